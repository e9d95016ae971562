<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>Error</name>
    <message>
        <source>No city is open</source>
        <translation>No hay ninguna ciudad abierta</translation>
    </message>
    <message>
        <source>Open a file or a sample first</source>
        <translation>Abra antes un archivo o un ejemplo</translation>
    </message>
    <message>
        <source>This result is already saved</source>
        <translation>Este resultado ya está guardado</translation>
    </message>
    <message>
        <source>Another result is being saved</source>
        <translation>Se está guardando otro resultado</translation>
    </message>
    <message>
        <source>Wait until it is saved</source>
        <translation>Espere a que se guarde</translation>
    </message>
    <message>
        <source>There is no result to save</source>
        <translation>No hay resultado que guardar</translation>
    </message>
    <message>
        <source>There is no result to export</source>
        <translation>No hay resultado que exportar</translation>
    </message>
    <message>
        <source>There are no figures to copy</source>
        <translation>No hay cifras que copiar</translation>
    </message>
    <message>
        <source>Press Run first</source>
        <translation>Pulse antes Calcular</translation>
    </message>
    <message>
        <source>The file was not opened: the project was changed while it was read</source>
        <translation>El archivo no se abrió: el proyecto cambió mientras se leía</translation>
    </message>
    <message>
        <source>Save or undo the change, then open the file again</source>
        <translation>Guarde o deshaga el cambio y abra el archivo de nuevo</translation>
    </message>
    <message>
        <source>The picture could not be written</source>
        <translation>No se pudo escribir la imagen</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Elija otra carpeta</translation>
    </message>
    <message>
        <source>No ground of the city is visible</source>
        <translation>No se ve suelo de la ciudad</translation>
    </message>
    <message>
        <source>Move the view to the city first</source>
        <translation>Mueva antes la vista a la ciudad</translation>
    </message>
    <message>
        <source>The project has no lots, and this rule is about parcels</source>
        <translation>El proyecto no tiene parcelas, y esta norma trata de parcelas</translation>
    </message>
    <message>
        <source>Draw the lot of the proposal: Edit &gt; Draw lot</source>
        <translation>Dibuje la parcela de la propuesta: Editar &gt; Dibujar parcela</translation>
    </message>
    <message>
        <source>The project has no places yet</source>
        <translation>El proyecto aún no tiene lugares</translation>
    </message>
    <message>
        <source>Read them from a map or draw one: Study &gt; Read places, Study &gt; Draw place</source>
        <translation>Léalos de un mapa o dibuje uno: Estudio &gt; Leer lugares, Estudio &gt; Dibujar lugar</translation>
    </message>
    <message>
        <source>No place is chosen</source>
        <translation>No hay ningún lugar elegido</translation>
    </message>
    <message>
        <source>Design a tower, or choose a scenario with a proposal</source>
        <translation>Diseñe una torre o elija un escenario con una propuesta</translation>
    </message>
    <message>
        <source>The building is still being designed</source>
        <translation>El edificio aún se está diseñando</translation>
    </message>
    <message>
        <source>Build it, then run the review</source>
        <translation>Constrúyalo y evalúe</translation>
    </message>
    <message>
        <source>There is no review to export</source>
        <translation>No hay evaluación que exportar</translation>
    </message>
    <message>
        <source>Press Run review first</source>
        <translation>Pulse antes Evaluar</translation>
    </message>
    <message>
        <source>The sides of the lot cross each other</source>
        <translation>Los lados de la parcela se cruzan</translation>
    </message>
    <message>
        <source>Draw the corners in order around the lot</source>
        <translation>Dibuje las esquinas en orden alrededor de la parcela</translation>
    </message>
    <message>
        <source>The polygon has no area</source>
        <translation>El polígono no tiene área</translation>
    </message>
    <message>
        <source>Draw it again with corners farther apart</source>
        <translation>Dibújelo de nuevo con esquinas más separadas</translation>
    </message>
    <message>
        <source>Click more corners, or press Esc</source>
        <translation>Haga clic en más esquinas o pulse Esc</translation>
    </message>
    <message>
        <source>There is no region or place of this name</source>
        <translation>No hay zona ni lugar con ese nombre</translation>
    </message>
    <message>
        <source>Choose one from the list</source>
        <translation>Elija uno de la lista</translation>
    </message>
    <message>
        <source>No corner is selected</source>
        <translation>No hay ninguna esquina seleccionada</translation>
    </message>
    <message>
        <source>Click a corner of the lot, then press Delete</source>
        <translation>Haga clic en una esquina de la parcela y pulse Supr</translation>
    </message>
    <message>
        <source>The direction of the side is not known</source>
        <translation>No se conoce la dirección del lado</translation>
    </message>
    <message>
        <source>Move the cursor to where the side leads, or type an azimuth: 40&lt;90</source>
        <translation>Mueva el cursor hacia donde va el lado, o escriba un acimut: 40&lt;90</translation>
    </message>
    <message>
        <source>This is not a length</source>
        <translation>Esto no es una longitud</translation>
    </message>
    <message>
        <source>Type it as 40, 40 m or 131&apos; 3&quot;, with an azimuth as 40&lt;90</source>
        <translation>Escríbala como 40, 40 m o 131&apos; 3&quot;, con acimut como 40&lt;90</translation>
    </message>
    <message>
        <source>Some scenarios could not be computed</source>
        <translation>Algunos escenarios no se pudieron calcular</translation>
    </message>
    <message>
        <source>The panel Scenarios says why in the row of each</source>
        <translation>El panel Escenarios dice el motivo en la fila de cada uno</translation>
    </message>
    <message>
        <source>The folder holds no buildings</source>
        <translation>La carpeta no contiene edificios</translation>
    </message>
    <message>
        <source>Choose a folder of footprints, city models or meshes</source>
        <translation>Elija una carpeta con huellas, modelos de ciudad o mallas</translation>
    </message>
    <message>
        <source>The city has a terrain already</source>
        <translation>La ciudad ya tiene terreno</translation>
    </message>
    <message>
        <source>Open the city without it first</source>
        <translation>Abra antes la ciudad sin él</translation>
    </message>
    <message>
        <source>A terrain can be added to city files only, before they are saved as a project</source>
        <translation>Solo se puede añadir un terreno a archivos de ciudad, antes de guardarlos como proyecto</translation>
    </message>
    <message>
        <source>Open the city files and the terrain together</source>
        <translation>Abra juntos los archivos de ciudad y el terreno</translation>
    </message>
    <message>
        <source>The city has an aerial photograph already</source>
        <translation>La ciudad ya tiene una fotografía aérea</translation>
    </message>
    <message>
        <source>Remove it first: File &gt; Aerial photograph</source>
        <translation>Quítela antes: Archivo &gt; Fotografía aérea</translation>
    </message>
    <message>
        <source>The file holds no such places near the city</source>
        <translation>El archivo no contiene lugares de este tipo cerca de la ciudad</translation>
    </message>
    <message>
        <source>Choose a map of this city with parks or streets, or a file of polygons</source>
        <translation>Elija un mapa de esta ciudad con parques o calles, o un archivo de polígonos</translation>
    </message>
    <message>
        <source>The project has no place of this name any more</source>
        <translation>El proyecto ya no tiene ningún lugar con este nombre</translation>
    </message>
    <message>
        <source>Run again, so that the table lists the places as they are</source>
        <translation>Vuelva a calcular para que la tabla muestre los lugares tal como son</translation>
    </message>
    <message>
        <source>Tick the places to review, or press In reach to find those that the shadow reaches</source>
        <translation>Marque los lugares que se revisan, o pulse «Al alcance» para hallar los que alcanza la sombra</translation>
    </message>
    <message>
        <source>It holds terrains only: open one by Open, or choose a folder of footprints, city models or meshes</source>
        <translation>Solo contiene terrenos: abra uno con Abrir, o elija una carpeta de huellas, modelos de ciudad o mallas</translation>
    </message>
    <message>
        <source>There is no result</source>
        <translation>No hay ningún resultado</translation>
    </message>
</context>
<context>
    <name>FieldText</name>
    <message>
        <source>The rule of a review board by which the ticked places are judged. The list has the rules that come with Noonmark and those of your own.</source>
        <translation>La norma de una autoridad con la que se juzgan los lugares marcados. La lista tiene las normas que trae Noonmark y las suyas propias.</translation>
    </message>
    <message>
        <source>The scenario with the proposal. Displayed: whichever is chosen at the top of the window.</source>
        <translation>El escenario con la propuesta. Mostrado: el que esté elegido en la parte superior de la ventana.</translation>
    </message>
    <message>
        <source>A choice that the rule leaves to the case, such as a district or a zone.</source>
        <translation>Una opción que la norma deja al caso, como un distrito o una zona.</translation>
    </message>
    <message>
        <source>How exactly the shadow is computed. The line below the list says what each choice means; its error is measured and stated beside the legend.</source>
        <translation>Con qué exactitud se calcula la sombra. La línea bajo la lista explica cada opción; su error se mide y aparece junto a la leyenda.</translation>
    </message>
    <message>
        <source>Shows or hides the time zone, the step of the sun and how sunrise is defined.</source>
        <translation>Muestra u oculta la zona horaria, el paso del sol y cómo se define el amanecer.</translation>
    </message>
    <message>
        <source>Shows or hides the method and its options, for experts.</source>
        <translation>Muestra u oculta el método y sus opciones, para expertos.</translation>
    </message>
    <message>
        <source>What the chart of a range of days shows: shadow in the scenario, in the baseline, or what the scenario adds.</source>
        <translation>Qué muestra el gráfico de un intervalo de días: sombra en el escenario, en la referencia o la que añade el escenario.</translation>
    </message>
    <message>
        <source>The places with their verdicts, and below each its days with the numbers behind it. A click shows the timeline, a double click zooms to the place.</source>
        <translation>Los lugares con sus dictámenes y, debajo, los días con sus cifras. Un clic muestra la cronología; un doble clic acerca al lugar.</translation>
    </message>
    <message>
        <source>What the proposal is compared with.</source>
        <translation>Con qué se compara la propuesta.</translation>
    </message>
    <message>
        <source>Lists only the places whose name or kind contains this text.</source>
        <translation>Lista solo los lugares cuyo nombre o tipo contiene este texto.</translation>
    </message>
    <message>
        <source>The places that the review judges: those with a tick.</source>
        <translation>Los lugares que se evalúan: los marcados.</translation>
    </message>
    <message>
        <source>The size of the floor plate: as a share of the lot in per cent, or as an area in square metres.</source>
        <translation>El tamaño de la planta: como parte de la parcela en tanto por ciento o como área en metros cuadrados.</translation>
    </message>
    <message>
        <source>Adds a height above which the walls are set back from the edge of the plate.</source>
        <translation>Añade una altura por encima de la cual los muros se retranquean.</translation>
    </message>
    <message>
        <source>Removes the selected setback.</source>
        <translation>Quita el retranqueo seleccionado.</translation>
    </message>
    <message>
        <source>Heights, and how far the walls are set back above each, metres.</source>
        <translation>Alturas, y cuánto se retranquean los muros por encima de cada una, metros.</translation>
    </message>
    <message>
        <source>Ends placing; the scenario stays as it is.</source>
        <translation>Termina la colocación; el escenario no cambia.</translation>
    </message>
    <message>
        <source>All that the project holds. Enter or a double click shows or uses a row, F2 renames it, Delete removes it, a right click has more.</source>
        <translation>Todo lo que contiene el proyecto. Intro o doble clic muestra o usa una fila, F2 cambia el nombre, Supr la quita, un clic derecho ofrece más.</translation>
    </message>
    <message>
        <source>The scenarios side by side, with their figures for the same period and region. A click on a heading sorts them.</source>
        <translation>Los escenarios con sus cifras para el mismo periodo y zona. Un clic en un encabezado los ordena.</translation>
    </message>
    <message>
        <source>The intervals of the weight table: days of the year, hours of the day, and a weight from -1 (shadow unwanted) to 1 (shade wanted). Double-click a cell to change it.</source>
        <translation>Los intervalos de la tabla de pesos: días del año, horas del día y un peso de -1 (no deseada) a 1 (deseada). Doble clic cambia una celda.</translation>
    </message>
    <message>
        <source>Does what the message proposes.</source>
        <translation>Hace lo que propone el mensaje.</translation>
    </message>
    <message>
        <source>Does the other thing that the message proposes.</source>
        <translation>Hace lo otro que propone el mensaje.</translation>
    </message>
    <message>
        <source>The date that is shown, in the year of the period.</source>
        <translation>La fecha mostrada, en el año del periodo.</translation>
    </message>
    <message>
        <source>The wall-clock time that is shown, in the time zone of the study.</source>
        <translation>La hora local mostrada, en la zona horaria del estudio.</translation>
    </message>
    <message>
        <source>The windows with their verdicts before and after, those that get worse first. A click on a column sorts by it, a click on a row tells when its window has sun.</source>
        <translation>Las ventanas con sus veredictos antes y después, primero las que empeoran. Un clic en una columna ordena por ella, un clic en una fila dice cuándo tiene sol su ventana.</translation>
    </message>
    <message>
        <source>The places with their hours of sun. A click on a heading sorts them, a click on a row shows its place in the view.</source>
        <translation>Los lugares con sus horas de sol. Un clic en un encabezado los ordena, un clic en una fila muestra su lugar en la vista.</translation>
    </message>
    <message>
        <source>The names of the scenarios, which stay in sight when the table is scrolled sideways. A double click shows a scenario.</source>
        <translation>Los nombres de los escenarios, que siguen a la vista al desplazar la tabla lateralmente. Un doble clic muestra un escenario.</translation>
    </message>
    <message>
        <source>What the study answers: minutes of shadow, the change that a scenario makes, a score of wanted and unwanted shadow, the verdicts of a board&apos;s rule, or the hours of sun of places.</source>
        <translation>Qué responde el estudio: minutos de sombra, el cambio que causa un escenario, una puntuación de sombra deseada y no deseada, los dictámenes según la norma de una autoridad o las horas de sol de los lugares.</translation>
    </message>
</context>
<context>
    <name>KeySheet</name>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>left or middle drag</source>
        <translation>arrastrar con el botón izquierdo o central</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Desplazar</translation>
    </message>
    <message>
        <source>right drag, Shift+drag, arrow keys</source>
        <translation>arrastrar con el botón derecho, Mayús+arrastrar, teclas de flecha</translation>
    </message>
    <message>
        <source>Zoom to the cursor</source>
        <translation>Acercar hacia el cursor</translation>
    </message>
    <message>
        <source>wheel, + and -</source>
        <translation>rueda, + y -</translation>
    </message>
    <message>
        <source>Menu of what is there</source>
        <translation>Menú de lo que hay ahí</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>clic derecho</translation>
    </message>
    <message>
        <source>Buildings</source>
        <translation>Edificios</translation>
    </message>
    <message>
        <source>Select; another too</source>
        <translation>Seleccionar; otro más</translation>
    </message>
    <message>
        <source>click; Ctrl+click</source>
        <translation>clic; Ctrl+clic</translation>
    </message>
    <message>
        <source>Select all in a rectangle</source>
        <translation>Seleccionar todo en un rectángulo</translation>
    </message>
    <message>
        <source>drag with Ctrl+Shift</source>
        <translation>arrastrar con Ctrl+Mayús</translation>
    </message>
    <message>
        <source>Change the height</source>
        <translation>Cambiar la altura</translation>
    </message>
    <message>
        <source>drag the arrow, or type the height and press Enter</source>
        <translation>arrastrar la flecha, o escribir la altura y pulsar Intro</translation>
    </message>
    <message>
        <source>Deselect</source>
        <translation>Deseleccionar</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Dibujo</translation>
    </message>
    <message>
        <source>A corner</source>
        <translation>Una esquina</translation>
    </message>
    <message>
        <source>click; with Shift at right angles, with Ctrl without snapping</source>
        <translation>clic; con Mayús en ángulo recto, con Ctrl sin ajuste</translation>
    </message>
    <message>
        <source>A side of a stated length</source>
        <translation>Un lado de longitud indicada</translation>
    </message>
    <message>
        <source>type it and press Enter</source>
        <translation>escribirla y pulsar Intro</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Terminar</translation>
    </message>
    <message>
        <source>double click, Enter or right click</source>
        <translation>doble clic, Intro o clic derecho</translation>
    </message>
    <message>
        <source>Remove the last corner; cancel</source>
        <translation>Quitar la última esquina; cancelar</translation>
    </message>
    <message>
        <source>Backspace; Esc</source>
        <translation>Retroceso; Esc</translation>
    </message>
</context>
<context>
    <name>LiveTrees</name>
    <message>
        <source>Live shade of trees</source>
        <translation>Sombra de los árboles en vivo</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Read &amp;places into this project</source>
        <translation>Leer los &amp;lugares en este proyecto</translation>
    </message>
    <message>
        <source>&amp;Open as another city</source>
        <translation>Abrir c&amp;omo otra ciudad</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>medida</translation>
    </message>
    <message>
        <source>from its storeys</source>
        <translation>según sus plantas</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>supuesta</translation>
    </message>
    <message>
        <source>from its mesh</source>
        <translation>de su malla</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>proyectada</translation>
    </message>
    <message>
        <source>synthetic</source>
        <translation>sintética</translation>
    </message>
    <message>
        <source>; mesh is open: %1 estimated</source>
        <translation>; malla abierta: %1 estimado</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Partes</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planta</translation>
    </message>
    <message>
        <source>Floor area</source>
        <translation>Superficie construida</translation>
    </message>
    <message>
        <source>every pixel</source>
        <translation>cada píxel</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Open a project or a city</source>
        <translation>Abrir un proyecto o una ciudad</translation>
    </message>
    <message>
        <source>Save project as</source>
        <translation>Guardar proyecto como</translation>
    </message>
    <message>
        <source>Projects (*%1)</source>
        <translation>Proyectos (*%1)</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation>%1 ya existe. ¿Sustituirlo?</translation>
    </message>
    <message>
        <source>Import a mesh as a building</source>
        <translation>Importar una malla como edificio</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Mallas</translation>
    </message>
    <message>
        <source>Region from file</source>
        <translation>Zona desde archivo</translation>
    </message>
    <message>
        <source>Polygons</source>
        <translation>Polígonos</translation>
    </message>
    <message>
        <source>Read places</source>
        <translation>Leer lugares</translation>
    </message>
    <message>
        <source>Maps and polygons</source>
        <translation>Mapas y polígonos</translation>
    </message>
    <message>
        <source>Save sun and sky</source>
        <translation>Guardar sol y cielo</translation>
    </message>
    <message>
        <source>Drawing (*.svg);;Picture (*.png);;Minutes by month and hour (*.csv)</source>
        <translation>Dibujo (*.svg);;Imagen (*.png);;Minutos por mes y hora (*.csv)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Guardar imagen</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>Export movie</source>
        <translation>Exportar película</translation>
    </message>
    <message>
        <source>Movies (*.mp4 *.gif)</source>
        <translation>Películas (*.mp4 *.gif)</translation>
    </message>
    <message>
        <source>Logo for the title block</source>
        <translation>Logotipo para el cajetín</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Imágenes (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>%1 already contains these files: %2. Replace them?</source>
        <translation>%1 ya contiene estos archivos: %2. ¿Sustituirlos?</translation>
    </message>
    <message>
        <source>Projects, cities and terrain</source>
        <translation>Proyectos, ciudades y terreno</translation>
    </message>
    <message>
        <source>Projects</source>
        <translation>Proyectos</translation>
    </message>
    <message>
        <source>Footprints</source>
        <translation>Huellas de edificios</translation>
    </message>
    <message>
        <source>3D models and meshes</source>
        <translation>Modelos 3D y mallas</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Terreno</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Resultados</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Proyecto</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Escenarios</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesos</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Edificio</translation>
    </message>
    <message>
        <source>Tower</source>
        <translation>Torre</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Evaluación</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>S&amp;un</source>
        <translation>S&amp;ol</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Paneles</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>S&amp;cenario</source>
        <translation>E&amp;scenario</translation>
    </message>
    <message>
        <source>&amp;Study</source>
        <translation>Es&amp;tudio</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>Graphics: OpenGL on the processor; a graphics card is faster</source>
        <translation>Gráficos: OpenGL en el procesador; una tarjeta gráfica es más rápida</translation>
    </message>
    <message>
        <source>Graphics: OpenGL on a graphics card</source>
        <translation>Gráficos: OpenGL en una tarjeta gráfica</translation>
    </message>
    <message>
        <source>System: %1, %2</source>
        <translation>Sistema: %1, %2</translation>
    </message>
    <message>
        <source>this moment</source>
        <translation>este momento</translation>
    </message>
    <message>
        <source>%1; continuous shadow follows</source>
        <translation>%1; la sombra continua viene después</translation>
    </message>
    <message>
        <source>west</source>
        <translation>oeste</translation>
    </message>
    <message>
        <source>east</source>
        <translation>este</translation>
    </message>
    <message>
        <source>south</source>
        <translation>sur</translation>
    </message>
    <message>
        <source>north</source>
        <translation>norte</translation>
    </message>
    <message>
        <source>Gross floor area</source>
        <translation>Superficie construida total</translation>
    </message>
    <message>
        <source>Floor area ratio (FAR)</source>
        <translation>Edificabilidad</translation>
    </message>
    <message>
        <source>Lot coverage</source>
        <translation>Ocupación de la parcela</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>Plantas</translation>
    </message>
    <message>
        <source>Buildings demolished</source>
        <translation>Edificios derribados</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Mostrar</translation>
    </message>
    <message>
        <source>&amp;Zoom to lot</source>
        <translation>&amp;Acercar a la parcela</translation>
    </message>
    <message>
        <source>&amp;Zoom to place</source>
        <translation>&amp;Acercar al lugar</translation>
    </message>
    <message>
        <source>&amp;Use as study region</source>
        <translation>&amp;Usar como zona del estudio</translation>
    </message>
    <message>
        <source>&amp;Use as study period</source>
        <translation>&amp;Usar como periodo del estudio</translation>
    </message>
    <message>
        <source>&amp;Edit and score</source>
        <translation>&amp;Editar y puntuar</translation>
    </message>
    <message>
        <source>City</source>
        <translation>Ciudad</translation>
    </message>
    <message>
        <source>The existing city, from which every scenario starts</source>
        <translation>La ciudad existente, de la que parte cada escenario</translation>
    </message>
    <message>
        <source>Terrain of %1 × %2 points</source>
        <translation>Terreno de %1 × %2 puntos</translation>
    </message>
    <message>
        <source>Flat ground</source>
        <translation>Suelo llano</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>de %1</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>referencia</translation>
    </message>
    <message>
        <source>Press Enter or double-click to show it</source>
        <translation>Pulse Intro o haga doble clic para mostrarlo</translation>
    </message>
    <message>
        <source>Step %1 of %2; press Delete to remove it</source>
        <translation>Paso %1 de %2; Supr lo quita</translation>
    </message>
    <message>
        <source>Lists of changes to the city; the displayed one is bold</source>
        <translation>Listas de cambios de la ciudad; la mostrada va en negrita</translation>
    </message>
    <message>
        <source>The existing city. Press Enter or double-click to show it</source>
        <translation>La ciudad existente. Pulse Intro o haga doble clic para mostrarla</translation>
    </message>
    <message>
        <source>Lots</source>
        <translation>Parcelas</translation>
    </message>
    <message>
        <source>Ground to build on</source>
        <translation>Suelo edificable</translation>
    </message>
    <message>
        <source>%1, roads: %2</source>
        <translation>%1, calles: %2</translation>
    </message>
    <message>
        <source>Press Enter or double-click to zoom to it</source>
        <translation>Pulse Intro o haga doble clic para acercarse</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Zonas</translation>
    </message>
    <message>
        <source>Where shadow is measured</source>
        <translation>Dónde se mide la sombra</translation>
    </message>
    <message>
        <source>Press Enter or double-click to use it as the study region</source>
        <translation>Pulse Intro o haga doble clic para usarla como zona del estudio</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Lugares</translation>
    </message>
    <message>
        <source>Areas whose sunlight matters: parks, playgrounds, school grounds...</source>
        <translation>Áreas cuyo soleamiento importa: parques, zonas de juego, patios escolares...</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1
Press Enter or double-click to zoom to it</source>
        <translation>%1
Pulse Intro o haga doble clic para acercarse</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>Periodos</translation>
    </message>
    <message>
        <source>Days and hours to study</source>
        <translation>Días y horas del estudio</translation>
    </message>
    <message>
        <source>%1
Press Enter or double-click to use it as the study period</source>
        <translation>%1
Pulse Intro o haga doble clic para usarlo como periodo del estudio</translation>
    </message>
    <message>
        <source>Weight tables</source>
        <translation>Tablas de pesos</translation>
    </message>
    <message>
        <source>How much shade is wanted (up to 1) or shadow unwanted (down to -1), by time of year</source>
        <translation>Cuánto se desea la sombra (hasta 1) o se rechaza (hasta -1), según la época del año</translation>
    </message>
    <message>
        <source>Press Enter or double-click to edit it and compute scores with it</source>
        <translation>Pulse Intro o haga doble clic para editarla y puntuar con ella</translation>
    </message>
    <message>
        <source>Saved results</source>
        <translation>Resultados guardados</translation>
    </message>
    <message>
        <source>Maps and figures saved in the project</source>
        <translation>Mapas y cifras guardados en el proyecto</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 comparado con %2</translation>
    </message>
    <message>
        <source>%1 of %2
Press Enter or double-click to show it again</source>
        <translation>%1 de %2
Pulse Intro o haga doble clic para volver a mostrarlo</translation>
    </message>
    <message>
        <source>Contribution of this new building alone: ground with over %1 min a day more gross shadow than without it</source>
        <translation>Contribución de este edificio nuevo por sí solo: suelo con más de %1 min al día de sombra total adicional</translation>
    </message>
    <message>
        <source>no change</source>
        <translation>sin cambios</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 más</translation>
    </message>
    <message>
        <source>%1 less</source>
        <translation>%1 menos</translation>
    </message>
    <message>
        <source>Compared</source>
        <translation>Comparado</translation>
    </message>
    <message>
        <source>%1
with %2</source>
        <translation>%1
con %2</translation>
    </message>
    <message>
        <source>Minutes of the first minus minutes of the second, with the same engine, steps and cells</source>
        <translation>Minutos del primero menos minutos del segundo, con el mismo motor, pasos y celdas</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periodo</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Motor de cálculo</translation>
    </message>
    <message>
        <source>Used for both</source>
        <translation>Usado para ambos</translation>
    </message>
    <message>
        <source>Measured error against rays: %1 % of the area, %2 % of the minutes of a cell</source>
        <translation>Error medido frente a rayos: %1 % del área, %2 % de los minutos de una celda</translation>
    </message>
    <message>
        <source>Continuous shadow was not counted</source>
        <translation>La sombra continua no se contó</translation>
    </message>
    <message>
        <source>So far: %1 (%2 %)</source>
        <translation>Hasta ahora: %1 (%2 %)</translation>
    </message>
    <message>
        <source>%1 with the weights %2</source>
        <translation>%1 con los pesos %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>formerly ground, now built over</source>
        <translation>antes suelo, ahora edificado</translation>
    </message>
    <message>
        <source>formerly building, now ground</source>
        <translation>antes edificio, ahora suelo</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>no medido</translation>
    </message>
    <message>
        <source>now in shadow</source>
        <translation>ahora en sombra</translation>
    </message>
    <message>
        <source>now in the sun</source>
        <translation>ahora al sol</translation>
    </message>
    <message>
        <source>change: gross %1 min a day</source>
        <translation>cambio: total %1 min al día</translation>
    </message>
    <message>
        <source>, continuous %1 min</source>
        <translation>, continua %1 min</translation>
    </message>
    <message>
        <source>So far: %1</source>
        <translation>Hasta ahora: %1</translation>
    </message>
    <message>
        <source>Refining: %1</source>
        <translation>Refinando: %1</translation>
    </message>
    <message>
        <source>Computing the shadow in the view...</source>
        <translation>Calculando la sombra de la vista...</translation>
    </message>
    <message>
        <source>No study yet: choose a period and a region, then press Run (Ctrl+R)</source>
        <translation>Aún no hay estudio: elija un periodo y una zona y pulse Calcular (Ctrl+R)</translation>
    </message>
    <message>
        <source>Against the ray reference, on a sample of the receivers over the same steps</source>
        <translation>Frente a la referencia por rayos, en una muestra de los receptores con los mismos pasos</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Time taken by the engine</source>
        <translation>Tiempo que tardó el motor</translation>
    </message>
    <message>
        <source>Steps of the sun</source>
        <translation>Posiciones del sol</translation>
    </message>
    <message>
        <source>Sunlit time</source>
        <translation>Tiempo de sol</translation>
    </message>
    <message>
        <source> min/day</source>
        <translation> min/día</translation>
    </message>
    <message>
        <source>Mean minutes a day with the sun above the horizon: 100 % of the time</source>
        <translation>Minutos medios al día con el sol sobre el horizonte: 100 % del tiempo</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Puntuado</translation>
    </message>
    <message>
        <source>%1
with the weights %2</source>
        <translation>%1
con los pesos %2</translation>
    </message>
    <message>
        <source>at an unknown date</source>
        <translation>en fecha desconocida</translation>
    </message>
    <message>
        <source>Saved %1: %2</source>
        <translation>Guardado %1: %2</translation>
    </message>
    <message>
        <source>%1. Outdated</source>
        <translation>%1. Desactualizado</translation>
    </message>
    <message>
        <source>Saved result</source>
        <translation>Resultado guardado</translation>
    </message>
    <message>
        <source>As saved in the project, not recomputed</source>
        <translation>Tal como se guardó en el proyecto, sin recalcular</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Zona</translation>
    </message>
    <message>
        <source>%1
cells of %2 m</source>
        <translation>%1
celdas de %2 m</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>sin nombre</translation>
    </message>
    <message>
        <source>Computed by</source>
        <translation>Calculado por</translation>
    </message>
    <message>
        <source>%1, saved %2</source>
        <translation>%1, guardado %2</translation>
    </message>
    <message>
        <source>A result saved %1.</source>
        <translation>Un resultado guardado %1.</translation>
    </message>
    <message>
        <source>Its inputs have not changed since.</source>
        <translation>Sus datos no han cambiado desde entonces.</translation>
    </message>
    <message>
        <source>Of a theoretical sum of %1, %2 % are in shadow in the baseline and %3 % in the scenario; incremental shadow takes %4 (%5 %)</source>
        <translation>De una suma teórica de %1, el %2 % está en sombra en la referencia y el %3 % en el escenario; la sombra añadida quita %4 (%5 %)</translation>
    </message>
    <message>
        <source>, most on %1</source>
        <translation>, sobre todo el %1</translation>
    </message>
    <message>
        <source>✓ pass</source>
        <translation>✓ cumple</translation>
    </message>
    <message>
        <source>≈ borderline</source>
        <translation>≈ en el límite</translation>
    </message>
    <message>
        <source>✗ fail</source>
        <translation>✗ no cumple</translation>
    </message>
    <message>
        <source>– not applicable</source>
        <translation>– no aplicable</translation>
    </message>
    <message>
        <source>? not checked</source>
        <translation>? no comprobado</translation>
    </message>
    <message>
        <source>building</source>
        <translation>edificio</translation>
    </message>
    <message>
        <source>building, %1</source>
        <translation>edificio, %1</translation>
    </message>
    <message>
        <source>lot</source>
        <translation>parcela</translation>
    </message>
    <message>
        <source>street</source>
        <translation>calle</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>y %1 más</translation>
    </message>
    <message>
        <source>park</source>
        <translation>parque</translation>
    </message>
    <message>
        <source>playground</source>
        <translation>zona de juegos</translation>
    </message>
    <message>
        <source>schoolyard</source>
        <translation>patio escolar</translation>
    </message>
    <message>
        <source>plaza</source>
        <translation>plaza</translation>
    </message>
    <message>
        <source>cemetery</source>
        <translation>cementerio</translation>
    </message>
    <message>
        <source>facade</source>
        <translation>fachada</translation>
    </message>
    <message>
        <source>stained glass</source>
        <translation>vidriera</translation>
    </message>
    <message>
        <source>other place</source>
        <translation>otro lugar</translation>
    </message>
    <message>
        <source>No region yet</source>
        <translation>Aún sin zona</translation>
    </message>
    <message>
        <source>%1 million</source>
        <translation>%1 millones de</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1 %2 Rays would take %3.</source>
        <translation>%1 %2 Con rayos: %3.</translation>
    </message>
    <message>
        <source>days</source>
        <translation>días</translation>
    </message>
    <message>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>about %1 %2</source>
        <translation>unos %1 %2</translation>
    </message>
    <message>
        <source>about a second</source>
        <translation>alrededor de un segundo</translation>
    </message>
    <message>
        <source>%1 %2: %3</source>
        <translation>%1 %2: %3</translation>
    </message>
    <message>
        <source>and %1 more, listed in study.json of an export</source>
        <translation>y %1 más, en study.json de una exportación</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Rápida</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exacta</translation>
    </message>
    <message>
        <source>Reference (rays)</source>
        <translation>Referencia (rayos)</translation>
    </message>
    <message>
        <source>Own settings</source>
        <translation>Ajustes propios</translation>
    </message>
    <message>
        <source>Exact where that is quick; over long periods off by 0.04 % of the time on average, and the error is measured</source>
        <translation>Exacta donde es rápido; en periodos largos se desvía un 0,04 % del tiempo de media, y el error se mide</translation>
    </message>
    <message>
        <source>The outline of every shadow at every step, without rounding</source>
        <translation>El contorno de cada sombra en cada paso, sin redondeo</translation>
    </message>
    <message>
        <source>One ray for every cell and step: what the other ways are checked against</source>
        <translation>Un rayo por celda y paso: con ello se comprueban los otros métodos</translation>
    </message>
    <message>
        <source>The method and the options chosen below</source>
        <translation>El método y las opciones elegidos abajo</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Hoy</translation>
    </message>
    <message>
        <source>21 March</source>
        <translation>21 de marzo</translation>
    </message>
    <message>
        <source>21 June</source>
        <translation>21 de junio</translation>
    </message>
    <message>
        <source>21 December</source>
        <translation>21 de diciembre</translation>
    </message>
    <message>
        <source>Growing season (October to April)</source>
        <translation>Época de crecimiento (octubre a abril)</translation>
    </message>
    <message>
        <source>Growing season (April to October)</source>
        <translation>Época de crecimiento (abril a octubre)</translation>
    </message>
    <message>
        <source>Whole year</source>
        <translation>Todo el año</translation>
    </message>
    <message>
        <source>Own dates</source>
        <translation>Fechas propias</translation>
    </message>
    <message>
        <source>How many minutes each spot is in shadow on a mean day of the period, and the longest time without a break</source>
        <translation>Cuántos minutos está cada punto en sombra en un día medio del periodo, y el tramo más largo sin interrupción</translation>
    </message>
    <message>
        <source>Minutes of shadow that the scenario adds or takes away, against the city chosen under &quot;compare with&quot;</source>
        <translation>Minutos de sombra que el escenario añade o quita frente a la ciudad elegida en «comparar con»</translation>
    </message>
    <message>
        <source>Shadow weighed by hour and month: wanted in summer, unwanted in winter. Choose the weights in the panel Weights</source>
        <translation>Sombra ponderada por hora y mes: deseada en verano, no deseada en invierno. Elija los pesos en el panel Pesos</translation>
    </message>
    <message>
        <source>Pass or fail of parks and other places by a board&apos;s rule. Choose it in the panel Review</source>
        <translation>Parques y otros lugares según la norma de una autoridad: cumplen o no. Elíjala en el panel Evaluación</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>NE</source>
        <translation>NE</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>SE</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>SW</source>
        <translation>SO</translation>
    </message>
    <message>
        <source>W</source>
        <translation>O</translation>
    </message>
    <message>
        <source>NW</source>
        <translation>NO</translation>
    </message>
    <message>
        <source>Sun below the horizon</source>
        <translation>Sol bajo el horizonte</translation>
    </message>
    <message>
        <source>Sun %1° %2, %3° high</source>
        <translation>Sol %1° %2, altura %3°</translation>
    </message>
    <message>
        <source>%1 % in shadow</source>
        <translation>%1 % en sombra</translation>
    </message>
    <message>
        <source>in shadow</source>
        <translation>en sombra</translation>
    </message>
    <message>
        <source>in the sun</source>
        <translation>al sol</translation>
    </message>
    <message>
        <source>gross %1 min a day</source>
        <translation>total %1 min al día</translation>
    </message>
    <message>
        <source>Ray reference</source>
        <translation>Referencia por rayos</translation>
    </message>
    <message>
        <source>Shadow on the ground of the region, cell by cell, with figures, report and files.
Computed by the engine of the study when you press Run.</source>
        <translation>Sombra en el suelo de la zona, celda a celda, con cifras, informe y archivos.
La calcula el motor del estudio al pulsar Calcular.</translation>
    </message>
    <message>
        <source>in the middle of the picture</source>
        <translation>en el centro de la imagen</translation>
    </message>
    <message>
        <source>%1.
Default: %2</source>
        <translation>%1.
Por defecto: %2</translation>
    </message>
    <message>
        <source>%1.
%2 to %3 %4, usually %5</source>
        <translation>%1.
%2 a %3 %4, normalmente %5</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> de %1</translation>
    </message>
    <message>
        <source>d MMM</source>
        <translation>d MMM</translation>
    </message>
    <message>
        <source>d MMMM</source>
        <translation>d &apos;de&apos; MMMM</translation>
    </message>
    <message>
        <source>d MMM yyyy</source>
        <translation>d MMM yyyy</translation>
    </message>
    <message>
        <source>d MMMM yyyy</source>
        <translation>d &apos;de&apos; MMMM &apos;de&apos; yyyy</translation>
    </message>
    <message>
        <source>%1, %2
%3 floor area, FAR %4</source>
        <translation>%1, %2
%3 construidos, edificabilidad %4</translation>
    </message>
    <message>
        <source>%1 %2, %3 %4</source>
        <translation>%1 %2, %3 %4</translation>
    </message>
    <message>
        <source>%1   height %2   x %3 m, y %4 m</source>
        <translation>%1   altura %2   x %3 m, y %4 m</translation>
    </message>
    <message>
        <source>%1, %2 high</source>
        <translation>%1, %2 de altura</translation>
    </message>
    <message>
        <source>Mo&amp;de</source>
        <translation>Mo&amp;do</translation>
    </message>
    <message>
        <source>Guided &amp;tours</source>
        <translation>&amp;Visitas guiadas</translation>
    </message>
    <message>
        <source>Plan, elevat&amp;ions, from the sun</source>
        <translation>Pl&amp;anta, alzados, desde el sol</translation>
    </message>
    <message>
        <source>&amp;Go to this view</source>
        <translation>&amp;Ir a esta vista</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>paralela</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>en perspectiva</translation>
    </message>
    <message>
        <source>%1, %2 %3</source>
        <translation>%1, %2 %3</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>%1
Press Enter or double-click to go to it</source>
        <translation>%1
Pulse Intro o haga doble clic para ir a ella</translation>
    </message>
    <message>
        <source>%1, %2 up (%3 in space)</source>
        <translation>%1, %2 hacia arriba (%3 en el espacio)</translation>
    </message>
    <message>
        <source>%1, %2 down (%3 in space)</source>
        <translation>%1, %2 hacia abajo (%3 en el espacio)</translation>
    </message>
    <message>
        <source>%1
All sides %2, area %3</source>
        <translation>%1
Todos los lados %2, área %3</translation>
    </message>
    <message>
        <source>%1 h of sun a day, at most %2 h without a break</source>
        <translation>%1 h de sol al día, como máximo %2 h sin interrupción</translation>
    </message>
    <message>
        <source>floor %1, %2</source>
        <translation>planta %1, %2</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Against the ray reference, on a sample of the points over the same steps</source>
        <translation>Frente a la referencia de rayos, en una muestra de los puntos con los mismos pasos</translation>
    </message>
    <message>
        <source>Horizons of the points</source>
        <translation>Horizontes de los puntos</translation>
    </message>
    <message>
        <source>Windows from file</source>
        <translation>Ventanas de un archivo</translation>
    </message>
    <message>
        <source>Points and polygons</source>
        <translation>Puntos y polígonos</translation>
    </message>
    <message>
        <source>Facades and points</source>
        <translation>Fachadas y puntos</translation>
    </message>
    <message>
        <source>the floor plate is smaller</source>
        <translation>la planta es menor</translation>
    </message>
    <message>
        <source>the tower is not turned</source>
        <translation>la torre no está girada</translation>
    </message>
    <message>
        <source>upper setbacks are left out</source>
        <translation>se omiten retranqueos superiores</translation>
    </message>
    <message>
        <source>To fit this lot: %1.</source>
        <translation>Para que quepa en este solar: %1.</translation>
    </message>
    <message>
        <source>Aerial photograph</source>
        <translation>Fotografía aérea</translation>
    </message>
    <message>
        <source>Pictures with a position</source>
        <translation>Imágenes con posición</translation>
    </message>
    <message>
        <source>Save the tiles as a photograph</source>
        <translation>Guardar las teselas como fotografía</translation>
    </message>
    <message>
        <source>GeoTIFF (*.tif)</source>
        <translation>GeoTIFF (*.tif)</translation>
    </message>
    <message>
        <source>Points from file</source>
        <translation>Puntos de un archivo</translation>
    </message>
    <message>
        <source>Tables of points</source>
        <translation>Tablas de puntos</translation>
    </message>
    <message>
        <source>the tower is not twisted</source>
        <translation>la torre no tiene torsión</translation>
    </message>
    <message>
        <source>Use not stated</source>
        <translation>Uso no indicado</translation>
    </message>
    <message>
        <source>From, above datum</source>
        <translation>Desde, sobre el datum</translation>
    </message>
    <message>
        <source>From height</source>
        <translation>Desde la altura</translation>
    </message>
    <message>
        <source>Inset</source>
        <translation>Retranqueo</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Estrechamiento</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torsión</translation>
    </message>
    <message>
        <source>%1, section box</source>
        <translation>%1, caja de corte</translation>
    </message>
    <message>
        <source>Camera, projection, section box and moment, saved with Ctrl+Shift+V</source>
        <translation>Cámara, proyección, caja de corte y momento, guardados con Ctrl+Mayús+V</translation>
    </message>
    <message>
        <source>%1, floor %2   before: %3, after: %4</source>
        <translation>%1, planta %2   antes: %3, después: %4</translation>
    </message>
    <message>
        <source> °</source>
        <translation> °</translation>
    </message>
    <message>
        <source>%1, top %2</source>
        <translation>%1, cota superior %2</translation>
    </message>
    <message>
        <source>%1 above datum</source>
        <translation>%1 sobre el datum</translation>
    </message>
    <message>
        <source>%1 above ground</source>
        <translation>%1 sobre el terreno</translation>
    </message>
    <message numerus="yes">
        <source>%1 more kind(s) of notes</source>
        <translation>
            <numerusform>%1 clase más de avisos</numerusform>
            <numerusform>%1 clases más de avisos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 place(s) were read</source>
        <translation>
            <numerusform>Se ha leído %1 lugar</numerusform>
            <numerusform>Se han leído %1 lugares</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; %1 replace(s) earlier ones</source>
        <translation>
            <numerusform>; %1 sustituye a otro anterior</numerusform>
            <numerusform>; %1 sustituyen a otros anteriores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a sample every %1 pixel(s)</source>
        <translation>
            <numerusform>una muestra cada %1 píxel</numerusform>
            <numerusform>una muestra cada %1 píxeles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 day(s); %3</source>
        <translation>
            <numerusform>%1 de %2 día; %3</numerusform>
            <numerusform>%1 de %2 días; %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>all %1 step(s)</source>
        <translation>
            <numerusform>el %1 paso</numerusform>
            <numerusform>los %1 pasos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 storey(s)</source>
        <translation>
            <numerusform>%1 planta</numerusform>
            <numerusform>%1 plantas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s)</source>
        <translation>
            <numerusform>%1 edificio</numerusform>
            <numerusform>%1 edificios</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 occlusion ray(s) divided by the engine&apos;s time</source>
        <translation>
            <numerusform>%1 rayo de oclusión dividido por el tiempo del motor</numerusform>
            <numerusform>%1 rayos de oclusión divididos por el tiempo del motor</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Positions of the sun above the horizon; %1 below it was/were left out</source>
        <translation>
            <numerusform>Posiciones del sol sobre el horizonte; se omitió %1 por debajo</numerusform>
            <numerusform>Posiciones del sol sobre el horizonte; se omitieron %1 por debajo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 window(s): %2</source>
        <translation>
            <numerusform>%1 ventana: %2</numerusform>
            <numerusform>%1 ventanas: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 window(s): %2.</source>
        <translation>
            <numerusform>%1 ventana: %2.</numerusform>
            <numerusform>%1 ventanas: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Compared with before, %1 get(s) worse and %2 better</source>
        <translation>
            <numerusform>En comparación con antes, %1 empeora y %2 mejoran</numerusform>
            <numerusform>En comparación con antes, %1 empeoran y %2 mejoran</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1
%2 × %3, %4, %5 cell(s)</source>
        <translation>
            <numerusform>%1
%2 × %3, %4, %5 celda</numerusform>
            <numerusform>%1
%2 × %3, %4, %5 celdas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 point(s)</source>
        <translation>
            <numerusform>%1 punto</numerusform>
            <numerusform>%1 puntos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cell(s)</source>
        <translation>
            <numerusform>%1 celda</numerusform>
            <numerusform>%1 celdas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 position(s) of the sun</source>
        <translation>
            <numerusform>%1 posición del sol</numerusform>
            <numerusform>%1 posiciones del sol</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Not counted: %1 building(s) whose floors are not known</source>
        <translation>
            <numerusform>No se cuenta: %1 edificio de plantas desconocidas</numerusform>
            <numerusform>No se cuentan: %1 edificios de plantas desconocidas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>by rays</source>
        <translation>con rayos</translation>
    </message>
    <message>
        <source>by shadow accrual maps</source>
        <translation>con mapas de acumulación de sombra</translation>
    </message>
    <message>
        <source>%1, %2 m, %3</source>
        <translation>%1, %2 m, %3</translation>
    </message>
    <message>
        <source>, storeys of %1</source>
        <translation>, plantas de %1</translation>
    </message>
    <message>
        <source>; %1 without a storey on the ground</source>
        <translation>; %1 sin planta en el suelo</translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s) selected</source>
        <translation>
            <numerusform>%1 edificio seleccionado</numerusform>
            <numerusform>%1 edificios seleccionados</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 over %2 min</source>
        <translation>%1 por encima de %2 min</translation>
    </message>
    <message>
        <source>No new shadow</source>
        <translation>Sin sombra nueva</translation>
    </message>
    <message>
        <source>New shadow: %1</source>
        <translation>Sombra nueva: %1</translation>
    </message>
    <message>
        <source>Worst spot: +%1 min a day</source>
        <translation>Peor punto: +%1 min al día</translation>
    </message>
    <message>
        <source>Less shadow: %1</source>
        <translation>Menos sombra: %1</translation>
    </message>
    <message>
        <source>Less shadow a day: %1</source>
        <translation>Menos sombra al día: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2, up to +%3 min</source>
        <translation>%1: %2, hasta +%3 min</translation>
    </message>
    <message>
        <source> (of the part that is measured)</source>
        <translation> (de la parte medida)</translation>
    </message>
    <message numerus="yes">
        <source>and %1 more place(s)</source>
        <translation>
            <numerusform>y %1 lugar más</numerusform>
            <numerusform>y %1 lugares más</numerusform>
        </translation>
    </message>
    <message>
        <source>exact at %1</source>
        <translation>exacta en %1</translation>
    </message>
    <message numerus="yes">
        <source>exact at %1 of %2 step(s)</source>
        <translation>
            <numerusform>exacta en %1 de %2 paso</numerusform>
            <numerusform>exacta en %1 de %2 pasos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, within 0.25° of azimuth</source>
        <translation>%1, con 0,25° de acimut</translation>
    </message>
    <message>
        <source>With the proposal: %1</source>
        <translation>Con la propuesta: %1</translation>
    </message>
    <message>
        <source>Change by the proposal, compared with %1: %2</source>
        <translation>Cambio por la propuesta respecto a %1: %2</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>esquina</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>borde</translation>
    </message>
    <message>
        <source>sq ft</source>
        <translation>ft²</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source>The change reaches beyond the ground that is measured</source>
        <translation>El cambio llega más allá del suelo medido</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>unos %1</translation>
    </message>
    <message>
        <source>Measured error of the longest shadow against rays, of the longest day: %1 % in the mean, %2 % at the 99th percentile, %3 % at most</source>
        <translation>Error medido de la sombra más larga frente a los rayos, respecto al día más largo: %1 % de media, %2 % en el percentil 99, %3 % como máximo</translation>
    </message>
    <message>
        <source>Measured error against rays: %1 % of the time in the sun</source>
        <translation>Error medido frente a los rayos: %1 % del tiempo al sol</translation>
    </message>
    <message>
        <source>Outdated: buildings have changed</source>
        <translation>Desactualizado: los edificios han cambiado</translation>
    </message>
    <message>
        <source>%1. Outdated: buildings have changed</source>
        <translation>%1. Desactualizado: los edificios han cambiado</translation>
    </message>
    <message>
        <source>%1 &gt; %2 min: %3</source>
        <translation>%1 &gt; %2 min: %3</translation>
    </message>
    <message>
        <source>Saved result %1</source>
        <translation>Resultado guardado %1</translation>
    </message>
    <message>
        <source>The month&apos;s contribution to the score</source>
        <translation>La contribución del mes a la puntuación</translation>
    </message>
    <message>
        <source>Interval of the table: its weight, and its contribution to the score</source>
        <translation>Intervalo de la tabla: su peso y su contribución a la puntuación</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>Guardar tabla</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tablas (*.csv)</translation>
    </message>
    <message>
        <source>A cell: %1 %3 in the mean, 99 of 100 within %2 %3</source>
        <translation>Una celda: %1 %3 de media, 99 de cada 100 dentro de %2 %3</translation>
    </message>
    <message>
        <source>%1 h of sun a day (%2 % of the sunlit time)</source>
        <translation>%1 h de sol al día (%2 % del tiempo con sol)</translation>
    </message>
    <message>
        <source>, continuous shadow %1 min</source>
        <translation>, sombra continua %1 min</translation>
    </message>
    <message>
        <source>change: sun %1 min a day</source>
        <translation>cambio: sol %1 min al día</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a term and its definition</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 min a day in shadow</source>
        <translation>%1 min al día en sombra</translation>
    </message>
    <message>
        <source>%1 min a day in shadow, %2 % of the sunlit time</source>
        <translation>%1 min al día en sombra, %2 % del tiempo con sol</translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s) shade it; %2 takes the most, %3 %</source>
        <translation>
            <numerusform>%1 edificio le da sombra; %2 es el que más quita, %3 %</numerusform>
            <numerusform>%1 edificios le dan sombra; %2 es el que más quita, %3 %</numerusform>
        </translation>
    </message>
    <message>
        <source>No building shades it in the period.</source>
        <translation>Ningún edificio le da sombra en el periodo.</translation>
    </message>
    <message>
        <source>The scenario minus the scenario without this building: what it adds alone, on ground that is open in both scenarios</source>
        <translation>El escenario menos el escenario sin este edificio: lo que añade por sí solo, en suelo libre en ambos escenarios</translation>
    </message>
    <message>
        <source>Share, %</source>
        <translation>Parte, %</translation>
    </message>
    <message>
        <source>Share of the sum of what each new building adds alone</source>
        <translation>De lo que los edificios nuevos añaden por sí solos, todos juntos</translation>
    </message>
    <message>
        <source>Adds, min a day</source>
        <translation>Añade, min al día</translation>
    </message>
    <message>
        <source>; mean over the cells</source>
        <translation>; media de las celdas</translation>
    </message>
    <message>
        <source>Adds a day</source>
        <translation>Añade al día</translation>
    </message>
    <message>
        <source>; area × hours a day</source>
        <translation>; área × horas al día</translation>
    </message>
    <message>
        <source>Attributed by: %1
The study: %2</source>
        <translation>Atribuido con: %1
El estudio: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 compared with %2: %3 min a day in shadow, mean over %4 cell(s).</source>
        <translation>
            <numerusform>%1 comparado con %2: %3 min al día en sombra, media de %4 celda.</numerusform>
            <numerusform>%1 comparado con %2: %3 min al día en sombra, media de %4 celdas.</numerusform>
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
        <translation>%1, %</translation>
    </message>
    <message>
        <source>%1, m²</source>
        <translation>%1, m²</translation>
    </message>
    <message>
        <source>%1, min</source>
        <translation>%1, min</translation>
    </message>
    <message>
        <source>%1, h</source>
        <translation>%1, h</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>This method does not sum months. These do: %1.</source>
        <translation>Este método no suma por meses. Estos sí: %1.</translation>
    </message>
    <message>
        <source>This method does not tell buildings apart. These do: %1.</source>
        <translation>Este método no distingue los edificios. Estos sí: %1.</translation>
    </message>
    <message>
        <source>Hours of sun a day of each park, street and other place: over the period, by month and on stated dates, in a table beside the map</source>
        <translation>Horas de sol al día de cada parque, calle y otro lugar: en el periodo, por mes y en fechas indicadas, en una tabla junto al mapa</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>Contribuciones</translation>
    </message>
    <message>
        <source>%1 h of sun a day</source>
        <translation>%1 h de sol al día</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>%1, %2 without a cell</source>
        <translation>%1, %2 sin celda</translation>
    </message>
    <message>
        <source>Each is a row of the panel Places</source>
        <translation>Cada uno es una fila del panel Lugares</translation>
    </message>
    <message>
        <source>Without shadow</source>
        <translation>Sin sombra</translation>
    </message>
    <message>
        <source>Sun above the horizon, mean over the days</source>
        <translation>Sol sobre el horizonte, media de los días</translation>
    </message>
    <message>
        <source>Least sun</source>
        <translation>Sol mínimo</translation>
    </message>
    <message>
        <source>Most sun</source>
        <translation>Sol máximo</translation>
    </message>
    <message>
        <source>Against the ray reference, on a sample of the cells over the same steps</source>
        <translation>Frente a la referencia por rayos, en una muestra de las celdas con los mismos pasos</translation>
    </message>
    <message>
        <source>Time taken by all of it</source>
        <translation>Tiempo que tardó todo</translation>
    </message>
    <message>
        <source>Parks</source>
        <translation>Parques</translation>
    </message>
    <message>
        <source>Playgrounds</source>
        <translation>Zonas de juego</translation>
    </message>
    <message>
        <source>Schoolyards</source>
        <translation>Patios escolares</translation>
    </message>
    <message>
        <source>Plazas</source>
        <translation>Plazas</translation>
    </message>
    <message>
        <source>Cemeteries</source>
        <translation>Cementerios</translation>
    </message>
    <message>
        <source>Streets</source>
        <translation>Calles</translation>
    </message>
    <message>
        <source>Facades</source>
        <translation>Fachadas</translation>
    </message>
    <message>
        <source>Stained glass</source>
        <translation>Vidrieras</translation>
    </message>
    <message>
        <source>Other places</source>
        <translation>Otros lugares</translation>
    </message>
    <message>
        <source>&amp;Copy the values</source>
        <translation>&amp;Copiar los valores</translation>
    </message>
    <message>
        <source>Contribution of this new building alone: ground that loses over %1 min of sun a day by it</source>
        <translation>Contribución de este edificio nuevo por sí solo: suelo que pierde por él más de %1 min de sol al día</translation>
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
        <source>Export buildings</source>
        <translation>Exportar edificios</translation>
    </message>
    <message>
        <source>Attributed by: %1</source>
        <translation>Atribuido por: %1</translation>
    </message>
    <message>
        <source>– figures only</source>
        <translation>– solo cifras</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>Error: %1</translation>
    </message>
    <message numerus="yes">
        <source>Against the ray reference, of a sample of %1 value(s)</source>
        <translation>
            <numerusform>Frente a la referencia de rayos, en una muestra de %1 valor</numerusform>
            <numerusform>Frente a la referencia de rayos, en una muestra de %1 valores</numerusform>
        </translation>
    </message>
    <message>
        <source>lawn or bed</source>
        <translation>césped o parterre</translation>
    </message>
    <message>
        <source>Lawns and beds</source>
        <translation>Céspedes y parterres</translation>
    </message>
    <message>
        <source>the whole lot</source>
        <translation>toda la parcela</translation>
    </message>
    <message>
        <source> (top: %1)</source>
        <translation> (última: %1)</translation>
    </message>
    <message>
        <source>%1   %2</source>
        <translation>%1   %2</translation>
    </message>
    <message>
        <source>Hides these panels, for more of the view, and shows them again</source>
        <translation>Oculta estos paneles, para ver más, y los vuelve a mostrar</translation>
    </message>
    <message>
        <source>Panels at the left</source>
        <translation>Paneles de la izquierda</translation>
    </message>
    <message>
        <source>Panels at the right</source>
        <translation>Paneles de la derecha</translation>
    </message>
    <message>
        <source>Panels below</source>
        <translation>Paneles inferiores</translation>
    </message>
    <message>
        <source>As&amp;k</source>
        <translation>&amp;Preguntar</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>takes %1 min of sun a day, %2 % of its shadow</source>
        <translation>quita %1 min de sol al día, el %2 % de su sombra</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Observación</translation>
    </message>
    <message>
        <source>%1 million rays a second</source>
        <translation>%1 millones de rayos por segundo</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ahora</translation>
    </message>
    <message>
        <source>Sun and shadow of a moment or a period on all visible surfaces: ground, roofs and facades.
Updated when the view or the time changes, coarse at first, then pixel by pixel.</source>
        <translation>Sol y sombra de un momento o un periodo en todas las superficies visibles: suelo, tejados y fachadas.
Se actualiza al cambiar la vista o la hora, primero de forma aproximada y luego píxel a píxel.</translation>
    </message>
    <message>
        <source>Verdicts by the rules of review boards, of a proposal or of the existing city.
Opens the panel Review.</source>
        <translation>Dictámenes según las normas de las autoridades, de una propuesta o de la ciudad existente.
Abre el panel Evaluación.</translation>
    </message>
    <message>
        <source>Heights of buildings:</source>
        <translation>Alturas de los edificios:</translation>
    </message>
    <message>
        <source>height %1</source>
        <translation>altura %1</translation>
    </message>
    <message numerus="yes">
        <source>; %1 place(s) were there before and stay as they are</source>
        <translation>
            <numerusform>; %1 de ellos ya estaba y queda como está</numerusform>
            <numerusform>; %1 de ellos ya estaban y quedan como están</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 h of sun a day, %2 % of the sunlit time</source>
        <translation>%1 h de sol al día, %2 % del tiempo de sol</translation>
    </message>
    <message numerus="yes">
        <source>%1 compared with %2: %3 min of sun a day, mean over %4 cell(s).</source>
        <translation>
            <numerusform>%1 comparado con %2: %3 min de sol al día, media de %4 celda.</numerusform>
            <numerusform>%1 comparado con %2: %3 min de sol al día, media de %4 celdas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cell(s); in the study itself %2.</source>
        <translation>
            <numerusform>%1 celda; en el propio estudio %2.</numerusform>
            <numerusform>%1 celdas; en el propio estudio %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: minutes of shadow</source>
        <translation>%1: minutos de sombra</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>&amp;Capa</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Leer</translation>
    </message>
    <message>
        <source>%1 (%2 features)</source>
        <translation>%1 (%2 elementos)</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Tipo</translation>
    </message>
    <message>
        <source>Found automatically</source>
        <translation>Se busca automáticamente</translation>
    </message>
    <message>
        <source>%1 min of shadow a day</source>
        <translation>%1 min de sombra al día</translation>
    </message>
    <message>
        <source>Max shadow</source>
        <translation>Sombra máxima</translation>
    </message>
    <message>
        <source>Min shadow</source>
        <translation>Sombra mínima</translation>
    </message>
    <message>
        <source>Mean shadow</source>
        <translation>Sombra media</translation>
    </message>
    <message>
        <source>Most shadow</source>
        <translation>Más sombra</translation>
    </message>
    <message>
        <source>The place with least sun in the mean</source>
        <translation>El lugar con menos sol de media</translation>
    </message>
    <message>
        <source>Least shadow</source>
        <translation>Menos sombra</translation>
    </message>
    <message>
        <source>The place with most sun in the mean</source>
        <translation>El lugar con más sol de media</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Árboles</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>score %1 m² a m²</source>
        <translation>puntuación %1 m² por m²</translation>
    </message>
    <message>
        <source>&amp;Heights of the trees&apos; canopy</source>
        <translation>&amp;Alturas del dosel arbóreo</translation>
    </message>
    <message>
        <source>&amp;Trees</source>
        <translation>&amp;Árboles</translation>
    </message>
    <message>
        <source>T&amp;errain</source>
        <translation>T&amp;erreno</translation>
    </message>
    <message>
        <source>&amp;Places</source>
        <translation>&amp;Lugares</translation>
    </message>
    <message>
        <source>%1: OpenStreetMap, whose tags are known.</source>
        <translation>%1: OpenStreetMap, cuyas etiquetas se conocen.</translation>
    </message>
    <message>
        <source>%1: a raster. Its cells are taken for heights of the canopy above the ground.</source>
        <translation>%1: un ráster. Sus celdas se toman como alturas del dosel sobre el suelo.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 feature(s) in layer %3.</source>
        <translation>
            <numerusform>%1: %2 elemento en la capa %3.</numerusform>
            <numerusform>%1: %2 elementos en la capa %3.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 measured</source>
        <translation>%1 medidas</translation>
    </message>
    <message>
        <source>%1 estimated</source>
        <translation>%1 estimadas</translation>
    </message>
    <message>
        <source>%1 assumed</source>
        <translation>%1 supuestas</translation>
    </message>
    <message numerus="yes">
        <source>%1 tree(s) are added.</source>
        <translation>
            <numerusform>Se añade %1 árbol.</numerusform>
            <numerusform>Se añaden %1 árboles.</numerusform>
        </translation>
    </message>
    <message>
        <source>Heights: %1 (%2)</source>
        <translation>Alturas: %1 (%2)</translation>
    </message>
    <message>
        <source>Crowns: %1 (%2)</source>
        <translation>Copas: %1 (%2)</translation>
    </message>
    <message>
        <source>not counted: no storey stands on the ground</source>
        <translation>no se cuenta: ninguna planta se apoya en el suelo</translation>
    </message>
    <message>
        <source>%1 as it stands</source>
        <translation>%1 tal como está</translation>
    </message>
    <message>
        <source>Without trees: %1</source>
        <translation>Sin árboles: %1</translation>
    </message>
    <message>
        <source>sunrise to sunset</source>
        <translation>del amanecer al ocaso</translation>
    </message>
    <message>
        <source>; sun comes back on %1 (%2 %)</source>
        <translation>; el sol vuelve a %1 (%2 %)</translation>
    </message>
    <message>
        <source>New shadow a day, by cells of %1: %2</source>
        <translation>Sombra nueva al día, por celdas de %1: %2</translation>
    </message>
    <message>
        <source>Existing</source>
        <translation>Existente</translation>
    </message>
    <message>
        <source>every %1 min</source>
        <translation>cada %1 min</translation>
    </message>
    <message>
        <source>no refraction</source>
        <translation>sin refracción</translation>
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
            <numerusform>%1 árbol le quita sol, el %2 % de la sombra.</numerusform>
            <numerusform>%1 árboles le quitan sol, el %2 % de la sombra.</numerusform>
        </translation>
    </message>
    <message>
        <source>Tree %1</source>
        <comment>its species or number</comment>
        <translation>Árbol %1</translation>
    </message>
    <message>
        <source>Least sure: %1 (%2, %3)</source>
        <translation>Menos seguro: %1 (%2, %3)</translation>
    </message>
    <message>
        <source>Verdicts</source>
        <translation>Dictámenes</translation>
    </message>
    <message>
        <source>; highest part %1</source>
        <translation>; parte más alta %1</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Cota</translation>
    </message>
    <message>
        <source>%1 to %2 above datum</source>
        <translation>%1 a %2 sobre el dátum</translation>
    </message>
    <message>
        <source>%1 against its empty lot</source>
        <translation>%1 frente a su parcela vacía</translation>
    </message>
    <message>
        <source>%1 high</source>
        <translation>de %1 de altura</translation>
    </message>
    <message>
        <source>%1 high, %2 %3</source>
        <comment>a building: its height, how far it is, in which direction</comment>
        <translation>de %1 de altura, %2 al %3</translation>
    </message>
    <message>
        <source>a building %1</source>
        <comment>23 m high, 120 m NE</comment>
        <translation>un edificio %1</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polígono</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>Aceptar</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Sí</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;No</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Reintentar</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>Abortar</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorar</translation>
    </message>
</context>
<context>
    <name>QUndoStack</name>
    <message>
        <source>Undo %1</source>
        <translation>Deshacer: %1</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Rehacer: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
</context>
<context>
    <name>Rule</name>
    <message>
        <source>Boston, Article 80 diagrams</source>
        <translation>Boston, diagramas del Article 80</translation>
    </message>
    <message>
        <source>Boston</source>
        <translation>Boston</translation>
    </message>
    <message>
        <source>Boston, Common and Garden</source>
        <translation>Boston, Common y Garden</translation>
    </message>
    <message>
        <source>Boston, Midtown</source>
        <translation>Boston, Midtown</translation>
    </message>
    <message>
        <source>BRE 209 (2022), amenity space</source>
        <translation>BRE 209 (2022), espacios libres</translation>
    </message>
    <message>
        <source>London</source>
        <translation>Londres</translation>
    </message>
    <message>
        <source>BRE 209 (2022), windows</source>
        <translation>BRE 209 (2022), ventanas</translation>
    </message>
    <message>
        <source>New York, CEQR chapter 8</source>
        <translation>Nueva York, CEQR capítulo 8</translation>
    </message>
    <message>
        <source>New York</source>
        <translation>Nueva York</translation>
    </message>
    <message>
        <source>China, GB 50180, sunlight of homes</source>
        <translation>China, GB 50180, sol en viviendas</translation>
    </message>
    <message>
        <source>China</source>
        <translation>China</translation>
    </message>
    <message>
        <source>EN 17037, exposure to sunlight</source>
        <translation>EN 17037, exposición al sol</translation>
    </message>
    <message>
        <source>Europe</source>
        <translation>Europa</translation>
    </message>
    <message>
        <source>Estonia, insolation of homes</source>
        <translation>Estonia, soleamiento de viviendas</translation>
    </message>
    <message>
        <source>Estonia</source>
        <translation>Estonia</translation>
    </message>
    <message>
        <source>Four days, three hours</source>
        <translation>Cuatro días, tres horas</translation>
    </message>
    <message>
        <source>Philadelphia, Seattle and others</source>
        <translation>Filadelfia, Seattle y otras</translation>
    </message>
    <message>
        <source>Japan, Building Standards Act, table 4</source>
        <translation>Japón, Ley de Normas de Construcción, tabla 4</translation>
    </message>
    <message>
        <source>Japan</source>
        <translation>Japón</translation>
    </message>
    <message>
        <source>Korea, right to sunlight</source>
        <translation>Corea, derecho al sol</translation>
    </message>
    <message>
        <source>Korea</source>
        <translation>Corea</translation>
    </message>
    <message>
        <source>Melbourne, amendment C278</source>
        <translation>Melbourne, enmienda C278</translation>
    </message>
    <message>
        <source>Melbourne</source>
        <translation>Melbourne</translation>
    </message>
    <message>
        <source>Montreal, parks</source>
        <translation>Montreal, parques</translation>
    </message>
    <message>
        <source>Montreal</source>
        <translation>Montreal</translation>
    </message>
    <message>
        <source>Montreal, east-west streets</source>
        <translation>Montreal, calles este-oeste</translation>
    </message>
    <message>
        <source>New South Wales, Apartment Design Guide</source>
        <translation>Nueva Gales del Sur, Apartment Design Guide</translation>
    </message>
    <message>
        <source>New South Wales</source>
        <translation>Nueva Gales del Sur</translation>
    </message>
    <message>
        <source>A rule of your own</source>
        <translation>Una regla propia</translation>
    </message>
    <message>
        <source>Anywhere</source>
        <translation>En cualquier lugar</translation>
    </message>
    <message>
        <source>Poland, sunlight in rooms</source>
        <translation>Polonia, sol en las habitaciones</translation>
    </message>
    <message>
        <source>Poland</source>
        <translation>Polonia</translation>
    </message>
    <message>
        <source>Russia (central zone), share of territory</source>
        <translation>Rusia (zona central), parte del terreno</translation>
    </message>
    <message>
        <source>Russia</source>
        <translation>Rusia</translation>
    </message>
    <message>
        <source>Russia (central zone), insolation of rooms</source>
        <translation>Rusia (zona central), soleamiento de habitaciones</translation>
    </message>
    <message>
        <source>San Francisco, Section 295 (Proposition K)</source>
        <translation>San Francisco, Section 295 (Proposition K)</translation>
    </message>
    <message>
        <source>San Francisco</source>
        <translation>San Francisco</translation>
    </message>
    <message>
        <source>The Hague, sunlight on facades</source>
        <translation>La Haya, sol en las fachadas</translation>
    </message>
    <message>
        <source>The Hague</source>
        <translation>La Haya</translation>
    </message>
    <message>
        <source>Netherlands, TNO light</source>
        <translation>Países Bajos, TNO leve</translation>
    </message>
    <message>
        <source>Netherlands</source>
        <translation>Países Bajos</translation>
    </message>
    <message>
        <source>Netherlands, TNO strict</source>
        <translation>Países Bajos, TNO estricta</translation>
    </message>
    <message>
        <source>Toronto, shadow study</source>
        <translation>Toronto, estudio de sombras</translation>
    </message>
    <message>
        <source>Toronto</source>
        <translation>Toronto</translation>
    </message>
    <message>
        <source>Vancouver, parks and schoolyards</source>
        <translation>Vancouver, parques y patios escolares</translation>
    </message>
    <message>
        <source>Vancouver</source>
        <translation>Vancouver</translation>
    </message>
    <message>
        <source>Zurich, shadow of tall buildings</source>
        <translation>Zúrich, sombra de edificios altos</translation>
    </message>
    <message>
        <source>Zurich</source>
        <translation>Zúrich</translation>
    </message>
    <message>
        <source>United States</source>
        <translation>Estados Unidos</translation>
    </message>
    <message>
        <source>Britain (UK)</source>
        <translation>Reino Unido</translation>
    </message>
    <message>
        <source>Korea (South)</source>
        <translation>Corea del Sur</translation>
    </message>
    <message>
        <source>Switzerland</source>
        <translation>Suiza</translation>
    </message>
    <message>
        <source>Canada</source>
        <translation>Canadá</translation>
    </message>
    <message>
        <source>Australia</source>
        <translation>Australia</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Día</translation>
    </message>
    <message>
        <source>New shadow enters</source>
        <translation>La sombra nueva entra</translation>
    </message>
    <message>
        <source>New shadow exits</source>
        <translation>La sombra nueva sale</translation>
    </message>
    <message>
        <source>Duration, min</source>
        <translation>Duración, min</translation>
    </message>
    <message>
        <source>Largest area, m²</source>
        <translation>Área máxima, m²</translation>
    </message>
    <message>
        <source>At one spot, min</source>
        <translation>En un punto, min</translation>
    </message>
    <message>
        <source>Shadow of fences and other small structures</source>
        <translation>Sombra de vallas y otras estructuras pequeñas</translation>
    </message>
    <message>
        <source>The rule asks for diagrams and states no limit, so there are figures and no verdict.</source>
        <translation>La norma pide diagramas y no fija ningún límite, así que hay valores y ningún veredicto.</translation>
    </message>
    <message>
        <source>The equinoxes and solstices are the 21st of March, June, September and December.</source>
        <translation>Los equinoccios y solsticios son el 21 de marzo, junio, septiembre y diciembre.</translation>
    </message>
    <message>
        <source>Diagrams at 9, 12 and 15 h on the equinoxes and solstices, and at 18 h in summer and autumn.</source>
        <translation>Diagramas a las 9, 12 y 15 h en los equinoccios y solsticios, y a las 18 h en verano y otoño.</translation>
    </message>
    <message>
        <source>Minutes with new shadow anywhere outside the first and last hour</source>
        <translation>Minutos con sombra nueva en cualquier punto fuera de la primera y la última hora</translation>
    </message>
    <message>
        <source>Park</source>
        <translation>Parque</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>Minutos</translation>
    </message>
    <message>
        <source>Exemptions and shadow banks</source>
        <translation>Exenciones y bancos de sombra</translation>
    </message>
    <message>
        <source>Sunrise and sunset are those of the upper limb with refraction: the definition is not stated.</source>
        <translation>La salida y la puesta del sol son las del borde superior con refracción: la definición no consta.</translation>
    </message>
    <message>
        <source>New shadow is shadow on ground that is lit in the baseline.</source>
        <translation>Sombra nueva es la sombra sobre suelo que tiene sol en la referencia.</translation>
    </message>
    <message>
        <source>New shadow only in the first hour after sunrise or 7:00 (the later) and in the last hour before sunset.</source>
        <translation>Sombra nueva solo en la primera hora tras la salida del sol o las 7:00 (lo más tarde) y en la última hora antes de la puesta.</translation>
    </message>
    <message>
        <source>New shadow at the worst spot</source>
        <translation>Sombra nueva en el peor punto</translation>
    </message>
    <message>
        <source>At the worst spot, min</source>
        <translation>En el peor punto, min</translation>
    </message>
    <message>
        <source>Anywhere, min</source>
        <translation>En cualquier punto, min</translation>
    </message>
    <message>
        <source>Exemptions, and areas too small to count</source>
        <translation>Exenciones, y áreas demasiado pequeñas para contar</translation>
    </message>
    <message>
        <source>The two hours are those of the worst spot: the figures at hand do not say whether a spot or the whole park is meant. The table states both.</source>
        <translation>Las dos horas son las del peor punto: los datos disponibles no dicen si se trata de un punto o de todo el parque. La tabla indica ambos.</translation>
    </message>
    <message>
        <source>Less than 2 h of new shadow within 8:00-14:30, from 21 March to 21 October.</source>
        <translation>Menos de 2 h de sombra nueva entre las 8:00 y las 14:30, del 21 de marzo al 21 de octubre.</translation>
    </message>
    <message>
        <source>Share of the space with 2 h of sun</source>
        <translation>Parte del espacio con 2 h de sol</translation>
    </message>
    <message>
        <source>Amenity space</source>
        <translation>Espacio de estancia</translation>
    </message>
    <message>
        <source>Share with 2 h of sun</source>
        <translation>Parte con 2 h de sol</translation>
    </message>
    <message>
        <source>Least sun, min</source>
        <translation>Mínimo de sol, min</translation>
    </message>
    <message>
        <source>The windows&apos; part of BRE 209: annual probable sunlight hours, vertical sky component</source>
        <translation>La parte de ventanas de BRE 209: horas de sol probables al año, componente vertical del cielo</translation>
    </message>
    <message>
        <source>Shadow of fences</source>
        <translation>Sombra de vallas</translation>
    </message>
    <message>
        <source>The two hours may be broken up.</source>
        <translation>Las dos horas pueden estar interrumpidas.</translation>
    </message>
    <message>
        <source>A space that meets the limit by its former value is stated with its new share.</source>
        <translation>Un espacio que cumple el límite por su valor anterior se indica con su nueva parte.</translation>
    </message>
    <message>
        <source>As reported, of trees only dense belts of evergreens count for sun on the ground. A cell is in their shade where they take half of the sun or more.</source>
        <translation>Según se informa, de los árboles solo cuentan los cinturones densos de perennes para el sol en el suelo. Una celda está en su sombra donde quitan la mitad del sol o más.</translation>
    </message>
    <message>
        <source>At least 2 h of sun on 21 March over at least half of an amenity space, or else at least 0.8 times its former value.</source>
        <translation>Al menos 2 h de sol el 21 de marzo en al menos la mitad de un espacio de estancia, o si no, al menos 0,8 veces su valor anterior.</translation>
    </message>
    <message>
        <source>face</source>
        <translation>cara</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>interior</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>exterior</translation>
    </message>
    <message>
        <source>windows of</source>
        <translation>ventanas de</translation>
    </message>
    <message>
        <source>neighbours</source>
        <translation>vecinos</translation>
    </message>
    <message>
        <source>own scheme</source>
        <translation>proyecto propio</translation>
    </message>
    <message>
        <source>Annual probable sunlight hours</source>
        <translation>Horas de sol probables al año</translation>
    </message>
    <message>
        <source>Loss of annual probable sunlight hours</source>
        <translation>Pérdida de horas de sol probables al año</translation>
    </message>
    <message>
        <source>Vertical sky component</source>
        <translation>Componente vertical del cielo</translation>
    </message>
    <message>
        <source>Probable sunlight hours from 21 September to 21 March, of those of the year</source>
        <translation>Horas de sol probables del 21 de septiembre al 21 de marzo, de las del año</translation>
    </message>
    <message>
        <source>Sunlight is asked of windows that face within 90 degrees of due south</source>
        <translation>Se exige sol a las ventanas orientadas a menos de 90 grados del sur</translation>
    </message>
    <message>
        <source>No-sky line and daylight in rooms</source>
        <translation>Línea sin cielo y luz diurna en las habitaciones</translation>
    </message>
    <message>
        <source>Which rooms are living rooms: all windows are evaluated</source>
        <translation>Qué habitaciones son salas de estar: se evalúan todas las ventanas</translation>
    </message>
    <message>
        <source>Windows that face north are asked for the sky component only</source>
        <translation>A las ventanas al norte solo se les exige la componente del cielo</translation>
    </message>
    <message>
        <source>Shadow of fences and blinds</source>
        <translation>Sombra de vallas y persianas</translation>
    </message>
    <message>
        <source>A window&apos;s sunlight suffers if it misses a target of its own, falls below 0.8 times the former value in that period, and loses more than 4 points of the year: it holds if one of the three does not occur. Where an authority asks for both 0.8 times and a loss of at most 4 points, copy the rule and change holds_if.</source>
        <translation>El sol de una ventana se ve afectado si no alcanza un objetivo propio, baja de 0,8 veces el valor anterior en ese periodo y pierde más de 4 puntos del año: se cumple si uno de los tres no ocurre. Donde una autoridad pida tanto 0,8 veces como una pérdida de 4 puntos como máximo, copie la norma y cambie holds_if.</translation>
    </message>
    <message>
        <source>Without a table of sunshine probability every hour with the sun up counts alike, and shares are of plain possible hours. Add a table for the place as &quot;sunshine&quot; in a copy of the rule, or with --sunshine.</source>
        <translation>Sin una tabla de probabilidad de sol, todas las horas con el sol sobre el horizonte cuentan igual, y las partes son de horas posibles. Añada una tabla del lugar como &quot;sunshine&quot; en una copia de la norma, o con --sunshine.</translation>
    </message>
    <message>
        <source>Shares are of the hours of the unobstructed sun in a whole year, also those of winter.</source>
        <translation>Las partes son de las horas de sol sin obstáculos de todo un año, también las del invierno.</translation>
    </message>
    <message>
        <source>The point is in the middle of the pane on the outside face. With the choice of the inside face, the sun must also pass the opening in the wall.</source>
        <translation>El punto está en el centro del vidrio, en la cara exterior. Si se elige la cara interior, el sol debe pasar también por el hueco del muro.</translation>
    </message>
    <message>
        <source>As reported, deciduous trees are left out before neighbours&apos; windows, and evergreens count. With the choice of one&apos;s own scheme, existing trees count by their season, and of the proposed ones the evergreens.</source>
        <translation>Según se informa, ante las ventanas de los vecinos se omiten los árboles caducos y cuentan los perennes. Si se elige el proyecto propio, los árboles existentes cuentan según su estación y, de los proyectados, los perennes.</translation>
    </message>
    <message>
        <source>Sun through crowns counts by the share that they let pass; a run is broken where they take half of it or more. The vertical sky component has the mean of the days with leaves and without.</source>
        <translation>El sol a través de las copas cuenta con la parte que dejan pasar; una duración se interrumpe donde quitan la mitad o más. La componente vertical del cielo es la media de los días con y sin hojas.</translation>
    </message>
    <message>
        <source>Windows of neighbours: vertical sky component at least 27 %, annual probable sunlight hours at least 25 % with 5 % in winter, each or else 0.8 times the former value; a loss of sunlight of at most 4 points is never notable.</source>
        <translation>Ventanas de los vecinos: componente vertical del cielo de al menos el 27 %, horas de sol probables al año de al menos el 25 % con un 5 % en invierno, cada una o si no 0,8 veces el valor anterior; una pérdida de sol de 4 puntos como máximo nunca es apreciable.</translation>
    </message>
    <message>
        <source>Minutes in which all direct sun is eliminated</source>
        <translation>Minutos en que desaparece todo el sol directo</translation>
    </message>
    <message>
        <source>Sun for plants at the worst spot, growing season</source>
        <translation>Sol para las plantas en el peor punto, época de crecimiento</translation>
    </message>
    <message>
        <source>Resource</source>
        <translation>Recurso</translation>
    </message>
    <message>
        <source>Analysis day</source>
        <translation>Día de análisis</translation>
    </message>
    <message>
        <source>Incremental shadow enters</source>
        <translation>La sombra añadida entra</translation>
    </message>
    <message>
        <source>Incremental shadow exits</source>
        <translation>La sombra añadida sale</translation>
    </message>
    <message>
        <source>Duration, h:min</source>
        <translation>Duración, h:min</translation>
    </message>
    <message>
        <source>Longest at one spot, h:min</source>
        <translation>Máximo en un punto, h:min</translation>
    </message>
    <message>
        <source>All direct sun eliminated, min</source>
        <translation>Todo el sol directo eliminado, min</translation>
    </message>
    <message>
        <source>Trigger: 50 ft or more, or more than 10 ft next to a resource</source>
        <translation>Umbral: 50 ft o más, o más de 10 ft junto a un recurso</translation>
    </message>
    <message>
        <source>Longest shadow: 4.3 x height</source>
        <translation>Sombra más larga: 4,3 x altura</translation>
    </message>
    <message>
        <source>No shadow between 108 and 252 degrees from north</source>
        <translation>Ninguna sombra entre 108 y 252 grados desde el norte</translation>
    </message>
    <message>
        <source>Hours: from 1.5 h after sunrise to 1.5 h before sunset</source>
        <translation>Horas: desde 1,5 h tras la salida del sol hasta 1,5 h antes de la puesta</translation>
    </message>
    <message>
        <source>Growing season: April to October; a statement on it is asked for</source>
        <translation>Época de crecimiento: abril a octubre; se pide una declaración al respecto</translation>
    </message>
    <message>
        <source>All direct sun eliminated from a resource for more than 10 min is generally significant</source>
        <translation>Quitar todo el sol directo de un recurso durante más de 10 min es en general significativo</translation>
    </message>
    <message>
        <source>Plants need 4 to 6 h of sun</source>
        <translation>Las plantas necesitan de 4 a 6 h de sol</translation>
    </message>
    <message>
        <source>The trigger (height of the proposal) and whether the resource is sensitive to sunlight</source>
        <translation>El umbral (altura de la propuesta) y si el recurso es sensible al sol</translation>
    </message>
    <message>
        <source>Significance of incremental shadow that leaves some sun: the rule asks for a judgement</source>
        <translation>Importancia de la sombra añadida que deja algo de sol: la norma pide un juicio</translation>
    </message>
    <message>
        <source>Stained glass and facades are measured on the ground in front of them</source>
        <translation>Las vidrieras y fachadas se miden en el suelo delante de ellas</translation>
    </message>
    <message>
        <source>Landscaped medians with seats, unless they are places of the project</source>
        <translation>Medianas ajardinadas con asientos, salvo que sean lugares del proyecto</translation>
    </message>
    <message>
        <source>The duration is the time with incremental shadow anywhere on the resource, without breaks.</source>
        <translation>La duración es el tiempo con sombra añadida en cualquier punto del recurso, sin interrupciones.</translation>
    </message>
    <message>
        <source>Kinds that the rule does not name (playground, plaza, cemetery, other) are evaluated as open space. Streets are not.</source>
        <translation>Los tipos que la norma no nombra (zona de juegos, plaza, cementerio, otros) se evalúan como espacio libre. Las calles no.</translation>
    </message>
    <message>
        <source>The sun for plants is counted within the rule&apos;s hours and compared with the lower figure, 4 h; it does not decide the verdict.</source>
        <translation>El sol para las plantas se cuenta en las horas de la norma y se compara con el valor menor, 4 h; no decide el veredicto.</translation>
    </message>
    <message>
        <source>Incremental shadow of a proposal on sunlight-sensitive resources on four analysis days, against the No-Action scenario.</source>
        <translation>Sombra añadida de una propuesta sobre recursos sensibles al sol en cuatro días de análisis, respecto al escenario sin actuación.</translation>
    </message>
    <message>
        <source>counting</source>
        <translation>recuento</translation>
    </message>
    <message>
        <source>Beijing, runs from 5 min</source>
        <translation>Pekín, tramos desde 5 min</translation>
    </message>
    <message>
        <source>Hangzhou, two longest runs</source>
        <translation>Hangzhou, los dos tramos más largos</translation>
    </message>
    <message>
        <source>all runs</source>
        <translation>todos los tramos</translation>
    </message>
    <message>
        <source>day</source>
        <translation>día</translation>
    </message>
    <message>
        <source>Great Cold, 2 h</source>
        <translation>Gran Frío, 2 h</translation>
    </message>
    <message>
        <source>Great Cold, 3 h</source>
        <translation>Gran Frío, 3 h</translation>
    </message>
    <message>
        <source>winter solstice, 1 h</source>
        <translation>solsticio de invierno, 1 h</translation>
    </message>
    <message>
        <source>winter solstice</source>
        <translation>solsticio de invierno</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>ángulo con el vidrio</translation>
    </message>
    <message>
        <source>15 degrees</source>
        <translation>15 grados</translation>
    </message>
    <message>
        <source>wall over width</source>
        <translation>muro entre anchura</translation>
    </message>
    <message>
        <source>Effective sun at both ends of the sill</source>
        <translation>Sol efectivo en ambos extremos del alféizar</translation>
    </message>
    <message>
        <source>Great Cold</source>
        <translation>Gran Frío</translation>
    </message>
    <message>
        <source>The sun counts from a sweep angle of 15 degrees, or arctan(thickness of the wall / width of the window)</source>
        <translation>El sol cuenta desde un ángulo de 15 grados con el vidrio, o arctan(grosor del muro / anchura de la ventana)</translation>
    </message>
    <message>
        <source>Beijing drops runs below 5 min; 30 min is also reported</source>
        <translation>Pekín descarta tramos de menos de 5 min; también se mencionan 30 min</translation>
    </message>
    <message>
        <source>Hangzhou sums the longest runs, steps of at most 5 min</source>
        <translation>Hangzhou suma los tramos más largos, con pasos de 5 min como máximo</translation>
    </message>
    <message>
        <source>Households: which windows belong to a household, and that one living room is enough</source>
        <translation>Hogares: qué ventanas pertenecen a un hogar, y que basta una sala de estar</translation>
    </message>
    <message>
        <source>The climate zone and size of the city, which choose the day</source>
        <translation>La zona climática y el tamaño de la ciudad, que determinan el día</translation>
    </message>
    <message>
        <source>The sun counts while both ends of the sill have it at once.</source>
        <translation>El sol cuenta mientras ambos extremos del alféizar lo tienen a la vez.</translation>
    </message>
    <message>
        <source>Windows of 1.5 m stand in where the file states no sizes.</source>
        <translation>Se suponen ventanas de 1,5 m donde el archivo no indica el tamaño.</translation>
    </message>
    <message>
        <source>Hangzhou: the two longest runs are summed; how many is not stated in what we have.</source>
        <translation>Hangzhou: se suman los dos tramos más largos; lo disponible no dice cuántos.</translation>
    </message>
    <message>
        <source>Homes: at least 2 h of sun on the Great Cold day from 8 to 16 h, or 1 h on the winter solstice from 9 to 15 h, true solar time, at both ends of the sill.</source>
        <translation>Viviendas: al menos 2 h de sol el día del Gran Frío de 8 a 16 h, o 1 h en el solsticio de invierno de 9 a 15 h, hora solar verdadera, en ambos extremos del alféizar.</translation>
    </message>
    <message>
        <source>country</source>
        <translation>país</translation>
    </message>
    <message>
        <source>Czech Republic, 13 deg</source>
        <translation>República Checa, 13 grados</translation>
    </message>
    <message>
        <source>Germany, 11 deg</source>
        <translation>Alemania, 11 grados</translation>
    </message>
    <message>
        <source>of choice</source>
        <translation>a elección</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>el peor</translation>
    </message>
    <message>
        <source>level</source>
        <translation>nivel</translation>
    </message>
    <message>
        <source>high</source>
        <translation>alto</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>medio</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>mínimo</translation>
    </message>
    <message>
        <source>Sun in the room</source>
        <translation>Sol en la habitación</translation>
    </message>
    <message>
        <source>Levels: 1.5 h minimum, 4 h high</source>
        <translation>Niveles: 1,5 h mínimo, 4 h alto</translation>
    </message>
    <message>
        <source>Level: 3 h medium</source>
        <translation>Nivel: 3 h medio</translation>
    </message>
    <message>
        <source>Which rooms are habitable, and that one room of a dwelling is enough</source>
        <translation>Qué habitaciones son habitables, y que basta una de la vivienda</translation>
    </message>
    <message>
        <source>Least altitudes of countries other than Germany and the Czech Republic: change lowest_sun_deg in a copy of the rule</source>
        <translation>Alturas mínimas de países distintos de Alemania y la República Checa: cambie lowest_sun_deg en una copia de la norma</translation>
    </message>
    <message>
        <source>Times through several openings of a room add up where they are not at the same moment: name the rooms in the file of windows (field room). Windows without a room are rooms of their own.</source>
        <translation>Los tiempos por varios huecos de una habitación se suman donde no coinciden: indique las habitaciones en el archivo de ventanas (campo room). Las ventanas sin habitación son habitaciones propias.</translation>
    </message>
    <message>
        <source>On the day of the user&apos;s choice: the best day of the range decides. The choice &quot;day=worst&quot; asks it of every day.</source>
        <translation>En el día que se elija: decide el mejor día del periodo. La opción &quot;day=worst&quot; lo exige todos los días.</translation>
    </message>
    <message>
        <source>Obstructions are looked up from the outside face; the opening, as deep as the wall, hides what the inside face does not see.</source>
        <translation>Los obstáculos se buscan desde la cara exterior; el hueco, tan profundo como el muro, oculta lo que la cara interior no ve.</translation>
    </message>
    <message>
        <source>The least altitude depends on the country. That of Germany is taken unless another country is chosen.</source>
        <translation>La altura mínima depende del país. Se toma la de Alemania si no se elige otro.</translation>
    </message>
    <message>
        <source>On one day between 1 February and 21 March at least 1.5 h of sun in one habitable room; 3 h medium, 4 h high.</source>
        <translation>En un día entre el 1 de febrero y el 21 de marzo, al menos 1,5 h de sol en una habitación habitable; 3 h medio, 4 h alto.</translation>
    </message>
    <message>
        <source>Longest unbroken sun</source>
        <translation>Sol ininterrumpido más largo</translation>
    </message>
    <message>
        <source>Sun of the day</source>
        <translation>Sol del día</translation>
    </message>
    <message>
        <source>3 h of unbroken sun, or 3.5 h with one break</source>
        <translation>3 h de sol ininterrumpido, o 3,5 h con una interrupción</translation>
    </message>
    <message>
        <source>Which rooms must have it</source>
        <translation>Qué habitaciones deben tenerlo</translation>
    </message>
    <message>
        <source>The worst day decides.</source>
        <translation>Decide el peor día.</translation>
    </message>
    <message>
        <source>With one break: the two longest parts of the day&apos;s sun add up to 3.5 h, whatever sun follows.</source>
        <translation>Con una interrupción: las dos partes más largas del sol del día suman 3,5 h, sea cual sea el sol que siga.</translation>
    </message>
    <message>
        <source>Every break counts, also one of a minute: the sun before and after it are two parts. The bands of the window state them.</source>
        <translation>Toda interrupción cuenta, también la de un minuto: el sol de antes y de después son dos partes. Las bandas de la ventana las indican.</translation>
    </message>
    <message>
        <source>From 22 April to 22 August at least 3 h of unbroken sun, or 3.5 h with one break; a loss of at most 50 %.</source>
        <translation>Del 22 de abril al 22 de agosto, al menos 3 h de sol ininterrumpido, o 3,5 h con una interrupción; una pérdida del 50 % como máximo.</translation>
    </message>
    <message>
        <source>The sheet has no limit, so there are figures and no verdict.</source>
        <translation>La hoja no tiene límite, así que hay valores y ningún veredicto.</translation>
    </message>
    <message>
        <source>The solstices and equinoxes are the 21st of March, June, September and December.</source>
        <translation>Los solsticios y equinoccios son el 21 de marzo, junio, septiembre y diciembre.</translation>
    </message>
    <message>
        <source>Diagrams at 9, 12 and 15 h on the solstices and equinoxes: the general sheet.</source>
        <translation>Diagramas a las 9, 12 y 15 h en los solsticios y equinoccios: la hoja general.</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>límites</translation>
    </message>
    <message>
        <source>3 h, 2 h</source>
        <translation>3 h, 2 h</translation>
    </message>
    <message>
        <source>4 h, 2.5 h</source>
        <translation>4 h, 2,5 h</translation>
    </message>
    <message>
        <source>5 h, 3 h</source>
        <translation>5 h, 3 h</translation>
    </message>
    <message>
        <source>Hokkaido 2 h, 1.5 h</source>
        <translation>Hokkaido 2 h, 1,5 h</translation>
    </message>
    <message>
        <source>Hokkaido 3 h, 2 h</source>
        <translation>Hokkaido 3 h, 2 h</translation>
    </message>
    <message>
        <source>Hokkaido 4 h, 2.5 h</source>
        <translation>Hokkaido 4 h, 2,5 h</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>plano</translation>
    </message>
    <message>
        <source>1.5 m</source>
        <translation>1,5 m</translation>
    </message>
    <message>
        <source>4 m</source>
        <translation>4 m</translation>
    </message>
    <message>
        <source>6.5 m</source>
        <translation>6,5 m</translation>
    </message>
    <message>
        <source>Shadow beyond 10 m of the parcel line</source>
        <translation>Sombra a más de 10 m del límite de la parcela</translation>
    </message>
    <message>
        <source>Shadow within 5 to 10 m of the parcel line</source>
        <translation>Sombra de 5 a 10 m del límite de la parcela</translation>
    </message>
    <message>
        <source>Parcel and belt</source>
        <translation>Parcela y franja</translation>
    </message>
    <message>
        <source>Longest shadow at a point, min</source>
        <translation>Sombra máxima en un punto, min</translation>
    </message>
    <message>
        <source>Shadow anywhere, min</source>
        <translation>Sombra en cualquier punto, min</translation>
    </message>
    <message>
        <source>True solar time 8 to 16 h; Hokkaido 9 to 15 h</source>
        <translation>Hora solar verdadera de 8 a 16 h; Hokkaido de 9 a 15 h</translation>
    </message>
    <message>
        <source>Plane 1.5, 4 or 6.5 m above the mean ground</source>
        <translation>Plano a 1,5, 4 o 6,5 m sobre el suelo medio</translation>
    </message>
    <message>
        <source>Limits within 5 to 10 m of the parcel line and beyond 10 m: 3 and 2 h, 4 and 2.5 h, 5 and 3 h; Hokkaido 2 and 1.5 h, 3 and 2 h, 4 and 2.5 h</source>
        <translation>Límites de 5 a 10 m del límite de la parcela y a más de 10 m: 3 y 2 h, 4 y 2,5 h, 5 y 3 h; Hokkaido 2 y 1,5 h, 3 y 2 h, 4 y 2,5 h</translation>
    </message>
    <message>
        <source>Triggers: eaves above 7 m or 3 storeys and more (plane of 1.5 m), above 10 m (planes of 4 and 6.5 m)</source>
        <translation>Umbral: alero de más de 7 m o 3 plantas o más (plano de 1,5 m), de más de 10 m (planos de 4 y 6,5 m)</translation>
    </message>
    <message>
        <source>The parcel line moves out by half the width of a road of at most 10 m, else to 5 m inside its far side</source>
        <translation>El límite de la parcela avanza la mitad de la anchura de una calle de hasta 10 m, o si no hasta 5 m antes de su lado lejano</translation>
    </message>
    <message>
        <source>Sheets: hourly (half-hourly) shadows, isochrones, 5 m and 10 m lines, designated points; island shadows must not be missed</source>
        <translation>Hojas: sombras cada hora (media hora), isócronas, líneas de 5 m y 10 m, puntos designados; no deben pasarse por alto las sombras aisladas</translation>
    </message>
    <message>
        <source>The triggers (eaves, storeys, zone): choose plane and limits</source>
        <translation>Los umbrales (alero, plantas, zona): elija plano y límites</translation>
    </message>
    <message>
        <source>Roads, water and railways along the parcels that the project does not state; edges set back more than 1 m are taken to be on none</source>
        <translation>Calles, agua y vías junto a las parcelas que el proyecto no indica; los bordes retranqueados más de 1 m se consideran sin ninguna</translation>
    </message>
    <message>
        <source>Designated points</source>
        <translation>Puntos designados</translation>
    </message>
    <message>
        <source>The winter solstice is 21 December.</source>
        <translation>El solsticio de invierno es el 21 de diciembre.</translation>
    </message>
    <message>
        <source>The places are the parcels; Noonmark measures the belts around them.</source>
        <translation>Los lugares son las parcelas; Noonmark mide las franjas a su alrededor.</translation>
    </message>
    <message>
        <source>The mean ground is the height 0 of the project&apos;s plane, unless the project has terrain.</source>
        <translation>El suelo medio es la altura 0 del plano del proyecto, salvo que el proyecto tenga terreno.</translation>
    </message>
    <message>
        <source>Shadow of the proposal on a plane above the mean ground on the winter solstice, between the 5 m and 10 m lines around the parcel and beyond them.</source>
        <translation>Sombra de la propuesta en un plano sobre el suelo medio en el solsticio de invierno, entre las líneas de 5 m y 10 m alrededor de la parcela y más allá.</translation>
    </message>
    <message>
        <source>Sun in total from 8 to 16 h</source>
        <translation>Sol total de 8 a 16 h</translation>
    </message>
    <message>
        <source>Unbroken sun from 9 to 15 h</source>
        <translation>Sol ininterrumpido de 9 a 15 h</translation>
    </message>
    <message>
        <source>Windows of schools and playgrounds within 200 m</source>
        <translation>Ventanas de escuelas y zonas de juegos a menos de 200 m</translation>
    </message>
    <message>
        <source>One of the two is enough.</source>
        <translation>Basta una de las dos.</translation>
    </message>
    <message>
        <source>On the winter solstice at least 4 h of sun in total from 8 to 16 h, or 2 h unbroken from 9 to 15 h.</source>
        <translation>En el solsticio de invierno, al menos 4 h de sol en total de 8 a 16 h, o 2 h ininterrumpidas de 9 a 15 h.</translation>
    </message>
    <message>
        <source>park type</source>
        <translation>tipo de parque</translation>
    </message>
    <message>
        <source>1 or 2</source>
        <translation>1 o 2</translation>
    </message>
    <message>
        <source>3</source>
        <translation>3</translation>
    </message>
    <message>
        <source>Minutes with added shadow anywhere</source>
        <translation>Minutos con sombra adicional en cualquier punto</translation>
    </message>
    <message>
        <source>Added shadow enters</source>
        <translation>La sombra adicional entra</translation>
    </message>
    <message>
        <source>Added shadow exits</source>
        <translation>La sombra adicional sale</translation>
    </message>
    <message>
        <source>No added shadow from 10 to 15 h on 21 June; type 3 from 10 to 14 h. As proposed</source>
        <translation>Ninguna sombra adicional de 10 a 15 h el 21 de junio; tipo 3 de 10 a 14 h. Según la propuesta</translation>
    </message>
    <message>
        <source>The type of the park: choose the option</source>
        <translation>El tipo de parque: elija la opción</translation>
    </message>
    <message>
        <source>The figures are those proposed, not those adopted.</source>
        <translation>Los valores son los propuestos, no los aprobados.</translation>
    </message>
    <message>
        <source>No added shadow on parks from 10 to 15 h on 21 June (type 3: to 14 h).</source>
        <translation>Ninguna sombra adicional en parques de 10 a 15 h el 21 de junio (tipo 3: hasta las 14 h).</translation>
    </message>
    <message>
        <source>Share of the park with 8 consecutive hours of sun</source>
        <translation>Parte del parque con 8 horas de sol seguidas</translation>
    </message>
    <message>
        <source>equinox</source>
        <translation>equinoccio</translation>
    </message>
    <message>
        <source>Share with 8 h of sun</source>
        <translation>Parte con 8 h de sol</translation>
    </message>
    <message>
        <source>The equinox is 21 March.</source>
        <translation>El equinoccio es el 21 de marzo.</translation>
    </message>
    <message>
        <source>Half of a park is half of its area.</source>
        <translation>La mitad de un parque es la mitad de su área.</translation>
    </message>
    <message>
        <source>On the equinox, 8 consecutive hours of sun within 8-18 h on at least half of a park.</source>
        <translation>En el equinoccio, 8 horas de sol seguidas entre las 8 y las 18 h en al menos la mitad de un parque.</translation>
    </message>
    <message>
        <source>minutes</source>
        <translation>minutos</translation>
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
        <translation>Sol seguido en el peor punto de la calle</translation>
    </message>
    <message>
        <source>Street</source>
        <translation>Calle</translation>
    </message>
    <message>
        <source>Least consecutive sun, min</source>
        <translation>Mínimo de sol seguido, min</translation>
    </message>
    <message>
        <source>150 (90) consecutive minutes of sun; the figures at hand do not say where 90 holds</source>
        <translation>150 (90) minutos de sol seguidos; los datos disponibles no dicen dónde valen 90</translation>
    </message>
    <message>
        <source>Whether a street runs east-west: choose the places</source>
        <translation>Si una calle va de este a oeste: elija los lugares</translation>
    </message>
    <message>
        <source>Where 90 minutes hold instead of 150: choose the option</source>
        <translation>Dónde valen 90 minutos en vez de 150: elija la opción</translation>
    </message>
    <message>
        <source>Every spot of the street must have the sun: the figures at hand do not say which line or share of a street counts.</source>
        <translation>Todos los puntos de la calle deben tener el sol: los datos disponibles no dicen qué línea o parte de una calle cuenta.</translation>
    </message>
    <message>
        <source>On the equinox, 150 consecutive minutes of sun within 12-15 h on east-west streets.</source>
        <translation>En el equinoccio, 150 minutos de sol seguidos entre las 12 y las 15 h en calles de este a oeste.</translation>
    </message>
    <message>
        <source>where</source>
        <translation>dónde</translation>
    </message>
    <message>
        <source>elsewhere, 3 h</source>
        <translation>en otros lugares, 3 h</translation>
    </message>
    <message>
        <source>metropolitan, 2 h</source>
        <translation>metropolitana, 2 h</translation>
    </message>
    <message>
        <source>Sun in the flat</source>
        <translation>Sol en la vivienda</translation>
    </message>
    <message>
        <source>Any sun in the flat</source>
        <translation>Algo de sol en la vivienda</translation>
    </message>
    <message>
        <source>1 m² for at least 15 min counts</source>
        <translation>Cuenta 1 m² durante al menos 15 min</translation>
    </message>
    <message>
        <source>That the sun is in living rooms and on balconies both</source>
        <translation>Que el sol esté tanto en salas de estar como en balcones</translation>
    </message>
    <message>
        <source>That 1 m² is lit</source>
        <translation>Que 1 m² tenga sol</translation>
    </message>
    <message>
        <source>Plan diagrams</source>
        <translation>Diagramas en planta</translation>
    </message>
    <message>
        <source>Times of less than 15 min do not count.</source>
        <translation>Los tiempos de menos de 15 min no cuentan.</translation>
    </message>
    <message>
        <source>A flat has the sun of all of its windows, where one of them has it: name the flats in the file of windows (field dwelling). Windows without one are flats of their own.</source>
        <translation>Una vivienda tiene el sol de todas sus ventanas cuando una lo tiene: indique las viviendas en el archivo de ventanas (campo dwelling). Las ventanas sin ella son viviendas propias.</translation>
    </message>
    <message>
        <source>A building passes by its shares; each flat has its own verdict besides.</source>
        <translation>Un edificio cumple por sus partes; cada vivienda tiene además su propio veredicto.</translation>
    </message>
    <message>
        <source>Flats with enough sun</source>
        <translation>Viviendas con sol suficiente</translation>
    </message>
    <message>
        <source>Flats with some sun</source>
        <translation>Viviendas con algo de sol</translation>
    </message>
    <message>
        <source>At least 70 % of the flats of a building have 2 h of sun from 9 to 15 h on 21 June in living rooms and on balconies (3 h outside the metropolis); at most 15 % have none.</source>
        <translation>Al menos el 70 % de las viviendas de un edificio tienen 2 h de sol de 9 a 15 h el 21 de junio en salas de estar y balcones (3 h fuera de la metrópoli); como máximo el 15 % no tiene ninguno.</translation>
    </message>
    <message>
        <source>All sun gone, min</source>
        <translation>Todo el sol perdido, min</translation>
    </message>
    <message>
        <source>One hour is an example, not a figure of any board.</source>
        <translation>Una hora es un ejemplo, no un valor de ningún organismo.</translation>
    </message>
    <message>
        <source>A start for a rule of your own: copy it, change it, and put it into your own folder of rules.</source>
        <translation>Un comienzo para una norma propia: cópiela, cámbiela y póngala en su propia carpeta de normas.</translation>
    </message>
    <message>
        <source>use</source>
        <translation>uso</translation>
    </message>
    <message>
        <source>homes</source>
        <translation>viviendas</translation>
    </message>
    <message>
        <source>homes in an inner city</source>
        <translation>viviendas en un centro urbano</translation>
    </message>
    <message>
        <source>schools</source>
        <translation>escuelas</translation>
    </message>
    <message>
        <source>That one room of a flat is enough: each room is evaluated by itself</source>
        <translation>Que basta una habitación de la vivienda: cada habitación se evalúa por sí misma</translation>
    </message>
    <message>
        <source>The sun may be broken up. Times through several openings of a room add up where they are not at the same moment: name the rooms in the file of windows (field room).</source>
        <translation>El sol puede estar interrumpido. Los tiempos por varios huecos de una habitación se suman donde no coinciden: indique las habitaciones en el archivo de ventanas (campo room).</translation>
    </message>
    <message>
        <source>At least 3 h of sun on the days of the equinoxes: homes from 7 to 17 h, schools from 8 to 16 h; 1.5 h in inner cities.</source>
        <translation>Al menos 3 h de sol los días de los equinoccios: viviendas de 7 a 17 h, escuelas de 8 a 16 h; 1,5 h en centros urbanos.</translation>
    </message>
    <message>
        <source>Share of the territory with 2 h of sun, or 2.5 h broken up</source>
        <translation>Parte del terreno con 2 h de sol, o 2,5 h interrumpidas</translation>
    </message>
    <message>
        <source>Territory</source>
        <translation>Terreno</translation>
    </message>
    <message>
        <source>Share with the sun</source>
        <translation>Parte con el sol</translation>
    </message>
    <message>
        <source>Least sun, h:min</source>
        <translation>Mínimo de sol, h:min</translation>
    </message>
    <message>
        <source>Intervals</source>
        <translation>Intervalos</translation>
    </message>
    <message>
        <source>2 h unbroken (by zone and number of rooms)</source>
        <translation>2 h ininterrumpidas (según la zona y el número de habitaciones)</translation>
    </message>
    <message>
        <source>Broken up: 0.5 h more, one part of at least 1 h</source>
        <translation>Interrumpidas: 0,5 h más, una parte de al menos 1 h</translation>
    </message>
    <message>
        <source>Output: h:min, number of intervals, share of territory</source>
        <translation>Salida: h:min, número de intervalos, parte del terreno</translation>
    </message>
    <message>
        <source>Rooms and windows</source>
        <translation>Habitaciones y ventanas</translation>
    </message>
    <message>
        <source>Other zones: change the days and hours in a rule of your own</source>
        <translation>Otras zonas: cambie los días y horas en una norma propia</translation>
    </message>
    <message>
        <source>Every break counts, also one of a single step of 5 min: the sun before and after it are two parts.</source>
        <translation>Toda interrupción cuenta, también la de un solo paso de 5 min: el sol de antes y de después son dos partes.</translation>
    </message>
    <message>
        <source>Every day of the range is evaluated; the smallest share counts.</source>
        <translation>Se evalúan todos los días del periodo; cuenta la parte menor.</translation>
    </message>
    <message>
        <source>The figures at hand state no share that a territory must reach, so there are figures and no verdict.</source>
        <translation>Los datos disponibles no fijan la parte que debe alcanzar un terreno, así que hay valores y ningún veredicto.</translation>
    </message>
    <message>
        <source>From 22 April to 22 August, the share of a territory with 2 h of unbroken sun, or 2.5 h broken up with one part of at least 1 h.</source>
        <translation>Del 22 de abril al 22 de agosto, la parte de un terreno con 2 h de sol ininterrumpido, o 2,5 h interrumpidas con una parte de al menos 1 h.</translation>
    </message>
    <message>
        <source>2 h of unbroken sun, or 2.5 h broken up</source>
        <translation>2 h de sol ininterrumpido, o 2,5 h interrumpidas</translation>
    </message>
    <message>
        <source>Output: h:min and number of intervals</source>
        <translation>Salida: h:min y número de intervalos</translation>
    </message>
    <message>
        <source>How many rooms of a flat must have it</source>
        <translation>Cuántas habitaciones de una vivienda deben tenerlo</translation>
    </message>
    <message>
        <source>Other zones: change the days in a copy of the rule</source>
        <translation>Otras zonas: cambie los días en una copia de la norma</translation>
    </message>
    <message>
        <source>From 22 April to 22 August at least 2 h of unbroken sun, or 2.5 h broken up with one part of at least 1 h.</source>
        <translation>Del 22 de abril al 22 de agosto, al menos 2 h de sol ininterrumpido, o 2,5 h interrumpidas con una parte de al menos 1 h.</translation>
    </message>
    <message>
        <source>days</source>
        <translation>días</translation>
    </message>
    <message>
        <source>every day</source>
        <translation>todos los días</translation>
    </message>
    <message>
        <source>mirrored half year</source>
        <translation>medio año reflejado</translation>
    </message>
    <message>
        <source>Net new shadow of the year</source>
        <translation>Sombra nueva neta del año</translation>
    </message>
    <message>
        <source>Existing shadow, sq ft h</source>
        <translation>Sombra existente, sq ft h</translation>
    </message>
    <message>
        <source>Shadow with project, sq ft h</source>
        <translation>Sombra con proyecto, sq ft h</translation>
    </message>
    <message>
        <source>Net new shadow, sq ft h</source>
        <translation>Sombra nueva neta, sq ft h</translation>
    </message>
    <message>
        <source>Share of the theoretical sum</source>
        <translation>Parte de la suma teórica</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Largest area, sq ft</source>
        <translation>Área máxima, sq ft</translation>
    </message>
    <message>
        <source>Trigger: buildings of more than 40 ft</source>
        <translation>Umbral: edificios de más de 40 ft</translation>
    </message>
    <message>
        <source>Hours: from 1 h after sunrise to 1 h before sunset, every day of the year</source>
        <translation>Horas: desde 1 h tras la salida del sol hasta 1 h antes de la puesta, todos los días del año</translation>
    </message>
    <message>
        <source>Theoretical annual available sunlight: area x 3,721.4 h</source>
        <translation>Sol anual teórico disponible: área x 3.721,4 h</translation>
    </message>
    <message>
        <source>Own count of the same hours: 3,720.9</source>
        <translation>Recuento propio de las mismas horas: 3.720,9</translation>
    </message>
    <message>
        <source>Samples of 15 min, mirrored half year</source>
        <translation>Muestras cada 15 min, medio año reflejado</translation>
    </message>
    <message>
        <source>Absolute limits of single parks and qualitative criteria</source>
        <translation>Límites absolutos de parques concretos y criterios cualitativos</translation>
    </message>
    <message>
        <source>Cumulative projects: run the rule again with a scenario that holds them</source>
        <translation>Proyectos acumulados: evalúe la norma de nuevo con un escenario que los contenga</translation>
    </message>
    <message>
        <source>Opening hours of the park</source>
        <translation>Horario de apertura del parque</translation>
    </message>
    <message>
        <source>The trigger (height of the proposal)</source>
        <translation>El umbral (altura de la propuesta)</translation>
    </message>
    <message>
        <source>The figures at hand state no numeric limit, so there are figures and no verdict.</source>
        <translation>Los datos disponibles no fijan ningún límite numérico, así que hay valores y ningún veredicto.</translation>
    </message>
    <message>
        <source>Shadow on a park over a whole year in square-foot-hours, as a share of the theoretical annual available sunlight.</source>
        <translation>Sombra sobre un parque durante todo un año en pies cuadrados-hora, como parte del sol anual teórico disponible.</translation>
    </message>
    <message>
        <source>Possible sun</source>
        <translation>Sol posible</translation>
    </message>
    <message>
        <source>What the rule allows where the norm is missed already</source>
        <translation>Lo que la norma permite donde ya no se cumple</translation>
    </message>
    <message>
        <source>The days and hours are those of the light norm of TNO; the point is on the facade, 0.75 m above the floor.</source>
        <translation>Los días y horas son los de la norma ligera de TNO; el punto está en la fachada, a 0,75 m del piso.</translation>
    </message>
    <message>
        <source>The sun may be broken up; the worst day decides.</source>
        <translation>El sol puede estar interrumpido; decide el peor día.</translation>
    </message>
    <message>
        <source>At least 2 h of possible sun on every day from 19 February to 21 October on the facade, with the sun above 10 degrees.</source>
        <translation>Al menos 2 h de sol posible todos los días del 19 de febrero al 21 de octubre en la fachada, con el sol por encima de 10 grados.</translation>
    </message>
    <message>
        <source>The middle of the sill, inside the glass, usually 0.75 m above the floor</source>
        <translation>El centro del alféizar, por dentro del vidrio, normalmente a 0,75 m del piso</translation>
    </message>
    <message>
        <source>Which facade is that of the living room</source>
        <translation>Qué fachada es la de la sala de estar</translation>
    </message>
    <message>
        <source>The glass is taken 0.1 m behind the face of the wall (opening.wall_m), and the edges of that opening hide the sun.</source>
        <translation>El vidrio se toma 0,1 m detrás de la cara del muro (opening.wall_m), y los bordes de ese hueco ocultan el sol.</translation>
    </message>
    <message>
        <source>At least 2 h of possible sun on every day from 19 February to 21 October, in the middle of the sill.</source>
        <translation>Al menos 2 h de sol posible todos los días del 19 de febrero al 21 de octubre, en el centro del alféizar.</translation>
    </message>
    <message>
        <source>At least 3 h of possible sun on every day from 21 January to 22 November, in the middle of the sill.</source>
        <translation>Al menos 3 h de sol posible todos los días del 21 de enero al 22 de noviembre, en el centro del alféizar.</translation>
    </message>
    <message>
        <source>Hourly from 9:18 to 18:18 (local mean noon)</source>
        <translation>Cada hora de 9:18 a 18:18 (mediodía medio local)</translation>
    </message>
    <message>
        <source>Diagrams on 21 March, June and September</source>
        <translation>Diagramas el 21 de marzo, junio y septiembre</translation>
    </message>
    <message>
        <source>Diagrams on 21 December</source>
        <translation>Diagramas el 21 de diciembre</translation>
    </message>
    <message>
        <source>On 21 December the hours are those of the wall clock too.</source>
        <translation>El 21 de diciembre las horas son también las del reloj.</translation>
    </message>
    <message>
        <source>Hourly diagrams from 9:18 to 18:18 on 21 March, June and September.</source>
        <translation>Diagramas cada hora de 9:18 a 18:18 el 21 de marzo, junio y septiembre.</translation>
    </message>
    <message>
        <source>The figures at hand state no limit, so there are figures and no verdict.</source>
        <translation>Los datos disponibles no fijan ningún límite, así que hay valores y ningún veredicto.</translation>
    </message>
    <message>
        <source>The equinoxes are 21 March and 21 September.</source>
        <translation>Los equinoccios son el 21 de marzo y el 21 de septiembre.</translation>
    </message>
    <message>
        <source>Shadow on parks and schoolyards within 10-16 h daylight time, from the spring to the autumn equinox.</source>
        <translation>Sombra sobre parques y patios escolares de 10 a 16 h, hora de verano, del equinoccio de primavera al de otoño.</translation>
    </message>
    <message>
        <source>Area with more than 3 h of shadow, and more than by the body within the zoning</source>
        <translation>Área con más de 3 h de sombra, y más que por el cuerpo permitido</translation>
    </message>
    <message>
        <source>Shadow at the worst spot</source>
        <translation>Sombra en el peor punto</translation>
    </message>
    <message>
        <source>mean winter day</source>
        <translation>día medio de invierno</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Vivienda</translation>
    </message>
    <message>
        <source>Area with more than 3 h and more than before, m²</source>
        <translation>Área con más de 3 h y más que antes, m²</translation>
    </message>
    <message>
        <source>Shadow at the worst spot, min</source>
        <translation>Sombra en el peor punto, min</translation>
    </message>
    <message>
        <source>Trigger: buildings of more than 25 m</source>
        <translation>Umbral: edificios de más de 25 m</translation>
    </message>
    <message>
        <source>Passes where a body within the zoning shades as much</source>
        <translation>Se cumple donde un cuerpo permitido da la misma sombra</translation>
    </message>
    <message>
        <source>Facades of the homes: their ground is measured</source>
        <translation>Fachadas de las viviendas: se mide el suelo ante ellas</translation>
    </message>
    <message>
        <source>Whether the scenario &apos;from&apos; is a body within the zoning</source>
        <translation>Si el escenario &apos;from&apos; es un cuerpo permitido</translation>
    </message>
    <message>
        <source>The scenario &apos;from&apos; holds the body within the zoning, or nothing on the site.</source>
        <translation>El escenario &apos;from&apos; contiene el cuerpo permitido, o nada en la parcela.</translation>
    </message>
    <message>
        <source>Shadow is counted minute by minute from 8 to 17 h; the diagrams show it by the hour.</source>
        <translation>La sombra se cuenta minuto a minuto de 8 a 17 h; los diagramas la muestran cada hora.</translation>
    </message>
    <message>
        <source>Each spot is compared with itself: it may have more than 3 h of shadow where the body within the zoning gives it as much. A spot within a minute of 3 h, for each time that shadow comes, is borderline.</source>
        <translation>Cada punto se compara consigo mismo: puede tener más de 3 h de sombra donde el cuerpo permitido le da la misma. Un punto a menos de un minuto de 3 h, por cada vez que llega la sombra, está en el límite.</translation>
    </message>
    <message>
        <source>The shadow that the hill casts without any building is not the tower&apos;s: it is not counted.</source>
        <translation>La sombra que la colina da sin ningún edificio no es de la torre: no se cuenta.</translation>
    </message>
    <message>
        <source>Buildings of more than 25 m: at most 3 h of shadow on neighbours&apos; homes on 3 November and 8 February, or no more than a body within the zoning.</source>
        <translation>Edificios de más de 25 m: como máximo 3 h de sombra sobre las viviendas vecinas el 3 de noviembre y el 8 de febrero, o no más que un cuerpo permitido.</translation>
    </message>
    <message>
        <source>Slopes: there is no terrain, so the ground is taken as flat</source>
        <translation>Pendientes: no hay terreno, por lo que el suelo se toma como llano</translation>
    </message>
    <message>
        <source>The rule leaves terrain out; here terrain casts shadow</source>
        <translation>La norma no cuenta el terreno; aquí el terreno da sombra</translation>
    </message>
    <message>
        <source>Where the windows are: one was assumed in each bay and storey of the facades</source>
        <translation>Dónde están las ventanas: se supuso una en cada tramo y planta de las fachadas</translation>
    </message>
</context>
<context>
    <name>StartQuestion</name>
    <message>
        <source>How sunny are our parks and streets?</source>
        <translation>¿Cuánto sol tienen nuestros parques y calles?</translation>
    </message>
    <message>
        <source>Hours of sun by place and month, and what lies below a threshold</source>
        <translation>Horas de sol por lugar y mes, y lo que queda por debajo de un umbral</translation>
    </message>
    <message>
        <source>What would a tower change?</source>
        <translation>¿Qué cambiaría una torre?</translation>
    </message>
    <message>
        <source>New shadow, the worst spot and the places it reaches, live while you drag</source>
        <translation>Sombra nueva, el peor punto y los lugares a los que llega, en vivo al arrastrar</translation>
    </message>
    <message>
        <source>Does this proposal pass the rules?</source>
        <translation>¿Cumple esta propuesta las normas?</translation>
    </message>
    <message>
        <source>Verdicts by the rules of review boards, the site&apos;s first, and a book to file</source>
        <translation>Dictámenes según las normas de las autoridades, primero las del lugar, y un informe para presentar</translation>
    </message>
    <message>
        <source>Which facades and windows get sun?</source>
        <translation>¿Qué fachadas y ventanas reciben sol?</translation>
    </message>
    <message>
        <source>Hours of sun and daylight at points of the facades</source>
        <translation>Horas de sol y luz natural en puntos de las fachadas</translation>
    </message>
    <message>
        <source>Is the shade where we want it?</source>
        <translation>¿Está la sombra donde la queremos?</translation>
    </message>
    <message>
        <source>Wanted shade in summer against unwanted shadow in winter, by hour and month</source>
        <translation>Sombra deseada en verano frente a no deseada en invierno, por hora y mes</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Architect: design a tower</source>
        <translation>Arquitectura: diseñar una torre</translation>
    </message>
    <message>
        <source>A tower on a lot, its shadow while you shape it, and what it changes</source>
        <translation>Una torre en una parcela, su sombra mientras la modela y lo que cambia</translation>
    </message>
    <message>
        <source>The green outlines in the view are lots. Towers are designed in the panel Tower.</source>
        <translation>Los contornos verdes de la vista son parcelas. Las torres se diseñan en el panel Torre.</translation>
    </message>
    <message>
        <source>The list above has the lots of the project. Design tower puts a first tower on the one chosen.</source>
        <translation>La lista de arriba tiene las parcelas del proyecto. Diseñar torre pone una primera torre en la elegida.</translation>
    </message>
    <message>
        <source>Type 70 storeys, or drag the arrow on the tower. Its shadow follows, and so do height and floor area.</source>
        <translation>Escriba 70 plantas o arrastre la flecha de la torre. La sombra, la altura y la superficie la siguen.</translation>
    </message>
    <message>
        <source>Build puts the tower into a new scenario. One undo takes it back.</source>
        <translation>Construir pone la torre en un escenario nuevo. Un solo Deshacer la retira.</translation>
    </message>
    <message>
        <source>Brown ground gains shadow, blue loses it. The panel Results has the figures.</source>
        <translation>El suelo marrón gana sombra, el azul la pierde. El panel Resultados tiene las cifras.</translation>
    </message>
    <message>
        <source>File &gt; Export writes the comparison as PDF, picture, tables and data. That is the end of this tour.</source>
        <translation>Archivo &gt; Exportar escribe la comparación en PDF, imagen, tablas y datos. Es el final de esta visita.</translation>
    </message>
    <message>
        <source>Planner: weigh shade over a year</source>
        <translation>Planificación: valorar la sombra de un año</translation>
    </message>
    <message>
        <source>Shadow of a whole year, one moment of it, and a score of wanted and unwanted shadow</source>
        <translation>La sombra de todo un año, un momento de él y una puntuación</translation>
    </message>
    <message>
        <source>A study answers four questions. The first is what to measure: choose Hours of shadow.</source>
        <translation>Un estudio responde cuatro preguntas. La primera es qué medir: elija Horas de sombra.</translation>
    </message>
    <message>
        <source>The second is when: choose the whole year.</source>
        <translation>La segunda es cuándo: elija todo el año.</translation>
    </message>
    <message>
        <source>Cells of 10 m are enough for a first look; smaller ones take longer.</source>
        <translation>Celdas de 10 m bastan para una primera mirada; las menores tardan más.</translation>
    </message>
    <message>
        <source>The line above the button says how long a study will take, before it runs. Start it.</source>
        <translation>La línea sobre el botón dice antes cuánto tardará un estudio. Inícielo.</translation>
    </message>
    <message>
        <source>The map shows the whole year. Choose One moment to see sun and shadow at a date and time.</source>
        <translation>El mapa muestra todo el año. Elija Un momento para ver el sol y la sombra en una fecha y hora.</translation>
    </message>
    <message>
        <source>Shade is welcome in summer and unwelcome in winter. The panel Weights says how much, month by month.</source>
        <translation>La sombra se agradece en verano y no en invierno. El panel Pesos dice cuánto, mes a mes.</translation>
    </message>
    <message>
        <source>Compute score adds up the year by these weights. Above zero, wanted shade outweighs unwanted shadow.</source>
        <translation>Calcular puntuación suma el año con estos pesos. Por encima de cero gana la sombra deseada.</translation>
    </message>
    <message>
        <source>File &gt; Export writes the score by month as tables, charts and maps for GIS. That is the end of this tour.</source>
        <translation>Archivo &gt; Exportar escribe la puntuación por mes en tablas, gráficos y mapas para SIG. Es el final de esta visita.</translation>
    </message>
    <message>
        <source>Review board: judge a proposal</source>
        <translation>Autoridad: juzgar una propuesta</translation>
    </message>
    <message>
        <source>A place whose sunlight matters, a proposal, and the verdicts of a rule</source>
        <translation>Un lugar cuyo soleamiento importa, una propuesta y los dictámenes de una norma</translation>
    </message>
    <message>
        <source>A review needs places whose sunlight matters. Choose Study &gt; Draw place and click the corners of a lawn in the park; Enter finishes.</source>
        <translation>Una evaluación necesita lugares cuyo soleamiento importe. Elija Estudio &gt; Dibujar lugar y haga clic en las esquinas de un césped del parque; Intro termina.</translation>
    </message>
    <message>
        <source>It also needs a proposal. Here we design one; usually the project has it already.</source>
        <translation>También necesita una propuesta. Aquí diseñamos una; normalmente el proyecto ya la tiene.</translation>
    </message>
    <message>
        <source>Design tower puts a tower on the lot chosen in the list.</source>
        <translation>Diseñar torre pone una torre en la parcela elegida en la lista.</translation>
    </message>
    <message>
        <source>Build makes it a scenario, which can be compared with the existing city.</source>
        <translation>Construir la convierte en un escenario, que se puede comparar con la ciudad existente.</translation>
    </message>
    <message>
        <source>Study &gt; Review by a rule opens the panel Review.</source>
        <translation>Estudio &gt; Evaluar según una norma abre el panel Evaluación.</translation>
    </message>
    <message>
        <source>Choose the rule of the board, here CEQR of New York. Its tool tip says what it asks and how sure its figures are.</source>
        <translation>Elija la norma de la autoridad, aquí CEQR de Nueva York. Su ayuda emergente dice qué pide y cuán seguras son sus cifras.</translation>
    </message>
    <message>
        <source>Run review judges every ticked place on the days of the rule.</source>
        <translation>Evaluar juzga cada lugar marcado en los días de la norma.</translation>
    </message>
    <message>
        <source>The table has the verdicts and the numbers behind them. Export shows the sheets and writes them with all data. That is the end of this tour.</source>
        <translation>La tabla tiene los dictámenes y sus cifras. Exportar muestra las láminas y las escribe con todos los datos. Es el final de esta visita.</translation>
    </message>
    <message>
        <source>Scenario &gt; Compare with the existing city asks what the tower changes. Where that takes longer, the button Compare of the panel Study starts it.</source>
        <translation>Escenario &gt; Comparar con la ciudad existente pregunta qué cambia la torre. Si tarda más, lo inicia el botón Comparar del panel Estudio.</translation>
    </message>
    <message>
        <source>Play and the two sliders move the sun. Whole period returns to the year.</source>
        <translation>Reproducir y los dos deslizadores mueven el sol. Todo el periodo vuelve al año.</translation>
    </message>
    <message>
        <source>Give it 90 storeys, so that its shadow reaches the lawn.</source>
        <translation>Déle 90 plantas para que su sombra alcance el césped.</translation>
    </message>
</context>
<context>
    <name>TreePanel</name>
    <message>
        <source>With trees, in the mean over the cells, while trees are dragged or planted: the region of the study and the places that change most</source>
        <translation>Con árboles, en la media de las celdas, mientras se arrastran o plantan árboles: la región del estudio y los lugares que más cambian</translation>
    </message>
</context>
<context>
    <name>noonmark</name>
    <message>
        <source>Height field</source>
        <translation>Campo de altura</translation>
    </message>
    <message>
        <source>Field with the heights (default: found by its name)</source>
        <translation>Campo con las alturas (por defecto: se reconoce por su nombre)</translation>
    </message>
    <message>
        <source>found by name</source>
        <translation>hallado por su nombre</translation>
    </message>
    <message>
        <source>Storeys field</source>
        <translation>Campo de plantas</translation>
    </message>
    <message>
        <source>Field with the storeys above the ground (default: found by its name)</source>
        <translation>Campo con las plantas sobre rasante (por defecto: se reconoce por su nombre)</translation>
    </message>
    <message>
        <source>Unit of heights</source>
        <translation>Unidad de las alturas</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>como en el archivo</translation>
    </message>
    <message>
        <source>Height of a storey</source>
        <translation>Altura de una planta</translation>
    </message>
    <message>
        <source>Height of a storey, 2 to 6 m</source>
        <translation>Altura de una planta, de 2 a 6 m</translation>
    </message>
    <message>
        <source>Default height</source>
        <translation>Altura por defecto</translation>
    </message>
    <message>
        <source>Height of buildings without height data, 1 to 1000 m</source>
        <translation>Altura de los edificios sin datos de altura, de 1 a 1000 m</translation>
    </message>
    <message>
        <source>Terrain from building bases</source>
        <translation>Terreno según bases de edificios</translation>
    </message>
    <message>
        <source>If there is no terrain, derive one from the ground elevations of the buildings; auto (default): only where neighbours stand at different heights</source>
        <translation>Si no hay terreno, deducir uno de las cotas del suelo de los edificios; auto (por defecto): solo donde los vecinos están a distinta altura</translation>
    </message>
    <message>
        <source>Terrain shows</source>
        <translation>El terreno muestra</translation>
    </message>
    <message>
        <source>What terrain rasters show: the bare ground, or a surface with the buildings on it; auto (default): a surface where they jump at the outlines of buildings</source>
        <translation>Qué muestran los rásteres de terreno: el suelo desnudo o una superficie con edificios; auto (por defecto): una superficie donde saltan en los contornos</translation>
    </message>
    <message>
        <source>Missing heights from the surface model</source>
        <translation>Alturas que faltan, del modelo de superficie</translation>
    </message>
    <message>
        <source>Give buildings without a height that of the surface model above the ground</source>
        <translation>Dar a los edificios sin altura la del modelo de superficie sobre el suelo</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Capa</translation>
    </message>
    <message>
        <source>Read this layer only</source>
        <translation>Leer solo esta capa</translation>
    </message>
    <message>
        <source>the polygon layers that hold buildings</source>
        <translation>las capas de polígonos con edificios</translation>
    </message>
    <message>
        <source>Coordinate system</source>
        <translation>Sistema de coordenadas</translation>
    </message>
    <message>
        <source>Coordinate reference system of files that do not state it: EPSG:2263</source>
        <translation>Sistema de coordenadas de los archivos que no lo indican: EPSG:2263</translation>
    </message>
    <message>
        <source>as in the file (example: EPSG:2263)</source>
        <translation>como en el archivo (ejemplo: EPSG:2263)</translation>
    </message>
    <message>
        <source>Level of detail</source>
        <translation>Nivel de detalle</translation>
    </message>
    <message>
        <source>the highest</source>
        <translation>el más alto</translation>
    </message>
    <message>
        <source>Maximum distance</source>
        <translation>Distancia máxima</translation>
    </message>
    <message>
        <source>Leave out features farther than this from the middle of the data, m</source>
        <translation>Omitir los objetos más lejanos que esto del centro de los datos, m</translation>
    </message>
    <message>
        <source>Mesh north</source>
        <translation>Norte de la malla</translation>
    </message>
    <message>
        <source>Meshes: azimuth of the mesh&apos;s north axis from true north, clockwise, degrees</source>
        <translation>Mallas: acimut del eje norte de la malla desde el norte geográfico, en sentido horario, grados</translation>
    </message>
    <message>
        <source>Origin located at</source>
        <translation>Origen situado en</translation>
    </message>
    <message>
        <source>Meshes: position of the mesh&apos;s origin, degrees</source>
        <translation>Mallas: posición del origen de la malla, grados</translation>
    </message>
    <message>
        <source>Buildings stand</source>
        <translation>Los edificios se apoyan</translation>
    </message>
    <message>
        <source>Where buildings stand: each on the terrain, or at the elevations that the file states (absolute); auto (default): as its bases lie against the terrain</source>
        <translation>Dónde se apoyan los edificios: cada uno en el terreno o a las cotas del archivo (absolute); auto (por defecto): según estén sus bases respecto al terreno</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Eje vertical</translation>
    </message>
    <message>
        <source>Meshes: the axis that points up, y or z; auto (default): as the format says or the shape suggests</source>
        <translation>Mallas: el eje hacia arriba, y o z; auto (por defecto): según diga el formato o sugiera la forma</translation>
    </message>
    <message>
        <source>Unit of coordinates</source>
        <translation>Unidad de las coordenadas</translation>
    </message>
    <message>
        <source>Receivers</source>
        <translation>Receptores</translation>
    </message>
    <message>
        <source>cells or points where shadow is measured</source>
        <translation>celdas o puntos donde se mide la sombra</translation>
    </message>
    <message>
        <source>Area of the receivers</source>
        <translation>Área de los receptores</translation>
    </message>
    <message>
        <source>area of all receivers</source>
        <translation>área de todos los receptores</translation>
    </message>
    <message>
        <source>Shadow area</source>
        <translation>Área de sombra</translation>
    </message>
    <message>
        <source>sum over the receivers of (share of the sunlit time in shadow x cell area)</source>
        <translation>suma sobre los receptores de (parte del tiempo con sol en sombra x área de la celda)</translation>
    </message>
    <message>
        <source>Mean gross</source>
        <translation>Sombra total media</translation>
    </message>
    <message>
        <source>minutes in shadow per day, mean over days and receivers</source>
        <translation>minutos en sombra al día, media de días y receptores</translation>
    </message>
    <message>
        <source>Max gross</source>
        <translation>Sombra total, máxima</translation>
    </message>
    <message>
        <source>minutes in shadow per day, mean over the days, at the receiver that has most</source>
        <translation>minutos en sombra al día, media de los días, en el receptor que más tiene</translation>
    </message>
    <message>
        <source>Mean continuous</source>
        <translation>Sombra continua media</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow on any day, mean over the receivers</source>
        <translation>sombra ininterrumpida más larga de un día, media de los receptores</translation>
    </message>
    <message>
        <source>Max continuous</source>
        <translation>Sombra continua máxima</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow at any receiver on any day</source>
        <translation>sombra ininterrumpida más larga en un receptor en un día</translation>
    </message>
    <message>
        <source>Bay</source>
        <translation>Vano</translation>
    </message>
    <message>
        <source>Facades: width of a bay, one point or window each</source>
        <translation>Fachadas: ancho de un vano, con un punto o ventana cada uno</translation>
    </message>
    <message>
        <source>Storey</source>
        <translation>Planta</translation>
    </message>
    <message>
        <source>Height of a storey: facades have one point or window each, windows are numbered by it</source>
        <translation>Altura de una planta: las fachadas tienen un punto o ventana en cada una, las ventanas se numeran por ella</translation>
    </message>
    <message>
        <source>Above floor</source>
        <translation>Sobre el suelo</translation>
    </message>
    <message>
        <source>Facades: height of the points above the floor</source>
        <translation>Fachadas: altura de los puntos sobre el suelo de la planta</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Alturas</translation>
    </message>
    <message>
        <source>Windows: heights are elevations, as those of the city, or metres above the ground below</source>
        <translation>Ventanas: las alturas son cotas, como las de la ciudad, o metros sobre el suelo de debajo</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Plane and lines: height above the mean of the ground, of the region or parcel</source>
        <translation>Plano y líneas: altura sobre la media del suelo, de la región o parcela</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Proyecto</translation>
    </message>
    <message>
        <source>Title block: the project</source>
        <translation>Cajetín: el proyecto</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>omitido</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>Title block: the author</source>
        <translation>Cajetín: el autor</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>Cliente</translation>
    </message>
    <message>
        <source>Title block: the client</source>
        <translation>Cajetín: el cliente</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Title block: the date as printed (default: today)</source>
        <translation>Cajetín: la fecha impresa (por defecto: hoy)</translation>
    </message>
    <message>
        <source>Sheet numbers</source>
        <translation>Números de lámina</translation>
    </message>
    <message>
        <source>Title block: A- numbers the sheets A-1, A-2, ...</source>
        <translation>Cajetín: A- numera las hojas A-1, A-2, ...</translation>
    </message>
    <message>
        <source>example: A- for A-1, A-2...</source>
        <translation>ejemplo: A- para A-1, A-2...</translation>
    </message>
    <message>
        <source>Sunlit time</source>
        <translation>Tiempo con sol</translation>
    </message>
    <message>
        <source>minutes of the period with the sun above the horizon</source>
        <translation>minutos del periodo con el sol sobre el horizonte</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>from -1 (shadow is unwanted) to 1 (shade is wanted)</source>
        <translation>de -1 (sombra no deseada) a 1 (sombra deseada)</translation>
    </message>
    <message>
        <source>Water left out</source>
        <translation>Agua excluida</translation>
    </message>
    <message>
        <source>area of rivers and lakes in the region, which is no ground</source>
        <translation>área de ríos y lagos de la región, que no es suelo</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pies</translation>
    </message>
    <message>
        <source>US survey feet</source>
        <translation>pies topográficos de EE. UU.</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>decimetres</source>
        <translation>decímetros</translation>
    </message>
    <message>
        <source>Unit of numbers without a unit in it: m, ft, us-ft, dm, cm, mm or in (default m)</source>
        <translation>Unidad de los números sin unidad: m, ft, us-ft, dm, cm, mm o in (por defecto m)</translation>
    </message>
    <message>
        <source>Meshes: unit of the coordinates: m, ft, us-ft, dm, cm, mm or in (default m)</source>
        <translation>Mallas: unidad de las coordenadas: m, ft, us-ft, dm, cm, mm o in (por defecto m)</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparación</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Saved result</source>
        <translation>Resultado guardado</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Puntuación</translation>
    </message>
    <message>
        <source>of the theoretical area x hours</source>
        <translation>del área x horas teóricas</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>Referencia</translation>
    </message>
    <message>
        <source>area in shadow in the baseline</source>
        <translation>área en sombra en la situación de referencia</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>area in shadow in the scenario</source>
        <translation>área en sombra en el escenario</translation>
    </message>
    <message>
        <source>Incremental</source>
        <translation>Incremental</translation>
    </message>
    <message>
        <source>area in shadow in the scenario, lit in the baseline</source>
        <translation>área en sombra en el escenario, con sol en la situación de referencia</translation>
    </message>
    <message>
        <source>Gained</source>
        <translation>Ganada</translation>
    </message>
    <message>
        <source>area lit in the scenario, in shadow in the baseline</source>
        <translation>área con sol en el escenario, en sombra en la situación de referencia</translation>
    </message>
    <message>
        <source>Days</source>
        <translation>Días</translation>
    </message>
    <message>
        <source>Hours of sun</source>
        <translation>Horas de sol</translation>
    </message>
    <message>
        <source>hours with the sun above the horizon</source>
        <translation>horas con el sol sobre el horizonte</translation>
    </message>
    <message>
        <source>Theoretical</source>
        <translation>Teórica</translation>
    </message>
    <message>
        <source>area x sunlit hours: without any shadow</source>
        <translation>área x horas de sol: sin ninguna sombra</translation>
    </message>
    <message>
        <source>area x hours in shadow in the baseline</source>
        <translation>área x horas en sombra en la situación de referencia</translation>
    </message>
    <message>
        <source>area x hours in shadow in the scenario</source>
        <translation>área x horas en sombra en el escenario</translation>
    </message>
    <message>
        <source>area x hours in shadow in the scenario, lit in the baseline</source>
        <translation>área x horas en sombra en el escenario, con sol en la situación de referencia</translation>
    </message>
    <message>
        <source>area x hours lit in the scenario, in shadow in the baseline</source>
        <translation>área x horas con sol en el escenario, en sombra en la situación de referencia</translation>
    </message>
    <message>
        <source>Share of baseline</source>
        <translation>Parte de la situación de referencia</translation>
    </message>
    <message>
        <source>Share of scenario</source>
        <translation>Parte del escenario</translation>
    </message>
    <message>
        <source>Share of incremental</source>
        <translation>Parte incremental</translation>
    </message>
    <message>
        <source>Open ground</source>
        <translation>Suelo libre</translation>
    </message>
    <message>
        <source>area of the place without buildings</source>
        <translation>área del lugar sin edificios</translation>
    </message>
    <message>
        <source>Mean sun</source>
        <translation>Sol medio</translation>
    </message>
    <message>
        <source>hours of sun a day, mean over the days and the place</source>
        <translation>horas de sol al día, media de los días y del lugar</translation>
    </message>
    <message>
        <source>Min sun</source>
        <translation>Sol mínimo</translation>
    </message>
    <message>
        <source>hours of sun a day, mean over the days, at the cell that has least</source>
        <translation>horas de sol al día, media de los días, en la celda que menos tiene</translation>
    </message>
    <message>
        <source>Max sun</source>
        <translation>Sol máximo</translation>
    </message>
    <message>
        <source>hours of sun a day, mean over the days, at the cell that has most</source>
        <translation>horas de sol al día, media de los días, en la celda que más tiene</translation>
    </message>
    <message>
        <source>Share with enough sun</source>
        <translation>Parte con sol suficiente</translation>
    </message>
    <message>
        <source>share of the area with the hours of sun a day that are enough, or more</source>
        <translation>parte del área con las horas de sol al día suficientes o más</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>points where sun is measured</source>
        <translation>puntos donde se mide el sol</translation>
    </message>
    <message>
        <source>mean minutes a day with the sun above the horizon: 100 % of the time</source>
        <translation>minutos medios al día con el sol sobre el horizonte: 100 % del tiempo</translation>
    </message>
    <message>
        <source>Least sun</source>
        <translation>Sol mínimo</translation>
    </message>
    <message>
        <source>Most sun</source>
        <translation>Sol máximo</translation>
    </message>
    <message>
        <source>minutes in shadow per day, mean over days and points; a point that faces away from the sun is in shadow</source>
        <translation>minutos en sombra al día, media de días y puntos; un punto que no mira al sol está en sombra</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow on any day, mean over the points</source>
        <translation>sombra ininterrumpida más larga de un día, media de los puntos</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow at any point on any day</source>
        <translation>sombra ininterrumpida más larga en un punto en un día</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>minutes per day that a point is in the sun, mean over the days</source>
        <translation>minutos al día que un punto está al sol, media de los días</translation>
    </message>
    <message>
        <source>Share of time</source>
        <translation>Parte del tiempo</translation>
    </message>
    <message>
        <source>sun, of the time with the sun above the horizon</source>
        <translation>sol, del tiempo con el sol sobre el horizonte</translation>
    </message>
    <message>
        <source>Gross</source>
        <translation>Total</translation>
    </message>
    <message>
        <source>minutes in shadow per day, mean over the days; a point that faces away from the sun is in shadow</source>
        <translation>minutos en sombra al día, media de los días; un punto que no mira al sol está en sombra</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Continua</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow on any day</source>
        <translation>sombra ininterrumpida más larga de un día</translation>
    </message>
    <message>
        <source>Longest sun</source>
        <translation>Sol más largo</translation>
    </message>
    <message>
        <source>longest unbroken run in the sun on any day</source>
        <translation>sol ininterrumpido más largo de un día</translation>
    </message>
    <message>
        <source>minutes of the month with the sun above the horizon</source>
        <translation>minutos del mes con el sol sobre el horizonte</translation>
    </message>
    <message>
        <source>Mean shadow</source>
        <translation>Sombra media</translation>
    </message>
    <message>
        <source>minutes in shadow in the whole month, mean over the receivers</source>
        <translation>minutos en sombra en todo el mes, media de los receptores</translation>
    </message>
    <message>
        <source>Number of days</source>
        <translation>Número de días</translation>
    </message>
    <message>
        <source>Hours per day</source>
        <translation>Horas al día</translation>
    </message>
    <message>
        <source>Hours a day, 0 to 24; 0 is one instant</source>
        <translation>Horas al día, de 0 a 24; 0 es un instante</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Length of a step, minutes; adjusted so that whole steps fill the hours of each day</source>
        <translation>Duración de un paso en minutos; ajustada para que pasos enteros llenen las horas de cada día</translation>
    </message>
    <message>
        <source>More shadow</source>
        <translation>Más sombra</translation>
    </message>
    <message>
        <source>area where the minutes rose by more than the threshold</source>
        <translation>área donde los minutos aumentaron más que el umbral</translation>
    </message>
    <message>
        <source>Less shadow</source>
        <translation>Menos sombra</translation>
    </message>
    <message>
        <source>area where the minutes fell by more than the threshold</source>
        <translation>área donde los minutos disminuyeron más que el umbral</translation>
    </message>
    <message>
        <source>Any more shadow</source>
        <translation>Cualquier sombra más</translation>
    </message>
    <message>
        <source>area where the minutes rose at all</source>
        <translation>área donde los minutos aumentaron algo</translation>
    </message>
    <message>
        <source>Any less shadow</source>
        <translation>Cualquier sombra menos</translation>
    </message>
    <message>
        <source>area where the minutes fell at all</source>
        <translation>área donde los minutos disminuyeron algo</translation>
    </message>
    <message>
        <source>Mean change</source>
        <translation>Cambio medio</translation>
    </message>
    <message>
        <source>mean of the change over the receivers</source>
        <translation>media del cambio sobre los receptores</translation>
    </message>
    <message>
        <source>Largest increase</source>
        <translation>Mayor aumento</translation>
    </message>
    <message>
        <source>the largest increase of a receiver</source>
        <translation>el mayor aumento de un receptor</translation>
    </message>
    <message>
        <source>Largest decrease</source>
        <translation>Mayor disminución</translation>
    </message>
    <message>
        <source>the largest decrease of a receiver</source>
        <translation>la mayor disminución de un receptor</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Umbral</translation>
    </message>
    <message>
        <source>change that counts: minutes a day of gross shadow, minutes of continuous shadow</source>
        <translation>cambio que cuenta: minutos al día de sombra total, minutos de sombra continua</translation>
    </message>
    <message>
        <source>Change of the shadow area</source>
        <translation>Cambio del área de sombra</translation>
    </message>
    <message>
        <source>change of the sum over the receivers of (share of the sunlit time in shadow x cell area)</source>
        <translation>cambio de la suma sobre los receptores de (parte del tiempo con sol en sombra x área de la celda)</translation>
    </message>
    <message>
        <source>Built over</source>
        <translation>Edificado</translation>
    </message>
    <message>
        <source>open ground before, under a building after: no receiver</source>
        <translation>suelo libre antes, bajo un edificio después: sin receptor</translation>
    </message>
    <message>
        <source>Became ground</source>
        <translation>Ahora suelo</translation>
    </message>
    <message>
        <source>under a building before, open ground after: no receiver</source>
        <translation>bajo un edificio antes, suelo libre después: sin receptor</translation>
    </message>
    <message>
        <source>Share of the lot</source>
        <translation>Parte de la parcela</translation>
    </message>
    <message>
        <source>Floor plate, % of the lot (default: all of it)</source>
        <translation>Planta, % de la parcela (por defecto: toda)</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Floor plate, m2</source>
        <translation>Planta, m²</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Estrechamiento</translation>
    </message>
    <message>
        <source>How much narrower the volume is at its top than at its bottom</source>
        <translation>Cuánto más estrecho es el volumen arriba que abajo</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torsión</translation>
    </message>
    <message>
        <source>Turn of the volume from its bottom to its top, clockwise</source>
        <translation>Giro del volumen de abajo arriba, en sentido horario</translation>
    </message>
    <message>
        <source>Storey height</source>
        <translation>Altura de planta</translation>
    </message>
    <message>
        <source>Height of a storey, floor to floor</source>
        <translation>Altura de una planta, de suelo a suelo</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>Plantas</translation>
    </message>
    <message>
        <source>Number of storeys, podium included</source>
        <translation>Número de plantas, con el podio</translation>
    </message>
    <message>
        <source>Height above ground</source>
        <translation>Altura sobre el terreno</translation>
    </message>
    <message>
        <source>Total height</source>
        <translation>Altura total</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Rotation clockwise about the middle of the tower, which must stay on its lot</source>
        <translation>Giro horario alrededor del centro de la torre, que debe quedar en su parcela</translation>
    </message>
    <message>
        <source>Podium</source>
        <translation>Basamento</translation>
    </message>
    <message>
        <source>Storeys of a podium below the tower</source>
        <translation>Plantas de un podio bajo la torre</translation>
    </message>
    <message>
        <source>From height</source>
        <translation>Desde la altura</translation>
    </message>
    <message>
        <source>Inset</source>
        <translation>Retranqueo</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Uso</translation>
    </message>
    <message>
        <source>Setbacks</source>
        <translation>Retranqueos</translation>
    </message>
    <message>
        <source>Uses</source>
        <translation>Usos</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Métrico</translation>
    </message>
    <message>
        <source>Imperial</source>
        <translation>Imperial</translation>
    </message>
    <message>
        <source>Metric and imperial</source>
        <translation>Métrico e imperial</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>Units of lengths and areas in tables and sheets</source>
        <translation>Unidades de longitudes y áreas en tablas y hojas</translation>
    </message>
    <message>
        <source>Score per m² of ground</source>
        <translation>Puntuación por m² de suelo</translation>
    </message>
    <message>
        <source>score divided by the area of all receivers</source>
        <translation>puntuación dividida por el área de todos los receptores</translation>
    </message>
    <message>
        <source>time in the sun per day, mean over days and points</source>
        <translation>tiempo al sol al día, media de días y puntos</translation>
    </message>
    <message>
        <source>time in the sun per day at the darkest point</source>
        <translation>tiempo al sol al día en el punto más oscuro</translation>
    </message>
    <message>
        <source>time in the sun per day at the sunniest point</source>
        <translation>tiempo al sol al día en el punto más soleado</translation>
    </message>
    <message>
        <source>Sun by place</source>
        <translation>Sol por lugar</translation>
    </message>
    <message>
        <source>hours of sun a day</source>
        <translation>horas de sol al día</translation>
    </message>
    <message>
        <source>Share of the area, %</source>
        <translation>Parte del área, %</translation>
    </message>
    <message>
        <source>Area that changes, m²</source>
        <translation>Área que cambia, m²</translation>
    </message>
    <message>
        <source>minutes of shadow a day, more than before</source>
        <translation>minutos de sombra al día, más que antes</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>What maps and sheets show: minutes of shadow, hours of sun, or the share of the sunlit time in the sun</source>
        <translation>Qué muestran mapas y láminas: minutos de sombra, horas de sol o la parte del tiempo con sol que se está al sol</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation>Invertido</translation>
    </message>
    <message>
        <source>Turn the colours round: bright where there is much shadow</source>
        <translation>Invierte los colores: claro donde hay mucha sombra</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Intervalo</translation>
    </message>
    <message>
        <source>Values at the ends of the legend, in the unit shown: 0:8; without it fitted to each map</source>
        <translation>Valores en los extremos de la leyenda, en la unidad mostrada: 0:8; si no se indican, se ajustan a cada mapa</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>ajustado</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Clases</translation>
    </message>
    <message>
        <source>Classes of the legend: continuous, equal:5, quantiles:5, or the numbers between them: 2,4,6; one number is a threshold</source>
        <translation>Clases de la leyenda: continuous, equal:5, quantiles:5 o los números entre ellas: 2,4,6; un solo número es un umbral</translation>
    </message>
    <message>
        <source>%1 of the area in shadow</source>
        <translation>%1 del área en sombra</translation>
    </message>
    <message>
        <source>%1: %2 in shadow</source>
        <translation>%1: %2 en sombra</translation>
    </message>
    <message>
        <source>%1 of sun a day, %2 in shade</source>
        <translation>%1 de sol al día, %2 en sombra</translation>
    </message>
    <message>
        <source>%1: %2 of sun a day, %3 in shade</source>
        <translation>%1: %2 de sol al día, %3 en sombra</translation>
    </message>
    <message>
        <source>Of %1 a day with the sun up, the darkest spot gets %2.</source>
        <translation>De %1 al día con el sol sobre el horizonte, el punto más oscuro recibe %2.</translation>
    </message>
    <message>
        <source>The longest unbroken shadow lasts %1.</source>
        <translation>La sombra ininterrumpida más larga dura %1.</translation>
    </message>
    <message>
        <source>sunlit time minus gross shadow per day, mean over days and receivers</source>
        <translation>tiempo de sol menos sombra total al día, media de días y receptores</translation>
    </message>
    <message>
        <source>Enough sun</source>
        <translation>Sol suficiente</translation>
    </message>
    <message>
        <source>Hours of sun a day that are enough: the share of each place that has them is stated</source>
        <translation>Horas de sol al día que son suficientes: se indica la parte de cada lugar que las tiene</translation>
    </message>
    <message>
        <source>Dates</source>
        <translation>Fechas</translation>
    </message>
    <message>
        <source>A day: the share of each place with less than enough sun on it is stated; may be repeated</source>
        <translation>Un día: se indica la parte de cada lugar que ese día no tiene sol suficiente; se puede repetir</translation>
    </message>
    <message>
        <source>Loss that counts</source>
        <translation>Pérdida que cuenta</translation>
    </message>
    <message>
        <source>Minutes of sun a day: the share of each place that loses more is stated</source>
        <translation>Minutos de sol al día: se indica la parte de cada lugar que pierde más</translation>
    </message>
    <message>
        <source>%1 of %2 places have less than %3 of sun a day</source>
        <translation>%1 de %2 lugares tienen menos de %3 de sol al día</translation>
    </message>
    <message>
        <source>Change of mean sun</source>
        <translation>Cambio del sol medio</translation>
    </message>
    <message>
        <source>hours of sun a day more than in the baseline, mean over the days and the place; negative: less</source>
        <translation>horas de sol al día más que en la referencia, media de los días y del lugar; negativo: menos</translation>
    </message>
    <message>
        <source>Largest loss</source>
        <translation>Mayor pérdida</translation>
    </message>
    <message>
        <source>minutes of sun a day less than in the baseline, mean over the days, at the cell that loses most</source>
        <translation>minutos de sol al día menos que en la referencia, media de los días, en la celda que más pierde</translation>
    </message>
    <message>
        <source>Largest gain</source>
        <translation>Mayor ganancia</translation>
    </message>
    <message>
        <source>minutes of sun a day more than in the baseline, mean over the days, at the cell that gains most</source>
        <translation>minutos de sol al día más que en la referencia, media de los días, en la celda que más gana</translation>
    </message>
    <message>
        <source>Share that loses sun</source>
        <translation>Parte que pierde sol</translation>
    </message>
    <message>
        <source>share of the area that loses more minutes of sun a day than the threshold of loss</source>
        <translation>parte del área que pierde más minutos de sol al día que el umbral de pérdida</translation>
    </message>
    <message>
        <source>Attributed shadow</source>
        <translation>Sombra atribuida</translation>
    </message>
    <message>
        <source>the part of the shadow that one building is charged with; the attributed shadows of all buildings and of the terrain add up to the total</source>
        <translation>la parte de la sombra que se imputa a un edificio; las sombras atribuidas de todos los edificios y del terreno suman el total</translation>
    </message>
    <message>
        <source>Sole contribution</source>
        <translation>Contribución exclusiva</translation>
    </message>
    <message>
        <source>the shadow that would disappear if only this building were gone</source>
        <translation>la sombra que desaparecería si solo faltara este edificio</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>attributed shadow, as a share of all shadow on the cells</source>
        <translation>sombra atribuida, como parte de toda la sombra en las celdas</translation>
    </message>
    <message>
        <source>Attributed</source>
        <translation>Atribuida</translation>
    </message>
    <message>
        <source>attributed shadow in minutes a day, mean over the cells</source>
        <translation>sombra atribuida en minutos al día, media de las celdas</translation>
    </message>
    <message>
        <source>Sole</source>
        <translation>Exclusiva</translation>
    </message>
    <message>
        <source>sole contribution in minutes a day, mean over the cells</source>
        <translation>contribución exclusiva en minutos al día, media de las celdas</translation>
    </message>
    <message>
        <source>Attributed area x hours</source>
        <translation>Área x horas atribuidas</translation>
    </message>
    <message>
        <source>attributed shadow as area x hours of the whole period</source>
        <translation>sombra atribuida como área x horas de todo el periodo</translation>
    </message>
    <message>
        <source>Sole area x hours</source>
        <translation>Área x horas exclusivas</translation>
    </message>
    <message>
        <source>sole contribution as area x hours of the whole period</source>
        <translation>contribución exclusiva como área x horas de todo el periodo</translation>
    </message>
    <message>
        <source>%1 of sun a day on average at %2 points</source>
        <translation>%1 de sol al día de media en %2 puntos</translation>
    </message>
    <message>
        <source>The darkest point gets %1, the sunniest %2, of %3 a day with the sun up.</source>
        <translation>El punto más oscuro recibe %1, el más soleado %2, de %3 al día con el sol sobre el horizonte.</translation>
    </message>
    <message>
        <source>Share of the points, %</source>
        <translation>Parte de los puntos, %</translation>
    </message>
    <message>
        <source>%1 changes no shadow here</source>
        <translation>%1 no cambia ninguna sombra aquí</translation>
    </message>
    <message>
        <source>%1 takes %2 of sun a day on average, at most %3 at one spot</source>
        <translation>%1 quita %2 de sol al día de media, como máximo %3 en un punto</translation>
    </message>
    <message>
        <source>%1 gives %2 of sun a day on average, at most %3 at one spot</source>
        <translation>%1 da %2 de sol al día de media, como máximo %3 en un punto</translation>
    </message>
    <message>
        <source>More shadow on %1, less on %2; by more than %3 a day on %4 and %5.</source>
        <translation>Más sombra en %1, menos en %2; en más de %3 al día en %4 y %5.</translation>
    </message>
    <message>
        <source>%1 changes the shadow by %2 at this moment</source>
        <translation>%1 cambia la sombra en %2 en este momento</translation>
    </message>
    <message>
        <source>%1 scores %2: wanted shade outweighs unwanted shadow</source>
        <translation>%1 obtiene %2: la sombra deseada pesa más que la no deseada</translation>
    </message>
    <message>
        <source>%1 scores %2: unwanted shadow outweighs wanted shade</source>
        <translation>%1 obtiene %2: la sombra no deseada pesa más que la deseada</translation>
    </message>
    <message>
        <source>%1 scores 0: wanted shade and unwanted shadow weigh the same</source>
        <translation>%1 obtiene 0: la sombra deseada y la no deseada pesan lo mismo</translation>
    </message>
    <message>
        <source>Weighted shade by month, m² h</source>
        <translation>Sombra ponderada por mes, m² h</translation>
    </message>
    <message>
        <source>Weighted by time: %1.</source>
        <translation>Ponderado por tiempo: %1.</translation>
    </message>
    <message>
        <source>Shadow area by month, m²</source>
        <translation>Área de sombra por mes, m²</translation>
    </message>
    <message>
        <source>minutes of sun a day, more than before</source>
        <translation>minutos de sol al día, más que antes</translation>
    </message>
    <message>
        <source>Colours of maps; all but traffic-light are safe for colour-blind readers. Maps of sun by place take violet-orange unless another is named</source>
        <translation>Colores de los mapas; todos menos traffic-light son aptos para daltónicos. Los mapas de sol por lugar usan violet-orange si no se nombra otra</translation>
    </message>
    <message>
        <source>Colours of changes</source>
        <translation>Colores de los cambios</translation>
    </message>
    <message>
        <source>Colours of differences and scores; all but green-red are safe for colour-blind readers</source>
        <translation>Colores de diferencias y puntuaciones; todos menos green-red son aptos para daltónicos</translation>
    </message>
    <message>
        <source>Changes reversed</source>
        <translation>Cambios invertidos</translation>
    </message>
    <message>
        <source>Turn the colours of differences and scores round</source>
        <translation>Invertir los colores de diferencias y puntuaciones</translation>
    </message>
    <message>
        <source>Classes of changes</source>
        <translation>Clases de los cambios</translation>
    </message>
    <message>
        <source>Classes of the legend of differences and scores, as of --classes; numbers in minutes of a difference: -30,-10,10,30</source>
        <translation>Clases de la leyenda de diferencias y puntuaciones, como en --classes; números en minutos de una diferencia: -30,-10,10,30</translation>
    </message>
    <message>
        <source>%1 of sun a day, %2 of what is possible</source>
        <translation>%1 de sol al día, %2 de lo posible</translation>
    </message>
    <message>
        <source>%1: %2 of sun a day, %3 of what is possible</source>
        <translation>%1: %2 de sol al día, %3 de lo posible</translation>
    </message>
    <message>
        <source>%1 of the possible sun, %2 a day</source>
        <translation>%1 del sol posible, %2 al día</translation>
    </message>
    <message>
        <source>%1: %2 of the possible sun, %3 a day</source>
        <translation>%1: %2 del sol posible, %3 al día</translation>
    </message>
    <message>
        <source>sunlit time minus gross shadow per day, at the receiver that has most shadow</source>
        <translation>tiempo con sol menos sombra total al día, en el receptor con más sombra</translation>
    </message>
    <message>
        <source>Sunlit area</source>
        <translation>Área con sol</translation>
    </message>
    <message>
        <source>sum over the receivers of (share of the sunlit time in the sun x cell area)</source>
        <translation>suma sobre los receptores de (parte del tiempo con sol al sol x área de la celda)</translation>
    </message>
    <message>
        <source>Hours of sun a day of the places that change most</source>
        <translation>Horas de sol al día de los lugares que más cambian</translation>
    </message>
    <message>
        <source>places</source>
        <translation>lugares</translation>
    </message>
    <message>
        <source>First day</source>
        <translation>Primer día</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>Time zone</source>
        <translation>Zona horaria</translation>
    </message>
    <message>
        <source>Sun as seen through the air</source>
        <translation>Sol a través del aire</translation>
    </message>
    <message>
        <source>Less sun</source>
        <translation>Menos sol</translation>
    </message>
    <message>
        <source>area that lost more minutes of sun than the threshold</source>
        <translation>área que perdió más minutos de sol que el umbral</translation>
    </message>
    <message>
        <source>More sun</source>
        <translation>Más sol</translation>
    </message>
    <message>
        <source>area that gained more minutes of sun than the threshold</source>
        <translation>área que ganó más minutos de sol que el umbral</translation>
    </message>
    <message>
        <source>Any less sun</source>
        <translation>Cualquier sol menos</translation>
    </message>
    <message>
        <source>area that lost any sun</source>
        <translation>área que perdió algo de sol</translation>
    </message>
    <message>
        <source>Any more sun</source>
        <translation>Cualquier sol más</translation>
    </message>
    <message>
        <source>area that gained any sun</source>
        <translation>área que ganó algo de sol</translation>
    </message>
    <message>
        <source>Mean change of sun</source>
        <translation>Cambio medio del sol</translation>
    </message>
    <message>
        <source>mean of the change of sun over the receivers; negative: less sun</source>
        <translation>media del cambio del sol sobre los receptores; negativo: menos sol</translation>
    </message>
    <message>
        <source>Largest loss of sun</source>
        <translation>Mayor pérdida de sol</translation>
    </message>
    <message>
        <source>the most sun that a receiver loses</source>
        <translation>el máximo sol que pierde un receptor</translation>
    </message>
    <message>
        <source>Largest gain of sun</source>
        <translation>Mayor ganancia de sol</translation>
    </message>
    <message>
        <source>the most sun that a receiver gains</source>
        <translation>el máximo sol que gana un receptor</translation>
    </message>
    <message>
        <source>Change of the sunlit area</source>
        <translation>Cambio del área con sol</translation>
    </message>
    <message>
        <source>change of the sum over the receivers of (share of the sunlit time in the sun x cell area)</source>
        <translation>cambio de la suma sobre los receptores de (parte del tiempo con sol al sol x área de la celda)</translation>
    </message>
    <message>
        <source>%1 changes no sun here</source>
        <translation>%1 no cambia el sol aquí</translation>
    </message>
    <message>
        <source>Less sun on %1, more on %2; by more than %3 a day on %4 and %5.</source>
        <translation>Menos sol en %1, más en %2; en más de %3 al día en %4 y %5.</translation>
    </message>
    <message>
        <source>Sunlit area by month, m²</source>
        <translation>Área con sol por mes, m²</translation>
    </message>
    <message>
        <source>Cells of small places</source>
        <translation>Celdas de lugares pequeños</translation>
    </message>
    <message>
        <source>Size of the cells of places with fewer than 25 cells, m; no effect if it is not smaller than that of the others</source>
        <translation>Tamaño de las celdas de lugares con menos de 25 celdas, m; tan grande como las demás o mayor: el mismo</translation>
    </message>
    <message>
        <source>Ray reference</source>
        <translation>Referencia por rayos</translation>
    </message>
    <message>
        <source>One ray per receiver and step, traced by Embree: the reference for the errors of the others</source>
        <translation>Un rayo por receptor y paso, trazado con Embree: la verdad con la que se miden los demás</translation>
    </message>
    <message>
        <source>Projected shadows</source>
        <translation>Sombras proyectadas</translation>
    </message>
    <message>
        <source>Each building&apos;s shadow filled as polygons at every step: exact and fast on flat ground</source>
        <translation>La sombra de cada edificio rellenada como polígonos en cada paso: exacto y rápido en suelo llano</translation>
    </message>
    <message>
        <source>Horizon sweep</source>
        <translation>Barrido de horizontes</translation>
    </message>
    <message>
        <source>The slope of each receiver&apos;s horizon, azimuth by azimuth: a year takes seconds, on terrain and roofs too</source>
        <translation>La pendiente del horizonte de cada receptor, acimut a acimut: un año en un momento, también en terreno y cubiertas</translation>
    </message>
    <message>
        <source>Shadow accrual map</source>
        <translation>Mapa de acumulación de sombra</translation>
    </message>
    <message>
        <source>A depth map of each step of an hour, drawn from a city placed once; hours that look alike computed once</source>
        <translation>Un mapa de profundidad por cada paso de una hora, dibujado con la ciudad colocada una vez; las horas parecidas se calculan una vez</translation>
    </message>
    <message>
        <source>Inverse accrual map</source>
        <translation>Mapa de acumulación inverso</translation>
    </message>
    <message>
        <source>Occluders at both ends of each hour, their shadows moved along straight lines between; hours that look alike computed once</source>
        <translation>Obstáculos en ambos extremos de cada hora, sus sombras movidas en línea recta entre ellos; las horas parecidas se calculan una vez</translation>
    </message>
    <message>
        <source>Ray reference through the direction graph</source>
        <translation>Referencia por rayos mediante el grafo de direcciones</translation>
    </message>
    <message>
        <source>Rays, with hours that look alike traced once: what the graph alone does to the error</source>
        <translation>Rayos, con las horas parecidas trazadas una vez: qué hace solo el grafo con el error</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Projected shadows, the horizon sweep or rays: the exact one where it is quick, and the result says which and why</source>
        <translation>Sombras proyectadas, barrido de horizontes o rayos: el exacto donde es rápido, y el resultado dice cuál y por qué</translation>
    </message>
    <message>
        <source>Shadow maps (OpenGL)</source>
        <translation>Mapas de sombra (OpenGL)</translation>
    </message>
    <message>
        <source>Draws one depth map per step and tests every cell against it: the method that the paper compares accrual maps with</source>
        <translation>Dibuja un mapa de profundidad por paso y comprueba cada celda: el método con que compara el artículo</translation>
    </message>
    <message>
        <source>Shadow accrual map (OpenGL)</source>
        <translation>Mapa de acumulación de sombra (OpenGL)</translation>
    </message>
    <message>
        <source>One draw on the graphics device fills the depth maps of all steps of an hour</source>
        <translation>Un solo dibujo en la tarjeta gráfica llena los mapas de profundidad de todos los pasos de una hora</translation>
    </message>
    <message>
        <source>Error target</source>
        <translation>Error objetivo</translation>
    </message>
    <message>
        <source>Target for the mean error of a cell&apos;s gross shadow, of the period. Halving it doubles the time of a run</source>
        <translation>Error medio de la sombra total de una celda, del periodo: los intervalos de acimut son tan anchos como permite; la mitad tarda el doble</translation>
    </message>
    <message>
        <source>Azimuth bin</source>
        <translation>Intervalo de acimut</translation>
    </message>
    <message>
        <source>Suns whose azimuth is less than this apart share one horizon; 0: as the error target asks</source>
        <translation>Los soles con menos separación de acimut comparten un horizonte; 0: según el error objetivo</translation>
    </message>
    <message>
        <source>Continuous shadow</source>
        <translation>Sombra continua</translation>
    </message>
    <message>
        <source>The longest unbroken shadow is counted too; without it, gross shadow only, in about half the time</source>
        <translation>También se cuenta la sombra ininterrumpida más larga; sin ella, solo la total, en la mitad del tiempo</translation>
    </message>
    <message>
        <source>Check runs</source>
        <translation>Comprobar tramos</translation>
    </message>
    <message>
        <source>Map size</source>
        <translation>Tamaño del mapa</translation>
    </message>
    <message>
        <source>Texels along a side of the depth map that is stretched over the region; no more than cells are used</source>
        <translation>Téxeles por lado del mapa de profundidad sobre la zona; no más que celdas</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>Desfase</translation>
    </message>
    <message>
        <source>How high above the ground something must be to shade it</source>
        <translation>A qué altura sobre el suelo debe estar algo para darle sombra</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Intervalo</translation>
    </message>
    <message>
        <source>How long the sun is taken to move in a straight line</source>
        <translation>Cuánto tiempo se supone que el sol se mueve en línea recta</translation>
    </message>
    <message>
        <source>Direction bound</source>
        <translation>Límite de dirección</translation>
    </message>
    <message>
        <source>Hours whose sun is less than this apart are computed once</source>
        <translation>Las horas cuyo sol dista menos se calculan una vez</translation>
    </message>
    <message>
        <source>Source levels</source>
        <translation>Niveles de origen</translation>
    </message>
    <message>
        <source>How many occluders, nearest first, are followed from each cell</source>
        <translation>Cuántos obstáculos, primero los más cercanos, se siguen desde cada celda</translation>
    </message>
    <message>
        <source>Sources by rays</source>
        <translation>Orígenes por rayos</translation>
    </message>
    <message>
        <source>Embree finds the occluders at an interval&apos;s ends; otherwise filled polygons do, which is faster</source>
        <translation>Embree halla los obstáculos en los extremos del intervalo; si no, polígonos rellenos, más rápido</translation>
    </message>
    <message>
        <source>Nearest hit</source>
        <translation>Impacto más cercano</translation>
    </message>
    <message>
        <source>Occluders nearer to a cell than this are left out (the paper: 1 m)</source>
        <translation>Se omiten los obstáculos más cercanos a una celda (el artículo: 1 m)</translation>
    </message>
    <message>
        <source>OpenCL device</source>
        <translation>Dispositivo OpenCL</translation>
    </message>
    <message>
        <source>Which OpenCL device draws, counted from 0; -1: the processor itself</source>
        <translation>Qué dispositivo OpenCL dibuja, contado desde 0; -1: el propio procesador</translation>
    </message>
    <message>
        <source>Rays look at every step of every longest run, so that a gap between two walls in one line is found too; without it, they look at what neighbouring bins leave in doubt</source>
        <translation>Los rayos comprueban cada paso de cada intervalo más largo, de modo que también se encuentra un hueco entre dos muros alineados; sin ello, comprueban lo que las direcciones vecinas dejan en duda</translation>
    </message>
    <message>
        <source>Gross shadow</source>
        <translation>Sombra total</translation>
    </message>
    <message>
        <source>minutes in shadow a day</source>
        <translation>minutos en sombra al día</translation>
    </message>
    <message>
        <source>longest run, minutes</source>
        <translation>tramo más largo, minutos</translation>
    </message>
    <message>
        <source>Change of gross shadow</source>
        <translation>Cambio de sombra total</translation>
    </message>
    <message>
        <source>Change of continuous shadow</source>
        <translation>Cambio de sombra continua</translation>
    </message>
    <message>
        <source>min a day</source>
        <translation>min al día</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>scale fitted to this difference</source>
        <translation>escala ajustada a esta diferencia</translation>
    </message>
    <message>
        <source>Shadow score</source>
        <translation>Puntuación de sombra</translation>
    </message>
    <message>
        <source>weight × share of time</source>
        <translation>peso × parte del tiempo</translation>
    </message>
    <message>
        <source>built over</source>
        <translation>edificado</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Sombra</translation>
    </message>
    <message>
        <source>at this moment</source>
        <translation>en este momento</translation>
    </message>
    <message>
        <source>scale locked: %1</source>
        <translation>escala fija: %1</translation>
    </message>
    <message>
        <source>largest %1</source>
        <translation>mayor %1</translation>
    </message>
    <message>
        <source>Verdicts on windows</source>
        <translation>Veredictos de las ventanas</translation>
    </message>
    <message>
        <source>before</source>
        <translation>antes</translation>
    </message>
    <message>
        <source>after</source>
        <translation>después</translation>
    </message>
    <message>
        <source>Change of verdicts</source>
        <translation>Cambio de los veredictos</translation>
    </message>
    <message>
        <source>from before to after</source>
        <translation>de antes a después</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>cumple</translation>
    </message>
    <message>
        <source>borderline</source>
        <translation>en el límite</translation>
    </message>
    <message>
        <source>fail</source>
        <translation>no cumple</translation>
    </message>
    <message>
        <source>not applicable</source>
        <translation>no aplicable</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>peor</translation>
    </message>
    <message>
        <source>better</source>
        <translation>mejor</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>igual</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>sin comparar</translation>
    </message>
    <message>
        <source>Share of the sunlit time</source>
        <translation>Parte del tiempo con sol</translation>
    </message>
    <message>
        <source>% in the sun</source>
        <translation>% al sol</translation>
    </message>
    <message>
        <source>Change of sun</source>
        <translation>Cambio de sol</translation>
    </message>
    <message>
        <source>CityGML, CityJSON: level of detail (default: the highest)</source>
        <translation>CityGML, CityJSON: nivel de detalle (por defecto: el más alto)</translation>
    </message>
    <message>
        <source>%1, with 99 % certainty within %2</source>
        <translation>%1, con un 99 % de certeza dentro de %2</translation>
    </message>
    <message>
        <source>%1 in the mean, 99 of 100 within %2, at most %3</source>
        <translation>%1 de media, 99 de cada 100 dentro de %2, como máximo %3</translation>
    </message>
    <message>
        <source>%1 takes more than a minute of sun a day from %2 places, at most %3 at one spot.</source>
        <translation>%1 quita más de un minuto de sol al día a %2 lugares, como máximo %3 en un punto.</translation>
    </message>
    <message>
        <source>Floor plate</source>
        <translation>Planta tipo</translation>
    </message>
    <message>
        <source>Gross floor area</source>
        <translation>Superficie construida total</translation>
    </message>
    <message>
        <source>Floor area ratio (FAR)</source>
        <translation>Edificabilidad</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Verdicts on places</source>
        <translation>Veredictos de los lugares</translation>
    </message>
    <message>
        <source>Review of windows</source>
        <translation>Evaluación de ventanas</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Evaluación</translation>
    </message>
    <message>
        <source>Inventories of trees</source>
        <translation>Inventarios de árboles</translation>
    </message>
    <message>
        <source>File with trees beside those of the city&apos;s files: points or a table with species, height, crown or stem; may be repeated</source>
        <translation>Archivo con árboles además de los de los archivos de ciudad: puntos o una tabla con especie, altura, copa o tronco; se puede repetir</translation>
    </message>
    <message>
        <source>Change of the minutes of sun a day by month</source>
        <translation>Cambio de los minutos de sol al día por mes</translation>
    </message>
    <message>
        <source>Change of the minutes of sun a day of these places</source>
        <translation>Cambio de los minutos de sol al día de estos lugares</translation>
    </message>
    <message>
        <source>%1 and %2 take the same sun: %3 a day on average over the places.</source>
        <translation>%1 y %2 quitan el mismo sol: %3 al día de media en los lugares.</translation>
    </message>
    <message>
        <source>%1 takes less sun than %2: %3 against %4 a day on average over the places.</source>
        <translation>%1 quita menos sol que %2: %3 frente a %4 al día de media en los lugares.</translation>
    </message>
    <message>
        <source>On %1 it has %2; %3 of its area has less than %4.</source>
        <translation>El %1 tiene %2; el %3 de su área tiene menos de %4.</translation>
    </message>
    <message>
        <source>%1 gives it %2 of sun a day, at most %3 at one spot.</source>
        <translation>%1 le da %2 de sol al día, como máximo %3 en un punto.</translation>
    </message>
    <message>
        <source>%1 takes %2 of sun a day from it, at most %3 at one spot.</source>
        <translation>%1 le quita %2 de sol al día, como máximo %3 en un punto.</translation>
    </message>
    <message>
        <source>%1 of %2 places fail %3 in %4</source>
        <translation>%1 de %2 lugares no cumplen %3 en %4</translation>
    </message>
    <message>
        <source>No place fails %3 in %4, but %1 of %2 are borderline</source>
        <translation>Ningún lugar incumple %3 en %4, pero %1 de %2 están en el límite</translation>
    </message>
    <message>
        <source>All of the %2 places judged pass %3 in %4</source>
        <translation>Los %2 lugares juzgados cumplen %3 en %4</translation>
    </message>
    <message>
        <source>%3 judges none of the places in %4</source>
        <translation>%3 no juzga ninguno de los lugares en %4</translation>
    </message>
    <message>
        <source>%1 of %2 windows fail %3 in %4</source>
        <translation>%1 de %2 ventanas no cumplen %3 en %4</translation>
    </message>
    <message>
        <source>No window fails %3 in %4, but %1 of %2 are borderline</source>
        <translation>Ninguna ventana incumple %3 en %4, pero %1 de %2 están en el límite</translation>
    </message>
    <message>
        <source>All of the %2 windows judged pass %3 in %4</source>
        <translation>Las %2 ventanas juzgadas cumplen %3 en %4</translation>
    </message>
    <message>
        <source>%3 judges none of the windows in %4</source>
        <translation>%3 no juzga ninguna de las ventanas en %4</translation>
    </message>
    <message>
        <source>Places that fail</source>
        <translation>Lugares que no cumplen</translation>
    </message>
    <message>
        <source>a limit of the rule is exceeded by more than the error of what was measured</source>
        <translation>se supera un límite de la norma en más que el error de lo medido</translation>
    </message>
    <message>
        <source>Borderline places</source>
        <translation>Lugares en el límite</translation>
    </message>
    <message>
        <source>within the error of a limit of the rule</source>
        <translation>dentro del error de un límite de la norma</translation>
    </message>
    <message>
        <source>Places that pass</source>
        <translation>Lugares que cumplen</translation>
    </message>
    <message>
        <source>they keep all limits of the rule</source>
        <translation>respetan todos los límites de la norma</translation>
    </message>
    <message>
        <source>Places without a limit</source>
        <translation>Lugares sin límite</translation>
    </message>
    <message>
        <source>the rule does not cover them, or states figures only</source>
        <translation>la norma no los abarca o solo indica cifras</translation>
    </message>
    <message>
        <source>Places not checked</source>
        <translation>Lugares no comprobados</translation>
    </message>
    <message>
        <source>nothing could be measured there</source>
        <translation>allí no se pudo medir nada</translation>
    </message>
    <message>
        <source>Windows that fail</source>
        <translation>Ventanas que no cumplen</translation>
    </message>
    <message>
        <source>in the scenario; rooms or dwellings where the rule judges those</source>
        <translation>en el escenario; habitaciones o viviendas donde la norma juzga esas</translation>
    </message>
    <message>
        <source>Borderline windows</source>
        <translation>Ventanas en el límite</translation>
    </message>
    <message>
        <source>Windows that pass</source>
        <translation>Ventanas que cumplen</translation>
    </message>
    <message>
        <source>Windows not judged</source>
        <translation>Ventanas no juzgadas</translation>
    </message>
    <message>
        <source>the rule does not apply to them, or they were not checked</source>
        <translation>la norma no se les aplica o no se comprobaron</translation>
    </message>
    <message>
        <source>Windows that failed before</source>
        <translation>Ventanas que antes no cumplían</translation>
    </message>
    <message>
        <source>in the baseline, of those that stand in both</source>
        <translation>en la referencia, de las que existen en ambos</translation>
    </message>
    <message>
        <source>Windows that get worse</source>
        <translation>Ventanas que empeoran</translation>
    </message>
    <message>
        <source>from pass to borderline or fail, or from borderline to fail</source>
        <translation>de cumple a en el límite o no cumple, o de en el límite a no cumple</translation>
    </message>
    <message>
        <source>Windows that get better</source>
        <translation>Ventanas que mejoran</translation>
    </message>
    <message>
        <source>from fail to borderline or pass, or from borderline to pass</source>
        <translation>de no cumple a en el límite o cumple, o de en el límite a cumple</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1 more places fail or are borderline.</source>
        <translation>Otros %1 lugares no cumplen o están en el límite.</translation>
    </message>
    <message>
        <source>%1 windows get worse than in %2, %3 get better.</source>
        <translation>%1 ventanas empeoran respecto a %2 y %3 mejoran.</translation>
    </message>
    <message>
        <source>Shade of trees</source>
        <translation>Sombra de los árboles</translation>
    </message>
    <message>
        <source>What is measured beside the shadow without trees, where the city has some: without, evergreen, seasonal or all (default)</source>
        <translation>Qué se mide además de la sombra sin árboles, si la ciudad los tiene: sin ellos, perennes, estacionales o todo (predeterminado)</translation>
    </message>
    <message>
        <source>After sunrise</source>
        <translation>Después del amanecer</translation>
    </message>
    <message>
        <source>Before sunset</source>
        <translation>Antes del ocaso</translation>
    </message>
    <message>
        <source>Sunrise at</source>
        <translation>Amanecer en</translation>
    </message>
    <message>
        <source>Which moment counts as sunrise and sunset: the altitude of the sun&apos;s centre</source>
        <translation>Qué momento cuenta como amanecer y ocaso: la altura del centro del sol</translation>
    </message>
    <message>
        <source>repaired</source>
        <translation>reparado</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>recortado</translation>
    </message>
    <message>
        <source>dropped</source>
        <translation>descartado</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>supuesta</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>medida</translation>
    </message>
    <message>
        <source>from storeys</source>
        <translation>según plantas</translation>
    </message>
    <message>
        <source>of a 3D model</source>
        <translation>de un modelo 3D</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>proyectada</translation>
    </message>
    <message>
        <source>made up</source>
        <translation>inventada</translation>
    </message>
    <message>
        <source>has no area, so it casts no shadow</source>
        <translation>no tiene área, así que no da sombra</translation>
    </message>
    <message>
        <source>faces without area were left out</source>
        <translation>se omitieron caras sin área</translation>
    </message>
    <message>
        <source>its surface is not closed; it is used unchanged</source>
        <translation>su superficie no está cerrada; se usa sin cambios</translation>
    </message>
    <message>
        <source>its faces pointed inward and were turned</source>
        <translation>sus caras miraban hacia dentro y se invirtieron</translation>
    </message>
    <message>
        <source>its outline could not be determined</source>
        <translation>no se pudo determinar su contorno</translation>
    </message>
    <message>
        <source>Choose the horizon sweep</source>
        <translation>Elija el barrido de horizontes</translation>
    </message>
    <message>
        <source>Choose projected shadows, or rays on terrain and roofs</source>
        <translation>Elija sombras proyectadas o, en terreno y cubiertas, rayos</translation>
    </message>
    <message>
        <source>Choose the horizon sweep or the ray reference</source>
        <translation>Elija el barrido de horizontes o la referencia por rayos</translation>
    </message>
    <message>
        <source>Choose a step of 3 seconds or more</source>
        <translation>Elija un paso de 3 segundos o más</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automático</translation>
    </message>
    <message>
        <source>none: the processor</source>
        <translation>ninguno: el procesador</translation>
    </message>
    <message>
        <source>the coordinates are read as longitude or easting first</source>
        <translation>las coordenadas se leen con la longitud o el este primero</translation>
    </message>
    <message>
        <source>far from the middle of the data</source>
        <translation>lejos del centro de los datos</translation>
    </message>
    <message>
        <source>one of several polygon layers; all are read as buildings</source>
        <translation>una de varias capas de polígonos; todas se leen como edificios</translation>
    </message>
    <message>
        <source>is not tagged as a building</source>
        <translation>no está etiquetado como edificio</translation>
    </message>
    <message>
        <source>lies underground</source>
        <translation>está bajo tierra</translation>
    </message>
    <message>
        <source>its roof is not flat; it is drawn flat at its full height</source>
        <translation>su cubierta no es plana; se dibuja plana a su altura total</translation>
    </message>
    <message>
        <source>its polygons overlapped or shared a wall and were joined</source>
        <translation>sus polígonos se solapaban o compartían un muro y se unieron</translation>
    </message>
    <message>
        <source>No file is named</source>
        <translation>No se indica ningún archivo</translation>
    </message>
    <message>
        <source>Name at least one file with buildings</source>
        <translation>Indique al menos un archivo con edificios</translation>
    </message>
    <message>
        <source>None of the files states its position on earth</source>
        <translation>Ninguno de los archivos indica su posición en la Tierra</translation>
    </message>
    <message>
        <source>there is no terrain: the ground between the buildings was interpolated from their bases</source>
        <translation>no hay terreno: el suelo entre los edificios se interpoló a partir de sus bases</translation>
    </message>
    <message>
        <source>buildings beyond the terrain stand on its nearest elevation</source>
        <translation>los edificios fuera del terreno se apoyan en su elevación más próxima</translation>
    </message>
    <message>
        <source>The file holds no polygon with an area</source>
        <translation>El archivo no contiene ningún polígono con área</translation>
    </message>
    <message>
        <source>Draw the region as a polygon</source>
        <translation>Dibuje la zona como polígono</translation>
    </message>
    <message>
        <source>It is not a polygon in well-known text</source>
        <translation>No es un polígono en well-known text</translation>
    </message>
    <message>
        <source>Give degrees, longitude first: POLYGON ((-73.98 40.76, -73.97 40.76, -73.97 40.77, -73.98 40.76))</source>
        <translation>Indique grados, la longitud primero: POLYGON ((-73.98 40.76, -73.97 40.76, -73.97 40.77, -73.98 40.76))</translation>
    </message>
    <message>
        <source>The polygon has no area</source>
        <translation>El polígono no tiene área</translation>
    </message>
    <message>
        <source>Give at least three corners</source>
        <translation>Indique al menos tres esquinas</translation>
    </message>
    <message>
        <source>There is no such file, and the text is neither four numbers nor a polygon</source>
        <translation>No existe ese archivo, y el texto no son cuatro números ni un polígono</translation>
    </message>
    <message>
        <source>Give west,south,east,north in degrees, for example -73.99,40.75,-73.98,40.76, a polygon as well-known text, or a polygon file</source>
        <translation>Indique oeste,sur,este,norte en grados, por ejemplo -73.99,40.75,-73.98,40.76, un polígono como well-known text o un archivo de polígonos</translation>
    </message>
    <message>
        <source>Names field</source>
        <translation>Campo de nombres</translation>
    </message>
    <message>
        <source>Field with the names of the buildings (default: found by its name)</source>
        <translation>Campo con los nombres de los edificios (por defecto: se reconoce por su nombre)</translation>
    </message>
    <message>
        <source>terrain far from the city was left out</source>
        <translation>se omitió el terreno lejos de la ciudad</translation>
    </message>
    <message>
        <source>cells without elevation were filled from the cells around</source>
        <translation>las celdas sin elevación se rellenaron a partir de las celdas de alrededor</translation>
    </message>
    <message>
        <source>a tree far from the buildings</source>
        <translation>un árbol lejos de los edificios</translation>
    </message>
    <message>
        <source>a second tree at the same place</source>
        <translation>un segundo árbol en el mismo sitio</translation>
    </message>
    <message>
        <source>Choose 0.25 to 10 m</source>
        <translation>Elija de 0,25 a 10 m</translation>
    </message>
    <message>
        <source>The region has no area</source>
        <translation>La zona no tiene área</translation>
    </message>
    <message>
        <source>Draw a polygon with an interior</source>
        <translation>Dibuje un polígono con interior</translation>
    </message>
    <message>
        <source>Choose larger cells or a smaller region; the limit is 2.1 billion cells</source>
        <translation>Elija celdas mayores o una zona menor; el límite es de 2100 millones de celdas</translation>
    </message>
    <message>
        <source>A corner is not on the globe</source>
        <translation>Una esquina no está en el globo terráqueo</translation>
    </message>
    <message>
        <source>Give degrees: west,south,east,north</source>
        <translation>Indique grados: oeste,sur,este,norte</translation>
    </message>
    <message>
        <source>The box is empty</source>
        <translation>El rectángulo está vacío</translation>
    </message>
    <message>
        <source>Give west &lt; east (or west &gt; east across the 180th meridian) and south &lt; north</source>
        <translation>Indique oeste &lt; este (u oeste &gt; este a través del meridiano 180) y sur &lt; norte</translation>
    </message>
    <message>
        <source>This is measured on the ground only, not on roofs</source>
        <translation>Esto se mide solo en el suelo, no en las cubiertas</translation>
    </message>
    <message>
        <source>Choose the ground, or run a study of the roofs</source>
        <translation>Elija el suelo o calcule un estudio de las cubiertas</translation>
    </message>
    <message>
        <source>On average over their area %1 a day, of %2 without any shadow.</source>
        <translation>De media sobre su área, %1 al día, de %2 sin ninguna sombra.</translation>
    </message>
    <message>
        <source>Choose larger cells, a smaller region or fewer steps</source>
        <translation>Elija celdas mayores, una zona menor o menos pasos</translation>
    </message>
    <message>
        <source>No cell of the region lies on a roof</source>
        <translation>Ninguna celda de la zona está en una cubierta</translation>
    </message>
    <message>
        <source>Choose a region with buildings, or smaller cells</source>
        <translation>Elija una zona con edificios o celdas menores</translation>
    </message>
    <message>
        <source>No cell of the region lies on open ground</source>
        <translation>Ninguna celda de la zona está en suelo libre</translation>
    </message>
    <message>
        <source>Choose a region outside buildings and water, or smaller cells</source>
        <translation>Elija una zona fuera de edificios y agua, o celdas menores</translation>
    </message>
    <message>
        <source>The start is not a date of the calendar</source>
        <translation>El inicio no es una fecha del calendario</translation>
    </message>
    <message>
        <source>Give a date such as 2026-03-21</source>
        <translation>Indique una fecha como 2026-03-21</translation>
    </message>
    <message>
        <source>Choose other dates; the position of the sun is known for these years only</source>
        <translation>Elija otras fechas; la posición del sol solo se conoce para estos años</translation>
    </message>
    <message>
        <source>The time of day at which the hours begin is out of range</source>
        <translation>La hora a la que empieza la franja está fuera del intervalo admitido</translation>
    </message>
    <message>
        <source>Give 00:00 to 24:00</source>
        <translation>Indique de 00:00 a 24:00</translation>
    </message>
    <message>
        <source>Give 0 (one instant), or 0.00028 to 24</source>
        <translation>Indique 0 (un instante) o de 0,00028 a 24</translation>
    </message>
    <message>
        <source>The hours after sunrise or before sunset are out of range</source>
        <translation>Las horas después del amanecer o antes del ocaso están fuera del intervalo admitido</translation>
    </message>
    <message>
        <source>Give at most 12 hours on either side</source>
        <translation>Indique como máximo 12 horas a cada lado</translation>
    </message>
    <message>
        <source>Choose a longer step or fewer days; the limit is 50 million steps</source>
        <translation>Elija un paso más largo o menos días; el límite es de 50 millones de pasos</translation>
    </message>
    <message>
        <source>The sun is below the horizon all the time</source>
        <translation>El sol está todo el tiempo bajo el horizonte</translation>
    </message>
    <message>
        <source>Choose other hours or days</source>
        <translation>Elija otras horas u otros días</translation>
    </message>
    <message>
        <source>%1 takes sun from %2, at most %3 a day at one spot</source>
        <translation>%1 quita sol a %2, como máximo %3 al día en un punto</translation>
    </message>
    <message>
        <source>%1 gives sun to %2, at most %3 a day at one spot</source>
        <translation>%1 da sol a %2, como máximo %3 al día en un punto</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Separación</translation>
    </message>
    <message>
        <source>Between the pieces of the lot of several towers</source>
        <translation>Entre las partes de la parcela de varias torres</translation>
    </message>
    <message>
        <source>Further towers</source>
        <translation>Otras torres</translation>
    </message>
    <message>
        <source>%1 everywhere</source>
        <translation>%1 en todas partes</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>%1 como máximo</translation>
    </message>
    <message>
        <source>On %1, %2 of %3 places have less than %4.</source>
        <translation>El %1 son %2 de %3 lugares los que tienen menos de %4.</translation>
    </message>
    <message>
        <source>%1 has the least sun, %2 a day, and %3 the most, %4.</source>
        <translation>El que menos sol tiene es %1, con %2 al día; el que más, %3, con %4.</translation>
    </message>
    <message>
        <source>%1: no open ground was measured</source>
        <translation>%1: no se midió suelo libre</translation>
    </message>
    <message>
        <source>%1: %2 of sun a day; %3 of its area has %4 or more</source>
        <translation>%1: %2 de sol al día; el %3 de su área tiene %4 o más</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>Especie</translation>
    </message>
    <message>
        <source>Latin name; its genus decides shape, density and leaves</source>
        <translation>Nombre latino; su género decide forma, densidad y hojas</translation>
    </message>
    <message>
        <source>Height above the ground, m</source>
        <translation>Altura sobre el suelo, m</translation>
    </message>
    <message>
        <source>estimated from crown or stem</source>
        <translation>estimada por la copa o el tronco</translation>
    </message>
    <message>
        <source>Crown diameter</source>
        <translation>Diámetro de copa</translation>
    </message>
    <message>
        <source>Diameter of the crown, m</source>
        <translation>Diámetro de la copa, m</translation>
    </message>
    <message>
        <source>estimated from stem or height</source>
        <translation>estimado por el tronco o la altura</translation>
    </message>
    <message>
        <source>Crown base</source>
        <translation>Base de la copa</translation>
    </message>
    <message>
        <source>Height of the crown&apos;s lower end above the ground, m</source>
        <translation>Altura del extremo inferior de la copa sobre el suelo, m</translation>
    </message>
    <message>
        <source>a share of the height</source>
        <translation>una parte de la altura</translation>
    </message>
    <message>
        <source>Stem diameter</source>
        <translation>Diámetro del tronco</translation>
    </message>
    <message>
        <source>Diameter of the stem at breast height, m</source>
        <translation>Diámetro del tronco a la altura del pecho, m</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>With trees as evergreens it is %1 a day.</source>
        <translation>Con los árboles como perennes es %1 al día.</translation>
    </message>
    <message>
        <source>With trees that lose their leaves by season it is %1 a day.</source>
        <translation>Con los árboles que pierden las hojas según la estación es %1 al día.</translation>
    </message>
    <message>
        <source>With trees as evergreens: %1; %2 of its area has %3 or more.</source>
        <translation>Con los árboles como perennes: %1; %2 de su superficie tiene %3 o más.</translation>
    </message>
    <message>
        <source>With trees that lose their leaves by season: %1; %2 of its area has %3 or more.</source>
        <translation>Con los árboles que pierden las hojas según la estación: %1; %2 de su superficie tiene %3 o más.</translation>
    </message>
    <message>
        <source>%1 of %2 places lie in shadow for more than %3 a day</source>
        <translation>%1 de %2 lugares están en sombra más de %3 al día</translation>
    </message>
    <message>
        <source>%1 has the most shadow, %2 a day, and %3 the least, %4.</source>
        <translation>%1 tiene la mayor sombra, %2 al día, y %3 la menor, %4.</translation>
    </message>
    <message>
        <source>On average over their area %1 of shadow a day, of %2 of daylight.</source>
        <translation>De media en su superficie, %1 de sombra al día, de %2 de luz diurna.</translation>
    </message>
    <message>
        <source>%1 adds more than a minute of shadow a day to %2 places, at most %3 at one spot.</source>
        <translation>%1 añade más de un minuto de sombra al día a %2 lugares, como máximo %3 en un punto.</translation>
    </message>
    <message>
        <source>Minutes of shadow a day by month</source>
        <translation>Minutos de sombra al día por mes</translation>
    </message>
    <message>
        <source>%1 reduces its shadow by %2 a day, at most %3 at one spot.</source>
        <translation>%1 le quita %2 de sombra al día, como máximo %3 en un punto.</translation>
    </message>
    <message>
        <source>%1 adds %2 of shadow a day to it, at most %3 at one spot.</source>
        <translation>%1 le añade %2 de sombra al día, como máximo %3 en un punto.</translation>
    </message>
    <message>
        <source>Thresholds of the change</source>
        <translation>Umbrales del cambio</translation>
    </message>
    <message>
        <source>Minutes of more or less shadow a day above which area counts; one or more</source>
        <translation>Minutos de más o menos sombra al día a partir de los cuales cuenta la superficie; uno o más</translation>
    </message>
    <message>
        <source>Each new building</source>
        <translation>Cada edificio nuevo</translation>
    </message>
    <message>
        <source>Also measure the sole contribution of each new building</source>
        <translation>Medir también la contribución exclusiva de cada edificio nuevo</translation>
    </message>
    <message>
        <source>Tolerance of buildings from a surface model</source>
        <translation>Tolerancia de los edificios de un modelo de superficie</translation>
    </message>
    <message>
        <source>How far buildings that are made of a surface model may lie above or below its cells, 0.05 to 5 m</source>
        <translation>Cuánto pueden quedar por encima o por debajo de sus celdas los edificios hechos de un modelo de superficie, de 0.05 a 5 m</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Extensión</translation>
    </message>
    <message>
        <source>Read only the buildings that touch this box, degrees; terrain is read whole</source>
        <translation>Lee solo los edificios que tocan este rectángulo, en grados; el terreno se lee entero</translation>
    </message>
    <message>
        <source>On %1, %2 of %3 places lie in shadow for more than %4.</source>
        <translation>El %1, %2 de %3 lugares están a la sombra más de %4.</translation>
    </message>
    <message>
        <source>Change of the minutes of shadow a day by month</source>
        <translation>Cambio de los minutos de sombra al día por mes</translation>
    </message>
    <message>
        <source>Minutes of shadow a day of the places that change most</source>
        <translation>Minutos de sombra al día de los lugares que más cambian</translation>
    </message>
    <message>
        <source>Change of the minutes of shadow a day of these places</source>
        <translation>Cambio de los minutos de sombra al día de estos lugares</translation>
    </message>
    <message>
        <source>%1: %2 of shadow a day; %3 of its area has %4 or less</source>
        <translation>%1: %2 de sombra al día; %3 de su superficie tiene %4 o menos</translation>
    </message>
    <message>
        <source>With trees as evergreens: %1; %2 of its area has %3 or less.</source>
        <translation>Con árboles perennes: %1; %2 de su superficie tiene %3 o menos.</translation>
    </message>
    <message>
        <source>With trees that lose their leaves by season: %1; %2 of its area has %3 or less.</source>
        <translation>Con árboles que pierden sus hojas según la estación: %1; %2 de su superficie tiene %3 o menos.</translation>
    </message>
    <message>
        <source>On %1 it lies in shadow for %2; %3 of its area for more than %4.</source>
        <translation>El %1 está a la sombra %2; %3 de su superficie, más de %4.</translation>
    </message>
    <message>
        <source>The measured hours begin this many hours after sunrise</source>
        <translation>Las horas medidas empiezan estas horas después de la salida del sol</translation>
    </message>
    <message>
        <source>The measured hours end this many hours before sunset</source>
        <translation>Las horas medidas acaban estas horas antes de la puesta del sol</translation>
    </message>
    <message>
        <source>minutes of shadow a day, mean over the days and the place</source>
        <translation>minutos de sombra al día, media de los días y del lugar</translation>
    </message>
    <message>
        <source>Max shadow</source>
        <translation>Sombra máx.</translation>
    </message>
    <message>
        <source>minutes of shadow a day, mean over the days, at the cell that has most</source>
        <translation>minutos de sombra al día, media de los días, en la celda que más tiene</translation>
    </message>
    <message>
        <source>Min shadow</source>
        <translation>Sombra mín.</translation>
    </message>
    <message>
        <source>minutes of shadow a day, mean over the days, at the cell that has least</source>
        <translation>minutos de sombra al día, media de los días, en la celda que menos tiene</translation>
    </message>
    <message>
        <source>a tree far from the buildings: its longitude and latitude are swapped</source>
        <translation>un árbol lejos de los edificios: su longitud y latitud están intercambiadas</translation>
    </message>
    <message>
        <source>Trees are not included.</source>
        <translation>Esto es sin árboles.</translation>
    </message>
    <message>
        <source>This is with trees as evergreens.</source>
        <translation>Esto es con los árboles como perennes.</translation>
    </message>
    <message>
        <source>This is with trees by their seasons.</source>
        <translation>Esto es con los árboles según sus estaciones.</translation>
    </message>
    <message>
        <source>Trees on maps</source>
        <translation>Árboles en los mapas</translation>
    </message>
    <message>
        <source>With trees as evergreens their number is %1, at most %2 at one spot.</source>
        <translation>Con los árboles como perennes son %1, como máximo %2 en un punto.</translation>
    </message>
    <message>
        <source>With trees that lose their leaves by season their number is %1, at most %2 at one spot.</source>
        <translation>Con árboles que pierden las hojas según la estación son %1, como máximo %2 en un punto.</translation>
    </message>
    <message>
        <source>Scale of diagrams</source>
        <translation>Escala de los diagramas</translation>
    </message>
    <message>
        <source>Scale of diagrams and elevations: 2000 for 1:2000 (default: a round one that fits)</source>
        <translation>Escala de diagramas y alzados: 2000 para 1:2000 (por defecto, una redonda que quepa)</translation>
    </message>
    <message>
        <source>Everything in full</source>
        <translation>Todo completo</translation>
    </message>
    <message>
        <source>Sheets: all tables, maps, elevations and timelines in full, on as many pages as that takes (default: at most 30 pages, with what changes most and what fails or is borderline)</source>
        <translation>Hojas: todas las tablas, mapas, alzados y cronologías completos, en tantas páginas como hagan falta (por defecto, como máximo 30 páginas, con lo que más cambia y lo que incumple o está al límite)</translation>
    </message>
    <message>
        <source>Map of sources of heights</source>
        <translation>Mapa de las fuentes de las alturas</translation>
    </message>
    <message>
        <source>Sheets: a page with the buildings coloured by where their heights come from: measured, from storeys, assumed, of a 3D model, designed</source>
        <translation>Hojas: una página con los edificios coloreados según la fuente de sus alturas: medidas, por plantas, supuestas, de un modelo 3D, proyectadas</translation>
    </message>
    <message>
        <source>Smallest place</source>
        <translation>Lugar más pequeño</translation>
    </message>
    <message>
        <source>Sheets of places: smaller places without a name are listed together, under the place that they lie in or by kind</source>
        <translation>Hojas de lugares: los lugares menores sin nombre se listan juntos, bajo el lugar en que están o por tipo</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Paper of the sheets: A4, A3, A1, Letter or Tabloid</source>
        <translation>Papel de las hojas: A4, A3, A1, Letter o Tabloid</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Horizontal</translation>
    </message>
    <message>
        <source>Sheets are wider than high</source>
        <translation>Las hojas son más anchas que altas</translation>
    </message>
    <message>
        <source>Hours of sun a day by month</source>
        <translation>Horas de sol al día por mes</translation>
    </message>
    <message>
        <source>Change of the hours of sun a day by month</source>
        <translation>Cambio de las horas de sol al día por mes</translation>
    </message>
    <message>
        <source>Hours of sun a day in the places by month</source>
        <translation>Horas de sol al día en los lugares por mes</translation>
    </message>
    <message>
        <source>Change of the hours of sun a day in the places by month</source>
        <translation>Cambio de las horas de sol al día en los lugares por mes</translation>
    </message>
    <message>
        <source>Change of the shadow area by month, m²</source>
        <translation>Cambio de la superficie en sombra por mes, m²</translation>
    </message>
    <message>
        <source>Change of the weighted shade by month, m² h</source>
        <translation>Cambio de la sombra ponderada por mes, m² h</translation>
    </message>
    <message>
        <source>Shadow score by month, m²</source>
        <translation>Puntuación de sombra por mes, m²</translation>
    </message>
    <message>
        <source>Change of the shadow score by month, m²</source>
        <translation>Cambio de la puntuación de sombra por mes, m²</translation>
    </message>
    <message>
        <source>duplicates</source>
        <translation>duplicados</translation>
    </message>
    <message>
        <source>Sun by place in %1</source>
        <translation>Sol por lugar en %1</translation>
    </message>
    <message>
        <source>Sun by place in %1 compared with %2</source>
        <translation>Sol por lugar en %1 comparado con %2</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 comparado con %2</translation>
    </message>
    <message>
        <source>Score of %1 with %2</source>
        <translation>Puntuación de %1 con %2</translation>
    </message>
    <message>
        <source>Study of %1</source>
        <translation>Estudio de %1</translation>
    </message>
    <message>
        <source>Points of %1</source>
        <translation>Puntos de %1</translation>
    </message>
    <message>
        <source>drawing diagrams</source>
        <translation>dibujando diagramas</translation>
    </message>
    <message>
        <source>drawing shadow fans</source>
        <translation>dibujando abanicos de sombra</translation>
    </message>
    <message>
        <source>drawing lines of equal hours</source>
        <translation>dibujando líneas de iguales horas</translation>
    </message>
    <message>
        <source>drawing views from the sun</source>
        <translation>dibujando vistas desde el sol</translation>
    </message>
    <message>
        <source>sweeping horizons</source>
        <translation>barriendo horizontes</translation>
    </message>
    <message>
        <source>sweeping horizons of points</source>
        <translation>barriendo horizontes de los puntos</translation>
    </message>
    <message>
        <source>tracing rays from points</source>
        <translation>trazando rayos desde los puntos</translation>
    </message>
    <message>
        <source>finding buildings in reach of the places</source>
        <translation>buscando edificios al alcance de los lugares</translation>
    </message>
    <message>
        <source>filling shadows</source>
        <translation>rellenando sombras</translation>
    </message>
    <message>
        <source>building the ray scene</source>
        <translation>preparando los rayos</translation>
    </message>
    <message>
        <source>tracing rays</source>
        <translation>trazando rayos</translation>
    </message>
    <message>
        <source>tracing rays through single trees</source>
        <translation>trazando rayos por árboles sueltos</translation>
    </message>
    <message>
        <source>unpacking the archive</source>
        <translation>descomprimiendo el archivo</translation>
    </message>
    <message>
        <source>making the buildings</source>
        <translation>creando los edificios</translation>
    </message>
    <message>
        <source>reading the features</source>
        <translation>leyendo los objetos</translation>
    </message>
    <message>
        <source>reading the city</source>
        <translation>leyendo la ciudad</translation>
    </message>
    <message>
        <source>reading the map</source>
        <translation>leyendo el mapa</translation>
    </message>
    <message>
        <source>reading windows</source>
        <translation>leyendo ventanas</translation>
    </message>
    <message>
        <source>repairing outlines</source>
        <translation>reparando contornos</translation>
    </message>
    <message>
        <source>making buildings</source>
        <translation>creando edificios</translation>
    </message>
    <message>
        <source>they stand where the file states</source>
        <translation>están donde indica el archivo</translation>
    </message>
    <message>
        <source>all were shifted onto it</source>
        <translation>todos se desplazaron sobre él</translation>
    </message>
    <message>
        <source>each building was set down on it</source>
        <translation>cada edificio se asentó sobre él</translation>
    </message>
    <message>
        <source>bases of %1 lie %2 m below the terrain (median of %3, spread %4 m)</source>
        <translation>las bases de %1 están %2 m bajo el terreno (mediana de %3, dispersión %4 m)</translation>
    </message>
    <message>
        <source>bases of %1 lie %2 m above the terrain (median of %3, spread %4 m)</source>
        <translation>las bases de %1 están %2 m sobre el terreno (mediana de %3, dispersión %4 m)</translation>
    </message>
    <message>
        <source>%1 far from that gap were set down by themselves</source>
        <translation>%1 con otra diferencia se asentaron por separado</translation>
    </message>
    <message>
        <source>%1 stay above the ground</source>
        <translation>%1 quedan sobre el suelo</translation>
    </message>
    <message>
        <source>finding the buildings</source>
        <translation>buscando los edificios</translation>
    </message>
    <message>
        <source>reading the mesh</source>
        <translation>leyendo la malla</translation>
    </message>
    <message>
        <source>making buildings of the surface model</source>
        <translation>creando edificios del modelo de superficie</translation>
    </message>
    <message>
        <source>reading canopy</source>
        <translation>leyendo el dosel</translation>
    </message>
    <message>
        <source>reading trees</source>
        <translation>leyendo árboles</translation>
    </message>
    <message>
        <source>joining shadows</source>
        <translation>uniendo sombras</translation>
    </message>
    <message>
        <source>evaluating windows</source>
        <translation>evaluando ventanas</translation>
    </message>
    <message>
        <source>%1 of %2 heights are assumed (%3 m)</source>
        <translation>%1 de %2 alturas son supuestas (%3 m)</translation>
    </message>
    <message>
        <source>%1 of %2 heights are assumed (most of them %3 m)</source>
        <translation>%1 de %2 alturas son supuestas (la mayoría, %3 m)</translation>
    </message>
    <message>
        <source>Fields that could hold heights or storeys: %1</source>
        <translation>Campos que podrían contener alturas o plantas: %1</translation>
    </message>
    <message>
        <source>In doubt: %1</source>
        <translation>Dudoso: %1</translation>
    </message>
    <message>
        <source>%1, %2 km from %3, %4</source>
        <translation>%1, a %2 km de %3, %4</translation>
    </message>
    <message>
        <source>no buildings</source>
        <translation>sin edificios</translation>
    </message>
    <message>
        <source>buildings: %1, parts: %2, up to %3 m high</source>
        <translation>edificios: %1, partes: %2, hasta %3 m de altura</translation>
    </message>
    <message>
        <source>on a terrain</source>
        <translation>sobre un terreno</translation>
    </message>
    <message>
        <source>on flat ground</source>
        <translation>sobre suelo plano</translation>
    </message>
    <message>
        <source>summing up places</source>
        <translation>resumiendo lugares</translation>
    </message>
    <message>
        <source>joining the timelines</source>
        <translation>uniendo las cronologías</translation>
    </message>
    <message>
        <source>surveying the buildings</source>
        <translation>midiendo los edificios</translation>
    </message>
    <message>
        <source>writing the map</source>
        <translation>escribiendo el mapa</translation>
    </message>
    <message>
        <source>building gone</source>
        <translation>edificio eliminado</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Hojas</translation>
    </message>
    <message>
        <source>Whether it keeps its leaves (default: as its genus)</source>
        <translation>Si conserva las hojas (por defecto: como su género)</translation>
    </message>
    <message>
        <source>as its genus</source>
        <translation>como su género</translation>
    </message>
    <message>
        <source>First day in leaf</source>
        <translation>Primer día con hojas</translation>
    </message>
    <message>
        <source>First day in leaf of a tree that loses its leaves (default: as the city&apos;s trees)</source>
        <translation>Primer día con hojas de un árbol que las pierde (por defecto: como los árboles de la ciudad)</translation>
    </message>
    <message>
        <source>MM-DD; as the city&apos;s trees</source>
        <translation>MM-DD; como los árboles de la ciudad</translation>
    </message>
    <message>
        <source>First day without leaves</source>
        <translation>Primer día sin hojas</translation>
    </message>
    <message>
        <source>First day without leaves of a tree that loses them (default: as the city&apos;s trees)</source>
        <translation>Primer día sin hojas de un árbol que las pierde (por defecto: como los árboles de la ciudad)</translation>
    </message>
    <message>
        <source>Which shadow maps and sheets show where trees reach; files of values hold all that were measured</source>
        <translation>Qué sombra muestran los mapas y las hojas donde alcanzan los árboles; los archivos de valores contienen todas las medidas</translation>
    </message>
    <message>
        <source>the days</source>
        <translation>los días</translation>
    </message>
    <message>
        <source>the hours</source>
        <translation>las horas</translation>
    </message>
    <message>
        <source>the clock</source>
        <translation>la hora oficial</translation>
    </message>
    <message>
        <source>the day %1</source>
        <translation>el día %1</translation>
    </message>
    <message>
        <source>the limit of &quot;%1&quot;</source>
        <translation>el límite de «%1»</translation>
    </message>
    <message>
        <source>the share of &quot;%1&quot;</source>
        <translation>la proporción de «%1»</translation>
    </message>
    <message>
        <source>the hours of sunshine</source>
        <translation>las horas de sol</translation>
    </message>
    <message>
        <source>What %1 builds stands outside the region: the figures are of the shadow that reaches into it.</source>
        <translation>Lo que construye %1 está fuera de la zona: las cifras son de la sombra que llega a ella.</translation>
    </message>
    <message>
        <source>A part of what %1 builds stands outside the region: the figures are of the shadow in it.</source>
        <translation>Una parte de lo que construye %1 está fuera de la zona: las cifras son de la sombra dentro de ella.</translation>
    </message>
    <message>
        <source>The change by more than %1 a day reaches the region&apos;s edge: beyond it is not measured.</source>
        <translation>El cambio de más de %1 al día llega al borde de la zona: más allá no se mide.</translation>
    </message>
    <message>
        <source>the coordinates are taken in the other order than that of their reference system, in which the buildings are mirror images</source>
        <translation>las coordenadas se toman en el orden contrario al de su sistema de referencia, en el que los edificios son imágenes especulares</translation>
    </message>
    <message>
        <source>Estimated or assumed of %1 trees: height of %2, crown of %3</source>
        <translation>Estimado o supuesto en %1 árboles: altura de %2, copa de %3</translation>
    </message>
    <message>
        <source>%1: %2 compared with %3</source>
        <translation>%1: %2 comparado con %3</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>The proposal&apos;s shadow reaches no place in the rule&apos;s hours</source>
        <translation>La sombra de la propuesta no alcanza ningún lugar en las horas de la norma</translation>
    </message>
    <message>
        <source>Review all places to have that stated for each</source>
        <translation>Aplique la norma a todos los lugares para que se indique en cada uno</translation>
    </message>
    <message>
        <source>The sides of the lot would cross or touch each other</source>
        <translation>Los lados de la parcela se cruzarían o se tocarían</translation>
    </message>
    <message>
        <source>Move the corner or side less far</source>
        <translation>Mueva menos la esquina o el lado</translation>
    </message>
    <message>
        <source>The sides beside it meet before that</source>
        <translation>Los lados contiguos se encuentran antes</translation>
    </message>
    <message>
        <source>Move the side less far</source>
        <translation>Mueva menos el lado</translation>
    </message>
    <message>
        <source>A lot needs three corners or more</source>
        <translation>Una parcela necesita tres esquinas o más</translation>
    </message>
    <message>
        <source>Move the corner instead</source>
        <translation>Mueva la esquina en su lugar</translation>
    </message>
    <message>
        <source>hot all year</source>
        <translation>calor todo el año</translation>
    </message>
    <message>
        <source>hot months</source>
        <translation>meses de calor</translation>
    </message>
    <message>
        <source>before the hot months</source>
        <translation>antes de los meses de calor</translation>
    </message>
    <message>
        <source>after the hot months</source>
        <translation>después de los meses de calor</translation>
    </message>
    <message>
        <source>winter</source>
        <translation>invierno</translation>
    </message>
    <message>
        <source>early spring</source>
        <translation>inicio de la primavera</translation>
    </message>
    <message>
        <source>hot month</source>
        <translation>mes de calor</translation>
    </message>
    <message>
        <source>growing season</source>
        <translation>época de crecimiento</translation>
    </message>
    <message>
        <source>pedestrian comfort</source>
        <translation>confort de los peatones</translation>
    </message>
    <message>
        <source>plants</source>
        <translation>plantas</translation>
    </message>
    <message>
        <source>default</source>
        <translation>predeterminado</translation>
    </message>
    <message>
        <source>Any country</source>
        <translation>Cualquier país</translation>
    </message>
    <message>
        <source>Source of height</source>
        <translation>Origen de la altura</translation>
    </message>
    <message>
        <source>of the highest part of each building; counts are of the whole city</source>
        <translation>de la parte más alta de cada edificio; los recuentos son de toda la ciudad</translation>
    </message>
    <message>
        <source>Where the heights come from</source>
        <translation>De dónde vienen las alturas</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Magnitud</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Definitions</source>
        <translation>Definiciones</translation>
    </message>
    <message>
        <source>Method and sources</source>
        <translation>Método y fuentes</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Cifras</translation>
    </message>
    <message>
        <source>Scenarios side by side</source>
        <translation>Escenarios lado a lado</translation>
    </message>
    <message>
        <source>%1 on one scale.</source>
        <translation>%1 en una misma escala.</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Edificio</translation>
    </message>
    <message>
        <source>The first %1 of %2.</source>
        <translation>Los primeros %1 de %2.</translation>
    </message>
    <message>
        <source> min a day</source>
        <translation> min al día</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>Contribuciones</translation>
    </message>
    <message>
        <source>Sole contribution of each new building: against the scenario without it</source>
        <translation>Contribución exclusiva de cada edificio nuevo: respecto al escenario sin él</translation>
    </message>
    <message>
        <source>Months</source>
        <translation>Meses</translation>
    </message>
    <message>
        <source> by month</source>
        <translation> por mes</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesos</translation>
    </message>
    <message>
        <source>shadow of the proposal alone</source>
        <translation>sombra de la propuesta sola</translation>
    </message>
    <message>
        <source>hours of shadow</source>
        <translation>horas de sombra</translation>
    </message>
    <message>
        <source>limit of the rule</source>
        <translation>límite de la norma</translation>
    </message>
    <message>
        <source>distance from the parcel</source>
        <translation>distancia a la parcela</translation>
    </message>
    <message>
        <source>existing shadow</source>
        <translation>sombra existente</translation>
    </message>
    <message>
        <source>incremental shadow</source>
        <translation>sombra añadida</translation>
    </message>
    <message>
        <source>sun gained</source>
        <translation>sol ganado</translation>
    </message>
    <message>
        <source>proposal</source>
        <translation>propuesta</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>eliminado</translation>
    </message>
    <message>
        <source>building</source>
        <translation>edificio</translation>
    </message>
    <message>
        <source>open below</source>
        <translation>abierto por debajo</translation>
    </message>
    <message>
        <source>place</source>
        <translation>lugar</translation>
    </message>
    <message>
        <source>Heights in %1 above the ground.</source>
        <translation>Alturas en %1 sobre el suelo.</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source> Numbers in a white field name the places above.</source>
        <translation> Los números en un campo blanco designan los lugares de arriba.</translation>
    </message>
    <message>
        <source> White lines: streets of the project.</source>
        <translation> Líneas blancas: calles del proyecto.</translation>
    </message>
    <message>
        <source> Pale colours: streets, water and parks of the map.</source>
        <translation> Colores pálidos: calles, agua y parques del mapa.</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>en %1</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>no cumple</translation>
    </message>
    <message>
        <source>verdict gets worse</source>
        <translation>el veredicto empeora</translation>
    </message>
    <message>
        <source>verdict gets better</source>
        <translation>el veredicto mejora</translation>
    </message>
    <message>
        <source>north</source>
        <translation>norte</translation>
    </message>
    <message>
        <source>north-east</source>
        <translation>noreste</translation>
    </message>
    <message>
        <source>east</source>
        <translation>este</translation>
    </message>
    <message>
        <source>south-east</source>
        <translation>sureste</translation>
    </message>
    <message>
        <source>south</source>
        <translation>sur</translation>
    </message>
    <message>
        <source>south-west</source>
        <translation>suroeste</translation>
    </message>
    <message>
        <source>west</source>
        <translation>oeste</translation>
    </message>
    <message>
        <source>north-west</source>
        <translation>noroeste</translation>
    </message>
    <message>
        <source>Floors of %1 m</source>
        <translation>Plantas de %1 m</translation>
    </message>
    <message>
        <source>, of designed towers as designed</source>
        <translation>, en las torres diseñadas como se diseñaron</translation>
    </message>
    <message>
        <source>continued</source>
        <translation>continuación</translation>
    </message>
    <message>
        <source>Language of sheets</source>
        <translation>Idioma de las hojas</translation>
    </message>
    <message>
        <source>Language of the texts, numbers and dates of sheets: en, de, es or ja (default: that of the window, English on the command line). Files for programs are the same in every language</source>
        <translation>Idioma de los textos, números y fechas de las hojas: en, de, es o ja (por defecto: el de la ventana; inglés en la línea de órdenes). Los archivos para programas son iguales en todos los idiomas</translation>
    </message>
    <message>
        <source>Timelines of places</source>
        <translation>Cronologías de los lugares</translation>
    </message>
    <message>
        <source>Shadows are on a horizontal plane %1 m above the mean ground. </source>
        <translation>Las sombras están en un plano horizontal a %1 m sobre el suelo medio. </translation>
    </message>
    <message>
        <source>place: </source>
        <translation>lugar: </translation>
    </message>
    <message>
        <source> or </source>
        <translation> o </translation>
    </message>
    <message>
        <source>Times: %1.</source>
        <translation>Horas: %1.</translation>
    </message>
    <message>
        <source> Edges of shadows follow cells of %1 m, because the ground is not level.</source>
        <translation> Los bordes de las sombras siguen celdas de %1 m, porque el suelo no es llano.</translation>
    </message>
    <message>
        <source>%1 compared with %2. %3North is up.</source>
        <translation>%1 comparado con %2. %3El norte está arriba.</translation>
    </message>
    <message>
        <source>Shadow diagrams</source>
        <translation>Diagramas de sombras</translation>
    </message>
    <message>
        <source>Shadow fans</source>
        <translation>Abanicos de sombra</translation>
    </message>
    <message>
        <source>All shadows of a day that the proposal would cast if it stood alone, %1. %2North is up.</source>
        <translation>Todas las sombras de un día que daría la propuesta si estuviera sola, %1. %2El norte está arriba.</translation>
    </message>
    <message>
        <source>, %1 to %2</source>
        <translation>, %1 a %2</translation>
    </message>
    <message>
        <source>1:%1. Existing buildings do not hide these shadows</source>
        <translation>1:%1. Los edificios existentes no ocultan estas sombras</translation>
    </message>
    <message>
        <source>Lines of equal hours of shadow</source>
        <translation>Líneas de igual duración de sombra</translation>
    </message>
    <message>
        <source>%1. Thick: limits of the rule. Dashed: distances from the parcel. North is up.</source>
        <translation>%1. Grueso: límites de la norma. Discontinuo: distancias a la parcela. El norte está arriba.</translation>
    </message>
    <message>
        <source>Views from the sun</source>
        <translation>Vistas desde el sol</translation>
    </message>
    <message>
        <source>%1, without perspective, as the sun sees it: what is visible is sunlit, what is hidden is in shadow. The proposal is violet, places are green.</source>
        <translation>%1, sin perspectiva, como lo ve el sol: lo visible está al sol, lo oculto en sombra. La propuesta es violeta, los lugares verdes.</translation>
    </message>
    <message>
        <source>%1 pass, %2 borderline, %3 fail, %4 not applicable</source>
        <translation>%1 cumplen, %2 en el límite, %3 no cumplen, %4 no aplicables</translation>
    </message>
    <message>
        <source>%1 before: %2.</source>
        <translation>%1 antes: %2.</translation>
    </message>
    <message>
        <source>%1 after: %2.</source>
        <translation>%1 después: %2.</translation>
    </message>
    <message>
        <source>%1 whose verdict gets worse: %2; better: %3.</source>
        <translation>%1 cuyo veredicto empeora: %2; mejora: %3.</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>Resumen</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Ventanas</translation>
    </message>
    <message>
        <source>Buildings</source>
        <translation>Edificios</translation>
    </message>
    <message>
        <source>Proposal: %1. Baseline: %2.</source>
        <translation>Propuesta: %1. Referencia: %2.</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>No comprobado</translation>
    </message>
    <message>
        <source>Fail before</source>
        <translation>No cumplen antes</translation>
    </message>
    <message>
        <source>Fail after</source>
        <translation>No cumplen después</translation>
    </message>
    <message>
        <source>Worse</source>
        <translation>Peor</translation>
    </message>
    <message>
        <source>Verdict before</source>
        <translation>Veredicto antes</translation>
    </message>
    <message>
        <source>Verdict after</source>
        <translation>Veredicto después</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Planta</translation>
    </message>
    <message>
        <source>Faces, deg</source>
        <translation>Orientación, grados</translation>
    </message>
    <message>
        <source>%1, before</source>
        <translation>%1, antes</translation>
    </message>
    <message>
        <source>%1, after</source>
        <translation>%1, después</translation>
    </message>
    <message>
        <source>Sun before</source>
        <translation>Sol antes</translation>
    </message>
    <message>
        <source>Sun after</source>
        <translation>Sol después</translation>
    </message>
    <message>
        <source>%1, clock: %2. Minutes, or percent where stated</source>
        <translation>%1, hora: %2. Minutos, o porcentaje donde se indica</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Engine: %1. Clock: %2, year %3; %4 steps of %5 min with the sun in the rule&apos;s hours.</source>
        <translation>Motor: %1. Hora: %2, año %3; %4 pasos de %5 min con el sol en las horas de la norma.</translation>
    </message>
    <message>
        <source>Each run of minutes is uncertain by a step, a sky component by %1 %. A value within its error of a limit is borderline, never pass.</source>
        <translation>Cada duración es incierta en un paso; una componente del cielo, en un %1 %. Un valor que dista de un límite menos que su error está en el límite, nunca cumple.</translation>
    </message>
    <message>
        <source>The rule, as it was read</source>
        <translation>La norma, tal como se leyó</translation>
    </message>
    <message>
        <source>Review of windows: </source>
        <translation>Revisión de ventanas: </translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tablas</translation>
    </message>
    <message>
        <source>Windows at no building</source>
        <translation>Ventanas en ningún edificio</translation>
    </message>
    <message>
        <source>The building is new or changed</source>
        <translation>El edificio es nuevo o ha cambiado</translation>
    </message>
    <message>
        <source>No former values</source>
        <translation>Sin valores anteriores</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>, scale locked</source>
        <translation>, escala fija</translation>
    </message>
    <message>
        <source>Elevations: </source>
        <translation>Alzados: </translation>
    </message>
    <message>
        <source>%1 and %2. %3. Colours beyond the ends of a scale are those of its ends.</source>
        <translation>%1 y %2. %3. Los colores más allá de los extremos de una escala son los de sus extremos.</translation>
    </message>
    <message>
        <source>Grey: no value. Seen square to the wall, from outside.</source>
        <translation>Gris: sin valor. Visto perpendicularmente a la pared, desde fuera.</translation>
    </message>
    <message>
        <source>Sun: azimuth %1°, altitude %2°</source>
        <translation>Sol: acimut %1°, altura %2°</translation>
    </message>
    <message>
        <source>Without perspective, as the sun sees it: what is visible is sunlit, what is hidden is in shadow. New and changed buildings are violet. Clock: %1.</source>
        <translation>Sin perspectiva, como lo ve el sol: lo visible está al sol, lo oculto en sombra. Los edificios nuevos y modificados son violetas. Hora: %1.</translation>
    </message>
    <message>
        <source>on a plane %1 m above the mean ground</source>
        <translation>en un plano a %1 m sobre el suelo medio</translation>
    </message>
    <message>
        <source>on the ground</source>
        <translation>en el suelo</translation>
    </message>
    <message>
        <source>Hours of shadow in the rule&apos;s hours, %1, on cells of %2 m</source>
        <translation>Horas de sombra en las horas de la norma, %1, en celdas de %2 m</translation>
    </message>
    <message>
        <source>Shadow review: </source>
        <translation>Revisión de sombras: </translation>
    </message>
    <message>
        <source>Engine: %1. Receivers: centres of the square cells of %2 m that the places touch, each weighed by its share of the place, not under a building of baseline or proposal.</source>
        <translation>Motor: %1. Receptores: centros de las celdas cuadradas de %2 m que tocan los lugares, cada una ponderada por su parte del lugar, no bajo un edificio de la referencia o de la propuesta.</translation>
    </message>
    <message>
        <source>Time: %1, %2 of %3 min with the sun in the rule&apos;s hours. Clock: %4.</source>
        <translation>Tiempo: %1, %2 de %3 min con el sol en las horas de la norma. Hora: %4.</translation>
    </message>
    <message>
        <source>Sun: ERFA, topocentric, seen from %1; apparent altitude, with refraction.</source>
        <translation>Sol: ERFA, topocéntrico, visto desde %1; altura aparente, con refracción.</translation>
    </message>
    <message>
        <source>Frame: metres to the east and true north of %1 (WGS84).</source>
        <translation>Sistema: metros hacia el este y el norte verdadero desde %1 (WGS84).</translation>
    </message>
    <message>
        <source>Incremental shadow lies on what is sunlit in the baseline; sun gained is the reverse.</source>
        <translation>La sombra añadida cae sobre lo que tiene sol en la referencia; el sol ganado es lo contrario.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>The outlines in diagrams are exact unions of projected buildings where the ground is level; the figures come from the cells.</source>
        <translation>Los contornos de los diagramas son uniones exactas de edificios proyectados donde el suelo es llano; los valores salen de las celdas.</translation>
    </message>
    <message>
        <source>Not modelled</source>
        <translation>No modelado</translation>
    </message>
    <message>
        <source>Small structures and penumbra; the sun is a point at the centre of its disc.</source>
        <translation>Estructuras pequeñas y penumbra; el sol es un punto en el centro de su disco.</translation>
    </message>
    <message>
        <source>. Diagrams show the shadows of buildings and terrain.</source>
        <translation>. Los diagramas muestran las sombras de edificios y terreno.</translation>
    </message>
    <message>
        <source> without a name</source>
        <translation> sin nombre</translation>
    </message>
    <message>
        <source>   ... further numbers: see the summary</source>
        <translation>   ... más números: véase el resumen</translation>
    </message>
    <message>
        <source>Of %1 places %2 are listed one by one; the numbers are those of the diagrams. Places of less than %3 without a name are listed together. Timelines are of places that fail or are borderline. review.csv has all places; the option --all-pages prints them.</source>
        <translation>De %1 lugares se listan %2 uno por uno; los números son los de los diagramas. Los lugares de menos de %3 sin nombre se listan juntos. Las cronologías son de lugares que no cumplen o están en el límite. review.csv tiene todos los lugares; la opción --all-pages los imprime.</translation>
    </message>
    <message>
        <source>Clock: %1, year %2. Engine: %3, every %4 min, cells of %5 m. %6.</source>
        <translation>Hora: %1, año %2. Motor: %3, cada %4 min, celdas de %5 m. %6.</translation>
    </message>
    <message>
        <source>Figures only: the sun is not up at the rule&apos;s times, so no diagram is drawn.</source>
        <translation>Solo valores: el sol no está sobre el horizonte a las horas de la norma, así que no se dibuja ningún diagrama.</translation>
    </message>
    <message>
        <source>Places without new shadow</source>
        <translation>Lugares sin sombra nueva</translation>
    </message>
    <message>
        <source>%1 further places with names</source>
        <translation>%1 lugares más con nombre</translation>
    </message>
    <message>
        <source>%1 without a name</source>
        <translation>%1 sin nombre</translation>
    </message>
    <message>
        <source>Nothing is stated as unchecked.</source>
        <translation>No consta nada sin comprobar.</translation>
    </message>
    <message>
        <source>Sums over the days of the rule</source>
        <translation>Sumas de los días de la norma</translation>
    </message>
    <message>
        <source>%1: existing shadow %2 of the theoretical sun; incremental %3; most on %4.</source>
        <translation>%1: sombra existente %2 del sol teórico; añadida %3; máxima el %4.</translation>
    </message>
    <message>
        <source>no day</source>
        <translation>ningún día</translation>
    </message>
    <message>
        <source>the most incremental shadow on %1 (%2) at one moment</source>
        <translation>la mayor sombra añadida sobre %1 (%2) en un momento</translation>
    </message>
    <message>
        <source>Numbers in a white field: places of the table.</source>
        <translation>Números en un campo blanco: lugares de la tabla.</translation>
    </message>
    <message>
        <source>Verdicts</source>
        <translation>Dictámenes</translation>
    </message>
    <message>
        <source>Verdicts, continued</source>
        <translation>Veredictos, continuación</translation>
    </message>
    <message>
        <source>Rule used in: %1. Site: %2.</source>
        <translation>Regla usada en: %1. Lugar: %2.</translation>
    </message>
    <message>
        <source>. %1 days without incremental shadow are in review.csv only</source>
        <translation>. %1 días sin sombra añadida están solo en review.csv</translation>
    </message>
    <message>
        <source>. Of each month the day of most incremental shadow; %1 further days are in review.csv, and here with the option --all-pages</source>
        <translation>. De cada mes el día de mayor sombra adicional; %1 días más están en review.csv, y aquí con la opción --all-pages</translation>
    </message>
    <message>
        <source>%1 of %2 places; review.csv has all</source>
        <translation>%1 de %2 lugares; review.csv los tiene todos</translation>
    </message>
    <message>
        <source>Table of the rule</source>
        <translation>Tabla de la norma</translation>
    </message>
    <message>
        <source>%1, clock: %2%3</source>
        <translation>%1, hora: %2%3</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Criterio</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Medido</translation>
    </message>
    <message>
        <source>Former</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Límite</translation>
    </message>
    <message>
        <source>Deciding day</source>
        <translation>Día decisivo</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source> (does not decide)</source>
        <translation> (no decide)</translation>
    </message>
    <message>
        <source>Former: the same in the baseline, where a limit compares with it</source>
        <translation>Anterior: lo mismo en la referencia, donde un límite se compara con ello</translation>
    </message>
    <message>
        <source>Criteria: the figures behind the verdicts</source>
        <translation>Criterios: los valores tras los veredictos</translation>
    </message>
    <message>
        <source>Theoretical sun</source>
        <translation>Sol teórico</translation>
    </message>
    <message>
        <source>Existing shadow</source>
        <translation>Sombra existente</translation>
    </message>
    <message>
        <source>share</source>
        <translation>parte</translation>
    </message>
    <message>
        <source>With proposal</source>
        <translation>Con propuesta</translation>
    </message>
    <message>
        <source>Days with incremental shadow</source>
        <translation>Días con sombra añadida</translation>
    </message>
    <message>
        <source>Day of most</source>
        <translation>Día de la máxima</translation>
    </message>
    <message>
        <source>Duration on it</source>
        <translation>Duración en él</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Sums</source>
        <translation>Sumas</translation>
    </message>
    <message>
        <source>Over the days of the rule; shares of the theoretical sun</source>
        <translation>De los días de la norma; partes del sol teórico</translation>
    </message>
    <message>
        <source>Days with shadow</source>
        <translation>Días con sombra</translation>
    </message>
    <message>
        <source>Enters at the earliest</source>
        <translation>Entra lo más pronto</translation>
    </message>
    <message>
        <source>Exits at the latest</source>
        <translation>Sale lo más tarde</translation>
    </message>
    <message>
        <source>Longest on a day</source>
        <translation>Máximo en un día</translation>
    </message>
    <message>
        <source>Largest area</source>
        <translation>Área máxima</translation>
    </message>
    <message>
        <source>Incremental shadow by season</source>
        <translation>Sombra añadida por estación</translation>
    </message>
    <message>
        <source>Seasons without incremental shadow are left out. Clock: %1</source>
        <translation>Se omiten las estaciones sin sombra añadida. Hora: %1</translation>
    </message>
    <message>
        <source>New building</source>
        <translation>Edificio nuevo</translation>
    </message>
    <message>
        <source>share of the theoretical sun</source>
        <translation>parte del sol teórico</translation>
    </message>
    <message>
        <source>of the proposal&apos;s shadow</source>
        <translation>de la sombra de la propuesta</translation>
    </message>
    <message>
        <source>Sole contributions of the new buildings</source>
        <translation>Contribuciones exclusivas de los edificios nuevos</translation>
    </message>
    <message>
        <source>What each casts where the baseline and all others of the proposal leave the sun, over the days of the rule; shadow that two of them share is in neither row</source>
        <translation>Lo que cada uno proyecta donde la referencia y los demás de la propuesta dejan el sol, en los días de la norma; la sombra que dos comparten no está en ninguna fila</translation>
    </message>
    <message>
        <source>Points at no building</source>
        <translation>Puntos en ningún edificio</translation>
    </message>
    <message>
        <source>Elevations</source>
        <translation>Alzados</translation>
    </message>
    <message>
        <source>, mean over the days</source>
        <translation>, media de los días</translation>
    </message>
    <message>
        <source>Seen square to the wall, from outside.</source>
        <translation>Visto perpendicularmente a la pared, desde fuera.</translation>
    </message>
    <message>
        <source>Points on %1. %2.</source>
        <translation>Puntos en %1. %2.</translation>
    </message>
    <message>
        <source>Rays at every step of the sun.</source>
        <translation>Rayos en cada posición del sol.</translation>
    </message>
    <message>
        <source>Horizons of the points, in bins of a quarter of a degree.</source>
        <translation>Horizontes de los puntos, en intervalos de un cuarto de grado.</translation>
    </message>
    <message>
        <source>Chosen since %1.</source>
        <translation>Elegido porque %1.</translation>
    </message>
    <message>
        <source>Error against rays: %1.</source>
        <translation>Error frente a los rayos: %1.</translation>
    </message>
    <message>
        <source>Hours of sun on %1</source>
        <translation>Horas de sol en %1</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Fuentes</translation>
    </message>
    <message>
        <source>building %1</source>
        <translation>edificio %1</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Terreno</translation>
    </message>
    <message>
        <source>Contributions of buildings</source>
        <translation>Contribuciones de los edificios</translation>
    </message>
    <message>
        <source>%1 and the buildings that make most of the shadow</source>
        <translation>%1 y los edificios que dan más sombra</translation>
    </message>
    <message>
        <source>Numbers as in the table; buildings outside of the map are not shown</source>
        <translation>Números como en la tabla; los edificios fuera del mapa no se muestran</translation>
    </message>
    <message>
        <source>Largest contributions</source>
        <translation>Mayores contribuciones</translation>
    </message>
    <message>
        <source>Area x hours in shadow, by building</source>
        <translation>Área x horas en sombra, por edificio</translation>
    </message>
    <message>
        <source>Numbers as in the table</source>
        <translation>Números como en la tabla</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>Share of all shadow</source>
        <translation>Parte de toda la sombra</translation>
    </message>
    <message>
        <source>Other buildings: %1</source>
        <translation>Otros edificios: %1</translation>
    </message>
    <message>
        <source>All shadow</source>
        <translation>Toda la sombra</translation>
    </message>
    <message>
        <source>Attributed: %1. Sole: %2. Area x hours over the whole period. Engine: %3. Rows below 0.1 % are added up; contributions.csv lists each.</source>
        <translation>Atribuida: %1. Exclusiva: %2. Área x horas de todo el periodo. Motor: %3. Las filas por debajo del 0,1 % están sumadas; contributions.csv las lista todas.</translation>
    </message>
    <message>
        <source>By building</source>
        <translation>Por edificio</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Árbol</translation>
    </message>
    <message>
        <source>Contributions of trees</source>
        <translation>Contribuciones de los árboles</translation>
    </message>
    <message>
        <source>What trees take of the sun that buildings leave, %1. The first %2 of %3; tree_contributions.csv lists each.</source>
        <translation>Lo que los árboles toman del sol que dejan los edificios, %1. Los primeros %2 de %3; tree_contributions.csv los lista todos.</translation>
    </message>
    <message>
        <source>By tree</source>
        <translation>Por árbol</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Conclusión</translation>
    </message>
    <message>
        <source>How this was made</source>
        <translation>Cómo se obtuvo</translation>
    </message>
    <message>
        <source>Cells of %1 m; places with fewer than %2 of them have cells of %3 m. Cells on the edge of a place count with the share of them that lies in it.</source>
        <translation>Celdas de %1 m; los lugares con menos de %2 tienen celdas de %3 m. Las celdas del borde de un lugar cuentan con la parte que queda dentro.</translation>
    </message>
    <message>
        <source>Without any shadow there would be %1 h of sun a day.</source>
        <translation>Sin ninguna sombra habría %1 h de sol al día.</translation>
    </message>
    <message>
        <source>Also measured with %1.</source>
        <translation>Medido también con %1.</translation>
    </message>
    <message>
        <source>Trees: %1.</source>
        <translation>Árboles: %1.</translation>
    </message>
    <message>
        <source>Error of cells: %1. The error of each figure is in the table at the end.</source>
        <translation>Error de las celdas: %1. El error de cada magnitud está en la tabla del final.</translation>
    </message>
    <message>
        <source>The baseline is %1. Ground that is built on in any scenario counts in none.</source>
        <translation>La referencia es %1. El suelo que se edifica en algún escenario no cuenta en ninguno.</translation>
    </message>
    <message>
        <source>minutes of shadow</source>
        <translation>minutos de sombra</translation>
    </message>
    <message>
        <source>hours of sun</source>
        <translation>horas de sol</translation>
    </message>
    <message>
        <source>Shadow by place</source>
        <translation>Sombra por lugar</translation>
    </message>
    <message>
        <source> a day</source>
        <translation> al día</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 el %2</translation>
    </message>
    <message>
        <source>Change of sun by place: </source>
        <translation>Cambio del sol por lugar: </translation>
    </message>
    <message>
        <source>minutes of sun a day</source>
        <translation>minutos de sol al día</translation>
    </message>
    <message>
        <source> on this day</source>
        <translation> en este día</translation>
    </message>
    <message>
        <source>mean %1 a day</source>
        <translation>media de %1 al día</translation>
    </message>
    <message>
        <source>   Further places: table, %1 and on.</source>
        <translation>   Más lugares: tabla, desde %1.</translation>
    </message>
    <message>
        <source>Places by their %1</source>
        <translation>Lugares según %1</translation>
    </message>
    <message>
        <source>Numbers as in the key and the table; a number that would cover another one is left out. Outlines without colour: places without figures.</source>
        <translation>Números como en la clave y la tabla; se omite el número que taparía otro. Contornos sin color: lugares sin valores.</translation>
    </message>
    <message>
        <source>Minutes of shadow by place</source>
        <translation>Minutos de sombra por lugar</translation>
    </message>
    <message>
        <source>Hours of sun by place</source>
        <translation>Horas de sol por lugar</translation>
    </message>
    <message>
        <source>Change of sun by place</source>
        <translation>Cambio del sol por lugar</translation>
    </message>
    <message>
        <source>change of mean sun a day against %1, minutes</source>
        <translation>cambio del sol medio al día respecto a %1, minutos</translation>
    </message>
    <message>
        <source>, min</source>
        <translation>, min</translation>
    </message>
    <message>
        <source>%1, %2, min</source>
        <translation>%1, %2, min</translation>
    </message>
    <message>
        <source>Change of mean shadow, min</source>
        <translation>Cambio de la sombra media, min</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Below, %1</source>
        <translation>Por debajo, %1</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Observaciones</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Lugares</translation>
    </message>
    <message>
        <source>with least sun</source>
        <translation>con menos sol</translation>
    </message>
    <message>
        <source>that lose most to the first scenario</source>
        <translation>que más pierden con el primer escenario</translation>
    </message>
    <message>
        <source>All %1, those %2 first.</source>
        <translation>Los %1, primero los %2.</translation>
    </message>
    <message>
        <source>The %1 of %2 %3; all of them are in places.csv.</source>
        <translation>Los %1 de %2 %3; todos están en places.csv.</translation>
    </message>
    <message>
        <source> The figures are those of %1; changes are from %2.</source>
        <translation> Los valores son los de %1; los cambios, respecto a %2.</translation>
    </message>
    <message>
        <source>Errors against the ray reference, on a sample</source>
        <translation>Errores frente a la referencia de rayos, en una muestra</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>99 of 100 within</source>
        <translation>99 de 100 dentro de</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Not measured.</source>
        <translation>No medido.</translation>
    </message>
    <message>
        <source>No month has a day that counts</source>
        <translation>Ningún mes tiene un día que cuente</translation>
    </message>
    <message>
        <source>100 % of the place</source>
        <translation>100 % del lugar</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>no contada</translation>
    </message>
    <message>
        <source>The sun is not up in the hours of the rule</source>
        <translation>El sol no está sobre el horizonte en las horas de la norma</translation>
    </message>
    <message>
        <source>%1   not counted</source>
        <translation>%1   no contado</translation>
    </message>
    <message>
        <source>the scenario&apos;s shadow</source>
        <translation>la sombra del escenario</translation>
    </message>
    <message>
        <source>the baseline&apos;s shadow</source>
        <translation>la sombra de la referencia</translation>
    </message>
    <message>
        <source>%1   %2 % of the place in %3</source>
        <translation>%1   %2 % del lugar en %3</translation>
    </message>
    <message>
        <source>sq ft</source>
        <translation>ft²</translation>
    </message>
    <message>
        <source>Sun gained</source>
        <translation>Sol ganado</translation>
    </message>
    <message>
        <source>The sun is not up in the rule&apos;s hours, or the place has no open ground</source>
        <translation>El sol no está sobre el horizonte en las horas de la norma, o el lugar no tiene suelo libre</translation>
    </message>
    <message>
        <source>%1   incremental %2; scenario %3; baseline %4</source>
        <translation>%1   añadida %2; escenario %3; referencia %4</translation>
    </message>
    <message>
        <source>; sun gained %1</source>
        <translation>; sol ganado %1</translation>
    </message>
    <message>
        <source>Incremental shadow on the edge of the place alone, beside all centres of cells</source>
        <translation>Sombra añadida solo en el borde del lugar, fuera de todos los centros de celda</translation>
    </message>
    <message>
        <source>No incremental shadow in the rule&apos;s hours</source>
        <translation>Sin sombra añadida en las horas de la norma</translation>
    </message>
    <message>
        <source> (up to %1 min too late)</source>
        <translation> (hasta %1 min demasiado tarde)</translation>
    </message>
    <message>
        <source>Incremental shadow from %1 to %2%6; at most %3, %4 % of the place, at %5</source>
        <translation>Sombra añadida de %1 a %2%6; como máximo %3, %4 % del lugar, a las %5</translation>
    </message>
    <message>
        <source>less shadow</source>
        <translation>menos sombra</translation>
    </message>
    <message>
        <source>in the sun</source>
        <translation>al sol</translation>
    </message>
    <message>
        <source>more shadow</source>
        <translation>más sombra</translation>
    </message>
    <message>
        <source>in shadow</source>
        <translation>en sombra</translation>
    </message>
    <message>
        <source>violet: proposed</source>
        <translation>violeta: propuesta</translation>
    </message>
    <message>
        <source>orange: only in the baseline</source>
        <translation>naranja: solo en la referencia</translation>
    </message>
    <message>
        <source>orange: demolished</source>
        <translation>naranja: derribado</translation>
    </message>
    <message>
        <source>dashed: open below</source>
        <translation>discontinuo: abierto por debajo</translation>
    </message>
    <message>
        <source>dark line: region</source>
        <translation>línea oscura: zona</translation>
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
        <translation>Cambios</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Escenarios</translation>
    </message>
    <message>
        <source>%1 Change: from %2, on the receivers of both. Engine: %3.</source>
        <translation>%1 Cambio: desde %2, en los receptores de ambos. Motor: %3.</translation>
    </message>
    <message>
        <source>The same study of each scenario</source>
        <translation>El mismo estudio de cada escenario</translation>
    </message>
    <message>
        <source>%1 high</source>
        <translation>de %1 de altura</translation>
    </message>
    <message>
        <source>floor area %1</source>
        <translation>superficie construida %1</translation>
    </message>
    <message>
        <source>no new building with known floors</source>
        <translation>ningún edificio nuevo con plantas conocidas</translation>
    </message>
    <message>
        <source>, on one scale</source>
        <translation>, en una misma escala</translation>
    </message>
    <message>
        <source>The first %1 of %2 scenarios; scenario_months.csv has all</source>
        <translation>Los primeros %1 de %2 escenarios; scenario_months.csv los tiene todos</translation>
    </message>
    <message>
        <source>%1: %2. Buildings and ground: SHA-256 %3.</source>
        <translation>%1: %2. Edificios y suelo: SHA-256 %3.</translation>
    </message>
    <message>
        <source>no changes</source>
        <translation>sin cambios</translation>
    </message>
    <message>
        <source>Colours: %1 in %2; continuous shadow in %3.</source>
        <translation>Colores: %1 en %2; sombra continua en %3.</translation>
    </message>
    <message>
        <source>sun</source>
        <translation>sol</translation>
    </message>
    <message>
        <source>gross shadow</source>
        <translation>sombra total</translation>
    </message>
    <message>
        <source>Change: minutes in %1 minus minutes in %2, with the same engine, steps and cells; positive means more %3. %4</source>
        <translation>Cambio: minutos en %1 menos minutos en %2, con el mismo motor, pasos y celdas; positivo significa más %3. %4</translation>
    </message>
    <message>
        <source>shadow</source>
        <translation>sombra</translation>
    </message>
    <message>
        <source>%1: %2 with more than %3 min a day of additional gross shadow</source>
        <translation>%1: %2 con más de %3 min al día de sombra total adicional</translation>
    </message>
    <message>
        <source>This is the error of the change, compared with the change by the ray reference.</source>
        <translation>Este es el error del cambio, comparado con el cambio según la referencia de rayos.</translation>
    </message>
    <message>
        <source>%1, %2 m high</source>
        <translation>%1, %2 m de alto</translation>
    </message>
    <message>
        <source>Further new buildings</source>
        <translation>Otros edificios nuevos</translation>
    </message>
    <message>
        <source>sun above the horizon for %1 min a day</source>
        <translation>sol sobre el horizonte %1 min al día</translation>
    </message>
    <message>
        <source> Positive means that wanted shade outweighs unwanted shadow. The figures of the months add up to the total.</source>
        <translation> Positivo significa que la sombra deseada supera a la no deseada. Los valores de los meses suman el total.</translation>
    </message>
    <message>
        <source>Engine: %1.</source>
        <translation>Motor: %1.</translation>
    </message>
    <message>
        <source>Receivers: centres of square cells of %1 m on %2, inside the region.</source>
        <translation>Receptores: centros de celdas cuadradas de %1 m en %2, dentro de la zona.</translation>
    </message>
    <message>
        <source>Weights: %1</source>
        <translation>Pesos: %1</translation>
    </message>
    <message>
        <source>Shadow score of %1</source>
        <translation>Puntuación de sombra de %1</translation>
    </message>
    <message>
        <source> At each step a ray is traced from each receiver to the centre of the sun; the receiver is in shadow if a building or the terrain blocks the ray.</source>
        <translation> En cada paso se traza un rayo de cada receptor al centro del sol; el receptor está en sombra si un edificio o el terreno lo interrumpe.</translation>
    </message>
    <message>
        <source>the terrain</source>
        <translation>el terreno</translation>
    </message>
    <message>
        <source>flat ground</source>
        <translation>suelo llano</translation>
    </message>
    <message>
        <source>Receivers: centres of square cells of %1 m on %2, inside the region and not under a building.</source>
        <translation>Receptores: centros de celdas cuadradas de %1 m en %2, dentro de la zona y no bajo un edificio.</translation>
    </message>
    <message>
        <source>Terrain: %1.</source>
        <translation>Terreno: %1.</translation>
    </message>
    <message>
        <source>; a single day is up to %1 min too long or too short</source>
        <translation>; un solo día es hasta %1 min demasiado largo o corto</translation>
    </message>
    <message>
        <source> The requested step was %1 min; its length was adjusted so that whole steps fill the hours of each day and the period has the exact number of minutes%2.</source>
        <translation> El paso pedido era de %1 min; se ajustó para que pasos enteros llenen las horas de cada día y el periodo tenga el número exacto de minutos%2.</translation>
    </message>
    <message>
        <source>Time: %1 steps of %2 min used; %3 left out because the sun was below the horizon (night is not shadow). Shares of time refer to the time with the sun above the horizon.%4</source>
        <translation>Tiempo: %1 pasos de %2 min usados; %3 omitidos porque el sol estaba bajo el horizonte (la noche no es sombra). Las partes del tiempo se refieren al tiempo con el sol sobre el horizonte.%4</translation>
    </message>
    <message>
        <source>geometric altitude, without refraction</source>
        <translation>altura geométrica, sin refracción</translation>
    </message>
    <message>
        <source>apparent altitude, with refraction at %1 hPa and %2 °C</source>
        <translation>altura aparente, con refracción a %1 hPa y %2 °C</translation>
    </message>
    <message>
        <source> At %1 steps the sun is just above the horizon but below the plane of the geometry; they are computed with the sun in that plane.</source>
        <translation> En %1 pasos el sol está justo sobre el horizonte, pero bajo el plano de la geometría; se calculan con el sol en ese plano.</translation>
    </message>
    <message>
        <source> In the frame of the geometry true north is rotated by %1° there and the vertical by %2°; at the farthest corner of the region the vertical differs by up to %3° (%4 s of the sun&apos;s motion).%5</source>
        <translation> En el sistema de la geometría el norte verdadero está girado allí %1° y la vertical %2°; en la esquina más lejana de la zona la vertical difiere hasta %3° (%4 s del movimiento del sol).%5</translation>
    </message>
    <message>
        <source>Sun: ERFA, topocentric, seen from the centre of the region (%1, %2 m); %3. Civil time of %4 from the tz database.%5</source>
        <translation>Sol: ERFA, topocéntrico, visto desde el centro de la zona (%1, %2 m); %3. Hora civil de %4 según la base de datos tz.%5</translation>
    </message>
    <message>
        <source>Frame: metres to the east and true north of %1 (WGS84), the CRS of shadow.tif: %2</source>
        <translation>Sistema: metros hacia el este y el norte verdadero desde %1 (WGS84), el CRS de shadow.tif: %2</translation>
    </message>
    <message>
        <source>%1 % in the mean, %2 % at the 99th percentile, %3 % (%4 min) at the worst receiver (%5)</source>
        <translation>%1 % de media, %2 % en el percentil 99, %3 % (%4 min) en el peor receptor (%5)</translation>
    </message>
    <message>
        <source>; continuous shadow by %1, of the longest day</source>
        <translation>; sombra continua en %1, del día más largo</translation>
    </message>
    <message>
        <source>Measured on %1 of the %2 receivers, spread over the region and traced again by the ray reference over the same %3 steps: shadow area off by %4 % of the ground (standard error %5); gross shadow by %6, of the sunlit time%7.</source>
        <translation>Medido en %1 de los %2 receptores, repartidos por la zona y trazados de nuevo con la referencia de rayos en los mismos %3 pasos: el área de sombra difiere un %4 % del suelo (error estándar %5); la sombra total en %6, del tiempo con sol%7.</translation>
    </message>
    <message>
        <source>All other engines are measured against the ray reference: for the city as modelled, one exact test decides each receiver and step. Changes between sun and shadow are resolved to one step (%1 min), edges of shadows to one cell (%2 m).</source>
        <translation>Los demás motores se miden frente a la referencia de rayos: para la ciudad modelada, una prueba exacta decide cada receptor y paso. Los cambios entre sol y sombra se resuelven a un paso (%1 min) y los bordes de las sombras a una celda (%2 m).</translation>
    </message>
    <message>
        <source>Limits of the model: roofs are flat unless the data contains their shape; %1; the sun is a point, whereas its real disc of 0.53° blurs a shadow&apos;s edge by about 1 m per 100 m of distance from the occluder. An error in height moves the end of a shadow by error / tan(altitude of the sun): see the sources of the heights.</source>
        <translation>Límites del modelo: las cubiertas son planas salvo que los datos contengan su forma; %1; el sol es un punto, mientras que su disco real de 0,53° difumina el borde de la sombra cerca de 1 m por cada 100 m de distancia al obstáculo. Un error de altura desplaza el extremo de la sombra en error / tan(altura del sol): véase el origen de las alturas.</translation>
    </message>
    <message>
        <source>trees count only in figures that name them, street furniture in none</source>
        <translation>los árboles cuentan solo en los valores que los nombran, el mobiliario urbano en ninguno</translation>
    </message>
    <message>
        <source>trees and street furniture are not included</source>
        <translation>no se incluyen árboles ni mobiliario urbano</translation>
    </message>
    <message>
        <source> Shares: of the receivers&apos; area and of the sunlit time.</source>
        <translation> Partes: del área de los receptores y del tiempo con sol.</translation>
    </message>
    <message>
        <source>Continuous shadow was not counted.</source>
        <translation>La sombra continua no se contó.</translation>
    </message>
    <message>
        <source>Error against the ray reference, on a sample</source>
        <translation>Error frente a la referencia de rayos, en una muestra</translation>
    </message>
    <message>
        <source>, scenario </source>
        <translation>, escenario </translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Datos de entrada</translation>
    </message>
    <message>
        <source>and %1 more: see the JSON file</source>
        <translation>y %1 más: véase el archivo JSON</translation>
    </message>
    <message>
        <source>No file: the city was not read from a file.</source>
        <translation>Ningún archivo: la ciudad no se leyó de un archivo.</translation>
    </message>
    <message>
        <source>%1: %2, the city without edits.</source>
        <translation>%1: %2, la ciudad sin cambios.</translation>
    </message>
    <message>
        <source>The project has not been saved yet.</source>
        <translation>El proyecto aún no se ha guardado.</translation>
    </message>
    <message>
        <source>%1, which does not contain the latest changes.</source>
        <translation>%1, que no contiene los últimos cambios.</translation>
    </message>
    <message>
        <source>%1, SHA-256 of the file:</source>
        <translation>%1, SHA-256 del archivo:</translation>
    </message>
    <message>
        <source>Project and scenario</source>
        <translation>Proyecto y escenario</translation>
    </message>
    <message>
        <source>SHA-256 of the content behind the result (defined in the JSON file):</source>
        <translation>SHA-256 del contenido en que se basa el resultado (definido en el archivo JSON):</translation>
    </message>
    <message>
        <source>an unknown number of m</source>
        <translation>un número desconocido de m</translation>
    </message>
    <message>
        <source>from levels × %1</source>
        <translation>de plantas × %1</translation>
    </message>
    <message>
        <source>missing in the data and replaced by a default (%1 for a whole building)</source>
        <translation>faltan en los datos y se sustituyen por un valor por defecto (%1 para un edificio entero)</translation>
    </message>
    <message>
        <source>from three-dimensional data</source>
        <translation>de datos tridimensionales</translation>
    </message>
    <message>
        <source>designed: given by the scenario</source>
        <translation>diseñadas: dadas por el escenario</translation>
    </message>
    <message>
        <source>made up: a sample of no real place</source>
        <translation>inventadas: una muestra de ningún lugar real</translation>
    </message>
    <message>
        <source>%1 in %2. Heights of the parts: %3.</source>
        <translation>%1 en %2. Alturas de las partes: %3.</translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation>De %1.</translation>
    </message>
    <message>
        <source>Features of the files are not parts: an outline that has parts of its own makes none, a feature of several outlines several.</source>
        <translation>Los elementos de los archivos no son partes: un contorno que tiene partes propias no da ninguna; un elemento de varios contornos, varias.</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>None: every feature was used unchanged.</source>
        <translation>Ninguno: todos los elementos se usaron sin cambios.</translation>
    </message>
    <message>
        <source>%1 in total, of %2 kinds; the JSON file beside this report lists each one with its feature.</source>
        <translation>%1 en total, de %2 tipos; el archivo JSON junto a este informe los lista con su elemento.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>%1 of %2 buildings used</source>
        <translation>%1 de %2 edificios usados</translation>
    </message>
    <message>
        <source>, %1 rays</source>
        <translation>, %1 rayos</translation>
    </message>
    <message>
        <source>. Skipped: </source>
        <translation>. Omitido: </translation>
    </message>
    <message>
        <source>Computation</source>
        <translation>Cálculo</translation>
    </message>
    <message>
        <source>How to repeat this result</source>
        <translation>Cómo repetir este resultado</translation>
    </message>
    <message>
        <source>%1 lies beside this report.</source>
        <translation>%1 está junto a este informe.</translation>
    </message>
    <message>
        <source>Shadow study</source>
        <translation>Estudio de sombras</translation>
    </message>
    <message>
        <source>at an unknown time</source>
        <translation>en un momento desconocido</translation>
    </message>
    <message>
        <source>on </source>
        <translation>el </translation>
    </message>
    <message>
        <source>A result saved in the project</source>
        <translation>Un resultado guardado en el proyecto</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, saved %2 by %3. Maps and figures are those that were saved.</source>
        <translation>«%1», guardado %2 por %3. Los mapas y valores son los que se guardaron.</translation>
    </message>
    <message>
        <source>Its inputs have not changed since.</source>
        <translation>Sus datos no han cambiado desde entonces.</translation>
    </message>
    <message>
        <source>The buildings drawn are those of the scenario as it is now.</source>
        <translation>Los edificios dibujados son los del escenario actual.</translation>
    </message>
    <message>
        <source>Square cells of %1 m; those that were not measured are white on the map.</source>
        <translation>Celdas cuadradas de %1 m; las no medidas son blancas en el mapa.</translation>
    </message>
    <message>
        <source>Error: %1.</source>
        <translation>Error: %1.</translation>
    </message>
    <message>
        <source>Weight table: %1.</source>
        <translation>Tabla de pesos: %1.</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>y %1 más</translation>
    </message>
    <message>
        <source>Shadow study of %1</source>
        <translation>Estudio de sombras de %1</translation>
    </message>
    <message>
        <source>Change: minutes in %1 minus minutes in %2; positive means more %3. %4</source>
        <translation>Cambio: minutos en %1 menos minutos en %2; positivo significa más %3. %4</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>W</source>
        <translation>O</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>%1 m east-west by %2 m north-south around %3 (WGS84)</source>
        <translation>%1 m de este a oeste por %2 m de norte a sur alrededor de %3 (WGS84)</translation>
    </message>
    <message>
        <source>Data: </source>
        <translation>Datos: </translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Tamaño de celda</translation>
    </message>
    <message>
        <source>Steps of the sun</source>
        <translation>Posiciones del sol</translation>
    </message>
    <message>
        <source> + %1 min</source>
        <translation> + %1 min</translation>
    </message>
    <message>
        <source> - %1 min</source>
        <translation> - %1 min</translation>
    </message>
    <message>
        <source>sunrise</source>
        <translation>salida del sol</translation>
    </message>
    <message>
        <source> to </source>
        <translation> a </translation>
    </message>
    <message>
        <source>sunset</source>
        <translation>puesta del sol</translation>
    </message>
    <message>
        <source>%1 for %2 h</source>
        <translation>%1 durante %2 h</translation>
    </message>
    <message>
        <source>no date</source>
        <translation>sin fecha</translation>
    </message>
    <message>
        <source>%1 to %2 (%3)</source>
        <translation>%1 a %2 (%3)</translation>
    </message>
    <message>
        <source>at </source>
        <translation>a las </translation>
    </message>
    <message>
        <source>, every %1 min</source>
        <translation>, cada %1 min</translation>
    </message>
    <message>
        <source>... the rest is in the JSON file</source>
        <translation>... el resto está en el archivo JSON</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>no comprobado</translation>
    </message>
    <message>
        <source>December to February</source>
        <translation>diciembre a febrero</translation>
    </message>
    <message>
        <source>March to May</source>
        <translation>marzo a mayo</translation>
    </message>
    <message>
        <source>June to August</source>
        <translation>junio a agosto</translation>
    </message>
    <message>
        <source>September to November</source>
        <translation>septiembre a noviembre</translation>
    </message>
    <message>
        <source>every</source>
        <translation>todos</translation>
    </message>
    <message>
        <source>average</source>
        <translation>media</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>elegido</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>suma</translation>
    </message>
    <message>
        <source>civil</source>
        <translation>hora civil</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>hora estándar</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fija</translation>
    </message>
    <message>
        <source>true solar</source>
        <translation>hora solar verdadera</translation>
    </message>
    <message>
        <source>upper limb</source>
        <translation>borde superior</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>centro</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>suelo</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>plano</translation>
    </message>
    <message>
        <source>windows</source>
        <translation>ventanas</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>todo</translation>
    </message>
    <message>
        <source>existing</source>
        <translation>existente</translation>
    </message>
    <message>
        <source>no action</source>
        <translation>sin actuación</translation>
    </message>
    <message>
        <source>reference body</source>
        <translation>cuerpo de referencia</translation>
    </message>
    <message>
        <source>mid pane</source>
        <translation>centro del vidrio</translation>
    </message>
    <message>
        <source>sill middle</source>
        <translation>centro del alféizar</translation>
    </message>
    <message>
        <source>sill ends</source>
        <translation>extremos del alféizar</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>exterior</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>interior</translation>
    </message>
    <message>
        <source>window</source>
        <translation>ventana</translation>
    </message>
    <message>
        <source>room</source>
        <translation>habitación</translation>
    </message>
    <message>
        <source>dwelling</source>
        <translation>vivienda</translation>
    </message>
    <message>
        <source>% of the sky&apos;s light</source>
        <translation>% de la luz del cielo</translation>
    </message>
    <message>
        <source>% of the year&apos;s probable sun</source>
        <translation>% del sol probable del año</translation>
    </message>
    <message>
        <source>rays</source>
        <translation>rayos</translation>
    </message>
    <message>
        <source>horizons with ends by rays</source>
        <translation>horizontes con los extremos por rayos</translation>
    </message>
    <message>
        <source>The windows of %1 more buildings are in windows.csv</source>
        <translation>Las ventanas de otros edificios están en windows.csv: %1 edificios</translation>
    </message>
    <message>
        <source>; %1 more windows are in windows.csv</source>
        <translation>; más ventanas en windows.csv: %1</translation>
    </message>
    <message>
        <source>Projected shadows: each building&apos;s shadow filled as polygons at every step, exact on flat ground</source>
        <translation>Sombras proyectadas: la sombra de cada edificio rellenada como polígonos en cada paso, exacta en terreno llano</translation>
    </message>
    <message>
        <source>cells under buildings</source>
        <translation>celdas bajo edificios</translation>
    </message>
    <message>
        <source>cells outside the region</source>
        <translation>celdas fuera de la zona</translation>
    </message>
    <message>
        <source>cells on water</source>
        <translation>celdas sobre agua</translation>
    </message>
    <message>
        <source>steps with the sun below the horizon</source>
        <translation>pasos con el sol bajo el horizonte</translation>
    </message>
    <message>
        <source>shadows that meet no receiver (casters x steps x bands of rows)</source>
        <translation>sombras que no tocan ningún receptor (emisores x pasos x bandas de filas)</translation>
    </message>
    <message>
        <source>prisms and solids whose shadow cannot reach a tile (each x azimuth bins)</source>
        <translation>prismas y sólidos cuya sombra no puede alcanzar una tesela (cada uno x clases de azimut)</translation>
    </message>
    <message>
        <source>buildings whose shadow cannot reach a receiver</source>
        <translation>edificios cuya sombra no puede alcanzar ningún receptor</translation>
    </message>
    <message>
        <source>Projected shadows: exact on flat ground, one run for all months and intervals</source>
        <translation>Sombras proyectadas: exactas en terreno llano, una pasada para todos los meses e intervalos</translation>
    </message>
    <message>
        <source>%1 takes more than a minute of sun a day from one place, at most %2 at one spot.</source>
        <translation>%1 quita más de un minuto de sol al día a un lugar, como máximo %2 en un punto.</translation>
    </message>
    <message>
        <source>%1 adds more than a minute of shadow a day to one place, at most %2 at one spot.</source>
        <translation>%1 añade más de un minuto de sombra al día a un lugar, como máximo %2 en un punto.</translation>
    </message>
    <message>
        <source>greenstreet</source>
        <translation>césped o parterre</translation>
    </message>
    <message>
        <source>other</source>
        <translation>otro lugar</translation>
    </message>
</context>
<context>
    <name>noonmark::AccuracyForm</name>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>method</source>
        <translation>método</translation>
    </message>
    <message>
        <source>How the shadow is computed; the ray reference is the standard for the errors of the others</source>
        <translation>Cómo se calcula la sombra; la referencia por rayos mide los errores de los demás</translation>
    </message>
</context>
<context>
    <name>noonmark::AccuracySection</name>
    <message>
        <source>As in the paper</source>
        <translation>Como en el artículo</translation>
    </message>
    <message>
        <source>Exploration by shadow accrual maps, analysis by inverse accrual maps through the direction graph,
as published. Approximate: the legend states the measured error</source>
        <translation>Exploración con mapas de acumulación de sombra, análisis con mapas inversos mediante el grafo de direcciones,
como se publicó. Aproximado: la leyenda indica el error medido</translation>
    </message>
    <message>
        <source>Method and options</source>
        <translation>Método y opciones</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Tamaño de celda</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Precisión</translation>
    </message>
    <message>
        <source>cell size</source>
        <translation>tamaño de celda</translation>
    </message>
    <message>
        <source>accuracy</source>
        <translation>precisión</translation>
    </message>
    <message>
        <source>Side of a cell on the ground. Half the size: four times the cells</source>
        <translation>Lado de una celda sobre el suelo. La mitad del tamaño: cuatro veces más celdas</translation>
    </message>
</context>
<context>
    <name>noonmark::BookView</name>
    <message>
        <source>Previous page</source>
        <translation>Página anterior</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Página siguiente</translation>
    </message>
    <message>
        <source>Goes to a chapter; the PDF has them as bookmarks</source>
        <translation>Va a un capítulo; en el PDF son marcadores</translation>
    </message>
    <message>
        <source>How large the page is shown</source>
        <translation>Tamaño con que se muestra la página</translation>
    </message>
    <message>
        <source>Whole page</source>
        <translation>Página entera</translation>
    </message>
    <message>
        <source>Page width</source>
        <translation>Ancho de página</translation>
    </message>
    <message>
        <source>%1 dots per inch</source>
        <translation>%1 puntos por pulgada</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>de %1</translation>
    </message>
    <message>
        <source>Painting the page</source>
        <translation>Dibujando la página</translation>
    </message>
    <message>
        <source>Sheets that are to be written are shown here</source>
        <translation>Aquí se muestran las hojas que se van a escribir</translation>
    </message>
</context>
<context>
    <name>noonmark::Breakdown</name>
    <message>
        <source>sweeping horizons</source>
        <translation>barriendo horizontes</translation>
    </message>
</context>
<context>
    <name>noonmark::BreakdownForm</name>
    <message>
        <source>Each month by itself</source>
        <translation>Cada mes por separado</translation>
    </message>
    <message>
        <source>Also sums the shadow of each month: bars in the panel Contributions, a table and maps in exports</source>
        <translation>Suma también la sombra de cada mes: barras en el panel Contribuciones, una tabla y mapas al exportar</translation>
    </message>
    <message>
        <source>Contribution of each building</source>
        <translation>Contribución de cada edificio</translation>
    </message>
    <message>
        <source>Attributed shadow</source>
        <translation>Sombra atribuida</translation>
    </message>
    <message>
        <source>Sole contribution</source>
        <translation>Contribución exclusiva</translation>
    </message>
    <message>
        <source>months</source>
        <translation>meses</translation>
    </message>
    <message>
        <source>contributions</source>
        <translation>contribuciones</translation>
    </message>
    <message>
        <source>Also finds what each building takes, for the panel Contributions and exports; takes up to twice as long.</source>
        <translation>Halla también lo que quita cada edificio, para el panel Contribuciones y las exportaciones; tarda hasta el doble.</translation>
    </message>
</context>
<context>
    <name>noonmark::BuildingAdder</name>
    <message>
        <source>finding the buildings</source>
        <translation>buscando los edificios</translation>
    </message>
</context>
<context>
    <name>noonmark::BuildingEditing</name>
    <message>
        <source>%1, %2
%3 floor area</source>
        <translation>%1, %2
%3 construidos</translation>
    </message>
    <message numerus="yes">
        <source>demolish %1 building(s)</source>
        <translation>
            <numerusform>derribar %1 edificio</numerusform>
            <numerusform>derribar %1 edificios</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::CachedTile</name>
    <message>
        <source>sweeping horizons</source>
        <translation>barriendo horizontes</translation>
    </message>
</context>
<context>
    <name>noonmark::ChartPages</name>
    <message>
        <source>Timelines</source>
        <translation>Cronologías</translation>
    </message>
    <message>
        <source>Clock: %1.</source>
        <translation>Hora: %1.</translation>
    </message>
</context>
<context>
    <name>noonmark::CompareActions</name>
    <message>
        <source>Scenarios side by side</source>
        <translation>Escenarios lado a lado</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>Two scenarios with one camera and at one time, the other one on the left</source>
        <translation>Dos escenarios con una cámara y en un mismo momento; el otro, a la izquierda</translation>
    </message>
    <message>
        <source>Swipe between scenarios</source>
        <translation>Deslizar entre escenarios</translation>
    </message>
    <message>
        <source>Shift+D</source>
        <translation>Shift+D</translation>
    </message>
    <message>
        <source>Drag the line in the view: the other scenario lies to its left</source>
        <translation>Arrastre la línea de la vista: a su izquierda está el otro escenario</translation>
    </message>
    <message>
        <source>Show the other scenario</source>
        <translation>Mostrar el otro escenario</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Press again for the displayed scenario: what differs flickers</source>
        <translation>Pulse de nuevo para el escenario mostrado: lo que difiere parpadea</translation>
    </message>
    <message>
        <source>There is only one scenario. Change a building or design a tower, then compare</source>
        <translation>Solo hay un escenario. Cambie un edificio o diseñe una torre y compare después</translation>
    </message>
    <message>
        <source>Left: %1. Right: %2</source>
        <translation>Izquierda: %1. Derecha: %2</translation>
    </message>
    <message>
        <source>shown: %1</source>
        <translation>se muestra: %1</translation>
    </message>
    <message>
        <source>sun and shadow of the same moment</source>
        <translation>sol y sombra del mismo momento</translation>
    </message>
    <message>
        <source>explored: %1 only</source>
        <translation>explorado: solo %1</translation>
    </message>
    <message>
        <source>the same question, in the same colours</source>
        <translation>la misma pregunta, en los mismos colores</translation>
    </message>
    <message>
        <source>not measured yet: %1 (Scenario &gt; Measure all scenarios)</source>
        <translation>aún sin medir: %1 (Escenario &gt; Medir todos los escenarios)</translation>
    </message>
</context>
<context>
    <name>noonmark::CompareStrip</name>
    <message>
        <source>The scenario on the left, or under the key C</source>
        <translation>El escenario de la izquierda, o con la tecla C</translation>
    </message>
    <message>
        <source>The displayed scenario, which edits change</source>
        <translation>El escenario mostrado, el que se edita</translation>
    </message>
    <message>
        <source>Ends the comparison in the view</source>
        <translation>Termina la comparación en la vista</translation>
    </message>
</context>
<context>
    <name>noonmark::ContextMenu</name>
    <message>
        <source>Select</source>
        <translation>Seleccionar</translation>
    </message>
    <message>
        <source>Replace by tower</source>
        <translation>Sustituir por torre</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Demolish</source>
        <translation>Derribar</translation>
    </message>
    <message>
        <source>Study its surroundings</source>
        <translation>Estudiar su entorno</translation>
    </message>
    <message>
        <source>Make its outline a place</source>
        <translation>Convertir su contorno en lugar</translation>
    </message>
    <message>
        <source>Study this place</source>
        <translation>Estudiar este lugar</translation>
    </message>
    <message>
        <source>Zoom to it</source>
        <translation>Acercar</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Aquí</translation>
    </message>
    <message>
        <source>Sun and sky here</source>
        <translation>Sol y cielo aquí</translation>
    </message>
    <message>
        <source>Draw lot</source>
        <translation>Dibujar parcela</translation>
    </message>
    <message>
        <source>Draw place</source>
        <translation>Dibujar lugar</translation>
    </message>
    <message>
        <source>Draw region</source>
        <translation>Dibujar zona</translation>
    </message>
    <message>
        <source>Copy position: %1</source>
        <translation>Copiar posición: %1</translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation>Medir desde aquí</translation>
    </message>
    <message>
        <source>Demolish the %1 selected</source>
        <translation>Demoler los %1 seleccionados</translation>
    </message>
    <message>
        <source>Edit lot</source>
        <translation>Editar parcela</translation>
    </message>
</context>
<context>
    <name>noonmark::ContributionLinks</name>
    <message>
        <source>No study yet. Run one (Ctrl+R), then click a place in the view to see which buildings shade it.</source>
        <translation>Aún no hay estudio. Calcule uno (Ctrl+R) y haga clic en un lugar de la vista para ver qué edificios le dan sombra.</translation>
    </message>
    <message>
        <source>What the buildings take from this place has not been computed yet.</source>
        <translation>Aún no se ha calculado lo que los edificios quitan a este lugar.</translation>
    </message>
    <message>
        <source>Click a place in the view to see which buildings shade it, or attribute the shadow of the whole region.</source>
        <translation>Haga clic en un lugar de la vista para ver qué edificios le dan sombra, o atribuya la sombra de toda la zona.</translation>
    </message>
    <message>
        <source>Attributing the shadow of %1</source>
        <translation>Atribuyendo la sombra de %1</translation>
    </message>
    <message>
        <source>Choose a place of the table, or click one in the view, to see which buildings shade it.</source>
        <translation>Elija un lugar de la tabla, o haga clic en uno en la vista, para ver qué edificios le dan sombra.</translation>
    </message>
    <message>
        <source>A saved result holds what buildings take from its whole region, if that was asked for. Of places it holds those that were attributed before it was saved.</source>
        <translation>Un resultado guardado contiene lo que los edificios quitan a toda su región, si se pidió. De lugares contiene los que se atribuyeron antes de guardarlo.</translation>
    </message>
    <message>
        <source>Buildings or trees have changed since the last answer. Run it again (Ctrl+R), then click a place in the view to see which buildings shade it.</source>
        <translation>Los edificios o los árboles han cambiado desde la última respuesta. Ejecútela otra vez (Ctrl+R) y haga clic después en un lugar de la vista para ver qué edificios le dan sombra.</translation>
    </message>
</context>
<context>
    <name>noonmark::ContributionModel</name>
    <message>
        <source>Building</source>
        <translation>Edificio</translation>
    </message>
    <message>
        <source>Building or tree</source>
        <translation>Edificio o árbol</translation>
    </message>
</context>
<context>
    <name>noonmark::Contributions</name>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>NE</source>
        <translation>NE</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>NW</source>
        <translation>NO</translation>
    </message>
    <message>
        <source>W</source>
        <translation>O</translation>
    </message>
    <message>
        <source>SW</source>
        <translation>SO</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>SE</translation>
    </message>
</context>
<context>
    <name>noonmark::ContributionsDock</name>
    <message>
        <source>Attribute the shadow</source>
        <translation>Atribuir la sombra</translation>
    </message>
    <message>
        <source>Finds what each building takes, by month, with the engine and the steps of the study</source>
        <translation>Averigua qué quita cada edificio, por mes, con el motor y los pasos del estudio</translation>
    </message>
    <message>
        <source>Colour the buildings</source>
        <translation>Colorear los edificios</translation>
    </message>
    <message>
        <source>Whose shadow is attributed to buildings. Or click a place in the view</source>
        <translation>De qué lugar se atribuye la sombra a los edificios. O haga clic en un lugar de la vista</translation>
    </message>
    <message>
        <source>Colours the buildings in the view by their share of the shadow</source>
        <translation>Colorea los edificios de la vista según su parte de la sombra</translation>
    </message>
    <message>
        <source>A row selects its building in the view; double-click to go there</source>
        <translation>Una fila selecciona su edificio en la vista; un doble clic va hasta él</translation>
    </message>
    <message>
        <source>Share of the shadow that a building is charged with</source>
        <translation>Parte de la sombra que se imputa a un edificio</translation>
    </message>
    <message>
        <source>Whole region</source>
        <translation>Toda la zona</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportar...</translation>
    </message>
    <message>
        <source>Writes this list with the answer, as CSV and JSON</source>
        <translation>Escribe esta lista con la respuesta, como CSV y JSON</translation>
    </message>
</context>
<context>
    <name>noonmark::CopyActions</name>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>The table or text last clicked, else the picture of the view</source>
        <translation>La tabla o el texto en que se hizo clic por última vez; si no, la imagen de la vista</translation>
    </message>
    <message>
        <source>The figures of the panel Results, as a table</source>
        <translation>Las cifras del panel Resultados, como tabla</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>The view with title, legend, scale and north</source>
        <translation>La vista con título, leyenda, escala y norte</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabla</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Cifras</translation>
    </message>
    <message>
        <source>%1 copied</source>
        <translation>%1 copiado</translation>
    </message>
    <message>
        <source>Copy fi&amp;gures</source>
        <translation>Copiar ci&amp;fras</translation>
    </message>
    <message>
        <source>C&amp;opy picture</source>
        <translation>Copiar &amp;imagen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
</context>
<context>
    <name>noonmark::CrownTracer</name>
    <message>
        <source>tracing rays through trees</source>
        <translation>trazando rayos por los árboles</translation>
    </message>
</context>
<context>
    <name>noonmark::DayClock</name>
    <message>
        <source>%1, with daylight saving</source>
        <translation>%1, con horario de verano</translation>
    </message>
    <message>
        <source>%1, standard time</source>
        <translation>%1, hora estándar</translation>
    </message>
    <message>
        <source>true solar time</source>
        <translation>hora solar verdadera</translation>
    </message>
</context>
<context>
    <name>noonmark::DayPanel</name>
    <message>
        <source>Any day, in the hours of the rule</source>
        <translation>Cualquier día, en las horas de la norma</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Cronología</translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation>%1 (%2).</translation>
    </message>
</context>
<context>
    <name>noonmark::DomeDisplay</name>
    <message>
        <source>Sun path dome</source>
        <translation>Cúpula de trayectorias solares</translation>
    </message>
    <message>
        <source>The sun&apos;s paths of the months and the hours on a dome around what the camera looks at, or around the pin of the panel Point</source>
        <translation>Las trayectorias del sol de los meses y las horas en una cúpula en torno a lo que mira la cámara, o al alfiler del panel Punto</translation>
    </message>
</context>
<context>
    <name>noonmark::EditActions</name>
    <message>
        <source>%1 is not a building of the displayed city</source>
        <translation>%1 no es un edificio de la ciudad mostrada</translation>
    </message>
    <message>
        <source>reload %1</source>
        <translation>recargar %1</translation>
    </message>
    <message>
        <source>region</source>
        <translation>zona</translation>
    </message>
    <message>
        <source>The study&apos;s region is now around what you built; Study &gt; Where changes it</source>
        <translation>La zona del estudio rodea ahora lo que ha construido; se cambia en «Estudio &gt; Dónde»</translation>
    </message>
</context>
<context>
    <name>noonmark::EditPreview</name>
    <message>
        <source>%1. Shape of %2 s ago</source>
        <translation>%1. Forma de hace %2 s</translation>
    </message>
    <message>
        <source>The live shadow was cancelled; it returns with the next design</source>
        <translation>La sombra en vivo se canceló; vuelve con el próximo diseño</translation>
    </message>
    <message>
        <source>No live shadow. %1</source>
        <translation>Sin sombra en vivo. %1</translation>
    </message>
    <message>
        <source>No live facades. %1</source>
        <translation>Sin fachadas en vivo. %1</translation>
    </message>
    <message numerus="yes">
        <source>Facades: %1 point(s) while it moves</source>
        <translation>
            <numerusform>Fachadas: %1 punto mientras se mueve</numerusform>
            <numerusform>Fachadas: %1 puntos mientras se mueve</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Facades: %1 point(s)</source>
        <translation>
            <numerusform>Fachadas: %1 punto</numerusform>
            <numerusform>Fachadas: %1 puntos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::EditTools</name>
    <message>
        <source>Draw &amp;lot</source>
        <translation>Dibujar &amp;parcela</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>&amp;Demolish</source>
        <translation>De&amp;rribar</translation>
    </message>
    <message>
        <source>Replace by &amp;tower</source>
        <translation>Sustituir por &amp;torre</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Replaces the selected building by a tower on its lot or footprint</source>
        <translation>Sustituye el edificio seleccionado por una torre en su parcela o huella</translation>
    </message>
    <message>
        <source>&amp;Move building</source>
        <translation>&amp;Mover edificio</translation>
    </message>
    <message>
        <source>Drag the selected building over the ground</source>
        <translation>Arrastre el edificio seleccionado sobre el suelo</translation>
    </message>
    <message>
        <source>Creates a lot from the selected building&apos;s outline</source>
        <translation>Crea una parcela con el contorno del edificio seleccionado</translation>
    </message>
    <message>
        <source>&amp;Import mesh...</source>
        <translation>Importar ma&amp;lla...</translation>
    </message>
    <message>
        <source>Adds a building from a mesh file, placed by a click</source>
        <translation>Añade un edificio desde un archivo de malla, colocado con un clic</translation>
    </message>
    <message>
        <source>Drag the building over the ground. Esc ends the tool.</source>
        <translation>Arrastre el edificio sobre el suelo. Esc termina.</translation>
    </message>
    <message>
        <source>Lot from foot&amp;print</source>
        <translation>Parcela desde la &amp;huella</translation>
    </message>
    <message>
        <source>Drag the arrow or type a height. Shift: do not snap to storeys. Enter builds, Esc cancels.</source>
        <translation>Arrastre la flecha o escriba una altura. Mayús: sin ajustar a plantas. Intro construye, Esc cancela.</translation>
    </message>
    <message>
        <source>Li&amp;ve facades</source>
        <translation>Fachadas en &amp;vivo</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>Shows the sunlight of a building&apos;s facades while it is designed or changed</source>
        <translation>Muestra el soleamiento de las fachadas de un edificio mientras se diseña o modifica</translation>
    </message>
    <message>
        <source>Removes the selected building, or all of several</source>
        <translation>Quita el edificio seleccionado, o todos si son varios</translation>
    </message>
    <message>
        <source>Live change</source>
        <translation>Cambio en vivo</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>While a building is edited: show the change against the baseline instead of all shadow</source>
        <translation>Muestra lo que cambia un edificio respecto a la referencia mientras se diseña o se modifica, en lugar de la sombra con él</translation>
    </message>
    <message>
        <source>Click corners on the ground, or type the length of a side; Shift: right angles, Ctrl: no snapping; Enter finishes, Esc cancels</source>
        <translation>Haga clic en las esquinas sobre el suelo o escriba la longitud de un lado; Mayús: ángulos rectos, Ctrl: sin ajuste; Intro termina, Esc cancela</translation>
    </message>
    <message>
        <source>Edit lot &amp;shape</source>
        <translation>Editar forma de la parcela</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>Drag the corners and sides of the lot that is chosen in the panel Tower, or that the selected building stands on</source>
        <translation>Arrastre las esquinas y los lados de la parcela elegida en el panel Torre, o de aquella en la que está el edificio seleccionado</translation>
    </message>
    <message>
        <source>Click the lot&apos;s corners, or type the length of a side. Shift: at right angles to the last side. Ctrl: no snapping. Double click or Enter finishes.</source>
        <translation>Haga clic en las esquinas de la parcela o escriba la longitud de un lado. Mayús: en ángulo recto con el último lado. Ctrl: sin ajuste. Doble clic o Intro termina.</translation>
    </message>
    <message>
        <source>Drag a corner or a side of %1; Ctrl: no snapping. A click on the middle of a side adds a corner, Delete removes the selected one, Esc ends.</source>
        <translation>Arrastre una esquina o un lado de %1; Ctrl: sin ajuste. Un clic en el centro de un lado añade una esquina, Supr quita la seleccionada, Esc termina.</translation>
    </message>
    <message>
        <source>Towers that were designed on it stay as they are.</source>
        <translation>Las torres diseñadas en ella quedan como están.</translation>
    </message>
    <message>
        <source>Plant trees</source>
        <translation>Plantar árboles</translation>
    </message>
    <message>
        <source>Each click on the ground plants a tree; Esc ends</source>
        <translation>Cada clic en el suelo planta un árbol; Esc termina</translation>
    </message>
    <message>
        <source>Plant a row of trees</source>
        <translation>Plantar una hilera de árboles</translation>
    </message>
    <message>
        <source>Click the corners of a line; a double click or Enter plants trees along it</source>
        <translation>Haga clic en las esquinas de una línea; un doble clic o Intro planta árboles a lo largo de ella</translation>
    </message>
    <message>
        <source>Click the corners of a line. A double click or Enter plants trees along it, Esc ends.</source>
        <translation>Haga clic en las esquinas de una línea. Un doble clic o Intro planta árboles a lo largo de ella, Esc termina.</translation>
    </message>
    <message>
        <source>Click where trees are to stand; their measures are in the panel Trees. Esc ends.</source>
        <translation>Haga clic donde deban estar los árboles; sus medidas están en el panel Árboles. Esc termina.</translation>
    </message>
</context>
<context>
    <name>noonmark::ElementForm</name>
    <message>
        <source>all of the region</source>
        <translation>todos los de la región</translation>
    </message>
    <message>
        <source>Names or ids of buildings, with commas between them; their middle must be in the region. Empty: all buildings of the region</source>
        <translation>Nombres o identificadores de edificios, separados por comas; su centro debe estar en la región. Vacío: todos los edificios de la región</translation>
    </message>
    <message>
        <source>Adds the selected building, or removes it. Click a building first.</source>
        <translation>Añade el edificio seleccionado o lo quita. Haga clic antes en un edificio.</translation>
    </message>
    <message>
        <source>file of windows</source>
        <translation>archivo de ventanas</translation>
    </message>
    <message>
        <source>Points or polygons with heights, in any vector format. Fields id, azimuth, floor</source>
        <translation>Puntos o polígonos con alturas, en cualquier formato vectorial. Campos id, azimuth, floor</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>Examinar...</translation>
    </message>
    <message>
        <source>Chooses the file of windows</source>
        <translation>Elige el archivo de ventanas</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>De</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>buildings</source>
        <translation>edificios</translation>
    </message>
    <message>
        <source>windows</source>
        <translation>ventanas</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Add selected</source>
        <translation>Añadir selección</translation>
    </message>
    <message>
        <source>all buildings</source>
        <translation>todos los edificios</translation>
    </message>
    <message>
        <source>Names or ids of buildings, with commas between them. Empty: all buildings</source>
        <translation>Nombres o identificadores de edificios, separados por comas. Vacío: todos los edificios</translation>
    </message>
    <message>
        <source>Proposed buildings only</source>
        <translation>Solo propuestos</translation>
    </message>
    <message>
        <source>The buildings that the displayed scenario builds or changes</source>
        <translation>Los edificios que el escenario mostrado construye o modifica</translation>
    </message>
</context>
<context>
    <name>noonmark::ElementModel</name>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Edificio</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Planta</translation>
    </message>
    <message>
        <source>Facing, °</source>
        <translation>Orientación, °</translation>
    </message>
</context>
<context>
    <name>noonmark::ElementPicking</name>
    <message>
        <source>Click walls in the view to choose their faces.</source>
        <translation>Haga clic en las paredes de la vista para elegir sus caras.</translation>
    </message>
    <message>
        <source>Click the ground, roofs or walls in the view to add points.</source>
        <translation>Haga clic en el suelo, las cubiertas o las paredes de la vista para añadir puntos.</translation>
    </message>
</context>
<context>
    <name>noonmark::ElementsDock</name>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source>Part of a building or point</source>
        <translation>Parte de un edificio o punto</translation>
    </message>
    <message>
        <source>Lists only the points whose id or building contains this text</source>
        <translation>Muestra solo los puntos cuyo identificador o edificio contiene este texto</translation>
    </message>
    <message>
        <source>any</source>
        <translation>cualquiera</translation>
    </message>
    <message>
        <source>Lists only the points with less sun a day than this</source>
        <translation>Muestra solo los puntos con menos sol al día que esto</translation>
    </message>
    <message>
        <source>Select rows to see their points in the view; double-click to go there</source>
        <translation>Seleccione filas para ver sus puntos en la vista; doble clic para ir allí</translation>
    </message>
    <message>
        <source>Sun below</source>
        <translation>Sol inferior a</translation>
    </message>
    <message>
        <source>No points measured</source>
        <translation>Sin puntos medidos</translation>
    </message>
    <message numerus="yes">
        <source>%1 point(s)</source>
        <translation>
            <numerusform>%1 punto</numerusform>
            <numerusform>%1 puntos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 point(s)</source>
        <translation>
            <numerusform>%1 de %2 punto</numerusform>
            <numerusform>%1 de %2 puntos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::ElevationFlow</name>
    <message>
        <source> %1 more buildings are not drawn.</source>
        <translation> No se dibujan %1 edificios más.</translation>
    </message>
    <message>
        <source> %1 sides do not fit on %2 at 1:%3 and are smaller.</source>
        <translation> %1 lados no caben en %2 a 1:%3 y son más pequeños.</translation>
    </message>
    <message>
        <source>%1, facing %2 (%3°)</source>
        <translation>%1, orientado al %2 (%3°)</translation>
    </message>
    <message>
        <source>, layer %1 of %2</source>
        <translation>, capa %1 de %2</translation>
    </message>
    <message>
        <source>1:%1 on %2. %3 windows</source>
        <translation>1:%1 en %2. %3 ventanas</translation>
    </message>
</context>
<context>
    <name>noonmark::Exploration</name>
    <message>
        <source>Exploring</source>
        <translation>Explorando</translation>
    </message>
</context>
<context>
    <name>noonmark::ExportDialog</name>
    <message>
        <source>Screen</source>
        <translation>Pantalla</translation>
    </message>
    <message>
        <source>Large screen</source>
        <translation>Pantalla grande</translation>
    </message>
    <message>
        <source>A4 in print</source>
        <translation>A4 impreso</translation>
    </message>
    <message>
        <source>A3 in print</source>
        <translation>A3 impreso</translation>
    </message>
    <message>
        <source>A1 in print</source>
        <translation>A1 impreso</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Otro</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source> pixels wide</source>
        <translation> píxeles de ancho</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Table of all cells</source>
        <translation>Tabla de todas las celdas</translation>
    </message>
    <message>
        <source>A line of text for each cell: large for a large region</source>
        <translation>Una línea de texto por celda: grande en zonas grandes</translation>
    </message>
    <message>
        <source>Sheets with a title block</source>
        <translation>Láminas con cajetín</translation>
    </message>
    <message>
        <source>A PDF with maps, figures, charts and method on several pages</source>
        <translation>Un PDF con mapas, cifras, gráficos y método en varias páginas</translation>
    </message>
    <message>
        <source>a folder; it is created if missing</source>
        <translation>una carpeta; se crea si no existe</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>Examinar...</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Elija una carpeta</translation>
    </message>
    <message>
        <source>Export to folder</source>
        <translation>Exportar a una carpeta</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>With the project</source>
        <translation>Con el proyecto</translation>
    </message>
    <message>
        <source>Puts a copy of the project&apos;s file into the folder, so that the result can be verified from there</source>
        <translation>Pone una copia del archivo del proyecto en la carpeta para poder verificar el resultado desde allí</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Abrir carpeta</translation>
    </message>
    <message>
        <source>Shows the written files</source>
        <translation>Muestra los archivos escritos</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>Escrito en %1</translation>
    </message>
    <message>
        <source>Cancelled. Any change lays the sheets out again.</source>
        <translation>Cancelado. Cualquier cambio vuelve a componer las láminas.</translation>
    </message>
    <message>
        <source>Title block</source>
        <translation>Cajetín</translation>
    </message>
    <message>
        <source>Laying out the sheets</source>
        <translation>Componiendo las láminas</translation>
    </message>
    <message>
        <source> pixels high</source>
        <translation> píxeles de alto</translation>
    </message>
    <message>
        <source>Title, legend and scale bar</source>
        <translation>Título, leyenda y barra de escala</translation>
    </message>
    <message>
        <source>Around the view, within the size of the picture</source>
        <translation>Alrededor de la vista, dentro del tamaño de la imagen</translation>
    </message>
    <message>
        <source>Save project first...</source>
        <translation>Guardar antes el proyecto...</translation>
    </message>
    <message>
        <source>A result can be verified only with the project that it comes from</source>
        <translation>Un resultado solo se puede verificar con el proyecto del que procede</translation>
    </message>
    <message>
        <source>The project has changes that are not saved: what is exported now cannot be verified.</source>
        <translation>El proyecto tiene cambios sin guardar: lo que se exporte ahora no se podrá verificar.</translation>
    </message>
    <message>
        <source>The project is not saved: what is exported now cannot be verified.</source>
        <translation>El proyecto no está guardado: lo que se exporte ahora no se podrá verificar.</translation>
    </message>
    <message>
        <source>Save project first</source>
        <translation>Guardar antes el proyecto</translation>
    </message>
    <message>
        <source>The name of the PDF with the sheets</source>
        <translation>El nombre del PDF con las láminas</translation>
    </message>
    <message>
        <source>Name of the sheets</source>
        <translation>Nombre de las láminas</translation>
    </message>
    <message>
        <source>Two of the files have one name: choose another for the sheets</source>
        <translation>Dos de los archivos tienen el mismo nombre: elija otro para las láminas</translation>
    </message>
    <message>
        <source>No sheets are written. Tick &quot;%1&quot; to see and write them.</source>
        <translation>No se escriben láminas. Marque «%1» para verlas y escribirlas.</translation>
    </message>
    <message>
        <source>What is chosen has no sheets.</source>
        <translation>Lo elegido no tiene láminas.</translation>
    </message>
</context>
<context>
    <name>noonmark::ExtrudeHandle</name>
    <message>
        <source>Height: %1  (Enter)</source>
        <translation>Altura: %1  (Intro)</translation>
    </message>
    <message>
        <source>Top above datum: %1  (Enter)</source>
        <translation>Cota superior sobre el datum: %1  (Intro)</translation>
    </message>
</context>
<context>
    <name>noonmark::FaceForm</name>
    <message>
        <source>all faces</source>
        <translation>todas las caras</translation>
    </message>
    <message>
        <source>Single faces of buildings, with commas between them, by the beginning of their points&apos; ids: way 12 wall 3. Empty: all faces</source>
        <translation>Caras concretas de edificios, separadas por comas, por el comienzo de los id de sus puntos: way 12 wall 3. Vacío: todas las caras</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Elegir</translation>
    </message>
    <message>
        <source>Click walls in the view: each click adds a face or removes it. Press again to end</source>
        <translation>Haga clic en las paredes de la vista: cada clic añade o quita una cara. Pulse de nuevo para terminar</translation>
    </message>
    <message>
        <source>any direction</source>
        <translation>cualquier dirección</translation>
    </message>
    <message>
        <source>north ± 45°</source>
        <translation>norte ± 45°</translation>
    </message>
    <message>
        <source>east ± 45°</source>
        <translation>este ± 45°</translation>
    </message>
    <message>
        <source>south ± 45°</source>
        <translation>sur ± 45°</translation>
    </message>
    <message>
        <source>west ± 45°</source>
        <translation>oeste ± 45°</translation>
    </message>
    <message>
        <source>other azimuths</source>
        <translation>otros acimutes</translation>
    </message>
    <message>
        <source>Only faces, or windows, that face this direction from true north</source>
        <translation>Solo caras o ventanas orientadas en esta dirección desde el norte geográfico</translation>
    </message>
    <message>
        <source>The first azimuth, clockwise from true north</source>
        <translation>El primer acimut, en sentido horario desde el norte geográfico</translation>
    </message>
    <message>
        <source>The last azimuth, clockwise from true north</source>
        <translation>El último acimut, en sentido horario desde el norte geográfico</translation>
    </message>
    <message>
        <source>Only points from which a level line straight out from the wall meets this place, as the windows along a park</source>
        <translation>Solo puntos desde los que una línea horizontal perpendicular a la pared alcanza este lugar, como las ventanas frente a un parque</translation>
    </message>
    <message>
        <source>How far away the place may be</source>
        <translation>A qué distancia puede estar el lugar</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Caras</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>Orientación</translation>
    </message>
    <message>
        <source>Looking at</source>
        <translation>Con vistas a</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>caras</translation>
    </message>
    <message>
        <source>faced place</source>
        <translation>lugar al que mira</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>dirección</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>cualquier cosa</translation>
    </message>
    <message>
        <source>azimuths</source>
        <translation>acimutes</translation>
    </message>
</context>
<context>
    <name>noonmark::FieldChoices</name>
    <message>
        <source>none is found by name</source>
        <translation>ninguno hallado por su nombre</translation>
    </message>
    <message>
        <source>found by name: %1</source>
        <translation>hallado por su nombre: %1</translation>
    </message>
    <message numerus="yes">
        <source>%1   %2 feature(s)</source>
        <translation>
            <numerusform>%1   %2 elemento</numerusform>
            <numerusform>%1   %2 elementos</numerusform>
        </translation>
    </message>
    <message>
        <source>Lists the fields with sample values</source>
        <translation>Muestra los campos con valores de ejemplo</translation>
    </message>
</context>
<context>
    <name>noonmark::FieldHelp</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>More in the guide (F1)</source>
        <translation>Más en la guía (F1)</translation>
    </message>
</context>
<context>
    <name>noonmark::Filming</name>
    <message>
        <source>computing the frames of the movie</source>
        <translation>calculando los fotogramas</translation>
    </message>
    <message>
        <source>writing the movie</source>
        <translation>escribiendo la película</translation>
    </message>
</context>
<context>
    <name>noonmark::FramePainter</name>
    <message>
        <source>Project</source>
        <translation>Proyecto</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>Cliente</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Hoja</translation>
    </message>
    <message>
        <source>sheet %1 of %2</source>
        <translation>hoja %1 de %2</translation>
    </message>
</context>
<context>
    <name>noonmark::FurtherTable</name>
    <message>
        <source>Add tower</source>
        <translation>Añadir torre</translation>
    </message>
    <message>
        <source>Another tower on the lot, apart from the others: each has a piece of it</source>
        <translation>Otra torre en la parcela, separada de las demás: cada una tiene una parte de ella</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Removes the selected tower, or the last one</source>
        <translation>Quita la torre seleccionada o la última</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>Plantas</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Planta tipo</translation>
    </message>
    <message>
        <source>Further towers, which the same step builds; the lot is divided across its longest side</source>
        <translation>Otras torres, que construye el mismo paso; la parcela se divide transversalmente a su lado más largo</translation>
    </message>
</context>
<context>
    <name>noonmark::GlazingForm</name>
    <message>
        <source>Facades, bay by bay</source>
        <translation>Fachadas, vano por vano</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>De un archivo</translation>
    </message>
    <message>
        <source>A file of points or polygons with heights gives the real windows</source>
        <translation>Un archivo de puntos o polígonos con alturas da las ventanas reales</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Ventanas</translation>
    </message>
</context>
<context>
    <name>noonmark::GlazingPanel</name>
    <message>
        <source>Verdicts after</source>
        <translation>Veredictos después</translation>
    </message>
    <message>
        <source>Verdicts before</source>
        <translation>Veredictos antes</translation>
    </message>
    <message>
        <source>Changed verdicts</source>
        <translation>Veredictos que cambian</translation>
    </message>
    <message>
        <source>No verdicts</source>
        <translation>Ningún veredicto</translation>
    </message>
    <message>
        <source>What the 3D view shows on the walls: a tile for each window in the colour of its verdict.
A click on a tile selects its row, a click on a row frames its window.</source>
        <translation>Lo que la vista 3D muestra en los muros: una tesela por ventana con el color de su veredicto.
Un clic en una tesela selecciona su fila; un clic en una fila encuadra su ventana.</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>En la vista</translation>
    </message>
</context>
<context>
    <name>noonmark::GlazingSession</name>
    <message>
        <source>Review</source>
        <translation>Revisión</translation>
    </message>
    <message>
        <source>Not up to date. %1</source>
        <translation>No actualizado. %1</translation>
    </message>
    <message>
        <source>Not up to date: buildings, windows or the rule have changed. Run again.</source>
        <translation>No está al día: han cambiado los edificios, las ventanas o la norma. Vuelva a ejecutarla.</translation>
    </message>
    <message>
        <source>Estimating</source>
        <translation>Estimando el tiempo</translation>
    </message>
    <message>
        <source>All reviews</source>
        <translation>Todas las revisiones</translation>
    </message>
</context>
<context>
    <name>noonmark::GlazingTable</name>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Planta</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Orientación</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Edificio</translation>
    </message>
    <message>
        <source>%1, before</source>
        <translation>%1, antes</translation>
    </message>
    <message>
        <source>%1, after</source>
        <translation>%1, después</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Sun on %1: %2; before: %3.</source>
        <translation>Sol el %1: %2; antes: %3.</translation>
    </message>
</context>
<context>
    <name>noonmark::GuideWindow</name>
    <message>
        <source>User guide</source>
        <translation>Guía del usuario</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>Buscar en la guía</translation>
    </message>
    <message>
        <source>Lists the pages with these words; Enter goes to the next place</source>
        <translation>Muestra las páginas con estas palabras; Intro va al siguiente resultado</translation>
    </message>
    <message>
        <source>Pages of the guide</source>
        <translation>Páginas de la guía</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>noonmark::HeightColours</name>
    <message>
        <source>Colour &amp;by source of height</source>
        <translation>Colorear según el o&amp;rigen de la altura</translation>
    </message>
    <message>
        <source>Buildings whose height is measured, computed from storeys or assumed</source>
        <translation>Edificios cuya altura está medida, calculada según las plantas o supuesta</translation>
    </message>
</context>
<context>
    <name>noonmark::HelpActions</name>
    <message>
        <source>User &amp;guide</source>
        <translation>&amp;Guía del usuario</translation>
    </message>
    <message>
        <source>The guide, at the page about the panel in use</source>
        <translation>La guía, en la página del panel en uso</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>Página de &amp;inicio</translation>
    </message>
    <message>
        <source>&amp;About Noonmark</source>
        <translation>&amp;Acerca de Noonmark</translation>
    </message>
    <message>
        <source>Version, libraries and processor</source>
        <translation>Versión, bibliotecas y procesador</translation>
    </message>
    <message>
        <source>About Noonmark</source>
        <translation>Acerca de Noonmark</translation>
    </message>
    <message>
        <source>&amp;What&apos;s this?</source>
        <translation>¿&amp;Qué es esto?</translation>
    </message>
    <message>
        <source>Explains the field that is clicked next; in a field, Shift+F1</source>
        <translation>Explica el campo en que se haga clic</translation>
    </message>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>&amp;Ratón y teclas</translation>
    </message>
    <message>
        <source>All keys and what the mouse does, as a table</source>
        <translation>Todas las teclas y lo que hace el ratón, en una tabla</translation>
    </message>
    <message>
        <source>Recent projects, samples and questions</source>
        <translation>Proyectos recientes, ejemplos y preguntas</translation>
    </message>
    <message>
        <source>Ctrl+F1</source>
        <translation>Ctrl+F1</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Preguntas</translation>
    </message>
    <message>
        <source>What do you want to know of this city?</source>
        <translation>¿Qué quiere saber de esta ciudad?</translation>
    </message>
</context>
<context>
    <name>noonmark::HorizonCache</name>
    <message>
        <source>sweeping horizons</source>
        <translation>barriendo horizontes</translation>
    </message>
</context>
<context>
    <name>noonmark::HoursOf</name>
    <message>
        <source>Hours of sun a day by month</source>
        <translation>Horas de sol al día por mes</translation>
    </message>
</context>
<context>
    <name>noonmark::KeySheet</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Ratón y teclas</translation>
    </message>
    <message>
        <source>Find a key or what it does</source>
        <translation>Buscar una tecla o lo que hace</translation>
    </message>
    <message>
        <source>Shows the rows that contain these words</source>
        <translation>Muestra las filas que contienen estas palabras</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Dónde</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>Keys, mouse</source>
        <translation>Teclas, ratón</translation>
    </message>
</context>
<context>
    <name>noonmark::LatestAnswers</name>
    <message>
        <source>Comparison</source>
        <translation>Comparación</translation>
    </message>
    <message>
        <source>All scores</source>
        <translation>Todas las puntuaciones</translation>
    </message>
    <message>
        <source>Reading saved results</source>
        <translation>Leyendo resultados guardados</translation>
    </message>
    <message>
        <source>Comparing buildings</source>
        <translation>Comparando edificios</translation>
    </message>
</context>
<context>
    <name>noonmark::LegendEditor</name>
    <message>
        <source>%1 (not for colour-blind readers)</source>
        <translation>%1 (no apto para lectores daltónicos)</translation>
    </message>
    <message>
        <source>Minutes in shadow, hours of sun (the sunlit time minus gross shadow), or the share of the sunlit time in the sun.
Continuous shadow stays in minutes: the longest run in the sun does not follow from it.</source>
        <translation>Minutos en sombra, horas de sol (el tiempo de sol menos la sombra total) o la parte del tiempo con sol que se está al sol.
La sombra continua sigue en minutos: de ella no se deduce el tramo más largo al sol.</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Continua</translation>
    </message>
    <message>
        <source>Equal classes</source>
        <translation>Clases iguales</translation>
    </message>
    <message>
        <source>Quantiles: as many cells in each</source>
        <translation>Cuantiles: las mismas celdas en cada clase</translation>
    </message>
    <message>
        <source>Typed numbers, or one threshold</source>
        <translation>Números escritos o un solo umbral</translation>
    </message>
    <message>
        <source>Re&amp;versed</source>
        <translation>In&amp;vertido</translation>
    </message>
    <message>
        <source>&amp;Locked</source>
        <translation>&amp;Fijo</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>ajustado</translation>
    </message>
    <message>
        <source>Values at the ends, in the unit shown, such as 0:8</source>
        <translation>Valores en los extremos, en la unidad mostrada, como 0:8</translation>
    </message>
    <message>
        <source>Numbers between the classes, ascending, in the unit shown. One number is a threshold: two colours</source>
        <translation>Números entre las clases, en orden ascendente y en la unidad mostrada. Un solo número es un umbral: dos colores</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Leyenda</translation>
    </message>
    <message>
        <source>Keep the range of this map for all others; unlocked, each map has its own.</source>
        <translation>Mantiene el intervalo de este mapa para todos los demás; si no está fijo, cada mapa tiene el suyo.</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Mostrar</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Colores</translation>
    </message>
    <message>
        <source>&amp;Range</source>
        <translation>&amp;Intervalo</translation>
    </message>
    <message>
        <source>Cla&amp;sses</source>
        <translation>Cla&amp;ses</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>&amp;Números</translation>
    </message>
    <message>
        <source>Not two numbers like 0:8, or not ascending numbers like 2,4,6</source>
        <translation>No son dos números como 0:8, o no son números ascendentes como 2,4,6</translation>
    </message>
    <message>
        <source>Colours from much sun to much shadow; of differences and scores those around a pale middle</source>
        <translation>Colores de mucho sol a mucha sombra; en diferencias y puntuaciones, los que rodean un centro pálido</translation>
    </message>
    <message>
        <source>%1 (safe for colour-blind readers)</source>
        <translation>%1 (apto para daltónicos)</translation>
    </message>
    <message>
        <source>What is shown has fixed colours: there is nothing to choose</source>
        <translation>Lo que se muestra tiene colores fijos: no hay nada que elegir</translation>
    </message>
    <message>
        <source>A difference has its range beside the legend; a score is fitted</source>
        <translation>Una diferencia tiene su intervalo junto a la leyenda; una puntuación se ajusta</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>By the threshold of the panel Places</source>
        <translation>Según el umbral del panel Lugares</translation>
    </message>
    <message>
        <source>Range and numbers are hours of sun a day</source>
        <translation>El intervalo y los números son horas de sol al día</translation>
    </message>
    <message>
        <source>Range and numbers are hours of sun a day: switch to Sun to change them</source>
        <translation>El intervalo y los números son horas de sol al día: cambie a Sol para modificarlos</translation>
    </message>
</context>
<context>
    <name>noonmark::LegendStrip</name>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>The ends of the colour scale of a difference.
Lock it to compare pictures of several proposals; 0: automatic, fitted to each difference.</source>
        <translation>Los extremos de la escala de colores de una diferencia.
Fíjelos para comparar imágenes de varias propuestas; 0: automática, ajustada a cada diferencia.</translation>
    </message>
    <message>
        <source>What is displayed.
Gross shadow: minutes in shadow per day, mean over the days.
Continuous shadow: longest unbroken run in shadow on any day, minutes.</source>
        <translation>Qué se muestra.
Sombra total: minutos en sombra al día, media de los días.
Sombra continua: tramo más largo en sombra de cualquier día, minutos.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Sombra</translation>
    </message>
    <message>
        <source>Show minutes in shadow</source>
        <translation>Mostrar minutos en sombra</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Show hours of sun a day: the sunlit time minus gross shadow, on maps, legends and what is exported.
Continuous shadow stays as it is: the longest run in the sun does not follow from it.</source>
        <translation>Muestra horas de sol al día: el tiempo de sol menos la sombra total, en mapas, leyendas y lo que se exporta.
La sombra continua no cambia: de ella no se deduce el tramo más largo al sol.</translation>
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
        <translation>proyectando sombras</translation>
    </message>
</context>
<context>
    <name>noonmark::LineForm</name>
    <message>
        <source>Parcel</source>
        <translation>Parcela</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Separación</translation>
    </message>
    <message>
        <source>lot or file</source>
        <translation>solar o archivo</translation>
    </message>
    <message>
        <source>The parcel that the lines run around: a lot, region or place of the project by its name, or the path of a polygon file</source>
        <translation>La parcela que rodean las líneas: un solar, una región o un lugar del proyecto por su nombre, o la ruta de un archivo de polígonos</translation>
    </message>
    <message>
        <source>Distance from point to point on a line</source>
        <translation>Distancia de punto a punto en una línea</translation>
    </message>
    <message>
        <source>parcel</source>
        <translation>parcela</translation>
    </message>
    <message>
        <source>spacing</source>
        <translation>separación</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>líneas</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Líneas</translation>
    </message>
    <message>
        <source>Distances of the lines from the parcel, with commas: 5, 10</source>
        <translation>Distancias de las líneas a la parcela, separadas por comas: 5, 10</translation>
    </message>
</context>
<context>
    <name>noonmark::LiveFacades</name>
    <message>
        <source>Live facades</source>
        <translation>Fachadas en vivo</translation>
    </message>
</context>
<context>
    <name>noonmark::LiveFollower</name>
    <message>
        <source>Live shadow</source>
        <translation>Sombra en vivo</translation>
    </message>
</context>
<context>
    <name>noonmark::LotEditing</name>
    <message>
        <source>add a corner to %1</source>
        <translation>añadir una esquina a %1</translation>
    </message>
    <message>
        <source>move a corner of %1</source>
        <translation>mover una esquina de %1</translation>
    </message>
    <message>
        <source>move a side of %1</source>
        <translation>mover un lado de %1</translation>
    </message>
    <message>
        <source>remove a corner of %1</source>
        <translation>quitar una esquina de %1</translation>
    </message>
</context>
<context>
    <name>noonmark::LotRoadsDialog</name>
    <message>
        <source>North</source>
        <translation>Norte</translation>
    </message>
    <message>
        <source>Northeast</source>
        <translation>Noreste</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Este</translation>
    </message>
    <message>
        <source>Southeast</source>
        <translation>Sureste</translation>
    </message>
    <message>
        <source>South</source>
        <translation>Sur</translation>
    </message>
    <message>
        <source>Southwest</source>
        <translation>Suroeste</translation>
    </message>
    <message>
        <source>West</source>
        <translation>Oeste</translation>
    </message>
    <message>
        <source>Northwest</source>
        <translation>Noroeste</translation>
    </message>
    <message>
        <source>no road</source>
        <translation>sin calle</translation>
    </message>
    <message>
        <source>Roads along %1</source>
        <translation>Calles junto a %1</translation>
    </message>
    <message>
        <source>How wide are the roads, water or railways on each side? Rules about parcels, as in Japan, move the parcel&apos;s line out along them. A side counts for the outermost edges that face within 45 degrees of it.</source>
        <translation>¿Qué ancho tienen las calles, el agua o las vías en cada lado? Las normas sobre parcelas, como en Japón, desplazan hacia fuera la línea de la parcela. Un lado vale para los bordes exteriores orientados hacia él con menos de 45 grados.</translation>
    </message>
</context>
<context>
    <name>noonmark::MainWindow</name>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>as in the paper</source>
        <translation>como en el artículo</translation>
    </message>
    <message>
        <source>Choose a scenario at the top first. A change to a building begins one: click a building, and drag its arrow or replace it by a tower (Ctrl+T).</source>
        <translation>Elija antes un escenario arriba. Un cambio en un edificio inicia uno: haga clic en un edificio y arrastre su flecha o sustitúyalo por una torre (Ctrl+T).</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Guardado como %1</translation>
    </message>
    <message>
        <source>%1[*] - Noonmark</source>
        <translation>%1[*] - Noonmark</translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation>Como en el artículo</translation>
    </message>
    <message>
        <source>receivers</source>
        <translation>receptores</translation>
    </message>
    <message>
        <source>Time and legend</source>
        <translation>Tiempo y leyenda</translation>
    </message>
    <message>
        <source>The answer is being computed</source>
        <translation>Se está calculando la respuesta</translation>
    </message>
    <message>
        <source>Now by shadow accrual maps, studies by inverse accrual maps through the direction graph.
Approximate: the legend states the measured error. Verdicts of reviews stay exact</source>
        <translation>Ahora con mapas de acumulación de sombra, los estudios con mapas de acumulación inversa a través del grafo de direcciones.
Aproximado: la leyenda indica el error medido. Los veredictos de las revisiones siguen siendo exactos</translation>
    </message>
    <message>
        <source>not as in the paper</source>
        <translation>no como en el artículo</translation>
    </message>
</context>
<context>
    <name>noonmark::MapLayer</name>
    <message>
        <source>Painting the map</source>
        <translation>Dibujando el mapa</translation>
    </message>
</context>
<context>
    <name>noonmark::MaskRun</name>
    <message>
        <source>filling shadows of places</source>
        <translation>rellenando sombras de los lugares</translation>
    </message>
</context>
<context>
    <name>noonmark::MassingForm</name>
    <message>
        <source>Podium</source>
        <translation>Basamento</translation>
    </message>
    <message>
        <source>One storey to %1; or drag the arrow on the tower, or type a number over the view</source>
        <translation>De una planta a %1; o arrastre la flecha de la torre, o escriba un número sobre la vista</translation>
    </message>
    <message>
        <source>Fewer than all storeys</source>
        <translation>Menos que todas las plantas</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>Plantas</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Planta tipo</translation>
    </message>
    <message>
        <source>Floor plate</source>
        <translation>Planta tipo</translation>
    </message>
    <message>
        <source>Taper, twist</source>
        <translation>Estrechamiento, torsión</translation>
    </message>
    <message>
        <source>Top above datum</source>
        <translation>Cota superior sobre el datum</translation>
    </message>
    <message>
        <source>Height above ground</source>
        <translation>Altura sobre el terreno</translation>
    </message>
    <message>
        <source>Turn, taper, twist</source>
        <translation>Girar, estrechar, torcer</translation>
    </message>
</context>
<context>
    <name>noonmark::MassingPanel</name>
    <message>
        <source>Name and id of the new building</source>
        <translation>Nombre e id del edificio nuevo</translation>
    </message>
    <message>
        <source>On</source>
        <translation>En</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Design tower</source>
        <translation>Diseñar torre</translation>
    </message>
    <message>
        <source>Designs a tower on this lot; building it demolishes the buildings on the lot</source>
        <translation>Diseña una torre en esta parcela; al construirla se derriban los edificios que hay en ella</translation>
    </message>
    <message>
        <source>Draw lot</source>
        <translation>Dibujar parcela</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Construir</translation>
    </message>
    <message>
        <source>Adds the tower to the scenario, as one undo step (Enter over the view)</source>
        <translation>Añade la torre al escenario, en un solo paso (Intro sobre la vista)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Leaves the scenario unchanged (Esc over the view)</source>
        <translation>Deja el escenario sin cambios (Esc sobre la vista)</translation>
    </message>
    <message>
        <source>No lots yet: draw one</source>
        <translation>Aún no hay parcelas: dibuje una</translation>
    </message>
    <message>
        <source>Copy tower here</source>
        <translation>Copiar la torre aquí</translation>
    </message>
    <message>
        <source>Sets the tower that is selected or being designed on this lot too, with its storeys, plate areas and setbacks, turned as the lot is</source>
        <translation>Coloca también en este solar la torre seleccionada o en diseño, con sus plantas, superficies de planta y retranqueos, girada como el solar</translation>
    </message>
    <message>
        <source>Sunlight of its facades</source>
        <translation>Soleamiento de sus fachadas</translation>
    </message>
    <message>
        <source>Shows the hours of shadow on the tower&apos;s facades, coarsely while it changes. Click other buildings in the view to see their facades too. Bays and storeys are those of the study&apos;s form.</source>
        <translation>Muestra las horas de sombra en las fachadas de la torre, de forma aproximada mientras cambia. Haga clic en otros edificios de la vista para ver también sus fachadas. Los vanos y plantas son los del formulario del estudio.</translation>
    </message>
    <message>
        <source>Change of shadow</source>
        <translation>Cambio de la sombra</translation>
    </message>
    <message>
        <source>Shows where the tower adds shadow to the baseline, or takes it away, instead of all shadow with it. A pin marks the worst spot.</source>
        <translation>Muestra dónde la torre añade sombra a la referencia o la quita, en lugar de toda la sombra con ella. Una chincheta marca el peor punto.</translation>
    </message>
    <message>
        <source>Edit lot</source>
        <translation>Editar parcela</translation>
    </message>
    <message>
        <source>Shows the lot&apos;s corners and sides as handles that are dragged.
A click on the middle of a side adds a corner, Delete removes the selected one.</source>
        <translation>Muestra las esquinas y los lados de la parcela como asas que se arrastran.
Un clic en el centro de un lado añade una esquina, Supr quita la seleccionada.</translation>
    </message>
    <message>
        <source>Click corners on the ground (Shift: at right angles to the last side; Ctrl: without snapping),
or type the length of a side and press Enter.
Double click, Enter or right click finishes, Backspace removes the last corner.</source>
        <translation>Haga clic en las esquinas sobre el suelo (Mayús: en ángulo recto con el último lado; Ctrl: sin ajuste),
o escriba la longitud de un lado y pulse Intro.
Doble clic, Intro o clic derecho termina, Retroceso quita la última esquina.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Edit tower</source>
        <translation>Editar torre</translation>
    </message>
    <message>
        <source>Designs the tower on this lot further, with the values it was built with</source>
        <translation>Sigue diseñando la torre de esta parcela, con los valores con que se construyó</translation>
    </message>
    <message>
        <source>Takes the nearest value with which the tower can be built</source>
        <translation>Toma el valor más próximo con el que se puede construir la torre</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Usar %1</translation>
    </message>
    <message>
        <source>Draw a lot on the ground, or click a building and make a lot from its footprint. Ctrl+T replaces the building that is selected by a tower.</source>
        <translation>Dibuje una parcela en el suelo, o haga clic en un edificio y cree una parcela a partir de su planta. Ctrl+T sustituye el edificio seleccionado por una torre.</translation>
    </message>
    <message>
        <source>The project&apos;s lots, and those of buildings that towers have replaced</source>
        <translation>Las parcelas del proyecto y las de los edificios que las torres han sustituido</translation>
    </message>
    <message>
        <source>A part of the tower stands outside the study&apos;s region, which alone is measured.</source>
        <translation>Una parte de la torre está fuera de la zona del estudio, que es lo único que se mide.</translation>
    </message>
    <message>
        <source>The tower stands outside the study&apos;s region, which alone is measured.</source>
        <translation>La torre está fuera de la zona del estudio, que es lo único que se mide.</translation>
    </message>
    <message>
        <source>Move the region here</source>
        <translation>Mover la zona aquí</translation>
    </message>
    <message>
        <source>Studies, comparisons and exports then measure the ground around the tower</source>
        <translation>Los estudios, comparaciones y exportaciones miden entonces el suelo alrededor de la torre</translation>
    </message>
</context>
<context>
    <name>noonmark::MassingPreview</name>
    <message>
        <source>Reading the files...</source>
        <translation>Leyendo los archivos...</translation>
    </message>
    <message>
        <source>The files hold no buildings.</source>
        <translation>Los archivos no contienen edificios.</translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s); heights: %2.
Lowest %3, median %4, tallest %5.</source>
        <translation>
            <numerusform>%1 edificio; alturas: %2.
El más bajo %3, mediana %4, el más alto %5.</numerusform>
            <numerusform>%1 edificios; alturas: %2.
El más bajo %3, mediana %4, el más alto %5.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 below the ground</source>
        <translation>%1 bajo el suelo</translation>
    </message>
</context>
<context>
    <name>noonmark::MeshPlacing</name>
    <message>
        <source>Reading %1</source>
        <translation>Leyendo %1</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importar %1</translation>
    </message>
</context>
<context>
    <name>noonmark::MessageBar</name>
    <message>
        <source>Shows or hides the other lines of this message</source>
        <translation>Muestra u oculta las demás líneas de este mensaje</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Cerrar este mensaje</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>Menos</translation>
    </message>
    <message numerus="yes">
        <source>%1 more line(s)</source>
        <translation>
            <numerusform>%1 línea más</numerusform>
            <numerusform>%1 líneas más</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::MomentPreview</name>
    <message>
        <source>Computing %1</source>
        <translation>Calculando %1</translation>
    </message>
</context>
<context>
    <name>noonmark::MovieActions</name>
    <message>
        <source>Export &amp;movie...</source>
        <translation>Exportar &amp;película...</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>The shadows of a day, of a year, or of the change by a scenario, as MP4 or GIF</source>
        <translation>Las sombras de un día, de un año o del cambio por un escenario, en MP4 o GIF</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 comparado con %2</translation>
    </message>
    <message>
        <source>Shadow: %1</source>
        <translation>Sombra: %1</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>Película</translation>
    </message>
    <message numerus="yes">
        <source>Movie of %1 frame(s) saved as %2</source>
        <translation>
            <numerusform>Película de %1 fotograma guardada como %2</numerusform>
            <numerusform>Película de %1 fotogramas guardada como %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Filming the view</source>
        <translation>Filmando la vista</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
</context>
<context>
    <name>noonmark::MovieDialog</name>
    <message>
        <source>Export movie</source>
        <translation>Exportar película</translation>
    </message>
    <message>
        <source>What changes from frame to frame</source>
        <translation>Qué cambia de un fotograma a otro</translation>
    </message>
    <message>
        <source>Shadows of one day</source>
        <translation>Sombras de un día</translation>
    </message>
    <message>
        <source>Shadows at one time through the year</source>
        <translation>Sombras a una hora a lo largo del año</translation>
    </message>
    <message>
        <source>From baseline to scenario</source>
        <translation>De la referencia al escenario</translation>
    </message>
    <message>
        <source> min of the day in each frame</source>
        <translation> min del día en cada fotograma</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>Película</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>What changes and what its shadows reach, or the places</source>
        <translation>Lo que cambia y lo que alcanzan sus sombras, o los lugares</translation>
    </message>
    <message>
        <source>The region of the study</source>
        <translation>La zona del estudio</translation>
    </message>
    <message>
        <source>Small pictures make small files, which matters for GIF</source>
        <translation>Imágenes pequeñas dan archivos pequeños, lo que importa en GIF</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 píxeles</translation>
    </message>
    <message>
        <source> frames per second</source>
        <translation> fotogramas por segundo</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportar...</translation>
    </message>
    <message>
        <source>Asks for a file: MP4 for players, GIF for pages and mail</source>
        <translation>Pide un archivo: MP4 para reproductores, GIF para páginas y correo</translation>
    </message>
    <message>
        <source>Shadows at one time through the period</source>
        <translation>Sombras a una hora a lo largo del periodo</translation>
    </message>
    <message>
        <source>What all frames show: a map, or the view from where its camera stands</source>
        <translation>Qué muestran todos los fotogramas: un mapa, o la vista desde donde está su cámara</translation>
    </message>
    <message>
        <source>The ground that the view shows</source>
        <translation>El suelo que muestra la vista</translation>
    </message>
    <message>
        <source>The view in 3D, as it is shown</source>
        <translation>La vista en 3D, tal como se muestra</translation>
    </message>
</context>
<context>
    <name>noonmark::OpenOptions</name>
    <message>
        <source>Open with options</source>
        <translation>Abrir con opciones</translation>
    </message>
    <message>
        <source>Read the files with these settings</source>
        <translation>Leer los archivos con estos ajustes</translation>
    </message>
    <message>
        <source>Add terrain or surface model...</source>
        <translation>Añadir terreno o modelo de superficie...</translation>
    </message>
    <message>
        <source>Reads elevations together with the buildings. Of a surface model and a terrain, missing heights are the difference.</source>
        <translation>Lee cotas junto con los edificios. Con un modelo de superficie y un terreno, las alturas que faltan son la diferencia.</translation>
    </message>
    <message>
        <source>Listing fields</source>
        <translation>Listando campos</translation>
    </message>
    <message>
        <source>Reading for the preview</source>
        <translation>Leyendo para la vista previa</translation>
    </message>
</context>
<context>
    <name>noonmark::OpeningActions</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>&amp;New project from a city...</source>
        <translation>&amp;Nuevo proyecto desde una ciudad...</translation>
    </message>
    <message>
        <source>Footprints, CityJSON, meshes, terrain; several files are combined into one city</source>
        <translation>Huellas, CityJSON, mallas, terreno; varios archivos se combinan en una ciudad</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Abrir...</translation>
    </message>
    <message>
        <source>A project, or city files, from which a new project is created</source>
        <translation>Un proyecto, o archivos de ciudad, con los que se crea un proyecto nuevo</translation>
    </message>
    <message>
        <source>Open &amp;with options...</source>
        <translation>Abrir con &amp;opciones...</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>For files without location, unit or heights</source>
        <translation>Para archivos sin ubicación, unidad o alturas</translation>
    </message>
    <message>
        <source>&amp;Central Park South</source>
        <translation>&amp;Central Park South</translation>
    </message>
    <message>
        <source>The park, its streets and the towers of the case study</source>
        <translation>El parque, sus calles y las torres del caso de estudio</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Retícula</translation>
    </message>
    <message>
        <source>A synthetic city of blocks and lots</source>
        <translation>Una ciudad sintética de manzanas y parcelas</translation>
    </message>
    <message>
        <source>The time zone %1 is a guess; %2 is also nearby.</source>
        <translation>La zona horaria %1 es una suposición; %2 también está cerca.</translation>
    </message>
    <message>
        <source>Open with options...</source>
        <translation>Abrir con opciones...</translation>
    </message>
    <message>
        <source>Open samp&amp;le</source>
        <translation>Abrir eje&amp;mplo</translation>
    </message>
    <message>
        <source>%1 is a terrain: it holds no buildings.</source>
        <translation>%1 es un terreno: no contiene edificios.</translation>
    </message>
    <message>
        <source>Add to the city</source>
        <translation>Añadir a la ciudad</translation>
    </message>
    <message>
        <source>Open alone</source>
        <translation>Abrir solo</translation>
    </message>
    <message numerus="yes">
        <source>%1 far building(s) left out of the first view.</source>
        <translation>
            <numerusform>%1 edificio lejano dejado aparte.</numerusform>
            <numerusform>%1 edificios lejanos dejados aparte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Zoom to all</source>
        <translation>Ver todo</translation>
    </message>
    <message>
        <source>Open a folder of city files</source>
        <translation>Abrir una carpeta de archivos de ciudad</translation>
    </message>
    <message numerus="yes">
        <source>%1 terrain(s) in the folder are not in the city: %2.</source>
        <translation>
            <numerusform>%1 terreno de la carpeta no está en la ciudad: %2.</numerusform>
            <numerusform>%1 terrenos de la carpeta no están en la ciudad: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Add terrain</source>
        <translation>Añadir terreno</translation>
    </message>
    <message>
        <source>Changed in reading: %1</source>
        <translation>Cambiado al leer: %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
</context>
<context>
    <name>noonmark::OtherScenario</name>
    <message>
        <source>Showing %1</source>
        <translation>Mostrando %1</translation>
    </message>
</context>
<context>
    <name>noonmark::PeriodForm</name>
    <message>
        <source>From sunrise to sunset</source>
        <translation>Del amanecer al ocaso</translation>
    </message>
    <message>
        <source>Time zone and sun</source>
        <translation>Zona horaria y sol</translation>
    </message>
    <message>
        <source>First day of the period, local date in the time zone</source>
        <translation>Primer día del periodo, fecha local en la zona horaria</translation>
    </message>
    <message>
        <source>IANA time zone of the wall clock, daylight saving included.
Set to that of the nearest city when a file is opened: check it near borders.</source>
        <translation>Zona horaria IANA de la hora local, con horario de verano.
Al abrir un archivo se toma la de la ciudad más cercana: compruébela cerca de fronteras.</translation>
    </message>
    <message>
        <source>Use sunrise and sunset instead of clock times</source>
        <translation>Usar amanecer y ocaso en lugar de horas de reloj</translation>
    </message>
    <message>
        <source>On: the air lifts the sun a little near the horizon (refraction).
Off: the sun&apos;s geometric position, as some rules require</source>
        <translation>Sí: el aire eleva un poco el sol cerca del horizonte (refracción).
No: la posición geométrica del sol, como exigen algunas normas</translation>
    </message>
    <message>
        <source>Wall-clock time at which each day&apos;s hours begin, hours:minutes</source>
        <translation>Hora de reloj a la que empiezan las horas de cada día, horas:minutos</translation>
    </message>
</context>
<context>
    <name>noonmark::PeriodSweep</name>
    <message>
        <source>sweeping horizons</source>
        <translation>barriendo horizontes</translation>
    </message>
</context>
<context>
    <name>noonmark::PhotographActions</name>
    <message>
        <source>Aer&amp;ial photograph...</source>
        <translation>&amp;Fotografía aérea...</translation>
    </message>
    <message>
        <source>An orthophoto or a scanned map with its position, drawn on the ground of the view, on maps and on sheets</source>
        <translation>Una ortofoto o un mapa escaneado con su posición, dibujados sobre el suelo de la vista, en mapas y en láminas</translation>
    </message>
    <message>
        <source>Aerial photo&amp;graph</source>
        <translation>&amp;Fotografía aérea</translation>
    </message>
    <message>
        <source>Shows or hides the aerial photograph</source>
        <translation>Muestra u oculta la fotografía aérea</translation>
    </message>
    <message>
        <source>Reading the photograph</source>
        <translation>Leyendo la fotografía</translation>
    </message>
    <message>
        <source>aerial photograph</source>
        <translation>fotografía aérea</translation>
    </message>
    <message>
        <source>remove aerial photograph</source>
        <translation>quitar fotografía aérea</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 tile(s) are missing and stay empty</source>
        <translation>
            <numerusform>Falta %1 de %2 tesela y queda vacía</numerusform>
            <numerusform>Faltan %1 de %2 teselas y quedan vacías</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::PhotographDialog</name>
    <message>
        <source>Draw it</source>
        <translation>Dibujarla</translation>
    </message>
    <message>
        <source>Aerial photograph</source>
        <translation>Fotografía aérea</translation>
    </message>
    <message>
        <source>(c) owner of the photograph, year</source>
        <translation>(c) propietario de la fotografía, año</translation>
    </message>
    <message>
        <source>Whose photograph it is; printed on maps, sheets and pictures that show it</source>
        <translation>De quién es la fotografía; se imprime en mapas, láminas e imágenes que la muestran</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How much it covers streets, parks and water below it</source>
        <translation>Cuánto cubre las calles, los parques y el agua que hay debajo</translation>
    </message>
    <message>
        <source>On the ground of the view, on maps and on sheets</source>
        <translation>Sobre el suelo de la vista, en mapas y en láminas</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Attribution</source>
        <translation>Atribución</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>Choose file...</source>
        <translation>Elegir archivo...</translation>
    </message>
    <message>
        <source>A GeoTIFF or Erdas Imagine file with its position, of 8 bits per colour</source>
        <translation>Un archivo GeoTIFF o Erdas Imagine con su posición, de 8 bits por color</translation>
    </message>
    <message>
        <source>From tiles...</source>
        <translation>Desde teselas...</translation>
    </message>
    <message>
        <source>Fetches tiles of the web&apos;s map scheme from an address that you state</source>
        <translation>Descarga teselas del esquema de mapas web desde una dirección que usted indica</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Takes the photograph out of the project; its file stays</source>
        <translation>Quita la fotografía del proyecto; su archivo permanece</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceActions</name>
    <message>
        <source>Read &amp;places...</source>
        <translation>Leer &amp;lugares...</translation>
    </message>
    <message>
        <source>Parks, playgrounds, school grounds... from OpenStreetMap or any file of polygons</source>
        <translation>Parques, zonas de juego, patios... de OpenStreetMap o de un archivo de polígonos</translation>
    </message>
    <message>
        <source>Draw p&amp;lace</source>
        <translation>Dibujar l&amp;ugar</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>Click corners on the ground; Enter finishes, Esc cancels</source>
        <translation>Haga clic en las esquinas sobre el suelo; Intro termina, Esc cancela</translation>
    </message>
    <message>
        <source>Creates a place from the selected building&apos;s outline</source>
        <translation>Crea un lugar con el contorno del edificio seleccionado</translation>
    </message>
    <message>
        <source>P&amp;laces</source>
        <translation>&amp;Lugares</translation>
    </message>
    <message>
        <source>Reading places</source>
        <translation>Leyendo lugares</translation>
    </message>
    <message>
        <source>read places</source>
        <translation>leer lugares</translation>
    </message>
    <message>
        <source>draw place</source>
        <translation>dibujar lugar</translation>
    </message>
    <message>
        <source>place from building</source>
        <translation>lugar desde edificio</translation>
    </message>
    <message>
        <source>Place from b&amp;uilding outline</source>
        <translation>Lugar desde el contorno de un &amp;edificio</translation>
    </message>
    <message>
        <source>Read s&amp;treets</source>
        <translation>Leer c&amp;alles</translation>
    </message>
    <message>
        <source>Streets from OpenStreetMap as places, cut at their junctions, carriageway and sidewalks apart</source>
        <translation>Calles de OpenStreetMap como lugares, cortadas en los cruces, calzada y aceras por separado</translation>
    </message>
    <message>
        <source>Shows names of places</source>
        <translation>Muestra los nombres de los lugares</translation>
    </message>
    <message>
        <source>Outlines of all places</source>
        <translation>Contornos de todos los lugares</translation>
    </message>
    <message>
        <source>Without it, the outline of the chosen place is shown, and of the one under the cursor</source>
        <translation>Sin ello se muestran el contorno del lugar elegido y el del que está bajo el cursor</translation>
    </message>
    <message>
        <source>Add to the &amp;city...</source>
        <translation>Añadir a la ciu&amp;dad...</translation>
    </message>
    <message>
        <source>Choose a file...</source>
        <translation>Elegir un archivo...</translation>
    </message>
    <message>
        <source>Which layer of %1 holds the places?</source>
        <translation>¿Qué capa de %1 contiene los lugares?</translation>
    </message>
    <message>
        <source>A terrain, an aerial photograph, trees, or parks and other places; what the city has stays</source>
        <translation>Un terreno, una fotografía aérea, árboles, o parques y otros lugares; lo que la ciudad tiene se conserva</translation>
    </message>
    <message>
        <source>%1 is drawn as %2; a right click on it in Project changes its kind.</source>
        <translation>%1 se dibujó como %2; un clic derecho en Proyecto cambia su tipo.</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceCharts</name>
    <message>
        <source>Timelines</source>
        <translation>Cronologías</translation>
    </message>
    <message>
        <source>Hours of the year in shadow</source>
        <translation>Horas del año en sombra</translation>
    </message>
    <message>
        <source>Shadow by month</source>
        <translation>Sombra por mes</translation>
    </message>
    <message>
        <source>%1 measured. Clock: %2.</source>
        <translation>%1 medidos. Hora: %2.</translation>
    </message>
    <message>
        <source>Incremental shadow: share of the place</source>
        <translation>Sombra añadida: parte del lugar</translation>
    </message>
    <message>
        <source>Shadow in the scenario: share of the place</source>
        <translation>Sombra en el escenario: parte del lugar</translation>
    </message>
    <message>
        <source>Day of the year across, time of day upwards; not counted: the sun is down, or outside the rule&apos;s hours</source>
        <translation>Días del año hacia la derecha, hora del día hacia arriba; no contado: el sol está bajo el horizonte o fuera de las horas de la norma</translation>
    </message>
    <message>
        <source>Area × hours in shadow by month</source>
        <translation>Área × horas en sombra por mes</translation>
    </message>
    <message>
        <source>The measured half of the year stands for both halves: each month counts twice</source>
        <translation>La mitad del año medida representa ambas mitades: cada mes cuenta doble</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceEvaluation</name>
    <message>
        <source>The rule is about windows, not about places</source>
        <translation>La norma trata de ventanas, no de lugares</translation>
    </message>
    <message>
        <source>The place has no cell where shadow is measured</source>
        <translation>El lugar no tiene ninguna celda donde se mida la sombra</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceFile</name>
    <message>
        <source>reading places</source>
        <translation>leyendo lugares</translation>
    </message>
    <message>
        <source>repairing outlines</source>
        <translation>reparando contornos</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceLinks</name>
    <message>
        <source>Outdated: places have changed</source>
        <translation>Desactualizado: los lugares han cambiado</translation>
    </message>
    <message>
        <source>Outdated: buildings, trees or places have changed</source>
        <translation>Desactualizado: han cambiado edificios, árboles o lugares</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceList</name>
    <message>
        <source>Find a place</source>
        <translation>Buscar un lugar</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todos</translation>
    </message>
    <message>
        <source>Tick all places</source>
        <translation>Marcar todos los lugares</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Tick no place</source>
        <translation>No marcar ninguno</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s) ticked</source>
        <translation>
            <numerusform>%1 de %2 lugar marcado</numerusform>
            <numerusform>%1 de %2 lugares marcados</numerusform>
        </translation>
    </message>
    <message>
        <source>In reach</source>
        <translation>Al alcance</translation>
    </message>
    <message>
        <source>Tick the places that the proposal&apos;s shadow reaches, found anew for each proposal</source>
        <translation>Marcar los lugares que alcanza la sombra de la propuesta, buscados de nuevo para cada propuesta</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s) in reach of the shadow; the others&apos; tooltips say why not</source>
        <translation>
            <numerusform>%1 de %2 lugar al alcance de la sombra; las ayudas de los demás dicen por qué no</numerusform>
            <numerusform>%1 de %2 lugares al alcance de la sombra; las ayudas de los demás dicen por qué no</numerusform>
        </translation>
    </message>
    <message>
        <source>Only those in reach of the shadow; they are being found</source>
        <translation>Solo los que alcanza la sombra; se están buscando</translation>
    </message>
    <message>
        <source>What the place is that is drawn, of the kinds that the rule is about</source>
        <translation>Qué es el lugar que se dibuja, de los tipos que trata la regla</translation>
    </message>
    <message>
        <source>Draw place</source>
        <translation>Dibujar lugar</translation>
    </message>
    <message>
        <source>Click the place&apos;s corners on the ground; double click or Enter finishes. Its name can then be typed in the list.</source>
        <translation>Haga clic en las esquinas del lugar en el suelo; doble clic o Intro termina. Después su nombre se escribe en la lista.</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceSorter</name>
    <message>
        <source>further places: %1</source>
        <translation>más lugares: %1</translation>
    </message>
    <message>
        <source>%1: pieces of less than %2</source>
        <translation>%1: trozos de menos de %2</translation>
    </message>
    <message>
        <source>%1, pieces of less than %2</source>
        <translation>%1, trozos de menos de %2</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceSunModel</name>
    <message>
        <source>%1, h</source>
        <translation>%1, h</translation>
    </message>
    <message>
        <source>Hours of sun on this day, mean over the place</source>
        <translation>Horas de sol en este día, media del lugar</translation>
    </message>
    <message>
        <source>%1 &lt; %2 h, %</source>
        <translation>%1 &lt; %2 h, %</translation>
    </message>
    <message>
        <source>Share of the area with less than %1 h of sun on this day</source>
        <translation>Parte del área con menos de %1 h de sol en este día</translation>
    </message>
    <message>
        <source>%1 (baseline: %2)</source>
        <translation>%1 (referencia: %2)</translation>
    </message>
    <message>
        <source>%1 without a name</source>
        <translation>%1 sin nombre</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>%1 (here: %2 h)</source>
        <translation>%1 (aquí: %2 h)</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Observaciones</translation>
    </message>
    <message>
        <source>Minutes of sun a day more than in the baseline, mean over the days and the place; negative: less</source>
        <translation>Minutos de sol al día más que en la referencia, media de los días y del lugar; negativo: menos</translation>
    </message>
    <message>
        <source>≥ %1 h, %</source>
        <translation>desde %1 h, %</translation>
    </message>
    <message>
        <source>Minutes of shadow a day: the sunlit time without the sun</source>
        <translation>Minutos de sombra al día: el tiempo diurno sin sol</translation>
    </message>
    <message>
        <source>%1: shadow, min</source>
        <translation>%1: sombra, min</translation>
    </message>
    <message>
        <source>Minutes of shadow on this day, mean over the place</source>
        <translation>Minutos de sombra ese día, media del lugar</translation>
    </message>
    <message>
        <source>Minutes of shadow a day more than in the baseline, mean over the days and the place; negative: less</source>
        <translation>Minutos de sombra al día más que en la situación de referencia, media de los días y del lugar; negativo: menos</translation>
    </message>
    <message>
        <source>Change of shadow, min</source>
        <translation>Cambio de sombra, min</translation>
    </message>
    <message>
        <source>≥ %1 h sun, %</source>
        <translation>≥ %1 h de sol, %</translation>
    </message>
    <message>
        <source>%1 &lt; %2 h sun, %</source>
        <translation>%1 &lt; %2 h de sol, %</translation>
    </message>
    <message>
        <source>%1: change, min</source>
        <translation>%1: cambio, min</translation>
    </message>
    <message>
        <source>%1: change of shadow, min</source>
        <translation>%1: cambio de sombra, min</translation>
    </message>
    <message>
        <source>Minutes more than in the baseline on this day, mean over the place; negative: less (baseline: %1)</source>
        <translation>Minutos más que en la línea base ese día, media sobre el lugar; negativo: menos (línea base: %1)</translation>
    </message>
</context>
<context>
    <name>noonmark::PlacesDock</name>
    <message>
        <source>What colours the places: the whole period, one of the dates, or the change against the baseline</source>
        <translation>Qué colorea los lugares: todo el periodo, una de las fechas o el cambio frente a la referencia</translation>
    </message>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source>Lists only places of this kind</source>
        <translation>Muestra solo los lugares de este tipo</translation>
    </message>
    <message>
        <source>By kind</source>
        <translation>Por tipo</translation>
    </message>
    <message>
        <source>Part of a name</source>
        <translation>Parte de un nombre</translation>
    </message>
    <message>
        <source>Lists only the places whose name contains this text</source>
        <translation>Muestra solo los lugares cuyo nombre contiene este texto</translation>
    </message>
    <message>
        <source>Places stand below a row of their kind with its means</source>
        <translation>Los lugares aparecen bajo una fila de su tipo con sus medias</translation>
    </message>
    <message>
        <source>Click a row to see its place in the view; a click on a place in the view selects its row</source>
        <translation>Haga clic en una fila para ver su lugar en la vista; un clic en un lugar de la vista selecciona su fila</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>Todos los tipos</translation>
    </message>
    <message>
        <source>Whole period</source>
        <translation>Todo el periodo</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>%1: no cell on open ground</source>
        <translation>%1: ninguna celda en suelo libre</translation>
    </message>
    <message>
        <source>%1: %2 h of sun a day</source>
        <translation>%1: %2 h de sol al día</translation>
    </message>
    <message>
        <source>No places measured: choose &quot;Sun by place&quot; in the panel Study</source>
        <translation>No se han medido lugares: elija «Sol por lugar» en el panel Estudio</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s)</source>
        <translation>
            <numerusform>%1 de %2 lugar</numerusform>
            <numerusform>%1 de %2 lugares</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 lose more than a minute of sun a day</source>
        <translation>%1 pierden más de un minuto de sol al día</translation>
    </message>
    <message>
        <source>%1 have less than %2 h of sun a day</source>
        <translation>%1 tienen menos de %2 h de sol al día</translation>
    </message>
    <message>
        <source>%1 have less than %2 h of sun on %3</source>
        <translation>%1 tienen menos de %2 h de sol el %3</translation>
    </message>
    <message numerus="yes">
        <source>%1 place(s)</source>
        <translation>
            <numerusform>%1 lugar</numerusform>
            <numerusform>%1 lugares</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s) listed</source>
        <translation>
            <numerusform>%1 de %2 lugar en la lista</numerusform>
            <numerusform>%1 de %2 lugares en la lista</numerusform>
        </translation>
    </message>
    <message>
        <source>Places with less sun a day than this are violet, others orange, unless the legend has other colours</source>
        <translation>Los lugares con menos sol al día son violetas, los demás naranjas, salvo que la leyenda tenga otros colores</translation>
    </message>
    <message>
        <source>Who shades it</source>
        <translation>Quién le da sombra</translation>
    </message>
    <message>
        <source>Shows which buildings take sun from the chosen place, and how much. Or double-click its row</source>
        <translation>Muestra qué edificios quitan sol al lugar elegido, y cuánto. O haga doble clic en su fila</translation>
    </message>
    <message>
        <source>Measured error against rays: %1</source>
        <translation>Error medido frente a rayos: %1</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 de %3</translation>
    </message>
    <message>
        <source>%1: %2 min of sun a day less</source>
        <translation>%1: %2 min de sol al día menos</translation>
    </message>
    <message>
        <source>%1: %2 min of sun a day more</source>
        <translation>%1: %2 min de sol al día más</translation>
    </message>
    <message>
        <source>%1. Headline and shares of the area are for %2 h, as they were saved</source>
        <translation>%1. El titular y las partes del área son para %2 h, tal como se guardaron</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Mostrarla</translation>
    </message>
    <message>
        <source>Shows this answer in the view and in the results again</source>
        <translation>Muestra de nuevo esta respuesta en la vista y en los resultados</translation>
    </message>
    <message>
        <source>The view shows another result than %1</source>
        <translation>La vista muestra un resultado distinto de %1</translation>
    </message>
    <message>
        <source>Sun by place</source>
        <translation>Sol por lugar</translation>
    </message>
    <message>
        <source>Shadow by place</source>
        <translation>Sombra por lugar</translation>
    </message>
    <message>
        <source>hours of sun a day</source>
        <translation>horas de sol al día</translation>
    </message>
    <message>
        <source>minutes of shadow a day</source>
        <translation>minutos de sombra al día</translation>
    </message>
    <message>
        <source>Change of sun by place</source>
        <translation>Cambio del sol por lugar</translation>
    </message>
    <message>
        <source>Change of shadow by place</source>
        <translation>Cambio de la sombra por lugar</translation>
    </message>
    <message>
        <source>minutes of sun a day</source>
        <translation>minutos de sol al día</translation>
    </message>
    <message>
        <source>%1: %2 min of shadow a day</source>
        <translation>%1: %2 min de sombra al día</translation>
    </message>
    <message>
        <source>%1: %2 min of shadow a day more</source>
        <translation>%1: %2 min más de sombra al día</translation>
    </message>
    <message>
        <source>%1: %2 min of shadow a day less</source>
        <translation>%1: %2 min menos de sombra al día</translation>
    </message>
    <message>
        <source>Only these</source>
        <translation>Solo estos</translation>
    </message>
    <message>
        <source>Lists only the places that this sentence counts</source>
        <translation>Enumera solo los lugares que cuenta esta frase</translation>
    </message>
    <message>
        <source> h of sun</source>
        <translation> h de sol</translation>
    </message>
    <message>
        <source>%1 get more than a minute of shadow a day more</source>
        <translation>%1 reciben más de un minuto de sombra al día adicional</translation>
    </message>
    <message>
        <source>%1 have more than %2 min of shadow a day</source>
        <translation>%1 tienen más de %2 min de sombra al día</translation>
    </message>
    <message>
        <source>%1 have more than %2 min of shadow on %3</source>
        <translation>%1 tienen más de %2 min de sombra el %3</translation>
    </message>
    <message>
        <source>%1, %2 without figures</source>
        <translation>%1, %2 sin cifras</translation>
    </message>
    <message>
        <source>%1. A saved answer states its dates as sun</source>
        <translation>%1. Una respuesta guardada indica sus fechas como sol</translation>
    </message>
    <message>
        <source>Which trees count in the table, the map and the headline</source>
        <translation>Si los árboles restan su parte del sol en la tabla, el mapa y el titular</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source> h of shade</source>
        <translation> h de sombra</translation>
    </message>
    <message>
        <source>&lt; </source>
        <translation>&lt; </translation>
    </message>
    <message>
        <source>any shade</source>
        <translation>cualquier sombra</translation>
    </message>
    <message>
        <source>Counts and lists the places with less shade than this, instead of those with too little sun</source>
        <translation>Cuenta y enumera los lugares con menos sombra que esta, en vez de los que tienen poco sol</translation>
    </message>
    <message>
        <source>%1 have less than %2 h of shade a day</source>
        <translation>%1 tienen menos de %2 h de sombra al día</translation>
    </message>
    <message>
        <source>%1 have less than %2 h of shade on %3</source>
        <translation>%1 tienen menos de %2 h de sombra el %3</translation>
    </message>
</context>
<context>
    <name>noonmark::PlacesForm</name>
    <message>
        <source>The project has no places. Read some (Study &gt; Read places...) or draw one.</source>
        <translation>El proyecto no tiene lugares. Léalos (Estudio &gt; Leer lugares...) o dibuje uno.</translation>
    </message>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source>Places of the ticked kinds are measured, all in one run</source>
        <translation>Se miden los lugares de los tipos marcados, todos en un solo cálculo</translation>
    </message>
    <message>
        <source>The share of each place with so many hours of sun a day is stated</source>
        <translation>Se indica la parte de cada lugar con tantas horas de sol al día</translation>
    </message>
    <message>
        <source>Days on which the hours of sun of each place are stated, too, with commas between</source>
        <translation>Días en los que se indican también las horas de sol de cada lugar, separados por comas</translation>
    </message>
    <message>
        <source>Enough sun</source>
        <translation>Sol suficiente</translation>
    </message>
    <message>
        <source>Dates</source>
        <translation>Fechas</translation>
    </message>
    <message>
        <source>All scenarios</source>
        <translation>Todos los escenarios</translation>
    </message>
    <message>
        <source>Measures the places in all scenarios and compares each with the baseline, which is chosen at the top</source>
        <translation>Mide los lugares en todos los escenarios y compara cada uno con la referencia, que se elige arriba</translation>
    </message>
    <message>
        <source>Own regions %1</source>
        <translation>Regiones propias %1</translation>
    </message>
    <message>
        <source>Read streets</source>
        <translation>Leer calles</translation>
    </message>
    <message>
        <source>Adds the streets of the city&apos;s OpenStreetMap file, cut at their junctions, carriageway and sidewalks apart</source>
        <translation>Añade las calles del archivo OpenStreetMap de la ciudad, cortadas en los cruces, calzada y aceras por separado</translation>
    </message>
</context>
<context>
    <name>noonmark::PlacingPanel</name>
    <message>
        <source>Build</source>
        <translation>Construir</translation>
    </message>
    <message>
        <source>Scale of all three axes</source>
        <translation>Escala de los tres ejes</translation>
    </message>
    <message>
        <source>Adds it to the scenario (Enter over the view)</source>
        <translation>Lo añade al escenario (Intro sobre la vista)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>%1: click the place on the ground for its middle.</source>
        <translation>%1: haga clic en el suelo donde irá su centro.</translation>
    </message>
    <message>
        <source> (and %1 more)</source>
        <translation> (y %1 más)</translation>
    </message>
    <message>
        <source>Floor to floor, %1 to %2, for lines at its floors; 0: not known</source>
        <translation>De suelo a suelo, %1 a %2, para las líneas de sus forjados; 0: desconocida</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconocida</translation>
    </message>
    <message>
        <source>Storey height</source>
        <translation>Altura de planta</translation>
    </message>
    <message>
        <source>%1, top %2. Another click moves it.</source>
        <translation>%1, cota superior %2. Otro clic lo mueve.</translation>
    </message>
    <message>
        <source>° east</source>
        <translation>° este</translation>
    </message>
    <message>
        <source>° north</source>
        <translation>° norte</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recargar</translation>
    </message>
    <message>
        <source>Puts the file in the place of its earlier edition; the edits that follow stay</source>
        <translation>Pone el archivo en lugar de su edición anterior; las modificaciones posteriores se conservan</translation>
    </message>
    <message>
        <source>Clockwise, seen from above. Of an IFC that states its true north, preset from it</source>
        <translation>En sentido horario, visto desde arriba. En un IFC que indica su norte verdadero, se toma de él</translation>
    </message>
    <message>
        <source>Where its middle stands; a click on the ground sets it, too</source>
        <translation>Dónde está su centro; un clic en el suelo también lo fija</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Centro</translation>
    </message>
    <message>
        <source>%1: an earlier version of this file is in the scenario as %2. Reload replaces it; Build adds another.</source>
        <translation>%1: una edición anterior está como %2. Recargar la sustituye en su sitio; Construir añade otra.</translation>
    </message>
</context>
<context>
    <name>noonmark::PlateField</name>
    <message>
        <source>Whole lot</source>
        <translation>Parcela entera</translation>
    </message>
    <message>
        <source>Share of the lot</source>
        <translation>Parte de la parcela</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>A smaller plate keeps the lot&apos;s shape, inset from all sides</source>
        <translation>Una planta menor conserva la forma de la parcela, retirada por todos los lados</translation>
    </message>
    <message>
        <source> sq ft</source>
        <translation> ft²</translation>
    </message>
</context>
<context>
    <name>noonmark::PointDock</name>
    <message>
        <source>In the sun on %1: %2
In the year: %3 h of %4 h
Sky view factor: %5</source>
        <translation>Al sol el %1: %2
En el año: %3 h de %4 h
Factor de visión del cielo: %5</translation>
    </message>
    <message>
        <source>
Vertical sky component: %1 %</source>
        <translation>
Componente vertical del cielo: %1 %</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Guardar...</translation>
    </message>
    <message>
        <source>The drawing as SVG or PNG, or the minutes by month and hour as CSV</source>
        <translation>El dibujo en SVG o PNG, o los minutos por mes y hora en CSV</translation>
    </message>
    <message>
        <source>Right-click the ground, a roof or a wall and choose Sun and sky here.</source>
        <translation>Haga clic derecho en el suelo, una cubierta o un muro y elija «Sol y cielo aquí».</translation>
    </message>
    <message>
        <source>Before: %1
%2

After: %3
%4</source>
        <translation>Antes: %1
%2

Después: %3
%4</translation>
    </message>
    <message>
        <source>%1 min on the day and %2 h in the year with their seasons; %3 min and %4 h as evergreens</source>
        <translation>%1 min en el día y %2 h en el año según sus estaciones; %3 min y %4 h como perennes</translation>
    </message>
    <message>
        <source>
With trees: %1</source>
        <translation>
Con árboles: %1</translation>
    </message>
    <message>
        <source>
Sky view factor with trees: %1 with their seasons, %2 as evergreens</source>
        <translation>
Factor de visión del cielo con árboles: %1 con sus estaciones, %2 como perennes</translation>
    </message>
    <message>
        <source>
Vertical sky component with trees: %1 % and %2 %</source>
        <translation>
Componente vertical del cielo con árboles: %1 % y %2 %</translation>
    </message>
    <message>
        <source>Trees that take most sun, with their seasons:</source>
        <translation>Árboles que quitan más sol, con sus estaciones:</translation>
    </message>
    <message>
        <source>%1: %2 min on the day, %3 h in the year</source>
        <comment>a tree, and the sun it takes</comment>
        <translation>%1: %2 min en el día, %3 h en el año</translation>
    </message>
    <message numerus="yes">
        <source>and %1 more tree(s)</source>
        <translation>
            <numerusform>y %1 árbol más</numerusform>
            <numerusform>y %1 árboles más</numerusform>
        </translation>
    </message>
    <message>
        <source>
In the sun on %1, %2: %3</source>
        <comment>a day, trees as evergreens, times</comment>
        <translation>
Al sol el %1, %2: %3</translation>
    </message>
</context>
<context>
    <name>noonmark::PointInspector</name>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
</context>
<context>
    <name>noonmark::PointListForm</name>
    <message>
        <source>Click points</source>
        <translation>Marcar puntos</translation>
    </message>
    <message>
        <source>Click the ground, roofs or walls in the view: each click adds a point. Press again to end</source>
        <translation>Haga clic en el suelo, las cubiertas o las paredes de la vista: cada clic añade un punto. Pulse de nuevo para terminar</translation>
    </message>
    <message>
        <source>Read CSV...</source>
        <translation>Leer CSV...</translation>
    </message>
    <message>
        <source>Replaces the list by a CSV file with columns id, lon, lat, height, facing</source>
        <translation>Sustituye la lista por un archivo CSV con las columnas id, lon, lat, height, facing</translation>
    </message>
    <message>
        <source>One point a line: id, longitude, latitude (degrees), metres above the ground, azimuth that a wall faces. Without a height the point is on the ground or roof, without an azimuth it is level</source>
        <translation>Un punto por línea: id, longitud, latitud (grados), metros sobre el suelo, acimut al que mira la pared. Sin altura, el punto está en el suelo o la cubierta; sin acimut, es horizontal</translation>
    </message>
    <message>
        <source>points</source>
        <translation>puntos</translation>
    </message>
</context>
<context>
    <name>noonmark::PointScenarios</name>
    <message>
        <source>The scenario before: what the other one is compared with</source>
        <translation>El escenario anterior: con el que se compara el otro</translation>
    </message>
    <message>
        <source>The scenario whose sun at the point is compared</source>
        <translation>El escenario cuyo sol en el punto se compara</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>Day, min</source>
        <translation>Día, min</translation>
    </message>
    <message>
        <source>Year, h</source>
        <translation>Año, h</translation>
    </message>
    <message>
        <source>Change, h</source>
        <translation>Cambio, h</translation>
    </message>
    <message>
        <source>Sky view</source>
        <translation>Vista del cielo</translation>
    </message>
    <message>
        <source>VSC, %</source>
        <translation>VSC, %</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>the baseline</source>
        <translation>el escenario de referencia</translation>
    </message>
    <message>
        <source>the displayed scenario</source>
        <translation>el escenario mostrado</translation>
    </message>
    <message>
        <source>The point&apos;s sun and sky in every scenario of the project, without trees where a row says nothing else. Copy (Ctrl+C) takes the table</source>
        <translation>El sol y el cielo del punto en cada escenario del proyecto, sin árboles donde la fila no diga otra cosa. Copiar (Ctrl+C) toma la tabla</translation>
    </message>
</context>
<context>
    <name>noonmark::PointShading</name>
    <message>
        <source>weighing crowns at points</source>
        <translation>ponderando copas en los puntos</translation>
    </message>
</context>
<context>
    <name>noonmark::PolygonDrawing</name>
    <message>
        <source>region</source>
        <translation>zona</translation>
    </message>
    <message>
        <source>lot</source>
        <translation>parcela</translation>
    </message>
    <message>
        <source>place</source>
        <translation>lugar</translation>
    </message>
    <message>
        <source>first corner: closes the outline</source>
        <translation>primera esquina: cierra el contorno</translation>
    </message>
    <message>
        <source>Length: %1  (Enter)</source>
        <translation>Longitud: %1  (Intro)</translation>
    </message>
    <message>
        <source>Length: %1, azimuth: %2° clockwise from north  (Enter)</source>
        <translation>Longitud: %1, acimut: %2° en sentido horario desde el norte  (Intro)</translation>
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
        <translation>Idioma, colores, unidades, papel y página de inicio</translation>
    </message>
    <message>
        <source>Pr&amp;eferences...</source>
        <translation>Prefere&amp;ncias...</translation>
    </message>
</context>
<context>
    <name>noonmark::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Como el sistema</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Light or dark; applies at once</source>
        <translation>Claro u oscuro; se aplica enseguida</translation>
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
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>Metric: metres</source>
        <translation>Métrico: metros</translation>
    </message>
    <message>
        <source>Imperial: feet</source>
        <translation>Imperial: pies</translation>
    </message>
    <message>
        <source>Metric and imperial</source>
        <translation>Métrico e imperial</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Of sheets, until you choose another for one of them</source>
        <translation>De las láminas, hasta que elija otro para una</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientación</translation>
    </message>
    <message>
        <source>Of sheets</source>
        <translation>De las láminas</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Vertical</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Horizontal</translation>
    </message>
    <message>
        <source>Show the start page when Noonmark starts</source>
        <translation>Mostrar la página de inicio al arrancar Noonmark</translation>
    </message>
    <message>
        <source>Only where no file is opened with the program. Help &gt; Start page shows it at any time</source>
        <translation>Solo si el programa no se abre con un archivo. Ayuda &gt; Página de inicio la muestra siempre</translation>
    </message>
    <message>
        <source>In which areas, lengths and heights are shown and lengths are typed; applies at once</source>
        <translation>En qué se muestran áreas, longitudes y alturas y se escriben las longitudes; se aplica enseguida</translation>
    </message>
    <message>
        <source>Of menus, panels and numbers; applies at once. Files and sheets stay English, and so do errors and warnings that hold a number or a name</source>
        <translation>De los menús, paneles y números; se aplica enseguida. Los archivos y las hojas siguen en inglés, igual que los errores y avisos que contienen un número o un nombre</translation>
    </message>
</context>
<context>
    <name>noonmark::ProgressStrip</name>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop this job; the previous result stays</source>
        <translation>Detener este trabajo; el resultado anterior se conserva</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>empezando</translation>
    </message>
</context>
<context>
    <name>noonmark::ProjectDock</name>
    <message>
        <source>remove step %1 of %2</source>
        <translation>quitar paso %1 de %2</translation>
    </message>
    <message>
        <source>delete %1</source>
        <translation>eliminar %1</translation>
    </message>
    <message>
        <source>duplicate %1</source>
        <translation>duplicar %1</translation>
    </message>
    <message>
        <source>new scenario %1</source>
        <translation>escenario nuevo %1</translation>
    </message>
    <message>
        <source>change kind of %1</source>
        <translation>cambiar tipo de %1</translation>
    </message>
    <message>
        <source>roads along %1</source>
        <translation>calles junto a %1</translation>
    </message>
    <message>
        <source>R&amp;oads along it...</source>
        <translation>&amp;Calles adyacentes...</translation>
    </message>
    <message>
        <source>&amp;Rename	F2</source>
        <translation>Cambiar no&amp;mbre	F2</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>&amp;Duplicar</translation>
    </message>
    <message>
        <source>&amp;Remove step	Del</source>
        <translation>&amp;Quitar paso	Supr</translation>
    </message>
    <message>
        <source>&amp;Delete	Del</source>
        <translation>&amp;Eliminar	Supr</translation>
    </message>
    <message>
        <source>&amp;Compare with this</source>
        <translation>&amp;Comparar con este</translation>
    </message>
    <message>
        <source>&amp;New scenario from this</source>
        <translation>&amp;Nuevo escenario desde este</translation>
    </message>
    <message>
        <source>&amp;Starts from</source>
        <translation>&amp;Parte de</translation>
    </message>
    <message>
        <source>change base of %1</source>
        <translation>cambiar base de %1</translation>
    </message>
    <message>
        <source>&amp;Use as study region</source>
        <translation>&amp;Usar como zona del estudio</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Tipo</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Mostrar</translation>
    </message>
    <message>
        <source>&amp;New scenario</source>
        <translation>&amp;Nuevo escenario</translation>
    </message>
    <message>
        <source>&amp;Save the study&apos;s region</source>
        <translation>&amp;Guardar la zona del estudio</translation>
    </message>
    <message>
        <source>&amp;Save the study&apos;s period</source>
        <translation>&amp;Guardar el periodo del estudio</translation>
    </message>
    <message>
        <source>&amp;Save the displayed result</source>
        <translation>&amp;Guardar el resultado mostrado</translation>
    </message>
    <message>
        <source>&amp;Draw a lot</source>
        <translation>&amp;Dibujar una parcela</translation>
    </message>
    <message>
        <source>&amp;Draw a place</source>
        <translation>&amp;Dibujar un lugar</translation>
    </message>
    <message>
        <source>&amp;Read places from a file...</source>
        <translation>&amp;Leer lugares de un archivo...</translation>
    </message>
    <message>
        <source>&amp;Save this view</source>
        <translation>&amp;Guardar esta vista</translation>
    </message>
    <message>
        <source>Edit lot &amp;shape</source>
        <translation>Editar forma de la parcela</translation>
    </message>
</context>
<context>
    <name>noonmark::ProjectSaving</name>
    <message>
        <source>Saving %1</source>
        <translation>Guardando %1</translation>
    </message>
    <message>
        <source>Saving recovery file</source>
        <translation>Guardando archivo de recuperación</translation>
    </message>
</context>
<context>
    <name>noonmark::ProjectSession</name>
    <message>
        <source>rename %1</source>
        <translation>cambiar nombre de %1</translation>
    </message>
    <message>
        <source>add lot %1</source>
        <translation>añadir parcela %1</translation>
    </message>
</context>
<context>
    <name>noonmark::R</name>
    <message>
        <source>Weighted shade</source>
        <translation>Sombra ponderada</translation>
    </message>
    <message>
        <source>sum over the steps of weight x hours in shadow x cell area, m2 h over the period; how the weight table is cut into intervals does not change it</source>
        <translation>suma sobre los pasos de peso x horas en sombra x área de la celda, m² h en el periodo; no cambia según cómo se divida la tabla de pesos en intervalos</translation>
    </message>
    <message>
        <source>Shadow score</source>
        <translation>Puntuación de sombra</translation>
    </message>
    <message>
        <source>sum over the intervals of the weight table of weight x share of the interval&apos;s sunlit time in shadow, times cell area; an interval that is cut in two counts twice</source>
        <translation>suma sobre los intervalos de la tabla de peso x parte del tiempo con sol del intervalo en sombra, por el área de la celda; un intervalo dividido en dos cuenta dos veces</translation>
    </message>
</context>
<context>
    <name>noonmark::RangePanel</name>
    <message>
        <source>Incremental shadow</source>
        <translation>Sombra añadida</translation>
    </message>
    <message>
        <source>Shadow in the scenario</source>
        <translation>Sombra en el escenario</translation>
    </message>
    <message>
        <source>Shadow in the baseline</source>
        <translation>Sombra en la referencia</translation>
    </message>
    <message>
        <source>Shadow by month</source>
        <translation>Sombra por mes</translation>
    </message>
    <message>
        <source>This rule is about single days. Rules about a range of days, such as san-francisco-295, have a chart by hour and day of the year.</source>
        <translation>Esta norma trata de días sueltos. Las normas sobre un intervalo de días, como san-francisco-295, tienen un gráfico por hora y día del año.</translation>
    </message>
    <message>
        <source>Computing...</source>
        <translation>Calculando...</translation>
    </message>
    <message>
        <source>Chart of the range</source>
        <translation>Gráfico del intervalo</translation>
    </message>
    <message>
        <source>Click a day for its timeline.</source>
        <translation>Haga clic en un día para ver su cronología.</translation>
    </message>
    <message>
        <source>Area × hours in shadow; each month counts twice, for both halves of the year.</source>
        <translation>Área × horas en sombra; cada mes cuenta dos veces, por ambas mitades del año.</translation>
    </message>
    <message>
        <source>Area × hours in shadow.</source>
        <translation>Área × horas en sombra.</translation>
    </message>
</context>
<context>
    <name>noonmark::ReadingForm</name>
    <message>
        <source>Origin located at</source>
        <translation>Origen situado en</translation>
    </message>
    <message>
        <source>° east</source>
        <translation>° este</translation>
    </message>
    <message>
        <source>° north</source>
        <translation>° norte</translation>
    </message>
    <message>
        <source>Middle of the open city</source>
        <translation>Centro de la ciudad abierta</translation>
    </message>
    <message>
        <source>Place and choice of data</source>
        <translation>Ubicación y selección de datos</translation>
    </message>
    <message>
        <source>Geographic location of the mesh&apos;s origin. Required for a mesh opened alone.
Off: at the origin of the city from the other files.</source>
        <translation>Ubicación geográfica del origen de la malla. Necesaria si la malla se abre sola.
No: en el origen de la ciudad de los demás archivos.</translation>
    </message>
    <message>
        <source>Longitude of the mesh&apos;s origin, degrees, east positive, -180 to 180</source>
        <translation>Longitud del origen de la malla, grados, este positivo, -180 a 180</translation>
    </message>
    <message>
        <source>Latitude of the mesh&apos;s origin, degrees, north positive, -90 to 90</source>
        <translation>Latitud del origen de la malla, grados, norte positivo, -90 a 90</translation>
    </message>
    <message>
        <source>Places the mesh&apos;s origin at the middle of the open city</source>
        <translation>Sitúa el origen de la malla en el centro de la ciudad abierta</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>Mallas (%1)</translation>
    </message>
    <message>
        <source>Heights and names</source>
        <translation>Alturas y nombres</translation>
    </message>
</context>
<context>
    <name>noonmark::RecentMenu</name>
    <message>
        <source>%1, with options</source>
        <translation>%1, con opciones</translation>
    </message>
    <message>
        <source>%1, read with %2</source>
        <translation>%1, leído con %2</translation>
    </message>
</context>
<context>
    <name>noonmark::RecoveryOffers</name>
    <message>
        <source>Noonmark closed before %1 was saved. Unsaved changes can be recovered.</source>
        <translation>Noonmark se cerró antes de guardar %1. Los cambios sin guardar se pueden recuperar.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Older changes...</source>
        <translation>Cambios anteriores...</translation>
    </message>
    <message>
        <source>There are unsaved changes to %1 from %2. They can be recovered or deleted.</source>
        <translation>Hay cambios sin guardar de %1 del %2. Se pueden recuperar o eliminar.</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>Eliminarlos</translation>
    </message>
    <message>
        <source>Noonmark closed before a project was saved. The unsaved project can be recovered.</source>
        <translation>Noonmark se cerró antes de guardar un proyecto. El proyecto sin guardar se puede recuperar.</translation>
    </message>
</context>
<context>
    <name>noonmark::RegionActions</name>
    <message>
        <source>&amp;Draw region</source>
        <translation>&amp;Dibujar zona</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Click corners on the ground; Enter finishes, Esc cancels</source>
        <translation>Haga clic en las esquinas sobre el suelo; Intro termina, Esc cancela</translation>
    </message>
    <message>
        <source>Region from &amp;file...</source>
        <translation>Zona desde arc&amp;hivo...</translation>
    </message>
    <message>
        <source>Polygons from a file, in any coordinate system</source>
        <translation>Polígonos de un archivo, en cualquier sistema de coordenadas</translation>
    </message>
    <message>
        <source>region</source>
        <translation>zona</translation>
    </message>
    <message>
        <source>draw %1</source>
        <translation>dibujar %1</translation>
    </message>
    <message>
        <source>save region %1</source>
        <translation>guardar zona %1</translation>
    </message>
</context>
<context>
    <name>noonmark::ResultActions</name>
    <message>
        <source>Save &amp;picture...</source>
        <translation>Guardar &amp;imagen...</translation>
    </message>
    <message>
        <source>Ctrl+P</source>
        <translation>Ctrl+P</translation>
    </message>
    <message>
        <source>The view with its legend, as a PNG file</source>
        <translation>La vista con su leyenda, como archivo PNG</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportar...</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>The displayed result, all scenarios or the review, as PDF, picture, GeoTIFF, tables and JSON</source>
        <translation>El resultado mostrado, todos los escenarios o la evaluación, en PDF, imagen, GeoTIFF, tablas y JSON</translation>
    </message>
    <message>
        <source>&amp;Save result</source>
        <translation>&amp;Guardar resultado</translation>
    </message>
    <message>
        <source>Stores the displayed map and figures in the project</source>
        <translation>Guarda en el proyecto el mapa y las cifras mostrados</translation>
    </message>
    <message>
        <source>Picture saved as %1</source>
        <translation>Imagen guardada como %1</translation>
    </message>
    <message>
        <source>Picture copied</source>
        <translation>Imagen copiada</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 comparado con %2</translation>
    </message>
    <message>
        <source>&amp;Export (%1)...</source>
        <translation>&amp;Exportar (%1)...</translation>
    </message>
    <message numerus="yes">
        <source>All %1 scenario(s) measured</source>
        <translation>
            <numerusform>El %1 escenario medido</numerusform>
            <numerusform>Los %1 escenarios medidos</numerusform>
        </translation>
    </message>
    <message>
        <source>Contributions to the shadow on %1</source>
        <translation>Qué quitan los edificios a %1</translation>
    </message>
    <message>
        <source>Picture of the view</source>
        <translation>Imagen de la vista</translation>
    </message>
    <message>
        <source>Table of scenarios: scores, verdicts, sun of places</source>
        <translation>Tabla de escenarios: puntuaciones, veredictos, sol de los lugares</translation>
    </message>
</context>
<context>
    <name>noonmark::ResultDisplay</name>
    <message>
        <source>These figures do not include the building being designed. Build it, then run.</source>
        <translation>Estas cifras no incluyen el edificio que se diseña. Constrúyalo y calcule.</translation>
    </message>
    <message>
        <source>Outdated figures: buildings have changed; %1.</source>
        <translation>Cifras desactualizadas: los edificios han cambiado; %1.</translation>
    </message>
    <message>
        <source>new figures are being computed</source>
        <translation>se calculan cifras nuevas</translation>
    </message>
    <message>
        <source>run again (Ctrl+R)</source>
        <translation>vuelva a calcular (Ctrl+R)</translation>
    </message>
    <message>
        <source>Outdated figures: settings have changed; run again (Ctrl+R).</source>
        <translation>Cifras desactualizadas: los ajustes han cambiado; vuelva a calcular (Ctrl+R).</translation>
    </message>
    <message>
        <source>Outdated score: the weight table has changed; score again.</source>
        <translation>Puntuación desactualizada: la tabla de pesos ha cambiado; vuelva a puntuar.</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Guardado: %1</translation>
    </message>
    <message>
        <source>%1 (outdated)</source>
        <translation>%1 (desactualizado)</translation>
    </message>
    <message>
        <source>Outdated figures: places have changed; run again (Ctrl+R).</source>
        <translation>Cifras desactualizadas: los lugares han cambiado; vuelva a calcular (Ctrl+R).</translation>
    </message>
</context>
<context>
    <name>noonmark::ResultsDock</name>
    <message>
        <source>Show the study again</source>
        <translation>Volver a mostrar el estudio</translation>
    </message>
    <message>
        <source>Replaces this result by the current study or comparison</source>
        <translation>Sustituye este resultado por el estudio o la comparación actual</translation>
    </message>
    <message>
        <source>No study yet.
Choose what, when and where in the panel Study, and press Run study (Ctrl+R). The answer then stands here.</source>
        <translation>Aún no hay estudio.
Elija qué, cuándo y dónde en el panel Estudio y pulse Calcular (Ctrl+R). La respuesta aparecerá aquí.</translation>
    </message>
    <message>
        <source>How this was made</source>
        <translation>Cómo se obtuvo</translation>
    </message>
    <message>
        <source>Period, engine, error, time, and the command that repeats this result</source>
        <translation>Periodo, motor, error, tiempo y el comando que pregunta lo mismo</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>Copiar comando</translation>
    </message>
    <message>
        <source>The command line that asks the same of the saved project or of the files</source>
        <translation>La línea de comandos que pregunta lo mismo con el proyecto guardado o los archivos</translation>
    </message>
    <message>
        <source>What was repaired, left out or assumed when the data was read</source>
        <translation>Qué se reparó, omitió o supuso al leer los datos</translation>
    </message>
    <message>
        <source>The answers of this session and those saved in the project, newest first</source>
        <translation>Las respuestas de esta sesión y las guardadas en el proyecto, primero las más recientes</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportar...</translation>
    </message>
    <message numerus="yes">
        <source>%1 warning(s) about the data</source>
        <translation>
            <numerusform>%1 aviso sobre los datos</numerusform>
            <numerusform>%1 avisos sobre los datos</numerusform>
        </translation>
    </message>
    <message>
        <source>Shows the figures of all places again</source>
        <translation>Vuelve a mostrar las cifras de todos los lugares</translation>
    </message>
    <message>
        <source>Who shades it</source>
        <translation>Quién le da sombra</translation>
    </message>
    <message>
        <source>Shows which buildings take sun from this place, and how much</source>
        <translation>Muestra qué edificios quitan sol a este lugar, y cuánto</translation>
    </message>
    <message numerus="yes">
        <source>Back to all %1 place(s)</source>
        <translation>
            <numerusform>Volver a %1 lugar</numerusform>
            <numerusform>Volver a los %1 lugares</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide this result</source>
        <translation>Ocultar este resultado</translation>
    </message>
    <message>
        <source>Show an earlier result</source>
        <translation>Mostrar un resultado anterior</translation>
    </message>
    <message>
        <source>Which trees count in what is shown here and in the view</source>
        <translation>Qué árboles cuentan en lo que se muestra aquí y en la vista</translation>
    </message>
</context>
<context>
    <name>noonmark::ReviewActions</name>
    <message>
        <source>Re&amp;view by a rule...</source>
        <translation>E&amp;valuar según una norma...</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Ctrl+Shift+R</translation>
    </message>
    <message>
        <source>Evaluate the rule of a review board on the places of the project</source>
        <translation>Aplicar la norma de una autoridad a los lugares del proyecto</translation>
    </message>
    <message>
        <source>Shows the sheets of the review, and writes them with its tables and drawings</source>
        <translation>Muestra las láminas de la evaluación y las escribe con sus tablas y dibujos</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Export t&amp;he review...</source>
        <translation>E&amp;xportar evaluación...</translation>
    </message>
</context>
<context>
    <name>noonmark::ReviewDock</name>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportar...</translation>
    </message>
    <message>
        <source>Copies the table, with all days, as text for a spreadsheet</source>
        <translation>Copia la tabla, con todos los días, como texto para una hoja de cálculo</translation>
    </message>
    <message>
        <source>Writes the sheets (PDF), the table (CSV), the data (JSON), and the shadows for CAD and GIS (DXF, GeoPackage)</source>
        <translation>Escribe las láminas (PDF), la tabla (CSV), los datos (JSON) y las sombras para CAD y SIG (DXF, GeoPackage)</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Día</translation>
    </message>
    <message>
        <source>Range of days</source>
        <translation>Intervalo de días</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Norma</translation>
    </message>
    <message>
        <source>Computing the verdicts of the building being designed...</source>
        <translation>Calculando los dictámenes del edificio que se diseña...</translation>
    </message>
    <message>
        <source>Press Run review to evaluate the rule on the ticked places.</source>
        <translation>Pulse Evaluar para aplicar la norma a los lugares marcados.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: %2 compared with %3. %4</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: %2 comparado con %3. %4</translation>
    </message>
    <message>
        <source>&lt;br&gt;&lt;i&gt;Follows the building being designed.&lt;/i&gt;</source>
        <translation>&lt;br&gt;&lt;i&gt;Sigue al edificio que se diseña.&lt;/i&gt;</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Click a row of the table to see its timeline.</source>
        <translation>Haga clic en una fila de la tabla para ver su cronología.</translation>
    </message>
    <message>
        <source>The timeline of a place appears here after a review.</source>
        <translation>La cronología de un lugar aparece aquí tras una evaluación.</translation>
    </message>
    <message>
        <source>Build the tower, then run the review, to see its range of days.</source>
        <translation>Construya la torre y evalúe para ver su intervalo de días.</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>No comprobado</translation>
    </message>
    <message>
        <source>How Noonmark reads what the rule leaves open</source>
        <translation>Cómo interpreta Noonmark lo que la norma deja abierto</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1, steps of %2 min, cells of %3 m, %4, %5&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1, pasos de %2 min, celdas de %3 m, %4, %5&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Rule files that are left out</source>
        <translation>Archivos de normas omitidos</translation>
    </message>
    <message>
        <source>&lt;h4&gt;Figures with status and source&lt;/h4&gt;</source>
        <translation>&lt;h4&gt;Cifras con estado y fuente&lt;/h4&gt;</translation>
    </message>
    <message>
        <source>A rule about windows has no timeline: click a row to read when its window has sun.</source>
        <translation>Una norma sobre ventanas no tiene cronología: haga clic en una fila para leer cuándo tiene sol su ventana.</translation>
    </message>
    <message>
        <source>Press Run review to evaluate the rule on the windows.</source>
        <translation>Pulse «Ejecutar revisión» para evaluar la norma en las ventanas.</translation>
    </message>
    <message>
        <source>Press Run review to see which places fail as the city stands, or design a tower.</source>
        <translation>Pulse Evaluar para ver qué lugares no cumplen en la ciudad actual, o diseñe una torre.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: %2 as it stands. %3</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: %2 en su estado actual. %3</translation>
    </message>
    <message>
        <source>The project holds %1, see the list of Results. Run review shows its places and timelines again.</source>
        <translation>El proyecto contiene %1, véase la lista de resultados. «Ejecutar revisión» vuelve a mostrar lugares y cronologías.</translation>
    </message>
</context>
<context>
    <name>noonmark::ReviewForm</name>
    <message>
        <source>Run review</source>
        <translation>Evaluar</translation>
    </message>
    <message>
        <source>Evaluate the rule on the ticked places, or on the windows</source>
        <translation>Evalúa la norma en los lugares marcados o en las ventanas</translation>
    </message>
    <message>
        <source>Expected time: %1</source>
        <translation>Tiempo previsto: %1</translation>
    </message>
</context>
<context>
    <name>noonmark::ReviewSession</name>
    <message>
        <source>Review</source>
        <translation>Evaluación</translation>
    </message>
    <message>
        <source>Estimating</source>
        <translation>Estimando</translation>
    </message>
    <message>
        <source>the building being designed</source>
        <translation>el edificio que se diseña</translation>
    </message>
    <message>
        <source>Live review</source>
        <translation>Evaluación en vivo</translation>
    </message>
    <message>
        <source>Not up to date: a building is being designed. Build it, then run.</source>
        <translation>No actualizado: se está diseñando un edificio. Constrúyalo y evalúe.</translation>
    </message>
    <message>
        <source>Not up to date. %1</source>
        <translation>No actualizado. %1</translation>
    </message>
    <message>
        <source>Not up to date: buildings or scenarios have changed. Run again.</source>
        <translation>No actualizado: los edificios o escenarios han cambiado. Evalúe de nuevo.</translation>
    </message>
    <message>
        <source>Not up to date: rule, places, time zone or year have changed. Run again.</source>
        <translation>No actualizado: norma, lugares, zona horaria o año han cambiado. Evalúe de nuevo.</translation>
    </message>
    <message>
        <source>All reviews</source>
        <translation>Todas las revisiones</translation>
    </message>
    <message>
        <source>Finding places in reach</source>
        <translation>Buscando lugares al alcance</translation>
    </message>
</context>
<context>
    <name>noonmark::RuleForm</name>
    <message>
        <source>Rule</source>
        <translation>Norma</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>Referencia</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>What the proposal is compared with. The rule asks for: %1</source>
        <translation>Con qué se compara la propuesta. La norma pide: %1</translation>
    </message>
    <message>
        <source>Displayed: %1</source>
        <translation>Mostrado: %1</translation>
    </message>
    <message>
        <source>%1 (not where the site is)</source>
        <translation>%1 (no donde está el emplazamiento)</translation>
    </message>
</context>
<context>
    <name>noonmark::RunForecast</name>
    <message>
        <source>Estimating</source>
        <translation>Estimando</translation>
    </message>
</context>
<context>
    <name>noonmark::SampleProgress</name>
    <message>
        <source>measuring the error on a sample</source>
        <translation>midiendo el error en una muestra</translation>
    </message>
</context>
<context>
    <name>noonmark::SavedViews</name>
    <message>
        <source>Sa&amp;ved views</source>
        <translation>Vistas &amp;guardadas</translation>
    </message>
    <message>
        <source>&amp;Save this view</source>
        <translation>&amp;Guardar esta vista</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>No view is saved yet</source>
        <translation>Aún no hay vistas guardadas</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>save view %1</source>
        <translation>guardar la vista %1</translation>
    </message>
    <message>
        <source>Saved as &apos;%1&apos; in the project. F2 in the project&apos;s list renames it.</source>
        <translation>Guardada como «%1» en el proyecto. F2 en la lista del proyecto cambia el nombre.</translation>
    </message>
    <message>
        <source>Camera, projection, section box, and date and time if a moment is shown, under a name in the project</source>
        <translation>Cámara, proyección, caja de corte y, si se muestra un momento, fecha y hora, con un nombre en el proyecto</translation>
    </message>
</context>
<context>
    <name>noonmark::SavingActions</name>
    <message>
        <source>&amp;Save project</source>
        <translation>&amp;Guardar proyecto</translation>
    </message>
    <message>
        <source>City, scenarios, lots, results and view in one file</source>
        <translation>Ciudad, escenarios, parcelas, resultados y vista en un archivo</translation>
    </message>
    <message>
        <source>Save project &amp;as...</source>
        <translation>Guardar proyecto &amp;como...</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Guardado como %1</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Guardar como...</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>Save changes to %1?</source>
        <translation>¿Guardar los cambios de %1?</translation>
    </message>
    <message>
        <source>Work in progress</source>
        <translation>Trabajo en curso</translation>
    </message>
    <message>
        <source>%1 is still running. Stop it?</source>
        <translation>%1 sigue en curso. ¿Detener?</translation>
    </message>
    <message>
        <source>Stop it</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>%1 is still running and will be stopped.</source>
        <translation>%1 sigue en curso y se detendrá.</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioActions</name>
    <message>
        <source>&amp;New scenario</source>
        <translation>&amp;Nuevo escenario</translation>
    </message>
    <message>
        <source>Starts from the existing city</source>
        <translation>Parte de la ciudad existente</translation>
    </message>
    <message>
        <source>New scenario &amp;from this one</source>
        <translation>Nuevo escenario &amp;desde este</translation>
    </message>
    <message>
        <source>Starts from the displayed scenario and inherits its later changes</source>
        <translation>Parte del escenario mostrado y hereda sus cambios posteriores</translation>
    </message>
    <message>
        <source>&amp;Compare with the existing city</source>
        <translation>&amp;Comparar con la ciudad existente</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Shows how many minutes of shadow the scenario adds or removes</source>
        <translation>Muestra cuántos minutos de sombra añade o quita el escenario</translation>
    </message>
    <message>
        <source>&amp;Measure all scenarios</source>
        <translation>&amp;Medir todos los escenarios</translation>
    </message>
    <message>
        <source>Runs the same study for each scenario, for comparison side by side</source>
        <translation>Hace el mismo estudio para cada escenario, para compararlos</translation>
    </message>
    <message>
        <source>&amp;Score all scenarios</source>
        <translation>&amp;Puntuar todos los escenarios</translation>
    </message>
    <message>
        <source>Computes the scores that the panel Scenarios lacks, with the table that the panel Weights shows</source>
        <translation>Calcula las puntuaciones que faltan en el panel Escenarios con la tabla del panel Pesos</translation>
    </message>
    <message>
        <source>&amp;Review all scenarios</source>
        <translation>&amp;Revisar todos los escenarios</translation>
    </message>
    <message>
        <source>Reviews the scenarios whose verdicts the panel Scenarios lacks, by the rule chosen in the panel Review</source>
        <translation>Revisa los escenarios cuyos dictámenes faltan en el panel Escenarios, según la norma elegida en el panel Revisión</translation>
    </message>
    <message>
        <source>The table of scenarios is on the clipboard</source>
        <translation>La tabla de escenarios está en el portapapeles</translation>
    </message>
    <message>
        <source>The existing city is displayed. Choose a scenario at the top, and compare it</source>
        <translation>Se muestra la ciudad existente. Elija un escenario en la parte superior y compárelo</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Guardado como %1</translation>
    </message>
    <message>
        <source>&amp;Export buildings...</source>
        <translation>&amp;Exportar edificios...</translation>
    </message>
    <message>
        <source>Writes the buildings that the displayed scenario proposes as glTF, OBJ, DXF or GeoPackage; of the existing city all buildings</source>
        <translation>Escribe los edificios que propone el escenario mostrado como glTF, OBJ, DXF o GeoPackage; de la ciudad existente, todos los edificios</translation>
    </message>
    <message>
        <source>Export buildings</source>
        <translation>Exportar edificios</translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s) saved as %2</source>
        <translation>
            <numerusform>%1 edificio guardado como %2</numerusform>
            <numerusform>%1 edificios guardados como %2</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no scenario yet to compare. A change to a building begins one: click a building, and drag its arrow or type its height</source>
        <translation>Todavía no hay ningún escenario que comparar. Un cambio en un edificio inicia uno: haga clic en un edificio y arrastre su flecha o escriba su altura</translation>
    </message>
    <message>
        <source>The table of scenarios compares the scores</source>
        <translation>La tabla de escenarios compara las puntuaciones</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioBar</name>
    <message>
        <source>The displayed scenario. Edits are added to it; on the existing city they start a new scenario</source>
        <translation>El escenario mostrado. Los cambios se le añaden; en la ciudad existente inician un escenario nuevo</translation>
    </message>
    <message>
        <source>Compare the scenario with this baseline: more or fewer minutes of shadow</source>
        <translation>Comparar el escenario con esta referencia: más o menos minutos de sombra</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>compare with</source>
        <translation>comparar con</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioCharts</name>
    <message>
        <source>No scenario has been scored by month: press Score all</source>
        <translation>Ningún escenario se ha puntuado por mes: pulse Puntuar todos</translation>
    </message>
    <message>
        <source>The first %1 of %2 scenarios; CSV saves all of them</source>
        <translation>Los primeros %1 de %2 escenarios; CSV los guarda todos</translation>
    </message>
    <message>
        <source>No differences: the baseline %1 lacks this figure</source>
        <translation>Sin diferencias: a la referencia %1 le falta esta cifra</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Saves all figures of the months of all scenarios, with their differences to the baseline</source>
        <translation>Guarda todas las cifras de los meses de todos los escenarios, con sus diferencias respecto a la referencia</translation>
    </message>
    <message>
        <source>A chart of the months of all scenarios, and of their differences to the baseline</source>
        <translation>Un gráfico de los meses de todos los escenarios y de sus diferencias respecto a la referencia</translation>
    </message>
    <message>
        <source>No chart</source>
        <translation>Sin gráfico</translation>
    </message>
    <message>
        <source>All of these together</source>
        <translation>Todos estos juntos</translation>
    </message>
    <message>
        <source>No scenario has months yet. %1</source>
        <translation>Ningún escenario tiene meses todavía. %1</translation>
    </message>
    <message>
        <source>Measure all by month</source>
        <translation>Medir todos por meses</translation>
    </message>
    <message>
        <source>No places have been measured: choose Sun by place in the panel Study, and press Measure all</source>
        <translation>No se han medido lugares: elija Sol por lugar en el panel Estudio y pulse Medir todo</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioTable</name>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>Double-click to show it</source>
        <translation>Doble clic para mostrarlo</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Cambios</translation>
    </message>
    <message>
        <source>Steps from the existing city, including those of its bases</source>
        <translation>Pasos desde la ciudad existente, con los de sus bases</translation>
    </message>
    <message>
        <source>Floor area by use</source>
        <translation>Superficie por uso</translation>
    </message>
    <message>
        <source>Gross floor area of the scenario&apos;s towers by use, sorted by its sum. Imported buildings and towers whose height was changed afterwards are not counted</source>
        <translation>Superficie construida total de las torres del escenario por uso, ordenada por la suma. No se cuentan los edificios importados ni las torres cuya altura se cambió después</translation>
    </message>
    <message>
        <source>Height, %1</source>
        <translation>Altura, %1</translation>
    </message>
    <message>
        <source>Highest point above its ground of the buildings that the scenario adds</source>
        <translation>Punto más alto sobre su suelo de los edificios que añade el escenario</translation>
    </message>
    <message>
        <source>Floor area, %1</source>
        <translation>Superficie, %1</translation>
    </message>
    <message>
        <source>Gross floor area of the scenario&apos;s towers. Imported buildings and towers whose height was changed afterwards are not counted</source>
        <translation>Superficie construida total de las torres del escenario. No se cuentan los edificios importados ni las torres cuya altura se cambió después</translation>
    </message>
    <message>
        <source>Impact, %1</source>
        <translation>Impacto, %1</translation>
    </message>
    <message>
        <source>Change of the shadow area from the chosen baseline, else from the existing city, on the receivers of both</source>
        <translation>Cambio del área de sombra respecto a la referencia elegida o, si no, a la ciudad existente, en los receptores de ambas</translation>
    </message>
    <message>
        <source>Verdicts</source>
        <translation>Dictámenes</translation>
    </message>
    <message>
        <source>By the rule and the baseline that the panel Review shows; sorted by the number that fail, then by borderline ones</source>
        <translation>Según la norma y la referencia del panel Revisión; ordenados por el número de los que no cumplen y luego por los que están en el límite</translation>
    </message>
    <message>
        <source>The scenario adds no building</source>
        <translation>El escenario no añade ningún edificio</translation>
    </message>
    <message>
        <source>Not computed with the current settings: press Measure all</source>
        <translation>No calculado con los ajustes actuales: pulse Medir todos</translation>
    </message>
    <message>
        <source>With the weights %1</source>
        <translation>Con los pesos %1</translation>
    </message>
    <message>
        <source>Not computed with these settings and the weights %1 since buildings last changed: press Score all</source>
        <translation>No calculado con estos ajustes y los pesos %1 desde el último cambio de los edificios: pulse Puntuar todos</translation>
    </message>
    <message>
        <source>%1, compared with %2</source>
        <translation>%1, comparado con %2</translation>
    </message>
    <message>
        <source>Not reviewed by the rule %1 since buildings or places last changed: press Review all</source>
        <translation>No revisado según la norma %1 desde el último cambio de edificios o lugares: pulse Revisar todos</translation>
    </message>
    <message>
        <source>The other scenarios are compared with this one</source>
        <translation>Los demás escenarios se comparan con este</translation>
    </message>
    <message>
        <source>Not compared with %1 with these settings since buildings last changed: press Measure all</source>
        <translation>No comparado con %1 con estos ajustes desde el último cambio de los edificios: pulse Medir todos</translation>
    </message>
    <message>
        <source>Compared with %1. Ground whose gross shadow changes by more than %2 min a day:
%3</source>
        <translation>Comparado con %1. Suelo cuya sombra total cambia más de %2 min al día:
%3</translation>
    </message>
    <message>
        <source>Measured earlier and saved with the project: press Measure all for the maps</source>
        <translation>Medido antes y guardado con el proyecto: pulse «Medir todos» para los mapas</translation>
    </message>
    <message>
        <source>not scored</source>
        <translation>sin puntuar</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>sin comparar</translation>
    </message>
    <message>
        <source>not reviewed</source>
        <translation>sin revisar</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>no medido</translation>
    </message>
    <message>
        <source>no baseline</source>
        <translation>sin referencia</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>no contada</translation>
    </message>
    <message>
        <source>starting scenario missing</source>
        <translation>falta la base</translation>
    </message>
    <message>
        <source>no weights</source>
        <translation>sin pesos</translation>
    </message>
    <message>
        <source>no rule</source>
        <translation>sin norma</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fallido</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>desactualizado</translation>
    </message>
    <message>
        <source>Best of this column</source>
        <translation>El mejor de esta columna</translation>
    </message>
    <message>
        <source>Measured error against rays: %1</source>
        <translation>Error medido frente a rayos: %1</translation>
    </message>
    <message>
        <source>%1 changes the shadow area by %2: area times its share of the sunlit time. Ground with over %3 min more shadow a day: %4.</source>
        <translation>%1 cambia el área de sombra en %2: área por su parte del tiempo con sol. Suelo con más de %3 min más de sombra al día: %4.</translation>
    </message>
    <message>
        <source>All scenarios change the shadow area by %1.</source>
        <translation>Todos los escenarios cambian el área de sombra en %1.</translation>
    </message>
    <message>
        <source>%1 adds less shadow than %2: %3 of shadow area against %4 (area times its share of the sunlit time), and %5 against %6 of ground with over %7 min more a day.</source>
        <translation>%1 añade menos sombra que %2: %3 de área de sombra frente a %4 (área por su parte del tiempo con sol), y %5 frente a %6 de suelo con más de %7 min más al día.</translation>
    </message>
    <message>
        <source>By the weights %1, %2 scores best (%3) and %4 worst (%5).</source>
        <translation>Según los pesos %1, %2 obtiene la mejor puntuación (%3) y %4 la peor (%5).</translation>
    </message>
    <message>
        <source>being scored</source>
        <translation>se está puntuando</translation>
    </message>
    <message>
        <source>being reviewed</source>
        <translation>se está revisando</translation>
    </message>
    <message>
        <source>being measured</source>
        <translation>se está midiendo</translation>
    </message>
    <message>
        <source>Sun of places, h</source>
        <translation>Sol de los lugares, h</translation>
    </message>
    <message>
        <source>Area of places with enough sun, %</source>
        <translation>Área de los lugares con sol suficiente, %</translation>
    </message>
    <message numerus="yes">
        <source>Over the area of the %Ln place(s) that were measured last</source>
        <translation>
            <numerusform>Sobre el área del %Ln lugar medido por última vez</numerusform>
            <numerusform>Sobre el área de los %Ln lugares medidos por última vez</numerusform>
        </translation>
    </message>
    <message>
        <source>Not measured since buildings last changed: choose Sun by place in the panel Study, and press Measure all</source>
        <translation>No se ha medido desde el último cambio de edificios: elija Sol por lugar en el panel Estudio y pulse Medir todo</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenariosDock</name>
    <message>
        <source>Only the existing city so far. Select a building and change it, or design a tower on a lot: the first change begins a scenario, which is listed here.</source>
        <translation>Por ahora solo la ciudad existente. Seleccione y cambie un edificio, o diseñe una torre en una parcela: el primer cambio inicia un escenario, que aparece aquí.</translation>
    </message>
    <message>
        <source>Measure all</source>
        <translation>Medir todos</translation>
    </message>
    <message>
        <source>Runs the study for scenarios without figures, with the current period and region</source>
        <translation>Estudia los escenarios sin cifras, con el periodo y la zona actuales</translation>
    </message>
    <message>
        <source>Score all</source>
        <translation>Puntuar todos</translation>
    </message>
    <message>
        <source>Computes the missing scores with the table that the panel Weights shows</source>
        <translation>Calcula las puntuaciones que faltan con la tabla del panel Pesos</translation>
    </message>
    <message>
        <source>Review all</source>
        <translation>Revisar todos</translation>
    </message>
    <message>
        <source>Reviews the scenarios without verdicts by the rule, the baseline and the places that are chosen in the panel Review</source>
        <translation>Revisa los escenarios sin dictámenes según la norma, la referencia y los lugares elegidos en el panel Revisión</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Diferencias</translation>
    </message>
    <message>
        <source>Shows figures as differences to the baseline: the chosen one, else the existing city</source>
        <translation>Muestra las cifras como diferencias con la referencia: la elegida o, si no, la ciudad existente</translation>
    </message>
    <message>
        <source>Shade is wanted</source>
        <translation>Se desea sombra</translation>
    </message>
    <message>
        <source>The star marks the scenario with most shadow as the best, not that with least</source>
        <translation>La estrella marca como mejor el escenario con más sombra, no el que tiene menos</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copies the table for a spreadsheet</source>
        <translation>Copia la tabla para una hoja de cálculo</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Saves the table with what each scenario lacks, in metres and square metres</source>
        <translation>Guarda la tabla con lo que falta a cada escenario, en metros y metros cuadrados</translation>
    </message>
</context>
<context>
    <name>noonmark::SearchActions</name>
    <message>
        <source>&amp;Find</source>
        <translation>&amp;Buscar</translation>
    </message>
    <message>
        <source>A building by name or id, a street, a place, a lot, a position or a command</source>
        <translation>Un edificio por nombre o identificador, una calle, un lugar, una parcela, una posición o una orden</translation>
    </message>
    <message>
        <source>Nothing is called &quot;%1&quot;, and no command that can be used now. Buildings without a name are found by their id.</source>
        <translation>Nada se llama «%1», ni ninguna orden que se pueda usar ahora. Los edificios sin nombre se encuentran por su identificador.</translation>
    </message>
</context>
<context>
    <name>noonmark::SearchField</name>
    <message>
        <source>Find (Ctrl+F)</source>
        <translation>Buscar (Ctrl+F)</translation>
    </message>
    <message>
        <source>A building by name or id, a street, a place, a lot, a position such as 40.7536, -73.9832, or a command</source>
        <translation>Un edificio por nombre o identificador, una calle, un lugar, una parcela, una posición como 40.7536, -73.9832, o una orden</translation>
    </message>
</context>
<context>
    <name>noonmark::SectionDialog</name>
    <message>
        <source>Section box</source>
        <translation>Caja de corte</translation>
    </message>
    <message>
        <source>West</source>
        <translation>Oeste</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Este</translation>
    </message>
    <message>
        <source>South</source>
        <translation>Sur</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Norte</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Parte superior</translation>
    </message>
    <message>
        <source>From the origin of the project, to the east and to the north</source>
        <translation>Desde el origen del proyecto, hacia el este y hacia el norte</translation>
    </message>
    <message>
        <source>Height above the origin of the project</source>
        <translation>Altura sobre el origen del proyecto</translation>
    </message>
    <message>
        <source>What the view shows</source>
        <translation>Lo que muestra la vista</translation>
    </message>
    <message>
        <source>The box around the ground in view</source>
        <translation>La caja en torno al suelo visible</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>The box around the whole city</source>
        <translation>La caja en torno a toda la ciudad</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Shows everything again</source>
        <translation>Muestra todo de nuevo</translation>
    </message>
</context>
<context>
    <name>noonmark::SelectionPanel</name>
    <message>
        <source>Import mesh...</source>
        <translation>Importar malla...</translation>
    </message>
    <message>
        <source>Demolish</source>
        <translation>Derribar</translation>
    </message>
    <message>
        <source>Removes the building (Delete)</source>
        <translation>Quita el edificio (Supr)</translation>
    </message>
    <message>
        <source>Replace by tower</source>
        <translation>Sustituir por torre</translation>
    </message>
    <message>
        <source>Replaces it by a tower on its lot or, if it has none, on its footprint</source>
        <translation>Lo sustituye por una torre en su parcela o, si no tiene, en su huella</translation>
    </message>
    <message>
        <source>Lot from footprint</source>
        <translation>Parcela desde la huella</translation>
    </message>
    <message>
        <source>Creates a lot from its outline on the ground</source>
        <translation>Crea una parcela con su contorno en el suelo</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Drag the building over the ground; Esc ends the tool</source>
        <translation>Arrastre el edificio sobre el suelo; Esc termina</translation>
    </message>
    <message>
        <source>Clockwise about its middle. Press Enter to apply</source>
        <translation>En sentido horario sobre su centro. Pulse Intro para aplicar</translation>
    </message>
    <message>
        <source>Negative: west, south. Press Enter to apply</source>
        <translation>Negativo: oeste, sur. Pulse Intro para aplicar</translation>
    </message>
    <message>
        <source>Move east</source>
        <translation>Mover al este</translation>
    </message>
    <message>
        <source>Move north</source>
        <translation>Mover al norte</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>Same floor area on its lot:</source>
        <translation>Misma superficie en su parcela:</translation>
    </message>
    <message>
        <source>Wider</source>
        <translation>Más ancho</translation>
    </message>
    <message>
        <source>Shorter, on a floor plate twice as large</source>
        <translation>Más bajo, con una planta el doble de grande</translation>
    </message>
    <message>
        <source>Widest</source>
        <translation>Lo más ancho</translation>
    </message>
    <message>
        <source>As short as the lot allows</source>
        <translation>Tan bajo como permita la parcela</translation>
    </message>
    <message>
        <source>Slimmer</source>
        <translation>Más esbelto</translation>
    </message>
    <message>
        <source>Taller, on half the floor plate</source>
        <translation>Más alto, con media planta</translation>
    </message>
    <message>
        <source>%1 to %2 above the ground; View &gt; Heights above datum shows it as an elevation. Or drag the arrow on the building. Press Enter to apply</source>
        <translation>De %1 a %2 sobre el terreno; Ver &gt; Alturas sobre el datum la muestra como cota. O arrastre la flecha del edificio. Pulse Intro para aplicar</translation>
    </message>
    <message>
        <source>Top above datum</source>
        <translation>Cota superior sobre el datum</translation>
    </message>
    <message>
        <source>Height above ground</source>
        <translation>Altura sobre el terreno</translation>
    </message>
    <message>
        <source>Demolish all</source>
        <translation>Derribar todos</translation>
    </message>
    <message>
        <source>Removes the selected buildings, as one step of undo (Delete)</source>
        <translation>Quita los edificios seleccionados, en un solo paso que se puede deshacer (Supr)</translation>
    </message>
    <message>
        <source>Click a building in the view to select it. Ctrl+click selects another too, a drag with Ctrl+Shift all in a rectangle.</source>
        <translation>Haga clic en un edificio de la vista para seleccionarlo. Ctrl+clic añade otro; arrastrar con Ctrl+Mayús, todos los de un rectángulo.</translation>
    </message>
    <message>
        <source>Adds a building from a file (%1), placed by a click on the ground</source>
        <translation>Añade un edificio de un archivo (%1), colocado con un clic en el suelo</translation>
    </message>
    <message>
        <source>Edit tower</source>
        <translation>Editar torre</translation>
    </message>
    <message>
        <source>Designs the tower further, with the values it was built with</source>
        <translation>Sigue diseñando la torre, con los valores con que se construyó</translation>
    </message>
</context>
<context>
    <name>noonmark::SetbackTable</name>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Add setback</source>
        <translation>Añadir retranqueo</translation>
    </message>
    <message>
        <source>Above each height the walls are set back by the inset, from bottom to top; taper and twist are those of the volume above it</source>
        <translation>Por encima de cada altura los muros se retranquean, de abajo arriba; el estrechamiento y la torsión son los del volumen superior</translation>
    </message>
    <message>
        <source>Height from which the walls are set back</source>
        <translation>Altura desde la que se retranquean los muros</translation>
    </message>
    <message>
        <source>How far every wall is set back, from the top of the volume below</source>
        <translation>Cuánto se retranquea cada muro, desde la parte superior del volumen inferior</translation>
    </message>
    <message>
        <source>Adds a setback above the others</source>
        <translation>Añade un retranqueo por encima de los demás</translation>
    </message>
    <message>
        <source>Removes the selected setback, or the last one</source>
        <translation>Quita el retranqueo seleccionado o el último</translation>
    </message>
</context>
<context>
    <name>noonmark::ShadowCache::State</name>
    <message>
        <source>filling shadows</source>
        <translation>rellenando sombras</translation>
    </message>
</context>
<context>
    <name>noonmark::ShadowProjection</name>
    <message>
        <source>filling shadows</source>
        <translation>rellenando sombras</translation>
    </message>
</context>
<context>
    <name>noonmark::SheetForm</name>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Title block (saved in the project)</source>
        <translation>Cajetín (se guarda en el proyecto)</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientación</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Vertical</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Horizontal</translation>
    </message>
    <message>
        <source>Scale of diagrams</source>
        <translation>Escala de los diagramas</translation>
    </message>
    <message>
        <source>A scale from 1:%1 to 1:%2 may be typed. Where a place or its shadows are larger than the paper at that scale, the diagram shows the part around the place.</source>
        <translation>Se puede escribir una escala de 1:%1 a 1:%2. Si un lugar o sus sombras superan el papel a esa escala, el diagrama muestra la parte en torno al lugar.</translation>
    </message>
    <message>
        <source>fits the page</source>
        <translation>ajustada a la página</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>Of areas, lengths and heights</source>
        <translation>De áreas, longitudes y alturas</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logotipo</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Elegir...</translation>
    </message>
    <message>
        <source>A PNG or JPEG picture of at most 1 MiB</source>
        <translation>Una imagen PNG o JPEG de 1 MiB como máximo</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Sheets without a logo</source>
        <translation>Láminas sin logotipo</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
</context>
<context>
    <name>noonmark::StartPage</name>
    <message>
        <source>Open a city</source>
        <translation>Abrir una ciudad</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Closes the start page (Esc)</source>
        <translation>Cierra la página de inicio (Esc)</translation>
    </message>
    <message>
        <source>Drop files or a folder here: OpenStreetMap, GeoPackage, CityJSON, CityGML, IFC, meshes, terrain.</source>
        <translation>Suelte aquí archivos o una carpeta: OpenStreetMap, GeoPackage, CityJSON, CityGML, IFC, mallas, terreno.</translation>
    </message>
    <message>
        <source>Open file...</source>
        <translation>Abrir archivo...</translation>
    </message>
    <message>
        <source>A project or city files (Ctrl+O)</source>
        <translation>Un proyecto o archivos de ciudad (Ctrl+O)</translation>
    </message>
    <message>
        <source>Open folder...</source>
        <translation>Abrir carpeta...</translation>
    </message>
    <message>
        <source>A folder of city files, such as tiles or a file geodatabase</source>
        <translation>Una carpeta de archivos de ciudad, como teselas o una geodatabase de archivos</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recientes</translation>
    </message>
    <message>
        <source>No longer there: %1</source>
        <translation>Ya no está: %1</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Ejemplos</translation>
    </message>
    <message>
        <source>Central Park South</source>
        <translation>Central Park South</translation>
    </message>
    <message>
        <source>The park, its streets and the towers of the case study</source>
        <translation>El parque, sus calles y las torres del caso de estudio</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Retícula</translation>
    </message>
    <message>
        <source>A synthetic city of blocks and lots</source>
        <translation>Una ciudad sintética de manzanas y parcelas</translation>
    </message>
    <message>
        <source>Guided tours and help</source>
        <translation>Visitas guiadas y ayuda</translation>
    </message>
    <message>
        <source>User guide (F1)</source>
        <translation>Guía del usuario (F1)</translation>
    </message>
    <message>
        <source>How to study, compare and review</source>
        <translation>Cómo estudiar, comparar y evaluar</translation>
    </message>
    <message>
        <source>What do you want to know?</source>
        <translation>¿Qué quiere saber?</translation>
    </message>
    <message>
        <source>Of which city?</source>
        <translation>¿De qué ciudad?</translation>
    </message>
</context>
<context>
    <name>noonmark::StudyActions</name>
    <message>
        <source>&amp;Run</source>
        <translation>Calcula&amp;r</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Compute the shadow in the region</source>
        <translation>Calcular la sombra en la zona</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>Ctrl+.</source>
        <translation>Ctrl+.</translation>
    </message>
    <message>
        <source>Stop the study that is running</source>
        <translation>Detener el estudio en curso</translation>
    </message>
    <message>
        <source>Show &amp;gross shadow</source>
        <translation>Mostrar sombra t&amp;otal</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>Minutes in shadow per day</source>
        <translation>Minutos en sombra al día</translation>
    </message>
    <message>
        <source>Show c&amp;ontinuous shadow</source>
        <translation>Mostrar sombra co&amp;ntinua</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>Longest unbroken run in shadow</source>
        <translation>Tramo más largo en sombra</translation>
    </message>
    <message>
        <source>period</source>
        <translation>periodo</translation>
    </message>
    <message>
        <source>save period %1</source>
        <translation>guardar periodo %1</translation>
    </message>
    <message>
        <source>%1 was compared with %2 when the project was saved. Run (Ctrl+R) repeats the comparison, in %3.</source>
        <translation>%1 estaba comparado con %2 al guardar el proyecto. Calcular (Ctrl+R) repite la comparación, en %3.</translation>
    </message>
    <message>
        <source>A study was shown when the project was saved. Run (Ctrl+R) computes it again, in %1.</source>
        <translation>Se mostraba un estudio al guardar el proyecto. Calcular (Ctrl+R) lo repite, en %1.</translation>
    </message>
    <message>
        <source>This study takes %1 (%2). The accuracy Quick takes %3 and measures its error against rays.</source>
        <translation>Este estudio tarda %1 (%2). La precisión Rápida tarda %3 y mide su error frente a rayos.</translation>
    </message>
    <message>
        <source>Run quickly</source>
        <translation>Calcular rápido</translation>
    </message>
    <message>
        <source>Run it all the same</source>
        <translation>Calcular de todos modos</translation>
    </message>
    <message>
        <source>This study takes %1 (%2). Larger cells, fewer days or a smaller region make it quicker.</source>
        <translation>Este estudio tarda %1 (%2). Celdas mayores, menos días o una zona menor lo aceleran.</translation>
    </message>
    <message>
        <source>Cancelled. The previous answer is shown.</source>
        <translation>Cancelado. Se muestra la respuesta anterior.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Cancelado.</translation>
    </message>
    <message>
        <source>The project holds what was measured: %1.</source>
        <translation>El proyecto contiene lo que se midió: %1.</translation>
    </message>
    <message>
        <source>The project holds %1 answers, all in the list of Results; among them %2.</source>
        <translation>El proyecto contiene %1 respuestas, todas en la lista de resultados; entre ellas %2.</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Mostrarla</translation>
    </message>
</context>
<context>
    <name>noonmark::StudyDock</name>
    <message>
        <source>Compute the minutes of shadow in every cell of the region (Ctrl+R)</source>
        <translation>Calcular los minutos de sombra en cada celda de la zona (Ctrl+R)</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Cuándo</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Dónde</translation>
    </message>
    <message>
        <source>How exactly</source>
        <translation>Con qué precisión</translation>
    </message>
    <message>
        <source>receivers</source>
        <translation>receptores</translation>
    </message>
    <message>
        <source>This method works on level ground only, but %1. Choose Quick or Reference.</source>
        <translation>Este método solo vale en suelo llano, pero %1. Elija Rápida o Referencia.</translation>
    </message>
    <message>
        <source>roofs are to be measured</source>
        <translation>se van a medir cubiertas</translation>
    </message>
    <message>
        <source>this city has terrain</source>
        <translation>esta ciudad tiene terreno</translation>
    </message>
    <message>
        <source>Choose a rule</source>
        <translation>Elegir una norma</translation>
    </message>
    <message>
        <source>Run again</source>
        <translation>Calcular de nuevo</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Run study</source>
        <translation>Calcular</translation>
    </message>
    <message>
        <source>This method measures no facades, windows or planes. Choose Quick or Reference.</source>
        <translation>Este método no mide fachadas, ventanas ni planos. Elija Rápida o Referencia.</translation>
    </message>
    <message>
        <source>period</source>
        <translation>periodo</translation>
    </message>
    <message>
        <source>Run (%1)</source>
        <translation>Calcular (%1)</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Calcular</translation>
    </message>
    <message>
        <source>Compute score</source>
        <translation>Calcular puntuación</translation>
    </message>
    <message>
        <source>The time that it takes is being estimated</source>
        <translation>Se está estimando el tiempo necesario</translation>
    </message>
</context>
<context>
    <name>noonmark::SunShadow</name>
    <message>
        <source>Drawing the shadow</source>
        <translation>Dibujando la sombra</translation>
    </message>
</context>
<context>
    <name>noonmark::SurfaceTracer</name>
    <message>
        <source>tracing rays</source>
        <translation>trazando rayos</translation>
    </message>
</context>
<context>
    <name>noonmark::TargetRow</name>
    <message>
        <source>Floor area</source>
        <translation>Superficie construida</translation>
    </message>
    <message>
        <source>FAR</source>
        <translation>FAR</translation>
    </message>
    <message>
        <source>Gross floor area, or floor area ratio: gross floor area divided by the lot&apos;s area</source>
        <translation>Superficie bruta, o edificabilidad: superficie bruta dividida por la de la parcela</translation>
    </message>
    <message>
        <source>Fit storeys</source>
        <translation>Ajustar plantas</translation>
    </message>
    <message>
        <source>The most storeys that stay within it</source>
        <translation>El mayor número de plantas que no lo supera</translation>
    </message>
    <message>
        <source>Fit plate</source>
        <translation>Ajustar planta tipo</translation>
    </message>
    <message>
        <source>The floor plate with which these storeys reach it</source>
        <translation>La planta tipo con la que estas plantas lo alcanzan</translation>
    </message>
    <message>
        <source> sq ft</source>
        <translation> ft²</translation>
    </message>
    <message>
        <source>What the tower shall have: type it, and storeys or plate are fitted; else what it has</source>
        <translation>Lo que debe tener la torre: al escribirlo se ajustan plantas o base; si no, lo que tiene</translation>
    </message>
</context>
<context>
    <name>noonmark::ThemeMenu</name>
    <message>
        <source>As the &amp;system</source>
        <translation>Como el &amp;sistema</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>C&amp;olours</source>
        <translation>&amp;Colores</translation>
    </message>
</context>
<context>
    <name>noonmark::TileDialog</name>
    <message>
        <source>Aerial photograph from tiles</source>
        <translation>Fotografía aérea desde teselas</translation>
    </message>
    <message>
        <source>Address of the tiles, with {z} for the zoom, {x} and {y} for the tile</source>
        <translation>Dirección de las teselas, con {z} para el nivel, {x} e {y} para la tesela</translation>
    </message>
    <message>
        <source>Whose tiles they are, as their owner asks for; printed wherever they are drawn</source>
        <translation>De quién son las teselas, como pide su propietario; se imprime donde se dibujen</translation>
    </message>
    <message>
        <source>Nothing is fetched before the button is pressed. Tiles of zoom %1: %2. Ask their owner whether you may store and print them.</source>
        <translation>No se descarga nada antes de pulsar el botón. Teselas del nivel %1: %2. Pregunte a su propietario si puede guardarlas e imprimirlas.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Attribution</source>
        <translation>Atribución</translation>
    </message>
    <message>
        <source>Fetch tiles</source>
        <translation>Descargar teselas</translation>
    </message>
    <message>
        <source>Fetches the tiles over the city from this address</source>
        <translation>Descarga de esta dirección las teselas sobre la ciudad</translation>
    </message>
</context>
<context>
    <name>noonmark::TileFetch</name>
    <message>
        <source>%1 is no picture of a tile</source>
        <translation>%1 no es la imagen de una tesela</translation>
    </message>
    <message>
        <source>The server has no tile of this place</source>
        <translation>El servidor no tiene ninguna tesela de este lugar</translation>
    </message>
</context>
<context>
    <name>noonmark::TimeDisplay</name>
    <message>
        <source>&amp;Play the sun</source>
        <translation>&amp;Reproducir el sol</translation>
    </message>
    <message>
        <source>Shift+Space</source>
        <translation>Shift+Space</translation>
    </message>
    <message>
        <source>Plays or stops the sun and its shadows</source>
        <translation>Reproduce o detiene el sol y sus sombras</translation>
    </message>
    <message>
        <source>Ten minutes &amp;later</source>
        <translation>Diez minutos &amp;después</translation>
    </message>
    <message>
        <source>The sun ten minutes later</source>
        <translation>El sol diez minutos después</translation>
    </message>
    <message>
        <source>Ten minutes &amp;earlier</source>
        <translation>Diez minutos &amp;antes</translation>
    </message>
    <message>
        <source>The sun ten minutes earlier</source>
        <translation>El sol diez minutos antes</translation>
    </message>
    <message>
        <source>&amp;Next day</source>
        <translation>Día &amp;siguiente</translation>
    </message>
    <message>
        <source>The sun at the same time of the next day</source>
        <translation>El sol a la misma hora del día siguiente</translation>
    </message>
    <message>
        <source>Previous &amp;day</source>
        <translation>Día an&amp;terior</translation>
    </message>
    <message>
        <source>The sun at the same time of the day before</source>
        <translation>El sol a la misma hora del día anterior</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>period</source>
        <translation>periodo</translation>
    </message>
    <message>
        <source>The sun is down or low there now, so this is noon: %1</source>
        <translation>El sol está allí ahora bajo o se ha puesto, así que esto es el mediodía: %1</translation>
    </message>
</context>
<context>
    <name>noonmark::TimeStrip</name>
    <message>
        <source>Whole period</source>
        <translation>Todo el periodo</translation>
    </message>
    <message>
        <source>One day</source>
        <translation>Un día</translation>
    </message>
    <message>
        <source>One moment</source>
        <translation>Un momento</translation>
    </message>
    <message>
        <source>What is shown: the whole period; one day of a study, from horizons cached in steps of half a degree;
or sun and shadow at one moment, on everything</source>
        <translation>Qué se muestra: todo el periodo; un día de un estudio, con horizontes guardados cada medio grado;
o el sol y la sombra en un momento, sobre todo</translation>
    </message>
    <message>
        <source>The date, in the year of the period. Arrows: a day; Page Up and Down: a month</source>
        <translation>La fecha, en el año del periodo. Flechas: un día; Re Pág y Av Pág: un mes</translation>
    </message>
    <message>
        <source>The wall-clock time; yellow: the sun is up. Arrows: a minute; Page Up and Down: an hour</source>
        <translation>La hora local; amarillo: el sol está fuera. Flechas: un minuto; Re Pág y Av Pág: una hora</translation>
    </message>
    <message>
        <source>Direction of the sun, clockwise from true north, and its altitude</source>
        <translation>Dirección del sol en sentido horario desde el norte verdadero, y su altura</translation>
    </message>
    <message>
        <source>Set as period</source>
        <translation>Usar como periodo</translation>
    </message>
    <message>
        <source>Makes this day or moment the period of the study; Run then computes its figures and errors</source>
        <translation>Convierte este día o momento en el periodo del estudio; Calcular da entonces cifras y errores</translation>
    </message>
    <message>
        <source>Plays the sun and its shadows (Shift+Space)</source>
        <translation>Reproduce el sol y sus sombras (Mayús+Espacio)</translation>
    </message>
    <message>
        <source>through the day</source>
        <translation>durante el día</translation>
    </message>
    <message>
        <source>through the year</source>
        <translation>durante el año</translation>
    </message>
    <message>
        <source>Play from sunrise to sunset of one date, or one time of day through the year</source>
        <translation>Reproducir de amanecer a ocaso de una fecha, o una hora a lo largo del año</translation>
    </message>
    <message>
        <source>slowly</source>
        <translation>lento</translation>
    </message>
    <message>
        <source>steadily</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>fast</source>
        <translation>rápido</translation>
    </message>
    <message>
        <source>Half an hour, an hour and a half or four hours of the day in a second;
of the year, as many weeks</source>
        <translation>Media hora, hora y media o cuatro horas del día en un segundo;
del año, otras tantas semanas</translation>
    </message>
    <message>
        <source>d MMM</source>
        <translation>d MMM</translation>
    </message>
    <message>
        <source>The date: 21 Dec, 12-21, or 21 for a day of this month</source>
        <translation>La fecha: 21 dic, 12-21, o 21 para un día de este mes</translation>
    </message>
    <message>
        <source>The wall-clock time: 14:30, 1430, or 14</source>
        <translation>La hora de reloj: 14:30, 1430 o 14</translation>
    </message>
</context>
<context>
    <name>noonmark::Tour</name>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 de %3)</translation>
    </message>
</context>
<context>
    <name>noonmark::TourBubble</name>
    <message>
        <source>Show me</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Does this step for you</source>
        <translation>Hace este paso por usted</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Terminar</translation>
    </message>
    <message>
        <source>End tour</source>
        <translation>Terminar visita</translation>
    </message>
    <message>
        <source>Help &gt; Guided tours starts it again</source>
        <translation>Ayuda &gt; Visitas guiadas la inicia de nuevo</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
</context>
<context>
    <name>noonmark::TowerDisplay</name>
    <message>
        <source>Store&amp;y lines</source>
        <translation>Líneas de forjado</translation>
    </message>
    <message>
        <source>Lines at the floors of proposed towers, and of imported buildings whose storey height is known</source>
        <translation>Líneas en los forjados de las torres propuestas y de los edificios importados cuya altura de planta se conoce</translation>
    </message>
    <message>
        <source>&amp;Heights above datum</source>
        <translation>Alt&amp;uras sobre el datum</translation>
    </message>
    <message>
        <source>Heights of buildings above the vertical zero of the project&apos;s terrain instead of above the ground under each building, as shown and as typed</source>
        <translation>Alturas de los edificios sobre el cero vertical del terreno del proyecto en lugar de sobre el suelo bajo cada edificio, al mostrarlas y al escribirlas</translation>
    </message>
</context>
<context>
    <name>noonmark::TowerEditing</name>
    <message>
        <source>Build %1</source>
        <translation>Construir %1</translation>
    </message>
</context>
<context>
    <name>noonmark::Tracer</name>
    <message>
        <source>tracing rays</source>
        <translation>trazando rayos</translation>
    </message>
</context>
<context>
    <name>noonmark::TreeActions</name>
    <message>
        <source>Add trees</source>
        <translation>Añadir árboles</translation>
    </message>
    <message>
        <source>Inventories of trees and canopy heights</source>
        <translation>Inventarios de árboles y alturas del dosel</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Listing fields</source>
        <translation>Listando campos</translation>
    </message>
    <message>
        <source>Reading trees</source>
        <translation>Leyendo árboles</translation>
    </message>
    <message>
        <source>add trees</source>
        <translation>añadir árboles</translation>
    </message>
</context>
<context>
    <name>noonmark::TreeEditing</name>
    <message numerus="yes">
        <source>plant %1 tree(s)</source>
        <translation>
            <numerusform>plantar %1 árbol</numerusform>
            <numerusform>plantar %1 árboles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>move %1 tree(s)</source>
        <translation>
            <numerusform>mover %1 árbol</numerusform>
            <numerusform>mover %1 árboles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>fell %1 tree(s)</source>
        <translation>
            <numerusform>talar %1 árbol</numerusform>
            <numerusform>talar %1 árboles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>replace %1 tree(s)</source>
        <translation>
            <numerusform>sustituir %1 árbol</numerusform>
            <numerusform>sustituir %1 árboles</numerusform>
        </translation>
    </message>
    <message>
        <source>let trees grow by %1 years</source>
        <translation>dejar crecer los árboles %1 años</translation>
    </message>
    <message>
        <source>Crowns of the other trees</source>
        <translation>Copas de los otros árboles</translation>
    </message>
    <message>
        <source>With trees and their seasons, while they move</source>
        <translation>Con árboles y sus estaciones, mientras se mueven</translation>
    </message>
    <message>
        <source>With trees as evergreens, while they move</source>
        <translation>Con árboles como perennes, mientras se mueven</translation>
    </message>
</context>
<context>
    <name>noonmark::TreeImportDialog</name>
    <message>
        <source>Add trees</source>
        <translation>Añadir árboles</translation>
    </message>
    <message>
        <source>as in the file (example: EPSG:2263)</source>
        <translation>como en el archivo (ejemplo: EPSG:2263)</translation>
    </message>
    <message>
        <source>Coordinate reference system, if the file does not state it</source>
        <translation>Sistema de referencia de coordenadas, si el archivo no lo indica</translation>
    </message>
    <message>
        <source>Coordinate system</source>
        <translation>Sistema de coordenadas</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Adds the trees to the existing city; Undo takes them back</source>
        <translation>Añade los árboles a la ciudad existente; Deshacer los retira</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>classes</source>
        <translation>clases</translation>
    </message>
    <message>
        <source>Unit of numbers without one</source>
        <translation>Unidad de los números sin unidad</translation>
    </message>
    <message>
        <source>Reading the trees...</source>
        <translation>Leyendo los árboles...</translation>
    </message>
</context>
<context>
    <name>noonmark::TreePanel</name>
    <message>
        <source>Species not known</source>
        <translation>Especie desconocida</translation>
    </message>
    <message>
        <source>evergreen</source>
        <translation>perenne</translation>
    </message>
    <message>
        <source>loses its leaves</source>
        <translation>pierde las hojas</translation>
    </message>
    <message>
        <source>%1, %2 high, crown %3, %4</source>
        <translation>%1, altura %2, copa %3, %4</translation>
    </message>
    <message>
        <source> years</source>
        <translation> años</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>Plantar</translation>
    </message>
    <message>
        <source>Each click on the ground plants a tree; Esc ends</source>
        <translation>Cada clic en el suelo planta un árbol; Esc termina</translation>
    </message>
    <message>
        <source>Plant a row</source>
        <translation>Plantar una hilera</translation>
    </message>
    <message>
        <source>Click the corners of a line; a double click or Enter plants trees along it</source>
        <translation>Haga clic en las esquinas de una línea; un doble clic o Intro planta árboles a lo largo de ella</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Sustituir</translation>
    </message>
    <message>
        <source>Puts trees with the measures above in place of the chosen ones</source>
        <translation>Pone árboles con las medidas de arriba en lugar de los elegidos</translation>
    </message>
    <message>
        <source>Fell</source>
        <translation>Talar</translation>
    </message>
    <message>
        <source>Removes the chosen trees (Delete)</source>
        <translation>Quita los árboles elegidos (Supr)</translation>
    </message>
    <message>
        <source>Let grow</source>
        <translation>Dejar crecer</translation>
    </message>
    <message>
        <source>The chosen trees after these years; all of the city if none is chosen</source>
        <translation>Los árboles elegidos después de estos años; todos los de la ciudad si no se ha elegido ninguno</translation>
    </message>
    <message>
        <source>Distance between the trees of a row</source>
        <translation>Distancia entre los árboles de una hilera</translation>
    </message>
    <message>
        <source>Years of growth, of which crown and height are estimated</source>
        <translation>Años de crecimiento, a partir de los cuales se estiman la copa y la altura</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Separación</translation>
    </message>
    <message numerus="yes">
        <source>%1 tree(s) in the city. Click one to choose it, Ctrl adds more</source>
        <translation>
            <numerusform>%1 árbol en la ciudad. Un clic lo elige</numerusform>
            <numerusform>%1 árboles en la ciudad. Un clic elige uno, Ctrl añade más</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 trees chosen</source>
        <translation>%1 árboles elegidos</translation>
    </message>
    <message>
        <source>Read trees of a file...</source>
        <translation>Leer árboles de un archivo...</translation>
    </message>
    <message>
        <source>Adds an inventory, OpenStreetMap or a raster of canopy heights to the existing city</source>
        <translation>Añade a la ciudad existente un inventario, OpenStreetMap o un ráster de alturas del dosel</translation>
    </message>
    <message>
        <source>The city has no trees yet. Plant some, or read those of a file</source>
        <translation>La ciudad aún no tiene árboles. Plante algunos o lea los de un archivo</translation>
    </message>
    <message>
        <source>loses its leaves (days of its own)</source>
        <translation>pierde las hojas (días propios)</translation>
    </message>
    <message>
        <source>Whole region</source>
        <translation>Toda la zona</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Sun, min a day</source>
        <translation>Sol, min al día</translation>
    </message>
    <message>
        <source>Shadow, min a day</source>
        <translation>Sombra, min al día</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
</context>
<context>
    <name>noonmark::UseTable</name>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Uso</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>Plantas</translation>
    </message>
    <message>
        <source>What the storeys are used for, from the ground floor up: retail 2, offices 10, homes the rest</source>
        <translation>Para qué se usan las plantas, desde la planta baja: comercio 2, oficinas 10, viviendas el resto</translation>
    </message>
    <message>
        <source>Add use</source>
        <translation>Añadir uso</translation>
    </message>
    <message>
        <source>Adds a use for the storeys above the others</source>
        <translation>Añade un uso para las plantas por encima de las demás</translation>
    </message>
    <message>
        <source>Removes the selected use, or the last one</source>
        <translation>Quita el uso seleccionado o el último</translation>
    </message>
    <message>
        <source>Retail</source>
        <translation>Comercio</translation>
    </message>
    <message>
        <source>Offices</source>
        <translation>Oficinas</translation>
    </message>
    <message>
        <source>Homes</source>
        <translation>Viviendas</translation>
    </message>
    <message>
        <source>Hotel</source>
        <translation>Hotel</translation>
    </message>
    <message>
        <source>Community</source>
        <translation>Equipamiento</translation>
    </message>
    <message>
        <source>Parking</source>
        <translation>Aparcamiento</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>Instalaciones</translation>
    </message>
    <message>
        <source>A use of the list, or any other text</source>
        <translation>Un uso de la lista o cualquier otro texto</translation>
    </message>
    <message>
        <source>the rest</source>
        <translation>el resto</translation>
    </message>
    <message>
        <source>How many storeys; 0: all storeys above, for the last use</source>
        <translation>Cuántas plantas; 0: todas las superiores, para el último uso</translation>
    </message>
</context>
<context>
    <name>noonmark::VerdictLinks</name>
    <message>
        <source>%1: %2 compared with %3</source>
        <translation>%1: %2 comparado con %3</translation>
    </message>
</context>
<context>
    <name>noonmark::VerdictTable</name>
    <message>
        <source>Place and day</source>
        <translation>Lugar y día</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Dictamen</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Día</translation>
    </message>
</context>
<context>
    <name>noonmark::ViewActions</name>
    <message>
        <source>Zoom to whole &amp;city</source>
        <translation>&amp;Toda la ciudad</translation>
    </message>
    <message>
        <source>&amp;North up</source>
        <translation>&amp;Norte arriba</translation>
    </message>
    <message>
        <source>&amp;Top view</source>
        <translation>&amp;Vista superior</translation>
    </message>
    <message>
        <source>Zoom to &amp;region</source>
        <translation>&amp;Zona del estudio</translation>
    </message>
    <message>
        <source>The study region seen from above</source>
        <translation>La zona del estudio vista desde arriba</translation>
    </message>
    <message>
        <source>&amp;Solid buildings</source>
        <translation>Edificios &amp;sólidos</translation>
    </message>
    <message>
        <source>Off: wireframe, so that the ground behind buildings is visible</source>
        <translation>No: alámbricos, para ver el suelo tras los edificios</translation>
    </message>
    <message>
        <source>&amp;Map on the ground</source>
        <translation>&amp;Mapa sobre el suelo</translation>
    </message>
    <message>
        <source>Streets, paths, parks, water and trees, drawn for orientation</source>
        <translation>Calles, caminos, parques, agua y árboles, como orientación</translation>
    </message>
    <message>
        <source>&amp;Explore by shadow accrual maps</source>
        <translation>&amp;Explorar con mapas de acumulación</translation>
    </message>
    <message>
        <source>As in the paper, instead of rays: inexact at shadow edges, but hours that look alike are computed once</source>
        <translation>Como en el artículo, en lugar de rayos: inexacto en los bordes, pero las horas parecidas se calculan una vez</translation>
    </message>
    <message>
        <source>Me&amp;asure distances</source>
        <translation>Med&amp;ir distancias</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>Click points on roofs, walls and ground: distance, height, area. Backspace removes the last point, a double click ends</source>
        <translation>Haga clic en puntos de tejados, paredes y suelo: distancia, altura, área. Retroceso quita el último punto, un doble clic termina</translation>
    </message>
    <message>
        <source>Section bo&amp;x</source>
        <translation>Ca&amp;ja de corte</translation>
    </message>
    <message>
        <source>Shift+X</source>
        <translation>Shift+X</translation>
    </message>
    <message>
        <source>Cuts away what lies outside a box, by handles or numbers; shadows remain those of the whole city</source>
        <translation>Recorta lo que queda fuera de una caja, con tiradores o números; las sombras siguen siendo las de toda la ciudad</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Árboles</translation>
    </message>
    <message>
        <source>The trees of the city, bare on days without leaves</source>
        <translation>Los árboles de la ciudad, desnudos en los días sin hojas</translation>
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
        <translation>Vista de la ciudad</translation>
    </message>
    <message>
        <source>Arrow keys pan, plus and minus zoom; Ctrl+F1 lists all keys</source>
        <translation>Las teclas de flecha desplazan, más y menos acercan y alejan; Ctrl+F1 muestra todas las teclas</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Zona</translation>
    </message>
</context>
<context>
    <name>noonmark::ViewPresets</name>
    <message>
        <source>From the &amp;south</source>
        <translation>Desde el &amp;sur</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>From the &amp;east</source>
        <translation>Desde el &amp;este</translation>
    </message>
    <message>
        <source>Shift+E</source>
        <translation>Shift+E</translation>
    </message>
    <message>
        <source>From the &amp;north</source>
        <translation>Desde el &amp;norte</translation>
    </message>
    <message>
        <source>Shift+N</source>
        <translation>Shift+N</translation>
    </message>
    <message>
        <source>From the &amp;west</source>
        <translation>Desde el &amp;oeste</translation>
    </message>
    <message>
        <source>Shift+W</source>
        <translation>Shift+W</translation>
    </message>
    <message>
        <source>From the s&amp;un</source>
        <translation>Desde el so&amp;l</translation>
    </message>
    <message>
        <source>As the sun sees the city at the date and time below the view: what is visible is sunlit</source>
        <translation>Como ve el sol la ciudad en la fecha y hora bajo la vista: lo visible está al sol</translation>
    </message>
    <message>
        <source>The sun is below the horizon at this date and time. Move the time below the view.</source>
        <translation>El sol está bajo el horizonte en esa fecha y hora. Cambie la hora bajo la vista.</translation>
    </message>
    <message>
        <source>Parallel pro&amp;jection</source>
        <translation>Pro&amp;yección paralela</translation>
    </message>
    <message>
        <source>Orthographic, as in plans and elevations: lengths across the view are to scale everywhere</source>
        <translation>Ortográfica, como en plantas y alzados: las longitudes perpendiculares a la vista están a escala en todas partes</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Planta</translation>
    </message>
    <message>
        <source>Shift+P</source>
        <translation>Shift+P</translation>
    </message>
    <message>
        <source>The same ground from straight above, north up, in parallel projection</source>
        <translation>El mismo suelo desde arriba, con el norte arriba, en proyección paralela</translation>
    </message>
    <message>
        <source>The same ground from this side; an elevation in parallel projection</source>
        <translation>El mismo suelo desde este lado; un alzado en proyección paralela</translation>
    </message>
</context>
<context>
    <name>noonmark::WarningsDock</name>
    <message>
        <source>Double-click a feature or press Enter to go to its building</source>
        <translation>Doble clic en un elemento o Intro va a su edificio</translation>
    </message>
    <message>
        <source>No warnings: nothing was left out, repaired or assumed</source>
        <translation>Sin avisos: no se omitió, reparó ni supuso nada</translation>
    </message>
</context>
<context>
    <name>noonmark::Watch</name>
    <message>
        <source>reading the picture</source>
        <translation>leyendo la imagen</translation>
    </message>
</context>
<context>
    <name>noonmark::Watcher</name>
    <message>
        <source>reading the terrain</source>
        <translation>leyendo el terreno</translation>
    </message>
    <message>
        <source>resampling the terrain</source>
        <translation>remuestreando el terreno</translation>
    </message>
</context>
<context>
    <name>noonmark::WeightCalendar</name>
    <message>
        <source>Weights by month and hour</source>
        <translation>Pesos por mes y hora</translation>
    </message>
    <message>
        <source>Drag to give months and hours the weight that is chosen below; drag with the right button to erase it. Keys: arrows, Shift, Enter, Delete, + and -</source>
        <translation>Arrastre para dar a meses y horas el peso elegido abajo; arrastre con el botón derecho para borrarlo. Teclas: flechas, Mayús, Intro, Supr, + y -</translation>
    </message>
    <message>
        <source>%1, %2:00 to %3:00</source>
        <translation>%1, de %2:00 a %3:00</translation>
    </message>
    <message>
        <source>no weight</source>
        <translation>sin peso</translation>
    </message>
    <message>
        <source>several weights, or none in part; mean %1</source>
        <translation>varios pesos, o ninguno en parte; media %1</translation>
    </message>
    <message>
        <source>weight %1</source>
        <translation>peso %1</translation>
    </message>
    <message>
        <source>sun wanted</source>
        <translation>sol deseado</translation>
    </message>
    <message>
        <source>shade wanted</source>
        <translation>sombra deseada</translation>
    </message>
</context>
<context>
    <name>noonmark::WeightsDock</name>
    <message>
        <source>Compute score</source>
        <translation>Calcular puntuación</translation>
    </message>
    <message>
        <source>Shadow of the displayed scenario over the study&apos;s region and period, weighted by this table: by month and as a map</source>
        <translation>Sombra del escenario mostrado en la zona y el periodo del estudio, ponderada con esta tabla: por mes y como mapa</translation>
    </message>
    <message>
        <source>The weight table to edit and to compute scores with; rename it with F2 in the project tree</source>
        <translation>La tabla de pesos que se edita y con la que se puntúa; cambie su nombre con F2 en el árbol del proyecto</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Adds an interval after the selected one: over days without a weight, else over half of its days</source>
        <translation>Añade un intervalo tras el seleccionado: en días sin peso o, si no, en la mitad de los suyos</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Removes the selected interval; its time then has no weight</source>
        <translation>Quita el intervalo seleccionado; su tiempo queda sin peso</translation>
    </message>
    <message>
        <source>New table</source>
        <translation>Tabla nueva</translation>
    </message>
    <message>
        <source>Adds a table that starts with the twelve months of the paper</source>
        <translation>Añade una tabla que parte de los doce meses del artículo</translation>
    </message>
    <message>
        <source>new weight table %1</source>
        <translation>tabla de pesos nueva %1</translation>
    </message>
    <message>
        <source>Cutting an interval in two changes the score, but not the weighted shade.</source>
        <translation>Dividir un intervalo en dos cambia la puntuación, pero no la sombra ponderada.</translation>
    </message>
    <message>
        <source>New from template</source>
        <translation>Nueva desde plantilla</translation>
    </message>
    <message>
        <source>Adds a table made for the latitude of this city, or a copy of a table of this project</source>
        <translation>Añade una tabla hecha para la latitud de esta ciudad o una copia de una tabla de este proyecto</translation>
    </message>
    <message>
        <source>Pedestrian comfort</source>
        <translation>Confort peatonal</translation>
    </message>
    <message>
        <source>Shade wanted in summer afternoons, sun in winter: a rule of thumb by latitude</source>
        <translation>Sombra deseada en las tardes de verano, sol en invierno: una regla práctica según la latitud</translation>
    </message>
    <message>
        <source>Plants</source>
        <translation>Plantas</translation>
    </message>
    <message>
        <source>Sun wanted in the growing season: a rule of thumb by latitude</source>
        <translation>Sol deseado en la época de crecimiento: una regla práctica según la latitud</translation>
    </message>
    <message>
        <source>As %1</source>
        <translation>Como %1</translation>
    </message>
    <message>
        <source>A copy, to be changed</source>
        <translation>Una copia para modificarla</translation>
    </message>
</context>
<context>
    <name>noonmark::WeightsModel</name>
    <message>
        <source>Interval</source>
        <translation>Intervalo</translation>
    </message>
    <message>
        <source>Name of the interval</source>
        <translation>Nombre del intervalo</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Primero</translation>
    </message>
    <message>
        <source>First day, every year: month and day such as 06-01, or a month such as June</source>
        <translation>Primer día, cada año: mes y día como 06-01, o un mes como June</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Último</translation>
    </message>
    <message>
        <source>Last day, included; before the first: across New Year. Such as 08-31, or a month such as August</source>
        <translation>Último día, incluido; anterior al primero: pasa por Año Nuevo. Como 08-31, o un mes como August</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>Time of day at which it begins, wall clock: 00:00 to 24:00</source>
        <translation>Hora a la que empieza: 00:00 a 24:00</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Time of day at which it ends: 00:00 to 24:00</source>
        <translation>Hora a la que termina: 00:00 a 24:00</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>-1 (shadow unwanted) to 1 (shade wanted)</source>
        <translation>-1 (sombra no deseada) a 1 (sombra deseada)</translation>
    </message>
    <message>
        <source>edit weights %1</source>
        <translation>editar pesos %1</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>fila %1</translation>
    </message>
</context>
<context>
    <name>noonmark::WhatForm</name>
    <message>
        <source>Hours of shadow</source>
        <translation>Horas de sombra</translation>
    </message>
    <message>
        <source>Change by a scenario</source>
        <translation>Cambio por un escenario</translation>
    </message>
    <message>
        <source>Score of wanted shadow</source>
        <translation>Puntuación de la sombra deseada</translation>
    </message>
    <message>
        <source>Review by a rule</source>
        <translation>Evaluación según una norma</translation>
    </message>
    <message>
        <source>Where shadow is measured. Changes and scores are measured on the ground only.
Facades, windows and planes are measured at points, each with its hours of sun.</source>
        <translation>Dónde se mide la sombra. Los cambios y puntuaciones se miden solo en el suelo.
Fachadas, ventanas y planos se miden en puntos, cada uno con sus horas de sol.</translation>
    </message>
    <message>
        <source>receivers</source>
        <translation>receptores</translation>
    </message>
    <message>
        <source>Sun by place</source>
        <translation>Sol por lugar</translation>
    </message>
</context>
<context>
    <name>noonmark::WhenForm</name>
    <message>
        <source>The days that are measured. The hours stay as they are</source>
        <translation>Los días que se miden. Las horas no cambian</translation>
    </message>
    <message>
        <source>The day and the hours of a review board&apos;s rule</source>
        <translation>El día y las horas de la norma de una autoridad</translation>
    </message>
    <message>
        <source>days</source>
        <translation>días</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>period</source>
        <translation>periodo</translation>
    </message>
    <message>
        <source>Days of a rule</source>
        <translation>Días de una norma</translation>
    </message>
</context>
<context>
    <name>noonmark::WhereForm</name>
    <message>
        <source>Place or region by name</source>
        <translation>Lugar o zona por nombre</translation>
    </message>
    <message>
        <source>A place or a region of the project. Type a part of its name.</source>
        <translation>Un lugar o una zona del proyecto. Escriba parte de su nombre.</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Dibujar</translation>
    </message>
    <message>
        <source>Click the corners of a polygon on the ground.
Double click, Enter or right click finishes, Backspace removes the last corner, Esc cancels.</source>
        <translation>Haga clic en las esquinas de un polígono sobre el suelo.
Doble clic, Intro o clic derecho termina, Retroceso quita la última esquina, Esc cancela.</translation>
    </message>
    <message>
        <source>What I see</source>
        <translation>Lo que veo</translation>
    </message>
    <message>
        <source>The ground visible in the view</source>
        <translation>El suelo visible en la vista</translation>
    </message>
    <message>
        <source>Whole city</source>
        <translation>Toda la ciudad</translation>
    </message>
    <message>
        <source>The bounding box of all buildings</source>
        <translation>El rectángulo que abarca todos los edificios</translation>
    </message>
    <message>
        <source>Around building</source>
        <translation>En torno al edificio</translation>
    </message>
    <message>
        <source>The selected building&apos;s surroundings, as far as four times its height.
Click a building first.</source>
        <translation>El entorno del edificio seleccionado, hasta cuatro veces su altura.
Haga clic antes en un edificio.</translation>
    </message>
</context>
<context>
    <name>noonmark::Workbench</name>
    <message>
        <source>Opening %1</source>
        <translation>Abriendo %1</translation>
    </message>
    <message>
        <source>Recovering</source>
        <translation>Recuperando</translation>
    </message>
    <message>
        <source>recover unsaved changes</source>
        <translation>recuperar cambios sin guardar</translation>
    </message>
    <message>
        <source>Unsaved changes recovered. Save keeps them, Undo discards them.</source>
        <translation>Cambios sin guardar recuperados. Guardar los conserva, Deshacer los descarta.</translation>
    </message>
    <message>
        <source>Showing %1</source>
        <translation>Mostrando %1</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message>
        <source>Estimating</source>
        <translation>Estimando</translation>
    </message>
    <message>
        <source>engine</source>
        <translation>motor</translation>
    </message>
    <message>
        <source>All scenarios</source>
        <translation>Todos los escenarios</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Guardando %1</translation>
    </message>
    <message>
        <source>save result %1</source>
        <translation>guardar resultado %1</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Exportando</translation>
    </message>
    <message>
        <source>Exported to %1: %2</source>
        <translation>Exportado a %1: %2</translation>
    </message>
    <message>
        <source>Finding the command</source>
        <translation>Buscando el comando</translation>
    </message>
    <message>
        <source>Comparing results with the buildings</source>
        <translation>Comparando los resultados con los edificios</translation>
    </message>
    <message>
        <source>%1 is saved with the project: the list above the results shows it again</source>
        <translation>%1 está guardado con el proyecto: la lista sobre los resultados lo vuelve a mostrar</translation>
    </message>
    <message>
        <source>months</source>
        <translation>meses</translation>
    </message>
    <message>
        <source>%1 is in the list of answers</source>
        <translation>%1 está en la lista de respuestas</translation>
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
        <translation>Sombra</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Share of the sunlit time</source>
        <translation>Parte del tiempo con sol</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source> min a day</source>
        <translation> min al día</translation>
    </message>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source> h a day</source>
        <translation> h al día</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>no contada</translation>
    </message>
    <message>
        <source>without trees, as evergreens, with seasons</source>
        <translation>sin árboles, como perennes, con estaciones</translation>
    </message>
    <message>
        <source>without trees</source>
        <translation>sin árboles</translation>
    </message>
    <message>
        <source>as evergreens</source>
        <translation>como perennes</translation>
    </message>
    <message>
        <source>with seasons</source>
        <translation>con estaciones</translation>
    </message>
    <message>
        <source>if neighbours&apos; ground heights differ</source>
        <translation>si difiere la cota de los vecinos</translation>
    </message>
    <message>
        <source>always</source>
        <translation>siempre</translation>
    </message>
    <message>
        <source>never (flat ground)</source>
        <translation>nunca (suelo llano)</translation>
    </message>
    <message>
        <source>as their bases fit the terrain</source>
        <translation>según encajen sus bases en el terreno</translation>
    </message>
    <message>
        <source>each set down on the terrain</source>
        <translation>cada uno apoyado en el terreno</translation>
    </message>
    <message>
        <source>at the elevations in the file</source>
        <translation>a las cotas del archivo</translation>
    </message>
    <message>
        <source>found by its steps at outlines</source>
        <translation>según sus saltos en los contornos</translation>
    </message>
    <message>
        <source>the bare ground</source>
        <translation>el suelo desnudo</translation>
    </message>
    <message>
        <source>a surface with buildings</source>
        <translation>una superficie con edificios</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
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
        <translation>Sol a índigo</translation>
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
        <translation>Gris</translation>
    </message>
    <message>
        <source>Green to red</source>
        <translation>Verde a rojo</translation>
    </message>
    <message>
        <source>Orange to violet</source>
        <translation>Naranja a violeta</translation>
    </message>
    <message>
        <source>Green-blue to brown</source>
        <translation>Verde azulado a marrón</translation>
    </message>
    <message>
        <source>Orange to purple</source>
        <translation>Naranja a púrpura</translation>
    </message>
    <message>
        <source>Blue to red</source>
        <translation>Azul a rojo</translation>
    </message>
    <message>
        <source>Green to red, pale in the middle</source>
        <translation>Verde a rojo, pálido en el centro</translation>
    </message>
    <message>
        <source>Gross shadow of a cell</source>
        <translation>Sombra bruta de una celda</translation>
    </message>
    <message>
        <source>Longest shadow of a cell</source>
        <translation>Sombra más larga de una celda</translation>
    </message>
    <message>
        <source>Shadow of a cell in a month</source>
        <translation>Sombra de una celda en un mes</translation>
    </message>
    <message>
        <source>Change of gross shadow of a cell</source>
        <translation>Cambio de la sombra bruta de una celda</translation>
    </message>
    <message>
        <source>Change of the longest shadow of a cell</source>
        <translation>Cambio de la sombra más larga de una celda</translation>
    </message>
    <message>
        <source>Score of a cell</source>
        <translation>Puntuación de una celda</translation>
    </message>
    <message>
        <source>Shadow score</source>
        <translation>Puntuación de sombra</translation>
    </message>
    <message>
        <source>Weighted shade</source>
        <translation>Sombra ponderada</translation>
    </message>
    <message>
        <source>Shadow area of a month</source>
        <translation>Área de sombra de un mes</translation>
    </message>
    <message>
        <source>Shadow score of a month</source>
        <translation>Puntuación de sombra de un mes</translation>
    </message>
    <message>
        <source>Weighted shade of a month</source>
        <translation>Sombra ponderada de un mes</translation>
    </message>
    <message>
        <source>Shadow area of an interval</source>
        <translation>Área de sombra de un intervalo</translation>
    </message>
    <message>
        <source>Shadow score of an interval</source>
        <translation>Puntuación de sombra de un intervalo</translation>
    </message>
    <message>
        <source>Weighted shade of an interval</source>
        <translation>Sombra ponderada de un intervalo</translation>
    </message>
    <message>
        <source>Least and most sun of a place, at a cell</source>
        <translation>Menos y más sol de un lugar, en una celda</translation>
    </message>
    <message>
        <source>Mean sun of a place</source>
        <translation>Sol medio de un lugar</translation>
    </message>
    <message>
        <source>Mean sun of a small place with cells of its own</source>
        <translation>Sol medio de un lugar pequeño con celdas propias</translation>
    </message>
    <message>
        <source>Mean sun of a place in a month</source>
        <translation>Sol medio de un lugar en un mes</translation>
    </message>
    <message>
        <source>Share of a place with enough sun</source>
        <translation>Parte de un lugar con sol suficiente</translation>
    </message>
    <message>
        <source>Mean sun of a place on a date</source>
        <translation>Sol medio de un lugar en una fecha</translation>
    </message>
    <message>
        <source>Share of a place with less than enough sun on a date</source>
        <translation>Parte de un lugar con sol insuficiente en una fecha</translation>
    </message>
    <message>
        <source>Change of the mean sun of a place</source>
        <translation>Cambio del sol medio de un lugar</translation>
    </message>
    <message>
        <source>Largest loss and gain of a place, at a cell</source>
        <translation>Mayor pérdida y ganancia de un lugar, en una celda</translation>
    </message>
    <message>
        <source>Share of a place that loses sun</source>
        <translation>Parte de un lugar que pierde sol</translation>
    </message>
    <message>
        <source>on the ground</source>
        <translation>en el suelo</translation>
    </message>
    <message>
        <source>on roofs</source>
        <translation>en las cubiertas</translation>
    </message>
    <message>
        <source>on the ground and roofs</source>
        <translation>en el suelo y las cubiertas</translation>
    </message>
    <message>
        <source>buildings stand on all of it</source>
        <translation>hay edificios en toda su superficie</translation>
    </message>
    <message>
        <source>no cell has its centre on its open ground</source>
        <translation>ninguna celda tiene su centro en su suelo libre</translation>
    </message>
    <message>
        <source>beyond the terrain: the nearest elevation is taken</source>
        <translation>fuera del terreno: se toma la elevación más próxima</translation>
    </message>
    <message>
        <source>mostly on water: measured at its surface</source>
        <translation>en su mayor parte sobre agua: medido en su superficie</translation>
    </message>
    <message>
        <source>elevations</source>
        <translation>cotas</translation>
    </message>
    <message>
        <source>above the ground</source>
        <translation>sobre el terreno</translation>
    </message>
    <message>
        <source>on facades</source>
        <translation>en fachadas</translation>
    </message>
    <message>
        <source>at windows of a file</source>
        <translation>en ventanas de un archivo</translation>
    </message>
    <message>
        <source>on a level plane</source>
        <translation>en un plano horizontal</translation>
    </message>
    <message>
        <source>on lines around a parcel</source>
        <translation>en líneas alrededor de una parcela</translation>
    </message>
    <message>
        <source>at single points</source>
        <translation>en puntos concretos</translation>
    </message>
    <message>
        <source>Hours of sun a day by month</source>
        <translation>Horas de sol al día por mes</translation>
    </message>
    <message>
        <source>first light of the disc (-0.833°)</source>
        <translation>primera luz (-0,833°)</translation>
    </message>
    <message>
        <source>middle of the disc (0°)</source>
        <translation>centro del disco (0°)</translation>
    </message>
    <message>
        <source>the eastings begin with the number of their zone, which was taken off</source>
        <translation>las coordenadas este empiezan por el número de su huso, que se quitó</translation>
    </message>
    <message>
        <source>Gross, trees as evergreens</source>
        <translation>Bruta, árboles como perennes</translation>
    </message>
    <message>
        <source>Gross, trees with their seasons</source>
        <translation>Bruta, árboles con sus estaciones</translation>
    </message>
    <message>
        <source>Sun, trees as evergreens</source>
        <translation>Sol, árboles como perennes</translation>
    </message>
    <message>
        <source>Sun, trees with their seasons</source>
        <translation>Sol, árboles con sus estaciones</translation>
    </message>
    <message>
        <source>trees as evergreens</source>
        <translation>árboles como perennes</translation>
    </message>
    <message>
        <source>trees with their seasons</source>
        <translation>árboles con sus estaciones</translation>
    </message>
    <message>
        <source>a wood is taken as closed canopy, in columns of 8 x 8 m</source>
        <translation>un bosque se toma como dosel cerrado, en columnas de 8 x 8 m</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Crown diameter</source>
        <translation>Diámetro de la copa</translation>
    </message>
    <message>
        <source>Crown base</source>
        <translation>Base de la copa</translation>
    </message>
    <message>
        <source>Stem diameter</source>
        <translation>Diámetro del tronco</translation>
    </message>
    <message>
        <source>Stem girth</source>
        <translation>Perímetro del tronco</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>Especie</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Género</translation>
    </message>
    <message>
        <source>Leaf cycle</source>
        <translation>Ciclo foliar</translation>
    </message>
    <message>
        <source>%1, carriageway</source>
        <translation>%1, calzada</translation>
    </message>
    <message>
        <source>%1, sidewalks</source>
        <translation>%1, aceras</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1, de %2 a %3</translation>
    </message>
    <message>
        <source>%1, at %2</source>
        <translation>%1, junto a %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
    <message>
        <source>%1, east of %2</source>
        <translation>%1, al este de %2</translation>
    </message>
    <message>
        <source>%1, north-east of %2</source>
        <translation>%1, al noreste de %2</translation>
    </message>
    <message>
        <source>%1, north of %2</source>
        <translation>%1, al norte de %2</translation>
    </message>
    <message>
        <source>%1, north-west of %2</source>
        <translation>%1, al noroeste de %2</translation>
    </message>
    <message>
        <source>%1, west of %2</source>
        <translation>%1, al oeste de %2</translation>
    </message>
    <message>
        <source>%1, south-west of %2</source>
        <translation>%1, al suroeste de %2</translation>
    </message>
    <message>
        <source>%1, south of %2</source>
        <translation>%1, al sur de %2</translation>
    </message>
    <message>
        <source>%1, south-east of %2</source>
        <translation>%1, al sureste de %2</translation>
    </message>
    <message>
        <source>evergreen</source>
        <translation>perenne</translation>
    </message>
    <message>
        <source>loses its leaves</source>
        <translation>pierde las hojas</translation>
    </message>
    <message>
        <source>First day in leaf</source>
        <translation>Primer día con hojas</translation>
    </message>
    <message>
        <source>First day without leaves</source>
        <translation>Primer día sin hojas</translation>
    </message>
    <message>
        <source>the whole city</source>
        <translation>toda la ciudad</translation>
    </message>
    <message>
        <source>the middle of the city</source>
        <translation>el centro de la ciudad</translation>
    </message>
    <message>
        <source>around the building</source>
        <translation>alrededor del edificio</translation>
    </message>
    <message>
        <source>around %1</source>
        <translation>alrededor de %1</translation>
    </message>
    <message>
        <source>That of the window</source>
        <translation>El de la ventana</translation>
    </message>
    <message>
        <source>Sun: azimuth %1°, altitude %2°</source>
        <translation>Sol: acimut %1°, altura %2°</translation>
    </message>
    <message>
        <source>%1 further pages are printed by the option --all-pages. </source>
        <translation>La opción --all-pages imprime %1 páginas más. </translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Dictamen</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Lugares</translation>
    </message>
    <message>
        <source>%1, generated by this program</source>
        <translation>%1, generado por este programa</translation>
    </message>
    <message>
        <source>%1, %2 bytes, SHA-256:</source>
        <translation>%1, %2 bytes, SHA-256:</translation>
    </message>
    <message>
        <source>%1 day</source>
        <translation>%1 día</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 días</translation>
    </message>
    <message>
        <source>%1 step</source>
        <translation>%1 paso</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 pasos</translation>
    </message>
    <message>
        <source>%1 value</source>
        <translation>%1 valor</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 valores</translation>
    </message>
    <message>
        <source>%1 edit</source>
        <translation>%1 cambio</translation>
    </message>
    <message>
        <source>%1 edits</source>
        <translation>%1 cambios</translation>
    </message>
    <message>
        <source>%1 place</source>
        <translation>%1 lugar</translation>
    </message>
    <message>
        <source>%1 places</source>
        <translation>%1 lugares</translation>
    </message>
    <message>
        <source>%1 building</source>
        <translation>%1 edificio</translation>
    </message>
    <message>
        <source>%1 buildings</source>
        <translation>%1 edificios</translation>
    </message>
    <message>
        <source>%1 part</source>
        <translation>%1 parte</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 partes</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source>sq ft</source>
        <translation>ft²</translation>
    </message>
    <message>
        <source>acres</source>
        <translation>acres</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>, one day in %1</source>
        <translation>, un día de cada %1</translation>
    </message>
    <message>
        <source>, half a year mirrored at 21 June</source>
        <translation>, medio año reflejado en el 21 de junio</translation>
    </message>
    <message>
        <source>; sun above %1 deg</source>
        <translation>; sol por encima de %1 grados</translation>
    </message>
    <message>
        <source>; sunrise: %1</source>
        <translation>; salida del sol: %1</translation>
    </message>
    <message>
        <source>, %1, %2 face</source>
        <translation>, %1, cara %2</translation>
    </message>
    <message>
        <source>, %1 m above the sill</source>
        <translation>, %1 m sobre el alféizar</translation>
    </message>
    <message>
        <source>, %1 m above the floor</source>
        <translation>, %1 m sobre el piso</translation>
    </message>
    <message>
        <source>, sun at least %1 deg from the pane</source>
        <translation>, sol a %1 grados como mínimo del vidrio</translation>
    </message>
    <message>
        <source>, sun at least arctan(wall / width) from the pane</source>
        <translation>, sol a arctan(pared / anchura) como mínimo del vidrio</translation>
    </message>
    <message>
        <source>; by %1</source>
        <translation>; por %1</translation>
    </message>
    <message>
        <source>; sill %1 m, wall %2 m, windows without a size %3 x %4 m</source>
        <translation>; alféizar %1 m, pared %2 m, ventanas sin tamaño %3 x %4 m</translation>
    </message>
    <message>
        <source> %1 m above mean ground</source>
        <translation> a %1 m sobre el suelo medio</translation>
    </message>
    <message>
        <source>; lines %1 and %2 m from the parcel</source>
        <translation>; líneas a %1 y %2 m de la parcela</translation>
    </message>
    <message>
        <source>, whose line moves out by %1 of the width of roads up to %2 m, to %3 m inside the far side of wider ones</source>
        <translation>, cuya línea avanza %1 veces la anchura de las calles de hasta %2 m, y hasta %3 m antes del lado lejano en las más anchas</translation>
    </message>
    <message>
        <source>; all places</source>
        <translation>; todos los lugares</translation>
    </message>
    <message>
        <source> or</source>
        <translation> o</translation>
    </message>
    <message>
        <source>: stated, no limit</source>
        <translation>: se indica, sin límite</translation>
    </message>
    <message>
        <source>; windows facing %1 to %2 deg</source>
        <translation>; ventanas orientadas de %1 a %2 grados</translation>
    </message>
    <message>
        <source> (does not decide)</source>
        <translation> (no decide)</translation>
    </message>
    <message>
        <source>days</source>
        <translation>días</translation>
    </message>
    <message>
        <source>clock</source>
        <translation>hora</translation>
    </message>
    <message>
        <source>step</source>
        <translation>paso</translation>
    </message>
    <message>
        <source>receivers</source>
        <translation>receptores</translation>
    </message>
    <message>
        <source>casters</source>
        <translation>obstáculos</translation>
    </message>
    <message>
        <source>trees</source>
        <translation>árboles</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>referencia</translation>
    </message>
    <message>
        <source>criterion</source>
        <translation>criterio</translation>
    </message>
    <message>
        <source>holds if</source>
        <translation>se cumple si</translation>
    </message>
    <message>
        <source>or</source>
        <translation>o</translation>
    </message>
    <message>
        <source>share</source>
        <translation>parte</translation>
    </message>
    <message>
        <source>sunshine</source>
        <translation>insolación</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>suma</translation>
    </message>
    <message>
        <source>table</source>
        <translation>tabla</translation>
    </message>
    <message>
        <source>diagrams</source>
        <translation>diagramas</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>opción</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Cifras</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>No comprobado</translation>
    </message>
    <message>
        <source>How the rule is read</source>
        <translation>Cómo se lee la norma</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>planta</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>abanico</translation>
    </message>
    <message>
        <source>isochrones</source>
        <translation>isócronas</translation>
    </message>
    <message>
        <source>view from the sun</source>
        <translation>vista desde el sol</translation>
    </message>
    <message>
        <source>hours</source>
        <translation>horas</translation>
    </message>
    <message>
        <source>, on full %1 min</source>
        <translation>, en múltiplos de %1 min</translation>
    </message>
    <message>
        <source> and </source>
        <translation> y </translation>
    </message>
    <message>
        <source>%1: %2 for at least %3 %</source>
        <translation>%1: %2 para al menos el %3 %</translation>
    </message>
    <message>
        <source>area x %1 h a year</source>
        <translation>área x %1 h al año</translation>
    </message>
    <message>
        <source>Least certain of what the verdicts rest on: %1 (%2: %3).</source>
        <translation>Lo menos seguro de aquello en que se basan los veredictos: %1 (%2: %3).</translation>
    </message>
    <message>
        <source>%1: %2; now %3</source>
        <translation>%1: %2; ahora %3</translation>
    </message>
    <message>
        <source>V: read in the rule&apos;s text or on an official page; R: reported by practice; U: not checked against the rule&apos;s text.</source>
        <translation>V: leído en el texto de la norma o en una página oficial; R: según la práctica; U: no comprobado con el texto de la norma.</translation>
    </message>
    <message>
        <source>figures only</source>
        <translation>solo valores</translation>
    </message>
    <message>
        <source>%1 x former</source>
        <translation>%1 x anterior</translation>
    </message>
    <message>
        <source>loss %1</source>
        <translation>pérdida %1</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 o %2</translation>
    </message>
    <message>
        <source> (former %1)</source>
        <translation> (anterior %1)</translation>
    </message>
    <message>
        <source> on %1</source>
        <translation> el %1</translation>
    </message>
    <message>
        <source>, wanted %1</source>
        <translation>, se exige %1</translation>
    </message>
    <message>
        <source>No sun in these hours</source>
        <translation>Sin sol en estas horas</translation>
    </message>
    <message>
        <source>The rule states no limit for this place</source>
        <translation>La norma no fija ningún límite para este lugar</translation>
    </message>
    <message>
        <source>read in the rule&apos;s text or on an official page</source>
        <translation>leído en el texto de la norma o en una página oficial</translation>
    </message>
    <message>
        <source>reported by practice</source>
        <translation>según la práctica</translation>
    </message>
    <message>
        <source>not checked against the rule&apos;s text</source>
        <translation>no comprobado con el texto de la norma</translation>
    </message>
    <message>
        <source>none counted</source>
        <translation>no se cuenta ninguno</translation>
    </message>
    <message>
        <source>evergreen trees only</source>
        <translation>solo árboles perennes</translation>
    </message>
    <message>
        <source>dense belts of evergreen trees only</source>
        <translation>solo cinturones densos de árboles perennes</translation>
    </message>
    <message>
        <source>all, as evergreens</source>
        <translation>todos, como perennes</translation>
    </message>
    <message>
        <source>all, with their seasons</source>
        <translation>todos, con sus estaciones</translation>
    </message>
    <message>
        <source>existing trees with their seasons, and new evergreens</source>
        <translation>árboles existentes con sus estaciones y nuevos perennes</translation>
    </message>
    <message>
        <source>sunrise</source>
        <translation>salida del sol</translation>
    </message>
    <message>
        <source>sunset</source>
        <translation>puesta del sol</translation>
    </message>
    <message>
        <source>the latest of</source>
        <translation>lo más tarde de</translation>
    </message>
    <message>
        <source>the earliest of</source>
        <translation>lo más pronto de</translation>
    </message>
    <message>
        <source>Trees: %1</source>
        <translation>Árboles: %1</translation>
    </message>
    <message>
        <source>; the city has no trees</source>
        <translation>; la ciudad no tiene árboles</translation>
    </message>
    <message>
        <source>; trees in the city: %1</source>
        <translation>; árboles en la ciudad: %1</translation>
    </message>
    <message>
        <source>; trees that count: %1 of %2</source>
        <translation>; árboles que cuentan: %1 de %2</translation>
    </message>
    <message>
        <source>The engine is the ray reference itself, against which others are measured.</source>
        <translation>El motor es la propia referencia de rayos, con la que se miden los demás.</translation>
    </message>
    <message>
        <source>The engine&apos;s error against the ray reference was not measured: it was switched off.</source>
        <translation>No se midió el error del motor frente a la referencia de rayos: estaba desactivado.</translation>
    </message>
    <message>
        <source>The engine&apos;s error against the ray reference could not be measured: see the warnings.</source>
        <translation>No se pudo medir el error del motor frente a la referencia de rayos: véanse los avisos.</translation>
    </message>
    <message>
        <source>Each run of minutes is uncertain by a step; each area by half of the cells that its edge passes through, at least by one; each area x hours by these and by half of what the area changes from step to step, where the days of a sum err independently of each other. </source>
        <translation>Cada duración es incierta en un paso; cada área, en la mitad de las celdas por las que pasa su borde, al menos en una; cada área x horas, en ambas cosas y en la mitad de lo que cambia el área de paso a paso, donde los días de una suma yerran con independencia. </translation>
    </message>
    <message>
        <source>Worst spots are the worst of the cells&apos; centres and of points around these, down to %1 m from each other; what the nearest found worse is in their error. </source>
        <translation>Los peores puntos son los peores de los centros de las celdas y de puntos alrededor, hasta a %1 m entre sí; lo que el más cercano halló peor está en su error. </translation>
    </message>
    <message>
        <source>Worst spots are the worst of the cells&apos; centres, and their error includes the cell. </source>
        <translation>Los peores puntos son los peores de los centros de las celdas, y su error incluye la celda. </translation>
    </message>
    <message>
        <source>Shadow enters and exits up to a step (%1 min) earlier than stated, as each step has the sun of its beginning. </source>
        <translation>La sombra entra y sale hasta un paso (%1 min) antes de lo indicado, ya que cada paso tiene el sol de su comienzo. </translation>
    </message>
    <message>
        <source>A value within its error of a limit is borderline, never pass.</source>
        <translation>Un valor que dista de un límite menos que su error está en el límite, nunca cumple.</translation>
    </message>
    <message>
        <source>the ground</source>
        <translation>el suelo</translation>
    </message>
    <message>
        <source>roofs</source>
        <translation>tejados</translation>
    </message>
    <message>
        <source>the ground and roofs</source>
        <translation>el suelo y los tejados</translation>
    </message>
    <message>
        <source>day %1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>no medido</translation>
    </message>
    <message>
        <source>%1 % mean, %2 % largest, against rays</source>
        <translation>%1 % de media, %2 % como máximo, frente a los rayos</translation>
    </message>
</context>
</TS>
