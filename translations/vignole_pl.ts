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
    <message>
        <source>Before registration</source>
        <translation>Przed dopasowaniem</translation>
    </message>
    <message>
        <source>across %1, up %2 %3, turned %4°</source>
        <translation>w poprzek %1, w górę %2 %3, obrót %4°</translation>
    </message>
    <message>
        <source>As seen</source>
        <translation>Jak widziano</translation>
    </message>
    <message>
        <source>Registered</source>
        <translation>Dopasowano</translation>
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
    <name>RecipeSetting</name>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
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
        <source>RFH: distance from the axis, mm</source>
        <translation>RFH: odległość od osi, mm</translation>
    </message>
    <message>
        <source>HF: half width of the crown, mm</source>
        <translation>HF: pół szerokości pow. tocznej, mm</translation>
    </message>
    <message>
        <source>HW: depth below the crown, mm</source>
        <translation>HW: głębokość pod pow. toczną, mm</translation>
    </message>
    <message>
        <source>HWA: the AREMA depth, mm</source>
        <translation>HWA: głębokość AREMA, mm</translation>
    </message>
    <message>
        <source>FT: inside the foot edges, mm</source>
        <translation>FT: od krawędzi stopki w głąb, mm</translation>
    </message>
    <message>
        <source>RAS: depth below the crown, mm</source>
        <translation>RAS: głębokość pod pow. toczną, mm</translation>
    </message>
    <message>
        <source>WT: height, mm (none: thinnest)</source>
        <translation>WT: wysokość, mm (brak: najcieńsza)</translation>
    </message>
    <message>
        <source>Base line: inside the foot edges, mm</source>
        <translation>Linia bazowa: od krawędzi stopki w głąb, mm</translation>
    </message>
    <message>
        <source>Line: smoothing σ, px</source>
        <translation>Linia: wygładzanie σ, px</translation>
    </message>
    <message>
        <source>Line: low threshold, DN</source>
        <translation>Linia: próg dolny, DN</translation>
    </message>
    <message>
        <source>Line: high threshold, DN</source>
        <translation>Linia: próg górny, DN</translation>
    </message>
    <message>
        <source>Line: longest gap bridged, px</source>
        <translation>Linia: największa łączona luka, px</translation>
    </message>
    <message>
        <source>Line: largest angle joined, °</source>
        <translation>Linia: największy łączony kąt, °</translation>
    </message>
    <message>
        <source>Line: shortest kept, points</source>
        <translation>Linia: najkrótsza, punkty</translation>
    </message>
    <message>
        <source>Line: blocks before overload</source>
        <translation>Linia: bloki do przeciążenia</translation>
    </message>
    <message>
        <source>Line: pull of bends taken off</source>
        <translation>Linia: korekcja ściągania na łukach</translation>
    </message>
    <message>
        <source>Registration: scale at first, mm</source>
        <translation>Dopasowanie: skala początkowa, mm</translation>
    </message>
    <message>
        <source>Registration: scale with a start, mm</source>
        <translation>Dopasowanie: skala ze startem, mm</translation>
    </message>
    <message>
        <source>Registration: inlier below, mm</source>
        <translation>Dopasowanie: punkt zgodny poniżej, mm</translation>
    </message>
    <message>
        <source>Registration: points used within, mm</source>
        <translation>Dopasowanie: punkty użyte do, mm</translation>
    </message>
    <message>
        <source>Registration: fails above rms, mm</source>
        <translation>Dopasowanie: błąd powyżej rms, mm</translation>
    </message>
    <message>
        <source>Registration: fails below share</source>
        <translation>Dopasowanie: błąd poniżej udziału</translation>
    </message>
    <message>
        <source>Measuring: ends left out, mm</source>
        <translation>Pomiar: pominięte końce, mm</translation>
    </message>
    <message>
        <source>Measuring: least points</source>
        <translation>Pomiar: najmniej punktów</translation>
    </message>
    <message>
        <source>Measuring: expansion, 1/K</source>
        <translation>Pomiar: rozszerzalność, 1/K</translation>
    </message>
    <message>
        <source>Measuring: hottest rail, °C</source>
        <translation>Pomiar: najgorętsza szyna, °C</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>tak</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>%1: limits, mm</source>
        <translation>%1: granice, mm</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>bez oceny</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>najwyżej %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>co najmniej %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 do %2</translation>
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
    <name>StudyReport</name>
    <message>
        <source>no outlier</source>
        <translation>brak odstających</translation>
    </message>
    <message>
        <source>straggler (5 %)</source>
        <translation>wątpliwa (5 %)</translation>
    </message>
    <message>
        <source>outlier (1 %)</source>
        <translation>odstająca (1 %)</translation>
    </message>
    <message>
        <source>%1: %2, critical %3 at 1 %</source>
        <translation>%1: %2, krytyczna %3 przy 1 %</translation>
    </message>
    <message>
        <source>Mean range of the runs, mm, per %1 m (Table VI)</source>
        <translation>Średni rozstęp przejazdów, mm, na %1 m (tab. VI)</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Wymiar</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>średnia</translation>
    </message>
    <message>
        <source>share of T, %</source>
        <translation>udział w T, %</translation>
    </message>
    <message>
        <source>Errors against the reference, mm (Table V)</source>
        <translation>Błędy względem odniesienia, mm (tab. V)</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>obciąż.</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>największy</translation>
    </message>
    <message>
        <source>largest, %</source>
        <translation>największy, %</translation>
    </message>
    <message>
        <source>E_n above 1</source>
        <translation>E_n powyżej 1</translation>
    </message>
    <message>
        <source>%1: values of the runs</source>
        <translation>%1: wartości przejazdów</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>długość, m</translation>
    </message>
    <message>
        <source>%1: range of the runs</source>
        <translation>%1: rozstęp przejazdów</translation>
    </message>
    <message>
        <source>%1: error at each position</source>
        <translation>%1: błąd w każdym położeniu</translation>
    </message>
    <message>
        <source>mean of the runs</source>
        <translation>średnia przejazdów</translation>
    </message>
    <message>
        <source>No verdict</source>
        <translation>Bez oceny</translation>
    </message>
    <message>
        <source>no dimension has both a tolerance and figures</source>
        <translation>żaden wymiar nie ma jednocześnie tolerancji i liczb</translation>
    </message>
    <message>
        <source>Repeatable</source>
        <translation>Powtarzalny</translation>
    </message>
    <message>
        <source>Not repeatable</source>
        <translation>Niepowtarzalny</translation>
    </message>
    <message>
        <source>%1 uses the largest share of its tolerance, %2; allowed are %3 %</source>
        <translation>%1 zużywa największą część swojej tolerancji, %2; dopuszczalne jest %3 %</translation>
    </message>
    <message>
        <source>uncertainties of values and reference are both needed for E_n; the figures stand by themselves</source>
        <translation>do E_n potrzebne są niepewności wartości i odniesienia; liczby mówią same za siebie</translation>
    </message>
    <message>
        <source>Agrees</source>
        <translation>Zgodny</translation>
    </message>
    <message>
        <source>Does not agree</source>
        <translation>Niezgodny</translation>
    </message>
    <message>
        <source>worst is %1: E n above 1 in %2 of its %3 values; chance allows %4</source>
        <translation>najgorszy jest %1: E n powyżej 1 w %2 z %3 wartości; przypadek dopuszcza %4</translation>
    </message>
    <message>
        <source>Runs and positions</source>
        <translation>Przejazdy i położenia</translation>
    </message>
    <message>
        <source>Repeatability s r</source>
        <translation>Powtarzalność s r</translation>
    </message>
    <message>
        <source>its 95 % interval</source>
        <translation>jej przedział 95 %</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 do %2</translation>
    </message>
    <message>
        <source>Limit r = 2.8 s r</source>
        <translation>Granica r = 2,8 s r</translation>
    </message>
    <message>
        <source>Mean and largest range</source>
        <translation>Rozstęp średni i największy</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 i %2</translation>
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
        <source>Left out: a run lacks them</source>
        <translation>Pominięte: brak ich w przejeździe</translation>
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
        <source>Bias</source>
        <translation>Obciążenie</translation>
    </message>
    <message>
        <source>RMS error</source>
        <translation>Błąd RMS</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>Największy błąd</translation>
    </message>
    <message>
        <source>in % of the reference</source>
        <translation>w % odniesienia</translation>
    </message>
    <message>
        <source>Limits of agreement</source>
        <translation>Granice zgodności</translation>
    </message>
    <message>
        <source>interval of the lower</source>
        <translation>przedział dolnej</translation>
    </message>
    <message>
        <source>interval of the upper</source>
        <translation>przedział górnej</translation>
    </message>
    <message>
        <source>Largest E n</source>
        <translation>Największe E n</translation>
    </message>
    <message>
        <source>E n above 1</source>
        <translation>E n powyżej 1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>Repeatability study</source>
        <translation>Badanie powtarzalności</translation>
    </message>
    <message>
        <source>Accuracy study</source>
        <translation>Badanie dokładności</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Przejazdy</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolerancje</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Wartości</translation>
    </message>
    <message>
        <source>means over %1 m</source>
        <translation>średnie z %1 m</translation>
    </message>
    <message>
        <source>single profiles</source>
        <translation>pojedyncze przekroje</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Odniesienie</translation>
    </message>
    <message>
        <source>Runs: %1.</source>
        <translation>Przejazdy: %1.</translation>
    </message>
    <message>
        <source>Conditions: %1.</source>
        <translation>Warunki: %1.</translation>
    </message>
    <message>
        <source>%1 over the length, as Fig. 9</source>
        <translation>%1 na długości, jak rys. 9</translation>
    </message>
    <message>
        <source>%1 against its reference</source>
        <translation>%1 wobec odniesienia</translation>
    </message>
    <message>
        <source>Figures of %1</source>
        <translation>Liczby dla %1</translation>
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
    <name>vignole::CalibrationDesk</name>
    <message>
        <source>Calibrations are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>Kalibracje nie są zachowywane: %1. Uruchomić program z archiwum (--archive FILE).</translation>
    </message>
    <message>
        <source>Calibrating is the technician&apos;s: sign in as technician or QA (Settings, F10).</source>
        <translation>Kalibruje technik: zaloguj się jako technik lub kontrola (Ustawienia, F10).</translation>
    </message>
    <message>
        <source>There is no archive, so a calibration could neither be kept nor reverted: start the program with --archive FILE.</source>
        <translation>Nie ma archiwum, więc kalibracji nie można by zachować ani cofnąć: uruchomić program z --archive FILE.</translation>
    </message>
    <message>
        <source>Another calibration needs a reason.</source>
        <translation>Inna kalibracja wymaga powodu.</translation>
    </message>
