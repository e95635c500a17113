<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>AskPath</name>
    <message>
        <source>Take this folder</source>
        <translation>Tomar esta carpeta</translation>
    </message>
</context>
<context>
    <name>Workspace</name>
    <message>
        <source>Needs a model of the liver: build it first.</source>
        <translation>Necesita un modelo del hígado: constrúyalo primero.</translation>
    </message>
    <message>
        <source>The model is being prepared.</source>
        <translation>El modelo se está preparando.</translation>
    </message>
</context>
<context>
    <name>effects</name>
    <message>
        <source>Stiffer or softer throughout</source>
        <translation>Más rígido o más blando en todo</translation>
    </message>
    <message>
        <source>Stiffens as it deforms</source>
        <translation>Se endurece al deformarse</translation>
    </message>
    <message>
        <source>The support gives way</source>
        <translation>El apoyo cede</translation>
    </message>
    <message>
        <source>A hidden stiffer region</source>
        <translation>Una región más rígida oculta</translation>
    </message>
    <message>
        <source>Creeps under load</source>
        <translation>Fluye bajo carga</translation>
    </message>
    <message>
        <source>The force sensor is off</source>
        <translation>El sensor de fuerza se desvía</translation>
    </message>
    <message>
        <source>Camera and specimen misaligned</source>
        <translation>Cámara y muestra desalineadas</translation>
    </message>
    <message>
        <source>Stiffer along one direction</source>
        <translation>Más rígido en una dirección</translation>
    </message>
    <message>
        <source>A stiff capsule around it</source>
        <translation>Una cápsula rígida alrededor</translation>
    </message>
    <message>
        <source>Already loaded at the start</source>
        <translation>Ya cargado al principio</translation>
    </message>
    <message>
        <source>Softer once it was stretched</source>
        <translation>Más blando tras haberse estirado</translation>
    </message>
    <message>
        <source>Loading and unloading differ</source>
        <translation>La carga y la descarga difieren</translation>
    </message>
    <message>
        <source>Tension and compression differ</source>
        <translation>La tracción y la compresión difieren</translation>
    </message>
    <message>
        <source>The battery&apos;s own resistance</source>
        <translation>La resistencia propia de la batería</translation>
    </message>
    <message>
        <source>Less charge when emptied fast</source>
        <translation>Menos carga si se vacía rápido</translation>
    </message>
    <message>
        <source>It warms itself</source>
        <translation>Se calienta a sí mismo</translation>
    </message>
    <message>
        <source>Voltage falls as it empties</source>
        <translation>La tensión cae al vaciarse</translation>
    </message>
    <message>
        <source>Power drawn at rest</source>
        <translation>Potencia en reposo</translation>
    </message>
    <message>
        <source>Power drawn by the work</source>
        <translation>Potencia debida al trabajo</translation>
    </message>
    <message>
        <source>Slows down when hot</source>
        <translation>Se ralentiza al calentarse</translation>
    </message>
    <message>
        <source>Sheds heat better or worse</source>
        <translation>Disipa el calor mejor o peor</translation>
    </message>
    <message>
        <source>Takes time to warm up</source>
        <translation>Tarda en calentarse</translation>
    </message>
    <message>
        <source>Power lost in the supply</source>
        <translation>Pérdidas en la alimentación</translation>
    </message>
    <message>
        <source>A smooth correction, no cause</source>
        <translation>Una corrección suave, no una causa</translation>
    </message>
    <message>
        <source>Waves lose energy on their way</source>
        <translation>Las ondas pierden energía en su camino</translation>
    </message>
    <message>
        <source>Long waves that compress, besides shear waves</source>
        <translation>Ondas largas de compresión, además de las de corte</translation>
    </message>
    <message>
        <source>Slices seen at different moments</source>
        <translation>Cortes vistos en momentos distintos</translation>
    </message>
    <message>
        <source>Another stiffness along the border</source>
        <translation>Otra rigidez a lo largo del borde</translation>
    </message>
    <message>
        <source>Held where nothing was declared</source>
        <translation>Sujetado donde no se declaró nada</translation>
    </message>
    <message>
        <source>A declared attachment gives way or is missing</source>
        <translation>Una sujeción declarada cede o falta</translation>
    </message>
    <message>
        <source>The neo-Hookean law</source>
        <translation>La ley neo-hookeana</translation>
    </message>
    <message>
        <source>The law of Mooney and Rivlin</source>
        <translation>La ley de Mooney y Rivlin</translation>
    </message>
    <message>
        <source>The law of Gent and Thomas</source>
        <translation>La ley de Gent y Thomas</translation>
    </message>
    <message>
        <source>The law of Gent</source>
        <translation>La ley de Gent</translation>
    </message>
    <message>
        <source>The law of Arruda and Boyce</source>
        <translation>La ley de Arruda y Boyce</translation>
    </message>
    <message>
        <source>The law of Ogden</source>
        <translation>La ley de Ogden</translation>
    </message>
    <message>
        <source>The law of Isihara</source>
        <translation>La ley de Isihara</translation>
    </message>
    <message>
        <source>The law of Yeoh</source>
        <translation>La ley de Yeoh</translation>
    </message>
    <message>
        <source>Fibres along one direction</source>
        <translation>Fibras en una dirección</translation>
    </message>
    <message>
        <source>The law of Haines and Wilson</source>
        <translation>La ley de Haines y Wilson</translation>
    </message>
    <message>
        <source>Fibres along two directions (Holzapfel)</source>
        <translation>Fibras en dos direcciones (Holzapfel)</translation>
    </message>
</context>
<context>
    <name>entries</name>
    <message>
        <source>the image of the anatomy</source>
        <translation>la imagen de la anatomía</translation>
    </message>
    <message>
        <source>the stiffness map</source>
        <translation>el mapa de rigidez</translation>
    </message>
    <message>
        <source>the confidence map</source>
        <translation>el mapa de confianza</translation>
    </message>
    <message>
        <source>the mesh of the liver</source>
        <translation>la malla del hígado</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>el modelo</translation>
    </message>
    <message>
        <source>the accepted evidence</source>
        <translation>la evidencia aceptada</translation>
    </message>
    <message>
        <source>the vessel trees</source>
        <translation>los árboles vasculares</translation>
    </message>
    <message>
        <source>the map of the segments</source>
        <translation>el mapa de los segmentos</translation>
    </message>
    <message>
        <source>%1 (label %2)</source>
        <translation>%1 (etiqueta %2)</translation>
    </message>
    <message>
        <source>label %1</source>
        <translation>etiqueta %1</translation>
    </message>
</context>
<context>
    <name>errors</name>
    <message>
        <source>There is no column &quot;{0}&quot;.</source>
        <translation>No hay ninguna columna «{0}».</translation>
    </message>
    <message>
        <source>The columns are {1}.</source>
        <translation>Las columnas son {1}.</translation>
    </message>
    <message>
        <source>{0} has too many columns.</source>
        <translation>{0} tiene demasiadas columnas.</translation>
    </message>
    <message>
        <source>{0} holds no rows of numbers.</source>
        <translation>{0} no contiene ninguna fila de números.</translation>
    </message>
    <message>
        <source>The file {0} cannot be read.</source>
        <translation>No se puede leer el archivo {0}.</translation>
    </message>
    <message>
        <source>Check that it exists and that you may read it.</source>
        <translation>Compruebe que existe y que tiene permiso para leerlo.</translation>
    </message>
    <message>
        <source>{0} cannot be written: {1}.</source>
        <translation>No se puede escribir {0}: {1}.</translation>
    </message>
    <message>
        <source>Check the folder, your rights there and the free space.</source>
        <translation>Compruebe la carpeta, sus permisos en ella y el espacio libre.</translation>
    </message>
    <message>
        <source>The file {0} has {1} bytes; at most {2} are read.</source>
        <translation>El archivo {0} tiene {1} bytes; se leen como máximo {2}.</translation>
    </message>
    <message>
        <source>The files that ship with Glisson were not found.</source>
        <translation>No se han encontrado los archivos que acompañan a Glisson.</translation>
    </message>
    <message>
        <source>Set GLISSON_RESOURCES to the folder named resources.</source>
        <translation>Asigne a GLISSON_RESOURCES la ruta de la carpeta resources.</translation>
    </message>
    <message>
        <source>{0} is nested too deep to be one of our files.</source>
        <translation>{0} está anidado a demasiada profundidad para ser uno de nuestros archivos.</translation>
    </message>
    <message>
        <source>{0} is not valid JSON at line {1}.</source>
        <translation>{0} no es JSON válido en la línea {1}.</translation>
    </message>
    <message>
        <source>Look for a missing comma, quote or bracket there.</source>
        <translation>Busque ahí una coma, unas comillas o un corchete que falte.</translation>
    </message>
    <message>
        <source>{0} holds a number too large for a computer&apos;s arithmetic.</source>
        <translation>{0} contiene un número demasiado grande para la aritmética de un ordenador.</translation>
    </message>
    <message>
        <source>{0} should be an object in braces.</source>
        <translation>{0} debe ser un objeto entre llaves.</translation>
    </message>
    <message>
        <source>{0} has a key that is not known: &quot;{1}&quot;.</source>
        <translation>{0} tiene una clave desconocida: «{1}».</translation>
    </message>
    <message>
        <source>Did you mean &quot;{2}&quot;?</source>
        <translation>¿Quería decir «{2}»?</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Cancelado.</translation>
    </message>
    <message>
        <source>{0} is there already.</source>
        <translation>{0} ya existe.</translation>
    </message>
    <message>
        <source>Choose another name, or remove it first.</source>
        <translation>Elija otro nombre o elimínelo antes.</translation>
    </message>
    <message>
        <source>The folder {0} cannot be made: {1}.</source>
        <translation>No se puede crear la carpeta {0}: {1}.</translation>
    </message>
    <message>
        <source>it holds no case.json</source>
        <translation>no contiene case.json</translation>
    </message>
    <message>
        <source>case.json does not say &quot;format&quot;: &quot;glisson-case/1&quot;</source>
        <translation>case.json no indica &quot;format&quot;: &quot;glisson-case/1&quot;</translation>
    </message>
    <message>
        <source>The case {0} has no {1} yet.</source>
        <translation>El caso {0} no tiene todavía {1}.</translation>
    </message>
    <message>
        <source>Import a study first (glisson-cli import).</source>
        <translation>Importe antes un estudio (glisson-cli import).</translation>
    </message>
    <message>
        <source>Segment it first (glisson-cli segment).</source>
        <translation>Segméntelo antes (glisson-cli segment).</translation>
    </message>
    <message>
        <source>Mesh the liver first (glisson-cli mesh).</source>
        <translation>Malle antes el hígado (glisson-cli mesh).</translation>
    </message>
    <message>
        <source>{0} cannot be put in its place: {1}.</source>
        <translation>No se puede poner {0} en su lugar: {1}.</translation>
    </message>
    <message>
        <source>{0} is damaged: {1}.</source>
        <translation>{0} está dañado: {1}.</translation>
    </message>
    <message>
        <source>{0} is not a Glisson case: {1}.</source>
        <translation>{0} no es un caso de Glisson: {1}.</translation>
    </message>
    <message>
        <source>Make one with: glisson-cli import STUDY --case NAME.glisson</source>
        <translation>Cree uno con: glisson-cli import ESTUDIO --case NOMBRE.glisson</translation>
    </message>
    <message>
        <source>{0} holds nothing that could be written as {1}.</source>
        <translation>{0} no contiene nada que pueda escribirse como {1}.</translation>
    </message>
    <message>
        <source>Run the stage that makes it first.</source>
        <translation>Ejecute antes el paso que lo genera.</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Escribiendo</translation>
    </message>
    <message>
        <source>The study has no series {0}.</source>
        <translation>El estudio no tiene la serie {0}.</translation>
    </message>
    <message>
        <source>glisson-cli scan lists them.</source>
        <translation>glisson-cli scan las enumera.</translation>
    </message>
    <message>
        <source>{0} series could be the {1}:{2}</source>
        <translation>{0} series podrían ser {1}:{2}</translation>
    </message>
    <message>
        <source>Name one with {3} UID.</source>
        <translation>Indique una con {3} UID.</translation>
    </message>
    <message>
        <source>No series is recognised as the anatomy.{0}</source>
        <translation>No se reconoce ninguna serie como anatomía.{0}</translation>
    </message>
    <message>
        <source>glisson-cli scan says what is there, and what was skipped.</source>
        <translation>glisson-cli scan indica qué hay y qué se ha omitido.</translation>
    </message>
    <message>
        <source>Name one with --anatomy UID.</source>
        <translation>Indique una con --anatomy UID.</translation>
    </message>
    <message>
        <source>Reading the structures</source>
        <translation>Leyendo las estructuras</translation>
    </message>
    <message>
        <source>Saving the mesh</source>
        <translation>Guardando la malla</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>Leyendo la malla</translation>
    </message>
    <message>
        <source>Stiffness of each cell from the MRE map</source>
        <translation>Rigidez de cada celda a partir del mapa de ERM</translation>
    </message>
    <message>
        <source>A Young&apos;s modulus of {0} kPa is not possible.</source>
        <translation>Un módulo de Young de {0} kPa no es posible.</translation>
    </message>
    <message>
        <source>Saving the model</source>
        <translation>Guardando el modelo</translation>
    </message>
    <message>
        <source>Give the mesh its stiffness first (glisson-cli stiffness).</source>
        <translation>Dé antes a la malla su rigidez (glisson-cli stiffness).</translation>
    </message>
    <message>
        <source>The model of {0} has no stiffness.</source>
        <translation>El modelo de {0} no tiene rigidez.</translation>
    </message>
    <message>
        <source>Run glisson-cli stiffness again.</source>
        <translation>Ejecute de nuevo glisson-cli stiffness.</translation>
    </message>
    <message>
        <source>Import a study with MR elastography, or choose --uniform-kPa or --atlas.</source>
        <translation>Importe un estudio con elastografía por RM o elija --uniform-kPa o --atlas.</translation>
    </message>
    <message>
        <source>{0} does not hold a simulation&apos;s result: {1}.</source>
        <translation>{0} no contiene el resultado de una simulación: {1}.</translation>
    </message>
    <message>
        <source>Make one with glisson-cli simulate --out DIR.</source>
        <translation>Genere uno con glisson-cli simulate --out CARPETA.</translation>
    </message>
    <message>
        <source>result.vtu is missing</source>
        <translation>falta result.vtu</translation>
    </message>
    <message>
        <source>result.json does not say &quot;format&quot;: &quot;glisson-result/1&quot;</source>
        <translation>result.json no indica &quot;format&quot;: &quot;glisson-result/1&quot;</translation>
    </message>
    <message>
        <source>the computation did not converge</source>
        <translation>el cálculo no ha convergido</translation>
    </message>
    <message>
        <source>The growing left {0} out; it was added to the liver.</source>
        <translation>El crecimiento dejó fuera {0}; se ha añadido al hígado.</translation>
    </message>
    <message>
        <source>Reading the labels</source>
        <translation>Leyendo la segmentación</translation>
    </message>
    <message>
        <source>No voxel of label {0} in {1} lies inside the anatomy.</source>
        <translation>Ningún vóxel de la etiqueta {0} de {1} está dentro de la anatomía.</translation>
    </message>
    <message>
        <source>Check that both belong to the same patient and frame of reference.</source>
        <translation>Compruebe que ambos pertenecen al mismo paciente y al mismo marco de referencia.</translation>
    </message>
    <message>
        <source>{0} has no labelled voxel.</source>
        <translation>{0} no tiene ningún vóxel etiquetado.</translation>
    </message>
    <message>
        <source>{0} has no label {2}; it holds {1}.</source>
        <translation>{0} no tiene la etiqueta {2}; contiene {1}.</translation>
    </message>
    <message>
        <source>{0} holds several labels: {1}.</source>
        <translation>{0} contiene varias etiquetas: {1}.</translation>
    </message>
    <message>
        <source>Choose one with --label-value.</source>
        <translation>Elija una con --label-value.</translation>
    </message>
    <message>
        <source>The magnitude images do not lie on the grid of the waves.</source>
        <translation>Las imágenes de magnitud no están en la cuadrícula de las ondas.</translation>
    </message>
    <message>
        <source>{0} holds no wave or phase images.</source>
        <translation>{0} no contiene imágenes de ondas ni de fase.</translation>
    </message>
    <message>
        <source>Import the phase series of an elastography scan (glisson-cli import --phase).</source>
        <translation>Importe la serie de fase de una elastografía (glisson-cli import --phase).</translation>
    </message>
    <message>
        <source>Reading the waves</source>
        <translation>Leyendo las ondas</translation>
    </message>
    <message>
        <source>Saving the maps</source>
        <translation>Guardando los mapas</translation>
    </message>
    <message>
        <source>{0} is not an experiment of the format &quot;glisson-experiment/1&quot;.</source>
        <translation>{0} no es un experimento con el formato &quot;glisson-experiment/1&quot;.</translation>
    </message>
    <message>
        <source>An experiment begins with &quot;format&quot;: &quot;glisson-experiment/1&quot; and &quot;kind&quot;.</source>
        <translation>Un experimento empieza por &quot;format&quot;: &quot;glisson-experiment/1&quot; y &quot;kind&quot;.</translation>
    </message>
    <message>
        <source>There is no kind of experiment called &quot;{0}&quot;.</source>
        <translation>No hay ningún tipo de experimento llamado «{0}».</translation>
    </message>
    <message>
        <source>Line {0} of {1} names {2}, which is not there.</source>
        <translation>La línea {0} de {1} nombra {2}, que no existe.</translation>
    </message>
    <message>
        <source>Files are looked for beside the experiment: was it copied without them, or is the name misspelt?</source>
        <translation>Los archivos se buscan junto al experimento: ¿se copió sin ellos o está mal escrito el nombre?</translation>
    </message>
    <message>
        <source>{0} lacks &quot;{1}&quot;.</source>
        <translation>A {0} le falta &quot;{1}&quot;.</translation>
    </message>
    <message>
        <source>{0} must be a finite number.</source>
        <translation>{0} debe ser un número finito.</translation>
    </message>
    <message>
        <source>{0} must be above zero.</source>
        <translation>{0} debe ser mayor que cero.</translation>
    </message>
    <message>
        <source>{0} must be a text in quotes.</source>
        <translation>{0} debe ser un texto entre comillas.</translation>
    </message>
    <message>
        <source>{0} must be three numbers [x, y, z].</source>
        <translation>{0} debe constar de tres números [x, y, z].</translation>
    </message>
    <message>
        <source>&quot;trials&quot; must be a list with at least one trial.</source>
        <translation>&quot;trials&quot; debe ser una lista con al menos un ensayo.</translation>
    </message>
    <message>
        <source>{0} must be an object in braces.</source>
        <translation>{0} debe ser un objeto entre llaves.</translation>
    </message>
    <message>
        <source>Two trials have the id &quot;{0}&quot;.</source>
        <translation>Dos ensayos tienen el identificador «{0}».</translation>
    </message>
    <message>
        <source>{0} has no column &quot;{1}&quot;, which the experiment names for {2}; line {3} has: {4}.</source>
        <translation>{0} no tiene la columna «{1}», que el experimento nombra para {2}; la línea {3} tiene: {4}.</translation>
    </message>
    <message>
        <source>Is the name misspelt, or is this the table of another trial?</source>
        <translation>¿Está mal escrito el nombre o es la tabla de otro ensayo?</translation>
    </message>
    <message>
        <source>Line {0} of {1} has no number under &quot;{2}&quot;.</source>
        <translation>La línea {0} de {1} no tiene ningún número en «{2}».</translation>
    </message>
    <message>
        <source>Is the table cut off, or written with decimal commas?</source>
        <translation>¿Está cortada la tabla o escrita con comas decimales?</translation>
    </message>
    <message>
        <source>Time goes back at line {0} of {1}: from {2} s to {3} s.</source>
        <translation>El tiempo retrocede en la línea {0} de {1}: de {2} s a {3} s.</translation>
    </message>
    <message>
        <source>Are two recordings in one table, or is this not the column of times?</source>
        <translation>¿Hay dos registros en una tabla o no es esta la columna de los tiempos?</translation>
    </message>
    <message>
        <source>{0} is {1} kPa, stiffer than any soft tissue.</source>
        <translation>{0} es {1} kPa, más rígido que cualquier tejido blando.</translation>
    </message>
    <message>
        <source>Was it given in Pa?</source>
        <translation>¿Se indicó en Pa?</translation>
    </message>
    <message>
        <source>Use the model.json that glisson-cli explain wrote for an experiment of this kind.</source>
        <translation>Use el model.json que glisson-cli explain escribió para un experimento de este tipo.</translation>
    </message>
    <message>
        <source>{0} is not a model of the format {1}.</source>
        <translation>{0} no es un modelo con el formato {1}.</translation>
    </message>
    <message>
        <source>{0} was not learnt from an experiment of the kind {1}.</source>
        <translation>{0} no se aprendió de un experimento del tipo {1}.</translation>
    </message>
    <message>
        <source>{0} is not a complete model.</source>
        <translation>{0} no es un modelo completo.</translation>
    </message>
    <message>
        <source>The effect {0} is unknown to this experiment.</source>
        <translation>El efecto {0} es desconocido para este experimento.</translation>
    </message>
    <message>
        <source>{0} of {1} is no number.</source>
        <translation>{0} de {1} no es un número.</translation>
    </message>
    <message>
        <source>The smooth correction was made for other quantities than this experiment has.</source>
        <translation>La corrección suave se hizo para otras magnitudes que las de este experimento.</translation>
    </message>
    <message>
        <source>The smooth correction is not complete.</source>
        <translation>La corrección suave no está completa.</translation>
    </message>
    <message>
        <source>The search for parameters failed: {0}.</source>
        <translation>La búsqueda de parámetros ha fallado: {0}.</translation>
    </message>
    <message>
        <source>The model has no solution where the search ended.</source>
        <translation>El modelo no tiene solución donde terminó la búsqueda.</translation>
    </message>
    <message>
        <source>This experiment proposes no further trials.</source>
        <translation>Este experimento no propone más ensayos.</translation>
    </message>
    <message>
        <source>The specimen is stiffer or softer than declared, everywhere and at every load.</source>
        <translation>La muestra es más rígida o más blanda de lo declarado, en todas partes y con cualquier carga.</translation>
    </message>
    <message>
        <source>The specimen is not equally stiff under tension and under compression.</source>
        <translation>La muestra no es igual de rígida a tracción que a compresión.</translation>
    </message>
    <message>
        <source>The tissue gets stiffer (or softer) the further it is deformed: its law is not a straight line.</source>
        <translation>El tejido se vuelve más rígido (o más blando) cuanto más se deforma: su ley no es una recta.</translation>
    </message>
    <message>
        <source>The tissue gives way slowly under a load that is held, and recovers slowly after it.</source>
        <translation>El tejido cede despacio bajo una carga mantenida y se recupera despacio después.</translation>
    </message>
    <message>
        <source>Once stretched, the tissue stays softer up to the deformation that it has seen (Mullins effect).</source>
        <translation>Una vez estirado, el tejido queda más blando hasta la deformación ya sufrida (efecto Mullins).</translation>
    </message>
    <message>
        <source>Less force comes back on the way out than went in on the way in, in every cycle and at any speed.</source>
        <translation>A la vuelta se recupera menos fuerza que la aplicada a la ida, en cada ciclo y a cualquier velocidad.</translation>
    </message>
    <message>
        <source>The load cell is at fault: it does not read zero without load, or its scale is off.</source>
        <translation>La célula de carga falla: no marca cero sin carga o su escala no es correcta.</translation>
    </message>
    <message>
        <source>The specimen was already loaded when the test began.</source>
        <translation>La muestra ya estaba cargada cuando empezó el ensayo.</translation>
    </message>
    <message>
        <source>The mode &quot;{0}&quot; is not known.</source>
        <translation>El modo «{0}» no se conoce.</translation>
    </message>
    <message>
        <source>The modes are compression, tension and shear.</source>
        <translation>Los modos son compression, tension y shear.</translation>
    </message>
    <message>
        <source>The declared law &quot;{0}&quot; is not known.</source>
        <translation>La ley declarada «{0}» no se conoce.</translation>
    </message>
    <message>
        <source>The laws are linear and neo-hookean.</source>
        <translation>Las leyes son linear y neo-hookean.</translation>
    </message>
    <message>
        <source>{0} gives &quot;{1}&quot;, which needs the specimen&apos;s {2}.</source>
        <translation>{0} indica &quot;{1}&quot;, que necesita {2} de la muestra.</translation>
    </message>
    <message>
        <source>Give the specimen&apos;s diameter_mm (or width_mm and thickness_mm, or area_mm2) and height_mm.</source>
        <translation>Indique diameter_mm de la muestra (o width_mm y thickness_mm, o area_mm2) y height_mm.</translation>
    </message>
    <message>
        <source>In {0} stress and strain mostly have opposite signs.</source>
        <translation>En {0} la tensión y la deformación tienen casi siempre signos opuestos.</translation>
    </message>
    <message>
        <source>In compression stretch is below 1, and displacement, force and stress are negative.</source>
        <translation>En compresión el estiramiento es menor que 1, y el desplazamiento, la fuerza y la tensión son negativos.</translation>
    </message>
    <message>
        <source>{0} names no column for &quot;stretch&quot; or &quot;displacement_mm&quot;.</source>
        <translation>{0} no nombra ninguna columna para &quot;stretch&quot; o &quot;displacement_mm&quot;.</translation>
    </message>
    <message>
        <source>{0} names no column for &quot;stress_kPa&quot; or &quot;force_N&quot;.</source>
        <translation>{0} no nombra ninguna columna para &quot;stress_kPa&quot; o &quot;force_N&quot;.</translation>
    </message>
    <message>
        <source>Line {0} of {1} gives a stretch of {2}, which no specimen survives.</source>
        <translation>La línea {0} de {1} da un estiramiento de {2}, que ninguna muestra soporta.</translation>
    </message>
    <message>
        <source>Is it strain, or a percentage? Stretch is length over length at rest.</source>
        <translation>¿Es la deformación o un porcentaje? El estiramiento es la longitud dividida por la longitud en reposo.</translation>
    </message>
    <message>
        <source>The material law is used beyond the stretch it allows.</source>
        <translation>La ley del material se usa más allá del estiramiento que permite.</translation>
    </message>
    <message>
        <source>The specimen in {0} is {1} mm across.</source>
        <translation>La muestra de {0} mide {1} mm.</translation>
    </message>
    <message>
        <source>Is the mesh in metres or micrometres?</source>
        <translation>¿Está la malla en metros o en micrómetros?</translation>
    </message>
    <message>
        <source>{0} has no cell array &quot;{1}&quot; with one number a cell.</source>
        <translation>{0} no tiene una matriz de celdas «{1}» con un número por celda.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus must be above zero in every cell.</source>
        <translation>El módulo de Young debe ser mayor que cero en cada celda.</translation>
    </message>
    <message>
        <source>{0} must lie between -1 and 0.5, both excluded.</source>
        <translation>{0} debe estar entre -1 y 0.5, ambos excluidos.</translation>
    </message>
    <message>
        <source>Line 1 of {0} names no column &quot;{1}&quot;.</source>
        <translation>La línea 1 de {0} no nombra ninguna columna «{1}».</translation>
    </message>
    <message>
        <source>A table of markers has id, rest_x_mm, rest_y_mm, rest_z_mm, x_mm, y_mm, z_mm.</source>
        <translation>Una tabla de marcadores tiene id, rest_x_mm, rest_y_mm, rest_z_mm, x_mm, y_mm, z_mm.</translation>
    </message>
    <message>
        <source>{0} holds no markers.</source>
        <translation>{0} no contiene marcadores.</translation>
    </message>
    <message>
        <source>All markers of {0} lie within {1} mm (line 2 on), on a specimen of {2} mm.</source>
        <translation>Todos los marcadores de {0} caben en {1} mm (desde la línea 2), en una muestra de {2} mm.</translation>
    </message>
    <message>
        <source>Are they in metres?</source>
        <translation>¿Están en metros?</translation>
    </message>
    <message>
        <source>Line {0} of {1}: marker {2} lies {3} mm outside the specimen at rest.</source>
        <translation>Línea {0} de {1}: el marcador {2} está a {3} mm fuera de la muestra en reposo.</translation>
    </message>
    <message>
        <source>Are markers and mesh in one frame (patient coordinates) and both in mm?</source>
        <translation>¿Están los marcadores y la malla en el mismo sistema (coordenadas del paciente) y ambos en mm?</translation>
    </message>
    <message>
        <source>Line {0} of {1}: marker {2} moved by {3} mm, more than the specimen is long.</source>
        <translation>Línea {0} de {1}: el marcador {2} se ha movido {3} mm, más que la longitud de la muestra.</translation>
    </message>
    <message>
        <source>Are the positions in another unit or frame than the positions at rest?</source>
        <translation>¿Están las posiciones en otra unidad u otro sistema que las posiciones en reposo?</translation>
    </message>
    <message>
        <source>{0}: a force of {1} N presses no soft specimen.</source>
        <translation>{0}: una fuerza de {1} N no se ejerce sobre ninguna muestra blanda.</translation>
    </message>
    <message>
        <source>Was it given in mN?</source>
        <translation>¿Se indicó en mN?</translation>
    </message>
    <message>
        <source>{0} must not be zero.</source>
        <translation>{0} no debe ser cero.</translation>
    </message>
    <message>
        <source>Trial {0} (line {1} of {2}) has no samples.</source>
        <translation>El ensayo {0} (línea {1} de {2}) no tiene mediciones.</translation>
    </message>
    <message>
        <source>Was the recording interrupted?</source>
        <translation>¿Se interrumpió el registro?</translation>
    </message>
    <message>
        <source>In trial {0} (line {1} of {2}) time goes back at sample {3}.</source>
        <translation>En el ensayo {0} (línea {1} de {2}) el tiempo retrocede en la medición {3}.</translation>
    </message>
    <message>
        <source>Are two recordings in one trial?</source>
        <translation>¿Hay dos registros en un ensayo?</translation>
    </message>
    <message>
        <source>No sample of trial {0} (line {1} of {2}) names markers.</source>
        <translation>Ninguna medición del ensayo {0} (línea {1} de {2}) nombra marcadores.</translation>
    </message>
    <message>
        <source>Preparing the specimen</source>
        <translation>Preparando la muestra</translation>
    </message>
    <message>
        <source>No sample of the experiment has markers.</source>
        <translation>Ninguna medición del experimento tiene marcadores.</translation>
    </message>
    <message>
        <source>Solved the declared specimen</source>
        <translation>Muestra declarada resuelta</translation>
    </message>
    <message>
        <source>The specimen&apos;s equations are too badly conditioned to be solved.</source>
        <translation>Las ecuaciones de la muestra están demasiado mal condicionadas para resolverse.</translation>
    </message>
    <message>
        <source>No equilibrium of a specimen that stiffens so strongly was found under these loads.</source>
        <translation>No se ha encontrado equilibrio bajo estas cargas para una muestra que se rigidiza tanto.</translation>
    </message>
    <message>
        <source>The battery&apos;s voltage falls under load: its own resistance turns energy into heat.</source>
        <translation>La tensión de la batería cae con la carga: su resistencia interna convierte energía en calor.</translation>
    </message>
    <message>
        <source>The battery&apos;s voltage falls under load, and what is lost there is what warms it.</source>
        <translation>La tensión de la batería cae con la carga, y lo que allí se pierde es lo que la calienta.</translation>
    </message>
    <message>
        <source>The faster the battery is emptied, the less it gives (Peukert).</source>
        <translation>Cuanto más deprisa se vacía la batería, menos entrega (Peukert).</translation>
    </message>
    <message>
        <source>The battery gives less when it is cold and more when it is warm.</source>
        <translation>La batería entrega menos en frío y más en caliente.</translation>
    </message>
    <message>
        <source>The battery&apos;s voltage falls while it empties, which a constant voltage leaves out.</source>
        <translation>La tensión de la batería cae mientras se vacía, algo que una tensión constante no recoge.</translation>
    </message>
    <message>
        <source>The computer draws power whatever it does, more than was declared.</source>
        <translation>El ordenador consume, haga lo que haga, más potencia de la declarada.</translation>
    </message>
    <message>
        <source>A part of the power is lost in the supply before it reaches the computer.</source>
        <translation>Una parte de la potencia se pierde en la alimentación antes de llegar al ordenador.</translation>
    </message>
    <message>
        <source>The warmer the computer gets, the more power it draws.</source>
        <translation>Cuanto más se calienta el ordenador, más consume.</translation>
    </message>
    <message>
        <source>The work itself takes power that was not declared.</source>
        <translation>El propio trabajo consume una potencia que no se declaró.</translation>
    </message>
    <message>
        <source>The computer slows itself down to stay below a temperature.</source>
        <translation>El ordenador se ralentiza para no superar una temperatura.</translation>
    </message>
    <message>
        <source>Heat leaves the computer better or worse than declared.</source>
        <translation>El calor sale del ordenador mejor o peor de lo declarado.</translation>
    </message>
    <message>
        <source>The computer takes time to warm up, longer or shorter than declared.</source>
        <translation>El ordenador tarda en calentarse, más o menos de lo declarado.</translation>
    </message>
    <message>
        <source>&quot;noise&quot; names no quantity, so that nothing can be judged.</source>
        <translation>&quot;noise&quot; no nombra ninguna magnitud, de modo que no se puede juzgar nada.</translation>
    </message>
    <message>
        <source>Give voltage_V, temperature_C or power_W: the standard deviation of that reading.</source>
        <translation>Indique voltage_V, temperature_C o power_W: la desviación típica de esa lectura.</translation>
    </message>
    <message>
        <source>The law of platforms is constant: a battery that gives all of its energy at any load.</source>
        <translation>La ley de las plataformas es constante: una batería que entrega toda su energía con cualquier carga.</translation>
    </message>
    <message>
        <source>{0} must not be below zero.</source>
        <translation>{0} no debe ser menor que cero.</translation>
    </message>
    <message>
        <source>Line {0} of {1} gives a {2} of {3}, which no worn computer reaches.</source>
        <translation>La línea {0} de {1} da {2} = {3}, algo que ningún ordenador corporal alcanza.</translation>
    </message>
    <message>
        <source>{0} has no column for a quantity whose noise is given.</source>
        <translation>{0} no tiene columna para una magnitud cuyo ruido se indica.</translation>
    </message>
    <message>
        <source>The declared figures predict none of the recorded quantities.</source>
        <translation>Las cifras declaradas no predicen ninguna de las magnitudes registradas.</translation>
    </message>
    <message>
        <source>Voltage needs nominal_voltage_V, temperature needs thermal_resistance_C_per_W and a power, power needs a current or a load.</source>
        <translation>La tensión necesita nominal_voltage_V, la temperatura thermal_resistance_C_per_W y una potencia, la potencia una corriente o una carga.</translation>
    </message>
    <message>
        <source>The model of the platform has no finite answer here.</source>
        <translation>El modelo de la plataforma no tiene aquí una respuesta finita.</translation>
    </message>
    <message>
        <source>it is proportional to the prediction</source>
        <translation>es proporcional a la predicción</translation>
    </message>
    <message>
        <source>it changes with the load</source>
        <translation>cambia con la carga</translation>
    </message>
    <message>
        <source>it changes with time</source>
        <translation>cambia con el tiempo</translation>
    </message>
    <message>
        <source>it has a mean in some direction</source>
        <translation>tiene una media en alguna dirección</translation>
    </message>
    <message>
        <source>it changes across the specimen</source>
        <translation>cambia a lo largo de la muestra</translation>
    </message>
    <message>
        <source>it differs from trial to trial</source>
        <translation>difiere de un ensayo a otro</translation>
    </message>
    <message>
        <source>it is larger than the noise</source>
        <translation>es mayor que el ruido</translation>
    </message>
    <message>
        <source>neighbours are off in the same way</source>
        <translation>los vecinos se desvían del mismo modo</translation>
    </message>
    <message>
        <source>trying effects</source>
        <translation>probando efectos</translation>
    </message>
    <message>
        <source>Only an experiment whose trials are measured can be explained.</source>
        <translation>Solo se puede explicar un experimento cuyos ensayos se hayan medido.</translation>
    </message>
    <message>
        <source>predicting with the declared model</source>
        <translation>prediciendo con el modelo declarado</translation>
    </message>
    <message>
        <source>weighing the evidence</source>
        <translation>sopesando las pruebas</translation>
    </message>
    <message>
        <source>done</source>
        <translation>terminado</translation>
    </message>
    <message>
        <source>No voxel of the stiffness map is reliable: none is positive, confident, inside the organ and {0} mm away from its border at once.</source>
        <translation>Ningún vóxel del mapa de rigidez es fiable: ninguno es a la vez positivo, de confianza, interior al órgano y alejado {0} mm de su borde.</translation>
    </message>
    <message>
        <source>Check that map, confidence mask and segmentation belong together, or trust voxels nearer to the border.</source>
        <translation>Compruebe que el mapa, la máscara de confianza y la segmentación corresponden entre sí o acepte vóxeles más próximos al borde.</translation>
    </message>
    <message>
        <source>The model does not lie in the stiffness map: {0} mm are between their boxes (model around {1}, map around {2}).</source>
        <translation>El modelo no está dentro del mapa de rigidez: {0} mm separan sus cajas (modelo en torno a {1}, mapa en torno a {2}).</translation>
    </message>
    <message>
        <source>They are probably in different frames of reference: take the stiffness series of the same study, or register the two.</source>
        <translation>Probablemente están en marcos de referencia distintos: tome la serie de rigidez del mismo estudio o registre ambos.</translation>
    </message>
    <message>
        <source>There are no cells to give a stiffness to.</source>
        <translation>No hay celdas a las que dar una rigidez.</translation>
    </message>
    <message>
        <source>The stiffness map holds no voxels.</source>
        <translation>El mapa de rigidez no contiene vóxeles.</translation>
    </message>
    <message>
        <source>The axes of the stiffness map are not at right angles, so that the nearest voxel is not to be told.</source>
        <translation>Los ejes del mapa de rigidez no son perpendiculares, de modo que no se puede determinar el vóxel más próximo.</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio must lie in (-1, 0.5], the border must not be negative and the averaging length must be positive; they are {0}, {1} mm and {2} mm.</source>
        <translation>El coeficiente de Poisson debe estar en (-1, 0.5], el borde no debe ser negativo y la longitud de promediado debe ser positiva; son {0}, {1} mm y {2} mm.</translation>
    </message>
    <message>
        <source>There are no wave or phase images.</source>
        <translation>No hay imágenes de ondas ni de fase.</translation>
    </message>
    <message>
        <source>Unwrapping the phase</source>
        <translation>Desenrollando la fase</translation>
    </message>
    <message>
        <source>The waves give no signal inside the organ.</source>
        <translation>Las ondas no dan señal dentro del órgano.</translation>
    </message>
    <message>
        <source>Check that the segmentation and the wave images belong together.</source>
        <translation>Compruebe que la segmentación y las imágenes de ondas corresponden entre sí.</translation>
    </message>
    <message>
        <source>Inverting the waves</source>
        <translation>Invirtiendo las ondas</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Invertido</translation>
    </message>
    <message>
        <source>Not one voxel could be inverted with confidence: there is no wave in these images, or it drowns in noise.</source>
        <translation>No se ha podido invertir con confianza ni un solo vóxel: no hay onda en estas imágenes o se pierde en el ruido.</translation>
    </message>
    <message>
        <source>Check that the phase series and the frequency are the right ones.</source>
        <translation>Compruebe que la serie de fase y la frecuencia son las correctas.</translation>
    </message>
    <message>
        <source>The region lies on another voxel grid than the map.</source>
        <translation>La región está en otra cuadrícula de vóxeles que el mapa.</translation>
    </message>
    <message>
        <source>The region holds no value.</source>
        <translation>La región no contiene ningún valor.</translation>
    </message>
    <message>
        <source>The wave images do not all lie on one grid.</source>
        <translation>Las imágenes de ondas no están todas en una misma cuadrícula.</translation>
    </message>
    <message>
        <source>The headers do not say at which frequency the organ was shaken.</source>
        <translation>Las cabeceras no indican con qué frecuencia se hizo vibrar el órgano.</translation>
    </message>
    <message>
        <source>Give it with --frequency-Hz; liver scans mostly use 60.</source>
        <translation>Indíquela con --frequency-Hz; en el hígado suele ser 60.</translation>
    </message>
    <message>
        <source>A vibration of {0} Hz is not possible.</source>
        <translation>Una vibración de {0} Hz no es posible.</translation>
    </message>
    <message>
        <source>The headers do not say which of the {0} wave images belong to which direction.</source>
        <translation>Las cabeceras no indican cuáles de las {0} imágenes de ondas pertenecen a cada dirección.</translation>
    </message>
    <message>
        <source>Say how many directions were measured with --directions; mostly 1 or 3.</source>
        <translation>Indique con --directions cuántas direcciones se midieron; casi siempre 1 o 3.</translation>
    </message>
    <message>
        <source>{0} wave images cannot be shared out among {1} directions.</source>
        <translation>{0} imágenes de ondas no se pueden repartir entre {1} direcciones.</translation>
    </message>
    <message>
        <source>At {0} Hz direction {1} has {2} instants and the first direction {3}.</source>
        <translation>A {0} Hz la dirección {1} tiene {2} instantes y la primera dirección {3}.</translation>
    </message>
    <message>
        <source>Only {0} instants of the wave were measured; at least {1} are needed to tell the wave from noise.</source>
        <translation>Solo se midieron {0} instantes de la onda; hacen falta al menos {1} para distinguir la onda del ruido.</translation>
    </message>
    <message>
        <source>The curl needs the motion along three known directions, in at least three slices.</source>
        <translation>El rotacional necesita el movimiento en tres direcciones conocidas, en al menos tres cortes.</translation>
    </message>
    <message>
        <source>Take long waves off with the high-pass instead.</source>
        <translation>Elimine en su lugar las ondas largas con el paso alto.</translation>
    </message>
    <message>
        <source>A cutting plane needs a finite point and a normal that is not zero.</source>
        <translation>Un plano de corte necesita un punto finito y una normal distinta de cero.</translation>
    </message>
    <message>
        <source>A cutting sheet needs 3 to {0} points; there are {1}.</source>
        <translation>Una superficie de corte necesita de 3 a {0} puntos; hay {1}.</translation>
    </message>
    <message>
        <source>A point of the cutting sheet is not finite.</source>
        <translation>Un punto de la superficie de corte no es finito.</translation>
    </message>
    <message>
        <source>The points of the cutting sheet lie almost on a line, which does not say which way to cut: add points away from it, or give a plane.</source>
        <translation>Los puntos de la superficie de corte están casi alineados, lo que no indica cómo cortar: añada puntos fuera de la línea o indique un plano.</translation>
    </message>
    <message>
        <source>Points {0} and {1} of the cutting sheet lie above each other: no smooth sheet over their plane passes through both.</source>
        <translation>Los puntos {0} y {1} de la superficie de corte están uno sobre otro: ninguna superficie suave sobre su plano pasa por ambos.</translation>
    </message>
    <message>
        <source>No smooth sheet passes through the points of the cut.</source>
        <translation>Ninguna superficie suave pasa por los puntos de la sección.</translation>
    </message>
    <message>
        <source>The surface is in pieces, between which there is no way along it.</source>
        <translation>La superficie está en trozos entre los que no hay camino sobre ella.</translation>
    </message>
    <message>
        <source>Keep its largest piece.</source>
        <translation>Conserve su trozo mayor.</translation>
    </message>
    <message>
        <source>Triangle {0} does not fit its neighbours: an edge has more than two triangles, or they are turned against each other.</source>
        <translation>El triángulo {0} no encaja con sus vecinos: una arista tiene más de dos triángulos o están orientados al revés.</translation>
    </message>
    <message>
        <source>Heat cannot spread over the surface: it has flat triangles.</source>
        <translation>El calor no puede propagarse por la superficie: tiene triángulos planos.</translation>
    </message>
    <message>
        <source>{0} cannot be read as a mesh: {1}.</source>
        <translation>No se puede leer {0} como malla: {1}.</translation>
    </message>
    <message>
        <source>Open it in ParaView to see whether it is damaged.</source>
        <translation>Ábralo en ParaView para ver si está dañado.</translation>
    </message>
    <message>
        <source>it names no dataset</source>
        <translation>no nombra ningún conjunto de datos</translation>
    </message>
    <message>
        <source>its points are not all there</source>
        <translation>no están todos sus puntos</translation>
    </message>
    <message>
        <source>its cell types are not all there</source>
        <translation>no están todos sus tipos de celda</translation>
    </message>
    <message>
        <source>it has not as many cell types as cells</source>
        <translation>no tiene tantos tipos de celda como celdas</translation>
    </message>
    <message>
        <source>a field says not how many arrays it has</source>
        <translation>un campo no indica cuántas matrices tiene</translation>
    </message>
    <message>
        <source>an array before its cells is not all there, or is text</source>
        <translation>una matriz anterior a sus celdas no está completa o es texto</translation>
    </message>
    <message>
        <source>{0} has no extension that is known for such a mesh.</source>
        <translation>{0} no tiene una extensión conocida para una malla así.</translation>
    </message>
    <message>
        <source>it holds no points</source>
        <translation>no contiene puntos</translation>
    </message>
    <message>
        <source>a cell names a point that does not exist</source>
        <translation>una celda nombra un punto que no existe</translation>
    </message>
    <message>
        <source>its polygons cannot be cut into triangles</source>
        <translation>sus polígonos no se pueden dividir en triángulos</translation>
    </message>
    <message>
        <source>Cell {1} of {0} is a {2} of {3} points; only tetrahedra are used.</source>
        <translation>La celda {1} de {0} es {2} de {3} puntos; solo se usan tetraedros.</translation>
    </message>
    <message>
        <source>Cut it into tetrahedra first, for example with ParaView&apos;s Tetrahedralize.</source>
        <translation>Divídala antes en tetraedros, por ejemplo con Tetrahedralize de ParaView.</translation>
    </message>
    <message>
        <source>it holds no tetrahedra</source>
        <translation>no contiene tetraedros</translation>
    </message>
    <message>
        <source>The header of {0} announces {1} items; a file of {2} bytes cannot hold them.</source>
        <translation>La cabecera de {0} anuncia {1} elementos; un archivo de {2} bytes no puede contenerlos.</translation>
    </message>
    <message>
        <source>The file is damaged or cut off; get it again from where it came.</source>
        <translation>El archivo está dañado o cortado; vuelva a obtenerlo de su origen.</translation>
    </message>
    <message>
        <source>Line {1} of {0} is neither a point nor a face.</source>
        <translation>La línea {1} de {0} no es ni un punto ni una cara.</translation>
    </message>
    <message>
        <source>Line {1} of {0} is not what an OFF file holds there.</source>
        <translation>La línea {1} de {0} no es lo que un archivo OFF contiene ahí.</translation>
    </message>
    <message>
        <source>its header is not that of a PLY file</source>
        <translation>su cabecera no es la de un archivo PLY</translation>
    </message>
    <message>
        <source>Point {0} of the surface has no finite position.</source>
        <translation>El punto {0} de la superficie no tiene una posición finita.</translation>
    </message>
    <message>
        <source>Triangle {0} names point {1}; the surface has {2} points.</source>
        <translation>El triángulo {0} nombra el punto {1}; la superficie tiene {2} puntos.</translation>
    </message>
    <message>
        <source>The surface holds no triangles.</source>
        <translation>La superficie no contiene triángulos.</translation>
    </message>
    <message>
        <source>The mesh holds no tetrahedra.</source>
        <translation>La malla no contiene tetraedros.</translation>
    </message>
    <message>
        <source>Tetrahedron {0} names point {1}; the mesh has {2} points.</source>
        <translation>El tetraedro {0} nombra el punto {1}; la malla tiene {2} puntos.</translation>
    </message>
    <message>
        <source>Point {0} of the mesh has no finite position.</source>
        <translation>El punto {0} de la malla no tiene una posición finita.</translation>
    </message>
    <message>
        <source>Tetrahedron {0} is flat or inside out: its volume is {1} mm3.</source>
        <translation>El tetraedro {0} es plano o está invertido: su volumen es {1} mm3.</translation>
    </message>
    <message>
        <source>The face of the points {0}, {1} and {2} belongs to {3} tetrahedra; at most two can.</source>
        <translation>La cara de los puntos {0}, {1} y {2} pertenece a {3} tetraedros; como máximo pueden ser dos.</translation>
    </message>
    <message>
        <source>The mesh falls in {0} parts that share no face, of {1} tetrahedra.</source>
        <translation>La malla se divide en {0} partes sin cara común, de {1} tetraedros.</translation>
    </message>
    <message>
        <source>Keep the largest part, or join them before meshing.</source>
        <translation>Conserve la parte mayor o únalas antes de mallar.</translation>
    </message>
    <message>
        <source>{0} is deflated as a whole, which is not read.</source>
        <translation>{0} está comprimido por completo (deflate), lo que no se lee.</translation>
    </message>
    <message>
        <source>Convert it first, for example with dcmconv +te.</source>
        <translation>Conviértalo antes, por ejemplo con dcmconv +te.</translation>
    </message>
    <message>
        <source>{0} is empty.</source>
        <translation>{0} está vacío.</translation>
    </message>
    <message>
        <source>{0} declares a length beyond its end in its first lines.</source>
        <translation>{0} declara en sus primeras líneas una longitud que rebasa su final.</translation>
    </message>
    <message>
        <source>{0} is no DICOM file, nor named as one of the volume files that are read.</source>
        <translation>{0} no es un archivo DICOM ni se llama como uno de los archivos de volumen que se leen.</translation>
    </message>
    <message>
        <source>The header of {0} is too large to be that of an image.</source>
        <translation>La cabecera de {0} es demasiado grande para ser la de una imagen.</translation>
    </message>
    <message>
        <source>{0} is damaged: an item stands outside a sequence at byte {1}.</source>
        <translation>{0} está dañado: hay un elemento fuera de una secuencia en el byte {1}.</translation>
    </message>
    <message>
        <source>{0} is damaged: a value without a length stands at byte {1}.</source>
        <translation>{0} está dañado: hay un valor sin longitud en el byte {1}.</translation>
    </message>
    <message>
        <source>{0} ends at byte {1}, in the middle of its header.</source>
        <translation>{0} termina en el byte {1}, en mitad de su cabecera.</translation>
    </message>
    <message>
        <source>{0} is damaged: the length at byte {1} leaves what encloses it.</source>
        <translation>{0} está dañado: la longitud en el byte {1} se sale de lo que la contiene.</translation>
    </message>
    <message>
        <source>{0} ends at byte {1}, in the middle of a sequence.</source>
        <translation>{0} termina en el byte {1}, en mitad de una secuencia.</translation>
    </message>
    <message>
        <source>{0} is damaged: a sequence holds something else than items at byte {1}.</source>
        <translation>{0} está dañado: una secuencia contiene algo que no son elementos en el byte {1}.</translation>
    </message>
    <message>
        <source>{0} is damaged: its pixels are not stored in the way its transfer syntax {1} says.</source>
        <translation>{0} está dañado: sus píxeles no están almacenados como dice su sintaxis de transferencia {1}.</translation>
    </message>
    <message>
        <source>{0} is cut short: {1} of {2} bytes of its pixels are there.</source>
        <translation>{0} está cortado: hay {1} de {2} bytes de sus píxeles.</translation>
    </message>
    <message>
        <source>{0} is damaged: its compressed pixels are broken at byte {1}.</source>
        <translation>{0} está dañado: sus píxeles comprimidos están rotos en el byte {1}.</translation>
    </message>
    <message>
        <source>The pixels of {0} are in too many pieces.</source>
        <translation>Los píxeles de {0} están en demasiados trozos.</translation>
    </message>
    <message>
        <source>{0} is cut short in its compressed pixels, at byte {1}.</source>
        <translation>{0} está cortado en sus píxeles comprimidos, en el byte {1}.</translation>
    </message>
    <message>
        <source>{0} is damaged: no value type is known for what stands at byte {1}.</source>
        <translation>{0} está dañado: no se conoce ningún tipo de valor para lo que hay en el byte {1}.</translation>
    </message>
    <message>
        <source>{0} nests its sequences more than {1} deep, which no image does.</source>
        <translation>{0} anida sus secuencias a más de {1} niveles, algo que ninguna imagen hace.</translation>
    </message>
    <message>
        <source>Copy the file again from where it came.</source>
        <translation>Copie de nuevo el archivo desde su origen.</translation>
    </message>
    <message>
        <source>The compressed pixels of {0} are damaged.</source>
        <translation>Los píxeles comprimidos de {0} están dañados.</translation>
    </message>
    <message>
        <source>{0} is compressed in a way that is not read (transfer syntax {1}).</source>
        <translation>{0} está comprimido de una forma que no se lee (sintaxis de transferencia {1}).</translation>
    </message>
    <message>
        <source>Convert it to an uncompressed or JPEG form first.</source>
        <translation>Conviértalo antes a una forma sin comprimir o JPEG.</translation>
    </message>
    <message>
        <source>The compressed picture of {0} is {1} x {2} with {3} bits, where its header says {4} x {5} with {6}.</source>
        <translation>La imagen comprimida de {0} tiene {1} x {2} píxeles con {3} bits, mientras que su cabecera dice {4} x {5} con {6}.</translation>
    </message>
    <message>
        <source>{0} lies inside {1}, which is only read.</source>
        <translation>{0} está dentro de {1}, que solo se lee.</translation>
    </message>
    <message>
        <source>Choose a folder elsewhere for the files without identity.</source>
        <translation>Elija una carpeta en otro lugar para los archivos sin identidad.</translation>
    </message>
    <message>
        <source>removing identity</source>
        <translation>eliminando la identidad</translation>
    </message>
    <message>
        <source>{0} holds no DICOM file.</source>
        <translation>{0} no contiene ningún archivo DICOM.</translation>
    </message>
    <message>
        <source>Give the folder or the file that holds the images.</source>
        <translation>Indique la carpeta o el archivo que contiene las imágenes.</translation>
    </message>
    <message>
        <source>{0} cannot be read: {1}.</source>
        <translation>No se puede leer {0}: {1}.</translation>
    </message>
    <message>
        <source>Check the path and your rights there.</source>
        <translation>Compruebe la ruta y sus permisos en ella.</translation>
    </message>
    <message>
        <source>{0} holds no image, or is damaged.</source>
        <translation>{0} no contiene ninguna imagen o está dañado.</translation>
    </message>
    <message>
        <source>{0} declares impossible pixels: {1} of {2} bits, the highest {3}.</source>
        <translation>{0} declara píxeles imposibles: {1} de {2} bits, el más alto {3}.</translation>
    </message>
    <message>
        <source>{0} declares compressed pictures too large to be true.</source>
        <translation>{0} declara imágenes comprimidas demasiado grandes para ser ciertas.</translation>
    </message>
    <message>
        <source>{0} holds {1} of the {2} frames that it declares.</source>
        <translation>{0} contiene {1} de los {2} fotogramas que declara.</translation>
    </message>
    <message>
        <source>{0} holds {1} bytes of pixels, but its size in pixels asks for {2}.</source>
        <translation>{0} contiene {1} bytes de píxeles, pero su tamaño exige {2}.</translation>
    </message>
    <message>
        <source>{0} is damaged: its header cannot be understood.</source>
        <translation>{0} está dañado: su cabecera no se entiende.</translation>
    </message>
    <message>
        <source>{0} is DICOM, but holds no picture ({1}).</source>
        <translation>{0} es DICOM, pero no contiene ninguna imagen ({1}).</translation>
    </message>
    <message>
        <source>{0} is no directory of DICOM files.</source>
        <translation>{0} no es un directorio de archivos DICOM (DICOMDIR).</translation>
    </message>
    <message>
        <source>Open the folder itself instead.</source>
        <translation>Abra en su lugar la propia carpeta.</translation>
    </message>
    <message>
        <source>Export the segmentation again, as binary and uncompressed DICOM SEG.</source>
        <translation>Exporte de nuevo la segmentación, como DICOM SEG binario y sin comprimir.</translation>
    </message>
    <message>
        <source>{0} is not a DICOM segmentation.</source>
        <translation>{0} no es una segmentación DICOM.</translation>
    </message>
    <message>
        <source>The segmentation {0} is compressed (or big endian).</source>
        <translation>La segmentación {0} está comprimida (o en big endian).</translation>
    </message>
    <message>
        <source>The segmentation {0} names no segment, or too many for its size: {1}.</source>
        <translation>La segmentación {0} no nombra ningún segmento o demasiados para su tamaño: {1}.</translation>
    </message>
    <message>
        <source>The headers of {0} are damaged.</source>
        <translation>Las cabeceras de {0} están dañadas.</translation>
    </message>
    <message>
        <source>The segmentation {0} does not say where its frames are: {1}.</source>
        <translation>La segmentación {0} no indica dónde están sus fotogramas: {1}.</translation>
    </message>
    <message>
        <source>rows, columns, frames or bits</source>
        <translation>filas, columnas, fotogramas o bits</translation>
    </message>
    <message>
        <source>pixel spacing</source>
        <translation>espaciado de los píxeles</translation>
    </message>
    <message>
        <source>The frames of the segmentation {0} are not above each other.</source>
        <translation>Los fotogramas de la segmentación {0} no están superpuestos.</translation>
    </message>
    <message>
        <source>The frames of the segmentation {0} are not evenly spaced.</source>
        <translation>Los fotogramas de la segmentación {0} no están espaciados por igual.</translation>
    </message>
    <message>
        <source>The segmentation {0} holds fewer frames than it declares.</source>
        <translation>La segmentación {0} contiene menos fotogramas de los que declara.</translation>
    </message>
    <message>
        <source>The segmentation {0} ends before its last frame.</source>
        <translation>La segmentación {0} termina antes de su último fotograma.</translation>
    </message>
    <message>
        <source>There is no segment to write.</source>
        <translation>No hay ningún segmento que escribir.</translation>
    </message>
    <message>
        <source>A segmentation needs the identifiers of the study, the series and the frame of reference that it was drawn on.</source>
        <translation>Una segmentación necesita los identificadores del estudio, de la serie y del marco de referencia sobre los que se dibujó.</translation>
    </message>
    <message>
        <source>The segments {0} and {1} lie on different grids; one file holds one grid.</source>
        <translation>Los segmentos {0} y {1} están en cuadrículas distintas; un archivo contiene una sola.</translation>
    </message>
    <message>
        <source>The grid of the segment {0} is skewed, left-handed or too large for DICOM.</source>
        <translation>La cuadrícula del segmento {0} está sesgada, es levógira o demasiado grande para DICOM.</translation>
    </message>
    <message>
        <source>The volume holds no voxels, so no series can be written to {0}.</source>
        <translation>El volumen no contiene vóxeles, así que no se puede escribir ninguna serie en {0}.</translation>
    </message>
    <message>
        <source>The slices have {0} x {1} voxels; DICOM counts rows and columns up to 65535.</source>
        <translation>Los cortes tienen {0} x {1} vóxeles; DICOM cuenta filas y columnas hasta 65535.</translation>
    </message>
    <message>
        <source>The series {0} needs the identifiers of its study, of itself and of its frame of reference.</source>
        <translation>La serie {0} necesita los identificadores de su estudio, de sí misma y de su marco de referencia.</translation>
    </message>
    <message>
        <source>The volume holds values that are not finite; DICOM cannot.</source>
        <translation>El volumen contiene valores no finitos; DICOM no lo permite.</translation>
    </message>
    <message>
        <source>Slice {0} holds the value {1}, which the rescale {2} x + {3} cannot hold in 16 bits.</source>
        <translation>El corte {0} contiene el valor {1}, que el reescalado {2} x + {3} no puede guardar en 16 bits.</translation>
    </message>
    <message>
        <source>{0} may not be read by you.</source>
        <translation>No tiene permiso para leer {0}.</translation>
    </message>
    <message>
        <source>{0} cannot be opened: it has gone, or is no ordinary file.</source>
        <translation>No se puede abrir {0}: ha desaparecido o no es un archivo ordinario.</translation>
    </message>
    <message>
        <source>{0} is not any more as it was when the folder was scanned.</source>
        <translation>{0} ya no está como cuando se examinó la carpeta.</translation>
    </message>
    <message>
        <source>Scan the folder again.</source>
        <translation>Examine de nuevo la carpeta.</translation>
    </message>
    <message>
        <source>{0} does not say which of its compressed pieces belong to frame {1}.</source>
        <translation>{0} no indica cuáles de sus trozos comprimidos pertenecen al fotograma {1}.</translation>
    </message>
    <message>
        <source>The series {0} has {1} volumes, counted from 0, and no {2}.</source>
        <translation>La serie {0} tiene {1} volúmenes, contados desde 0, y ninguno {2}.</translation>
    </message>
    <message>
        <source>The series {0} is a segmentation, not an image.</source>
        <translation>La serie {0} es una segmentación, no una imagen.</translation>
    </message>
    <message>
        <source>Import it as labels of a structure.</source>
        <translation>Impórtela como etiquetas de una estructura.</translation>
    </message>
    <message>
        <source>The series {0} holds pictures in colour and no values to measure.</source>
        <translation>La serie {0} contiene imágenes en color y ningún valor que medir.</translation>
    </message>
    <message>
        <source>Choose the grey-scale series that it was made from.</source>
        <translation>Elija la serie en escala de grises de la que procede.</translation>
    </message>
    <message>
        <source>The series {0} needs {1} GiB of memory, more than this computer has.</source>
        <translation>La serie {0} necesita {1} GiB de memoria, más de la que tiene este ordenador.</translation>
    </message>
    <message>
        <source>Reading the slices</source>
        <translation>Leyendo los cortes</translation>
    </message>
    <message>
        <source>Sorting the series</source>
        <translation>Ordenando las series</translation>
    </message>
    <message>
        <source>The folder {0} cannot be read.</source>
        <translation>No se puede leer la carpeta {0}.</translation>
    </message>
    <message>
        <source>Check your rights there.</source>
        <translation>Compruebe sus permisos en ella.</translation>
    </message>
    <message>
        <source>Files found</source>
        <translation>Archivos encontrados</translation>
    </message>
    <message>
        <source>There is nothing at {0}.</source>
        <translation>No hay nada en {0}.</translation>
    </message>
    <message>
        <source>Check the path.</source>
        <translation>Compruebe la ruta.</translation>
    </message>
    <message>
        <source>Files looked at</source>
        <translation>Archivos examinados</translation>
    </message>
    <message>
        <source>The map is in {0}, which is no unit of stiffness.</source>
        <translation>El mapa está en {0}, que no es una unidad de rigidez.</translation>
    </message>
    <message>
        <source>The stiffness map holds no value above zero.</source>
        <translation>El mapa de rigidez no contiene ningún valor mayor que cero.</translation>
    </message>
    <message>
        <source>It cannot be decided whether the stiffness map is in Pa or kPa: its median, {0}, is no stiffness of soft tissue in either.</source>
        <translation>No se puede decidir si el mapa de rigidez está en Pa o en kPa: su mediana, {0}, no es una rigidez de tejido blando en ninguna de las dos.</translation>
    </message>
    <message>
        <source>The stiffness map is marked as {0}, but its median, {1}, is a stiffness of soft tissue only in {2}.</source>
        <translation>El mapa de rigidez está marcado como {0}, pero su mediana, {1}, solo es una rigidez de tejido blando en {2}.</translation>
    </message>
    <message>
        <source>Correct the unit in the file after asking where it came from.</source>
        <translation>Corrija la unidad en el archivo después de consultar a quien lo generó.</translation>
    </message>
    <message>
        <source>{0} is not a label map: it holds the value {1}.</source>
        <translation>{0} no es un mapa de etiquetas: contiene el valor {1}.</translation>
    </message>
    <message>
        <source>A label map holds whole numbers from 0 to 65535.</source>
        <translation>Un mapa de etiquetas contiene números enteros de 0 a 65535.</translation>
    </message>
    <message>
        <source>{0} is not of a known kind of volume file.</source>
        <translation>{0} no es de un tipo conocido de archivo de volumen.</translation>
    </message>
    <message>
        <source>Known are .nii, .nii.gz, .nrrd, .nhdr, .mha and .mhd.</source>
        <translation>Se conocen .nii, .nii.gz, .nrrd, .nhdr, .mha y .mhd.</translation>
    </message>
    <message>
        <source>Check that the file is whole, for example by opening it in 3D Slicer.</source>
        <translation>Compruebe que el archivo está completo, por ejemplo abriéndolo en 3D Slicer.</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>está vacío</translation>
    </message>
    <message>
        <source>its header is not of that format</source>
        <translation>su cabecera no es de ese formato</translation>
    </message>
    <message>
        <source>{0} holds {1} values at each voxel; one is needed.</source>
        <translation>{0} contiene {1} valores por vóxel; se necesita uno.</translation>
    </message>
    <message>
        <source>Save one component (or a grey image in place of a colour one).</source>
        <translation>Guarde una sola componente (o una imagen gris en lugar de una en color).</translation>
    </message>
    <message>
        <source>{0} is not a three-dimensional volume: it has {1} axes.</source>
        <translation>{0} no es un volumen tridimensional: tiene {1} ejes.</translation>
    </message>
    <message>
        <source>Save one volume (one point in time) to a file.</source>
        <translation>Guarde un solo volumen (un solo instante) en un archivo.</translation>
    </message>
    <message>
        <source>The header of {0} gives no usable grid: sizes and spacings must be positive and the axes at right angles.</source>
        <translation>La cabecera de {0} no da una cuadrícula utilizable: los tamaños y espaciados deben ser positivos y los ejes perpendiculares.</translation>
    </message>
    <message>
        <source>Resample the volume onto a regular grid and save it again.</source>
        <translation>Remuestree el volumen en una cuadrícula regular y guárdelo de nuevo.</translation>
    </message>
    <message>
        <source>{0} is too short: its header declares {1} bytes of voxels and the file can hold {2} at most.</source>
        <translation>{0} es demasiado corto: su cabecera declara {1} bytes de vóxeles y el archivo puede contener {2} como máximo.</translation>
    </message>
    <message>
        <source>its numbers are of an unknown type</source>
        <translation>sus números son de un tipo desconocido</translation>
    </message>
    <message>
        <source>The supports do not hold the body: it {0}, so no equilibrium exists.</source>
        <translation>Los apoyos no sujetan el cuerpo: {0}, así que no existe equilibrio.</translation>
    </message>
    <message>
        <source>Hold more of it, or put a foundation under part of its surface.</source>
        <translation>Sujete una parte mayor o ponga una cimentación bajo parte de su superficie.</translation>
    </message>
    <message>
        <source>The mesh has {0} cells; at most {1} can be solved.</source>
        <translation>La malla tiene {0} celdas; se pueden resolver como máximo {1}.</translation>
    </message>
    <message>
        <source>Mesh with fewer cells.</source>
        <translation>Malle con menos celdas.</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio must lie between -1 and 0.5, both excluded; it is {0}.</source>
        <translation>El coeficiente de Poisson debe estar entre -1 y 0.5, ambos excluidos; es {0}.</translation>
    </message>
    <message>
        <source>For tissue that is nearly incompressible take 0.45 to 0.499.</source>
        <translation>Para tejido casi incompresible tome de 0.45 a 0.499.</translation>
    </message>
    <message>
        <source>The density must be a finite number, zero or above.</source>
        <translation>La densidad debe ser un número finito, cero o mayor.</translation>
    </message>
    <message>
        <source>There are {0} values of Young&apos;s modulus for {1} cells.</source>
        <translation>Hay {0} valores del módulo de Young para {1} celdas.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of cell {0} is {1} kPa; it must be a number above zero.</source>
        <translation>El módulo de Young de la celda {0} es {1} kPa; debe ser un número mayor que cero.</translation>
    </message>
    <message>
        <source>Fill the cells without data before simulating.</source>
        <translation>Complete las celdas sin datos antes de simular.</translation>
    </message>
    <message>
        <source>The tool at ({0}, {1}, {2}) mm with radius {3} mm touches nothing: the centre of the nearest face of the surface is {4} mm away.</source>
        <translation>El instrumento en ({0}, {1}, {2}) mm, de radio {3} mm, no toca nada: el centro de la cara más próxima de la superficie está a {4} mm.</translation>
    </message>
    <message>
        <source>Move its centre onto the surface, or make its radius larger than {4} mm.</source>
        <translation>Mueva su centro a la superficie o haga su radio mayor que {4} mm.</translation>
    </message>
    <message>
        <source>Ordering the equations</source>
        <translation>Ordenando las ecuaciones</translation>
    </message>
    <message>
        <source>Solving for {0} unknowns would take {1} GB of memory; the limit is {2} GB.</source>
        <translation>Resolver {0} incógnitas requeriría {1} GB de memoria; el límite es {2} GB.</translation>
    </message>
    <message>
        <source>Factorising</source>
        <translation>Factorizando</translation>
    </message>
    <message>
        <source>The stiffness matrix is not positive definite (column {0} of {1}).</source>
        <translation>La matriz de rigidez no es definida positiva (columna {0} de {1}).</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio may be too near 1/2, or cells may be flat: look at the mesh&apos;s quality.</source>
        <translation>El coeficiente de Poisson puede estar demasiado cerca de 1/2 o haber celdas planas: mire la calidad de la malla.</translation>
    </message>
    <message>
        <source>The solver ran out of memory for {0} unknowns.</source>
        <translation>Al solucionador le faltó memoria para {0} incógnitas.</translation>
    </message>
    <message>
        <source>Factorised</source>
        <translation>Factorizado</translation>
    </message>
    <message>
        <source>The equilibrium was not found. {0}</source>
        <translation>No se ha encontrado el equilibrio. {0}</translation>
    </message>
    <message>
        <source>The body&apos;s answer to a force on its surface was not found: the relative residual stayed at {0}.</source>
        <translation>No se ha encontrado la respuesta del cuerpo a una fuerza en su superficie: el residuo relativo se quedó en {0}.</translation>
    </message>
    <message>
        <source>The tool at ({0}, {1}, {2}) mm meets no surface on its way.</source>
        <translation>El instrumento en ({0}, {1}, {2}) mm no encuentra ninguna superficie en su camino.</translation>
    </message>
    <message>
        <source>Move it in front of the liver, or turn it towards it.</source>
        <translation>Muévalo delante del hígado o gírelo hacia él.</translation>
    </message>
    <message>
        <source>A grasper needs a finite place and a radius above zero.</source>
        <translation>Una pinza necesita un lugar finito y un radio mayor que cero.</translation>
    </message>
    <message>
        <source>The grasper holds no point of the surface.</source>
        <translation>La pinza no sujeta ningún punto de la superficie.</translation>
    </message>
    <message>
        <source>Move it onto the surface, or open its jaws wider.</source>
        <translation>Muévala a la superficie o abra más sus mordazas.</translation>
    </message>
    <message>
        <source>Looking for states that the data know</source>
        <translation>Buscando estados que los datos conocen</translation>
    </message>
    <message>
        <source>Looking for the equilibrium</source>
        <translation>Buscando el equilibrio</translation>
    </message>
    <message>
        <source>Solved</source>
        <translation>Resuelto</translation>
    </message>
    <message>
        <source>is not held at all</source>
        <translation>no está sujeto en absoluto</translation>
    </message>
    <message>
        <source>can slide in every direction</source>
        <translation>puede deslizarse en todas las direcciones</translation>
    </message>
    <message>
        <source>The tool of load {0} needs a finite centre and force.</source>
        <translation>El instrumento de la carga {0} necesita un centro y una fuerza finitos.</translation>
    </message>
    <message>
        <source>The tool of load {0} needs a radius above zero.</source>
        <translation>El instrumento de la carga {0} necesita un radio mayor que cero.</translation>
    </message>
    <message>
        <source>The pressure of load {0} is not a finite number.</source>
        <translation>La presión de la carga {0} no es un número finito.</translation>
    </message>
    <message>
        <source>The gravity of load {0} is not a finite vector.</source>
        <translation>La gravedad de la carga {0} no es un vector finito.</translation>
    </message>
    <message>
        <source>A material needs at least 3 measurements of strain and stress.</source>
        <translation>Un material necesita al menos 3 mediciones de deformación y tensión.</translation>
    </message>
    <message>
        <source>A measurement of strain and stress is not a finite number.</source>
        <translation>Una medición de deformación y tensión no es un número finito.</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio must lie between -1 and 0.5, and one neighbour or more is needed for a hull.</source>
        <translation>El coeficiente de Poisson debe estar entre -1 y 0.5, y hace falta al menos un vecino para una envolvente.</translation>
    </message>
    <message>
        <source>The measured stress does not grow with the strain.</source>
        <translation>La tensión medida no crece con la deformación.</translation>
    </message>
    <message>
        <source>Assembling the stiffness</source>
        <translation>Ensamblando la rigidez</translation>
    </message>
    <message>
        <source>Assembled</source>
        <translation>Ensamblado</translation>
    </message>
    <message>
        <source>A motion needs a step and a tolerance above zero, and damping not below it.</source>
        <translation>Un movimiento necesita un paso y una tolerancia mayores que cero y un amortiguamiento no negativo.</translation>
    </message>
    <message>
        <source>{0} nodes in this body need more than 5e8 voxels: take fewer.</source>
        <translation>{0} nodos en este cuerpo necesitan más de 5e8 vóxeles: tome menos.</translation>
    </message>
    <message>
        <source>Spreading the nodes</source>
        <translation>Repartiendo los nodos</translation>
    </message>
    <message>
        <source>Measuring how the material sees the body</source>
        <translation>Midiendo cómo ve el material el cuerpo</translation>
    </message>
    <message>
        <source>{0} nodes, {1} voxels a node and an overlap of {2} cannot be: the last two must be at least 1 and above 1.</source>
        <translation>{0} nodos, {1} vóxeles por nodo y un solapamiento de {2} no son posibles: los dos últimos deben ser al menos 1 y mayor que 1.</translation>
    </message>
    <message>
        <source>One linear solve a step moves the materials &quot;linear&quot; and &quot;corotational&quot;, without ligaments or a capsule.</source>
        <translation>Una resolución lineal por paso mueve los materiales &quot;linear&quot; y &quot;corotational&quot;, sin ligamentos ni cápsula.</translation>
    </message>
    <message>
        <source>A tool needs rods with finite ends and a radius above zero, and a pose that turns and moves it.</source>
        <translation>Un instrumento necesita barras con extremos finitos y radio mayor que cero, y una pose que lo gire y lo mueva.</translation>
    </message>
    <message>
        <source>{0} must be a name in quotes.</source>
        <translation>{0} debe ser un nombre entre comillas.</translation>
    </message>
    <message>
        <source>{0} must be one of {1}.</source>
        <translation>{0} debe ser uno de {1}.</translation>
    </message>
    <message>
        <source>{0} must be a list in brackets.</source>
        <translation>{0} debe ser una lista entre corchetes.</translation>
    </message>
    <message>
        <source>{0} goes with the material &quot;veronda-westmann&quot;: give both or neither.</source>
        <translation>{0} va con el material &quot;veronda-westmann&quot;: indique ambos o ninguno.</translation>
    </message>
    <message>
        <source>{0} and &quot;youngs_modulus_kPa&quot; both say how stiff the body is: give one.</source>
        <translation>{0} y &quot;youngs_modulus_kPa&quot; indican ambos la rigidez del cuerpo: indique solo uno.</translation>
    </message>
    <message>
        <source>{0} has the same id &quot;{1}&quot; as another.</source>
        <translation>{0} tiene el mismo identificador «{1}» que otro.</translation>
    </message>
    <message>
        <source>{0} needs exactly one of &quot;point_array&quot;, &quot;sphere&quot; and &quot;box&quot;.</source>
        <translation>{0} necesita exactamente uno de &quot;point_array&quot;, &quot;sphere&quot; y &quot;box&quot;.</translation>
    </message>
    <message>
        <source>In {0} the box&apos;s min_mm must not exceed its max_mm.</source>
        <translation>En {0} el min_mm de la caja no debe superar su max_mm.</translation>
    </message>
    <message>
        <source>{0} is a ligament: it takes neither &quot;foundation_kPa_per_mm&quot; nor &quot;directions&quot;.</source>
        <translation>{0} es un ligamento: no admite ni &quot;foundation_kPa_per_mm&quot; ni &quot;directions&quot;.</translation>
    </message>
    <message>
        <source>{0} has both &quot;foundation_kPa_per_mm&quot; and &quot;directions&quot;: a foundation acts in all directions.</source>
        <translation>{0} tiene a la vez &quot;foundation_kPa_per_mm&quot; y &quot;directions&quot;: una cimentación actúa en todas las direcciones.</translation>
    </message>
    <message>
        <source>The directions of {0} must be a list such as [&quot;x&quot;, &quot;z&quot;].</source>
        <translation>Las direcciones de {0} deben ser una lista, por ejemplo [&quot;x&quot;, &quot;z&quot;].</translation>
    </message>
    <message>
        <source>{0} needs exactly one of &quot;tool&quot;, &quot;pressure_kPa&quot;, &quot;gravity_m_s2&quot; and &quot;gravity_of_patient&quot;.</source>
        <translation>{0} necesita exactamente uno de &quot;tool&quot;, &quot;pressure_kPa&quot;, &quot;gravity_m_s2&quot; y &quot;gravity_of_patient&quot;.</translation>
    </message>
    <message>
        <source>{0} must lie between -90 and 90 degrees.</source>
        <translation>{0} debe estar entre -90 y 90 grados.</translation>
    </message>
    <message>
        <source>{0} has both &quot;left_tilt_deg&quot; and &quot;right_tilt_deg&quot;: give one.</source>
        <translation>{0} tiene a la vez &quot;left_tilt_deg&quot; y &quot;right_tilt_deg&quot;: indique solo uno.</translation>
    </message>
    <message>
        <source>{0} must be true or false.</source>
        <translation>{0} debe ser true o false.</translation>
    </message>
    <message>
        <source>The steps of {0} must be a whole number from 1 to 1000000.</source>
        <translation>Los pasos de {0} deben ser un número entero de 1 a 1000000.</translation>
    </message>
    <message>
        <source>The nodes of {0} must be a whole number from 1 to 1000000.</source>
        <translation>Los nodos de {0} deben ser un número entero de 1 a 1000000.</translation>
    </message>
    <message>
        <source>The mesh has no cell array {0} with one value a cell.</source>
        <translation>La malla no tiene una matriz de celdas {0} con un valor por celda.</translation>
    </message>
    <message>
        <source>Give the scenario &quot;youngs_modulus_kPa&quot;, a number or the name of a cell array; the mesh&apos;s cell arrays are: {1}.</source>
        <translation>Dé al escenario &quot;youngs_modulus_kPa&quot;, un número o el nombre de una matriz de celdas; las matrices de celdas de la malla son: {1}.</translation>
    </message>
    <message>
        <source>The position of landmark {0} is not a finite point.</source>
        <translation>La posición del punto de referencia {0} no es un punto finito.</translation>
    </message>
    <message>
        <source>Landmark {0} lies {1} mm outside the body.</source>
        <translation>El punto de referencia {0} está a {1} mm fuera del cuerpo.</translation>
    </message>
    <message>
        <source>Check that landmarks and mesh are in the same coordinates (LPS, mm).</source>
        <translation>Compruebe que los puntos de referencia y la malla están en las mismas coordenadas (LPS, mm).</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>Resolviendo</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>Moviendo</translation>
    </message>
    <message>
        <source>Checking the model</source>
        <translation>Comprobando el modelo</translation>
    </message>
    <message>
        <source>A ligament only pulls, so it is not linear: look for the equilibrium by steps.</source>
        <translation>Un ligamento solo tira, así que no es lineal: busque el equilibrio por pasos.</translation>
    </message>
    <message>
        <source>Nodal loads need {0} values: three a node.</source>
        <translation>Las cargas nodales necesitan {0} valores: tres por nodo.</translation>
    </message>
    <message>
        <source>A nodal load is not a finite number.</source>
        <translation>Una carga nodal no es un número finito.</translation>
    </message>
    <message>
        <source>Support {0} names no point of the mesh.</source>
        <translation>El apoyo {0} no nombra ningún punto de la malla.</translation>
    </message>
    <message>
        <source>Move or enlarge its region, or name another point array.</source>
        <translation>Mueva o amplíe su región o nombre otra matriz de puntos.</translation>
    </message>
    <message>
        <source>The foundation of support {0} needs a stiffness above zero, not {1} kPa/mm.</source>
        <translation>La cimentación del apoyo {0} necesita una rigidez mayor que cero, no {1} kPa/mm.</translation>
    </message>
    <message>
        <source>The foundation of support {0} covers no face: no face of the surface has all three points named.</source>
        <translation>La cimentación del apoyo {0} no cubre ninguna cara: ninguna cara de la superficie tiene nombrados sus tres puntos.</translation>
    </message>
    <message>
        <source>Move or enlarge its region.</source>
        <translation>Mueva o amplíe su región.</translation>
    </message>
    <message>
        <source>Support {0} asks for the point array {1}, which the mesh does not have with one value a point.</source>
        <translation>El apoyo {0} pide la matriz de puntos {1}, que la malla no tiene con un valor por punto.</translation>
    </message>
    <message>
        <source>The mesh&apos;s point arrays are: {2}.</source>
        <translation>Las matrices de puntos de la malla son: {2}.</translation>
    </message>
    <message>
        <source>The point array {0} is not a number at point {1}.</source>
        <translation>La matriz de puntos {0} no es un número en el punto {1}.</translation>
    </message>
    <message>
        <source>The sphere of support {0} needs a finite centre and a radius above zero.</source>
        <translation>La esfera del apoyo {0} necesita un centro finito y un radio mayor que cero.</translation>
    </message>
    <message>
        <source>The box of support {0} needs finite corners, the smaller one first.</source>
        <translation>La caja del apoyo {0} necesita esquinas finitas, la menor primero.</translation>
    </message>
    <message>
        <source>The ligament of support {0} needs a finite anchor, a stiffness above zero and a slack not below it.</source>
        <translation>El ligamento del apoyo {0} necesita un anclaje finito, una rigidez mayor que cero y una holgura no negativa.</translation>
    </message>
    <message>
        <source>The ligament of support {0} names no point of the surface.</source>
        <translation>El ligamento del apoyo {0} no nombra ningún punto de la superficie.</translation>
    </message>
    <message>
        <source>There is no published tissue {0}.</source>
        <translation>No hay ningún tejido publicado {0}.</translation>
    </message>
    <message>
        <source>The tissues are: {1}.</source>
        <translation>Los tejidos son: {1}.</translation>
    </message>
    <message>
        <source>{0} nodes in {1} rounds cannot be made; both must be at least 1.</source>
        <translation>{0} nodos en {1} rondas no son posibles; ambos deben ser al menos 1.</translation>
    </message>
    <message>
        <source>The body holds no voxels.</source>
        <translation>El cuerpo no contiene vóxeles.</translation>
    </message>
    <message>
        <source>{0} nodes are more than the body has voxels ({1}).</source>
        <translation>{0} nodos son más que los vóxeles del cuerpo ({1}).</translation>
    </message>
    <message>
        <source>The mesh generator gave up: {0}.</source>
        <translation>El generador de mallas ha desistido: {0}.</translation>
    </message>
    <message>
        <source>Ask for another number of cells, or smooth the labels.</source>
        <translation>Pida otro número de celdas o suavice las etiquetas.</translation>
    </message>
    <message>
        <source>The label map holds no labelled voxel, so there is no body to mesh.</source>
        <translation>El mapa de etiquetas no contiene ningún vóxel etiquetado, así que no hay cuerpo que mallar.</translation>
    </message>
    <message>
        <source>Segment the liver first.</source>
        <translation>Segmente antes el hígado.</translation>
    </message>
    <message>
        <source>The label map has {0} values for a grid of {1} x {2} x {3} voxels.</source>
        <translation>El mapa de etiquetas tiene {0} valores para una cuadrícula de {1} x {2} x {3} vóxeles.</translation>
    </message>
    <message>
        <source>The label map&apos;s axes are not at right angles, or its spacing is not positive.</source>
        <translation>Los ejes del mapa de etiquetas no son perpendiculares o su espaciado no es positivo.</translation>
    </message>
    <message>
        <source>A structure without voxels has no surface.</source>
        <translation>Una estructura sin vóxeles no tiene superficie.</translation>
    </message>
    <message>
        <source>Preparing the labels</source>
        <translation>Preparando las etiquetas</translation>
    </message>
    <message>
        <source>Removing slivers</source>
        <translation>Eliminando los tetraedros planos</translation>
    </message>
    <message>
        <source>Measuring the distance to the label boundary</source>
        <translation>Midiendo la distancia al límite de las etiquetas</translation>
    </message>
    <message>
        <source>The surface of the mesh is not a closed manifold.</source>
        <translation>La superficie de la malla no es una variedad cerrada.</translation>
    </message>
    <message>
        <source>Meshed</source>
        <translation>Mallado</translation>
    </message>
    <message>
        <source>A mesh of {0} cells cannot be made; from {1} to {2} can.</source>
        <translation>No se puede hacer una malla de {0} celdas; sí de {1} a {2}.</translation>
    </message>
    <message>
        <source>The share of cells for inner structures is {0}; it must be in 0 to 1.</source>
        <translation>La proporción de celdas para estructuras internas es {0}; debe estar entre 0 y 1.</translation>
    </message>
    <message>
        <source>Filling the body with tetrahedra</source>
        <translation>Rellenando el cuerpo con tetraedros</translation>
    </message>
    <message>
        <source>A piece of {0} has {1} ml, but its cells only {2} ml: the mesh has lost it.</source>
        <translation>Un trozo de {0} tiene {1} ml, pero sus celdas solo {2} ml: la malla lo ha perdido.</translation>
    </message>
    <message>
        <source>Ask for more cells.</source>
        <translation>Pida más celdas.</translation>
    </message>
    <message>
        <source>A battery with a {0} of {1} does not exist.</source>
        <translation>No existe una batería con {0} = {1}.</translation>
    </message>
    <message>
        <source>Correct the device&apos;s battery.</source>
        <translation>Corrija la batería del dispositivo.</translation>
    </message>
    <message>
        <source>A load of {0} W is more than the battery&apos;s internal resistance lets through.</source>
        <translation>Una carga de {0} W es más de lo que deja pasar la resistencia interna de la batería.</translation>
    </message>
    <message>
        <source>A batch of {0} nodes takes more than the {1} MB there are for it.</source>
        <translation>Un lote de {0} nodos ocupa más que los {1} MB disponibles.</translation>
    </message>
    <message>
        <source>{0} lacks a reading within the discharge.</source>
        <translation>A {0} le falta una lectura durante la descarga.</translation>
    </message>
    <message>
        <source>The time goes back in {0}.</source>
        <translation>El tiempo retrocede en {0}.</translation>
    </message>
    <message>
        <source>{0} holds no discharge.</source>
        <translation>{0} no contiene ninguna descarga.</translation>
    </message>
    <message>
        <source>{0} lacks a reading of the ambient.</source>
        <translation>A {0} le falta una lectura del ambiente.</translation>
    </message>
    <message>
        <source>A cell is set up from one slow discharge and at least two that are five times as fast.</source>
        <translation>Una celda se determina con una descarga lenta y al menos dos cinco veces más rápidas.</translation>
    </message>
    <message>
        <source>A convergence curve has 2 to {0} points; this one has {1}.</source>
        <translation>Una curva de convergencia tiene de 2 a {0} puntos; esta tiene {1}.</translation>
    </message>
    <message>
        <source>Point {0} of the convergence curve, {1} mm3 and {2} mm, is not positive or does not increase from the point before.</source>
        <translation>El punto {0} de la curva de convergencia, {1} mm3 y {2} mm, no es positivo o no aumenta respecto al anterior.</translation>
    </message>
    <message>
        <source>{0} has no list of points.</source>
        <translation>{0} no tiene ninguna lista de puntos.</translation>
    </message>
    <message>
        <source>An accuracy of {0} mm is finer than the convergence study reaches ({1} mm at {2} mm3 a node).</source>
        <translation>Una precisión de {0} mm es más fina de lo que alcanza el estudio de convergencia ({1} mm a {2} mm3 por nodo).</translation>
    </message>
    <message>
        <source>Ask for {1} mm or more.</source>
        <translation>Pida {1} mm o más.</translation>
    </message>
    <message>
        <source>Device {0} has {1} {2}; it must lie between {3} and {4}.</source>
        <translation>El dispositivo {0} tiene {1} {2}; debe estar entre {3} y {4}.</translation>
    </message>
    <message>
        <source>Correct that figure in the device&apos;s file.</source>
        <translation>Corrija esa cifra en el archivo del dispositivo.</translation>
    </message>
    <message>
        <source>Device {0} has measured points that are not positive, not by increasing nodes, or more than {1}.</source>
        <translation>El dispositivo {0} tiene puntos medidos que no son positivos, no están por nodos crecientes o son más de {1}.</translation>
    </message>
    <message>
        <source>{0} has no list &quot;devices&quot; of 1 to {1} devices.</source>
        <translation>{0} no tiene una lista &quot;devices&quot; de 1 a {1} dispositivos.</translation>
    </message>
    <message>
        <source>Two devices have the id &quot;{0}&quot;.</source>
        <translation>Dos dispositivos tienen el identificador «{0}».</translation>
    </message>
    <message>
        <source>Give each its own.</source>
        <translation>Dé a cada uno el suyo.</translation>
    </message>
    <message>
        <source>{0} has the id &quot;{1}&quot;.</source>
        <translation>{0} tiene el identificador «{1}».</translation>
    </message>
    <message>
        <source>Use up to 64 small letters, digits and dashes.</source>
        <translation>Use hasta 64 letras minúsculas, cifras y guiones.</translation>
    </message>
    <message>
        <source>{0} is worn &quot;{1}&quot;.</source>
        <translation>{0} se lleva «{1}».</translation>
    </message>
    <message>
        <source>Use head, belt or back.</source>
        <translation>Use head, belt o back.</translation>
    </message>
    <message>
        <source>The energy meter {0} stopped answering.</source>
        <translation>El medidor de energía {0} ha dejado de responder.</translation>
    </message>
    <message>
        <source>No energy counters of the processor (RAPL) at {0}.</source>
        <translation>No hay contadores de energía del procesador (RAPL) en {0}.</translation>
    </message>
    <message>
        <source>No current sensors (INA) at {0}.</source>
        <translation>No hay sensores de corriente (INA) en {0}.</translation>
    </message>
    <message>
        <source>The battery is not discharging: unplug the machine to measure by its gauge.</source>
        <translation>La batería no se descarga: desenchufe la máquina para medir con su indicador.</translation>
    </message>
    <message>
        <source>No battery gauge at {0}.</source>
        <translation>No hay indicador de batería en {0}.</translation>
    </message>
    <message>
        <source>{0} does not say &quot;format&quot;: &quot;{1}&quot;.</source>
        <translation>{0} no indica &quot;format&quot;: &quot;{1}&quot;.</translation>
    </message>
    <message>
        <source>Check that it is the file you meant.</source>
        <translation>Compruebe que es el archivo que quería.</translation>
    </message>
    <message>
        <source>{0} has no &quot;{1}&quot;, or not of the right kind.</source>
        <translation>{0} no tiene &quot;{1}&quot; o no es del tipo correcto.</translation>
    </message>
    <message>
        <source>The shipped devices.json shows every key.</source>
        <translation>El archivo devices.json incluido muestra todas las claves.</translation>
    </message>
    <message>
        <source>{0} has &quot;{1}&quot; {2}; it must lie between {3} and {4}.</source>
        <translation>{0} tiene &quot;{1}&quot; {2}; debe estar entre {3} y {4}.</translation>
    </message>
    <message>
        <source>{0} has &quot;{1}&quot; empty or longer than {2} characters.</source>
        <translation>{0} tiene &quot;{1}&quot; vacío o de más de {2} caracteres.</translation>
    </message>
    <message>
        <source>{0} has the source &quot;{1}&quot;.</source>
        <translation>{0} tiene la fuente «{1}».</translation>
    </message>
    <message>
        <source>Idle power</source>
        <translation>Potencia en reposo</translation>
    </message>
    <message>
        <source>Nothing on this machine tells its energy: idle and active power are assumed. Measure them with a current clamp or a power meter, and give them.</source>
        <translation>Nada en esta máquina indica su energía: las potencias en reposo y en carga son supuestas. Mídalas con una pinza amperimétrica o un vatímetro e indíquelas.</translation>
    </message>
    <message>
        <source>Memory bandwidth</source>
        <translation>Ancho de banda de la memoria</translation>
    </message>
    <message>
        <source>Block products</source>
        <translation>Productos por bloques</translation>
    </message>
    <message>
        <source>Other work disturbed the timing: batches usually took {0} times as long as the fastest one. Measure again on a quiet machine.</source>
        <translation>Otro trabajo ha perturbado la medida del tiempo: los lotes tardaron por lo general {0} veces más que el más rápido. Mida de nuevo en una máquina sin carga.</translation>
    </message>
    <message>
        <source>The grid holds no problem.</source>
        <translation>La cuadrícula no contiene ningún problema.</translation>
    </message>
    <message>
        <source>{0} of {1} problems are larger than the memory allowed and were left out; beyond {2} nodes the plan goes on in proportion.</source>
        <translation>{0} de {1} problemas superan la memoria permitida y se han omitido; más allá de {2} nodos el plan continúa en proporción.</translation>
    </message>
    <message>
        <source>This build has no OpenCL.</source>
        <translation>Esta versión no tiene OpenCL.</translation>
    </message>
    <message>
        <source>Build with -DGLISSON_OPENCL=ON.</source>
        <translation>Compile con -DGLISSON_OPENCL=ON.</translation>
    </message>
    <message>
        <source>OpenCL&apos;s {0} failed with {1}.</source>
        <translation>{0} de OpenCL ha fallado con {1}.</translation>
    </message>
    <message>
        <source>There is no OpenCL device &quot;{0}&quot;.</source>
        <translation>No hay ningún dispositivo OpenCL «{0}».</translation>
    </message>
    <message>
        <source>Found: {1}. A device shows once its driver is installed (pocl-opencl-icd for processors).</source>
        <translation>Encontrado: {1}. Un dispositivo aparece cuando su controlador está instalado (pocl-opencl-icd para procesadores).</translation>
    </message>
    <message>
        <source>{0} of {1} is not between {2} and {3}.</source>
        <translation>{0} de {1} no está entre {2} y {3}.</translation>
    </message>
    <message>
        <source>Correct the question.</source>
        <translation>Corrija la pregunta.</translation>
    </message>
    <message>
        <source>A room of {0} C is not cooler than the limit of {1} C.</source>
        <translation>Una sala a {0} C no está más fría que el límite de {1} C.</translation>
    </message>
    <message>
        <source>It draws {0} W when idle; its battery allows {1} W over {2} h, and is empty after {3} h without computing anything.</source>
        <translation>Consume {0} W en reposo; su batería permite {1} W durante {2} h y se vacía en {3} h sin calcular nada.</translation>
    </message>
    <message>
        <source>Its battery is empty after {0} h of {1} h: only {2} W of headroom over idling.</source>
        <translation>Su batería se vacía tras {0} h de {1} h: solo {2} W de margen sobre el reposo.</translation>
    </message>
    <message>
        <source>It reaches {0} C when idle; the limit is {1} C.</source>
        <translation>Alcanza {0} C en reposo; el límite es {1} C.</translation>
    </message>
    <message>
        <source>It reaches {0} C; the limit is {1} C.</source>
        <translation>Alcanza {0} C; el límite es {1} C.</translation>
    </message>
    <message>
        <source>It computes {0} frames a second of {1}.</source>
        <translation>Calcula {0} fotogramas por segundo de {1}.</translation>
    </message>
    <message>
        <source>{0} mm is coarser than the convergence study reaches; planned is its coarsest resolution, {1} mm3 a node.</source>
        <translation>{0} mm es más grueso de lo que alcanza el estudio de convergencia; se planifica con su resolución más gruesa, {1} mm3 por nodo.</translation>
    </message>
    <message>
        <source>A frame is {0} block products as in the dissertation, without the vector updates of conjugate gradients; a simulation that couples 27 nodes moves {1} times as much.</source>
        <translation>Un fotograma son {0} productos por bloques como en la tesis, sin las actualizaciones de vectores del gradiente conjugado; una simulación que acopla 27 nodos mueve {1} veces más datos.</translation>
    </message>
    <message>
        <source>{0} holds with next to no headroom: its battery allows {1} W over {2} h, and idling takes {3} W of them.</source>
        <translation>{0} aguanta casi sin margen: su batería permite {1} W durante {2} h, y el reposo consume {3} W de ellos.</translation>
    </message>
    <message>
        <source>{0}: after {1} s comes {2} s.</source>
        <translation>{0}: después de {1} s viene {2} s.</translation>
    </message>
    <message>
        <source>Give the column that holds the time, or cut the file there.</source>
        <translation>Indique la columna que contiene el tiempo o corte ahí el archivo.</translation>
    </message>
    <message>
        <source>Check the columns; at most every tenth row may be empty.</source>
        <translation>Compruebe las columnas; como máximo una de cada diez filas puede estar vacía.</translation>
    </message>
    <message>
        <source>Change the shortest run and pause, or cut the trace to the logged runs.</source>
        <translation>Cambie la ejecución y la pausa más cortas o recorte el registro a las ejecuciones del diario.</translation>
    </message>
    <message>
        <source>Run {0} drew nothing above idle, or nothing was run in it.</source>
        <translation>La ejecución {0} no consumió nada por encima del reposo o no se ejecutó nada en ella.</translation>
    </message>
    <message>
        <source>The power does not move between two levels, so no runs can be told from pauses.</source>
        <translation>La potencia no se mueve entre dos niveles, de modo que no se distinguen las ejecuciones de las pausas.</translation>
    </message>
    <message>
        <source>Record pauses between the runs; check that the right column was read.</source>
        <translation>Registre pausas entre las ejecuciones; compruebe que se leyó la columna correcta.</translation>
    </message>
    <message>
        <source>Idle power moves by {0} W over the recording; each run is compared with the pauses beside it.</source>
        <translation>La potencia en reposo varía {0} W durante el registro; cada ejecución se compara con las pausas contiguas.</translation>
    </message>
    <message>
        <source>A liver of {0} cm3 is outside {1} to {2} cm3.</source>
        <translation>Un hígado de {0} cm3 está fuera del intervalo de {1} a {2} cm3.</translation>
    </message>
    <message>
        <source>Check the volume and its unit: 1 litre is 1000 cm3.</source>
        <translation>Compruebe el volumen y su unidad: 1 litro son 1000 cm3.</translation>
    </message>
    <message>
        <source>A node cannot stand for {0} mm3.</source>
        <translation>Un nodo no puede representar {0} mm3.</translation>
    </message>
    <message>
        <source>A domain of influence of {0} nodes is no cube around a node.</source>
        <translation>Un dominio de influencia de {0} nodos no es un cubo alrededor de un nodo.</translation>
    </message>
    <message>
        <source>Use 1, 27 or 125.</source>
        <translation>Use 1, 27 o 125.</translation>
    </message>
    <message>
        <source>{0} products a frame are not between 1 and 100000.</source>
        <translation>{0} productos por fotograma no están entre 1 y 100000.</translation>
    </message>
    <message>
        <source>The folder {0} holds no judgement of a registration.</source>
        <translation>La carpeta {0} no contiene ninguna valoración de un registro.</translation>
    </message>
    <message>
        <source>Make one: glisson-cli sirgn SEQUENCE.json --method icp --out FOLDER.</source>
        <translation>Genere una: glisson-cli sirgn SECUENCIA.json --method icp --out CARPETA.</translation>
    </message>
    <message>
        <source>{0}: {1}.</source>
        <translation>{0}: {1}.</translation>
    </message>
    <message>
        <source>A sequence names frames with a cloud each, and landmarks.</source>
        <translation>Una secuencia nombra fotogramas con una nube de puntos cada uno y puntos de referencia.</translation>
    </message>
    <message>
        <source>it is not an object</source>
        <translation>no es un objeto</translation>
    </message>
    <message>
        <source>it has no list of frames</source>
        <translation>no tiene lista de fotogramas</translation>
    </message>
    <message>
        <source>registered does not name one cloud a frame</source>
        <translation>registered no nombra una nube de puntos por fotograma</translation>
    </message>
    <message>
        <source>registered holds something that is no file name</source>
        <translation>registered contiene algo que no es un nombre de archivo</translation>
    </message>
    <message>
        <source>Frame {0} is missing: there is no file {1}.</source>
        <translation>Falta el fotograma {0}: no hay ningún archivo {1}.</translation>
    </message>
    <message>
        <source>Remove the frame from the sequence (and number the tracks anew), or add it.</source>
        <translation>Quite el fotograma de la secuencia (y renumere las trayectorias) o añádalo.</translation>
    </message>
    <message>
        <source>it names no file of landmarks</source>
        <translation>no nombra ningún archivo de puntos de referencia</translation>
    </message>
    <message>
        <source>Line {1} of {0} is not landmark,frame,x_mm,y_mm,z_mm with a frame below {2}.</source>
        <translation>La línea {1} de {0} no es landmark,frame,x_mm,y_mm,z_mm con un fotograma menor que {2}.</translation>
    </message>
    <message>
        <source>Frame {0} holds no point that is finite.</source>
        <translation>El fotograma {0} no contiene ningún punto finito.</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>fotogramas</translation>
    </message>
    <message>
        <source>Track more features, or mark them by hand.</source>
        <translation>Siga más rasgos o márquelos a mano.</translation>
    </message>
    <message>
        <source>warps</source>
        <translation>deformaciones</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>triángulos</translation>
    </message>
    <message>
        <source>Frame {0} has {1} points, and {2} after registration: they must match one by one.</source>
        <translation>El fotograma {0} tiene {1} puntos, y {2} tras el registro: deben corresponderse uno a uno.</translation>
    </message>
    <message>
        <source>A tolerance must be a positive number of mm.</source>
        <translation>Una tolerancia debe ser un número positivo de mm.</translation>
    </message>
    <message>
        <source>The folder {0} is not empty.</source>
        <translation>La carpeta {0} no está vacía.</translation>
    </message>
    <message>
        <source>Name a new folder for the sequence.</source>
        <translation>Indique una carpeta nueva para la secuencia.</translation>
    </message>
    <message>
        <source>No feature could be followed through {0} frames.</source>
        <translation>Ningún rasgo se pudo seguir a lo largo de {0} fotogramas.</translation>
    </message>
    <message>
        <source>Take more frames, or give landmarks and a model of your own.</source>
        <translation>Tome más fotogramas o indique puntos de referencia y un modelo propios.</translation>
    </message>
    <message>
        <source>matching</source>
        <translation>emparejando</translation>
    </message>
    <message>
        <source>No two frames share four landmarks.</source>
        <translation>No hay dos fotogramas que compartan cuatro puntos de referencia.</translation>
    </message>
    <message>
        <source>Track more features, or leave out fewer frames.</source>
        <translation>Siga más rasgos u omita menos fotogramas.</translation>
    </message>
    <message>
        <source>Two frames or more can be aligned.</source>
        <translation>Se pueden alinear dos fotogramas o más.</translation>
    </message>
    <message>
        <source>aligning frames</source>
        <translation>alineando fotogramas</translation>
    </message>
    <message>
        <source>The distances between the points of the {0} are not square.</source>
        <translation>Las distancias entre los puntos de {0} no forman una matriz cuadrada.</translation>
    </message>
    <message>
        <source>The {0} has fewer than two points to match.</source>
        <translation>{0} tiene menos de dos puntos que emparejar.</translation>
    </message>
    <message>
        <source>The {0} has {1} points to match; {2} is the most.</source>
        <translation>{0} tiene {1} puntos que emparejar; el máximo es {2}.</translation>
    </message>
    <message>
        <source>Some points of the {0} are not connected over the surface.</source>
        <translation>Algunos puntos de {0} no están conectados sobre la superficie.</translation>
    </message>
    <message>
        <source>Keep the largest connected piece, or bridge the gap before matching.</source>
        <translation>Conserve el mayor trozo conexo o cierre el hueco antes de emparejar.</translation>
    </message>
    <message>
        <source>The distances between the points of the {0} are not those of a metric.</source>
        <translation>Las distancias entre los puntos de {0} no son las de una métrica.</translation>
    </message>
    <message>
        <source>The seed must hold one finite cost a source point and target point.</source>
        <translation>La semilla debe contener un coste finito por cada punto de origen y de destino.</translation>
    </message>
    <message>
        <source>sigma, tau and q must be positive.</source>
        <translation>sigma, tau y q deben ser positivos.</translation>
    </message>
    <message>
        <source>The written-out field needs {0} MB; {1} MB are allowed.</source>
        <translation>El campo desarrollado necesita {0} MB; se permiten {1} MB.</translation>
    </message>
    <message>
        <source>No point of one surface has a partner on the other.</source>
        <translation>Ningún punto de una superficie tiene pareja en la otra.</translation>
    </message>
    <message>
        <source>Align the surfaces roughly first, or give landmarks.</source>
        <translation>Alinee antes las superficies de forma aproximada o indique puntos de referencia.</translation>
    </message>
    <message>
        <source>non-rigid alignment</source>
        <translation>alineación no rígida</translation>
    </message>
    <message>
        <source>A landmark names point {0}, which cannot be led anywhere.</source>
        <translation>Un punto de referencia nombra el punto {0}, que no se puede llevar a ninguna parte.</translation>
    </message>
    <message>
        <source>The step of the non-rigid alignment has no solution.</source>
        <translation>El paso de la alineación no rígida no tiene solución.</translation>
    </message>
    <message>
        <source>By their geodesic distances the surfaces match only inside out.</source>
        <translation>Por sus distancias geodésicas, las superficies solo encajan invertidas.</translation>
    </message>
    <message>
        <source>Align them roughly and match with positions as prior, or use more points.</source>
        <translation>Alinéelas de forma aproximada y empareje con las posiciones como información previa, o use más puntos.</translation>
    </message>
    <message>
        <source>{0} points cannot be aligned to {1}.</source>
        <translation>{0} puntos no se pueden alinear con {1}.</translation>
    </message>
    <message>
        <source>A rigid alignment needs three pairs of points that do not lie on one line.</source>
        <translation>Una alineación rígida necesita tres pares de puntos no alineados.</translation>
    </message>
    <message>
        <source>Some of the points to align are not finite.</source>
        <translation>Algunos de los puntos que alinear no son finitos.</translation>
    </message>
    <message>
        <source>rigid alignment</source>
        <translation>alineación rígida</translation>
    </message>
    <message>
        <source>A surface of {0} points cannot give {1} samples.</source>
        <translation>Una superficie de {0} puntos no puede dar {1} muestras.</translation>
    </message>
    <message>
        <source>geodesic distances</source>
        <translation>distancias geodésicas</translation>
    </message>
    <message>
        <source>A spline needs as many finite points to start from as to lead to.</source>
        <translation>Una spline necesita tantos puntos finitos de partida como de llegada.</translation>
    </message>
    <message>
        <source>{0} points are too many for a spline; {1} is the most.</source>
        <translation>{0} puntos son demasiados para una spline; el máximo es {1}.</translation>
    </message>
    <message>
        <source>A spline needs four matched points that do not lie in one plane.</source>
        <translation>Una spline necesita cuatro puntos emparejados que no estén en un plano.</translation>
    </message>
    <message>
        <source>A result lacks the point array {0} with three values a point.</source>
        <translation>A un resultado le falta la matriz de puntos {0} con tres valores por punto.</translation>
    </message>
    <message>
        <source>Compare results of the same mesh.</source>
        <translation>Compare resultados de la misma malla.</translation>
    </message>
    <message>
        <source>The two results are not of the same mesh: {0} points and {1} cells against {2} and {3}.</source>
        <translation>Los dos resultados no son de la misma malla: {0} puntos y {1} celdas frente a {2} y {3}.</translation>
    </message>
    <message>
        <source>The two results are not of the same mesh: point {0} rests at different places.</source>
        <translation>Los dos resultados no son de la misma malla: el punto {0} reposa en lugares distintos.</translation>
    </message>
    <message>
        <source>No part of the surface looks like the liver&apos;s bare area (its upper rear).</source>
        <translation>Ninguna parte de la superficie se parece al área desnuda del hígado (arriba y detrás).</translation>
    </message>
    <message>
        <source>Name the supports in the scenario, by a sphere or a box.</source>
        <translation>Nombre los apoyos en el escenario, con una esfera o una caja.</translation>
    </message>
    <message>
        <source>{0} of the session cannot be read: {1}.</source>
        <translation>No se puede leer {0} de la sesión: {1}.</translation>
    </message>
    <message>
        <source>The cut passes the liver by.</source>
        <translation>La sección no pasa por el hígado.</translation>
    </message>
    <message>
        <source>Move it through the liver; positions are patient coordinates (LPS, mm).</source>
        <translation>Muévala a través del hígado; las posiciones son coordenadas del paciente (LPS, mm).</translation>
    </message>
    <message>
        <source>The point of the specimen lies on the cut, or is not finite.</source>
        <translation>El punto de la pieza quirúrgica está sobre la sección o no es finito.</translation>
    </message>
    <message>
        <source>The step did not converge: after {0} rounds a tool still reaches {1} mm into the surface, which still moves by {2} mm.</source>
        <translation>El paso no ha convergido: tras {0} rondas un instrumento aún penetra {1} mm en la superficie, que aún se mueve {2} mm.</translation>
    </message>
    <message>
        <source>Placing landmarks and structures</source>
        <translation>Colocando los puntos de referencia y las estructuras</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Nathanson liver retractor</source>
        <translation>Separador hepático de Nathanson</translation>
    </message>
    <message>
        <source>A bent rod that lies under the liver as a hook some centimetres across, sold in several sizes. We found no published drawing and no measured force: that it spreads its pull over a disc of 70 mm is our assumption, and 2 N is the weight of 190 ml of liver (1.06 kg/l), what lifting the lower part of segment VI takes. On a real liver&apos;s shape with a uniform 6 kPa, 2 N hoist it by 18 mm; linear elasticity is strained beyond.</source>
        <translation>Una varilla curvada que se apoya bajo el hígado como un gancho de unos centímetros, a la venta en varios tamaños. No hemos encontrado ningún dibujo publicado ni ninguna fuerza medida: que reparta su tracción sobre un disco de 70 mm es una suposición nuestra, y 2 N es el peso de 190 ml de hígado (1.06 kg/l), lo que exige elevar la parte inferior del segmento VI. Con la forma de un hígado real de 6 kPa uniformes, 2 N lo elevan 18 mm; más allá, la elasticidad lineal deja de ser válida.</translation>
    </message>
    <message>
        <source>Grasper</source>
        <translation>Pinza de agarre</translation>
    </message>
    <message>
        <source>Grip forces in porcine laparoscopic liver resection: 1.75 N on average, 3.38 N at most (Minimally Invasive Therapy &amp; Allied Technologies 31(1):28-33, 2022, doi:10.1080/13645706.2020.1755313). The jaw&apos;s patch of 12 mm is our assumption.</source>
        <translation>Fuerzas de agarre en resecciones hepáticas laparoscópicas en cerdos: 1.75 N de media, 3.38 N como máximo (Minimally Invasive Therapy &amp; Allied Technologies 31(1):28-33, 2022, doi:10.1080/13645706.2020.1755313). El contacto de la mordaza, de 12 mm, es una suposición nuestra.</translation>
    </message>
    <message>
        <source>Palpation probe</source>
        <translation>Sonda de palpación</translation>
    </message>
    <message>
        <source>A sphere of 10 mm pressed lightly; size and force are our assumption.</source>
        <translation>Una esfera de 10 mm apretada levemente; el tamaño y la fuerza son suposiciones nuestras.</translation>
    </message>
    <message>
        <source>There is no tool {0}.</source>
        <translation>No hay ningún instrumento {0}.</translation>
    </message>
    <message>
        <source>The tools are: {1}.</source>
        <translation>Los instrumentos son: {1}.</translation>
    </message>
    <message>
        <source>A case has no scene named {0}; it has {1}.</source>
        <translation>Un caso no tiene ninguna escena llamada {0}; tiene {1}.</translation>
    </message>
    <message>
        <source>{0} has no displacement.</source>
        <translation>{0} no tiene desplazamiento.</translation>
    </message>
    <message>
        <source>A picture has from {0} to {1} pixels a side; {2} x {3} were asked for.</source>
        <translation>Una imagen tiene de {0} a {1} píxeles por lado; se pidieron {2} x {3}.</translation>
    </message>
    <message>
        <source>There is nothing to draw with: neither EGL with OpenGL 3.2 nor an X server.</source>
        <translation>No hay con qué dibujar: ni EGL con OpenGL 3.2 ni un servidor X.</translation>
    </message>
    <message>
        <source>Install Mesa&apos;s drivers (on Debian: libegl-mesa0 and libgl1-mesa-dri).</source>
        <translation>Instale los controladores de Mesa (en Debian: libegl-mesa0 y libgl1-mesa-dri).</translation>
    </message>
    <message>
        <source>The picture could not be written: {0}.</source>
        <translation>No se ha podido escribir la imagen: {0}.</translation>
    </message>
    <message>
        <source>Choose a folder that you may write to, on a disk with room.</source>
        <translation>Elija una carpeta en la que pueda escribir, en un disco con espacio.</translation>
    </message>
    <message>
        <source>This is not a PNG picture that can be read: {0}.</source>
        <translation>Esta no es una imagen PNG legible: {0}.</translation>
    </message>
    <message>
        <source>Check that the file is whole.</source>
        <translation>Compruebe que el archivo está completo.</translation>
    </message>
    <message>
        <source>it is larger than 16384 pixels a side</source>
        <translation>tiene más de 16384 píxeles por lado</translation>
    </message>
    <message>
        <source>The picture cannot be drawn: {0}.</source>
        <translation>No se puede dibujar la imagen: {0}.</translation>
    </message>
    <message>
        <source>Every voxel of the image has the same value: there is nothing to grow in.</source>
        <translation>Todos los vóxeles de la imagen tienen el mismo valor: no hay dónde crecer.</translation>
    </message>
    <message>
        <source>Growing</source>
        <translation>Creciendo</translation>
    </message>
    <message>
        <source>No tissue thick enough to be an organ hangs together with the seeds.</source>
        <translation>Ningún tejido lo bastante grueso para ser un órgano está unido a las semillas.</translation>
    </message>
    <message>
        <source>Move the seed into the middle of the liver, away from vessels and edges.</source>
        <translation>Mueva la semilla al centro del hígado, lejos de vasos y bordes.</translation>
    </message>
    <message>
        <source>Smoothing the outline</source>
        <translation>Suavizando el contorno</translation>
    </message>
    <message>
        <source>There is no image value around seed {0}.</source>
        <translation>No hay ningún valor de imagen alrededor de la semilla {0}.</translation>
    </message>
    <message>
        <source>Seed {0} is much brighter ({1}) than seed {2} ({3}): one of them is probably not in the liver. Take it away.</source>
        <translation>La semilla {0} es mucho más clara ({1}) que la semilla {2} ({3}): una de ellas probablemente no está en el hígado. Quítela.</translation>
    </message>
    <message>
        <source>Nothing grew from seed {0}: the tissue around it is too thin or uneven. Move it to the middle of the liver.</source>
        <translation>Nada ha crecido desde la semilla {0}: el tejido que la rodea es demasiado fino o irregular. Muévala al centro del hígado.</translation>
    </message>
    <message>
        <source>The region reaches the side of the image: it has probably leaked into the body wall. Cut it there, or raise neck_radius_mm.</source>
        <translation>La región llega al lado de la imagen: probablemente se ha extendido a la pared abdominal. Córtela ahí o aumente neck_radius_mm.</translation>
    </message>
    <message>
        <source>The region reaches the first or last slice: the liver is not wholly in the image, and its volume is that of the part seen.</source>
        <translation>La región llega al primer o al último corte: el hígado no está entero en la imagen y su volumen es el de la parte visible.</translation>
    </message>
    <message>
        <source>{0} ml is more than a liver holds: the region has probably leaked into a neighbour. Raise neck_radius_mm, or cut it by hand.</source>
        <translation>{0} ml es más de lo que tiene un hígado: la región probablemente se ha extendido a un órgano vecino. Aumente neck_radius_mm o córtela a mano.</translation>
    </message>
    <message>
        <source>{0} ml is less than an adult&apos;s liver holds: the growth has probably stopped early. Add a seed in the part that is missing, or raise tolerance_sd.</source>
        <translation>{0} ml es menos de lo que tiene el hígado de un adulto: el crecimiento probablemente se ha detenido demasiado pronto. Añada una semilla en la parte que falta o aumente tolerance_sd.</translation>
    </message>
    <message>
        <source>An image of {0} x {1} x {2} voxels is too thin to grow in.</source>
        <translation>Una imagen de {0} x {1} x {2} vóxeles es demasiado fina para crecer en ella.</translation>
    </message>
    <message>
        <source>The options of growing must be positive, and one is {0}.</source>
        <translation>Las opciones del crecimiento deben ser positivas, y una es {0}.</translation>
    </message>
    <message>
        <source>There is no seed to grow from.</source>
        <translation>No hay ninguna semilla.</translation>
    </message>
    <message>
        <source>Give at least one point in the middle of the liver.</source>
        <translation>Indique al menos un punto en el centro del hígado.</translation>
    </message>
    <message>
        <source>Seed {0} at ({1}) mm lies {2} mm outside the image.</source>
        <translation>La semilla {0} en ({1}) mm está a {2} mm fuera de la imagen.</translation>
    </message>
    <message>
        <source>Seeds are DICOM patient coordinates (LPS) in mm, not voxel indices.</source>
        <translation>Las semillas son coordenadas DICOM del paciente (LPS) en mm, no índices de vóxeles.</translation>
    </message>
    <message>
        <source>There is no structure to label.</source>
        <translation>No hay ninguna estructura que etiquetar.</translation>
    </message>
    <message>
        <source>The structures {0} and {1} lie on different voxel grids.</source>
        <translation>Las estructuras {0} y {1} están en cuadrículas de vóxeles distintas.</translation>
    </message>
    <message>
        <source>None of the structures is the liver.</source>
        <translation>Ninguna de las estructuras es el hígado.</translation>
    </message>
    <message>
        <source>Segment it first, or name a structure &quot;liver&quot;.</source>
        <translation>Segméntelo antes o llame &quot;liver&quot; a una estructura.</translation>
    </message>
    <message>
        <source>The structure {0} holds no voxels.</source>
        <translation>La estructura {0} no contiene vóxeles.</translation>
    </message>
    <message>
        <source>The two masks lie on different voxel grids.</source>
        <translation>Las dos máscaras están en cuadrículas de vóxeles distintas.</translation>
    </message>
    <message>
        <source>There are no patients in this cohort.</source>
        <translation>No hay pacientes en esta cohorte.</translation>
    </message>
    <message>
        <source>The cohort has no patient {0}.</source>
        <translation>La cohorte no tiene al paciente {0}.</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Paciente</translation>
    </message>
    <message>
        <source>None of the {0} patients could be used; the first one: {1}</source>
        <translation>No se ha podido usar ninguno de los {0} pacientes; el primero: {1}</translation>
    </message>
    <message>
        <source>{0} holds files that are not an earlier demo&apos;s.</source>
        <translation>{0} contiene archivos que no son de una demostración anterior.</translation>
    </message>
    <message>
        <source>Choose an empty or a new folder.</source>
        <translation>Elija una carpeta vacía o nueva.</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Dibujando</translation>
    </message>
    <message>
        <source>simulating the MR images</source>
        <translation>simulando las imágenes de RM</translation>
    </message>
    <message>
        <source>simulating the elastography</source>
        <translation>simulando la elastografía</translation>
    </message>
    <message>
        <source>writing the study</source>
        <translation>escribiendo el estudio</translation>
    </message>
    <message>
        <source>writing the truth</source>
        <translation>escribiendo los valores verdaderos</translation>
    </message>
    <message>
        <source>Check the folder and your rights there.</source>
        <translation>Compruebe la carpeta y sus permisos en ella.</translation>
    </message>
    <message>
        <source>{0} holds none of the scans, such as A-1.69N.ply.</source>
        <translation>{0} no contiene ninguno de los escaneos, como A-1.69N.ply.</translation>
    </message>
    <message>
        <source>None of the trials could be compared; the first one: {0}</source>
        <translation>No se ha podido comparar ningún ensayo; el primero: {0}</translation>
    </message>
    <message>
        <source>The phantom&apos;s equilibrium was not reached: {0}</source>
        <translation>No se ha alcanzado el equilibrio del maniquí: {0}</translation>
    </message>
    <message>
        <source>The two judge different videos: {0} and {1}.</source>
        <translation>Los dos valoran vídeos distintos: {0} y {1}.</translation>
    </message>
    <message>
        <source>Judge both registrations on the same sequence.json.</source>
        <translation>Valore ambos registros con el mismo sequence.json.</translation>
    </message>
    <message>
        <source>The sequence names no camera to draw with.</source>
        <translation>La secuencia no nombra ninguna cámara con la que dibujar.</translation>
    </message>
    <message>
        <source>Add &quot;camera&quot;: {&quot;matrix&quot;: [3x3], &quot;distortion&quot;: [..]}.</source>
        <translation>Añada &quot;camera&quot;: {&quot;matrix&quot;: [3x3], &quot;distortion&quot;: [..]}.</translation>
    </message>
    <message>
        <source>Frame {0} of the sequence names no image.</source>
        <translation>El fotograma {0} de la secuencia no nombra ninguna imagen.</translation>
    </message>
    <message>
        <source>Add &quot;image&quot; to each frame.</source>
        <translation>Añada &quot;image&quot; a cada fotograma.</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>imágenes</translation>
    </message>
    <message>
        <source>Sample {0} of {1} has a size, a way or a force that is not positive.</source>
        <translation>La muestra {0} de {1} tiene un tamaño, un recorrido o una fuerza que no es positivo.</translation>
    </message>
    <message>
        <source>No labelled voxel of {0} lies where {1} has a stiffness.</source>
        <translation>Ningún vóxel etiquetado de {0} está donde {1} tiene una rigidez.</translation>
    </message>
    <message>
        <source>Material {0} was never put under the testing machine.</source>
        <translation>El material {0} nunca se puso en la máquina de ensayos.</translation>
    </message>
    <message>
        <source>Give its samples in the file of tests, or leave the region out.</source>
        <translation>Indique sus muestras en el archivo de ensayos u omita la región.</translation>
    </message>
    <message>
        <source>A board has from {0} to {1} points a side and a positive spacing; {2} x {3} at {4} mm were given.</source>
        <translation>Un tablero tiene de {0} a {1} puntos por lado y un espaciado positivo; se indicaron {2} x {3} a {4} mm.</translation>
    </message>
    <message>
        <source>The picture shows no board of {0} x {1} points.</source>
        <translation>La imagen no muestra ningún tablero de {0} x {1} puntos.</translation>
    </message>
    <message>
        <source>Count inner corners or circles, columns first; the board must be sharp and lit.</source>
        <translation>Cuente las esquinas interiores o los círculos, primero las columnas; el tablero debe estar nítido e iluminado.</translation>
    </message>
    <message>
        <source>{0} has {1} x {2} pixels, the first picture has {3} x {4}.</source>
        <translation>{0} tiene {1} x {2} píxeles, la primera imagen tiene {3} x {4}.</translation>
    </message>
    <message>
        <source>{0} of {1} pairs show the board to both eyes; {2} are needed.</source>
        <translation>{0} de {1} pares muestran el tablero a ambos ojos; hacen falta {2}.</translation>
    </message>
    <message>
        <source>Check the board&apos;s kind, its columns and rows; take it from several sides.</source>
        <translation>Compruebe el tipo de tablero, sus columnas y filas; tómelo desde varios lados.</translation>
    </message>
    <message>
        <source>The calibration did not converge: {0}.</source>
        <translation>La calibración no ha convergido: {0}.</translation>
    </message>
    <message>
        <source>By these pictures the right eye lies to the left of the left one.</source>
        <translation>Según estas imágenes el ojo derecho está a la izquierda del izquierdo.</translation>
    </message>
    <message>
        <source>Exchange the left and the right pictures.</source>
        <translation>Intercambie las imágenes izquierda y derecha.</translation>
    </message>
    <message>
        <source>The calibration {0} has no {1}.</source>
        <translation>A la calibración {0} le falta: {1}.</translation>
    </message>
    <message>
        <source>It needs left and right, each with a matrix and distortion, and left_to_right.</source>
        <translation>Necesita left y right, cada uno con matriz y distorsión, y left_to_right.</translation>
    </message>
    <message>
        <source>A camera&apos;s focal length is not positive.</source>
        <translation>La distancia focal de una cámara no es positiva.</translation>
    </message>
    <message>
        <source>A coefficient of distortion is not finite.</source>
        <translation>Un coeficiente de distorsión no es finito.</translation>
    </message>
    <message>
        <source>Both eyes are in one place: there is no depth to see.</source>
        <translation>Ambos ojos están en el mismo lugar: no se ve ninguna profundidad.</translation>
    </message>
    <message>
        <source>left_to_right does not hold a rotation: R R^T or the last row is off by {0}.</source>
        <translation>left_to_right no contiene una rotación: R R^T o la última fila se desvía {0}.</translation>
    </message>
    <message>
        <source>The picture {0} cannot be read.</source>
        <translation>No se puede leer la imagen {0}.</translation>
    </message>
    <message>
        <source>PNG, JPEG, TIFF and BMP are read.</source>
        <translation>Se leen PNG, JPEG, TIFF y BMP.</translation>
    </message>
    <message>
        <source>The picture {0} cannot be written.</source>
        <translation>No se puede escribir la imagen {0}.</translation>
    </message>
    <message>
        <source>The folder must exist, and the name end in .png or .jpg.</source>
        <translation>La carpeta debe existir y el nombre terminar en .png o .jpg.</translation>
    </message>
    <message>
        <source>The folder {0} holds no pictures.</source>
        <translation>La carpeta {0} no contiene imágenes.</translation>
    </message>
    <message>
        <source>The video {0} cannot be read.</source>
        <translation>No se puede leer el vídeo {0}.</translation>
    </message>
    <message>
        <source>Give a video file that OpenCV (FFmpeg) reads, or a folder of pictures.</source>
        <translation>Indique un archivo de vídeo que lea OpenCV (FFmpeg) o una carpeta de imágenes.</translation>
    </message>
    <message>
        <source>The video {0} cannot be decoded: {1}.</source>
        <translation>No se puede decodificar el vídeo {0}: {1}.</translation>
    </message>
    <message>
        <source>A picture of {0} has {1} x {2} pixels, the first has {3} x {4}.</source>
        <translation>Una imagen de {0} tiene {1} x {2} píxeles, la primera tiene {3} x {4}.</translation>
    </message>
    <message>
        <source>The pair could not be matched: {0}.</source>
        <translation>No se ha podido emparejar el par: {0}.</translation>
    </message>
    <message>
        <source>The calibration is not of these pictures: half of the {0} features that both show miss their epipolar lines by {1} pixels or more.</source>
        <translation>La calibración no es de estas imágenes: la mitad de los {0} rasgos que ambas muestran se aparta de sus líneas epipolares {1} píxeles o más.</translation>
    </message>
    <message>
        <source>Check that the calibration is this camera&apos;s, at this size of picture, and that left and right are not exchanged.</source>
        <translation>Compruebe que la calibración es de esta cámara, con este tamaño de imagen, y que izquierda y derecha no están intercambiadas.</translation>
    </message>
    <message>
        <source>By the calibration, {0} % of what both pictures show would lie behind the camera.</source>
        <translation>Según la calibración, el {0} % de lo que muestran ambas imágenes estaría detrás de la cámara.</translation>
    </message>
    <message>
        <source>Left and right pictures are exchanged, or the calibration is of another camera.</source>
        <translation>Las imágenes izquierda y derecha están intercambiadas o la calibración es de otra cámara.</translation>
    </message>
    <message>
        <source>The nearest depth must be positive and less than the farthest.</source>
        <translation>La profundidad más próxima debe ser positiva y menor que la más lejana.</translation>
    </message>
    <message>
        <source>The calibration is of pictures of another size: its principal point {0}, {1} lies outside {2} x {3} pixels.</source>
        <translation>La calibración es de imágenes de otro tamaño: su punto principal {0}, {1} está fuera de {2} x {3} píxeles.</translation>
    </message>
    <message>
        <source>Calibrate at the size of the video, or scale the calibration&apos;s matrices.</source>
        <translation>Calibre con el tamaño del vídeo o escale las matrices de la calibración.</translation>
    </message>
    <message>
        <source>The left image is {0} x {1} pixels, the right one {2} x {3}.</source>
        <translation>La imagen izquierda tiene {0} x {1} píxeles, la derecha {2} x {3}.</translation>
    </message>
    <message>
        <source>The images are {0} x {1} pixels; {2} x {3} were expected.</source>
        <translation>Las imágenes tienen {0} x {1} píxeles; se esperaban {2} x {3}.</translation>
    </message>
    <message>
        <source>There are {0} left and {1} right pictures: they must be taken in pairs.</source>
        <translation>Hay {0} imágenes izquierdas y {1} derechas: deben tomarse por pares.</translation>
    </message>
    <message>
        <source>calibrating</source>
        <translation>calibrando</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>No hay memoria suficiente para esto.</translation>
    </message>
    <message>
        <source>--channel wants COLUMN:AMPERES_PER_VOLT:SUPPLY_VOLTAGE[:CLIPS_AT], not &quot;{0}&quot;.</source>
        <translation>--channel espera COLUMN:AMPERES_PER_VOLT:SUPPLY_VOLTAGE[:CLIPS_AT], no «{0}».</translation>
    </message>
    <message>
        <source>A column that holds watts is just COLUMN.</source>
        <translation>Una columna que contiene vatios es simplemente COLUMN.</translation>
    </message>
    <message>
        <source>Nothing was measured.</source>
        <translation>No se ha medido nada.</translation>
    </message>
    <message>
        <source>There is no device &quot;{0}&quot;.</source>
        <translation>No hay ningún dispositivo «{0}».</translation>
    </message>
    <message>
        <source>glisson-cli platform list shows their ids.</source>
        <translation>glisson-cli platform list muestra sus identificadores.</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Leyendo</translation>
    </message>
    <message>
        <source>The points of a cut need three columns: x_mm, y_mm, z_mm.</source>
        <translation>Los puntos de una sección necesitan tres columnas: x_mm, y_mm, z_mm.</translation>
    </message>
    <message>
        <source>Reading the liver</source>
        <translation>Leyendo el hígado</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Seccionando</translation>
    </message>
    <message>
        <source>Reading the model</source>
        <translation>Leyendo el modelo</translation>
    </message>
    <message>
        <source>Moving the tools</source>
        <translation>Moviendo los instrumentos</translation>
    </message>
    <message>
        <source>Command {0} led to another state than was recorded.</source>
        <translation>La orden {0} llevó a un estado distinto del registrado.</translation>
    </message>
    <message>
        <source>Replay with the case and the version that it was recorded with.</source>
        <translation>Reproduzca con el caso y la versión con los que se registró.</translation>
    </message>
    <message>
        <source>{0} wants a position X,Y,Z in mm, not &quot;{1}&quot;.</source>
        <translation>{0} espera una posición X,Y,Z en mm, no «{1}».</translation>
    </message>
    <message>
        <source>--size wants WxH in pixels, 16 to 16384 each, not &quot;{0}&quot;.</source>
        <translation>--size espera ANCHOxALTO en píxeles, de 16 a 16384 cada uno, no «{0}».</translation>
    </message>
    <message>
        <source>The computation did not converge: {0}</source>
        <translation>El cálculo no ha convergido: {0}</translation>
    </message>
    <message>
        <source>The sequence names no registered clouds.</source>
        <translation>La secuencia no nombra nubes de puntos registradas.</translation>
    </message>
    <message>
        <source>Add &quot;registered&quot;, or choose --method icp or geo.</source>
        <translation>Añada &quot;registered&quot; o elija --method icp o geo.</translation>
    </message>
    <message>
        <source>The sequence names no model to register its clouds to.</source>
        <translation>La secuencia no nombra ningún modelo al que registrar sus nubes de puntos.</translation>
    </message>
    <message>
        <source>Add &quot;model&quot;: a surface file.</source>
        <translation>Añada &quot;model&quot;: un archivo de superficie.</translation>
    </message>
    <message>
        <source>Frame {0} shares too few landmarks with the others.</source>
        <translation>El fotograma {0} comparte demasiado pocos puntos de referencia con los demás.</translation>
    </message>
    <message>
        <source>The two pictures agree nowhere.</source>
        <translation>Las dos imágenes no coinciden en ninguna parte.</translation>
    </message>
    <message>
        <source>Check that left and right are not exchanged and that the calibration is theirs.</source>
        <translation>Compruebe que izquierda y derecha no están intercambiadas y que la calibración es la suya.</translation>
    </message>
    <message>
        <source>Name the cohort&apos;s folder, or ask for a simulated one with --simulated N.</source>
        <translation>Indique la carpeta de la cohorte o pida una simulada con --simulated N.</translation>
    </message>
    <message>
        <source>Reading the case</source>
        <translation>Leyendo el caso</translation>
    </message>
    <message>
        <source>Preparing the model</source>
        <translation>Preparando el modelo</translation>
    </message>
    <message>
        <source>Known are: {1}</source>
        <translation>Se conocen: {1}</translation>
    </message>
    <message>
        <source>Cut {0} opens the body nowhere.</source>
        <translation>La sección {0} no abre el cuerpo en ninguna parte.</translation>
    </message>
    <message>
        <source>Move it through the body, or open it wider; positions are LPS, in mm.</source>
        <translation>Muévala a través del cuerpo o ábrala más; las posiciones son LPS, en mm.</translation>
    </message>
    <message>
        <source>{0} needs exactly one of &quot;normal&quot; (a plane) and &quot;points_mm&quot; (a sheet through them).</source>
        <translation>{0} necesita exactamente uno de &quot;normal&quot; (un plano) y &quot;points_mm&quot; (una superficie que pasa por ellos).</translation>
    </message>
    <message>
        <source>{0} is a sheet: its &quot;center_mm&quot; needs the &quot;radius_mm&quot; that it is open within.</source>
        <translation>{0} es una superficie: su &quot;center_mm&quot; necesita el &quot;radius_mm&quot; dentro del cual está abierta.</translation>
    </message>
    <message>
        <source>{0} must be a list of three points or more.</source>
        <translation>{0} debe ser una lista de al menos tres puntos.</translation>
    </message>
    <message>
        <source>{0} needs exactly one of &quot;{1}&quot; and &quot;{2}&quot;.</source>
        <translation>{0} necesita exactamente uno de &quot;{1}&quot; y &quot;{2}&quot;.</translation>
    </message>
    <message>
        <source>{0} must be &quot;nathanson-retractor&quot;, &quot;palpation-probe&quot; or {&quot;rods&quot;: [...]}.</source>
        <translation>{0} debe ser &quot;nathanson-retractor&quot;, &quot;palpation-probe&quot; o {&quot;rods&quot;: [...]}.</translation>
    </message>
    <message>
        <source>Straight from data there are equilibria by finite elements: without a motion, a capsule, ligaments, tools or the meshfree engine.</source>
        <translation>Directamente a partir de datos hay equilibrios por elementos finitos: sin movimiento, cápsula, ligamentos, instrumentos ni motor sin malla.</translation>
    </message>
    <message>
        <source>At {0} Hz the phase of {1} % of the tissue does not come back to itself over a period; those voxels were left out.</source>
        <translation>A {0} Hz la fase del {1} % del tejido no vuelve a sí misma en un periodo; esos vóxeles se han omitido.</translation>
    </message>
    <message>
        <source>The loss came out negative, as when the instants run backwards in time; its sign was turned.</source>
        <translation>La pérdida salió negativa, como cuando los instantes van hacia atrás en el tiempo; se ha invertido su signo.</translation>
    </message>
    <message>
        <source>The headers name no directions: the {0} images were taken as {1} x {2} instants in their order.</source>
        <translation>Las cabeceras no nombran direcciones: las {0} imágenes se han tomado como {1} x {2} instantes en su orden.</translation>
    </message>
    <message>
        <source>The phase images have no unit: their full range, {0} to {1}, was taken as one turn.</source>
        <translation>Las imágenes de fase no tienen unidad: su intervalo completo, de {0} a {1}, se ha tomado como una vuelta.</translation>
    </message>
    <message>
        <source>The plan has no figure for the effect {0}; it is left out.</source>
        <translation>El plan no tiene ninguna cifra para el efecto {0}; se omite.</translation>
    </message>
    <message>
        <source>{0} was not learnt from the recordings of a platform.</source>
        <translation>{0} no se aprendió de los registros de una plataforma.</translation>
    </message>
    <message>
        <source>Use the model.json that glisson-cli explain wrote for an experiment of kind &quot;platform&quot;.</source>
        <translation>Use el model.json que glisson-cli explain escribió para un experimento del tipo &quot;platform&quot;.</translation>
    </message>
    <message>
        <source>A smooth correction has no cause and is left out of the plan.</source>
        <translation>Una corrección suave no tiene causa y queda fuera del plan.</translation>
    </message>
    <message>
        <source>These recordings are not explained by the effects found: they take a part of the error away, and are no proof of a cause.</source>
        <translation>Los efectos encontrados no explican estos registros: quitan una parte del error y no prueban ninguna causa.</translation>
    </message>
    <message>
        <source>The experiment is not of kind &quot;material&quot;: it holds no strain and stress.</source>
        <translation>El experimento no es del tipo &quot;material&quot;: no contiene deformación ni tensión.</translation>
    </message>
    <message>
        <source>A shear test cannot be used straight: take compression or tension.</source>
        <translation>Un ensayo de cizalla no se puede usar directamente: tome compresión o tracción.</translation>
    </message>
    <message>
        <source>A figure is measured, computed, from the dissertation (dissertation), or assumed.</source>
        <translation>Una cifra está medida (measured), calculada (computed), procede de la tesis (dissertation) o es supuesta (assumed).</translation>
    </message>
    <message>
        <source>It slows itself down at {0} C, and then computes {1} frames a second of {2}.</source>
        <translation>Se ralentiza a {0} C y entonces calcula {1} fotogramas por segundo de {2}.</translation>
    </message>
    <message>
        <source>The resolution for {0} mm in tissue of {1} kPa comes from this curve ({2}): {3}</source>
        <translation>La resolución para {0} mm en tejido de {1} kPa procede de esta curva ({2}): {3}</translation>
    </message>
    <message>
        <source>No beam of 50 x 10 x 10 mm fits into the liver.</source>
        <translation>Ninguna viga de 50 x 10 x 10 mm cabe en el hígado.</translation>
    </message>
    <message>
        <source>A beam found no equilibrium: {0}</source>
        <translation>Una viga no encontró el equilibrio: {0}</translation>
    </message>
    <message>
        <source>With {0} nodes the beam did not converge: {1}</source>
        <translation>Con {0} nodos la viga no ha convergido: {1}</translation>
    </message>
    <message>
        <source>Looking for the softest, stiffest and most uneven parts</source>
        <translation>Buscando las partes más blandas, más rígidas y más irregulares</translation>
    </message>
    <message>
        <source>Hoisting the beams</source>
        <translation>Elevando las vigas</translation>
    </message>
    <message>
        <source>Drawing typical and extreme patients</source>
        <translation>Dibujando pacientes típicos y extremos</translation>
    </message>
    <message>
        <source>{0} has no effect that could be accepted: nothing is missing.</source>
        <translation>{0} no contiene ningún efecto que aceptar: no falta nada.</translation>
    </message>
    <message>
        <source>The effect {0} was not accepted into {1}.</source>
        <translation>El efecto {0} no se había aceptado en {1}.</translation>
    </message>
    <message>
        <source>The accepted evidence of {0} cannot be read: {1}</source>
        <translation>No se puede leer la evidencia aceptada de {0}: {1}</translation>
    </message>
    <message>
        <source>Take it back (glisson-cli accept CASE --take-back) and accept it again.</source>
        <translation>Retírela (glisson-cli accept CASE --take-back) y acéptela de nuevo.</translation>
    </message>
    <message>
        <source>The model was made anew after this evidence had been accepted: see whether it still holds.</source>
        <translation>El modelo se hizo de nuevo después de aceptar esta evidencia: compruebe si sigue siendo válida.</translation>
    </message>
    <message>
        <source>The scenario says itself what holds the organ: the effect {0} is left out.</source>
        <translation>El escenario dice por sí mismo qué sujeta el órgano: el efecto {0} se omite.</translation>
    </message>
    <message>
        <source>The scenario says itself how stiff the organ is: the effect {0} is left out.</source>
        <translation>El escenario dice por sí mismo la rigidez del órgano: el efecto {0} se omite.</translation>
    </message>
    <message>
        <source>The scenario says itself what skin the organ has: the effect {0} is left out.</source>
        <translation>El escenario dice por sí mismo qué envoltura tiene el órgano: el efecto {0} se omite.</translation>
    </message>
    <message>
        <source>Only a linear equilibrium by finite elements can have a fibre direction: the effect {0} is left out.</source>
        <translation>Solo un equilibrio lineal por elementos finitos puede tener una dirección de fibras: el efecto {0} se omite.</translation>
    </message>
    <message>
        <source>{0} was not learnt from tissue.</source>
        <translation>{0} no se aprendió de un tejido.</translation>
    </message>
    <message>
        <source>Use the model.json that glisson-cli explain wrote for a palpation or a material test; a platform&apos;s goes to glisson-cli platform learn.</source>
        <translation>Use el model.json que glisson-cli explain escribió para una palpación o un ensayo de material; el de una plataforma va a glisson-cli platform learn.</translation>
    </message>
    <message>
        <source>In {0} no tissue can have such a {1}.</source>
        <translation>En {0}, ningún tejido puede tener tal {1}.</translation>
    </message>
    <message>
        <source>{0} has no effect {1}.</source>
        <translation>{0} no tiene ningún efecto {1}.</translation>
    </message>
    <message>
        <source>What loaded the specimen while it was measured does not load the organ.</source>
        <translation>Lo que cargaba la muestra durante la medición no carga el órgano.</translation>
    </message>
    <message>
        <source>A pressure of {0} kPa acts on the organ all the time.</source>
        <translation>Una presión de {0} kPa actúa siempre sobre el órgano.</translation>
    </message>
    <message>
        <source>A weight acts on the organ all the time, by ({0}, {1}, {2}) m/s2.</source>
        <translation>Un peso actúa siempre sobre el órgano, de ({0}, {1}, {2}) m/s2.</translation>
    </message>
    <message>
        <source>The organ is {0} times as stiff along ({1}, {2}, {3}) as across.</source>
        <translation>El órgano es {0} veces tan rígido a lo largo de ({1}, {2}, {3}) como a través.</translation>
    </message>
    <message>
        <source>The organ is {0} times as stiff along ({1}, {2}, {3}) as across: the specimen&apos;s axes are taken for the patient&apos;s.</source>
        <translation>El órgano es {0} veces tan rígido a lo largo de ({1}, {2}, {3}) como a través: los ejes de la muestra se toman por los del paciente.</translation>
    </message>
    <message>
        <source>The whole organ is {0} times as stiff as was declared.</source>
        <translation>El órgano entero es {0} veces tan rígido como se declaró.</translation>
    </message>
    <message>
        <source>The specimen&apos;s hard spot has no place in the organ: the specimen is not this organ in this place.</source>
        <translation>El punto duro de la muestra no tiene lugar en el órgano: la muestra no es este órgano en este lugar.</translation>
    </message>
    <message>
        <source>A spot of {0} mm radius at ({1}, {2}, {3}) is {4} times as stiff as around it.</source>
        <translation>Una zona de {0} mm de radio en ({1}, {2}, {3}) es {4} veces tan rígida como su entorno.</translation>
    </message>
    <message>
        <source>What holds the organ gives way like a spring of {0} kPa/mm.</source>
        <translation>Lo que sujeta el órgano cede como un muelle de {0} kPa/mm.</translation>
    </message>
    <message>
        <source>A skin of {0} N/mm lies around the organ.</source>
        <translation>Una envoltura de {0} N/mm rodea el órgano.</translation>
    </message>
    <message>
        <source>The load cell was off: that is of the measurement, and leaves the organ as it is.</source>
        <translation>La célula de carga estaba desajustada: eso atañe a la medición y deja el órgano como está.</translation>
    </message>
    <message>
        <source>The camera&apos;s frame was off: that is of the measurement, and leaves the organ as it is.</source>
        <translation>El sistema de la cámara estaba desplazado: eso atañe a la medición y deja el órgano como está.</translation>
    </message>
    <message>
        <source>This linear rehearsal cannot hold the effect {0}.</source>
        <translation>Este ensayo lineal no puede recoger el efecto {0}.</translation>
    </message>
    <message>
        <source>A smooth correction has no cause and is left out of the rehearsal.</source>
        <translation>Una corrección suave no tiene causa y queda fuera del ensayo.</translation>
    </message>
    <message>
        <source>These measurements are not explained by the effects found: they take a part of the error away, and are no proof of a cause.</source>
        <translation>Los efectos encontrados no explican estas mediciones: quitan una parte del error y no prueban ninguna causa.</translation>
    </message>
    <message>
        <source>A grain needs an axis of some length and a ratio above zero.</source>
        <translation>Una dirección de fibras necesita un eje de cierta longitud y una razón mayor que cero.</translation>
    </message>
    <message>
        <source>With a ratio of {0} along the grain no stable material is left at a Poisson&apos;s ratio of {1}.</source>
        <translation>Con una razón de {0} a lo largo de las fibras no queda ningún material estable con un coeficiente de Poisson de {1}.</translation>
    </message>
    <message>
        <source>A grain is there for equilibrium by finite elements, with the material &quot;linear&quot; and without ligaments.</source>
        <translation>Una dirección de fibras existe para el equilibrio por elementos finitos, con el material &quot;linear&quot; y sin ligamentos.</translation>
    </message>
    <message>
        <source>{0} would not come out as it was.</source>
        <translation>{0} no quedaría tal como estaba.</translation>
    </message>
    <message>
        <source>{0} is open in another window: what is done here cannot be undone.</source>
        <translation>{0} está abierto en otra ventana: lo que se haga aquí no se puede deshacer.</translation>
    </message>
    <message>
        <source>Close the other window, then open the case anew.</source>
        <translation>Cierre la otra ventana y vuelva a abrir el caso.</translation>
    </message>
    <message>
        <source>There is nothing left to undo.</source>
        <translation>No queda nada por deshacer.</translation>
    </message>
    <message>
        <source>There is nothing left to redo.</source>
        <translation>No queda nada por rehacer.</translation>
    </message>
    <message>
        <source>{0} has been changed by something else since: what was done before cannot be undone any more.</source>
        <translation>Otro programa ha modificado {0} desde entonces: lo hecho antes ya no se puede deshacer.</translation>
    </message>
    <message>
        <source>The history of the case cannot be read: {0}.</source>
        <translation>No se puede leer el historial del caso: {0}.</translation>
    </message>
    <message>
        <source>A stored step of the history does not fit its case.</source>
        <translation>Un paso guardado del historial no corresponde a su caso.</translation>
    </message>
    <message>
        <source>A stored step of the history reaches beyond its image.</source>
        <translation>Un paso guardado del historial sobrepasa los límites de su imagen.</translation>
    </message>
    <message>
        <source>A stored step of the history is cut off.</source>
        <translation>Un paso guardado del historial está truncado.</translation>
    </message>
    <message>
        <source>{0} does not hold a planned resection: {1}.</source>
        <translation>{0} no contiene una resección planificada: {1}.</translation>
    </message>
    <message>
        <source>Plan it again, or make one with glisson-cli resect.</source>
        <translation>Planifíquela de nuevo o cree una con glisson-cli resect.</translation>
    </message>
    <message>
        <source>Reading the experiment</source>
        <translation>Leyendo el experimento</translation>
    </message>
    <message>
        <source>no model was given, so there is no distance from it (RMSE)</source>
        <translation>no se dio ningún modelo, así que no hay distancia a él (RMSE)</translation>
    </message>
    <message>
        <source>The movie {0} cannot be written.</source>
        <translation>No se puede escribir la película {0}.</translation>
    </message>
    <message>
        <source>Choose a folder that exists.</source>
        <translation>Elija una carpeta que exista.</translation>
    </message>
    <message>
        <source>Choose a name that is not there yet.</source>
        <translation>Elija un nombre que aún no exista.</translation>
    </message>
    <message>
        <source>Choose a folder in which you may write.</source>
        <translation>Elija una carpeta en la que pueda escribir.</translation>
    </message>
    <message>
        <source>Leave the window&apos;s size as it is while the movie is made.</source>
        <translation>No cambie el tamaño de la ventana mientras se hace la película.</translation>
    </message>
    <message>
        <source>Choose a folder in which you may write, or a name without .mp4: then it becomes a folder of pictures.</source>
        <translation>Elija una carpeta en la que pueda escribir, o un nombre sin .mp4: entonces será una carpeta de imágenes.</translation>
    </message>
    <message>
        <source>Look whether the disk is full.</source>
        <translation>Compruebe si el disco está lleno.</translation>
    </message>
    <message>
        <source>The liver&apos;s shape with the tools there was not found: {0}</source>
        <translation>No se halló la forma del hígado con los instrumentos allí: {0}</translation>
    </message>
    <message>
        <source>Press less, or move the tool by smaller steps.</source>
        <translation>Apriete menos, o mueva el instrumento a pasos más pequeños.</translation>
    </message>
    <message>
        <source>A rigid tool that only touches the liver cannot pull it.</source>
        <translation>Un instrumento rígido que solo toca el hígado no puede tirar de él.</translation>
    </message>
    <message>
        <source>Push into the surface, or take the grasper.</source>
        <translation>Empuje hacia la superficie, o tome la pinza.</translation>
    </message>
    <message>
        <source>Tool {0} would move by {1} mm a step, past a surface that it should meet.</source>
        <translation>El instrumento {0} se movería {1} mm en un paso y pasaría de largo una superficie que debería tocar.</translation>
    </message>
    <message>
        <source>Take more steps: at most half the radius of the tool&apos;s rods in each.</source>
        <translation>Tome más pasos: en cada uno, como mucho la mitad del radio de las varillas del instrumento.</translation>
    </message>
    <message>
        <source>Comparing the files with what they were made from</source>
        <translation>Comparando los archivos con aquello de lo que se hicieron</translation>
    </message>
    <message>
        <source>{0} does not hold a report of measurements: {1}.</source>
        <translation>{0} no contiene un informe de mediciones: {1}.</translation>
    </message>
    <message>
        <source>Open an experiment to make one; it holds report.json, report.html and model.json.</source>
        <translation>Abra un experimento para crear uno; contiene report.json, report.html y model.json.</translation>
    </message>
    <message>
        <source>Two series are to be the {0}: {1} is the second.</source>
        <translation>Dos series deben ser {0}: {1} es la segunda.</translation>
    </message>
    <message>
        <source>Leave one of them out, or give it another role.</source>
        <translation>Omita una de ellas o dele otra función.</translation>
    </message>
    <message>
        <source>No series is chosen: give at least one of them a role.</source>
        <translation>No se ha elegido ninguna serie: dé una función a al menos una.</translation>
    </message>
    <message>
        <source>There is nothing of this structure at that place.</source>
        <translation>En ese lugar no hay nada de esta estructura.</translation>
    </message>
    <message>
        <source>Fill between slices of {0}</source>
        <translation>Rellenar entre cortes de {0}</translation>
    </message>
    <message>
        <source>Fill holes of {0}</source>
        <translation>Rellenar huecos de {0}</translation>
    </message>
    <message>
        <source>Keep the largest piece of {0}</source>
        <translation>Conservar el trozo mayor de {0}</translation>
    </message>
    <message>
        <source>Remove small pieces of {0}</source>
        <translation>Quitar trozos pequeños de {0}</translation>
    </message>
    <message>
        <source>Smooth {0}</source>
        <translation>Suavizar {0}</translation>
    </message>
    <message>
        <source>Margin around {0}</source>
        <translation>Margen alrededor de {0}</translation>
    </message>
    <message>
        <source>Shrink {0}</source>
        <translation>Reducir {0}</translation>
    </message>
    <message>
        <source>Keep one piece of {0}</source>
        <translation>Conservar un trozo de {0}</translation>
    </message>
    <message>
        <source>Smart brush on {0}</source>
        <translation>Pincel selectivo en {0}</translation>
    </message>
    <message>
        <source>Brush on {0}</source>
        <translation>Pincel en {0}</translation>
    </message>
    <message>
        <source>Eraser on {0}</source>
        <translation>Goma en {0}</translation>
    </message>
    <message>
        <source>Scissors on {0}</source>
        <translation>Tijeras en {0}</translation>
    </message>
    <message>
        <source>New structure {0}</source>
        <translation>Estructura nueva {0}</translation>
    </message>
    <message>
        <source>Rename {0}</source>
        <translation>Renombrar {0}</translation>
    </message>
    <message>
        <source>Remove {0}</source>
        <translation>Quitar {0}</translation>
    </message>
    <message>
        <source>The model cannot be used. Build it anew.</source>
        <translation>El modelo no se puede usar. Vuelva a construirlo.</translation>
    </message>
    <message>
        <source>Place the tool</source>
        <translation>Colocar el instrumento</translation>
    </message>
    <message>
        <source>Take the tool away</source>
        <translation>Retirar el instrumento</translation>
    </message>
    <message>
        <source>Move the tool</source>
        <translation>Mover el instrumento</translation>
    </message>
    <message>
        <source>Change the force</source>
        <translation>Cambiar la fuerza</translation>
    </message>
    <message>
        <source>No images were found in {0}.</source>
        <translation>No se encontraron imágenes en {0}.</translation>
    </message>
    <message>
        <source>By the meshfree engine a grasper pulls with a force; {0} has a displacement.</source>
        <translation>Con el motor sin malla una pinza tira con una fuerza; {0} tiene un desplazamiento.</translation>
    </message>
    <message>
        <source>Give it a pull, or take finite elements.</source>
        <translation>Dele una tracción, o tome los elementos finitos.</translation>
    </message>
    <message>
        <source>camera has no 3 x 3 matrix with positive focal lengths, or a distortion that is no list of numbers</source>
        <translation>camera no tiene una matriz 3 x 3 con distancias focales positivas, o su distorsión no es una lista de números</translation>
    </message>
    <message>
        <source>The first line of {0} is not {1}.</source>
        <translation>La primera línea de {0} no es {1}.</translation>
    </message>
    <message>
        <source>Name the columns so, in this order, with commas between them.</source>
        <translation>Nombre así las columnas, en este orden, separadas por comas.</translation>
    </message>
    <message>
        <source>Check that tracks and clouds are both in mm of the left camera.</source>
        <translation>Compruebe que las trayectorias y las nubes estén ambas en mm de la cámara izquierda.</translation>
    </message>
    <message>
        <source>In line {0} no number stands in the column &quot;{1}&quot;.</source>
        <translation>En la línea {0} no hay ningún número en la columna «{1}».</translation>
    </message>
    <message>
        <source>A line needs a strain (0.05 for 5 %) and a stress in kPa, numbers with a dot: look for a missing value, a unit, or a decimal comma.</source>
        <translation>Cada línea necesita una deformación (0.05 para el 5 %) y una tensión en kPa, números con punto: busque un valor que falta, una unidad o una coma decimal.</translation>
    </message>
    <message>
        <source>Tools with friction are not there for a body with a grain.</source>
        <translation>No hay instrumentos con fricción para un cuerpo con dirección de fibras.</translation>
    </message>
    <message>
        <source>Leave out the grain or the friction.</source>
        <translation>Quite la dirección de las fibras o la fricción.</translation>
    </message>
    <message>
        <source>The mean of the elastography&apos;s magnitude images serves as the anatomy.</source>
        <translation>La media de las imágenes de magnitud de la elastografía sirve de anatomía.</translation>
    </message>
    <message>
        <source>{0} was not wholly inside the liver; it was meshed as part of it.</source>
        <translation>{0} no estaba del todo dentro del hígado; se malló como parte de él.</translation>
    </message>
    <message>
        <source>{0} holds no voxels.</source>
        <translation>{0} no contiene ningún vóxel.</translation>
    </message>
    <message>
        <source>The body falls in {0} parts; the largest is kept, and the rest is left out: {1}.</source>
        <translation>El cuerpo se divide en {0} partes; se conserva la mayor y se descarta el resto: {1}.</translation>
    </message>
    <message>
        <source>Holes without a label inside the body, {0} ml together, are filled.</source>
        <translation>Los huecos sin etiqueta dentro del cuerpo, {0} ml en total, se rellenan.</translation>
    </message>
    <message>
        <source>{0} speck of fewer than {1} voxels ({2} voxels together) became part of what it touches.</source>
        <translation>{0} mota de menos de {1} vóxeles ({2} vóxeles en total) pasó a formar parte de lo que toca.</translation>
    </message>
    <message>
        <source>{0} specks of fewer than {1} voxels ({2} voxels together) became part of what they touch.</source>
        <translation>{0} motas de menos de {1} vóxeles ({2} vóxeles en total) pasaron a formar parte de lo que tocan.</translation>
    </message>
    <message>
        <source>The mesh has {0} cells instead of {1}; its shape and inner structures ask for them.</source>
        <translation>La malla tiene {0} celdas en vez de {1}; su forma y sus estructuras internas las requieren.</translation>
    </message>
    <message>
        <source>{0}: {1} piece ({2} ml) too thin for {3} cells got no cells of its own; about {4} cells would show it.</source>
        <translation>{0}: {1} trozo ({2} ml), demasiado fino para {3} celdas, no tiene celdas propias; con unas {4} celdas se vería.</translation>
    </message>
    <message>
        <source>{0}: {1} pieces ({2} ml) too thin for {3} cells got no cells of their own; about {4} cells would show them.</source>
        <translation>{0}: {1} trozos ({2} ml), demasiado finos para {3} celdas, no tienen celdas propias; con unas {4} celdas se verían.</translation>
    </message>
    <message>
        <source>Another way of touching</source>
        <translation>Otra manera de tocar</translation>
    </message>
    <message>
        <source>Place another tool</source>
        <translation>Colocar otra herramienta</translation>
    </message>
    <message>
        <source>The walls of cuts can be kept apart in equilibrium by finite elements, without a grain and not straight from data.</source>
        <translation>Las paredes de las secciones pueden mantenerse separadas en equilibrio con elementos finitos, sin dirección de fibras y no directamente a partir de datos.</translation>
    </message>
    <message>
        <source>The displacement has {0} points, the liver {1}; or one of them is not a number.</source>
        <translation>El desplazamiento tiene {0} puntos, el hígado {1}; o uno de ellos no es un número.</translation>
    </message>
    <message>
        <source>Simulate it again with the model as it is now.</source>
        <translation>Simúlelo de nuevo con el modelo tal como es ahora.</translation>
    </message>
    <message>
        <source>Pull or push with less force.</source>
        <translation>Tire o empuje con menos fuerza.</translation>
    </message>
    <message>
        <source>The result {0} is not of this model: its points at rest are others.</source>
        <translation>El resultado {0} no es de este modelo: sus puntos en reposo son otros.</translation>
    </message>
    <message>
        <source>one of its elements does not end</source>
        <translation>uno de sus elementos no termina</translation>
    </message>
    <message>
        <source>a compressed array has no blocks</source>
        <translation>una matriz comprimida no tiene bloques</translation>
    </message>
    <message>
        <source>the blocks of a compressed array have no size</source>
        <translation>los bloques de una matriz comprimida no tienen tamaño</translation>
    </message>
    <message>
        <source>a compressed array has more bytes than the file can hold</source>
        <translation>una matriz comprimida tiene más bytes de los que caben en el archivo</translation>
    </message>
    <message>
        <source>an array begins behind its end</source>
        <translation>una matriz empieza después de su final</translation>
    </message>
    <message>
        <source>Mesh the surface anew, for example with MeshLab.</source>
        <translation>Vuelva a mallar la superficie, por ejemplo con MeshLab.</translation>
    </message>
    <message>
        <source>No triangle of the surface has an area.</source>
        <translation>Ningún triángulo de la superficie tiene área.</translation>
    </message>
    <message>
        <source>Make the surface anew; a cloud of points is not one.</source>
        <translation>Genere de nuevo la superficie; una nube de puntos no lo es.</translation>
    </message>
    <message>
        <source>The surface is in {0} pieces, between which there is no way along it; the largest has {1} % of its area.</source>
        <translation>La superficie está en {0} piezas, entre las que no hay camino sobre ella; la mayor tiene el {1} % de su área.</translation>
    </message>
    <message>
        <source>Keep its largest piece, or join the pieces.</source>
        <translation>Conserve la pieza mayor o una las piezas.</translation>
    </message>
    <message>
        <source>Points at the place of another, joined with it: {0}.</source>
        <translation>Puntos en el lugar de otro, unidos a él: {0}.</translation>
    </message>
    <message>
        <source>Doubled or empty triangles left out: {0}.</source>
        <translation>Triángulos dobles o vacíos omitidos: {0}.</translation>
    </message>
    <message>
        <source>Triangles turned to fit their neighbours: {0}.</source>
        <translation>Triángulos girados para concordar con sus vecinos: {0}.</translation>
    </message>
    <message>
        <source>Points parted where the surface only touches itself: {0}.</source>
        <translation>Puntos separados donde la superficie solo se toca: {0}.</translation>
    </message>
    <message>
        <source>Pieces left out, together below 1 % of the area: {0}.</source>
        <translation>Piezas omitidas, juntas menos del 1 % del área: {0}.</translation>
    </message>
    <message>
        <source>the patient&apos;s left</source>
        <translation>la izquierda del paciente</translation>
    </message>
    <message>
        <source>the patient&apos;s right</source>
        <translation>la derecha del paciente</translation>
    </message>
    <message>
        <source>the back</source>
        <translation>la espalda</translation>
    </message>
    <message>
        <source>the front</source>
        <translation>el frente</translation>
    </message>
    <message>
        <source>the head</source>
        <translation>la cabeza</translation>
    </message>
    <message>
        <source>the feet</source>
        <translation>los pies</translation>
    </message>
    <message>
        <source>The image cuts the body off towards {0}; it is closed there by a flat cap.</source>
        <translation>La imagen corta el cuerpo hacia {0}; allí se cierra con una tapa plana.</translation>
    </message>
    <message>
        <source>Most rows of {0} are far shorter than its first.</source>
        <translation>La mayoría de las filas de {0} son mucho más cortas que la primera.</translation>
    </message>
    <message>
        <source>{0} is left out: its pixels cannot be written without what else is stored with them.</source>
        <translation>{0} se omite: sus píxeles no pueden escribirse sin lo que está guardado junto a ellos.</translation>
    </message>
    <message>
        <source>{0} does not say whether its pixels are signed: PixelRepresentation is {1}.</source>
        <translation>{0} no dice si sus píxeles tienen signo: PixelRepresentation es {1}.</translation>
    </message>
    <message>
        <source>its voxels lie in several files</source>
        <translation>sus vóxeles están en varios archivos</translation>
    </message>
    <message>
        <source>its voxels are encoded in a way that is not read</source>
        <translation>sus vóxeles están codificados de una manera que no se lee</translation>
    </message>
    <message>
        <source>{0} has {1} million voxels; at most {2} million are read.</source>
        <translation>{0} tiene {1} millones de vóxeles; se leen como máximo {2} millones.</translation>
    </message>
    <message>
        <source>Cut out the part that is needed, or resample it to larger voxels.</source>
        <translation>Recorte la parte necesaria o remuestree con vóxeles más grandes.</translation>
    </message>
    <message>
        <source>The compressed voxels of {0} are damaged or cut short.</source>
        <translation>Los vóxeles comprimidos de {0} están dañados o cortados.</translation>
    </message>
    <message>
        <source>{0} holds more voxels than its header declares: its sizes are not those that it was written with.</source>
        <translation>{0} contiene más vóxeles de los que declara su cabecera: sus tamaños no son aquellos con los que se escribió.</translation>
    </message>
    <message>
        <source>There is no room in the liver for {0} of {1} mm: make it smaller, or let it lie elsewhere.</source>
        <translation>No hay sitio en el hígado para {0} de {1} mm: redúzcala o colóquela en otro lugar.</translation>
    </message>
    <message>
        <source>A liver of {0} ml cannot be made: ask for 800 to 2800 ml.</source>
        <translation>No se puede generar un hígado de {0} ml: pida de 800 a 2800 ml.</translation>
    </message>
    <message>
        <source>A fat fraction of {0} with fibrosis of stage {1} cannot be made: the first is 0 to 0.5, the second 0 to 4.</source>
        <translation>No se puede generar una fracción de grasa de {0} con fibrosis de estadio {1}: la primera va de 0 a 0.5, el segundo de 0 a 4.</translation>
    </message>
    <message>
        <source>shaping the liver</source>
        <translation>dando forma al hígado</translation>
    </message>
    <message>
        <source>growing the vessels</source>
        <translation>creciendo los vasos</translation>
    </message>
    <message>
        <source>The lesion {0} is not understood: give its diameter in mm, as 30, and if you like its segment, 30@7, or its place, 30@x,y,z.</source>
        <translation>No se entiende la lesión {0}: indique su diámetro en mm, como 30, y si quiere su segmento, 30@7, o su lugar, 30@x,y,z.</translation>
    </message>
    <message>
        <source>others are writing it</source>
        <translation>otros lo están escribiendo</translation>
    </message>
    <message>
        <source>{0} is a link to another place, where nothing is written.</source>
        <translation>{0} es un enlace a otro lugar, donde no se escribe nada.</translation>
    </message>
    <message>
        <source>Put the folder itself there.</source>
        <translation>Ponga allí la carpeta misma.</translation>
    </message>
    <message>
        <source>{0} names a file outside its place in the case folder: {1}.</source>
        <translation>{0} nombra un archivo fuera de su lugar en la carpeta del caso: {1}.</translation>
    </message>
    <message>
        <source>{0} is being made by another program.</source>
        <translation>Otro programa está creando {0}.</translation>
    </message>
    <message>
        <source>Wait until it has finished, or choose another name.</source>
        <translation>Espere a que termine o elija otro nombre.</translation>
    </message>
    <message>
        <source>{0} was replaced by another program and does not fit the liver of this case.</source>
        <translation>{0} fue sustituido por otro programa y no corresponde al hígado de este caso.</translation>
    </message>
    <message>
        <source>Put the file back, or make it anew: glisson-cli segment, mesh, stiffness.</source>
        <translation>Devuelva el archivo o hágalo de nuevo: glisson-cli segment, mesh, stiffness.</translation>
    </message>
    <message>
        <source>Another program has changed {0} since it was saved.</source>
        <translation>Otro programa ha cambiado {0} desde que se guardó.</translation>
    </message>
    <message>
        <source>What {0} was made from has changed since: make it anew.</source>
        <translation>Aquello de lo que se hizo {0} ha cambiado desde entonces: hágalo de nuevo.</translation>
    </message>
    <message>
        <source>Point {0} of the surface lies farther off than a thousand kilometres.</source>
        <translation>El punto {0} de la superficie está a más de mil kilómetros.</translation>
    </message>
    <message>
        <source>No triangle of the surface has an area: they are lines or points.</source>
        <translation>Ningún triángulo de la superficie tiene área: son líneas o puntos.</translation>
    </message>
    <message>
        <source>Point {0} of the mesh lies farther off than a thousand kilometres.</source>
        <translation>El punto {0} de la malla está a más de mil kilómetros.</translation>
    </message>
    <message>
        <source>The command is done, but its answer cannot be written: {0}.</source>
        <translation>La orden está hecha, pero no se puede escribir su respuesta: {0}.</translation>
    </message>
    <message>
        <source>Check where standard output goes, and the space there.</source>
        <translation>Compruebe adónde va la salida estándar y el espacio que hay allí.</translation>
    </message>
    <message>
        <source>They are of another patient.</source>
        <translation>Son de otro paciente.</translation>
    </message>
    <message>
        <source>They are of another examination.</source>
        <translation>Son de otro examen.</translation>
    </message>
    <message>
        <source>They have another frame of reference: the patient may have moved between them.</source>
        <translation>Tienen otro sistema de referencia: el paciente puede haberse movido entre ellas.</translation>
    </message>
    <message>
        <source>They lie elsewhere: only {0} % of their place is that of the case&apos;s anatomy.</source>
        <translation>Están en otro lugar: solo el {0} % de su espacio es el de la anatomía del caso.</translation>
    </message>
    <message>
        <source>This was measured on &quot;{0}&quot;, and nothing shows that it is tissue of {1}.</source>
        <translation>Esto se midió en «{0}», y nada muestra que sea tejido de {1}.</translation>
    </message>
    <message>
        <source>Where it is, name the case in the experiment&apos;s title, or say so with --of-this-patient.</source>
        <translation>Si lo es, nombre el caso en el título del experimento, o dígalo con --of-this-patient.</translation>
    </message>
    <message>
        <source>The effect {0} would change nothing in the rehearsal: {1}</source>
        <translation>El efecto {0} no cambiaría nada en el ensayo: {1}</translation>
    </message>
    <message>
        <source>Accept the others alone (--effect KIND).</source>
        <translation>Acepte solo los otros (--effect CLASE).</translation>
    </message>
    <message>
        <source>Make a case of their own, or take them all the same with --replace.</source>
        <translation>Haga de ellas un caso aparte, o tómelas de todos modos con --replace.</translation>
    </message>
    <message>
        <source>These images may not belong to {0}.{1}</source>
        <translation>Puede que estas imágenes no pertenezcan a {0}.{1}</translation>
    </message>
    <message>
        <source>{0} has an anatomy already, which these images would replace.</source>
        <translation>{0} ya tiene una anatomía, que estas imágenes reemplazarían.</translation>
    </message>
    <message>
        <source>Drawn on another grid ({0} x {1} x {2}) and carried to the anatomy&apos;s, each voxel from the nearest one.</source>
        <translation>Dibujado en otra rejilla ({0} x {1} x {2}) y llevado a la de la anatomía, cada vóxel desde el más cercano.</translation>
    </message>
    <message>
        <source>Left out of the label map: {0}.</source>
        <translation>Omitido del mapa de etiquetas: {0}.</translation>
    </message>
    <message>
        <source>Nothing says what the values of {0} are: {1}.</source>
        <translation>Nada dice qué son los valores de {0}: {1}.</translation>
    </message>
    <message>
        <source>Name them, as in --label-value 1=liver --label-value 2=tumour-1.</source>
        <translation>Nómbrelos, como en --label-value 1=liver --label-value 2=tumour-1.</translation>
    </message>
    <message>
        <source>Two files bring the structure {0}: {1} is the second.</source>
        <translation>Dos archivos traen la estructura {0}: {1} es el segundo.</translation>
    </message>
    <message>
        <source>Leave one of them out (--labels UID takes that label map alone).</source>
        <translation>Omita uno de ellos (--labels UID toma solo ese mapa de etiquetas).</translation>
    </message>
    <message>
        <source>No voxel of {0} lies inside the anatomy.</source>
        <translation>Ningún vóxel de {0} está dentro de la anatomía.</translation>
    </message>
    <message>
        <source>Named after the file.</source>
        <translation>Nombrado por el archivo.</translation>
    </message>
    <message>
        <source>Named by you.</source>
        <translation>Nombrado por usted.</translation>
    </message>
    <message>
        <source>Named by 3D Slicer&apos;s segments.</source>
        <translation>Nombrado por los segmentos de 3D Slicer.</translation>
    </message>
    <message>
        <source>Named by the table in the file.</source>
        <translation>Nombrado por la tabla del archivo.</translation>
    </message>
    <message>
        <source>Named by the label description beside the file.</source>
        <translation>Nombrado por la descripción de etiquetas junto al archivo.</translation>
    </message>
    <message>
        <source>Named by TotalSegmentator&apos;s class numbers: see whether they are right.</source>
        <translation>Nombrado por los números de clase de TotalSegmentator: compruebe que son correctos.</translation>
    </message>
    <message>
        <source>The stiffness is assumed, {0} kPa for all cells, and not measured: it is not compared with the atlas.</source>
        <translation>La rigidez es supuesta, {0} kPa para todas las celdas, y no medida: no se compara con el atlas.</translation>
    </message>
    <message>
        <source>The stiffness is assumed, the atlas&apos;s {0} kPa for all cells, and not measured: it is not compared with the atlas.</source>
        <translation>La rigidez es supuesta, los {0} kPa del atlas para todas las celdas, y no medida: no se compara con el atlas.</translation>
    </message>
    <message>
        <source>The result in {0} is not to be used: {1}.</source>
        <translation>El resultado en {0} no es utilizable: {1}.</translation>
    </message>
    <message>
        <source>Simulate it again with less force, or on other supports.</source>
        <translation>Simúlelo de nuevo con menos fuerza o con otros apoyos.</translation>
    </message>
    <message>
        <source>Within the model: strains reach {0} %.</source>
        <translation>Dentro del modelo: las deformaciones llegan al {0} %.</translation>
    </message>
    <message>
        <source>Outside of the model: strains reach {0} %, and beyond {1} % it is an extrapolation.</source>
        <translation>Fuera del modelo: las deformaciones llegan al {0} %, y por encima del {1} % es una extrapolación.</translation>
    </message>
    <message>
        <source>Not to be used: cells turned inside out: {0}.</source>
        <translation>No utilizable: celdas invertidas: {0}.</translation>
    </message>
    <message>
        <source>Not to be used: the computation did not converge.</source>
        <translation>No utilizable: el cálculo no ha convergido.</translation>
    </message>
    <message>
        <source>cells turned inside out: {0}</source>
        <translation>celdas invertidas: {0}</translation>
    </message>
    <message>
        <source>Plan a resection first, and save it.</source>
        <translation>Planifique primero una resección y guárdela.</translation>
    </message>
    <message>
        <source>The result {0} is not to be used: {1}.</source>
        <translation>El resultado {0} no es utilizable: {1}.</translation>
    </message>
    <message>
        <source>Simulate it again with less force.</source>
        <translation>Simúlelo de nuevo con menos fuerza.</translation>
    </message>
    <message>
        <source>A result that did not converge cannot be compared: {0}</source>
        <translation>Un resultado que no ha convergido no se puede comparar: {0}</translation>
    </message>
    <message>
        <source>The retraction&apos;s answer is not to be used: {0}.</source>
        <translation>La respuesta de la retracción no es utilizable: {0}.</translation>
    </message>
    <message>
        <source>Use less force.</source>
        <translation>Use menos fuerza.</translation>
    </message>
    <message>
        <source>Less than 5 % of the organ is seen: too little to say where the rest is.</source>
        <translation>Se ve menos del 5 % del órgano: demasiado poco para decir dónde está el resto.</translation>
    </message>
    <message>
        <source>What is seen does not fit this organ: more than half of the points lie far from it.</source>
        <translation>Lo que se ve no corresponde a este órgano: más de la mitad de los puntos está lejos de él.</translation>
    </message>
    <message>
        <source>Preparing the organ</source>
        <translation>Preparando el órgano</translation>
    </message>
    <message>
        <source>Fewer than 20 points of the surface were seen.</source>
        <translation>Se vieron menos de 20 puntos de la superficie.</translation>
    </message>
    <message>
        <source>What was seen is twenty times smaller than the organ: lengths are in mm, are these in metres?</source>
        <translation>Lo visto es veinte veces más pequeño que el órgano: las longitudes son en mm, ¿están estas en metros?</translation>
    </message>
    <message>
        <source>What was seen is five times larger than the organ: lengths are in mm.</source>
        <translation>Lo visto es cinco veces mayor que el órgano: las longitudes son en mm.</translation>
    </message>
    <message>
        <source>Placing the organ</source>
        <translation>Situando el órgano</translation>
    </message>
    <message>
        <source>In {0}: {1}.</source>
        <translation>En {0}: {1}.</translation>
    </message>
    <message>
        <source>The format &quot;glisson-guidance/1&quot; is described in the documentation.</source>
        <translation>El formato &quot;glisson-guidance/1&quot; se describe en la documentación.</translation>
    </message>
    <message>
        <source>The first line must be id,x_mm,y_mm,z_mm.</source>
        <translation>La primera línea debe ser id,x_mm,y_mm,z_mm.</translation>
    </message>
    <message>
        <source>Line {0} must hold an id and three numbers.</source>
        <translation>La línea {0} debe contener un identificador y tres números.</translation>
    </message>
    <message>
        <source>Give a pose_guess, or mark ridges or the falciform ligament.</source>
        <translation>Indique una pose_guess, o marque bordes o el ligamento falciforme.</translation>
    </message>
    <message>
        <source>Under no pose does what frame {0} saw lie near the organ.</source>
        <translation>En ninguna posición lo que vio la imagen {0} queda cerca del órgano.</translation>
    </message>
    <message>
        <source>Check that the features have the same names on both sides, that lengths are in mm, and that the frame is of this patient.</source>
        <translation>Compruebe que las referencias tengan los mismos nombres en ambos lados, que las longitudes sean en mm y que la imagen sea de este paciente.</translation>
    </message>
    <message>
        <source>Reading the guidance case</source>
        <translation>Leyendo el caso de guiado</translation>
    </message>
    <message>
        <source>Another window has {0} open: here it can be looked at, and nothing is changed.</source>
        <translation>Otra ventana tiene abierto {0}: aquí se puede mirar, y nada se cambia.</translation>
    </message>
    <message>
        <source>Close it there and open it here again.</source>
        <translation>Ciérrelo allí y vuelva a abrirlo aquí.</translation>
    </message>
    <message>
        <source>The folder of {0} takes no files: the case can be looked at, and nothing is kept.</source>
        <translation>La carpeta de {0} no admite archivos: el caso se puede mirar, y nada se guarda.</translation>
    </message>
    <message>
        <source>Copy it to where you may write, and open the copy.</source>
        <translation>Cópielo a donde pueda escribir y abra la copia.</translation>
    </message>
    <message>
        <source>The folder {0} is gone: nothing more of this case can be kept.</source>
        <translation>La carpeta {0} ha desaparecido: nada más de este caso se puede guardar.</translation>
    </message>
    <message>
        <source>Bring it back to its place, or open the case where it is now.</source>
        <translation>Devuélvala a su sitio, o abra el caso donde esté ahora.</translation>
    </message>
    <message>
        <source>The landmarks in {0} cannot be read: {1}.</source>
        <translation>No se pueden leer las referencias de {0}: {1}.</translation>
    </message>
    <message>
        <source>Undo the change in the window, or delete the file&apos;s entry and set them again.</source>
        <translation>Deshaga el cambio en la ventana, o borre la entrada del archivo y colóquelas de nuevo.</translation>
    </message>
    <message>
        <source>No voxel there has a grey value from {0} to {1}.</source>
        <translation>Allí ningún vóxel tiene un valor de gris de {0} a {1}.</translation>
    </message>
    <message>
        <source>This case has no structure &quot;{0}&quot;.</source>
        <translation>Este caso no tiene ninguna estructura &quot;{0}&quot;.</translation>
    </message>
    <message>
        <source>Names are those of the folder labels in the case: liver, portal-vein, ...</source>
        <translation>Los nombres son los de la carpeta labels del caso: liver, portal-vein, ...</translation>
    </message>
    <message>
        <source>On {0} % of its border the outline lies on tissue that hardly differs from it, most of all at {1} (LPS, mm): look there before you trust it, and add a point where a part is missing.</source>
        <translation>En el {0} % de su borde el contorno limita con un tejido que apenas se distingue, sobre todo en {1} (LPS, mm): mire allí antes de fiarse y añada un punto donde falte una parte.</translation>
    </message>
    <message>
        <source>A seed lies where there is no image value, or outside of the structure to stay in.</source>
        <translation>Una semilla está donde la imagen no tiene valor, o fuera de la estructura en la que hay que quedarse.</translation>
    </message>
    <message>
        <source>Forget the points, and click inside of it.</source>
        <translation>Olvide los puntos y haga clic dentro.</translation>
    </message>
    <message>
        <source>Nothing around the seeds differs from them in brightness.</source>
        <translation>Nada alrededor de las semillas se distingue de ellas por el brillo.</translation>
    </message>
    <message>
        <source>Move the seeds, or draw with the brush.</source>
        <translation>Mueva las semillas o dibuje con el pincel.</translation>
    </message>
    <message>
        <source>What is as bright as the seeds and hangs together with them is more than {0} mm thick: no vessel.</source>
        <translation>Lo que es tan claro como las semillas y está unido a ellas tiene más de {0} mm de grosor: no es un vaso.</translation>
    </message>
    <message>
        <source>Move the seed into a vessel that stands out, or keep the growth inside of the liver.</source>
        <translation>Ponga la semilla en un vaso que destaque, o mantenga el crecimiento dentro del hígado.</translation>
    </message>
    <message>
        <source>The seeds ({0}) hardly stand out from the tissue around ({1}, scatter {2}): look at the outline.</source>
        <translation>Las semillas ({0}) apenas destacan del tejido de alrededor ({1}, dispersión {2}): mire el contorno.</translation>
    </message>
    <message>
        <source>The growth reaches the side of the image: it has probably leaked. Keep it inside of the liver, or cut it there.</source>
        <translation>El crecimiento llega al lado de la imagen: probablemente se ha escapado. Manténgalo dentro del hígado o córtelo allí.</translation>
    </message>
    <message>
        <source>Grey values for {0}</source>
        <translation>Valores de gris para {0}</translation>
    </message>
    <message>
        <source>{0} and another structure</source>
        <translation>{0} y otra estructura</translation>
    </message>
    <message>
        <source>This place is not in the liver: a landmark is followed as the liver moves.</source>
        <translation>Este lugar no está en el hígado: un punto de referencia se sigue cuando el hígado se mueve.</translation>
    </message>
    <message>
        <source>Click in the liver, in a slice or in 3D, and set it again.</source>
        <translation>Haga clic en el hígado, en un corte o en 3D, y colóquelo de nuevo.</translation>
    </message>
    <message>
        <source>Widen the range.</source>
        <translation>Amplíe el intervalo.</translation>
    </message>
    <message>
        <source>{0} does not hold the images that {1} was made from.</source>
        <translation>{0} no contiene las imágenes de las que se hizo {1}.</translation>
    </message>
    <message>
        <source>Name the folder that was imported.</source>
        <translation>Indique la carpeta que se importó.</translation>
    </message>
    <message>
        <source>SIMULATED, not measured</source>
        <translation>SIMULADO, no medido</translation>
    </message>
    <message>
        <source>The moduli in {0} were made of shear moduli by a Poisson&apos;s ratio of {1}, not {2}.</source>
        <translation>Los módulos de {0} se calcularon a partir de módulos de cizalla con un coeficiente de Poisson de {1}, no de {2}.</translation>
    </message>
    <message>
        <source>Say &quot;poisson_ratio&quot;: {1} in the specimen.</source>
        <translation>Indique &quot;poisson_ratio&quot;: {1} en la muestra (specimen).</translation>
    </message>
    <message>
        <source>Tetrahedra {0} and {1} lie on the same side of the face that they share: they overlap.</source>
        <translation>Los tetraedros {0} y {1} están del mismo lado de la cara que comparten: se solapan.</translation>
    </message>
    <message>
        <source>Mesh it anew.</source>
        <translation>Vuelva a mallarlo.</translation>
    </message>
    <message>
        <source>{0} holds {1} MB of voxels in {2} MB: nearly all of them have one value.</source>
        <translation>{0} contiene {1} MB de vóxeles en {2} MB: casi todos tienen el mismo valor.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of cell {0} is {1} kPa; matter has {2} to {3} kPa.</source>
        <translation>El módulo de Young de la celda {0} es de {1} kPa; la materia tiene de {2} a {3} kPa.</translation>
    </message>
    <message>
        <source>Check its unit: liver has 2 to 60 kPa.</source>
        <translation>Compruebe su unidad: el hígado tiene de 2 a 60 kPa.</translation>
    </message>
    <message>
        <source>The mesh&apos;s Poisson&apos;s ratio must lie above -1 and not above 0.5; it is {0}.</source>
        <translation>El coeficiente de Poisson de la malla debe ser mayor que -1 y no superar 0.5; es {0}.</translation>
    </message>
    <message>
        <source>SIMULATED: a generated liver, breathing and pressed by a tool as a formula says. The registration called &quot;given&quot; is the true one with a fault put into it on the left of the picture.</source>
        <translation>SIMULADO: un hígado generado, que respira y es presionado por un instrumento según una fórmula. El registro llamado «dado» es el verdadero con un fallo introducido a la izquierda de la imagen.</translation>
    </message>
    <message>
        <source>there is no picture</source>
        <translation>no hay ninguna imagen</translation>
    </message>
    <message>
        <source>Patient: name withheld</source>
        <translation>Paciente: nombre reservado</translation>
    </message>
    <message>
        <source>What was planned and rehearsed</source>
        <translation>Lo que se planificó y ensayó</translation>
    </message>
    <message>
        <source>Not a medical device.</source>
        <translation>No es un producto sanitario.</translation>
    </message>
    <message>
        <source>Glisson {0}. Not a medical device: not for diagnosis or treatment.</source>
        <translation>Glisson {0}. No es un producto sanitario: ni para diagnóstico ni para tratamiento.</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Origen</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Obtenido por</translation>
    </message>
    <message>
        <source>the case</source>
        <translation>el caso</translation>
    </message>
    <message>
        <source>files: {0}</source>
        <translation>archivos: {0}</translation>
    </message>
    <message>
        <source>The case holds no images.</source>
        <translation>El caso no contiene imágenes.</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Estructuras</translation>
    </message>
    <message>
        <source>Nothing is outlined yet.</source>
        <translation>Aún no se ha delimitado nada.</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Estructura</translation>
    </message>
    <message>
        <source>Outlined by</source>
        <translation>Delimitado por</translation>
    </message>
    <message>
        <source>{0} with {1} N over {2} mm radius</source>
        <translation>{0} con {1} N sobre {2} mm de radio</translation>
    </message>
    <message>
        <source>Rehearsed retraction</source>
        <translation>Retracción ensayada</translation>
    </message>
    <message>
        <source>No tool is on the liver: nothing is being rehearsed.</source>
        <translation>No hay ningún instrumento sobre el hígado: no se ensaya nada.</translation>
    </message>
    <message>
        <source>Tools: {0}.</source>
        <translation>Instrumentos: {0}.</translation>
    </message>
    <message>
        <source>The liver moves by up to {0} mm.</source>
        <translation>El hígado se mueve hasta {0} mm.</translation>
    </message>
    <message>
        <source>5 mm or more matters to a surgeon and is marked !.</source>
        <translation>A partir de 5 mm importa al cirujano y se marca con !.</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Punto de referencia</translation>
    </message>
    <message>
        <source>Moves (mm)</source>
        <translation>Movimiento (mm)</translation>
    </message>
    <message>
        <source>Atlas off (mm)</source>
        <translation>Error del atlas (mm)</translation>
    </message>
    <message>
        <source>What can be worn</source>
        <translation>Lo que se puede llevar puesto</translation>
    </message>
    <message>
        <source>For a liver of {0} cm3, {1} mm accuracy, {2} frames a second, {3} h at {4} deg C: {5}.</source>
        <translation>Para un hígado de {0} cm³, {1} mm de exactitud, {2} imágenes por segundo, {3} h a {4} °C: {5}.</translation>
    </message>
    <message>
        <source>the least obtrusive that holds is {0}</source>
        <translation>el menos molesto que basta es {0}</translation>
    </message>
    <message>
        <source>none of the known platforms holds</source>
        <translation>ninguna de las plataformas conocidas basta</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Plataforma</translation>
    </message>
    <message>
        <source>Frames/s</source>
        <translation>Imágenes/s</translation>
    </message>
    <message>
        <source>Battery (h)</source>
        <translation>Batería (h)</translation>
    </message>
    <message>
        <source>Surface (deg C)</source>
        <translation>Superficie (°C)</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Basta</translation>
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
        <source>current</source>
        <translation>al día</translation>
    </message>
    <message>
        <source>stale: made from something that has changed</source>
        <translation>obsoleto: cambió aquello de lo que procede</translation>
    </message>
    <message>
        <source>changed by another program</source>
        <translation>modificado por otro programa</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>Where it comes from</source>
        <translation>De dónde procede</translation>
    </message>
    <message>
        <source>Each file of the case, the beginning of its SHA-256, and what made it.</source>
        <translation>Cada archivo del caso, el comienzo de su SHA-256 y cómo se obtuvo.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>When (UTC)</source>
        <translation>Cuándo (UTC)</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>assumed: one value for all cells, {0} kPa</source>
        <translation>supuesta: un valor para todas las celdas, {0} kPa</translation>
    </message>
    <message>
        <source>assumed: the atlas&apos;s one value, {0} kPa</source>
        <translation>supuesta: el valor único del atlas, {0} kPa</translation>
    </message>
    <message>
        <source>the patient&apos;s own, from MR elastography</source>
        <translation>la del paciente, por elastografía RM</translation>
    </message>
    <message>
        <source>cut through: R1 !</source>
        <translation>cortado: R1 !</translation>
    </message>
    <message>
        <source>left in place !</source>
        <translation>queda dentro !</translation>
    </message>
    <message>
        <source>under 5 mm !</source>
        <translation>menos de 5 mm !</translation>
    </message>
    <message>
        <source>Smallest distance to the cut. Under 1 mm counts as R1, under 5 mm is narrow; both are marked !.</source>
        <translation>Menor distancia al corte. Menos de 1 mm cuenta como R1, menos de 5 mm es escaso; ambos se marcan con !.</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>Margin (mm)</source>
        <translation>Margen (mm)</translation>
    </message>
    <message>
        <source>Caution</source>
        <translation>Atención</translation>
    </message>
    <message>
        <source>Moved by the tools (mm)</source>
        <translation>Movido por los instrumentos (mm)</translation>
    </message>
    <message>
        <source>cut through</source>
        <translation>cortado</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>retirado</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>queda</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>There is no model yet.</source>
        <translation>Aún no hay modelo.</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Celdas</translation>
    </message>
    <message>
        <source>Smallest dihedral angle</source>
        <translation>Menor ángulo diedro</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidez</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Módulo de Young</translation>
    </message>
    <message>
        <source>{0} kPa on average, sd {1}</source>
        <translation>{0} kPa de media, desviación típica {1}</translation>
    </message>
    <message>
        <source>Cells without data of their own</source>
        <translation>Celdas sin datos propios</translation>
    </message>
    <message>
        <source>{0} % (filled from inside)</source>
        <translation>{0} % (completadas desde dentro)</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Sujeto por</translation>
    </message>
    <message>
        <source>the bare area near the vena cava, and springs under the diaphragm (assumed)</source>
        <translation>el área desnuda junto a la vena cava y muelles bajo el diafragma (supuesto)</translation>
    </message>
    <message>
        <source>Planned resection</source>
        <translation>Resección planificada</translation>
    </message>
    <message>
        <source>No resection was saved.</source>
        <translation>No se guardó ninguna resección.</translation>
    </message>
    <message>
        <source>The cut removes {0} ml and leaves {1} ml, {2} % of the liver.</source>
        <translation>El corte retira {0} ml y deja {1} ml, {2} % del hígado.</translation>
    </message>
    <message>
        <source>Planned on the liver as tools hold it, an answer within the model: strains reach {0} %.</source>
        <translation>Planificado sobre el hígado tal como lo sujetan los instrumentos, una respuesta dentro del modelo: las deformaciones alcanzan {0} %.</translation>
    </message>
    <message>
        <source>Planned on the liver as tools hold it, an answer outside of the model: strains reach {0} %.</source>
        <translation>Planificado sobre el hígado tal como lo sujetan los instrumentos, una respuesta fuera del modelo: las deformaciones alcanzan {0} %.</translation>
    </message>
    <message>
        <source>Vessels that the cut crosses.</source>
        <translation>Vasos que el corte atraviesa.</translation>
    </message>
    <message>
        <source>Vessel</source>
        <translation>Vaso</translation>
    </message>
    <message>
        <source>Diameter (mm)</source>
        <translation>Diámetro (mm)</translation>
    </message>
    <message>
        <source>Vena cava, by its width</source>
        <translation>Vena cava, por su anchura</translation>
    </message>
    <message>
        <source>The saved resection cannot be read: its file is damaged.</source>
        <translation>La resección guardada no se puede leer: su archivo está dañado.</translation>
    </message>
    <message>
        <source>Evidence accepted</source>
        <translation>Pruebas aceptadas</translation>
    </message>
    <message>
        <source>None: the model is as declared.</source>
        <translation>Ninguna: el modelo es como se declaró.</translation>
    </message>
    <message>
        <source>Changes the model: {0}</source>
        <translation>Cambia el modelo: {0}</translation>
    </message>
    <message>
        <source>Accepted, but left out: {0}</source>
        <translation>Aceptada, pero omitida: {0}</translation>
    </message>
    <message>
        <source>Cells of the liver</source>
        <translation>Celdas del hígado</translation>
    </message>
    <message>
        <source>Model: stiffness of each cell</source>
        <translation>Modelo: rigidez de cada celda</translation>
    </message>
    <message>
        <source>Images: {0}</source>
        <translation>Imágenes: {0}</translation>
    </message>
    <message>
        <source>Outline: {0}</source>
        <translation>Contorno: {0}</translation>
    </message>
    <message>
        <source>Smooth surface: {0}</source>
        <translation>Superficie lisa: {0}</translation>
    </message>
    <message>
        <source>imported</source>
        <translation>importado</translation>
    </message>
    <message>
        <source>outlined</source>
        <translation>delimitado</translation>
    </message>
    <message>
        <source>made into cells</source>
        <translation>dividido en celdas</translation>
    </message>
    <message>
        <source>stiffness given</source>
        <translation>rigidez asignada</translation>
    </message>
    <message>
        <source>waves inverted</source>
        <translation>ondas invertidas</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>aceptado</translation>
    </message>
    <message>
        <source>Left out of the label map: {0} and {1} more.</source>
        <translation>Omitidos del mapa de etiquetas: {0} y {1} más.</translation>
    </message>
    <message>
        <source>{0} lies outside of the liver and has no cells of its own.</source>
        <translation>{0} queda fuera del hígado y no tiene celdas propias.</translation>
    </message>
    <message>
        <source>No landmark was set.</source>
        <translation>No se fijó ningún punto de referencia.</translation>
    </message>
    <message>
        <source>{0} and the liver lie on different grids.</source>
        <translation>{0} y el hígado están en rejillas distintas.</translation>
    </message>
    <message>
        <source>Import one of them again: a case carries what it imports to one grid.</source>
        <translation>Importe de nuevo uno de los dos: un caso lleva lo que importa a una sola rejilla.</translation>
    </message>
    <message>
        <source>The case has no vessels to make trees of.</source>
        <translation>El caso no tiene vasos con los que hacer árboles.</translation>
    </message>
    <message>
        <source>Mark the structures portal-vein and hepatic-vein, or both as one structure, vessels.</source>
        <translation>Marque las estructuras portal-vein y hepatic-vein, o ambas como una sola estructura, vessels.</translation>
    </message>
    <message>
        <source>The case has no vessel trees.</source>
        <translation>El caso no tiene árboles vasculares.</translation>
    </message>
    <message>
        <source>Find them first (vessels), or take the liver&apos;s shape alone (--from prior).</source>
        <translation>Búsquelos primero (vessels), o tome solo la forma del hígado (--from prior).</translation>
    </message>
    <message>
        <source>What frame {0} saw fits the organ in more than one place: its shape alone does not say where.</source>
        <translation>Lo que se vio en la imagen {0} encaja en el órgano en más de un lugar: la forma sola no dice dónde.</translation>
    </message>
    <message>
        <source>measuring the depth of the vessels</source>
        <translation>midiendo la profundidad de los vasos</translation>
    </message>
    <message>
        <source>following the vessels</source>
        <translation>siguiendo los vasos</translation>
    </message>
    <message>
        <source>measuring the vessels</source>
        <translation>midiendo los vasos</translation>
    </message>
    <message>
        <source>The axes of the vessel mask are not at right angles: resample it.</source>
        <translation>Los ejes de la máscara de los vasos no forman ángulos rectos: vuelva a muestrearla.</translation>
    </message>
    <message>
        <source>The vessel mask holds no voxels: mark vessels first, or import another mask.</source>
        <translation>La máscara de los vasos no contiene vóxeles: marque primero vasos o importe otra máscara.</translation>
    </message>
    <message>
        <source>The vessel mask holds a piece of {0} mm width that is no vessel: mark vessels alone.</source>
        <translation>La máscara de los vasos contiene un trozo de {0} mm de ancho que no es un vaso: marque solo vasos.</translation>
    </message>
    <message>
        <source>looking at the liver</source>
        <translation>examinando el hígado</translation>
    </message>
    <message>
        <source>finding the segments</source>
        <translation>buscando los segmentos</translation>
    </message>
    <message>
        <source>Only {0} % of the vessels lie in the liver: check that both masks are of one scan.</source>
        <translation>Solo el {0} % de los vasos está en el hígado: compruebe que ambas máscaras son del mismo estudio.</translation>
    </message>
    <message>
        <source>The liver mask holds no voxels: mark the liver first.</source>
        <translation>La máscara del hígado no contiene vóxeles: marque primero el hígado.</translation>
    </message>
    <message>
        <source>The image ends within the liver, so that its segments cannot be told: take a scan that holds all of it.</source>
        <translation>La imagen termina dentro del hígado, por lo que no se pueden determinar sus segmentos: tome un estudio que lo contenga entero.</translation>
    </message>
    <message>
        <source>No branch of the {0} lies in the liver, so that no tissue can be told to be its: check that vessels and liver are of one scan.</source>
        <translation>Ninguna rama ({0}) está en el hígado, por lo que no se le puede atribuir tejido: compruebe que vasos e hígado son del mismo estudio.</translation>
    </message>
    <message>
        <source>The vessel trees cannot be read: {0} is missing or makes no sense.</source>
        <translation>No se pueden leer los árboles vasculares: {0} falta o no tiene sentido.</translation>
    </message>
    <message>
        <source>Find the vessels again.</source>
        <translation>Busque de nuevo los vasos.</translation>
    </message>
    <message>
        <source>--pose {0} is no rigid motion: 16 numbers with commas, row by row.</source>
        <translation>--pose {0} no es un movimiento rígido: 16 números con comas, fila por fila.</translation>
    </message>
    <message>
        <source>The pose takes a point of the scan (mm) to the camera&apos;s frame.</source>
        <translation>La pose lleva un punto del estudio (mm) al sistema de la cámara.</translation>
    </message>
    <message>
        <source>nothing was written into it</source>
        <translation>no se escribió nada en él</translation>
    </message>
    <message>
        <source>At large strain a session knows quadratic cells of a neo-Hookean or Veronda-Westmann material without a grain.</source>
        <translation>En gran deformación, una sesión solo conoce celdas cuadráticas de un material neohookeano o de Veronda-Westmann sin dirección de fibras.</translation>
    </message>
    <message>
        <source>The body has no rest under its standing loads.</source>
        <translation>El cuerpo no encuentra reposo bajo sus cargas permanentes.</translation>
    </message>
    <message>
        <source>A session does not know &quot;{0}&quot; of a scenario.</source>
        <translation>Una sesión no conoce «{0}» de un escenario.</translation>
    </message>
    <message>
        <source>Leave it out; tools are taken by the session&apos;s commands.</source>
        <translation>Omítalo; las herramientas se toman con las órdenes de la sesión.</translation>
    </message>
    <message>
        <source>The case has no plan {0}.</source>
        <translation>El caso no tiene ningún plan {0}.</translation>
    </message>
    <message>
        <source>A cut cannot advance through a body that was meshed with a cut.</source>
        <translation>No se puede avanzar un corte por un cuerpo mallado ya con un corte.</translation>
    </message>
    <message>
        <source>A cut cannot advance through a body with a capsule.</source>
        <translation>No se puede avanzar un corte por un cuerpo con cápsula.</translation>
    </message>
    <message>
        <source>Leave the capsule out, or cut before the rehearsal.</source>
        <translation>Omita la cápsula o corte antes del ensayo.</translation>
    </message>
    <message>
        <source>The cut&apos;s advance needs two different places to go between.</source>
        <translation>El avance del corte necesita dos lugares distintos entre los que ir.</translation>
    </message>
    <message>
        <source>The cut crosses an earlier one, whose walls would have to be divided too.</source>
        <translation>El corte cruza otro anterior, cuyas paredes también habría que dividir.</translation>
    </message>
    <message>
        <source>The cut opens nothing: all that lies along it is open already, held, or outside of the body.</source>
        <translation>El corte no abre nada: todo a lo largo de él ya está abierto, está fijo o queda fuera del cuerpo.</translation>
    </message>
    <message>
        <source>The body&apos;s answer to the cut was not found: the relative residual stayed at {0}.</source>
        <translation>No se halló la respuesta del cuerpo al corte: el residuo relativo se quedó en {0}.</translation>
    </message>
    <message>
        <source>Nothing would hold the part that this cut separates.</source>
        <translation>Nada sujetaría la parte que este corte separa.</translation>
    </message>
    <message>
        <source>Stop before the last bridge of tissue.</source>
        <translation>Deténgase antes del último puente de tejido.</translation>
    </message>
    <message>
        <source>{0} must be whole numbers from 1 to 8, Couinaud&apos;s segments.</source>
        <translation>{0} deben ser números enteros de 1 a 8, los segmentos de Couinaud.</translation>
    </message>
    <message>
        <source>{0} is not of the format glisson-plan/1.</source>
        <translation>{0} no tiene el formato glisson-plan/1.</translation>
    </message>
    <message>
        <source>{0} needs at least one cut in its list of cuts.</source>
        <translation>{0} necesita al menos una sección en su lista cuts.</translation>
    </message>
    <message>
        <source>A plan takes at most 255 tumours; there are {0}.</source>
        <translation>Un plan admite como máximo 255 tumores; hay {0}.</translation>
    </message>
    <message>
        <source>The liver&apos;s outline is empty.</source>
        <translation>El contorno del hígado está vacío.</translation>
    </message>
    <message>
        <source>looking what hangs on which vessel</source>
        <translation>buscando qué depende de cada vaso</translation>
    </message>
    <message>
        <source>looking at segments and stiffness</source>
        <translation>examinando segmentos y rigidez</translation>
    </message>
    <message>
        <source>looking around the tumours</source>
        <translation>examinando alrededor de los tumores</translation>
    </message>
    <message>
        <source>The plan holds no cut.</source>
        <translation>El plan no contiene ninguna sección.</translation>
    </message>
    <message>
        <source>The plan takes the whole liver: nothing would be left.</source>
        <translation>El plan se lleva todo el hígado: no quedaría nada.</translation>
    </message>
    <message>
        <source>The liver&apos;s segments are not known yet.</source>
        <translation>Los segmentos del hígado aún no se conocen.</translation>
    </message>
    <message>
        <source>Find them first (glisson-cli territories).</source>
        <translation>Hállelos primero (glisson-cli territories).</translation>
    </message>
    <message>
        <source>The plan names no segment to take: give numbers from 1 to 8.</source>
        <translation>El plan no nombra ningún segmento: dé números de 1 a 8.</translation>
    </message>
    <message>
        <source>There is no segment {0}: Couinaud&apos;s are 1 to 8.</source>
        <translation>No hay segmento {0}: los de Couinaud son del 1 al 8.</translation>
    </message>
    <message>
        <source>Segment {0} holds no tissue of this liver.</source>
        <translation>El segmento {0} no contiene tejido de este hígado.</translation>
    </message>
    <message>
        <source>There is no branch {0} in the vessel trees.</source>
        <translation>No hay ninguna rama {0} en los árboles vasculares.</translation>
    </message>
    <message>
        <source>glisson-cli vessels lists their names; portal/right/posterior stands for all that begin so.</source>
        <translation>glisson-cli vessels da sus nombres; portal/right/posterior vale por todos los que empiezan así.</translation>
    </message>
    <message>
        <source>No tissue of the liver belongs to the branch {0}.</source>
        <translation>Ningún tejido del hígado pertenece a la rama {0}.</translation>
    </message>
    <message>
        <source>Take a branch nearer to the stem.</source>
        <translation>Tome una rama más cercana al tronco.</translation>
    </message>
    <message>
        <source>There is no tumour {0} in the liver.</source>
        <translation>No hay ningún tumor {0} en el hígado.</translation>
    </message>
    <message>
        <source>Give the name of a structure of the case that lies in the liver.</source>
        <translation>Dé el nombre de una estructura del caso situada en el hígado.</translation>
    </message>
    <message>
        <source>The margin around {0} must be 0 to {1} mm.</source>
        <translation>El margen alrededor de {0} debe ser de 0 a {1} mm.</translation>
    </message>
    <message>
        <source>The planned cut passes the liver by.</source>
        <translation>El corte planificado no toca el hígado.</translation>
    </message>
    <message>
        <source>Plans compared</source>
        <translation>Planes comparados</translation>
    </message>
    <message>
        <source>{0} no longer holds: {1}</source>
        <translation>{0} ya no es válido: {1}</translation>
    </message>
    <message>
        <source>What {0} was made from has changed since it was kept.</source>
        <translation>Aquello de lo que se hizo {0} ha cambiado desde entonces.</translation>
    </message>
    <message>
        <source>Per cent are of the liver without its tumours. Thresholds are the surgeon&apos;s to set.</source>
        <translation>Los porcentajes son del hígado sin sus tumores. Los umbrales los fija el cirujano.</translation>
    </message>
    <message>
        <source>Removed (ml)</source>
        <translation>Extirpado (ml)</translation>
    </message>
    <message>
        <source>Left (ml)</source>
        <translation>Queda (ml)</translation>
    </message>
    <message>
        <source>Left (%)</source>
        <translation>Queda (%)</translation>
    </message>
    <message>
        <source>Left and alive: perfused and drained (ml)</source>
        <translation>Queda vivo: perfundido y drenado (ml)</translation>
    </message>
    <message>
        <source>Left and alive (%)</source>
        <translation>Queda vivo (%)</translation>
    </message>
    <message>
        <source>Left without inflow: ischaemic (ml)</source>
        <translation>Queda sin aporte: isquémico (ml)</translation>
    </message>
    <message>
        <source>Left without outflow: congested (ml)</source>
        <translation>Queda sin drenaje: congestivo (ml)</translation>
    </message>
    <message>
        <source>Smallest margin (mm)</source>
        <translation>Menor margen (mm)</translation>
    </message>
    <message>
        <source>Tumours cut through or left</source>
        <translation>Tumores seccionados o dejados</translation>
    </message>
    <message>
        <source>Stiffness of what is left (kPa)</source>
        <translation>Rigidez de lo que queda (kPa)</translation>
    </message>
    <message>
        <source>Measured share of it (%)</source>
        <translation>Parte medida (%)</translation>
    </message>
    <message>
        <source>What stays of each segment, in ml.</source>
        <translation>Lo que queda de cada segmento, en ml.</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segmento</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Rama</translation>
    </message>
    <message>
        <source>Make the demo anew.</source>
        <translation>Haga la demostración de nuevo.</translation>
    </message>
    <message>
        <source>{0} has no tumour to be found.</source>
        <translation>{0} no tiene ningún tumor que hallar.</translation>
    </message>
    <message>
        <source>The liver of {0} was found in no frame of its own video.</source>
        <translation>El hígado de {0} no se halló en ningún fotograma de su propio vídeo.</translation>
    </message>
    <message>
        <source>The case has no plan to compare.</source>
        <translation>El caso no tiene ningún plan que comparar.</translation>
    </message>
    <message>
        <source>Add some first: glisson-cli plan CASE --add PLAN.json.</source>
        <translation>Añada antes alguno: glisson-cli plan CASE --add PLAN.json.</translation>
    </message>
    <message>
        <source>Writing the video</source>
        <translation>Escribiendo el vídeo</translation>
    </message>
    <message>
        <source>Place the liver by hand</source>
        <translation>Colocar el hígado a mano</translation>
    </message>
    <message>
        <source>Reading the sequence</source>
        <translation>Leyendo la secuencia</translation>
    </message>
    <message>
        <source>Reading the clouds</source>
        <translation>Leyendo las nubes de puntos</translation>
    </message>
    <message>
        <source>The plan was set on the liver as it was held aside: set it at rest to cut along it here.</source>
        <translation>El plan se fijó con el hígado apartado: fíjelo en reposo para cortar aquí según él.</translation>
    </message>
    <message>
        <source>Keep the plan {0}</source>
        <translation>Conservar el plan {0}</translation>
    </message>
    <message>
        <source>Drop the plan {0}</source>
        <translation>Descartar el plan {0}</translation>
    </message>
    <message>
        <source>The outline fills {0} % of the body in its slices, a person&apos;s liver less than half: it is not the liver alone, or these are images of an animal or a phantom.</source>
        <translation>El contorno llena el {0} % del cuerpo en sus cortes, el hígado de una persona menos de la mitad: no es solo el hígado, o son imágenes de un animal o de un fantoma.</translation>
    </message>
    <message>
        <source>{0} ml is less than any person&apos;s liver holds: the outline is a part of it, or these are images of an animal or a phantom.</source>
        <translation>{0} ml es menos de lo que contiene el hígado de cualquier persona: el contorno es una parte de él, o son imágenes de un animal o de un fantoma.</translation>
    </message>
    <message>
        <source>{0} needs one of plane, sheet, segments, territory, around, ablation.</source>
        <translation>{0} necesita uno de plane, sheet, segments, territory, around, ablation.</translation>
    </message>
    <message>
        <source>An ablation needs a direction, and radii of more than 0 and at most {0} mm.</source>
        <translation>Una ablación necesita una dirección y radios de más de 0 y como máximo {0} mm.</translation>
    </message>
    <message>
        <source>The ablation lies beside the liver.</source>
        <translation>La ablación queda fuera del hígado.</translation>
    </message>
    <message>
        <source>Move it into the liver; positions are patient coordinates (LPS, mm).</source>
        <translation>Muévala dentro del hígado; las posiciones son coordenadas del paciente (LPS, mm).</translation>
    </message>
    <message>
        <source>{0}: the cut unrolled flat. Purple: tumour; red: less than 5 mm from one; amber: less than 10 mm. Rings: vessels that are cut.</source>
        <translation>{0}: el corte extendido en plano. Violeta: tumor; rojo: a menos de 5 mm de uno; ámbar: a menos de 10 mm. Anillos: vasos que se cortan.</translation>
    </message>
    <message>
        <source>Left, of the body&apos;s weight (%)</source>
        <translation>Queda, del peso corporal (%)</translation>
    </message>
    <message>
        <source>Left and alive, of the body&apos;s weight (%)</source>
        <translation>Queda y vive, del peso corporal (%)</translation>
    </message>
    <message>
        <source>No worse in margin, tissue and tumours, and better in one</source>
        <translation>No peor en margen, tejido y tumores, y mejor en uno</translation>
    </message>
    <message>
        <source>What a wider margin costs.</source>
        <translation>Lo que cuesta un margen más ancho.</translation>
    </message>
    <message>
        <source>smallest margin (mm)</source>
        <translation>margen mínimo (mm)</translation>
    </message>
    <message>
        <source>left and alive (ml)</source>
        <translation>queda y vive (ml)</translation>
    </message>
    <message>
        <source>--study and --plan serve a DICOM SEG alone (--format dicom-seg).</source>
        <translation>--study y --plan sirven solo para un DICOM SEG (--format dicom-seg).</translation>
    </message>
    <message>
        <source>Line {1} of {0} is not landmark,frame,x_mm,y_mm,z_mm of a landmark in the tracks, with &quot;model&quot; or a frame below {2}.</source>
        <translation>La línea {1} de {0} no es landmark,frame,x_mm,y_mm,z_mm de un punto de referencia seguido, con &quot;model&quot; o un fotograma menor que {2}.</translation>
    </message>
    <message>
        <source>Make the sequence anew, or leave &quot;benchmark&quot; out of it.</source>
        <translation>Haga la secuencia de nuevo, o quite &quot;benchmark&quot; de ella.</translation>
    </message>
    <message>
        <source>each point was aligned without a fifth of the landmarks, the one nearest to it among them</source>
        <translation>cada punto se alineó sin una quinta parte de los puntos de referencia, entre ellos el más cercano a él</translation>
    </message>
    <message>
        <source>benchmark is no file name</source>
        <translation>benchmark no es un nombre de archivo</translation>
    </message>
    <message>
        <source>judged by its own landmarks, without a benchmark kept with the sequence: a fault that never changes is hardly seen</source>
        <translation>juzgado por sus propios puntos de referencia, sin una referencia guardada con la secuencia: un fallo que nunca cambia apenas se ve</translation>
    </message>
    <message>
        <source>&quot;frames&quot; must be a list with at least one frame.</source>
        <translation>&quot;frames&quot; debe ser una lista con al menos un fotograma.</translation>
    </message>
    <message>
        <source>{0} must be a rigid motion: 16 numbers, row by row, scan to camera.</source>
        <translation>{0} debe ser un movimiento rígido: 16 números, fila por fila, del escáner a la cámara.</translation>
    </message>
    <message>
        <source>Is it stretched or mirrored, or given column by column?</source>
        <translation>¿Está estirado o reflejado, o dado columna por columna?</translation>
    </message>
    <message>
        <source>{0} holds no points.</source>
        <translation>{0} no contiene puntos.</translation>
    </message>
    <message>
        <source>In {0} most points of {1} lie farther than {2} mm from the organ, as the pose has it.</source>
        <translation>En {0} la mayoría de los puntos de {1} están a más de {2} mm del órgano, según la pose.</translation>
    </message>
    <message>
        <source>Are they in metres, in another camera&apos;s frame, or is &quot;pose_guess&quot; that of another frame?</source>
        <translation>¿Están en metros, en el sistema de otra cámara, o es &quot;pose_guess&quot; la de otro fotograma?</translation>
    </message>
    <message>
        <source>In {0} more than one tool touches the organ.</source>
        <translation>En {0} más de un instrumento toca el órgano.</translation>
    </message>
    <message>
        <source>An experiment takes frames with one tool, or none.</source>
        <translation>Un experimento admite fotogramas con un instrumento o ninguno.</translation>
    </message>
    <message>
        <source>Two frames have the id &quot;{0}&quot;.</source>
        <translation>Dos fotogramas tienen el id &quot;{0}&quot;.</translation>
    </message>
    <message>
        <source>{0} names no frames.</source>
        <translation>{0} no nombra fotogramas.</translation>
    </message>
    <message>
        <source>{0} names the frame &quot;{1}&quot;, which is not there.</source>
        <translation>{0} nombra el fotograma &quot;{1}&quot;, que no existe.</translation>
    </message>
    <message>
        <source>The frame &quot;{0}&quot; belongs to two trials.</source>
        <translation>El fotograma &quot;{0}&quot; pertenece a dos ensayos.</translation>
    </message>
    <message>
        <source>Name each frame in one trial, or leave &quot;trials&quot; out: each frame is one then.</source>
        <translation>Nombre cada fotograma en un ensayo, o quite &quot;trials&quot;: entonces cada fotograma es uno.</translation>
    </message>
    <message>
        <source>Repeat the longest trial at half of its current or load.</source>
        <translation>Repetir el ensayo más largo con la mitad de su corriente o de su carga.</translation>
    </message>
    <message>
        <source>Repeat the longest trial at twice its current or load.</source>
        <translation>Repetir el ensayo más largo con el doble de su corriente o de su carga.</translation>
    </message>
    <message>
        <source>Repeat the longest trial in a room that is 15 °C warmer.</source>
        <translation>Repetir el ensayo más largo en una sala 15 °C más caliente.</translation>
    </message>
    <message>
        <source>A finer mesh would change the prediction; {0} % of what it would change shows in the measurements and is taken off what the better model predicts.</source>
        <translation>Una malla más fina cambiaría la predicción; el {0} % de ese cambio se ve en las mediciones y se descuenta de lo que predice el modelo mejor.</translation>
    </message>
    <message>
        <source>There is only one trial, so nothing could be predicted that was not fitted.</source>
        <translation>Solo hay un ensayo, así que no se pudo predecir nada que no se hubiera usado en el ajuste.</translation>
    </message>
    <message>
        <source>The residual is not quite random, but no larger than the noise can be trusted to be.</source>
        <translation>El residuo no es del todo aleatorio, pero no es mayor que lo fiable que es el ruido indicado.</translation>
    </message>
    <message>
        <source>The residual is not quite random, but no larger than what a finer mesh would change of the prediction.</source>
        <translation>El residuo no es del todo aleatorio, pero no es mayor que lo que una malla más fina cambiaría en la predicción.</translation>
    </message>
    <message>
        <source>{0} was left out: {1}</source>
        <translation>Se dejó fuera: {0}. Motivo: {1}</translation>
    </message>
    <message>
        <source>These data do not determine {0} of {1}.</source>
        <translation>Estos datos no determinan {0} (efecto: {1}).</translation>
    </message>
    <message>
        <source>{0} of {1} ended at the limit of its range ({2}).</source>
        <translation>{0} terminó en el límite de su intervalo ({2}; efecto: {1}).</translation>
    </message>
    <message>
        <source>{0} and {1} can hardly be told apart in size (correlation {2}).</source>
        <translation>Apenas se distinguen en su magnitud «{0}» y «{1}» (correlación {2}).</translation>
    </message>
    <message>
        <source>there is nowhere to begin</source>
        <translation>no hay ningún valor inicial</translation>
    </message>
    <message>
        <source>it promised to take much less of the error than others</source>
        <translation>prometía quitar mucho menos error que otros</translation>
    </message>
    <message>
        <source>Deform ten times as slowly.</source>
        <translation>Deformar diez veces más despacio.</translation>
    </message>
    <message>
        <source>Deform ten times as fast.</source>
        <translation>Deformar diez veces más deprisa.</translation>
    </message>
    <message>
        <source>Deform quickly and hold for the length of the longest trial.</source>
        <translation>Deformar deprisa y mantener durante lo que dura el ensayo más largo.</translation>
    </message>
    <message>
        <source>Load and unload twice.</source>
        <translation>Cargar y descargar dos veces.</translation>
    </message>
    <message>
        <source>Deform a fifth further.</source>
        <translation>Deformar una quinta parte más.</translation>
    </message>
    <message>
        <source>Deform to the other side (tension in place of compression, or the reverse).</source>
        <translation>Deformar hacia el otro lado (tracción en vez de compresión, o al revés).</translation>
    </message>
    <message>
        <source>Press at ({0}, {1}, {2}) mm with {3} N.</source>
        <translation>Presionar en ({0}, {1}, {2}) mm con {3} N.</translation>
    </message>
    <message>
        <source>Press as in trial {0}, but with {1} N.</source>
        <translation>Presionar como en el ensayo {0}, pero con {1} N.</translation>
    </message>
    <message>
        <source>Press as in trial {0} and hold the force for {1} s.</source>
        <translation>Presionar como en el ensayo {0} y mantener la fuerza durante {1} s.</translation>
    </message>
    <message>
        <source>Pull where trial {0} presses, with {1} N.</source>
        <translation>Tirar donde el ensayo {0} presiona, con {1} N.</translation>
    </message>
    <message>
        <source>Error by load, a line a trial: broken before, whole after</source>
        <translation>Error según la carga, una línea por ensayo: discontinua antes, continua después</translation>
    </message>
    <message>
        <source>Measured (dots), before (broken), after (line)</source>
        <translation>Medido (puntos), antes (discontinua), después (línea)</translation>
    </message>
    <message>
        <source>What was left before (broken) and after (line)</source>
        <translation>Lo que quedaba antes (discontinua) y después (línea)</translation>
    </message>
    <message>
        <source>{0} was made on the data &quot;{1}&quot;, {2} on &quot;{3}&quot;.</source>
        <translation>{0} se hizo con los datos «{1}», {2} con «{3}».</translation>
    </message>
    <message>
        <source>{0} and {1} have no case in common.</source>
        <translation>{0} y {1} no tienen ningún caso en común.</translation>
    </message>
    <message>
        <source>Name the same cases in the first column of both metrics.csv.</source>
        <translation>Nombre los mismos casos en la primera columna de ambos metrics.csv.</translation>
    </message>
    <message>
        <source>The tolerances name {0}, which neither {1} nor {2} has.</source>
        <translation>Las tolerancias nombran {0}, que ni {1} ni {2} tienen.</translation>
    </message>
    <message>
        <source>{0} must begin with a line case,METRIC,METRIC, ...</source>
        <translation>{0} debe empezar con una línea case,METRIC,METRIC, ...</translation>
    </message>
    <message>
        <source>Column {0} of {1} has no name of its own.</source>
        <translation>La columna {0} de {1} no tiene nombre propio.</translation>
    </message>
    <message>
        <source>Line {0} of {1} has more cells than the first.</source>
        <translation>La línea {0} de {1} tiene más celdas que la primera.</translation>
    </message>
    <message>
        <source>Line {0} of {1} names no case, or one that was there before.</source>
        <translation>La línea {0} de {1} no nombra ningún caso, o uno que ya estaba.</translation>
    </message>
    <message>
        <source>{0} holds no case.</source>
        <translation>{0} no contiene ningún caso.</translation>
    </message>
    <message>
        <source>{0} holds no metrics.csv.</source>
        <translation>{0} no contiene ningún metrics.csv.</translation>
    </message>
    <message>
        <source>Write one: a line case,METRIC,..., then a row for each case.</source>
        <translation>Escriba uno: una línea case,METRIC,..., luego una fila por caso.</translation>
    </message>
    <message>
        <source>{0} must lie between 0 and 1.</source>
        <translation>{0} debe estar entre 0 y 1.</translation>
    </message>
    <message>
        <source>The pictures have different sizes: {0} x {1} and {2} x {3}.</source>
        <translation>Las imágenes tienen tamaños distintos: {0} x {1} y {2} x {3}.</translation>
    </message>
    <message>
        <source>The mask of the pictures is black everywhere.</source>
        <translation>La máscara de las imágenes es negra en todas partes.</translation>
    </message>
    <message>
        <source>{0}: samples {1}, rows without a reading {2}.</source>
        <translation>{0}: muestras {1}, filas sin lectura {2}.</translation>
    </message>
    <message>
        <source>Runs in the trace: {0}, in the log: {1}.</source>
        <translation>Ejecuciones en la traza: {0}, en el registro: {1}.</translation>
    </message>
    <message>
        <source>Gaps in the recording: {0}; runs end there and nothing is made up for them.</source>
        <translation>Huecos en la grabación: {0}; las ejecuciones terminan ahí y no se inventa nada en su lugar.</translation>
    </message>
    <message>
        <source>Rows without a reading: {0}.</source>
        <translation>Filas sin lectura: {0}.</translation>
    </message>
    <message>
        <source>Runs that reach the end of a channel&apos;s range, so that their power is a lower bound: {0}. Record again with a larger range.</source>
        <translation>Ejecuciones que llegan al final del rango de un canal, de modo que su potencia es una cota inferior: {0}. Grabe de nuevo con un rango mayor.</translation>
    </message>
    <message>
        <source>{0} declares an impossible size: {1} x {2} pixels, frames: {3}.</source>
        <translation>{0} declara un tamaño imposible: {1} x {2} píxeles, fotogramas: {3}.</translation>
    </message>
    <message>
        <source>The step would turn cells inside out ({0}): a tool goes too far into the body.</source>
        <translation>El paso volvería celdas del revés ({0}): un instrumento entra demasiado en el cuerpo.</translation>
    </message>
    <message>
        <source>Cells taken away where the body touched itself in a point or an edge: {0}.</source>
        <translation>Celdas quitadas donde el cuerpo se tocaba a sí mismo en un punto o una arista: {0}.</translation>
    </message>
    <message>
        <source>A landmark was followed through {0} of {1} frames.</source>
        <translation>Un punto de referencia se siguió por {0} de {1} fotogramas.</translation>
    </message>
    <message>
        <source>Landmarks that lie far from the points of their frames: {0} of {1}.</source>
        <translation>Puntos de referencia lejos de los puntos de sus fotogramas: {0} de {1}.</translation>
    </message>
    <message>
        <source>Landmarks seen in three frames or more: {0}; four that do not lie on one line are needed.</source>
        <translation>Puntos de referencia vistos en tres fotogramas o más: {0}; se necesitan cuatro que no estén en una recta.</translation>
    </message>
    <message>
        <source>Too few frames to correlate: {0}; {1} are needed.</source>
        <translation>Demasiado pocos fotogramas para correlacionar: {0}; se necesitan {1}.</translation>
    </message>
    <message>
        <source>Landmark {0} was followed through {1} of {2} frames.</source>
        <translation>El punto de referencia {0} se siguió por {1} de {2} fotogramas.</translation>
    </message>
    <message>
        <source>Landmarks left out, which were seen in fewer than three frames: {0}</source>
        <translation>Puntos de referencia omitidos, vistos en menos de tres fotogramas: {0}</translation>
    </message>
    <message>
        <source>Landmarks left out, which lie far from the points of their frames: {0}</source>
        <translation>Puntos de referencia omitidos, lejos de los puntos de sus fotogramas: {0}</translation>
    </message>
    <message>
        <source>Triangles with all corners in fewer than three frames, whose correlation is 0: {0}</source>
        <translation>Triángulos con todos los vértices en menos de tres fotogramas, cuya correlación es 0: {0}</translation>
    </message>
    <message>
        <source>The {0} video ends before the other, at frame {1}.</source>
        <translation>El vídeo ({0}) termina antes que el otro, en el fotograma {1}.</translation>
    </message>
    <message>
        <source>Frames that show something: {0}; {1} are needed.</source>
        <translation>Fotogramas que muestran algo: {0}; se necesitan {1}.</translation>
    </message>
    <message>
        <source>Held like this, cells of the liver are turned inside out ({0}): nothing can be measured there.</source>
        <translation>Sujeto así, hay celdas del hígado vueltas del revés ({0}): ahí no se puede medir nada.</translation>
    </message>
    <message>
        <source>The structures have changed since the model was built. Landmarks that now lie outside of it are left out ({0}). Build the model anew.</source>
        <translation>Las estructuras han cambiado desde que se construyó el modelo. Los puntos de referencia que ahora quedan fuera se omiten ({0}). Construya el modelo de nuevo.</translation>
    </message>
    <message>
        <source>Frames that belong to no trial: {0}.</source>
        <translation>Fotogramas que no pertenecen a ningún ensayo: {0}.</translation>
    </message>
    <message>
        <source>The benchmark is not of this sequence, with its landmarks ({0}) and frames ({1}).</source>
        <translation>La referencia no es de esta secuencia, con sus puntos de referencia ({0}) y fotogramas ({1}).</translation>
    </message>
    <message>
        <source>landmarks that the benchmark has no place for were left out: {0}</source>
        <translation>puntos de referencia omitidos, para los que la referencia no tiene lugar: {0}</translation>
    </message>
    <message>
        <source>The history of {0} has no step {1}.</source>
        <translation>El historial de {0} no tiene el paso {1}.</translation>
    </message>
    <message>
        <source>See which there are: glisson-cli macro CASE.</source>
        <translation>Vea cuáles hay: glisson-cli macro CASE.</translation>
    </message>
    <message>
        <source>Step {1} of {0} changed a view and nothing in the case.</source>
        <translation>El paso {1} de {0} cambió una vista y nada en el caso.</translation>
    </message>
    <message>
        <source>Step {0} of {1} began with another {2} than {3} holds.</source>
        <translation>El paso {0} de {1} empezó con otro {2} del que tiene {3}.</translation>
    </message>
    <message>
        <source>Begin with the case as it was, and do all steps in their order.</source>
        <translation>Empiece con el caso tal como era y haga todos los pasos en su orden.</translation>
    </message>
    <message>
        <source>{0} no longer holds what a step of its history led to: {1}.</source>
        <translation>{0} ya no contiene lo que dejó un paso de su historial: {1}.</translation>
    </message>
    <message>
        <source>Another program has changed it; do this step in the window.</source>
        <translation>Otro programa lo ha cambiado; haga este paso en la ventana.</translation>
    </message>
    <message>
        <source>No case fits in {0} minutes.</source>
        <translation>Ningún caso cabe en {0} minutos.</translation>
    </message>
    <message>
        <source>Give more minutes, or a history with shorter cases.</source>
        <translation>Dé más minutos, o un historial con casos más cortos.</translation>
    </message>
    <message>
        <source>{0} must begin with a line case,seconds,METRIC, ... and hold a row a case a run.</source>
        <translation>{0} debe empezar con una línea case,seconds,MEDIDA, ... y tener una fila por caso y ejecución.</translation>
    </message>
    <message>
        <source>A column of {0} is there twice.</source>
        <translation>Una columna de {0} está dos veces.</translation>
    </message>
    <message>
        <source>Line {0} of {1} names no case, or has more cells than the first.</source>
        <translation>La línea {0} de {1} no nombra ningún caso, o tiene más celdas que la primera.</translation>
    </message>
    <message>
        <source>{0} names no case.</source>
        <translation>{0} no nombra ningún caso.</translation>
    </message>
    <message>
        <source>Make it with glisson-cli gate-cases.</source>
        <translation>Hágalo con glisson-cli gate-cases.</translation>
    </message>
    <message>
        <source>Stiffness from the waves</source>
        <translation>Rigidez a partir de las ondas</translation>
    </message>
    <message>
        <source>A frame is this program&apos;s own: {0}. Carried over from another machine in proportion to memory and arithmetic; nobody has run it on these platforms.</source>
        <translation>Un fotograma es el propio de este programa: {0}. Trasladado desde otra máquina en proporción a la memoria y al cálculo; nadie lo ha ejecutado en estas plataformas.</translation>
    </message>
    <message>
        <source>The task {0} moves no bytes and takes no operations.</source>
        <translation>La tarea {0} no mueve bytes ni requiere operaciones.</translation>
    </message>
    <message>
        <source>{0} has no list &quot;tasks&quot; of 1 to {1} tasks.</source>
        <translation>{0} no tiene una lista &quot;tasks&quot; de 1 a {1} tareas.</translation>
    </message>
    <message>
        <source>Two tasks have the id &quot;{0}&quot;.</source>
        <translation>Dos tareas tienen el identificador &quot;{0}&quot;.</translation>
    </message>
    <message>
        <source>A support that moves by a displacement is there for equilibrium by finite elements, without tools, motion, walls kept apart and data in place of a law.</source>
        <translation>Un apoyo que se mueve con un desplazamiento existe para el equilibrio por elementos finitos, sin instrumentos, movimiento, paredes separadas ni datos en lugar de una ley.</translation>
    </message>
    <message>
        <source>The displacement of support {0} is not a finite vector.</source>
        <translation>El desplazamiento del apoyo {0} no es un vector finito.</translation>
    </message>
    <message>
        <source>Support {0} moves points that another support holds or moves elsewhere.</source>
        <translation>El apoyo {0} mueve puntos que otro apoyo sujeta o mueve a otro lugar.</translation>
    </message>
    <message>
        <source>Let each point be held by one support, or in other directions.</source>
        <translation>Que cada punto esté sujeto por un solo apoyo, o en otras direcciones.</translation>
    </message>
    <message>
        <source>{0} moves by a displacement: it is neither a foundation nor a ligament.</source>
        <translation>{0} se mueve con un desplazamiento: no es ni una base elástica ni un ligamento.</translation>
    </message>
    <message>
        <source>{0} is moved in a direction that its &quot;directions&quot; leave free.</source>
        <translation>{0} se mueve en una dirección que sus &quot;directions&quot; dejan libre.</translation>
    </message>
    <message>
        <source>Resolutions must grow from 0.5 mm3 or more to 1700 mm3 or less, in 2 to 100 steps.</source>
        <translation>Las resoluciones deben crecer desde 0.5 mm3 o más hasta 1700 mm3 o menos, en 2 a 100 pasos.</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Muestreo</translation>
    </message>
    <message>
        <source>The matching study takes ascending numbers of points from 8 to 1024, starts of 0 or more, 1 to 1000 passes and livers, and two or more poses of each shape.</source>
        <translation>El estudio de emparejamiento admite números de puntos ascendentes de 8 a 1024, inicios desde 0, de 1 a 1000 pasadas e hígados, y dos o más posturas de cada forma.</translation>
    </message>
    <message>
        <source>There is no task &quot;{0}&quot;.</source>
        <translation>No hay ninguna tarea &quot;{0}&quot;.</translation>
    </message>
    <message>
        <source>Use product or one of: {1}.</source>
        <translation>Use product o una de: {1}.</translation>
    </message>
    <message>
        <source>The hidden targets, which nothing was fitted to, are farther off with what was found ({0} mm on average) than without it ({1} mm): do not take it for the cause.</source>
        <translation>Los objetivos ocultos, a los que nada se ajustó, quedan más lejos con lo hallado (en promedio {0} mm) que sin ello ({1} mm): no lo tome por la causa.</translation>
    </message>
    <message>
        <source>Copy the plan {0}</source>
        <translation>Copiar el plan {0}</translation>
    </message>
    <message>
        <source>Set an ablation zone</source>
        <translation>Poner una zona de ablación</translation>
    </message>
    <message>
        <source>Cut around a tumour</source>
        <translation>Sección alrededor de un tumor</translation>
    </message>
    <message>
        <source>Cut along a territory</source>
        <translation>Sección a lo largo de un territorio</translation>
    </message>
    <message>
        <source>Cut by segments</source>
        <translation>Sección por segmentos</translation>
    </message>
    <message>
        <source>Change an ablation zone</source>
        <translation>Cambiar una zona de ablación</translation>
    </message>
    <message>
        <source>Give back what was to go</source>
        <translation>Devolver lo que se iba a quitar</translation>
    </message>
    <message>
        <source>No branch is named that is to be embolised.</source>
        <translation>No se nombra ninguna rama que embolizar.</translation>
    </message>
    <message>
        <source>A growth of {0} % is not between 0 and {1} %.</source>
        <translation>Un crecimiento de {0} % no está entre 0 y {1} %.</translation>
    </message>
    <message>
        <source>{0} is no branch of the portal vein.</source>
        <translation>{0} no es una rama de la vena porta.</translation>
    </message>
    <message>
        <source>The tool {0} spreads its force over a patch, which a session knows at large strain alone.</source>
        <translation>El instrumento {0} reparte su fuerza sobre una zona, lo que una sesión conoce solo con deformaciones grandes.</translation>
    </message>
    <message>
        <source>Take the material neo-hookean, or jaws that pull.</source>
        <translation>Use el material neo-hookean, o mordazas que tiren.</translation>
    </message>
    <message>
        <source>Computed with large deformations (neo-Hookean).</source>
        <translation>Calculado con deformaciones grandes (neo-hookeano).</translation>
    </message>
    <message>
        <source>Computed with small deformations (linear).</source>
        <translation>Calculado con deformaciones pequeñas (lineal).</translation>
    </message>
    <message>
        <source>The liver had not come to rest: landmarks are within {0} mm of it.</source>
        <translation>El hígado no había llegado al reposo: los puntos de referencia están a {0} mm de él como mucho.</translation>
    </message>
    <message>
        <source>This is no liver as the model&apos;s {0}: {1} mm are left between both, and its modes are {2} standard deviations out on average.</source>
        <translation>No es un hígado como los {0} del modelo: quedan {1} mm entre ambos, y sus modos están de media a {2} desviaciones típicas.</translation>
    </message>
    <message>
        <source>Look at spacing and affine; a resected or transplanted liver cannot be completed by a model of whole ones.</source>
        <translation>Revise el espaciado y la matriz afín; un hígado resecado o trasplantado no puede completarse con un modelo de hígados enteros.</translation>
    </message>
    <message>
        <source>The model&apos;s livers come nearer to this one&apos;s mirror image: left and right are exchanged, or the patient is a rare one.</source>
        <translation>Los hígados del modelo se acercan más a la imagen especular de este: izquierda y derecha están intercambiadas, o el paciente es un caso raro.</translation>
    </message>
    <message>
        <source>Look at the file&apos;s affine: which way its first axis runs.</source>
        <translation>Revise la matriz afín del archivo: hacia dónde va su primer eje.</translation>
    </message>
    <message>
        <source>The liver&apos;s mirror image is more like a liver ({0} mm from a typical one, against {1} mm): left and right are exchanged, or the patient is a rare one.</source>
        <translation>La imagen especular del hígado se parece más a un hígado ({0} mm de uno típico, frente a {1} mm): izquierda y derecha están intercambiadas, o el paciente es un caso raro.</translation>
    </message>
    <message>
        <source>A typical liver cannot be bent onto this one: {0} mm are left on average.</source>
        <translation>Un hígado típico no puede doblarse hasta este: quedan {0} mm de media.</translation>
    </message>
    <message>
        <source>Look whether the labels are one whole liver, neither resected nor transplanted.</source>
        <translation>Revise si las etiquetas son un hígado entero, ni resecado ni trasplantado.</translation>
    </message>
    <message>
        <source>No liver of {0} drawn from the model is a body of 400 to 5000 ml.</source>
        <translation>Ninguno de los {0} hígados extraídos del modelo es un cuerpo de 400 a 5000 ml.</translation>
    </message>
    <message>
        <source>The liver has {0} ml, which no adult&apos;s liver has.</source>
        <translation>El hígado tiene {0} ml, lo que no tiene el de ningún adulto.</translation>
    </message>
    <message>
        <source>Look whether the labels&apos; spacing is the scan&apos;s and all of them are liver.</source>
        <translation>Revise si el espaciado de las etiquetas es el del estudio y todas son hígado.</translation>
    </message>
    <message>
        <source>All voxels are said to be 1 x 1 x 1 mm, as in files that have lost their spacing; the liver&apos;s size would be a guess.</source>
        <translation>Todos los vóxeles dicen ser de 1 x 1 x 1 mm, como en los archivos que perdieron su espaciado; el tamaño del hígado sería una suposición.</translation>
    </message>
    <message>
        <source>Write the scan&apos;s spacing into the labels, or say that it is true.</source>
        <translation>Escriba el espaciado del estudio en las etiquetas, o diga que es cierto.</translation>
    </message>
    <message>
        <source>No voxel of the labels is a liver&apos;s.</source>
        <translation>Ningún vóxel de las etiquetas es de un hígado.</translation>
    </message>
    <message>
        <source>The liver lies in pieces that do not touch; the second of them holds {0} %.</source>
        <translation>El hígado está en trozos que no se tocan; el segundo contiene el {0} %.</translation>
    </message>
    <message>
        <source>Mend the labels, or take the piece that is the liver.</source>
        <translation>Corrija las etiquetas, o tome el trozo que es el hígado.</translation>
    </message>
    <message>
        <source>The file is no shape model: its point array {0} is missing or damaged.</source>
        <translation>El archivo no es un modelo de forma: su campo de puntos {0} falta o está dañado.</translation>
    </message>
    <message>
        <source>Give a model.vtp that &quot;study shapes&quot; has made.</source>
        <translation>Dé un model.vtp hecho por &quot;study shapes&quot;.</translation>
    </message>
    <message>
        <source>fitting the shape</source>
        <translation>ajustando la forma</translation>
    </message>
    <message>
        <source>What is seen of the liver does not come to lie on the model anywhere.</source>
        <translation>Lo que se ve del hígado no llega a coincidir con el modelo en ninguna parte.</translation>
    </message>
    <message>
        <source>Look whether it is in the patient&apos;s frame (LPS, mm) and is a liver.</source>
        <translation>Revise si está en el sistema del paciente (LPS, mm) y es un hígado.</translation>
    </message>
    <message>
        <source>A shape model needs {0} shapes or more; there are {1}.</source>
        <translation>Un modelo de forma necesita {0} formas o más; hay {1}.</translation>
    </message>
    <message>
        <source>The shapes have different points or triangles.</source>
        <translation>Las formas tienen puntos o triángulos distintos.</translation>
    </message>
    <message>
        <source>The image cuts the liver off towards {0}: a model learns from whole ones.</source>
        <translation>La imagen corta el hígado (lado: {0}): un modelo aprende de hígados enteros.</translation>
    </message>
    <message>
        <source>The folder holds no label maps of livers.</source>
        <translation>La carpeta no contiene mapas de etiquetas de hígados.</translation>
    </message>
    <message>
        <source>Give one with a file a liver, as ID_liver.nii.gz.</source>
        <translation>Dé una con un archivo por hígado, como ID_liver.nii.gz.</translation>
    </message>
    <message>
        <source>Small or large deformations</source>
        <translation>Deformaciones pequeñas o grandes</translation>
    </message>
    <message>
        <source>The whole organ is stiffer or softer than declared, everywhere by the same factor.</source>
        <translation>Todo el órgano es más rígido o más blando de lo declarado, en todas partes por el mismo factor.</translation>
    </message>
    <message>
        <source>What holds the organ gives way like a spring: all of it moves when a tool moves it.</source>
        <translation>Lo que sujeta el órgano cede como un muelle: se mueve entero cuando un instrumento lo mueve.</translation>
    </message>
    <message>
        <source>The camera stands elsewhere than declared: everything is seen turned and shifted alike.</source>
        <translation>La cámara está en otro sitio que el declarado: todo se ve girado y desplazado por igual.</translation>
    </message>
    <message>
        <source>The tools push with another force than declared, by the same factor in all frames.</source>
        <translation>Los instrumentos empujan con otra fuerza que la declarada, por el mismo factor en todas las imágenes.</translation>
    </message>
    <message>
        <source>Probability that nothing is missing: {1}; next comes: {2}, {3}.</source>
        <translation>Probabilidad de que no falte nada: {1}; a continuación: {2}, {3}.</translation>
    </message>
    <message>
        <source>Probability that nothing is missing: {1}.</source>
        <translation>Probabilidad de que no falte nada: {1}.</translation>
    </message>
    <message>
        <source>Probability of {0}: {1}; next comes: {2}, {3}.</source>
        <translation>Probabilidad de {0}: {1}; a continuación: {2}, {3}.</translation>
    </message>
    <message>
        <source>Probability of {0}: {1}.</source>
        <translation>Probabilidad de {0}: {1}.</translation>
    </message>
    <message>
        <source>Probability that something acts which is not in the catalogue: {1}; next comes: {2}, {3}.</source>
        <translation>Probabilidad de que actúe algo que no está en el catálogo: {1}; a continuación: {2}, {3}.</translation>
    </message>
    <message>
        <source>Probability that something acts which is not in the catalogue: {1}.</source>
        <translation>Probabilidad de que actúe algo que no está en el catálogo: {1}.</translation>
    </message>
    <message>
        <source>The whole specimen is stiffer or softer than declared, everywhere by the same factor.</source>
        <translation>Toda la muestra es más rígida o más blanda de lo declarado, en todas partes por el mismo factor.</translation>
    </message>
    <message>
        <source>The tissue stiffens the further it is strained: pressing twice as hard dents it less than twice as deep.</source>
        <translation>El tejido se vuelve más rígido cuanto más se deforma: al presionar el doble se hunde menos del doble.</translation>
    </message>
    <message>
        <source>What holds the specimen gives way like a spring: all of it moves a little when it is pressed.</source>
        <translation>Lo que sujeta la muestra cede como un muelle: toda ella se mueve un poco al presionarla.</translation>
    </message>
    <message>
        <source>Somewhere inside lies a stiff lump, as a tumour would: around it the specimen moves less.</source>
        <translation>En algún lugar del interior hay un bulto rígido, como lo sería un tumor: a su alrededor la muestra se mueve menos.</translation>
    </message>
    <message>
        <source>The tissue creeps: held under a steady force it goes on giving way for a while.</source>
        <translation>El tejido fluye: bajo una fuerza constante sigue cediendo durante un tiempo.</translation>
    </message>
    <message>
        <source>The load cell is off: it does not read zero when untouched, or it reads too much or too little.</source>
        <translation>La célula de carga está desajustada: no marca cero sin contacto, o marca de más o de menos.</translation>
    </message>
    <message>
        <source>The camera&apos;s coordinates do not match the specimen&apos;s: all markers seem shifted or turned alike.</source>
        <translation>Las coordenadas de la cámara no coinciden con las de la muestra: todos los marcadores parecen desplazados o girados por igual.</translation>
    </message>
    <message>
        <source>The tissue has fibres: it is stiffer (or softer) along one direction than across it.</source>
        <translation>El tejido tiene fibras: es más rígido (o más blando) a lo largo de una dirección que a través de ella.</translation>
    </message>
    <message>
        <source>A skin around the specimen (as Glisson&apos;s capsule around the liver) carries part of the load.</source>
        <translation>Una piel alrededor de la muestra (como la cápsula de Glisson alrededor del hígado) soporta parte de la carga.</translation>
    </message>
    <message>
        <source>Something else loaded the specimen while it was measured, and not when its shape was taken: its weight, or a pressure around it.</source>
        <translation>Algo más cargaba la muestra mientras se medía, y no cuando se tomó su forma: su peso o una presión a su alrededor.</translation>
    </message>
    <message>
        <source>× noise</source>
        <translation>× ruido</translation>
    </message>
    <message>
        <source>What the declared model lacks, by the measurements</source>
        <translation>Lo que le falta al modelo declarado, según las mediciones</translation>
    </message>
    <message>
        <source>What these trials could have shown</source>
        <translation>Lo que estos ensayos habrían podido mostrar</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Lo que se encontró</translation>
    </message>
    <message>
        <source>A smooth correction over load and place predicts trials better that it was not fitted to. It claims no cause.</source>
        <translation>Una corrección suave sobre la carga y el lugar predice mejor ensayos a los que no se ajustó. No afirma ninguna causa.</translation>
    </message>
    <message>
        <source>Candidates, each by itself</source>
        <translation>Candidatos, cada uno por sí solo</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>What to measure next</source>
        <translation>Qué medir a continuación</translation>
    </message>
    <message>
        <source>No further trial is needed to tell the leading explanations apart, or none is known that would.</source>
        <translation>No hace falta otro ensayo para distinguir las explicaciones principales, o no se conoce ninguno que lo haga.</translation>
    </message>
    <message>
        <source>Glisson plans and reviews liver surgery. Not a medical device.</source>
        <translation>Glisson planifica y revisa cirugía hepática. No es un producto sanitario.</translation>
    </message>
    <message>
        <source>What is left is noise: no test finds anything that noise would not do.</source>
        <translation>Lo que queda es ruido: ninguna prueba encuentra nada que el ruido no haría.</translation>
    </message>
    <message>
        <source>What is left is not noise: {0}.</source>
        <translation>Lo que queda no es ruido: {0}.</translation>
    </message>
    <message>
        <source>From this value on, nine of ten such experiments would have shown the effect</source>
        <translation>A partir de este valor, nueve de cada diez experimentos así habrían mostrado el efecto</translation>
    </message>
    <message>
        <source>effect</source>
        <translation>efecto</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>parámetro</translation>
    </message>
    <message>
        <source>without effect</source>
        <translation>sin efecto</translation>
    </message>
    <message>
        <source>seen from</source>
        <translation>visible desde</translation>
    </message>
    <message>
        <source>at no size in its range</source>
        <translation>con ningún valor de su intervalo</translation>
    </message>
    <message>
        <source>Errors ({0})</source>
        <translation>Errores ({0})</translation>
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
        <source>root mean square, trials that were fitted</source>
        <translation>media cuadrática, ensayos ajustados</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>media</translation>
    </message>
    <message>
        <source>95 of 100 are below</source>
        <translation>95 de cada 100 están por debajo</translation>
    </message>
    <message>
        <source>chi-squared over number</source>
        <translation>ji cuadrado entre número</translation>
    </message>
    <message>
        <source>{0} ({1} to {2})</source>
        <translation>{0} (de {1} a {2})</translation>
    </message>
    <message>
        <source>root mean square, trials left out whole</source>
        <translation>media cuadrática, ensayos omitidos por completo</translation>
    </message>
    <message>
        <source>hidden targets, which nothing was fitted to: mean (mm)</source>
        <translation>objetivos ocultos, a los que no se ajustó nada: media (mm)</translation>
    </message>
    <message>
        <source>hidden targets: the farthest (mm)</source>
        <translation>objetivos ocultos: el más alejado (mm)</translation>
    </message>
    <message>
        <source>noise of the measurement</source>
        <translation>ruido de la medición</translation>
    </message>
    <message>
        <source>Parameters, with standard deviation and 95 % interval</source>
        <translation>Parámetros, con desviación estándar e intervalo del 95 %</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>from</source>
        <translation>desde</translation>
    </message>
    <message>
        <source>to</source>
        <translation>hasta</translation>
    </message>
    <message>
        <source>could also be</source>
        <translation>también podría ser</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>no determinado</translation>
    </message>
    <message>
        <source>Errors in {0}; the lower the BIC, the better</source>
        <translation>Errores en {0}; cuanto menor el BIC, mejor</translation>
    </message>
    <message>
        <source>error fitted</source>
        <translation>error ajustado</translation>
    </message>
    <message>
        <source>error on trials left out</source>
        <translation>error en ensayos omitidos</translation>
    </message>
    <message>
        <source>change of BIC</source>
        <translation>cambio del BIC</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>observación</translation>
    </message>
    <message>
        <source>left out: {0}</source>
        <translation>omitido: {0}</translation>
    </message>
    <message>
        <source>like {0}</source>
        <translation>como {0}</translation>
    </message>
    <message>
        <source>Probability of each explanation, all that were weighed taken together</source>
        <translation>Probabilidad de cada explicación, tomadas juntas todas las sopesadas</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>otra cosa</translation>
    </message>
    <message>
        <source>nothing is missing</source>
        <translation>no falta nada</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} y {1}</translation>
    </message>
    <message>
        <source>force (N)</source>
        <translation>fuerza (N)</translation>
    </message>
    <message>
        <source>error ({0})</source>
        <translation>error ({0})</translation>
    </message>
    <message>
        <source>Residual before, trial {0} at its worst: arrows {1} times as long, red at {2} mm</source>
        <translation>Residuo antes, ensayo {0} en su peor momento: flechas {1} veces más largas, rojo en {2} mm</translation>
    </message>
    <message>
        <source>Residual after, trial {0} at its worst: arrows {1} times as long, red at {2} mm</source>
        <translation>Residuo después, ensayo {0} en su peor momento: flechas {1} veces más largas, rojo en {2} mm</translation>
    </message>
    <message>
        <source>voltage (V)</source>
        <translation>tensión (V)</translation>
    </message>
    <message>
        <source>temperature (°C)</source>
        <translation>temperatura (°C)</translation>
    </message>
    <message>
        <source>power (W)</source>
        <translation>potencia (W)</translation>
    </message>
    <message>
        <source>stress (kPa)</source>
        <translation>tensión (kPa)</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>tiempo (s)</translation>
    </message>
    <message>
        <source>strain</source>
        <translation>deformación</translation>
    </message>
    <message>
        <source>residual: {0}</source>
        <translation>residuo: {0}</translation>
    </message>
    <message>
        <source>The image cuts the liver off towards {0}: only whole ones can be retracted.</source>
        <translation>La imagen corta el hígado (lado: {0}): solo se retraen hígados enteros.</translation>
    </message>
    <message>
        <source>The tissue&apos;s own law found no equilibrium: {0}</source>
        <translation>La propia ley del tejido no encontró equilibrio: {0}</translation>
    </message>
    <message>
        <source>Measurements must be 3 to 100000, noise 0 to 50 % of the largest stress, and at most 20 of each are tried.</source>
        <translation>Las mediciones deben ser de 3 a 100000, el ruido de 0 a 50 % de la mayor tensión, y se prueban como mucho 20 de cada uno.</translation>
    </message>
    <message>
        <source>Tests must go to 5 % strain or farther, to 100 % at most, forces be up to 100 N, and a liver have 200 cells or more.</source>
        <translation>Los ensayos deben pasar del 5 % de deformación, como mucho hasta 100 %, las fuerzas no pasar de 100 N, y un hígado tener 200 celdas o más.</translation>
    </message>
    <message>
        <source>The specimen&apos;s state must be &quot;plane-strain&quot;.</source>
        <translation>El estado de la probeta debe ser &quot;plane-strain&quot;.</translation>
    </message>
    <message>
        <source>Plane stress is not known here: a thin sheet needs a law for its thickness.</source>
        <translation>La tensión plana no se conoce aquí: una lámina fina necesita una ley para su espesor.</translation>
    </message>
    <message>
        <source>{0} has {1} points; at most {2} are used.</source>
        <translation>{0} tiene {1} puntos; se usan como máximo {2}.</translation>
    </message>
    <message>
        <source>Give the field on a coarser mesh.</source>
        <translation>Dé el campo en una malla más gruesa.</translation>
    </message>
    <message>
        <source>{0} does not lie in a plane of equal z.</source>
        <translation>{0} no está en un plano de igual z.</translation>
    </message>
    <message>
        <source>{0} has a triangle without area (at {1}, {2}).</source>
        <translation>{0} tiene un triángulo sin área (en {1}, {2}).</translation>
    </message>
    <message>
        <source>The laws are {1}.</source>
        <translation>Las leyes son {1}.</translation>
    </message>
    <message>
        <source>{0} must lie between -1 and 0.5.</source>
        <translation>{0} debe estar entre -1 y 0.5.</translation>
    </message>
    <message>
        <source>The law {0} has no number called &quot;{1}&quot;.</source>
        <translation>La ley {0} no tiene ningún número llamado &quot;{1}&quot;.</translation>
    </message>
    <message>
        <source>Its numbers are {2}.</source>
        <translation>Sus números son {2}.</translation>
    </message>
    <message>
        <source>The declared law lacks some of its numbers: {0}.</source>
        <translation>A la ley declarada le faltan algunos de sus números: {0}.</translation>
    </message>
    <message>
        <source>Give all of them, or none: then they are found first, and the law&apos;s name alone is declared.</source>
        <translation>Dé todos o ninguno: entonces se hallan primero, y solo se declara el nombre de la ley.</translation>
    </message>
    <message>
        <source>{0} has no column &quot;{1}&quot; in its first line.</source>
        <translation>{0} no tiene ninguna columna &quot;{1}&quot; en su primera línea.</translation>
    </message>
    <message>
        <source>Displacements stand in point,ux,uy, reactions in boundary,fx,fy.</source>
        <translation>Los desplazamientos están en point,ux,uy, las reacciones en boundary,fx,fy.</translation>
    </message>
    <message>
        <source>{0} holds no row beneath its first line.</source>
        <translation>{0} no contiene nada bajo su primera línea.</translation>
    </message>
    <message>
        <source>Line {0} of {1} names no point of the mesh, which has {2} from 0 on.</source>
        <translation>La línea {0} de {1} no nombra ningún punto de la malla, que tiene {2} desde 0.</translation>
    </message>
    <message>
        <source>Points are numbered as in the mesh, from 0.</source>
        <translation>Los puntos se numeran como en la malla, desde 0.</translation>
    </message>
    <message>
        <source>{0} names the point array &quot;{1}&quot;, which the mesh does not have.</source>
        <translation>{0} nombra la lista de puntos &quot;{1}&quot;, que la malla no tiene.</translation>
    </message>
    <message>
        <source>{0} names the boundary &quot;{1}&quot;, of which the mesh has no points.</source>
        <translation>{0} nombra el borde &quot;{1}&quot;, del que la malla no tiene puntos.</translation>
    </message>
    <message>
        <source>Boundaries are sides (left, right, bottom, top), point arrays of the mesh, groups in its arrays &quot;group_x&quot; and &quot;group_y&quot;, or stand under &quot;boundaries&quot; in the experiment.</source>
        <translation>Los bordes son lados (left, right, bottom, top), listas de puntos de la malla, grupos de sus listas &quot;group_x&quot; y &quot;group_y&quot;, o están bajo &quot;boundaries&quot; en el experimento.</translation>
    </message>
    <message>
        <source>Nothing says where the plate is held or moved in {0}.</source>
        <translation>Nada dice dónde se sujeta o se mueve la placa en {0}.</translation>
    </message>
    <message>
        <source>Name the boundaries in the tables of reactions, or under &quot;boundaries&quot; in the experiment.</source>
        <translation>Nombre los bordes en las tablas de reacciones, o bajo &quot;boundaries&quot; en el experimento.</translation>
    </message>
    <message>
        <source>No reaction is given where a displacement is prescribed.</source>
        <translation>No se da ninguna reacción donde se impone un desplazamiento.</translation>
    </message>
    <message>
        <source>Displacements alone do not say how stiff the material is.</source>
        <translation>Los desplazamientos solos no dicen cuán rígido es el material.</translation>
    </message>
    <message>
        <source>The noise of displacements is stated as {0}, but neighbouring points differ by {1}, which was taken in its place.</source>
        <translation>El ruido de los desplazamientos se da como {0}, pero puntos vecinos difieren en {1}, que se tomó en su lugar.</translation>
    </message>
    <message>
        <source>The noise of displacements is stated as {0}, but neighbouring points differ by {1} alone: was the field smoothed? Smoothing leaves errors that neighbours share.</source>
        <translation>El ruido de los desplazamientos se da como {0}, pero puntos vecinos difieren solo en {1}: ¿se suavizó el campo? El suavizado deja errores que los vecinos comparten.</translation>
    </message>
    <message>
        <source>The noise of reactions is not stated; as opposite ones balance, {0} was taken.</source>
        <translation>El ruido de las reacciones no se da; según se equilibran las opuestas, se tomó {0}.</translation>
    </message>
    <message>
        <source>The noise of reactions is not stated; {0} was taken, two thousandths of the largest.</source>
        <translation>El ruido de las reacciones no se da; se tomó {0}, dos milésimas de la mayor.</translation>
    </message>
    <message>
        <source>No law has an equilibrium near these displacements.</source>
        <translation>Ninguna ley tiene un equilibrio cerca de estos desplazamientos.</translation>
    </message>
    <message>
        <source>Are points numbered as in the mesh, and are boundaries where the forces were measured?</source>
        <translation>¿Están los puntos numerados como en la malla, y los bordes donde se midieron las fuerzas?</translation>
    </message>
    <message>
        <source>The material resists shear and change of volume by another law than the one that is declared.</source>
        <translation>El material resiste el corte y el cambio de volumen según otra ley que la declarada.</translation>
    </message>
    <message>
        <source>The material is stiffer along fibres than across them.</source>
        <translation>El material es más rígido a lo largo de fibras que a través de ellas.</translation>
    </message>
    <message>
        <source>The law {0} has no equilibrium in trial {1}.</source>
        <translation>La ley {0} no tiene equilibrio en el ensayo {1}.</translation>
    </message>
    <message>
        <source>Are its numbers in the unit of the reactions over lengths, and large enough?</source>
        <translation>¿Están sus números en la unidad de las reacciones por longitud, y son bastante grandes?</translation>
    </message>
    <message>
        <source>The reactions are those of a solution on the mesh&apos;s own linear triangles, not of a plate: that error is in what is predicted for them.</source>
        <translation>Las reacciones son las de una solución en los triángulos lineales de la propia malla, no las de una placa: ese error está en lo que se predice para ellas.</translation>
    </message>
    <message>
        <source>Displacements and reactions are those of a solution on the mesh&apos;s own linear triangles, not of a plate: that error is in what is predicted.</source>
        <translation>Desplazamientos y reacciones son los de una solución en los triángulos lineales de la propia malla, no los de una placa: ese error está en lo que se predice.</translation>
    </message>
    <message>
        <source>The declared law stands without numbers: the best ones were taken as declared.</source>
        <translation>La ley declarada no tiene números: se tomaron los mejores como declarados.</translation>
    </message>
    <message>
        <source>The declared law {0} stands without numbers.</source>
        <translation>La ley declarada {0} no tiene números.</translation>
    </message>
    <message>
        <source>Give them under &quot;declared&quot;, or a model.json with --with.</source>
        <translation>Délos bajo &quot;declared&quot;, o un model.json con --with.</translation>
    </message>
    <message>
        <source>Cell {1} of {0} is a {2} of {3} points; only triangles and quadrangles are used.</source>
        <translation>La celda {1} de {0} es un {2} de {3} puntos; solo se usan triángulos y cuadrángulos.</translation>
    </message>
    <message>
        <source>Cut it into triangles first, for example with ParaView&apos;s Triangulate.</source>
        <translation>Córtela primero en triángulos, por ejemplo con Triangulate de ParaView.</translation>
    </message>
    <message>
        <source>largest strain</source>
        <translation>mayor deformación</translation>
    </message>
    <message>
        <source>Residual before, trial {0} at its worst: arrows {1} times as long, red at {2}</source>
        <translation>Residuo antes, ensayo {0} en su peor momento: flechas {1} veces más largas, rojo en {2}</translation>
    </message>
    <message>
        <source>Residual after, trial {0} at its worst: arrows {1} times as long, red at {2}</source>
        <translation>Residuo después, ensayo {0} en su peor momento: flechas {1} veces más largas, rojo en {2}</translation>
    </message>
    <message>
        <source>Set the cut</source>
        <translation>Poner la sección</translation>
    </message>
    <message>
        <source>Take the cut away</source>
        <translation>Quitar la sección</translation>
    </message>
    <message>
        <source>Change the cut</source>
        <translation>Cambiar la sección</translation>
    </message>
    <message>
        <source>{0} failed ({1}): {2}</source>
        <translation>{0} ha fallado ({1}): {2}</translation>
    </message>
    <message>
        <source>Run it by hand to see all that it says.</source>
        <translation>Ejecútelo a mano para ver todo lo que dice.</translation>
    </message>
    <message>
        <source>In the command {0} a quotation mark is not closed.</source>
        <translation>En la orden {0} hay una comilla sin cerrar.</translation>
    </message>
    <message>
        <source>Close it, or write \ before it.</source>
        <translation>Ciérrela, o escriba \ delante.</translation>
    </message>
    <message>
        <source>The command is empty.</source>
        <translation>La orden está vacía.</translation>
    </message>
    <message>
        <source>There is no program {0} on this computer.</source>
        <translation>No hay ningún programa {0} en este ordenador.</translation>
    </message>
    <message>
        <source>Install it, or write where it lies.</source>
        <translation>Instálelo, o escriba dónde está.</translation>
    </message>
    <message>
        <source>{0} could not be started: {1}</source>
        <translation>No se pudo iniciar {0}: {1}</translation>
    </message>
    <message>
        <source>Check that it may be run.</source>
        <translation>Compruebe que se puede ejecutar.</translation>
    </message>
    <message>
        <source>Handing over the images</source>
        <translation>Entregando las imágenes</translation>
    </message>
    <message>
        <source>As in: TotalSegmentator -i {image} -o {folder}</source>
        <translation>Como en: TotalSegmentator -i {image} -o {folder}</translation>
    </message>
    <message>
        <source>The command {0} is given no image.</source>
        <translation>La orden {0} no recibe ninguna imagen.</translation>
    </message>
    <message>
        <source>The command {0} is not told where to put what it outlines.</source>
        <translation>A la orden {0} no se le dice dónde poner lo que contornea.</translation>
    </message>
    <message>
        <source>The command {0} ended, and left no label map.</source>
        <translation>La orden {0} terminó y no dejó ningún mapa de etiquetas.</translation>
    </message>
    <message>
        <source>Run it by hand, and see which files it writes, and where.</source>
        <translation>Ejecútela a mano y vea qué archivos escribe y dónde.</translation>
    </message>
    <message>
        <source>In Settings, {0} does not say what a value of the outlining program is.</source>
        <translation>En Ajustes, {0} no dice qué es un valor del programa de contornos.</translation>
    </message>
    <message>
        <source>Write value and name, as in 1=liver, 2=tumour-1.</source>
        <translation>Escriba valor y nombre, como en 1=liver, 2=tumour-1.</translation>
    </message>
    <message>
        <source>Noted when {0}&apos;s liver was outlined:</source>
        <translation>Anotado al contornear el hígado de {0}:</translation>
    </message>
    <message>
        <source>{0} is compared with itself.</source>
        <translation>{0} se compara consigo mismo.</translation>
    </message>
    <message>
        <source>Name the case of the earlier study first, then that of the later one.</source>
        <translation>Nombre primero el caso del estudio anterior y después el del posterior.</translation>
    </message>
    <message>
        <source>One study was parted into segments by its vessels, the other by the liver&apos;s shape alone: a part of what differs comes of that.</source>
        <translation>Un estudio se dividió en segmentos según sus vasos, el otro según la forma del hígado sola: una parte de la diferencia viene de ahí.</translation>
    </message>
    <message>
        <source>{0} has no segments yet.</source>
        <translation>{0} aún no tiene segmentos.</translation>
    </message>
    <message>
        <source>Find them first: in Resect, or by glisson-cli territories CASE.</source>
        <translation>Hállelos primero: en Resección o con glisson-cli territories CASE.</translation>
    </message>
    <message>
        <source>The segments of {0} are older than the outlines or vessels that they were made from, or of another version of Glisson.</source>
        <translation>Los segmentos de {0} son más antiguos que los contornos o vasos de los que se hicieron, o de otra versión de Glisson.</translation>
    </message>
    <message>
        <source>Find them anew: in Resect, or by glisson-cli territories CASE.</source>
        <translation>Hállelos de nuevo: en Resección o con glisson-cli territories CASE.</translation>
    </message>
    <message>
        <source>Nothing shows whether {0} and {1} are of one patient: the images of one or both name nobody, or came into their case before cases kept what tells.</source>
        <translation>Nada muestra si {0} y {1} son de un mismo paciente: las imágenes de uno o de ambos no nombran a nadie, o entraron en su caso antes de que los casos lo guardaran.</translation>
    </message>
    <message>
        <source>The images of {0} and {1} name two patients; you said that they are of one.</source>
        <translation>Las imágenes de {0} y {1} nombran a dos pacientes; usted dijo que son de uno.</translation>
    </message>
    <message>
        <source>The images of {0} and {1} name two patients.</source>
        <translation>Las imágenes de {0} y {1} nombran a dos pacientes.</translation>
    </message>
    <message>
        <source>Where they are of one all the same, say so with --same-patient.</source>
        <translation>Si aun así son de uno, dígalo con --same-patient.</translation>
    </message>
    <message>
        <source>By the dates of its images {0} is {1} days older than {2}.</source>
        <translation>Según las fechas de sus imágenes, {0} es {1} días más antiguo que {2}.</translation>
    </message>
    <message>
        <source>By the dates of their images the studies are {0} days apart, and not {1}.</source>
        <translation>Según las fechas de sus imágenes, entre los estudios hay {0} días, y no {1}.</translation>
    </message>
    <message>
        <source>Leave --days out: it is for studies without dates.</source>
        <translation>Omita --days: es para estudios sin fechas.</translation>
    </message>
    <message>
        <source>Both studies are of the same day: there is no growth rate.</source>
        <translation>Ambos estudios son del mismo día: no hay tasa de crecimiento.</translation>
    </message>
    <message>
        <source>How many days lie between the studies is not known, so that there is no growth rate: their images have no dates, or name nobody. Say it (--days).</source>
        <translation>No se sabe cuántos días hay entre los estudios, de modo que no hay tasa de crecimiento: sus imágenes no tienen fechas o no nombran a nadie. Dígalo (--days).</translation>
    </message>
    <message>
        <source>Neither {0} nor {1} has a plan {2}.</source>
        <translation>Ni {0} ni {1} tienen un plan {2}.</translation>
    </message>
    <message>
        <source>{0} alone has the plan {1}, and not all of it goes by segments or territories: a plane, a sheet, a margin or a zone has its place in its own study.</source>
        <translation>Solo {0} tiene el plan {1}, y no todo en él va por segmentos o territorios: un plano, una superficie, un margen o una zona tienen su lugar en su propio estudio.</translation>
    </message>
    <message>
        <source>Keep a plan of that name in the other case too.</source>
        <translation>Conserve un plan de ese nombre también en el otro caso.</translation>
    </message>
    <message>
        <source>Less than {0} mm of the line lie over the liver.</source>
        <translation>Menos de {0} mm de la línea quedan sobre el hígado.</translation>
    </message>
    <message>
        <source>Draw it across the liver, from one side to the other.</source>
        <translation>Trácela a través del hígado, de un lado al otro.</translation>
    </message>
    <message>
        <source>The line turns back on itself.</source>
        <translation>La línea vuelve sobre sí misma.</translation>
    </message>
    <message>
        <source>Draw it from one side of the liver to the other without turning.</source>
        <translation>Trácela de un lado del hígado al otro sin volver atrás.</translation>
    </message>
    <message>
        <source>{0} days between the studies: the second must be later than the first.</source>
        <translation>{0} días entre los estudios: el segundo debe ser posterior al primero.</translation>
    </message>
    <message>
        <source>A standard liver volume of {0} ml is not more than 0.</source>
        <translation>Un volumen estándar del hígado de {0} ml no es mayor que 0.</translation>
    </message>
    <message>
        <source>The liver without tumours has {1} ml, {0} ml before ({2} %).</source>
        <translation>El hígado sin tumores tiene {1} ml, antes {0} ml ({2} %).</translation>
    </message>
    <message>
        <source>What the plan {0} leaves has {2} ml, {1} ml before ({3} %).</source>
        <translation>Lo que deja el plan {0} tiene {2} ml, antes {1} ml ({3} %).</translation>
    </message>
    <message>
        <source>That is {1} % of the standard liver volume of {3} ml, {0} % before: a degree of hypertrophy of {2} percentage points.</source>
        <translation>Es el {1} % del volumen estándar del hígado de {3} ml, antes el {0} %: un grado de hipertrofia de {2} puntos porcentuales.</translation>
    </message>
    <message>
        <source>That is {1} % of the liver without tumours of its own study, {0} % before: a degree of hypertrophy of {2} percentage points.</source>
        <translation>Es el {1} % del hígado sin tumores de su propio estudio, antes el {0} %: un grado de hipertrofia de {2} puntos porcentuales.</translation>
    </message>
    <message>
        <source>Kinetic growth rate: {0} percentage points a week, over {1} days by the images&apos; dates.</source>
        <translation>Tasa de crecimiento cinético: {0} puntos porcentuales por semana, en {1} días según las fechas de las imágenes.</translation>
    </message>
    <message>
        <source>Kinetic growth rate: {0} percentage points a week, over the {1} days that were given.</source>
        <translation>Tasa de crecimiento cinético: {0} puntos porcentuales por semana, en los {1} días que se dieron.</translation>
    </message>
    <message>
        <source>A remnant&apos;s change of up to {0} % may be none: volumes of what is parted anew are off by as much in one of ten.</source>
        <translation>Un cambio del remanente de hasta el {0} % puede no serlo: los volúmenes de lo que se divide de nuevo se desvían otro tanto en uno de cada diez casos.</translation>
    </message>
    <message>
        <source>A segment&apos;s change of up to {0} % (~) may be none: volumes of segments that are parted anew are off by as much in one of ten.</source>
        <translation>Un cambio de un segmento de hasta el {0} % (~) puede no serlo: los volúmenes de segmentos hallados de nuevo se desvían otro tanto en uno de cada diez casos.</translation>
    </message>
    <message>
        <source>Choose the plan {0}</source>
        <translation>Elegir el plan {0}</translation>
    </message>
    <message>
        <source>An OpenCL device solves motions by finite elements with the material &quot;linear&quot; or &quot;corotational&quot;, without tools, ligaments, capsule or gas.</source>
        <translation>Un dispositivo OpenCL resuelve movimientos por elementos finitos con el material &quot;linear&quot; o &quot;corotational&quot;, sin herramientas, ligamentos, cápsula ni gas.</translation>
    </message>
    <message>
        <source>{0} cannot compile the kernels: {1}</source>
        <translation>{0} no puede compilar los núcleos: {1}</translation>
    </message>
    <message>
        <source>The matching takes {0} MB on {1}, which has {2} MB.</source>
        <translation>El emparejamiento necesita {0} MB en {1}, que tiene {2} MB.</translation>
    </message>
    <message>
        <source>An OpenCL device matches by trwls in 16 bits.</source>
        <translation>Un dispositivo OpenCL empareja con trwls en 16 bits.</translation>
    </message>
    <message>
        <source>A probability weighs how well an explanation predicts what was measured, whatever the size of its effects, against how common it is taken to be before anything is measured. &quot;Something else&quot; stands for every cause that is not in the catalogue. Where the answer was known, in generated experiments, 98 of 100 explanations given 90 % and more were right, and 7 of 10 given 60 to 80 %.</source>
        <translation>Una probabilidad sopesa lo bien que una explicación predice lo medido, sea cual sea el tamaño de sus efectos, y lo frecuente que se supone antes de medir nada. «Otra cosa» representa toda causa que no está en el catálogo. Donde se conocía la respuesta, en experimentos generados, 98 de cada 100 explicaciones con un 90 % o más eran correctas, y 7 de cada 10 entre el 60 y el 80 %.</translation>
    </message>
    <message>
        <source>It would tell what is likeliest from {0}.</source>
        <translation>Distinguiría lo más probable de {0}.</translation>
    </message>
    <message>
        <source>Of the doubt among the known explanations {0} % is expected to be gone then.</source>
        <translation>De la duda entre las explicaciones conocidas se espera que entonces haya desaparecido un {0} %.</translation>
    </message>
    <message>
        <source>How the probabilities went while trials were added</source>
        <translation>Cómo cambiaron las probabilidades al añadir ensayos</translation>
    </message>
    <message>
        <source>number of trials</source>
        <translation>número de ensayos</translation>
    </message>
    <message>
        <source>probability (%)</source>
        <translation>probabilidad (%)</translation>
    </message>
    <message>
        <source>{0} has no frame {1}: it has {2}, counted from 0.</source>
        <translation>{0} no tiene la imagen {1}: tiene {2}, contadas desde 0.</translation>
    </message>
    <message>
        <source>Cut along the plan</source>
        <translation>Cortar según el plan</translation>
    </message>
    <message>
        <source>{0} is not the sequence that was asked for: its SHA-256 is another than {1}.</source>
        <translation>{0} no es la secuencia pedida: su SHA-256 es otro que {1}.</translation>
    </message>
    <message>
        <source>From one measurement to the next the values scatter {0} times as much as the stated noise, which cannot be right: state it anew and ask again.</source>
        <translation>De una medición a la siguiente los valores se dispersan {0} veces lo que dice el ruido declarado, que no puede ser correcto: declárelo de nuevo y vuelva a preguntar.</translation>
    </message>
    <message>
        <source>Nothing narrower joins this place to the rest of the structure: cut it off with the scissors, or click farther out.</source>
        <translation>Entre este lugar y el resto de la estructura nada es más estrecho: córtelo con las tijeras o haga clic más afuera.</translation>
    </message>
    <message>
        <source>Take a part off {0}</source>
        <translation>Parte quitada de {0}</translation>
    </message>
    <message>
        <source>The battery stopped discharging while it was measured.</source>
        <translation>La batería dejó de descargarse durante la medición.</translation>
    </message>
    <message>
        <source>Keep the machine unplugged until the measurement ends.</source>
        <translation>Mantenga la máquina desenchufada hasta que termine la medición.</translation>
    </message>
    <message>
        <source>The counter of {0} did not move in {1} s.</source>
        <translation>El contador de {0} no se movió en {1} s.</translation>
    </message>
    <message>
        <source>Measure for longer.</source>
        <translation>Mida durante más tiempo.</translation>
    </message>
    <message>
        <source>{0} gave one reading in {1} s: how sure it is cannot be told. Each metered problem runs {2} s.</source>
        <translation>{0} dio una sola lectura en {1} s: no se puede decir cuán segura es. Cada problema medido se ejecuta {2} s.</translation>
    </message>
    <message>
        <source>{0} is renewed every {1} s: each metered problem runs {2} s. What follows &quot;give or take&quot; is what that resolves; how true the readings are was not checked.</source>
        <translation>{0} se renueva cada {1} s: cada problema medido se ejecuta {2} s. Lo que sigue a «give or take» es la resolución que eso permite; no se comprobó si las lecturas son exactas.</translation>
    </message>
    <message>
        <source>The processor&apos;s energy counters (RAPL) at {0} may be read by root only, as they betray secrets (CVE-2020-8694): run this once as root, or let yourself read energy_uj.</source>
        <translation>Los contadores de energía del procesador (RAPL) en {0} solo los puede leer root, porque delatan secretos (CVE-2020-8694): ejecute esto una vez como root o concédase permiso de lectura de energy_uj.</translation>
    </message>
    <message>
        <source>The processor&apos;s energy counters (RAPL) at {0} hold no number or no range.</source>
        <translation>Los contadores de energía del procesador (RAPL) en {0} no contienen ningún número o ningún intervalo.</translation>
    </message>
    <message>
        <source>The battery gauge at {0} tells neither power nor what is left.</source>
        <translation>El indicador de la batería en {0} no indica ni la potencia ni lo que queda.</translation>
    </message>
    <message>
        <source>A trace needs a channel, factors other than 0, and a range that is positive.</source>
        <translation>Un registro necesita un canal, factores distintos de 0 y un intervalo positivo.</translation>
    </message>
    <message>
        <source>{0} begins as a power analyser&apos;s log, but its first line holds no time and no reading.</source>
        <translation>{0} empieza como el registro de un analizador de potencia, pero su primera línea no contiene ni hora ni lectura.</translation>
    </message>
    <message>
        <source>There is no meter {0} here.{1}</source>
        <translation>Aquí no hay ningún medidor {0}.{1}</translation>
    </message>
    <message>
        <source>{0} lies in no case, so that there is no scan to draw over.</source>
        <translation>{0} no está en ningún caso, así que no hay imagen sobre la que dibujar.</translation>
    </message>
    <message>
        <source>Give a result in the folder results of a case.</source>
        <translation>Indique un resultado de la carpeta results de un caso.</translation>
    </message>
    <message>
        <source>The result has no landmarks &quot;{0}&quot;; it has: {1}.</source>
        <translation>El resultado no tiene referencias «{0}»; tiene: {1}.</translation>
    </message>
    <message>
        <source>A result has no scene named {0}; it has displacement, landmarks.</source>
        <translation>Un resultado no tiene ninguna escena llamada {0}; tiene displacement, landmarks.</translation>
    </message>
    <message>
        <source>{0} must be &quot;glisson-orders/1&quot;.</source>
        <translation>{0} debe ser «glisson-orders/1».</translation>
    </message>
    <message>
        <source>There are no steps to keep as {0}.</source>
        <translation>No hay pasos que conservar como {0}.</translation>
    </message>
    <message>
        <source>Move a rigid tool or advance a cut first.</source>
        <translation>Mueva antes un instrumento rígido o avance un corte.</translation>
    </message>
    <message>
        <source>The case has no order of steps {0}.</source>
        <translation>El caso no tiene ningún orden de pasos {0}.</translation>
    </message>
    <message>
        <source>There is no order of steps to compare.</source>
        <translation>No hay ningún orden de pasos que comparar.</translation>
    </message>
    <message>
        <source>Keep the steps of a rehearsal first.</source>
        <translation>Conserve antes los pasos de un ensayo.</translation>
    </message>
    <message>
        <source>{0} (step {1})</source>
        <translation>{0} (paso {1})</translation>
    </message>
    <message>
        <source>What each order asks of the liver at its worst</source>
        <translation>Lo que cada orden exige del hígado en su peor momento</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>pasos</translation>
    </message>
    <message>
        <source>{0}, largest displacement (mm)</source>
        <translation>{0}, mayor desplazamiento (mm)</translation>
    </message>
    <message>
        <source>{0}, at the end (mm)</source>
        <translation>{0}, al final (mm)</translation>
    </message>
    <message>
        <source>largest force of one tool (N)</source>
        <translation>mayor fuerza de un instrumento (N)</translation>
    </message>
    <message>
        <source>largest strain (%)</source>
        <translation>mayor deformación (%)</translation>
    </message>
    <message>
        <source>strain of vessel walls, 95 of 100 below (%)</source>
        <translation>deformación de las paredes vasculares, 95 de 100 por debajo (%)</translation>
    </message>
    <message>
        <source>cut open at the end (cm2)</source>
        <translation>corte abierto al final (cm2)</translation>
    </message>
    <message>
        <source>steps that could not be carried out</source>
        <translation>pasos que no pudieron ejecutarse</translation>
    </message>
    <message>
        <source>steps not to be used</source>
        <translation>pasos que no deben usarse</translation>
    </message>
    <message>
        <source>Orders of steps</source>
        <translation>Órdenes de pasos</translation>
    </message>
    <message>
        <source>Computed with large deformations, at rest after each step.</source>
        <translation>Calculado con deformaciones grandes, en reposo tras cada paso.</translation>
    </message>
    <message>
        <source>Orders of steps compared</source>
        <translation>Órdenes de pasos comparados</translation>
    </message>
    <message>
        <source>Order of steps: {0}</source>
        <translation>Orden de pasos: {0}</translation>
    </message>
    <message>
        <source>rehearsed</source>
        <translation>ensayado</translation>
    </message>
    <message>
        <source>Keep the steps {0}</source>
        <translation>Conservar los pasos {0}</translation>
    </message>
    <message>
        <source>Drop the steps {0}</source>
        <translation>Descartar los pasos {0}</translation>
    </message>
    <message>
        <source>Compare orders of steps</source>
        <translation>Comparar órdenes de pasos</translation>
    </message>
    <message>
        <source>The calibration is of pictures of {0} x {1} pixels; these have {2} x {3}.</source>
        <translation>La calibración es de imágenes de {0} x {1} píxeles; estas tienen {2} x {3}.</translation>
    </message>
    <message>
        <source>A picture of {0} x {1} pixels cannot be halved into two of one size.</source>
        <translation>Una imagen de {0} x {1} píxeles no se puede dividir en dos de igual tamaño.</translation>
    </message>
    <message>
        <source>Give a video whose pictures show both eyes, or one video for each eye.</source>
        <translation>Indique un vídeo cuyas imágenes muestren ambos ojos, o uno para cada ojo.</translation>
    </message>
    <message>
        <source>The two videos differ in length: frames of the left one {0}, of the right one {1}.</source>
        <translation>Los dos vídeos no duran lo mismo: fotogramas del izquierdo {0}, del derecho {1}.</translation>
    </message>
    <message>
        <source>Give two videos of the same moments, or take fewer frames than both have.</source>
        <translation>Indique dos vídeos de los mismos momentos, o tome menos fotogramas de los que tienen ambos.</translation>
    </message>
    <message>
        <source>SIMULATED: a generated liver, breathing and pressed by a tool as a formula says.</source>
        <translation>SIMULADO: un hígado generado, que respira y es presionado por un instrumento según una fórmula.</translation>
    </message>
    <message>
        <source>The kinds are palpation, material, platform, guidance, full-field and elastography.</source>
        <translation>Las clases son palpation, material, platform, guidance, full-field y elastography.</translation>
    </message>
    <message>
        <source>The trials hold more than {0} values together.</source>
        <translation>Los ensayos contienen juntos más de {0} valores.</translation>
    </message>
    <message>
        <source>Cut the images to the region, or leave trials out.</source>
        <translation>Recorte las imágenes a la región u omita ensayos.</translation>
    </message>
    <message>
        <source>The declared density is {0} kg/m3, which no tissue has.</source>
        <translation>La densidad declarada es de {0} kg/m3, que ningún tejido tiene.</translation>
    </message>
    <message>
        <source>Was it given in g/cm3?</source>
        <translation>¿Se dio en g/cm3?</translation>
    </message>
    <message>
        <source>{0} names none of x, y and z.</source>
        <translation>{0} no nombra ninguno de x, y y z.</translation>
    </message>
    <message>
        <source>{0} must have x, y and z: without one of them a free pressure cannot be taken off.</source>
        <translation>{0} debe tener x, y y z: sin uno de ellos no se puede quitar una presión libre.</translation>
    </message>
    <message>
        <source>{0} must be those of the first trial.</source>
        <translation>{0} deben ser los del primer ensayo.</translation>
    </message>
    <message>
        <source>{0} has more than {1} voxels.</source>
        <translation>{0} tiene más de {1} vóxeles.</translation>
    </message>
    <message>
        <source>Cut it to the region.</source>
        <translation>Recórtela a la región.</translation>
    </message>
    <message>
        <source>The axes of {0} are not at right angles.</source>
        <translation>Los ejes de {0} no forman ángulos rectos.</translation>
    </message>
    <message>
        <source>{0} lies on another grid than the first image.</source>
        <translation>{0} está en otra cuadrícula que la primera imagen.</translation>
    </message>
    <message>
        <source>All images of an experiment have the same voxels.</source>
        <translation>Todas las imágenes de un experimento tienen los mismos vóxeles.</translation>
    </message>
    <message>
        <source>The region holds no voxel in which all images have numbers.</source>
        <translation>La región no contiene ningún vóxel en el que todas las imágenes tengan números.</translation>
    </message>
    <message>
        <source>Was the mask drawn on these images?</source>
        <translation>¿Se dibujó la máscara sobre estas imágenes?</translation>
    </message>
    <message>
        <source>Shear waves run slower or faster than declared, everywhere and at every frequency.</source>
        <translation>Las ondas de corte corren más despacio o más deprisa de lo declarado, en todas partes y a toda frecuencia.</translation>
    </message>
    <message>
        <source>Waves lose energy on their way, as in a viscous tissue.</source>
        <translation>Las ondas pierden energía en su camino, como en un tejido viscoso.</translation>
    </message>
    <message>
        <source>Shear waves along one direction, as of fibres, run at another speed than across it.</source>
        <translation>Las ondas de corte corren a lo largo de una dirección, como la de fibras, a otra velocidad que a través de ella.</translation>
    </message>
    <message>
        <source>Besides shear waves there are long ones that compress; the declared equation knows none.</source>
        <translation>Además de las ondas de corte hay ondas largas que comprimen; la ecuación declarada no las conoce.</translation>
    </message>
    <message>
        <source>Slices were not measured at one moment of the vibration, but one after the other.</source>
        <translation>Los cortes no se midieron en un mismo momento de la vibración, sino uno tras otro.</translation>
    </message>
    <message>
        <source>A region inside is stiffer or softer than declared.</source>
        <translation>Una región interior es más rígida o más blanda de lo declarado.</translation>
    </message>
    <message>
        <source>Along the border another stiffness holds than inside.</source>
        <translation>A lo largo del borde vale otra rigidez que dentro.</translation>
    </message>
    <message>
        <source>The images hold {0} x {1} x {2} voxels, too few for a patch.</source>
        <translation>Las imágenes contienen {0} x {1} x {2} vóxeles, muy pocos para un parche.</translation>
    </message>
    <message>
        <source>Seven along each axis are needed, or a single slice.</source>
        <translation>Hacen falta siete a lo largo de cada eje, o un solo corte.</translation>
    </message>
    <message>
        <source>No patch of trial {0} lies within the region: it would take {1} mm to each side.</source>
        <translation>Ningún parche del ensayo {0} cabe en la región: necesitaría {1} mm a cada lado.</translation>
    </message>
    <message>
        <source>Is the region thin, or the declared modulus in Pa? &quot;patch_radius_mm&quot; sets it.</source>
        <translation>¿Es delgada la región, o está en Pa el módulo declarado? &quot;patch_radius_mm&quot; lo fija.</translation>
    </message>
    <message>
        <source>Of trial {0} {1} patches were taken, evenly from all.</source>
        <translation>Del ensayo {0} se tomaron {1} parches, repartidos por igual.</translation>
    </message>
    <message>
        <source>frequency (Hz)</source>
        <translation>frecuencia (Hz)</translation>
    </message>
    <message>
        <source>The same with the better model</source>
        <translation>Lo mismo con el modelo mejor</translation>
    </message>
    <message>
        <source>What was seen does not lie where the frame before left the organ, and no other place was found: the organ is lost here.</source>
        <translation>Lo que se vio no está donde el fotograma anterior dejó el órgano, y no se encontró otro lugar: aquí el órgano se ha perdido.</translation>
    </message>
    <message>
        <source>{0} holds no marked lines.</source>
        <translation>{0} no contiene líneas marcadas.</translation>
    </message>
    <message>
        <source>It begins with &quot;format&quot;: &quot;glisson-marked-lines/1&quot;; a line has an id, places at rest and places seen, three numbers each.</source>
        <translation>Empieza con &quot;format&quot;: &quot;glisson-marked-lines/1&quot;; una línea tiene un id, puntos en reposo y puntos vistos, de tres números cada uno.</translation>
    </message>
    <message>
        <source>Mark a line</source>
        <translation>Marcar una línea</translation>
    </message>
    <message>
        <source>The format &quot;glisson-contours/1&quot; is described in the documentation.</source>
        <translation>El formato «glisson-contours/1» se describe en la documentación.</translation>
    </message>
    <message>
        <source>One picture tells a pose by two lines of the organ and more; {0} are given.</source>
        <translation>Una imagen indica la posición a partir de dos líneas del órgano; se dan {0}.</translation>
    </message>
    <message>
        <source>Mark ridges and the falciform ligament, or give a pose_guess.</source>
        <translation>Marque los bordes y el ligamento falciforme, o dé pose_guess.</translation>
    </message>
    <message>
        <source>Under no pose do the lines of the organ lie on those of the picture.</source>
        <translation>En ninguna posición están las líneas del órgano sobre las de la imagen.</translation>
    </message>
    <message>
        <source>Check that lines have the same names on both sides, that lengths are in mm, and that the picture is of this camera and patient.</source>
        <translation>Compruebe que las líneas se llaman igual en ambos lados, que las longitudes están en mm y que la imagen es de esta cámara y de este paciente.</translation>
    </message>
    <message>
        <source>The lines of the picture fit the organ in more than one place.</source>
        <translation>Las líneas de la imagen encajan con el órgano en más de un sitio.</translation>
    </message>
    <message>
        <source>Mark another line, or give a pose_guess.</source>
        <translation>Marque otra línea o dé pose_guess.</translation>
    </message>
    <message>
        <source>predicts nothing</source>
        <translation>no predice nada</translation>
    </message>
    <message>
        <source>Fitted without one of the trials, {0} has no solution there, or is farther off than a prediction of zero: it predicts nothing beyond what it was fitted to.</source>
        <translation>Ajustado sin uno de los ensayos, {0} no tiene allí solución, o se desvía más que una predicción de cero: no predice nada fuera de aquello a lo que se ajustó.</translation>
    </message>
    <message>
        <source>one of the quantities that were measured is off by more than its noise</source>
        <translation>una de las magnitudes medidas se desvía más que su ruido</translation>
    </message>
    <message>
        <source>Somewhere inside lies a stiff lump, as a tumour would: around it the organ gives way less.</source>
        <translation>En algún lugar del interior hay un nódulo duro, como lo sería un tumor: a su alrededor el órgano cede menos.</translation>
    </message>
    <message>
        <source>What held the specimen has no place on the organ&apos;s surface: the specimen is not this organ in this place.</source>
        <translation>Lo que sujetaba la muestra no tiene lugar en la superficie del órgano: la muestra no es este órgano en este lugar.</translation>
    </message>
    <message>
        <source>Around ({0}, {1}, {2}) the surface is held within {3} mm by springs of {4} kPa/mm.</source>
        <translation>Alrededor de ({0}, {1}, {2}) la superficie está sujeta en {3} mm por muelles de {4} kPa/mm.</translation>
    </message>
    <message>
        <source>What is declared to hold the organ at {0} holds it with {1} kPa/mm alone.</source>
        <translation>Lo declarado como sujeción del órgano en {0} solo lo sujeta con {1} kPa/mm.</translation>
    </message>
    <message>
        <source>The organ has no support {0} that could hold less.</source>
        <translation>El órgano no tiene ninguna sujeción {0} que pueda sujetar menos.</translation>
    </message>
    <message>
        <source>Something that nobody declared holds a part of the surface, as an adhesion or a ligament does: there it moves less.</source>
        <translation>Algo que nadie declaró sujeta una parte de la superficie, como una adherencia o un ligamento: allí se mueve menos.</translation>
    </message>
    <message>
        <source>One of the declared attachments holds less than declared, or is not there at all.</source>
        <translation>Una de las sujeciones declaradas sujeta menos de lo declarado, o no está.</translation>
    </message>
    <message>
        <source>Error by frequency: broken before, whole after</source>
        <translation>Error según la frecuencia: discontinuo antes, continuo después</translation>
    </message>
    <message>
        <source>Where the declared law does not hold: what it leaves in each patch, in noises (1 is noise alone; red at {0}); the worst layer</source>
        <translation>Dónde no se cumple la ley declarada: lo que deja en cada zona, en ruidos (1 es solo ruido; rojo en {0}); la peor capa</translation>
    </message>
    <message>
        <source>A lens&apos;s distortion has 4, 5, 8, 12 or 14 coefficients; here there are {0}.</source>
        <translation>La distorsión de una lente tiene 4, 5, 8, 12 o 14 coeficientes; aquí hay {0}.</translation>
    </message>
    <message>
        <source>A tool would lie {0} mm deep in the body.</source>
        <translation>Una herramienta quedaría {0} mm dentro del cuerpo.</translation>
    </message>
    <message>
        <source>Move it there in smaller steps, or away from the body.</source>
        <translation>Llévela allí con pasos más pequeños, o aléjela del cuerpo.</translation>
    </message>
    <message>
        <source>Press where trial {0} presses, with {1} N along ({2}, {3}, {4}).</source>
        <translation>Presionar donde presiona el ensayo {0}, con {1} N a lo largo de ({2}, {3}, {4}).</translation>
    </message>
    <message>
        <source>Press at ({0}, {1}, {2}) mm with {3} N and hold the force for {4} s.</source>
        <translation>Presionar en ({0}, {1}, {2}) mm con {3} N y mantener la fuerza durante {4} s.</translation>
    </message>
    <message>
        <source>No vessel lies within {0} mm of {1}, where one was told: put the place on the vessel.</source>
        <translation>A menos de {0} mm de {1}, donde se indicó un vaso, no hay ninguno: ponga el lugar sobre el vaso.</translation>
    </message>
    <message>
        <source>--click wants VESSEL=X,Y,Z with one of {0}, not &quot;{1}&quot;.</source>
        <translation>--click pide VASO=X,Y,Z con uno de {0}, no «{1}».</translation>
    </message>
    <message>
        <source>The residual is larger than the stated noise, but has no shape that speaks of an effect: the noise may be stated too small, or some rows are outliers.</source>
        <translation>El residuo es mayor que el ruido declarado, pero no tiene una forma que indique un efecto: quizá el ruido declarado es demasiado pequeño o algunos valores son atípicos.</translation>
    </message>
    <message>
        <source>Nothing is probable enough to be named. Probability of {0}: {1}; next comes: {2}, {3}.</source>
        <translation>Nada es lo bastante probable para nombrarlo. Probabilidad de {0}: {1}; después viene: {2}, {3}.</translation>
    </message>
    <message>
        <source>Nothing is missing: what the declared model leaves shows no effect, and nothing was added to it.</source>
        <translation>No falta nada: lo que deja el modelo declarado no muestra ningún efecto y no se le añadió nada.</translation>
    </message>
    <message>
        <source>Explained: the effects below are probable enough to be named.</source>
        <translation>Explicado: los efectos de abajo son lo bastante probables para nombrarlos.</translation>
    </message>
    <message>
        <source>Unexplained: something acts that the declared model lacks, and no combination of known effects is probable enough to be named. What is named below removes a part of the error and is not a cause that these data establish.</source>
        <translation>Sin explicar: actúa algo que falta en el modelo declarado, y ninguna combinación de efectos conocidos es lo bastante probable para nombrarla. Lo que figura abajo quita una parte del error y no es una causa que estos datos demuestren.</translation>
    </message>
    <message>
        <source>Probability of {0}, or of what these data cannot tell from it: {1}.</source>
        <translation>Probabilidad de {0}, o de lo que estos datos no distinguen de ello: {1}.</translation>
    </message>
    <message>
        <source>Unite them in one structure, vessels: its systems are told apart.</source>
        <translation>Únalas en una estructura, vessels: sus sistemas se distinguen.</translation>
    </message>
    <message>
        <source>{0} places on borders are told: tell {1} at most.</source>
        <translation>Se dicen {0} lugares en límites: diga {1} como mucho.</translation>
    </message>
    <message>
        <source>{0} does not lie in the liver, where the border of {1} was told: put the place inside.</source>
        <translation>{0} no está en el hígado, donde se dijo el límite de {1}: ponga el lugar dentro.</translation>
    </message>
    <message>
        <source>{0} lies {1} mm from the usual course of the border of {2}: tell the border that is meant, or put the place on it.</source>
        <translation>{0} está a {1} mm del recorrido habitual del límite de {2}: diga el límite que se quiere decir, o ponga el lugar en él.</translation>
    </message>
    <message>
        <source>The border of {0} cannot pass {1} as well as the other borders where they were told: take one of the places back.</source>
        <translation>El límite de {0} no puede pasar por {1} y los demás límites por sus lugares: retire uno de los lugares.</translation>
    </message>
    <message>
        <source>--border wants BORDER=X,Y,Z with one of {0}, not &quot;{1}&quot;.</source>
        <translation>--border pide BORDER=X,Y,Z con uno de {0}, no «{1}».</translation>
    </message>
    <message>
        <source>The tool {0} slides past the body, which gives way under {1} N.</source>
        <translation>La herramienta {0} resbala y pasa de largo: el cuerpo cede ante {1} N.</translation>
    </message>
    <message>
        <source>Push with less, or where the body holds against it.</source>
        <translation>Empuje con menos fuerza o donde el cuerpo resista.</translation>
    </message>
    <message>
        <source>The vessel trees were made before there was {0}: find the vessels again.</source>
        <translation>Los árboles de vasos se hicieron antes de que hubiera {0}: halle los vasos de nuevo.</translation>
    </message>
    <message>
        <source>What {1} was made from has changed since, and {0} was made from that: make {1} anew, then {0}.</source>
        <translation>Aquello de lo que se hizo {1} ha cambiado desde entonces, y {0} se hizo de ello: haga de nuevo {1} y después {0}.</translation>
    </message>
    <message>
        <source>{1} and {2} hold the same vessels: {0} % of the smaller one.</source>
        <translation>{1} y {2} contienen los mismos vasos: el {0} % del menor.</translation>
    </message>
    <message>
        <source>Take the one out of the other: glisson-cli segment --subtract.</source>
        <translation>Quite el uno del otro: glisson-cli segment --subtract.</translation>
    </message>
    <message>
        <source>{0} holds a piece as wide as it is long, which is no vessel.</source>
        <translation>{0} contiene un trozo tan ancho como largo, que no es un vaso.</translation>
    </message>
    <message>
        <source>Outline vessels and ducts alone, the gall bladder by itself.</source>
        <translation>Delimite solo vasos y conductos, y la vesícula biliar aparte.</translation>
    </message>
    <message>
        <source>{0} has no tissue of its own: arteries and bile ducts run with portal branches.</source>
        <translation>{0} no tiene tejido propio: las arterias y los conductos biliares van con las ramas portales.</translation>
    </message>
    <message>
        <source>Take the portal branch beside it.</source>
        <translation>Tome la rama portal de al lado.</translation>
    </message>
    <message>
        <source>{0}: branches that are cut, with the tissue beyond the cut; of arteries and bile ducts their own length.</source>
        <translation>{0}: ramas seccionadas, con el tejido más allá de la sección; de arterias y conductos biliares, su propia longitud.</translation>
    </message>
    <message>
        <source>Beyond it</source>
        <translation>Más allá</translation>
    </message>
    <message>
        <source>Of that left</source>
        <translation>De ello queda</translation>
    </message>
    <message>
        <source>Finding vessels</source>
        <translation>Buscando vasos</translation>
    </message>
    <message>
        <source>The outline to find vessels in holds nothing.</source>
        <translation>El contorno en el que se buscan vasos no contiene nada.</translation>
    </message>
    <message>
        <source>Nothing in the outline stands out as a tube.</source>
        <translation>Nada en el contorno destaca como un tubo.</translation>
    </message>
    <message>
        <source>Vessels need contrast: take another phase or sequence, grow them from seeds, or import their outline.</source>
        <translation>Los vasos necesitan contraste: tome otra fase o secuencia, hágalos crecer desde puntos o importe su contorno.</translation>
    </message>
    <message>
        <source>Vessels are brighter than the tissue around by {0}: {1} ml, {2} % of the outline.</source>
        <translation>Los vasos son {0} más claros que el tejido de alrededor: {1} ml, {2} % del contorno.</translation>
    </message>
    <message>
        <source>Vessels are darker than the tissue around by {0}: {1} ml, {2} % of the outline.</source>
        <translation>Los vasos son {0} más oscuros que el tejido de alrededor: {1} ml, {2} % del contorno.</translation>
    </message>
    <message>
        <source>The seed at ({0}) mm lies more than {1} mm from every vessel found.</source>
        <translation>El punto en ({0}) mm está a más de {1} mm de todo vaso encontrado.</translation>
    </message>
    <message>
        <source>Move the seed onto a vessel, or leave seeds out: then all vessels are kept.</source>
        <translation>Ponga el punto sobre un vaso, o prescinda de puntos: entonces quedan todos los vasos.</translation>
    </message>
    <message>
        <source>With tools in the hand the meshfree engine knows a linear, isotropic liver without ligaments.</source>
        <translation>Con instrumentos en la mano, el método sin malla conoce un hígado lineal e isótropo sin ligamentos.</translation>
    </message>
    <message>
        <source>Take finite elements for others.</source>
        <translation>Tome elementos finitos para otros.</translation>
    </message>
    <message>
        <source>{0} meshfree nodes are too many to be taken in hand: their matrix is not factorised within seconds.</source>
        <translation>{0} nodos sin malla son demasiados para tomarlos en la mano: su matriz no se factoriza en segundos.</translation>
    </message>
    <message>
        <source>Take fewer nodes, or let `simulate` solve for them.</source>
        <translation>Tome menos nodos, o deje que `simulate` los resuelva.</translation>
    </message>
    <message>
        <source>The liver was found without a point: look at it before you trust it, and give a point inside it where it is wrong.</source>
        <translation>El hígado se ha encontrado sin ningún punto: mírelo antes de fiarse de él y, donde esté mal, indique un punto en su interior.</translation>
    </message>
    <message>
        <source>The image shows {0} % of the liver&apos;s border; elsewhere the shape leads.</source>
        <translation>La imagen muestra el {0} % del borde del hígado; en lo demás guía la forma.</translation>
    </message>
    <message>
        <source>There is no image value where the liver is looked for.</source>
        <translation>Donde se busca el hígado, la imagen no tiene ningún valor.</translation>
    </message>
    <message>
        <source>Fitting the shape to the image</source>
        <translation>Ajustando la forma a la imagen</translation>
    </message>
    <message>
        <source>The image hardly shows a border where the model expects the liver&apos;s.</source>
        <translation>Donde el modelo espera el borde del hígado, la imagen apenas muestra alguno.</translation>
    </message>
    <message>
        <source>Give a seed inside the liver; look whether the image shows one, and lies in the patient&apos;s frame (LPS).</source>
        <translation>Indique un punto dentro del hígado; compruebe que la imagen muestre uno y esté en el sistema de coordenadas del paciente (LPS).</translation>
    </message>
    <message>
        <source>Looking for the liver</source>
        <translation>Buscando el hígado</translation>
    </message>
    <message>
        <source>No place in the image looks like a liver of the model&apos;s shape.</source>
        <translation>Ningún lugar de la imagen se parece a un hígado con la forma del modelo.</translation>
    </message>
    <message>
        <source>The liver is what grew by brightness alone: no shape made its border surer.</source>
        <translation>El hígado es lo que creció solo por brillo: ninguna forma hizo más seguro su borde.</translation>
    </message>
    <message>
        <source>Point {0} on what is not liver, at ({1}) mm, lies {2} mm outside the image.</source>
        <translation>El punto {0} sobre lo que no es hígado, en ({1}) mm, está a {2} mm fuera de la imagen.</translation>
    </message>
    <message>
        <source>Points are DICOM patient coordinates (LPS) in mm, not voxel indices.</source>
        <translation>Los puntos son coordenadas DICOM del paciente (LPS) en mm, no índices de vóxeles.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>No hay nada que deshacer.</translation>
    </message>
    <message>
        <source>The scenario says itself how soon the organ stiffens: the effect {0} is left out.</source>
        <translation>El escenario dice él mismo cuándo se endurece el órgano: el efecto {0} se omite.</translation>
    </message>
    <message>
        <source>Only the material veronda-westmann stiffens with strain: the effect {0} is left out.</source>
        <translation>Solo el material veronda-westmann se endurece con la deformación: el efecto {0} se omite.</translation>
    </message>
    <message>
        <source>That the specimen stiffens with strain is not carried to the organ.</source>
        <translation>Que la probeta se endurece con la deformación no se traslada al órgano.</translation>
    </message>
    <message>
        <source>With large deformations the organ stiffens as it is strained (Veronda and Westmann&apos;s law, strain_stiffening {0}); with small ones it does not.</source>
        <translation>Con deformaciones grandes el órgano se endurece al deformarse (ley de Veronda y Westmann, strain_stiffening {0}); con pequeñas, no.</translation>
    </message>
    <message>
        <source>Only bent by {0} mm (rms) does the organ lie where it was seen: it is another organ, the cloud is mirrored, or the guess is far off.</source>
        <translation>Solo deformado en {0} mm (media cuadrática) queda el órgano donde se vio: es otro órgano, la nube está reflejada o la estimación está muy lejos.</translation>
    </message>
    <message>
        <source>The feature {0} lies {1} mm from the organ at rest: it is of another organ, or in another frame than the mesh.</source>
        <translation>El rasgo {0} está a {1} mm del órgano en reposo: es de otro órgano, o está en otro sistema de coordenadas que la malla.</translation>
    </message>
    <message>
        <source>The feature {0} lies {1} mm from where all else that is seen has it: the features contradict each other or the cloud. Is each named rightly?</source>
        <translation>El rasgo {0} está a {1} mm de donde lo sitúa todo lo demás que se ve: los rasgos se contradicen entre sí o con la nube. ¿Tiene cada uno su nombre correcto?</translation>
    </message>
    <message>
        <source>Go on along the earlier cut, or keep farther away from it.</source>
        <translation>Continúe por el corte anterior o manténgase más lejos de él.</translation>
    </message>
    <message>
        <source>No equilibrium of the pressed gel was found at {0} mm.</source>
        <translation>No se encontró ningún equilibrio del gel presionado a {0} mm.</translation>
    </message>
    <message>
        <source>The gel does not bear {0} N at {1} mm of depth.</source>
        <translation>El gel no soporta {0} N a {1} mm de profundidad.</translation>
    </message>
    <message>
        <source>There is no trial {0}; the first one is {1}.</source>
        <translation>No hay ningún ensayo {0}; el primero es {1}.</translation>
    </message>
    <message>
        <source>A scene for SOFA cannot hold what the scenario says with {0}.</source>
        <translation>Una escena para SOFA no puede contener lo que el escenario dice con {0}.</translation>
    </message>
    <message>
        <source>It holds linear and corotational bodies by finite elements, fixed points, foundations and loads.</source>
        <translation>Contiene cuerpos lineales y corrotacionales por elementos finitos, puntos fijos, cimentaciones y cargas.</translation>
    </message>
    <message>
        <source>Without a scenario, the scene hoists segment VI with {0} N.</source>
        <translation>Sin escenario, la escena levanta el segmento VI con {0} N.</translation>
    </message>
    <message>
        <source>A scene for SOFA cannot hold the effect {0}: it is left out.</source>
        <translation>Una escena para SOFA no puede contener el efecto {0}: se omite.</translation>
    </message>
    <message>
        <source>SOFA&apos;s linear tetrahedra are stiffer than the quadratic ones here: the largest displacement should be {0} mm in the scene, and is {1} mm in Glisson.</source>
        <translation>Los tetraedros lineales de SOFA son más rígidos que los cuadráticos de aquí: el mayor desplazamiento debería ser de {0} mm en la escena y es de {1} mm en Glisson.</translation>
    </message>
    <message>
        <source>The liver&apos;s points are not those of the liver whose vessels are carried along.</source>
        <translation>Los puntos del hígado no son los del hígado cuyos vasos se llevan consigo.</translation>
    </message>
    <message>
        <source>Give the spacing of the reference that the model was made with, or draw without vessels.</source>
        <translation>Indique el espaciado de la referencia con el que se hizo el modelo, o genere sin vasos.</translation>
    </message>
    <message>
        <source>The liver is bent so far that vessels carried along would be turned inside out.</source>
        <translation>El hígado está tan doblado que los vasos llevados consigo quedarían vueltos del revés.</translation>
    </message>
    <message>
        <source>--scenario serves a scene for SOFA alone (--format sofa).</source>
        <translation>--scenario sirve solo para una escena para SOFA (--format sofa).</translation>
    </message>
    <message>
        <source>The scenario says itself how the organ relaxes: the effect {0} is left out.</source>
        <translation>El escenario dice él mismo cómo se relaja el órgano: el efecto {0} se omite.</translation>
    </message>
    <message>
        <source>Held for long, the organ creeps: it is {0} times as stiff as at once. In motion it relaxes on the way there, with times of {1} s.</source>
        <translation>Sujetado mucho tiempo, el órgano fluye: es entonces {0} veces tan rígido como al instante. En movimiento se relaja hasta ahí con tiempos de {1} s.</translation>
    </message>
    <message>
        <source>A relaxation has at most {0} terms, and {1} are given.</source>
        <translation>Una relajación tiene como mucho {0} términos, y se dan {1}.</translation>
    </message>
    <message>
        <source>Term {0} of a relaxation needs a weight between 0 and 1 and a time above zero.</source>
        <translation>El término {0} de una relajación necesita un peso entre 0 y 1 y un tiempo mayor que cero.</translation>
    </message>
    <message>
        <source>The weights of a relaxation sum to {0}: they must leave something of the stiffness, and sum to less than 1.</source>
        <translation>Los pesos de una relajación suman {0}: deben dejar algo de la rigidez y sumar menos de 1.</translation>
    </message>
    <message>
        <source>Straight from data nothing relaxes: the measured stresses are what is left.</source>
        <translation>Directamente de los datos nada se relaja: las tensiones medidas son lo que queda.</translation>
    </message>
    <message>
        <source>Leave out &quot;relaxation&quot;.</source>
        <translation>Omita &quot;relaxation&quot;.</translation>
    </message>
    <message>
        <source>A line that cuts needs 2 to {0} places; there are {1}.</source>
        <translation>Una línea de corte necesita de 2 a {0} puntos; hay {1}.</translation>
    </message>
    <message>
        <source>A line that cuts needs a way into the body with a length.</source>
        <translation>Una línea de corte necesita una dirección hacia el interior del cuerpo que tenga longitud.</translation>
    </message>
    <message>
        <source>A place of the line that cuts is not finite.</source>
        <translation>Un punto de la línea de corte no es finito.</translation>
    </message>
    <message>
        <source>Places {0} and {1} of the line that cuts lie above each other, along its way into the body.</source>
        <translation>Los puntos {0} y {1} de la línea de corte están uno sobre otro, en su dirección hacia el interior del cuerpo.</translation>
    </message>
    <message>
        <source>The line turns more sharply than the model&apos;s cells can follow, or meets itself.</source>
        <translation>La línea gira más cerrado de lo que las celdas del modelo pueden seguir, o se encuentra consigo misma.</translation>
    </message>
    <message>
        <source>Draw a wider curve, or begin a new cut farther away.</source>
        <translation>Dibuje una curva más amplia o empiece un corte nuevo más lejos.</translation>
    </message>
    <message>
        <source>Meshfree nodes reach ahead of a cut: its line cannot be drawn further once it is cut along.</source>
        <translation>Los nodos sin malla alcanzan más allá de un corte: su línea no se puede prolongar una vez que se ha cortado por ella.</translation>
    </message>
    <message>
        <source>Give the whole line before its first advance, or begin a new cut.</source>
        <translation>Dé la línea entera antes de su primer avance o empiece un corte nuevo.</translation>
    </message>
    <message>
        <source>The line leaves the surface that it was drawn on.</source>
        <translation>La línea sale de la superficie sobre la que se dibujó.</translation>
    </message>
    <message>
        <source>Turn the liver until you look onto it, and go on from there.</source>
        <translation>Gire el hígado hasta mirarlo de frente y siga desde ahí.</translation>
    </message>
    <message>
        <source>Lift, and begin a new cut farther away.</source>
        <translation>Suelte y empiece un corte nuevo más lejos.</translation>
    </message>
    <message>
        <source>Cut freehand</source>
        <translation>Cortar a mano alzada</translation>
    </message>
    <message>
        <source>A body in motion keeps its moduli.</source>
        <translation>Un cuerpo en movimiento conserva sus módulos.</translation>
    </message>
    <message>
        <source>A session in motion is by quadratic finite elements.</source>
        <translation>Una sesión en movimiento se calcula con elementos finitos cuadráticos.</translation>
    </message>
    <message>
        <source>A command is {&quot;hold&quot;: {...}}, {&quot;release&quot;: id}, {&quot;cut&quot;: {...}}, {&quot;undo&quot;: true}, {&quot;settle&quot;: true}, {&quot;compare&quot;: true} or {&quot;wait_steps&quot;: n}.</source>
        <translation>Una orden es {&quot;hold&quot;: {...}}, {&quot;release&quot;: id}, {&quot;cut&quot;: {...}}, {&quot;undo&quot;: true}, {&quot;settle&quot;: true}, {&quot;compare&quot;: true} o {&quot;wait_steps&quot;: n}.</translation>
    </message>
    <message>
        <source>A cut does not advance in a session in motion.</source>
        <translation>Un corte no avanza en una sesión en movimiento.</translation>
    </message>
    <message>
        <source>Cut in a session at rest.</source>
        <translation>Corte en una sesión en reposo.</translation>
    </message>
    <message>
        <source>At large strain a session in motion is damped by its mass alone.</source>
        <translation>Con deformaciones grandes, una sesión en movimiento se amortigua solo por su masa.</translation>
    </message>
    <message>
        <source>A session in motion is by finite elements.</source>
        <translation>Una sesión en movimiento se calcula con elementos finitos.</translation>
    </message>
    <message>
        <source>Take the engine &quot;fem&quot;, or no motion.</source>
        <translation>Tome el método &quot;fem&quot;, o ningún movimiento.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::AblationControls</name>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonda</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Diameter of the zone along the probe</source>
        <translation>Diámetro de la zona a lo largo de la sonda</translation>
    </message>
    <message>
        <source>Diameter of the zone across the probe</source>
        <translation>Diámetro de la zona a través de la sonda</translation>
    </message>
    <message>
        <source>from the side</source>
        <translation>desde el lado</translation>
    </message>
    <message>
        <source>from the front</source>
        <translation>desde delante</translation>
    </message>
    <message>
        <source>from below</source>
        <translation>desde abajo</translation>
    </message>
    <message>
        <source>At the crosshair</source>
        <translation>En la cruz</translation>
    </message>
    <message>
        <source>Sets a zone of this size about the crosshair</source>
        <translation>Pone una zona de este tamaño alrededor de la cruz</translation>
    </message>
    <message>
        <source>Over this tumour</source>
        <translation>Sobre este tumor</translation>
    </message>
    <message>
        <source>Sets the smallest ball that holds the tumour chosen above with its margin</source>
        <translation>Pone la menor esfera que contiene el tumor elegido arriba con su margen</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::AdvanceControls</name>
    <message>
        <source>Cut 5 mm further</source>
        <translation>Cortar 5 mm más</translation>
    </message>
    <message>
        <source>Leads the planned cut on, from the lower front edge to the upper back, while rigid tools hold the liver. Energy devices and bleeding are not simulated.</source>
        <translation>Continúa el corte planificado, del borde anterior inferior hacia atrás y arriba, mientras instrumentos rígidos sujetan el hígado. No se simulan instrumentos de energía ni sangrado.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Deshacer el paso</translation>
    </message>
    <message>
        <source>Tick the rigid tool above, to cut while tools hold the liver.</source>
        <translation>Marque arriba el instrumento rígido para cortar mientras los instrumentos sujetan el hígado.</translation>
    </message>
    <message>
        <source>%1 % of the section is open, by up to %2 mm.</source>
        <translation>El %1 % de la sección está abierto, hasta %2 mm.</translation>
    </message>
    <message>
        <source>Crossed: %1.</source>
        <translation>Cruzado: %1.</translation>
    </message>
    <message>
        <source>The plan&apos;s cut is %1 mm long. Nothing is cut yet.</source>
        <translation>El corte planificado mide %1 mm. Aún no se ha cortado nada.</translation>
    </message>
    <message>
        <source>Plan a plane or a sheet in Resect and keep the plan, to cut along it here.</source>
        <translation>Planifique un plano o una superficie en Resección y conserve el plan, para cortar aquí a lo largo de él.</translation>
    </message>
    <message>
        <source>By finite elements: %1 mm.</source>
        <translation>Por elementos finitos: %1 mm.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Closes the last advance, as long as no tool was moved since</source>
        <translation>Cierra el último avance mientras no se haya movido ningún instrumento</translation>
    </message>
    <message>
        <source>Cut freehand</source>
        <translation>Cortar a mano alzada</translation>
    </message>
    <message>
        <source>Then draw over the liver in the 3D view with the left button held: it parts behind the pointer, straight away from you, as deep as is said here. From the end of the last line the cut goes on.</source>
        <translation>Después dibuje sobre el hígado en la vista 3D con el botón izquierdo pulsado: se separa detrás del puntero, recto desde usted hacia dentro, tan hondo como se dice aquí. Desde el extremo de la última línea el corte continúa.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How deep the knife goes from the surface, away from you</source>
        <translation>Cuánto entra el cuchillo desde la superficie, alejándose de usted</translation>
    </message>
    <message>
        <source>%1 cm² are cut, open by up to %2 mm.</source>
        <translation>%1 cm² están cortados, abiertos hasta %2 mm.</translation>
    </message>
    <message>
        <source>Cut freehand, or plan a plane or a sheet in Resect and keep the plan, to cut along it here.</source>
        <translation>Corte a mano alzada, o planifique un plano o una superficie en Resección y conserve el plan, para cortar aquí a lo largo de él.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::AlgorithmChoice</name>
    <message>
        <source>ICP: nearest points</source>
        <translation>ICP: puntos más cercanos</translation>
    </message>
    <message>
        <source>GEO: distances along the surface</source>
        <translation>GEO: distancias a lo largo de la superficie</translation>
    </message>
    <message>
        <source>GNRA: all frames by their landmarks</source>
        <translation>GNRA: todos los fotogramas por sus puntos de referencia</translation>
    </message>
    <message>
        <source>Given by the sequence</source>
        <translation>Dado por la secuencia</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>Dado</translation>
    </message>
    <message>
        <source>Algorithms</source>
        <translation>Algoritmos</translation>
    </message>
    <message>
        <source>First algorithm</source>
        <translation>Primer algoritmo</translation>
    </message>
    <message>
        <source>Second algorithm</source>
        <translation>Segundo algoritmo</translation>
    </message>
    <message>
        <source>What the left picture shows</source>
        <translation>Lo que muestra la imagen izquierda</translation>
    </message>
    <message>
        <source>What the right picture shows, or nothing</source>
        <translation>Lo que muestra la imagen derecha, o nada</translation>
    </message>
    <message>
        <source>Register and judge</source>
        <translation>Registrar y juzgar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stops registering; what was computed before stays</source>
        <translation>Detiene el registro; lo calculado antes se conserva</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>No second algorithm</source>
        <translation>Sin segundo algoritmo</translation>
    </message>
    <message>
        <source>The sequence names no registered clouds</source>
        <translation>La secuencia no indica nubes registradas</translation>
    </message>
    <message>
        <source>The sequence names no model</source>
        <translation>La secuencia no indica ningún modelo</translation>
    </message>
    <message>
        <source>Open a sequence first</source>
        <translation>Abra primero una secuencia</translation>
    </message>
    <message>
        <source>It is being computed</source>
        <translation>Se está calculando</translation>
    </message>
    <message>
        <source>Both algorithms are computed already</source>
        <translation>Ambos algoritmos ya están calculados</translation>
    </message>
    <message>
        <source>Registers every frame by the algorithms above and judges them by SIRGn: up to a second or so a frame</source>
        <translation>Registra cada fotograma con los algoritmos de arriba y los juzga con SIRGn: hasta un segundo por fotograma, más o menos</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::BorderByHand</name>
    <message>
        <source>Runs through the crosshair</source>
        <translation>Pasa por la cruz</translation>
    </message>
    <message>
        <source>First stands the border that runs nearest to the crosshair</source>
        <translation>Primero está el límite que pasa más cerca de la cruz</translation>
    </message>
    <message>
        <source>Border %1 (%2 mm away)</source>
        <translation>Límite %1 (a %2 mm)</translation>
    </message>
    <message>
        <source>Forget the last place (%1)</source>
        <translation>Olvidar el último lugar (%1)</translation>
    </message>
    <message>
        <source>Places on borders that were set by hand: %1. Segments are found again without the last</source>
        <translation>Lugares en límites puestos a mano: %1. Los segmentos se hallan de nuevo sin el último</translation>
    </message>
    <message>
        <source>The border of these two segments is to pass the crosshair. Segments are found again by it, and are less in doubt. Its mark is dragged in a slice or in 3D; Delete takes away the one that was clicked on</source>
        <translation>El límite de estos dos segmentos debe pasar por la cruz. Los segmentos se hallan de nuevo según él y hay menos en duda. Su marca se arrastra en un corte o en 3D; Supr quita la que se ha pulsado</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::CandidatesTable</name>
    <message>
        <source>very strong</source>
        <translation>muy fuerte</translation>
    </message>
    <message>
        <source>strong</source>
        <translation>fuerte</translation>
    </message>
    <message>
        <source>weak</source>
        <translation>débil</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Suspect, each by itself</source>
        <translation>Sospechoso, cada uno por sí solo</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>On trials left out</source>
        <translation>En ensayos apartados</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>Evidencia</translation>
    </message>
    <message>
        <source>These data cannot tell it from</source>
        <translation>Estos datos no lo distinguen de</translation>
    </message>
    <message>
        <source>Root mean square on the trials that it was fitted to</source>
        <translation>Media cuadrática en los ensayos a los que se ajustó</translation>
    </message>
    <message>
        <source>Root mean square on trials that it was not fitted to, left out whole</source>
        <translation>Media cuadrática en ensayos enteros apartados, a los que no se ajustó</translation>
    </message>
    <message>
        <source>Against the declared model, by the difference of BIC</source>
        <translation>Contra el modelo declarado, por la diferencia de BIC</translation>
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
        <translation>fuera de concurso: %1</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::CaseDiary</name>
    <message>
        <source>Diary of %1 - Glisson</source>
        <translation>Diario de %1 - Glisson</translation>
    </message>
    <message>
        <source>What was done to this case, as far as it can be undone. Copied, it is a program that does the same without a window, on the case as it was before.</source>
        <translation>Lo que se hizo en este caso, en cuanto se puede deshacer. Copiado, es un programa que hace lo mismo sin ventana, en el caso tal como era antes.</translation>
    </message>
    <message>
        <source>The steps</source>
        <translation>Los pasos</translation>
    </message>
    <message>
        <source>Copy as Python</source>
        <translation>Copiar como Python</translation>
    </message>
    <message>
        <source>Copy as command line</source>
        <translation>Copiar como línea de órdenes</translation>
    </message>
    <message>
        <source>Steps copied: %1</source>
        <translation>Pasos copiados: %1</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::CaseOverview</name>
    <message>
        <source>The open case</source>
        <translation>El caso abierto</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Elemento</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Creado por</translation>
    </message>
    <message>
        <source>What comes next</source>
        <translation>Lo que sigue</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>al día</translation>
    </message>
    <message>
        <source>⚠ stale</source>
        <translation>⚠ desfasado</translation>
    </message>
    <message>
        <source>⚠ changed by another program</source>
        <translation>⚠ modificado por otro programa</translation>
    </message>
    <message>
        <source>⚠ file is gone</source>
        <translation>⚠ falta el archivo</translation>
    </message>
    <message>
        <source>Something that it was made from has changed since.</source>
        <translation>Algo de lo que se hizo ha cambiado desde entonces.</translation>
    </message>
    <message>
        <source>No case is open. Open images, choose what each series is for, and make a case of them.</source>
        <translation>No hay ningún caso abierto. Abra imágenes, elija para qué es cada serie y cree un caso con ellas.</translation>
    </message>
    <message>
        <source>Everything is up to date.</source>
        <translation>Todo está al día.</translation>
    </message>
    <message>
        <source>Stale: %1. They were made from something that has changed since.</source>
        <translation>Desfasados: %1. Se hicieron de algo que ha cambiado desde entonces.</translation>
    </message>
    <message>
        <source>Make the model anew</source>
        <translation>Rehacer el modelo</translation>
    </message>
    <message>
        <source>There are no anatomical images: without them nothing can be outlined. Open them on the left.</source>
        <translation>No hay imágenes anatómicas: sin ellas no se puede delimitar nada. Ábralas a la izquierda.</translation>
    </message>
    <message>
        <source>The elastography has not been inverted: File, Elastography waves (Ctrl+W) makes the stiffness of it.</source>
        <translation>La elastografía no se ha invertido: Archivo, Ondas de elastografía (Ctrl+W) obtiene de ella la rigidez.</translation>
    </message>
    <message>
        <source>The liver is not outlined yet.</source>
        <translation>El hígado aún no está delimitado.</translation>
    </message>
    <message>
        <source>Outline it in Segment</source>
        <translation>Delimitarlo en Segmentar</translation>
    </message>
    <message>
        <source>There is no model yet.</source>
        <translation>Aún no hay modelo.</translation>
    </message>
    <message>
        <source>Build the model</source>
        <translation>Construir el modelo</translation>
    </message>
    <message>
        <source>The model is there.</source>
        <translation>El modelo está hecho.</translation>
    </message>
    <message>
        <source>Rehearse</source>
        <translation>Ensayar</translation>
    </message>
    <message>
        <source>Building the model</source>
        <translation>Construyendo el modelo</translation>
    </message>
    <message>
        <source>import</source>
        <translation>importación</translation>
    </message>
    <message>
        <source>outlining</source>
        <translation>delimitación</translation>
    </message>
    <message>
        <source>meshing</source>
        <translation>mallado</translation>
    </message>
    <message>
        <source>giving stiffness</source>
        <translation>asignación de rigidez</translation>
    </message>
    <message>
        <source>inversion of waves</source>
        <translation>inversión de las ondas</translation>
    </message>
    <message>
        <source>Outline: %1</source>
        <translation>Contorno: %1</translation>
    </message>
    <message>
        <source>Surface: %1</source>
        <translation>Superficie: %1</translation>
    </message>
    <message>
        <source>Tetrahedra of the liver</source>
        <translation>Tetraedros del hígado</translation>
    </message>
    <message>
        <source>Model: stiffness of each cell</source>
        <translation>Modelo: rigidez de cada celda</translation>
    </message>
    <message>
        <source>Images: anatomy</source>
        <translation>Imágenes: anatomía</translation>
    </message>
    <message>
        <source>Map: stiffness (kPa)</source>
        <translation>Mapa: rigidez (kPa)</translation>
    </message>
    <message>
        <source>Map: confidence</source>
        <translation>Mapa: confianza</translation>
    </message>
    <message>
        <source>MRE magnitude</source>
        <translation>Magnitud de ERM</translation>
    </message>
    <message>
        <source>MRE phase</source>
        <translation>Fase de ERM</translation>
    </message>
    <message>
        <source>MRE waves</source>
        <translation>Ondas de ERM</translation>
    </message>
    <message>
        <source>There is no model yet. Without elastography its stiffness is assumed: the atlas&apos;s.</source>
        <translation>Todavía no hay modelo. Sin elastografía su rigidez es supuesta: la del atlas.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ComparisonChoice</name>
    <message>
        <source>Patient</source>
        <translation>Paciente</translation>
    </message>
    <message>
        <source>Atlas</source>
        <translation>Atlas</translation>
    </message>
    <message>
        <source>With one stiffness for the whole liver, as an atlas gives it</source>
        <translation>Con una sola rigidez para todo el hígado, como la da un atlas</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Ambos</translation>
    </message>
    <message>
        <source>Atlas in red, patient in blue: purple where they agree</source>
        <translation>Atlas en rojo, paciente en azul: violeta donde coinciden</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Lado a lado</translation>
    </message>
    <message>
        <source>Two 3D views that turn together: the patient on the left, the atlas on the right</source>
        <translation>Dos vistas 3D que giran juntas: el paciente a la izquierda, el atlas a la derecha</translation>
    </message>
    <message>
        <source>No stiffness was measured: there is nothing to compare with the atlas</source>
        <translation>No se midió ninguna rigidez: no hay nada que comparar con el atlas</translation>
    </message>
    <message>
        <source>With this patient&apos;s own stiffness, as it was measured</source>
        <translation>Con la rigidez propia de este paciente, tal como se midió</translation>
    </message>
    <message>
        <source>With the assumed stiffness</source>
        <translation>Con la rigidez supuesta</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ContourPlot</name>
    <message>
        <source>Liver (cm³)</source>
        <translation>Hígado (cm³)</translation>
    </message>
    <message>
        <source>Volume of a node (mm³)</source>
        <translation>Volumen de un nodo (mm³)</translation>
    </message>
    <message>
        <source>Accuracy (mm)</source>
        <translation>Precisión (mm)</translation>
    </message>
    <message>
        <source>hot spot</source>
        <translation>punto caliente</translation>
    </message>
    <message>
        <source>this case</source>
        <translation>este caso</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::CutControls</name>
    <message>
        <source>Cut by a plane</source>
        <translation>Sección por un plano</translation>
    </message>
    <message>
        <source>Cut by a smooth surface through points</source>
        <translation>Sección por una superficie suave que pasa por puntos</translation>
    </message>
    <message>
        <source>Divides</source>
        <translation>Separa</translation>
    </message>
    <message>
        <source>left from right</source>
        <translation>izquierda de derecha</translation>
    </message>
    <message>
        <source>front from back</source>
        <translation>delante de detrás</translation>
    </message>
    <message>
        <source>head from foot</source>
        <translation>cabeza de pies</translation>
    </message>
    <message>
        <source>Through crosshair</source>
        <translation>Por la cruz</translation>
    </message>
    <message>
        <source>Puts the plane through the crosshair, across the direction above</source>
        <translation>Pone el plano por la cruz, transversal a la dirección de arriba</translation>
    </message>
    <message>
        <source>By three clicks</source>
        <translation>Con tres clics</translation>
    </message>
    <message>
        <source>Then click three places on the liver or in the slices</source>
        <translation>Haga clic después en tres lugares del hígado o de los cortes</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Desplazar</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Inclinar</translation>
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
        <translation>Distancia del plano al centro del hígado, a lo largo de su normal</translation>
    </message>
    <message>
        <source>The normal about the axis from feet to head: 0° to the patient&apos;s left, 90° to the back</source>
        <translation>La normal alrededor del eje de pies a cabeza: 0° hacia la izquierda del paciente, 90° hacia atrás</translation>
    </message>
    <message>
        <source>The normal upwards: 90° to the head</source>
        <translation>La normal hacia arriba: 90° hacia la cabeza</translation>
    </message>
    <message>
        <source>Set points</source>
        <translation>Poner puntos</translation>
    </message>
    <message>
        <source>Each click on the liver or in a slice sets a point; points can be dragged</source>
        <translation>Cada clic en el hígado o en un corte pone un punto; los puntos se pueden arrastrar</translation>
    </message>
    <message>
        <source>Drop the last</source>
        <translation>Quitar el último</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Points set: %1. Three are needed.</source>
        <translation>Puntos puestos: %1. Hacen falta tres.</translation>
    </message>
    <message>
        <source>Points set: %1. Drag them in any view.</source>
        <translation>Puntos puestos: %1. Arrástrelos en cualquier vista.</translation>
    </message>
    <message>
        <source>Draw a line</source>
        <translation>Trazar una línea</translation>
    </message>
    <message>
        <source>Then draw over the liver in the 3D view with the left button held: the cut goes straight down under the line, as it is seen from there</source>
        <translation>Después trace sobre el hígado en la vista 3D con el botón izquierdo pulsado: la sección baja recta bajo la línea, tal como se ve desde allí</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::DeformationChoice</name>
    <message>
        <source>Deformations</source>
        <translation>Deformaciones</translation>
    </message>
    <message>
        <source>Small (at once)</source>
        <translation>Pequeñas (al instante)</translation>
    </message>
    <message>
        <source>A linear liver: made for strains up to 20 %</source>
        <translation>Un hígado lineal: hecho para deformaciones unitarias de hasta el 20 %</translation>
    </message>
    <message>
        <source>Large (settles)</source>
        <translation>Grandes (llega al reposo)</translation>
    </message>
    <message>
        <source>A hyperelastic (neo-Hookean) liver of the same stiffness: made for larger strains too. A first picture says how far its landmarks may be from rest, and is brought to rest in the background.</source>
        <translation>Un hígado hiperelástico (neo-hookeano) de la misma rigidez: hecho también para deformaciones unitarias mayores. Una primera imagen dice a qué distancia del reposo pueden estar sus puntos de referencia, y se lleva al reposo en segundo plano.</translation>
    </message>
    <message>
        <source>Use large deformations</source>
        <translation>Usar deformaciones grandes</translation>
    </message>
    <message>
        <source>The tools stay where they are; what was recorded begins anew</source>
        <translation>Los instrumentos se quedan donde están; lo grabado empieza de nuevo</translation>
    </message>
    <message>
        <source>The liver is being prepared for large deformations.</source>
        <translation>Se está preparando el hígado para deformaciones grandes.</translation>
    </message>
    <message>
        <source>Large deformations, as you chose.</source>
        <translation>Deformaciones grandes, como usted eligió.</translation>
    </message>
    <message>
        <source>Large deformations, as you chose: strains reach %1 %, small ones would only extrapolate.</source>
        <translation>Deformaciones grandes, como usted eligió: las deformaciones unitarias llegan al %1 %, las pequeñas solo extrapolarían.</translation>
    </message>
    <message>
        <source>Large deformations, as you chose. Strains reach %1 %: small ones would do.</source>
        <translation>Deformaciones grandes, como usted eligió. Las deformaciones unitarias llegan al %1 %: bastarían las pequeñas.</translation>
    </message>
    <message>
        <source>Small deformations: evidence gave this liver a grain, which large ones do not know.</source>
        <translation>Deformaciones pequeñas: la evidencia dio a este hígado una dirección de fibras, que las grandes no conocen.</translation>
    </message>
    <message>
        <source>Small deformations: made for strains up to 20 %.</source>
        <translation>Deformaciones pequeñas: hechas para deformaciones unitarias de hasta el 20 %.</translation>
    </message>
    <message>
        <source>Small deformations, but strains reach %1 %: beyond 20 % take large ones.</source>
        <translation>Deformaciones pequeñas, pero las deformaciones unitarias llegan al %1 %: más allá del 20 % use las grandes.</translation>
    </message>
    <message>
        <source>Small deformations: enough, since strains reach %1 % only.</source>
        <translation>Deformaciones pequeñas: bastan, pues las deformaciones unitarias llegan solo al %1 %.</translation>
    </message>
    <message>
        <source>Small, meshfree</source>
        <translation>Pequeñas, sin malla</translation>
    </message>
    <message>
        <source>A linear liver by a few hundred meshfree nodes in place of finite elements, under rigid tools. Finite elements answer beside it, so that you see what it costs and what it misses.</source>
        <translation>Un hígado lineal por unos cientos de nodos sin malla en lugar de elementos finitos, bajo instrumentos rígidos. Los elementos finitos responden al lado, para que vea lo que cuesta y lo que se le escapa.</translation>
    </message>
    <message>
        <source>The liver is being prepared for the meshfree engine.</source>
        <translation>El hígado se prepara para el método sin malla.</translation>
    </message>
    <message>
        <source>Meshfree, as you chose. Finite elements will answer beside it.</source>
        <translation>Sin malla, como eligió. Los elementos finitos responderán al lado.</translation>
    </message>
    <message>
        <source>Meshfree, as you chose. Finite elements found no shape under these tools.</source>
        <translation>Sin malla, como eligió. Los elementos finitos no hallaron forma bajo estos instrumentos.</translation>
    </message>
    <message>
        <source>Meshfree, as you chose: %1 ms, finite elements %2 ms. Landmarks are %3 mm apart at most, the surface %4 mm.</source>
        <translation>Sin malla, como eligió: %1 ms, elementos finitos %2 ms. Los puntos de referencia distan %3 mm como mucho, la superficie %4 mm.</translation>
    </message>
    <message>
        <source>Small, in motion</source>
        <translation>Pequeñas, en movimiento</translation>
    </message>
    <message>
        <source>A linear liver that takes its time, under rigid tools: what is let go swings and comes to rest, and tissue that creeps gives way under a held tool and comes back slowly. It is not cut.</source>
        <translation>Un hígado lineal que se toma su tiempo, bajo instrumentos rígidos: lo que se suelta oscila y llega al reposo, y el tejido que fluye cede bajo un instrumento sujeto y vuelve despacio. No se corta.</translation>
    </message>
    <message>
        <source>The liver is being prepared to move.</source>
        <translation>Se está preparando el hígado para moverse.</translation>
    </message>
    <message>
        <source>Its tissue creeps, as evidence showed.</source>
        <translation>Su tejido fluye, como mostraron las pruebas.</translation>
    </message>
    <message>
        <source>Its tissue is elastic: no accepted evidence shows that it creeps.</source>
        <translation>Su tejido es elástico: ninguna prueba aceptada muestra que fluya.</translation>
    </message>
    <message>
        <source>In motion, as you chose.</source>
        <translation>En movimiento, como eligió.</translation>
    </message>
    <message>
        <source>In motion, as you chose: %1 mm/s at most.</source>
        <translation>En movimiento, como eligió: %1 mm/s como mucho.</translation>
    </message>
    <message>
        <source>In motion, as you chose: it has come to rest.</source>
        <translation>En movimiento, como eligió: ha llegado al reposo.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::DiaryWindow</name>
    <message>
        <source>Log - Glisson</source>
        <translation>Registro - Glisson</translation>
    </message>
    <message>
        <source>What Glisson did, in English, for those who mend it. It holds nothing about a patient: no names, no paths, no values. Nothing is sent anywhere; you decide who gets it.</source>
        <translation>Lo que Glisson ha hecho, en inglés, para quienes lo reparan. No contiene nada sobre un paciente: ni nombres, ni rutas, ni valores. No se envía nada a ninguna parte; usted decide quién lo recibe.</translation>
    </message>
    <message>
        <source>The log</source>
        <translation>El registro</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Save a report of the problem...</source>
        <translation>Guardar un informe del problema…</translation>
    </message>
    <message>
        <source>Save a report of the problem</source>
        <translation>Guardar un informe del problema</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Texto (*.txt)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ErrorsTable</name>
    <message>
        <source>%1 × noise</source>
        <translation>%1 × ruido</translation>
    </message>
    <message>
        <source>Error, × noise</source>
        <translation>Error, × ruido</translation>
    </message>
    <message>
        <source>Error, %1</source>
        <translation>Error, %1</translation>
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
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>On trials left out</source>
        <translation>En ensayos apartados</translation>
    </message>
    <message>
        <source>95 % interval of it</source>
        <translation>Intervalo del 95 %</translation>
    </message>
    <message>
        <source>Root mean square</source>
        <translation>Media cuadrática</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>95 of 100 are below</source>
        <translation>95 de cada 100 están por debajo</translation>
    </message>
    <message>
        <source>Noise of the measurement</source>
        <translation>Ruido de la medición</translation>
    </message>
    <message>
        <source>Hidden targets, mean</source>
        <translation>Objetivos ocultos, media</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::EvidenceAnswer</name>
    <message>
        <source>What was found</source>
        <translation>Lo que se encontró</translation>
    </message>
    <message>
        <source>Residual (mm)</source>
        <translation>Residuo (mm)</translation>
    </message>
    <message>
        <source>Measured less predicted, where this trial was farthest off. Arrows %1 times as long as they are; colours reach to %2 mm, between markers interpolated.</source>
        <translation>Medido menos predicho, donde este ensayo más se apartó. Flechas alargadas %1 veces; colores hasta %2 mm, interpolados entre marcadores.</translation>
    </message>
    <message>
        <source>No test finds anything in it that noise would not do.</source>
        <translation>Ninguna prueba encuentra en ello nada que el ruido no haría.</translation>
    </message>
    <message>
        <source>What the declared model leaves is not noise: %1.</source>
        <translation>Lo que deja el modelo declarado no es ruido: %1.</translation>
    </message>
    <message>
        <source>What is left at the end: %1.</source>
        <translation>Lo que queda al final: %1.</translation>
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
        <source>Suspects</source>
        <translation>Sospechosos</translation>
    </message>
    <message>
        <source>What to measure next</source>
        <translation>Qué medir después</translation>
    </message>
    <message>
        <source>No further trial is known that would tell the leading explanations apart.</source>
        <translation>No se conoce otro ensayo que distinga las explicaciones principales.</translation>
    </message>
    <message>
        <source>Trial that is shown</source>
        <translation>Ensayo mostrado</translation>
    </message>
    <message>
        <source>What is left, in space</source>
        <translation>Lo que queda, en el espacio</translation>
    </message>
    <message>
        <source>The error before and after</source>
        <translation>El error antes y después</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalles</translation>
    </message>
    <message>
        <source>The error falls from %1 to %2.</source>
        <translation>El error baja de %1 a %2.</translation>
    </message>
    <message>
        <source>%1 It would tell what is likeliest from: %2.</source>
        <translation>%1 Distinguiría lo más probable de: %2.</translation>
    </message>
    <message>
        <source>%1 Of the doubt %2 % is expected to be gone then.</source>
        <translation>%1 De la duda se espera que entonces haya desaparecido un %2 %.</translation>
    </message>
    <message>
        <source>What these trials could have shown</source>
        <translation>Lo que estos ensayos habrían podido mostrar</translation>
    </message>
    <message>
        <source>Of experiments of this sort no further trial is proposed.</source>
        <translation>Para experimentos de este tipo no se propone ningún otro ensayo.</translation>
    </message>
    <message>
        <source>Nothing is missing: what the declared model leaves, %1, shows no effect.</source>
        <translation>No falta nada: lo que deja el modelo declarado, %1, no muestra ningún efecto.</translation>
    </message>
    <message>
        <source>%1: something acts, but no effect that Glisson knows is probable enough to be named.</source>
        <translation>%1: actúa algo, pero ningún efecto que Glisson conoce es lo bastante probable para nombrarlo.</translation>
    </message>
    <message>
        <source>%1: %2. This takes away %3 % of the error.</source>
        <translation>%1: %2. Esto quita el %3 % del error.</translation>
    </message>
    <message>
        <source>%1: %2 takes away %3 % of the error, but is not probable enough to be called the cause.</source>
        <translation>%1: %2 quita el %3 % del error, pero no es lo bastante probable para llamarlo la causa.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::EvidenceView</name>
    <message>
        <source>Evidence</source>
        <translation>Evidencia</translation>
    </message>
    <message>
        <source>Hold measurements against the model, and find what it lacks.</source>
        <translation>Contrastar mediciones con el modelo y encontrar lo que le falta.</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mediciones</translation>
    </message>
    <message>
        <source>Open an experiment...</source>
        <translation>Abrir un experimento…</translation>
    </message>
    <message>
        <source>A file that says what was measured and which model was assumed (Help, Closing the loop)</source>
        <translation>Un archivo que dice qué se midió y qué modelo se supuso (Ayuda, Cerrar el círculo con mediciones)</translation>
    </message>
    <message>
        <source>Try the example</source>
        <translation>Probar el ejemplo</translation>
    </message>
    <message>
        <source>Open a report...</source>
        <translation>Abrir un informe…</translation>
    </message>
    <message>
        <source>A folder with report.json and model.json, written here or by glisson-cli explain</source>
        <translation>Una carpeta con report.json y model.json, escrita aquí o por glisson-cli explain</translation>
    </message>
    <message>
        <source>For the patient</source>
        <translation>Para el paciente</translation>
    </message>
    <message>
        <source>Accept for this patient</source>
        <translation>Aceptar para este paciente</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>Other trials</source>
        <translation>Otros ensayos</translation>
    </message>
    <message>
        <source>Predict other trials...</source>
        <translation>Predecir otros ensayos…</translation>
    </message>
    <message>
        <source>An experiment of the same kind; where it was measured, both models are compared with it</source>
        <translation>Un experimento del mismo tipo; donde se midió, ambos modelos se comparan con él</translation>
    </message>
    <message>
        <source>Save the report...</source>
        <translation>Guardar el informe…</translation>
    </message>
    <message>
        <source>Explaining %1</source>
        <translation>Explicando %1</translation>
    </message>
    <message>
        <source>Open measurements first.</source>
        <translation>Abra primero mediciones.</translation>
    </message>
    <message>
        <source>Nothing was found missing that could be accepted.</source>
        <translation>No se encontró que faltara nada que pudiera aceptarse.</translation>
    </message>
    <message>
        <source>What was found is of a computer, not of a patient.</source>
        <translation>Lo encontrado es de un ordenador, no de un paciente.</translation>
    </message>
    <message>
        <source>Open the patient&apos;s case first.</source>
        <translation>Abra primero el caso del paciente.</translation>
    </message>
    <message>
        <source>Tick an effect among what was found.</source>
        <translation>Marque un efecto entre lo encontrado.</translation>
    </message>
    <message>
        <source>%1, learnt from %2</source>
        <translation>%1, aprendido de %2</translation>
    </message>
    <message>
        <source>A palpation</source>
        <translation>Una palpación</translation>
    </message>
    <message>
        <source>A material test</source>
        <translation>Un ensayo de material</translation>
    </message>
    <message>
        <source>A wearable computer</source>
        <translation>Un ordenador corporal</translation>
    </message>
    <message>
        <source>Nothing is open.</source>
        <translation>No hay nada abierto.</translation>
    </message>
    <message>
        <source>The ticked effects change the organ that is rehearsed</source>
        <translation>Los efectos marcados cambian el órgano que se ensaya</translation>
    </message>
    <message>
        <source>Nothing was accepted for this patient.</source>
        <translation>No se aceptó nada para este paciente.</translation>
    </message>
    <message>
        <source>The organ is again what it was before</source>
        <translation>El órgano vuelve a ser lo que era</translation>
    </message>
    <message>
        <source>Accepted: %1</source>
        <translation>Aceptado: %1</translation>
    </message>
    <message>
        <source>Accepted, but left out: %1</source>
        <translation>Aceptado, pero omitido: %1</translation>
    </message>
    <message>
        <source>About %1 s left</source>
        <translation>Quedan unos %1 s</translation>
    </message>
    <message>
        <source>About %1 min left</source>
        <translation>Quedan unos %1 min</translation>
    </message>
    <message>
        <source>Accepting the evidence</source>
        <translation>Aceptando la evidencia</translation>
    </message>
    <message>
        <source>Taking the evidence back</source>
        <translation>Retirando la evidencia</translation>
    </message>
    <message>
        <source>Predicting the trials of %1</source>
        <translation>Prediciendo los ensayos de %1</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>no medido</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Ensayo</translation>
    </message>
    <message>
        <source>Declared</source>
        <translation>Declarado</translation>
    </message>
    <message>
        <source>Better</source>
        <translation>Mejor</translation>
    </message>
    <message>
        <source>Root mean square error, %1</source>
        <translation>Error cuadrático medio, %1</translation>
    </message>
    <message>
        <source>Open an experiment</source>
        <translation>Abrir un experimento</translation>
    </message>
    <message>
        <source>Experiments (*.json)</source>
        <translation>Experimentos (*.json)</translation>
    </message>
    <message>
        <source>Open a report (a folder with report.json)</source>
        <translation>Abrir un informe (una carpeta con report.json)</translation>
    </message>
    <message>
        <source>Predict other trials</source>
        <translation>Predecir otros ensayos</translation>
    </message>
    <message>
        <source>Save the report in this folder</source>
        <translation>Guardar el informe en esta carpeta</translation>
    </message>
    <message>
        <source>The report is in %1</source>
        <translation>El informe está en %1</translation>
    </message>
    <message>
        <source>What was found would change nothing in the rehearsal: %1</source>
        <translation>Lo hallado no cambiaría nada en el ensayo: %1</translation>
    </message>
    <message>
        <source>This was measured on &quot;%1&quot;, and nothing shows that it is tissue of %2.</source>
        <translation>Esto se midió en «%1», y nada muestra que sea tejido de %2.</translation>
    </message>
    <message>
        <source>Accept for this patient?</source>
        <translation>¿Aceptar para este paciente?</translation>
    </message>
    <message>
        <source>Specimen: %1
Patient: %2

The organ that is rehearsed changes:
%3</source>
        <translation>Muestra: %1
Paciente: %2

El órgano que se ensaya cambia:
%3</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Aceptar</translation>
    </message>
    <message>
        <source>A sample of tissue, compressed: simulated, and it does something that its file does not declare</source>
        <translation>Una muestra de tejido, comprimida: simulada, y hace algo que su archivo no declara</translation>
    </message>
    <message>
        <source>A guided sequence</source>
        <translation>Una secuencia guiada</translation>
    </message>
    <message>
        <source>What was found is of a plate, not of a patient.</source>
        <translation>Lo hallado es de una placa, no de un paciente.</translation>
    </message>
    <message>
        <source>A plate in full field</source>
        <translation>Una placa en campo completo</translation>
    </message>
    <message>
        <source>What was found is of waves, not of how an organ is held.</source>
        <translation>Lo hallado es de ondas, no de cómo se sujeta un órgano.</translation>
    </message>
    <message>
        <source>Waves of an elastography</source>
        <translation>Ondas de una elastografía</translation>
    </message>
    <message>
        <source>Open measurements of a palpation, a material test, a plate in full field, waves of an elastography, a guided sequence or a wearable computer.
Glisson says how far the declared model is off, what it lacks, and how sure that is.

No measurements at hand? Try the example: a simulated sample of tissue that does something undeclared.</source>
        <translation>Abra mediciones de una palpación, un ensayo de material, una placa de campo completo, las ondas de una elastografía, una secuencia guiada o un ordenador corporal.
Glisson dice cuánto se equivoca el modelo declarado, qué le falta y con qué certeza.

¿No tiene mediciones a mano? Pruebe el ejemplo: una muestra de tejido simulada que hace algo no declarado.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ExportMenu</name>
    <message>
        <source>Images and outlines as NIfTI...</source>
        <translation>Imágenes y contornos como NIfTI...</translation>
    </message>
    <message>
        <source>Images and outlines as NRRD (3D Slicer)...</source>
        <translation>Imágenes y contornos como NRRD (3D Slicer)...</translation>
    </message>
    <message>
        <source>Outlines as DICOM SEG...</source>
        <translation>Contornos como DICOM SEG...</translation>
    </message>
    <message>
        <source>Surfaces as STL...</source>
        <translation>Superficies como STL...</translation>
    </message>
    <message>
        <source>Surfaces as OBJ...</source>
        <translation>Superficies como OBJ...</translation>
    </message>
    <message>
        <source>Surfaces as VTP (ParaView)...</source>
        <translation>Superficies como VTP (ParaView)...</translation>
    </message>
    <message>
        <source>The model&apos;s tetrahedra as VTU...</source>
        <translation>Los tetraedros del modelo como VTU...</translation>
    </message>
    <message>
        <source>Save the outlines</source>
        <translation>Guardar los contornos</translation>
    </message>
    <message>
        <source>DICOM (*.dcm)</source>
        <translation>DICOM (*.dcm)</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Guardar el modelo</translation>
    </message>
    <message>
        <source>VTK meshes (*.vtu)</source>
        <translation>Mallas VTK (*.vtu)</translation>
    </message>
    <message>
        <source>Write the files into this folder</source>
        <translation>Escribir los archivos en esta carpeta</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Exportación</translation>
    </message>
    <message>
        <source>Files written: %1, in %2</source>
        <translation>Archivos escritos: %1, en %2</translation>
    </message>
    <message>
        <source>Outlines, remnant and specimen as DICOM SEG</source>
        <translation>Contornos, remanente y pieza como DICOM SEG</translation>
    </message>
    <message>
        <source>No plan is kept: keep one in Resect</source>
        <translation>No hay ningún plan conservado: conserve uno en Resección</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FiguresTable</name>
    <message>
        <source>Figures of the registrations</source>
        <translation>Cifras de los registros</translation>
    </message>
    <message>
        <source>Mean correlation</source>
        <translation>Correlación media</translation>
    </message>
    <message>
        <source>Rejected (%)</source>
        <translation>Rechazados (%)</translation>
    </message>
    <message>
        <source>TRE (mm)</source>
        <translation>TRE (mm)</translation>
    </message>
    <message>
        <source>TRE, this frame (mm)</source>
        <translation>TRE, este fotograma (mm)</translation>
    </message>
    <message>
        <source>RMSE (mm)</source>
        <translation>RMSE (mm)</translation>
    </message>
    <message>
        <source>RMSE, this frame (mm)</source>
        <translation>RMSE, este fotograma (mm)</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Puntos de referencia</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triángulos</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Tiempo (s)</translation>
    </message>
    <message>
        <source>SIRGn, over the triangles: 1 is best</source>
        <translation>SIRGn, sobre los triángulos: 1 es lo mejor</translation>
    </message>
    <message>
        <source>Share of the triangles whose corners are off by %1 mm or more on average</source>
        <translation>Proporción de triángulos cuyos vértices se desvían en promedio %1 mm o más</translation>
    </message>
    <message>
        <source>Target registration error: how far registered landmarks are from where they are on the model, mm</source>
        <translation>Error de registro del objetivo (TRE): distancia entre los puntos de referencia registrados y su lugar en el modelo, mm</translation>
    </message>
    <message>
        <source>How far the registered cloud is from the model (root mean square), mm</source>
        <translation>Distancia de la nube registrada al modelo (media cuadrática), mm</translation>
    </message>
    <message>
        <source>To register all frames and to judge them, s</source>
        <translation>Para registrar todos los fotogramas y juzgarlos, s</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FoundTree</name>
    <message>
        <source>Effect</source>
        <translation>Efecto</translation>
    </message>
    <message>
        <source>Value ± sd</source>
        <translation>Valor ± desv.</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>● left open by the data</source>
        <translation>● los datos lo dejan abierto</translation>
    </message>
    <message>
        <source>changes nothing in the rehearsal</source>
        <translation>no cambia nada en el ensayo</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FreehandKnife</name>
    <message>
        <source>The last line is still being cut.</source>
        <translation>La última línea todavía se está cortando.</translation>
    </message>
    <message>
        <source>The cut would skim the liver here: turn it until you look onto its surface.</source>
        <translation>El corte solo rozaría el hígado aquí: gírelo hasta mirar su superficie de frente.</translation>
    </message>
    <message>
        <source>The line left the liver: the cut ends at its edge.</source>
        <translation>La línea salió del hígado: el corte termina en su borde.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FromMeasurements</name>
    <message>
        <source>Straight from measurements</source>
        <translation>Directamente de mediciones</translation>
    </message>
    <message>
        <source>The liver lifted at segment VI by what was measured of the tissue, without a law.</source>
        <translation>El hígado levantado en el segmento VI según lo medido en el tejido, sin ley.</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Force of the retractor at segment VI</source>
        <translation>Fuerza del separador en el segmento VI</translation>
    </message>
    <message>
        <source>Strain and stress...</source>
        <translation>Deformación y tensión...</translation>
    </message>
    <message>
        <source>A table with the columns strain and stress_kPa, or a material experiment; compression is negative</source>
        <translation>Una tabla con las columnas strain y stress_kPa, o un experimento de material; la compresión es negativa</translation>
    </message>
    <message>
        <source>Show it in 3D</source>
        <translation>Mostrarlo en 3D</translation>
    </message>
    <message>
        <source>Measured strain and stress</source>
        <translation>Deformación y tensión medidas</translation>
    </message>
    <message>
        <source>Tables and experiments (*.csv *.json)</source>
        <translation>Tablas y experimentos (*.csv *.json)</translation>
    </message>
    <message>
        <source>Retracting by %1</source>
        <translation>Retracción según %1</translation>
    </message>
    <message>
        <source>%1: %2 measurements, %3 N</source>
        <translation>%1: %2 mediciones, %3 N</translation>
    </message>
    <message>
        <source>Lifted by up to %1 mm; by the model&apos;s stiffness %2 mm.</source>
        <translation>Levantado hasta %1 mm; según la rigidez del modelo, %2 mm.</translation>
    </message>
    <message>
        <source>Apart by %1 mm on average, %2 mm at most.</source>
        <translation>Separados %1 mm de media, %2 mm como máximo.</translation>
    </message>
    <message>
        <source>Landmark %1: %2 mm apart, the most of all.</source>
        <translation>Punto de referencia %1: %2 mm de separación, la mayor de todas.</translation>
    </message>
    <message>
        <source>▲ %1 % of the liver is strained farther than was measured.</source>
        <translation>▲ El %1 % del hígado está deformado más allá de lo medido.</translation>
    </message>
    <message>
        <source>From the model&apos;s answer (mm)</source>
        <translation>De la respuesta del modelo (mm)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FromVideo</name>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>What is chosen here stays</source>
        <translation>Lo elegido aquí se queda</translation>
    </message>
    <message>
        <source>Make the sequence</source>
        <translation>Crear la secuencia</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stops, and leaves nothing behind</source>
        <translation>Se detiene y no deja nada</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Making a sequence from the video</source>
        <translation>Creando una secuencia del vídeo</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was left behind.</source>
        <translation>Cancelado. No quedó nada.</translation>
    </message>
    <message>
        <source>It is being computed</source>
        <translation>Se está calculando</translation>
    </message>
    <message>
        <source>Makes clouds and tracks of the frames, and opens them</source>
        <translation>Obtiene de los fotogramas nubes y trayectorias, y las abre</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::GrowthControls</name>
    <message>
        <source>Earlier study...</source>
        <translation>Estudio anterior...</translation>
    </message>
    <message>
        <source>The case of this patient&apos;s earlier study, with its segments: a folder NAME.glisson</source>
        <translation>El caso del estudio anterior de este paciente, con sus segmentos: una carpeta NAME.glisson</translation>
    </message>
    <message>
        <source>They are of one patient</source>
        <translation>Son de un mismo paciente</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segmentar</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ahora</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>kPa</source>
        <translation>kPa</translation>
    </message>
    <message>
        <source>ml without tumours, in the earlier study</source>
        <translation>ml sin tumores, en el estudio anterior</translation>
    </message>
    <message>
        <source>ml without tumours, in the open case</source>
        <translation>ml sin tumores, en el caso abierto</translation>
    </message>
    <message>
        <source>Of what it was; ~: no more than such a volume may be off by</source>
        <translation>De lo que era; ~: no más de lo que puede desviarse un volumen así</translation>
    </message>
    <message>
        <source>Mean stiffness before and now</source>
        <translation>Rigidez media antes y ahora</translation>
    </message>
    <message>
        <source>Remnant of</source>
        <translation>Remanente de</translation>
    </message>
    <message>
        <source>no plan</source>
        <translation>ningún plan</translation>
    </message>
    <message>
        <source>Days between</source>
        <translation>Días entre ambos</translation>
    </message>
    <message>
        <source>0: by the dates of the images. To be typed where these have none</source>
        <translation>0: según las fechas de las imágenes. Hay que escribirlos si no las tienen</translation>
    </message>
    <message>
        <source>Standard volume</source>
        <translation>Volumen estándar</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>The liver&apos;s volume estimated from body size, of which the per cent are in both studies: -794.41 + 1267.28 × body surface in m² (Vauthey et al. 2002). 0: of each study&apos;s own liver</source>
        <translation>El volumen del hígado estimado por el tamaño del cuerpo, del que son los tantos por ciento en ambos estudios: -794.41 + 1267.28 × superficie corporal en m² (Vauthey et al. 2002). 0: del hígado de cada estudio</translation>
    </message>
    <message>
        <source>The case of the earlier study</source>
        <translation>El caso del estudio anterior</translation>
    </message>
    <message>
        <source>Comparing...</source>
        <translation>Comparando...</translation>
    </message>
    <message>
        <source>Remnant</source>
        <translation>Remanente</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Hígado</translation>
    </message>
    <message>
        <source>%1 % of the liver</source>
        <translation>%1 % del hígado</translation>
    </message>
    <message>
        <source>%1 % and %2 % of it were measured.</source>
        <translation>Se midió el %1 % y el %2 %.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::GuidePage</name>
    <message>
        <source>Guide</source>
        <translation>Guiar</translation>
    </message>
    <message>
        <source>See on a laparoscope&apos;s frames where tumours and vessels lie, and how far to trust it.</source>
        <translation>Ver en los fotogramas de un laparoscopio dónde están tumores y vasos, y hasta dónde fiarse.</translation>
    </message>
    <message>
        <source>The liver in space, with what was seen of it</source>
        <translation>El hígado en el espacio, con lo visto de él</translation>
    </message>
    <message>
        <source>Open another...</source>
        <translation>Abrir otra…</translation>
    </message>
    <message>
        <source>Another sequence.json in place of this one</source>
        <translation>Otro sequence.json en lugar de este</translation>
    </message>
    <message>
        <source>Opening the sequence</source>
        <translation>Abriendo la secuencia</translation>
    </message>
    <message>
        <source>Making an example sequence</source>
        <translation>Creando una secuencia de ejemplo</translation>
    </message>
    <message>
        <source>Placing the liver</source>
        <translation>Colocando el hígado</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULADO</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Fotograma %1</translation>
    </message>
    <message>
        <source>dashed: may be off by more than %1 mm</source>
        <translation>discontinuo: puede desviarse más de %1 mm</translation>
    </message>
    <message>
        <source>not placed</source>
        <translation>sin colocar</translation>
    </message>
    <message>
        <source>Writing the video</source>
        <translation>Escribiendo el vídeo</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>Open a sequence</source>
        <translation>Abrir una secuencia</translation>
    </message>
    <message>
        <source>Sequences (*.json)</source>
        <translation>Secuencias (*.json)</translation>
    </message>
    <message>
        <source>Save a video of the frames</source>
        <translation>Guardar un vídeo de los fotogramas</translation>
    </message>
    <message>
        <source>Movies (*.mp4);;Folder of pictures (*)</source>
        <translation>Películas (*.mp4);;Carpeta de imágenes (*)</translation>
    </message>
    <message>
        <source>do not trust here</source>
        <translation>no fiarse aquí</translation>
    </message>
    <message>
        <source>%1: do not trust, ±%2 mm</source>
        <translation>%1: no fiarse, ±%2 mm</translation>
    </message>
    <message>
        <source>%1 ±%2 mm, %3 mm deep</source>
        <translation>%1 ±%2 mm, a %3 mm de profundidad</translation>
    </message>
    <message>
        <source>%1 ±%2 mm</source>
        <translation>%1 ±%2 mm</translation>
    </message>
    <message>
        <source>The sequence names no camera, so that nothing can be drawn over the video.</source>
        <translation>La secuencia no nombra ninguna cámara: no se puede dibujar nada sobre el vídeo.</translation>
    </message>
    <message>
        <source>By hand: nothing is known of the error yet. When it lies about right, press &quot;Refine&quot;.</source>
        <translation>A mano: aún no se sabe nada del error. Cuando esté más o menos en su sitio, pulse «Afinar».</translation>
    </message>
    <message>
        <source>Not placed yet: it is being computed.</source>
        <translation>Aún sin colocar: se está calculando.</translation>
    </message>
    <message>
        <source>Not placed yet: press &quot;Place the liver&quot;.</source>
        <translation>Aún sin colocar: pulse «Colocar el hígado».</translation>
    </message>
    <message>
        <source>Place it by hand, then press &quot;Refine&quot;.</source>
        <translation>Colóquelo a mano y pulse «Afinar».</translation>
    </message>
    <message>
        <source>All outlines lie within %1 mm of the truth, 90 times of 100.</source>
        <translation>Todos los contornos están a %1 mm como mucho de la verdad, 90 veces de 100.</translation>
    </message>
    <message>
        <source>Trust no outline of this frame to %1 mm.</source>
        <translation>No se fíe de ningún contorno de este fotograma a %1 mm.</translation>
    </message>
    <message>
        <source>Not to be trusted everywhere to %1 mm: %2.</source>
        <translation>No fiables en todas partes a %1 mm: %2.</translation>
    </message>
    <message>
        <source>%1 % of the liver&apos;s surface is seen; it is deformed by %2 mm.</source>
        <translation>Se ve el %1 % de la superficie del hígado; está deformado %2 mm.</translation>
    </message>
    <message>
        <source>One moment...</source>
        <translation>Un momento…</translation>
    </message>
    <message>
        <source>%1: %2 frames</source>
        <translation>%1: %2 fotogramas</translation>
    </message>
    <message>
        <source>%1: placed in %2 of %3 frames</source>
        <translation>%1: colocado en %2 de %3 fotogramas</translation>
    </message>
    <message>
        <source>Frame %1 with outlines</source>
        <translation>Fotograma %1 con contornos</translation>
    </message>
    <message>
        <source>From a video...</source>
        <translation>De un vídeo…</translation>
    </message>
    <message>
        <source>Two videos, or one that shows both eyes, become a sequence</source>
        <translation>Dos vídeos, o uno que muestra ambos ojos, se convierten en una secuencia</translation>
    </message>
    <message>
        <source>Nothing was seen of the surface there: an instrument, or a gap. Click beside it.</source>
        <translation>Ahí no se vio nada de la superficie: un instrumento o un hueco. Haga clic al lado.</translation>
    </message>
    <message>
        <source>Click along a line here, and along the same line on the model beside it.</source>
        <translation>Haga clic aquí a lo largo de una línea, y a lo largo de la misma línea en el modelo de al lado.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::GuidePanel</name>
    <message>
        <source>The liver on the frames</source>
        <translation>El hígado en los fotogramas</translation>
    </message>
    <message>
        <source>Place the liver</source>
        <translation>Colocar el hígado</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stops here; frames that are placed already stay</source>
        <translation>Se detiene aquí; lo ya colocado se queda</translation>
    </message>
    <message>
        <source>Place by hand</source>
        <translation>Colocar a mano</translation>
    </message>
    <message>
        <source>Lay the liver over the frame yourself, where it is not found or found wrong</source>
        <translation>Poner usted mismo el hígado sobre el fotograma, donde no se halla o se halla mal</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Afinar</translation>
    </message>
    <message>
        <source>Drag: move. Right drag or Shift: turn. Wheel: nearer, farther. Ctrl and wheel: turn in the picture. Arrow keys, + and - do the same in steps.</source>
        <translation>Arrastrar: mover. Botón derecho o Mayús: girar. Rueda: más cerca, más lejos. Ctrl y rueda: girar en la imagen. Las flechas, + y - hacen lo mismo por pasos.</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Contornos</translation>
    </message>
    <message>
        <source>Shows or hides what is drawn over the frame (O)</source>
        <translation>Muestra u oculta lo dibujado sobre el fotograma (O)</translation>
    </message>
    <message>
        <source>Opacity of the outlines</source>
        <translation>Opacidad de los contornos</translation>
    </message>
    <message>
        <source>How strong the outlines stand on the frame</source>
        <translation>La intensidad de los contornos sobre el fotograma</translation>
    </message>
    <message>
        <source>Trusted up to an error of</source>
        <translation>Fiable hasta un error de</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Outlines are dashed where 90 % of such places would be off by more than %1 mm</source>
        <translation>Discontinuo donde hacen falta más de %1 mm para contener el 90 % de tales puntos</translation>
    </message>
    <message>
        <source>It is being computed</source>
        <translation>Se está calculando</translation>
    </message>
    <message>
        <source>The sequence names no camera, so that nothing can be drawn over the video.</source>
        <translation>La secuencia no nombra ninguna cámara: no se puede dibujar nada sobre el vídeo.</translation>
    </message>
    <message>
        <source>Finds where the liver lies in the first frame, without a guess or by the lines that are marked, and follows it from frame to frame</source>
        <translation>Halla dónde está el hígado en el primer fotograma, sin indicación o por las líneas marcadas, y lo sigue de uno a otro</translation>
    </message>
    <message>
        <source>Place the liver by hand first</source>
        <translation>Coloque antes el hígado a mano</translation>
    </message>
    <message>
        <source>Fits the liver from where you laid it, and follows it from there</source>
        <translation>Ajusta el hígado desde donde usted lo puso y lo sigue desde ahí</translation>
    </message>
    <message>
        <source>Save a video...</source>
        <translation>Guardar un vídeo...</translation>
    </message>
    <message>
        <source>Place the liver first</source>
        <translation>Coloque antes el hígado</translation>
    </message>
    <message>
        <source>All frames with their outlines as they are shown now, MP4 or pictures</source>
        <translation>Todos los fotogramas con sus contornos tal como se ven, MP4 o imágenes</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::GuideWelcome</name>
    <message>
        <source>Where is the tumour in this picture?</source>
        <translation>¿Dónde está el tumor en esta imagen?</translation>
    </message>
    <message>
        <source>Open a sequence...</source>
        <translation>Abrir una secuencia…</translation>
    </message>
    <message>
        <source>Open the example</source>
        <translation>Abrir el ejemplo</translation>
    </message>
    <message>
        <source>A sequence.json with its clouds, tracks and pictures beside it</source>
        <translation>Un sequence.json con sus nubes, trayectorias e imágenes al lado</translation>
    </message>
    <message>
        <source>40 simulated frames, made in a few seconds the first time; 7 MB</source>
        <translation>40 fotogramas simulados, hechos en unos segundos la primera vez; 7 MB</translation>
    </message>
    <message>
        <source>The liver of the open case is placed on a laparoscope&apos;s frames and follows them; its tumours and vessels are drawn where they are, with how far they may be off. Begin with the video of a stereo laparoscope and its calibration, or pictures of a board; or open a sequence that was made of one. The example is simulated and shows the demo patient&apos;s liver.</source>
        <translation>El hígado del caso abierto se coloca en los fotogramas de un laparoscopio y los sigue; sus tumores y vasos se dibujan donde están, con cuánto pueden desviarse. Empiece con el vídeo de un laparoscopio estéreo y su calibración, o imágenes de un tablero; o abra una secuencia hecha de uno. El ejemplo es simulado y muestra el hígado del paciente de demostración.</translation>
    </message>
    <message>
        <source>From a video...</source>
        <translation>De un vídeo…</translation>
    </message>
    <message>
        <source>Two videos, or one that shows both eyes, become a sequence</source>
        <translation>Dos vídeos, o uno que muestra ambos ojos, se convierten en una secuencia</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::KeptOrders</name>
    <message>
        <source>Comparing orders of steps</source>
        <translation>Comparando órdenes de pasos</translation>
    </message>
    <message>
        <source>Order %1</source>
        <translation>Orden %1</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pasos</translation>
    </message>
    <message>
        <source>Name of the order</source>
        <translation>Nombre del orden</translation>
    </message>
    <message>
        <source>Keep these steps</source>
        <translation>Conservar estos pasos</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Runs each order again from the liver at rest; the report shows what comes of it</source>
        <translation>Repite cada orden desde el hígado en reposo; el informe muestra el resultado</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Takes the order that is marked out of the case</source>
        <translation>Saca del caso el orden marcado</translation>
    </message>
    <message>
        <source>Keeps all that the tools did, and the cut, in this order</source>
        <translation>Conserva todo lo que hicieron los instrumentos, y el corte, en este orden</translation>
    </message>
    <message>
        <source>Kept since: compare again.</source>
        <translation>Se conservó otro después: compare de nuevo.</translation>
    </message>
    <message>
        <source>Steps that could not be carried out, or are not to be used: %1</source>
        <translation>Pasos que no pudieron ejecutarse o no deben usarse: %1</translation>
    </message>
    <message>
        <source>How far the landmark goes that moves most; 5 mm or more is marked !</source>
        <translation>Hasta dónde llega el punto de referencia que más se mueve; desde 5 mm se marca con !</translation>
    </message>
    <message>
        <source>The largest force of any one tool</source>
        <translation>La mayor fuerza de un solo instrumento</translation>
    </message>
    <message>
        <source>The largest strain</source>
        <translation>La mayor deformación</translation>
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
        <translation>Se guardan pasos de instrumentos rígidos y de grandes deformaciones, con elementos finitos</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LabelNamesDialog</name>
    <message>
        <source>What the labels are</source>
        <translation>Qué son las etiquetas</translation>
    </message>
    <message>
        <source>%1 does not say what its values are. Choose a structure for each that you want.</source>
        <translation>%1 no dice qué son sus valores. Elija una estructura para cada uno de los que quiera.</translation>
    </message>
    <message>
        <source>%1: %2 ml</source>
        <translation>%1: %2 ml</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Omitir</translation>
    </message>
    <message>
        <source>Take them</source>
        <translation>Tomarlas</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LandmarkTable</name>
    <message>
        <source>Landmark</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Moves
mm</source>
        <translation>Despl.
mm</translation>
    </message>
    <message>
        <source>Atlas off
mm</source>
        <translation>Error
atlas
mm</translation>
    </message>
    <message>
        <source>From 5 mm</source>
        <translation>Desde
5 mm</translation>
    </message>
    <message>
        <source>How far from there the atlas&apos;s stiffness puts it</source>
        <translation>A qué distancia de ahí lo sitúa la rigidez del atlas</translation>
    </message>
    <message>
        <source>5 mm and more matters to a surgeon</source>
        <translation>5 mm o más son importantes para un cirujano</translation>
    </message>
    <message>
        <source>▲ Atlas off</source>
        <translation>▲ Atlas falla</translation>
    </message>
    <message>
        <source>● Moves</source>
        <translation>● Se mueve</translation>
    </message>
    <message>
        <source>How far the landmark moves from where the scan shows it</source>
        <translation>Cuánto se aleja el punto de referencia de donde lo muestra la exploración</translation>
    </message>
    <message>
        <source>%1: set by hand. A double click renames it.</source>
        <translation>%1: colocado a mano. Un doble clic lo renombra.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LanguageMenu</name>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>System language</source>
        <translation>Idioma del sistema</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LinePanel</name>
    <message>
        <source>Mark a ridge or a ligament on the frame and on the model: where the shape alone does not tell how the liver lies, the line does</source>
        <translation>Marque un borde o un ligamento en el fotograma y en el modelo: donde la forma sola no dice cómo está el hígado, lo dice la línea</translation>
    </message>
    <message>
        <source>Mark lines</source>
        <translation>Marcar líneas</translation>
    </message>
    <message>
        <source>Falciform ligament</source>
        <translation>Ligamento falciforme</translation>
    </message>
    <message>
        <source>Lower edge</source>
        <translation>Borde inferior</translation>
    </message>
    <message>
        <source>Gall bladder&apos;s border</source>
        <translation>Borde de la vesícula</translation>
    </message>
    <message>
        <source>Another line</source>
        <translation>Otra línea</translation>
    </message>
    <message>
        <source>The line that is marked</source>
        <translation>La línea que se marca</translation>
    </message>
    <message>
        <source>Which line the next clicks are of</source>
        <translation>A qué línea pertenecen los próximos clics</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Takes this line away, from the model and from all frames</source>
        <translation>Quita esta línea del modelo y de todos los fotogramas</translation>
    </message>
    <message>
        <source>Places on this frame: %1, on the model: %2.</source>
        <translation>Puntos en este fotograma: %1, en el modelo: %2.</translation>
    </message>
    <message>
        <source>It counts when the liver is placed.</source>
        <translation>Cuenta cuando se coloca el hígado.</translation>
    </message>
    <message>
        <source>It counts from two on each.</source>
        <translation>Cuenta a partir de dos en cada lado.</translation>
    </message>
    <message>
        <source>Click along the line on the frame, and along the same line on the model. The two need not begin or end at the same place. Undo takes a click back.</source>
        <translation>Haga clic a lo largo de la línea en el fotograma, y a lo largo de la misma línea en el modelo. No hace falta que empiecen ni acaben en el mismo punto. Deshacer retira un clic.</translation>
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
        <translation>Paciente</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
    <message>
        <source>Drag: turn. Shift+drag: shift. Wheel: zoom. Click: crosshair there.</source>
        <translation>Arrastrar: girar. Mayús+arrastrar: desplazar. Rueda: zoom. Clic: cruz en ese lugar.</translation>
    </message>
    <message>
        <source>Surgeon</source>
        <translation>Cirujano</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Delante</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Debajo</translation>
    </message>
    <message>
        <source>Look from here, everything in view</source>
        <translation>Mirar desde aquí, con todo a la vista</translation>
    </message>
    <message>
        <source>Atlas</source>
        <translation>Atlas</translation>
    </message>
    <message>
        <source>Click: crosshair. Right drag: brightness and contrast. Wheel: next slice.
Ctrl+wheel: zoom. Shift+drag: shift. Ctrl+drag: turn. Knobs of the crosshair: tilt the other slices.</source>
        <translation>Clic: cruz. Arrastrar con el derecho: brillo y contraste. Rueda: corte siguiente.
Ctrl+rueda: zoom. Mayús+arrastrar: desplazar. Ctrl+arrastrar: girar. Tiradores de la cruz: inclinar los otros cortes.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Guardar la imagen</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>The scan itself as a soft backdrop: bones and bright vessels behind the organ</source>
        <translation>La propia imagen como fondo suave: huesos y vasos brillantes detrás del órgano</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::MainWindow</name>
    <message>
        <source>Opening %1</source>
        <translation>Abriendo %1</translation>
    </message>
    <message>
        <source>Opening the demo patient</source>
        <translation>Abriendo el paciente de demostración</translation>
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
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Open a case...</source>
        <translation>&amp;Abrir un caso…</translation>
    </message>
    <message>
        <source>Open the &amp;demo patient</source>
        <translation>Abrir el paciente de &amp;demostración</translation>
    </message>
    <message>
        <source>&amp;Save the picture...</source>
        <translation>&amp;Guardar la imagen…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>&amp;About Glisson</source>
        <translation>&amp;Acerca de Glisson</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>A defect in Glisson stopped this: %1</source>
        <translation>Un defecto de Glisson ha interrumpido esto: %1</translation>
    </message>
    <message>
        <source>Open a case (a folder NAME.glisson)</source>
        <translation>Abrir un caso (una carpeta NOMBRE.glisson)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Guardar la imagen</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>The picture could not be written to %1.</source>
        <translation>No se ha podido escribir la imagen en %1.</translation>
    </message>
    <message>
        <source>About Glisson</source>
        <translation>Acerca de Glisson</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Glisson %1&lt;/h3&gt;&lt;p&gt;Planning and reviewing liver surgery.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Not a medical device.&lt;/b&gt; Not for diagnosis or treatment.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Glisson %1&lt;/h3&gt;&lt;p&gt;Planificación y revisión de la cirugía hepática.&lt;/p&gt;&lt;p&gt;&lt;b&gt;No es un producto sanitario.&lt;/b&gt; No apto para diagnóstico ni tratamiento.&lt;/p&gt;&lt;p&gt;Software libre bajo la Licencia Pública General de GNU, versión 3 o posterior.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Something else is still under way. Wait for it, or cancel it first.</source>
        <translation>Hay otra operación en curso. Espere a que termine o cancélela antes.</translation>
    </message>
    <message>
        <source>Outlining the liver</source>
        <translation>Delimitando el hígado</translation>
    </message>
    <message>
        <source>Building the model</source>
        <translation>Construyendo el modelo</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Cancelado.</translation>
    </message>
    <message>
        <source>Elastography &amp;waves...</source>
        <translation>&amp;Ondas de elastografía…</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manual</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>&amp;Ir</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abiertos &amp;recientemente</translation>
    </message>
    <message>
        <source>Se&amp;ttings...</source>
        <translation>&amp;Ajustes…</translation>
    </message>
    <message>
        <source>&amp;Keys...</source>
        <translation>&amp;Teclas…</translation>
    </message>
    <message>
        <source>&amp;Log and problems...</source>
        <translation>&amp;Registro y problemas…</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Ninguno todavía</translation>
    </message>
    <message>
        <source>Forget them</source>
        <translation>Vaciar la lista</translation>
    </message>
    <message>
        <source>&amp;Tour on the demo patient</source>
        <translation>&amp;Recorrido con el paciente de demostración</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>Open &amp;images...</source>
        <translation>Abrir &amp;imágenes...</translation>
    </message>
    <message>
        <source>&amp;Add labels...</source>
        <translation>&amp;Añadir etiquetas...</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportar</translation>
    </message>
    <message>
        <source>&amp;Close the case</source>
        <translation>&amp;Cerrar el caso</translation>
    </message>
    <message>
        <source>Open images: a folder, or a file of them</source>
        <translation>Abrir imágenes: una carpeta o uno de sus archivos</translation>
    </message>
    <message>
        <source>Add labels</source>
        <translation>Añadir etiquetas</translation>
    </message>
    <message>
        <source>Label maps and DICOM SEG (*.nii *.nii.gz *.nrrd *.mha *.mhd *.nhdr *.dcm);;All files (*)</source>
        <translation>Mapas de etiquetas y DICOM SEG (*.nii *.nii.gz *.nrrd *.mha *.mhd *.nhdr *.dcm);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>%1 is still under way. If you close now, it is given up, and the case stays as it was.</source>
        <translation>%1 sigue en curso. Si cierra ahora, se abandona y el caso queda como estaba.</translation>
    </message>
    <message>
        <source>Keep working</source>
        <translation>Seguir</translation>
    </message>
    <message>
        <source>Give it up and close</source>
        <translation>Abandonar y cerrar</translation>
    </message>
    <message>
        <source>&amp;Diary of the case...</source>
        <translation>&amp;Diario del caso...</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ManualWindow</name>
    <message>
        <source>Manual - Glisson</source>
        <translation>Manual - Glisson</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Buscar en el manual</translation>
    </message>
    <message>
        <source>Words to search for</source>
        <translation>Palabras que buscar</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Páginas del manual</translation>
    </message>
    <message>
        <source>The page</source>
        <translation>La página</translation>
    </message>
    <message>
        <source>The manual was not found among the files that ship with Glisson.</source>
        <translation>No se ha encontrado el manual entre los archivos que acompañan a Glisson.</translation>
    </message>
    <message>
        <source>No page holds these words.</source>
        <translation>Ninguna página contiene estas palabras.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::MeasureList</name>
    <message>
        <source>Measurements</source>
        <translation>Medidas</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Bola</translation>
    </message>
    <message>
        <source>Volume: %1</source>
        <translation>Volumen: %1</translation>
    </message>
    <message>
        <source>Takes this measurement away</source>
        <translation>Quita esta medida</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ModelPanel</name>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Bring it up to date</source>
        <translation>Actualizarlo</translation>
    </message>
    <message>
        <source>Cells, stiffness and supports of the liver, and building them anew.</source>
        <translation>Celdas, rigidez y apoyos del hígado, y cómo construirlos de nuevo.</translation>
    </message>
    <message>
        <source>Needs an outline of the liver: make it in Segment.</source>
        <translation>Necesita un contorno del hígado: hágalo en Segmentar.</translation>
    </message>
    <message>
        <source>The 3D view shows</source>
        <translation>La vista 3D muestra</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidez</translation>
    </message>
    <message>
        <source>The patient</source>
        <translation>El paciente</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Celdas</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Módulo de Young</translation>
    </message>
    <message>
        <source>From MR elastography</source>
        <translation>De la elastografía por RM</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation> kPa</translation>
    </message>
    <message>
        <source>Young&apos;s modulus, about three times the shear modulus</source>
        <translation>Módulo de Young, unas tres veces el módulo de cizalla</translation>
    </message>
    <message>
        <source>Give it this stiffness</source>
        <translation>Darle esta rigidez</translation>
    </message>
    <message>
        <source>Elastography waves...</source>
        <translation>Ondas de elastografía…</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Construir</translation>
    </message>
    <message>
        <source> cells</source>
        <translation> celdas</translation>
    </message>
    <message>
        <source>Wanted number of cells: more are finer and slower. 20 000 answer at once.</source>
        <translation>Número de celdas deseado: más son más finas y lentas. 20 000 responden al instante.</translation>
    </message>
    <message>
        <source>Building the model</source>
        <translation>Construyendo el modelo</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Abriendo %1</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Sujeto</translation>
    </message>
    <message>
        <source>On springs</source>
        <translation>Sobre muelles</translation>
    </message>
    <message>
        <source>Young&apos;s modulus (kPa)</source>
        <translation>Módulo de Young (kPa)</translation>
    </message>
    <message>
        <source>Needs a case: open one, or the demo patient.</source>
        <translation>Necesita un caso: abra uno o el paciente de demostración.</translation>
    </message>
    <message>
        <source>There is no model yet. Build it from the outline.</source>
        <translation>Aún no hay modelo. Constrúyalo a partir del contorno.</translation>
    </message>
    <message>
        <source>✓ The model is up to date.</source>
        <translation>✓ El modelo está al día.</translation>
    </message>
    <message>
        <source>▲ A file of the model is gone.</source>
        <translation>▲ Falta un archivo del modelo.</translation>
    </message>
    <message>
        <source>▲ Another program has changed a file of the model.</source>
        <translation>▲ Otro programa ha cambiado un archivo del modelo.</translation>
    </message>
    <message>
        <source>▲ The model is out of date.</source>
        <translation>▲ El modelo está desactualizado.</translation>
    </message>
    <message>
        <source>▲ Out of date: %1 changed since it was built.</source>
        <translation>▲ Desactualizado: %1 cambió desde que se construyó.</translation>
    </message>
    <message>
        <source>Build it anew</source>
        <translation>Construirlo de nuevo</translation>
    </message>
    <message>
        <source>Build the model</source>
        <translation>Construir el modelo</translation>
    </message>
    <message>
        <source>This case has no stiffness map: import one, or invert its waves</source>
        <translation>Este caso no tiene mapa de rigidez: importe uno o invierta sus ondas</translation>
    </message>
    <message>
        <source>Keeps the cells and gives each this stiffness</source>
        <translation>Conserva las celdas y da a cada una esta rigidez</translation>
    </message>
    <message>
        <source>Needs cells: build the model first</source>
        <translation>Necesita celdas: construya primero el modelo</translation>
    </message>
    <message>
        <source>Makes the cells anew and gives them the stiffness chosen above</source>
        <translation>Rehace las celdas y les da la rigidez elegida arriba</translation>
    </message>
    <message>
        <source>See the waves and invert them</source>
        <translation>Ver las ondas e invertirlas</translation>
    </message>
    <message>
        <source>This case has no raw waves</source>
        <translation>Este caso no tiene ondas sin procesar</translation>
    </message>
    <message>
        <source>Assumed from the liver&apos;s shape: the bare area at the vena cava is held, the dome below the diaphragm rests on springs of 1.1 kPa/mm.</source>
        <translation>Supuesto por la forma del hígado: el área desnuda junto a la vena cava está sujeta, la cúpula bajo el diafragma descansa sobre muelles de 1.1 kPa/mm.</translation>
    </message>
    <message>
        <source>%1 cells, %2 points</source>
        <translation>%1 celdas, %2 puntos</translation>
    </message>
    <message>
        <source>Smallest dihedral angle %1°</source>
        <translation>Menor ángulo diedro %1°</translation>
    </message>
    <message>
        <source>smallest dihedral angle of a cell, °</source>
        <translation>menor ángulo diedro de una celda, °</translation>
    </message>
    <message>
        <source>%1 kPa on average, sd %2</source>
        <translation>%1 kPa de media, desviación típica %2</translation>
    </message>
    <message>
        <source>%1 % of the cells without data of their own, filled from inside</source>
        <translation>%1 % de las celdas sin datos propios, rellenadas desde el interior</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of a cell, kPa</source>
        <translation>módulo de Young de una celda, kPa</translation>
    </message>
    <message>
        <source>Assumed: the atlas&apos;s 2.1 kPa in shear</source>
        <translation>Supuesto: los 2.1 kPa (cizalla) del atlas</translation>
    </message>
    <message>
        <source>Assumed: the atlas&apos;s 2.6 kPa in shear</source>
        <translation>Supuesto: los 2.6 kPa (cizalla) del atlas</translation>
    </message>
    <message>
        <source>Assumed: one value for all cells</source>
        <translation>Supuesto: un valor para todas las celdas</translation>
    </message>
    <message>
        <source>%1 ml outlined; the cells hold %2 % of it</source>
        <translation>%1 ml de contorno; las celdas llenan el %2 %</translation>
    </message>
    <message>
        <source>Assumed: %1 kPa for all cells</source>
        <translation>Supuesto: %1 kPa para todas las celdas</translation>
    </message>
    <message>
        <source>Attachments</source>
        <translation>Fijaciones</translation>
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
        <translation>no en reposo: puntos de referencia a %1 mm</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::NextStepBox</name>
    <message>
        <source>Next: put the crosshair inside the liver, away from large vessels.</source>
        <translation>A continuación: coloque la cruz dentro del hígado, lejos de los vasos grandes.</translation>
    </message>
    <message>
        <source>Next: build the model of the liver from its outline and stiffness.</source>
        <translation>A continuación: construya el modelo del hígado a partir de su contorno y su rigidez.</translation>
    </message>
    <message>
        <source>Outline the liver from here</source>
        <translation>Delimitar el hígado desde aquí</translation>
    </message>
    <message>
        <source>Build the model</source>
        <translation>Construir el modelo</translation>
    </message>
    <message>
        <source>Its elastography has not been inverted: until then the stiffness is assumed.</source>
        <translation>Su elastografía no se ha invertido: hasta entonces la rigidez es supuesta.</translation>
    </message>
    <message>
        <source>Elastography waves...</source>
        <translation>Ondas de elastografía…</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::Notices</name>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::NumberBox</name>
    <message>
        <source>At most %1.</source>
        <translation>Como máximo %1.</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <translation>Como mínimo %1.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PathRow</name>
    <message>
        <source>Choose...</source>
        <translation>Elegir...</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>Carpetas (*)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PatientViews</name>
    <message>
        <source>Displacement (mm)</source>
        <translation>Desplazamiento (mm)</translation>
    </message>
    <message>
        <source>Red: one stiffness from the atlas</source>
        <translation>Rojo: una sola rigidez, del atlas</translation>
    </message>
    <message>
        <source>Blue: the patient&apos;s own stiffness</source>
        <translation>Azul: la rigidez propia del paciente</translation>
    </message>
    <message>
        <source>Purple: both agree</source>
        <translation>Violeta: ambas coinciden</translation>
    </message>
    <message>
        <source>Shear stiffness (kPa)</source>
        <translation>Rigidez a cizalla (kPa)</translation>
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
        <translation>La rigidez propia del paciente</translation>
    </message>
    <message>
        <source>One stiffness from the atlas</source>
        <translation>Una sola rigidez, la del atlas</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PlanByAnatomy</name>
    <message>
        <source>Segments and tumours</source>
        <translation>Segmentos y tumores</translation>
    </message>
    <message>
        <source>Find segments</source>
        <translation>Hallar los segmentos</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segmento</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>Stays, ml</source>
        <translation>Queda, ml</translation>
    </message>
    <message>
        <source>kPa</source>
        <translation>kPa</translation>
    </message>
    <message>
        <source>Mean stiffness (Young&apos;s modulus) of the tissue that was measured; faint under half of it</source>
        <translation>Rigidez media (módulo de Young) del tejido medido; tenue por debajo de la mitad</translation>
    </message>
    <message>
        <source>Show segments</source>
        <translation>Mostrar los segmentos</translation>
    </message>
    <message>
        <source>Take these segments</source>
        <translation>Tomar estos segmentos</translation>
    </message>
    <message>
        <source>Removes the segments that are ticked</source>
        <translation>Extirpa los segmentos marcados</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Around this tumour</source>
        <translation>Alrededor de este tumor</translation>
    </message>
    <message>
        <source>Removes the tumour with all tissue up to this margin</source>
        <translation>Extirpa el tumor con todo el tejido hasta este margen</translation>
    </message>
    <message>
        <source>Branches cut</source>
        <translation>Ramas seccionadas</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Rama</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Diameter where it is cut</source>
        <translation>Diámetro donde se secciona</translation>
    </message>
    <message>
        <source>What of that stays in the patient without it</source>
        <translation>Lo que de ello queda en el paciente sin ella</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Queda</translation>
    </message>
    <message>
        <source>Keeps it in the case under this name, beside the others</source>
        <translation>Lo conserva en el caso con este nombre, junto a los demás</translation>
    </message>
    <message>
        <source>Finding vessels and segments</source>
        <translation>Hallando vasos y segmentos</translation>
    </message>
    <message>
        <source>Looking at the liver&apos;s anatomy...</source>
        <translation>Examinando la anatomía del hígado…</translation>
    </message>
    <message>
        <source>By the liver&apos;s shape alone: it has no vessel trees.</source>
        <translation>Según la forma del hígado sola: no hay árboles vasculares.</translation>
    </message>
    <message>
        <source>%1 % of the segment was measured.</source>
        <translation>Se midió el %1 % del segmento.</translation>
    </message>
    <message>
        <source>%1 % of the liver without tumours stay.</source>
        <translation>Queda el %1 % del hígado sin tumores.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 ml&lt;/b&gt; removed, &lt;b&gt;%2 ml&lt;/b&gt; stay: %3 % of the liver without tumours.</source>
        <translation>&lt;b&gt;%1 ml&lt;/b&gt; extirpados, &lt;b&gt;%2 ml&lt;/b&gt; permanecen: %3 % del hígado sin tumores.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 ml&lt;/b&gt; of it stay alive, perfused and drained (%2 %); without inflow %3 ml, without outflow %4 ml.</source>
        <translation>&lt;b&gt;%1 ml&lt;/b&gt; de ello siguen vivos, perfundidos y drenados (%2 %); sin aporte %3 ml, sin drenaje %4 ml.</translation>
    </message>
    <message>
        <source>Smallest margin: at least %1 mm.</source>
        <translation>Menor margen: al menos %1 mm.</translation>
    </message>
    <message>
        <source>Smallest margin: %1 mm.</source>
        <translation>Menor margen: %1 mm.</translation>
    </message>
    <message>
        <source>▲ %1 stays in the patient.</source>
        <translation>▲ %1 queda en el paciente.</translation>
    </message>
    <message>
        <source>▲ %1 is cut through.</source>
        <translation>▲ %1 queda seccionado.</translation>
    </message>
    <message>
        <source>What stays has %1 kPa; %2 % of it was measured.</source>
        <translation>Lo que queda tiene %1 kPa; se midió el %2 %.</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Extirpado</translation>
    </message>
    <message>
        <source>%1 is kept. Rehearse, Guide and the report follow it.</source>
        <translation>%1 está conservado. Ensayar, Guiar y el informe lo siguen.</translation>
    </message>
    <message>
        <source>%1 is kept.</source>
        <translation>%1 está conservado.</translation>
    </message>
    <message>
        <source>This patient is not kept in a case folder</source>
        <translation>Este paciente no se guarda en una carpeta de caso</translation>
    </message>
    <message>
        <source>Needs a cut through the liver</source>
        <translation>Necesita una sección a través del hígado</translation>
    </message>
    <message>
        <source>Keeps the cut on the liver held aside, for the report; the table is of plans at rest</source>
        <translation>Conserva la sección en el hígado apartado, para el informe; la tabla es de planes en reposo</translation>
    </message>
    <message>
        <source>Keeps it in the case under this name, beside the others; Rehearse, Guide and the report then follow it</source>
        <translation>Lo conserva en el caso con este nombre, junto a los otros; Ensayar, Guiar y el informe lo siguen entonces</translation>
    </message>
    <message>
        <source>The cut unrolled flat</source>
        <translation>La sección desplegada en plano</translation>
    </message>
    <message>
        <source>%1 (%2 ml)</source>
        <translation>%1 (%2 ml)</translation>
    </message>
    <message>
        <source>%1 ml of what goes are ablated.</source>
        <translation>%1 ml de lo que se quita se ablacionan.</translation>
    </message>
    <message>
        <source>No tumour is outlined: the map shows the vessels alone.</source>
        <translation>Ningún tumor está delimitado: el mapa muestra solo los vasos.</translation>
    </message>
    <message>
        <source>No tumour within %1 mm of the cut.</source>
        <translation>Ningún tumor a menos de %1 mm de la sección.</translation>
    </message>
    <message>
        <source>▲ The cut goes through a tumour.</source>
        <translation>▲ La sección atraviesa un tumor.</translation>
    </message>
    <message>
        <source>At the nearest the cut is %1 mm from a tumour.</source>
        <translation>En su punto más próximo, la sección queda a %1 mm de un tumor.</translation>
    </message>
    <message>
        <source>Along this territory</source>
        <translation>Por este territorio</translation>
    </message>
    <message>
        <source>Removes all that this branch feeds or drains, with what grows from it. Proposed: the smallest portal territory that holds the tumour above</source>
        <translation>Extirpa todo lo que esta rama irriga o drena, con lo que crece de ella. Propuesto: el menor territorio portal que contiene el tumor de arriba</translation>
    </message>
    <message>
        <source>Ablation</source>
        <translation>Ablación</translation>
    </message>
    <message>
        <source>%1 with %2 mm around it needs a zone %3 mm wide; %4 mm is the widest. Set several.</source>
        <translation>%1 con %2 mm alrededor necesita una zona de %3 mm de ancho; %4 mm es la más ancha. Ponga varias.</translation>
    </message>
    <message>
        <source>✕ gives it back</source>
        <translation>✕ lo devuelve</translation>
    </message>
    <message>
        <source>Segments: %1</source>
        <translation>Segmentos: %1</translation>
    </message>
    <message>
        <source>Territory: %1</source>
        <translation>Territorio: %1</translation>
    </message>
    <message>
        <source>%1 with %2 mm around it</source>
        <translation>%1 con %2 mm alrededor</translation>
    </message>
    <message>
        <source>Ablation, %1 × %2 mm</source>
        <translation>Ablación, %1 × %2 mm</translation>
    </message>
    <message>
        <source>Two stages</source>
        <translation>Dos tiempos</translation>
    </message>
    <message>
        <source>Growth since an earlier study</source>
        <translation>Crecimiento desde un estudio anterior</translation>
    </message>
    <message>
        <source>By the liver&apos;s shape and borders set by hand: it has no vessel trees.</source>
        <translation>Según la forma del hígado y límites puestos a mano: no tiene árboles vasculares.</translation>
    </message>
    <message>
        <source>By the portal and hepatic veins where both are outlined, else by the liver&apos;s shape alone. Arteries and bile ducts that are outlined get trees too</source>
        <translation>Según la vena porta y las venas hepáticas donde ambas están delimitadas, si no según la forma del hígado sola. Las arterias y los conductos biliares delimitados reciben también árboles</translation>
    </message>
    <message>
        <source>Beyond</source>
        <translation>Más allá</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Queda</translation>
    </message>
    <message>
        <source>All tissue that it feeds or drains beyond the cut; of an artery or a bile duct its own length</source>
        <translation>Todo el tejido que irriga o drena más allá de la sección; de una arteria o un conducto biliar, su propia longitud</translation>
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
        <translation>Planes</translation>
    </message>
    <message>
        <source>as they were kept</source>
        <translation>como se conservaron</translation>
    </message>
    <message>
        <source>widest margin first</source>
        <translation>mayor margen primero</translation>
    </message>
    <message>
        <source>most tissue alive first</source>
        <translation>más tejido vivo primero</translation>
    </message>
    <message>
        <source>least tissue cut off first</source>
        <translation>menos tejido cortado primero</translation>
    </message>
    <message>
        <source>Plans that leave a tumour, or cut through one, come after those that do not</source>
        <translation>Los planes que dejan un tumor, o lo atraviesan, van después de los demás</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Queda</translation>
    </message>
    <message>
        <source>Alive</source>
        <translation>Vivo</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortes</translation>
    </message>
    <message>
        <source>Of the liver without its tumours</source>
        <translation>Del hígado sin sus tumores</translation>
    </message>
    <message>
        <source>What stays perfused and drained, of the same</source>
        <translation>Lo que queda perfundido y drenado, igualmente</translation>
    </message>
    <message>
        <source>Branches that are cut</source>
        <translation>Ramas que se seccionan</translation>
    </message>
    <message>
        <source>A ring: another plan is no worse in margin, living tissue and tumours, and better in one.</source>
        <translation>Un anillo: otro plan no es peor en margen, tejido vivo y tumores, y es mejor en uno.</translation>
    </message>
    <message>
        <source>Name of the plan</source>
        <translation>Nombre del plan</translation>
    </message>
    <message>
        <source>Keep this plan</source>
        <translation>Conservar este plan</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Keeps the plan that is marked a second time, to be changed</source>
        <translation>Conserva el plan marcado por segunda vez, para cambiarlo</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Takes the plan that is marked out of the case</source>
        <translation>Saca del caso el plan marcado</translation>
    </message>
    <message>
        <source>Rehearse, Guide and the report follow this plan</source>
        <translation>Ensayar, Guiar y el informe siguen este plan</translation>
    </message>
    <message>
        <source>What it was made from has changed since; the figures are those of now.</source>
        <translation>Aquello de lo que se hizo ha cambiado desde entonces; las cifras son las de ahora.</translation>
    </message>
    <message>
        <source>No worse in anything, and better in something: %1</source>
        <translation>No es peor en nada, y es mejor en algo: %1</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PlanPlot</name>
    <message>
        <source>smallest margin, mm</source>
        <translation>menor margen, mm</translation>
    </message>
    <message>
        <source>stays alive, ml</source>
        <translation>queda vivo, ml</translation>
    </message>
    <message>
        <source>Plans by margin and by what stays alive</source>
        <translation>Planes por margen y por lo que queda vivo</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PlatformTable</name>
    <message>
        <source>Assumed: %1 %2 (%3)</source>
        <translation>Supuesto: %1 %2 (%3)</translation>
    </message>
    <message>
        <source>head</source>
        <translation>cabeza</translation>
    </message>
    <message>
        <source>belt</source>
        <translation>cinturón</translation>
    </message>
    <message>
        <source>back</source>
        <translation>espalda</translation>
    </message>
    <message>
        <source>idle draw</source>
        <translation>reposo</translation>
    </message>
    <message>
        <source>too hot idle</source>
        <translation>calor en reposo</translation>
    </message>
    <message>
        <source>too slow</source>
        <translation>lentitud</translation>
    </message>
    <message>
        <source>slows itself down</source>
        <translation>se ralentiza</translation>
    </message>
    <message>
        <source>battery</source>
        <translation>batería</translation>
    </message>
    <message>
        <source>too hot</source>
        <translation>calor</translation>
    </message>
    <message>
        <source>✕ fails: %1</source>
        <translation>✕ no sirve: %1</translation>
    </message>
    <message>
        <source>heat</source>
        <translation>calor</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>✓ holds; next limit: %1</source>
        <translation>✓ aguanta; límite: %1</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Plataforma</translation>
    </message>
    <message>
        <source>Worn on
the</source>
        <translation>Se lleva
en</translation>
    </message>
    <message>
        <source>Draws idle
W</source>
        <translation>En reposo
W</translation>
    </message>
    <message>
        <source>Battery
allows W</source>
        <translation>Batería
permite W</translation>
    </message>
    <message>
        <source>Left to
compute W</source>
        <translation>Queda para
calcular W</translation>
    </message>
    <message>
        <source>Frames/s
at most</source>
        <translation>Fotogr./s
como máx.</translation>
    </message>
    <message>
        <source>Lasts
h</source>
        <translation>Dura
h</translation>
    </message>
    <message>
        <source>Surface
°C</source>
        <translation>Superf.
°C</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Límite</translation>
    </message>
    <message>
        <source>Assumed
figures</source>
        <translation>Cifras
supuestas</translation>
    </message>
    <message>
        <source>What it takes from its battery when nothing is computed</source>
        <translation>Lo que toma de su batería cuando no se calcula nada</translation>
    </message>
    <message>
        <source>The largest constant power that its battery carries for the operation</source>
        <translation>La mayor potencia constante que su batería mantiene durante la operación</translation>
    </message>
    <message>
        <source>What the battery allows, less what idling takes</source>
        <translation>Lo que permite la batería menos lo que consume el reposo</translation>
    </message>
    <message>
        <source>The frame rate that meets every constraint</source>
        <translation>La frecuencia de fotogramas que cumple todas las condiciones</translation>
    </message>
    <message>
        <source>On one charge, at the wanted frame rate or the fastest it computes</source>
        <translation>Con una carga, a la frecuencia de fotogramas deseada o a la más rápida que calcula</translation>
    </message>
    <message>
        <source>At the end of the operation</source>
        <translation>Al final de la operación</translation>
    </message>
    <message>
        <source>Figures that nobody measured; ≈ marks what rests on them</source>
        <translation>Cifras que nadie ha medido; ≈ marca lo que depende de ellas</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Sure to
hold %</source>
        <translation>Basta
seguro %</translation>
    </message>
    <message>
        <source>In how many of 100 draws of its figures, off by as much as their sources may be, it holds</source>
        <translation>En cuántos de 100 sorteos de sus cifras, tan desviadas como puedan estarlo sus fuentes, basta</translation>
    </message>
    <message>
        <source>In 80 of 100 draws it can do %1 to %2 frames/s</source>
        <translation>En 80 de 100 sorteos alcanza de %1 a %2 fotogramas/s</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PlatformView</name>
    <message>
        <source>Volume and stiffness of %1</source>
        <translation>Volumen y rigidez de %1</translation>
    </message>
    <message>
        <source>Volume of %1; its stiffness is not known</source>
        <translation>Volumen de %1; su rigidez no se conoce</translation>
    </message>
    <message>
        <source>Stiffness of %1; its volume is not known</source>
        <translation>Rigidez de %1; su volumen no se conoce</translation>
    </message>
    <message>
        <source>%1 has no outlined liver yet: type its volume</source>
        <translation>%1 aún no tiene el hígado delimitado: escriba su volumen</translation>
    </message>
    <message>
        <source>The case</source>
        <translation>El caso</translation>
    </message>
    <message>
        <source>No case is open: type its figures</source>
        <translation>No hay ningún caso abierto: escriba sus cifras</translation>
    </message>
    <message>
        <source> cm³</source>
        <translation> cm³</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Hígado</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation> kPa</translation>
    </message>
    <message>
        <source>Mean Young&apos;s modulus. Softer tissue moves farther under the same load, and what a coarse model misses of it grows alike.</source>
        <translation>Módulo de Young medio. Un tejido más blando se mueve más con la misma carga, y lo que un modelo grueso pierde de ello crece igual.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Módulo de Young</translation>
    </message>
    <message>
        <source>What is wanted</source>
        <translation>Lo que se desea</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Precisión</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Duration of the operation</source>
        <translation>Duración de la operación</translation>
    </message>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Frecuencia de fotogramas</translation>
    </message>
    <message>
        <source> /s</source>
        <translation> /s</translation>
    </message>
    <message>
        <source>The room and the skin</source>
        <translation>La sala y la piel</translation>
    </message>
    <message>
        <source>Operating room</source>
        <translation>Quirófano</translation>
    </message>
    <message>
        <source> °C</source>
        <translation> °C</translation>
    </message>
    <message>
        <source>Hottest surface to be worn</source>
        <translation>Superficie más caliente que se puede llevar</translation>
    </message>
    <message>
        <source>Add devices...</source>
        <translation>Añadir dispositivos…</translation>
    </message>
    <message>
        <source>A table of your own, or what glisson-cli platform measure wrote</source>
        <translation>Una tabla propia o lo que escribió glisson-cli platform measure</translation>
    </message>
    <message>
        <source>Surface temperature</source>
        <translation>Temperatura de la superficie</translation>
    </message>
    <message>
        <source>Frame rate that holds</source>
        <translation>Frecuencia de fotogramas que aguanta</translation>
    </message>
    <message>
        <source>Battery life</source>
        <translation>Duración de la batería</translation>
    </message>
    <message>
        <source>Mean power</source>
        <translation>Potencia media</translation>
    </message>
    <message>
        <source>Add devices</source>
        <translation>Añadir dispositivos</translation>
    </message>
    <message>
        <source>Device tables (*.json)</source>
        <translation>Tablas de dispositivos (*.json)</translation>
    </message>
    <message>
        <source>%1 nodes of %2 mm³. A frame is %3 block products: %4 MB to move, %5 million operations.</source>
        <translation>%1 nodos de %2 mm³. Un fotograma son %3 productos por bloques: %4 MB que mover, %5 millones de operaciones.</translation>
    </message>
    <message>
        <source>None of these platforms holds.</source>
        <translation>Ninguna de estas plataformas aguanta.</translation>
    </message>
    <message>
        <source>Least obtrusive that holds, on the head: %1</source>
        <translation>La menos molesta que aguanta, en la cabeza: %1</translation>
    </message>
    <message>
        <source>Least obtrusive that holds, on the belt: %1</source>
        <translation>La menos molesta que aguanta, en el cinturón: %1</translation>
    </message>
    <message>
        <source>Least obtrusive that holds, on the back: %1</source>
        <translation>La menos molesta que aguanta, en la espalda: %1</translation>
    </message>
    <message>
        <source>Surface after %1 h at %2 frames/s (°C)</source>
        <translation>Superficie tras %1 h a %2 fotogramas/s (°C)</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Frames/s that hold for %1 h</source>
        <translation>Fotogramas/s que aguantan %1 h</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Battery lasts at %1 frames/s (h)</source>
        <translation>La batería dura a %1 fotogramas/s (h)</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>Mean power at %1 frames/s (W)</source>
        <translation>Potencia media a %1 fotogramas/s (W)</translation>
    </message>
    <message>
        <source>%1 W: the battery</source>
        <translation>%1 W: la batería</translation>
    </message>
    <message>
        <source>an operation of at most %1 h</source>
        <translation>una operación de como máximo %1 h</translation>
    </message>
    <message>
        <source>at most %1 frames/s</source>
        <translation>como máximo %1 fotogramas/s</translation>
    </message>
    <message>
        <source>an accuracy of %1 mm</source>
        <translation>una precisión de %1 mm</translation>
    </message>
    <message>
        <source>a battery of %1 Wh</source>
        <translation>una batería de %1 Wh</translation>
    </message>
    <message>
        <source>a heat sink of %1 °C/W</source>
        <translation>un disipador de %1 °C/W</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>medido</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>calculado</translation>
    </message>
    <message>
        <source>dissertation</source>
        <translation>tesis</translation>
    </message>
    <message>
        <source>ASSUMED</source>
        <translation>SUPUESTO</translation>
    </message>
    <message>
        <source>Idle first: it draws %1 W of the %2 W that its battery allows over %3 h; it would last %4 h and reach %5 °C without computing anything.</source>
        <translation>Primero el reposo: consume %1 W de los %2 W que su batería permite durante %3 h; sin calcular nada duraría %4 h y llegaría a %5 °C.</translation>
    </message>
    <message>
        <source>Frames/s: %1 by its speed, %2 by its battery, %3 by its heat. A frame takes %4 J above idle; mean power %5 W.</source>
        <translation>Fotogramas/s: %1 por su velocidad, %2 por su batería, %3 por su calor. Un fotograma consume %4 J sobre el reposo; potencia media %5 W.</translation>
    </message>
    <message>
        <source>Why it fails:</source>
        <translation>Por qué no sirve:</translation>
    </message>
    <message>
        <source>No single figure would make it hold.</source>
        <translation>Ninguna cifra por sí sola la haría aguantar.</translation>
    </message>
    <message>
        <source>It would hold with one of:</source>
        <translation>Aguantaría con una de estas:</translation>
    </message>
    <message>
        <source>Where its figures come from:</source>
        <translation>De dónde proceden sus cifras:</translation>
    </message>
    <message>
        <source>Volume of %1; its stiffness is assumed</source>
        <translation>Volumen de %1; su rigidez es supuesta</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Plataforma</translation>
    </message>
    <message>
        <source>Find what can be worn for this case.</source>
        <translation>Encontrar qué se puede llevar puesto en este caso.</translation>
    </message>
    <message>
        <source>What is computed</source>
        <translation>Qué se calcula</translation>
    </message>
    <message>
        <source>The dissertation&apos;s product</source>
        <translation>El producto de la tesis</translation>
    </message>
    <message>
        <source>A frame of it: %1 MB to move, %2 million operations.</source>
        <translation>Un fotograma: %1 MB que mover, %2 millones de operaciones.</translation>
    </message>
    <message>
        <source>How sure that is: with its figures off by as much as their sources may be, 5 to 30 %, it holds in %1 of 100 draws, and in 80 of 100 it can do %2 to %3 frames/s.</source>
        <translation>Qué seguro es: con sus cifras tan desviadas como puedan estarlo sus fuentes, del 5 al 30 %, basta en %1 de 100 sorteos, y en 80 de 100 alcanza de %2 a %3 fotogramas/s.</translation>
    </message>
    <message>
        <source>Rehearse: a live frame, small deformations</source>
        <translation>Ensayar: un fotograma, deformaciones pequeñas</translation>
    </message>
    <message>
        <source>Rehearse: a live frame, large deformations</source>
        <translation>Ensayar: un fotograma, deformaciones grandes</translation>
    </message>
    <message>
        <source>Rehearse: a step of the meshfree engine</source>
        <translation>Ensayar: un paso del método sin malla</translation>
    </message>
    <message>
        <source>Guide: a frame</source>
        <translation>Guiar: un fotograma</translation>
    </message>
    <message>
        <source>Match: a registration of 128 points</source>
        <translation>Emparejar: un registro de 128 puntos</translation>
    </message>
    <message>
        <source>Read a power recording...</source>
        <translation>Leer un registro de potencia...</translation>
    </message>
    <message>
        <source>What an oscilloscope, a power analyser or a battery tester wrote of a platform: idle power and power under load</source>
        <translation>Lo que un osciloscopio, un analizador de potencia o un comprobador de baterías registró de una plataforma: potencia en reposo y bajo carga</translation>
    </message>
    <message>
        <source>Read a power recording</source>
        <translation>Leer un registro de potencia</translation>
    </message>
    <message>
        <source>Recordings (*.csv *.txt *.log *.tsv)</source>
        <translation>Registros (*.csv *.txt *.log *.tsv)</translation>
    </message>
    <message>
        <source>%1, as recorded</source>
        <translation>%1, según el registro</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ProbabilityBars</name>
    <message>
        <source>Something that is not in the catalogue</source>
        <translation>Algo que no está en el catálogo</translation>
    </message>
    <message>
        <source>Nothing is missing</source>
        <translation>No falta nada</translation>
    </message>
    <message>
        <source>Probability of each explanation. Where the answer was known, in generated experiments, 98 of 100 that were given 90 % and more were right, and 7 of 10 given 60 to 80 %.</source>
        <translation>Probabilidad de cada explicación. Donde se conocía la respuesta, en experimentos generados, 98 de cada 100 con un 90 % o más eran correctas, y 7 de cada 10 entre el 60 y el 80 %.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ReadingPanel</name>
    <message>
        <source>Reading</source>
        <translation>Lectura</translation>
    </message>
    <message>
        <source>What the colours show</source>
        <translation>Qué muestran los colores</translation>
    </message>
    <message>
        <source>Colours: SIRGn&apos;s correlation</source>
        <translation>Colores: correlación de SIRGn</translation>
    </message>
    <message>
        <source>Colours: error of the landmarks (mm)</source>
        <translation>Colores: error de los puntos de referencia (mm)</translation>
    </message>
    <message>
        <source>Colours: doubt (mm)</source>
        <translation>Colores: duda (mm)</translation>
    </message>
    <message>
        <source>Correlation: whether landmarks and warp move alike over time, 1 is best. Error: mean distance of a triangle&apos;s landmarks, as registered, from where they are on the model, mm. Doubt: motion that the registration leaves unexplained, mm, to be compared within one sequence.</source>
        <translation>Correlación: si los puntos de referencia y la deformación se mueven igual con el tiempo, 1 es lo mejor. Error: distancia media de los puntos de referencia registrados de un triángulo a su lugar en el modelo, mm. Duda: movimiento que el registro deja sin explicar, mm, para comparar dentro de una misma secuencia.</translation>
    </message>
    <message>
        <source>Tolerance: rejected from</source>
        <translation>Tolerancia: rechazo a partir de</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Triangles whose landmarks are off by this much or more, mm, are grey and hatched</source>
        <translation>Los triángulos cuyos puntos de referencia se desvían esto o más (mm) se ven grises y rayados</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Sets the tolerance to %1 mm</source>
        <translation>Fija la tolerancia en %1 mm</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::RegisterPage</name>
    <message>
        <source>Register</source>
        <translation>Registrar</translation>
    </message>
    <message>
        <source>See how good a registration of a video is, place by place.</source>
        <translation>Ver qué calidad tiene el registro de un vídeo, lugar por lugar.</translation>
    </message>
    <message>
        <source>Opening the sequence</source>
        <translation>Abriendo la secuencia</translation>
    </message>
    <message>
        <source>Making an example sequence</source>
        <translation>Creando una secuencia de ejemplo</translation>
    </message>
    <message>
        <source>Registering the video</source>
        <translation>Registrando el vídeo</translation>
    </message>
    <message>
        <source>Open another...</source>
        <translation>Abrir otra…</translation>
    </message>
    <message>
        <source>Another sequence.json in place of this one</source>
        <translation>Otro sequence.json en lugar de este</translation>
    </message>
    <message>
        <source>Open a sequence</source>
        <translation>Abrir una secuencia</translation>
    </message>
    <message>
        <source>Sequences (*.json)</source>
        <translation>Secuencias (*.json)</translation>
    </message>
    <message>
        <source>Click a triangle to see its history.</source>
        <translation>Haga clic en un triángulo para ver su evolución.</translation>
    </message>
    <message>
        <source>%1 mm in this frame</source>
        <translation>%1 mm en este fotograma</translation>
    </message>
    <message>
        <source>not all its corners are seen in this frame</source>
        <translation>no se ven todos sus vértices en este fotograma</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>rechazado</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>aceptado</translation>
    </message>
    <message>
        <source>%1, triangle %2: correlation %3; off by %4 mm on average, %5; %6</source>
        <translation>%1, triángulo %2: correlación %3; desviado %4 mm en promedio, %5; %6</translation>
    </message>
    <message>
        <source>%1: %2 frames, %3 landmarks</source>
        <translation>%1: %2 fotogramas, %3 puntos de referencia</translation>
    </message>
    <message>
        <source>One moment...</source>
        <translation>Un momento…</translation>
    </message>
    <message>
        <source>Click a triangle to see its history; hover over it for its figures</source>
        <translation>Haga clic en un triángulo para ver su evolución; pase por encima para ver sus cifras</translation>
    </message>
    <message>
        <source>Not registered yet: press &quot;Register and judge&quot;.</source>
        <translation>Aún sin registrar: pulse «Registrar y juzgar».</translation>
    </message>
    <message>
        <source>%1: %2 % of %3 triangles rejected at %4 mm</source>
        <translation>%1: %2 % de %3 triángulos rechazados a %4 mm</translation>
    </message>
    <message>
        <source>The sequence names no camera, so that no mesh can be drawn over the video.</source>
        <translation>La secuencia no indica ninguna cámara, así que no se puede dibujar la malla sobre el vídeo.</translation>
    </message>
    <message>
        <source>The sequence names no pictures; the mesh is drawn on black.</source>
        <translation>La secuencia no indica imágenes; la malla se dibuja sobre negro.</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Correlación</translation>
    </message>
    <message>
        <source>Error
(mm)</source>
        <translation>Error
(mm)</translation>
    </message>
    <message>
        <source>Doubt
(mm)</source>
        <translation>Duda
(mm)</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bueno</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>malo</translation>
    </message>
    <message>
        <source>rejected: off by %1 mm or more</source>
        <translation>rechazado: desviado %1 mm o más</translation>
    </message>
    <message>
        <source>the left edge</source>
        <translation>el borde izquierdo</translation>
    </message>
    <message>
        <source>the right edge</source>
        <translation>el borde derecho</translation>
    </message>
    <message>
        <source>the upper edge</source>
        <translation>el borde superior</translation>
    </message>
    <message>
        <source>the lower edge</source>
        <translation>el borde inferior</translation>
    </message>
    <message>
        <source>%1 is nowhere off by %2 mm or more.</source>
        <translation>%1 no se desvía en ningún lugar %2 mm o más.</translation>
    </message>
    <message>
        <source>Do not trust %1: on most of it landmarks are off by %2 mm or more.</source>
        <translation>No se fíe de %1: en la mayor parte las referencias se desvían %2 mm o más.</translation>
    </message>
    <message>
        <source>Of %1 do not trust single places: %2 % of it is off by %3 mm or more.</source>
        <translation>De %1 no se fíe de lugares sueltos: el %2 % se desvía %3 mm o más.</translation>
    </message>
    <message>
        <source>Of %1 do not trust %2: landmarks are off by %3 mm or more there.</source>
        <translation>De %1 no se fíe de esto: %2. Allí las referencias se desvían %3 mm o más.</translation>
    </message>
    <message>
        <source>Neither %1 nor %2 is clearly better here.</source>
        <translation>Ni %1 ni %2 es aquí claramente mejor.</translation>
    </message>
    <message>
        <source>%1 is better here than %2.</source>
        <translation>%1 es aquí mejor que %2.</translation>
    </message>
    <message>
        <source>From a video...</source>
        <translation>De un vídeo…</translation>
    </message>
    <message>
        <source>Two videos, or one that shows both eyes, become a sequence</source>
        <translation>Dos vídeos, o uno que muestra ambos ojos, se convierten en una secuencia</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::RegisterWelcome</name>
    <message>
        <source>How good is a registration of a video?</source>
        <translation>¿Qué calidad tiene el registro de un vídeo?</translation>
    </message>
    <message>
        <source>Open a sequence...</source>
        <translation>Abrir una secuencia…</translation>
    </message>
    <message>
        <source>A sequence.json with its clouds, tracks and pictures beside it</source>
        <translation>Un sequence.json con sus nubes, trayectorias e imágenes al lado</translation>
    </message>
    <message>
        <source>Make an example sequence</source>
        <translation>Crear una secuencia de ejemplo</translation>
    </message>
    <message>
        <source>Simulates 40 frames in a few seconds and opens them; 7 MB</source>
        <translation>Simula 40 fotogramas en pocos segundos y los abre; 7 MB</translation>
    </message>
    <message>
        <source>Begin with the video of a stereo laparoscope and its calibration, or pictures of a board: a sequence is made of it, a cloud of points a frame and the tracks of landmarks. Or open a sequence that is there. Without a video, an example shows what it is about: the demo patient&apos;s liver, breathing and pressed by a tool, simulated.</source>
        <translation>Empiece con el vídeo de un laparoscopio estéreo y su calibración, o imágenes de un tablero: de él se hace una secuencia, una nube de puntos por fotograma y las trayectorias de puntos de referencia. O abra una secuencia que ya exista. Sin vídeo, un ejemplo muestra de qué se trata: el hígado del paciente de demostración, que respira y es presionado por un instrumento, simulado.</translation>
    </message>
    <message>
        <source>From a video...</source>
        <translation>De un vídeo…</translation>
    </message>
    <message>
        <source>Two videos, or one that shows both eyes, become a sequence</source>
        <translation>Dos vídeos, o uno que muestra ambos ojos, se convierten en una secuencia</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::RehearsePanel</name>
    <message>
        <source>Rehearse</source>
        <translation>Ensayar</translation>
    </message>
    <message>
        <source>Open a case with a model of the liver, or the demo patient, to rehearse a retraction.</source>
        <translation>Abra un caso con un modelo del hígado, o el paciente de demostración, para ensayar una retracción.</translation>
    </message>
    <message>
        <source>Show the liver with the stiffness of</source>
        <translation>Mostrar el hígado con la rigidez de</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Puntos de referencia</translation>
    </message>
    <message>
        <source>Colour the liver by how far it moves</source>
        <translation>Colorear el hígado según su desplazamiento</translation>
    </message>
    <message>
        <source>Place the tool to see what moves.</source>
        <translation>Coloque el instrumento para ver qué se mueve.</translation>
    </message>
    <message>
        <source>The liver moves by up to %1 mm.</source>
        <translation>El hígado se mueve hasta %1 mm.</translation>
    </message>
    <message>
        <source>The atlas is off by up to %1 mm.</source>
        <translation>El atlas se equivoca hasta %1 mm.</translation>
    </message>
    <message>
        <source>Changed by evidence: %1</source>
        <translation>Cambiado por la evidencia: %1</translation>
    </message>
    <message>
        <source>Evidence to bear in mind: %1</source>
        <translation>Evidencia que tener presente: %1</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Saves the landmarks as CSV, in mm</source>
        <translation>Guarda los puntos de referencia como CSV, en mm</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>A lo largo del tiempo</translation>
    </message>
    <message>
        <source>Save the landmarks as a table</source>
        <translation>Guardar los puntos de referencia como tabla</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tablas (*.csv)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Colocar</translation>
    </message>
    <message>
        <source>Sets a landmark where the crosshair is: click in a slice or in 3D first</source>
        <translation>Coloca un punto de referencia donde está la cruz: haga clic antes en un corte o en 3D</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Takes the chosen landmark away, if it was set by hand; Ctrl+Z brings it back</source>
        <translation>Quita el punto elegido, si se colocó a mano; Ctrl+Z lo devuelve</translation>
    </message>
    <message>
        <source>A name has letters or digits.</source>
        <translation>Un nombre tiene letras o cifras.</translation>
    </message>
    <message>
        <source>This name is taken.</source>
        <translation>Este nombre ya está en uso.</translation>
    </message>
    <message>
        <source>Rename landmark</source>
        <translation>Renombrar punto de referencia</translation>
    </message>
    <message>
        <source>Remove landmark</source>
        <translation>Quitar punto de referencia</translation>
    </message>
    <message>
        <source>▲ The image cuts the liver off here, towards %1. The tool touches a cap where the liver goes on: place it elsewhere.</source>
        <translation>▲ La imagen corta aquí el hígado, hacia %1. El instrumento toca una tapa donde el hígado continúa: colóquelo en otro lugar.</translation>
    </message>
    <message>
        <source>There are no landmarks: put the crosshair where one is to be, then press Set.</source>
        <translation>No hay puntos de referencia: coloque la cruz donde haya de estar uno y pulse Colocar.</translation>
    </message>
    <message>
        <source>Set landmark</source>
        <translation>Colocar punto de referencia</translation>
    </message>
    <message>
        <source>Pull with a tool, and see what moves and how far.</source>
        <translation>Tirar con un instrumento y ver qué se mueve y cuánto.</translation>
    </message>
    <message>
        <source>Click on the liver where the tool is to touch it.</source>
        <translation>Haga clic en el hígado donde el instrumento deba tocarlo.</translation>
    </message>
    <message>
        <source>Tool placed in %1 ms.</source>
        <translation>Instrumento colocado en %1 ms.</translation>
    </message>
    <message>
        <source>Orders of steps</source>
        <translation>Órdenes de pasos</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ReportView</name>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>Show the patient&apos;s name</source>
        <translation>Mostrar el nombre del paciente</translation>
    </message>
    <message>
        <source>Without it the page names neither the patient nor the case; see the settings too</source>
        <translation>Sin él, la página no nombra ni al paciente ni el caso; vea también los ajustes</translation>
    </message>
    <message>
        <source>Collect again</source>
        <translation>Reunir de nuevo</translation>
    </message>
    <message>
        <source>Reads the case and the present rehearsal anew</source>
        <translation>Lee de nuevo el caso y el ensayo actual</translation>
    </message>
    <message>
        <source>Save as a web page...</source>
        <translation>Guardar como página web…</translation>
    </message>
    <message>
        <source>Print to PDF...</source>
        <translation>Imprimir a PDF…</translation>
    </message>
    <message>
        <source>All that was done for this patient on one page.</source>
        <translation>Todo lo hecho para este paciente en una página.</translation>
    </message>
    <message>
        <source>Needs a case: open one, or the demo patient.</source>
        <translation>Necesita un caso: abra uno o el paciente de demostración.</translation>
    </message>
    <message>
        <source>Collecting the report</source>
        <translation>Reuniendo el informe</translation>
    </message>
    <message>
        <source>Open a case, or the demo patient, to see its page.</source>
        <translation>Abra un caso, o el paciente de demostración, para ver su página.</translation>
    </message>
    <message>
        <source>The page is being collected.</source>
        <translation>La página se está reuniendo.</translation>
    </message>
    <message>
        <source>Something has changed since this page was collected.</source>
        <translation>Algo ha cambiado desde que se reunió esta página.</translation>
    </message>
    <message>
        <source>Collected from the case and from what is being rehearsed now.</source>
        <translation>Reunido del caso y de lo que se ensaya ahora.</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Guardar el informe</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Páginas web (*.html)</translation>
    </message>
    <message>
        <source>The report is in %1</source>
        <translation>El informe está en %1</translation>
    </message>
    <message>
        <source>Print the report</source>
        <translation>Imprimir el informe</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>With what can be worn</source>
        <translation>Con lo que se puede llevar</translation>
    </message>
    <message>
        <source>Adds which wearable computers can do this case, as planned in Platform</source>
        <translation>Añade qué ordenadores portables pueden con este caso, como se planificó en Plataforma</translation>
    </message>
    <message>
        <source>The planned cut.</source>
        <translation>El corte planificado.</translation>
    </message>
    <message>
        <source>The patient as shown in the window.</source>
        <translation>El paciente tal como lo muestra la ventana.</translation>
    </message>
    <message>
        <source>Transverse</source>
        <translation>Transversal</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ResectPanel</name>
    <message>
        <source>Plan a resection</source>
        <translation>Planificar una resección</translation>
    </message>
    <message>
        <source>Needs a model of the liver. Build it first, or open the demo patient.</source>
        <translation>Necesita un modelo del hígado. Constrúyalo primero o abra el paciente de demostración.</translation>
    </message>
    <message>
        <source>Resect</source>
        <translation>Resección</translation>
    </message>
    <message>
        <source>Set a cut: what goes, what stays, how near the tumours it passes.</source>
        <translation>Trazar una sección: qué se va, qué queda, a qué distancia de los tumores pasa.</translation>
    </message>
    <message>
        <source>Draws the part that is removed away from the rest</source>
        <translation>Aparta del resto la parte que se extirpa</translation>
    </message>
    <message>
        <source>Remove the other part</source>
        <translation>Extirpar la otra parte</translation>
    </message>
    <message>
        <source>No cut</source>
        <translation>Sin sección</translation>
    </message>
    <message>
        <source>The three places lie almost on one line. Click three others.</source>
        <translation>Los tres lugares están casi en una línea. Haga clic en otros tres.</translation>
    </message>
    <message>
        <source>Click three places on the liver or in the slices.</source>
        <translation>Haga clic en tres lugares del hígado o de los cortes.</translation>
    </message>
    <message>
        <source>Click on the liver or in the slices where the cut is to pass.</source>
        <translation>Haga clic en el hígado o en los cortes por donde deba pasar la sección.</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Extirpado</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Queda</translation>
    </message>
    <message>
        <source>Set three or more points where the cut is to pass: on the liver, or in the slices.</source>
        <translation>Ponga tres o más puntos por donde deba pasar la sección: en el hígado o en los cortes.</translation>
    </message>
    <message>
        <source>Click three places through which the plane is to pass.</source>
        <translation>Haga clic en tres lugares por los que deba pasar el plano.</translation>
    </message>
    <message>
        <source>Planning...</source>
        <translation>Planificando…</translation>
    </message>
    <message>
        <source>Put the crosshair where the cut is to pass, then the plane through it. Drag its line in a slice to shift it, a line&apos;s end to tilt it.</source>
        <translation>Ponga la cruz donde deba pasar la sección y después el plano por ella. Arrastre su línea en un corte para desplazarlo, y un extremo de la línea para inclinarlo.</translation>
    </message>
    <message>
        <source>Separation</source>
        <translation>Separación</translation>
    </message>
    <message>
        <source>On the liver as the tool holds it</source>
        <translation>En el hígado tal como lo sujeta el instrumento</translation>
    </message>
    <message>
        <source>The cut lies on the liver held aside; the slices show the scan, at rest.</source>
        <translation>El corte está en el hígado apartado; los planos muestran la exploración, en reposo.</translation>
    </message>
    <message>
        <source>Margins, widths and places are those on the liver under the tool of Rehearse; volumes are at rest</source>
        <translation>Márgenes, anchuras y lugares son los del hígado bajo el instrumento de Ensayar; los volúmenes, en reposo</translation>
    </message>
    <message>
        <source>Place a tool in Rehearse first: a patch at small deformations that the model bears, not a rigid tool.</source>
        <translation>Coloque antes un instrumento en Ensayar: una zona con deformaciones pequeñas que el modelo soporta, no un instrumento rígido.</translation>
    </message>
    <message>
        <source>Draw a line over the liver in the 3D view.</source>
        <translation>Trace una línea sobre el hígado en la vista 3D.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ResectionResults</name>
    <message>
        <source>removed</source>
        <translation>extirpado</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>queda</translation>
    </message>
    <message>
        <source>cut through</source>
        <translation>seccionado</translation>
    </message>
    <message>
        <source>▲ R1: cut through</source>
        <translation>▲ R1: seccionado</translation>
    </message>
    <message>
        <source>▲ Stays in the patient</source>
        <translation>▲ Queda en el paciente</translation>
    </message>
    <message>
        <source>▲ R1: under 1 mm</source>
        <translation>▲ R1: menos de 1 mm</translation>
    </message>
    <message>
        <source>● Under 5 mm</source>
        <translation>● Menos de 5 mm</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Márgenes</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Estructura</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Smallest distance to the cut inside the liver</source>
        <translation>Menor distancia a la sección dentro del hígado</translation>
    </message>
    <message>
        <source>R1: a margin under 1 mm counts as tumour at the edge. Under 5 mm is narrow.</source>
        <translation>R1: un margen inferior a 1 mm cuenta como tumor en el borde. Menos de 5 mm es estrecho.</translation>
    </message>
    <message>
        <source>Vessels crossed</source>
        <translation>Vasos cruzados</translation>
    </message>
    <message>
        <source>Vessel</source>
        <translation>Vaso</translation>
    </message>
    <message>
        <source>Diameter, mm</source>
        <translation>Diámetro, mm</translation>
    </message>
    <message>
        <source>The cut crosses no vessel that was outlined.</source>
        <translation>La sección no cruza ningún vaso delimitado.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 ml&lt;/b&gt; removed (%2 %)</source>
        <translation>&lt;b&gt;%1 ml&lt;/b&gt; extirpados (%2 %)</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 ml&lt;/b&gt; stay (%2 %)</source>
        <translation>&lt;b&gt;%1 ml&lt;/b&gt; permanecen (%2 %)</translation>
    </message>
    <message>
        <source>Caution</source>
        <translation>Atención</translation>
    </message>
    <message>
        <source>With the tool %1 goes by %2 mm; its margin there is %3 mm.</source>
        <translation>Con el instrumento %1 se desplaza %2 mm; su margen allí es de %3 mm.</translation>
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
        <translation>%1, %2 mm de ancho</translation>
    </message>
    <message>
        <source>In a tumour</source>
        <translation>En un tumor</translation>
    </message>
    <message>
        <source>No tumour within %1 mm</source>
        <translation>Ningún tumor a menos de %1 mm</translation>
    </message>
    <message>
        <source>%1 mm from a tumour</source>
        <translation>a %1 mm de un tumor</translation>
    </message>
    <message>
        <source>tumour</source>
        <translation>tumor</translation>
    </message>
    <message>
        <source>under %1 mm</source>
        <translation>menos de %1 mm</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>○ portal, □ hepatic vein cut; ◇ artery, △ bile duct</source>
        <translation>○ vena porta, □ vena hepática seccionada; ◇ arteria, △ conducto biliar</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SegmentPanel</name>
    <message>
        <source>Segment</source>
        <translation>Segmentar</translation>
    </message>
    <message>
        <source>Outline the liver, its vessels and its tumours.</source>
        <translation>Delimitar el hígado, sus vasos y sus tumores.</translation>
    </message>
    <message>
        <source>Needs a case: open one, or import images.</source>
        <translation>Necesita un caso: abra uno o importe imágenes.</translation>
    </message>
    <message>
        <source>Needs anatomical images: import them in Study.</source>
        <translation>Necesita imágenes anatómicas: impórtelas en Estudio.</translation>
    </message>
    <message>
        <source>Nothing changed.</source>
        <translation>No ha cambiado nada.</translation>
    </message>
    <message>
        <source>Reading the structures</source>
        <translation>Leyendo las estructuras</translation>
    </message>
    <message>
        <source>Another name...</source>
        <translation>Otro nombre…</translation>
    </message>
    <message>
        <source>Name of the structure</source>
        <translation>Nombre de la estructura</translation>
    </message>
    <message>
        <source>Letters, digits and hyphens:</source>
        <translation>Letras, cifras y guiones:</translation>
    </message>
    <message>
        <source>Choose a structure first, or add one.</source>
        <translation>Elija primero una estructura o añada una.</translation>
    </message>
    <message>
        <source>Click into the structure first, in any slice.</source>
        <translation>Haga clic primero dentro de la estructura, en cualquier corte.</translation>
    </message>
    <message>
        <source>Replaces the outline by the tissue around the points</source>
        <translation>Sustituye el contorno por el tejido alrededor de los puntos</translation>
    </message>
    <message>
        <source>Click into the tissue, away from large vessels. Points so far: %1</source>
        <translation>Haga clic en el tejido, lejos de los grandes vasos. Puntos hasta ahora: %1</translation>
    </message>
    <message>
        <source>Choose a tool to draw in the slices. Without one, clicks move the crosshair.</source>
        <translation>Elija una herramienta para dibujar en los cortes. Sin ella, los clics mueven la cruz.</translation>
    </message>
    <message>
        <source>Growing: %1</source>
        <translation>Crecimiento: %1</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Estructuras</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Estructura</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>The chosen one is drawn on. The box shows or hides it.</source>
        <translation>Se dibuja sobre la elegida. La casilla la muestra o la oculta.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>A new, empty structure</source>
        <translation>Una estructura nueva y vacía</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>Another name, and with it another colour, for the chosen structure</source>
        <translation>Otro nombre, y con él otro color, para la estructura elegida</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Takes the chosen structure out of the case; Ctrl+Z brings it back</source>
        <translation>Quita del caso la estructura elegida; Ctrl+Z la recupera</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>Cruz</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pincel</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Goma</translation>
    </message>
    <message>
        <source>Smart brush</source>
        <translation>Pincel selectivo</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Tijeras</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Crecer</translation>
    </message>
    <message>
        <source>Pick piece</source>
        <translation>Elegir trozo</translation>
    </message>
    <message>
        <source>Clicks move the crosshair</source>
        <translation>Los clics mueven la cruz</translation>
    </message>
    <message>
        <source>Drag to add. Ctrl: erase instead. Shift+wheel: radius in mm</source>
        <translation>Arrastre para añadir. Ctrl: borrar. Mayús+rueda: radio en mm</translation>
    </message>
    <message>
        <source>Drag to take away. Ctrl: add instead. Shift+wheel: radius in mm</source>
        <translation>Arrastre para quitar. Ctrl: añadir. Mayús+rueda: radio en mm</translation>
    </message>
    <message>
        <source>Adds only where the grey values are like those under the click</source>
        <translation>Añade solo donde los grises se parecen a los del punto pulsado</translation>
    </message>
    <message>
        <source>Draw around something, and cut away what is inside or outside</source>
        <translation>Rodee algo y corte lo que queda dentro o fuera</translation>
    </message>
    <message>
        <source>%1 (key %2)</source>
        <translation>%1 (tecla %2)</translation>
    </message>
    <message>
        <source>Radius (Shift+wheel)</source>
        <translation>Radio (Mayús+rueda)</translation>
    </message>
    <message>
        <source>Radius of the brush in mm</source>
        <translation>Radio del pincel en mm</translation>
    </message>
    <message>
        <source>Disc in this slice</source>
        <translation>Disco en este corte</translation>
    </message>
    <message>
        <source>Ball through the slices</source>
        <translation>Bola a través de los cortes</translation>
    </message>
    <message>
        <source>Whether the brush reaches into the neighbouring slices</source>
        <translation>Si el pincel alcanza los cortes vecinos</translation>
    </message>
    <message>
        <source>Tolerance (standard deviations)</source>
        <translation>Tolerancia (desviaciones típicas)</translation>
    </message>
    <message>
        <source>How far a grey value may be from that under the click, in standard deviations around it</source>
        <translation>Cuánto puede apartarse un gris del que hay bajo el clic, en desviaciones típicas</translation>
    </message>
    <message>
        <source>Cut away what is inside</source>
        <translation>Cortar lo que queda dentro</translation>
    </message>
    <message>
        <source>Cut away what is outside</source>
        <translation>Cortar lo que queda fuera</translation>
    </message>
    <message>
        <source>In this slice only</source>
        <translation>Solo en este corte</translation>
    </message>
    <message>
        <source>Through all slices</source>
        <translation>A través de todos los cortes</translation>
    </message>
    <message>
        <source>Forget the points</source>
        <translation>Olvidar los puntos</translation>
    </message>
    <message>
        <source>The whole structure</source>
        <translation>La estructura entera</translation>
    </message>
    <message>
        <source>Fill between slices</source>
        <translation>Rellenar entre cortes</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Rellenar huecos</translation>
    </message>
    <message>
        <source>Keep the largest</source>
        <translation>Conservar el mayor</translation>
    </message>
    <message>
        <source>Remove pieces below</source>
        <translation>Quitar trozos de menos de</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Suavizar</translation>
    </message>
    <message>
        <source>Grow by</source>
        <translation>Ampliar en</translation>
    </message>
    <message>
        <source>Shrink by</source>
        <translation>Reducir en</translation>
    </message>
    <message>
        <source>Fills the slices between drawn ones by their shapes</source>
        <translation>Rellena los cortes entre los dibujados según sus formas</translation>
    </message>
    <message>
        <source>Fills what is enclosed on all sides</source>
        <translation>Rellena lo que está cerrado por todos lados</translation>
    </message>
    <message>
        <source>Keeps the largest piece and drops the others</source>
        <translation>Conserva el trozo mayor y quita los demás</translation>
    </message>
    <message>
        <source>Drops pieces of less than this volume in ml</source>
        <translation>Quita los trozos de menos de este volumen en ml</translation>
    </message>
    <message>
        <source>Rounds what is smaller than about this many mm</source>
        <translation>Redondea lo que mide menos de unos tantos mm</translation>
    </message>
    <message>
        <source>Adds a margin of this many mm all around</source>
        <translation>Añade alrededor un margen de estos mm</translation>
    </message>
    <message>
        <source>Takes a margin of this many mm away all around</source>
        <translation>Quita alrededor un margen de estos mm</translation>
    </message>
    <message>
        <source>Transverse</source>
        <translation>Transversal</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
    <message>
        <source>The slices that were drawn in</source>
        <translation>Los cortes en los que se dibujó</translation>
    </message>
    <message>
        <source>Least volume in ml</source>
        <translation>Volumen mínimo en ml</translation>
    </message>
    <message>
        <source>Radius of smoothing in mm</source>
        <translation>Radio del suavizado en mm</translation>
    </message>
    <message>
        <source>Margin in mm</source>
        <translation>Margen en mm</translation>
    </message>
    <message>
        <source>So far to both sides</source>
        <translation>Hacia ambos lados, hasta</translation>
    </message>
    <message>
        <source>This slice and all towards you</source>
        <translation>Este corte y todos los de delante</translation>
    </message>
    <message>
        <source>This slice and all behind it</source>
        <translation>Este corte y todos los de detrás</translation>
    </message>
    <message>
        <source>How deep the scissors cut along your line of sight, in tilted slices too</source>
        <translation>Hasta qué profundidad cortan las tijeras a lo largo de su línea de visión, también en cortes inclinados</translation>
    </message>
    <message>
        <source>How far the scissors cut before and behind this slice, in mm</source>
        <translation>Hasta dónde cortan las tijeras delante y detrás de este corte, en mm</translation>
    </message>
    <message>
        <source>Click into the middle of it. Points so far: %1</source>
        <translation>Haga clic en el medio. Puntos hasta ahora: %1</translation>
    </message>
    <message>
        <source>Outline with another program...</source>
        <translation>Contornear con otro programa...</translation>
    </message>
    <message>
        <source>Outline with another program</source>
        <translation>Contornear con otro programa</translation>
    </message>
    <message>
        <source>Its command, as in TotalSegmentator -i {image} -o {folder}
(kept in Settings):</source>
        <translation>Su orden, como en TotalSegmentator -i {image} -o {folder}
(queda en Ajustes):</translation>
    </message>
    <message>
        <source>Outlining with another program</source>
        <translation>Contorneando con otro programa</translation>
    </message>
    <message>
        <source>Click on the piece that is to stay; all others go. Ctrl and click: the part under the pointer goes, from where it is narrowest.</source>
        <translation>Haga clic en el trozo que debe quedar; los demás desaparecen. Ctrl y clic: desaparece la parte bajo el puntero, desde donde es más estrecha.</translation>
    </message>
    <message>
        <source>Click on the piece that is to stay; all others go. Ctrl: takes off the part under the pointer</source>
        <translation>Haga clic en el trozo que debe quedar; los demás desaparecen. Ctrl: quita la parte bajo el puntero</translation>
    </message>
    <message>
        <source>Outline the liver first.</source>
        <translation>Contornee primero el hígado.</translation>
    </message>
    <message>
        <source>Replaces the outline by all that is shaped like a vessel in the liver</source>
        <translation>Sustituye el contorno por todo lo que en el hígado tiene forma de vaso</translation>
    </message>
    <message>
        <source>Replaces the outline by the vessels in the liver that hang on the points</source>
        <translation>Sustituye el contorno por los vasos del hígado unidos a los puntos</translation>
    </message>
    <message>
        <source>Click into the vessel where it stands out best, or let all vessels be found. Points so far: %1</source>
        <translation>Haga clic en el vaso donde mejor destaca, o haga buscar todos los vasos. Puntos hasta ahora: %1</translation>
    </message>
    <message>
        <source>Finding vessels: %1</source>
        <translation>Buscando vasos: %1</translation>
    </message>
    <message>
        <source>Click points into the tissue, then let the structure grow over what looks alike; vessels are found without</source>
        <translation>Haga clic en puntos del tejido y deje crecer la estructura por lo parecido; los vasos se encuentran también sin ellos</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Replaces the outline by the liver that brightness and shape show; it needs no point</source>
        <translation>Sustituye el contorno por el hígado que muestran el brillo y la forma; no hace falta ningún punto</translation>
    </message>
    <message>
        <source>Finding: %1</source>
        <translation>Buscando: %1</translation>
    </message>
    <message>
        <source>Points outside count for Find alone.</source>
        <translation>Los puntos de fuera solo cuentan para «Buscar».</translation>
    </message>
    <message>
        <source>Click into the liver, away from large vessels; Ctrl and click into what is wrongly taken for it. A click on a point takes it away. Points so far: %1 inside, %2 outside</source>
        <translation>Haga clic en el hígado, lejos de los grandes vasos; con Ctrl, en lo que se toma por él por error. Un clic en un punto lo quita. Puntos hasta ahora: %1 dentro, %2 fuera</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SequenceReportView</name>
    <message>
        <source>Calibration: read; the eyes are %1 mm apart.</source>
        <translation>Calibración: leída; los ojos distan %1 mm.</translation>
    </message>
    <message>
        <source>Calibration: reprojection error %1 px; the board is seen in %2 of %3 pairs; the eyes are %4 mm apart.</source>
        <translation>Calibración: error de reproyección %1 px; el tablero se ve en %2 de %3 pares; los ojos distan %4 mm.</translation>
    </message>
    <message>
        <source>Landmarks tracked: %1.</source>
        <translation>Puntos de referencia seguidos: %1.</translation>
    </message>
    <message>
        <source>Landmarks tracked: %1; they agree within %2 mm once all frames are aligned.</source>
        <translation>Puntos de referencia seguidos: %1; coinciden en %2 mm una vez alineados todos los fotogramas.</translation>
    </message>
    <message>
        <source>Most pairs do not show the board: check its kind, its columns and its rows.</source>
        <translation>La mayoría de los pares no muestra el tablero: compruebe su tipo, sus columnas y sus filas.</translation>
    </message>
    <message>
        <source>More than 1 px: the board may not be flat, or it moved between the two eyes.</source>
        <translation>Más de 1 px: quizá el tablero no es plano, o se movió entre los dos ojos.</translation>
    </message>
    <message>
        <source>The eyes of a laparoscope are about 5 mm apart: is the board&apos;s size right?</source>
        <translation>Los ojos de un laparoscopio distan unos 5 mm: ¿es correcto el tamaño del tablero?</translation>
    </message>
    <message>
        <source>The eyes of a laparoscope are about 5 mm apart: is the calibration in mm?</source>
        <translation>Los ojos de un laparoscopio distan unos 5 mm: ¿está la calibración en mm?</translation>
    </message>
    <message>
        <source>The calibration&apos;s middle lies far from the pictures&apos; middle: is it of this size?</source>
        <translation>El centro de la calibración está lejos del de las imágenes: ¿es de este tamaño?</translation>
    </message>
    <message>
        <source>Frames left out because they show hardly anything in depth: %1.</source>
        <translation>Fotogramas omitidos porque apenas muestran algo en profundidad: %1.</translation>
    </message>
    <message>
        <source>What comes on the way</source>
        <translation>Lo que surge por el camino</translation>
    </message>
    <message>
        <source>Here you will see how well the camera is calibrated, how much of each pair of pictures is seen in depth, and how many landmarks are followed. Then the sequence is opened.</source>
        <translation>Aquí verá lo bien que está calibrada la cámara, cuánto de cada par de imágenes se ve en profundidad y cuántos puntos de referencia se siguen. Después se abre la secuencia.</translation>
    </message>
    <message>
        <source>A frame beside its depths</source>
        <translation>Un fotograma junto a sus profundidades</translation>
    </message>
    <message>
        <source>First pair, frame %1: points %2; %3 % of what can be seen.</source>
        <translation>Primer par, fotograma %1: puntos %2; %3 % de lo que se puede ver.</translation>
    </message>
    <message>
        <source>Frames: %1, with %2 points each on average; %3 % of what can be seen.</source>
        <translation>Fotogramas: %1, con %2 puntos cada uno de media; %3 % de lo que se puede ver.</translation>
    </message>
    <message>
        <source>Frame %1: points %2; %3 % of what can be seen; landmarks known from before: %4.</source>
        <translation>Fotograma %1: puntos %2; %3 % de lo que se puede ver; puntos de referencia ya conocidos: %4.</translation>
    </message>
    <message>
        <source>Kept in %1.</source>
        <translation>Guardada en %1.</translation>
    </message>
    <message>
        <source>Rectified left picture; beside it what is seen in depth, near places bright.</source>
        <translation>Imagen izquierda rectificada; al lado lo que se ve en profundidad, lo cercano claro.</translation>
    </message>
    <message>
        <source>Made from the video.</source>
        <translation>Creada del vídeo.</translation>
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
        <translation>Tamaño y espaciado</translation>
    </message>
    <message>
        <source>Use as</source>
        <translation>Usar como</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Observaciones</translation>
    </message>
    <message>
        <source>Anatomy</source>
        <translation>Anatomía</translation>
    </message>
    <message>
        <source>Stiffness (kPa)</source>
        <translation>Rigidez (kPa)</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Confianza</translation>
    </message>
    <message>
        <source>MRE magnitude</source>
        <translation>Magnitud de ERM</translation>
    </message>
    <message>
        <source>MRE phase</source>
        <translation>Fase de ERM</translation>
    </message>
    <message>
        <source>MRE waves</source>
        <translation>Ondas de ERM</translation>
    </message>
    <message>
        <source>Segmentation</source>
        <translation>Segmentación</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Omitir</translation>
    </message>
    <message>
        <source>Without a description</source>
        <translation>Sin descripción</translation>
    </message>
    <message>
        <source>%1 volumes</source>
        <translation>%1 volúmenes</translation>
    </message>
    <message>
        <source>Use %1 as</source>
        <translation>Usar %1 como</translation>
    </message>
    <message>
        <source>What this series is for. The proposal is read from its header.</source>
        <translation>Para qué es esta serie. La propuesta se lee de su cabecera.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SettingsWindow</name>
    <message>
        <source>Settings - Glisson</source>
        <translation>Ajustes - Glisson</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Aspecto</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>System language</source>
        <translation>Idioma del sistema</translation>
    </message>
    <message>
        <source>&amp;Processors</source>
        <translation>&amp;Procesadores</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Los %1</translation>
    </message>
    <message>
        <source>How many processors long computations may take</source>
        <translation>Cuántos procesadores pueden usar los cálculos largos</translation>
    </message>
    <message>
        <source>&amp;Patients&apos; names in what leaves this window</source>
        <translation>Nombres de los &amp;pacientes en lo que sale de esta ventana</translation>
    </message>
    <message>
        <source>Pictures, movies and reports name a patient only then. The log never does.</source>
        <translation>Solo entonces las imágenes, las películas y los informes nombran a un paciente. El registro nunca lo hace.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>&amp;Outlining program</source>
        <translation>Pr&amp;ograma de contornos</translation>
    </message>
    <message>
        <source>Its &amp;values</source>
        <translation>Sus &amp;valores</translation>
    </message>
    <message>
        <source>A program of yours that outlines organs, for Segment (Add). {image} stands for the images of the case and {folder} for where its label maps go. Values are named only where its files do not say what they are.</source>
        <translation>Un programa suyo que contornea órganos, para Segmentar (Añadir). {image} son las imágenes del caso y {folder} el lugar de sus mapas de etiquetas. Los valores se nombran solo donde sus archivos no dicen qué son.</translation>
    </message>
    <message>
        <source>As in: %1</source>
        <translation>Como en: %1</translation>
    </message>
    <message>
        <source>Livers&apos; &amp;shapes</source>
        <translation>&amp;Formas de hígado</translation>
    </message>
    <message>
        <source>A shape model&apos;s file, by which Segment finds the liver; without one, a simulated liver&apos;s shape</source>
        <translation>El archivo de un modelo de forma con el que Segmentar encuentra el hígado; sin él, la forma de un hígado simulado</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ShortcutsWindow</name>
    <message>
        <source>Keys - Glisson</source>
        <translation>Teclas - Glisson</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Words to search for</source>
        <translation>Palabras que buscar</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Qué hace</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Tecla</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SliceTools</name>
    <message>
        <source>Choose a structure first, or add one.</source>
        <translation>Elija primero una estructura o añada una.</translation>
    </message>
    <message>
        <source>One moment: the last change is being worked off.</source>
        <translation>Un momento: se está aplicando el último cambio.</translation>
    </message>
    <message>
        <source>Points outside count for the liver alone.</source>
        <translation>Los puntos de fuera solo cuentan para el hígado.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SolvingLight</name>
    <message>
        <source>○ No tool</source>
        <translation>○ Ningún instrumento</translation>
    </message>
    <message>
        <source>◐ Solving</source>
        <translation>◐ Resolviendo</translation>
    </message>
    <message>
        <source>▲ Not to be used</source>
        <translation>▲ No utilizable</translation>
    </message>
    <message>
        <source>✔ Solved</source>
        <translation>✔ Resuelto</translation>
    </message>
    <message>
        <source>✖ Not solved</source>
        <translation>✖ No resuelto</translation>
    </message>
    <message>
        <source>❚❚ Frozen</source>
        <translation>❚❚ Congelado</translation>
    </message>
    <message>
        <source>What is shown is from before.</source>
        <translation>Se muestra el estado anterior.</translation>
    </message>
    <message>
        <source>▲ Outside of the model</source>
        <translation>▲ Fuera del modelo</translation>
    </message>
    <message>
        <source>Use less force.</source>
        <translation>Use menos fuerza.</translation>
    </message>
    <message>
        <source>solved in %1 ms · drawn in %2 ms</source>
        <translation>resuelto en %1 ms · dibujado en %2 ms</translation>
    </message>
    <message>
        <source>Residual %1: how far the equations are from balance</source>
        <translation>Residuo %1: cuánto les falta a las ecuaciones para el equilibrio</translation>
    </message>
    <message>
        <source>An estimate, which holds for slow tools; past 0.5 mm the picture is said to be settling</source>
        <translation>Una estimación, válida para instrumentos lentos; por encima de 0.5 mm se dice que la imagen está llegando al reposo</translation>
    </message>
    <message>
        <source>◐ Preparing</source>
        <translation>◐ Preparando</translation>
    </message>
    <message>
        <source>◐ Settling</source>
        <translation>◐ Llegando al reposo</translation>
    </message>
    <message>
        <source>▲ Not at rest</source>
        <translation>▲ No está en reposo</translation>
    </message>
    <message>
        <source>Landmarks are within %1 mm of rest</source>
        <translation>Los puntos de referencia están a %1 mm del reposo como mucho</translation>
    </message>
    <message>
        <source>This picture is not at rest, and the liver may slip farther than is shown. Press less, or move the tool a little.</source>
        <translation>Esta imagen no está en reposo, y el hígado puede deslizarse más de lo que se muestra. Presione menos, o mueva un poco el instrumento.</translation>
    </message>
    <message>
        <source>◐ Moving</source>
        <translation>◐ En movimiento</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StatusLine</name>
    <message>
        <source>about %1 s left</source>
        <translation>quedan unos %1 s</translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation>quedan unos %1 min</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Not a medical device</source>
        <translation>No es un producto sanitario</translation>
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
        <translation>Deformación y tensión medidas</translation>
    </message>
    <message>
        <source>strain, %</source>
        <translation>deformación, %</translation>
    </message>
    <message>
        <source>stress, kPa</source>
        <translation>tensión, kPa</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StructureOperations</name>
    <message>
        <source>Choose a structure first, or add one.</source>
        <translation>Elija antes una estructura o añada una.</translation>
    </message>
    <message>
        <source>Replaces the structure by the voxels of these grey values</source>
        <translation>Sustituye la estructura por los vóxeles de estos valores de gris</translation>
    </message>
    <message>
        <source>There is no other structure.</source>
        <translation>No hay otra estructura.</translation>
    </message>
    <message>
        <source>Changes the chosen structure; the other one stays as it is</source>
        <translation>Cambia la estructura elegida; la otra queda como está</translation>
    </message>
    <message>
        <source>Grey values and other structures</source>
        <translation>Valores de gris y otras estructuras</translation>
    </message>
    <message>
        <source>Grey values from, to</source>
        <translation>Valores de gris de, a</translation>
    </message>
    <message>
        <source>Lowest grey value</source>
        <translation>Valor de gris más bajo</translation>
    </message>
    <message>
        <source>Highest grey value</source>
        <translation>Valor de gris más alto</translation>
    </message>
    <message>
        <source>As here</source>
        <translation>Como aquí</translation>
    </message>
    <message>
        <source>Takes the grey values that are like those under the crosshair</source>
        <translation>Toma los valores de gris parecidos a los que hay bajo la cruz</translation>
    </message>
    <message>
        <source>Take these</source>
        <translation>Tomar estos</translation>
    </message>
    <message>
        <source>The brush draws on these only</source>
        <translation>El pincel dibuja solo sobre estos</translation>
    </message>
    <message>
        <source>Inside of</source>
        <translation>Dentro de</translation>
    </message>
    <message>
        <source>the whole image</source>
        <translation>toda la imagen</translation>
    </message>
    <message>
        <source>Structure to stay inside of</source>
        <translation>Estructura en la que quedarse</translation>
    </message>
    <message>
        <source>Grow and Take these stay inside of this structure</source>
        <translation>Crecer y Tomar estos se quedan dentro de esta estructura</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Keep what is also in</source>
        <translation>Conservar lo que también está en</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Restar</translation>
    </message>
    <message>
        <source>What to do with the other structure</source>
        <translation>Qué hacer con la otra estructura</translation>
    </message>
    <message>
        <source>The other structure</source>
        <translation>La otra estructura</translation>
    </message>
    <message>
        <source>Do it</source>
        <translation>Aplicar</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StudiesPage</name>
    <message>
        <source>Studies</source>
        <translation>Estudios</translation>
    </message>
    <message>
        <source>Run the dissertation&apos;s studies over many patients, and follow them.</source>
        <translation>Ejecutar los estudios de la tesis sobre muchos pacientes y seguirlos.</translation>
    </message>
    <message>
        <source>Of the patients in</source>
        <translation>De los pacientes en</translation>
    </message>
    <message>
        <source>Of the case</source>
        <translation>Del caso</translation>
    </message>
    <message>
        <source>Of the livers in</source>
        <translation>De los hígados en</translation>
    </message>
    <message>
        <source>Of the scans in</source>
        <translation>De los escaneos en</translation>
    </message>
    <message>
        <source>No folder: simulated patients</source>
        <translation>Sin carpeta: pacientes simulados</translation>
    </message>
    <message>
        <source>Open a case, or choose one</source>
        <translation>Abra un caso o elija uno</translation>
    </message>
    <message>
        <source>Choose a folder of label maps</source>
        <translation>Elija una carpeta de mapas de etiquetas</translation>
    </message>
    <message>
        <source>No folder: simulated scans</source>
        <translation>Sin carpeta: escaneos simulados</translation>
    </message>
    <message>
        <source>The folder with the patients or scans, or a case</source>
        <translation>La carpeta con los pacientes o escaneos, o un caso</translation>
    </message>
    <message>
        <source>The folder for the results</source>
        <translation>La carpeta de los resultados</translation>
    </message>
    <message>
        <source>The folder that a study is written to</source>
        <translation>La carpeta en la que se escribe un estudio</translation>
    </message>
    <message>
        <source>Patients done: %1</source>
        <translation>Pacientes hechos: %1</translation>
    </message>
    <message>
        <source>Could not be used: %1</source>
        <translation>No se pudieron usar: %1</translation>
    </message>
    <message>
        <source>Start a study, or follow a folder that another program fills.</source>
        <translation>Empiece un estudio, o siga una carpeta que otro programa llena.</translation>
    </message>
    <message>
        <source>Stopping...</source>
        <translation>Parando...</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Hecho.</translation>
    </message>
    <message>
        <source>Stopped. Started again, it goes on from there.</source>
        <translation>Parado. Empezado de nuevo, sigue desde ahí.</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Elegir...</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Without a folder</source>
        <translation>Sin carpeta</translation>
    </message>
    <message>
        <source>Simulated patients</source>
        <translation>Pacientes simulados</translation>
    </message>
    <message>
        <source>Results go to</source>
        <translation>Los resultados van a</translation>
    </message>
    <message>
        <source>A folder. What lies there from an earlier run of the same study is not computed again.</source>
        <translation>Una carpeta. Lo que haya en ella de una ejecución anterior del mismo estudio no se calcula de nuevo.</translation>
    </message>
    <message>
        <source>...</source>
        <translation>...</translation>
    </message>
    <message>
        <source>Choose the folder for the results</source>
        <translation>Elegir la carpeta de los resultados</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>Runs beside the window; closing the window stops it. Started again, it goes on.</source>
        <translation>Se ejecuta junto a la ventana; cerrarla lo para. Empezado de nuevo, continúa.</translation>
    </message>
    <message>
        <source>Follow a folder...</source>
        <translation>Seguir una carpeta...</translation>
    </message>
    <message>
        <source>Shows what another program, or a cluster, writes to a study&apos;s folder</source>
        <translation>Muestra lo que otro programa, o un clúster, escribe en la carpeta de un estudio</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>What is done stays</source>
        <translation>Lo hecho se conserva</translation>
    </message>
    <message>
        <source>Open the page</source>
        <translation>Abrir la página</translation>
    </message>
    <message>
        <source>The study&apos;s report, in the browser</source>
        <translation>El informe del estudio, en el navegador</translation>
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
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Find images, say what each series is for, and see what the case holds.</source>
        <translation>Buscar imágenes, decir para qué es cada serie y ver qué contiene el caso.</translation>
    </message>
    <message>
        <source>Looking for images</source>
        <translation>Buscando imágenes</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Look in a folder...</source>
        <translation>Buscar en una carpeta…</translation>
    </message>
    <message>
        <source>A folder, a DICOMDIR or one file; dropping it on the window does the same</source>
        <translation>Una carpeta, un DICOMDIR o un archivo; soltarlo en la ventana hace lo mismo</translation>
    </message>
    <message>
        <source>Keep the case as</source>
        <translation>Guardar el caso como</translation>
    </message>
    <message>
        <source>Make a case</source>
        <translation>Crear un caso</translation>
    </message>
    <message>
        <source>Add to the open case</source>
        <translation>Añadir al caso abierto</translation>
    </message>
    <message>
        <source>Drop a folder of DICOM images, a DICOMDIR, or a NIfTI, NRRD or MHA file here.</source>
        <translation>Suelte aquí una carpeta de imágenes DICOM, un DICOMDIR o un archivo NIfTI, NRRD o MHA.</translation>
    </message>
    <message>
        <source>%1: series found: %2</source>
        <translation>%1: series encontradas: %2</translation>
    </message>
    <message>
        <source>; files left out: %1</source>
        <translation>; archivos omitidos: %1</translation>
    </message>
    <message>
        <source>Give at least one series a role first.</source>
        <translation>Dé primero una función a al menos una serie.</translation>
    </message>
    <message>
        <source>There is something of that name already: choose another.</source>
        <translation>Ya existe algo con ese nombre: elija otro.</translation>
    </message>
    <message>
        <source>Copies the chosen series into a new case</source>
        <translation>Copia las series elegidas en un caso nuevo</translation>
    </message>
    <message>
        <source>No case is open.</source>
        <translation>No hay ningún caso abierto.</translation>
    </message>
    <message>
        <source>Patients&apos; names are neither shown nor kept: a case keeps a hash of them. The images are never written to.</source>
        <translation>Los nombres de los pacientes ni se muestran ni se guardan: un caso guarda solo un resumen de ellos. Nunca se escribe en las imágenes.</translation>
    </message>
    <message>
        <source>Labels need the images that they were drawn on: give one series another role.</source>
        <translation>Las etiquetas necesitan las imágenes sobre las que se dibujaron: dé otro papel a una serie.</translation>
    </message>
    <message>
        <source>Glisson asks before anything is replaced; Ctrl+Z brings it back</source>
        <translation>Glisson pregunta antes de reemplazar nada; Ctrl+Z lo recupera</translation>
    </message>
    <message>
        <source>Open images: a folder, or a file of them</source>
        <translation>Abrir imágenes: una carpeta o uno de sus archivos</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StudyPanel</name>
    <message>
        <source>Slices show</source>
        <translation>Los cortes muestran</translation>
    </message>
    <message>
        <source>Anatomy</source>
        <translation>Anatomía</translation>
    </message>
    <message>
        <source>Stiffness (MR elastography)</source>
        <translation>Rigidez (elastografía por RM)</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Estructuras</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Estructura</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>No patient open</source>
        <translation>Ningún paciente abierto</translation>
    </message>
    <message>
        <source>%1 cells
Young&apos;s modulus %2 kPa (mean)</source>
        <translation>%1 celdas
Módulo de Young %2 kPa (media)</translation>
    </message>
    <message>
        <source>%1 voxels,
%2 each</source>
        <translation>%1 vóxeles,
de %2 cada uno</translation>
    </message>
    <message>
        <source>%1 cells
Young&apos;s modulus %2 kPa (assumed)</source>
        <translation>%1 celdas
Módulo de Young %2 kPa (supuesto)</translation>
    </message>
    <message>
        <source>%1 (fixed)</source>
        <translation>%1 (fijo)</translation>
    </message>
    <message>
        <source>No part of the model: drawn where it was outlined, it does not move.</source>
        <translation>No es parte del modelo: se dibuja donde se contorneó y no se mueve.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StudyRun</name>
    <message>
        <source>%1 could not be started: it belongs beside this program. Install Glisson again.</source>
        <translation>No se pudo iniciar %1: debe estar junto a este programa. Instale Glisson de nuevo.</translation>
    </message>
    <message>
        <source>The study ended without saying why. Start it again.</source>
        <translation>El estudio terminó sin decir por qué. Empiécelo de nuevo.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TakingIn</name>
    <message>
        <source>Looking at the labels</source>
        <translation>Examinando las etiquetas</translation>
    </message>
    <message>
        <source>The case %1 has an anatomy already. These images would replace it; what was outlined and modelled on it then no longer fits.</source>
        <translation>El caso %1 ya tiene una anatomía. Estas imágenes la reemplazarían; lo que se contorneó y modeló sobre ella dejaría de encajar.</translation>
    </message>
    <message>
        <source>Replace the anatomy?</source>
        <translation>¿Reemplazar la anatomía?</translation>
    </message>
    <message>
        <source>Is it this patient?</source>
        <translation>¿Es este paciente?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>Add all the same</source>
        <translation>Añadir de todos modos</translation>
    </message>
    <message>
        <source>Importing</source>
        <translation>Importando</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TargetTable</name>
    <message>
        <source>What is drawn, and how far it may be off</source>
        <translation>Lo dibujado y cuánto puede desviarse</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>sd</source>
        <translation>σ</translation>
    </message>
    <message>
        <source>90 %</source>
        <translation>90 %</translation>
    </message>
    <message>
        <source>deep</source>
        <translation>prof.</translation>
    </message>
    <message>
        <source>Standard deviation of each coordinate of the error, mm: the largest over the structure</source>
        <translation>Desviación estándar de cada coordenada del error, mm: la mayor de la estructura</translation>
    </message>
    <message>
        <source>90 of 100 such places are off by this at most, mm: 2.5 sd</source>
        <translation>90 de cada 100 puntos así se desvían esto como mucho, mm: 2.5 σ</translation>
    </message>
    <message>
        <source>How far its nearest place lies behind the liver&apos;s front, along the line of sight, mm</source>
        <translation>A qué distancia está su punto más próximo detrás del frente del hígado, en la línea de visión, mm</translation>
    </message>
    <message>
        <source>Do not trust it at %1 mm</source>
        <translation>No fiarse a %1 mm</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::Timeline</name>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Un fotograma atrás</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>Un fotograma adelante</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Fotograma</translation>
    </message>
    <message>
        <source>No frames</source>
        <translation>Sin fotogramas</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Fotograma %1 de %2</translation>
    </message>
    <message>
        <source>Open a sequence first</source>
        <translation>Abra primero una secuencia</translation>
    </message>
    <message>
        <source>Plays the video at 15 frames a second, round and round (Space)</source>
        <translation>Reproduce el vídeo a 15 fotogramas por segundo, en bucle (Espacio)</translation>
    </message>
    <message>
        <source>One frame back (Left)</source>
        <translation>Un fotograma atrás (Izquierda)</translation>
    </message>
    <message>
        <source>One frame on (Right)</source>
        <translation>Un fotograma adelante (Derecha)</translation>
    </message>
    <message>
        <source>The frame that is shown (Left, Right, Page Up, Page Down, Home, End)</source>
        <translation>El fotograma que se muestra (Izquierda, Derecha, RePág, AvPág, Inicio, Fin)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ToolControls</name>
    <message>
        <source>Tool</source>
        <translation>Instrumento</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>Place by click</source>
        <translation>Colocar con un clic</translation>
    </message>
    <message>
        <source>Then click on the liver where the tool is to touch it. By key: Ctrl+T, at the crosshair</source>
        <translation>Haga clic después en el hígado donde deba tocarlo el instrumento. Con el teclado: Ctrl+T, en la cruz</translation>
    </message>
    <message>
        <source>Hoist segment VI</source>
        <translation>Elevar el segmento VI</translation>
    </message>
    <message>
        <source>Puts the tool under the right, lower, rear part of the liver, lifting it to the front and the head</source>
        <translation>Coloca el instrumento bajo la parte derecha, inferior y posterior del hígado y la eleva hacia delante y hacia la cabeza</translation>
    </message>
    <message>
        <source>Hoist to front and head</source>
        <translation>Elevar hacia delante y la cabeza</translation>
    </message>
    <message>
        <source>Pull away from the surface</source>
        <translation>Tirar alejando de la superficie</translation>
    </message>
    <message>
        <source>Push into the surface</source>
        <translation>Empujar contra la superficie</translation>
    </message>
    <message>
        <source>As the arrow was dragged</source>
        <translation>Como se arrastró la flecha</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Touch with the rigid tool itself</source>
        <translation>Tocar con el propio instrumento rígido</translation>
    </message>
    <message>
        <source>The tool&apos;s solid in contact with the liver, and several tools at once. Otherwise the force is spread over a patch.</source>
        <translation>El cuerpo del instrumento en contacto con el hígado, y varios instrumentos a la vez. Si no, la fuerza se reparte sobre una zona.</translation>
    </message>
    <message>
        <source>Several tools at once need rigid tools</source>
        <translation>Varios instrumentos a la vez solo son posibles con instrumentos rígidos</translation>
    </message>
    <message>
        <source>Take the tool away</source>
        <translation>Retirar el instrumento</translation>
    </message>
    <message>
        <source>From %1 N on, strains are outside of the model</source>
        <translation>Desde %1 N, las deformaciones están fuera del modelo</translation>
    </message>
    <message>
        <source>Add another tool</source>
        <translation>Añadir otro instrumento</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TourCard</name>
    <message>
        <source>End the tour</source>
        <translation>Terminar el recorrido</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TracePlot</name>
    <message>
        <source>Time (s)</source>
        <translation>Tiempo (s)</translation>
    </message>
    <message>
        <source>Power (W)</source>
        <translation>Potencia (W)</translation>
    </message>
    <message>
        <source>Power; shaded: a run</source>
        <translation>Potencia; sombreado: una ejecución</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>Reposo</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TraceView</name>
    <message>
        <source>Close the recording</source>
        <translation>Cerrar el registro</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Potencia</translation>
    </message>
    <message>
        <source>Watts per unit</source>
        <translation>Vatios por unidad</translation>
    </message>
    <message>
        <source>1 where the column holds watts, 0.001 for milliwatts; for a current clamp its amperes per volt times the supply&apos;s voltage. Negative turns the sign.</source>
        <translation>1 si la columna contiene vatios, 0.001 para milivatios; para una pinza amperimétrica, sus amperios por voltio por la tensión de alimentación. Negativo cambia el signo.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>rows, one a second</source>
        <translation>filas, una por segundo</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>columna %1</translation>
    </message>
    <message>
        <source>Plan with it</source>
        <translation>Planificar con él</translation>
    </message>
    <message>
        <source>Plan with it as %1</source>
        <translation>Planificar con él como %1</translation>
    </message>
    <message>
        <source>Adds that platform once more, with the idle and active power of this recording</source>
        <translation>Añade esa plataforma otra vez, con la potencia en reposo y bajo carga de este registro</translation>
    </message>
    <message>
        <source>Idle %1 W, the median of the pauses. Under load %2 W more, the median of the runs (there are %3).</source>
        <translation>En reposo %1 W, la mediana de las pausas. Bajo carga %2 W más, la mediana de las ejecuciones (hay %3).</translation>
    </message>
    <message>
        <source>%1 W on average, from %2 to %3 W.</source>
        <translation>%1 W de media, de %2 a %3 W.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TrackControls</name>
    <message>
        <source>❚❚ Freeze</source>
        <translation>❚❚ Congelar</translation>
    </message>
    <message>
        <source>Nothing moves the tool while you look around</source>
        <translation>Nada mueve el instrumento mientras usted observa</translation>
    </message>
    <message>
        <source>▶ Play</source>
        <translation>▶ Reproducir</translation>
    </message>
    <message>
        <source>Shows again what was done, from where the time stands; rests are cut to 1 s</source>
        <translation>Muestra de nuevo lo hecho, desde el tiempo elegido; las pausas se acortan a 1 s</translation>
    </message>
    <message>
        <source>Any moment of this rehearsal, in seconds</source>
        <translation>Cualquier momento de este ensayo, en segundos</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Table...</source>
        <translation>Tabla…</translation>
    </message>
    <message>
        <source>Saves every moment as CSV: tools, forces (N), landmarks (mm)</source>
        <translation>Guarda cada momento como CSV: instrumentos, fuerzas (N), puntos de referencia (mm)</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Olvidar</translation>
    </message>
    <message>
        <source>Forgets what was done so far; the tool stays</source>
        <translation>Olvida lo hecho hasta ahora; el instrumento se queda</translation>
    </message>
    <message>
        <source>Stop (%1 %)</source>
        <translation>Parar (%1 %)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>Save a movie of the rehearsal</source>
        <translation>Guardar una película del ensayo</translation>
    </message>
    <message>
        <source>Movies (*.mp4);;Folder of pictures (*)</source>
        <translation>Películas (*.mp4);;Carpeta de imágenes (*)</translation>
    </message>
    <message>
        <source>Save the rehearsal as a table</source>
        <translation>Guardar el ensayo como tabla</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tablas (*.csv)</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 de %2 s</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>A movie of what the 3D view shows, MP4 or pictures</source>
        <translation>Una película de lo que muestra la vista 3D: MP4 o imágenes</translation>
    </message>
    <message>
        <source>Move a tool first: there is nothing to show yet</source>
        <translation>Mueva primero un instrumento: aún no hay nada que mostrar</translation>
    </message>
    <message>
        <source>Movie...</source>
        <translation>Película…</translation>
    </message>
    <message>
        <source>Stopped. No movie was written.</source>
        <translation>Detenido. No se ha escrito ninguna película.</translation>
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
        <translation>Error del atlas</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>5 mm</source>
        <translation>5 mm</translation>
    </message>
    <message>
        <source>Moves at most</source>
        <translation>Se mueve como máximo</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TriangleHistory</name>
    <message>
        <source>A triangle over the frames</source>
        <translation>Un triángulo a lo largo de los fotogramas</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Triángulo</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>The triangle of the left picture whose history is drawn; or click one in a picture</source>
        <translation>El triángulo de la imagen izquierda cuya evolución se dibuja; o haga clic en uno en una imagen</translation>
    </message>
    <message>
        <source>Error (mm)</source>
        <translation>Error (mm)</translation>
    </message>
    <message>
        <source>Motion (mm)</source>
        <translation>Movimiento (mm)</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Fotograma</translation>
    </message>
    <message>
        <source>The chosen triangle over the frames</source>
        <translation>El triángulo elegido a lo largo de los fotogramas</translation>
    </message>
    <message>
        <source>Left: how far the registered corners are from where they are on the model, mm, with the tolerance as a dash-dotted line. Right: what SIRGn&apos;s correlation compares, the motion of the landmarks and of the registration&apos;s warp, mm</source>
        <translation>Izquierda: distancia de los vértices registrados a su lugar en el modelo, mm, con la tolerancia como línea de trazo y punto. Derecha: lo que compara la correlación de SIRGn, el movimiento de los puntos de referencia y el de la deformación del registro, mm</translation>
    </message>
    <message>
        <source>Landmarks, %1</source>
        <translation>Puntos de referencia, %1</translation>
    </message>
    <message>
        <source>Warp, %1</source>
        <translation>Deformación, %1</translation>
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
        <translation>Cada fotograma de todo el registro. Izquierda: a qué distancia están los puntos de referencia registrados de su lugar en el modelo, mm, con la tolerancia como línea de trazo y punto. Derecha: a qué distancia está la nube registrada del modelo (media cuadrática), mm</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TwoStageControls</name>
    <message>
        <source>Embolised</source>
        <translation>Embolizada</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>The rest grows</source>
        <translation>El resto crece</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>By how much what keeps its portal inflow grows until the cut. On average it was 37.9 % in 44 studies (van Lienden et al. 2013), less in a cirrhotic liver</source>
        <translation>Cuánto crece hasta la sección lo que conserva su aporte portal. De media fue 37.9 % en 44 estudios (van Lienden et al. 2013), menos en un hígado cirrótico</translation>
    </message>
    <message>
        <source>%1 ml lose their portal inflow and shrink.</source>
        <translation>%1 ml pierden su aporte portal y se encogen.</translation>
    </message>
    <message>
        <source>%1 ml of what stays grow to &lt;b&gt;%2 ml&lt;/b&gt;: %3 % of the liver without tumours, %4 % now.</source>
        <translation>%1 ml de lo que queda crecen hasta &lt;b&gt;%2 ml&lt;/b&gt;: %3 % del hígado sin tumores, ahora %4 %.</translation>
    </message>
    <message>
        <source>▲ %1 ml of the embolised tissue stay in the patient and are not counted.</source>
        <translation>▲ %1 ml del tejido embolizado quedan en el paciente y no se cuentan.</translation>
    </message>
    <message>
        <source>An estimate by the growth above, not a forecast.</source>
        <translation>Una estimación según el crecimiento de arriba, no un pronóstico.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::Undo</name>
    <message>
        <source>Undone: %1</source>
        <translation>Deshecho: %1</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>Rehecho: %1</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Deshacer: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rehacer: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::UnsurePlaces</name>
    <message>
        <source>Next unsure place</source>
        <translation>Siguiente lugar dudoso</translation>
    </message>
    <message>
        <source>Where is it unsure?</source>
        <translation>¿Dónde hay dudas?</translation>
    </message>
    <message>
        <source>Goes to where the chosen outline lies on tissue that looks alike on both sides, as towards the heart</source>
        <translation>Va adonde el contorno elegido cae sobre tejido que se ve igual a ambos lados, como hacia el corazón</translation>
    </message>
    <message>
        <source>Looking along the border...</source>
        <translation>Recorriendo el borde...</translation>
    </message>
    <message>
        <source>%1 % of the border looks alike on both sides. Place %2 of %3 lies under the crosshair: draw it as you see it.</source>
        <translation>El %1 % del borde se ve igual a ambos lados. El lugar %2 de %3 está bajo la cruz: dibuje lo que vea allí.</translation>
    </message>
    <message>
        <source>No larger part of the border is unsure (%1 % in all).</source>
        <translation>Ninguna parte mayor del borde es dudosa (%1 % en total).</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::VesselClick</name>
    <message>
        <source>Lies at the crosshair</source>
        <translation>Está en la cruz</translation>
    </message>
    <message>
        <source>Put the crosshair on this vessel, in the middle of its course. Vessels and segments are found again by it</source>
        <translation>Ponga la cruz sobre este vaso, en la mitad de su recorrido. Los vasos y los segmentos se hallan de nuevo según él</translation>
    </message>
    <message>
        <source>First stands the vessel whose place would tell most of the borders of segments</source>
        <translation>Primero está el vaso cuyo lugar más diría de los límites de los segmentos</translation>
    </message>
    <message>
        <source>%1 (%2 ml in doubt)</source>
        <translation>%1 (%2 ml en duda)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::VideoForm</name>
    <message>
        <source>Video</source>
        <translation>Vídeo</translation>
    </message>
    <message>
        <source>Calibration of the camera</source>
        <translation>Calibración de la cámara</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Fotogramas</translation>
    </message>
    <message>
        <source>From frame</source>
        <translation>Desde el</translation>
    </message>
    <message>
        <source>One frame in</source>
        <translation>Uno de cada</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Como máximo</translation>
    </message>
    <message>
        <source>The first frame that is taken, counted from 1</source>
        <translation>El primer fotograma que se toma, contado desde 1</translation>
    </message>
    <message>
        <source>1 takes every frame, 5 every fifth</source>
        <translation>1 toma todos los fotogramas, 5 uno de cada cinco</translation>
    </message>
    <message>
        <source>So many frames are taken at most; each takes up to a second</source>
        <translation>Se toman como máximo tantos fotogramas; cada uno tarda hasta un segundo</translation>
    </message>
    <message>
        <source>Choose the video.</source>
        <translation>Elija el vídeo.</translation>
    </message>
    <message>
        <source>Choose the left eye&apos;s video.</source>
        <translation>Elija el vídeo del ojo izquierdo.</translation>
    </message>
    <message>
        <source>Choose the right eye&apos;s video.</source>
        <translation>Elija el vídeo del ojo derecho.</translation>
    </message>
    <message>
        <source>Choose the camera&apos;s calibration.</source>
        <translation>Elija la calibración de la cámara.</translation>
    </message>
    <message>
        <source>Choose the pictures of the board.</source>
        <translation>Elija las imágenes del tablero.</translation>
    </message>
    <message>
        <source>Say where to keep the sequence.</source>
        <translation>Diga dónde guardar la secuencia.</translation>
    </message>
    <message>
        <source>A video file, or a folder of its pictures</source>
        <translation>Un archivo de vídeo, o una carpeta con sus imágenes</translation>
    </message>
    <message>
        <source>Two videos, one for each eye</source>
        <translation>Dos vídeos, uno para cada ojo</translation>
    </message>
    <message>
        <source>One video, left eye on the left</source>
        <translation>Un vídeo, ojo izquierdo a la izquierda</translation>
    </message>
    <message>
        <source>One video, left eye on the right</source>
        <translation>Un vídeo, ojo izquierdo a la derecha</translation>
    </message>
    <message>
        <source>One video, left eye above</source>
        <translation>Un vídeo, ojo izquierdo arriba</translation>
    </message>
    <message>
        <source>How the video shows both eyes</source>
        <translation>Cómo muestra el vídeo ambos ojos</translation>
    </message>
    <message>
        <source>How the video, and the pictures of a board, show both eyes</source>
        <translation>Cómo muestran ambos ojos el vídeo y las imágenes de un tablero</translation>
    </message>
    <message>
        <source>Left eye</source>
        <translation>Ojo izquierdo</translation>
    </message>
    <message>
        <source>Right eye</source>
        <translation>Ojo derecho</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>De un archivo</translation>
    </message>
    <message>
        <source>From pictures of a board</source>
        <translation>De imágenes de un tablero</translation>
    </message>
    <message>
        <source>Where the calibration comes from</source>
        <translation>De dónde viene la calibración</translation>
    </message>
    <message>
        <source>Without a calibration, take pictures of a flat board with both eyes, from several sides</source>
        <translation>Sin calibración, tome imágenes de un tablero plano con ambos ojos, desde varios lados</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
    <message>
        <source>JSON, OpenCV&apos;s YAML or XML, or a folder of text files</source>
        <translation>JSON, YAML o XML de OpenCV, o una carpeta de archivos de texto</translation>
    </message>
    <message>
        <source>A folder of pictures or a video: the same board, from at least three sides; ten are better</source>
        <translation>Una carpeta de imágenes o un vídeo: el mismo tablero desde al menos tres lados; mejor diez</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>Tablero de ajedrez</translation>
    </message>
    <message>
        <source>Grid of circles</source>
        <translation>Cuadrícula de círculos</translation>
    </message>
    <message>
        <source>Grid of circles, four of them larger</source>
        <translation>Cuadrícula de círculos, cuatro mayores</translation>
    </message>
    <message>
        <source>Kind of board</source>
        <translation>Tipo de tablero</translation>
    </message>
    <message>
        <source>What is printed on the board</source>
        <translation>Lo que está impreso en el tablero</translation>
    </message>
    <message>
        <source>Inner corners, columns by rows</source>
        <translation>Esquinas interiores, columnas por filas</translation>
    </message>
    <message>
        <source>Circles, columns by rows</source>
        <translation>Círculos, columnas por filas</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Lado de un cuadro</translation>
    </message>
    <message>
        <source>From circle to circle</source>
        <translation>De círculo a círculo</translation>
    </message>
    <message>
        <source>Along a row: a board of 10 x 7 squares has 9 x 6 inner corners</source>
        <translation>Un tablero de 10 x 7 cuadros tiene 9 x 6 esquinas interiores</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Filas</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Measure it: all lengths of the sequence follow from it</source>
        <translation>Mídalo: todas las longitudes de la secuencia dependen de ello</translation>
    </message>
    <message>
        <source>Keep it in</source>
        <translation>Guardar en</translation>
    </message>
    <message>
        <source>A new folder for the clouds, tracks and pictures</source>
        <translation>Una carpeta nueva para nubes, trayectorias e imágenes</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ViewBar</name>
    <message>
        <source>Measure a &amp;distance</source>
        <translation>Medir una &amp;distancia</translation>
    </message>
    <message>
        <source>A distance in mm: click its two ends, or press Enter at the crosshair; Escape gives up</source>
        <translation>Una distancia en mm: haga clic en sus dos extremos, o pulse Intro en la cruz; Esc la cancela</translation>
    </message>
    <message>
        <source>Measure an &amp;angle</source>
        <translation>Medir un &amp;ángulo</translation>
    </message>
    <message>
        <source>An angle in degrees: click one side, the vertex, the other side</source>
        <translation>Un ángulo en grados: haga clic en un lado, el vértice y el otro lado</translation>
    </message>
    <message>
        <source>Measure a &amp;ball</source>
        <translation>Medir una &amp;bola</translation>
    </message>
    <message>
        <source>A ball&apos;s volume in ml: click its centre, then a point of its surface</source>
        <translation>El volumen de una bola en ml: haga clic en su centro y después en un punto de su superficie</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Lists the volume of a structure, in ml</source>
        <translation>Añade a la lista el volumen de una estructura, en ml</translation>
    </message>
    <message>
        <source>&amp;Volume of</source>
        <translation>&amp;Volumen de</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Hígado</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Pulmón</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Hueso</translation>
    </message>
    <message>
        <source>Brightness and contrast of the slices. The presets are for CT; MR has no fixed scale.
By hand: drag with the right button</source>
        <translation>Brillo y contraste de los cortes. Los valores predefinidos son para TC; la RM no tiene escala fija.
A mano: arrastre con el botón derecho</translation>
    </message>
    <message>
        <source>Brightness and contrast</source>
        <translation>Brillo y contraste</translation>
    </message>
    <message>
        <source>&amp;Next brightness and contrast</source>
        <translation>&amp;Siguiente brillo y contraste</translation>
    </message>
    <message>
        <source>Surgeon&apos;s &amp;side</source>
        <translation>&amp;Lado del cirujano</translation>
    </message>
    <message>
        <source>Turns the three slices to where the surgeon stands. By hand: drag the knobs of the crosshair, or Ctrl and drag</source>
        <translation>Gira los tres cortes hacia donde está el cirujano. A mano: arrastre los tiradores de la cruz, o Ctrl y arrastrar</translation>
    </message>
    <message>
        <source>&amp;Four views</source>
        <translation>&amp;Cuatro vistas</translation>
    </message>
    <message>
        <source>3D &amp;large</source>
        <translation>3D &amp;grande</translation>
    </message>
    <message>
        <source>T&amp;hree slices side by side</source>
        <translation>&amp;Tres cortes lado a lado</translation>
    </message>
    <message>
        <source>&amp;One view: the one in use</source>
        <translation>&amp;Una vista: la que se usa</translation>
    </message>
    <message>
        <source>Save the &amp;picture of the view in use...</source>
        <translation>Guardar la &amp;imagen de la vista en uso…</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>What there is no room for here</source>
        <translation>Lo que no cabe aquí</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Propio</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>S&amp;tandard planes</source>
        <translation>Planos es&amp;tándar</translation>
    </message>
    <message>
        <source>Transverse, coronal and sagittal slices again</source>
        <translation>De nuevo cortes transversales, coronales y sagitales</translation>
    </message>
    <message>
        <source>W %1  L %2</source>
        <translation>A %1  N %2</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ViewFrame</name>
    <message>
        <source>Show all four views</source>
        <translation>Mostrar las cuatro vistas</translation>
    </message>
    <message>
        <source>Fill the window with this view</source>
        <translation>Llenar la ventana con esta vista</translation>
    </message>
    <message>
        <source>Save the picture of this view</source>
        <translation>Guardar la imagen de esta vista</translation>
    </message>
    <message>
        <source>What there is no room for here</source>
        <translation>Lo que no cabe aquí</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::VisibleTable</name>
    <message>
        <source>Effect</source>
        <translation>Efecto</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parámetro</translation>
    </message>
    <message>
        <source>Without effect</source>
        <translation>Sin efecto</translation>
    </message>
    <message>
        <source>Seen from</source>
        <translation>Visible desde</translation>
    </message>
    <message>
        <source>In nine of ten such experiments an effect of this size is seen</source>
        <translation>En nueve de cada diez experimentos así se ve un efecto de este tamaño</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>at no size</source>
        <translation>con ningún valor</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::WaveView</name>
    <message>
        <source>Elastography waves</source>
        <translation>Ondas de elastografía</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>A defect in Glisson stopped this: %1</source>
        <translation>Un defecto de Glisson ha interrumpido esto: %1</translation>
    </message>
    <message>
        <source>Inverting the waves</source>
        <translation>Invirtiendo las ondas</translation>
    </message>
    <message>
        <source>Saving the maps</source>
        <translation>Guardando los mapas</translation>
    </message>
    <message>
        <source>The case now holds this stiffness. Build its model anew to use it.</source>
        <translation>El caso contiene ahora esta rigidez. Construya de nuevo su modelo para usarla.</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>as the images say</source>
        <translation>según las imágenes</translation>
    </message>
    <message>
        <source>&amp;Vibration</source>
        <translation>&amp;Vibración</translation>
    </message>
    <message>
        <source>Complex modulus</source>
        <translation>Módulo complejo</translation>
    </message>
    <message>
        <source>Local wavelength</source>
        <translation>Longitud de onda local</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Método</translation>
    </message>
    <message>
        <source>High-pass</source>
        <translation>Paso alto</translation>
    </message>
    <message>
        <source>Curl</source>
        <translation>Rotacional</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>&amp;Long waves</source>
        <translation>Ondas &amp;largas</translation>
    </message>
    <message>
        <source>Compute the stiffness</source>
        <translation>Calcular la rigidez</translation>
    </message>
    <message>
        <source>Shear waves</source>
        <translation>Ondas de cizalla</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>Shear stiffness</source>
        <translation>Rigidez a cizalla</translation>
    </message>
    <message>
        <source>kPa</source>
        <translation>kPa</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Confianza</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Accept into the case</source>
        <translation>Aceptar en el caso</translation>
    </message>
    <message>
        <source>Compute the stiffness from the waves that the case holds.</source>
        <translation>Calcule la rigidez a partir de las ondas que contiene el caso.</translation>
    </message>
    <message>
        <source>Shear stiffness %1 kPa on average over %2 confident voxels, %3 % of the region; middle half %4 to %5 kPa; vibration %6 Hz, wavelength %7 mm</source>
        <translation>Rigidez a cizalla de %1 kPa de media en %2 vóxeles de confianza, el %3 % de la región; mitad central de %4 a %5 kPa; vibración %6 Hz, longitud de onda %7 mm</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>Corte %1 de %2</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::WelcomePage</name>
    <message>
        <source>Plan a liver operation</source>
        <translation>Planificar una operación de hígado</translation>
    </message>
    <message>
        <source>Drop a case or a folder of DICOM images here, or begin with the demo patient.</source>
        <translation>Arrastre aquí un caso o una carpeta de imágenes DICOM, o empiece con el paciente de demostración.</translation>
    </message>
    <message>
        <source>Open the demo patient</source>
        <translation>Abrir el paciente de demostración</translation>
    </message>
    <message>
        <source>Open a case...</source>
        <translation>Abrir un caso…</translation>
    </message>
    <message>
        <source>Open images...</source>
        <translation>Abrir imágenes…</translation>
    </message>
    <message>
        <source>Opened before</source>
        <translation>Abiertos recientemente</translation>
    </message>
    <message>
        <source>Glisson ended unexpectedly. Open %1 as it was</source>
        <translation>Glisson terminó de forma inesperada. Abrir %1 tal como estaba</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::WorkspaceBar</name>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation>%1 (Ctrl+%2)</translation>
    </message>
    <message>
        <source>Research</source>
        <translation>Investigación</translation>
    </message>
</context>
<context>
    <name>parameters</name>
    <message>
        <source>amplitude</source>
        <translation>amplitud</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>ángulo</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>eje</translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation>acimut</translation>
    </message>
    <message>
        <source>center</source>
        <translation>centro</translation>
    </message>
    <message>
        <source>coefficient</source>
        <translation>coeficiente</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>curva</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>retraso</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>profundidad</translation>
    </message>
    <message>
        <source>efficiency</source>
        <translation>rendimiento</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>elevación</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energía</translation>
    </message>
    <message>
        <source>exponent</source>
        <translation>exponente</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>factor</translation>
    </message>
    <message>
        <source>faster</source>
        <translation>más rápido</translation>
    </message>
    <message>
        <source>foundation</source>
        <translation>lecho elástico</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>fricción</translation>
    </message>
    <message>
        <source>full load</source>
        <translation>plena carga</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>ganancia</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>gravedad</translation>
    </message>
    <message>
        <source>length scale</source>
        <translation>escala de longitud</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>límite</translation>
    </message>
    <message>
        <source>loss</source>
        <translation>pérdida</translation>
    </message>
    <message>
        <source>loss ratio</source>
        <translation>factor de pérdida</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>presión</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>radio</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>proporción</translation>
    </message>
    <message>
        <source>resistance</source>
        <translation>resistencia</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>rotación</translation>
    </message>
    <message>
        <source>share</source>
        <translation>parte</translation>
    </message>
    <message>
        <source>slip strain</source>
        <translation>deformación de deslizamiento</translation>
    </message>
    <message>
        <source>slower</source>
        <translation>más lento</translation>
    </message>
    <message>
        <source>static</source>
        <translation>potencia en reposo</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>rigidez</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
    </message>
    <message>
        <source>time constant</source>
        <translation>constante de tiempo</translation>
    </message>
    <message>
        <source>translation</source>
        <translation>traslación</translation>
    </message>
    <message>
        <source>viscosity</source>
        <translation>viscosidad</translation>
    </message>
    <message>
        <source>zero</source>
        <translation>cero</translation>
    </message>
</context>
<context>
    <name>patients</name>
    <message>
        <source>Demo patient</source>
        <translation>Paciente de demostración</translation>
    </message>
</context>
<context>
    <name>structures</name>
    <message>
        <source>Liver</source>
        <translation>Hígado</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>Cyst</source>
        <translation>Quiste</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Vena porta</translation>
    </message>
    <message>
        <source>Hepatic vein</source>
        <translation>Vena hepática</translation>
    </message>
    <message>
        <source>Artery</source>
        <translation>Arteria</translation>
    </message>
    <message>
        <source>Biliary tract</source>
        <translation>Vías biliares</translation>
    </message>
    <message>
        <source>Necrosis</source>
        <translation>Necrosis</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Vesícula biliar</translation>
    </message>
    <message>
        <source>Gastric vein</source>
        <translation>Vena gástrica</translation>
    </message>
    <message>
        <source>Aorta</source>
        <translation>Aorta</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Corazón</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Estómago</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Riñón</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Bazo</translation>
    </message>
    <message>
        <source>Pancreas</source>
        <translation>Páncreas</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Hueso</translation>
    </message>
    <message>
        <source>Hilum</source>
        <translation>Hilio hepático</translation>
    </message>
    <message>
        <source>Vena cava</source>
        <translation>Vena cava</translation>
    </message>
    <message>
        <source>Duodenum</source>
        <translation>Duodeno</translation>
    </message>
    <message>
        <source>Small bowel</source>
        <translation>Intestino delgado</translation>
    </message>
    <message>
        <source>Colon</source>
        <translation>Colon</translation>
    </message>
    <message>
        <source>Esophagus</source>
        <translation>Esófago</translation>
    </message>
    <message>
        <source>Adrenal gland</source>
        <translation>Glándula suprarrenal</translation>
    </message>
    <message>
        <source>Kidney left</source>
        <translation>Riñón izquierdo</translation>
    </message>
    <message>
        <source>Kidney right</source>
        <translation>Riñón derecho</translation>
    </message>
    <message>
        <source>Adrenal gland left</source>
        <translation>Glándula suprarrenal izquierda</translation>
    </message>
    <message>
        <source>Adrenal gland right</source>
        <translation>Glándula suprarrenal derecha</translation>
    </message>
    <message>
        <source>Planned cut</source>
        <translation>Corte previsto</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmentos</translation>
    </message>
</context>
<context>
    <name>studies</name>
    <message>
        <source>Landmarks under an atlas</source>
        <translation>Puntos de referencia bajo un atlas</translation>
    </message>
    <message>
        <source>How far a liver of one published stiffness misplaces a retracted liver&apos;s places, patient by patient (section 4.4).</source>
        <translation>Cuánto desplaza un hígado de una rigidez publicada los lugares de un hígado retraído, paciente a paciente (sección 4.4).</translation>
    </message>
    <message>
        <source>Stiffness of a cohort</source>
        <translation>Rigidez de una cohorte</translation>
    </message>
    <message>
        <source>How stiffness varies between patients and within one, against the atlas (section 4.3).</source>
        <translation>Cómo varía la rigidez entre pacientes y dentro de uno, frente al atlas (sección 4.3).</translation>
    </message>
    <message>
        <source>Beams of one liver</source>
        <translation>Vigas de un hígado</translation>
    </message>
    <message>
        <source>Beams of a case&apos;s softest, stiffest and most uneven tissue against one of its mean (table 4.1).</source>
        <translation>Vigas del tejido más blando, más rígido y más desigual de un caso frente a una de su media (tabla 4.1).</translation>
    </message>
    <message>
        <source>Shapes of livers</source>
        <translation>Formas de hígados</translation>
    </message>
    <message>
        <source>A mean liver and its modes, from a folder of segmented livers, judged on livers left out.</source>
        <translation>Un hígado medio y sus modos, de una carpeta de hígados segmentados, juzgado en hígados dejados fuera.</translation>
    </message>
    <message>
        <source>Pressed phantoms</source>
        <translation>Maniquíes presionados</translation>
    </message>
    <message>
        <source>Silicone pressed by a tool: the simulated surface against the scanned one (section 4.5). Without scans, SIMULATED ones.</source>
        <translation>Silicona presionada por una herramienta: la superficie simulada frente a la escaneada (sección 4.5). Sin escaneos, SIMULADOS.</translation>
    </message>
    <message>
        <source>Stiffness against a testing machine</source>
        <translation>Rigidez frente a una máquina de ensayo</translation>
    </message>
    <message>
        <source>Young&apos;s modulus by elastography beside a testing machine&apos;s, by the dissertation&apos;s own figures (section 4.6).</source>
        <translation>Módulo de Young por elastografía junto al de una máquina de ensayo, con las cifras de la propia tesis (sección 4.6).</translation>
    </message>
    <message>
        <source>Error against resolution</source>
        <translation>Error frente a resolución</translation>
    </message>
    <message>
        <source>How much of a beam&apos;s deflection a coarse model misses (section 6.3.2): what Platform plans by.</source>
        <translation>Cuánta flexión de una viga se le escapa a un modelo grueso (sección 6.3.2): con ello planifica Plataforma.</translation>
    </message>
    <message>
        <source>Matching of shapes</source>
        <translation>Emparejamiento de formas</translation>
    </message>
    <message>
        <source>Energy, bits, memory and time of matching two surfaces (chapter 3), on SIMULATED livers.</source>
        <translation>Energía, bits, memoria y tiempo del emparejamiento de dos superficies (capítulo 3), con hígados SIMULADOS.</translation>
    </message>
    <message>
        <source>Data in place of a law</source>
        <translation>Datos en lugar de una ley</translation>
    </message>
    <message>
        <source>A SIMULATED liver retracted straight from measured strain and stress, beside lines fitted to them (chapter 5).</source>
        <translation>Un hígado SIMULADO, retraído directamente a partir de deformación y tensión medidas, junto a rectas ajustadas (capítulo 5).</translation>
    </message>
</context>
<context>
    <name>tour</name>
    <message>
        <source>Study: the images</source>
        <translation>Estudio: las imágenes</translation>
    </message>
    <message>
        <source>Every case begins with its images. Drop a DICOM folder on the window: Glisson proposes what each series is for, and you correct it. Here you also see what a case still lacks.</source>
        <translation>Todo caso empieza por sus imágenes. Suelte una carpeta DICOM sobre la ventana: Glisson propone para qué sirve cada serie y usted lo corrige. Aquí también ve qué le falta todavía a un caso.</translation>
    </message>
    <message>
        <source>Segment: what is where</source>
        <translation>Segmentar: qué está dónde</translation>
    </message>
    <message>
        <source>The liver, its vessels and tumours as coloured outlines in the slices. Paint, erase, grow and smooth; every step can be undone, even after the case was closed.</source>
        <translation>El hígado, sus vasos y tumores como contornos de color en los cortes. Pinte, borre, haga crecer y suavice; cada paso se puede deshacer, incluso después de cerrar el caso.</translation>
    </message>
    <message>
        <source>Model: how stiff each part is</source>
        <translation>Modelo: la rigidez de cada parte</translation>
    </message>
    <message>
        <source>The liver becomes tetrahedra, and each gets the patient&apos;s own stiffness from MR elastography. What holds the liver in place is shown too.</source>
        <translation>El hígado se convierte en tetraedros y cada uno recibe la rigidez propia del paciente según la elastografía por RM. También se muestra qué sujeta el hígado.</translation>
    </message>
    <message>
        <source>Rehearse: pull, and see</source>
        <translation>Ensayar: tirar y ver</translation>
    </message>
    <message>
        <source>Resect: what is left</source>
        <translation>Resección: lo que queda</translation>
    </message>
    <message>
        <source>A cutting surface divides the liver: volumes of specimen and remnant, the smallest margin to each tumour, and the vessels that are crossed.</source>
        <translation>Una superficie de corte divide el hígado: volúmenes de la pieza y del remanente, el menor margen a cada tumor y los vasos que se cruzan.</translation>
    </message>
    <message>
        <source>Register: can the overlay be trusted</source>
        <translation>Registrar: ¿se puede confiar en la superposición?</translation>
    </message>
    <message>
        <source>Laparoscopic video is registered to the model, and SIRGn shows on each triangle how well, for one algorithm or two side by side.</source>
        <translation>El vídeo laparoscópico se registra con el modelo, y SIRGn muestra en cada triángulo con qué calidad, para un algoritmo o dos en paralelo.</translation>
    </message>
    <message>
        <source>Platform: what to wear</source>
        <translation>Plataforma: qué llevar</translation>
    </message>
    <message>
        <source>Which wearable computer carries this case for as long as the operation takes: frames a second, battery and heat, and why the others do not.</source>
        <translation>Qué ordenador corporal sirve para este caso mientras dure la operación: fotogramas por segundo, batería y calor, y por qué los demás no sirven.</translation>
    </message>
    <message>
        <source>Evidence: where the model is wrong</source>
        <translation>Evidencia: dónde se equivoca el modelo</translation>
    </message>
    <message>
        <source>Measurements are held against the model. What it cannot explain is traced to a cause; you accept that cause for this patient, and can take it back.</source>
        <translation>Las mediciones se comparan con el modelo. Lo que no puede explicar se atribuye a una causa; usted la acepta para este paciente y puede retirarla.</translation>
    </message>
    <message>
        <source>Report: one page</source>
        <translation>Informe: una página</translation>
    </message>
    <message>
        <source>All that was done for this patient, to read, save or print. The name is masked unless you ask for it in the settings.</source>
        <translation>Todo lo hecho para este paciente, para leer, guardar o imprimir. El nombre se oculta salvo que lo pida en los ajustes.</translation>
    </message>
    <message>
        <source>A retractor hoists segment VI. Change the force, or place the tool elsewhere by a click: the table follows each tumour and vessel, and marks what is 5 mm or more off.</source>
        <translation>Un separador eleva el segmento VI. Cambie la fuerza, o coloque el instrumento en otro lugar con un clic: la tabla sigue cada tumor y cada vaso, y marca lo que se desvía 5 mm o más.</translation>
    </message>
    <message>
        <source>Guide: where the tumour is now</source>
        <translation>Guiar: dónde está ahora el tumor</translation>
    </message>
    <message>
        <source>The liver is found on the frames of a laparoscope&apos;s video and follows them. Tumours and vessels are drawn where they lie, dashed where they are not to be trusted.</source>
        <translation>El hígado se halla en los fotogramas de un laparoscopio y los sigue. Tumores y vasos se dibujan donde están, discontinuos donde no hay que fiarse.</translation>
    </message>
</context>
<context>
    <name>vessels</name>
    <message>
        <source>Portal vein</source>
        <translation>Vena porta</translation>
    </message>
    <message>
        <source>Hepatic vein</source>
        <translation>Vena hepática</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>left</source>
        <translation>izquierda</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>media</translation>
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
        <translation>caudada</translation>
    </message>
    <message>
        <source>stem</source>
        <translation>tronco</translation>
    </message>
    <message>
        <source>Middle hepatic vein</source>
        <translation>Vena hepática media</translation>
    </message>
    <message>
        <source>Right hepatic vein</source>
        <translation>Vena hepática derecha</translation>
    </message>
    <message>
        <source>Umbilical portion of the left portal vein</source>
        <translation>Porción umbilical de la vena porta izquierda</translation>
    </message>
    <message>
        <source>Left hepatic vein</source>
        <translation>Vena hepática izquierda</translation>
    </message>
    <message>
        <source>Hepatic artery</source>
        <translation>Arteria hepática</translation>
    </message>
    <message>
        <source>Bile duct</source>
        <translation>Conducto biliar</translation>
    </message>
    <message>
        <source>outside the liver</source>
        <translation>fuera del hígado</translation>
    </message>
</context>
</TS>
