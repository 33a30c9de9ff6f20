<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>AlarmRule</name>
    <message>
        <source>A camera does not answer while a rail passes.</source>
        <translation>Eine Kamera antwortet nicht, während eine Schiene durchläuft.</translation>
    </message>
    <message>
        <source>Its quarter of the profile is missing; rails pass unmeasured.</source>
        <translation>Ihr Viertel des Messprofils fehlt; Schienen laufen ungemessen durch.</translation>
    </message>
    <message>
        <source>Check power and network cable of the camera, then Diagnostics; stop the line if it does not come back.</source>
        <translation>Strom und Netzwerkkabel der Kamera prüfen, dann Diagnose; kommt sie nicht wieder, Linie anhalten.</translation>
    </message>
    <message>
        <source>Too many triggers give no complete profile.</source>
        <translation>Zu viele Trigger ergeben kein vollständiges Messprofil.</translation>
    </message>
    <message>
        <source>Stretches of the rail are not measured.</source>
        <translation>Abschnitte der Schiene werden nicht gemessen.</translation>
    </message>
    <message>
        <source>See Diagnostics for the camera that loses frames; check network load and trigger.</source>
        <translation>In der Diagnose nachsehen, welche Kamera Bilder verliert; Netzlast und Trigger prüfen.</translation>
    </message>
    <message>
        <source>Too many profiles do not fit the section of the recipe.</source>
        <translation>Zu viele Messprofile passen nicht zum Schienenprofil des Rezepts.</translation>
    </message>
    <message>
        <source>The dimensions of this rail are not to be trusted.</source>
        <translation>Den Maßen dieser Schiene ist nicht zu trauen.</translation>
    </message>
    <message>
        <source>Check that the recipe is the one of the rail that runs; look at Stripes for glare or scale.</source>
        <translation>Prüfen, ob das Rezept zur laufenden Schiene gehört; unter Laserlinien nach Glanz oder Zunder sehen.</translation>
    </message>
    <message>
        <source>The measurement has stopped while a rail passes.</source>
        <translation>Die Messung steht, während eine Schiene durchläuft.</translation>
    </message>
    <message>
        <source>Rails pass unmeasured.</source>
        <translation>Schienen laufen ungemessen durch.</translation>
    </message>
    <message>
        <source>Start the measurement; if it stops again, save a support bundle in Diagnostics.</source>
        <translation>Messung starten; steht sie wieder, in der Diagnose eine Supportdatei sichern.</translation>
    </message>
    <message>
        <source>A rail has a stretch out of tolerance.</source>
        <translation>Eine Schiene hat einen Abschnitt außer Toleranz.</translation>
    </message>
    <message>
        <source>The rail must not be delivered as it is.</source>
        <translation>Die Schiene darf so nicht geliefert werden.</translation>
    </message>
    <message>
        <source>Mark the rail, see its exceptions on Rails, tell the rolling mill which dimension and where.</source>
        <translation>Schiene markieren, Überschreitungen unter Schienen ansehen, dem Walzwerk Maß und Stelle nennen.</translation>
    </message>
    <message>
        <source>The rail looks like another section than that of the recipe.</source>
        <translation>Die Schiene sieht nach einem anderen Profil aus als dem des Rezepts.</translation>
    </message>
    <message>
        <source>It is judged by the wrong tolerances.</source>
        <translation>Sie wird nach den falschen Toleranzen beurteilt.</translation>
    </message>
    <message>
        <source>Choose the recipe of the rail that is rolled.</source>
        <translation>Das Rezept der gewalzten Schiene wählen.</translation>
    </message>
    <message>
        <source>The calibration in force is refused, missing or out of date.</source>
        <translation>Die gültige Kalibrierung ist abgelehnt, fehlt oder ist abgelaufen.</translation>
    </message>
    <message>
        <source>Uncertainties are not what the reports state.</source>
        <translation>Die Unsicherheiten sind nicht die, die in den Berichten stehen.</translation>
    </message>
    <message>
        <source>Calibrate, or bring back an earlier calibration.</source>
        <translation>Kalibrieren oder eine frühere Kalibrierung zurückholen.</translation>
    </message>
    <message>
        <source>The seam between two cameras has moved in normal production.</source>
        <translation>Die Naht zwischen zwei Kameras hat sich in der laufenden Produktion verschoben.</translation>
    </message>
    <message>
        <source>Dimensions across the seam are biased by about as much.</source>
        <translation>Maße über die Naht sind um etwa ebenso viel verfälscht.</translation>
    </message>
    <message>
        <source>Check the mounting of the cameras beside the seam; calibrate the range finders at the next pause.</source>
        <translation>Befestigung der Kameras an der Naht prüfen; Lichtschnittsensoren in der nächsten Pause kalibrieren.</translation>
    </message>
    <message>
        <source>A camera loses frames.</source>
        <translation>Eine Kamera verliert Bilder.</translation>
    </message>
    <message>
        <source>Profiles are incomplete now and then.</source>
        <translation>Messprofile sind ab und zu unvollständig.</translation>
    </message>
    <message>
        <source>Check cable, switch and packet size of the camera.</source>
        <translation>Kabel, Switch und Paketgröße der Kamera prüfen.</translation>
    </message>
    <message>
        <source>Much of a laser line is saturated.</source>
        <translation>Ein großer Teil einer Laserlinie ist übersteuert.</translation>
    </message>
    <message>
        <source>Points on bright patches are less certain.</source>
        <translation>Punkte auf hellen Stellen sind unsicherer.</translation>
    </message>
    <message>
        <source>Shorten the exposure of the camera or clean the window.</source>
        <translation>Belichtung der Kamera verkürzen oder das Fenster reinigen.</translation>
    </message>
    <message>
        <source>A laser line is faint.</source>
        <translation>Eine Laserlinie ist schwach.</translation>
    </message>
    <message>
        <source>Points are missing or uncertain.</source>
        <translation>Punkte fehlen oder sind unsicher.</translation>
    </message>
    <message>
        <source>Clean the windows, check the laser, lengthen the exposure.</source>
        <translation>Fenster reinigen, Laser prüfen, Belichtung verlängern.</translation>
    </message>
    <message>
        <source>The rig is warmer than its calibration allows.</source>
        <translation>Die Messanlage ist wärmer, als ihre Kalibrierung erlaubt.</translation>
    </message>
    <message>
        <source>Positions of cameras and lasers move.</source>
        <translation>Kameras und Laser verschieben sich.</translation>
    </message>
    <message>
        <source>Check cooling and air; calibrate if it stays so.</source>
        <translation>Kühlung und Luft prüfen; bleibt es so, kalibrieren.</translation>
    </message>
    <message>
        <source>The disk is nearly full.</source>
        <translation>Die Festplatte ist fast voll.</translation>
    </message>
    <message>
        <source>Records of rails cannot be kept.</source>
        <translation>Aufzeichnungen der Schienen können nicht gespeichert werden.</translation>
    </message>
    <message>
        <source>Prune the archive or enlarge the disk.</source>
        <translation>Archiv bereinigen oder Festplatte vergrößern.</translation>
    </message>
    <message>
        <source>The archive does not answer.</source>
        <translation>Das Archiv antwortet nicht.</translation>
    </message>
    <message>
        <source>Rails are measured; their records wait on this machine&apos;s disk.</source>
        <translation>Schienen werden gemessen; ihre Aufzeichnungen warten auf der Platte dieses Rechners.</translation>
    </message>
    <message>
        <source>Check database and network; records are sent when it is back.</source>
        <translation>Datenbank und Netz prüfen; die Aufzeichnungen werden nachgesendet.</translation>
    </message>
    <message>
        <source>The queues of the measurement fill up.</source>
        <translation>Die Warteschlangen der Messung laufen voll.</translation>
    </message>
    <message>
        <source>Profiles will be dropped.</source>
        <translation>Messprofile werden verworfen.</translation>
    </message>
    <message>
        <source>Close what else runs on this machine; lower the trigger rate.</source>
        <translation>Andere Programme auf diesem Rechner schließen; Triggerrate senken.</translation>
    </message>
    <message>
        <source>A toleranced dimension is not measured while a rail passes.</source>
        <translation>Ein toleriertes Maß wird nicht gemessen, während eine Schiene durchläuft.</translation>
    </message>
    <message>
        <source>The rail cannot be judged by it.</source>
        <translation>Die Schiene kann danach nicht beurteilt werden.</translation>
    </message>
    <message>
        <source>Clean windows and check lasers; see Stripes for where the line is missing.</source>
        <translation>Fenster reinigen und Laser prüfen; unter Laserlinien sehen, wo die Linie fehlt.</translation>
    </message>
    <message>
        <source>The window answers slowly.</source>
        <translation>Das Fenster antwortet träge.</translation>
    </message>
    <message>
        <source>What it shows is late; the measurement goes on.</source>
        <translation>Die Anzeige kommt verspätet; die Messung läuft weiter.</translation>
    </message>
    <message>
        <source>Close what else runs on this machine; see Diagnostics.</source>
        <translation>Andere Programme auf diesem Rechner schließen; siehe Diagnose.</translation>
    </message>
</context>
<context>
    <name>AlarmWords</name>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>Rail %1 out of tolerance: %2</source>
        <translation>Schiene %1 außer Toleranz: %2</translation>
    </message>
    <message>
        <source>Camera %1 lost</source>
        <translation>Kamera %1 ausgefallen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>Dimension</name>
    <message>
        <source>Rail height</source>
        <translation>Schienenhöhe</translation>
    </message>
    <message>
        <source>Rail flange height</source>
        <translation>Laschenkammerhöhe</translation>
    </message>
    <message>
        <source>Foot width</source>
        <translation>Fußbreite</translation>
    </message>
    <message>
        <source>Head form</source>
        <translation>Kopfform</translation>
    </message>
    <message>
        <source>Head width</source>
        <translation>Kopfbreite</translation>
    </message>
    <message>
        <source>Head width (AREMA)</source>
        <translation>Kopfbreite (AREMA)</translation>
    </message>
    <message>
        <source>Foot thickness left</source>
        <translation>Fußdicke links</translation>
    </message>
    <message>
        <source>Foot thickness right</source>
        <translation>Fußdicke rechts</translation>
    </message>
    <message>
        <source>Rail asymmetry left</source>
        <translation>Asymmetrie links</translation>
    </message>
    <message>
        <source>Rail asymmetry right</source>
        <translation>Asymmetrie rechts</translation>
    </message>
    <message>
        <source>Web thickness</source>
        <translation>Stegdicke</translation>
    </message>
    <message>
        <source>Head radius</source>
        <translation>Kopfradius</translation>
    </message>
    <message>
        <source>Foot concavity</source>
        <translation>Fußkonkavität</translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>Grenznah</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Außerhalb</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Keine Grenze</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Nicht gemessen</translation>
    </message>
    <message>
        <source>not measured, because %1</source>
        <translation>nicht gemessen, denn: %1</translation>
    </message>
    <message>
        <source>%1 above the limit</source>
        <translation>%1 über der Grenze</translation>
    </message>
    <message>
        <source>%1 below the limit</source>
        <translation>%1 unter der Grenze</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>Außer Toleranz</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>No points</source>
        <translation>Keine Punkte</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Gehalten</translation>
    </message>
    <message>
        <source>No rail found</source>
        <translation>Keine Schiene erkannt</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Model %1 (approximate)</source>
        <translation>Modell %1 (genähert)</translation>
    </message>
    <message>
        <source>Model %1 (invented)</source>
        <translation>Modell %1 (erfunden)</translation>
    </message>
    <message>
        <source>Model %1</source>
        <translation>Modell %1</translation>
    </message>
    <message>
        <source>Camera 1</source>
        <translation>Kamera 1</translation>
    </message>
    <message>
        <source>deviation %1 %2, ×%3</source>
        <translation>Abweichung %1 %2, ×%3</translation>
    </message>
    <message>
        <source>Rail %1</source>
        <translation>Schiene %1</translation>
    </message>
    <message>
        <source>Rail profile report</source>
        <translation>Schienenprofilbericht</translation>
    </message>
    <message>
        <source>%1   recipe %2   calibration %3</source>
        <translation>%1   Rezept %2   Kalibrierung %3</translation>
    </message>
    <message>
        <source>mm. s: standard deviation along the rail; u, U: standard and expanded uncertainty of one profile; Exc.: stretches out of tolerance.</source>
        <translation>mm. s: Standardabweichung entlang der Schiene; u, U: Standard- und erweiterte Unsicherheit eines Messprofils; Übr.: Abschnitte außer Toleranz.</translation>
    </message>
    <message>
        <source>Profile at %1 m</source>
        <translation>Messprofil bei %1 m</translation>
    </message>
    <message>
        <source>Dimensions along the rail, mm over m</source>
        <translation>Maße entlang der Schiene, mm über m</translation>
    </message>
    <message>
        <source>mean of a stretch</source>
        <translation>Mittel eines Abschnitts</translation>
    </message>
    <message>
        <source>smallest to largest value of the stretch</source>
        <translation>kleinster bis größter Wert des Abschnitts</translation>
    </message>
    <message>
        <source>expected value</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>limits; the ground outside is grey</source>
        <translation>Grenzen; der Grund außerhalb ist grau</translation>
    </message>
    <message>
        <source>exception, with its square</source>
        <translation>Überschreitung, mit ihrem Quadrat</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>Überschreitungen</translation>
    </message>
    <message>
        <source>Exceptions: none</source>
        <translation>Überschreitungen: keine</translation>
    </message>
    <message>
        <source> (continued)</source>
        <translation> (Fortsetzung)</translation>
    </message>
    <message>
        <source>the first %1 of %2</source>
        <translation>die ersten %1 von %2</translation>
    </message>
    <message>
        <source>from m</source>
        <translation>von m</translation>
    </message>
    <message>
        <source>to m</source>
        <translation>bis m</translation>
    </message>
    <message>
        <source>length m</source>
        <translation>Länge m</translation>
    </message>
    <message>
        <source>worst mm</source>
        <translation>schlechtester mm</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>beyond limit</source>
        <translation>über Grenze</translation>
    </message>
    <message>
        <source>Triggers</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>gesehen</translation>
    </message>
    <message>
        <source>measured: complete, four contours</source>
        <translation>gemessen: vollständig, vier Konturen</translation>
    </message>
    <message>
        <source>incomplete: a camera or the registration was missing</source>
        <translation>unvollständig: eine Kamera oder die Einpassung fehlte</translation>
    </message>
    <message>
        <source>lost: no profile</source>
        <translation>verloren: kein Messprofil</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Anmerkungen</translation>
    </message>
    <message>
        <source>This section is invented: not for acceptance.</source>
        <translation>Dieses Profil ist erfunden: nicht für die Abnahme.</translation>
    </message>
    <message>
        <source>This section is approximate: not for acceptance.</source>
        <translation>Dieses Profil ist genähert: nicht für die Abnahme.</translation>
    </message>
    <message>
        <source>profile at %1 m</source>
        <translation>Messprofil bei %1 m</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Nennmaß</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Exc.</source>
        <translation>Übr.</translation>
    </message>
    <message>
        <source>max %1</source>
        <translation>max %1</translation>
    </message>
    <message>
        <source>min %1</source>
        <translation>min %1</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Schiene</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Schmelze</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Messprofile</translation>
    </message>
    <message>
        <source>Rail temperature</source>
        <translation>Schienentemperatur</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Measured (UTC)</source>
        <translation>Gemessen (UTC)</translation>
    </message>
    <message>
        <source>Written (UTC)</source>
        <translation>Erstellt (UTC)</translation>
    </message>
    <message>
        <source>Measured (local)</source>
        <translation>Gemessen (Ortszeit)</translation>
    </message>
    <message>
        <source>Written (local)</source>
        <translation>Erstellt (Ortszeit)</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>No limits to judge by</source>
        <translation>Keine Grenzen zum Urteilen</translation>
    </message>
    <message>
        <source>Not valid</source>
        <translation>Ungültig</translation>
    </message>
    <message>
        <source> out of tolerance</source>
        <translation> außer Toleranz</translation>
    </message>
    <message>
        <source> from %1 to %2 m</source>
        <translation> von %1 bis %2 m</translation>
    </message>
    <message>
        <source> in %1 stretches, the first at %2 m</source>
        <translation> in %1 Abschnitten, der erste bei %2 m</translation>
    </message>
    <message>
        <source> not measured</source>
        <translation> nicht gemessen</translation>
    </message>
    <message>
        <source> not measured, because %1</source>
        <translation> nicht gemessen, denn: %1</translation>
    </message>
    <message>
        <source> near limit</source>
        <translation> grenznah</translation>
    </message>
    <message>
        <source>%1 toleranced dimensions within their limits over %2 m</source>
        <translation>%1 tolerierte Maße innerhalb ihrer Grenzen auf %2 m</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULATION</translation>
    </message>
    <message>
        <source>Not measured, because %1</source>
        <translation>Nicht gemessen, denn: %1</translation>
    </message>
    <message>
        <source>Lengths refer to 15 °C. U is the expanded uncertainty with k = 2; a value nearer to a limit than U is near limit: it cannot be decided.</source>
        <translation>Längen gelten bei 15 °C. U ist die erweiterte Unsicherheit mit k = 2; ein Wert, der einer Grenze näher liegt als U, ist grenznah: er lässt sich nicht entscheiden.</translation>
    </message>
    <message>
        <source>mm at 15 °C</source>
        <translation>mm bei 15 °C</translation>
    </message>
    <message>
        <source>Before registration</source>
        <translation>Vor dem Einpassen</translation>
    </message>
    <message>
        <source>across %1, up %2 %3, turned %4°</source>
        <translation>quer %1, hoch %2 %3, gedreht %4°</translation>
    </message>
    <message>
        <source>As seen</source>
        <translation>Wie gesehen</translation>
    </message>
    <message>
        <source>Registered</source>
        <translation>Eingepasst</translation>
    </message>
