<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pl_PL" sourcelanguage="en">
<context>
    <name>AlarmRule</name>
    <message>
        <source>A camera does not answer while a rail passes.</source>
        <translation>Kamera nie odpowiada podczas przejazdu szyny.</translation>
    </message>
    <message>
        <source>Its quarter of the profile is missing; rails pass unmeasured.</source>
        <translation>Brakuje jej ćwiartki przekroju; szyny przejeżdżają bez pomiaru.</translation>
    </message>
    <message>
        <source>Check power and network cable of the camera, then Diagnostics; stop the line if it does not come back.</source>
        <translation>Sprawdzić zasilanie i kabel sieciowy kamery, potem Diagnostykę; jeśli nie wróci, zatrzymać linię.</translation>
    </message>
    <message>
        <source>Too many triggers give no complete profile.</source>
        <translation>Zbyt wiele wyzwoleń nie daje pełnego przekroju.</translation>
    </message>
    <message>
        <source>Stretches of the rail are not measured.</source>
        <translation>Odcinki szyny nie są mierzone.</translation>
    </message>
    <message>
        <source>See Diagnostics for the camera that loses frames; check network load and trigger.</source>
        <translation>Sprawdzić w Diagnostyce, która kamera gubi klatki; sprawdzić obciążenie sieci i wyzwalanie.</translation>
    </message>
    <message>
        <source>Too many profiles do not fit the section of the recipe.</source>
        <translation>Zbyt wiele przekrojów nie pasuje do profilu z receptury.</translation>
    </message>
    <message>
        <source>The dimensions of this rail are not to be trusted.</source>
        <translation>Wymiary tej szyny nie są wiarygodne.</translation>
    </message>
    <message>
        <source>Check that the recipe is the one of the rail that runs; look at Stripes for glare or scale.</source>
        <translation>Sprawdzić, czy receptura odpowiada bieżącej szynie; poszukać odblasków lub zgorzeliny na stronie Linie lasera.</translation>
    </message>
    <message>
        <source>The measurement has stopped while a rail passes.</source>
        <translation>Pomiar zatrzymał się podczas przejazdu szyny.</translation>
    </message>
    <message>
        <source>Rails pass unmeasured.</source>
        <translation>Szyny przejeżdżają bez pomiaru.</translation>
    </message>
    <message>
        <source>Start the measurement; if it stops again, save a support bundle in Diagnostics.</source>
        <translation>Uruchomić pomiar; jeśli znów stanie, zapisać plik serwisowy w Diagnostyce.</translation>
    </message>
    <message>
        <source>A rail has a stretch out of tolerance.</source>
        <translation>Szyna ma odcinek poza tolerancją.</translation>
    </message>
    <message>
        <source>The rail must not be delivered as it is.</source>
        <translation>Szyny nie wolno dostarczyć w tym stanie.</translation>
    </message>
    <message>
        <source>Mark the rail, see its exceptions on Rails, tell the rolling mill which dimension and where.</source>
        <translation>Oznaczyć szynę, obejrzeć przekroczenia na stronie Szyny, podać walcowni wymiar i miejsce.</translation>
    </message>
    <message>
        <source>The rail looks like another section than that of the recipe.</source>
        <translation>Szyna wygląda na inny profil niż w recepturze.</translation>
    </message>
    <message>
        <source>It is judged by the wrong tolerances.</source>
        <translation>Jest oceniana według niewłaściwych tolerancji.</translation>
    </message>
    <message>
        <source>Choose the recipe of the rail that is rolled.</source>
        <translation>Wybrać recepturę walcowanej szyny.</translation>
    </message>
    <message>
        <source>The calibration in force is refused, missing or out of date.</source>
        <translation>Obowiązująca kalibracja jest odrzucona, brakująca lub nieaktualna.</translation>
    </message>
    <message>
        <source>Uncertainties are not what the reports state.</source>
        <translation>Niepewności nie są takie, jak podają raporty.</translation>
    </message>
    <message>
        <source>Calibrate, or bring back an earlier calibration.</source>
        <translation>Skalibrować albo przywrócić wcześniejszą kalibrację.</translation>
    </message>
    <message>
        <source>The seam between two cameras has moved in normal production.</source>
        <translation>Styk między dwiema kamerami przesunął się podczas zwykłej produkcji.</translation>
    </message>
    <message>
        <source>Dimensions across the seam are biased by about as much.</source>
        <translation>Wymiary przez styk są obciążone podobnym błędem.</translation>
    </message>
    <message>
        <source>Check the mounting of the cameras beside the seam; calibrate the range finders at the next pause.</source>
        <translation>Sprawdzić mocowanie kamer przy styku; skalibrować dalmierze w najbliższej przerwie.</translation>
    </message>
    <message>
        <source>A camera loses frames.</source>
        <translation>Kamera gubi klatki.</translation>
    </message>
    <message>
        <source>Profiles are incomplete now and then.</source>
        <translation>Przekroje bywają niepełne.</translation>
    </message>
    <message>
        <source>Check cable, switch and packet size of the camera.</source>
        <translation>Sprawdzić kabel, przełącznik i rozmiar pakietu kamery.</translation>
    </message>
    <message>
        <source>Much of a laser line is saturated.</source>
        <translation>Duża część linii lasera jest przesycona.</translation>
    </message>
    <message>
        <source>Points on bright patches are less certain.</source>
        <translation>Punkty w jasnych miejscach są mniej pewne.</translation>
    </message>
    <message>
        <source>Shorten the exposure of the camera or clean the window.</source>
        <translation>Skrócić ekspozycję kamery lub oczyścić okienko.</translation>
    </message>
    <message>
        <source>A laser line is faint.</source>
        <translation>Linia lasera jest słaba.</translation>
    </message>
    <message>
        <source>Points are missing or uncertain.</source>
        <translation>Punktów brakuje lub są niepewne.</translation>
    </message>
    <message>
        <source>Clean the windows, check the laser, lengthen the exposure.</source>
        <translation>Oczyścić okienka, sprawdzić laser, wydłużyć ekspozycję.</translation>
    </message>
    <message>
        <source>The rig is warmer than its calibration allows.</source>
        <translation>Układ jest cieplejszy, niż dopuszcza kalibracja.</translation>
    </message>
    <message>
        <source>Positions of cameras and lasers move.</source>
        <translation>Położenia kamer i laserów się przesuwają.</translation>
    </message>
    <message>
        <source>Check cooling and air; calibrate if it stays so.</source>
        <translation>Sprawdzić chłodzenie i powietrze; jeśli się utrzymuje, skalibrować.</translation>
    </message>
    <message>
        <source>The disk is nearly full.</source>
        <translation>Dysk jest prawie pełny.</translation>
    </message>
    <message>
        <source>Records of rails cannot be kept.</source>
        <translation>Nie można zapisywać danych szyn.</translation>
    </message>
    <message>
        <source>Prune the archive or enlarge the disk.</source>
        <translation>Oczyścić archiwum lub powiększyć dysk.</translation>
    </message>
    <message>
        <source>The archive does not answer.</source>
        <translation>Archiwum nie odpowiada.</translation>
    </message>
    <message>
        <source>Rails are measured; their records wait on this machine&apos;s disk.</source>
        <translation>Szyny są mierzone; ich zapisy czekają na dysku tego komputera.</translation>
    </message>
    <message>
        <source>Check database and network; records are sent when it is back.</source>
        <translation>Sprawdzić bazę danych i sieć; zapisy zostaną wysłane po powrocie.</translation>
    </message>
    <message>
        <source>The queues of the measurement fill up.</source>
        <translation>Kolejki pomiaru się zapełniają.</translation>
    </message>
    <message>
        <source>Profiles will be dropped.</source>
        <translation>Przekroje będą odrzucane.</translation>
    </message>
    <message>
        <source>Close what else runs on this machine; lower the trigger rate.</source>
        <translation>Zamknąć inne programy na tym komputerze; zmniejszyć częstość wyzwalania.</translation>
    </message>
    <message>
        <source>A toleranced dimension is not measured while a rail passes.</source>
        <translation>Wymiar tolerowany nie jest mierzony podczas przejazdu szyny.</translation>
    </message>
    <message>
        <source>The rail cannot be judged by it.</source>
        <translation>Nie można według niego ocenić szyny.</translation>
    </message>
    <message>
        <source>Clean windows and check lasers; see Stripes for where the line is missing.</source>
        <translation>Oczyścić okienka i sprawdzić lasery; na stronie Linie lasera widać, gdzie brak linii.</translation>
    </message>
    <message>
        <source>The window answers slowly.</source>
        <translation>Okno odpowiada powoli.</translation>
    </message>
    <message>
        <source>What it shows is late; the measurement goes on.</source>
        <translation>Obraz jest opóźniony; pomiar trwa.</translation>
    </message>
    <message>
        <source>Close what else runs on this machine; see Diagnostics.</source>
        <translation>Zamknąć inne programy na tym komputerze; zob. Diagnostyka.</translation>
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
        <translation>%1 i %2</translation>
    </message>
    <message>
        <source>Rail %1 out of tolerance: %2</source>
        <translation>Szyna %1 poza tolerancją: %2</translation>
    </message>
    <message>
        <source>Camera %1 lost</source>
        <translation>Utracono kamerę %1</translation>
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
        <translation>Wysokość szyny</translation>
    </message>
    <message>
        <source>Rail flange height</source>
        <translation>Wysokość komory łubkowej</translation>
    </message>
    <message>
        <source>Foot width</source>
        <translation>Szerokość stopki</translation>
    </message>
    <message>
        <source>Head form</source>
        <translation>Kształt główki</translation>
    </message>
    <message>
        <source>Head width</source>
        <translation>Szerokość główki</translation>
    </message>
    <message>
        <source>Head width (AREMA)</source>
        <translation>Szerokość główki (AREMA)</translation>
    </message>
    <message>
        <source>Foot thickness left</source>
        <translation>Grubość stopki lewa</translation>
    </message>
    <message>
        <source>Foot thickness right</source>
        <translation>Grubość stopki prawa</translation>
    </message>
    <message>
        <source>Rail asymmetry left</source>
        <translation>Asymetria lewa</translation>
    </message>
    <message>
        <source>Rail asymmetry right</source>
        <translation>Asymetria prawa</translation>
    </message>
    <message>
        <source>Web thickness</source>
        <translation>Grubość szyjki</translation>
    </message>
    <message>
        <source>Head radius</source>
        <translation>Promień główki</translation>
    </message>
    <message>
        <source>Foot concavity</source>
        <translation>Wklęsłość stopki</translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>Good</source>
        <translation>W normie</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>Przy granicy</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Poza</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Bez granic</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Nie zmierzono</translation>
    </message>
    <message>
        <source>not measured, because %1</source>
        <translation>nie zmierzono, ponieważ: %1</translation>
    </message>
    <message>
        <source>%1 above the limit</source>
        <translation>%1 powyżej granicy</translation>
    </message>
    <message>
        <source>%1 below the limit</source>
        <translation>%1 poniżej granicy</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>Poza tolerancją</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Strona %1 z %2</translation>
    </message>
    <message>
        <source>No points</source>
        <translation>Brak punktów</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Wstrzymane</translation>
    </message>
    <message>
        <source>No rail found</source>
        <translation>Nie znaleziono szyny</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Zmierzone</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancja</translation>
    </message>
    <message>
        <source>Model %1 (approximate)</source>
        <translation>Model %1 (przybliżony)</translation>
    </message>
    <message>
        <source>Model %1 (invented)</source>
        <translation>Model %1 (zmyślony)</translation>
    </message>
    <message>
        <source>Model %1</source>
        <translation>Model %1</translation>
    </message>
    <message>
        <source>Camera 1</source>
        <translation>Kamera 1</translation>
    </message>
    <message>
        <source>deviation %1 %2, ×%3</source>
        <translation>odchyłka %1 %2, ×%3</translation>
    </message>
    <message>
        <source>Rail %1</source>
        <translation>Szyna %1</translation>
    </message>
    <message>
        <source>Rail profile report</source>
        <translation>Raport profilu szyny</translation>
    </message>
    <message>
        <source>%1   recipe %2   calibration %3</source>
        <translation>%1   receptura %2   kalibracja %3</translation>
    </message>
    <message>
        <source>mm. s: standard deviation along the rail; u, U: standard and expanded uncertainty of one profile; Exc.: stretches out of tolerance.</source>
        <translation>mm. s: odchylenie standardowe wzdłuż szyny; u, U: niepewność standardowa i rozszerzona jednego przekroju; Przekr.: odcinki poza tolerancją.</translation>
    </message>
    <message>
        <source>Profile at %1 m</source>
        <translation>Przekrój na %1 m</translation>
    </message>
    <message>
        <source>Dimensions along the rail, mm over m</source>
        <translation>Wymiary wzdłuż szyny, mm na m</translation>
    </message>
    <message>
        <source>mean of a stretch</source>
        <translation>średnia odcinka</translation>
    </message>
    <message>
        <source>smallest to largest value of the stretch</source>
        <translation>od najmniejszej do największej wartości odcinka</translation>
    </message>
    <message>
        <source>expected value</source>
        <translation>wartość oczekiwana</translation>
    </message>
    <message>
        <source>limits; the ground outside is grey</source>
        <translation>granice; tło poza nimi jest szare</translation>
    </message>
    <message>
        <source>exception, with its square</source>
        <translation>przekroczenie, z kwadratem</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nie zmierzono</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>Przekroczenia</translation>
    </message>
    <message>
        <source>Exceptions: none</source>
        <translation>Przekroczenia: brak</translation>
    </message>
    <message>
        <source> (continued)</source>
        <translation> (cd.)</translation>
    </message>
    <message>
        <source>the first %1 of %2</source>
        <translation>pierwsze %1 z %2</translation>
    </message>
    <message>
        <source>from m</source>
        <translation>od m</translation>
    </message>
    <message>
        <source>to m</source>
        <translation>do m</translation>
    </message>
    <message>
        <source>length m</source>
        <translation>długość m</translation>
    </message>
    <message>
        <source>worst mm</source>
        <translation>najgorszy mm</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>odchyłka</translation>
    </message>
    <message>
        <source>beyond limit</source>
        <translation>poza granicą</translation>
    </message>
    <message>
        <source>Triggers</source>
        <translation>Wyzwolenia</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>zauważone</translation>
    </message>
    <message>
        <source>measured: complete, four contours</source>
        <translation>zmierzone: pełne, cztery kontury</translation>
    </message>
    <message>
        <source>incomplete: a camera or the registration was missing</source>
        <translation>niepełne: brak kamery lub dopasowania</translation>
    </message>
    <message>
        <source>lost: no profile</source>
        <translation>utracone: brak przekroju</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Uwagi</translation>
    </message>
    <message>
        <source>This section is invented: not for acceptance.</source>
        <translation>Ten profil jest zmyślony: nie do odbioru.</translation>
    </message>
    <message>
        <source>This section is approximate: not for acceptance.</source>
        <translation>Ten profil jest przybliżony: nie do odbioru.</translation>
    </message>
    <message>
        <source>profile at %1 m</source>
        <translation>przekrój na %1 m</translation>
    </message>
    <message>
        <source> and </source>
        <translation> i </translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Wymiar</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Nominał</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Średnia</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Maks</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Granice</translation>
    </message>
    <message>
        <source>Exc.</source>
        <translation>Przekr.</translation>
    </message>
    <message>
        <source>max %1</source>
        <translation>maks %1</translation>
    </message>
    <message>
        <source>min %1</source>
        <translation>min %1</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Szyna</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Wytop</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Receptura</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Długość</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Przekroje</translation>
    </message>
    <message>
        <source>Rail temperature</source>
        <translation>Temperatura szyny</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibracja</translation>
    </message>
    <message>
        <source>Measured (UTC)</source>
        <translation>Zmierzono (UTC)</translation>
    </message>
    <message>
        <source>Written (UTC)</source>
        <translation>Sporządzono (UTC)</translation>
    </message>
    <message>
        <source>Measured (local)</source>
        <translation>Zmierzono (czas lok.)</translation>
    </message>
    <message>
        <source>Written (local)</source>
        <translation>Sporządzono (czas lok.)</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Wartości</translation>
    </message>
    <message>
        <source>No limits to judge by</source>
        <translation>Brak granic do oceny</translation>
    </message>
    <message>
        <source>Not valid</source>
        <translation>Nieważne</translation>
    </message>
    <message>
        <source> out of tolerance</source>
        <translation> poza tolerancją</translation>
    </message>
    <message>
        <source> from %1 to %2 m</source>
        <translation> od %1 do %2 m</translation>
    </message>
    <message>
        <source> in %1 stretches, the first at %2 m</source>
        <translation> w %1 odcinkach, pierwszy na %2 m</translation>
    </message>
    <message>
        <source> not measured</source>
        <translation> nie zmierzono</translation>
    </message>
    <message>
        <source> not measured, because %1</source>
        <translation> nie zmierzono, ponieważ: %1</translation>
    </message>
    <message>
        <source> near limit</source>
        <translation> przy granicy</translation>
    </message>
    <message>
        <source>%1 toleranced dimensions within their limits over %2 m</source>
        <translation>%1 wymiarów tolerowanych w granicach na %2 m</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>SYMULACJA</translation>
    </message>
    <message>
        <source>Not measured, because %1</source>
        <translation>Nie zmierzono, ponieważ: %1</translation>
    </message>
    <message>
        <source>Lengths refer to 15 °C. U is the expanded uncertainty with k = 2; a value nearer to a limit than U is near limit: it cannot be decided.</source>
        <translation>Długości odnoszą się do 15 °C. U to niepewność rozszerzona z k = 2; wartość bliżej granicy niż U jest przy granicy: nie można rozstrzygnąć.</translation>
    </message>
    <message>
        <source>mm at 15 °C</source>
        <translation>mm przy 15 °C</translation>
    </message>
