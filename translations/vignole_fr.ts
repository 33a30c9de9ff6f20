<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>AlarmRule</name>
    <message>
        <source>A camera does not answer while a rail passes.</source>
        <translation>Une caméra ne répond pas pendant le passage d&apos;un rail.</translation>
    </message>
    <message>
        <source>Its quarter of the profile is missing; rails pass unmeasured.</source>
        <translation>Son quart du profil manque ; des rails passent sans être mesurés.</translation>
    </message>
    <message>
        <source>Check power and network cable of the camera, then Diagnostics; stop the line if it does not come back.</source>
        <translation>Vérifier l&apos;alimentation et le câble réseau de la caméra, puis Diagnostic ; arrêter la ligne si elle ne revient pas.</translation>
    </message>
    <message>
        <source>Too many triggers give no complete profile.</source>
        <translation>Trop de déclenchements ne donnent pas de profil complet.</translation>
    </message>
    <message>
        <source>Stretches of the rail are not measured.</source>
        <translation>Des tronçons du rail ne sont pas mesurés.</translation>
    </message>
    <message>
        <source>See Diagnostics for the camera that loses frames; check network load and trigger.</source>
        <translation>Voir dans Diagnostic la caméra qui perd des images ; vérifier la charge du réseau et le déclenchement.</translation>
    </message>
    <message>
        <source>Too many profiles do not fit the section of the recipe.</source>
        <translation>Trop de profils ne correspondent pas à la section de la recette.</translation>
    </message>
    <message>
        <source>The dimensions of this rail are not to be trusted.</source>
        <translation>Les cotes de ce rail ne sont pas fiables.</translation>
    </message>
    <message>
        <source>Check that the recipe is the one of the rail that runs; look at Stripes for glare or scale.</source>
        <translation>Vérifier que la recette est celle du rail en cours ; chercher reflets ou calamine dans Lignes laser.</translation>
    </message>
    <message>
        <source>The measurement has stopped while a rail passes.</source>
        <translation>La mesure s&apos;est arrêtée pendant le passage d&apos;un rail.</translation>
    </message>
    <message>
        <source>Rails pass unmeasured.</source>
        <translation>Des rails passent sans être mesurés.</translation>
    </message>
    <message>
        <source>Start the measurement; if it stops again, save a support bundle in Diagnostics.</source>
        <translation>Démarrer la mesure ; si elle s&apos;arrête encore, enregistrer un fichier d&apos;assistance dans Diagnostic.</translation>
    </message>
    <message>
        <source>A rail has a stretch out of tolerance.</source>
        <translation>Un rail a un tronçon hors tolérance.</translation>
    </message>
    <message>
        <source>The rail must not be delivered as it is.</source>
        <translation>Le rail ne doit pas être livré en l&apos;état.</translation>
    </message>
    <message>
        <source>Mark the rail, see its exceptions on Rails, tell the rolling mill which dimension and where.</source>
        <translation>Marquer le rail, voir ses dépassements dans Rails, indiquer au laminoir la cote et l&apos;endroit.</translation>
    </message>
    <message>
        <source>The rail looks like another section than that of the recipe.</source>
        <translation>Le rail ressemble à une autre section que celle de la recette.</translation>
    </message>
    <message>
        <source>It is judged by the wrong tolerances.</source>
        <translation>Il est jugé selon de mauvaises tolérances.</translation>
    </message>
    <message>
        <source>Choose the recipe of the rail that is rolled.</source>
        <translation>Choisir la recette du rail laminé.</translation>
    </message>
    <message>
        <source>The calibration in force is refused, missing or out of date.</source>
        <translation>L&apos;étalonnage en vigueur est refusé, absent ou périmé.</translation>
    </message>
    <message>
        <source>Uncertainties are not what the reports state.</source>
        <translation>Les incertitudes ne sont pas celles des rapports.</translation>
    </message>
    <message>
        <source>Calibrate, or bring back an earlier calibration.</source>
        <translation>Étalonner, ou reprendre un étalonnage antérieur.</translation>
    </message>
    <message>
        <source>The seam between two cameras has moved in normal production.</source>
        <translation>La jonction entre deux caméras s&apos;est déplacée en production normale.</translation>
    </message>
    <message>
        <source>Dimensions across the seam are biased by about as much.</source>
        <translation>Les cotes qui traversent la jonction sont biaisées d&apos;autant.</translation>
    </message>
    <message>
        <source>Check the mounting of the cameras beside the seam; calibrate the range finders at the next pause.</source>
        <translation>Vérifier la fixation des caméras près de la jonction ; étalonner les télémètres à la prochaine pause.</translation>
    </message>
    <message>
        <source>A camera loses frames.</source>
        <translation>Une caméra perd des images.</translation>
    </message>
    <message>
        <source>Profiles are incomplete now and then.</source>
        <translation>Des profils sont parfois incomplets.</translation>
    </message>
    <message>
        <source>Check cable, switch and packet size of the camera.</source>
        <translation>Vérifier câble, commutateur et taille de paquet de la caméra.</translation>
    </message>
    <message>
        <source>Much of a laser line is saturated.</source>
        <translation>Une grande partie d&apos;une ligne laser est saturée.</translation>
    </message>
    <message>
        <source>Points on bright patches are less certain.</source>
        <translation>Les points sur les zones brillantes sont moins sûrs.</translation>
    </message>
    <message>
        <source>Shorten the exposure of the camera or clean the window.</source>
        <translation>Réduire l&apos;exposition de la caméra ou nettoyer la fenêtre.</translation>
    </message>
    <message>
        <source>A laser line is faint.</source>
        <translation>Une ligne laser est faible.</translation>
    </message>
    <message>
        <source>Points are missing or uncertain.</source>
        <translation>Des points manquent ou sont incertains.</translation>
    </message>
    <message>
        <source>Clean the windows, check the laser, lengthen the exposure.</source>
        <translation>Nettoyer les fenêtres, vérifier le laser, allonger l&apos;exposition.</translation>
    </message>
    <message>
        <source>The rig is warmer than its calibration allows.</source>
        <translation>L&apos;installation est plus chaude que son étalonnage ne le permet.</translation>
    </message>
    <message>
        <source>Positions of cameras and lasers move.</source>
        <translation>Les positions des caméras et des lasers bougent.</translation>
    </message>
    <message>
        <source>Check cooling and air; calibrate if it stays so.</source>
        <translation>Vérifier refroidissement et air ; étalonner si cela persiste.</translation>
    </message>
    <message>
        <source>The disk is nearly full.</source>
        <translation>Le disque est presque plein.</translation>
    </message>
    <message>
        <source>Records of rails cannot be kept.</source>
        <translation>Les enregistrements des rails ne pourront être conservés.</translation>
    </message>
    <message>
        <source>Prune the archive or enlarge the disk.</source>
        <translation>Épurer l&apos;archive ou agrandir le disque.</translation>
    </message>
    <message>
        <source>The archive does not answer.</source>
        <translation>L&apos;archive ne répond pas.</translation>
    </message>
    <message>
        <source>Rails are measured; their records wait on this machine&apos;s disk.</source>
        <translation>Les rails sont mesurés ; leurs enregistrements attendent sur le disque de cette machine.</translation>
    </message>
    <message>
        <source>Check database and network; records are sent when it is back.</source>
        <translation>Vérifier base de données et réseau ; les enregistrements seront envoyés à son retour.</translation>
    </message>
    <message>
        <source>The queues of the measurement fill up.</source>
        <translation>Les files d&apos;attente de la mesure se remplissent.</translation>
    </message>
    <message>
        <source>Profiles will be dropped.</source>
        <translation>Des profils seront perdus.</translation>
    </message>
    <message>
        <source>Close what else runs on this machine; lower the trigger rate.</source>
        <translation>Fermer les autres programmes de cette machine ; réduire la cadence.</translation>
    </message>
    <message>
        <source>A toleranced dimension is not measured while a rail passes.</source>
        <translation>Une cote tolérancée n&apos;est pas mesurée pendant le passage d&apos;un rail.</translation>
    </message>
    <message>
        <source>The rail cannot be judged by it.</source>
        <translation>Le rail ne peut être jugé sur elle.</translation>
    </message>
    <message>
        <source>Clean windows and check lasers; see Stripes for where the line is missing.</source>
        <translation>Nettoyer les fenêtres et vérifier les lasers ; voir dans Lignes laser où la ligne manque.</translation>
    </message>
    <message>
        <source>The window answers slowly.</source>
        <translation>La fenêtre répond lentement.</translation>
    </message>
    <message>
        <source>What it shows is late; the measurement goes on.</source>
        <translation>L&apos;affichage est en retard ; la mesure continue.</translation>
    </message>
    <message>
        <source>Close what else runs on this machine; see Diagnostics.</source>
        <translation>Fermer les autres programmes de cette machine ; voir Diagnostic.</translation>
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
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>Rail %1 out of tolerance: %2</source>
        <translation>Rail %1 hors tolérance : %2</translation>
    </message>
    <message>
        <source>Camera %1 lost</source>
        <translation>Caméra %1 perdue</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
</context>
<context>
    <name>Dimension</name>
    <message>
        <source>Rail height</source>
        <translation>Hauteur du rail</translation>
    </message>
    <message>
        <source>Rail flange height</source>
        <translation>Hauteur de portée d&apos;éclisse</translation>
    </message>
    <message>
        <source>Foot width</source>
        <translation>Largeur du patin</translation>
    </message>
    <message>
        <source>Head form</source>
        <translation>Forme du champignon</translation>
    </message>
    <message>
        <source>Head width</source>
        <translation>Largeur du champignon</translation>
    </message>
    <message>
        <source>Head width (AREMA)</source>
        <translation>Largeur du champignon (AREMA)</translation>
    </message>
    <message>
        <source>Foot thickness left</source>
        <translation>Épaisseur du patin gauche</translation>
    </message>
    <message>
        <source>Foot thickness right</source>
        <translation>Épaisseur du patin droit</translation>
    </message>
    <message>
        <source>Rail asymmetry left</source>
        <translation>Asymétrie gauche</translation>
    </message>
    <message>
        <source>Rail asymmetry right</source>
        <translation>Asymétrie droite</translation>
    </message>
    <message>
        <source>Web thickness</source>
        <translation>Épaisseur de l&apos;âme</translation>
    </message>
    <message>
        <source>Head radius</source>
        <translation>Rayon du champignon</translation>
    </message>
    <message>
        <source>Foot concavity</source>
        <translation>Concavité du patin</translation>
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
        <translation>Proche limite</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Hors tol.</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Sans limite</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Non mesuré</translation>
    </message>
    <message>
        <source>not measured, because %1</source>
        <translation>non mesuré, car : %1</translation>
    </message>
    <message>
        <source>%1 above the limit</source>
        <translation>%1 au-dessus de la limite</translation>
    </message>
    <message>
        <source>%1 below the limit</source>
        <translation>%1 sous la limite</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>Hors tolérance</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Page %1 sur %2</translation>
    </message>
    <message>
        <source>No points</source>
        <translation>Pas de points</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Figé</translation>
    </message>
    <message>
        <source>No rail found</source>
        <translation>Aucun rail trouvé</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesuré</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Model %1 (approximate)</source>
        <translation>Modèle %1 (approché)</translation>
    </message>
    <message>
        <source>Model %1 (invented)</source>
        <translation>Modèle %1 (inventé)</translation>
    </message>
    <message>
        <source>Model %1</source>
        <translation>Modèle %1</translation>
    </message>
    <message>
        <source>Camera 1</source>
        <translation>Caméra 1</translation>
    </message>
    <message>
        <source>deviation %1 %2, ×%3</source>
        <translation>écart %1 %2, ×%3</translation>
    </message>
    <message>
        <source>Rail %1</source>
        <translation>Rail %1</translation>
    </message>
    <message>
        <source>Rail profile report</source>
        <translation>Rapport de profil de rail</translation>
    </message>
    <message>
        <source>%1   recipe %2   calibration %3</source>
        <translation>%1   recette %2   étalonnage %3</translation>
    </message>
    <message>
        <source>mm. s: standard deviation along the rail; u, U: standard and expanded uncertainty of one profile; Exc.: stretches out of tolerance.</source>
        <translation>mm. s : écart-type le long du rail ; u, U : incertitude-type et élargie d&apos;un profil ; Dép. : tronçons hors tolérance.</translation>
    </message>
    <message>
        <source>Profile at %1 m</source>
        <translation>Profil à %1 m</translation>
    </message>
    <message>
        <source>Dimensions along the rail, mm over m</source>
        <translation>Cotes le long du rail, mm sur m</translation>
    </message>
    <message>
        <source>mean of a stretch</source>
        <translation>moyenne d&apos;un tronçon</translation>
    </message>
    <message>
        <source>smallest to largest value of the stretch</source>
        <translation>de la plus petite à la plus grande valeur du tronçon</translation>
    </message>
    <message>
        <source>expected value</source>
        <translation>valeur attendue</translation>
    </message>
    <message>
        <source>limits; the ground outside is grey</source>
        <translation>limites ; le fond extérieur est gris</translation>
    </message>
    <message>
        <source>exception, with its square</source>
        <translation>dépassement, avec son carré</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>non mesuré</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>Dépassements</translation>
    </message>
    <message>
        <source>Exceptions: none</source>
        <translation>Dépassements : aucun</translation>
    </message>
    <message>
        <source> (continued)</source>
        <translation> (suite)</translation>
    </message>
    <message>
        <source>the first %1 of %2</source>
        <translation>les %1 premiers sur %2</translation>
    </message>
    <message>
        <source>from m</source>
        <translation>de m</translation>
    </message>
    <message>
        <source>to m</source>
        <translation>à m</translation>
    </message>
    <message>
        <source>length m</source>
        <translation>longueur m</translation>
    </message>
    <message>
        <source>worst mm</source>
        <translation>pire mm</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>écart</translation>
    </message>
    <message>
        <source>beyond limit</source>
        <translation>hors limite</translation>
    </message>
    <message>
        <source>Triggers</source>
        <translation>Déclenchements</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>vus</translation>
    </message>
    <message>
        <source>measured: complete, four contours</source>
        <translation>mesurés : complets, quatre contours</translation>
    </message>
    <message>
        <source>incomplete: a camera or the registration was missing</source>
        <translation>incomplets : une caméra ou le recalage manquait</translation>
    </message>
    <message>
        <source>lost: no profile</source>
        <translation>perdus : pas de profil</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>This section is invented: not for acceptance.</source>
        <translation>Cette section est inventée : pas pour la réception.</translation>
    </message>
    <message>
        <source>This section is approximate: not for acceptance.</source>
        <translation>Cette section est approchée : pas pour la réception.</translation>
    </message>
    <message>
        <source>profile at %1 m</source>
        <translation>profil à %1 m</translation>
    </message>
    <message>
        <source> and </source>
        <translation> et </translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cote</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Nominal</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
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
        <translation>Limites</translation>
    </message>
    <message>
        <source>Exc.</source>
        <translation>Dép.</translation>
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
        <translation>Rail</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Coulée</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Recette</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profils</translation>
    </message>
    <message>
        <source>Rail temperature</source>
        <translation>Température du rail</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>Measured (UTC)</source>
        <translation>Mesuré (UTC)</translation>
    </message>
    <message>
        <source>Written (UTC)</source>
        <translation>Rédigé (UTC)</translation>
    </message>
    <message>
        <source>Measured (local)</source>
        <translation>Mesuré (heure locale)</translation>
    </message>
    <message>
        <source>Written (local)</source>
        <translation>Rédigé (heure locale)</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>No limits to judge by</source>
        <translation>Pas de limites pour juger</translation>
    </message>
    <message>
        <source>Not valid</source>
        <translation>Non valide</translation>
    </message>
    <message>
        <source> out of tolerance</source>
        <translation> hors tolérance</translation>
    </message>
    <message>
        <source> from %1 to %2 m</source>
        <translation> de %1 à %2 m</translation>
    </message>
    <message>
        <source> in %1 stretches, the first at %2 m</source>
        <translation> en %1 tronçons, le premier à %2 m</translation>
    </message>
    <message>
        <source> not measured</source>
        <translation> non mesuré</translation>
    </message>
    <message>
        <source> not measured, because %1</source>
        <translation> non mesuré, car : %1</translation>
    </message>
    <message>
        <source> near limit</source>
        <translation> proche limite</translation>
    </message>
    <message>
        <source>%1 toleranced dimensions within their limits over %2 m</source>
        <translation>%1 cotes tolérancées dans leurs limites sur %2 m</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULATION</translation>
    </message>
    <message>
        <source>Not measured, because %1</source>
        <translation>Non mesuré, car : %1</translation>
    </message>
    <message>
        <source>Lengths refer to 15 °C. U is the expanded uncertainty with k = 2; a value nearer to a limit than U is near limit: it cannot be decided.</source>
        <translation>Les longueurs se rapportent à 15 °C. U est l&apos;incertitude élargie avec k = 2 ; une valeur plus proche d&apos;une limite que U est proche limite : on ne peut décider.</translation>
    </message>
    <message>
        <source>mm at 15 °C</source>
        <translation>mm à 15 °C</translation>
    </message>
    <message>
        <source>Before registration</source>
        <translation>Avant le recalage</translation>
    </message>
    <message>
        <source>across %1, up %2 %3, turned %4°</source>
        <translation>travers %1, haut %2 %3, tourné de %4°</translation>
    </message>
    <message>
        <source>As seen</source>
        <translation>Comme vu</translation>
    </message>
    <message>
        <source>Registered</source>
        <translation>Recalé</translation>
    </message>
