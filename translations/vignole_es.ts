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
    <message>
        <source>Before registration</source>
        <translation>Antes del ajuste</translation>
    </message>
    <message>
        <source>across %1, up %2 %3, turned %4°</source>
        <translation>a través %1, arriba %2 %3, girado %4°</translation>
    </message>
    <message>
        <source>As seen</source>
        <translation>Como se ve</translation>
    </message>
    <message>
        <source>Registered</source>
        <translation>Ajustado</translation>
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
    <name>RecipeSetting</name>
    <message>
        <source>Section</source>
        <translation>Sección</translation>
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
        <source>RFH: distance from the axis, mm</source>
        <translation>RFH: distancia al eje, mm</translation>
    </message>
    <message>
        <source>HF: half width of the crown, mm</source>
        <translation>HF: semiancho de la rodadura, mm</translation>
    </message>
    <message>
        <source>HW: depth below the crown, mm</source>
        <translation>HW: profundidad bajo la rodadura, mm</translation>
    </message>
    <message>
        <source>HWA: the AREMA depth, mm</source>
        <translation>HWA: la profundidad AREMA, mm</translation>
    </message>
    <message>
        <source>FT: inside the foot edges, mm</source>
        <translation>FT: dentro de los bordes del patín, mm</translation>
    </message>
    <message>
        <source>RAS: depth below the crown, mm</source>
        <translation>RAS: profundidad bajo la rodadura, mm</translation>
    </message>
    <message>
        <source>WT: height, mm (none: thinnest)</source>
        <translation>WT: altura, mm (vacío: la más fina)</translation>
    </message>
    <message>
        <source>Base line: inside the foot edges, mm</source>
        <translation>Línea base: dentro de los bordes del patín, mm</translation>
    </message>
    <message>
        <source>Line: smoothing σ, px</source>
        <translation>Línea: suavizado σ, px</translation>
    </message>
    <message>
        <source>Line: low threshold, DN</source>
        <translation>Línea: umbral bajo, DN</translation>
    </message>
    <message>
        <source>Line: high threshold, DN</source>
        <translation>Línea: umbral alto, DN</translation>
    </message>
    <message>
        <source>Line: longest gap bridged, px</source>
        <translation>Línea: mayor hueco salvado, px</translation>
    </message>
    <message>
        <source>Line: largest angle joined, °</source>
        <translation>Línea: mayor ángulo unido, °</translation>
    </message>
    <message>
        <source>Line: shortest kept, points</source>
        <translation>Línea: la más corta, puntos</translation>
    </message>
    <message>
        <source>Line: blocks before overload</source>
        <translation>Línea: bloques antes de sobrecarga</translation>
    </message>
    <message>
        <source>Line: pull of bends taken off</source>
        <translation>Línea: sesgo en curvas corregido</translation>
    </message>
    <message>
        <source>Registration: scale at first, mm</source>
        <translation>Ajuste: escala inicial, mm</translation>
    </message>
    <message>
        <source>Registration: scale with a start, mm</source>
        <translation>Ajuste: escala con posición previa, mm</translation>
    </message>
    <message>
        <source>Registration: inlier below, mm</source>
        <translation>Ajuste: punto válido por debajo de, mm</translation>
    </message>
    <message>
        <source>Registration: points used within, mm</source>
        <translation>Ajuste: puntos usados hasta, mm</translation>
    </message>
    <message>
        <source>Registration: fails above rms, mm</source>
        <translation>Ajuste: falla si rms supera, mm</translation>
    </message>
    <message>
        <source>Registration: fails below share</source>
        <translation>Ajuste: falla si la parte es menor</translation>
    </message>
    <message>
        <source>Measuring: ends left out, mm</source>
        <translation>Medición: extremos omitidos, mm</translation>
    </message>
    <message>
        <source>Measuring: least points</source>
        <translation>Medición: puntos mínimos</translation>
    </message>
    <message>
        <source>Measuring: expansion, 1/K</source>
        <translation>Medición: dilatación, 1/K</translation>
    </message>
    <message>
        <source>Measuring: hottest rail, °C</source>
        <translation>Medición: carril más caliente, °C</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>%1: limits, mm</source>
        <translation>%1: límites, mm</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>no se juzga</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>como máx. %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>al menos %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
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
    <name>StudyReport</name>
    <message>
        <source>no outlier</source>
        <translation>sin atípicos</translation>
    </message>
    <message>
        <source>straggler (5 %)</source>
        <translation>dudoso (5 %)</translation>
    </message>
    <message>
        <source>outlier (1 %)</source>
        <translation>atípico (1 %)</translation>
    </message>
    <message>
        <source>%1: %2, critical %3 at 1 %</source>
        <translation>%1: %2, crítico %3 al 1 %</translation>
    </message>
    <message>
        <source>Mean range of the runs, mm, per %1 m (Table VI)</source>
        <translation>Rango medio de las pasadas, mm, por %1 m (Tabla VI)</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cota</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>media</translation>
    </message>
    <message>
        <source>share of T, %</source>
        <translation>parte de T, %</translation>
    </message>
    <message>
        <source>Errors against the reference, mm (Table V)</source>
        <translation>Errores frente a la referencia, mm (Tabla V)</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>sesgo</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>máximo</translation>
    </message>
    <message>
        <source>largest, %</source>
        <translation>máximo, %</translation>
    </message>
    <message>
        <source>E_n above 1</source>
        <translation>E_n mayor que 1</translation>
    </message>
    <message>
        <source>%1: values of the runs</source>
        <translation>%1: valores de las pasadas</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>longitud, m</translation>
    </message>
    <message>
        <source>%1: range of the runs</source>
        <translation>%1: rango de las pasadas</translation>
    </message>
    <message>
        <source>%1: error at each position</source>
        <translation>%1: error en cada posición</translation>
    </message>
    <message>
        <source>mean of the runs</source>
        <translation>media de las pasadas</translation>
    </message>
    <message>
        <source>No verdict</source>
        <translation>Sin veredicto</translation>
    </message>
    <message>
        <source>no dimension has both a tolerance and figures</source>
        <translation>ninguna cota tiene a la vez tolerancia y cifras</translation>
    </message>
    <message>
        <source>Repeatable</source>
        <translation>Repetible</translation>
    </message>
    <message>
        <source>Not repeatable</source>
        <translation>No repetible</translation>
    </message>
    <message>
        <source>%1 uses the largest share of its tolerance, %2; allowed are %3 %</source>
        <translation>%1 usa la mayor parte de su tolerancia, %2; se admite %3 %</translation>
    </message>
    <message>
        <source>uncertainties of values and reference are both needed for E_n; the figures stand by themselves</source>
        <translation>para E_n se necesitan las incertidumbres de valores y referencia; las cifras valen por sí solas</translation>
    </message>
    <message>
        <source>Agrees</source>
        <translation>Concuerda</translation>
    </message>
    <message>
        <source>Does not agree</source>
        <translation>No concuerda</translation>
    </message>
    <message>
        <source>worst is %1: E n above 1 in %2 of its %3 values; chance allows %4</source>
        <translation>el peor es %1: E n mayor que 1 en %2 de sus %3 valores; el azar admite %4</translation>
    </message>
    <message>
        <source>Runs and positions</source>
        <translation>Pasadas y posiciones</translation>
    </message>
    <message>
        <source>Repeatability s r</source>
        <translation>Repetibilidad s r</translation>
    </message>
    <message>
        <source>its 95 % interval</source>
        <translation>su intervalo del 95 %</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>Limit r = 2.8 s r</source>
        <translation>Límite r = 2,8 s r</translation>
    </message>
    <message>
        <source>Mean and largest range</source>
        <translation>Rango medio y máximo</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>s from the range</source>
        <translation>s a partir del rango</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autocorrelación</translation>
    </message>
    <message>
        <source>Left out: a run lacks them</source>
        <translation>Omitidos: faltan en una pasada</translation>
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
        <source>Bias</source>
        <translation>Sesgo</translation>
    </message>
    <message>
        <source>RMS error</source>
        <translation>Error RMS</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>Error máximo</translation>
    </message>
    <message>
        <source>in % of the reference</source>
        <translation>en % de la referencia</translation>
    </message>
    <message>
        <source>Limits of agreement</source>
        <translation>Límites de concordancia</translation>
    </message>
    <message>
        <source>interval of the lower</source>
        <translation>intervalo del inferior</translation>
    </message>
    <message>
        <source>interval of the upper</source>
        <translation>intervalo del superior</translation>
    </message>
    <message>
        <source>Largest E n</source>
        <translation>E n máximo</translation>
    </message>
    <message>
        <source>E n above 1</source>
        <translation>E n mayor que 1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Repeatability study</source>
        <translation>Estudio de repetibilidad</translation>
    </message>
    <message>
        <source>Accuracy study</source>
        <translation>Estudio de exactitud</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Pasadas</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolerancias</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>means over %1 m</source>
        <translation>medias sobre %1 m</translation>
    </message>
    <message>
        <source>single profiles</source>
        <translation>perfiles individuales</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referencia</translation>
    </message>
    <message>
        <source>Runs: %1.</source>
        <translation>Pasadas: %1.</translation>
    </message>
    <message>
        <source>Conditions: %1.</source>
        <translation>Condiciones: %1.</translation>
    </message>
    <message>
        <source>%1 over the length, as Fig. 9</source>
        <translation>%1 a lo largo, como la Fig. 9</translation>
    </message>
    <message>
        <source>%1 against its reference</source>
        <translation>%1 frente a su referencia</translation>
    </message>
    <message>
        <source>Figures of %1</source>
        <translation>Cifras de %1</translation>
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
    <name>vignole::CalibrationDesk</name>
    <message>
        <source>Calibrations are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>Las calibraciones no se guardan: %1. Inicie el programa con un archivo (--archive FILE).</translation>
    </message>
    <message>
        <source>Calibrating is the technician&apos;s: sign in as technician or QA (Settings, F10).</source>
        <translation>Calibrar es cosa del técnico: inicie sesión como técnico o calidad (Ajustes, F10).</translation>
    </message>
    <message>
        <source>There is no archive, so a calibration could neither be kept nor reverted: start the program with --archive FILE.</source>
        <translation>No hay archivo, así que una calibración no podría guardarse ni revertirse: inicie el programa con --archive FILE.</translation>
    </message>
    <message>
        <source>Another calibration needs a reason.</source>
        <translation>Otra calibración necesita un motivo.</translation>
    </message>