</context>
<context>
    <name>Engine</name>
    <message>
        <source>wrong section: looks like %1 rather than %2</source>
        <translation>niewłaściwy profil: wygląda na %1, nie %2</translation>
    </message>
    <message>
        <source>wrong section: looks like %1</source>
        <translation>niewłaściwy profil: wygląda na %1</translation>
    </message>
    <message>
        <source>not registered: %1</source>
        <translation>niedopasowany: %1</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>niedopasowany</translation>
    </message>
    <message>
        <source>looks like %1</source>
        <translation>wygląda na %1</translation>
    </message>
    <message>
        <source>the points do not agree with %1: %2 lie on it, rms %3 mm; another rail, badly worn, or not a rail?</source>
        <translation>punkty nie zgadzają się z %1: leży na nim %2, RMS %3 mm; inna szyna, mocno zużyta czy nie szyna?</translation>
    </message>
    <message>
        <source>the points do not agree with %1</source>
        <translation>punkty nie zgadzają się z %1</translation>
    </message>
    <message>
        <source>the section has no web</source>
        <translation>profil nie ma szyjki</translation>
    </message>
    <message>
        <source>the points do not determine a pose</source>
        <translation>punkty nie wyznaczają położenia</translation>
    </message>
    <message>
        <source>the foot edge is not upright</source>
        <translation>krawędź stopki nie jest pionowa</translation>
    </message>
    <message>
        <source>the crown is flat</source>
        <translation>powierzchnia toczna jest płaska</translation>
    </message>
    <message>
        <source>points do not reach x = %1 from the axis</source>
        <translation>punkty nie sięgają x = %1 od osi</translation>
    </message>
    <message>
        <source>points do not reach the crown on the axis</source>
        <translation>punkty nie sięgają powierzchni tocznej na osi</translation>
    </message>
    <message>
        <source>points do not reach %1 above the base line</source>
        <translation>punkty nie sięgają %1 nad linią bazową</translation>
    </message>
    <message>
        <source>not defined on this section</source>
        <translation>niezdefiniowane dla tego profilu</translation>
    </message>
    <message>
        <source>no point is near the outline of %1</source>
        <translation>żaden punkt nie leży przy zarysie %1</translation>
    </message>
    <message>
        <source>no base line: %1</source>
        <translation>brak linii bazowej: %1</translation>
    </message>
    <message>
        <source>measurement failed</source>
        <translation>pomiar nieudany</translation>
    </message>
    <message>
        <source>extraction failed</source>
        <translation>ekstrakcja nieudana</translation>
    </message>
    <message>
        <source>translation failed</source>
        <translation>przeliczenie nieudane</translation>
    </message>
    <message>
        <source>the profile is not registered</source>
        <translation>przekrój nie jest dopasowany</translation>
    </message>
    <message>
        <source>no points on %1</source>
        <translation>brak punktów na %1</translation>
    </message>
    <message>
        <source>only %1 point on %2, %3 are needed</source>
        <translation>tylko %1 punkt na %2, potrzeba %3</translation>
    </message>
    <message>
        <source>only %1 points on %2, %3 are needed</source>
        <translation>tylko %1 punktów na %2, potrzeba %3</translation>
    </message>
    <message>
        <source>only %1 points, at least %2 are needed</source>
        <translation>tylko %1 punktów, potrzeba co najmniej %2</translation>
    </message>
    <message>
        <source>the points on %1 make no curve</source>
        <translation>punkty na %1 nie tworzą krzywej</translation>
    </message>
    <message>
        <source>%1 is not fitted</source>
        <translation>%1 nie jest dopasowany</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>brak punktów</translation>
    </message>
    <message>
        <source>no profiles</source>
        <translation>brak przekrojów</translation>
    </message>
    <message>
        <source>no frames</source>
        <translation>brak klatek</translation>
    </message>
    <message>
        <source>no frame</source>
        <translation>brak klatki</translation>
    </message>
    <message>
        <source>frame lost</source>
        <translation>utracona klatka</translation>
    </message>
    <message>
        <source>repeated frame</source>
        <translation>powtórzona klatka</translation>
    </message>
    <message>
        <source>late frame</source>
        <translation>spóźniona klatka</translation>
    </message>
    <message>
        <source>too late</source>
        <translation>za późno</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>zatrzymano</translation>
    </message>
    <message>
        <source>source failed</source>
        <translation>awaria źródła</translation>
    </message>
    <message>
        <source>queue overflow</source>
        <translation>przepełnienie kolejki</translation>
    </message>
    <message>
        <source>outside of a rail</source>
        <translation>poza szyną</translation>
    </message>
    <message>
        <source>missed by all cameras</source>
        <translation>pominięte przez wszystkie kamery</translation>
    </message>
    <message>
        <source>%1 from %2 m</source>
        <translation>%1 od %2 m</translation>
    </message>
    <message>
        <source>camera %1: %2</source>
        <translation>kamera %1: %2</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>kamera %1</translation>
    </message>
    <message>
        <source>rail %1</source>
        <translation>szyna %1</translation>
    </message>
    <message>
        <source>line</source>
        <translation>linia</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>kalibracja</translation>
    </message>
    <message>
        <source>archive</source>
        <translation>archiwum</translation>
    </message>
    <message>
        <source>pipeline</source>
        <translation>tor przetwarzania</translation>
    </message>
    <message>
        <source>window</source>
        <translation>okno</translation>
    </message>
    <message>
        <source>disk</source>
        <translation>dysk</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>operator</translation>
    </message>
    <message>
        <source>range finders</source>
        <translation>dalmierze</translation>
    </message>
    <message>
        <source>rail %1 has passed: %2</source>
        <translation>przejechała szyna %1: %2</translation>
    </message>
    <message>
        <source>the line was started</source>
        <translation>uruchomiono linię</translation>
    </message>
    <message>
        <source>the line was stopped</source>
        <translation>zatrzymano linię</translation>
    </message>
    <message>
        <source>%1 signed in</source>
        <translation>zalogowano: %1</translation>
    </message>
    <message>
        <source>%1 signed out</source>
        <translation>wylogowano: %1</translation>
    </message>
    <message>
        <source>good</source>
        <translation>w normie</translation>
    </message>
    <message>
        <source>near limit</source>
        <translation>przy granicy</translation>
    </message>
    <message>
        <source>out of tolerance</source>
        <translation>poza tolerancją</translation>
    </message>
    <message>
        <source>no limits</source>
        <translation>bez granic</translation>
    </message>
    <message>
        <source>not valid</source>
        <translation>nieważne</translation>
    </message>
    <message>
        <source>is shorter than %1 characters</source>
        <translation>ma mniej niż %1 znaków</translation>
    </message>
    <message>
        <source>the old one is wrong</source>
        <translation>stare jest błędne</translation>
    </message>
    <message>
        <source>too many wrong ones; locked until %1</source>
        <translation>zbyt wiele błędnych; blokada do %1</translation>
    </message>
    <message>
        <source>needs a reason; say why</source>
        <translation>wymaga powodu; podać dlaczego</translation>
    </message>
    <message>
        <source>an entry needs who and what</source>
        <translation>wpis wymaga: kto i co</translation>
    </message>
    <message>
        <source>password</source>
        <translation>hasło</translation>
    </message>
    <message>
        <source>is no user here</source>
        <translation>nie jest tu wpisany</translation>
    </message>
    <message>
        <source>is longer than 1024 bytes</source>
        <translation>ma ponad 1024 bajty</translation>
    </message>
    <message>
        <source>a name has 1 to 64 characters</source>
        <translation>nazwa ma od 1 do 64 znaków</translation>
    </message>
    <message>
        <source>the first user must be an administrator</source>
        <translation>pierwszy użytkownik musi być administratorem</translation>
    </message>
    <message>
        <source>is a user already</source>
        <translation>jest już wpisany</translation>
    </message>
    <message>
        <source>is the last administrator; make another one first</source>
        <translation>jest ostatnim administratorem; najpierw wyznacz innego</translation>
    </message>
    <message>
        <source>there is none</source>
        <translation>nie ma go</translation>
    </message>
    <message>
        <source>no archive was asked for (--archive)</source>
        <translation>nie zażądano archiwum (--archive)</translation>
    </message>
    <message>
        <source>exact (virtual rig)</source>
        <translation>dokładna (układ wirtualny)</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>rysunek</translation>
    </message>
    <message>
        <source>none (generated numbers)</source>
        <translation>brak (liczby generowane)</translation>
    </message>
