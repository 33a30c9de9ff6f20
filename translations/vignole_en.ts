<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en">
<context>
    <name>vignole::AlarmCard</name>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarm</numerusform>
            <numerusform>%n alarms</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::AlarmHistoryPanel</name>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarm</numerusform>
            <numerusform>%n alarms</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n event(s)</source>
        <translation>
            <numerusform>%n event</numerusform>
            <numerusform>%n events</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::AlarmLine</name>
    <message numerus="yes">
        <source>%n alarm(s) acknowledged, still on</source>
        <translation>
            <numerusform>%n alarm acknowledged, still on</numerusform>
            <numerusform>%n alarms acknowledged, still on</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::AlarmsPage</name>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarm</numerusform>
            <numerusform>%n alarms</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not acknowledged</source>
        <translation>
            <numerusform>%n not acknowledged</numerusform>
            <numerusform>%n not acknowledged</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::AuditPanel</name>
    <message numerus="yes">
        <source>%n entry(s), the newest first</source>
        <translation>
            <numerusform>%n entry, the newest first</numerusform>
            <numerusform>%n entries, the newest first</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::CalibrationOverview</name>
    <message numerus="yes">
        <source>Due in %n day(s).</source>
        <translation>
            <numerusform>Due in %n day.</numerusform>
            <numerusform>Due in %n days.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::ChartsPage</name>
    <message numerus="yes">
        <source>mean with smallest and largest value, last %n rail(s) of this section</source>
        <translation>
            <numerusform>mean with smallest and largest value, last %n rail of this section</numerusform>
            <numerusform>mean with smallest and largest value, last %n rails of this section</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::DiagnosticsPage</name>
    <message numerus="yes">
        <source>%n core(s)</source>
        <translation>
            <numerusform>%n core</numerusform>
            <numerusform>%n cores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s) kept</source>
        <translation>
            <numerusform>%n rail kept</numerusform>
            <numerusform>%n rails kept</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::DimensionModel</name>
    <message numerus="yes">
        <source>%n stretch(es) out of tolerance</source>
        <translation>
            <numerusform>%n stretch out of tolerance</numerusform>
            <numerusform>%n stretches out of tolerance</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::DriftPanel</name>
    <message numerus="yes">
        <source>No camera has moved: %n rail(s) watched.</source>
        <translation>
            <numerusform>No camera has moved: %n rail watched.</numerusform>
            <numerusform>No camera has moved: %n rails watched.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::LensWizard</name>
    <message numerus="yes">
        <source>%n point(s) found.</source>
        <translation>
            <numerusform>%n point found.</numerusform>
            <numerusform>%n points found.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Next: hold the target to the dashed outline and take the picture; %n to go.</source>
        <translation>
            <numerusform>Next: hold the target to the dashed outline and take the picture; %n to go.</numerusform>
            <numerusform>Next: hold the target to the dashed outline and take the picture; %n to go.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Next: %1; %n to go.</source>
        <translation>
            <numerusform>Next: %1; %n to go.</numerusform>
            <numerusform>Next: %1; %n to go.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::PipelinePanel</name>
    <message numerus="yes">
        <source>%n dimension(s)</source>
        <translation>
            <numerusform>%n dimension</numerusform>
            <numerusform>%n dimensions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::QualityPage</name>
    <message numerus="yes">
        <source>The inspections were cancelled; %n were whole.</source>
        <translation>
            <numerusform>The inspections were cancelled; %n was whole.</numerusform>
            <numerusform>The inspections were cancelled; %n were whole.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::RailsPage</name>
    <message numerus="yes">
        <source>%n stretch(es)</source>
        <translation>
            <numerusform>%n stretch</numerusform>
            <numerusform>%n stretches</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::RecipesPage</name>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n value</numerusform>
            <numerusform>%n values</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::ReferencePanel</name>
    <message numerus="yes">
        <source>The gauge agrees with the certificate in every dimension, over %n profile(s).</source>
        <translation>
            <numerusform>The gauge agrees with the certificate in every dimension, over %n profile.</numerusform>
            <numerusform>The gauge agrees with the certificate in every dimension, over %n profiles.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::RigWizard</name>
    <message numerus="yes">
        <source>, %n picture(s) refused</source>
        <translation>
            <numerusform>, %n picture refused</numerusform>
            <numerusform>, %n pictures refused</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>May be used, but %n dimension(s) get more than is allowed.</source>
        <translation>
            <numerusform>May be used, but %n dimension gets more than is allowed.</numerusform>
            <numerusform>May be used, but %n dimensions get more than is allowed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::SectionDialog</name>
    <message numerus="yes">
        <source>%1 mm high, %2 cm², %3 kg/m, %4; %n primitive(s)</source>
        <translation>
            <numerusform>%1 mm high, %2 cm², %3 kg/m, %4; %n primitive</numerusform>
            <numerusform>%1 mm high, %2 cm², %3 kg/m, %4; %n primitives</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::StripesPage</name>
    <message numerus="yes">
        <source>The picture is no longer held: the last %n are.</source>
        <translation>
            <numerusform>The picture is no longer held: the last %n is.</numerusform>
            <numerusform>The picture is no longer held: the last %n are.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vignole::WhatIfDialog</name>
    <message numerus="yes">
        <source>%n rail(s) of section %1</source>
        <translation>
            <numerusform>%n rail of section %1</numerusform>
            <numerusform>%n rails of section %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n could not be judged: %1</source>
        <translation>
            <numerusform>%n could not be judged: %1</numerusform>
            <numerusform>%n could not be judged: %1</numerusform>
        </translation>
    </message>
</context>
</TS>
