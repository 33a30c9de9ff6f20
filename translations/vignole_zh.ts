<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>AlarmRule</name>
    <message>
        <source>A camera does not answer while a rail passes.</source>
        <translation>钢轨通过时一台相机无响应。</translation>
    </message>
    <message>
        <source>Its quarter of the profile is missing; rails pass unmeasured.</source>
        <translation>其所测四分之一轮廓缺失；钢轨未经测量通过。</translation>
    </message>
    <message>
        <source>Check power and network cable of the camera, then Diagnostics; stop the line if it does not come back.</source>
        <translation>检查相机电源和网线，再查看“诊断”；若未恢复，请停线。</translation>
    </message>
    <message>
        <source>Too many triggers give no complete profile.</source>
        <translation>过多触发未得到完整轮廓。</translation>
    </message>
    <message>
        <source>Stretches of the rail are not measured.</source>
        <translation>钢轨的部分长度未被测量。</translation>
    </message>
    <message>
        <source>See Diagnostics for the camera that loses frames; check network load and trigger.</source>
        <translation>在“诊断”中查看哪台相机丢帧；检查网络负载和触发。</translation>
    </message>
    <message>
        <source>Too many profiles do not fit the section of the recipe.</source>
        <translation>过多轮廓与配方的轨型不符。</translation>
    </message>
    <message>
        <source>The dimensions of this rail are not to be trusted.</source>
        <translation>该钢轨的尺寸不可信。</translation>
    </message>
    <message>
        <source>Check that the recipe is the one of the rail that runs; look at Stripes for glare or scale.</source>
        <translation>检查配方是否与当前钢轨一致；在“激光线”中查看反光或氧化皮。</translation>
    </message>
    <message>
        <source>The measurement has stopped while a rail passes.</source>
        <translation>钢轨通过时测量已停止。</translation>
    </message>
    <message>
        <source>Rails pass unmeasured.</source>
        <translation>钢轨未经测量通过。</translation>
    </message>
    <message>
        <source>Start the measurement; if it stops again, save a support bundle in Diagnostics.</source>
        <translation>启动测量；若再次停止，请在“诊断”中保存支持文件。</translation>
    </message>
    <message>
        <source>A rail has a stretch out of tolerance.</source>
        <translation>钢轨有一段超差。</translation>
    </message>
    <message>
        <source>The rail must not be delivered as it is.</source>
        <translation>该钢轨不得按现状交货。</translation>
    </message>
    <message>
        <source>Mark the rail, see its exceptions on Rails, tell the rolling mill which dimension and where.</source>
        <translation>标记钢轨，在“钢轨”中查看超差段，告知轧机哪个尺寸、在何处。</translation>
    </message>
    <message>
        <source>The rail looks like another section than that of the recipe.</source>
        <translation>该钢轨看似与配方不同的轨型。</translation>
    </message>
    <message>
        <source>It is judged by the wrong tolerances.</source>
        <translation>正按错误的公差评判。</translation>
    </message>
    <message>
        <source>Choose the recipe of the rail that is rolled.</source>
        <translation>选择所轧钢轨的配方。</translation>
    </message>
    <message>
        <source>The calibration in force is refused, missing or out of date.</source>
        <translation>现行标定被拒绝、缺失或已过期。</translation>
    </message>
    <message>
        <source>Uncertainties are not what the reports state.</source>
        <translation>不确定度与报告所述不符。</translation>
    </message>
    <message>
        <source>Calibrate, or bring back an earlier calibration.</source>
        <translation>重新标定，或恢复先前的标定。</translation>
    </message>
    <message>
        <source>The seam between two cameras has moved in normal production.</source>
        <translation>正常生产中两相机间的接缝发生移动。</translation>
    </message>
    <message>
        <source>Dimensions across the seam are biased by about as much.</source>
        <translation>跨接缝的尺寸有大致相同的偏差。</translation>
    </message>
    <message>
        <source>Check the mounting of the cameras beside the seam; calibrate the range finders at the next pause.</source>
        <translation>检查接缝旁相机的安装；下次停机时标定测距仪。</translation>
    </message>
    <message>
        <source>A camera loses frames.</source>
        <translation>一台相机丢帧。</translation>
    </message>
    <message>
        <source>Profiles are incomplete now and then.</source>
        <translation>轮廓时有不完整。</translation>
    </message>
    <message>
        <source>Check cable, switch and packet size of the camera.</source>
        <translation>检查相机的线缆、交换机和数据包大小。</translation>
    </message>
    <message>
        <source>Much of a laser line is saturated.</source>
        <translation>激光线大部分饱和。</translation>
    </message>
    <message>
        <source>Points on bright patches are less certain.</source>
        <translation>亮斑处的点不够可靠。</translation>
    </message>
    <message>
        <source>Shorten the exposure of the camera or clean the window.</source>
        <translation>缩短相机曝光或清洁窗口。</translation>
    </message>
    <message>
        <source>A laser line is faint.</source>
        <translation>激光线偏弱。</translation>
    </message>
    <message>
        <source>Points are missing or uncertain.</source>
        <translation>点缺失或不可靠。</translation>
    </message>
    <message>
        <source>Clean the windows, check the laser, lengthen the exposure.</source>
        <translation>清洁窗口，检查激光器，延长曝光。</translation>
    </message>
    <message>
        <source>The rig is warmer than its calibration allows.</source>
        <translation>装置温度超出标定允许范围。</translation>
    </message>
    <message>
        <source>Positions of cameras and lasers move.</source>
        <translation>相机和激光器的位置发生移动。</translation>
    </message>
    <message>
        <source>Check cooling and air; calibrate if it stays so.</source>
        <translation>检查冷却和气源；若持续如此请标定。</translation>
    </message>
    <message>
        <source>The disk is nearly full.</source>
        <translation>磁盘将满。</translation>
    </message>
    <message>
        <source>Records of rails cannot be kept.</source>
        <translation>无法保存钢轨记录。</translation>
    </message>
    <message>
        <source>Prune the archive or enlarge the disk.</source>
        <translation>清理档案库或扩大磁盘。</translation>
    </message>
    <message>
        <source>The archive does not answer.</source>
        <translation>档案库无响应。</translation>
    </message>
    <message>
        <source>Rails are measured; their records wait on this machine&apos;s disk.</source>
        <translation>钢轨仍在测量；记录暂存于本机磁盘。</translation>
    </message>
    <message>
        <source>Check database and network; records are sent when it is back.</source>
        <translation>检查数据库和网络；恢复后将补传记录。</translation>
    </message>
    <message>
        <source>The queues of the measurement fill up.</source>
        <translation>测量队列即将填满。</translation>
    </message>
    <message>
        <source>Profiles will be dropped.</source>
        <translation>轮廓将被丢弃。</translation>
    </message>
    <message>
        <source>Close what else runs on this machine; lower the trigger rate.</source>
        <translation>关闭本机其他程序；降低触发频率。</translation>
    </message>
    <message>
        <source>A toleranced dimension is not measured while a rail passes.</source>
        <translation>钢轨通过时某个有公差的尺寸未被测量。</translation>
    </message>
    <message>
        <source>The rail cannot be judged by it.</source>
        <translation>无法据此评判钢轨。</translation>
    </message>
    <message>
        <source>Clean windows and check lasers; see Stripes for where the line is missing.</source>
        <translation>清洁窗口并检查激光器；在“激光线”中查看缺失位置。</translation>
    </message>
    <message>
        <source>The window answers slowly.</source>
        <translation>界面响应缓慢。</translation>
    </message>
    <message>
        <source>What it shows is late; the measurement goes on.</source>
        <translation>显示滞后；测量继续。</translation>
    </message>
    <message>
        <source>Close what else runs on this machine; see Diagnostics.</source>
        <translation>关闭本机其他程序；查看“诊断”。</translation>
    </message>
</context>
<context>
    <name>AlarmWords</name>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1和%2</translation>
    </message>
    <message>
        <source>Rail %1 out of tolerance: %2</source>
        <translation>钢轨 %1 超差：%2</translation>
    </message>
    <message>
        <source>Camera %1 lost</source>
        <translation>相机 %1 丢失</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>Dimension</name>
    <message>
        <source>Rail height</source>
        <translation>轨高</translation>
    </message>
    <message>
        <source>Rail flange height</source>
        <translation>鱼尾面高度</translation>
    </message>
    <message>
        <source>Foot width</source>
        <translation>轨底宽</translation>
    </message>
    <message>
        <source>Head form</source>
        <translation>轨头形状</translation>
    </message>
    <message>
        <source>Head width</source>
        <translation>轨头宽</translation>
    </message>
    <message>
        <source>Head width (AREMA)</source>
        <translation>轨头宽（AREMA）</translation>
    </message>
    <message>
        <source>Foot thickness left</source>
        <translation>左轨底厚</translation>
    </message>
    <message>
        <source>Foot thickness right</source>
        <translation>右轨底厚</translation>
    </message>
    <message>
        <source>Rail asymmetry left</source>
        <translation>左不对称</translation>
    </message>
    <message>
        <source>Rail asymmetry right</source>
        <translation>右不对称</translation>
    </message>
    <message>
        <source>Web thickness</source>
        <translation>轨腰厚</translation>
    </message>
    <message>
        <source>Head radius</source>
        <translation>轨头半径</translation>
    </message>
    <message>
        <source>Foot concavity</source>
        <translation>轨底凹度</translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>Good</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>近限</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>超差</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>无限值</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>未测</translation>
    </message>
    <message>
        <source>not measured, because %1</source>
        <translation>未测，原因：%1</translation>
    </message>
    <message>
        <source>%1 above the limit</source>
        <translation>高于限值 %1</translation>
    </message>
    <message>
        <source>%1 below the limit</source>
        <translation>低于限值 %1</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>超差</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>No points</source>
        <translation>无点</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>No rail found</source>
        <translation>未找到钢轨</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>已测</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Model %1 (approximate)</source>
        <translation>模型 %1（近似）</translation>
    </message>
    <message>
        <source>Model %1 (invented)</source>
        <translation>模型 %1（虚构）</translation>
    </message>
    <message>
        <source>Model %1</source>
        <translation>模型 %1</translation>
    </message>
    <message>
        <source>Camera 1</source>
        <translation>相机 1</translation>
    </message>
    <message>
        <source>deviation %1 %2, ×%3</source>
        <translation>偏差 %1 %2，×%3</translation>
    </message>
    <message>
        <source>Rail %1</source>
        <translation>钢轨 %1</translation>
    </message>
    <message>
        <source>Rail profile report</source>
        <translation>钢轨轮廓报告</translation>
    </message>
    <message>
        <source>%1   recipe %2   calibration %3</source>
        <translation>%1   配方 %2   标定 %3</translation>
    </message>
    <message>
        <source>mm. s: standard deviation along the rail; u, U: standard and expanded uncertainty of one profile; Exc.: stretches out of tolerance.</source>
        <translation>单位 mm。s：沿轨长标准差；u、U：单个轮廓的标准与扩展不确定度；超差：超差段数。</translation>
    </message>
    <message>
        <source>Profile at %1 m</source>
        <translation>%1 m 处轮廓</translation>
    </message>
    <message>
        <source>Dimensions along the rail, mm over m</source>
        <translation>沿轨长尺寸，mm 对 m</translation>
    </message>
    <message>
        <source>mean of a stretch</source>
        <translation>区段均值</translation>
    </message>
    <message>
        <source>smallest to largest value of the stretch</source>
        <translation>区段最小至最大值</translation>
    </message>
    <message>
        <source>expected value</source>
        <translation>期望值</translation>
    </message>
    <message>
        <source>limits; the ground outside is grey</source>
        <translation>限值；界外底色为灰</translation>
    </message>
    <message>
        <source>exception, with its square</source>
        <translation>超差段，带方块</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>超差段</translation>
    </message>
    <message>
        <source>Exceptions: none</source>
        <translation>超差段：无</translation>
    </message>
    <message>
        <source> (continued)</source>
        <translation>（续）</translation>
    </message>
    <message>
        <source>the first %1 of %2</source>
        <translation>前 %1 个，共 %2 个</translation>
    </message>
    <message>
        <source>from m</source>
        <translation>起 m</translation>
    </message>
    <message>
        <source>to m</source>
        <translation>止 m</translation>
    </message>
    <message>
        <source>length m</source>
        <translation>长度 m</translation>
    </message>
    <message>
        <source>worst mm</source>
        <translation>最差 mm</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>beyond limit</source>
        <translation>超限</translation>
    </message>
    <message>
        <source>Triggers</source>
        <translation>触发</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>已见</translation>
    </message>
    <message>
        <source>measured: complete, four contours</source>
        <translation>已测：完整，四段轮廓</translation>
    </message>
    <message>
        <source>incomplete: a camera or the registration was missing</source>
        <translation>不完整：缺少相机或配准</translation>
    </message>
    <message>
        <source>lost: no profile</source>
        <translation>丢失：无轮廓</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>This section is invented: not for acceptance.</source>
        <translation>该轨型为虚构：不用于验收。</translation>
    </message>
    <message>
        <source>This section is approximate: not for acceptance.</source>
        <translation>该轨型为近似：不用于验收。</translation>
    </message>
    <message>
        <source>profile at %1 m</source>
        <translation>%1 m 处轮廓</translation>
    </message>
    <message>
        <source> and </source>
        <translation>和</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>名义值</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>Exc.</source>
        <translation>超差</translation>
    </message>
    <message>
        <source>max %1</source>
        <translation>最大 %1</translation>
    </message>
    <message>
        <source>min %1</source>
        <translation>最小 %1</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>钢轨</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>炉号</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>轨型</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>轮廓数</translation>
    </message>
    <message>
        <source>Rail temperature</source>
        <translation>钢轨温度</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Measured (UTC)</source>
        <translation>测量时间（UTC）</translation>
    </message>
    <message>
        <source>Written (UTC)</source>
        <translation>编写时间（UTC）</translation>
    </message>
    <message>
        <source>Measured (local)</source>
        <translation>测量时间（本地）</translation>
    </message>
    <message>
        <source>Written (local)</source>
        <translation>编写时间（本地）</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>No limits to judge by</source>
        <translation>无判定限值</translation>
    </message>
    <message>
        <source>Not valid</source>
        <translation>无效</translation>
    </message>
    <message>
        <source> out of tolerance</source>
        <translation>超差</translation>
    </message>
    <message>
        <source> from %1 to %2 m</source>
        <translation>，%1 至 %2 m</translation>
    </message>
    <message>
        <source> in %1 stretches, the first at %2 m</source>
        <translation>，共 %1 段，首段在 %2 m</translation>
    </message>
    <message>
        <source> not measured</source>
        <translation>未测</translation>
    </message>
    <message>
        <source> not measured, because %1</source>
        <translation>未测，原因：%1</translation>
    </message>
    <message>
        <source> near limit</source>
        <translation>近限</translation>
    </message>
    <message>
        <source>%1 toleranced dimensions within their limits over %2 m</source>
        <translation>%1 个有公差的尺寸在 %2 m 内合格</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Not measured, because %1</source>
        <translation>未测，原因：%1</translation>
    </message>
    <message>
        <source>Lengths refer to 15 °C. U is the expanded uncertainty with k = 2; a value nearer to a limit than U is near limit: it cannot be decided.</source>
        <translation>长度以 15 °C 为准。U 为扩展不确定度（k = 2）；距限值小于 U 的值为近限：无法判定。</translation>
    </message>
    <message>
        <source>mm at 15 °C</source>
        <translation>mm，15 °C</translation>
    </message>
    <message>
        <source>Before registration</source>
        <translation>配准前</translation>
    </message>
    <message>
        <source>across %1, up %2 %3, turned %4°</source>
        <translation>横向 %1，向上 %2 %3，转动 %4°</translation>
    </message>
    <message>
        <source>As seen</source>
        <translation>所见</translation>
    </message>
    <message>
        <source>Registered</source>
        <translation>已配准</translation>
    </message>