</context>
<context>
    <name>vignole::CalibrationOverview</name>
    <message>
        <source>In force</source>
        <translation>Obowiązuje</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibruj</translation>
    </message>
    <message>
        <source>What it is worth</source>
        <translation>Ile jest warta</translation>
    </message>
    <message>
        <source>Calibrations kept</source>
        <translation>Zachowane kalibracje</translation>
    </message>
    <message>
        <source>choose one to compare it with the one in force</source>
        <translation>wybierz jedną, by porównać ją z obowiązującą</translation>
    </message>
    <message>
        <source>Range finders…</source>
        <translation>Dalmierze…</translation>
    </message>
    <message>
        <source>Calibrate the range finders with the pin plate</source>
        <translation>Skalibruj dalmierze płytą z kołkami</translation>
    </message>
    <message>
        <source>Lens of a camera…</source>
        <translation>Obiektyw kamery…</translation>
    </message>
    <message>
        <source>Calibrate the lens of a camera with the flat target</source>
        <translation>Skalibruj obiektyw kamery płaską planszą</translation>
    </message>
    <message>
        <source>Encoder…</source>
        <translation>Enkoder…</translation>
    </message>
    <message>
        <source>Calibrate the encoder over a known length</source>
        <translation>Skalibruj enkoder na znanej długości</translation>
    </message>
    <message>
        <source>Reference piece…</source>
        <translation>Element wzorcowy…</translation>
    </message>
    <message>
        <source>Check the calibration on a reference piece</source>
        <translation>Sprawdź kalibrację na elemencie wzorcowym</translation>
    </message>
    <message>
        <source>Parameter study…</source>
        <translation>Badanie parametrów…</translation>
    </message>
    <message>
        <source>Study which settings of the calibration matter</source>
        <translation>Zbadaj, które ustawienia kalibracji są ważne</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibracja</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metoda</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Zachowana</translation>
    </message>
    <message>
        <source>By, because</source>
        <translation>Kto, powód</translation>
    </message>
    <message>
        <source>What the calibration in force is worth</source>
        <translation>Ile jest warta obowiązująca kalibracja</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>Reason for putting it back in force</source>
        <translation>Powód ponownego wprowadzenia w życie</translation>
    </message>
    <message>
        <source>Put in force</source>
        <translation>Wprowadź w życie</translation>
    </message>
    <message>
        <source>Put the chosen calibration in force</source>
        <translation>Wprowadź w życie wybraną kalibrację</translation>
    </message>
    <message>
        <source>No calibration</source>
        <translation>Brak kalibracji</translation>
    </message>
    <message>
        <source>Nothing can be measured: calibrate the range finders.</source>
        <translation>Nic nie można zmierzyć: skalibruj dalmierze.</translation>
    </message>
    <message>
        <source>Overdue: %1. Calibrate the range finders.</source>
        <translation>Po terminie: %1. Skalibruj dalmierze.</translation>
    </message>
    <message numerus="yes">
        <source>Due in %n day(s).</source>
        <translation>
            <numerusform>Termin za %n dzień.</numerusform>
            <numerusform>Termin za %n dni.</numerusform>
            <numerusform>Termin za %n dni.</numerusform>
        </translation>
    </message>
    <message>
        <source>No interval is set.</source>
        <translation>Nie ustawiono okresu.</translation>
    </message>
    <message>
        <source>Method: %1
Made: %2
Plate: %3
Cameras: %4</source>
        <translation>Metoda: %1
Wykonana: %2
Płyta: %3
Kamery: %4</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>None is kept yet. The first is kept when a rail is measured or a wizard ends.</source>
        <translation>Żadnej jeszcze nie zachowano. Pierwsza zostanie zachowana po pomiarze szyny lub zakończeniu kreatora.</translation>
    </message>
    <message>
        <source>In force: %1</source>
        <translation>Obowiązuje: %1</translation>
    </message>
    <message>
        <source> (cannot be read)</source>
        <translation> (nie można odczytać)</translation>
    </message>
    <message>
        <source>of another rig</source>
        <translation>innego układu</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Wymiar</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>Dopuszcz.</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Różnica</translation>
    </message>
    <message>
        <source>U of it</source>
        <translation>Jej U</translation>
    </message>
    <message>
        <source>U (k = 2) in %1</source>
        <translation>U (k = 2) w %1</translation>
    </message>
    <message>
        <source>Difference: what the chosen one measures more than the one in force</source>
        <translation>Różnica: o ile wybrana mierzy więcej niż obowiązująca</translation>
    </message>
    <message>
        <source>By the calibration alone, without the noise of the profiles</source>
        <translation>Tylko z kalibracji, bez szumu przekrojów</translation>
    </message>
    <message>
        <source>%1, too much</source>
        <translation>%1, za dużo</translation>
    </message>
    <message>
        <source>none stated</source>
        <translation>nie podano</translation>
    </message>
    <message>
        <source>Nothing is applied before old and new are compared.</source>
        <translation>Nic nie jest stosowane przed porównaniem starej i nowej.</translation>
    </message>
    <message>
        <source>It is of other cameras and cannot be put in force here.</source>
        <translation>Dotyczy innych kamer i nie można jej tu wprowadzić w życie.</translation>
    </message>
    <message>
        <source>It is in force.</source>
        <translation>Obowiązuje.</translation>
    </message>
    <message>
        <source>It is in force: the line measures with it from the next rail on.</source>
        <translation>Obowiązuje: linia mierzy nią od następnej szyny.</translation>
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
    <message>
        <source>Smallest</source>
        <translation>Najmniejsza</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Największa</translation>
    </message>
</context>
<context>
    <name>vignole::ClosedStep</name>
    <message>
        <source>Closed while the line measures</source>
        <translation>Zamknięte, gdy linia mierzy</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Zatrzymaj linię</translation>
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
        <source>Disk</source>
        <translation>Dysk</translation>
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
        <source>Screen</source>
        <translation>Ekran</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>Zapisano %1.</translation>
    </message>
    <message>
        <source>How much of the support bundle is written</source>
        <translation>Ile pliku serwisowego zapisano</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Ekspozycja</translation>
    </message>
    <message>
        <source>%1 profiles lost</source>
        <translation>utracone przekroje: %1</translation>
    </message>
    <message>
        <source>%1 without points</source>
        <translation>bez punktów: %1</translation>
    </message>
    <message>
        <source>%1 profiles kept</source>
        <translation>zachowane przekroje: %1</translation>
    </message>
    <message>
        <source>rails are not kept</source>
        <translation>szyny nie są zachowywane</translation>
    </message>
    <message>
        <source>%1 pictures/s, %2 % of a core</source>
        <translation>%1 obrazów/s, %2 % rdzenia</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Not available here, because these cameras are rendered: resends, incomplete frames, timeouts, temperature.</source>
        <translation>Niedostępne, bo te kamery są symulowane: ponowne wysłania, niepełne klatki, przekroczenia czasu, temperatura.</translation>
    </message>
    <message>
        <source>%1 of %2 GB</source>
        <translation>%1 z %2 GB</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>nie podano</translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s) kept</source>
        <translation>
            <numerusform>%n szyna zachowana</numerusform>
            <numerusform>%n szyny zachowane</numerusform>
            <numerusform>%n szyn zachowanych</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 MB, WAL %2 MB</source>
        <translation>%1 MB, WAL %2 MB</translation>
    </message>
    <message>
        <source>open, nothing is written</source>
        <translation>otwarte, nic się nie zapisuje</translation>
    </message>
    <message>
        <source>of %1 GB</source>
        <translation>z %1 GB</translation>
    </message>
    <message>
        <source>p99 %1 ms</source>
        <translation>p99 %1 ms</translation>
    </message>
    <message>
        <source>p50 %1, max %2</source>
        <translation>p50 %1, maks %2</translation>
    </message>
    <message>
        <source>window</source>
        <translation>okno</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatura</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Where the support bundle is put</source>
        <translation>Gdzie umieścić plik serwisowy</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Support bundle…</source>
        <translation>Plik serwisowy…</translation>
    </message>
    <message>
        <source>Cancel the support bundle</source>
        <translation>Anuluj plik serwisowy</translation>
    </message>
    <message>
        <source>Save a support bundle</source>
        <translation>Zapisz plik serwisowy</translation>
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
    <name>vignole::DriftPanel</name>
    <message>
        <source>Health</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>seams between the cameras on every rail</source>
        <translation>styki między kamerami na każdej szynie</translation>
    </message>
    <message>
        <source>Shift of each camera, rail by rail</source>
        <translation>Przesunięcie każdej kamery, szyna po szynie</translation>
    </message>
    <message>
        <source>Shift of each camera since its calibration</source>
        <translation>Przesunięcie każdej kamery od jej kalibracji</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Przesun.</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Alarm above</source>
        <translation>Alarm powyżej</translation>
    </message>
    <message>
        <source>No rail has passed yet. Camera drift shows in the seams of normal production, without a plate.</source>
        <translation>Nie przejechała jeszcze żadna szyna. Dryf kamer widać na stykach podczas zwykłej produkcji, bez płyty.</translation>
    </message>
    <message>
        <source>Learning what the seams are like: %1 of %2 rails since this calibration came into use.</source>
        <translation>Uczenie się styków: %1 z %2 szyn, odkąd obowiązuje ta kalibracja.</translation>
    </message>
    <message numerus="yes">
        <source>No camera has moved: %n rail(s) watched.</source>
        <translation>
            <numerusform>Żadna kamera się nie przesunęła: obserwowano %n szynę.</numerusform>
            <numerusform>Żadna kamera się nie przesunęła: obserwowano %n szyny.</numerusform>
            <numerusform>Żadna kamera się nie przesunęła: obserwowano %n szyn.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 moved</source>
        <translation>%1 przesun.</translation>
    </message>
    <message>
        <source>rail</source>
        <translation>szyna</translation>
    </message>
    <message>
        <source>shift in </source>
        <translation>przesun. w </translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>kamera %1</translation>
    </message>
    <message>
        <source>alarm above</source>
        <translation>alarm powyżej</translation>
    </message>