</context>
<context>
    <name>Engine</name>
    <message>
        <source>wrong section: looks like %1 rather than %2</source>
        <translation>mauvaise section : ressemble à %1 plutôt qu&apos;à %2</translation>
    </message>
    <message>
        <source>wrong section: looks like %1</source>
        <translation>mauvaise section : ressemble à %1</translation>
    </message>
    <message>
        <source>not registered: %1</source>
        <translation>non recalé : %1</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>non recalé</translation>
    </message>
    <message>
        <source>looks like %1</source>
        <translation>ressemble à %1</translation>
    </message>
    <message>
        <source>the points do not agree with %1: %2 lie on it, rms %3 mm; another rail, badly worn, or not a rail?</source>
        <translation>les points ne concordent pas avec %1 : %2 y sont, rms %3 mm ; autre rail, très usé, ou pas un rail ?</translation>
    </message>
    <message>
        <source>the points do not agree with %1</source>
        <translation>les points ne concordent pas avec %1</translation>
    </message>
    <message>
        <source>the section has no web</source>
        <translation>la section n&apos;a pas d&apos;âme</translation>
    </message>
    <message>
        <source>the points do not determine a pose</source>
        <translation>les points ne déterminent pas de position</translation>
    </message>
    <message>
        <source>the foot edge is not upright</source>
        <translation>le bord du patin n&apos;est pas vertical</translation>
    </message>
    <message>
        <source>the crown is flat</source>
        <translation>la table de roulement est plate</translation>
    </message>
    <message>
        <source>points do not reach x = %1 from the axis</source>
        <translation>les points n&apos;atteignent pas x = %1 de l&apos;axe</translation>
    </message>
    <message>
        <source>points do not reach the crown on the axis</source>
        <translation>les points n&apos;atteignent pas la table de roulement sur l&apos;axe</translation>
    </message>
    <message>
        <source>points do not reach %1 above the base line</source>
        <translation>les points n&apos;atteignent pas %1 au-dessus de la ligne de base</translation>
    </message>
    <message>
        <source>not defined on this section</source>
        <translation>non définie sur cette section</translation>
    </message>
    <message>
        <source>no point is near the outline of %1</source>
        <translation>aucun point n&apos;est proche du contour de %1</translation>
    </message>
    <message>
        <source>no base line: %1</source>
        <translation>pas de ligne de base : %1</translation>
    </message>
    <message>
        <source>measurement failed</source>
        <translation>échec de la mesure</translation>
    </message>
    <message>
        <source>extraction failed</source>
        <translation>échec de l&apos;extraction</translation>
    </message>
    <message>
        <source>translation failed</source>
        <translation>échec de la conversion</translation>
    </message>
    <message>
        <source>the profile is not registered</source>
        <translation>le profil n&apos;est pas recalé</translation>
    </message>
    <message>
        <source>no points on %1</source>
        <translation>pas de points sur %1</translation>
    </message>
    <message>
        <source>only %1 point on %2, %3 are needed</source>
        <translation>%1 seul point sur %2, il en faut %3</translation>
    </message>
    <message>
        <source>only %1 points on %2, %3 are needed</source>
        <translation>seulement %1 points sur %2, il en faut %3</translation>
    </message>
    <message>
        <source>only %1 points, at least %2 are needed</source>
        <translation>seulement %1 points, il en faut au moins %2</translation>
    </message>
    <message>
        <source>the points on %1 make no curve</source>
        <translation>les points sur %1 ne forment pas de courbe</translation>
    </message>
    <message>
        <source>%1 is not fitted</source>
        <translation>%1 n&apos;est pas ajusté</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>pas de points</translation>
    </message>
    <message>
        <source>no profiles</source>
        <translation>pas de profils</translation>
    </message>
    <message>
        <source>no frames</source>
        <translation>pas d&apos;images</translation>
    </message>
    <message>
        <source>no frame</source>
        <translation>pas d&apos;image</translation>
    </message>
    <message>
        <source>frame lost</source>
        <translation>image perdue</translation>
    </message>
    <message>
        <source>repeated frame</source>
        <translation>image répétée</translation>
    </message>
    <message>
        <source>late frame</source>
        <translation>image tardive</translation>
    </message>
    <message>
        <source>too late</source>
        <translation>trop tard</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>arrêté</translation>
    </message>
    <message>
        <source>source failed</source>
        <translation>échec de la source</translation>
    </message>
    <message>
        <source>queue overflow</source>
        <translation>file débordée</translation>
    </message>
    <message>
        <source>outside of a rail</source>
        <translation>hors d&apos;un rail</translation>
    </message>
    <message>
        <source>missed by all cameras</source>
        <translation>manqué par toutes les caméras</translation>
    </message>
    <message>
        <source>%1 from %2 m</source>
        <translation>%1 à partir de %2 m</translation>
    </message>
    <message>
        <source>camera %1: %2</source>
        <translation>caméra %1 : %2</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>caméra %1</translation>
    </message>
    <message>
        <source>rail %1</source>
        <translation>rail %1</translation>
    </message>
    <message>
        <source>line</source>
        <translation>ligne</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>étalonnage</translation>
    </message>
    <message>
        <source>archive</source>
        <translation>archive</translation>
    </message>
    <message>
        <source>pipeline</source>
        <translation>chaîne de traitement</translation>
    </message>
    <message>
        <source>window</source>
        <translation>fenêtre</translation>
    </message>
    <message>
        <source>disk</source>
        <translation>disque</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>opérateur</translation>
    </message>
    <message>
        <source>range finders</source>
        <translation>télémètres</translation>
    </message>
    <message>
        <source>rail %1 has passed: %2</source>
        <translation>le rail %1 est passé : %2</translation>
    </message>
    <message>
        <source>the line was started</source>
        <translation>la ligne a été démarrée</translation>
    </message>
    <message>
        <source>the line was stopped</source>
        <translation>la ligne a été arrêtée</translation>
    </message>
    <message>
        <source>%1 signed in</source>
        <translation>%1 s&apos;est connecté</translation>
    </message>
    <message>
        <source>%1 signed out</source>
        <translation>%1 s&apos;est déconnecté</translation>
    </message>
    <message>
        <source>good</source>
        <translation>conforme</translation>
    </message>
    <message>
        <source>near limit</source>
        <translation>proche limite</translation>
    </message>
    <message>
        <source>out of tolerance</source>
        <translation>hors tolérance</translation>
    </message>
    <message>
        <source>no limits</source>
        <translation>sans limites</translation>
    </message>
    <message>
        <source>not valid</source>
        <translation>non valide</translation>
    </message>
    <message>
        <source>is shorter than %1 characters</source>
        <translation>a moins de %1 caractères</translation>
    </message>
    <message>
        <source>the old one is wrong</source>
        <translation>l&apos;ancien est faux</translation>
    </message>
    <message>
        <source>too many wrong ones; locked until %1</source>
        <translation>trop d&apos;erreurs ; bloqué jusqu&apos;à %1</translation>
    </message>
    <message>
        <source>needs a reason; say why</source>
        <translation>exige un motif ; dire pourquoi</translation>
    </message>
    <message>
        <source>an entry needs who and what</source>
        <translation>une entrée exige qui et quoi</translation>
    </message>
    <message>
        <source>password</source>
        <translation>mot de passe</translation>
    </message>
    <message>
        <source>is no user here</source>
        <translation>n&apos;est pas inscrit ici</translation>
    </message>
    <message>
        <source>is longer than 1024 bytes</source>
        <translation>a plus de 1024 octets</translation>
    </message>
    <message>
        <source>a name has 1 to 64 characters</source>
        <translation>un nom a de 1 à 64 caractères</translation>
    </message>
    <message>
        <source>the first user must be an administrator</source>
        <translation>le premier utilisateur doit être administrateur</translation>
    </message>
    <message>
        <source>is a user already</source>
        <translation>est déjà inscrit</translation>
    </message>
    <message>
        <source>is the last administrator; make another one first</source>
        <translation>est le dernier administrateur ; en nommer d&apos;abord un autre</translation>
    </message>
    <message>
        <source>there is none</source>
        <translation>il n&apos;y en a pas</translation>
    </message>
    <message>
        <source>no archive was asked for (--archive)</source>
        <translation>aucune archive demandée (--archive)</translation>
    </message>
    <message>
        <source>exact (virtual rig)</source>
        <translation>exact (installation virtuelle)</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>plan</translation>
    </message>
    <message>
        <source>none (generated numbers)</source>
        <translation>aucun (nombres générés)</translation>
    </message>
</context>
<context>
    <name>Judgement</name>
    <message>
        <source>from %1 on</source>
        <translation>à partir de %1</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>de %1 à %2</translation>
    </message>
    <message>
        <source>%1 %2 above the limit %3</source>
        <translation>%1 %2 au-dessus de la limite %3</translation>
    </message>
    <message>
        <source>%1 %2 below the limit %3</source>
        <translation>%1 %2 sous la limite %3</translation>
    </message>
    <message>
        <source>%1 beyond the limit %2</source>
        <translation>%1 au-delà de la limite %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>camera %1 lost</source>
        <translation>caméra %1 perdue</translation>
    </message>
    <message>
        <source>cameras %1 lost</source>
        <translation>caméras %1 perdues</translation>
    </message>
    <message>
        <source>%1 dimensions</source>
        <translation>%1 cotes</translation>
    </message>
    <message>
        <source>Not valid</source>
        <translation>Non valide</translation>
    </message>
    <message>
        <source>%1 not measured from %2 on: %3</source>
        <translation>%1 non mesuré à partir de %2 : %3</translation>
    </message>
    <message>
        <source>%1 near limit</source>
        <translation>%1 proche limite</translation>
    </message>
    <message>
        <source>single profiles outside the limits</source>
        <translation>quelques profils hors des limites</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>Hors tolérance</translation>
    </message>
    <message>
        <source>%1 %2 inside the limit, closer than U</source>
        <translation>%1 %2 dans la limite, plus proche que U</translation>
    </message>
    <message>
        <source>%1 %2 outside the limit, by less than U</source>
        <translation>%1 %2 hors limite, de moins de U</translation>
    </message>
    <message>
        <source>within the guard band earlier on this rail</source>
        <translation>dans la bande de garde plus tôt sur ce rail</translation>
    </message>
    <message>
        <source>%1 within the guard band earlier on this rail</source>
        <translation>%1 dans la bande de garde plus tôt sur ce rail</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>Proche limite</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Conforme</translation>
    </message>
    <message>
        <source>%1 dimensions within limits up to %2</source>
        <translation>%1 cotes dans les limites jusqu&apos;à %2</translation>
    </message>
    <message>
        <source>Waiting for a rail</source>
        <translation>Attente d&apos;un rail</translation>
    </message>
    <message>
        <source>the gauge is ready; values appear with the head of the rail</source>
        <translation>l&apos;appareil est prêt ; les valeurs apparaissent avec la tête du rail</translation>
    </message>
    <message>
        <source>the line is not running: Ctrl+R starts it</source>
        <translation>la ligne est arrêtée : Ctrl+R la démarre</translation>
    </message>
    <message>
        <source>No limits</source>
        <translation>Sans limites</translation>
    </message>
    <message>
        <source>the recipe gives no tolerance to any dimension</source>
        <translation>la recette ne donne de tolérance à aucune cote</translation>
    </message>
    <message>
        <source>this rail was not measured completely</source>
        <translation>ce rail n&apos;a pas été entièrement mesuré</translation>
    </message>
    <message>
        <source>%1 not measured on enough of this rail</source>
        <translation>%1 mesuré sur une part insuffisante de ce rail</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>Au repos</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Armée</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>No profiles</source>
        <translation>Sans profil</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêtée</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Défaut</translation>
    </message>
    <message>
        <source>no profiles since %1, %2 ago. Hold this rail.</source>
        <translation>pas de profils depuis %1, il y a %2. Retenir ce rail.</translation>
    </message>
    <message>
        <source>held: last profile at %1, %2 ago</source>
        <translation>figé : dernier profil à %1, il y a %2</translation>
    </message>
    <message>
        <source>%1 of %2 cameras, %3 profiles/s</source>
        <translation>%1 caméras sur %2, %3 profils/s</translation>
    </message>
    <message>
        <source>no profiles for %1</source>
        <translation>pas de profils depuis %1</translation>
    </message>
    <message>
        <source>calibration %1</source>
        <translation>étalonnage %1</translation>
    </message>
    <message>
        <source>Not trusted</source>
        <translation>Non fiable</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Sans données</translation>
    </message>
    <message>
        <source>no profile yet</source>
        <translation>pas encore de profil</translation>
    </message>
    <message>
        <source>the line is not running</source>
        <translation>la ligne est arrêtée</translation>
    </message>
    <message>
        <source>Degraded</source>
        <translation>Dégradé</translation>
    </message>
    <message>
        <source>%1 of %2 incomplete</source>
        <translation>%1 sur %2 incomplets</translation>
    </message>
    <message>
        <source>Trusted</source>
        <translation>Fiable</translation>
    </message>
    <message>
        <source>The line is stopped: Ctrl+R starts it</source>
        <translation>La ligne est arrêtée : Ctrl+R la démarre</translation>
    </message>
    <message>
        <source>Ready for the next rail</source>
        <translation>Prête pour le prochain rail</translation>
    </message>
    <message>
        <source>No alarm on this rail</source>
        <translation>Aucune alarme sur ce rail</translation>
    </message>
</context>
<context>
    <name>Page</name>
    <message>
        <source>Monitor</source>
        <translation>Moniteur</translation>
    </message>
    <message>
        <source>Stripes</source>
        <translation>Lignes laser</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Rails</source>
        <translation>Rails</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recettes</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualité</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnostic</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
</context>
<context>
    <name>RecipeSetting</name>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Profile class</source>
        <translation>Classe de profil</translation>
    </message>
    <message>
        <source>Straightness class</source>
        <translation>Classe de rectitude</translation>
    </message>
    <message>
        <source>RFH: distance from the axis, mm</source>
        <translation>RFH : distance à l&apos;axe, mm</translation>
    </message>
    <message>
        <source>HF: half width of the crown, mm</source>
        <translation>HF : demi-largeur de la table, mm</translation>
    </message>
    <message>
        <source>HW: depth below the crown, mm</source>
        <translation>HW : profondeur sous la table, mm</translation>
    </message>
    <message>
        <source>HWA: the AREMA depth, mm</source>
        <translation>HWA : profondeur AREMA, mm</translation>
    </message>
    <message>
        <source>FT: inside the foot edges, mm</source>
        <translation>FT : en retrait des bords du patin, mm</translation>
    </message>
    <message>
        <source>RAS: depth below the crown, mm</source>
        <translation>RAS : profondeur sous la table, mm</translation>
    </message>
    <message>
        <source>WT: height, mm (none: thinnest)</source>
        <translation>WT : hauteur, mm (sans : au plus mince)</translation>
    </message>
    <message>
        <source>Base line: inside the foot edges, mm</source>
        <translation>Ligne de base : en retrait des bords, mm</translation>
    </message>
    <message>
        <source>Line: smoothing σ, px</source>
        <translation>Ligne : lissage σ, px</translation>
    </message>
    <message>
        <source>Line: low threshold, DN</source>
        <translation>Ligne : seuil bas, DN</translation>
    </message>
    <message>
        <source>Line: high threshold, DN</source>
        <translation>Ligne : seuil haut, DN</translation>
    </message>
    <message>
        <source>Line: longest gap bridged, px</source>
        <translation>Ligne : plus long trou comblé, px</translation>
    </message>
    <message>
        <source>Line: largest angle joined, °</source>
        <translation>Ligne : angle maximal de liaison, °</translation>
    </message>
    <message>
        <source>Line: shortest kept, points</source>
        <translation>Ligne : plus courte gardée, points</translation>
    </message>
    <message>
        <source>Line: blocks before overload</source>
        <translation>Ligne : blocs avant surcharge</translation>
    </message>
    <message>
        <source>Line: pull of bends taken off</source>
        <translation>Ligne : biais des courbures corrigé</translation>
    </message>
    <message>
        <source>Registration: scale at first, mm</source>
        <translation>Recalage : échelle initiale, mm</translation>
    </message>
    <message>
        <source>Registration: scale with a start, mm</source>
        <translation>Recalage : échelle avec départ, mm</translation>
    </message>
    <message>
        <source>Registration: inlier below, mm</source>
        <translation>Recalage : point cohérent sous, mm</translation>
    </message>
    <message>
        <source>Registration: points used within, mm</source>
        <translation>Recalage : points utilisés jusqu&apos;à, mm</translation>
    </message>
    <message>
        <source>Registration: fails above rms, mm</source>
        <translation>Recalage : échec au-dessus de rms, mm</translation>
    </message>
    <message>
        <source>Registration: fails below share</source>
        <translation>Recalage : échec sous la part</translation>
    </message>
    <message>
        <source>Measuring: ends left out, mm</source>
        <translation>Mesure : bouts écartés, mm</translation>
    </message>
    <message>
        <source>Measuring: least points</source>
        <translation>Mesure : points au minimum</translation>
    </message>
    <message>
        <source>Measuring: expansion, 1/K</source>
        <translation>Mesure : dilatation, 1/K</translation>
    </message>
    <message>
        <source>Measuring: hottest rail, °C</source>
        <translation>Mesure : rail le plus chaud, °C</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>%1: limits, mm</source>
        <translation>%1 : limites, mm</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>non jugée</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
</context>
<context>
    <name>Role</name>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Technician</source>
        <translation>Technicien</translation>
    </message>
    <message>
        <source>QA</source>
        <translation>Qualité</translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation>Administrateur</translation>
    </message>