</context>
<context>
    <name>Engine</name>
    <message>
        <source>wrong section: looks like %1 rather than %2</source>
        <translation>轨型错误：像 %1 而非 %2</translation>
    </message>
    <message>
        <source>wrong section: looks like %1</source>
        <translation>轨型错误：像 %1</translation>
    </message>
    <message>
        <source>not registered: %1</source>
        <translation>未配准：%1</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>未配准</translation>
    </message>
    <message>
        <source>looks like %1</source>
        <translation>看似 %1</translation>
    </message>
    <message>
        <source>the points do not agree with %1: %2 lie on it, rms %3 mm; another rail, badly worn, or not a rail?</source>
        <translation>点与 %1 不符：%2 落在其上，均方根 %3 mm；其他轨型、严重磨损，或非钢轨？</translation>
    </message>
    <message>
        <source>the points do not agree with %1</source>
        <translation>点与 %1 不符</translation>
    </message>
    <message>
        <source>the section has no web</source>
        <translation>该轨型无轨腰</translation>
    </message>
    <message>
        <source>the points do not determine a pose</source>
        <translation>点不足以确定位姿</translation>
    </message>
    <message>
        <source>the foot edge is not upright</source>
        <translation>轨底边缘不竖直</translation>
    </message>
    <message>
        <source>the crown is flat</source>
        <translation>轨顶为平面</translation>
    </message>
    <message>
        <source>points do not reach x = %1 from the axis</source>
        <translation>点未达到距轴线 x = %1 处</translation>
    </message>
    <message>
        <source>points do not reach the crown on the axis</source>
        <translation>点未达到轴线上的轨顶</translation>
    </message>
    <message>
        <source>points do not reach %1 above the base line</source>
        <translation>点未达到基线以上 %1</translation>
    </message>
    <message>
        <source>not defined on this section</source>
        <translation>该轨型未定义</translation>
    </message>
    <message>
        <source>no point is near the outline of %1</source>
        <translation>没有点靠近 %1 的轮廓</translation>
    </message>
    <message>
        <source>no base line: %1</source>
        <translation>无基线：%1</translation>
    </message>
    <message>
        <source>measurement failed</source>
        <translation>测量失败</translation>
    </message>
    <message>
        <source>extraction failed</source>
        <translation>提取失败</translation>
    </message>
    <message>
        <source>translation failed</source>
        <translation>转换失败</translation>
    </message>
    <message>
        <source>the profile is not registered</source>
        <translation>轮廓未配准</translation>
    </message>
    <message>
        <source>no points on %1</source>
        <translation>%1 上无点</translation>
    </message>
    <message>
        <source>only %1 point on %2, %3 are needed</source>
        <translation>%2 上仅 %1 个点，需要 %3 个</translation>
    </message>
    <message>
        <source>only %1 points on %2, %3 are needed</source>
        <translation>%2 上仅 %1 个点，需要 %3 个</translation>
    </message>
    <message>
        <source>only %1 points, at least %2 are needed</source>
        <translation>仅 %1 个点，至少需要 %2 个</translation>
    </message>
    <message>
        <source>the points on %1 make no curve</source>
        <translation>%1 上的点不构成曲线</translation>
    </message>
    <message>
        <source>%1 is not fitted</source>
        <translation>%1 未拟合</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>无点</translation>
    </message>
    <message>
        <source>no profiles</source>
        <translation>无轮廓</translation>
    </message>
    <message>
        <source>no frames</source>
        <translation>无帧</translation>
    </message>
    <message>
        <source>no frame</source>
        <translation>无帧</translation>
    </message>
    <message>
        <source>frame lost</source>
        <translation>帧丢失</translation>
    </message>
    <message>
        <source>repeated frame</source>
        <translation>帧重复</translation>
    </message>
    <message>
        <source>late frame</source>
        <translation>帧迟到</translation>
    </message>
    <message>
        <source>too late</source>
        <translation>过晚</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>source failed</source>
        <translation>图像源故障</translation>
    </message>
    <message>
        <source>queue overflow</source>
        <translation>队列溢出</translation>
    </message>
    <message>
        <source>outside of a rail</source>
        <translation>不在钢轨上</translation>
    </message>
    <message>
        <source>missed by all cameras</source>
        <translation>所有相机均错过</translation>
    </message>
    <message>
        <source>%1 from %2 m</source>
        <translation>%1，自 %2 m 起</translation>
    </message>
    <message>
        <source>camera %1: %2</source>
        <translation>相机 %1：%2</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>rail %1</source>
        <translation>钢轨 %1</translation>
    </message>
    <message>
        <source>line</source>
        <translation>产线</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>archive</source>
        <translation>档案库</translation>
    </message>
    <message>
        <source>pipeline</source>
        <translation>处理流水线</translation>
    </message>
    <message>
        <source>window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>disk</source>
        <translation>磁盘</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>range finders</source>
        <translation>测距仪</translation>
    </message>
    <message>
        <source>rail %1 has passed: %2</source>
        <translation>钢轨 %1 已通过：%2</translation>
    </message>
    <message>
        <source>the line was started</source>
        <translation>产线已启动</translation>
    </message>
    <message>
        <source>the line was stopped</source>
        <translation>产线已停止</translation>
    </message>
    <message>
        <source>%1 signed in</source>
        <translation>%1 已登录</translation>
    </message>
    <message>
        <source>%1 signed out</source>
        <translation>%1 已退出</translation>
    </message>
    <message>
        <source>good</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>near limit</source>
        <translation>近限</translation>
    </message>
    <message>
        <source>out of tolerance</source>
        <translation>超差</translation>
    </message>
    <message>
        <source>no limits</source>
        <translation>无限值</translation>
    </message>
    <message>
        <source>not valid</source>
        <translation>无效</translation>
    </message>
    <message>
        <source>is shorter than %1 characters</source>
        <translation>少于 %1 个字符</translation>
    </message>
    <message>
        <source>the old one is wrong</source>
        <translation>旧密码错误</translation>
    </message>
    <message>
        <source>too many wrong ones; locked until %1</source>
        <translation>错误过多；锁定至 %1</translation>
    </message>
    <message>
        <source>needs a reason; say why</source>
        <translation>需要说明原因</translation>
    </message>
    <message>
        <source>an entry needs who and what</source>
        <translation>条目需注明何人何事</translation>
    </message>
    <message>
        <source>password</source>
        <translation>密码</translation>
    </message>
    <message>
        <source>is no user here</source>
        <translation>此处无此用户</translation>
    </message>
    <message>
        <source>is longer than 1024 bytes</source>
        <translation>超过 1024 字节</translation>
    </message>
    <message>
        <source>a name has 1 to 64 characters</source>
        <translation>姓名须为 1 至 64 个字符</translation>
    </message>
    <message>
        <source>the first user must be an administrator</source>
        <translation>首位用户须为管理员</translation>
    </message>
    <message>
        <source>is a user already</source>
        <translation>已是用户</translation>
    </message>
    <message>
        <source>is the last administrator; make another one first</source>
        <translation>是最后一位管理员；请先指定另一位</translation>
    </message>
    <message>
        <source>there is none</source>
        <translation>没有</translation>
    </message>
    <message>
        <source>no archive was asked for (--archive)</source>
        <translation>未指定档案库（--archive）</translation>
    </message>
    <message>
        <source>exact (virtual rig)</source>
        <translation>精确（虚拟装置）</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>图纸</translation>
    </message>
    <message>
        <source>none (generated numbers)</source>
        <translation>无（生成数值）</translation>
    </message>
</context>
<context>
    <name>Judgement</name>
    <message>
        <source>from %1 on</source>
        <translation>自 %1 起</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>%1 %2 above the limit %3</source>
        <translation>%1 高于限值 %2，%3</translation>
    </message>
    <message>
        <source>%1 %2 below the limit %3</source>
        <translation>%1 低于限值 %2，%3</translation>
    </message>
    <message>
        <source>%1 beyond the limit %2</source>
        <translation>%1 超限，%2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1和%2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>camera %1 lost</source>
        <translation>相机 %1 丢失</translation>
    </message>
    <message>
        <source>cameras %1 lost</source>
        <translation>相机 %1 丢失</translation>
    </message>
    <message>
        <source>%1 dimensions</source>
        <translation>%1 个尺寸</translation>
    </message>
    <message>
        <source>Not valid</source>
        <translation>无效</translation>
    </message>
    <message>
        <source>%1 not measured from %2 on: %3</source>
        <translation>%1 自 %2 起未测：%3</translation>
    </message>
    <message>
        <source>%1 near limit</source>
        <translation>%1 近限</translation>
    </message>
    <message>
        <source>single profiles outside the limits</source>
        <translation>个别轮廓超出限值</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>超差</translation>
    </message>
    <message>
        <source>%1 %2 inside the limit, closer than U</source>
        <translation>%1 距限值 %2，小于 U</translation>
    </message>
    <message>
        <source>%1 %2 outside the limit, by less than U</source>
        <translation>%1 超限 %2，小于 U</translation>
    </message>
    <message>
        <source>within the guard band earlier on this rail</source>
        <translation>此钢轨先前处于保护带内</translation>
    </message>
    <message>
        <source>%1 within the guard band earlier on this rail</source>
        <translation>%1 在此钢轨先前处于保护带内</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>近限</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>%1 dimensions within limits up to %2</source>
        <translation>至 %2，%1 个尺寸均在限值内</translation>
    </message>
    <message>
        <source>Waiting for a rail</source>
        <translation>等待钢轨</translation>
    </message>
    <message>
        <source>the gauge is ready; values appear with the head of the rail</source>
        <translation>测量仪就绪；钢轨头部到达后显示数值</translation>
    </message>
    <message>
        <source>the line is not running: Ctrl+R starts it</source>
        <translation>产线未运行：按 Ctrl+R 启动</translation>
    </message>
    <message>
        <source>No limits</source>
        <translation>无限值</translation>
    </message>
    <message>
        <source>the recipe gives no tolerance to any dimension</source>
        <translation>配方未给任何尺寸规定公差</translation>
    </message>
    <message>
        <source>this rail was not measured completely</source>
        <translation>此钢轨未完整测量</translation>
    </message>
    <message>
        <source>%1 not measured on enough of this rail</source>
        <translation>%1 在此钢轨上的测量长度不足</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>待测</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>测量中</translation>
    </message>
    <message>
        <source>No profiles</source>
        <translation>无轮廓</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>no profiles since %1, %2 ago. Hold this rail.</source>
        <translation>自 %1 起无轮廓，已 %2。扣留此钢轨。</translation>
    </message>
    <message>
        <source>held: last profile at %1, %2 ago</source>
        <translation>保持：最后轮廓在 %1，%2 前</translation>
    </message>
    <message>
        <source>%1 of %2 cameras, %3 profiles/s</source>
        <translation>%1/%2 台相机，%3 轮廓/s</translation>
    </message>
    <message>
        <source>no profiles for %1</source>
        <translation>已 %1 无轮廓</translation>
    </message>
    <message>
        <source>calibration %1</source>
        <translation>标定：%1</translation>
    </message>
    <message>
        <source>Not trusted</source>
        <translation>不可信</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>无数据</translation>
    </message>
    <message>
        <source>no profile yet</source>
        <translation>尚无轮廓</translation>
    </message>
    <message>
        <source>the line is not running</source>
        <translation>产线未运行</translation>
    </message>
    <message>
        <source>Degraded</source>
        <translation>降级</translation>
    </message>
    <message>
        <source>%1 of %2 incomplete</source>
        <translation>%2 中 %1 不完整</translation>
    </message>
    <message>
        <source>Trusted</source>
        <translation>可信</translation>
    </message>
    <message>
        <source>The line is stopped: Ctrl+R starts it</source>
        <translation>产线已停：按 Ctrl+R 启动</translation>
    </message>
    <message>
        <source>Ready for the next rail</source>
        <translation>可测下一根钢轨</translation>
    </message>
    <message>
        <source>No alarm on this rail</source>
        <translation>此钢轨无报警</translation>
    </message>
</context>
<context>
    <name>Page</name>
    <message>
        <source>Monitor</source>
        <translation>监视</translation>
    </message>
    <message>
        <source>Stripes</source>
        <translation>激光线</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>图表</translation>
    </message>
    <message>
        <source>Rails</source>
        <translation>钢轨</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>诊断</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
</context>
<context>
    <name>RecipeSetting</name>
    <message>
        <source>Section</source>
        <translation>轨型</translation>
    </message>
    <message>
        <source>Profile class</source>
        <translation>轮廓等级</translation>
    </message>
    <message>
        <source>Straightness class</source>
        <translation>平直度等级</translation>
    </message>
    <message>
        <source>RFH: distance from the axis, mm</source>
        <translation>RFH：距轴线距离，mm</translation>
    </message>
    <message>
        <source>HF: half width of the crown, mm</source>
        <translation>HF：轨顶半宽，mm</translation>
    </message>
    <message>
        <source>HW: depth below the crown, mm</source>
        <translation>HW：轨顶以下深度，mm</translation>
    </message>
    <message>
        <source>HWA: the AREMA depth, mm</source>
        <translation>HWA：AREMA 深度，mm</translation>
    </message>
    <message>
        <source>FT: inside the foot edges, mm</source>
        <translation>FT：轨底边缘向内，mm</translation>
    </message>
    <message>
        <source>RAS: depth below the crown, mm</source>
        <translation>RAS：轨顶以下深度，mm</translation>
    </message>
    <message>
        <source>WT: height, mm (none: thinnest)</source>
        <translation>WT：高度，mm（无：最薄处）</translation>
    </message>
    <message>
        <source>Base line: inside the foot edges, mm</source>
        <translation>基线：轨底边缘向内，mm</translation>
    </message>
    <message>
        <source>Line: smoothing σ, px</source>
        <translation>线：平滑 σ，px</translation>
    </message>
    <message>
        <source>Line: low threshold, DN</source>
        <translation>线：低阈值，DN</translation>
    </message>
    <message>
        <source>Line: high threshold, DN</source>
        <translation>线：高阈值，DN</translation>
    </message>
    <message>
        <source>Line: longest gap bridged, px</source>
        <translation>线：最大桥接间隙，px</translation>
    </message>
    <message>
        <source>Line: largest angle joined, °</source>
        <translation>线：最大连接角度，°</translation>
    </message>
    <message>
        <source>Line: shortest kept, points</source>
        <translation>线：最短保留，点</translation>
    </message>
    <message>
        <source>Line: blocks before overload</source>
        <translation>线：过载前块数</translation>
    </message>
    <message>
        <source>Line: pull of bends taken off</source>
        <translation>线：扣除弯曲处偏移</translation>
    </message>
    <message>
        <source>Registration: scale at first, mm</source>
        <translation>配准：初始尺度，mm</translation>
    </message>
    <message>
        <source>Registration: scale with a start, mm</source>
        <translation>配准：有初值时尺度，mm</translation>
    </message>
    <message>
        <source>Registration: inlier below, mm</source>
        <translation>配准：内点小于，mm</translation>
    </message>
    <message>
        <source>Registration: points used within, mm</source>
        <translation>配准：用点距离以内，mm</translation>
    </message>
    <message>
        <source>Registration: fails above rms, mm</source>
        <translation>配准：均方根超过即失败，mm</translation>
    </message>
    <message>
        <source>Registration: fails below share</source>
        <translation>配准：比例低于即失败</translation>
    </message>
    <message>
        <source>Measuring: ends left out, mm</source>
        <translation>测量：端部舍去，mm</translation>
    </message>
    <message>
        <source>Measuring: least points</source>
        <translation>测量：最少点数</translation>
    </message>
    <message>
        <source>Measuring: expansion, 1/K</source>
        <translation>测量：膨胀系数，1/K</translation>
    </message>
    <message>
        <source>Measuring: hottest rail, °C</source>
        <translation>测量：最高钢轨温度，°C</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>%1: limits, mm</source>
        <translation>%1：限值，mm</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>不评判</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>不大于 %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>不小于 %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
</context>
<context>
    <name>Role</name>
    <message>
        <source>Operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>Technician</source>
        <translation>技术员</translation>
    </message>
    <message>
        <source>QA</source>
        <translation>质检</translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation>管理员</translation>
    </message>