</context>
<context>
    <name>Engine</name>
    <message>
        <source>wrong section: looks like %1 rather than %2</source>
        <translation>falsches Profil: sieht nach %1 aus statt %2</translation>
    </message>
    <message>
        <source>wrong section: looks like %1</source>
        <translation>falsches Profil: sieht nach %1 aus</translation>
    </message>
    <message>
        <source>not registered: %1</source>
        <translation>nicht eingepasst: %1</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>nicht eingepasst</translation>
    </message>
    <message>
        <source>looks like %1</source>
        <translation>sieht nach %1 aus</translation>
    </message>
    <message>
        <source>the points do not agree with %1: %2 lie on it, rms %3 mm; another rail, badly worn, or not a rail?</source>
        <translation>die Punkte passen nicht zu %1: %2 liegen darauf, RMS %3 mm; andere Schiene, stark verschlissen oder keine Schiene?</translation>
    </message>
    <message>
        <source>the points do not agree with %1</source>
        <translation>die Punkte passen nicht zu %1</translation>
    </message>
    <message>
        <source>the section has no web</source>
        <translation>das Profil hat keinen Steg</translation>
    </message>
    <message>
        <source>the points do not determine a pose</source>
        <translation>die Punkte bestimmen keine Lage</translation>
    </message>
    <message>
        <source>the foot edge is not upright</source>
        <translation>die Fußkante steht nicht senkrecht</translation>
    </message>
    <message>
        <source>the crown is flat</source>
        <translation>die Fahrfläche ist eben</translation>
    </message>
    <message>
        <source>points do not reach x = %1 from the axis</source>
        <translation>Punkte reichen nicht bis x = %1 von der Achse</translation>
    </message>
    <message>
        <source>points do not reach the crown on the axis</source>
        <translation>Punkte reichen nicht bis zur Fahrfläche auf der Achse</translation>
    </message>
    <message>
        <source>points do not reach %1 above the base line</source>
        <translation>Punkte reichen nicht bis %1 über der Grundlinie</translation>
    </message>
    <message>
        <source>not defined on this section</source>
        <translation>auf diesem Profil nicht definiert</translation>
    </message>
    <message>
        <source>no point is near the outline of %1</source>
        <translation>kein Punkt liegt nahe am Umriss von %1</translation>
    </message>
    <message>
        <source>no base line: %1</source>
        <translation>keine Grundlinie: %1</translation>
    </message>
    <message>
        <source>measurement failed</source>
        <translation>Messung fehlgeschlagen</translation>
    </message>
    <message>
        <source>extraction failed</source>
        <translation>Extraktion fehlgeschlagen</translation>
    </message>
    <message>
        <source>translation failed</source>
        <translation>Umrechnung fehlgeschlagen</translation>
    </message>
    <message>
        <source>the profile is not registered</source>
        <translation>das Messprofil ist nicht eingepasst</translation>
    </message>
    <message>
        <source>no points on %1</source>
        <translation>keine Punkte auf %1</translation>
    </message>
    <message>
        <source>only %1 point on %2, %3 are needed</source>
        <translation>nur %1 Punkt auf %2, %3 sind nötig</translation>
    </message>
    <message>
        <source>only %1 points on %2, %3 are needed</source>
        <translation>nur %1 Punkte auf %2, %3 sind nötig</translation>
    </message>
    <message>
        <source>only %1 points, at least %2 are needed</source>
        <translation>nur %1 Punkte, mindestens %2 sind nötig</translation>
    </message>
    <message>
        <source>the points on %1 make no curve</source>
        <translation>die Punkte auf %1 ergeben keine Kurve</translation>
    </message>
    <message>
        <source>%1 is not fitted</source>
        <translation>%1 ist nicht angepasst</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>keine Punkte</translation>
    </message>
    <message>
        <source>no profiles</source>
        <translation>keine Messprofile</translation>
    </message>
    <message>
        <source>no frames</source>
        <translation>keine Bilder</translation>
    </message>
    <message>
        <source>no frame</source>
        <translation>kein Bild</translation>
    </message>
    <message>
        <source>frame lost</source>
        <translation>Bild verloren</translation>
    </message>
    <message>
        <source>repeated frame</source>
        <translation>Bild wiederholt</translation>
    </message>
    <message>
        <source>late frame</source>
        <translation>Bild verspätet</translation>
    </message>
    <message>
        <source>too late</source>
        <translation>zu spät</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>source failed</source>
        <translation>Quelle ausgefallen</translation>
    </message>
    <message>
        <source>queue overflow</source>
        <translation>Warteschlange voll</translation>
    </message>
    <message>
        <source>outside of a rail</source>
        <translation>außerhalb einer Schiene</translation>
    </message>
    <message>
        <source>missed by all cameras</source>
        <translation>von allen Kameras verpasst</translation>
    </message>
    <message>
        <source>%1 from %2 m</source>
        <translation>%1 ab %2 m</translation>
    </message>
    <message>
        <source>camera %1: %2</source>
        <translation>Kamera %1: %2</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>rail %1</source>
        <translation>Schiene %1</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>pipeline</source>
        <translation>Verarbeitung</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>disk</source>
        <translation>Festplatte</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>range finders</source>
        <translation>Lichtschnittsensoren</translation>
    </message>
    <message>
        <source>rail %1 has passed: %2</source>
        <translation>Schiene %1 ist durchgelaufen: %2</translation>
    </message>
    <message>
        <source>the line was started</source>
        <translation>die Linie wurde gestartet</translation>
    </message>
    <message>
        <source>the line was stopped</source>
        <translation>die Linie wurde angehalten</translation>
    </message>
    <message>
        <source>%1 signed in</source>
        <translation>%1 hat sich angemeldet</translation>
    </message>
    <message>
        <source>%1 signed out</source>
        <translation>%1 hat sich abgemeldet</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>near limit</source>
        <translation>grenznah</translation>
    </message>
    <message>
        <source>out of tolerance</source>
        <translation>außer Toleranz</translation>
    </message>
    <message>
        <source>no limits</source>
        <translation>keine Grenzen</translation>
    </message>
    <message>
        <source>not valid</source>
        <translation>ungültig</translation>
    </message>
    <message>
        <source>is shorter than %1 characters</source>
        <translation>ist kürzer als %1 Zeichen</translation>
    </message>
    <message>
        <source>the old one is wrong</source>
        <translation>das alte ist falsch</translation>
    </message>
    <message>
        <source>too many wrong ones; locked until %1</source>
        <translation>zu viele falsche; gesperrt bis %1</translation>
    </message>
    <message>
        <source>needs a reason; say why</source>
        <translation>braucht einen Grund; bitte angeben</translation>
    </message>
    <message>
        <source>an entry needs who and what</source>
        <translation>ein Eintrag braucht wer und was</translation>
    </message>
    <message>
        <source>password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>is no user here</source>
        <translation>ist hier nicht eingetragen</translation>
    </message>
    <message>
        <source>is longer than 1024 bytes</source>
        <translation>ist länger als 1024 Byte</translation>
    </message>
    <message>
        <source>a name has 1 to 64 characters</source>
        <translation>ein Name hat 1 bis 64 Zeichen</translation>
    </message>
    <message>
        <source>the first user must be an administrator</source>
        <translation>der erste Benutzer muss Administrator sein</translation>
    </message>
    <message>
        <source>is a user already</source>
        <translation>ist bereits eingetragen</translation>
    </message>
    <message>
        <source>is the last administrator; make another one first</source>
        <translation>ist der letzte Administrator; erst einen anderen bestimmen</translation>
    </message>
    <message>
        <source>there is none</source>
        <translation>es gibt keines</translation>
    </message>
    <message>
        <source>no archive was asked for (--archive)</source>
        <translation>kein Archiv verlangt (--archive)</translation>
    </message>
    <message>
        <source>exact (virtual rig)</source>
        <translation>exakt (virtuelle Anlage)</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>Zeichnung</translation>
    </message>
    <message>
        <source>none (generated numbers)</source>
        <translation>keine (erzeugte Zahlen)</translation>
    </message>
</context>
<context>
    <name>Judgement</name>
    <message>
        <source>from %1 on</source>
        <translation>ab %1</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>%1 %2 above the limit %3</source>
        <translation>%1 %2 über der Grenze %3</translation>
    </message>
    <message>
        <source>%1 %2 below the limit %3</source>
        <translation>%1 %2 unter der Grenze %3</translation>
    </message>
    <message>
        <source>%1 beyond the limit %2</source>
        <translation>%1 jenseits der Grenze %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>camera %1 lost</source>
        <translation>Kamera %1 ausgefallen</translation>
    </message>
    <message>
        <source>cameras %1 lost</source>
        <translation>Kameras %1 ausgefallen</translation>
    </message>
    <message>
        <source>%1 dimensions</source>
        <translation>%1 Maße</translation>
    </message>
    <message>
        <source>Not valid</source>
        <translation>Ungültig</translation>
    </message>
    <message>
        <source>%1 not measured from %2 on: %3</source>
        <translation>%1 ab %2 nicht gemessen: %3</translation>
    </message>
    <message>
        <source>%1 near limit</source>
        <translation>%1 grenznah</translation>
    </message>
    <message>
        <source>single profiles outside the limits</source>
        <translation>einzelne Messprofile außerhalb der Grenzen</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>Außer Toleranz</translation>
    </message>
    <message>
        <source>%1 %2 inside the limit, closer than U</source>
        <translation>%1 %2 innerhalb der Grenze, näher als U</translation>
    </message>
    <message>
        <source>%1 %2 outside the limit, by less than U</source>
        <translation>%1 %2 außerhalb der Grenze, um weniger als U</translation>
    </message>
    <message>
        <source>within the guard band earlier on this rail</source>
        <translation>früher auf dieser Schiene im Schutzbereich</translation>
    </message>
    <message>
        <source>%1 within the guard band earlier on this rail</source>
        <translation>%1 früher auf dieser Schiene im Schutzbereich</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>Grenznah</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>%1 dimensions within limits up to %2</source>
        <translation>%1 Maße innerhalb der Grenzen bis %2</translation>
    </message>
    <message>
        <source>Waiting for a rail</source>
        <translation>Wartet auf Schiene</translation>
    </message>
    <message>
        <source>the gauge is ready; values appear with the head of the rail</source>
        <translation>die Messanlage ist bereit; Werte erscheinen mit dem Schienenanfang</translation>
    </message>
    <message>
        <source>the line is not running: Ctrl+R starts it</source>
        <translation>die Linie läuft nicht: Strg+R startet sie</translation>
    </message>
    <message>
        <source>No limits</source>
        <translation>Keine Grenzen</translation>
    </message>
    <message>
        <source>the recipe gives no tolerance to any dimension</source>
        <translation>das Rezept gibt keinem Maß eine Toleranz</translation>
    </message>
    <message>
        <source>this rail was not measured completely</source>
        <translation>diese Schiene wurde nicht vollständig gemessen</translation>
    </message>
    <message>
        <source>%1 not measured on enough of this rail</source>
        <translation>%1 auf zu wenig dieser Schiene gemessen</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>Ruhe</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Misst</translation>
    </message>
    <message>
        <source>No profiles</source>
        <translation>Keine Profile</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>no profiles since %1, %2 ago. Hold this rail.</source>
        <translation>keine Messprofile seit %1, vor %2. Schiene zurückhalten.</translation>
    </message>
    <message>
        <source>held: last profile at %1, %2 ago</source>
        <translation>gehalten: letztes Messprofil bei %1, vor %2</translation>
    </message>
    <message>
        <source>%1 of %2 cameras, %3 profiles/s</source>
        <translation>%1 von %2 Kameras, %3 Profile/s</translation>
    </message>
    <message>
        <source>no profiles for %1</source>
        <translation>seit %1 keine Messprofile</translation>
    </message>
    <message>
        <source>calibration %1</source>
        <translation>Kalibrierung %1</translation>
    </message>
    <message>
        <source>Not trusted</source>
        <translation>Unzuverlässig</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Keine Daten</translation>
    </message>
    <message>
        <source>no profile yet</source>
        <translation>noch kein Messprofil</translation>
    </message>
    <message>
        <source>the line is not running</source>
        <translation>die Linie läuft nicht</translation>
    </message>
    <message>
        <source>Degraded</source>
        <translation>Beeinträchtigt</translation>
    </message>
    <message>
        <source>%1 of %2 incomplete</source>
        <translation>%1 von %2 unvollständig</translation>
    </message>
    <message>
        <source>Trusted</source>
        <translation>Zuverlässig</translation>
    </message>
    <message>
        <source>The line is stopped: Ctrl+R starts it</source>
        <translation>Die Linie steht: Strg+R startet sie</translation>
    </message>
    <message>
        <source>Ready for the next rail</source>
        <translation>Bereit für die nächste Schiene</translation>
    </message>
    <message>
        <source>No alarm on this rail</source>
        <translation>Kein Alarm auf dieser Schiene</translation>
    </message>
</context>
<context>
    <name>Page</name>
    <message>
        <source>Monitor</source>
        <translation>Monitor</translation>
    </message>
    <message>
        <source>Stripes</source>
        <translation>Laserlinien</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Rails</source>
        <translation>Schienen</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Rezepte</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnose</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Optionen</translation>
    </message>
</context>
<context>
    <name>RecipeSetting</name>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Profile class</source>
        <translation>Profilklasse</translation>
    </message>
    <message>
        <source>Straightness class</source>
        <translation>Geradheitsklasse</translation>
    </message>
    <message>
        <source>RFH: distance from the axis, mm</source>
        <translation>RFH: Abstand von der Achse, mm</translation>
    </message>
    <message>
        <source>HF: half width of the crown, mm</source>
        <translation>HF: halbe Breite der Fahrfläche, mm</translation>
    </message>
    <message>
        <source>HW: depth below the crown, mm</source>
        <translation>HW: Tiefe unter der Fahrfläche, mm</translation>
    </message>
    <message>
        <source>HWA: the AREMA depth, mm</source>
        <translation>HWA: die AREMA-Tiefe, mm</translation>
    </message>
    <message>
        <source>FT: inside the foot edges, mm</source>
        <translation>FT: einwärts von den Fußkanten, mm</translation>
    </message>
    <message>
        <source>RAS: depth below the crown, mm</source>
        <translation>RAS: Tiefe unter der Fahrfläche, mm</translation>
    </message>
    <message>
        <source>WT: height, mm (none: thinnest)</source>
        <translation>WT: Höhe, mm (ohne: dünnste Stelle)</translation>
    </message>
    <message>
        <source>Base line: inside the foot edges, mm</source>
        <translation>Grundlinie: einwärts von den Fußkanten, mm</translation>
    </message>
    <message>
        <source>Line: smoothing σ, px</source>
        <translation>Linie: Glättung σ, px</translation>
    </message>
    <message>
        <source>Line: low threshold, DN</source>
        <translation>Linie: untere Schwelle, DN</translation>
    </message>
    <message>
        <source>Line: high threshold, DN</source>
        <translation>Linie: obere Schwelle, DN</translation>
    </message>
    <message>
        <source>Line: longest gap bridged, px</source>
        <translation>Linie: größte überbrückte Lücke, px</translation>
    </message>
    <message>
        <source>Line: largest angle joined, °</source>
        <translation>Linie: größter Verbindungswinkel, °</translation>
    </message>
    <message>
        <source>Line: shortest kept, points</source>
        <translation>Linie: kürzeste behaltene, Punkte</translation>
    </message>
    <message>
        <source>Line: blocks before overload</source>
        <translation>Linie: Blöcke bis Überlast</translation>
    </message>
    <message>
        <source>Line: pull of bends taken off</source>
        <translation>Linie: Krümmungsverzug korrigiert</translation>
    </message>
    <message>
        <source>Registration: scale at first, mm</source>
        <translation>Einpassung: Skala anfangs, mm</translation>
    </message>
    <message>
        <source>Registration: scale with a start, mm</source>
        <translation>Einpassung: Skala mit Startwert, mm</translation>
    </message>
    <message>
        <source>Registration: inlier below, mm</source>
        <translation>Einpassung: Inlier unter, mm</translation>
    </message>
    <message>
        <source>Registration: points used within, mm</source>
        <translation>Einpassung: Punkte genutzt bis, mm</translation>
    </message>
    <message>
        <source>Registration: fails above rms, mm</source>
        <translation>Einpassung: scheitert über RMS, mm</translation>
    </message>
    <message>
        <source>Registration: fails below share</source>
        <translation>Einpassung: scheitert unter Anteil</translation>
    </message>
    <message>
        <source>Measuring: ends left out, mm</source>
        <translation>Messung: Enden ausgelassen, mm</translation>
    </message>
    <message>
        <source>Measuring: least points</source>
        <translation>Messung: Mindestpunktzahl</translation>
    </message>
    <message>
        <source>Measuring: expansion, 1/K</source>
        <translation>Messung: Ausdehnung, 1/K</translation>
    </message>
    <message>
        <source>Measuring: hottest rail, °C</source>
        <translation>Messung: heißeste Schiene, °C</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>%1: limits, mm</source>
        <translation>%1: Grenzen, mm</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
</context>
<context>
    <name>Role</name>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Technician</source>
        <translation>Techniker</translation>
    </message>
    <message>
        <source>QA</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation>Administrator</translation>
    </message>
