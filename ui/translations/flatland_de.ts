<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AddCurve</name>
    <message>
        <source>add curve</source>
        <translation>Kurve hinzufügen</translation>
    </message>
</context>
<context>
    <name>Bridge</name>
    <message>
        <source>%1: none predicted</source>
        <translation>%1: keine vorhergesagt</translation>
    </message>
    <message>
        <source>%1: %2 of %3 predicted lines can be expected</source>
        <translation>%1: %2 von %3 vorhergesagten Linien sind zu erwarten</translation>
    </message>
    <message>
        <source>Apparent ridges</source>
        <translation>Scheinbare Grate</translation>
    </message>
    <message>
        <source>Contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <source>%1 cells, edges %2 long</source>
        <translation>%1 Zellen, Kanten %2 lang</translation>
    </message>
    <message numerus="yes">
        <source>%n left out: %1</source>
        <translation>
            <numerusform>%n ausgelassen: %1</numerusform>
            <numerusform>%n ausgelassen: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Predicted apparent ridge</source>
        <translation>Vorhergesagter scheinbarer Grat</translation>
    </message>
    <message>
        <source>Predicted contour</source>
        <translation>Vorhergesagte Kontur</translation>
    </message>
    <message>
        <source>%1, t = %2</source>
        <translation>%1, t = %2</translation>
    </message>
    <message>
        <source>There is no t_A here.</source>
        <translation>Hier gibt es kein t_A.</translation>
    </message>
    <message>
        <source>t_A leaves the plane by %1 degrees only: flatland&apos;s equation is nearly the surface&apos;s.</source>
        <translation>t_A weicht nur um %1 Grad von der Ebene ab: Flatlands Gleichung ist fast die der Fläche.</translation>
    </message>
    <message>
        <source>t_A leaves the plane by %1 degrees: λ is largest along the section, but not along t_A.</source>
        <translation>t_A weicht um %1 Grad von der Ebene ab: λ ist entlang des Schnitts am größten, nicht aber entlang t_A.</translation>
    </message>
    <message>
        <source>t_A leaves the plane by %1 degrees: λ is largest along t_A, but not along the section.</source>
        <translation>t_A weicht um %1 Grad von der Ebene ab: λ ist entlang t_A am größten, nicht aber entlang des Schnitts.</translation>
    </message>
    <message>
        <source>t_A leaves the plane by %1 degrees: flatland follows λ along the section, the surface along t_A.</source>
        <translation>t_A weicht um %1 Grad von der Ebene ab: Flatland folgt λ entlang des Schnitts, die Fläche entlang t_A.</translation>
    </message>
    <message>
        <source>The plane does not cut the surface.</source>
        <translation>Die Ebene schneidet die Fläche nicht.</translation>
    </message>
    <message>
        <source>; none of them found</source>
        <translation>; keine davon gefunden</translation>
    </message>
    <message>
        <source>; found %1 edges away (median), %2 % covered</source>
        <translation>; im Median %1 Kanten entfernt gefunden, %2 % abgedeckt</translation>
    </message>
    <message numerus="yes">
        <source>%n curve(s), at most %1 from the section (unit of the file)</source>
        <translation>
            <numerusform>%n Kurve, höchstens %1 vom Schnitt entfernt (Einheit der Datei)</numerusform>
            <numerusform>%n Kurven, höchstens %1 vom Schnitt entfernt (Einheit der Datei)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>BridgeMarks</name>
    <message>
        <source>predicted apparent ridge</source>
        <translation>vorhergesagter scheinbarer Grat</translation>
    </message>
    <message>
        <source>predicted contour</source>
        <translation>vorhergesagte Kontur</translation>
    </message>
</context>
<context>
    <name>BridgeMenu</name>
    <message>
        <source>E&amp;xtrude Curve</source>
        <translation>Kurve e&amp;xtrudieren</translation>
    </message>
    <message>
        <source>Make the selected curve a surface that follows it: moved across its plane</source>
        <translation>Die gewählte Kurve zu einer Fläche machen, die ihr folgt: quer zu ihrer Ebene verschoben</translation>
    </message>
    <message>
        <source>Re&amp;volve Curve</source>
        <translation>Kurve r&amp;otieren</translation>
    </message>
    <message>
        <source>Make the selected curve a surface that follows it: turned about an axis beside it</source>
        <translation>Die gewählte Kurve zu einer Fläche machen, die ihr folgt: um eine Achse neben ihr gedreht</translation>
    </message>
    <message>
        <source>Through the &amp;View Direction</source>
        <translation>Durch die &amp;Blickrichtung</translation>
    </message>
    <message>
        <source>A plane that holds the line of sight, through the picked point or the middle of the picture</source>
        <translation>Eine Ebene, die den Blickstrahl enthält, durch den gewählten Punkt oder die Bildmitte</translation>
    </message>
    <message>
        <source>Along &amp;t_A at the Picked Point</source>
        <translation>Entlang &amp;t_A am gewählten Punkt</translation>
    </message>
    <message>
        <source>A plane that holds the line of sight and t_A: there flatland&apos;s equation is the surface&apos;s</source>
        <translation>Eine Ebene, die den Blickstrahl und t_A enthält: dort ist Flatlands Gleichung die der Fläche</translation>
    </message>
    <message>
        <source>&amp;Open Section as Curve</source>
        <translation>Schnitt als &amp;Kurve öffnen</translation>
    </message>
    <message>
        <source>Put the section in the place of the scene&apos;s curves</source>
        <translation>Den Schnitt an die Stelle der Kurven der Szene setzen</translation>
    </message>
    <message>
        <source>Cuttin&amp;g Plane</source>
        <translation>Schnittebene</translation>
    </message>