</context>
<context>
    <name>Judgement</name>
    <message>
        <source>from %1 on</source>
        <translation>od %1</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>od %1 do %2</translation>
    </message>
    <message>
        <source>%1 %2 above the limit %3</source>
        <translation>%1 %2 powyżej granicy %3</translation>
    </message>
    <message>
        <source>%1 %2 below the limit %3</source>
        <translation>%1 %2 poniżej granicy %3</translation>
    </message>
    <message>
        <source>%1 beyond the limit %2</source>
        <translation>%1 poza granicą %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 i %2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>camera %1 lost</source>
        <translation>utracono kamerę %1</translation>
    </message>
    <message>
        <source>cameras %1 lost</source>
        <translation>utracono kamery %1</translation>
    </message>
    <message>
        <source>%1 dimensions</source>
        <translation>%1 wymiarów</translation>
    </message>
    <message>
        <source>Not valid</source>
        <translation>Nieważne</translation>
    </message>
    <message>
        <source>%1 not measured from %2 on: %3</source>
        <translation>%1 nie zmierzono od %2: %3</translation>
    </message>
    <message>
        <source>%1 near limit</source>
        <translation>%1 przy granicy</translation>
    </message>
    <message>
        <source>single profiles outside the limits</source>
        <translation>pojedyncze przekroje poza granicami</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>Poza tolerancją</translation>
    </message>
    <message>
        <source>%1 %2 inside the limit, closer than U</source>
        <translation>%1 %2 w granicy, bliżej niż U</translation>
    </message>
    <message>
        <source>%1 %2 outside the limit, by less than U</source>
        <translation>%1 %2 poza granicą, o mniej niż U</translation>
    </message>
    <message>
        <source>within the guard band earlier on this rail</source>
        <translation>wcześniej na tej szynie w paśmie ochronnym</translation>
    </message>
    <message>
        <source>%1 within the guard band earlier on this rail</source>
        <translation>%1 wcześniej na tej szynie w paśmie ochronnym</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>Przy granicy</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>W normie</translation>
    </message>
    <message>
        <source>%1 dimensions within limits up to %2</source>
        <translation>%1 wymiarów w granicach do %2</translation>
    </message>
    <message>
        <source>Waiting for a rail</source>
        <translation>Oczekiwanie na szynę</translation>
    </message>
    <message>
        <source>the gauge is ready; values appear with the head of the rail</source>
        <translation>przyrząd gotowy; wartości pojawią się z początkiem szyny</translation>
    </message>
    <message>
        <source>the line is not running: Ctrl+R starts it</source>
        <translation>linia nie pracuje: Ctrl+R ją uruchamia</translation>
    </message>
    <message>
        <source>No limits</source>
        <translation>Bez granic</translation>
    </message>
    <message>
        <source>the recipe gives no tolerance to any dimension</source>
        <translation>receptura nie podaje tolerancji żadnego wymiaru</translation>
    </message>
    <message>
        <source>this rail was not measured completely</source>
        <translation>ta szyna nie została zmierzona w całości</translation>
    </message>
    <message>
        <source>%1 not measured on enough of this rail</source>
        <translation>%1 zmierzono na zbyt małej części szyny</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>Bezczynna</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Gotowa</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Pomiar</translation>
    </message>
    <message>
        <source>No profiles</source>
        <translation>Brak przekr.</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Zatrzymana</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Awaria</translation>
    </message>
    <message>
        <source>no profiles since %1, %2 ago. Hold this rail.</source>
        <translation>brak przekrojów od %1, %2 temu. Zatrzymać tę szynę.</translation>
    </message>
    <message>
        <source>held: last profile at %1, %2 ago</source>
        <translation>wstrzymane: ostatni przekrój na %1, %2 temu</translation>
    </message>
    <message>
        <source>%1 of %2 cameras, %3 profiles/s</source>
        <translation>kamery: %1 z %2, %3 przekr./s</translation>
    </message>
    <message>
        <source>no profiles for %1</source>
        <translation>brak przekrojów od %1</translation>
    </message>
    <message>
        <source>calibration %1</source>
        <translation>kalibracja %1</translation>
    </message>
    <message>
        <source>Not trusted</source>
        <translation>Niewiarygodny</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Brak danych</translation>
    </message>
    <message>
        <source>no profile yet</source>
        <translation>jeszcze brak przekroju</translation>
    </message>
    <message>
        <source>the line is not running</source>
        <translation>linia nie pracuje</translation>
    </message>
    <message>
        <source>Degraded</source>
        <translation>Pogorszony</translation>
    </message>
    <message>
        <source>%1 of %2 incomplete</source>
        <translation>niepełne: %1 z %2</translation>
    </message>
    <message>
        <source>Trusted</source>
        <translation>Wiarygodny</translation>
    </message>
    <message>
        <source>The line is stopped: Ctrl+R starts it</source>
        <translation>Linia stoi: Ctrl+R ją uruchamia</translation>
    </message>
    <message>
        <source>Ready for the next rail</source>
        <translation>Gotowa na następną szynę</translation>
    </message>
    <message>
        <source>No alarm on this rail</source>
        <translation>Brak alarmów na tej szynie</translation>
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
        <translation>Linie lasera</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Wykresy</translation>
    </message>
    <message>
        <source>Rails</source>
        <translation>Szyny</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibracja</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Receptury</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Jakość</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmy</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnostyka</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ustawienia</translation>
    </message>
</context>
<context>
    <name>Role</name>
    <message>
        <source>Operator</source>
        <translation>Operator</translation>
    </message>
    <message>
        <source>Technician</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>QA</source>
        <translation>Kontrola</translation>
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
        <translation>pojawia się i znika</translation>
    </message>
    <message>
        <source>on for more than a day</source>
        <translation>trwa ponad dobę</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>ustąpił</translation>
    </message>
    <message>
        <source>acknowledged by %1</source>
        <translation>potwierdził: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarm</numerusform>
            <numerusform>%n alarmy</numerusform>
            <numerusform>%n alarmów</numerusform>
        </translation>
    </message>
    <message>
        <source>Priority %1</source>
        <translation>Priorytet %1</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Przyczyna</translation>
    </message>
    <message>
        <source>Consequence</source>
        <translation>Skutek</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Działanie</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Potwierdź</translation>
    </message>
    <message>
        <source>Acknowledge: %1</source>
        <translation>Potwierdź: %1</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmHistoryPanel</name>
    <message>
        <source>What happened</source>
        <translation>Co się działo</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmy</translation>
    </message>
    <message>
        <source>Show the alarms that came and went</source>
        <translation>Pokaż przeszłe alarmy</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Zdarzenia</translation>
    </message>
    <message>
        <source>Show events</source>
        <translation>Pokaż zdarzenia</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Eksport…</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Eksport do CSV</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>Wystąpił</translation>
    </message>
    <message>
        <source>Went</source>
        <translation>Ustąpił</translation>
    </message>
    <message>
        <source>Lasted</source>
        <translation>Trwał</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Szczegóły</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Kto</translation>
    </message>
    <message>
        <source>Alarms that came and went, newest first</source>
        <translation>Przeszłe alarmy, najnowsze najpierw</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Czas</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Zdarzenie</translation>
    </message>
    <message>
        <source>Events, newest first</source>
        <translation>Zdarzenia, najnowsze najpierw</translation>
    </message>
    <message>
        <source>still on</source>
        <translation>trwa</translation>
    </message>
    <message>
        <source>shelved: %1</source>
        <translation>odłożony: %1</translation>
    </message>
    <message>
        <source>nobody yet</source>
        <translation>jeszcze nikt</translation>
    </message>
    <message>
        <source>no alarm so far</source>
        <translation>dotąd brak alarmów</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarm</numerusform>
            <numerusform>%n alarmy</numerusform>
            <numerusform>%n alarmów</numerusform>
        </translation>
    </message>
    <message>
        <source>no event so far</source>
        <translation>dotąd brak zdarzeń</translation>
    </message>
    <message numerus="yes">
        <source>%n event(s)</source>
        <translation>
            <numerusform>%n zdarzenie</numerusform>
            <numerusform>%n zdarzenia</numerusform>
            <numerusform>%n zdarzeń</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>Zapisano %1</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>Nie można zapisać %1: %2</translation>
    </message>
    <message>
        <source>program ended</source>
        <translation>koniec programu</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmLine</name>
    <message>
        <source>Alarm, priority %1: %2. %3</source>
        <translation>Alarm, priorytet %1: %2. %3</translation>
    </message>
    <message>
        <source>1 of %1</source>
        <translation>1 z %1</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) acknowledged, still on</source>
        <translation>
            <numerusform>%n alarm potwierdzony, nadal trwa</numerusform>
            <numerusform>%n alarmy potwierdzone, nadal trwają</numerusform>
            <numerusform>%n alarmów potwierdzonych, nadal trwa</numerusform>
        </translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Potwierdź</translation>
    </message>
    <message>
        <source>Acknowledge the shown alarm</source>
        <translation>Potwierdź pokazany alarm</translation>
    </message>
    <message>
        <source>Acknowledge the shown alarm (Ctrl+A)</source>
        <translation>Potwierdź pokazany alarm (Ctrl+A)</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmsPage</name>
    <message>
        <source>Active</source>
        <translation>Aktywne</translation>
    </message>
    <message>
        <source>Acknowledge page</source>
        <translation>Potwierdź stronę</translation>
    </message>
    <message>
        <source>Acknowledge all that are shown</source>
        <translation>Potwierdź wszystkie pokazane</translation>
    </message>
    <message>
        <source>Acknowledge all that are shown (Ctrl+Shift+A)</source>
        <translation>Potwierdź wszystkie pokazane (Ctrl+Shift+A)</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Częstość</translation>
    </message>
    <message>
        <source>10 min</source>
        <translation>10 min</translation>
    </message>
    <message>
        <source>Hour</source>
        <translation>Godzina</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Doba</translation>
    </message>
    <message>
        <source>Shelve</source>
        <translation>Odłóż</translation>
    </message>
    <message>
        <source>hides an alarm for a while</source>
        <translation>ukrywa alarm na pewien czas</translation>
    </message>
    <message>
        <source>Alarm to shelve</source>
        <translation>Alarm do odłożenia</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>Reason for shelving</source>
        <translation>Powód odłożenia</translation>
    </message>
    <message>
        <source>For how long</source>
        <translation>Na jak długo</translation>
    </message>
    <message>
        <source>Shelved</source>
        <translation>Odłożone</translation>
    </message>
    <message>
        <source>comes back by itself</source>
        <translation>wraca samo</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Przywróć</translation>
    </message>
    <message>
        <source>Bring back the chosen alarm</source>
        <translation>Przywróć wybrany alarm</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Do</translation>
    </message>
    <message>
        <source>Shelved alarms</source>
        <translation>Odłożone alarmy</translation>
    </message>
    <message>
        <source>An operator may shelve for %1 minutes at most.</source>
        <translation>Operator może odłożyć najwyżej na %1 minut.</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarm</numerusform>
            <numerusform>%n alarmy</numerusform>
            <numerusform>%n alarmów</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not acknowledged</source>
        <translation>
            <numerusform>%n niepotwierdzony</numerusform>
            <numerusform>%n niepotwierdzone</numerusform>
            <numerusform>%n niepotwierdzonych</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is wrong. Alarms appear here with their cause, their consequence and what to do.</source>
        <translation>Wszystko w porządku. Alarmy pojawiają się tu z przyczyną, skutkiem i działaniem.</translation>
    </message>
    <message>
        <source>since the program started</source>
        <translation>od uruchomienia programu</translation>
    </message>
    <message>
        <source>Flood: more than 10 alarms in 10 minutes. Look for one cause behind them.</source>
        <translation>Lawina: ponad 10 alarmów w 10 minut. Szukać wspólnej przyczyny.</translation>
    </message>
    <message>
        <source>Target: below 1 in 10 minutes; above 10 it is a flood.</source>
        <translation>Cel: poniżej 1 na 10 minut; powyżej 10 to lawina.</translation>
    </message>
    <message>
        <source>alarms in 10 minutes</source>
        <translation>alarmy na 10 minut</translation>
    </message>
    <message>
        <source>Health of the alarms</source>
        <translation>Stan alarmów</translation>
    </message>
    <message>
        <source>flood: grouped by rule</source>
        <translation>lawina: pogrupowane wg reguły</translation>
    </message>
    <message>
        <source>Mean per 10 minutes</source>
        <translation>Średnio na 10 minut</translation>
    </message>
    <message>
        <source>%1, target below 1</source>
        <translation>%1, cel poniżej 1</translation>
    </message>
    <message>
        <source>Floods</source>
        <translation>Lawiny</translation>
    </message>
    <message>
        <source>Comes and goes</source>
        <translation>Pojawia się i znika</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>On for more than a day</source>
        <translation>Trwa ponad dobę</translation>
    </message>
    <message>
        <source>Shelving needs a reason.</source>
        <translation>Odłożenie wymaga powodu.</translation>
    </message>
