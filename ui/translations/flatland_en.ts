<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Bridge</name>
    <message numerus="yes">
        <source>%n left out: %1</source>
        <translation>
            <numerusform>%n left out: %1</numerusform>
            <numerusform>%n left out: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n curve(s), at most %1 from the section (unit of the file)</source>
        <translation>
            <numerusform>%n curve, at most %1 from the section (unit of the file)</numerusform>
            <numerusform>%n curves, at most %1 from the section (unit of the file)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Gesture</name>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points selected. Shift: add to the selection. Esc: take it back.</source>
        <translation>
            <numerusform>%n point selected. Shift: add to the selection. Esc: take it back.</numerusform>
            <numerusform>%n points selected. Shift: add to the selection. Esc: take it back.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SceneSummary</name>
    <message numerus="yes">
        <source>%n curves</source>
        <translation>
            <numerusform>%n curve</numerusform>
            <numerusform>%n curves</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n control points</source>
        <translation>
            <numerusform>%n control point</numerusform>
            <numerusform>%n control points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marks are hidden.</source>
        <translation>
            <numerusform>%n mark is hidden.</numerusform>
            <numerusform>%n marks are hidden.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>flatland::ui::SectionPanel</name>
    <message numerus="yes">
        <source>%n weaker than the view&apos;s threshold left out</source>
        <translation>
            <numerusform>%n weaker than the view&apos;s threshold left out</numerusform>
            <numerusform>%n weaker than the view&apos;s threshold left out</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>flatland::ui::StatusLine</name>
    <message numerus="yes">
        <source>all %n marks certified</source>
        <translation>
            <numerusform>the %n mark certified</numerusform>
            <numerusform>all %n marks certified</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n places unresolved</source>
        <translation>
            <numerusform>%n place unresolved</numerusform>
            <numerusform>%n places unresolved</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>all %n marks found to %1</source>
        <translation>
            <numerusform>the %n mark found to %1</numerusform>
            <numerusform>all %n marks found to %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>flatland::ui::SurfacePanel</name>
    <message numerus="yes">
        <source>%Ln vertices</source>
        <translation>
            <numerusform>%Ln vertex</numerusform>
            <numerusform>%Ln vertices</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangles</source>
        <translation>
            <numerusform>%Ln triangle</numerusform>
            <numerusform>%Ln triangles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>flatland::ui::SweepPanel</name>
    <message numerus="yes">
        <source>%n births or merges in half a turn</source>
        <translation>
            <numerusform>%n birth or merge in half a turn</numerusform>
            <numerusform>%n births or merges in half a turn</numerusform>
        </translation>
    </message>
</context>
</TS>