</context>
<context>
    <name>StudyReport</name>
    <message>
        <source>no outlier</source>
        <translation>无离群值</translation>
    </message>
    <message>
        <source>straggler (5 %)</source>
        <translation>歧离值（5 %）</translation>
    </message>
    <message>
        <source>outlier (1 %)</source>
        <translation>离群值（1 %）</translation>
    </message>
    <message>
        <source>%1: %2, critical %3 at 1 %</source>
        <translation>%1：%2，1 % 临界值 %3</translation>
    </message>
    <message>
        <source>Mean range of the runs, mm, per %1 m (Table VI)</source>
        <translation>各次平均极差，mm，每 %1 m（表 VI）</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>share of T, %</source>
        <translation>占 T，%</translation>
    </message>
    <message>
        <source>Errors against the reference, mm (Table V)</source>
        <translation>相对参考值的误差，mm（表 V）</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>偏倚</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>largest, %</source>
        <translation>最大，%</translation>
    </message>
    <message>
        <source>E_n above 1</source>
        <translation>E_n 大于 1</translation>
    </message>
    <message>
        <source>%1: values of the runs</source>
        <translation>%1：各次数值</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>长度，m</translation>
    </message>
    <message>
        <source>%1: range of the runs</source>
        <translation>%1：各次极差</translation>
    </message>
    <message>
        <source>%1: error at each position</source>
        <translation>%1：各位置误差</translation>
    </message>
    <message>
        <source>mean of the runs</source>
        <translation>各次均值</translation>
    </message>
    <message>
        <source>No verdict</source>
        <translation>无判定</translation>
    </message>
    <message>
        <source>no dimension has both a tolerance and figures</source>
        <translation>没有既有公差又有数据的尺寸</translation>
    </message>
    <message>
        <source>Repeatable</source>
        <translation>可重复</translation>
    </message>
    <message>
        <source>Not repeatable</source>
        <translation>不可重复</translation>
    </message>
    <message>
        <source>%1 uses the largest share of its tolerance, %2; allowed are %3 %</source>
        <translation>%1 占其公差的比例最大，为 %2；允许 %3 %</translation>
    </message>
    <message>
        <source>uncertainties of values and reference are both needed for E_n; the figures stand by themselves</source>
        <translation>计算 E_n 需要数值和参考值两者的不确定度；此处仅列数据</translation>
    </message>
    <message>
        <source>Agrees</source>
        <translation>一致</translation>
    </message>
    <message>
        <source>Does not agree</source>
        <translation>不一致</translation>
    </message>
    <message>
        <source>worst is %1: E n above 1 in %2 of its %3 values; chance allows %4</source>
        <translation>最差为 %1：其 %3 个值中 %2 的 E n 大于 1；偶然允许 %4</translation>
    </message>
    <message>
        <source>Runs and positions</source>
        <translation>次数与位置数</translation>
    </message>
    <message>
        <source>Repeatability s r</source>
        <translation>重复性 s r</translation>
    </message>
    <message>
        <source>its 95 % interval</source>
        <translation>其 95 % 区间</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Limit r = 2.8 s r</source>
        <translation>重复性限 r = 2.8 s r</translation>
    </message>
    <message>
        <source>Mean and largest range</source>
        <translation>平均与最大极差</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1和%2</translation>
    </message>
    <message>
        <source>s from the range</source>
        <translation>由极差求得的 s</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>自相关</translation>
    </message>
    <message>
        <source>Left out: a run lacks them</source>
        <translation>略去：有一次测量缺失</translation>
    </message>
    <message>
        <source>Grubbs, means of the runs</source>
        <translation>格拉布斯检验，各次均值</translation>
    </message>
    <message>
        <source>Cochran, scatter of the runs</source>
        <translation>科克伦检验，各次离散</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>偏倚</translation>
    </message>
    <message>
        <source>RMS error</source>
        <translation>均方根误差</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>最大误差</translation>
    </message>
    <message>
        <source>in % of the reference</source>
        <translation>占参考值的 %</translation>
    </message>
    <message>
        <source>Limits of agreement</source>
        <translation>一致性界限</translation>
    </message>
    <message>
        <source>interval of the lower</source>
        <translation>下界的区间</translation>
    </message>
    <message>
        <source>interval of the upper</source>
        <translation>上界的区间</translation>
    </message>
    <message>
        <source>Largest E n</source>
        <translation>最大 E n</translation>
    </message>
    <message>
        <source>E n above 1</source>
        <translation>E n 大于 1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Repeatability study</source>
        <translation>重复性研究</translation>
    </message>
    <message>
        <source>Accuracy study</source>
        <translation>准确度研究</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>测次</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>轨型</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>means over %1 m</source>
        <translation>%1 m 均值</translation>
    </message>
    <message>
        <source>single profiles</source>
        <translation>单个轮廓</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考值</translation>
    </message>
    <message>
        <source>Runs: %1.</source>
        <translation>测次：%1。</translation>
    </message>
    <message>
        <source>Conditions: %1.</source>
        <translation>条件：%1。</translation>
    </message>
    <message>
        <source>%1 over the length, as Fig. 9</source>
        <translation>%1 沿长度，同图 9</translation>
    </message>
    <message>
        <source>%1 against its reference</source>
        <translation>%1 与其参考值对比</translation>
    </message>
    <message>
        <source>Figures of %1</source>
        <translation>%1 的数据</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmCard</name>
    <message>
        <source>comes and goes</source>
        <translation>时有时无</translation>
    </message>
    <message>
        <source>on for more than a day</source>
        <translation>持续超过一天</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>已消失</translation>
    </message>
    <message>
        <source>acknowledged by %1</source>
        <translation>由 %1 确认</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n 个报警</numerusform>
        </translation>
    </message>
    <message>
        <source>Priority %1</source>
        <translation>优先级 %1</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Consequence</source>
        <translation>后果</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>措施</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>Acknowledge: %1</source>
        <translation>确认：%1</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmHistoryPanel</name>
    <message>
        <source>What happened</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Show the alarms that came and went</source>
        <translation>显示历史报警</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Show events</source>
        <translation>显示事件</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>导出为 CSV</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>出现</translation>
    </message>
    <message>
        <source>Went</source>
        <translation>消失</translation>
    </message>
    <message>
        <source>Lasted</source>
        <translation>持续</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>详情</translation>
    </message>
    <message>
        <source>By</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Alarms that came and went, newest first</source>
        <translation>历史报警，最新在前</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Events, newest first</source>
        <translation>事件，最新在前</translation>
    </message>
    <message>
        <source>still on</source>
        <translation>仍存在</translation>
    </message>
    <message>
        <source>shelved: %1</source>
        <translation>已搁置：%1</translation>
    </message>
    <message>
        <source>nobody yet</source>
        <translation>尚无人</translation>
    </message>
    <message>
        <source>no alarm so far</source>
        <translation>至今无报警</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n 个报警</numerusform>
        </translation>
    </message>
    <message>
        <source>no event so far</source>
        <translation>至今无事件</translation>
    </message>
    <message numerus="yes">
        <source>%n event(s)</source>
        <translation>
            <numerusform>%n 个事件</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>已写入 %1</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
    <message>
        <source>program ended</source>
        <translation>程序结束</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmLine</name>
    <message>
        <source>Alarm, priority %1: %2. %3</source>
        <translation>报警，优先级 %1：%2。%3</translation>
    </message>
    <message>
        <source>1 of %1</source>
        <translation>1 / %1</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) acknowledged, still on</source>
        <translation>
            <numerusform>%n 个报警已确认，仍存在</numerusform>
        </translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>Acknowledge the shown alarm</source>
        <translation>确认所示报警</translation>
    </message>
    <message>
        <source>Acknowledge the shown alarm (Ctrl+A)</source>
        <translation>确认所示报警（Ctrl+A）</translation>
    </message>
</context>
<context>
    <name>vignole::AlarmsPage</name>
    <message>
        <source>Active</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Acknowledge page</source>
        <translation>确认本页</translation>
    </message>
    <message>
        <source>Acknowledge all that are shown</source>
        <translation>确认所有显示的报警</translation>
    </message>
    <message>
        <source>Acknowledge all that are shown (Ctrl+Shift+A)</source>
        <translation>确认所有显示的报警（Ctrl+Shift+A）</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>10 min</source>
        <translation>10 分钟</translation>
    </message>
    <message>
        <source>Hour</source>
        <translation>小时</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>天</translation>
    </message>
    <message>
        <source>Shelve</source>
        <translation>搁置</translation>
    </message>
    <message>
        <source>hides an alarm for a while</source>
        <translation>暂时隐藏报警</translation>
    </message>
    <message>
        <source>Alarm to shelve</source>
        <translation>待搁置报警</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Reason for shelving</source>
        <translation>搁置原因</translation>
    </message>
    <message>
        <source>For how long</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Shelved</source>
        <translation>已搁置</translation>
    </message>
    <message>
        <source>comes back by itself</source>
        <translation>自动恢复</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Bring back the chosen alarm</source>
        <translation>恢复所选报警</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>截至</translation>
    </message>
    <message>
        <source>Shelved alarms</source>
        <translation>已搁置的报警</translation>
    </message>
    <message>
        <source>An operator may shelve for %1 minutes at most.</source>
        <translation>操作员最多可搁置 %1 分钟。</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n 个报警</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not acknowledged</source>
        <translation>
            <numerusform>%n 个未确认</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is wrong. Alarms appear here with their cause, their consequence and what to do.</source>
        <translation>一切正常。报警在此显示其原因、后果和处理措施。</translation>
    </message>
    <message>
        <source>since the program started</source>
        <translation>自程序启动以来</translation>
    </message>
    <message>
        <source>Flood: more than 10 alarms in 10 minutes. Look for one cause behind them.</source>
        <translation>报警泛滥：10 分钟内超过 10 个报警。请查找共同原因。</translation>
    </message>
    <message>
        <source>Target: below 1 in 10 minutes; above 10 it is a flood.</source>
        <translation>目标：10 分钟内少于 1 个；超过 10 个即泛滥。</translation>
    </message>
    <message>
        <source>alarms in 10 minutes</source>
        <translation>10 分钟内报警数</translation>
    </message>
    <message>
        <source>Health of the alarms</source>
        <translation>报警健康度</translation>
    </message>
    <message>
        <source>flood: grouped by rule</source>
        <translation>泛滥：按规则分组</translation>
    </message>
    <message>
        <source>Mean per 10 minutes</source>
        <translation>每 10 分钟平均</translation>
    </message>
    <message>
        <source>%1, target below 1</source>
        <translation>%1，目标小于 1</translation>
    </message>
    <message>
        <source>Floods</source>
        <translation>泛滥次数</translation>
    </message>
    <message>
        <source>Comes and goes</source>
        <translation>时有时无</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>On for more than a day</source>
        <translation>持续超过一天</translation>
    </message>
    <message>
        <source>Shelving needs a reason.</source>
        <translation>搁置需说明原因。</translation>
    </message>
</context>
<context>
    <name>vignole::AuditPanel</name>
    <message>
        <source>Audit trail</source>
        <translation>审计记录</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>何人</translation>
    </message>
    <message>
        <source>What</source>
        <translation>何事</translation>
    </message>
    <message>
        <source>Of what</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Audit trail, newest first</source>
        <translation>审计记录，最新在前</translation>
    </message>
    <message>
        <source>Check the chain</source>
        <translation>校验链</translation>
    </message>
    <message>
        <source>Check that no entry was changed, put in or taken out</source>
        <translation>校验没有条目被更改、插入或删除</translation>
    </message>
    <message>
        <source>The audit trail is shown to QA and administrators who have signed in.</source>
        <translation>审计记录仅向已登录的质检和管理员显示。</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s), the newest first</source>
        <translation>
            <numerusform>%n 条，最新在前</numerusform>
        </translation>
    </message>
    <message>
        <source>checking …</source>
        <translation>校验中…</translation>
    </message>
    <message>
        <source>The chain is whole: no entry was changed, put in or taken out.</source>
        <translation>链完整：没有条目被更改、插入或删除。</translation>
    </message>
    <message>
        <source>The chain is broken: %1</source>
        <translation>链已断：%1</translation>
    </message>
</context>
<context>
    <name>vignole::CalibrationDesk</name>
    <message>
        <source>Calibrations are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>标定未保存：%1。请带档案库启动程序（--archive FILE）。</translation>
    </message>
    <message>
        <source>Calibrating is the technician&apos;s: sign in as technician or QA (Settings, F10).</source>
        <translation>标定由技术员进行：请以技术员或质检登录（设置，F10）。</translation>
    </message>
    <message>
        <source>There is no archive, so a calibration could neither be kept nor reverted: start the program with --archive FILE.</source>
        <translation>没有档案库，标定既不能保存也不能恢复：请用 --archive FILE 启动程序。</translation>
    </message>
    <message>
        <source>Another calibration needs a reason.</source>
        <translation>更换标定需说明原因。</translation>
    </message>
</context>
<context>
    <name>vignole::CalibrationOverview</name>
    <message>
        <source>In force</source>
        <translation>现行</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>What it is worth</source>
        <translation>标定不确定度</translation>
    </message>
    <message>
        <source>Calibrations kept</source>
        <translation>已保存的标定</translation>
    </message>
    <message>
        <source>choose one to compare it with the one in force</source>
        <translation>选择一个，与现行标定对比</translation>
    </message>
    <message>
        <source>Range finders…</source>
        <translation>测距仪…</translation>
    </message>
    <message>
        <source>Calibrate the range finders with the pin plate</source>
        <translation>用销钉板标定测距仪</translation>
    </message>
    <message>
        <source>Lens of a camera…</source>
        <translation>相机镜头…</translation>
    </message>
    <message>
        <source>Calibrate the lens of a camera with the flat target</source>
        <translation>用平面靶标标定相机镜头</translation>
    </message>
    <message>
        <source>Encoder…</source>
        <translation>编码器…</translation>
    </message>
    <message>
        <source>Calibrate the encoder over a known length</source>
        <translation>用已知长度标定编码器</translation>
    </message>
    <message>
        <source>Reference piece…</source>
        <translation>标准件…</translation>
    </message>
    <message>
        <source>Check the calibration on a reference piece</source>
        <translation>用标准件核查标定</translation>
    </message>
    <message>
        <source>Parameter study…</source>
        <translation>参数研究…</translation>
    </message>
    <message>
        <source>Study which settings of the calibration matter</source>
        <translation>研究标定中哪些设置有影响</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>保存时间</translation>
    </message>
    <message>
        <source>By, because</source>
        <translation>人员，原因</translation>
    </message>
    <message>
        <source>What the calibration in force is worth</source>
        <translation>现行标定的不确定度</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Reason for putting it back in force</source>
        <translation>恢复启用的原因</translation>
    </message>
    <message>
        <source>Put in force</source>
        <translation>启用</translation>
    </message>
    <message>
        <source>Put the chosen calibration in force</source>
        <translation>启用所选标定</translation>
    </message>
    <message>
        <source>No calibration</source>
        <translation>无标定</translation>
    </message>
    <message>
        <source>Nothing can be measured: calibrate the range finders.</source>
        <translation>无法测量：请标定测距仪。</translation>
    </message>
    <message>
        <source>Overdue: %1. Calibrate the range finders.</source>
        <translation>已过期：%1。请标定测距仪。</translation>
    </message>
    <message numerus="yes">
        <source>Due in %n day(s).</source>
        <translation>
            <numerusform>%n 天后到期。</numerusform>
        </translation>
    </message>
    <message>
        <source>No interval is set.</source>
        <translation>未设定周期。</translation>
    </message>
    <message>
        <source>Method: %1
Made: %2
Plate: %3
Cameras: %4</source>
        <translation>方法：%1
生成：%2
标定板：%3
相机：%4</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>None is kept yet. The first is kept when a rail is measured or a wizard ends.</source>
        <translation>尚未保存标定。测量钢轨或向导完成时保存首个标定。</translation>
    </message>
    <message>
        <source>In force: %1</source>
        <translation>现行：%1</translation>
    </message>
    <message>
        <source> (cannot be read)</source>
        <translation> （无法读取）</translation>
    </message>
    <message>
        <source>of another rig</source>
        <translation>其他装置的</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>允许值</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>U of it</source>
        <translation>其 U</translation>
    </message>
    <message>
        <source>U (k = 2) in %1</source>
        <translation>U (k = 2)，%1</translation>
    </message>
    <message>
        <source>Difference: what the chosen one measures more than the one in force</source>
        <translation>差值：所选标定比现行标定多测的量</translation>
    </message>
    <message>
        <source>By the calibration alone, without the noise of the profiles</source>
        <translation>仅由标定引起，不含轮廓噪声</translation>
    </message>
    <message>
        <source>%1, too much</source>
        <translation>%1，过大</translation>
    </message>
    <message>
        <source>none stated</source>
        <translation>未给出</translation>
    </message>
    <message>
        <source>Nothing is applied before old and new are compared.</source>
        <translation>新旧对比之前不作任何应用。</translation>
    </message>
    <message>
        <source>It is of other cameras and cannot be put in force here.</source>
        <translation>属于其他相机，不能在此启用。</translation>
    </message>
    <message>
        <source>It is in force.</source>
        <translation>已启用。</translation>
    </message>
    <message>
        <source>It is in force: the line measures with it from the next rail on.</source>
        <translation>已启用：产线自下一根钢轨起用其测量。</translation>
    </message>
</context>
<context>
    <name>vignole::ChartsPage</name>
    <message>
        <source>Dimensions</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Dimension that is charted</source>
        <translation>图示尺寸</translation>
    </message>
    <message>
        <source>Rail that is charted</source>
        <translation>图示钢轨</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合</translation>
    </message>
    <message>
        <source>Whole range</source>
        <translation>全范围</translation>
    </message>
    <message>
        <source>Whole range (0)</source>
        <translation>全范围（0）</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Export the chart as picture, PDF or CSV</source>
        <translation>将图表导出为图片、PDF 或 CSV</translation>
    </message>
    <message>
        <source>Dimension along the rail</source>
        <translation>沿轨长尺寸</translation>
    </message>
    <message>
        <source>Dimension rail by rail</source>
        <translation>逐轨尺寸</translation>
    </message>
    <message>
        <source>Histogram of the rail</source>
        <translation>钢轨直方图</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>直方图</translation>
    </message>
    <message>
        <source>same scale, this rail</source>
        <translation>同一刻度，此钢轨</translation>
    </message>
    <message>
        <source>Per rail</source>
        <translation>每根钢轨</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>this rail</source>
        <translation>此钢轨</translation>
    </message>
    <message>
        <source>Figures of the rail</source>
        <translation>钢轨数据</translation>
    </message>
    <message>
        <source>Rails are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>钢轨未保存：%1。请带档案库启动程序（--archive FILE）。</translation>
    </message>
    <message>
        <source>No rail has been measured yet. Its chart appears here when it has passed.</source>
        <translation>尚未测量钢轨。钢轨通过后在此显示图表。</translation>
    </message>
    <message>
        <source>Newest rail</source>
        <translation>最新钢轨</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>长度，m</translation>
    </message>
    <message>
        <source>%1 along the rail</source>
        <translation>沿轨长 %1</translation>
    </message>
    <message>
        <source>rail %1, %2 profiles</source>
        <translation>钢轨 %1，%2 个轮廓</translation>
    </message>
    <message>
        <source>; no band: %1 of %2 other rails</source>
        <translation>；无带：其他钢轨 %1/%2</translation>
    </message>
    <message>
        <source>; band: last %1 rails, 10 to 90 %</source>
        <translation>；带：最近 %1 根钢轨，10–90 %</translation>
    </message>
    <message>
        <source>same scale, longest bar %1 %</source>
        <translation>同一刻度，最长条 %1 %</translation>
    </message>
    <message>
        <source>rail</source>
        <translation>钢轨</translation>
    </message>
    <message numerus="yes">
        <source>mean with smallest and largest value, last %n rail(s) of this section</source>
        <translation>
            <numerusform>均值及最小、最大值，该轨型最近 %n 根钢轨</numerusform>
        </translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>标准差</translation>
    </message>
    <message>
        <source>Uncertainty U (k = 2)</source>
        <translation>不确定度 U（k = 2）</translation>
    </message>
    <message>
        <source>Beyond a limit</source>
        <translation>超限</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>In the guard band</source>
        <translation>处于保护带</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>未测</translation>
    </message>
    <message>
        <source>Room to the nearer limit</source>
        <translation>距较近限值余量</translation>
    </message>
    <message>
        <source>Move over the chart or press Left and Right to read values; wheel or + and − zoom, drag moves.</source>
        <translation>在图上移动或按左右键读数；滚轮或 +、− 缩放，拖动平移。</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>not measured: %1</source>
        <translation>未测：%1</translation>
    </message>
    <message>
        <source>%1   %2 %3   U ±%4   %5 from expected   %6</source>
        <translation>%1   %2 %3   U ±%4   距期望 %5   %6</translation>
    </message>
    <message>
        <source>Export the chart</source>
        <translation>导出图表</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>已写入 %1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>无法写入 %1</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>最大</translation>
    </message>