</context>
<context>
    <name>StudyReport</name>
    <message>
        <source>no outlier</source>
        <translation>aucune aberrante</translation>
    </message>
    <message>
        <source>straggler (5 %)</source>
        <translation>valeur isolée (5 %)</translation>
    </message>
    <message>
        <source>outlier (1 %)</source>
        <translation>valeur aberrante (1 %)</translation>
    </message>
    <message>
        <source>%1: %2, critical %3 at 1 %</source>
        <translation>%1 : %2, critique %3 à 1 %</translation>
    </message>
    <message>
        <source>Mean range of the runs, mm, per %1 m (Table VI)</source>
        <translation>Étendue moyenne des passages, mm, par %1 m (Tableau VI)</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cote</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>share of T, %</source>
        <translation>part de T, %</translation>
    </message>
    <message>
        <source>Errors against the reference, mm (Table V)</source>
        <translation>Erreurs par rapport à la référence, mm (Tableau V)</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>biais</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>maximum</translation>
    </message>
    <message>
        <source>largest, %</source>
        <translation>maximum, %</translation>
    </message>
    <message>
        <source>E_n above 1</source>
        <translation>E_n &gt; 1</translation>
    </message>
    <message>
        <source>%1: values of the runs</source>
        <translation>%1 : valeurs des passages</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>longueur, m</translation>
    </message>
    <message>
        <source>%1: range of the runs</source>
        <translation>%1 : étendue des passages</translation>
    </message>
    <message>
        <source>%1: error at each position</source>
        <translation>%1 : erreur à chaque position</translation>
    </message>
    <message>
        <source>mean of the runs</source>
        <translation>moyenne des passages</translation>
    </message>
    <message>
        <source>No verdict</source>
        <translation>Pas de verdict</translation>
    </message>
    <message>
        <source>no dimension has both a tolerance and figures</source>
        <translation>aucune cote n&apos;a à la fois tolérance et chiffres</translation>
    </message>
    <message>
        <source>Repeatable</source>
        <translation>Répétable</translation>
    </message>
    <message>
        <source>Not repeatable</source>
        <translation>Non répétable</translation>
    </message>
    <message>
        <source>%1 uses the largest share of its tolerance, %2; allowed are %3 %</source>
        <translation>%1 utilise la plus grande part de sa tolérance, %2 ; sont admis %3 %</translation>
    </message>
    <message>
        <source>uncertainties of values and reference are both needed for E_n; the figures stand by themselves</source>
        <translation>E_n exige les incertitudes des valeurs et de la référence ; les chiffres sont donnés tels quels</translation>
    </message>
    <message>
        <source>Agrees</source>
        <translation>Concorde</translation>
    </message>
    <message>
        <source>Does not agree</source>
        <translation>Ne concorde pas</translation>
    </message>
    <message>
        <source>worst is %1: E n above 1 in %2 of its %3 values; chance allows %4</source>
        <translation>la pire : %1, E n &gt; 1 pour %2 de ses %3 valeurs ; le hasard permet %4</translation>
    </message>
    <message>
        <source>Runs and positions</source>
        <translation>Passages et positions</translation>
    </message>
    <message>
        <source>Repeatability s r</source>
        <translation>Répétabilité s r</translation>
    </message>
    <message>
        <source>its 95 % interval</source>
        <translation>son intervalle à 95 %</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Limit r = 2.8 s r</source>
        <translation>Limite r = 2,8 s r</translation>
    </message>
    <message>
        <source>Mean and largest range</source>
        <translation>Étendue moyenne et maximale</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>s from the range</source>
        <translation>s d&apos;après l&apos;étendue</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autocorrélation</translation>
    </message>
    <message>
        <source>Left out: a run lacks them</source>
        <translation>Écartées : absentes d&apos;un passage</translation>
    </message>
    <message>
        <source>Grubbs, means of the runs</source>
        <translation>Grubbs, moyennes des passages</translation>
    </message>
    <message>
        <source>Cochran, scatter of the runs</source>
        <translation>Cochran, dispersion des passages</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>Biais</translation>
    </message>
    <message>
        <source>RMS error</source>
        <translation>Erreur RMS</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>Erreur maximale</translation>
    </message>
    <message>
        <source>in % of the reference</source>
        <translation>en % de la référence</translation>
    </message>
    <message>
        <source>Limits of agreement</source>
        <translation>Limites de concordance</translation>
    </message>
    <message>
        <source>interval of the lower</source>
        <translation>intervalle de l&apos;inférieure</translation>
    </message>
    <message>
        <source>interval of the upper</source>
        <translation>intervalle de la supérieure</translation>
    </message>
    <message>
        <source>Largest E n</source>
        <translation>E n maximal</translation>
    </message>
    <message>
        <source>E n above 1</source>
        <translation>E n &gt; 1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Repeatability study</source>
        <translation>Étude de répétabilité</translation>
    </message>
    <message>
        <source>Accuracy study</source>
        <translation>Étude d&apos;exactitude</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Passages</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolérances</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>means over %1 m</source>
        <translation>moyennes sur %1 m</translation>
    </message>
    <message>
        <source>single profiles</source>
        <translation>profils individuels</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
    <message>
        <source>Runs: %1.</source>
        <translation>Passages : %1.</translation>
    </message>
    <message>
        <source>Conditions: %1.</source>
        <translation>Conditions : %1.</translation>
    </message>
    <message>
        <source>%1 over the length, as Fig. 9</source>
        <translation>%1 sur la longueur, comme Fig. 9</translation>
    </message>
    <message>
        <source>%1 against its reference</source>
        <translation>%1 par rapport à la référence</translation>
    </message>
    <message>
        <source>Figures of %1</source>
        <translation>Chiffres : %1</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmCard</name>
    <message>
        <source>comes and goes</source>
        <translation>va et vient</translation>
    </message>
    <message>
        <source>on for more than a day</source>
        <translation>active depuis plus d&apos;un jour</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>disparue</translation>
    </message>
    <message>
        <source>acknowledged by %1</source>
        <translation>acquittée par %1</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarme</numerusform>
            <numerusform>%n alarmes</numerusform>
        </translation>
    </message>
    <message>
        <source>Priority %1</source>
        <translation>Priorité %1</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Cause</translation>
    </message>
    <message>
        <source>Consequence</source>
        <translation>Conséquence</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Acquitter</translation>
    </message>
    <message>
        <source>Acknowledge: %1</source>
        <translation>Acquitter : %1</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmHistoryPanel</name>
    <message>
        <source>What happened</source>
        <translation>Ce qui s&apos;est passé</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Show the alarms that came and went</source>
        <translation>Montrer les alarmes passées</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Événements</translation>
    </message>
    <message>
        <source>Show events</source>
        <translation>Montrer les événements</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Exporter en CSV</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>Apparue</translation>
    </message>
    <message>
        <source>Went</source>
        <translation>Disparue</translation>
    </message>
    <message>
        <source>Lasted</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Par</translation>
    </message>
    <message>
        <source>Alarms that came and went, newest first</source>
        <translation>Alarmes passées, la plus récente d&apos;abord</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Événement</translation>
    </message>
    <message>
        <source>Events, newest first</source>
        <translation>Événements, le plus récent d&apos;abord</translation>
    </message>
    <message>
        <source>still on</source>
        <translation>encore active</translation>
    </message>
    <message>
        <source>shelved: %1</source>
        <translation>suspendue : %1</translation>
    </message>
    <message>
        <source>nobody yet</source>
        <translation>personne encore</translation>
    </message>
    <message>
        <source>no alarm so far</source>
        <translation>aucune alarme jusqu&apos;ici</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarme</numerusform>
            <numerusform>%n alarmes</numerusform>
        </translation>
    </message>
    <message>
        <source>no event so far</source>
        <translation>aucun événement jusqu&apos;ici</translation>
    </message>
    <message numerus="yes">
        <source>%n event(s)</source>
        <translation>
            <numerusform>%n événement</numerusform>
            <numerusform>%n événements</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 est écrit</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 ne peut être écrit : %2</translation>
    </message>
    <message>
        <source>program ended</source>
        <translation>fin du programme</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmLine</name>
    <message>
        <source>Alarm, priority %1: %2. %3</source>
        <translation>Alarme, priorité %1 : %2. %3</translation>
    </message>
    <message>
        <source>1 of %1</source>
        <translation>1 sur %1</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) acknowledged, still on</source>
        <translation>
            <numerusform>%n alarme acquittée, encore active</numerusform>
            <numerusform>%n alarmes acquittées, encore actives</numerusform>
        </translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Acquitter</translation>
    </message>
    <message>
        <source>Acknowledge the shown alarm</source>
        <translation>Acquitter l&apos;alarme affichée</translation>
    </message>
    <message>
        <source>Acknowledge the shown alarm (Ctrl+A)</source>
        <translation>Acquitter l&apos;alarme affichée (Ctrl+A)</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmsPage</name>
    <message>
        <source>Active</source>
        <translation>Actives</translation>
    </message>
    <message>
        <source>Acknowledge page</source>
        <translation>Acquitter la page</translation>
    </message>
    <message>
        <source>Acknowledge all that are shown</source>
        <translation>Acquitter toutes les affichées</translation>
    </message>
    <message>
        <source>Acknowledge all that are shown (Ctrl+Shift+A)</source>
        <translation>Acquitter toutes les affichées (Ctrl+Maj+A)</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Fréquence</translation>
    </message>
    <message>
        <source>10 min</source>
        <translation>10 min</translation>
    </message>
    <message>
        <source>Hour</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Jour</translation>
    </message>
    <message>
        <source>Shelve</source>
        <translation>Suspendre</translation>
    </message>
    <message>
        <source>hides an alarm for a while</source>
        <translation>masque une alarme un moment</translation>
    </message>
    <message>
        <source>Alarm to shelve</source>
        <translation>Alarme à suspendre</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Reason for shelving</source>
        <translation>Motif de la suspension</translation>
    </message>
    <message>
        <source>For how long</source>
        <translation>Pour combien de temps</translation>
    </message>
    <message>
        <source>Shelved</source>
        <translation>Suspendues</translation>
    </message>
    <message>
        <source>comes back by itself</source>
        <translation>revient d&apos;elle-même</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Bring back the chosen alarm</source>
        <translation>Reprendre l&apos;alarme choisie</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Jusqu&apos;à</translation>
    </message>
    <message>
        <source>Shelved alarms</source>
        <translation>Alarmes suspendues</translation>
    </message>
    <message>
        <source>An operator may shelve for %1 minutes at most.</source>
        <translation>Un opérateur peut suspendre %1 minutes au plus.</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarme</numerusform>
            <numerusform>%n alarmes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not acknowledged</source>
        <translation>
            <numerusform>%n non acquittée</numerusform>
            <numerusform>%n non acquittées</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is wrong. Alarms appear here with their cause, their consequence and what to do.</source>
        <translation>Tout va bien. Les alarmes apparaissent ici avec leur cause, leur conséquence et que faire.</translation>
    </message>
    <message>
        <source>since the program started</source>
        <translation>depuis le démarrage du programme</translation>
    </message>
    <message>
        <source>Flood: more than 10 alarms in 10 minutes. Look for one cause behind them.</source>
        <translation>Avalanche : plus de 10 alarmes en 10 minutes. Chercher une cause commune.</translation>
    </message>
    <message>
        <source>Target: below 1 in 10 minutes; above 10 it is a flood.</source>
        <translation>Cible : moins de 1 en 10 minutes ; au-delà de 10, c&apos;est une avalanche.</translation>
    </message>
    <message>
        <source>alarms in 10 minutes</source>
        <translation>alarmes en 10 minutes</translation>
    </message>
    <message>
        <source>Health of the alarms</source>
        <translation>Santé des alarmes</translation>
    </message>
    <message>
        <source>flood: grouped by rule</source>
        <translation>avalanche : groupées par règle</translation>
    </message>
    <message>
        <source>Mean per 10 minutes</source>
        <translation>Moyenne par 10 minutes</translation>
    </message>
    <message>
        <source>%1, target below 1</source>
        <translation>%1, cible &lt; 1</translation>
    </message>
    <message>
        <source>Floods</source>
        <translation>Avalanches</translation>
    </message>
    <message>
        <source>Comes and goes</source>
        <translation>Va et vient</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>On for more than a day</source>
        <translation>Active depuis plus d&apos;un jour</translation>
    </message>
    <message>
        <source>Shelving needs a reason.</source>
        <translation>Suspendre exige un motif.</translation>
    </message>
</context>
<context>
    <name>vignole::AuditPanel</name>
    <message>
        <source>Audit trail</source>
        <translation>Piste d&apos;audit</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Qui</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Of what</source>
        <translation>De quoi</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Audit trail, newest first</source>
        <translation>Piste d&apos;audit, la plus récente d&apos;abord</translation>
    </message>
    <message>
        <source>Check the chain</source>
        <translation>Vérifier la chaîne</translation>
    </message>
    <message>
        <source>Check that no entry was changed, put in or taken out</source>
        <translation>Vérifier qu&apos;aucune entrée n&apos;a été changée, ajoutée ou retirée</translation>
    </message>
    <message>
        <source>The audit trail is shown to QA and administrators who have signed in.</source>
        <translation>La piste d&apos;audit est montrée à la qualité et aux administrateurs connectés.</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s), the newest first</source>
        <translation>
            <numerusform>%n entrée, la plus récente d&apos;abord</numerusform>
            <numerusform>%n entrées, la plus récente d&apos;abord</numerusform>
        </translation>
    </message>
    <message>
        <source>checking …</source>
        <translation>vérification …</translation>
    </message>
    <message>
        <source>The chain is whole: no entry was changed, put in or taken out.</source>
        <translation>La chaîne est intacte : aucune entrée changée, ajoutée ou retirée.</translation>
    </message>
    <message>
        <source>The chain is broken: %1</source>
        <translation>La chaîne est rompue : %1</translation>
    </message>
</context>
<context>
    <name>vignole::CalibrationDesk</name>
    <message>
        <source>Calibrations are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>Les étalonnages ne sont pas conservés : %1. Démarrer le programme avec une archive (--archive FILE).</translation>
    </message>
    <message>
        <source>Calibrating is the technician&apos;s: sign in as technician or QA (Settings, F10).</source>
        <translation>L&apos;étalonnage relève du technicien : se connecter comme technicien ou qualité (Réglages, F10).</translation>
    </message>
    <message>
        <source>There is no archive, so a calibration could neither be kept nor reverted: start the program with --archive FILE.</source>
        <translation>Sans archive, un étalonnage ne pourrait être ni conservé ni repris : démarrer le programme avec --archive FILE.</translation>
    </message>
    <message>
        <source>Another calibration needs a reason.</source>
        <translation>Un autre étalonnage exige un motif.</translation>
    </message>
</context>
<context>
    <name>vignole::CalibrationOverview</name>
    <message>
        <source>In force</source>
        <translation>En vigueur</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Étalonner</translation>
    </message>
    <message>
        <source>What it is worth</source>
        <translation>Ce qu&apos;il vaut</translation>
    </message>
    <message>
        <source>Calibrations kept</source>
        <translation>Étalonnages conservés</translation>
    </message>
    <message>
        <source>choose one to compare it with the one in force</source>
        <translation>en choisir un pour le comparer à celui en vigueur</translation>
    </message>
    <message>
        <source>Range finders…</source>
        <translation>Télémètres…</translation>
    </message>
    <message>
        <source>Calibrate the range finders with the pin plate</source>
        <translation>Étalonner les télémètres avec la plaque à pions</translation>
    </message>
    <message>
        <source>Lens of a camera…</source>
        <translation>Objectif de caméra…</translation>
    </message>
    <message>
        <source>Calibrate the lens of a camera with the flat target</source>
        <translation>Étalonner l&apos;objectif d&apos;une caméra avec la mire plane</translation>
    </message>
    <message>
        <source>Encoder…</source>
        <translation>Codeur…</translation>
    </message>
    <message>
        <source>Calibrate the encoder over a known length</source>
        <translation>Étalonner le codeur sur une longueur connue</translation>
    </message>
    <message>
        <source>Reference piece…</source>
        <translation>Pièce de référence…</translation>
    </message>
    <message>
        <source>Check the calibration on a reference piece</source>
        <translation>Vérifier l&apos;étalonnage sur une pièce de référence</translation>
    </message>
    <message>
        <source>Parameter study…</source>
        <translation>Étude de paramètres…</translation>
    </message>
    <message>
        <source>Study which settings of the calibration matter</source>
        <translation>Étudier quels réglages de l&apos;étalonnage comptent</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Conservé</translation>
    </message>
    <message>
        <source>By, because</source>
        <translation>Par, motif</translation>
    </message>
    <message>
        <source>What the calibration in force is worth</source>
        <translation>Ce que vaut l&apos;étalonnage en vigueur</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Reason for putting it back in force</source>
        <translation>Motif de la remise en vigueur</translation>
    </message>
    <message>
        <source>Put in force</source>
        <translation>Mise en vigueur</translation>
    </message>
    <message>
        <source>Put the chosen calibration in force</source>
        <translation>Mettre en vigueur l&apos;étalonnage choisi</translation>
    </message>
    <message>
        <source>No calibration</source>
        <translation>Aucun étalonnage</translation>
    </message>
    <message>
        <source>Nothing can be measured: calibrate the range finders.</source>
        <translation>Rien ne peut être mesuré : étalonner les télémètres.</translation>
    </message>
    <message>
        <source>Overdue: %1. Calibrate the range finders.</source>
        <translation>En retard : %1. Étalonner les télémètres.</translation>
    </message>
    <message numerus="yes">
        <source>Due in %n day(s).</source>
        <translation>
            <numerusform>À refaire dans %n jour.</numerusform>
            <numerusform>À refaire dans %n jours.</numerusform>
        </translation>
    </message>
    <message>
        <source>No interval is set.</source>
        <translation>Aucun intervalle n&apos;est fixé.</translation>
    </message>
    <message>
        <source>Method: %1
Made: %2
Plate: %3
Cameras: %4</source>
        <translation>Méthode : %1
Établi : %2
Plaque : %3
Caméras : %4</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>None is kept yet. The first is kept when a rail is measured or a wizard ends.</source>
        <translation>Aucun n&apos;est encore conservé. Le premier le sera quand un rail sera mesuré ou qu&apos;un assistant se terminera.</translation>
    </message>
    <message>
        <source>In force: %1</source>
        <translation>En vigueur : %1</translation>
    </message>
    <message>
        <source> (cannot be read)</source>
        <translation> (illisible)</translation>
    </message>
    <message>
        <source>of another rig</source>
        <translation>autre installation</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cote</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>Admis</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Différence</translation>
    </message>
    <message>
        <source>U of it</source>
        <translation>Son U</translation>
    </message>
    <message>
        <source>U (k = 2) in %1</source>
        <translation>U (k = 2) en %1</translation>
    </message>
    <message>
        <source>Difference: what the chosen one measures more than the one in force</source>
        <translation>Différence : ce que l&apos;étalonnage choisi mesure de plus que celui en vigueur</translation>
    </message>
    <message>
        <source>By the calibration alone, without the noise of the profiles</source>
        <translation>Par l&apos;étalonnage seul, sans le bruit des profils</translation>
    </message>
    <message>
        <source>%1, too much</source>
        <translation>%1, trop</translation>
    </message>
    <message>
        <source>none stated</source>
        <translation>non indiquée</translation>
    </message>
    <message>
        <source>Nothing is applied before old and new are compared.</source>
        <translation>Rien n&apos;est appliqué avant de comparer l&apos;ancien et le nouveau.</translation>
    </message>
    <message>
        <source>It is of other cameras and cannot be put in force here.</source>
        <translation>Il vient d&apos;autres caméras et ne peut être mis en vigueur ici.</translation>
    </message>
    <message>
        <source>It is in force.</source>
        <translation>Il est en vigueur.</translation>
    </message>
    <message>
        <source>It is in force: the line measures with it from the next rail on.</source>
        <translation>Il est en vigueur : la ligne mesure avec lui dès le prochain rail.</translation>
    </message>
</context>
<context>
    <name>vignole::ChartsPage</name>
    <message>
        <source>Dimensions</source>
        <translation>Cotes</translation>
    </message>
    <message>
        <source>Dimension that is charted</source>
        <translation>Cote représentée</translation>
    </message>
    <message>
        <source>Rail that is charted</source>
        <translation>Rail représenté</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Whole range</source>
        <translation>Étendue entière</translation>
    </message>
    <message>
        <source>Whole range (0)</source>
        <translation>Étendue entière (0)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Export the chart as picture, PDF or CSV</source>
        <translation>Exporter le graphique en image, PDF ou CSV</translation>
    </message>
    <message>
        <source>Dimension along the rail</source>
        <translation>Cote le long du rail</translation>
    </message>
    <message>
        <source>Dimension rail by rail</source>
        <translation>Cote rail par rail</translation>
    </message>
    <message>
        <source>Histogram of the rail</source>
        <translation>Histogramme du rail</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramme</translation>
    </message>
    <message>
        <source>same scale, this rail</source>
        <translation>même échelle, ce rail</translation>
    </message>
    <message>
        <source>Per rail</source>
        <translation>Par rail</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Chiffres</translation>
    </message>
    <message>
        <source>this rail</source>
        <translation>ce rail</translation>
    </message>
    <message>
        <source>Figures of the rail</source>
        <translation>Chiffres du rail</translation>
    </message>
    <message>
        <source>Rails are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>Les rails ne sont pas conservés : %1. Démarrer le programme avec une archive (--archive FILE).</translation>
    </message>
    <message>
        <source>No rail has been measured yet. Its chart appears here when it has passed.</source>
        <translation>Aucun rail mesuré. Son graphique apparaîtra ici après son passage.</translation>
    </message>
    <message>
        <source>Newest rail</source>
        <translation>Dernier rail</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>longueur, m</translation>
    </message>
    <message>
        <source>%1 along the rail</source>
        <translation>%1 le long du rail</translation>
    </message>
    <message>
        <source>rail %1, %2 profiles</source>
        <translation>rail %1, %2 profils</translation>
    </message>
    <message>
        <source>; no band: %1 of %2 other rails</source>
        <translation> ; pas de bande : %1 autres rails sur %2</translation>
    </message>
    <message>
        <source>; band: last %1 rails, 10 to 90 %</source>
        <translation> ; bande : %1 derniers rails, 10 à 90 %</translation>
    </message>
    <message>
        <source>same scale, longest bar %1 %</source>
        <translation>même échelle, barre la plus longue %1 %</translation>
    </message>
    <message>
        <source>rail</source>
        <translation>rail</translation>
    </message>
    <message numerus="yes">
        <source>mean with smallest and largest value, last %n rail(s) of this section</source>
        <translation>
            <numerusform>moyenne avec plus petite et plus grande valeur, dernier rail de cette section</numerusform>
            <numerusform>moyenne avec plus petite et plus grande valeur, %n derniers rails de cette section</numerusform>
        </translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Écart-type</translation>
    </message>
    <message>
        <source>Uncertainty U (k = 2)</source>
        <translation>Incertitude U (k = 2)</translation>
    </message>
    <message>
        <source>Beyond a limit</source>
        <translation>Au-delà d&apos;une limite</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>In the guard band</source>
        <translation>Dans la bande de garde</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Non mesuré</translation>
    </message>
    <message>
        <source>Room to the nearer limit</source>
        <translation>Marge à la limite la plus proche</translation>
    </message>
    <message>
        <source>Move over the chart or press Left and Right to read values; wheel or + and − zoom, drag moves.</source>
        <translation>Survoler le graphique ou presser gauche et droite pour lire les valeurs ; molette ou + et − zooment, glisser déplace.</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>not measured: %1</source>
        <translation>non mesuré : %1</translation>
    </message>
    <message>
        <source>%1   %2 %3   U ±%4   %5 from expected   %6</source>
        <translation>%1   %2 %3   U ±%4   %5 de l&apos;attendu   %6</translation>
    </message>
    <message>
        <source>Export the chart</source>
        <translation>Exporter le graphique</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 est écrit</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 ne peut être écrit</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Maximum</translation>
    </message>
