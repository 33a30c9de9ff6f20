<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES" sourcelanguage="en">
<context>
    <name>AlarmRule</name>
    <message>
        <source>A camera does not answer while a rail passes.</source>
        <translation>Una cámara no responde mientras pasa un carril.</translation>
    </message>
    <message>
        <source>Its quarter of the profile is missing; rails pass unmeasured.</source>
        <translation>Falta su cuarto del perfil; los carriles pasan sin medir.</translation>
    </message>
    <message>
        <source>Check power and network cable of the camera, then Diagnostics; stop the line if it does not come back.</source>
        <translation>Compruebe alimentación y cable de red de la cámara y después Diagnóstico; pare la línea si no vuelve.</translation>
    </message>
    <message>
        <source>Too many triggers give no complete profile.</source>
        <translation>Demasiados disparos no dan un perfil completo.</translation>
    </message>
    <message>
        <source>Stretches of the rail are not measured.</source>
        <translation>Hay tramos del carril sin medir.</translation>
    </message>
    <message>
        <source>See Diagnostics for the camera that loses frames; check network load and trigger.</source>
        <translation>Vea en Diagnóstico qué cámara pierde imágenes; compruebe la carga de red y el disparo.</translation>
    </message>
    <message>
        <source>Too many profiles do not fit the section of the recipe.</source>
        <translation>Demasiados perfiles no encajan con la sección de la receta.</translation>
    </message>
    <message>
        <source>The dimensions of this rail are not to be trusted.</source>
        <translation>Las cotas de este carril no son fiables.</translation>
    </message>
    <message>
        <source>Check that the recipe is the one of the rail that runs; look at Stripes for glare or scale.</source>
        <translation>Compruebe que la receta sea la del carril que pasa; busque reflejos o cascarilla en Líneas láser.</translation>
    </message>
    <message>
        <source>The measurement has stopped while a rail passes.</source>
        <translation>La medición se ha detenido mientras pasa un carril.</translation>
    </message>
    <message>
        <source>Rails pass unmeasured.</source>
        <translation>Los carriles pasan sin medir.</translation>
    </message>
    <message>
        <source>Start the measurement; if it stops again, save a support bundle in Diagnostics.</source>
        <translation>Inicie la medición; si vuelve a pararse, guarde un archivo de soporte en Diagnóstico.</translation>
    </message>
    <message>
        <source>A rail has a stretch out of tolerance.</source>
        <translation>Un carril tiene un tramo fuera de tolerancia.</translation>
    </message>
    <message>
        <source>The rail must not be delivered as it is.</source>
        <translation>El carril no debe entregarse tal como está.</translation>
    </message>
    <message>
        <source>Mark the rail, see its exceptions on Rails, tell the rolling mill which dimension and where.</source>
        <translation>Marque el carril, vea sus excesos en Carriles e informe al laminador de la cota y el lugar.</translation>
    </message>
    <message>
        <source>The rail looks like another section than that of the recipe.</source>
        <translation>El carril parece de otra sección que la de la receta.</translation>
    </message>
    <message>
        <source>It is judged by the wrong tolerances.</source>
        <translation>Se juzga con tolerancias equivocadas.</translation>
    </message>
    <message>
        <source>Choose the recipe of the rail that is rolled.</source>
        <translation>Elija la receta del carril que se lamina.</translation>
    </message>
    <message>
        <source>The calibration in force is refused, missing or out of date.</source>
        <translation>La calibración vigente está rechazada, falta o ha caducado.</translation>
    </message>
    <message>
        <source>Uncertainties are not what the reports state.</source>
        <translation>Las incertidumbres no son las que indican los informes.</translation>
    </message>
    <message>
        <source>Calibrate, or bring back an earlier calibration.</source>
        <translation>Calibre o recupere una calibración anterior.</translation>
    </message>
    <message>
        <source>The seam between two cameras has moved in normal production.</source>
        <translation>La unión entre dos cámaras se ha desplazado en producción normal.</translation>
    </message>
    <message>
        <source>Dimensions across the seam are biased by about as much.</source>
        <translation>Las cotas que cruzan la unión tienen un sesgo similar.</translation>
    </message>
    <message>
        <source>Check the mounting of the cameras beside the seam; calibrate the range finders at the next pause.</source>
        <translation>Compruebe la fijación de las cámaras junto a la unión; calibre los telémetros en la próxima pausa.</translation>
    </message>
    <message>
        <source>A camera loses frames.</source>
        <translation>Una cámara pierde imágenes.</translation>
    </message>
    <message>
        <source>Profiles are incomplete now and then.</source>
        <translation>Algunos perfiles quedan incompletos.</translation>
    </message>
    <message>
        <source>Check cable, switch and packet size of the camera.</source>
        <translation>Compruebe cable, conmutador y tamaño de paquete de la cámara.</translation>
    </message>
    <message>
        <source>Much of a laser line is saturated.</source>
        <translation>Gran parte de una línea láser está saturada.</translation>
    </message>
    <message>
        <source>Points on bright patches are less certain.</source>
        <translation>Los puntos en zonas brillantes son menos seguros.</translation>
    </message>
    <message>
        <source>Shorten the exposure of the camera or clean the window.</source>
        <translation>Acorte la exposición de la cámara o limpie la ventana.</translation>
    </message>
    <message>
        <source>A laser line is faint.</source>
        <translation>Una línea láser es débil.</translation>
    </message>
    <message>
        <source>Points are missing or uncertain.</source>
        <translation>Faltan puntos o son inseguros.</translation>
    </message>
    <message>
        <source>Clean the windows, check the laser, lengthen the exposure.</source>
        <translation>Limpie las ventanas, compruebe el láser, alargue la exposición.</translation>
    </message>
    <message>
        <source>The rig is warmer than its calibration allows.</source>
        <translation>El equipo está más caliente de lo que admite su calibración.</translation>
    </message>
    <message>
        <source>Positions of cameras and lasers move.</source>
        <translation>Las posiciones de cámaras y láseres se desplazan.</translation>
    </message>
    <message>
        <source>Check cooling and air; calibrate if it stays so.</source>
        <translation>Compruebe refrigeración y aire; calibre si persiste.</translation>
    </message>
    <message>
        <source>The disk is nearly full.</source>
        <translation>El disco está casi lleno.</translation>
    </message>
    <message>
        <source>Records of rails cannot be kept.</source>
        <translation>No se podrán guardar los registros de los carriles.</translation>
    </message>
    <message>
        <source>Prune the archive or enlarge the disk.</source>
        <translation>Depure el archivo o amplíe el disco.</translation>
    </message>
    <message>
        <source>The archive does not answer.</source>
        <translation>El archivo no responde.</translation>
    </message>
    <message>
        <source>Rails are measured; their records wait on this machine&apos;s disk.</source>
        <translation>Los carriles se miden; sus registros esperan en el disco de este equipo.</translation>
    </message>
    <message>
        <source>Check database and network; records are sent when it is back.</source>
        <translation>Compruebe base de datos y red; los registros se enviarán cuando vuelva.</translation>
    </message>
    <message>
        <source>The queues of the measurement fill up.</source>
        <translation>Las colas de la medición se llenan.</translation>
    </message>
    <message>
        <source>Profiles will be dropped.</source>
        <translation>Se perderán perfiles.</translation>
    </message>
    <message>
        <source>Close what else runs on this machine; lower the trigger rate.</source>
        <translation>Cierre los demás programas de este equipo; reduzca la frecuencia de disparo.</translation>
    </message>
    <message>
        <source>A toleranced dimension is not measured while a rail passes.</source>
        <translation>Una cota con tolerancia no se mide mientras pasa un carril.</translation>
    </message>
    <message>
        <source>The rail cannot be judged by it.</source>
        <translation>El carril no puede juzgarse por ella.</translation>
    </message>
    <message>
        <source>Clean windows and check lasers; see Stripes for where the line is missing.</source>
        <translation>Limpie ventanas y compruebe láseres; vea en Líneas láser dónde falta la línea.</translation>
    </message>
    <message>
        <source>The window answers slowly.</source>
        <translation>La ventana responde con lentitud.</translation>
    </message>
    <message>
        <source>What it shows is late; the measurement goes on.</source>
        <translation>Lo que muestra llega tarde; la medición continúa.</translation>
    </message>
    <message>
        <source>Close what else runs on this machine; see Diagnostics.</source>
        <translation>Cierre los demás programas de este equipo; vea Diagnóstico.</translation>
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
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>Rail %1 out of tolerance: %2</source>
        <translation>Carril %1 fuera de tolerancia: %2</translation>
    </message>
    <message>
        <source>Camera %1 lost</source>
        <translation>Cámara %1 perdida</translation>
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
        <translation>Altura del carril</translation>
    </message>
    <message>
        <source>Rail flange height</source>
        <translation>Altura de la superficie de embridado</translation>
    </message>
    <message>
        <source>Foot width</source>
        <translation>Anchura del patín</translation>
    </message>
    <message>
        <source>Head form</source>
        <translation>Forma de la cabeza</translation>
    </message>
    <message>
        <source>Head width</source>
        <translation>Anchura de la cabeza</translation>
    </message>
    <message>
        <source>Head width (AREMA)</source>
        <translation>Anchura de la cabeza (AREMA)</translation>
    </message>
    <message>
        <source>Foot thickness left</source>
        <translation>Espesor del patín izquierdo</translation>
    </message>
    <message>
        <source>Foot thickness right</source>
        <translation>Espesor del patín derecho</translation>
    </message>
    <message>
        <source>Rail asymmetry left</source>
        <translation>Asimetría izquierda</translation>
    </message>
    <message>
        <source>Rail asymmetry right</source>
        <translation>Asimetría derecha</translation>
    </message>
    <message>
        <source>Web thickness</source>
        <translation>Espesor del alma</translation>
    </message>
    <message>
        <source>Head radius</source>
        <translation>Radio de la cabeza</translation>
    </message>
    <message>
        <source>Foot concavity</source>
        <translation>Concavidad del patín</translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>Good</source>
        <translation>Conforme</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>Casi al límite</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Fuera</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Sin límite</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Sin medir</translation>
    </message>
    <message>
        <source>not measured, because %1</source>
        <translation>sin medir, porque: %1</translation>
    </message>
    <message>
        <source>%1 above the limit</source>
        <translation>%1 sobre el límite</translation>
    </message>
    <message>
        <source>%1 below the limit</source>
        <translation>%1 bajo el límite</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>Fuera de tolerancia</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Página %1 de %2</translation>
    </message>
    <message>
        <source>No points</source>
        <translation>Sin puntos</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Retenido</translation>
    </message>
    <message>
        <source>No rail found</source>
        <translation>Ningún carril</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Medido</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>Model %1 (approximate)</source>
        <translation>Modelo %1 (aproximado)</translation>
    </message>
    <message>
        <source>Model %1 (invented)</source>
        <translation>Modelo %1 (inventado)</translation>
    </message>
    <message>
        <source>Model %1</source>
        <translation>Modelo %1</translation>
    </message>
    <message>
        <source>Camera 1</source>
        <translation>Cámara 1</translation>
    </message>
    <message>
        <source>deviation %1 %2, ×%3</source>
        <translation>desviación %1 %2, ×%3</translation>
    </message>
    <message>
        <source>Rail %1</source>
        <translation>Carril %1</translation>
    </message>
    <message>
        <source>Rail profile report</source>
        <translation>Informe de perfil de carril</translation>
    </message>
    <message>
        <source>%1   recipe %2   calibration %3</source>
        <translation>%1   receta %2   calibración %3</translation>
    </message>
    <message>
        <source>mm. s: standard deviation along the rail; u, U: standard and expanded uncertainty of one profile; Exc.: stretches out of tolerance.</source>
        <translation>mm. s: desviación típica a lo largo del carril; u, U: incertidumbre típica y expandida de un perfil; Exc.: tramos fuera de tolerancia.</translation>
    </message>
    <message>
        <source>Profile at %1 m</source>
        <translation>Perfil en %1 m</translation>
    </message>
    <message>
        <source>Dimensions along the rail, mm over m</source>
        <translation>Cotas a lo largo del carril, mm sobre m</translation>
    </message>
    <message>
        <source>mean of a stretch</source>
        <translation>media de un tramo</translation>
    </message>
    <message>
        <source>smallest to largest value of the stretch</source>
        <translation>del menor al mayor valor del tramo</translation>
    </message>
    <message>
        <source>expected value</source>
        <translation>valor esperado</translation>
    </message>
    <message>
        <source>limits; the ground outside is grey</source>
        <translation>límites; el fondo exterior es gris</translation>
    </message>
    <message>
        <source>exception, with its square</source>
        <translation>exceso, con su cuadrado</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>sin medir</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>Excesos</translation>
    </message>
    <message>
        <source>Exceptions: none</source>
        <translation>Excesos: ninguno</translation>
    </message>
    <message>
        <source> (continued)</source>
        <translation> (continuación)</translation>
    </message>
    <message>
        <source>the first %1 of %2</source>
        <translation>los primeros %1 de %2</translation>
    </message>
    <message>
        <source>from m</source>
        <translation>desde m</translation>
    </message>
    <message>
        <source>to m</source>
        <translation>hasta m</translation>
    </message>
    <message>
        <source>length m</source>
        <translation>longitud m</translation>
    </message>
    <message>
        <source>worst mm</source>
        <translation>peor mm</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>desviación</translation>
    </message>
    <message>
        <source>beyond limit</source>
        <translation>tras el límite</translation>
    </message>
    <message>
        <source>Triggers</source>
        <translation>Disparos</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>vistos</translation>
    </message>
    <message>
        <source>measured: complete, four contours</source>
        <translation>medidos: completos, cuatro contornos</translation>
    </message>
    <message>
        <source>incomplete: a camera or the registration was missing</source>
        <translation>incompletos: faltó una cámara o el ajuste</translation>
    </message>
    <message>
        <source>lost: no profile</source>
        <translation>perdidos: sin perfil</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>This section is invented: not for acceptance.</source>
        <translation>Esta sección es inventada: no válida para recepción.</translation>
    </message>
    <message>
        <source>This section is approximate: not for acceptance.</source>
        <translation>Esta sección es aproximada: no válida para recepción.</translation>
    </message>
    <message>
        <source>profile at %1 m</source>
        <translation>perfil en %1 m</translation>
    </message>
    <message>
        <source> and </source>
        <translation> y </translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cota</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Nominal</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Mín</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Máx</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Límites</translation>
    </message>
    <message>
        <source>Exc.</source>
        <translation>Exc.</translation>
    </message>
    <message>
        <source>max %1</source>
        <translation>máx %1</translation>
    </message>
    <message>
        <source>min %1</source>
        <translation>mín %1</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Carril</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Colada</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Receta</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Perfiles</translation>
    </message>
    <message>
        <source>Rail temperature</source>
        <translation>Temperatura del carril</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
    <message>
        <source>Measured (UTC)</source>
        <translation>Medido (UTC)</translation>
    </message>
    <message>
        <source>Written (UTC)</source>
        <translation>Escrito (UTC)</translation>
    </message>
    <message>
        <source>Measured (local)</source>
        <translation>Medido (local)</translation>
    </message>
    <message>
        <source>Written (local)</source>
        <translation>Escrito (local)</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>No limits to judge by</source>
        <translation>Sin límites para juzgar</translation>
    </message>
    <message>
        <source>Not valid</source>
        <translation>No válido</translation>
    </message>
    <message>
        <source> out of tolerance</source>
        <translation> fuera de tolerancia</translation>
    </message>
    <message>
        <source> from %1 to %2 m</source>
        <translation> de %1 a %2 m</translation>
    </message>
    <message>
        <source> in %1 stretches, the first at %2 m</source>
        <translation> en %1 tramos, el primero en %2 m</translation>
    </message>
    <message>
        <source> not measured</source>
        <translation> sin medir</translation>
    </message>
    <message>
        <source> not measured, because %1</source>
        <translation> sin medir, porque: %1</translation>
    </message>
    <message>
        <source> near limit</source>
        <translation> casi al límite</translation>
    </message>
    <message>
        <source>%1 toleranced dimensions within their limits over %2 m</source>
        <translation>%1 cotas con tolerancia dentro de sus límites en %2 m</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULACIÓN</translation>
    </message>
    <message>
        <source>Not measured, because %1</source>
        <translation>Sin medir, porque: %1</translation>
    </message>
    <message>
        <source>Lengths refer to 15 °C. U is the expanded uncertainty with k = 2; a value nearer to a limit than U is near limit: it cannot be decided.</source>
        <translation>Las longitudes se refieren a 15 °C. U es la incertidumbre expandida con k = 2; un valor más cerca de un límite que U está casi al límite: no puede decidirse.</translation>
    </message>
    <message>
        <source>mm at 15 °C</source>
        <translation>mm a 15 °C</translation>
    </message>