</context>
<context>
    <name>StudyReport</name>
    <message>
        <source>no outlier</source>
        <translation>kein Ausreißer</translation>
    </message>
    <message>
        <source>straggler (5 %)</source>
        <translation>verdächtig (5 %)</translation>
    </message>
    <message>
        <source>outlier (1 %)</source>
        <translation>Ausreißer (1 %)</translation>
    </message>
    <message>
        <source>%1: %2, critical %3 at 1 %</source>
        <translation>%1: %2, kritisch %3 bei 1 %</translation>
    </message>
    <message>
        <source>Mean range of the runs, mm, per %1 m (Table VI)</source>
        <translation>Mittlere Spannweite der Läufe, mm, je %1 m (Tabelle VI)</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>share of T, %</source>
        <translation>Anteil an T, %</translation>
    </message>
    <message>
        <source>Errors against the reference, mm (Table V)</source>
        <translation>Abweichungen von der Referenz, mm (Tabelle V)</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>Bias</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>größte</translation>
    </message>
    <message>
        <source>largest, %</source>
        <translation>größte, %</translation>
    </message>
    <message>
        <source>E_n above 1</source>
        <translation>E_n über 1</translation>
    </message>
    <message>
        <source>%1: values of the runs</source>
        <translation>%1: Werte der Läufe</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>Länge, m</translation>
    </message>
    <message>
        <source>%1: range of the runs</source>
        <translation>%1: Spannweite der Läufe</translation>
    </message>
    <message>
        <source>%1: error at each position</source>
        <translation>%1: Abweichung an jeder Stelle</translation>
    </message>
    <message>
        <source>mean of the runs</source>
        <translation>Mittel der Läufe</translation>
    </message>
    <message>
        <source>No verdict</source>
        <translation>Kein Urteil</translation>
    </message>
    <message>
        <source>no dimension has both a tolerance and figures</source>
        <translation>kein Maß hat Toleranz und Kennwerte zugleich</translation>
    </message>
    <message>
        <source>Repeatable</source>
        <translation>Wiederholbar</translation>
    </message>
    <message>
        <source>Not repeatable</source>
        <translation>Nicht wiederholbar</translation>
    </message>
    <message>
        <source>%1 uses the largest share of its tolerance, %2; allowed are %3 %</source>
        <translation>%1 nutzt den größten Anteil der Toleranz, %2; zulässig sind %3 %</translation>
    </message>
    <message>
        <source>uncertainties of values and reference are both needed for E_n; the figures stand by themselves</source>
        <translation>E_n braucht die Unsicherheiten der Werte und der Referenz; die Kennwerte stehen für sich</translation>
    </message>
    <message>
        <source>Agrees</source>
        <translation>Stimmt überein</translation>
    </message>
    <message>
        <source>Does not agree</source>
        <translation>Weicht ab</translation>
    </message>
    <message>
        <source>worst is %1: E n above 1 in %2 of its %3 values; chance allows %4</source>
        <translation>am schlechtesten: %1, E n über 1 bei %2 von %3 Werten; der Zufall erlaubt %4</translation>
    </message>
    <message>
        <source>Runs and positions</source>
        <translation>Läufe und Stellen</translation>
    </message>
    <message>
        <source>Repeatability s r</source>
        <translation>Wiederholbarkeit s r</translation>
    </message>
    <message>
        <source>its 95 % interval</source>
        <translation>ihr 95-%-Bereich</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Limit r = 2.8 s r</source>
        <translation>Grenze r = 2,8 s r</translation>
    </message>
    <message>
        <source>Mean and largest range</source>
        <translation>Mittlere, größte Spannweite</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>s from the range</source>
        <translation>s aus der Spannweite</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autokorrelation</translation>
    </message>
    <message>
        <source>Left out: a run lacks them</source>
        <translation>Ausgelassen: fehlen einem Lauf</translation>
    </message>
    <message>
        <source>Grubbs, means of the runs</source>
        <translation>Grubbs, Mittel der Läufe</translation>
    </message>
    <message>
        <source>Cochran, scatter of the runs</source>
        <translation>Cochran, Streuung der Läufe</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>Bias</translation>
    </message>
    <message>
        <source>RMS error</source>
        <translation>RMS-Abweichung</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>Größte Abweichung</translation>
    </message>
    <message>
        <source>in % of the reference</source>
        <translation>in % der Referenz</translation>
    </message>
    <message>
        <source>Limits of agreement</source>
        <translation>Übereinstimmungsgrenzen</translation>
    </message>
    <message>
        <source>interval of the lower</source>
        <translation>Bereich der unteren</translation>
    </message>
    <message>
        <source>interval of the upper</source>
        <translation>Bereich der oberen</translation>
    </message>
    <message>
        <source>Largest E n</source>
        <translation>Größtes E n</translation>
    </message>
    <message>
        <source>E n above 1</source>
        <translation>E n über 1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Repeatability study</source>
        <translation>Wiederholbarkeitsstudie</translation>
    </message>
    <message>
        <source>Accuracy study</source>
        <translation>Genauigkeitsstudie</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Toleranzen</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>means over %1 m</source>
        <translation>Mittel über %1 m</translation>
    </message>
    <message>
        <source>single profiles</source>
        <translation>einzelne Messprofile</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Runs: %1.</source>
        <translation>Läufe: %1.</translation>
    </message>
    <message>
        <source>Conditions: %1.</source>
        <translation>Bedingungen: %1.</translation>
    </message>
    <message>
        <source>%1 over the length, as Fig. 9</source>
        <translation>%1 über der Länge, wie Abb. 9</translation>
    </message>
    <message>
        <source>%1 against its reference</source>
        <translation>%1 gegen die Referenz</translation>
    </message>
    <message>
        <source>Figures of %1</source>
        <translation>Kennwerte: %1</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmCard</name>
    <message>
        <source>comes and goes</source>
        <translation>kommt und geht</translation>
    </message>
    <message>
        <source>on for more than a day</source>
        <translation>seit über einem Tag an</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>vorbei</translation>
    </message>
    <message>
        <source>acknowledged by %1</source>
        <translation>quittiert von %1</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n Alarm</numerusform>
            <numerusform>%n Alarme</numerusform>
        </translation>
    </message>
    <message>
        <source>Priority %1</source>
        <translation>Priorität %1</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Ursache</translation>
    </message>
    <message>
        <source>Consequence</source>
        <translation>Folge</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Maßnahme</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Quittieren</translation>
    </message>
    <message>
        <source>Acknowledge: %1</source>
        <translation>Quittieren: %1</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmHistoryPanel</name>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Show the alarms that came and went</source>
        <translation>Gekommene und gegangene Alarme zeigen</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Show events</source>
        <translation>Ereignisse zeigen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export…</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Als CSV exportieren</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>Gekommen</translation>
    </message>
    <message>
        <source>Went</source>
        <translation>Gegangen</translation>
    </message>
    <message>
        <source>Lasted</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Alarms that came and went, newest first</source>
        <translation>Gekommene und gegangene Alarme, neueste zuerst</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>Events, newest first</source>
        <translation>Ereignisse, neueste zuerst</translation>
    </message>
    <message>
        <source>still on</source>
        <translation>noch an</translation>
    </message>
    <message>
        <source>shelved: %1</source>
        <translation>zurückgestellt: %1</translation>
    </message>
    <message>
        <source>nobody yet</source>
        <translation>noch niemand</translation>
    </message>
    <message>
        <source>no alarm so far</source>
        <translation>bisher kein Alarm</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n Alarm</numerusform>
            <numerusform>%n Alarme</numerusform>
        </translation>
    </message>
    <message>
        <source>no event so far</source>
        <translation>bisher kein Ereignis</translation>
    </message>
    <message numerus="yes">
        <source>%n event(s)</source>
        <translation>
            <numerusform>%n Ereignis</numerusform>
            <numerusform>%n Ereignisse</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 ist geschrieben</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>program ended</source>
        <translation>Programmende</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmLine</name>
    <message>
        <source>Alarm, priority %1: %2. %3</source>
        <translation>Alarm, Priorität %1: %2. %3</translation>
    </message>
    <message>
        <source>1 of %1</source>
        <translation>1 von %1</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) acknowledged, still on</source>
        <translation>
            <numerusform>%n Alarm quittiert, noch an</numerusform>
            <numerusform>%n Alarme quittiert, noch an</numerusform>
        </translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Quittieren</translation>
    </message>
    <message>
        <source>Acknowledge the shown alarm</source>
        <translation>Gezeigten Alarm quittieren</translation>
    </message>
    <message>
        <source>Acknowledge the shown alarm (Ctrl+A)</source>
        <translation>Gezeigten Alarm quittieren (Strg+A)</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmsPage</name>
    <message>
        <source>Active</source>
        <translation>Anstehend</translation>
    </message>
    <message>
        <source>Acknowledge page</source>
        <translation>Seite quittieren</translation>
    </message>
    <message>
        <source>Acknowledge all that are shown</source>
        <translation>Alle gezeigten quittieren</translation>
    </message>
    <message>
        <source>Acknowledge all that are shown (Ctrl+Shift+A)</source>
        <translation>Alle gezeigten quittieren (Strg+Umschalt+A)</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Häufigkeit</translation>
    </message>
    <message>
        <source>10 min</source>
        <translation>10 min</translation>
    </message>
    <message>
        <source>Hour</source>
        <translation>Stunde</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>Shelve</source>
        <translation>Zurückstellen</translation>
    </message>
    <message>
        <source>hides an alarm for a while</source>
        <translation>verbirgt einen Alarm eine Weile</translation>
    </message>
    <message>
        <source>Alarm to shelve</source>
        <translation>Alarm zum Zurückstellen</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Reason for shelving</source>
        <translation>Grund der Rückstellung</translation>
    </message>
    <message>
        <source>For how long</source>
        <translation>Wie lange</translation>
    </message>
    <message>
        <source>Shelved</source>
        <translation>Zurückgestellt</translation>
    </message>
    <message>
        <source>comes back by itself</source>
        <translation>kommt von selbst wieder</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Bring back the chosen alarm</source>
        <translation>Gewählten Alarm zurückholen</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Shelved alarms</source>
        <translation>Zurückgestellte Alarme</translation>
    </message>
    <message>
        <source>An operator may shelve for %1 minutes at most.</source>
        <translation>Ein Bediener darf höchstens %1 Minuten zurückstellen.</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n Alarm</numerusform>
            <numerusform>%n Alarme</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not acknowledged</source>
        <translation>
            <numerusform>%n nicht quittiert</numerusform>
            <numerusform>%n nicht quittiert</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is wrong. Alarms appear here with their cause, their consequence and what to do.</source>
        <translation>Alles in Ordnung. Alarme erscheinen hier mit Ursache, Folge und Maßnahme.</translation>
    </message>
    <message>
        <source>since the program started</source>
        <translation>seit dem Programmstart</translation>
    </message>
    <message>
        <source>Flood: more than 10 alarms in 10 minutes. Look for one cause behind them.</source>
        <translation>Alarmflut: mehr als 10 Alarme in 10 Minuten. Nach einer gemeinsamen Ursache suchen.</translation>
    </message>
    <message>
        <source>Target: below 1 in 10 minutes; above 10 it is a flood.</source>
        <translation>Ziel: unter 1 in 10 Minuten; über 10 ist es eine Alarmflut.</translation>
    </message>
    <message>
        <source>alarms in 10 minutes</source>
        <translation>Alarme in 10 Minuten</translation>
    </message>
    <message>
        <source>Health of the alarms</source>
        <translation>Güte der Alarme</translation>
    </message>
    <message>
        <source>flood: grouped by rule</source>
        <translation>Alarmflut: nach Regel gruppiert</translation>
    </message>
    <message>
        <source>Mean per 10 minutes</source>
        <translation>Mittel je 10 Minuten</translation>
    </message>
    <message>
        <source>%1, target below 1</source>
        <translation>%1, Ziel unter 1</translation>
    </message>
    <message>
        <source>Floods</source>
        <translation>Alarmfluten</translation>
    </message>
    <message>
        <source>Comes and goes</source>
        <translation>Kommt und geht</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>On for more than a day</source>
        <translation>Seit über einem Tag an</translation>
    </message>
    <message>
        <source>Shelving needs a reason.</source>
        <translation>Zurückstellen braucht einen Grund.</translation>
    </message>
</context>
<context>
    <name>vignole::AuditPanel</name>
    <message>
        <source>Audit trail</source>
        <translation>Prüfpfad</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Wer</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Of what</source>
        <translation>Woran</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Audit trail, newest first</source>
        <translation>Prüfpfad, neueste zuerst</translation>
    </message>
    <message>
        <source>Check the chain</source>
        <translation>Kette prüfen</translation>
    </message>
    <message>
        <source>Check that no entry was changed, put in or taken out</source>
        <translation>Prüfen, dass kein Eintrag geändert, eingefügt oder entfernt wurde</translation>
    </message>
    <message>
        <source>The audit trail is shown to QA and administrators who have signed in.</source>
        <translation>Der Prüfpfad wird angemeldeten Qualitätsprüfern und Administratoren gezeigt.</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s), the newest first</source>
        <translation>
            <numerusform>%n Eintrag, der neueste zuerst</numerusform>
            <numerusform>%n Einträge, der neueste zuerst</numerusform>
        </translation>
    </message>
    <message>
        <source>checking …</source>
        <translation>prüft …</translation>
    </message>
    <message>
        <source>The chain is whole: no entry was changed, put in or taken out.</source>
        <translation>Die Kette ist heil: kein Eintrag wurde geändert, eingefügt oder entfernt.</translation>
    </message>
    <message>
        <source>The chain is broken: %1</source>
        <translation>Die Kette ist gebrochen: %1</translation>
    </message>
</context>
<context>
    <name>vignole::CalibrationDesk</name>
    <message>
        <source>Calibrations are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>Kalibrierungen werden nicht aufbewahrt: %1. Programm mit einem Archiv starten (--archive FILE).</translation>
    </message>
    <message>
        <source>Calibrating is the technician&apos;s: sign in as technician or QA (Settings, F10).</source>
        <translation>Kalibrieren ist Sache des Technikers: als Techniker oder Qualität anmelden (Optionen, F10).</translation>
    </message>
    <message>
        <source>There is no archive, so a calibration could neither be kept nor reverted: start the program with --archive FILE.</source>
        <translation>Es gibt kein Archiv, eine Kalibrierung ließe sich weder aufbewahren noch zurückholen: Programm mit --archive FILE starten.</translation>
    </message>
    <message>
        <source>Another calibration needs a reason.</source>
        <translation>Eine andere Kalibrierung braucht einen Grund.</translation>
    </message>
</context>
<context>
    <name>vignole::CalibrationOverview</name>
    <message>
        <source>In force</source>
        <translation>Gültig</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>What it is worth</source>
        <translation>Was sie wert ist</translation>
    </message>
    <message>
        <source>Calibrations kept</source>
        <translation>Kalibrierungen</translation>
    </message>
    <message>
        <source>choose one to compare it with the one in force</source>
        <translation>eine zum Vergleich mit der gültigen wählen</translation>
    </message>
    <message>
        <source>Range finders…</source>
        <translation>Lichtschnittsensoren…</translation>
    </message>
    <message>
        <source>Calibrate the range finders with the pin plate</source>
        <translation>Lichtschnittsensoren mit der Stiftplatte kalibrieren</translation>
    </message>
    <message>
        <source>Lens of a camera…</source>
        <translation>Objektiv einer Kamera…</translation>
    </message>
    <message>
        <source>Calibrate the lens of a camera with the flat target</source>
        <translation>Objektiv einer Kamera mit der ebenen Tafel kalibrieren</translation>
    </message>
    <message>
        <source>Encoder…</source>
        <translation>Drehgeber…</translation>
    </message>
    <message>
        <source>Calibrate the encoder over a known length</source>
        <translation>Drehgeber über eine bekannte Länge kalibrieren</translation>
    </message>
    <message>
        <source>Reference piece…</source>
        <translation>Referenzstück…</translation>
    </message>
    <message>
        <source>Check the calibration on a reference piece</source>
        <translation>Kalibrierung an einem Referenzstück prüfen</translation>
    </message>
    <message>
        <source>Parameter study…</source>
        <translation>Parameterstudie…</translation>
    </message>
    <message>
        <source>Study which settings of the calibration matter</source>
        <translation>Untersuchen, welche Einstellungen der Kalibrierung zählen</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Aufbewahrt</translation>
    </message>
    <message>
        <source>By, because</source>
        <translation>Von, Grund</translation>
    </message>
    <message>
        <source>What the calibration in force is worth</source>
        <translation>Was die gültige Kalibrierung wert ist</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Reason for putting it back in force</source>
        <translation>Grund, sie wieder in Kraft zu setzen</translation>
    </message>
    <message>
        <source>Put in force</source>
        <translation>In Kraft setzen</translation>
    </message>
    <message>
        <source>Put the chosen calibration in force</source>
        <translation>Gewählte Kalibrierung in Kraft setzen</translation>
    </message>
    <message>
        <source>No calibration</source>
        <translation>Keine Kalibrierung</translation>
    </message>
    <message>
        <source>Nothing can be measured: calibrate the range finders.</source>
        <translation>Es kann nichts gemessen werden: Lichtschnittsensoren kalibrieren.</translation>
    </message>
    <message>
        <source>Overdue: %1. Calibrate the range finders.</source>
        <translation>Überfällig: %1. Lichtschnittsensoren kalibrieren.</translation>
    </message>
    <message numerus="yes">
        <source>Due in %n day(s).</source>
        <translation>
            <numerusform>Fällig in %n Tag.</numerusform>
            <numerusform>Fällig in %n Tagen.</numerusform>
        </translation>
    </message>
    <message>
        <source>No interval is set.</source>
        <translation>Kein Intervall ist gesetzt.</translation>
    </message>
    <message>
        <source>Method: %1
Made: %2
Plate: %3
Cameras: %4</source>
        <translation>Methode: %1
Erstellt: %2
Platte: %3
Kameras: %4</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>None is kept yet. The first is kept when a rail is measured or a wizard ends.</source>
        <translation>Noch ist keine aufbewahrt. Die erste wird aufbewahrt, wenn eine Schiene gemessen wird oder ein Assistent endet.</translation>
    </message>
    <message>
        <source>In force: %1</source>
        <translation>Gültig: %1</translation>
    </message>
    <message>
        <source> (cannot be read)</source>
        <translation> (nicht lesbar)</translation>
    </message>
    <message>
        <source>of another rig</source>
        <translation>von anderer Anlage</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>Zulässig</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>U of it</source>
        <translation>U davon</translation>
    </message>
    <message>
        <source>U (k = 2) in %1</source>
        <translation>U (k = 2) in %1</translation>
    </message>
    <message>
        <source>Difference: what the chosen one measures more than the one in force</source>
        <translation>Unterschied: was die gewählte mehr misst als die gültige</translation>
    </message>
    <message>
        <source>By the calibration alone, without the noise of the profiles</source>
        <translation>Nur durch die Kalibrierung, ohne das Rauschen der Messprofile</translation>
    </message>
    <message>
        <source>%1, too much</source>
        <translation>%1, zu viel</translation>
    </message>
    <message>
        <source>none stated</source>
        <translation>ohne Angabe</translation>
    </message>
    <message>
        <source>Nothing is applied before old and new are compared.</source>
        <translation>Nichts wird angewendet, bevor alt und neu verglichen sind.</translation>
    </message>
    <message>
        <source>It is of other cameras and cannot be put in force here.</source>
        <translation>Sie gehört zu anderen Kameras und kann hier nicht in Kraft gesetzt werden.</translation>
    </message>
    <message>
        <source>It is in force.</source>
        <translation>Sie ist in Kraft.</translation>
    </message>
    <message>
        <source>It is in force: the line measures with it from the next rail on.</source>
        <translation>Sie ist in Kraft: ab der nächsten Schiene misst die Linie mit ihr.</translation>
    </message>
</context>
<context>
    <name>vignole::ChartsPage</name>
    <message>
        <source>Dimensions</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>Dimension that is charted</source>
        <translation>Dargestelltes Maß</translation>
    </message>
    <message>
        <source>Rail that is charted</source>
        <translation>Dargestellte Schiene</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Whole range</source>
        <translation>Ganzer Bereich</translation>
    </message>
    <message>
        <source>Whole range (0)</source>
        <translation>Ganzer Bereich (0)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export…</translation>
    </message>
    <message>
        <source>Export the chart as picture, PDF or CSV</source>
        <translation>Diagramm als Bild, PDF oder CSV exportieren</translation>
    </message>
    <message>
        <source>Dimension along the rail</source>
        <translation>Maß entlang der Schiene</translation>
    </message>
    <message>
        <source>Dimension rail by rail</source>
        <translation>Maß Schiene für Schiene</translation>
    </message>
    <message>
        <source>Histogram of the rail</source>
        <translation>Histogramm der Schiene</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>same scale, this rail</source>
        <translation>gleiche Skala, diese Schiene</translation>
    </message>
    <message>
        <source>Per rail</source>
        <translation>Je Schiene</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>this rail</source>
        <translation>diese Schiene</translation>
    </message>
    <message>
        <source>Figures of the rail</source>
        <translation>Kennwerte der Schiene</translation>
    </message>
    <message>
        <source>Rails are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>Schienen werden nicht aufbewahrt: %1. Programm mit einem Archiv starten (--archive FILE).</translation>
    </message>
    <message>
        <source>No rail has been measured yet. Its chart appears here when it has passed.</source>
        <translation>Noch keine Schiene gemessen. Ihr Diagramm erscheint hier, wenn sie durchgelaufen ist.</translation>
    </message>
    <message>
        <source>Newest rail</source>
        <translation>Neueste Schiene</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>Länge, m</translation>
    </message>
    <message>
        <source>%1 along the rail</source>
        <translation>%1 entlang der Schiene</translation>
    </message>
    <message>
        <source>rail %1, %2 profiles</source>
        <translation>Schiene %1, %2 Messprofile</translation>
    </message>
    <message>
        <source>; no band: %1 of %2 other rails</source>
        <translation>; kein Band: %1 von %2 anderen Schienen</translation>
    </message>
    <message>
        <source>; band: last %1 rails, 10 to 90 %</source>
        <translation>; Band: letzte %1 Schienen, 10 bis 90 %</translation>
    </message>
    <message>
        <source>same scale, longest bar %1 %</source>
        <translation>gleiche Skala, längster Balken %1 %</translation>
    </message>
    <message>
        <source>rail</source>
        <translation>Schiene</translation>
    </message>
    <message numerus="yes">
        <source>mean with smallest and largest value, last %n rail(s) of this section</source>
        <translation>
            <numerusform>Mittel mit kleinstem und größtem Wert, letzte Schiene dieses Profils</numerusform>
            <numerusform>Mittel mit kleinstem und größtem Wert, letzte %n Schienen dieses Profils</numerusform>
        </translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <source>Uncertainty U (k = 2)</source>
        <translation>Unsicherheit U (k = 2)</translation>
    </message>
    <message>
        <source>Beyond a limit</source>
        <translation>Jenseits einer Grenze</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>In the guard band</source>
        <translation>Im Schutzbereich</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Nicht gemessen</translation>
    </message>
    <message>
        <source>Room to the nearer limit</source>
        <translation>Abstand zur näheren Grenze</translation>
    </message>
    <message>
        <source>Move over the chart or press Left and Right to read values; wheel or + and − zoom, drag moves.</source>
        <translation>Über das Diagramm fahren oder Links und Rechts drücken, um Werte zu lesen; Rad oder + und − zoomen, Ziehen verschiebt.</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>not measured: %1</source>
        <translation>nicht gemessen: %1</translation>
    </message>
    <message>
        <source>%1   %2 %3   U ±%4   %5 from expected   %6</source>
        <translation>%1   %2 %3   U ±%4   %5 vom Sollwert   %6</translation>
    </message>
    <message>
        <source>Export the chart</source>
        <translation>Diagramm exportieren</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 ist geschrieben</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Kleinster</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter</translation>
    </message>