</context>
<context>
    <name>vignole::EncoderPanel</name>
    <message>
        <source>Encoder</source>
        <translation>Enkoder</translation>
    </message>
    <message>
        <source>Motion a pulse</source>
        <translation>Ruch na impuls</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Odczyty</translation>
    </message>
    <message>
        <source>Known length, first to last reading</source>
        <translation>Znana długość, od 1. do ostatniego odczytu</translation>
    </message>
    <message>
        <source>Known length, mm</source>
        <translation>Znana długość, mm</translation>
    </message>
    <message>
        <source>Its standard uncertainty</source>
        <translation>Jej niepewność standardowa</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length, mm</source>
        <translation>Niepewność standardowa długości, mm</translation>
    </message>
    <message>
        <source>Slip of the virtual second encoder, for training</source>
        <translation>Poślizg drugiego, wirtualnego enkodera, do szkolenia</translation>
    </message>
    <message>
        <source>Slip of the virtual second encoder, ppm</source>
        <translation>Poślizg drugiego, wirtualnego enkodera, ppm</translation>
    </message>
    <message>
        <source>Drive the rail</source>
        <translation>Przesuń szynę</translation>
    </message>
    <message>
        <source>Readings from a file…</source>
        <translation>Odczyty z pliku…</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Wyjdź</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Zatrzymaj linię</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Wielkość</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wartość</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>Niepewność standardowa</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Licznik</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Drugi</translation>
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
        <translation>Odczyty enkodera</translation>
    </message>
    <message>
        <source>Slip along the way</source>
        <translation>Poślizg na drodze</translation>
    </message>
    <message>
        <source>Readings: count,x_mm,y_mm[,count2]</source>
        <translation>Odczyty: count,x_mm,y_mm[,count2]</translation>
    </message>
    <message>
        <source>CSV (*.csv);;All files (*)</source>
        <translation>CSV (*.csv);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>Closed while the line measures: the rail is driven by hand over a known length. Stop the line to go on.</source>
        <translation>Zamknięte, gdy linia mierzy: szynę przesuwa się ręcznie o znaną długość. Zatrzymaj linię, aby kontynuować.</translation>
    </message>
    <message>
        <source>A rail is driven over a length that is known, and the pulses are counted: where the light crosses it, it is seen as well.</source>
        <translation>Szyna przejeżdża znaną długość, a impulsy są zliczane: widać też, gdzie przecina ją światło.</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>odczyt</translation>
    </message>
    <message>
        <source>second behind first, pulses</source>
        <translation>opóźnienie drugiego, impulsy</translation>
    </message>
    <message>
        <source>Next: drive the rail over the known length.</source>
        <translation>Dalej: przesuń szynę o znaną długość.</translation>
    </message>
    <message>
        <source> µm a pulse</source>
        <translation> µm na impuls</translation>
    </message>
    <message>
        <source> µm</source>
        <translation> µm</translation>
    </message>
    <message>
        <source>unknown: fewer than three readings</source>
        <translation>nieznana: mniej niż trzy odczyty</translation>
    </message>
    <message>
        <source>Along (V z)</source>
        <translation>Wzdłuż (V z)</translation>
    </message>
    <message>
        <source>Sideways (V x)</source>
        <translation>W bok (V x)</translation>
    </message>
    <message>
        <source>Upwards (V y)</source>
        <translation>W górę (V y)</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>Impulsy</translation>
    </message>
    <message>
        <source>Slip of the second</source>
        <translation>Poślizg drugiego</translation>
    </message>
    <message>
        <source>One of the encoders slips. Next: clean the wheels, press them on and drive again.</source>
        <translation>Jeden z enkoderów ślizga się. Dalej: oczyść koła, dociśnij je i przejedź ponownie.</translation>
    </message>
    <message>
        <source>One pulse is %1 µm of rail. Next: enter it where the encoder&apos;s pulses are divided into triggers.</source>
        <translation>Jeden impuls to %1 µm szyny. Dalej: wpisz to tam, gdzie impulsy enkodera dzieli się na wyzwolenia.</translation>
    </message>
</context>
<context>
    <name>vignole::FramesDrawing</name>
    <message>
        <source>Frames: world on the light plane, camera, image</source>
        <translation>Układy: świat na płaszczyźnie światła, kamera, obraz</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Obraz</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Świat</translation>
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
    <name>vignole::LensWizard</name>
    <message>
        <source>Cancelling…</source>
        <translation>Anulowanie…</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Obiektyw</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Przygotuj</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Pokrycie</translation>
    </message>
    <message>
        <source>Parts of the picture that have been seen</source>
        <translation>Już widziane części obrazu</translation>
    </message>
    <message>
        <source>Picture of the target</source>
        <translation>Obraz planszy</translation>
    </message>
    <message>
        <source>Pictures taken</source>
        <translation>Wykonane zdjęcia</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>Skos</translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>Rozmycie</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Oblicz</translation>
    </message>
    <message>
        <source>Lens models (Table III)</source>
        <translation>Modele obiektywu (tab. III)</translation>
    </message>
    <message>
        <source>Distortion model</source>
        <translation>Model dystorsji</translation>
    </message>
    <message>
        <source>Mean error px</source>
        <translation>Błąd średni px</translation>
    </message>
    <message>
        <source>RMS px</source>
        <translation>RMS px</translation>
    </message>
    <message>
        <source>Not seen before px</source>
        <translation>Wcześniej niewidziane px</translation>
    </message>
    <message>
        <source>Focal length mm</source>
        <translation>Ogniskowa mm</translation>
    </message>
    <message>
        <source>Lens models that were tried</source>
        <translation>Wypróbowane modele obiektywu</translation>
    </message>
    <message>
        <source>Coverage and residuals</source>
        <translation>Pokrycie i reszty</translation>
    </message>
    <message>
        <source>Points of all pictures</source>
        <translation>Punkty wszystkich zdjęć</translation>
    </message>
    <message>
        <source>Mean residual by place</source>
        <translation>Średnia reszta wg miejsca</translation>
    </message>
    <message>
        <source>The flat target with circles is held before one camera, in the pose that is drawn, picture by picture. The lens model is the simplest that predicts pictures it has not seen.
Target: %1, points within ±%2 µm.</source>
        <translation>Płaską planszę z okręgami trzyma się przed jedną kamerą w narysowanym położeniu, zdjęcie po zdjęciu. Model obiektywu to najprostszy, który przewiduje zdjęcia, których nie widział.