</context>
<context>
    <name>vignole::AuditPanel</name>
    <message>
        <source>Audit trail</source>
        <translation>Ślad audytowy</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Czas</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Kto</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Co</translation>
    </message>
    <message>
        <source>Of what</source>
        <translation>Czego</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>Audit trail, newest first</source>
        <translation>Ślad audytowy, najnowsze najpierw</translation>
    </message>
    <message>
        <source>Check the chain</source>
        <translation>Sprawdź łańcuch</translation>
    </message>
    <message>
        <source>Check that no entry was changed, put in or taken out</source>
        <translation>Sprawdź, że żadnego wpisu nie zmieniono, nie dodano ani nie usunięto</translation>
    </message>
    <message>
        <source>The audit trail is shown to QA and administrators who have signed in.</source>
        <translation>Ślad audytowy widzą zalogowani: kontrola jakości i administratorzy.</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s), the newest first</source>
        <translation>
            <numerusform>%n wpis, najnowszy najpierw</numerusform>
            <numerusform>%n wpisy, najnowszy najpierw</numerusform>
            <numerusform>%n wpisów, najnowszy najpierw</numerusform>
        </translation>
    </message>
    <message>
        <source>checking …</source>
        <translation>sprawdzanie …</translation>
    </message>
    <message>
        <source>The chain is whole: no entry was changed, put in or taken out.</source>
        <translation>Łańcuch jest cały: żadnego wpisu nie zmieniono, nie dodano ani nie usunięto.</translation>
    </message>
    <message>
        <source>The chain is broken: %1</source>
        <translation>Łańcuch jest przerwany: %1</translation>
    </message>
</context>
<context>
    <name>vignole::ChartsPage</name>
    <message>
        <source>Dimensions</source>
        <translation>Wymiary</translation>
    </message>
    <message>
        <source>Dimension that is charted</source>
        <translation>Wykreślany wymiar</translation>
    </message>
    <message>
        <source>Rail that is charted</source>
        <translation>Wykreślana szyna</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Dopasuj</translation>
    </message>
    <message>
        <source>Whole range</source>
        <translation>Cały zakres</translation>
    </message>
    <message>
        <source>Whole range (0)</source>
        <translation>Cały zakres (0)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Eksport…</translation>
    </message>
    <message>
        <source>Export the chart as picture, PDF or CSV</source>
        <translation>Eksport wykresu jako obraz, PDF lub CSV</translation>
    </message>
    <message>
        <source>Dimension along the rail</source>
        <translation>Wymiar wzdłuż szyny</translation>
    </message>
    <message>
        <source>Dimension rail by rail</source>
        <translation>Wymiar szyna po szynie</translation>
    </message>
    <message>
        <source>Histogram of the rail</source>
        <translation>Histogram szyny</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogram</translation>
    </message>
    <message>
        <source>same scale, this rail</source>
        <translation>ta sama skala, ta szyna</translation>
    </message>
    <message>
        <source>Per rail</source>
        <translation>Na szynę</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Liczby</translation>
    </message>
    <message>
        <source>this rail</source>
        <translation>ta szyna</translation>
    </message>
    <message>
        <source>Figures of the rail</source>
        <translation>Liczby dla szyny</translation>
    </message>
    <message>
        <source>Rails are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>Szyny nie są zachowywane: %1. Uruchomić program z archiwum (--archive FILE).</translation>
    </message>
    <message>
        <source>No rail has been measured yet. Its chart appears here when it has passed.</source>
        <translation>Nie zmierzono jeszcze szyny. Wykres pojawi się po jej przejeździe.</translation>
    </message>
    <message>
        <source>Newest rail</source>
        <translation>Najnowsza szyna</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>długość, m</translation>
    </message>
    <message>
        <source>%1 along the rail</source>
        <translation>%1 wzdłuż szyny</translation>
    </message>
    <message>
        <source>rail %1, %2 profiles</source>
        <translation>szyna %1, przekroje: %2</translation>
    </message>
    <message>
        <source>; no band: %1 of %2 other rails</source>
        <translation>; bez pasma: %1 z %2 innych szyn</translation>
    </message>
    <message>
        <source>; band: last %1 rails, 10 to 90 %</source>
        <translation>; pasmo: ostatnie szyny: %1, 10–90 %</translation>
    </message>
    <message>
        <source>same scale, longest bar %1 %</source>
        <translation>ta sama skala, najdłuższy słupek %1 %</translation>
    </message>
    <message>
        <source>rail</source>
        <translation>szyna</translation>
    </message>
    <message numerus="yes">
        <source>mean with smallest and largest value, last %n rail(s) of this section</source>
        <translation>
            <numerusform>średnia z najmniejszą i największą wartością, ostatnia szyna tego profilu</numerusform>
            <numerusform>średnia z najmniejszą i największą wartością, ostatnie %n szyny tego profilu</numerusform>
            <numerusform>średnia z najmniejszą i największą wartością, ostatnie %n szyn tego profilu</numerusform>
        </translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Średnia</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Odchylenie std.</translation>
    </message>
    <message>
        <source>Smallest, largest</source>
        <translation>Najmniejsza, największa</translation>
    </message>
    <message>
        <source>Uncertainty U (k = 2)</source>
        <translation>Niepewność U (k = 2)</translation>
    </message>
    <message>
        <source>Beyond a limit</source>
        <translation>Poza granicą</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>In the guard band</source>
        <translation>W paśmie ochronnym</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Nie zmierzono</translation>
    </message>
    <message>
        <source>Room to the nearer limit</source>
        <translation>Zapas do bliższej granicy</translation>
    </message>
    <message>
        <source>Move over the chart or press Left and Right to read values; wheel or + and − zoom, drag moves.</source>
        <translation>Przesuń po wykresie lub naciskaj w lewo i w prawo, by odczytać wartości; kółko lub + i − powiększają, przeciąganie przesuwa.</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>not measured: %1</source>
        <translation>nie zmierzono: %1</translation>
    </message>
    <message>
        <source>%1   %2 %3   U ±%4   %5 from expected   %6</source>
        <translation>%1   %2 %3   U ±%4   %5 od oczekiwanej   %6</translation>
    </message>
    <message>
        <source>Export the chart</source>
        <translation>Eksport wykresu</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>Zapisano %1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>Nie można zapisać %1</translation>
    </message>
</context>
<context>
    <name>vignole::DiagnosticsPage</name>
    <message>
        <source>Pipeline</source>
        <translation>Tor przetwarzania</translation>
    </message>
    <message>
        <source>Every trigger accounted for</source>
        <translation>Każde wyzwolenie rozliczone</translation>
    </message>
    <message>
        <source>since the line was started</source>
        <translation>od uruchomienia linii</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kamery</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Komputer</translation>
    </message>
    <message>
        <source>Support file…</source>
        <translation>Plik serwisowy…</translation>
    </message>
    <message>
        <source>Save a support file</source>
        <translation>Zapisz plik serwisowy</translation>
    </message>
    <message>
        <source>Where every trigger went</source>
        <translation>Gdzie trafiło każde wyzwolenie</translation>
    </message>
    <message>
        <source>Counters of the cameras</source>
        <translation>Liczniki kamer</translation>
    </message>
    <message>
        <source>Load of the computer</source>
        <translation>Obciążenie komputera</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Frames/s</source>
        <translation>Klatki/s</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Klatki</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Brak</translation>
    </message>
    <message>
        <source>held, %1 old</source>
        <translation>wstrzymane, sprzed %1</translation>
    </message>
    <message>
        <source>%1 profiles/s of %2 expected</source>
        <translation>%1 przekr./s z %2 oczekiwanych</translation>
    </message>
    <message>
        <source>Triggers</source>
        <translation>Wyzwolenia</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Zmierzone</translation>
    </message>
    <message>
        <source>Incomplete: measured by fewer cameras</source>
        <translation>Niepełne: zmierzone mniejszą liczbą kamer</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Utracone</translation>
    </message>
    <message>
        <source>Not accounted for</source>
        <translation>Nierozliczone</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>W toku</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>: lost</source>
        <translation>: utracona</translation>
    </message>
    <message>
        <source>Rendered cameras: no packets to be sent again, no temperature.</source>
        <translation>Kamery symulowane: bez ponawiania pakietów i temperatury.</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Dysk</translation>
    </message>
    <message>
        <source>%1 of %2 GB free</source>
        <translation>wolne %1 z %2 GB</translation>
    </message>
    <message>
        <source>make room: nearly full</source>
        <translation>zwolnić miejsce: prawie pełny</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiwum</translation>
    </message>
    <message>
        <source>open</source>
        <translation>otwarte</translation>
    </message>
    <message>
        <source>none: rails are not kept</source>
        <translation>brak: szyny nie są zachowywane</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Procesor</translation>
    </message>
    <message>
        <source>%1 % of one core</source>
        <translation>%1 % jednego rdzenia</translation>
    </message>
    <message numerus="yes">
        <source>%n core(s)</source>
        <translation>
            <numerusform>%n rdzeń</numerusform>
            <numerusform>%n rdzenie</numerusform>
            <numerusform>%n rdzeni</numerusform>
        </translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Pamięć</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Okno</translation>
    </message>
    <message>
        <source>turn p99 %1 ms</source>
        <translation>obieg p99 %1 ms</translation>
    </message>
    <message>
        <source>p50 %1, largest %2, limit 50 ms</source>
        <translation>p50 %1, największy %2, granica 50 ms</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Ekran</translation>
    </message>
    <message>
        <source>the window&apos;s thread</source>
        <translation>wątek okna</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>Nie można zapisać %1: %2</translation>
    </message>