</context>
<context>
    <name>vignole::ClosedStep</name>
    <message>
        <source>Closed while the line measures</source>
        <translation>Gesperrt, solange die Linie misst</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Linie stoppen</translation>
    </message>
</context>
<context>
    <name>vignole::DiagnosticsPage</name>
    <message>
        <source>Pipeline</source>
        <translation>Verarbeitung</translation>
    </message>
    <message>
        <source>Every trigger accounted for</source>
        <translation>Jeder Trigger ist verbucht</translation>
    </message>
    <message>
        <source>since the line was started</source>
        <translation>seit dem Start der Linie</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>Where every trigger went</source>
        <translation>Wohin jeder Trigger ging</translation>
    </message>
    <message>
        <source>Counters of the cameras</source>
        <translation>Zähler der Kameras</translation>
    </message>
    <message>
        <source>Load of the computer</source>
        <translation>Last des Rechners</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Frames/s</source>
        <translation>Bilder/s</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Fehlend</translation>
    </message>
    <message>
        <source>held, %1 old</source>
        <translation>gehalten, %1 alt</translation>
    </message>
    <message>
        <source>%1 profiles/s of %2 expected</source>
        <translation>%1 Profile/s von %2 erwarteten</translation>
    </message>
    <message>
        <source>Triggers</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Incomplete: measured by fewer cameras</source>
        <translation>Unvollständig: mit weniger Kameras gemessen</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>Not accounted for</source>
        <translation>Nicht verbucht</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>Unterwegs</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>: lost</source>
        <translation>: ausgefallen</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Festplatte</translation>
    </message>
    <message>
        <source>make room: nearly full</source>
        <translation>Platz schaffen: fast voll</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Prozessor</translation>
    </message>
    <message>
        <source>%1 % of one core</source>
        <translation>%1 % eines Kerns</translation>
    </message>
    <message numerus="yes">
        <source>%n core(s)</source>
        <translation>
            <numerusform>%n Kern</numerusform>
            <numerusform>%n Kerne</numerusform>
        </translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Bildschirm</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
    <message>
        <source>How much of the support bundle is written</source>
        <translation>Wie viel der Supportdatei geschrieben ist</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>%1 profiles lost</source>
        <translation>%1 Profile verloren</translation>
    </message>
    <message>
        <source>%1 without points</source>
        <translation>%1 ohne Punkte</translation>
    </message>
    <message>
        <source>%1 profiles kept</source>
        <translation>%1 Profile aufbewahrt</translation>
    </message>
    <message>
        <source>rails are not kept</source>
        <translation>Schienen nicht aufbewahrt</translation>
    </message>
    <message>
        <source>%1 pictures/s, %2 % of a core</source>
        <translation>%1 Bilder/s, %2 % eines Kerns</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Not available here, because these cameras are rendered: resends, incomplete frames, timeouts, temperature.</source>
        <translation>Hier nicht verfügbar, weil diese Kameras simuliert sind: Wiederholungen, unvollständige Bilder, Zeitüberschreitungen, Temperatur.</translation>
    </message>
    <message>
        <source>%1 of %2 GB</source>
        <translation>%1 von %2 GB</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>ohne Angabe</translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s) kept</source>
        <translation>
            <numerusform>%n Schiene aufbewahrt</numerusform>
            <numerusform>%n Schienen aufbewahrt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 MB, WAL %2 MB</source>
        <translation>%1 MB, WAL %2 MB</translation>
    </message>
    <message>
        <source>open, nothing is written</source>
        <translation>offen, nichts wird geschrieben</translation>
    </message>
    <message>
        <source>of %1 GB</source>
        <translation>von %1 GB</translation>
    </message>
    <message>
        <source>p99 %1 ms</source>
        <translation>p99 %1 ms</translation>
    </message>
    <message>
        <source>p50 %1, max %2</source>
        <translation>p50 %1, max %2</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Where the support bundle is put</source>
        <translation>Wohin die Supportdatei kommt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Support bundle…</source>
        <translation>Supportdatei…</translation>
    </message>
    <message>
        <source>Cancel the support bundle</source>
        <translation>Supportdatei abbrechen</translation>
    </message>
    <message>
        <source>Save a support bundle</source>
        <translation>Supportdatei sichern</translation>
    </message>
</context>
<context>
    <name>vignole::DimensionModel</name>
    <message>
        <source>Not measured</source>
        <translation>Nicht gemessen</translation>
    </message>
    <message>
        <source>Not measured, because %1</source>
        <translation>Nicht gemessen, denn: %1</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>limits %1 to %2</source>
        <translation>Grenzen %1 bis %2</translation>
    </message>
    <message>
        <source>waiting for a profile</source>
        <translation>wartet auf ein Messprofil</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Tolerance and guard band</source>
        <translation>Toleranz und Schutzbereich</translation>
    </message>
    <message>
        <source>Along the rail</source>
        <translation>Entlang der Schiene</translation>
    </message>
    <message>
        <source>Not meas.</source>
        <translation>Nicht gem.</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Gehalten</translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es) out of tolerance</source>
        <translation>
            <numerusform>%n Abschnitt außer Toleranz</numerusform>
            <numerusform>%n Abschnitte außer Toleranz</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 %3, deviation %4, U %5, %6</source>
        <translation>%1, %2 %3, Abweichung %4, U %5, %6</translation>
    </message>
</context>
<context>
    <name>vignole::DimensionTable</name>
    <message>
        <source>Dimensions</source>
        <translation>Maße</translation>
    </message>
</context>
<context>
    <name>vignole::DriftPanel</name>
    <message>
        <source>Health</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>seams between the cameras on every rail</source>
        <translation>Nähte zwischen den Kameras auf jeder Schiene</translation>
    </message>
    <message>
        <source>Shift of each camera, rail by rail</source>
        <translation>Versatz jeder Kamera, Schiene für Schiene</translation>
    </message>
    <message>
        <source>Shift of each camera since its calibration</source>
        <translation>Versatz jeder Kamera seit ihrer Kalibrierung</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Alarm above</source>
        <translation>Alarm über</translation>
    </message>
    <message>
        <source>No rail has passed yet. Camera drift shows in the seams of normal production, without a plate.</source>
        <translation>Noch ist keine Schiene durchgelaufen. Kameradrift zeigt sich an den Nähten der laufenden Produktion, ohne Platte.</translation>
    </message>
    <message>
        <source>Learning what the seams are like: %1 of %2 rails since this calibration came into use.</source>
        <translation>Die Nähte werden eingelernt: %1 von %2 Schienen, seit diese Kalibrierung in Gebrauch ist.</translation>
    </message>
    <message numerus="yes">
        <source>No camera has moved: %n rail(s) watched.</source>
        <translation>
            <numerusform>Keine Kamera hat sich verschoben: %n Schiene beobachtet.</numerusform>
            <numerusform>Keine Kamera hat sich verschoben: %n Schienen beobachtet.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 moved</source>
        <translation>%1 verschoben</translation>
    </message>
    <message>
        <source>rail</source>
        <translation>Schiene</translation>
    </message>
    <message>
        <source>shift in </source>
        <translation>Versatz in </translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>alarm above</source>
        <translation>Alarm über</translation>
    </message>
</context>
<context>
    <name>vignole::EncoderPanel</name>
    <message>
        <source>Encoder</source>
        <translation>Drehgeber</translation>
    </message>
    <message>
        <source>Motion a pulse</source>
        <translation>Weg je Impuls</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Ablesungen</translation>
    </message>
    <message>
        <source>Known length, first to last reading</source>
        <translation>Bekannte Länge, erste bis letzte Ablesung</translation>
    </message>
    <message>
        <source>Known length, mm</source>
        <translation>Bekannte Länge, mm</translation>
    </message>
    <message>
        <source>Its standard uncertainty</source>
        <translation>Ihre Standardunsicherheit</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length, mm</source>
        <translation>Standardunsicherheit der Länge, mm</translation>
    </message>
    <message>
        <source>Slip of the virtual second encoder, for training</source>
        <translation>Schlupf des virtuellen zweiten Drehgebers, zum Üben</translation>
    </message>
    <message>
        <source>Slip of the virtual second encoder, ppm</source>
        <translation>Schlupf des virtuellen zweiten Drehgebers, ppm</translation>
    </message>
    <message>
        <source>Drive the rail</source>
        <translation>Schiene fahren</translation>
    </message>
    <message>
        <source>Readings from a file…</source>
        <translation>Ablesungen aus Datei…</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Linie stoppen</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>Standardunsicherheit</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Zähler</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Zweiter</translation>
    </message>
    <message>
        <source>x mm</source>
        <translation>x mm</translation>
    </message>
    <message>
        <source>y mm</source>
        <translation>y mm</translation>
    </message>
    <message>
        <source>Readings of the encoder</source>
        <translation>Ablesungen des Drehgebers</translation>
    </message>
    <message>
        <source>Slip along the way</source>
        <translation>Schlupf entlang des Wegs</translation>
    </message>
    <message>
        <source>Readings: count,x_mm,y_mm[,count2]</source>
        <translation>Ablesungen: count,x_mm,y_mm[,count2]</translation>
    </message>
    <message>
        <source>CSV (*.csv);;All files (*)</source>
        <translation>CSV (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Closed while the line measures: the rail is driven by hand over a known length. Stop the line to go on.</source>
        <translation>Gesperrt, solange die Linie misst: die Schiene wird von Hand über eine bekannte Länge gefahren. Zum Fortfahren die Linie stoppen.</translation>
    </message>
    <message>
        <source>A rail is driven over a length that is known, and the pulses are counted: where the light crosses it, it is seen as well.</source>
        <translation>Eine Schiene wird über eine bekannte Länge gefahren, und die Impulse werden gezählt: wo das Licht sie schneidet, wird sie zugleich gesehen.</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>Ablesung</translation>
    </message>
    <message>
        <source>second behind first, pulses</source>
        <translation>zweiter hinter erstem, Impulse</translation>
    </message>
    <message>
        <source>Next: drive the rail over the known length.</source>
        <translation>Weiter: Schiene über die bekannte Länge fahren.</translation>
    </message>
    <message>
        <source> µm a pulse</source>
        <translation> µm je Impuls</translation>
    </message>
    <message>
        <source> µm</source>
        <translation> µm</translation>
    </message>
    <message>
        <source>unknown: fewer than three readings</source>
        <translation>unbekannt: weniger als drei Ablesungen</translation>
    </message>
    <message>
        <source>Along (V z)</source>
        <translation>Längs (V z)</translation>
    </message>
    <message>
        <source>Sideways (V x)</source>
        <translation>Seitlich (V x)</translation>
    </message>
    <message>
        <source>Upwards (V y)</source>
        <translation>Aufwärts (V y)</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>Impulse</translation>
    </message>
    <message>
        <source>Slip of the second</source>
        <translation>Schlupf des zweiten</translation>
    </message>
    <message>
        <source>One of the encoders slips. Next: clean the wheels, press them on and drive again.</source>
        <translation>Einer der Drehgeber rutscht. Weiter: Räder reinigen, andrücken und erneut fahren.</translation>
    </message>
    <message>
        <source>One pulse is %1 µm of rail. Next: enter it where the encoder&apos;s pulses are divided into triggers.</source>
        <translation>Ein Impuls entspricht %1 µm Schiene. Weiter: dort eintragen, wo die Impulse des Drehgebers in Trigger geteilt werden.</translation>
    </message>
</context>
<context>
    <name>vignole::FramesDrawing</name>
    <message>
        <source>Frames: world on the light plane, camera, image</source>
        <translation>Koordinatensysteme: Welt auf der Lichtebene, Kamera, Bild</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Welt</translation>
    </message>
</context>
<context>
    <name>vignole::HeaderBar</name>
    <message>
        <source>Rail</source>
        <translation>Schiene</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Schmelze</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Gauge</source>
        <translation>Messanlage</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>Helles Thema</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>Dunkles Thema</translation>
    </message>
    <message>
        <source>Other theme (Ctrl+D)</source>
        <translation>Anderes Thema (Strg+D)</translation>
    </message>
    <message>
        <source>%1: sign in</source>
        <translation>%1: anmelden</translation>
    </message>
    <message>
        <source>%1, %2: sign out</source>
        <translation>%1, %2: abmelden</translation>
    </message>
    <message>
        <source>Sign in (Ctrl+L)</source>
        <translation>Anmelden (Strg+L)</translation>
    </message>
    <message>
        <source>%1: sign out (Ctrl+L)</source>
        <translation>%1: abmelden (Strg+L)</translation>
    </message>
    <message>
        <source>Line: %1</source>
        <translation>Linie: %1</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULATION</translation>
    </message>
    <message>
        <source>Simulation: the rails are not real</source>
        <translation>Simulation: die Schienen sind nicht echt</translation>
    </message>
    <message>
        <source>The rails come from the virtual rig</source>
        <translation>Die Schienen kommen von der virtuellen Anlage</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
</context>
<context>
    <name>vignole::LastRails</name>
    <message>
        <source>Out</source>
        <translation>Außerhalb</translation>
    </message>
    <message>
        <source>, held</source>
        <translation>, gehalten</translation>
    </message>
    <message>
        <source>, now</source>
        <translation>, jetzt</translation>
    </message>
    <message>
        <source>good %1 of %2</source>
        <translation>gut %1 von %2</translation>
    </message>
    <message>
        <source>Last rails: %1</source>
        <translation>Letzte Schienen: %1</translation>
    </message>
    <message>
        <source>Last rails</source>
        <translation>Letzte</translation>
    </message>
</context>
<context>
    <name>vignole::LensWizard</name>
    <message>
        <source>Cancelling…</source>
        <translation>Bricht ab…</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Vorbereiten</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Parts of the picture that have been seen</source>
        <translation>Teile des Bildes, die gesehen wurden</translation>
    </message>
    <message>
        <source>Picture of the target</source>
        <translation>Bild der Tafel</translation>
    </message>
    <message>
        <source>Pictures taken</source>
        <translation>Aufgenommene Bilder</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>Schräge</translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>Unschärfe</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Rechnen</translation>
    </message>
    <message>
        <source>Lens models (Table III)</source>
        <translation>Objektivmodelle (Tabelle III)</translation>
    </message>
    <message>
        <source>Distortion model</source>
        <translation>Verzeichnungsmodell</translation>
    </message>
    <message>
        <source>Mean error px</source>
        <translation>Mittl. Abw. px</translation>
    </message>
    <message>
        <source>RMS px</source>
        <translation>RMS px</translation>
    </message>
    <message>
        <source>Not seen before px</source>
        <translation>Ungesehene Bilder px</translation>
    </message>
    <message>
        <source>Focal length mm</source>
        <translation>Brennweite mm</translation>
    </message>
    <message>
        <source>Lens models that were tried</source>
        <translation>Erprobte Objektivmodelle</translation>
    </message>
    <message>
        <source>Coverage and residuals</source>
        <translation>Abdeckung und Residuen</translation>
    </message>
    <message>
        <source>Points of all pictures</source>
        <translation>Punkte aller Bilder</translation>
    </message>
    <message>
        <source>Mean residual by place</source>
        <translation>Mittleres Residuum nach Ort</translation>
    </message>
    <message>
        <source>The flat target with circles is held before one camera, in the pose that is drawn, picture by picture. The lens model is the simplest that predicts pictures it has not seen.
Target: %1, points within ±%2 µm.</source>
        <translation>Die ebene Tafel mit Kreisen wird vor eine Kamera gehalten, Bild für Bild in der gezeichneten Lage. Das Objektivmodell ist das einfachste, das ungesehene Bilder vorhersagt.
Tafel: %1, Punkte auf ±%2 µm.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Camera whose lens is calibrated</source>
        <translation>Kamera, deren Objektiv kalibriert wird</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>Pictures: twelve cover a lens.</source>
        <translation>Bilder: zwölf decken ein Objektiv ab.</translation>
    </message>
    <message>
        <source>Number of pictures</source>
        <translation>Anzahl der Bilder</translation>
    </message>
    <message>
        <source>Target to the right, mm</source>
        <translation>Tafel nach rechts, mm</translation>
    </message>
    <message>
        <source>Target down, mm</source>
        <translation>Tafel nach unten, mm</translation>
    </message>
    <message>
        <source>Distance of the target, mm</source>
        <translation>Abstand der Tafel, mm</translation>
    </message>
    <message>
        <source>Tilt up and down, degrees</source>
        <translation>Neigung auf und ab, Grad</translation>
    </message>
    <message>
        <source>Tilt to the sides, degrees</source>
        <translation>Neigung zu den Seiten, Grad</translation>
    </message>
    <message>
        <source>Turn of the target, degrees</source>
        <translation>Drehung der Tafel, Grad</translation>
    </message>
    <message>
        <source>Hold as shown</source>
        <translation>So halten</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Take picture</source>
        <translation>Bild aufnehmen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Use with the plate</source>
        <translation>Mit Platte verwenden</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Sichern…</translation>
    </message>
    <message>
        <source>The camera is needed for the pictures of the target. Stop the line to go on; what has been taken so far is kept.</source>
        <translation>Die Kamera wird für die Bilder der Tafel gebraucht. Zum Fortfahren die Linie stoppen; was bisher aufgenommen ist, bleibt.</translation>
    </message>
    <message>
        <source>Progress of the solution</source>
        <translation>Fortschritt der Rechnung</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Abgebrochen: nichts hat sich geändert.</translation>
    </message>
    <message>
        <source>Lens of the camera</source>
        <translation>Objektiv der Kamera</translation>
    </message>
    <message>
        <source>camera%1.toml</source>
        <translation>camera%1.toml</translation>
    </message>
    <message>
        <source>Vignole (*.toml);;OpenCV (*.yaml);;HALCON (*.dat);;mrcal (*.cameramodel)</source>
        <translation>Vignole (*.toml);;OpenCV (*.yaml);;HALCON (*.dat);;mrcal (*.cameramodel)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>camera and target</source>
        <translation>Kamera und Tafel</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>model chosen by the data</source>
        <translation>Modell nach den Daten gewählt</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Table III, residuals</source>
        <translation>Tabelle III, Residuen</translation>
    </message>
    <message>
        <source>%1 % of the picture</source>
        <translation>%1 % des Bildes</translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>Noch keine.</translation>
    </message>
    <message>
        <source>May be used, but: %1</source>
        <translation>Verwendbar, aber: %1</translation>
    </message>
    <message>
        <source>May be used: mean error %1 px with the model %2, chosen by pictures it had not seen.</source>
        <translation>Verwendbar: mittlere Abweichung %1 px mit dem Modell %2, gewählt an Bildern, die es nicht gesehen hatte.</translation>
    </message>
    <message>
        <source>%1, chosen</source>
        <translation>%1, gewählt</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Next: choose the camera.</source>
        <translation>Weiter: Kamera wählen.</translation>
    </message>
    <message>
        <source>First picture</source>
        <translation>Erstes Bild</translation>
    </message>
    <message>
        <source>Looking at the target…</source>
        <translation>Prüft die Tafel…</translation>
    </message>
    <message>
        <source>This picture would be refused: %1</source>
        <translation>Dieses Bild würde abgelehnt: %1</translation>
    </message>
    <message>
        <source>This picture would be refused, because it shows the pose of picture %1; move the target to the dashed outline.</source>
        <translation>Dieses Bild würde abgelehnt, weil es die Lage von Bild %1 zeigt; die Tafel zum gestrichelten Umriss bewegen.</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) found.</source>
        <translation>
            <numerusform>%n Punkt gefunden.</numerusform>
            <numerusform>%n Punkte gefunden.</numerusform>
        </translation>
    </message>
    <message>
        <source>Next: solve, or take more.</source>
        <translation>Weiter: rechnen oder mehr aufnehmen.</translation>
    </message>
    <message>
        <source>Working out which pose tells most…</source>
        <translation>Sucht die Lage, die am meisten aussagt…</translation>
    </message>
    <message numerus="yes">
        <source>Next: hold the target to the dashed outline and take the picture; %n to go.</source>
        <translation>
            <numerusform>Weiter: Tafel an den gestrichelten Umriss halten und das Bild aufnehmen; noch %n.</numerusform>
            <numerusform>Weiter: Tafel an den gestrichelten Umriss halten und das Bild aufnehmen; noch %n.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Next: %1; %n to go.</source>
        <translation>
            <numerusform>Weiter: %1; noch %n.</numerusform>
            <numerusform>Weiter: %1; noch %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>Lens models are adjusted and tried on pictures they have not seen.</source>
        <translation>Objektivmodelle werden ausgeglichen und an Bildern erprobt, die sie nicht gesehen haben.</translation>
    </message>
    <message>
        <source>Next: nothing to do; the result comes by itself.</source>
        <translation>Weiter: nichts zu tun; das Ergebnis kommt von selbst.</translation>
    </message>
    <message>
        <source>Refused: it cannot be used.</source>
        <translation>Abgelehnt: nicht verwendbar.</translation>
    </message>
    <message>
        <source>The wizard of the range finders uses this lens. Next: calibrate the range finders.</source>
        <translation>Der Assistent der Lichtschnittsensoren verwendet dieses Objektiv. Weiter: Lichtschnittsensoren kalibrieren.</translation>
    </message>
    <message>
        <source>Next: use it with the plate, or save it.</source>
        <translation>Weiter: mit der Platte verwenden oder sichern.</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone. Start the program on the virtual rig.</source>
        <translation>Es ist keine Anlage vorhanden: die Assistenten sehen nur durch die virtuelle Anlage. Programm mit der virtuellen Anlage starten.</translation>
    </message>