Plansza: %1, punkty w granicach ±%2 µm.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Camera whose lens is calibrated</source>
        <translation>Kamera z kalibrowanym obiektywem</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>Pictures: twelve cover a lens.</source>
        <translation>Zdjęcia: dwanaście pokrywa obiektyw.</translation>
    </message>
    <message>
        <source>Number of pictures</source>
        <translation>Liczba zdjęć</translation>
    </message>
    <message>
        <source>Target to the right, mm</source>
        <translation>Plansza w prawo, mm</translation>
    </message>
    <message>
        <source>Target down, mm</source>
        <translation>Plansza w dół, mm</translation>
    </message>
    <message>
        <source>Distance of the target, mm</source>
        <translation>Odległość planszy, mm</translation>
    </message>
    <message>
        <source>Tilt up and down, degrees</source>
        <translation>Pochylenie w górę i w dół, stopnie</translation>
    </message>
    <message>
        <source>Tilt to the sides, degrees</source>
        <translation>Pochylenie na boki, stopnie</translation>
    </message>
    <message>
        <source>Turn of the target, degrees</source>
        <translation>Obrót planszy, stopnie</translation>
    </message>
    <message>
        <source>Hold as shown</source>
        <translation>Ustaw jak pokazano</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Wyjdź</translation>
    </message>
    <message>
        <source>Take picture</source>
        <translation>Zrób zdjęcie</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Use with the plate</source>
        <translation>Użyj z płytą</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Zapisz…</translation>
    </message>
    <message>
        <source>The camera is needed for the pictures of the target. Stop the line to go on; what has been taken so far is kept.</source>
        <translation>Kamera jest potrzebna do zdjęć planszy. Zatrzymaj linię, aby kontynuować; dotychczasowe zdjęcia zostają.</translation>
    </message>
    <message>
        <source>Progress of the solution</source>
        <translation>Postęp obliczeń</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Anulowano: nic się nie zmieniło.</translation>
    </message>
    <message>
        <source>Lens of the camera</source>
        <translation>Obiektyw kamery</translation>
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
        <translation>Zapisano: %1</translation>
    </message>
    <message>
        <source>camera and target</source>
        <translation>kamera i plansza</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Zdjęcia</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>model chosen by the data</source>
        <translation>model wybrany przez dane</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Wynik</translation>
    </message>
    <message>
        <source>Table III, residuals</source>
        <translation>Tabela III, reszty</translation>
    </message>
    <message>
        <source>%1 % of the picture</source>
        <translation>%1 % obrazu</translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>Jeszcze brak.</translation>
    </message>
    <message>
        <source>May be used, but: %1</source>
        <translation>Można użyć, ale: %1</translation>
    </message>
    <message>
        <source>May be used: mean error %1 px with the model %2, chosen by pictures it had not seen.</source>
        <translation>Można użyć: błąd średni %1 px z modelem %2, wybranym na zdjęciach, których nie widział.</translation>
    </message>
    <message>
        <source>%1, chosen</source>
        <translation>%1, wybrany</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>Next: choose the camera.</source>
        <translation>Dalej: wybierz kamerę.</translation>
    </message>
    <message>
        <source>First picture</source>
        <translation>Pierwsze zdjęcie</translation>
    </message>
    <message>
        <source>Looking at the target…</source>
        <translation>Podgląd planszy…</translation>
    </message>
    <message>
        <source>This picture would be refused: %1</source>
        <translation>To zdjęcie zostałoby odrzucone: %1</translation>
    </message>
    <message>
        <source>This picture would be refused, because it shows the pose of picture %1; move the target to the dashed outline.</source>
        <translation>To zdjęcie zostałoby odrzucone, bo pokazuje położenie ze zdjęcia %1; przesuń planszę do przerywanego zarysu.</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) found.</source>
        <translation>
            <numerusform>Znaleziono %n punkt.</numerusform>
            <numerusform>Znaleziono %n punkty.</numerusform>
            <numerusform>Znaleziono %n punktów.</numerusform>
        </translation>
    </message>
    <message>
        <source>Next: solve, or take more.</source>
        <translation>Dalej: oblicz lub zrób więcej zdjęć.</translation>
    </message>
    <message>
        <source>Working out which pose tells most…</source>
        <translation>Szukanie położenia, które powie najwięcej…</translation>
    </message>
    <message numerus="yes">
        <source>Next: hold the target to the dashed outline and take the picture; %n to go.</source>
        <translation>
            <numerusform>Dalej: ustaw planszę w przerywanym zarysie i zrób zdjęcie; zostało %n.</numerusform>
            <numerusform>Dalej: ustaw planszę w przerywanym zarysie i zrób zdjęcie; zostały %n.</numerusform>
            <numerusform>Dalej: ustaw planszę w przerywanym zarysie i zrób zdjęcie; zostało %n.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Next: %1; %n to go.</source>
        <translation>
            <numerusform>Dalej: %1; zostało %n.</numerusform>
            <numerusform>Dalej: %1; zostały %n.</numerusform>
            <numerusform>Dalej: %1; zostało %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>Lens models are adjusted and tried on pictures they have not seen.</source>
        <translation>Modele obiektywu są wyrównywane i próbowane na zdjęciach, których nie widziały.</translation>
    </message>
    <message>
        <source>Next: nothing to do; the result comes by itself.</source>
        <translation>Dalej: nic do zrobienia; wynik pojawi się sam.</translation>
    </message>
    <message>
        <source>Refused: it cannot be used.</source>
        <translation>Odrzucono: nie można użyć.</translation>
    </message>
    <message>
        <source>The wizard of the range finders uses this lens. Next: calibrate the range finders.</source>
        <translation>Kreator dalmierzy używa tego obiektywu. Dalej: skalibruj dalmierze.</translation>
    </message>
    <message>
        <source>Next: use it with the plate, or save it.</source>
        <translation>Dalej: użyj go z płytą lub zapisz.</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone. Start the program on the virtual rig.</source>
        <translation>Nie ma układu do podglądu: kreatory patrzą tylko przez układ wirtualny. Uruchom program na układzie wirtualnym.</translation>
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
    <message>
        <source>Show the points before registration</source>
        <translation>Pokaż punkty przed dopasowaniem</translation>
    </message>
    <message>
        <source>Show the points before registration (B)</source>
        <translation>Pokaż punkty przed dopasowaniem (B)</translation>
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
        <source>%1 points</source>
        <translation>punkty: %1</translation>
    </message>
    <message>
        <source>registered</source>
        <translation>dopasowany</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>niedopasowany</translation>
    </message>
    <message numerus="yes">
        <source>%n dimension(s)</source>
        <translation>
            <numerusform>%n wymiar</numerusform>
            <numerusform>%n wymiary</numerusform>
            <numerusform>%n wymiarów</numerusform>
        </translation>
    </message>
    <message>
        <source>SD %1</source>
        <translation>OS %1</translation>
    </message>
    <message>
        <source>99 % UCL %1</source>
        <translation>GGP 99 % %1</translation>
    </message>
    <message>
        <source>Consumers</source>
        <translation>Odbiorcy</translation>
    </message>
    <message>
        <source>in the queue now</source>
        <translation>teraz w kolejce</translation>
    </message>
    <message>
        <source>highest fill, of how many places</source>
        <translation>największe zapełnienie, z ilu miejsc</translation>
    </message>
    <message>
        <source>mean time, SD standard deviation, UCL upper limit of its 99 % confidence interval</source>
        <translation>czas średni, OS odchylenie standardowe, GGP górna granica jego przedziału ufności 99 %</translation>
    </message>