</context>
<context>
    <name>vignole::CalibrationOverview</name>
    <message>
        <source>In force</source>
        <translation>Vigente</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Calibrar</translation>
    </message>
    <message>
        <source>What it is worth</source>
        <translation>Cuánto vale</translation>
    </message>
    <message>
        <source>Calibrations kept</source>
        <translation>Calibraciones guardadas</translation>
    </message>
    <message>
        <source>choose one to compare it with the one in force</source>
        <translation>elija una para compararla con la vigente</translation>
    </message>
    <message>
        <source>Range finders…</source>
        <translation>Telémetros…</translation>
    </message>
    <message>
        <source>Calibrate the range finders with the pin plate</source>
        <translation>Calibrar los telémetros con la placa de pasadores</translation>
    </message>
    <message>
        <source>Lens of a camera…</source>
        <translation>Objetivo de cámara…</translation>
    </message>
    <message>
        <source>Calibrate the lens of a camera with the flat target</source>
        <translation>Calibrar el objetivo de una cámara con el patrón plano</translation>
    </message>
    <message>
        <source>Encoder…</source>
        <translation>Encóder…</translation>
    </message>
    <message>
        <source>Calibrate the encoder over a known length</source>
        <translation>Calibrar el encóder sobre una longitud conocida</translation>
    </message>
    <message>
        <source>Reference piece…</source>
        <translation>Pieza de referencia…</translation>
    </message>
    <message>
        <source>Check the calibration on a reference piece</source>
        <translation>Comprobar la calibración con una pieza de referencia</translation>
    </message>
    <message>
        <source>Parameter study…</source>
        <translation>Estudio de parámetros…</translation>
    </message>
    <message>
        <source>Study which settings of the calibration matter</source>
        <translation>Estudiar qué ajustes de la calibración importan</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Guardada</translation>
    </message>
    <message>
        <source>By, because</source>
        <translation>Por, motivo</translation>
    </message>
    <message>
        <source>What the calibration in force is worth</source>
        <translation>Cuánto vale la calibración vigente</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Reason for putting it back in force</source>
        <translation>Motivo para volver a ponerla en vigor</translation>
    </message>
    <message>
        <source>Put in force</source>
        <translation>Poner en vigor</translation>
    </message>
    <message>
        <source>Put the chosen calibration in force</source>
        <translation>Poner en vigor la calibración elegida</translation>
    </message>
    <message>
        <source>No calibration</source>
        <translation>Sin calibración</translation>
    </message>
    <message>
        <source>Nothing can be measured: calibrate the range finders.</source>
        <translation>No se puede medir nada: calibre los telémetros.</translation>
    </message>
    <message>
        <source>Overdue: %1. Calibrate the range finders.</source>
        <translation>Vencida: %1. Calibre los telémetros.</translation>
    </message>
    <message numerus="yes">
        <source>Due in %n day(s).</source>
        <translation>
            <numerusform>Vence en %n día.</numerusform>
            <numerusform>Vence en %n días.</numerusform>
        </translation>
    </message>
    <message>
        <source>No interval is set.</source>
        <translation>No hay intervalo fijado.</translation>
    </message>
    <message>
        <source>Method: %1
Made: %2
Plate: %3
Cameras: %4</source>
        <translation>Método: %1
Hecha: %2
Placa: %3
Cámaras: %4</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>None is kept yet. The first is kept when a rail is measured or a wizard ends.</source>
        <translation>Aún no se guarda ninguna. La primera se guarda al medir un carril o al terminar un asistente.</translation>
    </message>
    <message>
        <source>In force: %1</source>
        <translation>Vigente: %1</translation>
    </message>
    <message>
        <source> (cannot be read)</source>
        <translation> (no se puede leer)</translation>
    </message>
    <message>
        <source>of another rig</source>
        <translation>de otro equipo</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cota</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>Admitida</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>U of it</source>
        <translation>Su U</translation>
    </message>
    <message>
        <source>U (k = 2) in %1</source>
        <translation>U (k = 2) en %1</translation>
    </message>
    <message>
        <source>Difference: what the chosen one measures more than the one in force</source>
        <translation>Diferencia: lo que la elegida mide de más respecto a la vigente</translation>
    </message>
    <message>
        <source>By the calibration alone, without the noise of the profiles</source>
        <translation>Solo por la calibración, sin el ruido de los perfiles</translation>
    </message>
    <message>
        <source>%1, too much</source>
        <translation>%1, demasiado</translation>
    </message>
    <message>
        <source>none stated</source>
        <translation>no indicada</translation>
    </message>
    <message>
        <source>Nothing is applied before old and new are compared.</source>
        <translation>Nada se aplica antes de comparar la antigua y la nueva.</translation>
    </message>
    <message>
        <source>It is of other cameras and cannot be put in force here.</source>
        <translation>Es de otras cámaras y no puede ponerse en vigor aquí.</translation>
    </message>
    <message>
        <source>It is in force.</source>
        <translation>Está vigente.</translation>
    </message>
    <message>
        <source>It is in force: the line measures with it from the next rail on.</source>
        <translation>Está vigente: la línea mide con ella desde el próximo carril.</translation>
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
    <message>
        <source>Smallest</source>
        <translation>Menor</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Mayor</translation>
    </message>
</context>
<context>
    <name>vignole::ClosedStep</name>
    <message>
        <source>Closed while the line measures</source>
        <translation>Cerrado mientras la línea mide</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Parar la línea</translation>
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
        <source>Disk</source>
        <translation>Disco</translation>
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
        <source>Screen</source>
        <translation>Pantalla</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 está escrito.</translation>
    </message>
    <message>
        <source>How much of the support bundle is written</source>
        <translation>Cuánto del archivo de soporte está escrito</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Exposición</translation>
    </message>
    <message>
        <source>%1 profiles lost</source>
        <translation>%1 perfiles perdidos</translation>
    </message>
    <message>
        <source>%1 without points</source>
        <translation>%1 sin puntos</translation>
    </message>
    <message>
        <source>%1 profiles kept</source>
        <translation>%1 perfiles guardados</translation>
    </message>
    <message>
        <source>rails are not kept</source>
        <translation>los carriles no se guardan</translation>
    </message>
    <message>
        <source>%1 pictures/s, %2 % of a core</source>
        <translation>%1 imágenes/s, %2 % de un núcleo</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Not available here, because these cameras are rendered: resends, incomplete frames, timeouts, temperature.</source>
        <translation>No disponible aquí, porque estas cámaras son simuladas: reenvíos, imágenes incompletas, esperas agotadas, temperatura.</translation>
    </message>
    <message>
        <source>%1 of %2 GB</source>
        <translation>%1 de %2 GB</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>no indicado</translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s) kept</source>
        <translation>
            <numerusform>%n carril guardado</numerusform>
            <numerusform>%n carriles guardados</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 MB, WAL %2 MB</source>
        <translation>%1 MB, WAL %2 MB</translation>
    </message>
    <message>
        <source>open, nothing is written</source>
        <translation>abierto, no se escribe nada</translation>
    </message>
    <message>
        <source>of %1 GB</source>
        <translation>de %1 GB</translation>
    </message>
    <message>
        <source>p99 %1 ms</source>
        <translation>p99 %1 ms</translation>
    </message>
    <message>
        <source>p50 %1, max %2</source>
        <translation>p50 %1, máx %2</translation>
    </message>
    <message>
        <source>window</source>
        <translation>ventana</translation>
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
        <translation>Dónde se deja el archivo de soporte</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Support bundle…</source>
        <translation>Archivo de soporte…</translation>
    </message>
    <message>
        <source>Cancel the support bundle</source>
        <translation>Cancelar el archivo de soporte</translation>
    </message>
    <message>
        <source>Save a support bundle</source>
        <translation>Guardar un archivo de soporte</translation>
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
    <name>vignole::DriftPanel</name>
    <message>
        <source>Health</source>
        <translation>Salud</translation>
    </message>
    <message>
        <source>seams between the cameras on every rail</source>
        <translation>uniones entre las cámaras en cada carril</translation>
    </message>
    <message>
        <source>Shift of each camera, rail by rail</source>
        <translation>Desplaz. de cada cámara, carril por carril</translation>
    </message>
    <message>
        <source>Shift of each camera since its calibration</source>
        <translation>Desplaz. de cada cámara desde su calibración</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Desplaz.</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Alarm above</source>
        <translation>Alarma desde</translation>
    </message>
    <message>
        <source>No rail has passed yet. Camera drift shows in the seams of normal production, without a plate.</source>
        <translation>Aún no ha pasado ningún carril. La deriva de las cámaras se ve en las uniones de la producción normal, sin placa.</translation>
    </message>
    <message>
        <source>Learning what the seams are like: %1 of %2 rails since this calibration came into use.</source>
        <translation>Aprendiendo cómo son las uniones: %1 de %2 carriles desde que rige esta calibración.</translation>
    </message>
    <message numerus="yes">
        <source>No camera has moved: %n rail(s) watched.</source>
        <translation>
            <numerusform>Ninguna cámara se ha movido: %n carril vigilado.</numerusform>
            <numerusform>Ninguna cámara se ha movido: %n carriles vigilados.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 moved</source>
        <translation>%1 desplazada</translation>
    </message>
    <message>
        <source>rail</source>
        <translation>carril</translation>
    </message>
    <message>
        <source>shift in </source>
        <translation>desplaz. en </translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>cámara %1</translation>
    </message>
    <message>
        <source>alarm above</source>
        <translation>alarma desde</translation>
    </message>