</context>
<context>
    <name>Engine</name>
    <message>
        <source>wrong section: looks like %1 rather than %2</source>
        <translation>sección equivocada: parece %1 y no %2</translation>
    </message>
    <message>
        <source>wrong section: looks like %1</source>
        <translation>sección equivocada: parece %1</translation>
    </message>
    <message>
        <source>not registered: %1</source>
        <translation>no ajustado: %1</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>no ajustado</translation>
    </message>
    <message>
        <source>looks like %1</source>
        <translation>parece %1</translation>
    </message>
    <message>
        <source>the points do not agree with %1: %2 lie on it, rms %3 mm; another rail, badly worn, or not a rail?</source>
        <translation>los puntos no concuerdan con %1: %2 caen en él, rms %3 mm; ¿otro carril, muy gastado o no es un carril?</translation>
    </message>
    <message>
        <source>the points do not agree with %1</source>
        <translation>los puntos no concuerdan con %1</translation>
    </message>
    <message>
        <source>the section has no web</source>
        <translation>la sección no tiene alma</translation>
    </message>
    <message>
        <source>the points do not determine a pose</source>
        <translation>los puntos no determinan una posición</translation>
    </message>
    <message>
        <source>the foot edge is not upright</source>
        <translation>el borde del patín no es vertical</translation>
    </message>
    <message>
        <source>the crown is flat</source>
        <translation>la superficie de rodadura es plana</translation>
    </message>
    <message>
        <source>points do not reach x = %1 from the axis</source>
        <translation>los puntos no llegan a x = %1 del eje</translation>
    </message>
    <message>
        <source>points do not reach the crown on the axis</source>
        <translation>los puntos no llegan a la rodadura en el eje</translation>
    </message>
    <message>
        <source>points do not reach %1 above the base line</source>
        <translation>los puntos no llegan a %1 sobre la línea base</translation>
    </message>
    <message>
        <source>not defined on this section</source>
        <translation>no definida en esta sección</translation>
    </message>
    <message>
        <source>no point is near the outline of %1</source>
        <translation>ningún punto está cerca del contorno de %1</translation>
    </message>
    <message>
        <source>no base line: %1</source>
        <translation>sin línea base: %1</translation>
    </message>
    <message>
        <source>measurement failed</source>
        <translation>medición fallida</translation>
    </message>
    <message>
        <source>extraction failed</source>
        <translation>extracción fallida</translation>
    </message>
    <message>
        <source>translation failed</source>
        <translation>conversión fallida</translation>
    </message>
    <message>
        <source>the profile is not registered</source>
        <translation>el perfil no está ajustado</translation>
    </message>
    <message>
        <source>no points on %1</source>
        <translation>sin puntos en %1</translation>
    </message>
    <message>
        <source>only %1 point on %2, %3 are needed</source>
        <translation>solo %1 punto en %2, se necesitan %3</translation>
    </message>
    <message>
        <source>only %1 points on %2, %3 are needed</source>
        <translation>solo %1 puntos en %2, se necesitan %3</translation>
    </message>
    <message>
        <source>only %1 points, at least %2 are needed</source>
        <translation>solo %1 puntos, se necesitan al menos %2</translation>
    </message>
    <message>
        <source>the points on %1 make no curve</source>
        <translation>los puntos en %1 no forman una curva</translation>
    </message>
    <message>
        <source>%1 is not fitted</source>
        <translation>%1 no está ajustado</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>sin puntos</translation>
    </message>
    <message>
        <source>no profiles</source>
        <translation>sin perfiles</translation>
    </message>
    <message>
        <source>no frames</source>
        <translation>sin imágenes</translation>
    </message>
    <message>
        <source>no frame</source>
        <translation>sin imagen</translation>
    </message>
    <message>
        <source>frame lost</source>
        <translation>imagen perdida</translation>
    </message>
    <message>
        <source>repeated frame</source>
        <translation>imagen repetida</translation>
    </message>
    <message>
        <source>late frame</source>
        <translation>imagen tardía</translation>
    </message>
    <message>
        <source>too late</source>
        <translation>demasiado tarde</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>detenido</translation>
    </message>
    <message>
        <source>source failed</source>
        <translation>fallo de la fuente</translation>
    </message>
    <message>
        <source>queue overflow</source>
        <translation>cola desbordada</translation>
    </message>
    <message>
        <source>outside of a rail</source>
        <translation>fuera de un carril</translation>
    </message>
    <message>
        <source>missed by all cameras</source>
        <translation>perdido por todas las cámaras</translation>
    </message>
    <message>
        <source>%1 from %2 m</source>
        <translation>%1 desde %2 m</translation>
    </message>
    <message>
        <source>camera %1: %2</source>
        <translation>cámara %1: %2</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>cámara %1</translation>
    </message>
    <message>
        <source>rail %1</source>
        <translation>carril %1</translation>
    </message>
    <message>
        <source>line</source>
        <translation>línea</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>calibración</translation>
    </message>
    <message>
        <source>archive</source>
        <translation>archivo</translation>
    </message>
    <message>
        <source>pipeline</source>
        <translation>cadena de proceso</translation>
    </message>
    <message>
        <source>window</source>
        <translation>ventana</translation>
    </message>
    <message>
        <source>disk</source>
        <translation>disco</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>operador</translation>
    </message>
    <message>
        <source>range finders</source>
        <translation>telémetros</translation>
    </message>
    <message>
        <source>rail %1 has passed: %2</source>
        <translation>ha pasado el carril %1: %2</translation>
    </message>
    <message>
        <source>the line was started</source>
        <translation>se inició la línea</translation>
    </message>
    <message>
        <source>the line was stopped</source>
        <translation>se paró la línea</translation>
    </message>
    <message>
        <source>%1 signed in</source>
        <translation>%1 inició sesión</translation>
    </message>
    <message>
        <source>%1 signed out</source>
        <translation>%1 cerró sesión</translation>
    </message>
    <message>
        <source>good</source>
        <translation>conforme</translation>
    </message>
    <message>
        <source>near limit</source>
        <translation>casi al límite</translation>
    </message>
    <message>
        <source>out of tolerance</source>
        <translation>fuera de tolerancia</translation>
    </message>
    <message>
        <source>no limits</source>
        <translation>sin límites</translation>
    </message>
    <message>
        <source>not valid</source>
        <translation>no válido</translation>
    </message>
    <message>
        <source>is shorter than %1 characters</source>
        <translation>tiene menos de %1 caracteres</translation>
    </message>
    <message>
        <source>the old one is wrong</source>
        <translation>la antigua es incorrecta</translation>
    </message>
    <message>
        <source>too many wrong ones; locked until %1</source>
        <translation>demasiadas erróneas; bloqueado hasta %1</translation>
    </message>
    <message>
        <source>needs a reason; say why</source>
        <translation>necesita un motivo; diga por qué</translation>
    </message>
    <message>
        <source>an entry needs who and what</source>
        <translation>una entrada necesita quién y qué</translation>
    </message>
    <message>
        <source>password</source>
        <translation>contraseña</translation>
    </message>
    <message>
        <source>is no user here</source>
        <translation>no es usuario aquí</translation>
    </message>
    <message>
        <source>is longer than 1024 bytes</source>
        <translation>tiene más de 1024 bytes</translation>
    </message>
    <message>
        <source>a name has 1 to 64 characters</source>
        <translation>un nombre tiene de 1 a 64 caracteres</translation>
    </message>
    <message>
        <source>the first user must be an administrator</source>
        <translation>el primer usuario debe ser administrador</translation>
    </message>
    <message>
        <source>is a user already</source>
        <translation>ya es usuario</translation>
    </message>
    <message>
        <source>is the last administrator; make another one first</source>
        <translation>es el último administrador; nombre antes otro</translation>
    </message>
    <message>
        <source>there is none</source>
        <translation>no hay ninguno</translation>
    </message>
    <message>
        <source>no archive was asked for (--archive)</source>
        <translation>no se pidió archivo (--archive)</translation>
    </message>
    <message>
        <source>exact (virtual rig)</source>
        <translation>exacta (equipo virtual)</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>plano</translation>
    </message>
    <message>
        <source>none (generated numbers)</source>
        <translation>ninguna (números generados)</translation>
    </message>