</context>
<context>
    <name>vignole::PlateView</name>
    <message>
        <source>no picture yet</source>
        <translation>jeszcze brak obrazu</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>odrzucone</translation>
    </message>
    <message>
        <source>%1 of %2 pins</source>
        <translation>kołki: %1 z %2</translation>
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
        <translation>brak kołka</translation>
    </message>
    <message>
        <source>not found: %1</source>
        <translation>nie znaleziono: %1</translation>
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
        <source>as Fig. 9a</source>
        <translation>jak rys. 9a</translation>
    </message>
    <message>
        <source>Range of the runs</source>
        <translation>Rozstęp przejazdów</translation>
    </message>
    <message>
        <source>Values of every run over the length</source>
        <translation>Wartości każdego przejazdu na długości</translation>
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
        <source>Export as CSV</source>
        <translation>Eksport do CSV</translation>
    </message>
    <message>
        <source>truth of the virtual rig</source>
        <translation>prawda układu wirtualnego</translation>
    </message>
    <message numerus="yes">
        <source>The inspections were cancelled; %n were whole.</source>
        <translation>
            <numerusform>Inspekcje anulowano; ukończono %n.</numerusform>
            <numerusform>Inspekcje anulowano; ukończono %n.</numerusform>
            <numerusform>Inspekcje anulowano; ukończono %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>Runs of one rail</source>
        <translation>Przejazdy jednej szyny</translation>
    </message>
    <message>
        <source>Reference values</source>
        <translation>Wartości odniesienia</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Raport PDF</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Badanie</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Dokładność</translation>
    </message>
    <message>
        <source>Rails of the archive</source>
        <translation>Szyny z archiwum</translation>
    </message>
    <message>
        <source>Runs from a file</source>
        <translation>Przejazdy z pliku</translation>
    </message>
    <message>
        <source>Virtual rig</source>
        <translation>Układ wirtualny</translation>
    </message>
    <message>
        <source>Where the runs come from</source>
        <translation>Skąd pochodzą przejazdy</translation>
    </message>
    <message>
        <source>3 m of rail</source>
        <translation>3 m szyny</translation>
    </message>
    <message>
        <source>12 m of rail</source>
        <translation>12 m szyny</translation>
    </message>
    <message>
        <source>60 m of rail, as the paper</source>
        <translation>60 m szyny, jak w artykule</translation>
    </message>
    <message>
        <source>Length of the virtual rail</source>
        <translation>Długość wirtualnej szyny</translation>
    </message>
    <message>
        <source>Means over 0.5 m</source>
        <translation>Średnie z 0,5 m</translation>
    </message>
    <message>
        <source>Runs that may be laid over each other</source>
        <translation>Przejazdy, które można nałożyć</translation>
    </message>
    <message>
        <source>Open runs…</source>
        <translation>Otwórz przejazdy…</translation>
    </message>
    <message>
        <source>Open runs from a CSV file</source>
        <translation>Otwórz przejazdy z pliku CSV</translation>
    </message>
    <message>
        <source>Open reference…</source>
        <translation>Otwórz odniesienie…</translation>
    </message>
    <message>
        <source>Open reference values from a CSV file</source>
        <translation>Otwórz wartości odniesienia z pliku CSV</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Raport…</translation>
    </message>
    <message>
        <source>Report as PDF (Ctrl+P)</source>
        <translation>Raport PDF (Ctrl+P)</translation>
    </message>
    <message>
        <source>Export values as CSV</source>
        <translation>Eksport wartości do CSV</translation>
    </message>
    <message>
        <source>Export values as CSV (Ctrl+E)</source>
        <translation>Eksport wartości do CSV (Ctrl+E)</translation>
    </message>
    <message>
        <source>Progress of the inspections</source>
        <translation>Postęp inspekcji</translation>
    </message>
    <message>
        <source>What the runs differ by over the length</source>
        <translation>Czym różnią się przejazdy na długości</translation>
    </message>
    <message>
        <source>Every dimension; the chosen one is drawn</source>
        <translation>Każdy wymiar; rysowany jest wybrany</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Wynik</translation>
    </message>
    <message>
        <source>Figures of the chosen dimension, formulas and constants</source>
        <translation>Liczby wybranego wymiaru, wzory i stałe</translation>
    </message>
    <message>
        <source>Stored runs come from the archive, and there is none (%1): start the program with --archive FILE, or choose a file or the virtual rig above.</source>
        <translation>Zapisane przejazdy pochodzą z archiwum, a go nie ma (%1): uruchom program z --archive FILE albo wybierz wyżej plik lub układ wirtualny.</translation>
    </message>
    <message>
        <source>virtual rig</source>
        <translation>układ wirtualny</translation>
    </message>
    <message>
        <source>run %1</source>
        <translation>przejazd %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Inspect the rail five times</source>
        <translation>Zbadaj szynę pięć razy</translation>
    </message>
    <message>
        <source>Cancel the inspections</source>
        <translation>Anuluj inspekcje</translation>
    </message>
    <message>
        <source>Inspect the same virtual rail five times</source>
        <translation>Zbadaj pięć razy tę samą wirtualną szynę</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R)</source>
        <translation>Najpierw zatrzymaj linię (Ctrl+R)</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R): both need all processors, and no trigger may be lost to a study.</source>
        <translation>Najpierw zatrzymaj linię (Ctrl+R): oba zadania wymagają wszystkich procesorów, a badanie nie może zgubić wyzwolenia.</translation>
    </message>
    <message>
        <source>Accuracy needs a reference: open a CSV with the columns dimension, position_m, value and, if known, u.</source>
        <translation>Dokładność wymaga odniesienia: otwórz CSV z kolumnami dimension, position_m, value i, jeśli znane, u.</translation>
    </message>
    <message>
        <source>At least 1 run is needed, none is chosen.</source>
        <translation>Potrzebny jest co najmniej 1 przejazd, brak wybranych.</translation>
    </message>
    <message>
        <source>At least 2 runs of the same rail are needed, %1 chosen: choose %2 more. The paper took 5.</source>
        <translation>Potrzebne są co najmniej 2 przejazdy tej samej szyny, wybrano: %1; dobierz jeszcze %2. W artykule było 5.</translation>
    </message>
    <message>
        <source>stored rails, same rail and gauge</source>
        <translation>zapisane szyny, ta sama szyna i przyrząd</translation>
    </message>
    <message>
        <source>file %1</source>
        <translation>plik %1</translation>
    </message>
    <message>
        <source>virtual rig, exact calibration, other wander, vibration, scale, speckle and noise in every run</source>
        <translation>układ wirtualny, dokładna kalibracja, w każdym przejeździe inne zbaczanie, drgania, zgorzelina, plamkowanie i szum</translation>
    </message>
    <message>
        <source>The same rail is inspected five times …</source>
        <translation>Ta sama szyna jest badana pięć razy …</translation>
    </message>
    <message>
        <source>Conditions: %1.</source>
        <translation>Warunki: %1.</translation>
    </message>
    <message>
        <source>Tick the runs that were made of the same rail and compare.</source>
        <translation>Zaznacz przejazdy tej samej szyny i porównaj.</translation>
    </message>
    <message>
        <source>A CSV with the columns run, position_m and dimensions, as inspect --csv writes it.</source>
        <translation>CSV z kolumnami run, position_m i wymiarami, jak zapisuje inspect --csv.</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R): both need all processors.</source>
        <translation>Najpierw zatrzymaj linię (Ctrl+R): oba wymagają wszystkich procesorów.</translation>
    </message>
    <message>
        <source>The paper&apos;s experiment: one rail, five inspections, the truth known.</source>
        <translation>Doświadczenie z artykułu: jedna szyna, pięć inspekcji, znana prawda.</translation>
    </message>
    <message>
        <source>No runs are compared yet</source>
        <translation>Nie porównano jeszcze przejazdów</translation>
    </message>
    <message>
        <source>%1 over the length</source>
        <translation>%1 na długości</translation>
    </message>
    <message>
        <source>largest minus smallest at each position, as Fig. 9b</source>
        <translation>największa minus najmniejsza w każdym położeniu, jak rys. 9b</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>oczekiwana</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>granica dolna</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>granica górna</translation>
    </message>
    <message>
        <source>mean of %1 m</source>
        <translation>średnia z %1 m</translation>
    </message>
    <message>
        <source>Error of %1 over the length</source>
        <translation>Błąd %1 na długości</translation>
    </message>
    <message>
        <source>value minus reference, mean of the runs; %1</source>
        <translation>wartość minus odniesienie, średnia przejazdów; %1</translation>
    </message>
    <message>
        <source>value minus reference</source>
        <translation>wartość minus odniesienie</translation>
    </message>
    <message>
        <source>Largest error at each position</source>
        <translation>Największy błąd w każdym położeniu</translation>
    </message>
    <message>
        <source>of any run</source>
        <translation>z przejazdów</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>średnia</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>największy</translation>
    </message>
    <message>
        <source>no error</source>
        <translation>brak błędu</translation>
    </message>
    <message>
        <source>limit of agreement</source>
        <translation>granica zgodności</translation>
    </message>
    <message>
        <source>error, %1</source>
        <translation>błąd, %1</translation>
    </message>
    <message>
        <source>Dim.</source>
        <translation>Wym.</translation>
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
        <translation>Średni rozstęp na %1 m</translation>
    </message>
    <message>
        <source>as Table VI</source>
        <translation>jak tab. VI</translation>
    </message>
    <message>
        <source>%1, as Table VI; the stretches are in the report</source>
        <translation>%1, jak tab. VI; odcinki są w raporcie</translation>
    </message>
    <message>
        <source>%1, as Table VI</source>
        <translation>%1, jak tab. VI</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>obciąż.</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Błędy</translation>
    </message>
    <message>
        <source>%1, as Table V</source>
        <translation>%1, jak tab. V</translation>
    </message>
    <message>
        <source>as Table V</source>
        <translation>jak tab. V</translation>
    </message>
    <message>
        <source>Verdict, figures, formulas and constants stand here when runs are compared.</source>
        <translation>Tu pojawiają się ocena, liczby, wzory i stałe po porównaniu przejazdów.</translation>
    </message>
    <message>
        <source>figures of %1</source>
        <translation>liczby dla %1</translation>
    </message>
    <message>
        <source>writing …</source>
        <translation>zapis …</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>Zapisano %1.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>Nie można zapisać %1.</translation>
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
    <message>
        <source>kept since the start: %1 rails; %2 profiles wait</source>
        <translation>zachowane od startu: szyny %1; czekają przekroje: %2</translation>
    </message>
    <message>
        <source>nearest to a limit, inside</source>
        <translation>najbliżej granicy, wewnątrz</translation>
    </message>
    <message>
        <source>furthest beyond a limit, mm</source>
        <translation>najdalej poza granicą, mm</translation>
    </message>
    <message>
        <source>Dimension that is drawn</source>
        <translation>Rysowany wymiar</translation>
    </message>
    <message>
        <source>Show the points before registration</source>
        <translation>Pokaż punkty przed dopasowaniem</translation>
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
    <message>
        <source>Section…</source>
        <translation>Profil…</translation>
    </message>
    <message>
        <source>Draw the section, or bring one along from a drawing</source>
        <translation>Narysuj profil lub wczytaj go z rysunku</translation>
    </message>
    <message>
        <source>What if…</source>
        <translation>Co jeśli…</translation>
    </message>
    <message>
        <source>Judge stored rails by the chosen recipe</source>
        <translation>Oceń zapisane szyny wybraną recepturą</translation>
    </message>
    <message>
        <source>Use for the next rail</source>
        <translation>Użyj od następnej</translation>
    </message>
    <message>
        <source>Use the chosen recipe for the next rail</source>
        <translation>Użyj wybranej receptury dla następnej szyny</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ustawienia</translation>
    </message>
    <message>
        <source>Parameters of dimensions and settings of the stages</source>
        <translation>Parametry wymiarów i ustawienia etapów</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Ustawienie</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wartość</translation>
    </message>
    <message>
        <source>Settings of the chosen recipe</source>
        <translation>Ustawienia wybranej receptury</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>Name of the draft; another name makes a copy</source>
        <translation>Nazwa szkicu; inna nazwa tworzy kopię</translation>
    </message>
    <message>
        <source>On the line: %1 v%2.</source>
        <translation>Na linii: %1 v%2.</translation>
    </message>
    <message>
        <source>From the next rail: %1.</source>
        <translation>Od następnej szyny: %1.</translation>
    </message>
    <message>
        <source>Only an approved recipe is measured with.</source>
        <translation>Mierzy się tylko zatwierdzoną recepturą.</translation>
    </message>
    <message>
        <source>%1: the value is not of its kind.</source>
        <translation>%1: wartość nie jest właściwego rodzaju.</translation>
    </message>
    <message>
        <source>%1 v%2 is in force from the next rail; the rail in the gauge keeps what it began with.</source>
        <translation>%1 v%2 obowiązuje od następnej szyny; szyna w przyrządzie zachowuje to, z czym zaczęła.</translation>
    </message>
    <message>
        <source>What if needs at least %1 stored rails of section %2, there are %3: measure more first.</source>
        <translation>„Co jeśli” wymaga co najmniej %1 zapisanych szyn profilu %2, a jest ich %3: najpierw zmierz więcej.</translation>
    </message>
    <message>
        <source>Recipes are read, drafts cannot be kept: %1.</source>
        <translation>Receptury są odczytywane, szkiców nie można zachować: %1.</translation>
    </message>
