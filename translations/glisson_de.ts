<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AskPath</name>
    <message>
        <source>Take this folder</source>
        <translation>Diesen Ordner nehmen</translation>
    </message>
</context>
<context>
    <name>Workspace</name>
    <message>
        <source>Needs a model of the liver: build it first.</source>
        <translation>Braucht ein Modell der Leber: Erstellen Sie es zuerst.</translation>
    </message>
    <message>
        <source>The model is being prepared.</source>
        <translation>Das Modell wird vorbereitet.</translation>
    </message>
</context>
<context>
    <name>effects</name>
    <message>
        <source>Stiffer or softer throughout</source>
        <translation>Überall steifer oder weicher</translation>
    </message>
    <message>
        <source>Stiffens as it deforms</source>
        <translation>Versteift sich bei Verformung</translation>
    </message>
    <message>
        <source>The support gives way</source>
        <translation>Die Lagerung gibt nach</translation>
    </message>
    <message>
        <source>A hidden stiffer region</source>
        <translation>Ein verborgener steiferer Bereich</translation>
    </message>
    <message>
        <source>Creeps under load</source>
        <translation>Kriecht unter Last</translation>
    </message>
    <message>
        <source>The force sensor is off</source>
        <translation>Der Kraftsensor misst falsch</translation>
    </message>
    <message>
        <source>Camera and specimen misaligned</source>
        <translation>Kamera und Prüfkörper verschoben</translation>
    </message>
    <message>
        <source>Stiffer along one direction</source>
        <translation>Steifer in einer Richtung</translation>
    </message>
    <message>
        <source>A stiff capsule around it</source>
        <translation>Eine steife Kapsel darum</translation>
    </message>
    <message>
        <source>Already loaded at the start</source>
        <translation>Schon zu Beginn belastet</translation>
    </message>
    <message>
        <source>Softer once it was stretched</source>
        <translation>Weicher, nachdem es gedehnt wurde</translation>
    </message>
    <message>
        <source>Loading and unloading differ</source>
        <translation>Be- und Entlastung unterscheiden sich</translation>
    </message>
    <message>
        <source>Tension and compression differ</source>
        <translation>Zug und Druck unterscheiden sich</translation>
    </message>
    <message>
        <source>The battery&apos;s own resistance</source>
        <translation>Der Widerstand des Akkus selbst</translation>
    </message>
    <message>
        <source>Less charge when emptied fast</source>
        <translation>Weniger Ladung bei schneller Entladung</translation>
    </message>
    <message>
        <source>It warms itself</source>
        <translation>Es erwärmt sich selbst</translation>
    </message>
    <message>
        <source>Voltage falls as it empties</source>
        <translation>Spannung fällt beim Entladen</translation>
    </message>
    <message>
        <source>Power drawn at rest</source>
        <translation>Leistung im Leerlauf</translation>
    </message>
    <message>
        <source>Power drawn by the work</source>
        <translation>Leistung durch die Arbeit</translation>
    </message>
    <message>
        <source>Slows down when hot</source>
        <translation>Wird heiß langsamer</translation>
    </message>
    <message>
        <source>Sheds heat better or worse</source>
        <translation>Gibt Wärme besser oder schlechter ab</translation>
    </message>
    <message>
        <source>Takes time to warm up</source>
        <translation>Braucht Zeit zum Warmwerden</translation>
    </message>
    <message>
        <source>Power lost in the supply</source>
        <translation>Verlust in der Versorgung</translation>
    </message>
    <message>
        <source>A smooth correction, no cause</source>
        <translation>Eine glatte Korrektur, keine Ursache</translation>
    </message>
    <message>
        <source>Waves lose energy on their way</source>
        <translation>Wellen verlieren unterwegs Energie</translation>
    </message>
    <message>
        <source>Long waves that compress, besides shear waves</source>
        <translation>Lange Kompressionswellen neben den Scherwellen</translation>
    </message>
    <message>
        <source>Slices seen at different moments</source>
        <translation>Schichten zu verschiedenen Zeitpunkten gesehen</translation>
    </message>
    <message>
        <source>Another stiffness along the border</source>
        <translation>Andere Steifigkeit entlang des Randes</translation>
    </message>
    <message>
        <source>Held where nothing was declared</source>
        <translation>Gehalten, wo nichts angegeben war</translation>
    </message>
    <message>
        <source>A declared attachment gives way or is missing</source>
        <translation>Eine angegebene Anheftung gibt nach oder fehlt</translation>
    </message>
    <message>
        <source>The neo-Hookean law</source>
        <translation>Das neo-Hookesche Gesetz</translation>
    </message>
    <message>
        <source>The law of Mooney and Rivlin</source>
        <translation>Das Gesetz von Mooney und Rivlin</translation>
    </message>
    <message>
        <source>The law of Gent and Thomas</source>
        <translation>Das Gesetz von Gent und Thomas</translation>
    </message>
    <message>
        <source>The law of Gent</source>
        <translation>Das Gesetz von Gent</translation>
    </message>
    <message>
        <source>The law of Arruda and Boyce</source>
        <translation>Das Gesetz von Arruda und Boyce</translation>
    </message>
    <message>
        <source>The law of Ogden</source>
        <translation>Das Gesetz von Ogden</translation>
    </message>
    <message>
        <source>The law of Isihara</source>
        <translation>Das Gesetz von Isihara</translation>
    </message>
    <message>
        <source>The law of Yeoh</source>
        <translation>Das Gesetz von Yeoh</translation>
    </message>
    <message>
        <source>Fibres along one direction</source>
        <translation>Fasern in einer Richtung</translation>
    </message>
    <message>
        <source>The law of Haines and Wilson</source>
        <translation>Das Gesetz von Haines und Wilson</translation>
    </message>
    <message>
        <source>Fibres along two directions (Holzapfel)</source>
        <translation>Fasern in zwei Richtungen (Holzapfel)</translation>
    </message>
</context>
<context>
    <name>entries</name>
    <message>
        <source>the image of the anatomy</source>
        <translation>das Bild der Anatomie</translation>
    </message>
    <message>
        <source>the stiffness map</source>
        <translation>die Steifigkeitskarte</translation>
    </message>
    <message>
        <source>the confidence map</source>
        <translation>die Konfidenzkarte</translation>
    </message>
    <message>
        <source>the mesh of the liver</source>
        <translation>das Netz der Leber</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>das Modell</translation>
    </message>
    <message>
        <source>the accepted evidence</source>
        <translation>die angenommene Evidenz</translation>
    </message>
    <message>
        <source>the vessel trees</source>
        <translation>die Gefäßbäume</translation>
    </message>
    <message>
        <source>the map of the segments</source>
        <translation>die Karte der Segmente</translation>
    </message>
    <message>
        <source>%1 (label %2)</source>
        <translation>%1 (Label %2)</translation>
    </message>
    <message>
        <source>label %1</source>
        <translation>Label %1</translation>
    </message>
</context>
<context>
    <name>errors</name>
    <message>
        <source>There is no column &quot;{0}&quot;.</source>
        <translation>Es gibt keine Spalte „{0}“.</translation>
    </message>
    <message>
        <source>The columns are {1}.</source>
        <translation>Die Spalten sind {1}.</translation>
    </message>
    <message>
        <source>{0} has too many columns.</source>
        <translation>{0} hat zu viele Spalten.</translation>
    </message>
    <message>
        <source>{0} holds no rows of numbers.</source>
        <translation>{0} enthält keine Zeilen mit Zahlen.</translation>
    </message>
    <message>
        <source>The file {0} cannot be read.</source>
        <translation>Die Datei {0} kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Check that it exists and that you may read it.</source>
        <translation>Prüfen Sie, ob sie vorhanden ist und Sie sie lesen dürfen.</translation>
    </message>
    <message>
        <source>{0} cannot be written: {1}.</source>
        <translation>{0} kann nicht geschrieben werden: {1}.</translation>
    </message>
    <message>
        <source>Check the folder, your rights there and the free space.</source>
        <translation>Prüfen Sie den Ordner, Ihre Rechte dort und den freien Speicherplatz.</translation>
    </message>
    <message>
        <source>The file {0} has {1} bytes; at most {2} are read.</source>
        <translation>Die Datei {0} hat {1} Bytes; höchstens {2} werden gelesen.</translation>
    </message>
    <message>
        <source>The files that ship with Glisson were not found.</source>
        <translation>Die mit Glisson gelieferten Dateien wurden nicht gefunden.</translation>
    </message>
    <message>
        <source>Set GLISSON_RESOURCES to the folder named resources.</source>
        <translation>Setzen Sie GLISSON_RESOURCES auf den Ordner namens resources.</translation>
    </message>
    <message>
        <source>{0} is nested too deep to be one of our files.</source>
        <translation>{0} ist zu tief verschachtelt, um eine unserer Dateien zu sein.</translation>
    </message>
    <message>
        <source>{0} is not valid JSON at line {1}.</source>
        <translation>{0} ist in Zeile {1} kein gültiges JSON.</translation>
    </message>
    <message>
        <source>Look for a missing comma, quote or bracket there.</source>
        <translation>Suchen Sie dort nach einem fehlenden Komma, Anführungszeichen oder einer fehlenden Klammer.</translation>
    </message>
    <message>
        <source>{0} holds a number too large for a computer&apos;s arithmetic.</source>
        <translation>{0} enthält eine Zahl, die zu groß für die Rechnung eines Computers ist.</translation>
    </message>
    <message>
        <source>{0} should be an object in braces.</source>
        <translation>{0} muss ein Objekt in geschweiften Klammern sein.</translation>
    </message>
    <message>
        <source>{0} has a key that is not known: &quot;{1}&quot;.</source>
        <translation>{0} hat einen unbekannten Schlüssel: „{1}“.</translation>
    </message>
    <message>
        <source>Did you mean &quot;{2}&quot;?</source>
        <translation>Meinten Sie „{2}“?</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>{0} is there already.</source>
        <translation>{0} ist schon vorhanden.</translation>
    </message>
    <message>
        <source>Choose another name, or remove it first.</source>
        <translation>Wählen Sie einen anderen Namen, oder entfernen Sie es zuerst.</translation>
    </message>
    <message>
        <source>The folder {0} cannot be made: {1}.</source>
        <translation>Der Ordner {0} kann nicht angelegt werden: {1}.</translation>
    </message>
    <message>
        <source>it holds no case.json</source>
        <translation>er enthält keine case.json</translation>
    </message>
    <message>
        <source>case.json does not say &quot;format&quot;: &quot;glisson-case/1&quot;</source>
        <translation>case.json sagt nicht &quot;format&quot;: &quot;glisson-case/1&quot;</translation>
    </message>
    <message>
        <source>The case {0} has no {1} yet.</source>
        <translation>Der Fall {0} hat noch kein {1}.</translation>
    </message>
    <message>
        <source>Import a study first (glisson-cli import).</source>
        <translation>Importieren Sie zuerst eine Studie (glisson-cli import).</translation>
    </message>
    <message>
        <source>Segment it first (glisson-cli segment).</source>
        <translation>Segmentieren Sie es zuerst (glisson-cli segment).</translation>
    </message>
    <message>
        <source>Mesh the liver first (glisson-cli mesh).</source>
        <translation>Vernetzen Sie zuerst die Leber (glisson-cli mesh).</translation>
    </message>
    <message>
        <source>{0} cannot be put in its place: {1}.</source>
        <translation>{0} kann nicht an seinen Platz gebracht werden: {1}.</translation>
    </message>
    <message>
        <source>{0} is damaged: {1}.</source>
        <translation>{0} ist beschädigt: {1}.</translation>
    </message>
    <message>
        <source>{0} is not a Glisson case: {1}.</source>
        <translation>{0} ist kein Glisson-Fall: {1}.</translation>
    </message>
    <message>
        <source>Make one with: glisson-cli import STUDY --case NAME.glisson</source>
        <translation>Legen Sie einen an mit: glisson-cli import STUDIE --case NAME.glisson</translation>
    </message>
    <message>
        <source>{0} holds nothing that could be written as {1}.</source>
        <translation>{0} enthält nichts, was als {1} geschrieben werden könnte.</translation>
    </message>
    <message>
        <source>Run the stage that makes it first.</source>
        <translation>Führen Sie zuerst den Schritt aus, der es erzeugt.</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>The study has no series {0}.</source>
        <translation>Die Studie hat keine Serie {0}.</translation>
    </message>
    <message>
        <source>glisson-cli scan lists them.</source>
        <translation>glisson-cli scan führt sie auf.</translation>
    </message>
    <message>
        <source>{0} series could be the {1}:{2}</source>
        <translation>{0} Serien kommen als {1} infrage:{2}</translation>
    </message>
    <message>
        <source>Name one with {3} UID.</source>
        <translation>Nennen Sie eine mit {3} UID.</translation>
    </message>
    <message>
        <source>No series is recognised as the anatomy.{0}</source>
        <translation>Keine Serie ist als Anatomie erkannt.{0}</translation>
    </message>
    <message>
        <source>glisson-cli scan says what is there, and what was skipped.</source>
        <translation>glisson-cli scan sagt, was da ist und was übergangen wurde.</translation>
    </message>
    <message>
        <source>Name one with --anatomy UID.</source>
        <translation>Nennen Sie eine mit --anatomy UID.</translation>
    </message>
    <message>
        <source>Reading the structures</source>
        <translation>Strukturen werden gelesen</translation>
    </message>
    <message>
        <source>Saving the mesh</source>
        <translation>Netz wird gespeichert</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>Netz wird gelesen</translation>
    </message>
    <message>
        <source>Stiffness of each cell from the MRE map</source>
        <translation>Steifigkeit jeder Zelle aus der MRE-Karte</translation>
    </message>
    <message>
        <source>A Young&apos;s modulus of {0} kPa is not possible.</source>
        <translation>Ein Elastizitätsmodul von {0} kPa ist nicht möglich.</translation>
    </message>
    <message>
        <source>Saving the model</source>
        <translation>Modell wird gespeichert</translation>
    </message>
    <message>
        <source>Give the mesh its stiffness first (glisson-cli stiffness).</source>
        <translation>Geben Sie dem Netz zuerst seine Steifigkeit (glisson-cli stiffness).</translation>
    </message>
    <message>
        <source>The model of {0} has no stiffness.</source>
        <translation>Das Modell von {0} hat keine Steifigkeit.</translation>
    </message>
    <message>
        <source>Run glisson-cli stiffness again.</source>
        <translation>Führen Sie glisson-cli stiffness erneut aus.</translation>
    </message>
    <message>
        <source>Import a study with MR elastography, or choose --uniform-kPa or --atlas.</source>
        <translation>Importieren Sie eine Studie mit MR-Elastographie, oder wählen Sie --uniform-kPa oder --atlas.</translation>
    </message>
    <message>
        <source>{0} does not hold a simulation&apos;s result: {1}.</source>
        <translation>{0} enthält kein Ergebnis einer Simulation: {1}.</translation>
    </message>
    <message>
        <source>Make one with glisson-cli simulate --out DIR.</source>
        <translation>Erzeugen Sie eines mit glisson-cli simulate --out ORDNER.</translation>
    </message>
    <message>
        <source>result.vtu is missing</source>
        <translation>result.vtu fehlt</translation>
    </message>
    <message>
        <source>result.json does not say &quot;format&quot;: &quot;glisson-result/1&quot;</source>
        <translation>result.json sagt nicht &quot;format&quot;: &quot;glisson-result/1&quot;</translation>
    </message>
    <message>
        <source>the computation did not converge</source>
        <translation>die Rechnung ist nicht konvergiert</translation>
    </message>
    <message>
        <source>The growing left {0} out; it was added to the liver.</source>
        <translation>{0} wurde beim Wachsen ausgelassen und der Leber hinzugefügt.</translation>
    </message>
    <message>
        <source>Reading the labels</source>
        <translation>Segmentierung wird gelesen</translation>
    </message>
    <message>
        <source>No voxel of label {0} in {1} lies inside the anatomy.</source>
        <translation>Kein Voxel des Labels {0} in {1} liegt innerhalb der Anatomie.</translation>
    </message>
    <message>
        <source>Check that both belong to the same patient and frame of reference.</source>
        <translation>Prüfen Sie, ob beide zum selben Patienten und Bezugssystem gehören.</translation>
    </message>
    <message>
        <source>{0} has no labelled voxel.</source>
        <translation>{0} hat kein markiertes Voxel.</translation>
    </message>
    <message>
        <source>{0} has no label {2}; it holds {1}.</source>
        <translation>{0} hat kein Label {2}; enthalten ist {1}.</translation>
    </message>
    <message>
        <source>{0} holds several labels: {1}.</source>
        <translation>{0} enthält mehrere Labels: {1}.</translation>
    </message>
    <message>
        <source>Choose one with --label-value.</source>
        <translation>Wählen Sie eines mit --label-value.</translation>
    </message>
    <message>
        <source>The magnitude images do not lie on the grid of the waves.</source>
        <translation>Die Magnitudenbilder liegen nicht auf dem Gitter der Wellen.</translation>
    </message>
    <message>
        <source>{0} holds no wave or phase images.</source>
        <translation>{0} enthält keine Wellen- oder Phasenbilder.</translation>
    </message>
    <message>
        <source>Import the phase series of an elastography scan (glisson-cli import --phase).</source>
        <translation>Importieren Sie die Phasenserie einer Elastographie (glisson-cli import --phase).</translation>
    </message>
    <message>
        <source>Reading the waves</source>
        <translation>Wellen werden gelesen</translation>
    </message>
    <message>
        <source>Saving the maps</source>
        <translation>Karten werden gespeichert</translation>
    </message>
    <message>
        <source>{0} is not an experiment of the format &quot;glisson-experiment/1&quot;.</source>
        <translation>{0} ist kein Experiment im Format &quot;glisson-experiment/1&quot;.</translation>
    </message>
    <message>
        <source>An experiment begins with &quot;format&quot;: &quot;glisson-experiment/1&quot; and &quot;kind&quot;.</source>
        <translation>Ein Experiment beginnt mit &quot;format&quot;: &quot;glisson-experiment/1&quot; und &quot;kind&quot;.</translation>
    </message>
    <message>
        <source>There is no kind of experiment called &quot;{0}&quot;.</source>
        <translation>Es gibt keine Art von Experiment namens „{0}“.</translation>
    </message>
    <message>
        <source>Line {0} of {1} names {2}, which is not there.</source>
        <translation>Zeile {0} von {1} nennt {2}, das nicht vorhanden ist.</translation>
    </message>
    <message>
        <source>Files are looked for beside the experiment: was it copied without them, or is the name misspelt?</source>
        <translation>Dateien werden neben dem Experiment gesucht: Wurde es ohne sie kopiert, oder ist der Name falsch geschrieben?</translation>
    </message>
    <message>
        <source>{0} lacks &quot;{1}&quot;.</source>
        <translation>{0} fehlt &quot;{1}&quot;.</translation>
    </message>
    <message>
        <source>{0} must be a finite number.</source>
        <translation>{0} muss eine endliche Zahl sein.</translation>
    </message>
    <message>
        <source>{0} must be above zero.</source>
        <translation>{0} muss größer als null sein.</translation>
    </message>
    <message>
        <source>{0} must be a text in quotes.</source>
        <translation>{0} muss ein Text in Anführungszeichen sein.</translation>
    </message>
    <message>
        <source>{0} must be three numbers [x, y, z].</source>
        <translation>{0} muss aus drei Zahlen [x, y, z] bestehen.</translation>
    </message>
    <message>
        <source>&quot;trials&quot; must be a list with at least one trial.</source>
        <translation>&quot;trials&quot; muss eine Liste mit mindestens einem Versuch sein.</translation>
    </message>
    <message>
        <source>{0} must be an object in braces.</source>
        <translation>{0} muss ein Objekt in geschweiften Klammern sein.</translation>
    </message>
    <message>
        <source>Two trials have the id &quot;{0}&quot;.</source>
        <translation>Zwei Versuche haben die Kennung „{0}“.</translation>
    </message>
    <message>
        <source>{0} has no column &quot;{1}&quot;, which the experiment names for {2}; line {3} has: {4}.</source>
        <translation>{0} hat keine Spalte „{1}“, die das Experiment für {2} nennt; Zeile {3} hat: {4}.</translation>
    </message>
    <message>
        <source>Is the name misspelt, or is this the table of another trial?</source>
        <translation>Ist der Name falsch geschrieben, oder ist dies die Tabelle eines anderen Versuchs?</translation>
    </message>
    <message>
        <source>Line {0} of {1} has no number under &quot;{2}&quot;.</source>
        <translation>Zeile {0} von {1} hat unter „{2}“ keine Zahl.</translation>
    </message>
    <message>
        <source>Is the table cut off, or written with decimal commas?</source>
        <translation>Ist die Tabelle abgeschnitten oder mit Dezimalkommas geschrieben?</translation>
    </message>
    <message>
        <source>Time goes back at line {0} of {1}: from {2} s to {3} s.</source>
        <translation>In Zeile {0} von {1} läuft die Zeit zurück: von {2} s auf {3} s.</translation>
    </message>
    <message>
        <source>Are two recordings in one table, or is this not the column of times?</source>
        <translation>Stehen zwei Aufzeichnungen in einer Tabelle, oder ist dies nicht die Zeitspalte?</translation>
    </message>
    <message>
        <source>{0} is {1} kPa, stiffer than any soft tissue.</source>
        <translation>{0} ist {1} kPa, steifer als jedes Weichgewebe.</translation>
    </message>
    <message>
        <source>Was it given in Pa?</source>
        <translation>Wurde es in Pa angegeben?</translation>
    </message>
    <message>
        <source>Use the model.json that glisson-cli explain wrote for an experiment of this kind.</source>
        <translation>Verwenden Sie die model.json, die glisson-cli explain für ein Experiment dieser Art geschrieben hat.</translation>
    </message>
    <message>
        <source>{0} is not a model of the format {1}.</source>
        <translation>{0} ist kein Modell im Format {1}.</translation>
    </message>
    <message>
        <source>{0} was not learnt from an experiment of the kind {1}.</source>
        <translation>{0} wurde nicht aus einem Experiment der Art {1} gelernt.</translation>
    </message>
    <message>
        <source>{0} is not a complete model.</source>
        <translation>{0} ist kein vollständiges Modell.</translation>
    </message>
    <message>
        <source>The effect {0} is unknown to this experiment.</source>
        <translation>Der Effekt {0} ist diesem Experiment unbekannt.</translation>
    </message>
    <message>
        <source>{0} of {1} is no number.</source>
        <translation>{0} von {1} ist keine Zahl.</translation>
    </message>
    <message>
        <source>The smooth correction was made for other quantities than this experiment has.</source>
        <translation>Die glatte Korrektur wurde für andere Größen gemacht, als dieses Experiment hat.</translation>
    </message>
    <message>
        <source>The smooth correction is not complete.</source>
        <translation>Die glatte Korrektur ist nicht vollständig.</translation>
    </message>
    <message>
        <source>The search for parameters failed: {0}.</source>
        <translation>Die Suche nach Parametern ist fehlgeschlagen: {0}.</translation>
    </message>
    <message>
        <source>The model has no solution where the search ended.</source>
        <translation>Das Modell hat dort, wo die Suche endete, keine Lösung.</translation>
    </message>
    <message>
        <source>This experiment proposes no further trials.</source>
        <translation>Dieses Experiment schlägt keine weiteren Versuche vor.</translation>
    </message>
    <message>
        <source>The specimen is stiffer or softer than declared, everywhere and at every load.</source>
        <translation>Der Prüfkörper ist steifer oder weicher als angegeben, überall und bei jeder Last.</translation>
    </message>
    <message>
        <source>The specimen is not equally stiff under tension and under compression.</source>
        <translation>Der Prüfkörper ist auf Zug und auf Druck nicht gleich steif.</translation>
    </message>
    <message>
        <source>The tissue gets stiffer (or softer) the further it is deformed: its law is not a straight line.</source>
        <translation>Das Gewebe wird mit zunehmender Verformung steifer (oder weicher): Sein Gesetz ist keine Gerade.</translation>
    </message>
    <message>
        <source>The tissue gives way slowly under a load that is held, and recovers slowly after it.</source>
        <translation>Das Gewebe gibt unter gehaltener Last langsam nach und erholt sich danach langsam.</translation>
    </message>
    <message>
        <source>Once stretched, the tissue stays softer up to the deformation that it has seen (Mullins effect).</source>
        <translation>Einmal gedehnt, bleibt das Gewebe bis zu der erlebten Verformung weicher (Mullins-Effekt).</translation>
    </message>
    <message>
        <source>Less force comes back on the way out than went in on the way in, in every cycle and at any speed.</source>
        <translation>Beim Entlasten kommt weniger Kraft zurück, als beim Belasten hineinging, in jedem Zyklus und bei jeder Geschwindigkeit.</translation>
    </message>
    <message>
        <source>The load cell is at fault: it does not read zero without load, or its scale is off.</source>
        <translation>Die Kraftmessdose ist fehlerhaft: Sie zeigt ohne Last nicht null, oder ihr Maßstab stimmt nicht.</translation>
    </message>
    <message>
        <source>The specimen was already loaded when the test began.</source>
        <translation>Der Prüfkörper war schon belastet, als der Versuch begann.</translation>
    </message>
    <message>
        <source>The mode &quot;{0}&quot; is not known.</source>
        <translation>Der Modus „{0}“ ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The modes are compression, tension and shear.</source>
        <translation>Die Modi sind compression, tension und shear.</translation>
    </message>
    <message>
        <source>The declared law &quot;{0}&quot; is not known.</source>
        <translation>Das angegebene Gesetz „{0}“ ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The laws are linear and neo-hookean.</source>
        <translation>Die Gesetze sind linear und neo-hookean.</translation>
    </message>
    <message>
        <source>{0} gives &quot;{1}&quot;, which needs the specimen&apos;s {2}.</source>
        <translation>{0} gibt &quot;{1}&quot; an; dazu wird {2} des Prüfkörpers gebraucht.</translation>
    </message>
    <message>
        <source>Give the specimen&apos;s diameter_mm (or width_mm and thickness_mm, or area_mm2) and height_mm.</source>
        <translation>Geben Sie diameter_mm des Prüfkörpers an (oder width_mm und thickness_mm, oder area_mm2) sowie height_mm.</translation>
    </message>
    <message>
        <source>In {0} stress and strain mostly have opposite signs.</source>
        <translation>In {0} haben Spannung und Dehnung meist entgegengesetzte Vorzeichen.</translation>
    </message>
    <message>
        <source>In compression stretch is below 1, and displacement, force and stress are negative.</source>
        <translation>Bei Druck ist die Streckung kleiner als 1, und Weg, Kraft und Spannung sind negativ.</translation>
    </message>
    <message>
        <source>{0} names no column for &quot;stretch&quot; or &quot;displacement_mm&quot;.</source>
        <translation>{0} nennt keine Spalte für &quot;stretch&quot; oder &quot;displacement_mm&quot;.</translation>
    </message>
    <message>
        <source>{0} names no column for &quot;stress_kPa&quot; or &quot;force_N&quot;.</source>
        <translation>{0} nennt keine Spalte für &quot;stress_kPa&quot; oder &quot;force_N&quot;.</translation>
    </message>
    <message>
        <source>Line {0} of {1} gives a stretch of {2}, which no specimen survives.</source>
        <translation>Zeile {0} von {1} gibt eine Streckung von {2} an, die kein Prüfkörper übersteht.</translation>
    </message>
    <message>
        <source>Is it strain, or a percentage? Stretch is length over length at rest.</source>
        <translation>Ist es die Dehnung oder ein Prozentwert? Streckung ist Länge durch Ruhelänge.</translation>
    </message>
    <message>
        <source>The material law is used beyond the stretch it allows.</source>
        <translation>Das Materialgesetz wird jenseits der Streckung benutzt, die es zulässt.</translation>
    </message>
    <message>
        <source>The specimen in {0} is {1} mm across.</source>
        <translation>Der Prüfkörper in {0} misst {1} mm.</translation>
    </message>
    <message>
        <source>Is the mesh in metres or micrometres?</source>
        <translation>Ist das Netz in Metern oder Mikrometern?</translation>
    </message>
    <message>
        <source>{0} has no cell array &quot;{1}&quot; with one number a cell.</source>
        <translation>{0} hat kein Zellfeld „{1}“ mit einer Zahl je Zelle.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus must be above zero in every cell.</source>
        <translation>Der Elastizitätsmodul muss in jeder Zelle größer als null sein.</translation>
    </message>
    <message>
        <source>{0} must lie between -1 and 0.5, both excluded.</source>
        <translation>{0} muss zwischen -1 und 0.5 liegen, beide ausgeschlossen.</translation>
    </message>
    <message>
        <source>Line 1 of {0} names no column &quot;{1}&quot;.</source>
        <translation>Zeile 1 von {0} nennt keine Spalte „{1}“.</translation>
    </message>
    <message>
        <source>A table of markers has id, rest_x_mm, rest_y_mm, rest_z_mm, x_mm, y_mm, z_mm.</source>
        <translation>Eine Tabelle von Markern hat id, rest_x_mm, rest_y_mm, rest_z_mm, x_mm, y_mm, z_mm.</translation>
    </message>
    <message>
        <source>{0} holds no markers.</source>
        <translation>{0} enthält keine Marker.</translation>
    </message>
    <message>
        <source>All markers of {0} lie within {1} mm (line 2 on), on a specimen of {2} mm.</source>
        <translation>Alle Marker von {0} liegen innerhalb von {1} mm (ab Zeile 2), auf einem Prüfkörper von {2} mm.</translation>
    </message>
    <message>
        <source>Are they in metres?</source>
        <translation>Sind sie in Metern?</translation>
    </message>
    <message>
        <source>Line {0} of {1}: marker {2} lies {3} mm outside the specimen at rest.</source>
        <translation>Zeile {0} von {1}: Marker {2} liegt {3} mm außerhalb des ruhenden Prüfkörpers.</translation>
    </message>
    <message>
        <source>Are markers and mesh in one frame (patient coordinates) and both in mm?</source>
        <translation>Sind Marker und Netz im selben Bezugssystem (Patientenkoordinaten) und beide in mm?</translation>
    </message>
    <message>
        <source>Line {0} of {1}: marker {2} moved by {3} mm, more than the specimen is long.</source>
        <translation>Zeile {0} von {1}: Marker {2} hat sich um {3} mm bewegt, mehr als die Länge des Prüfkörpers.</translation>
    </message>
    <message>
        <source>Are the positions in another unit or frame than the positions at rest?</source>
        <translation>Haben die Positionen eine andere Einheit oder ein anderes Bezugssystem als die Ruhepositionen?</translation>
    </message>
    <message>
        <source>{0}: a force of {1} N presses no soft specimen.</source>
        <translation>{0}: Eine Kraft von {1} N drückt auf keinen weichen Prüfkörper.</translation>
    </message>
    <message>
        <source>Was it given in mN?</source>
        <translation>Wurde sie in mN angegeben?</translation>
    </message>
    <message>
        <source>{0} must not be zero.</source>
        <translation>{0} darf nicht null sein.</translation>
    </message>
    <message>
        <source>Trial {0} (line {1} of {2}) has no samples.</source>
        <translation>Versuch {0} (Zeile {1} von {2}) hat keine Messpunkte.</translation>
    </message>
    <message>
        <source>Was the recording interrupted?</source>
        <translation>Wurde die Aufzeichnung unterbrochen?</translation>
    </message>
    <message>
        <source>In trial {0} (line {1} of {2}) time goes back at sample {3}.</source>
        <translation>In Versuch {0} (Zeile {1} von {2}) läuft die Zeit bei Messpunkt {3} zurück.</translation>
    </message>
    <message>
        <source>Are two recordings in one trial?</source>
        <translation>Stehen zwei Aufzeichnungen in einem Versuch?</translation>
    </message>
    <message>
        <source>No sample of trial {0} (line {1} of {2}) names markers.</source>
        <translation>Kein Messpunkt von Versuch {0} (Zeile {1} von {2}) nennt Marker.</translation>
    </message>
    <message>
        <source>Preparing the specimen</source>
        <translation>Prüfkörper wird vorbereitet</translation>
    </message>
    <message>
        <source>No sample of the experiment has markers.</source>
        <translation>Kein Messpunkt des Experiments hat Marker.</translation>
    </message>
    <message>
        <source>Solved the declared specimen</source>
        <translation>Angegebener Prüfkörper gelöst</translation>
    </message>
    <message>
        <source>The specimen&apos;s equations are too badly conditioned to be solved.</source>
        <translation>Die Gleichungen des Prüfkörpers sind zu schlecht konditioniert, um gelöst zu werden.</translation>
    </message>
    <message>
        <source>No equilibrium of a specimen that stiffens so strongly was found under these loads.</source>
        <translation>Für einen Prüfkörper, der sich so stark versteift, wurde unter diesen Lasten kein Gleichgewicht gefunden.</translation>
    </message>
    <message>
        <source>The battery&apos;s voltage falls under load: its own resistance turns energy into heat.</source>
        <translation>Die Spannung des Akkus sinkt unter Last: Sein Innenwiderstand macht aus Energie Wärme.</translation>
    </message>
    <message>
        <source>The battery&apos;s voltage falls under load, and what is lost there is what warms it.</source>
        <translation>Die Spannung des Akkus sinkt unter Last, und was dort verloren geht, erwärmt ihn.</translation>
    </message>
    <message>
        <source>The faster the battery is emptied, the less it gives (Peukert).</source>
        <translation>Je schneller der Akku entladen wird, desto weniger gibt er her (Peukert).</translation>
    </message>
    <message>
        <source>The battery gives less when it is cold and more when it is warm.</source>
        <translation>Der Akku gibt bei Kälte weniger und bei Wärme mehr her.</translation>
    </message>
    <message>
        <source>The battery&apos;s voltage falls while it empties, which a constant voltage leaves out.</source>
        <translation>Die Spannung des Akkus sinkt beim Entladen, was eine konstante Spannung nicht erfasst.</translation>
    </message>
    <message>
        <source>The computer draws power whatever it does, more than was declared.</source>
        <translation>Der Rechner nimmt, was immer er tut, mehr Leistung auf als angegeben.</translation>
    </message>
    <message>
        <source>A part of the power is lost in the supply before it reaches the computer.</source>
        <translation>Ein Teil der Leistung geht in der Versorgung verloren, bevor er den Rechner erreicht.</translation>
    </message>
    <message>
        <source>The warmer the computer gets, the more power it draws.</source>
        <translation>Je wärmer der Rechner wird, desto mehr Leistung nimmt er auf.</translation>
    </message>
    <message>
        <source>The work itself takes power that was not declared.</source>
        <translation>Die Arbeit selbst braucht Leistung, die nicht angegeben war.</translation>
    </message>
    <message>
        <source>The computer slows itself down to stay below a temperature.</source>
        <translation>Der Rechner drosselt sich, um unter einer Temperatur zu bleiben.</translation>
    </message>
    <message>
        <source>Heat leaves the computer better or worse than declared.</source>
        <translation>Die Wärme verlässt den Rechner besser oder schlechter als angegeben.</translation>
    </message>
    <message>
        <source>The computer takes time to warm up, longer or shorter than declared.</source>
        <translation>Der Rechner braucht Zeit, um warm zu werden, länger oder kürzer als angegeben.</translation>
    </message>
    <message>
        <source>&quot;noise&quot; names no quantity, so that nothing can be judged.</source>
        <translation>&quot;noise&quot; nennt keine Größe, sodass sich nichts beurteilen lässt.</translation>
    </message>
    <message>
        <source>Give voltage_V, temperature_C or power_W: the standard deviation of that reading.</source>
        <translation>Geben Sie voltage_V, temperature_C oder power_W an: die Standardabweichung dieser Ablesung.</translation>
    </message>
    <message>
        <source>The law of platforms is constant: a battery that gives all of its energy at any load.</source>
        <translation>Das Gesetz der Geräte ist konstant: ein Akku, der bei jeder Last seine ganze Energie abgibt.</translation>
    </message>
    <message>
        <source>{0} must not be below zero.</source>
        <translation>{0} darf nicht kleiner als null sein.</translation>
    </message>
    <message>
        <source>Line {0} of {1} gives a {2} of {3}, which no worn computer reaches.</source>
        <translation>Zeile {0} von {1} gibt {2} mit {3} an, was kein getragener Rechner erreicht.</translation>
    </message>
    <message>
        <source>{0} has no column for a quantity whose noise is given.</source>
        <translation>{0} hat keine Spalte für eine Größe, deren Rauschen angegeben ist.</translation>
    </message>
    <message>
        <source>The declared figures predict none of the recorded quantities.</source>
        <translation>Die angegebenen Werte sagen keine der aufgezeichneten Größen vorher.</translation>
    </message>
    <message>
        <source>Voltage needs nominal_voltage_V, temperature needs thermal_resistance_C_per_W and a power, power needs a current or a load.</source>
        <translation>Für die Spannung wird nominal_voltage_V gebraucht, für die Temperatur thermal_resistance_C_per_W und eine Leistung, für die Leistung ein Strom oder eine Last.</translation>
    </message>
    <message>
        <source>The model of the platform has no finite answer here.</source>
        <translation>Das Modell des Geräts hat hier keine endliche Antwort.</translation>
    </message>
    <message>
        <source>it is proportional to the prediction</source>
        <translation>es ist proportional zur Vorhersage</translation>
    </message>
    <message>
        <source>it changes with the load</source>
        <translation>es ändert sich mit der Last</translation>
    </message>
    <message>
        <source>it changes with time</source>
        <translation>es ändert sich mit der Zeit</translation>
    </message>
    <message>
        <source>it has a mean in some direction</source>
        <translation>es hat in einer Richtung einen Mittelwert</translation>
    </message>
    <message>
        <source>it changes across the specimen</source>
        <translation>es ändert sich über den Prüfkörper hinweg</translation>
    </message>
    <message>
        <source>it differs from trial to trial</source>
        <translation>es unterscheidet sich von Versuch zu Versuch</translation>
    </message>
    <message>
        <source>it is larger than the noise</source>
        <translation>es ist größer als das Rauschen</translation>
    </message>
    <message>
        <source>neighbours are off in the same way</source>
        <translation>Nachbarn weichen auf gleiche Weise ab</translation>
    </message>
    <message>
        <source>trying effects</source>
        <translation>Effekte werden probiert</translation>
    </message>
    <message>
        <source>Only an experiment whose trials are measured can be explained.</source>
        <translation>Nur ein Experiment, dessen Versuche gemessen sind, kann erklärt werden.</translation>
    </message>
    <message>
        <source>predicting with the declared model</source>
        <translation>Vorhersage mit dem angegebenen Modell</translation>
    </message>
    <message>
        <source>weighing the evidence</source>
        <translation>Belege werden abgewogen</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>No voxel of the stiffness map is reliable: none is positive, confident, inside the organ and {0} mm away from its border at once.</source>
        <translation>Kein Voxel der Steifigkeitskarte ist verlässlich: Keines ist zugleich positiv, vertrauenswürdig, im Organ und {0} mm von dessen Rand entfernt.</translation>
    </message>
    <message>
        <source>Check that map, confidence mask and segmentation belong together, or trust voxels nearer to the border.</source>
        <translation>Prüfen Sie, ob Karte, Konfidenzmaske und Segmentierung zusammengehören, oder vertrauen Sie Voxeln näher am Rand.</translation>
    </message>
    <message>
        <source>The model does not lie in the stiffness map: {0} mm are between their boxes (model around {1}, map around {2}).</source>
        <translation>Das Modell liegt nicht in der Steifigkeitskarte: {0} mm trennen ihre Quader (Modell um {1}, Karte um {2}).</translation>
    </message>
    <message>
        <source>They are probably in different frames of reference: take the stiffness series of the same study, or register the two.</source>
        <translation>Wahrscheinlich sind sie in verschiedenen Bezugssystemen: Nehmen Sie die Steifigkeitsserie derselben Studie, oder registrieren Sie beide.</translation>
    </message>
    <message>
        <source>There are no cells to give a stiffness to.</source>
        <translation>Es gibt keine Zellen, denen eine Steifigkeit zu geben wäre.</translation>
    </message>
    <message>
        <source>The stiffness map holds no voxels.</source>
        <translation>Die Steifigkeitskarte enthält keine Voxel.</translation>
    </message>
    <message>
        <source>The axes of the stiffness map are not at right angles, so that the nearest voxel is not to be told.</source>
        <translation>Die Achsen der Steifigkeitskarte stehen nicht senkrecht aufeinander, sodass sich das nächste Voxel nicht bestimmen lässt.</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio must lie in (-1, 0.5], the border must not be negative and the averaging length must be positive; they are {0}, {1} mm and {2} mm.</source>
        <translation>Die Querkontraktionszahl muss in (-1, 0.5] liegen, der Rand darf nicht negativ und die Mittelungslänge muss positiv sein; sie sind {0}, {1} mm und {2} mm.</translation>
    </message>
    <message>
        <source>There are no wave or phase images.</source>
        <translation>Es gibt keine Wellen- oder Phasenbilder.</translation>
    </message>
    <message>
        <source>Unwrapping the phase</source>
        <translation>Phase wird entfaltet</translation>
    </message>
    <message>
        <source>The waves give no signal inside the organ.</source>
        <translation>Die Wellen geben im Organ kein Signal.</translation>
    </message>
    <message>
        <source>Check that the segmentation and the wave images belong together.</source>
        <translation>Prüfen Sie, ob Segmentierung und Wellenbilder zusammengehören.</translation>
    </message>
    <message>
        <source>Inverting the waves</source>
        <translation>Wellen werden invertiert</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Invertiert</translation>
    </message>
    <message>
        <source>Not one voxel could be inverted with confidence: there is no wave in these images, or it drowns in noise.</source>
        <translation>Kein einziges Voxel ließ sich mit Konfidenz invertieren: In diesen Bildern ist keine Welle, oder sie geht im Rauschen unter.</translation>
    </message>
    <message>
        <source>Check that the phase series and the frequency are the right ones.</source>
        <translation>Prüfen Sie, ob Phasenserie und Frequenz die richtigen sind.</translation>
    </message>
    <message>
        <source>The region lies on another voxel grid than the map.</source>
        <translation>Die Region liegt auf einem anderen Voxelgitter als die Karte.</translation>
    </message>
    <message>
        <source>The region holds no value.</source>
        <translation>Die Region enthält keinen Wert.</translation>
    </message>
    <message>
        <source>The wave images do not all lie on one grid.</source>
        <translation>Die Wellenbilder liegen nicht alle auf einem Gitter.</translation>
    </message>
    <message>
        <source>The headers do not say at which frequency the organ was shaken.</source>
        <translation>Die Kopfdaten sagen nicht, mit welcher Frequenz das Organ in Schwingung versetzt wurde.</translation>
    </message>
    <message>
        <source>Give it with --frequency-Hz; liver scans mostly use 60.</source>
        <translation>Geben Sie sie mit --frequency-Hz an; bei der Leber sind es meist 60.</translation>
    </message>
    <message>
        <source>A vibration of {0} Hz is not possible.</source>
        <translation>Eine Schwingung von {0} Hz ist nicht möglich.</translation>
    </message>
    <message>
        <source>The headers do not say which of the {0} wave images belong to which direction.</source>
        <translation>Die Kopfdaten sagen nicht, welche der {0} Wellenbilder zu welcher Richtung gehören.</translation>
    </message>
    <message>
        <source>Say how many directions were measured with --directions; mostly 1 or 3.</source>
        <translation>Sagen Sie mit --directions, wie viele Richtungen gemessen wurden; meist 1 oder 3.</translation>
    </message>
    <message>
        <source>{0} wave images cannot be shared out among {1} directions.</source>
        <translation>{0} Wellenbilder lassen sich nicht auf {1} Richtungen aufteilen.</translation>
    </message>
    <message>
        <source>At {0} Hz direction {1} has {2} instants and the first direction {3}.</source>
        <translation>Bei {0} Hz hat Richtung {1} {2} Zeitpunkte und die erste Richtung {3}.</translation>
    </message>
    <message>
        <source>Only {0} instants of the wave were measured; at least {1} are needed to tell the wave from noise.</source>
        <translation>Nur {0} Zeitpunkte der Welle wurden gemessen; mindestens {1} sind nötig, um Welle und Rauschen zu trennen.</translation>
    </message>
    <message>
        <source>The curl needs the motion along three known directions, in at least three slices.</source>
        <translation>Die Rotation braucht die Bewegung in drei bekannten Richtungen, in mindestens drei Schichten.</translation>
    </message>
    <message>
        <source>Take long waves off with the high-pass instead.</source>
        <translation>Entfernen Sie lange Wellen stattdessen mit dem Hochpass.</translation>
    </message>
    <message>
        <source>A cutting plane needs a finite point and a normal that is not zero.</source>
        <translation>Eine Schnittebene braucht einen endlichen Punkt und eine Normale ungleich null.</translation>
    </message>
    <message>
        <source>A cutting sheet needs 3 to {0} points; there are {1}.</source>
        <translation>Eine Schnittfläche braucht 3 bis {0} Punkte; es sind {1}.</translation>
    </message>
    <message>
        <source>A point of the cutting sheet is not finite.</source>
        <translation>Ein Punkt der Schnittfläche ist nicht endlich.</translation>
    </message>
    <message>
        <source>The points of the cutting sheet lie almost on a line, which does not say which way to cut: add points away from it, or give a plane.</source>
        <translation>Die Punkte der Schnittfläche liegen fast auf einer Geraden, was nicht sagt, wie zu schneiden ist: Fügen Sie Punkte abseits davon hinzu, oder geben Sie eine Ebene an.</translation>
    </message>
    <message>
        <source>Points {0} and {1} of the cutting sheet lie above each other: no smooth sheet over their plane passes through both.</source>
        <translation>Die Punkte {0} und {1} der Schnittfläche liegen übereinander: Keine glatte Fläche über ihrer Ebene geht durch beide.</translation>
    </message>
    <message>
        <source>No smooth sheet passes through the points of the cut.</source>
        <translation>Keine glatte Fläche geht durch die Punkte des Schnitts.</translation>
    </message>
    <message>
        <source>The surface is in pieces, between which there is no way along it.</source>
        <translation>Die Oberfläche besteht aus Stücken, zwischen denen kein Weg auf ihr liegt.</translation>
    </message>
    <message>
        <source>Keep its largest piece.</source>
        <translation>Behalten Sie ihr größtes Stück.</translation>
    </message>
    <message>
        <source>Triangle {0} does not fit its neighbours: an edge has more than two triangles, or they are turned against each other.</source>
        <translation>Dreieck {0} passt nicht zu seinen Nachbarn: Eine Kante hat mehr als zwei Dreiecke, oder sie sind gegeneinander gedreht.</translation>
    </message>
    <message>
        <source>Heat cannot spread over the surface: it has flat triangles.</source>
        <translation>Wärme kann sich auf der Oberfläche nicht ausbreiten: Sie hat entartete Dreiecke.</translation>
    </message>
    <message>
        <source>{0} cannot be read as a mesh: {1}.</source>
        <translation>{0} kann nicht als Netz gelesen werden: {1}.</translation>
    </message>
    <message>
        <source>Open it in ParaView to see whether it is damaged.</source>
        <translation>Öffnen Sie es in ParaView, um zu sehen, ob es beschädigt ist.</translation>
    </message>
    <message>
        <source>it names no dataset</source>
        <translation>es nennt keinen Datensatz</translation>
    </message>
    <message>
        <source>its points are not all there</source>
        <translation>seine Punkte sind nicht vollständig</translation>
    </message>
    <message>
        <source>its cell types are not all there</source>
        <translation>seine Zelltypen sind nicht vollständig</translation>
    </message>
    <message>
        <source>it has not as many cell types as cells</source>
        <translation>es hat nicht so viele Zelltypen wie Zellen</translation>
    </message>
    <message>
        <source>a field says not how many arrays it has</source>
        <translation>ein Feld sagt nicht, wie viele Arrays es hat</translation>
    </message>
    <message>
        <source>an array before its cells is not all there, or is text</source>
        <translation>ein Array vor seinen Zellen ist nicht vollständig oder ist Text</translation>
    </message>
    <message>
        <source>{0} has no extension that is known for such a mesh.</source>
        <translation>{0} hat keine Endung, die für ein solches Netz bekannt ist.</translation>
    </message>
    <message>
        <source>it holds no points</source>
        <translation>es enthält keine Punkte</translation>
    </message>
    <message>
        <source>a cell names a point that does not exist</source>
        <translation>eine Zelle nennt einen Punkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>its polygons cannot be cut into triangles</source>
        <translation>seine Polygone lassen sich nicht in Dreiecke zerlegen</translation>
    </message>
    <message>
        <source>Cell {1} of {0} is a {2} of {3} points; only tetrahedra are used.</source>
        <translation>Zelle {1} von {0} ist {2} mit {3} Punkten; nur Tetraeder werden verwendet.</translation>
    </message>
    <message>
        <source>Cut it into tetrahedra first, for example with ParaView&apos;s Tetrahedralize.</source>
        <translation>Zerlegen Sie es zuerst in Tetraeder, zum Beispiel mit Tetrahedralize von ParaView.</translation>
    </message>
    <message>
        <source>it holds no tetrahedra</source>
        <translation>es enthält keine Tetraeder</translation>
    </message>
    <message>
        <source>The header of {0} announces {1} items; a file of {2} bytes cannot hold them.</source>
        <translation>Die Kopfdaten von {0} kündigen {1} Einträge an; eine Datei von {2} Bytes kann sie nicht enthalten.</translation>
    </message>
    <message>
        <source>The file is damaged or cut off; get it again from where it came.</source>
        <translation>Die Datei ist beschädigt oder abgeschnitten; holen Sie sie erneut von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Line {1} of {0} is neither a point nor a face.</source>
        <translation>Zeile {1} von {0} ist weder ein Punkt noch eine Fläche.</translation>
    </message>
    <message>
        <source>Line {1} of {0} is not what an OFF file holds there.</source>
        <translation>Zeile {1} von {0} ist nicht das, was dort in einer OFF-Datei steht.</translation>
    </message>
    <message>
        <source>its header is not that of a PLY file</source>
        <translation>seine Kopfdaten sind nicht die einer PLY-Datei</translation>
    </message>
    <message>
        <source>Point {0} of the surface has no finite position.</source>
        <translation>Punkt {0} der Oberfläche hat keine endliche Position.</translation>
    </message>
    <message>
        <source>Triangle {0} names point {1}; the surface has {2} points.</source>
        <translation>Dreieck {0} nennt Punkt {1}; die Oberfläche hat {2} Punkte.</translation>
    </message>
    <message>
        <source>The surface holds no triangles.</source>
        <translation>Die Oberfläche enthält keine Dreiecke.</translation>
    </message>
    <message>
        <source>The mesh holds no tetrahedra.</source>
        <translation>Das Netz enthält keine Tetraeder.</translation>
    </message>
    <message>
        <source>Tetrahedron {0} names point {1}; the mesh has {2} points.</source>
        <translation>Tetraeder {0} nennt Punkt {1}; das Netz hat {2} Punkte.</translation>
    </message>
    <message>
        <source>Point {0} of the mesh has no finite position.</source>
        <translation>Punkt {0} des Netzes hat keine endliche Position.</translation>
    </message>
    <message>
        <source>Tetrahedron {0} is flat or inside out: its volume is {1} mm3.</source>
        <translation>Tetraeder {0} ist flach oder umgestülpt: Sein Volumen ist {1} mm3.</translation>
    </message>
    <message>
        <source>The face of the points {0}, {1} and {2} belongs to {3} tetrahedra; at most two can.</source>
        <translation>Die Fläche der Punkte {0}, {1} und {2} gehört zu {3} Tetraedern; höchstens zwei sind möglich.</translation>
    </message>
    <message>
        <source>The mesh falls in {0} parts that share no face, of {1} tetrahedra.</source>
        <translation>Das Netz zerfällt in {0} Teile ohne gemeinsame Fläche, mit {1} Tetraedern.</translation>
    </message>
    <message>
        <source>Keep the largest part, or join them before meshing.</source>
        <translation>Behalten Sie den größten Teil, oder verbinden Sie die Teile vor dem Vernetzen.</translation>
    </message>
    <message>
        <source>{0} is deflated as a whole, which is not read.</source>
        <translation>{0} ist als Ganzes komprimiert (Deflate); das wird nicht gelesen.</translation>
    </message>
    <message>
        <source>Convert it first, for example with dcmconv +te.</source>
        <translation>Wandeln Sie es zuerst um, zum Beispiel mit dcmconv +te.</translation>
    </message>
    <message>
        <source>{0} is empty.</source>
        <translation>{0} ist leer.</translation>
    </message>
    <message>
        <source>{0} declares a length beyond its end in its first lines.</source>
        <translation>{0} gibt in seinen ersten Zeilen eine Länge jenseits seines Endes an.</translation>
    </message>
    <message>
        <source>{0} is no DICOM file, nor named as one of the volume files that are read.</source>
        <translation>{0} ist keine DICOM-Datei und heißt auch nicht wie eine lesbare Volumendatei.</translation>
    </message>
    <message>
        <source>The header of {0} is too large to be that of an image.</source>
        <translation>Die Kopfdaten von {0} sind zu groß für die eines Bildes.</translation>
    </message>
    <message>
        <source>{0} is damaged: an item stands outside a sequence at byte {1}.</source>
        <translation>{0} ist beschädigt: Bei Byte {1} steht ein Eintrag außerhalb einer Sequenz.</translation>
    </message>
    <message>
        <source>{0} is damaged: a value without a length stands at byte {1}.</source>
        <translation>{0} ist beschädigt: Bei Byte {1} steht ein Wert ohne Länge.</translation>
    </message>
    <message>
        <source>{0} ends at byte {1}, in the middle of its header.</source>
        <translation>{0} endet bei Byte {1}, mitten in den Kopfdaten.</translation>
    </message>
    <message>
        <source>{0} is damaged: the length at byte {1} leaves what encloses it.</source>
        <translation>{0} ist beschädigt: Die Länge bei Byte {1} verlässt, was sie umschließt.</translation>
    </message>
    <message>
        <source>{0} ends at byte {1}, in the middle of a sequence.</source>
        <translation>{0} endet bei Byte {1}, mitten in einer Sequenz.</translation>
    </message>
    <message>
        <source>{0} is damaged: a sequence holds something else than items at byte {1}.</source>
        <translation>{0} ist beschädigt: Bei Byte {1} enthält eine Sequenz anderes als Einträge.</translation>
    </message>
    <message>
        <source>{0} is damaged: its pixels are not stored in the way its transfer syntax {1} says.</source>
        <translation>{0} ist beschädigt: Seine Pixel sind nicht so gespeichert, wie seine Transfersyntax {1} sagt.</translation>
    </message>
    <message>
        <source>{0} is cut short: {1} of {2} bytes of its pixels are there.</source>
        <translation>{0} ist abgeschnitten: {1} von {2} Bytes seiner Pixel sind da.</translation>
    </message>
    <message>
        <source>{0} is damaged: its compressed pixels are broken at byte {1}.</source>
        <translation>{0} ist beschädigt: Seine komprimierten Pixel sind bei Byte {1} zerstört.</translation>
    </message>
    <message>
        <source>The pixels of {0} are in too many pieces.</source>
        <translation>Die Pixel von {0} sind in zu vielen Stücken.</translation>
    </message>
    <message>
        <source>{0} is cut short in its compressed pixels, at byte {1}.</source>
        <translation>{0} ist in seinen komprimierten Pixeln abgeschnitten, bei Byte {1}.</translation>
    </message>
    <message>
        <source>{0} is damaged: no value type is known for what stands at byte {1}.</source>
        <translation>{0} ist beschädigt: Für das, was bei Byte {1} steht, ist kein Werttyp bekannt.</translation>
    </message>
    <message>
        <source>{0} nests its sequences more than {1} deep, which no image does.</source>
        <translation>{0} verschachtelt seine Sequenzen mehr als {1} tief, was kein Bild tut.</translation>
    </message>
    <message>
        <source>Copy the file again from where it came.</source>
        <translation>Kopieren Sie die Datei erneut von ihrer Quelle.</translation>
    </message>
    <message>
        <source>The compressed pixels of {0} are damaged.</source>
        <translation>Die komprimierten Pixel von {0} sind beschädigt.</translation>
    </message>
    <message>
        <source>{0} is compressed in a way that is not read (transfer syntax {1}).</source>
        <translation>{0} ist auf eine Art komprimiert, die nicht gelesen wird (Transfersyntax {1}).</translation>
    </message>
    <message>
        <source>Convert it to an uncompressed or JPEG form first.</source>
        <translation>Wandeln Sie es zuerst in eine unkomprimierte oder JPEG-Form um.</translation>
    </message>
    <message>
        <source>The compressed picture of {0} is {1} x {2} with {3} bits, where its header says {4} x {5} with {6}.</source>
        <translation>Das komprimierte Bild von {0} hat {1} x {2} Pixel mit {3} Bit, wo die Kopfdaten {4} x {5} mit {6} sagen.</translation>
    </message>
    <message>
        <source>{0} lies inside {1}, which is only read.</source>
        <translation>{0} liegt in {1}, das nur gelesen wird.</translation>
    </message>
    <message>
        <source>Choose a folder elsewhere for the files without identity.</source>
        <translation>Wählen Sie für die Dateien ohne Identität einen Ordner anderswo.</translation>
    </message>
    <message>
        <source>removing identity</source>
        <translation>Identität wird entfernt</translation>
    </message>
    <message>
        <source>{0} holds no DICOM file.</source>
        <translation>{0} enthält keine DICOM-Datei.</translation>
    </message>
    <message>
        <source>Give the folder or the file that holds the images.</source>
        <translation>Geben Sie den Ordner oder die Datei an, die die Bilder enthält.</translation>
    </message>
    <message>
        <source>{0} cannot be read: {1}.</source>
        <translation>{0} kann nicht gelesen werden: {1}.</translation>
    </message>
    <message>
        <source>Check the path and your rights there.</source>
        <translation>Prüfen Sie den Pfad und Ihre Rechte dort.</translation>
    </message>
    <message>
        <source>{0} holds no image, or is damaged.</source>
        <translation>{0} enthält kein Bild oder ist beschädigt.</translation>
    </message>
    <message>
        <source>{0} declares impossible pixels: {1} of {2} bits, the highest {3}.</source>
        <translation>{0} gibt unmögliche Pixel an: {1} von {2} Bit, das höchste {3}.</translation>
    </message>
    <message>
        <source>{0} declares compressed pictures too large to be true.</source>
        <translation>{0} gibt komprimierte Bilder an, die zu groß sind, um wahr zu sein.</translation>
    </message>
    <message>
        <source>{0} holds {1} of the {2} frames that it declares.</source>
        <translation>{0} enthält {1} der {2} Bilder, die es angibt.</translation>
    </message>
    <message>
        <source>{0} holds {1} bytes of pixels, but its size in pixels asks for {2}.</source>
        <translation>{0} enthält {1} Bytes an Pixeln, aber seine Größe verlangt {2}.</translation>
    </message>
    <message>
        <source>{0} is damaged: its header cannot be understood.</source>
        <translation>{0} ist beschädigt: Die Kopfdaten sind nicht zu verstehen.</translation>
    </message>
    <message>
        <source>{0} is DICOM, but holds no picture ({1}).</source>
        <translation>{0} ist DICOM, enthält aber kein Bild ({1}).</translation>
    </message>
    <message>
        <source>{0} is no directory of DICOM files.</source>
        <translation>{0} ist kein Verzeichnis von DICOM-Dateien (DICOMDIR).</translation>
    </message>
    <message>
        <source>Open the folder itself instead.</source>
        <translation>Öffnen Sie stattdessen den Ordner selbst.</translation>
    </message>
    <message>
        <source>Export the segmentation again, as binary and uncompressed DICOM SEG.</source>
        <translation>Exportieren Sie die Segmentierung erneut, als binäres, unkomprimiertes DICOM SEG.</translation>
    </message>
    <message>
        <source>{0} is not a DICOM segmentation.</source>
        <translation>{0} ist keine DICOM-Segmentierung.</translation>
    </message>
    <message>
        <source>The segmentation {0} is compressed (or big endian).</source>
        <translation>Die Segmentierung {0} ist komprimiert (oder Big Endian).</translation>
    </message>
    <message>
        <source>The segmentation {0} names no segment, or too many for its size: {1}.</source>
        <translation>Die Segmentierung {0} nennt kein Segment oder zu viele für ihre Größe: {1}.</translation>
    </message>
    <message>
        <source>The headers of {0} are damaged.</source>
        <translation>Die Kopfdaten von {0} sind beschädigt.</translation>
    </message>
    <message>
        <source>The segmentation {0} does not say where its frames are: {1}.</source>
        <translation>Die Segmentierung {0} sagt nicht, wo ihre Bilder liegen: {1}.</translation>
    </message>
    <message>
        <source>rows, columns, frames or bits</source>
        <translation>Zeilen, Spalten, Bilder oder Bits</translation>
    </message>
    <message>
        <source>pixel spacing</source>
        <translation>Pixelabstand</translation>
    </message>
    <message>
        <source>The frames of the segmentation {0} are not above each other.</source>
        <translation>Die Bilder der Segmentierung {0} liegen nicht übereinander.</translation>
    </message>
    <message>
        <source>The frames of the segmentation {0} are not evenly spaced.</source>
        <translation>Die Bilder der Segmentierung {0} haben keine gleichmäßigen Abstände.</translation>
    </message>
    <message>
        <source>The segmentation {0} holds fewer frames than it declares.</source>
        <translation>Die Segmentierung {0} enthält weniger Bilder, als sie angibt.</translation>
    </message>
    <message>
        <source>The segmentation {0} ends before its last frame.</source>
        <translation>Die Segmentierung {0} endet vor ihrem letzten Bild.</translation>
    </message>
    <message>
        <source>There is no segment to write.</source>
        <translation>Es gibt kein Segment zu schreiben.</translation>
    </message>
    <message>
        <source>A segmentation needs the identifiers of the study, the series and the frame of reference that it was drawn on.</source>
        <translation>Eine Segmentierung braucht die Kennungen der Studie, der Serie und des Bezugssystems, in dem sie gezeichnet wurde.</translation>
    </message>
    <message>
        <source>The segments {0} and {1} lie on different grids; one file holds one grid.</source>
        <translation>Die Segmente {0} und {1} liegen auf verschiedenen Gittern; eine Datei fasst ein Gitter.</translation>
    </message>
    <message>
        <source>The grid of the segment {0} is skewed, left-handed or too large for DICOM.</source>
        <translation>Das Gitter des Segments {0} ist schief, linkshändig oder zu groß für DICOM.</translation>
    </message>
    <message>
        <source>The volume holds no voxels, so no series can be written to {0}.</source>
        <translation>Das Volumen enthält keine Voxel, also kann keine Serie nach {0} geschrieben werden.</translation>
    </message>
    <message>
        <source>The slices have {0} x {1} voxels; DICOM counts rows and columns up to 65535.</source>
        <translation>Die Schichten haben {0} x {1} Voxel; DICOM zählt Zeilen und Spalten bis 65535.</translation>
    </message>
    <message>
        <source>The series {0} needs the identifiers of its study, of itself and of its frame of reference.</source>
        <translation>Die Serie {0} braucht die Kennungen ihrer Studie, ihrer selbst und ihres Bezugssystems.</translation>
    </message>
    <message>
        <source>The volume holds values that are not finite; DICOM cannot.</source>
        <translation>Das Volumen enthält Werte, die nicht endlich sind; DICOM kann das nicht.</translation>
    </message>
    <message>
        <source>Slice {0} holds the value {1}, which the rescale {2} x + {3} cannot hold in 16 bits.</source>
        <translation>Schicht {0} enthält den Wert {1}, den die Umskalierung {2} x + {3} in 16 Bit nicht fassen kann.</translation>
    </message>
    <message>
        <source>{0} may not be read by you.</source>
        <translation>{0} dürfen Sie nicht lesen.</translation>
    </message>
    <message>
        <source>{0} cannot be opened: it has gone, or is no ordinary file.</source>
        <translation>{0} kann nicht geöffnet werden: Es ist verschwunden oder keine gewöhnliche Datei.</translation>
    </message>
    <message>
        <source>{0} is not any more as it was when the folder was scanned.</source>
        <translation>{0} ist nicht mehr so wie beim Durchsuchen des Ordners.</translation>
    </message>
    <message>
        <source>Scan the folder again.</source>
        <translation>Durchsuchen Sie den Ordner erneut.</translation>
    </message>
    <message>
        <source>{0} does not say which of its compressed pieces belong to frame {1}.</source>
        <translation>{0} sagt nicht, welche seiner komprimierten Stücke zu Bild {1} gehören.</translation>
    </message>
    <message>
        <source>The series {0} has {1} volumes, counted from 0, and no {2}.</source>
        <translation>Die Serie {0} hat {1} Volumina, gezählt ab 0, und kein {2}.</translation>
    </message>
    <message>
        <source>The series {0} is a segmentation, not an image.</source>
        <translation>Die Serie {0} ist eine Segmentierung, kein Bild.</translation>
    </message>
    <message>
        <source>Import it as labels of a structure.</source>
        <translation>Importieren Sie sie als Labels einer Struktur.</translation>
    </message>
    <message>
        <source>The series {0} holds pictures in colour and no values to measure.</source>
        <translation>Die Serie {0} enthält Farbbilder und keine messbaren Werte.</translation>
    </message>
    <message>
        <source>Choose the grey-scale series that it was made from.</source>
        <translation>Wählen Sie die Graustufenserie, aus der sie entstanden ist.</translation>
    </message>
    <message>
        <source>The series {0} needs {1} GiB of memory, more than this computer has.</source>
        <translation>Die Serie {0} braucht {1} GiB Speicher, mehr als dieser Rechner hat.</translation>
    </message>
    <message>
        <source>Reading the slices</source>
        <translation>Schichten werden gelesen</translation>
    </message>
    <message>
        <source>Sorting the series</source>
        <translation>Serien werden sortiert</translation>
    </message>
    <message>
        <source>The folder {0} cannot be read.</source>
        <translation>Der Ordner {0} kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Check your rights there.</source>
        <translation>Prüfen Sie Ihre Rechte dort.</translation>
    </message>
    <message>
        <source>Files found</source>
        <translation>Gefundene Dateien</translation>
    </message>
    <message>
        <source>There is nothing at {0}.</source>
        <translation>Unter {0} ist nichts vorhanden.</translation>
    </message>
    <message>
        <source>Check the path.</source>
        <translation>Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>Files looked at</source>
        <translation>Durchgesehene Dateien</translation>
    </message>
    <message>
        <source>The map is in {0}, which is no unit of stiffness.</source>
        <translation>Die Karte ist in {0}, was keine Einheit der Steifigkeit ist.</translation>
    </message>
    <message>
        <source>The stiffness map holds no value above zero.</source>
        <translation>Die Steifigkeitskarte enthält keinen Wert über null.</translation>
    </message>
    <message>
        <source>It cannot be decided whether the stiffness map is in Pa or kPa: its median, {0}, is no stiffness of soft tissue in either.</source>
        <translation>Ob die Steifigkeitskarte in Pa oder kPa ist, lässt sich nicht entscheiden: Ihr Median, {0}, ist in keiner von beiden eine Steifigkeit von Weichgewebe.</translation>
    </message>
    <message>
        <source>The stiffness map is marked as {0}, but its median, {1}, is a stiffness of soft tissue only in {2}.</source>
        <translation>Die Steifigkeitskarte ist als {0} gekennzeichnet, aber ihr Median, {1}, ist nur in {2} eine Steifigkeit von Weichgewebe.</translation>
    </message>
    <message>
        <source>Correct the unit in the file after asking where it came from.</source>
        <translation>Berichtigen Sie die Einheit in der Datei, nachdem Sie bei deren Herkunft nachgefragt haben.</translation>
    </message>
    <message>
        <source>{0} is not a label map: it holds the value {1}.</source>
        <translation>{0} ist keine Labelkarte: Sie enthält den Wert {1}.</translation>
    </message>
    <message>
        <source>A label map holds whole numbers from 0 to 65535.</source>
        <translation>Eine Labelkarte enthält ganze Zahlen von 0 bis 65535.</translation>
    </message>
    <message>
        <source>{0} is not of a known kind of volume file.</source>
        <translation>{0} ist keine bekannte Art von Volumendatei.</translation>
    </message>
    <message>
        <source>Known are .nii, .nii.gz, .nrrd, .nhdr, .mha and .mhd.</source>
        <translation>Bekannt sind .nii, .nii.gz, .nrrd, .nhdr, .mha und .mhd.</translation>
    </message>
    <message>
        <source>Check that the file is whole, for example by opening it in 3D Slicer.</source>
        <translation>Prüfen Sie, ob die Datei vollständig ist, zum Beispiel durch Öffnen in 3D Slicer.</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>sie ist leer</translation>
    </message>
    <message>
        <source>its header is not of that format</source>
        <translation>ihre Kopfdaten sind nicht von diesem Format</translation>
    </message>
    <message>
        <source>{0} holds {1} values at each voxel; one is needed.</source>
        <translation>{0} enthält {1} Werte je Voxel; einer wird gebraucht.</translation>
    </message>
    <message>
        <source>Save one component (or a grey image in place of a colour one).</source>
        <translation>Speichern Sie eine Komponente (oder ein Graubild statt eines Farbbilds).</translation>
    </message>
    <message>
        <source>{0} is not a three-dimensional volume: it has {1} axes.</source>
        <translation>{0} ist kein dreidimensionales Volumen: Es hat {1} Achsen.</translation>
    </message>
    <message>
        <source>Save one volume (one point in time) to a file.</source>
        <translation>Speichern Sie ein Volumen (einen Zeitpunkt) in eine Datei.</translation>
    </message>
    <message>
        <source>The header of {0} gives no usable grid: sizes and spacings must be positive and the axes at right angles.</source>
        <translation>Die Kopfdaten von {0} ergeben kein brauchbares Gitter: Größen und Abstände müssen positiv und die Achsen rechtwinklig sein.</translation>
    </message>
    <message>
        <source>Resample the volume onto a regular grid and save it again.</source>
        <translation>Rechnen Sie das Volumen auf ein regelmäßiges Gitter um, und speichern Sie es neu.</translation>
    </message>
    <message>
        <source>{0} is too short: its header declares {1} bytes of voxels and the file can hold {2} at most.</source>
        <translation>{0} ist zu kurz: Die Kopfdaten geben {1} Bytes an Voxeln an, und die Datei kann höchstens {2} enthalten.</translation>
    </message>
    <message>
        <source>its numbers are of an unknown type</source>
        <translation>ihre Zahlen sind von unbekanntem Typ</translation>
    </message>
    <message>
        <source>The supports do not hold the body: it {0}, so no equilibrium exists.</source>
        <translation>Die Lagerung hält den Körper nicht: Er {0}, also gibt es kein Gleichgewicht.</translation>
    </message>
    <message>
        <source>Hold more of it, or put a foundation under part of its surface.</source>
        <translation>Halten Sie mehr davon fest, oder legen Sie eine Bettung unter einen Teil seiner Oberfläche.</translation>
    </message>
    <message>
        <source>The mesh has {0} cells; at most {1} can be solved.</source>
        <translation>Das Netz hat {0} Zellen; höchstens {1} sind lösbar.</translation>
    </message>
    <message>
        <source>Mesh with fewer cells.</source>
        <translation>Vernetzen Sie mit weniger Zellen.</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio must lie between -1 and 0.5, both excluded; it is {0}.</source>
        <translation>Die Querkontraktionszahl muss zwischen -1 und 0.5 liegen, beide ausgeschlossen; sie ist {0}.</translation>
    </message>
    <message>
        <source>For tissue that is nearly incompressible take 0.45 to 0.499.</source>
        <translation>Für fast inkompressibles Gewebe nehmen Sie 0.45 bis 0.499.</translation>
    </message>
    <message>
        <source>The density must be a finite number, zero or above.</source>
        <translation>Die Dichte muss eine endliche Zahl sein, null oder größer.</translation>
    </message>
    <message>
        <source>There are {0} values of Young&apos;s modulus for {1} cells.</source>
        <translation>Es gibt {0} Werte des Elastizitätsmoduls für {1} Zellen.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of cell {0} is {1} kPa; it must be a number above zero.</source>
        <translation>Der Elastizitätsmodul der Zelle {0} ist {1} kPa; er muss eine Zahl größer als null sein.</translation>
    </message>
    <message>
        <source>Fill the cells without data before simulating.</source>
        <translation>Füllen Sie die Zellen ohne Daten vor der Simulation.</translation>
    </message>
    <message>
        <source>The tool at ({0}, {1}, {2}) mm with radius {3} mm touches nothing: the centre of the nearest face of the surface is {4} mm away.</source>
        <translation>Das Instrument bei ({0}, {1}, {2}) mm mit dem Radius {3} mm berührt nichts: Die Mitte der nächsten Fläche der Oberfläche ist {4} mm entfernt.</translation>
    </message>
    <message>
        <source>Move its centre onto the surface, or make its radius larger than {4} mm.</source>
        <translation>Verschieben Sie seine Mitte auf die Oberfläche, oder machen Sie seinen Radius größer als {4} mm.</translation>
    </message>
    <message>
        <source>Ordering the equations</source>
        <translation>Gleichungen werden geordnet</translation>
    </message>
    <message>
        <source>Solving for {0} unknowns would take {1} GB of memory; the limit is {2} GB.</source>
        <translation>Die Lösung für {0} Unbekannte bräuchte {1} GB Speicher; die Grenze ist {2} GB.</translation>
    </message>
    <message>
        <source>Factorising</source>
        <translation>Faktorisierung</translation>
    </message>
    <message>
        <source>The stiffness matrix is not positive definite (column {0} of {1}).</source>
        <translation>Die Steifigkeitsmatrix ist nicht positiv definit (Spalte {0} von {1}).</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio may be too near 1/2, or cells may be flat: look at the mesh&apos;s quality.</source>
        <translation>Die Querkontraktionszahl liegt vielleicht zu nahe bei 1/2, oder Zellen sind flach: Sehen Sie sich die Qualität des Netzes an.</translation>
    </message>
    <message>
        <source>The solver ran out of memory for {0} unknowns.</source>
        <translation>Dem Löser fehlte der Speicher für {0} Unbekannte.</translation>
    </message>
    <message>
        <source>Factorised</source>
        <translation>Faktorisiert</translation>
    </message>
    <message>
        <source>The equilibrium was not found. {0}</source>
        <translation>Das Gleichgewicht wurde nicht gefunden. {0}</translation>
    </message>
    <message>
        <source>The body&apos;s answer to a force on its surface was not found: the relative residual stayed at {0}.</source>
        <translation>Die Antwort des Körpers auf eine Kraft an seiner Oberfläche wurde nicht gefunden: Das relative Residuum blieb bei {0}.</translation>
    </message>
    <message>
        <source>The tool at ({0}, {1}, {2}) mm meets no surface on its way.</source>
        <translation>Das Instrument bei ({0}, {1}, {2}) mm trifft auf seinem Weg keine Oberfläche.</translation>
    </message>
    <message>
        <source>Move it in front of the liver, or turn it towards it.</source>
        <translation>Verschieben Sie es vor die Leber, oder drehen Sie es zu ihr hin.</translation>
    </message>
    <message>
        <source>A grasper needs a finite place and a radius above zero.</source>
        <translation>Eine Fasszange braucht einen endlichen Ort und einen Radius größer als null.</translation>
    </message>
    <message>
        <source>The grasper holds no point of the surface.</source>
        <translation>Die Fasszange hält keinen Punkt der Oberfläche.</translation>
    </message>
    <message>
        <source>Move it onto the surface, or open its jaws wider.</source>
        <translation>Verschieben Sie sie auf die Oberfläche, oder öffnen Sie ihre Branchen weiter.</translation>
    </message>
    <message>
        <source>Looking for states that the data know</source>
        <translation>Suche nach Zuständen, die die Daten kennen</translation>
    </message>
    <message>
        <source>Looking for the equilibrium</source>
        <translation>Suche nach dem Gleichgewicht</translation>
    </message>
    <message>
        <source>Solved</source>
        <translation>Gelöst</translation>
    </message>
    <message>
        <source>is not held at all</source>
        <translation>ist überhaupt nicht gehalten</translation>
    </message>
    <message>
        <source>can slide in every direction</source>
        <translation>kann in jede Richtung gleiten</translation>
    </message>
    <message>
        <source>The tool of load {0} needs a finite centre and force.</source>
        <translation>Das Instrument der Last {0} braucht eine endliche Mitte und Kraft.</translation>
    </message>
    <message>
        <source>The tool of load {0} needs a radius above zero.</source>
        <translation>Das Instrument der Last {0} braucht einen Radius größer als null.</translation>
    </message>
    <message>
        <source>The pressure of load {0} is not a finite number.</source>
        <translation>Der Druck der Last {0} ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>The gravity of load {0} is not a finite vector.</source>
        <translation>Die Schwerkraft der Last {0} ist kein endlicher Vektor.</translation>
    </message>
    <message>
        <source>A material needs at least 3 measurements of strain and stress.</source>
        <translation>Ein Material braucht mindestens 3 Messungen von Dehnung und Spannung.</translation>
    </message>
    <message>
        <source>A measurement of strain and stress is not a finite number.</source>
        <translation>Eine Messung von Dehnung und Spannung ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio must lie between -1 and 0.5, and one neighbour or more is needed for a hull.</source>
        <translation>Die Querkontraktionszahl muss zwischen -1 und 0.5 liegen, und für eine Hülle ist mindestens ein Nachbar nötig.</translation>
    </message>
    <message>
        <source>The measured stress does not grow with the strain.</source>
        <translation>Die gemessene Spannung wächst nicht mit der Dehnung.</translation>
    </message>
    <message>
        <source>Assembling the stiffness</source>
        <translation>Steifigkeit wird zusammengestellt</translation>
    </message>
    <message>
        <source>Assembled</source>
        <translation>Zusammengestellt</translation>
    </message>
    <message>
        <source>A motion needs a step and a tolerance above zero, and damping not below it.</source>
        <translation>Eine Bewegung braucht einen Schritt und eine Toleranz größer als null und eine Dämpfung nicht kleiner.</translation>
    </message>
    <message>
        <source>{0} nodes in this body need more than 5e8 voxels: take fewer.</source>
        <translation>{0} Knoten in diesem Körper brauchen mehr als 5e8 Voxel: Nehmen Sie weniger.</translation>
    </message>
    <message>
        <source>Spreading the nodes</source>
        <translation>Knoten werden verteilt</translation>
    </message>
    <message>
        <source>Measuring how the material sees the body</source>
        <translation>Messung, wie das Material den Körper sieht</translation>
    </message>
    <message>
        <source>{0} nodes, {1} voxels a node and an overlap of {2} cannot be: the last two must be at least 1 and above 1.</source>
        <translation>{0} Knoten, {1} Voxel je Knoten und eine Überlappung von {2} sind nicht möglich: Die letzten beiden müssen mindestens 1 und größer als 1 sein.</translation>
    </message>
    <message>
        <source>One linear solve a step moves the materials &quot;linear&quot; and &quot;corotational&quot;, without ligaments or a capsule.</source>
        <translation>Mit einer linearen Lösung je Schritt bewegen sich die Materialien &quot;linear&quot; und &quot;corotational&quot;, ohne Bänder oder Kapsel.</translation>
    </message>
    <message>
        <source>A tool needs rods with finite ends and a radius above zero, and a pose that turns and moves it.</source>
        <translation>Ein Instrument braucht Stäbe mit endlichen Enden und einem Radius größer als null und eine Lage, die es dreht und bewegt.</translation>
    </message>
    <message>
        <source>{0} must be a name in quotes.</source>
        <translation>{0} muss ein Name in Anführungszeichen sein.</translation>
    </message>
    <message>
        <source>{0} must be one of {1}.</source>
        <translation>{0} muss eines von {1} sein.</translation>
    </message>
    <message>
        <source>{0} must be a list in brackets.</source>
        <translation>{0} muss eine Liste in eckigen Klammern sein.</translation>
    </message>
    <message>
        <source>{0} goes with the material &quot;veronda-westmann&quot;: give both or neither.</source>
        <translation>{0} gehört zum Material &quot;veronda-westmann&quot;: Geben Sie beide an oder keines.</translation>
    </message>
    <message>
        <source>{0} and &quot;youngs_modulus_kPa&quot; both say how stiff the body is: give one.</source>
        <translation>{0} und &quot;youngs_modulus_kPa&quot; sagen beide, wie steif der Körper ist: Geben Sie eines an.</translation>
    </message>
    <message>
        <source>{0} has the same id &quot;{1}&quot; as another.</source>
        <translation>{0} hat dieselbe Kennung „{1}“ wie ein anderes.</translation>
    </message>
    <message>
        <source>{0} needs exactly one of &quot;point_array&quot;, &quot;sphere&quot; and &quot;box&quot;.</source>
        <translation>{0} braucht genau eines von &quot;point_array&quot;, &quot;sphere&quot; und &quot;box&quot;.</translation>
    </message>
    <message>
        <source>In {0} the box&apos;s min_mm must not exceed its max_mm.</source>
        <translation>In {0} darf min_mm des Quaders sein max_mm nicht übersteigen.</translation>
    </message>
    <message>
        <source>{0} is a ligament: it takes neither &quot;foundation_kPa_per_mm&quot; nor &quot;directions&quot;.</source>
        <translation>{0} ist ein Band: Es nimmt weder &quot;foundation_kPa_per_mm&quot; noch &quot;directions&quot;.</translation>
    </message>
    <message>
        <source>{0} has both &quot;foundation_kPa_per_mm&quot; and &quot;directions&quot;: a foundation acts in all directions.</source>
        <translation>{0} hat sowohl &quot;foundation_kPa_per_mm&quot; als auch &quot;directions&quot;: Eine Bettung wirkt in alle Richtungen.</translation>
    </message>
    <message>
        <source>The directions of {0} must be a list such as [&quot;x&quot;, &quot;z&quot;].</source>
        <translation>Die Richtungen von {0} müssen eine Liste sein, etwa [&quot;x&quot;, &quot;z&quot;].</translation>
    </message>
    <message>
        <source>{0} needs exactly one of &quot;tool&quot;, &quot;pressure_kPa&quot;, &quot;gravity_m_s2&quot; and &quot;gravity_of_patient&quot;.</source>
        <translation>{0} braucht genau eines von &quot;tool&quot;, &quot;pressure_kPa&quot;, &quot;gravity_m_s2&quot; und &quot;gravity_of_patient&quot;.</translation>
    </message>
    <message>
        <source>{0} must lie between -90 and 90 degrees.</source>
        <translation>{0} muss zwischen -90 und 90 Grad liegen.</translation>
    </message>
    <message>
        <source>{0} has both &quot;left_tilt_deg&quot; and &quot;right_tilt_deg&quot;: give one.</source>
        <translation>{0} hat sowohl &quot;left_tilt_deg&quot; als auch &quot;right_tilt_deg&quot;: Geben Sie eines an.</translation>
    </message>
    <message>
        <source>{0} must be true or false.</source>
        <translation>{0} muss true oder false sein.</translation>
    </message>
    <message>
        <source>The steps of {0} must be a whole number from 1 to 1000000.</source>
        <translation>Die Schritte von {0} müssen eine ganze Zahl von 1 bis 1000000 sein.</translation>
    </message>
    <message>
        <source>The nodes of {0} must be a whole number from 1 to 1000000.</source>
        <translation>Die Knoten von {0} müssen eine ganze Zahl von 1 bis 1000000 sein.</translation>
    </message>
    <message>
        <source>The mesh has no cell array {0} with one value a cell.</source>
        <translation>Das Netz hat kein Zellfeld {0} mit einem Wert je Zelle.</translation>
    </message>
    <message>
        <source>Give the scenario &quot;youngs_modulus_kPa&quot;, a number or the name of a cell array; the mesh&apos;s cell arrays are: {1}.</source>
        <translation>Geben Sie dem Szenario &quot;youngs_modulus_kPa&quot;, eine Zahl oder den Namen eines Zellfelds; die Zellfelder des Netzes sind: {1}.</translation>
    </message>
    <message>
        <source>The position of landmark {0} is not a finite point.</source>
        <translation>Die Position der Landmarke {0} ist kein endlicher Punkt.</translation>
    </message>
    <message>
        <source>Landmark {0} lies {1} mm outside the body.</source>
        <translation>Landmarke {0} liegt {1} mm außerhalb des Körpers.</translation>
    </message>
    <message>
        <source>Check that landmarks and mesh are in the same coordinates (LPS, mm).</source>
        <translation>Prüfen Sie, ob Landmarken und Netz in denselben Koordinaten sind (LPS, mm).</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Checking the model</source>
        <translation>Modell wird geprüft</translation>
    </message>
    <message>
        <source>A ligament only pulls, so it is not linear: look for the equilibrium by steps.</source>
        <translation>Ein Band zieht nur, ist also nicht linear: Suchen Sie das Gleichgewicht schrittweise.</translation>
    </message>
    <message>
        <source>Nodal loads need {0} values: three a node.</source>
        <translation>Knotenlasten brauchen {0} Werte: drei je Knoten.</translation>
    </message>
    <message>
        <source>A nodal load is not a finite number.</source>
        <translation>Eine Knotenlast ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>Support {0} names no point of the mesh.</source>
        <translation>Lagerung {0} nennt keinen Punkt des Netzes.</translation>
    </message>
    <message>
        <source>Move or enlarge its region, or name another point array.</source>
        <translation>Verschieben oder vergrößern Sie ihre Region, oder nennen Sie ein anderes Punktfeld.</translation>
    </message>
    <message>
        <source>The foundation of support {0} needs a stiffness above zero, not {1} kPa/mm.</source>
        <translation>Die Bettung der Lagerung {0} braucht eine Steifigkeit größer als null, nicht {1} kPa/mm.</translation>
    </message>
    <message>
        <source>The foundation of support {0} covers no face: no face of the surface has all three points named.</source>
        <translation>Die Bettung der Lagerung {0} bedeckt keine Fläche: Bei keiner Fläche der Oberfläche sind alle drei Punkte genannt.</translation>
    </message>
    <message>
        <source>Move or enlarge its region.</source>
        <translation>Verschieben oder vergrößern Sie ihre Region.</translation>
    </message>
    <message>
        <source>Support {0} asks for the point array {1}, which the mesh does not have with one value a point.</source>
        <translation>Lagerung {0} verlangt das Punktfeld {1}, das das Netz nicht mit einem Wert je Punkt hat.</translation>
    </message>
    <message>
        <source>The mesh&apos;s point arrays are: {2}.</source>
        <translation>Die Punktfelder des Netzes sind: {2}.</translation>
    </message>
    <message>
        <source>The point array {0} is not a number at point {1}.</source>
        <translation>Das Punktfeld {0} ist bei Punkt {1} keine Zahl.</translation>
    </message>
    <message>
        <source>The sphere of support {0} needs a finite centre and a radius above zero.</source>
        <translation>Die Kugel der Lagerung {0} braucht eine endliche Mitte und einen Radius größer als null.</translation>
    </message>
    <message>
        <source>The box of support {0} needs finite corners, the smaller one first.</source>
        <translation>Der Quader der Lagerung {0} braucht endliche Ecken, die kleinere zuerst.</translation>
    </message>
    <message>
        <source>The ligament of support {0} needs a finite anchor, a stiffness above zero and a slack not below it.</source>
        <translation>Das Band der Lagerung {0} braucht einen endlichen Ankerpunkt, eine Steifigkeit größer als null und eine nicht negative Schlaffheit.</translation>
    </message>
    <message>
        <source>The ligament of support {0} names no point of the surface.</source>
        <translation>Das Band der Lagerung {0} nennt keinen Punkt der Oberfläche.</translation>
    </message>
    <message>
        <source>There is no published tissue {0}.</source>
        <translation>Es gibt kein veröffentlichtes Gewebe {0}.</translation>
    </message>
    <message>
        <source>The tissues are: {1}.</source>
        <translation>Die Gewebe sind: {1}.</translation>
    </message>
    <message>
        <source>{0} nodes in {1} rounds cannot be made; both must be at least 1.</source>
        <translation>{0} Knoten in {1} Runden sind nicht möglich; beide müssen mindestens 1 sein.</translation>
    </message>
    <message>
        <source>The body holds no voxels.</source>
        <translation>Der Körper enthält keine Voxel.</translation>
    </message>
    <message>
        <source>{0} nodes are more than the body has voxels ({1}).</source>
        <translation>{0} Knoten sind mehr, als der Körper Voxel hat ({1}).</translation>
    </message>
    <message>
        <source>The mesh generator gave up: {0}.</source>
        <translation>Der Netzgenerator hat aufgegeben: {0}.</translation>
    </message>
    <message>
        <source>Ask for another number of cells, or smooth the labels.</source>
        <translation>Verlangen Sie eine andere Zahl von Zellen, oder glätten Sie die Labels.</translation>
    </message>
    <message>
        <source>The label map holds no labelled voxel, so there is no body to mesh.</source>
        <translation>Die Labelkarte enthält kein markiertes Voxel, also gibt es keinen Körper zu vernetzen.</translation>
    </message>
    <message>
        <source>Segment the liver first.</source>
        <translation>Segmentieren Sie zuerst die Leber.</translation>
    </message>
    <message>
        <source>The label map has {0} values for a grid of {1} x {2} x {3} voxels.</source>
        <translation>Die Labelkarte hat {0} Werte für ein Gitter von {1} x {2} x {3} Voxeln.</translation>
    </message>
    <message>
        <source>The label map&apos;s axes are not at right angles, or its spacing is not positive.</source>
        <translation>Die Achsen der Labelkarte sind nicht rechtwinklig, oder ihr Abstand ist nicht positiv.</translation>
    </message>
    <message>
        <source>A structure without voxels has no surface.</source>
        <translation>Eine Struktur ohne Voxel hat keine Oberfläche.</translation>
    </message>
    <message>
        <source>Preparing the labels</source>
        <translation>Labels werden vorbereitet</translation>
    </message>
    <message>
        <source>Removing slivers</source>
        <translation>Flache Tetraeder werden entfernt</translation>
    </message>
    <message>
        <source>Measuring the distance to the label boundary</source>
        <translation>Abstand zur Grenze der Labels wird gemessen</translation>
    </message>
    <message>
        <source>The surface of the mesh is not a closed manifold.</source>
        <translation>Die Oberfläche des Netzes ist keine geschlossene Mannigfaltigkeit.</translation>
    </message>
    <message>
        <source>Meshed</source>
        <translation>Vernetzt</translation>
    </message>
    <message>
        <source>A mesh of {0} cells cannot be made; from {1} to {2} can.</source>
        <translation>Ein Netz mit {0} Zellen ist nicht möglich; von {1} bis {2} geht es.</translation>
    </message>
    <message>
        <source>The share of cells for inner structures is {0}; it must be in 0 to 1.</source>
        <translation>Der Anteil der Zellen für innere Strukturen ist {0}; er muss in 0 bis 1 liegen.</translation>
    </message>
    <message>
        <source>Filling the body with tetrahedra</source>
        <translation>Körper wird mit Tetraedern gefüllt</translation>
    </message>
    <message>
        <source>A piece of {0} has {1} ml, but its cells only {2} ml: the mesh has lost it.</source>
        <translation>Ein Stück von {0} hat {1} ml, seine Zellen aber nur {2} ml: Das Netz hat es verloren.</translation>
    </message>
    <message>
        <source>Ask for more cells.</source>
        <translation>Verlangen Sie mehr Zellen.</translation>
    </message>
    <message>
        <source>A battery with a {0} of {1} does not exist.</source>
        <translation>Einen Akku mit {0} = {1} gibt es nicht.</translation>
    </message>
    <message>
        <source>Correct the device&apos;s battery.</source>
        <translation>Berichtigen Sie den Akku des Geräts.</translation>
    </message>
    <message>
        <source>A load of {0} W is more than the battery&apos;s internal resistance lets through.</source>
        <translation>Eine Last von {0} W ist mehr, als der Innenwiderstand des Akkus durchlässt.</translation>
    </message>
    <message>
        <source>A batch of {0} nodes takes more than the {1} MB there are for it.</source>
        <translation>Ein Paket von {0} Knoten braucht mehr als die vorhandenen {1} MB.</translation>
    </message>
    <message>
        <source>{0} lacks a reading within the discharge.</source>
        <translation>{0} fehlt eine Ablesung während der Entladung.</translation>
    </message>
    <message>
        <source>The time goes back in {0}.</source>
        <translation>In {0} läuft die Zeit zurück.</translation>
    </message>
    <message>
        <source>{0} holds no discharge.</source>
        <translation>{0} enthält keine Entladung.</translation>
    </message>
    <message>
        <source>{0} lacks a reading of the ambient.</source>
        <translation>{0} fehlt eine Ablesung der Umgebung.</translation>
    </message>
    <message>
        <source>A cell is set up from one slow discharge and at least two that are five times as fast.</source>
        <translation>Eine Zelle wird aus einer langsamen Entladung und mindestens zwei fünfmal so schnellen bestimmt.</translation>
    </message>
    <message>
        <source>A convergence curve has 2 to {0} points; this one has {1}.</source>
        <translation>Eine Konvergenzkurve hat 2 bis {0} Punkte; diese hat {1}.</translation>
    </message>
    <message>
        <source>Point {0} of the convergence curve, {1} mm3 and {2} mm, is not positive or does not increase from the point before.</source>
        <translation>Punkt {0} der Konvergenzkurve, {1} mm3 und {2} mm, ist nicht positiv oder steigt gegenüber dem vorigen Punkt nicht an.</translation>
    </message>
    <message>
        <source>{0} has no list of points.</source>
        <translation>{0} hat keine Liste von Punkten.</translation>
    </message>
    <message>
        <source>An accuracy of {0} mm is finer than the convergence study reaches ({1} mm at {2} mm3 a node).</source>
        <translation>Eine Genauigkeit von {0} mm ist feiner, als die Konvergenzstudie reicht ({1} mm bei {2} mm3 je Knoten).</translation>
    </message>
    <message>
        <source>Ask for {1} mm or more.</source>
        <translation>Verlangen Sie {1} mm oder mehr.</translation>
    </message>
    <message>
        <source>Device {0} has {1} {2}; it must lie between {3} and {4}.</source>
        <translation>Gerät {0} hat {1} {2}; es muss zwischen {3} und {4} liegen.</translation>
    </message>
    <message>
        <source>Correct that figure in the device&apos;s file.</source>
        <translation>Berichtigen Sie diesen Wert in der Datei des Geräts.</translation>
    </message>
    <message>
        <source>Device {0} has measured points that are not positive, not by increasing nodes, or more than {1}.</source>
        <translation>Gerät {0} hat Messpunkte, die nicht positiv, nicht nach steigenden Knoten geordnet oder mehr als {1} sind.</translation>
    </message>
    <message>
        <source>{0} has no list &quot;devices&quot; of 1 to {1} devices.</source>
        <translation>{0} hat keine Liste &quot;devices&quot; von 1 bis {1} Geräten.</translation>
    </message>
    <message>
        <source>Two devices have the id &quot;{0}&quot;.</source>
        <translation>Zwei Geräte haben die Kennung „{0}“.</translation>
    </message>
    <message>
        <source>Give each its own.</source>
        <translation>Geben Sie jedem seine eigene.</translation>
    </message>
    <message>
        <source>{0} has the id &quot;{1}&quot;.</source>
        <translation>{0} hat die Kennung „{1}“.</translation>
    </message>
    <message>
        <source>Use up to 64 small letters, digits and dashes.</source>
        <translation>Verwenden Sie bis zu 64 Kleinbuchstaben, Ziffern und Bindestriche.</translation>
    </message>
    <message>
        <source>{0} is worn &quot;{1}&quot;.</source>
        <translation>{0} wird als „{1}“ getragen.</translation>
    </message>
    <message>
        <source>Use head, belt or back.</source>
        <translation>Verwenden Sie head, belt oder back.</translation>
    </message>
    <message>
        <source>The energy meter {0} stopped answering.</source>
        <translation>Das Energiemessgerät {0} antwortet nicht mehr.</translation>
    </message>
    <message>
        <source>No energy counters of the processor (RAPL) at {0}.</source>
        <translation>Keine Energiezähler des Prozessors (RAPL) bei {0}.</translation>
    </message>
    <message>
        <source>No current sensors (INA) at {0}.</source>
        <translation>Keine Stromsensoren (INA) bei {0}.</translation>
    </message>
    <message>
        <source>The battery is not discharging: unplug the machine to measure by its gauge.</source>
        <translation>Der Akku entlädt sich nicht: Ziehen Sie den Netzstecker, um mit seiner Anzeige zu messen.</translation>
    </message>
    <message>
        <source>No battery gauge at {0}.</source>
        <translation>Keine Akkuanzeige bei {0}.</translation>
    </message>
    <message>
        <source>{0} does not say &quot;format&quot;: &quot;{1}&quot;.</source>
        <translation>{0} sagt nicht &quot;format&quot;: &quot;{1}&quot;.</translation>
    </message>
    <message>
        <source>Check that it is the file you meant.</source>
        <translation>Prüfen Sie, ob es die gemeinte Datei ist.</translation>
    </message>
    <message>
        <source>{0} has no &quot;{1}&quot;, or not of the right kind.</source>
        <translation>{0} hat kein &quot;{1}&quot; oder nicht von der richtigen Art.</translation>
    </message>
    <message>
        <source>The shipped devices.json shows every key.</source>
        <translation>Die mitgelieferte devices.json zeigt jeden Schlüssel.</translation>
    </message>
    <message>
        <source>{0} has &quot;{1}&quot; {2}; it must lie between {3} and {4}.</source>
        <translation>{0} hat &quot;{1}&quot; {2}; es muss zwischen {3} und {4} liegen.</translation>
    </message>
    <message>
        <source>{0} has &quot;{1}&quot; empty or longer than {2} characters.</source>
        <translation>{0} hat &quot;{1}&quot; leer oder länger als {2} Zeichen.</translation>
    </message>
    <message>
        <source>{0} has the source &quot;{1}&quot;.</source>
        <translation>{0} hat die Quelle „{1}“.</translation>
    </message>
    <message>
        <source>Idle power</source>
        <translation>Leistung im Leerlauf</translation>
    </message>
    <message>
        <source>Nothing on this machine tells its energy: idle and active power are assumed. Measure them with a current clamp or a power meter, and give them.</source>
        <translation>Nichts auf diesem Rechner sagt seine Energie: Leerlauf- und Arbeitsleistung sind angenommen. Messen Sie sie mit einer Stromzange oder einem Leistungsmesser, und geben Sie sie an.</translation>
    </message>
    <message>
        <source>Memory bandwidth</source>
        <translation>Speicherbandbreite</translation>
    </message>
    <message>
        <source>Block products</source>
        <translation>Blockprodukte</translation>
    </message>
    <message>
        <source>Other work disturbed the timing: batches usually took {0} times as long as the fastest one. Measure again on a quiet machine.</source>
        <translation>Andere Arbeit hat die Zeitmessung gestört: Pakete dauerten meist {0}-mal so lange wie das schnellste. Messen Sie erneut auf einem ruhigen Rechner.</translation>
    </message>
    <message>
        <source>The grid holds no problem.</source>
        <translation>Das Raster enthält kein Problem.</translation>
    </message>
    <message>
        <source>{0} of {1} problems are larger than the memory allowed and were left out; beyond {2} nodes the plan goes on in proportion.</source>
        <translation>{0} von {1} Problemen sind größer, als der Speicher erlaubt, und wurden ausgelassen; über {2} Knoten hinaus rechnet der Plan proportional weiter.</translation>
    </message>
    <message>
        <source>This build has no OpenCL.</source>
        <translation>Diese Version hat kein OpenCL.</translation>
    </message>
    <message>
        <source>Build with -DGLISSON_OPENCL=ON.</source>
        <translation>Bauen Sie mit -DGLISSON_OPENCL=ON.</translation>
    </message>
    <message>
        <source>OpenCL&apos;s {0} failed with {1}.</source>
        <translation>{0} von OpenCL ist mit {1} fehlgeschlagen.</translation>
    </message>
    <message>
        <source>There is no OpenCL device &quot;{0}&quot;.</source>
        <translation>Es gibt kein OpenCL-Gerät „{0}“.</translation>
    </message>
    <message>
        <source>Found: {1}. A device shows once its driver is installed (pocl-opencl-icd for processors).</source>
        <translation>Gefunden: {1}. Ein Gerät erscheint, sobald sein Treiber installiert ist (pocl-opencl-icd für Prozessoren).</translation>
    </message>
    <message>
        <source>{0} of {1} is not between {2} and {3}.</source>
        <translation>{0} von {1} liegt nicht zwischen {2} und {3}.</translation>
    </message>
    <message>
        <source>Correct the question.</source>
        <translation>Berichtigen Sie die Frage.</translation>
    </message>
    <message>
        <source>A room of {0} C is not cooler than the limit of {1} C.</source>
        <translation>Ein Raum von {0} C ist nicht kühler als die Grenze von {1} C.</translation>
    </message>
    <message>
        <source>It draws {0} W when idle; its battery allows {1} W over {2} h, and is empty after {3} h without computing anything.</source>
        <translation>Es nimmt im Leerlauf {0} W auf; sein Akku erlaubt {1} W über {2} h und ist nach {3} h leer, ohne dass etwas gerechnet wurde.</translation>
    </message>
    <message>
        <source>Its battery is empty after {0} h of {1} h: only {2} W of headroom over idling.</source>
        <translation>Sein Akku ist nach {0} h von {1} h leer: nur {2} W Spielraum über dem Leerlauf.</translation>
    </message>
    <message>
        <source>It reaches {0} C when idle; the limit is {1} C.</source>
        <translation>Es erreicht im Leerlauf {0} C; die Grenze ist {1} C.</translation>
    </message>
    <message>
        <source>It reaches {0} C; the limit is {1} C.</source>
        <translation>Es erreicht {0} C; die Grenze ist {1} C.</translation>
    </message>
    <message>
        <source>It computes {0} frames a second of {1}.</source>
        <translation>Es rechnet {0} von {1} Bildern je Sekunde.</translation>
    </message>
    <message>
        <source>{0} mm is coarser than the convergence study reaches; planned is its coarsest resolution, {1} mm3 a node.</source>
        <translation>{0} mm ist gröber, als die Konvergenzstudie reicht; geplant wird mit ihrer gröbsten Auflösung, {1} mm3 je Knoten.</translation>
    </message>
    <message>
        <source>A frame is {0} block products as in the dissertation, without the vector updates of conjugate gradients; a simulation that couples 27 nodes moves {1} times as much.</source>
        <translation>Ein Bild sind {0} Blockprodukte wie in der Dissertation, ohne die Vektorschritte des Verfahrens der konjugierten Gradienten; eine Simulation, die 27 Knoten koppelt, bewegt {1}-mal so viel.</translation>
    </message>
    <message>
        <source>{0} holds with next to no headroom: its battery allows {1} W over {2} h, and idling takes {3} W of them.</source>
        <translation>{0} hält fast ohne Spielraum: Sein Akku erlaubt {1} W über {2} h, und der Leerlauf nimmt davon {3} W.</translation>
    </message>
    <message>
        <source>{0}: after {1} s comes {2} s.</source>
        <translation>{0}: Nach {1} s kommt {2} s.</translation>
    </message>
    <message>
        <source>Give the column that holds the time, or cut the file there.</source>
        <translation>Nennen Sie die Spalte mit der Zeit, oder schneiden Sie die Datei dort ab.</translation>
    </message>
    <message>
        <source>Check the columns; at most every tenth row may be empty.</source>
        <translation>Prüfen Sie die Spalten; höchstens jede zehnte Zeile darf leer sein.</translation>
    </message>
    <message>
        <source>Change the shortest run and pause, or cut the trace to the logged runs.</source>
        <translation>Ändern Sie den kürzesten Lauf und die kürzeste Pause, oder schneiden Sie die Aufzeichnung auf die protokollierten Läufe zu.</translation>
    </message>
    <message>
        <source>Run {0} drew nothing above idle, or nothing was run in it.</source>
        <translation>Lauf {0} nahm nichts über dem Leerlauf auf, oder es lief nichts darin.</translation>
    </message>
    <message>
        <source>The power does not move between two levels, so no runs can be told from pauses.</source>
        <translation>Die Leistung bewegt sich nicht zwischen zwei Stufen, sodass sich Läufe nicht von Pausen unterscheiden lassen.</translation>
    </message>
    <message>
        <source>Record pauses between the runs; check that the right column was read.</source>
        <translation>Zeichnen Sie Pausen zwischen den Läufen auf; prüfen Sie, ob die richtige Spalte gelesen wurde.</translation>
    </message>
    <message>
        <source>Idle power moves by {0} W over the recording; each run is compared with the pauses beside it.</source>
        <translation>Die Leerlaufleistung ändert sich während der Aufzeichnung um {0} W; jeder Lauf wird mit den Pausen daneben verglichen.</translation>
    </message>
    <message>
        <source>A liver of {0} cm3 is outside {1} to {2} cm3.</source>
        <translation>Eine Leber von {0} cm3 liegt außerhalb von {1} bis {2} cm3.</translation>
    </message>
    <message>
        <source>Check the volume and its unit: 1 litre is 1000 cm3.</source>
        <translation>Prüfen Sie das Volumen und seine Einheit: 1 Liter sind 1000 cm3.</translation>
    </message>
    <message>
        <source>A node cannot stand for {0} mm3.</source>
        <translation>Ein Knoten kann nicht für {0} mm3 stehen.</translation>
    </message>
    <message>
        <source>A domain of influence of {0} nodes is no cube around a node.</source>
        <translation>Ein Einflussbereich von {0} Knoten ist kein Würfel um einen Knoten.</translation>
    </message>
    <message>
        <source>Use 1, 27 or 125.</source>
        <translation>Verwenden Sie 1, 27 oder 125.</translation>
    </message>
    <message>
        <source>{0} products a frame are not between 1 and 100000.</source>
        <translation>{0} Produkte je Bild liegen nicht zwischen 1 und 100000.</translation>
    </message>
    <message>
        <source>The folder {0} holds no judgement of a registration.</source>
        <translation>Der Ordner {0} enthält kein Urteil über eine Registrierung.</translation>
    </message>
    <message>
        <source>Make one: glisson-cli sirgn SEQUENCE.json --method icp --out FOLDER.</source>
        <translation>Erzeugen Sie eines: glisson-cli sirgn SEQUENZ.json --method icp --out ORDNER.</translation>
    </message>
    <message>
        <source>{0}: {1}.</source>
        <translation>{0}: {1}.</translation>
    </message>
    <message>
        <source>A sequence names frames with a cloud each, and landmarks.</source>
        <translation>Eine Sequenz nennt Bilder mit je einer Punktwolke sowie Landmarken.</translation>
    </message>
    <message>
        <source>it is not an object</source>
        <translation>sie ist kein Objekt</translation>
    </message>
    <message>
        <source>it has no list of frames</source>
        <translation>sie hat keine Liste von Bildern</translation>
    </message>
    <message>
        <source>registered does not name one cloud a frame</source>
        <translation>registered nennt nicht je Bild eine Punktwolke</translation>
    </message>
    <message>
        <source>registered holds something that is no file name</source>
        <translation>registered enthält etwas, das kein Dateiname ist</translation>
    </message>
    <message>
        <source>Frame {0} is missing: there is no file {1}.</source>
        <translation>Bild {0} fehlt: Es gibt keine Datei {1}.</translation>
    </message>
    <message>
        <source>Remove the frame from the sequence (and number the tracks anew), or add it.</source>
        <translation>Entfernen Sie das Bild aus der Sequenz (und nummerieren Sie die Spuren neu), oder fügen Sie es hinzu.</translation>
    </message>
    <message>
        <source>it names no file of landmarks</source>
        <translation>sie nennt keine Datei mit Landmarken</translation>
    </message>
    <message>
        <source>Line {1} of {0} is not landmark,frame,x_mm,y_mm,z_mm with a frame below {2}.</source>
        <translation>Zeile {1} von {0} ist nicht landmark,frame,x_mm,y_mm,z_mm mit einem Bild unter {2}.</translation>
    </message>
    <message>
        <source>Frame {0} holds no point that is finite.</source>
        <translation>Bild {0} enthält keinen endlichen Punkt.</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Track more features, or mark them by hand.</source>
        <translation>Verfolgen Sie mehr Merkmale, oder markieren Sie sie von Hand.</translation>
    </message>
    <message>
        <source>warps</source>
        <translation>Verformungen</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Frame {0} has {1} points, and {2} after registration: they must match one by one.</source>
        <translation>Bild {0} hat {1} Punkte und nach der Registrierung {2}: Sie müssen einzeln übereinstimmen.</translation>
    </message>
    <message>
        <source>A tolerance must be a positive number of mm.</source>
        <translation>Eine Toleranz muss eine positive Zahl in mm sein.</translation>
    </message>
    <message>
        <source>The folder {0} is not empty.</source>
        <translation>Der Ordner {0} ist nicht leer.</translation>
    </message>
    <message>
        <source>Name a new folder for the sequence.</source>
        <translation>Nennen Sie einen neuen Ordner für die Sequenz.</translation>
    </message>
    <message>
        <source>No feature could be followed through {0} frames.</source>
        <translation>Kein Merkmal ließ sich durch {0} Bilder verfolgen.</translation>
    </message>
    <message>
        <source>Take more frames, or give landmarks and a model of your own.</source>
        <translation>Nehmen Sie mehr Bilder, oder geben Sie eigene Landmarken und ein eigenes Modell an.</translation>
    </message>
    <message>
        <source>matching</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>No two frames share four landmarks.</source>
        <translation>Keine zwei Bilder haben vier gemeinsame Landmarken.</translation>
    </message>
    <message>
        <source>Track more features, or leave out fewer frames.</source>
        <translation>Verfolgen Sie mehr Merkmale, oder lassen Sie weniger Bilder aus.</translation>
    </message>
    <message>
        <source>Two frames or more can be aligned.</source>
        <translation>Ausrichten lassen sich zwei Bilder oder mehr.</translation>
    </message>
    <message>
        <source>aligning frames</source>
        <translation>Bilder werden ausgerichtet</translation>
    </message>
    <message>
        <source>The distances between the points of the {0} are not square.</source>
        <translation>Die Abstände zwischen den Punkten von {0} sind nicht quadratisch angeordnet.</translation>
    </message>
    <message>
        <source>The {0} has fewer than two points to match.</source>
        <translation>{0} hat weniger als zwei Punkte zum Zuordnen.</translation>
    </message>
    <message>
        <source>The {0} has {1} points to match; {2} is the most.</source>
        <translation>{0} hat {1} Punkte zum Zuordnen; höchstens {2} sind möglich.</translation>
    </message>
    <message>
        <source>Some points of the {0} are not connected over the surface.</source>
        <translation>Einige Punkte von {0} sind über die Oberfläche nicht verbunden.</translation>
    </message>
    <message>
        <source>Keep the largest connected piece, or bridge the gap before matching.</source>
        <translation>Behalten Sie das größte zusammenhängende Stück, oder schließen Sie die Lücke vor der Zuordnung.</translation>
    </message>
    <message>
        <source>The distances between the points of the {0} are not those of a metric.</source>
        <translation>Die Abstände zwischen den Punkten von {0} sind nicht die einer Metrik.</translation>
    </message>
    <message>
        <source>The seed must hold one finite cost a source point and target point.</source>
        <translation>Der Startwert muss endliche Kosten für jedes Paar aus Quell- und Zielpunkt enthalten.</translation>
    </message>
    <message>
        <source>sigma, tau and q must be positive.</source>
        <translation>sigma, tau und q müssen positiv sein.</translation>
    </message>
    <message>
        <source>The written-out field needs {0} MB; {1} MB are allowed.</source>
        <translation>Das ausgeschriebene Feld braucht {0} MB; {1} MB sind erlaubt.</translation>
    </message>
    <message>
        <source>No point of one surface has a partner on the other.</source>
        <translation>Kein Punkt der einen Oberfläche hat einen Partner auf der anderen.</translation>
    </message>
    <message>
        <source>Align the surfaces roughly first, or give landmarks.</source>
        <translation>Richten Sie die Oberflächen zuerst grob aus, oder geben Sie Landmarken an.</translation>
    </message>
    <message>
        <source>non-rigid alignment</source>
        <translation>nichtstarre Ausrichtung</translation>
    </message>
    <message>
        <source>A landmark names point {0}, which cannot be led anywhere.</source>
        <translation>Eine Landmarke nennt Punkt {0}, der nirgendwohin geführt werden kann.</translation>
    </message>
    <message>
        <source>The step of the non-rigid alignment has no solution.</source>
        <translation>Der Schritt der nichtstarren Ausrichtung hat keine Lösung.</translation>
    </message>
    <message>
        <source>By their geodesic distances the surfaces match only inside out.</source>
        <translation>Nach ihren geodätischen Abständen passen die Oberflächen nur umgestülpt zueinander.</translation>
    </message>
    <message>
        <source>Align them roughly and match with positions as prior, or use more points.</source>
        <translation>Richten Sie sie grob aus, und ordnen Sie mit den Positionen als Vorwissen zu, oder verwenden Sie mehr Punkte.</translation>
    </message>
    <message>
        <source>{0} points cannot be aligned to {1}.</source>
        <translation>{0} Punkte lassen sich nicht auf {1} ausrichten.</translation>
    </message>
    <message>
        <source>A rigid alignment needs three pairs of points that do not lie on one line.</source>
        <translation>Eine starre Ausrichtung braucht drei Punktpaare, die nicht auf einer Geraden liegen.</translation>
    </message>
    <message>
        <source>Some of the points to align are not finite.</source>
        <translation>Einige der auszurichtenden Punkte sind nicht endlich.</translation>
    </message>
    <message>
        <source>rigid alignment</source>
        <translation>starre Ausrichtung</translation>
    </message>
    <message>
        <source>A surface of {0} points cannot give {1} samples.</source>
        <translation>Eine Oberfläche mit {0} Punkten kann keine {1} Stützpunkte liefern.</translation>
    </message>
    <message>
        <source>geodesic distances</source>
        <translation>geodätische Abstände</translation>
    </message>
    <message>
        <source>A spline needs as many finite points to start from as to lead to.</source>
        <translation>Ein Spline braucht ebenso viele endliche Ausgangs- wie Zielpunkte.</translation>
    </message>
    <message>
        <source>{0} points are too many for a spline; {1} is the most.</source>
        <translation>{0} Punkte sind zu viele für einen Spline; höchstens {1} sind möglich.</translation>
    </message>
    <message>
        <source>A spline needs four matched points that do not lie in one plane.</source>
        <translation>Ein Spline braucht vier zugeordnete Punkte, die nicht in einer Ebene liegen.</translation>
    </message>
    <message>
        <source>A result lacks the point array {0} with three values a point.</source>
        <translation>Einem Ergebnis fehlt das Punktfeld {0} mit drei Werten je Punkt.</translation>
    </message>
    <message>
        <source>Compare results of the same mesh.</source>
        <translation>Vergleichen Sie Ergebnisse desselben Netzes.</translation>
    </message>
    <message>
        <source>The two results are not of the same mesh: {0} points and {1} cells against {2} and {3}.</source>
        <translation>Die beiden Ergebnisse sind nicht vom selben Netz: {0} Punkte und {1} Zellen gegen {2} und {3}.</translation>
    </message>
    <message>
        <source>The two results are not of the same mesh: point {0} rests at different places.</source>
        <translation>Die beiden Ergebnisse sind nicht vom selben Netz: Punkt {0} ruht an verschiedenen Orten.</translation>
    </message>
    <message>
        <source>No part of the surface looks like the liver&apos;s bare area (its upper rear).</source>
        <translation>Kein Teil der Oberfläche sieht wie die Area nuda der Leber aus (oben hinten).</translation>
    </message>
    <message>
        <source>Name the supports in the scenario, by a sphere or a box.</source>
        <translation>Benennen Sie die Lagerungen im Szenario, durch eine Kugel oder einen Quader.</translation>
    </message>
    <message>
        <source>{0} of the session cannot be read: {1}.</source>
        <translation>{0} der Sitzung kann nicht gelesen werden: {1}.</translation>
    </message>
    <message>
        <source>The cut passes the liver by.</source>
        <translation>Der Schnitt geht an der Leber vorbei.</translation>
    </message>
    <message>
        <source>Move it through the liver; positions are patient coordinates (LPS, mm).</source>
        <translation>Verschieben Sie ihn durch die Leber; Positionen sind Patientenkoordinaten (LPS, mm).</translation>
    </message>
    <message>
        <source>The point of the specimen lies on the cut, or is not finite.</source>
        <translation>Der Punkt des Resektats liegt auf dem Schnitt oder ist nicht endlich.</translation>
    </message>
    <message>
        <source>The step did not converge: after {0} rounds a tool still reaches {1} mm into the surface, which still moves by {2} mm.</source>
        <translation>Der Schritt ist nicht konvergiert: Nach {0} Runden reicht ein Instrument noch {1} mm in die Oberfläche, die sich noch um {2} mm bewegt.</translation>
    </message>
    <message>
        <source>Placing landmarks and structures</source>
        <translation>Landmarken und Strukturen werden eingefügt</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Nathanson liver retractor</source>
        <translation>Nathanson-Leberretraktor</translation>
    </message>
    <message>
        <source>A bent rod that lies under the liver as a hook some centimetres across, sold in several sizes. We found no published drawing and no measured force: that it spreads its pull over a disc of 70 mm is our assumption, and 2 N is the weight of 190 ml of liver (1.06 kg/l), what lifting the lower part of segment VI takes. On a real liver&apos;s shape with a uniform 6 kPa, 2 N hoist it by 18 mm; linear elasticity is strained beyond.</source>
        <translation>Ein gebogener Stab, der als einige Zentimeter breiter Haken unter der Leber liegt und in mehreren Größen verkauft wird. Wir fanden keine veröffentlichte Zeichnung und keine gemessene Kraft: Dass er seinen Zug auf eine Scheibe von 70 mm verteilt, ist unsere Annahme, und 2 N sind das Gewicht von 190 ml Leber (1.06 kg/l), so viel, wie das Anheben des unteren Teils von Segment VI braucht. An der Form einer wirklichen Leber mit gleichmäßig 6 kPa heben 2 N sie um 18 mm an; darüber hinaus ist die lineare Elastizität überfordert.</translation>
    </message>
    <message>
        <source>Grasper</source>
        <translation>Fasszange</translation>
    </message>
    <message>
        <source>Grip forces in porcine laparoscopic liver resection: 1.75 N on average, 3.38 N at most (Minimally Invasive Therapy &amp; Allied Technologies 31(1):28-33, 2022, doi:10.1080/13645706.2020.1755313). The jaw&apos;s patch of 12 mm is our assumption.</source>
        <translation>Griffkräfte bei der laparoskopischen Leberresektion am Schwein: im Mittel 1.75 N, höchstens 3.38 N (Minimally Invasive Therapy &amp; Allied Technologies 31(1):28-33, 2022, doi:10.1080/13645706.2020.1755313). Die Auflage der Branche von 12 mm ist unsere Annahme.</translation>
    </message>
    <message>
        <source>Palpation probe</source>
        <translation>Palpationssonde</translation>
    </message>
    <message>
        <source>A sphere of 10 mm pressed lightly; size and force are our assumption.</source>
        <translation>Eine leicht angedrückte Kugel von 10 mm; Größe und Kraft sind unsere Annahme.</translation>
    </message>
    <message>
        <source>There is no tool {0}.</source>
        <translation>Es gibt kein Instrument {0}.</translation>
    </message>
    <message>
        <source>The tools are: {1}.</source>
        <translation>Die Instrumente sind: {1}.</translation>
    </message>
    <message>
        <source>A case has no scene named {0}; it has {1}.</source>
        <translation>Ein Fall hat keine Szene namens {0}; er hat {1}.</translation>
    </message>
    <message>
        <source>{0} has no displacement.</source>
        <translation>{0} hat keine Verschiebung.</translation>
    </message>
    <message>
        <source>A picture has from {0} to {1} pixels a side; {2} x {3} were asked for.</source>
        <translation>Ein Bild hat {0} bis {1} Pixel je Seite; {2} x {3} wurden verlangt.</translation>
    </message>
    <message>
        <source>There is nothing to draw with: neither EGL with OpenGL 3.2 nor an X server.</source>
        <translation>Es gibt nichts, womit gezeichnet werden könnte: weder EGL mit OpenGL 3.2 noch einen X-Server.</translation>
    </message>
    <message>
        <source>Install Mesa&apos;s drivers (on Debian: libegl-mesa0 and libgl1-mesa-dri).</source>
        <translation>Installieren Sie die Treiber von Mesa (unter Debian: libegl-mesa0 und libgl1-mesa-dri).</translation>
    </message>
    <message>
        <source>The picture could not be written: {0}.</source>
        <translation>Das Bild konnte nicht geschrieben werden: {0}.</translation>
    </message>
    <message>
        <source>Choose a folder that you may write to, on a disk with room.</source>
        <translation>Wählen Sie einen Ordner, in den Sie schreiben dürfen, auf einem Datenträger mit freiem Platz.</translation>
    </message>
    <message>
        <source>This is not a PNG picture that can be read: {0}.</source>
        <translation>Dies ist kein lesbares PNG-Bild: {0}.</translation>
    </message>
    <message>
        <source>Check that the file is whole.</source>
        <translation>Prüfen Sie, ob die Datei vollständig ist.</translation>
    </message>
    <message>
        <source>it is larger than 16384 pixels a side</source>
        <translation>es ist größer als 16384 Pixel je Seite</translation>
    </message>
    <message>
        <source>The picture cannot be drawn: {0}.</source>
        <translation>Das Bild kann nicht gezeichnet werden: {0}.</translation>
    </message>
    <message>
        <source>Every voxel of the image has the same value: there is nothing to grow in.</source>
        <translation>Jedes Voxel des Bildes hat denselben Wert: Es gibt nichts, worin etwas wachsen könnte.</translation>
    </message>
    <message>
        <source>Growing</source>
        <translation>Region wächst</translation>
    </message>
    <message>
        <source>No tissue thick enough to be an organ hangs together with the seeds.</source>
        <translation>Kein Gewebe, das dick genug für ein Organ wäre, hängt mit den Saatpunkten zusammen.</translation>
    </message>
    <message>
        <source>Move the seed into the middle of the liver, away from vessels and edges.</source>
        <translation>Setzen Sie den Saatpunkt in die Mitte der Leber, fern von Gefäßen und Rändern.</translation>
    </message>
    <message>
        <source>Smoothing the outline</source>
        <translation>Umriss wird geglättet</translation>
    </message>
    <message>
        <source>There is no image value around seed {0}.</source>
        <translation>Um Saatpunkt {0} gibt es keinen Bildwert.</translation>
    </message>
    <message>
        <source>Seed {0} is much brighter ({1}) than seed {2} ({3}): one of them is probably not in the liver. Take it away.</source>
        <translation>Saatpunkt {0} ist viel heller ({1}) als Saatpunkt {2} ({3}): Einer davon liegt wahrscheinlich nicht in der Leber. Nehmen Sie ihn weg.</translation>
    </message>
    <message>
        <source>Nothing grew from seed {0}: the tissue around it is too thin or uneven. Move it to the middle of the liver.</source>
        <translation>Von Saatpunkt {0} ist nichts gewachsen: Das Gewebe ringsum ist zu dünn oder zu ungleichmäßig. Setzen Sie ihn in die Mitte der Leber.</translation>
    </message>
    <message>
        <source>The region reaches the side of the image: it has probably leaked into the body wall. Cut it there, or raise neck_radius_mm.</source>
        <translation>Die Region reicht bis zur Seite des Bildes: Sie ist wahrscheinlich in die Bauchwand ausgelaufen. Schneiden Sie sie dort ab, oder erhöhen Sie neck_radius_mm.</translation>
    </message>
    <message>
        <source>The region reaches the first or last slice: the liver is not wholly in the image, and its volume is that of the part seen.</source>
        <translation>Die Region reicht bis zur ersten oder letzten Schicht: Die Leber ist nicht ganz im Bild, und ihr Volumen ist das des sichtbaren Teils.</translation>
    </message>
    <message>
        <source>{0} ml is more than a liver holds: the region has probably leaked into a neighbour. Raise neck_radius_mm, or cut it by hand.</source>
        <translation>{0} ml sind mehr, als eine Leber fasst: Die Region ist wahrscheinlich in ein Nachbarorgan ausgelaufen. Erhöhen Sie neck_radius_mm, oder schneiden Sie sie von Hand.</translation>
    </message>
    <message>
        <source>{0} ml is less than an adult&apos;s liver holds: the growth has probably stopped early. Add a seed in the part that is missing, or raise tolerance_sd.</source>
        <translation>{0} ml sind weniger, als die Leber eines Erwachsenen fasst: Das Wachstum hat wahrscheinlich zu früh aufgehört. Setzen Sie einen Saatpunkt in den fehlenden Teil, oder erhöhen Sie tolerance_sd.</translation>
    </message>
    <message>
        <source>An image of {0} x {1} x {2} voxels is too thin to grow in.</source>
        <translation>Ein Bild von {0} x {1} x {2} Voxeln ist zu dünn, um darin zu wachsen.</translation>
    </message>
    <message>
        <source>The options of growing must be positive, and one is {0}.</source>
        <translation>Die Optionen des Wachsens müssen positiv sein, und eine ist {0}.</translation>
    </message>
    <message>
        <source>There is no seed to grow from.</source>
        <translation>Es gibt keinen Saatpunkt.</translation>
    </message>
    <message>
        <source>Give at least one point in the middle of the liver.</source>
        <translation>Geben Sie mindestens einen Punkt in der Mitte der Leber an.</translation>
    </message>
    <message>
        <source>Seed {0} at ({1}) mm lies {2} mm outside the image.</source>
        <translation>Saatpunkt {0} bei ({1}) mm liegt {2} mm außerhalb des Bildes.</translation>
    </message>
    <message>
        <source>Seeds are DICOM patient coordinates (LPS) in mm, not voxel indices.</source>
        <translation>Saatpunkte sind DICOM-Patientenkoordinaten (LPS) in mm, keine Voxelindizes.</translation>
    </message>
    <message>
        <source>There is no structure to label.</source>
        <translation>Es gibt keine Struktur, die ein Label bekommen könnte.</translation>
    </message>
    <message>
        <source>The structures {0} and {1} lie on different voxel grids.</source>
        <translation>Die Strukturen {0} und {1} liegen auf verschiedenen Voxelgittern.</translation>
    </message>
    <message>
        <source>None of the structures is the liver.</source>
        <translation>Keine der Strukturen ist die Leber.</translation>
    </message>
    <message>
        <source>Segment it first, or name a structure &quot;liver&quot;.</source>
        <translation>Segmentieren Sie sie zuerst, oder nennen Sie eine Struktur &quot;liver&quot;.</translation>
    </message>
    <message>
        <source>The structure {0} holds no voxels.</source>
        <translation>Die Struktur {0} enthält keine Voxel.</translation>
    </message>
    <message>
        <source>The two masks lie on different voxel grids.</source>
        <translation>Die beiden Masken liegen auf verschiedenen Voxelgittern.</translation>
    </message>
    <message>
        <source>There are no patients in this cohort.</source>
        <translation>Diese Kohorte enthält keine Patienten.</translation>
    </message>
    <message>
        <source>The cohort has no patient {0}.</source>
        <translation>Die Kohorte hat keinen Patienten {0}.</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>None of the {0} patients could be used; the first one: {1}</source>
        <translation>Keiner der {0} Patienten war verwendbar; der erste: {1}</translation>
    </message>
    <message>
        <source>{0} holds files that are not an earlier demo&apos;s.</source>
        <translation>{0} enthält Dateien, die nicht von einer früheren Demonstration sind.</translation>
    </message>
    <message>
        <source>Choose an empty or a new folder.</source>
        <translation>Wählen Sie einen leeren oder neuen Ordner.</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>simulating the MR images</source>
        <translation>MR-Bilder werden simuliert</translation>
    </message>
    <message>
        <source>simulating the elastography</source>
        <translation>Elastographie wird simuliert</translation>
    </message>
    <message>
        <source>writing the study</source>
        <translation>Studie wird geschrieben</translation>
    </message>
    <message>
        <source>writing the truth</source>
        <translation>Sollwerte werden geschrieben</translation>
    </message>
    <message>
        <source>Check the folder and your rights there.</source>
        <translation>Prüfen Sie den Ordner und Ihre Rechte dort.</translation>
    </message>
    <message>
        <source>{0} holds none of the scans, such as A-1.69N.ply.</source>
        <translation>{0} enthält keinen der Scans, etwa A-1.69N.ply.</translation>
    </message>
    <message>
        <source>None of the trials could be compared; the first one: {0}</source>
        <translation>Keiner der Versuche ließ sich vergleichen; der erste: {0}</translation>
    </message>
    <message>
        <source>The phantom&apos;s equilibrium was not reached: {0}</source>
        <translation>Das Gleichgewicht des Phantoms wurde nicht erreicht: {0}</translation>
    </message>
    <message>
        <source>The two judge different videos: {0} and {1}.</source>
        <translation>Die beiden beurteilen verschiedene Videos: {0} und {1}.</translation>
    </message>
    <message>
        <source>Judge both registrations on the same sequence.json.</source>
        <translation>Beurteilen Sie beide Registrierungen an derselben sequence.json.</translation>
    </message>
    <message>
        <source>The sequence names no camera to draw with.</source>
        <translation>Die Sequenz nennt keine Kamera zum Zeichnen.</translation>
    </message>
    <message>
        <source>Add &quot;camera&quot;: {&quot;matrix&quot;: [3x3], &quot;distortion&quot;: [..]}.</source>
        <translation>Fügen Sie hinzu: &quot;camera&quot;: {&quot;matrix&quot;: [3x3], &quot;distortion&quot;: [..]}.</translation>
    </message>
    <message>
        <source>Frame {0} of the sequence names no image.</source>
        <translation>Bild {0} der Sequenz nennt keine Bilddatei.</translation>
    </message>
    <message>
        <source>Add &quot;image&quot; to each frame.</source>
        <translation>Fügen Sie jedem Bild &quot;image&quot; hinzu.</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Sample {0} of {1} has a size, a way or a force that is not positive.</source>
        <translation>Messung {0} von {1} hat eine Größe, einen Weg oder eine Kraft, die nicht positiv ist.</translation>
    </message>
    <message>
        <source>No labelled voxel of {0} lies where {1} has a stiffness.</source>
        <translation>Kein markiertes Voxel von {0} liegt dort, wo {1} eine Steifigkeit hat.</translation>
    </message>
    <message>
        <source>Material {0} was never put under the testing machine.</source>
        <translation>Material {0} war nie in der Prüfmaschine.</translation>
    </message>
    <message>
        <source>Give its samples in the file of tests, or leave the region out.</source>
        <translation>Geben Sie seine Messungen in der Datei der Prüfungen an, oder lassen Sie die Region aus.</translation>
    </message>
    <message>
        <source>A board has from {0} to {1} points a side and a positive spacing; {2} x {3} at {4} mm were given.</source>
        <translation>Eine Tafel hat {0} bis {1} Punkte je Seite und einen positiven Abstand; angegeben wurden {2} x {3} mit {4} mm.</translation>
    </message>
    <message>
        <source>The picture shows no board of {0} x {1} points.</source>
        <translation>Das Bild zeigt keine Tafel von {0} x {1} Punkten.</translation>
    </message>
    <message>
        <source>Count inner corners or circles, columns first; the board must be sharp and lit.</source>
        <translation>Zählen Sie die inneren Ecken oder Kreise, Spalten zuerst; die Tafel muss scharf und beleuchtet sein.</translation>
    </message>
    <message>
        <source>{0} has {1} x {2} pixels, the first picture has {3} x {4}.</source>
        <translation>{0} hat {1} x {2} Pixel, das erste Bild hat {3} x {4}.</translation>
    </message>
    <message>
        <source>{0} of {1} pairs show the board to both eyes; {2} are needed.</source>
        <translation>{0} von {1} Paaren zeigen beiden Augen die Tafel; {2} sind nötig.</translation>
    </message>
    <message>
        <source>Check the board&apos;s kind, its columns and rows; take it from several sides.</source>
        <translation>Prüfen Sie Art, Spalten und Zeilen der Tafel; nehmen Sie sie aus mehreren Richtungen auf.</translation>
    </message>
    <message>
        <source>The calibration did not converge: {0}.</source>
        <translation>Die Kalibrierung ist nicht konvergiert: {0}.</translation>
    </message>
    <message>
        <source>By these pictures the right eye lies to the left of the left one.</source>
        <translation>Nach diesen Bildern liegt das rechte Auge links vom linken.</translation>
    </message>
    <message>
        <source>Exchange the left and the right pictures.</source>
        <translation>Vertauschen Sie die linken und rechten Bilder.</translation>
    </message>
    <message>
        <source>The calibration {0} has no {1}.</source>
        <translation>Der Kalibrierung {0} fehlt: {1}.</translation>
    </message>
    <message>
        <source>It needs left and right, each with a matrix and distortion, and left_to_right.</source>
        <translation>Sie braucht left und right, jeweils mit Matrix und Verzeichnung, und left_to_right.</translation>
    </message>
    <message>
        <source>A camera&apos;s focal length is not positive.</source>
        <translation>Die Brennweite einer Kamera ist nicht positiv.</translation>
    </message>
    <message>
        <source>A coefficient of distortion is not finite.</source>
        <translation>Ein Koeffizient der Verzeichnung ist nicht endlich.</translation>
    </message>
    <message>
        <source>Both eyes are in one place: there is no depth to see.</source>
        <translation>Beide Augen sind an einem Ort: Es ist keine Tiefe zu sehen.</translation>
    </message>
    <message>
        <source>left_to_right does not hold a rotation: R R^T or the last row is off by {0}.</source>
        <translation>left_to_right enthält keine Drehung: R R^T oder die letzte Zeile weicht um {0} ab.</translation>
    </message>
    <message>
        <source>The picture {0} cannot be read.</source>
        <translation>Das Bild {0} kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>PNG, JPEG, TIFF and BMP are read.</source>
        <translation>Gelesen werden PNG, JPEG, TIFF und BMP.</translation>
    </message>
    <message>
        <source>The picture {0} cannot be written.</source>
        <translation>Das Bild {0} kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>The folder must exist, and the name end in .png or .jpg.</source>
        <translation>Der Ordner muss vorhanden sein und der Name auf .png oder .jpg enden.</translation>
    </message>
    <message>
        <source>The folder {0} holds no pictures.</source>
        <translation>Der Ordner {0} enthält keine Bilder.</translation>
    </message>
    <message>
        <source>The video {0} cannot be read.</source>
        <translation>Das Video {0} kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Give a video file that OpenCV (FFmpeg) reads, or a folder of pictures.</source>
        <translation>Geben Sie eine Videodatei an, die OpenCV (FFmpeg) liest, oder einen Ordner mit Bildern.</translation>
    </message>
    <message>
        <source>The video {0} cannot be decoded: {1}.</source>
        <translation>Das Video {0} kann nicht dekodiert werden: {1}.</translation>
    </message>
    <message>
        <source>A picture of {0} has {1} x {2} pixels, the first has {3} x {4}.</source>
        <translation>Ein Bild von {0} hat {1} x {2} Pixel, das erste hat {3} x {4}.</translation>
    </message>
    <message>
        <source>The pair could not be matched: {0}.</source>
        <translation>Das Paar ließ sich nicht zuordnen: {0}.</translation>
    </message>
    <message>
        <source>The calibration is not of these pictures: half of the {0} features that both show miss their epipolar lines by {1} pixels or more.</source>
        <translation>Die Kalibrierung gehört nicht zu diesen Bildern: Die Hälfte der {0} Merkmale, die beide zeigen, verfehlt ihre Epipolarlinien um {1} Pixel oder mehr.</translation>
    </message>
    <message>
        <source>Check that the calibration is this camera&apos;s, at this size of picture, and that left and right are not exchanged.</source>
        <translation>Prüfen Sie, ob die Kalibrierung zu dieser Kamera und Bildgröße gehört und links und rechts nicht vertauscht sind.</translation>
    </message>
    <message>
        <source>By the calibration, {0} % of what both pictures show would lie behind the camera.</source>
        <translation>Nach der Kalibrierung lägen {0} % dessen, was beide Bilder zeigen, hinter der Kamera.</translation>
    </message>
    <message>
        <source>Left and right pictures are exchanged, or the calibration is of another camera.</source>
        <translation>Linkes und rechtes Bild sind vertauscht, oder die Kalibrierung gehört zu einer anderen Kamera.</translation>
    </message>
    <message>
        <source>The nearest depth must be positive and less than the farthest.</source>
        <translation>Die kleinste Tiefe muss positiv und kleiner als die größte sein.</translation>
    </message>
    <message>
        <source>The calibration is of pictures of another size: its principal point {0}, {1} lies outside {2} x {3} pixels.</source>
        <translation>Die Kalibrierung gehört zu Bildern anderer Größe: Ihr Hauptpunkt {0}, {1} liegt außerhalb von {2} x {3} Pixeln.</translation>
    </message>
    <message>
        <source>Calibrate at the size of the video, or scale the calibration&apos;s matrices.</source>
        <translation>Kalibrieren Sie in der Größe des Videos, oder skalieren Sie die Matrizen der Kalibrierung.</translation>
    </message>
    <message>
        <source>The left image is {0} x {1} pixels, the right one {2} x {3}.</source>
        <translation>Das linke Bild hat {0} x {1} Pixel, das rechte {2} x {3}.</translation>
    </message>
    <message>
        <source>The images are {0} x {1} pixels; {2} x {3} were expected.</source>
        <translation>Die Bilder haben {0} x {1} Pixel; erwartet wurden {2} x {3}.</translation>
    </message>
    <message>
        <source>There are {0} left and {1} right pictures: they must be taken in pairs.</source>
        <translation>Es gibt {0} linke und {1} rechte Bilder: Sie müssen paarweise aufgenommen sein.</translation>
    </message>
    <message>
        <source>calibrating</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Dafür reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>--channel wants COLUMN:AMPERES_PER_VOLT:SUPPLY_VOLTAGE[:CLIPS_AT], not &quot;{0}&quot;.</source>
        <translation>--channel erwartet COLUMN:AMPERES_PER_VOLT:SUPPLY_VOLTAGE[:CLIPS_AT], nicht „{0}“.</translation>
    </message>
    <message>
        <source>A column that holds watts is just COLUMN.</source>
        <translation>Eine Spalte mit Watt ist einfach COLUMN.</translation>
    </message>
    <message>
        <source>Nothing was measured.</source>
        <translation>Es wurde nichts gemessen.</translation>
    </message>
    <message>
        <source>There is no device &quot;{0}&quot;.</source>
        <translation>Es gibt kein Gerät „{0}“.</translation>
    </message>
    <message>
        <source>glisson-cli platform list shows their ids.</source>
        <translation>glisson-cli platform list zeigt ihre Kennungen.</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>The points of a cut need three columns: x_mm, y_mm, z_mm.</source>
        <translation>Die Punkte eines Schnitts brauchen drei Spalten: x_mm, y_mm, z_mm.</translation>
    </message>
    <message>
        <source>Reading the liver</source>
        <translation>Leber wird gelesen</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Reading the model</source>
        <translation>Modell wird gelesen</translation>
    </message>
    <message>
        <source>Moving the tools</source>
        <translation>Instrumente werden bewegt</translation>
    </message>
    <message>
        <source>Command {0} led to another state than was recorded.</source>
        <translation>Befehl {0} führte zu einem anderen Zustand, als aufgezeichnet wurde.</translation>
    </message>
    <message>
        <source>Replay with the case and the version that it was recorded with.</source>
        <translation>Spielen Sie mit dem Fall und der Version ab, mit denen aufgezeichnet wurde.</translation>
    </message>
    <message>
        <source>{0} wants a position X,Y,Z in mm, not &quot;{1}&quot;.</source>
        <translation>{0} erwartet eine Position X,Y,Z in mm, nicht „{1}“.</translation>
    </message>
    <message>
        <source>--size wants WxH in pixels, 16 to 16384 each, not &quot;{0}&quot;.</source>
        <translation>--size erwartet BxH in Pixeln, jeweils 16 bis 16384, nicht „{0}“.</translation>
    </message>
    <message>
        <source>The computation did not converge: {0}</source>
        <translation>Die Rechnung ist nicht konvergiert: {0}</translation>
    </message>
    <message>
        <source>The sequence names no registered clouds.</source>
        <translation>Die Sequenz nennt keine registrierten Punktwolken.</translation>
    </message>
    <message>
        <source>Add &quot;registered&quot;, or choose --method icp or geo.</source>
        <translation>Fügen Sie &quot;registered&quot; hinzu, oder wählen Sie --method icp oder geo.</translation>
    </message>
    <message>
        <source>The sequence names no model to register its clouds to.</source>
        <translation>Die Sequenz nennt kein Modell, auf das ihre Punktwolken registriert werden könnten.</translation>
    </message>
    <message>
        <source>Add &quot;model&quot;: a surface file.</source>
        <translation>Fügen Sie &quot;model&quot; hinzu: eine Oberflächendatei.</translation>
    </message>
    <message>
        <source>Frame {0} shares too few landmarks with the others.</source>
        <translation>Bild {0} hat zu wenige Landmarken mit den anderen gemeinsam.</translation>
    </message>
    <message>
        <source>The two pictures agree nowhere.</source>
        <translation>Die beiden Bilder stimmen nirgends überein.</translation>
    </message>
    <message>
        <source>Check that left and right are not exchanged and that the calibration is theirs.</source>
        <translation>Prüfen Sie, ob links und rechts nicht vertauscht sind und die Kalibrierung zu ihnen gehört.</translation>
    </message>
    <message>
        <source>Name the cohort&apos;s folder, or ask for a simulated one with --simulated N.</source>
        <translation>Nennen Sie den Ordner der Kohorte, oder verlangen Sie eine simulierte mit --simulated N.</translation>
    </message>
    <message>
        <source>Reading the case</source>
        <translation>Fall wird gelesen</translation>
    </message>
    <message>
        <source>Preparing the model</source>
        <translation>Modell wird vorbereitet</translation>
    </message>
    <message>
        <source>Known are: {1}</source>
        <translation>Bekannt sind: {1}</translation>
    </message>
    <message>
        <source>Cut {0} opens the body nowhere.</source>
        <translation>Schnitt {0} öffnet den Körper nirgends.</translation>
    </message>
    <message>
        <source>Move it through the body, or open it wider; positions are LPS, in mm.</source>
        <translation>Verschieben Sie ihn durch den Körper, oder öffnen Sie ihn weiter; Positionen sind LPS, in mm.</translation>
    </message>
    <message>
        <source>{0} needs exactly one of &quot;normal&quot; (a plane) and &quot;points_mm&quot; (a sheet through them).</source>
        <translation>{0} braucht genau eines von &quot;normal&quot; (eine Ebene) und &quot;points_mm&quot; (eine Fläche durch sie).</translation>
    </message>
    <message>
        <source>{0} is a sheet: its &quot;center_mm&quot; needs the &quot;radius_mm&quot; that it is open within.</source>
        <translation>{0} ist eine Fläche: Ihr &quot;center_mm&quot; braucht den &quot;radius_mm&quot;, in dem sie offen ist.</translation>
    </message>
    <message>
        <source>{0} must be a list of three points or more.</source>
        <translation>{0} muss eine Liste von mindestens drei Punkten sein.</translation>
    </message>
    <message>
        <source>{0} needs exactly one of &quot;{1}&quot; and &quot;{2}&quot;.</source>
        <translation>{0} braucht genau eines von &quot;{1}&quot; und &quot;{2}&quot;.</translation>
    </message>
    <message>
        <source>{0} must be &quot;nathanson-retractor&quot;, &quot;palpation-probe&quot; or {&quot;rods&quot;: [...]}.</source>
        <translation>{0} muss &quot;nathanson-retractor&quot;, &quot;palpation-probe&quot; oder {&quot;rods&quot;: [...]} sein.</translation>
    </message>
    <message>
        <source>Straight from data there are equilibria by finite elements: without a motion, a capsule, ligaments, tools or the meshfree engine.</source>
        <translation>Direkt aus Daten gibt es Gleichgewichte mit finiten Elementen: ohne Bewegung, Kapsel, Bänder, Instrumente oder das netzfreie Verfahren.</translation>
    </message>
    <message>
        <source>At {0} Hz the phase of {1} % of the tissue does not come back to itself over a period; those voxels were left out.</source>
        <translation>Bei {0} Hz kehrt die Phase von {1} % des Gewebes über eine Periode nicht zu sich zurück; diese Voxel wurden ausgelassen.</translation>
    </message>
    <message>
        <source>The loss came out negative, as when the instants run backwards in time; its sign was turned.</source>
        <translation>Der Verlustmodul kam negativ heraus, wie wenn die Zeitpunkte rückwärts laufen; sein Vorzeichen wurde umgekehrt.</translation>
    </message>
    <message>
        <source>The headers name no directions: the {0} images were taken as {1} x {2} instants in their order.</source>
        <translation>Die Kopfdaten nennen keine Richtungen: Die {0} Bilder wurden als {1} x {2} Zeitpunkte in ihrer Reihenfolge genommen.</translation>
    </message>
    <message>
        <source>The phase images have no unit: their full range, {0} to {1}, was taken as one turn.</source>
        <translation>Die Phasenbilder haben keine Einheit: Ihr ganzer Bereich, {0} bis {1}, wurde als eine Umdrehung genommen.</translation>
    </message>
    <message>
        <source>The plan has no figure for the effect {0}; it is left out.</source>
        <translation>Der Plan hat für den Effekt {0} keinen Wert; er wird ausgelassen.</translation>
    </message>
    <message>
        <source>{0} was not learnt from the recordings of a platform.</source>
        <translation>{0} wurde nicht aus den Aufzeichnungen eines Geräts gelernt.</translation>
    </message>
    <message>
        <source>Use the model.json that glisson-cli explain wrote for an experiment of kind &quot;platform&quot;.</source>
        <translation>Verwenden Sie die model.json, die glisson-cli explain für ein Experiment der Art &quot;platform&quot; geschrieben hat.</translation>
    </message>
    <message>
        <source>A smooth correction has no cause and is left out of the plan.</source>
        <translation>Eine glatte Korrektur hat keine Ursache und bleibt aus dem Plan.</translation>
    </message>
    <message>
        <source>These recordings are not explained by the effects found: they take a part of the error away, and are no proof of a cause.</source>
        <translation>Die gefundenen Effekte erklären diese Aufzeichnungen nicht: Sie nehmen einen Teil des Fehlers weg und beweisen keine Ursache.</translation>
    </message>
    <message>
        <source>The experiment is not of kind &quot;material&quot;: it holds no strain and stress.</source>
        <translation>Das Experiment ist nicht von der Art &quot;material&quot;: Es enthält keine Dehnung und Spannung.</translation>
    </message>
    <message>
        <source>A shear test cannot be used straight: take compression or tension.</source>
        <translation>Ein Scherversuch kann nicht direkt verwendet werden: Nehmen Sie Druck oder Zug.</translation>
    </message>
    <message>
        <source>A figure is measured, computed, from the dissertation (dissertation), or assumed.</source>
        <translation>Ein Wert ist gemessen (measured), berechnet (computed), aus der Dissertation (dissertation) oder angenommen (assumed).</translation>
    </message>
    <message>
        <source>It slows itself down at {0} C, and then computes {1} frames a second of {2}.</source>
        <translation>Es drosselt sich bei {0} C und rechnet dann {1} von {2} Bildern je Sekunde.</translation>
    </message>
    <message>
        <source>The resolution for {0} mm in tissue of {1} kPa comes from this curve ({2}): {3}</source>
        <translation>Die Auflösung für {0} mm in Gewebe von {1} kPa stammt aus dieser Kurve ({2}): {3}</translation>
    </message>
    <message>
        <source>No beam of 50 x 10 x 10 mm fits into the liver.</source>
        <translation>Kein Balken von 50 x 10 x 10 mm passt in die Leber.</translation>
    </message>
    <message>
        <source>A beam found no equilibrium: {0}</source>
        <translation>Ein Balken fand kein Gleichgewicht: {0}</translation>
    </message>
    <message>
        <source>With {0} nodes the beam did not converge: {1}</source>
        <translation>Mit {0} Knoten ist der Balken nicht konvergiert: {1}</translation>
    </message>
    <message>
        <source>Looking for the softest, stiffest and most uneven parts</source>
        <translation>Suche nach den weichsten, steifsten und ungleichmäßigsten Teilen</translation>
    </message>
    <message>
        <source>Hoisting the beams</source>
        <translation>Balken werden angehoben</translation>
    </message>
    <message>
        <source>Drawing typical and extreme patients</source>
        <translation>Typische und extreme Patienten werden gezeichnet</translation>
    </message>
    <message>
        <source>{0} has no effect that could be accepted: nothing is missing.</source>
        <translation>{0} enthält keinen Effekt, der übernommen werden könnte: Es fehlt nichts.</translation>
    </message>
    <message>
        <source>The effect {0} was not accepted into {1}.</source>
        <translation>Der Effekt {0} wurde nicht in {1} übernommen.</translation>
    </message>
    <message>
        <source>The accepted evidence of {0} cannot be read: {1}</source>
        <translation>Der übernommene Befund von {0} ist nicht lesbar: {1}</translation>
    </message>
    <message>
        <source>Take it back (glisson-cli accept CASE --take-back) and accept it again.</source>
        <translation>Nehmen Sie ihn zurück (glisson-cli accept CASE --take-back) und übernehmen Sie ihn neu.</translation>
    </message>
    <message>
        <source>The model was made anew after this evidence had been accepted: see whether it still holds.</source>
        <translation>Das Modell wurde neu gemacht, nachdem dieser Befund übernommen worden war: Prüfen Sie, ob er noch gilt.</translation>
    </message>
    <message>
        <source>The scenario says itself what holds the organ: the effect {0} is left out.</source>
        <translation>Das Szenario sagt selbst, was das Organ hält: Der Effekt {0} bleibt weg.</translation>
    </message>
    <message>
        <source>The scenario says itself how stiff the organ is: the effect {0} is left out.</source>
        <translation>Das Szenario sagt selbst, wie steif das Organ ist: Der Effekt {0} bleibt weg.</translation>
    </message>
    <message>
        <source>The scenario says itself what skin the organ has: the effect {0} is left out.</source>
        <translation>Das Szenario sagt selbst, welche Hülle das Organ hat: Der Effekt {0} bleibt weg.</translation>
    </message>
    <message>
        <source>Only a linear equilibrium by finite elements can have a fibre direction: the effect {0} is left out.</source>
        <translation>Nur ein lineares Gleichgewicht mit finiten Elementen kann eine Faserrichtung haben: Der Effekt {0} bleibt weg.</translation>
    </message>
    <message>
        <source>{0} was not learnt from tissue.</source>
        <translation>{0} wurde nicht an Gewebe gelernt.</translation>
    </message>
    <message>
        <source>Use the model.json that glisson-cli explain wrote for a palpation or a material test; a platform&apos;s goes to glisson-cli platform learn.</source>
        <translation>Nehmen Sie die model.json, die glisson-cli explain für eine Palpation oder einen Materialversuch geschrieben hat; die einer Plattform gehört zu glisson-cli platform learn.</translation>
    </message>
    <message>
        <source>In {0} no tissue can have such a {1}.</source>
        <translation>In {0}: Kein Gewebe kann ein solches {1} haben.</translation>
    </message>
    <message>
        <source>{0} has no effect {1}.</source>
        <translation>{0} enthält keinen Effekt {1}.</translation>
    </message>
    <message>
        <source>What loaded the specimen while it was measured does not load the organ.</source>
        <translation>Was den Prüfkörper während der Messung belastet hat, belastet das Organ nicht.</translation>
    </message>
    <message>
        <source>A pressure of {0} kPa acts on the organ all the time.</source>
        <translation>Ein Druck von {0} kPa wirkt ständig auf das Organ.</translation>
    </message>
    <message>
        <source>A weight acts on the organ all the time, by ({0}, {1}, {2}) m/s2.</source>
        <translation>Ein Gewicht wirkt ständig auf das Organ, mit ({0}, {1}, {2}) m/s2.</translation>
    </message>
    <message>
        <source>The organ is {0} times as stiff along ({1}, {2}, {3}) as across.</source>
        <translation>Das Organ ist entlang ({1}, {2}, {3}) {0}-mal so steif wie quer dazu.</translation>
    </message>
    <message>
        <source>The organ is {0} times as stiff along ({1}, {2}, {3}) as across: the specimen&apos;s axes are taken for the patient&apos;s.</source>
        <translation>Das Organ ist entlang ({1}, {2}, {3}) {0}-mal so steif wie quer dazu: Die Achsen des Prüfkörpers werden für die des Patienten genommen.</translation>
    </message>
    <message>
        <source>The whole organ is {0} times as stiff as was declared.</source>
        <translation>Das ganze Organ ist {0}-mal so steif wie angegeben.</translation>
    </message>
    <message>
        <source>The specimen&apos;s hard spot has no place in the organ: the specimen is not this organ in this place.</source>
        <translation>Die harte Stelle des Prüfkörpers hat im Organ keinen Ort: Der Prüfkörper ist nicht dieses Organ an diesem Ort.</translation>
    </message>
    <message>
        <source>A spot of {0} mm radius at ({1}, {2}, {3}) is {4} times as stiff as around it.</source>
        <translation>Eine Stelle mit {0} mm Radius bei ({1}, {2}, {3}) ist {4}-mal so steif wie um sie herum.</translation>
    </message>
    <message>
        <source>What holds the organ gives way like a spring of {0} kPa/mm.</source>
        <translation>Was das Organ hält, gibt nach wie eine Feder von {0} kPa/mm.</translation>
    </message>
    <message>
        <source>A skin of {0} N/mm lies around the organ.</source>
        <translation>Eine Hülle von {0} N/mm liegt um das Organ.</translation>
    </message>
    <message>
        <source>The load cell was off: that is of the measurement, and leaves the organ as it is.</source>
        <translation>Die Kraftmessdose war verstellt: Das betrifft die Messung und lässt das Organ, wie es ist.</translation>
    </message>
    <message>
        <source>The camera&apos;s frame was off: that is of the measurement, and leaves the organ as it is.</source>
        <translation>Das Koordinatensystem der Kamera war verschoben: Das betrifft die Messung und lässt das Organ, wie es ist.</translation>
    </message>
    <message>
        <source>This linear rehearsal cannot hold the effect {0}.</source>
        <translation>Diese lineare Probe kann den Effekt {0} nicht fassen.</translation>
    </message>
    <message>
        <source>A smooth correction has no cause and is left out of the rehearsal.</source>
        <translation>Eine glatte Korrektur hat keine Ursache und bleibt aus der Probe.</translation>
    </message>
    <message>
        <source>These measurements are not explained by the effects found: they take a part of the error away, and are no proof of a cause.</source>
        <translation>Die gefundenen Effekte erklären diese Messungen nicht: Sie nehmen einen Teil des Fehlers weg und beweisen keine Ursache.</translation>
    </message>
    <message>
        <source>A grain needs an axis of some length and a ratio above zero.</source>
        <translation>Eine Faserrichtung braucht eine Achse von einiger Länge und ein Verhältnis über null.</translation>
    </message>
    <message>
        <source>With a ratio of {0} along the grain no stable material is left at a Poisson&apos;s ratio of {1}.</source>
        <translation>Mit einem Verhältnis von {0} entlang der Fasern bleibt bei einer Querkontraktionszahl von {1} kein stabiles Material.</translation>
    </message>
    <message>
        <source>A grain is there for equilibrium by finite elements, with the material &quot;linear&quot; and without ligaments.</source>
        <translation>Eine Faserrichtung gibt es für das Gleichgewicht mit finiten Elementen, mit dem Material &quot;linear&quot; und ohne Bänder.</translation>
    </message>
    <message>
        <source>{0} would not come out as it was.</source>
        <translation>{0} käme nicht so heraus, wie es war.</translation>
    </message>
    <message>
        <source>{0} is open in another window: what is done here cannot be undone.</source>
        <translation>{0} ist in einem anderen Fenster geöffnet: Was hier geschieht, kann nicht rückgängig gemacht werden.</translation>
    </message>
    <message>
        <source>Close the other window, then open the case anew.</source>
        <translation>Schließen Sie das andere Fenster und öffnen Sie den Fall dann erneut.</translation>
    </message>
    <message>
        <source>There is nothing left to undo.</source>
        <translation>Es gibt nichts mehr rückgängig zu machen.</translation>
    </message>
    <message>
        <source>There is nothing left to redo.</source>
        <translation>Es gibt nichts mehr zu wiederholen.</translation>
    </message>
    <message>
        <source>{0} has been changed by something else since: what was done before cannot be undone any more.</source>
        <translation>{0} wurde seither von anderer Seite geändert: Was davor geschah, kann nicht mehr rückgängig gemacht werden.</translation>
    </message>
    <message>
        <source>The history of the case cannot be read: {0}.</source>
        <translation>Der Verlauf des Falls kann nicht gelesen werden: {0}.</translation>
    </message>
    <message>
        <source>A stored step of the history does not fit its case.</source>
        <translation>Ein gespeicherter Schritt des Verlaufs passt nicht zu seinem Fall.</translation>
    </message>
    <message>
        <source>A stored step of the history reaches beyond its image.</source>
        <translation>Ein gespeicherter Schritt des Verlaufs reicht über sein Bild hinaus.</translation>
    </message>
    <message>
        <source>A stored step of the history is cut off.</source>
        <translation>Ein gespeicherter Schritt des Verlaufs ist abgeschnitten.</translation>
    </message>
    <message>
        <source>{0} does not hold a planned resection: {1}.</source>
        <translation>{0} enthält keine geplante Resektion: {1}.</translation>
    </message>
    <message>
        <source>Plan it again, or make one with glisson-cli resect.</source>
        <translation>Planen Sie sie neu, oder erstellen Sie eine mit glisson-cli resect.</translation>
    </message>
    <message>
        <source>Reading the experiment</source>
        <translation>Experiment wird gelesen</translation>
    </message>
    <message>
        <source>no model was given, so there is no distance from it (RMSE)</source>
        <translation>kein Modell angegeben, daher auch kein Abstand davon (RMSE)</translation>
    </message>
    <message>
        <source>The movie {0} cannot be written.</source>
        <translation>Der Film {0} kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Choose a folder that exists.</source>
        <translation>Wählen Sie einen Ordner, den es gibt.</translation>
    </message>
    <message>
        <source>Choose a name that is not there yet.</source>
        <translation>Wählen Sie einen Namen, den es dort noch nicht gibt.</translation>
    </message>
    <message>
        <source>Choose a folder in which you may write.</source>
        <translation>Wählen Sie einen Ordner, in den Sie schreiben dürfen.</translation>
    </message>
    <message>
        <source>Leave the window&apos;s size as it is while the movie is made.</source>
        <translation>Lassen Sie die Größe des Fensters, wie sie ist, solange der Film entsteht.</translation>
    </message>
    <message>
        <source>Choose a folder in which you may write, or a name without .mp4: then it becomes a folder of pictures.</source>
        <translation>Wählen Sie einen Ordner, in den Sie schreiben dürfen, oder einen Namen ohne .mp4: Dann wird es ein Ordner mit Bildern.</translation>
    </message>
    <message>
        <source>Look whether the disk is full.</source>
        <translation>Sehen Sie nach, ob der Datenträger voll ist.</translation>
    </message>
    <message>
        <source>The liver&apos;s shape with the tools there was not found: {0}</source>
        <translation>Die Form der Leber mit den Instrumenten dort wurde nicht gefunden: {0}</translation>
    </message>
    <message>
        <source>Press less, or move the tool by smaller steps.</source>
        <translation>Drücken Sie weniger, oder bewegen Sie das Instrument in kleineren Schritten.</translation>
    </message>
    <message>
        <source>A rigid tool that only touches the liver cannot pull it.</source>
        <translation>Ein starres Instrument, das die Leber nur berührt, kann sie nicht ziehen.</translation>
    </message>
    <message>
        <source>Push into the surface, or take the grasper.</source>
        <translation>Drücken Sie in die Oberfläche hinein, oder nehmen Sie die Fasszange.</translation>
    </message>
    <message>
        <source>Tool {0} would move by {1} mm a step, past a surface that it should meet.</source>
        <translation>Das Instrument {0} würde sich in einem Schritt um {1} mm bewegen, an einer Oberfläche vorbei, auf die es treffen sollte.</translation>
    </message>
    <message>
        <source>Take more steps: at most half the radius of the tool&apos;s rods in each.</source>
        <translation>Nehmen Sie mehr Schritte: in jedem höchstens den halben Radius der Stäbe des Instruments.</translation>
    </message>
    <message>
        <source>Comparing the files with what they were made from</source>
        <translation>Dateien werden mit dem verglichen, woraus sie entstanden</translation>
    </message>
    <message>
        <source>{0} does not hold a report of measurements: {1}.</source>
        <translation>{0} enthält keinen Bericht über Messungen: {1}.</translation>
    </message>
    <message>
        <source>Open an experiment to make one; it holds report.json, report.html and model.json.</source>
        <translation>Öffnen Sie ein Experiment, um einen zu erstellen; er enthält report.json, report.html und model.json.</translation>
    </message>
    <message>
        <source>Two series are to be the {0}: {1} is the second.</source>
        <translation>Zwei Serien sollen {0} sein: {1} ist die zweite.</translation>
    </message>
    <message>
        <source>Leave one of them out, or give it another role.</source>
        <translation>Lassen Sie eine davon aus oder geben Sie ihr eine andere Rolle.</translation>
    </message>
    <message>
        <source>No series is chosen: give at least one of them a role.</source>
        <translation>Keine Serie ist gewählt: Geben Sie mindestens einer eine Rolle.</translation>
    </message>
    <message>
        <source>There is nothing of this structure at that place.</source>
        <translation>An dieser Stelle ist nichts von dieser Struktur.</translation>
    </message>
    <message>
        <source>Fill between slices of {0}</source>
        <translation>Zwischen Schichten von {0} füllen</translation>
    </message>
    <message>
        <source>Fill holes of {0}</source>
        <translation>Löcher von {0} füllen</translation>
    </message>
    <message>
        <source>Keep the largest piece of {0}</source>
        <translation>Größtes Stück von {0} behalten</translation>
    </message>
    <message>
        <source>Remove small pieces of {0}</source>
        <translation>Kleine Stücke von {0} entfernen</translation>
    </message>
    <message>
        <source>Smooth {0}</source>
        <translation>{0} glätten</translation>
    </message>
    <message>
        <source>Margin around {0}</source>
        <translation>Rand um {0}</translation>
    </message>
    <message>
        <source>Shrink {0}</source>
        <translation>{0} schrumpfen</translation>
    </message>
    <message>
        <source>Keep one piece of {0}</source>
        <translation>Ein Stück von {0} behalten</translation>
    </message>
    <message>
        <source>Smart brush on {0}</source>
        <translation>Gewebepinsel auf {0}</translation>
    </message>
    <message>
        <source>Brush on {0}</source>
        <translation>Pinsel auf {0}</translation>
    </message>
    <message>
        <source>Eraser on {0}</source>
        <translation>Radierer auf {0}</translation>
    </message>
    <message>
        <source>Scissors on {0}</source>
        <translation>Schere an {0}</translation>
    </message>
    <message>
        <source>New structure {0}</source>
        <translation>Neue Struktur {0}</translation>
    </message>
    <message>
        <source>Rename {0}</source>
        <translation>{0} umbenennen</translation>
    </message>
    <message>
        <source>Remove {0}</source>
        <translation>{0} entfernen</translation>
    </message>
    <message>
        <source>The model cannot be used. Build it anew.</source>
        <translation>Das Modell kann nicht verwendet werden. Erstellen Sie es neu.</translation>
    </message>
    <message>
        <source>Place the tool</source>
        <translation>Instrument platzieren</translation>
    </message>
    <message>
        <source>Take the tool away</source>
        <translation>Instrument wegnehmen</translation>
    </message>
    <message>
        <source>Move the tool</source>
        <translation>Instrument bewegen</translation>
    </message>
    <message>
        <source>Change the force</source>
        <translation>Kraft ändern</translation>
    </message>
    <message>
        <source>No images were found in {0}.</source>
        <translation>In {0} wurden keine Bilder gefunden.</translation>
    </message>
    <message>
        <source>By the meshfree engine a grasper pulls with a force; {0} has a displacement.</source>
        <translation>Mit dem netzfreien Verfahren zieht eine Fasszange mit einer Kraft; {0} hat eine Verschiebung.</translation>
    </message>
    <message>
        <source>Give it a pull, or take finite elements.</source>
        <translation>Geben Sie ihr einen Zug, oder nehmen Sie finite Elemente.</translation>
    </message>
    <message>
        <source>camera has no 3 x 3 matrix with positive focal lengths, or a distortion that is no list of numbers</source>
        <translation>camera hat keine 3 x 3-Matrix mit positiven Brennweiten oder eine Verzeichnung, die keine Zahlenliste ist</translation>
    </message>
    <message>
        <source>The first line of {0} is not {1}.</source>
        <translation>Die erste Zeile von {0} lautet nicht {1}.</translation>
    </message>
    <message>
        <source>Name the columns so, in this order, with commas between them.</source>
        <translation>Benennen Sie die Spalten so, in dieser Reihenfolge, durch Kommas getrennt.</translation>
    </message>
    <message>
        <source>Check that tracks and clouds are both in mm of the left camera.</source>
        <translation>Prüfen Sie, ob Spuren und Punktwolken beide in mm der linken Kamera angegeben sind.</translation>
    </message>
    <message>
        <source>In line {0} no number stands in the column &quot;{1}&quot;.</source>
        <translation>In Zeile {0} steht in der Spalte „{1}“ keine Zahl.</translation>
    </message>
    <message>
        <source>A line needs a strain (0.05 for 5 %) and a stress in kPa, numbers with a dot: look for a missing value, a unit, or a decimal comma.</source>
        <translation>Eine Zeile braucht eine Dehnung (0.05 für 5 %) und eine Spannung in kPa, Zahlen mit Punkt: Zu suchen ist nach einem fehlenden Wert, einer Einheit oder einem Dezimalkomma.</translation>
    </message>
    <message>
        <source>Tools with friction are not there for a body with a grain.</source>
        <translation>Instrumente mit Reibung gibt es nicht für einen Körper mit Faserrichtung.</translation>
    </message>
    <message>
        <source>Leave out the grain or the friction.</source>
        <translation>Die Faserrichtung oder die Reibung weglassen.</translation>
    </message>
    <message>
        <source>The mean of the elastography&apos;s magnitude images serves as the anatomy.</source>
        <translation>Als Anatomie dient das Mittel der Magnitudenbilder der Elastografie.</translation>
    </message>
    <message>
        <source>{0} was not wholly inside the liver; it was meshed as part of it.</source>
        <translation>{0} lag nicht ganz in der Leber und wurde als Teil von ihr vernetzt.</translation>
    </message>
    <message>
        <source>{0} holds no voxels.</source>
        <translation>{0} enthält keine Voxel.</translation>
    </message>
    <message>
        <source>The body falls in {0} parts; the largest is kept, and the rest is left out: {1}.</source>
        <translation>Der Körper zerfällt in {0} Teile; der größte bleibt, der Rest fällt weg: {1}.</translation>
    </message>
    <message>
        <source>Holes without a label inside the body, {0} ml together, are filled.</source>
        <translation>Löcher ohne Label im Körper, zusammen {0} ml, sind gefüllt.</translation>
    </message>
    <message>
        <source>{0} speck of fewer than {1} voxels ({2} voxels together) became part of what it touches.</source>
        <translation>{0} Fleck mit weniger als {1} Voxeln (zusammen {2} Voxel) wurde Teil dessen, was er berührt.</translation>
    </message>
    <message>
        <source>{0} specks of fewer than {1} voxels ({2} voxels together) became part of what they touch.</source>
        <translation>{0} Flecken mit weniger als {1} Voxeln (zusammen {2} Voxel) wurden Teil dessen, was sie berühren.</translation>
    </message>
    <message>
        <source>The mesh has {0} cells instead of {1}; its shape and inner structures ask for them.</source>
        <translation>Das Netz hat {0} Zellen statt {1}; Form und innere Strukturen verlangen sie.</translation>
    </message>
    <message>
        <source>{0}: {1} piece ({2} ml) too thin for {3} cells got no cells of its own; about {4} cells would show it.</source>
        <translation>{0}: {1} Stück ({2} ml) ist für {3} Zellen zu dünn und bekam keine eigenen; mit etwa {4} Zellen wäre es zu sehen.</translation>
    </message>
    <message>
        <source>{0}: {1} pieces ({2} ml) too thin for {3} cells got no cells of their own; about {4} cells would show them.</source>
        <translation>{0}: {1} Stücke ({2} ml) sind für {3} Zellen zu dünn und bekamen keine eigenen; mit etwa {4} Zellen wären sie zu sehen.</translation>
    </message>
    <message>
        <source>Another way of touching</source>
        <translation>Andere Art der Berührung</translation>
    </message>
    <message>
        <source>Place another tool</source>
        <translation>Weiteres Instrument platzieren</translation>
    </message>
    <message>
        <source>The walls of cuts can be kept apart in equilibrium by finite elements, without a grain and not straight from data.</source>
        <translation>Die Wände von Schnitten können im Gleichgewicht mit finiten Elementen auseinandergehalten werden, ohne Faserrichtung und nicht unmittelbar aus Daten.</translation>
    </message>
    <message>
        <source>The displacement has {0} points, the liver {1}; or one of them is not a number.</source>
        <translation>Die Verschiebung hat {0} Punkte, die Leber {1}; oder eine davon ist keine Zahl.</translation>
    </message>
    <message>
        <source>Simulate it again with the model as it is now.</source>
        <translation>Simulieren Sie erneut mit dem jetzigen Modell.</translation>
    </message>
    <message>
        <source>Pull or push with less force.</source>
        <translation>Ziehen oder drücken Sie mit weniger Kraft.</translation>
    </message>
    <message>
        <source>The result {0} is not of this model: its points at rest are others.</source>
        <translation>Das Ergebnis {0} gehört nicht zu diesem Modell: Seine Punkte in Ruhe sind andere.</translation>
    </message>
    <message>
        <source>one of its elements does not end</source>
        <translation>eines ihrer Elemente endet nicht</translation>
    </message>
    <message>
        <source>a compressed array has no blocks</source>
        <translation>ein komprimiertes Feld hat keine Blöcke</translation>
    </message>
    <message>
        <source>the blocks of a compressed array have no size</source>
        <translation>die Blöcke eines komprimierten Felds haben keine Größe</translation>
    </message>
    <message>
        <source>a compressed array has more bytes than the file can hold</source>
        <translation>ein komprimiertes Feld hat mehr Bytes, als die Datei fassen kann</translation>
    </message>
    <message>
        <source>an array begins behind its end</source>
        <translation>ein Feld beginnt hinter ihrem Ende</translation>
    </message>
    <message>
        <source>Mesh the surface anew, for example with MeshLab.</source>
        <translation>Vernetzen Sie die Oberfläche neu, zum Beispiel mit MeshLab.</translation>
    </message>
    <message>
        <source>No triangle of the surface has an area.</source>
        <translation>Kein Dreieck der Oberfläche hat eine Fläche.</translation>
    </message>
    <message>
        <source>Make the surface anew; a cloud of points is not one.</source>
        <translation>Erzeugen Sie die Oberfläche neu; eine Punktwolke ist keine.</translation>
    </message>
    <message>
        <source>The surface is in {0} pieces, between which there is no way along it; the largest has {1} % of its area.</source>
        <translation>Die Oberfläche besteht aus {0} Stücken, zwischen denen kein Weg auf ihr führt; das größte hat {1} % ihrer Fläche.</translation>
    </message>
    <message>
        <source>Keep its largest piece, or join the pieces.</source>
        <translation>Behalten Sie das größte Stück, oder verbinden Sie die Stücke.</translation>
    </message>
    <message>
        <source>Points at the place of another, joined with it: {0}.</source>
        <translation>Punkte am Ort eines anderen, mit ihm vereint: {0}.</translation>
    </message>
    <message>
        <source>Doubled or empty triangles left out: {0}.</source>
        <translation>Doppelte oder leere Dreiecke weggelassen: {0}.</translation>
    </message>
    <message>
        <source>Triangles turned to fit their neighbours: {0}.</source>
        <translation>Dreiecke, die passend zu ihren Nachbarn gedreht wurden: {0}.</translation>
    </message>
    <message>
        <source>Points parted where the surface only touches itself: {0}.</source>
        <translation>Punkte, die geteilt wurden, wo die Oberfläche sich nur berührt: {0}.</translation>
    </message>
    <message>
        <source>Pieces left out, together below 1 % of the area: {0}.</source>
        <translation>Weggelassene Stücke, zusammen unter 1 % der Fläche: {0}.</translation>
    </message>
    <message>
        <source>the patient&apos;s left</source>
        <translation>zur linken Seite des Patienten</translation>
    </message>
    <message>
        <source>the patient&apos;s right</source>
        <translation>zur rechten Seite des Patienten</translation>
    </message>
    <message>
        <source>the back</source>
        <translation>zum Rücken</translation>
    </message>
    <message>
        <source>the front</source>
        <translation>nach vorn</translation>
    </message>
    <message>
        <source>the head</source>
        <translation>zum Kopf</translation>
    </message>
    <message>
        <source>the feet</source>
        <translation>zu den Füßen</translation>
    </message>
    <message>
        <source>The image cuts the body off towards {0}; it is closed there by a flat cap.</source>
        <translation>Das Bild schneidet den Körper {0} hin ab; dort ist er durch eine ebene Kappe geschlossen.</translation>
    </message>
    <message>
        <source>Most rows of {0} are far shorter than its first.</source>
        <translation>Die meisten Zeilen von {0} sind weit kürzer als die erste.</translation>
    </message>
    <message>
        <source>{0} is left out: its pixels cannot be written without what else is stored with them.</source>
        <translation>{0} wird weggelassen: Seine Bildpunkte lassen sich nicht ohne das schreiben, was sonst mit ihnen gespeichert ist.</translation>
    </message>
    <message>
        <source>{0} does not say whether its pixels are signed: PixelRepresentation is {1}.</source>
        <translation>{0} sagt nicht, ob seine Bildpunkte ein Vorzeichen haben: PixelRepresentation ist {1}.</translation>
    </message>
    <message>
        <source>its voxels lie in several files</source>
        <translation>seine Voxel liegen in mehreren Dateien</translation>
    </message>
    <message>
        <source>its voxels are encoded in a way that is not read</source>
        <translation>seine Voxel sind auf eine Weise kodiert, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>{0} has {1} million voxels; at most {2} million are read.</source>
        <translation>{0} hat {1} Millionen Voxel; höchstens {2} Millionen werden gelesen.</translation>
    </message>
    <message>
        <source>Cut out the part that is needed, or resample it to larger voxels.</source>
        <translation>Schneiden Sie den benötigten Teil aus oder rechnen Sie auf größere Voxel um.</translation>
    </message>
    <message>
        <source>The compressed voxels of {0} are damaged or cut short.</source>
        <translation>Die komprimierten Voxel von {0} sind beschädigt oder abgeschnitten.</translation>
    </message>
    <message>
        <source>{0} holds more voxels than its header declares: its sizes are not those that it was written with.</source>
        <translation>{0} enthält mehr Voxel, als sein Kopf angibt: Seine Größen sind nicht die, mit denen es geschrieben wurde.</translation>
    </message>
    <message>
        <source>There is no room in the liver for {0} of {1} mm: make it smaller, or let it lie elsewhere.</source>
        <translation>In der Leber ist kein Platz für {0} von {1} mm: Machen Sie sie kleiner, oder lassen Sie sie anderswo liegen.</translation>
    </message>
    <message>
        <source>A liver of {0} ml cannot be made: ask for 800 to 2800 ml.</source>
        <translation>Eine Leber von {0} ml lässt sich nicht erzeugen: Verlangen Sie 800 bis 2800 ml.</translation>
    </message>
    <message>
        <source>A fat fraction of {0} with fibrosis of stage {1} cannot be made: the first is 0 to 0.5, the second 0 to 4.</source>
        <translation>Ein Fettanteil von {0} mit Fibrose im Stadium {1} lässt sich nicht erzeugen: Der erste liegt zwischen 0 und 0.5, das zweite zwischen 0 und 4.</translation>
    </message>
    <message>
        <source>shaping the liver</source>
        <translation>die Leber wird geformt</translation>
    </message>
    <message>
        <source>growing the vessels</source>
        <translation>die Gefäße wachsen</translation>
    </message>
    <message>
        <source>The lesion {0} is not understood: give its diameter in mm, as 30, and if you like its segment, 30@7, or its place, 30@x,y,z.</source>
        <translation>Die Läsion {0} ist nicht verständlich: Geben Sie den Durchmesser in mm an, wie 30, und wenn Sie möchten das Segment, 30@7, oder den Ort, 30@x,y,z.</translation>
    </message>
    <message>
        <source>others are writing it</source>
        <translation>andere schreiben sie gerade</translation>
    </message>
    <message>
        <source>{0} is a link to another place, where nothing is written.</source>
        <translation>{0} verweist auf einen anderen Ort; dorthin wird nichts geschrieben.</translation>
    </message>
    <message>
        <source>Put the folder itself there.</source>
        <translation>Legen Sie den Ordner selbst dorthin.</translation>
    </message>
    <message>
        <source>{0} names a file outside its place in the case folder: {1}.</source>
        <translation>{0} nennt eine Datei außerhalb ihres Platzes im Fallordner: {1}.</translation>
    </message>
    <message>
        <source>{0} is being made by another program.</source>
        <translation>{0} wird gerade von einem anderen Programm angelegt.</translation>
    </message>
    <message>
        <source>Wait until it has finished, or choose another name.</source>
        <translation>Warten Sie, bis es fertig ist, oder wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>{0} was replaced by another program and does not fit the liver of this case.</source>
        <translation>{0} wurde von einem anderen Programm ersetzt und passt nicht zur Leber dieses Falls.</translation>
    </message>
    <message>
        <source>Put the file back, or make it anew: glisson-cli segment, mesh, stiffness.</source>
        <translation>Legen Sie die Datei zurück oder erzeugen Sie sie neu: glisson-cli segment, mesh, stiffness.</translation>
    </message>
    <message>
        <source>Another program has changed {0} since it was saved.</source>
        <translation>Ein anderes Programm hat {0} seit dem Speichern geändert.</translation>
    </message>
    <message>
        <source>What {0} was made from has changed since: make it anew.</source>
        <translation>Woraus {0} entstand, hat sich seitdem geändert: erzeugen Sie es neu.</translation>
    </message>
    <message>
        <source>Point {0} of the surface lies farther off than a thousand kilometres.</source>
        <translation>Punkt {0} der Oberfläche liegt weiter als tausend Kilometer entfernt.</translation>
    </message>
    <message>
        <source>No triangle of the surface has an area: they are lines or points.</source>
        <translation>Kein Dreieck der Oberfläche hat eine Fläche: es sind Linien oder Punkte.</translation>
    </message>
    <message>
        <source>Point {0} of the mesh lies farther off than a thousand kilometres.</source>
        <translation>Punkt {0} des Netzes liegt weiter als tausend Kilometer entfernt.</translation>
    </message>
    <message>
        <source>The command is done, but its answer cannot be written: {0}.</source>
        <translation>Der Befehl ist ausgeführt, aber seine Antwort kann nicht geschrieben werden: {0}.</translation>
    </message>
    <message>
        <source>Check where standard output goes, and the space there.</source>
        <translation>Prüfen Sie, wohin die Standardausgabe geht, und den Platz dort.</translation>
    </message>
    <message>
        <source>They are of another patient.</source>
        <translation>Sie sind von einem anderen Patienten.</translation>
    </message>
    <message>
        <source>They are of another examination.</source>
        <translation>Sie sind von einer anderen Untersuchung.</translation>
    </message>
    <message>
        <source>They have another frame of reference: the patient may have moved between them.</source>
        <translation>Sie haben ein anderes Bezugssystem: Der Patient kann sich dazwischen bewegt haben.</translation>
    </message>
    <message>
        <source>They lie elsewhere: only {0} % of their place is that of the case&apos;s anatomy.</source>
        <translation>Sie liegen anderswo: Nur {0} % ihres Raumes sind der der Anatomie des Falls.</translation>
    </message>
    <message>
        <source>This was measured on &quot;{0}&quot;, and nothing shows that it is tissue of {1}.</source>
        <translation>Das wurde an „{0}“ gemessen, und nichts zeigt, dass es Gewebe von {1} ist.</translation>
    </message>
    <message>
        <source>Where it is, name the case in the experiment&apos;s title, or say so with --of-this-patient.</source>
        <translation>Ist es das, so nennen Sie den Fall im Titel des Versuchs, oder sagen Sie es mit --of-this-patient.</translation>
    </message>
    <message>
        <source>The effect {0} would change nothing in the rehearsal: {1}</source>
        <translation>Die Wirkung {0} würde an der Probe nichts ändern: {1}</translation>
    </message>
    <message>
        <source>Accept the others alone (--effect KIND).</source>
        <translation>Nehmen Sie die anderen allein an (--effect ART).</translation>
    </message>
    <message>
        <source>Make a case of their own, or take them all the same with --replace.</source>
        <translation>Machen Sie einen eigenen Fall daraus, oder nehmen Sie sie trotzdem mit --replace.</translation>
    </message>
    <message>
        <source>These images may not belong to {0}.{1}</source>
        <translation>Diese Bilder gehören vielleicht nicht zu {0}.{1}</translation>
    </message>
    <message>
        <source>{0} has an anatomy already, which these images would replace.</source>
        <translation>{0} hat schon eine Anatomie, die diese Bilder ersetzen würden.</translation>
    </message>
    <message>
        <source>Drawn on another grid ({0} x {1} x {2}) and carried to the anatomy&apos;s, each voxel from the nearest one.</source>
        <translation>Auf einem anderen Gitter gezeichnet ({0} x {1} x {2}) und auf das der Anatomie übertragen, jedes Voxel vom nächsten.</translation>
    </message>
    <message>
        <source>Left out of the label map: {0}.</source>
        <translation>Aus der Labelkarte weggelassen: {0}.</translation>
    </message>
    <message>
        <source>Nothing says what the values of {0} are: {1}.</source>
        <translation>Nichts sagt, was die Werte von {0} sind: {1}.</translation>
    </message>
    <message>
        <source>Name them, as in --label-value 1=liver --label-value 2=tumour-1.</source>
        <translation>Benennen Sie sie, etwa --label-value 1=liver --label-value 2=tumour-1.</translation>
    </message>
    <message>
        <source>Two files bring the structure {0}: {1} is the second.</source>
        <translation>Zwei Dateien bringen die Struktur {0}: {1} ist die zweite.</translation>
    </message>
    <message>
        <source>Leave one of them out (--labels UID takes that label map alone).</source>
        <translation>Lassen Sie eine davon weg (--labels UID nimmt nur diese Labelkarte).</translation>
    </message>
    <message>
        <source>No voxel of {0} lies inside the anatomy.</source>
        <translation>Kein Voxel von {0} liegt in der Anatomie.</translation>
    </message>
    <message>
        <source>Named after the file.</source>
        <translation>Nach der Datei benannt.</translation>
    </message>
    <message>
        <source>Named by you.</source>
        <translation>Von Ihnen benannt.</translation>
    </message>
    <message>
        <source>Named by 3D Slicer&apos;s segments.</source>
        <translation>Nach den Segmenten von 3D Slicer benannt.</translation>
    </message>
    <message>
        <source>Named by the table in the file.</source>
        <translation>Nach der Tabelle in der Datei benannt.</translation>
    </message>
    <message>
        <source>Named by the label description beside the file.</source>
        <translation>Nach der Label-Beschreibung neben der Datei benannt.</translation>
    </message>
    <message>
        <source>Named by TotalSegmentator&apos;s class numbers: see whether they are right.</source>
        <translation>Nach den Klassennummern von TotalSegmentator benannt: Prüfen Sie, ob sie stimmen.</translation>
    </message>
    <message>
        <source>The stiffness is assumed, {0} kPa for all cells, and not measured: it is not compared with the atlas.</source>
        <translation>Die Steifigkeit ist angenommen, {0} kPa für alle Zellen, und nicht gemessen: Sie wird nicht mit dem Atlas verglichen.</translation>
    </message>
    <message>
        <source>The stiffness is assumed, the atlas&apos;s {0} kPa for all cells, and not measured: it is not compared with the atlas.</source>
        <translation>Die Steifigkeit ist angenommen, die {0} kPa des Atlas für alle Zellen, und nicht gemessen: Sie wird nicht mit dem Atlas verglichen.</translation>
    </message>
    <message>
        <source>The result in {0} is not to be used: {1}.</source>
        <translation>Das Ergebnis in {0} ist nicht brauchbar: {1}.</translation>
    </message>
    <message>
        <source>Simulate it again with less force, or on other supports.</source>
        <translation>Simulieren Sie es noch einmal mit weniger Kraft oder auf anderen Auflagern.</translation>
    </message>
    <message>
        <source>Within the model: strains reach {0} %.</source>
        <translation>Innerhalb des Modells: Die Dehnungen erreichen {0} %.</translation>
    </message>
    <message>
        <source>Outside of the model: strains reach {0} %, and beyond {1} % it is an extrapolation.</source>
        <translation>Außerhalb des Modells: Die Dehnungen erreichen {0} %, und über {1} % ist es eine Extrapolation.</translation>
    </message>
    <message>
        <source>Not to be used: cells turned inside out: {0}.</source>
        <translation>Nicht brauchbar: umgestülpte Zellen: {0}.</translation>
    </message>
    <message>
        <source>Not to be used: the computation did not converge.</source>
        <translation>Nicht brauchbar: Die Rechnung ist nicht konvergiert.</translation>
    </message>
    <message>
        <source>cells turned inside out: {0}</source>
        <translation>umgestülpte Zellen: {0}</translation>
    </message>
    <message>
        <source>Plan a resection first, and save it.</source>
        <translation>Planen Sie zuerst eine Resektion, und speichern Sie sie.</translation>
    </message>
    <message>
        <source>The result {0} is not to be used: {1}.</source>
        <translation>Das Ergebnis {0} ist nicht brauchbar: {1}.</translation>
    </message>
    <message>
        <source>Simulate it again with less force.</source>
        <translation>Simulieren Sie es noch einmal mit weniger Kraft.</translation>
    </message>
    <message>
        <source>A result that did not converge cannot be compared: {0}</source>
        <translation>Ein nicht konvergiertes Ergebnis kann nicht verglichen werden: {0}</translation>
    </message>
    <message>
        <source>The retraction&apos;s answer is not to be used: {0}.</source>
        <translation>Die Antwort der Retraktion ist nicht brauchbar: {0}.</translation>
    </message>
    <message>
        <source>Use less force.</source>
        <translation>Nehmen Sie weniger Kraft.</translation>
    </message>
    <message>
        <source>Less than 5 % of the organ is seen: too little to say where the rest is.</source>
        <translation>Weniger als 5 % des Organs sind zu sehen: zu wenig, um zu sagen, wo der Rest liegt.</translation>
    </message>
    <message>
        <source>What is seen does not fit this organ: more than half of the points lie far from it.</source>
        <translation>Was zu sehen ist, passt nicht zu diesem Organ: Mehr als die Hälfte der Punkte liegt weit davon entfernt.</translation>
    </message>
    <message>
        <source>Preparing the organ</source>
        <translation>Organ wird vorbereitet</translation>
    </message>
    <message>
        <source>Fewer than 20 points of the surface were seen.</source>
        <translation>Es wurden weniger als 20 Punkte der Oberfläche gesehen.</translation>
    </message>
    <message>
        <source>What was seen is twenty times smaller than the organ: lengths are in mm, are these in metres?</source>
        <translation>Das Gesehene ist zwanzigmal kleiner als das Organ: Längen sind in mm, stehen diese in Metern?</translation>
    </message>
    <message>
        <source>What was seen is five times larger than the organ: lengths are in mm.</source>
        <translation>Das Gesehene ist fünfmal größer als das Organ: Längen sind in mm.</translation>
    </message>
    <message>
        <source>Placing the organ</source>
        <translation>Organ wird eingepasst</translation>
    </message>
    <message>
        <source>In {0}: {1}.</source>
        <translation>In {0}: {1}.</translation>
    </message>
    <message>
        <source>The format &quot;glisson-guidance/1&quot; is described in the documentation.</source>
        <translation>Das Format &quot;glisson-guidance/1&quot; ist in der Dokumentation beschrieben.</translation>
    </message>
    <message>
        <source>The first line must be id,x_mm,y_mm,z_mm.</source>
        <translation>Die erste Zeile muss id,x_mm,y_mm,z_mm lauten.</translation>
    </message>
    <message>
        <source>Line {0} must hold an id and three numbers.</source>
        <translation>Zeile {0} muss eine Kennung und drei Zahlen enthalten.</translation>
    </message>
    <message>
        <source>Give a pose_guess, or mark ridges or the falciform ligament.</source>
        <translation>Geben Sie eine pose_guess an, oder markieren Sie Kanten oder das Ligamentum falciforme.</translation>
    </message>
    <message>
        <source>Under no pose does what frame {0} saw lie near the organ.</source>
        <translation>In keiner Lage liegt das, was Bild {0} zeigt, nahe am Organ.</translation>
    </message>
    <message>
        <source>Check that the features have the same names on both sides, that lengths are in mm, and that the frame is of this patient.</source>
        <translation>Prüfen Sie, ob die Merkmale auf beiden Seiten gleich heißen, Längen in mm sind und das Bild von diesem Patienten ist.</translation>
    </message>
    <message>
        <source>Reading the guidance case</source>
        <translation>Fall zur Bildführung wird gelesen</translation>
    </message>
    <message>
        <source>Another window has {0} open: here it can be looked at, and nothing is changed.</source>
        <translation>{0} ist in einem anderen Fenster offen: Hier wird es nur gezeigt, und nichts wird geändert.</translation>
    </message>
    <message>
        <source>Close it there and open it here again.</source>
        <translation>Schließen Sie es dort, und öffnen Sie es hier erneut.</translation>
    </message>
    <message>
        <source>The folder of {0} takes no files: the case can be looked at, and nothing is kept.</source>
        <translation>Der Ordner von {0} nimmt keine Dateien an: Der Fall lässt sich ansehen, doch nichts wird behalten.</translation>
    </message>
    <message>
        <source>Copy it to where you may write, and open the copy.</source>
        <translation>Kopieren Sie ihn an einen Ort, an dem Sie schreiben dürfen, und öffnen Sie die Kopie.</translation>
    </message>
    <message>
        <source>The folder {0} is gone: nothing more of this case can be kept.</source>
        <translation>Der Ordner {0} ist fort: Von diesem Fall lässt sich nichts mehr behalten.</translation>
    </message>
    <message>
        <source>Bring it back to its place, or open the case where it is now.</source>
        <translation>Bringen Sie ihn an seinen Platz zurück, oder öffnen Sie den Fall dort, wo er jetzt ist.</translation>
    </message>
    <message>
        <source>The landmarks in {0} cannot be read: {1}.</source>
        <translation>Die Landmarken in {0} lassen sich nicht lesen: {1}.</translation>
    </message>
    <message>
        <source>Undo the change in the window, or delete the file&apos;s entry and set them again.</source>
        <translation>Die Änderung im Fenster rückgängig machen oder den Eintrag der Datei löschen und sie neu setzen.</translation>
    </message>
    <message>
        <source>No voxel there has a grey value from {0} to {1}.</source>
        <translation>Dort hat kein Voxel einen Grauwert von {0} bis {1}.</translation>
    </message>
    <message>
        <source>This case has no structure &quot;{0}&quot;.</source>
        <translation>Dieser Fall hat keine Struktur &quot;{0}&quot;.</translation>
    </message>
    <message>
        <source>Names are those of the folder labels in the case: liver, portal-vein, ...</source>
        <translation>Die Namen sind die des Ordners labels im Fall: liver, portal-vein, ...</translation>
    </message>
    <message>
        <source>On {0} % of its border the outline lies on tissue that hardly differs from it, most of all at {1} (LPS, mm): look there before you trust it, and add a point where a part is missing.</source>
        <translation>An {0} % seines Randes liegt der Umriss an Gewebe, das sich kaum unterscheidet, vor allem bei {1} (LPS, mm): dort nachsehen, bevor man ihm traut, und einen Punkt setzen, wo ein Teil fehlt.</translation>
    </message>
    <message>
        <source>A seed lies where there is no image value, or outside of the structure to stay in.</source>
        <translation>Ein Saatpunkt liegt, wo das Bild keinen Wert hat, oder außerhalb der Struktur, in der zu bleiben ist.</translation>
    </message>
    <message>
        <source>Forget the points, and click inside of it.</source>
        <translation>Die Punkte vergessen und hineinklicken.</translation>
    </message>
    <message>
        <source>Nothing around the seeds differs from them in brightness.</source>
        <translation>Nichts um die Saatpunkte herum unterscheidet sich von ihnen in der Helligkeit.</translation>
    </message>
    <message>
        <source>Move the seeds, or draw with the brush.</source>
        <translation>Die Saatpunkte versetzen oder mit dem Pinsel zeichnen.</translation>
    </message>
    <message>
        <source>What is as bright as the seeds and hangs together with them is more than {0} mm thick: no vessel.</source>
        <translation>Was so hell wie die Saatpunkte ist und mit ihnen zusammenhängt, ist mehr als {0} mm dick: kein Gefäß.</translation>
    </message>
    <message>
        <source>Move the seed into a vessel that stands out, or keep the growth inside of the liver.</source>
        <translation>Den Saatpunkt in ein Gefäß setzen, das sich abhebt, oder das Wachsen in der Leber halten.</translation>
    </message>
    <message>
        <source>The seeds ({0}) hardly stand out from the tissue around ({1}, scatter {2}): look at the outline.</source>
        <translation>Die Saatpunkte ({0}) heben sich kaum vom Gewebe ringsum ab ({1}, Streuung {2}): den Umriss ansehen.</translation>
    </message>
    <message>
        <source>The growth reaches the side of the image: it has probably leaked. Keep it inside of the liver, or cut it there.</source>
        <translation>Das Wachsen erreicht den Bildrand: es ist wohl ausgelaufen. In der Leber halten oder dort abschneiden.</translation>
    </message>
    <message>
        <source>Grey values for {0}</source>
        <translation>Grauwerte für {0}</translation>
    </message>
    <message>
        <source>{0} and another structure</source>
        <translation>{0} und eine andere Struktur</translation>
    </message>
    <message>
        <source>This place is not in the liver: a landmark is followed as the liver moves.</source>
        <translation>Diese Stelle ist nicht in der Leber: einer Landmarke wird gefolgt, wenn sich die Leber bewegt.</translation>
    </message>
    <message>
        <source>Click in the liver, in a slice or in 3D, and set it again.</source>
        <translation>In die Leber klicken, in einem Schnitt oder in 3D, und sie noch einmal setzen.</translation>
    </message>
    <message>
        <source>Widen the range.</source>
        <translation>Den Bereich erweitern.</translation>
    </message>
    <message>
        <source>{0} does not hold the images that {1} was made from.</source>
        <translation>{0} enthält nicht die Bilder, aus denen {1} gemacht wurde.</translation>
    </message>
    <message>
        <source>Name the folder that was imported.</source>
        <translation>Nennen Sie den Ordner, der importiert wurde.</translation>
    </message>
    <message>
        <source>SIMULATED, not measured</source>
        <translation>SIMULIERT, nicht gemessen</translation>
    </message>
    <message>
        <source>The moduli in {0} were made of shear moduli by a Poisson&apos;s ratio of {1}, not {2}.</source>
        <translation>Die Moduln in {0} wurden mit der Querkontraktionszahl {1} aus Schubmoduln berechnet, nicht mit {2}.</translation>
    </message>
    <message>
        <source>Say &quot;poisson_ratio&quot;: {1} in the specimen.</source>
        <translation>Geben Sie im Prüfkörper (specimen) &quot;poisson_ratio&quot;: {1} an.</translation>
    </message>
    <message>
        <source>Tetrahedra {0} and {1} lie on the same side of the face that they share: they overlap.</source>
        <translation>Die Tetraeder {0} und {1} liegen auf derselben Seite ihrer gemeinsamen Fläche: Sie überlappen sich.</translation>
    </message>
    <message>
        <source>Mesh it anew.</source>
        <translation>Vernetzen Sie neu.</translation>
    </message>
    <message>
        <source>{0} holds {1} MB of voxels in {2} MB: nearly all of them have one value.</source>
        <translation>{0} enthält {1} MB Voxel in {2} MB: Fast alle haben denselben Wert.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of cell {0} is {1} kPa; matter has {2} to {3} kPa.</source>
        <translation>Der Elastizitätsmodul der Zelle {0} ist {1} kPa; Materie hat {2} bis {3} kPa.</translation>
    </message>
    <message>
        <source>Check its unit: liver has 2 to 60 kPa.</source>
        <translation>Prüfen Sie seine Einheit: Leber hat 2 bis 60 kPa.</translation>
    </message>
    <message>
        <source>The mesh&apos;s Poisson&apos;s ratio must lie above -1 and not above 0.5; it is {0}.</source>
        <translation>Die Querkontraktionszahl des Netzes muss über -1 und darf nicht über 0.5 liegen; sie ist {0}.</translation>
    </message>
    <message>
        <source>SIMULATED: a generated liver, breathing and pressed by a tool as a formula says. The registration called &quot;given&quot; is the true one with a fault put into it on the left of the picture.</source>
        <translation>SIMULIERT: eine erzeugte Leber, die nach einer Formel atmet und von einem Instrument eingedrückt wird. Die „vorgegebene“ Registrierung ist die wahre, in die links im Bild ein Fehler eingebaut wurde.</translation>
    </message>
    <message>
        <source>there is no picture</source>
        <translation>es gibt kein Bild</translation>
    </message>
    <message>
        <source>Patient: name withheld</source>
        <translation>Patient: Name zurückgehalten</translation>
    </message>
    <message>
        <source>What was planned and rehearsed</source>
        <translation>Was geplant und geprobt wurde</translation>
    </message>
    <message>
        <source>Not a medical device.</source>
        <translation>Kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>Glisson {0}. Not a medical device: not for diagnosis or treatment.</source>
        <translation>Glisson {0}. Kein Medizinprodukt: nicht für Diagnose oder Behandlung.</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Entstanden durch</translation>
    </message>
    <message>
        <source>the case</source>
        <translation>dem Fall</translation>
    </message>
    <message>
        <source>files: {0}</source>
        <translation>Dateien: {0}</translation>
    </message>
    <message>
        <source>The case holds no images.</source>
        <translation>Der Fall enthält keine Bilder.</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Nothing is outlined yet.</source>
        <translation>Noch ist nichts umrissen.</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Outlined by</source>
        <translation>Umrissen durch</translation>
    </message>
    <message>
        <source>{0} with {1} N over {2} mm radius</source>
        <translation>{0} mit {1} N auf {2} mm Radius</translation>
    </message>
    <message>
        <source>Rehearsed retraction</source>
        <translation>Geprobte Retraktion</translation>
    </message>
    <message>
        <source>No tool is on the liver: nothing is being rehearsed.</source>
        <translation>An der Leber ist kein Instrument: nichts wird geprobt.</translation>
    </message>
    <message>
        <source>Tools: {0}.</source>
        <translation>Instrumente: {0}.</translation>
    </message>
    <message>
        <source>The liver moves by up to {0} mm.</source>
        <translation>Die Leber bewegt sich um bis zu {0} mm.</translation>
    </message>
    <message>
        <source>5 mm or more matters to a surgeon and is marked !.</source>
        <translation>Ab 5 mm ist es für Chirurgen von Bedeutung und mit ! bezeichnet.</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Landmarke</translation>
    </message>
    <message>
        <source>Moves (mm)</source>
        <translation>Bewegung (mm)</translation>
    </message>
    <message>
        <source>Atlas off (mm)</source>
        <translation>Fehler des Atlas (mm)</translation>
    </message>
    <message>
        <source>What can be worn</source>
        <translation>Was sich tragen lässt</translation>
    </message>
    <message>
        <source>For a liver of {0} cm3, {1} mm accuracy, {2} frames a second, {3} h at {4} deg C: {5}.</source>
        <translation>Für eine Leber von {0} cm³, {1} mm Genauigkeit, {2} Bilder je Sekunde, {3} h bei {4} °C: {5}.</translation>
    </message>
    <message>
        <source>the least obtrusive that holds is {0}</source>
        <translation>das unauffälligste, das genügt, ist {0}</translation>
    </message>
    <message>
        <source>none of the known platforms holds</source>
        <translation>keine der bekannten Plattformen genügt</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Plattform</translation>
    </message>
    <message>
        <source>Frames/s</source>
        <translation>Bilder/s</translation>
    </message>
    <message>
        <source>Battery (h)</source>
        <translation>Akku (h)</translation>
    </message>
    <message>
        <source>Surface (deg C)</source>
        <translation>Oberfläche (°C)</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Genügt</translation>
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
        <source>current</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <source>stale: made from something that has changed</source>
        <translation>veraltet: die Grundlage hat sich geändert</translation>
    </message>
    <message>
        <source>changed by another program</source>
        <translation>von einem anderen Programm geändert</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>Where it comes from</source>
        <translation>Woher es kommt</translation>
    </message>
    <message>
        <source>Each file of the case, the beginning of its SHA-256, and what made it.</source>
        <translation>Jede Datei des Falls, der Anfang ihrer SHA-256 und wodurch sie entstand.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>When (UTC)</source>
        <translation>Wann (UTC)</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>assumed: one value for all cells, {0} kPa</source>
        <translation>angenommen: ein Wert für alle Zellen, {0} kPa</translation>
    </message>
    <message>
        <source>assumed: the atlas&apos;s one value, {0} kPa</source>
        <translation>angenommen: der eine Wert des Atlas, {0} kPa</translation>
    </message>
    <message>
        <source>the patient&apos;s own, from MR elastography</source>
        <translation>die des Patienten, aus MR-Elastographie</translation>
    </message>
    <message>
        <source>cut through: R1 !</source>
        <translation>durchschnitten: R1 !</translation>
    </message>
    <message>
        <source>left in place !</source>
        <translation>bleibt zurück !</translation>
    </message>
    <message>
        <source>under 5 mm !</source>
        <translation>unter 5 mm !</translation>
    </message>
    <message>
        <source>Smallest distance to the cut. Under 1 mm counts as R1, under 5 mm is narrow; both are marked !.</source>
        <translation>Kleinster Abstand zum Schnitt. Unter 1 mm gilt als R1, unter 5 mm ist knapp; beides ist mit ! bezeichnet.</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Margin (mm)</source>
        <translation>Abstand (mm)</translation>
    </message>
    <message>
        <source>Caution</source>
        <translation>Vorsicht</translation>
    </message>
    <message>
        <source>Moved by the tools (mm)</source>
        <translation>Von Instrumenten bewegt (mm)</translation>
    </message>
    <message>
        <source>cut through</source>
        <translation>durchschnitten</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>bleibt</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>There is no model yet.</source>
        <translation>Es gibt noch kein Modell.</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Smallest dihedral angle</source>
        <translation>Kleinster Diederwinkel</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>{0} kPa on average, sd {1}</source>
        <translation>im Mittel {0} kPa, Standardabweichung {1}</translation>
    </message>
    <message>
        <source>Cells without data of their own</source>
        <translation>Zellen ohne eigene Daten</translation>
    </message>
    <message>
        <source>{0} % (filled from inside)</source>
        <translation>{0} % (von innen ergänzt)</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Gehalten von</translation>
    </message>
    <message>
        <source>the bare area near the vena cava, and springs under the diaphragm (assumed)</source>
        <translation>der Area nuda an der Hohlvene und Federn unter dem Zwerchfell (angenommen)</translation>
    </message>
    <message>
        <source>Planned resection</source>
        <translation>Geplante Resektion</translation>
    </message>
    <message>
        <source>No resection was saved.</source>
        <translation>Es wurde keine Resektion gesichert.</translation>
    </message>
    <message>
        <source>The cut removes {0} ml and leaves {1} ml, {2} % of the liver.</source>
        <translation>Der Schnitt entfernt {0} ml und lässt {1} ml, {2} % der Leber.</translation>
    </message>
    <message>
        <source>Planned on the liver as tools hold it, an answer within the model: strains reach {0} %.</source>
        <translation>Geplant an der Leber, wie Instrumente sie halten, eine Antwort innerhalb des Modells: Dehnungen erreichen {0} %.</translation>
    </message>
    <message>
        <source>Planned on the liver as tools hold it, an answer outside of the model: strains reach {0} %.</source>
        <translation>Geplant an der Leber, wie Instrumente sie halten, eine Antwort außerhalb des Modells: Dehnungen erreichen {0} %.</translation>
    </message>
    <message>
        <source>Vessels that the cut crosses.</source>
        <translation>Gefäße, die der Schnitt kreuzt.</translation>
    </message>
    <message>
        <source>Vessel</source>
        <translation>Gefäß</translation>
    </message>
    <message>
        <source>Diameter (mm)</source>
        <translation>Durchmesser (mm)</translation>
    </message>
    <message>
        <source>Vena cava, by its width</source>
        <translation>Hohlvene, der Weite nach</translation>
    </message>
    <message>
        <source>The saved resection cannot be read: its file is damaged.</source>
        <translation>Die gesicherte Resektion ist nicht lesbar: ihre Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>Evidence accepted</source>
        <translation>Angenommene Belege</translation>
    </message>
    <message>
        <source>None: the model is as declared.</source>
        <translation>Keine: das Modell ist wie angegeben.</translation>
    </message>
    <message>
        <source>Changes the model: {0}</source>
        <translation>Ändert das Modell: {0}</translation>
    </message>
    <message>
        <source>Accepted, but left out: {0}</source>
        <translation>Angenommen, aber ausgelassen: {0}</translation>
    </message>
    <message>
        <source>Cells of the liver</source>
        <translation>Zellen der Leber</translation>
    </message>
    <message>
        <source>Model: stiffness of each cell</source>
        <translation>Modell: Steifigkeit jeder Zelle</translation>
    </message>
    <message>
        <source>Images: {0}</source>
        <translation>Bilder: {0}</translation>
    </message>
    <message>
        <source>Outline: {0}</source>
        <translation>Umriss: {0}</translation>
    </message>
    <message>
        <source>Smooth surface: {0}</source>
        <translation>Glatte Oberfläche: {0}</translation>
    </message>
    <message>
        <source>imported</source>
        <translation>importiert</translation>
    </message>
    <message>
        <source>outlined</source>
        <translation>umrissen</translation>
    </message>
    <message>
        <source>made into cells</source>
        <translation>in Zellen zerlegt</translation>
    </message>
    <message>
        <source>stiffness given</source>
        <translation>mit Steifigkeit versehen</translation>
    </message>
    <message>
        <source>waves inverted</source>
        <translation>aus Wellen berechnet</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>Left out of the label map: {0} and {1} more.</source>
        <translation>Aus der Labelkarte weggelassen: {0} und {1} weitere.</translation>
    </message>
    <message>
        <source>{0} lies outside of the liver and has no cells of its own.</source>
        <translation>{0} liegt außerhalb der Leber und hat keine eigenen Zellen.</translation>
    </message>
    <message>
        <source>No landmark was set.</source>
        <translation>Es wurde keine Landmarke gesetzt.</translation>
    </message>
    <message>
        <source>{0} and the liver lie on different grids.</source>
        <translation>{0} und die Leber liegen auf verschiedenen Gittern.</translation>
    </message>
    <message>
        <source>Import one of them again: a case carries what it imports to one grid.</source>
        <translation>Importieren Sie eines davon erneut: Ein Fall bringt, was er importiert, auf ein Gitter.</translation>
    </message>
    <message>
        <source>The case has no vessels to make trees of.</source>
        <translation>Der Fall hat keine Gefäße, aus denen Bäume werden könnten.</translation>
    </message>
    <message>
        <source>Mark the structures portal-vein and hepatic-vein, or both as one structure, vessels.</source>
        <translation>Markieren Sie die Strukturen portal-vein und hepatic-vein, oder beide als eine Struktur, vessels.</translation>
    </message>
    <message>
        <source>The case has no vessel trees.</source>
        <translation>Der Fall hat keine Gefäßbäume.</translation>
    </message>
    <message>
        <source>Find them first (vessels), or take the liver&apos;s shape alone (--from prior).</source>
        <translation>Suchen Sie sie zuerst (vessels), oder nehmen Sie allein die Form der Leber (--from prior).</translation>
    </message>
    <message>
        <source>What frame {0} saw fits the organ in more than one place: its shape alone does not say where.</source>
        <translation>Was Bild {0} zeigt, passt an mehr als einer Stelle auf das Organ: Die Form allein sagt nicht, wo.</translation>
    </message>
    <message>
        <source>measuring the depth of the vessels</source>
        <translation>die Tiefe der Gefäße wird gemessen</translation>
    </message>
    <message>
        <source>following the vessels</source>
        <translation>den Gefäßen wird gefolgt</translation>
    </message>
    <message>
        <source>measuring the vessels</source>
        <translation>die Gefäße werden vermessen</translation>
    </message>
    <message>
        <source>The axes of the vessel mask are not at right angles: resample it.</source>
        <translation>Die Achsen der Gefäßmaske stehen nicht senkrecht aufeinander: Tasten Sie sie neu ab.</translation>
    </message>
    <message>
        <source>The vessel mask holds no voxels: mark vessels first, or import another mask.</source>
        <translation>Die Gefäßmaske enthält keine Voxel: Markieren Sie zuerst Gefäße, oder importieren Sie eine andere Maske.</translation>
    </message>
    <message>
        <source>The vessel mask holds a piece of {0} mm width that is no vessel: mark vessels alone.</source>
        <translation>Die Gefäßmaske enthält ein {0} mm breites Stück, das kein Gefäß ist: Markieren Sie nur Gefäße.</translation>
    </message>
    <message>
        <source>looking at the liver</source>
        <translation>die Leber wird betrachtet</translation>
    </message>
    <message>
        <source>finding the segments</source>
        <translation>die Segmente werden gesucht</translation>
    </message>
    <message>
        <source>Only {0} % of the vessels lie in the liver: check that both masks are of one scan.</source>
        <translation>Nur {0} % der Gefäße liegen in der Leber: Prüfen Sie, ob beide Masken von einer Aufnahme sind.</translation>
    </message>
    <message>
        <source>The liver mask holds no voxels: mark the liver first.</source>
        <translation>Die Lebermaske enthält keine Voxel: Markieren Sie zuerst die Leber.</translation>
    </message>
    <message>
        <source>The image ends within the liver, so that its segments cannot be told: take a scan that holds all of it.</source>
        <translation>Das Bild endet in der Leber, sodass ihre Segmente nicht zu bestimmen sind: Nehmen Sie eine Aufnahme, die sie ganz enthält.</translation>
    </message>
    <message>
        <source>No branch of the {0} lies in the liver, so that no tissue can be told to be its: check that vessels and liver are of one scan.</source>
        <translation>Kein Ast ({0}) liegt in der Leber, sodass ihm kein Gewebe zugeordnet werden kann: Prüfen Sie, ob Gefäße und Leber von einer Aufnahme sind.</translation>
    </message>
    <message>
        <source>The vessel trees cannot be read: {0} is missing or makes no sense.</source>
        <translation>Die Gefäßbäume sind nicht lesbar: {0} fehlt oder ergibt keinen Sinn.</translation>
    </message>
    <message>
        <source>Find the vessels again.</source>
        <translation>Suchen Sie die Gefäße erneut.</translation>
    </message>
    <message>
        <source>--pose {0} is no rigid motion: 16 numbers with commas, row by row.</source>
        <translation>--pose {0} ist keine starre Bewegung: 16 Zahlen mit Kommas, Zeile für Zeile.</translation>
    </message>
    <message>
        <source>The pose takes a point of the scan (mm) to the camera&apos;s frame.</source>
        <translation>Die Lage bringt einen Punkt der Aufnahme (mm) ins System der Kamera.</translation>
    </message>
    <message>
        <source>nothing was written into it</source>
        <translation>nichts wurde hineingeschrieben</translation>
    </message>
    <message>
        <source>At large strain a session knows quadratic cells of a neo-Hookean or Veronda-Westmann material without a grain.</source>
        <translation>Bei großer Dehnung kennt eine Sitzung nur quadratische Zellen aus einem Neo-Hooke- oder Veronda-Westmann-Material ohne Faserrichtung.</translation>
    </message>
    <message>
        <source>The body has no rest under its standing loads.</source>
        <translation>Der Körper kommt unter seinen ständigen Lasten nicht zur Ruhe.</translation>
    </message>
    <message>
        <source>A session does not know &quot;{0}&quot; of a scenario.</source>
        <translation>Eine Sitzung kennt „{0}“ aus einem Szenario nicht.</translation>
    </message>
    <message>
        <source>Leave it out; tools are taken by the session&apos;s commands.</source>
        <translation>Lassen Sie es weg; Werkzeuge werden mit den Befehlen der Sitzung genommen.</translation>
    </message>
    <message>
        <source>The case has no plan {0}.</source>
        <translation>Der Fall hat keinen Plan {0}.</translation>
    </message>
    <message>
        <source>A cut cannot advance through a body that was meshed with a cut.</source>
        <translation>Durch einen Körper, der schon mit einem Schnitt vernetzt ist, lässt sich kein Schnitt weiterführen.</translation>
    </message>
    <message>
        <source>A cut cannot advance through a body with a capsule.</source>
        <translation>Durch einen Körper mit Kapsel lässt sich kein Schnitt weiterführen.</translation>
    </message>
    <message>
        <source>Leave the capsule out, or cut before the rehearsal.</source>
        <translation>Lassen Sie die Kapsel weg, oder schneiden Sie vor der Probe.</translation>
    </message>
    <message>
        <source>The cut&apos;s advance needs two different places to go between.</source>
        <translation>Das Weiterführen des Schnitts braucht zwei verschiedene Orte, zwischen denen es verläuft.</translation>
    </message>
    <message>
        <source>The cut crosses an earlier one, whose walls would have to be divided too.</source>
        <translation>Der Schnitt kreuzt einen früheren, dessen Wände auch geteilt werden müssten.</translation>
    </message>
    <message>
        <source>The cut opens nothing: all that lies along it is open already, held, or outside of the body.</source>
        <translation>Der Schnitt öffnet nichts: Alles entlang davon ist schon offen, festgehalten oder außerhalb des Körpers.</translation>
    </message>
    <message>
        <source>The body&apos;s answer to the cut was not found: the relative residual stayed at {0}.</source>
        <translation>Die Antwort des Körpers auf den Schnitt wurde nicht gefunden: Das relative Residuum blieb bei {0}.</translation>
    </message>
    <message>
        <source>Nothing would hold the part that this cut separates.</source>
        <translation>Nichts würde den Teil halten, den dieser Schnitt abtrennt.</translation>
    </message>
    <message>
        <source>Stop before the last bridge of tissue.</source>
        <translation>Hören Sie vor der letzten Gewebebrücke auf.</translation>
    </message>
    <message>
        <source>{0} must be whole numbers from 1 to 8, Couinaud&apos;s segments.</source>
        <translation>{0} müssen ganze Zahlen von 1 bis 8 sein, die Segmente nach Couinaud.</translation>
    </message>
    <message>
        <source>{0} is not of the format glisson-plan/1.</source>
        <translation>{0} hat nicht das Format glisson-plan/1.</translation>
    </message>
    <message>
        <source>{0} needs at least one cut in its list of cuts.</source>
        <translation>{0} braucht mindestens einen Schnitt in der Liste cuts.</translation>
    </message>
    <message>
        <source>A plan takes at most 255 tumours; there are {0}.</source>
        <translation>Ein Plan fasst höchstens 255 Tumoren; es sind {0}.</translation>
    </message>
    <message>
        <source>The liver&apos;s outline is empty.</source>
        <translation>Der Umriss der Leber ist leer.</translation>
    </message>
    <message>
        <source>looking what hangs on which vessel</source>
        <translation>sucht, was an welchem Gefäß hängt</translation>
    </message>
    <message>
        <source>looking at segments and stiffness</source>
        <translation>sieht Segmente und Steifigkeit an</translation>
    </message>
    <message>
        <source>looking around the tumours</source>
        <translation>sieht um die Tumoren herum nach</translation>
    </message>
    <message>
        <source>The plan holds no cut.</source>
        <translation>Der Plan enthält keinen Schnitt.</translation>
    </message>
    <message>
        <source>The plan takes the whole liver: nothing would be left.</source>
        <translation>Der Plan nimmt die ganze Leber: Es bliebe nichts.</translation>
    </message>
    <message>
        <source>The liver&apos;s segments are not known yet.</source>
        <translation>Die Segmente der Leber sind noch nicht bekannt.</translation>
    </message>
    <message>
        <source>Find them first (glisson-cli territories).</source>
        <translation>Bestimmen Sie sie zuerst (glisson-cli territories).</translation>
    </message>
    <message>
        <source>The plan names no segment to take: give numbers from 1 to 8.</source>
        <translation>Der Plan nennt kein Segment: Geben Sie Nummern von 1 bis 8 an.</translation>
    </message>
    <message>
        <source>There is no segment {0}: Couinaud&apos;s are 1 to 8.</source>
        <translation>Es gibt kein Segment {0}: Die nach Couinaud sind 1 bis 8.</translation>
    </message>
    <message>
        <source>Segment {0} holds no tissue of this liver.</source>
        <translation>Segment {0} enthält kein Gewebe dieser Leber.</translation>
    </message>
    <message>
        <source>There is no branch {0} in the vessel trees.</source>
        <translation>Es gibt keinen Ast {0} in den Gefäßbäumen.</translation>
    </message>
    <message>
        <source>glisson-cli vessels lists their names; portal/right/posterior stands for all that begin so.</source>
        <translation>glisson-cli vessels nennt ihre Namen; portal/right/posterior steht für alle, die so beginnen.</translation>
    </message>
    <message>
        <source>No tissue of the liver belongs to the branch {0}.</source>
        <translation>Kein Gewebe der Leber gehört zum Ast {0}.</translation>
    </message>
    <message>
        <source>Take a branch nearer to the stem.</source>
        <translation>Nehmen Sie einen Ast näher am Stamm.</translation>
    </message>
    <message>
        <source>There is no tumour {0} in the liver.</source>
        <translation>Es gibt keinen Tumor {0} in der Leber.</translation>
    </message>
    <message>
        <source>Give the name of a structure of the case that lies in the liver.</source>
        <translation>Nennen Sie eine Struktur des Falls, die in der Leber liegt.</translation>
    </message>
    <message>
        <source>The margin around {0} must be 0 to {1} mm.</source>
        <translation>Der Abstand um {0} muss 0 bis {1} mm sein.</translation>
    </message>
    <message>
        <source>The planned cut passes the liver by.</source>
        <translation>Der geplante Schnitt geht an der Leber vorbei.</translation>
    </message>
    <message>
        <source>Plans compared</source>
        <translation>Pläne im Vergleich</translation>
    </message>
    <message>
        <source>{0} no longer holds: {1}</source>
        <translation>{0} gilt nicht mehr: {1}</translation>
    </message>
    <message>
        <source>What {0} was made from has changed since it was kept.</source>
        <translation>Woraus {0} gemacht wurde, hat sich seither geändert.</translation>
    </message>
    <message>
        <source>Per cent are of the liver without its tumours. Thresholds are the surgeon&apos;s to set.</source>
        <translation>Prozente gelten für die Leber ohne ihre Tumoren. Schwellen setzt der Chirurg.</translation>
    </message>
    <message>
        <source>Removed (ml)</source>
        <translation>Entfernt (ml)</translation>
    </message>
    <message>
        <source>Left (ml)</source>
        <translation>Bleibt (ml)</translation>
    </message>
    <message>
        <source>Left (%)</source>
        <translation>Bleibt (%)</translation>
    </message>
    <message>
        <source>Left and alive: perfused and drained (ml)</source>
        <translation>Bleibt lebend: durchblutet und drainiert (ml)</translation>
    </message>
    <message>
        <source>Left and alive (%)</source>
        <translation>Bleibt lebend (%)</translation>
    </message>
    <message>
        <source>Left without inflow: ischaemic (ml)</source>
        <translation>Bleibt ohne Zufluss: ischämisch (ml)</translation>
    </message>
    <message>
        <source>Left without outflow: congested (ml)</source>
        <translation>Bleibt ohne Abfluss: gestaut (ml)</translation>
    </message>
    <message>
        <source>Smallest margin (mm)</source>
        <translation>Kleinster Abstand (mm)</translation>
    </message>
    <message>
        <source>Tumours cut through or left</source>
        <translation>Tumoren durchschnitten oder belassen</translation>
    </message>
    <message>
        <source>Stiffness of what is left (kPa)</source>
        <translation>Steifigkeit des Bleibenden (kPa)</translation>
    </message>
    <message>
        <source>Measured share of it (%)</source>
        <translation>Davon gemessen (%)</translation>
    </message>
    <message>
        <source>What stays of each segment, in ml.</source>
        <translation>Was von jedem Segment bleibt, in ml.</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ast</translation>
    </message>
    <message>
        <source>Make the demo anew.</source>
        <translation>Erstellen Sie die Demo neu.</translation>
    </message>
    <message>
        <source>{0} has no tumour to be found.</source>
        <translation>{0} hat keinen Tumor, der zu finden wäre.</translation>
    </message>
    <message>
        <source>The liver of {0} was found in no frame of its own video.</source>
        <translation>Die Leber von {0} wurde in keinem Bild ihres eigenen Videos gefunden.</translation>
    </message>
    <message>
        <source>The case has no plan to compare.</source>
        <translation>Der Fall hat keinen Plan zum Vergleichen.</translation>
    </message>
    <message>
        <source>Add some first: glisson-cli plan CASE --add PLAN.json.</source>
        <translation>Fügen Sie zuerst welche hinzu: glisson-cli plan CASE --add PLAN.json.</translation>
    </message>
    <message>
        <source>Writing the video</source>
        <translation>Video wird geschrieben</translation>
    </message>
    <message>
        <source>Place the liver by hand</source>
        <translation>Leber von Hand einpassen</translation>
    </message>
    <message>
        <source>Reading the sequence</source>
        <translation>Sequenz wird gelesen</translation>
    </message>
    <message>
        <source>Reading the clouds</source>
        <translation>Punktwolken werden gelesen</translation>
    </message>
    <message>
        <source>The plan was set on the liver as it was held aside: set it at rest to cut along it here.</source>
        <translation>Der Plan wurde an der zur Seite gehaltenen Leber gesetzt: Setzen Sie ihn in Ruhe, um hier daran entlang zu schneiden.</translation>
    </message>
    <message>
        <source>Keep the plan {0}</source>
        <translation>Den Plan {0} behalten</translation>
    </message>
    <message>
        <source>Drop the plan {0}</source>
        <translation>Den Plan {0} verwerfen</translation>
    </message>
    <message>
        <source>The outline fills {0} % of the body in its slices, a person&apos;s liver less than half: it is not the liver alone, or these are images of an animal or a phantom.</source>
        <translation>Der Umriss füllt {0} % des Körpers in seinen Schichten, die Leber eines Menschen weniger als die Hälfte: Er ist nicht die Leber allein, oder dies sind Bilder eines Tiers oder Phantoms.</translation>
    </message>
    <message>
        <source>{0} ml is less than any person&apos;s liver holds: the outline is a part of it, or these are images of an animal or a phantom.</source>
        <translation>{0} ml sind weniger, als die Leber irgendeines Menschen fasst: Der Umriss ist ein Teil von ihr, oder dies sind Bilder eines Tiers oder Phantoms.</translation>
    </message>
    <message>
        <source>{0} needs one of plane, sheet, segments, territory, around, ablation.</source>
        <translation>{0} braucht eines von plane, sheet, segments, territory, around, ablation.</translation>
    </message>
    <message>
        <source>An ablation needs a direction, and radii of more than 0 and at most {0} mm.</source>
        <translation>Eine Ablation braucht eine Richtung und Radien von mehr als 0 und höchstens {0} mm.</translation>
    </message>
    <message>
        <source>The ablation lies beside the liver.</source>
        <translation>Die Ablation liegt neben der Leber.</translation>
    </message>
    <message>
        <source>Move it into the liver; positions are patient coordinates (LPS, mm).</source>
        <translation>Schieben Sie sie in die Leber; Orte sind Patientenkoordinaten (LPS, mm).</translation>
    </message>
    <message>
        <source>{0}: the cut unrolled flat. Purple: tumour; red: less than 5 mm from one; amber: less than 10 mm. Rings: vessels that are cut.</source>
        <translation>{0}: der Schnitt flach ausgerollt. Violett: Tumor; rot: weniger als 5 mm von einem entfernt; gelb: weniger als 10 mm. Ringe: Gefäße, die durchtrennt werden.</translation>
    </message>
    <message>
        <source>Left, of the body&apos;s weight (%)</source>
        <translation>Bleibt, vom Körpergewicht (%)</translation>
    </message>
    <message>
        <source>Left and alive, of the body&apos;s weight (%)</source>
        <translation>Bleibt und lebt, vom Körpergewicht (%)</translation>
    </message>
    <message>
        <source>No worse in margin, tissue and tumours, and better in one</source>
        <translation>Bei Rand, Gewebe und Tumoren nirgends schlechter und in einem besser</translation>
    </message>
    <message>
        <source>What a wider margin costs.</source>
        <translation>Was ein breiterer Rand kostet.</translation>
    </message>
    <message>
        <source>smallest margin (mm)</source>
        <translation>kleinster Rand (mm)</translation>
    </message>
    <message>
        <source>left and alive (ml)</source>
        <translation>bleibt und lebt (ml)</translation>
    </message>
    <message>
        <source>--study and --plan serve a DICOM SEG alone (--format dicom-seg).</source>
        <translation>--study und --plan gelten nur für ein DICOM SEG (--format dicom-seg).</translation>
    </message>
    <message>
        <source>Line {1} of {0} is not landmark,frame,x_mm,y_mm,z_mm of a landmark in the tracks, with &quot;model&quot; or a frame below {2}.</source>
        <translation>Zeile {1} von {0} ist nicht landmark,frame,x_mm,y_mm,z_mm einer verfolgten Landmarke, mit &quot;model&quot; oder einem Bild unter {2}.</translation>
    </message>
    <message>
        <source>Make the sequence anew, or leave &quot;benchmark&quot; out of it.</source>
        <translation>Erstellen Sie die Sequenz neu, oder lassen Sie &quot;benchmark&quot; weg.</translation>
    </message>
    <message>
        <source>each point was aligned without a fifth of the landmarks, the one nearest to it among them</source>
        <translation>jeder Punkt wurde ohne ein Fünftel der Landmarken ausgerichtet, darunter die ihm nächste</translation>
    </message>
    <message>
        <source>benchmark is no file name</source>
        <translation>benchmark ist kein Dateiname</translation>
    </message>
    <message>
        <source>judged by its own landmarks, without a benchmark kept with the sequence: a fault that never changes is hardly seen</source>
        <translation>anhand der eigenen Landmarken beurteilt, ohne einen Vergleichsmaßstab in der Sequenz: ein Fehler, der sich nie ändert, ist kaum zu sehen</translation>
    </message>
    <message>
        <source>&quot;frames&quot; must be a list with at least one frame.</source>
        <translation>&quot;frames&quot; muss eine Liste mit mindestens einem Bild sein.</translation>
    </message>
    <message>
        <source>{0} must be a rigid motion: 16 numbers, row by row, scan to camera.</source>
        <translation>{0} muss eine starre Bewegung sein: 16 Zahlen, Zeile für Zeile, vom Scan zur Kamera.</translation>
    </message>
    <message>
        <source>Is it stretched or mirrored, or given column by column?</source>
        <translation>Ist sie gedehnt oder gespiegelt, oder spaltenweise angegeben?</translation>
    </message>
    <message>
        <source>{0} holds no points.</source>
        <translation>{0} enthält keine Punkte.</translation>
    </message>
    <message>
        <source>In {0} most points of {1} lie farther than {2} mm from the organ, as the pose has it.</source>
        <translation>In {0} liegen die meisten Punkte von {1} nach der angegebenen Lage weiter als {2} mm vom Organ entfernt.</translation>
    </message>
    <message>
        <source>Are they in metres, in another camera&apos;s frame, or is &quot;pose_guess&quot; that of another frame?</source>
        <translation>Sind sie in Metern, im System einer anderen Kamera, oder ist &quot;pose_guess&quot; die eines anderen Bildes?</translation>
    </message>
    <message>
        <source>In {0} more than one tool touches the organ.</source>
        <translation>In {0} berührt mehr als ein Instrument das Organ.</translation>
    </message>
    <message>
        <source>An experiment takes frames with one tool, or none.</source>
        <translation>Ein Experiment nimmt Bilder mit einem Instrument oder keinem.</translation>
    </message>
    <message>
        <source>Two frames have the id &quot;{0}&quot;.</source>
        <translation>Zwei Bilder haben die Kennung &quot;{0}&quot;.</translation>
    </message>
    <message>
        <source>{0} names no frames.</source>
        <translation>{0} nennt keine Bilder.</translation>
    </message>
    <message>
        <source>{0} names the frame &quot;{1}&quot;, which is not there.</source>
        <translation>{0} nennt das Bild &quot;{1}&quot;, das es nicht gibt.</translation>
    </message>
    <message>
        <source>The frame &quot;{0}&quot; belongs to two trials.</source>
        <translation>Das Bild &quot;{0}&quot; gehört zu zwei Versuchen.</translation>
    </message>
    <message>
        <source>Name each frame in one trial, or leave &quot;trials&quot; out: each frame is one then.</source>
        <translation>Nennen Sie jedes Bild in einem Versuch, oder lassen Sie &quot;trials&quot; weg: dann ist jedes Bild einer.</translation>
    </message>
    <message>
        <source>Repeat the longest trial at half of its current or load.</source>
        <translation>Den längsten Versuch mit halbem Strom oder halber Last wiederholen.</translation>
    </message>
    <message>
        <source>Repeat the longest trial at twice its current or load.</source>
        <translation>Den längsten Versuch mit doppeltem Strom oder doppelter Last wiederholen.</translation>
    </message>
    <message>
        <source>Repeat the longest trial in a room that is 15 °C warmer.</source>
        <translation>Den längsten Versuch in einem um 15 °C wärmeren Raum wiederholen.</translation>
    </message>
    <message>
        <source>A finer mesh would change the prediction; {0} % of what it would change shows in the measurements and is taken off what the better model predicts.</source>
        <translation>Ein feineres Netz würde die Vorhersage ändern; {0} % dieser Änderung zeigen sich in den Messungen und sind von der Vorhersage des besseren Modells abgezogen.</translation>
    </message>
    <message>
        <source>There is only one trial, so nothing could be predicted that was not fitted.</source>
        <translation>Es gibt nur einen Versuch; vorhergesagt werden konnte also nichts, woran nicht angepasst wurde.</translation>
    </message>
    <message>
        <source>The residual is not quite random, but no larger than the noise can be trusted to be.</source>
        <translation>Das Residuum ist nicht ganz zufällig, aber nicht größer, als das Rauschen verlässlich angegeben ist.</translation>
    </message>
    <message>
        <source>The residual is not quite random, but no larger than what a finer mesh would change of the prediction.</source>
        <translation>Das Residuum ist nicht ganz zufällig, aber nicht größer als das, was ein feineres Netz an der Vorhersage ändern würde.</translation>
    </message>
    <message>
        <source>{0} was left out: {1}</source>
        <translation>{0} wurde weggelassen: {1}</translation>
    </message>
    <message>
        <source>These data do not determine {0} of {1}.</source>
        <translation>Diese Daten bestimmen {0} nicht (Effekt: {1}).</translation>
    </message>
    <message>
        <source>{0} of {1} ended at the limit of its range ({2}).</source>
        <translation>{0} endete an der Grenze des zulässigen Bereichs ({2}; Effekt: {1}).</translation>
    </message>
    <message>
        <source>{0} and {1} can hardly be told apart in size (correlation {2}).</source>
        <translation>„{0}“ und „{1}“ lassen sich in ihrer Größe kaum trennen (Korrelation {2}).</translation>
    </message>
    <message>
        <source>there is nowhere to begin</source>
        <translation>es gibt keinen Anfangswert</translation>
    </message>
    <message>
        <source>it promised to take much less of the error than others</source>
        <translation>es versprach, viel weniger vom Fehler wegzunehmen als andere</translation>
    </message>
    <message>
        <source>Deform ten times as slowly.</source>
        <translation>Zehnmal so langsam verformen.</translation>
    </message>
    <message>
        <source>Deform ten times as fast.</source>
        <translation>Zehnmal so schnell verformen.</translation>
    </message>
    <message>
        <source>Deform quickly and hold for the length of the longest trial.</source>
        <translation>Rasch verformen und so lange halten, wie der längste Versuch dauert.</translation>
    </message>
    <message>
        <source>Load and unload twice.</source>
        <translation>Zweimal belasten und entlasten.</translation>
    </message>
    <message>
        <source>Deform a fifth further.</source>
        <translation>Um ein Fünftel weiter verformen.</translation>
    </message>
    <message>
        <source>Deform to the other side (tension in place of compression, or the reverse).</source>
        <translation>Zur anderen Seite verformen (Zug statt Druck oder umgekehrt).</translation>
    </message>
    <message>
        <source>Press at ({0}, {1}, {2}) mm with {3} N.</source>
        <translation>Bei ({0}, {1}, {2}) mm mit {3} N drücken.</translation>
    </message>
    <message>
        <source>Press as in trial {0}, but with {1} N.</source>
        <translation>Wie in Versuch {0} drücken, aber mit {1} N.</translation>
    </message>
    <message>
        <source>Press as in trial {0} and hold the force for {1} s.</source>
        <translation>Wie in Versuch {0} drücken und die Kraft {1} s lang halten.</translation>
    </message>
    <message>
        <source>Pull where trial {0} presses, with {1} N.</source>
        <translation>Dort ziehen, wo Versuch {0} drückt, mit {1} N.</translation>
    </message>
    <message>
        <source>Error by load, a line a trial: broken before, whole after</source>
        <translation>Fehler über der Last, eine Linie je Versuch: gestrichelt vorher, durchgezogen nachher</translation>
    </message>
    <message>
        <source>Measured (dots), before (broken), after (line)</source>
        <translation>Gemessen (Punkte), vorher (gestrichelt), nachher (Linie)</translation>
    </message>
    <message>
        <source>What was left before (broken) and after (line)</source>
        <translation>Was vorher (gestrichelt) und nachher (Linie) blieb</translation>
    </message>
    <message>
        <source>{0} was made on the data &quot;{1}&quot;, {2} on &quot;{3}&quot;.</source>
        <translation>{0} wurde mit den Daten „{1}“ gemacht, {2} mit „{3}“.</translation>
    </message>
    <message>
        <source>{0} and {1} have no case in common.</source>
        <translation>{0} und {1} haben keinen Fall gemeinsam.</translation>
    </message>
    <message>
        <source>Name the same cases in the first column of both metrics.csv.</source>
        <translation>Nennen Sie in der ersten Spalte beider metrics.csv dieselben Fälle.</translation>
    </message>
    <message>
        <source>The tolerances name {0}, which neither {1} nor {2} has.</source>
        <translation>Die Toleranzen nennen {0}, was weder {1} noch {2} hat.</translation>
    </message>
    <message>
        <source>{0} must begin with a line case,METRIC,METRIC, ...</source>
        <translation>{0} muss mit einer Zeile case,METRIC,METRIC, ... beginnen.</translation>
    </message>
    <message>
        <source>Column {0} of {1} has no name of its own.</source>
        <translation>Spalte {0} von {1} hat keinen eigenen Namen.</translation>
    </message>
    <message>
        <source>Line {0} of {1} has more cells than the first.</source>
        <translation>Zeile {0} von {1} hat mehr Zellen als die erste.</translation>
    </message>
    <message>
        <source>Line {0} of {1} names no case, or one that was there before.</source>
        <translation>Zeile {0} von {1} nennt keinen Fall oder einen, der schon da war.</translation>
    </message>
    <message>
        <source>{0} holds no case.</source>
        <translation>{0} enthält keinen Fall.</translation>
    </message>
    <message>
        <source>{0} holds no metrics.csv.</source>
        <translation>{0} enthält keine metrics.csv.</translation>
    </message>
    <message>
        <source>Write one: a line case,METRIC,..., then a row for each case.</source>
        <translation>Schreiben Sie eine: eine Zeile case,METRIC,..., dann eine Zeile je Fall.</translation>
    </message>
    <message>
        <source>{0} must lie between 0 and 1.</source>
        <translation>{0} muss zwischen 0 und 1 liegen.</translation>
    </message>
    <message>
        <source>The pictures have different sizes: {0} x {1} and {2} x {3}.</source>
        <translation>Die Bilder sind verschieden groß: {0} x {1} und {2} x {3}.</translation>
    </message>
    <message>
        <source>The mask of the pictures is black everywhere.</source>
        <translation>Die Maske der Bilder ist überall schwarz.</translation>
    </message>
    <message>
        <source>{0}: samples {1}, rows without a reading {2}.</source>
        <translation>{0}: Messwerte {1}, Zeilen ohne Messwert {2}.</translation>
    </message>
    <message>
        <source>Runs in the trace: {0}, in the log: {1}.</source>
        <translation>Läufe in der Aufzeichnung: {0}, im Protokoll: {1}.</translation>
    </message>
    <message>
        <source>Gaps in the recording: {0}; runs end there and nothing is made up for them.</source>
        <translation>Lücken in der Aufzeichnung: {0}; Läufe enden dort, und nichts wird dafür erfunden.</translation>
    </message>
    <message>
        <source>Rows without a reading: {0}.</source>
        <translation>Zeilen ohne Messwert: {0}.</translation>
    </message>
    <message>
        <source>Runs that reach the end of a channel&apos;s range, so that their power is a lower bound: {0}. Record again with a larger range.</source>
        <translation>Läufe, die an das Ende des Messbereichs eines Kanals stoßen, so dass ihre Leistung eine untere Schranke ist: {0}. Mit größerem Messbereich neu aufzeichnen.</translation>
    </message>
    <message>
        <source>{0} declares an impossible size: {1} x {2} pixels, frames: {3}.</source>
        <translation>{0} gibt eine unmögliche Größe an: {1} x {2} Pixel, Einzelbilder: {3}.</translation>
    </message>
    <message>
        <source>The step would turn cells inside out ({0}): a tool goes too far into the body.</source>
        <translation>Der Schritt würde Zellen umstülpen ({0}): Ein Instrument dringt zu weit in den Körper ein.</translation>
    </message>
    <message>
        <source>Cells taken away where the body touched itself in a point or an edge: {0}.</source>
        <translation>Entfernte Zellen, wo der Körper sich selbst in einem Punkt oder einer Kante berührte: {0}.</translation>
    </message>
    <message>
        <source>A landmark was followed through {0} of {1} frames.</source>
        <translation>Eine Landmarke wurde durch {0} von {1} Einzelbildern verfolgt.</translation>
    </message>
    <message>
        <source>Landmarks that lie far from the points of their frames: {0} of {1}.</source>
        <translation>Landmarken, die weit von den Punkten ihrer Einzelbilder liegen: {0} von {1}.</translation>
    </message>
    <message>
        <source>Landmarks seen in three frames or more: {0}; four that do not lie on one line are needed.</source>
        <translation>In drei oder mehr Einzelbildern gesehene Landmarken: {0}; gebraucht werden vier, die nicht auf einer Geraden liegen.</translation>
    </message>
    <message>
        <source>Too few frames to correlate: {0}; {1} are needed.</source>
        <translation>Zu wenige Einzelbilder zum Korrelieren: {0}; gebraucht werden {1}.</translation>
    </message>
    <message>
        <source>Landmark {0} was followed through {1} of {2} frames.</source>
        <translation>Landmarke {0} wurde durch {1} von {2} Einzelbildern verfolgt.</translation>
    </message>
    <message>
        <source>Landmarks left out, which were seen in fewer than three frames: {0}</source>
        <translation>Weggelassene Landmarken, die in weniger als drei Einzelbildern zu sehen waren: {0}</translation>
    </message>
    <message>
        <source>Landmarks left out, which lie far from the points of their frames: {0}</source>
        <translation>Weggelassene Landmarken, die weit von den Punkten ihrer Einzelbilder liegen: {0}</translation>
    </message>
    <message>
        <source>Triangles with all corners in fewer than three frames, whose correlation is 0: {0}</source>
        <translation>Dreiecke mit allen Ecken in weniger als drei Einzelbildern, deren Korrelation 0 ist: {0}</translation>
    </message>
    <message>
        <source>The {0} video ends before the other, at frame {1}.</source>
        <translation>Das Video ({0}) endet vor dem anderen, bei Einzelbild {1}.</translation>
    </message>
    <message>
        <source>Frames that show something: {0}; {1} are needed.</source>
        <translation>Einzelbilder, auf denen etwas zu sehen ist: {0}; gebraucht werden {1}.</translation>
    </message>
    <message>
        <source>Held like this, cells of the liver are turned inside out ({0}): nothing can be measured there.</source>
        <translation>So gehalten sind Zellen der Leber umgestülpt ({0}): Dort lässt sich nichts messen.</translation>
    </message>
    <message>
        <source>The structures have changed since the model was built. Landmarks that now lie outside of it are left out ({0}). Build the model anew.</source>
        <translation>Die Strukturen haben sich geändert, seit das Modell gebaut wurde. Landmarken, die jetzt außerhalb liegen, sind weggelassen ({0}). Das Modell neu bauen.</translation>
    </message>
    <message>
        <source>Frames that belong to no trial: {0}.</source>
        <translation>Bilder, die zu keinem Versuch gehören: {0}.</translation>
    </message>
    <message>
        <source>The benchmark is not of this sequence, with its landmarks ({0}) and frames ({1}).</source>
        <translation>Der Vergleichsmaßstab gehört nicht zu dieser Sequenz mit ihren Landmarken ({0}) und Bildern ({1}).</translation>
    </message>
    <message>
        <source>landmarks that the benchmark has no place for were left out: {0}</source>
        <translation>weggelassene Landmarken, für die der Vergleichsmaßstab keinen Ort hat: {0}</translation>
    </message>
    <message>
        <source>The history of {0} has no step {1}.</source>
        <translation>Der Verlauf von {0} hat keinen Schritt {1}.</translation>
    </message>
    <message>
        <source>See which there are: glisson-cli macro CASE.</source>
        <translation>Sehen Sie nach, welche es gibt: glisson-cli macro CASE.</translation>
    </message>
    <message>
        <source>Step {1} of {0} changed a view and nothing in the case.</source>
        <translation>Schritt {1} von {0} hat eine Ansicht geändert und nichts im Fall.</translation>
    </message>
    <message>
        <source>Step {0} of {1} began with another {2} than {3} holds.</source>
        <translation>Schritt {0} von {1} begann mit einem anderen Stand von {2}, als {3} ihn hat.</translation>
    </message>
    <message>
        <source>Begin with the case as it was, and do all steps in their order.</source>
        <translation>Beginnen Sie mit dem Fall, wie er war, und tun Sie alle Schritte in ihrer Reihenfolge.</translation>
    </message>
    <message>
        <source>{0} no longer holds what a step of its history led to: {1}.</source>
        <translation>{0} enthält nicht mehr, wohin ein Schritt seines Verlaufs geführt hat: {1}.</translation>
    </message>
    <message>
        <source>Another program has changed it; do this step in the window.</source>
        <translation>Ein anderes Programm hat es geändert; tun Sie diesen Schritt im Fenster.</translation>
    </message>
    <message>
        <source>No case fits in {0} minutes.</source>
        <translation>In {0} Minuten passt kein Fall.</translation>
    </message>
    <message>
        <source>Give more minutes, or a history with shorter cases.</source>
        <translation>Geben Sie mehr Minuten oder einen Verlauf mit kürzeren Fällen.</translation>
    </message>
    <message>
        <source>{0} must begin with a line case,seconds,METRIC, ... and hold a row a case a run.</source>
        <translation>{0} muss mit einer Zeile case,seconds,MASS, ... beginnen und je Fall und Lauf eine Zeile haben.</translation>
    </message>
    <message>
        <source>A column of {0} is there twice.</source>
        <translation>Eine Spalte von {0} kommt zweimal vor.</translation>
    </message>
    <message>
        <source>Line {0} of {1} names no case, or has more cells than the first.</source>
        <translation>Zeile {0} von {1} nennt keinen Fall oder hat mehr Felder als die erste.</translation>
    </message>
    <message>
        <source>{0} names no case.</source>
        <translation>{0} nennt keinen Fall.</translation>
    </message>
    <message>
        <source>Make it with glisson-cli gate-cases.</source>
        <translation>Machen Sie sie mit glisson-cli gate-cases.</translation>
    </message>
    <message>
        <source>Stiffness from the waves</source>
        <translation>Steifigkeit aus den Wellen</translation>
    </message>
    <message>
        <source>A frame is this program&apos;s own: {0}. Carried over from another machine in proportion to memory and arithmetic; nobody has run it on these platforms.</source>
        <translation>Ein Bild ist dieses Programms eigenes: {0}. Im Verhältnis von Speicher und Rechenleistung von einem anderen Rechner übertragen; auf diesen Plattformen hat es niemand laufen lassen.</translation>
    </message>
    <message>
        <source>The task {0} moves no bytes and takes no operations.</source>
        <translation>Die Aufgabe {0} bewegt keine Bytes und braucht keine Operationen.</translation>
    </message>
    <message>
        <source>{0} has no list &quot;tasks&quot; of 1 to {1} tasks.</source>
        <translation>{0} hat keine Liste &quot;tasks&quot; mit 1 bis {1} Aufgaben.</translation>
    </message>
    <message>
        <source>Two tasks have the id &quot;{0}&quot;.</source>
        <translation>Zwei Aufgaben haben die Kennung &quot;{0}&quot;.</translation>
    </message>
    <message>
        <source>A support that moves by a displacement is there for equilibrium by finite elements, without tools, motion, walls kept apart and data in place of a law.</source>
        <translation>Eine Auflage, die sich um eine Verschiebung bewegt, gibt es beim Gleichgewicht mit finiten Elementen, ohne Werkzeuge, Bewegung, getrennt gehaltene Wände und Daten anstelle eines Gesetzes.</translation>
    </message>
    <message>
        <source>The displacement of support {0} is not a finite vector.</source>
        <translation>Die Verschiebung der Auflage {0} ist kein endlicher Vektor.</translation>
    </message>
    <message>
        <source>Support {0} moves points that another support holds or moves elsewhere.</source>
        <translation>Auflage {0} bewegt Punkte, die eine andere Auflage festhält oder anderswohin bewegt.</translation>
    </message>
    <message>
        <source>Let each point be held by one support, or in other directions.</source>
        <translation>Jeder Punkt sollte von einer Auflage gehalten werden, oder in anderen Richtungen.</translation>
    </message>
    <message>
        <source>{0} moves by a displacement: it is neither a foundation nor a ligament.</source>
        <translation>{0} bewegt sich um eine Verschiebung: das ist weder eine Bettung noch ein Band.</translation>
    </message>
    <message>
        <source>{0} is moved in a direction that its &quot;directions&quot; leave free.</source>
        <translation>{0} wird in einer Richtung bewegt, die seine &quot;directions&quot; frei lassen.</translation>
    </message>
    <message>
        <source>Resolutions must grow from 0.5 mm3 or more to 1700 mm3 or less, in 2 to 100 steps.</source>
        <translation>Auflösungen müssen von mindestens 0.5 mm3 bis höchstens 1700 mm3 wachsen, in 2 bis 100 Schritten.</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Abtasten</translation>
    </message>
    <message>
        <source>The matching study takes ascending numbers of points from 8 to 1024, starts of 0 or more, 1 to 1000 passes and livers, and two or more poses of each shape.</source>
        <translation>Die Studie der Zuordnung nimmt aufsteigende Punktzahlen von 8 bis 1024, Anfänge ab 0, 1 bis 1000 Durchgänge und Lebern sowie zwei oder mehr Stellungen jeder Form.</translation>
    </message>
    <message>
        <source>There is no task &quot;{0}&quot;.</source>
        <translation>Es gibt keine Aufgabe &quot;{0}&quot;.</translation>
    </message>
    <message>
        <source>Use product or one of: {1}.</source>
        <translation>Verwenden Sie product oder eine von: {1}.</translation>
    </message>
    <message>
        <source>The hidden targets, which nothing was fitted to, are farther off with what was found ({0} mm on average) than without it ({1} mm): do not take it for the cause.</source>
        <translation>Die verborgenen Ziele, an die nichts angepasst wurde, liegen mit dem Gefundenen weiter daneben (im Mittel {0} mm) als ohne ({1} mm): Halten Sie es nicht für die Ursache.</translation>
    </message>
    <message>
        <source>Copy the plan {0}</source>
        <translation>Plan {0} kopieren</translation>
    </message>
    <message>
        <source>Set an ablation zone</source>
        <translation>Ablationszone setzen</translation>
    </message>
    <message>
        <source>Cut around a tumour</source>
        <translation>Schnitt um einen Tumor</translation>
    </message>
    <message>
        <source>Cut along a territory</source>
        <translation>Schnitt entlang eines Versorgungsgebiets</translation>
    </message>
    <message>
        <source>Cut by segments</source>
        <translation>Schnitt nach Segmenten</translation>
    </message>
    <message>
        <source>Change an ablation zone</source>
        <translation>Ablationszone ändern</translation>
    </message>
    <message>
        <source>Give back what was to go</source>
        <translation>Zurückgeben, was wegfallen sollte</translation>
    </message>
    <message>
        <source>No branch is named that is to be embolised.</source>
        <translation>Kein Ast ist genannt, der embolisiert werden soll.</translation>
    </message>
    <message>
        <source>A growth of {0} % is not between 0 and {1} %.</source>
        <translation>Ein Wachstum von {0} % liegt nicht zwischen 0 und {1} %.</translation>
    </message>
    <message>
        <source>{0} is no branch of the portal vein.</source>
        <translation>{0} ist kein Ast der Pfortader.</translation>
    </message>
    <message>
        <source>The tool {0} spreads its force over a patch, which a session knows at large strain alone.</source>
        <translation>Das Instrument {0} verteilt seine Kraft über eine Fläche, was eine Sitzung nur bei großen Dehnungen kennt.</translation>
    </message>
    <message>
        <source>Take the material neo-hookean, or jaws that pull.</source>
        <translation>Nehmen Sie das Material neo-hookean oder Backen, die ziehen.</translation>
    </message>
    <message>
        <source>Computed with large deformations (neo-Hookean).</source>
        <translation>Mit großen Verformungen berechnet (neo-Hookesch).</translation>
    </message>
    <message>
        <source>Computed with small deformations (linear).</source>
        <translation>Mit kleinen Verformungen berechnet (linear).</translation>
    </message>
    <message>
        <source>The liver had not come to rest: landmarks are within {0} mm of it.</source>
        <translation>Die Leber war nicht zur Ruhe gekommen: Landmarken sind höchstens {0} mm davon.</translation>
    </message>
    <message>
        <source>This is no liver as the model&apos;s {0}: {1} mm are left between both, and its modes are {2} standard deviations out on average.</source>
        <translation>Das ist keine Leber wie die {0} des Modells: {1} mm bleiben zwischen beiden, und ihre Moden liegen im Mittel {2} Standardabweichungen außerhalb.</translation>
    </message>
    <message>
        <source>Look at spacing and affine; a resected or transplanted liver cannot be completed by a model of whole ones.</source>
        <translation>Voxelabstand und affine Abbildung prüfen; eine resezierte oder transplantierte Leber kann ein Modell ganzer Lebern nicht ergänzen.</translation>
    </message>
    <message>
        <source>The model&apos;s livers come nearer to this one&apos;s mirror image: left and right are exchanged, or the patient is a rare one.</source>
        <translation>Die Lebern des Modells kommen dem Spiegelbild näher: Links und rechts sind vertauscht, oder der Patient ist ein seltener Fall.</translation>
    </message>
    <message>
        <source>Look at the file&apos;s affine: which way its first axis runs.</source>
        <translation>Die affine Abbildung der Datei prüfen: wohin ihre erste Achse läuft.</translation>
    </message>
    <message>
        <source>The liver&apos;s mirror image is more like a liver ({0} mm from a typical one, against {1} mm): left and right are exchanged, or the patient is a rare one.</source>
        <translation>Das Spiegelbild der Leber gleicht eher einer Leber ({0} mm von einer typischen gegen {1} mm): Links und rechts sind vertauscht, oder der Patient ist ein seltener Fall.</translation>
    </message>
    <message>
        <source>A typical liver cannot be bent onto this one: {0} mm are left on average.</source>
        <translation>Eine typische Leber lässt sich nicht auf diese biegen: {0} mm bleiben im Mittel.</translation>
    </message>
    <message>
        <source>Look whether the labels are one whole liver, neither resected nor transplanted.</source>
        <translation>Prüfen, ob die Labels eine ganze Leber sind, weder reseziert noch transplantiert.</translation>
    </message>
    <message>
        <source>No liver of {0} drawn from the model is a body of 400 to 5000 ml.</source>
        <translation>Keine von {0} aus dem Modell gezogenen Lebern ist ein Körper von 400 bis 5000 ml.</translation>
    </message>
    <message>
        <source>The liver has {0} ml, which no adult&apos;s liver has.</source>
        <translation>Die Leber hat {0} ml, was keine Leber eines Erwachsenen hat.</translation>
    </message>
    <message>
        <source>Look whether the labels&apos; spacing is the scan&apos;s and all of them are liver.</source>
        <translation>Prüfen, ob der Voxelabstand der Labels der des Scans ist und alle Leber sind.</translation>
    </message>
    <message>
        <source>All voxels are said to be 1 x 1 x 1 mm, as in files that have lost their spacing; the liver&apos;s size would be a guess.</source>
        <translation>Alle Voxel sollen 1 x 1 x 1 mm groß sein, wie in Dateien, die ihren Voxelabstand verloren haben; die Größe der Leber wäre geraten.</translation>
    </message>
    <message>
        <source>Write the scan&apos;s spacing into the labels, or say that it is true.</source>
        <translation>Den Voxelabstand des Scans in die Labels schreiben oder sagen, dass er stimmt.</translation>
    </message>
    <message>
        <source>No voxel of the labels is a liver&apos;s.</source>
        <translation>Kein Voxel der Labels gehört zu einer Leber.</translation>
    </message>
    <message>
        <source>The liver lies in pieces that do not touch; the second of them holds {0} %.</source>
        <translation>Die Leber liegt in Stücken, die sich nicht berühren; das zweite enthält {0} %.</translation>
    </message>
    <message>
        <source>Mend the labels, or take the piece that is the liver.</source>
        <translation>Die Labels ausbessern oder das Stück nehmen, das die Leber ist.</translation>
    </message>
    <message>
        <source>The file is no shape model: its point array {0} is missing or damaged.</source>
        <translation>Die Datei ist kein Formmodell: Ihr Punktfeld {0} fehlt oder ist beschädigt.</translation>
    </message>
    <message>
        <source>Give a model.vtp that &quot;study shapes&quot; has made.</source>
        <translation>Eine model.vtp angeben, die &quot;study shapes&quot; gemacht hat.</translation>
    </message>
    <message>
        <source>fitting the shape</source>
        <translation>Form wird angepasst</translation>
    </message>
    <message>
        <source>What is seen of the liver does not come to lie on the model anywhere.</source>
        <translation>Was von der Leber zu sehen ist, kommt nirgends auf dem Modell zu liegen.</translation>
    </message>
    <message>
        <source>Look whether it is in the patient&apos;s frame (LPS, mm) and is a liver.</source>
        <translation>Prüfen, ob es im Koordinatensystem des Patienten liegt (LPS, mm) und eine Leber ist.</translation>
    </message>
    <message>
        <source>A shape model needs {0} shapes or more; there are {1}.</source>
        <translation>Ein Formmodell braucht {0} Formen oder mehr; es gibt {1}.</translation>
    </message>
    <message>
        <source>The shapes have different points or triangles.</source>
        <translation>Die Formen haben verschiedene Punkte oder Dreiecke.</translation>
    </message>
    <message>
        <source>The image cuts the liver off towards {0}: a model learns from whole ones.</source>
        <translation>Das Bild schneidet die Leber ab, Richtung: {0}. Ein Modell lernt aus ganzen.</translation>
    </message>
    <message>
        <source>The folder holds no label maps of livers.</source>
        <translation>Der Ordner enthält keine Labelkarten von Lebern.</translation>
    </message>
    <message>
        <source>Give one with a file a liver, as ID_liver.nii.gz.</source>
        <translation>Einen mit einer Datei je Leber angeben, wie ID_liver.nii.gz.</translation>
    </message>
    <message>
        <source>Small or large deformations</source>
        <translation>Kleine oder große Verformungen</translation>
    </message>
    <message>
        <source>The whole organ is stiffer or softer than declared, everywhere by the same factor.</source>
        <translation>Das ganze Organ ist steifer oder weicher als angegeben, überall um denselben Faktor.</translation>
    </message>
    <message>
        <source>What holds the organ gives way like a spring: all of it moves when a tool moves it.</source>
        <translation>Was das Organ hält, gibt nach wie eine Feder: es bewegt sich als Ganzes, wenn ein Instrument es bewegt.</translation>
    </message>
    <message>
        <source>The camera stands elsewhere than declared: everything is seen turned and shifted alike.</source>
        <translation>Die Kamera steht anderswo als angegeben: alles wird gleich gedreht und verschoben gesehen.</translation>
    </message>
    <message>
        <source>The tools push with another force than declared, by the same factor in all frames.</source>
        <translation>Die Instrumente drücken mit einer anderen Kraft als angegeben, in allen Bildern um denselben Faktor.</translation>
    </message>
    <message>
        <source>Probability that nothing is missing: {1}; next comes: {2}, {3}.</source>
        <translation>Wahrscheinlichkeit, dass nichts fehlt: {1}; als Nächstes kommt: {2}, {3}.</translation>
    </message>
    <message>
        <source>Probability that nothing is missing: {1}.</source>
        <translation>Wahrscheinlichkeit, dass nichts fehlt: {1}.</translation>
    </message>
    <message>
        <source>Probability of {0}: {1}; next comes: {2}, {3}.</source>
        <translation>Wahrscheinlichkeit von {0}: {1}; als Nächstes kommt: {2}, {3}.</translation>
    </message>
    <message>
        <source>Probability of {0}: {1}.</source>
        <translation>Wahrscheinlichkeit von {0}: {1}.</translation>
    </message>
    <message>
        <source>Probability that something acts which is not in the catalogue: {1}; next comes: {2}, {3}.</source>
        <translation>Wahrscheinlichkeit, dass etwas wirkt, das nicht im Katalog steht: {1}; als Nächstes kommt: {2}, {3}.</translation>
    </message>
    <message>
        <source>Probability that something acts which is not in the catalogue: {1}.</source>
        <translation>Wahrscheinlichkeit, dass etwas wirkt, das nicht im Katalog steht: {1}.</translation>
    </message>
    <message>
        <source>The whole specimen is stiffer or softer than declared, everywhere by the same factor.</source>
        <translation>Die ganze Probe ist steifer oder weicher als angegeben, überall um denselben Faktor.</translation>
    </message>
    <message>
        <source>The tissue stiffens the further it is strained: pressing twice as hard dents it less than twice as deep.</source>
        <translation>Das Gewebe wird steifer, je weiter es gedehnt wird: doppelt so fest gedrückt gibt es weniger als doppelt so tief nach.</translation>
    </message>
    <message>
        <source>What holds the specimen gives way like a spring: all of it moves a little when it is pressed.</source>
        <translation>Was die Probe hält, gibt nach wie eine Feder: sie bewegt sich als Ganzes ein wenig, wenn sie gedrückt wird.</translation>
    </message>
    <message>
        <source>Somewhere inside lies a stiff lump, as a tumour would: around it the specimen moves less.</source>
        <translation>Irgendwo im Inneren liegt ein steifer Knoten, wie ein Tumor: um ihn herum bewegt sich die Probe weniger.</translation>
    </message>
    <message>
        <source>The tissue creeps: held under a steady force it goes on giving way for a while.</source>
        <translation>Das Gewebe kriecht: unter gleichbleibender Kraft gibt es noch eine Weile weiter nach.</translation>
    </message>
    <message>
        <source>The load cell is off: it does not read zero when untouched, or it reads too much or too little.</source>
        <translation>Die Kraftmessdose misst falsch: sie zeigt unberührt nicht null, oder zu viel oder zu wenig.</translation>
    </message>
    <message>
        <source>The camera&apos;s coordinates do not match the specimen&apos;s: all markers seem shifted or turned alike.</source>
        <translation>Die Koordinaten der Kamera passen nicht zu denen der Probe: alle Marker scheinen gleich verschoben oder gedreht.</translation>
    </message>
    <message>
        <source>The tissue has fibres: it is stiffer (or softer) along one direction than across it.</source>
        <translation>Das Gewebe hat eine Faserung: längs einer Richtung ist es steifer (oder weicher) als quer dazu.</translation>
    </message>
    <message>
        <source>A skin around the specimen (as Glisson&apos;s capsule around the liver) carries part of the load.</source>
        <translation>Eine Haut um die Probe (wie die Glisson-Kapsel um die Leber) trägt einen Teil der Last.</translation>
    </message>
    <message>
        <source>Something else loaded the specimen while it was measured, and not when its shape was taken: its weight, or a pressure around it.</source>
        <translation>Etwas anderes belastete die Probe beim Messen, aber nicht, als ihre Form aufgenommen wurde: ihr Gewicht oder ein Druck um sie herum.</translation>
    </message>
    <message>
        <source>× noise</source>
        <translation>× Rauschen</translation>
    </message>
    <message>
        <source>What the declared model lacks, by the measurements</source>
        <translation>Was dem angegebenen Modell nach den Messungen fehlt</translation>
    </message>
    <message>
        <source>What these trials could have shown</source>
        <translation>Was diese Versuche hätten zeigen können</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>A smooth correction over load and place predicts trials better that it was not fitted to. It claims no cause.</source>
        <translation>Eine glatte Korrektur über Last und Ort sagt Versuche besser vorher, an die sie nicht angepasst wurde. Sie nennt keine Ursache.</translation>
    </message>
    <message>
        <source>Candidates, each by itself</source>
        <translation>Kandidaten, jeder für sich</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>What to measure next</source>
        <translation>Was als Nächstes zu messen ist</translation>
    </message>
    <message>
        <source>No further trial is needed to tell the leading explanations apart, or none is known that would.</source>
        <translation>Es braucht keinen weiteren Versuch, um die führenden Erklärungen zu unterscheiden, oder es ist keiner bekannt, der das könnte.</translation>
    </message>
    <message>
        <source>Glisson plans and reviews liver surgery. Not a medical device.</source>
        <translation>Glisson plant und bespricht Leberoperationen. Kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>What is left is noise: no test finds anything that noise would not do.</source>
        <translation>Was übrig ist, ist Rauschen: keine Prüfung findet etwas, das Rauschen nicht täte.</translation>
    </message>
    <message>
        <source>What is left is not noise: {0}.</source>
        <translation>Was übrig ist, ist kein Rauschen: {0}.</translation>
    </message>
    <message>
        <source>From this value on, nine of ten such experiments would have shown the effect</source>
        <translation>Von diesem Wert an hätten neun von zehn solchen Experimenten den Effekt gezeigt</translation>
    </message>
    <message>
        <source>effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>without effect</source>
        <translation>ohne Effekt</translation>
    </message>
    <message>
        <source>seen from</source>
        <translation>zu sehen ab</translation>
    </message>
    <message>
        <source>at no size in its range</source>
        <translation>in keiner Größe seines Bereichs</translation>
    </message>
    <message>
        <source>Errors ({0})</source>
        <translation>Fehler ({0})</translation>
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
        <source>root mean square, trials that were fitted</source>
        <translation>quadratisches Mittel, angepasste Versuche</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>95 of 100 are below</source>
        <translation>95 von 100 liegen darunter</translation>
    </message>
    <message>
        <source>chi-squared over number</source>
        <translation>Chi-Quadrat durch Anzahl</translation>
    </message>
    <message>
        <source>{0} ({1} to {2})</source>
        <translation>{0} ({1} bis {2})</translation>
    </message>
    <message>
        <source>root mean square, trials left out whole</source>
        <translation>quadratisches Mittel, ganz ausgelassene Versuche</translation>
    </message>
    <message>
        <source>hidden targets, which nothing was fitted to: mean (mm)</source>
        <translation>verborgene Ziele, an die nichts angepasst wurde: Mittel (mm)</translation>
    </message>
    <message>
        <source>hidden targets: the farthest (mm)</source>
        <translation>verborgene Ziele: das fernste (mm)</translation>
    </message>
    <message>
        <source>noise of the measurement</source>
        <translation>Rauschen der Messung</translation>
    </message>
    <message>
        <source>Parameters, with standard deviation and 95 % interval</source>
        <translation>Parameter, mit Standardabweichung und 95-%-Intervall</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>could also be</source>
        <translation>könnte auch sein</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>nicht bestimmt</translation>
    </message>
    <message>
        <source>Errors in {0}; the lower the BIC, the better</source>
        <translation>Fehler in {0}; je niedriger das BIC, desto besser</translation>
    </message>
    <message>
        <source>error fitted</source>
        <translation>Fehler angepasst</translation>
    </message>
    <message>
        <source>error on trials left out</source>
        <translation>Fehler an ausgelassenen Versuchen</translation>
    </message>
    <message>
        <source>change of BIC</source>
        <translation>Änderung des BIC</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>left out: {0}</source>
        <translation>ausgelassen: {0}</translation>
    </message>
    <message>
        <source>like {0}</source>
        <translation>wie {0}</translation>
    </message>
    <message>
        <source>Probability of each explanation, all that were weighed taken together</source>
        <translation>Wahrscheinlichkeit jeder Erklärung, alle abgewogenen zusammengenommen</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>etwas anderes</translation>
    </message>
    <message>
        <source>nothing is missing</source>
        <translation>nichts fehlt</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} und {1}</translation>
    </message>
    <message>
        <source>force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>error ({0})</source>
        <translation>Fehler ({0})</translation>
    </message>
    <message>
        <source>Residual before, trial {0} at its worst: arrows {1} times as long, red at {2} mm</source>
        <translation>Rest vorher, Versuch {0}, wo er am größten ist: Pfeile {1}-mal so lang, rot bei {2} mm</translation>
    </message>
    <message>
        <source>Residual after, trial {0} at its worst: arrows {1} times as long, red at {2} mm</source>
        <translation>Rest nachher, Versuch {0}, wo er am größten ist: Pfeile {1}-mal so lang, rot bei {2} mm</translation>
    </message>
    <message>
        <source>voltage (V)</source>
        <translation>Spannung (V)</translation>
    </message>
    <message>
        <source>temperature (°C)</source>
        <translation>Temperatur (°C)</translation>
    </message>
    <message>
        <source>power (W)</source>
        <translation>Leistung (W)</translation>
    </message>
    <message>
        <source>stress (kPa)</source>
        <translation>Spannung (kPa)</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>strain</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>residual: {0}</source>
        <translation>Rest: {0}</translation>
    </message>
    <message>
        <source>The image cuts the liver off towards {0}: only whole ones can be retracted.</source>
        <translation>Das Bild schneidet die Leber ab, Richtung: {0}. Nur ganze lassen sich anheben.</translation>
    </message>
    <message>
        <source>The tissue&apos;s own law found no equilibrium: {0}</source>
        <translation>Das Gesetz des Gewebes selbst fand kein Gleichgewicht: {0}</translation>
    </message>
    <message>
        <source>Measurements must be 3 to 100000, noise 0 to 50 % of the largest stress, and at most 20 of each are tried.</source>
        <translation>Messungen müssen 3 bis 100000 sein, Rauschen 0 bis 50 % der größten Spannung, und von beidem werden höchstens 20 versucht.</translation>
    </message>
    <message>
        <source>Tests must go to 5 % strain or farther, to 100 % at most, forces be up to 100 N, and a liver have 200 cells or more.</source>
        <translation>Versuche müssen über 5 % Dehnung gehen, höchstens bis 100 %, Kräfte höchstens 100 N betragen und eine Leber 200 Zellen oder mehr haben.</translation>
    </message>
    <message>
        <source>The specimen&apos;s state must be &quot;plane-strain&quot;.</source>
        <translation>Der Zustand der Probe muss &quot;plane-strain&quot; sein.</translation>
    </message>
    <message>
        <source>Plane stress is not known here: a thin sheet needs a law for its thickness.</source>
        <translation>Ebener Spannungszustand ist hier nicht bekannt: ein dünnes Blatt braucht ein Gesetz für seine Dicke.</translation>
    </message>
    <message>
        <source>{0} has {1} points; at most {2} are used.</source>
        <translation>{0} hat {1} Punkte; höchstens {2} werden verwendet.</translation>
    </message>
    <message>
        <source>Give the field on a coarser mesh.</source>
        <translation>Geben Sie das Feld auf einem gröberen Netz an.</translation>
    </message>
    <message>
        <source>{0} does not lie in a plane of equal z.</source>
        <translation>{0} liegt nicht in einer Ebene mit gleichem z.</translation>
    </message>
    <message>
        <source>{0} has a triangle without area (at {1}, {2}).</source>
        <translation>{0} hat ein Dreieck ohne Fläche (bei {1}, {2}).</translation>
    </message>
    <message>
        <source>The laws are {1}.</source>
        <translation>Die Gesetze sind {1}.</translation>
    </message>
    <message>
        <source>{0} must lie between -1 and 0.5.</source>
        <translation>{0} muss zwischen -1 und 0.5 liegen.</translation>
    </message>
    <message>
        <source>The law {0} has no number called &quot;{1}&quot;.</source>
        <translation>Das Gesetz {0} hat keine Zahl namens &quot;{1}&quot;.</translation>
    </message>
    <message>
        <source>Its numbers are {2}.</source>
        <translation>Seine Zahlen sind {2}.</translation>
    </message>
    <message>
        <source>The declared law lacks some of its numbers: {0}.</source>
        <translation>Dem angegebenen Gesetz fehlen einige seiner Zahlen: {0}.</translation>
    </message>
    <message>
        <source>Give all of them, or none: then they are found first, and the law&apos;s name alone is declared.</source>
        <translation>Geben Sie alle an oder keine: dann werden sie zuerst bestimmt, und nur der Name des Gesetzes ist angegeben.</translation>
    </message>
    <message>
        <source>{0} has no column &quot;{1}&quot; in its first line.</source>
        <translation>{0} hat in der ersten Zeile keine Spalte &quot;{1}&quot;.</translation>
    </message>
    <message>
        <source>Displacements stand in point,ux,uy, reactions in boundary,fx,fy.</source>
        <translation>Verschiebungen stehen in point,ux,uy, Reaktionskräfte in boundary,fx,fy.</translation>
    </message>
    <message>
        <source>{0} holds no row beneath its first line.</source>
        <translation>{0} enthält unter der ersten Zeile nichts.</translation>
    </message>
    <message>
        <source>Line {0} of {1} names no point of the mesh, which has {2} from 0 on.</source>
        <translation>Zeile {0} von {1} nennt keinen Punkt des Netzes, das {2} hat, von 0 an.</translation>
    </message>
    <message>
        <source>Points are numbered as in the mesh, from 0.</source>
        <translation>Punkte sind wie im Netz nummeriert, von 0 an.</translation>
    </message>
    <message>
        <source>{0} names the point array &quot;{1}&quot;, which the mesh does not have.</source>
        <translation>{0} nennt das Punktfeld &quot;{1}&quot;, das das Netz nicht hat.</translation>
    </message>
    <message>
        <source>{0} names the boundary &quot;{1}&quot;, of which the mesh has no points.</source>
        <translation>{0} nennt den Rand &quot;{1}&quot;, von dem das Netz keine Punkte hat.</translation>
    </message>
    <message>
        <source>Boundaries are sides (left, right, bottom, top), point arrays of the mesh, groups in its arrays &quot;group_x&quot; and &quot;group_y&quot;, or stand under &quot;boundaries&quot; in the experiment.</source>
        <translation>Ränder sind Seiten (left, right, bottom, top), Punktfelder des Netzes, Gruppen in seinen Feldern &quot;group_x&quot; und &quot;group_y&quot;, oder sie stehen unter &quot;boundaries&quot; im Versuch.</translation>
    </message>
    <message>
        <source>Nothing says where the plate is held or moved in {0}.</source>
        <translation>Nichts sagt, wo die Platte in {0} gehalten oder bewegt wird.</translation>
    </message>
    <message>
        <source>Name the boundaries in the tables of reactions, or under &quot;boundaries&quot; in the experiment.</source>
        <translation>Nennen Sie die Ränder in den Tabellen der Reaktionskräfte oder unter &quot;boundaries&quot; im Versuch.</translation>
    </message>
    <message>
        <source>No reaction is given where a displacement is prescribed.</source>
        <translation>Nirgends, wo eine Verschiebung vorgegeben ist, steht eine Reaktionskraft.</translation>
    </message>
    <message>
        <source>Displacements alone do not say how stiff the material is.</source>
        <translation>Verschiebungen allein sagen nicht, wie steif das Material ist.</translation>
    </message>
    <message>
        <source>The noise of displacements is stated as {0}, but neighbouring points differ by {1}, which was taken in its place.</source>
        <translation>Das Rauschen der Verschiebungen ist mit {0} angegeben, aber benachbarte Punkte weichen um {1} ab; das wurde stattdessen genommen.</translation>
    </message>
    <message>
        <source>The noise of displacements is stated as {0}, but neighbouring points differ by {1} alone: was the field smoothed? Smoothing leaves errors that neighbours share.</source>
        <translation>Das Rauschen der Verschiebungen ist mit {0} angegeben, aber benachbarte Punkte weichen nur um {1} ab: wurde das Feld geglättet? Glätten lässt Fehler zurück, die Nachbarn teilen.</translation>
    </message>
    <message>
        <source>The noise of reactions is not stated; as opposite ones balance, {0} was taken.</source>
        <translation>Das Rauschen der Reaktionskräfte ist nicht angegeben; danach, wie gegenüberliegende sich ausgleichen, wurde {0} genommen.</translation>
    </message>
    <message>
        <source>The noise of reactions is not stated; {0} was taken, two thousandths of the largest.</source>
        <translation>Das Rauschen der Reaktionskräfte ist nicht angegeben; {0} wurde genommen, zwei Tausendstel der größten.</translation>
    </message>
    <message>
        <source>No law has an equilibrium near these displacements.</source>
        <translation>Kein Gesetz hat ein Gleichgewicht nahe diesen Verschiebungen.</translation>
    </message>
    <message>
        <source>Are points numbered as in the mesh, and are boundaries where the forces were measured?</source>
        <translation>Sind Punkte wie im Netz nummeriert, und liegen Ränder dort, wo die Kräfte gemessen wurden?</translation>
    </message>
    <message>
        <source>The material resists shear and change of volume by another law than the one that is declared.</source>
        <translation>Das Material widersteht Scherung und Volumenänderung nach einem anderen Gesetz als dem angegebenen.</translation>
    </message>
    <message>
        <source>The material is stiffer along fibres than across them.</source>
        <translation>Das Material ist entlang von Fasern steifer als quer dazu.</translation>
    </message>
    <message>
        <source>The law {0} has no equilibrium in trial {1}.</source>
        <translation>Das Gesetz {0} hat in Versuch {1} kein Gleichgewicht.</translation>
    </message>
    <message>
        <source>Are its numbers in the unit of the reactions over lengths, and large enough?</source>
        <translation>Stehen seine Zahlen in der Einheit der Kräfte durch Längen, und sind sie groß genug?</translation>
    </message>
    <message>
        <source>The reactions are those of a solution on the mesh&apos;s own linear triangles, not of a plate: that error is in what is predicted for them.</source>
        <translation>Die Reaktionskräfte sind die einer Lösung auf den linearen Dreiecken des Netzes selbst, nicht die einer Platte: dieser Fehler steckt in dem, was für sie vorhergesagt wird.</translation>
    </message>
    <message>
        <source>Displacements and reactions are those of a solution on the mesh&apos;s own linear triangles, not of a plate: that error is in what is predicted.</source>
        <translation>Verschiebungen und Reaktionskräfte sind die einer Lösung auf den linearen Dreiecken des Netzes selbst, nicht die einer Platte: dieser Fehler steckt in dem, was vorhergesagt wird.</translation>
    </message>
    <message>
        <source>The declared law stands without numbers: the best ones were taken as declared.</source>
        <translation>Das angegebene Gesetz steht ohne Zahlen: die besten wurden als angegeben genommen.</translation>
    </message>
    <message>
        <source>The declared law {0} stands without numbers.</source>
        <translation>Das angegebene Gesetz {0} steht ohne Zahlen.</translation>
    </message>
    <message>
        <source>Give them under &quot;declared&quot;, or a model.json with --with.</source>
        <translation>Geben Sie sie unter &quot;declared&quot; an oder ein model.json mit --with.</translation>
    </message>
    <message>
        <source>Cell {1} of {0} is a {2} of {3} points; only triangles and quadrangles are used.</source>
        <translation>Zelle {1} von {0} ist ein {2} mit {3} Punkten; nur Dreiecke und Vierecke werden verwendet.</translation>
    </message>
    <message>
        <source>Cut it into triangles first, for example with ParaView&apos;s Triangulate.</source>
        <translation>Zerlegen Sie es zuerst in Dreiecke, etwa mit Triangulate in ParaView.</translation>
    </message>
    <message>
        <source>largest strain</source>
        <translation>größte Dehnung</translation>
    </message>
    <message>
        <source>Residual before, trial {0} at its worst: arrows {1} times as long, red at {2}</source>
        <translation>Residuum vorher, Versuch {0}, wo es am größten ist: Pfeile {1}-mal so lang, rot bei {2}</translation>
    </message>
    <message>
        <source>Residual after, trial {0} at its worst: arrows {1} times as long, red at {2}</source>
        <translation>Residuum nachher, Versuch {0}, wo es am größten ist: Pfeile {1}-mal so lang, rot bei {2}</translation>
    </message>
    <message>
        <source>Set the cut</source>
        <translation>Schnitt setzen</translation>
    </message>
    <message>
        <source>Take the cut away</source>
        <translation>Schnitt wegnehmen</translation>
    </message>
    <message>
        <source>Change the cut</source>
        <translation>Schnitt ändern</translation>
    </message>
    <message>
        <source>{0} failed ({1}): {2}</source>
        <translation>{0} ist fehlgeschlagen ({1}): {2}</translation>
    </message>
    <message>
        <source>Run it by hand to see all that it says.</source>
        <translation>Starten Sie es von Hand, um alles zu sehen, was es meldet.</translation>
    </message>
    <message>
        <source>In the command {0} a quotation mark is not closed.</source>
        <translation>Im Befehl {0} ist ein Anführungszeichen nicht geschlossen.</translation>
    </message>
    <message>
        <source>Close it, or write \ before it.</source>
        <translation>Schließen Sie es, oder schreiben Sie \ davor.</translation>
    </message>
    <message>
        <source>The command is empty.</source>
        <translation>Der Befehl ist leer.</translation>
    </message>
    <message>
        <source>There is no program {0} on this computer.</source>
        <translation>Es gibt kein Programm {0} auf diesem Computer.</translation>
    </message>
    <message>
        <source>Install it, or write where it lies.</source>
        <translation>Installieren Sie es, oder schreiben Sie, wo es liegt.</translation>
    </message>
    <message>
        <source>{0} could not be started: {1}</source>
        <translation>{0} konnte nicht gestartet werden: {1}</translation>
    </message>
    <message>
        <source>Check that it may be run.</source>
        <translation>Prüfen Sie, ob es ausgeführt werden darf.</translation>
    </message>
    <message>
        <source>Handing over the images</source>
        <translation>Bilder werden übergeben</translation>
    </message>
    <message>
        <source>As in: TotalSegmentator -i {image} -o {folder}</source>
        <translation>Wie in: TotalSegmentator -i {image} -o {folder}</translation>
    </message>
    <message>
        <source>The command {0} is given no image.</source>
        <translation>Der Befehl {0} bekommt kein Bild.</translation>
    </message>
    <message>
        <source>The command {0} is not told where to put what it outlines.</source>
        <translation>Dem Befehl {0} ist nicht gesagt, wohin er seine Umrisse legen soll.</translation>
    </message>
    <message>
        <source>The command {0} ended, and left no label map.</source>
        <translation>Der Befehl {0} ist zu Ende und hat keine Labelkarte hinterlassen.</translation>
    </message>
    <message>
        <source>Run it by hand, and see which files it writes, and where.</source>
        <translation>Starten Sie ihn von Hand, und sehen Sie nach, welche Dateien er wohin schreibt.</translation>
    </message>
    <message>
        <source>In Settings, {0} does not say what a value of the outlining program is.</source>
        <translation>In den Einstellungen sagt {0} nicht, was ein Wert des Umriss-Programms ist.</translation>
    </message>
    <message>
        <source>Write value and name, as in 1=liver, 2=tumour-1.</source>
        <translation>Schreiben Sie Wert und Namen, wie in 1=liver, 2=tumour-1.</translation>
    </message>
    <message>
        <source>Noted when {0}&apos;s liver was outlined:</source>
        <translation>Beim Umreißen der Leber von {0} vermerkt:</translation>
    </message>
    <message>
        <source>{0} is compared with itself.</source>
        <translation>{0} wird mit sich selbst verglichen.</translation>
    </message>
    <message>
        <source>Name the case of the earlier study first, then that of the later one.</source>
        <translation>Nennen Sie zuerst den Fall der früheren Untersuchung, dann den der späteren.</translation>
    </message>
    <message>
        <source>One study was parted into segments by its vessels, the other by the liver&apos;s shape alone: a part of what differs comes of that.</source>
        <translation>Die eine Untersuchung wurde nach ihren Gefäßen in Segmente geteilt, die andere nach der Form der Leber allein: Ein Teil des Unterschieds kommt davon.</translation>
    </message>
    <message>
        <source>{0} has no segments yet.</source>
        <translation>{0} hat noch keine Segmente.</translation>
    </message>
    <message>
        <source>Find them first: in Resect, or by glisson-cli territories CASE.</source>
        <translation>Bestimmen Sie sie zuerst: in Resektion oder mit glisson-cli territories CASE.</translation>
    </message>
    <message>
        <source>The segments of {0} are older than the outlines or vessels that they were made from, or of another version of Glisson.</source>
        <translation>Die Segmente von {0} sind älter als die Umrisse oder Gefäße, aus denen sie gemacht wurden, oder von einer anderen Version von Glisson.</translation>
    </message>
    <message>
        <source>Find them anew: in Resect, or by glisson-cli territories CASE.</source>
        <translation>Bestimmen Sie sie neu: in Resektion oder mit glisson-cli territories CASE.</translation>
    </message>
    <message>
        <source>Nothing shows whether {0} and {1} are of one patient: the images of one or both name nobody, or came into their case before cases kept what tells.</source>
        <translation>Nichts zeigt, ob {0} und {1} von einem Patienten sind: Die Bilder eines oder beider nennen niemanden oder kamen in ihren Fall, bevor Fälle das behielten.</translation>
    </message>
    <message>
        <source>The images of {0} and {1} name two patients; you said that they are of one.</source>
        <translation>Die Bilder von {0} und {1} nennen zwei Patienten; Sie sagten, dass sie von einem sind.</translation>
    </message>
    <message>
        <source>The images of {0} and {1} name two patients.</source>
        <translation>Die Bilder von {0} und {1} nennen zwei Patienten.</translation>
    </message>
    <message>
        <source>Where they are of one all the same, say so with --same-patient.</source>
        <translation>Wenn sie trotzdem von einem sind, sagen Sie es mit --same-patient.</translation>
    </message>
    <message>
        <source>By the dates of its images {0} is {1} days older than {2}.</source>
        <translation>Nach den Daten seiner Bilder ist {0} um {1} Tage älter als {2}.</translation>
    </message>
    <message>
        <source>By the dates of their images the studies are {0} days apart, and not {1}.</source>
        <translation>Nach den Daten ihrer Bilder liegen die Untersuchungen {0} Tage auseinander und nicht {1}.</translation>
    </message>
    <message>
        <source>Leave --days out: it is for studies without dates.</source>
        <translation>Lassen Sie --days weg: Es ist für Untersuchungen ohne Daten.</translation>
    </message>
    <message>
        <source>Both studies are of the same day: there is no growth rate.</source>
        <translation>Beide Untersuchungen sind vom selben Tag: Eine Wachstumsrate gibt es nicht.</translation>
    </message>
    <message>
        <source>How many days lie between the studies is not known, so that there is no growth rate: their images have no dates, or name nobody. Say it (--days).</source>
        <translation>Wie viele Tage zwischen den Untersuchungen liegen, ist nicht bekannt, sodass es keine Wachstumsrate gibt: Ihre Bilder haben keine Daten oder nennen niemanden. Sagen Sie es (--days).</translation>
    </message>
    <message>
        <source>Neither {0} nor {1} has a plan {2}.</source>
        <translation>Weder {0} noch {1} hat einen Plan {2}.</translation>
    </message>
    <message>
        <source>{0} alone has the plan {1}, and not all of it goes by segments or territories: a plane, a sheet, a margin or a zone has its place in its own study.</source>
        <translation>Nur {0} hat den Plan {1}, und nicht alles daran geht nach Segmenten oder Gebieten: Eine Ebene, eine Fläche, ein Abstand oder eine Zone hat ihren Ort in ihrer eigenen Untersuchung.</translation>
    </message>
    <message>
        <source>Keep a plan of that name in the other case too.</source>
        <translation>Behalten Sie auch im anderen Fall einen Plan dieses Namens.</translation>
    </message>
    <message>
        <source>Less than {0} mm of the line lie over the liver.</source>
        <translation>Weniger als {0} mm der Linie liegen über der Leber.</translation>
    </message>
    <message>
        <source>Draw it across the liver, from one side to the other.</source>
        <translation>Zeichnen Sie sie quer über die Leber, von einer Seite zur anderen.</translation>
    </message>
    <message>
        <source>The line turns back on itself.</source>
        <translation>Die Linie kehrt um.</translation>
    </message>
    <message>
        <source>Draw it from one side of the liver to the other without turning.</source>
        <translation>Zeichnen Sie sie von einer Seite der Leber zur anderen, ohne umzukehren.</translation>
    </message>
    <message>
        <source>{0} days between the studies: the second must be later than the first.</source>
        <translation>{0} Tage zwischen den Untersuchungen: Die zweite muss später sein als die erste.</translation>
    </message>
    <message>
        <source>A standard liver volume of {0} ml is not more than 0.</source>
        <translation>Ein Standardvolumen der Leber von {0} ml ist nicht größer als 0.</translation>
    </message>
    <message>
        <source>The liver without tumours has {1} ml, {0} ml before ({2} %).</source>
        <translation>Die Leber ohne Tumoren hat {1} ml, vorher {0} ml ({2} %).</translation>
    </message>
    <message>
        <source>What the plan {0} leaves has {2} ml, {1} ml before ({3} %).</source>
        <translation>Was der Plan {0} lässt, hat {2} ml, vorher {1} ml ({3} %).</translation>
    </message>
    <message>
        <source>That is {1} % of the standard liver volume of {3} ml, {0} % before: a degree of hypertrophy of {2} percentage points.</source>
        <translation>Das sind {1} % des Standardvolumens der Leber von {3} ml, vorher {0} %: ein Grad der Hypertrophie von {2} Prozentpunkten.</translation>
    </message>
    <message>
        <source>That is {1} % of the liver without tumours of its own study, {0} % before: a degree of hypertrophy of {2} percentage points.</source>
        <translation>Das sind {1} % der Leber ohne Tumoren der eigenen Untersuchung, vorher {0} %: ein Grad der Hypertrophie von {2} Prozentpunkten.</translation>
    </message>
    <message>
        <source>Kinetic growth rate: {0} percentage points a week, over {1} days by the images&apos; dates.</source>
        <translation>Kinetische Wachstumsrate: {0} Prozentpunkte je Woche, über {1} Tage nach den Daten der Bilder.</translation>
    </message>
    <message>
        <source>Kinetic growth rate: {0} percentage points a week, over the {1} days that were given.</source>
        <translation>Kinetische Wachstumsrate: {0} Prozentpunkte je Woche, über die {1} angegebenen Tage.</translation>
    </message>
    <message>
        <source>A remnant&apos;s change of up to {0} % may be none: volumes of what is parted anew are off by as much in one of ten.</source>
        <translation>Eine Änderung des Rests bis {0} % kann keine sein: Volumina neu bestimmter Teile liegen in einem von zehn Fällen um so viel daneben.</translation>
    </message>
    <message>
        <source>A segment&apos;s change of up to {0} % (~) may be none: volumes of segments that are parted anew are off by as much in one of ten.</source>
        <translation>Eine Änderung eines Segments bis {0} % (~) kann keine sein: Volumina neu bestimmter Segmente liegen in einem von zehn Fällen um so viel daneben.</translation>
    </message>
    <message>
        <source>Choose the plan {0}</source>
        <translation>Plan {0} wählen</translation>
    </message>
    <message>
        <source>An OpenCL device solves motions by finite elements with the material &quot;linear&quot; or &quot;corotational&quot;, without tools, ligaments, capsule or gas.</source>
        <translation>Ein OpenCL-Gerät löst Bewegungen mit finiten Elementen aus dem Material &quot;linear&quot; oder &quot;corotational&quot;, ohne Werkzeuge, Bänder, Kapsel oder Gas.</translation>
    </message>
    <message>
        <source>{0} cannot compile the kernels: {1}</source>
        <translation>{0} kann die Kernel nicht übersetzen: {1}</translation>
    </message>
    <message>
        <source>The matching takes {0} MB on {1}, which has {2} MB.</source>
        <translation>Die Zuordnung braucht {0} MB auf {1}, das {2} MB hat.</translation>
    </message>
    <message>
        <source>An OpenCL device matches by trwls in 16 bits.</source>
        <translation>Ein OpenCL-Gerät ordnet mit trwls in 16 Bit zu.</translation>
    </message>
    <message>
        <source>A probability weighs how well an explanation predicts what was measured, whatever the size of its effects, against how common it is taken to be before anything is measured. &quot;Something else&quot; stands for every cause that is not in the catalogue. Where the answer was known, in generated experiments, 98 of 100 explanations given 90 % and more were right, and 7 of 10 given 60 to 80 %.</source>
        <translation>Eine Wahrscheinlichkeit wägt ab, wie gut eine Erklärung das Gemessene vorhersagt, wie groß ihre Effekte auch sind, und wie häufig sie vor jeder Messung angenommen wird. „Etwas anderes“ steht für jede Ursache, die nicht im Katalog ist. Wo die Antwort bekannt war, in erzeugten Experimenten, waren von 100 Erklärungen mit 90 % und mehr 98 richtig, von 10 mit 60 bis 80 % sieben.</translation>
    </message>
    <message>
        <source>It would tell what is likeliest from {0}.</source>
        <translation>Das würde das Wahrscheinlichste von {0} unterscheiden.</translation>
    </message>
    <message>
        <source>Of the doubt among the known explanations {0} % is expected to be gone then.</source>
        <translation>Vom Zweifel zwischen den bekannten Erklärungen sind dann voraussichtlich {0} % beseitigt.</translation>
    </message>
    <message>
        <source>How the probabilities went while trials were added</source>
        <translation>Wie sich die Wahrscheinlichkeiten änderten, während Versuche dazukamen</translation>
    </message>
    <message>
        <source>number of trials</source>
        <translation>Anzahl der Versuche</translation>
    </message>
    <message>
        <source>probability (%)</source>
        <translation>Wahrscheinlichkeit (%)</translation>
    </message>
    <message>
        <source>{0} has no frame {1}: it has {2}, counted from 0.</source>
        <translation>{0} hat kein Bild {1}: Es sind {2}, von 0 an gezählt.</translation>
    </message>
    <message>
        <source>Cut along the plan</source>
        <translation>Nach Plan schneiden</translation>
    </message>
    <message>
        <source>{0} is not the sequence that was asked for: its SHA-256 is another than {1}.</source>
        <translation>{0} ist nicht die verlangte Sequenz: Ihr SHA-256 ist ein anderer als {1}.</translation>
    </message>
    <message>
        <source>From one measurement to the next the values scatter {0} times as much as the stated noise, which cannot be right: state it anew and ask again.</source>
        <translation>Von einer Messung zur nächsten streuen die Werte {0}-mal so stark wie das angegebene Rauschen, das also nicht stimmen kann: Geben Sie es neu an und fragen Sie noch einmal.</translation>
    </message>
    <message>
        <source>Nothing narrower joins this place to the rest of the structure: cut it off with the scissors, or click farther out.</source>
        <translation>Zwischen dieser Stelle und dem Rest der Struktur ist nichts schmaler: Schneiden Sie sie mit der Schere ab, oder klicken Sie weiter außen.</translation>
    </message>
    <message>
        <source>Take a part off {0}</source>
        <translation>Teil von {0} abgenommen</translation>
    </message>
    <message>
        <source>The battery stopped discharging while it was measured.</source>
        <translation>Der Akku wurde während der Messung nicht mehr entladen.</translation>
    </message>
    <message>
        <source>Keep the machine unplugged until the measurement ends.</source>
        <translation>Lassen Sie das Gerät bis zum Ende der Messung vom Netz getrennt.</translation>
    </message>
    <message>
        <source>The counter of {0} did not move in {1} s.</source>
        <translation>Der Zähler von {0} hat sich in {1} s nicht bewegt.</translation>
    </message>
    <message>
        <source>Measure for longer.</source>
        <translation>Messen Sie länger.</translation>
    </message>
    <message>
        <source>{0} gave one reading in {1} s: how sure it is cannot be told. Each metered problem runs {2} s.</source>
        <translation>{0} gab in {1} s einen einzigen Wert: Wie sicher er ist, lässt sich nicht sagen. Jedes gemessene Problem läuft {2} s.</translation>
    </message>
    <message>
        <source>{0} is renewed every {1} s: each metered problem runs {2} s. What follows &quot;give or take&quot; is what that resolves; how true the readings are was not checked.</source>
        <translation>{0} wird alle {1} s erneuert: Jedes gemessene Problem läuft {2} s. Was auf „give or take“ folgt, ist die Auflösung daraus; wie richtig die Werte sind, wurde nicht geprüft.</translation>
    </message>
    <message>
        <source>The processor&apos;s energy counters (RAPL) at {0} may be read by root only, as they betray secrets (CVE-2020-8694): run this once as root, or let yourself read energy_uj.</source>
        <translation>Die Energiezähler des Prozessors (RAPL) bei {0} darf nur root lesen, da sie Geheimnisse verraten (CVE-2020-8694): Führen Sie dies einmal als root aus, oder geben Sie sich Leserecht auf energy_uj.</translation>
    </message>
    <message>
        <source>The processor&apos;s energy counters (RAPL) at {0} hold no number or no range.</source>
        <translation>Die Energiezähler des Prozessors (RAPL) bei {0} enthalten keine Zahl oder keinen Bereich.</translation>
    </message>
    <message>
        <source>The battery gauge at {0} tells neither power nor what is left.</source>
        <translation>Die Akkuanzeige bei {0} nennt weder Leistung noch Restladung.</translation>
    </message>
    <message>
        <source>A trace needs a channel, factors other than 0, and a range that is positive.</source>
        <translation>Eine Aufzeichnung braucht einen Kanal, Faktoren ungleich 0 und einen positiven Messbereich.</translation>
    </message>
    <message>
        <source>{0} begins as a power analyser&apos;s log, but its first line holds no time and no reading.</source>
        <translation>{0} beginnt wie das Protokoll eines Leistungsmessers, doch die erste Zeile enthält weder Zeit noch Messwert.</translation>
    </message>
    <message>
        <source>There is no meter {0} here.{1}</source>
        <translation>Hier gibt es kein Messgerät {0}.{1}</translation>
    </message>
    <message>
        <source>{0} lies in no case, so that there is no scan to draw over.</source>
        <translation>{0} liegt in keinem Fall, sodass es keine Aufnahme gibt, über die gezeichnet werden könnte.</translation>
    </message>
    <message>
        <source>Give a result in the folder results of a case.</source>
        <translation>Geben Sie ein Ergebnis im Ordner results eines Falls an.</translation>
    </message>
    <message>
        <source>The result has no landmarks &quot;{0}&quot;; it has: {1}.</source>
        <translation>Das Ergebnis hat keine Landmarken „{0}“; es hat: {1}.</translation>
    </message>
    <message>
        <source>A result has no scene named {0}; it has displacement, landmarks.</source>
        <translation>Ein Ergebnis hat keine Szene namens {0}; es hat displacement, landmarks.</translation>
    </message>
    <message>
        <source>{0} must be &quot;glisson-orders/1&quot;.</source>
        <translation>{0} muss „glisson-orders/1“ sein.</translation>
    </message>
    <message>
        <source>There are no steps to keep as {0}.</source>
        <translation>Es gibt keine Schritte, die als {0} zu behalten wären.</translation>
    </message>
    <message>
        <source>Move a rigid tool or advance a cut first.</source>
        <translation>Bewegen Sie zuerst ein starres Instrument oder führen Sie einen Schnitt weiter.</translation>
    </message>
    <message>
        <source>The case has no order of steps {0}.</source>
        <translation>Der Fall hat keine Schrittfolge {0}.</translation>
    </message>
    <message>
        <source>There is no order of steps to compare.</source>
        <translation>Es gibt keine Schrittfolge zu vergleichen.</translation>
    </message>
    <message>
        <source>Keep the steps of a rehearsal first.</source>
        <translation>Behalten Sie zuerst die Schritte einer Probe.</translation>
    </message>
    <message>
        <source>{0} (step {1})</source>
        <translation>{0} (Schritt {1})</translation>
    </message>
    <message>
        <source>What each order asks of the liver at its worst</source>
        <translation>Was jede Schrittfolge der Leber im schlimmsten Augenblick abverlangt</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>{0}, largest displacement (mm)</source>
        <translation>{0}, größte Verschiebung (mm)</translation>
    </message>
    <message>
        <source>{0}, at the end (mm)</source>
        <translation>{0}, am Ende (mm)</translation>
    </message>
    <message>
        <source>largest force of one tool (N)</source>
        <translation>größte Kraft eines Instruments (N)</translation>
    </message>
    <message>
        <source>largest strain (%)</source>
        <translation>größte Dehnung (%)</translation>
    </message>
    <message>
        <source>strain of vessel walls, 95 of 100 below (%)</source>
        <translation>Dehnung der Gefäßwände, 95 von 100 darunter (%)</translation>
    </message>
    <message>
        <source>cut open at the end (cm2)</source>
        <translation>Schnitt am Ende offen (cm2)</translation>
    </message>
    <message>
        <source>steps that could not be carried out</source>
        <translation>nicht ausführbare Schritte</translation>
    </message>
    <message>
        <source>steps not to be used</source>
        <translation>nicht zu gebrauchende Schritte</translation>
    </message>
    <message>
        <source>Orders of steps</source>
        <translation>Schrittfolgen</translation>
    </message>
    <message>
        <source>Computed with large deformations, at rest after each step.</source>
        <translation>Mit großen Verformungen berechnet, nach jedem Schritt in Ruhe.</translation>
    </message>
    <message>
        <source>Orders of steps compared</source>
        <translation>Schrittfolgen verglichen</translation>
    </message>
    <message>
        <source>Order of steps: {0}</source>
        <translation>Schrittfolge: {0}</translation>
    </message>
    <message>
        <source>rehearsed</source>
        <translation>geprobt</translation>
    </message>
    <message>
        <source>Keep the steps {0}</source>
        <translation>Die Schritte {0} behalten</translation>
    </message>
    <message>
        <source>Drop the steps {0}</source>
        <translation>Die Schritte {0} verwerfen</translation>
    </message>
    <message>
        <source>Compare orders of steps</source>
        <translation>Schrittfolgen vergleichen</translation>
    </message>
    <message>
        <source>The calibration is of pictures of {0} x {1} pixels; these have {2} x {3}.</source>
        <translation>Die Kalibrierung gilt für Bilder von {0} x {1} Pixeln; diese haben {2} x {3}.</translation>
    </message>
    <message>
        <source>A picture of {0} x {1} pixels cannot be halved into two of one size.</source>
        <translation>Ein Bild von {0} x {1} Pixeln lässt sich nicht in zwei gleich große teilen.</translation>
    </message>
    <message>
        <source>Give a video whose pictures show both eyes, or one video for each eye.</source>
        <translation>Geben Sie ein Video an, dessen Bilder beide Augen zeigen, oder eines für jedes Auge.</translation>
    </message>
    <message>
        <source>The two videos differ in length: frames of the left one {0}, of the right one {1}.</source>
        <translation>Die beiden Videos sind verschieden lang: Bilder des linken {0}, des rechten {1}.</translation>
    </message>
    <message>
        <source>Give two videos of the same moments, or take fewer frames than both have.</source>
        <translation>Geben Sie zwei Videos derselben Zeit an, oder nehmen Sie weniger Bilder, als beide haben.</translation>
    </message>
    <message>
        <source>SIMULATED: a generated liver, breathing and pressed by a tool as a formula says.</source>
        <translation>SIMULIERT: eine erzeugte Leber, die nach einer Formel atmet und von einem Instrument eingedrückt wird.</translation>
    </message>
    <message>
        <source>The kinds are palpation, material, platform, guidance, full-field and elastography.</source>
        <translation>Die Arten sind palpation, material, platform, guidance, full-field und elastography.</translation>
    </message>
    <message>
        <source>The trials hold more than {0} values together.</source>
        <translation>Die Versuche enthalten zusammen mehr als {0} Werte.</translation>
    </message>
    <message>
        <source>Cut the images to the region, or leave trials out.</source>
        <translation>Beschneiden Sie die Bilder auf die Region, oder lassen Sie Versuche weg.</translation>
    </message>
    <message>
        <source>The declared density is {0} kg/m3, which no tissue has.</source>
        <translation>Die angegebene Dichte ist {0} kg/m3; so dicht ist kein Gewebe.</translation>
    </message>
    <message>
        <source>Was it given in g/cm3?</source>
        <translation>Wurde sie in g/cm3 angegeben?</translation>
    </message>
    <message>
        <source>{0} names none of x, y and z.</source>
        <translation>{0} nennt weder x noch y noch z.</translation>
    </message>
    <message>
        <source>{0} must have x, y and z: without one of them a free pressure cannot be taken off.</source>
        <translation>{0} braucht x, y und z: fehlt eines, lässt sich ein freier Druck nicht abziehen.</translation>
    </message>
    <message>
        <source>{0} must be those of the first trial.</source>
        <translation>{0} müssen die des ersten Versuchs sein.</translation>
    </message>
    <message>
        <source>{0} has more than {1} voxels.</source>
        <translation>{0} hat mehr als {1} Voxel.</translation>
    </message>
    <message>
        <source>Cut it to the region.</source>
        <translation>Beschneiden Sie es auf die Region.</translation>
    </message>
    <message>
        <source>The axes of {0} are not at right angles.</source>
        <translation>Die Achsen von {0} stehen nicht im rechten Winkel zueinander.</translation>
    </message>
    <message>
        <source>{0} lies on another grid than the first image.</source>
        <translation>{0} liegt auf einem anderen Gitter als das erste Bild.</translation>
    </message>
    <message>
        <source>All images of an experiment have the same voxels.</source>
        <translation>Alle Bilder eines Experiments haben dieselben Voxel.</translation>
    </message>
    <message>
        <source>The region holds no voxel in which all images have numbers.</source>
        <translation>Die Region enthält kein Voxel, in dem alle Bilder Zahlen haben.</translation>
    </message>
    <message>
        <source>Was the mask drawn on these images?</source>
        <translation>Wurde die Maske auf diesen Bildern gezeichnet?</translation>
    </message>
    <message>
        <source>Shear waves run slower or faster than declared, everywhere and at every frequency.</source>
        <translation>Scherwellen laufen langsamer oder schneller als angegeben, überall und bei jeder Frequenz.</translation>
    </message>
    <message>
        <source>Waves lose energy on their way, as in a viscous tissue.</source>
        <translation>Wellen verlieren unterwegs Energie wie in zähem Gewebe.</translation>
    </message>
    <message>
        <source>Shear waves along one direction, as of fibres, run at another speed than across it.</source>
        <translation>Scherwellen laufen längs einer Richtung, wie der von Fasern, anders schnell als quer dazu.</translation>
    </message>
    <message>
        <source>Besides shear waves there are long ones that compress; the declared equation knows none.</source>
        <translation>Neben Scherwellen gibt es lange, die komprimieren; die angegebene Gleichung kennt keine.</translation>
    </message>
    <message>
        <source>Slices were not measured at one moment of the vibration, but one after the other.</source>
        <translation>Die Schichten wurden nicht in einem Augenblick der Schwingung gemessen, sondern nacheinander.</translation>
    </message>
    <message>
        <source>A region inside is stiffer or softer than declared.</source>
        <translation>Ein Bereich im Inneren ist steifer oder weicher als angegeben.</translation>
    </message>
    <message>
        <source>Along the border another stiffness holds than inside.</source>
        <translation>Entlang des Randes gilt eine andere Steifigkeit als innen.</translation>
    </message>
    <message>
        <source>The images hold {0} x {1} x {2} voxels, too few for a patch.</source>
        <translation>Die Bilder enthalten {0} x {1} x {2} Voxel, zu wenige für ein Teilstück.</translation>
    </message>
    <message>
        <source>Seven along each axis are needed, or a single slice.</source>
        <translation>Nötig sind sieben entlang jeder Achse, oder eine einzelne Schicht.</translation>
    </message>
    <message>
        <source>No patch of trial {0} lies within the region: it would take {1} mm to each side.</source>
        <translation>Kein Teilstück des Versuchs {0} liegt in der Region: es bräuchte {1} mm nach jeder Seite.</translation>
    </message>
    <message>
        <source>Is the region thin, or the declared modulus in Pa? &quot;patch_radius_mm&quot; sets it.</source>
        <translation>Ist die Region dünn, oder der angegebene Modul in Pa? &quot;patch_radius_mm&quot; legt es fest.</translation>
    </message>
    <message>
        <source>Of trial {0} {1} patches were taken, evenly from all.</source>
        <translation>Von Versuch {0} wurden {1} Teilstücke genommen, gleichmäßig aus allen.</translation>
    </message>
    <message>
        <source>frequency (Hz)</source>
        <translation>Frequenz (Hz)</translation>
    </message>
    <message>
        <source>The same with the better model</source>
        <translation>Dasselbe mit dem besseren Modell</translation>
    </message>
    <message>
        <source>What was seen does not lie where the frame before left the organ, and no other place was found: the organ is lost here.</source>
        <translation>Was gesehen wurde, liegt nicht, wo das Bild davor das Organ gelassen hat, und kein anderer Ort wurde gefunden: Hier ist das Organ verloren.</translation>
    </message>
    <message>
        <source>{0} holds no marked lines.</source>
        <translation>{0} enthält keine markierten Linien.</translation>
    </message>
    <message>
        <source>It begins with &quot;format&quot;: &quot;glisson-marked-lines/1&quot;; a line has an id, places at rest and places seen, three numbers each.</source>
        <translation>Sie beginnt mit &quot;format&quot;: &quot;glisson-marked-lines/1&quot;; eine Linie hat eine id, Stellen in Ruhe und gesehene Stellen, je drei Zahlen.</translation>
    </message>
    <message>
        <source>Mark a line</source>
        <translation>Linie markieren</translation>
    </message>
    <message>
        <source>The format &quot;glisson-contours/1&quot; is described in the documentation.</source>
        <translation>Das Format „glisson-contours/1“ ist in der Dokumentation beschrieben.</translation>
    </message>
    <message>
        <source>One picture tells a pose by two lines of the organ and more; {0} are given.</source>
        <translation>Ein Bild sagt die Lage ab zwei Linien des Organs; gegeben sind {0}.</translation>
    </message>
    <message>
        <source>Mark ridges and the falciform ligament, or give a pose_guess.</source>
        <translation>Markieren Sie Kanten und das Ligamentum falciforme, oder geben Sie pose_guess an.</translation>
    </message>
    <message>
        <source>Under no pose do the lines of the organ lie on those of the picture.</source>
        <translation>In keiner Lage liegen die Linien des Organs auf denen des Bildes.</translation>
    </message>
    <message>
        <source>Check that lines have the same names on both sides, that lengths are in mm, and that the picture is of this camera and patient.</source>
        <translation>Prüfen Sie, ob die Linien auf beiden Seiten gleich heißen, Längen in mm sind und das Bild von dieser Kamera und diesem Patienten ist.</translation>
    </message>
    <message>
        <source>The lines of the picture fit the organ in more than one place.</source>
        <translation>Die Linien des Bildes passen an mehr als einer Stelle zum Organ.</translation>
    </message>
    <message>
        <source>Mark another line, or give a pose_guess.</source>
        <translation>Markieren Sie eine weitere Linie, oder geben Sie pose_guess an.</translation>
    </message>
    <message>
        <source>predicts nothing</source>
        <translation>sagt nichts voraus</translation>
    </message>
    <message>
        <source>Fitted without one of the trials, {0} has no solution there, or is farther off than a prediction of zero: it predicts nothing beyond what it was fitted to.</source>
        <translation>Ohne einen der Versuche angepasst, hat {0} dort keine Lösung oder liegt weiter daneben als eine Vorhersage von null: Über das hinaus, woran es angepasst wurde, sagt es nichts voraus.</translation>
    </message>
    <message>
        <source>one of the quantities that were measured is off by more than its noise</source>
        <translation>eine der gemessenen Größen liegt weiter daneben als ihr Rauschen</translation>
    </message>
    <message>
        <source>Somewhere inside lies a stiff lump, as a tumour would: around it the organ gives way less.</source>
        <translation>Irgendwo im Inneren liegt ein harter Knoten, wie ein Tumor: um ihn herum gibt das Organ weniger nach.</translation>
    </message>
    <message>
        <source>What held the specimen has no place on the organ&apos;s surface: the specimen is not this organ in this place.</source>
        <translation>Was den Prüfkörper hielt, hat auf der Oberfläche des Organs keinen Ort: Der Prüfkörper ist nicht dieses Organ an diesem Ort.</translation>
    </message>
    <message>
        <source>Around ({0}, {1}, {2}) the surface is held within {3} mm by springs of {4} kPa/mm.</source>
        <translation>Um ({0}, {1}, {2}) wird die Oberfläche in {3} mm Umkreis von Federn mit {4} kPa/mm gehalten.</translation>
    </message>
    <message>
        <source>What is declared to hold the organ at {0} holds it with {1} kPa/mm alone.</source>
        <translation>Was das Organ laut Angabe an {0} hält, hält es nur mit {1} kPa/mm.</translation>
    </message>
    <message>
        <source>The organ has no support {0} that could hold less.</source>
        <translation>Das Organ hat keine Lagerung {0}, die weniger halten könnte.</translation>
    </message>
    <message>
        <source>Something that nobody declared holds a part of the surface, as an adhesion or a ligament does: there it moves less.</source>
        <translation>Etwas, das niemand angegeben hat, hält einen Teil der Oberfläche, wie eine Verwachsung oder ein Band: dort bewegt sie sich weniger.</translation>
    </message>
    <message>
        <source>One of the declared attachments holds less than declared, or is not there at all.</source>
        <translation>Eine der angegebenen Anheftungen hält weniger als angegeben oder ist gar nicht da.</translation>
    </message>
    <message>
        <source>Error by frequency: broken before, whole after</source>
        <translation>Fehler nach Frequenz: vorher gestrichelt, nachher durchgezogen</translation>
    </message>
    <message>
        <source>Where the declared law does not hold: what it leaves in each patch, in noises (1 is noise alone; red at {0}); the worst layer</source>
        <translation>Wo das angegebene Gesetz nicht gilt: was es in jedem Flecken übrig lässt, in Rauschen (1 ist Rauschen allein; rot bei {0}); die schlechteste Schicht</translation>
    </message>
    <message>
        <source>A lens&apos;s distortion has 4, 5, 8, 12 or 14 coefficients; here there are {0}.</source>
        <translation>Die Verzeichnung eines Objektivs hat 4, 5, 8, 12 oder 14 Koeffizienten; hier sind es {0}.</translation>
    </message>
    <message>
        <source>A tool would lie {0} mm deep in the body.</source>
        <translation>Ein Werkzeug läge {0} mm tief im Körper.</translation>
    </message>
    <message>
        <source>Move it there in smaller steps, or away from the body.</source>
        <translation>In kleineren Schritten dorthin bewegen, oder weg vom Körper.</translation>
    </message>
    <message>
        <source>Press where trial {0} presses, with {1} N along ({2}, {3}, {4}).</source>
        <translation>Drücken, wo Versuch {0} drückt, mit {1} N längs ({2}, {3}, {4}).</translation>
    </message>
    <message>
        <source>Press at ({0}, {1}, {2}) mm with {3} N and hold the force for {4} s.</source>
        <translation>Bei ({0}, {1}, {2}) mm mit {3} N drücken und die Kraft {4} s lang halten.</translation>
    </message>
    <message>
        <source>No vessel lies within {0} mm of {1}, where one was told: put the place on the vessel.</source>
        <translation>Im Umkreis von {0} mm um {1} liegt kein Gefäß, wo eines angegeben wurde: Setzen Sie die Stelle auf das Gefäß.</translation>
    </message>
    <message>
        <source>--click wants VESSEL=X,Y,Z with one of {0}, not &quot;{1}&quot;.</source>
        <translation>--click verlangt GEFÄSS=X,Y,Z mit einem von {0}, nicht „{1}“.</translation>
    </message>
    <message>
        <source>The residual is larger than the stated noise, but has no shape that speaks of an effect: the noise may be stated too small, or some rows are outliers.</source>
        <translation>Das Residuum ist größer als das angegebene Rauschen, hat aber keine Form, die für einen Effekt spricht: Das Rauschen ist vielleicht zu klein angegeben, oder einige Werte sind Ausreißer.</translation>
    </message>
    <message>
        <source>Nothing is probable enough to be named. Probability of {0}: {1}; next comes: {2}, {3}.</source>
        <translation>Nichts ist wahrscheinlich genug, um genannt zu werden. Wahrscheinlichkeit von {0}: {1}; danach kommt: {2}, {3}.</translation>
    </message>
    <message>
        <source>Nothing is missing: what the declared model leaves shows no effect, and nothing was added to it.</source>
        <translation>Es fehlt nichts: Was das angegebene Modell übrig lässt, zeigt keinen Effekt, und nichts wurde hinzugefügt.</translation>
    </message>
    <message>
        <source>Explained: the effects below are probable enough to be named.</source>
        <translation>Erklärt: Die Effekte unten sind wahrscheinlich genug, um genannt zu werden.</translation>
    </message>
    <message>
        <source>Unexplained: something acts that the declared model lacks, and no combination of known effects is probable enough to be named. What is named below removes a part of the error and is not a cause that these data establish.</source>
        <translation>Unerklärt: Es wirkt etwas, das dem angegebenen Modell fehlt, und keine Verbindung bekannter Effekte ist wahrscheinlich genug, um genannt zu werden. Was unten steht, nimmt einen Teil des Fehlers weg und ist keine Ursache, die diese Daten belegen.</translation>
    </message>
    <message>
        <source>Probability of {0}, or of what these data cannot tell from it: {1}.</source>
        <translation>Wahrscheinlichkeit von {0} oder von dem, was diese Daten nicht davon unterscheiden: {1}.</translation>
    </message>
    <message>
        <source>Unite them in one structure, vessels: its systems are told apart.</source>
        <translation>Vereinigen Sie sie in einer Struktur, vessels: Deren Systeme werden unterschieden.</translation>
    </message>
    <message>
        <source>{0} places on borders are told: tell {1} at most.</source>
        <translation>{0} Stellen auf Grenzen sind genannt: Nennen Sie höchstens {1}.</translation>
    </message>
    <message>
        <source>{0} does not lie in the liver, where the border of {1} was told: put the place inside.</source>
        <translation>{0} liegt nicht in der Leber, wo die Grenze von {1} genannt ist: Setzen Sie die Stelle hinein.</translation>
    </message>
    <message>
        <source>{0} lies {1} mm from the usual course of the border of {2}: tell the border that is meant, or put the place on it.</source>
        <translation>{0} liegt {1} mm vom üblichen Verlauf der Grenze von {2}: Nennen Sie die Grenze, die gemeint ist, oder setzen Sie die Stelle auf sie.</translation>
    </message>
    <message>
        <source>The border of {0} cannot pass {1} as well as the other borders where they were told: take one of the places back.</source>
        <translation>Die Grenze von {0} kann nicht durch {1} gehen und die anderen Grenzen durch ihre Stellen: Nehmen Sie eine der Stellen zurück.</translation>
    </message>
    <message>
        <source>--border wants BORDER=X,Y,Z with one of {0}, not &quot;{1}&quot;.</source>
        <translation>--border verlangt BORDER=X,Y,Z mit einem von {0}, nicht „{1}“.</translation>
    </message>
    <message>
        <source>The tool {0} slides past the body, which gives way under {1} N.</source>
        <translation>Das Werkzeug {0} gleitet am Körper vorbei, der unter {1} N nachgibt.</translation>
    </message>
    <message>
        <source>Push with less, or where the body holds against it.</source>
        <translation>Drücken Sie schwächer oder dort, wo der Körper standhält.</translation>
    </message>
    <message>
        <source>The vessel trees were made before there was {0}: find the vessels again.</source>
        <translation>Die Gefäßbäume wurden bestimmt, bevor es {0} gab: Bestimmen Sie die Gefäße neu.</translation>
    </message>
    <message>
        <source>What {1} was made from has changed since, and {0} was made from that: make {1} anew, then {0}.</source>
        <translation>Woraus {1} gemacht ist, hat sich seither geändert, und {0} ist daraus gemacht: Machen Sie {1} neu, dann {0}.</translation>
    </message>
    <message>
        <source>{1} and {2} hold the same vessels: {0} % of the smaller one.</source>
        <translation>{1} und {2} enthalten dieselben Gefäße: {0} % des kleineren.</translation>
    </message>
    <message>
        <source>Take the one out of the other: glisson-cli segment --subtract.</source>
        <translation>Nehmen Sie das eine aus dem anderen heraus: glisson-cli segment --subtract.</translation>
    </message>
    <message>
        <source>{0} holds a piece as wide as it is long, which is no vessel.</source>
        <translation>{0} enthält ein Stück, das so breit wie lang ist und kein Gefäß.</translation>
    </message>
    <message>
        <source>Outline vessels and ducts alone, the gall bladder by itself.</source>
        <translation>Umreißen Sie Gefäße und Gänge allein, die Gallenblase für sich.</translation>
    </message>
    <message>
        <source>{0} has no tissue of its own: arteries and bile ducts run with portal branches.</source>
        <translation>{0} hat kein eigenes Gewebe: Arterien und Gallengänge laufen mit Ästen der Pfortader.</translation>
    </message>
    <message>
        <source>Take the portal branch beside it.</source>
        <translation>Nehmen Sie den Pfortaderast daneben.</translation>
    </message>
    <message>
        <source>{0}: branches that are cut, with the tissue beyond the cut; of arteries and bile ducts their own length.</source>
        <translation>{0}: durchtrennte Äste, mit dem Gewebe jenseits des Schnitts; von Arterien und Gallengängen ihre eigene Länge.</translation>
    </message>
    <message>
        <source>Beyond it</source>
        <translation>Dahinter</translation>
    </message>
    <message>
        <source>Of that left</source>
        <translation>Davon bleibt</translation>
    </message>
    <message>
        <source>Finding vessels</source>
        <translation>Gefäße werden gesucht</translation>
    </message>
    <message>
        <source>The outline to find vessels in holds nothing.</source>
        <translation>Der Umriss, in dem Gefäße gesucht werden, enthält nichts.</translation>
    </message>
    <message>
        <source>Nothing in the outline stands out as a tube.</source>
        <translation>Nichts im Umriss hebt sich als Röhre ab.</translation>
    </message>
    <message>
        <source>Vessels need contrast: take another phase or sequence, grow them from seeds, or import their outline.</source>
        <translation>Gefäße brauchen Kontrast: Nehmen Sie eine andere Phase oder Sequenz, lassen Sie sie aus Punkten wachsen oder importieren Sie ihren Umriss.</translation>
    </message>
    <message>
        <source>Vessels are brighter than the tissue around by {0}: {1} ml, {2} % of the outline.</source>
        <translation>Gefäße sind um {0} heller als das Gewebe ringsum: {1} ml, {2} % des Umrisses.</translation>
    </message>
    <message>
        <source>Vessels are darker than the tissue around by {0}: {1} ml, {2} % of the outline.</source>
        <translation>Gefäße sind um {0} dunkler als das Gewebe ringsum: {1} ml, {2} % des Umrisses.</translation>
    </message>
    <message>
        <source>The seed at ({0}) mm lies more than {1} mm from every vessel found.</source>
        <translation>Der Punkt bei ({0}) mm liegt mehr als {1} mm von jedem gefundenen Gefäß entfernt.</translation>
    </message>
    <message>
        <source>Move the seed onto a vessel, or leave seeds out: then all vessels are kept.</source>
        <translation>Setzen Sie den Punkt auf ein Gefäß, oder lassen Sie Punkte weg: Dann bleiben alle Gefäße.</translation>
    </message>
    <message>
        <source>With tools in the hand the meshfree engine knows a linear, isotropic liver without ligaments.</source>
        <translation>Mit Instrumenten in der Hand kennt das netzfreie Verfahren eine lineare, isotrope Leber ohne Bänder.</translation>
    </message>
    <message>
        <source>Take finite elements for others.</source>
        <translation>Nehmen Sie für andere finite Elemente.</translation>
    </message>
    <message>
        <source>{0} meshfree nodes are too many to be taken in hand: their matrix is not factorised within seconds.</source>
        <translation>{0} netzfreie Knoten sind zu viele, um sie in die Hand zu nehmen: Ihre Matrix wird nicht in Sekunden zerlegt.</translation>
    </message>
    <message>
        <source>Take fewer nodes, or let `simulate` solve for them.</source>
        <translation>Nehmen Sie weniger Knoten, oder lassen Sie `simulate` für sie lösen.</translation>
    </message>
    <message>
        <source>The liver was found without a point: look at it before you trust it, and give a point inside it where it is wrong.</source>
        <translation>Die Leber wurde ohne Punkt gefunden: Sehen Sie sie an, bevor Sie ihr trauen, und geben Sie, wo sie falsch ist, einen Punkt in ihr an.</translation>
    </message>
    <message>
        <source>The image shows {0} % of the liver&apos;s border; elsewhere the shape leads.</source>
        <translation>Das Bild zeigt {0} % des Randes der Leber; sonst führt die Form.</translation>
    </message>
    <message>
        <source>There is no image value where the liver is looked for.</source>
        <translation>Wo die Leber gesucht wird, hat das Bild keinen Wert.</translation>
    </message>
    <message>
        <source>Fitting the shape to the image</source>
        <translation>Die Form wird an das Bild angepasst</translation>
    </message>
    <message>
        <source>The image hardly shows a border where the model expects the liver&apos;s.</source>
        <translation>Wo das Modell den Rand der Leber erwartet, zeigt das Bild kaum einen.</translation>
    </message>
    <message>
        <source>Give a seed inside the liver; look whether the image shows one, and lies in the patient&apos;s frame (LPS).</source>
        <translation>Geben Sie einen Punkt in der Leber an; prüfen Sie, ob das Bild eine zeigt und im Koordinatensystem des Patienten (LPS) liegt.</translation>
    </message>
    <message>
        <source>Looking for the liver</source>
        <translation>Die Leber wird gesucht</translation>
    </message>
    <message>
        <source>No place in the image looks like a liver of the model&apos;s shape.</source>
        <translation>Keine Stelle des Bildes sieht aus wie eine Leber von der Form des Modells.</translation>
    </message>
    <message>
        <source>The liver is what grew by brightness alone: no shape made its border surer.</source>
        <translation>Die Leber ist, was nach der Helligkeit allein gewachsen ist: Keine Form machte ihren Rand sicherer.</translation>
    </message>
    <message>
        <source>Point {0} on what is not liver, at ({1}) mm, lies {2} mm outside the image.</source>
        <translation>Punkt {0} auf etwas, das nicht Leber ist, bei ({1}) mm, liegt {2} mm außerhalb des Bildes.</translation>
    </message>
    <message>
        <source>Points are DICOM patient coordinates (LPS) in mm, not voxel indices.</source>
        <translation>Punkte sind DICOM-Patientenkoordinaten (LPS) in mm, keine Voxelindizes.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>The scenario says itself how soon the organ stiffens: the effect {0} is left out.</source>
        <translation>Das Szenario sagt selbst, wie bald sich das Organ versteift: Der Effekt {0} bleibt weg.</translation>
    </message>
    <message>
        <source>Only the material veronda-westmann stiffens with strain: the effect {0} is left out.</source>
        <translation>Nur das Material veronda-westmann versteift sich mit der Dehnung: Der Effekt {0} bleibt weg.</translation>
    </message>
    <message>
        <source>That the specimen stiffens with strain is not carried to the organ.</source>
        <translation>Dass die Probe sich mit der Dehnung versteift, wird nicht auf das Organ übertragen.</translation>
    </message>
    <message>
        <source>With large deformations the organ stiffens as it is strained (Veronda and Westmann&apos;s law, strain_stiffening {0}); with small ones it does not.</source>
        <translation>Bei großen Verformungen versteift sich das Organ mit der Dehnung (Gesetz von Veronda und Westmann, strain_stiffening {0}), bei kleinen nicht.</translation>
    </message>
    <message>
        <source>Only bent by {0} mm (rms) does the organ lie where it was seen: it is another organ, the cloud is mirrored, or the guess is far off.</source>
        <translation>Nur um {0} mm (quadratisches Mittel) verbogen liegt das Organ dort, wo es gesehen wurde: Es ist ein anderes Organ, die Punktwolke ist gespiegelt, oder die Schätzung liegt weit daneben.</translation>
    </message>
    <message>
        <source>The feature {0} lies {1} mm from the organ at rest: it is of another organ, or in another frame than the mesh.</source>
        <translation>Das Merkmal {0} liegt {1} mm vom Organ in Ruhe entfernt: Es gehört zu einem anderen Organ, oder zu einem anderen Koordinatensystem als das Netz.</translation>
    </message>
    <message>
        <source>The feature {0} lies {1} mm from where all else that is seen has it: the features contradict each other or the cloud. Is each named rightly?</source>
        <translation>Das Merkmal {0} liegt {1} mm von dort, wo alles andere Gesehene es erwarten lässt: Die Merkmale widersprechen einander oder der Punktwolke. Ist jedes richtig benannt?</translation>
    </message>
    <message>
        <source>Go on along the earlier cut, or keep farther away from it.</source>
        <translation>Setzen Sie den früheren Schnitt fort, oder halten Sie mehr Abstand von ihm.</translation>
    </message>
    <message>
        <source>No equilibrium of the pressed gel was found at {0} mm.</source>
        <translation>Bei {0} mm wurde kein Gleichgewicht des gedrückten Gels gefunden.</translation>
    </message>
    <message>
        <source>The gel does not bear {0} N at {1} mm of depth.</source>
        <translation>Das Gel trägt {0} N bei {1} mm Tiefe nicht.</translation>
    </message>
    <message>
        <source>There is no trial {0}; the first one is {1}.</source>
        <translation>Einen Versuch {0} gibt es nicht; der erste ist {1}.</translation>
    </message>
    <message>
        <source>A scene for SOFA cannot hold what the scenario says with {0}.</source>
        <translation>Eine Szene für SOFA kann nicht aufnehmen, was das Szenario mit {0} sagt.</translation>
    </message>
    <message>
        <source>It holds linear and corotational bodies by finite elements, fixed points, foundations and loads.</source>
        <translation>Sie nimmt lineare und korotierte Körper aus finiten Elementen auf, feste Punkte, Bettungen und Lasten.</translation>
    </message>
    <message>
        <source>Without a scenario, the scene hoists segment VI with {0} N.</source>
        <translation>Ohne Szenario hebt die Szene Segment VI mit {0} N an.</translation>
    </message>
    <message>
        <source>A scene for SOFA cannot hold the effect {0}: it is left out.</source>
        <translation>Eine Szene für SOFA kann den Effekt {0} nicht aufnehmen: Er bleibt weg.</translation>
    </message>
    <message>
        <source>SOFA&apos;s linear tetrahedra are stiffer than the quadratic ones here: the largest displacement should be {0} mm in the scene, and is {1} mm in Glisson.</source>
        <translation>Die linearen Tetraeder von SOFA sind steifer als die quadratischen hier: Die größte Verschiebung sollte in der Szene {0} mm sein, in Glisson ist sie {1} mm.</translation>
    </message>
    <message>
        <source>The liver&apos;s points are not those of the liver whose vessels are carried along.</source>
        <translation>Die Punkte der Leber sind nicht die der Leber, deren Gefäße mitgenommen werden.</translation>
    </message>
    <message>
        <source>Give the spacing of the reference that the model was made with, or draw without vessels.</source>
        <translation>Geben Sie den Punktabstand der Referenz an, mit dem das Modell gemacht wurde, oder zeichnen Sie ohne Gefäße.</translation>
    </message>
    <message>
        <source>The liver is bent so far that vessels carried along would be turned inside out.</source>
        <translation>Die Leber ist so stark gebogen, dass mitgenommene Gefäße umgestülpt würden.</translation>
    </message>
    <message>
        <source>--scenario serves a scene for SOFA alone (--format sofa).</source>
        <translation>--scenario gilt nur für eine Szene für SOFA (--format sofa).</translation>
    </message>
    <message>
        <source>The scenario says itself how the organ relaxes: the effect {0} is left out.</source>
        <translation>Das Szenario sagt selbst, wie das Organ relaxiert: Der Effekt {0} bleibt weg.</translation>
    </message>
    <message>
        <source>Held for long, the organ creeps: it is {0} times as stiff as at once. In motion it relaxes on the way there, with times of {1} s.</source>
        <translation>Lange gehalten, kriecht das Organ: Es ist dann {0}-mal so steif wie im ersten Augenblick. In Bewegung relaxiert es bis dahin mit Zeiten von {1} s.</translation>
    </message>
    <message>
        <source>A relaxation has at most {0} terms, and {1} are given.</source>
        <translation>Eine Relaxation hat höchstens {0} Terme, und {1} sind angegeben.</translation>
    </message>
    <message>
        <source>Term {0} of a relaxation needs a weight between 0 and 1 and a time above zero.</source>
        <translation>Term {0} einer Relaxation braucht ein Gewicht zwischen 0 und 1 und eine Zeit über null.</translation>
    </message>
    <message>
        <source>The weights of a relaxation sum to {0}: they must leave something of the stiffness, and sum to less than 1.</source>
        <translation>Die Gewichte einer Relaxation ergeben zusammen {0}: Sie müssen etwas von der Steifigkeit übrig lassen und zusammen weniger als 1 ergeben.</translation>
    </message>
    <message>
        <source>Straight from data nothing relaxes: the measured stresses are what is left.</source>
        <translation>Direkt aus Daten relaxiert nichts: Die gemessenen Spannungen sind das, was übrig bleibt.</translation>
    </message>
    <message>
        <source>Leave out &quot;relaxation&quot;.</source>
        <translation>&quot;relaxation&quot; weglassen.</translation>
    </message>
    <message>
        <source>A line that cuts needs 2 to {0} places; there are {1}.</source>
        <translation>Eine schneidende Linie braucht 2 bis {0} Stellen; es sind {1}.</translation>
    </message>
    <message>
        <source>A line that cuts needs a way into the body with a length.</source>
        <translation>Eine schneidende Linie braucht einen Weg in den Körper hinein, der eine Länge hat.</translation>
    </message>
    <message>
        <source>A place of the line that cuts is not finite.</source>
        <translation>Eine Stelle der schneidenden Linie ist nicht endlich.</translation>
    </message>
    <message>
        <source>Places {0} and {1} of the line that cuts lie above each other, along its way into the body.</source>
        <translation>Die Stellen {0} und {1} der schneidenden Linie liegen übereinander, längs ihres Weges in den Körper.</translation>
    </message>
    <message>
        <source>The line turns more sharply than the model&apos;s cells can follow, or meets itself.</source>
        <translation>Die Linie biegt enger ab, als die Zellen des Modells folgen können, oder trifft auf sich selbst.</translation>
    </message>
    <message>
        <source>Draw a wider curve, or begin a new cut farther away.</source>
        <translation>Zeichnen Sie einen weiteren Bogen, oder beginnen Sie einen neuen Schnitt weiter weg.</translation>
    </message>
    <message>
        <source>Meshfree nodes reach ahead of a cut: its line cannot be drawn further once it is cut along.</source>
        <translation>Netzfreie Knoten reichen über einen Schnitt hinaus: Seine Linie lässt sich nicht weiterzeichnen, sobald an ihr geschnitten ist.</translation>
    </message>
    <message>
        <source>Give the whole line before its first advance, or begin a new cut.</source>
        <translation>Geben Sie die ganze Linie vor ihrem ersten Schritt, oder beginnen Sie einen neuen Schnitt.</translation>
    </message>
    <message>
        <source>The line leaves the surface that it was drawn on.</source>
        <translation>Die Linie verlässt die Oberfläche, auf der sie gezeichnet wurde.</translation>
    </message>
    <message>
        <source>Turn the liver until you look onto it, and go on from there.</source>
        <translation>Drehen Sie die Leber, bis Sie darauf blicken, und fahren Sie von dort fort.</translation>
    </message>
    <message>
        <source>Lift, and begin a new cut farther away.</source>
        <translation>Lassen Sie los, und beginnen Sie einen neuen Schnitt weiter weg.</translation>
    </message>
    <message>
        <source>Cut freehand</source>
        <translation>Freihand schneiden</translation>
    </message>
    <message>
        <source>A body in motion keeps its moduli.</source>
        <translation>Ein Körper in Bewegung behält seine Moduln.</translation>
    </message>
    <message>
        <source>A session in motion is by quadratic finite elements.</source>
        <translation>Eine Sitzung in Bewegung rechnet mit quadratischen finiten Elementen.</translation>
    </message>
    <message>
        <source>A command is {&quot;hold&quot;: {...}}, {&quot;release&quot;: id}, {&quot;cut&quot;: {...}}, {&quot;undo&quot;: true}, {&quot;settle&quot;: true}, {&quot;compare&quot;: true} or {&quot;wait_steps&quot;: n}.</source>
        <translation>Ein Befehl ist {&quot;hold&quot;: {...}}, {&quot;release&quot;: id}, {&quot;cut&quot;: {...}}, {&quot;undo&quot;: true}, {&quot;settle&quot;: true}, {&quot;compare&quot;: true} oder {&quot;wait_steps&quot;: n}.</translation>
    </message>
    <message>
        <source>A cut does not advance in a session in motion.</source>
        <translation>In einer Sitzung in Bewegung lässt sich kein Schnitt weiterführen.</translation>
    </message>
    <message>
        <source>Cut in a session at rest.</source>
        <translation>Schneiden Sie in einer Sitzung in Ruhe.</translation>
    </message>
    <message>
        <source>At large strain a session in motion is damped by its mass alone.</source>
        <translation>Bei großen Dehnungen dämpft eine Sitzung in Bewegung allein über die Masse.</translation>
    </message>
    <message>
        <source>A session in motion is by finite elements.</source>
        <translation>Eine Sitzung in Bewegung rechnet mit finiten Elementen.</translation>
    </message>
    <message>
        <source>Take the engine &quot;fem&quot;, or no motion.</source>
        <translation>Nehmen Sie das Verfahren &quot;fem&quot;, oder keine Bewegung.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::AblationControls</name>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Diameter of the zone along the probe</source>
        <translation>Durchmesser der Zone längs der Sonde</translation>
    </message>
    <message>
        <source>Diameter of the zone across the probe</source>
        <translation>Durchmesser der Zone quer zur Sonde</translation>
    </message>
    <message>
        <source>from the side</source>
        <translation>von der Seite</translation>
    </message>
    <message>
        <source>from the front</source>
        <translation>von vorn</translation>
    </message>
    <message>
        <source>from below</source>
        <translation>von unten</translation>
    </message>
    <message>
        <source>At the crosshair</source>
        <translation>Am Fadenkreuz</translation>
    </message>
    <message>
        <source>Sets a zone of this size about the crosshair</source>
        <translation>Setzt eine Zone dieser Größe um das Fadenkreuz</translation>
    </message>
    <message>
        <source>Over this tumour</source>
        <translation>Über diesen Tumor</translation>
    </message>
    <message>
        <source>Sets the smallest ball that holds the tumour chosen above with its margin</source>
        <translation>Setzt die kleinste Kugel, die den oben gewählten Tumor mit seinem Abstand fasst</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::AdvanceControls</name>
    <message>
        <source>Cut 5 mm further</source>
        <translation>5 mm weiter schneiden</translation>
    </message>
    <message>
        <source>Leads the planned cut on, from the lower front edge to the upper back, while rigid tools hold the liver. Energy devices and bleeding are not simulated.</source>
        <translation>Führt den geplanten Schnitt weiter, vom unteren vorderen Rand nach hinten oben, während starre Instrumente die Leber halten. Energieinstrumente und Blutung werden nicht simuliert.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Tick the rigid tool above, to cut while tools hold the liver.</source>
        <translation>Wählen Sie oben das starre Instrument, um zu schneiden, während Instrumente die Leber halten.</translation>
    </message>
    <message>
        <source>%1 % of the section is open, by up to %2 mm.</source>
        <translation>%1 % der Schnittfläche sind offen, bis zu %2 mm weit.</translation>
    </message>
    <message>
        <source>Crossed: %1.</source>
        <translation>Gekreuzt: %1.</translation>
    </message>
    <message>
        <source>The plan&apos;s cut is %1 mm long. Nothing is cut yet.</source>
        <translation>Der geplante Schnitt ist %1 mm lang. Noch ist nichts geschnitten.</translation>
    </message>
    <message>
        <source>Plan a plane or a sheet in Resect and keep the plan, to cut along it here.</source>
        <translation>Behalten Sie in Resektion einen Plan (Ebene oder Fläche), um hier daran entlang zu schneiden.</translation>
    </message>
    <message>
        <source>By finite elements: %1 mm.</source>
        <translation>Nach finiten Elementen: %1 mm.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Closes the last advance, as long as no tool was moved since</source>
        <translation>Schließt den letzten Schritt, solange seither kein Instrument bewegt wurde</translation>
    </message>
    <message>
        <source>Cut freehand</source>
        <translation>Freihand schneiden</translation>
    </message>
    <message>
        <source>Then draw over the liver in the 3D view with the left button held: it parts behind the pointer, straight away from you, as deep as is said here. From the end of the last line the cut goes on.</source>
        <translation>Dann bei gehaltener linker Taste in der 3D-Ansicht über die Leber zeichnen: Sie teilt sich hinter dem Zeiger, gerade von Ihnen weg, so tief wie hier gesagt. Vom Ende der letzten Linie an geht der Schnitt weiter.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How deep the knife goes from the surface, away from you</source>
        <translation>Wie tief das Messer von der Oberfläche an geht, von Ihnen weg</translation>
    </message>
    <message>
        <source>%1 cm² are cut, open by up to %2 mm.</source>
        <translation>%1 cm² sind geschnitten, bis zu %2 mm weit offen.</translation>
    </message>
    <message>
        <source>Cut freehand, or plan a plane or a sheet in Resect and keep the plan, to cut along it here.</source>
        <translation>Schneiden Sie freihand, oder planen Sie in Resektion eine Ebene oder Fläche und behalten den Plan, um hier an ihm entlang zu schneiden.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::AlgorithmChoice</name>
    <message>
        <source>ICP: nearest points</source>
        <translation>ICP: nächste Punkte</translation>
    </message>
    <message>
        <source>GEO: distances along the surface</source>
        <translation>GEO: Abstände entlang der Oberfläche</translation>
    </message>
    <message>
        <source>GNRA: all frames by their landmarks</source>
        <translation>GNRA: alle Bilder über ihre Landmarken</translation>
    </message>
    <message>
        <source>Given by the sequence</source>
        <translation>Von der Sequenz vorgegeben</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>Vorgegeben</translation>
    </message>
    <message>
        <source>Algorithms</source>
        <translation>Algorithmen</translation>
    </message>
    <message>
        <source>First algorithm</source>
        <translation>Erster Algorithmus</translation>
    </message>
    <message>
        <source>Second algorithm</source>
        <translation>Zweiter Algorithmus</translation>
    </message>
    <message>
        <source>What the left picture shows</source>
        <translation>Was das linke Bild zeigt</translation>
    </message>
    <message>
        <source>What the right picture shows, or nothing</source>
        <translation>Was das rechte Bild zeigt, oder nichts</translation>
    </message>
    <message>
        <source>Register and judge</source>
        <translation>Registrieren und beurteilen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stops registering; what was computed before stays</source>
        <translation>Hält das Registrieren an; was vorher berechnet war, bleibt</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>No second algorithm</source>
        <translation>Kein zweiter Algorithmus</translation>
    </message>
    <message>
        <source>The sequence names no registered clouds</source>
        <translation>Die Sequenz nennt keine registrierten Punktwolken</translation>
    </message>
    <message>
        <source>The sequence names no model</source>
        <translation>Die Sequenz nennt kein Modell</translation>
    </message>
    <message>
        <source>Open a sequence first</source>
        <translation>Zuerst eine Sequenz öffnen</translation>
    </message>
    <message>
        <source>It is being computed</source>
        <translation>Es wird gerade berechnet</translation>
    </message>
    <message>
        <source>Both algorithms are computed already</source>
        <translation>Beide Algorithmen sind schon berechnet</translation>
    </message>
    <message>
        <source>Registers every frame by the algorithms above and judges them by SIRGn: up to a second or so a frame</source>
        <translation>Registriert jedes Bild mit den Algorithmen oben und beurteilt sie mit SIRGn: bis etwa eine Sekunde je Bild</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::BorderByHand</name>
    <message>
        <source>Runs through the crosshair</source>
        <translation>Verläuft durch das Fadenkreuz</translation>
    </message>
    <message>
        <source>First stands the border that runs nearest to the crosshair</source>
        <translation>Zuerst steht die Grenze, die dem Fadenkreuz am nächsten verläuft</translation>
    </message>
    <message>
        <source>Border %1 (%2 mm away)</source>
        <translation>Grenze %1 (%2 mm entfernt)</translation>
    </message>
    <message>
        <source>Forget the last place (%1)</source>
        <translation>Letzte Stelle vergessen (%1)</translation>
    </message>
    <message>
        <source>Places on borders that were set by hand: %1. Segments are found again without the last</source>
        <translation>Von Hand gesetzte Stellen auf Grenzen: %1. Segmente werden ohne die letzte neu bestimmt</translation>
    </message>
    <message>
        <source>The border of these two segments is to pass the crosshair. Segments are found again by it, and are less in doubt. Its mark is dragged in a slice or in 3D; Delete takes away the one that was clicked on</source>
        <translation>Die Grenze dieser beiden Segmente soll durch das Fadenkreuz gehen. Segmente werden danach neu bestimmt und sind weniger fraglich. Ihre Marke lässt sich in einer Schicht oder in 3D ziehen; Entf nimmt die angeklickte weg</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::CandidatesTable</name>
    <message>
        <source>very strong</source>
        <translation>sehr stark</translation>
    </message>
    <message>
        <source>strong</source>
        <translation>stark</translation>
    </message>
    <message>
        <source>weak</source>
        <translation>schwach</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>Suspect, each by itself</source>
        <translation>Verdacht, jeder für sich</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>On trials left out</source>
        <translation>An ausgelassenen Versuchen</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>Beleg</translation>
    </message>
    <message>
        <source>These data cannot tell it from</source>
        <translation>Diese Daten unterscheiden es nicht von</translation>
    </message>
    <message>
        <source>Root mean square on the trials that it was fitted to</source>
        <translation>Quadratisches Mittel auf den Versuchen, an die es angepasst wurde</translation>
    </message>
    <message>
        <source>Root mean square on trials that it was not fitted to, left out whole</source>
        <translation>Quadratisches Mittel auf ganz ausgelassenen Versuchen, an die es nicht angepasst wurde</translation>
    </message>
    <message>
        <source>Against the declared model, by the difference of BIC</source>
        <translation>Gegen das angegebene Modell, nach dem Unterschied des BIC</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>ΔBIC %1</source>
        <translation>ΔBIC %1</translation>
    </message>
    <message>
        <source>out of the running: %1</source>
        <translation>aus dem Rennen: %1</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::CaseDiary</name>
    <message>
        <source>Diary of %1 - Glisson</source>
        <translation>Tagebuch von %1 - Glisson</translation>
    </message>
    <message>
        <source>What was done to this case, as far as it can be undone. Copied, it is a program that does the same without a window, on the case as it was before.</source>
        <translation>Was an diesem Fall getan wurde, soweit es rückgängig zu machen ist. Kopiert ist es ein Programm, das ohne Fenster dasselbe tut, am Fall, wie er vorher war.</translation>
    </message>
    <message>
        <source>The steps</source>
        <translation>Die Schritte</translation>
    </message>
    <message>
        <source>Copy as Python</source>
        <translation>Als Python kopieren</translation>
    </message>
    <message>
        <source>Copy as command line</source>
        <translation>Als Befehlszeilen kopieren</translation>
    </message>
    <message>
        <source>Steps copied: %1</source>
        <translation>Kopierte Schritte: %1</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::CaseOverview</name>
    <message>
        <source>The open case</source>
        <translation>Der offene Fall</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Erstellt durch</translation>
    </message>
    <message>
        <source>What comes next</source>
        <translation>Was als Nächstes kommt</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <source>⚠ stale</source>
        <translation>⚠ veraltet</translation>
    </message>
    <message>
        <source>⚠ changed by another program</source>
        <translation>⚠ von einem anderen Programm geändert</translation>
    </message>
    <message>
        <source>⚠ file is gone</source>
        <translation>⚠ Datei fehlt</translation>
    </message>
    <message>
        <source>Something that it was made from has changed since.</source>
        <translation>Etwas, woraus es gemacht wurde, hat sich seither geändert.</translation>
    </message>
    <message>
        <source>No case is open. Open images, choose what each series is for, and make a case of them.</source>
        <translation>Es ist kein Fall geöffnet. Öffnen Sie Bilder, wählen Sie, wozu jede Serie dient, und legen Sie daraus einen Fall an.</translation>
    </message>
    <message>
        <source>Everything is up to date.</source>
        <translation>Alles ist aktuell.</translation>
    </message>
    <message>
        <source>Stale: %1. They were made from something that has changed since.</source>
        <translation>Veraltet: %1. Sie wurden aus etwas gemacht, das sich seither geändert hat.</translation>
    </message>
    <message>
        <source>Make the model anew</source>
        <translation>Modell neu erstellen</translation>
    </message>
    <message>
        <source>There are no anatomical images: without them nothing can be outlined. Open them on the left.</source>
        <translation>Es gibt keine anatomischen Bilder: Ohne sie kann nichts umrissen werden. Öffnen Sie sie links.</translation>
    </message>
    <message>
        <source>The elastography has not been inverted: File, Elastography waves (Ctrl+W) makes the stiffness of it.</source>
        <translation>Die Elastographie ist noch nicht invertiert: Datei, Elastographie-Wellen (Strg+W) macht daraus die Steifigkeit.</translation>
    </message>
    <message>
        <source>The liver is not outlined yet.</source>
        <translation>Die Leber ist noch nicht umrissen.</translation>
    </message>
    <message>
        <source>Outline it in Segment</source>
        <translation>In Segmentieren umreißen</translation>
    </message>
    <message>
        <source>There is no model yet.</source>
        <translation>Es gibt noch kein Modell.</translation>
    </message>
    <message>
        <source>Build the model</source>
        <translation>Modell erstellen</translation>
    </message>
    <message>
        <source>The model is there.</source>
        <translation>Das Modell ist da.</translation>
    </message>
    <message>
        <source>Rehearse</source>
        <translation>Proben</translation>
    </message>
    <message>
        <source>Building the model</source>
        <translation>Modell wird erstellt</translation>
    </message>
    <message>
        <source>import</source>
        <translation>Import</translation>
    </message>
    <message>
        <source>outlining</source>
        <translation>Umreißen</translation>
    </message>
    <message>
        <source>meshing</source>
        <translation>Vernetzung</translation>
    </message>
    <message>
        <source>giving stiffness</source>
        <translation>Steifigkeit zuweisen</translation>
    </message>
    <message>
        <source>inversion of waves</source>
        <translation>Inversion der Wellen</translation>
    </message>
    <message>
        <source>Outline: %1</source>
        <translation>Umriss: %1</translation>
    </message>
    <message>
        <source>Surface: %1</source>
        <translation>Oberfläche: %1</translation>
    </message>
    <message>
        <source>Tetrahedra of the liver</source>
        <translation>Tetraeder der Leber</translation>
    </message>
    <message>
        <source>Model: stiffness of each cell</source>
        <translation>Modell: Steifigkeit jeder Zelle</translation>
    </message>
    <message>
        <source>Images: anatomy</source>
        <translation>Bilder: Anatomie</translation>
    </message>
    <message>
        <source>Map: stiffness (kPa)</source>
        <translation>Karte: Steifigkeit (kPa)</translation>
    </message>
    <message>
        <source>Map: confidence</source>
        <translation>Karte: Konfidenz</translation>
    </message>
    <message>
        <source>MRE magnitude</source>
        <translation>MRE-Magnitude</translation>
    </message>
    <message>
        <source>MRE phase</source>
        <translation>MRE-Phase</translation>
    </message>
    <message>
        <source>MRE waves</source>
        <translation>MRE-Wellen</translation>
    </message>
    <message>
        <source>There is no model yet. Without elastography its stiffness is assumed: the atlas&apos;s.</source>
        <translation>Es gibt noch kein Modell. Ohne Elastographie ist seine Steifigkeit angenommen: die des Atlas.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ComparisonChoice</name>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Atlas</source>
        <translation>Atlas</translation>
    </message>
    <message>
        <source>With one stiffness for the whole liver, as an atlas gives it</source>
        <translation>Mit einer einzigen Steifigkeit für die ganze Leber, wie ein Atlas sie angibt</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Atlas in red, patient in blue: purple where they agree</source>
        <translation>Atlas in Rot, Patient in Blau: violett, wo sie übereinstimmen</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Two 3D views that turn together: the patient on the left, the atlas on the right</source>
        <translation>Zwei 3D-Ansichten, die sich gemeinsam drehen: links der Patient, rechts der Atlas</translation>
    </message>
    <message>
        <source>No stiffness was measured: there is nothing to compare with the atlas</source>
        <translation>Es wurde keine Steifigkeit gemessen: Mit dem Atlas ist nichts zu vergleichen</translation>
    </message>
    <message>
        <source>With this patient&apos;s own stiffness, as it was measured</source>
        <translation>Mit der eigenen Steifigkeit dieses Patienten, wie sie gemessen wurde</translation>
    </message>
    <message>
        <source>With the assumed stiffness</source>
        <translation>Mit der angenommenen Steifigkeit</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ContourPlot</name>
    <message>
        <source>Liver (cm³)</source>
        <translation>Leber (cm³)</translation>
    </message>
    <message>
        <source>Volume of a node (mm³)</source>
        <translation>Volumen eines Knotens (mm³)</translation>
    </message>
    <message>
        <source>Accuracy (mm)</source>
        <translation>Genauigkeit (mm)</translation>
    </message>
    <message>
        <source>hot spot</source>
        <translation>heiße Stelle</translation>
    </message>
    <message>
        <source>this case</source>
        <translation>dieser Fall</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::CutControls</name>
    <message>
        <source>Cut by a plane</source>
        <translation>Schnitt mit einer Ebene</translation>
    </message>
    <message>
        <source>Cut by a smooth surface through points</source>
        <translation>Schnitt mit einer glatten Fläche durch Punkte</translation>
    </message>
    <message>
        <source>Divides</source>
        <translation>Trennt</translation>
    </message>
    <message>
        <source>left from right</source>
        <translation>links von rechts</translation>
    </message>
    <message>
        <source>front from back</source>
        <translation>vorn von hinten</translation>
    </message>
    <message>
        <source>head from foot</source>
        <translation>Kopf- von Fußseite</translation>
    </message>
    <message>
        <source>Through crosshair</source>
        <translation>Durchs Fadenkreuz</translation>
    </message>
    <message>
        <source>Puts the plane through the crosshair, across the direction above</source>
        <translation>Legt die Ebene durch das Fadenkreuz, quer zur Richtung darüber</translation>
    </message>
    <message>
        <source>By three clicks</source>
        <translation>Mit drei Klicks</translation>
    </message>
    <message>
        <source>Then click three places on the liver or in the slices</source>
        <translation>Klicken Sie dann drei Stellen auf der Leber oder in den Schichten an</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Kippen</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Distance of the plane from the middle of the liver, along its normal</source>
        <translation>Abstand der Ebene von der Mitte der Leber, entlang ihrer Normalen</translation>
    </message>
    <message>
        <source>The normal about the axis from feet to head: 0° to the patient&apos;s left, 90° to the back</source>
        <translation>Die Normale um die Achse von den Füßen zum Kopf: 0° zur linken Seite des Patienten, 90° nach hinten</translation>
    </message>
    <message>
        <source>The normal upwards: 90° to the head</source>
        <translation>Die Normale nach oben: 90° zum Kopf</translation>
    </message>
    <message>
        <source>Set points</source>
        <translation>Punkte setzen</translation>
    </message>
    <message>
        <source>Each click on the liver or in a slice sets a point; points can be dragged</source>
        <translation>Jeder Klick auf die Leber oder in eine Schicht setzt einen Punkt; Punkte lassen sich ziehen</translation>
    </message>
    <message>
        <source>Drop the last</source>
        <translation>Letzten entfernen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Points set: %1. Three are needed.</source>
        <translation>Gesetzte Punkte: %1. Drei sind nötig.</translation>
    </message>
    <message>
        <source>Points set: %1. Drag them in any view.</source>
        <translation>Gesetzte Punkte: %1. Sie lassen sich in jeder Ansicht ziehen.</translation>
    </message>
    <message>
        <source>Draw a line</source>
        <translation>Linie zeichnen</translation>
    </message>
    <message>
        <source>Then draw over the liver in the 3D view with the left button held: the cut goes straight down under the line, as it is seen from there</source>
        <translation>Zeichnen Sie dann in der 3D-Ansicht mit gedrückter linker Taste über die Leber: Der Schnitt geht unter der Linie gerade in die Tiefe, so wie man sie von dort sieht</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::DeformationChoice</name>
    <message>
        <source>Deformations</source>
        <translation>Verformungen</translation>
    </message>
    <message>
        <source>Small (at once)</source>
        <translation>Kleine (sofort)</translation>
    </message>
    <message>
        <source>A linear liver: made for strains up to 20 %</source>
        <translation>Eine lineare Leber: gemacht für Dehnungen bis 20 %</translation>
    </message>
    <message>
        <source>Large (settles)</source>
        <translation>Große (kommt zur Ruhe)</translation>
    </message>
    <message>
        <source>A hyperelastic (neo-Hookean) liver of the same stiffness: made for larger strains too. A first picture says how far its landmarks may be from rest, and is brought to rest in the background.</source>
        <translation>Eine hyperelastische (neo-Hookesche) Leber derselben Steifigkeit: auch für größere Dehnungen gemacht. Ein erstes Bild sagt, wie weit seine Landmarken von der Ruhelage sein können, und wird im Hintergrund zur Ruhe gebracht.</translation>
    </message>
    <message>
        <source>Use large deformations</source>
        <translation>Große Verformungen nehmen</translation>
    </message>
    <message>
        <source>The tools stay where they are; what was recorded begins anew</source>
        <translation>Die Instrumente bleiben, wo sie sind; die Aufzeichnung beginnt neu</translation>
    </message>
    <message>
        <source>The liver is being prepared for large deformations.</source>
        <translation>Die Leber wird für große Verformungen vorbereitet.</translation>
    </message>
    <message>
        <source>Large deformations, as you chose.</source>
        <translation>Große Verformungen, wie Sie gewählt haben.</translation>
    </message>
    <message>
        <source>Large deformations, as you chose: strains reach %1 %, small ones would only extrapolate.</source>
        <translation>Große Verformungen, wie Sie gewählt haben: Dehnungen erreichen %1 %, kleine würden nur extrapolieren.</translation>
    </message>
    <message>
        <source>Large deformations, as you chose. Strains reach %1 %: small ones would do.</source>
        <translation>Große Verformungen, wie Sie gewählt haben. Dehnungen erreichen %1 %: kleine würden genügen.</translation>
    </message>
    <message>
        <source>Small deformations: evidence gave this liver a grain, which large ones do not know.</source>
        <translation>Kleine Verformungen: Belege gaben dieser Leber eine Faserrichtung, die große nicht kennen.</translation>
    </message>
    <message>
        <source>Small deformations: made for strains up to 20 %.</source>
        <translation>Kleine Verformungen: gemacht für Dehnungen bis 20 %.</translation>
    </message>
    <message>
        <source>Small deformations, but strains reach %1 %: beyond 20 % take large ones.</source>
        <translation>Kleine Verformungen, doch Dehnungen erreichen %1 %: jenseits von 20 % große nehmen.</translation>
    </message>
    <message>
        <source>Small deformations: enough, since strains reach %1 % only.</source>
        <translation>Kleine Verformungen: sie genügen, denn Dehnungen erreichen nur %1 %.</translation>
    </message>
    <message>
        <source>Small, meshfree</source>
        <translation>Kleine, netzfrei</translation>
    </message>
    <message>
        <source>A linear liver by a few hundred meshfree nodes in place of finite elements, under rigid tools. Finite elements answer beside it, so that you see what it costs and what it misses.</source>
        <translation>Eine lineare Leber aus einigen Hundert netzfreien Knoten anstelle finiter Elemente, unter starren Instrumenten. Finite Elemente antworten daneben, sodass Sie sehen, was es kostet und was ihm entgeht.</translation>
    </message>
    <message>
        <source>The liver is being prepared for the meshfree engine.</source>
        <translation>Die Leber wird für das netzfreie Verfahren vorbereitet.</translation>
    </message>
    <message>
        <source>Meshfree, as you chose. Finite elements will answer beside it.</source>
        <translation>Netzfrei, wie Sie wählten. Finite Elemente werden daneben antworten.</translation>
    </message>
    <message>
        <source>Meshfree, as you chose. Finite elements found no shape under these tools.</source>
        <translation>Netzfrei, wie Sie wählten. Finite Elemente fanden unter diesen Instrumenten keine Form.</translation>
    </message>
    <message>
        <source>Meshfree, as you chose: %1 ms, finite elements %2 ms. Landmarks are %3 mm apart at most, the surface %4 mm.</source>
        <translation>Netzfrei, wie Sie wählten: %1 ms, finite Elemente %2 ms. Landmarken liegen höchstens %3 mm auseinander, die Oberfläche %4 mm.</translation>
    </message>
    <message>
        <source>Small, in motion</source>
        <translation>Kleine, in Bewegung</translation>
    </message>
    <message>
        <source>A linear liver that takes its time, under rigid tools: what is let go swings and comes to rest, and tissue that creeps gives way under a held tool and comes back slowly. It is not cut.</source>
        <translation>Eine lineare Leber, die Zeit braucht, unter starren Instrumenten: Was losgelassen wird, schwingt und kommt zur Ruhe, und Gewebe, das kriecht, gibt unter einem gehaltenen Instrument nach und kommt langsam zurück. Sie wird nicht geschnitten.</translation>
    </message>
    <message>
        <source>The liver is being prepared to move.</source>
        <translation>Die Leber wird für die Bewegung vorbereitet.</translation>
    </message>
    <message>
        <source>Its tissue creeps, as evidence showed.</source>
        <translation>Ihr Gewebe kriecht, wie Belege gezeigt haben.</translation>
    </message>
    <message>
        <source>Its tissue is elastic: no accepted evidence shows that it creeps.</source>
        <translation>Ihr Gewebe ist elastisch: Kein angenommener Beleg zeigt, dass es kriecht.</translation>
    </message>
    <message>
        <source>In motion, as you chose.</source>
        <translation>In Bewegung, wie gewählt.</translation>
    </message>
    <message>
        <source>In motion, as you chose: %1 mm/s at most.</source>
        <translation>In Bewegung, wie gewählt: höchstens %1 mm/s.</translation>
    </message>
    <message>
        <source>In motion, as you chose: it has come to rest.</source>
        <translation>In Bewegung, wie gewählt: Sie ist zur Ruhe gekommen.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::DiaryWindow</name>
    <message>
        <source>Log - Glisson</source>
        <translation>Protokoll - Glisson</translation>
    </message>
    <message>
        <source>What Glisson did, in English, for those who mend it. It holds nothing about a patient: no names, no paths, no values. Nothing is sent anywhere; you decide who gets it.</source>
        <translation>Was Glisson getan hat, auf Englisch, für alle, die es reparieren. Über Patienten steht hier nichts: keine Namen, keine Pfade, keine Werte. Nichts wird irgendwohin gesendet; Sie entscheiden, wer es bekommt.</translation>
    </message>
    <message>
        <source>The log</source>
        <translation>Das Protokoll</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Save a report of the problem...</source>
        <translation>Bericht über das Problem speichern …</translation>
    </message>
    <message>
        <source>Save a report of the problem</source>
        <translation>Bericht über das Problem speichern</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Text (*.txt)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ErrorsTable</name>
    <message>
        <source>%1 × noise</source>
        <translation>%1 × Rauschen</translation>
    </message>
    <message>
        <source>Error, × noise</source>
        <translation>Fehler, × Rauschen</translation>
    </message>
    <message>
        <source>Error, %1</source>
        <translation>Fehler, %1</translation>
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
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>On trials left out</source>
        <translation>An ausgelassenen Versuchen</translation>
    </message>
    <message>
        <source>95 % interval of it</source>
        <translation>95-%-Intervall davon</translation>
    </message>
    <message>
        <source>Root mean square</source>
        <translation>Quadratisches Mittel</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>95 of 100 are below</source>
        <translation>95 von 100 liegen darunter</translation>
    </message>
    <message>
        <source>Noise of the measurement</source>
        <translation>Rauschen der Messung</translation>
    </message>
    <message>
        <source>Hidden targets, mean</source>
        <translation>Verborgene Ziele, Mittel</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::EvidenceAnswer</name>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>Residual (mm)</source>
        <translation>Residuum (mm)</translation>
    </message>
    <message>
        <source>Measured less predicted, where this trial was farthest off. Arrows %1 times as long as they are; colours reach to %2 mm, between markers interpolated.</source>
        <translation>Gemessen minus vorhergesagt, wo dieser Versuch am weitesten abwich. Pfeile %1-fach verlängert; Farben bis %2 mm, zwischen Markern interpoliert.</translation>
    </message>
    <message>
        <source>No test finds anything in it that noise would not do.</source>
        <translation>Kein Test findet darin etwas, das Rauschen nicht täte.</translation>
    </message>
    <message>
        <source>What the declared model leaves is not noise: %1.</source>
        <translation>Was das angegebene Modell übrig lässt, ist kein Rauschen: %1.</translation>
    </message>
    <message>
        <source>What is left at the end: %1.</source>
        <translation>Was am Ende bleibt: %1.</translation>
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
        <source>Suspects</source>
        <translation>Verdächtige</translation>
    </message>
    <message>
        <source>What to measure next</source>
        <translation>Was als Nächstes zu messen ist</translation>
    </message>
    <message>
        <source>No further trial is known that would tell the leading explanations apart.</source>
        <translation>Kein weiterer Versuch ist bekannt, der die führenden Erklärungen unterschiede.</translation>
    </message>
    <message>
        <source>Trial that is shown</source>
        <translation>Gezeigter Versuch</translation>
    </message>
    <message>
        <source>What is left, in space</source>
        <translation>Was übrig bleibt, im Raum</translation>
    </message>
    <message>
        <source>The error before and after</source>
        <translation>Der Fehler vorher und nachher</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>The error falls from %1 to %2.</source>
        <translation>Der Fehler fällt von %1 auf %2.</translation>
    </message>
    <message>
        <source>%1 It would tell what is likeliest from: %2.</source>
        <translation>%1 Das würde das Wahrscheinlichste unterscheiden von: %2.</translation>
    </message>
    <message>
        <source>%1 Of the doubt %2 % is expected to be gone then.</source>
        <translation>%1 Vom Zweifel sind dann voraussichtlich %2 % beseitigt.</translation>
    </message>
    <message>
        <source>What these trials could have shown</source>
        <translation>Was diese Versuche hätten zeigen können</translation>
    </message>
    <message>
        <source>Of experiments of this sort no further trial is proposed.</source>
        <translation>Für Experimente dieser Art wird kein weiterer Versuch vorgeschlagen.</translation>
    </message>
    <message>
        <source>Nothing is missing: what the declared model leaves, %1, shows no effect.</source>
        <translation>Es fehlt nichts: Was das angegebene Modell übrig lässt, %1, zeigt keinen Effekt.</translation>
    </message>
    <message>
        <source>%1: something acts, but no effect that Glisson knows is probable enough to be named.</source>
        <translation>%1: Es wirkt etwas, aber kein Effekt, den Glisson kennt, ist wahrscheinlich genug, um genannt zu werden.</translation>
    </message>
    <message>
        <source>%1: %2. This takes away %3 % of the error.</source>
        <translation>%1: %2. Das nimmt %3 % des Fehlers weg.</translation>
    </message>
    <message>
        <source>%1: %2 takes away %3 % of the error, but is not probable enough to be called the cause.</source>
        <translation>%1: %2 nimmt %3 % des Fehlers weg, ist aber nicht wahrscheinlich genug, um Ursache zu heißen.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::EvidenceView</name>
    <message>
        <source>Evidence</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Hold measurements against the model, and find what it lacks.</source>
        <translation>Messungen gegen das Modell halten und finden, was ihm fehlt.</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Open an experiment...</source>
        <translation>Experiment öffnen …</translation>
    </message>
    <message>
        <source>A file that says what was measured and which model was assumed (Help, Closing the loop)</source>
        <translation>Eine Datei, die sagt, was gemessen und welches Modell angenommen wurde (Hilfe, Den Kreis mit Messungen schließen)</translation>
    </message>
    <message>
        <source>Try the example</source>
        <translation>Das Beispiel probieren</translation>
    </message>
    <message>
        <source>Open a report...</source>
        <translation>Bericht öffnen …</translation>
    </message>
    <message>
        <source>A folder with report.json and model.json, written here or by glisson-cli explain</source>
        <translation>Ein Ordner mit report.json und model.json, hier oder von glisson-cli explain geschrieben</translation>
    </message>
    <message>
        <source>For the patient</source>
        <translation>Für den Patienten</translation>
    </message>
    <message>
        <source>Accept for this patient</source>
        <translation>Für diesen Patienten übernehmen</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Other trials</source>
        <translation>Andere Versuche</translation>
    </message>
    <message>
        <source>Predict other trials...</source>
        <translation>Andere Versuche vorhersagen …</translation>
    </message>
    <message>
        <source>An experiment of the same kind; where it was measured, both models are compared with it</source>
        <translation>Ein Experiment derselben Art; wo gemessen wurde, werden beide Modelle damit verglichen</translation>
    </message>
    <message>
        <source>Save the report...</source>
        <translation>Bericht speichern …</translation>
    </message>
    <message>
        <source>Explaining %1</source>
        <translation>%1 wird erklärt</translation>
    </message>
    <message>
        <source>Open measurements first.</source>
        <translation>Öffnen Sie zuerst Messungen.</translation>
    </message>
    <message>
        <source>Nothing was found missing that could be accepted.</source>
        <translation>Nichts Fehlendes gefunden, das übernommen werden könnte.</translation>
    </message>
    <message>
        <source>What was found is of a computer, not of a patient.</source>
        <translation>Das Gefundene betrifft einen Rechner, keinen Patienten.</translation>
    </message>
    <message>
        <source>Open the patient&apos;s case first.</source>
        <translation>Öffnen Sie zuerst den Fall des Patienten.</translation>
    </message>
    <message>
        <source>Tick an effect among what was found.</source>
        <translation>Kreuzen Sie unter dem Gefundenen einen Effekt an.</translation>
    </message>
    <message>
        <source>%1, learnt from %2</source>
        <translation>%1, gelernt aus %2</translation>
    </message>
    <message>
        <source>A palpation</source>
        <translation>Eine Palpation</translation>
    </message>
    <message>
        <source>A material test</source>
        <translation>Ein Materialversuch</translation>
    </message>
    <message>
        <source>A wearable computer</source>
        <translation>Ein am Körper getragener Rechner</translation>
    </message>
    <message>
        <source>Nothing is open.</source>
        <translation>Nichts ist geöffnet.</translation>
    </message>
    <message>
        <source>The ticked effects change the organ that is rehearsed</source>
        <translation>Die angekreuzten Effekte ändern das Organ, das geprobt wird</translation>
    </message>
    <message>
        <source>Nothing was accepted for this patient.</source>
        <translation>Für diesen Patienten wurde nichts übernommen.</translation>
    </message>
    <message>
        <source>The organ is again what it was before</source>
        <translation>Das Organ ist wieder, was es vorher war</translation>
    </message>
    <message>
        <source>Accepted: %1</source>
        <translation>Übernommen: %1</translation>
    </message>
    <message>
        <source>Accepted, but left out: %1</source>
        <translation>Übernommen, aber ausgelassen: %1</translation>
    </message>
    <message>
        <source>About %1 s left</source>
        <translation>Noch etwa %1 s</translation>
    </message>
    <message>
        <source>About %1 min left</source>
        <translation>Noch etwa %1 min</translation>
    </message>
    <message>
        <source>Accepting the evidence</source>
        <translation>Befund wird übernommen</translation>
    </message>
    <message>
        <source>Taking the evidence back</source>
        <translation>Befund wird zurückgenommen</translation>
    </message>
    <message>
        <source>Predicting the trials of %1</source>
        <translation>Versuche von %1 werden vorhergesagt</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Declared</source>
        <translation>Angegebenes</translation>
    </message>
    <message>
        <source>Better</source>
        <translation>Besseres</translation>
    </message>
    <message>
        <source>Root mean square error, %1</source>
        <translation>Mittlerer quadratischer Fehler, %1</translation>
    </message>
    <message>
        <source>Open an experiment</source>
        <translation>Experiment öffnen</translation>
    </message>
    <message>
        <source>Experiments (*.json)</source>
        <translation>Experimente (*.json)</translation>
    </message>
    <message>
        <source>Open a report (a folder with report.json)</source>
        <translation>Einen Bericht öffnen (ein Ordner mit report.json)</translation>
    </message>
    <message>
        <source>Predict other trials</source>
        <translation>Andere Versuche vorhersagen</translation>
    </message>
    <message>
        <source>Save the report in this folder</source>
        <translation>Den Bericht in diesem Ordner speichern</translation>
    </message>
    <message>
        <source>The report is in %1</source>
        <translation>Der Bericht liegt in %1</translation>
    </message>
    <message>
        <source>What was found would change nothing in the rehearsal: %1</source>
        <translation>Was gefunden wurde, würde an der Probe nichts ändern: %1</translation>
    </message>
    <message>
        <source>This was measured on &quot;%1&quot;, and nothing shows that it is tissue of %2.</source>
        <translation>Das wurde an „%1“ gemessen, und nichts zeigt, dass es Gewebe von %2 ist.</translation>
    </message>
    <message>
        <source>Accept for this patient?</source>
        <translation>Für diesen Patienten annehmen?</translation>
    </message>
    <message>
        <source>Specimen: %1
Patient: %2

The organ that is rehearsed changes:
%3</source>
        <translation>Probe: %1
Patient: %2

Das geprobte Organ ändert sich:
%3</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Annehmen</translation>
    </message>
    <message>
        <source>A sample of tissue, compressed: simulated, and it does something that its file does not declare</source>
        <translation>Eine Gewebeprobe unter Druck: simuliert, und sie tut etwas, das ihre Datei nicht angibt</translation>
    </message>
    <message>
        <source>A guided sequence</source>
        <translation>Eine geführte Sequenz</translation>
    </message>
    <message>
        <source>What was found is of a plate, not of a patient.</source>
        <translation>Was gefunden wurde, betrifft eine Platte, keinen Patienten.</translation>
    </message>
    <message>
        <source>A plate in full field</source>
        <translation>Eine Platte mit Vollfeldmessung</translation>
    </message>
    <message>
        <source>What was found is of waves, not of how an organ is held.</source>
        <translation>Das Gefundene betrifft Wellen, nicht, wie ein Organ gehalten wird.</translation>
    </message>
    <message>
        <source>Waves of an elastography</source>
        <translation>Wellen einer Elastographie</translation>
    </message>
    <message>
        <source>Open measurements of a palpation, a material test, a plate in full field, waves of an elastography, a guided sequence or a wearable computer.
Glisson says how far the declared model is off, what it lacks, and how sure that is.

No measurements at hand? Try the example: a simulated sample of tissue that does something undeclared.</source>
        <translation>Öffnen Sie Messungen einer Palpation, eines Materialversuchs, einer Platte mit Vollfeldmessung, der Wellen einer Elastographie, einer geführten Sequenz oder eines am Körper getragenen Rechners.
Glisson sagt, wie weit das angegebene Modell danebenliegt, was ihm fehlt und wie sicher das ist.

Keine Messungen zur Hand? Probieren Sie das Beispiel: eine simulierte Gewebeprobe, die etwas nicht Angegebenes tut.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ExportMenu</name>
    <message>
        <source>Images and outlines as NIfTI...</source>
        <translation>Bilder und Umrisse als NIfTI...</translation>
    </message>
    <message>
        <source>Images and outlines as NRRD (3D Slicer)...</source>
        <translation>Bilder und Umrisse als NRRD (3D Slicer)...</translation>
    </message>
    <message>
        <source>Outlines as DICOM SEG...</source>
        <translation>Umrisse als DICOM SEG...</translation>
    </message>
    <message>
        <source>Surfaces as STL...</source>
        <translation>Oberflächen als STL...</translation>
    </message>
    <message>
        <source>Surfaces as OBJ...</source>
        <translation>Oberflächen als OBJ...</translation>
    </message>
    <message>
        <source>Surfaces as VTP (ParaView)...</source>
        <translation>Oberflächen als VTP (ParaView)...</translation>
    </message>
    <message>
        <source>The model&apos;s tetrahedra as VTU...</source>
        <translation>Die Tetraeder des Modells als VTU...</translation>
    </message>
    <message>
        <source>Save the outlines</source>
        <translation>Umrisse speichern</translation>
    </message>
    <message>
        <source>DICOM (*.dcm)</source>
        <translation>DICOM (*.dcm)</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Modell speichern</translation>
    </message>
    <message>
        <source>VTK meshes (*.vtu)</source>
        <translation>VTK-Netze (*.vtu)</translation>
    </message>
    <message>
        <source>Write the files into this folder</source>
        <translation>Dateien in diesen Ordner schreiben</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Files written: %1, in %2</source>
        <translation>Geschriebene Dateien: %1, in %2</translation>
    </message>
    <message>
        <source>Outlines, remnant and specimen as DICOM SEG</source>
        <translation>Umrisse, Rest und Resektat als DICOM SEG</translation>
    </message>
    <message>
        <source>No plan is kept: keep one in Resect</source>
        <translation>Kein Plan ist behalten: Behalten Sie einen in Resektion</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FiguresTable</name>
    <message>
        <source>Figures of the registrations</source>
        <translation>Kennzahlen der Registrierungen</translation>
    </message>
    <message>
        <source>Mean correlation</source>
        <translation>Mittlere Korrelation</translation>
    </message>
    <message>
        <source>Rejected (%)</source>
        <translation>Verworfen (%)</translation>
    </message>
    <message>
        <source>TRE (mm)</source>
        <translation>TRE (mm)</translation>
    </message>
    <message>
        <source>TRE, this frame (mm)</source>
        <translation>TRE, dieses Bild (mm)</translation>
    </message>
    <message>
        <source>RMSE (mm)</source>
        <translation>RMSE (mm)</translation>
    </message>
    <message>
        <source>RMSE, this frame (mm)</source>
        <translation>RMSE, dieses Bild (mm)</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>SIRGn, over the triangles: 1 is best</source>
        <translation>SIRGn, über die Dreiecke: 1 ist am besten</translation>
    </message>
    <message>
        <source>Share of the triangles whose corners are off by %1 mm or more on average</source>
        <translation>Anteil der Dreiecke, deren Ecken im Mittel um %1 mm oder mehr danebenliegen</translation>
    </message>
    <message>
        <source>Target registration error: how far registered landmarks are from where they are on the model, mm</source>
        <translation>Zielregistrierungsfehler (TRE): wie weit registrierte Landmarken von ihrem Ort auf dem Modell entfernt sind, mm</translation>
    </message>
    <message>
        <source>How far the registered cloud is from the model (root mean square), mm</source>
        <translation>Wie weit die registrierte Punktwolke vom Modell entfernt ist (quadratisches Mittel), mm</translation>
    </message>
    <message>
        <source>To register all frames and to judge them, s</source>
        <translation>Um alle Bilder zu registrieren und zu beurteilen, s</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FoundTree</name>
    <message>
        <source>Effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>Value ± sd</source>
        <translation>Wert ± Std.abw.</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>● left open by the data</source>
        <translation>● von den Daten offen gelassen</translation>
    </message>
    <message>
        <source>changes nothing in the rehearsal</source>
        <translation>ändert an der Probe nichts</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FreehandKnife</name>
    <message>
        <source>The last line is still being cut.</source>
        <translation>Die letzte Linie wird noch geschnitten.</translation>
    </message>
    <message>
        <source>The cut would skim the liver here: turn it until you look onto its surface.</source>
        <translation>Der Schnitt würde die Leber hier nur streifen: Drehen Sie sie, bis Sie auf ihre Oberfläche blicken.</translation>
    </message>
    <message>
        <source>The line left the liver: the cut ends at its edge.</source>
        <translation>Die Linie hat die Leber verlassen: Der Schnitt endet an ihrem Rand.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FromMeasurements</name>
    <message>
        <source>Straight from measurements</source>
        <translation>Direkt aus Messwerten</translation>
    </message>
    <message>
        <source>The liver lifted at segment VI by what was measured of the tissue, without a law.</source>
        <translation>Die Leber am Segment VI gehoben nach dem, was am Gewebe gemessen wurde, ohne Gesetz.</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Force of the retractor at segment VI</source>
        <translation>Kraft des Retraktors am Segment VI</translation>
    </message>
    <message>
        <source>Strain and stress...</source>
        <translation>Dehnung und Spannung...</translation>
    </message>
    <message>
        <source>A table with the columns strain and stress_kPa, or a material experiment; compression is negative</source>
        <translation>Eine Tabelle mit den Spalten strain und stress_kPa oder ein Materialexperiment; Druck ist negativ</translation>
    </message>
    <message>
        <source>Show it in 3D</source>
        <translation>In 3D zeigen</translation>
    </message>
    <message>
        <source>Measured strain and stress</source>
        <translation>Gemessene Dehnung und Spannung</translation>
    </message>
    <message>
        <source>Tables and experiments (*.csv *.json)</source>
        <translation>Tabellen und Experimente (*.csv *.json)</translation>
    </message>
    <message>
        <source>Retracting by %1</source>
        <translation>Retraktion nach %1</translation>
    </message>
    <message>
        <source>%1: %2 measurements, %3 N</source>
        <translation>%1: %2 Messwerte, %3 N</translation>
    </message>
    <message>
        <source>Lifted by up to %1 mm; by the model&apos;s stiffness %2 mm.</source>
        <translation>Gehoben um bis zu %1 mm; nach der Steifigkeit des Modells %2 mm.</translation>
    </message>
    <message>
        <source>Apart by %1 mm on average, %2 mm at most.</source>
        <translation>Im Mittel %1 mm auseinander, höchstens %2 mm.</translation>
    </message>
    <message>
        <source>Landmark %1: %2 mm apart, the most of all.</source>
        <translation>Landmarke %1: %2 mm auseinander, am weitesten von allen.</translation>
    </message>
    <message>
        <source>▲ %1 % of the liver is strained farther than was measured.</source>
        <translation>▲ %1 % der Leber sind weiter gedehnt, als gemessen wurde.</translation>
    </message>
    <message>
        <source>From the model&apos;s answer (mm)</source>
        <translation>Von der Antwort des Modells (mm)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FromVideo</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>What is chosen here stays</source>
        <translation>Was hier gewählt ist, bleibt</translation>
    </message>
    <message>
        <source>Make the sequence</source>
        <translation>Sequenz herstellen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stops, and leaves nothing behind</source>
        <translation>Hört auf und lässt nichts zurück</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Making a sequence from the video</source>
        <translation>Aus dem Video wird eine Sequenz</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was left behind.</source>
        <translation>Abgebrochen. Es blieb nichts zurück.</translation>
    </message>
    <message>
        <source>It is being computed</source>
        <translation>Es wird gerade berechnet</translation>
    </message>
    <message>
        <source>Makes clouds and tracks of the frames, and opens them</source>
        <translation>Macht aus den Bildern Punktwolken und Spuren und öffnet sie</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::GrowthControls</name>
    <message>
        <source>Earlier study...</source>
        <translation>Frühere Untersuchung...</translation>
    </message>
    <message>
        <source>The case of this patient&apos;s earlier study, with its segments: a folder NAME.glisson</source>
        <translation>Der Fall der früheren Untersuchung dieses Patienten mit seinen Segmenten: ein Ordner NAME.glisson</translation>
    </message>
    <message>
        <source>They are of one patient</source>
        <translation>Sie sind von einem Patienten</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segmentieren</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>kPa</source>
        <translation>kPa</translation>
    </message>
    <message>
        <source>ml without tumours, in the earlier study</source>
        <translation>ml ohne Tumoren, in der früheren Untersuchung</translation>
    </message>
    <message>
        <source>ml without tumours, in the open case</source>
        <translation>ml ohne Tumoren, im offenen Fall</translation>
    </message>
    <message>
        <source>Of what it was; ~: no more than such a volume may be off by</source>
        <translation>Von dem, was es war; ~: nicht mehr, als ein solches Volumen danebenliegen kann</translation>
    </message>
    <message>
        <source>Mean stiffness before and now</source>
        <translation>Mittlere Steifigkeit vorher und jetzt</translation>
    </message>
    <message>
        <source>Remnant of</source>
        <translation>Rest nach</translation>
    </message>
    <message>
        <source>no plan</source>
        <translation>kein Plan</translation>
    </message>
    <message>
        <source>Days between</source>
        <translation>Tage dazwischen</translation>
    </message>
    <message>
        <source>0: by the dates of the images. To be typed where these have none</source>
        <translation>0: nach den Daten der Bilder. Einzugeben, wo diese keine haben</translation>
    </message>
    <message>
        <source>Standard volume</source>
        <translation>Standardvolumen</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>The liver&apos;s volume estimated from body size, of which the per cent are in both studies: -794.41 + 1267.28 × body surface in m² (Vauthey et al. 2002). 0: of each study&apos;s own liver</source>
        <translation>Das aus der Körpergröße geschätzte Lebervolumen, von dem die Prozente in beiden Untersuchungen sind: -794.41 + 1267.28 × Körperoberfläche in m² (Vauthey et al. 2002). 0: von der Leber der jeweiligen Untersuchung</translation>
    </message>
    <message>
        <source>The case of the earlier study</source>
        <translation>Der Fall der früheren Untersuchung</translation>
    </message>
    <message>
        <source>Comparing...</source>
        <translation>Wird verglichen...</translation>
    </message>
    <message>
        <source>Remnant</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>%1 % of the liver</source>
        <translation>%1 % der Leber</translation>
    </message>
    <message>
        <source>%1 % and %2 % of it were measured.</source>
        <translation>%1 % und %2 % davon wurden gemessen.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::GuidePage</name>
    <message>
        <source>Guide</source>
        <translation>Führen</translation>
    </message>
    <message>
        <source>See on a laparoscope&apos;s frames where tumours and vessels lie, and how far to trust it.</source>
        <translation>Auf den Bildern eines Laparoskops sehen, wo Tumoren und Gefäße liegen und wie weit dem zu trauen ist.</translation>
    </message>
    <message>
        <source>The liver in space, with what was seen of it</source>
        <translation>Die Leber im Raum, mit dem, was von ihr gesehen wurde</translation>
    </message>
    <message>
        <source>Open another...</source>
        <translation>Andere öffnen …</translation>
    </message>
    <message>
        <source>Another sequence.json in place of this one</source>
        <translation>Eine andere sequence.json anstelle dieser</translation>
    </message>
    <message>
        <source>Opening the sequence</source>
        <translation>Die Sequenz wird geöffnet</translation>
    </message>
    <message>
        <source>Making an example sequence</source>
        <translation>Eine Beispielsequenz wird erstellt</translation>
    </message>
    <message>
        <source>Placing the liver</source>
        <translation>Leber wird eingepasst</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULIERT</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>dashed: may be off by more than %1 mm</source>
        <translation>gestrichelt: vielleicht mehr als %1 mm daneben</translation>
    </message>
    <message>
        <source>not placed</source>
        <translation>nicht eingepasst</translation>
    </message>
    <message>
        <source>Writing the video</source>
        <translation>Video wird geschrieben</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Open a sequence</source>
        <translation>Eine Sequenz öffnen</translation>
    </message>
    <message>
        <source>Sequences (*.json)</source>
        <translation>Sequenzen (*.json)</translation>
    </message>
    <message>
        <source>Save a video of the frames</source>
        <translation>Video der Bilder speichern</translation>
    </message>
    <message>
        <source>Movies (*.mp4);;Folder of pictures (*)</source>
        <translation>Filme (*.mp4);;Ordner mit Bildern (*)</translation>
    </message>
    <message>
        <source>do not trust here</source>
        <translation>hier nicht trauen</translation>
    </message>
    <message>
        <source>%1: do not trust, ±%2 mm</source>
        <translation>%1: nicht trauen, ±%2 mm</translation>
    </message>
    <message>
        <source>%1 ±%2 mm, %3 mm deep</source>
        <translation>%1 ±%2 mm, %3 mm tief</translation>
    </message>
    <message>
        <source>%1 ±%2 mm</source>
        <translation>%1 ±%2 mm</translation>
    </message>
    <message>
        <source>The sequence names no camera, so that nothing can be drawn over the video.</source>
        <translation>Die Sequenz nennt keine Kamera, sodass über dem Video nichts gezeichnet werden kann.</translation>
    </message>
    <message>
        <source>By hand: nothing is known of the error yet. When it lies about right, press &quot;Refine&quot;.</source>
        <translation>Von Hand: Über den Fehler ist noch nichts bekannt. Wenn sie etwa richtig liegt, drücken Sie „Verfeinern“.</translation>
    </message>
    <message>
        <source>Not placed yet: it is being computed.</source>
        <translation>Noch nicht eingepasst: wird gerade berechnet.</translation>
    </message>
    <message>
        <source>Not placed yet: press &quot;Place the liver&quot;.</source>
        <translation>Noch nicht eingepasst: Drücken Sie „Leber einpassen“.</translation>
    </message>
    <message>
        <source>Place it by hand, then press &quot;Refine&quot;.</source>
        <translation>Passen Sie sie von Hand ein, und drücken Sie dann „Verfeinern“.</translation>
    </message>
    <message>
        <source>All outlines lie within %1 mm of the truth, 90 times of 100.</source>
        <translation>Alle Umrisse liegen in 90 von 100 Fällen höchstens %1 mm neben der Wahrheit.</translation>
    </message>
    <message>
        <source>Trust no outline of this frame to %1 mm.</source>
        <translation>Trauen Sie auf %1 mm genau keinem Umriss dieses Bildes.</translation>
    </message>
    <message>
        <source>Not to be trusted everywhere to %1 mm: %2.</source>
        <translation>Nicht überall auf %1 mm genau: %2.</translation>
    </message>
    <message>
        <source>%1 % of the liver&apos;s surface is seen; it is deformed by %2 mm.</source>
        <translation>%1 % der Leberoberfläche sind zu sehen; sie ist um %2 mm verformt.</translation>
    </message>
    <message>
        <source>One moment...</source>
        <translation>Einen Augenblick …</translation>
    </message>
    <message>
        <source>%1: %2 frames</source>
        <translation>%1: %2 Bilder</translation>
    </message>
    <message>
        <source>%1: placed in %2 of %3 frames</source>
        <translation>%1: in %2 von %3 Bildern eingepasst</translation>
    </message>
    <message>
        <source>Frame %1 with outlines</source>
        <translation>Bild %1 mit Umrissen</translation>
    </message>
    <message>
        <source>From a video...</source>
        <translation>Aus einem Video …</translation>
    </message>
    <message>
        <source>Two videos, or one that shows both eyes, become a sequence</source>
        <translation>Zwei Videos, oder eines mit beiden Augen, werden zu einer Sequenz</translation>
    </message>
    <message>
        <source>Nothing was seen of the surface there: an instrument, or a gap. Click beside it.</source>
        <translation>Dort wurde nichts von der Oberfläche gesehen: ein Instrument oder eine Lücke. Klicken Sie daneben.</translation>
    </message>
    <message>
        <source>Click along a line here, and along the same line on the model beside it.</source>
        <translation>Klicken Sie hier eine Linie entlang, und dieselbe Linie entlang am Modell daneben.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::GuidePanel</name>
    <message>
        <source>The liver on the frames</source>
        <translation>Die Leber auf den Bildern</translation>
    </message>
    <message>
        <source>Place the liver</source>
        <translation>Leber einpassen</translation>
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
        <source>Stops here; frames that are placed already stay</source>
        <translation>Hört hier auf; was schon eingepasst ist, bleibt</translation>
    </message>
    <message>
        <source>Place by hand</source>
        <translation>Von Hand einpassen</translation>
    </message>
    <message>
        <source>Lay the liver over the frame yourself, where it is not found or found wrong</source>
        <translation>Die Leber selbst über das Bild legen, wo sie nicht oder falsch gefunden wird</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Drag: move. Right drag or Shift: turn. Wheel: nearer, farther. Ctrl and wheel: turn in the picture. Arrow keys, + and - do the same in steps.</source>
        <translation>Ziehen: verschieben. Rechts ziehen oder Umschalt: drehen. Rad: näher, ferner. Strg und Rad: im Bild drehen. Pfeiltasten, + und - tun dasselbe in Schritten.</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>Shows or hides what is drawn over the frame (O)</source>
        <translation>Zeigt oder verbirgt, was über dem Bild gezeichnet ist (O)</translation>
    </message>
    <message>
        <source>Opacity of the outlines</source>
        <translation>Deckkraft der Umrisse</translation>
    </message>
    <message>
        <source>How strong the outlines stand on the frame</source>
        <translation>Wie kräftig die Umrisse auf dem Bild stehen</translation>
    </message>
    <message>
        <source>Trusted up to an error of</source>
        <translation>Verlässlich bis zu einem Fehler von</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Outlines are dashed where 90 % of such places would be off by more than %1 mm</source>
        <translation>Gestrichelt ist, wo es für 90 % solcher Stellen mehr als %1 mm braucht</translation>
    </message>
    <message>
        <source>It is being computed</source>
        <translation>Es wird gerade berechnet</translation>
    </message>
    <message>
        <source>The sequence names no camera, so that nothing can be drawn over the video.</source>
        <translation>Die Sequenz nennt keine Kamera, sodass über dem Video nichts gezeichnet werden kann.</translation>
    </message>
    <message>
        <source>Finds where the liver lies in the first frame, without a guess or by the lines that are marked, and follows it from frame to frame</source>
        <translation>Findet ohne Vorgabe oder nach den markierten Linien, wo die Leber im ersten Bild liegt, und folgt ihr von Bild zu Bild</translation>
    </message>
    <message>
        <source>Place the liver by hand first</source>
        <translation>Zuerst die Leber von Hand einpassen</translation>
    </message>
    <message>
        <source>Fits the liver from where you laid it, and follows it from there</source>
        <translation>Passt die Leber von dort an, wo Sie sie hingelegt haben, und folgt ihr von da an</translation>
    </message>
    <message>
        <source>Save a video...</source>
        <translation>Video speichern …</translation>
    </message>
    <message>
        <source>Place the liver first</source>
        <translation>Zuerst die Leber einpassen</translation>
    </message>
    <message>
        <source>All frames with their outlines as they are shown now, MP4 or pictures</source>
        <translation>Alle Bilder mit ihren Umrissen, wie sie jetzt gezeigt werden, MP4 oder Bilder</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::GuideWelcome</name>
    <message>
        <source>Where is the tumour in this picture?</source>
        <translation>Wo liegt der Tumor in diesem Bild?</translation>
    </message>
    <message>
        <source>Open a sequence...</source>
        <translation>Eine Sequenz öffnen …</translation>
    </message>
    <message>
        <source>Open the example</source>
        <translation>Beispiel öffnen</translation>
    </message>
    <message>
        <source>A sequence.json with its clouds, tracks and pictures beside it</source>
        <translation>Eine sequence.json mit ihren Punktwolken, Spuren und Bildern daneben</translation>
    </message>
    <message>
        <source>40 simulated frames, made in a few seconds the first time; 7 MB</source>
        <translation>40 simulierte Bilder, beim ersten Mal in wenigen Sekunden erstellt; 7 MB</translation>
    </message>
    <message>
        <source>The liver of the open case is placed on a laparoscope&apos;s frames and follows them; its tumours and vessels are drawn where they are, with how far they may be off. Begin with the video of a stereo laparoscope and its calibration, or pictures of a board; or open a sequence that was made of one. The example is simulated and shows the demo patient&apos;s liver.</source>
        <translation>Die Leber des offenen Falls wird in die Bilder eines Laparoskops eingepasst und folgt ihnen; Tumoren und Gefäße werden gezeichnet, wo sie sind, und wie weit sie daneben liegen können. Beginnen Sie mit dem Video eines Stereolaparoskops und seiner Kalibrierung oder Bildern einer Tafel; oder öffnen Sie eine Sequenz, die daraus gemacht wurde. Das Beispiel ist simuliert und zeigt die Leber der Demo-Person.</translation>
    </message>
    <message>
        <source>From a video...</source>
        <translation>Aus einem Video …</translation>
    </message>
    <message>
        <source>Two videos, or one that shows both eyes, become a sequence</source>
        <translation>Zwei Videos, oder eines mit beiden Augen, werden zu einer Sequenz</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::KeptOrders</name>
    <message>
        <source>Comparing orders of steps</source>
        <translation>Schrittfolgen werden verglichen</translation>
    </message>
    <message>
        <source>Order %1</source>
        <translation>Folge %1</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Folge</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Name of the order</source>
        <translation>Name der Schrittfolge</translation>
    </message>
    <message>
        <source>Keep these steps</source>
        <translation>Diese Schritte behalten</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Runs each order again from the liver at rest; the report shows what comes of it</source>
        <translation>Führt jede Folge noch einmal aus, von der ruhenden Leber an; der Bericht zeigt, was dabei herauskommt</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Takes the order that is marked out of the case</source>
        <translation>Nimmt die markierte Schrittfolge aus dem Fall</translation>
    </message>
    <message>
        <source>Keeps all that the tools did, and the cut, in this order</source>
        <translation>Behält alles, was die Instrumente taten, und den Schnitt, in dieser Reihenfolge</translation>
    </message>
    <message>
        <source>Kept since: compare again.</source>
        <translation>Seither kam eine dazu: noch einmal vergleichen.</translation>
    </message>
    <message>
        <source>Steps that could not be carried out, or are not to be used: %1</source>
        <translation>Nicht ausführbare oder nicht zu gebrauchende Schritte: %1</translation>
    </message>
    <message>
        <source>How far the landmark goes that moves most; 5 mm or more is marked !</source>
        <translation>Wie weit die Landmarke geht, die sich am meisten bewegt; ab 5 mm mit ! gekennzeichnet</translation>
    </message>
    <message>
        <source>The largest force of any one tool</source>
        <translation>Die größte Kraft eines einzelnen Instruments</translation>
    </message>
    <message>
        <source>The largest strain</source>
        <translation>Die größte Dehnung</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Steps are kept of rigid tools and of large deformations, by finite elements</source>
        <translation>Behalten werden Schritte starrer Instrumente und großer Verformungen, mit finiten Elementen</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LabelNamesDialog</name>
    <message>
        <source>What the labels are</source>
        <translation>Was die Labels sind</translation>
    </message>
    <message>
        <source>%1 does not say what its values are. Choose a structure for each that you want.</source>
        <translation>%1 sagt nicht, was seine Werte sind. Wählen Sie für jeden, den Sie wollen, eine Struktur.</translation>
    </message>
    <message>
        <source>%1: %2 ml</source>
        <translation>%1: %2 ml</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Weglassen</translation>
    </message>
    <message>
        <source>Take them</source>
        <translation>Übernehmen</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LandmarkTable</name>
    <message>
        <source>Landmark</source>
        <translation>Landmarke</translation>
    </message>
    <message>
        <source>Moves
mm</source>
        <translation>Weg
mm</translation>
    </message>
    <message>
        <source>Atlas off
mm</source>
        <translation>Atlas irrt
mm</translation>
    </message>
    <message>
        <source>From 5 mm</source>
        <translation>Ab 5 mm</translation>
    </message>
    <message>
        <source>How far from there the atlas&apos;s stiffness puts it</source>
        <translation>Wie weit entfernt davon die Steifigkeit des Atlas sie platziert</translation>
    </message>
    <message>
        <source>5 mm and more matters to a surgeon</source>
        <translation>5 mm und mehr sind für Chirurgen von Bedeutung</translation>
    </message>
    <message>
        <source>▲ Atlas off</source>
        <translation>▲ Atlas irrt</translation>
    </message>
    <message>
        <source>● Moves</source>
        <translation>● Bewegt sich</translation>
    </message>
    <message>
        <source>How far the landmark moves from where the scan shows it</source>
        <translation>Wie weit sich die Landmarke von dort bewegt, wo die Aufnahme sie zeigt</translation>
    </message>
    <message>
        <source>%1: set by hand. A double click renames it.</source>
        <translation>%1: von Hand gesetzt. Ein Doppelklick benennt sie um.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LanguageMenu</name>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>System language</source>
        <translation>Sprache des Systems</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LinePanel</name>
    <message>
        <source>Mark a ridge or a ligament on the frame and on the model: where the shape alone does not tell how the liver lies, the line does</source>
        <translation>Eine Kante oder ein Band auf dem Bild und am Modell markieren: Wo die Form allein nicht sagt, wie die Leber liegt, sagt es die Linie</translation>
    </message>
    <message>
        <source>Mark lines</source>
        <translation>Linien markieren</translation>
    </message>
    <message>
        <source>Falciform ligament</source>
        <translation>Ligamentum falciforme</translation>
    </message>
    <message>
        <source>Lower edge</source>
        <translation>Unterer Rand</translation>
    </message>
    <message>
        <source>Gall bladder&apos;s border</source>
        <translation>Rand der Gallenblase</translation>
    </message>
    <message>
        <source>Another line</source>
        <translation>Andere Linie</translation>
    </message>
    <message>
        <source>The line that is marked</source>
        <translation>Die Linie, die markiert wird</translation>
    </message>
    <message>
        <source>Which line the next clicks are of</source>
        <translation>Zu welcher Linie die nächsten Klicks gehören</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Takes this line away, from the model and from all frames</source>
        <translation>Nimmt diese Linie weg, vom Modell und von allen Bildern</translation>
    </message>
    <message>
        <source>Places on this frame: %1, on the model: %2.</source>
        <translation>Stellen auf diesem Bild: %1, am Modell: %2.</translation>
    </message>
    <message>
        <source>It counts when the liver is placed.</source>
        <translation>Sie zählt, wenn die Leber eingepasst wird.</translation>
    </message>
    <message>
        <source>It counts from two on each.</source>
        <translation>Sie zählt ab zwei auf jeder Seite.</translation>
    </message>
    <message>
        <source>Click along the line on the frame, and along the same line on the model. The two need not begin or end at the same place. Undo takes a click back.</source>
        <translation>Klicken Sie die Linie entlang auf dem Bild, und dieselbe Linie entlang am Modell. Beide müssen nicht an derselben Stelle beginnen oder enden. Rückgängig nimmt einen Klick zurück.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LinkedViews</name>
    <message>
        <source>Transverse</source>
        <translation>Transversal</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Drag: turn. Shift+drag: shift. Wheel: zoom. Click: crosshair there.</source>
        <translation>Ziehen: Drehen. Umschalt+Ziehen: Verschieben. Rad: Zoom. Klick: Fadenkreuz dorthin.</translation>
    </message>
    <message>
        <source>Surgeon</source>
        <translation>Chirurg</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Look from here, everything in view</source>
        <translation>Von hier blicken, alles im Bild</translation>
    </message>
    <message>
        <source>Atlas</source>
        <translation>Atlas</translation>
    </message>
    <message>
        <source>Click: crosshair. Right drag: brightness and contrast. Wheel: next slice.
Ctrl+wheel: zoom. Shift+drag: shift. Ctrl+drag: turn. Knobs of the crosshair: tilt the other slices.</source>
        <translation>Klick: Fadenkreuz. Mit rechter Taste ziehen: Helligkeit und Kontrast. Rad: nächste Schicht.
Strg+Rad: Zoom. Umschalt+Ziehen: Verschieben. Strg+Ziehen: Drehen. Griffe am Fadenkreuz: die anderen Schichten kippen.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The scan itself as a soft backdrop: bones and bright vessels behind the organ</source>
        <translation>Die Aufnahme selbst als weicher Hintergrund: Knochen und helle Gefäße hinter dem Organ</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::MainWindow</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Opening the demo patient</source>
        <translation>Demopatient wird geöffnet</translation>
    </message>
    <message>
        <source>Glisson</source>
        <translation>Glisson</translation>
    </message>
    <message>
        <source>%1 - Glisson</source>
        <translation>%1 - Glisson</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open a case...</source>
        <translation>Fall ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open the &amp;demo patient</source>
        <translation>&amp;Demopatienten öffnen</translation>
    </message>
    <message>
        <source>&amp;Save the picture...</source>
        <translation>Bild &amp;speichern …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;About Glisson</source>
        <translation>&amp;Über Glisson</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>A defect in Glisson stopped this: %1</source>
        <translation>Ein Fehler in Glisson hat dies beendet: %1</translation>
    </message>
    <message>
        <source>Open a case (a folder NAME.glisson)</source>
        <translation>Fall öffnen (ein Ordner NAME.glisson)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>The picture could not be written to %1.</source>
        <translation>Das Bild konnte nicht nach %1 geschrieben werden.</translation>
    </message>
    <message>
        <source>About Glisson</source>
        <translation>Über Glisson</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Glisson %1&lt;/h3&gt;&lt;p&gt;Planning and reviewing liver surgery.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Not a medical device.&lt;/b&gt; Not for diagnosis or treatment.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Glisson %1&lt;/h3&gt;&lt;p&gt;Planung und Auswertung von Leberoperationen.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Kein Medizinprodukt.&lt;/b&gt; Nicht für Diagnose oder Behandlung.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder später.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Something else is still under way. Wait for it, or cancel it first.</source>
        <translation>Etwas anderes läuft noch. Warten Sie darauf, oder brechen Sie es zuerst ab.</translation>
    </message>
    <message>
        <source>Outlining the liver</source>
        <translation>Leber wird umrissen</translation>
    </message>
    <message>
        <source>Building the model</source>
        <translation>Modell wird erstellt</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Elastography &amp;waves...</source>
        <translation>Elastographie-&amp;Wellen …</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>&amp;Gehe zu</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Se&amp;ttings...</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>&amp;Keys...</source>
        <translation>&amp;Tasten …</translation>
    </message>
    <message>
        <source>&amp;Log and problems...</source>
        <translation>&amp;Protokoll und Probleme …</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>Forget them</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>&amp;Tour on the demo patient</source>
        <translation>&amp;Rundgang am Demopatienten</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Open &amp;images...</source>
        <translation>&amp;Bilder öffnen...</translation>
    </message>
    <message>
        <source>&amp;Add labels...</source>
        <translation>&amp;Labels hinzufügen...</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Export</translation>
    </message>
    <message>
        <source>&amp;Close the case</source>
        <translation>Fall s&amp;chließen</translation>
    </message>
    <message>
        <source>Open images: a folder, or a file of them</source>
        <translation>Bilder öffnen: ein Ordner oder eine Datei davon</translation>
    </message>
    <message>
        <source>Add labels</source>
        <translation>Labels hinzufügen</translation>
    </message>
    <message>
        <source>Label maps and DICOM SEG (*.nii *.nii.gz *.nrrd *.mha *.mhd *.nhdr *.dcm);;All files (*)</source>
        <translation>Labelkarten und DICOM SEG (*.nii *.nii.gz *.nrrd *.mha *.mhd *.nhdr *.dcm);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 is still under way. If you close now, it is given up, and the case stays as it was.</source>
        <translation>%1 läuft noch. Wenn Sie jetzt schließen, wird das aufgegeben, und der Fall bleibt, wie er war.</translation>
    </message>
    <message>
        <source>Keep working</source>
        <translation>Weiterarbeiten</translation>
    </message>
    <message>
        <source>Give it up and close</source>
        <translation>Aufgeben und schließen</translation>
    </message>
    <message>
        <source>&amp;Diary of the case...</source>
        <translation>&amp;Tagebuch des Falls...</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ManualWindow</name>
    <message>
        <source>Manual - Glisson</source>
        <translation>Handbuch - Glisson</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Handbuch durchsuchen</translation>
    </message>
    <message>
        <source>Words to search for</source>
        <translation>Suchwörter</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Seiten des Handbuchs</translation>
    </message>
    <message>
        <source>The page</source>
        <translation>Die Seite</translation>
    </message>
    <message>
        <source>The manual was not found among the files that ship with Glisson.</source>
        <translation>Das Handbuch wurde unter den mit Glisson gelieferten Dateien nicht gefunden.</translation>
    </message>
    <message>
        <source>No page holds these words.</source>
        <translation>Keine Seite enthält diese Wörter.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::MeasureList</name>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Volume: %1</source>
        <translation>Volumen: %1</translation>
    </message>
    <message>
        <source>Takes this measurement away</source>
        <translation>Nimmt diese Messung weg</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ModelPanel</name>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Bring it up to date</source>
        <translation>Auf den neuesten Stand bringen</translation>
    </message>
    <message>
        <source>Cells, stiffness and supports of the liver, and building them anew.</source>
        <translation>Zellen, Steifigkeit und Lagerung der Leber, und wie sie neu erstellt werden.</translation>
    </message>
    <message>
        <source>Needs an outline of the liver: make it in Segment.</source>
        <translation>Braucht einen Umriss der Leber: Machen Sie ihn unter Segmentieren.</translation>
    </message>
    <message>
        <source>The 3D view shows</source>
        <translation>Die 3D-Ansicht zeigt</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>The patient</source>
        <translation>Den Patienten</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>E-Modul</translation>
    </message>
    <message>
        <source>From MR elastography</source>
        <translation>Aus der MR-Elastographie</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation> kPa</translation>
    </message>
    <message>
        <source>Young&apos;s modulus, about three times the shear modulus</source>
        <translation>Elastizitätsmodul, etwa das Dreifache des Schubmoduls</translation>
    </message>
    <message>
        <source>Give it this stiffness</source>
        <translation>Diese Steifigkeit geben</translation>
    </message>
    <message>
        <source>Elastography waves...</source>
        <translation>Elastographie-Wellen …</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Erstellen</translation>
    </message>
    <message>
        <source> cells</source>
        <translation> Zellen</translation>
    </message>
    <message>
        <source>Wanted number of cells: more are finer and slower. 20 000 answer at once.</source>
        <translation>Gewünschte Zahl der Zellen: mehr sind feiner und langsamer. 20 000 antworten sofort.</translation>
    </message>
    <message>
        <source>Building the model</source>
        <translation>Modell wird erstellt</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Gehalten</translation>
    </message>
    <message>
        <source>On springs</source>
        <translation>Auf Federn</translation>
    </message>
    <message>
        <source>Young&apos;s modulus (kPa)</source>
        <translation>Elastizitätsmodul (kPa)</translation>
    </message>
    <message>
        <source>Needs a case: open one, or the demo patient.</source>
        <translation>Braucht einen Fall: Öffnen Sie einen, oder den Demopatienten.</translation>
    </message>
    <message>
        <source>There is no model yet. Build it from the outline.</source>
        <translation>Es gibt noch kein Modell. Erstellen Sie es aus dem Umriss.</translation>
    </message>
    <message>
        <source>✓ The model is up to date.</source>
        <translation>✓ Das Modell ist auf dem neuesten Stand.</translation>
    </message>
    <message>
        <source>▲ A file of the model is gone.</source>
        <translation>▲ Eine Datei des Modells fehlt.</translation>
    </message>
    <message>
        <source>▲ Another program has changed a file of the model.</source>
        <translation>▲ Ein anderes Programm hat eine Datei des Modells geändert.</translation>
    </message>
    <message>
        <source>▲ The model is out of date.</source>
        <translation>▲ Das Modell ist veraltet.</translation>
    </message>
    <message>
        <source>▲ Out of date: %1 changed since it was built.</source>
        <translation>▲ Veraltet: %1 hat sich geändert, seit es erstellt wurde.</translation>
    </message>
    <message>
        <source>Build it anew</source>
        <translation>Neu erstellen</translation>
    </message>
    <message>
        <source>Build the model</source>
        <translation>Modell erstellen</translation>
    </message>
    <message>
        <source>This case has no stiffness map: import one, or invert its waves</source>
        <translation>Dieser Fall hat keine Steifigkeitskarte: Importieren Sie eine, oder invertieren Sie seine Wellen</translation>
    </message>
    <message>
        <source>Keeps the cells and gives each this stiffness</source>
        <translation>Behält die Zellen und gibt jeder diese Steifigkeit</translation>
    </message>
    <message>
        <source>Needs cells: build the model first</source>
        <translation>Braucht Zellen: Erstellen Sie zuerst das Modell</translation>
    </message>
    <message>
        <source>Makes the cells anew and gives them the stiffness chosen above</source>
        <translation>Macht die Zellen neu und gibt ihnen die oben gewählte Steifigkeit</translation>
    </message>
    <message>
        <source>See the waves and invert them</source>
        <translation>Die Wellen ansehen und invertieren</translation>
    </message>
    <message>
        <source>This case has no raw waves</source>
        <translation>Dieser Fall hat keine Rohwellen</translation>
    </message>
    <message>
        <source>Assumed from the liver&apos;s shape: the bare area at the vena cava is held, the dome below the diaphragm rests on springs of 1.1 kPa/mm.</source>
        <translation>Aus der Form der Leber angenommen: Die Area nuda an der Hohlvene wird gehalten, die Kuppel unter dem Zwerchfell ruht auf Federn von 1.1 kPa/mm.</translation>
    </message>
    <message>
        <source>%1 cells, %2 points</source>
        <translation>%1 Zellen, %2 Punkte</translation>
    </message>
    <message>
        <source>Smallest dihedral angle %1°</source>
        <translation>Kleinster Flächenwinkel %1°</translation>
    </message>
    <message>
        <source>smallest dihedral angle of a cell, °</source>
        <translation>kleinster Flächenwinkel einer Zelle, °</translation>
    </message>
    <message>
        <source>%1 kPa on average, sd %2</source>
        <translation>%1 kPa im Mittel, Standardabweichung %2</translation>
    </message>
    <message>
        <source>%1 % of the cells without data of their own, filled from inside</source>
        <translation>%1 % der Zellen ohne eigene Daten, von innen her aufgefüllt</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of a cell, kPa</source>
        <translation>Elastizitätsmodul einer Zelle, kPa</translation>
    </message>
    <message>
        <source>Assumed: the atlas&apos;s 2.1 kPa in shear</source>
        <translation>Angenommen: die 2.1 kPa (Schub) des Atlas</translation>
    </message>
    <message>
        <source>Assumed: the atlas&apos;s 2.6 kPa in shear</source>
        <translation>Angenommen: die 2.6 kPa (Schub) des Atlas</translation>
    </message>
    <message>
        <source>Assumed: one value for all cells</source>
        <translation>Angenommen: ein Wert für alle Zellen</translation>
    </message>
    <message>
        <source>%1 ml outlined; the cells hold %2 % of it</source>
        <translation>%1 ml umrissen; die Zellen füllen %2 % davon</translation>
    </message>
    <message>
        <source>Assumed: %1 kPa for all cells</source>
        <translation>Angenommen: %1 kPa für alle Zellen</translation>
    </message>
    <message>
        <source>Attachments</source>
        <translation>Aufhängung</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::MovieMaker</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>not at rest: landmarks within %1 mm</source>
        <translation>nicht in Ruhe: Landmarken auf %1 mm</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::NextStepBox</name>
    <message>
        <source>Next: put the crosshair inside the liver, away from large vessels.</source>
        <translation>Als Nächstes: Setzen Sie das Fadenkreuz in die Leber, fern von großen Gefäßen.</translation>
    </message>
    <message>
        <source>Next: build the model of the liver from its outline and stiffness.</source>
        <translation>Als Nächstes: Erstellen Sie das Modell der Leber aus ihrem Umriss und ihrer Steifigkeit.</translation>
    </message>
    <message>
        <source>Outline the liver from here</source>
        <translation>Leber von hier aus umreißen</translation>
    </message>
    <message>
        <source>Build the model</source>
        <translation>Modell erstellen</translation>
    </message>
    <message>
        <source>Its elastography has not been inverted: until then the stiffness is assumed.</source>
        <translation>Seine Elastographie ist noch nicht ausgewertet: bis dahin ist die Steifigkeit angenommen.</translation>
    </message>
    <message>
        <source>Elastography waves...</source>
        <translation>Elastographie-Wellen …</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::Notices</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::NumberBox</name>
    <message>
        <source>At most %1.</source>
        <translation>Höchstens %1.</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <translation>Mindestens %1.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PathRow</name>
    <message>
        <source>Choose...</source>
        <translation>Wählen...</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>Ordner (*)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PatientViews</name>
    <message>
        <source>Displacement (mm)</source>
        <translation>Verschiebung (mm)</translation>
    </message>
    <message>
        <source>Red: one stiffness from the atlas</source>
        <translation>Rot: eine Steifigkeit aus dem Atlas</translation>
    </message>
    <message>
        <source>Blue: the patient&apos;s own stiffness</source>
        <translation>Blau: die eigene Steifigkeit des Patienten</translation>
    </message>
    <message>
        <source>Purple: both agree</source>
        <translation>Violett: beide stimmen überein</translation>
    </message>
    <message>
        <source>Shear stiffness (kPa)</source>
        <translation>Schersteifigkeit (kPa)</translation>
    </message>
    <message>
        <source>%1  %2 mm</source>
        <translation>%1  %2 mm</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>The patient&apos;s own stiffness</source>
        <translation>Die eigene Steifigkeit des Patienten</translation>
    </message>
    <message>
        <source>One stiffness from the atlas</source>
        <translation>Eine Steifigkeit aus dem Atlas</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PlanByAnatomy</name>
    <message>
        <source>Segments and tumours</source>
        <translation>Segmente und Tumoren</translation>
    </message>
    <message>
        <source>Find segments</source>
        <translation>Segmente bestimmen</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>Stays, ml</source>
        <translation>Bleibt, ml</translation>
    </message>
    <message>
        <source>kPa</source>
        <translation>kPa</translation>
    </message>
    <message>
        <source>Mean stiffness (Young&apos;s modulus) of the tissue that was measured; faint under half of it</source>
        <translation>Mittlere Steifigkeit (Elastizitätsmodul) des gemessenen Gewebes; blass unter der Hälfte</translation>
    </message>
    <message>
        <source>Show segments</source>
        <translation>Segmente zeigen</translation>
    </message>
    <message>
        <source>Take these segments</source>
        <translation>Diese Segmente nehmen</translation>
    </message>
    <message>
        <source>Removes the segments that are ticked</source>
        <translation>Entfernt die angehakten Segmente</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Around this tumour</source>
        <translation>Um diesen Tumor</translation>
    </message>
    <message>
        <source>Removes the tumour with all tissue up to this margin</source>
        <translation>Entfernt den Tumor mit allem Gewebe bis zu diesem Abstand</translation>
    </message>
    <message>
        <source>Branches cut</source>
        <translation>Durchtrennte Äste</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ast</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Diameter where it is cut</source>
        <translation>Durchmesser, wo er durchtrennt wird</translation>
    </message>
    <message>
        <source>What of that stays in the patient without it</source>
        <translation>Was davon ohne ihn im Patienten bleibt</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Bleibt</translation>
    </message>
    <message>
        <source>Keeps it in the case under this name, beside the others</source>
        <translation>Hält ihn im Fall unter diesem Namen, neben den anderen</translation>
    </message>
    <message>
        <source>Finding vessels and segments</source>
        <translation>Gefäße und Segmente werden bestimmt</translation>
    </message>
    <message>
        <source>Looking at the liver&apos;s anatomy...</source>
        <translation>Die Anatomie der Leber wird angesehen …</translation>
    </message>
    <message>
        <source>By the liver&apos;s shape alone: it has no vessel trees.</source>
        <translation>Nach der Form der Leber allein: Gefäßbäume gibt es nicht.</translation>
    </message>
    <message>
        <source>%1 % of the segment was measured.</source>
        <translation>%1 % des Segments wurden gemessen.</translation>
    </message>
    <message>
        <source>%1 % of the liver without tumours stay.</source>
        <translation>%1 % der Leber ohne Tumoren bleiben.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 ml&lt;/b&gt; removed, &lt;b&gt;%2 ml&lt;/b&gt; stay: %3 % of the liver without tumours.</source>
        <translation>&lt;b&gt;%1 ml&lt;/b&gt; entfernt, &lt;b&gt;%2 ml&lt;/b&gt; bleiben: %3 % der Leber ohne Tumoren.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 ml&lt;/b&gt; of it stay alive, perfused and drained (%2 %); without inflow %3 ml, without outflow %4 ml.</source>
        <translation>&lt;b&gt;%1 ml&lt;/b&gt; davon bleiben am Leben, durchblutet und drainiert (%2 %); ohne Zufluss %3 ml, ohne Abfluss %4 ml.</translation>
    </message>
    <message>
        <source>Smallest margin: at least %1 mm.</source>
        <translation>Kleinster Abstand: mindestens %1 mm.</translation>
    </message>
    <message>
        <source>Smallest margin: %1 mm.</source>
        <translation>Kleinster Abstand: %1 mm.</translation>
    </message>
    <message>
        <source>▲ %1 stays in the patient.</source>
        <translation>▲ %1 bleibt im Patienten.</translation>
    </message>
    <message>
        <source>▲ %1 is cut through.</source>
        <translation>▲ %1 wird durchschnitten.</translation>
    </message>
    <message>
        <source>What stays has %1 kPa; %2 % of it was measured.</source>
        <translation>Was bleibt, hat %1 kPa; %2 % davon wurden gemessen.</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Entfernt</translation>
    </message>
    <message>
        <source>%1 is kept. Rehearse, Guide and the report follow it.</source>
        <translation>%1 ist behalten. Proben, Führen und der Bericht folgen ihm.</translation>
    </message>
    <message>
        <source>%1 is kept.</source>
        <translation>%1 ist behalten.</translation>
    </message>
    <message>
        <source>This patient is not kept in a case folder</source>
        <translation>Dieser Patient liegt in keinem Fallordner</translation>
    </message>
    <message>
        <source>Needs a cut through the liver</source>
        <translation>Braucht einen Schnitt durch die Leber</translation>
    </message>
    <message>
        <source>Keeps the cut on the liver held aside, for the report; the table is of plans at rest</source>
        <translation>Behält den Schnitt an der beiseitegehaltenen Leber für den Bericht; die Tabelle ist eine von Plänen in Ruhe</translation>
    </message>
    <message>
        <source>Keeps it in the case under this name, beside the others; Rehearse, Guide and the report then follow it</source>
        <translation>Behält ihn im Fall unter diesem Namen, neben den anderen; Proben, Führen und der Bericht folgen ihm dann</translation>
    </message>
    <message>
        <source>The cut unrolled flat</source>
        <translation>Der Schnitt, flach ausgerollt</translation>
    </message>
    <message>
        <source>%1 (%2 ml)</source>
        <translation>%1 (%2 ml)</translation>
    </message>
    <message>
        <source>%1 ml of what goes are ablated.</source>
        <translation>%1 ml von dem, was wegfällt, werden abladiert.</translation>
    </message>
    <message>
        <source>No tumour is outlined: the map shows the vessels alone.</source>
        <translation>Kein Tumor ist umrissen: Die Karte zeigt nur die Gefäße.</translation>
    </message>
    <message>
        <source>No tumour within %1 mm of the cut.</source>
        <translation>Kein Tumor näher als %1 mm am Schnitt.</translation>
    </message>
    <message>
        <source>▲ The cut goes through a tumour.</source>
        <translation>▲ Der Schnitt geht durch einen Tumor.</translation>
    </message>
    <message>
        <source>At the nearest the cut is %1 mm from a tumour.</source>
        <translation>Am nächsten kommt der Schnitt einem Tumor auf %1 mm.</translation>
    </message>
    <message>
        <source>Along this territory</source>
        <translation>Entlang dieses Gebiets</translation>
    </message>
    <message>
        <source>Removes all that this branch feeds or drains, with what grows from it. Proposed: the smallest portal territory that holds the tumour above</source>
        <translation>Entfernt alles, was dieser Ast versorgt oder entwässert, mit dem, was aus ihm wächst. Vorgeschlagen: das kleinste portale Gebiet, das den Tumor oben ganz enthält</translation>
    </message>
    <message>
        <source>Ablation</source>
        <translation>Ablation</translation>
    </message>
    <message>
        <source>%1 with %2 mm around it needs a zone %3 mm wide; %4 mm is the widest. Set several.</source>
        <translation>%1 mit %2 mm ringsum braucht eine %3 mm breite Zone; %4 mm ist die breiteste. Setzen Sie mehrere.</translation>
    </message>
    <message>
        <source>✕ gives it back</source>
        <translation>✕ gibt es zurück</translation>
    </message>
    <message>
        <source>Segments: %1</source>
        <translation>Segmente: %1</translation>
    </message>
    <message>
        <source>Territory: %1</source>
        <translation>Gebiet: %1</translation>
    </message>
    <message>
        <source>%1 with %2 mm around it</source>
        <translation>%1 mit %2 mm ringsum</translation>
    </message>
    <message>
        <source>Ablation, %1 × %2 mm</source>
        <translation>Ablation, %1 × %2 mm</translation>
    </message>
    <message>
        <source>Two stages</source>
        <translation>Zwei Schritte</translation>
    </message>
    <message>
        <source>Growth since an earlier study</source>
        <translation>Wachstum seit einer früheren Untersuchung</translation>
    </message>
    <message>
        <source>By the liver&apos;s shape and borders set by hand: it has no vessel trees.</source>
        <translation>Nach der Form der Leber und von Hand gesetzten Grenzen: Sie hat keine Gefäßbäume.</translation>
    </message>
    <message>
        <source>By the portal and hepatic veins where both are outlined, else by the liver&apos;s shape alone. Arteries and bile ducts that are outlined get trees too</source>
        <translation>Nach Pfortader und Lebervenen, wo beide umrissen sind, sonst nach der Form der Leber allein. Umrissene Arterien und Gallengänge bekommen auch Bäume</translation>
    </message>
    <message>
        <source>Beyond</source>
        <translation>Dahinter</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Bleibt</translation>
    </message>
    <message>
        <source>All tissue that it feeds or drains beyond the cut; of an artery or a bile duct its own length</source>
        <translation>Alles Gewebe, das er jenseits des Schnitts versorgt oder entwässert; bei einer Arterie oder einem Gallengang die eigene Länge</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PlanList</name>
    <message>
        <source>Plan %1</source>
        <translation>Plan %1</translation>
    </message>
    <message>
        <source>Plans</source>
        <translation>Pläne</translation>
    </message>
    <message>
        <source>as they were kept</source>
        <translation>wie sie behalten wurden</translation>
    </message>
    <message>
        <source>widest margin first</source>
        <translation>breitester Abstand zuerst</translation>
    </message>
    <message>
        <source>most tissue alive first</source>
        <translation>meistes lebendes Gewebe zuerst</translation>
    </message>
    <message>
        <source>least tissue cut off first</source>
        <translation>am wenigsten abgeschnitten zuerst</translation>
    </message>
    <message>
        <source>Plans that leave a tumour, or cut through one, come after those that do not</source>
        <translation>Pläne, die einen Tumor zurücklassen oder durchschneiden, kommen nach den anderen</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Bleibt</translation>
    </message>
    <message>
        <source>Alive</source>
        <translation>Lebend</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Äste</translation>
    </message>
    <message>
        <source>Of the liver without its tumours</source>
        <translation>Von der Leber ohne ihre Tumoren</translation>
    </message>
    <message>
        <source>What stays perfused and drained, of the same</source>
        <translation>Was durchblutet und drainiert bleibt, ebenso</translation>
    </message>
    <message>
        <source>Branches that are cut</source>
        <translation>Äste, die durchtrennt werden</translation>
    </message>
    <message>
        <source>A ring: another plan is no worse in margin, living tissue and tumours, and better in one.</source>
        <translation>Ein Ring: Ein anderer Plan ist in Abstand, lebendem Gewebe und Tumoren nicht schlechter und in einem besser.</translation>
    </message>
    <message>
        <source>Name of the plan</source>
        <translation>Name des Plans</translation>
    </message>
    <message>
        <source>Keep this plan</source>
        <translation>Diesen Plan behalten</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Keeps the plan that is marked a second time, to be changed</source>
        <translation>Behält den markierten Plan ein zweites Mal, um ihn zu ändern</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Takes the plan that is marked out of the case</source>
        <translation>Nimmt den markierten Plan aus dem Fall</translation>
    </message>
    <message>
        <source>Rehearse, Guide and the report follow this plan</source>
        <translation>Proben, Führen und der Bericht folgen diesem Plan</translation>
    </message>
    <message>
        <source>What it was made from has changed since; the figures are those of now.</source>
        <translation>Woraus er gemacht wurde, hat sich seither geändert; die Zahlen sind die von jetzt.</translation>
    </message>
    <message>
        <source>No worse in anything, and better in something: %1</source>
        <translation>In nichts schlechter und in etwas besser: %1</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PlanPlot</name>
    <message>
        <source>smallest margin, mm</source>
        <translation>kleinster Abstand, mm</translation>
    </message>
    <message>
        <source>stays alive, ml</source>
        <translation>bleibt lebend, ml</translation>
    </message>
    <message>
        <source>Plans by margin and by what stays alive</source>
        <translation>Pläne nach Abstand und nach dem, was lebend bleibt</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PlatformTable</name>
    <message>
        <source>Assumed: %1 %2 (%3)</source>
        <translation>Angenommen: %1 %2 (%3)</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>belt</source>
        <translation>Gürtel</translation>
    </message>
    <message>
        <source>back</source>
        <translation>Rücken</translation>
    </message>
    <message>
        <source>idle draw</source>
        <translation>Leerlauf</translation>
    </message>
    <message>
        <source>too hot idle</source>
        <translation>zu heiß im Leerlauf</translation>
    </message>
    <message>
        <source>too slow</source>
        <translation>zu langsam</translation>
    </message>
    <message>
        <source>slows itself down</source>
        <translation>drosselt sich</translation>
    </message>
    <message>
        <source>battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>too hot</source>
        <translation>zu heiß</translation>
    </message>
    <message>
        <source>✕ fails: %1</source>
        <translation>✕ reicht nicht: %1</translation>
    </message>
    <message>
        <source>heat</source>
        <translation>Wärme</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>✓ holds; next limit: %1</source>
        <translation>✓ hält; nächste Grenze: %1</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Worn on
the</source>
        <translation>Getragen
am</translation>
    </message>
    <message>
        <source>Draws idle
W</source>
        <translation>Leerlauf
W</translation>
    </message>
    <message>
        <source>Battery
allows W</source>
        <translation>Akku
erlaubt W</translation>
    </message>
    <message>
        <source>Left to
compute W</source>
        <translation>Rest zum
Rechnen W</translation>
    </message>
    <message>
        <source>Frames/s
at most</source>
        <translation>Bilder/s
höchstens</translation>
    </message>
    <message>
        <source>Lasts
h</source>
        <translation>Hält
h</translation>
    </message>
    <message>
        <source>Surface
°C</source>
        <translation>Oberfl.
°C</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Assumed
figures</source>
        <translation>Annahmen</translation>
    </message>
    <message>
        <source>What it takes from its battery when nothing is computed</source>
        <translation>Was es seinem Akku entnimmt, wenn nichts gerechnet wird</translation>
    </message>
    <message>
        <source>The largest constant power that its battery carries for the operation</source>
        <translation>Die größte konstante Leistung, die sein Akku über die Operation trägt</translation>
    </message>
    <message>
        <source>What the battery allows, less what idling takes</source>
        <translation>Was der Akku erlaubt, abzüglich des Leerlaufs</translation>
    </message>
    <message>
        <source>The frame rate that meets every constraint</source>
        <translation>Die Bildrate, die jede Bedingung erfüllt</translation>
    </message>
    <message>
        <source>On one charge, at the wanted frame rate or the fastest it computes</source>
        <translation>Mit einer Ladung, bei der gewünschten Bildrate oder der schnellsten, die es schafft</translation>
    </message>
    <message>
        <source>At the end of the operation</source>
        <translation>Am Ende der Operation</translation>
    </message>
    <message>
        <source>Figures that nobody measured; ≈ marks what rests on them</source>
        <translation>Werte, die niemand gemessen hat; ≈ kennzeichnet, was darauf beruht</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Sure to
hold %</source>
        <translation>Reicht
sicher %</translation>
    </message>
    <message>
        <source>In how many of 100 draws of its figures, off by as much as their sources may be, it holds</source>
        <translation>In wie vielen von 100 Ziehungen seiner Werte, so weit daneben, wie es ihre Quellen sein können, es reicht</translation>
    </message>
    <message>
        <source>In 80 of 100 draws it can do %1 to %2 frames/s</source>
        <translation>In 80 von 100 Ziehungen schafft es %1 bis %2 Bilder/s</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PlatformView</name>
    <message>
        <source>Volume and stiffness of %1</source>
        <translation>Volumen und Steifigkeit von %1</translation>
    </message>
    <message>
        <source>Volume of %1; its stiffness is not known</source>
        <translation>Volumen von %1; die Steifigkeit ist nicht bekannt</translation>
    </message>
    <message>
        <source>Stiffness of %1; its volume is not known</source>
        <translation>Steifigkeit von %1; das Volumen ist nicht bekannt</translation>
    </message>
    <message>
        <source>%1 has no outlined liver yet: type its volume</source>
        <translation>%1 hat noch keine umrissene Leber: Geben Sie ihr Volumen ein</translation>
    </message>
    <message>
        <source>The case</source>
        <translation>Der Fall</translation>
    </message>
    <message>
        <source>No case is open: type its figures</source>
        <translation>Kein Fall ist geöffnet: Geben Sie seine Werte ein</translation>
    </message>
    <message>
        <source> cm³</source>
        <translation> cm³</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation> kPa</translation>
    </message>
    <message>
        <source>Mean Young&apos;s modulus. Softer tissue moves farther under the same load, and what a coarse model misses of it grows alike.</source>
        <translation>Mittlerer Elastizitätsmodul. Weicheres Gewebe bewegt sich unter derselben Last weiter, und was einem groben Modell davon entgeht, wächst ebenso.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>E-Modul</translation>
    </message>
    <message>
        <source>What is wanted</source>
        <translation>Was gewünscht ist</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Duration of the operation</source>
        <translation>Dauer der Operation</translation>
    </message>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source> /s</source>
        <translation> /s</translation>
    </message>
    <message>
        <source>The room and the skin</source>
        <translation>Raum und Haut</translation>
    </message>
    <message>
        <source>Operating room</source>
        <translation>Operationssaal</translation>
    </message>
    <message>
        <source> °C</source>
        <translation> °C</translation>
    </message>
    <message>
        <source>Hottest surface to be worn</source>
        <translation>Heißeste tragbare Oberfläche</translation>
    </message>
    <message>
        <source>Add devices...</source>
        <translation>Geräte hinzufügen …</translation>
    </message>
    <message>
        <source>A table of your own, or what glisson-cli platform measure wrote</source>
        <translation>Eine eigene Tabelle oder was glisson-cli platform measure geschrieben hat</translation>
    </message>
    <message>
        <source>Surface temperature</source>
        <translation>Oberflächentemperatur</translation>
    </message>
    <message>
        <source>Frame rate that holds</source>
        <translation>Bildrate, die hält</translation>
    </message>
    <message>
        <source>Battery life</source>
        <translation>Akkulaufzeit</translation>
    </message>
    <message>
        <source>Mean power</source>
        <translation>Mittlere Leistung</translation>
    </message>
    <message>
        <source>Add devices</source>
        <translation>Geräte hinzufügen</translation>
    </message>
    <message>
        <source>Device tables (*.json)</source>
        <translation>Gerätetabellen (*.json)</translation>
    </message>
    <message>
        <source>%1 nodes of %2 mm³. A frame is %3 block products: %4 MB to move, %5 million operations.</source>
        <translation>%1 Knoten zu %2 mm³. Ein Bild sind %3 Blockprodukte: %4 MB zu bewegen, %5 Millionen Operationen.</translation>
    </message>
    <message>
        <source>None of these platforms holds.</source>
        <translation>Keines dieser Geräte hält.</translation>
    </message>
    <message>
        <source>Least obtrusive that holds, on the head: %1</source>
        <translation>Am wenigsten störend von denen, die halten, am Kopf: %1</translation>
    </message>
    <message>
        <source>Least obtrusive that holds, on the belt: %1</source>
        <translation>Am wenigsten störend von denen, die halten, am Gürtel: %1</translation>
    </message>
    <message>
        <source>Least obtrusive that holds, on the back: %1</source>
        <translation>Am wenigsten störend von denen, die halten, am Rücken: %1</translation>
    </message>
    <message>
        <source>Surface after %1 h at %2 frames/s (°C)</source>
        <translation>Oberfläche nach %1 h bei %2 Bildern/s (°C)</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Frames/s that hold for %1 h</source>
        <translation>Bilder/s, die %1 h halten</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Battery lasts at %1 frames/s (h)</source>
        <translation>Akku hält bei %1 Bildern/s (h)</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>Mean power at %1 frames/s (W)</source>
        <translation>Mittlere Leistung bei %1 Bildern/s (W)</translation>
    </message>
    <message>
        <source>%1 W: the battery</source>
        <translation>%1 W: der Akku</translation>
    </message>
    <message>
        <source>an operation of at most %1 h</source>
        <translation>eine Operation von höchstens %1 h</translation>
    </message>
    <message>
        <source>at most %1 frames/s</source>
        <translation>höchstens %1 Bilder/s</translation>
    </message>
    <message>
        <source>an accuracy of %1 mm</source>
        <translation>eine Genauigkeit von %1 mm</translation>
    </message>
    <message>
        <source>a battery of %1 Wh</source>
        <translation>ein Akku von %1 Wh</translation>
    </message>
    <message>
        <source>a heat sink of %1 °C/W</source>
        <translation>ein Kühlkörper von %1 °C/W</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>berechnet</translation>
    </message>
    <message>
        <source>dissertation</source>
        <translation>Dissertation</translation>
    </message>
    <message>
        <source>ASSUMED</source>
        <translation>ANGENOMMEN</translation>
    </message>
    <message>
        <source>Idle first: it draws %1 W of the %2 W that its battery allows over %3 h; it would last %4 h and reach %5 °C without computing anything.</source>
        <translation>Zuerst der Leerlauf: Es nimmt %1 W von den %2 W auf, die sein Akku über %3 h erlaubt; ohne zu rechnen hielte es %4 h und erreichte %5 °C.</translation>
    </message>
    <message>
        <source>Frames/s: %1 by its speed, %2 by its battery, %3 by its heat. A frame takes %4 J above idle; mean power %5 W.</source>
        <translation>Bilder/s: %1 nach Tempo, %2 nach Akku, %3 nach Wärme. Ein Bild braucht %4 J über dem Leerlauf; mittlere Leistung %5 W.</translation>
    </message>
    <message>
        <source>Why it fails:</source>
        <translation>Warum es nicht reicht:</translation>
    </message>
    <message>
        <source>No single figure would make it hold.</source>
        <translation>Kein einzelner Wert würde es halten lassen.</translation>
    </message>
    <message>
        <source>It would hold with one of:</source>
        <translation>Es hielte mit einem davon:</translation>
    </message>
    <message>
        <source>Where its figures come from:</source>
        <translation>Woher seine Werte stammen:</translation>
    </message>
    <message>
        <source>Volume of %1; its stiffness is assumed</source>
        <translation>Volumen von %1; die Steifigkeit ist angenommen</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Plattform</translation>
    </message>
    <message>
        <source>Find what can be worn for this case.</source>
        <translation>Finden, was sich für diesen Fall tragen lässt.</translation>
    </message>
    <message>
        <source>What is computed</source>
        <translation>Was berechnet wird</translation>
    </message>
    <message>
        <source>The dissertation&apos;s product</source>
        <translation>Das Produkt der Dissertation</translation>
    </message>
    <message>
        <source>A frame of it: %1 MB to move, %2 million operations.</source>
        <translation>Ein Bild davon: %1 MB zu bewegen, %2 Millionen Rechenschritte.</translation>
    </message>
    <message>
        <source>How sure that is: with its figures off by as much as their sources may be, 5 to 30 %, it holds in %1 of 100 draws, and in 80 of 100 it can do %2 to %3 frames/s.</source>
        <translation>Wie sicher das ist: Sind seine Werte so weit daneben, wie es ihre Quellen sein können, 5 bis 30 %, reicht es in %1 von 100 Ziehungen, und in 80 von 100 schafft es %2 bis %3 Bilder/s.</translation>
    </message>
    <message>
        <source>Rehearse: a live frame, small deformations</source>
        <translation>Proben: ein Bild, kleine Verformungen</translation>
    </message>
    <message>
        <source>Rehearse: a live frame, large deformations</source>
        <translation>Proben: ein Bild, große Verformungen</translation>
    </message>
    <message>
        <source>Rehearse: a step of the meshfree engine</source>
        <translation>Proben: ein Schritt des netzfreien Verfahrens</translation>
    </message>
    <message>
        <source>Guide: a frame</source>
        <translation>Führen: ein Bild</translation>
    </message>
    <message>
        <source>Match: a registration of 128 points</source>
        <translation>Zuordnen: eine Registrierung von 128 Punkten</translation>
    </message>
    <message>
        <source>Read a power recording...</source>
        <translation>Leistungsaufzeichnung lesen...</translation>
    </message>
    <message>
        <source>What an oscilloscope, a power analyser or a battery tester wrote of a platform: idle power and power under load</source>
        <translation>Was ein Oszilloskop, ein Leistungsmesser oder ein Akkutester von einer Plattform aufgezeichnet hat: Leistung im Leerlauf und unter Last</translation>
    </message>
    <message>
        <source>Read a power recording</source>
        <translation>Leistungsaufzeichnung lesen</translation>
    </message>
    <message>
        <source>Recordings (*.csv *.txt *.log *.tsv)</source>
        <translation>Aufzeichnungen (*.csv *.txt *.log *.tsv)</translation>
    </message>
    <message>
        <source>%1, as recorded</source>
        <translation>%1, wie aufgezeichnet</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ProbabilityBars</name>
    <message>
        <source>Something that is not in the catalogue</source>
        <translation>Etwas, das nicht im Katalog ist</translation>
    </message>
    <message>
        <source>Nothing is missing</source>
        <translation>Nichts fehlt</translation>
    </message>
    <message>
        <source>Probability of each explanation. Where the answer was known, in generated experiments, 98 of 100 that were given 90 % and more were right, and 7 of 10 given 60 to 80 %.</source>
        <translation>Wahrscheinlichkeit jeder Erklärung. Wo die Antwort bekannt war, in erzeugten Experimenten, waren von 100 mit 90 % und mehr 98 richtig, von 10 mit 60 bis 80 % sieben.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ReadingPanel</name>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>What the colours show</source>
        <translation>Was die Farben zeigen</translation>
    </message>
    <message>
        <source>Colours: SIRGn&apos;s correlation</source>
        <translation>Farben: Korrelation nach SIRGn</translation>
    </message>
    <message>
        <source>Colours: error of the landmarks (mm)</source>
        <translation>Farben: Fehler der Landmarken (mm)</translation>
    </message>
    <message>
        <source>Colours: doubt (mm)</source>
        <translation>Farben: Zweifel (mm)</translation>
    </message>
    <message>
        <source>Correlation: whether landmarks and warp move alike over time, 1 is best. Error: mean distance of a triangle&apos;s landmarks, as registered, from where they are on the model, mm. Doubt: motion that the registration leaves unexplained, mm, to be compared within one sequence.</source>
        <translation>Korrelation: ob sich Landmarken und Verformung im Lauf der Zeit gleich bewegen, 1 ist am besten. Fehler: mittlerer Abstand der registrierten Landmarken eines Dreiecks von ihrem Ort auf dem Modell, mm. Zweifel: Bewegung, die die Registrierung unerklärt lässt, mm, nur innerhalb einer Sequenz zu vergleichen.</translation>
    </message>
    <message>
        <source>Tolerance: rejected from</source>
        <translation>Toleranz: verworfen ab</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Triangles whose landmarks are off by this much or more, mm, are grey and hatched</source>
        <translation>Dreiecke, deren Landmarken um so viel oder mehr danebenliegen (mm), sind grau und schraffiert</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Sets the tolerance to %1 mm</source>
        <translation>Stellt die Toleranz auf %1 mm</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::RegisterPage</name>
    <message>
        <source>Register</source>
        <translation>Registrieren</translation>
    </message>
    <message>
        <source>See how good a registration of a video is, place by place.</source>
        <translation>Sehen, wie gut eine Registrierung eines Videos ist, Stelle für Stelle.</translation>
    </message>
    <message>
        <source>Opening the sequence</source>
        <translation>Die Sequenz wird geöffnet</translation>
    </message>
    <message>
        <source>Making an example sequence</source>
        <translation>Eine Beispielsequenz wird erstellt</translation>
    </message>
    <message>
        <source>Registering the video</source>
        <translation>Das Video wird registriert</translation>
    </message>
    <message>
        <source>Open another...</source>
        <translation>Andere öffnen …</translation>
    </message>
    <message>
        <source>Another sequence.json in place of this one</source>
        <translation>Eine andere sequence.json anstelle dieser</translation>
    </message>
    <message>
        <source>Open a sequence</source>
        <translation>Eine Sequenz öffnen</translation>
    </message>
    <message>
        <source>Sequences (*.json)</source>
        <translation>Sequenzen (*.json)</translation>
    </message>
    <message>
        <source>Click a triangle to see its history.</source>
        <translation>Klicken Sie ein Dreieck an, um seinen Verlauf zu sehen.</translation>
    </message>
    <message>
        <source>%1 mm in this frame</source>
        <translation>%1 mm in diesem Bild</translation>
    </message>
    <message>
        <source>not all its corners are seen in this frame</source>
        <translation>nicht alle Ecken sind in diesem Bild zu sehen</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>verworfen</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>%1, triangle %2: correlation %3; off by %4 mm on average, %5; %6</source>
        <translation>%1, Dreieck %2: Korrelation %3; im Mittel %4 mm daneben, %5; %6</translation>
    </message>
    <message>
        <source>%1: %2 frames, %3 landmarks</source>
        <translation>%1: %2 Bilder, %3 Landmarken</translation>
    </message>
    <message>
        <source>One moment...</source>
        <translation>Einen Augenblick …</translation>
    </message>
    <message>
        <source>Click a triangle to see its history; hover over it for its figures</source>
        <translation>Ein Dreieck anklicken, um seinen Verlauf zu sehen; darüberfahren für seine Zahlen</translation>
    </message>
    <message>
        <source>Not registered yet: press &quot;Register and judge&quot;.</source>
        <translation>Noch nicht registriert: „Registrieren und beurteilen“ drücken.</translation>
    </message>
    <message>
        <source>%1: %2 % of %3 triangles rejected at %4 mm</source>
        <translation>%1: %2 % von %3 Dreiecken bei %4 mm verworfen</translation>
    </message>
    <message>
        <source>The sequence names no camera, so that no mesh can be drawn over the video.</source>
        <translation>Die Sequenz nennt keine Kamera, darum lässt sich kein Netz über das Video zeichnen.</translation>
    </message>
    <message>
        <source>The sequence names no pictures; the mesh is drawn on black.</source>
        <translation>Die Sequenz nennt keine Bilder; das Netz wird auf Schwarz gezeichnet.</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Korrelation</translation>
    </message>
    <message>
        <source>Error
(mm)</source>
        <translation>Fehler
(mm)</translation>
    </message>
    <message>
        <source>Doubt
(mm)</source>
        <translation>Zweifel
(mm)</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>rejected: off by %1 mm or more</source>
        <translation>verworfen: %1 mm oder mehr daneben</translation>
    </message>
    <message>
        <source>the left edge</source>
        <translation>dem linken Rand</translation>
    </message>
    <message>
        <source>the right edge</source>
        <translation>dem rechten Rand</translation>
    </message>
    <message>
        <source>the upper edge</source>
        <translation>dem oberen Rand</translation>
    </message>
    <message>
        <source>the lower edge</source>
        <translation>dem unteren Rand</translation>
    </message>
    <message>
        <source>%1 is nowhere off by %2 mm or more.</source>
        <translation>%1 liegt nirgends um %2 mm oder mehr daneben.</translation>
    </message>
    <message>
        <source>Do not trust %1: on most of it landmarks are off by %2 mm or more.</source>
        <translation>%1 nicht trauen: auf dem größten Teil liegen Landmarken um %2 mm oder mehr daneben.</translation>
    </message>
    <message>
        <source>Of %1 do not trust single places: %2 % of it is off by %3 mm or more.</source>
        <translation>Bei %1 einzelnen Stellen nicht trauen: %2 % davon liegen um %3 mm oder mehr daneben.</translation>
    </message>
    <message>
        <source>Of %1 do not trust %2: landmarks are off by %3 mm or more there.</source>
        <translation>Bei %1 %2 nicht trauen: dort liegen Landmarken um %3 mm oder mehr daneben.</translation>
    </message>
    <message>
        <source>Neither %1 nor %2 is clearly better here.</source>
        <translation>Weder %1 noch %2 ist hier deutlich besser.</translation>
    </message>
    <message>
        <source>%1 is better here than %2.</source>
        <translation>%1 ist hier besser als %2.</translation>
    </message>
    <message>
        <source>From a video...</source>
        <translation>Aus einem Video …</translation>
    </message>
    <message>
        <source>Two videos, or one that shows both eyes, become a sequence</source>
        <translation>Zwei Videos, oder eines mit beiden Augen, werden zu einer Sequenz</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::RegisterWelcome</name>
    <message>
        <source>How good is a registration of a video?</source>
        <translation>Wie gut ist eine Registrierung eines Videos?</translation>
    </message>
    <message>
        <source>Open a sequence...</source>
        <translation>Eine Sequenz öffnen …</translation>
    </message>
    <message>
        <source>A sequence.json with its clouds, tracks and pictures beside it</source>
        <translation>Eine sequence.json mit ihren Punktwolken, Spuren und Bildern daneben</translation>
    </message>
    <message>
        <source>Make an example sequence</source>
        <translation>Beispielsequenz erstellen</translation>
    </message>
    <message>
        <source>Simulates 40 frames in a few seconds and opens them; 7 MB</source>
        <translation>Simuliert 40 Bilder in wenigen Sekunden und öffnet sie; 7 MB</translation>
    </message>
    <message>
        <source>Begin with the video of a stereo laparoscope and its calibration, or pictures of a board: a sequence is made of it, a cloud of points a frame and the tracks of landmarks. Or open a sequence that is there. Without a video, an example shows what it is about: the demo patient&apos;s liver, breathing and pressed by a tool, simulated.</source>
        <translation>Beginnen Sie mit dem Video eines Stereolaparoskops und seiner Kalibrierung oder Bildern einer Tafel: Daraus wird eine Sequenz, eine Punktwolke je Bild und die Spuren von Landmarken. Oder öffnen Sie eine Sequenz, die es schon gibt. Ohne Video zeigt ein Beispiel, worum es geht: die Leber der Demo-Person, die atmet und von einem Werkzeug gedrückt wird, simuliert.</translation>
    </message>
    <message>
        <source>From a video...</source>
        <translation>Aus einem Video …</translation>
    </message>
    <message>
        <source>Two videos, or one that shows both eyes, become a sequence</source>
        <translation>Zwei Videos, oder eines mit beiden Augen, werden zu einer Sequenz</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::RehearsePanel</name>
    <message>
        <source>Rehearse</source>
        <translation>Proben</translation>
    </message>
    <message>
        <source>Open a case with a model of the liver, or the demo patient, to rehearse a retraction.</source>
        <translation>Öffnen Sie einen Fall mit einem Modell der Leber oder den Demopatienten, um eine Retraktion zu proben.</translation>
    </message>
    <message>
        <source>Show the liver with the stiffness of</source>
        <translation>Leber zeigen mit der Steifigkeit von</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>Colour the liver by how far it moves</source>
        <translation>Leber nach ihrer Bewegung einfärben</translation>
    </message>
    <message>
        <source>Place the tool to see what moves.</source>
        <translation>Setzen Sie das Instrument, um zu sehen, was sich bewegt.</translation>
    </message>
    <message>
        <source>The liver moves by up to %1 mm.</source>
        <translation>Die Leber bewegt sich um bis zu %1 mm.</translation>
    </message>
    <message>
        <source>The atlas is off by up to %1 mm.</source>
        <translation>Der Atlas irrt um bis zu %1 mm.</translation>
    </message>
    <message>
        <source>Changed by evidence: %1</source>
        <translation>Durch Befunde verändert: %1</translation>
    </message>
    <message>
        <source>Evidence to bear in mind: %1</source>
        <translation>Befunde, die zu bedenken sind: %1</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Saves the landmarks as CSV, in mm</source>
        <translation>Speichert die Landmarken als CSV, in mm</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Zeitverlauf</translation>
    </message>
    <message>
        <source>Save the landmarks as a table</source>
        <translation>Landmarken als Tabelle speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Sets a landmark where the crosshair is: click in a slice or in 3D first</source>
        <translation>Setzt eine Landmarke, wo das Fadenkreuz ist: zuerst in einen Schnitt oder in 3D klicken</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Takes the chosen landmark away, if it was set by hand; Ctrl+Z brings it back</source>
        <translation>Nimmt die gewählte Landmarke weg, wenn sie von Hand gesetzt wurde; Strg+Z bringt sie zurück</translation>
    </message>
    <message>
        <source>A name has letters or digits.</source>
        <translation>Ein Name hat Buchstaben oder Ziffern.</translation>
    </message>
    <message>
        <source>This name is taken.</source>
        <translation>Dieser Name ist vergeben.</translation>
    </message>
    <message>
        <source>Rename landmark</source>
        <translation>Landmarke umbenennen</translation>
    </message>
    <message>
        <source>Remove landmark</source>
        <translation>Landmarke entfernen</translation>
    </message>
    <message>
        <source>▲ The image cuts the liver off here, towards %1. The tool touches a cap where the liver goes on: place it elsewhere.</source>
        <translation>▲ Das Bild schneidet die Leber hier ab, %1 hin. Das Instrument berührt eine Kappe, wo die Leber weitergeht: setzen Sie es anderswo an.</translation>
    </message>
    <message>
        <source>There are no landmarks: put the crosshair where one is to be, then press Set.</source>
        <translation>Es gibt keine Landmarken: setzen Sie das Fadenkreuz an den Ort und drücken Sie Setzen.</translation>
    </message>
    <message>
        <source>Set landmark</source>
        <translation>Landmarke setzen</translation>
    </message>
    <message>
        <source>Pull with a tool, and see what moves and how far.</source>
        <translation>Mit einem Instrument ziehen und sehen, was sich wie weit bewegt.</translation>
    </message>
    <message>
        <source>Click on the liver where the tool is to touch it.</source>
        <translation>Klicken Sie auf die Leber, wo das Instrument sie berühren soll.</translation>
    </message>
    <message>
        <source>Tool placed in %1 ms.</source>
        <translation>Instrument in %1 ms gesetzt.</translation>
    </message>
    <message>
        <source>Orders of steps</source>
        <translation>Schrittfolgen</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ReportView</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Show the patient&apos;s name</source>
        <translation>Den Namen des Patienten zeigen</translation>
    </message>
    <message>
        <source>Without it the page names neither the patient nor the case; see the settings too</source>
        <translation>Ohne ihn nennt die Seite weder den Patienten noch den Fall; siehe auch die Einstellungen</translation>
    </message>
    <message>
        <source>Collect again</source>
        <translation>Neu zusammenstellen</translation>
    </message>
    <message>
        <source>Reads the case and the present rehearsal anew</source>
        <translation>Liest den Fall und die jetzige Probe neu</translation>
    </message>
    <message>
        <source>Save as a web page...</source>
        <translation>Als Webseite speichern …</translation>
    </message>
    <message>
        <source>Print to PDF...</source>
        <translation>Als PDF drucken …</translation>
    </message>
    <message>
        <source>All that was done for this patient on one page.</source>
        <translation>Alles, was für diesen Patienten getan wurde, auf einer Seite.</translation>
    </message>
    <message>
        <source>Needs a case: open one, or the demo patient.</source>
        <translation>Braucht einen Fall: Öffnen Sie einen, oder den Demopatienten.</translation>
    </message>
    <message>
        <source>Collecting the report</source>
        <translation>Bericht wird zusammengestellt</translation>
    </message>
    <message>
        <source>Open a case, or the demo patient, to see its page.</source>
        <translation>Öffnen Sie einen Fall oder den Demopatienten, um die Seite zu sehen.</translation>
    </message>
    <message>
        <source>The page is being collected.</source>
        <translation>Die Seite wird zusammengestellt.</translation>
    </message>
    <message>
        <source>Something has changed since this page was collected.</source>
        <translation>Seit diese Seite zusammengestellt wurde, hat sich etwas geändert.</translation>
    </message>
    <message>
        <source>Collected from the case and from what is being rehearsed now.</source>
        <translation>Zusammengestellt aus dem Fall und dem, was gerade geprobt wird.</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webseiten (*.html)</translation>
    </message>
    <message>
        <source>The report is in %1</source>
        <translation>Der Bericht liegt in %1</translation>
    </message>
    <message>
        <source>Print the report</source>
        <translation>Bericht drucken</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>With what can be worn</source>
        <translation>Mit tragbaren Rechnern</translation>
    </message>
    <message>
        <source>Adds which wearable computers can do this case, as planned in Platform</source>
        <translation>Fügt hinzu, welche tragbaren Rechner diesen Fall leisten, wie in Plattform geplant</translation>
    </message>
    <message>
        <source>The planned cut.</source>
        <translation>Der geplante Schnitt.</translation>
    </message>
    <message>
        <source>The patient as shown in the window.</source>
        <translation>Der Patient, wie ihn das Fenster zeigt.</translation>
    </message>
    <message>
        <source>Transverse</source>
        <translation>Transversal</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ResectPanel</name>
    <message>
        <source>Plan a resection</source>
        <translation>Resektion planen</translation>
    </message>
    <message>
        <source>Needs a model of the liver. Build it first, or open the demo patient.</source>
        <translation>Braucht ein Modell der Leber. Erstellen Sie es zuerst, oder öffnen Sie den Demopatienten.</translation>
    </message>
    <message>
        <source>Resect</source>
        <translation>Resektion</translation>
    </message>
    <message>
        <source>Set a cut: what goes, what stays, how near the tumours it passes.</source>
        <translation>Einen Schnitt legen: was wegfällt, was bleibt, wie nah er an den Tumoren verläuft.</translation>
    </message>
    <message>
        <source>Draws the part that is removed away from the rest</source>
        <translation>Rückt den Teil, der entfernt wird, vom Rest ab</translation>
    </message>
    <message>
        <source>Remove the other part</source>
        <translation>Den anderen Teil entfernen</translation>
    </message>
    <message>
        <source>No cut</source>
        <translation>Kein Schnitt</translation>
    </message>
    <message>
        <source>The three places lie almost on one line. Click three others.</source>
        <translation>Die drei Stellen liegen fast auf einer Linie. Klicken Sie drei andere an.</translation>
    </message>
    <message>
        <source>Click three places on the liver or in the slices.</source>
        <translation>Klicken Sie drei Stellen auf der Leber oder in den Schichten an.</translation>
    </message>
    <message>
        <source>Click on the liver or in the slices where the cut is to pass.</source>
        <translation>Klicken Sie auf der Leber oder in den Schichten dorthin, wo der Schnitt verlaufen soll.</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Entfernt</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Bleibt</translation>
    </message>
    <message>
        <source>Set three or more points where the cut is to pass: on the liver, or in the slices.</source>
        <translation>Setzen Sie drei oder mehr Punkte, wo der Schnitt verlaufen soll: auf der Leber oder in den Schichten.</translation>
    </message>
    <message>
        <source>Click three places through which the plane is to pass.</source>
        <translation>Klicken Sie drei Stellen an, durch die die Ebene gehen soll.</translation>
    </message>
    <message>
        <source>Planning...</source>
        <translation>Wird geplant …</translation>
    </message>
    <message>
        <source>Put the crosshair where the cut is to pass, then the plane through it. Drag its line in a slice to shift it, a line&apos;s end to tilt it.</source>
        <translation>Setzen Sie das Fadenkreuz dorthin, wo der Schnitt verlaufen soll, dann die Ebene hindurch. Ziehen Sie ihre Linie in einer Schicht, um sie zu verschieben, und ein Ende der Linie, um sie zu kippen.</translation>
    </message>
    <message>
        <source>Separation</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>On the liver as the tool holds it</source>
        <translation>An der Leber, wie das Werkzeug sie hält</translation>
    </message>
    <message>
        <source>The cut lies on the liver held aside; the slices show the scan, at rest.</source>
        <translation>Der Schnitt liegt an der beiseite gehaltenen Leber; die Schichten zeigen die Aufnahme, in Ruhe.</translation>
    </message>
    <message>
        <source>Margins, widths and places are those on the liver under the tool of Rehearse; volumes are at rest</source>
        <translation>Abstände, Weiten und Orte sind die an der Leber unter dem Werkzeug von Proben; Volumina sind in Ruhe</translation>
    </message>
    <message>
        <source>Place a tool in Rehearse first: a patch at small deformations that the model bears, not a rigid tool.</source>
        <translation>Setzen Sie zuerst in Proben ein Instrument an: eine Fläche bei kleinen Verformungen, die das Modell trägt, kein starres Instrument.</translation>
    </message>
    <message>
        <source>Draw a line over the liver in the 3D view.</source>
        <translation>Zeichnen Sie in der 3D-Ansicht eine Linie über die Leber.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ResectionResults</name>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>bleibt</translation>
    </message>
    <message>
        <source>cut through</source>
        <translation>durchschnitten</translation>
    </message>
    <message>
        <source>▲ R1: cut through</source>
        <translation>▲ R1: durchschnitten</translation>
    </message>
    <message>
        <source>▲ Stays in the patient</source>
        <translation>▲ Bleibt im Patienten</translation>
    </message>
    <message>
        <source>▲ R1: under 1 mm</source>
        <translation>▲ R1: unter 1 mm</translation>
    </message>
    <message>
        <source>● Under 5 mm</source>
        <translation>● Unter 5 mm</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Smallest distance to the cut inside the liver</source>
        <translation>Kleinster Abstand zum Schnitt innerhalb der Leber</translation>
    </message>
    <message>
        <source>R1: a margin under 1 mm counts as tumour at the edge. Under 5 mm is narrow.</source>
        <translation>R1: Ein Abstand unter 1 mm gilt als Tumor am Rand. Unter 5 mm ist knapp.</translation>
    </message>
    <message>
        <source>Vessels crossed</source>
        <translation>Gekreuzte Gefäße</translation>
    </message>
    <message>
        <source>Vessel</source>
        <translation>Gefäß</translation>
    </message>
    <message>
        <source>Diameter, mm</source>
        <translation>Durchmesser, mm</translation>
    </message>
    <message>
        <source>The cut crosses no vessel that was outlined.</source>
        <translation>Der Schnitt kreuzt kein umrissenes Gefäß.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 ml&lt;/b&gt; removed (%2 %)</source>
        <translation>&lt;b&gt;%1 ml&lt;/b&gt; entfernt (%2 %)</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 ml&lt;/b&gt; stay (%2 %)</source>
        <translation>&lt;b&gt;%1 ml&lt;/b&gt; bleiben (%2 %)</translation>
    </message>
    <message>
        <source>Caution</source>
        <translation>Vorsicht</translation>
    </message>
    <message>
        <source>With the tool %1 goes by %2 mm; its margin there is %3 mm.</source>
        <translation>Mit dem Werkzeug geht %1 um %2 mm mit; der Abstand dort ist %3 mm.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ResectogramView</name>
    <message>
        <source>20 mm</source>
        <translation>20 mm</translation>
    </message>
    <message>
        <source>%1, %2 mm wide</source>
        <translation>%1, %2 mm weit</translation>
    </message>
    <message>
        <source>In a tumour</source>
        <translation>In einem Tumor</translation>
    </message>
    <message>
        <source>No tumour within %1 mm</source>
        <translation>Kein Tumor näher als %1 mm</translation>
    </message>
    <message>
        <source>%1 mm from a tumour</source>
        <translation>%1 mm von einem Tumor</translation>
    </message>
    <message>
        <source>tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>under %1 mm</source>
        <translation>unter %1 mm</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>○ portal, □ hepatic vein cut; ◇ artery, △ bile duct</source>
        <translation>○ Pfortader, □ Lebervene durchtrennt; ◇ Arterie, △ Gallengang</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SegmentPanel</name>
    <message>
        <source>Segment</source>
        <translation>Segmentieren</translation>
    </message>
    <message>
        <source>Outline the liver, its vessels and its tumours.</source>
        <translation>Leber, Gefäße und Tumoren umreißen.</translation>
    </message>
    <message>
        <source>Needs a case: open one, or import images.</source>
        <translation>Braucht einen Fall: Öffnen Sie einen oder importieren Sie Bilder.</translation>
    </message>
    <message>
        <source>Needs anatomical images: import them in Study.</source>
        <translation>Braucht anatomische Bilder: Importieren Sie sie unter Studie.</translation>
    </message>
    <message>
        <source>Nothing changed.</source>
        <translation>Nichts hat sich geändert.</translation>
    </message>
    <message>
        <source>Reading the structures</source>
        <translation>Strukturen werden gelesen</translation>
    </message>
    <message>
        <source>Another name...</source>
        <translation>Anderer Name …</translation>
    </message>
    <message>
        <source>Name of the structure</source>
        <translation>Name der Struktur</translation>
    </message>
    <message>
        <source>Letters, digits and hyphens:</source>
        <translation>Buchstaben, Ziffern und Bindestriche:</translation>
    </message>
    <message>
        <source>Choose a structure first, or add one.</source>
        <translation>Wählen Sie zuerst eine Struktur oder fügen Sie eine hinzu.</translation>
    </message>
    <message>
        <source>Click into the structure first, in any slice.</source>
        <translation>Klicken Sie zuerst in die Struktur, in irgendeiner Schicht.</translation>
    </message>
    <message>
        <source>Replaces the outline by the tissue around the points</source>
        <translation>Ersetzt den Umriss durch das Gewebe um die Punkte</translation>
    </message>
    <message>
        <source>Click into the tissue, away from large vessels. Points so far: %1</source>
        <translation>Klicken Sie ins Gewebe, abseits großer Gefäße. Punkte bisher: %1</translation>
    </message>
    <message>
        <source>Choose a tool to draw in the slices. Without one, clicks move the crosshair.</source>
        <translation>Wählen Sie ein Werkzeug, um in den Schichten zu zeichnen. Ohne Werkzeug bewegen Klicks das Fadenkreuz.</translation>
    </message>
    <message>
        <source>Growing: %1</source>
        <translation>Wachsen: %1</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>The chosen one is drawn on. The box shows or hides it.</source>
        <translation>Auf der gewählten wird gezeichnet. Das Kästchen zeigt oder verbirgt sie.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>A new, empty structure</source>
        <translation>Eine neue, leere Struktur</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Another name, and with it another colour, for the chosen structure</source>
        <translation>Ein anderer Name und damit eine andere Farbe für die gewählte Struktur</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Takes the chosen structure out of the case; Ctrl+Z brings it back</source>
        <translation>Nimmt die gewählte Struktur aus dem Fall; Strg+Z bringt sie zurück</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Radierer</translation>
    </message>
    <message>
        <source>Smart brush</source>
        <translation>Gewebepinsel</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Wachsen</translation>
    </message>
    <message>
        <source>Pick piece</source>
        <translation>Stück wählen</translation>
    </message>
    <message>
        <source>Clicks move the crosshair</source>
        <translation>Klicks bewegen das Fadenkreuz</translation>
    </message>
    <message>
        <source>Drag to add. Ctrl: erase instead. Shift+wheel: radius in mm</source>
        <translation>Ziehen fügt hinzu. Strg: stattdessen löschen. Umschalt+Rad: Radius in mm</translation>
    </message>
    <message>
        <source>Drag to take away. Ctrl: add instead. Shift+wheel: radius in mm</source>
        <translation>Ziehen nimmt weg. Strg: stattdessen hinzufügen. Umschalt+Rad: Radius in mm</translation>
    </message>
    <message>
        <source>Adds only where the grey values are like those under the click</source>
        <translation>Fügt nur hinzu, wo die Grauwerte denen unter dem Klick gleichen</translation>
    </message>
    <message>
        <source>Draw around something, and cut away what is inside or outside</source>
        <translation>Etwas umfahren und wegschneiden, was innen oder außen ist</translation>
    </message>
    <message>
        <source>%1 (key %2)</source>
        <translation>%1 (Taste %2)</translation>
    </message>
    <message>
        <source>Radius (Shift+wheel)</source>
        <translation>Radius (Umschalt+Rad)</translation>
    </message>
    <message>
        <source>Radius of the brush in mm</source>
        <translation>Radius des Pinsels in mm</translation>
    </message>
    <message>
        <source>Disc in this slice</source>
        <translation>Scheibe in dieser Schicht</translation>
    </message>
    <message>
        <source>Ball through the slices</source>
        <translation>Kugel durch die Schichten</translation>
    </message>
    <message>
        <source>Whether the brush reaches into the neighbouring slices</source>
        <translation>Ob der Pinsel in die Nachbarschichten reicht</translation>
    </message>
    <message>
        <source>Tolerance (standard deviations)</source>
        <translation>Toleranz (Standardabweichungen)</translation>
    </message>
    <message>
        <source>How far a grey value may be from that under the click, in standard deviations around it</source>
        <translation>Wie weit ein Grauwert von dem unter dem Klick abweichen darf, in Standardabweichungen um ihn</translation>
    </message>
    <message>
        <source>Cut away what is inside</source>
        <translation>Wegschneiden, was innen ist</translation>
    </message>
    <message>
        <source>Cut away what is outside</source>
        <translation>Wegschneiden, was außen ist</translation>
    </message>
    <message>
        <source>In this slice only</source>
        <translation>Nur in dieser Schicht</translation>
    </message>
    <message>
        <source>Through all slices</source>
        <translation>Durch alle Schichten</translation>
    </message>
    <message>
        <source>Forget the points</source>
        <translation>Punkte vergessen</translation>
    </message>
    <message>
        <source>The whole structure</source>
        <translation>Die ganze Struktur</translation>
    </message>
    <message>
        <source>Fill between slices</source>
        <translation>Zwischen Schichten füllen</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message>
        <source>Keep the largest</source>
        <translation>Größtes behalten</translation>
    </message>
    <message>
        <source>Remove pieces below</source>
        <translation>Stücke entfernen unter</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Grow by</source>
        <translation>Wachsen um</translation>
    </message>
    <message>
        <source>Shrink by</source>
        <translation>Schrumpfen um</translation>
    </message>
    <message>
        <source>Fills the slices between drawn ones by their shapes</source>
        <translation>Füllt die Schichten zwischen gezeichneten nach deren Formen</translation>
    </message>
    <message>
        <source>Fills what is enclosed on all sides</source>
        <translation>Füllt, was ringsum eingeschlossen ist</translation>
    </message>
    <message>
        <source>Keeps the largest piece and drops the others</source>
        <translation>Behält das größte Stück und entfernt die anderen</translation>
    </message>
    <message>
        <source>Drops pieces of less than this volume in ml</source>
        <translation>Entfernt Stücke von weniger als diesem Volumen in ml</translation>
    </message>
    <message>
        <source>Rounds what is smaller than about this many mm</source>
        <translation>Rundet, was kleiner als etwa so viele mm ist</translation>
    </message>
    <message>
        <source>Adds a margin of this many mm all around</source>
        <translation>Fügt ringsum einen Rand von so vielen mm hinzu</translation>
    </message>
    <message>
        <source>Takes a margin of this many mm away all around</source>
        <translation>Nimmt ringsum einen Rand von so vielen mm weg</translation>
    </message>
    <message>
        <source>Transverse</source>
        <translation>Transversal</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>The slices that were drawn in</source>
        <translation>Die Schichten, in denen gezeichnet wurde</translation>
    </message>
    <message>
        <source>Least volume in ml</source>
        <translation>Kleinstes Volumen in ml</translation>
    </message>
    <message>
        <source>Radius of smoothing in mm</source>
        <translation>Radius der Glättung in mm</translation>
    </message>
    <message>
        <source>Margin in mm</source>
        <translation>Rand in mm</translation>
    </message>
    <message>
        <source>So far to both sides</source>
        <translation>So weit nach beiden Seiten</translation>
    </message>
    <message>
        <source>This slice and all towards you</source>
        <translation>Diese Schicht und alle davor</translation>
    </message>
    <message>
        <source>This slice and all behind it</source>
        <translation>Diese Schicht und alle dahinter</translation>
    </message>
    <message>
        <source>How deep the scissors cut along your line of sight, in tilted slices too</source>
        <translation>Wie tief die Schere entlang Ihrer Blickrichtung schneidet, auch in gekippten Schichten</translation>
    </message>
    <message>
        <source>How far the scissors cut before and behind this slice, in mm</source>
        <translation>Wie weit die Schere vor und hinter dieser Schicht schneidet, in mm</translation>
    </message>
    <message>
        <source>Click into the middle of it. Points so far: %1</source>
        <translation>In die Mitte davon klicken. Punkte bisher: %1</translation>
    </message>
    <message>
        <source>Outline with another program...</source>
        <translation>Mit einem anderen Programm umreißen...</translation>
    </message>
    <message>
        <source>Outline with another program</source>
        <translation>Mit einem anderen Programm umreißen</translation>
    </message>
    <message>
        <source>Its command, as in TotalSegmentator -i {image} -o {folder}
(kept in Settings):</source>
        <translation>Sein Befehl, wie in TotalSegmentator -i {image} -o {folder}
(bleibt in den Einstellungen):</translation>
    </message>
    <message>
        <source>Outlining with another program</source>
        <translation>Ein anderes Programm umreißt</translation>
    </message>
    <message>
        <source>Click on the piece that is to stay; all others go. Ctrl and click: the part under the pointer goes, from where it is narrowest.</source>
        <translation>Klicken Sie auf das Stück, das bleiben soll; alle anderen verschwinden. Strg und Klick: Der Teil unter dem Zeiger verschwindet, von der schmalsten Stelle an.</translation>
    </message>
    <message>
        <source>Click on the piece that is to stay; all others go. Ctrl: takes off the part under the pointer</source>
        <translation>Klicken Sie auf das Stück, das bleiben soll; alle anderen verschwinden. Strg: nimmt den Teil unter dem Zeiger ab</translation>
    </message>
    <message>
        <source>Outline the liver first.</source>
        <translation>Umreißen Sie zuerst die Leber.</translation>
    </message>
    <message>
        <source>Replaces the outline by all that is shaped like a vessel in the liver</source>
        <translation>Ersetzt den Umriss durch alles, was in der Leber wie ein Gefäß geformt ist</translation>
    </message>
    <message>
        <source>Replaces the outline by the vessels in the liver that hang on the points</source>
        <translation>Ersetzt den Umriss durch die Gefäße der Leber, die an den Punkten hängen</translation>
    </message>
    <message>
        <source>Click into the vessel where it stands out best, or let all vessels be found. Points so far: %1</source>
        <translation>Klicken Sie in das Gefäß, wo es sich am besten abhebt, oder lassen Sie alle Gefäße finden. Punkte bisher: %1</translation>
    </message>
    <message>
        <source>Finding vessels: %1</source>
        <translation>Gefäße werden gesucht: %1</translation>
    </message>
    <message>
        <source>Click points into the tissue, then let the structure grow over what looks alike; vessels are found without</source>
        <translation>Klicken Sie Punkte in das Gewebe und lassen Sie die Struktur über Gleiches wachsen; Gefäße werden auch ohne gefunden</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Finden</translation>
    </message>
    <message>
        <source>Replaces the outline by the liver that brightness and shape show; it needs no point</source>
        <translation>Ersetzt den Umriss durch die Leber, die Helligkeit und Form zeigen; ein Punkt ist nicht nötig</translation>
    </message>
    <message>
        <source>Finding: %1</source>
        <translation>Wird gesucht: %1</translation>
    </message>
    <message>
        <source>Points outside count for Find alone.</source>
        <translation>Punkte außerhalb zählen nur für „Finden“.</translation>
    </message>
    <message>
        <source>Click into the liver, away from large vessels; Ctrl and click into what is wrongly taken for it. A click on a point takes it away. Points so far: %1 inside, %2 outside</source>
        <translation>Klicken Sie in die Leber, abseits großer Gefäße; mit Strg in das, was fälschlich für sie gehalten wird. Ein Klick auf einen Punkt nimmt ihn weg. Punkte bisher: %1 innerhalb, %2 außerhalb</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SequenceReportView</name>
    <message>
        <source>Calibration: read; the eyes are %1 mm apart.</source>
        <translation>Kalibrierung: gelesen; die Augen sind %1 mm auseinander.</translation>
    </message>
    <message>
        <source>Calibration: reprojection error %1 px; the board is seen in %2 of %3 pairs; the eyes are %4 mm apart.</source>
        <translation>Kalibrierung: Rückprojektionsfehler %1 px; die Tafel ist in %2 von %3 Paaren zu sehen; die Augen sind %4 mm auseinander.</translation>
    </message>
    <message>
        <source>Landmarks tracked: %1.</source>
        <translation>Verfolgte Landmarken: %1.</translation>
    </message>
    <message>
        <source>Landmarks tracked: %1; they agree within %2 mm once all frames are aligned.</source>
        <translation>Verfolgte Landmarken: %1; sind alle Bilder ausgerichtet, stimmen sie auf %2 mm überein.</translation>
    </message>
    <message>
        <source>Most pairs do not show the board: check its kind, its columns and its rows.</source>
        <translation>Die meisten Paare zeigen die Tafel nicht: Prüfen Sie ihre Art, ihre Spalten und Zeilen.</translation>
    </message>
    <message>
        <source>More than 1 px: the board may not be flat, or it moved between the two eyes.</source>
        <translation>Mehr als 1 px: Die Tafel ist vielleicht nicht eben, oder sie bewegte sich zwischen den beiden Augen.</translation>
    </message>
    <message>
        <source>The eyes of a laparoscope are about 5 mm apart: is the board&apos;s size right?</source>
        <translation>Die Augen eines Laparoskops sind etwa 5 mm auseinander: Stimmt die Größe der Tafel?</translation>
    </message>
    <message>
        <source>The eyes of a laparoscope are about 5 mm apart: is the calibration in mm?</source>
        <translation>Die Augen eines Laparoskops sind etwa 5 mm auseinander: Ist die Kalibrierung in mm?</translation>
    </message>
    <message>
        <source>The calibration&apos;s middle lies far from the pictures&apos; middle: is it of this size?</source>
        <translation>Die Mitte der Kalibrierung liegt weit von der Bildmitte: Gilt sie für diese Größe?</translation>
    </message>
    <message>
        <source>Frames left out because they show hardly anything in depth: %1.</source>
        <translation>Bilder, die weggelassen wurden, weil ihre Tiefe kaum zu sehen ist: %1.</translation>
    </message>
    <message>
        <source>What comes on the way</source>
        <translation>Was unterwegs entsteht</translation>
    </message>
    <message>
        <source>Here you will see how well the camera is calibrated, how much of each pair of pictures is seen in depth, and how many landmarks are followed. Then the sequence is opened.</source>
        <translation>Hier sehen Sie, wie gut die Kamera kalibriert ist, von wie viel jedes Bildpaares die Tiefe zu sehen ist und wie viele Landmarken verfolgt werden. Dann wird die Sequenz geöffnet.</translation>
    </message>
    <message>
        <source>A frame beside its depths</source>
        <translation>Ein Bild neben seinen Tiefen</translation>
    </message>
    <message>
        <source>First pair, frame %1: points %2; %3 % of what can be seen.</source>
        <translation>Erstes Paar, Bild %1: Punkte %2; %3 % von dem, was zu sehen ist.</translation>
    </message>
    <message>
        <source>Frames: %1, with %2 points each on average; %3 % of what can be seen.</source>
        <translation>Bilder: %1, im Mittel je %2 Punkte; %3 % von dem, was zu sehen ist.</translation>
    </message>
    <message>
        <source>Frame %1: points %2; %3 % of what can be seen; landmarks known from before: %4.</source>
        <translation>Bild %1: Punkte %2; %3 % von dem, was zu sehen ist; von vorher bekannte Landmarken: %4.</translation>
    </message>
    <message>
        <source>Kept in %1.</source>
        <translation>Aufbewahrt in %1.</translation>
    </message>
    <message>
        <source>Rectified left picture; beside it what is seen in depth, near places bright.</source>
        <translation>Rektifiziertes linkes Bild; daneben die Tiefe, die zu sehen ist, nahe Stellen hell.</translation>
    </message>
    <message>
        <source>Made from the video.</source>
        <translation>Aus dem Video hergestellt.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SeriesTable</name>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Size and spacing</source>
        <translation>Größe und Abstand</translation>
    </message>
    <message>
        <source>Use as</source>
        <translation>Verwenden als</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Anatomy</source>
        <translation>Anatomie</translation>
    </message>
    <message>
        <source>Stiffness (kPa)</source>
        <translation>Steifigkeit (kPa)</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Konfidenz</translation>
    </message>
    <message>
        <source>MRE magnitude</source>
        <translation>MRE-Magnitude</translation>
    </message>
    <message>
        <source>MRE phase</source>
        <translation>MRE-Phase</translation>
    </message>
    <message>
        <source>MRE waves</source>
        <translation>MRE-Wellen</translation>
    </message>
    <message>
        <source>Segmentation</source>
        <translation>Segmentierung</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Without a description</source>
        <translation>Ohne Beschreibung</translation>
    </message>
    <message>
        <source>%1 volumes</source>
        <translation>%1 Volumina</translation>
    </message>
    <message>
        <source>Use %1 as</source>
        <translation>%1 verwenden als</translation>
    </message>
    <message>
        <source>What this series is for. The proposal is read from its header.</source>
        <translation>Wozu diese Serie dient. Der Vorschlag ist aus ihrem Kopf gelesen.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SettingsWindow</name>
    <message>
        <source>Settings - Glisson</source>
        <translation>Einstellungen - Glisson</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Aussehen</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>System language</source>
        <translation>Sprache des Systems</translation>
    </message>
    <message>
        <source>&amp;Processors</source>
        <translation>&amp;Prozessoren</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Alle %1</translation>
    </message>
    <message>
        <source>How many processors long computations may take</source>
        <translation>Wie viele Prozessoren lange Rechnungen nutzen dürfen</translation>
    </message>
    <message>
        <source>&amp;Patients&apos; names in what leaves this window</source>
        <translation>&amp;Patientennamen in allem, was dieses Fenster verlässt</translation>
    </message>
    <message>
        <source>Pictures, movies and reports name a patient only then. The log never does.</source>
        <translation>Nur dann nennen Bilder, Filme und Berichte einen Patienten. Das Protokoll tut es nie.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>&amp;Outlining program</source>
        <translation>&amp;Umriss-Programm</translation>
    </message>
    <message>
        <source>Its &amp;values</source>
        <translation>Seine &amp;Werte</translation>
    </message>
    <message>
        <source>A program of yours that outlines organs, for Segment (Add). {image} stands for the images of the case and {folder} for where its label maps go. Values are named only where its files do not say what they are.</source>
        <translation>Ein eigenes Programm, das Organe umreißt, für Segmentieren (Hinzufügen). {image} steht für die Bilder des Falls und {folder} für den Ort seiner Labelkarten. Werte werden nur benannt, wo seine Dateien nicht sagen, was sie sind.</translation>
    </message>
    <message>
        <source>As in: %1</source>
        <translation>Wie in: %1</translation>
    </message>
    <message>
        <source>Livers&apos; &amp;shapes</source>
        <translation>&amp;Leberformen</translation>
    </message>
    <message>
        <source>A shape model&apos;s file, by which Segment finds the liver; without one, a simulated liver&apos;s shape</source>
        <translation>Die Datei eines Formmodells, mit dem Segmentieren die Leber findet; ohne eine die Form einer simulierten Leber</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ShortcutsWindow</name>
    <message>
        <source>Keys - Glisson</source>
        <translation>Tasten - Glisson</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Words to search for</source>
        <translation>Suchwörter</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Was sie tut</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SliceTools</name>
    <message>
        <source>Choose a structure first, or add one.</source>
        <translation>Wählen Sie zuerst eine Struktur oder fügen Sie eine hinzu.</translation>
    </message>
    <message>
        <source>One moment: the last change is being worked off.</source>
        <translation>Einen Moment: Die letzte Änderung wird noch ausgeführt.</translation>
    </message>
    <message>
        <source>Points outside count for the liver alone.</source>
        <translation>Punkte außerhalb zählen nur für die Leber.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SolvingLight</name>
    <message>
        <source>○ No tool</source>
        <translation>○ Kein Instrument</translation>
    </message>
    <message>
        <source>◐ Solving</source>
        <translation>◐ Löst</translation>
    </message>
    <message>
        <source>▲ Not to be used</source>
        <translation>▲ Nicht brauchbar</translation>
    </message>
    <message>
        <source>✔ Solved</source>
        <translation>✔ Gelöst</translation>
    </message>
    <message>
        <source>✖ Not solved</source>
        <translation>✖ Nicht gelöst</translation>
    </message>
    <message>
        <source>❚❚ Frozen</source>
        <translation>❚❚ Eingefroren</translation>
    </message>
    <message>
        <source>What is shown is from before.</source>
        <translation>Gezeigt wird der Stand davor.</translation>
    </message>
    <message>
        <source>▲ Outside of the model</source>
        <translation>▲ Außerhalb des Modells</translation>
    </message>
    <message>
        <source>Use less force.</source>
        <translation>Nehmen Sie weniger Kraft.</translation>
    </message>
    <message>
        <source>solved in %1 ms · drawn in %2 ms</source>
        <translation>gelöst in %1 ms · gezeichnet in %2 ms</translation>
    </message>
    <message>
        <source>Residual %1: how far the equations are from balance</source>
        <translation>Residuum %1: wie weit die Gleichungen vom Gleichgewicht entfernt sind</translation>
    </message>
    <message>
        <source>An estimate, which holds for slow tools; past 0.5 mm the picture is said to be settling</source>
        <translation>Eine Schätzung, die für langsame Instrumente gilt; über 0.5 mm heißt es, dass das Bild zur Ruhe kommt</translation>
    </message>
    <message>
        <source>◐ Preparing</source>
        <translation>◐ In Vorbereitung</translation>
    </message>
    <message>
        <source>◐ Settling</source>
        <translation>◐ Kommt zur Ruhe</translation>
    </message>
    <message>
        <source>▲ Not at rest</source>
        <translation>▲ Nicht in Ruhe</translation>
    </message>
    <message>
        <source>Landmarks are within %1 mm of rest</source>
        <translation>Landmarken liegen höchstens %1 mm von der Ruhelage</translation>
    </message>
    <message>
        <source>This picture is not at rest, and the liver may slip farther than is shown. Press less, or move the tool a little.</source>
        <translation>Dieses Bild ist nicht in Ruhe, und die Leber kann weiter gleiten, als gezeigt ist. Drücken Sie weniger, oder bewegen Sie das Instrument ein wenig.</translation>
    </message>
    <message>
        <source>◐ Moving</source>
        <translation>◐ In Bewegung</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StatusLine</name>
    <message>
        <source>about %1 s left</source>
        <translation>noch etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation>noch etwa %1 min</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Not a medical device</source>
        <translation>Kein Medizinprodukt</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StressStrainPlot</name>
    <message>
        <source>Measured strain and stress</source>
        <translation>Gemessene Dehnung und Spannung</translation>
    </message>
    <message>
        <source>strain, %</source>
        <translation>Dehnung, %</translation>
    </message>
    <message>
        <source>stress, kPa</source>
        <translation>Spannung, kPa</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StructureOperations</name>
    <message>
        <source>Choose a structure first, or add one.</source>
        <translation>Zuerst eine Struktur wählen oder hinzufügen.</translation>
    </message>
    <message>
        <source>Replaces the structure by the voxels of these grey values</source>
        <translation>Ersetzt die Struktur durch die Voxel mit diesen Grauwerten</translation>
    </message>
    <message>
        <source>There is no other structure.</source>
        <translation>Es gibt keine andere Struktur.</translation>
    </message>
    <message>
        <source>Changes the chosen structure; the other one stays as it is</source>
        <translation>Ändert die gewählte Struktur; die andere bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>Grey values and other structures</source>
        <translation>Grauwerte und andere Strukturen</translation>
    </message>
    <message>
        <source>Grey values from, to</source>
        <translation>Grauwerte von, bis</translation>
    </message>
    <message>
        <source>Lowest grey value</source>
        <translation>Niedrigster Grauwert</translation>
    </message>
    <message>
        <source>Highest grey value</source>
        <translation>Höchster Grauwert</translation>
    </message>
    <message>
        <source>As here</source>
        <translation>Wie hier</translation>
    </message>
    <message>
        <source>Takes the grey values that are like those under the crosshair</source>
        <translation>Nimmt die Grauwerte, die denen unter dem Fadenkreuz gleichen</translation>
    </message>
    <message>
        <source>Take these</source>
        <translation>Diese nehmen</translation>
    </message>
    <message>
        <source>The brush draws on these only</source>
        <translation>Der Pinsel zeichnet nur auf diesen</translation>
    </message>
    <message>
        <source>Inside of</source>
        <translation>Innerhalb von</translation>
    </message>
    <message>
        <source>the whole image</source>
        <translation>dem ganzen Bild</translation>
    </message>
    <message>
        <source>Structure to stay inside of</source>
        <translation>Struktur, in der zu bleiben ist</translation>
    </message>
    <message>
        <source>Grow and Take these stay inside of this structure</source>
        <translation>Wachsen und Diese nehmen bleiben in dieser Struktur</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Keep what is also in</source>
        <translation>Behalten, was auch darin ist</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>What to do with the other structure</source>
        <translation>Was mit der anderen Struktur zu tun ist</translation>
    </message>
    <message>
        <source>The other structure</source>
        <translation>Die andere Struktur</translation>
    </message>
    <message>
        <source>Do it</source>
        <translation>Ausführen</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StudiesPage</name>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Run the dissertation&apos;s studies over many patients, and follow them.</source>
        <translation>Die Studien der Dissertation über viele Patienten ausführen und verfolgen.</translation>
    </message>
    <message>
        <source>Of the patients in</source>
        <translation>An den Patienten in</translation>
    </message>
    <message>
        <source>Of the case</source>
        <translation>Am Fall</translation>
    </message>
    <message>
        <source>Of the livers in</source>
        <translation>An den Lebern in</translation>
    </message>
    <message>
        <source>Of the scans in</source>
        <translation>An den Scans in</translation>
    </message>
    <message>
        <source>No folder: simulated patients</source>
        <translation>Kein Ordner: simulierte Patienten</translation>
    </message>
    <message>
        <source>Open a case, or choose one</source>
        <translation>Öffnen oder wählen Sie einen Fall</translation>
    </message>
    <message>
        <source>Choose a folder of label maps</source>
        <translation>Wählen Sie einen Ordner mit Label-Karten</translation>
    </message>
    <message>
        <source>No folder: simulated scans</source>
        <translation>Kein Ordner: simulierte Scans</translation>
    </message>
    <message>
        <source>The folder with the patients or scans, or a case</source>
        <translation>Der Ordner mit den Patienten oder Scans, oder ein Fall</translation>
    </message>
    <message>
        <source>The folder for the results</source>
        <translation>Der Ordner für die Ergebnisse</translation>
    </message>
    <message>
        <source>The folder that a study is written to</source>
        <translation>Der Ordner, in den eine Studie geschrieben wird</translation>
    </message>
    <message>
        <source>Patients done: %1</source>
        <translation>Patienten fertig: %1</translation>
    </message>
    <message>
        <source>Could not be used: %1</source>
        <translation>Nicht zu gebrauchen: %1</translation>
    </message>
    <message>
        <source>Start a study, or follow a folder that another program fills.</source>
        <translation>Beginnen Sie eine Studie, oder folgen Sie einem Ordner, den ein anderes Programm füllt.</translation>
    </message>
    <message>
        <source>Stopping...</source>
        <translation>Wird angehalten...</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Fertig.</translation>
    </message>
    <message>
        <source>Stopped. Started again, it goes on from there.</source>
        <translation>Angehalten. Wieder begonnen, geht sie von dort weiter.</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Wählen...</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>Without a folder</source>
        <translation>Ohne Ordner</translation>
    </message>
    <message>
        <source>Simulated patients</source>
        <translation>Simulierte Patienten</translation>
    </message>
    <message>
        <source>Results go to</source>
        <translation>Ergebnisse nach</translation>
    </message>
    <message>
        <source>A folder. What lies there from an earlier run of the same study is not computed again.</source>
        <translation>Ein Ordner. Was dort aus einem früheren Lauf derselben Studie liegt, wird nicht noch einmal berechnet.</translation>
    </message>
    <message>
        <source>...</source>
        <translation>...</translation>
    </message>
    <message>
        <source>Choose the folder for the results</source>
        <translation>Den Ordner für die Ergebnisse wählen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Runs beside the window; closing the window stops it. Started again, it goes on.</source>
        <translation>Läuft neben dem Fenster; wird das Fenster geschlossen, hält sie an. Wieder begonnen, geht sie weiter.</translation>
    </message>
    <message>
        <source>Follow a folder...</source>
        <translation>Einem Ordner folgen...</translation>
    </message>
    <message>
        <source>Shows what another program, or a cluster, writes to a study&apos;s folder</source>
        <translation>Zeigt, was ein anderes Programm oder ein Rechencluster in den Ordner einer Studie schreibt</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>What is done stays</source>
        <translation>Was fertig ist, bleibt</translation>
    </message>
    <message>
        <source>Open the page</source>
        <translation>Seite öffnen</translation>
    </message>
    <message>
        <source>The study&apos;s report, in the browser</source>
        <translation>Der Bericht der Studie, im Browser</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StudyPage</name>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Find images, say what each series is for, and see what the case holds.</source>
        <translation>Bilder finden, sagen, wozu jede Serie dient, und sehen, was der Fall enthält.</translation>
    </message>
    <message>
        <source>Looking for images</source>
        <translation>Bilder werden gesucht</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Look in a folder...</source>
        <translation>In einem Ordner suchen …</translation>
    </message>
    <message>
        <source>A folder, a DICOMDIR or one file; dropping it on the window does the same</source>
        <translation>Ein Ordner, ein DICOMDIR oder eine Datei; Ablegen auf dem Fenster tut dasselbe</translation>
    </message>
    <message>
        <source>Keep the case as</source>
        <translation>Fall aufbewahren als</translation>
    </message>
    <message>
        <source>Make a case</source>
        <translation>Fall anlegen</translation>
    </message>
    <message>
        <source>Add to the open case</source>
        <translation>Zum offenen Fall hinzufügen</translation>
    </message>
    <message>
        <source>Drop a folder of DICOM images, a DICOMDIR, or a NIfTI, NRRD or MHA file here.</source>
        <translation>Legen Sie hier einen Ordner mit DICOM-Bildern, ein DICOMDIR oder eine NIfTI-, NRRD- oder MHA-Datei ab.</translation>
    </message>
    <message>
        <source>%1: series found: %2</source>
        <translation>%1: gefundene Serien: %2</translation>
    </message>
    <message>
        <source>; files left out: %1</source>
        <translation>; ausgelassene Dateien: %1</translation>
    </message>
    <message>
        <source>Give at least one series a role first.</source>
        <translation>Geben Sie zuerst mindestens einer Serie eine Rolle.</translation>
    </message>
    <message>
        <source>There is something of that name already: choose another.</source>
        <translation>Unter diesem Namen gibt es schon etwas: Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>Copies the chosen series into a new case</source>
        <translation>Kopiert die gewählten Serien in einen neuen Fall</translation>
    </message>
    <message>
        <source>No case is open.</source>
        <translation>Es ist kein Fall geöffnet.</translation>
    </message>
    <message>
        <source>Patients&apos; names are neither shown nor kept: a case keeps a hash of them. The images are never written to.</source>
        <translation>Patientennamen werden weder gezeigt noch behalten: Ein Fall behält nur einen Hashwert davon. In die Bilder wird nie geschrieben.</translation>
    </message>
    <message>
        <source>Labels need the images that they were drawn on: give one series another role.</source>
        <translation>Labels brauchen die Bilder, auf denen sie gezeichnet wurden: Geben Sie einer Serie eine andere Rolle.</translation>
    </message>
    <message>
        <source>Glisson asks before anything is replaced; Ctrl+Z brings it back</source>
        <translation>Glisson fragt, bevor etwas ersetzt wird; Strg+Z holt es zurück</translation>
    </message>
    <message>
        <source>Open images: a folder, or a file of them</source>
        <translation>Bilder öffnen: ein Ordner oder eine Datei davon</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StudyPanel</name>
    <message>
        <source>Slices show</source>
        <translation>Schichten zeigen</translation>
    </message>
    <message>
        <source>Anatomy</source>
        <translation>Anatomie</translation>
    </message>
    <message>
        <source>Stiffness (MR elastography)</source>
        <translation>Steifigkeit (MR-Elastographie)</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>No patient open</source>
        <translation>Kein Patient geöffnet</translation>
    </message>
    <message>
        <source>%1 cells
Young&apos;s modulus %2 kPa (mean)</source>
        <translation>%1 Zellen
Elastizitätsmodul %2 kPa (Mittel)</translation>
    </message>
    <message>
        <source>%1 voxels,
%2 each</source>
        <translation>%1 Voxel,
je %2</translation>
    </message>
    <message>
        <source>%1 cells
Young&apos;s modulus %2 kPa (assumed)</source>
        <translation>%1 Zellen
Elastizitätsmodul %2 kPa (angenommen)</translation>
    </message>
    <message>
        <source>%1 (fixed)</source>
        <translation>%1 (fest)</translation>
    </message>
    <message>
        <source>No part of the model: drawn where it was outlined, it does not move.</source>
        <translation>Nicht Teil des Modells: gezeichnet, wo es umrissen wurde; es bewegt sich nicht.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StudyRun</name>
    <message>
        <source>%1 could not be started: it belongs beside this program. Install Glisson again.</source>
        <translation>%1 ließ sich nicht starten: Es gehört neben dieses Programm. Installieren Sie Glisson neu.</translation>
    </message>
    <message>
        <source>The study ended without saying why. Start it again.</source>
        <translation>Die Studie endete, ohne zu sagen, warum. Beginnen Sie sie noch einmal.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TakingIn</name>
    <message>
        <source>Looking at the labels</source>
        <translation>Labels ansehen</translation>
    </message>
    <message>
        <source>The case %1 has an anatomy already. These images would replace it; what was outlined and modelled on it then no longer fits.</source>
        <translation>Der Fall %1 hat schon eine Anatomie. Diese Bilder würden sie ersetzen; was darauf umrissen und modelliert wurde, passt dann nicht mehr.</translation>
    </message>
    <message>
        <source>Replace the anatomy?</source>
        <translation>Die Anatomie ersetzen?</translation>
    </message>
    <message>
        <source>Is it this patient?</source>
        <translation>Ist es dieser Patient?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Add all the same</source>
        <translation>Trotzdem hinzufügen</translation>
    </message>
    <message>
        <source>Importing</source>
        <translation>Import läuft</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TargetTable</name>
    <message>
        <source>What is drawn, and how far it may be off</source>
        <translation>Was gezeichnet ist und wie weit es danebenliegen kann</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>sd</source>
        <translation>s</translation>
    </message>
    <message>
        <source>90 %</source>
        <translation>90 %</translation>
    </message>
    <message>
        <source>deep</source>
        <translation>tief</translation>
    </message>
    <message>
        <source>Standard deviation of each coordinate of the error, mm: the largest over the structure</source>
        <translation>Standardabweichung jeder Koordinate des Fehlers, mm: die größte der Struktur</translation>
    </message>
    <message>
        <source>90 of 100 such places are off by this at most, mm: 2.5 sd</source>
        <translation>90 von 100 solchen Stellen liegen höchstens so weit daneben, mm: 2.5 s</translation>
    </message>
    <message>
        <source>How far its nearest place lies behind the liver&apos;s front, along the line of sight, mm</source>
        <translation>Wie weit seine nächste Stelle in Blickrichtung hinter der Vorderseite der Leber liegt, mm</translation>
    </message>
    <message>
        <source>Do not trust it at %1 mm</source>
        <translation>Bei %1 mm nicht zu trauen</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::Timeline</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Ein Bild zurück</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>Ein Bild weiter</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>No frames</source>
        <translation>Keine Bilder</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>Open a sequence first</source>
        <translation>Zuerst eine Sequenz öffnen</translation>
    </message>
    <message>
        <source>Plays the video at 15 frames a second, round and round (Space)</source>
        <translation>Spielt das Video mit 15 Bildern je Sekunde, immer wieder (Leertaste)</translation>
    </message>
    <message>
        <source>One frame back (Left)</source>
        <translation>Ein Bild zurück (Links)</translation>
    </message>
    <message>
        <source>One frame on (Right)</source>
        <translation>Ein Bild weiter (Rechts)</translation>
    </message>
    <message>
        <source>The frame that is shown (Left, Right, Page Up, Page Down, Home, End)</source>
        <translation>Das Bild, das gezeigt wird (Links, Rechts, Bild auf, Bild ab, Pos1, Ende)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ToolControls</name>
    <message>
        <source>Tool</source>
        <translation>Instrument</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Place by click</source>
        <translation>Per Klick setzen</translation>
    </message>
    <message>
        <source>Then click on the liver where the tool is to touch it. By key: Ctrl+T, at the crosshair</source>
        <translation>Klicken Sie dann auf die Stelle der Leber, die das Instrument berühren soll. Per Taste: Strg+T, am Fadenkreuz</translation>
    </message>
    <message>
        <source>Hoist segment VI</source>
        <translation>Segment VI anheben</translation>
    </message>
    <message>
        <source>Puts the tool under the right, lower, rear part of the liver, lifting it to the front and the head</source>
        <translation>Setzt das Instrument unter den rechten, unteren, hinteren Teil der Leber und hebt ihn nach vorn und kopfwärts an</translation>
    </message>
    <message>
        <source>Hoist to front and head</source>
        <translation>Nach vorn und kopfwärts anheben</translation>
    </message>
    <message>
        <source>Pull away from the surface</source>
        <translation>Von der Oberfläche wegziehen</translation>
    </message>
    <message>
        <source>Push into the surface</source>
        <translation>In die Oberfläche drücken</translation>
    </message>
    <message>
        <source>As the arrow was dragged</source>
        <translation>Wie der Pfeil gezogen wurde</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Touch with the rigid tool itself</source>
        <translation>Mit dem starren Instrument selbst berühren</translation>
    </message>
    <message>
        <source>The tool&apos;s solid in contact with the liver, and several tools at once. Otherwise the force is spread over a patch.</source>
        <translation>Der Körper des Instruments in Berührung mit der Leber, und mehrere Instrumente zugleich. Sonst verteilt sich die Kraft auf eine Fläche.</translation>
    </message>
    <message>
        <source>Several tools at once need rigid tools</source>
        <translation>Mehrere Instrumente zugleich gehen nur mit starren Instrumenten</translation>
    </message>
    <message>
        <source>Take the tool away</source>
        <translation>Instrument wegnehmen</translation>
    </message>
    <message>
        <source>From %1 N on, strains are outside of the model</source>
        <translation>Ab %1 N liegen die Dehnungen außerhalb des Modells</translation>
    </message>
    <message>
        <source>Add another tool</source>
        <translation>Weiteres Instrument</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TourCard</name>
    <message>
        <source>End the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TracePlot</name>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Power (W)</source>
        <translation>Leistung (W)</translation>
    </message>
    <message>
        <source>Power; shaded: a run</source>
        <translation>Leistung; hinterlegt: ein Lauf</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>Leerlauf</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TraceView</name>
    <message>
        <source>Close the recording</source>
        <translation>Aufzeichnung schließen</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Watts per unit</source>
        <translation>Watt je Einheit</translation>
    </message>
    <message>
        <source>1 where the column holds watts, 0.001 for milliwatts; for a current clamp its amperes per volt times the supply&apos;s voltage. Negative turns the sign.</source>
        <translation>1, wo die Spalte Watt enthält, 0.001 für Milliwatt; für eine Stromzange ihre Ampere je Volt mal Versorgungsspannung. Negativ kehrt das Vorzeichen um.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>rows, one a second</source>
        <translation>Zeilen, eine je Sekunde</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>Plan with it</source>
        <translation>Damit planen</translation>
    </message>
    <message>
        <source>Plan with it as %1</source>
        <translation>Damit planen als %1</translation>
    </message>
    <message>
        <source>Adds that platform once more, with the idle and active power of this recording</source>
        <translation>Fügt diese Plattform noch einmal hinzu, mit Leerlauf- und Lastleistung dieser Aufzeichnung</translation>
    </message>
    <message>
        <source>Idle %1 W, the median of the pauses. Under load %2 W more, the median of the runs (there are %3).</source>
        <translation>Leerlauf %1 W, der Median der Pausen. Unter Last %2 W mehr, der Median der Läufe (es sind %3).</translation>
    </message>
    <message>
        <source>%1 W on average, from %2 to %3 W.</source>
        <translation>%1 W im Mittel, von %2 bis %3 W.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TrackControls</name>
    <message>
        <source>❚❚ Freeze</source>
        <translation>❚❚ Einfrieren</translation>
    </message>
    <message>
        <source>Nothing moves the tool while you look around</source>
        <translation>Nichts bewegt das Instrument, während Sie sich umsehen</translation>
    </message>
    <message>
        <source>▶ Play</source>
        <translation>▶ Abspielen</translation>
    </message>
    <message>
        <source>Shows again what was done, from where the time stands; rests are cut to 1 s</source>
        <translation>Zeigt noch einmal, was getan wurde, ab der eingestellten Zeit; Pausen sind auf 1 s gekürzt</translation>
    </message>
    <message>
        <source>Any moment of this rehearsal, in seconds</source>
        <translation>Ein beliebiger Moment dieser Probe, in Sekunden</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Table...</source>
        <translation>Tabelle …</translation>
    </message>
    <message>
        <source>Saves every moment as CSV: tools, forces (N), landmarks (mm)</source>
        <translation>Speichert jeden Moment als CSV: Instrumente, Kräfte (N), Landmarken (mm)</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Forgets what was done so far; the tool stays</source>
        <translation>Vergisst, was bisher getan wurde; das Instrument bleibt</translation>
    </message>
    <message>
        <source>Stop (%1 %)</source>
        <translation>Anhalten (%1 %)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Save a movie of the rehearsal</source>
        <translation>Film der Probe speichern</translation>
    </message>
    <message>
        <source>Movies (*.mp4);;Folder of pictures (*)</source>
        <translation>Filme (*.mp4);;Ordner mit Bildern (*)</translation>
    </message>
    <message>
        <source>Save the rehearsal as a table</source>
        <translation>Probe als Tabelle speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 von %2 s</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>A movie of what the 3D view shows, MP4 or pictures</source>
        <translation>Ein Film dessen, was die 3D-Ansicht zeigt: MP4 oder Bilder</translation>
    </message>
    <message>
        <source>Move a tool first: there is nothing to show yet</source>
        <translation>Bewegen Sie zuerst ein Instrument: Es gibt noch nichts zu zeigen</translation>
    </message>
    <message>
        <source>Movie...</source>
        <translation>Film …</translation>
    </message>
    <message>
        <source>Stopped. No movie was written.</source>
        <translation>Angehalten. Es wurde kein Film geschrieben.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TrackPlot</name>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Atlas off</source>
        <translation>Atlas irrt</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>5 mm</source>
        <translation>5 mm</translation>
    </message>
    <message>
        <source>Moves at most</source>
        <translation>Bewegt sich höchstens</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TriangleHistory</name>
    <message>
        <source>A triangle over the frames</source>
        <translation>Ein Dreieck über die Bilder</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>The triangle of the left picture whose history is drawn; or click one in a picture</source>
        <translation>Das Dreieck des linken Bildes, dessen Verlauf gezeichnet wird; oder klicken Sie eines in einem Bild an</translation>
    </message>
    <message>
        <source>Error (mm)</source>
        <translation>Fehler (mm)</translation>
    </message>
    <message>
        <source>Motion (mm)</source>
        <translation>Bewegung (mm)</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The chosen triangle over the frames</source>
        <translation>Das gewählte Dreieck über die Bilder</translation>
    </message>
    <message>
        <source>Left: how far the registered corners are from where they are on the model, mm, with the tolerance as a dash-dotted line. Right: what SIRGn&apos;s correlation compares, the motion of the landmarks and of the registration&apos;s warp, mm</source>
        <translation>Links: wie weit die registrierten Ecken von ihrem Ort auf dem Modell entfernt sind, mm, mit der Toleranz als Strichpunktlinie. Rechts: was die Korrelation von SIRGn vergleicht, die Bewegung der Landmarken und die der Verformung, mm</translation>
    </message>
    <message>
        <source>Landmarks, %1</source>
        <translation>Landmarken, %1</translation>
    </message>
    <message>
        <source>Warp, %1</source>
        <translation>Verformung, %1</translation>
    </message>
    <message>
        <source>TRE (mm)</source>
        <translation>TRE (mm)</translation>
    </message>
    <message>
        <source>RMSE (mm)</source>
        <translation>RMSE (mm)</translation>
    </message>
    <message>
        <source>Each frame of the whole registration. Left: how far registered landmarks are from where they are on the model, mm, with the tolerance as a dash-dotted line. Right: how far the registered cloud is from the model (root mean square), mm</source>
        <translation>Jedes Bild der ganzen Registrierung. Links: wie weit registrierte Landmarken von ihrem Ort auf dem Modell entfernt sind, mm, mit der Toleranz als strichpunktierter Linie. Rechts: wie weit die registrierte Punktwolke vom Modell entfernt ist (quadratisches Mittel), mm</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TwoStageControls</name>
    <message>
        <source>Embolised</source>
        <translation>Embolisiert</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>The rest grows</source>
        <translation>Der Rest wächst</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>By how much what keeps its portal inflow grows until the cut. On average it was 37.9 % in 44 studies (van Lienden et al. 2013), less in a cirrhotic liver</source>
        <translation>Um wie viel bis zum Schnitt wächst, was seinen portalen Zufluss behält. Im Mittel waren es in 44 Studien 37.9 % (van Lienden et al. 2013), bei Zirrhose weniger</translation>
    </message>
    <message>
        <source>%1 ml lose their portal inflow and shrink.</source>
        <translation>%1 ml verlieren ihren portalen Zufluss und schrumpfen.</translation>
    </message>
    <message>
        <source>%1 ml of what stays grow to &lt;b&gt;%2 ml&lt;/b&gt;: %3 % of the liver without tumours, %4 % now.</source>
        <translation>%1 ml von dem, was bleibt, wachsen auf &lt;b&gt;%2 ml&lt;/b&gt;: %3 % der Leber ohne Tumoren, jetzt %4 %.</translation>
    </message>
    <message>
        <source>▲ %1 ml of the embolised tissue stay in the patient and are not counted.</source>
        <translation>▲ %1 ml des embolisierten Gewebes bleiben im Patienten und sind nicht gezählt.</translation>
    </message>
    <message>
        <source>An estimate by the growth above, not a forecast.</source>
        <translation>Eine Schätzung nach dem Wachstum oben, keine Vorhersage.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::Undo</name>
    <message>
        <source>Undone: %1</source>
        <translation>Rückgängig gemacht: %1</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>Wiederholt: %1</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::UnsurePlaces</name>
    <message>
        <source>Next unsure place</source>
        <translation>Nächste unsichere Stelle</translation>
    </message>
    <message>
        <source>Where is it unsure?</source>
        <translation>Wo ist es unsicher?</translation>
    </message>
    <message>
        <source>Goes to where the chosen outline lies on tissue that looks alike on both sides, as towards the heart</source>
        <translation>Geht dorthin, wo der gewählte Umriss auf Gewebe liegt, das zu beiden Seiten gleich aussieht, wie zum Herzen hin</translation>
    </message>
    <message>
        <source>Looking along the border...</source>
        <translation>Der Rand wird abgesucht ...</translation>
    </message>
    <message>
        <source>%1 % of the border looks alike on both sides. Place %2 of %3 lies under the crosshair: draw it as you see it.</source>
        <translation>%1 % des Randes sehen zu beiden Seiten gleich aus. Stelle %2 von %3 liegt unter dem Fadenkreuz: Zeichnen Sie dort, was Sie sehen.</translation>
    </message>
    <message>
        <source>No larger part of the border is unsure (%1 % in all).</source>
        <translation>Kein größeres Stück des Randes ist unsicher (%1 % insgesamt).</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::VesselClick</name>
    <message>
        <source>Lies at the crosshair</source>
        <translation>Liegt am Fadenkreuz</translation>
    </message>
    <message>
        <source>Put the crosshair on this vessel, in the middle of its course. Vessels and segments are found again by it</source>
        <translation>Setzen Sie das Fadenkreuz auf dieses Gefäß, in die Mitte seines Verlaufs. Gefäße und Segmente werden danach neu bestimmt</translation>
    </message>
    <message>
        <source>First stands the vessel whose place would tell most of the borders of segments</source>
        <translation>Zuerst steht das Gefäß, dessen Lage am meisten über die Grenzen der Segmente sagte</translation>
    </message>
    <message>
        <source>%1 (%2 ml in doubt)</source>
        <translation>%1 (%2 ml fraglich)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::VideoForm</name>
    <message>
        <source>Video</source>
        <translation>Video</translation>
    </message>
    <message>
        <source>Calibration of the camera</source>
        <translation>Kalibrierung der Kamera</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>From frame</source>
        <translation>Ab Bild</translation>
    </message>
    <message>
        <source>One frame in</source>
        <translation>Eines von</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>The first frame that is taken, counted from 1</source>
        <translation>Das erste Bild, das genommen wird, von 1 an gezählt</translation>
    </message>
    <message>
        <source>1 takes every frame, 5 every fifth</source>
        <translation>1 nimmt jedes Bild, 5 jedes fünfte</translation>
    </message>
    <message>
        <source>So many frames are taken at most; each takes up to a second</source>
        <translation>So viele Bilder werden höchstens genommen; jedes dauert bis zu einer Sekunde</translation>
    </message>
    <message>
        <source>Choose the video.</source>
        <translation>Wählen Sie das Video.</translation>
    </message>
    <message>
        <source>Choose the left eye&apos;s video.</source>
        <translation>Wählen Sie das Video des linken Auges.</translation>
    </message>
    <message>
        <source>Choose the right eye&apos;s video.</source>
        <translation>Wählen Sie das Video des rechten Auges.</translation>
    </message>
    <message>
        <source>Choose the camera&apos;s calibration.</source>
        <translation>Wählen Sie die Kalibrierung der Kamera.</translation>
    </message>
    <message>
        <source>Choose the pictures of the board.</source>
        <translation>Wählen Sie die Bilder der Tafel.</translation>
    </message>
    <message>
        <source>Say where to keep the sequence.</source>
        <translation>Sagen Sie, wo die Sequenz aufbewahrt wird.</translation>
    </message>
    <message>
        <source>A video file, or a folder of its pictures</source>
        <translation>Eine Videodatei oder ein Ordner mit ihren Bildern</translation>
    </message>
    <message>
        <source>Two videos, one for each eye</source>
        <translation>Zwei Videos, eines für jedes Auge</translation>
    </message>
    <message>
        <source>One video, left eye on the left</source>
        <translation>Ein Video, linkes Auge links</translation>
    </message>
    <message>
        <source>One video, left eye on the right</source>
        <translation>Ein Video, linkes Auge rechts</translation>
    </message>
    <message>
        <source>One video, left eye above</source>
        <translation>Ein Video, linkes Auge oben</translation>
    </message>
    <message>
        <source>How the video shows both eyes</source>
        <translation>Wie das Video beide Augen zeigt</translation>
    </message>
    <message>
        <source>How the video, and the pictures of a board, show both eyes</source>
        <translation>Wie das Video und die Bilder einer Tafel beide Augen zeigen</translation>
    </message>
    <message>
        <source>Left eye</source>
        <translation>Linkes Auge</translation>
    </message>
    <message>
        <source>Right eye</source>
        <translation>Rechtes Auge</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>Aus einer Datei</translation>
    </message>
    <message>
        <source>From pictures of a board</source>
        <translation>Aus Bildern einer Tafel</translation>
    </message>
    <message>
        <source>Where the calibration comes from</source>
        <translation>Woher die Kalibrierung kommt</translation>
    </message>
    <message>
        <source>Without a calibration, take pictures of a flat board with both eyes, from several sides</source>
        <translation>Ohne Kalibrierung nehmen Sie eine ebene Tafel mit beiden Augen von mehreren Seiten auf</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>JSON, OpenCV&apos;s YAML or XML, or a folder of text files</source>
        <translation>JSON, YAML oder XML von OpenCV, oder ein Ordner mit Textdateien</translation>
    </message>
    <message>
        <source>A folder of pictures or a video: the same board, from at least three sides; ten are better</source>
        <translation>Ein Ordner mit Bildern oder ein Video: dieselbe Tafel von mindestens drei Seiten; zehn sind besser</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>Grid of circles</source>
        <translation>Gitter aus Kreisen</translation>
    </message>
    <message>
        <source>Grid of circles, four of them larger</source>
        <translation>Gitter aus Kreisen, vier davon größer</translation>
    </message>
    <message>
        <source>Kind of board</source>
        <translation>Art der Tafel</translation>
    </message>
    <message>
        <source>What is printed on the board</source>
        <translation>Was auf die Tafel gedruckt ist</translation>
    </message>
    <message>
        <source>Inner corners, columns by rows</source>
        <translation>Innere Ecken, Spalten mal Zeilen</translation>
    </message>
    <message>
        <source>Circles, columns by rows</source>
        <translation>Kreise, Spalten mal Zeilen</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Seite eines Feldes</translation>
    </message>
    <message>
        <source>From circle to circle</source>
        <translation>Von Kreis zu Kreis</translation>
    </message>
    <message>
        <source>Along a row: a board of 10 x 7 squares has 9 x 6 inner corners</source>
        <translation>Eine Tafel von 10 x 7 Feldern hat 9 x 6 innere Ecken</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Measure it: all lengths of the sequence follow from it</source>
        <translation>Messen Sie nach: Alle Längen der Sequenz folgen daraus</translation>
    </message>
    <message>
        <source>Keep it in</source>
        <translation>Aufbewahren in</translation>
    </message>
    <message>
        <source>A new folder for the clouds, tracks and pictures</source>
        <translation>Ein neuer Ordner für Punktwolken, Spuren und Bilder</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ViewBar</name>
    <message>
        <source>Measure a &amp;distance</source>
        <translation>A&amp;bstand messen</translation>
    </message>
    <message>
        <source>A distance in mm: click its two ends, or press Enter at the crosshair; Escape gives up</source>
        <translation>Ein Abstand in mm: Klicken Sie auf seine beiden Enden, oder drücken Sie die Eingabetaste am Fadenkreuz; Esc bricht ab</translation>
    </message>
    <message>
        <source>Measure an &amp;angle</source>
        <translation>&amp;Winkel messen</translation>
    </message>
    <message>
        <source>An angle in degrees: click one side, the vertex, the other side</source>
        <translation>Ein Winkel in Grad: Klicken Sie auf einen Schenkel, den Scheitel, den anderen Schenkel</translation>
    </message>
    <message>
        <source>Measure a &amp;ball</source>
        <translation>&amp;Kugel messen</translation>
    </message>
    <message>
        <source>A ball&apos;s volume in ml: click its centre, then a point of its surface</source>
        <translation>Das Volumen einer Kugel in ml: Klicken Sie auf ihren Mittelpunkt, dann auf einen Punkt ihrer Oberfläche</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Lists the volume of a structure, in ml</source>
        <translation>Nimmt das Volumen einer Struktur in die Liste auf, in ml</translation>
    </message>
    <message>
        <source>&amp;Volume of</source>
        <translation>&amp;Volumen von</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Brightness and contrast of the slices. The presets are for CT; MR has no fixed scale.
By hand: drag with the right button</source>
        <translation>Helligkeit und Kontrast der Schichten. Die Voreinstellungen gelten für CT; MR hat keine feste Skala.
Von Hand: mit der rechten Taste ziehen</translation>
    </message>
    <message>
        <source>Brightness and contrast</source>
        <translation>Helligkeit und Kontrast</translation>
    </message>
    <message>
        <source>&amp;Next brightness and contrast</source>
        <translation>&amp;Nächste Helligkeit und Kontrast</translation>
    </message>
    <message>
        <source>Surgeon&apos;s &amp;side</source>
        <translation>&amp;Seite des Chirurgen</translation>
    </message>
    <message>
        <source>Turns the three slices to where the surgeon stands. By hand: drag the knobs of the crosshair, or Ctrl and drag</source>
        <translation>Dreht die drei Schichten dorthin, wo der Chirurg steht. Von Hand: an den Griffen des Fadenkreuzes ziehen, oder Strg und ziehen</translation>
    </message>
    <message>
        <source>&amp;Four views</source>
        <translation>&amp;Vier Ansichten</translation>
    </message>
    <message>
        <source>3D &amp;large</source>
        <translation>3D &amp;groß</translation>
    </message>
    <message>
        <source>T&amp;hree slices side by side</source>
        <translation>&amp;Drei Schichten nebeneinander</translation>
    </message>
    <message>
        <source>&amp;One view: the one in use</source>
        <translation>&amp;Eine Ansicht: die benutzte</translation>
    </message>
    <message>
        <source>Save the &amp;picture of the view in use...</source>
        <translation>&amp;Bild der benutzten Ansicht speichern …</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>What there is no room for here</source>
        <translation>Wofür hier kein Platz ist</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>S&amp;tandard planes</source>
        <translation>S&amp;tandardebenen</translation>
    </message>
    <message>
        <source>Transverse, coronal and sagittal slices again</source>
        <translation>Wieder transversale, koronare und sagittale Schichten</translation>
    </message>
    <message>
        <source>W %1  L %2</source>
        <translation>W %1  L %2</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ViewFrame</name>
    <message>
        <source>Show all four views</source>
        <translation>Alle vier Ansichten zeigen</translation>
    </message>
    <message>
        <source>Fill the window with this view</source>
        <translation>Fenster mit dieser Ansicht füllen</translation>
    </message>
    <message>
        <source>Save the picture of this view</source>
        <translation>Das Bild dieser Ansicht speichern</translation>
    </message>
    <message>
        <source>What there is no room for here</source>
        <translation>Wofür hier kein Platz ist</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::VisibleTable</name>
    <message>
        <source>Effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Without effect</source>
        <translation>Ohne Effekt</translation>
    </message>
    <message>
        <source>Seen from</source>
        <translation>Sichtbar ab</translation>
    </message>
    <message>
        <source>In nine of ten such experiments an effect of this size is seen</source>
        <translation>In neun von zehn solchen Experimenten ist ein Effekt dieser Größe zu sehen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>at no size</source>
        <translation>in keiner Größe</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::WaveView</name>
    <message>
        <source>Elastography waves</source>
        <translation>Elastographie-Wellen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>A defect in Glisson stopped this: %1</source>
        <translation>Ein Fehler in Glisson hat dies beendet: %1</translation>
    </message>
    <message>
        <source>Inverting the waves</source>
        <translation>Wellen werden invertiert</translation>
    </message>
    <message>
        <source>Saving the maps</source>
        <translation>Karten werden gespeichert</translation>
    </message>
    <message>
        <source>The case now holds this stiffness. Build its model anew to use it.</source>
        <translation>Der Fall enthält jetzt diese Steifigkeit. Erstellen Sie sein Modell neu, um sie zu verwenden.</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>as the images say</source>
        <translation>wie in den Bildern</translation>
    </message>
    <message>
        <source>&amp;Vibration</source>
        <translation>&amp;Schwingung</translation>
    </message>
    <message>
        <source>Complex modulus</source>
        <translation>Komplexer Modul</translation>
    </message>
    <message>
        <source>Local wavelength</source>
        <translation>Lokale Wellenlänge</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Verfahren</translation>
    </message>
    <message>
        <source>High-pass</source>
        <translation>Hochpass</translation>
    </message>
    <message>
        <source>Curl</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>&amp;Long waves</source>
        <translation>&amp;Lange Wellen</translation>
    </message>
    <message>
        <source>Compute the stiffness</source>
        <translation>Steifigkeit berechnen</translation>
    </message>
    <message>
        <source>Shear waves</source>
        <translation>Scherwellen</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>Shear stiffness</source>
        <translation>Schersteifigkeit</translation>
    </message>
    <message>
        <source>kPa</source>
        <translation>kPa</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Konfidenz</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Accept into the case</source>
        <translation>In den Fall übernehmen</translation>
    </message>
    <message>
        <source>Compute the stiffness from the waves that the case holds.</source>
        <translation>Berechnen Sie die Steifigkeit aus den Wellen, die der Fall enthält.</translation>
    </message>
    <message>
        <source>Shear stiffness %1 kPa on average over %2 confident voxels, %3 % of the region; middle half %4 to %5 kPa; vibration %6 Hz, wavelength %7 mm</source>
        <translation>Schersteifigkeit im Mittel %1 kPa über %2 vertrauenswürdige Voxel, %3 % der Region; mittlere Hälfte %4 bis %5 kPa; Schwingung %6 Hz, Wellenlänge %7 mm</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>Schicht %1 von %2</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::WelcomePage</name>
    <message>
        <source>Plan a liver operation</source>
        <translation>Eine Leberoperation planen</translation>
    </message>
    <message>
        <source>Drop a case or a folder of DICOM images here, or begin with the demo patient.</source>
        <translation>Ziehen Sie einen Fall oder einen Ordner mit DICOM-Bildern hierher, oder beginnen Sie mit dem Demopatienten.</translation>
    </message>
    <message>
        <source>Open the demo patient</source>
        <translation>Demopatienten öffnen</translation>
    </message>
    <message>
        <source>Open a case...</source>
        <translation>Fall öffnen …</translation>
    </message>
    <message>
        <source>Open images...</source>
        <translation>Bilder öffnen …</translation>
    </message>
    <message>
        <source>Opened before</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Glisson ended unexpectedly. Open %1 as it was</source>
        <translation>Glisson wurde unerwartet beendet. %1 öffnen, wie es war</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::WorkspaceBar</name>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation>%1 (Strg+%2)</translation>
    </message>
    <message>
        <source>Research</source>
        <translation>Forschung</translation>
    </message>
</context>
<context>
    <name>parameters</name>
    <message>
        <source>amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>center</source>
        <translation>Mittelpunkt</translation>
    </message>
    <message>
        <source>coefficient</source>
        <translation>Koeffizient</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>efficiency</source>
        <translation>Wirkungsgrad</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>Elevation</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>faster</source>
        <translation>schneller</translation>
    </message>
    <message>
        <source>foundation</source>
        <translation>Bettung</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>full load</source>
        <translation>Volllast</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>length scale</source>
        <translation>Längenmaßstab</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>loss</source>
        <translation>Verlust</translation>
    </message>
    <message>
        <source>loss ratio</source>
        <translation>Verlustverhältnis</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>resistance</source>
        <translation>Widerstand</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>slip strain</source>
        <translation>Gleitdehnung</translation>
    </message>
    <message>
        <source>slower</source>
        <translation>langsamer</translation>
    </message>
    <message>
        <source>static</source>
        <translation>Grundleistung</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>time constant</source>
        <translation>Zeitkonstante</translation>
    </message>
    <message>
        <source>translation</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>viscosity</source>
        <translation>Viskosität</translation>
    </message>
    <message>
        <source>zero</source>
        <translation>Nullpunkt</translation>
    </message>
</context>
<context>
    <name>patients</name>
    <message>
        <source>Demo patient</source>
        <translation>Demopatient</translation>
    </message>
</context>
<context>
    <name>structures</name>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>Cyst</source>
        <translation>Zyste</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>Hepatic vein</source>
        <translation>Lebervene</translation>
    </message>
    <message>
        <source>Artery</source>
        <translation>Arterie</translation>
    </message>
    <message>
        <source>Biliary tract</source>
        <translation>Gallenwege</translation>
    </message>
    <message>
        <source>Necrosis</source>
        <translation>Nekrose</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Gallenblase</translation>
    </message>
    <message>
        <source>Gastric vein</source>
        <translation>Magenvene</translation>
    </message>
    <message>
        <source>Aorta</source>
        <translation>Aorta</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Herz</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Magen</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Niere</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Milz</translation>
    </message>
    <message>
        <source>Pancreas</source>
        <translation>Pankreas</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Hilum</source>
        <translation>Leberhilus</translation>
    </message>
    <message>
        <source>Vena cava</source>
        <translation>Hohlvene</translation>
    </message>
    <message>
        <source>Duodenum</source>
        <translation>Zwölffingerdarm</translation>
    </message>
    <message>
        <source>Small bowel</source>
        <translation>Dünndarm</translation>
    </message>
    <message>
        <source>Colon</source>
        <translation>Dickdarm</translation>
    </message>
    <message>
        <source>Esophagus</source>
        <translation>Speiseröhre</translation>
    </message>
    <message>
        <source>Adrenal gland</source>
        <translation>Nebenniere</translation>
    </message>
    <message>
        <source>Kidney left</source>
        <translation>Niere links</translation>
    </message>
    <message>
        <source>Kidney right</source>
        <translation>Niere rechts</translation>
    </message>
    <message>
        <source>Adrenal gland left</source>
        <translation>Nebenniere links</translation>
    </message>
    <message>
        <source>Adrenal gland right</source>
        <translation>Nebenniere rechts</translation>
    </message>
    <message>
        <source>Planned cut</source>
        <translation>Geplanter Schnitt</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
</context>
<context>
    <name>studies</name>
    <message>
        <source>Landmarks under an atlas</source>
        <translation>Landmarken unter einem Atlas</translation>
    </message>
    <message>
        <source>How far a liver of one published stiffness misplaces a retracted liver&apos;s places, patient by patient (section 4.4).</source>
        <translation>Wie weit eine Leber mit einer veröffentlichten Steifigkeit die Stellen einer angehobenen Leber falsch legt, Patient für Patient (Abschnitt 4.4).</translation>
    </message>
    <message>
        <source>Stiffness of a cohort</source>
        <translation>Steifigkeit einer Kohorte</translation>
    </message>
    <message>
        <source>How stiffness varies between patients and within one, against the atlas (section 4.3).</source>
        <translation>Wie die Steifigkeit zwischen Patienten und in einem streut, gegen den Atlas (Abschnitt 4.3).</translation>
    </message>
    <message>
        <source>Beams of one liver</source>
        <translation>Balken einer Leber</translation>
    </message>
    <message>
        <source>Beams of a case&apos;s softest, stiffest and most uneven tissue against one of its mean (table 4.1).</source>
        <translation>Balken aus dem weichsten, steifsten und ungleichmäßigsten Gewebe eines Falls gegen einen aus seinem Mittel (Tabelle 4.1).</translation>
    </message>
    <message>
        <source>Shapes of livers</source>
        <translation>Formen von Lebern</translation>
    </message>
    <message>
        <source>A mean liver and its modes, from a folder of segmented livers, judged on livers left out.</source>
        <translation>Eine mittlere Leber und ihre Moden, aus einem Ordner segmentierter Lebern, beurteilt an ausgelassenen Lebern.</translation>
    </message>
    <message>
        <source>Pressed phantoms</source>
        <translation>Gedrückte Phantome</translation>
    </message>
    <message>
        <source>Silicone pressed by a tool: the simulated surface against the scanned one (section 4.5). Without scans, SIMULATED ones.</source>
        <translation>Silikon, von einem Werkzeug gedrückt: die simulierte Oberfläche gegen die gescannte (Abschnitt 4.5). Ohne Scans SIMULIERTE.</translation>
    </message>
    <message>
        <source>Stiffness against a testing machine</source>
        <translation>Steifigkeit gegen eine Prüfmaschine</translation>
    </message>
    <message>
        <source>Young&apos;s modulus by elastography beside a testing machine&apos;s, by the dissertation&apos;s own figures (section 4.6).</source>
        <translation>Elastizitätsmodul aus Elastographie neben dem einer Prüfmaschine, nach den eigenen Zahlen der Dissertation (Abschnitt 4.6).</translation>
    </message>
    <message>
        <source>Error against resolution</source>
        <translation>Fehler gegen Auflösung</translation>
    </message>
    <message>
        <source>How much of a beam&apos;s deflection a coarse model misses (section 6.3.2): what Platform plans by.</source>
        <translation>Wie viel von der Durchbiegung eines Balkens einem groben Modell entgeht (Abschnitt 6.3.2): danach plant Plattform.</translation>
    </message>
    <message>
        <source>Matching of shapes</source>
        <translation>Zuordnen von Formen</translation>
    </message>
    <message>
        <source>Energy, bits, memory and time of matching two surfaces (chapter 3), on SIMULATED livers.</source>
        <translation>Energie, Bits, Speicher und Zeit beim Zuordnen zweier Oberflächen (Kapitel 3), an SIMULIERTEN Lebern.</translation>
    </message>
    <message>
        <source>Data in place of a law</source>
        <translation>Daten statt eines Gesetzes</translation>
    </message>
    <message>
        <source>A SIMULATED liver retracted straight from measured strain and stress, beside lines fitted to them (chapter 5).</source>
        <translation>Eine SIMULIERTE Leber, unmittelbar aus gemessener Dehnung und Spannung weggehalten, neben angepassten Geraden (Kapitel 5).</translation>
    </message>
</context>
<context>
    <name>tour</name>
    <message>
        <source>Study: the images</source>
        <translation>Studie: die Bilder</translation>
    </message>
    <message>
        <source>Every case begins with its images. Drop a DICOM folder on the window: Glisson proposes what each series is for, and you correct it. Here you also see what a case still lacks.</source>
        <translation>Jeder Fall beginnt mit seinen Bildern. Ziehen Sie einen DICOM-Ordner auf das Fenster: Glisson schlägt vor, wozu jede Serie dient, und Sie berichtigen es. Hier sehen Sie auch, was einem Fall noch fehlt.</translation>
    </message>
    <message>
        <source>Segment: what is where</source>
        <translation>Segmentieren: was wo liegt</translation>
    </message>
    <message>
        <source>The liver, its vessels and tumours as coloured outlines in the slices. Paint, erase, grow and smooth; every step can be undone, even after the case was closed.</source>
        <translation>Die Leber, ihre Gefäße und Tumoren als farbige Umrisse in den Schichten. Malen, radieren, wachsen lassen und glätten; jeder Schritt lässt sich rückgängig machen, auch nachdem der Fall geschlossen war.</translation>
    </message>
    <message>
        <source>Model: how stiff each part is</source>
        <translation>Modell: wie steif jeder Teil ist</translation>
    </message>
    <message>
        <source>The liver becomes tetrahedra, and each gets the patient&apos;s own stiffness from MR elastography. What holds the liver in place is shown too.</source>
        <translation>Die Leber wird zu Tetraedern, und jedes bekommt die eigene Steifigkeit des Patienten aus der MR-Elastographie. Auch was die Leber hält, ist zu sehen.</translation>
    </message>
    <message>
        <source>Rehearse: pull, and see</source>
        <translation>Proben: ziehen und sehen</translation>
    </message>
    <message>
        <source>Resect: what is left</source>
        <translation>Resektion: was übrig bleibt</translation>
    </message>
    <message>
        <source>A cutting surface divides the liver: volumes of specimen and remnant, the smallest margin to each tumour, and the vessels that are crossed.</source>
        <translation>Eine Schnittfläche teilt die Leber: Volumen von Resektat und Rest, der kleinste Abstand zu jedem Tumor und die Gefäße, die gekreuzt werden.</translation>
    </message>
    <message>
        <source>Register: can the overlay be trusted</source>
        <translation>Registrieren: ist der Überlagerung zu trauen</translation>
    </message>
    <message>
        <source>Laparoscopic video is registered to the model, and SIRGn shows on each triangle how well, for one algorithm or two side by side.</source>
        <translation>Laparoskopisches Video wird auf das Modell registriert, und SIRGn zeigt auf jedem Dreieck, wie gut, für einen Algorithmus oder zwei nebeneinander.</translation>
    </message>
    <message>
        <source>Platform: what to wear</source>
        <translation>Plattform: was zu tragen ist</translation>
    </message>
    <message>
        <source>Which wearable computer carries this case for as long as the operation takes: frames a second, battery and heat, and why the others do not.</source>
        <translation>Welcher am Körper getragene Rechner diesen Fall so lange bewältigt, wie die Operation dauert: Bilder pro Sekunde, Akku und Wärme, und warum die anderen es nicht tun.</translation>
    </message>
    <message>
        <source>Evidence: where the model is wrong</source>
        <translation>Befunde: wo das Modell irrt</translation>
    </message>
    <message>
        <source>Measurements are held against the model. What it cannot explain is traced to a cause; you accept that cause for this patient, and can take it back.</source>
        <translation>Messungen werden dem Modell gegenübergestellt. Was es nicht erklären kann, wird auf eine Ursache zurückgeführt; Sie übernehmen sie für diesen Patienten und können sie zurücknehmen.</translation>
    </message>
    <message>
        <source>Report: one page</source>
        <translation>Bericht: eine Seite</translation>
    </message>
    <message>
        <source>All that was done for this patient, to read, save or print. The name is masked unless you ask for it in the settings.</source>
        <translation>Alles, was für diesen Patienten getan wurde, zum Lesen, Speichern oder Drucken. Der Name ist verdeckt, außer Sie verlangen ihn in den Einstellungen.</translation>
    </message>
    <message>
        <source>A retractor hoists segment VI. Change the force, or place the tool elsewhere by a click: the table follows each tumour and vessel, and marks what is 5 mm or more off.</source>
        <translation>Ein Retraktor hebt Segment VI an. Ändern Sie die Kraft, oder setzen Sie das Instrument per Klick anderswo an: Die Tabelle folgt jedem Tumor und Gefäß und markiert, was 5 mm oder mehr abweicht.</translation>
    </message>
    <message>
        <source>Guide: where the tumour is now</source>
        <translation>Führen: wo der Tumor jetzt liegt</translation>
    </message>
    <message>
        <source>The liver is found on the frames of a laparoscope&apos;s video and follows them. Tumours and vessels are drawn where they lie, dashed where they are not to be trusted.</source>
        <translation>Die Leber wird auf den Bildern eines Laparoskops gefunden und folgt ihnen. Tumoren und Gefäße sind gezeichnet, wo sie liegen, gestrichelt, wo ihnen nicht zu trauen ist.</translation>
    </message>
</context>
<context>
    <name>vessels</name>
    <message>
        <source>Portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>Hepatic vein</source>
        <translation>Lebervene</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>mittlere</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>posterior</translation>
    </message>
    <message>
        <source>lateral</source>
        <translation>lateral</translation>
    </message>
    <message>
        <source>medial</source>
        <translation>medial</translation>
    </message>
    <message>
        <source>caudate</source>
        <translation>Caudatus</translation>
    </message>
    <message>
        <source>stem</source>
        <translation>Stamm</translation>
    </message>
    <message>
        <source>Middle hepatic vein</source>
        <translation>Mittlere Lebervene</translation>
    </message>
    <message>
        <source>Right hepatic vein</source>
        <translation>Rechte Lebervene</translation>
    </message>
    <message>
        <source>Umbilical portion of the left portal vein</source>
        <translation>Umbilikaler Teil der linken Pfortader</translation>
    </message>
    <message>
        <source>Left hepatic vein</source>
        <translation>Linke Lebervene</translation>
    </message>
    <message>
        <source>Hepatic artery</source>
        <translation>Leberarterie</translation>
    </message>
    <message>
        <source>Bile duct</source>
        <translation>Gallengang</translation>
    </message>
    <message>
        <source>outside the liver</source>
        <translation>außerhalb der Leber</translation>
    </message>
</context>
</TS>