</context>
<context>
    <name>vignole::ClosedStep</name>
    <message>
        <source>Closed while the line measures</source>
        <translation>产线测量时关闭</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>停止产线</translation>
    </message>
</context>
<context>
    <name>vignole::DiagnosticsPage</name>
    <message>
        <source>Pipeline</source>
        <translation>处理流水线</translation>
    </message>
    <message>
        <source>Every trigger accounted for</source>
        <translation>每次触发均有去向</translation>
    </message>
    <message>
        <source>since the line was started</source>
        <translation>自产线启动以来</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>计算机</translation>
    </message>
    <message>
        <source>Where every trigger went</source>
        <translation>每次触发的去向</translation>
    </message>
    <message>
        <source>Counters of the cameras</source>
        <translation>相机计数器</translation>
    </message>
    <message>
        <source>Load of the computer</source>
        <translation>计算机负载</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Frames/s</source>
        <translation>帧/s</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧数</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>held, %1 old</source>
        <translation>保持，%1 前</translation>
    </message>
    <message>
        <source>%1 profiles/s of %2 expected</source>
        <translation>%1 轮廓/s，期望 %2</translation>
    </message>
    <message>
        <source>Triggers</source>
        <translation>触发</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>已测</translation>
    </message>
    <message>
        <source>Incomplete: measured by fewer cameras</source>
        <translation>不完整：较少相机测得</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>Not accounted for</source>
        <translation>未计入</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>处理中</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>: lost</source>
        <translation>：丢失</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>磁盘</translation>
    </message>
    <message>
        <source>make room: nearly full</source>
        <translation>请腾出空间：将满</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>档案库</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>处理器</translation>
    </message>
    <message>
        <source>%1 % of one core</source>
        <translation>单核的 %1 %</translation>
    </message>
    <message numerus="yes">
        <source>%n core(s)</source>
        <translation>
            <numerusform>%n 核</numerusform>
        </translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>内存</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>屏幕</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>已写入 %1。</translation>
    </message>
    <message>
        <source>How much of the support bundle is written</source>
        <translation>支持文件写入进度</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>曝光</translation>
    </message>
    <message>
        <source>%1 profiles lost</source>
        <translation>%1 个轮廓丢失</translation>
    </message>
    <message>
        <source>%1 without points</source>
        <translation>%1 个无点</translation>
    </message>
    <message>
        <source>%1 profiles kept</source>
        <translation>%1 个轮廓已保存</translation>
    </message>
    <message>
        <source>rails are not kept</source>
        <translation>钢轨未保存</translation>
    </message>
    <message>
        <source>%1 pictures/s, %2 % of a core</source>
        <translation>%1 张图像/s，单核的 %2 %</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Not available here, because these cameras are rendered: resends, incomplete frames, timeouts, temperature.</source>
        <translation>此处不提供（相机为渲染生成）：重传、不完整帧、超时、温度。</translation>
    </message>
    <message>
        <source>%1 of %2 GB</source>
        <translation>%1 / %2 GB</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>未提供</translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s) kept</source>
        <translation>
            <numerusform>已保存 %n 根钢轨</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 MB, WAL %2 MB</source>
        <translation>%1 MB，WAL %2 MB</translation>
    </message>
    <message>
        <source>open, nothing is written</source>
        <translation>已打开，未写入</translation>
    </message>
    <message>
        <source>of %1 GB</source>
        <translation>共 %1 GB</translation>
    </message>
    <message>
        <source>p99 %1 ms</source>
        <translation>p99 %1 ms</translation>
    </message>
    <message>
        <source>p50 %1, max %2</source>
        <translation>p50 %1，最大 %2</translation>
    </message>
    <message>
        <source>window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Where the support bundle is put</source>
        <translation>支持文件的保存位置</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Support bundle…</source>
        <translation>支持文件…</translation>
    </message>
    <message>
        <source>Cancel the support bundle</source>
        <translation>取消支持文件</translation>
    </message>
    <message>
        <source>Save a support bundle</source>
        <translation>保存支持文件</translation>
    </message>
</context>
<context>
    <name>vignole::DimensionModel</name>
    <message>
        <source>Not measured</source>
        <translation>未测</translation>
    </message>
    <message>
        <source>Not measured, because %1</source>
        <translation>未测，原因：%1</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>无限值</translation>
    </message>
    <message>
        <source>limits %1 to %2</source>
        <translation>限值 %1 至 %2</translation>
    </message>
    <message>
        <source>waiting for a profile</source>
        <translation>等待轮廓</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Tolerance and guard band</source>
        <translation>公差与保护带</translation>
    </message>
    <message>
        <source>Along the rail</source>
        <translation>沿轨长</translation>
    </message>
    <message>
        <source>Not meas.</source>
        <translation>未测</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>保持</translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es) out of tolerance</source>
        <translation>
            <numerusform>%n 段超差</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 %3, deviation %4, U %5, %6</source>
        <translation>%1，%2 %3，偏差 %4，U %5，%6</translation>
    </message>
</context>
<context>
    <name>vignole::DimensionTable</name>
    <message>
        <source>Dimensions</source>
        <translation>尺寸</translation>
    </message>
</context>
<context>
    <name>vignole::DriftPanel</name>
    <message>
        <source>Health</source>
        <translation>健康度</translation>
    </message>
    <message>
        <source>seams between the cameras on every rail</source>
        <translation>每根钢轨上的相机间接缝</translation>
    </message>
    <message>
        <source>Shift of each camera, rail by rail</source>
        <translation>各相机的位移，逐轨</translation>
    </message>
    <message>
        <source>Shift of each camera since its calibration</source>
        <translation>各相机自标定以来的位移</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>位移</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Alarm above</source>
        <translation>报警限</translation>
    </message>
    <message>
        <source>No rail has passed yet. Camera drift shows in the seams of normal production, without a plate.</source>
        <translation>尚无钢轨通过。相机漂移由正常生产中的接缝显示，无需标定板。</translation>
    </message>
    <message>
        <source>Learning what the seams are like: %1 of %2 rails since this calibration came into use.</source>
        <translation>正在学习接缝状况：该标定启用以来已有 %1/%2 根钢轨。</translation>
    </message>
    <message numerus="yes">
        <source>No camera has moved: %n rail(s) watched.</source>
        <translation>
            <numerusform>没有相机移动：已监视 %n 根钢轨。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 moved</source>
        <translation>%1 已移动</translation>
    </message>
    <message>
        <source>rail</source>
        <translation>钢轨</translation>
    </message>
    <message>
        <source>shift in </source>
        <translation>位移，单位 </translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>alarm above</source>
        <translation>报警限</translation>
    </message>
</context>
<context>
    <name>vignole::EncoderPanel</name>
    <message>
        <source>Encoder</source>
        <translation>编码器</translation>
    </message>
    <message>
        <source>Motion a pulse</source>
        <translation>每脉冲位移</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>Known length, first to last reading</source>
        <translation>已知长度，首个至末个读数</translation>
    </message>
    <message>
        <source>Known length, mm</source>
        <translation>已知长度，mm</translation>
    </message>
    <message>
        <source>Its standard uncertainty</source>
        <translation>其标准不确定度</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length, mm</source>
        <translation>长度的标准不确定度，mm</translation>
    </message>
    <message>
        <source>Slip of the virtual second encoder, for training</source>
        <translation>第二虚拟编码器的打滑，供培训</translation>
    </message>
    <message>
        <source>Slip of the virtual second encoder, ppm</source>
        <translation>第二虚拟编码器的打滑，ppm</translation>
    </message>
    <message>
        <source>Drive the rail</source>
        <translation>驱动钢轨</translation>
    </message>
    <message>
        <source>Readings from a file…</source>
        <translation>从文件读入读数…</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>离开</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>停止产线</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>量</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>标准不确定度</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>计数</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>第二</translation>
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
        <translation>编码器读数</translation>
    </message>
    <message>
        <source>Slip along the way</source>
        <translation>沿程打滑</translation>
    </message>
    <message>
        <source>Readings: count,x_mm,y_mm[,count2]</source>
        <translation>读数：count,x_mm,y_mm[,count2]</translation>
    </message>
    <message>
        <source>CSV (*.csv);;All files (*)</source>
        <translation>CSV (*.csv);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Closed while the line measures: the rail is driven by hand over a known length. Stop the line to go on.</source>
        <translation>产线测量时关闭：钢轨须手动驱动通过已知长度。停止产线后继续。</translation>
    </message>
    <message>
        <source>A rail is driven over a length that is known, and the pulses are counted: where the light crosses it, it is seen as well.</source>
        <translation>将钢轨驱动通过已知长度并对脉冲计数：同时观察光线与钢轨相交之处。</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>second behind first, pulses</source>
        <translation>第二落后于第一，脉冲</translation>
    </message>
    <message>
        <source>Next: drive the rail over the known length.</source>
        <translation>下一步：将钢轨驱动通过已知长度。</translation>
    </message>
    <message>
        <source> µm a pulse</source>
        <translation> µm/脉冲</translation>
    </message>
    <message>
        <source> µm</source>
        <translation> µm</translation>
    </message>
    <message>
        <source>unknown: fewer than three readings</source>
        <translation>未知：读数少于三个</translation>
    </message>
    <message>
        <source>Along (V z)</source>
        <translation>纵向（V z）</translation>
    </message>
    <message>
        <source>Sideways (V x)</source>
        <translation>横向（V x）</translation>
    </message>
    <message>
        <source>Upwards (V y)</source>
        <translation>垂向（V y）</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>脉冲数</translation>
    </message>
    <message>
        <source>Slip of the second</source>
        <translation>第二编码器打滑</translation>
    </message>
    <message>
        <source>One of the encoders slips. Next: clean the wheels, press them on and drive again.</source>
        <translation>有一个编码器打滑。下一步：清洁测轮，压紧后重新驱动。</translation>
    </message>
    <message>
        <source>One pulse is %1 µm of rail. Next: enter it where the encoder&apos;s pulses are divided into triggers.</source>
        <translation>一个脉冲对应钢轨 %1 µm。下一步：在编码器脉冲分频为触发的位置输入该值。</translation>
    </message>
</context>
<context>
    <name>vignole::FramesDrawing</name>
    <message>
        <source>Frames: world on the light plane, camera, image</source>
        <translation>坐标系：光平面上的世界、相机、图像</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>World</source>
        <translation>世界</translation>
    </message>
</context>
<context>
    <name>vignole::HeaderBar</name>
    <message>
        <source>Rail</source>
        <translation>钢轨</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>炉号</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>轨型</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Gauge</source>
        <translation>测量仪</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>浅色主题</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>深色主题</translation>
    </message>
    <message>
        <source>Other theme (Ctrl+D)</source>
        <translation>切换主题（Ctrl+D）</translation>
    </message>
    <message>
        <source>%1: sign in</source>
        <translation>%1：登录</translation>
    </message>
    <message>
        <source>%1, %2: sign out</source>
        <translation>%1，%2：退出</translation>
    </message>
    <message>
        <source>Sign in (Ctrl+L)</source>
        <translation>登录（Ctrl+L）</translation>
    </message>
    <message>
        <source>%1: sign out (Ctrl+L)</source>
        <translation>%1：退出（Ctrl+L）</translation>
    </message>
    <message>
        <source>Line: %1</source>
        <translation>产线：%1</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Simulation: the rails are not real</source>
        <translation>仿真：钢轨并非真实</translation>
    </message>
    <message>
        <source>The rails come from the virtual rig</source>
        <translation>钢轨来自虚拟装置</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
</context>
<context>
    <name>vignole::LastRails</name>
    <message>
        <source>Out</source>
        <translation>超差</translation>
    </message>
    <message>
        <source>, held</source>
        <translation>，保持</translation>
    </message>
    <message>
        <source>, now</source>
        <translation>，当前</translation>
    </message>
    <message>
        <source>good %1 of %2</source>
        <translation>合格 %1/%2</translation>
    </message>
    <message>
        <source>Last rails: %1</source>
        <translation>最近钢轨：%1</translation>
    </message>
    <message>
        <source>Last rails</source>
        <translation>最近钢轨</translation>
    </message>
</context>
<context>
    <name>vignole::LensWizard</name>
    <message>
        <source>Cancelling…</source>
        <translation>取消中…</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>镜头</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>覆盖范围</translation>
    </message>
    <message>
        <source>Parts of the picture that have been seen</source>
        <translation>图像中已看到的区域</translation>
    </message>
    <message>
        <source>Picture of the target</source>
        <translation>靶标图像</translation>
    </message>
    <message>
        <source>Pictures taken</source>
        <translation>已拍图像</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>序号</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>倾角</translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>模糊</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>求解</translation>
    </message>
    <message>
        <source>Lens models (Table III)</source>
        <translation>镜头模型（表 III）</translation>
    </message>
    <message>
        <source>Distortion model</source>
        <translation>畸变模型</translation>
    </message>
    <message>
        <source>Mean error px</source>
        <translation>平均误差 px</translation>
    </message>
    <message>
        <source>RMS px</source>
        <translation>均方根 px</translation>
    </message>
    <message>
        <source>Not seen before px</source>
        <translation>未见图像 px</translation>
    </message>
    <message>
        <source>Focal length mm</source>
        <translation>焦距 mm</translation>
    </message>
    <message>
        <source>Lens models that were tried</source>
        <translation>试用过的镜头模型</translation>
    </message>
    <message>
        <source>Coverage and residuals</source>
        <translation>覆盖范围与残差</translation>
    </message>
    <message>
        <source>Points of all pictures</source>
        <translation>所有图像的点</translation>
    </message>
    <message>
        <source>Mean residual by place</source>
        <translation>各位置平均残差</translation>
    </message>
    <message>
        <source>The flat target with circles is held before one camera, in the pose that is drawn, picture by picture. The lens model is the simplest that predicts pictures it has not seen.
Target: %1, points within ±%2 µm.</source>
        <translation>将圆点平面靶标按所绘位姿置于一台相机前，逐张拍摄。所选镜头模型是能预测未见图像的最简模型。
靶标：%1，点位误差在 ±%2 µm 以内。</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Camera whose lens is calibrated</source>
        <translation>待标定镜头的相机</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>Pictures: twelve cover a lens.</source>
        <translation>图像：十二张可覆盖一个镜头。</translation>
    </message>
    <message>
        <source>Number of pictures</source>
        <translation>图像数量</translation>
    </message>
    <message>
        <source>Target to the right, mm</source>
        <translation>靶标向右，mm</translation>
    </message>
    <message>
        <source>Target down, mm</source>
        <translation>靶标向下，mm</translation>
    </message>
    <message>
        <source>Distance of the target, mm</source>
        <translation>靶标距离，mm</translation>
    </message>
    <message>
        <source>Tilt up and down, degrees</source>
        <translation>上下倾斜，度</translation>
    </message>
    <message>
        <source>Tilt to the sides, degrees</source>
        <translation>左右倾斜，度</translation>
    </message>
    <message>
        <source>Turn of the target, degrees</source>
        <translation>靶标转角，度</translation>
    </message>
    <message>
        <source>Hold as shown</source>
        <translation>按图持靶</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>离开</translation>
    </message>
    <message>
        <source>Take picture</source>
        <translation>拍摄</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Use with the plate</source>
        <translation>用于销钉板</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>The camera is needed for the pictures of the target. Stop the line to go on; what has been taken so far is kept.</source>
        <translation>拍摄靶标图像需要使用该相机。停止产线后继续；已拍内容将保留。</translation>
    </message>
    <message>
        <source>Progress of the solution</source>
        <translation>求解进度</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>已取消：未作任何更改。</translation>
    </message>
    <message>
        <source>Lens of the camera</source>
        <translation>相机镜头</translation>
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
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>camera and target</source>
        <translation>相机与靶标</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>model chosen by the data</source>
        <translation>由数据选定的模型</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Table III, residuals</source>
        <translation>表 III，残差</translation>
    </message>
    <message>
        <source>%1 % of the picture</source>
        <translation>图像的 %1 %</translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>尚无。</translation>
    </message>
    <message>
        <source>May be used, but: %1</source>
        <translation>可以使用，但：%1</translation>
    </message>
    <message>
        <source>May be used: mean error %1 px with the model %2, chosen by pictures it had not seen.</source>
        <translation>可以使用：模型 %2 平均误差 %1 px，由其未见过的图像选定。</translation>
    </message>
    <message>
        <source>%1, chosen</source>
        <translation>%1，已选</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Next: choose the camera.</source>
        <translation>下一步：选择相机。</translation>
    </message>
    <message>
        <source>First picture</source>
        <translation>首张图像</translation>
    </message>
    <message>
        <source>Looking at the target…</source>
        <translation>正在观察靶标…</translation>
    </message>
    <message>
        <source>This picture would be refused: %1</source>
        <translation>该图像将被拒绝：%1</translation>
    </message>
    <message>
        <source>This picture would be refused, because it shows the pose of picture %1; move the target to the dashed outline.</source>
        <translation>该图像将被拒绝，因其位姿与图像 %1 相同；请将靶标移至虚线轮廓处。</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) found.</source>
        <translation>
            <numerusform>找到 %n 个点。</numerusform>
        </translation>
    </message>
    <message>
        <source>Next: solve, or take more.</source>
        <translation>下一步：求解，或继续拍摄。</translation>
    </message>
    <message>
        <source>Working out which pose tells most…</source>
        <translation>正在计算信息最多的位姿…</translation>
    </message>
    <message numerus="yes">
        <source>Next: hold the target to the dashed outline and take the picture; %n to go.</source>
        <translation>
            <numerusform>下一步：将靶标对准虚线轮廓并拍摄；还需 %n 张。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Next: %1; %n to go.</source>
        <translation>
            <numerusform>下一步：%1；还需 %n 张。</numerusform>
        </translation>
    </message>
    <message>
        <source>Lens models are adjusted and tried on pictures they have not seen.</source>
        <translation>正在平差镜头模型，并用其未见过的图像检验。</translation>
    </message>
    <message>
        <source>Next: nothing to do; the result comes by itself.</source>
        <translation>下一步：无需操作；结果会自行出现。</translation>
    </message>
    <message>
        <source>Refused: it cannot be used.</source>
        <translation>已拒绝：无法使用。</translation>
    </message>
    <message>
        <source>The wizard of the range finders uses this lens. Next: calibrate the range finders.</source>
        <translation>测距仪向导将使用此镜头。下一步：标定测距仪。</translation>
    </message>
    <message>
        <source>Next: use it with the plate, or save it.</source>
        <translation>下一步：用于销钉板，或保存。</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone. Start the program on the virtual rig.</source>
        <translation>没有可供查看的装置：向导只能通过虚拟装置观察。请以虚拟装置启动程序。</translation>
    </message>
