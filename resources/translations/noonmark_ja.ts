<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>Error</name>
    <message>
        <source>No city is open</source>
        <translation>都市が開かれていません</translation>
    </message>
    <message>
        <source>Open a file or a sample first</source>
        <translation>先にファイルかサンプルを開いてください</translation>
    </message>
    <message>
        <source>This result is already saved</source>
        <translation>この結果は保存済みです</translation>
    </message>
    <message>
        <source>Another result is being saved</source>
        <translation>別の結果を保存中です</translation>
    </message>
    <message>
        <source>Wait until it is saved</source>
        <translation>保存が終わるまでお待ちください</translation>
    </message>
    <message>
        <source>There is no result to save</source>
        <translation>保存する結果がありません</translation>
    </message>
    <message>
        <source>There is no result to export</source>
        <translation>書き出す結果がありません</translation>
    </message>
    <message>
        <source>There are no figures to copy</source>
        <translation>コピーする数値がありません</translation>
    </message>
    <message>
        <source>Press Run first</source>
        <translation>先に計算を押してください</translation>
    </message>
    <message>
        <source>The file was not opened: the project was changed while it was read</source>
        <translation>読み込み中にプロジェクトが変わったため、ファイルを開きませんでした</translation>
    </message>
    <message>
        <source>Save or undo the change, then open the file again</source>
        <translation>変更を保存するか元に戻してから、もう一度開いてください</translation>
    </message>
    <message>
        <source>The picture could not be written</source>
        <translation>画像を書き込めませんでした</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>別のフォルダーを選んでください</translation>
    </message>
    <message>
        <source>No ground of the city is visible</source>
        <translation>都市の地面が見えていません</translation>
    </message>
    <message>
        <source>Move the view to the city first</source>
        <translation>先に表示を都市へ移してください</translation>
    </message>
    <message>
        <source>The project has no lots, and this rule is about parcels</source>
        <translation>この規定は敷地についてのものですが、プロジェクトに敷地がありません</translation>
    </message>
    <message>
        <source>Draw the lot of the proposal: Edit &gt; Draw lot</source>
        <translation>計画案の敷地を描いてください: 編集 &gt; 敷地を描く</translation>
    </message>
    <message>
        <source>The project has no places yet</source>
        <translation>プロジェクトにまだ場所がありません</translation>
    </message>
    <message>
        <source>Read them from a map or draw one: Study &gt; Read places, Study &gt; Draw place</source>
        <translation>地図から読み込むか描いてください: 検討 &gt; 場所を読み込む、検討 &gt; 場所を描く</translation>
    </message>
    <message>
        <source>No place is chosen</source>
        <translation>場所が選ばれていません</translation>
    </message>
    <message>
        <source>Design a tower, or choose a scenario with a proposal</source>
        <translation>塔を設計するか、計画案のあるシナリオを選んでください</translation>
    </message>
    <message>
        <source>The building is still being designed</source>
        <translation>建物はまだ設計中です</translation>
    </message>
    <message>
        <source>Build it, then run the review</source>
        <translation>建設してから審査してください</translation>
    </message>
    <message>
        <source>There is no review to export</source>
        <translation>書き出す審査がありません</translation>
    </message>
    <message>
        <source>Press Run review first</source>
        <translation>先に「審査する」を押してください</translation>
    </message>
    <message>
        <source>The sides of the lot cross each other</source>
        <translation>敷地の辺が交差しています</translation>
    </message>
    <message>
        <source>Draw the corners in order around the lot</source>
        <translation>敷地の周りを順に角を描いてください</translation>
    </message>
    <message>
        <source>The polygon has no area</source>
        <translation>多角形に面積がありません</translation>
    </message>
    <message>
        <source>Draw it again with corners farther apart</source>
        <translation>角をもっと離して描き直してください</translation>
    </message>
    <message>
        <source>Click more corners, or press Esc</source>
        <translation>角をさらにクリックするか Esc を押してください</translation>
    </message>
    <message>
        <source>There is no region or place of this name</source>
        <translation>この名称の範囲や場所はありません</translation>
    </message>
    <message>
        <source>Choose one from the list</source>
        <translation>一覧から選んでください</translation>
    </message>
    <message>
        <source>No corner is selected</source>
        <translation>角が選択されていません</translation>
    </message>
    <message>
        <source>Click a corner of the lot, then press Delete</source>
        <translation>敷地の角をクリックしてから Delete を押してください</translation>
    </message>
    <message>
        <source>The direction of the side is not known</source>
        <translation>辺の方向がわかりません</translation>
    </message>
    <message>
        <source>Move the cursor to where the side leads, or type an azimuth: 40&lt;90</source>
        <translation>辺の向かう先へカーソルを動かすか、方位角を入力してください: 40&lt;90</translation>
    </message>
    <message>
        <source>This is not a length</source>
        <translation>長さではありません</translation>
    </message>
    <message>
        <source>Type it as 40, 40 m or 131&apos; 3&quot;, with an azimuth as 40&lt;90</source>
        <translation>40、40 m、131&apos; 3&quot; のように、方位角付きなら 40&lt;90 と入力してください</translation>
    </message>
    <message>
        <source>Some scenarios could not be computed</source>
        <translation>計算できなかったシナリオがあります</translation>
    </message>
    <message>
        <source>The panel Scenarios says why in the row of each</source>
        <translation>理由はパネル「シナリオ」の各行にあります</translation>
    </message>
    <message>
        <source>The folder holds no buildings</source>
        <translation>フォルダーに建物がありません</translation>
    </message>
    <message>
        <source>Choose a folder of footprints, city models or meshes</source>
        <translation>建物外形、都市モデル、またはメッシュのフォルダーを選んでください</translation>
    </message>
    <message>
        <source>The city has a terrain already</source>
        <translation>都市にはすでに地形があります</translation>
    </message>
    <message>
        <source>Open the city without it first</source>
        <translation>先に地形なしで都市を開いてください</translation>
    </message>
    <message>
        <source>A terrain can be added to city files only, before they are saved as a project</source>
        <translation>地形を追加できるのは、プロジェクトとして保存する前の都市ファイルだけです</translation>
    </message>
    <message>
        <source>Open the city files and the terrain together</source>
        <translation>都市ファイルと地形を一緒に開いてください</translation>
    </message>
    <message>
        <source>The city has an aerial photograph already</source>
        <translation>都市にはすでに航空写真があります</translation>
    </message>
    <message>
        <source>Remove it first: File &gt; Aerial photograph</source>
        <translation>先に削除してください: ファイル &gt; 航空写真</translation>
    </message>
    <message>
        <source>The file holds no such places near the city</source>
        <translation>ファイルには都市の近くにそのような場所がありません</translation>
    </message>
    <message>
        <source>Choose a map of this city with parks or streets, or a file of polygons</source>
        <translation>この都市の公園や道路を含む地図、または多角形のファイルを選んでください</translation>
    </message>
    <message>
        <source>The project has no place of this name any more</source>
        <translation>プロジェクトにはこの名前の場所がもうありません</translation>
    </message>
    <message>
        <source>Run again, so that the table lists the places as they are</source>
        <translation>もう一度計算すると、表が現在の場所を示します</translation>
    </message>
    <message>
        <source>Tick the places to review, or press In reach to find those that the shadow reaches</source>
        <translation>評価する場所を選ぶか、「到達範囲」を押して影が届く場所を探してください</translation>
    </message>
    <message>
        <source>It holds terrains only: open one by Open, or choose a folder of footprints, city models or meshes</source>
        <translation>地形だけが入っています。「開く」で一つ開くか、建物の外形、都市モデル、メッシュのフォルダを選んでください</translation>
    </message>
    <message>
        <source>There is no result</source>
        <translation>結果がありません</translation>
    </message>
</context>
<context>
    <name>FieldText</name>
    <message>
        <source>The rule of a review board by which the ticked places are judged. The list has the rules that come with Noonmark and those of your own.</source>
        <translation>選んだ場所を判定する審査機関の規定。一覧には付属の規定と自作の規定があります。</translation>
    </message>
    <message>
        <source>The scenario with the proposal. Displayed: whichever is chosen at the top of the window.</source>
        <translation>計画案のシナリオ。表示中: ウィンドウ上部で選ばれているもの。</translation>
    </message>
    <message>
        <source>A choice that the rule leaves to the case, such as a district or a zone.</source>
        <translation>地区や用途地域など、規定が個別に選ばせる項目。</translation>
    </message>
    <message>
        <source>How exactly the shadow is computed. The line below the list says what each choice means; its error is measured and stated beside the legend.</source>
        <translation>日影をどれだけ正確に計算するか。一覧の下の行に意味が出ます。誤差は実測され、凡例の横に示されます。</translation>
    </message>
    <message>
        <source>Shows or hides the time zone, the step of the sun and how sunrise is defined.</source>
        <translation>タイムゾーン、太陽の間隔、日の出の定義を表示/非表示。</translation>
    </message>
    <message>
        <source>Shows or hides the method and its options, for experts.</source>
        <translation>専門家向けの方法と設定を表示/非表示。</translation>
    </message>
    <message>
        <source>What the chart of a range of days shows: shadow in the scenario, in the baseline, or what the scenario adds.</source>
        <translation>日の範囲のグラフの内容: シナリオの日影、比較基準の日影、またはシナリオによる増加。</translation>
    </message>
    <message>
        <source>The places with their verdicts, and below each its days with the numbers behind it. A click shows the timeline, a double click zooms to the place.</source>
        <translation>場所と判定、その下に日ごとの数値。クリックで時系列、ダブルクリックで場所に拡大。</translation>
    </message>
    <message>
        <source>What the proposal is compared with.</source>
        <translation>計画案の比較対象。</translation>
    </message>
    <message>
        <source>Lists only the places whose name or kind contains this text.</source>
        <translation>名称か種類にこの文字を含む場所だけを表示。</translation>
    </message>
    <message>
        <source>The places that the review judges: those with a tick.</source>
        <translation>審査する場所: 印の付いたもの。</translation>
    </message>
    <message>
        <source>The size of the floor plate: as a share of the lot in per cent, or as an area in square metres.</source>
        <translation>基準階の大きさ: 敷地に占める割合 (%)、または面積 (m²)。</translation>
    </message>
    <message>
        <source>Adds a height above which the walls are set back from the edge of the plate.</source>
        <translation>壁が後退し始める高さを追加。</translation>
    </message>
    <message>
        <source>Removes the selected setback.</source>
        <translation>選択したセットバックを削除。</translation>
    </message>
    <message>
        <source>Heights, and how far the walls are set back above each, metres.</source>
        <translation>高さと、その上での壁の後退距離、メートル。</translation>
    </message>
    <message>
        <source>Ends placing; the scenario stays as it is.</source>
        <translation>配置を中止。シナリオは変わりません。</translation>
    </message>
    <message>
        <source>All that the project holds. Enter or a double click shows or uses a row, F2 renames it, Delete removes it, a right click has more.</source>
        <translation>プロジェクトの全内容。Enter かダブルクリックで表示・使用、F2 で名前変更、Delete で削除、右クリックでその他。</translation>
    </message>
    <message>
        <source>The scenarios side by side, with their figures for the same period and region. A click on a heading sorts them.</source>
        <translation>同じ期間・範囲の数値でシナリオを並べた表。見出しのクリックで並べ替え。</translation>
    </message>
    <message>
        <source>The intervals of the weight table: days of the year, hours of the day, and a weight from -1 (shadow unwanted) to 1 (shade wanted). Double-click a cell to change it.</source>
        <translation>重み表の区間: 年の日、1 日の時刻、重み (-1 影は望ましくない から 1 影が望ましい)。ダブルクリックで変更。</translation>
    </message>
    <message>
        <source>Does what the message proposes.</source>
        <translation>メッセージの提案を行います。</translation>
    </message>
    <message>
        <source>Does the other thing that the message proposes.</source>
        <translation>メッセージのもう一つの提案を行います。</translation>
    </message>
    <message>
        <source>The date that is shown, in the year of the period.</source>
        <translation>表示する日付 (期間の年)。</translation>
    </message>
    <message>
        <source>The wall-clock time that is shown, in the time zone of the study.</source>
        <translation>表示する時刻 (検討のタイムゾーン)。</translation>
    </message>
    <message>
        <source>The windows with their verdicts before and after, those that get worse first. A click on a column sorts by it, a click on a row tells when its window has sun.</source>
        <translation>窓と、以前・以後の判定です。悪化するものが先に並びます。列をクリックすると並べ替え、行をクリックするとその窓に日が当たる時間がわかります。</translation>
    </message>
    <message>
        <source>The places with their hours of sun. A click on a heading sorts them, a click on a row shows its place in the view.</source>
        <translation>場所とその日照時間。見出しのクリックで並べ替え、行のクリックでその場所を表示します。</translation>
    </message>
    <message>
        <source>The names of the scenarios, which stay in sight when the table is scrolled sideways. A double click shows a scenario.</source>
        <translation>シナリオの名称。表を横にスクロールしても見えたままです。ダブルクリックでシナリオを表示します。</translation>
    </message>
    <message>
        <source>What the study answers: minutes of shadow, the change that a scenario makes, a score of wanted and unwanted shadow, the verdicts of a board&apos;s rule, or the hours of sun of places.</source>
        <translation>検討の内容: 日影の分、シナリオによる変化、望ましい影と望ましくない影のスコア、審査機関の規定による判定、または場所の日照時間。</translation>
    </message>
</context>
<context>
    <name>KeySheet</name>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>left or middle drag</source>
        <translation>左または中ボタンでドラッグ</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>right drag, Shift+drag, arrow keys</source>
        <translation>右ボタンでドラッグ、Shift+ドラッグ、矢印キー</translation>
    </message>
    <message>
        <source>Zoom to the cursor</source>
        <translation>カーソル位置を拡大</translation>
    </message>
    <message>
        <source>wheel, + and -</source>
        <translation>ホイール、+ と -</translation>
    </message>
    <message>
        <source>Menu of what is there</source>
        <translation>その場所にあるもののメニュー</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>右クリック</translation>
    </message>
    <message>
        <source>Buildings</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>Select; another too</source>
        <translation>選択; 追加で選択</translation>
    </message>
    <message>
        <source>click; Ctrl+click</source>
        <translation>クリック; Ctrl+クリック</translation>
    </message>
    <message>
        <source>Select all in a rectangle</source>
        <translation>長方形の中をすべて選択</translation>
    </message>
    <message>
        <source>drag with Ctrl+Shift</source>
        <translation>Ctrl+Shift を押しながらドラッグ</translation>
    </message>
    <message>
        <source>Change the height</source>
        <translation>高さを変更</translation>
    </message>
    <message>
        <source>drag the arrow, or type the height and press Enter</source>
        <translation>矢印をドラッグ、または高さを入力して Enter</translation>
    </message>
    <message>
        <source>Deselect</source>
        <translation>選択を解除</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>描画</translation>
    </message>
    <message>
        <source>A corner</source>
        <translation>角</translation>
    </message>
    <message>
        <source>click; with Shift at right angles, with Ctrl without snapping</source>
        <translation>クリック。Shift で直角、Ctrl でスナップなし</translation>
    </message>
    <message>
        <source>A side of a stated length</source>
        <translation>長さを指定した辺</translation>
    </message>
    <message>
        <source>type it and press Enter</source>
        <translation>長さを入力して Enter</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>double click, Enter or right click</source>
        <translation>ダブルクリック、Enter、または右クリック</translation>
    </message>
    <message>
        <source>Remove the last corner; cancel</source>
        <translation>最後の角を削除; 中止</translation>
    </message>
    <message>
        <source>Backspace; Esc</source>
        <translation>Backspace; Esc</translation>
    </message>
</context>
<context>
    <name>LiveTrees</name>
    <message>
        <source>Live shade of trees</source>
        <translation>樹木の日陰(操作中)</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Read &amp;places into this project</source>
        <translation>場所をこのプロジェクトに読み込む(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Open as another city</source>
        <translation>別の都市として開く(&amp;O)</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>実測</translation>
    </message>
    <message>
        <source>from its storeys</source>
        <translation>階数から</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>仮定</translation>
    </message>
    <message>
        <source>from its mesh</source>
        <translation>メッシュから</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>設計値</translation>
    </message>
    <message>
        <source>synthetic</source>
        <translation>合成</translation>
    </message>
    <message>
        <source>; mesh is open: %1 estimated</source>
        <translation>; メッシュに隙間あり: %1 は推定</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部分</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Floor area</source>
        <translation>床面積</translation>
    </message>
    <message>
        <source>every pixel</source>
        <translation>全画素</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Open a project or a city</source>
        <translation>プロジェクトまたは都市を開く</translation>
    </message>
    <message>
        <source>Save project as</source>
        <translation>プロジェクトに名前を付けて保存</translation>
    </message>
    <message>
        <source>Projects (*%1)</source>
        <translation>プロジェクト (*%1)</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation>%1 は既に存在します。置き換えますか?</translation>
    </message>
    <message>
        <source>Import a mesh as a building</source>
        <translation>メッシュを建物として読み込む</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>メッシュ</translation>
    </message>
    <message>
        <source>Region from file</source>
        <translation>ファイルから範囲</translation>
    </message>
    <message>
        <source>Polygons</source>
        <translation>ポリゴン</translation>
    </message>
    <message>
        <source>Read places</source>
        <translation>場所を読み込む</translation>
    </message>
    <message>
        <source>Maps and polygons</source>
        <translation>地図とポリゴン</translation>
    </message>
    <message>
        <source>Save sun and sky</source>
        <translation>太陽と天空を保存</translation>
    </message>
    <message>
        <source>Drawing (*.svg);;Picture (*.png);;Minutes by month and hour (*.csv)</source>
        <translation>図 (*.svg);;画像 (*.png);;月別・時刻別の分 (*.csv)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>画像を保存</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>Export movie</source>
        <translation>動画を書き出す</translation>
    </message>
    <message>
        <source>Movies (*.mp4 *.gif)</source>
        <translation>動画 (*.mp4 *.gif)</translation>
    </message>
    <message>
        <source>Logo for the title block</source>
        <translation>表題欄のロゴ</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>画像 (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>%1 already contains these files: %2. Replace them?</source>
        <translation>%1 には既に次のファイルがあります: %2。置き換えますか?</translation>
    </message>
    <message>
        <source>Projects, cities and terrain</source>
        <translation>プロジェクト、都市、地形</translation>
    </message>
    <message>
        <source>Projects</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>Footprints</source>
        <translation>建物外形</translation>
    </message>
    <message>
        <source>3D models and meshes</source>
        <translation>3D モデルとメッシュ</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>地形</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>検討</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>シナリオ</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>重み</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>Tower</source>
        <translation>塔</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>審査</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>S&amp;un</source>
        <translation>太陽(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>パネル(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>S&amp;cenario</source>
        <translation>シナリオ(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Study</source>
        <translation>検討(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>Graphics: OpenGL on the processor; a graphics card is faster</source>
        <translation>グラフィックス: プロセッサ上の OpenGL。グラフィックカードの方が高速です</translation>
    </message>
    <message>
        <source>Graphics: OpenGL on a graphics card</source>
        <translation>グラフィックス: グラフィックカード上の OpenGL</translation>
    </message>
    <message>
        <source>System: %1, %2</source>
        <translation>システム: %1, %2</translation>
    </message>
    <message>
        <source>this moment</source>
        <translation>この時刻</translation>
    </message>
    <message>
        <source>%1; continuous shadow follows</source>
        <translation>%1。連続日影は後で表示</translation>
    </message>
    <message>
        <source>west</source>
        <translation>西</translation>
    </message>
    <message>
        <source>east</source>
        <translation>東</translation>
    </message>
    <message>
        <source>south</source>
        <translation>南</translation>
    </message>
    <message>
        <source>north</source>
        <translation>北</translation>
    </message>
    <message>
        <source>Gross floor area</source>
        <translation>延べ面積</translation>
    </message>
    <message>
        <source>Floor area ratio (FAR)</source>
        <translation>容積率</translation>
    </message>
    <message>
        <source>Lot coverage</source>
        <translation>建蔽率</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>階数</translation>
    </message>
    <message>
        <source>Buildings demolished</source>
        <translation>除却する建物</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>表示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Zoom to lot</source>
        <translation>敷地に拡大(&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;Zoom to place</source>
        <translation>場所に拡大(&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;Use as study region</source>
        <translation>検討範囲として使う(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Use as study period</source>
        <translation>検討期間として使う(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Edit and score</source>
        <translation>編集してスコアを計算(&amp;E)</translation>
    </message>
    <message>
        <source>City</source>
        <translation>都市</translation>
    </message>
    <message>
        <source>The existing city, from which every scenario starts</source>
        <translation>現況の都市。すべてのシナリオの出発点</translation>
    </message>
    <message>
        <source>Terrain of %1 × %2 points</source>
        <translation>地形 %1 × %2 点</translation>
    </message>
    <message>
        <source>Flat ground</source>
        <translation>平らな地面</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>%1 から</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>比較基準</translation>
    </message>
    <message>
        <source>Press Enter or double-click to show it</source>
        <translation>Enter またはダブルクリックで表示</translation>
    </message>
    <message>
        <source>Step %1 of %2; press Delete to remove it</source>
        <translation>%2 のステップ %1。Delete で削除</translation>
    </message>
    <message>
        <source>Lists of changes to the city; the displayed one is bold</source>
        <translation>都市への変更の一覧。表示中のものは太字</translation>
    </message>
    <message>
        <source>The existing city. Press Enter or double-click to show it</source>
        <translation>現況の都市。Enter またはダブルクリックで表示</translation>
    </message>
    <message>
        <source>Lots</source>
        <translation>敷地</translation>
    </message>
    <message>
        <source>Ground to build on</source>
        <translation>建てられる土地</translation>
    </message>
    <message>
        <source>%1, roads: %2</source>
        <translation>%1, 道路: %2</translation>
    </message>
    <message>
        <source>Press Enter or double-click to zoom to it</source>
        <translation>Enter またはダブルクリックで拡大</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>Where shadow is measured</source>
        <translation>日影を測る所</translation>
    </message>
    <message>
        <source>Press Enter or double-click to use it as the study region</source>
        <translation>Enter またはダブルクリックで検討範囲にする</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Areas whose sunlight matters: parks, playgrounds, school grounds...</source>
        <translation>日照が重要な所: 公園、遊び場、校庭など</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1
Press Enter or double-click to zoom to it</source>
        <translation>%1
Enter またはダブルクリックで拡大</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>期間</translation>
    </message>
    <message>
        <source>Days and hours to study</source>
        <translation>検討する日と時間</translation>
    </message>
    <message>
        <source>%1
Press Enter or double-click to use it as the study period</source>
        <translation>%1
Enter またはダブルクリックで検討期間にする</translation>
    </message>
    <message>
        <source>Weight tables</source>
        <translation>重み表</translation>
    </message>
    <message>
        <source>How much shade is wanted (up to 1) or shadow unwanted (down to -1), by time of year</source>
        <translation>季節ごとに影がどれだけ望ましいか (最大 1)、望ましくないか (最小 -1)</translation>
    </message>
    <message>
        <source>Press Enter or double-click to edit it and compute scores with it</source>
        <translation>Enter またはダブルクリックで編集し、スコアを計算</translation>
    </message>
    <message>
        <source>Saved results</source>
        <translation>保存した結果</translation>
    </message>
    <message>
        <source>Maps and figures saved in the project</source>
        <translation>プロジェクトに保存した図と数値</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 と %2 の比較</translation>
    </message>
    <message>
        <source>%1 of %2
Press Enter or double-click to show it again</source>
        <translation>%2 の%1
Enter またはダブルクリックで再表示</translation>
    </message>
    <message>
        <source>Contribution of this new building alone: ground with over %1 min a day more gross shadow than without it</source>
        <translation>この新築建物だけの寄与: 累計日影が 1 日に %1 分を超えて増える地面</translation>
    </message>
    <message>
        <source>no change</source>
        <translation>変化なし</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 増</translation>
    </message>
    <message>
        <source>%1 less</source>
        <translation>%1 減</translation>
    </message>
    <message>
        <source>Compared</source>
        <translation>比較対象</translation>
    </message>
    <message>
        <source>%1
with %2</source>
        <translation>%1
対 %2</translation>
    </message>
    <message>
        <source>Minutes of the first minus minutes of the second, with the same engine, steps and cells</source>
        <translation>同じエンジン、ステップ、セルでの前者の分から後者の分を引いた値</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>期間</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>計算エンジン</translation>
    </message>
    <message>
        <source>Used for both</source>
        <translation>両方に使用</translation>
    </message>
    <message>
        <source>Measured error against rays: %1 % of the area, %2 % of the minutes of a cell</source>
        <translation>レイとの誤差 (実測): 面積の %1 %、セルの分の %2 %</translation>
    </message>
    <message>
        <source>Continuous shadow was not counted</source>
        <translation>連続日影は集計していません</translation>
    </message>
    <message>
        <source>So far: %1 (%2 %)</source>
        <translation>途中: %1 (%2 %)</translation>
    </message>
    <message>
        <source>%1 with the weights %2</source>
        <translation>%1 (重み %2)</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>formerly ground, now built over</source>
        <translation>元は地面、今は建物</translation>
    </message>
    <message>
        <source>formerly building, now ground</source>
        <translation>元は建物、今は地面</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>測定なし</translation>
    </message>
    <message>
        <source>now in shadow</source>
        <translation>今は日影</translation>
    </message>
    <message>
        <source>now in the sun</source>
        <translation>今は日なた</translation>
    </message>
    <message>
        <source>change: gross %1 min a day</source>
        <translation>変化: 累計 %1 分/日</translation>
    </message>
    <message>
        <source>, continuous %1 min</source>
        <translation>, 連続 %1 分</translation>
    </message>
    <message>
        <source>So far: %1</source>
        <translation>途中: %1</translation>
    </message>
    <message>
        <source>Refining: %1</source>
        <translation>細密化中: %1</translation>
    </message>
    <message>
        <source>Computing the shadow in the view...</source>
        <translation>表示中の日影を計算しています...</translation>
    </message>
    <message>
        <source>No study yet: choose a period and a region, then press Run (Ctrl+R)</source>
        <translation>まだ検討がありません。期間と範囲を選び、計算 (Ctrl+R) を押してください</translation>
    </message>
    <message>
        <source>Against the ray reference, on a sample of the receivers over the same steps</source>
        <translation>同じステップで抽出した測定点によるレイ基準との比較</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Time taken by the engine</source>
        <translation>エンジンの計算時間</translation>
    </message>
    <message>
        <source>Steps of the sun</source>
        <translation>太陽位置の数</translation>
    </message>
    <message>
        <source>Sunlit time</source>
        <translation>日照時間</translation>
    </message>
    <message>
        <source> min/day</source>
        <translation> 分/日</translation>
    </message>
    <message>
        <source>Mean minutes a day with the sun above the horizon: 100 % of the time</source>
        <translation>太陽が地平線より上にある 1 日の平均分: 時間の 100 %</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>評価対象</translation>
    </message>
    <message>
        <source>%1
with the weights %2</source>
        <translation>%1
重み %2</translation>
    </message>
    <message>
        <source>at an unknown date</source>
        <translation>日付不明</translation>
    </message>
    <message>
        <source>Saved %1: %2</source>
        <translation>%1 に保存: %2</translation>
    </message>
    <message>
        <source>%1. Outdated</source>
        <translation>%1。古い結果です</translation>
    </message>
    <message>
        <source>Saved result</source>
        <translation>保存した結果</translation>
    </message>
    <message>
        <source>As saved in the project, not recomputed</source>
        <translation>プロジェクトに保存したまま。再計算していません</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>シナリオ</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>%1
cells of %2 m</source>
        <translation>%1
セル %2 m</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>名称なし</translation>
    </message>
    <message>
        <source>Computed by</source>
        <translation>計算に使用</translation>
    </message>
    <message>
        <source>%1, saved %2</source>
        <translation>%1, %2 に保存</translation>
    </message>
    <message>
        <source>A result saved %1.</source>
        <translation>%1 に保存した結果。</translation>
    </message>
    <message>
        <source>Its inputs have not changed since.</source>
        <translation>入力はその後変わっていません。</translation>
    </message>
    <message>
        <source>Of a theoretical sum of %1, %2 % are in shadow in the baseline and %3 % in the scenario; incremental shadow takes %4 (%5 %)</source>
        <translation>理論上の合計 %1 のうち、比較基準では %2 %、シナリオでは %3 % が日影。増加日影は %4 (%5 %)</translation>
    </message>
    <message>
        <source>, most on %1</source>
        <translation>, 最大は %1</translation>
    </message>
    <message>
        <source>✓ pass</source>
        <translation>✓ 適合</translation>
    </message>
    <message>
        <source>≈ borderline</source>
        <translation>≈ 境界</translation>
    </message>
    <message>
        <source>✗ fail</source>
        <translation>✗ 不適合</translation>
    </message>
    <message>
        <source>– not applicable</source>
        <translation>– 対象外</translation>
    </message>
    <message>
        <source>? not checked</source>
        <translation>? 未確認</translation>
    </message>
    <message>
        <source>building</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>building, %1</source>
        <translation>建物, %1</translation>
    </message>
    <message>
        <source>lot</source>
        <translation>敷地</translation>
    </message>
    <message>
        <source>street</source>
        <translation>道路</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>ほか %1 件</translation>
    </message>
    <message>
        <source>park</source>
        <translation>公園</translation>
    </message>
    <message>
        <source>playground</source>
        <translation>遊び場</translation>
    </message>
    <message>
        <source>schoolyard</source>
        <translation>校庭</translation>
    </message>
    <message>
        <source>plaza</source>
        <translation>広場</translation>
    </message>
    <message>
        <source>cemetery</source>
        <translation>墓地</translation>
    </message>
    <message>
        <source>facade</source>
        <translation>外壁面</translation>
    </message>
    <message>
        <source>stained glass</source>
        <translation>ステンドグラス</translation>
    </message>
    <message>
        <source>other place</source>
        <translation>その他の場所</translation>
    </message>
    <message>
        <source>No region yet</source>
        <translation>範囲がありません</translation>
    </message>
    <message>
        <source>%1 million</source>
        <translation>%1 百万</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2。</translation>
    </message>
    <message>
        <source>%1 %2 Rays would take %3.</source>
        <translation>%1 %2 レイでは %3。</translation>
    </message>
    <message>
        <source>days</source>
        <translation>日</translation>
    </message>
    <message>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <source>min</source>
        <translation>分</translation>
    </message>
    <message>
        <source>s</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>about %1 %2</source>
        <translation>約 %1 %2</translation>
    </message>
    <message>
        <source>about a second</source>
        <translation>約 1 秒</translation>
    </message>
    <message>
        <source>%1 %2: %3</source>
        <translation>%1 %2: %3</translation>
    </message>
    <message>
        <source>and %1 more, listed in study.json of an export</source>
        <translation>ほか %1 件 (書き出しの study.json に記載)</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>速い</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>厳密</translation>
    </message>
    <message>
        <source>Reference (rays)</source>
        <translation>基準 (レイ)</translation>
    </message>
    <message>
        <source>Own settings</source>
        <translation>独自の設定</translation>
    </message>
    <message>
        <source>Exact where that is quick; over long periods off by 0.04 % of the time on average, and the error is measured</source>
        <translation>短時間で済む所では厳密。長期間では時間の平均 0.04 % の誤差があり、誤差は実測されます</translation>
    </message>
    <message>
        <source>The outline of every shadow at every step, without rounding</source>
        <translation>各ステップの影の輪郭を丸めずに計算</translation>
    </message>
    <message>
        <source>One ray for every cell and step: what the other ways are checked against</source>
        <translation>セルとステップごとにレイ 1 本。他の方法の検証基準</translation>
    </message>
    <message>
        <source>The method and the options chosen below</source>
        <translation>下で選んだ方法と設定</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>今日</translation>
    </message>
    <message>
        <source>21 March</source>
        <translation>3 月 21 日</translation>
    </message>
    <message>
        <source>21 June</source>
        <translation>6 月 21 日</translation>
    </message>
    <message>
        <source>21 December</source>
        <translation>12 月 21 日</translation>
    </message>
    <message>
        <source>Growing season (October to April)</source>
        <translation>生育期 (10 月から 4 月)</translation>
    </message>
    <message>
        <source>Growing season (April to October)</source>
        <translation>生育期 (4 月から 10 月)</translation>
    </message>
    <message>
        <source>Whole year</source>
        <translation>1 年間</translation>
    </message>
    <message>
        <source>Own dates</source>
        <translation>日付を指定</translation>
    </message>
    <message>
        <source>How many minutes each spot is in shadow on a mean day of the period, and the longest time without a break</source>
        <translation>期間の平均的な 1 日に各地点が日影になる分数と、途切れない最長時間</translation>
    </message>
    <message>
        <source>Minutes of shadow that the scenario adds or takes away, against the city chosen under &quot;compare with&quot;</source>
        <translation>「比較対象」で選んだ都市に対し、シナリオが増減させる日影の分</translation>
    </message>
    <message>
        <source>Shadow weighed by hour and month: wanted in summer, unwanted in winter. Choose the weights in the panel Weights</source>
        <translation>時刻と月で重み付けした影: 夏は望ましく、冬は望ましくない。重みは「重み」パネルで選択</translation>
    </message>
    <message>
        <source>Pass or fail of parks and other places by a board&apos;s rule. Choose it in the panel Review</source>
        <translation>公園などの場所が審査機関の規定に適合するか。規定は「審査」パネルで選択</translation>
    </message>
    <message>
        <source>N</source>
        <translation>北</translation>
    </message>
    <message>
        <source>NE</source>
        <translation>北東</translation>
    </message>
    <message>
        <source>E</source>
        <translation>東</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>南東</translation>
    </message>
    <message>
        <source>S</source>
        <translation>南</translation>
    </message>
    <message>
        <source>SW</source>
        <translation>南西</translation>
    </message>
    <message>
        <source>W</source>
        <translation>西</translation>
    </message>
    <message>
        <source>NW</source>
        <translation>北西</translation>
    </message>
    <message>
        <source>Sun below the horizon</source>
        <translation>太陽は地平線の下</translation>
    </message>
    <message>
        <source>Sun %1° %2, %3° high</source>
        <translation>太陽 %1° %2、高度 %3°</translation>
    </message>
    <message>
        <source>%1 % in shadow</source>
        <translation>%1 % が日影</translation>
    </message>
    <message>
        <source>in shadow</source>
        <translation>日影</translation>
    </message>
    <message>
        <source>in the sun</source>
        <translation>日なた</translation>
    </message>
    <message>
        <source>gross %1 min a day</source>
        <translation>累計 %1 分/日</translation>
    </message>
    <message>
        <source>Ray reference</source>
        <translation>レイ基準</translation>
    </message>
    <message>
        <source>Shadow on the ground of the region, cell by cell, with figures, report and files.
Computed by the engine of the study when you press Run.</source>
        <translation>範囲の地面の日影をセルごとに、数値・報告書・ファイルとともに求めます。
計算を押すと検討のエンジンで計算します。</translation>
    </message>
    <message>
        <source>in the middle of the picture</source>
        <translation>画像の中央</translation>
    </message>
    <message>
        <source>%1.
Default: %2</source>
        <translation>%1。
既定: %2</translation>
    </message>
    <message>
        <source>%1.
%2 to %3 %4, usually %5</source>
        <translation>%1。
%2 から %3 %4、通常 %5</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> (階高 %1)</translation>
    </message>
    <message>
        <source>d MMM</source>
        <translation>M月d日</translation>
    </message>
    <message>
        <source>d MMMM</source>
        <translation>M月d日</translation>
    </message>
    <message>
        <source>d MMM yyyy</source>
        <translation>yyyy年M月d日</translation>
    </message>
    <message>
        <source>d MMMM yyyy</source>
        <translation>yyyy年M月d日</translation>
    </message>
    <message>
        <source>%1, %2
%3 floor area, FAR %4</source>
        <translation>%1, %2
延べ面積 %3, 容積率 %4</translation>
    </message>
    <message>
        <source>%1 %2, %3 %4</source>
        <translation>%1 %2, %3 %4</translation>
    </message>
    <message>
        <source>%1   height %2   x %3 m, y %4 m</source>
        <translation>%1   高さ %2   x %3 m, y %4 m</translation>
    </message>
    <message>
        <source>%1, %2 high</source>
        <translation>%1, 高さ %2</translation>
    </message>
    <message>
        <source>Mo&amp;de</source>
        <translation>モード(&amp;D)</translation>
    </message>
    <message>
        <source>Guided &amp;tours</source>
        <translation>ガイドツアー(&amp;T)</translation>
    </message>
    <message>
        <source>Plan, elevat&amp;ions, from the sun</source>
        <translation>平面図・立面図・太陽から(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Go to this view</source>
        <translation>この表示に移る(&amp;G)</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>平行投影</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>透視投影</translation>
    </message>
    <message>
        <source>%1, %2 %3</source>
        <translation>%1、%2 %3</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>%1
Press Enter or double-click to go to it</source>
        <translation>%1
Enter またはダブルクリックで移ります</translation>
    </message>
    <message>
        <source>%1, %2 up (%3 in space)</source>
        <translation>%1、上に %2 (空間で %3)</translation>
    </message>
    <message>
        <source>%1, %2 down (%3 in space)</source>
        <translation>%1、下に %2 (空間で %3)</translation>
    </message>
    <message>
        <source>%1
All sides %2, area %3</source>
        <translation>%1
全辺 %2、面積 %3</translation>
    </message>
    <message>
        <source>%1 h of sun a day, at most %2 h without a break</source>
        <translation>1日の日照%1時間、連続で最長%2時間</translation>
    </message>
    <message>
        <source>floor %1, %2</source>
        <translation>%1階、%2</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>誤差</translation>
    </message>
    <message>
        <source>Against the ray reference, on a sample of the points over the same steps</source>
        <translation>光線による基準との差。点の標本を同じステップで比較</translation>
    </message>
    <message>
        <source>Horizons of the points</source>
        <translation>点の地平線</translation>
    </message>
    <message>
        <source>Windows from file</source>
        <translation>ファイルの窓</translation>
    </message>
    <message>
        <source>Points and polygons</source>
        <translation>点とポリゴン</translation>
    </message>
    <message>
        <source>Facades and points</source>
        <translation>ファサードと点</translation>
    </message>
    <message>
        <source>the floor plate is smaller</source>
        <translation>基準階を縮小</translation>
    </message>
    <message>
        <source>the tower is not turned</source>
        <translation>タワーの回転なし</translation>
    </message>
    <message>
        <source>upper setbacks are left out</source>
        <translation>上部のセットバックを省略</translation>
    </message>
    <message>
        <source>To fit this lot: %1.</source>
        <translation>この敷地に合わせるための変更: %1。</translation>
    </message>
    <message>
        <source>Aerial photograph</source>
        <translation>航空写真</translation>
    </message>
    <message>
        <source>Pictures with a position</source>
        <translation>位置情報を持つ画像</translation>
    </message>
    <message>
        <source>Save the tiles as a photograph</source>
        <translation>タイルを写真として保存</translation>
    </message>
    <message>
        <source>GeoTIFF (*.tif)</source>
        <translation>GeoTIFF (*.tif)</translation>
    </message>
    <message>
        <source>Points from file</source>
        <translation>ファイルから点を読み込む</translation>
    </message>
    <message>
        <source>Tables of points</source>
        <translation>点の表</translation>
    </message>
    <message>
        <source>the tower is not twisted</source>
        <translation>タワーにねじれなし</translation>
    </message>
    <message>
        <source>Use not stated</source>
        <translation>用途の指定なし</translation>
    </message>
    <message>
        <source>From, above datum</source>
        <translation>開始(基準面から)</translation>
    </message>
    <message>
        <source>From height</source>
        <translation>開始高さ</translation>
    </message>
    <message>
        <source>Inset</source>
        <translation>後退</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>先細り</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>ねじれ</translation>
    </message>
    <message>
        <source>%1, section box</source>
        <translation>%1、断面ボックス</translation>
    </message>
    <message>
        <source>Camera, projection, section box and moment, saved with Ctrl+Shift+V</source>
        <translation>カメラ、投影、断面ボックス、時点。Ctrl+Shift+V で保存</translation>
    </message>
    <message>
        <source>%1, floor %2   before: %3, after: %4</source>
        <translation>%1、%2階   前：%3、後：%4</translation>
    </message>
    <message>
        <source> °</source>
        <translation> °</translation>
    </message>
    <message>
        <source>%1, top %2</source>
        <translation>%1、上端 %2</translation>
    </message>
    <message>
        <source>%1 above datum</source>
        <translation>基準面から %1</translation>
    </message>
    <message>
        <source>%1 above ground</source>
        <translation>地盤から %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 more kind(s) of notes</source>
        <translation>
            <numerusform>ほかに %1 種類の通知があります</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 place(s) were read</source>
        <translation>
            <numerusform>%1 か所を読み込みました</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; %1 replace(s) earlier ones</source>
        <translation>
            <numerusform>; %1 か所は既存のものを置き換えました</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a sample every %1 pixel(s)</source>
        <translation>
            <numerusform>%1 画素ごとに 1 点</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 day(s); %3</source>
        <translation>
            <numerusform>%2 日中 %1 日; %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>all %1 step(s)</source>
        <translation>
            <numerusform>全 %1 ステップ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 storey(s)</source>
        <translation>
            <numerusform>%1 階</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s)</source>
        <translation>
            <numerusform>建物 %1 棟</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 occlusion ray(s) divided by the engine&apos;s time</source>
        <translation>
            <numerusform>遮蔽レイ %1 本をエンジンの時間で割った値</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Positions of the sun above the horizon; %1 below it was/were left out</source>
        <translation>
            <numerusform>地平線より上の太陽位置。下の %1 は除外</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 window(s): %2</source>
        <translation>
            <numerusform>窓 %1 か所: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 window(s): %2.</source>
        <translation>
            <numerusform>窓 %1 か所: %2。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Compared with before, %1 get(s) worse and %2 better</source>
        <translation>
            <numerusform>以前と比べて悪化 %1、改善 %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1
%2 × %3, %4, %5 cell(s)</source>
        <translation>
            <numerusform>%1
%2 × %3, %4, %5 セル</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 point(s)</source>
        <translation>
            <numerusform>%1 点</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cell(s)</source>
        <translation>
            <numerusform>%1 セル</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 position(s) of the sun</source>
        <translation>
            <numerusform>太陽位置 %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Not counted: %1 building(s) whose floors are not known</source>
        <translation>
            <numerusform>階が不明な建物 %1 棟は数えていません</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>by rays</source>
        <translation>光線による</translation>
    </message>
    <message>
        <source>by shadow accrual maps</source>
        <translation>影の累積マップによる</translation>
    </message>
    <message>
        <source>%1, %2 m, %3</source>
        <translation>%1、%2 m、%3</translation>
    </message>
    <message>
        <source>, storeys of %1</source>
        <translation>、階高 %1</translation>
    </message>
    <message>
        <source>; %1 without a storey on the ground</source>
        <translation>(地面に階のない %1 棟を除く)</translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s) selected</source>
        <translation>
            <numerusform>%1 棟を選択中</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 over %2 min</source>
        <translation>%2 分超 %1</translation>
    </message>
    <message>
        <source>No new shadow</source>
        <translation>新しい影なし</translation>
    </message>
    <message>
        <source>New shadow: %1</source>
        <translation>新しい影: %1</translation>
    </message>
    <message>
        <source>Worst spot: +%1 min a day</source>
        <translation>最大の地点: 1日 +%1 分</translation>
    </message>
    <message>
        <source>Less shadow: %1</source>
        <translation>減った影: %1</translation>
    </message>
    <message>
        <source>Less shadow a day: %1</source>
        <translation>1日の減った影: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2, up to +%3 min</source>
        <translation>%1: %2、最大 +%3 分</translation>
    </message>
    <message>
        <source> (of the part that is measured)</source>
        <translation> (計測した部分)</translation>
    </message>
    <message numerus="yes">
        <source>and %1 more place(s)</source>
        <translation>
            <numerusform>ほか %1 か所</numerusform>
        </translation>
    </message>
    <message>
        <source>exact at %1</source>
        <translation>%1で厳密</translation>
    </message>
    <message numerus="yes">
        <source>exact at %1 of %2 step(s)</source>
        <translation>
            <numerusform>%2 ステップ中 %1 で厳密</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, within 0.25° of azimuth</source>
        <translation>%1、方位角 0.25° 以内</translation>
    </message>
    <message>
        <source>With the proposal: %1</source>
        <translation>提案を含む: %1</translation>
    </message>
    <message>
        <source>Change by the proposal, compared with %1: %2</source>
        <translation>提案による変化（%1 と比較）: %2</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>角</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>辺</translation>
    </message>
    <message>
        <source>sq ft</source>
        <translation>平方フィート</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>フィート</translation>
    </message>
    <message>
        <source>The change reaches beyond the ground that is measured</source>
        <translation>変化は計測した地面の外まで及びます</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>約%1</translation>
    </message>
    <message>
        <source>Measured error of the longest shadow against rays, of the longest day: %1 % in the mean, %2 % at the 99th percentile, %3 % at most</source>
        <translation>光線に対する最長の影の実測誤差（最も長い日に対する割合）：平均 %1 %、99 パーセンタイル %2 %、最大 %3 %</translation>
    </message>
    <message>
        <source>Measured error against rays: %1 % of the time in the sun</source>
        <translation>光線に対する実測誤差：日照時間の %1 %</translation>
    </message>
    <message>
        <source>Outdated: buildings have changed</source>
        <translation>古い結果: 建物が変わりました</translation>
    </message>
    <message>
        <source>%1. Outdated: buildings have changed</source>
        <translation>%1。古い結果: 建物が変わりました</translation>
    </message>
    <message>
        <source>%1 &gt; %2 min: %3</source>
        <translation>%1 &gt; %2 分：%3</translation>
    </message>
    <message>
        <source>Saved result %1</source>
        <translation>保存した結果 %1</translation>
    </message>
    <message>
        <source>The month&apos;s contribution to the score</source>
        <translation>その月のスコアへの寄与</translation>
    </message>
    <message>
        <source>Interval of the table: its weight, and its contribution to the score</source>
        <translation>表の区間：重みとスコアへの寄与</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>表を保存</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>A cell: %1 %3 in the mean, 99 of 100 within %2 %3</source>
        <translation>セル: 平均 %1 %3、100 のうち 99 は %2 %3 以内</translation>
    </message>
    <message>
        <source>%1 h of sun a day (%2 % of the sunlit time)</source>
        <translation>日照 1 日 %1 時間 (可照時間の %2 %)</translation>
    </message>
    <message>
        <source>, continuous shadow %1 min</source>
        <translation>、連続日影 %1 分</translation>
    </message>
    <message>
        <source>change: sun %1 min a day</source>
        <translation>変化: 日照 %1 分/日</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a term and its definition</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 min a day in shadow</source>
        <translation>日影 1 日 %1 分</translation>
    </message>
    <message>
        <source>%1 min a day in shadow, %2 % of the sunlit time</source>
        <translation>日影 1 日 %1 分、可照時間の %2 %</translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s) shade it; %2 takes the most, %3 %</source>
        <translation>
            <numerusform>%1 棟が影を落としています。最も多いのは %2 で %3 %</numerusform>
        </translation>
    </message>
    <message>
        <source>No building shades it in the period.</source>
        <translation>期間中に影を落とす建物はありません。</translation>
    </message>
    <message>
        <source>The scenario minus the scenario without this building: what it adds alone, on ground that is open in both scenarios</source>
        <translation>シナリオからこの建物のないシナリオを引いた値: 両シナリオとも建物のない地面に、この建物だけが加える影</translation>
    </message>
    <message>
        <source>Share, %</source>
        <translation>割合、%</translation>
    </message>
    <message>
        <source>Share of the sum of what each new building adds alone</source>
        <translation>新築建物がそれぞれ単独で加える影の合計に対する割合</translation>
    </message>
    <message>
        <source>Adds, min a day</source>
        <translation>増加、分/日</translation>
    </message>
    <message>
        <source>; mean over the cells</source>
        <translation>。セルの平均</translation>
    </message>
    <message>
        <source>Adds a day</source>
        <translation>1 日の増加</translation>
    </message>
    <message>
        <source>; area × hours a day</source>
        <translation>。1 日の面積 × 時間</translation>
    </message>
    <message>
        <source>Attributed by: %1
The study: %2</source>
        <translation>配分の計算: %1
検討: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 compared with %2: %3 min a day in shadow, mean over %4 cell(s).</source>
        <translation>
            <numerusform>%1 と %2 の比較: 日影 1 日 %3 分 (%4 セルの平均)。</numerusform>
        </translation>
    </message>
    <message>
        <source>&lt; %1 %</source>
        <translation>&lt; %1 %</translation>
    </message>
    <message>
        <source>≥ %1 %</source>
        <translation>≥ %1 %</translation>
    </message>
    <message>
        <source>%1-%2 %</source>
        <comment>from and to, per cent</comment>
        <translation>%1-%2 %</translation>
    </message>
    <message>
        <source>%1, %</source>
        <translation>%1、%</translation>
    </message>
    <message>
        <source>%1, m²</source>
        <translation>%1、m²</translation>
    </message>
    <message>
        <source>%1, min</source>
        <translation>%1、分</translation>
    </message>
    <message>
        <source>%1, h</source>
        <translation>%1、時間</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 から %2</translation>
    </message>
    <message>
        <source>This method does not sum months. These do: %1.</source>
        <translation>この方法では月別の合計を求められません。求められる方法: %1。</translation>
    </message>
    <message>
        <source>This method does not tell buildings apart. These do: %1.</source>
        <translation>この方法では建物を区別できません。区別できる方法: %1。</translation>
    </message>
    <message>
        <source>Hours of sun a day of each park, street and other place: over the period, by month and on stated dates, in a table beside the map</source>
        <translation>公園、街路などの場所ごとの 1 日の日照時間: 期間全体、月別、指定日について、地図の横の表に示します</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>寄与</translation>
    </message>
    <message>
        <source>%1 h of sun a day</source>
        <translation>日照 1 日 %1 時間</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1, %2 without a cell</source>
        <translation>%1、うちセルなし %2</translation>
    </message>
    <message>
        <source>Each is a row of the panel Places</source>
        <translation>それぞれが「場所」パネルの 1 行になります</translation>
    </message>
    <message>
        <source>Without shadow</source>
        <translation>影がない場合</translation>
    </message>
    <message>
        <source>Sun above the horizon, mean over the days</source>
        <translation>太陽が地平線より上にある時間 (日の平均)</translation>
    </message>
    <message>
        <source>Least sun</source>
        <translation>最小の日照</translation>
    </message>
    <message>
        <source>Most sun</source>
        <translation>最大の日照</translation>
    </message>
    <message>
        <source>Against the ray reference, on a sample of the cells over the same steps</source>
        <translation>同じステップで抽出したセルによるレイ基準との比較</translation>
    </message>
    <message>
        <source>Time taken by all of it</source>
        <translation>全体の所要時間</translation>
    </message>
    <message>
        <source>Parks</source>
        <translation>公園</translation>
    </message>
    <message>
        <source>Playgrounds</source>
        <translation>遊び場</translation>
    </message>
    <message>
        <source>Schoolyards</source>
        <translation>校庭</translation>
    </message>
    <message>
        <source>Plazas</source>
        <translation>広場</translation>
    </message>
    <message>
        <source>Cemeteries</source>
        <translation>墓地</translation>
    </message>
    <message>
        <source>Streets</source>
        <translation>道路</translation>
    </message>
    <message>
        <source>Facades</source>
        <translation>外壁面</translation>
    </message>
    <message>
        <source>Stained glass</source>
        <translation>ステンドグラス</translation>
    </message>
    <message>
        <source>Other places</source>
        <translation>その他の場所</translation>
    </message>
    <message>
        <source>&amp;Copy the values</source>
        <translation>値をコピー(&amp;C)</translation>
    </message>
    <message>
        <source>Contribution of this new building alone: ground that loses over %1 min of sun a day by it</source>
        <translation>この新しい建物だけの寄与：それによって 1 日 %1 分を超える日照を失う地面</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>Export buildings</source>
        <translation>建物を書き出す</translation>
    </message>
    <message>
        <source>Attributed by: %1</source>
        <translation>寄与の算出：%1</translation>
    </message>
    <message>
        <source>– figures only</source>
        <translation>– 数値のみ</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>誤差：%1</translation>
    </message>
    <message numerus="yes">
        <source>Against the ray reference, of a sample of %1 value(s)</source>
        <translation>
            <numerusform>光線基準との比較、%1 個の値の標本</numerusform>
        </translation>
    </message>
    <message>
        <source>lawn or bed</source>
        <translation>芝生または花壇</translation>
    </message>
    <message>
        <source>Lawns and beds</source>
        <translation>芝生と花壇</translation>
    </message>
    <message>
        <source>the whole lot</source>
        <translation>敷地全体</translation>
    </message>
    <message>
        <source> (top: %1)</source>
        <translation> （最上階：%1）</translation>
    </message>
    <message>
        <source>%1   %2</source>
        <translation>%1   %2</translation>
    </message>
    <message>
        <source>Hides these panels, for more of the view, and shows them again</source>
        <translation>これらのパネルを隠して表示を広げ、再び表示します</translation>
    </message>
    <message>
        <source>Panels at the left</source>
        <translation>左のパネル</translation>
    </message>
    <message>
        <source>Panels at the right</source>
        <translation>右のパネル</translation>
    </message>
    <message>
        <source>Panels below</source>
        <translation>下のパネル</translation>
    </message>
    <message>
        <source>As&amp;k</source>
        <translation>質問(&amp;K)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>takes %1 min of sun a day, %2 % of its shadow</source>
        <translation>日照を 1 日 %1 分減らす。その影の %2 %</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>備考</translation>
    </message>
    <message>
        <source>%1 million rays a second</source>
        <translation>毎秒 %1 百万レイ</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>Sun and shadow of a moment or a period on all visible surfaces: ground, roofs and facades.
Updated when the view or the time changes, coarse at first, then pixel by pixel.</source>
        <translation>ある時点または期間の日なたと影を、地面・屋根・ファサードなど見えるすべての面に示します。
表示や時刻が変わると、まず粗く、次に画素ごとに更新します。</translation>
    </message>
    <message>
        <source>Verdicts by the rules of review boards, of a proposal or of the existing city.
Opens the panel Review.</source>
        <translation>審査機関の規定による、計画案または既存の街の判定。
「審査」パネルを開きます。</translation>
    </message>
    <message>
        <source>Heights of buildings:</source>
        <translation>建物の高さ:</translation>
    </message>
    <message>
        <source>height %1</source>
        <translation>高さ %1</translation>
    </message>
    <message numerus="yes">
        <source>; %1 place(s) were there before and stay as they are</source>
        <translation>
            <numerusform>; うち %1 か所は以前からあり、そのまま残ります</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 h of sun a day, %2 % of the sunlit time</source>
        <translation>1日の日照 %1 時間、日照時間の %2 %</translation>
    </message>
    <message numerus="yes">
        <source>%1 compared with %2: %3 min of sun a day, mean over %4 cell(s).</source>
        <translation>
            <numerusform>%1 と %2 の比較:1日の日照 %3 分、%4 セルの平均。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cell(s); in the study itself %2.</source>
        <translation>
            <numerusform>%1 セル。調査自体では %2。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: minutes of shadow</source>
        <translation>%1: 影の分数</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>レイヤ(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名前(&amp;N)</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>読み込む</translation>
    </message>
    <message>
        <source>%1 (%2 features)</source>
        <translation>%1 (地物 %2 件)</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>種類(&amp;K)</translation>
    </message>
    <message>
        <source>Found automatically</source>
        <translation>自動で選択</translation>
    </message>
    <message>
        <source>%1 min of shadow a day</source>
        <translation>1 日あたり影 %1 分</translation>
    </message>
    <message>
        <source>Max shadow</source>
        <translation>最大の影</translation>
    </message>
    <message>
        <source>Min shadow</source>
        <translation>最小の影</translation>
    </message>
    <message>
        <source>Mean shadow</source>
        <translation>平均の影</translation>
    </message>
    <message>
        <source>Most shadow</source>
        <translation>影が最も多い</translation>
    </message>
    <message>
        <source>The place with least sun in the mean</source>
        <translation>平均で日照が最も少ない場所</translation>
    </message>
    <message>
        <source>Least shadow</source>
        <translation>影が最も少ない</translation>
    </message>
    <message>
        <source>The place with most sun in the mean</source>
        <translation>平均で日照が最も多い場所</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>樹木</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>score %1 m² a m²</source>
        <translation>スコア %1 m²/m²</translation>
    </message>
    <message>
        <source>&amp;Heights of the trees&apos; canopy</source>
        <translation>樹冠の高さ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Trees</source>
        <translation>樹木(&amp;T)</translation>
    </message>
    <message>
        <source>T&amp;errain</source>
        <translation>地形(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Places</source>
        <translation>場所(&amp;P)</translation>
    </message>
    <message>
        <source>%1: OpenStreetMap, whose tags are known.</source>
        <translation>%1: OpenStreetMap(タグは既知)。</translation>
    </message>
    <message>
        <source>%1: a raster. Its cells are taken for heights of the canopy above the ground.</source>
        <translation>%1: ラスター。セルの値は地面からの樹冠の高さとして扱われます。</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 feature(s) in layer %3.</source>
        <translation>
            <numerusform>%1: レイヤー %3 に地物 %2 件。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 measured</source>
        <translation>測定 %1</translation>
    </message>
    <message>
        <source>%1 estimated</source>
        <translation>推定 %1</translation>
    </message>
    <message>
        <source>%1 assumed</source>
        <translation>仮定 %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 tree(s) are added.</source>
        <translation>
            <numerusform>樹木 %1 本が追加されます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Heights: %1 (%2)</source>
        <translation>高さ: %1 (%2)</translation>
    </message>
    <message>
        <source>Crowns: %1 (%2)</source>
        <translation>樹冠: %1 (%2)</translation>
    </message>
    <message>
        <source>not counted: no storey stands on the ground</source>
        <translation>数えません: 地面に立つ階がありません</translation>
    </message>
    <message>
        <source>%1 as it stands</source>
        <translation>現状の %1</translation>
    </message>
    <message>
        <source>Without trees: %1</source>
        <translation>樹木なし: %1</translation>
    </message>
    <message>
        <source>sunrise to sunset</source>
        <translation>日の出から日の入りまで</translation>
    </message>
    <message>
        <source>; sun comes back on %1 (%2 %)</source>
        <translation>。日照が戻る分は %1(%2 %)</translation>
    </message>
    <message>
        <source>New shadow a day, by cells of %1: %2</source>
        <translation>1 日の新しい日陰(セル %1): %2</translation>
    </message>
    <message>
        <source>Existing</source>
        <translation>現況</translation>
    </message>
    <message>
        <source>every %1 min</source>
        <translation>%1分ごと</translation>
    </message>
    <message>
        <source>no refraction</source>
        <translation>大気差なし</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>time in shadow, which trees are counted</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%1 tree(s) take sun from it, %2 % of the shadow.</source>
        <translation>
            <numerusform>%1 本の木が日光を遮り、影の %2 % を占めます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Tree %1</source>
        <comment>its species or number</comment>
        <translation>樹木 %1</translation>
    </message>
    <message>
        <source>Least sure: %1 (%2, %3)</source>
        <translation>最も不確かなもの: %1 (%2、%3)</translation>
    </message>
    <message>
        <source>Verdicts</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>; highest part %1</source>
        <translation>、最も高い部分 %1</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>標高</translation>
    </message>
    <message>
        <source>%1 to %2 above datum</source>
        <translation>基準面から %1 ～ %2</translation>
    </message>
    <message>
        <source>%1 against its empty lot</source>
        <translation>%1(更地との比較)</translation>
    </message>
    <message>
        <source>%1 high</source>
        <translation>高さ %1</translation>
    </message>
    <message>
        <source>%1 high, %2 %3</source>
        <comment>a building: its height, how far it is, in which direction</comment>
        <translation>高さ %1、%3 へ %2</translation>
    </message>
    <message>
        <source>a building %1</source>
        <comment>23 m high, 120 m NE</comment>
        <translation>%1の建物</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多角形</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>はい(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>いいえ(&amp;N)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>適用</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>リセット</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>再試行</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>無視</translation>
    </message>
</context>
<context>
    <name>QUndoStack</name>
    <message>
        <source>Undo %1</source>
        <translation>元に戻す: %1</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>やり直し: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直し</translation>
    </message>
</context>
<context>
    <name>Rule</name>
    <message>
        <source>Boston, Article 80 diagrams</source>
        <translation>ボストン、Article 80の図</translation>
    </message>
    <message>
        <source>Boston</source>
        <translation>ボストン</translation>
    </message>
    <message>
        <source>Boston, Common and Garden</source>
        <translation>ボストン、コモンとガーデン</translation>
    </message>
    <message>
        <source>Boston, Midtown</source>
        <translation>ボストン、ミッドタウン</translation>
    </message>
    <message>
        <source>BRE 209 (2022), amenity space</source>
        <translation>BRE 209 (2022)、屋外空間</translation>
    </message>
    <message>
        <source>London</source>
        <translation>ロンドン</translation>
    </message>
    <message>
        <source>BRE 209 (2022), windows</source>
        <translation>BRE 209 (2022)、窓</translation>
    </message>
    <message>
        <source>New York, CEQR chapter 8</source>
        <translation>ニューヨーク、CEQR第8章</translation>
    </message>
    <message>
        <source>New York</source>
        <translation>ニューヨーク</translation>
    </message>
    <message>
        <source>China, GB 50180, sunlight of homes</source>
        <translation>中国、GB 50180、住宅の日照</translation>
    </message>
    <message>
        <source>China</source>
        <translation>中国</translation>
    </message>
    <message>
        <source>EN 17037, exposure to sunlight</source>
        <translation>EN 17037、日照</translation>
    </message>
    <message>
        <source>Europe</source>
        <translation>ヨーロッパ</translation>
    </message>
    <message>
        <source>Estonia, insolation of homes</source>
        <translation>エストニア、住宅の日照</translation>
    </message>
    <message>
        <source>Estonia</source>
        <translation>エストニア</translation>
    </message>
    <message>
        <source>Four days, three hours</source>
        <translation>4日、3時刻</translation>
    </message>
    <message>
        <source>Philadelphia, Seattle and others</source>
        <translation>フィラデルフィア、シアトルなど</translation>
    </message>
    <message>
        <source>Japan, Building Standards Act, table 4</source>
        <translation>日本、建築基準法別表第四</translation>
    </message>
    <message>
        <source>Japan</source>
        <translation>日本</translation>
    </message>
    <message>
        <source>Korea, right to sunlight</source>
        <translation>韓国、日照権</translation>
    </message>
    <message>
        <source>Korea</source>
        <translation>韓国</translation>
    </message>
    <message>
        <source>Melbourne, amendment C278</source>
        <translation>メルボルン、改正C278</translation>
    </message>
    <message>
        <source>Melbourne</source>
        <translation>メルボルン</translation>
    </message>
    <message>
        <source>Montreal, parks</source>
        <translation>モントリオール、公園</translation>
    </message>
    <message>
        <source>Montreal</source>
        <translation>モントリオール</translation>
    </message>
    <message>
        <source>Montreal, east-west streets</source>
        <translation>モントリオール、東西の通り</translation>
    </message>
    <message>
        <source>New South Wales, Apartment Design Guide</source>
        <translation>ニューサウスウェールズ、Apartment Design Guide</translation>
    </message>
    <message>
        <source>New South Wales</source>
        <translation>ニューサウスウェールズ</translation>
    </message>
    <message>
        <source>A rule of your own</source>
        <translation>独自の規則</translation>
    </message>
    <message>
        <source>Anywhere</source>
        <translation>すべての場所</translation>
    </message>
    <message>
        <source>Poland, sunlight in rooms</source>
        <translation>ポーランド、居室の日照</translation>
    </message>
    <message>
        <source>Poland</source>
        <translation>ポーランド</translation>
    </message>
    <message>
        <source>Russia (central zone), share of territory</source>
        <translation>ロシア（中部）、敷地の割合</translation>
    </message>
    <message>
        <source>Russia</source>
        <translation>ロシア</translation>
    </message>
    <message>
        <source>Russia (central zone), insolation of rooms</source>
        <translation>ロシア（中部）、居室の日照</translation>
    </message>
    <message>
        <source>San Francisco, Section 295 (Proposition K)</source>
        <translation>サンフランシスコ、Section 295 (Proposition K)</translation>
    </message>
    <message>
        <source>San Francisco</source>
        <translation>サンフランシスコ</translation>
    </message>
    <message>
        <source>The Hague, sunlight on facades</source>
        <translation>ハーグ、ファサードの日照</translation>
    </message>
    <message>
        <source>The Hague</source>
        <translation>ハーグ</translation>
    </message>
    <message>
        <source>Netherlands, TNO light</source>
        <translation>オランダ、TNO light</translation>
    </message>
    <message>
        <source>Netherlands</source>
        <translation>オランダ</translation>
    </message>
    <message>
        <source>Netherlands, TNO strict</source>
        <translation>オランダ、TNO strict</translation>
    </message>
    <message>
        <source>Toronto, shadow study</source>
        <translation>トロント、日影検討</translation>
    </message>
    <message>
        <source>Toronto</source>
        <translation>トロント</translation>
    </message>
    <message>
        <source>Vancouver, parks and schoolyards</source>
        <translation>バンクーバー、公園と校庭</translation>
    </message>
    <message>
        <source>Vancouver</source>
        <translation>バンクーバー</translation>
    </message>
    <message>
        <source>Zurich, shadow of tall buildings</source>
        <translation>チューリッヒ、高層建物の影</translation>
    </message>
    <message>
        <source>Zurich</source>
        <translation>チューリッヒ</translation>
    </message>
    <message>
        <source>United States</source>
        <translation>アメリカ合衆国</translation>
    </message>
    <message>
        <source>Britain (UK)</source>
        <translation>イギリス</translation>
    </message>
    <message>
        <source>Korea (South)</source>
        <translation>韓国</translation>
    </message>
    <message>
        <source>Switzerland</source>
        <translation>スイス</translation>
    </message>
    <message>
        <source>Canada</source>
        <translation>カナダ</translation>
    </message>
    <message>
        <source>Australia</source>
        <translation>オーストラリア</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>日</translation>
    </message>
    <message>
        <source>New shadow enters</source>
        <translation>新しい影の開始</translation>
    </message>
    <message>
        <source>New shadow exits</source>
        <translation>新しい影の終了</translation>
    </message>
    <message>
        <source>Duration, min</source>
        <translation>継続時間、分</translation>
    </message>
    <message>
        <source>Largest area, m²</source>
        <translation>最大面積、m²</translation>
    </message>
    <message>
        <source>At one spot, min</source>
        <translation>一点で、分</translation>
    </message>
    <message>
        <source>Shadow of fences and other small structures</source>
        <translation>柵など小さな構造物の影</translation>
    </message>
    <message>
        <source>The rule asks for diagrams and states no limit, so there are figures and no verdict.</source>
        <translation>規定は図を求めるだけで限度がないため、数値のみで判定はありません。</translation>
    </message>
    <message>
        <source>The equinoxes and solstices are the 21st of March, June, September and December.</source>
        <translation>分点と至点は 3 月、6 月、9 月、12 月の 21 日です。</translation>
    </message>
    <message>
        <source>Diagrams at 9, 12 and 15 h on the equinoxes and solstices, and at 18 h in summer and autumn.</source>
        <translation>分点と至点の 9、12、15 時の図。夏と秋は 18 時も。</translation>
    </message>
    <message>
        <source>Minutes with new shadow anywhere outside the first and last hour</source>
        <translation>最初と最後の 1 時間を除き、どこかに新しい影がある分数</translation>
    </message>
    <message>
        <source>Park</source>
        <translation>公園</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>分</translation>
    </message>
    <message>
        <source>Exemptions and shadow banks</source>
        <translation>適用除外と影の枠</translation>
    </message>
    <message>
        <source>Sunrise and sunset are those of the upper limb with refraction: the definition is not stated.</source>
        <translation>日の出と日没は大気差を含む上縁によります。定義は示されていません。</translation>
    </message>
    <message>
        <source>New shadow is shadow on ground that is lit in the baseline.</source>
        <translation>新しい影とは、比較基準で日の当たる地面にできる影です。</translation>
    </message>
    <message>
        <source>New shadow only in the first hour after sunrise or 7:00 (the later) and in the last hour before sunset.</source>
        <translation>新しい影は、日の出か 7:00 の遅い方から 1 時間と、日没前の 1 時間だけ認められます。</translation>
    </message>
    <message>
        <source>New shadow at the worst spot</source>
        <translation>最悪の点の新しい影</translation>
    </message>
    <message>
        <source>At the worst spot, min</source>
        <translation>最悪の点で、分</translation>
    </message>
    <message>
        <source>Anywhere, min</source>
        <translation>どこかで、分</translation>
    </message>
    <message>
        <source>Exemptions, and areas too small to count</source>
        <translation>適用除外と、小さすぎて数えない面積</translation>
    </message>
    <message>
        <source>The two hours are those of the worst spot: the figures at hand do not say whether a spot or the whole park is meant. The table states both.</source>
        <translation>2 時間は最悪の点のものです。手元の資料からは点か公園全体かが分からないため、表には両方を示します。</translation>
    </message>
    <message>
        <source>Less than 2 h of new shadow within 8:00-14:30, from 21 March to 21 October.</source>
        <translation>3 月 21 日から 10 月 21 日、8:00-14:30 の新しい影が 2 時間未満。</translation>
    </message>
    <message>
        <source>Share of the space with 2 h of sun</source>
        <translation>日照 2 時間の部分の割合</translation>
    </message>
    <message>
        <source>Amenity space</source>
        <translation>アメニティ空間</translation>
    </message>
    <message>
        <source>Share with 2 h of sun</source>
        <translation>日照 2 時間の割合</translation>
    </message>
    <message>
        <source>Least sun, min</source>
        <translation>最少日照、分</translation>
    </message>
    <message>
        <source>The windows&apos; part of BRE 209: annual probable sunlight hours, vertical sky component</source>
        <translation>BRE 209 の窓の部分: 年間可能日照時間、鉛直天空光成分</translation>
    </message>
    <message>
        <source>Shadow of fences</source>
        <translation>柵の影</translation>
    </message>
    <message>
        <source>The two hours may be broken up.</source>
        <translation>2 時間は分かれていてもかまいません。</translation>
    </message>
    <message>
        <source>A space that meets the limit by its former value is stated with its new share.</source>
        <translation>以前の値によって限度を満たす空間は、新しい割合で示します。</translation>
    </message>
    <message>
        <source>As reported, of trees only dense belts of evergreens count for sun on the ground. A cell is in their shade where they take half of the sun or more.</source>
        <translation>報告によれば、地面の日照では樹木のうち常緑の密な樹林帯だけを数えます。日照の半分以上を遮る所のセルを影とします。</translation>
    </message>
    <message>
        <source>At least 2 h of sun on 21 March over at least half of an amenity space, or else at least 0.8 times its former value.</source>
        <translation>3 月 21 日にアメニティ空間の半分以上で 2 時間以上の日照、または以前の値の 0.8 倍以上。</translation>
    </message>
    <message>
        <source>face</source>
        <translation>面</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>内側</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>外側</translation>
    </message>
    <message>
        <source>windows of</source>
        <translation>対象の窓</translation>
    </message>
    <message>
        <source>neighbours</source>
        <translation>隣接建物</translation>
    </message>
    <message>
        <source>own scheme</source>
        <translation>自己の計画</translation>
    </message>
    <message>
        <source>Annual probable sunlight hours</source>
        <translation>年間可能日照時間</translation>
    </message>
    <message>
        <source>Loss of annual probable sunlight hours</source>
        <translation>年間可能日照時間の減少</translation>
    </message>
    <message>
        <source>Vertical sky component</source>
        <translation>鉛直天空光成分</translation>
    </message>
    <message>
        <source>Probable sunlight hours from 21 September to 21 March, of those of the year</source>
        <translation>9 月 21 日から 3 月 21 日の可能日照時間、年間に対する割合</translation>
    </message>
    <message>
        <source>Sunlight is asked of windows that face within 90 degrees of due south</source>
        <translation>日照は真南から 90 度以内を向く窓に求められます</translation>
    </message>
    <message>
        <source>No-sky line and daylight in rooms</source>
        <translation>室内の天空不可視線と昼光</translation>
    </message>
    <message>
        <source>Which rooms are living rooms: all windows are evaluated</source>
        <translation>どの部屋が居間か: すべての窓を評価します</translation>
    </message>
    <message>
        <source>Windows that face north are asked for the sky component only</source>
        <translation>北向きの窓には天空光成分だけが求められます</translation>
    </message>
    <message>
        <source>Shadow of fences and blinds</source>
        <translation>柵とブラインドの影</translation>
    </message>
    <message>
        <source>A window&apos;s sunlight suffers if it misses a target of its own, falls below 0.8 times the former value in that period, and loses more than 4 points of the year: it holds if one of the three does not occur. Where an authority asks for both 0.8 times and a loss of at most 4 points, copy the rule and change holds_if.</source>
        <translation>窓の日照は、固有の目標を満たさず、その期間に以前の値の 0.8 倍を下回り、年間で 4 ポイントを超えて失う場合に損なわれます。三つのうち一つでも起こらなければ適合です。当局が 0.8 倍と 4 ポイント以内の両方を求める場合は、規定を複製して holds_if を変更してください。</translation>
    </message>
    <message>
        <source>Without a table of sunshine probability every hour with the sun up counts alike, and shares are of plain possible hours. Add a table for the place as &quot;sunshine&quot; in a copy of the rule, or with --sunshine.</source>
        <translation>日照率の表がない場合、太陽が出ている時間はすべて等しく数え、割合は可照時間に対するものです。規定の複製に &quot;sunshine&quot; として、または --sunshine でその土地の表を追加してください。</translation>
    </message>
    <message>
        <source>Shares are of the hours of the unobstructed sun in a whole year, also those of winter.</source>
        <translation>割合は、冬も含めて年間の遮るもののない日照時間に対するものです。</translation>
    </message>
    <message>
        <source>The point is in the middle of the pane on the outside face. With the choice of the inside face, the sun must also pass the opening in the wall.</source>
        <translation>点は外側の面のガラス中央です。内側の面を選ぶと、太陽は壁の開口も通る必要があります。</translation>
    </message>
    <message>
        <source>As reported, deciduous trees are left out before neighbours&apos; windows, and evergreens count. With the choice of one&apos;s own scheme, existing trees count by their season, and of the proposed ones the evergreens.</source>
        <translation>報告によれば、隣接建物の窓の前では落葉樹を除き、常緑樹を数えます。自己の計画を選ぶと、既存の樹木は季節に応じて、計画の樹木は常緑樹を数えます。</translation>
    </message>
    <message>
        <source>Sun through crowns counts by the share that they let pass; a run is broken where they take half of it or more. The vertical sky component has the mean of the days with leaves and without.</source>
        <translation>樹冠を通る日照は通す割合で数え、半分以上遮る所で継続は途切れます。鉛直天空光成分は葉のある日とない日の平均です。</translation>
    </message>
    <message>
        <source>Windows of neighbours: vertical sky component at least 27 %, annual probable sunlight hours at least 25 % with 5 % in winter, each or else 0.8 times the former value; a loss of sunlight of at most 4 points is never notable.</source>
        <translation>隣接建物の窓: 鉛直天空光成分 27 % 以上、年間可能日照時間 25 % 以上 (うち冬 5 %)、または以前の値の 0.8 倍以上。4 ポイント以内の減少は目立たないものとします。</translation>
    </message>
    <message>
        <source>Minutes in which all direct sun is eliminated</source>
        <translation>直射日光がすべて失われる分数</translation>
    </message>
    <message>
        <source>Sun for plants at the worst spot, growing season</source>
        <translation>最悪の点での植物のための日照、生育期</translation>
    </message>
    <message>
        <source>Resource</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>Analysis day</source>
        <translation>検討日</translation>
    </message>
    <message>
        <source>Incremental shadow enters</source>
        <translation>増加日影の開始</translation>
    </message>
    <message>
        <source>Incremental shadow exits</source>
        <translation>増加日影の終了</translation>
    </message>
    <message>
        <source>Duration, h:min</source>
        <translation>継続時間、時:分</translation>
    </message>
    <message>
        <source>Longest at one spot, h:min</source>
        <translation>一点での最長、時:分</translation>
    </message>
    <message>
        <source>All direct sun eliminated, min</source>
        <translation>直射日光の消失、分</translation>
    </message>
    <message>
        <source>Trigger: 50 ft or more, or more than 10 ft next to a resource</source>
        <translation>対象: 50 ft 以上、または対象に隣接して 10 ft 超</translation>
    </message>
    <message>
        <source>Longest shadow: 4.3 x height</source>
        <translation>最長の影: 高さの 4.3 倍</translation>
    </message>
    <message>
        <source>No shadow between 108 and 252 degrees from north</source>
        <translation>北から 108 度から 252 度の間に影はありません</translation>
    </message>
    <message>
        <source>Hours: from 1.5 h after sunrise to 1.5 h before sunset</source>
        <translation>時間帯: 日の出 1.5 時間後から日没 1.5 時間前</translation>
    </message>
    <message>
        <source>Growing season: April to October; a statement on it is asked for</source>
        <translation>生育期: 4 月から 10 月。これについての記述が求められます</translation>
    </message>
    <message>
        <source>All direct sun eliminated from a resource for more than 10 min is generally significant</source>
        <translation>対象の直射日光が 10 分を超えてすべて失われることは、一般に重大とされます</translation>
    </message>
    <message>
        <source>Plants need 4 to 6 h of sun</source>
        <translation>植物には 4 から 6 時間の日照が必要です</translation>
    </message>
    <message>
        <source>The trigger (height of the proposal) and whether the resource is sensitive to sunlight</source>
        <translation>対象の条件 (計画案の高さ) と、対象が日照を要するか</translation>
    </message>
    <message>
        <source>Significance of incremental shadow that leaves some sun: the rule asks for a judgement</source>
        <translation>日照が一部残る増加日影の重大性: 規定は判断を求めます</translation>
    </message>
    <message>
        <source>Stained glass and facades are measured on the ground in front of them</source>
        <translation>ステンドグラスと外壁面はその前の地面で測定します</translation>
    </message>
    <message>
        <source>Landscaped medians with seats, unless they are places of the project</source>
        <translation>座席のある緑の中央分離帯 (プロジェクトの場所でない場合)</translation>
    </message>
    <message>
        <source>The duration is the time with incremental shadow anywhere on the resource, without breaks.</source>
        <translation>継続時間は対象のどこかに増加日影がある時間で、途切れは除きます。</translation>
    </message>
    <message>
        <source>Kinds that the rule does not name (playground, plaza, cemetery, other) are evaluated as open space. Streets are not.</source>
        <translation>規定が挙げない種類 (遊び場、広場、墓地、その他) はオープンスペースとして評価します。道路は対象外です。</translation>
    </message>
    <message>
        <source>The sun for plants is counted within the rule&apos;s hours and compared with the lower figure, 4 h; it does not decide the verdict.</source>
        <translation>植物のための日照は規定の時間内で数え、小さい方の 4 時間と比べます。判定には用いません。</translation>
    </message>
    <message>
        <source>Incremental shadow of a proposal on sunlight-sensitive resources on four analysis days, against the No-Action scenario.</source>
        <translation>四つの検討日に、日照を要する対象に計画案が与える増加日影。無計画時のシナリオとの比較。</translation>
    </message>
    <message>
        <source>counting</source>
        <translation>数え方</translation>
    </message>
    <message>
        <source>Beijing, runs from 5 min</source>
        <translation>北京、5 分以上の区間</translation>
    </message>
    <message>
        <source>Hangzhou, two longest runs</source>
        <translation>杭州、最長の二区間</translation>
    </message>
    <message>
        <source>all runs</source>
        <translation>すべての区間</translation>
    </message>
    <message>
        <source>day</source>
        <translation>日</translation>
    </message>
    <message>
        <source>Great Cold, 2 h</source>
        <translation>大寒、2 時間</translation>
    </message>
    <message>
        <source>Great Cold, 3 h</source>
        <translation>大寒、3 時間</translation>
    </message>
    <message>
        <source>winter solstice, 1 h</source>
        <translation>冬至、1 時間</translation>
    </message>
    <message>
        <source>winter solstice</source>
        <translation>冬至</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>ガラス面からの角度</translation>
    </message>
    <message>
        <source>15 degrees</source>
        <translation>15 度</translation>
    </message>
    <message>
        <source>wall over width</source>
        <translation>壁厚 / 幅</translation>
    </message>
    <message>
        <source>Effective sun at both ends of the sill</source>
        <translation>窓台両端の有効日照</translation>
    </message>
    <message>
        <source>Great Cold</source>
        <translation>大寒</translation>
    </message>
    <message>
        <source>The sun counts from a sweep angle of 15 degrees, or arctan(thickness of the wall / width of the window)</source>
        <translation>太陽はガラス面から 15 度、または arctan(壁厚 / 窓の幅) 以上で数えます</translation>
    </message>
    <message>
        <source>Beijing drops runs below 5 min; 30 min is also reported</source>
        <translation>北京では 5 分未満の区間を除きます。30 分とする報告もあります</translation>
    </message>
    <message>
        <source>Hangzhou sums the longest runs, steps of at most 5 min</source>
        <translation>杭州では最長の区間を合計し、ステップは 5 分以内です</translation>
    </message>
    <message>
        <source>Households: which windows belong to a household, and that one living room is enough</source>
        <translation>世帯: どの窓が世帯に属するか、居間一室で足りること</translation>
    </message>
    <message>
        <source>The climate zone and size of the city, which choose the day</source>
        <translation>日を決める気候区分と都市の規模</translation>
    </message>
    <message>
        <source>The sun counts while both ends of the sill have it at once.</source>
        <translation>窓台の両端に同時に日が当たる間を数えます。</translation>
    </message>
    <message>
        <source>Windows of 1.5 m stand in where the file states no sizes.</source>
        <translation>ファイルに大きさのない窓は 1.5 m とします。</translation>
    </message>
    <message>
        <source>Hangzhou: the two longest runs are summed; how many is not stated in what we have.</source>
        <translation>杭州: 最長の二区間を合計します。いくつかは手元の資料にありません。</translation>
    </message>
    <message>
        <source>Homes: at least 2 h of sun on the Great Cold day from 8 to 16 h, or 1 h on the winter solstice from 9 to 15 h, true solar time, at both ends of the sill.</source>
        <translation>住宅: 真太陽時で大寒の 8 時から 16 時に 2 時間以上、または冬至の 9 時から 15 時に 1 時間以上、窓台の両端で。</translation>
    </message>
    <message>
        <source>country</source>
        <translation>国</translation>
    </message>
    <message>
        <source>Czech Republic, 13 deg</source>
        <translation>チェコ、13 度</translation>
    </message>
    <message>
        <source>Germany, 11 deg</source>
        <translation>ドイツ、11 度</translation>
    </message>
    <message>
        <source>of choice</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>最悪</translation>
    </message>
    <message>
        <source>level</source>
        <translation>水準</translation>
    </message>
    <message>
        <source>high</source>
        <translation>高</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>中</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>最低</translation>
    </message>
    <message>
        <source>Sun in the room</source>
        <translation>部屋の日照</translation>
    </message>
    <message>
        <source>Levels: 1.5 h minimum, 4 h high</source>
        <translation>水準: 最低 1.5 時間、高 4 時間</translation>
    </message>
    <message>
        <source>Level: 3 h medium</source>
        <translation>水準: 中 3 時間</translation>
    </message>
    <message>
        <source>Which rooms are habitable, and that one room of a dwelling is enough</source>
        <translation>どの部屋が居室か、住戸の一室で足りること</translation>
    </message>
    <message>
        <source>Least altitudes of countries other than Germany and the Czech Republic: change lowest_sun_deg in a copy of the rule</source>
        <translation>ドイツとチェコ以外の国の最低高度: 規定の複製で lowest_sun_deg を変更</translation>
    </message>
    <message>
        <source>Times through several openings of a room add up where they are not at the same moment: name the rooms in the file of windows (field room). Windows without a room are rooms of their own.</source>
        <translation>一部屋の複数の開口の時間は、同時でなければ合計します。窓のファイルで部屋を示してください (フィールド room)。部屋のない窓はそれ自体を一部屋とします。</translation>
    </message>
    <message>
        <source>On the day of the user&apos;s choice: the best day of the range decides. The choice &quot;day=worst&quot; asks it of every day.</source>
        <translation>任意の日: 期間中の最良の日で判定します。&quot;day=worst&quot; を選ぶと毎日求めます。</translation>
    </message>
    <message>
        <source>Obstructions are looked up from the outside face; the opening, as deep as the wall, hides what the inside face does not see.</source>
        <translation>遮蔽物は外側の面から調べ、壁厚の深さの開口が内側の面から見えない部分を隠します。</translation>
    </message>
    <message>
        <source>The least altitude depends on the country. That of Germany is taken unless another country is chosen.</source>
        <translation>最低高度は国によります。ほかの国を選ばない限りドイツの値を用います。</translation>
    </message>
    <message>
        <source>On one day between 1 February and 21 March at least 1.5 h of sun in one habitable room; 3 h medium, 4 h high.</source>
        <translation>2 月 1 日から 3 月 21 日のある日に、居室一室で 1.5 時間以上の日照。中は 3 時間、高は 4 時間。</translation>
    </message>
    <message>
        <source>Longest unbroken sun</source>
        <translation>最長の連続日照</translation>
    </message>
    <message>
        <source>Sun of the day</source>
        <translation>1 日の日照</translation>
    </message>
    <message>
        <source>3 h of unbroken sun, or 3.5 h with one break</source>
        <translation>連続 3 時間、または一度途切れて 3.5 時間の日照</translation>
    </message>
    <message>
        <source>Which rooms must have it</source>
        <translation>どの部屋に必要か</translation>
    </message>
    <message>
        <source>The worst day decides.</source>
        <translation>最悪の日で判定します。</translation>
    </message>
    <message>
        <source>With one break: the two longest parts of the day&apos;s sun add up to 3.5 h, whatever sun follows.</source>
        <translation>一度途切れる場合: その後の日照によらず、その日の最長の二区間の合計が 3.5 時間。</translation>
    </message>
    <message>
        <source>Every break counts, also one of a minute: the sun before and after it are two parts. The bands of the window state them.</source>
        <translation>1 分でも途切れは数え、前後の日照は二区間とします。窓の日照帯に示します。</translation>
    </message>
    <message>
        <source>From 22 April to 22 August at least 3 h of unbroken sun, or 3.5 h with one break; a loss of at most 50 %.</source>
        <translation>4 月 22 日から 8 月 22 日、連続 3 時間、または一度途切れて 3.5 時間以上の日照。減少は 50 % 以内。</translation>
    </message>
    <message>
        <source>The sheet has no limit, so there are figures and no verdict.</source>
        <translation>この様式には限度がないため、数値のみで判定はありません。</translation>
    </message>
    <message>
        <source>The solstices and equinoxes are the 21st of March, June, September and December.</source>
        <translation>至点と分点は 3 月、6 月、9 月、12 月の 21 日です。</translation>
    </message>
    <message>
        <source>Diagrams at 9, 12 and 15 h on the solstices and equinoxes: the general sheet.</source>
        <translation>至点と分点の 9、12、15 時の図: 一般的な様式。</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>限度</translation>
    </message>
    <message>
        <source>3 h, 2 h</source>
        <translation>3 時間、2 時間</translation>
    </message>
    <message>
        <source>4 h, 2.5 h</source>
        <translation>4 時間、2.5 時間</translation>
    </message>
    <message>
        <source>5 h, 3 h</source>
        <translation>5 時間、3 時間</translation>
    </message>
    <message>
        <source>Hokkaido 2 h, 1.5 h</source>
        <translation>北海道 2 時間、1.5 時間</translation>
    </message>
    <message>
        <source>Hokkaido 3 h, 2 h</source>
        <translation>北海道 3 時間、2 時間</translation>
    </message>
    <message>
        <source>Hokkaido 4 h, 2.5 h</source>
        <translation>北海道 4 時間、2.5 時間</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>測定面</translation>
    </message>
    <message>
        <source>1.5 m</source>
        <translation>1.5 m</translation>
    </message>
    <message>
        <source>4 m</source>
        <translation>4 m</translation>
    </message>
    <message>
        <source>6.5 m</source>
        <translation>6.5 m</translation>
    </message>
    <message>
        <source>Shadow beyond 10 m of the parcel line</source>
        <translation>敷地境界線から 10 m を超える範囲の日影</translation>
    </message>
    <message>
        <source>Shadow within 5 to 10 m of the parcel line</source>
        <translation>敷地境界線から 5 m 超 10 m 以内の範囲の日影</translation>
    </message>
    <message>
        <source>Parcel and belt</source>
        <translation>敷地と範囲</translation>
    </message>
    <message>
        <source>Longest shadow at a point, min</source>
        <translation>一点での最長日影、分</translation>
    </message>
    <message>
        <source>Shadow anywhere, min</source>
        <translation>どこかの日影、分</translation>
    </message>
    <message>
        <source>True solar time 8 to 16 h; Hokkaido 9 to 15 h</source>
        <translation>真太陽時 8 時から 16 時。北海道は 9 時から 15 時</translation>
    </message>
    <message>
        <source>Plane 1.5, 4 or 6.5 m above the mean ground</source>
        <translation>平均地盤面から 1.5、4、6.5 m の測定面</translation>
    </message>
    <message>
        <source>Limits within 5 to 10 m of the parcel line and beyond 10 m: 3 and 2 h, 4 and 2.5 h, 5 and 3 h; Hokkaido 2 and 1.5 h, 3 and 2 h, 4 and 2.5 h</source>
        <translation>敷地境界線から 5 m 超 10 m 以内と 10 m 超の限度: 3 と 2 時間、4 と 2.5 時間、5 と 3 時間。北海道は 2 と 1.5 時間、3 と 2 時間、4 と 2.5 時間</translation>
    </message>
    <message>
        <source>Triggers: eaves above 7 m or 3 storeys and more (plane of 1.5 m), above 10 m (planes of 4 and 6.5 m)</source>
        <translation>対象: 軒高 7 m 超または 3 階以上 (測定面 1.5 m)、高さ 10 m 超 (測定面 4 m、6.5 m)</translation>
    </message>
    <message>
        <source>The parcel line moves out by half the width of a road of at most 10 m, else to 5 m inside its far side</source>
        <translation>敷地境界線は、幅 10 m 以下の道路ではその幅の半分だけ外側に、それ以外では反対側から 5 m の線まで移ります</translation>
    </message>
    <message>
        <source>Sheets: hourly (half-hourly) shadows, isochrones, 5 m and 10 m lines, designated points; island shadows must not be missed</source>
        <translation>図面: 1 時間ごと (30 分ごと) の日影図、等時間日影図、5 m と 10 m の線、指定点。島日影を見落とさないこと</translation>
    </message>
    <message>
        <source>The triggers (eaves, storeys, zone): choose plane and limits</source>
        <translation>対象の条件 (軒高、階数、用途地域): 測定面と限度を選択</translation>
    </message>
    <message>
        <source>Roads, water and railways along the parcels that the project does not state; edges set back more than 1 m are taken to be on none</source>
        <translation>プロジェクトにない敷地沿いの道路、水面、線路。1 m を超えて後退した辺はいずれにも接しないものとします</translation>
    </message>
    <message>
        <source>Designated points</source>
        <translation>指定点</translation>
    </message>
    <message>
        <source>The winter solstice is 21 December.</source>
        <translation>冬至は 12 月 21 日です。</translation>
    </message>
    <message>
        <source>The places are the parcels; Noonmark measures the belts around them.</source>
        <translation>場所は敷地で、Noonmark はその周囲の範囲を測定します。</translation>
    </message>
    <message>
        <source>The mean ground is the height 0 of the project&apos;s plane, unless the project has terrain.</source>
        <translation>プロジェクトに地形がなければ、平均地盤面はプロジェクト平面の高さ 0 です。</translation>
    </message>
    <message>
        <source>Shadow of the proposal on a plane above the mean ground on the winter solstice, between the 5 m and 10 m lines around the parcel and beyond them.</source>
        <translation>冬至に平均地盤面上の測定面に落ちる計画案の影。敷地から 5 m と 10 m の線の間と、その外側。</translation>
    </message>
    <message>
        <source>Sun in total from 8 to 16 h</source>
        <translation>8 時から 16 時の日照の合計</translation>
    </message>
    <message>
        <source>Unbroken sun from 9 to 15 h</source>
        <translation>9 時から 15 時の連続日照</translation>
    </message>
    <message>
        <source>Windows of schools and playgrounds within 200 m</source>
        <translation>200 m 以内の学校の窓と遊び場</translation>
    </message>
    <message>
        <source>One of the two is enough.</source>
        <translation>どちらか一方で足ります。</translation>
    </message>
    <message>
        <source>On the winter solstice at least 4 h of sun in total from 8 to 16 h, or 2 h unbroken from 9 to 15 h.</source>
        <translation>冬至に 8 時から 16 時で合計 4 時間以上、または 9 時から 15 時で連続 2 時間以上の日照。</translation>
    </message>
    <message>
        <source>park type</source>
        <translation>公園の類型</translation>
    </message>
    <message>
        <source>1 or 2</source>
        <translation>1 または 2</translation>
    </message>
    <message>
        <source>3</source>
        <translation>3</translation>
    </message>
    <message>
        <source>Minutes with added shadow anywhere</source>
        <translation>どこかに追加の影がある分数</translation>
    </message>
    <message>
        <source>Added shadow enters</source>
        <translation>追加の影の開始</translation>
    </message>
    <message>
        <source>Added shadow exits</source>
        <translation>追加の影の終了</translation>
    </message>
    <message>
        <source>No added shadow from 10 to 15 h on 21 June; type 3 from 10 to 14 h. As proposed</source>
        <translation>6 月 21 日の 10 時から 15 時に追加の影なし。類型 3 は 10 時から 14 時。提案のとおり</translation>
    </message>
    <message>
        <source>The type of the park: choose the option</source>
        <translation>公園の類型: 選択肢を選んでください</translation>
    </message>
    <message>
        <source>The figures are those proposed, not those adopted.</source>
        <translation>数値は提案されたもので、採択されたものではありません。</translation>
    </message>
    <message>
        <source>No added shadow on parks from 10 to 15 h on 21 June (type 3: to 14 h).</source>
        <translation>6 月 21 日の 10 時から 15 時 (類型 3 は 14 時まで)、公園に追加の影なし。</translation>
    </message>
    <message>
        <source>Share of the park with 8 consecutive hours of sun</source>
        <translation>連続 8 時間の日照がある公園の割合</translation>
    </message>
    <message>
        <source>equinox</source>
        <translation>春分・秋分</translation>
    </message>
    <message>
        <source>Share with 8 h of sun</source>
        <translation>日照 8 時間の割合</translation>
    </message>
    <message>
        <source>The equinox is 21 March.</source>
        <translation>春分は 3 月 21 日です。</translation>
    </message>
    <message>
        <source>Half of a park is half of its area.</source>
        <translation>公園の半分とは面積の半分です。</translation>
    </message>
    <message>
        <source>On the equinox, 8 consecutive hours of sun within 8-18 h on at least half of a park.</source>
        <translation>春分・秋分に、公園の半分以上で 8-18 時の間に連続 8 時間の日照。</translation>
    </message>
    <message>
        <source>minutes</source>
        <translation>分</translation>
    </message>
    <message>
        <source>150</source>
        <translation>150</translation>
    </message>
    <message>
        <source>90</source>
        <translation>90</translation>
    </message>
    <message>
        <source>Consecutive sun at the worst spot of the street</source>
        <translation>道路の最悪の点の連続日照</translation>
    </message>
    <message>
        <source>Street</source>
        <translation>道路</translation>
    </message>
    <message>
        <source>Least consecutive sun, min</source>
        <translation>最少の連続日照、分</translation>
    </message>
    <message>
        <source>150 (90) consecutive minutes of sun; the figures at hand do not say where 90 holds</source>
        <translation>連続 150 (90) 分の日照。90 が適用される所は手元の資料にありません</translation>
    </message>
    <message>
        <source>Whether a street runs east-west: choose the places</source>
        <translation>道路が東西方向かどうか: 場所を選んでください</translation>
    </message>
    <message>
        <source>Where 90 minutes hold instead of 150: choose the option</source>
        <translation>150 分でなく 90 分が適用される所: 選択肢を選んでください</translation>
    </message>
    <message>
        <source>Every spot of the street must have the sun: the figures at hand do not say which line or share of a street counts.</source>
        <translation>道路のすべての点に日照が必要です。手元の資料には、道路のどの線や割合を数えるかが示されていません。</translation>
    </message>
    <message>
        <source>On the equinox, 150 consecutive minutes of sun within 12-15 h on east-west streets.</source>
        <translation>春分・秋分に、東西方向の道路で 12-15 時の間に連続 150 分の日照。</translation>
    </message>
    <message>
        <source>where</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>elsewhere, 3 h</source>
        <translation>その他、3 時間</translation>
    </message>
    <message>
        <source>metropolitan, 2 h</source>
        <translation>大都市圏、2 時間</translation>
    </message>
    <message>
        <source>Sun in the flat</source>
        <translation>住戸の日照</translation>
    </message>
    <message>
        <source>Any sun in the flat</source>
        <translation>住戸に少しでも日照</translation>
    </message>
    <message>
        <source>1 m² for at least 15 min counts</source>
        <translation>1 m² が 15 分以上で数えます</translation>
    </message>
    <message>
        <source>That the sun is in living rooms and on balconies both</source>
        <translation>日照が居間とバルコニーの両方にあること</translation>
    </message>
    <message>
        <source>That 1 m² is lit</source>
        <translation>1 m² に日が当たること</translation>
    </message>
    <message>
        <source>Plan diagrams</source>
        <translation>平面の図</translation>
    </message>
    <message>
        <source>Times of less than 15 min do not count.</source>
        <translation>15 分未満の時間は数えません。</translation>
    </message>
    <message>
        <source>A flat has the sun of all of its windows, where one of them has it: name the flats in the file of windows (field dwelling). Windows without one are flats of their own.</source>
        <translation>住戸の日照は、いずれかの窓に日照があればよいものとします。窓のファイルで住戸を示してください (フィールド dwelling)。ない窓はそれ自体を一住戸とします。</translation>
    </message>
    <message>
        <source>A building passes by its shares; each flat has its own verdict besides.</source>
        <translation>建物は割合で判定し、各住戸にもそれぞれの判定があります。</translation>
    </message>
    <message>
        <source>Flats with enough sun</source>
        <translation>日照が足りる住戸</translation>
    </message>
    <message>
        <source>Flats with some sun</source>
        <translation>日照が少しある住戸</translation>
    </message>
    <message>
        <source>At least 70 % of the flats of a building have 2 h of sun from 9 to 15 h on 21 June in living rooms and on balconies (3 h outside the metropolis); at most 15 % have none.</source>
        <translation>6 月 21 日の 9 時から 15 時に、建物の住戸の 70 % 以上が居間とバルコニーで 2 時間の日照 (大都市圏外は 3 時間)。日照のない住戸は 15 % 以内。</translation>
    </message>
    <message>
        <source>All sun gone, min</source>
        <translation>日照の消失、分</translation>
    </message>
    <message>
        <source>One hour is an example, not a figure of any board.</source>
        <translation>1 時間は例であり、どの当局の数値でもありません。</translation>
    </message>
    <message>
        <source>A start for a rule of your own: copy it, change it, and put it into your own folder of rules.</source>
        <translation>独自の規定の出発点: 複製し、変更して、自分の規定フォルダーに入れてください。</translation>
    </message>
    <message>
        <source>use</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>homes</source>
        <translation>住宅</translation>
    </message>
    <message>
        <source>homes in an inner city</source>
        <translation>都心の住宅</translation>
    </message>
    <message>
        <source>schools</source>
        <translation>学校</translation>
    </message>
    <message>
        <source>That one room of a flat is enough: each room is evaluated by itself</source>
        <translation>住戸の一室で足りること: 各部屋を個別に評価します</translation>
    </message>
    <message>
        <source>The sun may be broken up. Times through several openings of a room add up where they are not at the same moment: name the rooms in the file of windows (field room).</source>
        <translation>日照は分かれていてもかまいません。一部屋の複数の開口の時間は、同時でなければ合計します。窓のファイルで部屋を示してください (フィールド room)。</translation>
    </message>
    <message>
        <source>At least 3 h of sun on the days of the equinoxes: homes from 7 to 17 h, schools from 8 to 16 h; 1.5 h in inner cities.</source>
        <translation>春分と秋分に 3 時間以上の日照: 住宅は 7 時から 17 時、学校は 8 時から 16 時。都心では 1.5 時間。</translation>
    </message>
    <message>
        <source>Share of the territory with 2 h of sun, or 2.5 h broken up</source>
        <translation>日照 2 時間、または分かれて 2.5 時間の敷地の割合</translation>
    </message>
    <message>
        <source>Territory</source>
        <translation>敷地</translation>
    </message>
    <message>
        <source>Share with the sun</source>
        <translation>日照のある割合</translation>
    </message>
    <message>
        <source>Least sun, h:min</source>
        <translation>最少日照、時:分</translation>
    </message>
    <message>
        <source>Intervals</source>
        <translation>区間数</translation>
    </message>
    <message>
        <source>2 h unbroken (by zone and number of rooms)</source>
        <translation>連続 2 時間 (地域と部屋数による)</translation>
    </message>
    <message>
        <source>Broken up: 0.5 h more, one part of at least 1 h</source>
        <translation>分かれる場合: 0.5 時間増し、1 時間以上の区間を含む</translation>
    </message>
    <message>
        <source>Output: h:min, number of intervals, share of territory</source>
        <translation>出力: 時:分、区間数、敷地の割合</translation>
    </message>
    <message>
        <source>Rooms and windows</source>
        <translation>部屋と窓</translation>
    </message>
    <message>
        <source>Other zones: change the days and hours in a rule of your own</source>
        <translation>その他の地域: 独自の規定で日と時間を変更</translation>
    </message>
    <message>
        <source>Every break counts, also one of a single step of 5 min: the sun before and after it are two parts.</source>
        <translation>5 分の 1 ステップでも途切れは数え、前後の日照は二区間とします。</translation>
    </message>
    <message>
        <source>Every day of the range is evaluated; the smallest share counts.</source>
        <translation>期間のすべての日を評価し、最小の割合を用います。</translation>
    </message>
    <message>
        <source>The figures at hand state no share that a territory must reach, so there are figures and no verdict.</source>
        <translation>手元の資料には敷地が満たすべき割合がないため、数値のみで判定はありません。</translation>
    </message>
    <message>
        <source>From 22 April to 22 August, the share of a territory with 2 h of unbroken sun, or 2.5 h broken up with one part of at least 1 h.</source>
        <translation>4 月 22 日から 8 月 22 日に、連続 2 時間、または 1 時間以上の区間を含めて合計 2.5 時間の日照がある敷地の割合。</translation>
    </message>
    <message>
        <source>2 h of unbroken sun, or 2.5 h broken up</source>
        <translation>連続 2 時間、または分かれて 2.5 時間の日照</translation>
    </message>
    <message>
        <source>Output: h:min and number of intervals</source>
        <translation>出力: 時:分と区間数</translation>
    </message>
    <message>
        <source>How many rooms of a flat must have it</source>
        <translation>住戸の何部屋に必要か</translation>
    </message>
    <message>
        <source>Other zones: change the days in a copy of the rule</source>
        <translation>その他の地域: 規定の複製で日を変更</translation>
    </message>
    <message>
        <source>From 22 April to 22 August at least 2 h of unbroken sun, or 2.5 h broken up with one part of at least 1 h.</source>
        <translation>4 月 22 日から 8 月 22 日に、連続 2 時間、または 1 時間以上の区間を含めて合計 2.5 時間以上の日照。</translation>
    </message>
    <message>
        <source>days</source>
        <translation>日</translation>
    </message>
    <message>
        <source>every day</source>
        <translation>毎日</translation>
    </message>
    <message>
        <source>mirrored half year</source>
        <translation>折り返しの半年</translation>
    </message>
    <message>
        <source>Net new shadow of the year</source>
        <translation>年間の正味の新しい影</translation>
    </message>
    <message>
        <source>Existing shadow, sq ft h</source>
        <translation>既存の影、sq ft h</translation>
    </message>
    <message>
        <source>Shadow with project, sq ft h</source>
        <translation>計画ありの影、sq ft h</translation>
    </message>
    <message>
        <source>Net new shadow, sq ft h</source>
        <translation>正味の新しい影、sq ft h</translation>
    </message>
    <message>
        <source>Share of the theoretical sum</source>
        <translation>理論合計に占める割合</translation>
    </message>
    <message>
        <source>From</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>To</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Largest area, sq ft</source>
        <translation>最大面積、sq ft</translation>
    </message>
    <message>
        <source>Trigger: buildings of more than 40 ft</source>
        <translation>対象: 40 ft を超える建物</translation>
    </message>
    <message>
        <source>Hours: from 1 h after sunrise to 1 h before sunset, every day of the year</source>
        <translation>時間帯: 年間毎日、日の出 1 時間後から日没 1 時間前</translation>
    </message>
    <message>
        <source>Theoretical annual available sunlight: area x 3,721.4 h</source>
        <translation>年間の理論日照: 面積 x 3,721.4 時間</translation>
    </message>
    <message>
        <source>Own count of the same hours: 3,720.9</source>
        <translation>同じ時間の独自の集計: 3,720.9</translation>
    </message>
    <message>
        <source>Samples of 15 min, mirrored half year</source>
        <translation>15 分ごとの標本、折り返しの半年</translation>
    </message>
    <message>
        <source>Absolute limits of single parks and qualitative criteria</source>
        <translation>個々の公園の絶対的な限度と定性的な基準</translation>
    </message>
    <message>
        <source>Cumulative projects: run the rule again with a scenario that holds them</source>
        <translation>累積する計画: それらを含むシナリオで規定を再度実行</translation>
    </message>
    <message>
        <source>Opening hours of the park</source>
        <translation>公園の開園時間</translation>
    </message>
    <message>
        <source>The trigger (height of the proposal)</source>
        <translation>対象の条件 (計画案の高さ)</translation>
    </message>
    <message>
        <source>The figures at hand state no numeric limit, so there are figures and no verdict.</source>
        <translation>手元の資料に数値の限度がないため、数値のみで判定はありません。</translation>
    </message>
    <message>
        <source>Shadow on a park over a whole year in square-foot-hours, as a share of the theoretical annual available sunlight.</source>
        <translation>公園の年間の影 (平方フィート時)、年間の理論日照に占める割合。</translation>
    </message>
    <message>
        <source>Possible sun</source>
        <translation>可能日照</translation>
    </message>
    <message>
        <source>What the rule allows where the norm is missed already</source>
        <translation>すでに基準を満たさない所で規定が許すこと</translation>
    </message>
    <message>
        <source>The days and hours are those of the light norm of TNO; the point is on the facade, 0.75 m above the floor.</source>
        <translation>日と時間は TNO の緩い基準のもので、点は外壁面、床から 0.75 m です。</translation>
    </message>
    <message>
        <source>The sun may be broken up; the worst day decides.</source>
        <translation>日照は分かれていてもよく、最悪の日で判定します。</translation>
    </message>
    <message>
        <source>At least 2 h of possible sun on every day from 19 February to 21 October on the facade, with the sun above 10 degrees.</source>
        <translation>2 月 19 日から 10 月 21 日の毎日、外壁面で太陽高度 10 度超の可能日照 2 時間以上。</translation>
    </message>
    <message>
        <source>The middle of the sill, inside the glass, usually 0.75 m above the floor</source>
        <translation>窓台の中央、ガラスの内側、通常は床から 0.75 m</translation>
    </message>
    <message>
        <source>Which facade is that of the living room</source>
        <translation>どの外壁面が居間のものか</translation>
    </message>
    <message>
        <source>The glass is taken 0.1 m behind the face of the wall (opening.wall_m), and the edges of that opening hide the sun.</source>
        <translation>ガラスは壁面から 0.1 m 奥 (opening.wall_m) とし、開口の縁が太陽を隠します。</translation>
    </message>
    <message>
        <source>At least 2 h of possible sun on every day from 19 February to 21 October, in the middle of the sill.</source>
        <translation>2 月 19 日から 10 月 21 日の毎日、窓台の中央で可能日照 2 時間以上。</translation>
    </message>
    <message>
        <source>At least 3 h of possible sun on every day from 21 January to 22 November, in the middle of the sill.</source>
        <translation>1 月 21 日から 11 月 22 日の毎日、窓台の中央で可能日照 3 時間以上。</translation>
    </message>
    <message>
        <source>Hourly from 9:18 to 18:18 (local mean noon)</source>
        <translation>9:18 から 18:18 まで 1 時間ごと (地方平均正午)</translation>
    </message>
    <message>
        <source>Diagrams on 21 March, June and September</source>
        <translation>3 月、6 月、9 月の 21 日の図</translation>
    </message>
    <message>
        <source>Diagrams on 21 December</source>
        <translation>12 月 21 日の図</translation>
    </message>
    <message>
        <source>On 21 December the hours are those of the wall clock too.</source>
        <translation>12 月 21 日も時間は時計の時刻です。</translation>
    </message>
    <message>
        <source>Hourly diagrams from 9:18 to 18:18 on 21 March, June and September.</source>
        <translation>3 月、6 月、9 月の 21 日、9:18 から 18:18 まで 1 時間ごとの図。</translation>
    </message>
    <message>
        <source>The figures at hand state no limit, so there are figures and no verdict.</source>
        <translation>手元の資料に限度がないため、数値のみで判定はありません。</translation>
    </message>
    <message>
        <source>The equinoxes are 21 March and 21 September.</source>
        <translation>春分と秋分は 3 月 21 日と 9 月 21 日です。</translation>
    </message>
    <message>
        <source>Shadow on parks and schoolyards within 10-16 h daylight time, from the spring to the autumn equinox.</source>
        <translation>春分から秋分まで、夏時間 10-16 時の公園と校庭の影。</translation>
    </message>
    <message>
        <source>Area with more than 3 h of shadow, and more than by the body within the zoning</source>
        <translation>3 時間を超え、かつ許容建物形状による影より多い影の面積</translation>
    </message>
    <message>
        <source>Shadow at the worst spot</source>
        <translation>最悪の点の影</translation>
    </message>
    <message>
        <source>mean winter day</source>
        <translation>平均的な冬の日</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>住宅</translation>
    </message>
    <message>
        <source>Area with more than 3 h and more than before, m²</source>
        <translation>3 時間超かつ以前より多い面積、m²</translation>
    </message>
    <message>
        <source>Shadow at the worst spot, min</source>
        <translation>最悪の点の影、分</translation>
    </message>
    <message>
        <source>Trigger: buildings of more than 25 m</source>
        <translation>対象: 25 m を超える建物</translation>
    </message>
    <message>
        <source>Passes where a body within the zoning shades as much</source>
        <translation>許容建物形状の影が同程度なら適合</translation>
    </message>
    <message>
        <source>Facades of the homes: their ground is measured</source>
        <translation>住宅の外壁面: その地面を測定します</translation>
    </message>
    <message>
        <source>Whether the scenario &apos;from&apos; is a body within the zoning</source>
        <translation>シナリオ &apos;from&apos; が許容建物形状かどうか</translation>
    </message>
    <message>
        <source>The scenario &apos;from&apos; holds the body within the zoning, or nothing on the site.</source>
        <translation>シナリオ &apos;from&apos; は許容建物形状、または敷地に何もない状態です。</translation>
    </message>
    <message>
        <source>Shadow is counted minute by minute from 8 to 17 h; the diagrams show it by the hour.</source>
        <translation>影は 8 時から 17 時まで 1 分ごとに数え、図は 1 時間ごとに示します。</translation>
    </message>
    <message>
        <source>Each spot is compared with itself: it may have more than 3 h of shadow where the body within the zoning gives it as much. A spot within a minute of 3 h, for each time that shadow comes, is borderline.</source>
        <translation>各点はそれ自身と比べます。許容建物形状が同程度の影を与える所では 3 時間を超えてもかまいません。影がかかるたびに 1 分として、3 時間との差がその範囲の点は境界とします。</translation>
    </message>
    <message>
        <source>The shadow that the hill casts without any building is not the tower&apos;s: it is not counted.</source>
        <translation>建物がなくても丘が落とす影はタワーのものではなく、数えません。</translation>
    </message>
    <message>
        <source>Buildings of more than 25 m: at most 3 h of shadow on neighbours&apos; homes on 3 November and 8 February, or no more than a body within the zoning.</source>
        <translation>25 m を超える建物: 11 月 3 日と 2 月 8 日に隣接する住宅への影が 3 時間以内、または許容建物形状による影以内。</translation>
    </message>
    <message>
        <source>Slopes: there is no terrain, so the ground is taken as flat</source>
        <translation>斜面: 地形がないので、地面は平らとみなします</translation>
    </message>
    <message>
        <source>The rule leaves terrain out; here terrain casts shadow</source>
        <translation>規定は地形を除きますが、ここでは地形も影を落とします</translation>
    </message>
    <message>
        <source>Where the windows are: one was assumed in each bay and storey of the facades</source>
        <translation>窓の位置: 外壁の各スパンと各階に一つずつあると仮定しました</translation>
    </message>
</context>
<context>
    <name>StartQuestion</name>
    <message>
        <source>How sunny are our parks and streets?</source>
        <translation>公園や街路の日当たりは？</translation>
    </message>
    <message>
        <source>Hours of sun by place and month, and what lies below a threshold</source>
        <translation>場所・月別の日照時間と、しきい値を下回るところ</translation>
    </message>
    <message>
        <source>What would a tower change?</source>
        <translation>塔で何が変わるか？</translation>
    </message>
    <message>
        <source>New shadow, the worst spot and the places it reaches, live while you drag</source>
        <translation>新しい影、影響が最大の地点、影が届く場所をドラッグしながらライブ表示</translation>
    </message>
    <message>
        <source>Does this proposal pass the rules?</source>
        <translation>この計画案は規定に適合するか？</translation>
    </message>
    <message>
        <source>Verdicts by the rules of review boards, the site&apos;s first, and a book to file</source>
        <translation>審査機関の規定による判定 (その土地の規定を先に) と、提出用の冊子</translation>
    </message>
    <message>
        <source>Which facades and windows get sun?</source>
        <translation>どのファサードと窓に日が当たるか？</translation>
    </message>
    <message>
        <source>Hours of sun and daylight at points of the facades</source>
        <translation>ファサードの点での日照時間と昼光</translation>
    </message>
    <message>
        <source>Is the shade where we want it?</source>
        <translation>影は望む場所にあるか？</translation>
    </message>
    <message>
        <source>Wanted shade in summer against unwanted shadow in winter, by hour and month</source>
        <translation>夏の望ましい影と冬の望ましくない影を、時刻と月ごとに比べます</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Architect: design a tower</source>
        <translation>設計者: 塔を設計する</translation>
    </message>
    <message>
        <source>A tower on a lot, its shadow while you shape it, and what it changes</source>
        <translation>敷地の塔、形を変えるときの影、その影響</translation>
    </message>
    <message>
        <source>The green outlines in the view are lots. Towers are designed in the panel Tower.</source>
        <translation>表示の緑の輪郭は敷地です。塔は「塔」パネルで設計します。</translation>
    </message>
    <message>
        <source>The list above has the lots of the project. Design tower puts a first tower on the one chosen.</source>
        <translation>上の一覧はプロジェクトの敷地です。「塔を設計」で選んだ敷地に最初の塔を置きます。</translation>
    </message>
    <message>
        <source>Type 70 storeys, or drag the arrow on the tower. Its shadow follows, and so do height and floor area.</source>
        <translation>70 階と入力するか、塔の矢印をドラッグします。影、高さ、延べ面積が追従します。</translation>
    </message>
    <message>
        <source>Build puts the tower into a new scenario. One undo takes it back.</source>
        <translation>「建設」で塔が新しいシナリオに入ります。元に戻すのは 1 回です。</translation>
    </message>
    <message>
        <source>Brown ground gains shadow, blue loses it. The panel Results has the figures.</source>
        <translation>茶色は影が増え、青は減る地面です。数値は「結果」パネルにあります。</translation>
    </message>
    <message>
        <source>File &gt; Export writes the comparison as PDF, picture, tables and data. That is the end of this tour.</source>
        <translation>「ファイル &gt; 書き出す」で比較を PDF、画像、表、データにします。このツアーは以上です。</translation>
    </message>
    <message>
        <source>Planner: weigh shade over a year</source>
        <translation>計画担当: 1 年の影を評価する</translation>
    </message>
    <message>
        <source>Shadow of a whole year, one moment of it, and a score of wanted and unwanted shadow</source>
        <translation>1 年間の影、その一時点、望ましい影と望ましくない影のスコア</translation>
    </message>
    <message>
        <source>A study answers four questions. The first is what to measure: choose Hours of shadow.</source>
        <translation>検討は四つの問いに答えます。最初は何を測るか: 「日影時間」を選びます。</translation>
    </message>
    <message>
        <source>The second is when: choose the whole year.</source>
        <translation>二つ目はいつか: 1 年間を選びます。</translation>
    </message>
    <message>
        <source>Cells of 10 m are enough for a first look; smaller ones take longer.</source>
        <translation>最初は 10 m のセルで十分です。小さくすると時間がかかります。</translation>
    </message>
    <message>
        <source>The line above the button says how long a study will take, before it runs. Start it.</source>
        <translation>ボタンの上の行に計算時間が前もって出ます。始めましょう。</translation>
    </message>
    <message>
        <source>The map shows the whole year. Choose One moment to see sun and shadow at a date and time.</source>
        <translation>図は 1 年間を示します。「一時点」を選ぶと、ある日時の太陽と影を表示します。</translation>
    </message>
    <message>
        <source>Shade is welcome in summer and unwelcome in winter. The panel Weights says how much, month by month.</source>
        <translation>影は夏は歓迎され、冬は嫌われます。「重み」パネルで月ごとに程度を示します。</translation>
    </message>
    <message>
        <source>Compute score adds up the year by these weights. Above zero, wanted shade outweighs unwanted shadow.</source>
        <translation>「スコアを計算」でこの重みで 1 年を合計します。0 より大きいと望ましい影が上回ります。</translation>
    </message>
    <message>
        <source>File &gt; Export writes the score by month as tables, charts and maps for GIS. That is the end of this tour.</source>
        <translation>「ファイル &gt; 書き出す」で月別スコアを表、グラフ、GIS 用の図にします。このツアーは以上です。</translation>
    </message>
    <message>
        <source>Review board: judge a proposal</source>
        <translation>審査機関: 計画案を判定する</translation>
    </message>
    <message>
        <source>A place whose sunlight matters, a proposal, and the verdicts of a rule</source>
        <translation>日照が重要な場所、計画案、規定による判定</translation>
    </message>
    <message>
        <source>A review needs places whose sunlight matters. Choose Study &gt; Draw place and click the corners of a lawn in the park; Enter finishes.</source>
        <translation>審査には日照が重要な場所が必要です。「検討 &gt; 場所を描く」を選び、公園の芝生の角をクリックし、Enter で終えます。</translation>
    </message>
    <message>
        <source>It also needs a proposal. Here we design one; usually the project has it already.</source>
        <translation>計画案も必要です。ここでは設計しますが、普通はプロジェクトに入っています。</translation>
    </message>
    <message>
        <source>Design tower puts a tower on the lot chosen in the list.</source>
        <translation>「塔を設計」で一覧の敷地に塔を置きます。</translation>
    </message>
    <message>
        <source>Build makes it a scenario, which can be compared with the existing city.</source>
        <translation>「建設」でシナリオになり、現況の都市と比較できます。</translation>
    </message>
    <message>
        <source>Study &gt; Review by a rule opens the panel Review.</source>
        <translation>「検討 &gt; 規定による審査」で「審査」パネルが開きます。</translation>
    </message>
    <message>
        <source>Choose the rule of the board, here CEQR of New York. Its tool tip says what it asks and how sure its figures are.</source>
        <translation>審査機関の規定を選びます。ここではニューヨークの CEQR です。ツールチップに内容と数値の確かさがあります。</translation>
    </message>
    <message>
        <source>Run review judges every ticked place on the days of the rule.</source>
        <translation>「審査する」で選んだ場所を規定の日について判定します。</translation>
    </message>
    <message>
        <source>The table has the verdicts and the numbers behind them. Export shows the sheets and writes them with all data. That is the end of this tour.</source>
        <translation>表に判定と根拠の数値があります。「書き出す」で図面を表示し、全データとともに書き出します。このツアーは以上です。</translation>
    </message>
    <message>
        <source>Scenario &gt; Compare with the existing city asks what the tower changes. Where that takes longer, the button Compare of the panel Study starts it.</source>
        <translation>「シナリオ &gt; 現況の都市と比較」で塔による変化を調べます。時間がかかる場合は「検討」パネルの「比較」ボタンで始めます。</translation>
    </message>
    <message>
        <source>Play and the two sliders move the sun. Whole period returns to the year.</source>
        <translation>再生と 2 本のスライダーで太陽が動きます。「期間全体」で 1 年に戻ります。</translation>
    </message>
    <message>
        <source>Give it 90 storeys, so that its shadow reaches the lawn.</source>
        <translation>影が芝生に届くように 90 階にします。</translation>
    </message>
</context>
<context>
    <name>TreePanel</name>
    <message>
        <source>With trees, in the mean over the cells, while trees are dragged or planted: the region of the study and the places that change most</source>
        <translation>樹木を移動または植える間の、セル平均(樹木を含む): 検討の範囲と変化の大きい場所</translation>
    </message>
</context>
<context>
    <name>noonmark</name>
    <message>
        <source>Height field</source>
        <translation>高さの項目</translation>
    </message>
    <message>
        <source>Field with the heights (default: found by its name)</source>
        <translation>高さのフィールド（既定：名前から判定）</translation>
    </message>
    <message>
        <source>found by name</source>
        <translation>名称で検出</translation>
    </message>
    <message>
        <source>Storeys field</source>
        <translation>階数の項目</translation>
    </message>
    <message>
        <source>Field with the storeys above the ground (default: found by its name)</source>
        <translation>地上階数のフィールド（既定：名前から判定）</translation>
    </message>
    <message>
        <source>Unit of heights</source>
        <translation>高さの単位</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>ファイルの通り</translation>
    </message>
    <message>
        <source>Height of a storey</source>
        <translation>階高</translation>
    </message>
    <message>
        <source>Height of a storey, 2 to 6 m</source>
        <translation>階高、2～6 m</translation>
    </message>
    <message>
        <source>Default height</source>
        <translation>既定の高さ</translation>
    </message>
    <message>
        <source>Height of buildings without height data, 1 to 1000 m</source>
        <translation>高さの情報がない建物の高さ、1～1000 m</translation>
    </message>
    <message>
        <source>Terrain from building bases</source>
        <translation>建物の基部から地形</translation>
    </message>
    <message>
        <source>If there is no terrain, derive one from the ground elevations of the buildings; auto (default): only where neighbours stand at different heights</source>
        <translation>地形がない場合、建物の地盤高から作ります。auto（既定）：隣り合う建物の高さが異なる場合のみ</translation>
    </message>
    <message>
        <source>Terrain shows</source>
        <translation>地形の内容</translation>
    </message>
    <message>
        <source>What terrain rasters show: the bare ground, or a surface with the buildings on it; auto (default): a surface where they jump at the outlines of buildings</source>
        <translation>地形ラスターの内容：地表面、または建物を含む表面。auto（既定）：建物の輪郭で段差があれば表面</translation>
    </message>
    <message>
        <source>Missing heights from the surface model</source>
        <translation>欠けている高さを表面モデルから取る</translation>
    </message>
    <message>
        <source>Give buildings without a height that of the surface model above the ground</source>
        <translation>高さのない建物に、地面からの表面モデルの高さを使います</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>Read this layer only</source>
        <translation>このレイヤーだけを読み込む</translation>
    </message>
    <message>
        <source>the polygon layers that hold buildings</source>
        <translation>建物のあるポリゴンレイヤー</translation>
    </message>
    <message>
        <source>Coordinate system</source>
        <translation>座標系</translation>
    </message>
    <message>
        <source>Coordinate reference system of files that do not state it: EPSG:2263</source>
        <translation>座標参照系が記されていないファイルの座標参照系：EPSG:2263</translation>
    </message>
    <message>
        <source>as in the file (example: EPSG:2263)</source>
        <translation>ファイルの通り (例: EPSG:2263)</translation>
    </message>
    <message>
        <source>Level of detail</source>
        <translation>詳細度</translation>
    </message>
    <message>
        <source>the highest</source>
        <translation>最も高いもの</translation>
    </message>
    <message>
        <source>Maximum distance</source>
        <translation>最大距離</translation>
    </message>
    <message>
        <source>Leave out features farther than this from the middle of the data, m</source>
        <translation>データの中心からこの距離より遠い地物を除く、m</translation>
    </message>
    <message>
        <source>Mesh north</source>
        <translation>メッシュの北</translation>
    </message>
    <message>
        <source>Meshes: azimuth of the mesh&apos;s north axis from true north, clockwise, degrees</source>
        <translation>メッシュ：メッシュの北軸の真北からの方位角（時計回り、度）</translation>
    </message>
    <message>
        <source>Origin located at</source>
        <translation>原点の位置</translation>
    </message>
    <message>
        <source>Meshes: position of the mesh&apos;s origin, degrees</source>
        <translation>メッシュ：メッシュの原点の位置、度</translation>
    </message>
    <message>
        <source>Buildings stand</source>
        <translation>建物の置き方</translation>
    </message>
    <message>
        <source>Where buildings stand: each on the terrain, or at the elevations that the file states (absolute); auto (default): as its bases lie against the terrain</source>
        <translation>建物の位置：それぞれ地形の上、またはファイルの標高（absolute）。auto（既定）：基部と地形の関係から判定</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>上向きの軸</translation>
    </message>
    <message>
        <source>Meshes: the axis that points up, y or z; auto (default): as the format says or the shape suggests</source>
        <translation>メッシュ：上方向の軸、y または z。auto（既定）：形式または形状から判定</translation>
    </message>
    <message>
        <source>Unit of coordinates</source>
        <translation>座標の単位</translation>
    </message>
    <message>
        <source>Receivers</source>
        <translation>測定点</translation>
    </message>
    <message>
        <source>cells or points where shadow is measured</source>
        <translation>影を測定するセルまたは点</translation>
    </message>
    <message>
        <source>Area of the receivers</source>
        <translation>測定点の面積</translation>
    </message>
    <message>
        <source>area of all receivers</source>
        <translation>すべての測定点の面積</translation>
    </message>
    <message>
        <source>Shadow area</source>
        <translation>日影面積</translation>
    </message>
    <message>
        <source>sum over the receivers of (share of the sunlit time in shadow x cell area)</source>
        <translation>各測定点の（日照時間のうち影の割合 × セルの面積）の合計</translation>
    </message>
    <message>
        <source>Mean gross</source>
        <translation>累計日影の平均</translation>
    </message>
    <message>
        <source>minutes in shadow per day, mean over days and receivers</source>
        <translation>1 日あたりの影の分数（日と測定点の平均）</translation>
    </message>
    <message>
        <source>Max gross</source>
        <translation>総影時間の最大</translation>
    </message>
    <message>
        <source>minutes in shadow per day, mean over the days, at the receiver that has most</source>
        <translation>最も影の長い測定点における 1 日あたりの影の分数（日の平均）</translation>
    </message>
    <message>
        <source>Mean continuous</source>
        <translation>連続日影の平均</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow on any day, mean over the receivers</source>
        <translation>1 日で最も長く続く影（測定点の平均）</translation>
    </message>
    <message>
        <source>Max continuous</source>
        <translation>連続日影の最大</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow at any receiver on any day</source>
        <translation>いずれかの測定点で 1 日に最も長く続く影</translation>
    </message>
    <message>
        <source>Bay</source>
        <translation>スパン</translation>
    </message>
    <message>
        <source>Facades: width of a bay, one point or window each</source>
        <translation>立面：スパンの幅（それぞれに点または窓が一つ）</translation>
    </message>
    <message>
        <source>Storey</source>
        <translation>階高</translation>
    </message>
    <message>
        <source>Height of a storey: facades have one point or window each, windows are numbered by it</source>
        <translation>階高：立面には各階に点または窓が一つあり、窓の階数はこれで数えます</translation>
    </message>
    <message>
        <source>Above floor</source>
        <translation>床からの高さ</translation>
    </message>
    <message>
        <source>Facades: height of the points above the floor</source>
        <translation>立面：床からの点の高さ</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>高さの基準</translation>
    </message>
    <message>
        <source>Windows: heights are elevations, as those of the city, or metres above the ground below</source>
        <translation>窓：高さは都市と同じ標高、または真下の地面からの高さ（m）</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Plane and lines: height above the mean of the ground, of the region or parcel</source>
        <translation>平面と線：範囲または敷地の平均地盤からの高さ</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>Title block: the project</source>
        <translation>表題欄：プロジェクト</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>作成者</translation>
    </message>
    <message>
        <source>Title block: the author</source>
        <translation>表題欄：作成者</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>発注者</translation>
    </message>
    <message>
        <source>Title block: the client</source>
        <translation>表題欄：依頼者</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>Title block: the date as printed (default: today)</source>
        <translation>表題欄：印刷される日付（既定：今日）</translation>
    </message>
    <message>
        <source>Sheet numbers</source>
        <translation>図面番号</translation>
    </message>
    <message>
        <source>Title block: A- numbers the sheets A-1, A-2, ...</source>
        <translation>表題欄：A- とすると図面番号は A-1、A-2、…</translation>
    </message>
    <message>
        <source>example: A- for A-1, A-2...</source>
        <translation>例: A-1, A-2... なら A-</translation>
    </message>
    <message>
        <source>Sunlit time</source>
        <translation>日照時間</translation>
    </message>
    <message>
        <source>minutes of the period with the sun above the horizon</source>
        <translation>期間のうち太陽が地平線より上にある分数</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>重み</translation>
    </message>
    <message>
        <source>from -1 (shadow is unwanted) to 1 (shade is wanted)</source>
        <translation>-1（影は望ましくない）から 1（日陰が望ましい）まで</translation>
    </message>
    <message>
        <source>Water left out</source>
        <translation>除外した水面</translation>
    </message>
    <message>
        <source>area of rivers and lakes in the region, which is no ground</source>
        <translation>範囲内の川や湖の面積（地面に含まれない）</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>フィート</translation>
    </message>
    <message>
        <source>US survey feet</source>
        <translation>米国測量フィート</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>decimetres</source>
        <translation>デシメートル</translation>
    </message>
    <message>
        <source>Unit of numbers without a unit in it: m, ft, us-ft, dm, cm, mm or in (default m)</source>
        <translation>単位のない数値の単位：m、ft、us-ft、dm、cm、mm、in（既定 m）</translation>
    </message>
    <message>
        <source>Meshes: unit of the coordinates: m, ft, us-ft, dm, cm, mm or in (default m)</source>
        <translation>メッシュ：座標の単位：m、ft、us-ft、dm、cm、mm、in（既定 m）</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>検討</translation>
    </message>
    <message>
        <source>Saved result</source>
        <translation>保存した結果</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>スコア</translation>
    </message>
    <message>
        <source>of the theoretical area x hours</source>
        <translation>理論上の面積 x 時間に対する割合</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>比較基準</translation>
    </message>
    <message>
        <source>area in shadow in the baseline</source>
        <translation>基準での影の面積</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>シナリオ</translation>
    </message>
    <message>
        <source>area in shadow in the scenario</source>
        <translation>シナリオでの影の面積</translation>
    </message>
    <message>
        <source>Incremental</source>
        <translation>増分</translation>
    </message>
    <message>
        <source>area in shadow in the scenario, lit in the baseline</source>
        <translation>シナリオでは影、基準では日照の面積</translation>
    </message>
    <message>
        <source>Gained</source>
        <translation>増加分の日照</translation>
    </message>
    <message>
        <source>area lit in the scenario, in shadow in the baseline</source>
        <translation>シナリオでは日照、基準では影の面積</translation>
    </message>
    <message>
        <source>Days</source>
        <translation>日数</translation>
    </message>
    <message>
        <source>Hours of sun</source>
        <translation>日照時間</translation>
    </message>
    <message>
        <source>hours with the sun above the horizon</source>
        <translation>太陽が地平線より上にある時間</translation>
    </message>
    <message>
        <source>Theoretical</source>
        <translation>理論値</translation>
    </message>
    <message>
        <source>area x sunlit hours: without any shadow</source>
        <translation>面積 x 日照時間：影がまったくない場合</translation>
    </message>
    <message>
        <source>area x hours in shadow in the baseline</source>
        <translation>基準での面積 x 影の時間</translation>
    </message>
    <message>
        <source>area x hours in shadow in the scenario</source>
        <translation>シナリオでの面積 x 影の時間</translation>
    </message>
    <message>
        <source>area x hours in shadow in the scenario, lit in the baseline</source>
        <translation>シナリオでは影、基準では日照の面積 x 時間</translation>
    </message>
    <message>
        <source>area x hours lit in the scenario, in shadow in the baseline</source>
        <translation>シナリオでは日照、基準では影の面積 x 時間</translation>
    </message>
    <message>
        <source>Share of baseline</source>
        <translation>基準の割合</translation>
    </message>
    <message>
        <source>Share of scenario</source>
        <translation>シナリオの割合</translation>
    </message>
    <message>
        <source>Share of incremental</source>
        <translation>増分の割合</translation>
    </message>
    <message>
        <source>Open ground</source>
        <translation>空地</translation>
    </message>
    <message>
        <source>area of the place without buildings</source>
        <translation>建物を除く場所の面積</translation>
    </message>
    <message>
        <source>Mean sun</source>
        <translation>平均日照</translation>
    </message>
    <message>
        <source>hours of sun a day, mean over the days and the place</source>
        <translation>1 日の日照時間（日と場所の平均）</translation>
    </message>
    <message>
        <source>Min sun</source>
        <translation>最小日照</translation>
    </message>
    <message>
        <source>hours of sun a day, mean over the days, at the cell that has least</source>
        <translation>最も少ないセルの 1 日の日照時間（日の平均）</translation>
    </message>
    <message>
        <source>Max sun</source>
        <translation>最大日照</translation>
    </message>
    <message>
        <source>hours of sun a day, mean over the days, at the cell that has most</source>
        <translation>最も多いセルの 1 日の日照時間（日の平均）</translation>
    </message>
    <message>
        <source>Share with enough sun</source>
        <translation>十分な日照のある割合</translation>
    </message>
    <message>
        <source>share of the area with the hours of sun a day that are enough, or more</source>
        <translation>十分な日照時間以上の面積の割合</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>points where sun is measured</source>
        <translation>日照を測定する点</translation>
    </message>
    <message>
        <source>mean minutes a day with the sun above the horizon: 100 % of the time</source>
        <translation>太陽が地平線より上にある 1 日の平均分数：時間の 100 %</translation>
    </message>
    <message>
        <source>Least sun</source>
        <translation>最小の日照</translation>
    </message>
    <message>
        <source>Most sun</source>
        <translation>最大の日照</translation>
    </message>
    <message>
        <source>minutes in shadow per day, mean over days and points; a point that faces away from the sun is in shadow</source>
        <translation>1 日の影の分数（日と点の平均）。太陽に背を向けた点は影とみなします</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow on any day, mean over the points</source>
        <translation>1 日で最も長く続く影（点の平均）</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow at any point on any day</source>
        <translation>いずれかの点で 1 日に最も長く続く影</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>日照</translation>
    </message>
    <message>
        <source>minutes per day that a point is in the sun, mean over the days</source>
        <translation>点が日照を受ける 1 日の分数（日の平均）</translation>
    </message>
    <message>
        <source>Share of time</source>
        <translation>時間の割合</translation>
    </message>
    <message>
        <source>sun, of the time with the sun above the horizon</source>
        <translation>太陽が地平線より上にある時間のうち日照の割合</translation>
    </message>
    <message>
        <source>Gross</source>
        <translation>累計</translation>
    </message>
    <message>
        <source>minutes in shadow per day, mean over the days; a point that faces away from the sun is in shadow</source>
        <translation>1 日の影の分数（日の平均）。太陽に背を向けた点は影とみなします</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>連続</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow on any day</source>
        <translation>1 日で最も長く続く影</translation>
    </message>
    <message>
        <source>Longest sun</source>
        <translation>最長日照</translation>
    </message>
    <message>
        <source>longest unbroken run in the sun on any day</source>
        <translation>1 日で最も長く続く日照</translation>
    </message>
    <message>
        <source>minutes of the month with the sun above the horizon</source>
        <translation>太陽が地平線より上にある月の分数</translation>
    </message>
    <message>
        <source>Mean shadow</source>
        <translation>平均影時間</translation>
    </message>
    <message>
        <source>minutes in shadow in the whole month, mean over the receivers</source>
        <translation>月全体の影の分数（測定点の平均）</translation>
    </message>
    <message>
        <source>Number of days</source>
        <translation>日数</translation>
    </message>
    <message>
        <source>Hours per day</source>
        <translation>1 日の時間数</translation>
    </message>
    <message>
        <source>Hours a day, 0 to 24; 0 is one instant</source>
        <translation>1 日の時間数、0～24。0 は一瞬</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>Length of a step, minutes; adjusted so that whole steps fill the hours of each day</source>
        <translation>ステップの長さ（分）。各日の時間がちょうど割り切れるよう調整されます</translation>
    </message>
    <message>
        <source>More shadow</source>
        <translation>影の増加</translation>
    </message>
    <message>
        <source>area where the minutes rose by more than the threshold</source>
        <translation>分数がしきい値を超えて増えた面積</translation>
    </message>
    <message>
        <source>Less shadow</source>
        <translation>影の減少</translation>
    </message>
    <message>
        <source>area where the minutes fell by more than the threshold</source>
        <translation>分数がしきい値を超えて減った面積</translation>
    </message>
    <message>
        <source>Any more shadow</source>
        <translation>影の増加（すべて）</translation>
    </message>
    <message>
        <source>area where the minutes rose at all</source>
        <translation>分数が少しでも増えた面積</translation>
    </message>
    <message>
        <source>Any less shadow</source>
        <translation>影の減少（すべて）</translation>
    </message>
    <message>
        <source>area where the minutes fell at all</source>
        <translation>分数が少しでも減った面積</translation>
    </message>
    <message>
        <source>Mean change</source>
        <translation>平均変化</translation>
    </message>
    <message>
        <source>mean of the change over the receivers</source>
        <translation>測定点における変化の平均</translation>
    </message>
    <message>
        <source>Largest increase</source>
        <translation>最大増加</translation>
    </message>
    <message>
        <source>the largest increase of a receiver</source>
        <translation>測定点の最大の増加</translation>
    </message>
    <message>
        <source>Largest decrease</source>
        <translation>最大減少</translation>
    </message>
    <message>
        <source>the largest decrease of a receiver</source>
        <translation>測定点の最大の減少</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>しきい値</translation>
    </message>
    <message>
        <source>change that counts: minutes a day of gross shadow, minutes of continuous shadow</source>
        <translation>数える変化：1 日の総影の分数、連続影の分数</translation>
    </message>
    <message>
        <source>Change of the shadow area</source>
        <translation>影の面積の変化</translation>
    </message>
    <message>
        <source>change of the sum over the receivers of (share of the sunlit time in shadow x cell area)</source>
        <translation>各測定点の（日照時間のうち影の割合 x セルの面積）の合計の変化</translation>
    </message>
    <message>
        <source>Built over</source>
        <translation>建物になった</translation>
    </message>
    <message>
        <source>open ground before, under a building after: no receiver</source>
        <translation>以前は空地、以後は建物の下：測定点なし</translation>
    </message>
    <message>
        <source>Became ground</source>
        <translation>地面になった</translation>
    </message>
    <message>
        <source>under a building before, open ground after: no receiver</source>
        <translation>以前は建物の下、以後は空地：測定点なし</translation>
    </message>
    <message>
        <source>Share of the lot</source>
        <translation>敷地に占める割合</translation>
    </message>
    <message>
        <source>Floor plate, % of the lot (default: all of it)</source>
        <translation>基準階面積、敷地に対する %（既定：全体）</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>Floor plate, m2</source>
        <translation>基準階面積、m²</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>先細り</translation>
    </message>
    <message>
        <source>How much narrower the volume is at its top than at its bottom</source>
        <translation>頂部が底部よりどれだけ細いか</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>ねじれ</translation>
    </message>
    <message>
        <source>Turn of the volume from its bottom to its top, clockwise</source>
        <translation>底部から頂部までのねじれ（時計回り）</translation>
    </message>
    <message>
        <source>Storey height</source>
        <translation>階高</translation>
    </message>
    <message>
        <source>Height of a storey, floor to floor</source>
        <translation>階高（床から床まで）</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>階数</translation>
    </message>
    <message>
        <source>Number of storeys, podium included</source>
        <translation>階数（低層部を含む）</translation>
    </message>
    <message>
        <source>Height above ground</source>
        <translation>地盤からの高さ</translation>
    </message>
    <message>
        <source>Total height</source>
        <translation>全高</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Rotation clockwise about the middle of the tower, which must stay on its lot</source>
        <translation>タワーの中心まわりの時計回りの回転。敷地内に収まる必要があります</translation>
    </message>
    <message>
        <source>Podium</source>
        <translation>基壇</translation>
    </message>
    <message>
        <source>Storeys of a podium below the tower</source>
        <translation>タワーの下の低層部の階数</translation>
    </message>
    <message>
        <source>From height</source>
        <translation>開始高さ</translation>
    </message>
    <message>
        <source>Inset</source>
        <translation>後退</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>Setbacks</source>
        <translation>セットバック</translation>
    </message>
    <message>
        <source>Uses</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>メートル法</translation>
    </message>
    <message>
        <source>Imperial</source>
        <translation>ヤード・ポンド法</translation>
    </message>
    <message>
        <source>Metric and imperial</source>
        <translation>両方</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Units of lengths and areas in tables and sheets</source>
        <translation>表と図面の長さと面積の単位</translation>
    </message>
    <message>
        <source>Score per m² of ground</source>
        <translation>地面 1 m² あたりのスコア</translation>
    </message>
    <message>
        <source>score divided by the area of all receivers</source>
        <translation>スコアを全測定点の面積で割った値</translation>
    </message>
    <message>
        <source>time in the sun per day, mean over days and points</source>
        <translation>1 日の日照時間（日と点の平均）</translation>
    </message>
    <message>
        <source>time in the sun per day at the darkest point</source>
        <translation>最も暗い点の 1 日の日照時間</translation>
    </message>
    <message>
        <source>time in the sun per day at the sunniest point</source>
        <translation>最も日当たりのよい点の 1 日の日照時間</translation>
    </message>
    <message>
        <source>Sun by place</source>
        <translation>場所別の日照</translation>
    </message>
    <message>
        <source>hours of sun a day</source>
        <translation>1 日の日照時間</translation>
    </message>
    <message>
        <source>Share of the area, %</source>
        <translation>面積の割合、%</translation>
    </message>
    <message>
        <source>Area that changes, m²</source>
        <translation>変化する面積、m²</translation>
    </message>
    <message>
        <source>minutes of shadow a day, more than before</source>
        <translation>以前より増えた 1 日の影の分数</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>What maps and sheets show: minutes of shadow, hours of sun, or the share of the sunlit time in the sun</source>
        <translation>地図と図面に示す量：影の分数、日照時間、または可照時間のうち日なたの割合</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>配色</translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation>反転</translation>
    </message>
    <message>
        <source>Turn the colours round: bright where there is much shadow</source>
        <translation>配色を逆にする：影の多い所を明るく</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>Values at the ends of the legend, in the unit shown: 0:8; without it fitted to each map</source>
        <translation>凡例の両端の値（表示中の単位）：0:8。省略すると地図ごとに自動</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>区分</translation>
    </message>
    <message>
        <source>Classes of the legend: continuous, equal:5, quantiles:5, or the numbers between them: 2,4,6; one number is a threshold</source>
        <translation>凡例の区分：continuous、equal:5、quantiles:5、または境界の数値：2,4,6。数値が一つならしきい値</translation>
    </message>
    <message>
        <source>%1 of the area in shadow</source>
        <translation>面積の %1 が影</translation>
    </message>
    <message>
        <source>%1: %2 in shadow</source>
        <translation>%1：%2 が影</translation>
    </message>
    <message>
        <source>%1 of sun a day, %2 in shade</source>
        <translation>日照は 1 日 %1、影は %2</translation>
    </message>
    <message>
        <source>%1: %2 of sun a day, %3 in shade</source>
        <translation>%1：日照は 1 日 %2、影は %3</translation>
    </message>
    <message>
        <source>Of %1 a day with the sun up, the darkest spot gets %2.</source>
        <translation>太陽が出ている 1 日 %1 のうち、最も暗い地点の日照は %2。</translation>
    </message>
    <message>
        <source>The longest unbroken shadow lasts %1.</source>
        <translation>途切れない最長の影は %1。</translation>
    </message>
    <message>
        <source>sunlit time minus gross shadow per day, mean over days and receivers</source>
        <translation>1 日の可照時間から総影時間を引いた値（日と測定点の平均）</translation>
    </message>
    <message>
        <source>Enough sun</source>
        <translation>十分な日照</translation>
    </message>
    <message>
        <source>Hours of sun a day that are enough: the share of each place that has them is stated</source>
        <translation>十分とみなす 1 日の日照時間：各場所でこれを満たす割合を示します</translation>
    </message>
    <message>
        <source>Dates</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>A day: the share of each place with less than enough sun on it is stated; may be repeated</source>
        <translation>日：その日に日照が十分でない割合を場所ごとに示します。複数指定可</translation>
    </message>
    <message>
        <source>Loss that counts</source>
        <translation>数える減少</translation>
    </message>
    <message>
        <source>Minutes of sun a day: the share of each place that loses more is stated</source>
        <translation>1 日の日照の分数：これを超えて減る割合を場所ごとに示します</translation>
    </message>
    <message>
        <source>%1 of %2 places have less than %3 of sun a day</source>
        <translation>%2 か所中 %1 か所で日照が 1 日 %3 未満</translation>
    </message>
    <message>
        <source>Change of mean sun</source>
        <translation>平均日照の変化</translation>
    </message>
    <message>
        <source>hours of sun a day more than in the baseline, mean over the days and the place; negative: less</source>
        <translation>比較基準より増えた 1 日の日照時間（日と場所の平均）。負は減少</translation>
    </message>
    <message>
        <source>Largest loss</source>
        <translation>最大の減少</translation>
    </message>
    <message>
        <source>minutes of sun a day less than in the baseline, mean over the days, at the cell that loses most</source>
        <translation>最も減るセルで比較基準より減った 1 日の日照の分数（日の平均）</translation>
    </message>
    <message>
        <source>Largest gain</source>
        <translation>最大の増加</translation>
    </message>
    <message>
        <source>minutes of sun a day more than in the baseline, mean over the days, at the cell that gains most</source>
        <translation>最も増えるセルで比較基準より増えた 1 日の日照の分数（日の平均）</translation>
    </message>
    <message>
        <source>Share that loses sun</source>
        <translation>日照が減る割合</translation>
    </message>
    <message>
        <source>share of the area that loses more minutes of sun a day than the threshold of loss</source>
        <translation>1 日の日照の分数が減少のしきい値を超えて減る面積の割合</translation>
    </message>
    <message>
        <source>Attributed shadow</source>
        <translation>配分された影</translation>
    </message>
    <message>
        <source>the part of the shadow that one building is charged with; the attributed shadows of all buildings and of the terrain add up to the total</source>
        <translation>影のうち 1 棟の建物に割り当てた分。すべての建物と地形に配分された影を足すと全体になります</translation>
    </message>
    <message>
        <source>Sole contribution</source>
        <translation>単独の寄与</translation>
    </message>
    <message>
        <source>the shadow that would disappear if only this building were gone</source>
        <translation>この建物だけがなければ消える影</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>割合</translation>
    </message>
    <message>
        <source>attributed shadow, as a share of all shadow on the cells</source>
        <translation>セルのすべての影に対する、配分された影の割合</translation>
    </message>
    <message>
        <source>Attributed</source>
        <translation>配分</translation>
    </message>
    <message>
        <source>attributed shadow in minutes a day, mean over the cells</source>
        <translation>配分された影の 1 日の分数（セルの平均）</translation>
    </message>
    <message>
        <source>Sole</source>
        <translation>単独</translation>
    </message>
    <message>
        <source>sole contribution in minutes a day, mean over the cells</source>
        <translation>単独の寄与の 1 日の分数（セルの平均）</translation>
    </message>
    <message>
        <source>Attributed area x hours</source>
        <translation>配分された面積 x 時間</translation>
    </message>
    <message>
        <source>attributed shadow as area x hours of the whole period</source>
        <translation>配分された影（全期間の面積 x 時間）</translation>
    </message>
    <message>
        <source>Sole area x hours</source>
        <translation>単独の面積 x 時間</translation>
    </message>
    <message>
        <source>sole contribution as area x hours of the whole period</source>
        <translation>単独の寄与（全期間の面積 x 時間）</translation>
    </message>
    <message>
        <source>%1 of sun a day on average at %2 points</source>
        <translation>%2 点で日照は平均 1 日 %1</translation>
    </message>
    <message>
        <source>The darkest point gets %1, the sunniest %2, of %3 a day with the sun up.</source>
        <translation>太陽が出ている 1 日 %3 のうち、最も暗い点の日照は %1、最も明るい点は %2。</translation>
    </message>
    <message>
        <source>Share of the points, %</source>
        <translation>点の割合、%</translation>
    </message>
    <message>
        <source>%1 changes no shadow here</source>
        <translation>%1 はここの影を変えません</translation>
    </message>
    <message>
        <source>%1 takes %2 of sun a day on average, at most %3 at one spot</source>
        <translation>%1 は日照を平均 1 日 %2、最大の地点で %3 減らします</translation>
    </message>
    <message>
        <source>%1 gives %2 of sun a day on average, at most %3 at one spot</source>
        <translation>%1 は日照を平均 1 日 %2、最大の地点で %3 増やします</translation>
    </message>
    <message>
        <source>More shadow on %1, less on %2; by more than %3 a day on %4 and %5.</source>
        <translation>影が増える面積は %1、減る面積は %2。1 日 %3 を超える増減はそれぞれ %4、%5。</translation>
    </message>
    <message>
        <source>%1 changes the shadow by %2 at this moment</source>
        <translation>%1 によるこの時点の影の変化は %2</translation>
    </message>
    <message>
        <source>%1 scores %2: wanted shade outweighs unwanted shadow</source>
        <translation>%1 のスコアは %2：望ましい影が望ましくない影を上回ります</translation>
    </message>
    <message>
        <source>%1 scores %2: unwanted shadow outweighs wanted shade</source>
        <translation>%1 のスコアは %2：望ましくない影が望ましい影を上回ります</translation>
    </message>
    <message>
        <source>%1 scores 0: wanted shade and unwanted shadow weigh the same</source>
        <translation>%1 のスコアは 0：望ましい影と望ましくない影が釣り合います</translation>
    </message>
    <message>
        <source>Weighted shade by month, m² h</source>
        <translation>月別の重み付き日陰、m² h</translation>
    </message>
    <message>
        <source>Weighted by time: %1.</source>
        <translation>時間による重み付け：%1。</translation>
    </message>
    <message>
        <source>Shadow area by month, m²</source>
        <translation>月別の日影面積, m²</translation>
    </message>
    <message>
        <source>minutes of sun a day, more than before</source>
        <translation>以前より増えた 1 日の日照の分数</translation>
    </message>
    <message>
        <source>Colours of maps; all but traffic-light are safe for colour-blind readers. Maps of sun by place take violet-orange unless another is named</source>
        <translation>地図の色。traffic-light 以外は色覚多様性に対応。場所別の日照の地図は、指定がなければ violet-orange を使います</translation>
    </message>
    <message>
        <source>Colours of changes</source>
        <translation>変化の色</translation>
    </message>
    <message>
        <source>Colours of differences and scores; all but green-red are safe for colour-blind readers</source>
        <translation>差と得点の色。green-red 以外は色覚多様性に対応</translation>
    </message>
    <message>
        <source>Changes reversed</source>
        <translation>変化の色を反転</translation>
    </message>
    <message>
        <source>Turn the colours of differences and scores round</source>
        <translation>差と得点の色を逆にします</translation>
    </message>
    <message>
        <source>Classes of changes</source>
        <translation>変化の区分</translation>
    </message>
    <message>
        <source>Classes of the legend of differences and scores, as of --classes; numbers in minutes of a difference: -30,-10,10,30</source>
        <translation>差と得点の凡例の区分（--classes と同じ）。数値は差の分数：-30,-10,10,30</translation>
    </message>
    <message>
        <source>%1 of sun a day, %2 of what is possible</source>
        <translation>1 日の日照 %1、可能な日照の %2</translation>
    </message>
    <message>
        <source>%1: %2 of sun a day, %3 of what is possible</source>
        <translation>%1：1 日の日照 %2、可能な日照の %3</translation>
    </message>
    <message>
        <source>%1 of the possible sun, %2 a day</source>
        <translation>可能な日照の %1、1 日 %2</translation>
    </message>
    <message>
        <source>%1: %2 of the possible sun, %3 a day</source>
        <translation>%1：可能な日照の %2、1 日 %3</translation>
    </message>
    <message>
        <source>sunlit time minus gross shadow per day, at the receiver that has most shadow</source>
        <translation>日照時間から 1 日の累計日影を引いたもの。影が最も多い測定点での値</translation>
    </message>
    <message>
        <source>Sunlit area</source>
        <translation>日照面積</translation>
    </message>
    <message>
        <source>sum over the receivers of (share of the sunlit time in the sun x cell area)</source>
        <translation>各測定点の（日照時間のうち日なたの割合 × セルの面積）の合計</translation>
    </message>
    <message>
        <source>Hours of sun a day of the places that change most</source>
        <translation>変化が最も大きい場所の 1 日の日照時間</translation>
    </message>
    <message>
        <source>places</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>First day</source>
        <translation>初日</translation>
    </message>
    <message>
        <source>From</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Time zone</source>
        <translation>タイムゾーン</translation>
    </message>
    <message>
        <source>Sun as seen through the air</source>
        <translation>大気を通して見た太陽</translation>
    </message>
    <message>
        <source>Less sun</source>
        <translation>日照の減少</translation>
    </message>
    <message>
        <source>area that lost more minutes of sun than the threshold</source>
        <translation>しきい値を超える分数の日照を失った面積</translation>
    </message>
    <message>
        <source>More sun</source>
        <translation>日照の増加</translation>
    </message>
    <message>
        <source>area that gained more minutes of sun than the threshold</source>
        <translation>しきい値を超える分数の日照を得た面積</translation>
    </message>
    <message>
        <source>Any less sun</source>
        <translation>日照の減少（すべて）</translation>
    </message>
    <message>
        <source>area that lost any sun</source>
        <translation>日照を少しでも失った面積</translation>
    </message>
    <message>
        <source>Any more sun</source>
        <translation>日照の増加（すべて）</translation>
    </message>
    <message>
        <source>area that gained any sun</source>
        <translation>日照を少しでも得た面積</translation>
    </message>
    <message>
        <source>Mean change of sun</source>
        <translation>日照の変化の平均</translation>
    </message>
    <message>
        <source>mean of the change of sun over the receivers; negative: less sun</source>
        <translation>測定点における日照の変化の平均。負は日照の減少</translation>
    </message>
    <message>
        <source>Largest loss of sun</source>
        <translation>日照の最大の減少</translation>
    </message>
    <message>
        <source>the most sun that a receiver loses</source>
        <translation>測定点が失う日照の最大</translation>
    </message>
    <message>
        <source>Largest gain of sun</source>
        <translation>日照の最大の増加</translation>
    </message>
    <message>
        <source>the most sun that a receiver gains</source>
        <translation>測定点が得る日照の最大</translation>
    </message>
    <message>
        <source>Change of the sunlit area</source>
        <translation>日照面積の変化</translation>
    </message>
    <message>
        <source>change of the sum over the receivers of (share of the sunlit time in the sun x cell area)</source>
        <translation>各測定点の（日照時間のうち日なたの割合 × セルの面積）の合計の変化</translation>
    </message>
    <message>
        <source>%1 changes no sun here</source>
        <translation>%1 はここの日照を変えません</translation>
    </message>
    <message>
        <source>Less sun on %1, more on %2; by more than %3 a day on %4 and %5.</source>
        <translation>日照の減少 %1、増加 %2。1 日 %3 を超えるのは %4 と %5。</translation>
    </message>
    <message>
        <source>Sunlit area by month, m²</source>
        <translation>月別の日照面積、m²</translation>
    </message>
    <message>
        <source>Cells of small places</source>
        <translation>小さな場所のセル</translation>
    </message>
    <message>
        <source>Size of the cells of places with fewer than 25 cells, m; no effect if it is not smaller than that of the others</source>
        <translation>25 セル未満の場所のセルの大きさ、m。ほかと同じかそれ以上なら同じ</translation>
    </message>
    <message>
        <source>Ray reference</source>
        <translation>レイ基準</translation>
    </message>
    <message>
        <source>One ray per receiver and step, traced by Embree: the reference for the errors of the others</source>
        <translation>測定点とステップごとに Embree で追跡するレイ 1 本: 他を測る基準</translation>
    </message>
    <message>
        <source>Projected shadows</source>
        <translation>投影した影</translation>
    </message>
    <message>
        <source>Each building&apos;s shadow filled as polygons at every step: exact and fast on flat ground</source>
        <translation>各ステップで各建物の影を多角形として塗る: 平らな地面で厳密かつ高速</translation>
    </message>
    <message>
        <source>Horizon sweep</source>
        <translation>地平線掃引</translation>
    </message>
    <message>
        <source>The slope of each receiver&apos;s horizon, azimuth by azimuth: a year takes seconds, on terrain and roofs too</source>
        <translation>各測定点の地平線の傾きを方位ごとに: 1 年も短時間、地形や屋根でも</translation>
    </message>
    <message>
        <source>Shadow accrual map</source>
        <translation>影累積マップ</translation>
    </message>
    <message>
        <source>A depth map of each step of an hour, drawn from a city placed once; hours that look alike computed once</source>
        <translation>1 時間の各ステップの深度マップを一度置いた都市から描く。似た時刻は 1 回だけ計算</translation>
    </message>
    <message>
        <source>Inverse accrual map</source>
        <translation>逆累積マップ</translation>
    </message>
    <message>
        <source>Occluders at both ends of each hour, their shadows moved along straight lines between; hours that look alike computed once</source>
        <translation>各時間の両端の遮蔽物を求め、その間は影を直線で動かす。似た時刻は 1 回だけ計算</translation>
    </message>
    <message>
        <source>Ray reference through the direction graph</source>
        <translation>方向グラフによるレイ基準</translation>
    </message>
    <message>
        <source>Rays, with hours that look alike traced once: what the graph alone does to the error</source>
        <translation>似た時刻を 1 回だけ追跡するレイ: グラフだけによる誤差</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Projected shadows, the horizon sweep or rays: the exact one where it is quick, and the result says which and why</source>
        <translation>投影した影、地平線掃引、レイのうち、短時間で済む所では厳密なもの。結果にどれか理由とともに示します</translation>
    </message>
    <message>
        <source>Shadow maps (OpenGL)</source>
        <translation>シャドウマップ (OpenGL)</translation>
    </message>
    <message>
        <source>Draws one depth map per step and tests every cell against it: the method that the paper compares accrual maps with</source>
        <translation>ステップごとに深度マップを描き全セルを調べる: 論文の比較対象の方法</translation>
    </message>
    <message>
        <source>Shadow accrual map (OpenGL)</source>
        <translation>影累積マップ (OpenGL)</translation>
    </message>
    <message>
        <source>One draw on the graphics device fills the depth maps of all steps of an hour</source>
        <translation>1 回の描画で 1 時間の全ステップの深度マップを作る</translation>
    </message>
    <message>
        <source>Error target</source>
        <translation>目標誤差</translation>
    </message>
    <message>
        <source>Target for the mean error of a cell&apos;s gross shadow, of the period. Halving it doubles the time of a run</source>
        <translation>セルの累計日影の平均誤差 (期間に対する割合): 方位の刻みはこれが許す幅になります。半分にすると時間は 2 倍</translation>
    </message>
    <message>
        <source>Azimuth bin</source>
        <translation>方位の刻み</translation>
    </message>
    <message>
        <source>Suns whose azimuth is less than this apart share one horizon; 0: as the error target asks</source>
        <translation>方位差がこれより小さい太陽は同じ地平線を使う。0: 目標誤差に従う</translation>
    </message>
    <message>
        <source>Continuous shadow</source>
        <translation>連続日影</translation>
    </message>
    <message>
        <source>The longest unbroken shadow is counted too; without it, gross shadow only, in about half the time</source>
        <translation>途切れない最長の影も数える。なしなら累計日影だけで約半分の時間</translation>
    </message>
    <message>
        <source>Check runs</source>
        <translation>連続の検査</translation>
    </message>
    <message>
        <source>Map size</source>
        <translation>マップの大きさ</translation>
    </message>
    <message>
        <source>Texels along a side of the depth map that is stretched over the region; no more than cells are used</source>
        <translation>範囲に広げる深度マップの一辺のテクセル数。セル数を超えない</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>バイアス</translation>
    </message>
    <message>
        <source>How high above the ground something must be to shade it</source>
        <translation>地面より何 m 高いと影を落とすとみなすか</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>区間</translation>
    </message>
    <message>
        <source>How long the sun is taken to move in a straight line</source>
        <translation>太陽が直線で動くとみなす時間</translation>
    </message>
    <message>
        <source>Direction bound</source>
        <translation>方向の許容差</translation>
    </message>
    <message>
        <source>Hours whose sun is less than this apart are computed once</source>
        <translation>太陽の差がこれより小さい時刻は 1 回だけ計算</translation>
    </message>
    <message>
        <source>Source levels</source>
        <translation>遮蔽物の段数</translation>
    </message>
    <message>
        <source>How many occluders, nearest first, are followed from each cell</source>
        <translation>各セルから近い順に追う遮蔽物の数</translation>
    </message>
    <message>
        <source>Sources by rays</source>
        <translation>レイで遮蔽物を探す</translation>
    </message>
    <message>
        <source>Embree finds the occluders at an interval&apos;s ends; otherwise filled polygons do, which is faster</source>
        <translation>区間の両端の遮蔽物を Embree で探す。なしなら多角形の塗りで、より速い</translation>
    </message>
    <message>
        <source>Nearest hit</source>
        <translation>最短の命中</translation>
    </message>
    <message>
        <source>Occluders nearer to a cell than this are left out (the paper: 1 m)</source>
        <translation>これよりセルに近い遮蔽物は除く (論文: 1 m)</translation>
    </message>
    <message>
        <source>OpenCL device</source>
        <translation>OpenCL デバイス</translation>
    </message>
    <message>
        <source>Which OpenCL device draws, counted from 0; -1: the processor itself</source>
        <translation>描画する OpenCL デバイス (0 から数える)。-1: プロセッサ</translation>
    </message>
    <message>
        <source>Rays look at every step of every longest run, so that a gap between two walls in one line is found too; without it, they look at what neighbouring bins leave in doubt</source>
        <translation>光線は最長の連続時間のすべてのステップを調べるため、一直線に並ぶ二つの壁の隙間も見つかります。使わない場合は、隣り合う方位で判定できない部分だけを調べます</translation>
    </message>
    <message>
        <source>Gross shadow</source>
        <translation>累計日影</translation>
    </message>
    <message>
        <source>minutes in shadow a day</source>
        <translation>1 日の日影の分</translation>
    </message>
    <message>
        <source>longest run, minutes</source>
        <translation>最長連続、分</translation>
    </message>
    <message>
        <source>Change of gross shadow</source>
        <translation>累計日影の変化</translation>
    </message>
    <message>
        <source>Change of continuous shadow</source>
        <translation>連続日影の変化</translation>
    </message>
    <message>
        <source>min a day</source>
        <translation>分/日</translation>
    </message>
    <message>
        <source>min</source>
        <translation>分</translation>
    </message>
    <message>
        <source>scale fitted to this difference</source>
        <translation>この差分に合わせた目盛</translation>
    </message>
    <message>
        <source>Shadow score</source>
        <translation>日影スコア</translation>
    </message>
    <message>
        <source>weight × share of time</source>
        <translation>重み × 時間の割合</translation>
    </message>
    <message>
        <source>built over</source>
        <translation>建物になった</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>日影</translation>
    </message>
    <message>
        <source>at this moment</source>
        <translation>この時刻</translation>
    </message>
    <message>
        <source>scale locked: %1</source>
        <translation>目盛固定: %1</translation>
    </message>
    <message>
        <source>largest %1</source>
        <translation>最大 %1</translation>
    </message>
    <message>
        <source>Verdicts on windows</source>
        <translation>窓の判定</translation>
    </message>
    <message>
        <source>before</source>
        <translation>前</translation>
    </message>
    <message>
        <source>after</source>
        <translation>後</translation>
    </message>
    <message>
        <source>Change of verdicts</source>
        <translation>判定の変化</translation>
    </message>
    <message>
        <source>from before to after</source>
        <translation>前から後へ</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>適合</translation>
    </message>
    <message>
        <source>borderline</source>
        <translation>境界</translation>
    </message>
    <message>
        <source>fail</source>
        <translation>不適合</translation>
    </message>
    <message>
        <source>not applicable</source>
        <translation>対象外</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>悪化</translation>
    </message>
    <message>
        <source>better</source>
        <translation>改善</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>変化なし</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>比較なし</translation>
    </message>
    <message>
        <source>Share of the sunlit time</source>
        <translation>可照時間に占める割合</translation>
    </message>
    <message>
        <source>% in the sun</source>
        <translation>% 日なた</translation>
    </message>
    <message>
        <source>Change of sun</source>
        <translation>日照の変化</translation>
    </message>
    <message>
        <source>CityGML, CityJSON: level of detail (default: the highest)</source>
        <translation>CityGML、CityJSON：詳細度（既定：最も高いもの）</translation>
    </message>
    <message>
        <source>%1, with 99 % certainty within %2</source>
        <translation>%1、99 % の確からしさで %2 以内</translation>
    </message>
    <message>
        <source>%1 in the mean, 99 of 100 within %2, at most %3</source>
        <translation>平均 %1、100 のうち 99 は %2 以内、最大 %3</translation>
    </message>
    <message>
        <source>%1 takes more than a minute of sun a day from %2 places, at most %3 at one spot.</source>
        <translation>%1 は %2 か所で 1 日 1 分を超える日照を奪い、1 地点では最大 %3 です。</translation>
    </message>
    <message>
        <source>Floor plate</source>
        <translation>基準階面積</translation>
    </message>
    <message>
        <source>Gross floor area</source>
        <translation>延べ面積</translation>
    </message>
    <message>
        <source>Floor area ratio (FAR)</source>
        <translation>容積率</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>調整</translation>
    </message>
    <message>
        <source>Verdicts on places</source>
        <translation>場所の判定</translation>
    </message>
    <message>
        <source>Review of windows</source>
        <translation>窓の審査</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>審査</translation>
    </message>
    <message>
        <source>Inventories of trees</source>
        <translation>樹木台帳</translation>
    </message>
    <message>
        <source>File with trees beside those of the city&apos;s files: points or a table with species, height, crown or stem; may be repeated</source>
        <translation>都市ファイルの樹木に加える樹木のファイル: 点、または樹種・高さ・樹冠・幹の表。複数指定できます</translation>
    </message>
    <message>
        <source>Change of the minutes of sun a day by month</source>
        <translation>月別の 1 日の日照の分数の変化</translation>
    </message>
    <message>
        <source>Change of the minutes of sun a day of these places</source>
        <translation>これらの場所の 1 日の日照の分数の変化</translation>
    </message>
    <message>
        <source>%1 and %2 take the same sun: %3 a day on average over the places.</source>
        <translation>%1 と %2 が減らす日照は同じです: 場所の平均で 1 日 %3。</translation>
    </message>
    <message>
        <source>%1 takes less sun than %2: %3 against %4 a day on average over the places.</source>
        <translation>%1 が奪う日照は %2 より少なくなります：場所の平均で 1 日、前者は %3、後者は %4 です。</translation>
    </message>
    <message>
        <source>On %1 it has %2; %3 of its area has less than %4.</source>
        <translation>%1 の日照は %2。面積の %3 が %4 未満です。</translation>
    </message>
    <message>
        <source>%1 gives it %2 of sun a day, at most %3 at one spot.</source>
        <translation>%1 はこの場所の日照を 1 日 %2、最大の地点で %3 増やします。</translation>
    </message>
    <message>
        <source>%1 takes %2 of sun a day from it, at most %3 at one spot.</source>
        <translation>%1 はこの場所の日照を 1 日 %2、最大の地点で %3 減らします。</translation>
    </message>
    <message>
        <source>%1 of %2 places fail %3 in %4</source>
        <translation>%4 では %2 か所中 %1 か所が %3 に不適合</translation>
    </message>
    <message>
        <source>No place fails %3 in %4, but %1 of %2 are borderline</source>
        <translation>%4 では %3 に不適合の場所はないが、%2 か所中 %1 か所が境界</translation>
    </message>
    <message>
        <source>All of the %2 places judged pass %3 in %4</source>
        <translation>%4 では判定した %2 か所すべてが %3 に適合</translation>
    </message>
    <message>
        <source>%3 judges none of the places in %4</source>
        <translation>%4 では %3 が判定する場所なし</translation>
    </message>
    <message>
        <source>%1 of %2 windows fail %3 in %4</source>
        <translation>%4 では %2 個中 %1 個の窓が %3 に不適合</translation>
    </message>
    <message>
        <source>No window fails %3 in %4, but %1 of %2 are borderline</source>
        <translation>%4 では %3 に不適合の窓はないが、%2 個中 %1 個が境界</translation>
    </message>
    <message>
        <source>All of the %2 windows judged pass %3 in %4</source>
        <translation>%4 では判定した %2 個の窓すべてが %3 に適合</translation>
    </message>
    <message>
        <source>%3 judges none of the windows in %4</source>
        <translation>%4 では %3 が判定する窓なし</translation>
    </message>
    <message>
        <source>Places that fail</source>
        <translation>不適合の場所</translation>
    </message>
    <message>
        <source>a limit of the rule is exceeded by more than the error of what was measured</source>
        <translation>規定の限度を測定の誤差より大きく超えています</translation>
    </message>
    <message>
        <source>Borderline places</source>
        <translation>境界の場所</translation>
    </message>
    <message>
        <source>within the error of a limit of the rule</source>
        <translation>規定の限度の誤差の範囲内</translation>
    </message>
    <message>
        <source>Places that pass</source>
        <translation>適合の場所</translation>
    </message>
    <message>
        <source>they keep all limits of the rule</source>
        <translation>規定の限度をすべて守っています</translation>
    </message>
    <message>
        <source>Places without a limit</source>
        <translation>限度のない場所</translation>
    </message>
    <message>
        <source>the rule does not cover them, or states figures only</source>
        <translation>規定の対象外、または数値のみを示す規定</translation>
    </message>
    <message>
        <source>Places not checked</source>
        <translation>未確認の場所</translation>
    </message>
    <message>
        <source>nothing could be measured there</source>
        <translation>何も測定できませんでした</translation>
    </message>
    <message>
        <source>Windows that fail</source>
        <translation>不適合の窓</translation>
    </message>
    <message>
        <source>in the scenario; rooms or dwellings where the rule judges those</source>
        <translation>シナリオでの数。規定が部屋や住戸を判定する場合はその数</translation>
    </message>
    <message>
        <source>Borderline windows</source>
        <translation>境界の窓</translation>
    </message>
    <message>
        <source>Windows that pass</source>
        <translation>適合の窓</translation>
    </message>
    <message>
        <source>Windows not judged</source>
        <translation>判定していない窓</translation>
    </message>
    <message>
        <source>the rule does not apply to them, or they were not checked</source>
        <translation>規定の対象外、または未確認</translation>
    </message>
    <message>
        <source>Windows that failed before</source>
        <translation>以前に不適合だった窓</translation>
    </message>
    <message>
        <source>in the baseline, of those that stand in both</source>
        <translation>比較基準で、両方にあるもののうちの数</translation>
    </message>
    <message>
        <source>Windows that get worse</source>
        <translation>悪化する窓</translation>
    </message>
    <message>
        <source>from pass to borderline or fail, or from borderline to fail</source>
        <translation>適合から境界または不適合へ、あるいは境界から不適合へ</translation>
    </message>
    <message>
        <source>Windows that get better</source>
        <translation>改善する窓</translation>
    </message>
    <message>
        <source>from fail to borderline or pass, or from borderline to pass</source>
        <translation>不適合から境界または適合へ、あるいは境界から適合へ</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2。</translation>
    </message>
    <message>
        <source>%1 more places fail or are borderline.</source>
        <translation>ほかに %1 か所が不適合または境界です。</translation>
    </message>
    <message>
        <source>%1 windows get worse than in %2, %3 get better.</source>
        <translation>%2 より悪化する窓は %1 個、改善する窓は %3 個です。</translation>
    </message>
    <message>
        <source>Shade of trees</source>
        <translation>樹木の影</translation>
    </message>
    <message>
        <source>What is measured beside the shadow without trees, where the city has some: without, evergreen, seasonal or all (default)</source>
        <translation>都市に樹木がある場合、樹木なしの影のほかに測るもの: なし、常緑、季節、すべて (既定)</translation>
    </message>
    <message>
        <source>After sunrise</source>
        <translation>日の出後</translation>
    </message>
    <message>
        <source>Before sunset</source>
        <translation>日没前</translation>
    </message>
    <message>
        <source>Sunrise at</source>
        <translation>日の出の定義</translation>
    </message>
    <message>
        <source>Which moment counts as sunrise and sunset: the altitude of the sun&apos;s centre</source>
        <translation>日の出・日没とみなす時点: 太陽中心の高度</translation>
    </message>
    <message>
        <source>repaired</source>
        <translation>修復</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>切り取り</translation>
    </message>
    <message>
        <source>dropped</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>仮定</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>実測</translation>
    </message>
    <message>
        <source>from storeys</source>
        <translation>階数から</translation>
    </message>
    <message>
        <source>of a 3D model</source>
        <translation>3D モデルから</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>設計値</translation>
    </message>
    <message>
        <source>made up</source>
        <translation>架空</translation>
    </message>
    <message>
        <source>has no area, so it casts no shadow</source>
        <translation>面積がないため影を落としません</translation>
    </message>
    <message>
        <source>faces without area were left out</source>
        <translation>面積のない面を除外しました</translation>
    </message>
    <message>
        <source>its surface is not closed; it is used unchanged</source>
        <translation>表面が閉じていません。そのまま使います</translation>
    </message>
    <message>
        <source>its faces pointed inward and were turned</source>
        <translation>面が内側を向いていたため反転しました</translation>
    </message>
    <message>
        <source>its outline could not be determined</source>
        <translation>外形を求められませんでした</translation>
    </message>
    <message>
        <source>Choose the horizon sweep</source>
        <translation>地平線掃引を選んでください</translation>
    </message>
    <message>
        <source>Choose projected shadows, or rays on terrain and roofs</source>
        <translation>投影した影を、地形や屋根ではレイを選んでください</translation>
    </message>
    <message>
        <source>Choose the horizon sweep or the ray reference</source>
        <translation>地平線掃引またはレイ基準を選んでください</translation>
    </message>
    <message>
        <source>Choose a step of 3 seconds or more</source>
        <translation>3 秒以上のステップを選んでください</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>none: the processor</source>
        <translation>なし: プロセッサ</translation>
    </message>
    <message>
        <source>the coordinates are read as longitude or easting first</source>
        <translation>座標は経度または東距を先として読み込みます</translation>
    </message>
    <message>
        <source>far from the middle of the data</source>
        <translation>データの中心から遠く離れています</translation>
    </message>
    <message>
        <source>one of several polygon layers; all are read as buildings</source>
        <translation>複数あるポリゴンレイヤーの一つ。すべて建物として読み込みます</translation>
    </message>
    <message>
        <source>is not tagged as a building</source>
        <translation>建物のタグがありません</translation>
    </message>
    <message>
        <source>lies underground</source>
        <translation>地下にあります</translation>
    </message>
    <message>
        <source>its roof is not flat; it is drawn flat at its full height</source>
        <translation>屋根が平らではありません。全高で平らに描きます</translation>
    </message>
    <message>
        <source>its polygons overlapped or shared a wall and were joined</source>
        <translation>ポリゴンが重なるか壁を共有していたため結合しました</translation>
    </message>
    <message>
        <source>No file is named</source>
        <translation>ファイルが指定されていません</translation>
    </message>
    <message>
        <source>Name at least one file with buildings</source>
        <translation>建物のあるファイルを一つ以上指定してください</translation>
    </message>
    <message>
        <source>None of the files states its position on earth</source>
        <translation>地球上の位置が示されたファイルがありません</translation>
    </message>
    <message>
        <source>there is no terrain: the ground between the buildings was interpolated from their bases</source>
        <translation>地形がありません: 建物の間の地面は基部から補間しました</translation>
    </message>
    <message>
        <source>buildings beyond the terrain stand on its nearest elevation</source>
        <translation>地形の範囲外の建物は最も近い標高に載せます</translation>
    </message>
    <message>
        <source>The file holds no polygon with an area</source>
        <translation>ファイルに面積のある多角形がありません</translation>
    </message>
    <message>
        <source>Draw the region as a polygon</source>
        <translation>範囲を多角形で描いてください</translation>
    </message>
    <message>
        <source>It is not a polygon in well-known text</source>
        <translation>Well-known text の多角形ではありません</translation>
    </message>
    <message>
        <source>Give degrees, longitude first: POLYGON ((-73.98 40.76, -73.97 40.76, -73.97 40.77, -73.98 40.76))</source>
        <translation>経度を先に、度で指定してください: POLYGON ((-73.98 40.76, -73.97 40.76, -73.97 40.77, -73.98 40.76))</translation>
    </message>
    <message>
        <source>The polygon has no area</source>
        <translation>多角形に面積がありません</translation>
    </message>
    <message>
        <source>Give at least three corners</source>
        <translation>三つ以上の角を指定してください</translation>
    </message>
    <message>
        <source>There is no such file, and the text is neither four numbers nor a polygon</source>
        <translation>そのようなファイルはなく、文字列は四つの数値でも多角形でもありません</translation>
    </message>
    <message>
        <source>Give west,south,east,north in degrees, for example -73.99,40.75,-73.98,40.76, a polygon as well-known text, or a polygon file</source>
        <translation>西,南,東,北を度で (例: -73.99,40.75,-73.98,40.76)、または well-known text の多角形かポリゴンのファイルを指定してください</translation>
    </message>
    <message>
        <source>Names field</source>
        <translation>名称の項目</translation>
    </message>
    <message>
        <source>Field with the names of the buildings (default: found by its name)</source>
        <translation>建物の名称のフィールド（既定：名前から判定）</translation>
    </message>
    <message>
        <source>terrain far from the city was left out</source>
        <translation>都市から遠い地形を除外しました</translation>
    </message>
    <message>
        <source>cells without elevation were filled from the cells around</source>
        <translation>標高のないセルを周囲のセルから補いました</translation>
    </message>
    <message>
        <source>a tree far from the buildings</source>
        <translation>建物から遠い樹木</translation>
    </message>
    <message>
        <source>a second tree at the same place</source>
        <translation>同じ位置の二本目の樹木</translation>
    </message>
    <message>
        <source>Choose 0.25 to 10 m</source>
        <translation>0.25～10 m を選んでください</translation>
    </message>
    <message>
        <source>The region has no area</source>
        <translation>範囲に面積がありません</translation>
    </message>
    <message>
        <source>Draw a polygon with an interior</source>
        <translation>内部のある多角形を描いてください</translation>
    </message>
    <message>
        <source>Choose larger cells or a smaller region; the limit is 2.1 billion cells</source>
        <translation>セルを大きくするか範囲を小さくしてください。上限は 21 億セルです</translation>
    </message>
    <message>
        <source>A corner is not on the globe</source>
        <translation>地球上にない角があります</translation>
    </message>
    <message>
        <source>Give degrees: west,south,east,north</source>
        <translation>度で指定してください: 西,南,東,北</translation>
    </message>
    <message>
        <source>The box is empty</source>
        <translation>長方形が空です</translation>
    </message>
    <message>
        <source>Give west &lt; east (or west &gt; east across the 180th meridian) and south &lt; north</source>
        <translation>西 &lt; 東 (180 度経線をまたぐときは 西 &gt; 東)、南 &lt; 北 で指定してください</translation>
    </message>
    <message>
        <source>This is measured on the ground only, not on roofs</source>
        <translation>これは地面でのみ測り、屋根では測りません</translation>
    </message>
    <message>
        <source>Choose the ground, or run a study of the roofs</source>
        <translation>地面を選ぶか、屋根の検討を計算してください</translation>
    </message>
    <message>
        <source>On average over their area %1 a day, of %2 without any shadow.</source>
        <translation>面積平均で 1 日 %1、影がまったくない場合は %2 です。</translation>
    </message>
    <message>
        <source>Choose larger cells, a smaller region or fewer steps</source>
        <translation>セルを大きく、範囲を小さく、またはステップを少なくしてください</translation>
    </message>
    <message>
        <source>No cell of the region lies on a roof</source>
        <translation>範囲内に屋根の上のセルがありません</translation>
    </message>
    <message>
        <source>Choose a region with buildings, or smaller cells</source>
        <translation>建物のある範囲を選ぶか、セルを小さくしてください</translation>
    </message>
    <message>
        <source>No cell of the region lies on open ground</source>
        <translation>範囲内に空地のセルがありません</translation>
    </message>
    <message>
        <source>Choose a region outside buildings and water, or smaller cells</source>
        <translation>建物と水面の外の範囲を選ぶか、セルを小さくしてください</translation>
    </message>
    <message>
        <source>The start is not a date of the calendar</source>
        <translation>開始日が暦にない日付です</translation>
    </message>
    <message>
        <source>Give a date such as 2026-03-21</source>
        <translation>2026-03-21 のように日付を指定してください</translation>
    </message>
    <message>
        <source>Choose other dates; the position of the sun is known for these years only</source>
        <translation>別の日付を選んでください。太陽位置がわかるのはこれらの年だけです</translation>
    </message>
    <message>
        <source>The time of day at which the hours begin is out of range</source>
        <translation>時間帯の開始時刻が範囲外です</translation>
    </message>
    <message>
        <source>Give 00:00 to 24:00</source>
        <translation>00:00～24:00 を指定してください</translation>
    </message>
    <message>
        <source>Give 0 (one instant), or 0.00028 to 24</source>
        <translation>0 (一瞬)、または 0.00028～24 を指定してください</translation>
    </message>
    <message>
        <source>The hours after sunrise or before sunset are out of range</source>
        <translation>日の出後または日没前の時間数が範囲外です</translation>
    </message>
    <message>
        <source>Give at most 12 hours on either side</source>
        <translation>どちらも 12 時間以下を指定してください</translation>
    </message>
    <message>
        <source>Choose a longer step or fewer days; the limit is 50 million steps</source>
        <translation>ステップを長くするか日数を減らしてください。上限は 5000 万ステップです</translation>
    </message>
    <message>
        <source>The sun is below the horizon all the time</source>
        <translation>太陽はずっと地平線の下です</translation>
    </message>
    <message>
        <source>Choose other hours or days</source>
        <translation>別の時間帯または日を選んでください</translation>
    </message>
    <message>
        <source>%1 takes sun from %2, at most %3 a day at one spot</source>
        <translation>%1 は %2 の範囲で日照を、最大の地点で 1 日 %3 減らします</translation>
    </message>
    <message>
        <source>%1 gives sun to %2, at most %3 a day at one spot</source>
        <translation>%1 は %2 の範囲で日照を、最大の地点で 1 日 %3 増やします</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>Between the pieces of the lot of several towers</source>
        <translation>複数のタワーで分けた敷地の各部分の間</translation>
    </message>
    <message>
        <source>Further towers</source>
        <translation>追加のタワー</translation>
    </message>
    <message>
        <source>%1 everywhere</source>
        <translation>どこでも %1</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>最大 %1</translation>
    </message>
    <message>
        <source>On %1, %2 of %3 places have less than %4.</source>
        <translation>%1 は %3 か所中 %2 か所が %4 未満です。</translation>
    </message>
    <message>
        <source>%1 has the least sun, %2 a day, and %3 the most, %4.</source>
        <translation>日照が最も少ないのは %1 の 1 日 %2、最も多いのは %3 の %4 です。</translation>
    </message>
    <message>
        <source>%1: no open ground was measured</source>
        <translation>%1：測定できる空地がありませんでした</translation>
    </message>
    <message>
        <source>%1: %2 of sun a day; %3 of its area has %4 or more</source>
        <translation>%1：日照は 1 日 %2。面積の %3 が %4 以上</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>樹種</translation>
    </message>
    <message>
        <source>Latin name; its genus decides shape, density and leaves</source>
        <translation>学名。属によって形、密度、葉が決まります</translation>
    </message>
    <message>
        <source>Height above the ground, m</source>
        <translation>地上からの高さ、m</translation>
    </message>
    <message>
        <source>estimated from crown or stem</source>
        <translation>樹冠または幹から推定</translation>
    </message>
    <message>
        <source>Crown diameter</source>
        <translation>樹冠直径</translation>
    </message>
    <message>
        <source>Diameter of the crown, m</source>
        <translation>樹冠の直径、m</translation>
    </message>
    <message>
        <source>estimated from stem or height</source>
        <translation>幹または高さから推定</translation>
    </message>
    <message>
        <source>Crown base</source>
        <translation>枝下高</translation>
    </message>
    <message>
        <source>Height of the crown&apos;s lower end above the ground, m</source>
        <translation>地上から樹冠下端までの高さ、m</translation>
    </message>
    <message>
        <source>a share of the height</source>
        <translation>高さに対する割合</translation>
    </message>
    <message>
        <source>Stem diameter</source>
        <translation>幹の直径</translation>
    </message>
    <message>
        <source>Diameter of the stem at breast height, m</source>
        <translation>胸高での幹の直径、m</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>With trees as evergreens it is %1 a day.</source>
        <translation>樹木を常緑とすると 1 日 %1 です。</translation>
    </message>
    <message>
        <source>With trees that lose their leaves by season it is %1 a day.</source>
        <translation>季節に葉を落とす樹木では 1 日 %1 です。</translation>
    </message>
    <message>
        <source>With trees as evergreens: %1; %2 of its area has %3 or more.</source>
        <translation>樹木を常緑とした場合: %1。面積の %2 が %3 以上です。</translation>
    </message>
    <message>
        <source>With trees that lose their leaves by season: %1; %2 of its area has %3 or more.</source>
        <translation>季節に葉を落とす樹木の場合: %1。面積の %2 が %3 以上です。</translation>
    </message>
    <message>
        <source>%1 of %2 places lie in shadow for more than %3 a day</source>
        <translation>%2 か所のうち %1 か所が 1 日 %3 を超えて影になります</translation>
    </message>
    <message>
        <source>%1 has the most shadow, %2 a day, and %3 the least, %4.</source>
        <translation>影が最も多いのは %1 (1 日 %2)、最も少ないのは %3 (%4) です。</translation>
    </message>
    <message>
        <source>On average over their area %1 of shadow a day, of %2 of daylight.</source>
        <translation>面積の平均で 1 日 %1 の影 (昼間 %2 のうち)。</translation>
    </message>
    <message>
        <source>%1 adds more than a minute of shadow a day to %2 places, at most %3 at one spot.</source>
        <translation>%1 は %2 か所に 1 日 1 分を超える影を加え、最大は一地点で %3 です。</translation>
    </message>
    <message>
        <source>Minutes of shadow a day by month</source>
        <translation>月ごとの 1 日の影 (分)</translation>
    </message>
    <message>
        <source>%1 reduces its shadow by %2 a day, at most %3 at one spot.</source>
        <translation>%1 により影は 1 日 %2 減り、最大は一地点で %3 です。</translation>
    </message>
    <message>
        <source>%1 adds %2 of shadow a day to it, at most %3 at one spot.</source>
        <translation>%1 により影は 1 日 %2 増え、最大は一地点で %3 です。</translation>
    </message>
    <message>
        <source>Thresholds of the change</source>
        <translation>変化のしきい値</translation>
    </message>
    <message>
        <source>Minutes of more or less shadow a day above which area counts; one or more</source>
        <translation>面積に数える 1 日の影の増減 (分)。1 つ以上</translation>
    </message>
    <message>
        <source>Each new building</source>
        <translation>新しい建物ごと</translation>
    </message>
    <message>
        <source>Also measure the sole contribution of each new building</source>
        <translation>新しい建物それぞれの単独の寄与も測ります</translation>
    </message>
    <message>
        <source>Tolerance of buildings from a surface model</source>
        <translation>表面モデルから作る建物の許容誤差</translation>
    </message>
    <message>
        <source>How far buildings that are made of a surface model may lie above or below its cells, 0.05 to 5 m</source>
        <translation>表面モデルから作る建物がそのセルから上下に離れてよい距離、0.05~5 m</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>Read only the buildings that touch this box, degrees; terrain is read whole</source>
        <translation>この範囲 (度) に触れる建物だけを読む。地形は全体を読む</translation>
    </message>
    <message>
        <source>On %1, %2 of %3 places lie in shadow for more than %4.</source>
        <translation>%1 には %3 か所のうち %2 か所が %4 を超えて影になる。</translation>
    </message>
    <message>
        <source>Change of the minutes of shadow a day by month</source>
        <translation>月別の 1 日の影の分数の変化</translation>
    </message>
    <message>
        <source>Minutes of shadow a day of the places that change most</source>
        <translation>変化が最も大きい場所の 1 日の影の分数</translation>
    </message>
    <message>
        <source>Change of the minutes of shadow a day of these places</source>
        <translation>これらの場所の 1 日の影の分数の変化</translation>
    </message>
    <message>
        <source>%1: %2 of shadow a day; %3 of its area has %4 or less</source>
        <translation>%1: 影は 1 日 %2。面積の %3 は %4 以下</translation>
    </message>
    <message>
        <source>With trees as evergreens: %1; %2 of its area has %3 or less.</source>
        <translation>木を常緑とした場合: %1。面積の %2 は %3 以下。</translation>
    </message>
    <message>
        <source>With trees that lose their leaves by season: %1; %2 of its area has %3 or less.</source>
        <translation>季節で葉を落とす木の場合: %1。面積の %2 は %3 以下。</translation>
    </message>
    <message>
        <source>On %1 it lies in shadow for %2; %3 of its area for more than %4.</source>
        <translation>%1 には %2 影になる。面積の %3 は %4 を超える。</translation>
    </message>
    <message>
        <source>The measured hours begin this many hours after sunrise</source>
        <translation>測定する時間は日の出からこの時間後に始まる</translation>
    </message>
    <message>
        <source>The measured hours end this many hours before sunset</source>
        <translation>測定する時間は日の入りのこの時間前に終わる</translation>
    </message>
    <message>
        <source>minutes of shadow a day, mean over the days and the place</source>
        <translation>1 日の影の分数。日数と場所での平均</translation>
    </message>
    <message>
        <source>Max shadow</source>
        <translation>最大の影</translation>
    </message>
    <message>
        <source>minutes of shadow a day, mean over the days, at the cell that has most</source>
        <translation>1 日の影の分数。日数の平均、最も多いセル</translation>
    </message>
    <message>
        <source>Min shadow</source>
        <translation>最小の影</translation>
    </message>
    <message>
        <source>minutes of shadow a day, mean over the days, at the cell that has least</source>
        <translation>1 日の影の分数。日数の平均、最も少ないセル</translation>
    </message>
    <message>
        <source>a tree far from the buildings: its longitude and latitude are swapped</source>
        <translation>建物から遠い樹木: 経度と緯度が入れ替わっています</translation>
    </message>
    <message>
        <source>Trees are not included.</source>
        <translation>樹木は含みません。</translation>
    </message>
    <message>
        <source>This is with trees as evergreens.</source>
        <translation>樹木を常緑として含みます。</translation>
    </message>
    <message>
        <source>This is with trees by their seasons.</source>
        <translation>樹木を季節に応じて含みます。</translation>
    </message>
    <message>
        <source>Trees on maps</source>
        <translation>地図の樹木</translation>
    </message>
    <message>
        <source>With trees as evergreens their number is %1, at most %2 at one spot.</source>
        <translation>樹木を常緑とすると %1、一点で最大 %2。</translation>
    </message>
    <message>
        <source>With trees that lose their leaves by season their number is %1, at most %2 at one spot.</source>
        <translation>季節で葉を落とす樹木を含めると %1、一点で最大 %2。</translation>
    </message>
    <message>
        <source>Scale of diagrams</source>
        <translation>図の縮尺</translation>
    </message>
    <message>
        <source>Scale of diagrams and elevations: 2000 for 1:2000 (default: a round one that fits)</source>
        <translation>図と立面図の縮尺: 1:2000 は 2000(既定値: 収まる切りのよい縮尺)</translation>
    </message>
    <message>
        <source>Everything in full</source>
        <translation>すべてを完全に</translation>
    </message>
    <message>
        <source>Sheets: all tables, maps, elevations and timelines in full, on as many pages as that takes (default: at most 30 pages, with what changes most and what fails or is borderline)</source>
        <translation>シート: すべての表、地図、立面図、時間経過を必要なだけのページに(既定値: 最大 30 ページ。変化が大きいもの、不適合または境界のもの)</translation>
    </message>
    <message>
        <source>Map of sources of heights</source>
        <translation>高さの出典の地図</translation>
    </message>
    <message>
        <source>Sheets: a page with the buildings coloured by where their heights come from: measured, from storeys, assumed, of a 3D model, designed</source>
        <translation>シート: 建物を高さの出典で色分けしたページ(測定、階数から、仮定、3D モデル、設計)</translation>
    </message>
    <message>
        <source>Smallest place</source>
        <translation>最小の場所</translation>
    </message>
    <message>
        <source>Sheets of places: smaller places without a name are listed together, under the place that they lie in or by kind</source>
        <translation>場所のシート: 名前のない小さな場所は、含まれる場所の下または種類別にまとめます</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>用紙</translation>
    </message>
    <message>
        <source>Paper of the sheets: A4, A3, A1, Letter or Tabloid</source>
        <translation>シートの用紙: A4、A3、A1、Letter、Tabloid</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>横向き</translation>
    </message>
    <message>
        <source>Sheets are wider than high</source>
        <translation>シートを横長にします</translation>
    </message>
    <message>
        <source>Hours of sun a day by month</source>
        <translation>月別の 1 日の日照時間</translation>
    </message>
    <message>
        <source>Change of the hours of sun a day by month</source>
        <translation>月別の 1 日の日照時間の変化</translation>
    </message>
    <message>
        <source>Hours of sun a day in the places by month</source>
        <translation>場所における月別の 1 日の日照時間</translation>
    </message>
    <message>
        <source>Change of the hours of sun a day in the places by month</source>
        <translation>場所における月別の 1 日の日照時間の変化</translation>
    </message>
    <message>
        <source>Change of the shadow area by month, m²</source>
        <translation>月別の日陰面積の変化、m²</translation>
    </message>
    <message>
        <source>Change of the weighted shade by month, m² h</source>
        <translation>月別の加重日陰の変化、m²·h</translation>
    </message>
    <message>
        <source>Shadow score by month, m²</source>
        <translation>月別の日陰スコア、m²</translation>
    </message>
    <message>
        <source>Change of the shadow score by month, m²</source>
        <translation>月別の日陰スコアの変化、m²</translation>
    </message>
    <message>
        <source>duplicates</source>
        <translation>重複</translation>
    </message>
    <message>
        <source>Sun by place in %1</source>
        <translation>%1 の場所別の日照</translation>
    </message>
    <message>
        <source>Sun by place in %1 compared with %2</source>
        <translation>%1 と %2 の場所別の日照の比較</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 と %2 の比較</translation>
    </message>
    <message>
        <source>Score of %1 with %2</source>
        <translation>%1 のスコア (%2)</translation>
    </message>
    <message>
        <source>Study of %1</source>
        <translation>%1 の検討</translation>
    </message>
    <message>
        <source>Points of %1</source>
        <translation>%1の点</translation>
    </message>
    <message>
        <source>drawing diagrams</source>
        <translation>図を描いています</translation>
    </message>
    <message>
        <source>drawing shadow fans</source>
        <translation>影の扇を描いています</translation>
    </message>
    <message>
        <source>drawing lines of equal hours</source>
        <translation>等時間線を描いています</translation>
    </message>
    <message>
        <source>drawing views from the sun</source>
        <translation>太陽からの眺めを描いています</translation>
    </message>
    <message>
        <source>sweeping horizons</source>
        <translation>地平線を走査しています</translation>
    </message>
    <message>
        <source>sweeping horizons of points</source>
        <translation>点の地平線を走査しています</translation>
    </message>
    <message>
        <source>tracing rays from points</source>
        <translation>点から光線を追跡しています</translation>
    </message>
    <message>
        <source>finding buildings in reach of the places</source>
        <translation>場所に届く建物を探しています</translation>
    </message>
    <message>
        <source>filling shadows</source>
        <translation>影を塗っています</translation>
    </message>
    <message>
        <source>building the ray scene</source>
        <translation>光線の準備をしています</translation>
    </message>
    <message>
        <source>tracing rays</source>
        <translation>光線を追跡しています</translation>
    </message>
    <message>
        <source>tracing rays through single trees</source>
        <translation>単木を通る光線を追跡しています</translation>
    </message>
    <message>
        <source>unpacking the archive</source>
        <translation>アーカイブを展開しています</translation>
    </message>
    <message>
        <source>making the buildings</source>
        <translation>建物を作成しています</translation>
    </message>
    <message>
        <source>reading the features</source>
        <translation>地物を読み込んでいます</translation>
    </message>
    <message>
        <source>reading the city</source>
        <translation>都市を読み込んでいます</translation>
    </message>
    <message>
        <source>reading the map</source>
        <translation>地図を読み込んでいます</translation>
    </message>
    <message>
        <source>reading windows</source>
        <translation>窓を読み込んでいます</translation>
    </message>
    <message>
        <source>repairing outlines</source>
        <translation>輪郭を修復しています</translation>
    </message>
    <message>
        <source>making buildings</source>
        <translation>建物を作成しています</translation>
    </message>
    <message>
        <source>they stand where the file states</source>
        <translation>ファイルに記載の位置にあります</translation>
    </message>
    <message>
        <source>all were shifted onto it</source>
        <translation>すべて地形上に移動しました</translation>
    </message>
    <message>
        <source>each building was set down on it</source>
        <translation>各建物を地形上に置きました</translation>
    </message>
    <message>
        <source>bases of %1 lie %2 m below the terrain (median of %3, spread %4 m)</source>
        <translation>%1の基部は地形より%2 m低い（%3棟の中央値、ばらつき%4 m）</translation>
    </message>
    <message>
        <source>bases of %1 lie %2 m above the terrain (median of %3, spread %4 m)</source>
        <translation>%1の基部は地形より%2 m高い（%3棟の中央値、ばらつき%4 m）</translation>
    </message>
    <message>
        <source>%1 far from that gap were set down by themselves</source>
        <translation>差が大きく異なる%1棟は個別に置きました</translation>
    </message>
    <message>
        <source>%1 stay above the ground</source>
        <translation>%1棟は地面より上に残ります</translation>
    </message>
    <message>
        <source>finding the buildings</source>
        <translation>建物を探しています</translation>
    </message>
    <message>
        <source>reading the mesh</source>
        <translation>メッシュを読み込んでいます</translation>
    </message>
    <message>
        <source>making buildings of the surface model</source>
        <translation>地表モデルから建物を作成しています</translation>
    </message>
    <message>
        <source>reading canopy</source>
        <translation>樹冠を読み込んでいます</translation>
    </message>
    <message>
        <source>reading trees</source>
        <translation>樹木を読み込んでいます</translation>
    </message>
    <message>
        <source>joining shadows</source>
        <translation>影を結合しています</translation>
    </message>
    <message>
        <source>evaluating windows</source>
        <translation>窓を評価しています</translation>
    </message>
    <message>
        <source>%1 of %2 heights are assumed (%3 m)</source>
        <translation>%1 / %2 の高さは仮定です（%3 m）</translation>
    </message>
    <message>
        <source>%1 of %2 heights are assumed (most of them %3 m)</source>
        <translation>%1 / %2 の高さは仮定です（多くは%3 m）</translation>
    </message>
    <message>
        <source>Fields that could hold heights or storeys: %1</source>
        <translation>高さまたは階数かもしれない項目: %1</translation>
    </message>
    <message>
        <source>In doubt: %1</source>
        <translation>不確か: %1</translation>
    </message>
    <message>
        <source>%1, %2 km from %3, %4</source>
        <translation>%1、%3 (%4) から%2 km</translation>
    </message>
    <message>
        <source>no buildings</source>
        <translation>建物なし</translation>
    </message>
    <message>
        <source>buildings: %1, parts: %2, up to %3 m high</source>
        <translation>建物: %1、部分: %2、高さ最大%3 m</translation>
    </message>
    <message>
        <source>on a terrain</source>
        <translation>地形の上</translation>
    </message>
    <message>
        <source>on flat ground</source>
        <translation>平らな地面の上</translation>
    </message>
    <message>
        <source>summing up places</source>
        <translation>場所を集計しています</translation>
    </message>
    <message>
        <source>joining the timelines</source>
        <translation>時系列を結合しています</translation>
    </message>
    <message>
        <source>surveying the buildings</source>
        <translation>建物を計測しています</translation>
    </message>
    <message>
        <source>writing the map</source>
        <translation>地図を書き出しています</translation>
    </message>
    <message>
        <source>building gone</source>
        <translation>建物は撤去済み</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>葉</translation>
    </message>
    <message>
        <source>Whether it keeps its leaves (default: as its genus)</source>
        <translation>葉を保つか(既定: 属による)</translation>
    </message>
    <message>
        <source>as its genus</source>
        <translation>属による</translation>
    </message>
    <message>
        <source>First day in leaf</source>
        <translation>着葉の初日</translation>
    </message>
    <message>
        <source>First day in leaf of a tree that loses its leaves (default: as the city&apos;s trees)</source>
        <translation>落葉する木が葉を付ける最初の日(既定: 都市の樹木と同じ)</translation>
    </message>
    <message>
        <source>MM-DD; as the city&apos;s trees</source>
        <translation>MM-DD、都市の樹木と同じ</translation>
    </message>
    <message>
        <source>First day without leaves</source>
        <translation>落葉の初日</translation>
    </message>
    <message>
        <source>First day without leaves of a tree that loses them (default: as the city&apos;s trees)</source>
        <translation>落葉する木が葉を失う最初の日(既定: 都市の樹木と同じ)</translation>
    </message>
    <message>
        <source>Which shadow maps and sheets show where trees reach; files of values hold all that were measured</source>
        <translation>樹木の影が届く所で地図と図面に示す影。値のファイルには測定したすべてが入ります</translation>
    </message>
    <message>
        <source>the days</source>
        <translation>日</translation>
    </message>
    <message>
        <source>the hours</source>
        <translation>時間帯</translation>
    </message>
    <message>
        <source>the clock</source>
        <translation>時刻系</translation>
    </message>
    <message>
        <source>the day %1</source>
        <translation>%1 の日</translation>
    </message>
    <message>
        <source>the limit of &quot;%1&quot;</source>
        <translation>「%1」の限度</translation>
    </message>
    <message>
        <source>the share of &quot;%1&quot;</source>
        <translation>「%1」の割合</translation>
    </message>
    <message>
        <source>the hours of sunshine</source>
        <translation>日照時間</translation>
    </message>
    <message>
        <source>What %1 builds stands outside the region: the figures are of the shadow that reaches into it.</source>
        <translation>%1 の建物は範囲の外にあります。数値は範囲に届く影のものです。</translation>
    </message>
    <message>
        <source>A part of what %1 builds stands outside the region: the figures are of the shadow in it.</source>
        <translation>%1 の建物の一部は範囲の外にあります。数値は範囲内の影のものです。</translation>
    </message>
    <message>
        <source>The change by more than %1 a day reaches the region&apos;s edge: beyond it is not measured.</source>
        <translation>1 日 %1 を超える変化が範囲の端に達しています。その外は測定されません。</translation>
    </message>
    <message>
        <source>the coordinates are taken in the other order than that of their reference system, in which the buildings are mirror images</source>
        <translation>座標参照系の順序では建物が鏡像になるため、座標を逆の順序で読みます</translation>
    </message>
    <message>
        <source>Estimated or assumed of %1 trees: height of %2, crown of %3</source>
        <translation>樹木 %1 本のうち推定または仮定: 高さ %2 本、樹冠 %3 本</translation>
    </message>
    <message>
        <source>%1: %2 compared with %3</source>
        <translation>%1：%2を%3と比較</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%2 の%1</translation>
    </message>
    <message>
        <source>The proposal&apos;s shadow reaches no place in the rule&apos;s hours</source>
        <translation>提案の影は規則の時間帯にどの場所にも届きません</translation>
    </message>
    <message>
        <source>Review all places to have that stated for each</source>
        <translation>すべての場所で評価すると、それぞれについて示されます</translation>
    </message>
    <message>
        <source>The sides of the lot would cross or touch each other</source>
        <translation>敷地の辺が交差または接触します</translation>
    </message>
    <message>
        <source>Move the corner or side less far</source>
        <translation>角または辺の移動を小さくしてください</translation>
    </message>
    <message>
        <source>The sides beside it meet before that</source>
        <translation>隣の辺どうしがその手前で交わります</translation>
    </message>
    <message>
        <source>Move the side less far</source>
        <translation>辺の移動を小さくしてください</translation>
    </message>
    <message>
        <source>A lot needs three corners or more</source>
        <translation>敷地には三つ以上の角が必要です</translation>
    </message>
    <message>
        <source>Move the corner instead</source>
        <translation>代わりに角を移動してください</translation>
    </message>
    <message>
        <source>hot all year</source>
        <translation>一年中暑い</translation>
    </message>
    <message>
        <source>hot months</source>
        <translation>暑い月</translation>
    </message>
    <message>
        <source>before the hot months</source>
        <translation>暑い月の前</translation>
    </message>
    <message>
        <source>after the hot months</source>
        <translation>暑い月の後</translation>
    </message>
    <message>
        <source>winter</source>
        <translation>冬</translation>
    </message>
    <message>
        <source>early spring</source>
        <translation>早春</translation>
    </message>
    <message>
        <source>hot month</source>
        <translation>暑い月</translation>
    </message>
    <message>
        <source>growing season</source>
        <translation>生育期</translation>
    </message>
    <message>
        <source>pedestrian comfort</source>
        <translation>歩行者の快適さ</translation>
    </message>
    <message>
        <source>plants</source>
        <translation>植物</translation>
    </message>
    <message>
        <source>default</source>
        <translation>既定</translation>
    </message>
    <message>
        <source>Any country</source>
        <translation>すべての国</translation>
    </message>
    <message>
        <source>Source of height</source>
        <translation>高さの出典</translation>
    </message>
    <message>
        <source>of the highest part of each building; counts are of the whole city</source>
        <translation>各建物の最も高い部分の出典。数は都市全体</translation>
    </message>
    <message>
        <source>Where the heights come from</source>
        <translation>高さの由来</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>項目</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>地図</translation>
    </message>
    <message>
        <source>Definitions</source>
        <translation>定義</translation>
    </message>
    <message>
        <source>Method and sources</source>
        <translation>方法と出典</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>Scenarios side by side</source>
        <translation>シナリオを並べて表示</translation>
    </message>
    <message>
        <source>%1 on one scale.</source>
        <translation>%1 を同じ目盛で表示。</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>The first %1 of %2.</source>
        <translation>%2 件中の最初の %1 件。</translation>
    </message>
    <message>
        <source> min a day</source>
        <translation> 分/日</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>寄与</translation>
    </message>
    <message>
        <source>Sole contribution of each new building: against the scenario without it</source>
        <translation>新しい建物ごとの単独の寄与: その建物がないシナリオとの比較</translation>
    </message>
    <message>
        <source>Months</source>
        <translation>月</translation>
    </message>
    <message>
        <source> by month</source>
        <translation> (月別)</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>重み</translation>
    </message>
    <message>
        <source>shadow of the proposal alone</source>
        <translation>計画案だけの影</translation>
    </message>
    <message>
        <source>hours of shadow</source>
        <translation>日影時間</translation>
    </message>
    <message>
        <source>limit of the rule</source>
        <translation>規定の限度</translation>
    </message>
    <message>
        <source>distance from the parcel</source>
        <translation>敷地からの距離</translation>
    </message>
    <message>
        <source>existing shadow</source>
        <translation>既存の影</translation>
    </message>
    <message>
        <source>incremental shadow</source>
        <translation>増加日影</translation>
    </message>
    <message>
        <source>sun gained</source>
        <translation>増えた日照</translation>
    </message>
    <message>
        <source>proposal</source>
        <translation>計画案</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>撤去</translation>
    </message>
    <message>
        <source>building</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>open below</source>
        <translation>下部が開放</translation>
    </message>
    <message>
        <source>place</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Heights in %1 above the ground.</source>
        <translation>高さは地面から %1。</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>フィート</translation>
    </message>
    <message>
        <source> Numbers in a white field name the places above.</source>
        <translation> 白地の数字は上の場所を示します。</translation>
    </message>
    <message>
        <source> White lines: streets of the project.</source>
        <translation> 白い線: プロジェクトの道路。</translation>
    </message>
    <message>
        <source> Pale colours: streets, water and parks of the map.</source>
        <translation> 淡い色: 地図の道路、水面、公園。</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>%1 で</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>不適合</translation>
    </message>
    <message>
        <source>verdict gets worse</source>
        <translation>判定が悪化</translation>
    </message>
    <message>
        <source>verdict gets better</source>
        <translation>判定が改善</translation>
    </message>
    <message>
        <source>north</source>
        <translation>北</translation>
    </message>
    <message>
        <source>north-east</source>
        <translation>北東</translation>
    </message>
    <message>
        <source>east</source>
        <translation>東</translation>
    </message>
    <message>
        <source>south-east</source>
        <translation>南東</translation>
    </message>
    <message>
        <source>south</source>
        <translation>南</translation>
    </message>
    <message>
        <source>south-west</source>
        <translation>南西</translation>
    </message>
    <message>
        <source>west</source>
        <translation>西</translation>
    </message>
    <message>
        <source>north-west</source>
        <translation>北西</translation>
    </message>
    <message>
        <source>Floors of %1 m</source>
        <translation>階高 %1 m</translation>
    </message>
    <message>
        <source>, of designed towers as designed</source>
        <translation>、設計したタワーは設計のとおり</translation>
    </message>
    <message>
        <source>continued</source>
        <translation>続き</translation>
    </message>
    <message>
        <source>Language of sheets</source>
        <translation>図面の言語</translation>
    </message>
    <message>
        <source>Language of the texts, numbers and dates of sheets: en, de, es or ja (default: that of the window, English on the command line). Files for programs are the same in every language</source>
        <translation>図面の文章、数値、日付の言語: en、de、es、ja (既定: ウィンドウの言語、コマンドラインでは英語)。プログラム用のファイルはどの言語でも同じです</translation>
    </message>
    <message>
        <source>Timelines of places</source>
        <translation>場所の時系列</translation>
    </message>
    <message>
        <source>Shadows are on a horizontal plane %1 m above the mean ground. </source>
        <translation>影は平均地盤面から %1 m の水平面上です。 </translation>
    </message>
    <message>
        <source>place: </source>
        <translation>場所: </translation>
    </message>
    <message>
        <source> or </source>
        <translation> または </translation>
    </message>
    <message>
        <source>Times: %1.</source>
        <translation>時刻: %1。</translation>
    </message>
    <message>
        <source> Edges of shadows follow cells of %1 m, because the ground is not level.</source>
        <translation> 地面が平らでないため、影の縁は %1 m のセルに沿います。</translation>
    </message>
    <message>
        <source>%1 compared with %2. %3North is up.</source>
        <translation>%1 と %2 の比較。%3上が北です。</translation>
    </message>
    <message>
        <source>Shadow diagrams</source>
        <translation>日影図</translation>
    </message>
    <message>
        <source>Shadow fans</source>
        <translation>影の扇形図</translation>
    </message>
    <message>
        <source>All shadows of a day that the proposal would cast if it stood alone, %1. %2North is up.</source>
        <translation>計画案だけが建つ場合の 1 日のすべての影、%1。%2上が北です。</translation>
    </message>
    <message>
        <source>, %1 to %2</source>
        <translation>、%1 から %2</translation>
    </message>
    <message>
        <source>1:%1. Existing buildings do not hide these shadows</source>
        <translation>1:%1。既存の建物はこれらの影を隠しません</translation>
    </message>
    <message>
        <source>Lines of equal hours of shadow</source>
        <translation>等時間日影線</translation>
    </message>
    <message>
        <source>%1. Thick: limits of the rule. Dashed: distances from the parcel. North is up.</source>
        <translation>%1。太線: 規定の限度。破線: 敷地からの距離。上が北です。</translation>
    </message>
    <message>
        <source>Views from the sun</source>
        <translation>太陽から見た図</translation>
    </message>
    <message>
        <source>%1, without perspective, as the sun sees it: what is visible is sunlit, what is hidden is in shadow. The proposal is violet, places are green.</source>
        <translation>%1、透視なし、太陽から見た姿: 見える所は日が当たり、隠れた所は影です。計画案は紫、場所は緑です。</translation>
    </message>
    <message>
        <source>%1 pass, %2 borderline, %3 fail, %4 not applicable</source>
        <translation>適合 %1、境界 %2、不適合 %3、対象外 %4</translation>
    </message>
    <message>
        <source>%1 before: %2.</source>
        <translation>%1 変更前: %2。</translation>
    </message>
    <message>
        <source>%1 after: %2.</source>
        <translation>%1 変更後: %2。</translation>
    </message>
    <message>
        <source>%1 whose verdict gets worse: %2; better: %3.</source>
        <translation>%1 のうち判定が悪化: %2、改善: %3。</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>概要</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>窓</translation>
    </message>
    <message>
        <source>Buildings</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>Proposal: %1. Baseline: %2.</source>
        <translation>計画案: %1。比較基準: %2。</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>未確認</translation>
    </message>
    <message>
        <source>Fail before</source>
        <translation>変更前の不適合</translation>
    </message>
    <message>
        <source>Fail after</source>
        <translation>変更後の不適合</translation>
    </message>
    <message>
        <source>Worse</source>
        <translation>悪化</translation>
    </message>
    <message>
        <source>Verdict before</source>
        <translation>変更前の判定</translation>
    </message>
    <message>
        <source>Verdict after</source>
        <translation>変更後の判定</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窓</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>階</translation>
    </message>
    <message>
        <source>Faces, deg</source>
        <translation>方位、度</translation>
    </message>
    <message>
        <source>%1, before</source>
        <translation>%1(以前)</translation>
    </message>
    <message>
        <source>%1, after</source>
        <translation>%1(以後)</translation>
    </message>
    <message>
        <source>Sun before</source>
        <translation>変更前の日照</translation>
    </message>
    <message>
        <source>Sun after</source>
        <translation>変更後の日照</translation>
    </message>
    <message>
        <source>%1, clock: %2. Minutes, or percent where stated</source>
        <translation>%1、時刻: %2。分、または表示のある所は %</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Engine: %1. Clock: %2, year %3; %4 steps of %5 min with the sun in the rule&apos;s hours.</source>
        <translation>エンジン: %1。時刻: %2、%3 年。規定の時間内に太陽がある %5 分刻みの %4 ステップ。</translation>
    </message>
    <message>
        <source>Each run of minutes is uncertain by a step, a sky component by %1 %. A value within its error of a limit is borderline, never pass.</source>
        <translation>時間には 1 ステップ、天空光成分には %1 % の不確かさがあります。限度との差が誤差以内の値は境界とし、適合とはしません。</translation>
    </message>
    <message>
        <source>The rule, as it was read</source>
        <translation>規定の読み取り方</translation>
    </message>
    <message>
        <source>Review of windows: </source>
        <translation>窓の審査: </translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Windows at no building</source>
        <translation>建物に属さない窓</translation>
    </message>
    <message>
        <source>The building is new or changed</source>
        <translation>建物は新しいか変更されています</translation>
    </message>
    <message>
        <source>No former values</source>
        <translation>以前の値なし</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変化</translation>
    </message>
    <message>
        <source>, scale locked</source>
        <translation>、目盛固定</translation>
    </message>
    <message>
        <source>Elevations: </source>
        <translation>立面図: </translation>
    </message>
    <message>
        <source>%1 and %2. %3. Colours beyond the ends of a scale are those of its ends.</source>
        <translation>%1 と %2。%3。目盛の端を超える色は端の色です。</translation>
    </message>
    <message>
        <source>Grey: no value. Seen square to the wall, from outside.</source>
        <translation>灰色: 値なし。外側から壁に正対して見た図。</translation>
    </message>
    <message>
        <source>Sun: azimuth %1°, altitude %2°</source>
        <translation>太陽: 方位角 %1°、高度 %2°</translation>
    </message>
    <message>
        <source>Without perspective, as the sun sees it: what is visible is sunlit, what is hidden is in shadow. New and changed buildings are violet. Clock: %1.</source>
        <translation>透視なし、太陽から見た姿: 見える所は日が当たり、隠れた所は影です。新しい建物と変更した建物は紫です。時刻: %1。</translation>
    </message>
    <message>
        <source>on a plane %1 m above the mean ground</source>
        <translation>平均地盤面から %1 m の面上</translation>
    </message>
    <message>
        <source>on the ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Hours of shadow in the rule&apos;s hours, %1, on cells of %2 m</source>
        <translation>規定の時間内の日影時間、%1、%2 m のセル</translation>
    </message>
    <message>
        <source>Shadow review: </source>
        <translation>日影審査: </translation>
    </message>
    <message>
        <source>Engine: %1. Receivers: centres of the square cells of %2 m that the places touch, each weighed by its share of the place, not under a building of baseline or proposal.</source>
        <translation>エンジン: %1。測定点: 場所にかかる %2 m 四方のセルの中心。場所に占める割合で重み付けし、比較基準や計画案の建物の下は除きます。</translation>
    </message>
    <message>
        <source>Time: %1, %2 of %3 min with the sun in the rule&apos;s hours. Clock: %4.</source>
        <translation>時間: %1、規定の時間内に太陽がある %3 分刻みの %2。時刻: %4。</translation>
    </message>
    <message>
        <source>Sun: ERFA, topocentric, seen from %1; apparent altitude, with refraction.</source>
        <translation>太陽: ERFA、地心でなく %1 から見た位置。見かけの高度、大気差を含む。</translation>
    </message>
    <message>
        <source>Frame: metres to the east and true north of %1 (WGS84).</source>
        <translation>座標: %1 (WGS84) から東と真北へのメートル。</translation>
    </message>
    <message>
        <source>Incremental shadow lies on what is sunlit in the baseline; sun gained is the reverse.</source>
        <translation>増加日影は比較基準で日が当たる所にできる影、増えた日照はその逆です。</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>誤差</translation>
    </message>
    <message>
        <source>The outlines in diagrams are exact unions of projected buildings where the ground is level; the figures come from the cells.</source>
        <translation>図の輪郭は、地面が平らな所では投影した建物の正確な和です。数値はセルによります。</translation>
    </message>
    <message>
        <source>Not modelled</source>
        <translation>モデル化していないもの</translation>
    </message>
    <message>
        <source>Small structures and penumbra; the sun is a point at the centre of its disc.</source>
        <translation>小さな構造物と半影。太陽は円盤の中心の点とします。</translation>
    </message>
    <message>
        <source>. Diagrams show the shadows of buildings and terrain.</source>
        <translation>。図には建物と地形の影を示します。</translation>
    </message>
    <message>
        <source> without a name</source>
        <translation> (名称なし)</translation>
    </message>
    <message>
        <source>   ... further numbers: see the summary</source>
        <translation>   ... その他の番号: 概要を参照</translation>
    </message>
    <message>
        <source>Of %1 places %2 are listed one by one; the numbers are those of the diagrams. Places of less than %3 without a name are listed together. Timelines are of places that fail or are borderline. review.csv has all places; the option --all-pages prints them.</source>
        <translation>%1 か所のうち %2 か所を個別に載せます。番号は図のものです。%3 未満で名称のない場所はまとめます。時系列は不適合と境界の場所です。すべての場所は review.csv にあり、オプション --all-pages で印刷します。</translation>
    </message>
    <message>
        <source>Clock: %1, year %2. Engine: %3, every %4 min, cells of %5 m. %6.</source>
        <translation>時刻: %1、%2 年。エンジン: %3、%4 分ごと、セル %5 m。%6。</translation>
    </message>
    <message>
        <source>Figures only: the sun is not up at the rule&apos;s times, so no diagram is drawn.</source>
        <translation>数値のみ: 規定の時刻に太陽が出ていないため、図はありません。</translation>
    </message>
    <message>
        <source>Places without new shadow</source>
        <translation>新しい影のない場所</translation>
    </message>
    <message>
        <source>%1 further places with names</source>
        <translation>名称のあるその他の場所 %1 か所</translation>
    </message>
    <message>
        <source>%1 without a name</source>
        <translation>名称のない%1</translation>
    </message>
    <message>
        <source>Nothing is stated as unchecked.</source>
        <translation>未確認の項目はありません。</translation>
    </message>
    <message>
        <source>Sums over the days of the rule</source>
        <translation>規定の日の合計</translation>
    </message>
    <message>
        <source>%1: existing shadow %2 of the theoretical sun; incremental %3; most on %4.</source>
        <translation>%1: 既存の影は理論日照の %2、増加 %3、最大の日は %4。</translation>
    </message>
    <message>
        <source>no day</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>the most incremental shadow on %1 (%2) at one moment</source>
        <translation>%1 (%2) の増加日影が最大となる瞬間</translation>
    </message>
    <message>
        <source>Numbers in a white field: places of the table.</source>
        <translation>白地の数字: 表の場所。</translation>
    </message>
    <message>
        <source>Verdicts</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Verdicts, continued</source>
        <translation>判定 (続き)</translation>
    </message>
    <message>
        <source>Rule used in: %1. Site: %2.</source>
        <translation>規則の適用地: %1。敷地: %2。</translation>
    </message>
    <message>
        <source>. %1 days without incremental shadow are in review.csv only</source>
        <translation>。増加日影のない %1 日は review.csv のみにあります</translation>
    </message>
    <message>
        <source>. Of each month the day of most incremental shadow; %1 further days are in review.csv, and here with the option --all-pages</source>
        <translation>。各月で追加の影が最も多い日。ほかの %1 日は review.csv に、またオプション --all-pages でここにあります</translation>
    </message>
    <message>
        <source>%1 of %2 places; review.csv has all</source>
        <translation>%2 か所中 %1 か所。すべては review.csv にあります</translation>
    </message>
    <message>
        <source>Table of the rule</source>
        <translation>規定の表</translation>
    </message>
    <message>
        <source>%1, clock: %2%3</source>
        <translation>%1、時刻: %2%3</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>基準</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>測定値</translation>
    </message>
    <message>
        <source>Former</source>
        <translation>以前</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>限度</translation>
    </message>
    <message>
        <source>Deciding day</source>
        <translation>決め手の日</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source> (does not decide)</source>
        <translation> (判定に用いない)</translation>
    </message>
    <message>
        <source>Former: the same in the baseline, where a limit compares with it</source>
        <translation>以前: 限度が比較する場合の、比較基準での同じ値</translation>
    </message>
    <message>
        <source>Criteria: the figures behind the verdicts</source>
        <translation>基準: 判定の根拠の数値</translation>
    </message>
    <message>
        <source>Theoretical sun</source>
        <translation>理論日照</translation>
    </message>
    <message>
        <source>Existing shadow</source>
        <translation>既存の影</translation>
    </message>
    <message>
        <source>share</source>
        <translation>割合</translation>
    </message>
    <message>
        <source>With proposal</source>
        <translation>計画案あり</translation>
    </message>
    <message>
        <source>Days with incremental shadow</source>
        <translation>増加日影のある日数</translation>
    </message>
    <message>
        <source>Day of most</source>
        <translation>最大の日</translation>
    </message>
    <message>
        <source>Duration on it</source>
        <translation>その日の時間</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分</translation>
    </message>
    <message>
        <source>Sums</source>
        <translation>合計</translation>
    </message>
    <message>
        <source>Over the days of the rule; shares of the theoretical sun</source>
        <translation>規定の日について。理論日照に占める割合</translation>
    </message>
    <message>
        <source>Days with shadow</source>
        <translation>影のある日数</translation>
    </message>
    <message>
        <source>Enters at the earliest</source>
        <translation>最も早い開始</translation>
    </message>
    <message>
        <source>Exits at the latest</source>
        <translation>最も遅い終了</translation>
    </message>
    <message>
        <source>Longest on a day</source>
        <translation>1 日の最長</translation>
    </message>
    <message>
        <source>Largest area</source>
        <translation>最大面積</translation>
    </message>
    <message>
        <source>Incremental shadow by season</source>
        <translation>季節別の増加日影</translation>
    </message>
    <message>
        <source>Seasons without incremental shadow are left out. Clock: %1</source>
        <translation>増加日影のない季節は省きます。時刻: %1</translation>
    </message>
    <message>
        <source>New building</source>
        <translation>新しい建物</translation>
    </message>
    <message>
        <source>share of the theoretical sun</source>
        <translation>理論日照に占める割合</translation>
    </message>
    <message>
        <source>of the proposal&apos;s shadow</source>
        <translation>計画案の影に占める割合</translation>
    </message>
    <message>
        <source>Sole contributions of the new buildings</source>
        <translation>新しい建物の単独の寄与</translation>
    </message>
    <message>
        <source>What each casts where the baseline and all others of the proposal leave the sun, over the days of the rule; shadow that two of them share is in neither row</source>
        <translation>比較基準と計画案の他の建物が日照を残す所に各建物が落とす影、規定の日について。二つが共有する影はどの行にも含みません</translation>
    </message>
    <message>
        <source>Points at no building</source>
        <translation>建物に属さない点</translation>
    </message>
    <message>
        <source>Elevations</source>
        <translation>立面図</translation>
    </message>
    <message>
        <source>, mean over the days</source>
        <translation>、日平均</translation>
    </message>
    <message>
        <source>Seen square to the wall, from outside.</source>
        <translation>外側から壁に正対して見た図。</translation>
    </message>
    <message>
        <source>Points on %1. %2.</source>
        <translation>%1 上の点。%2。</translation>
    </message>
    <message>
        <source>Rays at every step of the sun.</source>
        <translation>太陽位置ごとの光線。</translation>
    </message>
    <message>
        <source>Horizons of the points, in bins of a quarter of a degree.</source>
        <translation>点ごとの地平線、四分の一度刻み。</translation>
    </message>
    <message>
        <source>Chosen since %1.</source>
        <translation>選択の理由: %1。</translation>
    </message>
    <message>
        <source>Error against rays: %1.</source>
        <translation>光線に対する誤差: %1。</translation>
    </message>
    <message>
        <source>Hours of sun on %1</source>
        <translation>%1 の日照時間</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>出典</translation>
    </message>
    <message>
        <source>building %1</source>
        <translation>建物 %1</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>地形</translation>
    </message>
    <message>
        <source>Contributions of buildings</source>
        <translation>建物の寄与</translation>
    </message>
    <message>
        <source>%1 and the buildings that make most of the shadow</source>
        <translation>%1 と最も影を落とす建物</translation>
    </message>
    <message>
        <source>Numbers as in the table; buildings outside of the map are not shown</source>
        <translation>番号は表のとおり。地図外の建物は表示しません</translation>
    </message>
    <message>
        <source>Largest contributions</source>
        <translation>最大の寄与</translation>
    </message>
    <message>
        <source>Area x hours in shadow, by building</source>
        <translation>建物別の面積 x 影の時間</translation>
    </message>
    <message>
        <source>Numbers as in the table</source>
        <translation>番号は表のとおり</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Share of all shadow</source>
        <translation>全日影に占める割合</translation>
    </message>
    <message>
        <source>Other buildings: %1</source>
        <translation>その他の建物: %1</translation>
    </message>
    <message>
        <source>All shadow</source>
        <translation>全日影</translation>
    </message>
    <message>
        <source>Attributed: %1. Sole: %2. Area x hours over the whole period. Engine: %3. Rows below 0.1 % are added up; contributions.csv lists each.</source>
        <translation>帰属: %1。単独: %2。全期間の面積 x 時間。エンジン: %3。0.1 % 未満の行は合算しています。すべては contributions.csv にあります。</translation>
    </message>
    <message>
        <source>By building</source>
        <translation>建物別</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>樹木</translation>
    </message>
    <message>
        <source>Contributions of trees</source>
        <translation>樹木の寄与</translation>
    </message>
    <message>
        <source>What trees take of the sun that buildings leave, %1. The first %2 of %3; tree_contributions.csv lists each.</source>
        <translation>建物が残す日照のうち樹木が遮る分、%1。%3 件中の最初の %2 件。すべては tree_contributions.csv にあります。</translation>
    </message>
    <message>
        <source>By tree</source>
        <translation>樹木別</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>結論</translation>
    </message>
    <message>
        <source>How this was made</source>
        <translation>計算の方法</translation>
    </message>
    <message>
        <source>Cells of %1 m; places with fewer than %2 of them have cells of %3 m. Cells on the edge of a place count with the share of them that lies in it.</source>
        <translation>セルは %1 m。セルが %2 個未満の場所では %3 m。場所の縁のセルは内側にある割合で数えます。</translation>
    </message>
    <message>
        <source>Without any shadow there would be %1 h of sun a day.</source>
        <translation>影がまったくなければ日照は 1 日 %1 時間です。</translation>
    </message>
    <message>
        <source>Also measured with %1.</source>
        <translation>%1 でも測定。</translation>
    </message>
    <message>
        <source>Trees: %1.</source>
        <translation>樹木: %1。</translation>
    </message>
    <message>
        <source>Error of cells: %1. The error of each figure is in the table at the end.</source>
        <translation>セルの誤差: %1。各項目の誤差は末尾の表にあります。</translation>
    </message>
    <message>
        <source>The baseline is %1. Ground that is built on in any scenario counts in none.</source>
        <translation>比較基準は %1 です。いずれかのシナリオで建物が建つ地面はどのシナリオでも数えません。</translation>
    </message>
    <message>
        <source>minutes of shadow</source>
        <translation>日影の分数</translation>
    </message>
    <message>
        <source>hours of sun</source>
        <translation>日照時間</translation>
    </message>
    <message>
        <source>Shadow by place</source>
        <translation>場所ごとの影</translation>
    </message>
    <message>
        <source> a day</source>
        <translation> /日</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Change of sun by place: </source>
        <translation>場所別の日照の変化: </translation>
    </message>
    <message>
        <source>minutes of sun a day</source>
        <translation>1 日の日照 (分)</translation>
    </message>
    <message>
        <source> on this day</source>
        <translation> (この日)</translation>
    </message>
    <message>
        <source>mean %1 a day</source>
        <translation>平均 1 日 %1</translation>
    </message>
    <message>
        <source>   Further places: table, %1 and on.</source>
        <translation>   その他の場所: 表の %1 以降。</translation>
    </message>
    <message>
        <source>Places by their %1</source>
        <translation>%1 による場所</translation>
    </message>
    <message>
        <source>Numbers as in the key and the table; a number that would cover another one is left out. Outlines without colour: places without figures.</source>
        <translation>番号は凡例と表のとおり。ほかの番号に重なるものは省きます。色のない輪郭は値のない場所です。</translation>
    </message>
    <message>
        <source>Minutes of shadow by place</source>
        <translation>場所別の日影の分数</translation>
    </message>
    <message>
        <source>Hours of sun by place</source>
        <translation>場所別の日照時間</translation>
    </message>
    <message>
        <source>Change of sun by place</source>
        <translation>場所ごとの日照の変化</translation>
    </message>
    <message>
        <source>change of mean sun a day against %1, minutes</source>
        <translation>%1 に対する 1 日平均日照の変化、分</translation>
    </message>
    <message>
        <source>, min</source>
        <translation>、分</translation>
    </message>
    <message>
        <source>%1, %2, min</source>
        <translation>%1、%2、分</translation>
    </message>
    <message>
        <source>Change of mean shadow, min</source>
        <translation>平均日影の変化、分</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Below, %1</source>
        <translation>未満、%1</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>備考</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>with least sun</source>
        <translation>日照の最も少ない</translation>
    </message>
    <message>
        <source>that lose most to the first scenario</source>
        <translation>最初のシナリオで最も失う</translation>
    </message>
    <message>
        <source>All %1, those %2 first.</source>
        <translation>全 %1、%2 ものから。</translation>
    </message>
    <message>
        <source>The %1 of %2 %3; all of them are in places.csv.</source>
        <translation>%2 中 %3 %1 件。すべては places.csv にあります。</translation>
    </message>
    <message>
        <source> The figures are those of %1; changes are from %2.</source>
        <translation> 値は %1、変化は %2 に対するものです。</translation>
    </message>
    <message>
        <source>Errors against the ray reference, on a sample</source>
        <translation>光線基準に対する誤差 (標本)</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>99 of 100 within</source>
        <translation>100 のうち 99 が以内</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>値の数</translation>
    </message>
    <message>
        <source>Not measured.</source>
        <translation>測定していません。</translation>
    </message>
    <message>
        <source>No month has a day that counts</source>
        <translation>対象となる日がある月はありません</translation>
    </message>
    <message>
        <source>100 % of the place</source>
        <translation>場所の 100 %</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>未集計</translation>
    </message>
    <message>
        <source>The sun is not up in the hours of the rule</source>
        <translation>規定の時間に太陽が出ていません</translation>
    </message>
    <message>
        <source>%1   not counted</source>
        <translation>%1   対象外</translation>
    </message>
    <message>
        <source>the scenario&apos;s shadow</source>
        <translation>シナリオの影</translation>
    </message>
    <message>
        <source>the baseline&apos;s shadow</source>
        <translation>比較基準の影</translation>
    </message>
    <message>
        <source>%1   %2 % of the place in %3</source>
        <translation>%1   場所の %2 % が%3</translation>
    </message>
    <message>
        <source>sq ft</source>
        <translation>平方フィート</translation>
    </message>
    <message>
        <source>Sun gained</source>
        <translation>増えた日照</translation>
    </message>
    <message>
        <source>The sun is not up in the rule&apos;s hours, or the place has no open ground</source>
        <translation>規定の時間に太陽が出ていないか、場所に開けた地面がありません</translation>
    </message>
    <message>
        <source>%1   incremental %2; scenario %3; baseline %4</source>
        <translation>%1   増分 %2、シナリオ %3、比較基準 %4</translation>
    </message>
    <message>
        <source>; sun gained %1</source>
        <translation>、増えた日照 %1</translation>
    </message>
    <message>
        <source>Incremental shadow on the edge of the place alone, beside all centres of cells</source>
        <translation>増加日影は場所の縁だけで、どのセルの中心にもかかりません</translation>
    </message>
    <message>
        <source>No incremental shadow in the rule&apos;s hours</source>
        <translation>規定の時間に増加日影はありません</translation>
    </message>
    <message>
        <source> (up to %1 min too late)</source>
        <translation> (最大 %1 分遅い)</translation>
    </message>
    <message>
        <source>Incremental shadow from %1 to %2%6; at most %3, %4 % of the place, at %5</source>
        <translation>増加日影は %1 から %2%6。最大 %3、場所の %4 %、%5</translation>
    </message>
    <message>
        <source>less shadow</source>
        <translation>影が減る</translation>
    </message>
    <message>
        <source>in the sun</source>
        <translation>日なた</translation>
    </message>
    <message>
        <source>more shadow</source>
        <translation>影が増える</translation>
    </message>
    <message>
        <source>in shadow</source>
        <translation>日影</translation>
    </message>
    <message>
        <source>violet: proposed</source>
        <translation>紫: 計画</translation>
    </message>
    <message>
        <source>orange: only in the baseline</source>
        <translation>橙: 比較基準のみ</translation>
    </message>
    <message>
        <source>orange: demolished</source>
        <translation>橙: 取り壊し</translation>
    </message>
    <message>
        <source>dashed: open below</source>
        <translation>破線: 下部が開放</translation>
    </message>
    <message>
        <source>dark line: region</source>
        <translation>濃い線: 範囲</translation>
    </message>
    <message>
        <source> mi</source>
        <translation> mi</translation>
    </message>
    <message>
        <source> ft</source>
        <translation> ft</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>変更</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>シナリオ</translation>
    </message>
    <message>
        <source>%1 Change: from %2, on the receivers of both. Engine: %3.</source>
        <translation>%1 変化: %2 から、両方の測定点で。エンジン: %3。</translation>
    </message>
    <message>
        <source>The same study of each scenario</source>
        <translation>各シナリオの同じ検討</translation>
    </message>
    <message>
        <source>%1 high</source>
        <translation>高さ %1</translation>
    </message>
    <message>
        <source>floor area %1</source>
        <translation>延床面積 %1</translation>
    </message>
    <message>
        <source>no new building with known floors</source>
        <translation>階数の分かる新しい建物なし</translation>
    </message>
    <message>
        <source>, on one scale</source>
        <translation>、同じ目盛</translation>
    </message>
    <message>
        <source>The first %1 of %2 scenarios; scenario_months.csv has all</source>
        <translation>%2 シナリオ中の最初の %1。すべては scenario_months.csv にあります</translation>
    </message>
    <message>
        <source>%1: %2. Buildings and ground: SHA-256 %3.</source>
        <translation>%1: %2。建物と地面: SHA-256 %3。</translation>
    </message>
    <message>
        <source>no changes</source>
        <translation>変更なし</translation>
    </message>
    <message>
        <source>Colours: %1 in %2; continuous shadow in %3.</source>
        <translation>色: %1 は %2、連続日影は %3。</translation>
    </message>
    <message>
        <source>sun</source>
        <translation>日照</translation>
    </message>
    <message>
        <source>gross shadow</source>
        <translation>累計日影</translation>
    </message>
    <message>
        <source>Change: minutes in %1 minus minutes in %2, with the same engine, steps and cells; positive means more %3. %4</source>
        <translation>変化: %1 の分数から %2 の分数を引いた値 (同じエンジン、ステップ、セル)。正は%3が増えることを示します。%4</translation>
    </message>
    <message>
        <source>shadow</source>
        <translation>影</translation>
    </message>
    <message>
        <source>%1: %2 with more than %3 min a day of additional gross shadow</source>
        <translation>%1: 累計日影が 1 日 %3 分を超えて増える面積 %2</translation>
    </message>
    <message>
        <source>This is the error of the change, compared with the change by the ray reference.</source>
        <translation>これは光線基準による変化と比べた、変化の誤差です。</translation>
    </message>
    <message>
        <source>%1, %2 m high</source>
        <translation>%1、高さ %2 m</translation>
    </message>
    <message>
        <source>Further new buildings</source>
        <translation>その他の新しい建物</translation>
    </message>
    <message>
        <source>sun above the horizon for %1 min a day</source>
        <translation>太陽が地平線上にある時間 1 日 %1 分</translation>
    </message>
    <message>
        <source> Positive means that wanted shade outweighs unwanted shadow. The figures of the months add up to the total.</source>
        <translation> 正は望ましい日陰が望ましくない影を上回ることを示します。月の値の合計が全体です。</translation>
    </message>
    <message>
        <source>Engine: %1.</source>
        <translation>エンジン: %1。</translation>
    </message>
    <message>
        <source>Receivers: centres of square cells of %1 m on %2, inside the region.</source>
        <translation>測定点: 範囲内、%2 上の %1 m 四方のセルの中心。</translation>
    </message>
    <message>
        <source>Weights: %1</source>
        <translation>重み: %1</translation>
    </message>
    <message>
        <source>Shadow score of %1</source>
        <translation>%1 の日影スコア</translation>
    </message>
    <message>
        <source> At each step a ray is traced from each receiver to the centre of the sun; the receiver is in shadow if a building or the terrain blocks the ray.</source>
        <translation> 各ステップで測定点から太陽の中心へ光線を追跡し、建物か地形が遮れば測定点は影です。</translation>
    </message>
    <message>
        <source>the terrain</source>
        <translation>地形</translation>
    </message>
    <message>
        <source>flat ground</source>
        <translation>平らな地面</translation>
    </message>
    <message>
        <source>Receivers: centres of square cells of %1 m on %2, inside the region and not under a building.</source>
        <translation>測定点: 範囲内で建物の下でない、%2 上の %1 m 四方のセルの中心。</translation>
    </message>
    <message>
        <source>Terrain: %1.</source>
        <translation>地形: %1。</translation>
    </message>
    <message>
        <source>; a single day is up to %1 min too long or too short</source>
        <translation>、1 日は最大 %1 分長いか短くなります</translation>
    </message>
    <message>
        <source> The requested step was %1 min; its length was adjusted so that whole steps fill the hours of each day and the period has the exact number of minutes%2.</source>
        <translation> 指定のステップは %1 分です。各日の時間を整数個のステップで満たし、期間の分数が正確になるように長さを調整しました%2。</translation>
    </message>
    <message>
        <source>Time: %1 steps of %2 min used; %3 left out because the sun was below the horizon (night is not shadow). Shares of time refer to the time with the sun above the horizon.%4</source>
        <translation>時間: %2 分の %1 ステップを使用。太陽が地平線下の %3 は除外 (夜は影ではありません)。時間の割合は太陽が地平線上にある時間に対するものです。%4</translation>
    </message>
    <message>
        <source>geometric altitude, without refraction</source>
        <translation>幾何学的な高度、大気差なし</translation>
    </message>
    <message>
        <source>apparent altitude, with refraction at %1 hPa and %2 °C</source>
        <translation>見かけの高度、%1 hPa、%2 °C の大気差を含む</translation>
    </message>
    <message>
        <source> At %1 steps the sun is just above the horizon but below the plane of the geometry; they are computed with the sun in that plane.</source>
        <translation> %1 ステップでは太陽は地平線のすぐ上、形状の面より下にあり、その面上の太陽として計算しています。</translation>
    </message>
    <message>
        <source> In the frame of the geometry true north is rotated by %1° there and the vertical by %2°; at the farthest corner of the region the vertical differs by up to %3° (%4 s of the sun&apos;s motion).%5</source>
        <translation> 形状の座標系ではそこで真北が %1°、鉛直が %2° 回転しています。範囲の最も遠い角では鉛直が最大 %3° ずれます (太陽の動きで %4 秒)。%5</translation>
    </message>
    <message>
        <source>Sun: ERFA, topocentric, seen from the centre of the region (%1, %2 m); %3. Civil time of %4 from the tz database.%5</source>
        <translation>太陽: ERFA、範囲の中心 (%1、%2 m) から見た位置。%3。tz データベースによる %4 の常用時。%5</translation>
    </message>
    <message>
        <source>Frame: metres to the east and true north of %1 (WGS84), the CRS of shadow.tif: %2</source>
        <translation>座標: %1 (WGS84) から東と真北へのメートル、shadow.tif の CRS: %2</translation>
    </message>
    <message>
        <source>%1 % in the mean, %2 % at the 99th percentile, %3 % (%4 min) at the worst receiver (%5)</source>
        <translation>平均 %1 %、99 パーセンタイル %2 %、最悪の測定点で %3 % (%4 分) (%5)</translation>
    </message>
    <message>
        <source>; continuous shadow by %1, of the longest day</source>
        <translation>、連続日影は最も長い日の %1</translation>
    </message>
    <message>
        <source>Measured on %1 of the %2 receivers, spread over the region and traced again by the ray reference over the same %3 steps: shadow area off by %4 % of the ground (standard error %5); gross shadow by %6, of the sunlit time%7.</source>
        <translation>範囲に散らばる %2 点中 %1 点で、同じ %3 ステップを光線基準で追跡し直して測定: 日影面積の差は地面の %4 % (標準誤差 %5)、累計日影は可照時間の %6%7。</translation>
    </message>
    <message>
        <source>All other engines are measured against the ray reference: for the city as modelled, one exact test decides each receiver and step. Changes between sun and shadow are resolved to one step (%1 min), edges of shadows to one cell (%2 m).</source>
        <translation>ほかのエンジンはすべて光線基準と比べて測定します。モデル化した都市では、測定点とステップごとに正確な判定を一度行います。日向と影の変わり目は 1 ステップ (%1 分)、影の縁は 1 セル (%2 m) の精度です。</translation>
    </message>
    <message>
        <source>Limits of the model: roofs are flat unless the data contains their shape; %1; the sun is a point, whereas its real disc of 0.53° blurs a shadow&apos;s edge by about 1 m per 100 m of distance from the occluder. An error in height moves the end of a shadow by error / tan(altitude of the sun): see the sources of the heights.</source>
        <translation>モデルの限界: データに形がない屋根は平らです。%1。太陽は点ですが、実際の 0.53° の円盤は遮蔽物から 100 m につき約 1 m 影の縁をぼかします。高さの誤差は影の先端を 誤差 / tan(太陽高度) だけ動かします。高さの出典を参照してください。</translation>
    </message>
    <message>
        <source>trees count only in figures that name them, street furniture in none</source>
        <translation>樹木はそれを明記した数値だけに含まれ、街路設備はどれにも含まれません</translation>
    </message>
    <message>
        <source>trees and street furniture are not included</source>
        <translation>樹木と街路設備は含みません</translation>
    </message>
    <message>
        <source> Shares: of the receivers&apos; area and of the sunlit time.</source>
        <translation> 割合: 測定点の面積と可照時間に対するもの。</translation>
    </message>
    <message>
        <source>Continuous shadow was not counted.</source>
        <translation>連続日影は集計していません。</translation>
    </message>
    <message>
        <source>Error against the ray reference, on a sample</source>
        <translation>光線基準に対する誤差 (標本)</translation>
    </message>
    <message>
        <source>, scenario </source>
        <translation>、シナリオ </translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>入力</translation>
    </message>
    <message>
        <source>and %1 more: see the JSON file</source>
        <translation>ほか %1 件: JSON ファイルを参照</translation>
    </message>
    <message>
        <source>No file: the city was not read from a file.</source>
        <translation>ファイルなし: 都市はファイルから読み込まれていません。</translation>
    </message>
    <message>
        <source>%1: %2, the city without edits.</source>
        <translation>%1: %2、編集のない都市。</translation>
    </message>
    <message>
        <source>The project has not been saved yet.</source>
        <translation>プロジェクトはまだ保存されていません。</translation>
    </message>
    <message>
        <source>%1, which does not contain the latest changes.</source>
        <translation>%1。最新の変更は含みません。</translation>
    </message>
    <message>
        <source>%1, SHA-256 of the file:</source>
        <translation>%1、ファイルの SHA-256:</translation>
    </message>
    <message>
        <source>Project and scenario</source>
        <translation>プロジェクトとシナリオ</translation>
    </message>
    <message>
        <source>SHA-256 of the content behind the result (defined in the JSON file):</source>
        <translation>結果の元となる内容の SHA-256 (JSON ファイルで定義):</translation>
    </message>
    <message>
        <source>an unknown number of m</source>
        <translation>不明な値 m</translation>
    </message>
    <message>
        <source>from levels × %1</source>
        <translation>階数 × %1 から</translation>
    </message>
    <message>
        <source>missing in the data and replaced by a default (%1 for a whole building)</source>
        <translation>データになく既定値で補ったもの (建物全体で %1)</translation>
    </message>
    <message>
        <source>from three-dimensional data</source>
        <translation>三次元データから</translation>
    </message>
    <message>
        <source>designed: given by the scenario</source>
        <translation>設計: シナリオによる</translation>
    </message>
    <message>
        <source>made up: a sample of no real place</source>
        <translation>架空: 実在しない場所の見本</translation>
    </message>
    <message>
        <source>%1 in %2. Heights of the parts: %3.</source>
        <translation>%1、%2。部分の高さ: %3。</translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation>%1 から。</translation>
    </message>
    <message>
        <source>Features of the files are not parts: an outline that has parts of its own makes none, a feature of several outlines several.</source>
        <translation>ファイルの地物は部分ではありません。部分を持つ輪郭は部分にならず、複数の輪郭を持つ地物は複数になります。</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>None: every feature was used unchanged.</source>
        <translation>なし: すべての地物をそのまま使用しました。</translation>
    </message>
    <message>
        <source>%1 in total, of %2 kinds; the JSON file beside this report lists each one with its feature.</source>
        <translation>合計 %1 件、%2 種類。この報告書と並ぶ JSON ファイルに地物ごとの一覧があります。</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 of %2 buildings used</source>
        <translation>建物 %2 件中 %1 件を使用</translation>
    </message>
    <message>
        <source>, %1 rays</source>
        <translation>、光線 %1 本</translation>
    </message>
    <message>
        <source>. Skipped: </source>
        <translation>。省略: </translation>
    </message>
    <message>
        <source>Computation</source>
        <translation>計算</translation>
    </message>
    <message>
        <source>How to repeat this result</source>
        <translation>この結果を再現する方法</translation>
    </message>
    <message>
        <source>%1 lies beside this report.</source>
        <translation>%1 はこの報告書と並んで置かれています。</translation>
    </message>
    <message>
        <source>Shadow study</source>
        <translation>日影の検討</translation>
    </message>
    <message>
        <source>at an unknown time</source>
        <translation>日時不明</translation>
    </message>
    <message>
        <source>on </source>
        <translation>日時 </translation>
    </message>
    <message>
        <source>A result saved in the project</source>
        <translation>プロジェクトに保存された結果</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, saved %2 by %3. Maps and figures are those that were saved.</source>
        <translation>「%1」、%2 に %3 で保存。地図と数値は保存時のものです。</translation>
    </message>
    <message>
        <source>Its inputs have not changed since.</source>
        <translation>入力はその後変わっていません。</translation>
    </message>
    <message>
        <source>The buildings drawn are those of the scenario as it is now.</source>
        <translation>描かれている建物は現在のシナリオのものです。</translation>
    </message>
    <message>
        <source>Square cells of %1 m; those that were not measured are white on the map.</source>
        <translation>%1 m 四方のセル。測定していないものは地図で白です。</translation>
    </message>
    <message>
        <source>Error: %1.</source>
        <translation>誤差: %1。</translation>
    </message>
    <message>
        <source>Weight table: %1.</source>
        <translation>重みの表: %1。</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>ほか %1 件</translation>
    </message>
    <message>
        <source>Shadow study of %1</source>
        <translation>%1 の日影の検討</translation>
    </message>
    <message>
        <source>Change: minutes in %1 minus minutes in %2; positive means more %3. %4</source>
        <translation>変化: %1 の分数から %2 の分数を引いた値。正は%3が増えることを示します。%4</translation>
    </message>
    <message>
        <source>S</source>
        <translation>南</translation>
    </message>
    <message>
        <source>N</source>
        <translation>北</translation>
    </message>
    <message>
        <source>W</source>
        <translation>西</translation>
    </message>
    <message>
        <source>E</source>
        <translation>東</translation>
    </message>
    <message>
        <source>%1 m east-west by %2 m north-south around %3 (WGS84)</source>
        <translation>%3 (WGS84) を中心に東西 %1 m、南北 %2 m</translation>
    </message>
    <message>
        <source>Data: </source>
        <translation>データ: </translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>セルの大きさ</translation>
    </message>
    <message>
        <source>Steps of the sun</source>
        <translation>太陽位置の数</translation>
    </message>
    <message>
        <source> + %1 min</source>
        <translation> + %1 分</translation>
    </message>
    <message>
        <source> - %1 min</source>
        <translation> - %1 分</translation>
    </message>
    <message>
        <source>sunrise</source>
        <translation>日の出</translation>
    </message>
    <message>
        <source> to </source>
        <translation> から </translation>
    </message>
    <message>
        <source>sunset</source>
        <translation>日没</translation>
    </message>
    <message>
        <source>%1 for %2 h</source>
        <translation>%1 から %2 時間</translation>
    </message>
    <message>
        <source>no date</source>
        <translation>日付なし</translation>
    </message>
    <message>
        <source>%1 to %2 (%3)</source>
        <translation>%1 から %2 (%3)</translation>
    </message>
    <message>
        <source>at </source>
        <translation>時刻 </translation>
    </message>
    <message>
        <source>, every %1 min</source>
        <translation>、%1 分ごと</translation>
    </message>
    <message>
        <source>... the rest is in the JSON file</source>
        <translation>... 残りは JSON ファイルにあります</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>未確認</translation>
    </message>
    <message>
        <source>December to February</source>
        <translation>12 月から 2 月</translation>
    </message>
    <message>
        <source>March to May</source>
        <translation>3 月から 5 月</translation>
    </message>
    <message>
        <source>June to August</source>
        <translation>6 月から 8 月</translation>
    </message>
    <message>
        <source>September to November</source>
        <translation>9 月から 11 月</translation>
    </message>
    <message>
        <source>every</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>average</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>合計</translation>
    </message>
    <message>
        <source>civil</source>
        <translation>常用時</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>標準時</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>true solar</source>
        <translation>真太陽時</translation>
    </message>
    <message>
        <source>upper limb</source>
        <translation>上縁</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>測定面</translation>
    </message>
    <message>
        <source>windows</source>
        <translation>窓</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>existing</source>
        <translation>既存</translation>
    </message>
    <message>
        <source>no action</source>
        <translation>無計画時</translation>
    </message>
    <message>
        <source>reference body</source>
        <translation>比較用の建物形状</translation>
    </message>
    <message>
        <source>mid pane</source>
        <translation>ガラスの中央</translation>
    </message>
    <message>
        <source>sill middle</source>
        <translation>窓台の中央</translation>
    </message>
    <message>
        <source>sill ends</source>
        <translation>窓台の両端</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>外側</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>内側</translation>
    </message>
    <message>
        <source>window</source>
        <translation>窓</translation>
    </message>
    <message>
        <source>room</source>
        <translation>部屋</translation>
    </message>
    <message>
        <source>dwelling</source>
        <translation>住戸</translation>
    </message>
    <message>
        <source>% of the sky&apos;s light</source>
        <translation>天空光に対する %</translation>
    </message>
    <message>
        <source>% of the year&apos;s probable sun</source>
        <translation>年間の可能日照に対する %</translation>
    </message>
    <message>
        <source>rays</source>
        <translation>レイ</translation>
    </message>
    <message>
        <source>horizons with ends by rays</source>
        <translation>端をレイで求める地平線</translation>
    </message>
    <message>
        <source>The windows of %1 more buildings are in windows.csv</source>
        <translation>ほかの %1 棟の窓は windows.csv にあります</translation>
    </message>
    <message>
        <source>; %1 more windows are in windows.csv</source>
        <translation>。ほかの窓 %1 個は windows.csv にあります</translation>
    </message>
    <message>
        <source>Projected shadows: each building&apos;s shadow filled as polygons at every step, exact on flat ground</source>
        <translation>投影した影: 各建物の影を毎ステップ多角形として塗る。平らな地面で厳密</translation>
    </message>
    <message>
        <source>cells under buildings</source>
        <translation>建物の下のセル</translation>
    </message>
    <message>
        <source>cells outside the region</source>
        <translation>範囲外のセル</translation>
    </message>
    <message>
        <source>cells on water</source>
        <translation>水面のセル</translation>
    </message>
    <message>
        <source>steps with the sun below the horizon</source>
        <translation>太陽が地平線の下にあるステップ</translation>
    </message>
    <message>
        <source>shadows that meet no receiver (casters x steps x bands of rows)</source>
        <translation>どの測定点にも届かない影 (影を落とす物 x ステップ x 行の帯)</translation>
    </message>
    <message>
        <source>prisms and solids whose shadow cannot reach a tile (each x azimuth bins)</source>
        <translation>影がタイルに届かない角柱と立体 (それぞれ x 方位の区分)</translation>
    </message>
    <message>
        <source>buildings whose shadow cannot reach a receiver</source>
        <translation>影が測定点に届かない建物</translation>
    </message>
    <message>
        <source>Projected shadows: exact on flat ground, one run for all months and intervals</source>
        <translation>投影した影: 平らな地面で厳密。すべての月と区間を一度に計算</translation>
    </message>
    <message>
        <source>%1 takes more than a minute of sun a day from one place, at most %2 at one spot.</source>
        <translation>%1 は 1 か所で 1 日 1 分を超える日照を奪い、1 地点では最大 %2 です。</translation>
    </message>
    <message>
        <source>%1 adds more than a minute of shadow a day to one place, at most %2 at one spot.</source>
        <translation>%1 は 1 か所に 1 日 1 分を超える影を加え、最大は一地点で %2 です。</translation>
    </message>
    <message>
        <source>greenstreet</source>
        <translation>芝生または花壇</translation>
    </message>
    <message>
        <source>other</source>
        <translation>その他の場所</translation>
    </message>
</context>
<context>
    <name>noonmark::AccuracyForm</name>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>How the shadow is computed; the ray reference is the standard for the errors of the others</source>
        <translation>日影の計算方法。他の方法の誤差はレイ基準で測ります</translation>
    </message>
</context>
<context>
    <name>noonmark::AccuracySection</name>
    <message>
        <source>As in the paper</source>
        <translation>論文の通り</translation>
    </message>
    <message>
        <source>Exploration by shadow accrual maps, analysis by inverse accrual maps through the direction graph,
as published. Approximate: the legend states the measured error</source>
        <translation>探索は影累積マップ、解析は方向グラフを通した逆累積マップ。
論文の通りの近似で、凡例に実測誤差を示します</translation>
    </message>
    <message>
        <source>Method and options</source>
        <translation>方法と設定</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>セルの大きさ</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>精度</translation>
    </message>
    <message>
        <source>cell size</source>
        <translation>セルの大きさ</translation>
    </message>
    <message>
        <source>accuracy</source>
        <translation>精度</translation>
    </message>
    <message>
        <source>Side of a cell on the ground. Half the size: four times the cells</source>
        <translation>地面のセルの一辺。半分にするとセル数は4倍になります</translation>
    </message>
</context>
<context>
    <name>noonmark::BookView</name>
    <message>
        <source>Previous page</source>
        <translation>前のページ</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>次のページ</translation>
    </message>
    <message>
        <source>Goes to a chapter; the PDF has them as bookmarks</source>
        <translation>章へ移動。PDF ではしおりになります</translation>
    </message>
    <message>
        <source>How large the page is shown</source>
        <translation>ページの表示倍率</translation>
    </message>
    <message>
        <source>Whole page</source>
        <translation>ページ全体</translation>
    </message>
    <message>
        <source>Page width</source>
        <translation>ページ幅</translation>
    </message>
    <message>
        <source>%1 dots per inch</source>
        <translation>%1 dpi</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>/ %1</translation>
    </message>
    <message>
        <source>Painting the page</source>
        <translation>ページを描画中</translation>
    </message>
    <message>
        <source>Sheets that are to be written are shown here</source>
        <translation>書き出すシートがここに表示されます</translation>
    </message>
</context>
<context>
    <name>noonmark::Breakdown</name>
    <message>
        <source>sweeping horizons</source>
        <translation>地平線を走査しています</translation>
    </message>
</context>
<context>
    <name>noonmark::BreakdownForm</name>
    <message>
        <source>Each month by itself</source>
        <translation>月ごとに分ける</translation>
    </message>
    <message>
        <source>Also sums the shadow of each month: bars in the panel Contributions, a table and maps in exports</source>
        <translation>月ごとの影も合計: 「寄与」パネルの棒グラフ、書き出しの表と地図になります</translation>
    </message>
    <message>
        <source>Contribution of each building</source>
        <translation>建物ごとの寄与</translation>
    </message>
    <message>
        <source>Attributed shadow</source>
        <translation>配分された影</translation>
    </message>
    <message>
        <source>Sole contribution</source>
        <translation>単独の寄与</translation>
    </message>
    <message>
        <source>months</source>
        <translation>月別</translation>
    </message>
    <message>
        <source>contributions</source>
        <translation>寄与</translation>
    </message>
    <message>
        <source>Also finds what each building takes, for the panel Contributions and exports; takes up to twice as long.</source>
        <translation>各建物が奪う分も求めます（パネル「寄与」と書き出し用）。最大 2 倍の時間がかかります。</translation>
    </message>
</context>
<context>
    <name>noonmark::BuildingAdder</name>
    <message>
        <source>finding the buildings</source>
        <translation>建物を探しています</translation>
    </message>
</context>
<context>
    <name>noonmark::BuildingEditing</name>
    <message>
        <source>%1, %2
%3 floor area</source>
        <translation>%1, %2
延べ面積 %3</translation>
    </message>
    <message numerus="yes">
        <source>demolish %1 building(s)</source>
        <translation>
            <numerusform>%1 棟を除却</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::CachedTile</name>
    <message>
        <source>sweeping horizons</source>
        <translation>地平線を走査しています</translation>
    </message>
</context>
<context>
    <name>noonmark::ChartPages</name>
    <message>
        <source>Timelines</source>
        <translation>時系列</translation>
    </message>
    <message>
        <source>Clock: %1.</source>
        <translation>時刻: %1。</translation>
    </message>
</context>
<context>
    <name>noonmark::CompareActions</name>
    <message>
        <source>Scenarios side by side</source>
        <translation>シナリオを並べて表示</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>Two scenarios with one camera and at one time, the other one on the left</source>
        <translation>2 つのシナリオを同じカメラ・同じ時刻で表示します。左が比較するシナリオです</translation>
    </message>
    <message>
        <source>Swipe between scenarios</source>
        <translation>シナリオをスワイプ</translation>
    </message>
    <message>
        <source>Shift+D</source>
        <translation>Shift+D</translation>
    </message>
    <message>
        <source>Drag the line in the view: the other scenario lies to its left</source>
        <translation>ビューの線をドラッグします。線の左側が比較するシナリオです</translation>
    </message>
    <message>
        <source>Show the other scenario</source>
        <translation>比較するシナリオを表示</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Press again for the displayed scenario: what differs flickers</source>
        <translation>もう一度押すと表示中のシナリオに戻ります。異なる部分がちらつきます</translation>
    </message>
    <message>
        <source>There is only one scenario. Change a building or design a tower, then compare</source>
        <translation>シナリオは 1 つだけです。建物を変更するかタワーを設計してから比較してください</translation>
    </message>
    <message>
        <source>Left: %1. Right: %2</source>
        <translation>左: %1。右: %2</translation>
    </message>
    <message>
        <source>shown: %1</source>
        <translation>表示中: %1</translation>
    </message>
    <message>
        <source>sun and shadow of the same moment</source>
        <translation>同じ時刻の日照と影</translation>
    </message>
    <message>
        <source>explored: %1 only</source>
        <translation>探索表示: %1 のみ</translation>
    </message>
    <message>
        <source>the same question, in the same colours</source>
        <translation>同じ質問を同じ色で</translation>
    </message>
    <message>
        <source>not measured yet: %1 (Scenario &gt; Measure all scenarios)</source>
        <translation>未計測: %1 (シナリオ &gt; すべてのシナリオを計測)</translation>
    </message>
</context>
<context>
    <name>noonmark::CompareStrip</name>
    <message>
        <source>The scenario on the left, or under the key C</source>
        <translation>左側、または C キーで表示するシナリオ</translation>
    </message>
    <message>
        <source>The displayed scenario, which edits change</source>
        <translation>編集の対象となる、表示中のシナリオ</translation>
    </message>
    <message>
        <source>Ends the comparison in the view</source>
        <translation>ビューでの比較を終了します</translation>
    </message>
</context>
<context>
    <name>noonmark::ContextMenu</name>
    <message>
        <source>Select</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>Replace by tower</source>
        <translation>塔に置き換え</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Demolish</source>
        <translation>除却</translation>
    </message>
    <message>
        <source>Study its surroundings</source>
        <translation>周辺を検討</translation>
    </message>
    <message>
        <source>Make its outline a place</source>
        <translation>外形を場所にする</translation>
    </message>
    <message>
        <source>Study this place</source>
        <translation>この場所を検討</translation>
    </message>
    <message>
        <source>Zoom to it</source>
        <translation>拡大</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>ここ</translation>
    </message>
    <message>
        <source>Sun and sky here</source>
        <translation>ここの太陽と天空</translation>
    </message>
    <message>
        <source>Draw lot</source>
        <translation>敷地を描く</translation>
    </message>
    <message>
        <source>Draw place</source>
        <translation>場所を描く</translation>
    </message>
    <message>
        <source>Draw region</source>
        <translation>範囲を描く</translation>
    </message>
    <message>
        <source>Copy position: %1</source>
        <translation>位置をコピー: %1</translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation>ここから測る</translation>
    </message>
    <message>
        <source>Demolish the %1 selected</source>
        <translation>選択した %1 棟を除却</translation>
    </message>
    <message>
        <source>Edit lot</source>
        <translation>敷地を編集</translation>
    </message>
</context>
<context>
    <name>noonmark::ContributionLinks</name>
    <message>
        <source>No study yet. Run one (Ctrl+R), then click a place in the view to see which buildings shade it.</source>
        <translation>まだ検討がありません。計算 (Ctrl+R) の後、ビューで場所をクリックすると、影を落とす建物がわかります。</translation>
    </message>
    <message>
        <source>What the buildings take from this place has not been computed yet.</source>
        <translation>この場所から建物が奪う日照はまだ計算されていません。</translation>
    </message>
    <message>
        <source>Click a place in the view to see which buildings shade it, or attribute the shadow of the whole region.</source>
        <translation>ビューで場所をクリックすると影を落とす建物がわかります。範囲全体の影を配分することもできます。</translation>
    </message>
    <message>
        <source>Attributing the shadow of %1</source>
        <translation>%1 の影を配分しています</translation>
    </message>
    <message>
        <source>Choose a place of the table, or click one in the view, to see which buildings shade it.</source>
        <translation>表から場所を選ぶか、ビューで場所をクリックすると、どの建物が影を落とすかが分かります。</translation>
    </message>
    <message>
        <source>A saved result holds what buildings take from its whole region, if that was asked for. Of places it holds those that were attributed before it was saved.</source>
        <translation>保存した結果には、求められていれば領域全体から建物が奪う量が含まれます。場所については、保存前に算出したものが含まれます。</translation>
    </message>
    <message>
        <source>Buildings or trees have changed since the last answer. Run it again (Ctrl+R), then click a place in the view to see which buildings shade it.</source>
        <translation>前回の回答のあとに建物または樹木が変わりました。もう一度実行し (Ctrl+R)、ビューで場所をクリックすると、どの建物が影を落としているかが分かります。</translation>
    </message>
</context>
<context>
    <name>noonmark::ContributionModel</name>
    <message>
        <source>Building</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>Building or tree</source>
        <translation>建物または樹木</translation>
    </message>
</context>
<context>
    <name>noonmark::Contributions</name>
    <message>
        <source>E</source>
        <translation>東</translation>
    </message>
    <message>
        <source>NE</source>
        <translation>北東</translation>
    </message>
    <message>
        <source>N</source>
        <translation>北</translation>
    </message>
    <message>
        <source>NW</source>
        <translation>北西</translation>
    </message>
    <message>
        <source>W</source>
        <translation>西</translation>
    </message>
    <message>
        <source>SW</source>
        <translation>南西</translation>
    </message>
    <message>
        <source>S</source>
        <translation>南</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>南東</translation>
    </message>
</context>
<context>
    <name>noonmark::ContributionsDock</name>
    <message>
        <source>Attribute the shadow</source>
        <translation>影を配分</translation>
    </message>
    <message>
        <source>Finds what each building takes, by month, with the engine and the steps of the study</source>
        <translation>建物ごとに奪う日照を、検討のエンジンとステップで月別に求めます</translation>
    </message>
    <message>
        <source>Colour the buildings</source>
        <translation>建物を色分け</translation>
    </message>
    <message>
        <source>Whose shadow is attributed to buildings. Or click a place in the view</source>
        <translation>影を建物に配分する対象。ビューで場所をクリックしても選べます</translation>
    </message>
    <message>
        <source>Colours the buildings in the view by their share of the shadow</source>
        <translation>ビューの建物を影の割合で色分けします</translation>
    </message>
    <message>
        <source>A row selects its building in the view; double-click to go there</source>
        <translation>行を選ぶとビューでその建物を選択。ダブルクリックで移動します</translation>
    </message>
    <message>
        <source>Share of the shadow that a building is charged with</source>
        <translation>建物に割り当てた影の割合</translation>
    </message>
    <message>
        <source>Whole region</source>
        <translation>範囲全体</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>書き出す...</translation>
    </message>
    <message>
        <source>Writes this list with the answer, as CSV and JSON</source>
        <translation>この一覧を回答とともに CSV と JSON で書き出します</translation>
    </message>
</context>
<context>
    <name>noonmark::CopyActions</name>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
    <message>
        <source>The table or text last clicked, else the picture of the view</source>
        <translation>最後にクリックした表または文字。なければ表示の画像</translation>
    </message>
    <message>
        <source>The figures of the panel Results, as a table</source>
        <translation>「結果」の数値を表としてコピー</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>The view with title, legend, scale and north</source>
        <translation>題名、凡例、縮尺、方位付きの表示</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>%1 copied</source>
        <translation>%1をコピーしました</translation>
    </message>
    <message>
        <source>Copy fi&amp;gures</source>
        <translation>数値をコピー(&amp;G)</translation>
    </message>
    <message>
        <source>C&amp;opy picture</source>
        <translation>画像をコピー(&amp;O)</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
</context>
<context>
    <name>noonmark::CrownTracer</name>
    <message>
        <source>tracing rays through trees</source>
        <translation>樹木を通る光線を追跡しています</translation>
    </message>
</context>
<context>
    <name>noonmark::DayClock</name>
    <message>
        <source>%1, with daylight saving</source>
        <translation>%1、夏時間あり</translation>
    </message>
    <message>
        <source>%1, standard time</source>
        <translation>%1、標準時</translation>
    </message>
    <message>
        <source>true solar time</source>
        <translation>真太陽時</translation>
    </message>
</context>
<context>
    <name>noonmark::DayPanel</name>
    <message>
        <source>Any day, in the hours of the rule</source>
        <translation>規定の時間帯の任意の日</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>時系列</translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation>%1 (%2)。</translation>
    </message>
</context>
<context>
    <name>noonmark::DomeDisplay</name>
    <message>
        <source>Sun path dome</source>
        <translation>太陽軌道ドーム</translation>
    </message>
    <message>
        <source>The sun&apos;s paths of the months and the hours on a dome around what the camera looks at, or around the pin of the panel Point</source>
        <translation>カメラが見ている点、または「点」パネルのピンを中心とするドームに、各月の太陽の軌道と時刻を表示します</translation>
    </message>
</context>
<context>
    <name>noonmark::EditActions</name>
    <message>
        <source>%1 is not a building of the displayed city</source>
        <translation>%1 は表示中の都市の建物ではありません</translation>
    </message>
    <message>
        <source>reload %1</source>
        <translation>%1 の再読み込み</translation>
    </message>
    <message>
        <source>region</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>The study&apos;s region is now around what you built; Study &gt; Where changes it</source>
        <translation>検討範囲を建てたものの周りに移しました。「検討 &gt; 場所」で変更できます</translation>
    </message>
</context>
<context>
    <name>noonmark::EditPreview</name>
    <message>
        <source>%1. Shape of %2 s ago</source>
        <translation>%1。%2 秒前の形</translation>
    </message>
    <message>
        <source>The live shadow was cancelled; it returns with the next design</source>
        <translation>ライブ日影を中止しました。次の設計で再開します</translation>
    </message>
    <message>
        <source>No live shadow. %1</source>
        <translation>ライブ日影なし。%1</translation>
    </message>
    <message>
        <source>No live facades. %1</source>
        <translation>ライブファサードはありません。%1</translation>
    </message>
    <message numerus="yes">
        <source>Facades: %1 point(s) while it moves</source>
        <translation>
            <numerusform>ファサード: 移動中は %1 点</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Facades: %1 point(s)</source>
        <translation>
            <numerusform>ファサード: %1 点</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::EditTools</name>
    <message>
        <source>Draw &amp;lot</source>
        <translation>敷地を描く(&amp;L)</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>&amp;Demolish</source>
        <translation>除却(&amp;D)</translation>
    </message>
    <message>
        <source>Replace by &amp;tower</source>
        <translation>塔に置き換え(&amp;T)</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Replaces the selected building by a tower on its lot or footprint</source>
        <translation>選択した建物を、その敷地または外形の上の塔に置き換える</translation>
    </message>
    <message>
        <source>&amp;Move building</source>
        <translation>建物を移動(&amp;M)</translation>
    </message>
    <message>
        <source>Drag the selected building over the ground</source>
        <translation>選択した建物を地面の上でドラッグ</translation>
    </message>
    <message>
        <source>Creates a lot from the selected building&apos;s outline</source>
        <translation>選択した建物の外形から敷地を作る</translation>
    </message>
    <message>
        <source>&amp;Import mesh...</source>
        <translation>メッシュを読み込む(&amp;I)...</translation>
    </message>
    <message>
        <source>Adds a building from a mesh file, placed by a click</source>
        <translation>メッシュファイルの建物をクリックした位置に加える</translation>
    </message>
    <message>
        <source>Drag the building over the ground. Esc ends the tool.</source>
        <translation>建物を地面の上でドラッグ。Esc で終了。</translation>
    </message>
    <message>
        <source>Lot from foot&amp;print</source>
        <translation>外形から敷地(&amp;P)</translation>
    </message>
    <message>
        <source>Drag the arrow or type a height. Shift: do not snap to storeys. Enter builds, Esc cancels.</source>
        <translation>矢印をドラッグするか、高さを入力します。Shift: 階に揃えない。Enter で建設、Esc で取り消し。</translation>
    </message>
    <message>
        <source>Li&amp;ve facades</source>
        <translation>ライブファサード(&amp;V)</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>Shows the sunlight of a building&apos;s facades while it is designed or changed</source>
        <translation>設計・変更中の建物のファサードの日照を表示します</translation>
    </message>
    <message>
        <source>Removes the selected building, or all of several</source>
        <translation>選択した建物、または選択したすべての建物を除却します</translation>
    </message>
    <message>
        <source>Live change</source>
        <translation>ライブ変化</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>While a building is edited: show the change against the baseline instead of all shadow</source>
        <translation>設計中または変更中の建物について、影全体の代わりに、比較の基準からの変化を示します</translation>
    </message>
    <message>
        <source>Click corners on the ground, or type the length of a side; Shift: right angles, Ctrl: no snapping; Enter finishes, Esc cancels</source>
        <translation>地面で角をクリックするか、辺の長さを入力します。Shift: 直角、Ctrl: スナップなし、Enter で完了、Esc で中止</translation>
    </message>
    <message>
        <source>Edit lot &amp;shape</source>
        <translation>敷地の形を編集(&amp;S)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>Drag the corners and sides of the lot that is chosen in the panel Tower, or that the selected building stands on</source>
        <translation>「塔」ドックで選んだ敷地、または選択した建物が建つ敷地の角と辺をドラッグします</translation>
    </message>
    <message>
        <source>Click the lot&apos;s corners, or type the length of a side. Shift: at right angles to the last side. Ctrl: no snapping. Double click or Enter finishes.</source>
        <translation>敷地の角をクリックするか、辺の長さを入力します。Shift: 直前の辺に直角。Ctrl: スナップなし。ダブルクリックまたは Enter で完了します。</translation>
    </message>
    <message>
        <source>Drag a corner or a side of %1; Ctrl: no snapping. A click on the middle of a side adds a corner, Delete removes the selected one, Esc ends.</source>
        <translation>%1 の角または辺をドラッグします。Ctrl: スナップなし。辺の中央をクリックすると角を追加し、Delete で選択した角を削除、Esc で終了します。</translation>
    </message>
    <message>
        <source>Towers that were designed on it stay as they are.</source>
        <translation>この敷地で設計した塔はそのまま残ります。</translation>
    </message>
    <message>
        <source>Plant trees</source>
        <translation>樹木を植える</translation>
    </message>
    <message>
        <source>Each click on the ground plants a tree; Esc ends</source>
        <translation>地面をクリックするたびに木を植えます。Esc で終了</translation>
    </message>
    <message>
        <source>Plant a row of trees</source>
        <translation>並木を植える</translation>
    </message>
    <message>
        <source>Click the corners of a line; a double click or Enter plants trees along it</source>
        <translation>線の角をクリックし、ダブルクリックまたは Enter でその線に沿って木を植えます</translation>
    </message>
    <message>
        <source>Click the corners of a line. A double click or Enter plants trees along it, Esc ends.</source>
        <translation>線の角をクリックします。ダブルクリックまたは Enter でその線に沿って木を植え、Esc で終了します。</translation>
    </message>
    <message>
        <source>Click where trees are to stand; their measures are in the panel Trees. Esc ends.</source>
        <translation>木を植える位置をクリックします。寸法は「樹木」パネルにあります。Esc で終了します。</translation>
    </message>
</context>
<context>
    <name>noonmark::ElementForm</name>
    <message>
        <source>all of the region</source>
        <translation>領域内のすべて</translation>
    </message>
    <message>
        <source>Names or ids of buildings, with commas between them; their middle must be in the region. Empty: all buildings of the region</source>
        <translation>建物の名前またはID(コンマ区切り)。中心が領域内にあること。空欄: 領域内のすべての建物</translation>
    </message>
    <message>
        <source>Adds the selected building, or removes it. Click a building first.</source>
        <translation>選択した建物を追加または除外します。先に建物をクリックしてください。</translation>
    </message>
    <message>
        <source>file of windows</source>
        <translation>窓のファイル</translation>
    </message>
    <message>
        <source>Points or polygons with heights, in any vector format. Fields id, azimuth, floor</source>
        <translation>高さのある点またはポリゴン(任意のベクター形式)。フィールド id、azimuth、floor</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>参照...</translation>
    </message>
    <message>
        <source>Chooses the file of windows</source>
        <translation>窓のファイルを選びます</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>buildings</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>windows</source>
        <translation>窓</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>解除</translation>
    </message>
    <message>
        <source>Add selected</source>
        <translation>選択を追加</translation>
    </message>
    <message>
        <source>all buildings</source>
        <translation>すべての建物</translation>
    </message>
    <message>
        <source>Names or ids of buildings, with commas between them. Empty: all buildings</source>
        <translation>建物の名前または ID をコンマで区切って入力。空欄ならすべての建物</translation>
    </message>
    <message>
        <source>Proposed buildings only</source>
        <translation>計画建物のみ</translation>
    </message>
    <message>
        <source>The buildings that the displayed scenario builds or changes</source>
        <translation>表示中のシナリオが新築または変更する建物</translation>
    </message>
</context>
<context>
    <name>noonmark::ElementModel</name>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>階</translation>
    </message>
    <message>
        <source>Facing, °</source>
        <translation>方位、°</translation>
    </message>
</context>
<context>
    <name>noonmark::ElementPicking</name>
    <message>
        <source>Click walls in the view to choose their faces.</source>
        <translation>ビューの壁をクリックして面を選びます。</translation>
    </message>
    <message>
        <source>Click the ground, roofs or walls in the view to add points.</source>
        <translation>ビューの地面・屋根・壁をクリックして点を追加します。</translation>
    </message>
</context>
<context>
    <name>noonmark::ElementsDock</name>
    <message>
        <source> h</source>
        <translation> 時間</translation>
    </message>
    <message>
        <source>Part of a building or point</source>
        <translation>建物または点の一部</translation>
    </message>
    <message>
        <source>Lists only the points whose id or building contains this text</source>
        <translation>IDまたは建物にこの文字列を含む点だけを表示します</translation>
    </message>
    <message>
        <source>any</source>
        <translation>指定なし</translation>
    </message>
    <message>
        <source>Lists only the points with less sun a day than this</source>
        <translation>1日の日照がこれより短い点だけを表示します</translation>
    </message>
    <message>
        <source>Select rows to see their points in the view; double-click to go there</source>
        <translation>行を選ぶと点がビューに示されます。ダブルクリックでそこへ移動します</translation>
    </message>
    <message>
        <source>Sun below</source>
        <translation>日照が次より短い</translation>
    </message>
    <message>
        <source>No points measured</source>
        <translation>測定した点はありません</translation>
    </message>
    <message numerus="yes">
        <source>%1 point(s)</source>
        <translation>
            <numerusform>%1 点</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 point(s)</source>
        <translation>
            <numerusform>%2 点のうち %1 点</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::ElevationFlow</name>
    <message>
        <source> %1 more buildings are not drawn.</source>
        <translation> ほか %1 件の建物は描いていません。</translation>
    </message>
    <message>
        <source> %1 sides do not fit on %2 at 1:%3 and are smaller.</source>
        <translation> %1 面は %2 に 1:%3 で収まらないため縮小しています。</translation>
    </message>
    <message>
        <source>%1, facing %2 (%3°)</source>
        <translation>%1、%2向き (%3°)</translation>
    </message>
    <message>
        <source>, layer %1 of %2</source>
        <translation>、層 %1 / %2</translation>
    </message>
    <message>
        <source>1:%1 on %2. %3 windows</source>
        <translation>1:%1 (%2)。窓 %3</translation>
    </message>
</context>
<context>
    <name>noonmark::Exploration</name>
    <message>
        <source>Exploring</source>
        <translation>探索中</translation>
    </message>
</context>
<context>
    <name>noonmark::ExportDialog</name>
    <message>
        <source>Screen</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Large screen</source>
        <translation>大画面</translation>
    </message>
    <message>
        <source>A4 in print</source>
        <translation>A4 印刷</translation>
    </message>
    <message>
        <source>A3 in print</source>
        <translation>A3 印刷</translation>
    </message>
    <message>
        <source>A1 in print</source>
        <translation>A1 印刷</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>What</source>
        <translation>対象</translation>
    </message>
    <message>
        <source> pixels wide</source>
        <translation> 画素幅</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Table of all cells</source>
        <translation>全セルの表</translation>
    </message>
    <message>
        <source>A line of text for each cell: large for a large region</source>
        <translation>セルごとに 1 行。広い範囲では大きくなります</translation>
    </message>
    <message>
        <source>Sheets with a title block</source>
        <translation>表題欄付きの図面</translation>
    </message>
    <message>
        <source>A PDF with maps, figures, charts and method on several pages</source>
        <translation>図、数値、グラフ、方法を数ページにまとめた PDF</translation>
    </message>
    <message>
        <source>a folder; it is created if missing</source>
        <translation>フォルダー。なければ作ります</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>参照...</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>フォルダーを選ぶ</translation>
    </message>
    <message>
        <source>Export to folder</source>
        <translation>フォルダーに書き出す</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>With the project</source>
        <translation>プロジェクトも含める</translation>
    </message>
    <message>
        <source>Puts a copy of the project&apos;s file into the folder, so that the result can be verified from there</source>
        <translation>結果をその場で検証できるように、プロジェクトファイルのコピーをフォルダーに入れます</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>フォルダーを開く</translation>
    </message>
    <message>
        <source>Shows the written files</source>
        <translation>書き出したファイルを表示します</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>%1 に書き出しました</translation>
    </message>
    <message>
        <source>Cancelled. Any change lays the sheets out again.</source>
        <translation>中止しました。変更すると配置し直します。</translation>
    </message>
    <message>
        <source>Title block</source>
        <translation>表題欄</translation>
    </message>
    <message>
        <source>Laying out the sheets</source>
        <translation>図面を配置中</translation>
    </message>
    <message>
        <source> pixels high</source>
        <translation> 画素高</translation>
    </message>
    <message>
        <source>Title, legend and scale bar</source>
        <translation>題名、凡例、縮尺バー</translation>
    </message>
    <message>
        <source>Around the view, within the size of the picture</source>
        <translation>画像の大きさの中で、表示の周囲に付けます</translation>
    </message>
    <message>
        <source>Save project first...</source>
        <translation>先にプロジェクトを保存...</translation>
    </message>
    <message>
        <source>A result can be verified only with the project that it comes from</source>
        <translation>結果は元のプロジェクトがあるときだけ検証できます</translation>
    </message>
    <message>
        <source>The project has changes that are not saved: what is exported now cannot be verified.</source>
        <translation>プロジェクトに保存されていない変更があります。いま書き出すものは検証できません。</translation>
    </message>
    <message>
        <source>The project is not saved: what is exported now cannot be verified.</source>
        <translation>プロジェクトが保存されていません。いま書き出すものは検証できません。</translation>
    </message>
    <message>
        <source>Save project first</source>
        <translation>先にプロジェクトを保存</translation>
    </message>
    <message>
        <source>The name of the PDF with the sheets</source>
        <translation>シートの PDF の名前</translation>
    </message>
    <message>
        <source>Name of the sheets</source>
        <translation>シートの名前</translation>
    </message>
    <message>
        <source>Two of the files have one name: choose another for the sheets</source>
        <translation>二つのファイルが同じ名前です。シートに別の名前を選んでください</translation>
    </message>
    <message>
        <source>No sheets are written. Tick &quot;%1&quot; to see and write them.</source>
        <translation>シートは書き出されません。「%1」にチェックすると表示され、書き出されます。</translation>
    </message>
    <message>
        <source>What is chosen has no sheets.</source>
        <translation>選んだものにシートはありません。</translation>
    </message>
</context>
<context>
    <name>noonmark::ExtrudeHandle</name>
    <message>
        <source>Height: %1  (Enter)</source>
        <translation>高さ: %1  (Enter)</translation>
    </message>
    <message>
        <source>Top above datum: %1  (Enter)</source>
        <translation>上端(基準面から): %1  (Enter)</translation>
    </message>
</context>
<context>
    <name>noonmark::FaceForm</name>
    <message>
        <source>all faces</source>
        <translation>すべての面</translation>
    </message>
    <message>
        <source>Single faces of buildings, with commas between them, by the beginning of their points&apos; ids: way 12 wall 3. Empty: all faces</source>
        <translation>建物の個々の面(コンマ区切り)。点の ID の先頭部分で指定します: way 12 wall 3。空欄: すべての面</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>Click walls in the view: each click adds a face or removes it. Press again to end</source>
        <translation>ビューの壁をクリックするたびに面を追加または除外します。もう一度押すと終了します</translation>
    </message>
    <message>
        <source>any direction</source>
        <translation>すべての方位</translation>
    </message>
    <message>
        <source>north ± 45°</source>
        <translation>北 ± 45°</translation>
    </message>
    <message>
        <source>east ± 45°</source>
        <translation>東 ± 45°</translation>
    </message>
    <message>
        <source>south ± 45°</source>
        <translation>南 ± 45°</translation>
    </message>
    <message>
        <source>west ± 45°</source>
        <translation>西 ± 45°</translation>
    </message>
    <message>
        <source>other azimuths</source>
        <translation>その他の方位角</translation>
    </message>
    <message>
        <source>Only faces, or windows, that face this direction from true north</source>
        <translation>真北を基準にこの方位を向く面または窓だけ</translation>
    </message>
    <message>
        <source>The first azimuth, clockwise from true north</source>
        <translation>最初の方位角(真北から時計回り)</translation>
    </message>
    <message>
        <source>The last azimuth, clockwise from true north</source>
        <translation>最後の方位角(真北から時計回り)</translation>
    </message>
    <message>
        <source>Only points from which a level line straight out from the wall meets this place, as the windows along a park</source>
        <translation>壁から垂直に出る水平線がこの場所に達する点だけ(公園沿いの窓など)</translation>
    </message>
    <message>
        <source>How far away the place may be</source>
        <translation>場所までの最大距離</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>Looking at</source>
        <translation>面する場所</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>faced place</source>
        <translation>面する場所</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>方位</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>指定なし</translation>
    </message>
    <message>
        <source>azimuths</source>
        <translation>方位角</translation>
    </message>
</context>
<context>
    <name>noonmark::FieldChoices</name>
    <message>
        <source>none is found by name</source>
        <translation>名称で検出されず</translation>
    </message>
    <message>
        <source>found by name: %1</source>
        <translation>名称で検出: %1</translation>
    </message>
    <message numerus="yes">
        <source>%1   %2 feature(s)</source>
        <translation>
            <numerusform>%1   地物 %2 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Lists the fields with sample values</source>
        <translation>フィールドを値の例とともに一覧にします</translation>
    </message>
</context>
<context>
    <name>noonmark::FieldHelp</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 から %2</translation>
    </message>
    <message>
        <source>More in the guide (F1)</source>
        <translation>ガイドを見る (F1)</translation>
    </message>
</context>
<context>
    <name>noonmark::Filming</name>
    <message>
        <source>computing the frames of the movie</source>
        <translation>動画のコマを計算しています</translation>
    </message>
    <message>
        <source>writing the movie</source>
        <translation>動画を書き出しています</translation>
    </message>
</context>
<context>
    <name>noonmark::FramePainter</name>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>題名</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>発注者</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>作成者</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>図面</translation>
    </message>
    <message>
        <source>sheet %1 of %2</source>
        <translation>図面 %1 / %2</translation>
    </message>
</context>
<context>
    <name>noonmark::FurtherTable</name>
    <message>
        <source>Add tower</source>
        <translation>タワーを追加</translation>
    </message>
    <message>
        <source>Another tower on the lot, apart from the others: each has a piece of it</source>
        <translation>同じ敷地に、ほかと離れて建つタワー。それぞれが敷地の一部を占めます</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Removes the selected tower, or the last one</source>
        <translation>選択したタワー、または最後のタワーを削除します</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>階数</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>基準階</translation>
    </message>
    <message>
        <source>Further towers, which the same step builds; the lot is divided across its longest side</source>
        <translation>同じステップで建設する追加のタワー。敷地は最も長い辺を横切って分けます</translation>
    </message>
</context>
<context>
    <name>noonmark::GlazingForm</name>
    <message>
        <source>Facades, bay by bay</source>
        <translation>ファサード(スパンごと)</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>ファイルから</translation>
    </message>
    <message>
        <source>A file of points or polygons with heights gives the real windows</source>
        <translation>高さをもつ点またはポリゴンのファイルで実際の窓を指定します</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>窓</translation>
    </message>
</context>
<context>
    <name>noonmark::GlazingPanel</name>
    <message>
        <source>Verdicts after</source>
        <translation>後の判定</translation>
    </message>
    <message>
        <source>Verdicts before</source>
        <translation>前の判定</translation>
    </message>
    <message>
        <source>Changed verdicts</source>
        <translation>変化した判定</translation>
    </message>
    <message>
        <source>No verdicts</source>
        <translation>判定なし</translation>
    </message>
    <message>
        <source>What the 3D view shows on the walls: a tile for each window in the colour of its verdict.
A click on a tile selects its row, a click on a row frames its window.</source>
        <translation>3Dビューの壁面に表示するもの：窓ごとに判定の色のタイル。
タイルをクリックするとその行が選ばれ、行をクリックするとその窓が表示されます。</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>ビューの表示</translation>
    </message>
</context>
<context>
    <name>noonmark::GlazingSession</name>
    <message>
        <source>Review</source>
        <translation>審査</translation>
    </message>
    <message>
        <source>Not up to date. %1</source>
        <translation>最新ではありません。%1</translation>
    </message>
    <message>
        <source>Not up to date: buildings, windows or the rule have changed. Run again.</source>
        <translation>最新ではありません: 建物、窓、または規則が変わりました。もう一度実行してください。</translation>
    </message>
    <message>
        <source>Estimating</source>
        <translation>所要時間を見積もっています</translation>
    </message>
    <message>
        <source>All reviews</source>
        <translation>すべての審査</translation>
    </message>
</context>
<context>
    <name>noonmark::GlazingTable</name>
    <message>
        <source>Window</source>
        <translation>窓</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>以前</translation>
    </message>
    <message>
        <source>After</source>
        <translation>以後</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>階</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>%1, before</source>
        <translation>%1(以前)</translation>
    </message>
    <message>
        <source>%1, after</source>
        <translation>%1(以後)</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Sun on %1: %2; before: %3.</source>
        <translation>%1 の日照: %2、以前: %3。</translation>
    </message>
</context>
<context>
    <name>noonmark::GuideWindow</name>
    <message>
        <source>User guide</source>
        <translation>ユーザーガイド</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>ガイド内を検索</translation>
    </message>
    <message>
        <source>Lists the pages with these words; Enter goes to the next place</source>
        <translation>この語を含むページを一覧にします。Enter で次の箇所へ移ります</translation>
    </message>
    <message>
        <source>Pages of the guide</source>
        <translation>ガイドのページ</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
</context>
<context>
    <name>noonmark::HeightColours</name>
    <message>
        <source>Colour &amp;by source of height</source>
        <translation>高さの出典で色分け(&amp;B)</translation>
    </message>
    <message>
        <source>Buildings whose height is measured, computed from storeys or assumed</source>
        <translation>高さが実測、階数からの計算、仮定の建物</translation>
    </message>
</context>
<context>
    <name>noonmark::HelpActions</name>
    <message>
        <source>User &amp;guide</source>
        <translation>ユーザーガイド(&amp;G)</translation>
    </message>
    <message>
        <source>The guide, at the page about the panel in use</source>
        <translation>使用中のパネルについてのページを開く</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>スタートページ(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;About Noonmark</source>
        <translation>Noonmark について(&amp;A)</translation>
    </message>
    <message>
        <source>Version, libraries and processor</source>
        <translation>バージョン、ライブラリ、プロセッサ</translation>
    </message>
    <message>
        <source>About Noonmark</source>
        <translation>Noonmark について</translation>
    </message>
    <message>
        <source>&amp;What&apos;s this?</source>
        <translation>これは何?(&amp;W)</translation>
    </message>
    <message>
        <source>Explains the field that is clicked next; in a field, Shift+F1</source>
        <translation>次にクリックした欄を説明します</translation>
    </message>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>マウスとキー(&amp;M)</translation>
    </message>
    <message>
        <source>All keys and what the mouse does, as a table</source>
        <translation>すべてのキーとマウス操作の一覧表</translation>
    </message>
    <message>
        <source>Recent projects, samples and questions</source>
        <translation>最近のプロジェクト、サンプル、質問</translation>
    </message>
    <message>
        <source>Ctrl+F1</source>
        <translation>Ctrl+F1</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>質問</translation>
    </message>
    <message>
        <source>What do you want to know of this city?</source>
        <translation>この都市について何を知りたいですか?</translation>
    </message>
</context>
<context>
    <name>noonmark::HorizonCache</name>
    <message>
        <source>sweeping horizons</source>
        <translation>地平線を走査しています</translation>
    </message>
</context>
<context>
    <name>noonmark::HoursOf</name>
    <message>
        <source>Hours of sun a day by month</source>
        <translation>月別の 1 日の日照時間</translation>
    </message>
</context>
<context>
    <name>noonmark::KeySheet</name>
    <message>
        <source>Mouse and keys</source>
        <translation>マウスとキー</translation>
    </message>
    <message>
        <source>Find a key or what it does</source>
        <translation>キーまたはその働きを探す</translation>
    </message>
    <message>
        <source>Shows the rows that contain these words</source>
        <translation>この語を含む行を表示します</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>What</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>Keys, mouse</source>
        <translation>キー、マウス</translation>
    </message>
</context>
<context>
    <name>noonmark::LatestAnswers</name>
    <message>
        <source>Comparison</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>All scores</source>
        <translation>すべてのスコア</translation>
    </message>
    <message>
        <source>Reading saved results</source>
        <translation>保存した結果を読み込み中</translation>
    </message>
    <message>
        <source>Comparing buildings</source>
        <translation>建物を比較しています</translation>
    </message>
</context>
<context>
    <name>noonmark::LegendEditor</name>
    <message>
        <source>%1 (not for colour-blind readers)</source>
        <translation>%1 (色覚の多様性に非対応)</translation>
    </message>
    <message>
        <source>Minutes in shadow, hours of sun (the sunlit time minus gross shadow), or the share of the sunlit time in the sun.
Continuous shadow stays in minutes: the longest run in the sun does not follow from it.</source>
        <translation>日影の分、日照時間 (可照時間から累計日影を引いた値)、または可照時間のうち日なたの割合。
連続日影は分のままです。途切れない最長の日なたはそこから求められません。</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>連続</translation>
    </message>
    <message>
        <source>Equal classes</source>
        <translation>等間隔</translation>
    </message>
    <message>
        <source>Quantiles: as many cells in each</source>
        <translation>分位: 各区分のセル数が同じ</translation>
    </message>
    <message>
        <source>Typed numbers, or one threshold</source>
        <translation>入力した数値、または一つのしきい値</translation>
    </message>
    <message>
        <source>Re&amp;versed</source>
        <translation>反転(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Locked</source>
        <translation>固定(&amp;L)</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Values at the ends, in the unit shown, such as 0:8</source>
        <translation>両端の値 (表示中の単位)。例 0:8</translation>
    </message>
    <message>
        <source>Numbers between the classes, ascending, in the unit shown. One number is a threshold: two colours</source>
        <translation>区分の境界の数値を小さい順に (表示中の単位)。一つならしきい値となり 2 色</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>凡例</translation>
    </message>
    <message>
        <source>Keep the range of this map for all others; unlocked, each map has its own.</source>
        <translation>この地図の範囲を他のすべてにも使います。固定しなければ地図ごとに異なります。</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>表示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>配色(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Range</source>
        <translation>範囲(&amp;R)</translation>
    </message>
    <message>
        <source>Cla&amp;sses</source>
        <translation>区分(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>数値(&amp;N)</translation>
    </message>
    <message>
        <source>Not two numbers like 0:8, or not ascending numbers like 2,4,6</source>
        <translation>0:8 のような 2 つの数値、または 2,4,6 のような小さい順の数値ではありません</translation>
    </message>
    <message>
        <source>Colours from much sun to much shadow; of differences and scores those around a pale middle</source>
        <translation>多い日照から多い影への色。差と得点では淡い中央をはさむ色</translation>
    </message>
    <message>
        <source>%1 (safe for colour-blind readers)</source>
        <translation>%1（色覚多様性に対応）</translation>
    </message>
    <message>
        <source>What is shown has fixed colours: there is nothing to choose</source>
        <translation>表示中のものの色は固定で、選ぶものがありません</translation>
    </message>
    <message>
        <source>A difference has its range beside the legend; a score is fitted</source>
        <translation>差の範囲は凡例の横にあります。得点は自動で合わせます</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>By the threshold of the panel Places</source>
        <translation>「場所」パネルのしきい値による</translation>
    </message>
    <message>
        <source>Range and numbers are hours of sun a day</source>
        <translation>範囲と数値は 1 日の日照時間です</translation>
    </message>
    <message>
        <source>Range and numbers are hours of sun a day: switch to Sun to change them</source>
        <translation>範囲と数値は 1 日の日照時間です。変更するには「日照」に切り替えてください</translation>
    </message>
</context>
<context>
    <name>noonmark::LegendStrip</name>
    <message>
        <source> min</source>
        <translation> 分</translation>
    </message>
    <message>
        <source>The ends of the colour scale of a difference.
Lock it to compare pictures of several proposals; 0: automatic, fitted to each difference.</source>
        <translation>差分の色目盛の両端。
複数の案の図を比べるときは固定します。0: 自動で差分ごとに合わせる。</translation>
    </message>
    <message>
        <source>What is displayed.
Gross shadow: minutes in shadow per day, mean over the days.
Continuous shadow: longest unbroken run in shadow on any day, minutes.</source>
        <translation>表示する量。
累計日影: 1 日の日影の分、日の平均。
連続日影: 1 日のうち途切れない最長の日影、分。</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>日影</translation>
    </message>
    <message>
        <source>Show minutes in shadow</source>
        <translation>日影の分を表示</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>日照</translation>
    </message>
    <message>
        <source>Show hours of sun a day: the sunlit time minus gross shadow, on maps, legends and what is exported.
Continuous shadow stays as it is: the longest run in the sun does not follow from it.</source>
        <translation>地図、凡例、書き出しに 1 日の日照時間 (可照時間から累計日影を引いた値) を示します。
連続日影はそのままです。途切れない最長の日なたはそこから求められません。</translation>
    </message>
</context>
<context>
    <name>noonmark::LengthField</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>noonmark::LevelOutliner</name>
    <message>
        <source>projecting shadows</source>
        <translation>影を投影しています</translation>
    </message>
</context>
<context>
    <name>noonmark::LineForm</name>
    <message>
        <source>Parcel</source>
        <translation>敷地</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>lot or file</source>
        <translation>敷地またはファイル</translation>
    </message>
    <message>
        <source>The parcel that the lines run around: a lot, region or place of the project by its name, or the path of a polygon file</source>
        <translation>線が囲む敷地: プロジェクトの敷地・領域・場所の名前、またはポリゴンファイルのパス</translation>
    </message>
    <message>
        <source>Distance from point to point on a line</source>
        <translation>線上の点の間隔</translation>
    </message>
    <message>
        <source>parcel</source>
        <translation>敷地</translation>
    </message>
    <message>
        <source>spacing</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>線</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>線</translation>
    </message>
    <message>
        <source>Distances of the lines from the parcel, with commas: 5, 10</source>
        <translation>敷地から線までの距離(コンマ区切り): 5, 10</translation>
    </message>
</context>
<context>
    <name>noonmark::LiveFacades</name>
    <message>
        <source>Live facades</source>
        <translation>ライブファサード</translation>
    </message>
</context>
<context>
    <name>noonmark::LiveFollower</name>
    <message>
        <source>Live shadow</source>
        <translation>ライブ日影</translation>
    </message>
</context>
<context>
    <name>noonmark::LotEditing</name>
    <message>
        <source>add a corner to %1</source>
        <translation>%1 に角を追加</translation>
    </message>
    <message>
        <source>move a corner of %1</source>
        <translation>%1 の角を移動</translation>
    </message>
    <message>
        <source>move a side of %1</source>
        <translation>%1 の辺を移動</translation>
    </message>
    <message>
        <source>remove a corner of %1</source>
        <translation>%1 の角を削除</translation>
    </message>
</context>
<context>
    <name>noonmark::LotRoadsDialog</name>
    <message>
        <source>North</source>
        <translation>北</translation>
    </message>
    <message>
        <source>Northeast</source>
        <translation>北東</translation>
    </message>
    <message>
        <source>East</source>
        <translation>東</translation>
    </message>
    <message>
        <source>Southeast</source>
        <translation>南東</translation>
    </message>
    <message>
        <source>South</source>
        <translation>南</translation>
    </message>
    <message>
        <source>Southwest</source>
        <translation>南西</translation>
    </message>
    <message>
        <source>West</source>
        <translation>西</translation>
    </message>
    <message>
        <source>Northwest</source>
        <translation>北西</translation>
    </message>
    <message>
        <source>no road</source>
        <translation>道路なし</translation>
    </message>
    <message>
        <source>Roads along %1</source>
        <translation>%1 に接する道路</translation>
    </message>
    <message>
        <source>How wide are the roads, water or railways on each side? Rules about parcels, as in Japan, move the parcel&apos;s line out along them. A side counts for the outermost edges that face within 45 degrees of it.</source>
        <translation>各辺に接する道路、水面、線路の幅はいくらですか? 日本の日影規制のような敷地の規定では、敷地境界線をその分外側へ移します。各方位は、その方向から 45 度以内を向く最も外側の辺に適用されます。</translation>
    </message>
</context>
<context>
    <name>noonmark::MainWindow</name>
    <message>
        <source>Mode</source>
        <translation>モード</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>as in the paper</source>
        <translation>論文の通り</translation>
    </message>
    <message>
        <source>Choose a scenario at the top first. A change to a building begins one: click a building, and drag its arrow or replace it by a tower (Ctrl+T).</source>
        <translation>先に上部でシナリオを選んでください。建物を変更すると始まります。建物をクリックして矢印をドラッグするか、塔に置き換えます (Ctrl+T)。</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>%1 として保存しました</translation>
    </message>
    <message>
        <source>%1[*] - Noonmark</source>
        <translation>%1[*] - Noonmark</translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation>論文の通り</translation>
    </message>
    <message>
        <source>receivers</source>
        <translation>測定点</translation>
    </message>
    <message>
        <source>Time and legend</source>
        <translation>時刻と凡例</translation>
    </message>
    <message>
        <source>The answer is being computed</source>
        <translation>回答を計算しています</translation>
    </message>
    <message>
        <source>Now by shadow accrual maps, studies by inverse accrual maps through the direction graph.
Approximate: the legend states the measured error. Verdicts of reviews stay exact</source>
        <translation>「現在」は影の累積マップ、検討は方向グラフによる逆累積マップを使います。
近似値です。凡例に測定誤差を示します。審査の判定は正確なままです</translation>
    </message>
    <message>
        <source>not as in the paper</source>
        <translation>論文の方法をやめる</translation>
    </message>
</context>
<context>
    <name>noonmark::MapLayer</name>
    <message>
        <source>Painting the map</source>
        <translation>地図を描画中</translation>
    </message>
</context>
<context>
    <name>noonmark::MaskRun</name>
    <message>
        <source>filling shadows of places</source>
        <translation>場所の影を塗っています</translation>
    </message>
</context>
<context>
    <name>noonmark::MassingForm</name>
    <message>
        <source>Podium</source>
        <translation>基壇</translation>
    </message>
    <message>
        <source>One storey to %1; or drag the arrow on the tower, or type a number over the view</source>
        <translation>1 階分から %1。塔の矢印をドラッグするか、表示の上で数字を入力しても可</translation>
    </message>
    <message>
        <source>Fewer than all storeys</source>
        <translation>全階数より少ない数</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>階数</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>基準階</translation>
    </message>
    <message>
        <source>Floor plate</source>
        <translation>基準階面積</translation>
    </message>
    <message>
        <source>Taper, twist</source>
        <translation>先細り・ねじれ</translation>
    </message>
    <message>
        <source>Top above datum</source>
        <translation>上端(基準面から)</translation>
    </message>
    <message>
        <source>Height above ground</source>
        <translation>地盤からの高さ</translation>
    </message>
    <message>
        <source>Turn, taper, twist</source>
        <translation>回転・先細り・ねじり</translation>
    </message>
</context>
<context>
    <name>noonmark::MassingPanel</name>
    <message>
        <source>Name and id of the new building</source>
        <translation>新しい建物の名称と ID</translation>
    </message>
    <message>
        <source>On</source>
        <translation>敷地</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Design tower</source>
        <translation>塔を設計</translation>
    </message>
    <message>
        <source>Designs a tower on this lot; building it demolishes the buildings on the lot</source>
        <translation>この敷地に塔を設計。建設すると敷地の建物は除却されます</translation>
    </message>
    <message>
        <source>Draw lot</source>
        <translation>敷地を描く</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>建設</translation>
    </message>
    <message>
        <source>Adds the tower to the scenario, as one undo step (Enter over the view)</source>
        <translation>塔をシナリオに加える。取り消しは 1 回 (表示の上で Enter)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Leaves the scenario unchanged (Esc over the view)</source>
        <translation>シナリオを変えない (表示の上で Esc)</translation>
    </message>
    <message>
        <source>No lots yet: draw one</source>
        <translation>敷地がありません: 描いてください</translation>
    </message>
    <message>
        <source>Copy tower here</source>
        <translation>タワーをここへコピー</translation>
    </message>
    <message>
        <source>Sets the tower that is selected or being designed on this lot too, with its storeys, plate areas and setbacks, turned as the lot is</source>
        <translation>選択中または設計中のタワーを、階数・床面積・セットバックを保ち、敷地の向きに合わせてこの敷地にも置きます</translation>
    </message>
    <message>
        <source>Sunlight of its facades</source>
        <translation>ファサードの日照</translation>
    </message>
    <message>
        <source>Shows the hours of shadow on the tower&apos;s facades, coarsely while it changes. Click other buildings in the view to see their facades too. Bays and storeys are those of the study&apos;s form.</source>
        <translation>タワーのファサードの日影時間を表示します(変更中は粗く)。ビューで他の建物をクリックすると、そのファサードも表示します。スパンと階高は検討フォームの値です。</translation>
    </message>
    <message>
        <source>Change of shadow</source>
        <translation>影の変化</translation>
    </message>
    <message>
        <source>Shows where the tower adds shadow to the baseline, or takes it away, instead of all shadow with it. A pin marks the worst spot.</source>
        <translation>タワーを含む影全体の代わりに、比較の基準に対して影が増える場所と減る場所を示します。ピンは最も影響の大きい地点です。</translation>
    </message>
    <message>
        <source>Edit lot</source>
        <translation>敷地を編集</translation>
    </message>
    <message>
        <source>Shows the lot&apos;s corners and sides as handles that are dragged.
A click on the middle of a side adds a corner, Delete removes the selected one.</source>
        <translation>敷地の角と辺をドラッグできるハンドルとして表示します。
辺の中央をクリックすると角を追加し、Delete で選択した角を削除します。</translation>
    </message>
    <message>
        <source>Click corners on the ground (Shift: at right angles to the last side; Ctrl: without snapping),
or type the length of a side and press Enter.
Double click, Enter or right click finishes, Backspace removes the last corner.</source>
        <translation>地面で角をクリックする(Shift: 直前の辺に直角、Ctrl: スナップなし)か、
辺の長さを入力して Enter を押します。
ダブルクリック、Enter または右クリックで完了、Backspace で最後の角を取り消します。</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Edit tower</source>
        <translation>タワーを編集</translation>
    </message>
    <message>
        <source>Designs the tower on this lot further, with the values it was built with</source>
        <translation>この敷地のタワーを、建てたときの値から引き続き設計します</translation>
    </message>
    <message>
        <source>Takes the nearest value with which the tower can be built</source>
        <translation>タワーを建てられる最も近い値を使います</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1 を使う</translation>
    </message>
    <message>
        <source>Draw a lot on the ground, or click a building and make a lot from its footprint. Ctrl+T replaces the building that is selected by a tower.</source>
        <translation>地面に敷地を描くか、建物をクリックしてその外形から敷地を作ります。Ctrl+T は選んだ建物をタワーに置き換えます。</translation>
    </message>
    <message>
        <source>The project&apos;s lots, and those of buildings that towers have replaced</source>
        <translation>プロジェクトの敷地と、タワーが置き換えた建物の敷地</translation>
    </message>
    <message>
        <source>A part of the tower stands outside the study&apos;s region, which alone is measured.</source>
        <translation>タワーの一部が検討範囲の外にあります。測定されるのは範囲内だけです。</translation>
    </message>
    <message>
        <source>The tower stands outside the study&apos;s region, which alone is measured.</source>
        <translation>タワーが検討範囲の外にあります。測定されるのは範囲内だけです。</translation>
    </message>
    <message>
        <source>Move the region here</source>
        <translation>範囲をここへ移動</translation>
    </message>
    <message>
        <source>Studies, comparisons and exports then measure the ground around the tower</source>
        <translation>検討・比較・書き出しはタワーの周りの地面を測定するようになります</translation>
    </message>
</context>
<context>
    <name>noonmark::MassingPreview</name>
    <message>
        <source>Reading the files...</source>
        <translation>ファイルを読み込んでいます...</translation>
    </message>
    <message>
        <source>The files hold no buildings.</source>
        <translation>ファイルに建物がありません。</translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s); heights: %2.
Lowest %3, median %4, tallest %5.</source>
        <translation>
            <numerusform>建物 %1 棟。高さ: %2。
最低 %3、中央値 %4、最高 %5。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 below the ground</source>
        <translation>地面より %1 下</translation>
    </message>
</context>
<context>
    <name>noonmark::MeshPlacing</name>
    <message>
        <source>Reading %1</source>
        <translation>%1 を読み込み中</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 を読み込む</translation>
    </message>
</context>
<context>
    <name>noonmark::MessageBar</name>
    <message>
        <source>Shows or hides the other lines of this message</source>
        <translation>このメッセージの残りの行を表示/非表示</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>このメッセージを閉じる</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>少なく</translation>
    </message>
    <message numerus="yes">
        <source>%1 more line(s)</source>
        <translation>
            <numerusform>あと %1 行</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::MomentPreview</name>
    <message>
        <source>Computing %1</source>
        <translation>%1 を計算中</translation>
    </message>
</context>
<context>
    <name>noonmark::MovieActions</name>
    <message>
        <source>Export &amp;movie...</source>
        <translation>動画を書き出す(&amp;M)...</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>The shadows of a day, of a year, or of the change by a scenario, as MP4 or GIF</source>
        <translation>1 日、1 年、またはシナリオによる変化の影を MP4 か GIF に</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 と %2 の比較</translation>
    </message>
    <message>
        <source>Shadow: %1</source>
        <translation>日影: %1</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>動画</translation>
    </message>
    <message numerus="yes">
        <source>Movie of %1 frame(s) saved as %2</source>
        <translation>
            <numerusform>%1 コマの動画を %2 として保存しました</numerusform>
        </translation>
    </message>
    <message>
        <source>Filming the view</source>
        <translation>表示を撮影しています</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
</context>
<context>
    <name>noonmark::MovieDialog</name>
    <message>
        <source>Export movie</source>
        <translation>動画を書き出す</translation>
    </message>
    <message>
        <source>What changes from frame to frame</source>
        <translation>コマごとに変わるもの</translation>
    </message>
    <message>
        <source>Shadows of one day</source>
        <translation>1 日の影</translation>
    </message>
    <message>
        <source>Shadows at one time through the year</source>
        <translation>同じ時刻の 1 年の影</translation>
    </message>
    <message>
        <source>From baseline to scenario</source>
        <translation>比較基準からシナリオへ</translation>
    </message>
    <message>
        <source> min of the day in each frame</source>
        <translation> 分/コマ</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>動画</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>What changes and what its shadows reach, or the places</source>
        <translation>変わる所とその影の届く所、または場所</translation>
    </message>
    <message>
        <source>The region of the study</source>
        <translation>検討範囲</translation>
    </message>
    <message>
        <source>Small pictures make small files, which matters for GIF</source>
        <translation>小さい画像はファイルも小さく、GIF では重要です</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 画素</translation>
    </message>
    <message>
        <source> frames per second</source>
        <translation> コマ/秒</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>題名</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>書き出す...</translation>
    </message>
    <message>
        <source>Asks for a file: MP4 for players, GIF for pages and mail</source>
        <translation>ファイルを指定: MP4 は再生ソフト、GIF はウェブやメール向け</translation>
    </message>
    <message>
        <source>Shadows at one time through the period</source>
        <translation>同じ時刻の期間中の影</translation>
    </message>
    <message>
        <source>What all frames show: a map, or the view from where its camera stands</source>
        <translation>全コマが示すもの: 地図、またはカメラの位置からの表示</translation>
    </message>
    <message>
        <source>The ground that the view shows</source>
        <translation>ビューに見える地面</translation>
    </message>
    <message>
        <source>The view in 3D, as it is shown</source>
        <translation>表示中のままの 3D ビュー</translation>
    </message>
</context>
<context>
    <name>noonmark::OpenOptions</name>
    <message>
        <source>Open with options</source>
        <translation>設定して開く</translation>
    </message>
    <message>
        <source>Read the files with these settings</source>
        <translation>この設定でファイルを読み込む</translation>
    </message>
    <message>
        <source>Add terrain or surface model...</source>
        <translation>地形または表面モデルを追加...</translation>
    </message>
    <message>
        <source>Reads elevations together with the buildings. Of a surface model and a terrain, missing heights are the difference.</source>
        <translation>標高を建物と一緒に読み込みます。表面モデルと地形があれば、その差を欠けている高さとします。</translation>
    </message>
    <message>
        <source>Listing fields</source>
        <translation>フィールドを一覧にしています</translation>
    </message>
    <message>
        <source>Reading for the preview</source>
        <translation>プレビュー用に読み込み中</translation>
    </message>
</context>
<context>
    <name>noonmark::OpeningActions</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近のファイルを開く(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;New project from a city...</source>
        <translation>都市から新規プロジェクト(&amp;N)...</translation>
    </message>
    <message>
        <source>Footprints, CityJSON, meshes, terrain; several files are combined into one city</source>
        <translation>建物外形、CityJSON、メッシュ、地形。複数のファイルは 1 つの都市にまとめます</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>開く(&amp;O)...</translation>
    </message>
    <message>
        <source>A project, or city files, from which a new project is created</source>
        <translation>プロジェクト、または新規プロジェクトの元になる都市ファイル</translation>
    </message>
    <message>
        <source>Open &amp;with options...</source>
        <translation>設定して開く(&amp;W)...</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>For files without location, unit or heights</source>
        <translation>位置、単位、高さのないファイル用</translation>
    </message>
    <message>
        <source>&amp;Central Park South</source>
        <translation>&amp;Central Park South</translation>
    </message>
    <message>
        <source>The park, its streets and the towers of the case study</source>
        <translation>公園と街路、事例研究の塔</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>格子(&amp;G)</translation>
    </message>
    <message>
        <source>A synthetic city of blocks and lots</source>
        <translation>街区と敷地からなる合成都市</translation>
    </message>
    <message>
        <source>The time zone %1 is a guess; %2 is also nearby.</source>
        <translation>タイムゾーン %1 は推定です。%2 も近くにあります。</translation>
    </message>
    <message>
        <source>Open with options...</source>
        <translation>設定して開く...</translation>
    </message>
    <message>
        <source>Open samp&amp;le</source>
        <translation>サンプルを開く(&amp;L)</translation>
    </message>
    <message>
        <source>%1 is a terrain: it holds no buildings.</source>
        <translation>%1 は地形で、建物を含みません。</translation>
    </message>
    <message>
        <source>Add to the city</source>
        <translation>都市に追加</translation>
    </message>
    <message>
        <source>Open alone</source>
        <translation>単独で開く</translation>
    </message>
    <message numerus="yes">
        <source>%1 far building(s) left out of the first view.</source>
        <translation>
            <numerusform>遠くの建物 %1 棟を除外しています。</numerusform>
        </translation>
    </message>
    <message>
        <source>Zoom to all</source>
        <translation>全体を表示</translation>
    </message>
    <message>
        <source>Open a folder of city files</source>
        <translation>都市ファイルのフォルダーを開く</translation>
    </message>
    <message numerus="yes">
        <source>%1 terrain(s) in the folder are not in the city: %2.</source>
        <translation>
            <numerusform>フォルダーの地形 %1 件が都市に含まれていません: %2。</numerusform>
        </translation>
    </message>
    <message>
        <source>Add terrain</source>
        <translation>地形を追加</translation>
    </message>
    <message>
        <source>Changed in reading: %1</source>
        <translation>読み込み時の変更: %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
</context>
<context>
    <name>noonmark::OtherScenario</name>
    <message>
        <source>Showing %1</source>
        <translation>%1 を表示中</translation>
    </message>
</context>
<context>
    <name>noonmark::PeriodForm</name>
    <message>
        <source>From sunrise to sunset</source>
        <translation>日の出から日没まで</translation>
    </message>
    <message>
        <source>Time zone and sun</source>
        <translation>タイムゾーンと太陽</translation>
    </message>
    <message>
        <source>First day of the period, local date in the time zone</source>
        <translation>期間の初日、タイムゾーンの日付</translation>
    </message>
    <message>
        <source>IANA time zone of the wall clock, daylight saving included.
Set to that of the nearest city when a file is opened: check it near borders.</source>
        <translation>時刻の IANA タイムゾーン。夏時間を含みます。
ファイルを開くと最寄りの都市のものになります。境界付近では確認してください。</translation>
    </message>
    <message>
        <source>Use sunrise and sunset instead of clock times</source>
        <translation>時刻の代わりに日の出と日没を使う</translation>
    </message>
    <message>
        <source>On: the air lifts the sun a little near the horizon (refraction).
Off: the sun&apos;s geometric position, as some rules require</source>
        <translation>オン: 大気が地平線近くの太陽を少し持ち上げます (大気差)。
オフ: 太陽の幾何学的位置。これを求める規定もあります</translation>
    </message>
    <message>
        <source>Wall-clock time at which each day&apos;s hours begin, hours:minutes</source>
        <translation>各日の時間が始まる時刻 (時:分)</translation>
    </message>
</context>
<context>
    <name>noonmark::PeriodSweep</name>
    <message>
        <source>sweeping horizons</source>
        <translation>地平線を走査しています</translation>
    </message>
</context>
<context>
    <name>noonmark::PhotographActions</name>
    <message>
        <source>Aer&amp;ial photograph...</source>
        <translation>航空写真(&amp;I)...</translation>
    </message>
    <message>
        <source>An orthophoto or a scanned map with its position, drawn on the ground of the view, on maps and on sheets</source>
        <translation>位置情報を持つオルソ画像や地図画像を、表示の地面、地図、図面に描きます</translation>
    </message>
    <message>
        <source>Aerial photo&amp;graph</source>
        <translation>航空写真(&amp;G)</translation>
    </message>
    <message>
        <source>Shows or hides the aerial photograph</source>
        <translation>航空写真を表示または非表示にします</translation>
    </message>
    <message>
        <source>Reading the photograph</source>
        <translation>航空写真を読み込み中</translation>
    </message>
    <message>
        <source>aerial photograph</source>
        <translation>航空写真</translation>
    </message>
    <message>
        <source>remove aerial photograph</source>
        <translation>航空写真を削除</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 tile(s) are missing and stay empty</source>
        <translation>
            <numerusform>%2 枚中 %1 枚のタイルがなく、空白のままです</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::PhotographDialog</name>
    <message>
        <source>Draw it</source>
        <translation>描画する</translation>
    </message>
    <message>
        <source>Aerial photograph</source>
        <translation>航空写真</translation>
    </message>
    <message>
        <source>(c) owner of the photograph, year</source>
        <translation>(c) 写真の所有者、年</translation>
    </message>
    <message>
        <source>Whose photograph it is; printed on maps, sheets and pictures that show it</source>
        <translation>写真の権利者。写真を含む地図、図面、画像に印刷されます</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How much it covers streets, parks and water below it</source>
        <translation>下の道路、公園、水面をどれだけ覆うか</translation>
    </message>
    <message>
        <source>On the ground of the view, on maps and on sheets</source>
        <translation>表示の地面、地図、図面に</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Attribution</source>
        <translation>出典</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Choose file...</source>
        <translation>ファイルを選択...</translation>
    </message>
    <message>
        <source>A GeoTIFF or Erdas Imagine file with its position, of 8 bits per colour</source>
        <translation>位置情報を持つ GeoTIFF または Erdas Imagine ファイル(1色8ビット)</translation>
    </message>
    <message>
        <source>From tiles...</source>
        <translation>タイルから...</translation>
    </message>
    <message>
        <source>Fetches tiles of the web&apos;s map scheme from an address that you state</source>
        <translation>指定したアドレスからウェブ地図形式のタイルを取得します</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Takes the photograph out of the project; its file stays</source>
        <translation>写真をプロジェクトから外します。ファイルは残ります</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceActions</name>
    <message>
        <source>Read &amp;places...</source>
        <translation>場所を読み込む(&amp;P)...</translation>
    </message>
    <message>
        <source>Parks, playgrounds, school grounds... from OpenStreetMap or any file of polygons</source>
        <translation>公園、遊び場、校庭などを OpenStreetMap やポリゴンのファイルから</translation>
    </message>
    <message>
        <source>Draw p&amp;lace</source>
        <translation>場所を描く(&amp;L)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>Click corners on the ground; Enter finishes, Esc cancels</source>
        <translation>地面の角をクリック。Enter で終了、Esc で中止</translation>
    </message>
    <message>
        <source>Creates a place from the selected building&apos;s outline</source>
        <translation>選択した建物の外形から場所を作る</translation>
    </message>
    <message>
        <source>P&amp;laces</source>
        <translation>場所(&amp;L)</translation>
    </message>
    <message>
        <source>Reading places</source>
        <translation>場所を読み込み中</translation>
    </message>
    <message>
        <source>read places</source>
        <translation>場所の読み込み</translation>
    </message>
    <message>
        <source>draw place</source>
        <translation>場所の作図</translation>
    </message>
    <message>
        <source>place from building</source>
        <translation>建物から場所</translation>
    </message>
    <message>
        <source>Place from b&amp;uilding outline</source>
        <translation>建物外形から場所(&amp;U)</translation>
    </message>
    <message>
        <source>Read s&amp;treets</source>
        <translation>道路を読み込む(&amp;T)</translation>
    </message>
    <message>
        <source>Streets from OpenStreetMap as places, cut at their junctions, carriageway and sidewalks apart</source>
        <translation>OpenStreetMap の道路を場所として読み込みます。交差点で区切り、車道と歩道を分けます</translation>
    </message>
    <message>
        <source>Shows names of places</source>
        <translation>場所の名前を表示します</translation>
    </message>
    <message>
        <source>Outlines of all places</source>
        <translation>すべての場所の輪郭</translation>
    </message>
    <message>
        <source>Without it, the outline of the chosen place is shown, and of the one under the cursor</source>
        <translation>オフの場合、選択した場所とカーソル下の場所の輪郭だけを表示します</translation>
    </message>
    <message>
        <source>Add to the &amp;city...</source>
        <translation>都市に追加(&amp;C)...</translation>
    </message>
    <message>
        <source>Choose a file...</source>
        <translation>ファイルを選ぶ...</translation>
    </message>
    <message>
        <source>Which layer of %1 holds the places?</source>
        <translation>%1 のどのレイヤに場所がありますか?</translation>
    </message>
    <message>
        <source>A terrain, an aerial photograph, trees, or parks and other places; what the city has stays</source>
        <translation>地形、航空写真、樹木、公園などの場所を追加します。都市にあるものはそのまま残ります</translation>
    </message>
    <message>
        <source>%1 is drawn as %2; a right click on it in Project changes its kind.</source>
        <translation>%1 を %2 として描きました。「プロジェクト」で右クリックすると種類を変えられます。</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceCharts</name>
    <message>
        <source>Timelines</source>
        <translation>時系列</translation>
    </message>
    <message>
        <source>Hours of the year in shadow</source>
        <translation>1 年の影の時間</translation>
    </message>
    <message>
        <source>Shadow by month</source>
        <translation>月別の日影</translation>
    </message>
    <message>
        <source>%1 measured. Clock: %2.</source>
        <translation>測定 %1。時刻: %2。</translation>
    </message>
    <message>
        <source>Incremental shadow: share of the place</source>
        <translation>増加日影: 場所に占める割合</translation>
    </message>
    <message>
        <source>Shadow in the scenario: share of the place</source>
        <translation>シナリオの影: 場所に占める割合</translation>
    </message>
    <message>
        <source>Day of the year across, time of day upwards; not counted: the sun is down, or outside the rule&apos;s hours</source>
        <translation>横は日、縦は時刻。対象外: 太陽が沈んでいるか規定の時間外</translation>
    </message>
    <message>
        <source>Area × hours in shadow by month</source>
        <translation>月別の面積 × 影の時間</translation>
    </message>
    <message>
        <source>The measured half of the year stands for both halves: each month counts twice</source>
        <translation>測定した半年が両方の半年を表し、各月は二度数えます</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceEvaluation</name>
    <message>
        <source>The rule is about windows, not about places</source>
        <translation>この規定は窓に関するもので、場所には関しません</translation>
    </message>
    <message>
        <source>The place has no cell where shadow is measured</source>
        <translation>この場所には影を測定するセルがありません</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceFile</name>
    <message>
        <source>reading places</source>
        <translation>場所を読み込んでいます</translation>
    </message>
    <message>
        <source>repairing outlines</source>
        <translation>輪郭を修復しています</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceLinks</name>
    <message>
        <source>Outdated: places have changed</source>
        <translation>古い結果: 場所が変わりました</translation>
    </message>
    <message>
        <source>Outdated: buildings, trees or places have changed</source>
        <translation>最新ではありません: 建物、樹木、または場所が変わりました</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceList</name>
    <message>
        <source>Find a place</source>
        <translation>場所を探す</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Tick all places</source>
        <translation>すべての場所を選ぶ</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Tick no place</source>
        <translation>場所の選択を外す</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s) ticked</source>
        <translation>
            <numerusform>%2 か所中 %1 か所を選択</numerusform>
        </translation>
    </message>
    <message>
        <source>In reach</source>
        <translation>到達範囲</translation>
    </message>
    <message>
        <source>Tick the places that the proposal&apos;s shadow reaches, found anew for each proposal</source>
        <translation>提案の影が届く場所を選びます(提案ごとに求め直します)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s) in reach of the shadow; the others&apos; tooltips say why not</source>
        <translation>
            <numerusform>%2 か所のうち %1 か所に影が届きます。他の場所の理由はツールチップにあります</numerusform>
        </translation>
    </message>
    <message>
        <source>Only those in reach of the shadow; they are being found</source>
        <translation>影が届く場所のみ(検索中)</translation>
    </message>
    <message>
        <source>What the place is that is drawn, of the kinds that the rule is about</source>
        <translation>描く場所の種類（規則が対象とするもの）</translation>
    </message>
    <message>
        <source>Draw place</source>
        <translation>場所を描く</translation>
    </message>
    <message>
        <source>Click the place&apos;s corners on the ground; double click or Enter finishes. Its name can then be typed in the list.</source>
        <translation>地面で場所の角をクリックし、ダブルクリックか Enter で終えます。名前は一覧で入力できます。</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceSorter</name>
    <message>
        <source>further places: %1</source>
        <translation>その他の場所: %1</translation>
    </message>
    <message>
        <source>%1: pieces of less than %2</source>
        <translation>%1: %2 未満の断片</translation>
    </message>
    <message>
        <source>%1, pieces of less than %2</source>
        <translation>%1、%2 未満の断片</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceSunModel</name>
    <message>
        <source>%1, h</source>
        <translation>%1、時間</translation>
    </message>
    <message>
        <source>Hours of sun on this day, mean over the place</source>
        <translation>この日の日照時間 (場所の平均)</translation>
    </message>
    <message>
        <source>%1 &lt; %2 h, %</source>
        <translation>%1 &lt; %2 時間、%</translation>
    </message>
    <message>
        <source>Share of the area with less than %1 h of sun on this day</source>
        <translation>この日の日照が %1 時間未満の面積の割合</translation>
    </message>
    <message>
        <source>%1 (baseline: %2)</source>
        <translation>%1 (比較基準: %2)</translation>
    </message>
    <message>
        <source>%1 without a name</source>
        <translation>名称のない%1</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>%1 (here: %2 h)</source>
        <translation>%1（ここでは %2 h）</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>備考</translation>
    </message>
    <message>
        <source>Minutes of sun a day more than in the baseline, mean over the days and the place; negative: less</source>
        <translation>比較基準より増えた 1 日の日照の分数（日と場所の平均）。負は減少</translation>
    </message>
    <message>
        <source>≥ %1 h, %</source>
        <translation>%1 h 以上、%</translation>
    </message>
    <message>
        <source>Minutes of shadow a day: the sunlit time without the sun</source>
        <translation>1 日の影 (分): 昼間のうち日の当たらない時間</translation>
    </message>
    <message>
        <source>%1: shadow, min</source>
        <translation>%1: 影 (分)</translation>
    </message>
    <message>
        <source>Minutes of shadow on this day, mean over the place</source>
        <translation>この日の影 (分)、場所の平均</translation>
    </message>
    <message>
        <source>Minutes of shadow a day more than in the baseline, mean over the days and the place; negative: less</source>
        <translation>基準より増える 1 日の影 (分)、日と場所の平均。負は減少</translation>
    </message>
    <message>
        <source>Change of shadow, min</source>
        <translation>影の変化 (分)</translation>
    </message>
    <message>
        <source>≥ %1 h sun, %</source>
        <translation>日照 ≥ %1 h, %</translation>
    </message>
    <message>
        <source>%1 &lt; %2 h sun, %</source>
        <translation>%1 日照 &lt; %2 h, %</translation>
    </message>
    <message>
        <source>%1: change, min</source>
        <translation>%1: 変化、分</translation>
    </message>
    <message>
        <source>%1: change of shadow, min</source>
        <translation>%1: 日陰の変化、分</translation>
    </message>
    <message>
        <source>Minutes more than in the baseline on this day, mean over the place; negative: less (baseline: %1)</source>
        <translation>この日の基準より多い分数(場所の平均)。負は少ないことを示す(基準: %1)</translation>
    </message>
</context>
<context>
    <name>noonmark::PlacesDock</name>
    <message>
        <source>What colours the places: the whole period, one of the dates, or the change against the baseline</source>
        <translation>場所の色分けの内容: 期間全体、いずれかの日、または比較基準に対する変化</translation>
    </message>
    <message>
        <source> h</source>
        <translation> 時間</translation>
    </message>
    <message>
        <source>Lists only places of this kind</source>
        <translation>この種類の場所だけを一覧に表示</translation>
    </message>
    <message>
        <source>By kind</source>
        <translation>種類別</translation>
    </message>
    <message>
        <source>Part of a name</source>
        <translation>名称の一部</translation>
    </message>
    <message>
        <source>Lists only the places whose name contains this text</source>
        <translation>名称にこの文字を含む場所だけを一覧に表示</translation>
    </message>
    <message>
        <source>Places stand below a row of their kind with its means</source>
        <translation>場所を種類の行の下にまとめ、種類の行に平均を示します</translation>
    </message>
    <message>
        <source>Click a row to see its place in the view; a click on a place in the view selects its row</source>
        <translation>行のクリックでその場所をビューに表示。ビューで場所をクリックするとその行を選択します</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>すべての種類</translation>
    </message>
    <message>
        <source>Whole period</source>
        <translation>期間全体</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変化</translation>
    </message>
    <message>
        <source>%1: no cell on open ground</source>
        <translation>%1: 建物のない地面のセルなし</translation>
    </message>
    <message>
        <source>%1: %2 h of sun a day</source>
        <translation>%1: 日照 1 日 %2 時間</translation>
    </message>
    <message>
        <source>No places measured: choose &quot;Sun by place&quot; in the panel Study</source>
        <translation>測定した場所がありません。「検討」パネルで「場所別の日照」を選んでください</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s)</source>
        <translation>
            <numerusform>%2 か所中 %1 か所</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 lose more than a minute of sun a day</source>
        <translation>%1 か所で日照が 1 日 1 分を超えて減ります</translation>
    </message>
    <message>
        <source>%1 have less than %2 h of sun a day</source>
        <translation>%1 か所で日照が 1 日 %2 時間未満</translation>
    </message>
    <message>
        <source>%1 have less than %2 h of sun on %3</source>
        <translation>%1 か所で %3 の日照が %2 時間未満</translation>
    </message>
    <message numerus="yes">
        <source>%1 place(s)</source>
        <translation>
            <numerusform>%1 か所</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s) listed</source>
        <translation>
            <numerusform>%2 か所中 %1 か所を表示</numerusform>
        </translation>
    </message>
    <message>
        <source>Places with less sun a day than this are violet, others orange, unless the legend has other colours</source>
        <translation>1 日の日照がこれより少ない場所は紫、ほかは橙です（凡例に別の色がない場合）</translation>
    </message>
    <message>
        <source>Who shades it</source>
        <translation>影を落とす建物</translation>
    </message>
    <message>
        <source>Shows which buildings take sun from the chosen place, and how much. Or double-click its row</source>
        <translation>選択した場所の日照を奪う建物とその量を表示します。行のダブルクリックでも表示します</translation>
    </message>
    <message>
        <source>Measured error against rays: %1</source>
        <translation>光線に対する計測誤差：%1</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1：%3 中 %2</translation>
    </message>
    <message>
        <source>%1: %2 min of sun a day less</source>
        <translation>%1: 日照が 1 日 %2 分減少</translation>
    </message>
    <message>
        <source>%1: %2 min of sun a day more</source>
        <translation>%1: 日照が 1 日 %2 分増加</translation>
    </message>
    <message>
        <source>%1. Headline and shares of the area are for %2 h, as they were saved</source>
        <translation>%1。見出しと面積の割合は、保存時の %2 時間によるものです</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Shows this answer in the view and in the results again</source>
        <translation>この回答を表示と結果にもう一度出します</translation>
    </message>
    <message>
        <source>The view shows another result than %1</source>
        <translation>表示中の結果は %1 ではありません</translation>
    </message>
    <message>
        <source>Sun by place</source>
        <translation>場所ごとの日照</translation>
    </message>
    <message>
        <source>Shadow by place</source>
        <translation>場所ごとの影</translation>
    </message>
    <message>
        <source>hours of sun a day</source>
        <translation>1 日の日照時間</translation>
    </message>
    <message>
        <source>minutes of shadow a day</source>
        <translation>1 日の影 (分)</translation>
    </message>
    <message>
        <source>Change of sun by place</source>
        <translation>場所ごとの日照の変化</translation>
    </message>
    <message>
        <source>Change of shadow by place</source>
        <translation>場所ごとの影の変化</translation>
    </message>
    <message>
        <source>minutes of sun a day</source>
        <translation>1 日の日照 (分)</translation>
    </message>
    <message>
        <source>%1: %2 min of shadow a day</source>
        <translation>%1: 1 日の影 %2 分</translation>
    </message>
    <message>
        <source>%1: %2 min of shadow a day more</source>
        <translation>%1: 影が 1 日 %2 分増</translation>
    </message>
    <message>
        <source>%1: %2 min of shadow a day less</source>
        <translation>%1: 影が 1 日 %2 分減</translation>
    </message>
    <message>
        <source>Only these</source>
        <translation>これらのみ</translation>
    </message>
    <message>
        <source>Lists only the places that this sentence counts</source>
        <translation>この文が数える場所だけを一覧にする</translation>
    </message>
    <message>
        <source> h of sun</source>
        <translation> h (日照)</translation>
    </message>
    <message>
        <source>%1 get more than a minute of shadow a day more</source>
        <translation>%1 で 1 日の影が 1 分を超えて増える</translation>
    </message>
    <message>
        <source>%1 have more than %2 min of shadow a day</source>
        <translation>%1 で 1 日の影が %2 分を超える</translation>
    </message>
    <message>
        <source>%1 have more than %2 min of shadow on %3</source>
        <translation>%1 で %3 の影が %2 分を超える</translation>
    </message>
    <message>
        <source>%1, %2 without figures</source>
        <translation>%1、値のないもの %2</translation>
    </message>
    <message>
        <source>%1. A saved answer states its dates as sun</source>
        <translation>%1。保存された回答の日付は日照で示されます</translation>
    </message>
    <message>
        <source>Which trees count in the table, the map and the headline</source>
        <translation>表・地図・見出しで樹木が日照を遮るかどうか</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source> h of shade</source>
        <translation> 時間の日陰</translation>
    </message>
    <message>
        <source>&lt; </source>
        <translation>&lt; </translation>
    </message>
    <message>
        <source>any shade</source>
        <translation>すべての日陰</translation>
    </message>
    <message>
        <source>Counts and lists the places with less shade than this, instead of those with too little sun</source>
        <translation>日照が足りない場所の代わりに、これより日陰の少ない場所を数えて一覧にします</translation>
    </message>
    <message>
        <source>%1 have less than %2 h of shade a day</source>
        <translation>%1 は 1 日の日陰が %2 時間未満です</translation>
    </message>
    <message>
        <source>%1 have less than %2 h of shade on %3</source>
        <translation>%1 は %3 の日陰が %2 時間未満です</translation>
    </message>
</context>
<context>
    <name>noonmark::PlacesForm</name>
    <message>
        <source>The project has no places. Read some (Study &gt; Read places...) or draw one.</source>
        <translation>プロジェクトに場所がありません。読み込む (検討 &gt; 場所を読み込む...) か、描いてください。</translation>
    </message>
    <message>
        <source> h</source>
        <translation> 時間</translation>
    </message>
    <message>
        <source>Places of the ticked kinds are measured, all in one run</source>
        <translation>チェックした種類の場所をすべて 1 回の計算で測ります</translation>
    </message>
    <message>
        <source>The share of each place with so many hours of sun a day is stated</source>
        <translation>1 日の日照がこの時間以上の割合を場所ごとに示します</translation>
    </message>
    <message>
        <source>Days on which the hours of sun of each place are stated, too, with commas between</source>
        <translation>場所ごとの日照時間を示す日も指定。コンマで区切ります</translation>
    </message>
    <message>
        <source>Enough sun</source>
        <translation>十分な日照</translation>
    </message>
    <message>
        <source>Dates</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>All scenarios</source>
        <translation>全シナリオ</translation>
    </message>
    <message>
        <source>Measures the places in all scenarios and compares each with the baseline, which is chosen at the top</source>
        <translation>すべてのシナリオで場所を測定し、上で選んだ比較基準とそれぞれ比べます</translation>
    </message>
    <message>
        <source>Own regions %1</source>
        <translation>自分の領域 %1</translation>
    </message>
    <message>
        <source>Read streets</source>
        <translation>道路を読み込む</translation>
    </message>
    <message>
        <source>Adds the streets of the city&apos;s OpenStreetMap file, cut at their junctions, carriageway and sidewalks apart</source>
        <translation>都市の OpenStreetMap ファイルの道路を追加します。交差点で区切り、車道と歩道を分けます</translation>
    </message>
</context>
<context>
    <name>noonmark::PlacingPanel</name>
    <message>
        <source>Build</source>
        <translation>建設</translation>
    </message>
    <message>
        <source>Scale of all three axes</source>
        <translation>3 軸の縮尺</translation>
    </message>
    <message>
        <source>Adds it to the scenario (Enter over the view)</source>
        <translation>シナリオに加える (表示の上で Enter)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>倍率</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>%1: click the place on the ground for its middle.</source>
        <translation>%1: 中心を置く地面をクリック。</translation>
    </message>
    <message>
        <source> (and %1 more)</source>
        <translation> (ほか %1 件)</translation>
    </message>
    <message>
        <source>Floor to floor, %1 to %2, for lines at its floors; 0: not known</source>
        <translation>階高、%1~%2(階の線に使う)。0: 不明</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Storey height</source>
        <translation>階高</translation>
    </message>
    <message>
        <source>%1, top %2. Another click moves it.</source>
        <translation>%1、上端 %2。もう一度クリックすると移動します。</translation>
    </message>
    <message>
        <source>° east</source>
        <translation>° 東</translation>
    </message>
    <message>
        <source>° north</source>
        <translation>° 北</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>再読み込み</translation>
    </message>
    <message>
        <source>Puts the file in the place of its earlier edition; the edits that follow stay</source>
        <translation>ファイルを以前の版と置き換えます。その後の編集は残ります</translation>
    </message>
    <message>
        <source>Clockwise, seen from above. Of an IFC that states its true north, preset from it</source>
        <translation>上から見て時計回り。真北を示す IFC ではその値が初期値です</translation>
    </message>
    <message>
        <source>Where its middle stands; a click on the ground sets it, too</source>
        <translation>中心の位置。地面をクリックしても設定できます</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>%1: an earlier version of this file is in the scenario as %2. Reload replaces it; Build adds another.</source>
        <translation>%1: 以前の版が %2 として建っています。「再読み込み」はその場で置き換え、「建設」はもう一つ追加します。</translation>
    </message>
</context>
<context>
    <name>noonmark::PlateField</name>
    <message>
        <source>Whole lot</source>
        <translation>敷地全体</translation>
    </message>
    <message>
        <source>Share of the lot</source>
        <translation>敷地に占める割合</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>A smaller plate keeps the lot&apos;s shape, inset from all sides</source>
        <translation>小さい階は敷地の形を保ち、全辺で後退します</translation>
    </message>
    <message>
        <source> sq ft</source>
        <translation> 平方フィート</translation>
    </message>
</context>
<context>
    <name>noonmark::PointDock</name>
    <message>
        <source>In the sun on %1: %2
In the year: %3 h of %4 h
Sky view factor: %5</source>
        <translation>%1 の日照: %2
年間: %4 時間中 %3 時間
天空率: %5</translation>
    </message>
    <message>
        <source>
Vertical sky component: %1 %</source>
        <translation>
鉛直天空光成分: %1 %</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>保存...</translation>
    </message>
    <message>
        <source>The drawing as SVG or PNG, or the minutes by month and hour as CSV</source>
        <translation>図は SVG か PNG、月別・時刻別の分は CSV</translation>
    </message>
    <message>
        <source>Right-click the ground, a roof or a wall and choose Sun and sky here.</source>
        <translation>地面、屋根、壁を右クリックし、「ここの太陽と天空」を選んでください。</translation>
    </message>
    <message>
        <source>Before: %1
%2

After: %3
%4</source>
        <translation>変更前: %1
%2

変更後: %3
%4</translation>
    </message>
    <message>
        <source>%1 min on the day and %2 h in the year with their seasons; %3 min and %4 h as evergreens</source>
        <translation>季節に応じて、その日 %1 分、年間 %2 時間。常緑として %3 分、%4 時間</translation>
    </message>
    <message>
        <source>
With trees: %1</source>
        <translation>
樹木を含む: %1</translation>
    </message>
    <message>
        <source>
Sky view factor with trees: %1 with their seasons, %2 as evergreens</source>
        <translation>
樹木を含む天空率: 季節変化あり %1、常緑として %2</translation>
    </message>
    <message>
        <source>
Vertical sky component with trees: %1 % and %2 %</source>
        <translation>
樹木を含む鉛直天空光成分: %1 % と %2 %</translation>
    </message>
    <message>
        <source>Trees that take most sun, with their seasons:</source>
        <translation>最も日照を遮る樹木(季節変化あり):</translation>
    </message>
    <message>
        <source>%1: %2 min on the day, %3 h in the year</source>
        <comment>a tree, and the sun it takes</comment>
        <translation>%1: この日 %2 分、年間 %3 時間</translation>
    </message>
    <message numerus="yes">
        <source>and %1 more tree(s)</source>
        <translation>
            <numerusform>ほか %1 本</numerusform>
        </translation>
    </message>
    <message>
        <source>
In the sun on %1, %2: %3</source>
        <comment>a day, trees as evergreens, times</comment>
        <translation>
%1 に日が当たる時間、%2: %3</translation>
    </message>
</context>
<context>
    <name>noonmark::PointInspector</name>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
</context>
<context>
    <name>noonmark::PointListForm</name>
    <message>
        <source>Click points</source>
        <translation>点をクリック</translation>
    </message>
    <message>
        <source>Click the ground, roofs or walls in the view: each click adds a point. Press again to end</source>
        <translation>ビューの地面・屋根・壁をクリックするたびに点を追加します。もう一度押すと終了します</translation>
    </message>
    <message>
        <source>Read CSV...</source>
        <translation>CSV を読み込む...</translation>
    </message>
    <message>
        <source>Replaces the list by a CSV file with columns id, lon, lat, height, facing</source>
        <translation>列 id, lon, lat, height, facing を持つ CSV ファイルで一覧を置き換えます</translation>
    </message>
    <message>
        <source>One point a line: id, longitude, latitude (degrees), metres above the ground, azimuth that a wall faces. Without a height the point is on the ground or roof, without an azimuth it is level</source>
        <translation>1行に1点: ID、経度、緯度(度)、地上高(m)、壁の向く方位角。高さがなければ地面または屋根の上、方位角がなければ水平面です</translation>
    </message>
    <message>
        <source>points</source>
        <translation>点</translation>
    </message>
</context>
<context>
    <name>noonmark::PointScenarios</name>
    <message>
        <source>The scenario before: what the other one is compared with</source>
        <translation>変更前のシナリオ: 比較の基準</translation>
    </message>
    <message>
        <source>The scenario whose sun at the point is compared</source>
        <translation>この点の日照を比較するシナリオ</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>シナリオ</translation>
    </message>
    <message>
        <source>Day, min</source>
        <translation>1日、分</translation>
    </message>
    <message>
        <source>Year, h</source>
        <translation>1年、時間</translation>
    </message>
    <message>
        <source>Change, h</source>
        <translation>変化、時間</translation>
    </message>
    <message>
        <source>Sky view</source>
        <translation>天空率</translation>
    </message>
    <message>
        <source>VSC, %</source>
        <translation>VSC、%</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>変更前</translation>
    </message>
    <message>
        <source>After</source>
        <translation>変更後</translation>
    </message>
    <message>
        <source>the baseline</source>
        <translation>比較基準</translation>
    </message>
    <message>
        <source>the displayed scenario</source>
        <translation>表示中のシナリオ</translation>
    </message>
    <message>
        <source>The point&apos;s sun and sky in every scenario of the project, without trees where a row says nothing else. Copy (Ctrl+C) takes the table</source>
        <translation>プロジェクトの各シナリオでの地点の日照と天空(行に記載がなければ樹木なし)。コピー(Ctrl+C)で表を取り込みます</translation>
    </message>
</context>
<context>
    <name>noonmark::PointShading</name>
    <message>
        <source>weighing crowns at points</source>
        <translation>点での樹冠を評価しています</translation>
    </message>
</context>
<context>
    <name>noonmark::PolygonDrawing</name>
    <message>
        <source>region</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>lot</source>
        <translation>敷地</translation>
    </message>
    <message>
        <source>place</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>first corner: closes the outline</source>
        <translation>最初の角: 外形を閉じる</translation>
    </message>
    <message>
        <source>Length: %1  (Enter)</source>
        <translation>長さ: %1  (Enter)</translation>
    </message>
    <message>
        <source>Length: %1, azimuth: %2° clockwise from north  (Enter)</source>
        <translation>長さ: %1、方位角: 北から時計回りに %2°  (Enter)</translation>
    </message>
</context>
<context>
    <name>noonmark::PreferencesActions</name>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>Language, colours, units, paper and start page</source>
        <translation>言語、配色、単位、用紙、スタートページ</translation>
    </message>
    <message>
        <source>Pr&amp;eferences...</source>
        <translation>環境設定(&amp;E)...</translation>
    </message>
</context>
<context>
    <name>noonmark::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>環境設定</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>システムに合わせる</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>配色</translation>
    </message>
    <message>
        <source>Light or dark; applies at once</source>
        <translation>明るい/暗い。すぐに適用</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>明るい</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>暗い</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Metric: metres</source>
        <translation>メートル法: メートル</translation>
    </message>
    <message>
        <source>Imperial: feet</source>
        <translation>ヤード・ポンド法: フィート</translation>
    </message>
    <message>
        <source>Metric and imperial</source>
        <translation>両方</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>用紙</translation>
    </message>
    <message>
        <source>Of sheets, until you choose another for one of them</source>
        <translation>図面の用紙。個別に選ぶまで使います</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>Of sheets</source>
        <translation>図面の向き</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>縦</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>横</translation>
    </message>
    <message>
        <source>Show the start page when Noonmark starts</source>
        <translation>起動時にスタートページを表示</translation>
    </message>
    <message>
        <source>Only where no file is opened with the program. Help &gt; Start page shows it at any time</source>
        <translation>ファイルを開かずに起動したときだけ。ヘルプ &gt; スタートページ でいつでも表示できます</translation>
    </message>
    <message>
        <source>In which areas, lengths and heights are shown and lengths are typed; applies at once</source>
        <translation>面積・長さ・高さの表示と長さの入力の単位。すぐに適用</translation>
    </message>
    <message>
        <source>Of menus, panels and numbers; applies at once. Files and sheets stay English, and so do errors and warnings that hold a number or a name</source>
        <translation>メニュー、パネル、数字の言語で、すぐに変わります。ファイルとシート、数や名前を含むエラーと警告は英語のままです</translation>
    </message>
</context>
<context>
    <name>noonmark::ProgressStrip</name>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Stop this job; the previous result stays</source>
        <translation>この処理を中止。前の結果は残ります</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>開始中</translation>
    </message>
</context>
<context>
    <name>noonmark::ProjectDock</name>
    <message>
        <source>remove step %1 of %2</source>
        <translation>%2 のステップ %1 を削除</translation>
    </message>
    <message>
        <source>delete %1</source>
        <translation>%1 を削除</translation>
    </message>
    <message>
        <source>duplicate %1</source>
        <translation>%1 を複製</translation>
    </message>
    <message>
        <source>new scenario %1</source>
        <translation>新しいシナリオ %1</translation>
    </message>
    <message>
        <source>change kind of %1</source>
        <translation>%1 の種類を変更</translation>
    </message>
    <message>
        <source>roads along %1</source>
        <translation>%1 の道路</translation>
    </message>
    <message>
        <source>R&amp;oads along it...</source>
        <translation>接する道路(&amp;O)...</translation>
    </message>
    <message>
        <source>&amp;Rename	F2</source>
        <translation>名前を変更(&amp;R)	F2</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>複製(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Remove step	Del</source>
        <translation>ステップを削除(&amp;R)	Del</translation>
    </message>
    <message>
        <source>&amp;Delete	Del</source>
        <translation>削除(&amp;D)	Del</translation>
    </message>
    <message>
        <source>&amp;Compare with this</source>
        <translation>これと比較(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;New scenario from this</source>
        <translation>これから新しいシナリオ(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Starts from</source>
        <translation>出発点(&amp;S)</translation>
    </message>
    <message>
        <source>change base of %1</source>
        <translation>%1 の出発点を変更</translation>
    </message>
    <message>
        <source>&amp;Use as study region</source>
        <translation>検討範囲として使う(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>種類(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>表示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;New scenario</source>
        <translation>新しいシナリオ(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Save the study&apos;s region</source>
        <translation>検討範囲を保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Save the study&apos;s period</source>
        <translation>検討期間を保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Save the displayed result</source>
        <translation>表示中の結果を保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Draw a lot</source>
        <translation>敷地を描く(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Draw a place</source>
        <translation>場所を描く(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Read places from a file...</source>
        <translation>ファイルから場所を読み込む(&amp;R)...</translation>
    </message>
    <message>
        <source>&amp;Save this view</source>
        <translation>この表示を保存(&amp;S)</translation>
    </message>
    <message>
        <source>Edit lot &amp;shape</source>
        <translation>敷地の形を編集(&amp;S)</translation>
    </message>
</context>
<context>
    <name>noonmark::ProjectSaving</name>
    <message>
        <source>Saving %1</source>
        <translation>%1 を保存中</translation>
    </message>
    <message>
        <source>Saving recovery file</source>
        <translation>復元ファイルを保存中</translation>
    </message>
</context>
<context>
    <name>noonmark::ProjectSession</name>
    <message>
        <source>rename %1</source>
        <translation>%1 の名前を変更</translation>
    </message>
    <message>
        <source>add lot %1</source>
        <translation>敷地 %1 を追加</translation>
    </message>
</context>
<context>
    <name>noonmark::R</name>
    <message>
        <source>Weighted shade</source>
        <translation>重み付きの日陰</translation>
    </message>
    <message>
        <source>sum over the steps of weight x hours in shadow x cell area, m2 h over the period; how the weight table is cut into intervals does not change it</source>
        <translation>各ステップの「重み × 影の時間 × セルの面積」の合計（期間の m² h）。重み表の区間の分け方によって変わりません</translation>
    </message>
    <message>
        <source>Shadow score</source>
        <translation>日影スコア</translation>
    </message>
    <message>
        <source>sum over the intervals of the weight table of weight x share of the interval&apos;s sunlit time in shadow, times cell area; an interval that is cut in two counts twice</source>
        <translation>重み表の各区間の「重み × 区間の日照時間のうち影の割合」× セルの面積の合計。二つに分けた区間は二重に数えられます</translation>
    </message>
</context>
<context>
    <name>noonmark::RangePanel</name>
    <message>
        <source>Incremental shadow</source>
        <translation>増加日影</translation>
    </message>
    <message>
        <source>Shadow in the scenario</source>
        <translation>シナリオの日影</translation>
    </message>
    <message>
        <source>Shadow in the baseline</source>
        <translation>比較基準の日影</translation>
    </message>
    <message>
        <source>Shadow by month</source>
        <translation>月別の日影</translation>
    </message>
    <message>
        <source>This rule is about single days. Rules about a range of days, such as san-francisco-295, have a chart by hour and day of the year.</source>
        <translation>この規定は個々の日についてのものです。san-francisco-295 のように日の範囲についての規定には、時刻と日のグラフがあります。</translation>
    </message>
    <message>
        <source>Computing...</source>
        <translation>計算中...</translation>
    </message>
    <message>
        <source>Chart of the range</source>
        <translation>範囲のグラフ</translation>
    </message>
    <message>
        <source>Click a day for its timeline.</source>
        <translation>日をクリックすると時系列を表示。</translation>
    </message>
    <message>
        <source>Area × hours in shadow; each month counts twice, for both halves of the year.</source>
        <translation>面積 × 日影時間。年の前半と後半のため各月を 2 回数えます。</translation>
    </message>
    <message>
        <source>Area × hours in shadow.</source>
        <translation>面積 × 日影時間。</translation>
    </message>
</context>
<context>
    <name>noonmark::ReadingForm</name>
    <message>
        <source>Origin located at</source>
        <translation>原点の位置</translation>
    </message>
    <message>
        <source>° east</source>
        <translation>° 東</translation>
    </message>
    <message>
        <source>° north</source>
        <translation>° 北</translation>
    </message>
    <message>
        <source>Middle of the open city</source>
        <translation>開いている都市の中央</translation>
    </message>
    <message>
        <source>Place and choice of data</source>
        <translation>位置とデータの選択</translation>
    </message>
    <message>
        <source>Geographic location of the mesh&apos;s origin. Required for a mesh opened alone.
Off: at the origin of the city from the other files.</source>
        <translation>メッシュ原点の地理的位置。メッシュだけを開くとき必要です。
オフ: 他のファイルの都市の原点。</translation>
    </message>
    <message>
        <source>Longitude of the mesh&apos;s origin, degrees, east positive, -180 to 180</source>
        <translation>メッシュ原点の経度、度、東が正、-180 から 180</translation>
    </message>
    <message>
        <source>Latitude of the mesh&apos;s origin, degrees, north positive, -90 to 90</source>
        <translation>メッシュ原点の緯度、度、北が正、-90 から 90</translation>
    </message>
    <message>
        <source>Places the mesh&apos;s origin at the middle of the open city</source>
        <translation>メッシュ原点を開いている都市の中央に置く</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>メッシュ（%1）</translation>
    </message>
    <message>
        <source>Heights and names</source>
        <translation>高さと名称</translation>
    </message>
</context>
<context>
    <name>noonmark::RecentMenu</name>
    <message>
        <source>%1, with options</source>
        <translation>%1 (設定付き)</translation>
    </message>
    <message>
        <source>%1, read with %2</source>
        <translation>%1 (%2 で読み込み)</translation>
    </message>
</context>
<context>
    <name>noonmark::RecoveryOffers</name>
    <message>
        <source>Noonmark closed before %1 was saved. Unsaved changes can be recovered.</source>
        <translation>%1 を保存する前に Noonmark が終了しました。未保存の変更を復元できます。</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>復元</translation>
    </message>
    <message>
        <source>Older changes...</source>
        <translation>以前の変更...</translation>
    </message>
    <message>
        <source>There are unsaved changes to %1 from %2. They can be recovered or deleted.</source>
        <translation>%2 の %1 に未保存の変更があります。復元または削除できます。</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Noonmark closed before a project was saved. The unsaved project can be recovered.</source>
        <translation>プロジェクトを保存する前に Noonmark が終了しました。未保存のプロジェクトを復元できます。</translation>
    </message>
</context>
<context>
    <name>noonmark::RegionActions</name>
    <message>
        <source>&amp;Draw region</source>
        <translation>範囲を描く(&amp;D)</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Click corners on the ground; Enter finishes, Esc cancels</source>
        <translation>地面の角をクリック。Enter で終了、Esc で中止</translation>
    </message>
    <message>
        <source>Region from &amp;file...</source>
        <translation>ファイルから範囲(&amp;F)...</translation>
    </message>
    <message>
        <source>Polygons from a file, in any coordinate system</source>
        <translation>任意の座標系のファイルのポリゴン</translation>
    </message>
    <message>
        <source>region</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>draw %1</source>
        <translation>%1 を描く</translation>
    </message>
    <message>
        <source>save region %1</source>
        <translation>範囲 %1 を保存</translation>
    </message>
</context>
<context>
    <name>noonmark::ResultActions</name>
    <message>
        <source>Save &amp;picture...</source>
        <translation>画像を保存(&amp;P)...</translation>
    </message>
    <message>
        <source>Ctrl+P</source>
        <translation>Ctrl+P</translation>
    </message>
    <message>
        <source>The view with its legend, as a PNG file</source>
        <translation>凡例付きの表示を PNG ファイルに</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>書き出す(&amp;E)...</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>The displayed result, all scenarios or the review, as PDF, picture, GeoTIFF, tables and JSON</source>
        <translation>表示中の結果、全シナリオ、または審査を PDF、画像、GeoTIFF、表、JSON に</translation>
    </message>
    <message>
        <source>&amp;Save result</source>
        <translation>結果を保存(&amp;S)</translation>
    </message>
    <message>
        <source>Stores the displayed map and figures in the project</source>
        <translation>表示中の図と数値をプロジェクトに保存</translation>
    </message>
    <message>
        <source>Picture saved as %1</source>
        <translation>画像を %1 として保存しました</translation>
    </message>
    <message>
        <source>Picture copied</source>
        <translation>画像をコピーしました</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 と %2 の比較</translation>
    </message>
    <message>
        <source>&amp;Export (%1)...</source>
        <translation>書き出す (%1)(&amp;E)...</translation>
    </message>
    <message numerus="yes">
        <source>All %1 scenario(s) measured</source>
        <translation>
            <numerusform>測定した全 %1 シナリオ</numerusform>
        </translation>
    </message>
    <message>
        <source>Contributions to the shadow on %1</source>
        <translation>%1 から建物が奪う日照</translation>
    </message>
    <message>
        <source>Picture of the view</source>
        <translation>表示の画像</translation>
    </message>
    <message>
        <source>Table of scenarios: scores, verdicts, sun of places</source>
        <translation>シナリオの表: スコア、判定、場所の日照</translation>
    </message>
</context>
<context>
    <name>noonmark::ResultDisplay</name>
    <message>
        <source>These figures do not include the building being designed. Build it, then run.</source>
        <translation>これらの数値は設計中の建物を含みません。建設してから計算してください。</translation>
    </message>
    <message>
        <source>Outdated figures: buildings have changed; %1.</source>
        <translation>古い数値: 建物が変わりました。%1。</translation>
    </message>
    <message>
        <source>new figures are being computed</source>
        <translation>新しい数値を計算中</translation>
    </message>
    <message>
        <source>run again (Ctrl+R)</source>
        <translation>再計算してください (Ctrl+R)</translation>
    </message>
    <message>
        <source>Outdated figures: settings have changed; run again (Ctrl+R).</source>
        <translation>古い数値: 設定が変わりました。再計算してください (Ctrl+R)。</translation>
    </message>
    <message>
        <source>Outdated score: the weight table has changed; score again.</source>
        <translation>古いスコア: 重み表が変わりました。再計算してください。</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>保存しました: %1</translation>
    </message>
    <message>
        <source>%1 (outdated)</source>
        <translation>%1(古い)</translation>
    </message>
    <message>
        <source>Outdated figures: places have changed; run again (Ctrl+R).</source>
        <translation>古い数値: 場所が変わりました。再計算してください (Ctrl+R)。</translation>
    </message>
</context>
<context>
    <name>noonmark::ResultsDock</name>
    <message>
        <source>Show the study again</source>
        <translation>検討を再表示</translation>
    </message>
    <message>
        <source>Replaces this result by the current study or comparison</source>
        <translation>この結果を現在の検討または比較に替える</translation>
    </message>
    <message>
        <source>No study yet.
Choose what, when and where in the panel Study, and press Run study (Ctrl+R). The answer then stands here.</source>
        <translation>まだ検討がありません。
「検討」パネルで対象、時期、場所を選び、計算 (Ctrl+R) を押してください。答えはここに表示されます。</translation>
    </message>
    <message>
        <source>How this was made</source>
        <translation>計算の方法</translation>
    </message>
    <message>
        <source>Period, engine, error, time, and the command that repeats this result</source>
        <translation>期間、エンジン、誤差、時間、同じ検討を行うコマンド</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>コマンドをコピー</translation>
    </message>
    <message>
        <source>The command line that asks the same of the saved project or of the files</source>
        <translation>保存したプロジェクトまたはファイルで同じ検討を行うコマンドライン</translation>
    </message>
    <message>
        <source>What was repaired, left out or assumed when the data was read</source>
        <translation>データの読み込み時に修復、除外、仮定したもの</translation>
    </message>
    <message>
        <source>The answers of this session and those saved in the project, newest first</source>
        <translation>このセッションの答えとプロジェクトに保存された答え (新しい順)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>書き出す...</translation>
    </message>
    <message numerus="yes">
        <source>%1 warning(s) about the data</source>
        <translation>
            <numerusform>データに関する警告 %1 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Shows the figures of all places again</source>
        <translation>すべての場所の数値を再び表示します</translation>
    </message>
    <message>
        <source>Who shades it</source>
        <translation>影を落とす建物</translation>
    </message>
    <message>
        <source>Shows which buildings take sun from this place, and how much</source>
        <translation>この場所の日照を奪う建物とその量を表示します</translation>
    </message>
    <message numerus="yes">
        <source>Back to all %1 place(s)</source>
        <translation>
            <numerusform>全 %1 か所に戻る</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide this result</source>
        <translation>この結果を隠す</translation>
    </message>
    <message>
        <source>Show an earlier result</source>
        <translation>以前の結果を表示</translation>
    </message>
    <message>
        <source>Which trees count in what is shown here and in the view</source>
        <translation>ここと表示画面で数える樹木</translation>
    </message>
</context>
<context>
    <name>noonmark::ReviewActions</name>
    <message>
        <source>Re&amp;view by a rule...</source>
        <translation>規定による審査(&amp;V)...</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Ctrl+Shift+R</translation>
    </message>
    <message>
        <source>Evaluate the rule of a review board on the places of the project</source>
        <translation>審査機関の規定をプロジェクトの場所に適用</translation>
    </message>
    <message>
        <source>Shows the sheets of the review, and writes them with its tables and drawings</source>
        <translation>審査の図面を表示し、表や作図とともに書き出します</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Export t&amp;he review...</source>
        <translation>審査を書き出す(&amp;H)...</translation>
    </message>
</context>
<context>
    <name>noonmark::ReviewDock</name>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>書き出す...</translation>
    </message>
    <message>
        <source>Copies the table, with all days, as text for a spreadsheet</source>
        <translation>全日の表を表計算用の文字としてコピー</translation>
    </message>
    <message>
        <source>Writes the sheets (PDF), the table (CSV), the data (JSON), and the shadows for CAD and GIS (DXF, GeoPackage)</source>
        <translation>図面 (PDF)、表 (CSV)、データ (JSON)、CAD と GIS 用の影 (DXF, GeoPackage) を書き出す</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>日</translation>
    </message>
    <message>
        <source>Range of days</source>
        <translation>日の範囲</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>規定</translation>
    </message>
    <message>
        <source>Computing the verdicts of the building being designed...</source>
        <translation>設計中の建物の判定を計算しています...</translation>
    </message>
    <message>
        <source>Press Run review to evaluate the rule on the ticked places.</source>
        <translation>「審査する」を押すと、選んだ場所に規定を適用します。</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: %2 compared with %3. %4</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: %2 と %3 の比較。%4</translation>
    </message>
    <message>
        <source>&lt;br&gt;&lt;i&gt;Follows the building being designed.&lt;/i&gt;</source>
        <translation>&lt;br&gt;&lt;i&gt;設計中の建物に追従します。&lt;/i&gt;</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2。</translation>
    </message>
    <message>
        <source>Click a row of the table to see its timeline.</source>
        <translation>表の行をクリックすると時系列を表示。</translation>
    </message>
    <message>
        <source>The timeline of a place appears here after a review.</source>
        <translation>場所の時系列は審査の後に表示されます。</translation>
    </message>
    <message>
        <source>Build the tower, then run the review, to see its range of days.</source>
        <translation>塔を建設して審査すると日の範囲が表示されます。</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>未確認</translation>
    </message>
    <message>
        <source>How Noonmark reads what the rule leaves open</source>
        <translation>規定にない点の Noonmark の解釈</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1, steps of %2 min, cells of %3 m, %4, %5&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1, ステップ %2 分, セル %3 m, %4, %5&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Rule files that are left out</source>
        <translation>除外した規定ファイル</translation>
    </message>
    <message>
        <source>&lt;h4&gt;Figures with status and source&lt;/h4&gt;</source>
        <translation>&lt;h4&gt;数値の状態と出典&lt;/h4&gt;</translation>
    </message>
    <message>
        <source>A rule about windows has no timeline: click a row to read when its window has sun.</source>
        <translation>窓についての規則に時間経過はありません。行をクリックすると、その窓に日が当たる時間が表示されます。</translation>
    </message>
    <message>
        <source>Press Run review to evaluate the rule on the windows.</source>
        <translation>「審査を実行」を押すと、窓について規則を評価します。</translation>
    </message>
    <message>
        <source>Press Run review to see which places fail as the city stands, or design a tower.</source>
        <translation>「審査する」を押すと、現況の都市で不適合となる場所がわかります。または塔を設計してください。</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: %2 as it stands. %3</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: %2 の現状。%3</translation>
    </message>
    <message>
        <source>The project holds %1, see the list of Results. Run review shows its places and timelines again.</source>
        <translation>プロジェクトには %1 があります（「結果」の一覧）。審査を実行すると場所と時系列が再び表示されます。</translation>
    </message>
</context>
<context>
    <name>noonmark::ReviewForm</name>
    <message>
        <source>Run review</source>
        <translation>審査する</translation>
    </message>
    <message>
        <source>Evaluate the rule on the ticked places, or on the windows</source>
        <translation>チェックした場所または窓について規則を評価します</translation>
    </message>
    <message>
        <source>Expected time: %1</source>
        <translation>予想時間: %1</translation>
    </message>
</context>
<context>
    <name>noonmark::ReviewSession</name>
    <message>
        <source>Review</source>
        <translation>審査</translation>
    </message>
    <message>
        <source>Estimating</source>
        <translation>見積もり中</translation>
    </message>
    <message>
        <source>the building being designed</source>
        <translation>設計中の建物</translation>
    </message>
    <message>
        <source>Live review</source>
        <translation>ライブ審査</translation>
    </message>
    <message>
        <source>Not up to date: a building is being designed. Build it, then run.</source>
        <translation>最新ではありません: 建物を設計中です。建設してから審査してください。</translation>
    </message>
    <message>
        <source>Not up to date. %1</source>
        <translation>最新ではありません。%1</translation>
    </message>
    <message>
        <source>Not up to date: buildings or scenarios have changed. Run again.</source>
        <translation>最新ではありません: 建物かシナリオが変わりました。再審査してください。</translation>
    </message>
    <message>
        <source>Not up to date: rule, places, time zone or year have changed. Run again.</source>
        <translation>最新ではありません: 規定、場所、タイムゾーン、年のいずれかが変わりました。再審査してください。</translation>
    </message>
    <message>
        <source>All reviews</source>
        <translation>すべての審査</translation>
    </message>
    <message>
        <source>Finding places in reach</source>
        <translation>影が届く場所を検索中</translation>
    </message>
</context>
<context>
    <name>noonmark::RuleForm</name>
    <message>
        <source>Rule</source>
        <translation>規定</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>比較基準</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>シナリオ</translation>
    </message>
    <message>
        <source>What the proposal is compared with. The rule asks for: %1</source>
        <translation>計画案の比較対象。規定の要求: %1</translation>
    </message>
    <message>
        <source>Displayed: %1</source>
        <translation>表示中: %1</translation>
    </message>
    <message>
        <source>%1 (not where the site is)</source>
        <translation>%1（敷地の国のものではない）</translation>
    </message>
</context>
<context>
    <name>noonmark::RunForecast</name>
    <message>
        <source>Estimating</source>
        <translation>見積もり中</translation>
    </message>
</context>
<context>
    <name>noonmark::SampleProgress</name>
    <message>
        <source>measuring the error on a sample</source>
        <translation>標本で誤差を測定しています</translation>
    </message>
</context>
<context>
    <name>noonmark::SavedViews</name>
    <message>
        <source>Sa&amp;ved views</source>
        <translation>保存した表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Save this view</source>
        <translation>この表示を保存(&amp;S)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>No view is saved yet</source>
        <translation>保存した表示はまだありません</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>save view %1</source>
        <translation>表示 %1 を保存</translation>
    </message>
    <message>
        <source>Saved as &apos;%1&apos; in the project. F2 in the project&apos;s list renames it.</source>
        <translation>プロジェクトに「%1」として保存しました。プロジェクトの一覧で F2 を押すと名前を変えられます。</translation>
    </message>
    <message>
        <source>Camera, projection, section box, and date and time if a moment is shown, under a name in the project</source>
        <translation>カメラ、投影、断面ボックス、時点を表示中なら日時も、名前を付けてプロジェクトに保存します</translation>
    </message>
</context>
<context>
    <name>noonmark::SavingActions</name>
    <message>
        <source>&amp;Save project</source>
        <translation>プロジェクトを保存(&amp;S)</translation>
    </message>
    <message>
        <source>City, scenarios, lots, results and view in one file</source>
        <translation>都市、シナリオ、敷地、結果、視点を 1 つのファイルに</translation>
    </message>
    <message>
        <source>Save project &amp;as...</source>
        <translation>名前を付けて保存(&amp;A)...</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>%1 として保存しました</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>名前を付けて保存...</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存の変更</translation>
    </message>
    <message>
        <source>Save changes to %1?</source>
        <translation>%1 の変更を保存しますか?</translation>
    </message>
    <message>
        <source>Work in progress</source>
        <translation>処理中</translation>
    </message>
    <message>
        <source>%1 is still running. Stop it?</source>
        <translation>%1 はまだ実行中です。中止しますか?</translation>
    </message>
    <message>
        <source>Stop it</source>
        <translation>中止する</translation>
    </message>
    <message>
        <source>%1 is still running and will be stopped.</source>
        <translation>%1 はまだ実行中で、中止されます。</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioActions</name>
    <message>
        <source>&amp;New scenario</source>
        <translation>新しいシナリオ(&amp;N)</translation>
    </message>
    <message>
        <source>Starts from the existing city</source>
        <translation>現況の都市から始めます</translation>
    </message>
    <message>
        <source>New scenario &amp;from this one</source>
        <translation>このシナリオから新規作成(&amp;F)</translation>
    </message>
    <message>
        <source>Starts from the displayed scenario and inherits its later changes</source>
        <translation>表示中のシナリオから始め、その後の変更も引き継ぎます</translation>
    </message>
    <message>
        <source>&amp;Compare with the existing city</source>
        <translation>現況の都市と比較(&amp;C)</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Shows how many minutes of shadow the scenario adds or removes</source>
        <translation>シナリオが増減させる日影の分を表示</translation>
    </message>
    <message>
        <source>&amp;Measure all scenarios</source>
        <translation>全シナリオを測定(&amp;M)</translation>
    </message>
    <message>
        <source>Runs the same study for each scenario, for comparison side by side</source>
        <translation>各シナリオに同じ検討を行い、並べて比較</translation>
    </message>
    <message>
        <source>&amp;Score all scenarios</source>
        <translation>全シナリオを採点(&amp;S)</translation>
    </message>
    <message>
        <source>Computes the scores that the panel Scenarios lacks, with the table that the panel Weights shows</source>
        <translation>「シナリオ」パネルに欠けているスコアを「重み」パネルの表で計算します</translation>
    </message>
    <message>
        <source>&amp;Review all scenarios</source>
        <translation>全シナリオを審査(&amp;R)</translation>
    </message>
    <message>
        <source>Reviews the scenarios whose verdicts the panel Scenarios lacks, by the rule chosen in the panel Review</source>
        <translation>「シナリオ」パネルに判定のないシナリオを、「審査」パネルで選んだ規定で審査します</translation>
    </message>
    <message>
        <source>The table of scenarios is on the clipboard</source>
        <translation>シナリオの表をクリップボードにコピーしました</translation>
    </message>
    <message>
        <source>The existing city is displayed. Choose a scenario at the top, and compare it</source>
        <translation>現況の都市を表示中です。上部でシナリオを選んで比較してください</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>%1 として保存しました</translation>
    </message>
    <message>
        <source>&amp;Export buildings...</source>
        <translation>建物を書き出す(&amp;E)...</translation>
    </message>
    <message>
        <source>Writes the buildings that the displayed scenario proposes as glTF, OBJ, DXF or GeoPackage; of the existing city all buildings</source>
        <translation>表示中のシナリオが提案する建物を glTF、OBJ、DXF、GeoPackage で書き出します。現況の都市ではすべての建物を書き出します</translation>
    </message>
    <message>
        <source>Export buildings</source>
        <translation>建物を書き出す</translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s) saved as %2</source>
        <translation>
            <numerusform>%1 棟の建物を %2 として保存しました</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no scenario yet to compare. A change to a building begins one: click a building, and drag its arrow or type its height</source>
        <translation>比較するシナリオがまだありません。建物を変えるとシナリオが始まります。建物をクリックし、矢印をドラッグするか高さを入力してください</translation>
    </message>
    <message>
        <source>The table of scenarios compares the scores</source>
        <translation>シナリオの表で評点を比較します</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioBar</name>
    <message>
        <source>The displayed scenario. Edits are added to it; on the existing city they start a new scenario</source>
        <translation>表示中のシナリオ。変更はここに加わり、現況の都市では新しいシナリオになります</translation>
    </message>
    <message>
        <source>Compare the scenario with this baseline: more or fewer minutes of shadow</source>
        <translation>シナリオをこの基準と比較: 日影の分の増減</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>シナリオ</translation>
    </message>
    <message>
        <source>compare with</source>
        <translation>比較対象</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioCharts</name>
    <message>
        <source>No scenario has been scored by month: press Score all</source>
        <translation>月別に採点したシナリオがありません。「すべて採点」を押してください</translation>
    </message>
    <message>
        <source>The first %1 of %2 scenarios; CSV saves all of them</source>
        <translation>%2 件中最初の %1 件のシナリオ。CSV にはすべて保存されます</translation>
    </message>
    <message>
        <source>No differences: the baseline %1 lacks this figure</source>
        <translation>差はありません：比較基準 %1 にこの値がありません</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Saves all figures of the months of all scenarios, with their differences to the baseline</source>
        <translation>すべてのシナリオの月別の値を、比較基準との差とともに保存します</translation>
    </message>
    <message>
        <source>A chart of the months of all scenarios, and of their differences to the baseline</source>
        <translation>すべてのシナリオの月別のグラフと、比較基準との差のグラフ</translation>
    </message>
    <message>
        <source>No chart</source>
        <translation>グラフなし</translation>
    </message>
    <message>
        <source>All of these together</source>
        <translation>これらすべて</translation>
    </message>
    <message>
        <source>No scenario has months yet. %1</source>
        <translation>まだ月別の結果を持つシナリオがありません。%1</translation>
    </message>
    <message>
        <source>Measure all by month</source>
        <translation>すべてを月別に測定</translation>
    </message>
    <message>
        <source>No places have been measured: choose Sun by place in the panel Study, and press Measure all</source>
        <translation>場所はまだ測定されていません。「解析」パネルで「場所ごとの日照」を選び、「すべて測定」を押してください</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioTable</name>
    <message>
        <source>Scenario</source>
        <translation>シナリオ</translation>
    </message>
    <message>
        <source>Double-click to show it</source>
        <translation>ダブルクリックで表示</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>変更</translation>
    </message>
    <message>
        <source>Steps from the existing city, including those of its bases</source>
        <translation>現況の都市からのステップ (元のシナリオを含む)</translation>
    </message>
    <message>
        <source>Floor area by use</source>
        <translation>用途別床面積</translation>
    </message>
    <message>
        <source>Gross floor area of the scenario&apos;s towers by use, sorted by its sum. Imported buildings and towers whose height was changed afterwards are not counted</source>
        <translation>シナリオのタワーの用途別延床面積。合計で並べ替えます。読み込んだ建物と、後から高さを変えたタワーは数えません</translation>
    </message>
    <message>
        <source>Height, %1</source>
        <translation>高さ, %1</translation>
    </message>
    <message>
        <source>Highest point above its ground of the buildings that the scenario adds</source>
        <translation>シナリオが追加する建物の地盤からの最高点</translation>
    </message>
    <message>
        <source>Floor area, %1</source>
        <translation>床面積, %1</translation>
    </message>
    <message>
        <source>Gross floor area of the scenario&apos;s towers. Imported buildings and towers whose height was changed afterwards are not counted</source>
        <translation>シナリオのタワーの延床面積。読み込んだ建物と、後から高さを変えたタワーは数えません</translation>
    </message>
    <message>
        <source>Impact, %1</source>
        <translation>影響, %1</translation>
    </message>
    <message>
        <source>Change of the shadow area from the chosen baseline, else from the existing city, on the receivers of both</source>
        <translation>選んだ比較基準（なければ既存の街）に対する日影面積の変化。両方に共通する測定点について</translation>
    </message>
    <message>
        <source>Verdicts</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>By the rule and the baseline that the panel Review shows; sorted by the number that fail, then by borderline ones</source>
        <translation>「審査」パネルの規定と比較基準による。不適合の数、次に境界の数で並べ替えます</translation>
    </message>
    <message>
        <source>The scenario adds no building</source>
        <translation>このシナリオは建物を追加しません</translation>
    </message>
    <message>
        <source>Not computed with the current settings: press Measure all</source>
        <translation>現在の設定では未計算: 「すべて測定」を押してください</translation>
    </message>
    <message>
        <source>With the weights %1</source>
        <translation>重み %1 による</translation>
    </message>
    <message>
        <source>Not computed with these settings and the weights %1 since buildings last changed: press Score all</source>
        <translation>建物の最後の変更以降、この設定と重み %1 では未計算: 「すべて採点」を押してください</translation>
    </message>
    <message>
        <source>%1, compared with %2</source>
        <translation>%1、%2 との比較</translation>
    </message>
    <message>
        <source>Not reviewed by the rule %1 since buildings or places last changed: press Review all</source>
        <translation>建物または場所の最後の変更以降、規定 %1 では未審査: 「すべて審査」を押してください</translation>
    </message>
    <message>
        <source>The other scenarios are compared with this one</source>
        <translation>他のシナリオはこれと比較されます</translation>
    </message>
    <message>
        <source>Not compared with %1 with these settings since buildings last changed: press Measure all</source>
        <translation>建物の最後の変更以降、この設定では %1 と未比較: 「すべて測定」を押してください</translation>
    </message>
    <message>
        <source>Compared with %1. Ground whose gross shadow changes by more than %2 min a day:
%3</source>
        <translation>%1 との比較。累計日影が 1 日 %2 分を超えて変化する地面:
%3</translation>
    </message>
    <message>
        <source>Measured earlier and saved with the project: press Measure all for the maps</source>
        <translation>以前に測定し、プロジェクトに保存されています。地図は「すべて測定」で作成します</translation>
    </message>
    <message>
        <source>not scored</source>
        <translation>スコアなし</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>比較なし</translation>
    </message>
    <message>
        <source>not reviewed</source>
        <translation>未審査</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>測定なし</translation>
    </message>
    <message>
        <source>no baseline</source>
        <translation>比較基準なし</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>未集計</translation>
    </message>
    <message>
        <source>starting scenario missing</source>
        <translation>元のシナリオなし</translation>
    </message>
    <message>
        <source>no weights</source>
        <translation>重みなし</translation>
    </message>
    <message>
        <source>no rule</source>
        <translation>規定なし</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失敗</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>要再計算</translation>
    </message>
    <message>
        <source>Best of this column</source>
        <translation>この列の最良値</translation>
    </message>
    <message>
        <source>Measured error against rays: %1</source>
        <translation>光線に対する計測誤差：%1</translation>
    </message>
    <message>
        <source>%1 changes the shadow area by %2: area times its share of the sunlit time. Ground with over %3 min more shadow a day: %4.</source>
        <translation>%1 による日影面積の変化は %2（面積 × 可照時間に占める割合）。影が 1 日 %3 分を超えて増える地面: %4。</translation>
    </message>
    <message>
        <source>All scenarios change the shadow area by %1.</source>
        <translation>どのシナリオでも日影面積の変化は %1 です。</translation>
    </message>
    <message>
        <source>%1 adds less shadow than %2: %3 of shadow area against %4 (area times its share of the sunlit time), and %5 against %6 of ground with over %7 min more a day.</source>
        <translation>%1 が加える影は %2 より少なくなります: 日影面積は %3 に対し %4（面積 × 可照時間に占める割合）、1 日 %7 分を超えて増える地面は %5 に対し %6。</translation>
    </message>
    <message>
        <source>By the weights %1, %2 scores best (%3) and %4 worst (%5).</source>
        <translation>重み %1 では、スコアが最もよいのは %2 (%3)、最も悪いのは %4 (%5) です。</translation>
    </message>
    <message>
        <source>being scored</source>
        <translation>採点中</translation>
    </message>
    <message>
        <source>being reviewed</source>
        <translation>審査中</translation>
    </message>
    <message>
        <source>being measured</source>
        <translation>計測中</translation>
    </message>
    <message>
        <source>Sun of places, h</source>
        <translation>場所の日照、時間</translation>
    </message>
    <message>
        <source>Area of places with enough sun, %</source>
        <translation>十分な日照がある場所の面積、%</translation>
    </message>
    <message numerus="yes">
        <source>Over the area of the %Ln place(s) that were measured last</source>
        <translation>
            <numerusform>最後に測定した %Ln か所の面積について</numerusform>
        </translation>
    </message>
    <message>
        <source>Not measured since buildings last changed: choose Sun by place in the panel Study, and press Measure all</source>
        <translation>建物が最後に変わってから測定されていません。「解析」パネルで「場所ごとの日照」を選び、「すべて測定」を押してください</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenariosDock</name>
    <message>
        <source>Only the existing city so far. Select a building and change it, or design a tower on a lot: the first change begins a scenario, which is listed here.</source>
        <translation>まだ現況の都市だけです。建物を選んで変更するか敷地に塔を設計すると、最初の変更でシナリオが始まり、ここに表示されます。</translation>
    </message>
    <message>
        <source>Measure all</source>
        <translation>すべて測定</translation>
    </message>
    <message>
        <source>Runs the study for scenarios without figures, with the current period and region</source>
        <translation>数値のないシナリオを現在の期間と範囲で検討</translation>
    </message>
    <message>
        <source>Score all</source>
        <translation>すべて採点</translation>
    </message>
    <message>
        <source>Computes the missing scores with the table that the panel Weights shows</source>
        <translation>欠けているスコアを「重み」パネルの表で計算します</translation>
    </message>
    <message>
        <source>Review all</source>
        <translation>すべて審査</translation>
    </message>
    <message>
        <source>Reviews the scenarios without verdicts by the rule, the baseline and the places that are chosen in the panel Review</source>
        <translation>判定のないシナリオを、「審査」パネルで選んだ規定・比較基準・場所で審査します</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>差</translation>
    </message>
    <message>
        <source>Shows figures as differences to the baseline: the chosen one, else the existing city</source>
        <translation>数値を比較基準との差で表示。比較基準は選んだもの、なければ現況の都市</translation>
    </message>
    <message>
        <source>Shade is wanted</source>
        <translation>影が望ましい</translation>
    </message>
    <message>
        <source>The star marks the scenario with most shadow as the best, not that with least</source>
        <translation>星印を、影の最も少ないシナリオではなく最も多いシナリオに付けます</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copies the table for a spreadsheet</source>
        <translation>表を表計算用にコピー</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Saves the table with what each scenario lacks, in metres and square metres</source>
        <translation>各シナリオに欠けているものを含む表を、メートルと平方メートルで保存</translation>
    </message>
</context>
<context>
    <name>noonmark::SearchActions</name>
    <message>
        <source>&amp;Find</source>
        <translation>検索(&amp;F)</translation>
    </message>
    <message>
        <source>A building by name or id, a street, a place, a lot, a position or a command</source>
        <translation>名前または ID による建物、通り、場所、敷地、位置、またはコマンド</translation>
    </message>
    <message>
        <source>Nothing is called &quot;%1&quot;, and no command that can be used now. Buildings without a name are found by their id.</source>
        <translation>「%1」という名前のものも、今使えるコマンドもありません。名前のない建物は ID で見つかります。</translation>
    </message>
</context>
<context>
    <name>noonmark::SearchField</name>
    <message>
        <source>Find (Ctrl+F)</source>
        <translation>検索 (Ctrl+F)</translation>
    </message>
    <message>
        <source>A building by name or id, a street, a place, a lot, a position such as 40.7536, -73.9832, or a command</source>
        <translation>名前または ID による建物、通り、場所、敷地、40.7536, -73.9832 のような位置、またはコマンド</translation>
    </message>
</context>
<context>
    <name>noonmark::SectionDialog</name>
    <message>
        <source>Section box</source>
        <translation>断面ボックス</translation>
    </message>
    <message>
        <source>West</source>
        <translation>西</translation>
    </message>
    <message>
        <source>East</source>
        <translation>東</translation>
    </message>
    <message>
        <source>South</source>
        <translation>南</translation>
    </message>
    <message>
        <source>North</source>
        <translation>北</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>下端</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上端</translation>
    </message>
    <message>
        <source>From the origin of the project, to the east and to the north</source>
        <translation>プロジェクトの原点から東および北へ</translation>
    </message>
    <message>
        <source>Height above the origin of the project</source>
        <translation>プロジェクトの原点からの高さ</translation>
    </message>
    <message>
        <source>What the view shows</source>
        <translation>ビューに見える範囲</translation>
    </message>
    <message>
        <source>The box around the ground in view</source>
        <translation>見えている地面を囲む箱</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>リセット</translation>
    </message>
    <message>
        <source>The box around the whole city</source>
        <translation>都市全体を囲む箱</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>解除</translation>
    </message>
    <message>
        <source>Shows everything again</source>
        <translation>すべてを再び表示します</translation>
    </message>
</context>
<context>
    <name>noonmark::SelectionPanel</name>
    <message>
        <source>Import mesh...</source>
        <translation>メッシュを読み込む...</translation>
    </message>
    <message>
        <source>Demolish</source>
        <translation>除却</translation>
    </message>
    <message>
        <source>Removes the building (Delete)</source>
        <translation>建物を取り除く (Delete)</translation>
    </message>
    <message>
        <source>Replace by tower</source>
        <translation>塔に置き換え</translation>
    </message>
    <message>
        <source>Replaces it by a tower on its lot or, if it has none, on its footprint</source>
        <translation>敷地の上、なければ外形の上の塔に置き換える</translation>
    </message>
    <message>
        <source>Lot from footprint</source>
        <translation>外形から敷地</translation>
    </message>
    <message>
        <source>Creates a lot from its outline on the ground</source>
        <translation>地面の外形から敷地を作る</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Drag the building over the ground; Esc ends the tool</source>
        <translation>建物を地面の上でドラッグ。Esc で終了</translation>
    </message>
    <message>
        <source>Clockwise about its middle. Press Enter to apply</source>
        <translation>中心まわりに時計回り。Enter で適用</translation>
    </message>
    <message>
        <source>Negative: west, south. Press Enter to apply</source>
        <translation>負: 西、南。Enter で適用</translation>
    </message>
    <message>
        <source>Move east</source>
        <translation>東へ移動</translation>
    </message>
    <message>
        <source>Move north</source>
        <translation>北へ移動</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Same floor area on its lot:</source>
        <translation>敷地に同じ延べ面積で:</translation>
    </message>
    <message>
        <source>Wider</source>
        <translation>広く</translation>
    </message>
    <message>
        <source>Shorter, on a floor plate twice as large</source>
        <translation>基準階を 2 倍にして低く</translation>
    </message>
    <message>
        <source>Widest</source>
        <translation>最大幅</translation>
    </message>
    <message>
        <source>As short as the lot allows</source>
        <translation>敷地が許す限り低く</translation>
    </message>
    <message>
        <source>Slimmer</source>
        <translation>細く</translation>
    </message>
    <message>
        <source>Taller, on half the floor plate</source>
        <translation>基準階を半分にして高く</translation>
    </message>
    <message>
        <source>%1 to %2 above the ground; View &gt; Heights above datum shows it as an elevation. Or drag the arrow on the building. Press Enter to apply</source>
        <translation>地盤から %1~%2。表示 &gt; 基準面からの高さ で標高として示す。または建物の矢印をドラッグ。Enter で適用</translation>
    </message>
    <message>
        <source>Top above datum</source>
        <translation>上端(基準面から)</translation>
    </message>
    <message>
        <source>Height above ground</source>
        <translation>地盤からの高さ</translation>
    </message>
    <message>
        <source>Demolish all</source>
        <translation>すべて除却</translation>
    </message>
    <message>
        <source>Removes the selected buildings, as one step of undo (Delete)</source>
        <translation>選択した建物をまとめて除却します。1 回で元に戻せます (Delete)</translation>
    </message>
    <message>
        <source>Click a building in the view to select it. Ctrl+click selects another too, a drag with Ctrl+Shift all in a rectangle.</source>
        <translation>ビューの建物をクリックして選択します。Ctrl+クリックで追加、Ctrl+Shift を押しながらドラッグすると矩形内のすべてを選択します。</translation>
    </message>
    <message>
        <source>Adds a building from a file (%1), placed by a click on the ground</source>
        <translation>ファイル（%1）から建物を追加します。地面をクリックして配置します</translation>
    </message>
    <message>
        <source>Edit tower</source>
        <translation>タワーを編集</translation>
    </message>
    <message>
        <source>Designs the tower further, with the values it was built with</source>
        <translation>タワーを、建てたときの値から引き続き設計します</translation>
    </message>
</context>
<context>
    <name>noonmark::SetbackTable</name>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Add setback</source>
        <translation>セットバックを追加</translation>
    </message>
    <message>
        <source>Above each height the walls are set back by the inset, from bottom to top; taper and twist are those of the volume above it</source>
        <translation>各高さより上で壁が後退する(下から上へ)。先細りとねじれはその上のボリュームのもの</translation>
    </message>
    <message>
        <source>Height from which the walls are set back</source>
        <translation>壁が後退し始める高さ</translation>
    </message>
    <message>
        <source>How far every wall is set back, from the top of the volume below</source>
        <translation>下のボリュームの上端から各壁が後退する距離</translation>
    </message>
    <message>
        <source>Adds a setback above the others</source>
        <translation>ほかより上にセットバックを追加します</translation>
    </message>
    <message>
        <source>Removes the selected setback, or the last one</source>
        <translation>選択したセットバック、または最後のセットバックを削除します</translation>
    </message>
</context>
<context>
    <name>noonmark::ShadowCache::State</name>
    <message>
        <source>filling shadows</source>
        <translation>影を塗っています</translation>
    </message>
</context>
<context>
    <name>noonmark::ShadowProjection</name>
    <message>
        <source>filling shadows</source>
        <translation>影を塗っています</translation>
    </message>
</context>
<context>
    <name>noonmark::SheetForm</name>
    <message>
        <source>Page</source>
        <translation>ページ</translation>
    </message>
    <message>
        <source>Title block (saved in the project)</source>
        <translation>表題欄 (プロジェクトに保存)</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>用紙</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>縦</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>横</translation>
    </message>
    <message>
        <source>Scale of diagrams</source>
        <translation>図の縮尺</translation>
    </message>
    <message>
        <source>A scale from 1:%1 to 1:%2 may be typed. Where a place or its shadows are larger than the paper at that scale, the diagram shows the part around the place.</source>
        <translation>1:%1 から 1:%2 の縮尺を入力できます。場所や影が用紙より大きいときは、その周りだけを示します。</translation>
    </message>
    <message>
        <source>fits the page</source>
        <translation>ページに合わせる</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Of areas, lengths and heights</source>
        <translation>面積、長さ、高さの単位</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>ロゴ</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>選択...</translation>
    </message>
    <message>
        <source>A PNG or JPEG picture of at most 1 MiB</source>
        <translation>1 MiB 以下の PNG か JPEG 画像</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Sheets without a logo</source>
        <translation>ロゴなしの図面</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
</context>
<context>
    <name>noonmark::StartPage</name>
    <message>
        <source>Open a city</source>
        <translation>都市を開く</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Closes the start page (Esc)</source>
        <translation>スタートページを閉じます (Esc)</translation>
    </message>
    <message>
        <source>Drop files or a folder here: OpenStreetMap, GeoPackage, CityJSON, CityGML, IFC, meshes, terrain.</source>
        <translation>ファイルまたはフォルダーをここにドロップ: OpenStreetMap、GeoPackage、CityJSON、CityGML、IFC、メッシュ、地形。</translation>
    </message>
    <message>
        <source>Open file...</source>
        <translation>ファイルを開く...</translation>
    </message>
    <message>
        <source>A project or city files (Ctrl+O)</source>
        <translation>プロジェクトまたは都市ファイル (Ctrl+O)</translation>
    </message>
    <message>
        <source>Open folder...</source>
        <translation>フォルダーを開く...</translation>
    </message>
    <message>
        <source>A folder of city files, such as tiles or a file geodatabase</source>
        <translation>タイルやファイルジオデータベースなど、都市ファイルのフォルダー</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近のファイル</translation>
    </message>
    <message>
        <source>No longer there: %1</source>
        <translation>見つかりません: %1</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>サンプル</translation>
    </message>
    <message>
        <source>Central Park South</source>
        <translation>Central Park South</translation>
    </message>
    <message>
        <source>The park, its streets and the towers of the case study</source>
        <translation>公園と街路、事例研究の塔</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>格子</translation>
    </message>
    <message>
        <source>A synthetic city of blocks and lots</source>
        <translation>街区と敷地からなる合成都市</translation>
    </message>
    <message>
        <source>Guided tours and help</source>
        <translation>ガイドツアーとヘルプ</translation>
    </message>
    <message>
        <source>User guide (F1)</source>
        <translation>ユーザーガイド (F1)</translation>
    </message>
    <message>
        <source>How to study, compare and review</source>
        <translation>検討、比較、審査のしかた</translation>
    </message>
    <message>
        <source>What do you want to know?</source>
        <translation>何を知りたいですか？</translation>
    </message>
    <message>
        <source>Of which city?</source>
        <translation>どの都市について？</translation>
    </message>
</context>
<context>
    <name>noonmark::StudyActions</name>
    <message>
        <source>&amp;Run</source>
        <translation>計算(&amp;R)</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Compute the shadow in the region</source>
        <translation>範囲の日影を計算</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>Ctrl+.</source>
        <translation>Ctrl+.</translation>
    </message>
    <message>
        <source>Stop the study that is running</source>
        <translation>実行中の検討を止める</translation>
    </message>
    <message>
        <source>Show &amp;gross shadow</source>
        <translation>累計日影を表示(&amp;G)</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>Minutes in shadow per day</source>
        <translation>1 日の日影の分</translation>
    </message>
    <message>
        <source>Show c&amp;ontinuous shadow</source>
        <translation>連続日影を表示(&amp;O)</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>Longest unbroken run in shadow</source>
        <translation>途切れない最長の日影</translation>
    </message>
    <message>
        <source>period</source>
        <translation>期間</translation>
    </message>
    <message>
        <source>save period %1</source>
        <translation>期間 %1 を保存</translation>
    </message>
    <message>
        <source>%1 was compared with %2 when the project was saved. Run (Ctrl+R) repeats the comparison, in %3.</source>
        <translation>保存時に %1 を %2 と比較していました。計算 (Ctrl+R) で %3 かけて再現します。</translation>
    </message>
    <message>
        <source>A study was shown when the project was saved. Run (Ctrl+R) computes it again, in %1.</source>
        <translation>保存時に検討を表示していました。計算 (Ctrl+R) で %1 かけて再計算します。</translation>
    </message>
    <message>
        <source>This study takes %1 (%2). The accuracy Quick takes %3 and measures its error against rays.</source>
        <translation>この検討には %1 (%2) かかります。精度「速い」なら %3 で、レイとの誤差も測ります。</translation>
    </message>
    <message>
        <source>Run quickly</source>
        <translation>速く計算</translation>
    </message>
    <message>
        <source>Run it all the same</source>
        <translation>このまま計算</translation>
    </message>
    <message>
        <source>This study takes %1 (%2). Larger cells, fewer days or a smaller region make it quicker.</source>
        <translation>この検討には %1 (%2) かかります。セルを大きく、日数を少なく、範囲を小さくすると速くなります。</translation>
    </message>
    <message>
        <source>Cancelled. The previous answer is shown.</source>
        <translation>中止しました。前の回答を表示しています。</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>中止しました。</translation>
    </message>
    <message>
        <source>The project holds what was measured: %1.</source>
        <translation>プロジェクトには測定結果があります: %1。</translation>
    </message>
    <message>
        <source>The project holds %1 answers, all in the list of Results; among them %2.</source>
        <translation>プロジェクトには %1 件の答えがあり、すべて「結果」の一覧にあります。うち %2。</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>表示</translation>
    </message>
</context>
<context>
    <name>noonmark::StudyDock</name>
    <message>
        <source>Compute the minutes of shadow in every cell of the region (Ctrl+R)</source>
        <translation>範囲の各セルの日影の分を計算 (Ctrl+R)</translation>
    </message>
    <message>
        <source>What</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>When</source>
        <translation>時期</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>How exactly</source>
        <translation>精度</translation>
    </message>
    <message>
        <source>receivers</source>
        <translation>測定点</translation>
    </message>
    <message>
        <source>This method works on level ground only, but %1. Choose Quick or Reference.</source>
        <translation>この方法は平らな地面だけですが、%1。「速い」か「基準」を選んでください。</translation>
    </message>
    <message>
        <source>roofs are to be measured</source>
        <translation>屋根を測ります</translation>
    </message>
    <message>
        <source>this city has terrain</source>
        <translation>この都市には地形があります</translation>
    </message>
    <message>
        <source>Choose a rule</source>
        <translation>規定を選ぶ</translation>
    </message>
    <message>
        <source>Run again</source>
        <translation>再計算</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Run study</source>
        <translation>計算</translation>
    </message>
    <message>
        <source>This method measures no facades, windows or planes. Choose Quick or Reference.</source>
        <translation>この方法はファサード、窓、水平面を測れません。「速い」または「基準」を選んでください。</translation>
    </message>
    <message>
        <source>period</source>
        <translation>期間</translation>
    </message>
    <message>
        <source>Run (%1)</source>
        <translation>計算 (%1)</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>計算</translation>
    </message>
    <message>
        <source>Compute score</source>
        <translation>スコアを計算</translation>
    </message>
    <message>
        <source>The time that it takes is being estimated</source>
        <translation>所要時間を見積もり中</translation>
    </message>
</context>
<context>
    <name>noonmark::SunShadow</name>
    <message>
        <source>Drawing the shadow</source>
        <translation>影を描画中</translation>
    </message>
</context>
<context>
    <name>noonmark::SurfaceTracer</name>
    <message>
        <source>tracing rays</source>
        <translation>光線を追跡しています</translation>
    </message>
</context>
<context>
    <name>noonmark::TargetRow</name>
    <message>
        <source>Floor area</source>
        <translation>床面積</translation>
    </message>
    <message>
        <source>FAR</source>
        <translation>容積率</translation>
    </message>
    <message>
        <source>Gross floor area, or floor area ratio: gross floor area divided by the lot&apos;s area</source>
        <translation>延床面積、または容積率：延床面積を敷地面積で割った値</translation>
    </message>
    <message>
        <source>Fit storeys</source>
        <translation>階数を合わせる</translation>
    </message>
    <message>
        <source>The most storeys that stay within it</source>
        <translation>それを超えない最大の階数</translation>
    </message>
    <message>
        <source>Fit plate</source>
        <translation>基準階を合わせる</translation>
    </message>
    <message>
        <source>The floor plate with which these storeys reach it</source>
        <translation>この階数で達成する基準階の大きさ</translation>
    </message>
    <message>
        <source> sq ft</source>
        <translation> 平方フィート</translation>
    </message>
    <message>
        <source>What the tower shall have: type it, and storeys or plate are fitted; else what it has</source>
        <translation>タワーの目標値。入力すると階数か基準階を合わせます。未入力なら現在の値</translation>
    </message>
</context>
<context>
    <name>noonmark::ThemeMenu</name>
    <message>
        <source>As the &amp;system</source>
        <translation>システムに合わせる(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>明るい(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>暗い(&amp;D)</translation>
    </message>
    <message>
        <source>C&amp;olours</source>
        <translation>配色(&amp;O)</translation>
    </message>
</context>
<context>
    <name>noonmark::TileDialog</name>
    <message>
        <source>Aerial photograph from tiles</source>
        <translation>タイルから航空写真</translation>
    </message>
    <message>
        <source>Address of the tiles, with {z} for the zoom, {x} and {y} for the tile</source>
        <translation>タイルのアドレス。{z} はズーム、{x} と {y} はタイル</translation>
    </message>
    <message>
        <source>Whose tiles they are, as their owner asks for; printed wherever they are drawn</source>
        <translation>所有者が求めるとおりのタイルの出典。描かれる所すべてに印刷されます</translation>
    </message>
    <message>
        <source>Nothing is fetched before the button is pressed. Tiles of zoom %1: %2. Ask their owner whether you may store and print them.</source>
        <translation>ボタンを押すまで何も取得しません。ズーム %1 のタイル: %2。保存と印刷が許されるか所有者に確認してください。</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>Attribution</source>
        <translation>出典</translation>
    </message>
    <message>
        <source>Fetch tiles</source>
        <translation>タイルを取得</translation>
    </message>
    <message>
        <source>Fetches the tiles over the city from this address</source>
        <translation>このアドレスから都市のタイルを取得します</translation>
    </message>
</context>
<context>
    <name>noonmark::TileFetch</name>
    <message>
        <source>%1 is no picture of a tile</source>
        <translation>%1 はタイルの画像ではありません</translation>
    </message>
    <message>
        <source>The server has no tile of this place</source>
        <translation>サーバーにこの場所のタイルがありません</translation>
    </message>
</context>
<context>
    <name>noonmark::TimeDisplay</name>
    <message>
        <source>&amp;Play the sun</source>
        <translation>太陽を再生(&amp;P)</translation>
    </message>
    <message>
        <source>Shift+Space</source>
        <translation>Shift+Space</translation>
    </message>
    <message>
        <source>Plays or stops the sun and its shadows</source>
        <translation>太陽と影を再生または停止</translation>
    </message>
    <message>
        <source>Ten minutes &amp;later</source>
        <translation>10 分後(&amp;L)</translation>
    </message>
    <message>
        <source>The sun ten minutes later</source>
        <translation>10 分後の太陽</translation>
    </message>
    <message>
        <source>Ten minutes &amp;earlier</source>
        <translation>10 分前(&amp;E)</translation>
    </message>
    <message>
        <source>The sun ten minutes earlier</source>
        <translation>10 分前の太陽</translation>
    </message>
    <message>
        <source>&amp;Next day</source>
        <translation>翌日(&amp;N)</translation>
    </message>
    <message>
        <source>The sun at the same time of the next day</source>
        <translation>翌日の同時刻の太陽</translation>
    </message>
    <message>
        <source>Previous &amp;day</source>
        <translation>前日(&amp;D)</translation>
    </message>
    <message>
        <source>The sun at the same time of the day before</source>
        <translation>前日の同時刻の太陽</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>period</source>
        <translation>期間</translation>
    </message>
    <message>
        <source>The sun is down or low there now, so this is noon: %1</source>
        <translation>現地では今、太陽が低いか沈んでいるため、正午を示しています: %1</translation>
    </message>
</context>
<context>
    <name>noonmark::TimeStrip</name>
    <message>
        <source>Whole period</source>
        <translation>期間全体</translation>
    </message>
    <message>
        <source>One day</source>
        <translation>1 日</translation>
    </message>
    <message>
        <source>One moment</source>
        <translation>一時点</translation>
    </message>
    <message>
        <source>What is shown: the whole period; one day of a study, from horizons cached in steps of half a degree;
or sun and shadow at one moment, on everything</source>
        <translation>表示するもの: 期間全体、0.5 度刻みの地平線による検討の 1 日、
または一時点の太陽と影 (すべての面)</translation>
    </message>
    <message>
        <source>The date, in the year of the period. Arrows: a day; Page Up and Down: a month</source>
        <translation>期間の年の日付。矢印: 1 日、Page Up/Down: 1 か月</translation>
    </message>
    <message>
        <source>The wall-clock time; yellow: the sun is up. Arrows: a minute; Page Up and Down: an hour</source>
        <translation>時刻。黄色: 太陽が出ている。矢印: 1 分、Page Up/Down: 1 時間</translation>
    </message>
    <message>
        <source>Direction of the sun, clockwise from true north, and its altitude</source>
        <translation>真北から時計回りの太陽の方位と高度</translation>
    </message>
    <message>
        <source>Set as period</source>
        <translation>期間にする</translation>
    </message>
    <message>
        <source>Makes this day or moment the period of the study; Run then computes its figures and errors</source>
        <translation>この日や時点を検討期間にします。計算すると数値と誤差が得られます</translation>
    </message>
    <message>
        <source>Plays the sun and its shadows (Shift+Space)</source>
        <translation>太陽と影を再生 (Shift+Space)</translation>
    </message>
    <message>
        <source>through the day</source>
        <translation>1 日を通して</translation>
    </message>
    <message>
        <source>through the year</source>
        <translation>1 年を通して</translation>
    </message>
    <message>
        <source>Play from sunrise to sunset of one date, or one time of day through the year</source>
        <translation>ある日の日の出から日没まで、または同じ時刻を 1 年間再生</translation>
    </message>
    <message>
        <source>slowly</source>
        <translation>ゆっくり</translation>
    </message>
    <message>
        <source>steadily</source>
        <translation>普通</translation>
    </message>
    <message>
        <source>fast</source>
        <translation>速く</translation>
    </message>
    <message>
        <source>Half an hour, an hour and a half or four hours of the day in a second;
of the year, as many weeks</source>
        <translation>1 秒で 1 日の 0.5、1.5、4 時間。
1 年では同じ数の週</translation>
    </message>
    <message>
        <source>d MMM</source>
        <translation>M/d</translation>
    </message>
    <message>
        <source>The date: 21 Dec, 12-21, or 21 for a day of this month</source>
        <translation>日付: 21 Dec、12-21、または今月の日として 21</translation>
    </message>
    <message>
        <source>The wall-clock time: 14:30, 1430, or 14</source>
        <translation>時刻: 14:30、1430、14</translation>
    </message>
</context>
<context>
    <name>noonmark::Tour</name>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2/%3)</translation>
    </message>
</context>
<context>
    <name>noonmark::TourBubble</name>
    <message>
        <source>Show me</source>
        <translation>やって見せる</translation>
    </message>
    <message>
        <source>Does this step for you</source>
        <translation>このステップを代わりに行います</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>End tour</source>
        <translation>ツアーを終える</translation>
    </message>
    <message>
        <source>Help &gt; Guided tours starts it again</source>
        <translation>ヘルプ &gt; ガイドツアー で再開できます</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>次へ</translation>
    </message>
</context>
<context>
    <name>noonmark::TowerDisplay</name>
    <message>
        <source>Store&amp;y lines</source>
        <translation>階の線(&amp;Y)</translation>
    </message>
    <message>
        <source>Lines at the floors of proposed towers, and of imported buildings whose storey height is known</source>
        <translation>計画タワーと、階高がわかる読み込み建物の各階の線</translation>
    </message>
    <message>
        <source>&amp;Heights above datum</source>
        <translation>基準面からの高さ(&amp;H)</translation>
    </message>
    <message>
        <source>Heights of buildings above the vertical zero of the project&apos;s terrain instead of above the ground under each building, as shown and as typed</source>
        <translation>建物の高さを、各建物の地盤からではなく、プロジェクトの地形の鉛直基準から表示・入力する</translation>
    </message>
</context>
<context>
    <name>noonmark::TowerEditing</name>
    <message>
        <source>Build %1</source>
        <translation>%1 を建設</translation>
    </message>
</context>
<context>
    <name>noonmark::Tracer</name>
    <message>
        <source>tracing rays</source>
        <translation>光線を追跡しています</translation>
    </message>
</context>
<context>
    <name>noonmark::TreeActions</name>
    <message>
        <source>Add trees</source>
        <translation>樹木を追加</translation>
    </message>
    <message>
        <source>Inventories of trees and canopy heights</source>
        <translation>樹木台帳と樹冠の高さ</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Listing fields</source>
        <translation>フィールドを一覧中</translation>
    </message>
    <message>
        <source>Reading trees</source>
        <translation>樹木を読み込み中</translation>
    </message>
    <message>
        <source>add trees</source>
        <translation>樹木の追加</translation>
    </message>
</context>
<context>
    <name>noonmark::TreeEditing</name>
    <message numerus="yes">
        <source>plant %1 tree(s)</source>
        <translation>
            <numerusform>%1 本の木を植える</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>move %1 tree(s)</source>
        <translation>
            <numerusform>%1 本の木を移動</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>fell %1 tree(s)</source>
        <translation>
            <numerusform>%1 本の木を伐採</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>replace %1 tree(s)</source>
        <translation>
            <numerusform>%1 本の木を置き換え</numerusform>
        </translation>
    </message>
    <message>
        <source>let trees grow by %1 years</source>
        <translation>木を %1 年分成長させる</translation>
    </message>
    <message>
        <source>Crowns of the other trees</source>
        <translation>ほかの樹木の樹冠</translation>
    </message>
    <message>
        <source>With trees and their seasons, while they move</source>
        <translation>樹木とその季節を含む(移動中)</translation>
    </message>
    <message>
        <source>With trees as evergreens, while they move</source>
        <translation>樹木を常緑として含む(移動中)</translation>
    </message>
</context>
<context>
    <name>noonmark::TreeImportDialog</name>
    <message>
        <source>Add trees</source>
        <translation>樹木を追加</translation>
    </message>
    <message>
        <source>as in the file (example: EPSG:2263)</source>
        <translation>ファイルのとおり(例: EPSG:2263)</translation>
    </message>
    <message>
        <source>Coordinate reference system, if the file does not state it</source>
        <translation>座標参照系(ファイルに記載がない場合)</translation>
    </message>
    <message>
        <source>Coordinate system</source>
        <translation>座標系</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Adds the trees to the existing city; Undo takes them back</source>
        <translation>既存の都市に樹木を追加します。「元に戻す」で取り消せます</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>classes</source>
        <translation>階級</translation>
    </message>
    <message>
        <source>Unit of numbers without one</source>
        <translation>単位のない数値の単位</translation>
    </message>
    <message>
        <source>Reading the trees...</source>
        <translation>樹木を読み込んでいます...</translation>
    </message>
</context>
<context>
    <name>noonmark::TreePanel</name>
    <message>
        <source>Species not known</source>
        <translation>樹種不明</translation>
    </message>
    <message>
        <source>evergreen</source>
        <translation>常緑</translation>
    </message>
    <message>
        <source>loses its leaves</source>
        <translation>落葉</translation>
    </message>
    <message>
        <source>%1, %2 high, crown %3, %4</source>
        <translation>%1、高さ %2、樹冠 %3、%4</translation>
    </message>
    <message>
        <source> years</source>
        <translation> 年</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>植える</translation>
    </message>
    <message>
        <source>Each click on the ground plants a tree; Esc ends</source>
        <translation>地面をクリックするたびに木を植えます。Esc で終了</translation>
    </message>
    <message>
        <source>Plant a row</source>
        <translation>並べて植える</translation>
    </message>
    <message>
        <source>Click the corners of a line; a double click or Enter plants trees along it</source>
        <translation>線の角をクリックし、ダブルクリックまたは Enter でその線に沿って木を植えます</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換え</translation>
    </message>
    <message>
        <source>Puts trees with the measures above in place of the chosen ones</source>
        <translation>選択した木を上の寸法の木に置き換えます</translation>
    </message>
    <message>
        <source>Fell</source>
        <translation>伐採</translation>
    </message>
    <message>
        <source>Removes the chosen trees (Delete)</source>
        <translation>選択した木を取り除きます (Delete)</translation>
    </message>
    <message>
        <source>Let grow</source>
        <translation>成長させる</translation>
    </message>
    <message>
        <source>The chosen trees after these years; all of the city if none is chosen</source>
        <translation>選択した木のその年数後の姿。選択がなければ都市のすべての木</translation>
    </message>
    <message>
        <source>Distance between the trees of a row</source>
        <translation>並木の木と木の間隔</translation>
    </message>
    <message>
        <source>Years of growth, of which crown and height are estimated</source>
        <translation>成長の年数。樹冠と高さはこれから推定されます</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>間隔</translation>
    </message>
    <message numerus="yes">
        <source>%1 tree(s) in the city. Click one to choose it, Ctrl adds more</source>
        <translation>
            <numerusform>都市に %1 本の木があります。クリックで選択、Ctrl で追加</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 trees chosen</source>
        <translation>%1 本の木を選択</translation>
    </message>
    <message>
        <source>Read trees of a file...</source>
        <translation>ファイルの樹木を読み込む...</translation>
    </message>
    <message>
        <source>Adds an inventory, OpenStreetMap or a raster of canopy heights to the existing city</source>
        <translation>台帳、OpenStreetMap、または樹冠の高さのラスターを既存の都市に追加します</translation>
    </message>
    <message>
        <source>The city has no trees yet. Plant some, or read those of a file</source>
        <translation>都市にはまだ樹木がありません。植えるか、ファイルから読み込んでください</translation>
    </message>
    <message>
        <source>loses its leaves (days of its own)</source>
        <translation>落葉する(固有の日付)</translation>
    </message>
    <message>
        <source>Whole region</source>
        <translation>範囲全体</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Sun, min a day</source>
        <translation>日照 (分/日)</translation>
    </message>
    <message>
        <source>Shadow, min a day</source>
        <translation>影 (分/日)</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変化</translation>
    </message>
</context>
<context>
    <name>noonmark::UseTable</name>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>階数</translation>
    </message>
    <message>
        <source>What the storeys are used for, from the ground floor up: retail 2, offices 10, homes the rest</source>
        <translation>階の用途、1階から上へ: 店舗2、オフィス10、残りは住宅</translation>
    </message>
    <message>
        <source>Add use</source>
        <translation>用途を追加</translation>
    </message>
    <message>
        <source>Adds a use for the storeys above the others</source>
        <translation>ほかの用途より上の階の用途を追加する</translation>
    </message>
    <message>
        <source>Removes the selected use, or the last one</source>
        <translation>選択した用途、または最後の用途を削除する</translation>
    </message>
    <message>
        <source>Retail</source>
        <translation>店舗</translation>
    </message>
    <message>
        <source>Offices</source>
        <translation>オフィス</translation>
    </message>
    <message>
        <source>Homes</source>
        <translation>住宅</translation>
    </message>
    <message>
        <source>Hotel</source>
        <translation>ホテル</translation>
    </message>
    <message>
        <source>Community</source>
        <translation>公共施設</translation>
    </message>
    <message>
        <source>Parking</source>
        <translation>駐車場</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>機械室</translation>
    </message>
    <message>
        <source>A use of the list, or any other text</source>
        <translation>一覧の用途、またはほかの任意の文字</translation>
    </message>
    <message>
        <source>the rest</source>
        <translation>残り</translation>
    </message>
    <message>
        <source>How many storeys; 0: all storeys above, for the last use</source>
        <translation>階数。0: それより上のすべての階(最後の用途)</translation>
    </message>
</context>
<context>
    <name>noonmark::VerdictLinks</name>
    <message>
        <source>%1: %2 compared with %3</source>
        <translation>%1：%2を%3と比較</translation>
    </message>
</context>
<context>
    <name>noonmark::VerdictTable</name>
    <message>
        <source>Place and day</source>
        <translation>場所と日</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>日</translation>
    </message>
</context>
<context>
    <name>noonmark::ViewActions</name>
    <message>
        <source>Zoom to whole &amp;city</source>
        <translation>都市全体(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;North up</source>
        <translation>北を上に(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Top view</source>
        <translation>平面(&amp;T)</translation>
    </message>
    <message>
        <source>Zoom to &amp;region</source>
        <translation>範囲に拡大(&amp;R)</translation>
    </message>
    <message>
        <source>The study region seen from above</source>
        <translation>検討範囲を上から</translation>
    </message>
    <message>
        <source>&amp;Solid buildings</source>
        <translation>建物を面で表示(&amp;S)</translation>
    </message>
    <message>
        <source>Off: wireframe, so that the ground behind buildings is visible</source>
        <translation>オフ: ワイヤーフレーム。建物の後ろの地面が見えます</translation>
    </message>
    <message>
        <source>&amp;Map on the ground</source>
        <translation>地面に地図(&amp;M)</translation>
    </message>
    <message>
        <source>Streets, paths, parks, water and trees, drawn for orientation</source>
        <translation>道路、小道、公園、水面、樹木 (位置の目安)</translation>
    </message>
    <message>
        <source>&amp;Explore by shadow accrual maps</source>
        <translation>影累積マップで探索(&amp;E)</translation>
    </message>
    <message>
        <source>As in the paper, instead of rays: inexact at shadow edges, but hours that look alike are computed once</source>
        <translation>論文の通り、レイの代わりに。影の縁は不正確ですが、似た時刻は 1 回だけ計算します</translation>
    </message>
    <message>
        <source>Me&amp;asure distances</source>
        <translation>距離を測る(&amp;A)</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>Click points on roofs, walls and ground: distance, height, area. Backspace removes the last point, a double click ends</source>
        <translation>屋根・壁・地面の点をクリック: 距離、高さ、面積。Backspace で最後の点を消し、ダブルクリックで終わります</translation>
    </message>
    <message>
        <source>Section bo&amp;x</source>
        <translation>断面ボックス(&amp;X)</translation>
    </message>
    <message>
        <source>Shift+X</source>
        <translation>Shift+X</translation>
    </message>
    <message>
        <source>Cuts away what lies outside a box, by handles or numbers; shadows remain those of the whole city</source>
        <translation>ハンドルまたは数値で指定した箱の外側を切り取ります。日影は都市全体のままです</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>樹木</translation>
    </message>
    <message>
        <source>The trees of the city, bare on days without leaves</source>
        <translation>都市の木。葉のない日は裸木</translation>
    </message>
</context>
<context>
    <name>noonmark::ViewPanel</name>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>View of the city</source>
        <translation>都市の表示</translation>
    </message>
    <message>
        <source>Arrow keys pan, plus and minus zoom; Ctrl+F1 lists all keys</source>
        <translation>矢印キーで移動、プラスとマイナスで拡大・縮小。Ctrl+F1 で全キーを一覧表示</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>範囲</translation>
    </message>
</context>
<context>
    <name>noonmark::ViewPresets</name>
    <message>
        <source>From the &amp;south</source>
        <translation>南から(&amp;S)</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>From the &amp;east</source>
        <translation>東から(&amp;E)</translation>
    </message>
    <message>
        <source>Shift+E</source>
        <translation>Shift+E</translation>
    </message>
    <message>
        <source>From the &amp;north</source>
        <translation>北から(&amp;N)</translation>
    </message>
    <message>
        <source>Shift+N</source>
        <translation>Shift+N</translation>
    </message>
    <message>
        <source>From the &amp;west</source>
        <translation>西から(&amp;W)</translation>
    </message>
    <message>
        <source>Shift+W</source>
        <translation>Shift+W</translation>
    </message>
    <message>
        <source>From the s&amp;un</source>
        <translation>太陽から(&amp;U)</translation>
    </message>
    <message>
        <source>As the sun sees the city at the date and time below the view: what is visible is sunlit</source>
        <translation>下に示す日時に太陽から見た都市: 見える所が日なたです</translation>
    </message>
    <message>
        <source>The sun is below the horizon at this date and time. Move the time below the view.</source>
        <translation>この日時には太陽が地平線の下です。下の時刻を変えてください。</translation>
    </message>
    <message>
        <source>Parallel pro&amp;jection</source>
        <translation>平行投影(&amp;J)</translation>
    </message>
    <message>
        <source>Orthographic, as in plans and elevations: lengths across the view are to scale everywhere</source>
        <translation>平面図や立面図のような正投影: 視線に直交する長さはどこでも縮尺どおりです</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>平面図(&amp;P)</translation>
    </message>
    <message>
        <source>Shift+P</source>
        <translation>Shift+P</translation>
    </message>
    <message>
        <source>The same ground from straight above, north up, in parallel projection</source>
        <translation>同じ地面を真上から、北を上に、平行投影で</translation>
    </message>
    <message>
        <source>The same ground from this side; an elevation in parallel projection</source>
        <translation>同じ地面をこの側から。平行投影では立面図です</translation>
    </message>
</context>
<context>
    <name>noonmark::WarningsDock</name>
    <message>
        <source>Double-click a feature or press Enter to go to its building</source>
        <translation>ダブルクリックか Enter でその建物へ移動</translation>
    </message>
    <message>
        <source>No warnings: nothing was left out, repaired or assumed</source>
        <translation>警告なし: 除外、修復、仮定はありません</translation>
    </message>
</context>
<context>
    <name>noonmark::Watch</name>
    <message>
        <source>reading the picture</source>
        <translation>画像を読み込んでいます</translation>
    </message>
</context>
<context>
    <name>noonmark::Watcher</name>
    <message>
        <source>reading the terrain</source>
        <translation>地形を読み込んでいます</translation>
    </message>
    <message>
        <source>resampling the terrain</source>
        <translation>地形を再標本化しています</translation>
    </message>
</context>
<context>
    <name>noonmark::WeightCalendar</name>
    <message>
        <source>Weights by month and hour</source>
        <translation>月と時刻ごとの重み</translation>
    </message>
    <message>
        <source>Drag to give months and hours the weight that is chosen below; drag with the right button to erase it. Keys: arrows, Shift, Enter, Delete, + and -</source>
        <translation>ドラッグした月と時刻に、下で選んだ重みを与えます。右ボタンのドラッグで消去。キー: 矢印、Shift、Enter、Delete、+ と -</translation>
    </message>
    <message>
        <source>%1, %2:00 to %3:00</source>
        <translation>%1、%2:00 から %3:00</translation>
    </message>
    <message>
        <source>no weight</source>
        <translation>重みなし</translation>
    </message>
    <message>
        <source>several weights, or none in part; mean %1</source>
        <translation>複数の重み、または一部が重みなし。平均 %1</translation>
    </message>
    <message>
        <source>weight %1</source>
        <translation>重み %1</translation>
    </message>
    <message>
        <source>sun wanted</source>
        <translation>日なたが望ましい</translation>
    </message>
    <message>
        <source>shade wanted</source>
        <translation>影が望ましい</translation>
    </message>
</context>
<context>
    <name>noonmark::WeightsDock</name>
    <message>
        <source>Compute score</source>
        <translation>スコアを計算</translation>
    </message>
    <message>
        <source>Shadow of the displayed scenario over the study&apos;s region and period, weighted by this table: by month and as a map</source>
        <translation>表示中のシナリオの検討範囲・期間の影をこの表で重み付け: 月別と図</translation>
    </message>
    <message>
        <source>The weight table to edit and to compute scores with; rename it with F2 in the project tree</source>
        <translation>編集しスコアに使う重み表。名前の変更はプロジェクトで F2</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>重み</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Adds an interval after the selected one: over days without a weight, else over half of its days</source>
        <translation>選択した区間の後に追加: 重みのない日、なければその半分の日</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Removes the selected interval; its time then has no weight</source>
        <translation>選択した区間を削除。その時間は重みなしになります</translation>
    </message>
    <message>
        <source>New table</source>
        <translation>新しい表</translation>
    </message>
    <message>
        <source>Adds a table that starts with the twelve months of the paper</source>
        <translation>論文の 12 か月から始まる表を追加</translation>
    </message>
    <message>
        <source>new weight table %1</source>
        <translation>新しい重み表 %1</translation>
    </message>
    <message>
        <source>Cutting an interval in two changes the score, but not the weighted shade.</source>
        <translation>区間を二つに分けるとスコアは変わりますが、重み付きの日陰は変わりません。</translation>
    </message>
    <message>
        <source>New from template</source>
        <translation>テンプレートから新規</translation>
    </message>
    <message>
        <source>Adds a table made for the latitude of this city, or a copy of a table of this project</source>
        <translation>この都市の緯度に合わせた表、またはこのプロジェクトの表のコピーを追加</translation>
    </message>
    <message>
        <source>Pedestrian comfort</source>
        <translation>歩行者の快適性</translation>
    </message>
    <message>
        <source>Shade wanted in summer afternoons, sun in winter: a rule of thumb by latitude</source>
        <translation>夏の午後は影、冬は日なたが望ましい: 緯度による目安</translation>
    </message>
    <message>
        <source>Plants</source>
        <translation>植物</translation>
    </message>
    <message>
        <source>Sun wanted in the growing season: a rule of thumb by latitude</source>
        <translation>生育期は日なたが望ましい: 緯度による目安</translation>
    </message>
    <message>
        <source>As %1</source>
        <translation>%1 と同じ</translation>
    </message>
    <message>
        <source>A copy, to be changed</source>
        <translation>変更用のコピー</translation>
    </message>
</context>
<context>
    <name>noonmark::WeightsModel</name>
    <message>
        <source>Interval</source>
        <translation>区間</translation>
    </message>
    <message>
        <source>Name of the interval</source>
        <translation>区間の名称</translation>
    </message>
    <message>
        <source>First</source>
        <translation>開始日</translation>
    </message>
    <message>
        <source>First day, every year: month and day such as 06-01, or a month such as June</source>
        <translation>毎年の開始日: 06-01 のような月日、または June のような月</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>終了日</translation>
    </message>
    <message>
        <source>Last day, included; before the first: across New Year. Such as 08-31, or a month such as August</source>
        <translation>終了日 (含む)。開始日より前なら年をまたぎます。08-31 のような月日、または August のような月</translation>
    </message>
    <message>
        <source>From</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Time of day at which it begins, wall clock: 00:00 to 24:00</source>
        <translation>開始時刻: 00:00 から 24:00</translation>
    </message>
    <message>
        <source>To</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Time of day at which it ends: 00:00 to 24:00</source>
        <translation>終了時刻: 00:00 から 24:00</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>重み</translation>
    </message>
    <message>
        <source>-1 (shadow unwanted) to 1 (shade wanted)</source>
        <translation>-1 (影は望ましくない) から 1 (影が望ましい)</translation>
    </message>
    <message>
        <source>edit weights %1</source>
        <translation>重み %1 を編集</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>行 %1</translation>
    </message>
</context>
<context>
    <name>noonmark::WhatForm</name>
    <message>
        <source>Hours of shadow</source>
        <translation>日影時間</translation>
    </message>
    <message>
        <source>Change by a scenario</source>
        <translation>シナリオによる変化</translation>
    </message>
    <message>
        <source>Score of wanted shadow</source>
        <translation>望ましい影のスコア</translation>
    </message>
    <message>
        <source>Review by a rule</source>
        <translation>規定による審査</translation>
    </message>
    <message>
        <source>Where shadow is measured. Changes and scores are measured on the ground only.
Facades, windows and planes are measured at points, each with its hours of sun.</source>
        <translation>影を測る場所。変化とスコアは地盤面でのみ測ります。
ファサード、窓、水平面は点で測り、点ごとに日照時間を示します。</translation>
    </message>
    <message>
        <source>receivers</source>
        <translation>測定点</translation>
    </message>
    <message>
        <source>Sun by place</source>
        <translation>場所別の日照</translation>
    </message>
</context>
<context>
    <name>noonmark::WhenForm</name>
    <message>
        <source>The days that are measured. The hours stay as they are</source>
        <translation>測定する日。時間帯は変わりません</translation>
    </message>
    <message>
        <source>The day and the hours of a review board&apos;s rule</source>
        <translation>審査機関の規定の日と時間帯</translation>
    </message>
    <message>
        <source>days</source>
        <translation>日</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 から %2</translation>
    </message>
    <message>
        <source>period</source>
        <translation>期間</translation>
    </message>
    <message>
        <source>Days of a rule</source>
        <translation>規定の日</translation>
    </message>
</context>
<context>
    <name>noonmark::WhereForm</name>
    <message>
        <source>Place or region by name</source>
        <translation>場所または範囲の名称</translation>
    </message>
    <message>
        <source>A place or a region of the project. Type a part of its name.</source>
        <translation>プロジェクトの場所か範囲。名称の一部を入力。</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>描く</translation>
    </message>
    <message>
        <source>Click the corners of a polygon on the ground.
Double click, Enter or right click finishes, Backspace removes the last corner, Esc cancels.</source>
        <translation>地面の多角形の角をクリック。
ダブルクリック、Enter、右クリックで終了、Backspace で最後の角を取り消し、Esc で中止。</translation>
    </message>
    <message>
        <source>What I see</source>
        <translation>表示中の所</translation>
    </message>
    <message>
        <source>The ground visible in the view</source>
        <translation>表示中の地面</translation>
    </message>
    <message>
        <source>Whole city</source>
        <translation>都市全体</translation>
    </message>
    <message>
        <source>The bounding box of all buildings</source>
        <translation>全建物を囲む長方形</translation>
    </message>
    <message>
        <source>Around building</source>
        <translation>建物の周り</translation>
    </message>
    <message>
        <source>The selected building&apos;s surroundings, as far as four times its height.
Click a building first.</source>
        <translation>選択した建物の周り、高さの 4 倍まで。
先に建物をクリックしてください。</translation>
    </message>
</context>
<context>
    <name>noonmark::Workbench</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 を開いています</translation>
    </message>
    <message>
        <source>Recovering</source>
        <translation>復元中</translation>
    </message>
    <message>
        <source>recover unsaved changes</source>
        <translation>未保存の変更を復元</translation>
    </message>
    <message>
        <source>Unsaved changes recovered. Save keeps them, Undo discards them.</source>
        <translation>未保存の変更を復元しました。保存すると残り、元に戻すと破棄します。</translation>
    </message>
    <message>
        <source>Showing %1</source>
        <translation>%1 を表示中</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>無題</translation>
    </message>
    <message>
        <source>Estimating</source>
        <translation>見積もり中</translation>
    </message>
    <message>
        <source>engine</source>
        <translation>エンジン</translation>
    </message>
    <message>
        <source>All scenarios</source>
        <translation>全シナリオ</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 を保存中</translation>
    </message>
    <message>
        <source>save result %1</source>
        <translation>結果 %1 を保存</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>書き出し中</translation>
    </message>
    <message>
        <source>Exported to %1: %2</source>
        <translation>%1 に書き出しました: %2</translation>
    </message>
    <message>
        <source>Finding the command</source>
        <translation>コマンドを求めています</translation>
    </message>
    <message>
        <source>Comparing results with the buildings</source>
        <translation>結果を建物と比較しています</translation>
    </message>
    <message>
        <source>%1 is saved with the project: the list above the results shows it again</source>
        <translation>%1 をプロジェクトに保存しました。結果の上の一覧から再び表示できます</translation>
    </message>
    <message>
        <source>months</source>
        <translation>月</translation>
    </message>
    <message>
        <source>%1 is in the list of answers</source>
        <translation>%1 は回答の一覧にある</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
</context>
<context>
    <name>std</name>
    <message>
        <source>Shadow</source>
        <translation>日影</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>日照</translation>
    </message>
    <message>
        <source>Share of the sunlit time</source>
        <translation>可照時間に占める割合</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分</translation>
    </message>
    <message>
        <source> min a day</source>
        <translation> 分/日</translation>
    </message>
    <message>
        <source> h</source>
        <translation> 時間</translation>
    </message>
    <message>
        <source> h a day</source>
        <translation> 時間/日</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>未集計</translation>
    </message>
    <message>
        <source>without trees, as evergreens, with seasons</source>
        <translation>樹木なし、常緑として、季節あり</translation>
    </message>
    <message>
        <source>without trees</source>
        <translation>樹木なし</translation>
    </message>
    <message>
        <source>as evergreens</source>
        <translation>常緑として</translation>
    </message>
    <message>
        <source>with seasons</source>
        <translation>季節あり</translation>
    </message>
    <message>
        <source>if neighbours&apos; ground heights differ</source>
        <translation>隣接する地盤高が異なる場合</translation>
    </message>
    <message>
        <source>always</source>
        <translation>常に</translation>
    </message>
    <message>
        <source>never (flat ground)</source>
        <translation>しない (平らな地面)</translation>
    </message>
    <message>
        <source>as their bases fit the terrain</source>
        <translation>基部と地形の合い方に応じて</translation>
    </message>
    <message>
        <source>each set down on the terrain</source>
        <translation>それぞれを地形に載せる</translation>
    </message>
    <message>
        <source>at the elevations in the file</source>
        <translation>ファイルの標高のまま</translation>
    </message>
    <message>
        <source>found by its steps at outlines</source>
        <translation>輪郭での段差から判定</translation>
    </message>
    <message>
        <source>the bare ground</source>
        <translation>地表面のみ</translation>
    </message>
    <message>
        <source>a surface with buildings</source>
        <translation>建物を含む表面</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Sun to indigo</source>
        <translation>日なた色から藍色</translation>
    </message>
    <message>
        <source>Viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation>Cividis</translation>
    </message>
    <message>
        <source>Magma</source>
        <translation>Magma</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>グレー</translation>
    </message>
    <message>
        <source>Green to red</source>
        <translation>緑から赤</translation>
    </message>
    <message>
        <source>Orange to violet</source>
        <translation>橙から紫</translation>
    </message>
    <message>
        <source>Green-blue to brown</source>
        <translation>青緑から茶</translation>
    </message>
    <message>
        <source>Orange to purple</source>
        <translation>橙から赤紫</translation>
    </message>
    <message>
        <source>Blue to red</source>
        <translation>青から赤</translation>
    </message>
    <message>
        <source>Green to red, pale in the middle</source>
        <translation>緑から赤、中央は淡い色</translation>
    </message>
    <message>
        <source>Gross shadow of a cell</source>
        <translation>セルの総日影</translation>
    </message>
    <message>
        <source>Longest shadow of a cell</source>
        <translation>セルの最長連続日影</translation>
    </message>
    <message>
        <source>Shadow of a cell in a month</source>
        <translation>セルの月別の日影</translation>
    </message>
    <message>
        <source>Change of gross shadow of a cell</source>
        <translation>セルの総日影の変化</translation>
    </message>
    <message>
        <source>Change of the longest shadow of a cell</source>
        <translation>セルの最長連続日影の変化</translation>
    </message>
    <message>
        <source>Score of a cell</source>
        <translation>セルの得点</translation>
    </message>
    <message>
        <source>Shadow score</source>
        <translation>日影スコア</translation>
    </message>
    <message>
        <source>Weighted shade</source>
        <translation>重み付きの日陰</translation>
    </message>
    <message>
        <source>Shadow area of a month</source>
        <translation>月の日影面積</translation>
    </message>
    <message>
        <source>Shadow score of a month</source>
        <translation>月の日影スコア</translation>
    </message>
    <message>
        <source>Weighted shade of a month</source>
        <translation>月の重み付き日陰</translation>
    </message>
    <message>
        <source>Shadow area of an interval</source>
        <translation>区間の日影面積</translation>
    </message>
    <message>
        <source>Shadow score of an interval</source>
        <translation>区間の日影スコア</translation>
    </message>
    <message>
        <source>Weighted shade of an interval</source>
        <translation>区間の重み付き日陰</translation>
    </message>
    <message>
        <source>Least and most sun of a place, at a cell</source>
        <translation>場所の最小・最大の日照（セル）</translation>
    </message>
    <message>
        <source>Mean sun of a place</source>
        <translation>場所の平均日照</translation>
    </message>
    <message>
        <source>Mean sun of a small place with cells of its own</source>
        <translation>専用のセルを持つ小さな場所の平均日照</translation>
    </message>
    <message>
        <source>Mean sun of a place in a month</source>
        <translation>場所の月別平均日照</translation>
    </message>
    <message>
        <source>Share of a place with enough sun</source>
        <translation>十分な日照がある場所の割合</translation>
    </message>
    <message>
        <source>Mean sun of a place on a date</source>
        <translation>場所の指定日の平均日照</translation>
    </message>
    <message>
        <source>Share of a place with less than enough sun on a date</source>
        <translation>指定日に日照が不足する場所の割合</translation>
    </message>
    <message>
        <source>Change of the mean sun of a place</source>
        <translation>場所の平均日照の変化</translation>
    </message>
    <message>
        <source>Largest loss and gain of a place, at a cell</source>
        <translation>場所の最大の減少と増加（セル）</translation>
    </message>
    <message>
        <source>Share of a place that loses sun</source>
        <translation>日照が減る場所の割合</translation>
    </message>
    <message>
        <source>on the ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>on roofs</source>
        <translation>屋根</translation>
    </message>
    <message>
        <source>on the ground and roofs</source>
        <translation>地面と屋根</translation>
    </message>
    <message>
        <source>buildings stand on all of it</source>
        <translation>全体に建物が建っています</translation>
    </message>
    <message>
        <source>no cell has its centre on its open ground</source>
        <translation>空地に中心を持つセルがありません</translation>
    </message>
    <message>
        <source>beyond the terrain: the nearest elevation is taken</source>
        <translation>地形の範囲外：最も近い標高を使用</translation>
    </message>
    <message>
        <source>mostly on water: measured at its surface</source>
        <translation>大部分が水面上：水面で計測</translation>
    </message>
    <message>
        <source>elevations</source>
        <translation>標高</translation>
    </message>
    <message>
        <source>above the ground</source>
        <translation>地盤からの高さ</translation>
    </message>
    <message>
        <source>on facades</source>
        <translation>ファサード</translation>
    </message>
    <message>
        <source>at windows of a file</source>
        <translation>ファイルの窓</translation>
    </message>
    <message>
        <source>on a level plane</source>
        <translation>水平面</translation>
    </message>
    <message>
        <source>on lines around a parcel</source>
        <translation>敷地まわりの線上</translation>
    </message>
    <message>
        <source>at single points</source>
        <translation>個別の点</translation>
    </message>
    <message>
        <source>Hours of sun a day by month</source>
        <translation>月別の 1 日の日照時間</translation>
    </message>
    <message>
        <source>first light of the disc (-0.833°)</source>
        <translation>上縁が出る時 (-0.833°)</translation>
    </message>
    <message>
        <source>middle of the disc (0°)</source>
        <translation>中心が出る時 (0°)</translation>
    </message>
    <message>
        <source>the eastings begin with the number of their zone, which was taken off</source>
        <translation>東距がゾーン番号で始まるため、番号を取り除きました</translation>
    </message>
    <message>
        <source>Gross, trees as evergreens</source>
        <translation>総日影、樹木は常緑とする</translation>
    </message>
    <message>
        <source>Gross, trees with their seasons</source>
        <translation>総日影、樹木は季節による</translation>
    </message>
    <message>
        <source>Sun, trees as evergreens</source>
        <translation>日照、樹木は常緑とする</translation>
    </message>
    <message>
        <source>Sun, trees with their seasons</source>
        <translation>日照、樹木は季節による</translation>
    </message>
    <message>
        <source>trees as evergreens</source>
        <translation>常緑とした樹木</translation>
    </message>
    <message>
        <source>trees with their seasons</source>
        <translation>季節のある樹木</translation>
    </message>
    <message>
        <source>a wood is taken as closed canopy, in columns of 8 x 8 m</source>
        <translation>森は 8 x 8 m の柱からなる閉じた樹冠とみなします</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Crown diameter</source>
        <translation>樹冠の直径</translation>
    </message>
    <message>
        <source>Crown base</source>
        <translation>樹冠の下端</translation>
    </message>
    <message>
        <source>Stem diameter</source>
        <translation>幹の直径</translation>
    </message>
    <message>
        <source>Stem girth</source>
        <translation>幹の周囲</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>種</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>属</translation>
    </message>
    <message>
        <source>Leaf cycle</source>
        <translation>葉の周期</translation>
    </message>
    <message>
        <source>%1, carriageway</source>
        <translation>%1、車道</translation>
    </message>
    <message>
        <source>%1, sidewalks</source>
        <translation>%1、歩道</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1、%2から%3まで</translation>
    </message>
    <message>
        <source>%1, at %2</source>
        <translation>%1、%2付近</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 ほか%2件</translation>
    </message>
    <message>
        <source>%1, east of %2</source>
        <translation>%1、%2の東</translation>
    </message>
    <message>
        <source>%1, north-east of %2</source>
        <translation>%1、%2の北東</translation>
    </message>
    <message>
        <source>%1, north of %2</source>
        <translation>%1、%2の北</translation>
    </message>
    <message>
        <source>%1, north-west of %2</source>
        <translation>%1、%2の北西</translation>
    </message>
    <message>
        <source>%1, west of %2</source>
        <translation>%1、%2の西</translation>
    </message>
    <message>
        <source>%1, south-west of %2</source>
        <translation>%1、%2の南西</translation>
    </message>
    <message>
        <source>%1, south of %2</source>
        <translation>%1、%2の南</translation>
    </message>
    <message>
        <source>%1, south-east of %2</source>
        <translation>%1、%2の南東</translation>
    </message>
    <message>
        <source>evergreen</source>
        <translation>常緑</translation>
    </message>
    <message>
        <source>loses its leaves</source>
        <translation>落葉</translation>
    </message>
    <message>
        <source>First day in leaf</source>
        <translation>着葉の初日</translation>
    </message>
    <message>
        <source>First day without leaves</source>
        <translation>落葉の初日</translation>
    </message>
    <message>
        <source>the whole city</source>
        <translation>都市全体</translation>
    </message>
    <message>
        <source>the middle of the city</source>
        <translation>都市の中央</translation>
    </message>
    <message>
        <source>around the building</source>
        <translation>建物の周辺</translation>
    </message>
    <message>
        <source>around %1</source>
        <translation>%1 の周辺</translation>
    </message>
    <message>
        <source>That of the window</source>
        <translation>ウィンドウの言語</translation>
    </message>
    <message>
        <source>Sun: azimuth %1°, altitude %2°</source>
        <translation>太陽: 方位角 %1°、高度 %2°</translation>
    </message>
    <message>
        <source>%1 further pages are printed by the option --all-pages. </source>
        <translation>ほか %1 ページはオプション --all-pages で印刷します。 </translation>
    </message>
    <message>
        <source>Place</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>%1, generated by this program</source>
        <translation>%1、このプログラムが生成</translation>
    </message>
    <message>
        <source>%1, %2 bytes, SHA-256:</source>
        <translation>%1、%2 バイト、SHA-256:</translation>
    </message>
    <message>
        <source>%1 day</source>
        <translation>%1 日</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 日</translation>
    </message>
    <message>
        <source>%1 step</source>
        <translation>%1 ステップ</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 ステップ</translation>
    </message>
    <message>
        <source>%1 value</source>
        <translation>%1 個の値</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 個の値</translation>
    </message>
    <message>
        <source>%1 edit</source>
        <translation>%1 件の編集</translation>
    </message>
    <message>
        <source>%1 edits</source>
        <translation>%1 件の編集</translation>
    </message>
    <message>
        <source>%1 place</source>
        <translation>%1 か所</translation>
    </message>
    <message>
        <source>%1 places</source>
        <translation>%1 か所</translation>
    </message>
    <message>
        <source>%1 building</source>
        <translation>建物 %1 件</translation>
    </message>
    <message>
        <source>%1 buildings</source>
        <translation>建物 %1 件</translation>
    </message>
    <message>
        <source>%1 part</source>
        <translation>部分 %1 件</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>部分 %1 件</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>フィート</translation>
    </message>
    <message>
        <source>sq ft</source>
        <translation>平方フィート</translation>
    </message>
    <message>
        <source>acres</source>
        <translation>エーカー</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 から %2</translation>
    </message>
    <message>
        <source>, one day in %1</source>
        <translation>、%1 日に 1 日</translation>
    </message>
    <message>
        <source>, half a year mirrored at 21 June</source>
        <translation>、6 月 21 日で折り返した半年</translation>
    </message>
    <message>
        <source>; sun above %1 deg</source>
        <translation>、太陽高度 %1 度超</translation>
    </message>
    <message>
        <source>; sunrise: %1</source>
        <translation>、日の出: %1</translation>
    </message>
    <message>
        <source>, %1, %2 face</source>
        <translation>、%1、%2面</translation>
    </message>
    <message>
        <source>, %1 m above the sill</source>
        <translation>、窓台から %1 m</translation>
    </message>
    <message>
        <source>, %1 m above the floor</source>
        <translation>、床から %1 m</translation>
    </message>
    <message>
        <source>, sun at least %1 deg from the pane</source>
        <translation>、ガラス面から %1 度以上の太陽</translation>
    </message>
    <message>
        <source>, sun at least arctan(wall / width) from the pane</source>
        <translation>、ガラス面から arctan(壁厚 / 幅) 以上の太陽</translation>
    </message>
    <message>
        <source>; by %1</source>
        <translation>、%1ごと</translation>
    </message>
    <message>
        <source>; sill %1 m, wall %2 m, windows without a size %3 x %4 m</source>
        <translation>、窓台 %1 m、壁厚 %2 m、大きさのない窓 %3 x %4 m</translation>
    </message>
    <message>
        <source> %1 m above mean ground</source>
        <translation> 平均地盤面から %1 m</translation>
    </message>
    <message>
        <source>; lines %1 and %2 m from the parcel</source>
        <translation>、敷地から %1 m と %2 m の線</translation>
    </message>
    <message>
        <source>, whose line moves out by %1 of the width of roads up to %2 m, to %3 m inside the far side of wider ones</source>
        <translation>、その線は幅 %2 m までの道路では幅の %1 倍、より広い道路では反対側から %3 m の所まで外側に移ります</translation>
    </message>
    <message>
        <source>; all places</source>
        <translation>、すべての場所</translation>
    </message>
    <message>
        <source> or</source>
        <translation> または</translation>
    </message>
    <message>
        <source>: stated, no limit</source>
        <translation>: 値のみ、限度なし</translation>
    </message>
    <message>
        <source>; windows facing %1 to %2 deg</source>
        <translation>、方位 %1 から %2 度の窓</translation>
    </message>
    <message>
        <source> (does not decide)</source>
        <translation> (判定に用いない)</translation>
    </message>
    <message>
        <source>days</source>
        <translation>日</translation>
    </message>
    <message>
        <source>clock</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>receivers</source>
        <translation>測定点</translation>
    </message>
    <message>
        <source>casters</source>
        <translation>遮蔽物</translation>
    </message>
    <message>
        <source>trees</source>
        <translation>樹木</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>比較基準</translation>
    </message>
    <message>
        <source>criterion</source>
        <translation>基準</translation>
    </message>
    <message>
        <source>holds if</source>
        <translation>成立条件</translation>
    </message>
    <message>
        <source>or</source>
        <translation>または</translation>
    </message>
    <message>
        <source>share</source>
        <translation>割合</translation>
    </message>
    <message>
        <source>sunshine</source>
        <translation>日照率</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>合計</translation>
    </message>
    <message>
        <source>table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>diagrams</source>
        <translation>図</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>未確認</translation>
    </message>
    <message>
        <source>How the rule is read</source>
        <translation>規定の読み方</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>平面図</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>扇形図</translation>
    </message>
    <message>
        <source>isochrones</source>
        <translation>等時間線</translation>
    </message>
    <message>
        <source>view from the sun</source>
        <translation>太陽から見た図</translation>
    </message>
    <message>
        <source>hours</source>
        <translation>時間帯</translation>
    </message>
    <message>
        <source>, on full %1 min</source>
        <translation>、%1 分単位</translation>
    </message>
    <message>
        <source> and </source>
        <translation> かつ </translation>
    </message>
    <message>
        <source>%1: %2 for at least %3 %</source>
        <translation>%1: %2 が %3 % 以上</translation>
    </message>
    <message>
        <source>area x %1 h a year</source>
        <translation>面積 x 年 %1 時間</translation>
    </message>
    <message>
        <source>Least certain of what the verdicts rest on: %1 (%2: %3).</source>
        <translation>判定の根拠のうち最も不確かなもの: %1 (%2: %3)。</translation>
    </message>
    <message>
        <source>%1: %2; now %3</source>
        <translation>%1: %2。現在 %3</translation>
    </message>
    <message>
        <source>V: read in the rule&apos;s text or on an official page; R: reported by practice; U: not checked against the rule&apos;s text.</source>
        <translation>V: 規定の本文か公式ページで確認。R: 実務による報告。U: 規定の本文と未照合。</translation>
    </message>
    <message>
        <source>figures only</source>
        <translation>数値のみ</translation>
    </message>
    <message>
        <source>%1 x former</source>
        <translation>以前の %1 倍</translation>
    </message>
    <message>
        <source>loss %1</source>
        <translation>減少 %1</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 または %2</translation>
    </message>
    <message>
        <source> (former %1)</source>
        <translation> (以前 %1)</translation>
    </message>
    <message>
        <source> on %1</source>
        <translation> (%1)</translation>
    </message>
    <message>
        <source>, wanted %1</source>
        <translation>、要求 %1</translation>
    </message>
    <message>
        <source>No sun in these hours</source>
        <translation>この時間に太陽なし</translation>
    </message>
    <message>
        <source>The rule states no limit for this place</source>
        <translation>この場所には規定の限度がありません</translation>
    </message>
    <message>
        <source>read in the rule&apos;s text or on an official page</source>
        <translation>規定の本文か公式ページで確認</translation>
    </message>
    <message>
        <source>reported by practice</source>
        <translation>実務による報告</translation>
    </message>
    <message>
        <source>not checked against the rule&apos;s text</source>
        <translation>規定の本文と未照合</translation>
    </message>
    <message>
        <source>none counted</source>
        <translation>対象外</translation>
    </message>
    <message>
        <source>evergreen trees only</source>
        <translation>常緑樹のみ</translation>
    </message>
    <message>
        <source>dense belts of evergreen trees only</source>
        <translation>常緑樹の密な樹林帯のみ</translation>
    </message>
    <message>
        <source>all, as evergreens</source>
        <translation>すべて、常緑として</translation>
    </message>
    <message>
        <source>all, with their seasons</source>
        <translation>すべて、季節を考慮</translation>
    </message>
    <message>
        <source>existing trees with their seasons, and new evergreens</source>
        <translation>既存の樹木は季節を考慮、新しい樹木は常緑樹のみ</translation>
    </message>
    <message>
        <source>sunrise</source>
        <translation>日の出</translation>
    </message>
    <message>
        <source>sunset</source>
        <translation>日没</translation>
    </message>
    <message>
        <source>the latest of</source>
        <translation>最も遅いもの</translation>
    </message>
    <message>
        <source>the earliest of</source>
        <translation>最も早いもの</translation>
    </message>
    <message>
        <source>Trees: %1</source>
        <translation>樹木: %1</translation>
    </message>
    <message>
        <source>; the city has no trees</source>
        <translation>、都市に樹木なし</translation>
    </message>
    <message>
        <source>; trees in the city: %1</source>
        <translation>、都市の樹木: %1</translation>
    </message>
    <message>
        <source>; trees that count: %1 of %2</source>
        <translation>、対象の樹木: %2 本中 %1 本</translation>
    </message>
    <message>
        <source>The engine is the ray reference itself, against which others are measured.</source>
        <translation>このエンジンは、ほかを測る基準となる光線基準そのものです。</translation>
    </message>
    <message>
        <source>The engine&apos;s error against the ray reference was not measured: it was switched off.</source>
        <translation>光線基準に対するエンジンの誤差は、無効にされていたため測定していません。</translation>
    </message>
    <message>
        <source>The engine&apos;s error against the ray reference could not be measured: see the warnings.</source>
        <translation>光線基準に対するエンジンの誤差は測定できませんでした。警告を参照してください。</translation>
    </message>
    <message>
        <source>Each run of minutes is uncertain by a step; each area by half of the cells that its edge passes through, at least by one; each area x hours by these and by half of what the area changes from step to step, where the days of a sum err independently of each other. </source>
        <translation>時間には 1 ステップ、面積には縁が通るセルの半分 (少なくとも 1 個)、面積 x 時間にはその両方とステップ間の面積変化の半分の不確かさがあり、合計の各日の誤差は互いに独立です。 </translation>
    </message>
    <message>
        <source>Worst spots are the worst of the cells&apos; centres and of points around these, down to %1 m from each other; what the nearest found worse is in their error. </source>
        <translation>最悪の点は、セルの中心とその周りの点 (間隔 %1 m まで) のうち最悪のものです。隣の点でさらに悪い分は誤差に含まれます。 </translation>
    </message>
    <message>
        <source>Worst spots are the worst of the cells&apos; centres, and their error includes the cell. </source>
        <translation>最悪の点はセルの中心のうち最悪のもので、誤差にはセルが含まれます。 </translation>
    </message>
    <message>
        <source>Shadow enters and exits up to a step (%1 min) earlier than stated, as each step has the sun of its beginning. </source>
        <translation>各ステップはその始まりの太陽を用いるため、影の開始と終了は表示より最大 1 ステップ (%1 分) 早くなります。 </translation>
    </message>
    <message>
        <source>A value within its error of a limit is borderline, never pass.</source>
        <translation>限度との差が誤差以内の値は境界とし、適合とはしません。</translation>
    </message>
    <message>
        <source>the ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>roofs</source>
        <translation>屋根</translation>
    </message>
    <message>
        <source>the ground and roofs</source>
        <translation>地面と屋根</translation>
    </message>
    <message>
        <source>day %1 of %2</source>
        <translation>%2%1日</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>測定なし</translation>
    </message>
    <message>
        <source>%1 % mean, %2 % largest, against rays</source>
        <translation>レイに対し平均 %1 %、最大 %2 %</translation>
    </message>
</context>
</TS>
