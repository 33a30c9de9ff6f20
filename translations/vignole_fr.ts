<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>AlarmRule</name>
    <message>
        <source>A camera does not answer while a rail passes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its quarter of the profile is missing; rails pass unmeasured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check power and network cable of the camera, then Diagnostics; stop the line if it does not come back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too many triggers give no complete profile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stretches of the rail are not measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See Diagnostics for the camera that loses frames; check network load and trigger.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too many profiles do not fit the section of the recipe.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dimensions of this rail are not to be trusted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the recipe is the one of the rail that runs; look at Stripes for glare or scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measurement has stopped while a rail passes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rails pass unmeasured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the measurement; if it stops again, save a support bundle in Diagnostics.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A rail has a stretch out of tolerance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rail must not be delivered as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark the rail, see its exceptions on Rails, tell the rolling mill which dimension and where.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rail looks like another section than that of the recipe.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is judged by the wrong tolerances.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the recipe of the rail that is rolled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The calibration in force is refused, missing or out of date.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainties are not what the reports state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate, or bring back an earlier calibration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The seam between two cameras has moved in normal production.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimensions across the seam are biased by about as much.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the mounting of the cameras beside the seam; calibrate the range finders at the next pause.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A camera loses frames.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profiles are incomplete now and then.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check cable, switch and packet size of the camera.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Much of a laser line is saturated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points on bright patches are less certain.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shorten the exposure of the camera or clean the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A laser line is faint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points are missing or uncertain.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clean the windows, check the laser, lengthen the exposure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rig is warmer than its calibration allows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions of cameras and lasers move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check cooling and air; calibrate if it stays so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The disk is nearly full.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records of rails cannot be kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prune the archive or enlarge the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The archive does not answer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rails are measured; their records wait on this machine&apos;s disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check database and network; records are sent when it is back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The queues of the measurement fill up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profiles will be dropped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close what else runs on this machine; lower the trigger rate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A toleranced dimension is not measured while a rail passes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rail cannot be judged by it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clean windows and check lasers; see Stripes for where the line is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The window answers slowly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it shows is late; the measurement goes on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close what else runs on this machine; see Diagnostics.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AlarmWords</name>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rail %1 out of tolerance: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera %1 lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>came</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>went</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>acknowledged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shelved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taken off the shelf</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shelf ran out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flood began</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flood ended</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Dimension</name>
    <message>
        <source>Rail height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rail flange height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Head form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Head width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Head width (AREMA)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot thickness left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot thickness right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rail asymmetry left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rail asymmetry right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Web thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Head radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot concavity</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>Good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured, because %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 above the limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 below the limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No rail found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model %1 (approximate)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model %1 (invented)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deviation %1 %2, ×%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rail %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rail profile report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1   recipe %2   calibration %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm. s: standard deviation along the rail; u, U: standard and expanded uncertainty of one profile; Exc.: stretches out of tolerance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile at %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimensions along the rail, mm over m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean of a stretch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smallest to largest value of the stretch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expected value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limits; the ground outside is grey</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exception, with its square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exceptions: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (continued)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>worst mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Triggers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured: complete, four contours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>incomplete: a camera or the registration was missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost: no profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lengths refer to 15 ଌ. U is the expanded uncertainty with k = 2; a value nearer to a limit than U is near limit: it cannot be decided.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This section is invented: not for acceptance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This section is approximate: not for acceptance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>profile at %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Max</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exc.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>min %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rail temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured (UTC)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written (UTC)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured (local)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written (local)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm at 15 ଌ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No limits to judge by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not valid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> out of tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> from %1 to %2 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> in %1 stretches, the first at %2 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> not measured, because %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> near limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 toleranced dimensions within their limits over %2 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured, because %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Engine</name>
    <message>
        <source>wrong section: looks like %1 rather than %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrong section: looks like %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not registered: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not registered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looks like %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the points do not agree with %1: %2 lie on it, rms %3 mm; another rail, badly worn, or not a rail?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the points do not agree with %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the section has no web</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the points do not determine a pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the foot edge is not upright</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the crown is flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points do not reach x = %1 from the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points do not reach the crown on the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points do not reach %1 above the base line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not defined on this section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no point is near the outline of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no base line: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measurement failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>extraction failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>translation failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the profile is not registered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no points on %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only %1 point on %2, %3 are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only %1 points on %2, %3 are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only %1 points, at least %2 are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the points on %1 make no curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not fitted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeated frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>late frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>source failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>queue overflow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outside of a rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missed by all cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 from %2 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>camera %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rail %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>archive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pipeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nominal (virtual rig)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>range finders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rail %1 has passed: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the line was started</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the line was stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 signed in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 signed out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>near limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>out of tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not valid</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Judgement</name>
    <message>
        <source>from %1 on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 above the limit %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 below the limit %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 beyond the limit %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>camera %1 lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cameras %1 lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 dimensions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not valid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 not measured from %2 on: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 near limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>single profiles outside the limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 inside the limit, closer than U</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 outside the limit, by less than U</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>within the guard band earlier on this rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 within the guard band earlier on this rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 dimensions within limits up to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for a rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the gauge is ready; values appear with the head of the rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the line is not running: Ctrl+R starts it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recipe gives no tolerance to any dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this rail was not measured completely</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 not measured on enough of this rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Idle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no profiles since %1, %2 ago. Hold this rail.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>held: last profile at %1, %2 ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 cameras, %3 profiles/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no profiles for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>calibration %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not trusted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no profile yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the line is not running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degraded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 incomplete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trusted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The line is stopped: Ctrl+R starts it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready for the next rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No alarm on this rail</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Page</name>
    <message>
        <source>Monitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stripes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Role</name>
    <message>
        <source>Operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Technician</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>QA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::AlarmLine</name>
    <message>
        <source>Alarm, priority %1: %2. %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) acknowledged, still on</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge the shown alarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge the shown alarm (Ctrl+A)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::AlarmsPage</name>
    <message>
        <source>Active</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge all that are shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge all that are shown (Ctrl+Shift+A)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What happened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Details</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lives of the alarms, newest first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shelve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hides an alarm for a while</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarm to shelve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason for shelving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For how long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shelved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comes back by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring back the chosen alarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Until</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shelved alarms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An operator may shelve for %1 minutes at most.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Priority %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Consequence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>acknowledged by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not acknowledged</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is wrong. Alarms appear here with their cause, their consequence and what to do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>alarms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing since the program started</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>since the program started</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flood: more than 10 alarms in 10 minutes. Look for one cause behind them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target: below 1 in 10 minutes; above 10 it is a flood.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::ChartsPage</name>
    <message>
        <source>Dimensions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimension that is charted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rail that is charted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole range (0)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the chart as picture, PDF or CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimension along the rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimension rail by rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Histogram of the rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>same scale, this rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Per rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figures of the rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rails are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No rail has been measured yet. Its chart appears here when it has passed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newest rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 along the rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rail %1, %2 profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; no band: %1 of %2 other rails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; band: last %1 rails, 10 to 90 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>same scale, longest bar %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>mean with smallest and largest value, last %n rail(s) of this section</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest, largest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty U (k = 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beyond a limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the guard band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room to the nearer limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move over the chart or press Left and Right to read values; wheel or + and − zoom, drag moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1   %2 %3   U ±%4   %5 from expected   %6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the chart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::DiagnosticsPage</name>
    <message>
        <source>Pipeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every trigger accounted for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>since the line was started</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Support file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a support file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where every trigger went</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counters of the cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load of the computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>held, %1 old</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 profiles/s of %2 expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Triggers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Incomplete: measured by fewer cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not accounted for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>: lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rendered cameras: no packets to be sent again, no temperature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 GB free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>make room: nearly full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Archive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none: rails are not kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Processor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % of one core</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n core(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn p99 %1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p50 %1, largest %2, limit 50 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the window&apos;s thread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::DimensionModel</name>
    <message>
        <source>Not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured, because %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limits %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting for a profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance and guard band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not meas.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Held</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es) out of tolerance</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 %3, deviation %4, U %5, %6</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::DimensionTable</name>
    <message>
        <source>Dimensions</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::HeaderBar</name>
    <message>
        <source>Rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gauge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other theme (Ctrl+D)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: sign in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2: sign out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign in (Ctrl+L)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: sign out (Ctrl+L)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation: the rails are not real</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rails come from the virtual rig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::LastRails</name>
    <message>
        <source>Out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>good %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last rails: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last rails</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::MonitorPage</name>
    <message>
        <source>Whole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Web</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the section (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnify deviations less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnify deviations less (−)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviations are drawn so many times larger (0: back to 20)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnify deviations more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnify deviations more (+)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour points by camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour points by camera (C)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing in full view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing in full view (F11)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (Ctrl+R)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no value</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::PipelinePanel</name>
    <message>
        <source>Pipeline: %1 triggers, %2 measured, %3 incomplete, %4 lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SD %1   UCL %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acquisition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line extraction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2D to 3D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean time of a stage, SD standard deviation, UCL upper limit of the 99 % confidence interval; of a queue now (dark), highest fill (mark) and size</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::ProfileCanvas</name>
    <message>
        <source>Measured profile over the section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last profile at %1 m, %2 ago</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::QualityPage</name>
    <message>
        <source>Repeatability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>runs of the same rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rails that may be laid over each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Single profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Means over 0.1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Means over 1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare the chosen runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export values and ranges as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values over the length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as Fig. 9a</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range of the runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as Fig. 9b</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values of every run over the length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range of the runs over the length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>per 10 m, as Table VI</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From – to, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean range, section by section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figures of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs come from the archive, and there is none: %1. Start the program with --archive FILE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least 2 runs of the same rail are needed, %1 chosen; the paper took 5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No rail has been kept yet. Runs of the same rail are compared here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick the runs that were made of the same rail, choose a dimension and compare.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>range, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs, positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeatability s_r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its 95 % interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit r = 2.8 s_r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s from the range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, critical %2 (1 %)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grubbs, means of the runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cochran, scatter of the runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 positions left out: a run lacks them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::RailBand</name>
    <message>
        <source>Place along the rail</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::RailsPage</name>
    <message>
        <source>Rails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rail or heat, from its beginning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search by rail or heat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimension out of tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worst</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rails found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report as PDF (Ctrl+P)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export as CSV (Ctrl+E)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From – to, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worst, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stretches out of tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous exception</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous exception (Shift+N)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next exception</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next exception (N)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play along the rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause (P)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No rail is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a rail in the list: its profile, its dimensions along the rail and its exceptions are shown here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rails are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No rail is like that. Clear the search or choose other filters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No rail has been measured yet. Rails appear here when they have passed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay: not live.  Rail %1, %2 to %3, recipe %4, calibration %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none: every dimension stayed within its limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>The profile cannot be drawn: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile at %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no. %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>: points were not kept of this rail, the model is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; drawn is no. %1, the nearest whose points were kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>writing %1 …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::ReplayCanvas</name>
    <message>
        <source>Profile of the stored rail</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::SettingsPage</name>
    <message>
        <source>Screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Role</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People who may sign in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the new person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First password of the new person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason for entering the person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Role of the new person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Archive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No site is configured: the four cameras are those of the virtual rig, and every page says SIMULATION. Cameras with GigE Vision are not part of this version.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vignole %1: rail profiles in millimetres, with their uncertainty. Licence GPL-3.0-or-later.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names and roles are the administrator&apos;s: sign in as administrator to see and enter people.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>never</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is entered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is none: %1. Rails are measured and not kept. Start the program with --archive FILE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
%2 rails are kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language of the screen</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::SignInPanel</name>
    <message>
        <source>Who is here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Password</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter as the first administrator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody can sign in: people are kept in the archive, and there is none (%1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After a quarter of an hour without a key or a touch it is the operator&apos;s screen again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody is entered yet. The first one is the administrator and enters the others; the password has at least 8 characters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without signing in this is the operator&apos;s screen: it measures, shows and acknowledges.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name and password are both needed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name or password is wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This account is closed; ask the administrator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too many wrong passwords: locked until %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::StripChart</name>
    <message>
        <source>%1 along the rail: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::StripeView</name>
    <message>
        <source>Camera %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brightness along the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saturated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trigger %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no picture yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::StripesPage</name>
    <message>
        <source>Line extraction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smoothing σ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low threshold t_l</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>High threshold t_h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link distance d</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link angle α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 on trial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On trial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In use against on trial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture of the chosen camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard what is on trial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use from next start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use what is on trial from the next start of the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason for the change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freeze the pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freeze the pictures (P)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is tried acts on these pictures alone until it is applied.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anybody may try; a technician who has signed in applies.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>held, %1 old</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This source hands out no pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is on trial: change a parameter first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A change of the measurement needs a reason.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is used from the next start of the line (Ctrl+R stops and starts it); the running rail keeps what it began with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saturated, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty, px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time, ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean shift, px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::TolerancePlot</name>
    <message>
        <source>lower limit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>upper limit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>vignole::VerdictPanel</name>
    <message>
        <source>Verdict: %1, %2. Gauge: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gauge: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATION, %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