</context>
<context>
    <name>vignole::ClosedStep</name>
    <message>
        <source>Closed while the line measures</source>
        <translation>Fermé tant que la ligne mesure</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Arrêter la ligne</translation>
    </message>
</context>
<context>
    <name>vignole::DiagnosticsPage</name>
    <message>
        <source>Pipeline</source>
        <translation>Chaîne de traitement</translation>
    </message>
    <message>
        <source>Every trigger accounted for</source>
        <translation>Chaque déclenchement compté</translation>
    </message>
    <message>
        <source>since the line was started</source>
        <translation>depuis le démarrage de la ligne</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Caméras</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Ordinateur</translation>
    </message>
    <message>
        <source>Where every trigger went</source>
        <translation>Où est allé chaque déclenchement</translation>
    </message>
    <message>
        <source>Counters of the cameras</source>
        <translation>Compteurs des caméras</translation>
    </message>
    <message>
        <source>Load of the computer</source>
        <translation>Charge de l&apos;ordinateur</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Frames/s</source>
        <translation>Images/s</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Manquantes</translation>
    </message>
    <message>
        <source>held, %1 old</source>
        <translation>figé, vieux de %1</translation>
    </message>
    <message>
        <source>%1 profiles/s of %2 expected</source>
        <translation>%1 profils/s sur %2 attendus</translation>
    </message>
    <message>
        <source>Triggers</source>
        <translation>Déclenchements</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesuré</translation>
    </message>
    <message>
        <source>Incomplete: measured by fewer cameras</source>
        <translation>Incomplets : mesurés par moins de caméras</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Perdus</translation>
    </message>
    <message>
        <source>Not accounted for</source>
        <translation>Non comptés</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>En cours</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Caméra %1</translation>
    </message>
    <message>
        <source>: lost</source>
        <translation> : perdue</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Disque</translation>
    </message>
    <message>
        <source>make room: nearly full</source>
        <translation>faire de la place : presque plein</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archive</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Processeur</translation>
    </message>
    <message>
        <source>%1 % of one core</source>
        <translation>%1 % d&apos;un cœur</translation>
    </message>
    <message numerus="yes">
        <source>%n core(s)</source>
        <translation>
            <numerusform>%n cœur</numerusform>
            <numerusform>%n cœurs</numerusform>
        </translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Mémoire</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 Mo</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Écran</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 est écrit.</translation>
    </message>
    <message>
        <source>How much of the support bundle is written</source>
        <translation>Part du fichier d&apos;assistance déjà écrite</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Exposition</translation>
    </message>
    <message>
        <source>%1 profiles lost</source>
        <translation>%1 profils perdus</translation>
    </message>
    <message>
        <source>%1 without points</source>
        <translation>%1 sans points</translation>
    </message>
    <message>
        <source>%1 profiles kept</source>
        <translation>%1 profils conservés</translation>
    </message>
    <message>
        <source>rails are not kept</source>
        <translation>rails non conservés</translation>
    </message>
    <message>
        <source>%1 pictures/s, %2 % of a core</source>
        <translation>%1 images/s, %2 % d&apos;un cœur</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Not available here, because these cameras are rendered: resends, incomplete frames, timeouts, temperature.</source>
        <translation>Non disponible ici, car ces caméras sont simulées : renvois, images incomplètes, délais dépassés, température.</translation>
    </message>
    <message>
        <source>%1 of %2 GB</source>
        <translation>%1 sur %2 Go</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>non indiqué</translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s) kept</source>
        <translation>
            <numerusform>%n rail conservé</numerusform>
            <numerusform>%n rails conservés</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 MB, WAL %2 MB</source>
        <translation>%1 Mo, WAL %2 Mo</translation>
    </message>
    <message>
        <source>open, nothing is written</source>
        <translation>ouverte, rien n&apos;est écrit</translation>
    </message>
    <message>
        <source>of %1 GB</source>
        <translation>sur %1 Go</translation>
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
        <translation>fenêtre</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Température</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Where the support bundle is put</source>
        <translation>Où placer le fichier d&apos;assistance</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Support bundle…</source>
        <translation>Assistance…</translation>
    </message>
    <message>
        <source>Cancel the support bundle</source>
        <translation>Annuler le fichier d&apos;assistance</translation>
    </message>
    <message>
        <source>Save a support bundle</source>
        <translation>Enregistrer un fichier d&apos;assistance</translation>
    </message>
</context>
<context>
    <name>vignole::DimensionModel</name>
    <message>
        <source>Not measured</source>
        <translation>Non mesuré</translation>
    </message>
    <message>
        <source>Not measured, because %1</source>
        <translation>Non mesuré, car : %1</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sans limite</translation>
    </message>
    <message>
        <source>limits %1 to %2</source>
        <translation>limites %1 à %2</translation>
    </message>
    <message>
        <source>waiting for a profile</source>
        <translation>attente d&apos;un profil</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cote</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Tolerance and guard band</source>
        <translation>Tolérance et bande de garde</translation>
    </message>
    <message>
        <source>Along the rail</source>
        <translation>Le long du rail</translation>
    </message>
    <message>
        <source>Not meas.</source>
        <translation>Non mesuré</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Figé</translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es) out of tolerance</source>
        <translation>
            <numerusform>%n tronçon hors tolérance</numerusform>
            <numerusform>%n tronçons hors tolérance</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 %3, deviation %4, U %5, %6</source>
        <translation>%1, %2 %3, écart %4, U %5, %6</translation>
    </message>
</context>
<context>
    <name>vignole::DimensionTable</name>
    <message>
        <source>Dimensions</source>
        <translation>Cotes</translation>
    </message>
</context>
<context>
    <name>vignole::DriftPanel</name>
    <message>
        <source>Health</source>
        <translation>Santé</translation>
    </message>
    <message>
        <source>seams between the cameras on every rail</source>
        <translation>jonctions entre les caméras sur chaque rail</translation>
    </message>
    <message>
        <source>Shift of each camera, rail by rail</source>
        <translation>Décalage de chaque caméra, rail par rail</translation>
    </message>
    <message>
        <source>Shift of each camera since its calibration</source>
        <translation>Décalage de chaque caméra depuis son étalonnage</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Alarm above</source>
        <translation>Alarme au-delà</translation>
    </message>
    <message>
        <source>No rail has passed yet. Camera drift shows in the seams of normal production, without a plate.</source>
        <translation>Aucun rail n&apos;est encore passé. La dérive des caméras se voit aux jonctions en production normale, sans plaque.</translation>
    </message>
    <message>
        <source>Learning what the seams are like: %1 of %2 rails since this calibration came into use.</source>
        <translation>Apprentissage des jonctions : %1 rails sur %2 depuis que cet étalonnage est en service.</translation>
    </message>
    <message numerus="yes">
        <source>No camera has moved: %n rail(s) watched.</source>
        <translation>
            <numerusform>Aucune caméra n&apos;a bougé : %n rail observé.</numerusform>
            <numerusform>Aucune caméra n&apos;a bougé : %n rails observés.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 moved</source>
        <translation>%1 déplacée</translation>
    </message>
    <message>
        <source>rail</source>
        <translation>rail</translation>
    </message>
    <message>
        <source>shift in </source>
        <translation>décalage en </translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>caméra %1</translation>
    </message>
    <message>
        <source>alarm above</source>
        <translation>alarme au-delà</translation>
    </message>
</context>
<context>
    <name>vignole::EncoderPanel</name>
    <message>
        <source>Encoder</source>
        <translation>Codeur</translation>
    </message>
    <message>
        <source>Motion a pulse</source>
        <translation>Avance/impulsion</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Lectures</translation>
    </message>
    <message>
        <source>Known length, first to last reading</source>
        <translation>Longueur connue, première à dernière lecture</translation>
    </message>
    <message>
        <source>Known length, mm</source>
        <translation>Longueur connue, mm</translation>
    </message>
    <message>
        <source>Its standard uncertainty</source>
        <translation>Son incertitude-type</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length, mm</source>
        <translation>Incertitude-type de la longueur, mm</translation>
    </message>
    <message>
        <source>Slip of the virtual second encoder, for training</source>
        <translation>Glissement du second codeur virtuel, pour s&apos;exercer</translation>
    </message>
    <message>
        <source>Slip of the virtual second encoder, ppm</source>
        <translation>Glissement du second codeur virtuel, ppm</translation>
    </message>
    <message>
        <source>Drive the rail</source>
        <translation>Déplacer le rail</translation>
    </message>
    <message>
        <source>Readings from a file…</source>
        <translation>Lectures d&apos;un fichier…</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Arrêter la ligne</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>Incertitude-type</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Comptage</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Second</translation>
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
        <translation>Lectures du codeur</translation>
    </message>
    <message>
        <source>Slip along the way</source>
        <translation>Glissement le long du trajet</translation>
    </message>
    <message>
        <source>Readings: count,x_mm,y_mm[,count2]</source>
        <translation>Lectures : count,x_mm,y_mm[,count2]</translation>
    </message>
    <message>
        <source>CSV (*.csv);;All files (*)</source>
        <translation>CSV (*.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Closed while the line measures: the rail is driven by hand over a known length. Stop the line to go on.</source>
        <translation>Fermé tant que la ligne mesure : le rail est déplacé à la main sur une longueur connue. Arrêter la ligne pour continuer.</translation>
    </message>
    <message>
        <source>A rail is driven over a length that is known, and the pulses are counted: where the light crosses it, it is seen as well.</source>
        <translation>Un rail est déplacé sur une longueur connue et les impulsions sont comptées : là où la lumière le coupe, il est vu aussi.</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>second behind first, pulses</source>
        <translation>retard du second, impulsions</translation>
    </message>
    <message>
        <source>Next: drive the rail over the known length.</source>
        <translation>Ensuite : déplacer le rail sur la longueur connue.</translation>
    </message>
    <message>
        <source> µm a pulse</source>
        <translation> µm/impulsion</translation>
    </message>
    <message>
        <source> µm</source>
        <translation> µm</translation>
    </message>
    <message>
        <source>unknown: fewer than three readings</source>
        <translation>inconnue : moins de trois lectures</translation>
    </message>
    <message>
        <source>Along (V z)</source>
        <translation>En long (V z)</translation>
    </message>
    <message>
        <source>Sideways (V x)</source>
        <translation>En travers (V x)</translation>
    </message>
    <message>
        <source>Upwards (V y)</source>
        <translation>En hauteur (V y)</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>Impulsions</translation>
    </message>
    <message>
        <source>Slip of the second</source>
        <translation>Glissement du second</translation>
    </message>
    <message>
        <source>One of the encoders slips. Next: clean the wheels, press them on and drive again.</source>
        <translation>L&apos;un des codeurs glisse. Ensuite : nettoyer les roues, les plaquer et recommencer.</translation>
    </message>
    <message>
        <source>One pulse is %1 µm of rail. Next: enter it where the encoder&apos;s pulses are divided into triggers.</source>
        <translation>Une impulsion vaut %1 µm de rail. Ensuite : saisir cette valeur là où les impulsions du codeur sont divisées en déclenchements.</translation>
    </message>
</context>
<context>
    <name>vignole::FramesDrawing</name>
    <message>
        <source>Frames: world on the light plane, camera, image</source>
        <translation>Repères : monde sur le plan de lumière, caméra, image</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Monde</translation>
    </message>
</context>
<context>
    <name>vignole::HeaderBar</name>
    <message>
        <source>Rail</source>
        <translation>Rail</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Coulée</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Recette</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Gauge</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>Thème clair</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>Thème sombre</translation>
    </message>
    <message>
        <source>Other theme (Ctrl+D)</source>
        <translation>Autre thème (Ctrl+D)</translation>
    </message>
    <message>
        <source>%1: sign in</source>
        <translation>%1 : se connecter</translation>
    </message>
    <message>
        <source>%1, %2: sign out</source>
        <translation>%1, %2 : se déconnecter</translation>
    </message>
    <message>
        <source>Sign in (Ctrl+L)</source>
        <translation>Se connecter (Ctrl+L)</translation>
    </message>
    <message>
        <source>%1: sign out (Ctrl+L)</source>
        <translation>%1 : se déconnecter (Ctrl+L)</translation>
    </message>
    <message>
        <source>Line: %1</source>
        <translation>Ligne : %1</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULATION</translation>
    </message>
    <message>
        <source>Simulation: the rails are not real</source>
        <translation>Simulation : les rails ne sont pas réels</translation>
    </message>
    <message>
        <source>The rails come from the virtual rig</source>
        <translation>Les rails viennent de l&apos;installation virtuelle</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
</context>
<context>
    <name>vignole::LastRails</name>
    <message>
        <source>Out</source>
        <translation>Hors tol.</translation>
    </message>
    <message>
        <source>, held</source>
        <translation>, figé</translation>
    </message>
    <message>
        <source>, now</source>
        <translation>, actuel</translation>
    </message>
    <message>
        <source>good %1 of %2</source>
        <translation>conf. %1 sur %2</translation>
    </message>
    <message>
        <source>Last rails: %1</source>
        <translation>Derniers rails : %1</translation>
    </message>
    <message>
        <source>Last rails</source>
        <translation>Derniers</translation>
    </message>
</context>
<context>
    <name>vignole::LensWizard</name>
    <message>
        <source>Cancelling…</source>
        <translation>Annulation…</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objectif</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Préparer</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Couverture</translation>
    </message>
    <message>
        <source>Parts of the picture that have been seen</source>
        <translation>Parties de l&apos;image qui ont été vues</translation>
    </message>
    <message>
        <source>Picture of the target</source>
        <translation>Image de la mire</translation>
    </message>
    <message>
        <source>Pictures taken</source>
        <translation>Images prises</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>Oblique</translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>Flou</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Calculer</translation>
    </message>
    <message>
        <source>Lens models (Table III)</source>
        <translation>Modèles d&apos;objectif (Tableau III)</translation>
    </message>
    <message>
        <source>Distortion model</source>
        <translation>Modèle de distorsion</translation>
    </message>
    <message>
        <source>Mean error px</source>
        <translation>Erreur moy. px</translation>
    </message>
    <message>
        <source>RMS px</source>
        <translation>RMS px</translation>
    </message>
    <message>
        <source>Not seen before px</source>
        <translation>Images non vues px</translation>
    </message>
    <message>
        <source>Focal length mm</source>
        <translation>Focale mm</translation>
    </message>
    <message>
        <source>Lens models that were tried</source>
        <translation>Modèles d&apos;objectif essayés</translation>
    </message>
    <message>
        <source>Coverage and residuals</source>
        <translation>Couverture et résidus</translation>
    </message>
    <message>
        <source>Points of all pictures</source>
        <translation>Points de toutes les images</translation>
    </message>
    <message>
        <source>Mean residual by place</source>
        <translation>Résidu moyen par endroit</translation>
    </message>
    <message>
        <source>The flat target with circles is held before one camera, in the pose that is drawn, picture by picture. The lens model is the simplest that predicts pictures it has not seen.
Target: %1, points within ±%2 µm.</source>
        <translation>La mire plane à cercles est tenue devant une caméra, image par image, dans la pose dessinée. Le modèle d&apos;objectif est le plus simple qui prédise des images qu&apos;il n&apos;a pas vues.
Mire : %1, points à ±%2 µm.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Camera whose lens is calibrated</source>
        <translation>Caméra dont l&apos;objectif est étalonné</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Caméra %1</translation>
    </message>
    <message>
        <source>Pictures: twelve cover a lens.</source>
        <translation>Images : douze couvrent un objectif.</translation>
    </message>
    <message>
        <source>Number of pictures</source>
        <translation>Nombre d&apos;images</translation>
    </message>
    <message>
        <source>Target to the right, mm</source>
        <translation>Mire vers la droite, mm</translation>
    </message>
    <message>
        <source>Target down, mm</source>
        <translation>Mire vers le bas, mm</translation>
    </message>
    <message>
        <source>Distance of the target, mm</source>
        <translation>Distance de la mire, mm</translation>
    </message>
    <message>
        <source>Tilt up and down, degrees</source>
        <translation>Inclinaison haut et bas, degrés</translation>
    </message>
    <message>
        <source>Tilt to the sides, degrees</source>
        <translation>Inclinaison sur les côtés, degrés</translation>
    </message>
    <message>
        <source>Turn of the target, degrees</source>
        <translation>Rotation de la mire, degrés</translation>
    </message>
    <message>
        <source>Hold as shown</source>
        <translation>Tenir ainsi</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Take picture</source>
        <translation>Prendre l&apos;image</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Use with the plate</source>
        <translation>Utiliser avec plaque</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>The camera is needed for the pictures of the target. Stop the line to go on; what has been taken so far is kept.</source>
        <translation>La caméra est nécessaire aux images de la mire. Arrêter la ligne pour continuer ; ce qui a été pris est conservé.</translation>
    </message>
    <message>
        <source>Progress of the solution</source>
        <translation>Progression du calcul</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Annulé : rien n&apos;a changé.</translation>
    </message>
    <message>
        <source>Lens of the camera</source>
        <translation>Objectif de la caméra</translation>
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
        <translation>Écrit : %1</translation>
    </message>
    <message>
        <source>camera and target</source>
        <translation>caméra et mire</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>model chosen by the data</source>
        <translation>modèle choisi par les données</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Table III, residuals</source>
        <translation>Tableau III, résidus</translation>
    </message>
    <message>
        <source>%1 % of the picture</source>
        <translation>%1 % de l&apos;image</translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>Aucune encore.</translation>
    </message>
    <message>
        <source>May be used, but: %1</source>
        <translation>Utilisable, mais : %1</translation>
    </message>
    <message>
        <source>May be used: mean error %1 px with the model %2, chosen by pictures it had not seen.</source>
        <translation>Utilisable : erreur moyenne %1 px avec le modèle %2, choisi sur des images qu&apos;il n&apos;avait pas vues.</translation>
    </message>
    <message>
        <source>%1, chosen</source>
        <translation>%1, choisi</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Next: choose the camera.</source>
        <translation>Ensuite : choisir la caméra.</translation>
    </message>
    <message>
        <source>First picture</source>
        <translation>Première image</translation>
    </message>
    <message>
        <source>Looking at the target…</source>
        <translation>Examen de la mire…</translation>
    </message>
    <message>
        <source>This picture would be refused: %1</source>
        <translation>Cette image serait refusée : %1</translation>
    </message>
    <message>
        <source>This picture would be refused, because it shows the pose of picture %1; move the target to the dashed outline.</source>
        <translation>Cette image serait refusée, car elle montre la pose de l&apos;image %1 ; déplacer la mire vers le contour en tirets.</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) found.</source>
        <translation>
            <numerusform>%n point trouvé.</numerusform>
            <numerusform>%n points trouvés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Next: solve, or take more.</source>
        <translation>Ensuite : calculer, ou en prendre d&apos;autres.</translation>
    </message>
    <message>
        <source>Working out which pose tells most…</source>
        <translation>Recherche de la pose la plus instructive…</translation>
    </message>
    <message numerus="yes">
        <source>Next: hold the target to the dashed outline and take the picture; %n to go.</source>
        <translation>
            <numerusform>Ensuite : tenir la mire sur le contour en tirets et prendre l&apos;image ; encore %n.</numerusform>
            <numerusform>Ensuite : tenir la mire sur le contour en tirets et prendre l&apos;image ; encore %n.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Next: %1; %n to go.</source>
        <translation>
            <numerusform>Ensuite : %1 ; encore %n.</numerusform>
            <numerusform>Ensuite : %1 ; encore %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>Lens models are adjusted and tried on pictures they have not seen.</source>
        <translation>Les modèles d&apos;objectif sont ajustés et essayés sur des images qu&apos;ils n&apos;ont pas vues.</translation>
    </message>
    <message>
        <source>Next: nothing to do; the result comes by itself.</source>
        <translation>Ensuite : rien à faire ; le résultat vient de lui-même.</translation>
    </message>
    <message>
        <source>Refused: it cannot be used.</source>
        <translation>Refusé : inutilisable.</translation>
    </message>
    <message>
        <source>The wizard of the range finders uses this lens. Next: calibrate the range finders.</source>
        <translation>L&apos;assistant des télémètres utilise cet objectif. Ensuite : étalonner les télémètres.</translation>
    </message>
    <message>
        <source>Next: use it with the plate, or save it.</source>
        <translation>Ensuite : l&apos;utiliser avec la plaque, ou l&apos;enregistrer.</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone. Start the program on the virtual rig.</source>
        <translation>Aucune installation n&apos;est disponible : les assistants ne voient que par l&apos;installation virtuelle. Démarrer le programme sur l&apos;installation virtuelle.</translation>
    </message>