</context>
<context>
    <name>vignole::EncoderPanel</name>
    <message>
        <source>Encoder</source>
        <translation>Encóder</translation>
    </message>
    <message>
        <source>Motion a pulse</source>
        <translation>Avance por pulso</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Lecturas</translation>
    </message>
    <message>
        <source>Known length, first to last reading</source>
        <translation>Longitud conocida, primera a última lectura</translation>
    </message>
    <message>
        <source>Known length, mm</source>
        <translation>Longitud conocida, mm</translation>
    </message>
    <message>
        <source>Its standard uncertainty</source>
        <translation>Su incertidumbre típica</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length, mm</source>
        <translation>Incertidumbre típica de la longitud, mm</translation>
    </message>
    <message>
        <source>Slip of the virtual second encoder, for training</source>
        <translation>Deslizamiento del segundo encóder virtual, para formación</translation>
    </message>
    <message>
        <source>Slip of the virtual second encoder, ppm</source>
        <translation>Deslizamiento del segundo encóder virtual, ppm</translation>
    </message>
    <message>
        <source>Drive the rail</source>
        <translation>Mover el carril</translation>
    </message>
    <message>
        <source>Readings from a file…</source>
        <translation>Lecturas de archivo…</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Parar la línea</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Magnitud</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>Incertidumbre típica</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Cuenta</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Segundo</translation>
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
        <translation>Lecturas del encóder</translation>
    </message>
    <message>
        <source>Slip along the way</source>
        <translation>Desliz. a lo largo</translation>
    </message>
    <message>
        <source>Readings: count,x_mm,y_mm[,count2]</source>
        <translation>Lecturas: count,x_mm,y_mm[,count2]</translation>
    </message>
    <message>
        <source>CSV (*.csv);;All files (*)</source>
        <translation>CSV (*.csv);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Closed while the line measures: the rail is driven by hand over a known length. Stop the line to go on.</source>
        <translation>Cerrado mientras la línea mide: el carril se mueve a mano sobre una longitud conocida. Pare la línea para continuar.</translation>
    </message>
    <message>
        <source>A rail is driven over a length that is known, and the pulses are counted: where the light crosses it, it is seen as well.</source>
        <translation>Un carril recorre una longitud conocida y se cuentan los pulsos: también se ve dónde lo cruza la luz.</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>lectura</translation>
    </message>
    <message>
        <source>second behind first, pulses</source>
        <translation>retraso del segundo, pulsos</translation>
    </message>
    <message>
        <source>Next: drive the rail over the known length.</source>
        <translation>Siguiente: mueva el carril sobre la longitud conocida.</translation>
    </message>
    <message>
        <source> µm a pulse</source>
        <translation> µm por pulso</translation>
    </message>
    <message>
        <source> µm</source>
        <translation> µm</translation>
    </message>
    <message>
        <source>unknown: fewer than three readings</source>
        <translation>desconocida: menos de tres lecturas</translation>
    </message>
    <message>
        <source>Along (V z)</source>
        <translation>A lo largo (V z)</translation>
    </message>
    <message>
        <source>Sideways (V x)</source>
        <translation>Lateral (V x)</translation>
    </message>
    <message>
        <source>Upwards (V y)</source>
        <translation>Hacia arriba (V y)</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>Pulsos</translation>
    </message>
    <message>
        <source>Slip of the second</source>
        <translation>Desliz. del segundo</translation>
    </message>
    <message>
        <source>One of the encoders slips. Next: clean the wheels, press them on and drive again.</source>
        <translation>Un encóder desliza. Siguiente: limpie las ruedas, apriételas y repita el recorrido.</translation>
    </message>
    <message>
        <source>One pulse is %1 µm of rail. Next: enter it where the encoder&apos;s pulses are divided into triggers.</source>
        <translation>Un pulso son %1 µm de carril. Siguiente: introdúzcalo donde los pulsos del encóder se dividen en disparos.</translation>
    </message>
</context>
<context>
    <name>vignole::FramesDrawing</name>
    <message>
        <source>Frames: world on the light plane, camera, image</source>
        <translation>Sistemas de referencia: mundo en el plano de luz, cámara, imagen</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Mundo</translation>
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
    <name>vignole::LensWizard</name>
    <message>
        <source>Cancelling…</source>
        <translation>Cancelando…</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Preparar</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Cobertura</translation>
    </message>
    <message>
        <source>Parts of the picture that have been seen</source>
        <translation>Partes de la imagen que se han visto</translation>
    </message>
    <message>
        <source>Picture of the target</source>
        <translation>Imagen del patrón</translation>
    </message>
    <message>
        <source>Pictures taken</source>
        <translation>Imágenes tomadas</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>Oblicuo</translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>Borroso</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Calcular</translation>
    </message>
    <message>
        <source>Lens models (Table III)</source>
        <translation>Modelos de objetivo (Tabla III)</translation>
    </message>
    <message>
        <source>Distortion model</source>
        <translation>Modelo de distorsión</translation>
    </message>
    <message>
        <source>Mean error px</source>
        <translation>Error medio px</translation>
    </message>
    <message>
        <source>RMS px</source>
        <translation>RMS px</translation>
    </message>
    <message>
        <source>Not seen before px</source>
        <translation>No vistas antes px</translation>
    </message>
    <message>
        <source>Focal length mm</source>
        <translation>Distancia focal mm</translation>
    </message>
    <message>
        <source>Lens models that were tried</source>
        <translation>Modelos de objetivo probados</translation>
    </message>
    <message>
        <source>Coverage and residuals</source>
        <translation>Cobertura y residuos</translation>
    </message>
    <message>
        <source>Points of all pictures</source>
        <translation>Puntos de todas las imágenes</translation>
    </message>
    <message>
        <source>Mean residual by place</source>
        <translation>Residuo medio por lugar</translation>
    </message>
    <message>
        <source>The flat target with circles is held before one camera, in the pose that is drawn, picture by picture. The lens model is the simplest that predicts pictures it has not seen.
Target: %1, points within ±%2 µm.</source>
        <translation>El patrón plano con círculos se sostiene ante una cámara, en la posición dibujada, imagen por imagen. El modelo de objetivo es el más simple que predice imágenes que no ha visto.
