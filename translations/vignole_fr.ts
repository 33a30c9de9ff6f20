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
        <source>Smallest, largest</source>
        <translation>Plus petite, plus grande</translation>
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
        <source>Support file…</source>
        <translation>Fichier d&apos;assistance…</translation>
    </message>
    <message>
        <source>Save a support file</source>
        <translation>Enregistrer un fichier d&apos;assistance</translation>
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
        <source>Rendered cameras: no packets to be sent again, no temperature.</source>
        <translation>Caméras simulées : pas de paquets renvoyés, pas de température.</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Disque</translation>
    </message>
    <message>
        <source>%1 of %2 GB free</source>
        <translation>%1 Go libres sur %2</translation>
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
        <source>open</source>
        <translation>ouverte</translation>
    </message>
    <message>
        <source>none: rails are not kept</source>
        <translation>aucune : rails non conservés</translation>
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
        <source>turn p99 %1 ms</source>
        <translation>tour p99 %1 ms</translation>
    </message>
    <message>
        <source>p50 %1, largest %2, limit 50 ms</source>
        <translation>p50 %1, maxi %2, limite 50 ms</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Écran</translation>
    </message>
    <message>
        <source>the window&apos;s thread</source>
        <translation>le fil de la fenêtre</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 ne peut être écrit : %2</translation>
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
        <source>mean time of a stage, SD standard deviation, UCL upper limit of the 99 % confidence interval; of a queue now (dark), highest fill (mark) and size</source>
        <translation>temps moyen d&apos;une étape, ET écart-type, LSC limite supérieure de l&apos;intervalle de confiance à 99 % ; d&apos;une file : maintenant (sombre), plus haut niveau (repère) et taille</translation>
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
        <source>Rails that may be laid over each other</source>
        <translation>Rails superposables</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cote</translation>
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
        <source>Export values and ranges as CSV</source>
        <translation>Exporter valeurs et étendues en CSV</translation>
    </message>
    <message>
        <source>Values over the length</source>
        <translation>Valeurs sur la longueur</translation>
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
        <source>as Fig. 9b</source>
        <translation>comme Fig. 9b</translation>
    </message>
    <message>
        <source>Values of every run over the length</source>
        <translation>Valeurs de chaque passage sur la longueur</translation>
    </message>
    <message>
        <source>Range of the runs over the length</source>
        <translation>Étendue des passages sur la longueur</translation>
    </message>
    <message>
        <source>Mean range</source>
        <translation>Étendue moyenne</translation>
    </message>
    <message>
        <source>per 10 m, as Table VI</source>
        <translation>par 10 m, comme Tab. VI</translation>
    </message>
    <message>
        <source>From – to, m</source>
        <translation>De – à, m</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positions</translation>
    </message>
    <message>
        <source>Mean range, section by section</source>
        <translation>Étendue moyenne, tronçon par tronçon</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Chiffres</translation>
    </message>
    <message>
        <source>Figures of the study</source>
        <translation>Chiffres de l&apos;étude</translation>
    </message>
    <message>
        <source>Runs come from the archive, and there is none: %1. Start the program with --archive FILE.</source>
        <translation>Les passages viennent de l&apos;archive, et il n&apos;y en a pas : %1. Démarrer le programme avec --archive FILE.</translation>
    </message>
    <message>
        <source>At least 2 runs of the same rail are needed, %1 chosen; the paper took 5.</source>
        <translation>Il faut au moins 2 passages du même rail, %1 choisis ; l&apos;article en a pris 5.</translation>
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
        <source>Tick the runs that were made of the same rail, choose a dimension and compare.</source>
        <translation>Cocher les passages du même rail, choisir une cote et comparer.</translation>
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
        <source>Runs, positions</source>
        <translation>Passages, positions</translation>
    </message>
    <message>
        <source>Repeatability s_r</source>
        <translation>Répétabilité s_r</translation>
    </message>
    <message>
        <source>its 95 % interval</source>
        <translation>son intervalle à 95 %</translation>
    </message>
    <message>
        <source>Limit r = 2.8 s_r</source>
        <translation>Limite r = 2,8 s_r</translation>
    </message>
    <message>
        <source>Largest range</source>
        <translation>Plus grande étendue</translation>
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
        <source>%1, critical %2 (1 %)</source>
        <translation>%1, critique %2 (1 %)</translation>
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
        <source>, %1 positions left out: a run lacks them</source>
        <translation>, %1 positions omises : un passage ne les a pas</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Exporter en CSV</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 est écrit</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 ne peut être écrit</translation>
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
        <source>inside</source>
        <translation>dedans</translation>
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
        <source>kept: %1 rails, %2 profiles waiting</source>
        <translation>conservés : %1 rails, %2 profils en attente</translation>
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
</context>
<context>
    <name>vignole::ReplayCanvas</name>
    <message>
        <source>Profile of the stored rail</source>
        <translation>Profil du rail conservé</translation>
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
        <source>No site is configured: the four cameras are those of the virtual rig, and every page says SIMULATION. Cameras with GigE Vision are not part of this version.</source>
        <translation>Aucun site n&apos;est configuré : les quatre caméras sont celles de l&apos;installation virtuelle et chaque page indique SIMULATION. Les caméras GigE Vision ne font pas partie de cette version.</translation>
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
</context>
<context>
    <name>vignole::StripesPage</name>
    <message>
        <source>Line extraction</source>
        <translation>Extraction de ligne</translation>
    </message>
    <message>
        <source>Smoothing σ</source>
        <translation>Lissage σ</translation>
    </message>
    <message>
        <source>Low threshold t_l</source>
        <translation>Seuil bas t_l</translation>
    </message>
    <message>
        <source>High threshold t_h</source>
        <translation>Seuil haut t_h</translation>
    </message>
    <message>
        <source>Link distance d</source>
        <translation>Distance de liaison d</translation>
    </message>
    <message>
        <source>Link angle α</source>
        <translation>Angle de liaison α</translation>
    </message>
    <message>
        <source>%1 on trial</source>
        <translation>%1 à l&apos;essai</translation>
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
        <source>Difference</source>
        <translation>Différence</translation>
    </message>
    <message>
        <source>In use against on trial</source>
        <translation>En service et à l&apos;essai</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Enregistrer l&apos;image…</translation>
    </message>
    <message>
        <source>Save the picture of the chosen camera</source>
        <translation>Enregistrer l&apos;image de la caméra choisie</translation>
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
        <source>Use from next start</source>
        <translation>Utiliser au prochain démarrage</translation>
    </message>
    <message>
        <source>Use what is on trial from the next start of the line</source>
        <translation>Utiliser l&apos;essai au prochain démarrage de la ligne</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Reason for the change</source>
        <translation>Motif du changement</translation>
    </message>
    <message>
        <source>Live again</source>
        <translation>Reprendre le direct</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Figer</translation>
    </message>
    <message>
        <source>Freeze the pictures</source>
        <translation>Figer les images</translation>
    </message>
    <message>
        <source>Freeze the pictures (P)</source>
        <translation>Figer les images (P)</translation>
    </message>
    <message>
        <source>What is tried acts on these pictures alone until it is applied.</source>
        <translation>L&apos;essai n&apos;agit que sur ces images jusqu&apos;à son application.</translation>
    </message>
    <message>
        <source>Anybody may try; a technician who has signed in applies.</source>
        <translation>Chacun peut essayer ; un technicien connecté applique.</translation>
    </message>
    <message>
        <source>lost: %1</source>
        <translation>perdue : %1</translation>
    </message>
    <message>
        <source>held, %1 old</source>
        <translation>figé, vieux de %1</translation>
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
        <source>Is used from the next start of the line (Ctrl+R stops and starts it); the running rail keeps what it began with.</source>
        <translation>Utilisé au prochain démarrage de la ligne (Ctrl+R arrête et démarre) ; le rail en cours garde ce avec quoi il a commencé.</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>caméra %1</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Saturated, %</source>
        <translation>Saturé, %</translation>
    </message>
    <message>
        <source>Uncertainty, px</source>
        <translation>Incertitude, px</translation>
    </message>
    <message>
        <source>Time, ms</source>
        <translation>Temps, ms</translation>
    </message>
    <message>
        <source>Mean shift, px</source>
        <translation>Décalage moyen, px</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer l&apos;image</translation>
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
        <source>Camera %1</source>
        <translation>Caméra %1</translation>
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
</TS>
