<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Error</name>
    <message>
        <source>No city is open</source>
        <translation>Keine Stadt ist geöffnet</translation>
    </message>
    <message>
        <source>Open a file or a sample first</source>
        <translation>Zuerst eine Datei oder ein Beispiel öffnen</translation>
    </message>
    <message>
        <source>This result is already saved</source>
        <translation>Dieses Ergebnis ist schon gespeichert</translation>
    </message>
    <message>
        <source>Another result is being saved</source>
        <translation>Ein anderes Ergebnis wird gerade gespeichert</translation>
    </message>
    <message>
        <source>Wait until it is saved</source>
        <translation>Warten, bis es gespeichert ist</translation>
    </message>
    <message>
        <source>There is no result to save</source>
        <translation>Es gibt kein Ergebnis zu speichern</translation>
    </message>
    <message>
        <source>There is no result to export</source>
        <translation>Es gibt kein Ergebnis zu exportieren</translation>
    </message>
    <message>
        <source>There are no figures to copy</source>
        <translation>Es gibt keine Zahlen zu kopieren</translation>
    </message>
    <message>
        <source>Press Run first</source>
        <translation>Zuerst Berechnen drücken</translation>
    </message>
    <message>
        <source>The file was not opened: the project was changed while it was read</source>
        <translation>Die Datei wurde nicht geöffnet: das Projekt wurde währenddessen geändert</translation>
    </message>
    <message>
        <source>Save or undo the change, then open the file again</source>
        <translation>Die Änderung speichern oder zurücknehmen und die Datei erneut öffnen</translation>
    </message>
    <message>
        <source>The picture could not be written</source>
        <translation>Das Bild konnte nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Einen anderen Ordner wählen</translation>
    </message>
    <message>
        <source>No ground of the city is visible</source>
        <translation>Kein Boden der Stadt ist sichtbar</translation>
    </message>
    <message>
        <source>Move the view to the city first</source>
        <translation>Zuerst die Ansicht zur Stadt bewegen</translation>
    </message>
    <message>
        <source>The project has no lots, and this rule is about parcels</source>
        <translation>Das Projekt hat keine Grundstücke, und diese Regel gilt für Flurstücke</translation>
    </message>
    <message>
        <source>Draw the lot of the proposal: Edit &gt; Draw lot</source>
        <translation>Das Grundstück des Entwurfs zeichnen: Bearbeiten &gt; Grundstück zeichnen</translation>
    </message>
    <message>
        <source>The project has no places yet</source>
        <translation>Das Projekt hat noch keine Orte</translation>
    </message>
    <message>
        <source>Read them from a map or draw one: Study &gt; Read places, Study &gt; Draw place</source>
        <translation>Aus einer Karte einlesen oder einen zeichnen: Untersuchung &gt; Orte einlesen, Untersuchung &gt; Ort zeichnen</translation>
    </message>
    <message>
        <source>No place is chosen</source>
        <translation>Kein Ort ist gewählt</translation>
    </message>
    <message>
        <source>Design a tower, or choose a scenario with a proposal</source>
        <translation>Einen Turm entwerfen oder ein Szenario mit einem Entwurf wählen</translation>
    </message>
    <message>
        <source>The building is still being designed</source>
        <translation>Das Gebäude wird noch entworfen</translation>
    </message>
    <message>
        <source>Build it, then run the review</source>
        <translation>Bauen, dann prüfen</translation>
    </message>
    <message>
        <source>There is no review to export</source>
        <translation>Es gibt keine Prüfung zu exportieren</translation>
    </message>
    <message>
        <source>Press Run review first</source>
        <translation>Zuerst Prüfen drücken</translation>
    </message>
    <message>
        <source>The sides of the lot cross each other</source>
        <translation>Die Seiten des Grundstücks kreuzen sich</translation>
    </message>
    <message>
        <source>Draw the corners in order around the lot</source>
        <translation>Die Ecken der Reihe nach um das Grundstück zeichnen</translation>
    </message>
    <message>
        <source>The polygon has no area</source>
        <translation>Das Polygon hat keine Fläche</translation>
    </message>
    <message>
        <source>Draw it again with corners farther apart</source>
        <translation>Mit weiter entfernten Ecken neu zeichnen</translation>
    </message>
    <message>
        <source>Click more corners, or press Esc</source>
        <translation>Weitere Ecken anklicken oder Esc drücken</translation>
    </message>
    <message>
        <source>There is no region or place of this name</source>
        <translation>Es gibt kein Gebiet und keinen Ort dieses Namens</translation>
    </message>
    <message>
        <source>Choose one from the list</source>
        <translation>Aus der Liste wählen</translation>
    </message>
    <message>
        <source>No corner is selected</source>
        <translation>Keine Ecke ist gewählt</translation>
    </message>
    <message>
        <source>Click a corner of the lot, then press Delete</source>
        <translation>Eine Ecke des Grundstücks anklicken, dann Entf drücken</translation>
    </message>
    <message>
        <source>The direction of the side is not known</source>
        <translation>Die Richtung der Seite ist nicht bekannt</translation>
    </message>
    <message>
        <source>Move the cursor to where the side leads, or type an azimuth: 40&lt;90</source>
        <translation>Den Zeiger dorthin bewegen, wohin die Seite führt, oder einen Azimut eingeben: 40&lt;90</translation>
    </message>
    <message>
        <source>This is not a length</source>
        <translation>Das ist keine Länge</translation>
    </message>
    <message>
        <source>Type it as 40, 40 m or 131&apos; 3&quot;, with an azimuth as 40&lt;90</source>
        <translation>Als 40, 40 m oder 131&apos; 3&quot; eingeben, mit Azimut als 40&lt;90</translation>
    </message>
    <message>
        <source>Some scenarios could not be computed</source>
        <translation>Einige Szenarien konnten nicht berechnet werden</translation>
    </message>
    <message>
        <source>The panel Scenarios says why in the row of each</source>
        <translation>Das Feld Szenarien nennt in jeder Zeile den Grund</translation>
    </message>
    <message>
        <source>The folder holds no buildings</source>
        <translation>Der Ordner enthält keine Gebäude</translation>
    </message>
    <message>
        <source>Choose a folder of footprints, city models or meshes</source>
        <translation>Einen Ordner mit Grundrissen, Stadtmodellen oder 3D-Modellen wählen</translation>
    </message>
    <message>
        <source>The city has a terrain already</source>
        <translation>Die Stadt hat schon ein Gelände</translation>
    </message>
    <message>
        <source>Open the city without it first</source>
        <translation>Zuerst die Stadt ohne das Gelände öffnen</translation>
    </message>
    <message>
        <source>A terrain can be added to city files only, before they are saved as a project</source>
        <translation>Ein Gelände kann nur zu Stadtdateien hinzugefügt werden, bevor sie als Projekt gespeichert sind</translation>
    </message>
    <message>
        <source>Open the city files and the terrain together</source>
        <translation>Die Stadtdateien und das Gelände zusammen öffnen</translation>
    </message>
    <message>
        <source>The city has an aerial photograph already</source>
        <translation>Die Stadt hat schon ein Luftbild</translation>
    </message>
    <message>
        <source>Remove it first: File &gt; Aerial photograph</source>
        <translation>Es zuerst entfernen: Datei &gt; Luftbild</translation>
    </message>
    <message>
        <source>The file holds no such places near the city</source>
        <translation>Die Datei enthält keine solchen Orte bei der Stadt</translation>
    </message>
    <message>
        <source>Choose a map of this city with parks or streets, or a file of polygons</source>
        <translation>Wählen Sie eine Karte dieser Stadt mit Parks oder Straßen oder eine Datei mit Polygonen</translation>
    </message>
    <message>
        <source>The project has no place of this name any more</source>
        <translation>Das Projekt hat keinen Ort dieses Namens mehr</translation>
    </message>
    <message>
        <source>Run again, so that the table lists the places as they are</source>
        <translation>Rechnen Sie neu, damit die Tabelle die Orte zeigt, wie sie sind</translation>
    </message>
    <message>
        <source>Tick the places to review, or press In reach to find those that the shadow reaches</source>
        <translation>Kreuzen Sie die zu prüfenden Orte an, oder drücken Sie „In Reichweite“, um die zu finden, die der Schatten erreicht</translation>
    </message>
    <message>
        <source>It holds terrains only: open one by Open, or choose a folder of footprints, city models or meshes</source>
        <translation>Er enthält nur Gelände: öffnen Sie eines mit Öffnen, oder wählen Sie einen Ordner mit Grundrissen, Stadtmodellen oder Netzen</translation>
    </message>
    <message>
        <source>There is no result</source>
        <translation>Es gibt kein Ergebnis</translation>
    </message>
</context>
<context>
    <name>FieldText</name>
    <message>
        <source>The rule of a review board by which the ticked places are judged. The list has the rules that come with Noonmark and those of your own.</source>
        <translation>Die Regel einer Behörde, nach der die angekreuzten Orte beurteilt werden. Die Liste enthält die mitgelieferten und Ihre eigenen Regeln.</translation>
    </message>
    <message>
        <source>The scenario with the proposal. Displayed: whichever is chosen at the top of the window.</source>
        <translation>Das Szenario mit dem Entwurf. Angezeigt: das oben im Fenster gewählte.</translation>
    </message>
    <message>
        <source>A choice that the rule leaves to the case, such as a district or a zone.</source>
        <translation>Eine Wahl, die die Regel dem Fall überlässt, etwa ein Bezirk oder eine Zone.</translation>
    </message>
    <message>
        <source>How exactly the shadow is computed. The line below the list says what each choice means; its error is measured and stated beside the legend.</source>
        <translation>Wie genau der Schatten berechnet wird. Die Zeile unter der Liste erklärt die Wahl; ihr Fehler wird gemessen und steht neben der Legende.</translation>
    </message>
    <message>
        <source>Shows or hides the time zone, the step of the sun and how sunrise is defined.</source>
        <translation>Zeigt oder verbirgt Zeitzone, Schrittweite der Sonne und die Definition des Sonnenaufgangs.</translation>
    </message>
    <message>
        <source>Shows or hides the method and its options, for experts.</source>
        <translation>Zeigt oder verbirgt das Verfahren und seine Optionen, für Fachleute.</translation>
    </message>
    <message>
        <source>What the chart of a range of days shows: shadow in the scenario, in the baseline, or what the scenario adds.</source>
        <translation>Was das Diagramm einer Spanne von Tagen zeigt: Schatten im Szenario, in der Ausgangslage oder was das Szenario hinzufügt.</translation>
    </message>
    <message>
        <source>The places with their verdicts, and below each its days with the numbers behind it. A click shows the timeline, a double click zooms to the place.</source>
        <translation>Die Orte mit ihren Befunden, darunter die Tage mit den Zahlen. Ein Klick zeigt den Zeitverlauf, ein Doppelklick den Ort von nahem.</translation>
    </message>
    <message>
        <source>What the proposal is compared with.</source>
        <translation>Womit der Entwurf verglichen wird.</translation>
    </message>
    <message>
        <source>Lists only the places whose name or kind contains this text.</source>
        <translation>Zeigt nur Orte, deren Name oder Art diesen Text enthält.</translation>
    </message>
    <message>
        <source>The places that the review judges: those with a tick.</source>
        <translation>Die Orte, die geprüft werden: die angekreuzten.</translation>
    </message>
    <message>
        <source>The size of the floor plate: as a share of the lot in per cent, or as an area in square metres.</source>
        <translation>Die Größe der Geschossplatte: als Anteil am Grundstück in Prozent oder als Fläche in Quadratmetern.</translation>
    </message>
    <message>
        <source>Adds a height above which the walls are set back from the edge of the plate.</source>
        <translation>Fügt eine Höhe hinzu, über der die Wände zurückspringen.</translation>
    </message>
    <message>
        <source>Removes the selected setback.</source>
        <translation>Entfernt den gewählten Rücksprung.</translation>
    </message>
    <message>
        <source>Heights, and how far the walls are set back above each, metres.</source>
        <translation>Höhen, und wie weit die Wände darüber zurückspringen, Meter.</translation>
    </message>
    <message>
        <source>Ends placing; the scenario stays as it is.</source>
        <translation>Beendet das Setzen; das Szenario bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>All that the project holds. Enter or a double click shows or uses a row, F2 renames it, Delete removes it, a right click has more.</source>
        <translation>Alles, was das Projekt enthält. Eingabe oder Doppelklick zeigt oder verwendet eine Zeile, F2 benennt um, Entf entfernt, ein Rechtsklick bietet mehr.</translation>
    </message>
    <message>
        <source>The scenarios side by side, with their figures for the same period and region. A click on a heading sorts them.</source>
        <translation>Die Szenarien nebeneinander, mit ihren Zahlen für denselben Zeitraum und dasselbe Gebiet. Ein Klick auf eine Überschrift sortiert.</translation>
    </message>
    <message>
        <source>The intervals of the weight table: days of the year, hours of the day, and a weight from -1 (shadow unwanted) to 1 (shade wanted). Double-click a cell to change it.</source>
        <translation>Die Intervalle der Gewichtstabelle: Tage des Jahres, Stunden des Tages und ein Gewicht von -1 (unerwünscht) bis 1 (erwünscht). Doppelklick ändert eine Zelle.</translation>
    </message>
    <message>
        <source>Does what the message proposes.</source>
        <translation>Tut, was die Meldung vorschlägt.</translation>
    </message>
    <message>
        <source>Does the other thing that the message proposes.</source>
        <translation>Tut das andere, was die Meldung vorschlägt.</translation>
    </message>
    <message>
        <source>The date that is shown, in the year of the period.</source>
        <translation>Das gezeigte Datum, im Jahr des Zeitraums.</translation>
    </message>
    <message>
        <source>The wall-clock time that is shown, in the time zone of the study.</source>
        <translation>Die gezeigte Uhrzeit, in der Zeitzone der Untersuchung.</translation>
    </message>
    <message>
        <source>The windows with their verdicts before and after, those that get worse first. A click on a column sorts by it, a click on a row tells when its window has sun.</source>
        <translation>Die Fenster mit ihren Befunden vorher und nachher, zuerst die, die schlechter werden. Ein Klick auf eine Spalte sortiert danach, ein Klick auf eine Zeile sagt, wann ihr Fenster Sonne hat.</translation>
    </message>
    <message>
        <source>The places with their hours of sun. A click on a heading sorts them, a click on a row shows its place in the view.</source>
        <translation>Die Orte mit ihren Sonnenstunden. Ein Klick auf eine Überschrift sortiert sie, ein Klick auf eine Zeile zeigt ihren Ort in der Ansicht.</translation>
    </message>
    <message>
        <source>The names of the scenarios, which stay in sight when the table is scrolled sideways. A double click shows a scenario.</source>
        <translation>Die Namen der Szenarien, die sichtbar bleiben, wenn die Tabelle seitlich verschoben wird. Ein Doppelklick zeigt ein Szenario.</translation>
    </message>
    <message>
        <source>What the study answers: minutes of shadow, the change that a scenario makes, a score of wanted and unwanted shadow, the verdicts of a board&apos;s rule, or the hours of sun of places.</source>
        <translation>Was die Untersuchung beantwortet: Minuten im Schatten, die Änderung durch ein Szenario, eine Bewertung erwünschten und unerwünschten Schattens, die Befunde nach der Regel einer Behörde oder die Sonnenstunden von Orten.</translation>
    </message>
</context>
<context>
    <name>KeySheet</name>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>left or middle drag</source>
        <translation>Ziehen mit linker oder mittlerer Taste</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>right drag, Shift+drag, arrow keys</source>
        <translation>Ziehen mit rechter Taste, Umschalt+Ziehen, Pfeiltasten</translation>
    </message>
    <message>
        <source>Zoom to the cursor</source>
        <translation>Zum Zeiger hin vergrößern</translation>
    </message>
    <message>
        <source>wheel, + and -</source>
        <translation>Mausrad, + und -</translation>
    </message>
    <message>
        <source>Menu of what is there</source>
        <translation>Menü dessen, was dort ist</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>Buildings</source>
        <translation>Gebäude</translation>
    </message>
    <message>
        <source>Select; another too</source>
        <translation>Auswählen; ein weiteres dazu</translation>
    </message>
    <message>
        <source>click; Ctrl+click</source>
        <translation>Klick; Strg+Klick</translation>
    </message>
    <message>
        <source>Select all in a rectangle</source>
        <translation>Alle in einem Rechteck auswählen</translation>
    </message>
    <message>
        <source>drag with Ctrl+Shift</source>
        <translation>Ziehen mit Strg+Umschalt</translation>
    </message>
    <message>
        <source>Change the height</source>
        <translation>Die Höhe ändern</translation>
    </message>
    <message>
        <source>drag the arrow, or type the height and press Enter</source>
        <translation>am Pfeil ziehen, oder die Höhe eingeben und Eingabe drücken</translation>
    </message>
    <message>
        <source>Deselect</source>
        <translation>Auswahl aufheben</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>A corner</source>
        <translation>Eine Ecke</translation>
    </message>
    <message>
        <source>click; with Shift at right angles, with Ctrl without snapping</source>
        <translation>Klick; mit Umschalt rechtwinklig, mit Strg ohne Einrasten</translation>
    </message>
    <message>
        <source>A side of a stated length</source>
        <translation>Eine Seite mit angegebener Länge</translation>
    </message>
    <message>
        <source>type it and press Enter</source>
        <translation>sie eingeben und Eingabe drücken</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>double click, Enter or right click</source>
        <translation>Doppelklick, Eingabe oder Rechtsklick</translation>
    </message>
    <message>
        <source>Remove the last corner; cancel</source>
        <translation>Letzte Ecke entfernen; abbrechen</translation>
    </message>
    <message>
        <source>Backspace; Esc</source>
        <translation>Rücktaste; Esc</translation>
    </message>
</context>
<context>
    <name>LiveTrees</name>
    <message>
        <source>Live shade of trees</source>
        <translation>Schatten der Bäume beim Ziehen</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Read &amp;places into this project</source>
        <translation>&amp;Orte in dieses Projekt einlesen</translation>
    </message>
    <message>
        <source>&amp;Open as another city</source>
        <translation>Als andere Stadt öffn&amp;en</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>from its storeys</source>
        <translation>aus den Geschossen</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>from its mesh</source>
        <translation>aus dem Modell</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>entworfen</translation>
    </message>
    <message>
        <source>synthetic</source>
        <translation>synthetisch</translation>
    </message>
    <message>
        <source>; mesh is open: %1 estimated</source>
        <translation>; Modell ist offen: %1 geschätzt</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Grundfläche</translation>
    </message>
    <message>
        <source>Floor area</source>
        <translation>Geschossfläche</translation>
    </message>
    <message>
        <source>every pixel</source>
        <translation>jedes Pixel</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a project or a city</source>
        <translation>Ein Projekt oder eine Stadt öffnen</translation>
    </message>
    <message>
        <source>Save project as</source>
        <translation>Projekt speichern unter</translation>
    </message>
    <message>
        <source>Projects (*%1)</source>
        <translation>Projekte (*%1)</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation>%1 ist schon vorhanden. Ersetzen?</translation>
    </message>
    <message>
        <source>Import a mesh as a building</source>
        <translation>Ein 3D-Modell als Gebäude einfügen</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>3D-Modelle</translation>
    </message>
    <message>
        <source>Region from file</source>
        <translation>Gebiet aus Datei</translation>
    </message>
    <message>
        <source>Polygons</source>
        <translation>Polygone</translation>
    </message>
    <message>
        <source>Read places</source>
        <translation>Orte einlesen</translation>
    </message>
    <message>
        <source>Maps and polygons</source>
        <translation>Karten und Polygone</translation>
    </message>
    <message>
        <source>Save sun and sky</source>
        <translation>Sonne und Himmel speichern</translation>
    </message>
    <message>
        <source>Drawing (*.svg);;Picture (*.png);;Minutes by month and hour (*.csv)</source>
        <translation>Zeichnung (*.svg);;Bild (*.png);;Minuten nach Monat und Stunde (*.csv)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Export movie</source>
        <translation>Film exportieren</translation>
    </message>
    <message>
        <source>Movies (*.mp4 *.gif)</source>
        <translation>Filme (*.mp4 *.gif)</translation>
    </message>
    <message>
        <source>Logo for the title block</source>
        <translation>Logo für das Schriftfeld</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Bilder (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>%1 already contains these files: %2. Replace them?</source>
        <translation>%1 enthält schon diese Dateien: %2. Ersetzen?</translation>
    </message>
    <message>
        <source>Projects, cities and terrain</source>
        <translation>Projekte, Städte und Gelände</translation>
    </message>
    <message>
        <source>Projects</source>
        <translation>Projekte</translation>
    </message>
    <message>
        <source>Footprints</source>
        <translation>Grundrisse</translation>
    </message>
    <message>
        <source>3D models and meshes</source>
        <translation>3D-Modelle</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Gelände</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Untersuchung</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Szenarien</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Gebäude</translation>
    </message>
    <message>
        <source>Tower</source>
        <translation>Turm</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>S&amp;un</source>
        <translation>S&amp;onne</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>Bedien&amp;felder</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>S&amp;cenario</source>
        <translation>S&amp;zenario</translation>
    </message>
    <message>
        <source>&amp;Study</source>
        <translation>&amp;Untersuchung</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Graphics: OpenGL on the processor; a graphics card is faster</source>
        <translation>Grafik: OpenGL auf dem Prozessor; eine Grafikkarte ist schneller</translation>
    </message>
    <message>
        <source>Graphics: OpenGL on a graphics card</source>
        <translation>Grafik: OpenGL auf einer Grafikkarte</translation>
    </message>
    <message>
        <source>System: %1, %2</source>
        <translation>System: %1, %2</translation>
    </message>
    <message>
        <source>this moment</source>
        <translation>diesem Zeitpunkt</translation>
    </message>
    <message>
        <source>%1; continuous shadow follows</source>
        <translation>%1; Dauerschatten folgt</translation>
    </message>
    <message>
        <source>west</source>
        <translation>West</translation>
    </message>
    <message>
        <source>east</source>
        <translation>Ost</translation>
    </message>
    <message>
        <source>south</source>
        <translation>Süd</translation>
    </message>
    <message>
        <source>north</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>Gross floor area</source>
        <translation>Bruttogrundfläche</translation>
    </message>
    <message>
        <source>Floor area ratio (FAR)</source>
        <translation>Geschossflächenzahl (GFZ)</translation>
    </message>
    <message>
        <source>Lot coverage</source>
        <translation>Überbauung des Grundstücks</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>Geschosse</translation>
    </message>
    <message>
        <source>Buildings demolished</source>
        <translation>Abgerissene Gebäude</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Anzeigen</translation>
    </message>
    <message>
        <source>&amp;Zoom to lot</source>
        <translation>&amp;Grundstück zeigen</translation>
    </message>
    <message>
        <source>&amp;Zoom to place</source>
        <translation>&amp;Ort zeigen</translation>
    </message>
    <message>
        <source>&amp;Use as study region</source>
        <translation>Als Unter&amp;suchungsgebiet verwenden</translation>
    </message>
    <message>
        <source>&amp;Use as study period</source>
        <translation>Als Untersuchungs&amp;zeitraum verwenden</translation>
    </message>
    <message>
        <source>&amp;Edit and score</source>
        <translation>&amp;Bearbeiten und bewerten</translation>
    </message>
    <message>
        <source>City</source>
        <translation>Stadt</translation>
    </message>
    <message>
        <source>The existing city, from which every scenario starts</source>
        <translation>Der Bestand, mit dem jedes Szenario beginnt</translation>
    </message>
    <message>
        <source>Terrain of %1 × %2 points</source>
        <translation>Gelände mit %1 × %2 Punkten</translation>
    </message>
    <message>
        <source>Flat ground</source>
        <translation>Ebener Boden</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>aus %1</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>Ausgangslage</translation>
    </message>
    <message>
        <source>Press Enter or double-click to show it</source>
        <translation>Eingabe oder Doppelklick zeigt es</translation>
    </message>
    <message>
        <source>Step %1 of %2; press Delete to remove it</source>
        <translation>Schritt %1 von %2; Entf entfernt ihn</translation>
    </message>
    <message>
        <source>Lists of changes to the city; the displayed one is bold</source>
        <translation>Listen von Änderungen an der Stadt; die angezeigte ist fett</translation>
    </message>
    <message>
        <source>The existing city. Press Enter or double-click to show it</source>
        <translation>Der Bestand. Eingabe oder Doppelklick zeigt ihn</translation>
    </message>
    <message>
        <source>Lots</source>
        <translation>Grundstücke</translation>
    </message>
    <message>
        <source>Ground to build on</source>
        <translation>Boden, der bebaut werden kann</translation>
    </message>
    <message>
        <source>%1, roads: %2</source>
        <translation>%1, Straßen: %2</translation>
    </message>
    <message>
        <source>Press Enter or double-click to zoom to it</source>
        <translation>Eingabe oder Doppelklick zeigt es von nahem</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Gebiete</translation>
    </message>
    <message>
        <source>Where shadow is measured</source>
        <translation>Wo Schatten gemessen wird</translation>
    </message>
    <message>
        <source>Press Enter or double-click to use it as the study region</source>
        <translation>Eingabe oder Doppelklick macht es zum Untersuchungsgebiet</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>Areas whose sunlight matters: parks, playgrounds, school grounds...</source>
        <translation>Flächen, deren Besonnung zählt: Parks, Spielplätze, Schulhöfe ...</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1
Press Enter or double-click to zoom to it</source>
        <translation>%1
Eingabe oder Doppelklick zeigt ihn von nahem</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>Zeiträume</translation>
    </message>
    <message>
        <source>Days and hours to study</source>
        <translation>Tage und Stunden der Untersuchung</translation>
    </message>
    <message>
        <source>%1
Press Enter or double-click to use it as the study period</source>
        <translation>%1
Eingabe oder Doppelklick macht ihn zum Untersuchungszeitraum</translation>
    </message>
    <message>
        <source>Weight tables</source>
        <translation>Gewichtstabellen</translation>
    </message>
    <message>
        <source>How much shade is wanted (up to 1) or shadow unwanted (down to -1), by time of year</source>
        <translation>Wie erwünscht Schatten (bis 1) oder wie unerwünscht er ist (bis -1), je nach Jahreszeit</translation>
    </message>
    <message>
        <source>Press Enter or double-click to edit it and compute scores with it</source>
        <translation>Eingabe oder Doppelklick öffnet sie zum Bearbeiten und Bewerten</translation>
    </message>
    <message>
        <source>Saved results</source>
        <translation>Gespeicherte Ergebnisse</translation>
    </message>
    <message>
        <source>Maps and figures saved in the project</source>
        <translation>Im Projekt gespeicherte Karten und Zahlen</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 verglichen mit %2</translation>
    </message>
    <message>
        <source>%1 of %2
Press Enter or double-click to show it again</source>
        <translation>%1 von %2
Eingabe oder Doppelklick zeigt es wieder</translation>
    </message>
    <message>
        <source>Contribution of this new building alone: ground with over %1 min a day more gross shadow than without it</source>
        <translation>Beitrag dieses neuen Gebäudes allein: Boden mit über %1 Minuten mehr Gesamtschatten am Tag als ohne es</translation>
    </message>
    <message>
        <source>no change</source>
        <translation>keine Änderung</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 mehr</translation>
    </message>
    <message>
        <source>%1 less</source>
        <translation>%1 weniger</translation>
    </message>
    <message>
        <source>Compared</source>
        <translation>Verglichen</translation>
    </message>
    <message>
        <source>%1
with %2</source>
        <translation>%1
mit %2</translation>
    </message>
    <message>
        <source>Minutes of the first minus minutes of the second, with the same engine, steps and cells</source>
        <translation>Minuten des ersten minus Minuten des zweiten, mit gleichem Verfahren, gleichen Schritten und Zellen</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Zeitraum</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Used for both</source>
        <translation>Für beide verwendet</translation>
    </message>
    <message>
        <source>Measured error against rays: %1 % of the area, %2 % of the minutes of a cell</source>
        <translation>Fehler gegen Strahlen: %1 % der Fläche, %2 % der Minuten einer Zelle</translation>
    </message>
    <message>
        <source>Continuous shadow was not counted</source>
        <translation>Dauerschatten wurde nicht gezählt</translation>
    </message>
    <message>
        <source>So far: %1 (%2 %)</source>
        <translation>Bisher: %1 (%2 %)</translation>
    </message>
    <message>
        <source>%1 with the weights %2</source>
        <translation>%1 mit den Gewichten %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>formerly ground, now built over</source>
        <translation>vorher Boden, jetzt überbaut</translation>
    </message>
    <message>
        <source>formerly building, now ground</source>
        <translation>vorher Gebäude, jetzt Boden</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>now in shadow</source>
        <translation>jetzt im Schatten</translation>
    </message>
    <message>
        <source>now in the sun</source>
        <translation>jetzt in der Sonne</translation>
    </message>
    <message>
        <source>change: gross %1 min a day</source>
        <translation>Änderung: gesamt %1 min am Tag</translation>
    </message>
    <message>
        <source>, continuous %1 min</source>
        <translation>, am Stück %1 min</translation>
    </message>
    <message>
        <source>So far: %1</source>
        <translation>Bisher: %1</translation>
    </message>
    <message>
        <source>Refining: %1</source>
        <translation>Wird feiner: %1</translation>
    </message>
    <message>
        <source>Computing the shadow in the view...</source>
        <translation>Der Schatten in der Ansicht wird berechnet ...</translation>
    </message>
    <message>
        <source>No study yet: choose a period and a region, then press Run (Ctrl+R)</source>
        <translation>Noch keine Untersuchung: Zeitraum und Gebiet wählen, dann Berechnen drücken (Strg+R)</translation>
    </message>
    <message>
        <source>Against the ray reference, on a sample of the receivers over the same steps</source>
        <translation>Gegen die Strahlreferenz, an einer Stichprobe der Messpunkte zu denselben Schritten</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Time taken by the engine</source>
        <translation>Rechenzeit des Verfahrens</translation>
    </message>
    <message>
        <source>Steps of the sun</source>
        <translation>Sonnenstände</translation>
    </message>
    <message>
        <source>Sunlit time</source>
        <translation>Besonnte Zeit</translation>
    </message>
    <message>
        <source> min/day</source>
        <translation> min/Tag</translation>
    </message>
    <message>
        <source>Mean minutes a day with the sun above the horizon: 100 % of the time</source>
        <translation>Mittlere Minuten am Tag mit Sonne über dem Horizont: 100 % der Zeit</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Bewertet</translation>
    </message>
    <message>
        <source>%1
with the weights %2</source>
        <translation>%1
mit den Gewichten %2</translation>
    </message>
    <message>
        <source>at an unknown date</source>
        <translation>zu unbekanntem Datum</translation>
    </message>
    <message>
        <source>Saved %1: %2</source>
        <translation>Gespeichert %1: %2</translation>
    </message>
    <message>
        <source>%1. Outdated</source>
        <translation>%1. Veraltet</translation>
    </message>
    <message>
        <source>Saved result</source>
        <translation>Gespeichertes Ergebnis</translation>
    </message>
    <message>
        <source>As saved in the project, not recomputed</source>
        <translation>Wie im Projekt gespeichert, nicht neu berechnet</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Gebiet</translation>
    </message>
    <message>
        <source>%1
cells of %2 m</source>
        <translation>%1
Zellen von %2 m</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>Computed by</source>
        <translation>Berechnet mit</translation>
    </message>
    <message>
        <source>%1, saved %2</source>
        <translation>%1, gespeichert %2</translation>
    </message>
    <message>
        <source>A result saved %1.</source>
        <translation>Ein Ergebnis, gespeichert %1.</translation>
    </message>
    <message>
        <source>Its inputs have not changed since.</source>
        <translation>Seine Eingaben haben sich seither nicht geändert.</translation>
    </message>
    <message>
        <source>Of a theoretical sum of %1, %2 % are in shadow in the baseline and %3 % in the scenario; incremental shadow takes %4 (%5 %)</source>
        <translation>Von einer theoretischen Summe von %1 liegen %2 % in der Ausgangslage und %3 % im Szenario im Schatten; zusätzlicher Schatten nimmt %4 (%5 %)</translation>
    </message>
    <message>
        <source>, most on %1</source>
        <translation>, am meisten am %1</translation>
    </message>
    <message>
        <source>✓ pass</source>
        <translation>✓ erfüllt</translation>
    </message>
    <message>
        <source>≈ borderline</source>
        <translation>≈ grenzwertig</translation>
    </message>
    <message>
        <source>✗ fail</source>
        <translation>✗ nicht erfüllt</translation>
    </message>
    <message>
        <source>– not applicable</source>
        <translation>– nicht anwendbar</translation>
    </message>
    <message>
        <source>? not checked</source>
        <translation>? nicht geprüft</translation>
    </message>
    <message>
        <source>building</source>
        <translation>Gebäude</translation>
    </message>
    <message>
        <source>building, %1</source>
        <translation>Gebäude, %1</translation>
    </message>
    <message>
        <source>lot</source>
        <translation>Grundstück</translation>
    </message>
    <message>
        <source>street</source>
        <translation>Straße</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>park</source>
        <translation>Park</translation>
    </message>
    <message>
        <source>playground</source>
        <translation>Spielplatz</translation>
    </message>
    <message>
        <source>schoolyard</source>
        <translation>Schulhof</translation>
    </message>
    <message>
        <source>plaza</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>cemetery</source>
        <translation>Friedhof</translation>
    </message>
    <message>
        <source>facade</source>
        <translation>Fassade</translation>
    </message>
    <message>
        <source>stained glass</source>
        <translation>Buntglas</translation>
    </message>
    <message>
        <source>other place</source>
        <translation>anderer Ort</translation>
    </message>
    <message>
        <source>No region yet</source>
        <translation>Noch kein Gebiet</translation>
    </message>
    <message>
        <source>%1 million</source>
        <translation>%1 Millionen</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1 %2 Rays would take %3.</source>
        <translation>%1 %2 Strahlen bräuchten %3.</translation>
    </message>
    <message>
        <source>days</source>
        <translation>Tage</translation>
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
        <translation>etwa %1 %2</translation>
    </message>
    <message>
        <source>about a second</source>
        <translation>etwa eine Sekunde</translation>
    </message>
    <message>
        <source>%1 %2: %3</source>
        <translation>%1 %2: %3</translation>
    </message>
    <message>
        <source>and %1 more, listed in study.json of an export</source>
        <translation>und %1 weitere, aufgeführt in study.json eines Exports</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Genau</translation>
    </message>
    <message>
        <source>Reference (rays)</source>
        <translation>Referenz (Strahlen)</translation>
    </message>
    <message>
        <source>Own settings</source>
        <translation>Eigene Einstellungen</translation>
    </message>
    <message>
        <source>Exact where that is quick; over long periods off by 0.04 % of the time on average, and the error is measured</source>
        <translation>Genau, wo das schnell geht; über lange Zeiträume im Mittel 0,04 % der Zeit daneben, und der Fehler wird gemessen</translation>
    </message>
    <message>
        <source>The outline of every shadow at every step, without rounding</source>
        <translation>Der Umriss jedes Schattens bei jedem Schritt, ohne Rundung</translation>
    </message>
    <message>
        <source>One ray for every cell and step: what the other ways are checked against</source>
        <translation>Ein Strahl je Zelle und Schritt: daran werden die anderen Verfahren geprüft</translation>
    </message>
    <message>
        <source>The method and the options chosen below</source>
        <translation>Das unten gewählte Verfahren mit seinen Optionen</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>21 March</source>
        <translation>21. März</translation>
    </message>
    <message>
        <source>21 June</source>
        <translation>21. Juni</translation>
    </message>
    <message>
        <source>21 December</source>
        <translation>21. Dezember</translation>
    </message>
    <message>
        <source>Growing season (October to April)</source>
        <translation>Vegetationszeit (Oktober bis April)</translation>
    </message>
    <message>
        <source>Growing season (April to October)</source>
        <translation>Vegetationszeit (April bis Oktober)</translation>
    </message>
    <message>
        <source>Whole year</source>
        <translation>Ganzes Jahr</translation>
    </message>
    <message>
        <source>Own dates</source>
        <translation>Eigene Stichtage</translation>
    </message>
    <message>
        <source>How many minutes each spot is in shadow on a mean day of the period, and the longest time without a break</source>
        <translation>Wie viele Minuten jede Stelle an einem mittleren Tag des Zeitraums im Schatten liegt, und die längste Zeit ohne Unterbrechung</translation>
    </message>
    <message>
        <source>Minutes of shadow that the scenario adds or takes away, against the city chosen under &quot;compare with&quot;</source>
        <translation>Minuten Schatten, die das Szenario hinzufügt oder wegnimmt, gegen die Stadt unter „verglichen mit“</translation>
    </message>
    <message>
        <source>Shadow weighed by hour and month: wanted in summer, unwanted in winter. Choose the weights in the panel Weights</source>
        <translation>Schatten nach Stunde und Monat gewichtet: im Sommer erwünscht, im Winter unerwünscht. Die Gewichte stehen im Feld Gewichte</translation>
    </message>
    <message>
        <source>Pass or fail of parks and other places by a board&apos;s rule. Choose it in the panel Review</source>
        <translation>Parks und andere Orte nach der Regel einer Behörde: erfüllt oder nicht. Die Regel steht im Feld Prüfung</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>NE</source>
        <translation>NO</translation>
    </message>
    <message>
        <source>E</source>
        <translation>O</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>SO</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>SW</source>
        <translation>SW</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>NW</source>
        <translation>NW</translation>
    </message>
    <message>
        <source>Sun below the horizon</source>
        <translation>Sonne unter dem Horizont</translation>
    </message>
    <message>
        <source>Sun %1° %2, %3° high</source>
        <translation>Sonne %1° %2, %3° hoch</translation>
    </message>
    <message>
        <source>%1 % in shadow</source>
        <translation>%1 % im Schatten</translation>
    </message>
    <message>
        <source>in shadow</source>
        <translation>im Schatten</translation>
    </message>
    <message>
        <source>in the sun</source>
        <translation>in der Sonne</translation>
    </message>
    <message>
        <source>gross %1 min a day</source>
        <translation>gesamt %1 min am Tag</translation>
    </message>
    <message>
        <source>Ray reference</source>
        <translation>Strahlreferenz</translation>
    </message>
    <message>
        <source>Shadow on the ground of the region, cell by cell, with figures, report and files.
Computed by the engine of the study when you press Run.</source>
        <translation>Schatten auf dem Boden des Gebiets, Zelle für Zelle, mit Zahlen, Bericht und Dateien.
Wird mit dem Verfahren der Untersuchung berechnet, wenn Sie Berechnen drücken.</translation>
    </message>
    <message>
        <source>in the middle of the picture</source>
        <translation>in der Mitte des Bildes</translation>
    </message>
    <message>
        <source>%1.
Default: %2</source>
        <translation>%1.
Vorgabe: %2</translation>
    </message>
    <message>
        <source>%1.
%2 to %3 %4, usually %5</source>
        <translation>%1.
%2 bis %3 %4, üblich %5</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> zu %1</translation>
    </message>
    <message>
        <source>d MMM</source>
        <translation>d. MMM</translation>
    </message>
    <message>
        <source>d MMMM</source>
        <translation>d. MMMM</translation>
    </message>
    <message>
        <source>d MMM yyyy</source>
        <translation>d. MMM yyyy</translation>
    </message>
    <message>
        <source>d MMMM yyyy</source>
        <translation>d. MMMM yyyy</translation>
    </message>
    <message>
        <source>%1, %2
%3 floor area, FAR %4</source>
        <translation>%1, %2
%3 Geschossfläche, GFZ %4</translation>
    </message>
    <message>
        <source>%1 %2, %3 %4</source>
        <translation>%1 %2, %3 %4</translation>
    </message>
    <message>
        <source>%1   height %2   x %3 m, y %4 m</source>
        <translation>%1   Höhe %2   x %3 m, y %4 m</translation>
    </message>
    <message>
        <source>%1, %2 high</source>
        <translation>%1, %2 hoch</translation>
    </message>
    <message>
        <source>Mo&amp;de</source>
        <translation>&amp;Modus</translation>
    </message>
    <message>
        <source>Guided &amp;tours</source>
        <translation>&amp;Führungen</translation>
    </message>
    <message>
        <source>Plan, elevat&amp;ions, from the sun</source>
        <translation>Grundriss, Ansich&amp;ten, von der Sonne</translation>
    </message>
    <message>
        <source>&amp;Go to this view</source>
        <translation>&amp;Zu dieser Ansicht</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>parallel</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>perspektivisch</translation>
    </message>
    <message>
        <source>%1, %2 %3</source>
        <translation>%1, %2 %3</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>%1
Press Enter or double-click to go to it</source>
        <translation>%1
Eingabe oder Doppelklick zeigt sie</translation>
    </message>
    <message>
        <source>%1, %2 up (%3 in space)</source>
        <translation>%1, %2 hinauf (%3 im Raum)</translation>
    </message>
    <message>
        <source>%1, %2 down (%3 in space)</source>
        <translation>%1, %2 hinab (%3 im Raum)</translation>
    </message>
    <message>
        <source>%1
All sides %2, area %3</source>
        <translation>%1
Alle Seiten %2, Fläche %3</translation>
    </message>
    <message>
        <source>%1 h of sun a day, at most %2 h without a break</source>
        <translation>%1 h Sonne am Tag, höchstens %2 h ohne Unterbrechung</translation>
    </message>
    <message>
        <source>floor %1, %2</source>
        <translation>Geschoss %1, %2</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Against the ray reference, on a sample of the points over the same steps</source>
        <translation>Gegen die Strahlenreferenz, an einer Stichprobe der Punkte über dieselben Schritte</translation>
    </message>
    <message>
        <source>Horizons of the points</source>
        <translation>Horizonte der Punkte</translation>
    </message>
    <message>
        <source>Windows from file</source>
        <translation>Fenster aus Datei</translation>
    </message>
    <message>
        <source>Points and polygons</source>
        <translation>Punkte und Polygone</translation>
    </message>
    <message>
        <source>Facades and points</source>
        <translation>Fassaden und Punkte</translation>
    </message>
    <message>
        <source>the floor plate is smaller</source>
        <translation>die Geschossplatte ist kleiner</translation>
    </message>
    <message>
        <source>the tower is not turned</source>
        <translation>der Turm ist nicht gedreht</translation>
    </message>
    <message>
        <source>upper setbacks are left out</source>
        <translation>obere Rücksprünge entfallen</translation>
    </message>
    <message>
        <source>To fit this lot: %1.</source>
        <translation>Damit er auf dieses Grundstück passt: %1.</translation>
    </message>
    <message>
        <source>Aerial photograph</source>
        <translation>Luftbild</translation>
    </message>
    <message>
        <source>Pictures with a position</source>
        <translation>Bilder mit Lage</translation>
    </message>
    <message>
        <source>Save the tiles as a photograph</source>
        <translation>Kacheln als Luftbild speichern</translation>
    </message>
    <message>
        <source>GeoTIFF (*.tif)</source>
        <translation>GeoTIFF (*.tif)</translation>
    </message>
    <message>
        <source>Points from file</source>
        <translation>Punkte aus Datei</translation>
    </message>
    <message>
        <source>Tables of points</source>
        <translation>Punkttabellen</translation>
    </message>
    <message>
        <source>the tower is not twisted</source>
        <translation>der Turm ist nicht in sich gedreht</translation>
    </message>
    <message>
        <source>Use not stated</source>
        <translation>Nutzung nicht angegeben</translation>
    </message>
    <message>
        <source>From, above datum</source>
        <translation>Ab, über Bezugsniveau</translation>
    </message>
    <message>
        <source>From height</source>
        <translation>Ab Höhe</translation>
    </message>
    <message>
        <source>Inset</source>
        <translation>Rücksprung</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Verjüngung</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Verdrehung</translation>
    </message>
    <message>
        <source>%1, section box</source>
        <translation>%1, Schnittbox</translation>
    </message>
    <message>
        <source>Camera, projection, section box and moment, saved with Ctrl+Shift+V</source>
        <translation>Kamera, Projektion, Schnittbox und Zeitpunkt, gespeichert mit Strg+Umschalt+V</translation>
    </message>
    <message>
        <source>%1, floor %2   before: %3, after: %4</source>
        <translation>%1, Geschoss %2   vorher: %3, nachher: %4</translation>
    </message>
    <message>
        <source> °</source>
        <translation> °</translation>
    </message>
    <message>
        <source>%1, top %2</source>
        <translation>%1, Oberkante %2</translation>
    </message>
    <message>
        <source>%1 above datum</source>
        <translation>%1 über Bezugsniveau</translation>
    </message>
    <message>
        <source>%1 above ground</source>
        <translation>%1 über Gelände</translation>
    </message>
    <message numerus="yes">
        <source>%1 more kind(s) of notes</source>
        <translation>
            <numerusform>%1 weitere Art von Hinweisen</numerusform>
            <numerusform>%1 weitere Arten von Hinweisen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 place(s) were read</source>
        <translation>
            <numerusform>%1 Ort wurde eingelesen</numerusform>
            <numerusform>%1 Orte wurden eingelesen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; %1 replace(s) earlier ones</source>
        <translation>
            <numerusform>; %1 ersetzt einen früheren</numerusform>
            <numerusform>; %1 ersetzen frühere</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a sample every %1 pixel(s)</source>
        <translation>
            <numerusform>ein Wert je %1 Pixel</numerusform>
            <numerusform>ein Wert je %1 Pixel</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 day(s); %3</source>
        <translation>
            <numerusform>%1 von %2 Tag; %3</numerusform>
            <numerusform>%1 von %2 Tagen; %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>all %1 step(s)</source>
        <translation>
            <numerusform>dem %1 Schritt</numerusform>
            <numerusform>allen %1 Schritten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 storey(s)</source>
        <translation>
            <numerusform>%1 Geschoss</numerusform>
            <numerusform>%1 Geschosse</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s)</source>
        <translation>
            <numerusform>%1 Gebäude</numerusform>
            <numerusform>%1 Gebäude</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 occlusion ray(s) divided by the engine&apos;s time</source>
        <translation>
            <numerusform>%1 Schattenstrahl durch die Zeit des Verfahrens</numerusform>
            <numerusform>%1 Schattenstrahlen durch die Zeit des Verfahrens</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Positions of the sun above the horizon; %1 below it was/were left out</source>
        <translation>
            <numerusform>Sonnenstände über dem Horizont; %1 darunter wurde ausgelassen</numerusform>
            <numerusform>Sonnenstände über dem Horizont; %1 darunter wurden ausgelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 window(s): %2</source>
        <translation>
            <numerusform>%1 Fenster: %2</numerusform>
            <numerusform>%1 Fenster: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 window(s): %2.</source>
        <translation>
            <numerusform>%1 Fenster: %2.</numerusform>
            <numerusform>%1 Fenster: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Compared with before, %1 get(s) worse and %2 better</source>
        <translation>
            <numerusform>Gegenüber vorher wird %1 schlechter und %2 besser</numerusform>
            <numerusform>Gegenüber vorher werden %1 schlechter und %2 besser</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1
%2 × %3, %4, %5 cell(s)</source>
        <translation>
            <numerusform>%1
%2 × %3, %4, %5 Zelle</numerusform>
            <numerusform>%1
%2 × %3, %4, %5 Zellen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 point(s)</source>
        <translation>
            <numerusform>%1 Punkt</numerusform>
            <numerusform>%1 Punkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cell(s)</source>
        <translation>
            <numerusform>%1 Zelle</numerusform>
            <numerusform>%1 Zellen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 position(s) of the sun</source>
        <translation>
            <numerusform>%1 Sonnenstand</numerusform>
            <numerusform>%1 Sonnenstände</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Not counted: %1 building(s) whose floors are not known</source>
        <translation>
            <numerusform>Nicht gezählt: %1 Gebäude, dessen Geschosse nicht bekannt sind</numerusform>
            <numerusform>Nicht gezählt: %1 Gebäude, deren Geschosse nicht bekannt sind</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>by rays</source>
        <translation>durch Strahlen</translation>
    </message>
    <message>
        <source>by shadow accrual maps</source>
        <translation>durch Schattenkarten (Shadow Accrual Maps)</translation>
    </message>
    <message>
        <source>%1, %2 m, %3</source>
        <translation>%1, %2 m, %3</translation>
    </message>
    <message>
        <source>, storeys of %1</source>
        <translation>, Geschosse von %1</translation>
    </message>
    <message>
        <source>; %1 without a storey on the ground</source>
        <translation>; %1 ohne Geschoss am Boden</translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s) selected</source>
        <translation>
            <numerusform>%1 Gebäude ausgewählt</numerusform>
            <numerusform>%1 Gebäude ausgewählt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 over %2 min</source>
        <translation>%1 über %2 min</translation>
    </message>
    <message>
        <source>No new shadow</source>
        <translation>Kein neuer Schatten</translation>
    </message>
    <message>
        <source>New shadow: %1</source>
        <translation>Neuer Schatten: %1</translation>
    </message>
    <message>
        <source>Worst spot: +%1 min a day</source>
        <translation>Stärkste Zunahme: +%1 min am Tag</translation>
    </message>
    <message>
        <source>Less shadow: %1</source>
        <translation>Weniger Schatten: %1</translation>
    </message>
    <message>
        <source>Less shadow a day: %1</source>
        <translation>Weniger Schatten am Tag: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2, up to +%3 min</source>
        <translation>%1: %2, bis zu +%3 min</translation>
    </message>
    <message>
        <source> (of the part that is measured)</source>
        <translation> (des gemessenen Teils)</translation>
    </message>
    <message numerus="yes">
        <source>and %1 more place(s)</source>
        <translation>
            <numerusform>und %1 weiterer Ort</numerusform>
            <numerusform>und %1 weitere Orte</numerusform>
        </translation>
    </message>
    <message>
        <source>exact at %1</source>
        <translation>genau an %1</translation>
    </message>
    <message numerus="yes">
        <source>exact at %1 of %2 step(s)</source>
        <translation>
            <numerusform>genau an %1 von %2 Schritt</numerusform>
            <numerusform>genau an %1 von %2 Schritten</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, within 0.25° of azimuth</source>
        <translation>%1, Azimut auf 0,25° genau</translation>
    </message>
    <message>
        <source>With the proposal: %1</source>
        <translation>Mit dem Entwurf: %1</translation>
    </message>
    <message>
        <source>Change by the proposal, compared with %1: %2</source>
        <translation>Änderung durch den Entwurf gegenüber %1: %2</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>sq ft</source>
        <translation>sq ft</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source>The change reaches beyond the ground that is measured</source>
        <translation>Die Änderung reicht über den gemessenen Boden hinaus</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>Measured error of the longest shadow against rays, of the longest day: %1 % in the mean, %2 % at the 99th percentile, %3 % at most</source>
        <translation>Gemessener Fehler des längsten Schattens gegenüber Strahlen, vom längsten Tag: %1 % im Mittel, %2 % im 99. Perzentil, höchstens %3 %</translation>
    </message>
    <message>
        <source>Measured error against rays: %1 % of the time in the sun</source>
        <translation>Gemessener Fehler gegenüber Strahlen: %1 % der Zeit in der Sonne</translation>
    </message>
    <message>
        <source>Outdated: buildings have changed</source>
        <translation>Veraltet: Gebäude haben sich geändert</translation>
    </message>
    <message>
        <source>%1. Outdated: buildings have changed</source>
        <translation>%1. Veraltet: Gebäude haben sich geändert</translation>
    </message>
    <message>
        <source>%1 &gt; %2 min: %3</source>
        <translation>%1 &gt; %2 min: %3</translation>
    </message>
    <message>
        <source>Saved result %1</source>
        <translation>Gespeichertes Ergebnis %1</translation>
    </message>
    <message>
        <source>The month&apos;s contribution to the score</source>
        <translation>Der Beitrag des Monats zur Bewertung</translation>
    </message>
    <message>
        <source>Interval of the table: its weight, and its contribution to the score</source>
        <translation>Intervall der Tabelle: sein Gewicht und sein Beitrag zum Wert</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>A cell: %1 %3 in the mean, 99 of 100 within %2 %3</source>
        <translation>Eine Zelle: %1 %3 im Mittel, 99 von 100 innerhalb von %2 %3</translation>
    </message>
    <message>
        <source>%1 h of sun a day (%2 % of the sunlit time)</source>
        <translation>%1 h Sonne am Tag (%2 % der besonnten Zeit)</translation>
    </message>
    <message>
        <source>, continuous shadow %1 min</source>
        <translation>, Dauerschatten %1 min</translation>
    </message>
    <message>
        <source>change: sun %1 min a day</source>
        <translation>Änderung: Sonne %1 min am Tag</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a term and its definition</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 min a day in shadow</source>
        <translation>%1 min am Tag im Schatten</translation>
    </message>
    <message>
        <source>%1 min a day in shadow, %2 % of the sunlit time</source>
        <translation>%1 min am Tag im Schatten, %2 % der besonnten Zeit</translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s) shade it; %2 takes the most, %3 %</source>
        <translation>
            <numerusform>%1 Gebäude wirft hier Schatten; %2 nimmt am meisten, %3 %</numerusform>
            <numerusform>%1 Gebäude werfen hier Schatten; %2 nimmt am meisten, %3 %</numerusform>
        </translation>
    </message>
    <message>
        <source>No building shades it in the period.</source>
        <translation>Kein Gebäude wirft im Zeitraum Schatten hierher.</translation>
    </message>
    <message>
        <source>The scenario minus the scenario without this building: what it adds alone, on ground that is open in both scenarios</source>
        <translation>Das Szenario minus das Szenario ohne dieses Gebäude: was es allein hinzufügt, auf Boden, der in beiden Szenarien frei ist</translation>
    </message>
    <message>
        <source>Share, %</source>
        <translation>Anteil, %</translation>
    </message>
    <message>
        <source>Share of the sum of what each new building adds alone</source>
        <translation>An dem, was die neuen Gebäude jeweils allein hinzufügen, alle zusammen</translation>
    </message>
    <message>
        <source>Adds, min a day</source>
        <translation>Zusatz, min am Tag</translation>
    </message>
    <message>
        <source>; mean over the cells</source>
        <translation>; Mittel über die Zellen</translation>
    </message>
    <message>
        <source>Adds a day</source>
        <translation>Zusatz am Tag</translation>
    </message>
    <message>
        <source>; area × hours a day</source>
        <translation>; Fläche × Stunden am Tag</translation>
    </message>
    <message>
        <source>Attributed by: %1
The study: %2</source>
        <translation>Zugerechnet mit: %1
Die Untersuchung: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 compared with %2: %3 min a day in shadow, mean over %4 cell(s).</source>
        <translation>
            <numerusform>%1 verglichen mit %2: %3 min am Tag im Schatten, Mittel über %4 Zelle.</numerusform>
            <numerusform>%1 verglichen mit %2: %3 min am Tag im Schatten, Mittel über %4 Zellen.</numerusform>
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
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>This method does not sum months. These do: %1.</source>
        <translation>Dieses Verfahren summiert keine Monate. Diese tun es: %1.</translation>
    </message>
    <message>
        <source>This method does not tell buildings apart. These do: %1.</source>
        <translation>Dieses Verfahren unterscheidet keine Gebäude. Diese tun es: %1.</translation>
    </message>
    <message>
        <source>Hours of sun a day of each park, street and other place: over the period, by month and on stated dates, in a table beside the map</source>
        <translation>Sonnenstunden am Tag von jedem Park, jeder Straße und jedem anderen Ort: über den Zeitraum, nach Monat und an angegebenen Tagen, in einer Tabelle neben der Karte</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>Beiträge</translation>
    </message>
    <message>
        <source>%1 h of sun a day</source>
        <translation>%1 h Sonne am Tag</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>%1, %2 without a cell</source>
        <translation>%1, %2 ohne Zelle</translation>
    </message>
    <message>
        <source>Each is a row of the panel Places</source>
        <translation>Jeder ist eine Zeile im Feld Orte</translation>
    </message>
    <message>
        <source>Without shadow</source>
        <translation>Ohne Schatten</translation>
    </message>
    <message>
        <source>Sun above the horizon, mean over the days</source>
        <translation>Sonne über dem Horizont, Mittel über die Tage</translation>
    </message>
    <message>
        <source>Least sun</source>
        <translation>Wenigste Sonne</translation>
    </message>
    <message>
        <source>Most sun</source>
        <translation>Meiste Sonne</translation>
    </message>
    <message>
        <source>Against the ray reference, on a sample of the cells over the same steps</source>
        <translation>Gegen die Strahlreferenz, an einer Stichprobe der Zellen zu denselben Schritten</translation>
    </message>
    <message>
        <source>Time taken by all of it</source>
        <translation>Zeitbedarf insgesamt</translation>
    </message>
    <message>
        <source>Parks</source>
        <translation>Parks</translation>
    </message>
    <message>
        <source>Playgrounds</source>
        <translation>Spielplätze</translation>
    </message>
    <message>
        <source>Schoolyards</source>
        <translation>Schulhöfe</translation>
    </message>
    <message>
        <source>Plazas</source>
        <translation>Plätze</translation>
    </message>
    <message>
        <source>Cemeteries</source>
        <translation>Friedhöfe</translation>
    </message>
    <message>
        <source>Streets</source>
        <translation>Straßen</translation>
    </message>
    <message>
        <source>Facades</source>
        <translation>Fassaden</translation>
    </message>
    <message>
        <source>Stained glass</source>
        <translation>Buntglasfenster</translation>
    </message>
    <message>
        <source>Other places</source>
        <translation>Andere Orte</translation>
    </message>
    <message>
        <source>&amp;Copy the values</source>
        <translation>Werte &amp;kopieren</translation>
    </message>
    <message>
        <source>Contribution of this new building alone: ground that loses over %1 min of sun a day by it</source>
        <translation>Beitrag dieses neuen Gebäudes allein: Boden, der durch es mehr als %1 min Sonne am Tag verliert</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Export buildings</source>
        <translation>Gebäude exportieren</translation>
    </message>
    <message>
        <source>Attributed by: %1</source>
        <translation>Zugerechnet mit: %1</translation>
    </message>
    <message>
        <source>– figures only</source>
        <translation>– nur Zahlen</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>Fehler: %1</translation>
    </message>
    <message numerus="yes">
        <source>Against the ray reference, of a sample of %1 value(s)</source>
        <translation>
            <numerusform>Gegen die Strahlenreferenz, an einer Stichprobe von %1 Wert</numerusform>
            <numerusform>Gegen die Strahlenreferenz, an einer Stichprobe von %1 Werten</numerusform>
        </translation>
    </message>
    <message>
        <source>lawn or bed</source>
        <translation>Rasen oder Beet</translation>
    </message>
    <message>
        <source>Lawns and beds</source>
        <translation>Rasen und Beete</translation>
    </message>
    <message>
        <source>the whole lot</source>
        <translation>das ganze Grundstück</translation>
    </message>
    <message>
        <source> (top: %1)</source>
        <translation> (oberstes: %1)</translation>
    </message>
    <message>
        <source>%1   %2</source>
        <translation>%1   %2</translation>
    </message>
    <message>
        <source>Hides these panels, for more of the view, and shows them again</source>
        <translation>Verbirgt diese Felder für mehr Platz in der Ansicht und zeigt sie wieder</translation>
    </message>
    <message>
        <source>Panels at the left</source>
        <translation>Felder links</translation>
    </message>
    <message>
        <source>Panels at the right</source>
        <translation>Felder rechts</translation>
    </message>
    <message>
        <source>Panels below</source>
        <translation>Felder unten</translation>
    </message>
    <message>
        <source>As&amp;k</source>
        <translation>&amp;Fragen</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>takes %1 min of sun a day, %2 % of its shadow</source>
        <translation>nimmt %1 min Sonne am Tag, %2 % seines Schattens</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>%1 million rays a second</source>
        <translation>%1 Millionen Strahlen je Sekunde</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Sun and shadow of a moment or a period on all visible surfaces: ground, roofs and facades.
Updated when the view or the time changes, coarse at first, then pixel by pixel.</source>
        <translation>Sonne und Schatten eines Zeitpunkts oder Zeitraums auf allen sichtbaren Flächen: Boden, Dächern und Fassaden.
Aktualisiert, wenn sich Ansicht oder Zeit ändern, zuerst grob, dann Pixel für Pixel.</translation>
    </message>
    <message>
        <source>Verdicts by the rules of review boards, of a proposal or of the existing city.
Opens the panel Review.</source>
        <translation>Befunde nach den Regeln von Behörden, zu einem Entwurf oder zum Bestand.
Öffnet das Feld Prüfung.</translation>
    </message>
    <message>
        <source>Heights of buildings:</source>
        <translation>Höhen der Gebäude:</translation>
    </message>
    <message>
        <source>height %1</source>
        <translation>Höhe %1</translation>
    </message>
    <message numerus="yes">
        <source>; %1 place(s) were there before and stay as they are</source>
        <translation>
            <numerusform>; %1 davon war schon da und bleibt, wie er ist</numerusform>
            <numerusform>; %1 davon waren schon da und bleiben, wie sie sind</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 h of sun a day, %2 % of the sunlit time</source>
        <translation>%1 h Sonne am Tag, %2 % der Sonnenzeit</translation>
    </message>
    <message numerus="yes">
        <source>%1 compared with %2: %3 min of sun a day, mean over %4 cell(s).</source>
        <translation>
            <numerusform>%1 verglichen mit %2: %3 min Sonne am Tag, Mittel über %4 Zelle.</numerusform>
            <numerusform>%1 verglichen mit %2: %3 min Sonne am Tag, Mittel über %4 Zellen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cell(s); in the study itself %2.</source>
        <translation>
            <numerusform>%1 Zelle; in der Untersuchung selbst %2.</numerusform>
            <numerusform>%1 Zellen; in der Untersuchung selbst %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: minutes of shadow</source>
        <translation>%1: Minuten Schatten</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>&amp;Ebene</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Einlesen</translation>
    </message>
    <message>
        <source>%1 (%2 features)</source>
        <translation>%1 (%2 Objekte)</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Art</translation>
    </message>
    <message>
        <source>Found automatically</source>
        <translation>Automatisch gefunden</translation>
    </message>
    <message>
        <source>%1 min of shadow a day</source>
        <translation>%1 min Schatten am Tag</translation>
    </message>
    <message>
        <source>Max shadow</source>
        <translation>Größter Schatten</translation>
    </message>
    <message>
        <source>Min shadow</source>
        <translation>Geringster Schatten</translation>
    </message>
    <message>
        <source>Mean shadow</source>
        <translation>Mittlerer Schatten</translation>
    </message>
    <message>
        <source>Most shadow</source>
        <translation>Größter Schatten</translation>
    </message>
    <message>
        <source>The place with least sun in the mean</source>
        <translation>Der Ort mit der im Mittel wenigsten Sonne</translation>
    </message>
    <message>
        <source>Least shadow</source>
        <translation>Wenigster Schatten</translation>
    </message>
    <message>
        <source>The place with most sun in the mean</source>
        <translation>Der Ort mit der im Mittel meisten Sonne</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Bäume</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>score %1 m² a m²</source>
        <translation>Bewertung %1 m² je m²</translation>
    </message>
    <message>
        <source>&amp;Heights of the trees&apos; canopy</source>
        <translation>&amp;Höhen des Kronendachs</translation>
    </message>
    <message>
        <source>&amp;Trees</source>
        <translation>&amp;Bäume</translation>
    </message>
    <message>
        <source>T&amp;errain</source>
        <translation>&amp;Gelände</translation>
    </message>
    <message>
        <source>&amp;Places</source>
        <translation>&amp;Orte</translation>
    </message>
    <message>
        <source>%1: OpenStreetMap, whose tags are known.</source>
        <translation>%1: OpenStreetMap, dessen Attribute bekannt sind.</translation>
    </message>
    <message>
        <source>%1: a raster. Its cells are taken for heights of the canopy above the ground.</source>
        <translation>%1: ein Raster. Seine Zellen gelten als Höhen des Kronendachs über dem Boden.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 feature(s) in layer %3.</source>
        <translation>
            <numerusform>%1: %2 Objekt in der Ebene %3.</numerusform>
            <numerusform>%1: %2 Objekte in der Ebene %3.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 measured</source>
        <translation>%1 gemessen</translation>
    </message>
    <message>
        <source>%1 estimated</source>
        <translation>%1 geschätzt</translation>
    </message>
    <message>
        <source>%1 assumed</source>
        <translation>%1 angenommen</translation>
    </message>
    <message numerus="yes">
        <source>%1 tree(s) are added.</source>
        <translation>
            <numerusform>%1 Baum kommt hinzu.</numerusform>
            <numerusform>%1 Bäume kommen hinzu.</numerusform>
        </translation>
    </message>
    <message>
        <source>Heights: %1 (%2)</source>
        <translation>Höhen: %1 (%2)</translation>
    </message>
    <message>
        <source>Crowns: %1 (%2)</source>
        <translation>Kronen: %1 (%2)</translation>
    </message>
    <message>
        <source>not counted: no storey stands on the ground</source>
        <translation>nicht gezählt: kein Geschoss steht auf dem Boden</translation>
    </message>
    <message>
        <source>%1 as it stands</source>
        <translation>%1 im jetzigen Zustand</translation>
    </message>
    <message>
        <source>Without trees: %1</source>
        <translation>Ohne Bäume: %1</translation>
    </message>
    <message>
        <source>sunrise to sunset</source>
        <translation>Sonnenaufgang bis Sonnenuntergang</translation>
    </message>
    <message>
        <source>; sun comes back on %1 (%2 %)</source>
        <translation>; auf %1 kommt Sonne zurück (%2 %)</translation>
    </message>
    <message>
        <source>New shadow a day, by cells of %1: %2</source>
        <translation>Neuer Schatten am Tag, nach Zellen von %1: %2</translation>
    </message>
    <message>
        <source>Existing</source>
        <translation>Bestand</translation>
    </message>
    <message>
        <source>every %1 min</source>
        <translation>alle %1 min</translation>
    </message>
    <message>
        <source>no refraction</source>
        <translation>ohne Refraktion</translation>
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
            <numerusform>%1 Baum nimmt ihm Sonne, %2 % des Schattens.</numerusform>
            <numerusform>%1 Bäume nehmen ihm Sonne, %2 % des Schattens.</numerusform>
        </translation>
    </message>
    <message>
        <source>Tree %1</source>
        <comment>its species or number</comment>
        <translation>Baum %1</translation>
    </message>
    <message>
        <source>Least sure: %1 (%2, %3)</source>
        <translation>Am wenigsten gesichert: %1 (%2, %3)</translation>
    </message>
    <message>
        <source>Verdicts</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>; highest part %1</source>
        <translation>; höchster Teil %1</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Höhenlage</translation>
    </message>
    <message>
        <source>%1 to %2 above datum</source>
        <translation>%1 bis %2 über Höhennull</translation>
    </message>
    <message>
        <source>%1 against its empty lot</source>
        <translation>%1 gegenüber dem leeren Grundstück</translation>
    </message>
    <message>
        <source>%1 high</source>
        <translation>%1 hoch</translation>
    </message>
    <message>
        <source>%1 high, %2 %3</source>
        <comment>a building: its height, how far it is, in which direction</comment>
        <translation>%1 hoch, %2 %3</translation>
    </message>
    <message>
        <source>a building %1</source>
        <comment>23 m high, 120 m NE</comment>
        <translation>ein Gebäude, %1</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygon</translation>
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
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ja</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Nein</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorieren</translation>
    </message>
</context>
<context>
    <name>QUndoStack</name>
    <message>
        <source>Undo %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
</context>
<context>
    <name>Rule</name>
    <message>
        <source>Boston, Article 80 diagrams</source>
        <translation>Boston, Diagramme nach Article 80</translation>
    </message>
    <message>
        <source>Boston</source>
        <translation>Boston</translation>
    </message>
    <message>
        <source>Boston, Common and Garden</source>
        <translation>Boston, Common und Garden</translation>
    </message>
    <message>
        <source>Boston, Midtown</source>
        <translation>Boston, Midtown</translation>
    </message>
    <message>
        <source>BRE 209 (2022), amenity space</source>
        <translation>BRE 209 (2022), Freiflächen</translation>
    </message>
    <message>
        <source>London</source>
        <translation>London</translation>
    </message>
    <message>
        <source>BRE 209 (2022), windows</source>
        <translation>BRE 209 (2022), Fenster</translation>
    </message>
    <message>
        <source>New York, CEQR chapter 8</source>
        <translation>New York, CEQR Kapitel 8</translation>
    </message>
    <message>
        <source>New York</source>
        <translation>New York</translation>
    </message>
    <message>
        <source>China, GB 50180, sunlight of homes</source>
        <translation>China, GB 50180, Sonne in Wohnungen</translation>
    </message>
    <message>
        <source>China</source>
        <translation>China</translation>
    </message>
    <message>
        <source>EN 17037, exposure to sunlight</source>
        <translation>EN 17037, Besonnung</translation>
    </message>
    <message>
        <source>Europe</source>
        <translation>Europa</translation>
    </message>
    <message>
        <source>Estonia, insolation of homes</source>
        <translation>Estland, Besonnung von Wohnungen</translation>
    </message>
    <message>
        <source>Estonia</source>
        <translation>Estland</translation>
    </message>
    <message>
        <source>Four days, three hours</source>
        <translation>4 Tage, 3 Uhrzeiten</translation>
    </message>
    <message>
        <source>Philadelphia, Seattle and others</source>
        <translation>Philadelphia, Seattle und andere</translation>
    </message>
    <message>
        <source>Japan, Building Standards Act, table 4</source>
        <translation>Japan, Baunormengesetz, Tabelle 4</translation>
    </message>
    <message>
        <source>Japan</source>
        <translation>Japan</translation>
    </message>
    <message>
        <source>Korea, right to sunlight</source>
        <translation>Korea, Recht auf Sonne</translation>
    </message>
    <message>
        <source>Korea</source>
        <translation>Korea</translation>
    </message>
    <message>
        <source>Melbourne, amendment C278</source>
        <translation>Melbourne, Änderung C278</translation>
    </message>
    <message>
        <source>Melbourne</source>
        <translation>Melbourne</translation>
    </message>
    <message>
        <source>Montreal, parks</source>
        <translation>Montreal, Parks</translation>
    </message>
    <message>
        <source>Montreal</source>
        <translation>Montreal</translation>
    </message>
    <message>
        <source>Montreal, east-west streets</source>
        <translation>Montreal, Ost-West-Straßen</translation>
    </message>
    <message>
        <source>New South Wales, Apartment Design Guide</source>
        <translation>New South Wales, Apartment Design Guide</translation>
    </message>
    <message>
        <source>New South Wales</source>
        <translation>New South Wales</translation>
    </message>
    <message>
        <source>A rule of your own</source>
        <translation>Eine eigene Regel</translation>
    </message>
    <message>
        <source>Anywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Poland, sunlight in rooms</source>
        <translation>Polen, Sonne in Räumen</translation>
    </message>
    <message>
        <source>Poland</source>
        <translation>Polen</translation>
    </message>
    <message>
        <source>Russia (central zone), share of territory</source>
        <translation>Russland (mittlere Zone), Anteil der Fläche</translation>
    </message>
    <message>
        <source>Russia</source>
        <translation>Russland</translation>
    </message>
    <message>
        <source>Russia (central zone), insolation of rooms</source>
        <translation>Russland (mittlere Zone), Besonnung von Räumen</translation>
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
        <translation>Den Haag, Sonne auf Fassaden</translation>
    </message>
    <message>
        <source>The Hague</source>
        <translation>Den Haag</translation>
    </message>
    <message>
        <source>Netherlands, TNO light</source>
        <translation>Niederlande, TNO leicht</translation>
    </message>
    <message>
        <source>Netherlands</source>
        <translation>Niederlande</translation>
    </message>
    <message>
        <source>Netherlands, TNO strict</source>
        <translation>Niederlande, TNO streng</translation>
    </message>
    <message>
        <source>Toronto, shadow study</source>
        <translation>Toronto, Schattenstudie</translation>
    </message>
    <message>
        <source>Toronto</source>
        <translation>Toronto</translation>
    </message>
    <message>
        <source>Vancouver, parks and schoolyards</source>
        <translation>Vancouver, Parks und Schulhöfe</translation>
    </message>
    <message>
        <source>Vancouver</source>
        <translation>Vancouver</translation>
    </message>
    <message>
        <source>Zurich, shadow of tall buildings</source>
        <translation>Zürich, Schatten von Hochhäusern</translation>
    </message>
    <message>
        <source>Zurich</source>
        <translation>Zürich</translation>
    </message>
    <message>
        <source>United States</source>
        <translation>Vereinigte Staaten</translation>
    </message>
    <message>
        <source>Britain (UK)</source>
        <translation>Vereinigtes Königreich</translation>
    </message>
    <message>
        <source>Korea (South)</source>
        <translation>Südkorea</translation>
    </message>
    <message>
        <source>Switzerland</source>
        <translation>Schweiz</translation>
    </message>
    <message>
        <source>Canada</source>
        <translation>Kanada</translation>
    </message>
    <message>
        <source>Australia</source>
        <translation>Australien</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>New shadow enters</source>
        <translation>Neuer Schatten tritt ein</translation>
    </message>
    <message>
        <source>New shadow exits</source>
        <translation>Neuer Schatten tritt aus</translation>
    </message>
    <message>
        <source>Duration, min</source>
        <translation>Dauer, min</translation>
    </message>
    <message>
        <source>Largest area, m²</source>
        <translation>Größte Fläche, m²</translation>
    </message>
    <message>
        <source>At one spot, min</source>
        <translation>An einer Stelle, min</translation>
    </message>
    <message>
        <source>Shadow of fences and other small structures</source>
        <translation>Schatten von Zäunen und anderen kleinen Bauteilen</translation>
    </message>
    <message>
        <source>The rule asks for diagrams and states no limit, so there are figures and no verdict.</source>
        <translation>Die Regel verlangt Pläne und nennt keine Grenze, daher gibt es Zahlen und keinen Befund.</translation>
    </message>
    <message>
        <source>The equinoxes and solstices are the 21st of March, June, September and December.</source>
        <translation>Die Tagundnachtgleichen und Sonnenwenden sind der 21. März, Juni, September und Dezember.</translation>
    </message>
    <message>
        <source>Diagrams at 9, 12 and 15 h on the equinoxes and solstices, and at 18 h in summer and autumn.</source>
        <translation>Pläne um 9, 12 und 15 h an den Tagundnachtgleichen und Sonnenwenden, im Sommer und Herbst auch um 18 h.</translation>
    </message>
    <message>
        <source>Minutes with new shadow anywhere outside the first and last hour</source>
        <translation>Minuten mit neuem Schatten irgendwo außerhalb der ersten und letzten Stunde</translation>
    </message>
    <message>
        <source>Park</source>
        <translation>Park</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>Minuten</translation>
    </message>
    <message>
        <source>Exemptions and shadow banks</source>
        <translation>Ausnahmen und Schattenkonten</translation>
    </message>
    <message>
        <source>Sunrise and sunset are those of the upper limb with refraction: the definition is not stated.</source>
        <translation>Sonnenauf- und -untergang sind die des Oberrands mit Refraktion: die Definition ist nicht angegeben.</translation>
    </message>
    <message>
        <source>New shadow is shadow on ground that is lit in the baseline.</source>
        <translation>Neuer Schatten ist Schatten auf Boden, der in der Ausgangslage besonnt ist.</translation>
    </message>
    <message>
        <source>New shadow only in the first hour after sunrise or 7:00 (the later) and in the last hour before sunset.</source>
        <translation>Neuer Schatten nur in der ersten Stunde nach Sonnenaufgang oder 7:00 (dem späteren) und in der letzten Stunde vor Sonnenuntergang.</translation>
    </message>
    <message>
        <source>New shadow at the worst spot</source>
        <translation>Neuer Schatten an der schlechtesten Stelle</translation>
    </message>
    <message>
        <source>At the worst spot, min</source>
        <translation>An der schlechtesten Stelle, min</translation>
    </message>
    <message>
        <source>Anywhere, min</source>
        <translation>Irgendwo, min</translation>
    </message>
    <message>
        <source>Exemptions, and areas too small to count</source>
        <translation>Ausnahmen, und Flächen, die zu klein sind, um zu zählen</translation>
    </message>
    <message>
        <source>The two hours are those of the worst spot: the figures at hand do not say whether a spot or the whole park is meant. The table states both.</source>
        <translation>Die zwei Stunden gelten für die schlechteste Stelle: die vorliegenden Zahlen sagen nicht, ob eine Stelle oder der ganze Park gemeint ist. Die Tabelle nennt beides.</translation>
    </message>
    <message>
        <source>Less than 2 h of new shadow within 8:00-14:30, from 21 March to 21 October.</source>
        <translation>Weniger als 2 h neuer Schatten von 8:00 bis 14:30, vom 21. März bis 21. Oktober.</translation>
    </message>
    <message>
        <source>Share of the space with 2 h of sun</source>
        <translation>Anteil der Fläche mit 2 h Sonne</translation>
    </message>
    <message>
        <source>Amenity space</source>
        <translation>Freifläche</translation>
    </message>
    <message>
        <source>Share with 2 h of sun</source>
        <translation>Anteil mit 2 h Sonne</translation>
    </message>
    <message>
        <source>Least sun, min</source>
        <translation>Wenigste Sonne, min</translation>
    </message>
    <message>
        <source>The windows&apos; part of BRE 209: annual probable sunlight hours, vertical sky component</source>
        <translation>Der Fensterteil von BRE 209: jährliche wahrscheinliche Sonnenstunden, vertikaler Himmelslichtanteil</translation>
    </message>
    <message>
        <source>Shadow of fences</source>
        <translation>Schatten von Zäunen</translation>
    </message>
    <message>
        <source>The two hours may be broken up.</source>
        <translation>Die zwei Stunden dürfen unterbrochen sein.</translation>
    </message>
    <message>
        <source>A space that meets the limit by its former value is stated with its new share.</source>
        <translation>Eine Fläche, welche die Grenze durch ihren früheren Wert erfüllt, ist mit ihrem neuen Anteil angegeben.</translation>
    </message>
    <message>
        <source>As reported, of trees only dense belts of evergreens count for sun on the ground. A cell is in their shade where they take half of the sun or more.</source>
        <translation>Wie berichtet, zählen von den Bäumen für die Sonne am Boden nur dichte Gürtel immergrüner. Eine Zelle liegt in ihrem Schatten, wo sie die Hälfte der Sonne oder mehr nehmen.</translation>
    </message>
    <message>
        <source>At least 2 h of sun on 21 March over at least half of an amenity space, or else at least 0.8 times its former value.</source>
        <translation>Mindestens 2 h Sonne am 21. März auf mindestens der Hälfte einer Freifläche, oder sonst mindestens das 0,8-fache ihres früheren Werts.</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>windows of</source>
        <translation>Fenster von</translation>
    </message>
    <message>
        <source>neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>own scheme</source>
        <translation>eigenem Vorhaben</translation>
    </message>
    <message>
        <source>Annual probable sunlight hours</source>
        <translation>Jährliche wahrscheinliche Sonnenstunden</translation>
    </message>
    <message>
        <source>Loss of annual probable sunlight hours</source>
        <translation>Verlust an jährlichen wahrscheinlichen Sonnenstunden</translation>
    </message>
    <message>
        <source>Vertical sky component</source>
        <translation>Vertikaler Himmelslichtanteil</translation>
    </message>
    <message>
        <source>Probable sunlight hours from 21 September to 21 March, of those of the year</source>
        <translation>Wahrscheinliche Sonnenstunden vom 21. September bis 21. März, von denen des Jahres</translation>
    </message>
    <message>
        <source>Sunlight is asked of windows that face within 90 degrees of due south</source>
        <translation>Sonnenlicht wird für Fenster verlangt, die höchstens 90 Grad von Süden abweichen</translation>
    </message>
    <message>
        <source>No-sky line and daylight in rooms</source>
        <translation>Grenzlinie des sichtbaren Himmels und Tageslicht in Räumen</translation>
    </message>
    <message>
        <source>Which rooms are living rooms: all windows are evaluated</source>
        <translation>Welche Räume Wohnräume sind: alle Fenster werden geprüft</translation>
    </message>
    <message>
        <source>Windows that face north are asked for the sky component only</source>
        <translation>Fenster nach Norden müssen nur den Himmelslichtanteil erfüllen</translation>
    </message>
    <message>
        <source>Shadow of fences and blinds</source>
        <translation>Schatten von Zäunen und Jalousien</translation>
    </message>
    <message>
        <source>A window&apos;s sunlight suffers if it misses a target of its own, falls below 0.8 times the former value in that period, and loses more than 4 points of the year: it holds if one of the three does not occur. Where an authority asks for both 0.8 times and a loss of at most 4 points, copy the rule and change holds_if.</source>
        <translation>Das Sonnenlicht eines Fensters leidet, wenn es ein eigenes Ziel verfehlt, in diesem Zeitraum unter das 0,8-fache des früheren Werts fällt und mehr als 4 Punkte des Jahres verliert: es gilt, wenn eines der drei nicht eintritt. Wo eine Behörde sowohl das 0,8-fache als auch einen Verlust von höchstens 4 Punkten verlangt, kopieren Sie die Regel und ändern holds_if.</translation>
    </message>
    <message>
        <source>Without a table of sunshine probability every hour with the sun up counts alike, and shares are of plain possible hours. Add a table for the place as &quot;sunshine&quot; in a copy of the rule, or with --sunshine.</source>
        <translation>Ohne eine Tabelle der Sonnenscheinwahrscheinlichkeit zählt jede Stunde mit der Sonne am Himmel gleich, und Anteile gelten für einfache mögliche Stunden. Fügen Sie in einer Kopie der Regel unter &quot;sunshine&quot; oder mit --sunshine eine Tabelle für den Ort hinzu.</translation>
    </message>
    <message>
        <source>Shares are of the hours of the unobstructed sun in a whole year, also those of winter.</source>
        <translation>Anteile gelten für die Stunden der unverstellten Sonne im ganzen Jahr, auch die des Winters.</translation>
    </message>
    <message>
        <source>The point is in the middle of the pane on the outside face. With the choice of the inside face, the sun must also pass the opening in the wall.</source>
        <translation>Der Punkt liegt in der Mitte der Scheibe auf der Außenseite. Mit der Wahl der Innenseite muss die Sonne auch durch die Öffnung in der Wand.</translation>
    </message>
    <message>
        <source>As reported, deciduous trees are left out before neighbours&apos; windows, and evergreens count. With the choice of one&apos;s own scheme, existing trees count by their season, and of the proposed ones the evergreens.</source>
        <translation>Wie berichtet, bleiben Laubbäume vor Fenstern der Nachbarn weg, und immergrüne zählen. Mit der Wahl des eigenen Vorhabens zählen vorhandene Bäume nach Jahreszeit, und von den geplanten die immergrünen.</translation>
    </message>
    <message>
        <source>Sun through crowns counts by the share that they let pass; a run is broken where they take half of it or more. The vertical sky component has the mean of the days with leaves and without.</source>
        <translation>Sonne durch Kronen zählt mit dem Anteil, den sie durchlassen; eine Dauer ist unterbrochen, wo sie die Hälfte davon oder mehr nehmen. Der vertikale Himmelslichtanteil ist das Mittel der Tage mit und ohne Laub.</translation>
    </message>
    <message>
        <source>Windows of neighbours: vertical sky component at least 27 %, annual probable sunlight hours at least 25 % with 5 % in winter, each or else 0.8 times the former value; a loss of sunlight of at most 4 points is never notable.</source>
        <translation>Fenster der Nachbarn: vertikaler Himmelslichtanteil mindestens 27 %, jährliche wahrscheinliche Sonnenstunden mindestens 25 %, davon 5 % im Winter, jeweils oder sonst das 0,8-fache des früheren Werts; ein Verlust von höchstens 4 Punkten Sonnenlicht ist nie spürbar.</translation>
    </message>
    <message>
        <source>Minutes in which all direct sun is eliminated</source>
        <translation>Minuten, in denen alle direkte Sonne verschwindet</translation>
    </message>
    <message>
        <source>Sun for plants at the worst spot, growing season</source>
        <translation>Sonne für Pflanzen an der schlechtesten Stelle, Wachstumszeit</translation>
    </message>
    <message>
        <source>Resource</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Analysis day</source>
        <translation>Untersuchungstag</translation>
    </message>
    <message>
        <source>Incremental shadow enters</source>
        <translation>Zusätzlicher Schatten tritt ein</translation>
    </message>
    <message>
        <source>Incremental shadow exits</source>
        <translation>Zusätzlicher Schatten tritt aus</translation>
    </message>
    <message>
        <source>Duration, h:min</source>
        <translation>Dauer, h:min</translation>
    </message>
    <message>
        <source>Longest at one spot, h:min</source>
        <translation>Am längsten an einer Stelle, h:min</translation>
    </message>
    <message>
        <source>All direct sun eliminated, min</source>
        <translation>Alle direkte Sonne genommen, min</translation>
    </message>
    <message>
        <source>Trigger: 50 ft or more, or more than 10 ft next to a resource</source>
        <translation>Auslöser: 50 ft und mehr, oder mehr als 10 ft neben einem schützenswerten Ort</translation>
    </message>
    <message>
        <source>Longest shadow: 4.3 x height</source>
        <translation>Längster Schatten: 4,3 x Höhe</translation>
    </message>
    <message>
        <source>No shadow between 108 and 252 degrees from north</source>
        <translation>Kein Schatten zwischen 108 und 252 Grad von Norden</translation>
    </message>
    <message>
        <source>Hours: from 1.5 h after sunrise to 1.5 h before sunset</source>
        <translation>Stunden: von 1,5 h nach Sonnenaufgang bis 1,5 h vor Sonnenuntergang</translation>
    </message>
    <message>
        <source>Growing season: April to October; a statement on it is asked for</source>
        <translation>Wachstumszeit: April bis Oktober; eine Aussage dazu wird verlangt</translation>
    </message>
    <message>
        <source>All direct sun eliminated from a resource for more than 10 min is generally significant</source>
        <translation>Alle direkte Sonne mehr als 10 min lang von einem Ort genommen gilt in der Regel als erheblich</translation>
    </message>
    <message>
        <source>Plants need 4 to 6 h of sun</source>
        <translation>Pflanzen brauchen 4 bis 6 h Sonne</translation>
    </message>
    <message>
        <source>The trigger (height of the proposal) and whether the resource is sensitive to sunlight</source>
        <translation>Der Auslöser (Höhe des Entwurfs), und ob der Ort auf Sonne angewiesen ist</translation>
    </message>
    <message>
        <source>Significance of incremental shadow that leaves some sun: the rule asks for a judgement</source>
        <translation>Erheblichkeit zusätzlichen Schattens, der etwas Sonne lässt: die Regel verlangt ein Urteil</translation>
    </message>
    <message>
        <source>Stained glass and facades are measured on the ground in front of them</source>
        <translation>Buntglasfenster und Fassaden werden auf dem Boden vor ihnen gemessen</translation>
    </message>
    <message>
        <source>Landscaped medians with seats, unless they are places of the project</source>
        <translation>Begrünte Mittelstreifen mit Sitzplätzen, außer wenn sie Orte des Projekts sind</translation>
    </message>
    <message>
        <source>The duration is the time with incremental shadow anywhere on the resource, without breaks.</source>
        <translation>Die Dauer ist die Zeit mit zusätzlichem Schatten irgendwo auf dem Ort, ohne Unterbrechungen.</translation>
    </message>
    <message>
        <source>Kinds that the rule does not name (playground, plaza, cemetery, other) are evaluated as open space. Streets are not.</source>
        <translation>Arten, welche die Regel nicht nennt (Spielplatz, Platz, Friedhof, andere), werden als Freiraum geprüft. Straßen nicht.</translation>
    </message>
    <message>
        <source>The sun for plants is counted within the rule&apos;s hours and compared with the lower figure, 4 h; it does not decide the verdict.</source>
        <translation>Die Sonne für Pflanzen wird in den Stunden der Regel gezählt und mit dem kleineren Wert, 4 h, verglichen; sie entscheidet nicht über den Befund.</translation>
    </message>
    <message>
        <source>Incremental shadow of a proposal on sunlight-sensitive resources on four analysis days, against the No-Action scenario.</source>
        <translation>Zusätzlicher Schatten eines Entwurfs auf sonnenbedürftige Orte an vier Untersuchungstagen, gegenüber dem Szenario ohne Vorhaben.</translation>
    </message>
    <message>
        <source>counting</source>
        <translation>Zählung</translation>
    </message>
    <message>
        <source>Beijing, runs from 5 min</source>
        <translation>Peking, Abschnitte ab 5 min</translation>
    </message>
    <message>
        <source>Hangzhou, two longest runs</source>
        <translation>Hangzhou, die zwei längsten Abschnitte</translation>
    </message>
    <message>
        <source>all runs</source>
        <translation>alle Abschnitte</translation>
    </message>
    <message>
        <source>day</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>Great Cold, 2 h</source>
        <translation>Große Kälte, 2 h</translation>
    </message>
    <message>
        <source>Great Cold, 3 h</source>
        <translation>Große Kälte, 3 h</translation>
    </message>
    <message>
        <source>winter solstice, 1 h</source>
        <translation>Wintersonnenwende, 1 h</translation>
    </message>
    <message>
        <source>winter solstice</source>
        <translation>Wintersonnenwende</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>Winkel zur Scheibe</translation>
    </message>
    <message>
        <source>15 degrees</source>
        <translation>15 Grad</translation>
    </message>
    <message>
        <source>wall over width</source>
        <translation>Wand durch Breite</translation>
    </message>
    <message>
        <source>Effective sun at both ends of the sill</source>
        <translation>Wirksame Sonne an beiden Enden der Brüstung</translation>
    </message>
    <message>
        <source>Great Cold</source>
        <translation>Große Kälte</translation>
    </message>
    <message>
        <source>The sun counts from a sweep angle of 15 degrees, or arctan(thickness of the wall / width of the window)</source>
        <translation>Die Sonne zählt ab einem Winkel von 15 Grad zur Scheibe, oder arctan(Wanddicke / Fensterbreite)</translation>
    </message>
    <message>
        <source>Beijing drops runs below 5 min; 30 min is also reported</source>
        <translation>Peking lässt Abschnitte unter 5 min weg; auch 30 min werden berichtet</translation>
    </message>
    <message>
        <source>Hangzhou sums the longest runs, steps of at most 5 min</source>
        <translation>Hangzhou summiert die längsten Abschnitte, Schritte von höchstens 5 min</translation>
    </message>
    <message>
        <source>Households: which windows belong to a household, and that one living room is enough</source>
        <translation>Haushalte: welche Fenster zu einem Haushalt gehören, und dass ein Wohnraum genügt</translation>
    </message>
    <message>
        <source>The climate zone and size of the city, which choose the day</source>
        <translation>Klimazone und Größe der Stadt, die den Tag bestimmen</translation>
    </message>
    <message>
        <source>The sun counts while both ends of the sill have it at once.</source>
        <translation>Die Sonne zählt, solange beide Enden der Brüstung sie zugleich haben.</translation>
    </message>
    <message>
        <source>Windows of 1.5 m stand in where the file states no sizes.</source>
        <translation>Fenster von 1,5 m stehen für solche, deren Größe die Datei nicht nennt.</translation>
    </message>
    <message>
        <source>Hangzhou: the two longest runs are summed; how many is not stated in what we have.</source>
        <translation>Hangzhou: die zwei längsten Abschnitte werden summiert; wie viele es sind, sagt das Vorliegende nicht.</translation>
    </message>
    <message>
        <source>Homes: at least 2 h of sun on the Great Cold day from 8 to 16 h, or 1 h on the winter solstice from 9 to 15 h, true solar time, at both ends of the sill.</source>
        <translation>Wohnungen: mindestens 2 h Sonne am Tag der Großen Kälte von 8 bis 16 h, oder 1 h zur Wintersonnenwende von 9 bis 15 h, wahre Sonnenzeit, an beiden Enden der Brüstung.</translation>
    </message>
    <message>
        <source>country</source>
        <translation>Land</translation>
    </message>
    <message>
        <source>Czech Republic, 13 deg</source>
        <translation>Tschechien, 13 Grad</translation>
    </message>
    <message>
        <source>Germany, 11 deg</source>
        <translation>Deutschland, 11 Grad</translation>
    </message>
    <message>
        <source>of choice</source>
        <translation>nach Wahl</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>schlechtester</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mittel</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>Mindestmaß</translation>
    </message>
    <message>
        <source>Sun in the room</source>
        <translation>Sonne im Raum</translation>
    </message>
    <message>
        <source>Levels: 1.5 h minimum, 4 h high</source>
        <translation>Stufen: 1,5 h Mindestmaß, 4 h hoch</translation>
    </message>
    <message>
        <source>Level: 3 h medium</source>
        <translation>Stufe: 3 h mittel</translation>
    </message>
    <message>
        <source>Which rooms are habitable, and that one room of a dwelling is enough</source>
        <translation>Welche Räume Aufenthaltsräume sind, und dass ein Raum einer Wohnung genügt</translation>
    </message>
    <message>
        <source>Least altitudes of countries other than Germany and the Czech Republic: change lowest_sun_deg in a copy of the rule</source>
        <translation>Mindesthöhen anderer Länder als Deutschland und Tschechien: lowest_sun_deg in einer Kopie der Regel ändern</translation>
    </message>
    <message>
        <source>Times through several openings of a room add up where they are not at the same moment: name the rooms in the file of windows (field room). Windows without a room are rooms of their own.</source>
        <translation>Zeiten durch mehrere Öffnungen eines Raums werden addiert, wo sie nicht zugleich sind: nennen Sie die Räume in der Datei der Fenster (Feld room). Fenster ohne Raum sind eigene Räume.</translation>
    </message>
    <message>
        <source>On the day of the user&apos;s choice: the best day of the range decides. The choice &quot;day=worst&quot; asks it of every day.</source>
        <translation>Am Tag nach Wahl: der beste Tag des Zeitraums entscheidet. Die Wahl &quot;day=worst&quot; verlangt es an jedem Tag.</translation>
    </message>
    <message>
        <source>Obstructions are looked up from the outside face; the opening, as deep as the wall, hides what the inside face does not see.</source>
        <translation>Hindernisse werden von der Außenseite aus gesucht; die Öffnung, so tief wie die Wand, verdeckt, was die Innenseite nicht sieht.</translation>
    </message>
    <message>
        <source>The least altitude depends on the country. That of Germany is taken unless another country is chosen.</source>
        <translation>Die Mindesthöhe hängt vom Land ab. Genommen wird die von Deutschland, wenn kein anderes Land gewählt ist.</translation>
    </message>
    <message>
        <source>On one day between 1 February and 21 March at least 1.5 h of sun in one habitable room; 3 h medium, 4 h high.</source>
        <translation>An einem Tag zwischen 1. Februar und 21. März mindestens 1,5 h Sonne in einem Aufenthaltsraum; 3 h mittel, 4 h hoch.</translation>
    </message>
    <message>
        <source>Longest unbroken sun</source>
        <translation>Längste ununterbrochene Sonne</translation>
    </message>
    <message>
        <source>Sun of the day</source>
        <translation>Sonne des Tages</translation>
    </message>
    <message>
        <source>3 h of unbroken sun, or 3.5 h with one break</source>
        <translation>3 h ununterbrochene Sonne, oder 3,5 h mit einer Unterbrechung</translation>
    </message>
    <message>
        <source>Which rooms must have it</source>
        <translation>Welche Räume sie haben müssen</translation>
    </message>
    <message>
        <source>The worst day decides.</source>
        <translation>Der schlechteste Tag entscheidet.</translation>
    </message>
    <message>
        <source>With one break: the two longest parts of the day&apos;s sun add up to 3.5 h, whatever sun follows.</source>
        <translation>Mit einer Unterbrechung: die zwei längsten Teile der Sonne des Tages ergeben zusammen 3,5 h, welche Sonne auch folgt.</translation>
    </message>
    <message>
        <source>Every break counts, also one of a minute: the sun before and after it are two parts. The bands of the window state them.</source>
        <translation>Jede Unterbrechung zählt, auch eine von einer Minute: die Sonne davor und danach sind zwei Teile. Die Bänder des Fensters nennen sie.</translation>
    </message>
    <message>
        <source>From 22 April to 22 August at least 3 h of unbroken sun, or 3.5 h with one break; a loss of at most 50 %.</source>
        <translation>Vom 22. April bis 22. August mindestens 3 h ununterbrochene Sonne, oder 3,5 h mit einer Unterbrechung; ein Verlust von höchstens 50 %.</translation>
    </message>
    <message>
        <source>The sheet has no limit, so there are figures and no verdict.</source>
        <translation>Das Blatt hat keine Grenze, daher gibt es Zahlen und keinen Befund.</translation>
    </message>
    <message>
        <source>The solstices and equinoxes are the 21st of March, June, September and December.</source>
        <translation>Die Sonnenwenden und Tagundnachtgleichen sind der 21. März, Juni, September und Dezember.</translation>
    </message>
    <message>
        <source>Diagrams at 9, 12 and 15 h on the solstices and equinoxes: the general sheet.</source>
        <translation>Pläne um 9, 12 und 15 h an den Sonnenwenden und Tagundnachtgleichen: das allgemeine Blatt.</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>Grenzen</translation>
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
        <translation>Ebene</translation>
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
        <translation>Schatten jenseits von 10 m von der Grundstücksgrenze</translation>
    </message>
    <message>
        <source>Shadow within 5 to 10 m of the parcel line</source>
        <translation>Schatten von 5 bis 10 m von der Grundstücksgrenze</translation>
    </message>
    <message>
        <source>Parcel and belt</source>
        <translation>Grundstück und Gürtel</translation>
    </message>
    <message>
        <source>Longest shadow at a point, min</source>
        <translation>Längster Schatten an einem Punkt, min</translation>
    </message>
    <message>
        <source>Shadow anywhere, min</source>
        <translation>Schatten irgendwo, min</translation>
    </message>
    <message>
        <source>True solar time 8 to 16 h; Hokkaido 9 to 15 h</source>
        <translation>Wahre Sonnenzeit 8 bis 16 h; Hokkaido 9 bis 15 h</translation>
    </message>
    <message>
        <source>Plane 1.5, 4 or 6.5 m above the mean ground</source>
        <translation>Ebene 1,5, 4 oder 6,5 m über dem mittleren Boden</translation>
    </message>
    <message>
        <source>Limits within 5 to 10 m of the parcel line and beyond 10 m: 3 and 2 h, 4 and 2.5 h, 5 and 3 h; Hokkaido 2 and 1.5 h, 3 and 2 h, 4 and 2.5 h</source>
        <translation>Grenzen von 5 bis 10 m von der Grundstücksgrenze und jenseits von 10 m: 3 und 2 h, 4 und 2,5 h, 5 und 3 h; Hokkaido 2 und 1,5 h, 3 und 2 h, 4 und 2,5 h</translation>
    </message>
    <message>
        <source>Triggers: eaves above 7 m or 3 storeys and more (plane of 1.5 m), above 10 m (planes of 4 and 6.5 m)</source>
        <translation>Auslöser: Traufe über 7 m oder 3 Geschosse und mehr (Ebene 1,5 m), über 10 m (Ebenen 4 und 6,5 m)</translation>
    </message>
    <message>
        <source>The parcel line moves out by half the width of a road of at most 10 m, else to 5 m inside its far side</source>
        <translation>Die Grundstücksgrenze rückt um die halbe Breite einer Straße von höchstens 10 m nach außen, sonst bis 5 m vor deren ferne Seite</translation>
    </message>
    <message>
        <source>Sheets: hourly (half-hourly) shadows, isochrones, 5 m and 10 m lines, designated points; island shadows must not be missed</source>
        <translation>Blätter: stündliche (halbstündliche) Schatten, Isochronen, Linien bei 5 m und 10 m, festgelegte Punkte; Inselschatten dürfen nicht übersehen werden</translation>
    </message>
    <message>
        <source>The triggers (eaves, storeys, zone): choose plane and limits</source>
        <translation>Die Auslöser (Traufe, Geschosse, Zone): Ebene und Grenzen wählen</translation>
    </message>
    <message>
        <source>Roads, water and railways along the parcels that the project does not state; edges set back more than 1 m are taken to be on none</source>
        <translation>Straßen, Wasser und Bahnen an den Grundstücken, die das Projekt nicht nennt; Ränder, die mehr als 1 m zurückliegen, gelten als an keiner gelegen</translation>
    </message>
    <message>
        <source>Designated points</source>
        <translation>Festgelegte Punkte</translation>
    </message>
    <message>
        <source>The winter solstice is 21 December.</source>
        <translation>Die Wintersonnenwende ist der 21. Dezember.</translation>
    </message>
    <message>
        <source>The places are the parcels; Noonmark measures the belts around them.</source>
        <translation>Die Orte sind die Grundstücke; Noonmark misst die Gürtel um sie.</translation>
    </message>
    <message>
        <source>The mean ground is the height 0 of the project&apos;s plane, unless the project has terrain.</source>
        <translation>Der mittlere Boden ist die Höhe 0 der Projektebene, außer wenn das Projekt Gelände hat.</translation>
    </message>
    <message>
        <source>Shadow of the proposal on a plane above the mean ground on the winter solstice, between the 5 m and 10 m lines around the parcel and beyond them.</source>
        <translation>Schatten des Entwurfs auf einer Ebene über dem mittleren Boden zur Wintersonnenwende, zwischen den Linien bei 5 m und 10 m um das Grundstück und jenseits davon.</translation>
    </message>
    <message>
        <source>Sun in total from 8 to 16 h</source>
        <translation>Sonne insgesamt von 8 bis 16 h</translation>
    </message>
    <message>
        <source>Unbroken sun from 9 to 15 h</source>
        <translation>Ununterbrochene Sonne von 9 bis 15 h</translation>
    </message>
    <message>
        <source>Windows of schools and playgrounds within 200 m</source>
        <translation>Fenster von Schulen und Spielplätzen im Umkreis von 200 m</translation>
    </message>
    <message>
        <source>One of the two is enough.</source>
        <translation>Eines von beiden genügt.</translation>
    </message>
    <message>
        <source>On the winter solstice at least 4 h of sun in total from 8 to 16 h, or 2 h unbroken from 9 to 15 h.</source>
        <translation>Zur Wintersonnenwende mindestens 4 h Sonne insgesamt von 8 bis 16 h, oder 2 h ununterbrochen von 9 bis 15 h.</translation>
    </message>
    <message>
        <source>park type</source>
        <translation>Parktyp</translation>
    </message>
    <message>
        <source>1 or 2</source>
        <translation>1 oder 2</translation>
    </message>
    <message>
        <source>3</source>
        <translation>3</translation>
    </message>
    <message>
        <source>Minutes with added shadow anywhere</source>
        <translation>Minuten mit hinzukommendem Schatten irgendwo</translation>
    </message>
    <message>
        <source>Added shadow enters</source>
        <translation>Hinzukommender Schatten tritt ein</translation>
    </message>
    <message>
        <source>Added shadow exits</source>
        <translation>Hinzukommender Schatten tritt aus</translation>
    </message>
    <message>
        <source>No added shadow from 10 to 15 h on 21 June; type 3 from 10 to 14 h. As proposed</source>
        <translation>Kein hinzukommender Schatten von 10 bis 15 h am 21. Juni; Typ 3 von 10 bis 14 h. Wie vorgeschlagen</translation>
    </message>
    <message>
        <source>The type of the park: choose the option</source>
        <translation>Der Typ des Parks: die Möglichkeit wählen</translation>
    </message>
    <message>
        <source>The figures are those proposed, not those adopted.</source>
        <translation>Die Zahlen sind die vorgeschlagenen, nicht die beschlossenen.</translation>
    </message>
    <message>
        <source>No added shadow on parks from 10 to 15 h on 21 June (type 3: to 14 h).</source>
        <translation>Kein hinzukommender Schatten auf Parks von 10 bis 15 h am 21. Juni (Typ 3: bis 14 h).</translation>
    </message>
    <message>
        <source>Share of the park with 8 consecutive hours of sun</source>
        <translation>Anteil des Parks mit 8 zusammenhängenden Sonnenstunden</translation>
    </message>
    <message>
        <source>equinox</source>
        <translation>Tagundnachtgleiche</translation>
    </message>
    <message>
        <source>Share with 8 h of sun</source>
        <translation>Anteil mit 8 h Sonne</translation>
    </message>
    <message>
        <source>The equinox is 21 March.</source>
        <translation>Die Tagundnachtgleiche ist der 21. März.</translation>
    </message>
    <message>
        <source>Half of a park is half of its area.</source>
        <translation>Die Hälfte eines Parks ist die Hälfte seiner Fläche.</translation>
    </message>
    <message>
        <source>On the equinox, 8 consecutive hours of sun within 8-18 h on at least half of a park.</source>
        <translation>Zur Tagundnachtgleiche 8 zusammenhängende Sonnenstunden von 8 bis 18 h auf mindestens der Hälfte eines Parks.</translation>
    </message>
    <message>
        <source>minutes</source>
        <translation>Minuten</translation>
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
        <translation>Zusammenhängende Sonne an der schlechtesten Stelle der Straße</translation>
    </message>
    <message>
        <source>Street</source>
        <translation>Straße</translation>
    </message>
    <message>
        <source>Least consecutive sun, min</source>
        <translation>Wenigste zusammenhängende Sonne, min</translation>
    </message>
    <message>
        <source>150 (90) consecutive minutes of sun; the figures at hand do not say where 90 holds</source>
        <translation>150 (90) zusammenhängende Minuten Sonne; die vorliegenden Zahlen sagen nicht, wo 90 gilt</translation>
    </message>
    <message>
        <source>Whether a street runs east-west: choose the places</source>
        <translation>Ob eine Straße von Ost nach West verläuft: die Orte wählen</translation>
    </message>
    <message>
        <source>Where 90 minutes hold instead of 150: choose the option</source>
        <translation>Wo 90 Minuten statt 150 gelten: die Möglichkeit wählen</translation>
    </message>
    <message>
        <source>Every spot of the street must have the sun: the figures at hand do not say which line or share of a street counts.</source>
        <translation>Jede Stelle der Straße muss die Sonne haben: die vorliegenden Zahlen sagen nicht, welche Linie oder welcher Anteil einer Straße zählt.</translation>
    </message>
    <message>
        <source>On the equinox, 150 consecutive minutes of sun within 12-15 h on east-west streets.</source>
        <translation>Zur Tagundnachtgleiche 150 zusammenhängende Minuten Sonne von 12 bis 15 h auf Straßen in Ost-West-Richtung.</translation>
    </message>
    <message>
        <source>where</source>
        <translation>wo</translation>
    </message>
    <message>
        <source>elsewhere, 3 h</source>
        <translation>anderswo, 3 h</translation>
    </message>
    <message>
        <source>metropolitan, 2 h</source>
        <translation>Großstadtgebiet, 2 h</translation>
    </message>
    <message>
        <source>Sun in the flat</source>
        <translation>Sonne in der Wohnung</translation>
    </message>
    <message>
        <source>Any sun in the flat</source>
        <translation>Überhaupt Sonne in der Wohnung</translation>
    </message>
    <message>
        <source>1 m² for at least 15 min counts</source>
        <translation>1 m² für mindestens 15 min zählt</translation>
    </message>
    <message>
        <source>That the sun is in living rooms and on balconies both</source>
        <translation>Dass die Sonne sowohl in Wohnräumen als auch auf Balkonen ist</translation>
    </message>
    <message>
        <source>That 1 m² is lit</source>
        <translation>Dass 1 m² besonnt ist</translation>
    </message>
    <message>
        <source>Plan diagrams</source>
        <translation>Pläne</translation>
    </message>
    <message>
        <source>Times of less than 15 min do not count.</source>
        <translation>Zeiten von weniger als 15 min zählen nicht.</translation>
    </message>
    <message>
        <source>A flat has the sun of all of its windows, where one of them has it: name the flats in the file of windows (field dwelling). Windows without one are flats of their own.</source>
        <translation>Eine Wohnung hat die Sonne aller ihrer Fenster, sobald eines sie hat: nennen Sie die Wohnungen in der Datei der Fenster (Feld dwelling). Fenster ohne Angabe sind eigene Wohnungen.</translation>
    </message>
    <message>
        <source>A building passes by its shares; each flat has its own verdict besides.</source>
        <translation>Ein Gebäude erfüllt die Regel durch seine Anteile; jede Wohnung hat daneben ihren eigenen Befund.</translation>
    </message>
    <message>
        <source>Flats with enough sun</source>
        <translation>Wohnungen mit genug Sonne</translation>
    </message>
    <message>
        <source>Flats with some sun</source>
        <translation>Wohnungen mit etwas Sonne</translation>
    </message>
    <message>
        <source>At least 70 % of the flats of a building have 2 h of sun from 9 to 15 h on 21 June in living rooms and on balconies (3 h outside the metropolis); at most 15 % have none.</source>
        <translation>Mindestens 70 % der Wohnungen eines Gebäudes haben am 21. Juni von 9 bis 15 h 2 h Sonne in Wohnräumen und auf Balkonen (3 h außerhalb des Großstadtgebiets); höchstens 15 % haben keine.</translation>
    </message>
    <message>
        <source>All sun gone, min</source>
        <translation>Alle Sonne genommen, min</translation>
    </message>
    <message>
        <source>One hour is an example, not a figure of any board.</source>
        <translation>Eine Stunde ist ein Beispiel, keine Zahl irgendeiner Behörde.</translation>
    </message>
    <message>
        <source>A start for a rule of your own: copy it, change it, and put it into your own folder of rules.</source>
        <translation>Ein Anfang für eine eigene Regel: kopieren, ändern und in den eigenen Regelordner legen.</translation>
    </message>
    <message>
        <source>use</source>
        <translation>Nutzung</translation>
    </message>
    <message>
        <source>homes</source>
        <translation>Wohnungen</translation>
    </message>
    <message>
        <source>homes in an inner city</source>
        <translation>Wohnungen in einer Innenstadt</translation>
    </message>
    <message>
        <source>schools</source>
        <translation>Schulen</translation>
    </message>
    <message>
        <source>That one room of a flat is enough: each room is evaluated by itself</source>
        <translation>Dass ein Raum einer Wohnung genügt: jeder Raum wird für sich geprüft</translation>
    </message>
    <message>
        <source>The sun may be broken up. Times through several openings of a room add up where they are not at the same moment: name the rooms in the file of windows (field room).</source>
        <translation>Die Sonne darf unterbrochen sein. Zeiten durch mehrere Öffnungen eines Raums werden addiert, wo sie nicht zugleich sind: nennen Sie die Räume in der Datei der Fenster (Feld room).</translation>
    </message>
    <message>
        <source>At least 3 h of sun on the days of the equinoxes: homes from 7 to 17 h, schools from 8 to 16 h; 1.5 h in inner cities.</source>
        <translation>Mindestens 3 h Sonne an den Tagen der Tagundnachtgleichen: Wohnungen von 7 bis 17 h, Schulen von 8 bis 16 h; 1,5 h in Innenstädten.</translation>
    </message>
    <message>
        <source>Share of the territory with 2 h of sun, or 2.5 h broken up</source>
        <translation>Anteil der Fläche mit 2 h Sonne, oder 2,5 h mit Unterbrechungen</translation>
    </message>
    <message>
        <source>Territory</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Share with the sun</source>
        <translation>Anteil mit der Sonne</translation>
    </message>
    <message>
        <source>Least sun, h:min</source>
        <translation>Wenigste Sonne, h:min</translation>
    </message>
    <message>
        <source>Intervals</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>2 h unbroken (by zone and number of rooms)</source>
        <translation>2 h ununterbrochen (nach Zone und Zahl der Räume)</translation>
    </message>
    <message>
        <source>Broken up: 0.5 h more, one part of at least 1 h</source>
        <translation>Mit Unterbrechungen: 0,5 h mehr, ein Teil von mindestens 1 h</translation>
    </message>
    <message>
        <source>Output: h:min, number of intervals, share of territory</source>
        <translation>Ausgabe: h:min, Zahl der Abschnitte, Anteil der Fläche</translation>
    </message>
    <message>
        <source>Rooms and windows</source>
        <translation>Räume und Fenster</translation>
    </message>
    <message>
        <source>Other zones: change the days and hours in a rule of your own</source>
        <translation>Andere Zonen: Tage und Stunden in einer eigenen Regel ändern</translation>
    </message>
    <message>
        <source>Every break counts, also one of a single step of 5 min: the sun before and after it are two parts.</source>
        <translation>Jede Unterbrechung zählt, auch eine von einem einzigen Schritt von 5 min: die Sonne davor und danach sind zwei Teile.</translation>
    </message>
    <message>
        <source>Every day of the range is evaluated; the smallest share counts.</source>
        <translation>Jeder Tag des Zeitraums wird geprüft; der kleinste Anteil zählt.</translation>
    </message>
    <message>
        <source>The figures at hand state no share that a territory must reach, so there are figures and no verdict.</source>
        <translation>Die vorliegenden Zahlen nennen keinen Anteil, den eine Fläche erreichen muss, daher gibt es Zahlen und keinen Befund.</translation>
    </message>
    <message>
        <source>From 22 April to 22 August, the share of a territory with 2 h of unbroken sun, or 2.5 h broken up with one part of at least 1 h.</source>
        <translation>Vom 22. April bis 22. August der Anteil einer Fläche mit 2 h ununterbrochener Sonne, oder 2,5 h mit Unterbrechungen und einem Teil von mindestens 1 h.</translation>
    </message>
    <message>
        <source>2 h of unbroken sun, or 2.5 h broken up</source>
        <translation>2 h ununterbrochene Sonne, oder 2,5 h mit Unterbrechungen</translation>
    </message>
    <message>
        <source>Output: h:min and number of intervals</source>
        <translation>Ausgabe: h:min und Zahl der Abschnitte</translation>
    </message>
    <message>
        <source>How many rooms of a flat must have it</source>
        <translation>Wie viele Räume einer Wohnung sie haben müssen</translation>
    </message>
    <message>
        <source>Other zones: change the days in a copy of the rule</source>
        <translation>Andere Zonen: die Tage in einer Kopie der Regel ändern</translation>
    </message>
    <message>
        <source>From 22 April to 22 August at least 2 h of unbroken sun, or 2.5 h broken up with one part of at least 1 h.</source>
        <translation>Vom 22. April bis 22. August mindestens 2 h ununterbrochene Sonne, oder 2,5 h mit Unterbrechungen und einem Teil von mindestens 1 h.</translation>
    </message>
    <message>
        <source>days</source>
        <translation>Tage</translation>
    </message>
    <message>
        <source>every day</source>
        <translation>jeder Tag</translation>
    </message>
    <message>
        <source>mirrored half year</source>
        <translation>gespiegeltes Halbjahr</translation>
    </message>
    <message>
        <source>Net new shadow of the year</source>
        <translation>Netto neuer Schatten des Jahres</translation>
    </message>
    <message>
        <source>Existing shadow, sq ft h</source>
        <translation>Vorhandener Schatten, sq ft h</translation>
    </message>
    <message>
        <source>Shadow with project, sq ft h</source>
        <translation>Schatten mit Projekt, sq ft h</translation>
    </message>
    <message>
        <source>Net new shadow, sq ft h</source>
        <translation>Netto neuer Schatten, sq ft h</translation>
    </message>
    <message>
        <source>Share of the theoretical sum</source>
        <translation>Anteil an der theoretischen Summe</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Largest area, sq ft</source>
        <translation>Größte Fläche, sq ft</translation>
    </message>
    <message>
        <source>Trigger: buildings of more than 40 ft</source>
        <translation>Auslöser: Gebäude von mehr als 40 ft</translation>
    </message>
    <message>
        <source>Hours: from 1 h after sunrise to 1 h before sunset, every day of the year</source>
        <translation>Stunden: von 1 h nach Sonnenaufgang bis 1 h vor Sonnenuntergang, an jedem Tag des Jahres</translation>
    </message>
    <message>
        <source>Theoretical annual available sunlight: area x 3,721.4 h</source>
        <translation>Theoretisch verfügbares Sonnenlicht im Jahr: Fläche x 3.721,4 h</translation>
    </message>
    <message>
        <source>Own count of the same hours: 3,720.9</source>
        <translation>Eigene Zählung derselben Stunden: 3.720,9</translation>
    </message>
    <message>
        <source>Samples of 15 min, mirrored half year</source>
        <translation>Stichproben alle 15 min, gespiegeltes Halbjahr</translation>
    </message>
    <message>
        <source>Absolute limits of single parks and qualitative criteria</source>
        <translation>Absolute Grenzen einzelner Parks und qualitative Kriterien</translation>
    </message>
    <message>
        <source>Cumulative projects: run the rule again with a scenario that holds them</source>
        <translation>Mehrere Vorhaben zusammen: die Regel mit einem Szenario, das sie enthält, noch einmal prüfen</translation>
    </message>
    <message>
        <source>Opening hours of the park</source>
        <translation>Öffnungszeiten des Parks</translation>
    </message>
    <message>
        <source>The trigger (height of the proposal)</source>
        <translation>Der Auslöser (Höhe des Entwurfs)</translation>
    </message>
    <message>
        <source>The figures at hand state no numeric limit, so there are figures and no verdict.</source>
        <translation>Die vorliegenden Zahlen nennen keine Grenze in Zahlen, daher gibt es Zahlen und keinen Befund.</translation>
    </message>
    <message>
        <source>Shadow on a park over a whole year in square-foot-hours, as a share of the theoretical annual available sunlight.</source>
        <translation>Schatten auf einem Park über ein ganzes Jahr in Quadratfuß-Stunden, als Anteil am theoretisch verfügbaren Sonnenlicht des Jahres.</translation>
    </message>
    <message>
        <source>Possible sun</source>
        <translation>Mögliche Sonne</translation>
    </message>
    <message>
        <source>What the rule allows where the norm is missed already</source>
        <translation>Was die Regel erlaubt, wo die Norm schon verfehlt ist</translation>
    </message>
    <message>
        <source>The days and hours are those of the light norm of TNO; the point is on the facade, 0.75 m above the floor.</source>
        <translation>Tage und Stunden sind die der leichten Norm von TNO; der Punkt liegt auf der Fassade, 0,75 m über dem Fußboden.</translation>
    </message>
    <message>
        <source>The sun may be broken up; the worst day decides.</source>
        <translation>Die Sonne darf unterbrochen sein; der schlechteste Tag entscheidet.</translation>
    </message>
    <message>
        <source>At least 2 h of possible sun on every day from 19 February to 21 October on the facade, with the sun above 10 degrees.</source>
        <translation>Mindestens 2 h mögliche Sonne an jedem Tag vom 19. Februar bis 21. Oktober auf der Fassade, mit der Sonne über 10 Grad.</translation>
    </message>
    <message>
        <source>The middle of the sill, inside the glass, usually 0.75 m above the floor</source>
        <translation>Die Mitte der Brüstung, innen an der Scheibe, meist 0,75 m über dem Fußboden</translation>
    </message>
    <message>
        <source>Which facade is that of the living room</source>
        <translation>Welche Fassade die des Wohnzimmers ist</translation>
    </message>
    <message>
        <source>The glass is taken 0.1 m behind the face of the wall (opening.wall_m), and the edges of that opening hide the sun.</source>
        <translation>Das Glas liegt 0,1 m hinter der Wandfläche (opening.wall_m), und die Ränder dieser Öffnung verdecken die Sonne.</translation>
    </message>
    <message>
        <source>At least 2 h of possible sun on every day from 19 February to 21 October, in the middle of the sill.</source>
        <translation>Mindestens 2 h mögliche Sonne an jedem Tag vom 19. Februar bis 21. Oktober, in der Mitte der Brüstung.</translation>
    </message>
    <message>
        <source>At least 3 h of possible sun on every day from 21 January to 22 November, in the middle of the sill.</source>
        <translation>Mindestens 3 h mögliche Sonne an jedem Tag vom 21. Januar bis 22. November, in der Mitte der Brüstung.</translation>
    </message>
    <message>
        <source>Hourly from 9:18 to 18:18 (local mean noon)</source>
        <translation>Stündlich von 9:18 bis 18:18 (mittlerer örtlicher Mittag)</translation>
    </message>
    <message>
        <source>Diagrams on 21 March, June and September</source>
        <translation>Pläne am 21. März, Juni und September</translation>
    </message>
    <message>
        <source>Diagrams on 21 December</source>
        <translation>Pläne am 21. Dezember</translation>
    </message>
    <message>
        <source>On 21 December the hours are those of the wall clock too.</source>
        <translation>Auch am 21. Dezember sind die Stunden die der Uhr.</translation>
    </message>
    <message>
        <source>Hourly diagrams from 9:18 to 18:18 on 21 March, June and September.</source>
        <translation>Stündliche Pläne von 9:18 bis 18:18 am 21. März, Juni und September.</translation>
    </message>
    <message>
        <source>The figures at hand state no limit, so there are figures and no verdict.</source>
        <translation>Die vorliegenden Zahlen nennen keine Grenze, daher gibt es Zahlen und keinen Befund.</translation>
    </message>
    <message>
        <source>The equinoxes are 21 March and 21 September.</source>
        <translation>Die Tagundnachtgleichen sind der 21. März und der 21. September.</translation>
    </message>
    <message>
        <source>Shadow on parks and schoolyards within 10-16 h daylight time, from the spring to the autumn equinox.</source>
        <translation>Schatten auf Parks und Schulhöfen von 10 bis 16 h Sommerzeit, von der Frühlings- bis zur Herbst-Tagundnachtgleiche.</translation>
    </message>
    <message>
        <source>Area with more than 3 h of shadow, and more than by the body within the zoning</source>
        <translation>Fläche mit mehr als 3 h Schatten und mehr als durch den Körper nach Bauordnung</translation>
    </message>
    <message>
        <source>Shadow at the worst spot</source>
        <translation>Schatten an der schlechtesten Stelle</translation>
    </message>
    <message>
        <source>mean winter day</source>
        <translation>mittlerer Wintertag</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Wohnung</translation>
    </message>
    <message>
        <source>Area with more than 3 h and more than before, m²</source>
        <translation>Fläche mit mehr als 3 h und mehr als vorher, m²</translation>
    </message>
    <message>
        <source>Shadow at the worst spot, min</source>
        <translation>Schatten an der schlechtesten Stelle, min</translation>
    </message>
    <message>
        <source>Trigger: buildings of more than 25 m</source>
        <translation>Auslöser: Gebäude von mehr als 25 m</translation>
    </message>
    <message>
        <source>Passes where a body within the zoning shades as much</source>
        <translation>Gilt, wo ein Körper nach Bauordnung ebenso viel Schatten wirft</translation>
    </message>
    <message>
        <source>Facades of the homes: their ground is measured</source>
        <translation>Fassaden der Wohnungen: gemessen wird der Boden davor</translation>
    </message>
    <message>
        <source>Whether the scenario &apos;from&apos; is a body within the zoning</source>
        <translation>Ob das Szenario &apos;from&apos; ein Körper nach Bauordnung ist</translation>
    </message>
    <message>
        <source>The scenario &apos;from&apos; holds the body within the zoning, or nothing on the site.</source>
        <translation>Das Szenario &apos;from&apos; enthält den Körper nach Bauordnung, oder nichts auf dem Grundstück.</translation>
    </message>
    <message>
        <source>Shadow is counted minute by minute from 8 to 17 h; the diagrams show it by the hour.</source>
        <translation>Schatten wird von 8 bis 17 h Minute für Minute gezählt; die Pläne zeigen ihn stündlich.</translation>
    </message>
    <message>
        <source>Each spot is compared with itself: it may have more than 3 h of shadow where the body within the zoning gives it as much. A spot within a minute of 3 h, for each time that shadow comes, is borderline.</source>
        <translation>Jede Stelle wird mit sich selbst verglichen: sie darf mehr als 3 h Schatten haben, wo ihr der Körper nach Bauordnung ebenso viel gibt. Eine Stelle, die je Eintritt des Schattens innerhalb einer Minute an 3 h liegt, ist grenzwertig.</translation>
    </message>
    <message>
        <source>The shadow that the hill casts without any building is not the tower&apos;s: it is not counted.</source>
        <translation>Schatten, den der Hügel ohne jedes Gebäude wirft, ist nicht der des Turms: er zählt nicht.</translation>
    </message>
    <message>
        <source>Buildings of more than 25 m: at most 3 h of shadow on neighbours&apos; homes on 3 November and 8 February, or no more than a body within the zoning.</source>
        <translation>Gebäude von mehr als 25 m: höchstens 3 h Schatten auf Wohnungen der Nachbarn am 3. November und 8. Februar, oder nicht mehr als ein Körper nach Bauordnung.</translation>
    </message>
    <message>
        <source>Slopes: there is no terrain, so the ground is taken as flat</source>
        <translation>Hänge: es gibt kein Gelände, daher gilt der Boden als eben</translation>
    </message>
    <message>
        <source>The rule leaves terrain out; here terrain casts shadow</source>
        <translation>Die Regel lässt Gelände weg; hier wirft es Schatten</translation>
    </message>
    <message>
        <source>Where the windows are: one was assumed in each bay and storey of the facades</source>
        <translation>Wo die Fenster sind: in jeder Achse und jedem Geschoss der Fassaden wurde eines angenommen</translation>
    </message>
</context>
<context>
    <name>StartQuestion</name>
    <message>
        <source>How sunny are our parks and streets?</source>
        <translation>Wie sonnig sind unsere Parks und Straßen?</translation>
    </message>
    <message>
        <source>Hours of sun by place and month, and what lies below a threshold</source>
        <translation>Sonnenstunden nach Ort und Monat, und was unter einer Schwelle liegt</translation>
    </message>
    <message>
        <source>What would a tower change?</source>
        <translation>Was würde ein Turm ändern?</translation>
    </message>
    <message>
        <source>New shadow, the worst spot and the places it reaches, live while you drag</source>
        <translation>Neuer Schatten, die am stärksten betroffene Stelle und die erreichten Orte, live beim Ziehen</translation>
    </message>
    <message>
        <source>Does this proposal pass the rules?</source>
        <translation>Erfüllt dieser Entwurf die Regeln?</translation>
    </message>
    <message>
        <source>Verdicts by the rules of review boards, the site&apos;s first, and a book to file</source>
        <translation>Befunde nach den Regeln von Behörden, die des Standorts zuerst, und ein Berichtsheft zum Einreichen</translation>
    </message>
    <message>
        <source>Which facades and windows get sun?</source>
        <translation>Welche Fassaden und Fenster bekommen Sonne?</translation>
    </message>
    <message>
        <source>Hours of sun and daylight at points of the facades</source>
        <translation>Sonnenstunden und Tageslicht an Punkten der Fassaden</translation>
    </message>
    <message>
        <source>Is the shade where we want it?</source>
        <translation>Ist der Schatten dort, wo wir ihn wollen?</translation>
    </message>
    <message>
        <source>Wanted shade in summer against unwanted shadow in winter, by hour and month</source>
        <translation>Erwünschter Schatten im Sommer gegen unerwünschten im Winter, nach Stunde und Monat</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Architect: design a tower</source>
        <translation>Architektur: einen Turm entwerfen</translation>
    </message>
    <message>
        <source>A tower on a lot, its shadow while you shape it, and what it changes</source>
        <translation>Ein Turm auf einem Grundstück, sein Schatten beim Formen und was er ändert</translation>
    </message>
    <message>
        <source>The green outlines in the view are lots. Towers are designed in the panel Tower.</source>
        <translation>Die grünen Umrisse in der Ansicht sind Grundstücke. Türme werden im Feld Turm entworfen.</translation>
    </message>
    <message>
        <source>The list above has the lots of the project. Design tower puts a first tower on the one chosen.</source>
        <translation>Die Liste darüber enthält die Grundstücke des Projekts. Turm entwerfen setzt einen ersten Turm auf das gewählte.</translation>
    </message>
    <message>
        <source>Type 70 storeys, or drag the arrow on the tower. Its shadow follows, and so do height and floor area.</source>
        <translation>70 Geschosse eingeben oder am Pfeil des Turms ziehen. Schatten, Höhe und Geschossfläche folgen.</translation>
    </message>
    <message>
        <source>Build puts the tower into a new scenario. One undo takes it back.</source>
        <translation>Bauen setzt den Turm in ein neues Szenario. Einmal Rückgängig nimmt ihn zurück.</translation>
    </message>
    <message>
        <source>Brown ground gains shadow, blue loses it. The panel Results has the figures.</source>
        <translation>Brauner Boden gewinnt Schatten, blauer verliert ihn. Das Feld Ergebnisse hat die Zahlen.</translation>
    </message>
    <message>
        <source>File &gt; Export writes the comparison as PDF, picture, tables and data. That is the end of this tour.</source>
        <translation>Datei &gt; Exportieren schreibt den Vergleich als PDF, Bild, Tabellen und Daten. Das ist das Ende dieser Führung.</translation>
    </message>
    <message>
        <source>Planner: weigh shade over a year</source>
        <translation>Planung: Schatten eines Jahres abwägen</translation>
    </message>
    <message>
        <source>Shadow of a whole year, one moment of it, and a score of wanted and unwanted shadow</source>
        <translation>Schatten eines ganzen Jahres, ein Zeitpunkt daraus und eine Bewertung</translation>
    </message>
    <message>
        <source>A study answers four questions. The first is what to measure: choose Hours of shadow.</source>
        <translation>Eine Untersuchung beantwortet vier Fragen. Die erste ist, was gemessen wird: Stunden im Schatten wählen.</translation>
    </message>
    <message>
        <source>The second is when: choose the whole year.</source>
        <translation>Die zweite ist, wann: das ganze Jahr wählen.</translation>
    </message>
    <message>
        <source>Cells of 10 m are enough for a first look; smaller ones take longer.</source>
        <translation>Zellen von 10 m genügen für einen ersten Blick; kleinere dauern länger.</translation>
    </message>
    <message>
        <source>The line above the button says how long a study will take, before it runs. Start it.</source>
        <translation>Die Zeile über dem Knopf sagt vorher, wie lange eine Untersuchung dauert. Starten.</translation>
    </message>
    <message>
        <source>The map shows the whole year. Choose One moment to see sun and shadow at a date and time.</source>
        <translation>Die Karte zeigt das ganze Jahr. Ein Zeitpunkt zeigt Sonne und Schatten zu Datum und Uhrzeit.</translation>
    </message>
    <message>
        <source>Shade is welcome in summer and unwelcome in winter. The panel Weights says how much, month by month.</source>
        <translation>Schatten ist im Sommer willkommen, im Winter nicht. Das Feld Gewichte sagt, wie sehr, Monat für Monat.</translation>
    </message>
    <message>
        <source>Compute score adds up the year by these weights. Above zero, wanted shade outweighs unwanted shadow.</source>
        <translation>Bewerten summiert das Jahr mit diesen Gewichten. Über null überwiegt der erwünschte Schatten.</translation>
    </message>
    <message>
        <source>File &gt; Export writes the score by month as tables, charts and maps for GIS. That is the end of this tour.</source>
        <translation>Datei &gt; Exportieren schreibt die Bewertung nach Monat als Tabellen, Diagramme und Karten für GIS. Das ist das Ende dieser Führung.</translation>
    </message>
    <message>
        <source>Review board: judge a proposal</source>
        <translation>Behörde: einen Entwurf prüfen</translation>
    </message>
    <message>
        <source>A place whose sunlight matters, a proposal, and the verdicts of a rule</source>
        <translation>Ein Ort, dessen Besonnung zählt, ein Entwurf und die Befunde einer Regel</translation>
    </message>
    <message>
        <source>A review needs places whose sunlight matters. Choose Study &gt; Draw place and click the corners of a lawn in the park; Enter finishes.</source>
        <translation>Eine Prüfung braucht Orte, deren Besonnung zählt. Untersuchung &gt; Ort zeichnen wählen und die Ecken einer Wiese im Park anklicken; Eingabe beendet.</translation>
    </message>
    <message>
        <source>It also needs a proposal. Here we design one; usually the project has it already.</source>
        <translation>Sie braucht auch einen Entwurf. Hier entwerfen wir einen; meist enthält das Projekt ihn schon.</translation>
    </message>
    <message>
        <source>Design tower puts a tower on the lot chosen in the list.</source>
        <translation>Turm entwerfen setzt einen Turm auf das in der Liste gewählte Grundstück.</translation>
    </message>
    <message>
        <source>Build makes it a scenario, which can be compared with the existing city.</source>
        <translation>Bauen macht daraus ein Szenario, das mit dem Bestand verglichen werden kann.</translation>
    </message>
    <message>
        <source>Study &gt; Review by a rule opens the panel Review.</source>
        <translation>Untersuchung &gt; Prüfung nach einer Regel öffnet das Feld Prüfung.</translation>
    </message>
    <message>
        <source>Choose the rule of the board, here CEQR of New York. Its tool tip says what it asks and how sure its figures are.</source>
        <translation>Die Regel der Behörde wählen, hier CEQR aus New York. Ihr Hinweis sagt, was sie verlangt und wie sicher ihre Zahlen sind.</translation>
    </message>
    <message>
        <source>Run review judges every ticked place on the days of the rule.</source>
        <translation>Prüfen beurteilt jeden angekreuzten Ort an den Tagen der Regel.</translation>
    </message>
    <message>
        <source>The table has the verdicts and the numbers behind them. Export shows the sheets and writes them with all data. That is the end of this tour.</source>
        <translation>Die Tabelle hat die Befunde und die Zahlen dahinter. Exportieren zeigt die Blätter und schreibt sie mit allen Daten. Das ist das Ende dieser Führung.</translation>
    </message>
    <message>
        <source>Scenario &gt; Compare with the existing city asks what the tower changes. Where that takes longer, the button Compare of the panel Study starts it.</source>
        <translation>Szenario &gt; Mit dem Bestand vergleichen fragt, was der Turm ändert. Wo das länger dauert, startet es der Knopf Vergleichen im Feld Untersuchung.</translation>
    </message>
    <message>
        <source>Play and the two sliders move the sun. Whole period returns to the year.</source>
        <translation>Abspielen und die zwei Regler bewegen die Sonne. Ganzer Zeitraum kehrt zum Jahr zurück.</translation>
    </message>
    <message>
        <source>Give it 90 storeys, so that its shadow reaches the lawn.</source>
        <translation>Ihm 90 Geschosse geben, damit sein Schatten die Wiese erreicht.</translation>
    </message>
</context>
<context>
    <name>TreePanel</name>
    <message>
        <source>With trees, in the mean over the cells, while trees are dragged or planted: the region of the study and the places that change most</source>
        <translation>Mit Bäumen, im Mittel über die Zellen, während Bäume gezogen oder gepflanzt werden: die Region der Studie und die Orte, die sich am meisten ändern</translation>
    </message>
</context>
<context>
    <name>noonmark</name>
    <message>
        <source>Height field</source>
        <translation>Feld der Höhe</translation>
    </message>
    <message>
        <source>Field with the heights (default: found by its name)</source>
        <translation>Feld mit den Höhen (Vorgabe: am Namen erkannt)</translation>
    </message>
    <message>
        <source>found by name</source>
        <translation>am Namen erkannt</translation>
    </message>
    <message>
        <source>Storeys field</source>
        <translation>Feld der Geschosse</translation>
    </message>
    <message>
        <source>Field with the storeys above the ground (default: found by its name)</source>
        <translation>Feld mit den Geschossen über dem Boden (Vorgabe: am Namen erkannt)</translation>
    </message>
    <message>
        <source>Unit of heights</source>
        <translation>Einheit der Höhen</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>wie in der Datei</translation>
    </message>
    <message>
        <source>Height of a storey</source>
        <translation>Höhe eines Geschosses</translation>
    </message>
    <message>
        <source>Height of a storey, 2 to 6 m</source>
        <translation>Höhe eines Geschosses, 2 bis 6 m</translation>
    </message>
    <message>
        <source>Default height</source>
        <translation>Vorgabehöhe</translation>
    </message>
    <message>
        <source>Height of buildings without height data, 1 to 1000 m</source>
        <translation>Höhe von Gebäuden ohne Höhenangabe, 1 bis 1000 m</translation>
    </message>
    <message>
        <source>Terrain from building bases</source>
        <translation>Gelände aus den Fußpunkten der Gebäude</translation>
    </message>
    <message>
        <source>If there is no terrain, derive one from the ground elevations of the buildings; auto (default): only where neighbours stand at different heights</source>
        <translation>Ohne Gelände eines aus den Bodenhöhen der Gebäude ableiten; auto (Vorgabe): nur wo Nachbarn verschieden hoch stehen</translation>
    </message>
    <message>
        <source>Terrain shows</source>
        <translation>Das Gelände zeigt</translation>
    </message>
    <message>
        <source>What terrain rasters show: the bare ground, or a surface with the buildings on it; auto (default): a surface where they jump at the outlines of buildings</source>
        <translation>Was Geländeraster zeigen: den bloßen Boden oder eine Oberfläche mit Gebäuden; auto (Vorgabe): eine Oberfläche, wo sie an Umrissen springen</translation>
    </message>
    <message>
        <source>Missing heights from the surface model</source>
        <translation>Fehlende Höhen aus dem Oberflächenmodell</translation>
    </message>
    <message>
        <source>Give buildings without a height that of the surface model above the ground</source>
        <translation>Gebäude ohne Höhe erhalten die des Oberflächenmodells über dem Boden</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Read this layer only</source>
        <translation>Nur diese Ebene lesen</translation>
    </message>
    <message>
        <source>the polygon layers that hold buildings</source>
        <translation>die Polygonebenen mit Gebäuden</translation>
    </message>
    <message>
        <source>Coordinate system</source>
        <translation>Koordinatensystem</translation>
    </message>
    <message>
        <source>Coordinate reference system of files that do not state it: EPSG:2263</source>
        <translation>Koordinatensystem von Dateien, die keines angeben: EPSG:2263</translation>
    </message>
    <message>
        <source>as in the file (example: EPSG:2263)</source>
        <translation>wie in der Datei (Beispiel: EPSG:2263)</translation>
    </message>
    <message>
        <source>Level of detail</source>
        <translation>Detailgrad</translation>
    </message>
    <message>
        <source>the highest</source>
        <translation>die höchste</translation>
    </message>
    <message>
        <source>Maximum distance</source>
        <translation>Größte Entfernung</translation>
    </message>
    <message>
        <source>Leave out features farther than this from the middle of the data, m</source>
        <translation>Objekte weglassen, die weiter von der Mitte der Daten entfernt sind, m</translation>
    </message>
    <message>
        <source>Mesh north</source>
        <translation>Norden des Modells</translation>
    </message>
    <message>
        <source>Meshes: azimuth of the mesh&apos;s north axis from true north, clockwise, degrees</source>
        <translation>3D-Modelle: Azimut der Nordachse des Modells von geografisch Nord, im Uhrzeigersinn, Grad</translation>
    </message>
    <message>
        <source>Origin located at</source>
        <translation>Ursprung liegt bei</translation>
    </message>
    <message>
        <source>Meshes: position of the mesh&apos;s origin, degrees</source>
        <translation>3D-Modelle: Lage des Ursprungs des Modells, Grad</translation>
    </message>
    <message>
        <source>Buildings stand</source>
        <translation>Gebäude stehen</translation>
    </message>
    <message>
        <source>Where buildings stand: each on the terrain, or at the elevations that the file states (absolute); auto (default): as its bases lie against the terrain</source>
        <translation>Wo Gebäude stehen: jedes auf dem Gelände oder auf den Höhen der Datei (absolute); auto (Vorgabe): je nachdem, wie ihre Fußpunkte zum Gelände liegen</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Achse nach oben</translation>
    </message>
    <message>
        <source>Meshes: the axis that points up, y or z; auto (default): as the format says or the shape suggests</source>
        <translation>3D-Modelle: die Achse nach oben, y oder z; auto (Vorgabe): wie das Format sagt oder die Form nahelegt</translation>
    </message>
    <message>
        <source>Unit of coordinates</source>
        <translation>Einheit der Koordinaten</translation>
    </message>
    <message>
        <source>Receivers</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>cells or points where shadow is measured</source>
        <translation>Zellen oder Punkte, an denen der Schatten gemessen wird</translation>
    </message>
    <message>
        <source>Area of the receivers</source>
        <translation>Fläche der Messpunkte</translation>
    </message>
    <message>
        <source>area of all receivers</source>
        <translation>Fläche aller Messpunkte</translation>
    </message>
    <message>
        <source>Shadow area</source>
        <translation>Schattenfläche</translation>
    </message>
    <message>
        <source>sum over the receivers of (share of the sunlit time in shadow x cell area)</source>
        <translation>Summe über die Messpunkte aus (Anteil der besonnten Zeit im Schatten x Zellfläche)</translation>
    </message>
    <message>
        <source>Mean gross</source>
        <translation>Gesamtschatten, Mittel</translation>
    </message>
    <message>
        <source>minutes in shadow per day, mean over days and receivers</source>
        <translation>Minuten im Schatten am Tag, Mittel über Tage und Messpunkte</translation>
    </message>
    <message>
        <source>Max gross</source>
        <translation>Gesamtschatten, größter</translation>
    </message>
    <message>
        <source>minutes in shadow per day, mean over the days, at the receiver that has most</source>
        <translation>Minuten im Schatten am Tag, Mittel über die Tage, am Messpunkt mit dem meisten</translation>
    </message>
    <message>
        <source>Mean continuous</source>
        <translation>Dauerschatten, Mittel</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow on any day, mean over the receivers</source>
        <translation>längster ununterbrochener Schatten eines Tages, Mittel über die Messpunkte</translation>
    </message>
    <message>
        <source>Max continuous</source>
        <translation>Dauerschatten, größter</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow at any receiver on any day</source>
        <translation>längster ununterbrochener Schatten an einem Messpunkt an einem Tag</translation>
    </message>
    <message>
        <source>Bay</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Facades: width of a bay, one point or window each</source>
        <translation>Fassaden: Breite einer Achse mit je einem Punkt oder Fenster</translation>
    </message>
    <message>
        <source>Storey</source>
        <translation>Geschoss</translation>
    </message>
    <message>
        <source>Height of a storey: facades have one point or window each, windows are numbered by it</source>
        <translation>Höhe eines Geschosses: Fassaden haben je einen Punkt oder ein Fenster, Fenster werden danach nummeriert</translation>
    </message>
    <message>
        <source>Above floor</source>
        <translation>Über Fußboden</translation>
    </message>
    <message>
        <source>Facades: height of the points above the floor</source>
        <translation>Fassaden: Höhe der Punkte über dem Fußboden</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Höhen</translation>
    </message>
    <message>
        <source>Windows: heights are elevations, as those of the city, or metres above the ground below</source>
        <translation>Fenster: Höhen sind Höhenlagen wie die der Stadt oder Meter über dem Boden darunter</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Plane and lines: height above the mean of the ground, of the region or parcel</source>
        <translation>Ebene und Linien: Höhe über dem Mittel des Bodens, des Gebiets oder Grundstücks</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Title block: the project</source>
        <translation>Schriftfeld: das Projekt</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Verfasser</translation>
    </message>
    <message>
        <source>Title block: the author</source>
        <translation>Schriftfeld: der Verfasser</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>Auftraggeber</translation>
    </message>
    <message>
        <source>Title block: the client</source>
        <translation>Schriftfeld: der Auftraggeber</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Title block: the date as printed (default: today)</source>
        <translation>Schriftfeld: das Datum, wie gedruckt (Vorgabe: heute)</translation>
    </message>
    <message>
        <source>Sheet numbers</source>
        <translation>Blattnummern</translation>
    </message>
    <message>
        <source>Title block: A- numbers the sheets A-1, A-2, ...</source>
        <translation>Schriftfeld: A- nummeriert die Blätter A-1, A-2, ...</translation>
    </message>
    <message>
        <source>example: A- for A-1, A-2...</source>
        <translation>Beispiel: A- für A-1, A-2 ...</translation>
    </message>
    <message>
        <source>Sunlit time</source>
        <translation>Besonnte Zeit</translation>
    </message>
    <message>
        <source>minutes of the period with the sun above the horizon</source>
        <translation>Minuten des Zeitraums mit der Sonne über dem Horizont</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>from -1 (shadow is unwanted) to 1 (shade is wanted)</source>
        <translation>von -1 (Schatten unerwünscht) bis 1 (Schatten erwünscht)</translation>
    </message>
    <message>
        <source>Water left out</source>
        <translation>Wasser ausgelassen</translation>
    </message>
    <message>
        <source>area of rivers and lakes in the region, which is no ground</source>
        <translation>Fläche der Flüsse und Seen im Gebiet, die kein Boden ist</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>US survey feet</source>
        <translation>US-Vermessungsfuß</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>decimetres</source>
        <translation>Dezimeter</translation>
    </message>
    <message>
        <source>Unit of numbers without a unit in it: m, ft, us-ft, dm, cm, mm or in (default m)</source>
        <translation>Einheit der Zahlen ohne Einheit: m, ft, us-ft, dm, cm, mm oder in (Vorgabe m)</translation>
    </message>
    <message>
        <source>Meshes: unit of the coordinates: m, ft, us-ft, dm, cm, mm or in (default m)</source>
        <translation>3D-Modelle: Einheit der Koordinaten: m, ft, us-ft, dm, cm, mm oder in (Vorgabe m)</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Untersuchung</translation>
    </message>
    <message>
        <source>Saved result</source>
        <translation>Gespeichertes Ergebnis</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>of the theoretical area x hours</source>
        <translation>der theoretischen Fläche x Stunden</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>Ausgangslage</translation>
    </message>
    <message>
        <source>area in shadow in the baseline</source>
        <translation>Fläche im Schatten in der Ausgangslage</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>area in shadow in the scenario</source>
        <translation>Fläche im Schatten im Szenario</translation>
    </message>
    <message>
        <source>Incremental</source>
        <translation>Zusätzlich</translation>
    </message>
    <message>
        <source>area in shadow in the scenario, lit in the baseline</source>
        <translation>Fläche im Schatten im Szenario, besonnt in der Ausgangslage</translation>
    </message>
    <message>
        <source>Gained</source>
        <translation>Gewonnen</translation>
    </message>
    <message>
        <source>area lit in the scenario, in shadow in the baseline</source>
        <translation>Fläche besonnt im Szenario, im Schatten in der Ausgangslage</translation>
    </message>
    <message>
        <source>Days</source>
        <translation>Tage</translation>
    </message>
    <message>
        <source>Hours of sun</source>
        <translation>Sonnenstunden</translation>
    </message>
    <message>
        <source>hours with the sun above the horizon</source>
        <translation>Stunden mit der Sonne über dem Horizont</translation>
    </message>
    <message>
        <source>Theoretical</source>
        <translation>Theoretisch</translation>
    </message>
    <message>
        <source>area x sunlit hours: without any shadow</source>
        <translation>Fläche x Sonnenstunden: ganz ohne Schatten</translation>
    </message>
    <message>
        <source>area x hours in shadow in the baseline</source>
        <translation>Fläche x Stunden im Schatten in der Ausgangslage</translation>
    </message>
    <message>
        <source>area x hours in shadow in the scenario</source>
        <translation>Fläche x Stunden im Schatten im Szenario</translation>
    </message>
    <message>
        <source>area x hours in shadow in the scenario, lit in the baseline</source>
        <translation>Fläche x Stunden im Schatten im Szenario, besonnt in der Ausgangslage</translation>
    </message>
    <message>
        <source>area x hours lit in the scenario, in shadow in the baseline</source>
        <translation>Fläche x Stunden besonnt im Szenario, im Schatten in der Ausgangslage</translation>
    </message>
    <message>
        <source>Share of baseline</source>
        <translation>Anteil der Ausgangslage</translation>
    </message>
    <message>
        <source>Share of scenario</source>
        <translation>Anteil des Szenarios</translation>
    </message>
    <message>
        <source>Share of incremental</source>
        <translation>Anteil des zusätzlichen Schattens</translation>
    </message>
    <message>
        <source>Open ground</source>
        <translation>Freie Fläche</translation>
    </message>
    <message>
        <source>area of the place without buildings</source>
        <translation>Fläche des Orts ohne Gebäude</translation>
    </message>
    <message>
        <source>Mean sun</source>
        <translation>Mittlere Sonne</translation>
    </message>
    <message>
        <source>hours of sun a day, mean over the days and the place</source>
        <translation>Sonnenstunden am Tag, Mittel über die Tage und den Ort</translation>
    </message>
    <message>
        <source>Min sun</source>
        <translation>Kleinste Besonnung</translation>
    </message>
    <message>
        <source>hours of sun a day, mean over the days, at the cell that has least</source>
        <translation>Sonnenstunden am Tag, Mittel über die Tage, an der Zelle mit den wenigsten</translation>
    </message>
    <message>
        <source>Max sun</source>
        <translation>Größte Besonnung</translation>
    </message>
    <message>
        <source>hours of sun a day, mean over the days, at the cell that has most</source>
        <translation>Sonnenstunden am Tag, Mittel über die Tage, an der Zelle mit den meisten</translation>
    </message>
    <message>
        <source>Share with enough sun</source>
        <translation>Anteil mit genug Sonne</translation>
    </message>
    <message>
        <source>share of the area with the hours of sun a day that are enough, or more</source>
        <translation>Anteil der Fläche mit genug Sonnenstunden am Tag oder mehr</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>points where sun is measured</source>
        <translation>Punkte, an denen die Sonne gemessen wird</translation>
    </message>
    <message>
        <source>mean minutes a day with the sun above the horizon: 100 % of the time</source>
        <translation>mittlere Minuten am Tag mit der Sonne über dem Horizont: 100 % der Zeit</translation>
    </message>
    <message>
        <source>Least sun</source>
        <translation>Wenigste Sonne</translation>
    </message>
    <message>
        <source>Most sun</source>
        <translation>Meiste Sonne</translation>
    </message>
    <message>
        <source>minutes in shadow per day, mean over days and points; a point that faces away from the sun is in shadow</source>
        <translation>Minuten im Schatten am Tag, Mittel über Tage und Punkte; ein Punkt, der der Sonne abgewandt ist, liegt im Schatten</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow on any day, mean over the points</source>
        <translation>längster ununterbrochener Schatten eines Tages, Mittel über die Punkte</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow at any point on any day</source>
        <translation>längster ununterbrochener Schatten an einem Punkt an einem Tag</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>minutes per day that a point is in the sun, mean over the days</source>
        <translation>Minuten am Tag, die ein Punkt in der Sonne liegt, Mittel über die Tage</translation>
    </message>
    <message>
        <source>Share of time</source>
        <translation>Anteil der Zeit</translation>
    </message>
    <message>
        <source>sun, of the time with the sun above the horizon</source>
        <translation>Sonne, von der Zeit mit der Sonne über dem Horizont</translation>
    </message>
    <message>
        <source>Gross</source>
        <translation>Gesamt</translation>
    </message>
    <message>
        <source>minutes in shadow per day, mean over the days; a point that faces away from the sun is in shadow</source>
        <translation>Minuten im Schatten am Tag, Mittel über die Tage; ein Punkt, der der Sonne abgewandt ist, liegt im Schatten</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>longest unbroken run in shadow on any day</source>
        <translation>längster ununterbrochener Schatten eines Tages</translation>
    </message>
    <message>
        <source>Longest sun</source>
        <translation>Längste Sonne</translation>
    </message>
    <message>
        <source>longest unbroken run in the sun on any day</source>
        <translation>längste ununterbrochene Sonne eines Tages</translation>
    </message>
    <message>
        <source>minutes of the month with the sun above the horizon</source>
        <translation>Minuten des Monats mit der Sonne über dem Horizont</translation>
    </message>
    <message>
        <source>Mean shadow</source>
        <translation>Mittlerer Schatten</translation>
    </message>
    <message>
        <source>minutes in shadow in the whole month, mean over the receivers</source>
        <translation>Minuten im Schatten im ganzen Monat, Mittel über die Messpunkte</translation>
    </message>
    <message>
        <source>Number of days</source>
        <translation>Anzahl der Tage</translation>
    </message>
    <message>
        <source>Hours per day</source>
        <translation>Stunden am Tag</translation>
    </message>
    <message>
        <source>Hours a day, 0 to 24; 0 is one instant</source>
        <translation>Stunden am Tag, 0 bis 24; 0 ist ein Augenblick</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Length of a step, minutes; adjusted so that whole steps fill the hours of each day</source>
        <translation>Länge eines Schritts in Minuten; so angepasst, dass ganze Schritte die Stunden jedes Tages füllen</translation>
    </message>
    <message>
        <source>More shadow</source>
        <translation>Mehr Schatten</translation>
    </message>
    <message>
        <source>area where the minutes rose by more than the threshold</source>
        <translation>Fläche, auf der die Minuten um mehr als die Schwelle zunahmen</translation>
    </message>
    <message>
        <source>Less shadow</source>
        <translation>Weniger Schatten</translation>
    </message>
    <message>
        <source>area where the minutes fell by more than the threshold</source>
        <translation>Fläche, auf der die Minuten um mehr als die Schwelle abnahmen</translation>
    </message>
    <message>
        <source>Any more shadow</source>
        <translation>Überhaupt mehr Schatten</translation>
    </message>
    <message>
        <source>area where the minutes rose at all</source>
        <translation>Fläche, auf der die Minuten überhaupt zunahmen</translation>
    </message>
    <message>
        <source>Any less shadow</source>
        <translation>Überhaupt weniger Schatten</translation>
    </message>
    <message>
        <source>area where the minutes fell at all</source>
        <translation>Fläche, auf der die Minuten überhaupt abnahmen</translation>
    </message>
    <message>
        <source>Mean change</source>
        <translation>Mittlere Änderung</translation>
    </message>
    <message>
        <source>mean of the change over the receivers</source>
        <translation>Mittel der Änderung über die Messpunkte</translation>
    </message>
    <message>
        <source>Largest increase</source>
        <translation>Größte Zunahme</translation>
    </message>
    <message>
        <source>the largest increase of a receiver</source>
        <translation>die größte Zunahme eines Messpunkts</translation>
    </message>
    <message>
        <source>Largest decrease</source>
        <translation>Größte Abnahme</translation>
    </message>
    <message>
        <source>the largest decrease of a receiver</source>
        <translation>die größte Abnahme eines Messpunkts</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>change that counts: minutes a day of gross shadow, minutes of continuous shadow</source>
        <translation>Änderung, die zählt: Minuten Gesamtschatten am Tag, Minuten Dauerschatten</translation>
    </message>
    <message>
        <source>Change of the shadow area</source>
        <translation>Änderung der Schattenfläche</translation>
    </message>
    <message>
        <source>change of the sum over the receivers of (share of the sunlit time in shadow x cell area)</source>
        <translation>Änderung der Summe über die Messpunkte aus (Anteil der besonnten Zeit im Schatten x Zellfläche)</translation>
    </message>
    <message>
        <source>Built over</source>
        <translation>Überbaut</translation>
    </message>
    <message>
        <source>open ground before, under a building after: no receiver</source>
        <translation>vorher freier Boden, nachher unter einem Gebäude: kein Messpunkt</translation>
    </message>
    <message>
        <source>Became ground</source>
        <translation>Boden geworden</translation>
    </message>
    <message>
        <source>under a building before, open ground after: no receiver</source>
        <translation>vorher unter einem Gebäude, nachher freier Boden: kein Messpunkt</translation>
    </message>
    <message>
        <source>Share of the lot</source>
        <translation>Anteil am Grundstück</translation>
    </message>
    <message>
        <source>Floor plate, % of the lot (default: all of it)</source>
        <translation>Geschossplatte, % des Grundstücks (Vorgabe: ganz)</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Floor plate, m2</source>
        <translation>Geschossplatte, m²</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Verjüngung</translation>
    </message>
    <message>
        <source>How much narrower the volume is at its top than at its bottom</source>
        <translation>Um wie viel schmaler das Volumen oben ist als unten</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Verdrehung</translation>
    </message>
    <message>
        <source>Turn of the volume from its bottom to its top, clockwise</source>
        <translation>Drehung des Volumens von unten nach oben, im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Storey height</source>
        <translation>Geschosshöhe</translation>
    </message>
    <message>
        <source>Height of a storey, floor to floor</source>
        <translation>Höhe eines Geschosses, von Boden zu Boden</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>Geschosse</translation>
    </message>
    <message>
        <source>Number of storeys, podium included</source>
        <translation>Anzahl der Geschosse, mit Sockel</translation>
    </message>
    <message>
        <source>Height above ground</source>
        <translation>Höhe über Gelände</translation>
    </message>
    <message>
        <source>Total height</source>
        <translation>Gesamthöhe</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Rotation clockwise about the middle of the tower, which must stay on its lot</source>
        <translation>Drehung im Uhrzeigersinn um die Mitte des Turms, der auf seinem Grundstück bleiben muss</translation>
    </message>
    <message>
        <source>Podium</source>
        <translation>Sockel</translation>
    </message>
    <message>
        <source>Storeys of a podium below the tower</source>
        <translation>Geschosse eines Sockels unter dem Turm</translation>
    </message>
    <message>
        <source>From height</source>
        <translation>Ab Höhe</translation>
    </message>
    <message>
        <source>Inset</source>
        <translation>Rücksprung</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Nutzung</translation>
    </message>
    <message>
        <source>Setbacks</source>
        <translation>Rücksprünge</translation>
    </message>
    <message>
        <source>Uses</source>
        <translation>Nutzungen</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Metrisch</translation>
    </message>
    <message>
        <source>Imperial</source>
        <translation>Imperial</translation>
    </message>
    <message>
        <source>Metric and imperial</source>
        <translation>Metrisch und imperial</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Units of lengths and areas in tables and sheets</source>
        <translation>Einheiten der Längen und Flächen in Tabellen und Blättern</translation>
    </message>
    <message>
        <source>Score per m² of ground</source>
        <translation>Wert je m² Boden</translation>
    </message>
    <message>
        <source>score divided by the area of all receivers</source>
        <translation>Wert geteilt durch die Fläche aller Messpunkte</translation>
    </message>
    <message>
        <source>time in the sun per day, mean over days and points</source>
        <translation>Zeit in der Sonne am Tag, Mittel über Tage und Punkte</translation>
    </message>
    <message>
        <source>time in the sun per day at the darkest point</source>
        <translation>Zeit in der Sonne am Tag am dunkelsten Punkt</translation>
    </message>
    <message>
        <source>time in the sun per day at the sunniest point</source>
        <translation>Zeit in der Sonne am Tag am sonnigsten Punkt</translation>
    </message>
    <message>
        <source>Sun by place</source>
        <translation>Sonne nach Ort</translation>
    </message>
    <message>
        <source>hours of sun a day</source>
        <translation>Sonnenstunden am Tag</translation>
    </message>
    <message>
        <source>Share of the area, %</source>
        <translation>Anteil der Fläche, %</translation>
    </message>
    <message>
        <source>Area that changes, m²</source>
        <translation>Fläche mit Änderung, m²</translation>
    </message>
    <message>
        <source>minutes of shadow a day, more than before</source>
        <translation>Minuten im Schatten am Tag, mehr als vorher</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>What maps and sheets show: minutes of shadow, hours of sun, or the share of the sunlit time in the sun</source>
        <translation>Was Karten und Blätter zeigen: Minuten im Schatten, Sonnenstunden oder den Anteil der besonnten Zeit in der Sonne</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Turn the colours round: bright where there is much shadow</source>
        <translation>Die Farben umkehren: hell, wo viel Schatten ist</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Values at the ends of the legend, in the unit shown: 0:8; without it fitted to each map</source>
        <translation>Werte an den Enden der Legende, in der gezeigten Einheit: 0:8; ohne Angabe an jede Karte angepasst</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>angepasst</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Klassen</translation>
    </message>
    <message>
        <source>Classes of the legend: continuous, equal:5, quantiles:5, or the numbers between them: 2,4,6; one number is a threshold</source>
        <translation>Klassen der Legende: continuous, equal:5, quantiles:5 oder die Zahlen dazwischen: 2,4,6; eine einzelne Zahl ist eine Schwelle</translation>
    </message>
    <message>
        <source>%1 of the area in shadow</source>
        <translation>%1 der Fläche im Schatten</translation>
    </message>
    <message>
        <source>%1: %2 in shadow</source>
        <translation>%1: %2 im Schatten</translation>
    </message>
    <message>
        <source>%1 of sun a day, %2 in shade</source>
        <translation>%1 Sonne am Tag, %2 im Schatten</translation>
    </message>
    <message>
        <source>%1: %2 of sun a day, %3 in shade</source>
        <translation>%1: %2 Sonne am Tag, %3 im Schatten</translation>
    </message>
    <message>
        <source>Of %1 a day with the sun up, the darkest spot gets %2.</source>
        <translation>Von %1 am Tag mit der Sonne über dem Horizont erhält die dunkelste Stelle %2.</translation>
    </message>
    <message>
        <source>The longest unbroken shadow lasts %1.</source>
        <translation>Der längste ununterbrochene Schatten dauert %1.</translation>
    </message>
    <message>
        <source>sunlit time minus gross shadow per day, mean over days and receivers</source>
        <translation>besonnte Zeit minus Gesamtschatten am Tag, Mittel über Tage und Messpunkte</translation>
    </message>
    <message>
        <source>Enough sun</source>
        <translation>Genug Sonne</translation>
    </message>
    <message>
        <source>Hours of sun a day that are enough: the share of each place that has them is stated</source>
        <translation>Sonnenstunden am Tag, die genügen: angegeben wird der Anteil jedes Orts, der sie hat</translation>
    </message>
    <message>
        <source>Dates</source>
        <translation>Stichtage</translation>
    </message>
    <message>
        <source>A day: the share of each place with less than enough sun on it is stated; may be repeated</source>
        <translation>Ein Tag: angegeben wird der Anteil jedes Orts mit weniger als genug Sonne an diesem Tag; darf wiederholt werden</translation>
    </message>
    <message>
        <source>Loss that counts</source>
        <translation>Verlust, der zählt</translation>
    </message>
    <message>
        <source>Minutes of sun a day: the share of each place that loses more is stated</source>
        <translation>Minuten Sonne am Tag: angegeben wird der Anteil jedes Orts, der mehr verliert</translation>
    </message>
    <message>
        <source>%1 of %2 places have less than %3 of sun a day</source>
        <translation>%1 von %2 Orten haben weniger als %3 Sonne am Tag</translation>
    </message>
    <message>
        <source>Change of mean sun</source>
        <translation>Änderung der mittleren Sonne</translation>
    </message>
    <message>
        <source>hours of sun a day more than in the baseline, mean over the days and the place; negative: less</source>
        <translation>Sonnenstunden am Tag mehr als in der Ausgangslage, Mittel über die Tage und den Ort; negativ: weniger</translation>
    </message>
    <message>
        <source>Largest loss</source>
        <translation>Größter Verlust</translation>
    </message>
    <message>
        <source>minutes of sun a day less than in the baseline, mean over the days, at the cell that loses most</source>
        <translation>Minuten Sonne am Tag weniger als in der Ausgangslage, Mittel über die Tage, an der Zelle, die am meisten verliert</translation>
    </message>
    <message>
        <source>Largest gain</source>
        <translation>Größter Gewinn</translation>
    </message>
    <message>
        <source>minutes of sun a day more than in the baseline, mean over the days, at the cell that gains most</source>
        <translation>Minuten Sonne am Tag mehr als in der Ausgangslage, Mittel über die Tage, an der Zelle, die am meisten gewinnt</translation>
    </message>
    <message>
        <source>Share that loses sun</source>
        <translation>Anteil, der Sonne verliert</translation>
    </message>
    <message>
        <source>share of the area that loses more minutes of sun a day than the threshold of loss</source>
        <translation>Anteil der Fläche, der mehr Minuten Sonne am Tag verliert als die Verlustschwelle</translation>
    </message>
    <message>
        <source>Attributed shadow</source>
        <translation>Zugerechneter Schatten</translation>
    </message>
    <message>
        <source>the part of the shadow that one building is charged with; the attributed shadows of all buildings and of the terrain add up to the total</source>
        <translation>der Teil des Schattens, der einem Gebäude zugerechnet wird; die zugerechneten Schatten aller Gebäude und des Geländes ergeben zusammen den ganzen Schatten</translation>
    </message>
    <message>
        <source>Sole contribution</source>
        <translation>Alleiniger Beitrag</translation>
    </message>
    <message>
        <source>the shadow that would disappear if only this building were gone</source>
        <translation>der Schatten, der verschwände, wenn nur dieses Gebäude fehlte</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>attributed shadow, as a share of all shadow on the cells</source>
        <translation>zugerechneter Schatten als Anteil am gesamten Schatten auf den Zellen</translation>
    </message>
    <message>
        <source>Attributed</source>
        <translation>Zugerechnet</translation>
    </message>
    <message>
        <source>attributed shadow in minutes a day, mean over the cells</source>
        <translation>zugerechneter Schatten in Minuten am Tag, Mittel über die Zellen</translation>
    </message>
    <message>
        <source>Sole</source>
        <translation>Allein</translation>
    </message>
    <message>
        <source>sole contribution in minutes a day, mean over the cells</source>
        <translation>alleiniger Beitrag in Minuten am Tag, Mittel über die Zellen</translation>
    </message>
    <message>
        <source>Attributed area x hours</source>
        <translation>Zugerechnete Fläche x Stunden</translation>
    </message>
    <message>
        <source>attributed shadow as area x hours of the whole period</source>
        <translation>zugerechneter Schatten als Fläche x Stunden des ganzen Zeitraums</translation>
    </message>
    <message>
        <source>Sole area x hours</source>
        <translation>Alleinige Fläche x Stunden</translation>
    </message>
    <message>
        <source>sole contribution as area x hours of the whole period</source>
        <translation>alleiniger Beitrag als Fläche x Stunden des ganzen Zeitraums</translation>
    </message>
    <message>
        <source>%1 of sun a day on average at %2 points</source>
        <translation>%1 Sonne am Tag im Mittel an %2 Punkten</translation>
    </message>
    <message>
        <source>The darkest point gets %1, the sunniest %2, of %3 a day with the sun up.</source>
        <translation>Der dunkelste Punkt erhält %1, der sonnigste %2, von %3 am Tag mit der Sonne über dem Horizont.</translation>
    </message>
    <message>
        <source>Share of the points, %</source>
        <translation>Anteil der Punkte, %</translation>
    </message>
    <message>
        <source>%1 changes no shadow here</source>
        <translation>%1 ändert hier keinen Schatten</translation>
    </message>
    <message>
        <source>%1 takes %2 of sun a day on average, at most %3 at one spot</source>
        <translation>%1 nimmt im Mittel %2 Sonne am Tag, höchstens %3 an einer Stelle</translation>
    </message>
    <message>
        <source>%1 gives %2 of sun a day on average, at most %3 at one spot</source>
        <translation>%1 gibt im Mittel %2 Sonne am Tag, höchstens %3 an einer Stelle</translation>
    </message>
    <message>
        <source>More shadow on %1, less on %2; by more than %3 a day on %4 and %5.</source>
        <translation>Mehr Schatten auf %1, weniger auf %2; um mehr als %3 am Tag auf %4 und %5.</translation>
    </message>
    <message>
        <source>%1 changes the shadow by %2 at this moment</source>
        <translation>%1 ändert den Schatten zu diesem Zeitpunkt um %2</translation>
    </message>
    <message>
        <source>%1 scores %2: wanted shade outweighs unwanted shadow</source>
        <translation>%1 hat die Bewertung %2: erwünschter Schatten überwiegt unerwünschten</translation>
    </message>
    <message>
        <source>%1 scores %2: unwanted shadow outweighs wanted shade</source>
        <translation>%1 hat die Bewertung %2: unerwünschter Schatten überwiegt erwünschten</translation>
    </message>
    <message>
        <source>%1 scores 0: wanted shade and unwanted shadow weigh the same</source>
        <translation>%1 hat die Bewertung 0: erwünschter und unerwünschter Schatten wiegen gleich viel</translation>
    </message>
    <message>
        <source>Weighted shade by month, m² h</source>
        <translation>Gewichteter Schatten nach Monat, m² h</translation>
    </message>
    <message>
        <source>Weighted by time: %1.</source>
        <translation>Nach Zeit gewichtet: %1.</translation>
    </message>
    <message>
        <source>Shadow area by month, m²</source>
        <translation>Schattenfläche nach Monat, m²</translation>
    </message>
    <message>
        <source>minutes of sun a day, more than before</source>
        <translation>Minuten Sonne am Tag, mehr als vorher</translation>
    </message>
    <message>
        <source>Colours of maps; all but traffic-light are safe for colour-blind readers. Maps of sun by place take violet-orange unless another is named</source>
        <translation>Farben der Karten; alle außer traffic-light sind für Farbenblinde geeignet. Karten der Sonne nach Orten nehmen violet-orange, wenn keine andere genannt ist</translation>
    </message>
    <message>
        <source>Colours of changes</source>
        <translation>Farben der Änderungen</translation>
    </message>
    <message>
        <source>Colours of differences and scores; all but green-red are safe for colour-blind readers</source>
        <translation>Farben von Unterschieden und Bewertungen; alle außer green-red sind für Farbenblinde geeignet</translation>
    </message>
    <message>
        <source>Changes reversed</source>
        <translation>Änderungen umgekehrt</translation>
    </message>
    <message>
        <source>Turn the colours of differences and scores round</source>
        <translation>Die Farben von Unterschieden und Bewertungen umkehren</translation>
    </message>
    <message>
        <source>Classes of changes</source>
        <translation>Klassen der Änderungen</translation>
    </message>
    <message>
        <source>Classes of the legend of differences and scores, as of --classes; numbers in minutes of a difference: -30,-10,10,30</source>
        <translation>Klassen der Legende von Unterschieden und Bewertungen, wie bei --classes; Zahlen in Minuten eines Unterschieds: -30,-10,10,30</translation>
    </message>
    <message>
        <source>%1 of sun a day, %2 of what is possible</source>
        <translation>%1 Sonne am Tag, %2 des Möglichen</translation>
    </message>
    <message>
        <source>%1: %2 of sun a day, %3 of what is possible</source>
        <translation>%1: %2 Sonne am Tag, %3 des Möglichen</translation>
    </message>
    <message>
        <source>%1 of the possible sun, %2 a day</source>
        <translation>%1 der möglichen Sonne, %2 am Tag</translation>
    </message>
    <message>
        <source>%1: %2 of the possible sun, %3 a day</source>
        <translation>%1: %2 der möglichen Sonne, %3 am Tag</translation>
    </message>
    <message>
        <source>sunlit time minus gross shadow per day, at the receiver that has most shadow</source>
        <translation>besonnte Zeit minus Gesamtschatten am Tag, am Messpunkt mit dem meisten Schatten</translation>
    </message>
    <message>
        <source>Sunlit area</source>
        <translation>Besonnte Fläche</translation>
    </message>
    <message>
        <source>sum over the receivers of (share of the sunlit time in the sun x cell area)</source>
        <translation>Summe über die Messpunkte aus (Anteil der besonnten Zeit in der Sonne x Zellfläche)</translation>
    </message>
    <message>
        <source>Hours of sun a day of the places that change most</source>
        <translation>Sonnenstunden am Tag der Orte, die sich am meisten ändern</translation>
    </message>
    <message>
        <source>places</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>First day</source>
        <translation>Erster Tag</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Time zone</source>
        <translation>Zeitzone</translation>
    </message>
    <message>
        <source>Sun as seen through the air</source>
        <translation>Sonne durch die Luft</translation>
    </message>
    <message>
        <source>Less sun</source>
        <translation>Weniger Sonne</translation>
    </message>
    <message>
        <source>area that lost more minutes of sun than the threshold</source>
        <translation>Fläche, die mehr Minuten Sonne als die Schwelle verlor</translation>
    </message>
    <message>
        <source>More sun</source>
        <translation>Mehr Sonne</translation>
    </message>
    <message>
        <source>area that gained more minutes of sun than the threshold</source>
        <translation>Fläche, die mehr Minuten Sonne als die Schwelle gewann</translation>
    </message>
    <message>
        <source>Any less sun</source>
        <translation>Überhaupt weniger Sonne</translation>
    </message>
    <message>
        <source>area that lost any sun</source>
        <translation>Fläche, die irgendwie Sonne verlor</translation>
    </message>
    <message>
        <source>Any more sun</source>
        <translation>Überhaupt mehr Sonne</translation>
    </message>
    <message>
        <source>area that gained any sun</source>
        <translation>Fläche, die irgendwie Sonne gewann</translation>
    </message>
    <message>
        <source>Mean change of sun</source>
        <translation>Mittlere Änderung der Sonne</translation>
    </message>
    <message>
        <source>mean of the change of sun over the receivers; negative: less sun</source>
        <translation>Mittel der Änderung der Sonne über die Messpunkte; negativ: weniger Sonne</translation>
    </message>
    <message>
        <source>Largest loss of sun</source>
        <translation>Größter Verlust an Sonne</translation>
    </message>
    <message>
        <source>the most sun that a receiver loses</source>
        <translation>die meiste Sonne, die ein Messpunkt verliert</translation>
    </message>
    <message>
        <source>Largest gain of sun</source>
        <translation>Größter Gewinn an Sonne</translation>
    </message>
    <message>
        <source>the most sun that a receiver gains</source>
        <translation>die meiste Sonne, die ein Messpunkt gewinnt</translation>
    </message>
    <message>
        <source>Change of the sunlit area</source>
        <translation>Änderung der besonnten Fläche</translation>
    </message>
    <message>
        <source>change of the sum over the receivers of (share of the sunlit time in the sun x cell area)</source>
        <translation>Änderung der Summe über die Messpunkte aus (Anteil der besonnten Zeit in der Sonne x Zellfläche)</translation>
    </message>
    <message>
        <source>%1 changes no sun here</source>
        <translation>%1 ändert hier keine Sonne</translation>
    </message>
    <message>
        <source>Less sun on %1, more on %2; by more than %3 a day on %4 and %5.</source>
        <translation>Weniger Sonne auf %1, mehr auf %2; um mehr als %3 am Tag auf %4 und %5.</translation>
    </message>
    <message>
        <source>Sunlit area by month, m²</source>
        <translation>Besonnte Fläche nach Monat, m²</translation>
    </message>
    <message>
        <source>Cells of small places</source>
        <translation>Zellen kleiner Orte</translation>
    </message>
    <message>
        <source>Size of the cells of places with fewer than 25 cells, m; no effect if it is not smaller than that of the others</source>
        <translation>Größe der Zellen von Orten mit weniger als 25 Zellen, m; so groß wie die anderen oder größer: dieselbe</translation>
    </message>
    <message>
        <source>Ray reference</source>
        <translation>Strahlreferenz</translation>
    </message>
    <message>
        <source>One ray per receiver and step, traced by Embree: the reference for the errors of the others</source>
        <translation>Ein Strahl je Messpunkt und Schritt, mit Embree verfolgt: die Wahrheit, an der die anderen gemessen werden</translation>
    </message>
    <message>
        <source>Projected shadows</source>
        <translation>Projizierte Schatten</translation>
    </message>
    <message>
        <source>Each building&apos;s shadow filled as polygons at every step: exact and fast on flat ground</source>
        <translation>Der Schatten jedes Gebäudes bei jedem Schritt als Polygon gefüllt: genau und schnell auf ebenem Boden</translation>
    </message>
    <message>
        <source>Horizon sweep</source>
        <translation>Horizontverfahren</translation>
    </message>
    <message>
        <source>The slope of each receiver&apos;s horizon, azimuth by azimuth: a year takes seconds, on terrain and roofs too</source>
        <translation>Die Neigung des Horizonts jedes Messpunkts, Azimut für Azimut: ein Jahr in Augenblicken, auch auf Gelände und Dächern</translation>
    </message>
    <message>
        <source>Shadow accrual map</source>
        <translation>Schattenakkumulationskarte</translation>
    </message>
    <message>
        <source>A depth map of each step of an hour, drawn from a city placed once; hours that look alike computed once</source>
        <translation>Eine Tiefenkarte je Schritt einer Stunde, aus einer einmal gesetzten Stadt; ähnliche Stunden werden einmal berechnet</translation>
    </message>
    <message>
        <source>Inverse accrual map</source>
        <translation>Inverse Akkumulationskarte</translation>
    </message>
    <message>
        <source>Occluders at both ends of each hour, their shadows moved along straight lines between; hours that look alike computed once</source>
        <translation>Schattenwerfer an beiden Enden jeder Stunde, ihre Schatten dazwischen geradlinig bewegt; ähnliche Stunden werden einmal berechnet</translation>
    </message>
    <message>
        <source>Ray reference through the direction graph</source>
        <translation>Strahlreferenz über den Richtungsgraphen</translation>
    </message>
    <message>
        <source>Rays, with hours that look alike traced once: what the graph alone does to the error</source>
        <translation>Strahlen, ähnliche Stunden nur einmal verfolgt: was der Graph allein zum Fehler beiträgt</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Projected shadows, the horizon sweep or rays: the exact one where it is quick, and the result says which and why</source>
        <translation>Projizierte Schatten, Horizontverfahren oder Strahlen: das genaue, wo es schnell ist; das Ergebnis nennt welches und warum</translation>
    </message>
    <message>
        <source>Shadow maps (OpenGL)</source>
        <translation>Schattenkarten (OpenGL)</translation>
    </message>
    <message>
        <source>Draws one depth map per step and tests every cell against it: the method that the paper compares accrual maps with</source>
        <translation>Zeichnet eine Tiefenkarte je Schritt und prüft jede Zelle daran: das Verfahren, mit dem der Artikel vergleicht</translation>
    </message>
    <message>
        <source>Shadow accrual map (OpenGL)</source>
        <translation>Schattenakkumulationskarte (OpenGL)</translation>
    </message>
    <message>
        <source>One draw on the graphics device fills the depth maps of all steps of an hour</source>
        <translation>Ein Zeichenvorgang der Grafikkarte füllt die Tiefenkarten aller Schritte einer Stunde</translation>
    </message>
    <message>
        <source>Error target</source>
        <translation>Fehlerziel</translation>
    </message>
    <message>
        <source>Target for the mean error of a cell&apos;s gross shadow, of the period. Halving it doubles the time of a run</source>
        <translation>Mittlerer Fehler des Gesamtschattens einer Zelle, vom Zeitraum: die Azimutklassen sind so breit, wie er zulässt; der halbe Fehler dauert doppelt so lange</translation>
    </message>
    <message>
        <source>Azimuth bin</source>
        <translation>Azimutklasse</translation>
    </message>
    <message>
        <source>Suns whose azimuth is less than this apart share one horizon; 0: as the error target asks</source>
        <translation>Sonnenstände mit geringerem Azimutabstand teilen einen Horizont; 0: wie es der Zielfehler verlangt</translation>
    </message>
    <message>
        <source>Continuous shadow</source>
        <translation>Dauerschatten</translation>
    </message>
    <message>
        <source>The longest unbroken shadow is counted too; without it, gross shadow only, in about half the time</source>
        <translation>Auch der längste ununterbrochene Schatten wird gezählt; ohne ihn nur der Gesamtschatten, in etwa der halben Zeit</translation>
    </message>
    <message>
        <source>Check runs</source>
        <translation>Dauer prüfen</translation>
    </message>
    <message>
        <source>Map size</source>
        <translation>Kartengröße</translation>
    </message>
    <message>
        <source>Texels along a side of the depth map that is stretched over the region; no more than cells are used</source>
        <translation>Texel je Seite der Tiefenkarte über dem Gebiet; nicht mehr als Zellen</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>How high above the ground something must be to shade it</source>
        <translation>Wie hoch über dem Boden etwas sein muss, um ihn zu verschatten</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Intervall</translation>
    </message>
    <message>
        <source>How long the sun is taken to move in a straight line</source>
        <translation>Wie lange die Sonne als geradlinig bewegt gilt</translation>
    </message>
    <message>
        <source>Direction bound</source>
        <translation>Richtungsschranke</translation>
    </message>
    <message>
        <source>Hours whose sun is less than this apart are computed once</source>
        <translation>Stunden, deren Sonne weniger auseinander liegt, werden einmal berechnet</translation>
    </message>
    <message>
        <source>Source levels</source>
        <translation>Quellebenen</translation>
    </message>
    <message>
        <source>How many occluders, nearest first, are followed from each cell</source>
        <translation>Wie viele Schattenwerfer, die nächsten zuerst, je Zelle verfolgt werden</translation>
    </message>
    <message>
        <source>Sources by rays</source>
        <translation>Quellen mit Strahlen</translation>
    </message>
    <message>
        <source>Embree finds the occluders at an interval&apos;s ends; otherwise filled polygons do, which is faster</source>
        <translation>Embree findet die Schattenwerfer an den Intervallenden; sonst gefüllte Polygone, was schneller ist</translation>
    </message>
    <message>
        <source>Nearest hit</source>
        <translation>Nächster Treffer</translation>
    </message>
    <message>
        <source>Occluders nearer to a cell than this are left out (the paper: 1 m)</source>
        <translation>Schattenwerfer, die näher an einer Zelle sind, werden ausgelassen (Artikel: 1 m)</translation>
    </message>
    <message>
        <source>OpenCL device</source>
        <translation>OpenCL-Gerät</translation>
    </message>
    <message>
        <source>Which OpenCL device draws, counted from 0; -1: the processor itself</source>
        <translation>Welches OpenCL-Gerät zeichnet, ab 0 gezählt; -1: der Prozessor selbst</translation>
    </message>
    <message>
        <source>Rays look at every step of every longest run, so that a gap between two walls in one line is found too; without it, they look at what neighbouring bins leave in doubt</source>
        <translation>Strahlen prüfen jeden Schritt jedes längsten Zeitraums, sodass auch eine Lücke zwischen zwei Wänden in einer Linie gefunden wird; ohne dies prüfen sie, was benachbarte Richtungen offenlassen</translation>
    </message>
    <message>
        <source>Gross shadow</source>
        <translation>Gesamtschatten</translation>
    </message>
    <message>
        <source>minutes in shadow a day</source>
        <translation>Minuten im Schatten am Tag</translation>
    </message>
    <message>
        <source>longest run, minutes</source>
        <translation>längste Dauer, Minuten</translation>
    </message>
    <message>
        <source>Change of gross shadow</source>
        <translation>Änderung des Gesamtschattens</translation>
    </message>
    <message>
        <source>Change of continuous shadow</source>
        <translation>Änderung des Dauerschattens</translation>
    </message>
    <message>
        <source>min a day</source>
        <translation>min am Tag</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>scale fitted to this difference</source>
        <translation>Skala dieser Differenz angepasst</translation>
    </message>
    <message>
        <source>Shadow score</source>
        <translation>Schattenbewertung</translation>
    </message>
    <message>
        <source>weight × share of time</source>
        <translation>Gewicht × Zeitanteil</translation>
    </message>
    <message>
        <source>built over</source>
        <translation>überbaut</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>at this moment</source>
        <translation>zu diesem Zeitpunkt</translation>
    </message>
    <message>
        <source>scale locked: %1</source>
        <translation>Skala fest: %1</translation>
    </message>
    <message>
        <source>largest %1</source>
        <translation>größte %1</translation>
    </message>
    <message>
        <source>Verdicts on windows</source>
        <translation>Befunde über Fenster</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
    <message>
        <source>Change of verdicts</source>
        <translation>Änderung der Befunde</translation>
    </message>
    <message>
        <source>from before to after</source>
        <translation>von vorher zu nachher</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>erfüllt</translation>
    </message>
    <message>
        <source>borderline</source>
        <translation>grenzwertig</translation>
    </message>
    <message>
        <source>fail</source>
        <translation>nicht erfüllt</translation>
    </message>
    <message>
        <source>not applicable</source>
        <translation>nicht anwendbar</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>schlechter</translation>
    </message>
    <message>
        <source>better</source>
        <translation>besser</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>unverändert</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>nicht verglichen</translation>
    </message>
    <message>
        <source>Share of the sunlit time</source>
        <translation>Anteil der besonnten Zeit</translation>
    </message>
    <message>
        <source>% in the sun</source>
        <translation>% in der Sonne</translation>
    </message>
    <message>
        <source>Change of sun</source>
        <translation>Änderung der Sonne</translation>
    </message>
    <message>
        <source>CityGML, CityJSON: level of detail (default: the highest)</source>
        <translation>CityGML, CityJSON: Detaillierungsgrad (Vorgabe: der höchste)</translation>
    </message>
    <message>
        <source>%1, with 99 % certainty within %2</source>
        <translation>%1, mit 99 % Sicherheit innerhalb von %2</translation>
    </message>
    <message>
        <source>%1 in the mean, 99 of 100 within %2, at most %3</source>
        <translation>%1 im Mittel, 99 von 100 innerhalb von %2, höchstens %3</translation>
    </message>
    <message>
        <source>%1 takes more than a minute of sun a day from %2 places, at most %3 at one spot.</source>
        <translation>%1 nimmt %2 Orten mehr als eine Minute Sonne am Tag, höchstens %3 an einer Stelle.</translation>
    </message>
    <message>
        <source>Floor plate</source>
        <translation>Geschossplatte</translation>
    </message>
    <message>
        <source>Gross floor area</source>
        <translation>Bruttogrundfläche</translation>
    </message>
    <message>
        <source>Floor area ratio (FAR)</source>
        <translation>Geschossflächenzahl (GFZ)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Verdicts on places</source>
        <translation>Befunde über Orte</translation>
    </message>
    <message>
        <source>Review of windows</source>
        <translation>Prüfung der Fenster</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Inventories of trees</source>
        <translation>Baumkataster</translation>
    </message>
    <message>
        <source>File with trees beside those of the city&apos;s files: points or a table with species, height, crown or stem; may be repeated</source>
        <translation>Datei mit Bäumen zusätzlich zu denen der Stadtdateien: Punkte oder eine Tabelle mit Art, Höhe, Krone oder Stamm; mehrfach möglich</translation>
    </message>
    <message>
        <source>Change of the minutes of sun a day by month</source>
        <translation>Änderung der Minuten Sonne am Tag nach Monat</translation>
    </message>
    <message>
        <source>Change of the minutes of sun a day of these places</source>
        <translation>Änderung der Minuten Sonne am Tag dieser Orte</translation>
    </message>
    <message>
        <source>%1 and %2 take the same sun: %3 a day on average over the places.</source>
        <translation>%1 und %2 nehmen gleich viel Sonne: %3 am Tag im Mittel über die Orte.</translation>
    </message>
    <message>
        <source>%1 takes less sun than %2: %3 against %4 a day on average over the places.</source>
        <translation>%1 nimmt weniger Sonne als %2: %3 gegenüber %4 am Tag im Mittel über die Orte.</translation>
    </message>
    <message>
        <source>On %1 it has %2; %3 of its area has less than %4.</source>
        <translation>Am %1 hat der Ort %2; %3 seiner Fläche hat weniger als %4.</translation>
    </message>
    <message>
        <source>%1 gives it %2 of sun a day, at most %3 at one spot.</source>
        <translation>%1 gibt dem Ort %2 Sonne am Tag, höchstens %3 an einer Stelle.</translation>
    </message>
    <message>
        <source>%1 takes %2 of sun a day from it, at most %3 at one spot.</source>
        <translation>%1 nimmt dem Ort %2 Sonne am Tag, höchstens %3 an einer Stelle.</translation>
    </message>
    <message>
        <source>%1 of %2 places fail %3 in %4</source>
        <translation>%1 von %2 Orten erfüllen %3 in %4 nicht</translation>
    </message>
    <message>
        <source>No place fails %3 in %4, but %1 of %2 are borderline</source>
        <translation>Kein Ort verfehlt %3 in %4, aber %1 von %2 sind grenzwertig</translation>
    </message>
    <message>
        <source>All of the %2 places judged pass %3 in %4</source>
        <translation>Alle %2 beurteilten Orte erfüllen %3 in %4</translation>
    </message>
    <message>
        <source>%3 judges none of the places in %4</source>
        <translation>%3 beurteilt keinen der Orte in %4</translation>
    </message>
    <message>
        <source>%1 of %2 windows fail %3 in %4</source>
        <translation>%1 von %2 Fenstern erfüllen %3 in %4 nicht</translation>
    </message>
    <message>
        <source>No window fails %3 in %4, but %1 of %2 are borderline</source>
        <translation>Kein Fenster verfehlt %3 in %4, aber %1 von %2 sind grenzwertig</translation>
    </message>
    <message>
        <source>All of the %2 windows judged pass %3 in %4</source>
        <translation>Alle %2 beurteilten Fenster erfüllen %3 in %4</translation>
    </message>
    <message>
        <source>%3 judges none of the windows in %4</source>
        <translation>%3 beurteilt keines der Fenster in %4</translation>
    </message>
    <message>
        <source>Places that fail</source>
        <translation>Orte, die nicht erfüllen</translation>
    </message>
    <message>
        <source>a limit of the rule is exceeded by more than the error of what was measured</source>
        <translation>eine Grenze der Regel ist um mehr als den Fehler der Messung überschritten</translation>
    </message>
    <message>
        <source>Borderline places</source>
        <translation>Grenzwertige Orte</translation>
    </message>
    <message>
        <source>within the error of a limit of the rule</source>
        <translation>innerhalb des Fehlers einer Grenze der Regel</translation>
    </message>
    <message>
        <source>Places that pass</source>
        <translation>Orte, die erfüllen</translation>
    </message>
    <message>
        <source>they keep all limits of the rule</source>
        <translation>sie halten alle Grenzen der Regel ein</translation>
    </message>
    <message>
        <source>Places without a limit</source>
        <translation>Orte ohne Grenze</translation>
    </message>
    <message>
        <source>the rule does not cover them, or states figures only</source>
        <translation>die Regel erfasst sie nicht oder nennt nur Zahlen</translation>
    </message>
    <message>
        <source>Places not checked</source>
        <translation>Nicht geprüfte Orte</translation>
    </message>
    <message>
        <source>nothing could be measured there</source>
        <translation>dort konnte nichts gemessen werden</translation>
    </message>
    <message>
        <source>Windows that fail</source>
        <translation>Fenster, die nicht erfüllen</translation>
    </message>
    <message>
        <source>in the scenario; rooms or dwellings where the rule judges those</source>
        <translation>im Szenario; Räume oder Wohnungen, wo die Regel diese beurteilt</translation>
    </message>
    <message>
        <source>Borderline windows</source>
        <translation>Grenzwertige Fenster</translation>
    </message>
    <message>
        <source>Windows that pass</source>
        <translation>Fenster, die erfüllen</translation>
    </message>
    <message>
        <source>Windows not judged</source>
        <translation>Nicht beurteilte Fenster</translation>
    </message>
    <message>
        <source>the rule does not apply to them, or they were not checked</source>
        <translation>die Regel gilt für sie nicht, oder sie wurden nicht geprüft</translation>
    </message>
    <message>
        <source>Windows that failed before</source>
        <translation>Fenster, die vorher nicht erfüllten</translation>
    </message>
    <message>
        <source>in the baseline, of those that stand in both</source>
        <translation>in der Ausgangslage, von denen, die in beiden stehen</translation>
    </message>
    <message>
        <source>Windows that get worse</source>
        <translation>Fenster, die schlechter werden</translation>
    </message>
    <message>
        <source>from pass to borderline or fail, or from borderline to fail</source>
        <translation>von erfüllt zu grenzwertig oder nicht erfüllt, oder von grenzwertig zu nicht erfüllt</translation>
    </message>
    <message>
        <source>Windows that get better</source>
        <translation>Fenster, die besser werden</translation>
    </message>
    <message>
        <source>from fail to borderline or pass, or from borderline to pass</source>
        <translation>von nicht erfüllt zu grenzwertig oder erfüllt, oder von grenzwertig zu erfüllt</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1 more places fail or are borderline.</source>
        <translation>%1 weitere Orte erfüllen nicht oder sind grenzwertig.</translation>
    </message>
    <message>
        <source>%1 windows get worse than in %2, %3 get better.</source>
        <translation>%1 Fenster werden schlechter als in %2, %3 werden besser.</translation>
    </message>
    <message>
        <source>Shade of trees</source>
        <translation>Schatten von Bäumen</translation>
    </message>
    <message>
        <source>What is measured beside the shadow without trees, where the city has some: without, evergreen, seasonal or all (default)</source>
        <translation>Was neben dem Schatten ohne Bäume gemessen wird, wo die Stadt welche hat: ohne, immergrün, mit Jahreszeiten oder alles (Vorgabe)</translation>
    </message>
    <message>
        <source>After sunrise</source>
        <translation>Nach Sonnenaufgang</translation>
    </message>
    <message>
        <source>Before sunset</source>
        <translation>Vor Sonnenuntergang</translation>
    </message>
    <message>
        <source>Sunrise at</source>
        <translation>Sonnenaufgang bei</translation>
    </message>
    <message>
        <source>Which moment counts as sunrise and sunset: the altitude of the sun&apos;s centre</source>
        <translation>Welcher Zeitpunkt als Sonnenauf- und -untergang gilt: die Höhe der Sonnenmitte</translation>
    </message>
    <message>
        <source>repaired</source>
        <translation>repariert</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>beschnitten</translation>
    </message>
    <message>
        <source>dropped</source>
        <translation>verworfen</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>from storeys</source>
        <translation>aus Geschossen</translation>
    </message>
    <message>
        <source>of a 3D model</source>
        <translation>aus einem 3D-Modell</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>entworfen</translation>
    </message>
    <message>
        <source>made up</source>
        <translation>erfunden</translation>
    </message>
    <message>
        <source>has no area, so it casts no shadow</source>
        <translation>hat keine Fläche und wirft deshalb keinen Schatten</translation>
    </message>
    <message>
        <source>faces without area were left out</source>
        <translation>Teilflächen ohne Flächeninhalt wurden ausgelassen</translation>
    </message>
    <message>
        <source>its surface is not closed; it is used unchanged</source>
        <translation>seine Oberfläche ist nicht geschlossen; es wird unverändert verwendet</translation>
    </message>
    <message>
        <source>its faces pointed inward and were turned</source>
        <translation>seine Teilflächen zeigten nach innen und wurden umgedreht</translation>
    </message>
    <message>
        <source>its outline could not be determined</source>
        <translation>sein Umriss konnte nicht bestimmt werden</translation>
    </message>
    <message>
        <source>Choose the horizon sweep</source>
        <translation>Das Horizontverfahren wählen</translation>
    </message>
    <message>
        <source>Choose projected shadows, or rays on terrain and roofs</source>
        <translation>Projizierte Schatten wählen, auf Gelände und Dächern Strahlen</translation>
    </message>
    <message>
        <source>Choose the horizon sweep or the ray reference</source>
        <translation>Das Horizontverfahren oder die Strahlreferenz wählen</translation>
    </message>
    <message>
        <source>Choose a step of 3 seconds or more</source>
        <translation>Einen Schritt von mindestens 3 Sekunden wählen</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>none: the processor</source>
        <translation>keines: der Prozessor</translation>
    </message>
    <message>
        <source>the coordinates are read as longitude or easting first</source>
        <translation>die Koordinaten werden mit Länge oder Ostwert zuerst gelesen</translation>
    </message>
    <message>
        <source>far from the middle of the data</source>
        <translation>weit von der Mitte der Daten entfernt</translation>
    </message>
    <message>
        <source>one of several polygon layers; all are read as buildings</source>
        <translation>eine von mehreren Polygonebenen; alle werden als Gebäude gelesen</translation>
    </message>
    <message>
        <source>is not tagged as a building</source>
        <translation>ist nicht als Gebäude gekennzeichnet</translation>
    </message>
    <message>
        <source>lies underground</source>
        <translation>liegt unter der Erde</translation>
    </message>
    <message>
        <source>its roof is not flat; it is drawn flat at its full height</source>
        <translation>sein Dach ist nicht flach; es wird flach in voller Höhe dargestellt</translation>
    </message>
    <message>
        <source>its polygons overlapped or shared a wall and were joined</source>
        <translation>seine Polygone überlappten sich oder teilten eine Wand und wurden vereinigt</translation>
    </message>
    <message>
        <source>No file is named</source>
        <translation>Keine Datei ist angegeben</translation>
    </message>
    <message>
        <source>Name at least one file with buildings</source>
        <translation>Mindestens eine Datei mit Gebäuden angeben</translation>
    </message>
    <message>
        <source>None of the files states its position on earth</source>
        <translation>Keine der Dateien nennt ihre Lage auf der Erde</translation>
    </message>
    <message>
        <source>there is no terrain: the ground between the buildings was interpolated from their bases</source>
        <translation>es gibt kein Gelände: der Boden zwischen den Gebäuden wurde aus ihren Fußpunkten interpoliert</translation>
    </message>
    <message>
        <source>buildings beyond the terrain stand on its nearest elevation</source>
        <translation>Gebäude außerhalb des Geländes stehen auf dessen nächster Höhe</translation>
    </message>
    <message>
        <source>The file holds no polygon with an area</source>
        <translation>Die Datei enthält kein Polygon mit einer Fläche</translation>
    </message>
    <message>
        <source>Draw the region as a polygon</source>
        <translation>Das Gebiet als Polygon zeichnen</translation>
    </message>
    <message>
        <source>It is not a polygon in well-known text</source>
        <translation>Es ist kein Polygon in Well-known Text</translation>
    </message>
    <message>
        <source>Give degrees, longitude first: POLYGON ((-73.98 40.76, -73.97 40.76, -73.97 40.77, -73.98 40.76))</source>
        <translation>Grad angeben, Länge zuerst: POLYGON ((-73.98 40.76, -73.97 40.76, -73.97 40.77, -73.98 40.76))</translation>
    </message>
    <message>
        <source>The polygon has no area</source>
        <translation>Das Polygon hat keine Fläche</translation>
    </message>
    <message>
        <source>Give at least three corners</source>
        <translation>Mindestens drei Ecken angeben</translation>
    </message>
    <message>
        <source>There is no such file, and the text is neither four numbers nor a polygon</source>
        <translation>Es gibt keine solche Datei, und der Text ist weder vier Zahlen noch ein Polygon</translation>
    </message>
    <message>
        <source>Give west,south,east,north in degrees, for example -73.99,40.75,-73.98,40.76, a polygon as well-known text, or a polygon file</source>
        <translation>West,Süd,Ost,Nord in Grad angeben, zum Beispiel -73.99,40.75,-73.98,40.76, ein Polygon als Well-known Text oder eine Polygondatei</translation>
    </message>
    <message>
        <source>Names field</source>
        <translation>Feld der Namen</translation>
    </message>
    <message>
        <source>Field with the names of the buildings (default: found by its name)</source>
        <translation>Feld mit den Namen der Gebäude (Vorgabe: am Namen erkannt)</translation>
    </message>
    <message>
        <source>terrain far from the city was left out</source>
        <translation>Gelände weit von der Stadt entfernt wurde ausgelassen</translation>
    </message>
    <message>
        <source>cells without elevation were filled from the cells around</source>
        <translation>Zellen ohne Höhe wurden aus den Zellen ringsum gefüllt</translation>
    </message>
    <message>
        <source>a tree far from the buildings</source>
        <translation>ein Baum weit von den Gebäuden entfernt</translation>
    </message>
    <message>
        <source>a second tree at the same place</source>
        <translation>ein zweiter Baum an derselben Stelle</translation>
    </message>
    <message>
        <source>Choose 0.25 to 10 m</source>
        <translation>0,25 bis 10 m wählen</translation>
    </message>
    <message>
        <source>The region has no area</source>
        <translation>Das Gebiet hat keine Fläche</translation>
    </message>
    <message>
        <source>Draw a polygon with an interior</source>
        <translation>Ein Polygon mit einem Inneren zeichnen</translation>
    </message>
    <message>
        <source>Choose larger cells or a smaller region; the limit is 2.1 billion cells</source>
        <translation>Größere Zellen oder ein kleineres Gebiet wählen; die Grenze liegt bei 2,1 Milliarden Zellen</translation>
    </message>
    <message>
        <source>A corner is not on the globe</source>
        <translation>Eine Ecke liegt nicht auf dem Globus</translation>
    </message>
    <message>
        <source>Give degrees: west,south,east,north</source>
        <translation>Grad angeben: West,Süd,Ost,Nord</translation>
    </message>
    <message>
        <source>The box is empty</source>
        <translation>Das Rechteck ist leer</translation>
    </message>
    <message>
        <source>Give west &lt; east (or west &gt; east across the 180th meridian) and south &lt; north</source>
        <translation>West &lt; Ost (oder West &gt; Ost über den 180. Längengrad hinweg) und Süd &lt; Nord angeben</translation>
    </message>
    <message>
        <source>This is measured on the ground only, not on roofs</source>
        <translation>Das wird nur auf dem Boden gemessen, nicht auf Dächern</translation>
    </message>
    <message>
        <source>Choose the ground, or run a study of the roofs</source>
        <translation>Den Boden wählen oder eine Untersuchung der Dächer berechnen</translation>
    </message>
    <message>
        <source>On average over their area %1 a day, of %2 without any shadow.</source>
        <translation>Im Mittel über ihre Fläche %1 am Tag, von %2 ganz ohne Schatten.</translation>
    </message>
    <message>
        <source>Choose larger cells, a smaller region or fewer steps</source>
        <translation>Größere Zellen, ein kleineres Gebiet oder weniger Schritte wählen</translation>
    </message>
    <message>
        <source>No cell of the region lies on a roof</source>
        <translation>Keine Zelle des Gebiets liegt auf einem Dach</translation>
    </message>
    <message>
        <source>Choose a region with buildings, or smaller cells</source>
        <translation>Ein Gebiet mit Gebäuden oder kleinere Zellen wählen</translation>
    </message>
    <message>
        <source>No cell of the region lies on open ground</source>
        <translation>Keine Zelle des Gebiets liegt auf freiem Boden</translation>
    </message>
    <message>
        <source>Choose a region outside buildings and water, or smaller cells</source>
        <translation>Ein Gebiet außerhalb von Gebäuden und Wasser oder kleinere Zellen wählen</translation>
    </message>
    <message>
        <source>The start is not a date of the calendar</source>
        <translation>Der Anfang ist kein Datum des Kalenders</translation>
    </message>
    <message>
        <source>Give a date such as 2026-03-21</source>
        <translation>Ein Datum wie 2026-03-21 angeben</translation>
    </message>
    <message>
        <source>Choose other dates; the position of the sun is known for these years only</source>
        <translation>Andere Daten wählen; der Sonnenstand ist nur für diese Jahre bekannt</translation>
    </message>
    <message>
        <source>The time of day at which the hours begin is out of range</source>
        <translation>Die Uhrzeit, zu der die Stunden beginnen, liegt außerhalb des zulässigen Bereichs</translation>
    </message>
    <message>
        <source>Give 00:00 to 24:00</source>
        <translation>00:00 bis 24:00 angeben</translation>
    </message>
    <message>
        <source>Give 0 (one instant), or 0.00028 to 24</source>
        <translation>0 (ein Augenblick) oder 0,00028 bis 24 angeben</translation>
    </message>
    <message>
        <source>The hours after sunrise or before sunset are out of range</source>
        <translation>Die Stunden nach Sonnenaufgang oder vor Sonnenuntergang liegen außerhalb des zulässigen Bereichs</translation>
    </message>
    <message>
        <source>Give at most 12 hours on either side</source>
        <translation>Auf jeder Seite höchstens 12 Stunden angeben</translation>
    </message>
    <message>
        <source>Choose a longer step or fewer days; the limit is 50 million steps</source>
        <translation>Einen längeren Schritt oder weniger Tage wählen; die Grenze liegt bei 50 Millionen Schritten</translation>
    </message>
    <message>
        <source>The sun is below the horizon all the time</source>
        <translation>Die Sonne steht die ganze Zeit unter dem Horizont</translation>
    </message>
    <message>
        <source>Choose other hours or days</source>
        <translation>Andere Stunden oder Tage wählen</translation>
    </message>
    <message>
        <source>%1 takes sun from %2, at most %3 a day at one spot</source>
        <translation>%1 nimmt auf %2 Sonne, höchstens %3 am Tag an einer Stelle</translation>
    </message>
    <message>
        <source>%1 gives sun to %2, at most %3 a day at one spot</source>
        <translation>%1 gibt auf %2 Sonne, höchstens %3 am Tag an einer Stelle</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Between the pieces of the lot of several towers</source>
        <translation>Zwischen den Teilen des Grundstücks bei mehreren Türmen</translation>
    </message>
    <message>
        <source>Further towers</source>
        <translation>Weitere Türme</translation>
    </message>
    <message>
        <source>%1 everywhere</source>
        <translation>%1 überall</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>On %1, %2 of %3 places have less than %4.</source>
        <translation>Am %1 sind es %2 von %3 Orten, die weniger als %4 haben.</translation>
    </message>
    <message>
        <source>%1 has the least sun, %2 a day, and %3 the most, %4.</source>
        <translation>Am wenigsten Sonne hat %1 mit %2 am Tag, am meisten %3 mit %4.</translation>
    </message>
    <message>
        <source>%1: no open ground was measured</source>
        <translation>%1: Es wurde keine freie Fläche gemessen</translation>
    </message>
    <message>
        <source>%1: %2 of sun a day; %3 of its area has %4 or more</source>
        <translation>%1: %2 Sonne am Tag; %3 der Fläche hat %4 oder mehr</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Latin name; its genus decides shape, density and leaves</source>
        <translation>Lateinischer Name; die Gattung bestimmt Form, Dichte und Laub</translation>
    </message>
    <message>
        <source>Height above the ground, m</source>
        <translation>Höhe über dem Boden, m</translation>
    </message>
    <message>
        <source>estimated from crown or stem</source>
        <translation>aus Krone oder Stamm geschätzt</translation>
    </message>
    <message>
        <source>Crown diameter</source>
        <translation>Kronendurchmesser</translation>
    </message>
    <message>
        <source>Diameter of the crown, m</source>
        <translation>Durchmesser der Krone, m</translation>
    </message>
    <message>
        <source>estimated from stem or height</source>
        <translation>aus Stamm oder Höhe geschätzt</translation>
    </message>
    <message>
        <source>Crown base</source>
        <translation>Kronenansatz</translation>
    </message>
    <message>
        <source>Height of the crown&apos;s lower end above the ground, m</source>
        <translation>Höhe des unteren Kronenendes über dem Boden, m</translation>
    </message>
    <message>
        <source>a share of the height</source>
        <translation>ein Anteil der Höhe</translation>
    </message>
    <message>
        <source>Stem diameter</source>
        <translation>Stammdurchmesser</translation>
    </message>
    <message>
        <source>Diameter of the stem at breast height, m</source>
        <translation>Durchmesser des Stamms in Brusthöhe, m</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>With trees as evergreens it is %1 a day.</source>
        <translation>Mit immergrünen Bäumen sind es %1 am Tag.</translation>
    </message>
    <message>
        <source>With trees that lose their leaves by season it is %1 a day.</source>
        <translation>Mit Bäumen, die je nach Jahreszeit kahl sind, sind es %1 am Tag.</translation>
    </message>
    <message>
        <source>With trees as evergreens: %1; %2 of its area has %3 or more.</source>
        <translation>Mit immergrünen Bäumen: %1; %2 seiner Fläche hat %3 oder mehr.</translation>
    </message>
    <message>
        <source>With trees that lose their leaves by season: %1; %2 of its area has %3 or more.</source>
        <translation>Mit Bäumen, die je nach Jahreszeit kahl sind: %1; %2 seiner Fläche hat %3 oder mehr.</translation>
    </message>
    <message>
        <source>%1 of %2 places lie in shadow for more than %3 a day</source>
        <translation>%1 von %2 Orten liegen mehr als %3 am Tag im Schatten</translation>
    </message>
    <message>
        <source>%1 has the most shadow, %2 a day, and %3 the least, %4.</source>
        <translation>%1 hat den meisten Schatten, %2 am Tag, und %3 den wenigsten, %4.</translation>
    </message>
    <message>
        <source>On average over their area %1 of shadow a day, of %2 of daylight.</source>
        <translation>Im Mittel ihrer Fläche %1 Schatten am Tag, bei %2 Tageslicht.</translation>
    </message>
    <message>
        <source>%1 adds more than a minute of shadow a day to %2 places, at most %3 at one spot.</source>
        <translation>%1 bringt %2 Orten mehr als eine Minute Schatten am Tag, höchstens %3 an einer Stelle.</translation>
    </message>
    <message>
        <source>Minutes of shadow a day by month</source>
        <translation>Minuten Schatten am Tag nach Monat</translation>
    </message>
    <message>
        <source>%1 reduces its shadow by %2 a day, at most %3 at one spot.</source>
        <translation>%1 erspart ihm %2 Schatten am Tag, höchstens %3 an einer Stelle.</translation>
    </message>
    <message>
        <source>%1 adds %2 of shadow a day to it, at most %3 at one spot.</source>
        <translation>%1 bringt ihm %2 Schatten am Tag, höchstens %3 an einer Stelle.</translation>
    </message>
    <message>
        <source>Thresholds of the change</source>
        <translation>Schwellen der Änderung</translation>
    </message>
    <message>
        <source>Minutes of more or less shadow a day above which area counts; one or more</source>
        <translation>Minuten mehr oder weniger Schatten am Tag, ab denen Fläche zählt; eine oder mehrere</translation>
    </message>
    <message>
        <source>Each new building</source>
        <translation>Jedes neue Gebäude</translation>
    </message>
    <message>
        <source>Also measure the sole contribution of each new building</source>
        <translation>Auch den alleinigen Beitrag jedes neuen Gebäudes messen</translation>
    </message>
    <message>
        <source>Tolerance of buildings from a surface model</source>
        <translation>Toleranz der Gebäude aus einem Oberflächenmodell</translation>
    </message>
    <message>
        <source>How far buildings that are made of a surface model may lie above or below its cells, 0.05 to 5 m</source>
        <translation>Wie weit Gebäude, die aus einem Oberflächenmodell entstehen, über oder unter seinen Zellen liegen dürfen, 0.05 bis 5 m</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Ausdehnung</translation>
    </message>
    <message>
        <source>Read only the buildings that touch this box, degrees; terrain is read whole</source>
        <translation>Liest nur die Gebäude, die dieses Rechteck in Grad berühren; Gelände wird ganz gelesen</translation>
    </message>
    <message>
        <source>On %1, %2 of %3 places lie in shadow for more than %4.</source>
        <translation>Am %1 liegen %2 von %3 Orten länger als %4 im Schatten.</translation>
    </message>
    <message>
        <source>Change of the minutes of shadow a day by month</source>
        <translation>Änderung der Schattenminuten am Tag nach Monaten</translation>
    </message>
    <message>
        <source>Minutes of shadow a day of the places that change most</source>
        <translation>Schattenminuten am Tag der Orte, die sich am meisten ändern</translation>
    </message>
    <message>
        <source>Change of the minutes of shadow a day of these places</source>
        <translation>Änderung der Schattenminuten am Tag dieser Orte</translation>
    </message>
    <message>
        <source>%1: %2 of shadow a day; %3 of its area has %4 or less</source>
        <translation>%1: %2 Schatten am Tag; %3 der Fläche hat %4 oder weniger</translation>
    </message>
    <message>
        <source>With trees as evergreens: %1; %2 of its area has %3 or less.</source>
        <translation>Mit immergrünen Bäumen: %1; %2 seiner Fläche hat %3 oder weniger.</translation>
    </message>
    <message>
        <source>With trees that lose their leaves by season: %1; %2 of its area has %3 or less.</source>
        <translation>Mit Bäumen, die je nach Jahreszeit kahl sind: %1; %2 seiner Fläche hat %3 oder weniger.</translation>
    </message>
    <message>
        <source>On %1 it lies in shadow for %2; %3 of its area for more than %4.</source>
        <translation>Am %1 liegt er %2 im Schatten; %3 seiner Fläche länger als %4.</translation>
    </message>
    <message>
        <source>The measured hours begin this many hours after sunrise</source>
        <translation>Die gemessenen Stunden beginnen so viele Stunden nach Sonnenaufgang</translation>
    </message>
    <message>
        <source>The measured hours end this many hours before sunset</source>
        <translation>Die gemessenen Stunden enden so viele Stunden vor Sonnenuntergang</translation>
    </message>
    <message>
        <source>minutes of shadow a day, mean over the days and the place</source>
        <translation>Schattenminuten am Tag, Mittel über die Tage und den Ort</translation>
    </message>
    <message>
        <source>Max shadow</source>
        <translation>Max. Schatten</translation>
    </message>
    <message>
        <source>minutes of shadow a day, mean over the days, at the cell that has most</source>
        <translation>Schattenminuten am Tag, Mittel über die Tage, an der Zelle mit den meisten</translation>
    </message>
    <message>
        <source>Min shadow</source>
        <translation>Min. Schatten</translation>
    </message>
    <message>
        <source>minutes of shadow a day, mean over the days, at the cell that has least</source>
        <translation>Schattenminuten am Tag, Mittel über die Tage, an der Zelle mit den wenigsten</translation>
    </message>
    <message>
        <source>a tree far from the buildings: its longitude and latitude are swapped</source>
        <translation>ein Baum weit von den Gebäuden: seine Länge und Breite sind vertauscht</translation>
    </message>
    <message>
        <source>Trees are not included.</source>
        <translation>Dies ist ohne Bäume.</translation>
    </message>
    <message>
        <source>This is with trees as evergreens.</source>
        <translation>Dies ist mit Bäumen als Immergrünen.</translation>
    </message>
    <message>
        <source>This is with trees by their seasons.</source>
        <translation>Dies ist mit Bäumen nach ihren Jahreszeiten.</translation>
    </message>
    <message>
        <source>Trees on maps</source>
        <translation>Bäume auf Karten</translation>
    </message>
    <message>
        <source>With trees as evergreens their number is %1, at most %2 at one spot.</source>
        <translation>Mit Bäumen als Immergrünen sind es %1, höchstens %2 an einer Stelle.</translation>
    </message>
    <message>
        <source>With trees that lose their leaves by season their number is %1, at most %2 at one spot.</source>
        <translation>Mit Bäumen, die nach Jahreszeit ihr Laub verlieren, sind es %1, höchstens %2 an einer Stelle.</translation>
    </message>
    <message>
        <source>Scale of diagrams</source>
        <translation>Maßstab der Diagramme</translation>
    </message>
    <message>
        <source>Scale of diagrams and elevations: 2000 for 1:2000 (default: a round one that fits)</source>
        <translation>Maßstab von Diagrammen und Ansichten: 2000 für 1:2000 (Vorgabe: ein runder, der passt)</translation>
    </message>
    <message>
        <source>Everything in full</source>
        <translation>Alles vollständig</translation>
    </message>
    <message>
        <source>Sheets: all tables, maps, elevations and timelines in full, on as many pages as that takes (default: at most 30 pages, with what changes most and what fails or is borderline)</source>
        <translation>Blätter: alle Tabellen, Karten, Ansichten und Zeitverläufe vollständig, auf so vielen Seiten wie nötig (Vorgabe: höchstens 30 Seiten, mit dem, was sich am meisten ändert und was nicht erfüllt oder grenzwertig ist)</translation>
    </message>
    <message>
        <source>Map of sources of heights</source>
        <translation>Karte der Herkunft der Höhen</translation>
    </message>
    <message>
        <source>Sheets: a page with the buildings coloured by where their heights come from: measured, from storeys, assumed, of a 3D model, designed</source>
        <translation>Blätter: eine Seite mit den Gebäuden in Farben nach der Herkunft ihrer Höhen: gemessen, aus Geschossen, angenommen, aus einem 3D-Modell, entworfen</translation>
    </message>
    <message>
        <source>Smallest place</source>
        <translation>Kleinster Ort</translation>
    </message>
    <message>
        <source>Sheets of places: smaller places without a name are listed together, under the place that they lie in or by kind</source>
        <translation>Blätter von Orten: kleinere Orte ohne Namen stehen zusammen, unter dem Ort, in dem sie liegen, oder nach Art</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Paper of the sheets: A4, A3, A1, Letter or Tabloid</source>
        <translation>Papier der Blätter: A4, A3, A1, Letter oder Tabloid</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Querformat</translation>
    </message>
    <message>
        <source>Sheets are wider than high</source>
        <translation>Blätter sind breiter als hoch</translation>
    </message>
    <message>
        <source>Hours of sun a day by month</source>
        <translation>Sonnenstunden am Tag nach Monaten</translation>
    </message>
    <message>
        <source>Change of the hours of sun a day by month</source>
        <translation>Änderung der Sonnenstunden am Tag nach Monaten</translation>
    </message>
    <message>
        <source>Hours of sun a day in the places by month</source>
        <translation>Sonnenstunden am Tag in den Orten nach Monaten</translation>
    </message>
    <message>
        <source>Change of the hours of sun a day in the places by month</source>
        <translation>Änderung der Sonnenstunden am Tag in den Orten nach Monaten</translation>
    </message>
    <message>
        <source>Change of the shadow area by month, m²</source>
        <translation>Änderung der Schattenfläche nach Monaten, m²</translation>
    </message>
    <message>
        <source>Change of the weighted shade by month, m² h</source>
        <translation>Änderung des gewichteten Schattens nach Monaten, m² h</translation>
    </message>
    <message>
        <source>Shadow score by month, m²</source>
        <translation>Schattenbewertung nach Monaten, m²</translation>
    </message>
    <message>
        <source>Change of the shadow score by month, m²</source>
        <translation>Änderung der Schattenbewertung nach Monaten, m²</translation>
    </message>
    <message>
        <source>duplicates</source>
        <translation>doppelt</translation>
    </message>
    <message>
        <source>Sun by place in %1</source>
        <translation>Sonne nach Ort in %1</translation>
    </message>
    <message>
        <source>Sun by place in %1 compared with %2</source>
        <translation>Sonne nach Ort in %1, verglichen mit %2</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 verglichen mit %2</translation>
    </message>
    <message>
        <source>Score of %1 with %2</source>
        <translation>Bewertung von %1 mit %2</translation>
    </message>
    <message>
        <source>Study of %1</source>
        <translation>Untersuchung von %1</translation>
    </message>
    <message>
        <source>Points of %1</source>
        <translation>Punkte von %1</translation>
    </message>
    <message>
        <source>drawing diagrams</source>
        <translation>zeichnet Diagramme</translation>
    </message>
    <message>
        <source>drawing shadow fans</source>
        <translation>zeichnet Schattenfächer</translation>
    </message>
    <message>
        <source>drawing lines of equal hours</source>
        <translation>zeichnet Linien gleicher Stunden</translation>
    </message>
    <message>
        <source>drawing views from the sun</source>
        <translation>zeichnet Blicke von der Sonne</translation>
    </message>
    <message>
        <source>sweeping horizons</source>
        <translation>sucht Horizonte</translation>
    </message>
    <message>
        <source>sweeping horizons of points</source>
        <translation>sucht Horizonte der Punkte</translation>
    </message>
    <message>
        <source>tracing rays from points</source>
        <translation>verfolgt Strahlen von Punkten</translation>
    </message>
    <message>
        <source>finding buildings in reach of the places</source>
        <translation>sucht Gebäude, deren Schatten die Orte erreicht</translation>
    </message>
    <message>
        <source>filling shadows</source>
        <translation>füllt Schatten</translation>
    </message>
    <message>
        <source>building the ray scene</source>
        <translation>bereitet Strahlen vor</translation>
    </message>
    <message>
        <source>tracing rays</source>
        <translation>verfolgt Strahlen</translation>
    </message>
    <message>
        <source>tracing rays through single trees</source>
        <translation>verfolgt Strahlen durch einzelne Bäume</translation>
    </message>
    <message>
        <source>unpacking the archive</source>
        <translation>entpackt das Archiv</translation>
    </message>
    <message>
        <source>making the buildings</source>
        <translation>bildet die Gebäude</translation>
    </message>
    <message>
        <source>reading the features</source>
        <translation>liest die Objekte</translation>
    </message>
    <message>
        <source>reading the city</source>
        <translation>liest die Stadt</translation>
    </message>
    <message>
        <source>reading the map</source>
        <translation>liest die Karte</translation>
    </message>
    <message>
        <source>reading windows</source>
        <translation>liest Fenster</translation>
    </message>
    <message>
        <source>repairing outlines</source>
        <translation>repariert Umrisse</translation>
    </message>
    <message>
        <source>making buildings</source>
        <translation>bildet Gebäude</translation>
    </message>
    <message>
        <source>they stand where the file states</source>
        <translation>sie stehen, wo die Datei es angibt</translation>
    </message>
    <message>
        <source>all were shifted onto it</source>
        <translation>alle wurden darauf verschoben</translation>
    </message>
    <message>
        <source>each building was set down on it</source>
        <translation>jedes Gebäude wurde darauf gesetzt</translation>
    </message>
    <message>
        <source>bases of %1 lie %2 m below the terrain (median of %3, spread %4 m)</source>
        <translation>die Fußpunkte von %1 liegen %2 m unter dem Gelände (Median von %3, Streuung %4 m)</translation>
    </message>
    <message>
        <source>bases of %1 lie %2 m above the terrain (median of %3, spread %4 m)</source>
        <translation>die Fußpunkte von %1 liegen %2 m über dem Gelände (Median von %3, Streuung %4 m)</translation>
    </message>
    <message>
        <source>%1 far from that gap were set down by themselves</source>
        <translation>%1 mit anderem Abstand wurden einzeln abgesetzt</translation>
    </message>
    <message>
        <source>%1 stay above the ground</source>
        <translation>%1 bleiben über dem Boden</translation>
    </message>
    <message>
        <source>finding the buildings</source>
        <translation>sucht die Gebäude</translation>
    </message>
    <message>
        <source>reading the mesh</source>
        <translation>liest das Netz</translation>
    </message>
    <message>
        <source>making buildings of the surface model</source>
        <translation>bildet Gebäude aus dem Oberflächenmodell</translation>
    </message>
    <message>
        <source>reading canopy</source>
        <translation>liest die Kronenhöhen</translation>
    </message>
    <message>
        <source>reading trees</source>
        <translation>liest Bäume</translation>
    </message>
    <message>
        <source>joining shadows</source>
        <translation>vereinigt Schatten</translation>
    </message>
    <message>
        <source>evaluating windows</source>
        <translation>wertet Fenster aus</translation>
    </message>
    <message>
        <source>%1 of %2 heights are assumed (%3 m)</source>
        <translation>%1 von %2 Höhen sind angenommen (%3 m)</translation>
    </message>
    <message>
        <source>%1 of %2 heights are assumed (most of them %3 m)</source>
        <translation>%1 von %2 Höhen sind angenommen (meist %3 m)</translation>
    </message>
    <message>
        <source>Fields that could hold heights or storeys: %1</source>
        <translation>Felder, die Höhen oder Geschosse enthalten könnten: %1</translation>
    </message>
    <message>
        <source>In doubt: %1</source>
        <translation>Zweifelhaft: %1</translation>
    </message>
    <message>
        <source>%1, %2 km from %3, %4</source>
        <translation>%1, %2 km von %3, %4</translation>
    </message>
    <message>
        <source>no buildings</source>
        <translation>keine Gebäude</translation>
    </message>
    <message>
        <source>buildings: %1, parts: %2, up to %3 m high</source>
        <translation>Gebäude: %1, Teile: %2, bis %3 m hoch</translation>
    </message>
    <message>
        <source>on a terrain</source>
        <translation>auf einem Gelände</translation>
    </message>
    <message>
        <source>on flat ground</source>
        <translation>auf ebenem Boden</translation>
    </message>
    <message>
        <source>summing up places</source>
        <translation>fasst Orte zusammen</translation>
    </message>
    <message>
        <source>joining the timelines</source>
        <translation>verbindet die Zeitleisten</translation>
    </message>
    <message>
        <source>surveying the buildings</source>
        <translation>misst die Gebäude</translation>
    </message>
    <message>
        <source>writing the map</source>
        <translation>schreibt die Karte</translation>
    </message>
    <message>
        <source>building gone</source>
        <translation>Gebäude entfernt</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Laub</translation>
    </message>
    <message>
        <source>Whether it keeps its leaves (default: as its genus)</source>
        <translation>Ob er sein Laub behält (Vorgabe: wie seine Gattung)</translation>
    </message>
    <message>
        <source>as its genus</source>
        <translation>wie seine Gattung</translation>
    </message>
    <message>
        <source>First day in leaf</source>
        <translation>Erster Tag mit Laub</translation>
    </message>
    <message>
        <source>First day in leaf of a tree that loses its leaves (default: as the city&apos;s trees)</source>
        <translation>Erster Tag mit Laub eines Baums, der es verliert (Vorgabe: wie die Bäume der Stadt)</translation>
    </message>
    <message>
        <source>MM-DD; as the city&apos;s trees</source>
        <translation>MM-TT; wie die Bäume der Stadt</translation>
    </message>
    <message>
        <source>First day without leaves</source>
        <translation>Erster Tag ohne Laub</translation>
    </message>
    <message>
        <source>First day without leaves of a tree that loses them (default: as the city&apos;s trees)</source>
        <translation>Erster Tag ohne Laub eines Baums, der es verliert (Vorgabe: wie die Bäume der Stadt)</translation>
    </message>
    <message>
        <source>Which shadow maps and sheets show where trees reach; files of values hold all that were measured</source>
        <translation>Welchen Schatten Karten und Blätter zeigen, wo Bäume hinreichen; Dateien mit Werten enthalten alle gemessenen</translation>
    </message>
    <message>
        <source>the days</source>
        <translation>die Tage</translation>
    </message>
    <message>
        <source>the hours</source>
        <translation>die Stunden</translation>
    </message>
    <message>
        <source>the clock</source>
        <translation>die Uhrzeit</translation>
    </message>
    <message>
        <source>the day %1</source>
        <translation>der Tag %1</translation>
    </message>
    <message>
        <source>the limit of &quot;%1&quot;</source>
        <translation>der Grenzwert von „%1“</translation>
    </message>
    <message>
        <source>the share of &quot;%1&quot;</source>
        <translation>der Anteil von „%1“</translation>
    </message>
    <message>
        <source>the hours of sunshine</source>
        <translation>die Sonnenstunden</translation>
    </message>
    <message>
        <source>What %1 builds stands outside the region: the figures are of the shadow that reaches into it.</source>
        <translation>Was %1 baut, steht außerhalb des Gebiets: Die Zahlen gelten für den Schatten, der hineinreicht.</translation>
    </message>
    <message>
        <source>A part of what %1 builds stands outside the region: the figures are of the shadow in it.</source>
        <translation>Ein Teil dessen, was %1 baut, steht außerhalb des Gebiets: Die Zahlen gelten für den Schatten darin.</translation>
    </message>
    <message>
        <source>The change by more than %1 a day reaches the region&apos;s edge: beyond it is not measured.</source>
        <translation>Die Änderung um mehr als %1 am Tag reicht bis zum Rand des Gebiets: Dahinter wird nicht gemessen.</translation>
    </message>
    <message>
        <source>the coordinates are taken in the other order than that of their reference system, in which the buildings are mirror images</source>
        <translation>die Koordinaten werden in der anderen Reihenfolge als der ihres Bezugssystems gelesen, in der die Gebäude spiegelverkehrt sind</translation>
    </message>
    <message>
        <source>Estimated or assumed of %1 trees: height of %2, crown of %3</source>
        <translation>Geschätzt oder angenommen bei %1 Bäumen: Höhe von %2, Krone von %3</translation>
    </message>
    <message>
        <source>%1: %2 compared with %3</source>
        <translation>%1: %2 verglichen mit %3</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>The proposal&apos;s shadow reaches no place in the rule&apos;s hours</source>
        <translation>Der Schatten des Vorschlags erreicht in den Stunden der Regel keinen Ort</translation>
    </message>
    <message>
        <source>Review all places to have that stated for each</source>
        <translation>Prüfen Sie alle Orte, um das für jeden ausgewiesen zu bekommen</translation>
    </message>
    <message>
        <source>The sides of the lot would cross or touch each other</source>
        <translation>Die Seiten des Grundstücks würden sich kreuzen oder berühren</translation>
    </message>
    <message>
        <source>Move the corner or side less far</source>
        <translation>Die Ecke oder Seite weniger weit verschieben</translation>
    </message>
    <message>
        <source>The sides beside it meet before that</source>
        <translation>Die Seiten daneben treffen sich vorher</translation>
    </message>
    <message>
        <source>Move the side less far</source>
        <translation>Die Seite weniger weit verschieben</translation>
    </message>
    <message>
        <source>A lot needs three corners or more</source>
        <translation>Ein Grundstück braucht mindestens drei Ecken</translation>
    </message>
    <message>
        <source>Move the corner instead</source>
        <translation>Stattdessen die Ecke verschieben</translation>
    </message>
    <message>
        <source>hot all year</source>
        <translation>ganzjährig heiß</translation>
    </message>
    <message>
        <source>hot months</source>
        <translation>heiße Monate</translation>
    </message>
    <message>
        <source>before the hot months</source>
        <translation>vor den heißen Monaten</translation>
    </message>
    <message>
        <source>after the hot months</source>
        <translation>nach den heißen Monaten</translation>
    </message>
    <message>
        <source>winter</source>
        <translation>Winter</translation>
    </message>
    <message>
        <source>early spring</source>
        <translation>Vorfrühling</translation>
    </message>
    <message>
        <source>hot month</source>
        <translation>heißer Monat</translation>
    </message>
    <message>
        <source>growing season</source>
        <translation>Wachstumszeit</translation>
    </message>
    <message>
        <source>pedestrian comfort</source>
        <translation>Behaglichkeit zu Fuß</translation>
    </message>
    <message>
        <source>plants</source>
        <translation>Pflanzen</translation>
    </message>
    <message>
        <source>default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Any country</source>
        <translation>Jedes Land</translation>
    </message>
    <message>
        <source>Source of height</source>
        <translation>Herkunft der Höhe</translation>
    </message>
    <message>
        <source>of the highest part of each building; counts are of the whole city</source>
        <translation>des höchsten Teils jedes Gebäudes; die Anzahlen gelten für die ganze Stadt</translation>
    </message>
    <message>
        <source>Where the heights come from</source>
        <translation>Woher die Höhen kommen</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Definitions</source>
        <translation>Definitionen</translation>
    </message>
    <message>
        <source>Method and sources</source>
        <translation>Verfahren und Quellen</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Scenarios side by side</source>
        <translation>Szenarien nebeneinander</translation>
    </message>
    <message>
        <source>%1 on one scale.</source>
        <translation>%1 auf einer Skala.</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Gebäude</translation>
    </message>
    <message>
        <source>The first %1 of %2.</source>
        <translation>Die ersten %1 von %2.</translation>
    </message>
    <message>
        <source> min a day</source>
        <translation> min am Tag</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>Beiträge</translation>
    </message>
    <message>
        <source>Sole contribution of each new building: against the scenario without it</source>
        <translation>Alleiniger Beitrag jedes neuen Gebäudes: gegenüber dem Szenario ohne es</translation>
    </message>
    <message>
        <source>Months</source>
        <translation>Monate</translation>
    </message>
    <message>
        <source> by month</source>
        <translation> nach Monaten</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>shadow of the proposal alone</source>
        <translation>Schatten des Entwurfs allein</translation>
    </message>
    <message>
        <source>hours of shadow</source>
        <translation>Stunden Schatten</translation>
    </message>
    <message>
        <source>limit of the rule</source>
        <translation>Grenze der Regel</translation>
    </message>
    <message>
        <source>distance from the parcel</source>
        <translation>Abstand vom Grundstück</translation>
    </message>
    <message>
        <source>existing shadow</source>
        <translation>vorhandener Schatten</translation>
    </message>
    <message>
        <source>incremental shadow</source>
        <translation>zusätzlicher Schatten</translation>
    </message>
    <message>
        <source>sun gained</source>
        <translation>gewonnene Sonne</translation>
    </message>
    <message>
        <source>proposal</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>building</source>
        <translation>Gebäude</translation>
    </message>
    <message>
        <source>open below</source>
        <translation>unten offen</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Heights in %1 above the ground.</source>
        <translation>Höhen in %1 über dem Boden.</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source> Numbers in a white field name the places above.</source>
        <translation> Zahlen in weißem Feld bezeichnen die Orte oben.</translation>
    </message>
    <message>
        <source> White lines: streets of the project.</source>
        <translation> Weiße Linien: Straßen des Projekts.</translation>
    </message>
    <message>
        <source> Pale colours: streets, water and parks of the map.</source>
        <translation> Blasse Farben: Straßen, Wasser und Parks der Karte.</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>auf %1</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>nicht erfüllt</translation>
    </message>
    <message>
        <source>verdict gets worse</source>
        <translation>Befund wird schlechter</translation>
    </message>
    <message>
        <source>verdict gets better</source>
        <translation>Befund wird besser</translation>
    </message>
    <message>
        <source>north</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>north-east</source>
        <translation>Nordost</translation>
    </message>
    <message>
        <source>east</source>
        <translation>Ost</translation>
    </message>
    <message>
        <source>south-east</source>
        <translation>Südost</translation>
    </message>
    <message>
        <source>south</source>
        <translation>Süd</translation>
    </message>
    <message>
        <source>south-west</source>
        <translation>Südwest</translation>
    </message>
    <message>
        <source>west</source>
        <translation>West</translation>
    </message>
    <message>
        <source>north-west</source>
        <translation>Nordwest</translation>
    </message>
    <message>
        <source>Floors of %1 m</source>
        <translation>Geschosse von %1 m</translation>
    </message>
    <message>
        <source>, of designed towers as designed</source>
        <translation>, von entworfenen Türmen wie entworfen</translation>
    </message>
    <message>
        <source>continued</source>
        <translation>Fortsetzung</translation>
    </message>
    <message>
        <source>Language of sheets</source>
        <translation>Sprache der Blätter</translation>
    </message>
    <message>
        <source>Language of the texts, numbers and dates of sheets: en, de, es or ja (default: that of the window, English on the command line). Files for programs are the same in every language</source>
        <translation>Sprache der Texte, Zahlen und Daten der Blätter: en, de, es oder ja (Vorgabe: die des Fensters, auf der Befehlszeile Englisch). Dateien für Programme sind in jeder Sprache gleich</translation>
    </message>
    <message>
        <source>Timelines of places</source>
        <translation>Zeitverläufe der Orte</translation>
    </message>
    <message>
        <source>Shadows are on a horizontal plane %1 m above the mean ground. </source>
        <translation>Die Schatten liegen auf einer waagerechten Ebene %1 m über dem mittleren Boden. </translation>
    </message>
    <message>
        <source>place: </source>
        <translation>Ort: </translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>Times: %1.</source>
        <translation>Zeiten: %1.</translation>
    </message>
    <message>
        <source> Edges of shadows follow cells of %1 m, because the ground is not level.</source>
        <translation> Die Ränder der Schatten folgen Zellen von %1 m, weil der Boden nicht eben ist.</translation>
    </message>
    <message>
        <source>%1 compared with %2. %3North is up.</source>
        <translation>%1 verglichen mit %2. %3Norden ist oben.</translation>
    </message>
    <message>
        <source>Shadow diagrams</source>
        <translation>Schattenpläne</translation>
    </message>
    <message>
        <source>Shadow fans</source>
        <translation>Schattenfächer</translation>
    </message>
    <message>
        <source>All shadows of a day that the proposal would cast if it stood alone, %1. %2North is up.</source>
        <translation>Alle Schatten eines Tages, die der Entwurf würfe, wenn er allein stünde, %1. %2Norden ist oben.</translation>
    </message>
    <message>
        <source>, %1 to %2</source>
        <translation>, %1 bis %2</translation>
    </message>
    <message>
        <source>1:%1. Existing buildings do not hide these shadows</source>
        <translation>1:%1. Vorhandene Gebäude verdecken diese Schatten nicht</translation>
    </message>
    <message>
        <source>Lines of equal hours of shadow</source>
        <translation>Linien gleicher Schattenstunden</translation>
    </message>
    <message>
        <source>%1. Thick: limits of the rule. Dashed: distances from the parcel. North is up.</source>
        <translation>%1. Dick: Grenzen der Regel. Gestrichelt: Abstände vom Grundstück. Norden ist oben.</translation>
    </message>
    <message>
        <source>Views from the sun</source>
        <translation>Ansichten von der Sonne aus</translation>
    </message>
    <message>
        <source>%1, without perspective, as the sun sees it: what is visible is sunlit, what is hidden is in shadow. The proposal is violet, places are green.</source>
        <translation>%1, ohne Perspektive, wie die Sonne es sieht: was sichtbar ist, ist besonnt, was verdeckt ist, liegt im Schatten. Der Entwurf ist violett, Orte sind grün.</translation>
    </message>
    <message>
        <source>%1 pass, %2 borderline, %3 fail, %4 not applicable</source>
        <translation>%1 erfüllt, %2 grenzwertig, %3 nicht erfüllt, %4 nicht anwendbar</translation>
    </message>
    <message>
        <source>%1 before: %2.</source>
        <translation>%1 vorher: %2.</translation>
    </message>
    <message>
        <source>%1 after: %2.</source>
        <translation>%1 nachher: %2.</translation>
    </message>
    <message>
        <source>%1 whose verdict gets worse: %2; better: %3.</source>
        <translation>%1, deren Befund schlechter wird: %2; besser: %3.</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>Zusammenfassung</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Buildings</source>
        <translation>Gebäude</translation>
    </message>
    <message>
        <source>Proposal: %1. Baseline: %2.</source>
        <translation>Entwurf: %1. Ausgangslage: %2.</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Nicht geprüft</translation>
    </message>
    <message>
        <source>Fail before</source>
        <translation>Nicht erfüllt vorher</translation>
    </message>
    <message>
        <source>Fail after</source>
        <translation>Nicht erfüllt nachher</translation>
    </message>
    <message>
        <source>Worse</source>
        <translation>Schlechter</translation>
    </message>
    <message>
        <source>Verdict before</source>
        <translation>Befund vorher</translation>
    </message>
    <message>
        <source>Verdict after</source>
        <translation>Befund nachher</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Geschoss</translation>
    </message>
    <message>
        <source>Faces, deg</source>
        <translation>Richtung, Grad</translation>
    </message>
    <message>
        <source>%1, before</source>
        <translation>%1, vorher</translation>
    </message>
    <message>
        <source>%1, after</source>
        <translation>%1, nachher</translation>
    </message>
    <message>
        <source>Sun before</source>
        <translation>Sonne vorher</translation>
    </message>
    <message>
        <source>Sun after</source>
        <translation>Sonne nachher</translation>
    </message>
    <message>
        <source>%1, clock: %2. Minutes, or percent where stated</source>
        <translation>%1, Uhrzeit: %2. Minuten, oder Prozent, wo angegeben</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Engine: %1. Clock: %2, year %3; %4 steps of %5 min with the sun in the rule&apos;s hours.</source>
        <translation>Verfahren: %1. Uhrzeit: %2, Jahr %3; %4 Schritte von %5 min mit der Sonne in den Stunden der Regel.</translation>
    </message>
    <message>
        <source>Each run of minutes is uncertain by a step, a sky component by %1 %. A value within its error of a limit is borderline, never pass.</source>
        <translation>Jede Dauer ist um einen Schritt unsicher, ein Himmelslichtanteil um %1 %. Ein Wert, der innerhalb seines Fehlers an einer Grenze liegt, ist grenzwertig, nie erfüllt.</translation>
    </message>
    <message>
        <source>The rule, as it was read</source>
        <translation>Die Regel, wie sie gelesen wurde</translation>
    </message>
    <message>
        <source>Review of windows: </source>
        <translation>Prüfung der Fenster: </translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabellen</translation>
    </message>
    <message>
        <source>Windows at no building</source>
        <translation>Fenster an keinem Gebäude</translation>
    </message>
    <message>
        <source>The building is new or changed</source>
        <translation>Das Gebäude ist neu oder geändert</translation>
    </message>
    <message>
        <source>No former values</source>
        <translation>Keine früheren Werte</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>, scale locked</source>
        <translation>, Skala fest</translation>
    </message>
    <message>
        <source>Elevations: </source>
        <translation>Ansichten: </translation>
    </message>
    <message>
        <source>%1 and %2. %3. Colours beyond the ends of a scale are those of its ends.</source>
        <translation>%1 und %2. %3. Farben jenseits der Enden einer Skala sind die ihrer Enden.</translation>
    </message>
    <message>
        <source>Grey: no value. Seen square to the wall, from outside.</source>
        <translation>Grau: kein Wert. Senkrecht auf die Wand gesehen, von außen.</translation>
    </message>
    <message>
        <source>Sun: azimuth %1°, altitude %2°</source>
        <translation>Sonne: Azimut %1°, Höhe %2°</translation>
    </message>
    <message>
        <source>Without perspective, as the sun sees it: what is visible is sunlit, what is hidden is in shadow. New and changed buildings are violet. Clock: %1.</source>
        <translation>Ohne Perspektive, wie die Sonne es sieht: was sichtbar ist, ist besonnt, was verdeckt ist, liegt im Schatten. Neue und geänderte Gebäude sind violett. Uhrzeit: %1.</translation>
    </message>
    <message>
        <source>on a plane %1 m above the mean ground</source>
        <translation>auf einer Ebene %1 m über dem mittleren Boden</translation>
    </message>
    <message>
        <source>on the ground</source>
        <translation>auf dem Boden</translation>
    </message>
    <message>
        <source>Hours of shadow in the rule&apos;s hours, %1, on cells of %2 m</source>
        <translation>Schattenstunden in den Stunden der Regel, %1, auf Zellen von %2 m</translation>
    </message>
    <message>
        <source>Shadow review: </source>
        <translation>Schattenprüfung: </translation>
    </message>
    <message>
        <source>Engine: %1. Receivers: centres of the square cells of %2 m that the places touch, each weighed by its share of the place, not under a building of baseline or proposal.</source>
        <translation>Verfahren: %1. Messpunkte: Mitten der quadratischen Zellen von %2 m, welche die Orte berühren, jede mit ihrem Anteil am Ort gewichtet, nicht unter einem Gebäude der Ausgangslage oder des Entwurfs.</translation>
    </message>
    <message>
        <source>Time: %1, %2 of %3 min with the sun in the rule&apos;s hours. Clock: %4.</source>
        <translation>Zeit: %1, %2 von %3 min mit der Sonne in den Stunden der Regel. Uhrzeit: %4.</translation>
    </message>
    <message>
        <source>Sun: ERFA, topocentric, seen from %1; apparent altitude, with refraction.</source>
        <translation>Sonne: ERFA, topozentrisch, von %1 aus gesehen; scheinbare Höhe, mit Refraktion.</translation>
    </message>
    <message>
        <source>Frame: metres to the east and true north of %1 (WGS84).</source>
        <translation>Koordinaten: Meter nach Osten und geografisch Norden von %1 (WGS84).</translation>
    </message>
    <message>
        <source>Incremental shadow lies on what is sunlit in the baseline; sun gained is the reverse.</source>
        <translation>Zusätzlicher Schatten liegt auf dem, was in der Ausgangslage besonnt ist; gewonnene Sonne ist das Umgekehrte.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>The outlines in diagrams are exact unions of projected buildings where the ground is level; the figures come from the cells.</source>
        <translation>Die Umrisse in den Plänen sind genaue Vereinigungen projizierter Gebäude, wo der Boden eben ist; die Zahlen kommen aus den Zellen.</translation>
    </message>
    <message>
        <source>Not modelled</source>
        <translation>Nicht modelliert</translation>
    </message>
    <message>
        <source>Small structures and penumbra; the sun is a point at the centre of its disc.</source>
        <translation>Kleine Bauteile und Halbschatten; die Sonne ist ein Punkt in der Mitte ihrer Scheibe.</translation>
    </message>
    <message>
        <source>. Diagrams show the shadows of buildings and terrain.</source>
        <translation>. Die Pläne zeigen die Schatten von Gebäuden und Gelände.</translation>
    </message>
    <message>
        <source> without a name</source>
        <translation> ohne Namen</translation>
    </message>
    <message>
        <source>   ... further numbers: see the summary</source>
        <translation>   ... weitere Nummern: siehe Zusammenfassung</translation>
    </message>
    <message>
        <source>Of %1 places %2 are listed one by one; the numbers are those of the diagrams. Places of less than %3 without a name are listed together. Timelines are of places that fail or are borderline. review.csv has all places; the option --all-pages prints them.</source>
        <translation>Von %1 Orten sind %2 einzeln aufgeführt; die Nummern sind die der Pläne. Orte von weniger als %3 ohne Namen sind zusammengefasst. Zeitverläufe zeigen Orte, die nicht erfüllt oder grenzwertig sind. review.csv enthält alle Orte; die Option --all-pages druckt sie.</translation>
    </message>
    <message>
        <source>Clock: %1, year %2. Engine: %3, every %4 min, cells of %5 m. %6.</source>
        <translation>Uhrzeit: %1, Jahr %2. Verfahren: %3, alle %4 min, Zellen von %5 m. %6.</translation>
    </message>
    <message>
        <source>Figures only: the sun is not up at the rule&apos;s times, so no diagram is drawn.</source>
        <translation>Nur Zahlen: zu den Zeiten der Regel steht die Sonne nicht am Himmel, daher ist kein Plan gezeichnet.</translation>
    </message>
    <message>
        <source>Places without new shadow</source>
        <translation>Orte ohne neuen Schatten</translation>
    </message>
    <message>
        <source>%1 further places with names</source>
        <translation>%1 weitere Orte mit Namen</translation>
    </message>
    <message>
        <source>%1 without a name</source>
        <translation>%1 ohne Namen</translation>
    </message>
    <message>
        <source>Nothing is stated as unchecked.</source>
        <translation>Nichts ist als ungeprüft angegeben.</translation>
    </message>
    <message>
        <source>Sums over the days of the rule</source>
        <translation>Summen über die Tage der Regel</translation>
    </message>
    <message>
        <source>%1: existing shadow %2 of the theoretical sun; incremental %3; most on %4.</source>
        <translation>%1: vorhandener Schatten %2 der theoretischen Sonne; zusätzlich %3; am meisten am %4.</translation>
    </message>
    <message>
        <source>no day</source>
        <translation>keinem Tag</translation>
    </message>
    <message>
        <source>the most incremental shadow on %1 (%2) at one moment</source>
        <translation>der meiste zusätzliche Schatten auf %1 (%2) in einem Augenblick</translation>
    </message>
    <message>
        <source>Numbers in a white field: places of the table.</source>
        <translation>Zahlen in weißem Feld: Orte der Tabelle.</translation>
    </message>
    <message>
        <source>Verdicts</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Verdicts, continued</source>
        <translation>Befunde, Fortsetzung</translation>
    </message>
    <message>
        <source>Rule used in: %1. Site: %2.</source>
        <translation>Regel verwendet in: %1. Ort: %2.</translation>
    </message>
    <message>
        <source>. %1 days without incremental shadow are in review.csv only</source>
        <translation>. %1 Tage ohne zusätzlichen Schatten stehen nur in review.csv</translation>
    </message>
    <message>
        <source>. Of each month the day of most incremental shadow; %1 further days are in review.csv, and here with the option --all-pages</source>
        <translation>. Von jedem Monat der Tag mit dem meisten zusätzlichen Schatten; %1 weitere Tage stehen in review.csv, und hier mit der Option --all-pages</translation>
    </message>
    <message>
        <source>%1 of %2 places; review.csv has all</source>
        <translation>%1 von %2 Orten; review.csv enthält alle</translation>
    </message>
    <message>
        <source>Table of the rule</source>
        <translation>Tabelle der Regel</translation>
    </message>
    <message>
        <source>%1, clock: %2%3</source>
        <translation>%1, Uhrzeit: %2%3</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Former</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Deciding day</source>
        <translation>Entscheidender Tag</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source> (does not decide)</source>
        <translation> (entscheidet nicht)</translation>
    </message>
    <message>
        <source>Former: the same in the baseline, where a limit compares with it</source>
        <translation>Früher: dasselbe in der Ausgangslage, wo eine Grenze damit vergleicht</translation>
    </message>
    <message>
        <source>Criteria: the figures behind the verdicts</source>
        <translation>Kriterien: die Zahlen hinter den Befunden</translation>
    </message>
    <message>
        <source>Theoretical sun</source>
        <translation>Theoretische Sonne</translation>
    </message>
    <message>
        <source>Existing shadow</source>
        <translation>Vorhandener Schatten</translation>
    </message>
    <message>
        <source>share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>With proposal</source>
        <translation>Mit Entwurf</translation>
    </message>
    <message>
        <source>Days with incremental shadow</source>
        <translation>Tage mit zusätzlichem Schatten</translation>
    </message>
    <message>
        <source>Day of most</source>
        <translation>Tag des meisten</translation>
    </message>
    <message>
        <source>Duration on it</source>
        <translation>Dauer an diesem</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Sums</source>
        <translation>Summen</translation>
    </message>
    <message>
        <source>Over the days of the rule; shares of the theoretical sun</source>
        <translation>Über die Tage der Regel; Anteile an der theoretischen Sonne</translation>
    </message>
    <message>
        <source>Days with shadow</source>
        <translation>Tage mit Schatten</translation>
    </message>
    <message>
        <source>Enters at the earliest</source>
        <translation>Tritt frühestens ein</translation>
    </message>
    <message>
        <source>Exits at the latest</source>
        <translation>Verlässt spätestens</translation>
    </message>
    <message>
        <source>Longest on a day</source>
        <translation>Am längsten an einem Tag</translation>
    </message>
    <message>
        <source>Largest area</source>
        <translation>Größte Fläche</translation>
    </message>
    <message>
        <source>Incremental shadow by season</source>
        <translation>Zusätzlicher Schatten nach Jahreszeit</translation>
    </message>
    <message>
        <source>Seasons without incremental shadow are left out. Clock: %1</source>
        <translation>Jahreszeiten ohne zusätzlichen Schatten fehlen. Uhrzeit: %1</translation>
    </message>
    <message>
        <source>New building</source>
        <translation>Neues Gebäude</translation>
    </message>
    <message>
        <source>share of the theoretical sun</source>
        <translation>Anteil an der theoretischen Sonne</translation>
    </message>
    <message>
        <source>of the proposal&apos;s shadow</source>
        <translation>am Schatten des Entwurfs</translation>
    </message>
    <message>
        <source>Sole contributions of the new buildings</source>
        <translation>Alleinige Beiträge der neuen Gebäude</translation>
    </message>
    <message>
        <source>What each casts where the baseline and all others of the proposal leave the sun, over the days of the rule; shadow that two of them share is in neither row</source>
        <translation>Was jedes wirft, wo die Ausgangslage und alle anderen des Entwurfs die Sonne lassen, über die Tage der Regel; Schatten, den zwei gemeinsam werfen, steht in keiner Zeile</translation>
    </message>
    <message>
        <source>Points at no building</source>
        <translation>Punkte an keinem Gebäude</translation>
    </message>
    <message>
        <source>Elevations</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>, mean over the days</source>
        <translation>, Mittel über die Tage</translation>
    </message>
    <message>
        <source>Seen square to the wall, from outside.</source>
        <translation>Senkrecht auf die Wand gesehen, von außen.</translation>
    </message>
    <message>
        <source>Points on %1. %2.</source>
        <translation>Punkte auf %1. %2.</translation>
    </message>
    <message>
        <source>Rays at every step of the sun.</source>
        <translation>Strahlen zu jedem Sonnenstand.</translation>
    </message>
    <message>
        <source>Horizons of the points, in bins of a quarter of a degree.</source>
        <translation>Horizonte der Punkte, in Abschnitten von einem Viertelgrad.</translation>
    </message>
    <message>
        <source>Chosen since %1.</source>
        <translation>Gewählt, weil %1.</translation>
    </message>
    <message>
        <source>Error against rays: %1.</source>
        <translation>Fehler gegen Strahlen: %1.</translation>
    </message>
    <message>
        <source>Hours of sun on %1</source>
        <translation>Sonnenstunden auf %1</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>building %1</source>
        <translation>Gebäude %1</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Gelände</translation>
    </message>
    <message>
        <source>Contributions of buildings</source>
        <translation>Beiträge der Gebäude</translation>
    </message>
    <message>
        <source>%1 and the buildings that make most of the shadow</source>
        <translation>%1 und die Gebäude, die den meisten Schatten werfen</translation>
    </message>
    <message>
        <source>Numbers as in the table; buildings outside of the map are not shown</source>
        <translation>Zahlen wie in der Tabelle; Gebäude außerhalb der Karte sind nicht gezeigt</translation>
    </message>
    <message>
        <source>Largest contributions</source>
        <translation>Größte Beiträge</translation>
    </message>
    <message>
        <source>Area x hours in shadow, by building</source>
        <translation>Fläche x Stunden im Schatten, nach Gebäude</translation>
    </message>
    <message>
        <source>Numbers as in the table</source>
        <translation>Zahlen wie in der Tabelle</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Share of all shadow</source>
        <translation>Anteil an allem Schatten</translation>
    </message>
    <message>
        <source>Other buildings: %1</source>
        <translation>Andere Gebäude: %1</translation>
    </message>
    <message>
        <source>All shadow</source>
        <translation>Aller Schatten</translation>
    </message>
    <message>
        <source>Attributed: %1. Sole: %2. Area x hours over the whole period. Engine: %3. Rows below 0.1 % are added up; contributions.csv lists each.</source>
        <translation>Zugerechnet: %1. Alleinig: %2. Fläche x Stunden über den ganzen Zeitraum. Verfahren: %3. Zeilen unter 0,1 % sind zusammengefasst; contributions.csv nennt jede.</translation>
    </message>
    <message>
        <source>By building</source>
        <translation>Nach Gebäude</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Baum</translation>
    </message>
    <message>
        <source>Contributions of trees</source>
        <translation>Beiträge der Bäume</translation>
    </message>
    <message>
        <source>What trees take of the sun that buildings leave, %1. The first %2 of %3; tree_contributions.csv lists each.</source>
        <translation>Was Bäume von der Sonne nehmen, die Gebäude lassen, %1. Die ersten %2 von %3; tree_contributions.csv nennt jeden.</translation>
    </message>
    <message>
        <source>By tree</source>
        <translation>Nach Baum</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>How this was made</source>
        <translation>Wie dies entstand</translation>
    </message>
    <message>
        <source>Cells of %1 m; places with fewer than %2 of them have cells of %3 m. Cells on the edge of a place count with the share of them that lies in it.</source>
        <translation>Zellen von %1 m; Orte mit weniger als %2 davon haben Zellen von %3 m. Zellen am Rand eines Orts zählen mit dem Anteil, der in ihm liegt.</translation>
    </message>
    <message>
        <source>Without any shadow there would be %1 h of sun a day.</source>
        <translation>Ohne jeden Schatten gäbe es %1 h Sonne am Tag.</translation>
    </message>
    <message>
        <source>Also measured with %1.</source>
        <translation>Auch mit %1 gemessen.</translation>
    </message>
    <message>
        <source>Trees: %1.</source>
        <translation>Bäume: %1.</translation>
    </message>
    <message>
        <source>Error of cells: %1. The error of each figure is in the table at the end.</source>
        <translation>Fehler der Zellen: %1. Der Fehler jeder Größe steht in der Tabelle am Ende.</translation>
    </message>
    <message>
        <source>The baseline is %1. Ground that is built on in any scenario counts in none.</source>
        <translation>Die Ausgangslage ist %1. Boden, der in irgendeinem Szenario bebaut ist, zählt in keinem.</translation>
    </message>
    <message>
        <source>minutes of shadow</source>
        <translation>Minuten Schatten</translation>
    </message>
    <message>
        <source>hours of sun</source>
        <translation>Sonnenstunden</translation>
    </message>
    <message>
        <source>Shadow by place</source>
        <translation>Schatten nach Ort</translation>
    </message>
    <message>
        <source> a day</source>
        <translation> am Tag</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 am %2</translation>
    </message>
    <message>
        <source>Change of sun by place: </source>
        <translation>Änderung der Sonne nach Ort: </translation>
    </message>
    <message>
        <source>minutes of sun a day</source>
        <translation>Minuten Sonne am Tag</translation>
    </message>
    <message>
        <source> on this day</source>
        <translation> an diesem Tag</translation>
    </message>
    <message>
        <source>mean %1 a day</source>
        <translation>Mittel %1 am Tag</translation>
    </message>
    <message>
        <source>   Further places: table, %1 and on.</source>
        <translation>   Weitere Orte: Tabelle, ab %1.</translation>
    </message>
    <message>
        <source>Places by their %1</source>
        <translation>Orte nach %1</translation>
    </message>
    <message>
        <source>Numbers as in the key and the table; a number that would cover another one is left out. Outlines without colour: places without figures.</source>
        <translation>Zahlen wie im Schlüssel und in der Tabelle; eine Zahl, die eine andere verdecken würde, fehlt. Umrisse ohne Farbe: Orte ohne Werte.</translation>
    </message>
    <message>
        <source>Minutes of shadow by place</source>
        <translation>Minuten Schatten nach Ort</translation>
    </message>
    <message>
        <source>Hours of sun by place</source>
        <translation>Sonnenstunden nach Ort</translation>
    </message>
    <message>
        <source>Change of sun by place</source>
        <translation>Änderung der Sonne nach Ort</translation>
    </message>
    <message>
        <source>change of mean sun a day against %1, minutes</source>
        <translation>Änderung der mittleren Sonne am Tag gegenüber %1, Minuten</translation>
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
        <translation>Änderung des mittleren Schattens, min</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Below, %1</source>
        <translation>Darunter, %1</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>with least sun</source>
        <translation>mit der wenigsten Sonne</translation>
    </message>
    <message>
        <source>that lose most to the first scenario</source>
        <translation>die am meisten an das erste Szenario verlieren</translation>
    </message>
    <message>
        <source>All %1, those %2 first.</source>
        <translation>Alle %1, zuerst die %2.</translation>
    </message>
    <message>
        <source>The %1 of %2 %3; all of them are in places.csv.</source>
        <translation>Die %1 von %2 %3; alle stehen in places.csv.</translation>
    </message>
    <message>
        <source> The figures are those of %1; changes are from %2.</source>
        <translation> Die Werte sind die von %1; Änderungen gelten gegenüber %2.</translation>
    </message>
    <message>
        <source>Errors against the ray reference, on a sample</source>
        <translation>Fehler gegen die Strahlenreferenz, an einer Stichprobe</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>99 of 100 within</source>
        <translation>99 von 100 innerhalb</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Not measured.</source>
        <translation>Nicht gemessen.</translation>
    </message>
    <message>
        <source>No month has a day that counts</source>
        <translation>Kein Monat hat einen Tag, der zählt</translation>
    </message>
    <message>
        <source>100 % of the place</source>
        <translation>100 % des Orts</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>nicht gezählt</translation>
    </message>
    <message>
        <source>The sun is not up in the hours of the rule</source>
        <translation>In den Stunden der Regel steht die Sonne nicht am Himmel</translation>
    </message>
    <message>
        <source>%1   not counted</source>
        <translation>%1   nicht gezählt</translation>
    </message>
    <message>
        <source>the scenario&apos;s shadow</source>
        <translation>dem Schatten des Szenarios</translation>
    </message>
    <message>
        <source>the baseline&apos;s shadow</source>
        <translation>dem Schatten der Ausgangslage</translation>
    </message>
    <message>
        <source>%1   %2 % of the place in %3</source>
        <translation>%1   %2 % des Orts in %3</translation>
    </message>
    <message>
        <source>sq ft</source>
        <translation>sq ft</translation>
    </message>
    <message>
        <source>Sun gained</source>
        <translation>Gewonnene Sonne</translation>
    </message>
    <message>
        <source>The sun is not up in the rule&apos;s hours, or the place has no open ground</source>
        <translation>In den Stunden der Regel steht die Sonne nicht am Himmel, oder der Ort hat keinen offenen Boden</translation>
    </message>
    <message>
        <source>%1   incremental %2; scenario %3; baseline %4</source>
        <translation>%1   zusätzlich %2; Szenario %3; Ausgangslage %4</translation>
    </message>
    <message>
        <source>; sun gained %1</source>
        <translation>; gewonnene Sonne %1</translation>
    </message>
    <message>
        <source>Incremental shadow on the edge of the place alone, beside all centres of cells</source>
        <translation>Zusätzlicher Schatten nur am Rand des Orts, neben allen Zellmitten</translation>
    </message>
    <message>
        <source>No incremental shadow in the rule&apos;s hours</source>
        <translation>Kein zusätzlicher Schatten in den Stunden der Regel</translation>
    </message>
    <message>
        <source> (up to %1 min too late)</source>
        <translation> (bis zu %1 min zu spät)</translation>
    </message>
    <message>
        <source>Incremental shadow from %1 to %2%6; at most %3, %4 % of the place, at %5</source>
        <translation>Zusätzlicher Schatten von %1 bis %2%6; höchstens %3, %4 % des Orts, um %5</translation>
    </message>
    <message>
        <source>less shadow</source>
        <translation>weniger Schatten</translation>
    </message>
    <message>
        <source>in the sun</source>
        <translation>in der Sonne</translation>
    </message>
    <message>
        <source>more shadow</source>
        <translation>mehr Schatten</translation>
    </message>
    <message>
        <source>in shadow</source>
        <translation>im Schatten</translation>
    </message>
    <message>
        <source>violet: proposed</source>
        <translation>violett: Entwurf</translation>
    </message>
    <message>
        <source>orange: only in the baseline</source>
        <translation>orange: nur in der Ausgangslage</translation>
    </message>
    <message>
        <source>orange: demolished</source>
        <translation>orange: abgerissen</translation>
    </message>
    <message>
        <source>dashed: open below</source>
        <translation>gestrichelt: unten offen</translation>
    </message>
    <message>
        <source>dark line: region</source>
        <translation>dunkle Linie: Gebiet</translation>
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
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Szenarien</translation>
    </message>
    <message>
        <source>%1 Change: from %2, on the receivers of both. Engine: %3.</source>
        <translation>%1 Änderung: von %2, auf den Messpunkten beider. Verfahren: %3.</translation>
    </message>
    <message>
        <source>The same study of each scenario</source>
        <translation>Dieselbe Untersuchung jedes Szenarios</translation>
    </message>
    <message>
        <source>%1 high</source>
        <translation>%1 hoch</translation>
    </message>
    <message>
        <source>floor area %1</source>
        <translation>Geschossfläche %1</translation>
    </message>
    <message>
        <source>no new building with known floors</source>
        <translation>kein neues Gebäude mit bekannten Geschossen</translation>
    </message>
    <message>
        <source>, on one scale</source>
        <translation>, auf einer Skala</translation>
    </message>
    <message>
        <source>The first %1 of %2 scenarios; scenario_months.csv has all</source>
        <translation>Die ersten %1 von %2 Szenarien; scenario_months.csv enthält alle</translation>
    </message>
    <message>
        <source>%1: %2. Buildings and ground: SHA-256 %3.</source>
        <translation>%1: %2. Gebäude und Boden: SHA-256 %3.</translation>
    </message>
    <message>
        <source>no changes</source>
        <translation>keine Änderungen</translation>
    </message>
    <message>
        <source>Colours: %1 in %2; continuous shadow in %3.</source>
        <translation>Farben: %1 in %2; Dauerschatten in %3.</translation>
    </message>
    <message>
        <source>sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>gross shadow</source>
        <translation>Gesamtschatten</translation>
    </message>
    <message>
        <source>Change: minutes in %1 minus minutes in %2, with the same engine, steps and cells; positive means more %3. %4</source>
        <translation>Änderung: Minuten in %1 minus Minuten in %2, mit demselben Verfahren, denselben Schritten und Zellen; positiv heißt mehr %3. %4</translation>
    </message>
    <message>
        <source>shadow</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>%1: %2 with more than %3 min a day of additional gross shadow</source>
        <translation>%1: %2 mit mehr als %3 min zusätzlichem Gesamtschatten am Tag</translation>
    </message>
    <message>
        <source>This is the error of the change, compared with the change by the ray reference.</source>
        <translation>Dies ist der Fehler der Änderung, verglichen mit der Änderung nach der Strahlenreferenz.</translation>
    </message>
    <message>
        <source>%1, %2 m high</source>
        <translation>%1, %2 m hoch</translation>
    </message>
    <message>
        <source>Further new buildings</source>
        <translation>Weitere neue Gebäude</translation>
    </message>
    <message>
        <source>sun above the horizon for %1 min a day</source>
        <translation>Sonne %1 min am Tag über dem Horizont</translation>
    </message>
    <message>
        <source> Positive means that wanted shade outweighs unwanted shadow. The figures of the months add up to the total.</source>
        <translation> Positiv heißt, dass erwünschter Schatten den unerwünschten überwiegt. Die Zahlen der Monate ergeben zusammen die Summe.</translation>
    </message>
    <message>
        <source>Engine: %1.</source>
        <translation>Verfahren: %1.</translation>
    </message>
    <message>
        <source>Receivers: centres of square cells of %1 m on %2, inside the region.</source>
        <translation>Messpunkte: Mitten quadratischer Zellen von %1 m auf %2, im Gebiet.</translation>
    </message>
    <message>
        <source>Weights: %1</source>
        <translation>Gewichte: %1</translation>
    </message>
    <message>
        <source>Shadow score of %1</source>
        <translation>Schattenbewertung von %1</translation>
    </message>
    <message>
        <source> At each step a ray is traced from each receiver to the centre of the sun; the receiver is in shadow if a building or the terrain blocks the ray.</source>
        <translation> In jedem Schritt wird von jedem Messpunkt ein Strahl zur Sonnenmitte verfolgt; der Messpunkt liegt im Schatten, wenn ein Gebäude oder das Gelände den Strahl aufhält.</translation>
    </message>
    <message>
        <source>the terrain</source>
        <translation>dem Gelände</translation>
    </message>
    <message>
        <source>flat ground</source>
        <translation>ebenem Boden</translation>
    </message>
    <message>
        <source>Receivers: centres of square cells of %1 m on %2, inside the region and not under a building.</source>
        <translation>Messpunkte: Mitten quadratischer Zellen von %1 m auf %2, im Gebiet und nicht unter einem Gebäude.</translation>
    </message>
    <message>
        <source>Terrain: %1.</source>
        <translation>Gelände: %1.</translation>
    </message>
    <message>
        <source>; a single day is up to %1 min too long or too short</source>
        <translation>; ein einzelner Tag ist bis zu %1 min zu lang oder zu kurz</translation>
    </message>
    <message>
        <source> The requested step was %1 min; its length was adjusted so that whole steps fill the hours of each day and the period has the exact number of minutes%2.</source>
        <translation> Der verlangte Schritt war %1 min; seine Länge wurde angepasst, damit ganze Schritte die Stunden jedes Tages füllen und der Zeitraum genau die richtige Zahl von Minuten hat%2.</translation>
    </message>
    <message>
        <source>Time: %1 steps of %2 min used; %3 left out because the sun was below the horizon (night is not shadow). Shares of time refer to the time with the sun above the horizon.%4</source>
        <translation>Zeit: %1 Schritte von %2 min verwendet; %3 weggelassen, weil die Sonne unter dem Horizont stand (Nacht ist kein Schatten). Zeitanteile beziehen sich auf die Zeit mit der Sonne über dem Horizont.%4</translation>
    </message>
    <message>
        <source>geometric altitude, without refraction</source>
        <translation>geometrische Höhe, ohne Refraktion</translation>
    </message>
    <message>
        <source>apparent altitude, with refraction at %1 hPa and %2 °C</source>
        <translation>scheinbare Höhe, mit Refraktion bei %1 hPa und %2 °C</translation>
    </message>
    <message>
        <source> At %1 steps the sun is just above the horizon but below the plane of the geometry; they are computed with the sun in that plane.</source>
        <translation> In %1 Schritten steht die Sonne knapp über dem Horizont, aber unter der Ebene der Geometrie; sie sind mit der Sonne in dieser Ebene berechnet.</translation>
    </message>
    <message>
        <source> In the frame of the geometry true north is rotated by %1° there and the vertical by %2°; at the farthest corner of the region the vertical differs by up to %3° (%4 s of the sun&apos;s motion).%5</source>
        <translation> Im Koordinatensystem der Geometrie ist geografisch Nord dort um %1° gedreht und die Senkrechte um %2°; an der entferntesten Ecke des Gebiets weicht die Senkrechte um bis zu %3° ab (%4 s der Sonnenbewegung).%5</translation>
    </message>
    <message>
        <source>Sun: ERFA, topocentric, seen from the centre of the region (%1, %2 m); %3. Civil time of %4 from the tz database.%5</source>
        <translation>Sonne: ERFA, topozentrisch, von der Mitte des Gebiets aus gesehen (%1, %2 m); %3. Ortszeit von %4 aus der tz-Datenbank.%5</translation>
    </message>
    <message>
        <source>Frame: metres to the east and true north of %1 (WGS84), the CRS of shadow.tif: %2</source>
        <translation>Koordinaten: Meter nach Osten und geografisch Norden von %1 (WGS84), das CRS von shadow.tif: %2</translation>
    </message>
    <message>
        <source>%1 % in the mean, %2 % at the 99th percentile, %3 % (%4 min) at the worst receiver (%5)</source>
        <translation>%1 % im Mittel, %2 % beim 99. Perzentil, %3 % (%4 min) am schlechtesten Messpunkt (%5)</translation>
    </message>
    <message>
        <source>; continuous shadow by %1, of the longest day</source>
        <translation>; Dauerschatten um %1, des längsten Tages</translation>
    </message>
    <message>
        <source>Measured on %1 of the %2 receivers, spread over the region and traced again by the ray reference over the same %3 steps: shadow area off by %4 % of the ground (standard error %5); gross shadow by %6, of the sunlit time%7.</source>
        <translation>An %1 der %2 Messpunkte gemessen, über das Gebiet verteilt und mit der Strahlenreferenz in denselben %3 Schritten nachgerechnet: Schattenfläche um %4 % des Bodens daneben (Standardfehler %5); Gesamtschatten um %6, der besonnten Zeit%7.</translation>
    </message>
    <message>
        <source>All other engines are measured against the ray reference: for the city as modelled, one exact test decides each receiver and step. Changes between sun and shadow are resolved to one step (%1 min), edges of shadows to one cell (%2 m).</source>
        <translation>Alle anderen Verfahren werden gegen die Strahlenreferenz gemessen: für die Stadt, wie sie modelliert ist, entscheidet eine genaue Prüfung jeden Messpunkt und Schritt. Wechsel zwischen Sonne und Schatten sind auf einen Schritt (%1 min) aufgelöst, Schattenränder auf eine Zelle (%2 m).</translation>
    </message>
    <message>
        <source>Limits of the model: roofs are flat unless the data contains their shape; %1; the sun is a point, whereas its real disc of 0.53° blurs a shadow&apos;s edge by about 1 m per 100 m of distance from the occluder. An error in height moves the end of a shadow by error / tan(altitude of the sun): see the sources of the heights.</source>
        <translation>Grenzen des Modells: Dächer sind flach, wenn die Daten ihre Form nicht enthalten; %1; die Sonne ist ein Punkt, während ihre wirkliche Scheibe von 0,53° den Schattenrand um etwa 1 m je 100 m Entfernung vom Hindernis verwischt. Ein Höhenfehler verschiebt das Schattenende um Fehler / tan(Sonnenhöhe): siehe die Herkunft der Höhen.</translation>
    </message>
    <message>
        <source>trees count only in figures that name them, street furniture in none</source>
        <translation>Bäume zählen nur in Zahlen, die sie nennen, Straßenmöbel in keiner</translation>
    </message>
    <message>
        <source>trees and street furniture are not included</source>
        <translation>Bäume und Straßenmöbel sind nicht enthalten</translation>
    </message>
    <message>
        <source> Shares: of the receivers&apos; area and of the sunlit time.</source>
        <translation> Anteile: an der Fläche der Messpunkte und an der besonnten Zeit.</translation>
    </message>
    <message>
        <source>Continuous shadow was not counted.</source>
        <translation>Dauerschatten wurde nicht gezählt.</translation>
    </message>
    <message>
        <source>Error against the ray reference, on a sample</source>
        <translation>Fehler gegen die Strahlenreferenz, an einer Stichprobe</translation>
    </message>
    <message>
        <source>, scenario </source>
        <translation>, Szenario </translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Eingaben</translation>
    </message>
    <message>
        <source>and %1 more: see the JSON file</source>
        <translation>und %1 weitere: siehe die JSON-Datei</translation>
    </message>
    <message>
        <source>No file: the city was not read from a file.</source>
        <translation>Keine Datei: die Stadt wurde nicht aus einer Datei gelesen.</translation>
    </message>
    <message>
        <source>%1: %2, the city without edits.</source>
        <translation>%1: %2, die Stadt ohne Änderungen.</translation>
    </message>
    <message>
        <source>The project has not been saved yet.</source>
        <translation>Das Projekt ist noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>%1, which does not contain the latest changes.</source>
        <translation>%1, das die letzten Änderungen nicht enthält.</translation>
    </message>
    <message>
        <source>%1, SHA-256 of the file:</source>
        <translation>%1, SHA-256 der Datei:</translation>
    </message>
    <message>
        <source>Project and scenario</source>
        <translation>Projekt und Szenario</translation>
    </message>
    <message>
        <source>SHA-256 of the content behind the result (defined in the JSON file):</source>
        <translation>SHA-256 des Inhalts hinter dem Ergebnis (in der JSON-Datei definiert):</translation>
    </message>
    <message>
        <source>an unknown number of m</source>
        <translation>einer unbekannten Zahl von m</translation>
    </message>
    <message>
        <source>from levels × %1</source>
        <translation>aus Geschossen × %1</translation>
    </message>
    <message>
        <source>missing in the data and replaced by a default (%1 for a whole building)</source>
        <translation>fehlen in den Daten und sind durch eine Vorgabe ersetzt (%1 für ein ganzes Gebäude)</translation>
    </message>
    <message>
        <source>from three-dimensional data</source>
        <translation>aus dreidimensionalen Daten</translation>
    </message>
    <message>
        <source>designed: given by the scenario</source>
        <translation>entworfen: vom Szenario gegeben</translation>
    </message>
    <message>
        <source>made up: a sample of no real place</source>
        <translation>erfunden: ein Beispiel ohne wirklichen Ort</translation>
    </message>
    <message>
        <source>%1 in %2. Heights of the parts: %3.</source>
        <translation>%1 in %2. Höhen der Teile: %3.</translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation>Aus %1.</translation>
    </message>
    <message>
        <source>Features of the files are not parts: an outline that has parts of its own makes none, a feature of several outlines several.</source>
        <translation>Objekte der Dateien sind keine Teile: ein Umriss mit eigenen Teilen ergibt keinen, ein Objekt mit mehreren Umrissen mehrere.</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>None: every feature was used unchanged.</source>
        <translation>Keine: jedes Objekt wurde unverändert verwendet.</translation>
    </message>
    <message>
        <source>%1 in total, of %2 kinds; the JSON file beside this report lists each one with its feature.</source>
        <translation>%1 insgesamt, von %2 Arten; die JSON-Datei neben diesem Bericht nennt jeden mit seinem Objekt.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>%1 of %2 buildings used</source>
        <translation>%1 von %2 Gebäuden verwendet</translation>
    </message>
    <message>
        <source>, %1 rays</source>
        <translation>, %1 Strahlen</translation>
    </message>
    <message>
        <source>. Skipped: </source>
        <translation>. Ausgelassen: </translation>
    </message>
    <message>
        <source>Computation</source>
        <translation>Berechnung</translation>
    </message>
    <message>
        <source>How to repeat this result</source>
        <translation>Wie dieses Ergebnis zu wiederholen ist</translation>
    </message>
    <message>
        <source>%1 lies beside this report.</source>
        <translation>%1 liegt neben diesem Bericht.</translation>
    </message>
    <message>
        <source>Shadow study</source>
        <translation>Schattenuntersuchung</translation>
    </message>
    <message>
        <source>at an unknown time</source>
        <translation>zu unbekannter Zeit</translation>
    </message>
    <message>
        <source>on </source>
        <translation>am </translation>
    </message>
    <message>
        <source>A result saved in the project</source>
        <translation>Ein im Projekt gespeichertes Ergebnis</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, saved %2 by %3. Maps and figures are those that were saved.</source>
        <translation>„%1“, gespeichert %2 von %3. Karten und Zahlen sind die, die gespeichert wurden.</translation>
    </message>
    <message>
        <source>Its inputs have not changed since.</source>
        <translation>Seine Eingaben haben sich seither nicht geändert.</translation>
    </message>
    <message>
        <source>The buildings drawn are those of the scenario as it is now.</source>
        <translation>Gezeichnet sind die Gebäude des Szenarios, wie es jetzt ist.</translation>
    </message>
    <message>
        <source>Square cells of %1 m; those that were not measured are white on the map.</source>
        <translation>Quadratische Zellen von %1 m; die nicht gemessenen sind auf der Karte weiß.</translation>
    </message>
    <message>
        <source>Error: %1.</source>
        <translation>Fehler: %1.</translation>
    </message>
    <message>
        <source>Weight table: %1.</source>
        <translation>Gewichtstabelle: %1.</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Shadow study of %1</source>
        <translation>Schattenuntersuchung von %1</translation>
    </message>
    <message>
        <source>Change: minutes in %1 minus minutes in %2; positive means more %3. %4</source>
        <translation>Änderung: Minuten in %1 minus Minuten in %2; positiv heißt mehr %3. %4</translation>
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
        <translation>W</translation>
    </message>
    <message>
        <source>E</source>
        <translation>O</translation>
    </message>
    <message>
        <source>%1 m east-west by %2 m north-south around %3 (WGS84)</source>
        <translation>%1 m von Ost nach West mal %2 m von Nord nach Süd um %3 (WGS84)</translation>
    </message>
    <message>
        <source>Data: </source>
        <translation>Daten: </translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Zellgröße</translation>
    </message>
    <message>
        <source>Steps of the sun</source>
        <translation>Sonnenstände</translation>
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
        <translation>Sonnenaufgang</translation>
    </message>
    <message>
        <source> to </source>
        <translation> bis </translation>
    </message>
    <message>
        <source>sunset</source>
        <translation>Sonnenuntergang</translation>
    </message>
    <message>
        <source>%1 for %2 h</source>
        <translation>%1, %2 h lang</translation>
    </message>
    <message>
        <source>no date</source>
        <translation>kein Datum</translation>
    </message>
    <message>
        <source>%1 to %2 (%3)</source>
        <translation>%1 bis %2 (%3)</translation>
    </message>
    <message>
        <source>at </source>
        <translation>um </translation>
    </message>
    <message>
        <source>, every %1 min</source>
        <translation>, alle %1 min</translation>
    </message>
    <message>
        <source>... the rest is in the JSON file</source>
        <translation>... der Rest steht in der JSON-Datei</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>nicht geprüft</translation>
    </message>
    <message>
        <source>December to February</source>
        <translation>Dezember bis Februar</translation>
    </message>
    <message>
        <source>March to May</source>
        <translation>März bis Mai</translation>
    </message>
    <message>
        <source>June to August</source>
        <translation>Juni bis August</translation>
    </message>
    <message>
        <source>September to November</source>
        <translation>September bis November</translation>
    </message>
    <message>
        <source>every</source>
        <translation>jeder</translation>
    </message>
    <message>
        <source>average</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>gewählt</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>civil</source>
        <translation>bürgerliche Zeit</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>Normalzeit</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>true solar</source>
        <translation>wahre Sonnenzeit</translation>
    </message>
    <message>
        <source>upper limb</source>
        <translation>Oberrand</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>windows</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>existing</source>
        <translation>Bestand</translation>
    </message>
    <message>
        <source>no action</source>
        <translation>ohne Vorhaben</translation>
    </message>
    <message>
        <source>reference body</source>
        <translation>Vergleichskörper</translation>
    </message>
    <message>
        <source>mid pane</source>
        <translation>Scheibenmitte</translation>
    </message>
    <message>
        <source>sill middle</source>
        <translation>Mitte der Brüstung</translation>
    </message>
    <message>
        <source>sill ends</source>
        <translation>Enden der Brüstung</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>dwelling</source>
        <translation>Wohnung</translation>
    </message>
    <message>
        <source>% of the sky&apos;s light</source>
        <translation>% des Himmelslichts</translation>
    </message>
    <message>
        <source>% of the year&apos;s probable sun</source>
        <translation>% der wahrscheinlichen Sonne des Jahres</translation>
    </message>
    <message>
        <source>rays</source>
        <translation>Strahlen</translation>
    </message>
    <message>
        <source>horizons with ends by rays</source>
        <translation>Horizonte, deren Enden Strahlen bestimmen</translation>
    </message>
    <message>
        <source>The windows of %1 more buildings are in windows.csv</source>
        <translation>Die Fenster weiterer Gebäude stehen in windows.csv: %1 Gebäude</translation>
    </message>
    <message>
        <source>; %1 more windows are in windows.csv</source>
        <translation>; weitere Fenster in windows.csv: %1</translation>
    </message>
    <message>
        <source>Projected shadows: each building&apos;s shadow filled as polygons at every step, exact on flat ground</source>
        <translation>Projizierte Schatten: der Schatten jedes Gebäudes bei jedem Schritt als Polygone gefüllt, genau auf ebenem Boden</translation>
    </message>
    <message>
        <source>cells under buildings</source>
        <translation>Zellen unter Gebäuden</translation>
    </message>
    <message>
        <source>cells outside the region</source>
        <translation>Zellen außerhalb des Gebiets</translation>
    </message>
    <message>
        <source>cells on water</source>
        <translation>Zellen auf Wasser</translation>
    </message>
    <message>
        <source>steps with the sun below the horizon</source>
        <translation>Schritte mit der Sonne unter dem Horizont</translation>
    </message>
    <message>
        <source>shadows that meet no receiver (casters x steps x bands of rows)</source>
        <translation>Schatten, die keinen Messpunkt treffen (Werfer x Schritte x Zeilenbänder)</translation>
    </message>
    <message>
        <source>prisms and solids whose shadow cannot reach a tile (each x azimuth bins)</source>
        <translation>Prismen und Körper, deren Schatten eine Kachel nicht erreichen kann (je x Azimutklassen)</translation>
    </message>
    <message>
        <source>buildings whose shadow cannot reach a receiver</source>
        <translation>Gebäude, deren Schatten keinen Messpunkt erreichen kann</translation>
    </message>
    <message>
        <source>Projected shadows: exact on flat ground, one run for all months and intervals</source>
        <translation>Projizierte Schatten: genau auf ebenem Boden, ein Lauf für alle Monate und Intervalle</translation>
    </message>
    <message>
        <source>%1 takes more than a minute of sun a day from one place, at most %2 at one spot.</source>
        <translation>%1 nimmt einem Ort mehr als eine Minute Sonne am Tag, höchstens %2 an einer Stelle.</translation>
    </message>
    <message>
        <source>%1 adds more than a minute of shadow a day to one place, at most %2 at one spot.</source>
        <translation>%1 bringt einem Ort mehr als eine Minute Schatten am Tag, höchstens %2 an einer Stelle.</translation>
    </message>
    <message>
        <source>greenstreet</source>
        <translation>Rasen oder Beet</translation>
    </message>
    <message>
        <source>other</source>
        <translation>anderer Ort</translation>
    </message>
</context>
<context>
    <name>noonmark::AccuracyForm</name>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>How the shadow is computed; the ray reference is the standard for the errors of the others</source>
        <translation>Wie der Schatten berechnet wird; an der Strahlreferenz werden die Fehler der anderen gemessen</translation>
    </message>
</context>
<context>
    <name>noonmark::AccuracySection</name>
    <message>
        <source>As in the paper</source>
        <translation>Wie im Artikel</translation>
    </message>
    <message>
        <source>Exploration by shadow accrual maps, analysis by inverse accrual maps through the direction graph,
as published. Approximate: the legend states the measured error</source>
        <translation>Erkundung mit Schattenakkumulationskarten, Analyse mit inversen Akkumulationskarten über den Richtungsgraphen,
wie veröffentlicht. Genähert: die Legende nennt den gemessenen Fehler</translation>
    </message>
    <message>
        <source>Method and options</source>
        <translation>Verfahren und Optionen</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Zellgröße</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>cell size</source>
        <translation>Zellgröße</translation>
    </message>
    <message>
        <source>accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Side of a cell on the ground. Half the size: four times the cells</source>
        <translation>Seite einer Zelle auf dem Boden. Halb so groß: viermal so viele Zellen</translation>
    </message>
</context>
<context>
    <name>noonmark::BookView</name>
    <message>
        <source>Previous page</source>
        <translation>Vorige Seite</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Nächste Seite</translation>
    </message>
    <message>
        <source>Goes to a chapter; the PDF has them as bookmarks</source>
        <translation>Geht zu einem Kapitel; im PDF sind sie Lesezeichen</translation>
    </message>
    <message>
        <source>How large the page is shown</source>
        <translation>Wie groß die Seite gezeigt wird</translation>
    </message>
    <message>
        <source>Whole page</source>
        <translation>Ganze Seite</translation>
    </message>
    <message>
        <source>Page width</source>
        <translation>Seitenbreite</translation>
    </message>
    <message>
        <source>%1 dots per inch</source>
        <translation>%1 Punkte je Zoll</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>Painting the page</source>
        <translation>Die Seite wird gezeichnet</translation>
    </message>
    <message>
        <source>Sheets that are to be written are shown here</source>
        <translation>Hier stehen die Blätter, die geschrieben werden</translation>
    </message>
</context>
<context>
    <name>noonmark::Breakdown</name>
    <message>
        <source>sweeping horizons</source>
        <translation>sucht Horizonte</translation>
    </message>
</context>
<context>
    <name>noonmark::BreakdownForm</name>
    <message>
        <source>Each month by itself</source>
        <translation>Jeder Monat für sich</translation>
    </message>
    <message>
        <source>Also sums the shadow of each month: bars in the panel Contributions, a table and maps in exports</source>
        <translation>Summiert auch den Schatten jedes Monats: Balken im Feld Beiträge, eine Tabelle und Karten in Exporten</translation>
    </message>
    <message>
        <source>Contribution of each building</source>
        <translation>Beitrag jedes Gebäudes</translation>
    </message>
    <message>
        <source>Attributed shadow</source>
        <translation>Zugerechneter Schatten</translation>
    </message>
    <message>
        <source>Sole contribution</source>
        <translation>Alleiniger Beitrag</translation>
    </message>
    <message>
        <source>months</source>
        <translation>Monate</translation>
    </message>
    <message>
        <source>contributions</source>
        <translation>Beiträge</translation>
    </message>
    <message>
        <source>Also finds what each building takes, for the panel Contributions and exports; takes up to twice as long.</source>
        <translation>Ermittelt auch, was jedes Gebäude nimmt, für das Feld Beiträge und den Export; dauert bis zu doppelt so lange.</translation>
    </message>
</context>
<context>
    <name>noonmark::BuildingAdder</name>
    <message>
        <source>finding the buildings</source>
        <translation>sucht die Gebäude</translation>
    </message>
</context>
<context>
    <name>noonmark::BuildingEditing</name>
    <message>
        <source>%1, %2
%3 floor area</source>
        <translation>%1, %2
%3 Geschossfläche</translation>
    </message>
    <message numerus="yes">
        <source>demolish %1 building(s)</source>
        <translation>
            <numerusform>%1 Gebäude abreißen</numerusform>
            <numerusform>%1 Gebäude abreißen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::CachedTile</name>
    <message>
        <source>sweeping horizons</source>
        <translation>sucht Horizonte</translation>
    </message>
</context>
<context>
    <name>noonmark::ChartPages</name>
    <message>
        <source>Timelines</source>
        <translation>Zeitverläufe</translation>
    </message>
    <message>
        <source>Clock: %1.</source>
        <translation>Uhrzeit: %1.</translation>
    </message>
</context>
<context>
    <name>noonmark::CompareActions</name>
    <message>
        <source>Scenarios side by side</source>
        <translation>Szenarien nebeneinander</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>Two scenarios with one camera and at one time, the other one on the left</source>
        <translation>Zwei Szenarien mit einer Kamera und zu einer Zeit, das andere links</translation>
    </message>
    <message>
        <source>Swipe between scenarios</source>
        <translation>Zwischen Szenarien wischen</translation>
    </message>
    <message>
        <source>Shift+D</source>
        <translation>Shift+D</translation>
    </message>
    <message>
        <source>Drag the line in the view: the other scenario lies to its left</source>
        <translation>Die Linie in der Ansicht ziehen: links von ihr liegt das andere Szenario</translation>
    </message>
    <message>
        <source>Show the other scenario</source>
        <translation>Das andere Szenario zeigen</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Press again for the displayed scenario: what differs flickers</source>
        <translation>Noch einmal drücken für das angezeigte Szenario: Unterschiede flackern</translation>
    </message>
    <message>
        <source>There is only one scenario. Change a building or design a tower, then compare</source>
        <translation>Es gibt nur ein Szenario. Ändern Sie ein Gebäude oder entwerfen Sie einen Turm, dann vergleichen</translation>
    </message>
    <message>
        <source>Left: %1. Right: %2</source>
        <translation>Links: %1. Rechts: %2</translation>
    </message>
    <message>
        <source>shown: %1</source>
        <translation>gezeigt: %1</translation>
    </message>
    <message>
        <source>sun and shadow of the same moment</source>
        <translation>Sonne und Schatten desselben Zeitpunkts</translation>
    </message>
    <message>
        <source>explored: %1 only</source>
        <translation>erkundet: nur %1</translation>
    </message>
    <message>
        <source>the same question, in the same colours</source>
        <translation>dieselbe Frage in denselben Farben</translation>
    </message>
    <message>
        <source>not measured yet: %1 (Scenario &gt; Measure all scenarios)</source>
        <translation>noch nicht gemessen: %1 (Szenario &gt; Alle Szenarien messen)</translation>
    </message>
</context>
<context>
    <name>noonmark::CompareStrip</name>
    <message>
        <source>The scenario on the left, or under the key C</source>
        <translation>Das Szenario links, oder mit der Taste C</translation>
    </message>
    <message>
        <source>The displayed scenario, which edits change</source>
        <translation>Das angezeigte Szenario, das bearbeitet wird</translation>
    </message>
    <message>
        <source>Ends the comparison in the view</source>
        <translation>Beendet den Vergleich in der Ansicht</translation>
    </message>
</context>
<context>
    <name>noonmark::ContextMenu</name>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Replace by tower</source>
        <translation>Durch Turm ersetzen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Demolish</source>
        <translation>Abreißen</translation>
    </message>
    <message>
        <source>Study its surroundings</source>
        <translation>Umgebung untersuchen</translation>
    </message>
    <message>
        <source>Make its outline a place</source>
        <translation>Umriss als Ort aufnehmen</translation>
    </message>
    <message>
        <source>Study this place</source>
        <translation>Diesen Ort untersuchen</translation>
    </message>
    <message>
        <source>Zoom to it</source>
        <translation>Von nahem zeigen</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Hier</translation>
    </message>
    <message>
        <source>Sun and sky here</source>
        <translation>Sonne und Himmel hier</translation>
    </message>
    <message>
        <source>Draw lot</source>
        <translation>Grundstück zeichnen</translation>
    </message>
    <message>
        <source>Draw place</source>
        <translation>Ort zeichnen</translation>
    </message>
    <message>
        <source>Draw region</source>
        <translation>Gebiet zeichnen</translation>
    </message>
    <message>
        <source>Copy position: %1</source>
        <translation>Position kopieren: %1</translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation>Von hier messen</translation>
    </message>
    <message>
        <source>Demolish the %1 selected</source>
        <translation>Die %1 ausgewählten abreißen</translation>
    </message>
    <message>
        <source>Edit lot</source>
        <translation>Grundstück bearbeiten</translation>
    </message>
</context>
<context>
    <name>noonmark::ContributionLinks</name>
    <message>
        <source>No study yet. Run one (Ctrl+R), then click a place in the view to see which buildings shade it.</source>
        <translation>Noch keine Untersuchung. Eine berechnen (Strg+R), dann in der Ansicht auf einen Ort klicken, um zu sehen, welche Gebäude ihn verschatten.</translation>
    </message>
    <message>
        <source>What the buildings take from this place has not been computed yet.</source>
        <translation>Was die Gebäude diesem Ort nehmen, ist noch nicht berechnet.</translation>
    </message>
    <message>
        <source>Click a place in the view to see which buildings shade it, or attribute the shadow of the whole region.</source>
        <translation>In der Ansicht auf einen Ort klicken, um zu sehen, welche Gebäude ihn verschatten, oder den Schatten des ganzen Gebiets zurechnen.</translation>
    </message>
    <message>
        <source>Attributing the shadow of %1</source>
        <translation>Der Schatten von %1 wird zugerechnet</translation>
    </message>
    <message>
        <source>Choose a place of the table, or click one in the view, to see which buildings shade it.</source>
        <translation>Wählen Sie einen Ort der Tabelle, oder klicken Sie einen in der Ansicht an, um zu sehen, welche Gebäude ihn beschatten.</translation>
    </message>
    <message>
        <source>A saved result holds what buildings take from its whole region, if that was asked for. Of places it holds those that were attributed before it was saved.</source>
        <translation>Ein gespeichertes Ergebnis enthält, was Gebäude seiner ganzen Region nehmen, falls danach gefragt war. Von Orten enthält es die, die vor dem Speichern zugeordnet wurden.</translation>
    </message>
    <message>
        <source>Buildings or trees have changed since the last answer. Run it again (Ctrl+R), then click a place in the view to see which buildings shade it.</source>
        <translation>Gebäude oder Bäume haben sich seit der letzten Antwort geändert. Führen Sie sie erneut aus (Strg+R) und klicken Sie dann in der Ansicht auf einen Ort, um zu sehen, welche Gebäude ihn beschatten.</translation>
    </message>
</context>
<context>
    <name>noonmark::ContributionModel</name>
    <message>
        <source>Building</source>
        <translation>Gebäude</translation>
    </message>
    <message>
        <source>Building or tree</source>
        <translation>Gebäude oder Baum</translation>
    </message>
</context>
<context>
    <name>noonmark::Contributions</name>
    <message>
        <source>E</source>
        <translation>O</translation>
    </message>
    <message>
        <source>NE</source>
        <translation>NO</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>NW</source>
        <translation>NW</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>SW</source>
        <translation>SW</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>SO</translation>
    </message>
</context>
<context>
    <name>noonmark::ContributionsDock</name>
    <message>
        <source>Attribute the shadow</source>
        <translation>Schatten zurechnen</translation>
    </message>
    <message>
        <source>Finds what each building takes, by month, with the engine and the steps of the study</source>
        <translation>Ermittelt, was jedes Gebäude nimmt, nach Monat, mit dem Verfahren und den Schritten der Untersuchung</translation>
    </message>
    <message>
        <source>Colour the buildings</source>
        <translation>Gebäude färben</translation>
    </message>
    <message>
        <source>Whose shadow is attributed to buildings. Or click a place in the view</source>
        <translation>Wessen Schatten den Gebäuden zugerechnet wird. Oder in der Ansicht auf einen Ort klicken</translation>
    </message>
    <message>
        <source>Colours the buildings in the view by their share of the shadow</source>
        <translation>Färbt die Gebäude in der Ansicht nach ihrem Anteil am Schatten</translation>
    </message>
    <message>
        <source>A row selects its building in the view; double-click to go there</source>
        <translation>Eine Zeile wählt ihr Gebäude in der Ansicht aus; ein Doppelklick führt dorthin</translation>
    </message>
    <message>
        <source>Share of the shadow that a building is charged with</source>
        <translation>Anteil am Schatten, der einem Gebäude zugerechnet wird</translation>
    </message>
    <message>
        <source>Whole region</source>
        <translation>Ganzes Gebiet</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportieren ...</translation>
    </message>
    <message>
        <source>Writes this list with the answer, as CSV and JSON</source>
        <translation>Schreibt diese Liste mit der Antwort als CSV und JSON</translation>
    </message>
</context>
<context>
    <name>noonmark::CopyActions</name>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>The table or text last clicked, else the picture of the view</source>
        <translation>Die zuletzt angeklickte Tabelle oder der Text, sonst das Bild der Ansicht</translation>
    </message>
    <message>
        <source>The figures of the panel Results, as a table</source>
        <translation>Die Zahlen des Felds Ergebnisse als Tabelle</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>The view with title, legend, scale and north</source>
        <translation>Die Ansicht mit Titel, Legende, Maßstab und Nordpfeil</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>%1 copied</source>
        <translation>%1 kopiert</translation>
    </message>
    <message>
        <source>Copy fi&amp;gures</source>
        <translation>&amp;Zahlen kopieren</translation>
    </message>
    <message>
        <source>C&amp;opy picture</source>
        <translation>Bi&amp;ld kopieren</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
</context>
<context>
    <name>noonmark::CrownTracer</name>
    <message>
        <source>tracing rays through trees</source>
        <translation>verfolgt Strahlen durch Bäume</translation>
    </message>
</context>
<context>
    <name>noonmark::DayClock</name>
    <message>
        <source>%1, with daylight saving</source>
        <translation>%1, mit Sommerzeit</translation>
    </message>
    <message>
        <source>%1, standard time</source>
        <translation>%1, Normalzeit</translation>
    </message>
    <message>
        <source>true solar time</source>
        <translation>wahre Sonnenzeit</translation>
    </message>
</context>
<context>
    <name>noonmark::DayPanel</name>
    <message>
        <source>Any day, in the hours of the rule</source>
        <translation>Ein beliebiger Tag in den Stunden der Regel</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitverlauf</translation>
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
        <translation>Sonnenbahnkuppel</translation>
    </message>
    <message>
        <source>The sun&apos;s paths of the months and the hours on a dome around what the camera looks at, or around the pin of the panel Point</source>
        <translation>Die Sonnenbahnen der Monate und die Stunden auf einer Kuppel um das, was die Kamera ansieht, oder um die Nadel des Felds Punkt</translation>
    </message>
</context>
<context>
    <name>noonmark::EditActions</name>
    <message>
        <source>%1 is not a building of the displayed city</source>
        <translation>%1 ist kein Gebäude der angezeigten Stadt</translation>
    </message>
    <message>
        <source>reload %1</source>
        <translation>%1 neu laden</translation>
    </message>
    <message>
        <source>region</source>
        <translation>Gebiet</translation>
    </message>
    <message>
        <source>The study&apos;s region is now around what you built; Study &gt; Where changes it</source>
        <translation>Das Untersuchungsgebiet liegt jetzt um das, was Sie gebaut haben; „Untersuchung &gt; Wo“ ändert es</translation>
    </message>
</context>
<context>
    <name>noonmark::EditPreview</name>
    <message>
        <source>%1. Shape of %2 s ago</source>
        <translation>%1. Form von vor %2 s</translation>
    </message>
    <message>
        <source>The live shadow was cancelled; it returns with the next design</source>
        <translation>Der mitlaufende Schatten wurde abgebrochen; beim nächsten Entwurf kommt er wieder</translation>
    </message>
    <message>
        <source>No live shadow. %1</source>
        <translation>Kein mitlaufender Schatten. %1</translation>
    </message>
    <message>
        <source>No live facades. %1</source>
        <translation>Keine mitlaufenden Fassaden. %1</translation>
    </message>
    <message numerus="yes">
        <source>Facades: %1 point(s) while it moves</source>
        <translation>
            <numerusform>Fassaden: %1 Punkt während der Bewegung</numerusform>
            <numerusform>Fassaden: %1 Punkte während der Bewegung</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Facades: %1 point(s)</source>
        <translation>
            <numerusform>Fassaden: %1 Punkt</numerusform>
            <numerusform>Fassaden: %1 Punkte</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::EditTools</name>
    <message>
        <source>Draw &amp;lot</source>
        <translation>&amp;Grundstück zeichnen</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>&amp;Demolish</source>
        <translation>Gebäude &amp;abreißen</translation>
    </message>
    <message>
        <source>Replace by &amp;tower</source>
        <translation>Durch &amp;Turm ersetzen</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Replaces the selected building by a tower on its lot or footprint</source>
        <translation>Ersetzt das ausgewählte Gebäude durch einen Turm auf seinem Grundstück oder Grundriss</translation>
    </message>
    <message>
        <source>&amp;Move building</source>
        <translation>Gebäude &amp;verschieben</translation>
    </message>
    <message>
        <source>Drag the selected building over the ground</source>
        <translation>Das ausgewählte Gebäude über den Boden ziehen</translation>
    </message>
    <message>
        <source>Creates a lot from the selected building&apos;s outline</source>
        <translation>Legt aus dem Umriss des ausgewählten Gebäudes ein Grundstück an</translation>
    </message>
    <message>
        <source>&amp;Import mesh...</source>
        <translation>3D-Modell &amp;einfügen ...</translation>
    </message>
    <message>
        <source>Adds a building from a mesh file, placed by a click</source>
        <translation>Fügt ein Gebäude aus einer Modelldatei ein, durch einen Klick gesetzt</translation>
    </message>
    <message>
        <source>Drag the building over the ground. Esc ends the tool.</source>
        <translation>Das Gebäude über den Boden ziehen. Esc beendet das Werkzeug.</translation>
    </message>
    <message>
        <source>Lot from foot&amp;print</source>
        <translation>Grundstück aus Grund&amp;riss</translation>
    </message>
    <message>
        <source>Drag the arrow or type a height. Shift: do not snap to storeys. Enter builds, Esc cancels.</source>
        <translation>Ziehen Sie den Pfeil oder tippen Sie eine Höhe. Umschalttaste: nicht auf Geschosse einrasten. Eingabetaste baut, Esc bricht ab.</translation>
    </message>
    <message>
        <source>Li&amp;ve facades</source>
        <translation>Mitlaufende &amp;Fassaden</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>Shows the sunlight of a building&apos;s facades while it is designed or changed</source>
        <translation>Zeigt die Besonnung der Fassaden eines Gebäudes, während es entworfen oder geändert wird</translation>
    </message>
    <message>
        <source>Removes the selected building, or all of several</source>
        <translation>Entfernt das ausgewählte Gebäude, oder alle ausgewählten</translation>
    </message>
    <message>
        <source>Live change</source>
        <translation>Mitlaufende Änderung</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>While a building is edited: show the change against the baseline instead of all shadow</source>
        <translation>Zeigt, was ein Gebäude gegenüber der Ausgangslage ändert, während es entworfen oder geändert wird, statt des Schattens mit ihm</translation>
    </message>
    <message>
        <source>Click corners on the ground, or type the length of a side; Shift: right angles, Ctrl: no snapping; Enter finishes, Esc cancels</source>
        <translation>Ecken auf dem Boden anklicken oder die Länge einer Seite eingeben; Umschalt: rechte Winkel, Strg: nicht einrasten; Eingabe beendet, Esc bricht ab</translation>
    </message>
    <message>
        <source>Edit lot &amp;shape</source>
        <translation>Grundstück &amp;umformen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>Drag the corners and sides of the lot that is chosen in the panel Tower, or that the selected building stands on</source>
        <translation>Ecken und Seiten des Grundstücks ziehen, das im Dock Turm gewählt ist oder auf dem das gewählte Gebäude steht</translation>
    </message>
    <message>
        <source>Click the lot&apos;s corners, or type the length of a side. Shift: at right angles to the last side. Ctrl: no snapping. Double click or Enter finishes.</source>
        <translation>Die Ecken des Grundstücks anklicken oder die Länge einer Seite eingeben. Umschalt: rechtwinklig zur letzten Seite. Strg: nicht einrasten. Doppelklick oder Eingabe beendet.</translation>
    </message>
    <message>
        <source>Drag a corner or a side of %1; Ctrl: no snapping. A click on the middle of a side adds a corner, Delete removes the selected one, Esc ends.</source>
        <translation>Eine Ecke oder Seite von %1 ziehen; Strg: nicht einrasten. Ein Klick auf die Mitte einer Seite fügt eine Ecke hinzu, Entf entfernt die gewählte, Esc beendet.</translation>
    </message>
    <message>
        <source>Towers that were designed on it stay as they are.</source>
        <translation>Türme, die darauf entworfen wurden, bleiben unverändert.</translation>
    </message>
    <message>
        <source>Plant trees</source>
        <translation>Bäume pflanzen</translation>
    </message>
    <message>
        <source>Each click on the ground plants a tree; Esc ends</source>
        <translation>Jeder Klick auf den Boden pflanzt einen Baum; Esc beendet</translation>
    </message>
    <message>
        <source>Plant a row of trees</source>
        <translation>Baumreihe pflanzen</translation>
    </message>
    <message>
        <source>Click the corners of a line; a double click or Enter plants trees along it</source>
        <translation>Klicken Sie die Ecken einer Linie; ein Doppelklick oder die Eingabetaste pflanzt Bäume entlang der Linie</translation>
    </message>
    <message>
        <source>Click the corners of a line. A double click or Enter plants trees along it, Esc ends.</source>
        <translation>Klicken Sie die Ecken einer Linie. Ein Doppelklick oder die Eingabetaste pflanzt Bäume entlang der Linie, Esc beendet.</translation>
    </message>
    <message>
        <source>Click where trees are to stand; their measures are in the panel Trees. Esc ends.</source>
        <translation>Klicken Sie, wo Bäume stehen sollen; ihre Maße stehen in der Leiste Bäume. Esc beendet.</translation>
    </message>
</context>
<context>
    <name>noonmark::ElementForm</name>
    <message>
        <source>all of the region</source>
        <translation>alle des Gebiets</translation>
    </message>
    <message>
        <source>Names or ids of buildings, with commas between them; their middle must be in the region. Empty: all buildings of the region</source>
        <translation>Namen oder Kennungen von Gebäuden, durch Kommas getrennt; ihre Mitte muss im Gebiet liegen. Leer: alle Gebäude des Gebiets</translation>
    </message>
    <message>
        <source>Adds the selected building, or removes it. Click a building first.</source>
        <translation>Fügt das gewählte Gebäude hinzu oder entfernt es. Klicken Sie zuerst ein Gebäude an.</translation>
    </message>
    <message>
        <source>file of windows</source>
        <translation>Datei mit Fenstern</translation>
    </message>
    <message>
        <source>Points or polygons with heights, in any vector format. Fields id, azimuth, floor</source>
        <translation>Punkte oder Polygone mit Höhen in einem beliebigen Vektorformat. Felder id, azimuth, floor</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>Durchsuchen ...</translation>
    </message>
    <message>
        <source>Chooses the file of windows</source>
        <translation>Wählt die Datei mit den Fenstern</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>buildings</source>
        <translation>Gebäude</translation>
    </message>
    <message>
        <source>windows</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Add selected</source>
        <translation>Gewähltes dazu</translation>
    </message>
    <message>
        <source>all buildings</source>
        <translation>alle Gebäude</translation>
    </message>
    <message>
        <source>Names or ids of buildings, with commas between them. Empty: all buildings</source>
        <translation>Namen oder Kennungen von Gebäuden, durch Kommas getrennt. Leer: alle Gebäude</translation>
    </message>
    <message>
        <source>Proposed buildings only</source>
        <translation>Nur geplante Gebäude</translation>
    </message>
    <message>
        <source>The buildings that the displayed scenario builds or changes</source>
        <translation>Die Gebäude, die das angezeigte Szenario errichtet oder ändert</translation>
    </message>
</context>
<context>
    <name>noonmark::ElementModel</name>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Gebäude</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Geschoss</translation>
    </message>
    <message>
        <source>Facing, °</source>
        <translation>Richtung, °</translation>
    </message>
</context>
<context>
    <name>noonmark::ElementPicking</name>
    <message>
        <source>Click walls in the view to choose their faces.</source>
        <translation>Klicken Sie in der Ansicht auf Wände, um ihre Flächen zu wählen.</translation>
    </message>
    <message>
        <source>Click the ground, roofs or walls in the view to add points.</source>
        <translation>Klicken Sie in der Ansicht auf Boden, Dächer oder Wände, um Punkte hinzuzufügen.</translation>
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
        <translation>Teil eines Gebäudes oder Punkts</translation>
    </message>
    <message>
        <source>Lists only the points whose id or building contains this text</source>
        <translation>Listet nur Punkte auf, deren Kennung oder Gebäude diesen Text enthält</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Lists only the points with less sun a day than this</source>
        <translation>Listet nur Punkte mit weniger Sonne am Tag auf</translation>
    </message>
    <message>
        <source>Select rows to see their points in the view; double-click to go there</source>
        <translation>Wählen Sie Zeilen, um ihre Punkte in der Ansicht zu sehen; ein Doppelklick führt dorthin</translation>
    </message>
    <message>
        <source>Sun below</source>
        <translation>Sonne unter</translation>
    </message>
    <message>
        <source>No points measured</source>
        <translation>Keine Punkte gemessen</translation>
    </message>
    <message numerus="yes">
        <source>%1 point(s)</source>
        <translation>
            <numerusform>%1 Punkt</numerusform>
            <numerusform>%1 Punkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 point(s)</source>
        <translation>
            <numerusform>%1 von %2 Punkt</numerusform>
            <numerusform>%1 von %2 Punkten</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::ElevationFlow</name>
    <message>
        <source> %1 more buildings are not drawn.</source>
        <translation> %1 weitere Gebäude sind nicht gezeichnet.</translation>
    </message>
    <message>
        <source> %1 sides do not fit on %2 at 1:%3 and are smaller.</source>
        <translation> %1 Seiten passen nicht auf %2 bei 1:%3 und sind kleiner.</translation>
    </message>
    <message>
        <source>%1, facing %2 (%3°)</source>
        <translation>%1, nach %2 (%3°)</translation>
    </message>
    <message>
        <source>, layer %1 of %2</source>
        <translation>, Lage %1 von %2</translation>
    </message>
    <message>
        <source>1:%1 on %2. %3 windows</source>
        <translation>1:%1 auf %2. %3 Fenster</translation>
    </message>
</context>
<context>
    <name>noonmark::Exploration</name>
    <message>
        <source>Exploring</source>
        <translation>Erkundung läuft</translation>
    </message>
</context>
<context>
    <name>noonmark::ExportDialog</name>
    <message>
        <source>Screen</source>
        <translation>Bildschirm</translation>
    </message>
    <message>
        <source>Large screen</source>
        <translation>Großer Bildschirm</translation>
    </message>
    <message>
        <source>A4 in print</source>
        <translation>A4 im Druck</translation>
    </message>
    <message>
        <source>A3 in print</source>
        <translation>A3 im Druck</translation>
    </message>
    <message>
        <source>A1 in print</source>
        <translation>A1 im Druck</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source> pixels wide</source>
        <translation> Pixel breit</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Table of all cells</source>
        <translation>Tabelle aller Zellen</translation>
    </message>
    <message>
        <source>A line of text for each cell: large for a large region</source>
        <translation>Eine Textzeile je Zelle: bei großen Gebieten umfangreich</translation>
    </message>
    <message>
        <source>Sheets with a title block</source>
        <translation>Blätter mit Schriftfeld</translation>
    </message>
    <message>
        <source>A PDF with maps, figures, charts and method on several pages</source>
        <translation>Ein PDF mit Karten, Zahlen, Diagrammen und Verfahren auf mehreren Seiten</translation>
    </message>
    <message>
        <source>a folder; it is created if missing</source>
        <translation>ein Ordner; fehlt er, wird er angelegt</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>Durchsuchen ...</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Einen Ordner wählen</translation>
    </message>
    <message>
        <source>Export to folder</source>
        <translation>In Ordner exportieren</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>With the project</source>
        <translation>Mit dem Projekt</translation>
    </message>
    <message>
        <source>Puts a copy of the project&apos;s file into the folder, so that the result can be verified from there</source>
        <translation>Legt eine Kopie der Projektdatei in den Ordner, damit sich das Ergebnis von dort aus nachprüfen lässt</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Shows the written files</source>
        <translation>Zeigt die geschriebenen Dateien</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>Geschrieben nach %1</translation>
    </message>
    <message>
        <source>Cancelled. Any change lays the sheets out again.</source>
        <translation>Abgebrochen. Jede Änderung setzt die Blätter neu.</translation>
    </message>
    <message>
        <source>Title block</source>
        <translation>Schriftfeld</translation>
    </message>
    <message>
        <source>Laying out the sheets</source>
        <translation>Die Blätter werden gesetzt</translation>
    </message>
    <message>
        <source> pixels high</source>
        <translation> Pixel hoch</translation>
    </message>
    <message>
        <source>Title, legend and scale bar</source>
        <translation>Titel, Legende und Maßstabsleiste</translation>
    </message>
    <message>
        <source>Around the view, within the size of the picture</source>
        <translation>Um die Ansicht herum, innerhalb der Größe des Bildes</translation>
    </message>
    <message>
        <source>Save project first...</source>
        <translation>Projekt zuerst speichern ...</translation>
    </message>
    <message>
        <source>A result can be verified only with the project that it comes from</source>
        <translation>Ein Ergebnis kann nur mit dem Projekt nachgeprüft werden, aus dem es stammt</translation>
    </message>
    <message>
        <source>The project has changes that are not saved: what is exported now cannot be verified.</source>
        <translation>Das Projekt hat ungespeicherte Änderungen: Was jetzt exportiert wird, kann nicht nachgeprüft werden.</translation>
    </message>
    <message>
        <source>The project is not saved: what is exported now cannot be verified.</source>
        <translation>Das Projekt ist nicht gespeichert: Was jetzt exportiert wird, kann nicht nachgeprüft werden.</translation>
    </message>
    <message>
        <source>Save project first</source>
        <translation>Projekt zuerst speichern</translation>
    </message>
    <message>
        <source>The name of the PDF with the sheets</source>
        <translation>Der Name der PDF-Datei mit den Blättern</translation>
    </message>
    <message>
        <source>Name of the sheets</source>
        <translation>Name der Blätter</translation>
    </message>
    <message>
        <source>Two of the files have one name: choose another for the sheets</source>
        <translation>Zwei der Dateien haben denselben Namen: Wählen Sie einen anderen für die Blätter</translation>
    </message>
    <message>
        <source>No sheets are written. Tick &quot;%1&quot; to see and write them.</source>
        <translation>Es werden keine Blätter geschrieben. Mit „%1“ sind sie zu sehen und werden geschrieben.</translation>
    </message>
    <message>
        <source>What is chosen has no sheets.</source>
        <translation>Was gewählt ist, hat keine Blätter.</translation>
    </message>
</context>
<context>
    <name>noonmark::ExtrudeHandle</name>
    <message>
        <source>Height: %1  (Enter)</source>
        <translation>Höhe: %1  (Eingabetaste)</translation>
    </message>
    <message>
        <source>Top above datum: %1  (Enter)</source>
        <translation>Oberkante über Bezugsniveau: %1  (Eingabe)</translation>
    </message>
</context>
<context>
    <name>noonmark::FaceForm</name>
    <message>
        <source>all faces</source>
        <translation>alle Flächen</translation>
    </message>
    <message>
        <source>Single faces of buildings, with commas between them, by the beginning of their points&apos; ids: way 12 wall 3. Empty: all faces</source>
        <translation>Einzelne Flächen von Gebäuden, durch Kommas getrennt, nach dem Anfang der Kennungen ihrer Punkte: way 12 wall 3. Leer: alle Flächen</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Click walls in the view: each click adds a face or removes it. Press again to end</source>
        <translation>Auf Wände in der Ansicht klicken: Jeder Klick fügt eine Fläche hinzu oder entfernt sie. Zum Beenden erneut drücken</translation>
    </message>
    <message>
        <source>any direction</source>
        <translation>jede Richtung</translation>
    </message>
    <message>
        <source>north ± 45°</source>
        <translation>Nord ± 45°</translation>
    </message>
    <message>
        <source>east ± 45°</source>
        <translation>Ost ± 45°</translation>
    </message>
    <message>
        <source>south ± 45°</source>
        <translation>Süd ± 45°</translation>
    </message>
    <message>
        <source>west ± 45°</source>
        <translation>West ± 45°</translation>
    </message>
    <message>
        <source>other azimuths</source>
        <translation>andere Azimute</translation>
    </message>
    <message>
        <source>Only faces, or windows, that face this direction from true north</source>
        <translation>Nur Flächen oder Fenster, die in diese Richtung weisen, von geografisch Nord aus</translation>
    </message>
    <message>
        <source>The first azimuth, clockwise from true north</source>
        <translation>Der erste Azimut, im Uhrzeigersinn von geografisch Nord</translation>
    </message>
    <message>
        <source>The last azimuth, clockwise from true north</source>
        <translation>Der letzte Azimut, im Uhrzeigersinn von geografisch Nord</translation>
    </message>
    <message>
        <source>Only points from which a level line straight out from the wall meets this place, as the windows along a park</source>
        <translation>Nur Punkte, von denen eine waagerechte Linie senkrecht zur Wand diesen Ort trifft, wie Fenster entlang eines Parks</translation>
    </message>
    <message>
        <source>How far away the place may be</source>
        <translation>Wie weit der Ort entfernt sein darf</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Looking at</source>
        <translation>Blick auf</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>faced place</source>
        <translation>gegenüberliegender Ort</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>azimuths</source>
        <translation>Azimute</translation>
    </message>
</context>
<context>
    <name>noonmark::FieldChoices</name>
    <message>
        <source>none is found by name</source>
        <translation>keines am Namen erkannt</translation>
    </message>
    <message>
        <source>found by name: %1</source>
        <translation>am Namen erkannt: %1</translation>
    </message>
    <message numerus="yes">
        <source>%1   %2 feature(s)</source>
        <translation>
            <numerusform>%1   %2 Objekt</numerusform>
            <numerusform>%1   %2 Objekte</numerusform>
        </translation>
    </message>
    <message>
        <source>Lists the fields with sample values</source>
        <translation>Listet die Felder mit Beispielwerten auf</translation>
    </message>
</context>
<context>
    <name>noonmark::FieldHelp</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>More in the guide (F1)</source>
        <translation>Mehr im Handbuch (F1)</translation>
    </message>
</context>
<context>
    <name>noonmark::Filming</name>
    <message>
        <source>computing the frames of the movie</source>
        <translation>berechnet die Bilder des Films</translation>
    </message>
    <message>
        <source>writing the movie</source>
        <translation>schreibt den Film</translation>
    </message>
</context>
<context>
    <name>noonmark::FramePainter</name>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>Auftraggeber</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Verfasser</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>sheet %1 of %2</source>
        <translation>Blatt %1 von %2</translation>
    </message>
</context>
<context>
    <name>noonmark::FurtherTable</name>
    <message>
        <source>Add tower</source>
        <translation>Turm hinzufügen</translation>
    </message>
    <message>
        <source>Another tower on the lot, apart from the others: each has a piece of it</source>
        <translation>Ein weiterer Turm auf dem Grundstück, getrennt von den anderen: jeder hat einen Teil davon</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the selected tower, or the last one</source>
        <translation>Entfernt den gewählten Turm oder den letzten</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>Geschosse</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Geschossplatte</translation>
    </message>
    <message>
        <source>Further towers, which the same step builds; the lot is divided across its longest side</source>
        <translation>Weitere Türme, die derselbe Schritt baut; das Grundstück wird quer zu seiner längsten Seite geteilt</translation>
    </message>
</context>
<context>
    <name>noonmark::GlazingForm</name>
    <message>
        <source>Facades, bay by bay</source>
        <translation>Fassaden, Achse für Achse</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>Aus einer Datei</translation>
    </message>
    <message>
        <source>A file of points or polygons with heights gives the real windows</source>
        <translation>Eine Datei mit Punkten oder Polygonen mit Höhen gibt die wirklichen Fenster an</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Fenster</translation>
    </message>
</context>
<context>
    <name>noonmark::GlazingPanel</name>
    <message>
        <source>Verdicts after</source>
        <translation>Befunde nachher</translation>
    </message>
    <message>
        <source>Verdicts before</source>
        <translation>Befunde vorher</translation>
    </message>
    <message>
        <source>Changed verdicts</source>
        <translation>Geänderte Befunde</translation>
    </message>
    <message>
        <source>No verdicts</source>
        <translation>Keine Befunde</translation>
    </message>
    <message>
        <source>What the 3D view shows on the walls: a tile for each window in the colour of its verdict.
A click on a tile selects its row, a click on a row frames its window.</source>
        <translation>Was die 3D-Ansicht auf den Wänden zeigt: eine Kachel je Fenster in der Farbe seines Befunds.
Ein Klick auf eine Kachel wählt ihre Zeile, ein Klick auf eine Zeile zeigt ihr Fenster.</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>In der Ansicht</translation>
    </message>
</context>
<context>
    <name>noonmark::GlazingSession</name>
    <message>
        <source>Review</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Not up to date. %1</source>
        <translation>Nicht aktuell. %1</translation>
    </message>
    <message>
        <source>Not up to date: buildings, windows or the rule have changed. Run again.</source>
        <translation>Nicht aktuell: Gebäude, Fenster oder die Regel haben sich geändert. Erneut ausführen.</translation>
    </message>
    <message>
        <source>Estimating</source>
        <translation>Zeit wird geschätzt</translation>
    </message>
    <message>
        <source>All reviews</source>
        <translation>Alle Prüfungen</translation>
    </message>
</context>
<context>
    <name>noonmark::GlazingTable</name>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Geschoss</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Gebäude</translation>
    </message>
    <message>
        <source>%1, before</source>
        <translation>%1, vorher</translation>
    </message>
    <message>
        <source>%1, after</source>
        <translation>%1, nachher</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Sun on %1: %2; before: %3.</source>
        <translation>Sonne am %1: %2; vorher: %3.</translation>
    </message>
</context>
<context>
    <name>noonmark::GuideWindow</name>
    <message>
        <source>User guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>Lists the pages with these words; Enter goes to the next place</source>
        <translation>Listet die Seiten mit diesen Wörtern auf; Eingabe geht zur nächsten Stelle</translation>
    </message>
    <message>
        <source>Pages of the guide</source>
        <translation>Seiten des Handbuchs</translation>
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
        <translation>Nach Höhen&amp;quelle färben</translation>
    </message>
    <message>
        <source>Buildings whose height is measured, computed from storeys or assumed</source>
        <translation>Gebäude, deren Höhe gemessen, aus Geschossen berechnet oder angenommen ist</translation>
    </message>
</context>
<context>
    <name>noonmark::HelpActions</name>
    <message>
        <source>User &amp;guide</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>The guide, at the page about the panel in use</source>
        <translation>Das Handbuch, auf der Seite zum benutzten Feld</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>&amp;Startseite</translation>
    </message>
    <message>
        <source>&amp;About Noonmark</source>
        <translation>&amp;Über Noonmark</translation>
    </message>
    <message>
        <source>Version, libraries and processor</source>
        <translation>Version, Bibliotheken und Prozessor</translation>
    </message>
    <message>
        <source>About Noonmark</source>
        <translation>Über Noonmark</translation>
    </message>
    <message>
        <source>&amp;What&apos;s this?</source>
        <translation>&amp;Was ist das?</translation>
    </message>
    <message>
        <source>Explains the field that is clicked next; in a field, Shift+F1</source>
        <translation>Erklärt das nächste angeklickte Feld</translation>
    </message>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>&amp;Maus und Tasten</translation>
    </message>
    <message>
        <source>All keys and what the mouse does, as a table</source>
        <translation>Alle Tasten und was die Maus tut, als Tabelle</translation>
    </message>
    <message>
        <source>Recent projects, samples and questions</source>
        <translation>Zuletzt geöffnete Projekte, Beispiele und Fragen</translation>
    </message>
    <message>
        <source>Ctrl+F1</source>
        <translation>Ctrl+F1</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>What do you want to know of this city?</source>
        <translation>Was möchten Sie über diese Stadt wissen?</translation>
    </message>
</context>
<context>
    <name>noonmark::HorizonCache</name>
    <message>
        <source>sweeping horizons</source>
        <translation>sucht Horizonte</translation>
    </message>
</context>
<context>
    <name>noonmark::HoursOf</name>
    <message>
        <source>Hours of sun a day by month</source>
        <translation>Sonnenstunden am Tag nach Monat</translation>
    </message>
</context>
<context>
    <name>noonmark::KeySheet</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>Find a key or what it does</source>
        <translation>Eine Taste suchen oder was sie tut</translation>
    </message>
    <message>
        <source>Shows the rows that contain these words</source>
        <translation>Zeigt die Zeilen, die diese Wörter enthalten</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Keys, mouse</source>
        <translation>Tasten, Maus</translation>
    </message>
</context>
<context>
    <name>noonmark::LatestAnswers</name>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>All scores</source>
        <translation>Alle Bewertungen</translation>
    </message>
    <message>
        <source>Reading saved results</source>
        <translation>Gespeicherte Ergebnisse werden gelesen</translation>
    </message>
    <message>
        <source>Comparing buildings</source>
        <translation>Gebäude werden verglichen</translation>
    </message>
</context>
<context>
    <name>noonmark::LegendEditor</name>
    <message>
        <source>%1 (not for colour-blind readers)</source>
        <translation>%1 (nicht bei Farbenfehlsichtigkeit)</translation>
    </message>
    <message>
        <source>Minutes in shadow, hours of sun (the sunlit time minus gross shadow), or the share of the sunlit time in the sun.
Continuous shadow stays in minutes: the longest run in the sun does not follow from it.</source>
        <translation>Minuten im Schatten, Sonnenstunden (die besonnte Zeit minus Gesamtschatten) oder der Anteil der besonnten Zeit in der Sonne.
Dauerschatten bleibt in Minuten: Die längste Sonne ohne Unterbrechung folgt nicht daraus.</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Equal classes</source>
        <translation>Gleiche Klassen</translation>
    </message>
    <message>
        <source>Quantiles: as many cells in each</source>
        <translation>Quantile: gleich viele Zellen in jeder</translation>
    </message>
    <message>
        <source>Typed numbers, or one threshold</source>
        <translation>Eingegebene Zahlen oder eine Schwelle</translation>
    </message>
    <message>
        <source>Re&amp;versed</source>
        <translation>&amp;Umgekehrt</translation>
    </message>
    <message>
        <source>&amp;Locked</source>
        <translation>&amp;Fixiert</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>angepasst</translation>
    </message>
    <message>
        <source>Values at the ends, in the unit shown, such as 0:8</source>
        <translation>Werte an den Enden, in der gezeigten Einheit, etwa 0:8</translation>
    </message>
    <message>
        <source>Numbers between the classes, ascending, in the unit shown. One number is a threshold: two colours</source>
        <translation>Zahlen zwischen den Klassen, aufsteigend, in der gezeigten Einheit. Eine einzelne Zahl ist eine Schwelle: zwei Farben</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Keep the range of this map for all others; unlocked, each map has its own.</source>
        <translation>Den Bereich dieser Karte für alle anderen behalten; nicht fixiert hat jede Karte ihren eigenen.</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Anzeigen</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>F&amp;arben</translation>
    </message>
    <message>
        <source>&amp;Range</source>
        <translation>&amp;Bereich</translation>
    </message>
    <message>
        <source>Cla&amp;sses</source>
        <translation>&amp;Klassen</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>&amp;Zahlen</translation>
    </message>
    <message>
        <source>Not two numbers like 0:8, or not ascending numbers like 2,4,6</source>
        <translation>Keine zwei Zahlen wie 0:8 oder keine aufsteigenden Zahlen wie 2,4,6</translation>
    </message>
    <message>
        <source>Colours from much sun to much shadow; of differences and scores those around a pale middle</source>
        <translation>Farben von viel Sonne zu viel Schatten; bei Unterschieden und Bewertungen die um eine blasse Mitte</translation>
    </message>
    <message>
        <source>%1 (safe for colour-blind readers)</source>
        <translation>%1 (für Farbenblinde geeignet)</translation>
    </message>
    <message>
        <source>What is shown has fixed colours: there is nothing to choose</source>
        <translation>Was gezeigt wird, hat feste Farben: es gibt nichts zu wählen</translation>
    </message>
    <message>
        <source>A difference has its range beside the legend; a score is fitted</source>
        <translation>Ein Unterschied hat seinen Bereich neben der Legende; eine Bewertung wird angepasst</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>By the threshold of the panel Places</source>
        <translation>Nach der Schwelle des Felds Orte</translation>
    </message>
    <message>
        <source>Range and numbers are hours of sun a day</source>
        <translation>Bereich und Zahlen sind Sonnenstunden am Tag</translation>
    </message>
    <message>
        <source>Range and numbers are hours of sun a day: switch to Sun to change them</source>
        <translation>Bereich und Zahlen sind Sonnenstunden am Tag: Zum Ändern auf Sonne umschalten</translation>
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
        <translation>Die Enden der Farbskala einer Differenz.
Feststellen, um Bilder mehrerer Entwürfe zu vergleichen; 0: automatisch, jeder Differenz angepasst.</translation>
    </message>
    <message>
        <source>What is displayed.
Gross shadow: minutes in shadow per day, mean over the days.
Continuous shadow: longest unbroken run in shadow on any day, minutes.</source>
        <translation>Was gezeigt wird.
Gesamtschatten: Minuten im Schatten am Tag, Mittel über die Tage.
Dauerschatten: längster ununterbrochener Schatten eines Tages, Minuten.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Show minutes in shadow</source>
        <translation>Minuten im Schatten zeigen</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>Show hours of sun a day: the sunlit time minus gross shadow, on maps, legends and what is exported.
Continuous shadow stays as it is: the longest run in the sun does not follow from it.</source>
        <translation>Sonnenstunden am Tag zeigen: die besonnte Zeit minus Gesamtschatten, auf Karten, in Legenden und in Exporten.
Dauerschatten bleibt, wie er ist: Die längste Sonne ohne Unterbrechung folgt nicht daraus.</translation>
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
        <translation>wirft Schatten</translation>
    </message>
</context>
<context>
    <name>noonmark::LineForm</name>
    <message>
        <source>Parcel</source>
        <translation>Flurstück</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>lot or file</source>
        <translation>Grundstück oder Datei</translation>
    </message>
    <message>
        <source>The parcel that the lines run around: a lot, region or place of the project by its name, or the path of a polygon file</source>
        <translation>Das Flurstück, um das die Linien verlaufen: ein Baugrundstück, Gebiet oder Ort des Projekts mit Namen, oder der Pfad einer Polygondatei</translation>
    </message>
    <message>
        <source>Distance from point to point on a line</source>
        <translation>Abstand von Punkt zu Punkt auf einer Linie</translation>
    </message>
    <message>
        <source>parcel</source>
        <translation>Flurstück</translation>
    </message>
    <message>
        <source>spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Distances of the lines from the parcel, with commas: 5, 10</source>
        <translation>Abstände der Linien vom Flurstück, mit Kommas: 5, 10</translation>
    </message>
</context>
<context>
    <name>noonmark::LiveFacades</name>
    <message>
        <source>Live facades</source>
        <translation>Mitlaufende Fassaden</translation>
    </message>
</context>
<context>
    <name>noonmark::LiveFollower</name>
    <message>
        <source>Live shadow</source>
        <translation>Mitlaufender Schatten</translation>
    </message>
</context>
<context>
    <name>noonmark::LotEditing</name>
    <message>
        <source>add a corner to %1</source>
        <translation>eine Ecke an %1 hinzufügen</translation>
    </message>
    <message>
        <source>move a corner of %1</source>
        <translation>eine Ecke von %1 verschieben</translation>
    </message>
    <message>
        <source>move a side of %1</source>
        <translation>eine Seite von %1 verschieben</translation>
    </message>
    <message>
        <source>remove a corner of %1</source>
        <translation>eine Ecke von %1 entfernen</translation>
    </message>
</context>
<context>
    <name>noonmark::LotRoadsDialog</name>
    <message>
        <source>North</source>
        <translation>Norden</translation>
    </message>
    <message>
        <source>Northeast</source>
        <translation>Nordosten</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Osten</translation>
    </message>
    <message>
        <source>Southeast</source>
        <translation>Südosten</translation>
    </message>
    <message>
        <source>South</source>
        <translation>Süden</translation>
    </message>
    <message>
        <source>Southwest</source>
        <translation>Südwesten</translation>
    </message>
    <message>
        <source>West</source>
        <translation>Westen</translation>
    </message>
    <message>
        <source>Northwest</source>
        <translation>Nordwesten</translation>
    </message>
    <message>
        <source>no road</source>
        <translation>keine Straße</translation>
    </message>
    <message>
        <source>Roads along %1</source>
        <translation>Straßen an %1</translation>
    </message>
    <message>
        <source>How wide are the roads, water or railways on each side? Rules about parcels, as in Japan, move the parcel&apos;s line out along them. A side counts for the outermost edges that face within 45 degrees of it.</source>
        <translation>Wie breit sind Straßen, Wasser oder Gleise auf jeder Seite? Regeln über Parzellen, wie in Japan, rücken die Parzellengrenze an ihnen nach außen. Eine Seite gilt für die äußersten Kanten, die bis auf 45 Grad zu ihr zeigen.</translation>
    </message>
</context>
<context>
    <name>noonmark::MainWindow</name>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>as in the paper</source>
        <translation>wie im Artikel</translation>
    </message>
    <message>
        <source>Choose a scenario at the top first. A change to a building begins one: click a building, and drag its arrow or replace it by a tower (Ctrl+T).</source>
        <translation>Erst oben ein Szenario wählen. Eine Änderung an einem Gebäude beginnt eines: ein Gebäude anklicken und an seinem Pfeil ziehen oder es durch einen Turm ersetzen (Strg+T).</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>%1[*] - Noonmark</source>
        <translation>%1[*] - Noonmark</translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation>Wie im Artikel</translation>
    </message>
    <message>
        <source>receivers</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Time and legend</source>
        <translation>Zeit und Legende</translation>
    </message>
    <message>
        <source>The answer is being computed</source>
        <translation>Die Antwort wird berechnet</translation>
    </message>
    <message>
        <source>Now by shadow accrual maps, studies by inverse accrual maps through the direction graph.
Approximate: the legend states the measured error. Verdicts of reviews stay exact</source>
        <translation>Jetzt mit Schattenakkumulationskarten, Studien mit inversen Akkumulationskarten über den Richtungsgraphen.
Näherung: Die Legende nennt den gemessenen Fehler. Urteile von Prüfungen bleiben exakt</translation>
    </message>
    <message>
        <source>not as in the paper</source>
        <translation>nicht wie im Artikel</translation>
    </message>
</context>
<context>
    <name>noonmark::MapLayer</name>
    <message>
        <source>Painting the map</source>
        <translation>Die Karte wird gezeichnet</translation>
    </message>
</context>
<context>
    <name>noonmark::MaskRun</name>
    <message>
        <source>filling shadows of places</source>
        <translation>füllt Schatten der Orte</translation>
    </message>
</context>
<context>
    <name>noonmark::MassingForm</name>
    <message>
        <source>Podium</source>
        <translation>Sockel</translation>
    </message>
    <message>
        <source>One storey to %1; or drag the arrow on the tower, or type a number over the view</source>
        <translation>Von einem Geschoss bis %1; oder am Pfeil des Turms ziehen oder eine Zahl über der Ansicht tippen</translation>
    </message>
    <message>
        <source>Fewer than all storeys</source>
        <translation>Weniger als alle Geschosse</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>Geschosse</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Geschossplatte</translation>
    </message>
    <message>
        <source>Floor plate</source>
        <translation>Geschossplatte</translation>
    </message>
    <message>
        <source>Taper, twist</source>
        <translation>Verjüngung, Verdrehung</translation>
    </message>
    <message>
        <source>Top above datum</source>
        <translation>Oberkante über Bezugsniveau</translation>
    </message>
    <message>
        <source>Height above ground</source>
        <translation>Höhe über Gelände</translation>
    </message>
    <message>
        <source>Turn, taper, twist</source>
        <translation>Drehen, verjüngen, verdrehen</translation>
    </message>
</context>
<context>
    <name>noonmark::MassingPanel</name>
    <message>
        <source>Name and id of the new building</source>
        <translation>Name und Id des neuen Gebäudes</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Design tower</source>
        <translation>Turm entwerfen</translation>
    </message>
    <message>
        <source>Designs a tower on this lot; building it demolishes the buildings on the lot</source>
        <translation>Entwirft einen Turm auf diesem Grundstück; beim Bauen werden die Gebäude darauf abgerissen</translation>
    </message>
    <message>
        <source>Draw lot</source>
        <translation>Grundstück zeichnen</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Bauen</translation>
    </message>
    <message>
        <source>Adds the tower to the scenario, as one undo step (Enter over the view)</source>
        <translation>Fügt den Turm dem Szenario hinzu, als ein Schritt (Eingabe über der Ansicht)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Leaves the scenario unchanged (Esc over the view)</source>
        <translation>Lässt das Szenario unverändert (Esc über der Ansicht)</translation>
    </message>
    <message>
        <source>No lots yet: draw one</source>
        <translation>Noch keine Grundstücke: eines zeichnen</translation>
    </message>
    <message>
        <source>Copy tower here</source>
        <translation>Turm hierher kopieren</translation>
    </message>
    <message>
        <source>Sets the tower that is selected or being designed on this lot too, with its storeys, plate areas and setbacks, turned as the lot is</source>
        <translation>Setzt den gewählten oder gerade entworfenen Turm auch auf dieses Grundstück, mit seinen Geschossen, Geschossflächen und Rücksprüngen, gedreht wie das Grundstück</translation>
    </message>
    <message>
        <source>Sunlight of its facades</source>
        <translation>Besonnung der Fassaden</translation>
    </message>
    <message>
        <source>Shows the hours of shadow on the tower&apos;s facades, coarsely while it changes. Click other buildings in the view to see their facades too. Bays and storeys are those of the study&apos;s form.</source>
        <translation>Zeigt die Schattenstunden an den Fassaden des Turms, grob, während er sich ändert. Klicken Sie in der Ansicht auf andere Gebäude, um auch deren Fassaden zu sehen. Achsen und Geschosse sind die des Studienformulars.</translation>
    </message>
    <message>
        <source>Change of shadow</source>
        <translation>Änderung des Schattens</translation>
    </message>
    <message>
        <source>Shows where the tower adds shadow to the baseline, or takes it away, instead of all shadow with it. A pin marks the worst spot.</source>
        <translation>Zeigt, wo der Turm der Ausgangslage Schatten hinzufügt oder wegnimmt, statt des gesamten Schattens mit ihm. Eine Nadel zeigt die am stärksten betroffene Stelle.</translation>
    </message>
    <message>
        <source>Edit lot</source>
        <translation>Grundstück bearbeiten</translation>
    </message>
    <message>
        <source>Shows the lot&apos;s corners and sides as handles that are dragged.
A click on the middle of a side adds a corner, Delete removes the selected one.</source>
        <translation>Zeigt Ecken und Seiten des Grundstücks als Griffe zum Ziehen.
Ein Klick auf die Mitte einer Seite fügt eine Ecke hinzu, Entf entfernt die gewählte.</translation>
    </message>
    <message>
        <source>Click corners on the ground (Shift: at right angles to the last side; Ctrl: without snapping),
or type the length of a side and press Enter.
Double click, Enter or right click finishes, Backspace removes the last corner.</source>
        <translation>Ecken auf dem Boden anklicken (Umschalt: rechtwinklig zur letzten Seite; Strg: ohne Einrasten)
oder die Länge einer Seite eingeben und Eingabe drücken.
Doppelklick, Eingabe oder Rechtsklick beendet, die Rücktaste entfernt die letzte Ecke.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Edit tower</source>
        <translation>Turm bearbeiten</translation>
    </message>
    <message>
        <source>Designs the tower on this lot further, with the values it was built with</source>
        <translation>Entwirft den Turm auf diesem Grundstück weiter, mit den Werten, mit denen er gebaut wurde</translation>
    </message>
    <message>
        <source>Takes the nearest value with which the tower can be built</source>
        <translation>Nimmt den nächsten Wert, mit dem der Turm gebaut werden kann</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1 nehmen</translation>
    </message>
    <message>
        <source>Draw a lot on the ground, or click a building and make a lot from its footprint. Ctrl+T replaces the building that is selected by a tower.</source>
        <translation>Zeichnen Sie ein Grundstück auf den Boden, oder klicken Sie auf ein Gebäude und machen Sie aus seinem Grundriss ein Grundstück. Strg+T ersetzt das gewählte Gebäude durch einen Turm.</translation>
    </message>
    <message>
        <source>The project&apos;s lots, and those of buildings that towers have replaced</source>
        <translation>Die Grundstücke des Projekts und die von Gebäuden, die Türme ersetzt haben</translation>
    </message>
    <message>
        <source>A part of the tower stands outside the study&apos;s region, which alone is measured.</source>
        <translation>Ein Teil des Turms steht außerhalb des Untersuchungsgebiets; nur dort wird gemessen.</translation>
    </message>
    <message>
        <source>The tower stands outside the study&apos;s region, which alone is measured.</source>
        <translation>Der Turm steht außerhalb des Untersuchungsgebiets; nur dort wird gemessen.</translation>
    </message>
    <message>
        <source>Move the region here</source>
        <translation>Untersuchungsgebiet hierher verschieben</translation>
    </message>
    <message>
        <source>Studies, comparisons and exports then measure the ground around the tower</source>
        <translation>Studien, Vergleiche und Exporte messen dann den Boden um den Turm</translation>
    </message>
</context>
<context>
    <name>noonmark::MassingPreview</name>
    <message>
        <source>Reading the files...</source>
        <translation>Die Dateien werden gelesen ...</translation>
    </message>
    <message>
        <source>The files hold no buildings.</source>
        <translation>Die Dateien enthalten keine Gebäude.</translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s); heights: %2.
Lowest %3, median %4, tallest %5.</source>
        <translation>
            <numerusform>%1 Gebäude; Höhen: %2.
Niedrigstes %3, Median %4, höchstes %5.</numerusform>
            <numerusform>%1 Gebäude; Höhen: %2.
Niedrigstes %3, Median %4, höchstes %5.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 below the ground</source>
        <translation>%1 unter dem Boden</translation>
    </message>
</context>
<context>
    <name>noonmark::MeshPlacing</name>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 einfügen</translation>
    </message>
</context>
<context>
    <name>noonmark::MessageBar</name>
    <message>
        <source>Shows or hides the other lines of this message</source>
        <translation>Zeigt oder verbirgt die weiteren Zeilen dieser Meldung</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>Weniger</translation>
    </message>
    <message numerus="yes">
        <source>%1 more line(s)</source>
        <translation>
            <numerusform>%1 weitere Zeile</numerusform>
            <numerusform>%1 weitere Zeilen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::MomentPreview</name>
    <message>
        <source>Computing %1</source>
        <translation>%1 wird berechnet</translation>
    </message>
</context>
<context>
    <name>noonmark::MovieActions</name>
    <message>
        <source>Export &amp;movie...</source>
        <translation>&amp;Film exportieren ...</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>The shadows of a day, of a year, or of the change by a scenario, as MP4 or GIF</source>
        <translation>Die Schatten eines Tages, eines Jahres oder der Änderung durch ein Szenario, als MP4 oder GIF</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 verglichen mit %2</translation>
    </message>
    <message>
        <source>Shadow: %1</source>
        <translation>Schatten: %1</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>Film</translation>
    </message>
    <message numerus="yes">
        <source>Movie of %1 frame(s) saved as %2</source>
        <translation>
            <numerusform>Film mit %1 Bild gespeichert als %2</numerusform>
            <numerusform>Film mit %1 Bildern gespeichert als %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Filming the view</source>
        <translation>Die Ansicht wird gefilmt</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
</context>
<context>
    <name>noonmark::MovieDialog</name>
    <message>
        <source>Export movie</source>
        <translation>Film exportieren</translation>
    </message>
    <message>
        <source>What changes from frame to frame</source>
        <translation>Was sich von Bild zu Bild ändert</translation>
    </message>
    <message>
        <source>Shadows of one day</source>
        <translation>Schatten eines Tages</translation>
    </message>
    <message>
        <source>Shadows at one time through the year</source>
        <translation>Schatten zu einer Uhrzeit durch das Jahr</translation>
    </message>
    <message>
        <source>From baseline to scenario</source>
        <translation>Von der Ausgangslage zum Szenario</translation>
    </message>
    <message>
        <source> min of the day in each frame</source>
        <translation> min des Tages je Bild</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Uhrzeit</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>What changes and what its shadows reach, or the places</source>
        <translation>Was sich ändert und wohin seine Schatten reichen, oder die Orte</translation>
    </message>
    <message>
        <source>The region of the study</source>
        <translation>Das Gebiet der Untersuchung</translation>
    </message>
    <message>
        <source>Small pictures make small files, which matters for GIF</source>
        <translation>Kleine Bilder ergeben kleine Dateien, was bei GIF zählt</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message>
        <source> frames per second</source>
        <translation> Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportieren ...</translation>
    </message>
    <message>
        <source>Asks for a file: MP4 for players, GIF for pages and mail</source>
        <translation>Fragt nach einer Datei: MP4 für Abspielprogramme, GIF für Seiten und E-Mail</translation>
    </message>
    <message>
        <source>Shadows at one time through the period</source>
        <translation>Schatten zu einer Uhrzeit durch den Zeitraum</translation>
    </message>
    <message>
        <source>What all frames show: a map, or the view from where its camera stands</source>
        <translation>Was alle Bilder zeigen: eine Karte oder die Ansicht vom Standort ihrer Kamera</translation>
    </message>
    <message>
        <source>The ground that the view shows</source>
        <translation>Der Boden, den die Ansicht zeigt</translation>
    </message>
    <message>
        <source>The view in 3D, as it is shown</source>
        <translation>Die Ansicht in 3D, wie sie gezeigt wird</translation>
    </message>
</context>
<context>
    <name>noonmark::OpenOptions</name>
    <message>
        <source>Open with options</source>
        <translation>Mit Optionen öffnen</translation>
    </message>
    <message>
        <source>Read the files with these settings</source>
        <translation>Die Dateien mit diesen Einstellungen lesen</translation>
    </message>
    <message>
        <source>Add terrain or surface model...</source>
        <translation>Gelände oder Oberflächenmodell hinzufügen ...</translation>
    </message>
    <message>
        <source>Reads elevations together with the buildings. Of a surface model and a terrain, missing heights are the difference.</source>
        <translation>Liest Höhenlagen zusammen mit den Gebäuden ein. Mit Oberflächenmodell und Gelände ergeben sich fehlende Höhen aus der Differenz.</translation>
    </message>
    <message>
        <source>Listing fields</source>
        <translation>Felder werden aufgelistet</translation>
    </message>
    <message>
        <source>Reading for the preview</source>
        <translation>Vorschau wird gelesen</translation>
    </message>
</context>
<context>
    <name>noonmark::OpeningActions</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;New project from a city...</source>
        <translation>&amp;Neues Projekt aus einer Stadt ...</translation>
    </message>
    <message>
        <source>Footprints, CityJSON, meshes, terrain; several files are combined into one city</source>
        <translation>Grundrisse, CityJSON, 3D-Modelle, Gelände; mehrere Dateien werden zu einer Stadt verbunden</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Öffnen ...</translation>
    </message>
    <message>
        <source>A project, or city files, from which a new project is created</source>
        <translation>Ein Projekt, oder Stadtdateien, aus denen ein neues Projekt entsteht</translation>
    </message>
    <message>
        <source>Open &amp;with options...</source>
        <translation>Mit O&amp;ptionen öffnen ...</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>For files without location, unit or heights</source>
        <translation>Für Dateien ohne Lage, Einheit oder Höhen</translation>
    </message>
    <message>
        <source>&amp;Central Park South</source>
        <translation>&amp;Central Park South</translation>
    </message>
    <message>
        <source>The park, its streets and the towers of the case study</source>
        <translation>Der Park, seine Straßen und die Türme der Fallstudie</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Raster</translation>
    </message>
    <message>
        <source>A synthetic city of blocks and lots</source>
        <translation>Eine synthetische Stadt aus Blöcken und Grundstücken</translation>
    </message>
    <message>
        <source>The time zone %1 is a guess; %2 is also nearby.</source>
        <translation>Die Zeitzone %1 ist geraten; auch %2 liegt nahe.</translation>
    </message>
    <message>
        <source>Open with options...</source>
        <translation>Mit Optionen öffnen ...</translation>
    </message>
    <message>
        <source>Open samp&amp;le</source>
        <translation>Beispie&amp;l öffnen</translation>
    </message>
    <message>
        <source>%1 is a terrain: it holds no buildings.</source>
        <translation>%1 ist ein Gelände und enthält keine Gebäude.</translation>
    </message>
    <message>
        <source>Add to the city</source>
        <translation>Zur Stadt hinzufügen</translation>
    </message>
    <message>
        <source>Open alone</source>
        <translation>Allein öffnen</translation>
    </message>
    <message numerus="yes">
        <source>%1 far building(s) left out of the first view.</source>
        <translation>
            <numerusform>%1 fernes Gebäude bleibt außer Acht.</numerusform>
            <numerusform>%1 ferne Gebäude bleiben außer Acht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Zoom to all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Open a folder of city files</source>
        <translation>Einen Ordner mit Stadtdateien öffnen</translation>
    </message>
    <message numerus="yes">
        <source>%1 terrain(s) in the folder are not in the city: %2.</source>
        <translation>
            <numerusform>%1 Gelände im Ordner ist nicht in der Stadt: %2.</numerusform>
            <numerusform>%1 Gelände im Ordner sind nicht in der Stadt: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Add terrain</source>
        <translation>Gelände hinzufügen</translation>
    </message>
    <message>
        <source>Changed in reading: %1</source>
        <translation>Beim Lesen geändert: %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
</context>
<context>
    <name>noonmark::OtherScenario</name>
    <message>
        <source>Showing %1</source>
        <translation>%1 wird gezeigt</translation>
    </message>
</context>
<context>
    <name>noonmark::PeriodForm</name>
    <message>
        <source>From sunrise to sunset</source>
        <translation>Sonnenauf- bis -untergang</translation>
    </message>
    <message>
        <source>Time zone and sun</source>
        <translation>Zeitzone und Sonne</translation>
    </message>
    <message>
        <source>First day of the period, local date in the time zone</source>
        <translation>Erster Tag des Zeitraums, Datum in der Zeitzone</translation>
    </message>
    <message>
        <source>IANA time zone of the wall clock, daylight saving included.
Set to that of the nearest city when a file is opened: check it near borders.</source>
        <translation>IANA-Zeitzone der Uhrzeit, mit Sommerzeit.
Beim Öffnen einer Datei die der nächsten Stadt: nahe Grenzen prüfen.</translation>
    </message>
    <message>
        <source>Use sunrise and sunset instead of clock times</source>
        <translation>Sonnenauf- und -untergang statt Uhrzeiten verwenden</translation>
    </message>
    <message>
        <source>On: the air lifts the sun a little near the horizon (refraction).
Off: the sun&apos;s geometric position, as some rules require</source>
        <translation>Ein: die Luft hebt die Sonne nahe dem Horizont ein wenig (Refraktion).
Aus: die geometrische Lage der Sonne, wie manche Regeln sie verlangen</translation>
    </message>
    <message>
        <source>Wall-clock time at which each day&apos;s hours begin, hours:minutes</source>
        <translation>Uhrzeit, zu der die Stunden jedes Tages beginnen, Stunden:Minuten</translation>
    </message>
</context>
<context>
    <name>noonmark::PeriodSweep</name>
    <message>
        <source>sweeping horizons</source>
        <translation>sucht Horizonte</translation>
    </message>
</context>
<context>
    <name>noonmark::PhotographActions</name>
    <message>
        <source>Aer&amp;ial photograph...</source>
        <translation>Luf&amp;tbild ...</translation>
    </message>
    <message>
        <source>An orthophoto or a scanned map with its position, drawn on the ground of the view, on maps and on sheets</source>
        <translation>Ein Orthofoto oder eine gescannte Karte mit ihrer Lage, gezeichnet auf dem Boden der Ansicht, auf Karten und Blättern</translation>
    </message>
    <message>
        <source>Aerial photo&amp;graph</source>
        <translation>Luftb&amp;ild</translation>
    </message>
    <message>
        <source>Shows or hides the aerial photograph</source>
        <translation>Zeigt oder verbirgt das Luftbild</translation>
    </message>
    <message>
        <source>Reading the photograph</source>
        <translation>Luftbild wird gelesen</translation>
    </message>
    <message>
        <source>aerial photograph</source>
        <translation>Luftbild</translation>
    </message>
    <message>
        <source>remove aerial photograph</source>
        <translation>Luftbild entfernen</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 tile(s) are missing and stay empty</source>
        <translation>
            <numerusform>%1 von %2 Kachel fehlt und bleibt leer</numerusform>
            <numerusform>%1 von %2 Kacheln fehlen und bleiben leer</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::PhotographDialog</name>
    <message>
        <source>Draw it</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Aerial photograph</source>
        <translation>Luftbild</translation>
    </message>
    <message>
        <source>(c) owner of the photograph, year</source>
        <translation>(c) Eigentümer des Bildes, Jahr</translation>
    </message>
    <message>
        <source>Whose photograph it is; printed on maps, sheets and pictures that show it</source>
        <translation>Wem das Bild gehört; gedruckt auf Karten, Blättern und Bildern, die es zeigen</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How much it covers streets, parks and water below it</source>
        <translation>Wie stark es Straßen, Parks und Wasser darunter überdeckt</translation>
    </message>
    <message>
        <source>On the ground of the view, on maps and on sheets</source>
        <translation>Auf dem Boden der Ansicht, auf Karten und Blättern</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Attribution</source>
        <translation>Quellenangabe</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Choose file...</source>
        <translation>Datei wählen ...</translation>
    </message>
    <message>
        <source>A GeoTIFF or Erdas Imagine file with its position, of 8 bits per colour</source>
        <translation>Ein GeoTIFF oder eine Erdas-Imagine-Datei mit Lage, 8 Bit je Farbe</translation>
    </message>
    <message>
        <source>From tiles...</source>
        <translation>Aus Kacheln ...</translation>
    </message>
    <message>
        <source>Fetches tiles of the web&apos;s map scheme from an address that you state</source>
        <translation>Holt Kacheln des Web-Kartenschemas von einer Adresse, die Sie angeben</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Takes the photograph out of the project; its file stays</source>
        <translation>Nimmt das Luftbild aus dem Projekt; seine Datei bleibt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceActions</name>
    <message>
        <source>Read &amp;places...</source>
        <translation>&amp;Orte einlesen ...</translation>
    </message>
    <message>
        <source>Parks, playgrounds, school grounds... from OpenStreetMap or any file of polygons</source>
        <translation>Parks, Spielplätze, Schulhöfe ... aus OpenStreetMap oder einer Datei mit Polygonen</translation>
    </message>
    <message>
        <source>Draw p&amp;lace</source>
        <translation>Or&amp;t zeichnen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>Click corners on the ground; Enter finishes, Esc cancels</source>
        <translation>Ecken auf dem Boden anklicken; Eingabe beendet, Esc bricht ab</translation>
    </message>
    <message>
        <source>Creates a place from the selected building&apos;s outline</source>
        <translation>Legt aus dem Umriss des ausgewählten Gebäudes einen Ort an</translation>
    </message>
    <message>
        <source>P&amp;laces</source>
        <translation>O&amp;rte</translation>
    </message>
    <message>
        <source>Reading places</source>
        <translation>Orte werden gelesen</translation>
    </message>
    <message>
        <source>read places</source>
        <translation>Orte einlesen</translation>
    </message>
    <message>
        <source>draw place</source>
        <translation>Ort zeichnen</translation>
    </message>
    <message>
        <source>place from building</source>
        <translation>Ort aus Gebäude</translation>
    </message>
    <message>
        <source>Place from b&amp;uilding outline</source>
        <translation>Ort aus Gebäudeu&amp;mriss</translation>
    </message>
    <message>
        <source>Read s&amp;treets</source>
        <translation>Straßen einlesen</translation>
    </message>
    <message>
        <source>Streets from OpenStreetMap as places, cut at their junctions, carriageway and sidewalks apart</source>
        <translation>Straßen aus OpenStreetMap als Orte, an Kreuzungen geteilt, Fahrbahn und Gehwege getrennt</translation>
    </message>
    <message>
        <source>Shows names of places</source>
        <translation>Zeigt Namen von Orten</translation>
    </message>
    <message>
        <source>Outlines of all places</source>
        <translation>Umrisse aller Orte</translation>
    </message>
    <message>
        <source>Without it, the outline of the chosen place is shown, and of the one under the cursor</source>
        <translation>Sonst werden der Umriss des gewählten Ortes und der des Ortes unter dem Zeiger gezeigt</translation>
    </message>
    <message>
        <source>Add to the &amp;city...</source>
        <translation>Zur Stadt &amp;hinzufügen ...</translation>
    </message>
    <message>
        <source>Choose a file...</source>
        <translation>Datei wählen ...</translation>
    </message>
    <message>
        <source>Which layer of %1 holds the places?</source>
        <translation>Welche Ebene von %1 enthält die Orte?</translation>
    </message>
    <message>
        <source>A terrain, an aerial photograph, trees, or parks and other places; what the city has stays</source>
        <translation>Ein Gelände, ein Luftbild, Bäume oder Parks und andere Orte; was die Stadt hat, bleibt</translation>
    </message>
    <message>
        <source>%1 is drawn as %2; a right click on it in Project changes its kind.</source>
        <translation>%1 ist als %2 gezeichnet; ein Rechtsklick darauf in Projekt ändert die Art.</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceCharts</name>
    <message>
        <source>Timelines</source>
        <translation>Zeitverläufe</translation>
    </message>
    <message>
        <source>Hours of the year in shadow</source>
        <translation>Stunden des Jahres im Schatten</translation>
    </message>
    <message>
        <source>Shadow by month</source>
        <translation>Schatten nach Monat</translation>
    </message>
    <message>
        <source>%1 measured. Clock: %2.</source>
        <translation>%1 gemessen. Uhrzeit: %2.</translation>
    </message>
    <message>
        <source>Incremental shadow: share of the place</source>
        <translation>Zusätzlicher Schatten: Anteil des Orts</translation>
    </message>
    <message>
        <source>Shadow in the scenario: share of the place</source>
        <translation>Schatten im Szenario: Anteil des Orts</translation>
    </message>
    <message>
        <source>Day of the year across, time of day upwards; not counted: the sun is down, or outside the rule&apos;s hours</source>
        <translation>Tage des Jahres nach rechts, Tageszeit nach oben; nicht gezählt: die Sonne ist untergegangen, oder außerhalb der Stunden der Regel</translation>
    </message>
    <message>
        <source>Area × hours in shadow by month</source>
        <translation>Fläche × Stunden im Schatten nach Monaten</translation>
    </message>
    <message>
        <source>The measured half of the year stands for both halves: each month counts twice</source>
        <translation>Die gemessene Jahreshälfte steht für beide Hälften: jeder Monat zählt doppelt</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceEvaluation</name>
    <message>
        <source>The rule is about windows, not about places</source>
        <translation>Die Regel gilt für Fenster, nicht für Orte</translation>
    </message>
    <message>
        <source>The place has no cell where shadow is measured</source>
        <translation>Der Ort hat keine Zelle, in der Schatten gemessen wird</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceFile</name>
    <message>
        <source>reading places</source>
        <translation>liest Orte</translation>
    </message>
    <message>
        <source>repairing outlines</source>
        <translation>repariert Umrisse</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceLinks</name>
    <message>
        <source>Outdated: places have changed</source>
        <translation>Veraltet: Orte haben sich geändert</translation>
    </message>
    <message>
        <source>Outdated: buildings, trees or places have changed</source>
        <translation>Veraltet: Gebäude, Bäume oder Orte haben sich geändert</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceList</name>
    <message>
        <source>Find a place</source>
        <translation>Einen Ort finden</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Tick all places</source>
        <translation>Alle Orte ankreuzen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Tick no place</source>
        <translation>Keinen Ort ankreuzen</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s) ticked</source>
        <translation>
            <numerusform>%1 von %2 Ort angekreuzt</numerusform>
            <numerusform>%1 von %2 Orten angekreuzt</numerusform>
        </translation>
    </message>
    <message>
        <source>In reach</source>
        <translation>In Reichweite</translation>
    </message>
    <message>
        <source>Tick the places that the proposal&apos;s shadow reaches, found anew for each proposal</source>
        <translation>Die Orte ankreuzen, die der Schatten des Vorschlags erreicht; für jeden Vorschlag neu bestimmt</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s) in reach of the shadow; the others&apos; tooltips say why not</source>
        <translation>
            <numerusform>%1 von %2 Ort in Reichweite des Schattens; die Hinweise der anderen sagen, warum nicht</numerusform>
            <numerusform>%1 von %2 Orten in Reichweite des Schattens; die Hinweise der anderen sagen, warum nicht</numerusform>
        </translation>
    </message>
    <message>
        <source>Only those in reach of the shadow; they are being found</source>
        <translation>Nur die in Reichweite des Schattens; sie werden gesucht</translation>
    </message>
    <message>
        <source>What the place is that is drawn, of the kinds that the rule is about</source>
        <translation>Was der gezeichnete Ort ist, von den Arten, für die die Regel gilt</translation>
    </message>
    <message>
        <source>Draw place</source>
        <translation>Ort zeichnen</translation>
    </message>
    <message>
        <source>Click the place&apos;s corners on the ground; double click or Enter finishes. Its name can then be typed in the list.</source>
        <translation>Klicken Sie die Ecken des Ortes am Boden an; Doppelklick oder Eingabe beendet. Der Name kann dann in der Liste getippt werden.</translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceSorter</name>
    <message>
        <source>further places: %1</source>
        <translation>weitere Orte: %1</translation>
    </message>
    <message>
        <source>%1: pieces of less than %2</source>
        <translation>%1: Stücke von weniger als %2</translation>
    </message>
    <message>
        <source>%1, pieces of less than %2</source>
        <translation>%1, Stücke von weniger als %2</translation>
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
        <translation>Sonnenstunden an diesem Tag, Mittel über den Ort</translation>
    </message>
    <message>
        <source>%1 &lt; %2 h, %</source>
        <translation>%1 &lt; %2 h, %</translation>
    </message>
    <message>
        <source>Share of the area with less than %1 h of sun on this day</source>
        <translation>Anteil der Fläche mit weniger als %1 h Sonne an diesem Tag</translation>
    </message>
    <message>
        <source>%1 (baseline: %2)</source>
        <translation>%1 (Ausgangslage: %2)</translation>
    </message>
    <message>
        <source>%1 without a name</source>
        <translation>%1 ohne Namen</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>%1 (here: %2 h)</source>
        <translation>%1 (hier: %2 h)</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Minutes of sun a day more than in the baseline, mean over the days and the place; negative: less</source>
        <translation>Minuten Sonne am Tag mehr als in der Ausgangslage, Mittel über die Tage und den Ort; negativ: weniger</translation>
    </message>
    <message>
        <source>≥ %1 h, %</source>
        <translation>ab %1 h, %</translation>
    </message>
    <message>
        <source>Minutes of shadow a day: the sunlit time without the sun</source>
        <translation>Minuten Schatten am Tag: die Tageszeit ohne Sonne</translation>
    </message>
    <message>
        <source>%1: shadow, min</source>
        <translation>%1: Schatten, min</translation>
    </message>
    <message>
        <source>Minutes of shadow on this day, mean over the place</source>
        <translation>Minuten Schatten an diesem Tag, Mittel über den Ort</translation>
    </message>
    <message>
        <source>Minutes of shadow a day more than in the baseline, mean over the days and the place; negative: less</source>
        <translation>Minuten Schatten am Tag mehr als in der Ausgangslage, Mittel über die Tage und den Ort; negativ: weniger</translation>
    </message>
    <message>
        <source>Change of shadow, min</source>
        <translation>Änderung des Schattens, min</translation>
    </message>
    <message>
        <source>≥ %1 h sun, %</source>
        <translation>≥ %1 h Sonne, %</translation>
    </message>
    <message>
        <source>%1 &lt; %2 h sun, %</source>
        <translation>%1 &lt; %2 h Sonne, %</translation>
    </message>
    <message>
        <source>%1: change, min</source>
        <translation>%1: Änderung, min</translation>
    </message>
    <message>
        <source>%1: change of shadow, min</source>
        <translation>%1: Änderung des Schattens, min</translation>
    </message>
    <message>
        <source>Minutes more than in the baseline on this day, mean over the place; negative: less (baseline: %1)</source>
        <translation>Minuten mehr als in der Ausgangslage an diesem Tag, im Mittel über den Ort; negativ: weniger (Ausgangslage: %1)</translation>
    </message>
</context>
<context>
    <name>noonmark::PlacesDock</name>
    <message>
        <source>What colours the places: the whole period, one of the dates, or the change against the baseline</source>
        <translation>Was die Orte färbt: der ganze Zeitraum, einer der Stichtage oder die Änderung gegenüber der Ausgangslage</translation>
    </message>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source>Lists only places of this kind</source>
        <translation>Listet nur Orte dieser Art auf</translation>
    </message>
    <message>
        <source>By kind</source>
        <translation>Nach Art</translation>
    </message>
    <message>
        <source>Part of a name</source>
        <translation>Teil eines Namens</translation>
    </message>
    <message>
        <source>Lists only the places whose name contains this text</source>
        <translation>Listet nur die Orte auf, deren Name diesen Text enthält</translation>
    </message>
    <message>
        <source>Places stand below a row of their kind with its means</source>
        <translation>Orte stehen unter einer Zeile ihrer Art mit deren Mitteln</translation>
    </message>
    <message>
        <source>Click a row to see its place in the view; a click on a place in the view selects its row</source>
        <translation>Ein Klick auf eine Zeile zeigt ihren Ort in der Ansicht; ein Klick auf einen Ort in der Ansicht wählt seine Zeile aus</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>Alle Arten</translation>
    </message>
    <message>
        <source>Whole period</source>
        <translation>Ganzer Zeitraum</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>%1: no cell on open ground</source>
        <translation>%1: keine Zelle auf freier Fläche</translation>
    </message>
    <message>
        <source>%1: %2 h of sun a day</source>
        <translation>%1: %2 h Sonne am Tag</translation>
    </message>
    <message>
        <source>No places measured: choose &quot;Sun by place&quot; in the panel Study</source>
        <translation>Keine Orte gemessen: „Sonne nach Ort“ im Feld Untersuchung wählen</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s)</source>
        <translation>
            <numerusform>%1 von %2 Ort</numerusform>
            <numerusform>%1 von %2 Orten</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 lose more than a minute of sun a day</source>
        <translation>%1 verlieren mehr als eine Minute Sonne am Tag</translation>
    </message>
    <message>
        <source>%1 have less than %2 h of sun a day</source>
        <translation>%1 haben weniger als %2 h Sonne am Tag</translation>
    </message>
    <message>
        <source>%1 have less than %2 h of sun on %3</source>
        <translation>%1 haben weniger als %2 h Sonne am %3</translation>
    </message>
    <message numerus="yes">
        <source>%1 place(s)</source>
        <translation>
            <numerusform>%1 Ort</numerusform>
            <numerusform>%1 Orte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s) listed</source>
        <translation>
            <numerusform>%1 von %2 Ort aufgelistet</numerusform>
            <numerusform>%1 von %2 Orten aufgelistet</numerusform>
        </translation>
    </message>
    <message>
        <source>Places with less sun a day than this are violet, others orange, unless the legend has other colours</source>
        <translation>Orte mit weniger Sonne am Tag sind violett, andere orange, wenn die Legende keine anderen Farben hat</translation>
    </message>
    <message>
        <source>Who shades it</source>
        <translation>Wer ihn beschattet</translation>
    </message>
    <message>
        <source>Shows which buildings take sun from the chosen place, and how much. Or double-click its row</source>
        <translation>Zeigt, welche Gebäude dem gewählten Ort Sonne nehmen, und wie viel. Oder doppelklicken Sie seine Zeile</translation>
    </message>
    <message>
        <source>Measured error against rays: %1</source>
        <translation>Gemessener Fehler gegen Strahlen: %1</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 von %3</translation>
    </message>
    <message>
        <source>%1: %2 min of sun a day less</source>
        <translation>%1: %2 min Sonne am Tag weniger</translation>
    </message>
    <message>
        <source>%1: %2 min of sun a day more</source>
        <translation>%1: %2 min Sonne am Tag mehr</translation>
    </message>
    <message>
        <source>%1. Headline and shares of the area are for %2 h, as they were saved</source>
        <translation>%1. Überschrift und Flächenanteile gelten für %2 h, wie sie gespeichert wurden</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Anzeigen</translation>
    </message>
    <message>
        <source>Shows this answer in the view and in the results again</source>
        <translation>Zeigt diese Antwort wieder in der Ansicht und den Ergebnissen</translation>
    </message>
    <message>
        <source>The view shows another result than %1</source>
        <translation>Die Ansicht zeigt ein anderes Ergebnis als %1</translation>
    </message>
    <message>
        <source>Sun by place</source>
        <translation>Sonne nach Ort</translation>
    </message>
    <message>
        <source>Shadow by place</source>
        <translation>Schatten nach Ort</translation>
    </message>
    <message>
        <source>hours of sun a day</source>
        <translation>Sonnenstunden am Tag</translation>
    </message>
    <message>
        <source>minutes of shadow a day</source>
        <translation>Minuten Schatten am Tag</translation>
    </message>
    <message>
        <source>Change of sun by place</source>
        <translation>Änderung der Sonne nach Ort</translation>
    </message>
    <message>
        <source>Change of shadow by place</source>
        <translation>Änderung des Schattens nach Ort</translation>
    </message>
    <message>
        <source>minutes of sun a day</source>
        <translation>Minuten Sonne am Tag</translation>
    </message>
    <message>
        <source>%1: %2 min of shadow a day</source>
        <translation>%1: %2 min Schatten am Tag</translation>
    </message>
    <message>
        <source>%1: %2 min of shadow a day more</source>
        <translation>%1: %2 min mehr Schatten am Tag</translation>
    </message>
    <message>
        <source>%1: %2 min of shadow a day less</source>
        <translation>%1: %2 min weniger Schatten am Tag</translation>
    </message>
    <message>
        <source>Only these</source>
        <translation>Nur diese</translation>
    </message>
    <message>
        <source>Lists only the places that this sentence counts</source>
        <translation>Listet nur die Orte, die dieser Satz zählt</translation>
    </message>
    <message>
        <source> h of sun</source>
        <translation> h Sonne</translation>
    </message>
    <message>
        <source>%1 get more than a minute of shadow a day more</source>
        <translation>%1 bekommen mehr als eine Minute Schatten am Tag dazu</translation>
    </message>
    <message>
        <source>%1 have more than %2 min of shadow a day</source>
        <translation>%1 haben mehr als %2 min Schatten am Tag</translation>
    </message>
    <message>
        <source>%1 have more than %2 min of shadow on %3</source>
        <translation>%1 haben am %3 mehr als %2 min Schatten</translation>
    </message>
    <message>
        <source>%1, %2 without figures</source>
        <translation>%1, %2 ohne Werte</translation>
    </message>
    <message>
        <source>%1. A saved answer states its dates as sun</source>
        <translation>%1. Eine gespeicherte Antwort nennt ihre Tage als Sonne</translation>
    </message>
    <message>
        <source>Which trees count in the table, the map and the headline</source>
        <translation>Ob Bäume in Tabelle, Karte und Überschrift ihren Anteil der Sonne nehmen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source> h of shade</source>
        <translation> h Schatten</translation>
    </message>
    <message>
        <source>&lt; </source>
        <translation>&lt; </translation>
    </message>
    <message>
        <source>any shade</source>
        <translation>jeder Schatten</translation>
    </message>
    <message>
        <source>Counts and lists the places with less shade than this, instead of those with too little sun</source>
        <translation>Zählt und listet die Orte mit weniger Schatten als diesem statt derer mit zu wenig Sonne</translation>
    </message>
    <message>
        <source>%1 have less than %2 h of shade a day</source>
        <translation>%1 haben weniger als %2 h Schatten am Tag</translation>
    </message>
    <message>
        <source>%1 have less than %2 h of shade on %3</source>
        <translation>%1 haben am %3 weniger als %2 h Schatten</translation>
    </message>
</context>
<context>
    <name>noonmark::PlacesForm</name>
    <message>
        <source>The project has no places. Read some (Study &gt; Read places...) or draw one.</source>
        <translation>Das Projekt hat keine Orte. Orte einlesen (Untersuchung &gt; Orte einlesen ...) oder einen zeichnen.</translation>
    </message>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source>Places of the ticked kinds are measured, all in one run</source>
        <translation>Orte der angekreuzten Arten werden gemessen, alle in einem Durchgang</translation>
    </message>
    <message>
        <source>The share of each place with so many hours of sun a day is stated</source>
        <translation>Angegeben wird der Anteil jedes Orts mit so vielen Sonnenstunden am Tag</translation>
    </message>
    <message>
        <source>Days on which the hours of sun of each place are stated, too, with commas between</source>
        <translation>Tage, an denen die Sonnenstunden jedes Orts ebenfalls angegeben werden, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>Enough sun</source>
        <translation>Genug Sonne</translation>
    </message>
    <message>
        <source>Dates</source>
        <translation>Stichtage</translation>
    </message>
    <message>
        <source>All scenarios</source>
        <translation>Alle Szenarien</translation>
    </message>
    <message>
        <source>Measures the places in all scenarios and compares each with the baseline, which is chosen at the top</source>
        <translation>Misst die Orte in allen Szenarien und vergleicht jedes mit der Ausgangslage, die oben gewählt wird</translation>
    </message>
    <message>
        <source>Own regions %1</source>
        <translation>Eigene Gebiete %1</translation>
    </message>
    <message>
        <source>Read streets</source>
        <translation>Straßen einlesen</translation>
    </message>
    <message>
        <source>Adds the streets of the city&apos;s OpenStreetMap file, cut at their junctions, carriageway and sidewalks apart</source>
        <translation>Fügt die Straßen der OpenStreetMap-Datei der Stadt hinzu, an Kreuzungen geteilt, Fahrbahn und Gehwege getrennt</translation>
    </message>
</context>
<context>
    <name>noonmark::PlacingPanel</name>
    <message>
        <source>Build</source>
        <translation>Bauen</translation>
    </message>
    <message>
        <source>Scale of all three axes</source>
        <translation>Maßstab aller drei Achsen</translation>
    </message>
    <message>
        <source>Adds it to the scenario (Enter over the view)</source>
        <translation>Fügt es dem Szenario hinzu (Eingabe über der Ansicht)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>%1: click the place on the ground for its middle.</source>
        <translation>%1: die Stelle auf dem Boden für seine Mitte anklicken.</translation>
    </message>
    <message>
        <source> (and %1 more)</source>
        <translation> (und %1 weitere)</translation>
    </message>
    <message>
        <source>Floor to floor, %1 to %2, for lines at its floors; 0: not known</source>
        <translation>Geschosshöhe, %1 bis %2, für Linien an den Decken; 0: nicht bekannt</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Storey height</source>
        <translation>Geschosshöhe</translation>
    </message>
    <message>
        <source>%1, top %2. Another click moves it.</source>
        <translation>%1, Oberkante %2. Ein weiterer Klick versetzt es.</translation>
    </message>
    <message>
        <source>° east</source>
        <translation>° Ost</translation>
    </message>
    <message>
        <source>° north</source>
        <translation>° Nord</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Puts the file in the place of its earlier edition; the edits that follow stay</source>
        <translation>Setzt die Datei an die Stelle ihrer früheren Ausgabe; die folgenden Änderungen bleiben</translation>
    </message>
    <message>
        <source>Clockwise, seen from above. Of an IFC that states its true north, preset from it</source>
        <translation>Im Uhrzeigersinn, von oben gesehen. Bei einer IFC mit Angabe ihrer Nordrichtung daraus voreingestellt</translation>
    </message>
    <message>
        <source>Where its middle stands; a click on the ground sets it, too</source>
        <translation>Wo seine Mitte steht; ein Klick auf den Boden setzt sie ebenfalls</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>%1: an earlier version of this file is in the scenario as %2. Reload replaces it; Build adds another.</source>
        <translation>%1: eine frühere Ausgabe steht als %2. Neu laden ersetzt sie an ihrem Platz; Bauen fügt eine weitere hinzu.</translation>
    </message>
</context>
<context>
    <name>noonmark::PlateField</name>
    <message>
        <source>Whole lot</source>
        <translation>Ganzes Grundstück</translation>
    </message>
    <message>
        <source>Share of the lot</source>
        <translation>Anteil am Grundstück</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>A smaller plate keeps the lot&apos;s shape, inset from all sides</source>
        <translation>Eine kleinere Platte behält die Form des Grundstücks, auf allen Seiten eingerückt</translation>
    </message>
    <message>
        <source> sq ft</source>
        <translation> sq ft</translation>
    </message>
</context>
<context>
    <name>noonmark::PointDock</name>
    <message>
        <source>In the sun on %1: %2
In the year: %3 h of %4 h
Sky view factor: %5</source>
        <translation>In der Sonne am %1: %2
Im Jahr: %3 h von %4 h
Himmelssichtfaktor: %5</translation>
    </message>
    <message>
        <source>
Vertical sky component: %1 %</source>
        <translation>
Vertikaler Himmelslichtanteil: %1 %</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Speichern ...</translation>
    </message>
    <message>
        <source>The drawing as SVG or PNG, or the minutes by month and hour as CSV</source>
        <translation>Die Zeichnung als SVG oder PNG oder die Minuten nach Monat und Stunde als CSV</translation>
    </message>
    <message>
        <source>Right-click the ground, a roof or a wall and choose Sun and sky here.</source>
        <translation>Den Boden, ein Dach oder eine Wand rechts anklicken und „Sonne und Himmel hier“ wählen.</translation>
    </message>
    <message>
        <source>Before: %1
%2

After: %3
%4</source>
        <translation>Vorher: %1
%2

Nachher: %3
%4</translation>
    </message>
    <message>
        <source>%1 min on the day and %2 h in the year with their seasons; %3 min and %4 h as evergreens</source>
        <translation>%1 min am Tag und %2 h im Jahr mit ihren Jahreszeiten; %3 min und %4 h als Immergrüne</translation>
    </message>
    <message>
        <source>
With trees: %1</source>
        <translation>
Mit Bäumen: %1</translation>
    </message>
    <message>
        <source>
Sky view factor with trees: %1 with their seasons, %2 as evergreens</source>
        <translation>
Himmelssichtfaktor mit Bäumen: %1 mit ihren Jahreszeiten, %2 als Immergrüne</translation>
    </message>
    <message>
        <source>
Vertical sky component with trees: %1 % and %2 %</source>
        <translation>
Vertikaler Himmelslichtanteil mit Bäumen: %1 % und %2 %</translation>
    </message>
    <message>
        <source>Trees that take most sun, with their seasons:</source>
        <translation>Bäume, die am meisten Sonne nehmen, mit ihren Jahreszeiten:</translation>
    </message>
    <message>
        <source>%1: %2 min on the day, %3 h in the year</source>
        <comment>a tree, and the sun it takes</comment>
        <translation>%1: %2 min am Tag, %3 h im Jahr</translation>
    </message>
    <message numerus="yes">
        <source>and %1 more tree(s)</source>
        <translation>
            <numerusform>und %1 weiterer Baum</numerusform>
            <numerusform>und %1 weitere Bäume</numerusform>
        </translation>
    </message>
    <message>
        <source>
In the sun on %1, %2: %3</source>
        <comment>a day, trees as evergreens, times</comment>
        <translation>
In der Sonne am %1, %2: %3</translation>
    </message>
</context>
<context>
    <name>noonmark::PointInspector</name>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
</context>
<context>
    <name>noonmark::PointListForm</name>
    <message>
        <source>Click points</source>
        <translation>Punkte anklicken</translation>
    </message>
    <message>
        <source>Click the ground, roofs or walls in the view: each click adds a point. Press again to end</source>
        <translation>Auf Boden, Dächer oder Wände in der Ansicht klicken: Jeder Klick fügt einen Punkt hinzu. Zum Beenden erneut drücken</translation>
    </message>
    <message>
        <source>Read CSV...</source>
        <translation>CSV lesen ...</translation>
    </message>
    <message>
        <source>Replaces the list by a CSV file with columns id, lon, lat, height, facing</source>
        <translation>Ersetzt die Liste durch eine CSV-Datei mit den Spalten id, lon, lat, height, facing</translation>
    </message>
    <message>
        <source>One point a line: id, longitude, latitude (degrees), metres above the ground, azimuth that a wall faces. Without a height the point is on the ground or roof, without an azimuth it is level</source>
        <translation>Ein Punkt je Zeile: Kennung, Länge, Breite (Grad), Meter über dem Boden, Azimut der Wand. Ohne Höhe liegt der Punkt auf Boden oder Dach, ohne Azimut ist er waagerecht</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
</context>
<context>
    <name>noonmark::PointScenarios</name>
    <message>
        <source>The scenario before: what the other one is compared with</source>
        <translation>Das Szenario vorher: womit das andere verglichen wird</translation>
    </message>
    <message>
        <source>The scenario whose sun at the point is compared</source>
        <translation>Das Szenario, dessen Sonne am Punkt verglichen wird</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Day, min</source>
        <translation>Tag, min</translation>
    </message>
    <message>
        <source>Year, h</source>
        <translation>Jahr, h</translation>
    </message>
    <message>
        <source>Change, h</source>
        <translation>Änderung, h</translation>
    </message>
    <message>
        <source>Sky view</source>
        <translation>Himmelssicht</translation>
    </message>
    <message>
        <source>VSC, %</source>
        <translation>VSC, %</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>the baseline</source>
        <translation>die Ausgangslage</translation>
    </message>
    <message>
        <source>the displayed scenario</source>
        <translation>das angezeigte Szenario</translation>
    </message>
    <message>
        <source>The point&apos;s sun and sky in every scenario of the project, without trees where a row says nothing else. Copy (Ctrl+C) takes the table</source>
        <translation>Sonne und Himmel des Punkts in jedem Szenario des Projekts, ohne Bäume, wo eine Zeile nichts anderes sagt. Kopieren (Strg+C) nimmt die Tabelle</translation>
    </message>
</context>
<context>
    <name>noonmark::PointShading</name>
    <message>
        <source>weighing crowns at points</source>
        <translation>wägt Kronen an Punkten</translation>
    </message>
</context>
<context>
    <name>noonmark::PolygonDrawing</name>
    <message>
        <source>region</source>
        <translation>Gebiet</translation>
    </message>
    <message>
        <source>lot</source>
        <translation>Grundstück</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>first corner: closes the outline</source>
        <translation>erste Ecke: schließt den Umriss</translation>
    </message>
    <message>
        <source>Length: %1  (Enter)</source>
        <translation>Länge: %1  (Eingabe)</translation>
    </message>
    <message>
        <source>Length: %1, azimuth: %2° clockwise from north  (Enter)</source>
        <translation>Länge: %1, Azimut: %2° im Uhrzeigersinn von Nord  (Eingabe)</translation>
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
        <translation>Sprache, Farben, Einheiten, Papier und Startseite</translation>
    </message>
    <message>
        <source>Pr&amp;eferences...</source>
        <translation>E&amp;instellungen ...</translation>
    </message>
</context>
<context>
    <name>noonmark::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Light or dark; applies at once</source>
        <translation>Hell oder dunkel; gilt sofort</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Metric: metres</source>
        <translation>Metrisch: Meter</translation>
    </message>
    <message>
        <source>Imperial: feet</source>
        <translation>Imperial: Fuß</translation>
    </message>
    <message>
        <source>Metric and imperial</source>
        <translation>Metrisch und imperial</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Of sheets, until you choose another for one of them</source>
        <translation>Von Blättern, bis für eines ein anderes gewählt wird</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Of sheets</source>
        <translation>Von Blättern</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Hochformat</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Querformat</translation>
    </message>
    <message>
        <source>Show the start page when Noonmark starts</source>
        <translation>Startseite beim Start von Noonmark zeigen</translation>
    </message>
    <message>
        <source>Only where no file is opened with the program. Help &gt; Start page shows it at any time</source>
        <translation>Nur wenn keine Datei mit dem Programm geöffnet wird. Hilfe &gt; Startseite zeigt sie jederzeit</translation>
    </message>
    <message>
        <source>In which areas, lengths and heights are shown and lengths are typed; applies at once</source>
        <translation>Worin Flächen, Längen und Höhen gezeigt und Längen eingegeben werden; gilt sofort</translation>
    </message>
    <message>
        <source>Of menus, panels and numbers; applies at once. Files and sheets stay English, and so do errors and warnings that hold a number or a name</source>
        <translation>Von Menüs, Bereichen und Zahlen; gilt sofort. Dateien und Blätter bleiben englisch, ebenso Fehler und Warnungen, die eine Zahl oder einen Namen enthalten</translation>
    </message>
</context>
<context>
    <name>noonmark::ProgressStrip</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop this job; the previous result stays</source>
        <translation>Diese Berechnung abbrechen; das vorige Ergebnis bleibt</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>beginnt</translation>
    </message>
</context>
<context>
    <name>noonmark::ProjectDock</name>
    <message>
        <source>remove step %1 of %2</source>
        <translation>Schritt %1 von %2 entfernen</translation>
    </message>
    <message>
        <source>delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>duplicate %1</source>
        <translation>%1 verdoppeln</translation>
    </message>
    <message>
        <source>new scenario %1</source>
        <translation>neues Szenario %1</translation>
    </message>
    <message>
        <source>change kind of %1</source>
        <translation>Art von %1 ändern</translation>
    </message>
    <message>
        <source>roads along %1</source>
        <translation>Straßen an %1</translation>
    </message>
    <message>
        <source>R&amp;oads along it...</source>
        <translation>S&amp;traßen daran ...</translation>
    </message>
    <message>
        <source>&amp;Rename	F2</source>
        <translation>Um&amp;benennen	F2</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>&amp;Remove step	Del</source>
        <translation>&amp;Schritt entfernen	Entf</translation>
    </message>
    <message>
        <source>&amp;Delete	Del</source>
        <translation>&amp;Löschen	Entf</translation>
    </message>
    <message>
        <source>&amp;Compare with this</source>
        <translation>Ver&amp;gleichen damit</translation>
    </message>
    <message>
        <source>&amp;New scenario from this</source>
        <translation>&amp;Neues Szenario hieraus</translation>
    </message>
    <message>
        <source>&amp;Starts from</source>
        <translation>Beginnt &amp;mit</translation>
    </message>
    <message>
        <source>change base of %1</source>
        <translation>Ausgangspunkt von %1 ändern</translation>
    </message>
    <message>
        <source>&amp;Use as study region</source>
        <translation>Als Unter&amp;suchungsgebiet verwenden</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Art</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Anzeigen</translation>
    </message>
    <message>
        <source>&amp;New scenario</source>
        <translation>&amp;Neues Szenario</translation>
    </message>
    <message>
        <source>&amp;Save the study&apos;s region</source>
        <translation>Untersuchungsgebiet &amp;speichern</translation>
    </message>
    <message>
        <source>&amp;Save the study&apos;s period</source>
        <translation>Untersuchungszeitraum &amp;speichern</translation>
    </message>
    <message>
        <source>&amp;Save the displayed result</source>
        <translation>Angezeigtes Ergebnis &amp;speichern</translation>
    </message>
    <message>
        <source>&amp;Draw a lot</source>
        <translation>&amp;Grundstück zeichnen</translation>
    </message>
    <message>
        <source>&amp;Draw a place</source>
        <translation>&amp;Ort zeichnen</translation>
    </message>
    <message>
        <source>&amp;Read places from a file...</source>
        <translation>Orte aus Datei &amp;einlesen ...</translation>
    </message>
    <message>
        <source>&amp;Save this view</source>
        <translation>Diese Ansicht &amp;speichern</translation>
    </message>
    <message>
        <source>Edit lot &amp;shape</source>
        <translation>Grundstück &amp;umformen</translation>
    </message>
</context>
<context>
    <name>noonmark::ProjectSaving</name>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saving recovery file</source>
        <translation>Sicherung wird gespeichert</translation>
    </message>
</context>
<context>
    <name>noonmark::ProjectSession</name>
    <message>
        <source>rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>add lot %1</source>
        <translation>Grundstück %1 hinzufügen</translation>
    </message>
</context>
<context>
    <name>noonmark::R</name>
    <message>
        <source>Weighted shade</source>
        <translation>Gewichteter Schatten</translation>
    </message>
    <message>
        <source>sum over the steps of weight x hours in shadow x cell area, m2 h over the period; how the weight table is cut into intervals does not change it</source>
        <translation>Summe über die Schritte von Gewicht x Stunden im Schatten x Zellfläche, m² h im Zeitraum; wie die Gewichtstabelle in Intervalle geteilt ist, ändert nichts daran</translation>
    </message>
    <message>
        <source>Shadow score</source>
        <translation>Schattenbewertung</translation>
    </message>
    <message>
        <source>sum over the intervals of the weight table of weight x share of the interval&apos;s sunlit time in shadow, times cell area; an interval that is cut in two counts twice</source>
        <translation>Summe über die Intervalle der Gewichtstabelle von Gewicht x Anteil der Sonnenzeit des Intervalls im Schatten, mal Zellfläche; ein geteiltes Intervall zählt doppelt</translation>
    </message>
</context>
<context>
    <name>noonmark::RangePanel</name>
    <message>
        <source>Incremental shadow</source>
        <translation>Zusätzlicher Schatten</translation>
    </message>
    <message>
        <source>Shadow in the scenario</source>
        <translation>Schatten im Szenario</translation>
    </message>
    <message>
        <source>Shadow in the baseline</source>
        <translation>Schatten in der Ausgangslage</translation>
    </message>
    <message>
        <source>Shadow by month</source>
        <translation>Schatten nach Monat</translation>
    </message>
    <message>
        <source>This rule is about single days. Rules about a range of days, such as san-francisco-295, have a chart by hour and day of the year.</source>
        <translation>Diese Regel gilt einzelnen Tagen. Regeln über eine Spanne von Tagen, wie san-francisco-295, haben ein Diagramm nach Stunde und Tag des Jahres.</translation>
    </message>
    <message>
        <source>Computing...</source>
        <translation>Wird berechnet ...</translation>
    </message>
    <message>
        <source>Chart of the range</source>
        <translation>Diagramm der Spanne</translation>
    </message>
    <message>
        <source>Click a day for its timeline.</source>
        <translation>Einen Tag anklicken zeigt seinen Zeitverlauf.</translation>
    </message>
    <message>
        <source>Area × hours in shadow; each month counts twice, for both halves of the year.</source>
        <translation>Fläche × Stunden im Schatten; jeder Monat zählt doppelt, für beide Jahreshälften.</translation>
    </message>
    <message>
        <source>Area × hours in shadow.</source>
        <translation>Fläche × Stunden im Schatten.</translation>
    </message>
</context>
<context>
    <name>noonmark::ReadingForm</name>
    <message>
        <source>Origin located at</source>
        <translation>Ursprung liegt bei</translation>
    </message>
    <message>
        <source>° east</source>
        <translation>° Ost</translation>
    </message>
    <message>
        <source>° north</source>
        <translation>° Nord</translation>
    </message>
    <message>
        <source>Middle of the open city</source>
        <translation>Mitte der offenen Stadt</translation>
    </message>
    <message>
        <source>Place and choice of data</source>
        <translation>Lage und Auswahl der Daten</translation>
    </message>
    <message>
        <source>Geographic location of the mesh&apos;s origin. Required for a mesh opened alone.
Off: at the origin of the city from the other files.</source>
        <translation>Geografische Lage des Modellursprungs. Nötig, wenn ein Modell allein geöffnet wird.
Aus: am Ursprung der Stadt aus den anderen Dateien.</translation>
    </message>
    <message>
        <source>Longitude of the mesh&apos;s origin, degrees, east positive, -180 to 180</source>
        <translation>Länge des Modellursprungs, Grad, Ost positiv, -180 bis 180</translation>
    </message>
    <message>
        <source>Latitude of the mesh&apos;s origin, degrees, north positive, -90 to 90</source>
        <translation>Breite des Modellursprungs, Grad, Nord positiv, -90 bis 90</translation>
    </message>
    <message>
        <source>Places the mesh&apos;s origin at the middle of the open city</source>
        <translation>Setzt den Ursprung des Modells in die Mitte der offenen Stadt</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>3D-Modelle (%1)</translation>
    </message>
    <message>
        <source>Heights and names</source>
        <translation>Höhen und Namen</translation>
    </message>
</context>
<context>
    <name>noonmark::RecentMenu</name>
    <message>
        <source>%1, with options</source>
        <translation>%1, mit Optionen</translation>
    </message>
    <message>
        <source>%1, read with %2</source>
        <translation>%1, gelesen mit %2</translation>
    </message>
</context>
<context>
    <name>noonmark::RecoveryOffers</name>
    <message>
        <source>Noonmark closed before %1 was saved. Unsaved changes can be recovered.</source>
        <translation>Noonmark wurde beendet, bevor %1 gespeichert war. Ungespeicherte Änderungen können wiederhergestellt werden.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Older changes...</source>
        <translation>Ältere Änderungen ...</translation>
    </message>
    <message>
        <source>There are unsaved changes to %1 from %2. They can be recovered or deleted.</source>
        <translation>Es gibt ungespeicherte Änderungen an %1 vom %2. Sie können wiederhergestellt oder gelöscht werden.</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Noonmark closed before a project was saved. The unsaved project can be recovered.</source>
        <translation>Noonmark wurde beendet, bevor ein Projekt gespeichert war. Das Projekt kann wiederhergestellt werden.</translation>
    </message>
</context>
<context>
    <name>noonmark::RegionActions</name>
    <message>
        <source>&amp;Draw region</source>
        <translation>Gebiet &amp;zeichnen</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Click corners on the ground; Enter finishes, Esc cancels</source>
        <translation>Ecken auf dem Boden anklicken; Eingabe beendet, Esc bricht ab</translation>
    </message>
    <message>
        <source>Region from &amp;file...</source>
        <translation>Gebiet aus Datei ...</translation>
    </message>
    <message>
        <source>Polygons from a file, in any coordinate system</source>
        <translation>Polygone aus einer Datei, in einem beliebigen Koordinatensystem</translation>
    </message>
    <message>
        <source>region</source>
        <translation>Gebiet</translation>
    </message>
    <message>
        <source>draw %1</source>
        <translation>%1 zeichnen</translation>
    </message>
    <message>
        <source>save region %1</source>
        <translation>Gebiet %1 speichern</translation>
    </message>
</context>
<context>
    <name>noonmark::ResultActions</name>
    <message>
        <source>Save &amp;picture...</source>
        <translation>B&amp;ild speichern ...</translation>
    </message>
    <message>
        <source>Ctrl+P</source>
        <translation>Ctrl+P</translation>
    </message>
    <message>
        <source>The view with its legend, as a PNG file</source>
        <translation>Die Ansicht mit ihrer Legende als PNG-Datei</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>E&amp;xportieren ...</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>The displayed result, all scenarios or the review, as PDF, picture, GeoTIFF, tables and JSON</source>
        <translation>Das angezeigte Ergebnis, alle Szenarien oder die Prüfung als PDF, Bild, GeoTIFF, Tabellen und JSON</translation>
    </message>
    <message>
        <source>&amp;Save result</source>
        <translation>Ergebnis &amp;speichern</translation>
    </message>
    <message>
        <source>Stores the displayed map and figures in the project</source>
        <translation>Legt die angezeigte Karte und ihre Zahlen im Projekt ab</translation>
    </message>
    <message>
        <source>Picture saved as %1</source>
        <translation>Bild gespeichert als %1</translation>
    </message>
    <message>
        <source>Picture copied</source>
        <translation>Bild kopiert</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 verglichen mit %2</translation>
    </message>
    <message>
        <source>&amp;Export (%1)...</source>
        <translation>E&amp;xportieren (%1) ...</translation>
    </message>
    <message numerus="yes">
        <source>All %1 scenario(s) measured</source>
        <translation>
            <numerusform>Das %1 gemessene Szenario</numerusform>
            <numerusform>Alle %1 gemessenen Szenarien</numerusform>
        </translation>
    </message>
    <message>
        <source>Contributions to the shadow on %1</source>
        <translation>Was Gebäude %1 nehmen</translation>
    </message>
    <message>
        <source>Picture of the view</source>
        <translation>Bild der Ansicht</translation>
    </message>
    <message>
        <source>Table of scenarios: scores, verdicts, sun of places</source>
        <translation>Tabelle der Szenarien: Bewertungen, Urteile, Sonne der Orte</translation>
    </message>
</context>
<context>
    <name>noonmark::ResultDisplay</name>
    <message>
        <source>These figures do not include the building being designed. Build it, then run.</source>
        <translation>Diese Zahlen enthalten das entworfene Gebäude nicht. Bauen, dann berechnen.</translation>
    </message>
    <message>
        <source>Outdated figures: buildings have changed; %1.</source>
        <translation>Veraltete Zahlen: Gebäude haben sich geändert; %1.</translation>
    </message>
    <message>
        <source>new figures are being computed</source>
        <translation>neue Zahlen werden berechnet</translation>
    </message>
    <message>
        <source>run again (Ctrl+R)</source>
        <translation>neu berechnen (Strg+R)</translation>
    </message>
    <message>
        <source>Outdated figures: settings have changed; run again (Ctrl+R).</source>
        <translation>Veraltete Zahlen: Einstellungen haben sich geändert; neu berechnen (Strg+R).</translation>
    </message>
    <message>
        <source>Outdated score: the weight table has changed; score again.</source>
        <translation>Veraltete Bewertung: die Gewichtstabelle hat sich geändert; neu bewerten.</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>%1 (outdated)</source>
        <translation>%1 (veraltet)</translation>
    </message>
    <message>
        <source>Outdated figures: places have changed; run again (Ctrl+R).</source>
        <translation>Veraltete Zahlen: Orte haben sich geändert; rechnen Sie neu (Strg+R).</translation>
    </message>
</context>
<context>
    <name>noonmark::ResultsDock</name>
    <message>
        <source>Show the study again</source>
        <translation>Untersuchung wieder zeigen</translation>
    </message>
    <message>
        <source>Replaces this result by the current study or comparison</source>
        <translation>Ersetzt dieses Ergebnis durch die laufende Untersuchung oder den Vergleich</translation>
    </message>
    <message>
        <source>No study yet.
Choose what, when and where in the panel Study, and press Run study (Ctrl+R). The answer then stands here.</source>
        <translation>Noch keine Untersuchung.
Im Feld Untersuchung wählen, was, wann und wo, und Berechnen drücken (Strg+R). Dann steht die Antwort hier.</translation>
    </message>
    <message>
        <source>How this was made</source>
        <translation>Wie dies entstand</translation>
    </message>
    <message>
        <source>Period, engine, error, time, and the command that repeats this result</source>
        <translation>Zeitraum, Verfahren, Fehler, Zeit und der Befehl, der dasselbe fragt</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>Befehl kopieren</translation>
    </message>
    <message>
        <source>The command line that asks the same of the saved project or of the files</source>
        <translation>Die Befehlszeile, die dasselbe vom gespeicherten Projekt oder von den Dateien fragt</translation>
    </message>
    <message>
        <source>What was repaired, left out or assumed when the data was read</source>
        <translation>Was beim Einlesen der Daten repariert, ausgelassen oder angenommen wurde</translation>
    </message>
    <message>
        <source>The answers of this session and those saved in the project, newest first</source>
        <translation>Die Antworten dieser Sitzung und die im Projekt gespeicherten, neueste zuerst</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportieren ...</translation>
    </message>
    <message numerus="yes">
        <source>%1 warning(s) about the data</source>
        <translation>
            <numerusform>%1 Hinweis zu den Daten</numerusform>
            <numerusform>%1 Hinweise zu den Daten</numerusform>
        </translation>
    </message>
    <message>
        <source>Shows the figures of all places again</source>
        <translation>Zeigt wieder die Zahlen aller Orte</translation>
    </message>
    <message>
        <source>Who shades it</source>
        <translation>Wer ihn beschattet</translation>
    </message>
    <message>
        <source>Shows which buildings take sun from this place, and how much</source>
        <translation>Zeigt, welche Gebäude diesem Ort Sonne nehmen, und wie viel</translation>
    </message>
    <message numerus="yes">
        <source>Back to all %1 place(s)</source>
        <translation>
            <numerusform>Zurück zu %1 Ort</numerusform>
            <numerusform>Zurück zu allen %1 Orten</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide this result</source>
        <translation>Dieses Ergebnis ausblenden</translation>
    </message>
    <message>
        <source>Show an earlier result</source>
        <translation>Ein früheres Ergebnis zeigen</translation>
    </message>
    <message>
        <source>Which trees count in what is shown here and in the view</source>
        <translation>Welche Bäume hier und in der Ansicht zählen</translation>
    </message>
</context>
<context>
    <name>noonmark::ReviewActions</name>
    <message>
        <source>Re&amp;view by a rule...</source>
        <translation>&amp;Prüfung nach einer Regel ...</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Ctrl+Shift+R</translation>
    </message>
    <message>
        <source>Evaluate the rule of a review board on the places of the project</source>
        <translation>Die Regel einer Behörde an den Orten des Projekts auswerten</translation>
    </message>
    <message>
        <source>Shows the sheets of the review, and writes them with its tables and drawings</source>
        <translation>Zeigt die Blätter der Prüfung und schreibt sie mit ihren Tabellen und Zeichnungen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Export t&amp;he review...</source>
        <translation>Prüfung e&amp;xportieren ...</translation>
    </message>
</context>
<context>
    <name>noonmark::ReviewDock</name>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportieren ...</translation>
    </message>
    <message>
        <source>Copies the table, with all days, as text for a spreadsheet</source>
        <translation>Kopiert die Tabelle mit allen Tagen als Text für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>Writes the sheets (PDF), the table (CSV), the data (JSON), and the shadows for CAD and GIS (DXF, GeoPackage)</source>
        <translation>Schreibt die Blätter (PDF), die Tabelle (CSV), die Daten (JSON) und die Schatten für CAD und GIS (DXF, GeoPackage)</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>Range of days</source>
        <translation>Spanne von Tagen</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Computing the verdicts of the building being designed...</source>
        <translation>Die Befunde für das entworfene Gebäude werden berechnet ...</translation>
    </message>
    <message>
        <source>Press Run review to evaluate the rule on the ticked places.</source>
        <translation>Prüfen drücken, um die Regel an den angekreuzten Orten auszuwerten.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: %2 compared with %3. %4</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: %2 verglichen mit %3. %4</translation>
    </message>
    <message>
        <source>&lt;br&gt;&lt;i&gt;Follows the building being designed.&lt;/i&gt;</source>
        <translation>&lt;br&gt;&lt;i&gt;Folgt dem entworfenen Gebäude.&lt;/i&gt;</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Click a row of the table to see its timeline.</source>
        <translation>Eine Zeile der Tabelle anklicken zeigt ihren Zeitverlauf.</translation>
    </message>
    <message>
        <source>The timeline of a place appears here after a review.</source>
        <translation>Der Zeitverlauf eines Orts erscheint hier nach einer Prüfung.</translation>
    </message>
    <message>
        <source>Build the tower, then run the review, to see its range of days.</source>
        <translation>Den Turm bauen, dann prüfen, um die Spanne von Tagen zu sehen.</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Nicht geprüft</translation>
    </message>
    <message>
        <source>How Noonmark reads what the rule leaves open</source>
        <translation>Wie Noonmark liest, was die Regel offen lässt</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1, steps of %2 min, cells of %3 m, %4, %5&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1, Schritte von %2 min, Zellen von %3 m, %4, %5&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Rule files that are left out</source>
        <translation>Ausgelassene Regeldateien</translation>
    </message>
    <message>
        <source>&lt;h4&gt;Figures with status and source&lt;/h4&gt;</source>
        <translation>&lt;h4&gt;Zahlen mit Stand und Quelle&lt;/h4&gt;</translation>
    </message>
    <message>
        <source>A rule about windows has no timeline: click a row to read when its window has sun.</source>
        <translation>Eine Regel über Fenster hat keinen Zeitverlauf: Ein Klick auf eine Zeile zeigt, wann ihr Fenster Sonne hat.</translation>
    </message>
    <message>
        <source>Press Run review to evaluate the rule on the windows.</source>
        <translation>Prüfen drücken, um die Regel an den Fenstern auszuwerten.</translation>
    </message>
    <message>
        <source>Press Run review to see which places fail as the city stands, or design a tower.</source>
        <translation>Prüfen drücken, um zu sehen, welche Orte die Regel schon im Bestand nicht einhalten, oder einen Turm entwerfen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: %2 as it stands. %3</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: %2 im jetzigen Zustand. %3</translation>
    </message>
    <message>
        <source>The project holds %1, see the list of Results. Run review shows its places and timelines again.</source>
        <translation>Das Projekt enthält %1, siehe die Liste der Ergebnisse. „Prüfen“ zeigt Orte und Zeitverläufe wieder.</translation>
    </message>
</context>
<context>
    <name>noonmark::ReviewForm</name>
    <message>
        <source>Run review</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Evaluate the rule on the ticked places, or on the windows</source>
        <translation>Wertet die Regel an den angekreuzten Orten oder an den Fenstern aus</translation>
    </message>
    <message>
        <source>Expected time: %1</source>
        <translation>Erwartete Dauer: %1</translation>
    </message>
</context>
<context>
    <name>noonmark::ReviewSession</name>
    <message>
        <source>Review</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Estimating</source>
        <translation>Wird abgeschätzt</translation>
    </message>
    <message>
        <source>the building being designed</source>
        <translation>das entworfene Gebäude</translation>
    </message>
    <message>
        <source>Live review</source>
        <translation>Mitlaufende Prüfung</translation>
    </message>
    <message>
        <source>Not up to date: a building is being designed. Build it, then run.</source>
        <translation>Nicht aktuell: ein Gebäude wird entworfen. Bauen, dann prüfen.</translation>
    </message>
    <message>
        <source>Not up to date. %1</source>
        <translation>Nicht aktuell. %1</translation>
    </message>
    <message>
        <source>Not up to date: buildings or scenarios have changed. Run again.</source>
        <translation>Nicht aktuell: Gebäude oder Szenarien haben sich geändert. Neu prüfen.</translation>
    </message>
    <message>
        <source>Not up to date: rule, places, time zone or year have changed. Run again.</source>
        <translation>Nicht aktuell: Regel, Orte, Zeitzone oder Jahr haben sich geändert. Neu prüfen.</translation>
    </message>
    <message>
        <source>All reviews</source>
        <translation>Alle Prüfungen</translation>
    </message>
    <message>
        <source>Finding places in reach</source>
        <translation>Orte in Reichweite bestimmen</translation>
    </message>
</context>
<context>
    <name>noonmark::RuleForm</name>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>Ausgangslage</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>What the proposal is compared with. The rule asks for: %1</source>
        <translation>Womit der Entwurf verglichen wird. Die Regel verlangt: %1</translation>
    </message>
    <message>
        <source>Displayed: %1</source>
        <translation>Angezeigt: %1</translation>
    </message>
    <message>
        <source>%1 (not where the site is)</source>
        <translation>%1 (nicht für diesen Standort)</translation>
    </message>
</context>
<context>
    <name>noonmark::RunForecast</name>
    <message>
        <source>Estimating</source>
        <translation>Wird abgeschätzt</translation>
    </message>
</context>
<context>
    <name>noonmark::SampleProgress</name>
    <message>
        <source>measuring the error on a sample</source>
        <translation>misst den Fehler an einer Stichprobe</translation>
    </message>
</context>
<context>
    <name>noonmark::SavedViews</name>
    <message>
        <source>Sa&amp;ved views</source>
        <translation>Gespeic&amp;herte Ansichten</translation>
    </message>
    <message>
        <source>&amp;Save this view</source>
        <translation>Diese Ansicht &amp;speichern</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>No view is saved yet</source>
        <translation>Noch keine Ansicht gespeichert</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>save view %1</source>
        <translation>Ansicht %1 speichern</translation>
    </message>
    <message>
        <source>Saved as &apos;%1&apos; in the project. F2 in the project&apos;s list renames it.</source>
        <translation>Im Projekt als „%1“ gespeichert. F2 in der Projektliste benennt sie um.</translation>
    </message>
    <message>
        <source>Camera, projection, section box, and date and time if a moment is shown, under a name in the project</source>
        <translation>Kamera, Projektion, Schnittbox und, wenn ein Zeitpunkt gezeigt wird, Datum und Uhrzeit unter einem Namen im Projekt</translation>
    </message>
</context>
<context>
    <name>noonmark::SavingActions</name>
    <message>
        <source>&amp;Save project</source>
        <translation>Projekt &amp;speichern</translation>
    </message>
    <message>
        <source>City, scenarios, lots, results and view in one file</source>
        <translation>Stadt, Szenarien, Grundstücke, Ergebnisse und Ansicht in einer Datei</translation>
    </message>
    <message>
        <source>Save project &amp;as...</source>
        <translation>Projekt speichern &amp;unter ...</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Speichern unter ...</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save changes to %1?</source>
        <translation>Änderungen an %1 speichern?</translation>
    </message>
    <message>
        <source>Work in progress</source>
        <translation>Arbeit im Gange</translation>
    </message>
    <message>
        <source>%1 is still running. Stop it?</source>
        <translation>%1 läuft noch. Abbrechen?</translation>
    </message>
    <message>
        <source>Stop it</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 is still running and will be stopped.</source>
        <translation>%1 läuft noch und wird beendet.</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioActions</name>
    <message>
        <source>&amp;New scenario</source>
        <translation>&amp;Neues Szenario</translation>
    </message>
    <message>
        <source>Starts from the existing city</source>
        <translation>Beginnt mit dem Bestand</translation>
    </message>
    <message>
        <source>New scenario &amp;from this one</source>
        <translation>Neues Szenario aus &amp;diesem</translation>
    </message>
    <message>
        <source>Starts from the displayed scenario and inherits its later changes</source>
        <translation>Beginnt mit dem angezeigten Szenario und übernimmt dessen spätere Änderungen</translation>
    </message>
    <message>
        <source>&amp;Compare with the existing city</source>
        <translation>Mit dem Bestand &amp;vergleichen</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Shows how many minutes of shadow the scenario adds or removes</source>
        <translation>Zeigt, wie viele Minuten Schatten das Szenario hinzufügt oder wegnimmt</translation>
    </message>
    <message>
        <source>&amp;Measure all scenarios</source>
        <translation>&amp;Alle Szenarien messen</translation>
    </message>
    <message>
        <source>Runs the same study for each scenario, for comparison side by side</source>
        <translation>Führt dieselbe Untersuchung für jedes Szenario durch, zum Vergleich nebeneinander</translation>
    </message>
    <message>
        <source>&amp;Score all scenarios</source>
        <translation>Alle Szenarien &amp;bewerten</translation>
    </message>
    <message>
        <source>Computes the scores that the panel Scenarios lacks, with the table that the panel Weights shows</source>
        <translation>Berechnet die Bewertungen, die im Feld Szenarien fehlen, mit der Tabelle im Feld Gewichte</translation>
    </message>
    <message>
        <source>&amp;Review all scenarios</source>
        <translation>Alle Szenarien &amp;prüfen</translation>
    </message>
    <message>
        <source>Reviews the scenarios whose verdicts the panel Scenarios lacks, by the rule chosen in the panel Review</source>
        <translation>Prüft die Szenarien, deren Befunde im Feld Szenarien fehlen, nach der Regel im Feld Prüfung</translation>
    </message>
    <message>
        <source>The table of scenarios is on the clipboard</source>
        <translation>Die Tabelle der Szenarien ist in der Zwischenablage</translation>
    </message>
    <message>
        <source>The existing city is displayed. Choose a scenario at the top, and compare it</source>
        <translation>Der Bestand wird angezeigt. Oben ein Szenario wählen und es vergleichen</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>&amp;Export buildings...</source>
        <translation>Gebäude &amp;exportieren ...</translation>
    </message>
    <message>
        <source>Writes the buildings that the displayed scenario proposes as glTF, OBJ, DXF or GeoPackage; of the existing city all buildings</source>
        <translation>Schreibt die Gebäude, die das angezeigte Szenario vorschlägt, als glTF, OBJ, DXF oder GeoPackage; von der bestehenden Stadt alle Gebäude</translation>
    </message>
    <message>
        <source>Export buildings</source>
        <translation>Gebäude exportieren</translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s) saved as %2</source>
        <translation>
            <numerusform>%1 Gebäude gespeichert als %2</numerusform>
            <numerusform>%1 Gebäude gespeichert als %2</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no scenario yet to compare. A change to a building begins one: click a building, and drag its arrow or type its height</source>
        <translation>Es gibt noch kein Szenario zum Vergleichen. Eine Änderung an einem Gebäude beginnt eines: ein Gebäude anklicken und seinen Pfeil ziehen oder seine Höhe eingeben</translation>
    </message>
    <message>
        <source>The table of scenarios compares the scores</source>
        <translation>Die Tabelle der Szenarien vergleicht die Bewertungen</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioBar</name>
    <message>
        <source>The displayed scenario. Edits are added to it; on the existing city they start a new scenario</source>
        <translation>Das angezeigte Szenario. Änderungen gehen hinein; am Bestand beginnen sie ein neues Szenario</translation>
    </message>
    <message>
        <source>Compare the scenario with this baseline: more or fewer minutes of shadow</source>
        <translation>Das Szenario mit diesem Stand vergleichen: mehr oder weniger Minuten Schatten</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>compare with</source>
        <translation>verglichen mit</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioCharts</name>
    <message>
        <source>No scenario has been scored by month: press Score all</source>
        <translation>Kein Szenario ist nach Monaten bewertet: Alle bewerten drücken</translation>
    </message>
    <message>
        <source>The first %1 of %2 scenarios; CSV saves all of them</source>
        <translation>Die ersten %1 von %2 Szenarien; CSV speichert alle</translation>
    </message>
    <message>
        <source>No differences: the baseline %1 lacks this figure</source>
        <translation>Keine Unterschiede: der Ausgangslage %1 fehlt diese Zahl</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV ...</translation>
    </message>
    <message>
        <source>Saves all figures of the months of all scenarios, with their differences to the baseline</source>
        <translation>Speichert alle Zahlen der Monate aller Szenarien mit ihren Unterschieden zur Ausgangslage</translation>
    </message>
    <message>
        <source>A chart of the months of all scenarios, and of their differences to the baseline</source>
        <translation>Ein Diagramm der Monate aller Szenarien und ihrer Unterschiede zur Ausgangslage</translation>
    </message>
    <message>
        <source>No chart</source>
        <translation>Kein Diagramm</translation>
    </message>
    <message>
        <source>All of these together</source>
        <translation>Alle diese zusammen</translation>
    </message>
    <message>
        <source>No scenario has months yet. %1</source>
        <translation>Noch hat kein Szenario Monate. %1</translation>
    </message>
    <message>
        <source>Measure all by month</source>
        <translation>Alle nach Monaten messen</translation>
    </message>
    <message>
        <source>No places have been measured: choose Sun by place in the panel Study, and press Measure all</source>
        <translation>Keine Orte wurden gemessen: wählen Sie im Bereich Studie Sonne nach Orten, und drücken Sie Alle messen</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioTable</name>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Double-click to show it</source>
        <translation>Doppelklick zeigt es</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>Steps from the existing city, including those of its bases</source>
        <translation>Schritte seit dem Bestand, mit denen seiner Grundlagen</translation>
    </message>
    <message>
        <source>Floor area by use</source>
        <translation>Geschossfläche nach Nutzung</translation>
    </message>
    <message>
        <source>Gross floor area of the scenario&apos;s towers by use, sorted by its sum. Imported buildings and towers whose height was changed afterwards are not counted</source>
        <translation>Bruttogrundfläche der Türme des Szenarios nach Nutzung, sortiert nach der Summe. Importierte Gebäude und Türme, deren Höhe nachträglich geändert wurde, zählen nicht mit</translation>
    </message>
    <message>
        <source>Height, %1</source>
        <translation>Höhe, %1</translation>
    </message>
    <message>
        <source>Highest point above its ground of the buildings that the scenario adds</source>
        <translation>Höchster Punkt über dem Boden der Gebäude, die das Szenario hinzufügt</translation>
    </message>
    <message>
        <source>Floor area, %1</source>
        <translation>Geschossfläche, %1</translation>
    </message>
    <message>
        <source>Gross floor area of the scenario&apos;s towers. Imported buildings and towers whose height was changed afterwards are not counted</source>
        <translation>Bruttogrundfläche der Türme des Szenarios. Importierte Gebäude und Türme, deren Höhe nachträglich geändert wurde, zählen nicht mit</translation>
    </message>
    <message>
        <source>Impact, %1</source>
        <translation>Auswirkung, %1</translation>
    </message>
    <message>
        <source>Change of the shadow area from the chosen baseline, else from the existing city, on the receivers of both</source>
        <translation>Änderung der Schattenfläche gegenüber der gewählten Ausgangslage, sonst gegenüber dem Bestand, auf den Messpunkten von beiden</translation>
    </message>
    <message>
        <source>Verdicts</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>By the rule and the baseline that the panel Review shows; sorted by the number that fail, then by borderline ones</source>
        <translation>Nach der Regel und der Ausgangslage im Feld Prüfung; sortiert nach der Zahl der nicht bestandenen, dann der grenzwertigen</translation>
    </message>
    <message>
        <source>The scenario adds no building</source>
        <translation>Das Szenario fügt kein Gebäude hinzu</translation>
    </message>
    <message>
        <source>Not computed with the current settings: press Measure all</source>
        <translation>Mit den jetzigen Einstellungen nicht berechnet: Alle messen drücken</translation>
    </message>
    <message>
        <source>With the weights %1</source>
        <translation>Mit den Gewichten %1</translation>
    </message>
    <message>
        <source>Not computed with these settings and the weights %1 since buildings last changed: press Score all</source>
        <translation>Seit der letzten Änderung der Gebäude nicht mit diesen Einstellungen und den Gewichten %1 berechnet: Alle bewerten drücken</translation>
    </message>
    <message>
        <source>%1, compared with %2</source>
        <translation>%1, verglichen mit %2</translation>
    </message>
    <message>
        <source>Not reviewed by the rule %1 since buildings or places last changed: press Review all</source>
        <translation>Seit der letzten Änderung der Gebäude oder Orte nicht nach der Regel %1 geprüft: Alle prüfen drücken</translation>
    </message>
    <message>
        <source>The other scenarios are compared with this one</source>
        <translation>Die anderen Szenarien werden mit diesem verglichen</translation>
    </message>
    <message>
        <source>Not compared with %1 with these settings since buildings last changed: press Measure all</source>
        <translation>Seit der letzten Änderung der Gebäude nicht mit diesen Einstellungen mit %1 verglichen: Alle messen drücken</translation>
    </message>
    <message>
        <source>Compared with %1. Ground whose gross shadow changes by more than %2 min a day:
%3</source>
        <translation>Verglichen mit %1. Boden, dessen Gesamtschatten sich um mehr als %2 min am Tag ändert:
%3</translation>
    </message>
    <message>
        <source>Measured earlier and saved with the project: press Measure all for the maps</source>
        <translation>Früher gemessen und mit dem Projekt gespeichert: „Alle messen“ ergibt die Karten</translation>
    </message>
    <message>
        <source>not scored</source>
        <translation>nicht bewertet</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>nicht verglichen</translation>
    </message>
    <message>
        <source>not reviewed</source>
        <translation>nicht geprüft</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>no baseline</source>
        <translation>keine Ausgangslage</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>nicht gezählt</translation>
    </message>
    <message>
        <source>starting scenario missing</source>
        <translation>Ausgangslage fehlt</translation>
    </message>
    <message>
        <source>no weights</source>
        <translation>keine Gewichte</translation>
    </message>
    <message>
        <source>no rule</source>
        <translation>keine Regel</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>Best of this column</source>
        <translation>Bester Wert dieser Spalte</translation>
    </message>
    <message>
        <source>Measured error against rays: %1</source>
        <translation>Gemessener Fehler gegen Strahlen: %1</translation>
    </message>
    <message>
        <source>%1 changes the shadow area by %2: area times its share of the sunlit time. Ground with over %3 min more shadow a day: %4.</source>
        <translation>%1 ändert die Schattenfläche um %2: Fläche mal ihr Anteil der besonnten Zeit. Boden mit über %3 min mehr Schatten am Tag: %4.</translation>
    </message>
    <message>
        <source>All scenarios change the shadow area by %1.</source>
        <translation>Alle Szenarien ändern die Schattenfläche um %1.</translation>
    </message>
    <message>
        <source>%1 adds less shadow than %2: %3 of shadow area against %4 (area times its share of the sunlit time), and %5 against %6 of ground with over %7 min more a day.</source>
        <translation>%1 fügt weniger Schatten hinzu als %2: %3 Schattenfläche gegenüber %4 (Fläche mal ihr Anteil der besonnten Zeit) und %5 gegenüber %6 Boden mit über %7 min mehr am Tag.</translation>
    </message>
    <message>
        <source>By the weights %1, %2 scores best (%3) and %4 worst (%5).</source>
        <translation>Nach den Gewichten %1 ist %2 am besten (%3) und %4 am schlechtesten bewertet (%5).</translation>
    </message>
    <message>
        <source>being scored</source>
        <translation>wird bewertet</translation>
    </message>
    <message>
        <source>being reviewed</source>
        <translation>wird geprüft</translation>
    </message>
    <message>
        <source>being measured</source>
        <translation>wird gemessen</translation>
    </message>
    <message>
        <source>Sun of places, h</source>
        <translation>Sonne der Orte, h</translation>
    </message>
    <message>
        <source>Area of places with enough sun, %</source>
        <translation>Fläche der Orte mit genug Sonne, %</translation>
    </message>
    <message numerus="yes">
        <source>Over the area of the %Ln place(s) that were measured last</source>
        <translation>
            <numerusform>Über die Fläche des %Ln zuletzt gemessenen Ortes</numerusform>
            <numerusform>Über die Fläche der %Ln zuletzt gemessenen Orte</numerusform>
        </translation>
    </message>
    <message>
        <source>Not measured since buildings last changed: choose Sun by place in the panel Study, and press Measure all</source>
        <translation>Nicht gemessen, seit sich Gebäude zuletzt geändert haben: wählen Sie im Bereich Studie Sonne nach Orten, und drücken Sie Alle messen</translation>
    </message>
</context>
<context>
    <name>noonmark::ScenariosDock</name>
    <message>
        <source>Only the existing city so far. Select a building and change it, or design a tower on a lot: the first change begins a scenario, which is listed here.</source>
        <translation>Bisher nur der Bestand. Ein Gebäude auswählen und ändern oder einen Turm auf einem Grundstück entwerfen: die erste Änderung beginnt ein Szenario, das hier steht.</translation>
    </message>
    <message>
        <source>Measure all</source>
        <translation>Alle messen</translation>
    </message>
    <message>
        <source>Runs the study for scenarios without figures, with the current period and region</source>
        <translation>Untersucht alle Szenarien ohne Zahlen, mit dem jetzigen Zeitraum und Gebiet</translation>
    </message>
    <message>
        <source>Score all</source>
        <translation>Alle bewerten</translation>
    </message>
    <message>
        <source>Computes the missing scores with the table that the panel Weights shows</source>
        <translation>Berechnet die fehlenden Bewertungen mit der Tabelle im Feld Gewichte</translation>
    </message>
    <message>
        <source>Review all</source>
        <translation>Alle prüfen</translation>
    </message>
    <message>
        <source>Reviews the scenarios without verdicts by the rule, the baseline and the places that are chosen in the panel Review</source>
        <translation>Prüft die Szenarien ohne Befunde nach Regel, Ausgangslage und Orten, die im Feld Prüfung gewählt sind</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Differenzen</translation>
    </message>
    <message>
        <source>Shows figures as differences to the baseline: the chosen one, else the existing city</source>
        <translation>Zeigt Zahlen als Differenzen zur Ausgangslage: der gewählten, sonst dem Bestand</translation>
    </message>
    <message>
        <source>Shade is wanted</source>
        <translation>Schatten ist erwünscht</translation>
    </message>
    <message>
        <source>The star marks the scenario with most shadow as the best, not that with least</source>
        <translation>Der Stern markiert das Szenario mit dem meisten Schatten als das beste, nicht das mit dem wenigsten</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copies the table for a spreadsheet</source>
        <translation>Kopiert die Tabelle für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV ...</translation>
    </message>
    <message>
        <source>Saves the table with what each scenario lacks, in metres and square metres</source>
        <translation>Speichert die Tabelle mit dem, was jedem Szenario fehlt, in Metern und Quadratmetern</translation>
    </message>
</context>
<context>
    <name>noonmark::SearchActions</name>
    <message>
        <source>&amp;Find</source>
        <translation>&amp;Suchen</translation>
    </message>
    <message>
        <source>A building by name or id, a street, a place, a lot, a position or a command</source>
        <translation>Ein Gebäude nach Name oder Kennung, eine Straße, einen Ort, ein Grundstück, eine Position oder einen Befehl</translation>
    </message>
    <message>
        <source>Nothing is called &quot;%1&quot;, and no command that can be used now. Buildings without a name are found by their id.</source>
        <translation>Nichts heißt „%1“, auch kein Befehl, der jetzt möglich ist. Gebäude ohne Namen findet man nach ihrer Kennung.</translation>
    </message>
</context>
<context>
    <name>noonmark::SearchField</name>
    <message>
        <source>Find (Ctrl+F)</source>
        <translation>Suchen (Strg+F)</translation>
    </message>
    <message>
        <source>A building by name or id, a street, a place, a lot, a position such as 40.7536, -73.9832, or a command</source>
        <translation>Ein Gebäude nach Name oder Kennung, eine Straße, ein Ort, ein Grundstück, eine Position wie 40.7536, -73.9832 oder ein Befehl</translation>
    </message>
</context>
<context>
    <name>noonmark::SectionDialog</name>
    <message>
        <source>Section box</source>
        <translation>Schnittbox</translation>
    </message>
    <message>
        <source>West</source>
        <translation>Westen</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Osten</translation>
    </message>
    <message>
        <source>South</source>
        <translation>Süden</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Norden</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>From the origin of the project, to the east and to the north</source>
        <translation>Vom Ursprung des Projekts nach Osten und nach Norden</translation>
    </message>
    <message>
        <source>Height above the origin of the project</source>
        <translation>Höhe über dem Ursprung des Projekts</translation>
    </message>
    <message>
        <source>What the view shows</source>
        <translation>Was die Ansicht zeigt</translation>
    </message>
    <message>
        <source>The box around the ground in view</source>
        <translation>Der Quader um den sichtbaren Boden</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>The box around the whole city</source>
        <translation>Der Quader um die ganze Stadt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Shows everything again</source>
        <translation>Zeigt wieder alles</translation>
    </message>
</context>
<context>
    <name>noonmark::SelectionPanel</name>
    <message>
        <source>Import mesh...</source>
        <translation>3D-Modell einfügen ...</translation>
    </message>
    <message>
        <source>Demolish</source>
        <translation>Abreißen</translation>
    </message>
    <message>
        <source>Removes the building (Delete)</source>
        <translation>Entfernt das Gebäude (Entf)</translation>
    </message>
    <message>
        <source>Replace by tower</source>
        <translation>Durch Turm ersetzen</translation>
    </message>
    <message>
        <source>Replaces it by a tower on its lot or, if it has none, on its footprint</source>
        <translation>Ersetzt es durch einen Turm auf seinem Grundstück oder, wenn es keines hat, auf seinem Grundriss</translation>
    </message>
    <message>
        <source>Lot from footprint</source>
        <translation>Grundstück aus Grundriss</translation>
    </message>
    <message>
        <source>Creates a lot from its outline on the ground</source>
        <translation>Legt aus seinem Umriss auf dem Boden ein Grundstück an</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Drag the building over the ground; Esc ends the tool</source>
        <translation>Das Gebäude über den Boden ziehen; Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Clockwise about its middle. Press Enter to apply</source>
        <translation>Im Uhrzeigersinn um seine Mitte. Eingabe übernimmt</translation>
    </message>
    <message>
        <source>Negative: west, south. Press Enter to apply</source>
        <translation>Negativ: nach Westen, Süden. Eingabe übernimmt</translation>
    </message>
    <message>
        <source>Move east</source>
        <translation>Nach Osten</translation>
    </message>
    <message>
        <source>Move north</source>
        <translation>Nach Norden</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Same floor area on its lot:</source>
        <translation>Gleiche Geschossfläche auf seinem Grundstück:</translation>
    </message>
    <message>
        <source>Wider</source>
        <translation>Breiter</translation>
    </message>
    <message>
        <source>Shorter, on a floor plate twice as large</source>
        <translation>Niedriger, auf einer doppelt so großen Platte</translation>
    </message>
    <message>
        <source>Widest</source>
        <translation>Am breitesten</translation>
    </message>
    <message>
        <source>As short as the lot allows</source>
        <translation>So niedrig, wie das Grundstück zulässt</translation>
    </message>
    <message>
        <source>Slimmer</source>
        <translation>Schlanker</translation>
    </message>
    <message>
        <source>Taller, on half the floor plate</source>
        <translation>Höher, auf der halben Platte</translation>
    </message>
    <message>
        <source>%1 to %2 above the ground; View &gt; Heights above datum shows it as an elevation. Or drag the arrow on the building. Press Enter to apply</source>
        <translation>%1 bis %2 über Gelände; Ansicht &gt; Höhen über Bezugsniveau zeigt sie als absolute Höhe. Oder den Pfeil am Gebäude ziehen. Eingabe übernimmt</translation>
    </message>
    <message>
        <source>Top above datum</source>
        <translation>Oberkante über Bezugsniveau</translation>
    </message>
    <message>
        <source>Height above ground</source>
        <translation>Höhe über Gelände</translation>
    </message>
    <message>
        <source>Demolish all</source>
        <translation>Alle abreißen</translation>
    </message>
    <message>
        <source>Removes the selected buildings, as one step of undo (Delete)</source>
        <translation>Entfernt die ausgewählten Gebäude, als ein Schritt zum Rückgängigmachen (Entf)</translation>
    </message>
    <message>
        <source>Click a building in the view to select it. Ctrl+click selects another too, a drag with Ctrl+Shift all in a rectangle.</source>
        <translation>Ein Gebäude in der Ansicht anklicken wählt es aus. Strg+Klick wählt ein weiteres dazu, Ziehen mit Strg+Umschalt alle in einem Rechteck.</translation>
    </message>
    <message>
        <source>Adds a building from a file (%1), placed by a click on the ground</source>
        <translation>Fügt ein Gebäude aus einer Datei (%1) hinzu, platziert durch einen Klick auf den Boden</translation>
    </message>
    <message>
        <source>Edit tower</source>
        <translation>Turm bearbeiten</translation>
    </message>
    <message>
        <source>Designs the tower further, with the values it was built with</source>
        <translation>Entwirft den Turm weiter, mit den Werten, mit denen er gebaut wurde</translation>
    </message>
</context>
<context>
    <name>noonmark::SetbackTable</name>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Add setback</source>
        <translation>Rücksprung hinzufügen</translation>
    </message>
    <message>
        <source>Above each height the walls are set back by the inset, from bottom to top; taper and twist are those of the volume above it</source>
        <translation>Über jeder Höhe springen die Wände um den Rücksprung zurück, von unten nach oben; Verjüngung und Verdrehung gelten für den Baukörper darüber</translation>
    </message>
    <message>
        <source>Height from which the walls are set back</source>
        <translation>Höhe, ab der die Wände zurückspringen</translation>
    </message>
    <message>
        <source>How far every wall is set back, from the top of the volume below</source>
        <translation>Wie weit jede Wand zurückspringt, von der Oberkante des Baukörpers darunter</translation>
    </message>
    <message>
        <source>Adds a setback above the others</source>
        <translation>Fügt einen Rücksprung über den anderen hinzu</translation>
    </message>
    <message>
        <source>Removes the selected setback, or the last one</source>
        <translation>Entfernt den gewählten Rücksprung oder den letzten</translation>
    </message>
</context>
<context>
    <name>noonmark::ShadowCache::State</name>
    <message>
        <source>filling shadows</source>
        <translation>füllt Schatten</translation>
    </message>
</context>
<context>
    <name>noonmark::ShadowProjection</name>
    <message>
        <source>filling shadows</source>
        <translation>füllt Schatten</translation>
    </message>
</context>
<context>
    <name>noonmark::SheetForm</name>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Title block (saved in the project)</source>
        <translation>Schriftfeld (im Projekt gespeichert)</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Hochformat</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Querformat</translation>
    </message>
    <message>
        <source>Scale of diagrams</source>
        <translation>Maßstab der Pläne</translation>
    </message>
    <message>
        <source>A scale from 1:%1 to 1:%2 may be typed. Where a place or its shadows are larger than the paper at that scale, the diagram shows the part around the place.</source>
        <translation>Ein Maßstab von 1:%1 bis 1:%2 kann getippt werden. Sind ein Ort oder seine Schatten dabei größer als das Papier, zeigt der Plan den Teil um den Ort.</translation>
    </message>
    <message>
        <source>fits the page</source>
        <translation>passt auf die Seite</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Of areas, lengths and heights</source>
        <translation>Von Flächen, Längen und Höhen</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Wählen ...</translation>
    </message>
    <message>
        <source>A PNG or JPEG picture of at most 1 MiB</source>
        <translation>Ein PNG- oder JPEG-Bild von höchstens 1 MiB</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Sheets without a logo</source>
        <translation>Blätter ohne Logo</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
</context>
<context>
    <name>noonmark::StartPage</name>
    <message>
        <source>Open a city</source>
        <translation>Eine Stadt öffnen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes the start page (Esc)</source>
        <translation>Schließt die Startseite (Esc)</translation>
    </message>
    <message>
        <source>Drop files or a folder here: OpenStreetMap, GeoPackage, CityJSON, CityGML, IFC, meshes, terrain.</source>
        <translation>Dateien oder einen Ordner hier ablegen: OpenStreetMap, GeoPackage, CityJSON, CityGML, IFC, 3D-Modelle, Gelände.</translation>
    </message>
    <message>
        <source>Open file...</source>
        <translation>Datei öffnen ...</translation>
    </message>
    <message>
        <source>A project or city files (Ctrl+O)</source>
        <translation>Ein Projekt oder Stadtdateien (Strg+O)</translation>
    </message>
    <message>
        <source>Open folder...</source>
        <translation>Ordner öffnen ...</translation>
    </message>
    <message>
        <source>A folder of city files, such as tiles or a file geodatabase</source>
        <translation>Ein Ordner mit Stadtdateien, etwa Kacheln oder eine File-Geodatabase</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>No longer there: %1</source>
        <translation>Nicht mehr vorhanden: %1</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Central Park South</source>
        <translation>Central Park South</translation>
    </message>
    <message>
        <source>The park, its streets and the towers of the case study</source>
        <translation>Der Park, seine Straßen und die Türme der Fallstudie</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>A synthetic city of blocks and lots</source>
        <translation>Eine synthetische Stadt aus Blöcken und Grundstücken</translation>
    </message>
    <message>
        <source>Guided tours and help</source>
        <translation>Führungen und Hilfe</translation>
    </message>
    <message>
        <source>User guide (F1)</source>
        <translation>Handbuch (F1)</translation>
    </message>
    <message>
        <source>How to study, compare and review</source>
        <translation>Wie man untersucht, vergleicht und prüft</translation>
    </message>
    <message>
        <source>What do you want to know?</source>
        <translation>Was möchten Sie wissen?</translation>
    </message>
    <message>
        <source>Of which city?</source>
        <translation>Über welche Stadt?</translation>
    </message>
</context>
<context>
    <name>noonmark::StudyActions</name>
    <message>
        <source>&amp;Run</source>
        <translation>Be&amp;rechnen</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Compute the shadow in the region</source>
        <translation>Den Schatten im Gebiet berechnen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Ab&amp;brechen</translation>
    </message>
    <message>
        <source>Ctrl+.</source>
        <translation>Ctrl+.</translation>
    </message>
    <message>
        <source>Stop the study that is running</source>
        <translation>Die laufende Untersuchung anhalten</translation>
    </message>
    <message>
        <source>Show &amp;gross shadow</source>
        <translation>&amp;Gesamtschatten zeigen</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>Minutes in shadow per day</source>
        <translation>Minuten im Schatten am Tag</translation>
    </message>
    <message>
        <source>Show c&amp;ontinuous shadow</source>
        <translation>&amp;Dauerschatten zeigen</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>Longest unbroken run in shadow</source>
        <translation>Längster ununterbrochener Schatten</translation>
    </message>
    <message>
        <source>period</source>
        <translation>Zeitraum</translation>
    </message>
    <message>
        <source>save period %1</source>
        <translation>Zeitraum %1 speichern</translation>
    </message>
    <message>
        <source>%1 was compared with %2 when the project was saved. Run (Ctrl+R) repeats the comparison, in %3.</source>
        <translation>%1 war mit %2 verglichen, als das Projekt gespeichert wurde. Berechnen (Strg+R) wiederholt den Vergleich, Dauer %3.</translation>
    </message>
    <message>
        <source>A study was shown when the project was saved. Run (Ctrl+R) computes it again, in %1.</source>
        <translation>Eine Untersuchung war gezeigt, als das Projekt gespeichert wurde. Berechnen (Strg+R) wiederholt sie, Dauer %1.</translation>
    </message>
    <message>
        <source>This study takes %1 (%2). The accuracy Quick takes %3 and measures its error against rays.</source>
        <translation>Diese Untersuchung dauert %1 (%2). Die Genauigkeit Schnell braucht %3 und misst ihren Fehler gegen Strahlen.</translation>
    </message>
    <message>
        <source>Run quickly</source>
        <translation>Schnell berechnen</translation>
    </message>
    <message>
        <source>Run it all the same</source>
        <translation>Trotzdem berechnen</translation>
    </message>
    <message>
        <source>This study takes %1 (%2). Larger cells, fewer days or a smaller region make it quicker.</source>
        <translation>Diese Untersuchung dauert %1 (%2). Größere Zellen, weniger Tage oder ein kleineres Gebiet machen sie schneller.</translation>
    </message>
    <message>
        <source>Cancelled. The previous answer is shown.</source>
        <translation>Abgebrochen. Die vorige Antwort wird gezeigt.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>The project holds what was measured: %1.</source>
        <translation>Das Projekt enthält, was gemessen wurde: %1.</translation>
    </message>
    <message>
        <source>The project holds %1 answers, all in the list of Results; among them %2.</source>
        <translation>Das Projekt enthält %1 Antworten, alle in der Liste der Ergebnisse; darunter %2.</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Anzeigen</translation>
    </message>
</context>
<context>
    <name>noonmark::StudyDock</name>
    <message>
        <source>Compute the minutes of shadow in every cell of the region (Ctrl+R)</source>
        <translation>Die Minuten Schatten in jeder Zelle des Gebiets berechnen (Strg+R)</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>How exactly</source>
        <translation>Wie genau</translation>
    </message>
    <message>
        <source>receivers</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>This method works on level ground only, but %1. Choose Quick or Reference.</source>
        <translation>Dieses Verfahren gilt nur für ebenen Boden, aber %1. Schnell oder Referenz wählen.</translation>
    </message>
    <message>
        <source>roofs are to be measured</source>
        <translation>Dächer sollen gemessen werden</translation>
    </message>
    <message>
        <source>this city has terrain</source>
        <translation>diese Stadt hat Gelände</translation>
    </message>
    <message>
        <source>Choose a rule</source>
        <translation>Regel wählen</translation>
    </message>
    <message>
        <source>Run again</source>
        <translation>Neu berechnen</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Run study</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>This method measures no facades, windows or planes. Choose Quick or Reference.</source>
        <translation>Dieses Verfahren misst keine Fassaden, Fenster oder Ebenen. Wählen Sie Schnell oder Referenz.</translation>
    </message>
    <message>
        <source>period</source>
        <translation>Zeitraum</translation>
    </message>
    <message>
        <source>Run (%1)</source>
        <translation>Berechnen (%1)</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Compute score</source>
        <translation>Bewertung berechnen</translation>
    </message>
    <message>
        <source>The time that it takes is being estimated</source>
        <translation>Die Dauer wird geschätzt</translation>
    </message>
</context>
<context>
    <name>noonmark::SunShadow</name>
    <message>
        <source>Drawing the shadow</source>
        <translation>Der Schatten wird gezeichnet</translation>
    </message>
</context>
<context>
    <name>noonmark::SurfaceTracer</name>
    <message>
        <source>tracing rays</source>
        <translation>verfolgt Strahlen</translation>
    </message>
</context>
<context>
    <name>noonmark::TargetRow</name>
    <message>
        <source>Floor area</source>
        <translation>Geschossfläche</translation>
    </message>
    <message>
        <source>FAR</source>
        <translation>GFZ</translation>
    </message>
    <message>
        <source>Gross floor area, or floor area ratio: gross floor area divided by the lot&apos;s area</source>
        <translation>Bruttogeschossfläche oder Geschossflächenzahl: Bruttogeschossfläche geteilt durch die Fläche des Grundstücks</translation>
    </message>
    <message>
        <source>Fit storeys</source>
        <translation>Geschosse anpassen</translation>
    </message>
    <message>
        <source>The most storeys that stay within it</source>
        <translation>Die meisten Geschosse, die darunter bleiben</translation>
    </message>
    <message>
        <source>Fit plate</source>
        <translation>Platte anpassen</translation>
    </message>
    <message>
        <source>The floor plate with which these storeys reach it</source>
        <translation>Die Geschossplatte, mit der diese Geschosse es erreichen</translation>
    </message>
    <message>
        <source> sq ft</source>
        <translation> sq ft</translation>
    </message>
    <message>
        <source>What the tower shall have: type it, and storeys or plate are fitted; else what it has</source>
        <translation>Was der Turm haben soll: Ist es getippt, werden Geschosse oder Grundriss angepasst; sonst, was er hat</translation>
    </message>
</context>
<context>
    <name>noonmark::ThemeMenu</name>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>C&amp;olours</source>
        <translation>Far&amp;ben</translation>
    </message>
</context>
<context>
    <name>noonmark::TileDialog</name>
    <message>
        <source>Aerial photograph from tiles</source>
        <translation>Luftbild aus Kacheln</translation>
    </message>
    <message>
        <source>Address of the tiles, with {z} for the zoom, {x} and {y} for the tile</source>
        <translation>Adresse der Kacheln, mit {z} für die Zoomstufe, {x} und {y} für die Kachel</translation>
    </message>
    <message>
        <source>Whose tiles they are, as their owner asks for; printed wherever they are drawn</source>
        <translation>Wem die Kacheln gehören, wie es ihr Eigentümer verlangt; gedruckt, wo immer sie gezeichnet sind</translation>
    </message>
    <message>
        <source>Nothing is fetched before the button is pressed. Tiles of zoom %1: %2. Ask their owner whether you may store and print them.</source>
        <translation>Vor dem Knopfdruck wird nichts geholt. Kacheln der Zoomstufe %1: %2. Fragen Sie ihren Eigentümer, ob Sie sie speichern und drucken dürfen.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Attribution</source>
        <translation>Quellenangabe</translation>
    </message>
    <message>
        <source>Fetch tiles</source>
        <translation>Kacheln holen</translation>
    </message>
    <message>
        <source>Fetches the tiles over the city from this address</source>
        <translation>Holt die Kacheln über der Stadt von dieser Adresse</translation>
    </message>
</context>
<context>
    <name>noonmark::TileFetch</name>
    <message>
        <source>%1 is no picture of a tile</source>
        <translation>%1 ist kein Bild einer Kachel</translation>
    </message>
    <message>
        <source>The server has no tile of this place</source>
        <translation>Der Server hat keine Kachel dieses Ortes</translation>
    </message>
</context>
<context>
    <name>noonmark::TimeDisplay</name>
    <message>
        <source>&amp;Play the sun</source>
        <translation>Sonne ab&amp;spielen</translation>
    </message>
    <message>
        <source>Shift+Space</source>
        <translation>Shift+Space</translation>
    </message>
    <message>
        <source>Plays or stops the sun and its shadows</source>
        <translation>Spielt die Sonne und ihre Schatten ab oder hält sie an</translation>
    </message>
    <message>
        <source>Ten minutes &amp;later</source>
        <translation>Zehn Minuten s&amp;päter</translation>
    </message>
    <message>
        <source>The sun ten minutes later</source>
        <translation>Die Sonne zehn Minuten später</translation>
    </message>
    <message>
        <source>Ten minutes &amp;earlier</source>
        <translation>Zehn Minuten f&amp;rüher</translation>
    </message>
    <message>
        <source>The sun ten minutes earlier</source>
        <translation>Die Sonne zehn Minuten früher</translation>
    </message>
    <message>
        <source>&amp;Next day</source>
        <translation>&amp;Nächster Tag</translation>
    </message>
    <message>
        <source>The sun at the same time of the next day</source>
        <translation>Die Sonne zur selben Zeit am nächsten Tag</translation>
    </message>
    <message>
        <source>Previous &amp;day</source>
        <translation>&amp;Voriger Tag</translation>
    </message>
    <message>
        <source>The sun at the same time of the day before</source>
        <translation>Die Sonne zur selben Zeit am Tag davor</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>period</source>
        <translation>Zeitraum</translation>
    </message>
    <message>
        <source>The sun is down or low there now, so this is noon: %1</source>
        <translation>Die Sonne steht dort jetzt tief oder ist untergegangen, darum ist dies Mittag: %1</translation>
    </message>
</context>
<context>
    <name>noonmark::TimeStrip</name>
    <message>
        <source>Whole period</source>
        <translation>Ganzer Zeitraum</translation>
    </message>
    <message>
        <source>One day</source>
        <translation>Ein Tag</translation>
    </message>
    <message>
        <source>One moment</source>
        <translation>Ein Zeitpunkt</translation>
    </message>
    <message>
        <source>What is shown: the whole period; one day of a study, from horizons cached in steps of half a degree;
or sun and shadow at one moment, on everything</source>
        <translation>Was gezeigt wird: der ganze Zeitraum; ein Tag einer Untersuchung, aus gespeicherten Horizonten in halben Grad;
oder Sonne und Schatten zu einem Zeitpunkt, auf allem</translation>
    </message>
    <message>
        <source>The date, in the year of the period. Arrows: a day; Page Up and Down: a month</source>
        <translation>Das Datum im Jahr des Zeitraums. Pfeile: ein Tag; Bild auf und ab: ein Monat</translation>
    </message>
    <message>
        <source>The wall-clock time; yellow: the sun is up. Arrows: a minute; Page Up and Down: an hour</source>
        <translation>Die Uhrzeit; gelb: die Sonne ist oben. Pfeile: eine Minute; Bild auf und ab: eine Stunde</translation>
    </message>
    <message>
        <source>Direction of the sun, clockwise from true north, and its altitude</source>
        <translation>Richtung der Sonne im Uhrzeigersinn von geografisch Nord, und ihre Höhe</translation>
    </message>
    <message>
        <source>Set as period</source>
        <translation>Als Zeitraum</translation>
    </message>
    <message>
        <source>Makes this day or moment the period of the study; Run then computes its figures and errors</source>
        <translation>Macht diesen Tag oder Zeitpunkt zum Zeitraum der Untersuchung; Berechnen liefert dann Zahlen und Fehler</translation>
    </message>
    <message>
        <source>Plays the sun and its shadows (Shift+Space)</source>
        <translation>Spielt die Sonne und ihre Schatten ab (Umschalt+Leertaste)</translation>
    </message>
    <message>
        <source>through the day</source>
        <translation>durch den Tag</translation>
    </message>
    <message>
        <source>through the year</source>
        <translation>durch das Jahr</translation>
    </message>
    <message>
        <source>Play from sunrise to sunset of one date, or one time of day through the year</source>
        <translation>Von Sonnenaufgang bis -untergang eines Datums abspielen oder eine Uhrzeit durch das Jahr</translation>
    </message>
    <message>
        <source>slowly</source>
        <translation>langsam</translation>
    </message>
    <message>
        <source>steadily</source>
        <translation>stetig</translation>
    </message>
    <message>
        <source>fast</source>
        <translation>schnell</translation>
    </message>
    <message>
        <source>Half an hour, an hour and a half or four hours of the day in a second;
of the year, as many weeks</source>
        <translation>Eine halbe, anderthalb oder vier Stunden des Tages in einer Sekunde;
vom Jahr ebenso viele Wochen</translation>
    </message>
    <message>
        <source>d MMM</source>
        <translation>d.M.</translation>
    </message>
    <message>
        <source>The date: 21 Dec, 12-21, or 21 for a day of this month</source>
        <translation>Das Datum: 21. Dez, 12-21 oder 21 für einen Tag dieses Monats</translation>
    </message>
    <message>
        <source>The wall-clock time: 14:30, 1430, or 14</source>
        <translation>Die Uhrzeit: 14:30, 1430 oder 14</translation>
    </message>
</context>
<context>
    <name>noonmark::Tour</name>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 von %3)</translation>
    </message>
</context>
<context>
    <name>noonmark::TourBubble</name>
    <message>
        <source>Show me</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Does this step for you</source>
        <translation>Führt diesen Schritt für Sie aus</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>End tour</source>
        <translation>Führung beenden</translation>
    </message>
    <message>
        <source>Help &gt; Guided tours starts it again</source>
        <translation>Hilfe &gt; Führungen startet sie wieder</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
</context>
<context>
    <name>noonmark::TowerDisplay</name>
    <message>
        <source>Store&amp;y lines</source>
        <translation>Geschoss&amp;linien</translation>
    </message>
    <message>
        <source>Lines at the floors of proposed towers, and of imported buildings whose storey height is known</source>
        <translation>Linien an den Geschossdecken geplanter Türme und importierter Gebäude mit bekannter Geschosshöhe</translation>
    </message>
    <message>
        <source>&amp;Heights above datum</source>
        <translation>Höhen über Bez&amp;ugsniveau</translation>
    </message>
    <message>
        <source>Heights of buildings above the vertical zero of the project&apos;s terrain instead of above the ground under each building, as shown and as typed</source>
        <translation>Gebäudehöhen über dem Höhennullpunkt des Projektgeländes statt über dem Gelände unter jedem Gebäude, angezeigt und eingegeben</translation>
    </message>
</context>
<context>
    <name>noonmark::TowerEditing</name>
    <message>
        <source>Build %1</source>
        <translation>%1 bauen</translation>
    </message>
</context>
<context>
    <name>noonmark::Tracer</name>
    <message>
        <source>tracing rays</source>
        <translation>verfolgt Strahlen</translation>
    </message>
</context>
<context>
    <name>noonmark::TreeActions</name>
    <message>
        <source>Add trees</source>
        <translation>Bäume hinzufügen</translation>
    </message>
    <message>
        <source>Inventories of trees and canopy heights</source>
        <translation>Baumkataster und Höhen des Kronendachs</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Listing fields</source>
        <translation>Felder werden aufgelistet</translation>
    </message>
    <message>
        <source>Reading trees</source>
        <translation>Bäume werden gelesen</translation>
    </message>
    <message>
        <source>add trees</source>
        <translation>Bäume hinzufügen</translation>
    </message>
</context>
<context>
    <name>noonmark::TreeEditing</name>
    <message numerus="yes">
        <source>plant %1 tree(s)</source>
        <translation>
            <numerusform>%1 Baum pflanzen</numerusform>
            <numerusform>%1 Bäume pflanzen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>move %1 tree(s)</source>
        <translation>
            <numerusform>%1 Baum versetzen</numerusform>
            <numerusform>%1 Bäume versetzen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>fell %1 tree(s)</source>
        <translation>
            <numerusform>%1 Baum fällen</numerusform>
            <numerusform>%1 Bäume fällen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>replace %1 tree(s)</source>
        <translation>
            <numerusform>%1 Baum ersetzen</numerusform>
            <numerusform>%1 Bäume ersetzen</numerusform>
        </translation>
    </message>
    <message>
        <source>let trees grow by %1 years</source>
        <translation>Bäume %1 Jahre wachsen lassen</translation>
    </message>
    <message>
        <source>Crowns of the other trees</source>
        <translation>Kronen der anderen Bäume</translation>
    </message>
    <message>
        <source>With trees and their seasons, while they move</source>
        <translation>Mit Bäumen und ihren Jahreszeiten, während sie bewegt werden</translation>
    </message>
    <message>
        <source>With trees as evergreens, while they move</source>
        <translation>Mit Bäumen als Immergrünen, während sie bewegt werden</translation>
    </message>
</context>
<context>
    <name>noonmark::TreeImportDialog</name>
    <message>
        <source>Add trees</source>
        <translation>Bäume hinzufügen</translation>
    </message>
    <message>
        <source>as in the file (example: EPSG:2263)</source>
        <translation>wie in der Datei (Beispiel: EPSG:2263)</translation>
    </message>
    <message>
        <source>Coordinate reference system, if the file does not state it</source>
        <translation>Koordinatenreferenzsystem, falls die Datei es nicht angibt</translation>
    </message>
    <message>
        <source>Coordinate system</source>
        <translation>Koordinatensystem</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Adds the trees to the existing city; Undo takes them back</source>
        <translation>Fügt die Bäume der bestehenden Stadt hinzu; Rückgängig nimmt sie zurück</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>classes</source>
        <translation>Klassen</translation>
    </message>
    <message>
        <source>Unit of numbers without one</source>
        <translation>Einheit von Zahlen ohne Einheit</translation>
    </message>
    <message>
        <source>Reading the trees...</source>
        <translation>Die Bäume werden gelesen ...</translation>
    </message>
</context>
<context>
    <name>noonmark::TreePanel</name>
    <message>
        <source>Species not known</source>
        <translation>Art nicht bekannt</translation>
    </message>
    <message>
        <source>evergreen</source>
        <translation>immergrün</translation>
    </message>
    <message>
        <source>loses its leaves</source>
        <translation>wirft die Blätter ab</translation>
    </message>
    <message>
        <source>%1, %2 high, crown %3, %4</source>
        <translation>%1, %2 hoch, Krone %3, %4</translation>
    </message>
    <message>
        <source> years</source>
        <translation> Jahre</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>Pflanzen</translation>
    </message>
    <message>
        <source>Each click on the ground plants a tree; Esc ends</source>
        <translation>Jeder Klick auf den Boden pflanzt einen Baum; Esc beendet</translation>
    </message>
    <message>
        <source>Plant a row</source>
        <translation>Reihe pflanzen</translation>
    </message>
    <message>
        <source>Click the corners of a line; a double click or Enter plants trees along it</source>
        <translation>Klicken Sie die Ecken einer Linie; ein Doppelklick oder die Eingabetaste pflanzt Bäume entlang der Linie</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Puts trees with the measures above in place of the chosen ones</source>
        <translation>Setzt Bäume mit den Maßen oben an die Stelle der gewählten</translation>
    </message>
    <message>
        <source>Fell</source>
        <translation>Fällen</translation>
    </message>
    <message>
        <source>Removes the chosen trees (Delete)</source>
        <translation>Entfernt die gewählten Bäume (Entf)</translation>
    </message>
    <message>
        <source>Let grow</source>
        <translation>Wachsen lassen</translation>
    </message>
    <message>
        <source>The chosen trees after these years; all of the city if none is chosen</source>
        <translation>Die gewählten Bäume nach diesen Jahren; alle der Stadt, wenn keiner gewählt ist</translation>
    </message>
    <message>
        <source>Distance between the trees of a row</source>
        <translation>Abstand zwischen den Bäumen einer Reihe</translation>
    </message>
    <message>
        <source>Years of growth, of which crown and height are estimated</source>
        <translation>Jahre des Wachstums, aus denen Krone und Höhe geschätzt werden</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message numerus="yes">
        <source>%1 tree(s) in the city. Click one to choose it, Ctrl adds more</source>
        <translation>
            <numerusform>%1 Baum in der Stadt. Ein Klick wählt ihn</numerusform>
            <numerusform>%1 Bäume in der Stadt. Ein Klick wählt einen, Strg weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 trees chosen</source>
        <translation>%1 Bäume gewählt</translation>
    </message>
    <message>
        <source>Read trees of a file...</source>
        <translation>Bäume einer Datei lesen ...</translation>
    </message>
    <message>
        <source>Adds an inventory, OpenStreetMap or a raster of canopy heights to the existing city</source>
        <translation>Fügt der bestehenden Stadt ein Baumkataster, OpenStreetMap oder ein Raster von Kronenhöhen hinzu</translation>
    </message>
    <message>
        <source>The city has no trees yet. Plant some, or read those of a file</source>
        <translation>Die Stadt hat noch keine Bäume. Pflanzen Sie welche, oder lesen Sie die einer Datei</translation>
    </message>
    <message>
        <source>loses its leaves (days of its own)</source>
        <translation>verliert sein Laub (eigene Tage)</translation>
    </message>
    <message>
        <source>Whole region</source>
        <translation>Ganzes Gebiet</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Sun, min a day</source>
        <translation>Sonne, min am Tag</translation>
    </message>
    <message>
        <source>Shadow, min a day</source>
        <translation>Schatten, min am Tag</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
</context>
<context>
    <name>noonmark::UseTable</name>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Nutzung</translation>
    </message>
    <message>
        <source>Storeys</source>
        <translation>Geschosse</translation>
    </message>
    <message>
        <source>What the storeys are used for, from the ground floor up: retail 2, offices 10, homes the rest</source>
        <translation>Wofür die Geschosse genutzt werden, vom Erdgeschoss aufwärts: Handel 2, Büros 10, Wohnungen der Rest</translation>
    </message>
    <message>
        <source>Add use</source>
        <translation>Nutzung hinzufügen</translation>
    </message>
    <message>
        <source>Adds a use for the storeys above the others</source>
        <translation>Fügt eine Nutzung für die Geschosse über den anderen hinzu</translation>
    </message>
    <message>
        <source>Removes the selected use, or the last one</source>
        <translation>Entfernt die gewählte Nutzung oder die letzte</translation>
    </message>
    <message>
        <source>Retail</source>
        <translation>Handel</translation>
    </message>
    <message>
        <source>Offices</source>
        <translation>Büros</translation>
    </message>
    <message>
        <source>Homes</source>
        <translation>Wohnungen</translation>
    </message>
    <message>
        <source>Hotel</source>
        <translation>Hotel</translation>
    </message>
    <message>
        <source>Community</source>
        <translation>Gemeinbedarf</translation>
    </message>
    <message>
        <source>Parking</source>
        <translation>Parken</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>A use of the list, or any other text</source>
        <translation>Eine Nutzung der Liste oder ein beliebiger Text</translation>
    </message>
    <message>
        <source>the rest</source>
        <translation>der Rest</translation>
    </message>
    <message>
        <source>How many storeys; 0: all storeys above, for the last use</source>
        <translation>Wie viele Geschosse; 0: alle Geschosse darüber, für die letzte Nutzung</translation>
    </message>
</context>
<context>
    <name>noonmark::VerdictLinks</name>
    <message>
        <source>%1: %2 compared with %3</source>
        <translation>%1: %2 verglichen mit %3</translation>
    </message>
</context>
<context>
    <name>noonmark::VerdictTable</name>
    <message>
        <source>Place and day</source>
        <translation>Ort und Tag</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Tag</translation>
    </message>
</context>
<context>
    <name>noonmark::ViewActions</name>
    <message>
        <source>Zoom to whole &amp;city</source>
        <translation>Ganze &amp;Stadt</translation>
    </message>
    <message>
        <source>&amp;North up</source>
        <translation>&amp;Norden oben</translation>
    </message>
    <message>
        <source>&amp;Top view</source>
        <translation>&amp;Draufsicht</translation>
    </message>
    <message>
        <source>Zoom to &amp;region</source>
        <translation>&amp;Gebiet zeigen</translation>
    </message>
    <message>
        <source>The study region seen from above</source>
        <translation>Das Untersuchungsgebiet von oben</translation>
    </message>
    <message>
        <source>&amp;Solid buildings</source>
        <translation>Gebäude ausgef&amp;üllt</translation>
    </message>
    <message>
        <source>Off: wireframe, so that the ground behind buildings is visible</source>
        <translation>Aus: Drahtmodell, damit der Boden hinter Gebäuden sichtbar ist</translation>
    </message>
    <message>
        <source>&amp;Map on the ground</source>
        <translation>&amp;Karte auf dem Boden</translation>
    </message>
    <message>
        <source>Streets, paths, parks, water and trees, drawn for orientation</source>
        <translation>Straßen, Wege, Parks, Wasser und Bäume zur Orientierung</translation>
    </message>
    <message>
        <source>&amp;Explore by shadow accrual maps</source>
        <translation>&amp;Erkundung mit Akkumulationskarten</translation>
    </message>
    <message>
        <source>As in the paper, instead of rays: inexact at shadow edges, but hours that look alike are computed once</source>
        <translation>Wie im Artikel statt mit Strahlen: an Schattenkanten ungenau, aber ähnliche Stunden werden nur einmal berechnet</translation>
    </message>
    <message>
        <source>Me&amp;asure distances</source>
        <translation>Abst&amp;ände messen</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>Click points on roofs, walls and ground: distance, height, area. Backspace removes the last point, a double click ends</source>
        <translation>Punkte auf Dächern, Wänden und Boden anklicken: Abstand, Höhe, Fläche. Rücktaste entfernt den letzten Punkt, ein Doppelklick beendet</translation>
    </message>
    <message>
        <source>Section bo&amp;x</source>
        <translation>Schnittbo&amp;x</translation>
    </message>
    <message>
        <source>Shift+X</source>
        <translation>Shift+X</translation>
    </message>
    <message>
        <source>Cuts away what lies outside a box, by handles or numbers; shadows remain those of the whole city</source>
        <translation>Schneidet weg, was außerhalb eines Quaders liegt, mit Griffen oder Zahlen; die Schatten bleiben die der ganzen Stadt</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Bäume</translation>
    </message>
    <message>
        <source>The trees of the city, bare on days without leaves</source>
        <translation>Die Bäume der Stadt, kahl an Tagen ohne Laub</translation>
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
        <translation>Ansicht der Stadt</translation>
    </message>
    <message>
        <source>Arrow keys pan, plus and minus zoom; Ctrl+F1 lists all keys</source>
        <translation>Pfeiltasten verschieben, Plus und Minus zoomen; Ctrl+F1 listet alle Tasten auf</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Gebiet</translation>
    </message>
</context>
<context>
    <name>noonmark::ViewPresets</name>
    <message>
        <source>From the &amp;south</source>
        <translation>Von &amp;Süden</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>From the &amp;east</source>
        <translation>Von &amp;Osten</translation>
    </message>
    <message>
        <source>Shift+E</source>
        <translation>Shift+E</translation>
    </message>
    <message>
        <source>From the &amp;north</source>
        <translation>Von &amp;Norden</translation>
    </message>
    <message>
        <source>Shift+N</source>
        <translation>Shift+N</translation>
    </message>
    <message>
        <source>From the &amp;west</source>
        <translation>Von &amp;Westen</translation>
    </message>
    <message>
        <source>Shift+W</source>
        <translation>Shift+W</translation>
    </message>
    <message>
        <source>From the s&amp;un</source>
        <translation>Von de&amp;r Sonne</translation>
    </message>
    <message>
        <source>As the sun sees the city at the date and time below the view: what is visible is sunlit</source>
        <translation>Wie die Sonne die Stadt zu Datum und Uhrzeit unter der Ansicht sieht: was sichtbar ist, ist besonnt</translation>
    </message>
    <message>
        <source>The sun is below the horizon at this date and time. Move the time below the view.</source>
        <translation>Zu diesem Zeitpunkt steht die Sonne unter dem Horizont. Die Uhrzeit unter der Ansicht ändern.</translation>
    </message>
    <message>
        <source>Parallel pro&amp;jection</source>
        <translation>&amp;Parallelprojektion</translation>
    </message>
    <message>
        <source>Orthographic, as in plans and elevations: lengths across the view are to scale everywhere</source>
        <translation>Orthogonal wie in Grundrissen und Ansichten: Längen quer zur Blickrichtung sind überall maßstäblich</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Grundriss</translation>
    </message>
    <message>
        <source>Shift+P</source>
        <translation>Shift+P</translation>
    </message>
    <message>
        <source>The same ground from straight above, north up, in parallel projection</source>
        <translation>Derselbe Boden genau von oben, Norden oben, in Parallelprojektion</translation>
    </message>
    <message>
        <source>The same ground from this side; an elevation in parallel projection</source>
        <translation>Derselbe Boden von dieser Seite; in Parallelprojektion eine Ansicht</translation>
    </message>
</context>
<context>
    <name>noonmark::WarningsDock</name>
    <message>
        <source>Double-click a feature or press Enter to go to its building</source>
        <translation>Doppelklick auf ein Objekt oder Eingabe geht zu seinem Gebäude</translation>
    </message>
    <message>
        <source>No warnings: nothing was left out, repaired or assumed</source>
        <translation>Keine Hinweise: nichts wurde ausgelassen, repariert oder angenommen</translation>
    </message>
</context>
<context>
    <name>noonmark::Watch</name>
    <message>
        <source>reading the picture</source>
        <translation>liest das Bild</translation>
    </message>
</context>
<context>
    <name>noonmark::Watcher</name>
    <message>
        <source>reading the terrain</source>
        <translation>liest das Gelände</translation>
    </message>
    <message>
        <source>resampling the terrain</source>
        <translation>passt das Gelände an</translation>
    </message>
</context>
<context>
    <name>noonmark::WeightCalendar</name>
    <message>
        <source>Weights by month and hour</source>
        <translation>Gewichte nach Monat und Stunde</translation>
    </message>
    <message>
        <source>Drag to give months and hours the weight that is chosen below; drag with the right button to erase it. Keys: arrows, Shift, Enter, Delete, + and -</source>
        <translation>Ziehen gibt Monaten und Stunden das unten gewählte Gewicht; Ziehen mit der rechten Taste löscht es. Tasten: Pfeile, Umschalt, Eingabe, Entf, + und -</translation>
    </message>
    <message>
        <source>%1, %2:00 to %3:00</source>
        <translation>%1, %2:00 bis %3:00</translation>
    </message>
    <message>
        <source>no weight</source>
        <translation>kein Gewicht</translation>
    </message>
    <message>
        <source>several weights, or none in part; mean %1</source>
        <translation>mehrere Gewichte oder teils keines; Mittel %1</translation>
    </message>
    <message>
        <source>weight %1</source>
        <translation>Gewicht %1</translation>
    </message>
    <message>
        <source>sun wanted</source>
        <translation>Sonne erwünscht</translation>
    </message>
    <message>
        <source>shade wanted</source>
        <translation>Schatten erwünscht</translation>
    </message>
</context>
<context>
    <name>noonmark::WeightsDock</name>
    <message>
        <source>Compute score</source>
        <translation>Bewerten</translation>
    </message>
    <message>
        <source>Shadow of the displayed scenario over the study&apos;s region and period, weighted by this table: by month and as a map</source>
        <translation>Schatten des angezeigten Szenarios im Gebiet und Zeitraum der Untersuchung, mit dieser Tabelle gewichtet: nach Monat und als Karte</translation>
    </message>
    <message>
        <source>The weight table to edit and to compute scores with; rename it with F2 in the project tree</source>
        <translation>Die Gewichtstabelle zum Bearbeiten und Bewerten; umbenennen mit F2 im Projektbaum</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Adds an interval after the selected one: over days without a weight, else over half of its days</source>
        <translation>Fügt nach dem gewählten Intervall eines hinzu: über Tage ohne Gewicht, sonst über die Hälfte seiner Tage</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the selected interval; its time then has no weight</source>
        <translation>Entfernt das gewählte Intervall; seine Zeit hat dann kein Gewicht</translation>
    </message>
    <message>
        <source>New table</source>
        <translation>Neue Tabelle</translation>
    </message>
    <message>
        <source>Adds a table that starts with the twelve months of the paper</source>
        <translation>Fügt eine Tabelle hinzu, die mit den zwölf Monaten des Artikels beginnt</translation>
    </message>
    <message>
        <source>new weight table %1</source>
        <translation>neue Gewichtstabelle %1</translation>
    </message>
    <message>
        <source>Cutting an interval in two changes the score, but not the weighted shade.</source>
        <translation>Ein Intervall zu teilen ändert die Bewertung, aber nicht den gewichteten Schatten.</translation>
    </message>
    <message>
        <source>New from template</source>
        <translation>Neu aus Vorlage</translation>
    </message>
    <message>
        <source>Adds a table made for the latitude of this city, or a copy of a table of this project</source>
        <translation>Fügt eine Tabelle für die geografische Breite dieser Stadt hinzu oder eine Kopie einer Tabelle dieses Projekts</translation>
    </message>
    <message>
        <source>Pedestrian comfort</source>
        <translation>Komfort zu Fuß</translation>
    </message>
    <message>
        <source>Shade wanted in summer afternoons, sun in winter: a rule of thumb by latitude</source>
        <translation>Schatten an Sommernachmittagen erwünscht, Sonne im Winter: eine Faustregel nach geografischer Breite</translation>
    </message>
    <message>
        <source>Plants</source>
        <translation>Pflanzen</translation>
    </message>
    <message>
        <source>Sun wanted in the growing season: a rule of thumb by latitude</source>
        <translation>Sonne in der Vegetationszeit erwünscht: eine Faustregel nach geografischer Breite</translation>
    </message>
    <message>
        <source>As %1</source>
        <translation>Wie %1</translation>
    </message>
    <message>
        <source>A copy, to be changed</source>
        <translation>Eine Kopie zum Ändern</translation>
    </message>
</context>
<context>
    <name>noonmark::WeightsModel</name>
    <message>
        <source>Interval</source>
        <translation>Intervall</translation>
    </message>
    <message>
        <source>Name of the interval</source>
        <translation>Name des Intervalls</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Erster</translation>
    </message>
    <message>
        <source>First day, every year: month and day such as 06-01, or a month such as June</source>
        <translation>Erster Tag, jedes Jahr: Monat und Tag wie 06-01 oder ein Monat wie June</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Letzter</translation>
    </message>
    <message>
        <source>Last day, included; before the first: across New Year. Such as 08-31, or a month such as August</source>
        <translation>Letzter Tag, eingeschlossen; vor dem ersten: über Neujahr. Wie 08-31 oder ein Monat wie August</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Time of day at which it begins, wall clock: 00:00 to 24:00</source>
        <translation>Uhrzeit, zu der es beginnt: 00:00 bis 24:00</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Time of day at which it ends: 00:00 to 24:00</source>
        <translation>Uhrzeit, zu der es endet: 00:00 bis 24:00</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>-1 (shadow unwanted) to 1 (shade wanted)</source>
        <translation>-1 (Schatten unerwünscht) bis 1 (Schatten erwünscht)</translation>
    </message>
    <message>
        <source>edit weights %1</source>
        <translation>Gewichte %1 bearbeiten</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>Zeile %1</translation>
    </message>
</context>
<context>
    <name>noonmark::WhatForm</name>
    <message>
        <source>Hours of shadow</source>
        <translation>Stunden im Schatten</translation>
    </message>
    <message>
        <source>Change by a scenario</source>
        <translation>Änderung durch ein Szenario</translation>
    </message>
    <message>
        <source>Score of wanted shadow</source>
        <translation>Bewertung erwünschten Schattens</translation>
    </message>
    <message>
        <source>Review by a rule</source>
        <translation>Prüfung nach einer Regel</translation>
    </message>
    <message>
        <source>Where shadow is measured. Changes and scores are measured on the ground only.
Facades, windows and planes are measured at points, each with its hours of sun.</source>
        <translation>Wo der Schatten gemessen wird. Änderungen und Bewertungen werden nur auf dem Boden gemessen.
Fassaden, Fenster und Ebenen werden an Punkten gemessen, jeder mit seinen Sonnenstunden.</translation>
    </message>
    <message>
        <source>receivers</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Sun by place</source>
        <translation>Sonne nach Ort</translation>
    </message>
</context>
<context>
    <name>noonmark::WhenForm</name>
    <message>
        <source>The days that are measured. The hours stay as they are</source>
        <translation>Die Tage, die gemessen werden. Die Stunden bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>The day and the hours of a review board&apos;s rule</source>
        <translation>Der Tag und die Stunden aus der Regel einer Behörde</translation>
    </message>
    <message>
        <source>days</source>
        <translation>Tage</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>period</source>
        <translation>Zeitraum</translation>
    </message>
    <message>
        <source>Days of a rule</source>
        <translation>Tage einer Regel</translation>
    </message>
</context>
<context>
    <name>noonmark::WhereForm</name>
    <message>
        <source>Place or region by name</source>
        <translation>Ort oder Gebiet nach Name</translation>
    </message>
    <message>
        <source>A place or a region of the project. Type a part of its name.</source>
        <translation>Ein Ort oder Gebiet des Projekts. Einen Teil des Namens tippen.</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Click the corners of a polygon on the ground.
Double click, Enter or right click finishes, Backspace removes the last corner, Esc cancels.</source>
        <translation>Die Ecken eines Polygons auf dem Boden anklicken.
Doppelklick, Eingabe oder Rechtsklick beendet, Rücktaste entfernt die letzte Ecke, Esc bricht ab.</translation>
    </message>
    <message>
        <source>What I see</source>
        <translation>Was ich sehe</translation>
    </message>
    <message>
        <source>The ground visible in the view</source>
        <translation>Der in der Ansicht sichtbare Boden</translation>
    </message>
    <message>
        <source>Whole city</source>
        <translation>Ganze Stadt</translation>
    </message>
    <message>
        <source>The bounding box of all buildings</source>
        <translation>Das umschließende Rechteck aller Gebäude</translation>
    </message>
    <message>
        <source>Around building</source>
        <translation>Um das Gebäude</translation>
    </message>
    <message>
        <source>The selected building&apos;s surroundings, as far as four times its height.
Click a building first.</source>
        <translation>Die Umgebung des gewählten Gebäudes, bis zum Vierfachen seiner Höhe.
Zuerst ein Gebäude anklicken.</translation>
    </message>
</context>
<context>
    <name>noonmark::Workbench</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Recovering</source>
        <translation>Wird wiederhergestellt</translation>
    </message>
    <message>
        <source>recover unsaved changes</source>
        <translation>ungespeicherte Änderungen wiederherstellen</translation>
    </message>
    <message>
        <source>Unsaved changes recovered. Save keeps them, Undo discards them.</source>
        <translation>Ungespeicherte Änderungen wiederhergestellt. Speichern behält sie, Rückgängig verwirft sie.</translation>
    </message>
    <message>
        <source>Showing %1</source>
        <translation>%1 wird gezeigt</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Estimating</source>
        <translation>Wird abgeschätzt</translation>
    </message>
    <message>
        <source>engine</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>All scenarios</source>
        <translation>Alle Szenarien</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>save result %1</source>
        <translation>Ergebnis %1 speichern</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Wird exportiert</translation>
    </message>
    <message>
        <source>Exported to %1: %2</source>
        <translation>Exportiert nach %1: %2</translation>
    </message>
    <message>
        <source>Finding the command</source>
        <translation>Der Befehl wird ermittelt</translation>
    </message>
    <message>
        <source>Comparing results with the buildings</source>
        <translation>Ergebnisse werden mit den Gebäuden verglichen</translation>
    </message>
    <message>
        <source>%1 is saved with the project: the list above the results shows it again</source>
        <translation>%1 ist mit dem Projekt gespeichert: Die Liste über den Ergebnissen zeigt es wieder</translation>
    </message>
    <message>
        <source>months</source>
        <translation>Monate</translation>
    </message>
    <message>
        <source>%1 is in the list of answers</source>
        <translation>%1 steht in der Liste der Antworten</translation>
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
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>Share of the sunlit time</source>
        <translation>Anteil der besonnten Zeit</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source> min a day</source>
        <translation> min am Tag</translation>
    </message>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source> h a day</source>
        <translation> h am Tag</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>nicht gezählt</translation>
    </message>
    <message>
        <source>without trees, as evergreens, with seasons</source>
        <translation>ohne Bäume, als immergrüne, mit Jahreszeiten</translation>
    </message>
    <message>
        <source>without trees</source>
        <translation>ohne Bäume</translation>
    </message>
    <message>
        <source>as evergreens</source>
        <translation>als immergrüne</translation>
    </message>
    <message>
        <source>with seasons</source>
        <translation>mit Jahreszeiten</translation>
    </message>
    <message>
        <source>if neighbours&apos; ground heights differ</source>
        <translation>wenn Bodenhöhen von Nachbarn abweichen</translation>
    </message>
    <message>
        <source>always</source>
        <translation>immer</translation>
    </message>
    <message>
        <source>never (flat ground)</source>
        <translation>nie (ebener Boden)</translation>
    </message>
    <message>
        <source>as their bases fit the terrain</source>
        <translation>je nachdem, wie ihre Fußpunkte zum Gelände passen</translation>
    </message>
    <message>
        <source>each set down on the terrain</source>
        <translation>jedes auf das Gelände gesetzt</translation>
    </message>
    <message>
        <source>at the elevations in the file</source>
        <translation>auf den Höhen der Datei</translation>
    </message>
    <message>
        <source>found by its steps at outlines</source>
        <translation>an Stufen entlang der Umrisse erkannt</translation>
    </message>
    <message>
        <source>the bare ground</source>
        <translation>den bloßen Boden</translation>
    </message>
    <message>
        <source>a surface with buildings</source>
        <translation>eine Oberfläche mit Gebäuden</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
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
        <translation>Sonne bis Indigo</translation>
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
        <translation>Grau</translation>
    </message>
    <message>
        <source>Green to red</source>
        <translation>Grün bis Rot</translation>
    </message>
    <message>
        <source>Orange to violet</source>
        <translation>Orange zu Violett</translation>
    </message>
    <message>
        <source>Green-blue to brown</source>
        <translation>Grünblau zu Braun</translation>
    </message>
    <message>
        <source>Orange to purple</source>
        <translation>Orange zu Purpur</translation>
    </message>
    <message>
        <source>Blue to red</source>
        <translation>Blau zu Rot</translation>
    </message>
    <message>
        <source>Green to red, pale in the middle</source>
        <translation>Grün zu Rot, in der Mitte blass</translation>
    </message>
    <message>
        <source>Gross shadow of a cell</source>
        <translation>Gesamtschatten einer Zelle</translation>
    </message>
    <message>
        <source>Longest shadow of a cell</source>
        <translation>Längster Schatten einer Zelle</translation>
    </message>
    <message>
        <source>Shadow of a cell in a month</source>
        <translation>Schatten einer Zelle in einem Monat</translation>
    </message>
    <message>
        <source>Change of gross shadow of a cell</source>
        <translation>Änderung des Gesamtschattens einer Zelle</translation>
    </message>
    <message>
        <source>Change of the longest shadow of a cell</source>
        <translation>Änderung des längsten Schattens einer Zelle</translation>
    </message>
    <message>
        <source>Score of a cell</source>
        <translation>Bewertung einer Zelle</translation>
    </message>
    <message>
        <source>Shadow score</source>
        <translation>Schattenbewertung</translation>
    </message>
    <message>
        <source>Weighted shade</source>
        <translation>Gewichteter Schatten</translation>
    </message>
    <message>
        <source>Shadow area of a month</source>
        <translation>Schattenfläche eines Monats</translation>
    </message>
    <message>
        <source>Shadow score of a month</source>
        <translation>Schattenbewertung eines Monats</translation>
    </message>
    <message>
        <source>Weighted shade of a month</source>
        <translation>Gewichteter Schatten eines Monats</translation>
    </message>
    <message>
        <source>Shadow area of an interval</source>
        <translation>Schattenfläche eines Intervalls</translation>
    </message>
    <message>
        <source>Shadow score of an interval</source>
        <translation>Schattenbewertung eines Intervalls</translation>
    </message>
    <message>
        <source>Weighted shade of an interval</source>
        <translation>Gewichteter Schatten eines Intervalls</translation>
    </message>
    <message>
        <source>Least and most sun of a place, at a cell</source>
        <translation>Wenigste und meiste Sonne eines Ortes, an einer Zelle</translation>
    </message>
    <message>
        <source>Mean sun of a place</source>
        <translation>Mittlere Sonne eines Ortes</translation>
    </message>
    <message>
        <source>Mean sun of a small place with cells of its own</source>
        <translation>Mittlere Sonne eines kleinen Ortes mit eigenen Zellen</translation>
    </message>
    <message>
        <source>Mean sun of a place in a month</source>
        <translation>Mittlere Sonne eines Ortes in einem Monat</translation>
    </message>
    <message>
        <source>Share of a place with enough sun</source>
        <translation>Anteil eines Ortes mit genug Sonne</translation>
    </message>
    <message>
        <source>Mean sun of a place on a date</source>
        <translation>Mittlere Sonne eines Ortes an einem Tag</translation>
    </message>
    <message>
        <source>Share of a place with less than enough sun on a date</source>
        <translation>Anteil eines Ortes mit zu wenig Sonne an einem Tag</translation>
    </message>
    <message>
        <source>Change of the mean sun of a place</source>
        <translation>Änderung der mittleren Sonne eines Ortes</translation>
    </message>
    <message>
        <source>Largest loss and gain of a place, at a cell</source>
        <translation>Größter Verlust und Gewinn eines Ortes, an einer Zelle</translation>
    </message>
    <message>
        <source>Share of a place that loses sun</source>
        <translation>Anteil eines Ortes, der Sonne verliert</translation>
    </message>
    <message>
        <source>on the ground</source>
        <translation>auf dem Boden</translation>
    </message>
    <message>
        <source>on roofs</source>
        <translation>auf Dächern</translation>
    </message>
    <message>
        <source>on the ground and roofs</source>
        <translation>auf Boden und Dächern</translation>
    </message>
    <message>
        <source>buildings stand on all of it</source>
        <translation>Gebäude stehen auf der ganzen Fläche</translation>
    </message>
    <message>
        <source>no cell has its centre on its open ground</source>
        <translation>keine Zelle hat ihre Mitte auf seinem freien Boden</translation>
    </message>
    <message>
        <source>beyond the terrain: the nearest elevation is taken</source>
        <translation>außerhalb des Geländes: die nächste Höhe gilt</translation>
    </message>
    <message>
        <source>mostly on water: measured at its surface</source>
        <translation>größtenteils auf Wasser: an dessen Oberfläche gemessen</translation>
    </message>
    <message>
        <source>elevations</source>
        <translation>Höhenlagen</translation>
    </message>
    <message>
        <source>above the ground</source>
        <translation>über dem Gelände</translation>
    </message>
    <message>
        <source>on facades</source>
        <translation>an Fassaden</translation>
    </message>
    <message>
        <source>at windows of a file</source>
        <translation>an Fenstern einer Datei</translation>
    </message>
    <message>
        <source>on a level plane</source>
        <translation>auf einer waagerechten Ebene</translation>
    </message>
    <message>
        <source>on lines around a parcel</source>
        <translation>auf Linien um ein Flurstück</translation>
    </message>
    <message>
        <source>at single points</source>
        <translation>an einzelnen Punkten</translation>
    </message>
    <message>
        <source>Hours of sun a day by month</source>
        <translation>Sonnenstunden am Tag nach Monat</translation>
    </message>
    <message>
        <source>first light of the disc (-0.833°)</source>
        <translation>erstes Licht (-0,833°)</translation>
    </message>
    <message>
        <source>middle of the disc (0°)</source>
        <translation>Mitte der Scheibe (0°)</translation>
    </message>
    <message>
        <source>the eastings begin with the number of their zone, which was taken off</source>
        <translation>die Rechtswerte beginnen mit der Nummer ihrer Zone; sie wurde entfernt</translation>
    </message>
    <message>
        <source>Gross, trees as evergreens</source>
        <translation>Gesamtschatten, Bäume als immergrün</translation>
    </message>
    <message>
        <source>Gross, trees with their seasons</source>
        <translation>Gesamtschatten, Bäume mit Jahreszeiten</translation>
    </message>
    <message>
        <source>Sun, trees as evergreens</source>
        <translation>Sonne, Bäume als immergrün</translation>
    </message>
    <message>
        <source>Sun, trees with their seasons</source>
        <translation>Sonne, Bäume mit Jahreszeiten</translation>
    </message>
    <message>
        <source>trees as evergreens</source>
        <translation>Bäume als immergrün</translation>
    </message>
    <message>
        <source>trees with their seasons</source>
        <translation>Bäume mit ihren Jahreszeiten</translation>
    </message>
    <message>
        <source>a wood is taken as closed canopy, in columns of 8 x 8 m</source>
        <translation>ein Wald gilt als geschlossenes Kronendach, in Säulen von 8 x 8 m</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Crown diameter</source>
        <translation>Kronendurchmesser</translation>
    </message>
    <message>
        <source>Crown base</source>
        <translation>Kronenansatz</translation>
    </message>
    <message>
        <source>Stem diameter</source>
        <translation>Stammdurchmesser</translation>
    </message>
    <message>
        <source>Stem girth</source>
        <translation>Stammumfang</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Gattung</translation>
    </message>
    <message>
        <source>Leaf cycle</source>
        <translation>Belaubung</translation>
    </message>
    <message>
        <source>%1, carriageway</source>
        <translation>%1, Fahrbahn</translation>
    </message>
    <message>
        <source>%1, sidewalks</source>
        <translation>%1, Gehwege</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1, %2 bis %3</translation>
    </message>
    <message>
        <source>%1, at %2</source>
        <translation>%1, an %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1, east of %2</source>
        <translation>%1, östlich von %2</translation>
    </message>
    <message>
        <source>%1, north-east of %2</source>
        <translation>%1, nordöstlich von %2</translation>
    </message>
    <message>
        <source>%1, north of %2</source>
        <translation>%1, nördlich von %2</translation>
    </message>
    <message>
        <source>%1, north-west of %2</source>
        <translation>%1, nordwestlich von %2</translation>
    </message>
    <message>
        <source>%1, west of %2</source>
        <translation>%1, westlich von %2</translation>
    </message>
    <message>
        <source>%1, south-west of %2</source>
        <translation>%1, südwestlich von %2</translation>
    </message>
    <message>
        <source>%1, south of %2</source>
        <translation>%1, südlich von %2</translation>
    </message>
    <message>
        <source>%1, south-east of %2</source>
        <translation>%1, südöstlich von %2</translation>
    </message>
    <message>
        <source>evergreen</source>
        <translation>immergrün</translation>
    </message>
    <message>
        <source>loses its leaves</source>
        <translation>wirft die Blätter ab</translation>
    </message>
    <message>
        <source>First day in leaf</source>
        <translation>Erster Tag mit Laub</translation>
    </message>
    <message>
        <source>First day without leaves</source>
        <translation>Erster Tag ohne Laub</translation>
    </message>
    <message>
        <source>the whole city</source>
        <translation>die ganze Stadt</translation>
    </message>
    <message>
        <source>the middle of the city</source>
        <translation>die Mitte der Stadt</translation>
    </message>
    <message>
        <source>around the building</source>
        <translation>um das Gebäude</translation>
    </message>
    <message>
        <source>around %1</source>
        <translation>um %1</translation>
    </message>
    <message>
        <source>That of the window</source>
        <translation>Die des Fensters</translation>
    </message>
    <message>
        <source>Sun: azimuth %1°, altitude %2°</source>
        <translation>Sonne: Azimut %1°, Höhe %2°</translation>
    </message>
    <message>
        <source>%1 further pages are printed by the option --all-pages. </source>
        <translation>%1 weitere Seiten druckt die Option --all-pages. </translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>%1, generated by this program</source>
        <translation>%1, von diesem Programm erzeugt</translation>
    </message>
    <message>
        <source>%1, %2 bytes, SHA-256:</source>
        <translation>%1, %2 Bytes, SHA-256:</translation>
    </message>
    <message>
        <source>%1 day</source>
        <translation>%1 Tag</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 Tage</translation>
    </message>
    <message>
        <source>%1 step</source>
        <translation>%1 Schritt</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 Schritte</translation>
    </message>
    <message>
        <source>%1 value</source>
        <translation>%1 Wert</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 Werte</translation>
    </message>
    <message>
        <source>%1 edit</source>
        <translation>%1 Änderung</translation>
    </message>
    <message>
        <source>%1 edits</source>
        <translation>%1 Änderungen</translation>
    </message>
    <message>
        <source>%1 place</source>
        <translation>%1 Ort</translation>
    </message>
    <message>
        <source>%1 places</source>
        <translation>%1 Orte</translation>
    </message>
    <message>
        <source>%1 building</source>
        <translation>%1 Gebäude</translation>
    </message>
    <message>
        <source>%1 buildings</source>
        <translation>%1 Gebäude</translation>
    </message>
    <message>
        <source>%1 part</source>
        <translation>%1 Teil</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 Teilen</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source>sq ft</source>
        <translation>sq ft</translation>
    </message>
    <message>
        <source>acres</source>
        <translation>Acres</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>, one day in %1</source>
        <translation>, ein Tag von %1</translation>
    </message>
    <message>
        <source>, half a year mirrored at 21 June</source>
        <translation>, ein halbes Jahr, am 21. Juni gespiegelt</translation>
    </message>
    <message>
        <source>; sun above %1 deg</source>
        <translation>; Sonne über %1 Grad</translation>
    </message>
    <message>
        <source>; sunrise: %1</source>
        <translation>; Sonnenaufgang: %1</translation>
    </message>
    <message>
        <source>, %1, %2 face</source>
        <translation>, %1, %2</translation>
    </message>
    <message>
        <source>, %1 m above the sill</source>
        <translation>, %1 m über der Brüstung</translation>
    </message>
    <message>
        <source>, %1 m above the floor</source>
        <translation>, %1 m über dem Fußboden</translation>
    </message>
    <message>
        <source>, sun at least %1 deg from the pane</source>
        <translation>, Sonne mindestens %1 Grad von der Scheibe</translation>
    </message>
    <message>
        <source>, sun at least arctan(wall / width) from the pane</source>
        <translation>, Sonne mindestens arctan(Wand / Breite) von der Scheibe</translation>
    </message>
    <message>
        <source>; by %1</source>
        <translation>; je %1</translation>
    </message>
    <message>
        <source>; sill %1 m, wall %2 m, windows without a size %3 x %4 m</source>
        <translation>; Brüstung %1 m, Wand %2 m, Fenster ohne Größe %3 x %4 m</translation>
    </message>
    <message>
        <source> %1 m above mean ground</source>
        <translation> %1 m über dem mittleren Boden</translation>
    </message>
    <message>
        <source>; lines %1 and %2 m from the parcel</source>
        <translation>; Linien %1 und %2 m vom Grundstück</translation>
    </message>
    <message>
        <source>, whose line moves out by %1 of the width of roads up to %2 m, to %3 m inside the far side of wider ones</source>
        <translation>, dessen Linie um das %1-fache der Breite von Straßen bis %2 m nach außen rückt, bei breiteren bis %3 m vor ihre ferne Seite</translation>
    </message>
    <message>
        <source>; all places</source>
        <translation>; alle Orte</translation>
    </message>
    <message>
        <source> or</source>
        <translation> oder</translation>
    </message>
    <message>
        <source>: stated, no limit</source>
        <translation>: angegeben, ohne Grenze</translation>
    </message>
    <message>
        <source>; windows facing %1 to %2 deg</source>
        <translation>; Fenster nach %1 bis %2 Grad</translation>
    </message>
    <message>
        <source> (does not decide)</source>
        <translation> (entscheidet nicht)</translation>
    </message>
    <message>
        <source>days</source>
        <translation>Tage</translation>
    </message>
    <message>
        <source>clock</source>
        <translation>Uhrzeit</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>receivers</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>casters</source>
        <translation>Hindernisse</translation>
    </message>
    <message>
        <source>trees</source>
        <translation>Bäume</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>Ausgangslage</translation>
    </message>
    <message>
        <source>criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>holds if</source>
        <translation>gilt, wenn</translation>
    </message>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
    <message>
        <source>share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>sunshine</source>
        <translation>Sonnenschein</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>diagrams</source>
        <translation>Pläne</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>Wahl</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Nicht geprüft</translation>
    </message>
    <message>
        <source>How the rule is read</source>
        <translation>Wie die Regel gelesen wird</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>Fächer</translation>
    </message>
    <message>
        <source>isochrones</source>
        <translation>Isochronen</translation>
    </message>
    <message>
        <source>view from the sun</source>
        <translation>Ansicht von der Sonne aus</translation>
    </message>
    <message>
        <source>hours</source>
        <translation>Stunden</translation>
    </message>
    <message>
        <source>, on full %1 min</source>
        <translation>, auf volle %1 min</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>%1: %2 for at least %3 %</source>
        <translation>%1: %2 für mindestens %3 %</translation>
    </message>
    <message>
        <source>area x %1 h a year</source>
        <translation>Fläche x %1 h im Jahr</translation>
    </message>
    <message>
        <source>Least certain of what the verdicts rest on: %1 (%2: %3).</source>
        <translation>Am wenigsten sicher von dem, worauf die Befunde beruhen: %1 (%2: %3).</translation>
    </message>
    <message>
        <source>%1: %2; now %3</source>
        <translation>%1: %2; jetzt %3</translation>
    </message>
    <message>
        <source>V: read in the rule&apos;s text or on an official page; R: reported by practice; U: not checked against the rule&apos;s text.</source>
        <translation>V: im Text der Regel oder auf einer amtlichen Seite gelesen; R: aus der Praxis berichtet; U: nicht am Text der Regel geprüft.</translation>
    </message>
    <message>
        <source>figures only</source>
        <translation>nur Zahlen</translation>
    </message>
    <message>
        <source>%1 x former</source>
        <translation>%1 x früher</translation>
    </message>
    <message>
        <source>loss %1</source>
        <translation>Verlust %1</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source> (former %1)</source>
        <translation> (früher %1)</translation>
    </message>
    <message>
        <source> on %1</source>
        <translation> am %1</translation>
    </message>
    <message>
        <source>, wanted %1</source>
        <translation>, verlangt %1</translation>
    </message>
    <message>
        <source>No sun in these hours</source>
        <translation>Keine Sonne in diesen Stunden</translation>
    </message>
    <message>
        <source>The rule states no limit for this place</source>
        <translation>Die Regel nennt keine Grenze für diesen Ort</translation>
    </message>
    <message>
        <source>read in the rule&apos;s text or on an official page</source>
        <translation>im Text der Regel oder auf einer amtlichen Seite gelesen</translation>
    </message>
    <message>
        <source>reported by practice</source>
        <translation>aus der Praxis berichtet</translation>
    </message>
    <message>
        <source>not checked against the rule&apos;s text</source>
        <translation>nicht am Text der Regel geprüft</translation>
    </message>
    <message>
        <source>none counted</source>
        <translation>keine gezählt</translation>
    </message>
    <message>
        <source>evergreen trees only</source>
        <translation>nur immergrüne Bäume</translation>
    </message>
    <message>
        <source>dense belts of evergreen trees only</source>
        <translation>nur dichte Gürtel immergrüner Bäume</translation>
    </message>
    <message>
        <source>all, as evergreens</source>
        <translation>alle, als immergrün</translation>
    </message>
    <message>
        <source>all, with their seasons</source>
        <translation>alle, mit ihren Jahreszeiten</translation>
    </message>
    <message>
        <source>existing trees with their seasons, and new evergreens</source>
        <translation>vorhandene Bäume mit ihren Jahreszeiten und neue immergrüne</translation>
    </message>
    <message>
        <source>sunrise</source>
        <translation>Sonnenaufgang</translation>
    </message>
    <message>
        <source>sunset</source>
        <translation>Sonnenuntergang</translation>
    </message>
    <message>
        <source>the latest of</source>
        <translation>das späteste von</translation>
    </message>
    <message>
        <source>the earliest of</source>
        <translation>das früheste von</translation>
    </message>
    <message>
        <source>Trees: %1</source>
        <translation>Bäume: %1</translation>
    </message>
    <message>
        <source>; the city has no trees</source>
        <translation>; die Stadt hat keine Bäume</translation>
    </message>
    <message>
        <source>; trees in the city: %1</source>
        <translation>; Bäume in der Stadt: %1</translation>
    </message>
    <message>
        <source>; trees that count: %1 of %2</source>
        <translation>; Bäume, die zählen: %1 von %2</translation>
    </message>
    <message>
        <source>The engine is the ray reference itself, against which others are measured.</source>
        <translation>Das Verfahren ist die Strahlenreferenz selbst, gegen die andere gemessen werden.</translation>
    </message>
    <message>
        <source>The engine&apos;s error against the ray reference was not measured: it was switched off.</source>
        <translation>Der Fehler des Verfahrens gegen die Strahlenreferenz wurde nicht gemessen: er war abgeschaltet.</translation>
    </message>
    <message>
        <source>The engine&apos;s error against the ray reference could not be measured: see the warnings.</source>
        <translation>Der Fehler des Verfahrens gegen die Strahlenreferenz konnte nicht gemessen werden: siehe die Hinweise.</translation>
    </message>
    <message>
        <source>Each run of minutes is uncertain by a step; each area by half of the cells that its edge passes through, at least by one; each area x hours by these and by half of what the area changes from step to step, where the days of a sum err independently of each other. </source>
        <translation>Jede Dauer ist um einen Schritt unsicher; jede Fläche um die Hälfte der Zellen, durch die ihr Rand geht, mindestens um eine; jedes Produkt Fläche x Stunden um beides und um die Hälfte dessen, was sich die Fläche von Schritt zu Schritt ändert, wobei die Tage einer Summe unabhängig voneinander irren. </translation>
    </message>
    <message>
        <source>Worst spots are the worst of the cells&apos; centres and of points around these, down to %1 m from each other; what the nearest found worse is in their error. </source>
        <translation>Die schlechtesten Stellen sind die schlechtesten der Zellmitten und von Punkten darum herum, bis zu %1 m voneinander; um was der nächste schlechter war, steht in ihrem Fehler. </translation>
    </message>
    <message>
        <source>Worst spots are the worst of the cells&apos; centres, and their error includes the cell. </source>
        <translation>Die schlechtesten Stellen sind die schlechtesten der Zellmitten, und ihr Fehler schließt die Zelle ein. </translation>
    </message>
    <message>
        <source>Shadow enters and exits up to a step (%1 min) earlier than stated, as each step has the sun of its beginning. </source>
        <translation>Schatten tritt bis zu einem Schritt (%1 min) früher ein und aus als angegeben, da jeder Schritt die Sonne seines Anfangs hat. </translation>
    </message>
    <message>
        <source>A value within its error of a limit is borderline, never pass.</source>
        <translation>Ein Wert, der innerhalb seines Fehlers an einer Grenze liegt, ist grenzwertig, nie erfüllt.</translation>
    </message>
    <message>
        <source>the ground</source>
        <translation>dem Boden</translation>
    </message>
    <message>
        <source>roofs</source>
        <translation>Dächern</translation>
    </message>
    <message>
        <source>the ground and roofs</source>
        <translation>dem Boden und Dächern</translation>
    </message>
    <message>
        <source>day %1 of %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>%1 % mean, %2 % largest, against rays</source>
        <translation>im Mittel %1 %, höchstens %2 %, gegen Strahlen</translation>
    </message>
</context>
</TS>