</context>
<context>
    <name>vignole::MainWindow</name>
    <message>
        <source>Is this rail good?</source>
        <translation>这根钢轨合格吗？</translation>
    </message>
    <message>
        <source>The large word is the verdict of the rail so far; beside it stands whether the gauge can be trusted. Both are made for two metres&apos; distance.</source>
        <translation>大字为钢轨至今的判定；旁边显示测量仪是否可信。两者在两米外均可辨认。</translation>
    </message>
    <message>
        <source>The measured profile</source>
        <translation>实测轮廓</translation>
    </message>
    <message>
        <source>The rail as it is measured, over its section; deviations are drawn twenty times larger. Keys 1 to 4 show whole, head, web and foot, + and − change the magnification, C colours by camera.</source>
        <translation>实测钢轨叠于轨型之上；偏差放大二十倍。按键 1 至 4 显示整体、轨头、轨腰和轨底，+、− 改变放大倍数，C 按相机着色。</translation>
    </message>
    <message>
        <source>Every dimension</source>
        <translation>每个尺寸</translation>
    </message>
    <message>
        <source>Value, deviation, uncertainty and where it lies in its tolerance; the hatched ends are closer to a limit than the uncertainty. Choose a row to see the dimension in the drawing.</source>
        <translation>数值、偏差、不确定度及在公差中的位置；斜线端部距限值小于不确定度。选择一行可在图中查看该尺寸。</translation>
    </message>
    <message>
        <source>What runs</source>
        <translation>当前运行</translation>
    </message>
    <message>
        <source>The line, the rail and who is here. SIMULATION: without a site the rails come from a virtual rig, measured by the real engine.</source>
        <translation>产线、钢轨与当前人员。“仿真”：未配置现场时，钢轨来自虚拟装置，由真实引擎测量。</translation>
    </message>
    <message>
        <source>Ten pages</source>
        <translation>十个页面</translation>
    </message>
    <message>
        <source>F1 to F10, in this order: rails that passed are on F4, alarms on F8, language, units and people on F10. Ctrl+R stops and starts the line.</source>
        <translation>F1 至 F10 依次：已通过的钢轨在 F4，报警在 F8，语言、单位和人员在 F10。Ctrl+R 停止和启动产线。</translation>
    </message>
    <message>
        <source>Close Vignole</source>
        <translation>关闭 Vignole</translation>
    </message>
    <message>
        <source>A rail is being measured.</source>
        <translation>正在测量一根钢轨。</translation>
    </message>
    <message>
        <source>What has been measured of it is kept; the rest would pass unmeasured.</source>
        <translation>已测部分将保存；其余将未测通过。</translation>
    </message>
    <message>
        <source>Close after this rail</source>
        <translation>此轨后关闭</translation>
    </message>
    <message>
        <source>Close now</source>
        <translation>立即关闭</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>留下</translation>
    </message>
</context>
<context>
    <name>vignole::MonitorPage</name>
    <message>
        <source>Whole</source>
        <translation>整体</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>轨头</translation>
    </message>
    <message>
        <source>Web</source>
        <translation>轨腰</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>轨底</translation>
    </message>
    <message>
        <source>View: %1</source>
        <translation>视图：%1</translation>
    </message>
    <message>
        <source>%1 of the section (%2)</source>
        <translation>轨型%1（%2）</translation>
    </message>
    <message>
        <source>Magnify deviations less</source>
        <translation>减小偏差放大</translation>
    </message>
    <message>
        <source>Magnify deviations less (−)</source>
        <translation>减小偏差放大（−）</translation>
    </message>
    <message>
        <source>Deviations are drawn so many times larger (0: back to 20)</source>
        <translation>偏差放大绘制的倍数（0：恢复为 20）</translation>
    </message>
    <message>
        <source>Magnify deviations more</source>
        <translation>增大偏差放大</translation>
    </message>
    <message>
        <source>Magnify deviations more (+)</source>
        <translation>增大偏差放大（+）</translation>
    </message>
    <message>
        <source>By camera</source>
        <translation>按相机</translation>
    </message>
    <message>
        <source>Colour points by camera</source>
        <translation>按相机给点着色</translation>
    </message>
    <message>
        <source>Colour points by camera (C)</source>
        <translation>按相机给点着色（C）</translation>
    </message>
    <message>
        <source>Drawing in full view</source>
        <translation>图形全视图</translation>
    </message>
    <message>
        <source>Drawing in full view (F11)</source>
        <translation>图形全视图（F11）</translation>
    </message>
    <message>
        <source>Stop line</source>
        <translation>停止产线</translation>
    </message>
    <message>
        <source>Start line</source>
        <translation>启动产线</translation>
    </message>
    <message>
        <source>%1 (Ctrl+R)</source>
        <translation>%1（Ctrl+R）</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>无值</translation>
    </message>
    <message>
        <source>Show the points before registration</source>
        <translation>显示配准前的点</translation>
    </message>
    <message>
        <source>Show the points before registration (B)</source>
        <translation>显示配准前的点 (B)</translation>
    </message>
</context>
<context>
    <name>vignole::NextRailDialog</name>
    <message>
        <source>Next rail</source>
        <translation>下一根钢轨</translation>
    </message>
    <message>
        <source>What is entered here goes with the next rail that begins. An empty field stays as the line has it.</source>
        <translation>此处输入用于下一根开始的钢轨。空字段沿用产线数据。</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>钢轨</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>炉号</translation>
    </message>
    <message>
        <source>Strand</source>
        <translation>铸流</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>订单</translation>
    </message>
    <message>
        <source>Temperature, °C</source>
        <translation>温度，°C</translation>
    </message>
    <message>
        <source>For the next rail</source>
        <translation>用于下一根钢轨</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>撤回</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Waits for the next rail.</source>
        <translation>等待下一根钢轨。</translation>
    </message>
    <message>
        <source>%1 waits for the next rail.</source>
        <translation>%1 等待下一根钢轨。</translation>
    </message>
    <message>
        <source>The rail has begun with what was entered.</source>
        <translation>钢轨已按输入开始。</translation>
    </message>
    <message>
        <source>The temperature is no number from %1 to %2 °C.</source>
        <translation>温度不是 %1 至 %2 °C 的数值。</translation>
    </message>
    <message>
        <source>Nothing was entered: fill in at least one field.</source>
        <translation>未输入内容：至少填写一项。</translation>
    </message>
    <message>
        <source>Nothing waits: the next rail is named by the line.</source>
        <translation>无待用信息：下一根钢轨由产线命名。</translation>
    </message>
</context>
<context>
    <name>vignole::PeoplePanel</name>
    <message>
        <source>People</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Names and roles are the administrator&apos;s: sign in as administrator to see and enter people.</source>
        <translation>姓名和角色由管理员管理：以管理员登录以查看和登记人员。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>姓名</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Last here</source>
        <translation>上次登录</translation>
    </message>
    <message>
        <source>People who may sign in</source>
        <translation>可登录的人员</translation>
    </message>
    <message>
        <source>Name of the new person</source>
        <translation>新人员姓名</translation>
    </message>
    <message>
        <source>First or new password</source>
        <translation>初始或新密码</translation>
    </message>
    <message>
        <source>First password of the new person</source>
        <translation>新人员初始密码</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Reason for entering the person</source>
        <translation>登记原因</translation>
    </message>
    <message>
        <source>Role of the new person</source>
        <translation>新人员角色</translation>
    </message>
    <message>
        <source>Enter a person</source>
        <translation>登记人员</translation>
    </message>
    <message>
        <source>Give a new password</source>
        <translation>设新密码</translation>
    </message>
    <message>
        <source>Give the chosen person a new password</source>
        <translation>为所选人员设新密码</translation>
    </message>
    <message>
        <source>Give this role</source>
        <translation>授予此角色</translation>
    </message>
    <message>
        <source>Give the chosen person this role</source>
        <translation>为所选人员授予此角色</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>已关闭</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>已锁定</translation>
    </message>
    <message>
        <source>chooses a password</source>
        <translation>待设密码</translation>
    </message>
    <message>
        <source>open</source>
        <translation>已打开</translation>
    </message>
    <message>
        <source>never</source>
        <translation>从未</translation>
    </message>
    <message>
        <source>Open the account</source>
        <translation>启用账户</translation>
    </message>
    <message>
        <source>Close the account</source>
        <translation>关闭账户</translation>
    </message>
    <message>
        <source>Open the account of the chosen person</source>
        <translation>启用所选人员账户</translation>
    </message>
    <message>
        <source>Close the account of the chosen person</source>
        <translation>关闭所选人员账户</translation>
    </message>
    <message>
        <source>%1 is entered.</source>
        <translation>%1 已登记。</translation>
    </message>
    <message>
        <source>%1 has a new password and chooses another at the next sign-in.</source>
        <translation>%1 已有新密码，下次登录时须另设。</translation>
    </message>
    <message>
        <source>%1 is now %2.</source>
        <translation>%1 现为%2。</translation>
    </message>
    <message>
        <source>The account of %1 is closed.</source>
        <translation>%1 的账户已关闭。</translation>
    </message>
    <message>
        <source>The account of %1 is open.</source>
        <translation>%1 的账户已启用。</translation>
    </message>
</context>
<context>
    <name>vignole::PipelinePanel</name>
    <message>
        <source>Pipeline: %1 triggers, %2 measured, %3 incomplete, %4 lost</source>
        <translation>流水线：触发 %1，已测 %2，不完整 %3，丢失 %4</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>无数据</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>SD %1   UCL %2</source>
        <translation>SD %1   UCL %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Acquisition</source>
        <translation>采集</translation>
    </message>
    <message>
        <source>Line extraction</source>
        <translation>线提取</translation>
    </message>
    <message>
        <source>2D to 3D</source>
        <translation>2D 转 3D</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 个点</translation>
    </message>
    <message>
        <source>registered</source>
        <translation>已配准</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>未配准</translation>
    </message>
    <message numerus="yes">
        <source>%n dimension(s)</source>
        <translation>
            <numerusform>%n 个尺寸</numerusform>
        </translation>
    </message>
    <message>
        <source>SD %1</source>
        <translation>SD %1</translation>
    </message>
    <message>
        <source>99 % UCL %1</source>
        <translation>99 % UCL %1</translation>
    </message>
    <message>
        <source>Consumers</source>
        <translation>使用方</translation>
    </message>
    <message>
        <source>in the queue now</source>
        <translation>当前队列中</translation>
    </message>
    <message>
        <source>highest fill, of how many places</source>
        <translation>最高占用，共多少位</translation>
    </message>
    <message>
        <source>mean time, SD standard deviation, UCL upper limit of its 99 % confidence interval</source>
        <translation>平均时间，SD 标准差，UCL 其 99 % 置信区间上限</translation>
    </message>
</context>
<context>
    <name>vignole::PlateView</name>
    <message>
        <source>no picture yet</source>
        <translation>尚无图像</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>被拒绝</translation>
    </message>
    <message>
        <source>%1 of %2 pins</source>
        <translation>销钉 %1/%2</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>相机 %1：%2</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>no pin here</source>
        <translation>此处无销钉</translation>
    </message>
    <message>
        <source>not found: %1</source>
        <translation>未找到：%1</translation>
    </message>
</context>
<context>
    <name>vignole::ProfileCanvas</name>
    <message>
        <source>Measured profile over the section</source>
        <translation>轨型上的实测轮廓</translation>
    </message>
    <message>
        <source>last profile at %1 m, %2 ago</source>
        <translation>最后轮廓在 %1 m，%2 前</translation>
    </message>
