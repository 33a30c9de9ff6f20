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
        <source>Smallest, largest</source>
        <translation>Kleinster, größter</translation>
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
        <source>Support file…</source>
        <translation>Supportdatei…</translation>
    </message>
    <message>
        <source>Save a support file</source>
        <translation>Supportdatei sichern</translation>
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
        <source>Rendered cameras: no packets to be sent again, no temperature.</source>
        <translation>Gerechnete Kameras: keine Paketwiederholungen, keine Temperatur.</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Festplatte</translation>
    </message>
    <message>
        <source>%1 of %2 GB free</source>
        <translation>%1 von %2 GB frei</translation>
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
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>none: rails are not kept</source>
        <translation>keines: Schienen werden nicht aufbewahrt</translation>
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
        <source>turn p99 %1 ms</source>
        <translation>Umlauf p99 %1 ms</translation>
    </message>
    <message>
        <source>p50 %1, largest %2, limit 50 ms</source>
        <translation>p50 %1, größter %2, Grenze 50 ms</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Bildschirm</translation>
    </message>
    <message>
        <source>the window&apos;s thread</source>
        <translation>der Thread des Fensters</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 kann nicht geschrieben werden: %2</translation>
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
        <source>mean time of a stage, SD standard deviation, UCL upper limit of the 99 % confidence interval; of a queue now (dark), highest fill (mark) and size</source>
        <translation>mittlere Zeit einer Stufe, SD Standardabweichung, OKG obere Grenze des 99-%-Vertrauensbereichs; einer Warteschlange: jetzt (dunkel), höchste Füllung (Marke) und Größe</translation>
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
        <source>Rails that may be laid over each other</source>
        <translation>Schienen, die übereinandergelegt werden können</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Maß</translation>
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
        <source>Export values and ranges as CSV</source>
        <translation>Werte und Spannweiten als CSV exportieren</translation>
    </message>
    <message>
        <source>Values over the length</source>
        <translation>Werte über der Länge</translation>
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
        <source>as Fig. 9b</source>
        <translation>wie Abb. 9b</translation>
    </message>
    <message>
        <source>Values of every run over the length</source>
        <translation>Werte jedes Laufs über der Länge</translation>
    </message>
    <message>
        <source>Range of the runs over the length</source>
        <translation>Spannweite der Läufe über der Länge</translation>
    </message>
    <message>
        <source>Mean range</source>
        <translation>Mittlere Spannweite</translation>
    </message>
    <message>
        <source>per 10 m, as Table VI</source>
        <translation>je 10 m, wie Tab. VI</translation>
    </message>
    <message>
        <source>From – to, m</source>
        <translation>Von – bis, m</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Stellen</translation>
    </message>
    <message>
        <source>Mean range, section by section</source>
        <translation>Mittlere Spannweite, Abschnitt für Abschnitt</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>Figures of the study</source>
        <translation>Kennwerte der Studie</translation>
    </message>
    <message>
        <source>Runs come from the archive, and there is none: %1. Start the program with --archive FILE.</source>
        <translation>Läufe kommen aus dem Archiv, und es gibt keines: %1. Programm mit --archive FILE starten.</translation>
    </message>
    <message>
        <source>At least 2 runs of the same rail are needed, %1 chosen; the paper took 5.</source>
        <translation>Mindestens 2 Läufe derselben Schiene sind nötig, %1 gewählt; im Aufsatz waren es 5.</translation>
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
        <source>Tick the runs that were made of the same rail, choose a dimension and compare.</source>
        <translation>Läufe derselben Schiene ankreuzen, ein Maß wählen und vergleichen.</translation>
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
        <source>Runs, positions</source>
        <translation>Läufe, Stellen</translation>
    </message>
    <message>
        <source>Repeatability s_r</source>
        <translation>Wiederholbarkeit s_r</translation>
    </message>
    <message>
        <source>its 95 % interval</source>
        <translation>ihr 95-%-Bereich</translation>
    </message>
    <message>
        <source>Limit r = 2.8 s_r</source>
        <translation>Grenze r = 2,8 s_r</translation>
    </message>
    <message>
        <source>Largest range</source>
        <translation>Größte Spannweite</translation>
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
        <source>%1, critical %2 (1 %)</source>
        <translation>%1, kritisch %2 (1 %)</translation>
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
        <source>, %1 positions left out: a run lacks them</source>
        <translation>, %1 Stellen ausgelassen: sie fehlen in einem Lauf</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Als CSV exportieren</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 ist geschrieben</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 kann nicht geschrieben werden</translation>
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
        <source>inside</source>
        <translation>innerhalb</translation>
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
        <source>kept: %1 rails, %2 profiles waiting</source>
        <translation>aufbewahrt: %1 Schienen, %2 Messprofile warten</translation>
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
</context>
<context>
    <name>vignole::ReplayCanvas</name>
    <message>
        <source>Profile of the stored rail</source>
        <translation>Messprofil der gespeicherten Schiene</translation>
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
        <source>No site is configured: the four cameras are those of the virtual rig, and every page says SIMULATION. Cameras with GigE Vision are not part of this version.</source>
        <translation>Es ist kein Standort eingerichtet: die vier Kameras sind die der virtuellen Anlage, und jede Seite sagt SIMULATION. Kameras mit GigE Vision gehören nicht zu dieser Version.</translation>
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
</context>
<context>
    <name>vignole::StripesPage</name>
    <message>
        <source>Line extraction</source>
        <translation>Linienextraktion</translation>
    </message>
    <message>
        <source>Smoothing σ</source>
        <translation>Glättung σ</translation>
    </message>
    <message>
        <source>Low threshold t_l</source>
        <translation>Untere Schwelle t_l</translation>
    </message>
    <message>
        <source>High threshold t_h</source>
        <translation>Obere Schwelle t_h</translation>
    </message>
    <message>
        <source>Link distance d</source>
        <translation>Verknüpfungsabstand d</translation>
    </message>
    <message>
        <source>Link angle α</source>
        <translation>Verknüpfungswinkel α</translation>
    </message>
    <message>
        <source>%1 on trial</source>
        <translation>%1 auf Probe</translation>
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
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>In use against on trial</source>
        <translation>In Gebrauch gegen Probe</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Bild sichern…</translation>
    </message>
    <message>
        <source>Save the picture of the chosen camera</source>
        <translation>Bild der gewählten Kamera sichern</translation>
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
        <source>Use from next start</source>
        <translation>Ab nächstem Start nutzen</translation>
    </message>
    <message>
        <source>Use what is on trial from the next start of the line</source>
        <translation>Probe ab dem nächsten Start der Linie verwenden</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Reason for the change</source>
        <translation>Grund der Änderung</translation>
    </message>
    <message>
        <source>Live again</source>
        <translation>Wieder live</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Einfrieren</translation>
    </message>
    <message>
        <source>Freeze the pictures</source>
        <translation>Bilder einfrieren</translation>
    </message>
    <message>
        <source>Freeze the pictures (P)</source>
        <translation>Bilder einfrieren (P)</translation>
    </message>
    <message>
        <source>What is tried acts on these pictures alone until it is applied.</source>
        <translation>Was erprobt wird, wirkt nur auf diese Bilder, bis es angewendet wird.</translation>
    </message>
    <message>
        <source>Anybody may try; a technician who has signed in applies.</source>
        <translation>Erproben darf jeder; ein angemeldeter Techniker wendet an.</translation>
    </message>
    <message>
        <source>lost: %1</source>
        <translation>ausgefallen: %1</translation>
    </message>
    <message>
        <source>held, %1 old</source>
        <translation>gehalten, %1 alt</translation>
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
        <source>Is used from the next start of the line (Ctrl+R stops and starts it); the running rail keeps what it began with.</source>
        <translation>Gilt ab dem nächsten Start der Linie (Strg+R hält an und startet); die laufende Schiene behält, womit sie begann.</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Saturated, %</source>
        <translation>Übersteuert, %</translation>
    </message>
    <message>
        <source>Uncertainty, px</source>
        <translation>Unsicherheit, px</translation>
    </message>
    <message>
        <source>Time, ms</source>
        <translation>Zeit, ms</translation>
    </message>
    <message>
        <source>Mean shift, px</source>
        <translation>Mittlere Verschiebung, px</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild sichern</translation>
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
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
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
</TS>