</context>
<context>
    <name>vignole::DimensionModel</name>
    <message>
        <source>Not measured</source>
        <translation>Nie zmierzono</translation>
    </message>
    <message>
        <source>Not measured, because %1</source>
        <translation>Nie zmierzono, ponieważ: %1</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>bez granic</translation>
    </message>
    <message>
        <source>limits %1 to %2</source>
        <translation>granice %1 do %2</translation>
    </message>
    <message>
        <source>waiting for a profile</source>
        <translation>oczekiwanie na przekrój</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Wymiar</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Odchyłka</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Tolerance and guard band</source>
        <translation>Tolerancja i pasmo ochronne</translation>
    </message>
    <message>
        <source>Along the rail</source>
        <translation>Wzdłuż szyny</translation>
    </message>
    <message>
        <source>Not meas.</source>
        <translation>Brak pom.</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Wstrzymane</translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es) out of tolerance</source>
        <translation>
            <numerusform>%n odcinek poza tolerancją</numerusform>
            <numerusform>%n odcinki poza tolerancją</numerusform>
            <numerusform>%n odcinków poza tolerancją</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 %3, deviation %4, U %5, %6</source>
        <translation>%1, %2 %3, odchyłka %4, U %5, %6</translation>
    </message>
</context>
<context>
    <name>vignole::DimensionTable</name>
    <message>
        <source>Dimensions</source>
        <translation>Wymiary</translation>
    </message>
</context>
<context>
    <name>vignole::HeaderBar</name>
    <message>
        <source>Rail</source>
        <translation>Szyna</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Wytop</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Receptura</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Długość</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Prędkość</translation>
    </message>
    <message>
        <source>Gauge</source>
        <translation>Przyrząd</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>Jasny motyw</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>Ciemny motyw</translation>
    </message>
    <message>
        <source>Other theme (Ctrl+D)</source>
        <translation>Inny motyw (Ctrl+D)</translation>
    </message>
    <message>
        <source>%1: sign in</source>
        <translation>%1: zaloguj</translation>
    </message>
    <message>
        <source>%1, %2: sign out</source>
        <translation>%1, %2: wyloguj</translation>
    </message>
    <message>
        <source>Sign in (Ctrl+L)</source>
        <translation>Zaloguj (Ctrl+L)</translation>
    </message>
    <message>
        <source>%1: sign out (Ctrl+L)</source>
        <translation>%1: wyloguj (Ctrl+L)</translation>
    </message>
    <message>
        <source>Line: %1</source>
        <translation>Linia: %1</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>SYMULACJA</translation>
    </message>
    <message>
        <source>Simulation: the rails are not real</source>
        <translation>Symulacja: szyny nie są prawdziwe</translation>
    </message>
    <message>
        <source>The rails come from the virtual rig</source>
        <translation>Szyny pochodzą z układu wirtualnego</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Język</translation>
    </message>
</context>
<context>
    <name>vignole::LastRails</name>
    <message>
        <source>Out</source>
        <translation>Poza</translation>
    </message>
    <message>
        <source>, held</source>
        <translation>, wstrz.</translation>
    </message>
    <message>
        <source>, now</source>
        <translation>, teraz</translation>
    </message>
    <message>
        <source>good %1 of %2</source>
        <translation>dobre %1 z %2</translation>
    </message>
    <message>
        <source>Last rails: %1</source>
        <translation>Ostatnie szyny: %1</translation>
    </message>
    <message>
        <source>Last rails</source>
        <translation>Ostatnie</translation>
    </message>
</context>
<context>
    <name>vignole::MainWindow</name>
    <message>
        <source>Is this rail good?</source>
        <translation>Czy ta szyna jest dobra?</translation>
    </message>
    <message>
        <source>The large word is the verdict of the rail so far; beside it stands whether the gauge can be trusted. Both are made for two metres&apos; distance.</source>
        <translation>Duże słowo to dotychczasowa ocena szyny; obok widać, czy przyrządowi można ufać. Oba czyta się z dwóch metrów.</translation>
    </message>
    <message>
        <source>The measured profile</source>
        <translation>Zmierzony przekrój</translation>
    </message>
    <message>
        <source>The rail as it is measured, over its section; deviations are drawn twenty times larger. Keys 1 to 4 show whole, head, web and foot, + and − change the magnification, C colours by camera.</source>
        <translation>Szyna zmierzona na tle profilu; odchyłki narysowano dwudziestokrotnie większe. Klawisze 1–4 pokazują całość, główkę, szyjkę i stopkę; + i − zmieniają powiększenie; C koloruje wg kamery.</translation>
    </message>
    <message>
        <source>Every dimension</source>
        <translation>Każdy wymiar</translation>
    </message>
    <message>
        <source>Value, deviation, uncertainty and where it lies in its tolerance; the hatched ends are closer to a limit than the uncertainty. Choose a row to see the dimension in the drawing.</source>
        <translation>Wartość, odchyłka, niepewność i położenie w tolerancji; zakreskowane końce są bliżej granicy niż niepewność. Wybierz wiersz, by zobaczyć wymiar na rysunku.</translation>
    </message>
    <message>
        <source>What runs</source>
        <translation>Co pracuje</translation>
    </message>
    <message>
        <source>The line, the rail and who is here. SIMULATION: without a site the rails come from a virtual rig, measured by the real engine.</source>
        <translation>Linia, szyna i kto tu jest. SYMULACJA: bez zakładu szyny pochodzą z układu wirtualnego, mierzone prawdziwym silnikiem.</translation>
    </message>
    <message>
        <source>Ten pages</source>
        <translation>Dziesięć stron</translation>
    </message>
    <message>
        <source>F1 to F10, in this order: rails that passed are on F4, alarms on F8, language, units and people on F10. Ctrl+R stops and starts the line.</source>
        <translation>F1–F10, w tej kolejności: przeszłe szyny na F4, alarmy na F8, język, jednostki i osoby na F10. Ctrl+R zatrzymuje i uruchamia linię.</translation>
    </message>
    <message>
        <source>Close Vignole</source>
        <translation>Zamknij Vignole</translation>
    </message>
    <message>
        <source>A rail is being measured.</source>
        <translation>Trwa pomiar szyny.</translation>
    </message>
    <message>
        <source>What has been measured of it is kept; the rest would pass unmeasured.</source>
        <translation>To, co zmierzono, zostaje; reszta przejechałaby bez pomiaru.</translation>
    </message>
    <message>
        <source>Close after this rail</source>
        <translation>Zamknij po tej szynie</translation>
    </message>
    <message>
        <source>Close now</source>
        <translation>Zamknij teraz</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Zostań</translation>
    </message>
</context>
<context>
    <name>vignole::MonitorPage</name>
    <message>
        <source>Whole</source>
        <translation>Całość</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Główka</translation>
    </message>
    <message>
        <source>Web</source>
        <translation>Szyjka</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Stopka</translation>
    </message>
    <message>
        <source>View: %1</source>
        <translation>Widok: %1</translation>
    </message>
    <message>
        <source>%1 of the section (%2)</source>
        <translation>%1, część profilu (%2)</translation>
    </message>
    <message>
        <source>Magnify deviations less</source>
        <translation>Mniej powiększaj odchyłki</translation>
    </message>
    <message>
        <source>Magnify deviations less (−)</source>
        <translation>Mniej powiększaj odchyłki (−)</translation>
    </message>
    <message>
        <source>Deviations are drawn so many times larger (0: back to 20)</source>
        <translation>Tyle razy większe rysuje się odchyłki (0: powrót do 20)</translation>
    </message>
    <message>
        <source>Magnify deviations more</source>
        <translation>Bardziej powiększaj odchyłki</translation>
    </message>
    <message>
        <source>Magnify deviations more (+)</source>
        <translation>Bardziej powiększaj odchyłki (+)</translation>
    </message>
    <message>
        <source>By camera</source>
        <translation>Wg kamery</translation>
    </message>
    <message>
        <source>Colour points by camera</source>
        <translation>Koloruj punkty według kamery</translation>
    </message>
    <message>
        <source>Colour points by camera (C)</source>
        <translation>Koloruj punkty według kamery (C)</translation>
    </message>
    <message>
        <source>Drawing in full view</source>
        <translation>Rysunek w pełnym widoku</translation>
    </message>
    <message>
        <source>Drawing in full view (F11)</source>
        <translation>Rysunek w pełnym widoku (F11)</translation>
    </message>
    <message>
        <source>Stop line</source>
        <translation>Zatrzymaj</translation>
    </message>
    <message>
        <source>Start line</source>
        <translation>Uruchom</translation>
    </message>
    <message>
        <source>%1 (Ctrl+R)</source>
        <translation>%1 (Ctrl+R)</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>brak</translation>
    </message>
</context>
<context>
    <name>vignole::NextRailDialog</name>
    <message>
        <source>Next rail</source>
        <translation>Następna szyna</translation>
    </message>
    <message>
        <source>What is entered here goes with the next rail that begins. An empty field stays as the line has it.</source>
        <translation>Wpisane tu dane dotyczą następnej szyny. Puste pole zostaje takie, jak podaje linia.</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Szyna</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Wytop</translation>
    </message>
    <message>
        <source>Strand</source>
        <translation>Żyła</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Zlecenie</translation>
    </message>
    <message>
        <source>Temperature, °C</source>
        <translation>Temperatura, °C</translation>
    </message>
    <message>
        <source>For the next rail</source>
        <translation>Dla następnej szyny</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Wycofaj</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Waits for the next rail.</source>
        <translation>Czeka na następną szynę.</translation>
    </message>
    <message>
        <source>%1 waits for the next rail.</source>
        <translation>%1 czeka na następną szynę.</translation>
    </message>
    <message>
        <source>The rail has begun with what was entered.</source>
        <translation>Szyna rozpoczęła się z wpisanymi danymi.</translation>
    </message>
    <message>
        <source>The temperature is no number from %1 to %2 °C.</source>
        <translation>Temperatura nie jest liczbą od %1 do %2 °C.</translation>
    </message>
    <message>
        <source>Nothing was entered: fill in at least one field.</source>
        <translation>Nic nie wpisano: wypełnij co najmniej jedno pole.</translation>
    </message>
    <message>
        <source>Nothing waits: the next rail is named by the line.</source>
        <translation>Nic nie czeka: następną szynę nazwie linia.</translation>
    </message>