</context>
<context>
    <name>vignole::QualityPage</name>
    <message>
        <source>Repeatability</source>
        <translation>重复性</translation>
    </message>
    <message>
        <source>runs of the same rail</source>
        <translation>同一钢轨的多次测量</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>次</translation>
    </message>
    <message>
        <source>Length, m</source>
        <translation>长度，m</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>已测</translation>
    </message>
    <message>
        <source>Single profiles</source>
        <translation>单个轮廓</translation>
    </message>
    <message>
        <source>Means over 0.1 m</source>
        <translation>0.1 m 均值</translation>
    </message>
    <message>
        <source>Means over 1 m</source>
        <translation>1 m 均值</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>比较内容</translation>
    </message>
    <message>
        <source>Compare the chosen runs</source>
        <translation>比较所选各次</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>as Fig. 9a</source>
        <translation>同图 9a</translation>
    </message>
    <message>
        <source>Range of the runs</source>
        <translation>各次极差</translation>
    </message>
    <message>
        <source>Values of every run over the length</source>
        <translation>每次测量沿长度的数值</translation>
    </message>
    <message>
        <source>reading …</source>
        <translation>读取中…</translation>
    </message>
    <message>
        <source>No rail has been kept yet. Runs of the same rail are compared here.</source>
        <translation>尚未保存钢轨。在此比较同一钢轨的多次测量。</translation>
    </message>
    <message>
        <source>length, m</source>
        <translation>长度，m</translation>
    </message>
    <message>
        <source>range</source>
        <translation>极差</translation>
    </message>
    <message>
        <source>range, %1</source>
        <translation>极差，%1</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>导出为 CSV</translation>
    </message>
    <message>
        <source>truth of the virtual rig</source>
        <translation>虚拟装置的真值</translation>
    </message>
    <message numerus="yes">
        <source>The inspections were cancelled; %n were whole.</source>
        <translation>
            <numerusform>检测已取消；%n 次完整。</numerusform>
        </translation>
    </message>
    <message>
        <source>Runs of one rail</source>
        <translation>同一钢轨的各次测量</translation>
    </message>
    <message>
        <source>Reference values</source>
        <translation>参考值</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>PDF 报告</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>研究</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>准确度</translation>
    </message>
    <message>
        <source>Rails of the archive</source>
        <translation>档案库中的钢轨</translation>
    </message>
    <message>
        <source>Runs from a file</source>
        <translation>文件中的测次</translation>
    </message>
    <message>
        <source>Virtual rig</source>
        <translation>虚拟装置</translation>
    </message>
    <message>
        <source>Where the runs come from</source>
        <translation>测次来源</translation>
    </message>
    <message>
        <source>3 m of rail</source>
        <translation>3 m 钢轨</translation>
    </message>
    <message>
        <source>12 m of rail</source>
        <translation>12 m 钢轨</translation>
    </message>
    <message>
        <source>60 m of rail, as the paper</source>
        <translation>60 m 钢轨，同论文</translation>
    </message>
    <message>
        <source>Length of the virtual rail</source>
        <translation>虚拟钢轨的长度</translation>
    </message>
    <message>
        <source>Means over 0.5 m</source>
        <translation>0.5 m 均值</translation>
    </message>
    <message>
        <source>Runs that may be laid over each other</source>
        <translation>可相互叠合的测次</translation>
    </message>
    <message>
        <source>Open runs…</source>
        <translation>打开测次…</translation>
    </message>
    <message>
        <source>Open runs from a CSV file</source>
        <translation>从 CSV 文件打开测次</translation>
    </message>
    <message>
        <source>Open reference…</source>
        <translation>打开参考值…</translation>
    </message>
    <message>
        <source>Open reference values from a CSV file</source>
        <translation>从 CSV 文件打开参考值</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>报告…</translation>
    </message>
    <message>
        <source>Report as PDF (Ctrl+P)</source>
        <translation>PDF 报告（Ctrl+P）</translation>
    </message>
    <message>
        <source>Export values as CSV</source>
        <translation>将数值导出为 CSV</translation>
    </message>
    <message>
        <source>Export values as CSV (Ctrl+E)</source>
        <translation>将数值导出为 CSV（Ctrl+E）</translation>
    </message>
    <message>
        <source>Progress of the inspections</source>
        <translation>检测进度</translation>
    </message>
    <message>
        <source>What the runs differ by over the length</source>
        <translation>各次沿长度的差异</translation>
    </message>
    <message>
        <source>Every dimension; the chosen one is drawn</source>
        <translation>所有尺寸；绘制所选尺寸</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Figures of the chosen dimension, formulas and constants</source>
        <translation>所选尺寸的数据、公式和常数</translation>
    </message>
    <message>
        <source>Stored runs come from the archive, and there is none (%1): start the program with --archive FILE, or choose a file or the virtual rig above.</source>
        <translation>已存测次取自档案库，但没有档案库（%1）：请用 --archive FILE 启动程序，或在上方选择文件或虚拟装置。</translation>
    </message>
    <message>
        <source>virtual rig</source>
        <translation>虚拟装置</translation>
    </message>
    <message>
        <source>run %1</source>
        <translation>测次 %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Inspect the rail five times</source>
        <translation>检测钢轨五次</translation>
    </message>
    <message>
        <source>Cancel the inspections</source>
        <translation>取消检测</translation>
    </message>
    <message>
        <source>Inspect the same virtual rail five times</source>
        <translation>检测同一虚拟钢轨五次</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R)</source>
        <translation>请先停止产线（Ctrl+R）</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R): both need all processors, and no trigger may be lost to a study.</source>
        <translation>请先停止产线（Ctrl+R）：两者都需要全部处理器，且不得因研究而丢失触发。</translation>
    </message>
    <message>
        <source>Accuracy needs a reference: open a CSV with the columns dimension, position_m, value and, if known, u.</source>
        <translation>准确度研究需要参考值：请打开含 dimension、position_m、value 列（若已知，还有 u 列）的 CSV。</translation>
    </message>
    <message>
        <source>At least 1 run is needed, none is chosen.</source>
        <translation>至少需要 1 个测次，尚未选择。</translation>
    </message>
    <message>
        <source>At least 2 runs of the same rail are needed, %1 chosen: choose %2 more. The paper took 5.</source>
        <translation>至少需要同一钢轨的 2 个测次，已选 %1 个：请再选 %2 个。论文用了 5 个。</translation>
    </message>
    <message>
        <source>stored rails, same rail and gauge</source>
        <translation>已存钢轨，同一钢轨、同一测量仪</translation>
    </message>
    <message>
        <source>file %1</source>
        <translation>文件 %1</translation>
    </message>
    <message>
        <source>virtual rig, exact calibration, other wander, vibration, scale, speckle and noise in every run</source>
        <translation>虚拟装置，精确标定，每次的横移、振动、氧化皮、散斑和噪声各不相同</translation>
    </message>
    <message>
        <source>The same rail is inspected five times …</source>
        <translation>正在对同一钢轨检测五次…</translation>
    </message>
    <message>
        <source>Conditions: %1.</source>
        <translation>条件：%1。</translation>
    </message>
    <message>
        <source>Tick the runs that were made of the same rail and compare.</source>
        <translation>勾选同一钢轨的各次测量并比较。</translation>
    </message>
    <message>
        <source>A CSV with the columns run, position_m and dimensions, as inspect --csv writes it.</source>
        <translation>含 run、position_m 和各尺寸列的 CSV，即 inspect --csv 写出的格式。</translation>
    </message>
    <message>
        <source>Stop the line first (Ctrl+R): both need all processors.</source>
        <translation>请先停止产线（Ctrl+R）：两者都需要全部处理器。</translation>
    </message>
    <message>
        <source>The paper&apos;s experiment: one rail, five inspections, the truth known.</source>
        <translation>论文的试验：一根钢轨，五次检测，真值已知。</translation>
    </message>
    <message>
        <source>No runs are compared yet</source>
        <translation>尚未比较任何测次</translation>
    </message>
    <message>
        <source>%1 over the length</source>
        <translation>%1 沿长度</translation>
    </message>
    <message>
        <source>largest minus smallest at each position, as Fig. 9b</source>
        <translation>各位置最大减最小，同图 9b</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>期望</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>下限</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>mean of %1 m</source>
        <translation>%1 m 均值</translation>
    </message>
    <message>
        <source>Error of %1 over the length</source>
        <translation>%1 沿长度的误差</translation>
    </message>
    <message>
        <source>value minus reference, mean of the runs; %1</source>
        <translation>测值减参考值，各次均值；%1</translation>
    </message>
    <message>
        <source>value minus reference</source>
        <translation>测值减参考值</translation>
    </message>
    <message>
        <source>Largest error at each position</source>
        <translation>各位置最大误差</translation>
    </message>
    <message>
        <source>of any run</source>
        <translation>任一次</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>no error</source>
        <translation>零误差</translation>
    </message>
    <message>
        <source>limit of agreement</source>
        <translation>一致性界限</translation>
    </message>
    <message>
        <source>error, %1</source>
        <translation>误差，%1</translation>
    </message>
    <message>
        <source>Dim.</source>
        <translation>尺寸</translation>
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
        <translation>每 %1 m 平均极差</translation>
    </message>
    <message>
        <source>as Table VI</source>
        <translation>同表 VI</translation>
    </message>
    <message>
        <source>%1, as Table VI; the stretches are in the report</source>
        <translation>%1，同表 VI；各段见报告</translation>
    </message>
    <message>
        <source>%1, as Table VI</source>
        <translation>%1，同表 VI</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>偏倚</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>%1, as Table V</source>
        <translation>%1，同表 V</translation>
    </message>
    <message>
        <source>as Table V</source>
        <translation>同表 V</translation>
    </message>
    <message>
        <source>Verdict, figures, formulas and constants stand here when runs are compared.</source>
        <translation>比较测次后，此处显示判定、数据、公式和常数。</translation>
    </message>
    <message>
        <source>figures of %1</source>
        <translation>%1 的数据</translation>
    </message>
    <message>
        <source>writing …</source>
        <translation>正在写入…</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>已写入 %1。</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>无法写入 %1。</translation>
    </message>
</context>
<context>
    <name>vignole::RailBand</name>
    <message>
        <source>Place along the rail</source>
        <translation>沿轨位置</translation>
    </message>
</context>
<context>
    <name>vignole::RailsPage</name>
    <message>
        <source>Rails</source>
        <translation>钢轨</translation>
    </message>
    <message>
        <source>Rail or heat, from its beginning</source>
        <translation>钢轨号或炉号开头</translation>
    </message>
    <message>
        <source>Search by rail or heat</source>
        <translation>按钢轨或炉号搜索</translation>
    </message>
    <message>
        <source>Any verdict</source>
        <translation>任意判定</translation>
    </message>
    <message>
        <source>Out of tolerance</source>
        <translation>超差</translation>
    </message>
    <message>
        <source>Near limit</source>
        <translation>近限</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>未测</translation>
    </message>
    <message>
        <source>Any dimension</source>
        <translation>任意尺寸</translation>
    </message>
    <message>
        <source>%1 out</source>
        <translation>%1 超差</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Dimension out of tolerance</source>
        <translation>超差尺寸</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>钢轨</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>炉号</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>最差</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Rails found</source>
        <translation>找到的钢轨</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>报告…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>PDF 报告</translation>
    </message>
    <message>
        <source>Report as PDF (Ctrl+P)</source>
        <translation>PDF 报告（Ctrl+P）</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>返回实时</translation>
    </message>
    <message>
        <source>Along the rail</source>
        <translation>沿轨长</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>超差段</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>From – to, m</source>
        <translation>起 – 止，m</translation>
    </message>
    <message>
        <source>Worst, mm</source>
        <translation>最差，mm</translation>
    </message>
    <message>
        <source>Limits, mm</source>
        <translation>限值，mm</translation>
    </message>
    <message>
        <source>Stretches out of tolerance</source>
        <translation>超差段</translation>
    </message>
    <message>
        <source>Previous exception</source>
        <translation>上一超差段</translation>
    </message>
    <message>
        <source>Previous exception (Shift+N)</source>
        <translation>上一超差段（Shift+N）</translation>
    </message>
    <message>
        <source>Next exception</source>
        <translation>下一超差段</translation>
    </message>
    <message>
        <source>Next exception (N)</source>
        <translation>下一超差段（N）</translation>
    </message>
    <message>
        <source>Play along the rail</source>
        <translation>沿轨播放</translation>
    </message>
    <message>
        <source>Play or pause (P)</source>
        <translation>播放或暂停（P）</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>No rail is open</source>
        <translation>未打开钢轨</translation>
    </message>
    <message>
        <source>Choose a rail in the list: its profile, its dimensions along the rail and its exceptions are shown here.</source>
        <translation>在列表中选择钢轨：此处显示其轮廓、沿轨尺寸和超差段。</translation>
    </message>
    <message>
        <source>Rails are not kept: %1. Start the program with an archive (--archive FILE).</source>
        <translation>钢轨未保存：%1。请带档案库启动程序（--archive FILE）。</translation>
    </message>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>No rail is like that. Clear the search or choose other filters.</source>
        <translation>没有符合的钢轨。清除搜索或选择其他筛选。</translation>
    </message>
    <message>
        <source>No rail has been measured yet. Rails appear here when they have passed.</source>
        <translation>尚未测量钢轨。钢轨通过后在此显示。</translation>
    </message>
    <message>
        <source>Replay: not live.  Rail %1, %2 to %3, recipe %4, calibration %5</source>
        <translation>回放：非实时。钢轨 %1，%2 至 %3，配方 %4，标定 %5</translation>
    </message>
    <message>
        <source>none: every dimension stayed within its limits</source>
        <translation>无：各尺寸均在限值内</translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es)</source>
        <translation>
            <numerusform>%n 段</numerusform>
        </translation>
    </message>
    <message>
        <source>The profile cannot be drawn: %1.</source>
        <translation>无法绘制轮廓：%1。</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Profile at %1 m</source>
        <translation>%1 m 处轮廓</translation>
    </message>
    <message>
        <source>no. %1 of %2</source>
        <translation>第 %1 个，共 %2 个</translation>
    </message>
    <message>
        <source>: points were not kept of this rail, the model is shown</source>
        <translation>：此钢轨未保存点，显示模型</translation>
    </message>
    <message>
        <source>; drawn is no. %1, the nearest whose points were kept</source>
        <translation>；绘制第 %1 个，最近的有点轮廓</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>无值</translation>
    </message>
    <message>
        <source>writing %1 …</source>
        <translation>正在写入 %1…</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>已写入 %1</translation>
    </message>
    <message>
        <source>Any time</source>
        <translation>任意时间</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>今天</translation>
    </message>
    <message>
        <source>7 days</source>
        <translation>7 天</translation>
    </message>
    <message>
        <source>4 weeks</source>
        <translation>4 周</translation>
    </message>
    <message>
        <source>12 months</source>
        <translation>12 个月</translation>
    </message>
    <message>
        <source>Any section</source>
        <translation>任意轨型</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>轨型</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Clear search and filters</source>
        <translation>清除搜索与筛选</translation>
    </message>
    <message>
        <source>What if…</source>
        <translation>假设…</translation>
    </message>
    <message>
        <source>Judge the rails found with other limits</source>
        <translation>用其他限值评判所找钢轨</translation>
    </message>
    <message>
        <source>Next rail…</source>
        <translation>下一根钢轨…</translation>
    </message>
    <message>
        <source>Enter the papers of the next rail</source>
        <translation>输入下一根钢轨的资料</translation>
    </message>
    <message>
        <source>Export as CSV or JSON</source>
        <translation>导出为 CSV 或 JSON</translation>
    </message>
    <message>
        <source>Export as CSV or JSON (Ctrl+E)</source>
        <translation>导出为 CSV 或 JSON（Ctrl+E）</translation>
    </message>
    <message>
        <source>Nothing new is kept: nobody writes into this archive.</source>
        <translation>不再保存新数据：无人写入该档案库。</translation>
    </message>
    <message>
        <source>Nothing is kept. Live rails are shown on Monitor only.</source>
        <translation>未保存任何数据。实时钢轨仅在“监视”显示。</translation>
    </message>
    <message>
        <source>; %1 profiles lost</source>
        <translation>；%1 个轮廓丢失</translation>
    </message>
    <message>
        <source>; points of %1 profiles left out</source>
        <translation>；%1 个轮廓的点略去</translation>
    </message>
    <message>
        <source>Nothing can be written: %1. What passes waits in memory.</source>
        <translation>无法写入：%1。通过的数据暂存于内存。</translation>
    </message>
    <message>
        <source>kept since the start: %1 rails; %2 profiles wait</source>
        <translation>启动以来已保存：%1 根钢轨；%2 个轮廓等待中</translation>
    </message>
    <message>
        <source>nearest to a limit, inside</source>
        <translation>最接近限值，在内</translation>
    </message>
    <message>
        <source>furthest beyond a limit, mm</source>
        <translation>超限最多，mm</translation>
    </message>
    <message>
        <source>Dimension that is drawn</source>
        <translation>所绘尺寸</translation>
    </message>
    <message>
        <source>Show the points before registration</source>
        <translation>显示配准前的点</translation>
    </message>
</context>
<context>
    <name>vignole::RateChart</name>
    <message>
        <source>Alarms in each ten minutes of the last %1 hours: at most %2</source>
        <translation>最近 %1 小时每十分钟报警数：最多 %2</translation>
    </message>
    <message>
        <source>flood above %1</source>
        <translation>超过 %1 为泛滥</translation>
    </message>
    <message>
        <source>hours; dotted at %1: target</source>
        <translation>小时；%1 处点线为目标</translation>
    </message>
</context>
<context>
    <name>vignole::RecipesPage</name>
    <message>
        <source>Draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>已批准</translation>
    </message>
    <message>
        <source>Retired</source>
        <translation>已停用</translation>
    </message>
    <message>
        <source>With the program</source>
        <translation>程序自带</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Recipes and their versions</source>
        <translation>配方及其版本</translation>
    </message>
    <message>
        <source>Section of the new recipe</source>
        <translation>新配方的轨型</translation>
    </message>
    <message>
        <source>Profile and straightness class of the new recipe</source>
        <translation>新配方的轮廓与平直度等级</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新建</translation>
    </message>
    <message>
        <source>New draft from section and class</source>
        <translation>按轨型和等级新建草稿</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>导入…</translation>
    </message>
    <message>
        <source>Import a recipe file as a draft</source>
        <translation>将配方文件导入为草稿</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Export the chosen recipe</source>
        <translation>导出所选配方</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Nominal, mm</source>
        <translation>名义值，mm</translation>
    </message>
    <message>
        <source>Lower, mm</source>
        <translation>下限，mm</translation>
    </message>
    <message>
        <source>Upper, mm</source>
        <translation>上限，mm</translation>
    </message>
    <message>
        <source>Tolerances of the chosen recipe</source>
        <translation>所选配方的公差</translation>
    </message>
    <message>
        <source>What is new in it</source>
        <translation>新内容</translation>
    </message>
    <message>
        <source>What is new in the draft</source>
        <translation>草稿中的新内容</translation>
    </message>
    <message>
        <source>Save as a new draft</source>
        <translation>另存为新草稿</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>Recipe to compare with</source>
        <translation>对比配方</translation>
    </message>
    <message>
        <source>What</source>
        <translation>何事</translation>
    </message>
    <message>
        <source>There</source>
        <translation>彼</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>此</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>差异项</translation>
    </message>
    <message>
        <source>Approval</source>
        <translation>批准</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Reason for the approval</source>
        <translation>批准原因</translation>
    </message>
    <message>
        <source>Your password</source>
        <translation>您的密码</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>批准</translation>
    </message>
    <message>
        <source>Approve the draft</source>
        <translation>批准草稿</translation>
    </message>
    <message>
        <source>against %1 v%2, %3</source>
        <translation>对比 %1 v%2，%3</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>%1 v%2</source>
        <translation>%1 v%2</translation>
    </message>
    <message>
        <source>%1, by %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Both are the same.</source>
        <translation>两者相同。</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n 项</numerusform>
        </translation>
    </message>
    <message>
        <source>Only a draft is approved.</source>
        <translation>仅可批准草稿。</translation>
    </message>
    <message>
        <source>QA approves: sign in.</source>
        <translation>由质检批准：请登录。</translation>
    </message>
    <message>
        <source>This draft is yours: somebody else approves it.</source>
        <translation>此草稿为您所建：须由他人批准。</translation>
    </message>
    <message>
        <source>Approval retires the version before; reason and password go with your name into the audit trail.</source>
        <translation>批准将停用前一版本；原因与您的姓名记入审计记录，并以密码确认。</translation>
    </message>
    <message>
        <source>%1 v%2 is kept as a draft.</source>
        <translation>%1 v%2 已存为草稿。</translation>
    </message>
    <message>
        <source>%1: the lower limit lies above the upper one; exchange them.</source>
        <translation>%1：下限高于上限；请互换。</translation>
    </message>
    <message>
        <source>%1: a limit is a number in mm, or empty for none.</source>
        <translation>%1：限值为以 mm 计的数值，空表示无。</translation>
    </message>
    <message>
        <source>Say what is new in the draft.</source>
        <translation>请说明草稿中的新内容。</translation>
    </message>
    <message>
        <source>Approved.</source>
        <translation>已批准。</translation>
    </message>
    <message>
        <source>Import a recipe file</source>
        <translation>导入配方文件</translation>
    </message>
    <message>
        <source>Export the recipe</source>
        <translation>导出配方</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>已写入 %1</translation>
    </message>
    <message>
        <source>Section…</source>
        <translation>轨型…</translation>
    </message>
    <message>
        <source>Draw the section, or bring one along from a drawing</source>
        <translation>绘制轨型，或从图纸导入</translation>
    </message>
    <message>
        <source>What if…</source>
        <translation>假设…</translation>
    </message>
    <message>
        <source>Judge stored rails by the chosen recipe</source>
        <translation>按所选配方评判已存钢轨</translation>
    </message>
    <message>
        <source>Use for the next rail</source>
        <translation>用于下一根钢轨</translation>
    </message>
    <message>
        <source>Use the chosen recipe for the next rail</source>
        <translation>将所选配方用于下一根钢轨</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Parameters of dimensions and settings of the stages</source>
        <translation>尺寸参数与各环节设置</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Settings of the chosen recipe</source>
        <translation>所选配方的设置</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Name of the draft; another name makes a copy</source>
        <translation>草稿名称；改名则另建副本</translation>
    </message>
    <message>
        <source>On the line: %1 v%2.</source>
        <translation>产线上：%1 v%2。</translation>
    </message>
    <message>
        <source>From the next rail: %1.</source>
        <translation>自下一根钢轨起：%1。</translation>
    </message>
    <message>
        <source>Only an approved recipe is measured with.</source>
        <translation>仅可用已批准的配方测量。</translation>
    </message>
    <message>
        <source>%1: the value is not of its kind.</source>
        <translation>%1：值的类型不符。</translation>
    </message>
    <message>
        <source>%1 v%2 is in force from the next rail; the rail in the gauge keeps what it began with.</source>
        <translation>%1 v%2 自下一根钢轨起生效；测量仪中的钢轨沿用开始时的配方。</translation>
    </message>
    <message>
        <source>What if needs at least %1 stored rails of section %2, there are %3: measure more first.</source>
        <translation>“假设”至少需要 %1 根轨型 %2 的已存钢轨，现有 %3 根：请先多测量。</translation>
    </message>
    <message>
        <source>Recipes are read, drafts cannot be kept: %1.</source>
        <translation>配方可读取，但无法保存草稿：%1。</translation>
    </message>