</context>
<context>
    <name>vignole::MainWindow</name>
    <message>
        <source>Is this rail good?</source>
        <translation>Ist diese Schiene gut?</translation>
    </message>
    <message>
        <source>The large word is the verdict of the rail so far; beside it stands whether the gauge can be trusted. Both are made for two metres&apos; distance.</source>
        <translation>Das große Wort ist das bisherige Urteil über die Schiene; daneben steht, ob der Messanlage zu trauen ist. Beides ist aus zwei Metern lesbar.</translation>
    </message>
    <message>
        <source>The measured profile</source>
        <translation>Das Messprofil</translation>
    </message>
    <message>
        <source>The rail as it is measured, over its section; deviations are drawn twenty times larger. Keys 1 to 4 show whole, head, web and foot, + and − change the magnification, C colours by camera.</source>
        <translation>Die Schiene, wie sie gemessen wird, über ihrem Profil; Abweichungen sind zwanzigfach vergrößert. Die Tasten 1 bis 4 zeigen alles, Kopf, Steg und Fuß, + und − ändern die Vergrößerung, C färbt nach Kamera.</translation>
    </message>
    <message>
        <source>Every dimension</source>
        <translation>Jedes Maß</translation>
    </message>
    <message>
        <source>Value, deviation, uncertainty and where it lies in its tolerance; the hatched ends are closer to a limit than the uncertainty. Choose a row to see the dimension in the drawing.</source>
        <translation>Wert, Abweichung, Unsicherheit und Lage in der Toleranz; die schraffierten Enden liegen einer Grenze näher als die Unsicherheit. Eine Zeile wählen zeigt das Maß in der Zeichnung.</translation>
    </message>
    <message>
        <source>What runs</source>
        <translation>Was läuft</translation>
    </message>
    <message>
        <source>The line, the rail and who is here. SIMULATION: without a site the rails come from a virtual rig, measured by the real engine.</source>
        <translation>Die Linie, die Schiene und wer hier ist. SIMULATION: ohne Standort kommen die Schienen von einer virtuellen Anlage, gemessen vom echten Messkern.</translation>
    </message>
    <message>
        <source>Ten pages</source>
        <translation>Zehn Seiten</translation>
    </message>
    <message>
        <source>F1 to F10, in this order: rails that passed are on F4, alarms on F8, language, units and people on F10. Ctrl+R stops and starts the line.</source>
        <translation>F1 bis F10, in dieser Reihenfolge: durchgelaufene Schienen auf F4, Alarme auf F8, Sprache, Einheiten und Personen auf F10. Strg+R stoppt und startet die Linie.</translation>
    </message>
    <message>
        <source>Close Vignole</source>
        <translation>Vignole schließen</translation>
    </message>
    <message>
        <source>A rail is being measured.</source>
        <translation>Eine Schiene wird gemessen.</translation>
    </message>
    <message>
        <source>What has been measured of it is kept; the rest would pass unmeasured.</source>
        <translation>Was davon gemessen ist, bleibt; der Rest liefe ungemessen durch.</translation>
    </message>
    <message>
        <source>Close after this rail</source>
        <translation>Nach dieser Schiene schließen</translation>
    </message>
    <message>
        <source>Close now</source>
        <translation>Jetzt schließen</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Bleiben</translation>
    </message>
</context>
<context>
    <name>vignole::MonitorPage</name>
    <message>
        <source>Whole</source>
        <translation>Ganz</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Web</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>View: %1</source>
        <translation>Ansicht: %1</translation>
    </message>
    <message>
        <source>%1 of the section (%2)</source>
        <translation>%1, vom Profil (%2)</translation>
    </message>
    <message>
        <source>Magnify deviations less</source>
        <translation>Abweichungen weniger vergrößern</translation>
    </message>
    <message>
        <source>Magnify deviations less (−)</source>
        <translation>Abweichungen weniger vergrößern (−)</translation>
    </message>
    <message>
        <source>Deviations are drawn so many times larger (0: back to 20)</source>
        <translation>So viele Male größer werden Abweichungen gezeichnet (0: zurück auf 20)</translation>
    </message>
    <message>
        <source>Magnify deviations more</source>
        <translation>Abweichungen mehr vergrößern</translation>
    </message>
    <message>
        <source>Magnify deviations more (+)</source>
        <translation>Abweichungen mehr vergrößern (+)</translation>
    </message>
    <message>
        <source>By camera</source>
        <translation>Nach Kamera</translation>
    </message>
    <message>
        <source>Colour points by camera</source>
        <translation>Punkte nach Kamera färben</translation>
    </message>
    <message>
        <source>Colour points by camera (C)</source>
        <translation>Punkte nach Kamera färben (C)</translation>
    </message>
    <message>
        <source>Drawing in full view</source>
        <translation>Zeichnung in Vollansicht</translation>
    </message>
    <message>
        <source>Drawing in full view (F11)</source>
        <translation>Zeichnung in Vollansicht (F11)</translation>
    </message>
    <message>
        <source>Stop line</source>
        <translation>Linie stoppen</translation>
    </message>
    <message>
        <source>Start line</source>
        <translation>Linie starten</translation>
    </message>
    <message>
        <source>%1 (Ctrl+R)</source>
        <translation>%1 (Strg+R)</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>Show the points before registration</source>
        <translation>Punkte vor dem Einpassen zeigen</translation>
    </message>
    <message>
        <source>Show the points before registration (B)</source>
        <translation>Punkte vor dem Einpassen zeigen (B)</translation>
    </message>
</context>
<context>
    <name>vignole::NextRailDialog</name>
    <message>
        <source>Next rail</source>
        <translation>Nächste Schiene</translation>
    </message>
    <message>
        <source>What is entered here goes with the next rail that begins. An empty field stays as the line has it.</source>
        <translation>Was hier eingetragen wird, gilt für die nächste Schiene, die beginnt. Ein leeres Feld bleibt, wie die Linie es hat.</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Schiene</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Schmelze</translation>
    </message>
    <message>
        <source>Strand</source>
        <translation>Strang</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>Temperature, °C</source>
        <translation>Temperatur, °C</translation>
    </message>
    <message>
        <source>For the next rail</source>
        <translation>Für die nächste Schiene</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Zurückziehen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Waits for the next rail.</source>
        <translation>Wartet auf die nächste Schiene.</translation>
    </message>
    <message>
        <source>%1 waits for the next rail.</source>
        <translation>%1 wartet auf die nächste Schiene.</translation>
    </message>
    <message>
        <source>The rail has begun with what was entered.</source>
        <translation>Die Schiene hat mit den Eingaben begonnen.</translation>
    </message>
    <message>
        <source>The temperature is no number from %1 to %2 °C.</source>
        <translation>Die Temperatur ist keine Zahl von %1 bis %2 °C.</translation>
    </message>
    <message>
        <source>Nothing was entered: fill in at least one field.</source>
        <translation>Nichts eingetragen: mindestens ein Feld ausfüllen.</translation>
    </message>
    <message>
        <source>Nothing waits: the next rail is named by the line.</source>
        <translation>Nichts wartet: die nächste Schiene benennt die Linie.</translation>
    </message>
</context>
<context>
    <name>vignole::PeoplePanel</name>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Names and roles are the administrator&apos;s: sign in as administrator to see and enter people.</source>
        <translation>Namen und Rollen verwaltet der Administrator: als Administrator anmelden, um Personen zu sehen und einzutragen.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Last here</source>
        <translation>Zuletzt hier</translation>
    </message>
    <message>
        <source>People who may sign in</source>
        <translation>Personen, die sich anmelden dürfen</translation>
    </message>
    <message>
        <source>Name of the new person</source>
        <translation>Name der neuen Person</translation>
    </message>
    <message>
        <source>First or new password</source>
        <translation>Erstes oder neues Passwort</translation>
    </message>
    <message>
        <source>First password of the new person</source>
        <translation>Erstes Passwort der neuen Person</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Reason for entering the person</source>
        <translation>Grund für den Eintrag</translation>
    </message>
    <message>
        <source>Role of the new person</source>
        <translation>Rolle der neuen Person</translation>
    </message>
    <message>
        <source>Enter a person</source>
        <translation>Person eintragen</translation>
    </message>
    <message>
        <source>Give a new password</source>
        <translation>Neues Passwort vergeben</translation>
    </message>
    <message>
        <source>Give the chosen person a new password</source>
        <translation>Der gewählten Person ein neues Passwort geben</translation>
    </message>
    <message>
        <source>Give this role</source>
        <translation>Diese Rolle geben</translation>
    </message>
    <message>
        <source>Give the chosen person this role</source>
        <translation>Der gewählten Person diese Rolle geben</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verriegelt</translation>
    </message>
    <message>
        <source>chooses a password</source>
        <translation>wählt ein Passwort</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>Open the account</source>
        <translation>Konto öffnen</translation>
    </message>
    <message>
        <source>Close the account</source>
        <translation>Konto sperren</translation>
    </message>
    <message>
        <source>Open the account of the chosen person</source>
        <translation>Konto der gewählten Person öffnen</translation>
    </message>
    <message>
        <source>Close the account of the chosen person</source>
        <translation>Konto der gewählten Person sperren</translation>
    </message>
    <message>
        <source>%1 is entered.</source>
        <translation>%1 ist eingetragen.</translation>
    </message>
    <message>
        <source>%1 has a new password and chooses another at the next sign-in.</source>
        <translation>%1 hat ein neues Passwort und wählt beim nächsten Anmelden ein anderes.</translation>
    </message>
    <message>
        <source>%1 is now %2.</source>
        <translation>%1 ist jetzt %2.</translation>
    </message>
    <message>
        <source>The account of %1 is closed.</source>
        <translation>Das Konto von %1 ist gesperrt.</translation>
    </message>
    <message>
        <source>The account of %1 is open.</source>
        <translation>Das Konto von %1 ist offen.</translation>
    </message>
</context>
<context>
    <name>vignole::PipelinePanel</name>
    <message>
        <source>Pipeline: %1 triggers, %2 measured, %3 incomplete, %4 lost</source>
        <translation>Verarbeitung: %1 Trigger, %2 gemessen, %3 unvollständig, %4 verloren</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>keine Daten</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>SD %1   UCL %2</source>
        <translation>SD %1   OKG %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Acquisition</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Line extraction</source>
        <translation>Linienextraktion</translation>
    </message>
    <message>
        <source>2D to 3D</source>
        <translation>2D zu 3D</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Messprofil</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>registered</source>
        <translation>eingepasst</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>nicht eingepasst</translation>
    </message>
    <message numerus="yes">
        <source>%n dimension(s)</source>
        <translation>
            <numerusform>%n Maß</numerusform>
            <numerusform>%n Maße</numerusform>
        </translation>
    </message>
    <message>
        <source>SD %1</source>
        <translation>SD %1</translation>
    </message>
    <message>
        <source>99 % UCL %1</source>
        <translation>99 % OKG %1</translation>
    </message>
    <message>
        <source>Consumers</source>
        <translation>Abnehmer</translation>
    </message>
    <message>
        <source>in the queue now</source>
        <translation>jetzt wartend</translation>
    </message>
    <message>
        <source>highest fill, of how many places</source>
        <translation>höchste Füllung, von wie vielen Plätzen</translation>
    </message>
    <message>
        <source>mean time, SD standard deviation, UCL upper limit of its 99 % confidence interval</source>
        <translation>mittlere Zeit, SD Standardabweichung, OKG obere Grenze ihres 99-%-Vertrauensbereichs</translation>
    </message>
</context>
<context>
    <name>vignole::PlateView</name>
    <message>
        <source>no picture yet</source>
        <translation>noch kein Bild</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>%1 of %2 pins</source>
        <translation>%1 von %2 Stiften</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>Kamera %1: %2</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>no pin here</source>
        <translation>hier kein Stift</translation>
    </message>
    <message>
        <source>not found: %1</source>
        <translation>nicht gefunden: %1</translation>
    </message>
</context>
<context>
    <name>vignole::ProfileCanvas</name>
    <message>
        <source>Measured profile over the section</source>
        <translation>Messprofil über dem Schienenprofil</translation>
    </message>
    <message>
        <source>last profile at %1 m, %2 ago</source>
        <translation>letztes Messprofil bei %1 m, vor %2</translation>
    </message>
