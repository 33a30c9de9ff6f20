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