</context>
<context>
    <name>Judgement</name>
    <message>
        <source>from %1 on</source>
        <translation>desde %1</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>%1 %2 above the limit %3</source>
        <translation>%1 %2 sobre el límite %3</translation>
    </message>
    <message>
        <source>%1 %2 below the limit %3</source>
        <translation>%1 %2 bajo el límite %3</translation>
    </message>
    <message>
        <source>%1 beyond the limit %2</source>
        <translation>%1 tras el límite %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>camera %1 lost</source>
        <translation>cámara %1 perdida</translation>
    </message>
    <message>
        <source>cameras %1 lost</source>
        <translation>cámaras %1 perdidas</translation>
    </message>
    <message>
        <source>%1 dimensions</source>
        <translation>%1 cotas</translation>
    </message>
    <message>
        <source>Not valid</source>
        <translation>No válido</translation>
    </message>
    <message>
        <source>%1 not measured from %2 on: %3</source>
        <translation>%1 sin medir desde %2: %3</translation>
    </message>
    <message>
        <source>%1 near limit</source>
        <translation>%1 casi al límite</translation>
    </message>
    <message>
        <source>single profiles outside the limits</source>
        <translation>algunos perfiles fuera de los límites</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>Fuera de tolerancia</translation>
    </message>
    <message>
        <source>%1 %2 inside the limit, closer than U</source>
        <translation>%1 %2 dentro del límite, más cerca que U</translation>
    </message>
    <message>
        <source>%1 %2 outside the limit, by less than U</source>
        <translation>%1 %2 fuera del límite, por menos de U</translation>
    </message>
    <message>
        <source>within the guard band earlier on this rail</source>
        <translation>antes en la banda de guarda en este carril</translation>
    </message>
    <message>
        <source>%1 within the guard band earlier on this rail</source>
        <translation>%1 antes en la banda de guarda en este carril</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>Casi al límite</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Conforme</translation>
    </message>
    <message>
        <source>%1 dimensions within limits up to %2</source>
        <translation>%1 cotas dentro de límites hasta %2</translation>
    </message>
    <message>
        <source>Waiting for a rail</source>
        <translation>Esperando carril</translation>
    </message>
    <message>
        <source>the gauge is ready; values appear with the head of the rail</source>
        <translation>el medidor está listo; los valores aparecen con la cabeza del carril</translation>
    </message>
    <message>
        <source>the line is not running: Ctrl+R starts it</source>
        <translation>la línea no está en marcha: Ctrl+R la inicia</translation>
    </message>
    <message>
        <source>No limits</source>
        <translation>Sin límites</translation>
    </message>
    <message>
        <source>the recipe gives no tolerance to any dimension</source>
        <translation>la receta no da tolerancia a ninguna cota</translation>
    </message>
    <message>
        <source>this rail was not measured completely</source>
        <translation>este carril no se midió por completo</translation>
    </message>
    <message>
        <source>%1 not measured on enough of this rail</source>
        <translation>%1 sin medir en parte suficiente de este carril</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>En reposo</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Lista</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Midiendo</translation>
    </message>
    <message>
        <source>No profiles</source>
        <translation>Sin perfiles</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Parada</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fallo</translation>
    </message>
    <message>
        <source>no profiles since %1, %2 ago. Hold this rail.</source>
        <translation>sin perfiles desde %1, hace %2. Retenga este carril.</translation>
    </message>
    <message>
        <source>held: last profile at %1, %2 ago</source>
        <translation>retenido: último perfil en %1, hace %2</translation>
    </message>
    <message>
        <source>%1 of %2 cameras, %3 profiles/s</source>
        <translation>%1 de %2 cámaras, %3 perfiles/s</translation>
    </message>
    <message>
        <source>no profiles for %1</source>
        <translation>sin perfiles desde hace %1</translation>
    </message>
    <message>
        <source>calibration %1</source>
        <translation>calibración %1</translation>
    </message>
    <message>
        <source>Not trusted</source>
        <translation>No fiable</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Sin datos</translation>
    </message>
    <message>
        <source>no profile yet</source>
        <translation>aún sin perfil</translation>
    </message>
    <message>
        <source>the line is not running</source>
        <translation>la línea no está en marcha</translation>
    </message>
    <message>
        <source>Degraded</source>
        <translation>Degradado</translation>
    </message>
    <message>
        <source>%1 of %2 incomplete</source>
        <translation>%1 de %2 incompletos</translation>
    </message>
    <message>
        <source>Trusted</source>
        <translation>Fiable</translation>
    </message>
    <message>
        <source>The line is stopped: Ctrl+R starts it</source>
        <translation>La línea está parada: Ctrl+R la inicia</translation>
    </message>
    <message>
        <source>Ready for the next rail</source>
        <translation>Lista para el próximo carril</translation>
    </message>
    <message>
        <source>No alarm on this rail</source>
        <translation>Ninguna alarma en este carril</translation>
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
        <translation>Líneas láser</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Rails</source>
        <translation>Carriles</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recetas</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Calidad</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmas</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnóstico</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
</context>
<context>
    <name>Role</name>
    <message>
        <source>Operator</source>
        <translation>Operador</translation>
    </message>
    <message>
        <source>Technician</source>
        <translation>Técnico</translation>
    </message>
    <message>
        <source>QA</source>
        <translation>Calidad</translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation>Administrador</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmCard</name>
    <message>
        <source>comes and goes</source>
        <translation>va y viene</translation>
    </message>
    <message>
        <source>on for more than a day</source>
        <translation>activa más de un día</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>desaparecida</translation>
    </message>
    <message>
        <source>acknowledged by %1</source>
        <translation>reconocida por %1</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarma</numerusform>
            <numerusform>%n alarmas</numerusform>
        </translation>
    </message>
    <message>
        <source>Priority %1</source>
        <translation>Prioridad %1</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Causa</translation>
    </message>
    <message>
        <source>Consequence</source>
        <translation>Consecuencia</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Reconocer</translation>
    </message>
    <message>
        <source>Acknowledge: %1</source>
        <translation>Reconocer: %1</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmHistoryPanel</name>
    <message>
        <source>What happened</source>
        <translation>Qué ocurrió</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmas</translation>
    </message>
    <message>
        <source>Show the alarms that came and went</source>
        <translation>Mostrar las alarmas pasadas</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Eventos</translation>
    </message>
    <message>
        <source>Show events</source>
        <translation>Mostrar eventos</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Exportar como CSV</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>Llegó</translation>
    </message>
    <message>
        <source>Went</source>
        <translation>Se fue</translation>
    </message>
    <message>
        <source>Lasted</source>
        <translation>Duró</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarma</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalles</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Por</translation>
    </message>
    <message>
        <source>Alarms that came and went, newest first</source>
        <translation>Alarmas pasadas, primero la más reciente</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Evento</translation>
    </message>
    <message>
        <source>Events, newest first</source>
        <translation>Eventos, primero el más reciente</translation>
    </message>
    <message>
        <source>still on</source>
        <translation>aún activa</translation>
    </message>
    <message>
        <source>shelved: %1</source>
        <translation>aplazada: %1</translation>
    </message>
    <message>
        <source>nobody yet</source>
        <translation>nadie aún</translation>
    </message>
    <message>
        <source>no alarm so far</source>
        <translation>ninguna alarma hasta ahora</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarma</numerusform>
            <numerusform>%n alarmas</numerusform>
        </translation>
    </message>
    <message>
        <source>no event so far</source>
        <translation>ningún evento hasta ahora</translation>
    </message>
    <message numerus="yes">
        <source>%n event(s)</source>
        <translation>
            <numerusform>%n evento</numerusform>
            <numerusform>%n eventos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 está escrito</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 no se puede escribir: %2</translation>
    </message>
    <message>
        <source>program ended</source>
        <translation>fin del programa</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmLine</name>
    <message>
        <source>Alarm, priority %1: %2. %3</source>
        <translation>Alarma, prioridad %1: %2. %3</translation>
    </message>
    <message>
        <source>1 of %1</source>
        <translation>1 de %1</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) acknowledged, still on</source>
        <translation>
            <numerusform>%n alarma reconocida, aún activa</numerusform>
            <numerusform>%n alarmas reconocidas, aún activas</numerusform>
        </translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Reconocer</translation>
    </message>
    <message>
        <source>Acknowledge the shown alarm</source>
        <translation>Reconocer la alarma mostrada</translation>
    </message>
    <message>
        <source>Acknowledge the shown alarm (Ctrl+A)</source>
        <translation>Reconocer la alarma mostrada (Ctrl+A)</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmsPage</name>
    <message>
        <source>Active</source>
        <translation>Activas</translation>
    </message>
    <message>
        <source>Acknowledge page</source>
        <translation>Reconocer página</translation>
    </message>
    <message>
        <source>Acknowledge all that are shown</source>
        <translation>Reconocer todas las mostradas</translation>
    </message>
    <message>
        <source>Acknowledge all that are shown (Ctrl+Shift+A)</source>
        <translation>Reconocer todas las mostradas (Ctrl+Mayús+A)</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarma</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Frecuencia</translation>
    </message>
    <message>
        <source>10 min</source>
        <translation>10 min</translation>
    </message>
    <message>
        <source>Hour</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Día</translation>
    </message>
    <message>
        <source>Shelve</source>
        <translation>Aplazar</translation>
    </message>
    <message>
        <source>hides an alarm for a while</source>
        <translation>oculta una alarma un tiempo</translation>
    </message>
    <message>
        <source>Alarm to shelve</source>
        <translation>Alarma que aplazar</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Reason for shelving</source>
        <translation>Motivo del aplazamiento</translation>
    </message>
    <message>
        <source>For how long</source>
        <translation>Por cuánto tiempo</translation>
    </message>
    <message>
        <source>Shelved</source>
        <translation>Aplazadas</translation>
    </message>
    <message>
        <source>comes back by itself</source>
        <translation>vuelve por sí sola</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Bring back the chosen alarm</source>
        <translation>Recuperar la alarma elegida</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Shelved alarms</source>
        <translation>Alarmas aplazadas</translation>
    </message>
    <message>
        <source>An operator may shelve for %1 minutes at most.</source>
        <translation>Un operador puede aplazar %1 minutos como máximo.</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarma</numerusform>
            <numerusform>%n alarmas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not acknowledged</source>
        <translation>
            <numerusform>%n sin reconocer</numerusform>
            <numerusform>%n sin reconocer</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is wrong. Alarms appear here with their cause, their consequence and what to do.</source>
        <translation>Todo está bien. Las alarmas aparecen aquí con su causa, su consecuencia y qué hacer.</translation>
    </message>
    <message>
        <source>since the program started</source>
        <translation>desde que se inició el programa</translation>
    </message>
    <message>
        <source>Flood: more than 10 alarms in 10 minutes. Look for one cause behind them.</source>
        <translation>Avalancha: más de 10 alarmas en 10 minutos. Busque una causa común.</translation>
    </message>
    <message>
        <source>Target: below 1 in 10 minutes; above 10 it is a flood.</source>
        <translation>Objetivo: menos de 1 en 10 minutos; más de 10 es una avalancha.</translation>
    </message>
    <message>
        <source>alarms in 10 minutes</source>
        <translation>alarmas en 10 minutos</translation>
    </message>
    <message>
        <source>Health of the alarms</source>
        <translation>Salud de las alarmas</translation>
    </message>
    <message>
        <source>flood: grouped by rule</source>
        <translation>avalancha: agrupadas por regla</translation>
    </message>
    <message>
        <source>Mean per 10 minutes</source>
        <translation>Media en 10 minutos</translation>
    </message>
    <message>
        <source>%1, target below 1</source>
        <translation>%1, objetivo &lt; 1</translation>
    </message>
    <message>
        <source>Floods</source>
        <translation>Avalanchas</translation>
    </message>
    <message>
        <source>Comes and goes</source>
        <translation>Va y viene</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>On for more than a day</source>
        <translation>Activa más de un día</translation>
    </message>
    <message>
        <source>Shelving needs a reason.</source>
        <translation>Aplazar necesita un motivo.</translation>
    </message>