</context>
<context>
    <name>vignole::MainWindow</name>
    <message>
        <source>Is this rail good?</source>
        <translation>Ce rail est-il bon ?</translation>
    </message>
    <message>
        <source>The large word is the verdict of the rail so far; beside it stands whether the gauge can be trusted. Both are made for two metres&apos; distance.</source>
        <translation>Le grand mot est le verdict du rail jusqu&apos;ici ; à côté, si l&apos;appareil est fiable. Les deux se lisent à deux mètres.</translation>
    </message>
    <message>
        <source>The measured profile</source>
        <translation>Le profil mesuré</translation>
    </message>
    <message>
        <source>The rail as it is measured, over its section; deviations are drawn twenty times larger. Keys 1 to 4 show whole, head, web and foot, + and − change the magnification, C colours by camera.</source>
        <translation>Le rail mesuré, sur sa section ; les écarts sont agrandis vingt fois. Les touches 1 à 4 montrent l&apos;ensemble, la tête, l&apos;âme et le patin ; + et − changent l&apos;agrandissement ; C colore par caméra.</translation>
    </message>
    <message>
        <source>Every dimension</source>
        <translation>Chaque cote</translation>
    </message>
    <message>
        <source>Value, deviation, uncertainty and where it lies in its tolerance; the hatched ends are closer to a limit than the uncertainty. Choose a row to see the dimension in the drawing.</source>
        <translation>Valeur, écart, incertitude et place dans la tolérance ; les bouts hachurés sont plus proches d&apos;une limite que l&apos;incertitude. Choisir une ligne pour voir la cote dans le dessin.</translation>
    </message>
    <message>
        <source>What runs</source>
        <translation>Ce qui tourne</translation>
    </message>
    <message>
        <source>The line, the rail and who is here. SIMULATION: without a site the rails come from a virtual rig, measured by the real engine.</source>
        <translation>La ligne, le rail et qui est là. SIMULATION : sans site, les rails viennent d&apos;une installation virtuelle, mesurés par le vrai moteur.</translation>
    </message>
    <message>
        <source>Ten pages</source>
        <translation>Dix pages</translation>
    </message>
    <message>
        <source>F1 to F10, in this order: rails that passed are on F4, alarms on F8, language, units and people on F10. Ctrl+R stops and starts the line.</source>
        <translation>F1 à F10, dans cet ordre : rails passés sur F4, alarmes sur F8, langue, unités et personnes sur F10. Ctrl+R arrête et démarre la ligne.</translation>
    </message>
    <message>
        <source>Close Vignole</source>
        <translation>Fermer Vignole</translation>
    </message>
    <message>
        <source>A rail is being measured.</source>
        <translation>Un rail est en cours de mesure.</translation>
    </message>
    <message>
        <source>What has been measured of it is kept; the rest would pass unmeasured.</source>
        <translation>Ce qui est mesuré est conservé ; le reste passerait sans mesure.</translation>
    </message>
    <message>
        <source>Close after this rail</source>
        <translation>Fermer après ce rail</translation>
    </message>
    <message>
        <source>Close now</source>
        <translation>Fermer maintenant</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Rester</translation>
    </message>
</context>
<context>
    <name>vignole::MonitorPage</name>
    <message>
        <source>Whole</source>
        <translation>Entier</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Tête</translation>
    </message>
    <message>
        <source>Web</source>
        <translation>Âme</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Patin</translation>
    </message>
    <message>
        <source>View: %1</source>
        <translation>Vue : %1</translation>
    </message>
    <message>
        <source>%1 of the section (%2)</source>
        <translation>%1, de la section (%2)</translation>
    </message>
    <message>
        <source>Magnify deviations less</source>
        <translation>Agrandir moins les écarts</translation>
    </message>
    <message>
        <source>Magnify deviations less (−)</source>
        <translation>Agrandir moins les écarts (−)</translation>
    </message>
    <message>
        <source>Deviations are drawn so many times larger (0: back to 20)</source>
        <translation>Les écarts sont dessinés autant de fois plus grands (0 : retour à 20)</translation>
    </message>
    <message>
        <source>Magnify deviations more</source>
        <translation>Agrandir plus les écarts</translation>
    </message>
    <message>
        <source>Magnify deviations more (+)</source>
        <translation>Agrandir plus les écarts (+)</translation>
    </message>
    <message>
        <source>By camera</source>
        <translation>Par caméra</translation>
    </message>
    <message>
        <source>Colour points by camera</source>
        <translation>Colorer les points par caméra</translation>
    </message>
    <message>
        <source>Colour points by camera (C)</source>
        <translation>Colorer les points par caméra (C)</translation>
    </message>
    <message>
        <source>Drawing in full view</source>
        <translation>Dessin en pleine vue</translation>
    </message>
    <message>
        <source>Drawing in full view (F11)</source>
        <translation>Dessin en pleine vue (F11)</translation>
    </message>
    <message>
        <source>Stop line</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Start line</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>%1 (Ctrl+R)</source>
        <translation>%1 (Ctrl+R)</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>sans valeur</translation>
    </message>
    <message>
        <source>Show the points before registration</source>
        <translation>Montrer les points avant le recalage</translation>
    </message>
    <message>
        <source>Show the points before registration (B)</source>
        <translation>Montrer les points avant le recalage (B)</translation>
    </message>
</context>
<context>
    <name>vignole::NextRailDialog</name>
    <message>
        <source>Next rail</source>
        <translation>Prochain rail</translation>
    </message>
    <message>
        <source>What is entered here goes with the next rail that begins. An empty field stays as the line has it.</source>
        <translation>Ce qui est saisi ici accompagne le prochain rail qui commence. Un champ vide reste comme la ligne l&apos;a.</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Rail</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Coulée</translation>
    </message>
    <message>
        <source>Strand</source>
        <translation>Ligne de coulée</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Temperature, °C</source>
        <translation>Température, °C</translation>
    </message>
    <message>
        <source>For the next rail</source>
        <translation>Pour le prochain rail</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Waits for the next rail.</source>
        <translation>Attend le prochain rail.</translation>
    </message>
    <message>
        <source>%1 waits for the next rail.</source>
        <translation>%1 attend le prochain rail.</translation>
    </message>
    <message>
        <source>The rail has begun with what was entered.</source>
        <translation>Le rail a commencé avec les données saisies.</translation>
    </message>
    <message>
        <source>The temperature is no number from %1 to %2 °C.</source>
        <translation>La température n&apos;est pas un nombre de %1 à %2 °C.</translation>
    </message>
    <message>
        <source>Nothing was entered: fill in at least one field.</source>
        <translation>Rien n&apos;a été saisi : remplir au moins un champ.</translation>
    </message>
    <message>
        <source>Nothing waits: the next rail is named by the line.</source>
        <translation>Rien n&apos;attend : le prochain rail est nommé par la ligne.</translation>
    </message>
</context>
<context>
    <name>vignole::PeoplePanel</name>
    <message>
        <source>People</source>
        <translation>Personnes</translation>
    </message>
    <message>
        <source>Names and roles are the administrator&apos;s: sign in as administrator to see and enter people.</source>
        <translation>Noms et rôles relèvent de l&apos;administrateur : se connecter comme administrateur pour voir et inscrire des personnes.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Last here</source>
        <translation>Dernière fois</translation>
    </message>
    <message>
        <source>People who may sign in</source>
        <translation>Personnes pouvant se connecter</translation>
    </message>
    <message>
        <source>Name of the new person</source>
        <translation>Nom de la nouvelle personne</translation>
    </message>
    <message>
        <source>First or new password</source>
        <translation>Premier ou nouveau mot de passe</translation>
    </message>
    <message>
        <source>First password of the new person</source>
        <translation>Premier mot de passe de la nouvelle personne</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Reason for entering the person</source>
        <translation>Motif de l&apos;inscription</translation>
    </message>
    <message>
        <source>Role of the new person</source>
        <translation>Rôle de la nouvelle personne</translation>
    </message>
    <message>
        <source>Enter a person</source>
        <translation>Inscrire une personne</translation>
    </message>
    <message>
        <source>Give a new password</source>
        <translation>Donner un nouveau mot de passe</translation>
    </message>
    <message>
        <source>Give the chosen person a new password</source>
        <translation>Donner un nouveau mot de passe à la personne choisie</translation>
    </message>
    <message>
        <source>Give this role</source>
        <translation>Donner ce rôle</translation>
    </message>
    <message>
        <source>Give the chosen person this role</source>
        <translation>Donner ce rôle à la personne choisie</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>fermé</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqué</translation>
    </message>
    <message>
        <source>chooses a password</source>
        <translation>choisit un mot de passe</translation>
    </message>
    <message>
        <source>open</source>
        <translation>ouverte</translation>
    </message>
    <message>
        <source>never</source>
        <translation>jamais</translation>
    </message>
    <message>
        <source>Open the account</source>
        <translation>Ouvrir le compte</translation>
    </message>
    <message>
        <source>Close the account</source>
        <translation>Fermer le compte</translation>
    </message>
    <message>
        <source>Open the account of the chosen person</source>
        <translation>Ouvrir le compte de la personne choisie</translation>
    </message>
    <message>
        <source>Close the account of the chosen person</source>
        <translation>Fermer le compte de la personne choisie</translation>
    </message>
    <message>
        <source>%1 is entered.</source>
        <translation>%1 est inscrit.</translation>
    </message>
    <message>
        <source>%1 has a new password and chooses another at the next sign-in.</source>
        <translation>%1 a un nouveau mot de passe et en choisira un autre à la prochaine connexion.</translation>
    </message>
    <message>
        <source>%1 is now %2.</source>
        <translation>%1 est maintenant %2.</translation>
    </message>
    <message>
        <source>The account of %1 is closed.</source>
        <translation>Le compte de %1 est fermé.</translation>
    </message>
    <message>
        <source>The account of %1 is open.</source>
        <translation>Le compte de %1 est ouvert.</translation>
    </message>
</context>
<context>
    <name>vignole::PipelinePanel</name>
    <message>
        <source>Pipeline: %1 triggers, %2 measured, %3 incomplete, %4 lost</source>
        <translation>Chaîne : %1 déclenchements, %2 mesurés, %3 incomplets, %4 perdus</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>sans données</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>SD %1   UCL %2</source>
        <translation>ET %1   LSC %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Acquisition</source>
        <translation>Acquisition</translation>
    </message>
    <message>
        <source>Line extraction</source>
        <translation>Extraction de ligne</translation>
    </message>
    <message>
        <source>2D to 3D</source>
        <translation>2D en 3D</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Caméra %1</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>registered</source>
        <translation>recalé</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>non recalé</translation>
    </message>
    <message numerus="yes">
        <source>%n dimension(s)</source>
        <translation>
            <numerusform>%n cote</numerusform>
            <numerusform>%n cotes</numerusform>
        </translation>
    </message>
    <message>
        <source>SD %1</source>
        <translation>ET %1</translation>
    </message>
    <message>
        <source>99 % UCL %1</source>
        <translation>99 % LSC %1</translation>
    </message>
    <message>
        <source>Consumers</source>
        <translation>Sorties</translation>
    </message>
    <message>
        <source>in the queue now</source>
        <translation>actuellement en file</translation>
    </message>
    <message>
        <source>highest fill, of how many places</source>
        <translation>remplissage maximal, sur combien de places</translation>
    </message>
    <message>
        <source>mean time, SD standard deviation, UCL upper limit of its 99 % confidence interval</source>
        <translation>temps moyen, ET écart-type, LSC limite supérieure de son intervalle de confiance à 99 %</translation>
    </message>
</context>
<context>
    <name>vignole::PlateView</name>
    <message>
        <source>no picture yet</source>
        <translation>pas encore d&apos;image</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusée</translation>
    </message>
    <message>
        <source>%1 of %2 pins</source>
        <translation>%1 pions sur %2</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>Caméra %1 : %2</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Caméra %1</translation>
    </message>
    <message>
        <source>no pin here</source>
        <translation>pas de pion ici</translation>
    </message>
    <message>
        <source>not found: %1</source>
        <translation>non trouvé : %1</translation>
    </message>
</context>
<context>
    <name>vignole::ProfileCanvas</name>
    <message>
        <source>Measured profile over the section</source>
        <translation>Profil mesuré sur la section</translation>
    </message>
    <message>
        <source>last profile at %1 m, %2 ago</source>
        <translation>dernier profil à %1 m, il y a %2</translation>
    </message>
</context>
<context>
    <name>vignole::QualityPage</name>
    <message>
        <source>Repeatability</source>
        <translation>Répétabilité</translation>
    </message>
    <message>
        <source>runs of the same rail</source>
        <translation>passages du même rail</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Passage</translation>
    </message>
    <message>
        <source>Length, m</source>
        <translation>Longueur, m</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesuré</translation>
    </message>
    <message>
        <source>Single profiles</source>
        <translation>Profils individuels</translation>
    </message>
    <message>
        <source>Means over 0.1 m</source>
        <translation>Moyennes sur 0,1 m</translation>
    </message>
    <message>
        <source>Means over 1 m</source>
        <translation>Moyennes sur 1 m</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>Ce qui est comparé</translation>
    </message>
    <message>
        <source>Compare the chosen runs</source>
        <translation>Comparer les passages choisis</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>as Fig. 9a</source>
        <translation>comme Fig. 9a</translation>
    </message>
    <message>
        <source>Range of the runs</source>
        <translation>Étendue des passages</translation>
    </message>
    <message>
        <source>Values of every run over the length</source>
        <translation>Valeurs de chaque passage sur la longueur</translation>
    </message>
    <message>
        <source>reading …</source>
        <translation>lecture …</translation>
    </message>
    <message>
        <source>No rail has been kept yet. Runs of the same rail are compared here.</source>
        <translation>Aucun rail conservé. Les passages du même rail se comparent ici.</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>longueur, m</translation>
    </message>
    <message>
        <source>range</source>
        <translation>étendue</translation>
    </message>
    <message>
        <source>range, %1</source>
        <translation>étendue, %1</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Exporter en CSV</translation>
    </message>
    <message>
        <source>truth of the virtual rig</source>
        <translation>vérité de l&apos;installation virtuelle</translation>
    </message>
    <message numerus="yes">
        <source>The inspections were cancelled; %n were whole.</source>
        <translation>
            <numerusform>Les inspections ont été annulées ; %n était complète.</numerusform>
            <numerusform>Les inspections ont été annulées ; %n étaient complètes.</numerusform>
        </translation>
    </message>
    <message>
        <source>Runs of one rail</source>
        <translation>Passages d&apos;un rail</translation>
    </message>
    <message>
        <source>Reference values</source>
        <translation>Valeurs de référence</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Rapport en PDF</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Exactitude</translation>
    </message>
    <message>
        <source>Rails of the archive</source>
        <translation>Rails de l&apos;archive</translation>
    </message>
    <message>
        <source>Runs from a file</source>
        <translation>Passages d&apos;un fichier</translation>
    </message>
    <message>
        <source>Virtual rig</source>
        <translation>Inst. virtuelle</translation>
    </message>
    <message>
        <source>Where the runs come from</source>
        <translation>D&apos;où viennent les passages</translation>
    </message>
    <message>
        <source>3 m of rail</source>
        <translation>3 m de rail</translation>
    </message>
    <message>
        <source>12 m of rail</source>
        <translation>12 m de rail</translation>
    </message>
    <message>
        <source>60 m of rail, as the paper</source>
        <translation>60 m de rail, comme l&apos;article</translation>
    </message>
    <message>
        <source>Length of the virtual rail</source>
        <translation>Longueur du rail virtuel</translation>
    </message>
    <message>
        <source>Means over 0.5 m</source>
        <translation>Moyennes sur 0,5 m</translation>
    </message>
    <message>
        <source>Runs that may be laid over each other</source>
        <translation>Passages qui peuvent être superposés</translation>
    </message>
    <message>
        <source>Open runs…</source>
        <translation>Passages…</translation>
    </message>
    <message>
        <source>Open runs from a CSV file</source>
        <translation>Ouvrir des passages d&apos;un fichier CSV</translation>
    </message>
    <message>
        <source>Open reference…</source>
        <translation>Référence…</translation>
    </message>
    <message>
        <source>Open reference values from a CSV file</source>
        <translation>Ouvrir des valeurs de référence d&apos;un fichier CSV</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Report as PDF (Ctrl+P)</source>
        <translation>Rapport en PDF (Ctrl+P)</translation>
    </message>
    <message>
        <source>Export values as CSV</source>
        <translation>Exporter les valeurs en CSV</translation>
    </message>
    <message>
        <source>Export values as CSV (Ctrl+E)</source>
        <translation>Exporter les valeurs en CSV (Ctrl+E)</translation>
    </message>
    <message>
        <source>Progress of the inspections</source>
        <translation>Progression des inspections</translation>
    </message>
    <message>
        <source>What the runs differ by over the length</source>
        <translation>En quoi les passages diffèrent sur la longueur</translation>
    </message>
    <message>
        <source>Every dimension; the chosen one is drawn</source>
        <translation>Chaque cote ; celle choisie est dessinée</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Figures of the chosen dimension, formulas and constants</source>
        <translation>Chiffres de la cote choisie, formules et constantes</translation>
    </message>
    <message>
        <source>Stored runs come from the archive, and there is none (%1): start the program with --archive FILE, or choose a file or the virtual rig above.</source>
        <translation>Les passages conservés viennent de l&apos;archive, et il n&apos;y en a pas (%1) : démarrer le programme avec --archive FILE, ou choisir ci-dessus un fichier ou l&apos;installation virtuelle.</translation>
    </message>
    <message>
        <source>virtual rig</source>
        <translation>installation virtuelle</translation>
    </message>
    <message>
        <source>run %1</source>
        <translation>passage %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Inspect the rail five times</source>
        <translation>Inspecter le rail cinq fois</translation>
    </message>
    <message>
        <source>Cancel the inspections</source>
        <translation>Annuler les inspections</translation>
    </message>
    <message>
        <source>Inspect the same virtual rail five times</source>
        <translation>Inspecter cinq fois le même rail virtuel</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R)</source>
        <translation>Arrêter d&apos;abord la ligne (Ctrl+R)</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R): both need all processors, and no trigger may be lost to a study.</source>
        <translation>Arrêter d&apos;abord la ligne (Ctrl+R) : les deux exigent tous les processeurs, et aucun déclenchement ne doit être perdu pour une étude.</translation>
    </message>
    <message>
        <source>Accuracy needs a reference: open a CSV with the columns dimension, position_m, value and, if known, u.</source>
        <translation>L&apos;exactitude exige une référence : ouvrir un fichier CSV avec les colonnes dimension, position_m, value et, si elle est connue, u.</translation>
    </message>
    <message>
        <source>At least 1 run is needed, none is chosen.</source>
        <translation>Il faut au moins 1 passage, aucun n&apos;est choisi.</translation>
    </message>
    <message>
        <source>At least 2 runs of the same rail are needed, %1 chosen: choose %2 more. The paper took 5.</source>
        <translation>Il faut au moins 2 passages du même rail (choisis : %1) : en choisir encore %2. L&apos;article en a pris 5.</translation>
    </message>
    <message>
        <source>stored rails, same rail and gauge</source>
        <translation>rails conservés, même rail et même appareil</translation>
    </message>
    <message>
        <source>file %1</source>
        <translation>fichier %1</translation>
    </message>
    <message>
        <source>virtual rig, exact calibration, other wander, vibration, scale, speckle and noise in every run</source>
        <translation>installation virtuelle, étalonnage exact, flottement, vibration, calamine, speckle et bruit différents à chaque passage</translation>
    </message>
    <message>
        <source>The same rail is inspected five times …</source>
        <translation>Le même rail est inspecté cinq fois …</translation>
    </message>
    <message>
        <source>Conditions: %1.</source>
        <translation>Conditions : %1.</translation>
    </message>
    <message>
        <source>Tick the runs that were made of the same rail and compare.</source>
        <translation>Cocher les passages du même rail et comparer.</translation>
    </message>
    <message>
        <source>A CSV with the columns run, position_m and dimensions, as inspect --csv writes it.</source>
        <translation>Un fichier CSV avec les colonnes run, position_m et les cotes, comme l&apos;écrit inspect --csv.</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R): both need all processors.</source>
        <translation>Arrêter d&apos;abord la ligne (Ctrl+R) : les deux exigent tous les processeurs.</translation>
    </message>
    <message>
        <source>The paper&apos;s experiment: one rail, five inspections, the truth known.</source>
        <translation>L&apos;expérience de l&apos;article : un rail, cinq inspections, la vérité connue.</translation>
    </message>
    <message>
        <source>No runs are compared yet</source>
        <translation>Aucun passage comparé</translation>
    </message>
    <message>
        <source>%1 over the length</source>
        <translation>%1 sur la longueur</translation>
    </message>
    <message>
        <source>largest minus smallest at each position, as Fig. 9b</source>
        <translation>le plus grand moins le plus petit à chaque position, comme Fig. 9b</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>attendu</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>limite inférieure</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>limite supérieure</translation>
    </message>
    <message>
        <source>mean of %1 m</source>
        <translation>moyenne sur %1 m</translation>
    </message>
    <message>
        <source>Error of %1 over the length</source>
        <translation>Erreur sur la longueur : %1</translation>
    </message>
    <message>
        <source>value minus reference, mean of the runs; %1</source>
        <translation>valeur moins référence, moyenne des passages ; %1</translation>
    </message>
    <message>
        <source>value minus reference</source>
        <translation>valeur moins référence</translation>
    </message>
    <message>
        <source>Largest error at each position</source>
        <translation>Erreur maximale à chaque position</translation>
    </message>
    <message>
        <source>of any run</source>
        <translation>d&apos;un passage</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>maximum</translation>
    </message>
    <message>
        <source>no error</source>
        <translation>sans erreur</translation>
    </message>
    <message>
        <source>limit of agreement</source>
        <translation>limite de concordance</translation>
    </message>
    <message>
        <source>error, %1</source>
        <translation>erreur, %1</translation>
    </message>
    <message>
        <source>Dim.</source>
        <translation>Cote</translation>
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
        <translation>Étendue moyenne par %1 m</translation>
    </message>
    <message>
        <source>as Table VI</source>
        <translation>comme Tabl. VI</translation>
    </message>
    <message>
        <source>%1, as Table VI; the stretches are in the report</source>
        <translation>%1, comme Tableau VI ; les tronçons sont dans le rapport</translation>
    </message>
    <message>
        <source>%1, as Table VI</source>
        <translation>%1, comme Tabl. VI</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>biais</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Erreurs</translation>
    </message>
    <message>
        <source>%1, as Table V</source>
        <translation>%1, comme Tabl. V</translation>
    </message>
    <message>
        <source>as Table V</source>
        <translation>comme Tabl. V</translation>
    </message>
    <message>
        <source>Verdict, figures, formulas and constants stand here when runs are compared.</source>
        <translation>Verdict, chiffres, formules et constantes s&apos;affichent ici quand des passages sont comparés.</translation>
    </message>
    <message>
        <source>figures of %1</source>
        <translation>chiffres : %1</translation>
    </message>
    <message>
        <source>writing …</source>
        <translation>écriture …</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 est écrit.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 ne peut être écrit.</translation>
    </message>
