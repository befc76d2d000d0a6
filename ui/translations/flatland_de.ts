<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AddCurve</name>
    <message>
        <source>add curve</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>Thesis figure 3-4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Five control points, seen from the right: silhouettes, ridges, a valley, inflections and apparent ridges on one curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Almost a circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The four-piece circle of drawing programs: its curvature wavers by three per cent, and so it has ridges that a circle has not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S-curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cubic with one inflection; turn the view until the silhouettes meet in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bump</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A bump on a plain, seen from straight above: the foot of the bump shows where the offset term moves an apparent ridge away from the ridge.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cusp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cubic whose speed vanishes at t = 1/2: the tangent turns back, a corner of 180 degrees.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A curve that crosses itself and hides part of itself from the screen.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>EditMenus</name>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back the last step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do the step again that was taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a curve in the middle of the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the curve picked last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raise &amp;Degree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One control point more in every piece; the shape stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Flip Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the normal round: ridges and valleys change places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to where this scene began</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;set to File as Opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;set to Preset “%1”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FileMenu</name>
    <message>
        <source>%1 (gone)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget all recent files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start over with the first preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scene file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scene under another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the picture as SVG, PDF, PNG or TikZ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FlatCanvas</name>
    <message>
        <source>Nothing here yet. Curve &gt; Add Curve draws one.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FlipNormal</name>
    <message>
        <source>flip normal</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Gesture</name>
    <message>
        <source>Drag to move the viewer; Shift steps by 15°, Ctrl keeps the distance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to turn the view; Shift steps by 15°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point %1 at (%2): drag to move it, Delete removes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at t = %2%3: click to find it in the table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, hidden from the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click to insert a point here; drag to move the whole curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a point to bend the curve, or the eye to turn the view. H shows all keys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving %1 by (%2). Ctrl: along one axis. Alt: leave the handles. Esc: take it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points selected. Shift: add to the selection. Esc: take it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marks follow from the curve and the view; the table tells this one&apos;s values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving the viewer. Shift: steps of 15°. Ctrl: same distance. Esc: take it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turning the view. Shift: steps of 15°. Esc: take it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>   distance %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving the picture. F: fit it into the window.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>InsertPoint</name>
    <message>
        <source>insert point</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LayoutMenu</name>
    <message>
        <source>&amp;Work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Canvas and all panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Picture-Making</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The canvas alone, with what an export needs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;rojector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full screen, large type, few panels; Esc leaves it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;estore Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The panels of this layout back to their places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Larger type, marks and lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smaller type, marks and lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Usual Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type, marks and lines as on the first day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colours of the desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;High Contrast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White on black, yellow for what is picked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language of the window, from its next start on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Wheel Zooms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A mouse wheel zooms; off: it moves the picture, and Ctrl + wheel zooms</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MarkWords</name>
    <message>
        <source>Silhouette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silhouettes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The line of sight touches the curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inflections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curvature changes sign.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ridge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curve bulges most to the side of its normal: a positive maximum of curvature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Valley</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Valleys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curve bulges most away from its normal: a negative minimum of curvature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curve is least curved here without being straight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tangent jumps: a kink or a cusp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apparent ridge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apparent ridges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curvature as seen on the screen, λ, has a maximum.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apparent minimum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apparent minima</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curvature as seen on the screen, λ, has a minimum.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All keys and mouse gestures on one sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Flatland</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What this program is</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MovePoints</name>
    <message>
        <source>move point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move points</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Panels</name>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Legend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marks</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlacePoint</name>
    <message>
        <source>type coordinates</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RaiseDegree</name>
    <message>
        <source>raise degree</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RemoveCurve</name>
    <message>
        <source>remove curve</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RemovePoints</name>
    <message>
        <source>remove points</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SetView</name>
    <message>
        <source>change projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ViewMenu</name>
    <message>
        <source>&amp;Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show it larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show it smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View from %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the viewer at %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The viewer stands at a distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Control Polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the lines between the control points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hidden Parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what the viewer cannot see, paler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or close this panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ne&amp;xt Pane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the focus on: canvas, panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre&amp;vious Pane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the focus back</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::EditController</name>
    <message>
        <source>Nothing is selected. Click a point or press Tab, then Delete.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curve has degree %1 already, the highest that can be edited here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reset</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::ExportDialog</name>
    <message>
        <source>Export picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file and write the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SVG and PDF stay sharp at any size; TikZ is for LaTeX</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SVG, vector graphics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF, vector graphics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG, pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TikZ, for LaTeX</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of width and height; 96 px are one inch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixels per inch of a PNG file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dots per inch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name the marks by letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Legend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Explain the marks in a legend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the lines between the control points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what the viewer cannot see, paler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave out the background</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::FileController</name>
    <message>
        <source>Flatland scenes (*.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save scene as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are lost otherwise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scene</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::FlatCanvas</name>
    <message>
        <source>Canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curve with its control points, the view handle, the screen and the marks. Tab steps through the points, arrow keys move them, F6 goes on to the panels.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::KeySheet</name>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the point, or the whole curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along one axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt + drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave its handles behind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click on the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert a point, shape kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click, Shift + click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select, select more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag on nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select by rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tab, Shift + Tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next, previous point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the selected points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift + arrow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ten times as far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl or Alt + arrow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A tenth as far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back a drag; deselect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + Shift + A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raise the degree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flip the normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + R</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Viewer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift + drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In steps of 15°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the distance (perspective)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 2 3 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View from 0°, 90°, 180°, 270°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perspective on or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel, pinch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle button, Space + drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two fingers on a trackpad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control polygon on or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden parts on or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Focus to the next panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files and steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + N, O, S</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New, open, save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + Shift + S</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + Shift + Z, Ctrl + Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>H, ?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys and gestures</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::Layouts</name>
    <message>
        <source>Esc leaves projector mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the window as it was (Esc or F11)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::LegendPanel</name>
    <message>
        <source>Hidden parts, paler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what lies behind the curve as seen from the viewer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::MainWindow</name>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language changes when the window is opened the next time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] – Flatland</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Flatland</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h3&gt;Flatland %1&lt;/h3&gt;&lt;p&gt;View-dependent curvature and apparent ridges of plane curves, seen on a one-dimensional screen.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::MarksModel</name>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What kind of mark it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the curve, from 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter on the curve: piece number plus place in the piece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arc length from the start of the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinate on the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View-dependent curvature squared; none at a silhouette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feature term of the apparent-ridge equation, (n·w) k k&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset term of the apparent-ridge equation, −k³ (t·w)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Term added by the perspective view; zero in an orthographic one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the mark&apos;s equation is from zero there, without dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether nothing lies between the mark and the viewer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::MarksPanel</name>
    <message>
        <source>Marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a row to highlight the mark; Enter or a double-click centres it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::PointsModel</name>
    <message>
        <source>The curve passes through this point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This point pulls the curve towards itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a number; the coordinate stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinates lie within %1; the coordinate stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::PointsPanel</name>
    <message>
        <source>Coordinate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click a coordinate, or press F2, to type it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::StatusLine</name>
    <message>
        <source>Where the pointer is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction, and in perspective distance, of the viewer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all %1 marks certified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether every mark was found and none invented, with certified signs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of the last search for marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 marks, %2 places unresolved</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>flatland::ui::ViewPanel</name>
    <message>
        <source>Direction from the curve to the viewer, counter-clockwise from the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The viewer stands at a distance; off: infinitely far away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the viewer from the origin, in scene lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the viewer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View from %1°</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