</context>
<context>
    <name>vignole::AuditPanel</name>
    <message>
        <source>Audit trail</source>
        <translation>Registro de auditoría</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Quién</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>Of what</source>
        <translation>De qué</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Audit trail, newest first</source>
        <translation>Registro de auditoría, primero lo más reciente</translation>
    </message>
    <message>
        <source>Check the chain</source>
        <translation>Comprobar la cadena</translation>
    </message>
    <message>
        <source>Check that no entry was changed, put in or taken out</source>
        <translation>Comprobar que ninguna entrada se cambió, añadió o quitó</translation>
    </message>
    <message>
        <source>The audit trail is shown to QA and administrators who have signed in.</source>
        <translation>El registro de auditoría se muestra a calidad y administradores con sesión iniciada.</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s), the newest first</source>
        <translation>
            <numerusform>%n entrada, primero la más reciente</numerusform>
            <numerusform>%n entradas, primero la más reciente</numerusform>
        </translation>
    </message>
    <message>
        <source>checking …</source>
        <translation>comprobando …</translation>
    </message>
    <message>
        <source>The chain is whole: no entry was changed, put in or taken out.</source>
        <translation>La cadena está íntegra: ninguna entrada se cambió, añadió ni quitó.</translation>
    </message>
    <message>
        <source>The chain is broken: %1</source>
        <translation>La cadena está rota: %1</translation>
    </message>
</context>
<context>
    <name>vignole::ChartsPage</name>
    <message>
        <source>Dimensions</source>
        <translation>Cotas</translation>
    </message>
    <message>
        <source>Dimension that is charted</source>
        <translation>Cota representada</translation>
    </message>
    <message>
        <source>Rail that is charted</source>
        <translation>Carril representado</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Whole range</source>
        <translation>Rango completo</translation>
    </message>
    <message>
        <source>Whole range (0)</source>
        <translation>Rango completo (0)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Export the chart as picture, PDF or CSV</source>
        <translation>Exportar el gráfico como imagen, PDF o CSV</translation>
    </message>
    <message>
        <source>Dimension along the rail</source>
        <translation>Cota a lo largo del carril</translation>
    </message>
    <message>
        <source>Dimension rail by rail</source>
        <translation>Cota carril por carril</translation>
    </message>
    <message>
        <source>Histogram of the rail</source>
        <translation>Histograma del carril</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histograma</translation>
    </message>
    <message>
        <source>same scale, this rail</source>
        <translation>misma escala, este carril</translation>
    </message>
    <message>
        <source>Per rail</source>
        <translation>Por carril</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Cifras</translation>
    </message>
    <message>
        <source>this rail</source>
        <translation>este carril</translation>
    </message>
    <message>
        <source>Figures of the rail</source>
        <translation>Cifras del carril</translation>
    </message>
    <message>
        <source>Rails are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>Los carriles no se guardan: %1. Inicie el programa con un archivo (--archive FILE).</translation>
    </message>
    <message>
        <source>No rail has been measured yet. Its chart appears here when it has passed.</source>
        <translation>Aún no se ha medido ningún carril. Su gráfico aparecerá aquí cuando haya pasado.</translation>
    </message>
    <message>
        <source>Newest rail</source>
        <translation>Carril más reciente</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>longitud, m</translation>
    </message>
    <message>
        <source>%1 along the rail</source>
        <translation>%1 a lo largo del carril</translation>
    </message>
    <message>
        <source>rail %1, %2 profiles</source>
        <translation>carril %1, %2 perfiles</translation>
    </message>
    <message>
        <source>; no band: %1 of %2 other rails</source>
        <translation>; sin banda: %1 de %2 otros carriles</translation>
    </message>
    <message>
        <source>; band: last %1 rails, 10 to 90 %</source>
        <translation>; banda: últimos %1 carriles, 10 a 90 %</translation>
    </message>
    <message>
        <source>same scale, longest bar %1 %</source>
        <translation>misma escala, barra mayor %1 %</translation>
    </message>
    <message>
        <source>rail</source>
        <translation>carril</translation>
    </message>
    <message numerus="yes">
        <source>mean with smallest and largest value, last %n rail(s) of this section</source>
        <translation>
            <numerusform>media con el menor y el mayor valor, último carril de esta sección</numerusform>
            <numerusform>media con el menor y el mayor valor, últimos %n carriles de esta sección</numerusform>
        </translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Desviación típica</translation>
    </message>
    <message>
        <source>Smallest, largest</source>
        <translation>Menor, mayor</translation>
    </message>
    <message>
        <source>Uncertainty U (k = 2)</source>
        <translation>Incertidumbre U (k = 2)</translation>
    </message>
    <message>
        <source>Beyond a limit</source>
        <translation>Tras un límite</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>In the guard band</source>
        <translation>En la banda de guarda</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Sin medir</translation>
    </message>
    <message>
        <source>Room to the nearer limit</source>
        <translation>Margen al límite más cercano</translation>
    </message>
    <message>
        <source>Move over the chart or press Left and Right to read values; wheel or + and − zoom, drag moves.</source>
        <translation>Pase sobre el gráfico o pulse izquierda y derecha para leer valores; rueda o + y − amplían, arrastrar desplaza.</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>not measured: %1</source>
        <translation>sin medir: %1</translation>
    </message>
    <message>
        <source>%1   %2 %3   U ±%4   %5 from expected   %6</source>
        <translation>%1   %2 %3   U ±%4   %5 del esperado   %6</translation>
    </message>
    <message>
        <source>Export the chart</source>
        <translation>Exportar el gráfico</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 está escrito</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 no se puede escribir</translation>
    </message>
</context>
<context>
    <name>vignole::DiagnosticsPage</name>
    <message>
        <source>Pipeline</source>
        <translation>Cadena de proceso</translation>
    </message>
    <message>
        <source>Every trigger accounted for</source>
        <translation>Cada disparo tiene cuenta</translation>
    </message>
    <message>
        <source>since the line was started</source>
        <translation>desde el inicio de la línea</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Support file…</source>
        <translation>Archivo de soporte…</translation>
    </message>
    <message>
        <source>Save a support file</source>
        <translation>Guardar un archivo de soporte</translation>
    </message>
    <message>
        <source>Where every trigger went</source>
        <translation>Adónde fue cada disparo</translation>
    </message>
    <message>
        <source>Counters of the cameras</source>
        <translation>Contadores de las cámaras</translation>
    </message>
    <message>
        <source>Load of the computer</source>
        <translation>Carga del equipo</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Frames/s</source>
        <translation>Imágenes/s</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Faltan</translation>
    </message>
    <message>
        <source>held, %1 old</source>
        <translation>retenido, hace %1</translation>
    </message>
    <message>
        <source>%1 profiles/s of %2 expected</source>
        <translation>%1 perfiles/s de %2 esperados</translation>
    </message>
    <message>
        <source>Triggers</source>
        <translation>Disparos</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Medido</translation>
    </message>
    <message>
        <source>Incomplete: measured by fewer cameras</source>
        <translation>Incompletos: medidos con menos cámaras</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Perdidos</translation>
    </message>
    <message>
        <source>Not accounted for</source>
        <translation>Sin cuenta</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>En curso</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Cámara %1</translation>
    </message>
    <message>
        <source>: lost</source>
        <translation>: perdida</translation>
    </message>
    <message>
        <source>Rendered cameras: no packets to be sent again, no temperature.</source>
        <translation>Cámaras simuladas: sin reenvío de paquetes, sin temperatura.</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Disco</translation>
    </message>
    <message>
        <source>%1 of %2 GB free</source>
        <translation>%1 de %2 GB libres</translation>
    </message>
    <message>
        <source>make room: nearly full</source>
        <translation>haga sitio: casi lleno</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>open</source>
        <translation>abierto</translation>
    </message>
    <message>
        <source>none: rails are not kept</source>
        <translation>ninguno: los carriles no se guardan</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Procesador</translation>
    </message>
    <message>
        <source>%1 % of one core</source>
        <translation>%1 % de un núcleo</translation>
    </message>
    <message numerus="yes">
        <source>%n core(s)</source>
        <translation>
            <numerusform>%n núcleo</numerusform>
            <numerusform>%n núcleos</numerusform>
        </translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Memoria</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>turn p99 %1 ms</source>
        <translation>vuelta p99 %1 ms</translation>
    </message>
    <message>
        <source>p50 %1, largest %2, limit 50 ms</source>
        <translation>p50 %1, mayor %2, límite 50 ms</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Pantalla</translation>
    </message>
    <message>
        <source>the window&apos;s thread</source>
        <translation>el hilo de la ventana</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 no se puede escribir: %2</translation>
    </message>