</context>
<context>
    <name>vignole::PeoplePanel</name>
    <message>
        <source>People</source>
        <translation>Osoby</translation>
    </message>
    <message>
        <source>Names and roles are the administrator&apos;s: sign in as administrator to see and enter people.</source>
        <translation>Nazwami i rolami zarządza administrator: zaloguj się jako administrator, by zobaczyć i wpisać osoby.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rola</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Last here</source>
        <translation>Ostatnio</translation>
    </message>
    <message>
        <source>People who may sign in</source>
        <translation>Osoby mogące się zalogować</translation>
    </message>
    <message>
        <source>Name of the new person</source>
        <translation>Nazwa nowej osoby</translation>
    </message>
    <message>
        <source>First or new password</source>
        <translation>Pierwsze lub nowe hasło</translation>
    </message>
    <message>
        <source>First password of the new person</source>
        <translation>Pierwsze hasło nowej osoby</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>Reason for entering the person</source>
        <translation>Powód wpisu</translation>
    </message>
    <message>
        <source>Role of the new person</source>
        <translation>Rola nowej osoby</translation>
    </message>
    <message>
        <source>Enter a person</source>
        <translation>Wpisz osobę</translation>
    </message>
    <message>
        <source>Give a new password</source>
        <translation>Nadaj nowe hasło</translation>
    </message>
    <message>
        <source>Give the chosen person a new password</source>
        <translation>Nadaj nowe hasło wybranej osobie</translation>
    </message>
    <message>
        <source>Give this role</source>
        <translation>Nadaj tę rolę</translation>
    </message>
    <message>
        <source>Give the chosen person this role</source>
        <translation>Nadaj tę rolę wybranej osobie</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>zamknięte</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>zablokowane</translation>
    </message>
    <message>
        <source>chooses a password</source>
        <translation>wybiera hasło</translation>
    </message>
    <message>
        <source>open</source>
        <translation>otwarte</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nigdy</translation>
    </message>
    <message>
        <source>Open the account</source>
        <translation>Otwórz konto</translation>
    </message>
    <message>
        <source>Close the account</source>
        <translation>Zamknij konto</translation>
    </message>
    <message>
        <source>Open the account of the chosen person</source>
        <translation>Otwórz konto wybranej osoby</translation>
    </message>
    <message>
        <source>Close the account of the chosen person</source>
        <translation>Zamknij konto wybranej osoby</translation>
    </message>
    <message>
        <source>%1 is entered.</source>
        <translation>Wpisano: %1.</translation>
    </message>
    <message>
        <source>%1 has a new password and chooses another at the next sign-in.</source>
        <translation>%1 ma nowe hasło i wybierze inne przy następnym logowaniu.</translation>
    </message>
    <message>
        <source>%1 is now %2.</source>
        <translation>%1 to teraz %2.</translation>
    </message>
    <message>
        <source>The account of %1 is closed.</source>
        <translation>Konto %1 jest zamknięte.</translation>
    </message>
    <message>
        <source>The account of %1 is open.</source>
        <translation>Konto %1 jest otwarte.</translation>
    </message>
</context>
<context>
    <name>vignole::PipelinePanel</name>
    <message>
        <source>Pipeline: %1 triggers, %2 measured, %3 incomplete, %4 lost</source>
        <translation>Tor: wyzwolenia %1, zmierzone %2, niepełne %3, utracone %4</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>brak danych</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>SD %1   UCL %2</source>
        <translation>OS %1   GGP %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>Acquisition</source>
        <translation>Akwizycja</translation>
    </message>
    <message>
        <source>Line extraction</source>
        <translation>Ekstrakcja linii</translation>
    </message>
    <message>
        <source>2D to 3D</source>
        <translation>2D na 3D</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Przekrój</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Pomiar</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>mean time of a stage, SD standard deviation, UCL upper limit of the 99 % confidence interval; of a queue now (dark), highest fill (mark) and size</source>
        <translation>średni czas etapu, OS odchylenie standardowe, GGP górna granica przedziału ufności 99 %; kolejki: teraz (ciemne), najwyższe wypełnienie (znak) i rozmiar</translation>
    </message>
</context>
<context>
    <name>vignole::ProfileCanvas</name>
    <message>
        <source>Measured profile over the section</source>
        <translation>Zmierzony przekrój na tle profilu</translation>
    </message>
    <message>
        <source>last profile at %1 m, %2 ago</source>
        <translation>ostatni przekrój na %1 m, %2 temu</translation>
    </message>
</context>
<context>
    <name>vignole::QualityPage</name>
    <message>
        <source>Repeatability</source>
        <translation>Powtarzalność</translation>
    </message>
    <message>
        <source>runs of the same rail</source>
        <translation>przejazdy tej samej szyny</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Przejazd</translation>
    </message>
    <message>
        <source>Length, m</source>
        <translation>Długość, m</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Zmierzone</translation>
    </message>
    <message>
        <source>Rails that may be laid over each other</source>
        <translation>Szyny, które można nałożyć na siebie</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Wymiar</translation>
    </message>
    <message>
        <source>Single profiles</source>
        <translation>Pojedyncze przekroje</translation>
    </message>
    <message>
        <source>Means over 0.1 m</source>
        <translation>Średnie z 0,1 m</translation>
    </message>
    <message>
        <source>Means over 1 m</source>
        <translation>Średnie z 1 m</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>Co się porównuje</translation>
    </message>
    <message>
        <source>Compare the chosen runs</source>
        <translation>Porównaj wybrane przejazdy</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Eksport…</translation>
    </message>
    <message>
        <source>Export values and ranges as CSV</source>
        <translation>Eksport wartości i rozstępów do CSV</translation>
    </message>
    <message>
        <source>Values over the length</source>
        <translation>Wartości na długości</translation>
    </message>
    <message>
        <source>as Fig. 9a</source>
        <translation>jak rys. 9a</translation>
    </message>
    <message>
        <source>Range of the runs</source>
        <translation>Rozstęp przejazdów</translation>
    </message>
    <message>
        <source>as Fig. 9b</source>
        <translation>jak rys. 9b</translation>
    </message>
    <message>
        <source>Values of every run over the length</source>
        <translation>Wartości każdego przejazdu na długości</translation>
    </message>
    <message>
        <source>Range of the runs over the length</source>
        <translation>Rozstęp przejazdów na długości</translation>
    </message>
    <message>
        <source>Mean range</source>
        <translation>Średni rozstęp</translation>
    </message>
    <message>
        <source>per 10 m, as Table VI</source>
        <translation>na 10 m, jak tab. VI</translation>
    </message>
    <message>
        <source>From – to, m</source>
        <translation>Od – do, m</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Miejsca</translation>
    </message>
    <message>
        <source>Mean range, section by section</source>
        <translation>Średni rozstęp, odcinek po odcinku</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Liczby</translation>
    </message>
    <message>
        <source>Figures of the study</source>
        <translation>Liczby z badania</translation>
    </message>
    <message>
        <source>Runs come from the archive, and there is none: %1. Start the program with --archive FILE.</source>
        <translation>Przejazdy pochodzą z archiwum, a go nie ma: %1. Uruchomić program z --archive FILE.</translation>
    </message>
    <message>
        <source>At least 2 runs of the same rail are needed, %1 chosen; the paper took 5.</source>
        <translation>Potrzeba co najmniej 2 przejazdów tej samej szyny, wybrano %1; w artykule było 5.</translation>
    </message>
    <message>
        <source>reading …</source>
        <translation>odczyt …</translation>
    </message>
    <message>
        <source>No rail has been kept yet. Runs of the same rail are compared here.</source>
        <translation>Nie zachowano jeszcze szyny. Tu porównuje się przejazdy tej samej szyny.</translation>
    </message>
    <message>
        <source>Tick the runs that were made of the same rail, choose a dimension and compare.</source>
        <translation>Zaznacz przejazdy tej samej szyny, wybierz wymiar i porównaj.</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>długość, m</translation>
    </message>
    <message>
        <source>range</source>
        <translation>rozstęp</translation>
    </message>
    <message>
        <source>range, %1</source>
        <translation>rozstęp, %1</translation>
    </message>
    <message>
        <source>Runs, positions</source>
        <translation>Przejazdy, miejsca</translation>
    </message>
    <message>
        <source>Repeatability s_r</source>
        <translation>Powtarzalność s_r</translation>
    </message>
    <message>
        <source>its 95 % interval</source>
        <translation>jej przedział 95 %</translation>
    </message>
    <message>
        <source>Limit r = 2.8 s_r</source>
        <translation>Granica r = 2,8 s_r</translation>
    </message>
    <message>
        <source>Largest range</source>
        <translation>Największy rozstęp</translation>
    </message>
    <message>
        <source>s from the range</source>
        <translation>s z rozstępu</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autokorelacja</translation>
    </message>
    <message>
        <source>%1, critical %2 (1 %)</source>
        <translation>%1, krytyczna %2 (1 %)</translation>
    </message>
    <message>
        <source>Grubbs, means of the runs</source>
        <translation>Grubbs, średnie przejazdów</translation>
    </message>
    <message>
        <source>Cochran, scatter of the runs</source>
        <translation>Cochran, rozrzut przejazdów</translation>
    </message>
    <message>
        <source>, %1 positions left out: a run lacks them</source>
        <translation>, pominięto miejsca: %1 (brak w przejeździe)</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Eksport do CSV</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>Zapisano %1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>Nie można zapisać %1</translation>
    </message>
</context>
<context>
    <name>vignole::RailBand</name>
    <message>
        <source>Place along the rail</source>
        <translation>Miejsce wzdłuż szyny</translation>
    </message>
