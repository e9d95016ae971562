<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message numerus="yes">
        <source>%1 more kind(s) of notes</source>
        <translation>
            <numerusform>%1 more kind of notes</numerusform>
            <numerusform>%1 more kinds of notes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 place(s) were read</source>
        <translation>
            <numerusform>%1 place was read</numerusform>
            <numerusform>%1 places were read</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; %1 replace(s) earlier ones</source>
        <translation>
            <numerusform>; %1 replaces an earlier one</numerusform>
            <numerusform>; %1 replace earlier ones</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a sample every %1 pixel(s)</source>
        <translation>
            <numerusform>a sample every %1 pixel</numerusform>
            <numerusform>a sample every %1 pixels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 day(s); %3</source>
        <translation>
            <numerusform>%1 of %2 day; %3</numerusform>
            <numerusform>%1 of %2 days; %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>all %1 step(s)</source>
        <translation>
            <numerusform>all of %1 step</numerusform>
            <numerusform>all %1 steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 storey(s)</source>
        <translation>
            <numerusform>%1 storey</numerusform>
            <numerusform>%1 storeys</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s)</source>
        <translation>
            <numerusform>%1 building</numerusform>
            <numerusform>%1 buildings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 occlusion ray(s) divided by the engine&apos;s time</source>
        <translation>
            <numerusform>%1 occlusion ray divided by the engine&apos;s time</numerusform>
            <numerusform>%1 occlusion rays divided by the engine&apos;s time</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Positions of the sun above the horizon; %1 below it was/were left out</source>
        <translation>
            <numerusform>Positions of the sun above the horizon; %1 below it was left out</numerusform>
            <numerusform>Positions of the sun above the horizon; %1 below it were left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 window(s): %2</source>
        <translation>
            <numerusform>%1 window: %2</numerusform>
            <numerusform>%1 windows: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 window(s): %2.</source>
        <translation>
            <numerusform>%1 window: %2.</numerusform>
            <numerusform>%1 windows: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Compared with before, %1 get(s) worse and %2 better</source>
        <translation>
            <numerusform>Compared with before, %1 gets worse and %2 better</numerusform>
            <numerusform>Compared with before, %1 get worse and %2 better</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1
%2 × %3, %4, %5 cell(s)</source>
        <translation>
            <numerusform>%1
%2 × %3, %4, %5 cell</numerusform>
            <numerusform>%1
%2 × %3, %4, %5 cells</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 point(s)</source>
        <translation>
            <numerusform>%1 point</numerusform>
            <numerusform>%1 points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cell(s)</source>
        <translation>
            <numerusform>%1 cell</numerusform>
            <numerusform>%1 cells</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 position(s) of the sun</source>
        <translation>
            <numerusform>%1 position of the sun</numerusform>
            <numerusform>%1 positions of the sun</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Not counted: %1 building(s) whose floors are not known</source>
        <translation>
            <numerusform>Not counted: %1 building whose floors are not known</numerusform>
            <numerusform>Not counted: %1 buildings whose floors are not known</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s) selected</source>
        <translation>
            <numerusform>%1 building selected</numerusform>
            <numerusform>%1 buildings selected</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %1 more place(s)</source>
        <translation>
            <numerusform>and %1 more place</numerusform>
            <numerusform>and %1 more places</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>exact at %1 of %2 step(s)</source>
        <translation>
            <numerusform>exact at %1 of %2 step</numerusform>
            <numerusform>exact at %1 of %2 steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 building(s) shade it; %2 takes the most, %3 %</source>
        <translation>
            <numerusform>%1 building shades it; %2 takes the most, %3 %</numerusform>
            <numerusform>%1 buildings shade it; %2 takes the most, %3 %</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 compared with %2: %3 min a day in shadow, mean over %4 cell(s).</source>
        <translation>
            <numerusform>%1 compared with %2: %3 min a day in shadow, mean over %4 cell.</numerusform>
            <numerusform>%1 compared with %2: %3 min a day in shadow, mean over %4 cells.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Against the ray reference, of a sample of %1 value(s)</source>
        <translation>
            <numerusform>Against the ray reference, of a sample of %1 value</numerusform>
            <numerusform>Against the ray reference, of a sample of %1 values</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; %1 place(s) were there before and stay as they are</source>
        <translation>
            <numerusform>; %1 place was there before and stays as it is</numerusform>
            <numerusform>; %1 places were there before and stay as they are</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 compared with %2: %3 min of sun a day, mean over %4 cell(s).</source>
        <translation>
            <numerusform>%1 compared with %2: %3 min of sun a day, mean over %4 cell.</numerusform>
            <numerusform>%1 compared with %2: %3 min of sun a day, mean over %4 cells.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cell(s); in the study itself %2.</source>
        <translation>
            <numerusform>%1 cell; in the study itself %2.</numerusform>
            <numerusform>%1 cells; in the study itself %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 feature(s) in layer %3.</source>
        <translation>
            <numerusform>%1: %2 feature in layer %3.</numerusform>
            <numerusform>%1: %2 features in layer %3.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 tree(s) are added.</source>
        <translation>
            <numerusform>%1 tree is added.</numerusform>
            <numerusform>%1 trees are added.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 tree(s) take sun from it, %2 % of the shadow.</source>
        <translation>
            <numerusform>%1 tree takes sun from it, %2 % of the shadow.</numerusform>
            <numerusform>%1 trees take sun from it, %2 % of the shadow.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::BuildingEditing</name>
    <message numerus="yes">
        <source>demolish %1 building(s)</source>
        <translation>
            <numerusform>demolish %1 building</numerusform>
            <numerusform>demolish %1 buildings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::EditPreview</name>
    <message numerus="yes">
        <source>Facades: %1 point(s) while it moves</source>
        <translation>
            <numerusform>Facades: %1 point while it moves</numerusform>
            <numerusform>Facades: %1 points while it moves</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Facades: %1 point(s)</source>
        <translation>
            <numerusform>Facades: %1 point</numerusform>
            <numerusform>Facades: %1 points</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::ElementsDock</name>
    <message numerus="yes">
        <source>%1 point(s)</source>
        <translation>
            <numerusform>%1 point</numerusform>
            <numerusform>%1 points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 point(s)</source>
        <translation>
            <numerusform>%1 of %2 point</numerusform>
            <numerusform>%1 of %2 points</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::FieldChoices</name>
    <message numerus="yes">
        <source>%1   %2 feature(s)</source>
        <translation>
            <numerusform>%1   %2 feature</numerusform>
            <numerusform>%1   %2 features</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::MassingPreview</name>
    <message numerus="yes">
        <source>%1 building(s); heights: %2.