</context>
<context>
    <name>vignole::ReferencePanel</name>
    <message>
        <source>Reference piece</source>
        <translation>Element wzorcowy</translation>
    </message>
    <message>
        <source>Certificate and gauge</source>
        <translation>Certyfikat i przyrząd</translation>
    </message>
    <message>
        <source>Profiles that are averaged</source>
        <translation>Uśredniane przekroje</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Postęp sprawdzania</translation>
    </message>
    <message>
        <source>Measure the piece</source>
        <translation>Zmierz element</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Wyjdź</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Zatrzymaj linię</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Anulowano: nic się nie zmieniło.</translation>
    </message>
    <message>
        <source>Closed while the line measures: the piece stands where the rail passes. Stop the line to go on.</source>
        <translation>Zamknięte, gdy linia mierzy: element stoi tam, gdzie przejeżdża szyna. Zatrzymaj linię, aby kontynuować.</translation>
    </message>
    <message>
        <source>A section with a certificate is put into the gauge and measured with the calibration in force. On the virtual rig it is a virtual piece, whose truth is its certificate (U = 2 µm).</source>
        <translation>Do przyrządu wkłada się odcinek profilu z certyfikatem i mierzy z obowiązującą kalibracją. W układzie wirtualnym jest to element wirtualny, którego prawdą jest jego certyfikat (U = 2 µm).</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Pomiar…</translation>
    </message>
    <message>
        <source>Next: measure the piece.</source>
        <translation>Dalej: zmierz element.</translation>
    </message>
    <message numerus="yes">
        <source>The gauge agrees with the certificate in every dimension, over %n profile(s).</source>
        <translation>
            <numerusform>Przyrząd zgadza się z certyfikatem w każdym wymiarze, na podstawie %n przekroju.</numerusform>
            <numerusform>Przyrząd zgadza się z certyfikatem w każdym wymiarze, na podstawie %n przekrojów.</numerusform>
            <numerusform>Przyrząd zgadza się z certyfikatem w każdym wymiarze, na podstawie %n przekrojów.</numerusform>
        </translation>
    </message>
    <message>
        <source>The gauge does not agree with the certificate. Next: clean the piece and measure again; if it stays so, calibrate the range finders.</source>
        <translation>Przyrząd nie zgadza się z certyfikatem. Dalej: oczyść element i zmierz ponownie; jeśli to się utrzymuje, skalibruj dalmierze.</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Wymiar</translation>
    </message>
    <message>
        <source>Certificate %1</source>
        <translation>Certyfikat %1</translation>
    </message>
    <message>
        <source>Measured %1</source>
        <translation>Zmierzone %1</translation>
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
        <source>Deviation over U</source>
        <translation>Odchyłka / U</translation>
    </message>
    <message>
        <source>%1, differs</source>
        <translation>%1, różni się</translation>
    </message>
    <message>
        <source>not measured: %1</source>
        <translation>nie zmierzono: %1</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone.</source>
        <translation>Nie ma układu do podglądu: kreatory patrzą tylko przez układ wirtualny.</translation>
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
    <name>vignole::RigDrawing</name>
    <message>
        <source>The rig as it is calibrated</source>
        <translation>Stanowisko według kalibracji</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>Along the rail: fields of view on the light plane, distances</source>
        <translation>Wzdłuż szyny: pola widzenia na płaszczyźnie światła, odległości</translation>
    </message>
    <message>
        <source>From the side: angles out of the light plane</source>
        <translation>Z boku: kąty względem płaszczyzny światła</translation>
    </message>
</context>
<context>
    <name>vignole::RigWizard</name>
    <message>
        <source>Cancelling…</source>
        <translation>Anulowanie…</translation>
    </message>
    <message>
        <source>Range finders</source>
        <translation>Dalmierze</translation>
    </message>
    <message>
        <source>What it means</source>
        <translation>Co to znaczy</translation>
    </message>
    <message>
        <source>Fit to the pins</source>
        <translation>Dopasowanie do kołków</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Przygotuj</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Oblicz</translation>
    </message>
    <message>
        <source>Pins found (Fig. 8d)</source>
        <translation>Znalezione kołki (rys. 8d)</translation>
    </message>
    <message>
        <source>circles: the pins as found; points: the lines of the first placement</source>
        <translation>okręgi: znalezione kołki; punkty: linie pierwszego ułożenia</translation>
    </message>
    <message>
        <source>Pins in the world</source>
        <translation>Kołki w przestrzeni</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Sprawdzenia</translation>
    </message>
    <message>
        <source>Put in force</source>
        <translation>Wprowadź w życie</translation>
    </message>
    <message>
        <source>How often the plate is put down: four find an error of the plate as well.</source>
        <translation>Ile razy układa się płytę: cztery ujawniają też błąd samej płyty.</translation>
    </message>
    <message>
        <source>Number of placements</source>
        <translation>Liczba ułożeń</translation>
    </message>
    <message>
        <source>The virtual plate, for training</source>
        <translation>Płyta wirtualna, do szkolenia</translation>
    </message>
    <message>
        <source>is as its certificate says</source>
        <translation>jest zgodna z certyfikatem</translation>
    </message>
    <message>
        <source>is the mirror image of its file</source>
        <translation>jest lustrzanym odbiciem pliku</translation>
    </message>
    <message>
        <source>is not the one of the certificate</source>
        <translation>nie jest tą z certyfikatu</translation>
    </message>
    <message>
        <source>has lost pin 4</source>
        <translation>straciła kołek 4</translation>
    </message>
    <message>
        <source>Virtual plate</source>
        <translation>Płyta wirtualna</translation>
    </message>
    <message>
        <source>Plate to the right, mm</source>
        <translation>Płyta w prawo, mm</translation>
    </message>
    <message>
        <source>Plate up, mm</source>
        <translation>Płyta w górę, mm</translation>
    </message>
    <message>
        <source>Plate turned anticlockwise, degrees</source>
        <translation>Płyta obrócona w lewo, stopnie</translation>
    </message>
    <message>
        <source>Plate tilted out of the light, degrees</source>
        <translation>Płyta wychylona ze światła, stopnie</translation>
    </message>
    <message>
        <source>tilt </source>
        <translation>pochyl. </translation>
    </message>
    <message>
        <source>Place as shown</source>
        <translation>Ułóż jak pokazano</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Wyjdź</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Wstecz</translation>
    </message>
    <message>
        <source>Take again</source>
        <translation>Powtórz</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Raport…</translation>
    </message>
    <message>
        <source>The plate stands where the rail passes, and the cameras are needed. Stop the line to go on; what has been taken so far is kept.</source>
        <translation>Płyta stoi tam, gdzie przejeżdża szyna, a kamery są potrzebne. Zatrzymaj linię, aby kontynuować; dotychczasowe zdjęcia zostają.</translation>
    </message>
    <message>
        <source>To be repeated after so many days (0: never)</source>
        <translation>Powtórzyć po tylu dniach (0: nigdy)</translation>
    </message>
    <message>
        <source>Days after which the calibration is to be repeated</source>
        <translation>Dni, po których należy powtórzyć kalibrację</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>Reason for the new calibration</source>
        <translation>Powód nowej kalibracji</translation>
    </message>
    <message>
        <source>Progress of the solution</source>
        <translation>Postęp obliczeń</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Centre (CD)</source>
        <translation>Środek (CD)</translation>
    </message>
    <message>
        <source>Radius (RD)</source>
        <translation>Promień (RD)</translation>
    </message>
    <message>
        <source>Points (PD)</source>
        <translation>Punkty (PD)</translation>
    </message>
    <message>
        <source>Table IV: fit to the pins</source>
        <translation>Tabela IV: dopasowanie do kołków</translation>
    </message>
    <message>
        <source>Checks of the new calibration</source>
        <translation>Sprawdzenia nowej kalibracji</translation>
    </message>
    <message>
        <source>Four cameras together…</source>
        <translation>Cztery kamery razem…</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Anulowano: nic się nie zmieniło.</translation>
    </message>
    <message>
        <source>%1 is in force: the line measures with it from the next rail on.</source>
        <translation>%1 obowiązuje: linia mierzy nią od następnej szyny.</translation>
    </message>
    <message>
        <source>Report of the calibration</source>
        <translation>Raport kalibracji</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Zapisano: %1</translation>
    </message>
    <message>
        <source>turned and moved</source>
        <translation>obrócona i przesunięta</translation>
    </message>
    <message>
        <source>turned 180°</source>
        <translation>obrócona o 180°</translation>
    </message>
    <message>
        <source>moved %1 mm</source>
        <translation>przesunięta o %1 mm</translation>
    </message>
    <message>
        <source>as drawn, 0°</source>
        <translation>jak na rysunku, 0°</translation>
    </message>
    <message>
        <source>plate and cameras</source>
        <translation>płyta i kamery</translation>
    </message>
    <message>
        <source>Placement %1</source>
        <translation>Ułożenie %1</translation>
    </message>
    <message>
        <source>four cameras together</source>
        <translation>cztery kamery razem</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Porównaj</translation>
    </message>
    <message>
        <source>old and new</source>
        <translation>stara i nowa</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Zastosuj</translation>
    </message>
    <message>
        <source>reason and signature</source>
        <translation>powód i podpis</translation>
    </message>
    <message>
        <source>placement %1 of %2</source>
        <translation>ułożenie %1 z %2</translation>
    </message>
    <message>
        <source>U (k = 2) in %1</source>
        <translation>U (k = 2) w %1</translation>
    </message>
    <message>
        <source>mean / max in %1</source>
        <translation>średnia / maks w %1</translation>
    </message>
    <message>
        <source>Plate, %1</source>
        <translation>Płyta, %1</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Płyta</translation>
    </message>
    <message>
        <source>%1, U = 3 µm, pins towards the cameras</source>
        <translation>%1, U = 3 µm, kołki w stronę kamer</translation>
    </message>
    <message>
        <source>Camera %1: lens as calibrated in this session</source>
        <translation>Kamera %1: obiektyw skalibrowany w tej sesji</translation>
    </message>
    <message>
        <source>Camera %1: lens of the calibration in force</source>
        <translation>Kamera %1: obiektyw z obowiązującej kalibracji</translation>
    </message>
    <message>
        <source>The plate with 13 pins is put into the gauge where the rail passes, pins towards the cameras, and turned and moved between the pictures. Nothing is applied before old and new have been compared and you confirm.