</context>
<context>
    <name>vignole::RailsPage</name>
    <message>
        <source>Rails</source>
        <translation>Szyny</translation>
    </message>
    <message>
        <source>Rail or heat, from its beginning</source>
        <translation>Szyna lub wytop, od początku</translation>
    </message>
    <message>
        <source>Search by rail or heat</source>
        <translation>Szukaj po szynie lub wytopie</translation>
    </message>
    <message>
        <source>Any verdict</source>
        <translation>Dowolna ocena</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>Poza tolerancją</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>Przy granicy</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>W normie</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Nie zmierzono</translation>
    </message>
    <message>
        <source>Any dimension</source>
        <translation>Dowolny wymiar</translation>
    </message>
    <message>
        <source>%1 out</source>
        <translation>%1 poza</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Ocena</translation>
    </message>
    <message>
        <source>Dimension out of tolerance</source>
        <translation>Wymiar poza tolerancją</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Szyna</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Wytop</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Najgorszy</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Czas</translation>
    </message>
    <message>
        <source>Rails found</source>
        <translation>Znalezione szyny</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Raport…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Eksport…</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Raport PDF</translation>
    </message>
    <message>
        <source>Report as PDF (Ctrl+P)</source>
        <translation>Raport PDF (Ctrl+P)</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Wróć na żywo</translation>
    </message>
    <message>
        <source>Along the rail</source>
        <translation>Wzdłuż szyny</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>Przekroczenia</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Wymiar</translation>
    </message>
    <message>
        <source>From – to, m</source>
        <translation>Od – do, m</translation>
    </message>
    <message>
        <source>Worst, mm</source>
        <translation>Najgorszy, mm</translation>
    </message>
    <message>
        <source>Limits, mm</source>
        <translation>Granice, mm</translation>
    </message>
    <message>
        <source>Stretches out of tolerance</source>
        <translation>Odcinki poza tolerancją</translation>
    </message>
    <message>
        <source>Previous exception</source>
        <translation>Poprzednie przekroczenie</translation>
    </message>
    <message>
        <source>Previous exception (Shift+N)</source>
        <translation>Poprzednie przekroczenie (Shift+N)</translation>
    </message>
    <message>
        <source>Next exception</source>
        <translation>Następne przekroczenie</translation>
    </message>
    <message>
        <source>Next exception (N)</source>
        <translation>Następne przekroczenie (N)</translation>
    </message>
    <message>
        <source>Play along the rail</source>
        <translation>Odtwarzaj wzdłuż szyny</translation>
    </message>
    <message>
        <source>Play or pause (P)</source>
        <translation>Odtwarzaj lub wstrzymaj (P)</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Przekrój</translation>
    </message>
    <message>
        <source>No rail is open</source>
        <translation>Nie otwarto szyny</translation>
    </message>
    <message>
        <source>Choose a rail in the list: its profile, its dimensions along the rail and its exceptions are shown here.</source>
        <translation>Wybierz szynę z listy: tu pojawią się jej przekrój, wymiary wzdłuż szyny i przekroczenia.</translation>
    </message>
    <message>
        <source>Rails are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>Szyny nie są zachowywane: %1. Uruchomić program z archiwum (--archive FILE).</translation>
    </message>
    <message>
        <source>running</source>
        <translation>trwa</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>w granicach</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>No rail is like that. Clear the search or choose other filters.</source>
        <translation>Żadna szyna nie pasuje. Wyczyść wyszukiwanie lub wybierz inne filtry.</translation>
    </message>
    <message>
        <source>No rail has been measured yet. Rails appear here when they have passed.</source>
        <translation>Nie zmierzono jeszcze szyny. Szyny pojawiają się tu po przejeździe.</translation>
    </message>
    <message>
        <source>Replay: not live.  Rail %1, %2 to %3, recipe %4, calibration %5</source>
        <translation>Odtwarzanie: nie na żywo.  Szyna %1, %2 do %3, receptura %4, kalibracja %5</translation>
    </message>
    <message>
        <source>none: every dimension stayed within its limits</source>
        <translation>brak: każdy wymiar w granicach</translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es)</source>
        <translation>
            <numerusform>%n odcinek</numerusform>
            <numerusform>%n odcinki</numerusform>
            <numerusform>%n odcinków</numerusform>
        </translation>
    </message>
    <message>
        <source>The profile cannot be drawn: %1.</source>
        <translation>Nie można narysować przekroju: %1.</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Profile at %1 m</source>
        <translation>Przekrój na %1 m</translation>
    </message>
    <message>
        <source>no. %1 of %2</source>
        <translation>nr %1 z %2</translation>
    </message>
    <message>
        <source>: points were not kept of this rail, the model is shown</source>
        <translation>: punktów tej szyny nie zachowano, pokazano model</translation>
    </message>
    <message>
        <source>; drawn is no. %1, the nearest whose points were kept</source>
        <translation>; narysowano nr %1, najbliższy z zachowanymi punktami</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>writing %1 …</source>
        <translation>zapis %1 …</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>Zapisano %1</translation>
    </message>
    <message>
        <source>Any time</source>
        <translation>Dowolny czas</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Dziś</translation>
    </message>
    <message>
        <source>7 days</source>
        <translation>7 dni</translation>
    </message>
    <message>
        <source>4 weeks</source>
        <translation>4 tygodnie</translation>
    </message>
    <message>
        <source>12 months</source>
        <translation>12 miesięcy</translation>
    </message>
    <message>
        <source>Any section</source>
        <translation>Dowolny profil</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Wyczyść</translation>
    </message>
    <message>
        <source>Clear search and filters</source>
        <translation>Wyczyść wyszukiwanie i filtry</translation>
    </message>
    <message>
        <source>What if…</source>
        <translation>Co jeśli…</translation>
    </message>
    <message>
        <source>Judge the rails found with other limits</source>
        <translation>Oceń znalezione szyny innymi granicami</translation>
    </message>
    <message>
        <source>Next rail…</source>
        <translation>Następna szyna…</translation>
    </message>
    <message>
        <source>Enter the papers of the next rail</source>
        <translation>Wpisz dane następnej szyny</translation>
    </message>
    <message>
        <source>Export as CSV or JSON</source>
        <translation>Eksport do CSV lub JSON</translation>
    </message>
    <message>
        <source>Export as CSV or JSON (Ctrl+E)</source>
        <translation>Eksport do CSV lub JSON (Ctrl+E)</translation>
    </message>
    <message>
        <source>Nothing new is kept: nobody writes into this archive.</source>
        <translation>Nic nowego nie jest zachowywane: nikt nie pisze do tego archiwum.</translation>
    </message>
    <message>
        <source>Nothing is kept. Live rails are shown on Monitor only.</source>
        <translation>Nic nie jest zachowywane. Bieżące szyny widać tylko na Monitorze.</translation>
    </message>
    <message>
        <source>kept: %1 rails, %2 profiles waiting</source>
        <translation>zachowane szyny: %1, oczekujące przekroje: %2</translation>
    </message>
    <message>
        <source>; %1 profiles lost</source>
        <translation>; utracone przekroje: %1</translation>
    </message>
    <message>
        <source>; points of %1 profiles left out</source>
        <translation>; pominięto punkty przekrojów: %1</translation>
    </message>
    <message>
        <source>Nothing can be written: %1. What passes waits in memory.</source>
        <translation>Nie można zapisywać: %1. Przejazdy czekają w pamięci.</translation>
    </message>
</context>
<context>
    <name>vignole::RateChart</name>
    <message>
        <source>Alarms in each ten minutes of the last %1 hours: at most %2</source>
        <translation>Alarmy na dziesięć minut z ostatnich %1 godzin: najwyżej %2</translation>
    </message>
    <message>
        <source>flood above %1</source>
        <translation>lawina powyżej %1</translation>
    </message>
    <message>
        <source>hours; dotted at %1: target</source>
        <translation>godziny; kropki przy %1: cel</translation>
    </message>
</context>
<context>
    <name>vignole::RecipesPage</name>
    <message>
        <source>Draft</source>
        <translation>Szkic</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>Zatwierdzona</translation>
    </message>
    <message>
        <source>Retired</source>
        <translation>Wycofana</translation>
    </message>
    <message>
        <source>With the program</source>
        <translation>Z programem</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Receptury</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Receptura</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Wersja</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Recipes and their versions</source>
        <translation>Receptury i ich wersje</translation>
    </message>
    <message>
        <source>Section of the new recipe</source>
        <translation>Profil nowej receptury</translation>
    </message>
    <message>
        <source>Profile and straightness class of the new recipe</source>
        <translation>Klasa profilu i prostości nowej receptury</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nowa</translation>
    </message>
    <message>
        <source>New draft from section and class</source>
        <translation>Nowy szkic z profilu i klasy</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Import…</translation>
    </message>
    <message>
        <source>Import a recipe file as a draft</source>
        <translation>Import pliku receptury jako szkicu</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Eksport…</translation>
    </message>
    <message>
        <source>Export the chosen recipe</source>
        <translation>Eksport wybranej receptury</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Wymiar</translation>
    </message>
    <message>
        <source>Nominal, mm</source>
        <translation>Nominał, mm</translation>
    </message>
    <message>
        <source>Lower, mm</source>
        <translation>Dolna, mm</translation>
    </message>
    <message>
        <source>Upper, mm</source>
        <translation>Górna, mm</translation>
    </message>
    <message>
        <source>Tolerances of the chosen recipe</source>
        <translation>Tolerancje wybranej receptury</translation>
    </message>
    <message>
        <source>What is new in it</source>
        <translation>Co nowego</translation>
    </message>
    <message>
        <source>What is new in the draft</source>
        <translation>Co nowego w szkicu</translation>
    </message>
    <message>
        <source>Save as a new draft</source>
        <translation>Zapisz jako nowy szkic</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Różnica</translation>
    </message>
    <message>
        <source>Recipe to compare with</source>
        <translation>Receptura do porównania</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Co</translation>
    </message>
    <message>
        <source>There</source>
        <translation>Tam</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Tu</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Co się różni</translation>
    </message>
    <message>
        <source>Approval</source>
        <translation>Zatwierdzenie</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>Reason for the approval</source>
        <translation>Powód zatwierdzenia</translation>
    </message>
    <message>
        <source>Your password</source>
        <translation>Twoje hasło</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Zatwierdź</translation>
    </message>
    <message>
        <source>Approve the draft</source>
        <translation>Zatwierdź szkic</translation>
    </message>
    <message>
        <source>against %1 v%2, %3</source>
        <translation>wobec %1 v%2, %3</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolerancje</translation>
    </message>
    <message>
        <source>%1 v%2</source>
        <translation>%1 v%2</translation>
    </message>
    <message>
        <source>%1, by %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Both are the same.</source>
        <translation>Obie są takie same.</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n wartość</numerusform>
            <numerusform>%n wartości</numerusform>
            <numerusform>%n wartości</numerusform>
        </translation>
    </message>
    <message>
        <source>Only a draft is approved.</source>
        <translation>Zatwierdza się tylko szkic.</translation>
    </message>
    <message>
        <source>QA approves: sign in.</source>
        <translation>Zatwierdza kontrola: zaloguj się.</translation>
    </message>
    <message>
        <source>This draft is yours: somebody else approves it.</source>
        <translation>To twój szkic: zatwierdza go ktoś inny.</translation>
    </message>
    <message>
        <source>Approval retires the version before; reason and password go with your name into the audit trail.</source>
        <translation>Zatwierdzenie wycofuje poprzednią wersję; powód i nazwa trafiają do śladu audytowego, potwierdzone hasłem.</translation>
    </message>
    <message>
        <source>%1 v%2 is kept as a draft.</source>
        <translation>%1 v%2 zachowano jako szkic.</translation>
    </message>
    <message>
        <source>%1: the lower limit lies above the upper one; exchange them.</source>
        <translation>%1: granica dolna leży nad górną; zamień je.</translation>
    </message>
    <message>
        <source>%1: a limit is a number in mm, or empty for none.</source>
        <translation>%1: granica to liczba w mm albo puste pole.</translation>
    </message>
    <message>
        <source>Say what is new in the draft.</source>
        <translation>Podaj, co nowego w szkicu.</translation>
    </message>
    <message>
        <source>Approved.</source>
        <translation>Zatwierdzono.</translation>
    </message>
    <message>
        <source>Import a recipe file</source>
        <translation>Import pliku receptury</translation>
    </message>
    <message>
        <source>Export the recipe</source>
        <translation>Eksport receptury</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>Zapisano %1</translation>
    </message>
</context>
<context>
    <name>vignole::ReplayCanvas</name>
    <message>
        <source>Profile of the stored rail</source>
        <translation>Przekrój zapisanej szyny</translation>
    </message>
</context>
<context>
    <name>vignole::SettingsPage</name>
    <message>
        <source>Screen</source>
        <translation>Ekran</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Motyw</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Długości</translation>
    </message>
    <message>
        <source>Unit of lengths</source>
        <translation>Jednostka długości</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Jasny</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Ciemny</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Milimetry</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Cale</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Osoby</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiwum</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kamery</translation>
    </message>
    <message>
        <source>No site is configured: the four cameras are those of the virtual rig, and every page says SIMULATION. Cameras with GigE Vision are not part of this version.</source>
        <translation>Nie skonfigurowano zakładu: cztery kamery należą do układu wirtualnego, a każda strona mówi SYMULACJA. Kamery GigE Vision nie należą do tej wersji.</translation>
    </message>
    <message>
        <source>About</source>
        <translation>O programie</translation>
    </message>
    <message>
        <source>Vignole %1: rail profiles in millimetres, with their uncertainty. Licence GPL-3.0-or-later.</source>
        <translation>Vignole %1: profile szyn w milimetrach, z ich niepewnością. Licencja GPL-3.0-or-later.</translation>
    </message>
    <message>
        <source>There is none: %1. Rails are measured and not kept. Start the program with --archive FILE.</source>
        <translation>Brak: %1. Szyny są mierzone, lecz niezachowywane. Uruchomić program z --archive FILE.</translation>
    </message>
    <message>
        <source>%1
%2 rails are kept.</source>
        <translation>%1
Zachowane szyny: %2.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Język</translation>
    </message>
    <message>
        <source>Language of the screen</source>
        <translation>Język ekranu</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ustawienia</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>Grupy ustawień</translation>
    </message>
    <message>
        <source>Who is here</source>
        <translation>Kto tu jest</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>Ślad audytowy</translation>
    </message>
    <message>
        <source>of this machine; kept for the next start</source>
        <translation>tego komputera; zachowane do następnego startu</translation>
    </message>
    <message>
        <source>Show the tour</source>
        <translation>Pokaż przewodnik</translation>
    </message>
    <message>
        <source>Show the tour of Monitor</source>
        <translation>Pokaż przewodnik po Monitorze</translation>
    </message>