Lowest %3, median %4, tallest %5.</source>
        <translation>
            <numerusform>%1 building; heights: %2.
Lowest %3, median %4, tallest %5.</numerusform>
            <numerusform>%1 buildings; heights: %2.
Lowest %3, median %4, tallest %5.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::MessageBar</name>
    <message numerus="yes">
        <source>%1 more line(s)</source>
        <translation>
            <numerusform>%1 more line</numerusform>
            <numerusform>%1 more lines</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::MovieActions</name>
    <message numerus="yes">
        <source>Movie of %1 frame(s) saved as %2</source>
        <translation>
            <numerusform>Movie of %1 frame saved as %2</numerusform>
            <numerusform>Movie of %1 frames saved as %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::OpeningActions</name>
    <message numerus="yes">
        <source>%1 far building(s) left out of the first view.</source>
        <translation>
            <numerusform>%1 far building left out of the first view.</numerusform>
            <numerusform>%1 far buildings left out of the first view.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 terrain(s) in the folder are not in the city: %2.</source>
        <translation>
            <numerusform>%1 terrain in the folder is not in the city: %2.</numerusform>
            <numerusform>%1 terrains in the folder are not in the city: %2.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::PhotographActions</name>
    <message numerus="yes">
        <source>%1 of %2 tile(s) are missing and stay empty</source>
        <translation>
            <numerusform>%1 of %2 tile is missing and stays empty</numerusform>
            <numerusform>%1 of %2 tiles are missing and stay empty</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::PlaceList</name>
    <message numerus="yes">
        <source>%1 of %2 place(s) ticked</source>
        <translation>
            <numerusform>%1 of %2 place ticked</numerusform>
            <numerusform>%1 of %2 places ticked</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s) in reach of the shadow; the others&apos; tooltips say why not</source>
        <translation>
            <numerusform>%1 of %2 place in reach of the shadow; the others&apos; tooltips say why not</numerusform>
            <numerusform>%1 of %2 places in reach of the shadow; the others&apos; tooltips say why not</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::PlacesDock</name>
    <message numerus="yes">
        <source>%1 of %2 place(s)</source>
        <translation>
            <numerusform>%1 of %2 place</numerusform>
            <numerusform>%1 of %2 places</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 place(s)</source>
        <translation>
            <numerusform>%1 place</numerusform>
            <numerusform>%1 places</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 place(s) listed</source>
        <translation>
            <numerusform>%1 of %2 place listed</numerusform>
            <numerusform>%1 of %2 places listed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::PointDock</name>
    <message numerus="yes">
        <source>and %1 more tree(s)</source>
        <translation>
            <numerusform>and %1 more tree</numerusform>
            <numerusform>and %1 more trees</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::ResultActions</name>
    <message numerus="yes">
        <source>All %1 scenario(s) measured</source>
        <translation>
            <numerusform>The %1 scenario measured</numerusform>
            <numerusform>All %1 scenarios measured</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::ResultsDock</name>
    <message numerus="yes">
        <source>%1 warning(s) about the data</source>
        <translation>
            <numerusform>%1 warning about the data</numerusform>
            <numerusform>%1 warnings about the data</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Back to all %1 place(s)</source>
        <translation>
            <numerusform>Back to the %1 place</numerusform>
            <numerusform>Back to all %1 places</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioActions</name>
    <message numerus="yes">
        <source>%1 building(s) saved as %2</source>
        <translation>
            <numerusform>%1 building saved as %2</numerusform>
            <numerusform>%1 buildings saved as %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::ScenarioTable</name>
    <message numerus="yes">
        <source>Over the area of the %Ln place(s) that were measured last</source>
        <translation>
            <numerusform>Over the area of the %Ln place that was measured last</numerusform>
            <numerusform>Over the area of the %Ln places that were measured last</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::TreeEditing</name>
    <message numerus="yes">
        <source>plant %1 tree(s)</source>
        <translation>
            <numerusform>plant %1 tree</numerusform>
            <numerusform>plant %1 trees</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>move %1 tree(s)</source>
        <translation>
            <numerusform>move %1 tree</numerusform>
            <numerusform>move %1 trees</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>fell %1 tree(s)</source>
        <translation>
            <numerusform>fell %1 tree</numerusform>
            <numerusform>fell %1 trees</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>replace %1 tree(s)</source>
        <translation>
            <numerusform>replace %1 tree</numerusform>
            <numerusform>replace %1 trees</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>noonmark::TreePanel</name>
    <message numerus="yes">
        <source>%1 tree(s) in the city. Click one to choose it, Ctrl adds more</source>
        <translation>
            <numerusform>%1 tree in the city. Click it to choose it</numerusform>
            <numerusform>%1 trees in the city. Click one to choose it, Ctrl adds more</numerusform>
        </translation>
    </message>
</context>
</TS>