</context>
<context>
    <name>vignole::QualityPage</name>
    <message>
        <source>Repeatability</source>
        <translation>Wiederholbarkeit</translation>
    </message>
    <message>
        <source>runs of the same rail</source>
        <translation>Läufe derselben Schiene</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Length, m</source>
        <translation>Länge, m</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Single profiles</source>
        <translation>Einzelne Messprofile</translation>
    </message>
    <message>
        <source>Means over 0.1 m</source>
        <translation>Mittel über 0,1 m</translation>
    </message>
    <message>
        <source>Means over 1 m</source>
        <translation>Mittel über 1 m</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>Was verglichen wird</translation>
    </message>
    <message>
        <source>Compare the chosen runs</source>
        <translation>Gewählte Läufe vergleichen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export…</translation>
    </message>
    <message>
        <source>as Fig. 9a</source>
        <translation>wie Abb. 9a</translation>
    </message>
    <message>
        <source>Range of the runs</source>
        <translation>Spannweite der Läufe</translation>
    </message>
    <message>
        <source>Values of every run over the length</source>
        <translation>Werte jedes Laufs über der Länge</translation>
    </message>
    <message>
        <source>reading …</source>
        <translation>liest …</translation>
    </message>
    <message>
        <source>No rail has been kept yet. Runs of the same rail are compared here.</source>
        <translation>Noch keine Schiene aufbewahrt. Hier werden Läufe derselben Schiene verglichen.</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>Länge, m</translation>
    </message>
    <message>
        <source>range</source>
        <translation>Spannweite</translation>
    </message>
    <message>
        <source>range, %1</source>
        <translation>Spannweite, %1</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Als CSV exportieren</translation>
    </message>
    <message>
        <source>truth of the virtual rig</source>
        <translation>Wahrheit der virtuellen Anlage</translation>
    </message>
    <message numerus="yes">
        <source>The inspections were cancelled; %n were whole.</source>
        <translation>
            <numerusform>Die Prüfungen wurden abgebrochen; %n war vollständig.</numerusform>
            <numerusform>Die Prüfungen wurden abgebrochen; %n waren vollständig.</numerusform>
        </translation>
    </message>
    <message>
        <source>Runs of one rail</source>
        <translation>Läufe einer Schiene</translation>
    </message>
    <message>
        <source>Reference values</source>
        <translation>Referenzwerte</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Bericht als PDF</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Rails of the archive</source>
        <translation>Schienen des Archivs</translation>
    </message>
    <message>
        <source>Runs from a file</source>
        <translation>Läufe aus einer Datei</translation>
    </message>
    <message>
        <source>Virtual rig</source>
        <translation>Virtuelle Anlage</translation>
    </message>
    <message>
        <source>Where the runs come from</source>
        <translation>Woher die Läufe kommen</translation>
    </message>
    <message>
        <source>3 m of rail</source>
        <translation>3 m Schiene</translation>
    </message>
    <message>
        <source>12 m of rail</source>
        <translation>12 m Schiene</translation>
    </message>
    <message>
        <source>60 m of rail, as the paper</source>
        <translation>60 m Schiene, wie im Aufsatz</translation>
    </message>
    <message>
        <source>Length of the virtual rail</source>
        <translation>Länge der virtuellen Schiene</translation>
    </message>
    <message>
        <source>Means over 0.5 m</source>
        <translation>Mittel über 0,5 m</translation>
    </message>
    <message>
        <source>Runs that may be laid over each other</source>
        <translation>Läufe, die sich übereinanderlegen lassen</translation>
    </message>
    <message>
        <source>Open runs…</source>
        <translation>Läufe öffnen…</translation>
    </message>
    <message>
        <source>Open runs from a CSV file</source>
        <translation>Läufe aus einer CSV-Datei öffnen</translation>
    </message>
    <message>
        <source>Open reference…</source>
        <translation>Referenz öffnen…</translation>
    </message>
    <message>
        <source>Open reference values from a CSV file</source>
        <translation>Referenzwerte aus einer CSV-Datei öffnen</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Report as PDF (Ctrl+P)</source>
        <translation>Bericht als PDF (Strg+P)</translation>
    </message>
    <message>
        <source>Export values as CSV</source>
        <translation>Werte als CSV exportieren</translation>
    </message>
    <message>
        <source>Export values as CSV (Ctrl+E)</source>
        <translation>Werte als CSV exportieren (Strg+E)</translation>
    </message>
    <message>
        <source>Progress of the inspections</source>
        <translation>Fortschritt der Prüfungen</translation>
    </message>
    <message>
        <source>What the runs differ by over the length</source>
        <translation>Worin sich die Läufe über der Länge unterscheiden</translation>
    </message>
    <message>
        <source>Every dimension; the chosen one is drawn</source>
        <translation>Jedes Maß; das gewählte ist gezeichnet</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Figures of the chosen dimension, formulas and constants</source>
        <translation>Kennwerte des gewählten Maßes, Formeln und Konstanten</translation>
    </message>
    <message>
        <source>Stored runs come from the archive, and there is none (%1): start the program with --archive FILE, or choose a file or the virtual rig above.</source>
        <translation>Gespeicherte Läufe kommen aus dem Archiv, und es gibt keines (%1): Programm mit --archive FILE starten oder oben eine Datei oder die virtuelle Anlage wählen.</translation>
    </message>
    <message>
        <source>virtual rig</source>
        <translation>virtuelle Anlage</translation>
    </message>
    <message>
        <source>run %1</source>
        <translation>Lauf %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Inspect the rail five times</source>
        <translation>Schiene fünfmal prüfen</translation>
    </message>
    <message>
        <source>Cancel the inspections</source>
        <translation>Prüfungen abbrechen</translation>
    </message>
    <message>
        <source>Inspect the same virtual rail five times</source>
        <translation>Dieselbe virtuelle Schiene fünfmal prüfen</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R)</source>
        <translation>Zuerst die Linie stoppen (Strg+R)</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R): both need all processors, and no trigger may be lost to a study.</source>
        <translation>Zuerst die Linie stoppen (Strg+R): beide brauchen alle Prozessoren, und für eine Studie darf kein Trigger verloren gehen.</translation>
    </message>
    <message>
        <source>Accuracy needs a reference: open a CSV with the columns dimension, position_m, value and, if known, u.</source>
        <translation>Genauigkeit braucht eine Referenz: eine CSV-Datei mit den Spalten dimension, position_m, value und, falls bekannt, u öffnen.</translation>
    </message>
    <message>
        <source>At least 1 run is needed, none is chosen.</source>
        <translation>Mindestens 1 Lauf ist nötig, keiner ist gewählt.</translation>
    </message>
    <message>
        <source>At least 2 runs of the same rail are needed, %1 chosen: choose %2 more. The paper took 5.</source>
        <translation>Mindestens 2 Läufe derselben Schiene sind nötig, %1 gewählt: noch %2 wählen. Der Aufsatz nahm 5.</translation>
    </message>
    <message>
        <source>stored rails, same rail and gauge</source>
        <translation>gespeicherte Schienen, gleiche Schiene und Messanlage</translation>
    </message>
    <message>
        <source>file %1</source>
        <translation>Datei %1</translation>
    </message>
    <message>
        <source>virtual rig, exact calibration, other wander, vibration, scale, speckle and noise in every run</source>
        <translation>virtuelle Anlage, exakte Kalibrierung, in jedem Lauf anderes Wandern, andere Schwingung, anderer Zunder, Speckle und Rauschen</translation>
    </message>
    <message>
        <source>The same rail is inspected five times …</source>
        <translation>Dieselbe Schiene wird fünfmal geprüft …</translation>
    </message>
    <message>
        <source>Conditions: %1.</source>
        <translation>Bedingungen: %1.</translation>
    </message>
    <message>
        <source>Tick the runs that were made of the same rail and compare.</source>
        <translation>Läufe derselben Schiene ankreuzen und vergleichen.</translation>
    </message>
    <message>
        <source>A CSV with the columns run, position_m and dimensions, as inspect --csv writes it.</source>
        <translation>Eine CSV-Datei mit den Spalten run, position_m und den Maßen, wie inspect --csv sie schreibt.</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R): both need all processors.</source>
        <translation>Zuerst die Linie stoppen (Strg+R): beide brauchen alle Prozessoren.</translation>
    </message>
    <message>
        <source>The paper&apos;s experiment: one rail, five inspections, the truth known.</source>
        <translation>Der Versuch des Aufsatzes: eine Schiene, fünf Prüfungen, die Wahrheit bekannt.</translation>
    </message>
    <message>
        <source>No runs are compared yet</source>
        <translation>Noch keine Läufe verglichen</translation>
    </message>
    <message>
        <source>%1 over the length</source>
        <translation>%1 über der Länge</translation>
    </message>
    <message>
        <source>largest minus smallest at each position, as Fig. 9b</source>
        <translation>größter minus kleinster an jeder Stelle, wie Abb. 9b</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>untere Grenze</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>obere Grenze</translation>
    </message>
    <message>
        <source>mean of %1 m</source>
        <translation>Mittel über %1 m</translation>
    </message>
    <message>
        <source>Error of %1 over the length</source>
        <translation>Abweichung über der Länge: %1</translation>
    </message>
    <message>
        <source>value minus reference, mean of the runs; %1</source>
        <translation>Wert minus Referenz, Mittel der Läufe; %1</translation>
    </message>
    <message>
        <source>value minus reference</source>
        <translation>Wert minus Referenz</translation>
    </message>
    <message>
        <source>Largest error at each position</source>
        <translation>Größte Abweichung an jeder Stelle</translation>
    </message>
    <message>
        <source>of any run</source>
        <translation>eines Laufs</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>größte</translation>
    </message>
    <message>
        <source>no error</source>
        <translation>Abweichung 0</translation>
    </message>
    <message>
        <source>limit of agreement</source>
        <translation>Übereinstimmungsgrenze</translation>
    </message>
    <message>
        <source>error, %1</source>
        <translation>Abweichung, %1</translation>
    </message>
    <message>
        <source>Dim.</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>% T</source>
        <translation>% T</translation>
    </message>
    <message>
        <source>Mean range per %1 m</source>
        <translation>Mittl. Spannweite je %1 m</translation>
    </message>
    <message>
        <source>as Table VI</source>
        <translation>wie Tabelle VI</translation>
    </message>
    <message>
        <source>%1, as Table VI; the stretches are in the report</source>
        <translation>%1, wie Tabelle VI; die Abschnitte stehen im Bericht</translation>
    </message>
    <message>
        <source>%1, as Table VI</source>
        <translation>%1, wie Tabelle VI</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>Bias</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Abweichungen</translation>
    </message>
    <message>
        <source>%1, as Table V</source>
        <translation>%1, wie Tabelle V</translation>
    </message>
    <message>
        <source>as Table V</source>
        <translation>wie Tabelle V</translation>
    </message>
    <message>
        <source>Verdict, figures, formulas and constants stand here when runs are compared.</source>
        <translation>Urteil, Kennwerte, Formeln und Konstanten stehen hier, wenn Läufe verglichen sind.</translation>
    </message>
    <message>
        <source>figures of %1</source>
        <translation>Kennwerte: %1</translation>
    </message>
    <message>
        <source>writing …</source>
        <translation>schreibt …</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 kann nicht geschrieben werden.</translation>
    </message>
</context>
<context>
    <name>vignole::RailBand</name>
    <message>
        <source>Place along the rail</source>
        <translation>Stelle entlang der Schiene</translation>
    </message>
</context>
<context>
    <name>vignole::RailsPage</name>
    <message>
        <source>Rails</source>
        <translation>Schienen</translation>
    </message>
    <message>
        <source>Rail or heat, from its beginning</source>
        <translation>Schiene oder Schmelze, vom Anfang an</translation>
    </message>
    <message>
        <source>Search by rail or heat</source>
        <translation>Nach Schiene oder Schmelze suchen</translation>
    </message>
    <message>
        <source>Any verdict</source>
        <translation>Jedes Urteil</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>Außer Toleranz</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>Grenznah</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Nicht gemessen</translation>
    </message>
    <message>
        <source>Any dimension</source>
        <translation>Jedes Maß</translation>
    </message>
    <message>
        <source>%1 out</source>
        <translation>%1 außerhalb</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Dimension out of tolerance</source>
        <translation>Maß außer Toleranz</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Schiene</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Schmelze</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Schlechtestes</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Rails found</source>
        <translation>Gefundene Schienen</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export…</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Bericht als PDF</translation>
    </message>
    <message>
        <source>Report as PDF (Ctrl+P)</source>
        <translation>Bericht als PDF (Strg+P)</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Zurück zu live</translation>
    </message>
    <message>
        <source>Along the rail</source>
        <translation>Entlang der Schiene</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>Überschreitungen</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>From – to, m</source>
        <translation>Von – bis, m</translation>
    </message>
    <message>
        <source>Worst, mm</source>
        <translation>Schlechtestes, mm</translation>
    </message>
    <message>
        <source>Limits, mm</source>
        <translation>Grenzen, mm</translation>
    </message>
    <message>
        <source>Stretches out of tolerance</source>
        <translation>Abschnitte außer Toleranz</translation>
    </message>
    <message>
        <source>Previous exception</source>
        <translation>Vorige Überschreitung</translation>
    </message>
    <message>
        <source>Previous exception (Shift+N)</source>
        <translation>Vorige Überschreitung (Umschalt+N)</translation>
    </message>
    <message>
        <source>Next exception</source>
        <translation>Nächste Überschreitung</translation>
    </message>
    <message>
        <source>Next exception (N)</source>
        <translation>Nächste Überschreitung (N)</translation>
    </message>
    <message>
        <source>Play along the rail</source>
        <translation>Entlang der Schiene abspielen</translation>
    </message>
    <message>
        <source>Play or pause (P)</source>
        <translation>Abspielen oder anhalten (P)</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Messprofil</translation>
    </message>
    <message>
        <source>No rail is open</source>
        <translation>Keine Schiene geöffnet</translation>
    </message>
    <message>
        <source>Choose a rail in the list: its profile, its dimensions along the rail and its exceptions are shown here.</source>
        <translation>Schiene in der Liste wählen: hier erscheinen ihr Messprofil, ihre Maße entlang der Schiene und ihre Überschreitungen.</translation>
    </message>
    <message>
        <source>Rails are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>Schienen werden nicht aufbewahrt: %1. Programm mit einem Archiv starten (--archive FILE).</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>No rail is like that. Clear the search or choose other filters.</source>
        <translation>Keine Schiene entspricht dem. Suche leeren oder andere Filter wählen.</translation>
    </message>
    <message>
        <source>No rail has been measured yet. Rails appear here when they have passed.</source>
        <translation>Noch keine Schiene gemessen. Schienen erscheinen hier, wenn sie durchgelaufen sind.</translation>
    </message>
    <message>
        <source>Replay: not live.  Rail %1, %2 to %3, recipe %4, calibration %5</source>
        <translation>Wiedergabe: nicht live.  Schiene %1, %2 bis %3, Rezept %4, Kalibrierung %5</translation>
    </message>
    <message>
        <source>none: every dimension stayed within its limits</source>
        <translation>keine: jedes Maß blieb in seinen Grenzen</translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es)</source>
        <translation>
            <numerusform>%n Abschnitt</numerusform>
            <numerusform>%n Abschnitte</numerusform>
        </translation>
    </message>
    <message>
        <source>The profile cannot be drawn: %1.</source>
        <translation>Das Messprofil lässt sich nicht zeichnen: %1.</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Profile at %1 m</source>
        <translation>Messprofil bei %1 m</translation>
    </message>
    <message>
        <source>no. %1 of %2</source>
        <translation>Nr. %1 von %2</translation>
    </message>
    <message>
        <source>: points were not kept of this rail, the model is shown</source>
        <translation>: von dieser Schiene wurden keine Punkte aufbewahrt, gezeigt ist das Modell</translation>
    </message>
    <message>
        <source>; drawn is no. %1, the nearest whose points were kept</source>
        <translation>; gezeichnet ist Nr. %1, das nächste mit aufbewahrten Punkten</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>writing %1 …</source>
        <translation>schreibt %1 …</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 ist geschrieben</translation>
    </message>
    <message>
        <source>Any time</source>
        <translation>Jederzeit</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>7 days</source>
        <translation>7 Tage</translation>
    </message>
    <message>
        <source>4 weeks</source>
        <translation>4 Wochen</translation>
    </message>
    <message>
        <source>12 months</source>
        <translation>12 Monate</translation>
    </message>
    <message>
        <source>Any section</source>
        <translation>Jedes Profil</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Clear search and filters</source>
        <translation>Suche und Filter leeren</translation>
    </message>
    <message>
        <source>What if…</source>
        <translation>Was wäre wenn…</translation>
    </message>
    <message>
        <source>Judge the rails found with other limits</source>
        <translation>Gefundene Schienen mit anderen Grenzen beurteilen</translation>
    </message>
    <message>
        <source>Next rail…</source>
        <translation>Nächste Schiene…</translation>
    </message>
    <message>
        <source>Enter the papers of the next rail</source>
        <translation>Begleitdaten der nächsten Schiene eintragen</translation>
    </message>
    <message>
        <source>Export as CSV or JSON</source>
        <translation>Als CSV oder JSON exportieren</translation>
    </message>
    <message>
        <source>Export as CSV or JSON (Ctrl+E)</source>
        <translation>Als CSV oder JSON exportieren (Strg+E)</translation>
    </message>
    <message>
        <source>Nothing new is kept: nobody writes into this archive.</source>
        <translation>Nichts Neues wird aufbewahrt: niemand schreibt in dieses Archiv.</translation>
    </message>
    <message>
        <source>Nothing is kept. Live rails are shown on Monitor only.</source>
        <translation>Nichts wird aufbewahrt. Laufende Schienen zeigt nur der Monitor.</translation>
    </message>
    <message>
        <source>; %1 profiles lost</source>
        <translation>; %1 Messprofile verloren</translation>
    </message>
    <message>
        <source>; points of %1 profiles left out</source>
        <translation>; Punkte von %1 Messprofilen ausgelassen</translation>
    </message>
    <message>
        <source>Nothing can be written: %1. What passes waits in memory.</source>
        <translation>Es kann nicht geschrieben werden: %1. Was durchläuft, wartet im Speicher.</translation>
    </message>
    <message>
        <source>kept since the start: %1 rails; %2 profiles wait</source>
        <translation>seit dem Start aufbewahrt: %1 Schienen; %2 Messprofile warten</translation>
    </message>
    <message>
        <source>nearest to a limit, inside</source>
        <translation>einer Grenze am nächsten, innerhalb</translation>
    </message>
    <message>
        <source>furthest beyond a limit, mm</source>
        <translation>am weitesten jenseits einer Grenze, mm</translation>
    </message>
    <message>
        <source>Dimension that is drawn</source>
        <translation>Gezeichnetes Maß</translation>
    </message>
    <message>
        <source>Show the points before registration</source>
        <translation>Punkte vor dem Einpassen zeigen</translation>
    </message>
</context>
<context>
    <name>vignole::RateChart</name>
    <message>
        <source>Alarms in each ten minutes of the last %1 hours: at most %2</source>
        <translation>Alarme je zehn Minuten der letzten %1 Stunden: höchstens %2</translation>
    </message>
    <message>
        <source>flood above %1</source>
        <translation>Alarmflut über %1</translation>
    </message>
    <message>
        <source>hours; dotted at %1: target</source>
        <translation>Stunden; gepunktet bei %1: Ziel</translation>
    </message>
</context>
<context>
    <name>vignole::RecipesPage</name>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>Retired</source>
        <translation>Zurückgezogen</translation>
    </message>
    <message>
        <source>With the program</source>
        <translation>Mit dem Programm</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Rezepte</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Recipes and their versions</source>
        <translation>Rezepte und ihre Versionen</translation>
    </message>
    <message>
        <source>Section of the new recipe</source>
        <translation>Profil des neuen Rezepts</translation>
    </message>
    <message>
        <source>Profile and straightness class of the new recipe</source>
        <translation>Profil- und Geradheitsklasse des neuen Rezepts</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>New draft from section and class</source>
        <translation>Neuer Entwurf aus Profil und Klasse</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Import…</translation>
    </message>
    <message>
        <source>Import a recipe file as a draft</source>
        <translation>Rezeptdatei als Entwurf importieren</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export…</translation>
    </message>
    <message>
        <source>Export the chosen recipe</source>
        <translation>Gewähltes Rezept exportieren</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>Nominal, mm</source>
        <translation>Nennmaß, mm</translation>
    </message>
    <message>
        <source>Lower, mm</source>
        <translation>Untere, mm</translation>
    </message>
    <message>
        <source>Upper, mm</source>
        <translation>Obere, mm</translation>
    </message>
    <message>
        <source>Tolerances of the chosen recipe</source>
        <translation>Toleranzen des gewählten Rezepts</translation>
    </message>
    <message>
        <source>What is new in it</source>
        <translation>Was daran neu ist</translation>
    </message>
    <message>
        <source>What is new in the draft</source>
        <translation>Was am Entwurf neu ist</translation>
    </message>
    <message>
        <source>Save as a new draft</source>
        <translation>Als neuen Entwurf sichern</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Recipe to compare with</source>
        <translation>Rezept zum Vergleichen</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>There</source>
        <translation>Dort</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Hier</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Was sich unterscheidet</translation>
    </message>
    <message>
        <source>Approval</source>
        <translation>Freigabe</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Reason for the approval</source>
        <translation>Grund der Freigabe</translation>
    </message>
    <message>
        <source>Your password</source>
        <translation>Ihr Passwort</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Approve the draft</source>
        <translation>Entwurf freigeben</translation>
    </message>
    <message>
        <source>against %1 v%2, %3</source>
        <translation>gegen %1 v%2, %3</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Toleranzen</translation>
    </message>
    <message>
        <source>%1 v%2</source>
        <translation>%1 v%2</translation>
    </message>
    <message>
        <source>%1, by %2</source>
        <translation>%1, von %2</translation>
    </message>
    <message>
        <source>Both are the same.</source>
        <translation>Beide sind gleich.</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n Wert</numerusform>
            <numerusform>%n Werte</numerusform>
        </translation>
    </message>
    <message>
        <source>Only a draft is approved.</source>
        <translation>Nur ein Entwurf wird freigegeben.</translation>
    </message>
    <message>
        <source>QA approves: sign in.</source>
        <translation>Die Qualität gibt frei: anmelden.</translation>
    </message>
    <message>
        <source>This draft is yours: somebody else approves it.</source>
        <translation>Dieser Entwurf ist Ihrer: jemand anderes gibt ihn frei.</translation>
    </message>
    <message>
        <source>Approval retires the version before; reason and password go with your name into the audit trail.</source>
        <translation>Die Freigabe zieht die Version davor zurück; Grund und Name kommen in den Prüfpfad, das Passwort bestätigt sie.</translation>
    </message>
    <message>
        <source>%1 v%2 is kept as a draft.</source>
        <translation>%1 v%2 ist als Entwurf aufbewahrt.</translation>
    </message>
    <message>
        <source>%1: the lower limit lies above the upper one; exchange them.</source>
        <translation>%1: die untere Grenze liegt über der oberen; bitte tauschen.</translation>
    </message>
    <message>
        <source>%1: a limit is a number in mm, or empty for none.</source>
        <translation>%1: eine Grenze ist eine Zahl in mm oder leer für keine.</translation>
    </message>
    <message>
        <source>Say what is new in the draft.</source>
        <translation>Sagen, was am Entwurf neu ist.</translation>
    </message>
    <message>
        <source>Approved.</source>
        <translation>Freigegeben.</translation>
    </message>
    <message>
        <source>Import a recipe file</source>
        <translation>Rezeptdatei importieren</translation>
    </message>
    <message>
        <source>Export the recipe</source>
        <translation>Rezept exportieren</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 ist geschrieben</translation>
    </message>
    <message>
        <source>Section…</source>
        <translation>Profil…</translation>
    </message>
    <message>
        <source>Draw the section, or bring one along from a drawing</source>
        <translation>Profil zeichnen oder aus einer Zeichnung mitbringen</translation>
    </message>
    <message>
        <source>What if…</source>
        <translation>Was wäre wenn…</translation>
    </message>
    <message>
        <source>Judge stored rails by the chosen recipe</source>
        <translation>Gespeicherte Schienen nach dem gewählten Rezept beurteilen</translation>
    </message>
    <message>
        <source>Use for the next rail</source>
        <translation>Ab nächster Schiene</translation>
    </message>
    <message>
        <source>Use the chosen recipe for the next rail</source>
        <translation>Gewähltes Rezept für die nächste Schiene verwenden</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Parameters of dimensions and settings of the stages</source>
        <translation>Parameter der Maße und Einstellungen der Stufen</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Settings of the chosen recipe</source>
        <translation>Einstellungen des gewählten Rezepts</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the draft; another name makes a copy</source>
        <translation>Name des Entwurfs; ein anderer Name ergibt eine Kopie</translation>
    </message>
    <message>
        <source>On the line: %1 v%2.</source>
        <translation>Auf der Linie: %1 v%2.</translation>
    </message>
    <message>
        <source>From the next rail: %1.</source>
        <translation>Ab der nächsten Schiene: %1.</translation>
    </message>
    <message>
        <source>Only an approved recipe is measured with.</source>
        <translation>Gemessen wird nur mit einem freigegebenen Rezept.</translation>
    </message>
    <message>
        <source>%1: the value is not of its kind.</source>
        <translation>%1: der Wert ist nicht von der rechten Art.</translation>
    </message>
    <message>
        <source>%1 v%2 is in force from the next rail; the rail in the gauge keeps what it began with.</source>
        <translation>%1 v%2 gilt ab der nächsten Schiene; die Schiene in der Messanlage behält, womit sie begann.</translation>
    </message>
    <message>
        <source>What if needs at least %1 stored rails of section %2, there are %3: measure more first.</source>
        <translation>„Was wäre wenn“ braucht mindestens %1 gespeicherte Schienen des Profils %2, es gibt %3: zuerst mehr messen.</translation>
    </message>
    <message>
        <source>Recipes are read, drafts cannot be kept: %1.</source>
        <translation>Rezepte werden gelesen, Entwürfe können nicht aufbewahrt werden: %1.</translation>
    </message>