</context>
<context>
    <name>vignole::DimensionModel</name>
    <message>
        <source>Not measured</source>
        <translation>Sin medir</translation>
    </message>
    <message>
        <source>Not measured, because %1</source>
        <translation>Sin medir, porque: %1</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sin límite</translation>
    </message>
    <message>
        <source>limits %1 to %2</source>
        <translation>límites %1 a %2</translation>
    </message>
    <message>
        <source>waiting for a profile</source>
        <translation>esperando un perfil</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cota</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Desviación</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Tolerance and guard band</source>
        <translation>Tolerancia y banda de guarda</translation>
    </message>
    <message>
        <source>Along the rail</source>
        <translation>A lo largo del carril</translation>
    </message>
    <message>
        <source>Not meas.</source>
        <translation>Sin medir</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Retenido</translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es) out of tolerance</source>
        <translation>
            <numerusform>%n tramo fuera de tolerancia</numerusform>
            <numerusform>%n tramos fuera de tolerancia</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 %3, deviation %4, U %5, %6</source>
        <translation>%1, %2 %3, desviación %4, U %5, %6</translation>
    </message>
</context>
<context>
    <name>vignole::DimensionTable</name>
    <message>
        <source>Dimensions</source>
        <translation>Cotas</translation>
    </message>
</context>
<context>
    <name>vignole::HeaderBar</name>
    <message>
        <source>Rail</source>
        <translation>Carril</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Colada</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Receta</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Gauge</source>
        <translation>Medidor</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>Tema claro</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>Tema oscuro</translation>
    </message>
    <message>
        <source>Other theme (Ctrl+D)</source>
        <translation>Otro tema (Ctrl+D)</translation>
    </message>
    <message>
        <source>%1: sign in</source>
        <translation>%1: iniciar sesión</translation>
    </message>
    <message>
        <source>%1, %2: sign out</source>
        <translation>%1, %2: cerrar sesión</translation>
    </message>
    <message>
        <source>Sign in (Ctrl+L)</source>
        <translation>Iniciar sesión (Ctrl+L)</translation>
    </message>
    <message>
        <source>%1: sign out (Ctrl+L)</source>
        <translation>%1: cerrar sesión (Ctrl+L)</translation>
    </message>
    <message>
        <source>Line: %1</source>
        <translation>Línea: %1</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULACIÓN</translation>
    </message>
    <message>
        <source>Simulation: the rails are not real</source>
        <translation>Simulación: los carriles no son reales</translation>
    </message>
    <message>
        <source>The rails come from the virtual rig</source>
        <translation>Los carriles provienen del equipo virtual</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
</context>
<context>
    <name>vignole::LastRails</name>
    <message>
        <source>Out</source>
        <translation>Fuera</translation>
    </message>
    <message>
        <source>, held</source>
        <translation>, retenido</translation>
    </message>
    <message>
        <source>, now</source>
        <translation>, ahora</translation>
    </message>
    <message>
        <source>good %1 of %2</source>
        <translation>conf. %1 de %2</translation>
    </message>
    <message>
        <source>Last rails: %1</source>
        <translation>Últimos carriles: %1</translation>
    </message>
    <message>
        <source>Last rails</source>
        <translation>Últimos</translation>
    </message>
</context>
<context>
    <name>vignole::MainWindow</name>
    <message>
        <source>Is this rail good?</source>
        <translation>¿Es bueno este carril?</translation>
    </message>
    <message>
        <source>The large word is the verdict of the rail so far; beside it stands whether the gauge can be trusted. Both are made for two metres&apos; distance.</source>
        <translation>La palabra grande es el veredicto del carril hasta ahora; al lado, si el medidor es fiable. Ambos se leen a dos metros.</translation>
    </message>
    <message>
        <source>The measured profile</source>
        <translation>El perfil medido</translation>
    </message>
    <message>
        <source>The rail as it is measured, over its section; deviations are drawn twenty times larger. Keys 1 to 4 show whole, head, web and foot, + and − change the magnification, C colours by camera.</source>
        <translation>El carril medido sobre su sección; las desviaciones se dibujan veinte veces mayores. Las teclas 1 a 4 muestran todo, cabeza, alma y patín; + y − cambian la ampliación; C colorea por cámara.</translation>
    </message>
    <message>
        <source>Every dimension</source>
        <translation>Cada cota</translation>
    </message>
    <message>
        <source>Value, deviation, uncertainty and where it lies in its tolerance; the hatched ends are closer to a limit than the uncertainty. Choose a row to see the dimension in the drawing.</source>
        <translation>Valor, desviación, incertidumbre y su lugar en la tolerancia; los extremos rayados están más cerca de un límite que la incertidumbre. Elija una fila para ver la cota en el dibujo.</translation>
    </message>
    <message>
        <source>What runs</source>
        <translation>Qué está en marcha</translation>
    </message>
    <message>
        <source>The line, the rail and who is here. SIMULATION: without a site the rails come from a virtual rig, measured by the real engine.</source>
        <translation>La línea, el carril y quién está aquí. SIMULACIÓN: sin instalación, los carriles provienen de un equipo virtual, medidos por el motor real.</translation>
    </message>
    <message>
        <source>Ten pages</source>
        <translation>Diez páginas</translation>
    </message>
    <message>
        <source>F1 to F10, in this order: rails that passed are on F4, alarms on F8, language, units and people on F10. Ctrl+R stops and starts the line.</source>
        <translation>F1 a F10, en este orden: los carriles pasados en F4, las alarmas en F8, idioma, unidades y personas en F10. Ctrl+R para e inicia la línea.</translation>
    </message>
    <message>
        <source>Close Vignole</source>
        <translation>Cerrar Vignole</translation>
    </message>
    <message>
        <source>A rail is being measured.</source>
        <translation>Se está midiendo un carril.</translation>
    </message>
    <message>
        <source>What has been measured of it is kept; the rest would pass unmeasured.</source>
        <translation>Lo medido se guarda; el resto pasaría sin medir.</translation>
    </message>
    <message>
        <source>Close after this rail</source>
        <translation>Cerrar tras este carril</translation>
    </message>
    <message>
        <source>Close now</source>
        <translation>Cerrar ahora</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Quedarse</translation>
    </message>
</context>
<context>
    <name>vignole::MonitorPage</name>
    <message>
        <source>Whole</source>
        <translation>Todo</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Cabeza</translation>
    </message>
    <message>
        <source>Web</source>
        <translation>Alma</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Patín</translation>
    </message>
    <message>
        <source>View: %1</source>
        <translation>Vista: %1</translation>
    </message>
    <message>
        <source>%1 of the section (%2)</source>
        <translation>%1, de la sección (%2)</translation>
    </message>
    <message>
        <source>Magnify deviations less</source>
        <translation>Ampliar menos las desviaciones</translation>
    </message>
    <message>
        <source>Magnify deviations less (−)</source>
        <translation>Ampliar menos las desviaciones (−)</translation>
    </message>
    <message>
        <source>Deviations are drawn so many times larger (0: back to 20)</source>
        <translation>Las desviaciones se dibujan tantas veces mayores (0: vuelve a 20)</translation>
    </message>
    <message>
        <source>Magnify deviations more</source>
        <translation>Ampliar más las desviaciones</translation>
    </message>
    <message>
        <source>Magnify deviations more (+)</source>
        <translation>Ampliar más las desviaciones (+)</translation>
    </message>
    <message>
        <source>By camera</source>
        <translation>Por cámara</translation>
    </message>
    <message>
        <source>Colour points by camera</source>
        <translation>Colorear los puntos por cámara</translation>
    </message>
    <message>
        <source>Colour points by camera (C)</source>
        <translation>Colorear los puntos por cámara (C)</translation>
    </message>
    <message>
        <source>Drawing in full view</source>
        <translation>Dibujo a pantalla completa</translation>
    </message>
    <message>
        <source>Drawing in full view (F11)</source>
        <translation>Dibujo a pantalla completa (F11)</translation>
    </message>
    <message>
        <source>Stop line</source>
        <translation>Parar línea</translation>
    </message>
    <message>
        <source>Start line</source>
        <translation>Iniciar línea</translation>
    </message>
    <message>
        <source>%1 (Ctrl+R)</source>
        <translation>%1 (Ctrl+R)</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>sin valor</translation>
    </message>
</context>
<context>
    <name>vignole::NextRailDialog</name>
    <message>
        <source>Next rail</source>
        <translation>Próximo carril</translation>
    </message>
    <message>
        <source>What is entered here goes with the next rail that begins. An empty field stays as the line has it.</source>
        <translation>Lo que se introduce aquí va con el próximo carril que empiece. Un campo vacío queda como lo tiene la línea.</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Carril</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Colada</translation>
    </message>
    <message>
        <source>Strand</source>
        <translation>Línea de colada</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Pedido</translation>
    </message>
    <message>
        <source>Temperature, °C</source>
        <translation>Temperatura, °C</translation>
    </message>
    <message>
        <source>For the next rail</source>
        <translation>Para el próximo carril</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Waits for the next rail.</source>
        <translation>Espera al próximo carril.</translation>
    </message>
    <message>
        <source>%1 waits for the next rail.</source>
        <translation>%1 espera al próximo carril.</translation>
    </message>
    <message>
        <source>The rail has begun with what was entered.</source>
        <translation>El carril ha empezado con lo introducido.</translation>
    </message>
    <message>
        <source>The temperature is no number from %1 to %2 °C.</source>
        <translation>La temperatura no es un número de %1 a %2 °C.</translation>
    </message>
    <message>
        <source>Nothing was entered: fill in at least one field.</source>
        <translation>No se introdujo nada: rellene al menos un campo.</translation>
    </message>
    <message>
        <source>Nothing waits: the next rail is named by the line.</source>
        <translation>Nada espera: el próximo carril lo nombra la línea.</translation>
    </message>