Patrón: %1, puntos dentro de ±%2 µm.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Camera whose lens is calibrated</source>
        <translation>Cámara cuyo objetivo se calibra</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Cámara %1</translation>
    </message>
    <message>
        <source>Pictures: twelve cover a lens.</source>
        <translation>Imágenes: doce cubren un objetivo.</translation>
    </message>
    <message>
        <source>Number of pictures</source>
        <translation>Número de imágenes</translation>
    </message>
    <message>
        <source>Target to the right, mm</source>
        <translation>Patrón a la derecha, mm</translation>
    </message>
    <message>
        <source>Target down, mm</source>
        <translation>Patrón hacia abajo, mm</translation>
    </message>
    <message>
        <source>Distance of the target, mm</source>
        <translation>Distancia del patrón, mm</translation>
    </message>
    <message>
        <source>Tilt up and down, degrees</source>
        <translation>Inclinación arriba y abajo, grados</translation>
    </message>
    <message>
        <source>Tilt to the sides, degrees</source>
        <translation>Inclinación a los lados, grados</translation>
    </message>
    <message>
        <source>Turn of the target, degrees</source>
        <translation>Giro del patrón, grados</translation>
    </message>
    <message>
        <source>Hold as shown</source>
        <translation>Sostener como se ve</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Take picture</source>
        <translation>Tomar imagen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Use with the plate</source>
        <translation>Usar con la placa</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>The camera is needed for the pictures of the target. Stop the line to go on; what has been taken so far is kept.</source>
        <translation>La cámara hace falta para las imágenes del patrón. Pare la línea para continuar; lo tomado hasta ahora se conserva.</translation>
    </message>
    <message>
        <source>Progress of the solution</source>
        <translation>Progreso del cálculo</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Cancelado: nada ha cambiado.</translation>
    </message>
    <message>
        <source>Lens of the camera</source>
        <translation>Objetivo de la cámara</translation>
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
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>camera and target</source>
        <translation>cámara y patrón</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>model chosen by the data</source>
        <translation>modelo elegido por los datos</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Table III, residuals</source>
        <translation>Tabla III, residuos</translation>
    </message>
    <message>
        <source>%1 % of the picture</source>
        <translation>%1 % de la imagen</translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>Aún ninguna.</translation>
    </message>
    <message>
        <source>May be used, but: %1</source>
        <translation>Puede usarse, pero: %1</translation>
    </message>
    <message>
        <source>May be used: mean error %1 px with the model %2, chosen by pictures it had not seen.</source>
        <translation>Puede usarse: error medio %1 px con el modelo %2, elegido con imágenes que no había visto.</translation>
    </message>
    <message>
        <source>%1, chosen</source>
        <translation>%1, elegido</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Next: choose the camera.</source>
        <translation>Siguiente: elija la cámara.</translation>
    </message>
    <message>
        <source>First picture</source>
        <translation>Primera imagen</translation>
    </message>
    <message>
        <source>Looking at the target…</source>
        <translation>Mirando el patrón…</translation>
    </message>
    <message>
        <source>This picture would be refused: %1</source>
        <translation>Esta imagen se rechazaría: %1</translation>
    </message>
    <message>
        <source>This picture would be refused, because it shows the pose of picture %1; move the target to the dashed outline.</source>
        <translation>Esta imagen se rechazaría, porque muestra la posición de la imagen %1; mueva el patrón al contorno discontinuo.</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) found.</source>
        <translation>
            <numerusform>%n punto encontrado.</numerusform>
            <numerusform>%n puntos encontrados.</numerusform>
        </translation>
    </message>
    <message>
        <source>Next: solve, or take more.</source>
        <translation>Siguiente: calcule o tome más.</translation>
    </message>
    <message>
        <source>Working out which pose tells most…</source>
        <translation>Buscando la posición que más aporta…</translation>
    </message>
    <message numerus="yes">
        <source>Next: hold the target to the dashed outline and take the picture; %n to go.</source>
        <translation>
            <numerusform>Siguiente: lleve el patrón al contorno discontinuo y tome la imagen; falta %n.</numerusform>
            <numerusform>Siguiente: lleve el patrón al contorno discontinuo y tome la imagen; faltan %n.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Next: %1; %n to go.</source>
        <translation>
            <numerusform>Siguiente: %1; falta %n.</numerusform>
            <numerusform>Siguiente: %1; faltan %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>Lens models are adjusted and tried on pictures they have not seen.</source>
        <translation>Los modelos de objetivo se ajustan y se prueban con imágenes que no han visto.</translation>
    </message>
    <message>
        <source>Next: nothing to do; the result comes by itself.</source>
        <translation>Siguiente: nada que hacer; el resultado llega solo.</translation>
    </message>
    <message>
        <source>Refused: it cannot be used.</source>
        <translation>Rechazado: no se puede usar.</translation>
    </message>
    <message>
        <source>The wizard of the range finders uses this lens. Next: calibrate the range finders.</source>
        <translation>El asistente de los telémetros usa este objetivo. Siguiente: calibre los telémetros.</translation>
    </message>
    <message>
        <source>Next: use it with the plate, or save it.</source>
        <translation>Siguiente: úselo con la placa o guárdelo.</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone. Start the program on the virtual rig.</source>
        <translation>No hay equipo por el que mirar: los asistentes solo miran por el equipo virtual. Inicie el programa con el equipo virtual.</translation>
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
    <message>
        <source>Show the points before registration</source>
        <translation>Mostrar los puntos antes del ajuste</translation>
    </message>
    <message>
        <source>Show the points before registration (B)</source>
        <translation>Mostrar los puntos antes del ajuste (B)</translation>
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
        <source>%1 points</source>
        <translation>%1 puntos</translation>
    </message>
    <message>
        <source>registered</source>
        <translation>ajustado</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>no ajustado</translation>
    </message>
    <message numerus="yes">
        <source>%n dimension(s)</source>
        <translation>
            <numerusform>%n cota</numerusform>
            <numerusform>%n cotas</numerusform>
        </translation>
    </message>
    <message>
        <source>SD %1</source>
        <translation>DT %1</translation>
    </message>
    <message>
        <source>99 % UCL %1</source>
        <translation>LCS 99 % %1</translation>
    </message>
    <message>
        <source>Consumers</source>
        <translation>Consumidores</translation>
    </message>
    <message>
        <source>in the queue now</source>
        <translation>ahora en la cola</translation>
    </message>
    <message>
        <source>highest fill, of how many places</source>
        <translation>máximo llenado, de cuántos lugares</translation>
    </message>
    <message>
        <source>mean time, SD standard deviation, UCL upper limit of its 99 % confidence interval</source>
        <translation>tiempo medio, DT desviación típica, LCS límite superior de su intervalo de confianza del 99 %</translation>
    </message>