</context>
<context>
    <name>vignole::RailBand</name>
    <message>
        <source>Place along the rail</source>
        <translation>Endroit le long du rail</translation>
    </message>
</context>
<context>
    <name>vignole::RailsPage</name>
    <message>
        <source>Rails</source>
        <translation>Rails</translation>
    </message>
    <message>
        <source>Rail or heat, from its beginning</source>
        <translation>Rail ou coulée, par le début</translation>
    </message>
    <message>
        <source>Search by rail or heat</source>
        <translation>Chercher par rail ou coulée</translation>
    </message>
    <message>
        <source>Any verdict</source>
        <translation>Tout verdict</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>Hors tolérance</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>Proche limite</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Conforme</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Non mesuré</translation>
    </message>
    <message>
        <source>Any dimension</source>
        <translation>Toute cote</translation>
    </message>
    <message>
        <source>%1 out</source>
        <translation>%1 hors tol.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Dimension out of tolerance</source>
        <translation>Cote hors tolérance</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Rail</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Coulée</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Pire</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Rails found</source>
        <translation>Rails trouvés</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Rapport en PDF</translation>
    </message>
    <message>
        <source>Report as PDF (Ctrl+P)</source>
        <translation>Rapport en PDF (Ctrl+P)</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Retour au direct</translation>
    </message>
    <message>
        <source>Along the rail</source>
        <translation>Le long du rail</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>Dépassements</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cote</translation>
    </message>
    <message>
        <source>From – to, m</source>
        <translation>De – à, m</translation>
    </message>
    <message>
        <source>Worst, mm</source>
        <translation>Pire, mm</translation>
    </message>
    <message>
        <source>Limits, mm</source>
        <translation>Limites, mm</translation>
    </message>
    <message>
        <source>Stretches out of tolerance</source>
        <translation>Tronçons hors tolérance</translation>
    </message>
    <message>
        <source>Previous exception</source>
        <translation>Dépassement précédent</translation>
    </message>
    <message>
        <source>Previous exception (Shift+N)</source>
        <translation>Dépassement précédent (Maj+N)</translation>
    </message>
    <message>
        <source>Next exception</source>
        <translation>Dépassement suivant</translation>
    </message>
    <message>
        <source>Next exception (N)</source>
        <translation>Dépassement suivant (N)</translation>
    </message>
    <message>
        <source>Play along the rail</source>
        <translation>Lire le long du rail</translation>
    </message>
    <message>
        <source>Play or pause (P)</source>
        <translation>Lecture ou pause (P)</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>No rail is open</source>
        <translation>Aucun rail ouvert</translation>
    </message>
    <message>
        <source>Choose a rail in the list: its profile, its dimensions along the rail and its exceptions are shown here.</source>
        <translation>Choisir un rail dans la liste : son profil, ses cotes le long du rail et ses dépassements s&apos;affichent ici.</translation>
    </message>
    <message>
        <source>Rails are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>Les rails ne sont pas conservés : %1. Démarrer le programme avec une archive (--archive FILE).</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>No rail is like that. Clear the search or choose other filters.</source>
        <translation>Aucun rail ne correspond. Effacer la recherche ou choisir d&apos;autres filtres.</translation>
    </message>
    <message>
        <source>No rail has been measured yet. Rails appear here when they have passed.</source>
        <translation>Aucun rail mesuré. Les rails apparaissent ici après leur passage.</translation>
    </message>
    <message>
        <source>Replay: not live.  Rail %1, %2 to %3, recipe %4, calibration %5</source>
        <translation>Relecture : pas en direct.  Rail %1, %2 à %3, recette %4, étalonnage %5</translation>
    </message>
    <message>
        <source>none: every dimension stayed within its limits</source>
        <translation>aucun : toutes les cotes dans leurs limites</translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es)</source>
        <translation>
            <numerusform>%n tronçon</numerusform>
            <numerusform>%n tronçons</numerusform>
        </translation>
    </message>
    <message>
        <source>The profile cannot be drawn: %1.</source>
        <translation>Le profil ne peut être dessiné : %1.</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Profile at %1 m</source>
        <translation>Profil à %1 m</translation>
    </message>
    <message>
        <source>no. %1 of %2</source>
        <translation>n° %1 sur %2</translation>
    </message>
    <message>
        <source>: points were not kept of this rail, the model is shown</source>
        <translation> : points non conservés pour ce rail, le modèle est montré</translation>
    </message>
    <message>
        <source>; drawn is no. %1, the nearest whose points were kept</source>
        <translation> ; dessiné le n° %1, le plus proche dont les points sont conservés</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>sans valeur</translation>
    </message>
    <message>
        <source>writing %1 …</source>
        <translation>écriture de %1 …</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 est écrit</translation>
    </message>
    <message>
        <source>Any time</source>
        <translation>Toute date</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Aujourd&apos;hui</translation>
    </message>
    <message>
        <source>7 days</source>
        <translation>7 jours</translation>
    </message>
    <message>
        <source>4 weeks</source>
        <translation>4 semaines</translation>
    </message>
    <message>
        <source>12 months</source>
        <translation>12 mois</translation>
    </message>
    <message>
        <source>Any section</source>
        <translation>Toute section</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Clear search and filters</source>
        <translation>Effacer recherche et filtres</translation>
    </message>
    <message>
        <source>What if…</source>
        <translation>Et si…</translation>
    </message>
    <message>
        <source>Judge the rails found with other limits</source>
        <translation>Juger les rails trouvés avec d&apos;autres limites</translation>
    </message>
    <message>
        <source>Next rail…</source>
        <translation>Prochain rail…</translation>
    </message>
    <message>
        <source>Enter the papers of the next rail</source>
        <translation>Saisir les données du prochain rail</translation>
    </message>
    <message>
        <source>Export as CSV or JSON</source>
        <translation>Exporter en CSV ou JSON</translation>
    </message>
    <message>
        <source>Export as CSV or JSON (Ctrl+E)</source>
        <translation>Exporter en CSV ou JSON (Ctrl+E)</translation>
    </message>
    <message>
        <source>Nothing new is kept: nobody writes into this archive.</source>
        <translation>Rien de nouveau n&apos;est conservé : personne n&apos;écrit dans cette archive.</translation>
    </message>
    <message>
        <source>Nothing is kept. Live rails are shown on Monitor only.</source>
        <translation>Rien n&apos;est conservé. Les rails en direct ne sont que sur Moniteur.</translation>
    </message>
    <message>
        <source>; %1 profiles lost</source>
        <translation> ; %1 profils perdus</translation>
    </message>
    <message>
        <source>; points of %1 profiles left out</source>
        <translation> ; points de %1 profils omis</translation>
    </message>
    <message>
        <source>Nothing can be written: %1. What passes waits in memory.</source>
        <translation>Impossible d&apos;écrire : %1. Ce qui passe attend en mémoire.</translation>
    </message>
    <message>
        <source>kept since the start: %1 rails; %2 profiles wait</source>
        <translation>conservés depuis le démarrage : %1 rails ; %2 profils attendent</translation>
    </message>
    <message>
        <source>nearest to a limit, inside</source>
        <translation>le plus proche d&apos;une limite, à l&apos;intérieur</translation>
    </message>
    <message>
        <source>furthest beyond a limit, mm</source>
        <translation>le plus loin au-delà d&apos;une limite, mm</translation>
    </message>
    <message>
        <source>Dimension that is drawn</source>
        <translation>Dimension dessinée</translation>
    </message>
    <message>
        <source>Show the points before registration</source>
        <translation>Montrer les points avant le recalage</translation>
    </message>
</context>
<context>
    <name>vignole::RateChart</name>
    <message>
        <source>Alarms in each ten minutes of the last %1 hours: at most %2</source>
        <translation>Alarmes par dix minutes des %1 dernières heures : au plus %2</translation>
    </message>
    <message>
        <source>flood above %1</source>
        <translation>avalanche au-delà de %1</translation>
    </message>
    <message>
        <source>hours; dotted at %1: target</source>
        <translation>heures ; pointillé à %1 : cible</translation>
    </message>
</context>
<context>
    <name>vignole::RecipesPage</name>
    <message>
        <source>Draft</source>
        <translation>Brouillon</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>Approuvée</translation>
    </message>
    <message>
        <source>Retired</source>
        <translation>Retirée</translation>
    </message>
    <message>
        <source>With the program</source>
        <translation>Avec le programme</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recettes</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Recette</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Recipes and their versions</source>
        <translation>Recettes et leurs versions</translation>
    </message>
    <message>
        <source>Section of the new recipe</source>
        <translation>Section de la nouvelle recette</translation>
    </message>
    <message>
        <source>Profile and straightness class of the new recipe</source>
        <translation>Classe de profil et de rectitude de la nouvelle recette</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouvelle</translation>
    </message>
    <message>
        <source>New draft from section and class</source>
        <translation>Nouveau brouillon d&apos;après section et classe</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importer…</translation>
    </message>
    <message>
        <source>Import a recipe file as a draft</source>
        <translation>Importer un fichier de recette comme brouillon</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Export the chosen recipe</source>
        <translation>Exporter la recette choisie</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cote</translation>
    </message>
    <message>
        <source>Nominal, mm</source>
        <translation>Nominal, mm</translation>
    </message>
    <message>
        <source>Lower, mm</source>
        <translation>Inférieure, mm</translation>
    </message>
    <message>
        <source>Upper, mm</source>
        <translation>Supérieure, mm</translation>
    </message>
    <message>
        <source>Tolerances of the chosen recipe</source>
        <translation>Tolérances de la recette choisie</translation>
    </message>
    <message>
        <source>What is new in it</source>
        <translation>Ce qu&apos;il y a de nouveau</translation>
    </message>
    <message>
        <source>What is new in the draft</source>
        <translation>Ce qu&apos;il y a de nouveau dans le brouillon</translation>
    </message>
    <message>
        <source>Save as a new draft</source>
        <translation>Enregistrer comme nouveau brouillon</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Différence</translation>
    </message>
    <message>
        <source>Recipe to compare with</source>
        <translation>Recette à comparer</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>There</source>
        <translation>Là</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Ici</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Ce qui diffère</translation>
    </message>
    <message>
        <source>Approval</source>
        <translation>Approbation</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Reason for the approval</source>
        <translation>Motif de l&apos;approbation</translation>
    </message>
    <message>
        <source>Your password</source>
        <translation>Votre mot de passe</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Approuver</translation>
    </message>
    <message>
        <source>Approve the draft</source>
        <translation>Approuver le brouillon</translation>
    </message>
    <message>
        <source>against %1 v%2, %3</source>
        <translation>contre %1 v%2, %3</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolérances</translation>
    </message>
    <message>
        <source>%1 v%2</source>
        <translation>%1 v%2</translation>
    </message>
    <message>
        <source>%1, by %2</source>
        <translation>%1, par %2</translation>
    </message>
    <message>
        <source>Both are the same.</source>
        <translation>Les deux sont identiques.</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n valeur</numerusform>
            <numerusform>%n valeurs</numerusform>
        </translation>
    </message>
    <message>
        <source>Only a draft is approved.</source>
        <translation>Seul un brouillon s&apos;approuve.</translation>
    </message>
    <message>
        <source>QA approves: sign in.</source>
        <translation>La qualité approuve : se connecter.</translation>
    </message>
    <message>
        <source>This draft is yours: somebody else approves it.</source>
        <translation>Ce brouillon est le vôtre : quelqu&apos;un d&apos;autre l&apos;approuve.</translation>
    </message>
    <message>
        <source>Approval retires the version before; reason and password go with your name into the audit trail.</source>
        <translation>L&apos;approbation retire la version précédente ; motif et nom vont dans la piste d&apos;audit, confirmés par le mot de passe.</translation>
    </message>
    <message>
        <source>%1 v%2 is kept as a draft.</source>
        <translation>%1 v%2 est conservée comme brouillon.</translation>
    </message>
    <message>
        <source>%1: the lower limit lies above the upper one; exchange them.</source>
        <translation>%1 : la limite inférieure est au-dessus de la supérieure ; les échanger.</translation>
    </message>
    <message>
        <source>%1: a limit is a number in mm, or empty for none.</source>
        <translation>%1 : une limite est un nombre en mm, ou vide s&apos;il n&apos;y en a pas.</translation>
    </message>
    <message>
        <source>Say what is new in the draft.</source>
        <translation>Dire ce qu&apos;il y a de nouveau dans le brouillon.</translation>
    </message>
    <message>
        <source>Approved.</source>
        <translation>Approuvée.</translation>
    </message>
    <message>
        <source>Import a recipe file</source>
        <translation>Importer un fichier de recette</translation>
    </message>
    <message>
        <source>Export the recipe</source>
        <translation>Exporter la recette</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 est écrit</translation>
    </message>
    <message>
        <source>Section…</source>
        <translation>Section…</translation>
    </message>
    <message>
        <source>Draw the section, or bring one along from a drawing</source>
        <translation>Dessiner la section, ou l&apos;apporter depuis un plan</translation>
    </message>
    <message>
        <source>What if…</source>
        <translation>Et si…</translation>
    </message>
    <message>
        <source>Judge stored rails by the chosen recipe</source>
        <translation>Juger les rails conservés selon la recette choisie</translation>
    </message>
    <message>
        <source>Use for the next rail</source>
        <translation>Pour le prochain rail</translation>
    </message>
    <message>
        <source>Use the chosen recipe for the next rail</source>
        <translation>Utiliser la recette choisie pour le prochain rail</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Parameters of dimensions and settings of the stages</source>
        <translation>Paramètres des cotes et réglages des étapes</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Settings of the chosen recipe</source>
        <translation>Réglages de la recette choisie</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Name of the draft; another name makes a copy</source>
        <translation>Nom du brouillon ; un autre nom en fait une copie</translation>
    </message>
    <message>
        <source>On the line: %1 v%2.</source>
        <translation>Sur la ligne : %1 v%2.</translation>
    </message>
    <message>
        <source>From the next rail: %1.</source>
        <translation>Dès le prochain rail : %1.</translation>
    </message>
    <message>
        <source>Only an approved recipe is measured with.</source>
        <translation>On ne mesure qu&apos;avec une recette approuvée.</translation>
    </message>
    <message>
        <source>%1: the value is not of its kind.</source>
        <translation>%1 : la valeur n&apos;est pas du bon type.</translation>
    </message>
    <message>
        <source>%1 v%2 is in force from the next rail; the rail in the gauge keeps what it began with.</source>
        <translation>%1 v%2 est en vigueur dès le prochain rail ; le rail dans l&apos;appareil garde ce avec quoi il a commencé.</translation>
    </message>
    <message>
        <source>What if needs at least %1 stored rails of section %2, there are %3: measure more first.</source>
        <translation>« Et si » exige au moins %1 rails conservés de la section %2, il y en a %3 : en mesurer d&apos;abord d&apos;autres.</translation>
    </message>
    <message>
        <source>Recipes are read, drafts cannot be kept: %1.</source>
        <translation>Les recettes sont lues, les brouillons ne peuvent pas être conservés : %1.</translation>
    </message>