</context>
<context>
    <name>vignole::PeoplePanel</name>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
    <message>
        <source>Names and roles are the administrator&apos;s: sign in as administrator to see and enter people.</source>
        <translation>Nombres y roles son cosa del administrador: inicie sesión como administrador para ver y dar de alta personas.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rol</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Last here</source>
        <translation>Última vez</translation>
    </message>
    <message>
        <source>People who may sign in</source>
        <translation>Personas que pueden iniciar sesión</translation>
    </message>
    <message>
        <source>Name of the new person</source>
        <translation>Nombre de la persona nueva</translation>
    </message>
    <message>
        <source>First or new password</source>
        <translation>Primera o nueva contraseña</translation>
    </message>
    <message>
        <source>First password of the new person</source>
        <translation>Primera contraseña de la persona nueva</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Reason for entering the person</source>
        <translation>Motivo del alta</translation>
    </message>
    <message>
        <source>Role of the new person</source>
        <translation>Rol de la persona nueva</translation>
    </message>
    <message>
        <source>Enter a person</source>
        <translation>Dar de alta</translation>
    </message>
    <message>
        <source>Give a new password</source>
        <translation>Dar una contraseña nueva</translation>
    </message>
    <message>
        <source>Give the chosen person a new password</source>
        <translation>Dar a la persona elegida una contraseña nueva</translation>
    </message>
    <message>
        <source>Give this role</source>
        <translation>Dar este rol</translation>
    </message>
    <message>
        <source>Give the chosen person this role</source>
        <translation>Dar este rol a la persona elegida</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>cerrada</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueada</translation>
    </message>
    <message>
        <source>chooses a password</source>
        <translation>elige contraseña</translation>
    </message>
    <message>
        <source>open</source>
        <translation>abierto</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nunca</translation>
    </message>
    <message>
        <source>Open the account</source>
        <translation>Abrir la cuenta</translation>
    </message>
    <message>
        <source>Close the account</source>
        <translation>Cerrar la cuenta</translation>
    </message>
    <message>
        <source>Open the account of the chosen person</source>
        <translation>Abrir la cuenta de la persona elegida</translation>
    </message>
    <message>
        <source>Close the account of the chosen person</source>
        <translation>Cerrar la cuenta de la persona elegida</translation>
    </message>
    <message>
        <source>%1 is entered.</source>
        <translation>%1 está dado de alta.</translation>
    </message>
    <message>
        <source>%1 has a new password and chooses another at the next sign-in.</source>
        <translation>%1 tiene una contraseña nueva y elegirá otra en el próximo inicio.</translation>
    </message>
    <message>
        <source>%1 is now %2.</source>
        <translation>%1 es ahora %2.</translation>
    </message>
    <message>
        <source>The account of %1 is closed.</source>
        <translation>La cuenta de %1 está cerrada.</translation>
    </message>
    <message>
        <source>The account of %1 is open.</source>
        <translation>La cuenta de %1 está abierta.</translation>
    </message>
</context>
<context>
    <name>vignole::PipelinePanel</name>
    <message>
        <source>Pipeline: %1 triggers, %2 measured, %3 incomplete, %4 lost</source>
        <translation>Cadena: %1 disparos, %2 medidos, %3 incompletos, %4 perdidos</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>sin datos</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>SD %1   UCL %2</source>
        <translation>DT %1   LCS %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Acquisition</source>
        <translation>Adquisición</translation>
    </message>
    <message>
        <source>Line extraction</source>
        <translation>Extracción de línea</translation>
    </message>
    <message>
        <source>2D to 3D</source>
        <translation>2D a 3D</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Perfil</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Medición</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Cámara %1</translation>
    </message>
    <message>
        <source>mean time of a stage, SD standard deviation, UCL upper limit of the 99 % confidence interval; of a queue now (dark), highest fill (mark) and size</source>
        <translation>tiempo medio de una etapa, DT desviación típica, LCS límite superior del intervalo de confianza del 99 %; de una cola: ahora (oscuro), llenado máximo (marca) y tamaño</translation>
    </message>
</context>
<context>
    <name>vignole::ProfileCanvas</name>
    <message>
        <source>Measured profile over the section</source>
        <translation>Perfil medido sobre la sección</translation>
    </message>
    <message>
        <source>last profile at %1 m, %2 ago</source>
        <translation>último perfil en %1 m, hace %2</translation>
    </message>
</context>
<context>
    <name>vignole::QualityPage</name>
    <message>
        <source>Repeatability</source>
        <translation>Repetibilidad</translation>
    </message>
    <message>
        <source>runs of the same rail</source>
        <translation>pasadas del mismo carril</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Pasada</translation>
    </message>
    <message>
        <source>Length, m</source>
        <translation>Longitud, m</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Medido</translation>
    </message>
    <message>
        <source>Rails that may be laid over each other</source>
        <translation>Carriles que pueden superponerse</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cota</translation>
    </message>
    <message>
        <source>Single profiles</source>
        <translation>Perfiles individuales</translation>
    </message>
    <message>
        <source>Means over 0.1 m</source>
        <translation>Medias sobre 0,1 m</translation>
    </message>
    <message>
        <source>Means over 1 m</source>
        <translation>Medias sobre 1 m</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>Qué se compara</translation>
    </message>
    <message>
        <source>Compare the chosen runs</source>
        <translation>Comparar las pasadas elegidas</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Export values and ranges as CSV</source>
        <translation>Exportar valores y rangos como CSV</translation>
    </message>
    <message>
        <source>Values over the length</source>
        <translation>Valores a lo largo</translation>
    </message>
    <message>
        <source>as Fig. 9a</source>
        <translation>como Fig. 9a</translation>
    </message>
    <message>
        <source>Range of the runs</source>
        <translation>Rango de las pasadas</translation>
    </message>
    <message>
        <source>as Fig. 9b</source>
        <translation>como Fig. 9b</translation>
    </message>
    <message>
        <source>Values of every run over the length</source>
        <translation>Valores de cada pasada a lo largo</translation>
    </message>
    <message>
        <source>Range of the runs over the length</source>
        <translation>Rango de las pasadas a lo largo</translation>
    </message>
    <message>
        <source>Mean range</source>
        <translation>Rango medio</translation>
    </message>
    <message>
        <source>per 10 m, as Table VI</source>
        <translation>por 10 m, como Tabla VI</translation>
    </message>
    <message>
        <source>From – to, m</source>
        <translation>De – a, m</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Posiciones</translation>
    </message>
    <message>
        <source>Mean range, section by section</source>
        <translation>Rango medio, tramo a tramo</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Cifras</translation>
    </message>
    <message>
        <source>Figures of the study</source>
        <translation>Cifras del estudio</translation>
    </message>
    <message>
        <source>Runs come from the archive, and there is none: %1. Start the program with --archive FILE.</source>
        <translation>Las pasadas vienen del archivo y no hay ninguno: %1. Inicie el programa con --archive FILE.</translation>
    </message>
    <message>
        <source>At least 2 runs of the same rail are needed, %1 chosen; the paper took 5.</source>
        <translation>Se necesitan al menos 2 pasadas del mismo carril, %1 elegidas; el artículo usó 5.</translation>
    </message>
    <message>
        <source>reading …</source>
        <translation>leyendo …</translation>
    </message>
    <message>
        <source>No rail has been kept yet. Runs of the same rail are compared here.</source>
        <translation>Aún no se ha guardado ningún carril. Aquí se comparan pasadas del mismo carril.</translation>
    </message>
    <message>
        <source>Tick the runs that were made of the same rail, choose a dimension and compare.</source>
        <translation>Marque las pasadas del mismo carril, elija una cota y compare.</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>longitud, m</translation>
    </message>
    <message>
        <source>range</source>
        <translation>rango</translation>
    </message>
    <message>
        <source>range, %1</source>
        <translation>rango, %1</translation>
    </message>
    <message>
        <source>Runs, positions</source>
        <translation>Pasadas, posiciones</translation>
    </message>
    <message>
        <source>Repeatability s_r</source>
        <translation>Repetibilidad s_r</translation>
    </message>
    <message>
        <source>its 95 % interval</source>
        <translation>su intervalo del 95 %</translation>
    </message>
    <message>
        <source>Limit r = 2.8 s_r</source>
        <translation>Límite r = 2,8 s_r</translation>
    </message>
    <message>
        <source>Largest range</source>
        <translation>Rango mayor</translation>
    </message>
    <message>
        <source>s from the range</source>
        <translation>s por el rango</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autocorrelación</translation>
    </message>
    <message>
        <source>%1, critical %2 (1 %)</source>
        <translation>%1, crítico %2 (1 %)</translation>
    </message>
    <message>
        <source>Grubbs, means of the runs</source>
        <translation>Grubbs, medias de las pasadas</translation>
    </message>
    <message>
        <source>Cochran, scatter of the runs</source>
        <translation>Cochran, dispersión de las pasadas</translation>
    </message>
    <message>
        <source>, %1 positions left out: a run lacks them</source>
        <translation>, %1 posiciones omitidas: faltan en una pasada</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Exportar como CSV</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 está escrito</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 no se puede escribir</translation>
    </message>
</context>
<context>
    <name>vignole::RailBand</name>
    <message>
        <source>Place along the rail</source>
        <translation>Lugar en el carril</translation>
    </message>