</context>
<context>
    <name>vignole::PlateView</name>
    <message>
        <source>no picture yet</source>
        <translation>aún sin imagen</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>rechazada</translation>
    </message>
    <message>
        <source>%1 of %2 pins</source>
        <translation>%1 de %2 pasadores</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>Cámara %1: %2</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Cámara %1</translation>
    </message>
    <message>
        <source>no pin here</source>
        <translation>sin pasador</translation>
    </message>
    <message>
        <source>not found: %1</source>
        <translation>no encontrados: %1</translation>
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
        <source>as Fig. 9a</source>
        <translation>como Fig. 9a</translation>
    </message>
    <message>
        <source>Range of the runs</source>
        <translation>Rango de las pasadas</translation>
    </message>
    <message>
        <source>Values of every run over the length</source>
        <translation>Valores de cada pasada a lo largo</translation>
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
        <source>Export as CSV</source>
        <translation>Exportar como CSV</translation>
    </message>
    <message>
        <source>truth of the virtual rig</source>
        <translation>verdad del equipo virtual</translation>
    </message>
    <message numerus="yes">
        <source>The inspections were cancelled; %n were whole.</source>
        <translation>
            <numerusform>Las inspecciones se cancelaron; %n quedó completa.</numerusform>
            <numerusform>Las inspecciones se cancelaron; %n quedaron completas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Runs of one rail</source>
        <translation>Pasadas de un carril</translation>
    </message>
    <message>
        <source>Reference values</source>
        <translation>Valores de referencia</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Informe en PDF</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Exactitud</translation>
    </message>
    <message>
        <source>Rails of the archive</source>
        <translation>Carriles del archivo</translation>
    </message>
    <message>
        <source>Runs from a file</source>
        <translation>Pasadas de un CSV</translation>
    </message>
    <message>
        <source>Virtual rig</source>
        <translation>Equipo virtual</translation>
    </message>
    <message>
        <source>Where the runs come from</source>
        <translation>De dónde vienen las pasadas</translation>
    </message>
    <message>
        <source>3 m of rail</source>
        <translation>3 m de carril</translation>
    </message>
    <message>
        <source>12 m of rail</source>
        <translation>12 m de carril</translation>
    </message>
    <message>
        <source>60 m of rail, as the paper</source>
        <translation>60 m de carril, como el artículo</translation>
    </message>
    <message>
        <source>Length of the virtual rail</source>
        <translation>Longitud del carril virtual</translation>
    </message>
    <message>
        <source>Means over 0.5 m</source>
        <translation>Medias sobre 0,5 m</translation>
    </message>
    <message>
        <source>Runs that may be laid over each other</source>
        <translation>Pasadas que pueden superponerse</translation>
    </message>
    <message>
        <source>Open runs…</source>
        <translation>Abrir pasadas…</translation>
    </message>
    <message>
        <source>Open runs from a CSV file</source>
        <translation>Abrir pasadas de un archivo CSV</translation>
    </message>
    <message>
        <source>Open reference…</source>
        <translation>Abrir referencia…</translation>
    </message>
    <message>
        <source>Open reference values from a CSV file</source>
        <translation>Abrir valores de referencia de un archivo CSV</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Informe…</translation>
    </message>
    <message>
        <source>Report as PDF (Ctrl+P)</source>
        <translation>Informe en PDF (Ctrl+P)</translation>
    </message>
    <message>
        <source>Export values as CSV</source>
        <translation>Exportar los valores como CSV</translation>
    </message>
    <message>
        <source>Export values as CSV (Ctrl+E)</source>
        <translation>Exportar los valores como CSV (Ctrl+E)</translation>
    </message>
    <message>
        <source>Progress of the inspections</source>
        <translation>Progreso de las inspecciones</translation>
    </message>
    <message>
        <source>What the runs differ by over the length</source>
        <translation>En qué difieren las pasadas a lo largo</translation>
    </message>
    <message>
        <source>Every dimension; the chosen one is drawn</source>
        <translation>Cada cota; se dibuja la elegida</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Figures of the chosen dimension, formulas and constants</source>
        <translation>Cifras de la cota elegida, fórmulas y constantes</translation>
    </message>
    <message>
        <source>Stored runs come from the archive, and there is none (%1): start the program with --archive FILE, or choose a file or the virtual rig above.</source>
        <translation>Las pasadas guardadas vienen del archivo y no hay ninguno (%1): inicie el programa con --archive FILE, o elija arriba un archivo CSV o el equipo virtual.</translation>
    </message>
    <message>
        <source>virtual rig</source>
        <translation>equipo virtual</translation>
    </message>
    <message>
        <source>run %1</source>
        <translation>pasada %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Inspect the rail five times</source>
        <translation>Inspeccionar el carril cinco veces</translation>
    </message>
    <message>
        <source>Cancel the inspections</source>
        <translation>Cancelar las inspecciones</translation>
    </message>
    <message>
        <source>Inspect the same virtual rail five times</source>
        <translation>Inspeccionar cinco veces el mismo carril virtual</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R)</source>
        <translation>Pare antes la línea (Ctrl+R)</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R): both need all processors, and no trigger may be lost to a study.</source>
        <translation>Pare antes la línea (Ctrl+R): ambas necesitan todos los procesadores y un estudio no debe costar ningún disparo.</translation>
    </message>
    <message>
        <source>Accuracy needs a reference: open a CSV with the columns dimension, position_m, value and, if known, u.</source>
        <translation>La exactitud necesita una referencia: abra un CSV con las columnas dimension, position_m, value y, si se conoce, u.</translation>
    </message>
    <message>
        <source>At least 1 run is needed, none is chosen.</source>
        <translation>Se necesita al menos 1 pasada; no hay ninguna elegida.</translation>
    </message>
    <message>
        <source>At least 2 runs of the same rail are needed, %1 chosen: choose %2 more. The paper took 5.</source>
        <translation>Se necesitan al menos 2 pasadas del mismo carril, elegidas: %1; elija %2 más. El artículo tomó 5.</translation>
    </message>
    <message>
        <source>stored rails, same rail and gauge</source>
        <translation>carriles guardados, mismo carril y medidor</translation>
    </message>
    <message>
        <source>file %1</source>
        <translation>archivo %1</translation>
    </message>
    <message>
        <source>virtual rig, exact calibration, other wander, vibration, scale, speckle and noise in every run</source>
        <translation>equipo virtual, calibración exacta, otro desvío, vibración, cascarilla, moteado y ruido en cada pasada</translation>
    </message>
    <message>
        <source>The same rail is inspected five times …</source>
        <translation>El mismo carril se inspecciona cinco veces …</translation>
    </message>
    <message>
        <source>Conditions: %1.</source>
        <translation>Condiciones: %1.</translation>
    </message>
    <message>
        <source>Tick the runs that were made of the same rail and compare.</source>
        <translation>Marque las pasadas hechas con el mismo carril y compare.</translation>
    </message>
    <message>
        <source>A CSV with the columns run, position_m and dimensions, as inspect --csv writes it.</source>
        <translation>Un CSV con las columnas run, position_m y las cotas, como lo escribe inspect --csv.</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R): both need all processors.</source>
        <translation>Pare antes la línea (Ctrl+R): ambas necesitan todos los procesadores.</translation>
    </message>
    <message>
        <source>The paper&apos;s experiment: one rail, five inspections, the truth known.</source>
        <translation>El experimento del artículo: un carril, cinco inspecciones, verdad conocida.</translation>
    </message>
    <message>
        <source>No runs are compared yet</source>
        <translation>Aún no se comparan pasadas</translation>
    </message>
    <message>
        <source>%1 over the length</source>
        <translation>%1 a lo largo</translation>
    </message>
    <message>
        <source>largest minus smallest at each position, as Fig. 9b</source>
        <translation>máximo menos mínimo en cada posición, como la Fig. 9b</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>esperado</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>límite inferior</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>límite superior</translation>
    </message>
    <message>
        <source>mean of %1 m</source>
        <translation>media de %1 m</translation>
    </message>
    <message>
        <source>Error of %1 over the length</source>
        <translation>Error de %1 a lo largo</translation>
    </message>
    <message>
        <source>value minus reference, mean of the runs; %1</source>
        <translation>valor menos referencia, media de las pasadas; %1</translation>
    </message>
    <message>
        <source>value minus reference</source>
        <translation>valor menos referencia</translation>
    </message>
    <message>
        <source>Largest error at each position</source>
        <translation>Error máximo en cada posición</translation>
    </message>
    <message>
        <source>of any run</source>
        <translation>entre pasadas</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>media</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>máximo</translation>
    </message>
    <message>
        <source>no error</source>
        <translation>sin error</translation>
    </message>
    <message>
        <source>limit of agreement</source>
        <translation>límite de concordancia</translation>
    </message>
    <message>
        <source>error, %1</source>
        <translation>error, %1</translation>
    </message>
    <message>
        <source>Dim.</source>
        <translation>Cota</translation>
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
        <translation>Rango medio por %1 m</translation>
    </message>
    <message>
        <source>as Table VI</source>
        <translation>como Tabla VI</translation>
    </message>
    <message>
        <source>%1, as Table VI; the stretches are in the report</source>
        <translation>%1, como Tabla VI; los tramos están en el informe</translation>
    </message>
    <message>
        <source>%1, as Table VI</source>
        <translation>%1, como Tabla VI</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>sesgo</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Errores</translation>
    </message>
    <message>
        <source>%1, as Table V</source>
        <translation>%1, como Tabla V</translation>
    </message>
    <message>
        <source>as Table V</source>
        <translation>como Tabla V</translation>
    </message>
    <message>
        <source>Verdict, figures, formulas and constants stand here when runs are compared.</source>
        <translation>Aquí aparecen veredicto, cifras, fórmulas y constantes cuando se comparan pasadas.</translation>
    </message>
    <message>
        <source>figures of %1</source>
        <translation>cifras de %1</translation>
    </message>
    <message>
        <source>writing …</source>
        <translation>escribiendo …</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 está escrito.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 no se puede escribir.</translation>
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
    <message>
        <source>kept since the start: %1 rails; %2 profiles wait</source>
        <translation>guardados desde el inicio: %1 carriles; %2 perfiles esperan</translation>
    </message>
    <message>
        <source>nearest to a limit, inside</source>
        <translation>el más cercano a un límite, dentro</translation>
    </message>
    <message>
        <source>furthest beyond a limit, mm</source>
        <translation>lo más lejos tras un límite, mm</translation>
    </message>
    <message>
        <source>Dimension that is drawn</source>
        <translation>Dimensión dibujada</translation>
    </message>
    <message>
        <source>Show the points before registration</source>
        <translation>Mostrar los puntos antes del ajuste</translation>
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
    <message>
        <source>Section…</source>
        <translation>Sección…</translation>
    </message>
    <message>
        <source>Draw the section, or bring one along from a drawing</source>
        <translation>Dibujar la sección o traerla de un plano</translation>
    </message>
    <message>
        <source>What if…</source>
        <translation>Y si…</translation>
    </message>
    <message>
        <source>Judge stored rails by the chosen recipe</source>
        <translation>Juzgar los carriles guardados con la receta elegida</translation>
    </message>
    <message>
        <source>Use for the next rail</source>
        <translation>Usar desde el próximo</translation>
    </message>
    <message>
        <source>Use the chosen recipe for the next rail</source>
        <translation>Usar la receta elegida para el próximo carril</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>Parameters of dimensions and settings of the stages</source>
        <translation>Parámetros de las cotas y ajustes de las etapas</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Settings of the chosen recipe</source>
        <translation>Ajustes de la receta elegida</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Name of the draft; another name makes a copy</source>
        <translation>Nombre del borrador; otro nombre hace una copia</translation>
    </message>
    <message>
        <source>On the line: %1 v%2.</source>
        <translation>En la línea: %1 v%2.</translation>
    </message>
    <message>
        <source>From the next rail: %1.</source>
        <translation>Desde el próximo carril: %1.</translation>
    </message>
    <message>
        <source>Only an approved recipe is measured with.</source>
        <translation>Solo se mide con una receta aprobada.</translation>
    </message>
    <message>
        <source>%1: the value is not of its kind.</source>
        <translation>%1: el valor no es del tipo debido.</translation>
    </message>
    <message>
        <source>%1 v%2 is in force from the next rail; the rail in the gauge keeps what it began with.</source>
        <translation>%1 v%2 rige desde el próximo carril; el carril en el medidor conserva aquello con lo que empezó.</translation>
    </message>
    <message>
        <source>What if needs at least %1 stored rails of section %2, there are %3: measure more first.</source>
        <translation>«Y si» necesita al menos %1 carriles guardados de la sección %2 y hay %3: mida antes más.</translation>
    </message>
    <message>
        <source>Recipes are read, drafts cannot be kept: %1.</source>
        <translation>Las recetas se leen, los borradores no se pueden guardar: %1.</translation>
    </message>