</context>
<context>
    <name>vignole::ReferencePanel</name>
    <message>
        <source>Reference piece</source>
        <translation>Pièce de référence</translation>
    </message>
    <message>
        <source>Certificate and gauge</source>
        <translation>Certificat et appareil</translation>
    </message>
    <message>
        <source>Profiles that are averaged</source>
        <translation>Profils moyennés</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Progression du contrôle</translation>
    </message>
    <message>
        <source>Measure the piece</source>
        <translation>Mesurer la pièce</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Arrêter la ligne</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Annulé : rien n&apos;a changé.</translation>
    </message>
    <message>
        <source>Closed while the line measures: the piece stands where the rail passes. Stop the line to go on.</source>
        <translation>Fermé tant que la ligne mesure : la pièce est là où passe le rail. Arrêter la ligne pour continuer.</translation>
    </message>
    <message>
        <source>A section with a certificate is put into the gauge and measured with the calibration in force. On the virtual rig it is a virtual piece, whose truth is its certificate (U = 2 µm).</source>
        <translation>Une section avec certificat est placée dans l&apos;appareil et mesurée avec l&apos;étalonnage en vigueur. Sur l&apos;installation virtuelle, c&apos;est une pièce virtuelle dont la vérité est le certificat (U = 2 µm).</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Mesure…</translation>
    </message>
    <message>
        <source>Next: measure the piece.</source>
        <translation>Ensuite : mesurer la pièce.</translation>
    </message>
    <message numerus="yes">
        <source>The gauge agrees with the certificate in every dimension, over %n profile(s).</source>
        <translation>
            <numerusform>L&apos;appareil concorde avec le certificat pour chaque cote, sur %n profil.</numerusform>
            <numerusform>L&apos;appareil concorde avec le certificat pour chaque cote, sur %n profils.</numerusform>
        </translation>
    </message>
    <message>
        <source>The gauge does not agree with the certificate. Next: clean the piece and measure again; if it stays so, calibrate the range finders.</source>
        <translation>L&apos;appareil ne concorde pas avec le certificat. Ensuite : nettoyer la pièce et mesurer à nouveau ; si cela persiste, étalonner les télémètres.</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cote</translation>
    </message>
    <message>
        <source>Certificate %1</source>
        <translation>Certificat %1</translation>
    </message>
    <message>
        <source>Measured %1</source>
        <translation>Mesuré %1</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Deviation over U</source>
        <translation>Écart sur U</translation>
    </message>
    <message>
        <source>%1, differs</source>
        <translation>%1, diffère</translation>
    </message>
    <message>
        <source>not measured: %1</source>
        <translation>non mesuré : %1</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone.</source>
        <translation>Aucune installation n&apos;est disponible : les assistants ne voient que par l&apos;installation virtuelle.</translation>
    </message>
</context>
<context>
    <name>vignole::ReplayCanvas</name>
    <message>
        <source>Profile of the stored rail</source>
        <translation>Profil du rail conservé</translation>
    </message>
</context>
<context>
    <name>vignole::RigDrawing</name>
    <message>
        <source>The rig as it is calibrated</source>
        <translation>L’installation telle qu’elle est étalonnée</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Caméra %1</translation>
    </message>
    <message>
        <source>Along the rail: fields of view on the light plane, distances</source>
        <translation>Le long du rail : champs de vue sur le plan de lumière, distances</translation>
    </message>
    <message>
        <source>From the side: angles out of the light plane</source>
        <translation>De côté : angles hors du plan de lumière</translation>
    </message>
</context>
<context>
    <name>vignole::RigWizard</name>
    <message>
        <source>Cancelling…</source>
        <translation>Annulation…</translation>
    </message>
    <message>
        <source>Range finders</source>
        <translation>Télémètres</translation>
    </message>
    <message>
        <source>What it means</source>
        <translation>Signification</translation>
    </message>
    <message>
        <source>Fit to the pins</source>
        <translation>Ajustement aux pions</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Préparer</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Calculer</translation>
    </message>
    <message>
        <source>Pins found (Fig. 8d)</source>
        <translation>Pions trouvés (Fig. 8d)</translation>
    </message>
    <message>
        <source>circles: the pins as found; points: the lines of the first placement</source>
        <translation>cercles : pions tels que trouvés ; points : lignes de la première position</translation>
    </message>
    <message>
        <source>Pins in the world</source>
        <translation>Pions dans l&apos;espace</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Contrôles</translation>
    </message>
    <message>
        <source>Put in force</source>
        <translation>Mise en vigueur</translation>
    </message>
    <message>
        <source>How often the plate is put down: four find an error of the plate as well.</source>
        <translation>Combien de fois la plaque est posée : quatre révèlent aussi une erreur de la plaque.</translation>
    </message>
    <message>
        <source>Number of placements</source>
        <translation>Nombre de positions</translation>
    </message>
    <message>
        <source>The virtual plate, for training</source>
        <translation>La plaque virtuelle, pour s&apos;exercer</translation>
    </message>
    <message>
        <source>is as its certificate says</source>
        <translation>est conforme à son certificat</translation>
    </message>
    <message>
        <source>is the mirror image of its file</source>
        <translation>est l&apos;image miroir de son fichier</translation>
    </message>
    <message>
        <source>is not the one of the certificate</source>
        <translation>n&apos;est pas celle du certificat</translation>
    </message>
    <message>
        <source>has lost pin 4</source>
        <translation>a perdu le pion 4</translation>
    </message>
    <message>
        <source>Virtual plate</source>
        <translation>Plaque virtuelle</translation>
    </message>
    <message>
        <source>Plate to the right, mm</source>
        <translation>Plaque vers la droite, mm</translation>
    </message>
    <message>
        <source>Plate up, mm</source>
        <translation>Plaque vers le haut, mm</translation>
    </message>
    <message>
        <source>Plate turned anticlockwise, degrees</source>
        <translation>Plaque tournée en sens antihoraire, degrés</translation>
    </message>
    <message>
        <source>Plate tilted out of the light, degrees</source>
        <translation>Plaque inclinée hors du plan laser, degrés</translation>
    </message>
    <message>
        <source>tilt </source>
        <translation>incl. </translation>
    </message>
    <message>
        <source>Place as shown</source>
        <translation>Placer ainsi</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Take again</source>
        <translation>Refaire</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>The plate stands where the rail passes, and the cameras are needed. Stop the line to go on; what has been taken so far is kept.</source>
        <translation>La plaque est là où passe le rail, et les caméras sont nécessaires. Arrêter la ligne pour continuer ; ce qui a été pris est conservé.</translation>
    </message>
    <message>
        <source>To be repeated after so many days (0: never)</source>
        <translation>À refaire après tant de jours (0 : jamais)</translation>
    </message>
    <message>
        <source>Days after which the calibration is to be repeated</source>
        <translation>Jours après lesquels l&apos;étalonnage est à refaire</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Reason for the new calibration</source>
        <translation>Motif du nouvel étalonnage</translation>
    </message>
    <message>
        <source>Progress of the solution</source>
        <translation>Progression du calcul</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Centre (CD)</source>
        <translation>Centre (CD)</translation>
    </message>
    <message>
        <source>Radius (RD)</source>
        <translation>Rayon (RD)</translation>
    </message>
    <message>
        <source>Points (PD)</source>
        <translation>Points (PD)</translation>
    </message>
    <message>
        <source>Table IV: fit to the pins</source>
        <translation>Tableau IV : ajustement aux pions</translation>
    </message>
    <message>
        <source>Checks of the new calibration</source>
        <translation>Contrôles du nouvel étalonnage</translation>
    </message>
    <message>
        <source>Four cameras together…</source>
        <translation>Quatre caméras ensemble…</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Annulé : rien n&apos;a changé.</translation>
    </message>
    <message>
        <source>%1 is in force: the line measures with it from the next rail on.</source>
        <translation>%1 est en vigueur : la ligne mesure avec lui dès le prochain rail.</translation>
    </message>
    <message>
        <source>Report of the calibration</source>
        <translation>Rapport de l&apos;étalonnage</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit : %1</translation>
    </message>
    <message>
        <source>turned and moved</source>
        <translation>tournée et déplacée</translation>
    </message>
    <message>
        <source>turned 180°</source>
        <translation>tournée de 180°</translation>
    </message>
    <message>
        <source>moved %1 mm</source>
        <translation>déplacée %1 mm</translation>
    </message>
    <message>
        <source>as drawn, 0°</source>
        <translation>dessinée, 0°</translation>
    </message>
    <message>
        <source>plate and cameras</source>
        <translation>plaque et caméras</translation>
    </message>
    <message>
        <source>Placement %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>four cameras together</source>
        <translation>quatre caméras ensemble</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>old and new</source>
        <translation>ancien et nouveau</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>reason and signature</source>
        <translation>motif et signature</translation>
    </message>
    <message>
        <source>placement %1 of %2</source>
        <translation>position %1 sur %2</translation>
    </message>
    <message>
        <source>U (k = 2) in %1</source>
        <translation>U (k = 2) en %1</translation>
    </message>
    <message>
        <source>mean / max in %1</source>
        <translation>moyenne / max en %1</translation>
    </message>
    <message>
        <source>Plate, %1</source>
        <translation>Plaque, %1</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaque</translation>
    </message>
    <message>
        <source>%1, U = 3 µm, pins towards the cameras</source>
        <translation>%1, U = 3 µm, pions vers les caméras</translation>
    </message>
    <message>
        <source>Camera %1: lens as calibrated in this session</source>
        <translation>Caméra %1 : objectif étalonné pendant cette session</translation>
    </message>
    <message>
        <source>Camera %1: lens of the calibration in force</source>
        <translation>Caméra %1 : objectif de l&apos;étalonnage en vigueur</translation>
    </message>
    <message>
        <source>The plate with 13 pins is put into the gauge where the rail passes, pins towards the cameras, and turned and moved between the pictures. Nothing is applied before old and new have been compared and you confirm.

%1</source>
        <translation>La plaque à 13 pions est placée dans l&apos;appareil là où passe le rail, pions vers les caméras, puis tournée et déplacée entre les images. Rien n&apos;est appliqué avant la comparaison de l&apos;ancien et du nouveau et votre confirmation.

%1</translation>
    </message>
    <message>
        <source>%1 takes the place of %2 from the next rail on. Both are kept and can be compared and put back.</source>
        <translation>%1 remplace %2 dès le prochain rail. Les deux sont conservés et peuvent être comparés et repris.</translation>
    </message>
    <message>
        <source>could not be asked</source>
        <translation>non vérifiable</translation>
    </message>
    <message>
        <source>%1, within %2</source>
        <translation>%1, limite %2</translation>
    </message>
    <message>
        <source>%1, above %2</source>
        <translation>%1, dépasse %2</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>%1 vers la droite</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 vers la gauche</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>%1 vers le haut</translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation>%1 vers le bas</translation>
    </message>
    <message>
        <source>turned by %1° anticlockwise</source>
        <translation>tourner de %1° en sens antihoraire</translation>
    </message>
    <message>
        <source>turned by %1° clockwise</source>
        <translation>tourner de %1° en sens horaire</translation>
    </message>
    <message>
        <source>Next: move the plate to the dashed outlines: %1.</source>
        <translation>Ensuite : amener la plaque sur les contours en tirets : %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Next: put the plate into the gauge.</source>
        <translation>Ensuite : placer la plaque dans l&apos;appareil.</translation>
    </message>
    <message>
        <source>First placement</source>
        <translation>1re position</translation>
    </message>
    <message>
        <source>Next placement</source>
        <translation>Position suivante</translation>
    </message>
    <message>
        <source>Looking at the plate…</source>
        <translation>Examen de la plaque…</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>Caméra %1 : %2</translation>
    </message>
    <message>
        <source>%1 of %2 pins found</source>
        <translation>%1 pions trouvés sur %2</translation>
    </message>
    <message numerus="yes">
        <source>, %n picture(s) refused</source>
        <translation>
            <numerusform>, %n image refusée</numerusform>
            <numerusform>, %n images refusées</numerusform>
        </translation>
    </message>
    <message>
        <source>All four cameras see the plate where it must lie. Next: “%1”.</source>
        <translation>Les quatre caméras voient la plaque là où elle doit être. Ensuite : « %1 ».</translation>
    </message>
    <message>
        <source>The poses of four cameras are found together with the pins.</source>
        <translation>Les poses des quatre caméras sont déterminées avec les pions.</translation>
    </message>
    <message>
        <source>Next: nothing to do; the comparison comes by itself.</source>
        <translation>Ensuite : rien à faire ; la comparaison vient d&apos;elle-même.</translation>
    </message>
    <message>
        <source>Refused: it cannot be put in force.</source>
        <translation>Refusé : ne peut être mis en vigueur.</translation>
    </message>
    <message>
        <source>May be used: every check is within its limit.</source>
        <translation>Utilisable : chaque contrôle est dans sa limite.</translation>
    </message>
    <message numerus="yes">
        <source>May be used, but %n dimension(s) get more than is allowed.</source>
        <translation>
            <numerusform>Utilisable, mais %n cote reçoit plus qu&apos;admis.</numerusform>
            <numerusform>Utilisable, mais %n cotes reçoivent plus qu&apos;admis.</numerusform>
        </translation>
    </message>
    <message>
        <source>Next: compare old and new on the right. Nothing is applied before you confirm.</source>
        <translation>Ensuite : comparer à droite l&apos;ancien et le nouveau. Rien n&apos;est appliqué avant votre confirmation.</translation>
    </message>
    <message>
        <source>Done. Next: start the line and watch the first rail.</source>
        <translation>Terminé. Ensuite : démarrer la ligne et observer le premier rail.</translation>
    </message>
    <message>
        <source>Next: give the reason and put it in force.</source>
        <translation>Ensuite : donner le motif et mettre en vigueur.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone. Start the program on the virtual rig.</source>
        <translation>Aucune installation n&apos;est disponible : les assistants ne voient que par l&apos;installation virtuelle. Démarrer le programme sur l&apos;installation virtuelle.</translation>
    </message>
</context>
<context>
    <name>vignole::SectionDialog</name>
    <message>
        <source>Drawing of a section</source>
        <translation>Plan d&apos;une section</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Section with its primitives named</source>
        <translation>Section avec ses primitives nommées</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Longueur, mm</translation>
    </message>
    <message>
        <source>Radius, mm</source>
        <translation>Rayon, mm</translation>
    </message>
    <message>
        <source>Primitives of the section</source>
        <translation>Primitives de la section</translation>
    </message>
    <message>
        <source>Name of the section</source>
        <translation>Nom de la section</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Profile and straightness class of its recipe</source>
        <translation>Classe de profil et de rectitude de sa recette</translation>
    </message>
    <message>
        <source>Open a drawing…</source>
        <translation>Ouvrir un plan…</translation>
    </message>
    <message>
        <source>Open a drawing of a section</source>
        <translation>Ouvrir le plan d&apos;une section</translation>
    </message>
    <message>
        <source>Make a draft of it</source>
        <translation>En faire un brouillon</translation>
    </message>
    <message>
        <source>Keep the section and make a draft of it</source>
        <translation>Conserver la section et en faire un brouillon</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>There is nothing in this file that could be drawn.</source>
        <translation>Rien dans ce fichier ne peut être dessiné.</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Refusé : %1</translation>
    </message>
    <message>
        <source>QA makes drafts: sign in.</source>
        <translation>La qualité fait les brouillons : se connecter.</translation>
    </message>
    <message>
        <source>Open a drawing: one closed outline of lines and arcs, the rail upright.</source>
        <translation>Ouvrir un plan : un seul contour fermé de segments et d&apos;arcs, le rail debout.</translation>
    </message>
    <message>
        <source>DXF, JSON or a MiniProf design</source>
        <translation>DXF, JSON ou dessin MiniProf</translation>
    </message>
    <message numerus="yes">
        <source>%1 mm high, %2 cm², %3 kg/m, %4; %n primitive(s)</source>
        <translation>
            <numerusform>%1 mm de haut, %2 cm², %3 kg/m, %4 ; %n primitive</numerusform>
            <numerusform>%1 mm de haut, %2 cm², %3 kg/m, %4 ; %n primitives</numerusform>
        </translation>
    </message>
    <message>
        <source>symmetric</source>
        <translation>symétrique</translation>
    </message>
    <message>
        <source>asymmetric</source>
        <translation>asymétrique</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>arc</translation>
    </message>
    <message>
        <source>segment</source>
        <translation>segment</translation>
    </message>
    <message>
        <source>A name has letters, digits, spaces, dots and hyphens: it becomes the name of a file.</source>
        <translation>Un nom a des lettres, chiffres, espaces, points et traits d&apos;union : il devient le nom d&apos;un fichier.</translation>
    </message>
    <message>
        <source>%1 is a section of the catalogue: give yours another name.</source>
        <translation>%1 est une section du catalogue : donner un autre nom à la vôtre.</translation>
    </message>
    <message>
        <source>There is another section of the name %1: give a new name.</source>
        <translation>Il existe une autre section du nom de %1 : donner un nouveau nom.</translation>
    </message>
</context>
<context>
    <name>vignole::SectionDrawing</name>
    <message>
        <source>free end</source>
        <translation>bout libre</translation>
    </message>
    <message>
        <source>open here: %1 mm</source>
        <translation>ouvert ici : %1 mm</translation>
    </message>
</context>
<context>
    <name>vignole::SettingsPage</name>
    <message>
        <source>Screen</source>
        <translation>Écran</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Longueurs</translation>
    </message>
    <message>
        <source>Unit of lengths</source>
        <translation>Unité de longueur</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimètres</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pouces</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personnes</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archive</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Caméras</translation>
    </message>
    <message>
        <source>About</source>
        <translation>À propos</translation>
    </message>
    <message>
        <source>Vignole %1: rail profiles in millimetres, with their uncertainty. Licence GPL-3.0-or-later.</source>
        <translation>Vignole %1 : profils de rail en millimètres, avec leur incertitude. Licence GPL-3.0-or-later.</translation>
    </message>
    <message>
        <source>There is none: %1. Rails are measured and not kept. Start the program with --archive FILE.</source>
        <translation>Il n&apos;y en a pas : %1. Les rails sont mesurés mais non conservés. Démarrer le programme avec --archive FILE.</translation>
    </message>
    <message>
        <source>%1
%2 rails are kept.</source>
        <translation>%1