%1</source>
        <translation>Płytę z 13 kołkami wkłada się do przyrządu tam, gdzie przejeżdża szyna, kołkami w stronę kamer, i między zdjęciami obraca się ją i przesuwa. Nic nie jest stosowane, zanim stara i nowa nie zostaną porównane, a zmiana potwierdzona.

%1</translation>
    </message>
    <message>
        <source>%1 takes the place of %2 from the next rail on. Both are kept and can be compared and put back.</source>
        <translation>%1 zastępuje %2 od następnej szyny. Obie są zachowane i można je porównać lub przywrócić.</translation>
    </message>
    <message>
        <source>could not be asked</source>
        <translation>nie można było sprawdzić</translation>
    </message>
    <message>
        <source>%1, within %2</source>
        <translation>%1, w granicy %2</translation>
    </message>
    <message>
        <source>%1, above %2</source>
        <translation>%1, powyżej %2</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>%1 w prawo</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 w lewo</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>%1 w górę</translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation>%1 w dół</translation>
    </message>
    <message>
        <source>turned by %1° anticlockwise</source>
        <translation>obrót o %1° w lewo</translation>
    </message>
    <message>
        <source>turned by %1° clockwise</source>
        <translation>obrót o %1° w prawo</translation>
    </message>
    <message>
        <source>Next: move the plate to the dashed outlines: %1.</source>
        <translation>Dalej: przesuń płytę do przerywanych zarysów: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>Next: put the plate into the gauge.</source>
        <translation>Dalej: włóż płytę do przyrządu.</translation>
    </message>
    <message>
        <source>First placement</source>
        <translation>Pierwsze ułożenie</translation>
    </message>
    <message>
        <source>Next placement</source>
        <translation>Następne ułożenie</translation>
    </message>
    <message>
        <source>Looking at the plate…</source>
        <translation>Podgląd płyty…</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>Kamera %1: %2</translation>
    </message>
    <message>
        <source>%1 of %2 pins found</source>
        <translation>znalezione kołki: %1 z %2</translation>
    </message>
    <message numerus="yes">
        <source>, %n picture(s) refused</source>
        <translation>
            <numerusform>, odrzucono %n zdjęcie</numerusform>
            <numerusform>, odrzucono %n zdjęcia</numerusform>
            <numerusform>, odrzucono %n zdjęć</numerusform>
        </translation>
    </message>
    <message>
        <source>All four cameras see the plate where it must lie. Next: “%1”.</source>
        <translation>Wszystkie cztery kamery widzą płytę tam, gdzie powinna leżeć. Dalej: „%1”.</translation>
    </message>
    <message>
        <source>The poses of four cameras are found together with the pins.</source>
        <translation>Położenia czterech kamer są wyznaczane razem z kołkami.</translation>
    </message>
    <message>
        <source>Next: nothing to do; the comparison comes by itself.</source>
        <translation>Dalej: nic do zrobienia; porównanie pojawi się samo.</translation>
    </message>
    <message>
        <source>Refused: it cannot be put in force.</source>
        <translation>Odrzucono: nie można jej wprowadzić w życie.</translation>
    </message>
    <message>
        <source>May be used: every check is within its limit.</source>
        <translation>Można użyć: każde sprawdzenie mieści się w granicy.</translation>
    </message>
    <message numerus="yes">
        <source>May be used, but %n dimension(s) get more than is allowed.</source>
        <translation>
            <numerusform>Można użyć, ale %n wymiar ma więcej, niż wolno.</numerusform>
            <numerusform>Można użyć, ale %n wymiary mają więcej, niż wolno.</numerusform>
            <numerusform>Można użyć, ale %n wymiarów ma więcej, niż wolno.</numerusform>
        </translation>
    </message>
    <message>
        <source>Next: compare old and new on the right. Nothing is applied before you confirm.</source>
        <translation>Dalej: porównaj po prawej starą i nową. Nic nie jest stosowane przed potwierdzeniem.</translation>
    </message>
    <message>
        <source>Done. Next: start the line and watch the first rail.</source>
        <translation>Gotowe. Dalej: uruchom linię i obserwuj pierwszą szynę.</translation>
    </message>
    <message>
        <source>Next: give the reason and put it in force.</source>
        <translation>Dalej: podaj powód i wprowadź ją w życie.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone. Start the program on the virtual rig.</source>
        <translation>Nie ma układu do podglądu: kreatory patrzą tylko przez układ wirtualny. Uruchom program na układzie wirtualnym.</translation>
    </message>
</context>
<context>
    <name>vignole::SectionDialog</name>
    <message>
        <source>Drawing of a section</source>
        <translation>Rysunek profilu</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Section with its primitives named</source>
        <translation>Profil z nazwanymi prymitywami</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Długość, mm</translation>
    </message>
    <message>
        <source>Radius, mm</source>
        <translation>Promień, mm</translation>
    </message>
    <message>
        <source>Primitives of the section</source>
        <translation>Prymitywy profilu</translation>
    </message>
    <message>
        <source>Name of the section</source>
        <translation>Nazwa profilu</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasa</translation>
    </message>
    <message>
        <source>Profile and straightness class of its recipe</source>
        <translation>Klasa profilu i prostości jego receptury</translation>
    </message>
    <message>
        <source>Open a drawing…</source>
        <translation>Otwórz rysunek…</translation>
    </message>
    <message>
        <source>Open a drawing of a section</source>
        <translation>Otwórz rysunek profilu</translation>
    </message>
    <message>
        <source>Make a draft of it</source>
        <translation>Utwórz szkic</translation>
    </message>
    <message>
        <source>Keep the section and make a draft of it</source>
        <translation>Zachowaj profil i utwórz z niego szkic</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>There is nothing in this file that could be drawn.</source>
        <translation>W tym pliku nie ma nic do narysowania.</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Odrzucono: %1</translation>
    </message>
    <message>
        <source>QA makes drafts: sign in.</source>
        <translation>Szkice tworzy kontrola: zaloguj się.</translation>
    </message>
    <message>
        <source>Open a drawing: one closed outline of lines and arcs, the rail upright.</source>
        <translation>Otwórz rysunek: jeden zamknięty zarys z linii i łuków, szyna stojąca.</translation>
    </message>
    <message>
        <source>DXF, JSON or a MiniProf design</source>
        <translation>DXF, JSON lub projekt MiniProf</translation>
    </message>
    <message numerus="yes">
        <source>%1 mm high, %2 cm², %3 kg/m, %4; %n primitive(s)</source>
        <translation>
            <numerusform>%1 mm wysokości, %2 cm², %3 kg/m, %4; %n prymityw</numerusform>
            <numerusform>%1 mm wysokości, %2 cm², %3 kg/m, %4; %n prymitywy</numerusform>
            <numerusform>%1 mm wysokości, %2 cm², %3 kg/m, %4; %n prymitywów</numerusform>
        </translation>
    </message>
    <message>
        <source>symmetric</source>
        <translation>symetryczny</translation>
    </message>
    <message>
        <source>asymmetric</source>
        <translation>asymetryczny</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>łuk</translation>
    </message>
    <message>
        <source>segment</source>
        <translation>odcinek</translation>
    </message>
    <message>
        <source>A name has letters, digits, spaces, dots and hyphens: it becomes the name of a file.</source>
        <translation>Nazwa ma litery, cyfry, spacje, kropki i łączniki: staje się nazwą pliku.</translation>
    </message>
    <message>
        <source>%1 is a section of the catalogue: give yours another name.</source>
        <translation>%1 to profil z katalogu: nadaj swojemu inną nazwę.</translation>
    </message>
    <message>
        <source>There is another section of the name %1: give a new name.</source>
        <translation>Istnieje inny profil o nazwie %1: podaj nową nazwę.</translation>
    </message>