</context>
<context>
    <name>vignole::ReferencePanel</name>
    <message>
        <source>Reference piece</source>
        <translation>Referenzstück</translation>
    </message>
    <message>
        <source>Certificate and gauge</source>
        <translation>Kalibrierschein und Anlage</translation>
    </message>
    <message>
        <source>Profiles that are averaged</source>
        <translation>Gemittelte Messprofile</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Fortschritt der Prüfung</translation>
    </message>
    <message>
        <source>Measure the piece</source>
        <translation>Stück messen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Linie stoppen</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Abgebrochen: nichts hat sich geändert.</translation>
    </message>
    <message>
        <source>Closed while the line measures: the piece stands where the rail passes. Stop the line to go on.</source>
        <translation>Gesperrt, solange die Linie misst: das Stück steht, wo die Schiene durchläuft. Zum Fortfahren die Linie stoppen.</translation>
    </message>
    <message>
        <source>A section with a certificate is put into the gauge and measured with the calibration in force. On the virtual rig it is a virtual piece, whose truth is its certificate (U = 2 µm).</source>
        <translation>Ein Profilstück mit Kalibrierschein wird in die Messanlage gesetzt und mit der gültigen Kalibrierung gemessen. Auf der virtuellen Anlage ist es ein virtuelles Stück, dessen Wahrheit sein Kalibrierschein ist (U = 2 µm).</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Misst…</translation>
    </message>
    <message>
        <source>Next: measure the piece.</source>
        <translation>Weiter: Stück messen.</translation>
    </message>
    <message numerus="yes">
        <source>The gauge agrees with the certificate in every dimension, over %n profile(s).</source>
        <translation>
            <numerusform>Die Messanlage stimmt in jedem Maß mit dem Kalibrierschein überein, über %n Messprofil.</numerusform>
            <numerusform>Die Messanlage stimmt in jedem Maß mit dem Kalibrierschein überein, über %n Messprofile.</numerusform>
        </translation>
    </message>
    <message>
        <source>The gauge does not agree with the certificate. Next: clean the piece and measure again; if it stays so, calibrate the range finders.</source>
        <translation>Die Messanlage stimmt nicht mit dem Kalibrierschein überein. Weiter: Stück reinigen und erneut messen; bleibt es so, Lichtschnittsensoren kalibrieren.</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>Certificate %1</source>
        <translation>Kalibrierschein %1</translation>
    </message>
    <message>
        <source>Measured %1</source>
        <translation>Gemessen %1</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Deviation over U</source>
        <translation>Abweichung zu U</translation>
    </message>
    <message>
        <source>%1, differs</source>
        <translation>%1, weicht ab</translation>
    </message>
    <message>
        <source>not measured: %1</source>
        <translation>nicht gemessen: %1</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone.</source>
        <translation>Es ist keine Anlage vorhanden: die Assistenten sehen nur durch die virtuelle Anlage.</translation>
    </message>
</context>
<context>
    <name>vignole::ReplayCanvas</name>
    <message>
        <source>Profile of the stored rail</source>
        <translation>Messprofil der gespeicherten Schiene</translation>
    </message>
</context>
<context>
    <name>vignole::RigDrawing</name>
    <message>
        <source>The rig as it is calibrated</source>
        <translation>Die Anlage, wie sie kalibriert ist</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>Along the rail: fields of view on the light plane, distances</source>
        <translation>Entlang der Schiene: Sichtfelder auf der Lichtebene, Abstände</translation>
    </message>
    <message>
        <source>From the side: angles out of the light plane</source>
        <translation>Von der Seite: Winkel zur Lichtebene</translation>
    </message>
</context>
<context>
    <name>vignole::RigWizard</name>
    <message>
        <source>Cancelling…</source>
        <translation>Bricht ab…</translation>
    </message>
    <message>
        <source>Range finders</source>
        <translation>Lichtschnittsensoren</translation>
    </message>
    <message>
        <source>What it means</source>
        <translation>Was es bedeutet</translation>
    </message>
    <message>
        <source>Fit to the pins</source>
        <translation>Anpassung an Stifte</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Vorbereiten</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Rechnen</translation>
    </message>
    <message>
        <source>Pins found (Fig. 8d)</source>
        <translation>Gefundene Stifte (Abb. 8d)</translation>
    </message>
    <message>
        <source>circles: the pins as found; points: the lines of the first placement</source>
        <translation>Kreise: Stifte wie gefunden; Punkte: Linien der ersten Stellung</translation>
    </message>
    <message>
        <source>Pins in the world</source>
        <translation>Stifte im Raum</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Put in force</source>
        <translation>In Kraft setzen</translation>
    </message>
    <message>
        <source>How often the plate is put down: four find an error of the plate as well.</source>
        <translation>Wie oft die Platte gestellt wird: vier finden auch einen Fehler der Platte.</translation>
    </message>
    <message>
        <source>Number of placements</source>
        <translation>Anzahl der Stellungen</translation>
    </message>
    <message>
        <source>The virtual plate, for training</source>
        <translation>Die virtuelle Platte, zum Üben</translation>
    </message>
    <message>
        <source>is as its certificate says</source>
        <translation>entspricht ihrem Kalibrierschein</translation>
    </message>
    <message>
        <source>is the mirror image of its file</source>
        <translation>ist das Spiegelbild ihrer Datei</translation>
    </message>
    <message>
        <source>is not the one of the certificate</source>
        <translation>ist nicht die des Kalibrierscheins</translation>
    </message>
    <message>
        <source>has lost pin 4</source>
        <translation>hat Stift 4 verloren</translation>
    </message>
    <message>
        <source>Virtual plate</source>
        <translation>Virtuelle Platte</translation>
    </message>
    <message>
        <source>Plate to the right, mm</source>
        <translation>Platte nach rechts, mm</translation>
    </message>
    <message>
        <source>Plate up, mm</source>
        <translation>Platte nach oben, mm</translation>
    </message>
    <message>
        <source>Plate turned anticlockwise, degrees</source>
        <translation>Platte gegen den Uhrzeigersinn gedreht, Grad</translation>
    </message>
    <message>
        <source>Plate tilted out of the light, degrees</source>
        <translation>Platte aus der Lichtebene gekippt, Grad</translation>
    </message>
    <message>
        <source>tilt </source>
        <translation>Kipp. </translation>
    </message>
    <message>
        <source>Place as shown</source>
        <translation>So einsetzen</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Take again</source>
        <translation>Neu aufnehmen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>The plate stands where the rail passes, and the cameras are needed. Stop the line to go on; what has been taken so far is kept.</source>
        <translation>Die Platte steht, wo die Schiene durchläuft, und die Kameras werden gebraucht. Zum Fortfahren die Linie stoppen; was bisher aufgenommen ist, bleibt.</translation>
    </message>
    <message>
        <source>To be repeated after so many days (0: never)</source>
        <translation>Zu wiederholen nach so vielen Tagen (0: nie)</translation>
    </message>
    <message>
        <source>Days after which the calibration is to be repeated</source>
        <translation>Tage, nach denen die Kalibrierung zu wiederholen ist</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Reason for the new calibration</source>
        <translation>Grund der neuen Kalibrierung</translation>
    </message>
    <message>
        <source>Progress of the solution</source>
        <translation>Fortschritt der Rechnung</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Centre (CD)</source>
        <translation>Mitte (CD)</translation>
    </message>
    <message>
        <source>Radius (RD)</source>
        <translation>Radius (RD)</translation>
    </message>
    <message>
        <source>Points (PD)</source>
        <translation>Punkte (PD)</translation>
    </message>
    <message>
        <source>Table IV: fit to the pins</source>
        <translation>Tabelle IV: Anpassung an Stifte</translation>
    </message>
    <message>
        <source>Checks of the new calibration</source>
        <translation>Prüfungen der neuen Kalibrierung</translation>
    </message>
    <message>
        <source>Four cameras together…</source>
        <translation>Vier Kameras zusammen…</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Abgebrochen: nichts hat sich geändert.</translation>
    </message>
    <message>
        <source>%1 is in force: the line measures with it from the next rail on.</source>
        <translation>%1 ist in Kraft: ab der nächsten Schiene misst die Linie damit.</translation>
    </message>
    <message>
        <source>Report of the calibration</source>
        <translation>Bericht der Kalibrierung</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>turned and moved</source>
        <translation>gedreht und bewegt</translation>
    </message>
    <message>
        <source>turned 180°</source>
        <translation>180° gedreht</translation>
    </message>
    <message>
        <source>moved %1 mm</source>
        <translation>%1 mm bewegt</translation>
    </message>
    <message>
        <source>as drawn, 0°</source>
        <translation>gezeichnet, 0°</translation>
    </message>
    <message>
        <source>plate and cameras</source>
        <translation>Platte und Kameras</translation>
    </message>
    <message>
        <source>Placement %1</source>
        <translation>Stellung %1</translation>
    </message>
    <message>
        <source>four cameras together</source>
        <translation>vier Kameras zusammen</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>old and new</source>
        <translation>alt und neu</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>reason and signature</source>
        <translation>Grund und Unterschrift</translation>
    </message>
    <message>
        <source>placement %1 of %2</source>
        <translation>Stellung %1 von %2</translation>
    </message>
    <message>
        <source>U (k = 2) in %1</source>
        <translation>U (k = 2) in %1</translation>
    </message>
    <message>
        <source>mean / max in %1</source>
        <translation>Mittel / Max in %1</translation>
    </message>
    <message>
        <source>Plate, %1</source>
        <translation>Platte, %1</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>%1, U = 3 µm, pins towards the cameras</source>
        <translation>%1, U = 3 µm, Stifte zu den Kameras</translation>
    </message>
    <message>
        <source>Camera %1: lens as calibrated in this session</source>
        <translation>Kamera %1: Objektiv wie in dieser Sitzung kalibriert</translation>
    </message>
    <message>
        <source>Camera %1: lens of the calibration in force</source>
        <translation>Kamera %1: Objektiv der gültigen Kalibrierung</translation>
    </message>
    <message>
        <source>The plate with 13 pins is put into the gauge where the rail passes, pins towards the cameras, and turned and moved between the pictures. Nothing is applied before old and new have been compared and you confirm.

%1</source>
        <translation>Die Platte mit 13 Stiften wird dort in die Messanlage gesetzt, wo die Schiene durchläuft, Stifte zu den Kameras, und zwischen den Bildern gedreht und bewegt. Nichts wird angewendet, bevor alt und neu verglichen sind und Sie bestätigen.

%1</translation>
    </message>
    <message>
        <source>%1 takes the place of %2 from the next rail on. Both are kept and can be compared and put back.</source>
        <translation>%1 tritt ab der nächsten Schiene an die Stelle von %2. Beide bleiben aufbewahrt, lassen sich vergleichen und zurückholen.</translation>
    </message>
    <message>
        <source>could not be asked</source>
        <translation>nicht prüfbar</translation>
    </message>
    <message>
        <source>%1, within %2</source>
        <translation>%1, innerhalb %2</translation>
    </message>
    <message>
        <source>%1, above %2</source>
        <translation>%1, über %2</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>%1 nach rechts</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 nach links</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>%1 nach oben</translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation>%1 nach unten</translation>
    </message>
    <message>
        <source>turned by %1° anticlockwise</source>
        <translation>um %1° gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>turned by %1° clockwise</source>
        <translation>um %1° im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Next: move the plate to the dashed outlines: %1.</source>
        <translation>Weiter: Platte zu den gestrichelten Umrissen bewegen: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Next: put the plate into the gauge.</source>
        <translation>Weiter: Platte in die Messanlage setzen.</translation>
    </message>
    <message>
        <source>First placement</source>
        <translation>Erste Stellung</translation>
    </message>
    <message>
        <source>Next placement</source>
        <translation>Nächste Stellung</translation>
    </message>
    <message>
        <source>Looking at the plate…</source>
        <translation>Prüft die Platte…</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>Kamera %1: %2</translation>
    </message>
    <message>
        <source>%1 of %2 pins found</source>
        <translation>%1 von %2 Stiften gefunden</translation>
    </message>
    <message numerus="yes">
        <source>, %n picture(s) refused</source>
        <translation>
            <numerusform>, %n Bild abgelehnt</numerusform>
            <numerusform>, %n Bilder abgelehnt</numerusform>
        </translation>
    </message>
    <message>
        <source>All four cameras see the plate where it must lie. Next: “%1”.</source>
        <translation>Alle vier Kameras sehen die Platte, wo sie stehen muss. Weiter: „%1“.</translation>
    </message>
    <message>
        <source>The poses of four cameras are found together with the pins.</source>
        <translation>Die Lagen der vier Kameras werden zusammen mit den Stiften bestimmt.</translation>
    </message>
    <message>
        <source>Next: nothing to do; the comparison comes by itself.</source>
        <translation>Weiter: nichts zu tun; der Vergleich kommt von selbst.</translation>
    </message>
    <message>
        <source>Refused: it cannot be put in force.</source>
        <translation>Abgelehnt: kann nicht in Kraft gesetzt werden.</translation>
    </message>
    <message>
        <source>May be used: every check is within its limit.</source>
        <translation>Verwendbar: jede Prüfung liegt innerhalb ihrer Grenze.</translation>
    </message>
    <message numerus="yes">
        <source>May be used, but %n dimension(s) get more than is allowed.</source>
        <translation>
            <numerusform>Verwendbar, aber %n Maß erhält mehr als zulässig.</numerusform>
            <numerusform>Verwendbar, aber %n Maße erhalten mehr als zulässig.</numerusform>
        </translation>
    </message>
    <message>
        <source>Next: compare old and new on the right. Nothing is applied before you confirm.</source>
        <translation>Weiter: rechts alt und neu vergleichen. Nichts wird angewendet, bevor Sie bestätigen.</translation>
    </message>
    <message>
        <source>Done. Next: start the line and watch the first rail.</source>
        <translation>Fertig. Weiter: Linie starten und die erste Schiene beobachten.</translation>
    </message>
    <message>
        <source>Next: give the reason and put it in force.</source>
        <translation>Weiter: Grund angeben und in Kraft setzen.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone. Start the program on the virtual rig.</source>
        <translation>Es ist keine Anlage vorhanden: die Assistenten sehen nur durch die virtuelle Anlage. Programm mit der virtuellen Anlage starten.</translation>
    </message>
</context>
<context>
    <name>vignole::SectionDialog</name>
    <message>
        <source>Drawing of a section</source>
        <translation>Zeichnung eines Profils</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Section with its primitives named</source>
        <translation>Profil mit benannten Elementen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Länge, mm</translation>
    </message>
    <message>
        <source>Radius, mm</source>
        <translation>Radius, mm</translation>
    </message>
    <message>
        <source>Primitives of the section</source>
        <translation>Elemente des Profils</translation>
    </message>
    <message>
        <source>Name of the section</source>
        <translation>Name des Profils</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Profile and straightness class of its recipe</source>
        <translation>Profil- und Geradheitsklasse seines Rezepts</translation>
    </message>
    <message>
        <source>Open a drawing…</source>
        <translation>Zeichnung öffnen…</translation>
    </message>
    <message>
        <source>Open a drawing of a section</source>
        <translation>Zeichnung eines Profils öffnen</translation>
    </message>
    <message>
        <source>Make a draft of it</source>
        <translation>Entwurf daraus machen</translation>
    </message>
    <message>
        <source>Keep the section and make a draft of it</source>
        <translation>Profil aufbewahren und einen Entwurf daraus machen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>There is nothing in this file that could be drawn.</source>
        <translation>In dieser Datei ist nichts, das sich zeichnen ließe.</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Abgelehnt: %1</translation>
    </message>
    <message>
        <source>QA makes drafts: sign in.</source>
        <translation>Entwürfe macht die Qualität: anmelden.</translation>
    </message>
    <message>
        <source>Open a drawing: one closed outline of lines and arcs, the rail upright.</source>
        <translation>Eine Zeichnung öffnen: ein geschlossener Umriss aus Strecken und Bögen, die Schiene aufrecht.</translation>
    </message>
    <message>
        <source>DXF, JSON or a MiniProf design</source>
        <translation>DXF, JSON oder MiniProf-Design</translation>
    </message>
    <message numerus="yes">
        <source>%1 mm high, %2 cm², %3 kg/m, %4; %n primitive(s)</source>
        <translation>
            <numerusform>%1 mm hoch, %2 cm², %3 kg/m, %4; %n Element</numerusform>
            <numerusform>%1 mm hoch, %2 cm², %3 kg/m, %4; %n Elemente</numerusform>
        </translation>
    </message>
    <message>
        <source>symmetric</source>
        <translation>symmetrisch</translation>
    </message>
    <message>
        <source>asymmetric</source>
        <translation>asymmetrisch</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>segment</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>A name has letters, digits, spaces, dots and hyphens: it becomes the name of a file.</source>
        <translation>Ein Name hat Buchstaben, Ziffern, Leerzeichen, Punkte und Bindestriche: er wird zum Namen einer Datei.</translation>
    </message>
    <message>
        <source>%1 is a section of the catalogue: give yours another name.</source>
        <translation>%1 ist ein Profil des Katalogs: Ihrem bitte einen anderen Namen geben.</translation>
    </message>
    <message>
        <source>There is another section of the name %1: give a new name.</source>
        <translation>Es gibt ein anderes Profil mit dem Namen %1: einen neuen Namen geben.</translation>
    </message>
</context>
<context>
    <name>vignole::SectionDrawing</name>
    <message>
        <source>free end</source>
        <translation>freies Ende</translation>
    </message>
    <message>
        <source>open here: %1 mm</source>
        <translation>hier offen: %1 mm</translation>
    </message>
</context>
<context>
    <name>vignole::SettingsPage</name>
    <message>
        <source>Screen</source>
        <translation>Bildschirm</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thema</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>Unit of lengths</source>
        <translation>Längeneinheit</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Über</translation>
    </message>
    <message>
        <source>Vignole %1: rail profiles in millimetres, with their uncertainty. Licence GPL-3.0-or-later.</source>
        <translation>Vignole %1: Schienenprofile in Millimetern, mit ihrer Unsicherheit. Lizenz GPL-3.0-or-later.</translation>
    </message>
    <message>
        <source>There is none: %1. Rails are measured and not kept. Start the program with --archive FILE.</source>
        <translation>Es gibt keines: %1. Schienen werden gemessen und nicht aufbewahrt. Programm mit --archive FILE starten.</translation>
    </message>
    <message>
        <source>%1
%2 rails are kept.</source>
        <translation>%1