</context>
<context>
    <name>vignole::ReferencePanel</name>
    <message>
        <source>Reference piece</source>
        <translation>Pieza de referencia</translation>
    </message>
    <message>
        <source>Certificate and gauge</source>
        <translation>Certificado y medidor</translation>
    </message>
    <message>
        <source>Profiles that are averaged</source>
        <translation>Perfiles que se promedian</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Progreso de la comprobación</translation>
    </message>
    <message>
        <source>Measure the piece</source>
        <translation>Medir la pieza</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Parar la línea</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Cancelado: nada ha cambiado.</translation>
    </message>
    <message>
        <source>Closed while the line measures: the piece stands where the rail passes. Stop the line to go on.</source>
        <translation>Cerrado mientras la línea mide: la pieza está donde pasa el carril. Pare la línea para continuar.</translation>
    </message>
    <message>
        <source>A section with a certificate is put into the gauge and measured with the calibration in force. On the virtual rig it is a virtual piece, whose truth is its certificate (U = 2 µm).</source>
        <translation>Se coloca en el medidor una sección con certificado y se mide con la calibración vigente. En el equipo virtual es una pieza virtual cuya verdad es su certificado (U = 2 µm).</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Midiendo…</translation>
    </message>
    <message>
        <source>Next: measure the piece.</source>
        <translation>Siguiente: mida la pieza.</translation>
    </message>
    <message numerus="yes">
        <source>The gauge agrees with the certificate in every dimension, over %n profile(s).</source>
        <translation>
            <numerusform>El medidor concuerda con el certificado en todas las cotas, con %n perfil.</numerusform>
            <numerusform>El medidor concuerda con el certificado en todas las cotas, con %n perfiles.</numerusform>
        </translation>
    </message>
    <message>
        <source>The gauge does not agree with the certificate. Next: clean the piece and measure again; if it stays so, calibrate the range finders.</source>
        <translation>El medidor no concuerda con el certificado. Siguiente: limpie la pieza y mida de nuevo; si persiste, calibre los telémetros.</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cota</translation>
    </message>
    <message>
        <source>Certificate %1</source>
        <translation>Certificado %1</translation>
    </message>
    <message>
        <source>Measured %1</source>
        <translation>Medido %1</translation>
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
        <source>Deviation over U</source>
        <translation>Desviación / U</translation>
    </message>
    <message>
        <source>%1, differs</source>
        <translation>%1, difiere</translation>
    </message>
    <message>
        <source>not measured: %1</source>
        <translation>sin medir: %1</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone.</source>
        <translation>No hay equipo por el que mirar: los asistentes solo miran por el equipo virtual.</translation>
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
    <name>vignole::RigDrawing</name>
    <message>
        <source>The rig as it is calibrated</source>
        <translation>La instalación tal como está calibrada</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Cámara %1</translation>
    </message>
    <message>
        <source>Along the rail: fields of view on the light plane, distances</source>
        <translation>A lo largo del carril: campos de visión en el plano de luz, distancias</translation>
    </message>
    <message>
        <source>From the side: angles out of the light plane</source>
        <translation>De lado: ángulos fuera del plano de luz</translation>
    </message>
</context>
<context>
    <name>vignole::RigWizard</name>
    <message>
        <source>Cancelling…</source>
        <translation>Cancelando…</translation>
    </message>
    <message>
        <source>Range finders</source>
        <translation>Telémetros</translation>
    </message>
    <message>
        <source>What it means</source>
        <translation>Qué significa</translation>
    </message>
    <message>
        <source>Fit to the pins</source>
        <translation>Ajuste a los pasadores</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Preparar</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Calcular</translation>
    </message>
    <message>
        <source>Pins found (Fig. 8d)</source>
        <translation>Pasadores hallados (Fig. 8d)</translation>
    </message>
    <message>
        <source>circles: the pins as found; points: the lines of the first placement</source>
        <translation>círculos: los pasadores hallados; puntos: las líneas de la primera colocación</translation>
    </message>
    <message>
        <source>Pins in the world</source>
        <translation>Pasadores en el espacio</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Controles</translation>
    </message>
    <message>
        <source>Put in force</source>
        <translation>Poner en vigor</translation>
    </message>
    <message>
        <source>How often the plate is put down: four find an error of the plate as well.</source>
        <translation>Cuántas veces se coloca la placa: con cuatro se halla también un error de la placa.</translation>
    </message>
    <message>
        <source>Number of placements</source>
        <translation>Número de colocaciones</translation>
    </message>
    <message>
        <source>The virtual plate, for training</source>
        <translation>La placa virtual, para formación</translation>
    </message>
    <message>
        <source>is as its certificate says</source>
        <translation>es como dice su certificado</translation>
    </message>
    <message>
        <source>is the mirror image of its file</source>
        <translation>es la imagen especular de su archivo</translation>
    </message>
    <message>
        <source>is not the one of the certificate</source>
        <translation>no es la del certificado</translation>
    </message>
    <message>
        <source>has lost pin 4</source>
        <translation>perdió el pasador 4</translation>
    </message>
    <message>
        <source>Virtual plate</source>
        <translation>Placa virtual</translation>
    </message>
    <message>
        <source>Plate to the right, mm</source>
        <translation>Placa a la derecha, mm</translation>
    </message>
    <message>
        <source>Plate up, mm</source>
        <translation>Placa arriba, mm</translation>
    </message>
    <message>
        <source>Plate turned anticlockwise, degrees</source>
        <translation>Placa girada en sentido antihorario, grados</translation>
    </message>
    <message>
        <source>Plate tilted out of the light, degrees</source>
        <translation>Placa inclinada fuera de la luz, grados</translation>
    </message>
    <message>
        <source>tilt </source>
        <translation>incl. </translation>
    </message>
    <message>
        <source>Place as shown</source>
        <translation>Colocar como se ve</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Take again</source>
        <translation>Repetir</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Informe…</translation>
    </message>
    <message>
        <source>The plate stands where the rail passes, and the cameras are needed. Stop the line to go on; what has been taken so far is kept.</source>
        <translation>La placa está donde pasa el carril y las cámaras hacen falta. Pare la línea para continuar; lo tomado hasta ahora se conserva.</translation>
    </message>
    <message>
        <source>To be repeated after so many days (0: never)</source>
        <translation>Repetir tras estos días (0: nunca)</translation>
    </message>
    <message>
        <source>Days after which the calibration is to be repeated</source>
        <translation>Días tras los que debe repetirse la calibración</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Reason for the new calibration</source>
        <translation>Motivo de la calibración nueva</translation>
    </message>
    <message>
        <source>Progress of the solution</source>
        <translation>Progreso del cálculo</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Centre (CD)</source>
        <translation>Centro (CD)</translation>
    </message>
    <message>
        <source>Radius (RD)</source>
        <translation>Radio (RD)</translation>
    </message>
    <message>
        <source>Points (PD)</source>
        <translation>Puntos (PD)</translation>
    </message>
    <message>
        <source>Table IV: fit to the pins</source>
        <translation>Tabla IV: ajuste a los pasadores</translation>
    </message>
    <message>
        <source>Checks of the new calibration</source>
        <translation>Controles de la calibración nueva</translation>
    </message>
    <message>
        <source>Four cameras together…</source>
        <translation>Cuatro cámaras juntas…</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Cancelado: nada ha cambiado.</translation>
    </message>
    <message>
        <source>%1 is in force: the line measures with it from the next rail on.</source>
        <translation>%1 está vigente: la línea mide con ella desde el próximo carril.</translation>
    </message>
    <message>
        <source>Report of the calibration</source>
        <translation>Informe de la calibración</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>turned and moved</source>
        <translation>girada y desplazada</translation>
    </message>
    <message>
        <source>turned 180°</source>
        <translation>girada 180°</translation>
    </message>
    <message>
        <source>moved %1 mm</source>
        <translation>desplazada %1 mm</translation>
    </message>
    <message>
        <source>as drawn, 0°</source>
        <translation>según dibujo, 0°</translation>
    </message>
    <message>
        <source>plate and cameras</source>
        <translation>placa y cámaras</translation>
    </message>
    <message>
        <source>Placement %1</source>
        <translation>Colocación %1</translation>
    </message>
    <message>
        <source>four cameras together</source>
        <translation>cuatro cámaras juntas</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>old and new</source>
        <translation>antigua y nueva</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>reason and signature</source>
        <translation>motivo y firma</translation>
    </message>
    <message>
        <source>placement %1 of %2</source>
        <translation>colocación %1 de %2</translation>
    </message>
    <message>
        <source>U (k = 2) in %1</source>
        <translation>U (k = 2) en %1</translation>
    </message>
    <message>
        <source>mean / max in %1</source>
        <translation>media / máx en %1</translation>
    </message>
    <message>
        <source>Plate, %1</source>
        <translation>Placa, %1</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Placa</translation>
    </message>
    <message>
        <source>%1, U = 3 µm, pins towards the cameras</source>
        <translation>%1, U = 3 µm, pasadores hacia las cámaras</translation>
    </message>
    <message>
        <source>Camera %1: lens as calibrated in this session</source>
        <translation>Cámara %1: objetivo calibrado en esta sesión</translation>
    </message>
    <message>
        <source>Camera %1: lens of the calibration in force</source>
        <translation>Cámara %1: objetivo de la calibración vigente</translation>
    </message>
    <message>
        <source>The plate with 13 pins is put into the gauge where the rail passes, pins towards the cameras, and turned and moved between the pictures. Nothing is applied before old and new have been compared and you confirm.