</context>
<context>
    <name>CompareMenu</name>
    <message>
        <source>compare views</source>
        <translation>Ansichten vergleichen</translation>
    </message>
    <message>
        <source>Views of the surface side by side</source>
        <translation>Ansichten der Fläche nebeneinander</translation>
    </message>
    <message>
        <source>&amp;One View</source>
        <translation>&amp;Eine Ansicht</translation>
    </message>
    <message>
        <source>&amp;Two Views</source>
        <translation>&amp;Zwei Ansichten</translation>
    </message>
    <message>
        <source>&amp;Four Views</source>
        <translation>&amp;Vier Ansichten</translation>
    </message>
    <message>
        <source>&amp;Contours, Suggestive, Ridges, Apparent Ridges</source>
        <translation>&amp;Konturen, suggestive, Grate, scheinbare Grate</translation>
    </message>
    <message>
        <source>Four views: contours alone, and with each of the other families</source>
        <translation>Vier Ansichten: Konturen allein und mit je einer der anderen Familien</translation>
    </message>
    <message>
        <source>Closed Form and &amp;Neighbours</source>
        <translation>Geschlossene Form und &amp;Nachbarn</translation>
    </message>
    <message>
        <source>Apparent ridges by the closed form, and by differences between neighbours as in the thesis</source>
        <translation>Scheinbare Grate nach der geschlossenen Form und aus Differenzen zwischen Nachbarn wie in der Dissertation</translation>
    </message>
    <message>
        <source>&amp;Difference of the Two</source>
        <translation>&amp;Unterschied der beiden</translation>
    </message>
    <message>
        <source>Where the two derivatives give different apparent ridges</source>
        <translation>Wo die beiden Ableitungen verschiedene scheinbare Grate ergeben</translation>
    </message>
    <message>
        <source>&amp;Second Camera</source>
        <translation>Zweite &amp;Kamera</translation>
    </message>
    <message>
        <source>The lines of the first view seen from elsewhere</source>
        <translation>Die Linien der ersten Ansicht, von anderswo gesehen</translation>
    </message>
    <message>
        <source>Only the first view, with the lines it had before comparing</source>
        <translation>Nur die erste Ansicht, mit den Linien von vor dem Vergleich</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>Thesis figure 3-4</source>
        <translation>Abbildung 3-4 der Arbeit</translation>
    </message>
    <message>
        <source>Five control points, seen from the right: silhouettes, ridges, a valley, inflections and apparent ridges on one curve.</source>
        <translation>Fünf Kontrollpunkte, von rechts gesehen: Silhouetten, Grate, ein Tal, Wendepunkte und scheinbare Grate auf einer Kurve.</translation>
    </message>
    <message>
        <source>Almost a circle</source>
        <translation>Fast ein Kreis</translation>
    </message>
    <message>
        <source>The four-piece circle of drawing programs: its curvature wavers by three per cent, and so it has ridges that a circle has not.</source>
        <translation>Der Kreis der Zeichenprogramme aus vier Stücken: Seine Krümmung schwankt um drei Prozent, und so hat er Grate, die ein Kreis nicht hat.</translation>
    </message>
    <message>
        <source>S-curve</source>
        <translation>S-Kurve</translation>
    </message>
    <message>
        <source>A cubic with one inflection; turn the view until the silhouettes meet in it.</source>
        <translation>Eine Kubik mit einem Wendepunkt; drehen Sie die Ansicht, bis die Silhouetten in ihm zusammentreffen.</translation>
    </message>
    <message>
        <source>Bump</source>
        <translation>Beule</translation>
    </message>
    <message>
        <source>A bump on a plain, seen from straight above: the foot of the bump shows where the offset term moves an apparent ridge away from the ridge.</source>
        <translation>Eine Beule auf einer Ebene, genau von oben gesehen: Am Fuß der Beule zeigt sich, wo der Versatzterm einen scheinbaren Grat vom Grat fortrückt.</translation>
    </message>
    <message>
        <source>Cusp</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>A cubic whose speed vanishes at t = 1/2: the tangent turns back, a corner of 180 degrees.</source>
        <translation>Eine Kubik, deren Geschwindigkeit bei t = 1/2 verschwindet: Die Tangente kehrt um, eine Ecke von 180 Grad.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>A curve that crosses itself and hides part of itself from the screen.</source>
        <translation>Eine Kurve, die sich selbst kreuzt und einen Teil von sich vor dem Schirm verdeckt.</translation>
    </message>
    <message>
        <source>seen from %1</source>
        <translation>gesehen von %1</translation>
    </message>
    <message>
        <source>at distance %1</source>
        <translation>Abstand %1</translation>
    </message>
    <message>
        <source>paler: hidden</source>
        <translation>blasser: verdeckt</translation>
    </message>
    <message>
        <source>Silhouette</source>
        <translation>Silhouette</translation>
    </message>
    <message>
        <source>Inflection</source>
        <translation>Wendepunkt</translation>
    </message>
    <message>
        <source>Ridge</source>
        <translation>Grat</translation>
    </message>
    <message>
        <source>Valley</source>
        <translation>Tal</translation>
    </message>
    <message>
        <source>Flat point</source>
        <translation>Flachpunkt</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Apparent ridge</source>
        <translation>Scheinbarer Grat</translation>
    </message>
    <message>
        <source>Apparent minimum</source>
        <translation>Scheinbares Minimum</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Parabola</source>
        <translation>Parabel</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>Gaussian bump</source>
        <translation>Gaußsche Beule</translation>
    </message>
    <message>
        <source>Superellipse</source>
        <translation>Superellipse</translation>
    </message>
    <message>
        <source>Lissajous</source>
        <translation>Lissajous</translation>
    </message>
    <message>
        <source>Cycloid</source>
        <translation>Zykloide</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>half axis along x</source>
        <translation>Halbachse entlang x</translation>
    </message>
    <message>
        <source>half axis along y</source>
        <translation>Halbachse entlang y</translation>
    </message>
    <message>
        <source>steepness</source>
        <translation>Steilheit</translation>
    </message>
    <message>
        <source>half width</source>
        <translation>halbe Breite</translation>
    </message>
    <message>
        <source>half height</source>
        <translation>halbe Höhe</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>wave number</source>
        <translation>Wellenzahl</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>width of the bump</source>
        <translation>Breite der Beule</translation>
    </message>
    <message>
        <source>half width of the curve</source>
        <translation>halbe Breite der Kurve</translation>
    </message>
    <message>
        <source>exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>swings along x</source>
        <translation>Schwingungen entlang x</translation>
    </message>
    <message>
        <source>swings along y</source>
        <translation>Schwingungen entlang y</translation>
    </message>
    <message>
        <source>phase, degrees</source>
        <translation>Phase, Grad</translation>
    </message>
    <message>
        <source>radius of the wheel</source>
        <translation>Radius des Rads</translation>
    </message>
    <message>
        <source>distance of the pen from the hub; r gives cusps</source>
        <translation>Abstand des Stifts von der Nabe; r gibt Spitzen</translation>
    </message>
    <message>
        <source>arches</source>
        <translation>Bögen</translation>
    </message>
    <message>
        <source>Bezier curve</source>
        <translation>Bézierkurve</translation>
    </message>
    <message>
        <source>Bezier chain</source>
        <translation>Bézier-Kette</translation>
    </message>
    <message>
        <source>B-spline</source>
        <translation>B-Spline</translation>
    </message>
    <message>
        <source>rational Bezier</source>
        <translation>rationale Bézierkurve</translation>
    </message>
    <message>
        <source>formula</source>
        <translation>Formel</translation>
    </message>
    <message>
        <source>a curve needs at least 2 control points</source>
        <translation>eine Kurve braucht mindestens 2 Kontrollpunkte</translation>
    </message>
    <message>
        <source>only joints can be removed from a chain; this point is a handle</source>
        <translation>aus einer Kette lassen sich nur Gelenke entfernen; dieser Punkt ist ein Griff</translation>
    </message>
    <message>
        <source>too few joints would stay: remove the whole curve instead</source>
        <translation>es blieben zu wenige Gelenke: Entfernen Sie die ganze Kurve</translation>
    </message>
    <message>
        <source>The curve is given by a formula and has no points; convert it to a Bezier chain first.</source>
        <translation>Die Kurve ist durch eine Formel gegeben und hat keine Punkte; wandeln Sie sie erst in eine Bézier-Kette um.</translation>
    </message>
    <message>
        <source>Points of a rational chain cannot be removed; convert it to a Bezier chain first.</source>
        <translation>Punkte einer rationalen Kette lassen sich nicht entfernen; wandeln Sie sie erst in eine Bézier-Kette um.</translation>
    </message>
    <message>
        <source>A rational Bezier curve keeps at least 2 points.</source>
        <translation>Eine rationale Bézierkurve behält mindestens 2 Punkte.</translation>
    </message>
    <message>
        <source>The degree of a B-spline stays; convert it to a Bezier chain to raise it.</source>
        <translation>Der Grad eines B-Splines bleibt; wandeln Sie ihn in eine Bézier-Kette um, um ihn zu erhöhen.</translation>
    </message>
    <message>
        <source>The curve is given by a formula and has no degree.</source>
        <translation>Die Kurve ist durch eine Formel gegeben und hat keinen Grad.</translation>
    </message>
    <message>
        <source>the defining polynomial cannot be told from zero</source>
        <translation>das bestimmende Polynom ist von null nicht zu unterscheiden</translation>
    </message>
    <message>
        <source>none or an even number of roots too close to tell apart</source>
        <translation>keine oder eine gerade Zahl von Nullstellen, zu nah, um sie zu trennen</translation>
    </message>
    <message>
        <source>an odd number of roots too close to count; one is marked</source>
        <translation>eine ungerade Zahl von Nullstellen, zu nah, um sie zu zählen; eine ist markiert</translation>
    </message>
    <message>
        <source>curvature is infinite here, of undecided sign</source>
        <translation>die Krümmung ist hier unendlich, ihr Vorzeichen unentschieden</translation>
    </message>
    <message>
        <source>the curve is too large or too small for double precision</source>
        <translation>die Kurve ist zu groß oder zu klein für doppelte Genauigkeit</translation>
    </message>
    <message>
        <source>the formula is nested too deeply</source>
        <translation>die Formel ist zu tief geschachtelt</translation>
    </message>
    <message>
        <source>something is missing here</source>
        <translation>hier fehlt etwas</translation>
    </message>
    <message>
        <source>a ) is missing</source>
        <translation>eine ) fehlt</translation>
    </message>
    <message>
        <source>there is no ( for this )</source>
        <translation>zu dieser ) gibt es keine (</translation>
    </message>
    <message>
        <source>this number is out of range</source>
        <translation>diese Zahl ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>this is not a number</source>
        <translation>das ist keine Zahl</translation>
    </message>
    <message>
        <source>t cannot stand here: the domain of t must not depend on it</source>
        <translation>t kann hier nicht stehen: Der Bereich von t darf nicht von t abhängen</translation>
    </message>
    <message>
        <source>a name begins with a letter</source>
        <translation>ein Name beginnt mit einem Buchstaben</translation>
    </message>
    <message>
        <source>a name has only letters a-z, digits and _</source>
        <translation>ein Name hat nur Buchstaben a-z, Ziffern und _</translation>
    </message>
    <message>
        <source>the name is longer than 64 letters</source>
        <translation>der Name ist länger als 64 Zeichen</translation>
    </message>
    <message>
        <source>the name is taken already</source>
        <translation>der Name ist schon vergeben</translation>
    </message>
    <message>
        <source>this is not a finite number</source>
        <translation>das ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>this is beyond 1e15</source>
        <translation>das liegt jenseits von 1e15</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Degenerate cases</source>
        <translation>Entartete Fälle</translation>
    </message>
    <message>
        <source>One corner of 180 degrees at the tip, which is a silhouette too because the image folds there, and one apparent minimum near the lower left end. No ridge: at the tip curvature is infinite and changes sign.</source>
        <translation>Eine Ecke von 180 Grad an der Spitze, die auch Silhouette ist, weil das Bild dort umkehrt, und ein scheinbares Minimum nahe dem linken unteren Ende. Kein Grat: An der Spitze ist die Krümmung unendlich und wechselt das Vorzeichen.</translation>
    </message>
    <message>
        <source>Pause on the way</source>
        <translation>Halt unterwegs</translation>
    </message>
    <message>
        <source>x = u^3, y = u^4: the speed vanishes at u = 0, but the tangent does not turn back, y = x^(4/3).</source>
        <translation>x = u^3, y = u^4: Bei u = 0 verschwindet die Geschwindigkeit, doch die Tangente kehrt nicht um, y = x^(4/3).</translation>
    </message>
    <message>
        <source>One valley and one apparent ridge, both at the lowest point, where curvature is infinite. No corner: the tangent is continuous.</source>
        <translation>Ein Tal und ein scheinbarer Grat, beide am tiefsten Punkt, wo die Krümmung unendlich ist. Keine Ecke: Die Tangente ist stetig.</translation>
    </message>
    <message>
        <source>Points on a line</source>
        <translation>Punkte auf einer Geraden</translation>
    </message>
    <message>
        <source>Four control points on a slanted line: curvature is 0 everywhere, so every point would be an inflection.</source>
        <translation>Vier Kontrollpunkte auf einer schrägen Geraden: Die Krümmung ist überall 0, also wäre jeder Punkt ein Wendepunkt.</translation>
    </message>
    <message>
        <source>No mark at all. The curve is listed as straight.</source>
        <translation>Gar keine Marke. Die Kurve wird als gerade aufgeführt.</translation>
    </message>
    <message>
        <source>Line seen end-on</source>
        <translation>Gerade, längs gesehen</translation>
    </message>
    <message>
        <source>A straight curve seen along itself: its image is one point, and every point would be a silhouette.</source>
        <translation>Eine gerade Kurve, längs gesehen: Ihr Bild ist ein Punkt, und jeder Punkt wäre Silhouette.</translation>
    </message>
    <message>
        <source>No mark at all. The curve is listed as straight and seen end-on.</source>
        <translation>Gar keine Marke. Die Kurve wird als gerade und längs gesehen aufgeführt.</translation>
    </message>
    <message>
        <source>Line that turns back</source>
        <translation>Gerade, die umkehrt</translation>
    </message>
    <message>
        <source>Three points on a line, the ends in the same place: there and back again.</source>
        <translation>Drei Punkte auf einer Geraden, die Enden am selben Ort: hin und wieder zurück.</translation>
    </message>
    <message>
        <source>One corner of 180 degrees at the far end, a silhouette too. Both halves are listed as straight.</source>
        <translation>Eine Ecke von 180 Grad am fernen Ende, auch Silhouette. Beide Hälften werden als gerade aufgeführt.</translation>
    </message>
    <message>
        <source>All points equal</source>
        <translation>Alle Punkte gleich</translation>
    </message>
    <message>
        <source>Four control points in one place: a curve without length.</source>
        <translation>Vier Kontrollpunkte an einem Ort: eine Kurve ohne Länge.</translation>
    </message>
    <message>
        <source>No mark at all. The curve is listed as a point.</source>
        <translation>Gar keine Marke. Die Kurve wird als Punkt aufgeführt.</translation>
    </message>
    <message>
        <source>Coincident control points</source>
        <translation>Zusammenfallende Kontrollpunkte</translation>
    </message>
    <message>
        <source>The first two control points are one: the curve starts at speed 0.</source>
        <translation>Die ersten beiden Kontrollpunkte sind einer: Die Kurve beginnt mit Geschwindigkeit 0.</translation>
    </message>
    <message>
        <source>One ridge and one apparent ridge at the crest; one flat point and one apparent minimum before it. Nothing at the start: its curvature is infinite, but an end has no extremum.</source>
        <translation>Ein Grat und ein scheinbarer Grat am Scheitel; davor ein Flachpunkt und ein scheinbares Minimum. Nichts am Anfang: Dort ist die Krümmung unendlich, aber ein Ende hat kein Extremum.</translation>
    </message>
    <message>
        <source>Inflection at an end</source>
        <translation>Wendepunkt an einem Ende</translation>
    </message>
    <message>
        <source>y = 4/9 x^3 from x = 0: curvature vanishes at the very start.</source>
        <translation>y = 4/9 x^3 ab x = 0: Die Krümmung verschwindet genau am Anfang.</translation>
    </message>
    <message>
        <source>One inflection at t = 0, one valley at x = (9/80)^(1/4) = 0.579 and one apparent ridge at x = (3/16)^(1/4) = 0.658.</source>
        <translation>Ein Wendepunkt bei t = 0, ein Tal bei x = (9/80)^(1/4) = 0.579 und ein scheinbarer Grat bei x = (3/16)^(1/4) = 0.658.</translation>
    </message>
    <message>
        <source>Silhouette at an inflection</source>
        <translation>Silhouette an einem Wendepunkt</translation>
    </message>
    <message>
        <source>y = 8/27 x^3 seen along its tangent at the origin: n.w touches 0 there and keeps its sign, a double root.</source>
        <translation>y = 8/27 x^3, längs der Tangente im Ursprung gesehen: n.w berührt dort 0 und behält sein Vorzeichen, eine doppelte Nullstelle.</translation>
    </message>
    <message>
        <source>One silhouette and one inflection, both at t = 1/2; a valley and a ridge at x = -0.709 and 0.709. No apparent ridge: lambda only grows towards the silhouette.</source>
        <translation>Eine Silhouette und ein Wendepunkt, beide bei t = 1/2; ein Tal und ein Grat bei x = -0.709 und 0.709. Kein scheinbarer Grat: Lambda wächst nur zur Silhouette hin.</translation>
    </message>
    <message>
        <source>Undulation</source>
        <translation>Flachpunkt höherer Ordnung</translation>
    </message>
    <message>
        <source>y = x^4: curvature touches 0 at the middle and keeps its sign, a double root.</source>
        <translation>y = x^4: Die Krümmung berührt in der Mitte 0 und behält ihr Vorzeichen, eine doppelte Nullstelle.</translation>
    </message>
    <message>
        <source>No inflection. A flat point and an apparent minimum with lambda = 0 at t = 1/2; valleys at x = -+(1/56)^(1/6) = 0.511, apparent ridges at x = -+(1/32)^(1/6) = 0.561.</source>
        <translation>Kein Wendepunkt. Ein Flachpunkt und ein scheinbares Minimum mit Lambda = 0 bei t = 1/2; Täler bei x = -+(1/56)^(1/6) = 0.511, scheinbare Grate bei x = -+(1/32)^(1/6) = 0.561.</translation>
    </message>
    <message>
        <source>Double root of k&apos;</source>
        <translation>Doppelte Nullstelle von k&apos;</translation>
    </message>
    <message>
        <source>A curve that bends ever less from left to right; at the middle the loss stops, k&apos; = k&apos;&apos; = 0, and goes on.</source>
        <translation>Eine Kurve, die sich von links nach rechts immer weniger krümmt; in der Mitte hält die Abnahme inne, k&apos; = k&apos;&apos; = 0, und geht weiter.</translation>
    </message>
    <message>
        <source>No ridge, valley or flat point: k&apos; keeps its sign. One apparent minimum and one apparent ridge, to the left and right of the middle.</source>
        <translation>Kein Grat, Tal oder Flachpunkt: k&apos; behält sein Vorzeichen. Ein scheinbares Minimum und ein scheinbarer Grat, links und rechts der Mitte.</translation>
    </message>
    <message>
        <source>Straight, then bent</source>
        <translation>Erst gerade, dann gekrümmt</translation>
    </message>
    <message>
        <source>A straight piece that goes over smoothly into a cubic: on the first k and k&apos; are 0 throughout.</source>
        <translation>Ein gerades Stück, das glatt in eine Kubik übergeht: Auf dem ersten sind k und k&apos; überall 0.</translation>
    </message>
    <message>
        <source>Nothing on the straight piece, which is listed as straight, and nothing at the joint. On the cubic a valley, and a silhouette at its end.</source>
        <translation>Nichts auf dem geraden Stück, das als gerade aufgeführt wird, und nichts an der Nahtstelle. Auf der Kubik ein Tal und eine Silhouette an ihrem Ende.</translation>
    </message>
    <message>
        <source>Corner with a fold</source>
        <translation>Ecke mit Umkehr</translation>
    </message>
    <message>
        <source>Two straight pieces that meet at an angle; seen from the right the image turns back at the corner.</source>
        <translation>Zwei gerade Stücke, die sich in einem Winkel treffen; von rechts gesehen kehrt das Bild an der Ecke um.</translation>
    </message>
    <message>
        <source>A corner of 119.7 degrees, which is a silhouette too; seen from above it is the corner alone. Both pieces are listed as straight.</source>
        <translation>Eine Ecke von 119.7 Grad, die auch Silhouette ist; von oben gesehen ist sie nur Ecke. Beide Stücke werden als gerade aufgeführt.</translation>
    </message>
    <message>
        <source>Curvature jumps</source>
        <translation>Die Krümmung springt</translation>
    </message>
    <message>
        <source>Two parabolas with a common tangent at the crest, where curvature jumps from 1 to 4.</source>
        <translation>Zwei Parabeln mit gemeinsamer Tangente am Scheitel, wo die Krümmung von 1 auf 4 springt.</translation>
    </message>
    <message>
        <source>One ridge and one apparent ridge, both at the joint, with the larger of its two curvatures: lambda = 16.</source>
        <translation>Ein Grat und ein scheinbarer Grat, beide an der Nahtstelle, mit der größeren der beiden Krümmungen: Lambda = 16.</translation>
    </message>
    <message>
        <source>Constant curvature</source>
        <translation>Konstante Krümmung</translation>
    </message>
    <message>
        <source>A true circle, given by its formula: k&apos; is 0 everywhere, so every point would be an extremum.</source>
        <translation>Ein echter Kreis, durch seine Formel gegeben: k&apos; ist überall 0, so dass jeder Punkt ein Extremum wäre.</translation>
    </message>
    <message>
        <source>Two silhouettes, left and right, and two apparent minima with lambda = 1, facing the viewer and away. No ridge and no apparent ridge. The curve is listed as of constant curvature.</source>
        <translation>Zwei Silhouetten, links und rechts, und zwei scheinbare Minima mit lambda = 1, dem Betrachter zu- und abgewandt. Kein Grat und kein scheinbarer Grat. Die Kurve ist als von konstanter Krümmung aufgeführt.</translation>
    </message>
    <message>
        <source>Exterior silhouette</source>
        <translation>Äußere Silhouette</translation>
    </message>
    <message>
        <source>Occluding contours</source>
        <translation>Verdeckende Konturen</translation>
    </message>
    <message>
        <source>Suggestive contours</source>
        <translation>Suggestive Konturen</translation>
    </message>
    <message>
        <source>Suggestive highlights</source>
        <translation>Suggestive Glanzlinien</translation>
    </message>
    <message>
        <source>Apparent ridges</source>
        <translation>Scheinbare Grate</translation>
    </message>
    <message>
        <source>Principal highlights</source>
        <translation>Hauptglanzlinien</translation>
    </message>
    <message>
        <source>Isophotes</source>
        <translation>Isophoten</translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation>Grate</translation>
    </message>
    <message>
        <source>Valleys</source>
        <translation>Täler</translation>
    </message>
    <message>
        <source>Parabolic lines</source>
        <translation>Parabolische Linien</translation>
    </message>
    <message>
        <source>Zero mean curvature</source>
        <translation>Mittelkrümmung 0</translation>
    </message>
    <message>
        <source>Creases</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Boundaries</source>
        <translation>Ränder</translation>
    </message>
    <message>
        <source>Self-intersections</source>
        <translation>Durchdringungen</translation>
    </message>
    <message>
        <source>Topographic lines</source>
        <translation>Höhenlinien</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>torus</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>ellipsoid</source>
        <translation>Ellipsoid</translation>
    </message>
    <message>
        <source>saddle</source>
        <translation>Sattel</translation>
    </message>
    <message>
        <source>sine sheet</source>
        <translation>Sinusblatt</translation>
    </message>
    <message>
        <source>gaussian bump</source>
        <translation>Gaußscher Buckel</translation>
    </message>
    <message>
        <source>rounded cube</source>
        <translation>Gerundeter Würfel</translation>
    </message>
    <message>
        <source>bumpy sphere</source>
        <translation>Bucklige Kugel</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known: %2</source>
        <translation>&quot;%1&quot; ist unbekannt: %2</translation>
    </message>
    <message>
        <source>%1 needs its argument in ( )</source>
        <translation>%1 braucht sein Argument in ( )</translation>
    </message>
    <message>
        <source>%1 needs two arguments with a comma between them</source>
        <translation>%1 braucht zwei Argumente mit einem Komma dazwischen</translation>
    </message>
    <message>
        <source>%1 takes %2; a decimal is written with a point</source>
        <translation>%1 nimmt %2; Dezimalzahlen werden mit Punkt geschrieben</translation>
    </message>
    <message>
        <source>an operator is missing before &quot;%1&quot;; a product is written 2*t</source>
        <translation>vor &quot;%1&quot; fehlt ein Rechenzeichen; ein Produkt schreibt man 2*t</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot stand here</source>
        <translation>&quot;%1&quot; darf hier nicht stehen</translation>
    </message>
    <message>
        <source>the formula is longer than %1 characters</source>
        <translation>die Formel ist länger als %1 Zeichen</translation>
    </message>
    <message>
        <source>the domain must end above %1</source>
        <translation>der Bereich muss über %1 enden</translation>
    </message>
    <message>
        <source>%1 is beyond 1e50 at t = %2</source>
        <translation>%1 liegt bei t = %2 jenseits von 1e50</translation>
    </message>
    <message>
        <source>%1 has no finite value at t = %2</source>
        <translation>%1 hat bei t = %2 keinen endlichen Wert</translation>
    </message>
    <message>
        <source>%1 grows beyond all bounds at t = %2</source>
        <translation>%1 wächst bei t = %2 über alle Grenzen</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>%1 must be from %2 to %3</source>
        <translation>%1 muss von %2 bis %3 reichen</translation>
    </message>
    <message>
        <source>%1 must be a whole number</source>
        <translation>%1 muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>weight %1 is not above 0</source>
        <translation>Gewicht %1 ist nicht größer als 0</translation>
    </message>
    <message>
        <source>a degree of %1 is below 1</source>
        <translation>ein Grad von %1 liegt unter 1</translation>
    </message>
    <message>
        <source>degree %1 is above %2, the highest supported</source>
        <translation>Grad %1 liegt über %2, dem höchsten erlaubten</translation>
    </message>
    <message>
        <source>degree %1 with %2 points: %3</source>
        <translation>Grad %1 mit %2 Punkten: %3</translation>
    </message>
    <message>
        <source>a closed chain of m pieces needs %1 m points (the first is not repeated)</source>
        <translation>eine geschlossene Kette von m Stücken braucht %1 m Punkte (der erste wird nicht wiederholt)</translation>
    </message>
    <message>
        <source>an open chain of m pieces needs %1 m + 1 points</source>
        <translation>eine offene Kette von m Stücken braucht %1 m + 1 Punkte</translation>
    </message>
    <message>
        <source>a B-spline of degree %1 needs at least %2 points, found %3</source>
        <translation>ein B-Spline vom Grad %1 braucht mindestens %2 Punkte, gefunden: %3</translation>
    </message>
    <message>
        <source>a Bezier curve needs at least 2 points, found %1</source>
        <translation>eine Bézierkurve braucht mindestens 2 Punkte, gefunden: %1</translation>
    </message>
    <message>
        <source>expected %1 knots for %2 points of degree %3, found %4</source>
        <translation>erwartet werden %1 Knoten für %2 Punkte vom Grad %3, gefunden: %4</translation>
    </message>
    <message>
        <source>expected %1 weights, one for each point, found %2</source>
        <translation>erwartet werden %1 Gewichte, eines je Punkt, gefunden: %2</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>column %1: %2</source>
        <translation>Spalte %1: %2</translation>
    </message>
    <message>
        <source>%1, character %2</source>
        <translation>%1, Zeichen %2</translation>
    </message>
    <message>
        <source>not valid JSON: %1</source>
        <translation>kein gültiges JSON: %1</translation>
    </message>
    <message>
        <source>number %1 is too large for a double</source>
        <translation>die Zahl %1 ist zu groß</translation>
    </message>
    <message>
        <source>the number %1 is too large</source>
        <translation>die Zahl %1 ist zu groß</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is there twice</source>
        <translation>der Schlüssel &quot;%1&quot; steht doppelt da</translation>
    </message>
    <message>
        <source>nested deeper than %1 levels</source>
        <translation>tiefer als %1 Ebenen verschachtelt</translation>
    </message>
    <message>
        <source>nested deeper than %1</source>
        <translation>tiefer als %1 Ebenen verschachtelt</translation>
    </message>
    <message>
        <source>missing &quot;%1&quot; or &quot;%2&quot;</source>
        <translation>es fehlt &quot;%1&quot; oder &quot;%2&quot;</translation>
    </message>
    <message>
        <source>missing &quot;%1&quot;</source>
        <translation>es fehlt &quot;%1&quot;</translation>
    </message>
    <message>
        <source>unknown key %1; known here: %2</source>
        <translation>unbekannter Schlüssel %1; hier bekannt: %2</translation>
    </message>
    <message>
        <source>a key too many; known here: %1</source>
        <translation>ein Schlüssel zu viel; hier bekannt: %1</translation>
    </message>
    <message>
        <source>there is no family %1; known: %2</source>
        <translation>es gibt keine Familie %1; bekannt: %2</translation>
    </message>
    <message>
        <source>expected a whole number, found %1</source>
        <translation>erwartet wird eine ganze Zahl, gefunden: %1</translation>
    </message>
    <message>
        <source>expected a degree of at least 1, found %1</source>
        <translation>erwartet wird ein Grad von mindestens 1, gefunden: %1</translation>
    </message>
    <message>
        <source>expected a distance above 0, found %1</source>
        <translation>erwartet wird ein Abstand über 0, gefunden: %1</translation>
    </message>
    <message>
        <source>expected version 1 to 4, found %1</source>
        <translation>erwartet wird Version 1 bis 4, gefunden: %1</translation>
    </message>
    <message>
        <source>expected 2 numbers [x, y], found %1</source>
        <translation>erwartet werden 2 Zahlen [x, y], gefunden: %1</translation>
    </message>
    <message>
        <source>expected 4 numbers, found %1</source>
        <translation>erwartet werden 4 Zahlen, gefunden: %1</translation>
    </message>
    <message>
        <source>expected a number after the comma, found %1</source>
        <translation>nach dem Komma wird eine Zahl erwartet, gefunden: %1</translation>
    </message>
    <message>
        <source>expected a path command, found %1</source>
        <translation>erwartet wird ein Pfadbefehl, gefunden: %1</translation>
    </message>
    <message>
        <source>a path begins with M or m, found %1</source>
        <translation>ein Pfad beginnt mit M oder m, gefunden: %1</translation>
    </message>
    <message>
        <source>expected %1, found %2</source>
        <translation>erwartet: %1, gefunden: %2</translation>
    </message>
    <message>
        <source>%1 is beyond %2, the largest length supported</source>
        <translation>%1 liegt über %2, der größten erlaubten Länge</translation>
    </message>
    <message>
        <source>&quot;%1&quot; came with version 2; write &quot;flatland&quot;: 2</source>
        <translation>&quot;%1&quot; gibt es seit Version 2; dafür &quot;flatland&quot;: 2 schreiben</translation>
    </message>
    <message>
        <source>has both &quot;%1&quot; and &quot;%2&quot;; give one</source>
        <translation>hat sowohl &quot;%1&quot; als auch &quot;%2&quot;; nur eines angeben</translation>
    </message>
    <message>
        <source>version %1 was made by a newer Flatland; this one reads up to version %2</source>
        <translation>Version %1 stammt von einem neueren Flatland; dieses liest bis Version %2</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>ist nicht lesbar: %1</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>ist nicht schreibbar: %1</translation>
    </message>
    <message>
        <source>cannot be replaced: %1</source>
        <translation>lässt sich nicht ersetzen: %1</translation>
    </message>
    <message>
        <source>is not well-formed XML: %1</source>
        <translation>ist kein wohlgeformtes XML: %1</translation>
    </message>
    <message>
        <source>is not SVG: its outermost element is %1</source>
        <translation>ist kein SVG: das äußerste Element ist %1</translation>
    </message>
    <message>
        <source>has no curve to show; %1</source>
        <translation>enthält keine Kurve; %1</translation>
    </message>
    <message>
        <source>has %1 pieces, more than the %2 that the window can follow; flatland features takes them all</source>
        <translation>hat %1 Stücke, mehr als die %2, denen das Fenster folgen kann; flatland features nimmt sie alle</translation>
    </message>
    <message>
        <source>there is no such font here; the nearest names are %1</source>
        <translation>diese Schrift gibt es hier nicht; die ähnlichsten Namen: %1</translation>
    </message>
    <message>
        <source>the font has no glyph for %1; %2</source>
        <translation>die Schrift hat kein Zeichen für %1; %2</translation>
    </message>
    <message>
        <source>more than %1 steps</source>
        <translation>mehr als %1 Schritte</translation>
    </message>
    <message>
        <source>no such preset; there are %1</source>
        <translation>kein solches Beispiel; es gibt %1</translation>
    </message>
    <message>
        <source>no such panel; there are %1</source>
        <translation>kein solches Bedienfeld; es gibt %1</translation>
    </message>
    <message>
        <source>no such equation; there are %1</source>
        <translation>keine solche Gleichung; es gibt %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: %2</source>
        <translation>&quot;%1&quot;: %2</translation>
    </message>
    <message>
        <source>Silhouettes</source>
        <translation>Silhouetten</translation>
    </message>
    <message>
        <source>Inflections</source>
        <translation>Wendepunkte</translation>
    </message>
    <message>
        <source>Flat points</source>
        <translation>Flachpunkte</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Apparent minima</source>
        <translation>Scheinbare Minima</translation>
    </message>
    <message>
        <source>Born or merged</source>
        <translation>Geboren oder verschmolzen</translation>
    </message>
    <message>
        <source>view direction (orthographic)</source>
        <translation>Blickrichtung (orthografisch)</translation>
    </message>
    <message>
        <source>arc length</source>
        <translation>Bogenlänge</translation>
    </message>
    <message>
        <source>no power law here</source>
        <translation>hier kein Potenzgesetz</translation>
    </message>
    <message>
        <source>predicted slope %1</source>
        <translation>vorhergesagte Steigung %1</translation>
    </message>
    <message>
        <source>fitted %1</source>
        <translation>angepasst %1</translation>
    </message>
    <message>
        <source>medians of %1 curves</source>
        <translation>Mediane von %1 Kurven</translation>
    </message>
    <message>
        <source>%1 pairs</source>
        <translation>%1 Paare</translation>
    </message>
    <message>
        <source>median %1</source>
        <translation>Median %1</translation>
    </message>
    <message>
        <source>quartiles %1, %2</source>
        <translation>Quartile %1, %2</translation>
    </message>
    <message>
        <source>thesis: 1/100,000</source>
        <translation>Dissertation: 1/100.000</translation>
    </message>
    <message>
        <source>square of side %1</source>
        <translation>Quadrat mit Seite %1</translation>
    </message>
    <message>
        <source>|offset| / |feature|</source>
        <translation>|Versatz| / |Merkmal|</translation>
    </message>
    <message>
        <source>|offset| / |feature|, the same curves in three kinds of unit</source>
        <translation>|Versatz| / |Merkmal|, dieselben Kurven in drei Arten von Einheiten</translation>
    </message>
    <message>
        <source>apparent ridge to its ridge or valley, on the screen / length of the curve</source>
        <translation>scheinbarer Grat bis zu seinem Grat oder Tal, auf dem Schirm / Länge der Kurve</translation>
    </message>
    <message>
        <source>arc-length</source>
        <translation>Bogenlänge</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>unnormalised</source>
        <translation>nicht normiert</translation>
    </message>
    <message>
        <source>there is no such function</source>
        <translation>eine solche Funktion gibt es nicht</translation>
    </message>
    <message>
        <source>neither t, pi, e nor a constant</source>
        <translation>weder t, pi, e noch eine Konstante</translation>
    </message>
    <message>
        <source>the curve turns too often for its domain</source>
        <translation>die Kurve windet sich zu oft für ihren Bereich</translation>
    </message>
    <message>
        <source>one argument</source>
        <translation>ein Argument</translation>
    </message>
    <message>
        <source>two arguments</source>
        <translation>zwei Argumente</translation>
    </message>
    <message>
        <source>a closed chain needs at least 2 points</source>
        <translation>eine geschlossene Kette braucht mindestens 2 Punkte</translation>
    </message>
    <message>
        <source>the largest weight is more than a million times the smallest</source>
        <translation>das größte Gewicht ist mehr als millionenmal so groß wie das kleinste</translation>
    </message>
    <message>
        <source>top level</source>
        <translation>oberste Ebene</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>not UTF-8 text</source>
        <translation>kein UTF-8-Text</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>ist nicht lesbar</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>ist nicht schreibbar</translation>
    </message>
    <message>
        <source>cannot be written to the end</source>
        <translation>ist nicht bis zum Ende schreibbar</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Zugriff verweigert</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>Ist kein Ordner</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Kein Platz mehr auf dem Gerät</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Dateisystem nur lesbar</translation>
    </message>
    <message>
        <source>larger than 64 MiB, too large for a scene</source>
        <translation>größer als 64 MiB, zu groß für eine Szene</translation>
    </message>
    <message>
        <source>larger than 16 MiB, too large for a drawing</source>
        <translation>größer als 16 MiB, zu groß für eine Zeichnung</translation>
    </message>
    <message>
        <source>larger than 1 MiB, too large for a lesson</source>
        <translation>größer als 1 MiB, zu groß für eine Lektion</translation>
    </message>
    <message>
        <source>missing &quot;flatland&quot;: 1, which marks a scene and its version</source>
        <translation>es fehlt &quot;flatland&quot;: 1, das eine Szene und ihre Version kennzeichnet</translation>
    </message>
    <message>
        <source>missing &quot;curves&quot;</source>
        <translation>es fehlt &quot;curves&quot;</translation>
    </message>
    <message>
        <source>not a finite number</source>
        <translation>keine endliche Zahl</translation>
    </message>
    <message>
        <source>expected 2 numbers [x, y]</source>
        <translation>erwartet werden 2 Zahlen [x, y]</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a string</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a number or a string</source>
        <translation>eine Zahl oder ein Text</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>wahr oder falsch (true, false)</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>a list of points [x, y]</source>
        <translation>eine Liste von Punkten [x, y]</translation>
    </message>
    <message>
        <source>a point [x, y]</source>
        <translation>ein Punkt [x, y]</translation>
    </message>
    <message>
        <source>a list of curves</source>
        <translation>eine Liste von Kurven</translation>
    </message>
    <message>
        <source>null</source>
        <translation>null</translation>
    </message>
    <message>
        <source>is compressed; unpack it first (gunzip -c x.svgz &gt; x.svg)</source>
        <translation>ist gepackt; zuerst entpacken (gunzip -c x.svgz &gt; x.svg)</translation>
    </message>
    <message>
        <source>has no curve to show</source>
        <translation>enthält keine Kurve</translation>
    </message>
    <message>
        <source>has coordinates beyond 1e50, the largest supported</source>
        <translation>hat Koordinaten über 1e50, dem größten erlaubten Wert</translation>
    </message>
    <message>
        <source>is too small to be seen</source>
        <translation>ist zu klein, um sichtbar zu sein</translation>
    </message>
    <message>
        <source>there are no fonts here</source>
        <translation>hier gibt es keine Schriften</translation>
    </message>
    <message>
        <source>is a font without outlines</source>
        <translation>ist eine Schrift ohne Umrisse</translation>
    </message>
    <message>
        <source>has no outline, it is blank</source>
        <translation>hat keinen Umriss, es ist leer</translation>
    </message>
    <message>
        <source>expected one character after the family&apos;s name</source>
        <translation>nach dem Namen der Schrift wird ein Zeichen erwartet</translation>
    </message>
    <message>
        <source>expected a code such as U+0061 after U+</source>
        <translation>nach U+ wird ein Code wie U+0061 erwartet</translation>
    </message>
    <message>
        <source>no picture of this size can be made</source>
        <translation>ein Bild dieser Größe ist nicht möglich</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>das Ende</translation>
    </message>
    <message>
        <source>no title, &quot;# ...&quot;</source>
        <translation>kein Titel, &quot;# ...&quot;</translation>
    </message>
    <message>
        <source>no step, &quot;## ...&quot;</source>
        <translation>kein Schritt, &quot;## ...&quot;</translation>
    </message>
    <message>
        <source>a block before the first step</source>
        <translation>ein Block vor dem ersten Schritt</translation>
    </message>
    <message>
        <source>a second block in one step</source>
        <translation>ein zweiter Block in einem Schritt</translation>
    </message>
    <message>
        <source>the block is not closed by ```</source>
        <translation>der Block ist nicht mit ``` geschlossen</translation>
    </message>
    <message>
        <source>the block is empty</source>
        <translation>der Block ist leer</translation>
    </message>
    <message>
        <source>a step without a title</source>
        <translation>ein Schritt ohne Titel</translation>
    </message>
    <message>
        <source>expected a text</source>
        <translation>erwartet wird ein Text</translation>
    </message>
    <message>
        <source>expected a number</source>
        <translation>erwartet wird eine Zahl</translation>
    </message>
    <message>
        <source>expected true or false</source>
        <translation>erwartet wird true oder false</translation>
    </message>
    <message>
        <source>the line has to be there</source>
        <translation>die Linie muss da sein</translation>
    </message>
    <message>
        <source>the surface faces away: ridges are looked for on the side that is seen</source>
        <translation>die Fläche ist abgewandt: Grate werden auf der gesehenen Seite gesucht</translation>
    </message>
    <message>
        <source>the parallel turns the normal as much as the meridian: no circle is a maximum</source>
        <translation>der Breitenkreis dreht die Normale so stark wie der Meridian: kein Kreis ist ein Maximum</translation>
    </message>
    <message>
        <source>the axis is within 4 edges: parallels shrink to a point</source>
        <translation>die Achse ist näher als 4 Kanten: Breitenkreise schrumpfen zu einem Punkt</translation>
    </message>
    <message>
        <source>a corner, cusp or jump of curvature is within 4 edges: the surface is not smooth</source>
        <translation>eine Ecke, Spitze oder ein Krümmungssprung ist näher als 4 Kanten: die Fläche ist nicht glatt</translation>
    </message>
    <message>
        <source>a border is within 4 edges: curvature is estimated from one side</source>
        <translation>ein Rand ist näher als 4 Kanten: die Krümmung wird von einer Seite geschätzt</translation>
    </message>
    <message>
        <source>the radius of curvature is below 4 edges, here or within 4 edges: the mesh is too coarse for the bend</source>
        <translation>der Krümmungsradius ist unter 4 Kanten, hier oder innerhalb von 4 Kanten: das Netz ist zu grob für die Biegung</translation>
    </message>
    <message>
        <source>lambda falls by less than twice what a line must have: a plain with noise on it</source>
        <translation>λ fällt um weniger als das Doppelte dessen, was eine Linie haben muss: eine Ebene mit Rauschen</translation>
    </message>
    <message>
        <source>a perspective view turns from place to place; the bridge needs an orthographic one</source>
        <translation>eine perspektivische Ansicht dreht sich von Ort zu Ort; die Brücke braucht eine orthografische</translation>
    </message>
    <message>
        <source>an extrusion seen along its rulings is a silhouette throughout</source>
        <translation>eine Extrusion ist entlang ihrer Geraden gesehen überall Silhouette</translation>
    </message>
    <message>
        <source>a surface of revolution has to be seen along its axis, from 0,1,0 or 0,-1,0</source>
        <translation>eine Rotationsfläche muss entlang ihrer Achse gesehen werden, aus 0,1,0 oder 0,-1,0</translation>
    </message>
    <message>
        <source>%1: median distance to the exact apparent ridge against the mean edge length</source>
        <translation>%1: Median des Abstands zum exakten scheinbaren Grat über der mittleren Kantenlänge</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Brücke</translation>
    </message>
    <message>
        <source>1 edge</source>
        <translation>1 Kante</translation>
    </message>
    <message>
        <source>%1 curvature, %2 derivative</source>
        <translation>Krümmung: %1, Ableitung: %2</translation>
    </message>
    <message>
        <source>, order %1</source>
        <translation>, Ordnung %1</translation>
    </message>
    <message>
        <source>jet</source>
        <translation>Jet</translation>
    </message>
    <message>
        <source>one-ring</source>
        <translation>Einring</translation>
    </message>
    <message>
        <source>closed-form</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>the plane is seen head-on: no direction within it leads to the viewer</source>
        <translation>die Ebene wird frontal gesehen: keine Richtung in ihr führt zum Betrachter</translation>
    </message>
    <message>
        <source>swept curve</source>
        <translation>bewegte Kurve</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>Byte %1</translation>
    </message>
    <message>
        <source>%1 is not a whole number of reasonable size: %2</source>
        <translation>%1 ist keine ganze Zahl in vernünftiger Größe: %2</translation>
    </message>
    <message>
        <source>%1 is not a whole number: %2</source>
        <translation>%1 ist keine ganze Zahl: %2</translation>
    </message>
    <message>
        <source>%1 is not a number: %2</source>
        <translation>%1 ist keine Zahl: %2</translation>
    </message>
    <message>
        <source>x of a vertex</source>
        <translation>x eines Eckpunkts</translation>
    </message>
    <message>
        <source>y of a vertex</source>
        <translation>y eines Eckpunkts</translation>
    </message>
    <message>
        <source>z of a vertex</source>
        <translation>z eines Eckpunkts</translation>
    </message>
    <message>
        <source>w of a vertex</source>
        <translation>w eines Eckpunkts</translation>
    </message>
    <message>
        <source>vertex of a face</source>
        <translation>Eckpunkt einer Facette</translation>
    </message>
    <message>
        <source>corner of a face</source>
        <translation>Ecke einer Facette</translation>
    </message>
    <message>
        <source>texture or normal of a face</source>
        <translation>Textur oder Normale einer Facette</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>ein Wert</translation>
    </message>
    <message>
        <source>a value of a vertex</source>
        <translation>ein Wert eines Eckpunkts</translation>
    </message>
    <message>
        <source>the length of a list</source>
        <translation>die Länge einer Liste</translation>
    </message>
    <message>
        <source>number of dimensions</source>
        <translation>Anzahl der Dimensionen</translation>
    </message>
    <message>
        <source>number of vertices</source>
        <translation>Anzahl der Eckpunkte</translation>
    </message>
    <message>
        <source>number of faces</source>
        <translation>Anzahl der Facetten</translation>
    </message>
    <message>
        <source>number of edges</source>
        <translation>Anzahl der Kanten</translation>
    </message>
    <message>
        <source>number of corners of a face</source>
        <translation>Anzahl der Ecken einer Facette</translation>
    </message>
    <message>
        <source>number of elements</source>
        <translation>Anzahl der Elemente</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>is compressed (gzip); unpack it first</source>
        <translation>ist komprimiert (gzip); entpacke sie zuerst</translation>
    </message>
    <message>
        <source>is no mesh file: PLY, OBJ, STL, OFF, glTF and GLB can be read</source>
        <translation>ist keine Netzdatei: PLY, OBJ, STL, OFF, glTF und GLB können gelesen werden</translation>
    </message>
    <message>
        <source>does not fit into memory</source>
        <translation>passt nicht in den Speicher</translation>
    </message>
    <message>
        <source>no such solid; there are %1</source>
        <translation>diesen Körper gibt es nicht; es gibt %1</translation>
    </message>
    <message>
        <source>expected a number of cells from %1 to %2, found %3</source>
        <translation>erwartet eine Zahl von Zellen von %1 bis %2, gefunden %3</translation>
    </message>
    <message>
        <source>a solid is solid:NAME, solid:NAME:CELLS or solid:NAME:CELLS:irregular</source>
        <translation>ein Körper heißt solid:NAME, solid:NAME:ZELLEN oder solid:NAME:ZELLEN:irregular</translation>
    </message>
    <message>
        <source>more than %1 corners of faces, which is too many</source>
        <translation>mehr als %1 Ecken von Facetten, das sind zu viele</translation>
    </message>
    <message>
        <source>all faces lie at one point</source>
        <translation>alle Facetten liegen in einem Punkt</translation>
    </message>
    <message>
        <source>no face has an area</source>
        <translation>keine Facette hat eine Fläche</translation>
    </message>
    <message>
        <source>there are no faces: a cloud of points is no mesh</source>
        <translation>es gibt keine Facetten: eine Punktwolke ist kein Netz</translation>
    </message>
    <message>
        <source>there are no faces</source>
        <translation>es gibt keine Facetten</translation>
    </message>
    <message>
        <source>there are no triangles</source>
        <translation>es gibt keine Dreiecke</translation>
    </message>
    <message>
        <source>there are no facets</source>
        <translation>es gibt keine Facetten</translation>
    </message>
    <message>
        <source>the PLY header has no end_header</source>
        <translation>der PLY-Kopf hat kein end_header</translation>
    </message>
    <message>
        <source>not a PLY file: it does not begin with the line &apos;ply&apos;</source>
        <translation>keine PLY-Datei: sie beginnt nicht mit der Zeile &apos;ply&apos;</translation>
    </message>
    <message>
        <source>unknown type of a property: %1</source>
        <translation>unbekannter Typ einer Eigenschaft: %1</translation>
    </message>
    <message>
        <source>unknown format %1</source>
        <translation>unbekanntes Format %1</translation>
    </message>
    <message>
        <source>the number of elements is negative</source>
        <translation>die Anzahl der Elemente ist negativ</translation>
    </message>
    <message>
        <source>a property stands before the first element</source>
        <translation>eine Eigenschaft steht vor dem ersten Element</translation>
    </message>
    <message>
        <source>the length of a list is not a whole number</source>
        <translation>die Länge einer Liste ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>a property has no name</source>
        <translation>eine Eigenschaft hat keinen Namen</translation>
    </message>
    <message>
        <source>unknown word in the header: %1</source>
        <translation>unbekanntes Wort im Kopf: %1</translation>
    </message>
    <message>
        <source>the header does not say the format</source>
        <translation>der Kopf nennt das Format nicht</translation>
    </message>
    <message>
        <source>more values than the header announces: %1</source>
        <translation>mehr Werte, als der Kopf ankündigt: %1</translation>
    </message>
    <message>
        <source>the length of a list is negative</source>
        <translation>die Länge einer Liste ist negativ</translation>
    </message>
    <message>
        <source>a list of %1 values is longer than the file</source>
        <translation>eine Liste von %1 Werten ist länger als die Datei</translation>
    </message>
    <message>
        <source>there are too many vertices</source>
        <translation>es gibt zu viele Eckpunkte</translation>
    </message>
    <message>
        <source>the header has no element &apos;vertex&apos;</source>
        <translation>der Kopf hat kein Element &apos;vertex&apos;</translation>
    </message>
    <message>
        <source>the header says %1 times %2, more than the file can hold</source>
        <translation>der Kopf sagt %1 mal %2, mehr als in die Datei passt</translation>
    </message>
    <message>
        <source>vertices have no %1</source>
        <translation>Eckpunkte haben kein %1</translation>
    </message>
    <message>
        <source>%1 of vertex %2 is not finite</source>
        <translation>%1 des Eckpunkts %2 ist nicht endlich</translation>
    </message>
    <message>
        <source>%1 has no list of whole numbers &apos;vertex_indices&apos;</source>
        <translation>%1 hat keine Liste ganzer Zahlen &apos;vertex_indices&apos;</translation>
    </message>
    <message>
        <source>not an OBJ file: %1</source>
        <translation>keine OBJ-Datei: %1</translation>
    </message>
    <message>
        <source>a face uses vertex 0, but the first one is 1</source>
        <translation>eine Facette verwendet Eckpunkt 0, aber der erste ist 1</translation>
    </message>
    <message>
        <source>a face uses vertex %1, but they are 0 to %2</source>
        <translation>eine Facette verwendet Eckpunkt %1, aber es sind 0 bis %2</translation>
    </message>
    <message>
        <source>a face uses vertex %1 of %2</source>
        <translation>eine Facette verwendet Eckpunkt %1 von %2</translation>
    </message>
    <message>
        <source>%1 uses vertex %2, but they are 0 to %3</source>
        <translation>%1 verwendet Eckpunkt %2, aber es sind 0 bis %3</translation>
    </message>
    <message>
        <source>unknown kind of OFF file: %1</source>
        <translation>unbekannte Art von OFF-Datei: %1</translation>
    </message>
    <message>
        <source>a count is negative</source>
        <translation>eine Anzahl ist negativ</translation>
    </message>
    <message>
        <source>a coordinate of a vertex is not finite</source>
        <translation>eine Koordinate eines Eckpunkts ist nicht endlich</translation>
    </message>
    <message>
        <source>a face has a negative number of corners</source>
        <translation>eine Facette hat eine negative Anzahl von Ecken</translation>
    </message>
    <message>
        <source>a face has %1 values of colour</source>
        <translation>eine Facette hat %1 Farbwerte</translation>
    </message>
    <message>
        <source>a face has less than three corners</source>
        <translation>eine Facette hat weniger als drei Ecken</translation>
    </message>
    <message>
        <source>a face has too many values</source>
        <translation>eine Facette hat zu viele Werte</translation>
    </message>
    <message>
        <source>a vertex lies at infinity</source>
        <translation>ein Eckpunkt liegt im Unendlichen</translation>
    </message>
    <message>
        <source>has points of %1 dimensions instead of %2</source>
        <translation>hat Punkte mit %1 Dimensionen statt %2</translation>
    </message>
    <message>
        <source>the counts, %1 vertices and %2 faces, are more than the file can hold</source>
        <translation>die Anzahlen, %1 Eckpunkte und %2 Facetten, sind mehr, als in die Datei passt</translation>
    </message>
    <message>
        <source>the vertices end within a line</source>
        <translation>die Eckpunkte enden mitten in einer Zeile</translation>
    </message>
    <message>
        <source>the file has no counts</source>
        <translation>die Datei hat keine Anzahlen</translation>
    </message>
    <message>
        <source>the file has no faces</source>
        <translation>die Datei hat keine Facetten</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>die Datei endet zu früh</translation>
    </message>
    <message>
        <source>the file ends before the counts</source>
        <translation>die Datei endet vor den Anzahlen</translation>
    </message>
    <message>
        <source>the file ends and has no faces</source>
        <translation>die Datei endet und hat keine Facetten</translation>
    </message>
    <message>
        <source>the file ends and has no facets</source>
        <translation>die Datei endet und hat keine Facetten</translation>
    </message>
    <message>
        <source>the file ends after %1 of %2 vertices</source>
        <translation>die Datei endet nach %1 von %2 Eckpunkten</translation>
    </message>
    <message>
        <source>the file ends after %1 of %2 faces</source>
        <translation>die Datei endet nach %1 von %2 Facetten</translation>
    </message>
    <message>
        <source>%1 is missing: the file ends</source>
        <translation>%1 fehlt: die Datei endet</translation>
    </message>
    <message>
        <source>%1 is missing, there is %2</source>
        <translation>%1 fehlt, da steht %2</translation>
    </message>
    <message>
        <source>%1 expected, there is %2</source>
        <translation>%1 erwartet, da steht %2</translation>
    </message>
    <message>
        <source>neither a text STL nor long enough for a binary one</source>
        <translation>weder ein STL als Text noch lang genug für ein binäres</translation>
    </message>
    <message>
        <source>says that there are %1 facets, but the file ends after %2</source>
        <translation>sagt, es gebe %1 Facetten, aber die Datei endet nach %2</translation>
    </message>
    <message>
        <source>a coordinate of facet %1 is not finite</source>
        <translation>eine Koordinate von Facette %1 ist nicht endlich</translation>
    </message>
    <message>
        <source>the GLB header is cut short</source>
        <translation>der GLB-Kopf ist abgeschnitten</translation>
    </message>
    <message>
        <source>GLB version %1 instead of 2</source>
        <translation>GLB-Version %1 statt 2</translation>
    </message>
    <message>
        <source>the GLB should have only %1 bytes</source>
        <translation>das GLB sollte nur %1 Bytes haben</translation>
    </message>
    <message>
        <source>the GLB should have %1 bytes, but has %2</source>
        <translation>das GLB sollte %1 Bytes haben, hat aber %2</translation>
    </message>
    <message>
        <source>a chunk of %1 bytes is longer than the file</source>
        <translation>ein Stück von %1 Bytes ist länger als die Datei</translation>
    </message>
    <message>
        <source>the first chunk is not JSON</source>
        <translation>das erste Stück ist kein JSON</translation>
    </message>
    <message>
        <source>its data URI is not base64</source>
        <translation>seine Daten-URI ist kein base64</translation>
    </message>
    <message>
        <source>the base64 of its data URI is malformed</source>
        <translation>das base64 seiner Daten-URI ist fehlerhaft</translation>
    </message>
    <message>
        <source>should have %1 bytes, but has %2</source>
        <translation>sollte %1 Bytes haben, hat aber %2</translation>
    </message>
    <message>
        <source>%1 is an address; only files beside this one are read</source>
        <translation>%1 ist eine Adresse; nur Dateien neben dieser werden gelesen</translation>
    </message>
    <message>
        <source>there is no file %1 beside this one or in a folder below</source>
        <translation>es gibt keine Datei %1 neben dieser oder in einem Ordner darunter</translation>
    </message>
    <message>
        <source>the JSON is nested too deeply</source>
        <translation>das JSON ist zu tief geschachtelt</translation>
    </message>
    <message>
        <source>the JSON is malformed</source>
        <translation>das JSON ist fehlerhaft</translation>
    </message>
    <message>
        <source>the JSON has a number that is too large</source>
        <translation>das JSON hat eine zu große Zahl</translation>
    </message>
    <message>
        <source>the JSON is no glTF object</source>
        <translation>das JSON ist kein glTF-Objekt</translation>
    </message>
    <message>
        <source>needs the extension %1, which cannot be read</source>
        <translation>braucht die Erweiterung %1, die nicht gelesen werden kann</translation>
    </message>
    <message>
        <source>%1 is not a whole number from 0 to 2^32 - 1: %2</source>
        <translation>%1 ist keine ganze Zahl von 0 bis 2^32 - 1: %2</translation>
    </message>
    <message>
        <source>%1 is no list of %2 numbers</source>
        <translation>%1 ist keine Liste von %2 Zahlen</translation>
    </message>
    <message>
        <source>%1 is no list</source>
        <translation>%1 ist keine Liste</translation>
    </message>
    <message>
        <source>is no object</source>
        <translation>ist kein Objekt</translation>
    </message>
    <message>
        <source>is no glTF: it has no asset.version</source>
        <translation>ist kein glTF: es hat keine asset.version</translation>
    </message>
    <message>
        <source>glTF version %1 instead of 2.0</source>
        <translation>glTF-Version %1 statt 2.0</translation>
    </message>
    <message>
        <source>%1 has what is no index: %2</source>
        <translation>%1 hat, was kein Index ist: %2</translation>
    </message>
    <message>
        <source>a rotation is zero</source>
        <translation>eine Drehung ist null</translation>
    </message>
    <message>
        <source>%1 is no index</source>
        <translation>%1 ist kein Index</translation>
    </message>
    <message>
        <source>is no index</source>
        <translation>ist kein Index</translation>
    </message>
    <message>
        <source>each is the child of another</source>
        <translation>jedes ist das Kind eines anderen</translation>
    </message>
    <message>
        <source>%1 is no text</source>
        <translation>%1 ist kein Text</translation>
    </message>
    <message>
        <source>has no data</source>
        <translation>hat keine Daten</translation>
    </message>
    <message>
        <source>shows its meshes too many times over</source>
        <translation>zeigt seine Netze zu oft</translation>
    </message>
    <message>
        <source>has two parents</source>
        <translation>hat zwei Eltern</translation>
    </message>
    <message>
        <source>has no buffer</source>
        <translation>hat keinen Puffer</translation>
    </message>
    <message>
        <source>reaches beyond its buffer</source>
        <translation>reicht über seinen Puffer hinaus</translation>
    </message>
    <message>
        <source>accessor %1 does not exist</source>
        <translation>Zugriff %1 gibt es nicht</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>gibt es nicht</translation>
    </message>
    <message>
        <source>has the wrong type</source>
        <translation>hat den falschen Typ</translation>
    </message>
    <message>
        <source>has values of unknown type</source>
        <translation>hat Werte von unbekanntem Typ</translation>
    </message>
    <message>
        <source>has sparse indices that are not whole numbers</source>
        <translation>hat dünn besetzte Indizes, die keine ganzen Zahlen sind</translation>
    </message>
    <message>
        <source>replaces more values than it has</source>
        <translation>ersetzt mehr Werte, als es hat</translation>
    </message>
    <message>
        <source>its sparse indices do not rise, or lead nowhere</source>
        <translation>seine dünn besetzten Indizes steigen nicht oder führen nirgendwohin</translation>
    </message>
    <message>
        <source>has indices that are not whole numbers</source>
        <translation>hat Indizes, die keine ganzen Zahlen sind</translation>
    </message>
    <message>
        <source>index %1 is %2, but there are %3 vertices</source>
        <translation>Index %1 ist %2, aber es gibt %3 Eckpunkte</translation>
    </message>
    <message>
        <source>vertex %1 is not finite</source>
        <translation>Eckpunkt %1 ist nicht endlich</translation>
    </message>
    <message>
        <source>the number of its indices is not a multiple of 3</source>
        <translation>die Anzahl seiner Indizes ist kein Vielfaches von 3</translation>
    </message>
    <message>
        <source>is longer than 4 GB</source>
        <translation>ist länger als 4 GB</translation>
    </message>
    <message>
        <source>is no valid glTF: %1</source>
        <translation>ist kein gültiges glTF: %1</translation>
    </message>
    <message>
        <source>%1 is not finite: %2</source>
        <translation>%1 ist nicht endlich: %2</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 fehlt</translation>
    </message>
    <message>
        <source>the word OFF at the beginning is missing</source>
        <translation>das Wort OFF am Anfang fehlt</translation>
    </message>
    <message>
        <source>text after the last face passed over</source>
        <translation>Text nach der letzten Facette übergangen</translation>
    </message>
    <message>
        <source>%1 bytes after the last face passed over</source>
        <translation>%1 Bytes nach der letzten Facette übergangen</translation>
    </message>
    <message>
        <source>%1 bytes after the last element passed over</source>
        <translation>%1 Bytes nach dem letzten Element übergangen</translation>
    </message>
    <message>
        <source>%1 bytes after the last facet passed over</source>
        <translation>%1 Bytes nach der letzten Facette übergangen</translation>
    </message>
    <message>
        <source>%1 bytes after the GLB passed over</source>
        <translation>%1 Bytes nach dem GLB übergangen</translation>
    </message>
    <message>
        <source>1 face with less than three corners left out</source>
        <translation>1 Facette mit weniger als drei Ecken ausgelassen</translation>
    </message>
    <message>
        <source>%1 faces with less than three corners left out</source>
        <translation>%1 Facetten mit weniger als drei Ecken ausgelassen</translation>
    </message>
    <message>
        <source>1 record of unknown kind passed over</source>
        <translation>1 Eintrag unbekannter Art übergangen</translation>
    </message>
    <message>
        <source>%1 records of unknown kind passed over</source>
        <translation>%1 Einträge unbekannter Art übergangen</translation>
    </message>
    <message>
        <source>1 group of points or lines passed over</source>
        <translation>1 Gruppe von Punkten oder Linien übergangen</translation>
    </message>
    <message>
        <source>%1 groups of points or lines passed over</source>
        <translation>%1 Gruppen von Punkten oder Linien übergangen</translation>
    </message>
    <message>
        <source>1 vertex without a face left out</source>
        <translation>1 Eckpunkt ohne Facette ausgelassen</translation>
    </message>
    <message>
        <source>%1 vertices without a face left out</source>
        <translation>%1 Eckpunkte ohne Facette ausgelassen</translation>
    </message>
    <message>
        <source>1 vertex welded to another at the same place</source>
        <translation>1 Eckpunkt mit einem anderen am selben Ort verschweißt</translation>
    </message>
    <message>
        <source>%1 vertices welded to another at the same place</source>
        <translation>%1 Eckpunkte mit einem anderen am selben Ort verschweißt</translation>
    </message>
    <message>
        <source>1 face that crosses itself triangulated with overlaps</source>
        <translation>1 Facette, die sich selbst kreuzt, mit Überlappungen in Dreiecke zerlegt</translation>
    </message>
    <message>
        <source>%1 faces that cross themselves triangulated with overlaps</source>
        <translation>%1 Facetten, die sich selbst kreuzen, mit Überlappungen in Dreiecke zerlegt</translation>
    </message>
    <message>
        <source>1 very large face made a fan, which may fold over</source>
        <translation>1 sehr große Facette zum Fächer gemacht, der sich überschlagen kann</translation>
    </message>
    <message>
        <source>%1 very large faces made a fan, which may fold over</source>
        <translation>%1 sehr große Facetten zum Fächer gemacht, der sich überschlagen kann</translation>
    </message>
    <message>
        <source>1 triangle with two corners at one place left out</source>
        <translation>1 Dreieck mit zwei Ecken an einem Ort ausgelassen</translation>
    </message>
    <message>
        <source>%1 triangles with two corners at one place left out</source>
        <translation>%1 Dreiecke mit zwei Ecken an einem Ort ausgelassen</translation>
    </message>
    <message>
        <source>1 triangle that repeat another left out</source>
        <translation>1 wiederholtes Dreieck ausgelassen</translation>
    </message>
    <message>
        <source>%1 triangles that repeat another left out</source>
        <translation>%1 wiederholte Dreiecke ausgelassen</translation>
    </message>
    <message>
        <source>1 triangle of pieces without area left out</source>
        <translation>1 Dreieck von Stücken ohne Fläche ausgelassen</translation>
    </message>
    <message>
        <source>%1 triangles of pieces without area left out</source>
        <translation>%1 Dreiecke von Stücken ohne Fläche ausgelassen</translation>
    </message>
    <message>
        <source>1 triangle turned to agree with their neighbours</source>
        <translation>1 Dreieck umgedreht, passend zu den Nachbarn</translation>
    </message>
    <message>
        <source>%1 triangles turned to agree with their neighbours</source>
        <translation>%1 Dreiecke umgedreht, passend zu den Nachbarn</translation>
    </message>
    <message>
        <source>1 piece that was inside out turned outward</source>
        <translation>1 umgestülptes Stück nach außen gewendet</translation>
    </message>
    <message>
        <source>%1 pieces that were inside out turned outward</source>
        <translation>%1 umgestülpte Stücke nach außen gewendet</translation>
    </message>
    <message>
        <source>1 triangle without area kept</source>
        <translation>1 Dreieck ohne Fläche behalten</translation>
    </message>
    <message>
        <source>%1 triangles without area kept</source>
        <translation>%1 Dreiecke ohne Fläche behalten</translation>
    </message>
    <message>
        <source>1 edge with more than two triangles cut</source>
        <translation>1 Kante mit mehr als zwei Dreiecken aufgeschnitten</translation>
    </message>
    <message>
        <source>%1 edges with more than two triangles cut</source>
        <translation>%1 Kanten mit mehr als zwei Dreiecken aufgeschnitten</translation>
    </message>
    <message>
        <source>1 vertex where surfaces touch cut apart</source>
        <translation>1 Eckpunkt aufgetrennt, wo Flächen sich berühren</translation>
    </message>
    <message>
        <source>%1 vertices where surfaces touch cut apart</source>
        <translation>%1 Eckpunkte aufgetrennt, wo Flächen sich berühren</translation>
    </message>
    <message>
        <source>1 edge cut, because the surface has one side only</source>
        <translation>1 Kante aufgeschnitten, weil die Fläche nur eine Seite hat</translation>
    </message>
    <message>
        <source>%1 edges cut, because the surface has one side only</source>
        <translation>%1 Kanten aufgeschnitten, weil die Fläche nur eine Seite hat</translation>
    </message>
    <message>
        <source>a silhouette is within 4 edges, or n.w is below 0.05: lambda grows without bound there</source>
        <translation>eine Silhouette ist näher als 4 Kanten, oder n.w ist unter 0,05: Lambda wächst dort über alle Grenzen</translation>
    </message>
    <message>
        <source>expected one of %1; found %2</source>
        <translation>eines von %1 erwartet; %2 gefunden</translation>
    </message>
    <message>
        <source>expected three numbers</source>
        <translation>drei Zahlen erwartet</translation>
    </message>
    <message>
        <source>expected a number above 0, found %1</source>
        <translation>eine Zahl über 0 erwartet, %1 gefunden</translation>
    </message>
    <message>
        <source>expected a number of at least %1, found %2</source>
        <translation>eine Zahl ab %1 erwartet, %2 gefunden</translation>
    </message>
    <message>
        <source>expected a direction, found %1</source>
        <translation>eine Richtung erwartet, %1 gefunden</translation>
    </message>
    <message>
        <source>expected an angle from %1 to %2 degrees, found %3</source>
        <translation>ein Winkel von %1 bis %2 Grad erwartet, %3 gefunden</translation>
    </message>
    <message>
        <source>expected a threshold of 0 or above</source>
        <translation>eine Schwelle ab 0 erwartet</translation>
    </message>
    <message>
        <source>expected a colour like %1, or none</source>
        <translation>eine Farbe wie %1 oder keine erwartet</translation>
    </message>
    <message>
        <source>expected the index of a curve, from 0</source>
        <translation>die Nummer einer Kurve ab 0 erwartet</translation>
    </message>
    <message>
        <source>expected %1 to %2 cells</source>
        <translation>%1 bis %2 Zellen erwartet</translation>
    </message>
    <message>
        <source>expected 1 to %1 levels</source>
        <translation>1 bis %1 Stufen erwartet</translation>
    </message>
    <message>
        <source>expected a file or solid:NAME</source>
        <translation>eine Datei oder solid:NAME erwartet</translation>
    </message>
    <message>
        <source>expected a share of at most 1</source>
        <translation>ein Anteil bis 1 erwartet</translation>
    </message>
    <message>
        <source>&quot;up&quot; lies along &quot;towards&quot;</source>
        <translation>&quot;up&quot; liegt längs &quot;towards&quot;</translation>
    </message>
    <message>
        <source>there is one of this name already</source>
        <translation>diesen Namen gibt es schon</translation>
    </message>
    <message>
        <source>more than %1 entries</source>
        <translation>mehr als %1 Einträge</translation>
    </message>
    <message>
        <source>more than %1 views</source>
        <translation>mehr als %1 Ansichten</translation>
    </message>
    <message>
        <source>&quot;mesh&quot;: &quot;swept:&quot; and &quot;swept&quot; belong together</source>
        <translation>&quot;mesh&quot;: &quot;swept:&quot; und &quot;swept&quot; gehören zusammen</translation>
    </message>
    <message>
        <source>came with version 3; write &quot;flatland&quot;: 3</source>
        <translation>kam mit Version 3; dafür &quot;flatland&quot;: 3 schreiben</translation>
    </message>
    <message>
        <source>panes, ink, swept and plane came with version 4; write &quot;flatland&quot;: 4</source>
        <translation>panes, ink, swept und plane kamen mit Version 4; dafür &quot;flatland&quot;: 4 schreiben</translation>
    </message>
    <message>
        <source>y turned up</source>
        <translation>y nach oben gewendet</translation>
    </message>
    <message>
        <source>scaled by %1 and centred</source>
        <translation>mit %1 skaliert und zentriert</translation>
    </message>
    <message>
        <source>centred</source>
        <translation>zentriert</translation>
    </message>
    <message>
        <source>1 gradient</source>
        <translation>1 Verlauf</translation>
    </message>
    <message>
        <source>%1 gradients</source>
        <translation>%1 Verläufe</translation>
    </message>
    <message>
        <source>1 pattern</source>
        <translation>1 Muster</translation>
    </message>
    <message>
        <source>%1 patterns</source>
        <translation>%1 Muster</translation>
    </message>
    <message>
        <source>1 filter</source>
        <translation>1 Filter</translation>
    </message>
    <message>
        <source>%1 filters</source>
        <translation>%1 Filter</translation>
    </message>
    <message>
        <source>1 style rule</source>
        <translation>1 Stilregel</translation>
    </message>
    <message>
        <source>%1 style rules</source>
        <translation>%1 Stilregeln</translation>
    </message>
    <message>
        <source>1 hidden element</source>
        <translation>1 verborgenes Element</translation>
    </message>
    <message>
        <source>%1 hidden elements</source>
        <translation>%1 verborgene Elemente</translation>
    </message>
    <message>
        <source>1 clip path</source>
        <translation>1 Beschneidungspfad</translation>
    </message>
    <message>
        <source>%1 clip paths</source>
        <translation>%1 Beschneidungspfade</translation>
    </message>
    <message>
        <source>1 mask</source>
        <translation>1 Maske</translation>
    </message>
    <message>
        <source>%1 masks</source>
        <translation>%1 Masken</translation>
    </message>
    <message>
        <source>1 text</source>
        <translation>1 Text</translation>
    </message>
    <message>
        <source>%1 texts</source>
        <translation>%1 Texte</translation>
    </message>
    <message>
        <source>1 image</source>
        <translation>1 Bild</translation>
    </message>
    <message>
        <source>%1 images</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source>1 foreign object</source>
        <translation>1 Fremdobjekt</translation>
    </message>
    <message>
        <source>%1 foreign objects</source>
        <translation>%1 Fremdobjekte</translation>
    </message>
    <message>
        <source>1 reference to what is not there</source>
        <translation>1 Verweis auf Fehlendes</translation>
    </message>
    <message>
        <source>%1 references to what is not there</source>
        <translation>%1 Verweise auf Fehlendes</translation>
    </message>
    <message>
        <source>1 shape with neither fill nor stroke</source>
        <translation>1 Form ohne Füllung und Strich</translation>
    </message>
    <message>
        <source>%1 shapes with neither fill nor stroke</source>
        <translation>%1 Formen ohne Füllung und Strich</translation>
    </message>
    <message>
        <source>1 subpath without length</source>
        <translation>1 Teilpfad ohne Länge</translation>
    </message>
    <message>
        <source>%1 subpaths without length</source>
        <translation>%1 Teilpfade ohne Länge</translation>
    </message>
    <message>
        <source>1 segment of zero length</source>
        <translation>1 Segment der Länge null</translation>
    </message>
    <message>
        <source>%1 segments of zero length</source>
        <translation>%1 Segmente der Länge null</translation>
    </message>
    <message>
        <source>1 curve of %1</source>
        <translation>1 Kurve aus %1</translation>
    </message>
    <message>
        <source>%1 curves of %2</source>
        <translation>%1 Kurven aus %2</translation>
    </message>
    <message>
        <source>1 curve</source>
        <translation>1 Kurve</translation>
    </message>
    <message>
        <source>%1 curves</source>
        <translation>%1 Kurven</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>ausgelassen: %1</translation>
    </message>
</context>
<context>
    <name>EditMenus</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig:</translation>
    </message>
    <message>
        <source>Take back the last step</source>
        <translation>Den letzten Schritt zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen:</translation>
    </message>
    <message>
        <source>Do the step again that was taken back</source>
        <translation>Den zurückgenommenen Schritt noch einmal tun</translation>
    </message>
    <message>
        <source>&amp;Delete Points</source>
        <translation>Punkte &amp;löschen</translation>
    </message>
    <message>
        <source>Remove the selected points</source>
        <translation>Die ausgewählten Punkte entfernen</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>&amp;Alles auswählen</translation>
    </message>
    <message>
        <source>Select all points</source>
        <translation>Alle Punkte auswählen</translation>
    </message>
    <message>
        <source>&amp;Add Curve</source>
        <translation>Kurve &amp;hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Remove Curve</source>
        <translation>Kurve &amp;entfernen</translation>
    </message>
    <message>
        <source>Remove the curve picked last</source>
        <translation>Die zuletzt gewählte Kurve entfernen</translation>
    </message>
    <message>
        <source>Raise &amp;Degree</source>
        <translation>&amp;Grad erhöhen</translation>
    </message>
    <message>
        <source>One control point more in every piece; the shape stays</source>
        <translation>Ein Kontrollpunkt mehr in jedem Stück; die Form bleibt</translation>
    </message>
    <message>
        <source>&amp;Flip Normal</source>
        <translation>&amp;Normale umkehren</translation>
    </message>
    <message>
        <source>Turn the normal round: ridges and valleys change places</source>
        <translation>Die Normale umkehren: Grate und Täler tauschen die Plätze</translation>
    </message>
    <message>
        <source>Re&amp;set</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Back to where this scene began</source>
        <translation>Zurück zum Anfang dieser Szene</translation>
    </message>
    <message>
        <source>Re&amp;set to File as Opened</source>
        <translation>&amp;Zurück zur Datei, wie sie geöffnet wurde</translation>
    </message>
    <message>
        <source>Re&amp;set to Preset “%1”</source>
        <translation>&amp;Zurück zum Beispiel „%1“</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Import &amp;Glyph…</source>
        <translation>&amp;Glyphe importieren …</translation>
    </message>
    <message>
        <source>Add the outline of a letter to this scene</source>
        <translation>Den Umriss eines Buchstabens zu dieser Szene hinzufügen</translation>
    </message>
    <message>
        <source>Add a curve beside those there are</source>
        <translation>Eine Kurve neben den vorhandenen hinzufügen</translation>
    </message>
    <message>
        <source>Add such a curve beside those there are; the panel Curve has its numbers</source>
        <translation>Eine solche Kurve neben den vorhandenen hinzufügen; das Bedienfeld Kurve hat ihre Zahlen</translation>
    </message>
</context>
<context>
    <name>FigureFiles</name>
    <message>
        <source>the name should end in .svg, .pdf, .png, .tex or .csv</source>
        <translation>der Name sollte auf .svg, .pdf, .png, .tex oder .csv enden</translation>
    </message>
    <message>
        <source>SVG picture (*.svg)</source>
        <translation>SVG-Bild (*.svg)</translation>
    </message>
    <message>
        <source>PDF picture (*.pdf)</source>
        <translation>PDF-Bild (*.pdf)</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>TikZ picture (*.tex)</source>
        <translation>TikZ-Bild (*.tex)</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>CSV-Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Export diagram</source>
        <translation>Diagramm exportieren</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exportiert nach %1</translation>
    </message>
</context>
<context>
    <name>FileMenu</name>
    <message>
        <source>%1 (gone)</source>
        <translation>%1 (nicht mehr da)</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Keine zuletzt geöffneten Dateien</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>Forget all recent files</source>
        <translation>Alle zuletzt geöffneten Dateien vergessen</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Start over with the first preset</source>
        <translation>Neu anfangen mit dem ersten Beispiel</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Presets</source>
        <translation>Be&amp;ispiele</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Die Szene speichern</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the scene under another name</source>
        <translation>Die Szene unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Write the picture as SVG, PDF, PNG or TikZ</source>
        <translation>Das Bild als SVG, PDF, PNG oder TikZ schreiben</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Das Fenster schließen</translation>
    </message>
    <message>
        <source>Open a scene file or an SVG drawing</source>
        <translation>Eine Szenendatei oder eine SVG-Zeichnung öffnen</translation>
    </message>
    <message>
        <source>&amp;Import SVG…</source>
        <translation>SVG &amp;importieren …</translation>
    </message>
    <message>
        <source>Add the outlines of a drawing to this scene</source>
        <translation>Die Umrisse einer Zeichnung zu dieser Szene hinzufügen</translation>
    </message>
</context>
<context>
    <name>FlatCanvas</name>
    <message>
        <source>Nothing here yet. Curve &gt; Add Curve draws one.</source>
        <translation>Hier ist noch nichts. Kurve &gt; Kurve hinzufügen zeichnet eine.</translation>
    </message>
</context>
<context>
    <name>FlipNormal</name>
    <message>
        <source>flip normal</source>
        <translation>Normale umkehren</translation>
    </message>
</context>
<context>
    <name>Gesture</name>
    <message>
        <source>Drag to move the viewer; Shift steps by 15°, Ctrl keeps the distance.</source>
        <translation>Ziehen bewegt den Betrachter; Umschalt geht in Schritten von 15°, Strg hält den Abstand.</translation>
    </message>
    <message>
        <source>Drag to turn the view; Shift steps by 15°.</source>
        <translation>Ziehen dreht die Ansicht; Umschalt geht in Schritten von 15°.</translation>
    </message>
    <message>
        <source>Point %1 at (%2): drag to move it, Delete removes it.</source>
        <translation>Punkt %1 bei (%2): Ziehen bewegt ihn, Entf entfernt ihn.</translation>
    </message>
    <message>
        <source>%1 at t = %2%3: click to find it in the table.</source>
        <translation>%1 bei t = %2%3: ein Klick findet die Zeile in der Tabelle.</translation>
    </message>
    <message>
        <source>, hidden from the screen</source>
        <translation>, vom Schirm aus verdeckt</translation>
    </message>
    <message>
        <source>Drag a point to bend the curve, or the eye to turn the view. H shows all keys.</source>
        <translation>Punkt ziehen: Kurve biegen. Auge ziehen: Ansicht drehen. H: alle Tasten.</translation>
    </message>
    <message>
        <source>Moving %1 by (%2). Ctrl: along one axis. Alt: leave the handles. Esc: take it back.</source>
        <translation>Bewegt %1 um (%2). Strg: entlang einer Achse. Alt: ohne die Griffe. Esc: zurücknehmen.</translation>
    </message>
    <message>
        <source>the point</source>
        <translation>den Punkt</translation>
    </message>
    <message>
        <source>Marks follow from the curve and the view; the table tells this one&apos;s values.</source>
        <translation>Marken folgen aus Kurve und Ansicht; die Tabelle nennt die Werte dieser Marke.</translation>
    </message>
    <message>
        <source>Moving the viewer. Shift: steps of 15°. Ctrl: same distance. Esc: take it back.</source>
        <translation>Bewegt den Betrachter. Umschalt: Schritte von 15°. Strg: gleicher Abstand. Esc: zurücknehmen.</translation>
    </message>
    <message>
        <source>Turning the view. Shift: steps of 15°. Esc: take it back.</source>
        <translation>Dreht die Ansicht. Umschalt: Schritte von 15°. Esc: zurücknehmen.</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>   distance %1</source>
        <translation>   Abstand %1</translation>
    </message>
    <message>
        <source>Moving the picture. F: fit it into the window.</source>
        <translation>Bewegt das Bild. F: ins Fenster einpassen.</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n Punkt</numerusform>
            <numerusform>%n Punkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points selected. Shift: add to the selection. Esc: take it back.</source>
        <translation>
            <numerusform>%n Punkt ausgewählt. Umschalt: zur Auswahl hinzufügen. Esc: zurücknehmen.</numerusform>
            <numerusform>%n Punkte ausgewählt. Umschalt: zur Auswahl hinzufügen. Esc: zurücknehmen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Probe at t = %1: drag to slide it along the curve; M goes to the next mark.</source>
        <translation>Sonde bei t = %1: Ziehen schiebt sie die Kurve entlang; M geht zur nächsten Marke.</translation>
    </message>
    <message>
        <source>Click to put the probe here, double-click to insert a point; drag to move the curve.</source>
        <translation>Klick setzt die Sonde hierher, Doppelklick fügt einen Punkt ein; Ziehen bewegt die Kurve.</translation>
    </message>
    <message>
        <source>Moving the curve by (%1). Ctrl: along one axis. Esc: take it back.</source>
        <translation>Bewegt die Kurve um (%1). Strg: entlang einer Achse. Esc: zurücknehmen.</translation>
    </message>
    <message>
        <source>Sliding the probe along the curve. Esc: take it back.</source>
        <translation>Schiebt die Sonde die Kurve entlang. Esc: zurücknehmen.</translation>
    </message>
</context>
<context>
    <name>InsertPoint</name>
    <message>
        <source>insert point</source>
        <translation>Punkt einfügen</translation>
    </message>
</context>
<context>
    <name>LayoutMenu</name>
    <message>
        <source>&amp;Work</source>
        <translation>&amp;Arbeit</translation>
    </message>
    <message>
        <source>Canvas and all panels</source>
        <translation>Zeichenfläche und alle Bedienfelder</translation>
    </message>
    <message>
        <source>&amp;Picture-Making</source>
        <translation>&amp;Bild</translation>
    </message>
    <message>
        <source>The canvas alone, with what an export needs</source>
        <translation>Die Zeichenfläche allein, mit dem, was ein Export braucht</translation>
    </message>
    <message>
        <source>P&amp;rojector</source>
        <translation>&amp;Projektor</translation>
    </message>
    <message>
        <source>Full screen, large type, few panels; Esc leaves it</source>
        <translation>Ganzer Bildschirm, große Schrift, wenige Bedienfelder; Esc beendet ihn</translation>
    </message>
    <message>
        <source>R&amp;estore Panels</source>
        <translation>Bedienfelder &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>The panels of this layout back to their places</source>
        <translation>Die Bedienfelder dieser Anordnung zurück an ihre Plätze</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>&amp;Größer</translation>
    </message>
    <message>
        <source>Larger type, marks and lines</source>
        <translation>Größere Schrift, Marken und Linien</translation>
    </message>
    <message>
        <source>&amp;Smaller</source>
        <translation>&amp;Kleiner</translation>
    </message>
    <message>
        <source>Smaller type, marks and lines</source>
        <translation>Kleinere Schrift, Marken und Linien</translation>
    </message>
    <message>
        <source>&amp;Usual Size</source>
        <translation>&amp;Übliche Größe</translation>
    </message>
    <message>
        <source>Type, marks and lines as on the first day</source>
        <translation>Schrift, Marken und Linien wie am ersten Tag</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;System</translation>
    </message>
    <message>
        <source>The colours of the desktop</source>
        <translation>Die Farben des Schreibtischs</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation>Dunkel auf hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation>Hell auf dunkel</translation>
    </message>
    <message>
        <source>&amp;High Contrast</source>
        <translation>Hoher &amp;Kontrast</translation>
    </message>
    <message>
        <source>White on black, yellow for what is picked</source>
        <translation>Weiß auf Schwarz, Gelb für Ausgewähltes</translation>
    </message>
    <message>
        <source>The language of the window, from its next start on</source>
        <translation>Die Sprache des Fensters, ab seinem nächsten Start</translation>
    </message>
    <message>
        <source>&amp;Layout</source>
        <translation>&amp;Anordnung</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Darstellungsgröße</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Wheel Zooms</source>
        <translation>&amp;Mausrad zoomt</translation>
    </message>
    <message>
        <source>A mouse wheel zooms; off: it moves the picture, and Ctrl + wheel zooms</source>
        <translation>Das Mausrad zoomt; aus: es bewegt das Bild, und Strg + Mausrad zoomt</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>&amp;Fläche</translation>
    </message>
    <message>
        <source>The surface large, the canvas beside it</source>
        <translation>Die Fläche groß, die Leinwand daneben</translation>
    </message>
    <message>
        <source>Cu&amp;rves beside the Surface</source>
        <translation>K&amp;urven neben der Fläche</translation>
    </message>
    <message>
        <source>Show the curves beside a surface; off: the surface has all the room</source>
        <translation>Die Kurven neben einer Fläche zeigen; aus: die Fläche hat den ganzen Platz</translation>
    </message>
</context>
<context>
    <name>LessonMenu</name>
    <message>
        <source>No recent lessons</source>
        <translation>Keine zuletzt geöffneten Lektionen</translation>
    </message>
    <message>
        <source>Start this lesson</source>
        <translation>Diese Lektion beginnen</translation>
    </message>
    <message>
        <source>Open a lesson of your own</source>
        <translation>Eine eigene Lektion öffnen</translation>
    </message>
    <message>
        <source>Open &amp;Recent Lesson</source>
        <translation>&amp;Zuletzt geöffnete Lektion</translation>
    </message>
    <message>
        <source>&amp;Next Step</source>
        <translation>&amp;Nächster Schritt</translation>
    </message>
    <message>
        <source>On to the next step</source>
        <translation>Weiter zum nächsten Schritt</translation>
    </message>
    <message>
        <source>Step &amp;Back</source>
        <translation>Schritt zu&amp;rück</translation>
    </message>
    <message>
        <source>Back to the step before</source>
        <translation>Zurück zum Schritt davor</translation>
    </message>
    <message>
        <source>Next &amp;Stop</source>
        <translation>Nächster &amp;Halt</translation>
    </message>
    <message>
        <source>On to the next step that is a stop</source>
        <translation>Weiter zum nächsten Schritt, der ein Halt ist</translation>
    </message>
    <message>
        <source>&amp;First Step</source>
        <translation>&amp;Erster Schritt</translation>
    </message>
    <message>
        <source>Back to the beginning</source>
        <translation>Zurück zum Anfang</translation>
    </message>
    <message>
        <source>Scene of This Step &amp;Again</source>
        <translation>&amp;Szene dieses Schritts noch einmal</translation>
    </message>
    <message>
        <source>The scene as the lesson has it, whatever was dragged</source>
        <translation>Die Szene, wie die Lektion sie hat, was auch gezogen wurde</translation>
    </message>
    <message>
        <source>Back to your own scene</source>
        <translation>Zurück zur eigenen Szene</translation>
    </message>
    <message>
        <source>Open &amp;Lesson…</source>
        <translation>&amp;Lektion öffnen …</translation>
    </message>
    <message>
        <source>Lea&amp;ve Lesson</source>
        <translation>Lektion &amp;verlassen</translation>
    </message>
</context>
<context>
    <name>LessonWords</name>
    <message>
        <source>A cusp: the curve has no tangent here, so there is no normal. Move the probe.</source>
        <translation>Eine Spitze: Die Kurve hat hier keine Tangente, also auch keine Normale. Bewegen Sie die Sonde.</translation>
    </message>
    <message>
        <source>A silhouette: n·j = 0. Nothing can be differentiated by the screen coordinate here; λ has no finite value.</source>
        <translation>Eine Silhouette: n·j = 0. Nach der Schirmkoordinate lässt sich hier nichts ableiten; λ hat keinen endlichen Wert.</translation>
    </message>
    <message>
        <source>Point at the curve to see the values there.</source>
        <translation>Zeigen Sie auf die Kurve, um die Werte dort zu sehen.</translation>
    </message>
    <message>
        <source>%1 (%2 % of the curve)</source>
        <translation>%1 (%2 % der Kurve)</translation>
    </message>
    <message>
        <source>(3.13) as printed has no roots here</source>
        <translation>(3.13) wie gedruckt hat hier keine Nullstellen</translation>
    </message>
    <message>
        <source>Printed roots at a maximum of λ: %1 of %2</source>
        <translation>Gedruckte Nullstellen an einem Maximum von λ: %1 von %2</translation>
    </message>
    <message>
        <source>; no apparent ridge on their curve</source>
        <translation>; kein scheinbarer Grat auf ihrer Kurve</translation>
    </message>
    <message>
        <source>; off the nearest apparent ridge by %1</source>
        <translation>; zum nächsten scheinbaren Grat %1</translation>
    </message>
    <message>
        <source>; off the nearest apparent ridge by %1 at best, %2 at worst</source>
        <translation>; zum nächsten scheinbaren Grat mindestens %1, höchstens %2</translation>
    </message>
    <message>
        <source>at arc length %1: off the nearest apparent ridge by %2</source>
        <translation>bei Bogenlänge %1: zum nächsten scheinbaren Grat %2</translation>
    </message>
    <message>
        <source>at arc length %1: no apparent ridge on the curve</source>
        <translation>bei Bogenlänge %1: kein scheinbarer Grat auf der Kurve</translation>
    </message>
    <message>
        <source>The normal is unknown here.</source>
        <translation>Die Normale ist hier nicht bekannt.</translation>
    </message>
    <message>
        <source>Seen from here the surface bends alike in all directions, or not at all: there is no t_A.</source>
        <translation>Von hier gesehen krümmt sich die Fläche in alle Richtungen gleich oder gar nicht: es gibt kein t_A.</translation>
    </message>
    <message>
        <source>%1: rounding, both sides agree</source>
        <translation>%1: Rundung, beide Seiten gleich</translation>
    </message>
    <message>
        <source>|left| + |right|</source>
        <translation>|links| + |rechts|</translation>
    </message>
    <message>
        <source>%1: &lt;b&gt;%2 % of %3&lt;/b&gt;</source>
        <translation>%1: &lt;b&gt;%2 % von %3&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1: &lt;b&gt;%2 % of the largest %3&lt;/b&gt;</source>
        <translation>%1: &lt;b&gt;%2 % des größten %3&lt;/b&gt;</translation>
    </message>
    <message>
        <source>left − right</source>
        <translation>links − rechts</translation>
    </message>
    <message>
        <source>largest |left − right|</source>
        <translation>größtes |links − rechts|</translation>
    </message>
</context>
<context>
    <name>LimitsWords</name>
    <message>
        <source>λ</source>
        <translation>λ</translation>
    </message>
    <message>
        <source>|feature|</source>
        <translation>|Merkmal|</translation>
    </message>
    <message>
        <source>|offset|</source>
        <translation>|Versatz|</translation>
    </message>
    <message>
        <source>|offset| / |feature|</source>
        <translation>|Versatz| / |Merkmal|</translation>
    </message>
    <message>
        <source>apparent ridge to the merging</source>
        <translation>scheinbarer Grat bis zur Verschmelzung</translation>
    </message>
    <message>
        <source>silhouette to the merging</source>
        <translation>Silhouette bis zur Verschmelzung</translation>
    </message>
    <message>
        <source>|n·w|</source>
        <translation>|n·w|</translation>
    </message>
    <message>
        <source>arc length to the silhouette</source>
        <translation>Bogenlänge bis zur Silhouette</translation>
    </message>
    <message>
        <source>angle to the merging, radians</source>
        <translation>Winkel bis zur Verschmelzung, Bogenmaß</translation>
    </message>
    <message>
        <source>λ = k²/(n·w)²: slope −2. The feature term falls with n·w, the offset term stays. At n·w = 0 the equation is singular and says nothing, but λ grows without bound towards it: its supremum lies there, and the silhouette is drawn as such.</source>
        <translation>λ = k²/(n·w)²: Steigung −2. Der Merkmalsterm fällt mit n·w, der Versatzterm bleibt. Bei n·w = 0 ist die Gleichung singulär und sagt nichts, aber λ wächst dorthin ohne Grenze: Dort liegt sein Supremum, und die Silhouette wird als solche gezeichnet.</translation>
    </message>
    <message>
        <source>n·w falls as k s, and k cancels: λ = 1/s², whatever the curvature. The feature term vanishes with s, the offset term does not: near a silhouette there is no apparent ridge.</source>
        <translation>n·w fällt wie k s, und k kürzt sich: λ = 1/s², gleich welche Krümmung. Der Merkmalsterm verschwindet mit s, der Versatzterm nicht: Nahe einer Silhouette gibt es keinen scheinbaren Grat.</translation>
    </message>
    <message>
        <source>k and n·w vanish together: k as s, n·w as s². λ = 4/s², four times as fast as at an ordinary silhouette, and the offset term is twice the feature term.</source>
        <translation>k und n·w verschwinden zusammen: k wie s, n·w wie s². λ = 4/s², viermal so schnell wie an einer gewöhnlichen Silhouette, und der Versatzterm ist das Doppelte des Merkmalsterms.</translation>
    </message>
    <message>
        <source>k vanishes as a power m of s, n·w as the power m + 1: λ = (m + 1)²/s².</source>
        <translation>k verschwindet wie eine Potenz m von s, n·w wie die Potenz m + 1: λ = (m + 1)²/s².</translation>
    </message>
    <message>
        <source>At a cusp k grows as 1/√s while n·w does not vanish: λ grows as 1/s only.</source>
        <translation>An einer Spitze wächst k wie 1/√s, während n·w nicht verschwindet: λ wächst nur wie 1/s.</translation>
    </message>
    <message>
        <source>At a cusp that points along the line of sight k grows as 1/√s and n·w falls as √s: λ = 1/(4 s²).</source>
        <translation>An einer Spitze, die entlang der Sehlinie zeigt, wächst k wie 1/√s und n·w fällt wie √s: λ = 1/(4 s²).</translation>
    </message>
    <message>
        <source>Seen along the tangent of an inflection, two apparent ridges meet and leave as two silhouettes. On both sides their distance is √(2 angle / |k′|): slope 1/2.</source>
        <translation>Entlang der Tangente eines Wendepunkts gesehen treffen sich zwei scheinbare Grate und gehen als zwei Silhouetten auseinander. Auf beiden Seiten ist ihr Abstand √(2 Winkel / |k′|): Steigung 1/2.</translation>
    </message>
</context>
<context>
    <name>MarkWords</name>
    <message>
        <source>Silhouette</source>
        <translation>Silhouette</translation>
    </message>
    <message>
        <source>Silhouettes</source>
        <translation>Silhouetten</translation>
    </message>
    <message>
        <source>The line of sight touches the curve.</source>
        <translation>Die Sehlinie berührt die Kurve.</translation>
    </message>
    <message>
        <source>Inflection</source>
        <translation>Wendepunkt</translation>
    </message>
    <message>
        <source>Inflections</source>
        <translation>Wendepunkte</translation>
    </message>
    <message>
        <source>The curvature changes sign.</source>
        <translation>Die Krümmung wechselt das Vorzeichen.</translation>
    </message>
    <message>
        <source>Ridge</source>
        <translation>Grat</translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation>Grate</translation>
    </message>
    <message>
        <source>The curve bulges most to the side of its normal: a positive maximum of curvature.</source>
        <translation>Die Kurve wölbt sich am meisten zur Seite ihrer Normale: ein positives Maximum der Krümmung.</translation>
    </message>
    <message>
        <source>Valley</source>
        <translation>Tal</translation>
    </message>
    <message>
        <source>Valleys</source>
        <translation>Täler</translation>
    </message>
    <message>
        <source>The curve bulges most away from its normal: a negative minimum of curvature.</source>
        <translation>Die Kurve wölbt sich am meisten von ihrer Normale weg: ein negatives Minimum der Krümmung.</translation>
    </message>
    <message>
        <source>Flat point</source>
        <translation>Flachpunkt</translation>
    </message>
    <message>
        <source>Flat points</source>
        <translation>Flachpunkte</translation>
    </message>
    <message>
        <source>The curve is least curved here without being straight.</source>
        <translation>Die Kurve ist hier am wenigsten gekrümmt, ohne gerade zu sein.</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>The tangent jumps: a kink or a cusp.</source>
        <translation>Die Tangente springt: ein Knick oder eine Spitze.</translation>
    </message>
    <message>
        <source>Apparent ridge</source>
        <translation>Scheinbarer Grat</translation>
    </message>
    <message>
        <source>Apparent ridges</source>
        <translation>Scheinbare Grate</translation>
    </message>
    <message>
        <source>The curvature as seen on the screen, λ, has a maximum.</source>
        <translation>Die Krümmung, wie der Schirm sie zeigt, λ, hat ein Maximum.</translation>
    </message>
    <message>
        <source>Apparent minimum</source>
        <translation>Scheinbares Minimum</translation>
    </message>
    <message>
        <source>Apparent minima</source>
        <translation>Scheinbare Minima</translation>
    </message>
    <message>
        <source>The curvature as seen on the screen, λ, has a minimum.</source>
        <translation>Die Krümmung, wie der Schirm sie zeigt, λ, hat ein Minimum.</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Curve</source>
        <translation>&amp;Kurve</translation>
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
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>All keys and mouse gestures on one sheet</source>
        <translation>Alle Tasten und Mausgesten auf einem Blatt</translation>
    </message>
    <message>
        <source>&amp;About Flatland</source>
        <translation>Ü&amp;ber Flatland</translation>
    </message>
    <message>
        <source>What this program is</source>
        <translation>Was dieses Programm ist</translation>
    </message>
    <message>
        <source>&amp;Lesson</source>
        <translation>&amp;Lektion</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>&amp;Fläche</translation>
    </message>
</context>
<context>
    <name>MoveCurve</name>
    <message>
        <source>move curve</source>
        <translation>Kurve bewegen</translation>
    </message>
</context>
<context>
    <name>MovePoints</name>
    <message>
        <source>move point</source>
        <translation>Punkt bewegen</translation>
    </message>
    <message>
        <source>move points</source>
        <translation>Punkte bewegen</translation>
    </message>
</context>
<context>
    <name>NewCurves</name>
    <message>
        <source>&amp;Bezier</source>
        <translation>&amp;Bézier</translation>
    </message>
    <message>
        <source>B-&amp;spline, closed</source>
        <translation>B-&amp;Spline, geschlossen</translation>
    </message>
    <message>
        <source>&amp;Rational Bezier: a circle</source>
        <translation>&amp;Rationale Bézierkurve: ein Kreis</translation>
    </message>
    <message>
        <source>&amp;Typed Formula</source>
        <translation>Eingetippte &amp;Formel</translation>
    </message>
</context>
<context>
    <name>PaneMarks</name>
    <message>
        <source>Solving for ink</source>
        <translation>Tinte wird gelöst</translation>
    </message>
    <message>
        <source>Ink %1 %</source>
        <translation>Tinte %1 %</translation>
    </message>
    <message>
        <source>Thresholds × %1</source>
        <translation>Schwellen × %1</translation>
    </message>
    <message>
        <source>Ink %1 % of %2 %</source>
        <translation>Tinte %1 % von %2 %</translation>
    </message>
    <message>
        <source>As view 1 sees it:</source>
        <translation>Wie Ansicht 1 es sieht:</translation>
    </message>
</context>
<context>
    <name>PaneWords</name>
    <message>
        <source>Families of the First View</source>
        <translation>Familien der ersten Ansicht</translation>
    </message>
    <message>
        <source>change view</source>
        <translation>Ansicht ändern</translation>
    </message>
    <message>
        <source>Derivative from Neighbours, as in the Thesis</source>
        <translation>Ableitung aus Nachbarn, wie in der Dissertation</translation>
    </message>
    <message>
        <source>Difference from the First View</source>
        <translation>Unterschied zur ersten Ansicht</translation>
    </message>
    <message>
        <source>Camera of Its Own</source>
        <translation>Eigene Kamera</translation>
    </message>
    <message>
        <source>No lines</source>
        <translation>Keine Linien</translation>
    </message>
    <message>
        <source>Difference: %1</source>
        <translation>Unterschied: %1</translation>
    </message>
    <message>
        <source>Second camera: %1</source>
        <translation>Zweite Kamera: %1</translation>
    </message>
    <message>
        <source>change lines</source>
        <translation>Linien ändern</translation>
    </message>
    <message>
        <source>By neighbours: %1</source>
        <translation>Aus Nachbarn: %1</translation>
    </message>
    <message>
        <source>Draw the lines that the first view draws</source>
        <translation>Die Linien zeichnen, die die erste Ansicht zeichnet</translation>
    </message>
    <message>
        <source>Apparent ridges by differences between neighbours; off: by the closed form</source>
        <translation>Scheinbare Grate aus Differenzen zwischen Nachbarn; aus: aus der geschlossenen Form</translation>
    </message>
    <message>
        <source>Lines of both views, coloured by which of them has them</source>
        <translation>Linien beider Ansichten, gefärbt danach, welche von ihnen sie hat</translation>
    </message>
    <message>
        <source>See the lines of the first view from elsewhere</source>
        <translation>Die Linien der ersten Ansicht von anderswo sehen</translation>
    </message>
    <message>
        <source>Draw these lines in this view</source>
        <translation>Diese Linien in dieser Ansicht zeichnen</translation>
    </message>
</context>
<context>
    <name>Panels</name>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Rundblick</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzfälle</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Verläufe</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Brücke</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Surface derivation</source>
        <translation>Herleitung der Fläche</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Dreieck</translation>
    </message>
</context>
<context>
    <name>PictureLegend</name>
    <message>
        <source>In both, within a mean edge</source>
        <translation>In beiden, bis auf eine mittlere Kante</translation>
    </message>
    <message>
        <source>Only here: %1 % of these</source>
        <translation>Nur hier: %1 % von diesen</translation>
    </message>
    <message>
        <source>Missing: %1 % of the first</source>
        <translation>Fehlt: %1 % der ersten</translation>
    </message>
    <message>
        <source>linear to ±%1, then logarithmic</source>
        <translation>linear bis ±%1, dann logarithmisch</translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation>logarithmisch</translation>
    </message>
</context>
<context>
    <name>PlacePoint</name>
    <message>
        <source>type coordinates</source>
        <translation>Koordinaten eintippen</translation>
    </message>
</context>
<context>
    <name>ProbeMenu</name>
    <message>
        <source>&amp;Place at Pointer</source>
        <translation>An den &amp;Mauszeiger setzen</translation>
    </message>
    <message>
        <source>Put the probe on the curve where the pointer is; a click there does so too</source>
        <translation>Die Sonde auf die Kurve setzen, wo der Mauszeiger ist; ein Klick dort tut es auch</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Take the probe away (Esc with nothing selected)</source>
        <translation>Die Sonde wegnehmen (Esc, wenn nichts ausgewählt ist)</translation>
    </message>
    <message>
        <source>&amp;Next Mark</source>
        <translation>&amp;Nächste Marke</translation>
    </message>
    <message>
        <source>Move the probe to the next mark, exactly</source>
        <translation>Die Sonde genau auf die nächste Marke setzen</translation>
    </message>
    <message>
        <source>Move the probe to the mark before, exactly</source>
        <translation>Die Sonde genau auf die vorige Marke setzen</translation>
    </message>
    <message>
        <source>&amp;Forward</source>
        <translation>Vor&amp;wärts</translation>
    </message>
    <message>
        <source>Move the probe along the curve</source>
        <translation>Die Sonde die Kurve entlang bewegen</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Rückwärts</translation>
    </message>
    <message>
        <source>Move the probe back along the curve</source>
        <translation>Die Sonde auf der Kurve zurück bewegen</translation>
    </message>
    <message>
        <source>Forward, Ten Times</source>
        <translation>Zehnfach vorwärts</translation>
    </message>
    <message>
        <source>Move the probe ten times as far</source>
        <translation>Die Sonde zehnmal so weit bewegen</translation>
    </message>
    <message>
        <source>Back, Ten Times</source>
        <translation>Zehnfach rückwärts</translation>
    </message>
    <message>
        <source>Move the probe back ten times as far</source>
        <translation>Die Sonde zehnmal so weit zurück bewegen</translation>
    </message>
    <message>
        <source>&amp;Vectors n, t, k</source>
        <translation>&amp;Vektoren n, t, k</translation>
    </message>
    <message>
        <source>Normal, tangent and dn/du = k t at the probe</source>
        <translation>Normale, Tangente und dn/du = k t an der Sonde</translation>
    </message>
    <message>
        <source>&amp;Osculating Circle</source>
        <translation>&amp;Schmiegekreis</translation>
    </message>
    <message>
        <source>The circle that touches the curve to second order at the probe</source>
        <translation>Der Kreis, der die Kurve an der Sonde in zweiter Ordnung berührt</translation>
    </message>
    <message>
        <source>&amp;Curvature Comb</source>
        <translation>&amp;Krümmungskamm</translation>
    </message>
    <message>
        <source>Teeth as long as the curvature is large, along the curve of the probe</source>
        <translation>Zähne, so lang wie die Krümmung groß ist, entlang der Kurve der Sonde</translation>
    </message>
    <message>
        <source>&amp;dn/di on the Screen</source>
        <translation>&amp;dn/di auf dem Schirm</translation>
    </message>
    <message>
        <source>How fast the normal turns for a step on the screen</source>
        <translation>Wie schnell sich die Normale für einen Schritt auf dem Schirm dreht</translation>
    </message>
    <message>
        <source>&amp;Longer Comb</source>
        <translation>&amp;Längerer Kamm</translation>
    </message>
    <message>
        <source>Lengthen the teeth of the comb</source>
        <translation>Die Zähne des Kamms verlängern</translation>
    </message>
    <message>
        <source>&amp;Shorter Comb</source>
        <translation>Kür&amp;zerer Kamm</translation>
    </message>
    <message>
        <source>Shorten the teeth of the comb</source>
        <translation>Die Zähne des Kamms verkürzen</translation>
    </message>
    <message>
        <source>Previo&amp;us Mark</source>
        <translation>V&amp;orige Marke</translation>
    </message>
</context>
<context>
    <name>ProbeOverlay</name>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>t</source>
        <translation>t</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>dn/di = %1</source>
        <translation>dn/di = %1</translation>
    </message>
    <message>
        <source>comb: k = %1</source>
        <translation>Kamm: k = %1</translation>
    </message>
</context>
<context>
    <name>ProfilePlot</name>
    <message>
        <source>arc length u</source>
        <translation>Bogenlänge u</translation>
    </message>
    <message>
        <source>screen coordinate</source>
        <translation>Schirmkoordinate</translation>
    </message>
    <message>
        <source>Curvature k</source>
        <translation>Krümmung k</translation>
    </message>
    <message>
        <source>View-dependent curvature λ</source>
        <translation>Blickabhängige Krümmung λ</translation>
    </message>
    <message>
        <source>Terms</source>
        <translation>Terme</translation>
    </message>
    <message>
        <source>|offset| / |feature|</source>
        <translation>|Versatz| / |Merkmal|</translation>
    </message>
    <message>
        <source>Curvature k, with dn/du = k t: positive where the curve bulges to the side of its normal. Peaks that would flatten the rest are cut off.</source>
        <translation>Krümmung k, mit dn/du = k t: positiv, wo sich die Kurve zur Seite ihrer Normale wölbt. Spitzen, die den Rest flach drückten, sind abgeschnitten.</translation>
    </message>
    <message>
        <source>λ = |dn/di|² = k² / (n·w)², on a logarithmic axis: how fast the normal turns for a step on the screen, squared. Infinite at silhouettes, 0 at inflections.</source>
        <translation>λ = |dn/di|² = k² / (n·w)², auf logarithmischer Achse: wie schnell sich die Normale für einen Schritt auf dem Schirm dreht, im Quadrat. Unendlich an Silhouetten, 0 an Wendepunkten.</translation>
    </message>
    <message>
        <source>The terms of the apparent-ridge equation and their sum, which is (n·w)³/2 times the derivative of λ. The axis is that of asinh: linear near 0, logarithmic beyond, so that small and large values are both readable.</source>
        <translation>Die Terme der Gleichung des scheinbaren Grats und ihre Summe; sie ist (n·w)³/2 mal die Ableitung von λ. Die Achse ist die des asinh: linear bei 0, darüber hinaus logarithmisch, sodass kleine und große Werte lesbar sind.</translation>
    </message>
    <message>
        <source>Size of the offset term against the feature term, on a logarithmic axis. Above the line at 1 the offset is the larger one.</source>
        <translation>Größe des Versatzterms gegen den Merkmalsterm, auf logarithmischer Achse. Über der Linie bei 1 ist der Versatz der größere.</translation>
    </message>
    <message>
        <source>feature</source>
        <translation>Merkmal</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>%1, log</source>
        <translation>%1, logarithmisch</translation>
    </message>
    <message>
        <source>%1, asinh, linear to ±%2</source>
        <translation>%1, asinh, linear bis ±%2</translation>
    </message>
</context>
<context>
    <name>RaiseDegree</name>
    <message>
        <source>raise degree</source>
        <translation>Grad erhöhen</translation>
    </message>
</context>
<context>
    <name>RemoveCurve</name>
    <message>
        <source>remove curve</source>
        <translation>Kurve entfernen</translation>
    </message>
</context>
<context>
    <name>RemovePoints</name>
    <message>
        <source>remove points</source>
        <translation>Punkte entfernen</translation>
    </message>
</context>
<context>
    <name>SaveName</name>
    <message>
        <source>Replace file</source>
        <translation>Datei ersetzen</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
</context>
<context>
    <name>SceneSummary</name>
    <message numerus="yes">
        <source>%n curves</source>
        <translation>
            <numerusform>%n Kurve</numerusform>
            <numerusform>%n Kurven</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n control points</source>
        <translation>
            <numerusform>%n Kontrollpunkt</numerusform>
            <numerusform>%n Kontrollpunkte</numerusform>
        </translation>
    </message>
    <message>
        <source>Seen from %1°.</source>
        <translation>Gesehen von %1°.</translation>
    </message>
    <message numerus="yes">
        <source>%n marks are hidden.</source>
        <translation>
            <numerusform>%n Marke ist verdeckt.</numerusform>
            <numerusform>%n Marken sind verdeckt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SectionCommand</name>
    <message>
        <source>There is no plane that cuts the surface yet.</source>
        <translation>Noch schneidet keine Ebene die Fläche.</translation>
    </message>
    <message>
        <source>The plane does not cut the surface.</source>
        <translation>Die Ebene schneidet die Fläche nicht.</translation>
    </message>
    <message>
        <source>open section</source>
        <translation>Schnitt öffnen</translation>
    </message>
</context>
<context>
    <name>SetView</name>
    <message>
        <source>change projection</source>
        <translation>Projektion ändern</translation>
    </message>
    <message>
        <source>turn view</source>
        <translation>Ansicht drehen</translation>
    </message>
</context>
<context>
    <name>SurfaceMenu</name>
    <message>
        <source>&amp;Front	1</source>
        <translation>Von &amp;vorn	1</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>Von &amp;hinten</translation>
    </message>
    <message>
        <source>&amp;Right	3</source>
        <translation>Von &amp;rechts	3</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Von &amp;links</translation>
    </message>
    <message>
        <source>&amp;Top	7</source>
        <translation>Von &amp;oben	7</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>Von &amp;unten</translation>
    </message>
    <message>
        <source>Look at the surface from there</source>
        <translation>Die Fläche von dort aus ansehen</translation>
    </message>
    <message>
        <source>&amp;Perspective	5</source>
        <translation>&amp;Perspektive	5</translation>
    </message>
    <message>
        <source>The viewer of the surface stands at a distance, or far away</source>
        <translation>Der Betrachter der Fläche steht in einem Abstand oder weit weg</translation>
    </message>
    <message>
        <source>R&amp;eset Camera	R</source>
        <translation>Kamera &amp;zurücksetzen	R</translation>
    </message>
    <message>
        <source>Look at the surface as when it was opened</source>
        <translation>Die Fläche so ansehen wie beim Öffnen</translation>
    </message>
    <message>
        <source>&amp;Open Mesh…</source>
        <translation>Netz &amp;öffnen …</translation>
    </message>
    <message>
        <source>Put a mesh beside the curves: PLY, OBJ, STL, OFF, glTF</source>
        <translation>Ein Netz neben die Kurven stellen: PLY, OBJ, STL, OFF, glTF</translation>
    </message>
    <message>
        <source>&amp;Solids</source>
        <translation>&amp;Körper</translation>
    </message>
    <message>
        <source>Put a surface given by a formula beside the curves</source>
        <translation>Eine durch eine Formel gegebene Fläche neben die Kurven stellen</translation>
    </message>
    <message>
        <source>&amp;Next Mesh in the Folder</source>
        <translation>&amp;Nächstes Netz im Ordner</translation>
    </message>
    <message>
        <source>Open the next mesh of this folder, by name</source>
        <translation>Das dem Namen nach nächste Netz dieses Ordners öffnen</translation>
    </message>
    <message>
        <source>&amp;Previous Mesh in the Folder</source>
        <translation>&amp;Voriges Netz im Ordner</translation>
    </message>
    <message>
        <source>Open the mesh before this one in its folder</source>
        <translation>Das Netz vor diesem in seinem Ordner öffnen</translation>
    </message>
    <message>
        <source>&amp;Close Surface</source>
        <translation>Fläche s&amp;chließen</translation>
    </message>
    <message>
        <source>Take the surface out of the scene</source>
        <translation>Die Fläche aus der Szene nehmen</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>&amp;Ansehen</translation>
    </message>
    <message>
        <source>Sp&amp;in	Space</source>
        <translation>K&amp;reiseln	Leertaste</translation>
    </message>
    <message>
        <source>Turn the surface on and on</source>
        <translation>Die Fläche immer weiter drehen</translation>
    </message>
    <message>
        <source>&amp;Export Surface…</source>
        <translation>Fläche &amp;exportieren …</translation>
    </message>
    <message>
        <source>Write the picture of the surface</source>
        <translation>Das Bild der Fläche schreiben</translation>
    </message>
    <message>
        <source>Co&amp;mpare</source>
        <translation>&amp;Vergleichen</translation>
    </message>
    <message>
        <source>This axis of the file points upward</source>
        <translation>Diese Achse der Datei zeigt nach oben</translation>
    </message>
    <message>
        <source>change up axis</source>
        <translation>Achse nach oben ändern</translation>
    </message>
    <message>
        <source>&amp;Up Axis</source>
        <translation>&amp;Achse nach oben</translation>
    </message>
</context>
<context>
    <name>SweepCommand</name>
    <message>
        <source>revolve curve</source>
        <translation>Kurve rotieren</translation>
    </message>
    <message>
        <source>extrude curve</source>
        <translation>Kurve extrudieren</translation>
    </message>
</context>
<context>
    <name>SweepWords</name>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>born or merged at %1°</source>
        <translation>geboren oder verschmolzen bei %1°</translation>
    </message>
</context>
<context>
    <name>UnsavedWork</name>
    <message>
        <source>the curves as you changed them</source>
        <translation>die Kurven, wie Sie sie geändert haben</translation>
    </message>
    <message>
        <source>from where the curves are seen</source>
        <translation>von wo die Kurven gesehen werden</translation>
    </message>
    <message>
        <source>the surface made of a curve</source>
        <translation>die Fläche, die aus einer Kurve gemacht ist</translation>
    </message>
    <message>
        <source>thresholds, colours and widths of the lines of %1</source>
        <translation>Schwellen, Farben und Breiten der Linien von %1</translation>
    </message>
    <message>
        <source>the cameras you kept</source>
        <translation>die Kameras, die Sie behalten haben</translation>
    </message>
    <message>
        <source>how it is shown</source>
        <translation>wie sie gezeigt wird</translation>
    </message>
    <message>
        <source>how %1 is shown</source>
        <translation>wie %1 gezeigt wird</translation>
    </message>
    <message>
        <source>thresholds, colours and widths of lines</source>
        <translation>Schwellen, Farben und Breiten von Linien</translation>
    </message>
    <message>
        <source>%1 beside the curves</source>
        <comment>a mesh</comment>
        <translation>%1 neben den Kurven</translation>
    </message>
    <message>
        <source>%1 in the place of: %2</source>
        <comment>a mesh, a surface</comment>
        <translation>%1 anstelle von: %2</translation>
    </message>
    <message>
        <source>that a surface was closed (%1)</source>
        <translation>dass eine Fläche geschlossen wurde (%1)</translation>
    </message>
    <message>
        <source>the plane that cuts the surface</source>
        <translation>die Ebene, die die Fläche schneidet</translation>
    </message>
    <message>
        <source>that the plane was removed</source>
        <translation>dass die Ebene entfernt wurde</translation>
    </message>
</context>
<context>
    <name>ViewMenu</name>
    <message>
        <source>&amp;Fit</source>
        <translation>E&amp;inpassen</translation>
    </message>
    <message>
        <source>Show the whole scene</source>
        <translation>Die ganze Szene zeigen</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Show it larger</source>
        <translation>Größer zeigen</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Show it smaller</source>
        <translation>Kleiner zeigen</translation>
    </message>
    <message>
        <source>View from %1°</source>
        <translation>Ansicht von %1°</translation>
    </message>
    <message>
        <source>Put the viewer at %1°</source>
        <translation>Den Betrachter auf %1° stellen</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>The viewer stands at a distance</source>
        <translation>Der Betrachter steht in einem Abstand</translation>
    </message>
    <message>
        <source>&amp;Control Polygon</source>
        <translation>K&amp;ontrollpolygon</translation>
    </message>
    <message>
        <source>Show the lines between the control points</source>
        <translation>Die Linien zwischen den Kontrollpunkten zeigen</translation>
    </message>
    <message>
        <source>&amp;Hidden Parts</source>
        <translation>&amp;Verdeckte Teile</translation>
    </message>
    <message>
        <source>Show what the viewer cannot see, paler</source>
        <translation>Blasser zeigen, was der Betrachter nicht sieht</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>&amp;Bedienfelder</translation>
    </message>
    <message>
        <source>Show or close this panel</source>
        <translation>Dieses Bedienfeld zeigen oder schließen</translation>
    </message>
    <message>
        <source>Ne&amp;xt Pane</source>
        <translation>&amp;Nächster Bereich</translation>
    </message>
    <message>
        <source>Move the focus on: canvas, panels</source>
        <translation>Den Fokus weitergeben: Zeichenfläche, Bedienfelder</translation>
    </message>
    <message>
        <source>Pre&amp;vious Pane</source>
        <translation>Vor&amp;heriger Bereich</translation>
    </message>
    <message>
        <source>Move the focus back</source>
        <translation>Den Fokus zurückgeben</translation>
    </message>
    <message>
        <source>Pro&amp;be</source>
        <translation>Sond&amp;e</translation>
    </message>
</context>
<context>
    <name>flatland::ui::BridgeController</name>
    <message>
        <source>The section is in flatland; undo brings the curves back.</source>
        <translation>Der Schnitt ist in Flatland; Rückgängig bringt die Kurven zurück.</translation>
    </message>
    <message>
        <source>There is no curve to make a surface of.</source>
        <translation>Es gibt keine Kurve, aus der eine Fläche werden könnte.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::BridgePanel</name>
    <message>
        <source>Median distance of the lines found from those that flatland predicts, in edges of the mesh, and how much of the predicted lines was found</source>
        <translation>Median des Abstands der gefundenen Linien von denen, die Flatland vorhersagt, in Kanten des Netzes, und wie viel der vorhergesagten gefunden wurde</translation>
    </message>
    <message>
        <source>Not swept</source>
        <translation>Nicht aus einer Kurve</translation>
    </message>
    <message>
        <source>Extrusion</source>
        <translation>Extrusion</translation>
    </message>
    <message>
        <source>Revolution</source>
        <translation>Rotationsfläche</translation>
    </message>
    <message>
        <source>How the curve becomes a surface: moved across its plane, or turned about an axis in it</source>
        <translation>Wie aus der Kurve eine Fläche wird: quer zu ihrer Ebene verschoben oder um eine Achse in ihr gedreht</translation>
    </message>
    <message>
        <source>S&amp;urface</source>
        <translation>&amp;Fläche</translation>
    </message>
    <message>
        <source>Which curve of the scene is swept</source>
        <translation>Welche Kurve der Szene bewegt wird</translation>
    </message>
    <message>
        <source>sweep another curve</source>
        <translation>andere Kurve bewegen</translation>
    </message>
    <message>
        <source>&amp;Curve</source>
        <translation>&amp;Kurve</translation>
    </message>
    <message>
        <source>change sweep</source>
        <translation>Bewegung ändern</translation>
    </message>
    <message>
        <source>Cells of the mesh along the curve. While a curve is dragged there are as many as keep up with the hand</source>
        <translation>Zellen des Netzes entlang der Kurve. Während eine Kurve gezogen wird, sind es so viele, wie mit der Hand Schritt halten</translation>
    </message>
    <message>
        <source>change resolution</source>
        <translation>Auflösung ändern</translation>
    </message>
    <message>
        <source>C&amp;ells</source>
        <translation>&amp;Zellen</translation>
    </message>
    <message>
        <source>&amp;Link views</source>
        <translation>Ansichten &amp;verknüpfen</translation>
    </message>
    <message>
        <source>Who turns the surface turns the flat view, and the other way</source>
        <translation>Wer die Fläche dreht, dreht die Ansicht in Flatland, und umgekehrt</translation>
    </message>
    <message>
        <source>&amp;Predicted lines</source>
        <translation>Vor&amp;hergesagte Linien</translation>
    </message>
    <message>
        <source>Draw where flatland says that the lines are, dashed, with ticks at the edge of the picture; pale where they cannot be expected</source>
        <translation>Zeichnen, wo die Linien laut Flatland sind, gestrichelt, mit Strichen am Bildrand; blass, wo sie nicht zu erwarten sind</translation>
    </message>
    <message>
        <source>close surface</source>
        <translation>Fläche schließen</translation>
    </message>
    <message>
        <source>There is no curve to make a surface of.</source>
        <translation>Es gibt keine Kurve, aus der eine Fläche werden könnte.</translation>
    </message>
    <message>
        <source>Curve %1</source>
        <translation>Kurve %1</translation>
    </message>
    <message>
        <source>&amp;Axis at x</source>
        <translation>&amp;Achse bei x</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>Where the upright axis of the revolution is</source>
        <translation>Wo die aufrechte Drehachse ist</translation>
    </message>
    <message>
        <source>How far the curve is moved across its plane</source>
        <translation>Wie weit die Kurve quer zu ihrer Ebene verschoben wird</translation>
    </message>
    <message>
        <source>The curve that the surface was swept from is gone.</source>
        <translation>Die Kurve, aus der die Fläche entstand, ist nicht mehr da.</translation>
    </message>
    <message>
        <source>Why the views are not linked</source>
        <translation>Warum die Ansichten nicht verknüpft sind</translation>
    </message>
    <message>
        <source>How prediction and lines agree</source>
        <translation>Wie Vorhersage und Linien übereinstimmen</translation>
    </message>
</context>
<context>
    <name>flatland::ui::BridgeStudy</name>
    <message>
        <source>Distance over resolution</source>
        <translation>Abstand über der Auflösung</translation>
    </message>
    <message>
        <source>Median distance of extracted to predicted ridges, for meshes of 16 to 256 cells along the curve</source>
        <translation>Median des Abstands gefundener von vorhergesagten Graten, für Netze mit 16 bis 256 Zellen entlang der Kurve</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Write the diagram as a picture, or all values as CSV</source>
        <translation>Das Diagramm als Bild schreiben oder alle Werte als CSV</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Study resolutions</source>
        <translation>Auflösungen &amp;untersuchen</translation>
    </message>
    <message>
        <source>Give up the study</source>
        <translation>Die Untersuchung aufgeben</translation>
    </message>
    <message>
        <source>Measure the distance on meshes of 16 to 256 cells, for both estimators of curvature and both ways to the derivative</source>
        <translation>Den Abstand auf Netzen mit 16 bis 256 Zellen messen, für beide Schätzer der Krümmung und beide Wege zur Ableitung</translation>
    </message>
    <message>
        <source>bridge</source>
        <translation>bruecke</translation>
    </message>
    <message>
        <source>Of the curve and the view as they were.</source>
        <translation>Von Kurve und Ansicht, wie sie vorher waren.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::ColourStrip</name>
    <message>
        <source>Legend of the colours</source>
        <translation>Legende der Farben</translation>
    </message>
</context>
<context>
    <name>flatland::ui::CurvePanel</name>
    <message>
        <source>&amp;Convert to Bezier Chain</source>
        <translation>In Bézier-&amp;Kette umwandeln</translation>
    </message>
    <message>
        <source>, degree %1</source>
        <translation>, Grad %1</translation>
    </message>
    <message>
        <source>, closed</source>
        <translation>, geschlossen</translation>
    </message>
    <message>
        <source>, open</source>
        <translation>, offen</translation>
    </message>
    <message>
        <source>No curve. The menu Curve &gt; New adds one.</source>
        <translation>Keine Kurve. Das Menü Kurve &gt; Neu fügt eine hinzu.</translation>
    </message>
    <message>
        <source>Curve %1: %2</source>
        <translation>Kurve %1: %2</translation>
    </message>
    <message>
        <source>The same curve as Bezier pieces with points to drag: exact</source>
        <translation>Dieselbe Kurve als Bézier-Stücke mit ziehbaren Punkten: genau</translation>
    </message>
    <message>
        <source>Cubic Bezier pieces with points to drag, within a millionth of the size of the curve</source>
        <translation>Kubische Bézier-Stücke mit ziehbaren Punkten, auf ein Millionstel der Größe der Kurve genau</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>How strongly each point pulls the curve: a number above 0</source>
        <translation>Wie stark jeder Punkt die Kurve zieht: eine Zahl über 0</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>“%1” is not a number; the weight stays.</source>
        <translation>„%1“ ist keine Zahl; das Gewicht bleibt.</translation>
    </message>
    <message>
        <source>change weight</source>
        <translation>Gewicht ändern</translation>
    </message>
    <message>
        <source>The curve is a single point and stays as it is.</source>
        <translation>Die Kurve ist ein einziger Punkt und bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>convert curve</source>
        <translation>Kurve umwandeln</translation>
    </message>
    <message>
        <source>, points: %1</source>
        <translation>, Punkte: %1</translation>
    </message>
    <message>
        <source>, pieces: %1</source>
        <translation>, Stücke: %1</translation>
    </message>
    <message>
        <source>Converted exactly; Bezier pieces: %1.</source>
        <translation>Genau umgewandelt; Bézier-Stücke: %1.</translation>
    </message>
    <message>
        <source>Converted within %1; cubic pieces: %2.</source>
        <translation>Auf %1 genau umgewandelt; kubische Stücke: %2.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::DerivationPanel</name>
    <message>
        <source>The vertex nearest to the picked point; type a number to pick another</source>
        <translation>Der dem gewählten Punkt nächste Eckpunkt; eine Zahl wählt einen anderen</translation>
    </message>
    <message>
        <source>The equations that the thesis misprints, as it prints them</source>
        <translation>Die Gleichungen mit Druckfehlern so, wie die Arbeit sie druckt</translation>
    </message>
    <message>
        <source>Matrices and equations</source>
        <translation>Matrizen und Gleichungen</translation>
    </message>
    <message>
        <source>Click a point of the surface, or press P over its picture.</source>
        <translation>Klicken Sie einen Punkt der Fläche an oder drücken Sie P über ihrem Bild.</translation>
    </message>
    <message>
        <source>Curvature is still being estimated.</source>
        <translation>Die Krümmung wird noch geschätzt.</translation>
    </message>
    <message>
        <source>The normal is unknown here.</source>
        <translation>Die Normale ist hier unbekannt.</translation>
    </message>
    <message>
        <source>%1, the other %2</source>
        <translation>%1, der andere %2</translation>
    </message>
    <message>
        <source>feature %1, offset %2, perspective %3</source>
        <translation>Merkmal %1, Versatz %2, Perspektive %3</translation>
    </message>
    <message>
        <source>, as printed</source>
        <translation>, wie gedruckt</translation>
    </message>
    <message>
        <source>There are no principal directions here.</source>
        <translation>Hier gibt es keine Hauptrichtungen.</translation>
    </message>
    <message>
        <source>As printed</source>
        <translation>Wie gedruckt</translation>
    </message>
    <message>
        <source>Vertex</source>
        <translation>Eckpunkt</translation>
    </message>
    <message>
        <source>The line of sight</source>
        <translation>Die Blickrichtung</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>The derivative of curvature</source>
        <translation>Die Ableitung der Krümmung</translation>
    </message>
    <message>
        <source>Foreshortening</source>
        <translation>Verkürzung</translation>
    </message>
    <message>
        <source>The projection</source>
        <translation>Die Projektion</translation>
    </message>
    <message>
        <source>Back from the screen</source>
        <translation>Zurück vom Schirm</translation>
    </message>
    <message>
        <source>Lengths on the screen</source>
        <translation>Längen auf dem Schirm</translation>
    </message>
    <message>
        <source>View-dependent curvature</source>
        <translation>Ansichtsabhängige Krümmung</translation>
    </message>
    <message>
        <source>Where the normal turns most</source>
        <translation>Wo die Normale sich am meisten dreht</translation>
    </message>
    <message>
        <source>The direction of it</source>
        <translation>Die Richtung davon</translation>
    </message>
    <message>
        <source>A direction on the screen</source>
        <translation>Eine Richtung auf dem Schirm</translation>
    </message>
    <message>
        <source>How the normal turns along it</source>
        <translation>Wie die Normale sich dort dreht</translation>
    </message>
    <message>
        <source>What a unit vector cannot change</source>
        <translation>Was ein Einheitsvektor nicht ändern kann</translation>
    </message>
    <message>
        <source>What is left</source>
        <translation>Was bleibt</translation>
    </message>
    <message>
        <source>The derivative of K</source>
        <translation>Die Ableitung von K</translation>
    </message>
    <message>
        <source>The derivative of an inverse</source>
        <translation>Die Ableitung einer Inversen</translation>
    </message>
    <message>
        <source>The derivative of the projection</source>
        <translation>Die Ableitung der Projektion</translation>
    </message>
    <message>
        <source>The derivative of λ</source>
        <translation>Die Ableitung von λ</translation>
    </message>
    <message>
        <source>Feature plus offset</source>
        <translation>Merkmal plus Versatz</translation>
    </message>
    <message>
        <source>Seen from nearby</source>
        <translation>Aus der Nähe gesehen</translation>
    </message>
    <message>
        <source>Both sides of each equation at the vertex, and their difference from the digits shown; lengths in units of the surface&apos;s size</source>
        <translation>Beide Seiten jeder Gleichung am Eckpunkt und ihr Unterschied nach den gezeigten Ziffern; Längen in Einheiten der Größe der Fläche</translation>
    </message>
    <message>
        <source>feature</source>
        <translation>Merkmal</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>0, the viewer is infinitely far away</source>
        <translation>0, der Betrachter ist unendlich weit weg</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>t&lt;sub&gt;A&lt;/sub&gt; has no sign of its own: colours and the reading at the pointer take it towards larger λ, the other way round than here, and the three terms with it.</source>
        <translation>t&lt;sub&gt;A&lt;/sub&gt; hat kein eigenes Vorzeichen: Farben und die Werte am Zeiger nehmen es zu größerem λ hin, hier ist es umgekehrt, und die drei Terme mit ihm.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::DockTitle</name>
    <message>
        <source>Move the panel out of the window</source>
        <translation>Das Bedienfeld aus dem Fenster lösen</translation>
    </message>
    <message>
        <source>Close; the View menu opens it again</source>
        <translation>Schließen; das Menü Ansicht öffnet ihn wieder</translation>
    </message>
</context>
<context>
    <name>flatland::ui::EditController</name>
    <message>
        <source>Nothing is selected. Click a point or press Tab, then Delete.</source>
        <translation>Nichts ist ausgewählt. Klicken Sie auf einen Punkt oder drücken Sie Tab, dann Entf.</translation>
    </message>
    <message>
        <source>The curve has degree %1 already, the highest that can be edited here.</source>
        <translation>Die Kurve hat schon Grad %1, den höchsten, der sich hier bearbeiten lässt.</translation>
    </message>
    <message>
        <source>reset</source>
        <translation>zurücksetzen</translation>
    </message>
</context>
<context>
    <name>flatland::ui::ExportDialog</name>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Choose a file and write the picture</source>
        <translation>Eine Datei wählen und das Bild schreiben</translation>
    </message>
    <message>
        <source>SVG, vector graphics</source>
        <translation>SVG, Vektorgrafik</translation>
    </message>
    <message>
        <source>PDF, vector graphics</source>
        <translation>PDF, Vektorgrafik</translation>
    </message>
    <message>
        <source>PNG, pixels</source>
        <translation>PNG, Pixel</translation>
    </message>
    <message>
        <source>TikZ, for LaTeX</source>
        <translation>TikZ, für LaTeX</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Buchstaben</translation>
    </message>
    <message>
        <source>Name the marks by letters</source>
        <translation>Die Marken mit Buchstaben benennen</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Explain the marks in a legend</source>
        <translation>Die Marken in einer Legende erklären</translation>
    </message>
    <message>
        <source>Control polygon</source>
        <translation>Kontrollpolygon</translation>
    </message>
    <message>
        <source>Show the lines between the control points</source>
        <translation>Die Linien zwischen den Kontrollpunkten zeigen</translation>
    </message>
    <message>
        <source>Hidden parts</source>
        <translation>Verdeckte Teile</translation>
    </message>
    <message>
        <source>Show what the viewer cannot see, paler</source>
        <translation>Blasser zeigen, was der Betrachter nicht sieht</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>Leave out the background</source>
        <translation>Den Hintergrund weglassen</translation>
    </message>
    <message>
        <source>How much larger than usual marks, letters and lines are</source>
        <translation>Wie viel größer als üblich Marken, Buchstaben und Linien sind</translation>
    </message>
    <message>
        <source>&amp;Marks</source>
        <translation>&amp;Marken</translation>
    </message>
</context>
<context>
    <name>flatland::ui::ExportFields</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>SVG and PDF stay sharp at any size; TikZ is for LaTeX</source>
        <translation>SVG und PDF bleiben in jeder Größe scharf; TikZ ist für LaTeX</translation>
    </message>
    <message>
        <source>Unit of width and height; 96 px are one inch</source>
        <translation>Einheit von Breite und Höhe; 96 px sind ein Zoll</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>Breite des Bildes</translation>
    </message>
    <message>
        <source>Height of the picture</source>
        <translation>Höhe des Bildes</translation>
    </message>
    <message>
        <source>Pixels per inch of a PNG file</source>
        <translation>Pixel je Zoll einer PNG-Datei</translation>
    </message>
    <message>
        <source>For which background the colours are</source>
        <translation>Für welchen Hintergrund die Farben sind</translation>
    </message>
    <message>
        <source>For white</source>
        <translation>Für Weiß</translation>
    </message>
    <message>
        <source>For dark grey</source>
        <translation>Für Dunkelgrau</translation>
    </message>
    <message>
        <source>For black</source>
        <translation>Für Schwarz</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>E&amp;inheit</translation>
    </message>
    <message>
        <source>&amp;Dots per inch</source>
        <translation>&amp;Punkte je Zoll</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>F&amp;arben</translation>
    </message>
</context>
<context>
    <name>flatland::ui::FamiliesPanel</name>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Blass</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>Farbe von %1</translation>
    </message>
    <message>
        <source>Lines that the surface hides</source>
        <translation>Linien, die die Fläche verdeckt</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Weggelassen</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Gestrichelt</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Hidden lines</source>
        <translation>Verdeckte Linien</translation>
    </message>
    <message>
        <source>Every crossing, unfiltered</source>
        <translation>Alle Nullstellen, ungefiltert</translation>
    </message>
    <message>
        <source>Also where the equation holds but no line is drawn: minima, weak ones, the far side</source>
        <translation>Auch dort, wo die Gleichung gilt, aber keine Linie gezeichnet wird: Minima, schwache, die Rückseite</translation>
    </message>
    <message>
        <source>How many levels of brightness</source>
        <translation>Wie viele Stufen der Helligkeit</translation>
    </message>
    <message>
        <source>How many levels of height</source>
        <translation>Wie viele Stufen der Höhe</translation>
    </message>
    <message>
        <source>change lines</source>
        <translation>Linien ändern</translation>
    </message>
</context>
<context>
    <name>flatland::ui::FamilyEditor</name>
    <message>
        <source>change parameter</source>
        <translation>Parameter ändern</translation>
    </message>
    <message>
        <source>b/a = %1. The triangle marks b/a = √(3/2) = 1.2247: seen along y, the tip that faces the viewer is an apparent ridge only above it; below, lambda has a minimum there.</source>
        <translation>b/a = %1. Das Dreieck markiert b/a = √(3/2) = 1.2247: Entlang y gesehen ist der Scheitel vor dem Betrachter nur darüber ein scheinbarer Grat; darunter hat λ dort ein Minimum.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::FamilyRow</name>
    <message>
        <source>Draw these lines</source>
        <translation>Diese Linien zeichnen</translation>
    </message>
    <message>
        <source>Smallest angle between the two triangles of an edge</source>
        <translation>Kleinster Winkel zwischen den beiden Dreiecken einer Kante</translation>
    </message>
    <message>
        <source>How strong a line must be; curvatures times the size of the surface, so that the threshold can stay, and stays, for the next mesh</source>
        <translation>Wie stark eine Linie sein muss; Krümmungen mal Größe der Fläche, daher kann und wird die Schwelle für das nächste Netz bleiben</translation>
    </message>
    <message>
        <source>Threshold of %1</source>
        <translation>Schwelle von %1</translation>
    </message>
    <message>
        <source>. Arrow keys and wheel: 2 % up or down</source>
        <translation>. Pfeiltasten und Rad: 2 % mehr oder weniger</translation>
    </message>
    <message>
        <source>Fade %1</source>
        <translation>%1 blasser</translation>
    </message>
    <message>
        <source>Weak lines are paler</source>
        <translation>Schwache Linien sind blasser</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>Farbe von %1</translation>
    </message>
    <message>
        <source>Another colour; the usual one suits the background</source>
        <translation>Eine andere Farbe; die übliche passt zum Hintergrund</translation>
    </message>
    <message>
        <source>Width of %1</source>
        <translation>Breite von %1</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>Breite in Pixeln</translation>
    </message>
</context>
<context>
    <name>flatland::ui::FileController</name>
    <message>
        <source>Flatland scenes (*.json);;All files (*)</source>
        <translation>Flatland-Szenen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation>Szene öffnen</translation>
    </message>
    <message>
        <source>Save scene as</source>
        <translation>Szene speichern unter</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Die Änderungen an %1 speichern?</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>szene</translation>
    </message>
    <message>
        <source>Expected: %1</source>
        <translation>Erwartet: %1</translation>
    </message>
    <message>
        <source>Scenes and drawings (*.json *.svg);;All files (*)</source>
        <translation>Szenen und Zeichnungen (*.json *.svg);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the scene that took the place of %1 (%2)?</source>
        <translation>Die Szene speichern, die an die Stelle von %1 getreten ist (%2)?</translation>
    </message>
    <message>
        <source>It is lost otherwise.</source>
        <translation>Sie geht sonst verloren.</translation>
    </message>
    <message>
        <source>lesson</source>
        <translation>lektion</translation>
    </message>
    <message>
        <source>Save the scene of the lesson as you changed it?</source>
        <translation>Die Szene der Lektion so sichern, wie Sie sie geändert haben?</translation>
    </message>
    <message>
        <source>It is lost otherwise. Your own scene stays as it was.</source>
        <translation>Sonst geht sie verloren. Ihre eigene Szene bleibt, wie sie war.</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <comment>scene, mesh</comment>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>Save this scene?</source>
        <translation>Diese Szene speichern?</translation>
    </message>
    <message>
        <source>Lost otherwise: %1.</source>
        <translation>Sonst verloren: %1.</translation>
    </message>
    <message>
        <source>Only Undo brings back what was taken out of it: %1.</source>
        <translation>Nur Rückgängig bringt zurück, was daraus entfernt wurde: %1.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::FlatCanvas</name>
    <message>
        <source>Canvas</source>
        <translation>Zeichenfläche</translation>
    </message>
</context>
<context>
    <name>flatland::ui::FormulaEditor</name>
    <message>
        <source>&amp;x(t)</source>
        <translation>&amp;x(t)</translation>
    </message>
    <message>
        <source>A formula in t, such as cos(t) * (1 + a*cos(3*t))</source>
        <translation>Eine Formel in t, etwa cos(t) * (1 + a*cos(3*t))</translation>
    </message>
    <message>
        <source>&amp;y(t)</source>
        <translation>&amp;y(t)</translation>
    </message>
    <message>
        <source>A formula in t, such as sin(t)^3</source>
        <translation>Eine Formel in t, etwa sin(t)^3</translation>
    </message>
    <message>
        <source>t &amp;from</source>
        <translation>t &amp;von</translation>
    </message>
    <message>
        <source>Where t begins: a formula without t</source>
        <translation>Wo t beginnt: eine Formel ohne t</translation>
    </message>
    <message>
        <source>t &amp;to</source>
        <translation>t &amp;bis</translation>
    </message>
    <message>
        <source>Where t ends: a formula without t, such as 2*pi</source>
        <translation>Wo t endet: eine Formel ohne t, etwa 2*pi</translation>
    </message>
    <message>
        <source>&amp;with</source>
        <translation>&amp;mit</translation>
    </message>
    <message>
        <source>Named numbers, such as a = 0.3, b = 2</source>
        <translation>Benannte Zahlen, etwa a = 0.3, b = 2</translation>
    </message>
    <message>
        <source>Write a = 0.3, b = 2: names, numbers, commas.</source>
        <translation>Schreiben Sie a = 0.3, b = 2: Namen, Zahlen, Kommas.</translation>
    </message>
    <message>
        <source>type formula</source>
        <translation>Formel eintippen</translation>
    </message>
    <message>
        <source>column %1: %2</source>
        <translation>Spalte %1: %2</translation>
    </message>
</context>
<context>
    <name>flatland::ui::GlCanvas</name>
    <message>
        <source>OpenGL: %1</source>
        <translation>OpenGL: %1</translation>
    </message>
    <message>
        <source>The surface cannot be drawn by OpenGL any more.</source>
        <translation>Die Fläche kann nicht mehr mit OpenGL gezeichnet werden.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::GlyphDialog</name>
    <message>
        <source>Import glyph</source>
        <translation>Glyphe importieren</translation>
    </message>
    <message>
        <source>The font whose letter is taken</source>
        <translation>Die Schrift, aus der der Buchstabe stammt</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>The letter, or its code as U+0061</source>
        <translation>Der Buchstabe oder sein Code wie U+0061</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>Zeichen</translation>
    </message>
    <message>
        <source>Outline of the letter</source>
        <translation>Umriss des Buchstabens</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Add the outline to the scene</source>
        <translation>Den Umriss zur Szene hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Font:</source>
        <translation>&amp;Schrift:</translation>
    </message>
    <message>
        <source>&amp;Character:</source>
        <translation>&amp;Zeichen:</translation>
    </message>
</context>
<context>
    <name>flatland::ui::ImportController</name>
    <message>
        <source>Import drawing</source>
        <translation>Zeichnung importieren</translation>
    </message>
    <message>
        <source>SVG drawings (*.svg);;All files (*)</source>
        <translation>SVG-Zeichnungen (*.svg);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>import glyph</source>
        <translation>Glyphe importieren</translation>
    </message>
</context>
<context>
    <name>flatland::ui::InkRow</name>
    <message>
        <source>&amp;Equal ink</source>
        <translation>&amp;Gleich viel Tinte</translation>
    </message>
    <message>
        <source>In every view one factor on the thresholds is solved for, so that its drawing covers this share of the paper</source>
        <translation>In jeder Ansicht wird ein Faktor auf die Schwellen gelöst, mit dem ihre Zeichnung diesen Anteil des Papiers bedeckt</translation>
    </message>
    <message>
        <source>Ink in per cent</source>
        <translation>Tinte in Prozent</translation>
    </message>
    <message>
        <source>Share of the paper that the strokes of a view cover</source>
        <translation>Anteil des Papiers, den die Striche einer Ansicht bedecken</translation>
    </message>
    <message>
        <source>change ink</source>
        <translation>Tinte ändern</translation>
    </message>
    <message>
        <source>All lines of these families give %1 % only.</source>
        <translation>Alle Linien dieser Familien ergeben nur %1 %.</translation>
    </message>
    <message>
        <source>Lines that have no threshold give %1 % already.</source>
        <translation>Linien ohne Schwelle ergeben schon %1 %.</translation>
    </message>
    <message>
        <source>View %1: %2</source>
        <translation>Ansicht %1: %2</translation>
    </message>
</context>
<context>
    <name>flatland::ui::KeySheet</name>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Move the point, or the whole curve</source>
        <translation>Den Punkt oder die ganze Kurve bewegen</translation>
    </message>
    <message>
        <source>Ctrl + drag</source>
        <translation>Strg + Ziehen</translation>
    </message>
    <message>
        <source>Along one axis</source>
        <translation>Entlang einer Achse</translation>
    </message>
    <message>
        <source>Alt + drag</source>
        <translation>Alt + Ziehen</translation>
    </message>
    <message>
        <source>Leave its handles behind</source>
        <translation>Ohne seine Griffe</translation>
    </message>
    <message>
        <source>Double-click on the curve</source>
        <translation>Doppelklick auf die Kurve</translation>
    </message>
    <message>
        <source>Insert a point, shape kept</source>
        <translation>Einen Punkt einfügen, die Form bleibt</translation>
    </message>
    <message>
        <source>Click, Shift + click</source>
        <translation>Klick, Umschalt + Klick</translation>
    </message>
    <message>
        <source>Select, select more</source>
        <translation>Auswählen, mehr auswählen</translation>
    </message>
    <message>
        <source>Drag on nothing</source>
        <translation>Ziehen im Leeren</translation>
    </message>
    <message>
        <source>Select by rectangle</source>
        <translation>Mit einem Rechteck auswählen</translation>
    </message>
    <message>
        <source>Tab, Shift + Tab</source>
        <translation>Tab, Umschalt + Tab</translation>
    </message>
    <message>
        <source>Next, previous point</source>
        <translation>Nächster, voriger Punkt</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>Move the selected points</source>
        <translation>Die ausgewählten Punkte bewegen</translation>
    </message>
    <message>
        <source>Shift + arrow</source>
        <translation>Umschalt + Pfeil</translation>
    </message>
    <message>
        <source>Ten times as far</source>
        <translation>Zehnmal so weit</translation>
    </message>
    <message>
        <source>Ctrl or Alt + arrow</source>
        <translation>Strg oder Alt + Pfeil</translation>
    </message>
    <message>
        <source>A tenth as far</source>
        <translation>Ein Zehntel so weit</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Viewer</source>
        <translation>Betrachter</translation>
    </message>
    <message>
        <source>Drag the eye</source>
        <translation>Das Auge ziehen</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Die Ansicht drehen</translation>
    </message>
    <message>
        <source>Shift + drag</source>
        <translation>Umschalt + Ziehen</translation>
    </message>
    <message>
        <source>In steps of 15°</source>
        <translation>In Schritten von 15°</translation>
    </message>
    <message>
        <source>Keep the distance (perspective)</source>
        <translation>Den Abstand halten (Perspektive)</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Am Mauszeiger zoomen</translation>
    </message>
    <message>
        <source>Middle button, Space + drag</source>
        <translation>Mittlere Taste, Leertaste + Ziehen</translation>
    </message>
    <message>
        <source>Move the picture</source>
        <translation>Das Bild bewegen</translation>
    </message>
    <message>
        <source>Two fingers on a trackpad</source>
        <translation>Zwei Finger auf dem Trackpad</translation>
    </message>
    <message>
        <source>Keys and gestures</source>
        <translation>Tasten und Gesten</translation>
    </message>
    <message>
        <source>Wheel, pinch, Ctrl + wheel</source>
        <translation>Mausrad, Spreizen, Strg + Mausrad</translation>
    </message>
    <message>
        <source>H, ? and Esc close this sheet</source>
        <translation>H, ? und Esc schließen dieses Blatt</translation>
    </message>
    <message>
        <source>Take back a drag; deselect; no probe; leave projector</source>
        <translation>Ziehen zurücknehmen; Auswahl aufheben; Sonde weg; Projektor beenden</translation>
    </message>
    <message>
        <source>Probe and plots</source>
        <translation>Sonde und Verläufe</translation>
    </message>
    <message>
        <source>Click on the curve</source>
        <translation>Klick auf die Kurve</translation>
    </message>
    <message>
        <source>Put the probe there</source>
        <translation>Die Sonde dorthin setzen</translation>
    </message>
    <message>
        <source>Drag the ring</source>
        <translation>Den Ring ziehen</translation>
    </message>
    <message>
        <source>Slide it along the curve</source>
        <translation>Sie die Kurve entlang schieben</translation>
    </message>
    <message>
        <source>+ − 0 in a plot</source>
        <translation>+ − 0 in einem Verlauf</translation>
    </message>
    <message>
        <source>Zoom, show all</source>
        <translation>Zoomen, alles zeigen</translation>
    </message>
    <message>
        <source>Sweep panel</source>
        <translation>Rundblick</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Links, Rechts</translation>
    </message>
    <message>
        <source>Turn the view by 1°</source>
        <translation>Die Ansicht um 1° drehen</translation>
    </message>
    <message>
        <source>Shift, Ctrl + the same</source>
        <translation>Umschalt, Strg + dieselben</translation>
    </message>
    <message>
        <source>By 0.1°, to the next event</source>
        <translation>Um 0.1°, zum nächsten Ereignis</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Turn once around; Esc goes back</source>
        <translation>Einmal herumdrehen; Esc kehrt zurück</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Drag, Ctrl + drag</source>
        <translation>Ziehen, Strg + Ziehen</translation>
    </message>
    <message>
        <source>Turn, roll</source>
        <translation>Drehen, rollen</translation>
    </message>
    <message>
        <source>Shift + drag, middle button</source>
        <translation>Umschalt + Ziehen, mittlere Taste</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>1 3 7, 9</source>
        <translation>1 3 7, 9</translation>
    </message>
    <message>
        <source>Front, right, top; opposite side</source>
        <translation>Vorn, rechts, oben; Gegenseite</translation>
    </message>
    <message>
        <source>5, F, R, Space</source>
        <translation>5, F, R, Leertaste</translation>
    </message>
    <message>
        <source>Perspective, fit, reset, spin</source>
        <translation>Perspektive, einpassen, zurücksetzen, kreiseln</translation>
    </message>
    <message>
        <source>Click; P</source>
        <translation>Klick; P</translation>
    </message>
    <message>
        <source>Pick the point there, in the middle</source>
        <translation>Den Punkt dort, in der Mitte wählen</translation>
    </message>
    <message>
        <source>[ ], C</source>
        <translation>[ ], C</translation>
    </message>
    <message>
        <source>Move the plane; arrow keys turn it</source>
        <translation>Ebene verschieben; Pfeile drehen sie</translation>
    </message>
</context>
<context>
    <name>flatland::ui::Layouts</name>
    <message>
        <source>Back to the window as it was (Esc or F11)</source>
        <translation>Zurück zum Fenster, wie es war (Esc oder F11)</translation>
    </message>
    <message>
        <source>Esc: leave</source>
        <translation>Esc: verlassen</translation>
    </message>
</context>
<context>
    <name>flatland::ui::LegendPanel</name>
    <message>
        <source>Hidden parts, paler</source>
        <translation>Verdeckte Teile, blasser</translation>
    </message>
    <message>
        <source>Show what lies behind the curve as seen from the viewer</source>
        <translation>Zeigen, was vom Betrachter aus hinter der Kurve liegt</translation>
    </message>
</context>
<context>
    <name>flatland::ui::LessonController</name>
    <message>
        <source>Lesson: %1</source>
        <translation>Lektion: %1</translation>
    </message>
</context>
<context>
    <name>flatland::ui::LessonFiles</name>
    <message>
        <source>Open lesson</source>
        <translation>Lektion öffnen</translation>
    </message>
    <message>
        <source>Lessons (*.md);;All files (*)</source>
        <translation>Lektionen (*.md);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>flatland::ui::LessonModel</name>
    <message>
        <source>leave lesson</source>
        <translation>Lektion verlassen</translation>
    </message>
    <message>
        <source>lesson: %1</source>
        <translation>Lektion: %1</translation>
    </message>
</context>
<context>
    <name>flatland::ui::LessonPanel</name>
    <message>
        <source>Words of the step</source>
        <translation>Worte des Schritts</translation>
    </message>
    <message>
        <source>First step (Home)</source>
        <translation>Erster Schritt (Pos1)</translation>
    </message>
    <message>
        <source>Step back (Page Up)</source>
        <translation>Schritt zurück (Bild auf)</translation>
    </message>
    <message>
        <source>Next step (Page Down)</source>
        <translation>Nächster Schritt (Bild ab)</translation>
    </message>
    <message>
        <source>On to the next stop (Shift + Page Down)</source>
        <translation>Weiter zum nächsten Halt (Umschalt + Bild ab)</translation>
    </message>
    <message>
        <source>The scene of this step again</source>
        <translation>Die Szene dieses Schritts noch einmal</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Leave the lesson: back to your own scene</source>
        <translation>Die Lektion verlassen: zurück zur eigenen Szene</translation>
    </message>
    <message>
        <source>As printed</source>
        <translation>Wie gedruckt</translation>
    </message>
    <message>
        <source>The equation as the thesis has it</source>
        <translation>Die Gleichung, wie die Arbeit sie hat</translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation>Berichtigt</translation>
    </message>
    <message>
        <source>The equation as it should be</source>
        <translation>Die Gleichung, wie sie sein sollte</translation>
    </message>
    <message>
        <source>Printed roots on the curve</source>
        <translation>Gedruckte Nullstellen auf der Kurve</translation>
    </message>
    <message>
        <source>Where (3.13) as printed would put apparent ridges: hollow and dashed</source>
        <translation>Wohin (3.13), wie gedruckt, scheinbare Grate setzte: hohl und gestrichelt</translation>
    </message>
    <message>
        <source> · stop</source>
        <translation> · Halt</translation>
    </message>
    <message>
        <source>No lesson is open</source>
        <translation>Keine Lektion ist offen</translation>
    </message>
    <message>
        <source>What the step says</source>
        <translation>Was der Schritt sagt</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>How far the printed roots miss</source>
        <translation>Wie weit die gedruckten Nullstellen danebenliegen</translation>
    </message>
    <message>
        <source> · undone: your own scene</source>
        <translation> · zurückgenommen: Ihre eigene Szene</translation>
    </message>
    <message>
        <source>The **Lesson** menu has four, and opens your own.</source>
        <translation>Das Menü **Lektion** hat vier und öffnet eigene.</translation>
    </message>
    <message>
        <source>The values of both sides at the probe, and their difference from the digits shown</source>
        <translation>Die Werte beider Seiten an der Sonde und ihr Unterschied nach den gezeigten Ziffern</translation>
    </message>
    <message>
        <source>&lt;b&gt;Step %1 of %2&lt;/b&gt;%3</source>
        <translation>&lt;b&gt;Schritt %1 von %2&lt;/b&gt;%3</translation>
    </message>
</context>
<context>
    <name>flatland::ui::LimitsPanel</name>
    <message>
        <source>Turn the view</source>
        <translation>Ansicht drehen</translation>
    </message>
    <message>
        <source>Walk along the curve</source>
        <translation>Die Kurve entlanggehen</translation>
    </message>
    <message>
        <source>A ridge slides in</source>
        <translation>Ein Grat gleitet hinein</translation>
    </message>
    <message>
        <source>Three ways to a silhouette: turn the view at the probe; walk from the probe to the nearest silhouette; turn the view until an apparent ridge meets a silhouette at an inflection</source>
        <translation>Drei Wege zu einer Silhouette: die Ansicht an der Sonde drehen; von der Sonde zur nächsten Silhouette gehen; die Ansicht drehen, bis ein scheinbarer Grat an einem Wendepunkt auf eine Silhouette trifft</translation>
    </message>
    <message>
        <source>Way to the silhouette</source>
        <translation>Weg zur Silhouette</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>Was gezeichnet wird</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Write the diagram as a picture, or all values as CSV</source>
        <translation>Das Diagramm als Bild oder alle Werte als CSV schreiben</translation>
    </message>
    <message>
        <source>n·w at the probe, from 1 (seen head-on) to 0 (silhouette): turns the view</source>
        <translation>n·w an der Sonde, von 1 (frontal gesehen) bis 0 (Silhouette): dreht die Ansicht</translation>
    </message>
    <message>
        <source>Foreshortening n·w</source>
        <translation>Verkürzung n·w</translation>
    </message>
    <message>
        <source>n·w</source>
        <translation>n·w</translation>
    </message>
    <message>
        <source>&amp;n·w</source>
        <translation>&amp;n·w</translation>
    </message>
    <message>
        <source>This curve has no inflection into which an apparent ridge could slide.</source>
        <translation>Diese Kurve hat keinen Wendepunkt, in den ein scheinbarer Grat gleiten könnte.</translation>
    </message>
    <message>
        <source>This curve has no silhouette to go to in this view.</source>
        <translation>Diese Kurve hat in dieser Ansicht keine Silhouette, zu der man gehen könnte.</translation>
    </message>
    <message>
        <source>n·w = 0: the silhouette; λ has no value here</source>
        <translation>n·w = 0: die Silhouette; λ hat hier keinen Wert</translation>
    </message>
    <message>
        <source>n·w = %1   λ = %2   |feature| %3   |offset| %4</source>
        <translation>n·w = %1   λ = %2   |Merkmal| %3   |Versatz| %4</translation>
    </message>
    <message>
        <source>These limits are those of a viewer infinitely far away; switch perspective off to turn the view by n·w.</source>
        <translation>Diese Grenzfälle gelten für einen unendlich fernen Betrachter; schalten Sie die Perspektive aus, um die Ansicht über n·w zu drehen.</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>grenzfaelle</translation>
    </message>
</context>
<context>
    <name>flatland::ui::LimitsView</name>
    <message>
        <source>Power law at the silhouette</source>
        <translation>Potenzgesetz an der Silhouette</translation>
    </message>
    <message>
        <source>Points: measured. Solid: fitted to the last decade. Dashed: predicted</source>
        <translation>Punkte: gemessen. Durchgezogen: an die letzte Dekade angepasst. Gestrichelt: vorhergesagt</translation>
    </message>
</context>
<context>
    <name>flatland::ui::MainWindow</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The language changes when the window is opened the next time.</source>
        <translation>Die Sprache wechselt, wenn das Fenster das nächste Mal geöffnet wird.</translation>
    </message>
    <message>
        <source>%1[*] – Flatland</source>
        <translation>%1[*] – Flatland</translation>
    </message>
    <message>
        <source>About Flatland</source>
        <translation>Über Flatland</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Flatland %1&lt;/h3&gt;&lt;p&gt;View-dependent curvature and apparent ridges of plane curves, seen on a one-dimensional screen.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Flatland %1&lt;/h3&gt;&lt;p&gt;Blickabhängige Krümmung und scheinbare Grate ebener Kurven, gesehen auf einem eindimensionalen Schirm.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder später.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>bild</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1-Dateien (*.%2)</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exportiert nach %1</translation>
    </message>
</context>
<context>
    <name>flatland::ui::MarksModel</name>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>What kind of mark it is</source>
        <translation>Welcher Art die Marke ist</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Number of the curve, from 0</source>
        <translation>Nummer der Kurve, ab 0</translation>
    </message>
    <message>
        <source>t</source>
        <translation>t</translation>
    </message>
    <message>
        <source>Parameter on the curve: piece number plus place in the piece</source>
        <translation>Parameter auf der Kurve: Nummer des Stücks plus Ort im Stück</translation>
    </message>
    <message>
        <source>u</source>
        <translation>u</translation>
    </message>
    <message>
        <source>Arc length from the start of the curve</source>
        <translation>Bogenlänge vom Anfang der Kurve</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Schirm</translation>
    </message>
    <message>
        <source>Coordinate on the screen</source>
        <translation>Koordinate auf dem Schirm</translation>
    </message>
    <message>
        <source>View-dependent curvature squared; none at a silhouette</source>
        <translation>Quadrat der blickabhängigen Krümmung; keines an einer Silhouette</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>Merkmal</translation>
    </message>
    <message>
        <source>Feature term of the apparent-ridge equation, (n·w) k k&apos;</source>
        <translation>Merkmalsterm der Gleichung des scheinbaren Grats, (n·w) k k&apos;</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Offset term of the apparent-ridge equation, −k³ (t·w)</source>
        <translation>Versatzterm der Gleichung des scheinbaren Grats, −k³ (t·w)</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>Term added by the perspective view; zero in an orthographic one</source>
        <translation>Zusatzterm der perspektivischen Ansicht; null in einer orthografischen</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residuum</translation>
    </message>
    <message>
        <source>How far the mark&apos;s equation is from zero there, without dimension</source>
        <translation>Wie weit die Gleichung der Marke dort von null entfernt ist, ohne Dimension</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Whether nothing lies between the mark and the viewer</source>
        <translation>Ob nichts zwischen Marke und Betrachter liegt</translation>
    </message>
</context>
<context>
    <name>flatland::ui::MarksPanel</name>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Select a row to highlight the mark; Enter or a double-click centres it.</source>
        <translation>Eine Zeile auswählen hebt die Marke hervor; Eingabe oder Doppelklick rückt sie in die Mitte.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>What went wrong; the text can be selected</source>
        <translation>Was schiefging; der Text lässt sich auswählen</translation>
    </message>
</context>
<context>
    <name>flatland::ui::PaneWidget</name>
    <message>
        <source>Picture of the surface</source>
        <translation>Bild der Fläche</translation>
    </message>
    <message>
        <source>Picture of the surface, view %1</source>
        <translation>Bild der Fläche, Ansicht %1</translation>
    </message>
    <message>
        <source>View %1: %2</source>
        <translation>Ansicht %1: %2</translation>
    </message>
    <message>
        <source>%1. A click changes what this view shows</source>
        <translation>%1. Ein Klick ändert, was diese Ansicht zeigt</translation>
    </message>
</context>
<context>
    <name>flatland::ui::PlaneInput</name>
    <message>
        <source>Moving the plane; Esc takes it back</source>
        <translation>Bewegt die Ebene; Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>The arrow keys turn the plane; [ and ] move it</source>
        <translation>Die Pfeiltasten drehen die Ebene; [ und ] verschieben sie</translation>
    </message>
    <message>
        <source>The arrow keys turn the surface</source>
        <translation>Die Pfeiltasten drehen die Fläche</translation>
    </message>
    <message>
        <source>move plane</source>
        <translation>Ebene bewegen</translation>
    </message>
</context>
<context>
    <name>flatland::ui::PlotExportDialog</name>
    <message>
        <source>Export plot: %1</source>
        <translation>Verlauf exportieren: %1</translation>
    </message>
    <message>
        <source>SVG and PDF stay sharp at any size; CSV is for a spreadsheet</source>
        <translation>SVG und PDF bleiben in jeder Größe scharf; CSV ist für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>SVG, vector graphics</source>
        <translation>SVG, Vektorgrafik</translation>
    </message>
    <message>
        <source>PDF, vector graphics</source>
        <translation>PDF, Vektorgrafik</translation>
    </message>
    <message>
        <source>PNG, pixels</source>
        <translation>PNG, Pixel</translation>
    </message>
    <message>
        <source>CSV, the numbers</source>
        <translation>CSV, die Zahlen</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>Breite des Bildes</translation>
    </message>
    <message>
        <source>Height of the picture</source>
        <translation>Höhe des Bildes</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Pixels per inch of a PNG file</source>
        <translation>Pixel je Zoll einer PNG-Datei</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Choose a file and write the plot</source>
        <translation>Eine Datei wählen und den Verlauf schreiben</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>&amp;Dots per inch</source>
        <translation>&amp;Punkte je Zoll</translation>
    </message>
</context>
<context>
    <name>flatland::ui::PlotExporter</name>
    <message>
        <source>Copied the plot as a picture.</source>
        <translation>Verlauf als Bild kopiert.</translation>
    </message>
    <message>
        <source>Copied the numbers of the plot as CSV.</source>
        <translation>Zahlen des Verlaufs als CSV kopiert.</translation>
    </message>
    <message>
        <source>Export plot</source>
        <translation>Verlauf exportieren</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1-Dateien (*.%2)</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exportiert nach %1</translation>
    </message>
</context>
<context>
    <name>flatland::ui::PlotsPanel</name>
    <message>
        <source>against arc length</source>
        <translation>über der Bogenlänge</translation>
    </message>
    <message>
        <source>against screen</source>
        <translation>über dem Schirm</translation>
    </message>
    <message>
        <source>What the plots are drawn against: length along the curve, or place on the screen</source>
        <translation>Worüber die Verläufe gezeichnet sind: Länge auf der Kurve oder Ort auf dem Schirm</translation>
    </message>
    <message>
        <source>Drawn against</source>
        <translation>Gezeichnet über</translation>
    </message>
    <message>
        <source>The curve that is plotted: that of the probe</source>
        <translation>Die Kurve, deren Verläufe gezeichnet sind: die der Sonde</translation>
    </message>
    <message>
        <source>Plotted curve</source>
        <translation>Gezeichnete Kurve</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Show the whole curve (0, or a double-click on a plot)</source>
        <translation>Die ganze Kurve zeigen (0 oder Doppelklick auf einen Verlauf)</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Verläufe</translation>
    </message>
    <message>
        <source>Which plots are shown, and how to copy or export them</source>
        <translation>Welche Verläufe gezeigt werden, und wie man sie kopiert oder exportiert</translation>
    </message>
    <message>
        <source>Export %1…</source>
        <translation>%1 exportieren …</translation>
    </message>
    <message>
        <source>Write the plot as SVG, PDF, PNG or CSV</source>
        <translation>Den Verlauf als SVG, PDF, PNG oder CSV schreiben</translation>
    </message>
    <message>
        <source>Curve %1</source>
        <translation>Kurve %1</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>&amp;Bild kopieren</translation>
    </message>
    <message>
        <source>Copy the plot to the clipboard</source>
        <translation>Den Verlauf in die Zwischenablage kopieren</translation>
    </message>
    <message>
        <source>Copy &amp;Numbers</source>
        <translation>&amp;Zahlen kopieren</translation>
    </message>
    <message>
        <source>Copy what is plotted as CSV</source>
        <translation>Das Gezeichnete als CSV kopieren</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Show &amp;All</source>
        <translation>&amp;Alles zeigen</translation>
    </message>
    <message>
        <source>Show the whole curve</source>
        <translation>Die ganze Kurve zeigen</translation>
    </message>
    <message>
        <source>&amp;Hide This Plot</source>
        <translation>Diesen &amp;Verlauf verbergen</translation>
    </message>
    <message>
        <source>The button Plots brings it back</source>
        <translation>Der Knopf Verläufe bringt ihn zurück</translation>
    </message>
</context>
<context>
    <name>flatland::ui::PointsModel</name>
    <message>
        <source>The curve passes through this point.</source>
        <translation>Die Kurve geht durch diesen Punkt.</translation>
    </message>
    <message>
        <source>This point pulls the curve towards itself.</source>
        <translation>Dieser Punkt zieht die Kurve zu sich hin.</translation>
    </message>
    <message>
        <source>“%1” is not a number; the coordinate stays.</source>
        <translation>„%1“ ist keine Zahl; die Koordinate bleibt.</translation>
    </message>
    <message>
        <source>Coordinates lie within %1; the coordinate stays.</source>
        <translation>Koordinaten liegen innerhalb von %1; die Koordinate bleibt.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
</context>
<context>
    <name>flatland::ui::PointsPanel</name>
    <message>
        <source>Coordinate</source>
        <translation>Koordinate</translation>
    </message>
    <message>
        <source>Control points</source>
        <translation>Kontrollpunkte</translation>
    </message>
    <message>
        <source>Double-click a coordinate, or press F2, to type it.</source>
        <translation>Doppelklick auf eine Koordinate, oder F2, um sie einzutippen.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::ProbePanel</name>
    <message>
        <source>t</source>
        <translation>t</translation>
    </message>
    <message>
        <source>Parameter on the curve: piece number plus place in the piece</source>
        <translation>Parameter auf der Kurve: Nummer des Stücks plus Ort im Stück</translation>
    </message>
    <message>
        <source>u</source>
        <translation>u</translation>
    </message>
    <message>
        <source>Arc length from the start of the curve (length)</source>
        <translation>Bogenlänge vom Anfang der Kurve (Länge)</translation>
    </message>
    <message>
        <source>Type a value and press Enter.</source>
        <translation>Tippen Sie einen Wert und drücken Sie Eingabe.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Place in the plane (length)</source>
        <translation>Ort in der Ebene (Länge)</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>Unit normal</source>
        <translation>Einheitsnormale</translation>
    </message>
    <message>
        <source>Tangent</source>
        <translation>Tangente</translation>
    </message>
    <message>
        <source>Unit tangent, towards larger t</source>
        <translation>Einheitstangente, zu größerem t hin</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>Curvature, dn/du = k t: positive where the curve bulges to the side of n (1/length)</source>
        <translation>Krümmung, dn/du = k t: positiv, wo sich die Kurve zur Seite von n wölbt (1/Länge)</translation>
    </message>
    <message>
        <source>k&apos;</source>
        <translation>k&apos;</translation>
    </message>
    <message>
        <source>Derivative of k by arc length (1/length²)</source>
        <translation>Ableitung von k nach der Bogenlänge (1/Länge²)</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius of the osculating circle, 1/|k| (length)</source>
        <translation>Radius des Schmiegekreises, 1/|k| (Länge)</translation>
    </message>
    <message>
        <source>The curve is straight here: no finite radius.</source>
        <translation>Die Kurve ist hier gerade: kein endlicher Radius.</translation>
    </message>
    <message>
        <source>Infinite: the probe is at a silhouette.</source>
        <translation>Unendlich: Die Sonde ist an einer Silhouette.</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Schirm</translation>
    </message>
    <message>
        <source>Coordinate on the screen (length)</source>
        <translation>Koordinate auf dem Schirm (Länge)</translation>
    </message>
    <message>
        <source>At or behind the viewer: no image.</source>
        <translation>Am Betrachter oder hinter ihm: kein Bild.</translation>
    </message>
    <message>
        <source>n·w</source>
        <translation>n·w</translation>
    </message>
    <message>
        <source>Foreshortening; 0 at a silhouette</source>
        <translation>Verkürzung; 0 an einer Silhouette</translation>
    </message>
    <message>
        <source>View-dependent curvature squared, k²/(n·w)² (1/length²)</source>
        <translation>Quadrat der blickabhängigen Krümmung, k²/(n·w)² (1/Länge²)</translation>
    </message>
    <message>
        <source>dn/di</source>
        <translation>dn/di</translation>
    </message>
    <message>
        <source>Turn of the normal for a step on the screen, along the screen: k/|n·w| (1/length)</source>
        <translation>Drehung der Normale für einen Schritt auf dem Schirm, entlang des Schirms: k/|n·w| (1/Länge)</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>Merkmal</translation>
    </message>
    <message>
        <source>Feature term, (n·w) k k&apos; (1/length³)</source>
        <translation>Merkmalsterm, (n·w) k k&apos; (1/Länge³)</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Offset term, −k³ (t·w) (1/length³)</source>
        <translation>Versatzterm, −k³ (t·w) (1/Länge³)</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>Term added by the perspective view (1/length³)</source>
        <translation>Zusatzterm der perspektivischen Ansicht (1/Länge³)</translation>
    </message>
    <message>
        <source>0: the viewer is infinitely far away.</source>
        <translation>0: Der Betrachter ist unendlich fern.</translation>
    </message>
    <message>
        <source>Sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>Sum of the terms, (n·w)³/2 dλ/du; 0 at an apparent ridge (1/length³)</source>
        <translation>Summe der Terme, (n·w)³/2 dλ/du; 0 an einem scheinbaren Grat (1/Länge³)</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>Size of the offset term against the feature term, without unit</source>
        <translation>Größe des Versatzterms gegen den Merkmalsterm, ohne Einheit</translation>
    </message>
    <message>
        <source>The feature term is 0 here.</source>
        <translation>Der Merkmalsterm ist hier 0.</translation>
    </message>
    <message>
        <source>At a cusp the curve has no tangent.</source>
        <translation>An einer Spitze hat die Kurve keine Tangente.</translation>
    </message>
    <message>
        <source>No probe: click on the curve, or press K.</source>
        <translation>Keine Sonde: Klicken Sie auf die Kurve oder drücken Sie K.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::ProfilePlot</name>
    <message>
        <source>The values at the probe</source>
        <translation>Die Werte an der Sonde</translation>
    </message>
    <message>
        <source>Click or drag: probe. Wheel: zoom. Middle button or Space: move. Double-click: show all. Right button: copy, export.</source>
        <translation>Klick oder Ziehen: Sonde. Mausrad: zoomen. Mittlere Taste oder Leertaste: bewegen. Doppelklick: alles zeigen. Rechte Taste: kopieren, exportieren.</translation>
    </message>
    <message>
        <source>%1, asinh</source>
        <translation>%1, asinh</translation>
    </message>
</context>
<context>
    <name>flatland::ui::SectionPanel</name>
    <message>
        <source>&amp;Open section as curve</source>
        <translation>Schnitt als Kurve ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Ridges of the surface beside those of the section</source>
        <translation>Grate der Fläche neben denen des Schnitts</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>t_A off plane</source>
        <translation>t_A zur Ebene</translation>
    </message>
    <message>
        <source>Through the &amp;view</source>
        <translation>Durch den &amp;Blick</translation>
    </message>
    <message>
        <source>A plane that holds the line of sight, through the picked point or the middle of the picture</source>
        <translation>Eine Ebene, die den Blickstrahl enthält, durch den gewählten Punkt oder die Bildmitte</translation>
    </message>
    <message>
        <source>Along &amp;t_A</source>
        <translation>Entlang &amp;t_A</translation>
    </message>
    <message>
        <source>A plane that holds the line of sight and t_A at the picked point (click on the surface): there flatland&apos;s equation is the surface&apos;s</source>
        <translation>Eine Ebene, die den Blickstrahl und t_A am gewählten Punkt enthält (auf die Fläche klicken): dort ist Flatlands Gleichung die der Fläche</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>En&amp;tfernen</translation>
    </message>
    <message>
        <source>Take the plane away</source>
        <translation>Die Ebene wegnehmen</translation>
    </message>
    <message>
        <source>A&amp;zimuth</source>
        <translation>A&amp;zimut</translation>
    </message>
    <message>
        <source>Direction of the normal around the upright axis</source>
        <translation>Richtung der Normalen um die aufrechte Achse</translation>
    </message>
    <message>
        <source>E&amp;levation</source>
        <translation>E&amp;rhebung</translation>
    </message>
    <message>
        <source>How far the normal points upward</source>
        <translation>Wie weit die Normale nach oben zeigt</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>A&amp;bstand</translation>
    </message>
    <message>
        <source>How far from the middle of the surface, along the normal; the surface&apos;s longest side is 2</source>
        <translation>Wie weit von der Mitte der Fläche, entlang der Normalen; die längste Seite der Fläche ist 2</translation>
    </message>
    <message>
        <source>To&amp;lerance</source>
        <translation>To&amp;leranz</translation>
    </message>
    <message>
        <source>There is no surface to cut.</source>
        <translation>Es gibt keine Fläche zum Schneiden.</translation>
    </message>
    <message>
        <source>cut along the view</source>
        <translation>entlang des Blicks schneiden</translation>
    </message>
    <message>
        <source>Click on the surface first: t_A is that of a point.</source>
        <translation>Klicke zuerst auf die Fläche: t_A gehört zu einem Punkt.</translation>
    </message>
    <message>
        <source>There is no t_A at this point.</source>
        <translation>An diesem Punkt gibt es kein t_A.</translation>
    </message>
    <message>
        <source>cut along t_A</source>
        <translation>entlang t_A schneiden</translation>
    </message>
    <message>
        <source>remove plane</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>move plane</source>
        <translation>Ebene bewegen</translation>
    </message>
    <message>
        <source>Put the section in the place of the scene&apos;s curves, seen as it is now</source>
        <translation>Den Schnitt an die Stelle der Kurven der Szene setzen, gesehen wie jetzt</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>t = %1</source>
        <translation>t = %1</translation>
    </message>
    <message>
        <source>%1: t = %2</source>
        <translation>%1: t = %2</translation>
    </message>
    <message>
        <source>How far the curve may be from the section, in thousandths of the surface&apos;s longest side. Automatic: 1, and at least a tenth of an edge, so that the curve does not follow the facets</source>
        <translation>Wie weit die Kurve vom Schnitt entfernt sein darf, in Tausendsteln der längsten Seite der Fläche. Automatisch: 1, und mindestens eine Zehntelkante, damit die Kurve nicht den Facetten folgt</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>The section</source>
        <translation>Der Schnitt</translation>
    </message>
    <message>
        <source>Why the pair differs</source>
        <translation>Warum das Paar sich unterscheidet</translation>
    </message>
    <message>
        <source>. The swept surface goes with its curve; undo brings both back</source>
        <translation>. Die Fläche, die aus der Kurve entstand, geht mit ihr; Rückgängig bringt beide zurück</translation>
    </message>
    <message>
        <source>What the table leaves out</source>
        <translation>Was die Tabelle weglässt</translation>
    </message>
    <message numerus="yes">
        <source>%n weaker than the view&apos;s threshold left out</source>
        <translation>
            <numerusform>%n schwächere als die Schwelle der Ansicht weggelassen</numerusform>
            <numerusform>%n schwächere als die Schwelle der Ansicht weggelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>Apparent ridges of the surface that go through the plane, each with the nearest apparent ridge of the section, and the angle between t_A and the plane. The row that is selected is ringed in both pictures</source>
        <translation>Scheinbare Grate der Fläche, die durch die Ebene gehen, jeder mit dem nächsten scheinbaren Grat des Schnitts und dem Winkel zwischen t_A und der Ebene. Die gewählte Zeile ist in beiden Bildern umringt</translation>
    </message>
    <message>
        <source>No plane yet. A button above puts one through the surface; its round handles turn it, the square moves it.</source>
        <translation>Noch keine Ebene. Ein Knopf oben legt eine durch die Fläche; die runden Griffe drehen sie, das Quadrat verschiebt sie.</translation>
    </message>
    <message>
        <source>The surface is being cut.</source>
        <translation>Die Fläche wird geschnitten.</translation>
    </message>
    <message>
        <source>The surface could not be cut here.</source>
        <translation>Die Fläche ließ sich hier nicht schneiden.</translation>
    </message>
    <message>
        <source>Select a row: here it says why the pair differs.</source>
        <translation>Eine Zeile wählen: Hier steht, warum das Paar sich unterscheidet.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::StatusLine</name>
    <message>
        <source>Where the pointer is</source>
        <translation>Wo der Mauszeiger ist</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>Direction, and in perspective distance, of the viewer</source>
        <translation>Richtung und, in der Perspektive, Abstand des Betrachters</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Time of the last search for marks</source>
        <translation>Zeit der letzten Suche nach Marken</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>View %1, %2</source>
        <translation>Ansicht %1, %2</translation>
    </message>
    <message numerus="yes">
        <source>all %n marks certified</source>
        <translation>
            <numerusform>die %n Marke bewiesen</numerusform>
            <numerusform>alle %n Marken bewiesen</numerusform>
        </translation>
    </message>
    <message>
        <source>Ridges and valleys exchange names: the viewer has passed the line through the ends of the curve and sees its other side.</source>
        <translation>Grate und Täler tauschen die Namen: Der Betrachter hat die Linie durch die Enden der Kurve überschritten und sieht ihre andere Seite.</translation>
    </message>
    <message numerus="yes">
        <source>%n places unresolved</source>
        <translation>
            <numerusform>%n Stelle unentschieden</numerusform>
            <numerusform>%n Stellen unentschieden</numerusform>
        </translation>
    </message>
    <message>
        <source>Every mark was found and none is invented: nothing is left open.</source>
        <translation>Jede Marke ist gefunden und keine erfunden: Nichts ist offen.</translation>
    </message>
    <message>
        <source>Nothing is left open, to an estimated error of %1; what is narrower than the samples may be missed.</source>
        <translation>Nichts ist offen, bis auf einen geschätzten Fehler von %1; was schmaler ist als die Stützstellen, kann fehlen.</translation>
    </message>
    <message>
        <source>%1, curve %2, t from %3 to %4: %5</source>
        <translation>%1, Kurve %2, t von %3 bis %4: %5</translation>
    </message>
    <message>
        <source>Bring the place to the middle of the canvas</source>
        <translation>Die Stelle in die Mitte der Zeichenfläche rücken</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Whether every mark was found and none invented, with certified signs, or on a curve of formulas within an error. A click lists the places where that could not be decided.</source>
        <translation>Ob jede Marke gefunden und keine erfunden wurde, mit bewiesenen Vorzeichen oder, auf einer Kurve aus Formeln, bis auf einen Fehler. Ein Klick listet die Stellen auf, an denen sich das nicht entscheiden ließ.</translation>
    </message>
    <message numerus="yes">
        <source>all %n marks found to %1</source>
        <translation>
            <numerusform>die %n Marke gefunden bis auf %1</numerusform>
            <numerusform>alle %n Marken gefunden bis auf %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>flatland::ui::StepSizePlot</name>
    <message>
        <source>Difference quotients against their step size</source>
        <translation>Differenzenquotienten über ihrer Schrittweite</translation>
    </message>
    <message>
        <source>step h</source>
        <translation>Schritt h</translation>
    </message>
    <message>
        <source>off by</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>How far difference quotients are from the right side.
h: %1.
Filled: corrected. Hollow, dashed: as printed.
Large steps: truncation, slope 2. Small steps: rounding, slope −1.</source>
        <translation>Wie weit Differenzenquotienten von der rechten Seite sind.
h: %1.
Gefüllt: berichtigt. Hohl, gestrichelt: wie gedruckt.
Große Schritte: Abbruch, Steigung 2. Kleine Schritte: Rundung, Steigung −1.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::StudyPanel</name>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>arc length</source>
        <translation>Bogenlänge</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>unnormalised</source>
        <translation>nicht normiert</translation>
    </message>
    <message>
        <source>&amp;Curves</source>
        <translation>&amp;Kurven</translation>
    </message>
    <message>
        <source>How many random curves</source>
        <translation>Wie viele zufällige Kurven</translation>
    </message>
    <message>
        <source>Po&amp;ints</source>
        <translation>P&amp;unkte</translation>
    </message>
    <message>
        <source>Control points of each curve, 3 to 9</source>
        <translation>Kontrollpunkte jeder Kurve, 3 bis 9</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>S&amp;aat</translation>
    </message>
    <message>
        <source>Which random curves: the same seed, the same curves</source>
        <translation>Welche zufälligen Kurven: gleiche Saat, gleiche Kurven</translation>
    </message>
    <message>
        <source>U&amp;nits</source>
        <translation>Ei&amp;nheiten</translation>
    </message>
    <message>
        <source>arc length: as derived, without dimension. parameter: derivative of k by t. unnormalised: also the normal as long as the derivative</source>
        <translation>Bogenlänge: wie hergeleitet, ohne Dimension. Parameter: Ableitung von k nach t. nicht normiert: auch die Normale so lang wie die Ableitung</translation>
    </message>
    <message>
        <source>Sc&amp;ale</source>
        <translation>&amp;Maßstab</translation>
    </message>
    <message>
        <source>Side of the square the control points are drawn from, for example in pixels</source>
        <translation>Seite des Quadrats, aus dem die Kontrollpunkte gezogen werden, zum Beispiel in Pixeln</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>Measure the curves; again: stop</source>
        <translation>Die Kurven messen; noch einmal: anhalten</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Mixed units</source>
        <translation>Gemischte Einheiten</translation>
    </message>
    <message>
        <source>Ratio: offset term over feature term. Displacement: how far apparent ridges lie from their ridges. Mixed units: the ratio in three kinds of unit, at any scale</source>
        <translation>Verhältnis: Versatzterm zu Merkmalsterm. Verschiebung: wie weit scheinbare Grate von ihren Graten liegen. Gemischte Einheiten: das Verhältnis in drei Arten von Einheiten, in jedem Maßstab</translation>
    </message>
    <message>
        <source>Diagram</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>Side of the square, 0.01 to 10,000: the curves stay, the units change</source>
        <translation>Seite des Quadrats, 0.01 bis 10 000: Die Kurven bleiben, die Einheiten ändern sich</translation>
    </message>
    <message>
        <source>Scale of the mixed units</source>
        <translation>Maßstab der gemischten Einheiten</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>&amp;Table…</source>
        <translation>&amp;Tabelle …</translation>
    </message>
    <message>
        <source>Measure and write one row per curve as CSV; a file that was interrupted is continued</source>
        <translation>Messen und je Kurve eine Zeile als CSV schreiben; eine unterbrochene Datei wird fortgesetzt</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Write the diagram as a picture</source>
        <translation>Das Diagramm als Bild schreiben</translation>
    </message>
    <message>
        <source>The seed must be a whole number from 0</source>
        <translation>Die Saat muss eine ganze Zahl ab 0 sein</translation>
    </message>
    <message>
        <source>Write the table of the study</source>
        <translation>Die Tabelle der Studie schreiben</translation>
    </message>
    <message>
        <source>study.csv</source>
        <translation>studie.csv</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>CSV-Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>study</source>
        <translation>studie</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>%1 curves · %2 apparent ridges, %3 births · %4 ridges and valleys, %5 deaths</source>
        <translation>%1 Kurven · %2 scheinbare Grate, %3 Geburten · %4 Grate und Täler, %5 Tode</translation>
    </message>
    <message>
        <source>Stopped: </source>
        <translation>Angehalten: </translation>
    </message>
    <message>
        <source>Show Curve %1 of the Study</source>
        <translation>Kurve %1 der Studie zeigen</translation>
    </message>
    <message>
        <source>Curve %1 of the study. Undo brings your curve back.</source>
        <translation>Kurve %1 der Studie. Rückgängig bringt Ihre Kurve zurück.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::StudyView</name>
    <message>
        <source>Histogram of the study</source>
        <translation>Histogramm der Studie</translation>
    </message>
    <message>
        <source>Click a bar: show a curve of it on the canvas. Left, Right and Enter do the same</source>
        <translation>Klick auf einen Balken: eine seiner Kurven auf der Zeichenfläche zeigen. Links, Rechts und Eingabe tun dasselbe</translation>
    </message>
    <message>
        <source>%1 to %2: %3 %, for example curve %4</source>
        <translation>%1 bis %2: %3 %, zum Beispiel Kurve %4</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Misst …</translation>
    </message>
    <message>
        <source>How large is the offset term against the feature term, over many random curves? Press Run.</source>
        <translation>Wie groß ist der Versatzterm gegen den Merkmalsterm, über viele zufällige Kurven? Drücken Sie Starten.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::SurfaceArea</name>
    <message>
        <source>&amp;Open Mesh...</source>
        <translation>Netz ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Choose a file with a mesh</source>
        <translation>Eine Datei mit einem Netz wählen</translation>
    </message>
    <message>
        <source>No surface yet. Open a mesh (PLY, OBJ, STL, OFF, glTF), drop one here, or take one of Surface &gt; Solids.</source>
        <translation>Noch keine Fläche. Öffne ein Netz (PLY, OBJ, STL, OFF, glTF), lass eines hierher fallen oder nimm eines von Fläche &gt; Körper.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::SurfaceController</name>
    <message>
        <source>Open mesh</source>
        <translation>Netz öffnen</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Netze (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>There is no mesh in this folder any more.</source>
        <translation>In diesem Ordner ist kein Netz mehr.</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>Fläche exportieren</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>flaeche</translation>
    </message>
    <message>
        <source>The lines are not found yet; export again in a moment.</source>
        <translation>Die Linien sind noch nicht gefunden; exportiere gleich noch einmal.</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exportiert nach %1</translation>
    </message>
    <message>
        <source>Does it lie down? Surface &gt; Up Axis stands it up.</source>
        <translation>Liegt es? Fläche &gt; Achse nach oben stellt es auf.</translation>
    </message>
    <message>
        <source>The window closes when the export is written.</source>
        <translation>Das Fenster schließt, wenn der Export geschrieben ist.</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1-Dateien (*.%2)</translation>
    </message>
    <message>
        <source>Stopped reading %1. The surface before stays.</source>
        <translation>Lesen von %1 abgebrochen. Die Fläche davor bleibt.</translation>
    </message>
    <message>
        <source>Stopped reading %1.</source>
        <translation>Lesen von %1 abgebrochen.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::SurfaceExportDialog</name>
    <message>
        <source>Export surface</source>
        <translation>Fläche exportieren</translation>
    </message>
    <message>
        <source>SVG, the lines as vectors</source>
        <translation>SVG, die Linien als Vektoren</translation>
    </message>
    <message>
        <source>PDF, the lines as vectors</source>
        <translation>PDF, die Linien als Vektoren</translation>
    </message>
    <message>
        <source>TikZ, the lines for LaTeX</source>
        <translation>TikZ, die Linien für LaTeX</translation>
    </message>
    <message>
        <source>PNG, the picture with its shading</source>
        <translation>PNG, das Bild mit seiner Schattierung</translation>
    </message>
    <message>
        <source>PLY, curvature at the vertices</source>
        <translation>PLY, Krümmung an den Eckpunkten</translation>
    </message>
    <message>
        <source>CSV, curvature at the vertices</source>
        <translation>CSV, Krümmung an den Eckpunkten</translation>
    </message>
    <message>
        <source>JSON, cameras for flatland lines</source>
        <translation>JSON, Kameras für flatland lines</translation>
    </message>
    <message>
        <source>Lines keep their width whatever the size.</source>
        <translation>Linien behalten ihre Breite bei jeder Größe.</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Choose a file and write it</source>
        <translation>Eine Datei wählen und schreiben</translation>
    </message>
</context>
<context>
    <name>flatland::ui::SurfaceExporter</name>
    <message>
        <source>%1 is the mesh itself, which would be lost</source>
        <translation>%1 ist das Netz selbst, das verloren ginge</translation>
    </message>
</context>
<context>
    <name>flatland::ui::SurfaceInput</name>
    <message>
        <source>Turning; Esc takes it back</source>
        <translation>Drehen; Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Moving; Esc takes it back</source>
        <translation>Verschieben; Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Rolling; Esc takes it back</source>
        <translation>Rollen; Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Drag: turn (Shift: move). Click: pick. Wheel: zoom. 1 3 7: views. 5: perspective.</source>
        <translation>Ziehen: drehen (Umschalt: verschieben). Klick: Punkt wählen. Rad: Zoom. 1 3 7: Ansichten. 5: Perspektive.</translation>
    </message>
    <message>
        <source>Drag: move the plane along its normal</source>
        <translation>Ziehen: die Ebene entlang ihrer Normalen verschieben</translation>
    </message>
    <message>
        <source>Drag: turn the plane</source>
        <translation>Ziehen: die Ebene drehen</translation>
    </message>
    <message>
        <source>The arrow keys turn the plane; [ and ] move it; Esc gives them back</source>
        <translation>Die Pfeiltasten drehen die Ebene; [ und ] verschieben sie; Esc gibt sie zurück</translation>
    </message>
</context>
<context>
    <name>flatland::ui::SurfaceOverlay</name>
    <message>
        <source>k₁, largest curvature</source>
        <translation>k₁, größte Krümmung</translation>
    </message>
    <message>
        <source>k₂, smallest curvature</source>
        <translation>k₂, kleinste Krümmung</translation>
    </message>
    <message>
        <source>λ, view-dependent curvature</source>
        <translation>λ, blickabhängige Krümmung</translation>
    </message>
    <message>
        <source>|Offset| / |feature|</source>
        <translation>|Versatz| / |Merkmal|</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>Frame %1 ms</source>
        <translation>Bild %1 ms</translation>
    </message>
    <message>
        <source>Lines %1 ms</source>
        <translation>Linien %1 ms</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keins</translation>
    </message>
    <message>
        <source>feature %1</source>
        <translation>Merkmal %1</translation>
    </message>
    <message>
        <source>offset %1</source>
        <translation>Versatz %1</translation>
    </message>
    <message>
        <source>perspective %1</source>
        <translation>Perspektive %1</translation>
    </message>
    <message>
        <source>|offset| / |feature| %1</source>
        <translation>|Versatz| / |Merkmal| %1</translation>
    </message>
    <message>
        <source>Feature term, towards larger λ</source>
        <translation>Merkmalsterm, zu größerem λ hin</translation>
    </message>
    <message>
        <source>Offset term, towards larger λ</source>
        <translation>Versatzterm, zu größerem λ hin</translation>
    </message>
</context>
<context>
    <name>flatland::ui::SurfacePanel</name>
    <message>
        <source>What was found in the mesh</source>
        <translation>Was im Netz gefunden wurde</translation>
    </message>
    <message>
        <source>Paper, lines only</source>
        <translation>Papier, nur Linien</translation>
    </message>
    <message>
        <source>Flat triangles</source>
        <translation>Flache Dreiecke</translation>
    </message>
    <message>
        <source>Matt (Lambert)</source>
        <translation>Matt (Lambert)</translation>
    </message>
    <message>
        <source>Toon</source>
        <translation>Comic</translation>
    </message>
    <message>
        <source>Warm and cool (Gooch)</source>
        <translation>Warm und kalt (Gooch)</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Colour map</source>
        <translation>Farbkarte</translation>
    </message>
    <message>
        <source>What is seen below the lines</source>
        <translation>Was unter den Linien zu sehen ist</translation>
    </message>
    <message>
        <source>change shading</source>
        <translation>Schattierung ändern</translation>
    </message>
    <message>
        <source>&amp;Shading</source>
        <translation>&amp;Schattierung</translation>
    </message>
    <message>
        <source>change colour map</source>
        <translation>Farbkarte ändern</translation>
    </message>
    <message>
        <source>&amp;Colours of</source>
        <translation>&amp;Farben von</translation>
    </message>
    <message>
        <source>How much larger than needed the neighbourhoods are that curvature is estimated from: larger is smoother</source>
        <translation>Wie viel größer als nötig die Umgebungen sind, aus denen die Krümmung geschätzt wird: größer ist glatter</translation>
    </message>
    <message>
        <source>change smoothness</source>
        <translation>Glättung ändern</translation>
    </message>
    <message>
        <source>S&amp;moothness</source>
        <translation>&amp;Glättung</translation>
    </message>
    <message>
        <source>Cameras kept</source>
        <translation>Behaltene Kameras</translation>
    </message>
    <message>
        <source>Double-click or Return: look from there again</source>
        <translation>Doppelklick oder Eingabe: wieder von dort ansehen</translation>
    </message>
    <message>
        <source>&amp;Keep Camera</source>
        <translation>Kamera &amp;behalten</translation>
    </message>
    <message>
        <source>Keep this view with the scene</source>
        <translation>Diese Ansicht mit der Szene behalten</translation>
    </message>
    <message>
        <source>&amp;Forget</source>
        <translation>&amp;Vergessen</translation>
    </message>
    <message>
        <source>Take the selected camera off the list</source>
        <translation>Die gewählte Kamera von der Liste nehmen</translation>
    </message>
    <message>
        <source>Read in %1 ms</source>
        <translation>Gelesen in %1 ms</translation>
    </message>
    <message>
        <source>Curvature in %1 ms</source>
        <translation>Krümmung in %1 ms</translation>
    </message>
    <message>
        <source>keep camera</source>
        <translation>Kamera behalten</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>forget camera</source>
        <translation>Kamera vergessen</translation>
    </message>
    <message numerus="yes">
        <source>%Ln vertices</source>
        <translation>
            <numerusform>%Ln Eckpunkt</numerusform>
            <numerusform>%Ln Eckpunkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangles</source>
        <translation>
            <numerusform>%Ln Dreieck</numerusform>
            <numerusform>%Ln Dreiecke</numerusform>
        </translation>
    </message>
    <message>
        <source>What the colour map shows; curvatures times the size of the surface. Choosing one makes the colour map the shading</source>
        <translation>Was die Farbkarte zeigt; Krümmungen mal Größe der Fläche. Eine Wahl macht die Farbkarte zur Schattierung</translation>
    </message>
</context>
<context>
    <name>flatland::ui::SurfaceProgress</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Begin again what was given up</source>
        <translation>Von neuem beginnen, was abgebrochen wurde</translation>
    </message>
    <message>
        <source>The mesh was not read</source>
        <translation>Das Netz wurde nicht gelesen</translation>
    </message>
    <message>
        <source>No lines: curvature was not estimated</source>
        <translation>Keine Linien: Die Krümmung wurde nicht geschätzt</translation>
    </message>
    <message>
        <source>A coarse mesh: the fine one was not made</source>
        <translation>Ein grobes Netz: Das feine wurde nicht gemacht</translation>
    </message>
    <message>
        <source>The lines are those of the smoothness before</source>
        <translation>Die Linien sind die der vorigen Glättung</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>Das Netz wird gelesen</translation>
    </message>
    <message>
        <source>Estimating curvature</source>
        <translation>Die Krümmung wird geschätzt</translation>
    </message>
    <message>
        <source>Give up reading; what was there before stays</source>
        <translation>Nicht weiter lesen; was vorher da war, bleibt</translation>
    </message>
    <message>
        <source>Give up estimating; lines that were there before stay, a new mesh has none. Go On begins again.</source>
        <translation>Das Schätzen abbrechen; Linien, die schon da waren, bleiben, ein neues Netz hat keine. „Weiter“ beginnt von neuem.</translation>
    </message>
</context>
<context>
    <name>flatland::ui::SurfaceSource</name>
    <message>
        <source>open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>close surface</source>
        <translation>Fläche schließen</translation>
    </message>
</context>
<context>
    <name>flatland::ui::SweepPanel</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Direction from the curve to the viewer</source>
        <translation>Richtung von der Kurve zum Betrachter</translation>
    </message>
    <message>
        <source>View angle</source>
        <translation>Ansichtswinkel</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>How fast the view turns when played</source>
        <translation>Wie schnell sich die Ansicht beim Abspielen dreht</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Turn to the previous event of an apparent ridge (Ctrl+Left)</source>
        <translation>Zum vorigen Ereignis eines scheinbaren Grats drehen (Strg+Links)</translation>
    </message>
    <message>
        <source>Turn to the next event of an apparent ridge (Ctrl+Right)</source>
        <translation>Zum nächsten Ereignis eines scheinbaren Grats drehen (Strg+Rechts)</translation>
    </message>
    <message>
        <source>Turn the view once around (Space); Esc returns to the view before</source>
        <translation>Die Ansicht einmal herumdrehen (Leertaste); Esc kehrt zur Ansicht davor zurück</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Show the whole diagram (F)</source>
        <translation>Das ganze Diagramm zeigen (F)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Write the diagram as SVG, PDF, PNG, TikZ or as a CSV table</source>
        <translation>Das Diagramm als SVG, PDF, PNG, TikZ oder als CSV-Tabelle schreiben</translation>
    </message>
    <message>
        <source>Updating…</source>
        <translation>Wird erneuert …</translation>
    </message>
    <message>
        <source>Shown for a viewer infinitely far away, not for this perspective</source>
        <translation>Gezeigt für einen unendlich fernen Betrachter, nicht für diese Perspektive</translation>
    </message>
    <message numerus="yes">
        <source>%n births or merges in half a turn</source>
        <translation>
            <numerusform>%n Geburt oder Verschmelzung in einer halben Drehung</numerusform>
            <numerusform>%n Geburten oder Verschmelzungen in einer halben Drehung</numerusform>
        </translation>
    </message>
    <message>
        <source>certified</source>
        <translation>bewiesen</translation>
    </message>
    <message>
        <source> · </source>
        <translation> · </translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>rundblick</translation>
    </message>
    <message>
        <source>not complete</source>
        <translation>nicht vollständig</translation>
    </message>
    <message>
        <source>too many branches: points are coarse</source>
        <translation>zu viele Äste: Die Punkte liegen weit auseinander</translation>
    </message>
    <message>
        <source>too large: what is hidden is not marked</source>
        <translation>zu groß: Was verdeckt ist, ist nicht gekennzeichnet</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>vollständig</translation>
    </message>
</context>
<context>
    <name>flatland::ui::SweepView</name>
    <message>
        <source>View sweep</source>
        <translation>Rundblick</translation>
    </message>
    <message>
        <source>Click: go there. Drag: turn the view. Wheel: zoom. Middle button: move. Left, Right: turn by 1° (Shift 0.1°, Ctrl next event). Space: play.</source>
        <translation>Klick: dorthin gehen. Ziehen: Ansicht drehen. Mausrad: zoomen. Mittlere Taste: bewegen. Links, Rechts: um 1° drehen (Umschalt 0.1°, Strg nächstes Ereignis). Leertaste: abspielen.</translation>
    </message>
    <message>
        <source>No curve</source>
        <translation>Keine Kurve</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Rechnet …</translation>
    </message>
    <message>
        <source>An apparent ridge is born or merges with a minimum at %1°, arc length %2</source>
        <translation>Ein scheinbarer Grat entsteht oder verschmilzt mit einem Minimum bei %1°, Bogenlänge %2</translation>
    </message>
    <message>
        <source>%1°, arc length %2</source>
        <translation>%1°, Bogenlänge %2</translation>
    </message>
</context>
<context>
    <name>flatland::ui::TrianglePanel</name>
    <message>
        <source>The picked triangle; type a number to pick another</source>
        <translation>Das gewählte Dreieck; eine Zahl wählt ein anderes</translation>
    </message>
    <message>
        <source>What becomes of the triangle</source>
        <translation>Was aus dem Dreieck wird</translation>
    </message>
    <message>
        <source>(a) Where λ is compared, to both sides along t_A</source>
        <translation>(a) Wo λ verglichen wird, zu beiden Seiten längs t_A</translation>
    </message>
    <message>
        <source>(b) t_A, turned to where λ grows</source>
        <translation>(b) t_A, dorthin gedreht, wo λ wächst</translation>
    </message>
    <message>
        <source>(c) Where two directions disagree: crossings and the line</source>
        <translation>(c) Wo zwei Richtungen sich widersprechen: Kreuzungen und die Linie</translation>
    </message>
    <message>
        <source>(d) Perpendiculars: a maximum if all angles are acute</source>
        <translation>(d) Lote: ein Maximum, wenn alle Winkel spitz sind</translation>
    </message>
    <message>
        <source>Click a point of the surface, or press P over its picture.</source>
        <translation>Klicken Sie einen Punkt der Fläche an oder drücken Sie P über ihrem Bild.</translation>
    </message>
    <message>
        <source>by neighbours</source>
        <translation>aus Nachbarn</translation>
    </message>
    <message>
        <source>cos</source>
        <translation>cos</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>At the corners</source>
        <translation>An den Eckpunkten</translation>
    </message>
    <message>
        <source>At each corner λ, its derivative along t_A on the screen, the same from its neighbours, and the cosine between t_A and the perpendicular; ↔: flipped</source>
        <translation>An jedem Eckpunkt λ, seine Ableitung längs t_A auf dem Schirm, dieselbe aus den Nachbarn und der Kosinus zwischen t_A und dem Lot; ↔: umgedreht</translation>
    </message>
    <message>
        <source>Dropped: a normal is unknown.</source>
        <translation>Verworfen: Eine Normale ist unbekannt.</translation>
    </message>
    <message>
        <source>Dropped: a sharp edge parts the surface here, and is itself the line.</source>
        <translation>Verworfen: Eine scharfe Kante teilt hier die Fläche und ist selbst die Linie.</translation>
    </message>
    <message>
        <source>Nothing here: all three directions agree.</source>
        <translation>Nichts: Alle drei Richtungen stimmen überein.</translation>
    </message>
    <message>
        <source>Dropped: a corner is turned away.</source>
        <translation>Verworfen: Ein Eckpunkt ist abgewandt.</translation>
    </message>
    <message>
        <source>Dropped: one edge alone is crossed; t_A has a singular point here.</source>
        <translation>Verworfen: Nur eine Kante wird gekreuzt; t_A hat hier einen singulären Punkt.</translation>
    </message>
    <message>
        <source>Dropped: t_A turns too far from corner to corner.</source>
        <translation>Verworfen: t_A dreht sich von Eckpunkt zu Eckpunkt zu weit.</translation>
    </message>
    <message>
        <source>Dropped: √λ is below the threshold %1.</source>
        <translation>Verworfen: √λ liegt unter der Schwelle %1.</translation>
    </message>
    <message>
        <source>Dropped: a direction points away from the line, so it is a minimum.</source>
        <translation>Verworfen: Eine Richtung zeigt von der Linie weg, also ist es ein Minimum.</translation>
    </message>
    <message>
        <source>A maximum, but λ hardly falls beside it</source>
        <translation>Ein Maximum, aber λ fällt daneben kaum</translation>
    </message>
    <message>
        <source>A maximum: all directions point towards the line</source>
        <translation>Ein Maximum: Alle Richtungen zeigen zur Linie</translation>
    </message>
    <message>
        <source>%1. Drawn, as the triangle before it on the line.</source>
        <translation>%1. Gezeichnet wie das Dreieck davor auf der Linie.</translation>
    </message>
    <message>
        <source>%1. Dropped, as the triangle before it on the line.</source>
        <translation>%1. Verworfen wie das Dreieck davor auf der Linie.</translation>
    </message>
    <message>
        <source>%1. Kept.</source>
        <translation>%1. Behalten.</translation>
    </message>
    <message>
        <source>%1. Dropped.</source>
        <translation>%1. Verworfen.</translation>
    </message>
    <message>
        <source>Drawn, as every crossing. The filters would say: %1</source>
        <translation>Gezeichnet wie jede Kreuzung. Die Filter würden sagen: %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
</context>
<context>
    <name>flatland::ui::TriangleView</name>
    <message>
        <source>The triangle</source>
        <translation>Das Dreieck</translation>
    </message>
    <message>
        <source>The picked triangle in its own plane. Bars: crossings; orange: t_A to where λ grows; dashed: as it came</source>
        <translation>Das gewählte Dreieck in seiner Ebene. Kästchen: Kreuzungen; orange: t_A dorthin, wo λ wächst; gestrichelt: wie es kam</translation>
    </message>
</context>
<context>
    <name>flatland::ui::ViewPanel</name>
    <message>
        <source>Direction from the curve to the viewer, counter-clockwise from the right</source>
        <translation>Richtung von der Kurve zum Betrachter, gegen den Uhrzeigersinn von rechts</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>The viewer stands at a distance; off: infinitely far away</source>
        <translation>Der Betrachter steht in einem Abstand; aus: unendlich weit weg</translation>
    </message>
    <message>
        <source>Distance of the viewer from the origin, in scene lengths</source>
        <translation>Abstand des Betrachters vom Ursprung, in Längen der Szene</translation>
    </message>
    <message>
        <source>Distance of the viewer</source>
        <translation>Abstand des Betrachters</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>View from %1°</source>
        <translation>Ansicht von %1°</translation>
    </message>
</context>
</TS>