%2 rails sont conservés.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Language of the screen</source>
        <translation>Langue de l&apos;écran</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>Groupes de réglages</translation>
    </message>
    <message>
        <source>Who is here</source>
        <translation>Qui est là</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>Piste d&apos;audit</translation>
    </message>
    <message>
        <source>of this machine; kept for the next start</source>
        <translation>de cette machine ; conservé pour le prochain démarrage</translation>
    </message>
    <message>
        <source>Show the tour</source>
        <translation>Montrer la visite</translation>
    </message>
    <message>
        <source>Show the tour of Monitor</source>
        <translation>Montrer la visite de Moniteur</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Installation</translation>
    </message>
    <message>
        <source>drawn from the calibration in force</source>
        <translation>dessinée d’après l’étalonnage en vigueur</translation>
    </message>
    <message>
        <source>This line does not tell its calibration.</source>
        <translation>Cette ligne n’indique pas son étalonnage.</translation>
    </message>
    <message>
        <source>Calibration %1. The rail stands where it was seen last.</source>
        <translation>Étalonnage %1. Le rail est là où il a été vu en dernier.</translation>
    </message>
    <message>
        <source>Calibration %1. No rail has been seen yet.</source>
        <translation>Étalonnage %1. Aucun rail n’a encore été vu.</translation>
    </message>
    <message>
        <source>No site is configured: the four cameras are those of the virtual rig, and every page says SIMULATION. Cameras are measured with on the command line: vignole-cli inspect --source gige.</source>
        <translation>Aucun site n&apos;est configuré : les quatre caméras sont celles de l&apos;installation virtuelle et chaque page indique SIMULATION. Avec des caméras, la ligne de commande mesure : vignole-cli inspect --source gige.</translation>
    </message>
</context>
<context>
    <name>vignole::SignInPanel</name>
    <message>
        <source>Who is here</source>
        <translation>Qui est là</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Mot de passe</translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation>Se déconnecter</translation>
    </message>
    <message>
        <source>Enter as the first administrator</source>
        <translation>S&apos;inscrire comme premier administrateur</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Se connecter</translation>
    </message>
    <message>
        <source>Nobody can sign in: people are kept in the archive, and there is none (%1).</source>
        <translation>Personne ne peut se connecter : les personnes sont dans l&apos;archive, et il n&apos;y en a pas (%1).</translation>
    </message>
    <message>
        <source>After a quarter of an hour without a key or a touch it is the operator&apos;s screen again.</source>
        <translation>Après un quart d&apos;heure sans touche ni contact, l&apos;écran revient à l&apos;opérateur.</translation>
    </message>
    <message>
        <source>Nobody is entered yet. The first one is the administrator and enters the others; the password has at least 8 characters.</source>
        <translation>Personne n&apos;est inscrit. Le premier est l&apos;administrateur et inscrit les autres ; le mot de passe a au moins 8 caractères.</translation>
    </message>
    <message>
        <source>Without signing in this is the operator&apos;s screen: it measures, shows and acknowledges.</source>
        <translation>Sans connexion, c&apos;est l&apos;écran de l&apos;opérateur : il mesure, affiche et acquitte.</translation>
    </message>
    <message>
        <source>Name and password are both needed.</source>
        <translation>Nom et mot de passe sont nécessaires.</translation>
    </message>
    <message>
        <source>Name or password is wrong.</source>
        <translation>Nom ou mot de passe incorrect.</translation>
    </message>
    <message>
        <source>This account is closed; ask the administrator.</source>
        <translation>Ce compte est fermé ; demander à l&apos;administrateur.</translation>
    </message>
    <message>
        <source>Too many wrong passwords: locked until %1.</source>
        <translation>Trop de mots de passe erronés : bloqué jusqu&apos;à %1.</translation>
    </message>
    <message>
        <source>New password, at least 8 characters</source>
        <translation>Nouveau mot de passe, au moins 8 caractères</translation>
    </message>
    <message>
        <source>New password</source>
        <translation>Nouveau mot de passe</translation>
    </message>
    <message>
        <source>Change the password</source>
        <translation>Changer le mot de passe</translation>
    </message>
    <message>
        <source>Present password</source>
        <translation>Mot de passe actuel</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>This password was given by somebody else: choose one of your own.</source>
        <translation>Ce mot de passe a été donné par quelqu&apos;un d&apos;autre : en choisir un à soi.</translation>
    </message>
    <message>
        <source>The password is changed.</source>
        <translation>Le mot de passe est changé.</translation>
    </message>
    <message>
        <source>The password is changed: sign in with it.</source>
        <translation>Le mot de passe est changé : se connecter avec.</translation>
    </message>
</context>
<context>
    <name>vignole::StepList</name>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Étape %1 sur %2 : %3</translation>
    </message>
</context>
<context>
    <name>vignole::StripChart</name>
    <message>
        <source>%1 along the rail: %2</source>
        <translation>%1 le long du rail : %2</translation>
    </message>
</context>
<context>
    <name>vignole::StripeView</name>
    <message>
        <source>Camera %1</source>
        <translation>Caméra %1</translation>
    </message>
    <message>
        <source>brightness along the line</source>
        <translation>luminosité le long de la ligne</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Saturated</source>
        <translation>Saturé</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Bruit</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Morceaux</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>trigger %1</source>
        <translation>décl. %1</translation>
    </message>
    <message>
        <source>no picture yet</source>
        <translation>pas encore d&apos;image</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>haut gauche</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>haut droite</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>bas droite</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>bas gauche</translation>
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
        <translation>L&apos;essai n&apos;agit que sur ces images jusqu&apos;à son application.</translation>
    </message>
    <message>
        <source>Anybody may try; a technician who has signed in applies.</source>
        <translation>Chacun peut essayer ; un technicien connecté applique.</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>Figé</translation>
    </message>
    <message>
        <source>This source hands out no pictures.</source>
        <translation>Cette source ne fournit pas d&apos;images.</translation>
    </message>
    <message>
        <source>Nothing is on trial: change a parameter first.</source>
        <translation>Rien à l&apos;essai : changer d&apos;abord un paramètre.</translation>
    </message>
    <message>
        <source>A change of the measurement needs a reason.</source>
        <translation>Un changement de la mesure exige un motif.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer l&apos;image</translation>
    </message>
    <message>
        <source>Lost: %1</source>
        <translation>Perdue : %1</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Figé</translation>
    </message>
    <message>
        <source>The line has not been started (Ctrl+R).</source>
        <translation>La ligne n&apos;a pas été démarrée (Ctrl+R).</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>âge %1</translation>
    </message>
    <message numerus="yes">
        <source>The picture is no longer held: the last %n are.</source>
        <translation>
            <numerusform>L&apos;image n&apos;est plus gardée : seule la dernière (%n) l&apos;est.</numerusform>
            <numerusform>L&apos;image n&apos;est plus gardée : seules les %n dernières le sont.</numerusform>
        </translation>
    </message>
    <message>
        <source>No picture: %1</source>
        <translation>Pas d&apos;image : %1</translation>
    </message>
    <message>
        <source>Pictures behind the profile at %1 m.</source>
        <translation>Images derrière le profil à %1 m.</translation>
    </message>
    <message>
        <source>Waits for the next rail; the running rail keeps what it began with.</source>
        <translation>Attend le prochain rail ; le rail en cours garde ce avec quoi il a commencé.</translation>
    </message>
    <message>
        <source>There is no archive, so the change could not be recorded: nothing was changed.</source>
        <translation>Sans archive, le changement ne pouvait être enregistré : rien n&apos;a été changé.</translation>
    </message>
    <message>
        <source>The change is being recorded…</source>
        <translation>Enregistrement du changement…</translation>
    </message>
    <message>
        <source>Nothing was changed, because it could not be recorded: %1</source>
        <translation>Rien n&apos;a été changé, car cela n&apos;a pu être enregistré : %1</translation>
    </message>
    <message>
        <source>Recorded. The exposure changes with the next start of the line, the parameters with the next rail.</source>
        <translation>Enregistré. L&apos;exposition change au prochain démarrage de la ligne, les paramètres au prochain rail.</translation>
    </message>
    <message>
        <source>Recorded. Waits for the next rail; the running rail keeps what it began with.</source>
        <translation>Enregistré. Attend le prochain rail ; le rail en cours garde ce avec quoi il a commencé.</translation>
    </message>
    <message>
        <source>Camera %1 has no picture to save.</source>
        <translation>La caméra %1 n&apos;a pas d&apos;image à enregistrer.</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>Enregistrement de %1…</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 est écrit.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 ne peut être écrit : %2</translation>
    </message>
</context>
<context>
    <name>vignole::StudyPanel</name>
    <message>
        <source>Parameter study</source>
        <translation>Étude de paramètres</translation>
    </message>
    <message>
        <source>Main effects</source>
        <translation>Effets principaux</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Niveaux</translation>
    </message>
    <message>
        <source>Settings and their levels</source>
        <translation>Réglages et leurs niveaux</translation>
    </message>
    <message>
        <source>Influence of each setting</source>
        <translation>Influence de chaque réglage</translation>
    </message>
    <message>
        <source>Placements of the plate</source>
        <translation>Positions de la plaque</translation>
    </message>
    <message>
        <source>Placements of the plate for the study</source>
        <translation>Positions de la plaque pour l&apos;étude</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Progression de l&apos;étude</translation>
    </message>
    <message>
        <source>Start the study</source>
        <translation>Démarrer l&apos;étude</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>Arrêter la ligne</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>settings and levels</source>
        <translation>réglages et niveaux</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>Annulé : rien n&apos;a changé.</translation>
    </message>
    <message>
        <source>Report of the study</source>
        <translation>Rapport de l&apos;étude</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit : %1</translation>
    </message>
    <message>
        <source>Closed while the line measures: the plate stands where the rail passes. Stop the line to go on.</source>
        <translation>Fermé tant que la ligne mesure : la plaque est là où passe le rail. Arrêter la ligne pour continuer.</translation>
    </message>
    <message>
        <source>Every combination of the levels is a calibration by the paper&apos;s method on pictures of the plate. Levels are parted by commas; one level or none: the setting is not varied.</source>
        <translation>Chaque combinaison des niveaux est un étalonnage par la méthode de l&apos;article sur des images de la plaque. Les niveaux sont séparés par des virgules ; un seul niveau ou aucun : le réglage ne varie pas.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Calcul…</translation>
    </message>
    <message>
        <source>Next: choose levels and start.</source>
        <translation>Ensuite : choisir les niveaux et démarrer.</translation>
    </message>
    <message>
        <source>Exposure, ms</source>
        <translation>Exposition, ms</translation>
    </message>
    <message>
        <source>Smoothing σ, px</source>
        <translation>Lissage σ, px</translation>
    </message>
    <message>
        <source>Ellipses a pin</source>
        <translation>Ellipses par pion</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustement</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone.</source>
        <translation>Aucune installation n&apos;est disponible : les assistants ne voient que par l&apos;installation virtuelle.</translation>
    </message>
</context>
<context>
    <name>vignole::SupportBundle</name>
    <message>
        <source>is there already</source>
        <translation>existe déjà</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>ne peut être créé</translation>
    </message>
    <message>
        <source>cancelled: nothing is left of it</source>
        <translation>annulé : il n&apos;en reste rien</translation>
    </message>
</context>
<context>
    <name>vignole::TolerancePlot</name>
    <message>
        <source>lower limit %1</source>
        <translation>limite inférieure %1</translation>
    </message>
    <message>
        <source>upper limit %1</source>
        <translation>limite supérieure %1</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>attendu %1</translation>
    </message>
</context>
<context>
    <name>vignole::Tour</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Fermer (Échap)</translation>
    </message>
    <message>
        <source>Close the tour</source>
        <translation>Fermer la visite</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Commencer</translation>
    </message>
</context>
<context>
    <name>vignole::TrialPanel</name>
    <message>
        <source>Line extraction</source>
        <translation>Extraction de ligne</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Exposition</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>Low threshold</source>
        <translation>Seuil bas</translation>
    </message>
    <message>
        <source>High threshold</source>
        <translation>Seuil haut</translation>
    </message>
    <message>
        <source>Link distance</source>
        <translation>Distance de lien</translation>
    </message>
    <message>
        <source>Link angle</source>
        <translation>Angle de lien</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Paramètre</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>En service</translation>
    </message>
    <message>
        <source>On trial</source>
        <translation>À l&apos;essai</translation>
    </message>
    <message>
        <source>%1 on trial</source>
        <translation>%1 à l&apos;essai</translation>
    </message>
    <message>
        <source>%1: less</source>
        <translation>%1 : moins</translation>
    </message>
    <message>
        <source>%1: more</source>
        <translation>%1 : plus</translation>
    </message>
    <message>
        <source>Choose camera %1</source>
        <translation>Choisir la caméra %1</translation>
    </message>
    <message>
        <source>Pixels with the line in use</source>
        <translation>Pixels avec la ligne en service</translation>
    </message>
    <message>
        <source>Pixels with the line on trial</source>
        <translation>Pixels avec la ligne à l&apos;essai</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Différence</translation>
    </message>
    <message>
        <source>In use against on trial</source>
        <translation>En service et à l&apos;essai</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Gained, lost</source>
        <translation>Gagnés, perdus</translation>
    </message>
    <message>
        <source>Saturated points</source>
        <translation>Points saturés</translation>
    </message>
    <message>
        <source>Uncertainty, px</source>
        <translation>Incertitude, px</translation>
    </message>
    <message>
        <source>Shift: mean, largest, px</source>
        <translation>Décalage : moyen, maximal, px</translation>
    </message>
    <message>
        <source>Time, ms</source>
        <translation>Temps, ms</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save the picture of the chosen camera (Ctrl+S)</source>
        <translation>Enregistrer l&apos;image de la caméra choisie (Ctrl+S)</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Direct</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Figer</translation>
    </message>
    <message>
        <source>Live pictures again (P)</source>
        <translation>À nouveau en direct (P)</translation>
    </message>
    <message>
        <source>Freeze the pictures (P)</source>
        <translation>Figer les images (P)</translation>
    </message>
    <message>
        <source>Freeze the pictures</source>
        <translation>Figer les images</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>The pictures behind the newest profile (B)</source>
        <translation>Les images derrière le dernier profil (B)</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Discard what is on trial</source>
        <translation>Abandonner l&apos;essai</translation>
    </message>
    <message>
        <source>Use from next rail</source>
        <translation>Dès le prochain rail</translation>
    </message>
    <message>
        <source>Use what is on trial from the next rail on</source>
        <translation>Utiliser l&apos;essai dès le prochain rail</translation>
    </message>
    <message>
        <source>Reason for the change</source>
        <translation>Motif du changement</translation>
    </message>
    <message>
        <source>These cameras&apos; exposure cannot be changed from here.</source>
        <translation>L&apos;exposition de ces caméras ne peut être changée d&apos;ici.</translation>
    </message>
    <message>
        <source>camera %1, frozen</source>
        <translation>caméra %1, figée</translation>
    </message>
    <message>
        <source>camera %1, live</source>
        <translation>caméra %1, en direct</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>pas d&apos;image</translation>
    </message>
    <message>
        <source>nothing on trial: change a parameter</source>
        <translation>rien à l&apos;essai : changer un paramètre</translation>
    </message>
</context>
<context>
    <name>vignole::VerdictPanel</name>
    <message>
        <source>Verdict: %1, %2. Gauge: %3</source>
        <translation>Verdict : %1, %2. Appareil : %3</translation>
    </message>
    <message>
        <source>Gauge: %1</source>
        <translation>Appareil : %1</translation>
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
        <translation>Et si</translation>
    </message>
    <message>
        <source>The rails that were found are judged again with other limits, from what is stored of every profile. Nothing that is stored changes.</source>
        <translation>Les rails trouvés sont rejugés avec d&apos;autres limites, d&apos;après ce qui est conservé de chaque profil. Rien de conservé ne change.</translation>
    </message>
    <message>
        <source>Profile class</source>
        <translation>Classe de profil</translation>
    </message>
    <message>
        <source>Straightness class</source>
        <translation>Classe de rectitude</translation>
    </message>
    <message>
        <source>As in the recipe</source>
        <translation>Comme dans la recette</translation>
    </message>
    <message>
        <source>lower, %1</source>
        <translation>inférieure, %1</translation>
    </message>
    <message>
        <source>upper, %1</source>
        <translation>supérieure, %1</translation>
    </message>
    <message>
        <source>Lower limit of %1, deviation</source>
        <translation>Limite inférieure de %1, écart</translation>
    </message>
    <message>
        <source>Upper limit of %1, deviation</source>
        <translation>Limite supérieure de %1, écart</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Rail</translation>
    </message>
    <message>
        <source>Was</source>
        <translation>Était</translation>
    </message>
    <message>
        <source>Would be</source>
        <translation>Serait</translation>
    </message>
    <message>
        <source>Because of</source>
        <translation>À cause de</translation>
    </message>
    <message>
        <source>Rails whose verdict would change</source>
        <translation>Rails dont le verdict changerait</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>A limit of %1 is no number. An empty field is no limit.</source>
        <translation>Une limite de %1 n&apos;est pas un nombre. Un champ vide : pas de limite.</translation>
    </message>
    <message>
        <source>The lower limit of %1 is above the upper one: exchange them.</source>
        <translation>La limite inférieure de %1 est au-dessus de la supérieure : les échanger.</translation>
    </message>
    <message>
        <source>%1 of %2 rails judged</source>
        <translation>%1 rails jugés sur %2</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Essayer</translation>
    </message>
    <message>
        <source>Stop judging</source>
        <translation>Arrêter le jugement</translation>
    </message>
    <message>
        <source>Judge the rails with these limits</source>
        <translation>Juger les rails avec ces limites</translation>
    </message>
    <message>
        <source>No rail of this section is in the list. Search for rails first.</source>
        <translation>Aucun rail de cette section dans la liste. Chercher d&apos;abord des rails.</translation>
    </message>
    <message>
        <source>Judging …</source>
        <translation>Jugement …</translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s) of section %1</source>
        <translation>
            <numerusform>%n rail de la section %1</numerusform>
            <numerusform>%n rails de la section %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Fewer than %1 rails prove little.</source>
        <translation>Moins de %1 rails prouvent peu.</translation>
    </message>
    <message>
        <source>Choose a class or enter deviations from nominal, then Try. Empty: no limit.</source>
        <translation>Choisir une classe ou saisir des écarts au nominal, puis Essayer. Vide : pas de limite.</translation>
    </message>
    <message>
        <source>%1 of %2 rails would change their verdict</source>
        <translation>%1 rails sur %2 changeraient de verdict</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 à %3</translation>
    </message>
    <message>
        <source>stopped before all %1 were judged</source>
        <translation>arrêté avant d&apos;avoir jugé les %1</translation>
    </message>
    <message numerus="yes">
        <source>%n could not be judged: %1</source>
        <translation>
            <numerusform>%n n&apos;a pu être jugé : %1</numerusform>
            <numerusform>%n n&apos;ont pu être jugés : %1</numerusform>
        </translation>
    </message>
    <message>
        <source>fewer than %1 rails prove little</source>
        <translation>moins de %1 rails prouvent peu</translation>
    </message>
</context>
<context>
    <name>vignole::WorthTable</name>
    <message>
        <source>Dimension</source>
        <translation>Cote</translation>
    </message>
    <message>
        <source>In force</source>
        <translation>En vigueur</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>Admis</translation>
    </message>
    <message>
        <source>Largest part</source>
        <translation>Part principale</translation>
    </message>
    <message>
        <source>What the calibration is worth for each dimension</source>
        <translation>Ce que vaut l&apos;étalonnage pour chaque cote</translation>
    </message>
    <message>
        <source>More than the tolerance allows</source>
        <translation>Plus que la tolérance ne permet</translation>
    </message>
    <message>
        <source>too much: %1</source>
        <translation>trop : %1</translation>
    </message>
</context>
</TS>