</context>
<context>
    <name>vignole::ReferencePanel</name>
    <message>
        <source>Reference piece</source>
        <translation>标准件</translation>
    </message>
    <message>
        <source>Certificate and gauge</source>
        <translation>证书与测量仪</translation>
    </message>
    <message>
        <source>Profiles that are averaged</source>
        <translation>取平均的轮廓数</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>核查进度</translation>
    </message>
    <message>
        <source>Measure the piece</source>
        <translation>测量标准件</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>离开</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>停止产线</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>已取消：未作任何更改。</translation>
    </message>
    <message>
        <source>Closed while the line measures: the piece stands where the rail passes. Stop the line to go on.</source>
        <translation>产线测量时关闭：标准件位于钢轨通过之处。停止产线后继续。</translation>
    </message>
    <message>
        <source>A section with a certificate is put into the gauge and measured with the calibration in force. On the virtual rig it is a virtual piece, whose truth is its certificate (U = 2 µm).</source>
        <translation>将带证书的轨段放入测量仪，用现行标定测量。在虚拟装置上为虚拟标准件，其真值即其证书（U = 2 µm）。</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>测量中…</translation>
    </message>
    <message>
        <source>Next: measure the piece.</source>
        <translation>下一步：测量标准件。</translation>
    </message>
    <message numerus="yes">
        <source>The gauge agrees with the certificate in every dimension, over %n profile(s).</source>
        <translation>
            <numerusform>测量仪在所有尺寸上与证书一致，基于 %n 个轮廓。</numerusform>
        </translation>
    </message>
    <message>
        <source>The gauge does not agree with the certificate. Next: clean the piece and measure again; if it stays so, calibrate the range finders.</source>
        <translation>测量仪与证书不一致。下一步：清洁标准件后重新测量；若仍如此，请标定测距仪。</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Certificate %1</source>
        <translation>证书 %1</translation>
    </message>
    <message>
        <source>Measured %1</source>
        <translation>实测 %1</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Deviation over U</source>
        <translation>偏差 / U</translation>
    </message>
    <message>
        <source>%1, differs</source>
        <translation>%1，不一致</translation>
    </message>
    <message>
        <source>not measured: %1</source>
        <translation>未测：%1</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone.</source>
        <translation>没有可供查看的装置：向导只能通过虚拟装置观察。</translation>
    </message>
</context>
<context>
    <name>vignole::ReplayCanvas</name>
    <message>
        <source>Profile of the stored rail</source>
        <translation>已存钢轨的轮廓</translation>
    </message>
</context>
<context>
    <name>vignole::RigDrawing</name>
    <message>
        <source>The rig as it is calibrated</source>
        <translation>标定后的装置</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>Along the rail: fields of view on the light plane, distances</source>
        <translation>沿钢轨方向：光平面上的视场、距离</translation>
    </message>
    <message>
        <source>From the side: angles out of the light plane</source>
        <translation>侧视：与光平面的夹角</translation>
    </message>
</context>
<context>
    <name>vignole::RigWizard</name>
    <message>
        <source>Cancelling…</source>
        <translation>取消中…</translation>
    </message>
    <message>
        <source>Range finders</source>
        <translation>测距仪</translation>
    </message>
    <message>
        <source>What it means</source>
        <translation>结果含义</translation>
    </message>
    <message>
        <source>Fit to the pins</source>
        <translation>销钉拟合</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>求解</translation>
    </message>
    <message>
        <source>Pins found (Fig. 8d)</source>
        <translation>找到的销钉（图 8d）</translation>
    </message>
    <message>
        <source>circles: the pins as found; points: the lines of the first placement</source>
        <translation>圆：找到的销钉；点：首次放置的激光线</translation>
    </message>
    <message>
        <source>Pins in the world</source>
        <translation>世界坐标中的销钉</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>检验</translation>
    </message>
    <message>
        <source>Put in force</source>
        <translation>启用</translation>
    </message>
    <message>
        <source>How often the plate is put down: four find an error of the plate as well.</source>
        <translation>销钉板的放置次数：四次还可发现板本身的误差。</translation>
    </message>
    <message>
        <source>Number of placements</source>
        <translation>放置次数</translation>
    </message>
    <message>
        <source>The virtual plate, for training</source>
        <translation>虚拟销钉板，供培训</translation>
    </message>
    <message>
        <source>is as its certificate says</source>
        <translation>与证书一致</translation>
    </message>
    <message>
        <source>is the mirror image of its file</source>
        <translation>为其文件的镜像</translation>
    </message>
    <message>
        <source>is not the one of the certificate</source>
        <translation>不是证书所指的那块</translation>
    </message>
    <message>
        <source>has lost pin 4</source>
        <translation>缺少 4 号销钉</translation>
    </message>
    <message>
        <source>Virtual plate</source>
        <translation>虚拟销钉板</translation>
    </message>
    <message>
        <source>Plate to the right, mm</source>
        <translation>板向右，mm</translation>
    </message>
    <message>
        <source>Plate up, mm</source>
        <translation>板向上，mm</translation>
    </message>
    <message>
        <source>Plate turned anticlockwise, degrees</source>
        <translation>板逆时针旋转，度</translation>
    </message>
    <message>
        <source>Plate tilted out of the light, degrees</source>
        <translation>板倾斜出光平面，度</translation>
    </message>
    <message>
        <source>tilt </source>
        <translation>倾斜 </translation>
    </message>
    <message>
        <source>Place as shown</source>
        <translation>按图放置</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>离开</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Take again</source>
        <translation>重拍</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>报告…</translation>
    </message>
    <message>
        <source>The plate stands where the rail passes, and the cameras are needed. Stop the line to go on; what has been taken so far is kept.</source>
        <translation>销钉板位于钢轨通过之处，且需要使用相机。停止产线后继续；已拍内容将保留。</translation>
    </message>
    <message>
        <source>To be repeated after so many days (0: never)</source>
        <translation>多少天后重新标定（0：从不）</translation>
    </message>
    <message>
        <source>Days after which the calibration is to be repeated</source>
        <translation>标定须重新进行的天数</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Reason for the new calibration</source>
        <translation>新标定的原因</translation>
    </message>
    <message>
        <source>Progress of the solution</source>
        <translation>求解进度</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Centre (CD)</source>
        <translation>圆心（CD）</translation>
    </message>
    <message>
        <source>Radius (RD)</source>
        <translation>半径（RD）</translation>
    </message>
    <message>
        <source>Points (PD)</source>
        <translation>点（PD）</translation>
    </message>
    <message>
        <source>Table IV: fit to the pins</source>
        <translation>表 IV：销钉拟合</translation>
    </message>
    <message>
        <source>Checks of the new calibration</source>
        <translation>新标定的检验</translation>
    </message>
    <message>
        <source>Four cameras together…</source>
        <translation>四台相机联合求解…</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>已取消：未作任何更改。</translation>
    </message>
    <message>
        <source>%1 is in force: the line measures with it from the next rail on.</source>
        <translation>%1 已启用：产线自下一根钢轨起用其测量。</translation>
    </message>
    <message>
        <source>Report of the calibration</source>
        <translation>标定报告</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>turned and moved</source>
        <translation>旋转并移动</translation>
    </message>
    <message>
        <source>turned 180°</source>
        <translation>旋转 180°</translation>
    </message>
    <message>
        <source>moved %1 mm</source>
        <translation>移动 %1 mm</translation>
    </message>
    <message>
        <source>as drawn, 0°</source>
        <translation>按图，0°</translation>
    </message>
    <message>
        <source>plate and cameras</source>
        <translation>销钉板与相机</translation>
    </message>
    <message>
        <source>Placement %1</source>
        <translation>放置 %1</translation>
    </message>
    <message>
        <source>four cameras together</source>
        <translation>四台相机联合</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>对比</translation>
    </message>
    <message>
        <source>old and new</source>
        <translation>新与旧</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>reason and signature</source>
        <translation>原因与签名</translation>
    </message>
    <message>
        <source>placement %1 of %2</source>
        <translation>放置 %1/%2</translation>
    </message>
    <message>
        <source>U (k = 2) in %1</source>
        <translation>U (k = 2)，%1</translation>
    </message>
    <message>
        <source>mean / max in %1</source>
        <translation>均值 / 最大，%1</translation>
    </message>
    <message>
        <source>Plate, %1</source>
        <translation>销钉板，%1</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>销钉板</translation>
    </message>
    <message>
        <source>%1, U = 3 µm, pins towards the cameras</source>
        <translation>%1，U = 3 µm，销钉朝向相机</translation>
    </message>
    <message>
        <source>Camera %1: lens as calibrated in this session</source>
        <translation>相机 %1：本次标定的镜头</translation>
    </message>
    <message>
        <source>Camera %1: lens of the calibration in force</source>
        <translation>相机 %1：现行标定的镜头</translation>
    </message>
    <message>
        <source>The plate with 13 pins is put into the gauge where the rail passes, pins towards the cameras, and turned and moved between the pictures. Nothing is applied before old and new have been compared and you confirm.

%1</source>
        <translation>将带 13 个销钉的销钉板放入测量仪中钢轨通过之处，销钉朝向相机，并在各次拍摄之间旋转和移动。新旧对比且经您确认之前不作任何应用。

%1</translation>
    </message>
    <message>
        <source>%1 takes the place of %2 from the next rail on. Both are kept and can be compared and put back.</source>
        <translation>%1 自下一根钢轨起取代 %2。两者均保留，可对比，也可恢复。</translation>
    </message>
    <message>
        <source>could not be asked</source>
        <translation>无法检验</translation>
    </message>
    <message>
        <source>%1, within %2</source>
        <translation>%1，在 %2 以内</translation>
    </message>
    <message>
        <source>%1, above %2</source>
        <translation>%1，高于 %2</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>右移 %1</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>左移 %1</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>上移 %1</translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation>下移 %1</translation>
    </message>
    <message>
        <source>turned by %1° anticlockwise</source>
        <translation>逆时针转 %1°</translation>
    </message>
    <message>
        <source>turned by %1° clockwise</source>
        <translation>顺时针转 %1°</translation>
    </message>
    <message>
        <source>Next: move the plate to the dashed outlines: %1.</source>
        <translation>下一步：将销钉板移至虚线轮廓处：%1。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Next: put the plate into the gauge.</source>
        <translation>下一步：将销钉板放入测量仪。</translation>
    </message>
    <message>
        <source>First placement</source>
        <translation>首次放置</translation>
    </message>
    <message>
        <source>Next placement</source>
        <translation>下次放置</translation>
    </message>
    <message>
        <source>Looking at the plate…</source>
        <translation>正在观察销钉板…</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>相机 %1：%2</translation>
    </message>
    <message>
        <source>%1 of %2 pins found</source>
        <translation>找到销钉 %1/%2</translation>
    </message>
    <message numerus="yes">
        <source>, %n picture(s) refused</source>
        <translation>
            <numerusform>，%n 张图像被拒绝</numerusform>
        </translation>
    </message>
    <message>
        <source>All four cameras see the plate where it must lie. Next: “%1”.</source>
        <translation>四台相机均在应在位置看到销钉板。下一步：“%1”。</translation>
    </message>
    <message>
        <source>The poses of four cameras are found together with the pins.</source>
        <translation>正在与销钉一并求解四台相机的位姿。</translation>
    </message>
    <message>
        <source>Next: nothing to do; the comparison comes by itself.</source>
        <translation>下一步：无需操作；对比会自行出现。</translation>
    </message>
    <message>
        <source>Refused: it cannot be put in force.</source>
        <translation>已拒绝：无法启用。</translation>
    </message>
    <message>
        <source>May be used: every check is within its limit.</source>
        <translation>可以使用：各项检验均在限值内。</translation>
    </message>
    <message numerus="yes">
        <source>May be used, but %n dimension(s) get more than is allowed.</source>
        <translation>
            <numerusform>可以使用，但 %n 个尺寸超过允许值。</numerusform>
        </translation>
    </message>
    <message>
        <source>Next: compare old and new on the right. Nothing is applied before you confirm.</source>
        <translation>下一步：在右侧对比新旧。您确认之前不作任何应用。</translation>
    </message>
    <message>
        <source>Done. Next: start the line and watch the first rail.</source>
        <translation>完成。下一步：启动产线并观察第一根钢轨。</translation>
    </message>
    <message>
        <source>Next: give the reason and put it in force.</source>
        <translation>下一步：填写原因并启用。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone. Start the program on the virtual rig.</source>
        <translation>没有可供查看的装置：向导只能通过虚拟装置观察。请以虚拟装置启动程序。</translation>
    </message>
</context>
<context>
    <name>vignole::SectionDialog</name>
    <message>
        <source>Drawing of a section</source>
        <translation>轨型图</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>轨型</translation>
    </message>
    <message>
        <source>Section with its primitives named</source>
        <translation>标出图元名称的轨型</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>长度，mm</translation>
    </message>
    <message>
        <source>Radius, mm</source>
        <translation>半径，mm</translation>
    </message>
    <message>
        <source>Primitives of the section</source>
        <translation>轨型的图元</translation>
    </message>
    <message>
        <source>Name of the section</source>
        <translation>轨型名称</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>等级</translation>
    </message>
    <message>
        <source>Profile and straightness class of its recipe</source>
        <translation>其配方的轮廓与平直度等级</translation>
    </message>
    <message>
        <source>Open a drawing…</source>
        <translation>打开图纸…</translation>
    </message>
    <message>
        <source>Open a drawing of a section</source>
        <translation>打开轨型图纸</translation>
    </message>
    <message>
        <source>Make a draft of it</source>
        <translation>据此建草稿</translation>
    </message>
    <message>
        <source>Keep the section and make a draft of it</source>
        <translation>保存轨型并据此建草稿</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>There is nothing in this file that could be drawn.</source>
        <translation>此文件中没有可绘制的内容。</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>已拒绝：%1</translation>
    </message>
    <message>
        <source>QA makes drafts: sign in.</source>
        <translation>由质检建立草稿：请登录。</translation>
    </message>
    <message>
        <source>Open a drawing: one closed outline of lines and arcs, the rail upright.</source>
        <translation>打开图纸：一条由直线和圆弧组成的闭合轮廓，钢轨直立。</translation>
    </message>
    <message>
        <source>DXF, JSON or a MiniProf design</source>
        <translation>DXF、JSON 或 MiniProf 设计</translation>
    </message>
    <message numerus="yes">
        <source>%1 mm high, %2 cm², %3 kg/m, %4; %n primitive(s)</source>
        <translation>
            <numerusform>高 %1 mm，%2 cm²，%3 kg/m，%4；%n 个图元</numerusform>
        </translation>
    </message>
    <message>
        <source>symmetric</source>
        <translation>对称</translation>
    </message>
    <message>
        <source>asymmetric</source>
        <translation>不对称</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>segment</source>
        <translation>线段</translation>
    </message>
    <message>
        <source>A name has letters, digits, spaces, dots and hyphens: it becomes the name of a file.</source>
        <translation>名称可含字母、数字、空格、点和连字符：它将成为文件名。</translation>
    </message>
    <message>
        <source>%1 is a section of the catalogue: give yours another name.</source>
        <translation>%1 是目录中的轨型：请另取名称。</translation>
    </message>
    <message>
        <source>There is another section of the name %1: give a new name.</source>
        <translation>已有另一名为 %1 的轨型：请取新名称。</translation>
    </message>
</context>
<context>
    <name>vignole::SectionDrawing</name>
    <message>
        <source>free end</source>
        <translation>自由端</translation>
    </message>
    <message>
        <source>open here: %1 mm</source>
        <translation>此处断开：%1 mm</translation>
    </message>
</context>
<context>
    <name>vignole::SettingsPage</name>
    <message>
        <source>Screen</source>
        <translation>屏幕</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Unit of lengths</source>
        <translation>长度单位</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>People</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>档案库</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>About</source>
        <translation>关于</translation>
    </message>
    <message>
        <source>Vignole %1: rail profiles in millimetres, with their uncertainty. Licence GPL-3.0-or-later.</source>
        <translation>Vignole %1：以毫米计的钢轨轮廓及其不确定度。许可证 GPL-3.0-or-later。</translation>
    </message>
    <message>
        <source>There is none: %1. Rails are measured and not kept. Start the program with --archive FILE.</source>
        <translation>没有：%1。钢轨只测量不保存。请用 --archive FILE 启动程序。</translation>
    </message>
    <message>
        <source>%1
%2 rails are kept.</source>
        <translation>%1