%1</source>
        <translation>La placa con 13 pasadores se coloca en el medidor donde pasa el carril, con los pasadores hacia las cámaras, y se gira y desplaza entre las imágenes. Nada se aplica antes de que se hayan comparado la antigua y la nueva y usted lo confirme.

%1</translation>
    </message>
    <message>
        <source>%1 takes the place of %2 from the next rail on. Both are kept and can be compared and put back.</source>
        <translation>%1 sustituye a %2 desde el próximo carril. Ambas se guardan y pueden compararse y volver a ponerse en vigor.</translation>
    </message>
    <message>
        <source>could not be asked</source>
        <translation>no se pudo comprobar</translation>
    </message>
    <message>
        <source>%1, within %2</source>
        <translation>%1, dentro de %2</translation>
    </message>
    <message>
        <source>%1, above %2</source>
        <translation>%1, sobre %2</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>%1 a la derecha</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 a la izquierda</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>%1 arriba</translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation>%1 abajo</translation>
    </message>
    <message>
        <source>turned by %1° anticlockwise</source>
        <translation>girar %1° en sentido antihorario</translation>
    </message>
    <message>
        <source>turned by %1° clockwise</source>
        <translation>girar %1° en sentido horario</translation>
    </message>
    <message>
        <source>Next: move the plate to the dashed outlines: %1.</source>
        <translation>Siguiente: mueva la placa a los contornos discontinuos: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Next: put the plate into the gauge.</source>
        <translation>Siguiente: coloque la placa en el medidor.</translation>
    </message>
    <message>
        <source>First placement</source>
        <translation>Primera colocación</translation>
    </message>
    <message>
        <source>Next placement</source>
        <translation>Colocación siguiente</translation>
    </message>
    <message>
        <source>Looking at the plate…</source>
        <translation>Mirando la placa…</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>Cámara %1: %2</translation>
    </message>
    <message>
        <source>%1 of %2 pins found</source>
        <translation>%1 de %2 pasadores hallados</translation>
    </message>
    <message numerus="yes">
        <source>, %n picture(s) refused</source>
        <translation>
            <numerusform>, %n imagen rechazada</numerusform>
            <numerusform>, %n imágenes rechazadas</numerusform>
        </translation>
    </message>
    <message>
        <source>All four cameras see the plate where it must lie. Next: “%1”.</source>
        <translation>Las cuatro cámaras ven la placa donde debe estar. Siguiente: «%1».</translation>
    </message>
    <message>
        <source>The poses of four cameras are found together with the pins.</source>
        <translation>Las posiciones de las cuatro cámaras se calculan junto con los pasadores.</translation>
    </message>
    <message>
        <source>Next: nothing to do; the comparison comes by itself.</source>
        <translation>Siguiente: nada que hacer; la comparación llega sola.</translation>
    </message>
    <message>
        <source>Refused: it cannot be put in force.</source>
        <translation>Rechazada: no puede ponerse en vigor.</translation>
    </message>
    <message>
        <source>May be used: every check is within its limit.</source>
        <translation>Puede usarse: cada control está dentro de su límite.</translation>
    </message>
    <message numerus="yes">
        <source>May be used, but %n dimension(s) get more than is allowed.</source>
        <translation>
            <numerusform>Puede usarse, pero %n cota supera lo admitido.</numerusform>
            <numerusform>Puede usarse, pero %n cotas superan lo admitido.</numerusform>
        </translation>
    </message>
    <message>
        <source>Next: compare old and new on the right. Nothing is applied before you confirm.</source>
        <translation>Siguiente: compare a la derecha la antigua y la nueva. Nada se aplica antes de que usted confirme.</translation>
    </message>
    <message>
        <source>Done. Next: start the line and watch the first rail.</source>
        <translation>Hecho. Siguiente: inicie la línea y observe el primer carril.</translation>
    </message>
    <message>
        <source>Next: give the reason and put it in force.</source>
        <translation>Siguiente: dé el motivo y póngala en vigor.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone. Start the program on the virtual rig.</source>
        <translation>No hay equipo por el que mirar: los asistentes solo miran por el equipo virtual. Inicie el programa con el equipo virtual.</translation>
    </message>
</context>
<context>
    <name>vignole::SectionDialog</name>
    <message>
        <source>Drawing of a section</source>
        <translation>Plano de una sección</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>Section with its primitives named</source>
        <translation>Sección con los nombres de sus primitivas</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Longitud, mm</translation>
    </message>
    <message>
        <source>Radius, mm</source>
        <translation>Radio, mm</translation>
    </message>
    <message>
        <source>Primitives of the section</source>
        <translation>Primitivas de la sección</translation>
    </message>
    <message>
        <source>Name of the section</source>
        <translation>Nombre de la sección</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Profile and straightness class of its recipe</source>
        <translation>Clase de perfil y rectitud de su receta</translation>
    </message>
    <message>
        <source>Open a drawing…</source>
        <translation>Abrir un plano…</translation>
    </message>
    <message>
        <source>Open a drawing of a section</source>
        <translation>Abrir el plano de una sección</translation>
    </message>
    <message>
        <source>Make a draft of it</source>
        <translation>Hacer borrador</translation>
    </message>
    <message>
        <source>Keep the section and make a draft of it</source>
        <translation>Guardar la sección y hacer un borrador de ella</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>There is nothing in this file that could be drawn.</source>
        <translation>En este archivo no hay nada que pueda dibujarse.</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Rechazado: %1</translation>
    </message>
    <message>
        <source>QA makes drafts: sign in.</source>
        <translation>Los borradores los hace calidad: inicie sesión.</translation>
    </message>
    <message>
        <source>Open a drawing: one closed outline of lines and arcs, the rail upright.</source>
        <translation>Abra un plano: un contorno cerrado de líneas y arcos, el carril de pie.</translation>
    </message>
    <message>
        <source>DXF, JSON or a MiniProf design</source>
        <translation>DXF, JSON o un diseño MiniProf</translation>
    </message>
    <message numerus="yes">
        <source>%1 mm high, %2 cm², %3 kg/m, %4; %n primitive(s)</source>
        <translation>
            <numerusform>%1 mm de alto, %2 cm², %3 kg/m, %4; %n primitiva</numerusform>
            <numerusform>%1 mm de alto, %2 cm², %3 kg/m, %4; %n primitivas</numerusform>
        </translation>
    </message>
    <message>
        <source>symmetric</source>
        <translation>simétrica</translation>
    </message>
    <message>
        <source>asymmetric</source>
        <translation>asimétrica</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>arco</translation>
    </message>
    <message>
        <source>segment</source>
        <translation>segmento</translation>
    </message>
    <message>
        <source>A name has letters, digits, spaces, dots and hyphens: it becomes the name of a file.</source>
        <translation>Un nombre tiene letras, cifras, espacios, puntos y guiones: será el nombre de un archivo.</translation>
    </message>
    <message>
        <source>%1 is a section of the catalogue: give yours another name.</source>
        <translation>%1 es una sección del catálogo: dé otro nombre a la suya.</translation>
    </message>
    <message>
        <source>There is another section of the name %1: give a new name.</source>
        <translation>Ya hay otra sección con el nombre %1: dé un nombre nuevo.</translation>
    </message>