</context>
<context>
    <name>vignole::SectionDrawing</name>
    <message>
        <source>free end</source>
        <translation>wolny koniec</translation>
    </message>
    <message>
        <source>open here: %1 mm</source>
        <translation>tu otwarte: %1 mm</translation>
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
    <message>
        <source>Rig</source>
        <translation>Stanowisko</translation>
    </message>
    <message>
        <source>drawn from the calibration in force</source>
        <translation>rysowane według obowiązującej kalibracji</translation>
    </message>
    <message>
        <source>This line does not tell its calibration.</source>
        <translation>Ta linia nie podaje swojej kalibracji.</translation>
    </message>
    <message>
        <source>Calibration %1. The rail stands where it was seen last.</source>
        <translation>Kalibracja %1. Szyna stoi tam, gdzie widziano ją ostatnio.</translation>
    </message>
    <message>
        <source>Calibration %1. No rail has been seen yet.</source>
        <translation>Kalibracja %1. Nie widziano jeszcze żadnej szyny.</translation>
    </message>
    <message>
        <source>No site is configured: the four cameras are those of the virtual rig, and every page says SIMULATION. Cameras are measured with on the command line: vignole-cli inspect --source gige.</source>
        <translation>Nie skonfigurowano zakładu: cztery kamery należą do układu wirtualnego, a każda strona mówi SYMULACJA. Z kamerami mierzy wiersz poleceń: vignole-cli inspect --source gige.</translation>
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
    <name>vignole::StepList</name>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Krok %1 z %2: %3</translation>
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
    <message>
        <source>upper left</source>
        <translation>lewa górna</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>prawa górna</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>prawa dolna</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>lewa dolna</translation>
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
        <translation>Próba działa tylko na te obrazy, dopóki nie zostanie zastosowana.</translation>
    </message>
    <message>
        <source>Anybody may try; a technician who has signed in applies.</source>
        <translation>Próbować może każdy; stosuje zalogowany technik.</translation>
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
        <source>Save the picture</source>
        <translation>Zapisz obraz</translation>
    </message>
    <message>
        <source>Lost: %1</source>
        <translation>Utracona: %1</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Wstrzymane</translation>
    </message>
    <message>
        <source>The line has not been started (Ctrl+R).</source>
        <translation>Linii nie uruchomiono (Ctrl+R).</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>sprzed %1</translation>
    </message>
    <message numerus="yes">
        <source>The picture is no longer held: the last %n are.</source>
        <translation>
            <numerusform>Obrazu już nie ma: zachowany jest tylko ostatni (%n).</numerusform>
            <numerusform>Obrazu już nie ma: zachowane są ostatnie %n.</numerusform>
            <numerusform>Obrazu już nie ma: zachowanych jest ostatnich %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>No picture: %1</source>
        <translation>Brak obrazu: %1</translation>
    </message>
    <message>
        <source>Pictures behind the profile at %1 m.</source>
        <translation>Obrazy przekroju na %1 m.</translation>
    </message>
    <message>
        <source>Waits for the next rail; the running rail keeps what it began with.</source>
        <translation>Czeka na następną szynę; bieżąca szyna zachowuje to, z czym zaczęła.</translation>
    </message>
    <message>
        <source>There is no archive, so the change could not be recorded: nothing was changed.</source>
        <translation>Nie ma archiwum, więc zmiany nie można było zapisać: niczego nie zmieniono.</translation>
    </message>
    <message>
        <source>The change is being recorded…</source>
        <translation>Trwa zapis zmiany…</translation>
    </message>
    <message>
        <source>Nothing was changed, because it could not be recorded: %1</source>
        <translation>Niczego nie zmieniono, bo nie można było tego zapisać: %1</translation>
    </message>
    <message>
        <source>Recorded. The exposure changes with the next start of the line, the parameters with the next rail.</source>
        <translation>Zapisano. Ekspozycja zmieni się przy następnym uruchomieniu linii, parametry z następną szyną.</translation>
    </message>
    <message>
        <source>Recorded. Waits for the next rail; the running rail keeps what it began with.</source>
        <translation>Zapisano. Czeka na następną szynę; bieżąca szyna zachowuje to, z czym zaczęła.</translation>
    </message>
    <message>
        <source>Camera %1 has no picture to save.</source>
        <translation>Kamera %1 nie ma obrazu do zapisania.</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Obrazy (*.png)</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>Zapis %1…</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>Zapisano %1.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>Nie można zapisać %1: %2</translation>
    </message>
</context>
<context>
    <name>vignole::StudyPanel</name>
    <message>
        <source>Parameter study</source>
        <translation>Badanie parametrów</translation>
    </message>
    <message>
        <source>Main effects</source>
        <translation>Efekty główne</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Ustawienie</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Poziomy</translation>
    </message>
    <message>
        <source>Settings and their levels</source>
        <translation>Ustawienia i ich poziomy</translation>
    </message>
    <message>
        <source>Influence of each setting</source>
        <translation>Wpływ każdego ustawienia</translation>
    </message>
    <message>
        <source>Placements of the plate</source>
        <translation>Ułożenia płyty</translation>
    </message>
    <message>
        <source>Placements of the plate for the study</source>
        <translation>Ułożenia płyty do badania</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Postęp badania</translation>
    </message>
    <message>
        <source>Start the study</source>
        <translation>Rozpocznij badanie</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Wyjdź</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Zatrzymaj linię</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Raport…</translation>
    </message>
    <message>
        <source>settings and levels</source>
        <translation>ustawienia i poziomy</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Anulowano: nic się nie zmieniło.</translation>
    </message>
    <message>
        <source>Report of the study</source>
        <translation>Raport z badania</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Zapisano: %1</translation>
    </message>
    <message>
        <source>Closed while the line measures: the plate stands where the rail passes. Stop the line to go on.</source>
        <translation>Zamknięte, gdy linia mierzy: płyta stoi tam, gdzie przejeżdża szyna. Zatrzymaj linię, aby kontynuować.</translation>
    </message>
    <message>
        <source>Every combination of the levels is a calibration by the paper&apos;s method on pictures of the plate. Levels are parted by commas; one level or none: the setting is not varied.</source>
        <translation>Każda kombinacja poziomów to kalibracja metodą z artykułu na zdjęciach płyty. Poziomy oddziela się przecinkami; jeden poziom lub żaden: ustawienie się nie zmienia.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Obliczanie…</translation>
    </message>
    <message>
        <source>Next: choose levels and start.</source>
        <translation>Dalej: wybierz poziomy i rozpocznij.</translation>
    </message>
    <message>
        <source>Exposure, ms</source>
        <translation>Ekspozycja, ms</translation>
    </message>
    <message>
        <source>Smoothing σ, px</source>
        <translation>Wygładzanie σ, px</translation>
    </message>
    <message>
        <source>Ellipses a pin</source>
        <translation>Elipsy na kołek</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Dopasowanie</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone.</source>
        <translation>Nie ma układu do podglądu: kreatory patrzą tylko przez układ wirtualny.</translation>
    </message>
</context>
<context>
    <name>vignole::SupportBundle</name>
    <message>
        <source>is there already</source>
        <translation>już istnieje</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>nie można utworzyć</translation>
    </message>
    <message>
        <source>cancelled: nothing is left of it</source>
        <translation>anulowano: nic z niego nie zostało</translation>
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
    <name>vignole::TrialPanel</name>
    <message>
        <source>Line extraction</source>
        <translation>Ekstrakcja linii</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Ekspozycja</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Wygładzanie</translation>
    </message>
    <message>
        <source>Low threshold</source>
        <translation>Próg dolny</translation>
    </message>
    <message>
        <source>High threshold</source>
        <translation>Próg górny</translation>
    </message>
    <message>
        <source>Link distance</source>
        <translation>Odl. łączenia</translation>
    </message>
    <message>
        <source>Link angle</source>
        <translation>Kąt łączenia</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parametr</translation>
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
        <source>%1 on trial</source>
        <translation>%1 na próbę</translation>
    </message>
    <message>
        <source>%1: less</source>
        <translation>%1: mniej</translation>
    </message>
    <message>
        <source>%1: more</source>
        <translation>%1: więcej</translation>
    </message>
    <message>
        <source>Choose camera %1</source>
        <translation>Wybierz kamerę %1</translation>
    </message>
    <message>
        <source>Pixels with the line in use</source>
        <translation>Piksele z linią w użyciu</translation>
    </message>
    <message>
        <source>Pixels with the line on trial</source>
        <translation>Piksele z linią na próbę</translation>
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
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <source>Gained, lost</source>
        <translation>Zyskane, utracone</translation>
    </message>
    <message>
        <source>Saturated points</source>
        <translation>Punkty przesycone</translation>
    </message>
    <message>
        <source>Uncertainty, px</source>
        <translation>Niepewność, px</translation>
    </message>
    <message>
        <source>Shift: mean, largest, px</source>
        <translation>Przesun.: średnie, maks., px</translation>
    </message>
    <message>
        <source>Time, ms</source>
        <translation>Czas, ms</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Zapisz</translation>
    </message>
    <message>
        <source>Save the picture of the chosen camera (Ctrl+S)</source>
        <translation>Zapisz obraz wybranej kamery (Ctrl+S)</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Na żywo</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Zamroź</translation>
    </message>
    <message>
        <source>Live pictures again (P)</source>
        <translation>Znów obrazy na żywo (P)</translation>
    </message>
    <message>
        <source>Freeze the pictures (P)</source>
        <translation>Zamroź obrazy (P)</translation>
    </message>
    <message>
        <source>Freeze the pictures</source>
        <translation>Zamroź obrazy</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Przekrój</translation>
    </message>
    <message>
        <source>The pictures behind the newest profile (B)</source>
        <translation>Obrazy najnowszego przekroju (B)</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Odrzuć</translation>
    </message>
    <message>
        <source>Discard what is on trial</source>
        <translation>Odrzuć to, co jest na próbę</translation>
    </message>
    <message>
        <source>Use from next rail</source>
        <translation>Użyj od następnej</translation>
    </message>
    <message>
        <source>Use what is on trial from the next rail on</source>
        <translation>Użyj tego, co na próbę, od następnej szyny</translation>
    </message>
    <message>
        <source>Reason for the change</source>
        <translation>Powód zmiany</translation>
    </message>
    <message>
        <source>These cameras&apos; exposure cannot be changed from here.</source>
        <translation>Ekspozycji tych kamer nie można stąd zmienić.</translation>
    </message>
    <message>
        <source>camera %1, frozen</source>
        <translation>kamera %1, zamrożona</translation>
    </message>
    <message>
        <source>camera %1, live</source>
        <translation>kamera %1, na żywo</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>brak obrazu</translation>
    </message>
    <message>
        <source>nothing on trial: change a parameter</source>
        <translation>nic na próbę: zmień parametr</translation>
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
<context>
    <name>vignole::WorthTable</name>
    <message>
        <source>Dimension</source>
        <translation>Wymiar</translation>
    </message>
    <message>
        <source>In force</source>
        <translation>Obowiązuje</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nowa</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>Dopuszcz.</translation>
    </message>
    <message>
        <source>Largest part</source>
        <translation>Największy wkład</translation>
    </message>
    <message>
        <source>What the calibration is worth for each dimension</source>
        <translation>Ile kalibracja jest warta dla każdego wymiaru</translation>
    </message>
    <message>
        <source>More than the tolerance allows</source>
        <translation>Więcej, niż dopuszcza tolerancja</translation>
    </message>
    <message>
        <source>too much: %1</source>
        <translation>za dużo: %1</translation>
    </message>
</context>
</TS>