已保存 %2 根钢轨。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Language of the screen</source>
        <translation>屏幕语言</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>设置分组</translation>
    </message>
    <message>
        <source>Who is here</source>
        <translation>当前人员</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>审计记录</translation>
    </message>
    <message>
        <source>of this machine; kept for the next start</source>
        <translation>本机；保存至下次启动</translation>
    </message>
    <message>
        <source>Show the tour</source>
        <translation>显示导览</translation>
    </message>
    <message>
        <source>Show the tour of Monitor</source>
        <translation>显示“监视”导览</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>装置</translation>
    </message>
    <message>
        <source>drawn from the calibration in force</source>
        <translation>按现行标定绘制</translation>
    </message>
    <message>
        <source>This line does not tell its calibration.</source>
        <translation>该产线未告知其标定。</translation>
    </message>
    <message>
        <source>Calibration %1. The rail stands where it was seen last.</source>
        <translation>标定 %1。钢轨位于最近一次所见之处。</translation>
    </message>
    <message>
        <source>Calibration %1. No rail has been seen yet.</source>
        <translation>标定 %1。尚未见到钢轨。</translation>
    </message>
    <message>
        <source>No site is configured: the four cameras are those of the virtual rig, and every page says SIMULATION. Cameras are measured with on the command line: vignole-cli inspect --source gige.</source>
        <translation>未配置现场：四台相机为虚拟装置的相机，每页均显示“仿真”。使用相机测量请用命令行：vignole-cli inspect --source gige。</translation>
    </message>
</context>
<context>
    <name>vignole::SignInPanel</name>
    <message>
        <source>Who is here</source>
        <translation>当前人员</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>姓名</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>密码</translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation>退出登录</translation>
    </message>
    <message>
        <source>Enter as the first administrator</source>
        <translation>登记为首位管理员</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>登录</translation>
    </message>
    <message>
        <source>Nobody can sign in: people are kept in the archive, and there is none (%1).</source>
        <translation>无法登录：人员保存在档案库中，但没有档案库（%1）。</translation>
    </message>
    <message>
        <source>After a quarter of an hour without a key or a touch it is the operator&apos;s screen again.</source>
        <translation>一刻钟无按键或触摸后，屏幕恢复为操作员。</translation>
    </message>
    <message>
        <source>Nobody is entered yet. The first one is the administrator and enters the others; the password has at least 8 characters.</source>
        <translation>尚无人员登记。第一位为管理员，由其登记他人；密码至少 8 个字符。</translation>
    </message>
    <message>
        <source>Without signing in this is the operator&apos;s screen: it measures, shows and acknowledges.</source>
        <translation>未登录时为操作员屏幕：可测量、查看和确认。</translation>
    </message>
    <message>
        <source>Name and password are both needed.</source>
        <translation>需要姓名和密码。</translation>
    </message>
    <message>
        <source>Name or password is wrong.</source>
        <translation>姓名或密码错误。</translation>
    </message>
    <message>
        <source>This account is closed; ask the administrator.</source>
        <translation>该账户已关闭；请联系管理员。</translation>
    </message>
    <message>
        <source>Too many wrong passwords: locked until %1.</source>
        <translation>密码错误次数过多：锁定至 %1。</translation>
    </message>
    <message>
        <source>New password, at least 8 characters</source>
        <translation>新密码，至少 8 个字符</translation>
    </message>
    <message>
        <source>New password</source>
        <translation>新密码</translation>
    </message>
    <message>
        <source>Change the password</source>
        <translation>更改密码</translation>
    </message>
    <message>
        <source>Present password</source>
        <translation>当前密码</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>This password was given by somebody else: choose one of your own.</source>
        <translation>此密码由他人设置：请设自己的密码。</translation>
    </message>
    <message>
        <source>The password is changed.</source>
        <translation>密码已更改。</translation>
    </message>
    <message>
        <source>The password is changed: sign in with it.</source>
        <translation>密码已更改：请用新密码登录。</translation>
    </message>
</context>
<context>
    <name>vignole::StepList</name>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>第 %1 步，共 %2 步：%3</translation>
    </message>
</context>
<context>
    <name>vignole::StripChart</name>
    <message>
        <source>%1 along the rail: %2</source>
        <translation>沿轨长 %1：%2</translation>
    </message>
</context>
<context>
    <name>vignole::StripeView</name>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>brightness along the line</source>
        <translation>沿线亮度</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Saturated</source>
        <translation>饱和</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>噪声</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>段数</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>trigger %1</source>
        <translation>触发 %1</translation>
    </message>
    <message>
        <source>no picture yet</source>
        <translation>尚无图像</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>左上</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>右上</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>右下</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>左下</translation>
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
        <translation>试用参数在应用前仅作用于这些图像。</translation>
    </message>
    <message>
        <source>Anybody may try; a technician who has signed in applies.</source>
        <translation>任何人可试用；由已登录的技术员应用。</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>已冻结</translation>
    </message>
    <message>
        <source>This source hands out no pictures.</source>
        <translation>该图像源不提供图像。</translation>
    </message>
    <message>
        <source>Nothing is on trial: change a parameter first.</source>
        <translation>无试用内容：先更改一个参数。</translation>
    </message>
    <message>
        <source>A change of the measurement needs a reason.</source>
        <translation>更改测量需说明原因。</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>保存图像</translation>
    </message>
    <message>
        <source>Lost: %1</source>
        <translation>丢失：%1</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>The line has not been started (Ctrl+R).</source>
        <translation>产线尚未启动（Ctrl+R）。</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>%1 前</translation>
    </message>
    <message numerus="yes">
        <source>The picture is no longer held: the last %n are.</source>
        <translation>
            <numerusform>该图像已不再保留：仅保留最近 %n 张。</numerusform>
        </translation>
    </message>
    <message>
        <source>No picture: %1</source>
        <translation>无图像：%1</translation>
    </message>
    <message>
        <source>Pictures behind the profile at %1 m.</source>
        <translation>%1 m 处轮廓对应的图像。</translation>
    </message>
    <message>
        <source>Waits for the next rail; the running rail keeps what it began with.</source>
        <translation>等待下一根钢轨；当前钢轨沿用开始时的设置。</translation>
    </message>
    <message>
        <source>There is no archive, so the change could not be recorded: nothing was changed.</source>
        <translation>没有档案库，无法记录更改：未作任何更改。</translation>
    </message>
    <message>
        <source>The change is being recorded…</source>
        <translation>正在记录更改…</translation>
    </message>
    <message>
        <source>Nothing was changed, because it could not be recorded: %1</source>
        <translation>未作任何更改，因为无法记录：%1</translation>
    </message>
    <message>
        <source>Recorded. The exposure changes with the next start of the line, the parameters with the next rail.</source>
        <translation>已记录。曝光在产线下次启动时更改，参数自下一根钢轨起更改。</translation>
    </message>
    <message>
        <source>Recorded. Waits for the next rail; the running rail keeps what it began with.</source>
        <translation>已记录。等待下一根钢轨；当前钢轨沿用开始时的设置。</translation>
    </message>
    <message>
        <source>Camera %1 has no picture to save.</source>
        <translation>相机 %1 没有可保存的图像。</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>图像 (*.png)</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>正在保存 %1…</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>已写入 %1。</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
</context>
<context>
    <name>vignole::StudyPanel</name>
    <message>
        <source>Parameter study</source>
        <translation>参数研究</translation>
    </message>
    <message>
        <source>Main effects</source>
        <translation>主效应</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>Settings and their levels</source>
        <translation>设置及其水平</translation>
    </message>
    <message>
        <source>Influence of each setting</source>
        <translation>各设置的影响</translation>
    </message>
    <message>
        <source>Placements of the plate</source>
        <translation>销钉板放置次数</translation>
    </message>
    <message>
        <source>Placements of the plate for the study</source>
        <translation>研究用销钉板放置次数</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>研究进度</translation>
    </message>
    <message>
        <source>Start the study</source>
        <translation>开始研究</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>离开</translation>
    </message>
    <message>
        <source>Stop the line</source>
        <translation>停止产线</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>报告…</translation>
    </message>
    <message>
        <source>settings and levels</source>
        <translation>设置与水平</translation>
    </message>
    <message>
        <source>Cancelled: nothing has changed.</source>
        <translation>已取消：未作任何更改。</translation>
    </message>
    <message>
        <source>Report of the study</source>
        <translation>研究报告</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>Closed while the line measures: the plate stands where the rail passes. Stop the line to go on.</source>
        <translation>产线测量时关闭：销钉板位于钢轨通过之处。停止产线后继续。</translation>
    </message>
    <message>
        <source>Every combination of the levels is a calibration by the paper&apos;s method on pictures of the plate. Levels are parted by commas; one level or none: the setting is not varied.</source>
        <translation>各水平的每种组合都是按论文方法对销钉板图像进行的一次标定。水平以逗号分隔；一个或没有水平：该设置不变化。</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>运行中…</translation>
    </message>
    <message>
        <source>Next: choose levels and start.</source>
        <translation>下一步：选择水平并开始。</translation>
    </message>
    <message>
        <source>Exposure, ms</source>
        <translation>曝光，ms</translation>
    </message>
    <message>
        <source>Smoothing σ, px</source>
        <translation>平滑 σ，px</translation>
    </message>
    <message>
        <source>Ellipses a pin</source>
        <translation>每销椭圆数</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>There is no rig to look through: the wizards look through the virtual rig alone.</source>
        <translation>没有可供查看的装置：向导只能通过虚拟装置观察。</translation>
    </message>
</context>
<context>
    <name>vignole::SupportBundle</name>
    <message>
        <source>is there already</source>
        <translation>已存在</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>无法创建</translation>
    </message>
    <message>
        <source>cancelled: nothing is left of it</source>
        <translation>已取消：未留下任何内容</translation>
    </message>
</context>
<context>
    <name>vignole::TolerancePlot</name>
    <message>
        <source>lower limit %1</source>
        <translation>下限 %1</translation>
    </message>
    <message>
        <source>upper limit %1</source>
        <translation>上限 %1</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>期望 %1</translation>
    </message>
</context>
<context>
    <name>vignole::Tour</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>关闭（Esc）</translation>
    </message>
    <message>
        <source>Close the tour</source>
        <translation>关闭导览</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>开始</translation>
    </message>
</context>
<context>
    <name>vignole::TrialPanel</name>
    <message>
        <source>Line extraction</source>
        <translation>线提取</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>曝光</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Low threshold</source>
        <translation>低阈值</translation>
    </message>
    <message>
        <source>High threshold</source>
        <translation>高阈值</translation>
    </message>
    <message>
        <source>Link distance</source>
        <translation>连接距离</translation>
    </message>
    <message>
        <source>Link angle</source>
        <translation>连接角度</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>现用</translation>
    </message>
    <message>
        <source>On trial</source>
        <translation>试用</translation>
    </message>
    <message>
        <source>%1 on trial</source>
        <translation>%1，试用</translation>
    </message>
    <message>
        <source>%1: less</source>
        <translation>%1：减小</translation>
    </message>
    <message>
        <source>%1: more</source>
        <translation>%1：增大</translation>
    </message>
    <message>
        <source>Choose camera %1</source>
        <translation>选择相机 %1</translation>
    </message>
    <message>
        <source>Pixels with the line in use</source>
        <translation>含现用线的像素</translation>
    </message>
    <message>
        <source>Pixels with the line on trial</source>
        <translation>含试用线的像素</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>In use against on trial</source>
        <translation>现用与试用对比</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Gained, lost</source>
        <translation>增加，减少</translation>
    </message>
    <message>
        <source>Saturated points</source>
        <translation>饱和点数</translation>
    </message>
    <message>
        <source>Uncertainty, px</source>
        <translation>不确定度，px</translation>
    </message>
    <message>
        <source>Shift: mean, largest, px</source>
        <translation>偏移：平均，最大，px</translation>
    </message>
    <message>
        <source>Time, ms</source>
        <translation>时间，ms</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save the picture of the chosen camera (Ctrl+S)</source>
        <translation>保存所选相机的图像（Ctrl+S）</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>冻结</translation>
    </message>
    <message>
        <source>Live pictures again (P)</source>
        <translation>恢复实时图像（P）</translation>
    </message>
    <message>
        <source>Freeze the pictures (P)</source>
        <translation>冻结图像（P）</translation>
    </message>
    <message>
        <source>Freeze the pictures</source>
        <translation>冻结图像</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>The pictures behind the newest profile (B)</source>
        <translation>最新轮廓对应的图像（B）</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Discard what is on trial</source>
        <translation>放弃试用内容</translation>
    </message>
    <message>
        <source>Use from next rail</source>
        <translation>下一根起采用</translation>
    </message>
    <message>
        <source>Use what is on trial from the next rail on</source>
        <translation>自下一根钢轨起采用试用内容</translation>
    </message>
    <message>
        <source>Reason for the change</source>
        <translation>更改原因</translation>
    </message>
    <message>
        <source>These cameras&apos; exposure cannot be changed from here.</source>
        <translation>这些相机的曝光不能在此更改。</translation>
    </message>
    <message>
        <source>camera %1, frozen</source>
        <translation>相机 %1，已冻结</translation>
    </message>
    <message>
        <source>camera %1, live</source>
        <translation>相机 %1，实时</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>无图像</translation>
    </message>
    <message>
        <source>nothing on trial: change a parameter</source>
        <translation>无试用内容：更改一个参数</translation>
    </message>
</context>
<context>
    <name>vignole::VerdictPanel</name>
    <message>
        <source>Verdict: %1, %2. Gauge: %3</source>
        <translation>判定：%1，%2。测量仪：%3</translation>
    </message>
    <message>
        <source>Gauge: %1</source>
        <translation>测量仪：%1</translation>
    </message>
    <message>
        <source>SIMULATION, %1</source>
        <translation>仿真，%1</translation>
    </message>
</context>
<context>
    <name>vignole::WhatIfDialog</name>
    <message>
        <source>What if</source>
        <translation>假设</translation>
    </message>
    <message>
        <source>The rails that were found are judged again with other limits, from what is stored of every profile. Nothing that is stored changes.</source>
        <translation>按每个轮廓的存储数据，用其他限值重新评判所找钢轨。存储内容不变。</translation>
    </message>
    <message>
        <source>Profile class</source>
        <translation>轮廓等级</translation>
    </message>
    <message>
        <source>Straightness class</source>
        <translation>平直度等级</translation>
    </message>
    <message>
        <source>As in the recipe</source>
        <translation>同配方</translation>
    </message>
    <message>
        <source>lower, %1</source>
        <translation>下限，%1</translation>
    </message>
    <message>
        <source>upper, %1</source>
        <translation>上限，%1</translation>
    </message>
    <message>
        <source>Lower limit of %1, deviation</source>
        <translation>%1 下限，偏差</translation>
    </message>
    <message>
        <source>Upper limit of %1, deviation</source>
        <translation>%1 上限，偏差</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>钢轨</translation>
    </message>
    <message>
        <source>Was</source>
        <translation>原</translation>
    </message>
    <message>
        <source>Would be</source>
        <translation>将为</translation>
    </message>
    <message>
        <source>Because of</source>
        <translation>因</translation>
    </message>
    <message>
        <source>Rails whose verdict would change</source>
        <translation>判定将改变的钢轨</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>A limit of %1 is no number. An empty field is no limit.</source>
        <translation>%1 的限值不是数值。空字段表示无限值。</translation>
    </message>
    <message>
        <source>The lower limit of %1 is above the upper one: exchange them.</source>
        <translation>%1 的下限高于上限：请互换。</translation>
    </message>
    <message>
        <source>%1 of %2 rails judged</source>
        <translation>已评判 %1/%2 根钢轨</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>试算</translation>
    </message>
    <message>
        <source>Stop judging</source>
        <translation>停止评判</translation>
    </message>
    <message>
        <source>Judge the rails with these limits</source>
        <translation>用这些限值评判钢轨</translation>
    </message>
    <message>
        <source>No rail of this section is in the list. Search for rails first.</source>
        <translation>列表中没有该轨型的钢轨。请先搜索。</translation>
    </message>
    <message>
        <source>Judging …</source>
        <translation>评判中…</translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s) of section %1</source>
        <translation>
            <numerusform>轨型 %1 的 %n 根钢轨</numerusform>
        </translation>
    </message>
    <message>
        <source>Fewer than %1 rails prove little.</source>
        <translation>少于 %1 根钢轨说明不了问题。</translation>
    </message>
    <message>
        <source>Choose a class or enter deviations from nominal, then Try. Empty: no limit.</source>
        <translation>选择等级或输入相对名义值的偏差，然后试算。空：无限值。</translation>
    </message>
    <message>
        <source>%1 of %2 rails would change their verdict</source>
        <translation>%2 根钢轨中 %1 根将改变判定</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 根由%2变为%3</translation>
    </message>
    <message>
        <source>stopped before all %1 were judged</source>
        <translation>在评判全部 %1 根之前停止</translation>
    </message>
    <message numerus="yes">
        <source>%n could not be judged: %1</source>
        <translation>
            <numerusform>%n 根无法评判：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>fewer than %1 rails prove little</source>
        <translation>少于 %1 根钢轨说明不了问题</translation>
    </message>
</context>
<context>
    <name>vignole::WorthTable</name>
    <message>
        <source>Dimension</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>In force</source>
        <translation>现行</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>允许值</translation>
    </message>
    <message>
        <source>Largest part</source>
        <translation>最大分量</translation>
    </message>
    <message>
        <source>What the calibration is worth for each dimension</source>
        <translation>标定对各尺寸的不确定度</translation>
    </message>
    <message>
        <source>More than the tolerance allows</source>
        <translation>超过公差允许</translation>
    </message>
    <message>
        <source>too much: %1</source>
        <translation>过大：%1</translation>
    </message>
</context>
</TS>