%2 Schienen sind aufbewahrt.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Language of the screen</source>
        <translation>Sprache des Bildschirms</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>Gruppen der Optionen</translation>
    </message>
    <message>
        <source>Who is here</source>
        <translation>Wer hier ist</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>Prüfpfad</translation>
    </message>
    <message>
        <source>of this machine; kept for the next start</source>
        <translation>dieses Rechners; bleibt für den nächsten Start</translation>
    </message>
    <message>
        <source>Show the tour</source>
        <translation>Rundgang zeigen</translation>
    </message>
    <message>
        <source>Show the tour of Monitor</source>
        <translation>Rundgang durch den Monitor zeigen</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Anlage</translation>
    </message>
    <message>
        <source>drawn from the calibration in force</source>
        <translation>nach der gültigen Kalibrierung gezeichnet</translation>
    </message>
    <message>
        <source>This line does not tell its calibration.</source>
        <translation>Diese Linie nennt ihre Kalibrierung nicht.</translation>
    </message>
    <message>
        <source>Calibration %1. The rail stands where it was seen last.</source>
        <translation>Kalibrierung %1. Die Schiene steht, wo sie zuletzt gesehen wurde.</translation>
    </message>
    <message>
        <source>Calibration %1. No rail has been seen yet.</source>
        <translation>Kalibrierung %1. Noch wurde keine Schiene gesehen.</translation>
    </message>
    <message>
        <source>No site is configured: the four cameras are those of the virtual rig, and every page says SIMULATION. Cameras are measured with on the command line: vignole-cli inspect --source gige.</source>
        <translation>Es ist kein Standort eingerichtet: die vier Kameras sind die der virtuellen Anlage, und jede Seite sagt SIMULATION. Mit Kameras misst die Befehlszeile: vignole-cli inspect --source gige.</translation>
    </message>
</context>
<context>
    <name>vignole::SignInPanel</name>
    <message>
        <source>Who is here</source>
        <translation>Wer hier ist</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation>Abmelden</translation>
    </message>
    <message>
        <source>Enter as the first administrator</source>
        <translation>Als erster Administrator eintragen</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Nobody can sign in: people are kept in the archive, and there is none (%1).</source>
        <translation>Niemand kann sich anmelden: Personen stehen im Archiv, und es gibt keines (%1).</translation>
    </message>
    <message>
        <source>After a quarter of an hour without a key or a touch it is the operator&apos;s screen again.</source>
        <translation>Nach einer Viertelstunde ohne Taste oder Berührung ist es wieder der Bildschirm des Bedieners.</translation>
    </message>
    <message>
        <source>Nobody is entered yet. The first one is the administrator and enters the others; the password has at least 8 characters.</source>
        <translation>Noch ist niemand eingetragen. Der Erste ist Administrator und trägt die anderen ein; das Passwort hat mindestens 8 Zeichen.</translation>
    </message>
    <message>
        <source>Without signing in this is the operator&apos;s screen: it measures, shows and acknowledges.</source>
        <translation>Ohne Anmeldung ist dies der Bildschirm des Bedieners: er misst, zeigt und quittiert.</translation>
    </message>
    <message>
        <source>Name and password are both needed.</source>
        <translation>Name und Passwort sind beide nötig.</translation>
    </message>
    <message>
        <source>Name or password is wrong.</source>
        <translation>Name oder Passwort ist falsch.</translation>
    </message>
    <message>
        <source>This account is closed; ask the administrator.</source>
        <translation>Dieses Konto ist gesperrt; bitte den Administrator fragen.</translation>
    </message>
    <message>
        <source>Too many wrong passwords: locked until %1.</source>
        <translation>Zu viele falsche Passwörter: gesperrt bis %1.</translation>
    </message>
    <message>
        <source>New password, at least 8 characters</source>
        <translation>Neues Passwort, mindestens 8 Zeichen</translation>
    </message>
    <message>
        <source>New password</source>
        <translation>Neues Passwort</translation>
    </message>
    <message>
        <source>Change the password</source>
        <translation>Passwort ändern</translation>
    </message>
    <message>
        <source>Present password</source>
        <translation>Jetziges Passwort</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>This password was given by somebody else: choose one of your own.</source>
        <translation>Dieses Passwort hat jemand anderes vergeben: bitte ein eigenes wählen.</translation>
    </message>
    <message>
        <source>The password is changed.</source>
        <translation>Das Passwort ist geändert.</translation>
    </message>
    <message>
        <source>The password is changed: sign in with it.</source>
        <translation>Das Passwort ist geändert: damit anmelden.</translation>
    </message>
</context>
<context>
    <name>vignole::StepList</name>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Schritt %1 von %2: %3</translation>
    </message>
</context>
<context>
    <name>vignole::StripChart</name>
    <message>
        <source>%1 along the rail: %2</source>
        <translation>%1 entlang der Schiene: %2</translation>
    </message>
</context>
<context>
    <name>vignole::StripeView</name>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>brightness along the line</source>
        <translation>Helligkeit entlang der Linie</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Saturated</source>
        <translation>Übersteuert</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>trigger %1</source>
        <translation>Trigger %1</translation>
    </message>
    <message>
        <source>no picture yet</source>
        <translation>noch kein Bild</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>oben links</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>oben rechts</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>unten rechts</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>unten links</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
</context>
<context>
    <name>vignole::StripesPage</name>
    <message>
        <source>What is tried acts on these pictures alone until it is applied.</source>
        <translation>Was erprobt wird, wirkt nur auf diese Bilder, bis es angewendet wird.</translation>
    </message>
    <message>
        <source>Anybody may try; a technician who has signed in applies.</source>
        <translation>Erproben darf jeder; ein angemeldeter Techniker wendet an.</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>Eingefroren</translation>
    </message>
    <message>
        <source>This source hands out no pictures.</source>
        <translation>Diese Quelle gibt keine Bilder heraus.</translation>
    </message>
    <message>
        <source>Nothing is on trial: change a parameter first.</source>
        <translation>Nichts auf Probe: zuerst einen Parameter ändern.</translation>
    </message>
    <message>
        <source>A change of the measurement needs a reason.</source>
        <translation>Eine Änderung der Messung braucht einen Grund.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild sichern</translation>
    </message>
    <message>
        <source>Lost: %1</source>
        <translation>Verloren: %1</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Gehalten</translation>
    </message>
    <message>
        <source>The line has not been started (Ctrl+R).</source>
        <translation>Die Linie ist nicht gestartet (Strg+R).</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>%1 alt</translation>
    </message>
    <message numerus="yes">
        <source>The picture is no longer held: the last %n are.</source>
        <translation>
            <numerusform>Das Bild wird nicht mehr gehalten: nur das letzte (%n).</numerusform>
            <numerusform>Das Bild wird nicht mehr gehalten: nur die letzten %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>No picture: %1</source>
        <translation>Kein Bild: %1</translation>
    </message>
    <message>
        <source>Pictures behind the profile at %1 m.</source>
        <translation>Bilder hinter dem Messprofil bei %1 m.</translation>
    </message>
    <message>
        <source>Waits for the next rail; the running rail keeps what it began with.</source>
        <translation>Wartet auf die nächste Schiene; die laufende behält, womit sie begann.</translation>
    </message>
    <message>
        <source>There is no archive, so the change could not be recorded: nothing was changed.</source>
        <translation>Es gibt kein Archiv, die Änderung ließe sich nicht aufzeichnen: nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The change is being recorded…</source>
        <translation>Die Änderung wird aufgezeichnet…</translation>
    </message>
    <message>
        <source>Nothing was changed, because it could not be recorded: %1</source>
        <translation>Nichts wurde geändert, weil es nicht aufgezeichnet werden konnte: %1</translation>
    </message>
    <message>
        <source>Recorded. The exposure changes with the next start of the line, the parameters with the next rail.</source>
        <translation>Aufgezeichnet. Die Belichtung ändert sich mit dem nächsten Start der Linie, die Parameter mit der nächsten Schiene.</translation>
    </message>
    <message>
        <source>Recorded. Waits for the next rail; the running rail keeps what it began with.</source>
        <translation>Aufgezeichnet. Wartet auf die nächste Schiene; die laufende behält, womit sie begann.</translation>
    </message>
    <message>
        <source>Camera %1 has no picture to save.</source>
        <translation>Kamera %1 hat kein Bild zum Sichern.</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>Sichert %1…</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 kann nicht geschrieben werden: %2</translation>
    </message>
</context>
<context>
    <name>vignole::StudyPanel</name>
    <message>
        <source>Parameter study</source>
        <translation>Parameterstudie</translation>
    </message>
    <message>
        <source>Main effects</source>
        <translation>Haupteffekte</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Settings and their levels</source>
        <translation>Einstellungen und ihre Stufen</translation>
    </message>
    <message>
        <source>Influence of each setting</source>
        <translation>Einfluss jeder Einstellung</translation>
    </message>
    <message>
        <source>Placements of the plate</source>
        <translation>Stellungen der Platte</translation>
    </message>
    <message>
        <source>Placements of the plate for the study</source>
        <translation>Stellungen der Platte für die Studie</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Fortschritt der Studie</translation>
    </message>
    <message>
        <source>Start the study</source>
        <translation>Studie starten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Linie stoppen</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>settings and levels</source>
        <translation>Einstellungen und Stufen</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Abgebrochen: nichts hat sich geändert.</translation>
    </message>
    <message>
        <source>Report of the study</source>
        <translation>Bericht der Studie</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Closed while the line measures: the plate stands where the rail passes. Stop the line to go on.</source>
        <translation>Gesperrt, solange die Linie misst: die Platte steht, wo die Schiene durchläuft. Zum Fortfahren die Linie stoppen.</translation>
    </message>
    <message>
        <source>Every combination of the levels is a calibration by the paper&apos;s method on pictures of the plate. Levels are parted by commas; one level or none: the setting is not varied.</source>
        <translation>Jede Kombination der Stufen ist eine Kalibrierung nach der Methode des Aufsatzes an Bildern der Platte. Stufen werden durch Kommas getrennt; eine oder keine Stufe: die Einstellung wird nicht verändert.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Rechnet…</translation>
    </message>
    <message>
        <source>Next: choose levels and start.</source>
        <translation>Weiter: Stufen wählen und starten.</translation>
    </message>
    <message>
        <source>Exposure, ms</source>
        <translation>Belichtung, ms</translation>
    </message>
    <message>
        <source>Smoothing σ, px</source>
        <translation>Glättung σ, px</translation>
    </message>
    <message>
        <source>Ellipses a pin</source>
        <translation>Ellipsen je Stift</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ausgleich</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone.</source>
        <translation>Es ist keine Anlage vorhanden: die Assistenten sehen nur durch die virtuelle Anlage.</translation>
    </message>
</context>
<context>
    <name>vignole::SupportBundle</name>
    <message>
        <source>is there already</source>
        <translation>ist schon vorhanden</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>cancelled: nothing is left of it</source>
        <translation>abgebrochen: nichts bleibt davon</translation>
    </message>
</context>
<context>
    <name>vignole::TolerancePlot</name>
    <message>
        <source>lower limit %1</source>
        <translation>untere Grenze %1</translation>
    </message>
    <message>
        <source>upper limit %1</source>
        <translation>obere Grenze %1</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>Sollwert %1</translation>
    </message>
</context>
<context>
    <name>vignole::Tour</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
    <message>
        <source>Close the tour</source>
        <translation>Rundgang schließen</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
</context>
<context>
    <name>vignole::TrialPanel</name>
    <message>
        <source>Line extraction</source>
        <translation>Linienextraktion</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Low threshold</source>
        <translation>Untere Schwelle</translation>
    </message>
    <message>
        <source>High threshold</source>
        <translation>Obere Schwelle</translation>
    </message>
    <message>
        <source>Link distance</source>
        <translation>Koppelabstand</translation>
    </message>
    <message>
        <source>Link angle</source>
        <translation>Koppelwinkel</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>In Gebrauch</translation>
    </message>
    <message>
        <source>On trial</source>
        <translation>Auf Probe</translation>
    </message>
    <message>
        <source>%1 on trial</source>
        <translation>%1 auf Probe</translation>
    </message>
    <message>
        <source>%1: less</source>
        <translation>%1: weniger</translation>
    </message>
    <message>
        <source>%1: more</source>
        <translation>%1: mehr</translation>
    </message>
    <message>
        <source>Choose camera %1</source>
        <translation>Kamera %1 wählen</translation>
    </message>
    <message>
        <source>Pixels with the line in use</source>
        <translation>Pixel mit der Linie in Gebrauch</translation>
    </message>
    <message>
        <source>Pixels with the line on trial</source>
        <translation>Pixel mit der Linie auf Probe</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>In use against on trial</source>
        <translation>In Gebrauch gegen Probe</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Gained, lost</source>
        <translation>Neu, verloren</translation>
    </message>
    <message>
        <source>Saturated points</source>
        <translation>Übersteuerte Punkte</translation>
    </message>
    <message>
        <source>Uncertainty, px</source>
        <translation>Unsicherheit, px</translation>
    </message>
    <message>
        <source>Shift: mean, largest, px</source>
        <translation>Versatz: Mittel, größter, px</translation>
    </message>
    <message>
        <source>Time, ms</source>
        <translation>Zeit, ms</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>Save the picture of the chosen camera (Ctrl+S)</source>
        <translation>Bild der gewählten Kamera sichern (Strg+S)</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Einfrieren</translation>
    </message>
    <message>
        <source>Live pictures again (P)</source>
        <translation>Wieder Live-Bilder (P)</translation>
    </message>
    <message>
        <source>Freeze the pictures (P)</source>
        <translation>Bilder einfrieren (P)</translation>
    </message>
    <message>
        <source>Freeze the pictures</source>
        <translation>Bilder einfrieren</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Messprofil</translation>
    </message>
    <message>
        <source>The pictures behind the newest profile (B)</source>
        <translation>Die Bilder hinter dem neuesten Messprofil (B)</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Discard what is on trial</source>
        <translation>Probe verwerfen</translation>
    </message>
    <message>
        <source>Use from next rail</source>
        <translation>Ab nächster Schiene</translation>
    </message>
    <message>
        <source>Use what is on trial from the next rail on</source>
        <translation>Probe ab der nächsten Schiene verwenden</translation>
    </message>
    <message>
        <source>Reason for the change</source>
        <translation>Grund der Änderung</translation>
    </message>
    <message>
        <source>These cameras&apos; exposure cannot be changed from here.</source>
        <translation>Die Belichtung dieser Kameras lässt sich von hier nicht ändern.</translation>
    </message>
    <message>
        <source>camera %1, frozen</source>
        <translation>Kamera %1, eingefroren</translation>
    </message>
    <message>
        <source>camera %1, live</source>
        <translation>Kamera %1, live</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>kein Bild</translation>
    </message>
    <message>
        <source>nothing on trial: change a parameter</source>
        <translation>nichts auf Probe: einen Parameter ändern</translation>
    </message>
</context>
<context>
    <name>vignole::VerdictPanel</name>
    <message>
        <source>Verdict: %1, %2. Gauge: %3</source>
        <translation>Urteil: %1, %2. Messanlage: %3</translation>
    </message>
    <message>
        <source>Gauge: %1</source>
        <translation>Messanlage: %1</translation>
    </message>
    <message>
        <source>SIMULATION, %1</source>
        <translation>SIMULATION, %1</translation>
    </message>
</context>
<context>
    <name>vignole::WhatIfDialog</name>
    <message>
        <source>What if</source>
        <translation>Was wäre wenn</translation>
    </message>
    <message>
        <source>The rails that were found are judged again with other limits, from what is stored of every profile. Nothing that is stored changes.</source>
        <translation>Die gefundenen Schienen werden mit anderen Grenzen neu beurteilt, aus dem, was von jedem Messprofil gespeichert ist. Gespeichertes ändert sich nicht.</translation>
    </message>
    <message>
        <source>Profile class</source>
        <translation>Profilklasse</translation>
    </message>
    <message>
        <source>Straightness class</source>
        <translation>Geradheitsklasse</translation>
    </message>
    <message>
        <source>As in the recipe</source>
        <translation>Wie im Rezept</translation>
    </message>
    <message>
        <source>lower, %1</source>
        <translation>untere, %1</translation>
    </message>
    <message>
        <source>upper, %1</source>
        <translation>obere, %1</translation>
    </message>
    <message>
        <source>Lower limit of %1, deviation</source>
        <translation>Untere Grenze von %1, Abweichung</translation>
    </message>
    <message>
        <source>Upper limit of %1, deviation</source>
        <translation>Obere Grenze von %1, Abweichung</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Schiene</translation>
    </message>
    <message>
        <source>Was</source>
        <translation>War</translation>
    </message>
    <message>
        <source>Would be</source>
        <translation>Wäre</translation>
    </message>
    <message>
        <source>Because of</source>
        <translation>Wegen</translation>
    </message>
    <message>
        <source>Rails whose verdict would change</source>
        <translation>Schienen, deren Urteil sich änderte</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>A limit of %1 is no number. An empty field is no limit.</source>
        <translation>Eine Grenze von %1 ist keine Zahl. Ein leeres Feld ist keine Grenze.</translation>
    </message>
    <message>
        <source>The lower limit of %1 is above the upper one: exchange them.</source>
        <translation>Die untere Grenze von %1 liegt über der oberen: bitte tauschen.</translation>
    </message>
    <message>
        <source>%1 of %2 rails judged</source>
        <translation>%1 von %2 Schienen beurteilt</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Erproben</translation>
    </message>
    <message>
        <source>Stop judging</source>
        <translation>Beurteilung stoppen</translation>
    </message>
    <message>
        <source>Judge the rails with these limits</source>
        <translation>Schienen mit diesen Grenzen beurteilen</translation>
    </message>
    <message>
        <source>No rail of this section is in the list. Search for rails first.</source>
        <translation>Keine Schiene dieses Profils in der Liste. Zuerst Schienen suchen.</translation>
    </message>
    <message>
        <source>Judging …</source>
        <translation>Beurteilt …</translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s) of section %1</source>
        <translation>
            <numerusform>%n Schiene des Profils %1</numerusform>
            <numerusform>%n Schienen des Profils %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Fewer than %1 rails prove little.</source>
        <translation>Weniger als %1 Schienen beweisen wenig.</translation>
    </message>
    <message>
        <source>Choose a class or enter deviations from nominal, then Try. Empty: no limit.</source>
        <translation>Klasse wählen oder Abweichungen vom Nennmaß eingeben, dann Erproben. Leer: keine Grenze.</translation>
    </message>
    <message>
        <source>%1 of %2 rails would change their verdict</source>
        <translation>%1 von %2 Schienen änderten ihr Urteil</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 von %2 zu %3</translation>
    </message>
    <message>
        <source>stopped before all %1 were judged</source>
        <translation>gestoppt, bevor alle %1 beurteilt waren</translation>
    </message>
    <message numerus="yes">
        <source>%n could not be judged: %1</source>
        <translation>
            <numerusform>%n konnte nicht beurteilt werden: %1</numerusform>
            <numerusform>%n konnten nicht beurteilt werden: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>fewer than %1 rails prove little</source>
        <translation>weniger als %1 Schienen beweisen wenig</translation>
    </message>
</context>
<context>
    <name>vignole::WorthTable</name>
    <message>
        <source>Dimension</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>In force</source>
        <translation>Gültig</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>Zulässig</translation>
    </message>
    <message>
        <source>Largest part</source>
        <translation>Größter Anteil</translation>
    </message>
    <message>
        <source>What the calibration is worth for each dimension</source>
        <translation>Was die Kalibrierung für jedes Maß wert ist</translation>
    </message>
    <message>
        <source>More than the tolerance allows</source>
        <translation>Mehr, als die Toleranz erlaubt</translation>
    </message>
    <message>
        <source>too much: %1</source>
        <translation>zu viel: %1</translation>
    </message>
</context>
</TS>