</context>
<context>
    <name>vignole::RailsPage</name>
    <message>
        <source>Rails</source>
        <translation>Carriles</translation>
    </message>
    <message>
        <source>Rail or heat, from its beginning</source>
        <translation>Carril o colada, desde el principio</translation>
    </message>
    <message>
        <source>Search by rail or heat</source>
        <translation>Buscar por carril o colada</translation>
    </message>
    <message>
        <source>Any verdict</source>
        <translation>Cualquier veredicto</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>Fuera de tolerancia</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>Casi al límite</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Conforme</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Sin medir</translation>
    </message>
    <message>
        <source>Any dimension</source>
        <translation>Cualquier cota</translation>
    </message>
    <message>
        <source>%1 out</source>
        <translation>%1 fuera</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Dimension out of tolerance</source>
        <translation>Cota fuera de tolerancia</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Carril</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Colada</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Peor</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Rails found</source>
        <translation>Carriles encontrados</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Informe…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Informe en PDF</translation>
    </message>
    <message>
        <source>Report as PDF (Ctrl+P)</source>
        <translation>Informe en PDF (Ctrl+P)</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Volver al directo</translation>
    </message>
    <message>
        <source>Along the rail</source>
        <translation>A lo largo del carril</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>Excesos</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cota</translation>
    </message>
    <message>
        <source>From – to, m</source>
        <translation>De – a, m</translation>
    </message>
    <message>
        <source>Worst, mm</source>
        <translation>Peor, mm</translation>
    </message>
    <message>
        <source>Limits, mm</source>
        <translation>Límites, mm</translation>
    </message>
    <message>
        <source>Stretches out of tolerance</source>
        <translation>Tramos fuera de tolerancia</translation>
    </message>
    <message>
        <source>Previous exception</source>
        <translation>Exceso anterior</translation>
    </message>
    <message>
        <source>Previous exception (Shift+N)</source>
        <translation>Exceso anterior (Mayús+N)</translation>
    </message>
    <message>
        <source>Next exception</source>
        <translation>Exceso siguiente</translation>
    </message>
    <message>
        <source>Next exception (N)</source>
        <translation>Exceso siguiente (N)</translation>
    </message>
    <message>
        <source>Play along the rail</source>
        <translation>Reproducir a lo largo del carril</translation>
    </message>
    <message>
        <source>Play or pause (P)</source>
        <translation>Reproducir o pausar (P)</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Perfil</translation>
    </message>
    <message>
        <source>No rail is open</source>
        <translation>Ningún carril abierto</translation>
    </message>
    <message>
        <source>Choose a rail in the list: its profile, its dimensions along the rail and its exceptions are shown here.</source>
        <translation>Elija un carril en la lista: aquí se muestran su perfil, sus cotas a lo largo y sus excesos.</translation>
    </message>
    <message>
        <source>Rails are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>Los carriles no se guardan: %1. Inicie el programa con un archivo (--archive FILE).</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en curso</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>dentro</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>No rail is like that. Clear the search or choose other filters.</source>
        <translation>Ningún carril es así. Borre la búsqueda o elija otros filtros.</translation>
    </message>
    <message>
        <source>No rail has been measured yet. Rails appear here when they have passed.</source>
        <translation>Aún no se ha medido ningún carril. Aparecerán aquí cuando hayan pasado.</translation>
    </message>
    <message>
        <source>Replay: not live.  Rail %1, %2 to %3, recipe %4, calibration %5</source>
        <translation>Reproducción: no en directo.  Carril %1, %2 a %3, receta %4, calibración %5</translation>
    </message>
    <message>
        <source>none: every dimension stayed within its limits</source>
        <translation>ninguno: todas las cotas dentro de límites</translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es)</source>
        <translation>
            <numerusform>%n tramo</numerusform>
            <numerusform>%n tramos</numerusform>
        </translation>
    </message>
    <message>
        <source>The profile cannot be drawn: %1.</source>
        <translation>El perfil no se puede dibujar: %1.</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Profile at %1 m</source>
        <translation>Perfil en %1 m</translation>
    </message>
    <message>
        <source>no. %1 of %2</source>
        <translation>n.º %1 de %2</translation>
    </message>
    <message>
        <source>: points were not kept of this rail, the model is shown</source>
        <translation>: no se guardaron puntos de este carril, se muestra el modelo</translation>
    </message>
    <message>
        <source>; drawn is no. %1, the nearest whose points were kept</source>
        <translation>; se dibuja el n.º %1, el más cercano con puntos guardados</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>sin valor</translation>
    </message>
    <message>
        <source>writing %1 …</source>
        <translation>escribiendo %1 …</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 está escrito</translation>
    </message>
    <message>
        <source>Any time</source>
        <translation>Cualquier fecha</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Hoy</translation>
    </message>
    <message>
        <source>7 days</source>
        <translation>7 días</translation>
    </message>
    <message>
        <source>4 weeks</source>
        <translation>4 semanas</translation>
    </message>
    <message>
        <source>12 months</source>
        <translation>12 meses</translation>
    </message>
    <message>
        <source>Any section</source>
        <translation>Cualquier sección</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Clear search and filters</source>
        <translation>Borrar búsqueda y filtros</translation>
    </message>
    <message>
        <source>What if…</source>
        <translation>Y si…</translation>
    </message>
    <message>
        <source>Judge the rails found with other limits</source>
        <translation>Juzgar los carriles encontrados con otros límites</translation>
    </message>
    <message>
        <source>Next rail…</source>
        <translation>Próximo carril…</translation>
    </message>
    <message>
        <source>Enter the papers of the next rail</source>
        <translation>Introducir los datos del próximo carril</translation>
    </message>
    <message>
        <source>Export as CSV or JSON</source>
        <translation>Exportar como CSV o JSON</translation>
    </message>
    <message>
        <source>Export as CSV or JSON (Ctrl+E)</source>
        <translation>Exportar como CSV o JSON (Ctrl+E)</translation>
    </message>
    <message>
        <source>Nothing new is kept: nobody writes into this archive.</source>
        <translation>No se guarda nada nuevo: nadie escribe en este archivo.</translation>
    </message>
    <message>
        <source>Nothing is kept. Live rails are shown on Monitor only.</source>
        <translation>No se guarda nada. Los carriles en directo solo se ven en Monitor.</translation>
    </message>
    <message>
        <source>kept: %1 rails, %2 profiles waiting</source>
        <translation>guardados: %1 carriles, %2 perfiles en espera</translation>
    </message>
    <message>
        <source>; %1 profiles lost</source>
        <translation>; %1 perfiles perdidos</translation>
    </message>
    <message>
        <source>; points of %1 profiles left out</source>
        <translation>; puntos de %1 perfiles omitidos</translation>
    </message>
    <message>
        <source>Nothing can be written: %1. What passes waits in memory.</source>
        <translation>No se puede escribir: %1. Lo que pasa espera en memoria.</translation>
    </message>
</context>
<context>
    <name>vignole::RateChart</name>
    <message>
        <source>Alarms in each ten minutes of the last %1 hours: at most %2</source>
        <translation>Alarmas cada diez minutos en las últimas %1 horas: %2 como máximo</translation>
    </message>
    <message>
        <source>flood above %1</source>
        <translation>avalancha: más de %1</translation>
    </message>
    <message>
        <source>hours; dotted at %1: target</source>
        <translation>horas; punteado en %1: objetivo</translation>
    </message>
</context>
<context>
    <name>vignole::RecipesPage</name>
    <message>
        <source>Draft</source>
        <translation>Borrador</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>Aprobada</translation>
    </message>
    <message>
        <source>Retired</source>
        <translation>Retirada</translation>
    </message>
    <message>
        <source>With the program</source>
        <translation>Con el programa</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recetas</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Receta</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Versión</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Recipes and their versions</source>
        <translation>Recetas y sus versiones</translation>
    </message>
    <message>
        <source>Section of the new recipe</source>
        <translation>Sección de la receta nueva</translation>
    </message>
    <message>
        <source>Profile and straightness class of the new recipe</source>
        <translation>Clase de perfil y rectitud de la receta nueva</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nueva</translation>
    </message>
    <message>
        <source>New draft from section and class</source>
        <translation>Borrador nuevo de sección y clase</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importar…</translation>
    </message>
    <message>
        <source>Import a recipe file as a draft</source>
        <translation>Importar un archivo de receta como borrador</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Export the chosen recipe</source>
        <translation>Exportar la receta elegida</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cota</translation>
    </message>
    <message>
        <source>Nominal, mm</source>
        <translation>Nominal, mm</translation>
    </message>
    <message>
        <source>Lower, mm</source>
        <translation>Inferior, mm</translation>
    </message>
    <message>
        <source>Upper, mm</source>
        <translation>Superior, mm</translation>
    </message>
    <message>
        <source>Tolerances of the chosen recipe</source>
        <translation>Tolerancias de la receta elegida</translation>
    </message>
    <message>
        <source>What is new in it</source>
        <translation>Qué tiene de nuevo</translation>
    </message>
    <message>
        <source>What is new in the draft</source>
        <translation>Qué hay de nuevo en el borrador</translation>
    </message>
    <message>
        <source>Save as a new draft</source>
        <translation>Guardar como borrador nuevo</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>Recipe to compare with</source>
        <translation>Receta con la que comparar</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>There</source>
        <translation>Allí</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Aquí</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Qué difiere</translation>
    </message>
    <message>
        <source>Approval</source>
        <translation>Aprobación</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Reason for the approval</source>
        <translation>Motivo de la aprobación</translation>
    </message>
    <message>
        <source>Your password</source>
        <translation>Su contraseña</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Aprobar</translation>
    </message>
    <message>
        <source>Approve the draft</source>
        <translation>Aprobar el borrador</translation>
    </message>
    <message>
        <source>against %1 v%2, %3</source>
        <translation>frente a %1 v%2, %3</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolerancias</translation>
    </message>
    <message>
        <source>%1 v%2</source>
        <translation>%1 v%2</translation>
    </message>
    <message>
        <source>%1, by %2</source>
        <translation>%1, por %2</translation>
    </message>
    <message>
        <source>Both are the same.</source>
        <translation>Ambas son iguales.</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n valor</numerusform>
            <numerusform>%n valores</numerusform>
        </translation>
    </message>
    <message>
        <source>Only a draft is approved.</source>
        <translation>Solo se aprueba un borrador.</translation>
    </message>
    <message>
        <source>QA approves: sign in.</source>
        <translation>Aprueba calidad: inicie sesión.</translation>
    </message>
    <message>
        <source>This draft is yours: somebody else approves it.</source>
        <translation>Este borrador es suyo: lo aprueba otra persona.</translation>
    </message>
    <message>
        <source>Approval retires the version before; reason and password go with your name into the audit trail.</source>
        <translation>La aprobación retira la versión anterior; motivo y contraseña van con su nombre al registro de auditoría.</translation>
    </message>
    <message>
        <source>%1 v%2 is kept as a draft.</source>
        <translation>%1 v%2 se guarda como borrador.</translation>
    </message>
    <message>
        <source>%1: the lower limit lies above the upper one; exchange them.</source>
        <translation>%1: el límite inferior está sobre el superior; intercámbielos.</translation>
    </message>
    <message>
        <source>%1: a limit is a number in mm, or empty for none.</source>
        <translation>%1: un límite es un número en mm, o vacío si no hay.</translation>
    </message>
    <message>
        <source>Say what is new in the draft.</source>
        <translation>Diga qué hay de nuevo en el borrador.</translation>
    </message>
    <message>
        <source>Approved.</source>
        <translation>Aprobada.</translation>
    </message>
    <message>
        <source>Import a recipe file</source>
        <translation>Importar un archivo de receta</translation>
    </message>
    <message>
        <source>Export the recipe</source>
        <translation>Exportar la receta</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 está escrito</translation>
    </message>
</context>
<context>
    <name>vignole::ReplayCanvas</name>
    <message>
        <source>Profile of the stored rail</source>
        <translation>Perfil del carril guardado</translation>
    </message>
</context>
<context>
    <name>vignole::SettingsPage</name>
    <message>
        <source>Screen</source>
        <translation>Pantalla</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Longitudes</translation>
    </message>
    <message>
        <source>Unit of lengths</source>
        <translation>Unidad de longitud</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Milímetros</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pulgadas</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>No site is configured: the four cameras are those of the virtual rig, and every page says SIMULATION. Cameras with GigE Vision are not part of this version.</source>
        <translation>No hay instalación configurada: las cuatro cámaras son las del equipo virtual y cada página dice SIMULACIÓN. Las cámaras GigE Vision no forman parte de esta versión.</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Acerca de</translation>
    </message>
    <message>
        <source>Vignole %1: rail profiles in millimetres, with their uncertainty. Licence GPL-3.0-or-later.</source>
        <translation>Vignole %1: perfiles de carril en milímetros, con su incertidumbre. Licencia GPL-3.0-or-later.</translation>
    </message>
    <message>
        <source>There is none: %1. Rails are measured and not kept. Start the program with --archive FILE.</source>
        <translation>No hay: %1. Los carriles se miden y no se guardan. Inicie el programa con --archive FILE.</translation>
    </message>
    <message>
        <source>%1
%2 rails are kept.</source>
        <translation>%1
Se guardan %2 carriles.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Language of the screen</source>
        <translation>Idioma de la pantalla</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>Grupos de ajustes</translation>
    </message>
    <message>
        <source>Who is here</source>
        <translation>Quién está aquí</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>Registro de auditoría</translation>
    </message>
    <message>
        <source>of this machine; kept for the next start</source>
        <translation>de este equipo; se guarda para el próximo inicio</translation>
    </message>
    <message>
        <source>Show the tour</source>
        <translation>Mostrar la visita</translation>
    </message>
    <message>
        <source>Show the tour of Monitor</source>
        <translation>Mostrar la visita de Monitor</translation>
    </message>