</context>
<context>
    <name>vignole::SectionDrawing</name>
    <message>
        <source>free end</source>
        <translation>extremo libre</translation>
    </message>
    <message>
        <source>open here: %1 mm</source>
        <translation>abierto aquí: %1 mm</translation>
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
    <message>
        <source>Rig</source>
        <translation>Instalación</translation>
    </message>
    <message>
        <source>drawn from the calibration in force</source>
        <translation>dibujada según la calibración vigente</translation>
    </message>
    <message>
        <source>This line does not tell its calibration.</source>
        <translation>Esta línea no indica su calibración.</translation>
    </message>
    <message>
        <source>Calibration %1. The rail stands where it was seen last.</source>
        <translation>Calibración %1. El carril está donde se vio por última vez.</translation>
    </message>
    <message>
        <source>Calibration %1. No rail has been seen yet.</source>
        <translation>Calibración %1. Aún no se ha visto ningún carril.</translation>
    </message>
    <message>
        <source>No site is configured: the four cameras are those of the virtual rig, and every page says SIMULATION. Cameras are measured with on the command line: vignole-cli inspect --source gige.</source>
        <translation>No hay instalación configurada: las cuatro cámaras son las del equipo virtual y cada página dice SIMULACIÓN. Con cámaras se mide desde la línea de comandos: vignole-cli inspect --source gige.</translation>
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
    <name>vignole::StepList</name>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Paso %1 de %2: %3</translation>
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
    <message>
        <source>upper left</source>
        <translation>arriba izq.</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>arriba dcha.</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>abajo dcha.</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>abajo izq.</translation>
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
        <translation>Lo que se prueba actúa solo en estas imágenes hasta que se aplica.</translation>
    </message>
    <message>
        <source>Anybody may try; a technician who has signed in applies.</source>
        <translation>Cualquiera puede probar; aplica un técnico con sesión iniciada.</translation>
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
        <source>Save the picture</source>
        <translation>Guardar la imagen</translation>
    </message>
    <message>
        <source>Lost: %1</source>
        <translation>Perdida: %1</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Retenido</translation>
    </message>
    <message>
        <source>The line has not been started (Ctrl+R).</source>
        <translation>La línea no se ha iniciado (Ctrl+R).</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>hace %1</translation>
    </message>
    <message numerus="yes">
        <source>The picture is no longer held: the last %n are.</source>
        <translation>
            <numerusform>La imagen ya no se conserva: solo la última (%n).</numerusform>
            <numerusform>La imagen ya no se conserva: solo las últimas %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>No picture: %1</source>
        <translation>Sin imagen: %1</translation>
    </message>
    <message>
        <source>Pictures behind the profile at %1 m.</source>
        <translation>Imágenes del perfil en %1 m.</translation>
    </message>
    <message>
        <source>Waits for the next rail; the running rail keeps what it began with.</source>
        <translation>Espera al próximo carril; el carril en curso conserva aquello con lo que empezó.</translation>
    </message>
    <message>
        <source>There is no archive, so the change could not be recorded: nothing was changed.</source>
        <translation>No hay archivo, así que el cambio no pudo registrarse: no se cambió nada.</translation>
    </message>
    <message>
        <source>The change is being recorded…</source>
        <translation>Registrando el cambio…</translation>
    </message>
    <message>
        <source>Nothing was changed, because it could not be recorded: %1</source>
        <translation>No se cambió nada, porque no se pudo registrar: %1</translation>
    </message>
    <message>
        <source>Recorded. The exposure changes with the next start of the line, the parameters with the next rail.</source>
        <translation>Registrado. La exposición cambia con el próximo inicio de la línea; los parámetros, con el próximo carril.</translation>
    </message>
    <message>
        <source>Recorded. Waits for the next rail; the running rail keeps what it began with.</source>
        <translation>Registrado. Espera al próximo carril; el carril en curso conserva aquello con lo que empezó.</translation>
    </message>
    <message>
        <source>Camera %1 has no picture to save.</source>
        <translation>La cámara %1 no tiene imagen que guardar.</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>Guardando %1…</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 está escrito.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 no se puede escribir: %2</translation>
    </message>
</context>
<context>
    <name>vignole::StudyPanel</name>
    <message>
        <source>Parameter study</source>
        <translation>Estudio de parámetros</translation>
    </message>
    <message>
        <source>Main effects</source>
        <translation>Efectos principales</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Niveles</translation>
    </message>
    <message>
        <source>Settings and their levels</source>
        <translation>Ajustes y sus niveles</translation>
    </message>
    <message>
        <source>Influence of each setting</source>
        <translation>Influencia de cada ajuste</translation>
    </message>
    <message>
        <source>Placements of the plate</source>
        <translation>Colocaciones de la placa</translation>
    </message>
    <message>
        <source>Placements of the plate for the study</source>
        <translation>Colocaciones de la placa para el estudio</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Progreso del estudio</translation>
    </message>
    <message>
        <source>Start the study</source>
        <translation>Iniciar el estudio</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Parar la línea</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Informe…</translation>
    </message>
    <message>
        <source>settings and levels</source>
        <translation>ajustes y niveles</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Cancelado: nada ha cambiado.</translation>
    </message>
    <message>
        <source>Report of the study</source>
        <translation>Informe del estudio</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>Closed while the line measures: the plate stands where the rail passes. Stop the line to go on.</source>
        <translation>Cerrado mientras la línea mide: la placa está donde pasa el carril. Pare la línea para continuar.</translation>
    </message>
    <message>
        <source>Every combination of the levels is a calibration by the paper&apos;s method on pictures of the plate. Levels are parted by commas; one level or none: the setting is not varied.</source>
        <translation>Cada combinación de los niveles es una calibración por el método del artículo con imágenes de la placa. Los niveles se separan con comas; un nivel o ninguno: el ajuste no se varía.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Calculando…</translation>
    </message>
    <message>
        <source>Next: choose levels and start.</source>
        <translation>Siguiente: elija niveles e inicie.</translation>
    </message>
    <message>
        <source>Exposure, ms</source>
        <translation>Exposición, ms</translation>
    </message>
    <message>
        <source>Smoothing σ, px</source>
        <translation>Suavizado σ, px</translation>
    </message>
    <message>
        <source>Ellipses a pin</source>
        <translation>Elipses por pasador</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone.</source>
        <translation>No hay equipo por el que mirar: los asistentes solo miran por el equipo virtual.</translation>
    </message>
</context>
<context>
    <name>vignole::SupportBundle</name>
    <message>
        <source>is there already</source>
        <translation>ya existe</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>no se puede crear</translation>
    </message>
    <message>
        <source>cancelled: nothing is left of it</source>
        <translation>cancelado: no queda nada de él</translation>
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
    <name>vignole::TrialPanel</name>
    <message>
        <source>Line extraction</source>
        <translation>Extracción de línea</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Exposición</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Suavizado</translation>
    </message>
    <message>
        <source>Low threshold</source>
        <translation>Umbral bajo</translation>
    </message>
    <message>
        <source>High threshold</source>
        <translation>Umbral alto</translation>
    </message>
    <message>
        <source>Link distance</source>
        <translation>Dist. de enlace</translation>
    </message>
    <message>
        <source>Link angle</source>
        <translation>Áng. de enlace</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parámetro</translation>
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
        <source>%1 on trial</source>
        <translation>%1 a prueba</translation>
    </message>
    <message>
        <source>%1: less</source>
        <translation>%1: menos</translation>
    </message>
    <message>
        <source>%1: more</source>
        <translation>%1: más</translation>
    </message>
    <message>
        <source>Choose camera %1</source>
        <translation>Elegir cámara %1</translation>
    </message>
    <message>
        <source>Pixels with the line in use</source>
        <translation>Píxeles con la línea en uso</translation>
    </message>
    <message>
        <source>Pixels with the line on trial</source>
        <translation>Píxeles con la línea a prueba</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>In use against on trial</source>
        <translation>En uso y a prueba</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Gained, lost</source>
        <translation>Ganados, perdidos</translation>
    </message>
    <message>
        <source>Saturated points</source>
        <translation>Puntos saturados</translation>
    </message>
    <message>
        <source>Uncertainty, px</source>
        <translation>Incertidumbre, px</translation>
    </message>
    <message>
        <source>Shift: mean, largest, px</source>
        <translation>Desplaz.: media, máx., px</translation>
    </message>
    <message>
        <source>Time, ms</source>
        <translation>Tiempo, ms</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Save the picture of the chosen camera (Ctrl+S)</source>
        <translation>Guardar la imagen de la cámara elegida (Ctrl+S)</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Directo</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Congelar</translation>
    </message>
    <message>
        <source>Live pictures again (P)</source>
        <translation>Otra vez imágenes en directo (P)</translation>
    </message>
    <message>
        <source>Freeze the pictures (P)</source>
        <translation>Congelar las imágenes (P)</translation>
    </message>
    <message>
        <source>Freeze the pictures</source>
        <translation>Congelar las imágenes</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Perfil</translation>
    </message>
    <message>
        <source>The pictures behind the newest profile (B)</source>
        <translation>Las imágenes del perfil más reciente (B)</translation>
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
        <source>Use from next rail</source>
        <translation>Usar desde el próximo</translation>
    </message>
    <message>
        <source>Use what is on trial from the next rail on</source>
        <translation>Usar lo que está a prueba desde el próximo carril</translation>
    </message>
    <message>
        <source>Reason for the change</source>
        <translation>Motivo del cambio</translation>
    </message>
    <message>
        <source>These cameras&apos; exposure cannot be changed from here.</source>
        <translation>La exposición de estas cámaras no puede cambiarse desde aquí.</translation>
    </message>
    <message>
        <source>camera %1, frozen</source>
        <translation>cámara %1, congelada</translation>
    </message>
    <message>
        <source>camera %1, live</source>
        <translation>cámara %1, en directo</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>sin imagen</translation>
    </message>
    <message>
        <source>nothing on trial: change a parameter</source>
        <translation>nada a prueba: cambie un parámetro</translation>
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
<context>
    <name>vignole::WorthTable</name>
    <message>
        <source>Dimension</source>
        <translation>Cota</translation>
    </message>
    <message>
        <source>In force</source>
        <translation>Vigente</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nueva</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>Admitida</translation>
    </message>
    <message>
        <source>Largest part</source>
        <translation>Mayor aporte</translation>
    </message>
    <message>
        <source>What the calibration is worth for each dimension</source>
        <translation>Cuánto vale la calibración para cada cota</translation>
    </message>
    <message>
        <source>More than the tolerance allows</source>
        <translation>Más de lo que admite la tolerancia</translation>
    </message>
    <message>
        <source>too much: %1</source>
        <translation>demasiado: %1</translation>
    </message>
</context>
</TS>