</context>
<context>
    <name>vignole::SignInPanel</name>
    <message>
        <source>Who is here</source>
        <translation>Kto tu jest</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Hasło</translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation>Wyloguj</translation>
    </message>
    <message>
        <source>Enter as the first administrator</source>
        <translation>Wpisz pierwszego administratora</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Zaloguj</translation>
    </message>
    <message>
        <source>Nobody can sign in: people are kept in the archive, and there is none (%1).</source>
        <translation>Nikt nie może się zalogować: osoby są w archiwum, a go nie ma (%1).</translation>
    </message>
    <message>
        <source>After a quarter of an hour without a key or a touch it is the operator&apos;s screen again.</source>
        <translation>Po kwadransie bez klawisza i dotyku ekran wraca do operatora.</translation>
    </message>
    <message>
        <source>Nobody is entered yet. The first one is the administrator and enters the others; the password has at least 8 characters.</source>
        <translation>Nikogo jeszcze nie wpisano. Pierwsza osoba jest administratorem i wpisuje pozostałe; hasło ma co najmniej 8 znaków.</translation>
    </message>
    <message>
        <source>Without signing in this is the operator&apos;s screen: it measures, shows and acknowledges.</source>
        <translation>Bez logowania to ekran operatora: mierzy, pokazuje i potwierdza.</translation>
    </message>
    <message>
        <source>Name and password are both needed.</source>
        <translation>Potrzebne są nazwa i hasło.</translation>
    </message>
    <message>
        <source>Name or password is wrong.</source>
        <translation>Nazwa lub hasło jest błędne.</translation>
    </message>
    <message>
        <source>This account is closed; ask the administrator.</source>
        <translation>To konto jest zamknięte; zapytaj administratora.</translation>
    </message>
    <message>
        <source>Too many wrong passwords: locked until %1.</source>
        <translation>Zbyt wiele błędnych haseł: blokada do %1.</translation>
    </message>
    <message>
        <source>New password, at least 8 characters</source>
        <translation>Nowe hasło, co najmniej 8 znaków</translation>
    </message>
    <message>
        <source>New password</source>
        <translation>Nowe hasło</translation>
    </message>
    <message>
        <source>Change the password</source>
        <translation>Zmień hasło</translation>
    </message>
    <message>
        <source>Present password</source>
        <translation>Obecne hasło</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>This password was given by somebody else: choose one of your own.</source>
        <translation>To hasło nadał ktoś inny: wybierz własne.</translation>
    </message>
    <message>
        <source>The password is changed.</source>
        <translation>Hasło zmieniono.</translation>
    </message>
    <message>
        <source>The password is changed: sign in with it.</source>
        <translation>Hasło zmieniono: zaloguj się nim.</translation>
    </message>
</context>
<context>
    <name>vignole::StripChart</name>
    <message>
        <source>%1 along the rail: %2</source>
        <translation>%1 wzdłuż szyny: %2</translation>
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
        <translation>jasność wzdłuż linii</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <source>Saturated</source>
        <translation>Przesycone</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Szum</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Kawałki</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Średnia</translation>
    </message>
    <message>
        <source>trigger %1</source>
        <translation>wyzw. %1</translation>
    </message>
    <message>
        <source>no picture yet</source>
        <translation>jeszcze brak obrazu</translation>
    </message>
</context>
<context>
    <name>vignole::StripesPage</name>
    <message>
        <source>Line extraction</source>
        <translation>Ekstrakcja linii</translation>
    </message>
    <message>
        <source>Smoothing σ</source>
        <translation>Wygładzanie σ</translation>
    </message>
    <message>
        <source>Low threshold t_l</source>
        <translation>Próg dolny t_l</translation>
    </message>
    <message>
        <source>High threshold t_h</source>
        <translation>Próg górny t_h</translation>
    </message>
    <message>
        <source>Link distance d</source>
        <translation>Odległość łączenia d</translation>
    </message>
    <message>
        <source>Link angle α</source>
        <translation>Kąt łączenia α</translation>
    </message>
    <message>
        <source>%1 on trial</source>
        <translation>%1 na próbę</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>W użyciu</translation>
    </message>
    <message>
        <source>On trial</source>
        <translation>Na próbę</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Różnica</translation>
    </message>
    <message>
        <source>In use against on trial</source>
        <translation>W użyciu a na próbę</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Zapisz obraz…</translation>
    </message>
    <message>
        <source>Save the picture of the chosen camera</source>
        <translation>Zapisz obraz wybranej kamery</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Odrzuć</translation>
    </message>
    <message>
        <source>Discard what is on trial</source>
        <translation>Odrzuć próbę</translation>
    </message>
    <message>
        <source>Use from next start</source>
        <translation>Użyj od nast. startu</translation>
    </message>
    <message>
        <source>Use what is on trial from the next start of the line</source>
        <translation>Użyj próby od następnego startu linii</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>Reason for the change</source>
        <translation>Powód zmiany</translation>
    </message>
    <message>
        <source>Live again</source>
        <translation>Znów na żywo</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Zamroź</translation>
    </message>
    <message>
        <source>Freeze the pictures</source>
        <translation>Zamroź obrazy</translation>
    </message>
    <message>
        <source>Freeze the pictures (P)</source>
        <translation>Zamroź obrazy (P)</translation>
    </message>
    <message>
        <source>What is tried acts on these pictures alone until it is applied.</source>
        <translation>Próba działa tylko na te obrazy, dopóki nie zostanie zastosowana.</translation>
    </message>
    <message>
        <source>Anybody may try; a technician who has signed in applies.</source>
        <translation>Próbować może każdy; stosuje zalogowany technik.</translation>
    </message>
    <message>
        <source>lost: %1</source>
        <translation>utracona: %1</translation>
    </message>
    <message>
        <source>held, %1 old</source>
        <translation>wstrzymane, sprzed %1</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>Zamrożone</translation>
    </message>
    <message>
        <source>This source hands out no pictures.</source>
        <translation>To źródło nie udostępnia obrazów.</translation>
    </message>
    <message>
        <source>Nothing is on trial: change a parameter first.</source>
        <translation>Nic na próbę: najpierw zmień parametr.</translation>
    </message>
    <message>
        <source>A change of the measurement needs a reason.</source>
        <translation>Zmiana pomiaru wymaga powodu.</translation>
    </message>
    <message>
        <source>Is used from the next start of the line (Ctrl+R stops and starts it); the running rail keeps what it began with.</source>
        <translation>Obowiązuje od następnego startu linii (Ctrl+R zatrzymuje i uruchamia); bieżąca szyna zachowuje dotychczasowe.</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>kamera %1</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <source>Saturated, %</source>
        <translation>Przesycone, %</translation>
    </message>
    <message>
        <source>Uncertainty, px</source>
        <translation>Niepewność, px</translation>
    </message>
    <message>
        <source>Time, ms</source>
        <translation>Czas, ms</translation>
    </message>
    <message>
        <source>Mean shift, px</source>
        <translation>Średnie przesunięcie, px</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Zapisz obraz</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>Zapisano %1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>Nie można zapisać %1</translation>
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
        <translation>granica dolna %1</translation>
    </message>
    <message>
        <source>upper limit %1</source>
        <translation>granica górna %1</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>oczekiwana %1</translation>
    </message>
</context>
<context>
    <name>vignole::Tour</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Zamknij (Esc)</translation>
    </message>
    <message>
        <source>Close the tour</source>
        <translation>Zamknij przewodnik</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Zaczynaj</translation>
    </message>
</context>
<context>
    <name>vignole::VerdictPanel</name>
    <message>
        <source>Verdict: %1, %2. Gauge: %3</source>
        <translation>Ocena: %1, %2. Przyrząd: %3</translation>
    </message>
    <message>
        <source>Gauge: %1</source>
        <translation>Przyrząd: %1</translation>
    </message>
    <message>
        <source>SIMULATION, %1</source>
        <translation>SYMULACJA, %1</translation>
    </message>
</context>
<context>
    <name>vignole::WhatIfDialog</name>
    <message>
        <source>What if</source>
        <translation>Co jeśli</translation>
    </message>
    <message>
        <source>The rails that were found are judged again with other limits, from what is stored of every profile. Nothing that is stored changes.</source>
        <translation>Znalezione szyny są oceniane ponownie innymi granicami, z zapisów każdego przekroju. Zapisane dane się nie zmieniają.</translation>
    </message>
    <message>
        <source>Profile class</source>
        <translation>Klasa profilu</translation>
    </message>
    <message>
        <source>Straightness class</source>
        <translation>Klasa prostości</translation>
    </message>
    <message>
        <source>As in the recipe</source>
        <translation>Jak w recepturze</translation>
    </message>
    <message>
        <source>lower, %1</source>
        <translation>dolna, %1</translation>
    </message>
    <message>
        <source>upper, %1</source>
        <translation>górna, %1</translation>
    </message>
    <message>
        <source>Lower limit of %1, deviation</source>
        <translation>Granica dolna %1, odchyłka</translation>
    </message>
    <message>
        <source>Upper limit of %1, deviation</source>
        <translation>Granica górna %1, odchyłka</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Szyna</translation>
    </message>
    <message>
        <source>Was</source>
        <translation>Było</translation>
    </message>
    <message>
        <source>Would be</source>
        <translation>Byłoby</translation>
    </message>
    <message>
        <source>Because of</source>
        <translation>Z powodu</translation>
    </message>
    <message>
        <source>Rails whose verdict would change</source>
        <translation>Szyny, których ocena by się zmieniła</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Postęp</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>A limit of %1 is no number. An empty field is no limit.</source>
        <translation>Granica %1 nie jest liczbą. Puste pole to brak granicy.</translation>
    </message>
    <message>
        <source>The lower limit of %1 is above the upper one: exchange them.</source>
        <translation>Granica dolna %1 leży nad górną: zamień je.</translation>
    </message>
    <message>
        <source>%1 of %2 rails judged</source>
        <translation>ocenione szyny: %1 z %2</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Wypróbuj</translation>
    </message>
    <message>
        <source>Stop judging</source>
        <translation>Zatrzymaj ocenę</translation>
    </message>
    <message>
        <source>Judge the rails with these limits</source>
        <translation>Oceń szyny tymi granicami</translation>
    </message>
    <message>
        <source>No rail of this section is in the list. Search for rails first.</source>
        <translation>Na liście nie ma szyn tego profilu. Najpierw wyszukaj szyny.</translation>
    </message>
    <message>
        <source>Judging …</source>
        <translation>Ocenianie …</translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s) of section %1</source>
        <translation>
            <numerusform>%n szyna profilu %1</numerusform>
            <numerusform>%n szyny profilu %1</numerusform>
            <numerusform>%n szyn profilu %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Fewer than %1 rails prove little.</source>
        <translation>Mniej niż %1 szyn niewiele dowodzi.</translation>
    </message>
    <message>
        <source>Choose a class or enter deviations from nominal, then Try. Empty: no limit.</source>
        <translation>Wybierz klasę lub wpisz odchyłki od nominału, potem Wypróbuj. Puste: brak granicy.</translation>
    </message>
    <message>
        <source>%1 of %2 rails would change their verdict</source>
        <translation>ocenę zmieniłyby szyny: %1 z %2</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 z %2 na %3</translation>
    </message>
    <message>
        <source>stopped before all %1 were judged</source>
        <translation>zatrzymano przed oceną wszystkich %1</translation>
    </message>
    <message numerus="yes">
        <source>%n could not be judged: %1</source>
        <translation>
            <numerusform>%n nie można było ocenić: %1</numerusform>
            <numerusform>%n nie można było ocenić: %1</numerusform>
            <numerusform>%n nie można było ocenić: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>fewer than %1 rails prove little</source>
        <translation>mniej niż %1 szyn niewiele dowodzi</translation>
    </message>
</context>
</TS>