</context>
<context>
    <name>vignole::SignInPanel</name>
    <message>
        <source>Who is here</source>
        <translation>Quién está aquí</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Contraseña</translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation>Cerrar sesión</translation>
    </message>
    <message>
        <source>Enter as the first administrator</source>
        <translation>Alta como primer administrador</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Iniciar sesión</translation>
    </message>
    <message>
        <source>Nobody can sign in: people are kept in the archive, and there is none (%1).</source>
        <translation>Nadie puede iniciar sesión: las personas se guardan en el archivo y no hay ninguno (%1).</translation>
    </message>
    <message>
        <source>After a quarter of an hour without a key or a touch it is the operator&apos;s screen again.</source>
        <translation>Tras un cuarto de hora sin tecla ni toque vuelve a ser la pantalla del operador.</translation>
    </message>
    <message>
        <source>Nobody is entered yet. The first one is the administrator and enters the others; the password has at least 8 characters.</source>
        <translation>Aún no hay nadie dado de alta. El primero es el administrador y da de alta a los demás; la contraseña tiene al menos 8 caracteres.</translation>
    </message>
    <message>
        <source>Without signing in this is the operator&apos;s screen: it measures, shows and acknowledges.</source>
        <translation>Sin iniciar sesión es la pantalla del operador: mide, muestra y reconoce.</translation>
    </message>
    <message>
        <source>Name and password are both needed.</source>
        <translation>Se necesitan nombre y contraseña.</translation>
    </message>
    <message>
        <source>Name or password is wrong.</source>
        <translation>Nombre o contraseña incorrectos.</translation>
    </message>
    <message>
        <source>This account is closed; ask the administrator.</source>
        <translation>Esta cuenta está cerrada; consulte al administrador.</translation>
    </message>
    <message>
        <source>Too many wrong passwords: locked until %1.</source>
        <translation>Demasiadas contraseñas erróneas: bloqueado hasta %1.</translation>
    </message>
    <message>
        <source>New password, at least 8 characters</source>
        <translation>Contraseña nueva, al menos 8 caracteres</translation>
    </message>
    <message>
        <source>New password</source>
        <translation>Contraseña nueva</translation>
    </message>
    <message>
        <source>Change the password</source>
        <translation>Cambiar la contraseña</translation>
    </message>
    <message>
        <source>Present password</source>
        <translation>Contraseña actual</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>This password was given by somebody else: choose one of your own.</source>
        <translation>Esta contraseña la dio otra persona: elija una propia.</translation>
    </message>
    <message>
        <source>The password is changed.</source>
        <translation>La contraseña ha cambiado.</translation>
    </message>
    <message>
        <source>The password is changed: sign in with it.</source>
        <translation>La contraseña ha cambiado: inicie sesión con ella.</translation>
    </message>
</context>
<context>
    <name>vignole::StripChart</name>
    <message>
        <source>%1 along the rail: %2</source>
        <translation>%1 a lo largo del carril: %2</translation>
    </message>
</context>
<context>
    <name>vignole::StripeView</name>
    <message>
        <source>Camera %1</source>
        <translation>Cámara %1</translation>
    </message>
    <message>
        <source>brightness along the line</source>
        <translation>brillo a lo largo de la línea</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Saturated</source>
        <translation>Saturado</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Ruido</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Trozos</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>trigger %1</source>
        <translation>disparo %1</translation>
    </message>
    <message>
        <source>no picture yet</source>
        <translation>aún sin imagen</translation>
    </message>
</context>
<context>
    <name>vignole::StripesPage</name>
    <message>
        <source>Line extraction</source>
        <translation>Extracción de línea</translation>
    </message>
    <message>
        <source>Smoothing σ</source>
        <translation>Suavizado σ</translation>
    </message>
    <message>
        <source>Low threshold t_l</source>
        <translation>Umbral bajo t_l</translation>
    </message>
    <message>
        <source>High threshold t_h</source>
        <translation>Umbral alto t_h</translation>
    </message>
    <message>
        <source>Link distance d</source>
        <translation>Distancia de enlace d</translation>
    </message>
    <message>
        <source>Link angle α</source>
        <translation>Ángulo de enlace α</translation>
    </message>
    <message>
        <source>%1 on trial</source>
        <translation>%1 a prueba</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>En uso</translation>
    </message>
    <message>
        <source>On trial</source>
        <translation>A prueba</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>In use against on trial</source>
        <translation>En uso frente a prueba</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Guardar imagen…</translation>
    </message>
    <message>
        <source>Save the picture of the chosen camera</source>
        <translation>Guardar la imagen de la cámara elegida</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Discard what is on trial</source>
        <translation>Descartar lo que está a prueba</translation>
    </message>
    <message>
        <source>Use from next start</source>
        <translation>Usar desde el próximo inicio</translation>
    </message>
    <message>
        <source>Use what is on trial from the next start of the line</source>
        <translation>Usar lo probado desde el próximo inicio de la línea</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Reason for the change</source>
        <translation>Motivo del cambio</translation>
    </message>
    <message>
        <source>Live again</source>
        <translation>Otra vez en directo</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Congelar</translation>
    </message>
    <message>
        <source>Freeze the pictures</source>
        <translation>Congelar las imágenes</translation>
    </message>
    <message>
        <source>Freeze the pictures (P)</source>
        <translation>Congelar las imágenes (P)</translation>
    </message>
    <message>
        <source>What is tried acts on these pictures alone until it is applied.</source>
        <translation>Lo que se prueba actúa solo en estas imágenes hasta que se aplica.</translation>
    </message>
    <message>
        <source>Anybody may try; a technician who has signed in applies.</source>
        <translation>Cualquiera puede probar; aplica un técnico con sesión iniciada.</translation>
    </message>
    <message>
        <source>lost: %1</source>
        <translation>perdida: %1</translation>
    </message>
    <message>
        <source>held, %1 old</source>
        <translation>retenido, hace %1</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>Congelado</translation>
    </message>
    <message>
        <source>This source hands out no pictures.</source>
        <translation>Esta fuente no entrega imágenes.</translation>
    </message>
    <message>
        <source>Nothing is on trial: change a parameter first.</source>
        <translation>Nada a prueba: cambie antes un parámetro.</translation>
    </message>
    <message>
        <source>A change of the measurement needs a reason.</source>
        <translation>Un cambio de la medición necesita un motivo.</translation>
    </message>
    <message>
        <source>Is used from the next start of the line (Ctrl+R stops and starts it); the running rail keeps what it began with.</source>
        <translation>Se usa desde el próximo inicio de la línea (Ctrl+R para e inicia); el carril en curso conserva lo que tenía.</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>cámara %1</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Saturated, %</source>
        <translation>Saturado, %</translation>
    </message>
    <message>
        <source>Uncertainty, px</source>
        <translation>Incertidumbre, px</translation>
    </message>
    <message>
        <source>Time, ms</source>
        <translation>Tiempo, ms</translation>
    </message>
    <message>
        <source>Mean shift, px</source>
        <translation>Desplaz. medio, px</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Guardar la imagen</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 está escrito</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 no se puede escribir</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Cámara %1</translation>
    </message>
</context>
<context>
    <name>vignole::TolerancePlot</name>
    <message>
        <source>lower limit %1</source>
        <translation>límite inferior %1</translation>
    </message>
    <message>
        <source>upper limit %1</source>
        <translation>límite superior %1</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>esperado %1</translation>
    </message>
</context>
<context>
    <name>vignole::Tour</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Cerrar (Esc)</translation>
    </message>
    <message>
        <source>Close the tour</source>
        <translation>Cerrar la visita</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Empezar</translation>
    </message>
</context>
<context>
    <name>vignole::VerdictPanel</name>
    <message>
        <source>Verdict: %1, %2. Gauge: %3</source>
        <translation>Veredicto: %1, %2. Medidor: %3</translation>
    </message>
    <message>
        <source>Gauge: %1</source>
        <translation>Medidor: %1</translation>
    </message>
    <message>
        <source>SIMULATION, %1</source>
        <translation>SIMULACIÓN, %1</translation>
    </message>
</context>
<context>
    <name>vignole::WhatIfDialog</name>
    <message>
        <source>What if</source>
        <translation>Y si</translation>
    </message>
    <message>
        <source>The rails that were found are judged again with other limits, from what is stored of every profile. Nothing that is stored changes.</source>
        <translation>Los carriles encontrados se juzgan de nuevo con otros límites, según lo guardado de cada perfil. Nada de lo guardado cambia.</translation>
    </message>
    <message>
        <source>Profile class</source>
        <translation>Clase de perfil</translation>
    </message>
    <message>
        <source>Straightness class</source>
        <translation>Clase de rectitud</translation>
    </message>
    <message>
        <source>As in the recipe</source>
        <translation>Como en la receta</translation>
    </message>
    <message>
        <source>lower, %1</source>
        <translation>inferior, %1</translation>
    </message>
    <message>
        <source>upper, %1</source>
        <translation>superior, %1</translation>
    </message>
    <message>
        <source>Lower limit of %1, deviation</source>
        <translation>Límite inferior de %1, desviación</translation>
    </message>
    <message>
        <source>Upper limit of %1, deviation</source>
        <translation>Límite superior de %1, desviación</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Carril</translation>
    </message>
    <message>
        <source>Was</source>
        <translation>Era</translation>
    </message>
    <message>
        <source>Would be</source>
        <translation>Sería</translation>
    </message>
    <message>
        <source>Because of</source>
        <translation>A causa de</translation>
    </message>
    <message>
        <source>Rails whose verdict would change</source>
        <translation>Carriles cuyo veredicto cambiaría</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>A limit of %1 is no number. An empty field is no limit.</source>
        <translation>Un límite de %1 no es un número. Un campo vacío es sin límite.</translation>
    </message>
    <message>
        <source>The lower limit of %1 is above the upper one: exchange them.</source>
        <translation>El límite inferior de %1 está sobre el superior: intercámbielos.</translation>
    </message>
    <message>
        <source>%1 of %2 rails judged</source>
        <translation>%1 de %2 carriles juzgados</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Probar</translation>
    </message>
    <message>
        <source>Stop judging</source>
        <translation>Parar el juicio</translation>
    </message>
    <message>
        <source>Judge the rails with these limits</source>
        <translation>Juzgar los carriles con estos límites</translation>
    </message>
    <message>
        <source>No rail of this section is in the list. Search for rails first.</source>
        <translation>Ningún carril de esta sección en la lista. Busque antes carriles.</translation>
    </message>
    <message>
        <source>Judging …</source>
        <translation>Juzgando …</translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s) of section %1</source>
        <translation>
            <numerusform>%n carril de la sección %1</numerusform>
            <numerusform>%n carriles de la sección %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Fewer than %1 rails prove little.</source>
        <translation>Menos de %1 carriles prueban poco.</translation>
    </message>
    <message>
        <source>Choose a class or enter deviations from nominal, then Try. Empty: no limit.</source>
        <translation>Elija una clase o introduzca desviaciones del nominal y pulse Probar. Vacío: sin límite.</translation>
    </message>
    <message>
        <source>%1 of %2 rails would change their verdict</source>
        <translation>%1 de %2 carriles cambiarían su veredicto</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 a %3</translation>
    </message>
    <message>
        <source>stopped before all %1 were judged</source>
        <translation>parado antes de juzgar los %1</translation>
    </message>
    <message numerus="yes">
        <source>%n could not be judged: %1</source>
        <translation>
            <numerusform>%n no pudo juzgarse: %1</numerusform>
            <numerusform>%n no pudieron juzgarse: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>fewer than %1 rails prove little</source>
        <translation>menos de %1 carriles prueban poco</translation>
    </message>
</context>
</TS>
