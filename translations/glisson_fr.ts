<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>AskPath</name>
    <message>
        <source>Take this folder</source>
        <translation>Prendre ce dossier</translation>
    </message>
</context>
<context>
    <name>Workspace</name>
    <message>
        <source>Needs a model of the liver: build it first.</source>
        <translation>Il faut un modèle du foie&#xa0;: construisez-le d’abord.</translation>
    </message>
    <message>
        <source>The model is being prepared.</source>
        <translation>Le modèle est en cours de préparation.</translation>
    </message>
</context>
<context>
    <name>effects</name>
    <message>
        <source>Stiffer or softer throughout</source>
        <translation>Partout plus rigide ou plus souple</translation>
    </message>
    <message>
        <source>Stiffens as it deforms</source>
        <translation>Se raidit en se déformant</translation>
    </message>
    <message>
        <source>The support gives way</source>
        <translation>L’appui cède</translation>
    </message>
    <message>
        <source>A hidden stiffer region</source>
        <translation>Une région plus rigide cachée</translation>
    </message>
    <message>
        <source>Creeps under load</source>
        <translation>Flue sous la charge</translation>
    </message>
    <message>
        <source>The force sensor is off</source>
        <translation>Le capteur de force est faussé</translation>
    </message>
    <message>
        <source>Camera and specimen misaligned</source>
        <translation>Caméra et échantillon mal alignés</translation>
    </message>
    <message>
        <source>Stiffer along one direction</source>
        <translation>Plus rigide dans une direction</translation>
    </message>
    <message>
        <source>A stiff capsule around it</source>
        <translation>Une capsule rigide autour</translation>
    </message>
    <message>
        <source>Already loaded at the start</source>
        <translation>Déjà chargé au départ</translation>
    </message>
    <message>
        <source>Softer once it was stretched</source>
        <translation>Plus souple après un premier étirement</translation>
    </message>
    <message>
        <source>Loading and unloading differ</source>
        <translation>Charge et décharge diffèrent</translation>
    </message>
    <message>
        <source>Tension and compression differ</source>
        <translation>Traction et compression diffèrent</translation>
    </message>
    <message>
        <source>The battery&apos;s own resistance</source>
        <translation>La résistance propre de la batterie</translation>
    </message>
    <message>
        <source>Less charge when emptied fast</source>
        <translation>Moins de charge si vidée vite</translation>
    </message>
    <message>
        <source>It warms itself</source>
        <translation>Il se réchauffe lui-même</translation>
    </message>
    <message>
        <source>Voltage falls as it empties</source>
        <translation>La tension baisse en se vidant</translation>
    </message>
    <message>
        <source>Power drawn at rest</source>
        <translation>Puissance au repos</translation>
    </message>
    <message>
        <source>Power drawn by the work</source>
        <translation>Puissance due au travail</translation>
    </message>
    <message>
        <source>Slows down when hot</source>
        <translation>Ralentit à chaud</translation>
    </message>
    <message>
        <source>Sheds heat better or worse</source>
        <translation>Évacue la chaleur mieux ou moins bien</translation>
    </message>
    <message>
        <source>Takes time to warm up</source>
        <translation>Met du temps à chauffer</translation>
    </message>
    <message>
        <source>Power lost in the supply</source>
        <translation>Pertes dans l’alimentation</translation>
    </message>
    <message>
        <source>A smooth correction, no cause</source>
        <translation>Une correction lisse, pas une cause</translation>
    </message>
    <message>
        <source>Waves lose energy on their way</source>
        <translation>Les ondes perdent de l’énergie en chemin</translation>
    </message>
    <message>
        <source>Long waves that compress, besides shear waves</source>
        <translation>De longues ondes de compression, outre celles de cisaillement</translation>
    </message>
    <message>
        <source>Slices seen at different moments</source>
        <translation>Coupes vues à des moments différents</translation>
    </message>
    <message>
        <source>Another stiffness along the border</source>
        <translation>Une autre rigidité le long du bord</translation>
    </message>
    <message>
        <source>Held where nothing was declared</source>
        <translation>Tenu là où rien n’était déclaré</translation>
    </message>
    <message>
        <source>A declared attachment gives way or is missing</source>
        <translation>Une attache déclarée cède ou manque</translation>
    </message>
    <message>
        <source>The neo-Hookean law</source>
        <translation>La loi néo-hookéenne</translation>
    </message>
    <message>
        <source>The law of Mooney and Rivlin</source>
        <translation>La loi de Mooney et Rivlin</translation>
    </message>
    <message>
        <source>The law of Gent and Thomas</source>
        <translation>La loi de Gent et Thomas</translation>
    </message>
    <message>
        <source>The law of Gent</source>
        <translation>La loi de Gent</translation>
    </message>
    <message>
        <source>The law of Arruda and Boyce</source>
        <translation>La loi d&apos;Arruda et Boyce</translation>
    </message>
    <message>
        <source>The law of Ogden</source>
        <translation>La loi d&apos;Ogden</translation>
    </message>
    <message>
        <source>The law of Isihara</source>
        <translation>La loi d&apos;Isihara</translation>
    </message>
    <message>
        <source>The law of Yeoh</source>
        <translation>La loi de Yeoh</translation>
    </message>
    <message>
        <source>Fibres along one direction</source>
        <translation>Fibres dans une direction</translation>
    </message>
    <message>
        <source>The law of Haines and Wilson</source>
        <translation>La loi de Haines et Wilson</translation>
    </message>
    <message>
        <source>Fibres along two directions (Holzapfel)</source>
        <translation>Fibres dans deux directions (Holzapfel)</translation>
    </message>
</context>
<context>
    <name>entries</name>
    <message>
        <source>the image of the anatomy</source>
        <translation>l’image de l’anatomie</translation>
    </message>
    <message>
        <source>the stiffness map</source>
        <translation>la carte de rigidité</translation>
    </message>
    <message>
        <source>the confidence map</source>
        <translation>la carte de confiance</translation>
    </message>
    <message>
        <source>the mesh of the liver</source>
        <translation>le maillage du foie</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>le modèle</translation>
    </message>
    <message>
        <source>the accepted evidence</source>
        <translation>les constats acceptés</translation>
    </message>
    <message>
        <source>the vessel trees</source>
        <translation>les arbres vasculaires</translation>
    </message>
    <message>
        <source>the map of the segments</source>
        <translation>la carte des segments</translation>
    </message>
    <message>
        <source>%1 (label %2)</source>
        <translation>%1 (étiquette %2)</translation>
    </message>
    <message>
        <source>label %1</source>
        <translation>étiquette %1</translation>
    </message>
</context>
<context>
    <name>errors</name>
    <message>
        <source>There is no column &quot;{0}&quot;.</source>
        <translation>Il n’y a pas de colonne «&#xa0;{0}&#xa0;».</translation>
    </message>
    <message>
        <source>The columns are {1}.</source>
        <translation>Les colonnes sont {1}.</translation>
    </message>
    <message>
        <source>{0} has too many columns.</source>
        <translation>{0} a trop de colonnes.</translation>
    </message>
    <message>
        <source>{0} holds no rows of numbers.</source>
        <translation>{0} ne contient aucune ligne de nombres.</translation>
    </message>
    <message>
        <source>The file {0} cannot be read.</source>
        <translation>Le fichier {0} ne peut pas être lu.</translation>
    </message>
    <message>
        <source>Check that it exists and that you may read it.</source>
        <translation>Vérifiez qu’il existe et que vous avez le droit de le lire.</translation>
    </message>
    <message>
        <source>{0} cannot be written: {1}.</source>
        <translation>{0} ne peut pas être écrit&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>Check the folder, your rights there and the free space.</source>
        <translation>Vérifiez le dossier, vos droits sur celui-ci et l’espace libre.</translation>
    </message>
    <message>
        <source>The file {0} has {1} bytes; at most {2} are read.</source>
        <translation>Le fichier {0} a {1} octets&#xa0;; {2} au plus sont lus.</translation>
    </message>
    <message>
        <source>The files that ship with Glisson were not found.</source>
        <translation>Les fichiers livrés avec Glisson n’ont pas été trouvés.</translation>
    </message>
    <message>
        <source>Set GLISSON_RESOURCES to the folder named resources.</source>
        <translation>Donnez à GLISSON_RESOURCES le chemin du dossier resources.</translation>
    </message>
    <message>
        <source>{0} is nested too deep to be one of our files.</source>
        <translation>{0} est imbriqué trop profondément pour être un de nos fichiers.</translation>
    </message>
    <message>
        <source>{0} is not valid JSON at line {1}.</source>
        <translation>{0} n’est pas du JSON valide à la ligne {1}.</translation>
    </message>
    <message>
        <source>Look for a missing comma, quote or bracket there.</source>
        <translation>Cherchez-y une virgule, un guillemet ou un crochet manquant.</translation>
    </message>
    <message>
        <source>{0} holds a number too large for a computer&apos;s arithmetic.</source>
        <translation>{0} contient un nombre trop grand pour l’arithmétique d’un ordinateur.</translation>
    </message>
    <message>
        <source>{0} should be an object in braces.</source>
        <translation>{0} doit être un objet entre accolades.</translation>
    </message>
    <message>
        <source>{0} has a key that is not known: &quot;{1}&quot;.</source>
        <translation>{0} a une clé inconnue&#xa0;: «&#xa0;{1}&#xa0;».</translation>
    </message>
    <message>
        <source>Did you mean &quot;{2}&quot;?</source>
        <translation>Vouliez-vous dire «&#xa0;{2}&#xa0;»&#xa0;?</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>{0} is there already.</source>
        <translation>{0} existe déjà.</translation>
    </message>
    <message>
        <source>Choose another name, or remove it first.</source>
        <translation>Choisissez un autre nom, ou supprimez-le d’abord.</translation>
    </message>
    <message>
        <source>The folder {0} cannot be made: {1}.</source>
        <translation>Le dossier {0} ne peut pas être créé&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>it holds no case.json</source>
        <translation>il ne contient pas de case.json</translation>
    </message>
    <message>
        <source>case.json does not say &quot;format&quot;: &quot;glisson-case/1&quot;</source>
        <translation>case.json n’indique pas &quot;format&quot;: &quot;glisson-case/1&quot;</translation>
    </message>
    <message>
        <source>The case {0} has no {1} yet.</source>
        <translation>Le cas {0} n’a pas encore de {1}.</translation>
    </message>
    <message>
        <source>Import a study first (glisson-cli import).</source>
        <translation>Importez d’abord une étude (glisson-cli import).</translation>
    </message>
    <message>
        <source>Segment it first (glisson-cli segment).</source>
        <translation>Segmentez-le d’abord (glisson-cli segment).</translation>
    </message>
    <message>
        <source>Mesh the liver first (glisson-cli mesh).</source>
        <translation>Maillez d’abord le foie (glisson-cli mesh).</translation>
    </message>
    <message>
        <source>{0} cannot be put in its place: {1}.</source>
        <translation>{0} ne peut pas être mis à sa place&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>{0} is damaged: {1}.</source>
        <translation>{0} est endommagé&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>{0} is not a Glisson case: {1}.</source>
        <translation>{0} n’est pas un cas Glisson&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>Make one with: glisson-cli import STUDY --case NAME.glisson</source>
        <translation>Créez-en un avec&#xa0;: glisson-cli import ETUDE --case NOM.glisson</translation>
    </message>
    <message>
        <source>{0} holds nothing that could be written as {1}.</source>
        <translation>{0} ne contient rien qui puisse être écrit en {1}.</translation>
    </message>
    <message>
        <source>Run the stage that makes it first.</source>
        <translation>Exécutez d’abord l’étape qui le produit.</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Écriture</translation>
    </message>
    <message>
        <source>The study has no series {0}.</source>
        <translation>L’étude n’a pas de série {0}.</translation>
    </message>
    <message>
        <source>glisson-cli scan lists them.</source>
        <translation>glisson-cli scan en donne la liste.</translation>
    </message>
    <message>
        <source>{0} series could be the {1}:{2}</source>
        <translation>{0} séries pourraient être {1}&#xa0;:{2}</translation>
    </message>
    <message>
        <source>Name one with {3} UID.</source>
        <translation>Indiquez-en une avec {3} UID.</translation>
    </message>
    <message>
        <source>No series is recognised as the anatomy.{0}</source>
        <translation>Aucune série n’est reconnue comme anatomie.{0}</translation>
    </message>
    <message>
        <source>glisson-cli scan says what is there, and what was skipped.</source>
        <translation>glisson-cli scan indique ce qui s’y trouve et ce qui a été ignoré.</translation>
    </message>
    <message>
        <source>Name one with --anatomy UID.</source>
        <translation>Indiquez-en une avec --anatomy UID.</translation>
    </message>
    <message>
        <source>Reading the structures</source>
        <translation>Lecture des structures</translation>
    </message>
    <message>
        <source>Saving the mesh</source>
        <translation>Enregistrement du maillage</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>Lecture du maillage</translation>
    </message>
    <message>
        <source>Stiffness of each cell from the MRE map</source>
        <translation>Rigidité de chaque cellule d’après la carte d’ERM</translation>
    </message>
    <message>
        <source>A Young&apos;s modulus of {0} kPa is not possible.</source>
        <translation>Un module de Young de {0} kPa n’est pas possible.</translation>
    </message>
    <message>
        <source>Saving the model</source>
        <translation>Enregistrement du modèle</translation>
    </message>
    <message>
        <source>Give the mesh its stiffness first (glisson-cli stiffness).</source>
        <translation>Donnez d’abord sa rigidité au maillage (glisson-cli stiffness).</translation>
    </message>
    <message>
        <source>The model of {0} has no stiffness.</source>
        <translation>Le modèle de {0} n’a pas de rigidité.</translation>
    </message>
    <message>
        <source>Run glisson-cli stiffness again.</source>
        <translation>Exécutez de nouveau glisson-cli stiffness.</translation>
    </message>
    <message>
        <source>Import a study with MR elastography, or choose --uniform-kPa or --atlas.</source>
        <translation>Importez une étude avec élastographie par RM, ou choisissez --uniform-kPa ou --atlas.</translation>
    </message>
    <message>
        <source>{0} does not hold a simulation&apos;s result: {1}.</source>
        <translation>{0} ne contient pas de résultat de simulation&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>Make one with glisson-cli simulate --out DIR.</source>
        <translation>Produisez-en un avec glisson-cli simulate --out DOSSIER.</translation>
    </message>
    <message>
        <source>result.vtu is missing</source>
        <translation>result.vtu manque</translation>
    </message>
    <message>
        <source>result.json does not say &quot;format&quot;: &quot;glisson-result/1&quot;</source>
        <translation>result.json n’indique pas &quot;format&quot;: &quot;glisson-result/1&quot;</translation>
    </message>
    <message>
        <source>the computation did not converge</source>
        <translation>le calcul n’a pas convergé</translation>
    </message>
    <message>
        <source>The growing left {0} out; it was added to the liver.</source>
        <translation>La croissance avait laissé de côté {0}&#xa0;; la structure a été ajoutée au foie.</translation>
    </message>
    <message>
        <source>Reading the labels</source>
        <translation>Lecture de la segmentation</translation>
    </message>
    <message>
        <source>No voxel of label {0} in {1} lies inside the anatomy.</source>
        <translation>Aucun voxel de l’étiquette {0} de {1} ne se trouve dans l’anatomie.</translation>
    </message>
    <message>
        <source>Check that both belong to the same patient and frame of reference.</source>
        <translation>Vérifiez que les deux appartiennent au même patient et au même référentiel.</translation>
    </message>
    <message>
        <source>{0} has no labelled voxel.</source>
        <translation>{0} n’a aucun voxel étiqueté.</translation>
    </message>
    <message>
        <source>{0} has no label {2}; it holds {1}.</source>
        <translation>{0} n’a pas d’étiquette {2}&#xa0;; il contient {1}.</translation>
    </message>
    <message>
        <source>{0} holds several labels: {1}.</source>
        <translation>{0} contient plusieurs étiquettes&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>Choose one with --label-value.</source>
        <translation>Choisissez-en une avec --label-value.</translation>
    </message>
    <message>
        <source>The magnitude images do not lie on the grid of the waves.</source>
        <translation>Les images de magnitude ne sont pas sur la grille des ondes.</translation>
    </message>
    <message>
        <source>{0} holds no wave or phase images.</source>
        <translation>{0} ne contient pas d’images d’ondes ni de phase.</translation>
    </message>
    <message>
        <source>Import the phase series of an elastography scan (glisson-cli import --phase).</source>
        <translation>Importez la série de phase d’une élastographie (glisson-cli import --phase).</translation>
    </message>
    <message>
        <source>Reading the waves</source>
        <translation>Lecture des ondes</translation>
    </message>
    <message>
        <source>Saving the maps</source>
        <translation>Enregistrement des cartes</translation>
    </message>
    <message>
        <source>{0} is not an experiment of the format &quot;glisson-experiment/1&quot;.</source>
        <translation>{0} n’est pas une expérience au format &quot;glisson-experiment/1&quot;.</translation>
    </message>
    <message>
        <source>An experiment begins with &quot;format&quot;: &quot;glisson-experiment/1&quot; and &quot;kind&quot;.</source>
        <translation>Une expérience commence par &quot;format&quot;: &quot;glisson-experiment/1&quot; et &quot;kind&quot;.</translation>
    </message>
    <message>
        <source>There is no kind of experiment called &quot;{0}&quot;.</source>
        <translation>Il n’y a pas de type d’expérience nommé «&#xa0;{0}&#xa0;».</translation>
    </message>
    <message>
        <source>Line {0} of {1} names {2}, which is not there.</source>
        <translation>La ligne {0} de {1} nomme {2}, qui n’existe pas.</translation>
    </message>
    <message>
        <source>Files are looked for beside the experiment: was it copied without them, or is the name misspelt?</source>
        <translation>Les fichiers sont cherchés à côté de l’expérience&#xa0;: a-t-elle été copiée sans eux, ou le nom est-il mal écrit&#xa0;?</translation>
    </message>
    <message>
        <source>{0} lacks &quot;{1}&quot;.</source>
        <translation>Il manque &quot;{1}&quot; à {0}.</translation>
    </message>
    <message>
        <source>{0} must be a finite number.</source>
        <translation>{0} doit être un nombre fini.</translation>
    </message>
    <message>
        <source>{0} must be above zero.</source>
        <translation>{0} doit être supérieur à zéro.</translation>
    </message>
    <message>
        <source>{0} must be a text in quotes.</source>
        <translation>{0} doit être un texte entre guillemets.</translation>
    </message>
    <message>
        <source>{0} must be three numbers [x, y, z].</source>
        <translation>{0} doit être formé de trois nombres [x, y, z].</translation>
    </message>
    <message>
        <source>&quot;trials&quot; must be a list with at least one trial.</source>
        <translation>&quot;trials&quot; doit être une liste d’au moins un essai.</translation>
    </message>
    <message>
        <source>{0} must be an object in braces.</source>
        <translation>{0} doit être un objet entre accolades.</translation>
    </message>
    <message>
        <source>Two trials have the id &quot;{0}&quot;.</source>
        <translation>Deux essais ont l’identifiant «&#xa0;{0}&#xa0;».</translation>
    </message>
    <message>
        <source>{0} has no column &quot;{1}&quot;, which the experiment names for {2}; line {3} has: {4}.</source>
        <translation>{0} n’a pas de colonne «&#xa0;{1}&#xa0;», que l’expérience nomme pour {2}&#xa0;; la ligne {3} contient&#xa0;: {4}.</translation>
    </message>
    <message>
        <source>Is the name misspelt, or is this the table of another trial?</source>
        <translation>Le nom est-il mal écrit, ou est-ce la table d’un autre essai&#xa0;?</translation>
    </message>
    <message>
        <source>Line {0} of {1} has no number under &quot;{2}&quot;.</source>
        <translation>La ligne {0} de {1} n’a pas de nombre sous «&#xa0;{2}&#xa0;».</translation>
    </message>
    <message>
        <source>Is the table cut off, or written with decimal commas?</source>
        <translation>La table est-elle tronquée, ou écrite avec des virgules décimales&#xa0;?</translation>
    </message>
    <message>
        <source>Time goes back at line {0} of {1}: from {2} s to {3} s.</source>
        <translation>Le temps recule à la ligne {0} de {1}&#xa0;: de {2} s à {3} s.</translation>
    </message>
    <message>
        <source>Are two recordings in one table, or is this not the column of times?</source>
        <translation>Y a-t-il deux enregistrements dans une table, ou n’est-ce pas la colonne des temps&#xa0;?</translation>
    </message>
    <message>
        <source>{0} is {1} kPa, stiffer than any soft tissue.</source>
        <translation>{0} vaut {1} kPa, plus rigide que tout tissu mou.</translation>
    </message>
    <message>
        <source>Was it given in Pa?</source>
        <translation>A-t-il été donné en Pa&#xa0;?</translation>
    </message>
    <message>
        <source>Use the model.json that glisson-cli explain wrote for an experiment of this kind.</source>
        <translation>Utilisez le model.json que glisson-cli explain a écrit pour une expérience de ce type.</translation>
    </message>
    <message>
        <source>{0} is not a model of the format {1}.</source>
        <translation>{0} n’est pas un modèle au format {1}.</translation>
    </message>
    <message>
        <source>{0} was not learnt from an experiment of the kind {1}.</source>
        <translation>{0} n’a pas été appris d’une expérience de type {1}.</translation>
    </message>
    <message>
        <source>{0} is not a complete model.</source>
        <translation>{0} n’est pas un modèle complet.</translation>
    </message>
    <message>
        <source>The effect {0} is unknown to this experiment.</source>
        <translation>L’effet {0} est inconnu de cette expérience.</translation>
    </message>
    <message>
        <source>{0} of {1} is no number.</source>
        <translation>{0} de {1} n’est pas un nombre.</translation>
    </message>
    <message>
        <source>The smooth correction was made for other quantities than this experiment has.</source>
        <translation>La correction lisse a été faite pour d’autres grandeurs que celles de cette expérience.</translation>
    </message>
    <message>
        <source>The smooth correction is not complete.</source>
        <translation>La correction lisse n’est pas complète.</translation>
    </message>
    <message>
        <source>The search for parameters failed: {0}.</source>
        <translation>La recherche des paramètres a échoué&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>The model has no solution where the search ended.</source>
        <translation>Le modèle n’a pas de solution là où la recherche s’est arrêtée.</translation>
    </message>
    <message>
        <source>This experiment proposes no further trials.</source>
        <translation>Cette expérience ne propose pas d’autres essais.</translation>
    </message>
    <message>
        <source>The specimen is stiffer or softer than declared, everywhere and at every load.</source>
        <translation>L’échantillon est plus rigide ou plus souple que déclaré, partout et sous toute charge.</translation>
    </message>
    <message>
        <source>The specimen is not equally stiff under tension and under compression.</source>
        <translation>L’échantillon n’a pas la même rigidité en traction et en compression.</translation>
    </message>
    <message>
        <source>The tissue gets stiffer (or softer) the further it is deformed: its law is not a straight line.</source>
        <translation>Le tissu devient plus rigide (ou plus souple) à mesure qu’il se déforme&#xa0;: sa loi n’est pas une droite.</translation>
    </message>
    <message>
        <source>The tissue gives way slowly under a load that is held, and recovers slowly after it.</source>
        <translation>Le tissu cède lentement sous une charge maintenue, puis récupère lentement.</translation>
    </message>
    <message>
        <source>Once stretched, the tissue stays softer up to the deformation that it has seen (Mullins effect).</source>
        <translation>Une fois étiré, le tissu reste plus souple jusqu’à la déformation déjà subie (effet Mullins).</translation>
    </message>
    <message>
        <source>Less force comes back on the way out than went in on the way in, in every cycle and at any speed.</source>
        <translation>Au retour, la force est moindre qu’à l’aller, à chaque cycle et à toute vitesse.</translation>
    </message>
    <message>
        <source>The load cell is at fault: it does not read zero without load, or its scale is off.</source>
        <translation>Le capteur de force est en défaut&#xa0;: il n’indique pas zéro à vide, ou son échelle est fausse.</translation>
    </message>
    <message>
        <source>The specimen was already loaded when the test began.</source>
        <translation>L’échantillon était déjà chargé au début de l’essai.</translation>
    </message>
    <message>
        <source>The mode &quot;{0}&quot; is not known.</source>
        <translation>Le mode «&#xa0;{0}&#xa0;» n’est pas connu.</translation>
    </message>
    <message>
        <source>The modes are compression, tension and shear.</source>
        <translation>Les modes sont compression, tension et shear.</translation>
    </message>
    <message>
        <source>The declared law &quot;{0}&quot; is not known.</source>
        <translation>La loi déclarée «&#xa0;{0}&#xa0;» n’est pas connue.</translation>
    </message>
    <message>
        <source>The laws are linear and neo-hookean.</source>
        <translation>Les lois sont linear et neo-hookean.</translation>
    </message>
    <message>
        <source>{0} gives &quot;{1}&quot;, which needs the specimen&apos;s {2}.</source>
        <translation>{0} donne &quot;{1}&quot;, qui exige {2} de l’échantillon.</translation>
    </message>
    <message>
        <source>Give the specimen&apos;s diameter_mm (or width_mm and thickness_mm, or area_mm2) and height_mm.</source>
        <translation>Indiquez diameter_mm de l’échantillon (ou width_mm et thickness_mm, ou area_mm2) et height_mm.</translation>
    </message>
    <message>
        <source>In {0} stress and strain mostly have opposite signs.</source>
        <translation>Dans {0}, contrainte et déformation sont le plus souvent de signes opposés.</translation>
    </message>
    <message>
        <source>In compression stretch is below 1, and displacement, force and stress are negative.</source>
        <translation>En compression, l’élongation est inférieure à 1, et le déplacement, la force et la contrainte sont négatifs.</translation>
    </message>
    <message>
        <source>{0} names no column for &quot;stretch&quot; or &quot;displacement_mm&quot;.</source>
        <translation>{0} ne nomme aucune colonne pour &quot;stretch&quot; ou &quot;displacement_mm&quot;.</translation>
    </message>
    <message>
        <source>{0} names no column for &quot;stress_kPa&quot; or &quot;force_N&quot;.</source>
        <translation>{0} ne nomme aucune colonne pour &quot;stress_kPa&quot; ou &quot;force_N&quot;.</translation>
    </message>
    <message>
        <source>Line {0} of {1} gives a stretch of {2}, which no specimen survives.</source>
        <translation>La ligne {0} de {1} donne une élongation de {2}, à laquelle aucun échantillon ne survit.</translation>
    </message>
    <message>
        <source>Is it strain, or a percentage? Stretch is length over length at rest.</source>
        <translation>Est-ce une déformation, ou un pourcentage&#xa0;? L’élongation est la longueur divisée par la longueur au repos.</translation>
    </message>
    <message>
        <source>The material law is used beyond the stretch it allows.</source>
        <translation>La loi du matériau est employée au-delà de l’élongation qu’elle permet.</translation>
    </message>
    <message>
        <source>The specimen in {0} is {1} mm across.</source>
        <translation>L’échantillon de {0} mesure {1} mm.</translation>
    </message>
    <message>
        <source>Is the mesh in metres or micrometres?</source>
        <translation>Le maillage est-il en mètres ou en micromètres&#xa0;?</translation>
    </message>
    <message>
        <source>{0} has no cell array &quot;{1}&quot; with one number a cell.</source>
        <translation>{0} n’a pas de tableau de cellules «&#xa0;{1}&#xa0;» avec un nombre par cellule.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus must be above zero in every cell.</source>
        <translation>Le module de Young doit être supérieur à zéro dans chaque cellule.</translation>
    </message>
    <message>
        <source>{0} must lie between -1 and 0.5, both excluded.</source>
        <translation>{0} doit être compris entre -1 et 0.5, bornes exclues.</translation>
    </message>
    <message>
        <source>Line 1 of {0} names no column &quot;{1}&quot;.</source>
        <translation>La ligne 1 de {0} ne nomme pas de colonne «&#xa0;{1}&#xa0;».</translation>
    </message>
    <message>
        <source>A table of markers has id, rest_x_mm, rest_y_mm, rest_z_mm, x_mm, y_mm, z_mm.</source>
        <translation>Une table de marqueurs contient id, rest_x_mm, rest_y_mm, rest_z_mm, x_mm, y_mm, z_mm.</translation>
    </message>
    <message>
        <source>{0} holds no markers.</source>
        <translation>{0} ne contient pas de marqueurs.</translation>
    </message>
    <message>
        <source>All markers of {0} lie within {1} mm (line 2 on), on a specimen of {2} mm.</source>
        <translation>Tous les marqueurs de {0} tiennent dans {1} mm (à partir de la ligne 2), sur un échantillon de {2} mm.</translation>
    </message>
    <message>
        <source>Are they in metres?</source>
        <translation>Sont-ils en mètres&#xa0;?</translation>
    </message>
    <message>
        <source>Line {0} of {1}: marker {2} lies {3} mm outside the specimen at rest.</source>
        <translation>Ligne {0} de {1}&#xa0;: le marqueur {2} est à {3} mm hors de l’échantillon au repos.</translation>
    </message>
    <message>
        <source>Are markers and mesh in one frame (patient coordinates) and both in mm?</source>
        <translation>Marqueurs et maillage sont-ils dans le même repère (coordonnées du patient) et tous deux en mm&#xa0;?</translation>
    </message>
    <message>
        <source>Line {0} of {1}: marker {2} moved by {3} mm, more than the specimen is long.</source>
        <translation>Ligne {0} de {1}&#xa0;: le marqueur {2} s’est déplacé de {3} mm, plus que la longueur de l’échantillon.</translation>
    </message>
    <message>
        <source>Are the positions in another unit or frame than the positions at rest?</source>
        <translation>Les positions sont-elles dans une autre unité ou un autre repère que les positions au repos&#xa0;?</translation>
    </message>
    <message>
        <source>{0}: a force of {1} N presses no soft specimen.</source>
        <translation>{0}&#xa0;: une force de {1} N ne s’exerce sur aucun échantillon mou.</translation>
    </message>
    <message>
        <source>Was it given in mN?</source>
        <translation>A-t-elle été donnée en mN&#xa0;?</translation>
    </message>
    <message>
        <source>{0} must not be zero.</source>
        <translation>{0} ne doit pas être nul.</translation>
    </message>
    <message>
        <source>Trial {0} (line {1} of {2}) has no samples.</source>
        <translation>L’essai {0} (ligne {1} de {2}) n’a pas de mesures.</translation>
    </message>
    <message>
        <source>Was the recording interrupted?</source>
        <translation>L’enregistrement a-t-il été interrompu&#xa0;?</translation>
    </message>
    <message>
        <source>In trial {0} (line {1} of {2}) time goes back at sample {3}.</source>
        <translation>Dans l’essai {0} (ligne {1} de {2}), le temps recule à la mesure {3}.</translation>
    </message>
    <message>
        <source>Are two recordings in one trial?</source>
        <translation>Y a-t-il deux enregistrements dans un essai&#xa0;?</translation>
    </message>
    <message>
        <source>No sample of trial {0} (line {1} of {2}) names markers.</source>
        <translation>Aucune mesure de l’essai {0} (ligne {1} de {2}) ne nomme de marqueurs.</translation>
    </message>
    <message>
        <source>Preparing the specimen</source>
        <translation>Préparation de l’échantillon</translation>
    </message>
    <message>
        <source>No sample of the experiment has markers.</source>
        <translation>Aucune mesure de l’expérience n’a de marqueurs.</translation>
    </message>
    <message>
        <source>Solved the declared specimen</source>
        <translation>Échantillon déclaré résolu</translation>
    </message>
    <message>
        <source>The specimen&apos;s equations are too badly conditioned to be solved.</source>
        <translation>Les équations de l’échantillon sont trop mal conditionnées pour être résolues.</translation>
    </message>
    <message>
        <source>No equilibrium of a specimen that stiffens so strongly was found under these loads.</source>
        <translation>Aucun équilibre n’a été trouvé sous ces charges pour un échantillon qui se rigidifie autant.</translation>
    </message>
    <message>
        <source>The battery&apos;s voltage falls under load: its own resistance turns energy into heat.</source>
        <translation>La tension de la batterie baisse en charge&#xa0;: sa résistance interne change l’énergie en chaleur.</translation>
    </message>
    <message>
        <source>The battery&apos;s voltage falls under load, and what is lost there is what warms it.</source>
        <translation>La tension de la batterie baisse en charge, et ce qui s’y perd la réchauffe.</translation>
    </message>
    <message>
        <source>The faster the battery is emptied, the less it gives (Peukert).</source>
        <translation>Plus la batterie est vidée vite, moins elle fournit (Peukert).</translation>
    </message>
    <message>
        <source>The battery gives less when it is cold and more when it is warm.</source>
        <translation>La batterie fournit moins à froid et plus à chaud.</translation>
    </message>
    <message>
        <source>The battery&apos;s voltage falls while it empties, which a constant voltage leaves out.</source>
        <translation>La tension de la batterie baisse à mesure qu’elle se vide, ce qu’une tension constante ignore.</translation>
    </message>
    <message>
        <source>The computer draws power whatever it does, more than was declared.</source>
        <translation>L’ordinateur consomme, quoi qu’il fasse, plus de puissance que déclaré.</translation>
    </message>
    <message>
        <source>A part of the power is lost in the supply before it reaches the computer.</source>
        <translation>Une partie de la puissance se perd dans l’alimentation avant d’atteindre l’ordinateur.</translation>
    </message>
    <message>
        <source>The warmer the computer gets, the more power it draws.</source>
        <translation>Plus l’ordinateur chauffe, plus il consomme.</translation>
    </message>
    <message>
        <source>The work itself takes power that was not declared.</source>
        <translation>Le travail lui-même consomme une puissance qui n’était pas déclarée.</translation>
    </message>
    <message>
        <source>The computer slows itself down to stay below a temperature.</source>
        <translation>L’ordinateur se ralentit pour rester sous une température.</translation>
    </message>
    <message>
        <source>Heat leaves the computer better or worse than declared.</source>
        <translation>La chaleur quitte l’ordinateur mieux ou moins bien que déclaré.</translation>
    </message>
    <message>
        <source>The computer takes time to warm up, longer or shorter than declared.</source>
        <translation>L’ordinateur met du temps à chauffer, plus ou moins que déclaré.</translation>
    </message>
    <message>
        <source>&quot;noise&quot; names no quantity, so that nothing can be judged.</source>
        <translation>&quot;noise&quot; ne nomme aucune grandeur, de sorte que rien ne peut être jugé.</translation>
    </message>
    <message>
        <source>Give voltage_V, temperature_C or power_W: the standard deviation of that reading.</source>
        <translation>Indiquez voltage_V, temperature_C ou power_W&#xa0;: l’écart-type de cette mesure.</translation>
    </message>
    <message>
        <source>The law of platforms is constant: a battery that gives all of its energy at any load.</source>
        <translation>La loi des plates-formes est constante&#xa0;: une batterie qui donne toute son énergie sous toute charge.</translation>
    </message>
    <message>
        <source>{0} must not be below zero.</source>
        <translation>{0} ne doit pas être inférieur à zéro.</translation>
    </message>
    <message>
        <source>Line {0} of {1} gives a {2} of {3}, which no worn computer reaches.</source>
        <translation>La ligne {0} de {1} donne {2} = {3}, ce qu’aucun ordinateur porté n’atteint.</translation>
    </message>
    <message>
        <source>{0} has no column for a quantity whose noise is given.</source>
        <translation>{0} n’a pas de colonne pour une grandeur dont le bruit est donné.</translation>
    </message>
    <message>
        <source>The declared figures predict none of the recorded quantities.</source>
        <translation>Les chiffres déclarés ne prédisent aucune des grandeurs enregistrées.</translation>
    </message>
    <message>
        <source>Voltage needs nominal_voltage_V, temperature needs thermal_resistance_C_per_W and a power, power needs a current or a load.</source>
        <translation>La tension exige nominal_voltage_V, la température thermal_resistance_C_per_W et une puissance, la puissance un courant ou une charge.</translation>
    </message>
    <message>
        <source>The model of the platform has no finite answer here.</source>
        <translation>Le modèle de la plateforme n’a pas ici de réponse finie.</translation>
    </message>
    <message>
        <source>it is proportional to the prediction</source>
        <translation>il est proportionnel à la prédiction</translation>
    </message>
    <message>
        <source>it changes with the load</source>
        <translation>il change avec la charge</translation>
    </message>
    <message>
        <source>it changes with time</source>
        <translation>il change avec le temps</translation>
    </message>
    <message>
        <source>it has a mean in some direction</source>
        <translation>il a une moyenne dans une direction</translation>
    </message>
    <message>
        <source>it changes across the specimen</source>
        <translation>il change à travers l’échantillon</translation>
    </message>
    <message>
        <source>it differs from trial to trial</source>
        <translation>il diffère d’un essai à l’autre</translation>
    </message>
    <message>
        <source>it is larger than the noise</source>
        <translation>il est plus grand que le bruit</translation>
    </message>
    <message>
        <source>neighbours are off in the same way</source>
        <translation>des voisins s’écartent de la même façon</translation>
    </message>
    <message>
        <source>trying effects</source>
        <translation>essai des effets</translation>
    </message>
    <message>
        <source>Only an experiment whose trials are measured can be explained.</source>
        <translation>Seule une expérience dont les essais sont mesurés peut être expliquée.</translation>
    </message>
    <message>
        <source>predicting with the declared model</source>
        <translation>prédiction avec le modèle déclaré</translation>
    </message>
    <message>
        <source>weighing the evidence</source>
        <translation>pesée des indices</translation>
    </message>
    <message>
        <source>done</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>No voxel of the stiffness map is reliable: none is positive, confident, inside the organ and {0} mm away from its border at once.</source>
        <translation>Aucun voxel de la carte de rigidité n’est fiable&#xa0;: aucun n’est à la fois positif, de confiance, dans l’organe et à {0} mm de son bord.</translation>
    </message>
    <message>
        <source>Check that map, confidence mask and segmentation belong together, or trust voxels nearer to the border.</source>
        <translation>Vérifiez que la carte, le masque de confiance et la segmentation vont ensemble, ou acceptez des voxels plus près du bord.</translation>
    </message>
    <message>
        <source>The model does not lie in the stiffness map: {0} mm are between their boxes (model around {1}, map around {2}).</source>
        <translation>Le modèle n’est pas dans la carte de rigidité&#xa0;: {0} mm séparent leurs boîtes (modèle autour de {1}, carte autour de {2}).</translation>
    </message>
    <message>
        <source>They are probably in different frames of reference: take the stiffness series of the same study, or register the two.</source>
        <translation>Ils sont probablement dans des référentiels différents&#xa0;: prenez la série de rigidité de la même étude, ou recalez les deux.</translation>
    </message>
    <message>
        <source>There are no cells to give a stiffness to.</source>
        <translation>Il n’y a pas de cellules auxquelles donner une rigidité.</translation>
    </message>
    <message>
        <source>The stiffness map holds no voxels.</source>
        <translation>La carte de rigidité ne contient aucun voxel.</translation>
    </message>
    <message>
        <source>The axes of the stiffness map are not at right angles, so that the nearest voxel is not to be told.</source>
        <translation>Les axes de la carte de rigidité ne sont pas perpendiculaires, de sorte que le voxel le plus proche ne peut être déterminé.</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio must lie in (-1, 0.5], the border must not be negative and the averaging length must be positive; they are {0}, {1} mm and {2} mm.</source>
        <translation>Le coefficient de Poisson doit être dans (-1, 0.5], le bord ne doit pas être négatif et la longueur de moyenne doit être positive&#xa0;; ils valent {0}, {1} mm et {2} mm.</translation>
    </message>
    <message>
        <source>There are no wave or phase images.</source>
        <translation>Il n’y a pas d’images d’ondes ni de phase.</translation>
    </message>
    <message>
        <source>Unwrapping the phase</source>
        <translation>Déroulement de la phase</translation>
    </message>
    <message>
        <source>The waves give no signal inside the organ.</source>
        <translation>Les ondes ne donnent aucun signal dans l’organe.</translation>
    </message>
    <message>
        <source>Check that the segmentation and the wave images belong together.</source>
        <translation>Vérifiez que la segmentation et les images d’ondes vont ensemble.</translation>
    </message>
    <message>
        <source>Inverting the waves</source>
        <translation>Inversion des ondes</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Inversé</translation>
    </message>
    <message>
        <source>Not one voxel could be inverted with confidence: there is no wave in these images, or it drowns in noise.</source>
        <translation>Aucun voxel n’a pu être inversé avec confiance&#xa0;: il n’y a pas d’onde dans ces images, ou elle se noie dans le bruit.</translation>
    </message>
    <message>
        <source>Check that the phase series and the frequency are the right ones.</source>
        <translation>Vérifiez que la série de phase et la fréquence sont les bonnes.</translation>
    </message>
    <message>
        <source>The region lies on another voxel grid than the map.</source>
        <translation>La région est sur une autre grille de voxels que la carte.</translation>
    </message>
    <message>
        <source>The region holds no value.</source>
        <translation>La région ne contient aucune valeur.</translation>
    </message>
    <message>
        <source>The wave images do not all lie on one grid.</source>
        <translation>Les images d’ondes ne sont pas toutes sur une même grille.</translation>
    </message>
    <message>
        <source>The headers do not say at which frequency the organ was shaken.</source>
        <translation>Les en-têtes n’indiquent pas à quelle fréquence l’organe a été mis en vibration.</translation>
    </message>
    <message>
        <source>Give it with --frequency-Hz; liver scans mostly use 60.</source>
        <translation>Indiquez-la avec --frequency-Hz&#xa0;; pour le foie, c’est le plus souvent 60.</translation>
    </message>
    <message>
        <source>A vibration of {0} Hz is not possible.</source>
        <translation>Une vibration de {0} Hz n’est pas possible.</translation>
    </message>
    <message>
        <source>The headers do not say which of the {0} wave images belong to which direction.</source>
        <translation>Les en-têtes n’indiquent pas quelles images, parmi les {0} images d’ondes, appartiennent à quelle direction.</translation>
    </message>
    <message>
        <source>Say how many directions were measured with --directions; mostly 1 or 3.</source>
        <translation>Indiquez avec --directions combien de directions ont été mesurées&#xa0;; le plus souvent 1 ou 3.</translation>
    </message>
    <message>
        <source>{0} wave images cannot be shared out among {1} directions.</source>
        <translation>{0} images d’ondes ne peuvent pas être réparties sur {1} directions.</translation>
    </message>
    <message>
        <source>At {0} Hz direction {1} has {2} instants and the first direction {3}.</source>
        <translation>À {0} Hz, la direction {1} a {2} instants et la première direction {3}.</translation>
    </message>
    <message>
        <source>Only {0} instants of the wave were measured; at least {1} are needed to tell the wave from noise.</source>
        <translation>Seuls {0} instants de l’onde ont été mesurés&#xa0;; il en faut au moins {1} pour distinguer l’onde du bruit.</translation>
    </message>
    <message>
        <source>The curl needs the motion along three known directions, in at least three slices.</source>
        <translation>Le rotationnel exige le mouvement selon trois directions connues, sur au moins trois coupes.</translation>
    </message>
    <message>
        <source>Take long waves off with the high-pass instead.</source>
        <translation>Supprimez plutôt les ondes longues avec le passe-haut.</translation>
    </message>
    <message>
        <source>A cutting plane needs a finite point and a normal that is not zero.</source>
        <translation>Un plan de coupe exige un point fini et une normale non nulle.</translation>
    </message>
    <message>
        <source>A cutting sheet needs 3 to {0} points; there are {1}.</source>
        <translation>Une surface de coupe exige de 3 à {0} points&#xa0;; il y en a {1}.</translation>
    </message>
    <message>
        <source>A point of the cutting sheet is not finite.</source>
        <translation>Un point de la surface de coupe n’est pas fini.</translation>
    </message>
    <message>
        <source>The points of the cutting sheet lie almost on a line, which does not say which way to cut: add points away from it, or give a plane.</source>
        <translation>Les points de la surface de coupe sont presque alignés, ce qui ne dit pas comment couper&#xa0;: ajoutez des points à l’écart, ou donnez un plan.</translation>
    </message>
    <message>
        <source>Points {0} and {1} of the cutting sheet lie above each other: no smooth sheet over their plane passes through both.</source>
        <translation>Les points {0} et {1} de la surface de coupe sont l’un au-dessus de l’autre&#xa0;: aucune surface lisse au-dessus de leur plan ne passe par les deux.</translation>
    </message>
    <message>
        <source>No smooth sheet passes through the points of the cut.</source>
        <translation>Aucune surface lisse ne passe par les points de la section.</translation>
    </message>
    <message>
        <source>The surface is in pieces, between which there is no way along it.</source>
        <translation>La surface est en morceaux entre lesquels aucun chemin ne la suit.</translation>
    </message>
    <message>
        <source>Keep its largest piece.</source>
        <translation>Gardez son plus grand morceau.</translation>
    </message>
    <message>
        <source>Triangle {0} does not fit its neighbours: an edge has more than two triangles, or they are turned against each other.</source>
        <translation>Le triangle {0} ne s’accorde pas avec ses voisins&#xa0;: une arête a plus de deux triangles, ou ils sont orientés en sens contraire.</translation>
    </message>
    <message>
        <source>Heat cannot spread over the surface: it has flat triangles.</source>
        <translation>La chaleur ne peut pas se propager sur la surface&#xa0;: elle a des triangles plats.</translation>
    </message>
    <message>
        <source>{0} cannot be read as a mesh: {1}.</source>
        <translation>{0} ne peut pas être lu comme maillage&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>Open it in ParaView to see whether it is damaged.</source>
        <translation>Ouvrez-le dans ParaView pour voir s’il est endommagé.</translation>
    </message>
    <message>
        <source>it names no dataset</source>
        <translation>il ne nomme aucun jeu de données</translation>
    </message>
    <message>
        <source>its points are not all there</source>
        <translation>ses points ne sont pas tous là</translation>
    </message>
    <message>
        <source>its cell types are not all there</source>
        <translation>ses types de cellules ne sont pas tous là</translation>
    </message>
    <message>
        <source>it has not as many cell types as cells</source>
        <translation>il n’a pas autant de types de cellules que de cellules</translation>
    </message>
    <message>
        <source>a field says not how many arrays it has</source>
        <translation>un champ n’indique pas combien de tableaux il contient</translation>
    </message>
    <message>
        <source>an array before its cells is not all there, or is text</source>
        <translation>un tableau avant ses cellules est incomplet, ou est du texte</translation>
    </message>
    <message>
        <source>{0} has no extension that is known for such a mesh.</source>
        <translation>{0} n’a pas d’extension connue pour un tel maillage.</translation>
    </message>
    <message>
        <source>it holds no points</source>
        <translation>il ne contient pas de points</translation>
    </message>
    <message>
        <source>a cell names a point that does not exist</source>
        <translation>une cellule nomme un point qui n’existe pas</translation>
    </message>
    <message>
        <source>its polygons cannot be cut into triangles</source>
        <translation>ses polygones ne peuvent pas être découpés en triangles</translation>
    </message>
    <message>
        <source>Cell {1} of {0} is a {2} of {3} points; only tetrahedra are used.</source>
        <translation>La cellule {1} de {0} est un {2} de {3} points&#xa0;; seuls les tétraèdres sont utilisés.</translation>
    </message>
    <message>
        <source>Cut it into tetrahedra first, for example with ParaView&apos;s Tetrahedralize.</source>
        <translation>Découpez-le d’abord en tétraèdres, par exemple avec Tetrahedralize de ParaView.</translation>
    </message>
    <message>
        <source>it holds no tetrahedra</source>
        <translation>il ne contient pas de tétraèdres</translation>
    </message>
    <message>
        <source>The header of {0} announces {1} items; a file of {2} bytes cannot hold them.</source>
        <translation>L’en-tête de {0} annonce {1} éléments&#xa0;; un fichier de {2} octets ne peut pas les contenir.</translation>
    </message>
    <message>
        <source>The file is damaged or cut off; get it again from where it came.</source>
        <translation>Le fichier est endommagé ou tronqué&#xa0;; récupérez-le à sa source.</translation>
    </message>
    <message>
        <source>Line {1} of {0} is neither a point nor a face.</source>
        <translation>La ligne {1} de {0} n’est ni un point ni une face.</translation>
    </message>
    <message>
        <source>Line {1} of {0} is not what an OFF file holds there.</source>
        <translation>La ligne {1} de {0} n’est pas ce qu’un fichier OFF contient à cet endroit.</translation>
    </message>
    <message>
        <source>its header is not that of a PLY file</source>
        <translation>son en-tête n’est pas celui d’un fichier PLY</translation>
    </message>
    <message>
        <source>Point {0} of the surface has no finite position.</source>
        <translation>Le point {0} de la surface n’a pas de position finie.</translation>
    </message>
    <message>
        <source>Triangle {0} names point {1}; the surface has {2} points.</source>
        <translation>Le triangle {0} nomme le point {1}&#xa0;; la surface a {2} points.</translation>
    </message>
    <message>
        <source>The surface holds no triangles.</source>
        <translation>La surface ne contient pas de triangles.</translation>
    </message>
    <message>
        <source>The mesh holds no tetrahedra.</source>
        <translation>Le maillage ne contient pas de tétraèdres.</translation>
    </message>
    <message>
        <source>Tetrahedron {0} names point {1}; the mesh has {2} points.</source>
        <translation>Le tétraèdre {0} nomme le point {1}&#xa0;; le maillage a {2} points.</translation>
    </message>
    <message>
        <source>Point {0} of the mesh has no finite position.</source>
        <translation>Le point {0} du maillage n’a pas de position finie.</translation>
    </message>
    <message>
        <source>Tetrahedron {0} is flat or inside out: its volume is {1} mm3.</source>
        <translation>Le tétraèdre {0} est plat ou retourné&#xa0;: son volume est de {1} mm3.</translation>
    </message>
    <message>
        <source>The face of the points {0}, {1} and {2} belongs to {3} tetrahedra; at most two can.</source>
        <translation>La face des points {0}, {1} et {2} appartient à {3} tétraèdres&#xa0;; deux au plus sont possibles.</translation>
    </message>
    <message>
        <source>The mesh falls in {0} parts that share no face, of {1} tetrahedra.</source>
        <translation>Le maillage se divise en {0} parties sans face commune, de {1} tétraèdres.</translation>
    </message>
    <message>
        <source>Keep the largest part, or join them before meshing.</source>
        <translation>Gardez la plus grande partie, ou réunissez-les avant le maillage.</translation>
    </message>
    <message>
        <source>{0} is deflated as a whole, which is not read.</source>
        <translation>{0} est entièrement compressé (deflate), ce qui n’est pas lu.</translation>
    </message>
    <message>
        <source>Convert it first, for example with dcmconv +te.</source>
        <translation>Convertissez-le d’abord, par exemple avec dcmconv +te.</translation>
    </message>
    <message>
        <source>{0} is empty.</source>
        <translation>{0} est vide.</translation>
    </message>
    <message>
        <source>{0} declares a length beyond its end in its first lines.</source>
        <translation>{0} déclare dans ses premières lignes une longueur au-delà de sa fin.</translation>
    </message>
    <message>
        <source>{0} is no DICOM file, nor named as one of the volume files that are read.</source>
        <translation>{0} n’est pas un fichier DICOM, ni nommé comme un des fichiers de volume qui sont lus.</translation>
    </message>
    <message>
        <source>The header of {0} is too large to be that of an image.</source>
        <translation>L’en-tête de {0} est trop grand pour celui d’une image.</translation>
    </message>
    <message>
        <source>{0} is damaged: an item stands outside a sequence at byte {1}.</source>
        <translation>{0} est endommagé&#xa0;: un élément se trouve hors d’une séquence à l’octet {1}.</translation>
    </message>
    <message>
        <source>{0} is damaged: a value without a length stands at byte {1}.</source>
        <translation>{0} est endommagé&#xa0;: une valeur sans longueur se trouve à l’octet {1}.</translation>
    </message>
    <message>
        <source>{0} ends at byte {1}, in the middle of its header.</source>
        <translation>{0} se termine à l’octet {1}, au milieu de son en-tête.</translation>
    </message>
    <message>
        <source>{0} is damaged: the length at byte {1} leaves what encloses it.</source>
        <translation>{0} est endommagé&#xa0;: la longueur à l’octet {1} dépasse ce qui l’entoure.</translation>
    </message>
    <message>
        <source>{0} ends at byte {1}, in the middle of a sequence.</source>
        <translation>{0} se termine à l’octet {1}, au milieu d’une séquence.</translation>
    </message>
    <message>
        <source>{0} is damaged: a sequence holds something else than items at byte {1}.</source>
        <translation>{0} est endommagé&#xa0;: une séquence contient autre chose que des éléments à l’octet {1}.</translation>
    </message>
    <message>
        <source>{0} is damaged: its pixels are not stored in the way its transfer syntax {1} says.</source>
        <translation>{0} est endommagé&#xa0;: ses pixels ne sont pas stockés comme le dit sa syntaxe de transfert {1}.</translation>
    </message>
    <message>
        <source>{0} is cut short: {1} of {2} bytes of its pixels are there.</source>
        <translation>{0} est tronqué&#xa0;: {1} octets de ses pixels sur {2} sont là.</translation>
    </message>
    <message>
        <source>{0} is damaged: its compressed pixels are broken at byte {1}.</source>
        <translation>{0} est endommagé&#xa0;: ses pixels compressés sont corrompus à l’octet {1}.</translation>
    </message>
    <message>
        <source>The pixels of {0} are in too many pieces.</source>
        <translation>Les pixels de {0} sont en trop de morceaux.</translation>
    </message>
    <message>
        <source>{0} is cut short in its compressed pixels, at byte {1}.</source>
        <translation>{0} est tronqué dans ses pixels compressés, à l’octet {1}.</translation>
    </message>
    <message>
        <source>{0} is damaged: no value type is known for what stands at byte {1}.</source>
        <translation>{0} est endommagé&#xa0;: aucun type de valeur n’est connu pour ce qui se trouve à l’octet {1}.</translation>
    </message>
    <message>
        <source>{0} nests its sequences more than {1} deep, which no image does.</source>
        <translation>{0} imbrique ses séquences sur plus de {1} niveaux, ce qu’aucune image ne fait.</translation>
    </message>
    <message>
        <source>Copy the file again from where it came.</source>
        <translation>Copiez de nouveau le fichier depuis sa source.</translation>
    </message>
    <message>
        <source>The compressed pixels of {0} are damaged.</source>
        <translation>Les pixels compressés de {0} sont endommagés.</translation>
    </message>
    <message>
        <source>{0} is compressed in a way that is not read (transfer syntax {1}).</source>
        <translation>{0} est compressé d’une façon qui n’est pas lue (syntaxe de transfert {1}).</translation>
    </message>
    <message>
        <source>Convert it to an uncompressed or JPEG form first.</source>
        <translation>Convertissez-le d’abord en une forme non compressée ou JPEG.</translation>
    </message>
    <message>
        <source>The compressed picture of {0} is {1} x {2} with {3} bits, where its header says {4} x {5} with {6}.</source>
        <translation>L’image compressée de {0} a {1} x {2} pixels à {3} bits, alors que son en-tête indique {4} x {5} à {6}.</translation>
    </message>
    <message>
        <source>{0} lies inside {1}, which is only read.</source>
        <translation>{0} se trouve dans {1}, qui est seulement lu.</translation>
    </message>
    <message>
        <source>Choose a folder elsewhere for the files without identity.</source>
        <translation>Choisissez un autre dossier pour les fichiers sans identité.</translation>
    </message>
    <message>
        <source>removing identity</source>
        <translation>suppression de l’identité</translation>
    </message>
    <message>
        <source>{0} holds no DICOM file.</source>
        <translation>{0} ne contient aucun fichier DICOM.</translation>
    </message>
    <message>
        <source>Give the folder or the file that holds the images.</source>
        <translation>Indiquez le dossier ou le fichier qui contient les images.</translation>
    </message>
    <message>
        <source>{0} cannot be read: {1}.</source>
        <translation>{0} ne peut pas être lu&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>Check the path and your rights there.</source>
        <translation>Vérifiez le chemin et vos droits.</translation>
    </message>
    <message>
        <source>{0} holds no image, or is damaged.</source>
        <translation>{0} ne contient pas d’image, ou est endommagé.</translation>
    </message>
    <message>
        <source>{0} declares impossible pixels: {1} of {2} bits, the highest {3}.</source>
        <translation>{0} déclare des pixels impossibles&#xa0;: {1} bits sur {2}, le plus haut {3}.</translation>
    </message>
    <message>
        <source>{0} declares compressed pictures too large to be true.</source>
        <translation>{0} déclare des images compressées trop grandes pour être vraies.</translation>
    </message>
    <message>
        <source>{0} holds {1} of the {2} frames that it declares.</source>
        <translation>{0} contient {1} des {2} images qu’il déclare.</translation>
    </message>
    <message>
        <source>{0} holds {1} bytes of pixels, but its size in pixels asks for {2}.</source>
        <translation>{0} contient {1} octets de pixels, mais sa taille en exige {2}.</translation>
    </message>
    <message>
        <source>{0} is damaged: its header cannot be understood.</source>
        <translation>{0} est endommagé&#xa0;: son en-tête est incompréhensible.</translation>
    </message>
    <message>
        <source>{0} is DICOM, but holds no picture ({1}).</source>
        <translation>{0} est du DICOM, mais ne contient pas d’image ({1}).</translation>
    </message>
    <message>
        <source>{0} is no directory of DICOM files.</source>
        <translation>{0} n’est pas un répertoire de fichiers DICOM (DICOMDIR).</translation>
    </message>
    <message>
        <source>Open the folder itself instead.</source>
        <translation>Ouvrez plutôt le dossier lui-même.</translation>
    </message>
    <message>
        <source>Export the segmentation again, as binary and uncompressed DICOM SEG.</source>
        <translation>Exportez de nouveau la segmentation, en DICOM SEG binaire et non compressé.</translation>
    </message>
    <message>
        <source>{0} is not a DICOM segmentation.</source>
        <translation>{0} n’est pas une segmentation DICOM.</translation>
    </message>
    <message>
        <source>The segmentation {0} is compressed (or big endian).</source>
        <translation>La segmentation {0} est compressée (ou en big endian).</translation>
    </message>
    <message>
        <source>The segmentation {0} names no segment, or too many for its size: {1}.</source>
        <translation>La segmentation {0} ne nomme aucun segment, ou trop pour sa taille&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>The headers of {0} are damaged.</source>
        <translation>Les en-têtes de {0} sont endommagés.</translation>
    </message>
    <message>
        <source>The segmentation {0} does not say where its frames are: {1}.</source>
        <translation>La segmentation {0} n’indique pas où sont ses images&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>rows, columns, frames or bits</source>
        <translation>lignes, colonnes, images ou bits</translation>
    </message>
    <message>
        <source>pixel spacing</source>
        <translation>espacement des pixels</translation>
    </message>
    <message>
        <source>The frames of the segmentation {0} are not above each other.</source>
        <translation>Les images de la segmentation {0} ne sont pas superposées.</translation>
    </message>
    <message>
        <source>The frames of the segmentation {0} are not evenly spaced.</source>
        <translation>Les images de la segmentation {0} ne sont pas régulièrement espacées.</translation>
    </message>
    <message>
        <source>The segmentation {0} holds fewer frames than it declares.</source>
        <translation>La segmentation {0} contient moins d’images qu’elle n’en déclare.</translation>
    </message>
    <message>
        <source>The segmentation {0} ends before its last frame.</source>
        <translation>La segmentation {0} se termine avant sa dernière image.</translation>
    </message>
    <message>
        <source>There is no segment to write.</source>
        <translation>Il n’y a pas de segment à écrire.</translation>
    </message>
    <message>
        <source>A segmentation needs the identifiers of the study, the series and the frame of reference that it was drawn on.</source>
        <translation>Une segmentation exige les identifiants de l’étude, de la série et du référentiel sur lesquels elle a été dessinée.</translation>
    </message>
    <message>
        <source>The segments {0} and {1} lie on different grids; one file holds one grid.</source>
        <translation>Les segments {0} et {1} sont sur des grilles différentes&#xa0;; un fichier contient une seule grille.</translation>
    </message>
    <message>
        <source>The grid of the segment {0} is skewed, left-handed or too large for DICOM.</source>
        <translation>La grille du segment {0} est oblique, de sens indirect ou trop grande pour DICOM.</translation>
    </message>
    <message>
        <source>The volume holds no voxels, so no series can be written to {0}.</source>
        <translation>Le volume ne contient aucun voxel&#xa0;; aucune série ne peut donc être écrite dans {0}.</translation>
    </message>
    <message>
        <source>The slices have {0} x {1} voxels; DICOM counts rows and columns up to 65535.</source>
        <translation>Les coupes ont {0} x {1} voxels&#xa0;; DICOM compte les lignes et les colonnes jusqu’à 65535.</translation>
    </message>
    <message>
        <source>The series {0} needs the identifiers of its study, of itself and of its frame of reference.</source>
        <translation>La série {0} exige les identifiants de son étude, d’elle-même et de son référentiel.</translation>
    </message>
    <message>
        <source>The volume holds values that are not finite; DICOM cannot.</source>
        <translation>Le volume contient des valeurs non finies&#xa0;; DICOM ne le permet pas.</translation>
    </message>
    <message>
        <source>Slice {0} holds the value {1}, which the rescale {2} x + {3} cannot hold in 16 bits.</source>
        <translation>La coupe {0} contient la valeur {1}, que le changement d’échelle {2} x + {3} ne peut contenir sur 16 bits.</translation>
    </message>
    <message>
        <source>{0} may not be read by you.</source>
        <translation>Vous n’avez pas le droit de lire {0}.</translation>
    </message>
    <message>
        <source>{0} cannot be opened: it has gone, or is no ordinary file.</source>
        <translation>{0} ne peut pas être ouvert&#xa0;: il a disparu, ou n’est pas un fichier ordinaire.</translation>
    </message>
    <message>
        <source>{0} is not any more as it was when the folder was scanned.</source>
        <translation>{0} n’est plus tel qu’au moment de l’examen du dossier.</translation>
    </message>
    <message>
        <source>Scan the folder again.</source>
        <translation>Examinez de nouveau le dossier.</translation>
    </message>
    <message>
        <source>{0} does not say which of its compressed pieces belong to frame {1}.</source>
        <translation>{0} n’indique pas lesquels de ses morceaux compressés appartiennent à l’image {1}.</translation>
    </message>
    <message>
        <source>The series {0} has {1} volumes, counted from 0, and no {2}.</source>
        <translation>La série {0} a {1} volumes, comptés à partir de 0, et pas de {2}.</translation>
    </message>
    <message>
        <source>The series {0} is a segmentation, not an image.</source>
        <translation>La série {0} est une segmentation, pas une image.</translation>
    </message>
    <message>
        <source>Import it as labels of a structure.</source>
        <translation>Importez-la comme étiquettes d’une structure.</translation>
    </message>
    <message>
        <source>The series {0} holds pictures in colour and no values to measure.</source>
        <translation>La série {0} contient des images en couleur et aucune valeur à mesurer.</translation>
    </message>
    <message>
        <source>Choose the grey-scale series that it was made from.</source>
        <translation>Choisissez la série en niveaux de gris dont elle provient.</translation>
    </message>
    <message>
        <source>The series {0} needs {1} GiB of memory, more than this computer has.</source>
        <translation>La série {0} exige {1} Gio de mémoire, plus que n’en a cet ordinateur.</translation>
    </message>
    <message>
        <source>Reading the slices</source>
        <translation>Lecture des coupes</translation>
    </message>
    <message>
        <source>Sorting the series</source>
        <translation>Tri des séries</translation>
    </message>
    <message>
        <source>The folder {0} cannot be read.</source>
        <translation>Le dossier {0} ne peut pas être lu.</translation>
    </message>
    <message>
        <source>Check your rights there.</source>
        <translation>Vérifiez vos droits.</translation>
    </message>
    <message>
        <source>Files found</source>
        <translation>Fichiers trouvés</translation>
    </message>
    <message>
        <source>There is nothing at {0}.</source>
        <translation>Il n’y a rien à {0}.</translation>
    </message>
    <message>
        <source>Check the path.</source>
        <translation>Vérifiez le chemin.</translation>
    </message>
    <message>
        <source>Files looked at</source>
        <translation>Fichiers examinés</translation>
    </message>
    <message>
        <source>The map is in {0}, which is no unit of stiffness.</source>
        <translation>La carte est en {0}, qui n’est pas une unité de rigidité.</translation>
    </message>
    <message>
        <source>The stiffness map holds no value above zero.</source>
        <translation>La carte de rigidité ne contient aucune valeur supérieure à zéro.</translation>
    </message>
    <message>
        <source>It cannot be decided whether the stiffness map is in Pa or kPa: its median, {0}, is no stiffness of soft tissue in either.</source>
        <translation>On ne peut décider si la carte de rigidité est en Pa ou en kPa&#xa0;: sa médiane, {0}, n’est une rigidité de tissu mou dans aucune des deux.</translation>
    </message>
    <message>
        <source>The stiffness map is marked as {0}, but its median, {1}, is a stiffness of soft tissue only in {2}.</source>
        <translation>La carte de rigidité est marquée en {0}, mais sa médiane, {1}, n’est une rigidité de tissu mou qu’en {2}.</translation>
    </message>
    <message>
        <source>Correct the unit in the file after asking where it came from.</source>
        <translation>Corrigez l’unité dans le fichier après vous être renseigné auprès de sa source.</translation>
    </message>
    <message>
        <source>{0} is not a label map: it holds the value {1}.</source>
        <translation>{0} n’est pas une carte d’étiquettes&#xa0;: elle contient la valeur {1}.</translation>
    </message>
    <message>
        <source>A label map holds whole numbers from 0 to 65535.</source>
        <translation>Une carte d’étiquettes contient des nombres entiers de 0 à 65535.</translation>
    </message>
    <message>
        <source>{0} is not of a known kind of volume file.</source>
        <translation>{0} n’est pas d’un type connu de fichier de volume.</translation>
    </message>
    <message>
        <source>Known are .nii, .nii.gz, .nrrd, .nhdr, .mha and .mhd.</source>
        <translation>Sont connus .nii, .nii.gz, .nrrd, .nhdr, .mha et .mhd.</translation>
    </message>
    <message>
        <source>Check that the file is whole, for example by opening it in 3D Slicer.</source>
        <translation>Vérifiez que le fichier est complet, par exemple en l’ouvrant dans 3D Slicer.</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>il est vide</translation>
    </message>
    <message>
        <source>its header is not of that format</source>
        <translation>son en-tête n’est pas de ce format</translation>
    </message>
    <message>
        <source>{0} holds {1} values at each voxel; one is needed.</source>
        <translation>{0} contient {1} valeurs par voxel&#xa0;; il en faut une.</translation>
    </message>
    <message>
        <source>Save one component (or a grey image in place of a colour one).</source>
        <translation>Enregistrez une seule composante (ou une image en gris au lieu d’une image en couleur).</translation>
    </message>
    <message>
        <source>{0} is not a three-dimensional volume: it has {1} axes.</source>
        <translation>{0} n’est pas un volume à trois dimensions&#xa0;: il a {1} axes.</translation>
    </message>
    <message>
        <source>Save one volume (one point in time) to a file.</source>
        <translation>Enregistrez un seul volume (un seul instant) dans un fichier.</translation>
    </message>
    <message>
        <source>The header of {0} gives no usable grid: sizes and spacings must be positive and the axes at right angles.</source>
        <translation>L’en-tête de {0} ne donne pas de grille utilisable&#xa0;: tailles et espacements doivent être positifs et les axes perpendiculaires.</translation>
    </message>
    <message>
        <source>Resample the volume onto a regular grid and save it again.</source>
        <translation>Rééchantillonnez le volume sur une grille régulière et enregistrez-le de nouveau.</translation>
    </message>
    <message>
        <source>{0} is too short: its header declares {1} bytes of voxels and the file can hold {2} at most.</source>
        <translation>{0} est trop court&#xa0;: son en-tête déclare {1} octets de voxels et le fichier peut en contenir {2} au plus.</translation>
    </message>
    <message>
        <source>its numbers are of an unknown type</source>
        <translation>ses nombres sont d’un type inconnu</translation>
    </message>
    <message>
        <source>The supports do not hold the body: it {0}, so no equilibrium exists.</source>
        <translation>Les appuis ne tiennent pas le corps&#xa0;: il {0}, donc aucun équilibre n’existe.</translation>
    </message>
    <message>
        <source>Hold more of it, or put a foundation under part of its surface.</source>
        <translation>Tenez-en une plus grande partie, ou placez une fondation sous une partie de sa surface.</translation>
    </message>
    <message>
        <source>The mesh has {0} cells; at most {1} can be solved.</source>
        <translation>Le maillage a {0} cellules&#xa0;; {1} au plus peuvent être résolues.</translation>
    </message>
    <message>
        <source>Mesh with fewer cells.</source>
        <translation>Maillez avec moins de cellules.</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio must lie between -1 and 0.5, both excluded; it is {0}.</source>
        <translation>Le coefficient de Poisson doit être compris entre -1 et 0.5, bornes exclues&#xa0;; il vaut {0}.</translation>
    </message>
    <message>
        <source>For tissue that is nearly incompressible take 0.45 to 0.499.</source>
        <translation>Pour un tissu presque incompressible, prenez de 0.45 à 0.499.</translation>
    </message>
    <message>
        <source>The density must be a finite number, zero or above.</source>
        <translation>La masse volumique doit être un nombre fini, nul ou positif.</translation>
    </message>
    <message>
        <source>There are {0} values of Young&apos;s modulus for {1} cells.</source>
        <translation>Il y a {0} valeurs du module de Young pour {1} cellules.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of cell {0} is {1} kPa; it must be a number above zero.</source>
        <translation>Le module de Young de la cellule {0} est de {1} kPa&#xa0;; il doit être un nombre supérieur à zéro.</translation>
    </message>
    <message>
        <source>Fill the cells without data before simulating.</source>
        <translation>Complétez les cellules sans données avant de simuler.</translation>
    </message>
    <message>
        <source>The tool at ({0}, {1}, {2}) mm with radius {3} mm touches nothing: the centre of the nearest face of the surface is {4} mm away.</source>
        <translation>L’instrument en ({0}, {1}, {2}) mm, de rayon {3} mm, ne touche rien&#xa0;: le centre de la face la plus proche de la surface est à {4} mm.</translation>
    </message>
    <message>
        <source>Move its centre onto the surface, or make its radius larger than {4} mm.</source>
        <translation>Déplacez son centre sur la surface, ou donnez-lui un rayon supérieur à {4} mm.</translation>
    </message>
    <message>
        <source>Ordering the equations</source>
        <translation>Mise en ordre des équations</translation>
    </message>
    <message>
        <source>Solving for {0} unknowns would take {1} GB of memory; the limit is {2} GB.</source>
        <translation>La résolution pour {0} inconnues exigerait {1} Go de mémoire&#xa0;; la limite est de {2} Go.</translation>
    </message>
    <message>
        <source>Factorising</source>
        <translation>Factorisation</translation>
    </message>
    <message>
        <source>The stiffness matrix is not positive definite (column {0} of {1}).</source>
        <translation>La matrice de rigidité n’est pas définie positive (colonne {0} sur {1}).</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio may be too near 1/2, or cells may be flat: look at the mesh&apos;s quality.</source>
        <translation>Le coefficient de Poisson est peut-être trop proche de 1/2, ou des cellules sont plates&#xa0;: regardez la qualité du maillage.</translation>
    </message>
    <message>
        <source>The solver ran out of memory for {0} unknowns.</source>
        <translation>Le solveur a manqué de mémoire pour {0} inconnues.</translation>
    </message>
    <message>
        <source>Factorised</source>
        <translation>Factorisé</translation>
    </message>
    <message>
        <source>The equilibrium was not found. {0}</source>
        <translation>L’équilibre n’a pas été trouvé. {0}</translation>
    </message>
    <message>
        <source>The body&apos;s answer to a force on its surface was not found: the relative residual stayed at {0}.</source>
        <translation>La réponse du corps à une force sur sa surface n’a pas été trouvée&#xa0;: le résidu relatif est resté à {0}.</translation>
    </message>
    <message>
        <source>The tool at ({0}, {1}, {2}) mm meets no surface on its way.</source>
        <translation>L’instrument en ({0}, {1}, {2}) mm ne rencontre aucune surface sur son chemin.</translation>
    </message>
    <message>
        <source>Move it in front of the liver, or turn it towards it.</source>
        <translation>Déplacez-le devant le foie, ou tournez-le vers lui.</translation>
    </message>
    <message>
        <source>A grasper needs a finite place and a radius above zero.</source>
        <translation>Une pince exige un emplacement fini et un rayon supérieur à zéro.</translation>
    </message>
    <message>
        <source>The grasper holds no point of the surface.</source>
        <translation>La pince ne tient aucun point de la surface.</translation>
    </message>
    <message>
        <source>Move it onto the surface, or open its jaws wider.</source>
        <translation>Déplacez-la sur la surface, ou ouvrez davantage ses mors.</translation>
    </message>
    <message>
        <source>Looking for states that the data know</source>
        <translation>Recherche d’états connus des données</translation>
    </message>
    <message>
        <source>Looking for the equilibrium</source>
        <translation>Recherche de l’équilibre</translation>
    </message>
    <message>
        <source>Solved</source>
        <translation>Résolu</translation>
    </message>
    <message>
        <source>is not held at all</source>
        <translation>n’est pas tenu du tout</translation>
    </message>
    <message>
        <source>can slide in every direction</source>
        <translation>peut glisser dans toutes les directions</translation>
    </message>
    <message>
        <source>The tool of load {0} needs a finite centre and force.</source>
        <translation>L’instrument de la charge {0} exige un centre et une force finis.</translation>
    </message>
    <message>
        <source>The tool of load {0} needs a radius above zero.</source>
        <translation>L’instrument de la charge {0} exige un rayon supérieur à zéro.</translation>
    </message>
    <message>
        <source>The pressure of load {0} is not a finite number.</source>
        <translation>La pression de la charge {0} n’est pas un nombre fini.</translation>
    </message>
    <message>
        <source>The gravity of load {0} is not a finite vector.</source>
        <translation>La pesanteur de la charge {0} n’est pas un vecteur fini.</translation>
    </message>
    <message>
        <source>A material needs at least 3 measurements of strain and stress.</source>
        <translation>Un matériau exige au moins 3 mesures de déformation et de contrainte.</translation>
    </message>
    <message>
        <source>A measurement of strain and stress is not a finite number.</source>
        <translation>Une mesure de déformation et de contrainte n’est pas un nombre fini.</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio must lie between -1 and 0.5, and one neighbour or more is needed for a hull.</source>
        <translation>Le coefficient de Poisson doit être compris entre -1 et 0.5, et il faut au moins un voisin pour une enveloppe.</translation>
    </message>
    <message>
        <source>The measured stress does not grow with the strain.</source>
        <translation>La contrainte mesurée ne croît pas avec la déformation.</translation>
    </message>
    <message>
        <source>Assembling the stiffness</source>
        <translation>Assemblage de la rigidité</translation>
    </message>
    <message>
        <source>Assembled</source>
        <translation>Assemblé</translation>
    </message>
    <message>
        <source>A motion needs a step and a tolerance above zero, and damping not below it.</source>
        <translation>Un mouvement exige un pas et une tolérance supérieurs à zéro, et un amortissement qui ne lui soit pas inférieur.</translation>
    </message>
    <message>
        <source>{0} nodes in this body need more than 5e8 voxels: take fewer.</source>
        <translation>{0} nœuds dans ce corps exigent plus de 5e8 voxels&#xa0;: prenez-en moins.</translation>
    </message>
    <message>
        <source>Spreading the nodes</source>
        <translation>Répartition des nœuds</translation>
    </message>
    <message>
        <source>Measuring how the material sees the body</source>
        <translation>Mesure de la façon dont le matériau voit le corps</translation>
    </message>
    <message>
        <source>{0} nodes, {1} voxels a node and an overlap of {2} cannot be: the last two must be at least 1 and above 1.</source>
        <translation>{0} nœuds, {1} voxels par nœud et un recouvrement de {2} sont impossibles&#xa0;: les deux derniers doivent être au moins 1 et supérieur à 1.</translation>
    </message>
    <message>
        <source>One linear solve a step moves the materials &quot;linear&quot; and &quot;corotational&quot;, without ligaments or a capsule.</source>
        <translation>Une résolution linéaire par pas fait mouvoir les matériaux &quot;linear&quot; et &quot;corotational&quot;, sans ligaments ni capsule.</translation>
    </message>
    <message>
        <source>A tool needs rods with finite ends and a radius above zero, and a pose that turns and moves it.</source>
        <translation>Un instrument exige des tiges aux extrémités finies et de rayon supérieur à zéro, et une pose qui le tourne et le déplace.</translation>
    </message>
    <message>
        <source>{0} must be a name in quotes.</source>
        <translation>{0} doit être un nom entre guillemets.</translation>
    </message>
    <message>
        <source>{0} must be one of {1}.</source>
        <translation>{0} doit être l’un de {1}.</translation>
    </message>
    <message>
        <source>{0} must be a list in brackets.</source>
        <translation>{0} doit être une liste entre crochets.</translation>
    </message>
    <message>
        <source>{0} goes with the material &quot;veronda-westmann&quot;: give both or neither.</source>
        <translation>{0} va avec le matériau &quot;veronda-westmann&quot;&#xa0;: donnez les deux ou aucun.</translation>
    </message>
    <message>
        <source>{0} and &quot;youngs_modulus_kPa&quot; both say how stiff the body is: give one.</source>
        <translation>{0} et &quot;youngs_modulus_kPa&quot; disent tous deux la rigidité du corps&#xa0;: n’en donnez qu’un.</translation>
    </message>
    <message>
        <source>{0} has the same id &quot;{1}&quot; as another.</source>
        <translation>{0} a le même identifiant «&#xa0;{1}&#xa0;» qu’un autre.</translation>
    </message>
    <message>
        <source>{0} needs exactly one of &quot;point_array&quot;, &quot;sphere&quot; and &quot;box&quot;.</source>
        <translation>{0} exige exactement un parmi &quot;point_array&quot;, &quot;sphere&quot; et &quot;box&quot;.</translation>
    </message>
    <message>
        <source>In {0} the box&apos;s min_mm must not exceed its max_mm.</source>
        <translation>Dans {0}, le min_mm de la boîte ne doit pas dépasser son max_mm.</translation>
    </message>
    <message>
        <source>{0} is a ligament: it takes neither &quot;foundation_kPa_per_mm&quot; nor &quot;directions&quot;.</source>
        <translation>{0} est un ligament&#xa0;: il ne prend ni &quot;foundation_kPa_per_mm&quot; ni &quot;directions&quot;.</translation>
    </message>
    <message>
        <source>{0} has both &quot;foundation_kPa_per_mm&quot; and &quot;directions&quot;: a foundation acts in all directions.</source>
        <translation>{0} a à la fois &quot;foundation_kPa_per_mm&quot; et &quot;directions&quot;&#xa0;: une fondation agit dans toutes les directions.</translation>
    </message>
    <message>
        <source>The directions of {0} must be a list such as [&quot;x&quot;, &quot;z&quot;].</source>
        <translation>Les directions de {0} doivent être une liste, par exemple [&quot;x&quot;, &quot;z&quot;].</translation>
    </message>
    <message>
        <source>{0} needs exactly one of &quot;tool&quot;, &quot;pressure_kPa&quot;, &quot;gravity_m_s2&quot; and &quot;gravity_of_patient&quot;.</source>
        <translation>{0} exige exactement un parmi &quot;tool&quot;, &quot;pressure_kPa&quot;, &quot;gravity_m_s2&quot; et &quot;gravity_of_patient&quot;.</translation>
    </message>
    <message>
        <source>{0} must lie between -90 and 90 degrees.</source>
        <translation>{0} doit être compris entre -90 et 90 degrés.</translation>
    </message>
    <message>
        <source>{0} has both &quot;left_tilt_deg&quot; and &quot;right_tilt_deg&quot;: give one.</source>
        <translation>{0} a à la fois &quot;left_tilt_deg&quot; et &quot;right_tilt_deg&quot;&#xa0;: n’en donnez qu’un.</translation>
    </message>
    <message>
        <source>{0} must be true or false.</source>
        <translation>{0} doit être true ou false.</translation>
    </message>
    <message>
        <source>The steps of {0} must be a whole number from 1 to 1000000.</source>
        <translation>Les pas de {0} doivent être un nombre entier de 1 à 1000000.</translation>
    </message>
    <message>
        <source>The nodes of {0} must be a whole number from 1 to 1000000.</source>
        <translation>Les nœuds de {0} doivent être un nombre entier de 1 à 1000000.</translation>
    </message>
    <message>
        <source>The mesh has no cell array {0} with one value a cell.</source>
        <translation>Le maillage n’a pas de tableau de cellules {0} avec une valeur par cellule.</translation>
    </message>
    <message>
        <source>Give the scenario &quot;youngs_modulus_kPa&quot;, a number or the name of a cell array; the mesh&apos;s cell arrays are: {1}.</source>
        <translation>Donnez au scénario &quot;youngs_modulus_kPa&quot;, un nombre ou le nom d’un tableau de cellules&#xa0;; les tableaux de cellules du maillage sont&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>The position of landmark {0} is not a finite point.</source>
        <translation>La position du repère {0} n’est pas un point fini.</translation>
    </message>
    <message>
        <source>Landmark {0} lies {1} mm outside the body.</source>
        <translation>Le repère {0} est à {1} mm hors du corps.</translation>
    </message>
    <message>
        <source>Check that landmarks and mesh are in the same coordinates (LPS, mm).</source>
        <translation>Vérifiez que les repères et le maillage sont dans les mêmes coordonnées (LPS, mm).</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Checking the model</source>
        <translation>Vérification du modèle</translation>
    </message>
    <message>
        <source>A ligament only pulls, so it is not linear: look for the equilibrium by steps.</source>
        <translation>Un ligament ne fait que tirer, il n’est donc pas linéaire&#xa0;: cherchez l’équilibre par pas.</translation>
    </message>
    <message>
        <source>Nodal loads need {0} values: three a node.</source>
        <translation>Les charges nodales exigent {0} valeurs&#xa0;: trois par nœud.</translation>
    </message>
    <message>
        <source>A nodal load is not a finite number.</source>
        <translation>Une charge nodale n’est pas un nombre fini.</translation>
    </message>
    <message>
        <source>Support {0} names no point of the mesh.</source>
        <translation>L’appui {0} ne nomme aucun point du maillage.</translation>
    </message>
    <message>
        <source>Move or enlarge its region, or name another point array.</source>
        <translation>Déplacez ou agrandissez sa région, ou nommez un autre tableau de points.</translation>
    </message>
    <message>
        <source>The foundation of support {0} needs a stiffness above zero, not {1} kPa/mm.</source>
        <translation>La fondation de l’appui {0} exige une rigidité supérieure à zéro, et non {1} kPa/mm.</translation>
    </message>
    <message>
        <source>The foundation of support {0} covers no face: no face of the surface has all three points named.</source>
        <translation>La fondation de l’appui {0} ne couvre aucune face&#xa0;: aucune face de la surface n’a ses trois points nommés.</translation>
    </message>
    <message>
        <source>Move or enlarge its region.</source>
        <translation>Déplacez ou agrandissez sa région.</translation>
    </message>
    <message>
        <source>Support {0} asks for the point array {1}, which the mesh does not have with one value a point.</source>
        <translation>L’appui {0} demande le tableau de points {1}, que le maillage n’a pas avec une valeur par point.</translation>
    </message>
    <message>
        <source>The mesh&apos;s point arrays are: {2}.</source>
        <translation>Les tableaux de points du maillage sont&#xa0;: {2}.</translation>
    </message>
    <message>
        <source>The point array {0} is not a number at point {1}.</source>
        <translation>Le tableau de points {0} n’est pas un nombre au point {1}.</translation>
    </message>
    <message>
        <source>The sphere of support {0} needs a finite centre and a radius above zero.</source>
        <translation>La sphère de l’appui {0} exige un centre fini et un rayon supérieur à zéro.</translation>
    </message>
    <message>
        <source>The box of support {0} needs finite corners, the smaller one first.</source>
        <translation>La boîte de l’appui {0} exige des coins finis, le plus petit d’abord.</translation>
    </message>
    <message>
        <source>The ligament of support {0} needs a finite anchor, a stiffness above zero and a slack not below it.</source>
        <translation>Le ligament de l’appui {0} exige un point d’ancrage fini, une rigidité supérieure à zéro et un mou qui ne soit pas négatif.</translation>
    </message>
    <message>
        <source>The ligament of support {0} names no point of the surface.</source>
        <translation>Le ligament de l’appui {0} ne nomme aucun point de la surface.</translation>
    </message>
    <message>
        <source>There is no published tissue {0}.</source>
        <translation>Il n’y a pas de tissu publié {0}.</translation>
    </message>
    <message>
        <source>The tissues are: {1}.</source>
        <translation>Les tissus sont&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>{0} nodes in {1} rounds cannot be made; both must be at least 1.</source>
        <translation>{0} nœuds en {1} tours sont impossibles&#xa0;; les deux doivent être au moins 1.</translation>
    </message>
    <message>
        <source>The body holds no voxels.</source>
        <translation>Le corps ne contient aucun voxel.</translation>
    </message>
    <message>
        <source>{0} nodes are more than the body has voxels ({1}).</source>
        <translation>{0} nœuds, c’est plus que le corps n’a de voxels ({1}).</translation>
    </message>
    <message>
        <source>The mesh generator gave up: {0}.</source>
        <translation>Le mailleur a abandonné&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Ask for another number of cells, or smooth the labels.</source>
        <translation>Demandez un autre nombre de cellules, ou lissez les étiquettes.</translation>
    </message>
    <message>
        <source>The label map holds no labelled voxel, so there is no body to mesh.</source>
        <translation>La carte d’étiquettes ne contient aucun voxel étiqueté, il n’y a donc pas de corps à mailler.</translation>
    </message>
    <message>
        <source>Segment the liver first.</source>
        <translation>Segmentez d’abord le foie.</translation>
    </message>
    <message>
        <source>The label map has {0} values for a grid of {1} x {2} x {3} voxels.</source>
        <translation>La carte d’étiquettes a {0} valeurs pour une grille de {1} x {2} x {3} voxels.</translation>
    </message>
    <message>
        <source>The label map&apos;s axes are not at right angles, or its spacing is not positive.</source>
        <translation>Les axes de la carte d’étiquettes ne sont pas perpendiculaires, ou son espacement n’est pas positif.</translation>
    </message>
    <message>
        <source>A structure without voxels has no surface.</source>
        <translation>Une structure sans voxels n’a pas de surface.</translation>
    </message>
    <message>
        <source>Preparing the labels</source>
        <translation>Préparation des étiquettes</translation>
    </message>
    <message>
        <source>Removing slivers</source>
        <translation>Suppression des tétraèdres plats</translation>
    </message>
    <message>
        <source>Measuring the distance to the label boundary</source>
        <translation>Mesure de la distance à la limite des étiquettes</translation>
    </message>
    <message>
        <source>The surface of the mesh is not a closed manifold.</source>
        <translation>La surface du maillage n’est pas une variété fermée.</translation>
    </message>
    <message>
        <source>Meshed</source>
        <translation>Maillé</translation>
    </message>
    <message>
        <source>A mesh of {0} cells cannot be made; from {1} to {2} can.</source>
        <translation>Un maillage de {0} cellules est impossible&#xa0;; de {1} à {2}, c’est possible.</translation>
    </message>
    <message>
        <source>The share of cells for inner structures is {0}; it must be in 0 to 1.</source>
        <translation>La part des cellules pour les structures internes est {0}&#xa0;; elle doit être comprise entre 0 et 1.</translation>
    </message>
    <message>
        <source>Filling the body with tetrahedra</source>
        <translation>Remplissage du corps de tétraèdres</translation>
    </message>
    <message>
        <source>A piece of {0} has {1} ml, but its cells only {2} ml: the mesh has lost it.</source>
        <translation>Un morceau de {0} fait {1} ml, mais ses cellules seulement {2} ml&#xa0;: le maillage l’a perdu.</translation>
    </message>
    <message>
        <source>Ask for more cells.</source>
        <translation>Demandez plus de cellules.</translation>
    </message>
    <message>
        <source>A battery with a {0} of {1} does not exist.</source>
        <translation>Une batterie avec {0} = {1} n’existe pas.</translation>
    </message>
    <message>
        <source>Correct the device&apos;s battery.</source>
        <translation>Corrigez la batterie de l’appareil.</translation>
    </message>
    <message>
        <source>A load of {0} W is more than the battery&apos;s internal resistance lets through.</source>
        <translation>Une charge de {0} W dépasse ce que laisse passer la résistance interne de la batterie.</translation>
    </message>
    <message>
        <source>A batch of {0} nodes takes more than the {1} MB there are for it.</source>
        <translation>Un lot de {0} nœuds exige plus que les {1} Mo disponibles.</translation>
    </message>
    <message>
        <source>{0} lacks a reading within the discharge.</source>
        <translation>Il manque à {0} une mesure pendant la décharge.</translation>
    </message>
    <message>
        <source>The time goes back in {0}.</source>
        <translation>Le temps recule dans {0}.</translation>
    </message>
    <message>
        <source>{0} holds no discharge.</source>
        <translation>{0} ne contient pas de décharge.</translation>
    </message>
    <message>
        <source>{0} lacks a reading of the ambient.</source>
        <translation>Il manque à {0} une mesure de l’ambiance.</translation>
    </message>
    <message>
        <source>A cell is set up from one slow discharge and at least two that are five times as fast.</source>
        <translation>Une cellule se détermine par une décharge lente et au moins deux autres cinq fois plus rapides.</translation>
    </message>
    <message>
        <source>A convergence curve has 2 to {0} points; this one has {1}.</source>
        <translation>Une courbe de convergence a de 2 à {0} points&#xa0;; celle-ci en a {1}.</translation>
    </message>
    <message>
        <source>Point {0} of the convergence curve, {1} mm3 and {2} mm, is not positive or does not increase from the point before.</source>
        <translation>Le point {0} de la courbe de convergence, {1} mm3 et {2} mm, n’est pas positif ou n’augmente pas par rapport au précédent.</translation>
    </message>
    <message>
        <source>{0} has no list of points.</source>
        <translation>{0} n’a pas de liste de points.</translation>
    </message>
    <message>
        <source>An accuracy of {0} mm is finer than the convergence study reaches ({1} mm at {2} mm3 a node).</source>
        <translation>Une précision de {0} mm est plus fine que ce qu’atteint l’étude de convergence ({1} mm à {2} mm3 par nœud).</translation>
    </message>
    <message>
        <source>Ask for {1} mm or more.</source>
        <translation>Demandez {1} mm ou plus.</translation>
    </message>
    <message>
        <source>Device {0} has {1} {2}; it must lie between {3} and {4}.</source>
        <translation>L’appareil {0} a {1} {2}&#xa0;; ce doit être entre {3} et {4}.</translation>
    </message>
    <message>
        <source>Correct that figure in the device&apos;s file.</source>
        <translation>Corrigez ce chiffre dans le fichier de l’appareil.</translation>
    </message>
    <message>
        <source>Device {0} has measured points that are not positive, not by increasing nodes, or more than {1}.</source>
        <translation>L’appareil {0} a des points mesurés non positifs, non classés par nœuds croissants, ou plus de {1}.</translation>
    </message>
    <message>
        <source>{0} has no list &quot;devices&quot; of 1 to {1} devices.</source>
        <translation>{0} n’a pas de liste &quot;devices&quot; de 1 à {1} appareils.</translation>
    </message>
    <message>
        <source>Two devices have the id &quot;{0}&quot;.</source>
        <translation>Deux appareils ont l’identifiant «&#xa0;{0}&#xa0;».</translation>
    </message>
    <message>
        <source>Give each its own.</source>
        <translation>Donnez à chacun le sien.</translation>
    </message>
    <message>
        <source>{0} has the id &quot;{1}&quot;.</source>
        <translation>{0} a l’identifiant «&#xa0;{1}&#xa0;».</translation>
    </message>
    <message>
        <source>Use up to 64 small letters, digits and dashes.</source>
        <translation>Employez jusqu’à 64 minuscules, chiffres et traits d’union.</translation>
    </message>
    <message>
        <source>{0} is worn &quot;{1}&quot;.</source>
        <translation>{0} est porté «&#xa0;{1}&#xa0;».</translation>
    </message>
    <message>
        <source>Use head, belt or back.</source>
        <translation>Employez head, belt ou back.</translation>
    </message>
    <message>
        <source>The energy meter {0} stopped answering.</source>
        <translation>Le compteur d’énergie {0} ne répond plus.</translation>
    </message>
    <message>
        <source>No energy counters of the processor (RAPL) at {0}.</source>
        <translation>Pas de compteurs d’énergie du processeur (RAPL) à {0}.</translation>
    </message>
    <message>
        <source>No current sensors (INA) at {0}.</source>
        <translation>Pas de capteurs de courant (INA) à {0}.</translation>
    </message>
    <message>
        <source>The battery is not discharging: unplug the machine to measure by its gauge.</source>
        <translation>La batterie ne se décharge pas&#xa0;: débranchez la machine pour mesurer par sa jauge.</translation>
    </message>
    <message>
        <source>No battery gauge at {0}.</source>
        <translation>Pas de jauge de batterie à {0}.</translation>
    </message>
    <message>
        <source>{0} does not say &quot;format&quot;: &quot;{1}&quot;.</source>
        <translation>{0} n’indique pas &quot;format&quot;: &quot;{1}&quot;.</translation>
    </message>
    <message>
        <source>Check that it is the file you meant.</source>
        <translation>Vérifiez que c’est bien le fichier voulu.</translation>
    </message>
    <message>
        <source>{0} has no &quot;{1}&quot;, or not of the right kind.</source>
        <translation>{0} n’a pas de &quot;{1}&quot;, ou pas du bon type.</translation>
    </message>
    <message>
        <source>The shipped devices.json shows every key.</source>
        <translation>Le fichier devices.json fourni montre toutes les clés.</translation>
    </message>
    <message>
        <source>{0} has &quot;{1}&quot; {2}; it must lie between {3} and {4}.</source>
        <translation>{0} a &quot;{1}&quot; {2}&#xa0;; ce doit être entre {3} et {4}.</translation>
    </message>
    <message>
        <source>{0} has &quot;{1}&quot; empty or longer than {2} characters.</source>
        <translation>{0} a &quot;{1}&quot; vide ou de plus de {2} caractères.</translation>
    </message>
    <message>
        <source>{0} has the source &quot;{1}&quot;.</source>
        <translation>{0} a la source «&#xa0;{1}&#xa0;».</translation>
    </message>
    <message>
        <source>Idle power</source>
        <translation>Puissance au repos</translation>
    </message>
    <message>
        <source>Nothing on this machine tells its energy: idle and active power are assumed. Measure them with a current clamp or a power meter, and give them.</source>
        <translation>Rien sur cette machine n’indique son énergie&#xa0;: les puissances au repos et en charge sont supposées. Mesurez-les avec une pince ampèremétrique ou un wattmètre, et indiquez-les.</translation>
    </message>
    <message>
        <source>Memory bandwidth</source>
        <translation>Bande passante de la mémoire</translation>
    </message>
    <message>
        <source>Block products</source>
        <translation>Produits par blocs</translation>
    </message>
    <message>
        <source>Other work disturbed the timing: batches usually took {0} times as long as the fastest one. Measure again on a quiet machine.</source>
        <translation>Un autre travail a perturbé le chronométrage&#xa0;: les lots ont en général duré {0} fois plus que le plus rapide. Mesurez de nouveau sur une machine au calme.</translation>
    </message>
    <message>
        <source>The grid holds no problem.</source>
        <translation>La grille ne contient aucun problème.</translation>
    </message>
    <message>
        <source>{0} of {1} problems are larger than the memory allowed and were left out; beyond {2} nodes the plan goes on in proportion.</source>
        <translation>{0} problèmes sur {1} dépassent la mémoire permise et ont été omis&#xa0;; au-delà de {2} nœuds, le plan continue en proportion.</translation>
    </message>
    <message>
        <source>This build has no OpenCL.</source>
        <translation>Cette version n’a pas OpenCL.</translation>
    </message>
    <message>
        <source>Build with -DGLISSON_OPENCL=ON.</source>
        <translation>Compilez avec -DGLISSON_OPENCL=ON.</translation>
    </message>
    <message>
        <source>OpenCL&apos;s {0} failed with {1}.</source>
        <translation>{0} d’OpenCL a échoué avec {1}.</translation>
    </message>
    <message>
        <source>There is no OpenCL device &quot;{0}&quot;.</source>
        <translation>Il n’y a pas d’appareil OpenCL «&#xa0;{0}&#xa0;».</translation>
    </message>
    <message>
        <source>Found: {1}. A device shows once its driver is installed (pocl-opencl-icd for processors).</source>
        <translation>Trouvé&#xa0;: {1}. Un appareil apparaît une fois son pilote installé (pocl-opencl-icd pour les processeurs).</translation>
    </message>
    <message>
        <source>{0} of {1} is not between {2} and {3}.</source>
        <translation>{0} = {1} n’est pas compris entre {2} et {3}.</translation>
    </message>
    <message>
        <source>Correct the question.</source>
        <translation>Corrigez la question.</translation>
    </message>
    <message>
        <source>A room of {0} C is not cooler than the limit of {1} C.</source>
        <translation>Une pièce à {0} C n’est pas plus fraîche que la limite de {1} C.</translation>
    </message>
    <message>
        <source>It draws {0} W when idle; its battery allows {1} W over {2} h, and is empty after {3} h without computing anything.</source>
        <translation>Il consomme {0} W au repos&#xa0;; sa batterie permet {1} W pendant {2} h, et elle est vide au bout de {3} h sans rien calculer.</translation>
    </message>
    <message>
        <source>Its battery is empty after {0} h of {1} h: only {2} W of headroom over idling.</source>
        <translation>Sa batterie est vide au bout de {0} h sur {1} h&#xa0;: seulement {2} W de marge au-dessus du repos.</translation>
    </message>
    <message>
        <source>It reaches {0} C when idle; the limit is {1} C.</source>
        <translation>Il atteint {0} C au repos&#xa0;; la limite est de {1} C.</translation>
    </message>
    <message>
        <source>It reaches {0} C; the limit is {1} C.</source>
        <translation>Il atteint {0} C&#xa0;; la limite est de {1} C.</translation>
    </message>
    <message>
        <source>It computes {0} frames a second of {1}.</source>
        <translation>Il calcule {0} images par seconde sur {1}.</translation>
    </message>
    <message>
        <source>{0} mm is coarser than the convergence study reaches; planned is its coarsest resolution, {1} mm3 a node.</source>
        <translation>{0} mm est plus grossier que ce qu’atteint l’étude de convergence&#xa0;; le plan prend sa résolution la plus grossière, {1} mm3 par nœud.</translation>
    </message>
    <message>
        <source>A frame is {0} block products as in the dissertation, without the vector updates of conjugate gradients; a simulation that couples 27 nodes moves {1} times as much.</source>
        <translation>Une image fait {0} produits par blocs comme dans la thèse, sans les mises à jour de vecteurs du gradient conjugué&#xa0;; une simulation qui couple 27 nœuds déplace {1} fois plus de données.</translation>
    </message>
    <message>
        <source>{0} holds with next to no headroom: its battery allows {1} W over {2} h, and idling takes {3} W of them.</source>
        <translation>{0} tient presque sans marge&#xa0;: sa batterie permet {1} W pendant {2} h, et le repos en prend {3} W.</translation>
    </message>
    <message>
        <source>{0}: after {1} s comes {2} s.</source>
        <translation>{0}&#xa0;: après {1} s vient {2} s.</translation>
    </message>
    <message>
        <source>Give the column that holds the time, or cut the file there.</source>
        <translation>Indiquez la colonne qui contient le temps, ou coupez le fichier à cet endroit.</translation>
    </message>
    <message>
        <source>Check the columns; at most every tenth row may be empty.</source>
        <translation>Vérifiez les colonnes&#xa0;; au plus une ligne sur dix peut être vide.</translation>
    </message>
    <message>
        <source>Change the shortest run and pause, or cut the trace to the logged runs.</source>
        <translation>Changez l’exécution et la pause les plus courtes, ou coupez la trace aux exécutions du journal.</translation>
    </message>
    <message>
        <source>Run {0} drew nothing above idle, or nothing was run in it.</source>
        <translation>L’exécution {0} n’a rien consommé au-delà du repos, ou rien n’y a été exécuté.</translation>
    </message>
    <message>
        <source>The power does not move between two levels, so no runs can be told from pauses.</source>
        <translation>La puissance ne varie pas entre deux niveaux, de sorte que les exécutions ne se distinguent pas des pauses.</translation>
    </message>
    <message>
        <source>Record pauses between the runs; check that the right column was read.</source>
        <translation>Enregistrez des pauses entre les exécutions&#xa0;; vérifiez que la bonne colonne a été lue.</translation>
    </message>
    <message>
        <source>Idle power moves by {0} W over the recording; each run is compared with the pauses beside it.</source>
        <translation>La puissance au repos varie de {0} W pendant l’enregistrement&#xa0;; chaque exécution est comparée aux pauses voisines.</translation>
    </message>
    <message>
        <source>A liver of {0} cm3 is outside {1} to {2} cm3.</source>
        <translation>Un foie de {0} cm3 est hors de l’intervalle de {1} à {2} cm3.</translation>
    </message>
    <message>
        <source>Check the volume and its unit: 1 litre is 1000 cm3.</source>
        <translation>Vérifiez le volume et son unité&#xa0;: 1 litre vaut 1000 cm3.</translation>
    </message>
    <message>
        <source>A node cannot stand for {0} mm3.</source>
        <translation>Un nœud ne peut pas représenter {0} mm3.</translation>
    </message>
    <message>
        <source>A domain of influence of {0} nodes is no cube around a node.</source>
        <translation>Un domaine d’influence de {0} nœuds n’est pas un cube autour d’un nœud.</translation>
    </message>
    <message>
        <source>Use 1, 27 or 125.</source>
        <translation>Employez 1, 27 ou 125.</translation>
    </message>
    <message>
        <source>{0} products a frame are not between 1 and 100000.</source>
        <translation>{0} produits par image ne sont pas entre 1 et 100000.</translation>
    </message>
    <message>
        <source>The folder {0} holds no judgement of a registration.</source>
        <translation>Le dossier {0} ne contient pas de jugement d’un recalage.</translation>
    </message>
    <message>
        <source>Make one: glisson-cli sirgn SEQUENCE.json --method icp --out FOLDER.</source>
        <translation>Produisez-en un&#xa0;: glisson-cli sirgn SEQUENCE.json --method icp --out DOSSIER.</translation>
    </message>
    <message>
        <source>{0}: {1}.</source>
        <translation>{0}&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>A sequence names frames with a cloud each, and landmarks.</source>
        <translation>Une séquence nomme des images avec chacune un nuage de points, et des repères.</translation>
    </message>
    <message>
        <source>it is not an object</source>
        <translation>elle n’est pas un objet</translation>
    </message>
    <message>
        <source>it has no list of frames</source>
        <translation>elle n’a pas de liste d’images</translation>
    </message>
    <message>
        <source>registered does not name one cloud a frame</source>
        <translation>registered ne nomme pas un nuage de points par image</translation>
    </message>
    <message>
        <source>registered holds something that is no file name</source>
        <translation>registered contient quelque chose qui n’est pas un nom de fichier</translation>
    </message>
    <message>
        <source>Frame {0} is missing: there is no file {1}.</source>
        <translation>L’image {0} manque&#xa0;: il n’y a pas de fichier {1}.</translation>
    </message>
    <message>
        <source>Remove the frame from the sequence (and number the tracks anew), or add it.</source>
        <translation>Retirez l’image de la séquence (et renumérotez les trajectoires), ou ajoutez-la.</translation>
    </message>
    <message>
        <source>it names no file of landmarks</source>
        <translation>elle ne nomme aucun fichier de repères</translation>
    </message>
    <message>
        <source>Line {1} of {0} is not landmark,frame,x_mm,y_mm,z_mm with a frame below {2}.</source>
        <translation>La ligne {1} de {0} n’est pas landmark,frame,x_mm,y_mm,z_mm avec une image inférieure à {2}.</translation>
    </message>
    <message>
        <source>Frame {0} holds no point that is finite.</source>
        <translation>L’image {0} ne contient aucun point fini.</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>Track more features, or mark them by hand.</source>
        <translation>Suivez plus de points caractéristiques, ou marquez-les à la main.</translation>
    </message>
    <message>
        <source>warps</source>
        <translation>déformations</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>triangles</translation>
    </message>
    <message>
        <source>Frame {0} has {1} points, and {2} after registration: they must match one by one.</source>
        <translation>L’image {0} a {1} points, et {2} après recalage&#xa0;: ils doivent correspondre un à un.</translation>
    </message>
    <message>
        <source>A tolerance must be a positive number of mm.</source>
        <translation>Une tolérance doit être un nombre positif de mm.</translation>
    </message>
    <message>
        <source>The folder {0} is not empty.</source>
        <translation>Le dossier {0} n’est pas vide.</translation>
    </message>
    <message>
        <source>Name a new folder for the sequence.</source>
        <translation>Indiquez un nouveau dossier pour la séquence.</translation>
    </message>
    <message>
        <source>No feature could be followed through {0} frames.</source>
        <translation>Aucun point caractéristique n’a pu être suivi sur {0} images.</translation>
    </message>
    <message>
        <source>Take more frames, or give landmarks and a model of your own.</source>
        <translation>Prenez plus d’images, ou donnez vos propres repères et un modèle.</translation>
    </message>
    <message>
        <source>matching</source>
        <translation>mise en correspondance</translation>
    </message>
    <message>
        <source>No two frames share four landmarks.</source>
        <translation>Aucune paire d’images ne partage quatre repères.</translation>
    </message>
    <message>
        <source>Track more features, or leave out fewer frames.</source>
        <translation>Suivez plus de points caractéristiques, ou omettez moins d’images.</translation>
    </message>
    <message>
        <source>Two frames or more can be aligned.</source>
        <translation>On peut aligner deux images ou plus.</translation>
    </message>
    <message>
        <source>aligning frames</source>
        <translation>alignement des images</translation>
    </message>
    <message>
        <source>The distances between the points of the {0} are not square.</source>
        <translation>Les distances entre les points de {0} ne forment pas une matrice carrée.</translation>
    </message>
    <message>
        <source>The {0} has fewer than two points to match.</source>
        <translation>{0} a moins de deux points à mettre en correspondance.</translation>
    </message>
    <message>
        <source>The {0} has {1} points to match; {2} is the most.</source>
        <translation>{0} a {1} points à mettre en correspondance&#xa0;; le maximum est {2}.</translation>
    </message>
    <message>
        <source>Some points of the {0} are not connected over the surface.</source>
        <translation>Certains points de {0} ne sont pas reliés sur la surface.</translation>
    </message>
    <message>
        <source>Keep the largest connected piece, or bridge the gap before matching.</source>
        <translation>Gardez le plus grand morceau connexe, ou comblez la lacune avant la mise en correspondance.</translation>
    </message>
    <message>
        <source>The distances between the points of the {0} are not those of a metric.</source>
        <translation>Les distances entre les points de {0} ne sont pas celles d’une métrique.</translation>
    </message>
    <message>
        <source>The seed must hold one finite cost a source point and target point.</source>
        <translation>L’amorce doit contenir un coût fini par point source et point cible.</translation>
    </message>
    <message>
        <source>sigma, tau and q must be positive.</source>
        <translation>sigma, tau et q doivent être positifs.</translation>
    </message>
    <message>
        <source>The written-out field needs {0} MB; {1} MB are allowed.</source>
        <translation>Le champ développé exige {0} Mo&#xa0;; {1} Mo sont permis.</translation>
    </message>
    <message>
        <source>No point of one surface has a partner on the other.</source>
        <translation>Aucun point d’une surface n’a de correspondant sur l’autre.</translation>
    </message>
    <message>
        <source>Align the surfaces roughly first, or give landmarks.</source>
        <translation>Alignez d’abord grossièrement les surfaces, ou donnez des repères.</translation>
    </message>
    <message>
        <source>non-rigid alignment</source>
        <translation>alignement non rigide</translation>
    </message>
    <message>
        <source>A landmark names point {0}, which cannot be led anywhere.</source>
        <translation>Un repère nomme le point {0}, qui ne peut être mené nulle part.</translation>
    </message>
    <message>
        <source>The step of the non-rigid alignment has no solution.</source>
        <translation>Le pas de l’alignement non rigide n’a pas de solution.</translation>
    </message>
    <message>
        <source>By their geodesic distances the surfaces match only inside out.</source>
        <translation>D’après leurs distances géodésiques, les surfaces ne correspondent que retournées.</translation>
    </message>
    <message>
        <source>Align them roughly and match with positions as prior, or use more points.</source>
        <translation>Alignez-les grossièrement et mettez en correspondance avec les positions comme a priori, ou prenez plus de points.</translation>
    </message>
    <message>
        <source>{0} points cannot be aligned to {1}.</source>
        <translation>{0} points ne peuvent pas être alignés sur {1}.</translation>
    </message>
    <message>
        <source>A rigid alignment needs three pairs of points that do not lie on one line.</source>
        <translation>Un alignement rigide exige trois paires de points non alignés.</translation>
    </message>
    <message>
        <source>Some of the points to align are not finite.</source>
        <translation>Certains des points à aligner ne sont pas finis.</translation>
    </message>
    <message>
        <source>rigid alignment</source>
        <translation>alignement rigide</translation>
    </message>
    <message>
        <source>A surface of {0} points cannot give {1} samples.</source>
        <translation>Une surface de {0} points ne peut pas donner {1} échantillons.</translation>
    </message>
    <message>
        <source>geodesic distances</source>
        <translation>distances géodésiques</translation>
    </message>
    <message>
        <source>A spline needs as many finite points to start from as to lead to.</source>
        <translation>Une spline exige autant de points finis au départ qu’à l’arrivée.</translation>
    </message>
    <message>
        <source>{0} points are too many for a spline; {1} is the most.</source>
        <translation>{0} points sont trop pour une spline&#xa0;; le maximum est {1}.</translation>
    </message>
    <message>
        <source>A spline needs four matched points that do not lie in one plane.</source>
        <translation>Une spline exige quatre points appariés qui ne soient pas dans un plan.</translation>
    </message>
    <message>
        <source>A result lacks the point array {0} with three values a point.</source>
        <translation>Il manque à un résultat le tableau de points {0} avec trois valeurs par point.</translation>
    </message>
    <message>
        <source>Compare results of the same mesh.</source>
        <translation>Comparez des résultats du même maillage.</translation>
    </message>
    <message>
        <source>The two results are not of the same mesh: {0} points and {1} cells against {2} and {3}.</source>
        <translation>Les deux résultats ne sont pas du même maillage&#xa0;: {0} points et {1} cellules contre {2} et {3}.</translation>
    </message>
    <message>
        <source>The two results are not of the same mesh: point {0} rests at different places.</source>
        <translation>Les deux résultats ne sont pas du même maillage&#xa0;: le point {0} repose à des endroits différents.</translation>
    </message>
    <message>
        <source>No part of the surface looks like the liver&apos;s bare area (its upper rear).</source>
        <translation>Aucune partie de la surface ne ressemble à l’area nuda du foie (en haut et en arrière).</translation>
    </message>
    <message>
        <source>Name the supports in the scenario, by a sphere or a box.</source>
        <translation>Nommez les appuis dans le scénario, par une sphère ou une boîte.</translation>
    </message>
    <message>
        <source>{0} of the session cannot be read: {1}.</source>
        <translation>{0} de la séance ne peut pas être lu&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>The cut passes the liver by.</source>
        <translation>La section passe à côté du foie.</translation>
    </message>
    <message>
        <source>Move it through the liver; positions are patient coordinates (LPS, mm).</source>
        <translation>Déplacez-la à travers le foie&#xa0;; les positions sont des coordonnées du patient (LPS, mm).</translation>
    </message>
    <message>
        <source>The point of the specimen lies on the cut, or is not finite.</source>
        <translation>Le point de la pièce opératoire est sur la section, ou n’est pas fini.</translation>
    </message>
    <message>
        <source>The step did not converge: after {0} rounds a tool still reaches {1} mm into the surface, which still moves by {2} mm.</source>
        <translation>Le pas n’a pas convergé&#xa0;: après {0} tours, un instrument pénètre encore de {1} mm dans la surface, qui bouge encore de {2} mm.</translation>
    </message>
    <message>
        <source>Placing landmarks and structures</source>
        <translation>Mise en place des repères et des structures</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Prêt</translation>
    </message>
    <message>
        <source>Nathanson liver retractor</source>
        <translation>Écarteur hépatique de Nathanson</translation>
    </message>
    <message>
        <source>A bent rod that lies under the liver as a hook some centimetres across, sold in several sizes. We found no published drawing and no measured force: that it spreads its pull over a disc of 70 mm is our assumption, and 2 N is the weight of 190 ml of liver (1.06 kg/l), what lifting the lower part of segment VI takes. On a real liver&apos;s shape with a uniform 6 kPa, 2 N hoist it by 18 mm; linear elasticity is strained beyond.</source>
        <translation>Une tige coudée placée sous le foie comme un crochet de quelques centimètres, vendue en plusieurs tailles. Nous n’avons trouvé ni dessin publié ni force mesurée&#xa0;: qu’elle répartisse sa traction sur un disque de 70 mm est notre hypothèse, et 2 N est le poids de 190 ml de foie (1.06 kg/l), ce qu’exige le soulèvement de la partie inférieure du segment VI. Sur la forme d’un vrai foie de 6 kPa uniformes, 2 N le soulèvent de 18 mm&#xa0;; au-delà, l’élasticité linéaire n’est plus valable.</translation>
    </message>
    <message>
        <source>Grasper</source>
        <translation>Pince à préhension</translation>
    </message>
    <message>
        <source>Grip forces in porcine laparoscopic liver resection: 1.75 N on average, 3.38 N at most (Minimally Invasive Therapy &amp; Allied Technologies 31(1):28-33, 2022, doi:10.1080/13645706.2020.1755313). The jaw&apos;s patch of 12 mm is our assumption.</source>
        <translation>Forces de préhension lors de résections hépatiques laparoscopiques chez le porc&#xa0;: 1.75 N en moyenne, 3.38 N au plus (Minimally Invasive Therapy &amp; Allied Technologies 31(1):28-33, 2022, doi:10.1080/13645706.2020.1755313). Le contact du mors, de 12 mm, est notre hypothèse.</translation>
    </message>
    <message>
        <source>Palpation probe</source>
        <translation>Sonde de palpation</translation>
    </message>
    <message>
        <source>A sphere of 10 mm pressed lightly; size and force are our assumption.</source>
        <translation>Une sphère de 10 mm appuyée légèrement&#xa0;; taille et force sont notre hypothèse.</translation>
    </message>
    <message>
        <source>There is no tool {0}.</source>
        <translation>Il n’y a pas d’instrument {0}.</translation>
    </message>
    <message>
        <source>The tools are: {1}.</source>
        <translation>Les instruments sont&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>A case has no scene named {0}; it has {1}.</source>
        <translation>Un cas n’a pas de scène nommée {0}&#xa0;; il a {1}.</translation>
    </message>
    <message>
        <source>{0} has no displacement.</source>
        <translation>{0} n’a pas de déplacement.</translation>
    </message>
    <message>
        <source>A picture has from {0} to {1} pixels a side; {2} x {3} were asked for.</source>
        <translation>Une image a de {0} à {1} pixels de côté&#xa0;; {2} x {3} ont été demandés.</translation>
    </message>
    <message>
        <source>There is nothing to draw with: neither EGL with OpenGL 3.2 nor an X server.</source>
        <translation>Il n’y a rien pour dessiner&#xa0;: ni EGL avec OpenGL 3.2, ni serveur X.</translation>
    </message>
    <message>
        <source>Install Mesa&apos;s drivers (on Debian: libegl-mesa0 and libgl1-mesa-dri).</source>
        <translation>Installez les pilotes de Mesa (sous Debian&#xa0;: libegl-mesa0 et libgl1-mesa-dri).</translation>
    </message>
    <message>
        <source>The picture could not be written: {0}.</source>
        <translation>L’image n’a pas pu être écrite&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Choose a folder that you may write to, on a disk with room.</source>
        <translation>Choisissez un dossier où vous avez le droit d’écrire, sur un disque qui a de la place.</translation>
    </message>
    <message>
        <source>This is not a PNG picture that can be read: {0}.</source>
        <translation>Ce n’est pas une image PNG lisible&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Check that the file is whole.</source>
        <translation>Vérifiez que le fichier est complet.</translation>
    </message>
    <message>
        <source>it is larger than 16384 pixels a side</source>
        <translation>elle a plus de 16384 pixels de côté</translation>
    </message>
    <message>
        <source>The picture cannot be drawn: {0}.</source>
        <translation>L’image ne peut pas être dessinée&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Every voxel of the image has the same value: there is nothing to grow in.</source>
        <translation>Tous les voxels de l’image ont la même valeur&#xa0;: il n’y a rien où croître.</translation>
    </message>
    <message>
        <source>Growing</source>
        <translation>Croissance</translation>
    </message>
    <message>
        <source>No tissue thick enough to be an organ hangs together with the seeds.</source>
        <translation>Aucun tissu assez épais pour être un organe n’est relié aux germes.</translation>
    </message>
    <message>
        <source>Move the seed into the middle of the liver, away from vessels and edges.</source>
        <translation>Placez le germe au milieu du foie, loin des vaisseaux et des bords.</translation>
    </message>
    <message>
        <source>Smoothing the outline</source>
        <translation>Lissage du contour</translation>
    </message>
    <message>
        <source>There is no image value around seed {0}.</source>
        <translation>Il n’y a pas de valeur d’image autour du germe {0}.</translation>
    </message>
    <message>
        <source>Seed {0} is much brighter ({1}) than seed {2} ({3}): one of them is probably not in the liver. Take it away.</source>
        <translation>Le germe {0} est bien plus clair ({1}) que le germe {2} ({3})&#xa0;: l’un d’eux n’est probablement pas dans le foie. Retirez-le.</translation>
    </message>
    <message>
        <source>Nothing grew from seed {0}: the tissue around it is too thin or uneven. Move it to the middle of the liver.</source>
        <translation>Rien n’a crû à partir du germe {0}&#xa0;: le tissu autour est trop mince ou irrégulier. Déplacez-le au milieu du foie.</translation>
    </message>
    <message>
        <source>The region reaches the side of the image: it has probably leaked into the body wall. Cut it there, or raise neck_radius_mm.</source>
        <translation>La région atteint le côté de l’image&#xa0;: elle a probablement débordé dans la paroi abdominale. Coupez-la à cet endroit, ou augmentez neck_radius_mm.</translation>
    </message>
    <message>
        <source>The region reaches the first or last slice: the liver is not wholly in the image, and its volume is that of the part seen.</source>
        <translation>La région atteint la première ou la dernière coupe&#xa0;: le foie n’est pas entièrement dans l’image, et son volume est celui de la partie visible.</translation>
    </message>
    <message>
        <source>{0} ml is more than a liver holds: the region has probably leaked into a neighbour. Raise neck_radius_mm, or cut it by hand.</source>
        <translation>{0} ml, c’est plus que n’en contient un foie&#xa0;: la région a probablement débordé dans un organe voisin. Augmentez neck_radius_mm, ou coupez-la à la main.</translation>
    </message>
    <message>
        <source>{0} ml is less than an adult&apos;s liver holds: the growth has probably stopped early. Add a seed in the part that is missing, or raise tolerance_sd.</source>
        <translation>{0} ml, c’est moins que n’en contient le foie d’un adulte&#xa0;: la croissance s’est probablement arrêtée trop tôt. Ajoutez un germe dans la partie manquante, ou augmentez tolerance_sd.</translation>
    </message>
    <message>
        <source>An image of {0} x {1} x {2} voxels is too thin to grow in.</source>
        <translation>Une image de {0} x {1} x {2} voxels est trop mince pour y croître.</translation>
    </message>
    <message>
        <source>The options of growing must be positive, and one is {0}.</source>
        <translation>Les options de la croissance doivent être positives, et l’une vaut {0}.</translation>
    </message>
    <message>
        <source>There is no seed to grow from.</source>
        <translation>Il n’y a pas de germe.</translation>
    </message>
    <message>
        <source>Give at least one point in the middle of the liver.</source>
        <translation>Donnez au moins un point au milieu du foie.</translation>
    </message>
    <message>
        <source>Seed {0} at ({1}) mm lies {2} mm outside the image.</source>
        <translation>Le germe {0} en ({1}) mm est à {2} mm hors de l’image.</translation>
    </message>
    <message>
        <source>Seeds are DICOM patient coordinates (LPS) in mm, not voxel indices.</source>
        <translation>Les germes sont des coordonnées du patient DICOM (LPS) en mm, non des indices de voxels.</translation>
    </message>
    <message>
        <source>There is no structure to label.</source>
        <translation>Il n’y a pas de structure à étiqueter.</translation>
    </message>
    <message>
        <source>The structures {0} and {1} lie on different voxel grids.</source>
        <translation>Les structures {0} et {1} sont sur des grilles de voxels différentes.</translation>
    </message>
    <message>
        <source>None of the structures is the liver.</source>
        <translation>Aucune des structures n’est le foie.</translation>
    </message>
    <message>
        <source>Segment it first, or name a structure &quot;liver&quot;.</source>
        <translation>Segmentez-le d’abord, ou nommez une structure &quot;liver&quot;.</translation>
    </message>
    <message>
        <source>The structure {0} holds no voxels.</source>
        <translation>La structure {0} ne contient aucun voxel.</translation>
    </message>
    <message>
        <source>The two masks lie on different voxel grids.</source>
        <translation>Les deux masques sont sur des grilles de voxels différentes.</translation>
    </message>
    <message>
        <source>There are no patients in this cohort.</source>
        <translation>Il n’y a pas de patients dans cette cohorte.</translation>
    </message>
    <message>
        <source>The cohort has no patient {0}.</source>
        <translation>La cohorte n’a pas de patient {0}.</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>None of the {0} patients could be used; the first one: {1}</source>
        <translation>Aucun des {0} patients n’a pu être utilisé&#xa0;; le premier&#xa0;: {1}</translation>
    </message>
    <message>
        <source>{0} holds files that are not an earlier demo&apos;s.</source>
        <translation>{0} contient des fichiers qui ne sont pas d’une démonstration antérieure.</translation>
    </message>
    <message>
        <source>Choose an empty or a new folder.</source>
        <translation>Choisissez un dossier vide ou nouveau.</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Dessin</translation>
    </message>
    <message>
        <source>simulating the MR images</source>
        <translation>simulation des images RM</translation>
    </message>
    <message>
        <source>simulating the elastography</source>
        <translation>simulation de l’élastographie</translation>
    </message>
    <message>
        <source>writing the study</source>
        <translation>écriture de l’étude</translation>
    </message>
    <message>
        <source>writing the truth</source>
        <translation>écriture de la vérité terrain</translation>
    </message>
    <message>
        <source>Check the folder and your rights there.</source>
        <translation>Vérifiez le dossier et vos droits.</translation>
    </message>
    <message>
        <source>{0} holds none of the scans, such as A-1.69N.ply.</source>
        <translation>{0} ne contient aucun des scans, tel que A-1.69N.ply.</translation>
    </message>
    <message>
        <source>None of the trials could be compared; the first one: {0}</source>
        <translation>Aucun des essais n’a pu être comparé&#xa0;; le premier&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The phantom&apos;s equilibrium was not reached: {0}</source>
        <translation>L’équilibre du fantôme n’a pas été atteint&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The two judge different videos: {0} and {1}.</source>
        <translation>Les deux jugent des vidéos différentes&#xa0;: {0} et {1}.</translation>
    </message>
    <message>
        <source>Judge both registrations on the same sequence.json.</source>
        <translation>Jugez les deux recalages sur le même sequence.json.</translation>
    </message>
    <message>
        <source>The sequence names no camera to draw with.</source>
        <translation>La séquence ne nomme aucune caméra pour dessiner.</translation>
    </message>
    <message>
        <source>Add &quot;camera&quot;: {&quot;matrix&quot;: [3x3], &quot;distortion&quot;: [..]}.</source>
        <translation>Ajoutez &quot;camera&quot;: {&quot;matrix&quot;: [3x3], &quot;distortion&quot;: [..]}.</translation>
    </message>
    <message>
        <source>Frame {0} of the sequence names no image.</source>
        <translation>L’image {0} de la séquence ne nomme aucun fichier d’image.</translation>
    </message>
    <message>
        <source>Add &quot;image&quot; to each frame.</source>
        <translation>Ajoutez &quot;image&quot; à chaque image.</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>images</translation>
    </message>
    <message>
        <source>Sample {0} of {1} has a size, a way or a force that is not positive.</source>
        <translation>L’échantillon {0} de {1} a une taille, une course ou une force qui n’est pas positive.</translation>
    </message>
    <message>
        <source>No labelled voxel of {0} lies where {1} has a stiffness.</source>
        <translation>Aucun voxel étiqueté de {0} n’est là où {1} a une rigidité.</translation>
    </message>
    <message>
        <source>Material {0} was never put under the testing machine.</source>
        <translation>Le matériau {0} n’a jamais été mis dans la machine d’essai.</translation>
    </message>
    <message>
        <source>Give its samples in the file of tests, or leave the region out.</source>
        <translation>Donnez ses échantillons dans le fichier des essais, ou omettez la région.</translation>
    </message>
    <message>
        <source>A board has from {0} to {1} points a side and a positive spacing; {2} x {3} at {4} mm were given.</source>
        <translation>Une mire a de {0} à {1} points de côté et un espacement positif&#xa0;; {2} x {3} à {4} mm ont été donnés.</translation>
    </message>
    <message>
        <source>The picture shows no board of {0} x {1} points.</source>
        <translation>L’image ne montre aucune mire de {0} x {1} points.</translation>
    </message>
    <message>
        <source>Count inner corners or circles, columns first; the board must be sharp and lit.</source>
        <translation>Comptez les coins intérieurs ou les cercles, colonnes d’abord&#xa0;; la mire doit être nette et éclairée.</translation>
    </message>
    <message>
        <source>{0} has {1} x {2} pixels, the first picture has {3} x {4}.</source>
        <translation>{0} a {1} x {2} pixels, la première image en a {3} x {4}.</translation>
    </message>
    <message>
        <source>{0} of {1} pairs show the board to both eyes; {2} are needed.</source>
        <translation>{0} paires sur {1} montrent la mire aux deux yeux&#xa0;; il en faut {2}.</translation>
    </message>
    <message>
        <source>Check the board&apos;s kind, its columns and rows; take it from several sides.</source>
        <translation>Vérifiez le type de mire, ses colonnes et ses lignes&#xa0;; prenez-la sous plusieurs angles.</translation>
    </message>
    <message>
        <source>The calibration did not converge: {0}.</source>
        <translation>Le calibrage n’a pas convergé&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>By these pictures the right eye lies to the left of the left one.</source>
        <translation>D’après ces images, l’œil droit est à gauche de l’œil gauche.</translation>
    </message>
    <message>
        <source>Exchange the left and the right pictures.</source>
        <translation>Échangez les images de gauche et de droite.</translation>
    </message>
    <message>
        <source>The calibration {0} has no {1}.</source>
        <translation>Il manque au calibrage {0}&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>It needs left and right, each with a matrix and distortion, and left_to_right.</source>
        <translation>Il exige left et right, chacun avec une matrice et une distorsion, et left_to_right.</translation>
    </message>
    <message>
        <source>A camera&apos;s focal length is not positive.</source>
        <translation>La distance focale d’une caméra n’est pas positive.</translation>
    </message>
    <message>
        <source>A coefficient of distortion is not finite.</source>
        <translation>Un coefficient de distorsion n’est pas fini.</translation>
    </message>
    <message>
        <source>Both eyes are in one place: there is no depth to see.</source>
        <translation>Les deux yeux sont au même endroit&#xa0;: aucune profondeur n’est visible.</translation>
    </message>
    <message>
        <source>left_to_right does not hold a rotation: R R^T or the last row is off by {0}.</source>
        <translation>left_to_right ne contient pas de rotation&#xa0;: R R^T ou la dernière ligne s’écarte de {0}.</translation>
    </message>
    <message>
        <source>The picture {0} cannot be read.</source>
        <translation>L’image {0} ne peut pas être lue.</translation>
    </message>
    <message>
        <source>PNG, JPEG, TIFF and BMP are read.</source>
        <translation>PNG, JPEG, TIFF et BMP sont lus.</translation>
    </message>
    <message>
        <source>The picture {0} cannot be written.</source>
        <translation>L’image {0} ne peut pas être écrite.</translation>
    </message>
    <message>
        <source>The folder must exist, and the name end in .png or .jpg.</source>
        <translation>Le dossier doit exister, et le nom finir en .png ou .jpg.</translation>
    </message>
    <message>
        <source>The folder {0} holds no pictures.</source>
        <translation>Le dossier {0} ne contient pas d’images.</translation>
    </message>
    <message>
        <source>The video {0} cannot be read.</source>
        <translation>La vidéo {0} ne peut pas être lue.</translation>
    </message>
    <message>
        <source>Give a video file that OpenCV (FFmpeg) reads, or a folder of pictures.</source>
        <translation>Donnez un fichier vidéo que lit OpenCV (FFmpeg), ou un dossier d’images.</translation>
    </message>
    <message>
        <source>The video {0} cannot be decoded: {1}.</source>
        <translation>La vidéo {0} ne peut pas être décodée&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>A picture of {0} has {1} x {2} pixels, the first has {3} x {4}.</source>
        <translation>Une image de {0} a {1} x {2} pixels, la première en a {3} x {4}.</translation>
    </message>
    <message>
        <source>The pair could not be matched: {0}.</source>
        <translation>La paire n’a pas pu être mise en correspondance&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>The calibration is not of these pictures: half of the {0} features that both show miss their epipolar lines by {1} pixels or more.</source>
        <translation>Le calibrage n’est pas celui de ces images&#xa0;: la moitié des {0} points communs aux deux manquent leur ligne épipolaire de {1} pixels ou plus.</translation>
    </message>
    <message>
        <source>Check that the calibration is this camera&apos;s, at this size of picture, and that left and right are not exchanged.</source>
        <translation>Vérifiez que le calibrage est celui de cette caméra, à cette taille d’image, et que gauche et droite ne sont pas échangées.</translation>
    </message>
    <message>
        <source>By the calibration, {0} % of what both pictures show would lie behind the camera.</source>
        <translation>D’après le calibrage, {0}&#xa0;% de ce que montrent les deux images serait derrière la caméra.</translation>
    </message>
    <message>
        <source>Left and right pictures are exchanged, or the calibration is of another camera.</source>
        <translation>Les images gauche et droite sont échangées, ou le calibrage est celui d’une autre caméra.</translation>
    </message>
    <message>
        <source>The nearest depth must be positive and less than the farthest.</source>
        <translation>La profondeur la plus proche doit être positive et inférieure à la plus éloignée.</translation>
    </message>
    <message>
        <source>The calibration is of pictures of another size: its principal point {0}, {1} lies outside {2} x {3} pixels.</source>
        <translation>Le calibrage est celui d’images d’une autre taille&#xa0;: son point principal {0}, {1} est hors de {2} x {3} pixels.</translation>
    </message>
    <message>
        <source>Calibrate at the size of the video, or scale the calibration&apos;s matrices.</source>
        <translation>Calibrez à la taille de la vidéo, ou mettez à l’échelle les matrices du calibrage.</translation>
    </message>
    <message>
        <source>The left image is {0} x {1} pixels, the right one {2} x {3}.</source>
        <translation>L’image gauche a {0} x {1} pixels, la droite {2} x {3}.</translation>
    </message>
    <message>
        <source>The images are {0} x {1} pixels; {2} x {3} were expected.</source>
        <translation>Les images ont {0} x {1} pixels&#xa0;; {2} x {3} étaient attendus.</translation>
    </message>
    <message>
        <source>There are {0} left and {1} right pictures: they must be taken in pairs.</source>
        <translation>Il y a {0} images gauches et {1} droites&#xa0;: elles doivent être prises par paires.</translation>
    </message>
    <message>
        <source>calibrating</source>
        <translation>calibrage</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Il n’y a pas assez de mémoire pour cela.</translation>
    </message>
    <message>
        <source>--channel wants COLUMN:AMPERES_PER_VOLT:SUPPLY_VOLTAGE[:CLIPS_AT], not &quot;{0}&quot;.</source>
        <translation>--channel attend COLUMN:AMPERES_PER_VOLT:SUPPLY_VOLTAGE[:CLIPS_AT], et non «&#xa0;{0}&#xa0;».</translation>
    </message>
    <message>
        <source>A column that holds watts is just COLUMN.</source>
        <translation>Une colonne qui contient des watts est simplement COLUMN.</translation>
    </message>
    <message>
        <source>Nothing was measured.</source>
        <translation>Rien n’a été mesuré.</translation>
    </message>
    <message>
        <source>There is no device &quot;{0}&quot;.</source>
        <translation>Il n’y a pas d’appareil «&#xa0;{0}&#xa0;».</translation>
    </message>
    <message>
        <source>glisson-cli platform list shows their ids.</source>
        <translation>glisson-cli platform list montre leurs identifiants.</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>The points of a cut need three columns: x_mm, y_mm, z_mm.</source>
        <translation>Les points d’une section exigent trois colonnes&#xa0;: x_mm, y_mm, z_mm.</translation>
    </message>
    <message>
        <source>Reading the liver</source>
        <translation>Lecture du foie</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Reading the model</source>
        <translation>Lecture du modèle</translation>
    </message>
    <message>
        <source>Moving the tools</source>
        <translation>Déplacement des instruments</translation>
    </message>
    <message>
        <source>Command {0} led to another state than was recorded.</source>
        <translation>La commande {0} a mené à un autre état que celui enregistré.</translation>
    </message>
    <message>
        <source>Replay with the case and the version that it was recorded with.</source>
        <translation>Rejouez avec le cas et la version de l’enregistrement.</translation>
    </message>
    <message>
        <source>{0} wants a position X,Y,Z in mm, not &quot;{1}&quot;.</source>
        <translation>{0} attend une position X,Y,Z en mm, et non «&#xa0;{1}&#xa0;».</translation>
    </message>
    <message>
        <source>--size wants WxH in pixels, 16 to 16384 each, not &quot;{0}&quot;.</source>
        <translation>--size attend LxH en pixels, de 16 à 16384 chacun, et non «&#xa0;{0}&#xa0;».</translation>
    </message>
    <message>
        <source>The computation did not converge: {0}</source>
        <translation>Le calcul n’a pas convergé&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The sequence names no registered clouds.</source>
        <translation>La séquence ne nomme pas de nuages de points recalés.</translation>
    </message>
    <message>
        <source>Add &quot;registered&quot;, or choose --method icp or geo.</source>
        <translation>Ajoutez &quot;registered&quot;, ou choisissez --method icp ou geo.</translation>
    </message>
    <message>
        <source>The sequence names no model to register its clouds to.</source>
        <translation>La séquence ne nomme pas de modèle sur lequel recaler ses nuages de points.</translation>
    </message>
    <message>
        <source>Add &quot;model&quot;: a surface file.</source>
        <translation>Ajoutez &quot;model&quot;&#xa0;: un fichier de surface.</translation>
    </message>
    <message>
        <source>Frame {0} shares too few landmarks with the others.</source>
        <translation>L’image {0} partage trop peu de repères avec les autres.</translation>
    </message>
    <message>
        <source>The two pictures agree nowhere.</source>
        <translation>Les deux images ne s’accordent nulle part.</translation>
    </message>
    <message>
        <source>Check that left and right are not exchanged and that the calibration is theirs.</source>
        <translation>Vérifiez que gauche et droite ne sont pas échangées et que le calibrage est le leur.</translation>
    </message>
    <message>
        <source>Name the cohort&apos;s folder, or ask for a simulated one with --simulated N.</source>
        <translation>Indiquez le dossier de la cohorte, ou demandez-en une simulée avec --simulated N.</translation>
    </message>
    <message>
        <source>Reading the case</source>
        <translation>Lecture du cas</translation>
    </message>
    <message>
        <source>Preparing the model</source>
        <translation>Préparation du modèle</translation>
    </message>
    <message>
        <source>Known are: {1}</source>
        <translation>Sont connues&#xa0;: {1}</translation>
    </message>
    <message>
        <source>Cut {0} opens the body nowhere.</source>
        <translation>La section {0} n’ouvre le corps nulle part.</translation>
    </message>
    <message>
        <source>Move it through the body, or open it wider; positions are LPS, in mm.</source>
        <translation>Déplacez-la à travers le corps, ou ouvrez-la davantage&#xa0;; les positions sont en LPS, en mm.</translation>
    </message>
    <message>
        <source>{0} needs exactly one of &quot;normal&quot; (a plane) and &quot;points_mm&quot; (a sheet through them).</source>
        <translation>{0} exige exactement un parmi &quot;normal&quot; (un plan) et &quot;points_mm&quot; (une surface passant par eux).</translation>
    </message>
    <message>
        <source>{0} is a sheet: its &quot;center_mm&quot; needs the &quot;radius_mm&quot; that it is open within.</source>
        <translation>{0} est une surface&#xa0;: son &quot;center_mm&quot; exige le &quot;radius_mm&quot; dans lequel elle est ouverte.</translation>
    </message>
    <message>
        <source>{0} must be a list of three points or more.</source>
        <translation>{0} doit être une liste d’au moins trois points.</translation>
    </message>
    <message>
        <source>{0} needs exactly one of &quot;{1}&quot; and &quot;{2}&quot;.</source>
        <translation>{0} exige exactement un parmi &quot;{1}&quot; et &quot;{2}&quot;.</translation>
    </message>
    <message>
        <source>{0} must be &quot;nathanson-retractor&quot;, &quot;palpation-probe&quot; or {&quot;rods&quot;: [...]}.</source>
        <translation>{0} doit être &quot;nathanson-retractor&quot;, &quot;palpation-probe&quot; ou {&quot;rods&quot;: [...]}.</translation>
    </message>
    <message>
        <source>Straight from data there are equilibria by finite elements: without a motion, a capsule, ligaments, tools or the meshfree engine.</source>
        <translation>Directement à partir de données, il y a des équilibres par éléments finis&#xa0;: sans mouvement, capsule, ligaments, instruments ni moteur sans maillage.</translation>
    </message>
    <message>
        <source>At {0} Hz the phase of {1} % of the tissue does not come back to itself over a period; those voxels were left out.</source>
        <translation>À {0} Hz, la phase de {1}&#xa0;% du tissu ne revient pas à elle-même sur une période&#xa0;; ces voxels ont été omis.</translation>
    </message>
    <message>
        <source>The loss came out negative, as when the instants run backwards in time; its sign was turned.</source>
        <translation>La perte est sortie négative, comme si les instants remontaient le temps&#xa0;; son signe a été inversé.</translation>
    </message>
    <message>
        <source>The headers name no directions: the {0} images were taken as {1} x {2} instants in their order.</source>
        <translation>Les en-têtes ne nomment pas de directions&#xa0;: les {0} images ont été prises comme {1} x {2} instants dans leur ordre.</translation>
    </message>
    <message>
        <source>The phase images have no unit: their full range, {0} to {1}, was taken as one turn.</source>
        <translation>Les images de phase n’ont pas d’unité&#xa0;: leur plage entière, de {0} à {1}, a été prise pour un tour.</translation>
    </message>
    <message>
        <source>The plan has no figure for the effect {0}; it is left out.</source>
        <translation>Le plan n’a pas de chiffre pour l’effet {0}&#xa0;; il est omis.</translation>
    </message>
    <message>
        <source>{0} was not learnt from the recordings of a platform.</source>
        <translation>{0} n’a pas été appris des enregistrements d’une plateforme.</translation>
    </message>
    <message>
        <source>Use the model.json that glisson-cli explain wrote for an experiment of kind &quot;platform&quot;.</source>
        <translation>Utilisez le model.json que glisson-cli explain a écrit pour une expérience de type &quot;platform&quot;.</translation>
    </message>
    <message>
        <source>A smooth correction has no cause and is left out of the plan.</source>
        <translation>Une correction lisse n’a pas de cause et est exclue du plan.</translation>
    </message>
    <message>
        <source>These recordings are not explained by the effects found: they take a part of the error away, and are no proof of a cause.</source>
        <translation>Les effets trouvés n’expliquent pas ces enregistrements&#xa0;: ils enlèvent une partie de l’erreur et ne prouvent aucune cause.</translation>
    </message>
    <message>
        <source>The experiment is not of kind &quot;material&quot;: it holds no strain and stress.</source>
        <translation>L’expérience n’est pas de type &quot;material&quot;&#xa0;: elle ne contient ni déformation ni contrainte.</translation>
    </message>
    <message>
        <source>A shear test cannot be used straight: take compression or tension.</source>
        <translation>Un essai de cisaillement ne peut pas être employé directement&#xa0;: prenez une compression ou une traction.</translation>
    </message>
    <message>
        <source>A figure is measured, computed, from the dissertation (dissertation), or assumed.</source>
        <translation>Un chiffre est mesuré (measured), calculé (computed), tiré de la thèse (dissertation) ou supposé (assumed).</translation>
    </message>
    <message>
        <source>It slows itself down at {0} C, and then computes {1} frames a second of {2}.</source>
        <translation>Il se ralentit à {0} C, et calcule alors {1} images par seconde sur {2}.</translation>
    </message>
    <message>
        <source>The resolution for {0} mm in tissue of {1} kPa comes from this curve ({2}): {3}</source>
        <translation>La résolution pour {0} mm dans un tissu de {1} kPa vient de cette courbe ({2})&#xa0;: {3}</translation>
    </message>
    <message>
        <source>No beam of 50 x 10 x 10 mm fits into the liver.</source>
        <translation>Aucune poutre de 50 x 10 x 10 mm ne tient dans le foie.</translation>
    </message>
    <message>
        <source>A beam found no equilibrium: {0}</source>
        <translation>Une poutre n’a pas trouvé d’équilibre&#xa0;: {0}</translation>
    </message>
    <message>
        <source>With {0} nodes the beam did not converge: {1}</source>
        <translation>Avec {0} nœuds, la poutre n’a pas convergé&#xa0;: {1}</translation>
    </message>
    <message>
        <source>Looking for the softest, stiffest and most uneven parts</source>
        <translation>Recherche des parties les plus souples, les plus rigides et les plus irrégulières</translation>
    </message>
    <message>
        <source>Hoisting the beams</source>
        <translation>Soulèvement des poutres</translation>
    </message>
    <message>
        <source>Drawing typical and extreme patients</source>
        <translation>Dessin de patients typiques et extrêmes</translation>
    </message>
    <message>
        <source>{0} has no effect that could be accepted: nothing is missing.</source>
        <translation>{0} ne contient aucun effet à accepter&#xa0;: il ne manque rien.</translation>
    </message>
    <message>
        <source>The effect {0} was not accepted into {1}.</source>
        <translation>L’effet {0} n’a pas été accepté dans {1}.</translation>
    </message>
    <message>
        <source>The accepted evidence of {0} cannot be read: {1}</source>
        <translation>Les constats acceptés de {0} ne peuvent pas être lus&#xa0;: {1}</translation>
    </message>
    <message>
        <source>Take it back (glisson-cli accept CASE --take-back) and accept it again.</source>
        <translation>Retirez-les (glisson-cli accept CASE --take-back) et acceptez-les de nouveau.</translation>
    </message>
    <message>
        <source>The model was made anew after this evidence had been accepted: see whether it still holds.</source>
        <translation>Le modèle a été refait après l’acceptation de ces constats&#xa0;: vérifiez qu’ils valent encore.</translation>
    </message>
    <message>
        <source>The scenario says itself what holds the organ: the effect {0} is left out.</source>
        <translation>Le scénario dit lui-même ce qui tient l’organe&#xa0;: l’effet {0} est écarté.</translation>
    </message>
    <message>
        <source>The scenario says itself how stiff the organ is: the effect {0} is left out.</source>
        <translation>Le scénario dit lui-même la rigidité de l’organe&#xa0;: l’effet {0} est écarté.</translation>
    </message>
    <message>
        <source>The scenario says itself what skin the organ has: the effect {0} is left out.</source>
        <translation>Le scénario dit lui-même quelle enveloppe a l’organe&#xa0;: l’effet {0} est écarté.</translation>
    </message>
    <message>
        <source>Only a linear equilibrium by finite elements can have a fibre direction: the effect {0} is left out.</source>
        <translation>Seul un équilibre linéaire par éléments finis peut avoir une direction de fibres&#xa0;: l’effet {0} est écarté.</translation>
    </message>
    <message>
        <source>{0} was not learnt from tissue.</source>
        <translation>{0} n’a pas été appris sur un tissu.</translation>
    </message>
    <message>
        <source>Use the model.json that glisson-cli explain wrote for a palpation or a material test; a platform&apos;s goes to glisson-cli platform learn.</source>
        <translation>Prenez le model.json que glisson-cli explain a écrit pour une palpation ou un essai de matériau&#xa0;; celui d’une plateforme va à glisson-cli platform learn.</translation>
    </message>
    <message>
        <source>In {0} no tissue can have such a {1}.</source>
        <translation>Dans {0}, aucun tissu ne peut avoir un tel {1}.</translation>
    </message>
    <message>
        <source>{0} has no effect {1}.</source>
        <translation>{0} n’a pas d’effet {1}.</translation>
    </message>
    <message>
        <source>What loaded the specimen while it was measured does not load the organ.</source>
        <translation>Ce qui chargeait l’échantillon pendant la mesure ne charge pas l’organe.</translation>
    </message>
    <message>
        <source>A pressure of {0} kPa acts on the organ all the time.</source>
        <translation>Une pression de {0} kPa agit en permanence sur l’organe.</translation>
    </message>
    <message>
        <source>A weight acts on the organ all the time, by ({0}, {1}, {2}) m/s2.</source>
        <translation>Un poids agit en permanence sur l’organe, de ({0}, {1}, {2}) m/s2.</translation>
    </message>
    <message>
        <source>The organ is {0} times as stiff along ({1}, {2}, {3}) as across.</source>
        <translation>L’organe est {0} fois aussi rigide le long de ({1}, {2}, {3}) qu’en travers.</translation>
    </message>
    <message>
        <source>The organ is {0} times as stiff along ({1}, {2}, {3}) as across: the specimen&apos;s axes are taken for the patient&apos;s.</source>
        <translation>L’organe est {0} fois aussi rigide le long de ({1}, {2}, {3}) qu’en travers&#xa0;: les axes de l’échantillon sont pris pour ceux du patient.</translation>
    </message>
    <message>
        <source>The whole organ is {0} times as stiff as was declared.</source>
        <translation>L’organe entier est {0} fois aussi rigide que déclaré.</translation>
    </message>
    <message>
        <source>The specimen&apos;s hard spot has no place in the organ: the specimen is not this organ in this place.</source>
        <translation>Le point dur de l’échantillon n’a pas de place dans l’organe&#xa0;: l’échantillon n’est pas cet organe à cette place.</translation>
    </message>
    <message>
        <source>A spot of {0} mm radius at ({1}, {2}, {3}) is {4} times as stiff as around it.</source>
        <translation>Une zone de {0} mm de rayon en ({1}, {2}, {3}) est {4} fois aussi rigide que ce qui l’entoure.</translation>
    </message>
    <message>
        <source>What holds the organ gives way like a spring of {0} kPa/mm.</source>
        <translation>Ce qui tient l’organe cède comme un ressort de {0} kPa/mm.</translation>
    </message>
    <message>
        <source>A skin of {0} N/mm lies around the organ.</source>
        <translation>Une enveloppe de {0} N/mm entoure l’organe.</translation>
    </message>
    <message>
        <source>The load cell was off: that is of the measurement, and leaves the organ as it is.</source>
        <translation>Le capteur de force était déréglé&#xa0;: cela concerne la mesure et laisse l’organe tel qu’il est.</translation>
    </message>
    <message>
        <source>The camera&apos;s frame was off: that is of the measurement, and leaves the organ as it is.</source>
        <translation>Le repère de la caméra était décalé&#xa0;: cela concerne la mesure et laisse l’organe tel qu’il est.</translation>
    </message>
    <message>
        <source>This linear rehearsal cannot hold the effect {0}.</source>
        <translation>Cette répétition linéaire ne peut pas rendre l’effet {0}.</translation>
    </message>
    <message>
        <source>A smooth correction has no cause and is left out of the rehearsal.</source>
        <translation>Une correction lisse n’a pas de cause et est exclue de la répétition.</translation>
    </message>
    <message>
        <source>These measurements are not explained by the effects found: they take a part of the error away, and are no proof of a cause.</source>
        <translation>Les effets trouvés n’expliquent pas ces mesures&#xa0;: ils enlèvent une partie de l’erreur et ne prouvent aucune cause.</translation>
    </message>
    <message>
        <source>A grain needs an axis of some length and a ratio above zero.</source>
        <translation>Une direction de fibres demande un axe d’une certaine longueur et un rapport supérieur à zéro.</translation>
    </message>
    <message>
        <source>With a ratio of {0} along the grain no stable material is left at a Poisson&apos;s ratio of {1}.</source>
        <translation>Avec un rapport de {0} le long des fibres, il ne reste aucun matériau stable pour un coefficient de Poisson de {1}.</translation>
    </message>
    <message>
        <source>A grain is there for equilibrium by finite elements, with the material &quot;linear&quot; and without ligaments.</source>
        <translation>Une direction de fibres existe pour l’équilibre par éléments finis, avec le matériau &quot;linear&quot; et sans ligaments.</translation>
    </message>
    <message>
        <source>{0} would not come out as it was.</source>
        <translation>{0} ne serait pas rétabli tel qu’il était.</translation>
    </message>
    <message>
        <source>{0} is open in another window: what is done here cannot be undone.</source>
        <translation>{0} est ouvert dans une autre fenêtre&#xa0;: ce qui est fait ici ne peut pas être annulé.</translation>
    </message>
    <message>
        <source>Close the other window, then open the case anew.</source>
        <translation>Fermez l’autre fenêtre, puis rouvrez le cas.</translation>
    </message>
    <message>
        <source>There is nothing left to undo.</source>
        <translation>Il n’y a plus rien à annuler.</translation>
    </message>
    <message>
        <source>There is nothing left to redo.</source>
        <translation>Il n’y a plus rien à rétablir.</translation>
    </message>
    <message>
        <source>{0} has been changed by something else since: what was done before cannot be undone any more.</source>
        <translation>{0} a été modifié par autre chose depuis&#xa0;: ce qui a été fait auparavant ne peut plus être annulé.</translation>
    </message>
    <message>
        <source>The history of the case cannot be read: {0}.</source>
        <translation>L’historique du cas ne peut pas être lu&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>A stored step of the history does not fit its case.</source>
        <translation>Une étape enregistrée de l’historique ne correspond pas à son cas.</translation>
    </message>
    <message>
        <source>A stored step of the history reaches beyond its image.</source>
        <translation>Une étape enregistrée de l’historique dépasse les limites de son image.</translation>
    </message>
    <message>
        <source>A stored step of the history is cut off.</source>
        <translation>Une étape enregistrée de l’historique est tronquée.</translation>
    </message>
    <message>
        <source>{0} does not hold a planned resection: {1}.</source>
        <translation>{0} ne contient pas de résection planifiée&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>Plan it again, or make one with glisson-cli resect.</source>
        <translation>Planifiez-la de nouveau, ou créez-en une avec glisson-cli resect.</translation>
    </message>
    <message>
        <source>Reading the experiment</source>
        <translation>Lecture de l’expérience</translation>
    </message>
    <message>
        <source>no model was given, so there is no distance from it (RMSE)</source>
        <translation>aucun modèle n’a été donné, donc aucune distance à celui-ci (RMSE)</translation>
    </message>
    <message>
        <source>The movie {0} cannot be written.</source>
        <translation>Le film {0} ne peut pas être écrit.</translation>
    </message>
    <message>
        <source>Choose a folder that exists.</source>
        <translation>Choisissez un dossier qui existe.</translation>
    </message>
    <message>
        <source>Choose a name that is not there yet.</source>
        <translation>Choisissez un nom qui n’existe pas encore.</translation>
    </message>
    <message>
        <source>Choose a folder in which you may write.</source>
        <translation>Choisissez un dossier où vous pouvez écrire.</translation>
    </message>
    <message>
        <source>Leave the window&apos;s size as it is while the movie is made.</source>
        <translation>Ne changez pas la taille de la fenêtre pendant la création du film.</translation>
    </message>
    <message>
        <source>Choose a folder in which you may write, or a name without .mp4: then it becomes a folder of pictures.</source>
        <translation>Choisissez un dossier où vous pouvez écrire, ou un nom sans .mp4&#xa0;: ce sera alors un dossier d’images.</translation>
    </message>
    <message>
        <source>Look whether the disk is full.</source>
        <translation>Vérifiez si le disque est plein.</translation>
    </message>
    <message>
        <source>The liver&apos;s shape with the tools there was not found: {0}</source>
        <translation>La forme du foie avec les instruments à cet endroit n’a pas été trouvée&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Press less, or move the tool by smaller steps.</source>
        <translation>Appuyez moins, ou déplacez l’instrument par pas plus petits.</translation>
    </message>
    <message>
        <source>A rigid tool that only touches the liver cannot pull it.</source>
        <translation>Un instrument rigide qui ne fait que toucher le foie ne peut pas le tirer.</translation>
    </message>
    <message>
        <source>Push into the surface, or take the grasper.</source>
        <translation>Poussez dans la surface, ou prenez la pince.</translation>
    </message>
    <message>
        <source>Tool {0} would move by {1} mm a step, past a surface that it should meet.</source>
        <translation>L’instrument {0} avancerait de {1} mm en un pas et passerait à travers une surface qu’il devrait rencontrer.</translation>
    </message>
    <message>
        <source>Take more steps: at most half the radius of the tool&apos;s rods in each.</source>
        <translation>Prenez plus de pas&#xa0;: dans chacun, au plus la moitié du rayon des tiges de l’instrument.</translation>
    </message>
    <message>
        <source>Comparing the files with what they were made from</source>
        <translation>Comparaison des fichiers avec ce dont ils proviennent</translation>
    </message>
    <message>
        <source>{0} does not hold a report of measurements: {1}.</source>
        <translation>{0} ne contient pas de rapport de mesures&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>Open an experiment to make one; it holds report.json, report.html and model.json.</source>
        <translation>Ouvrez une expérience pour en créer un&#xa0;; il contient report.json, report.html et model.json.</translation>
    </message>
    <message>
        <source>Two series are to be the {0}: {1} is the second.</source>
        <translation>Deux séries doivent être {0}&#xa0;: {1} est la seconde.</translation>
    </message>
    <message>
        <source>Leave one of them out, or give it another role.</source>
        <translation>Écartez l’une d’elles ou donnez-lui un autre rôle.</translation>
    </message>
    <message>
        <source>No series is chosen: give at least one of them a role.</source>
        <translation>Aucune série n’est choisie&#xa0;: donnez un rôle à au moins une d’elles.</translation>
    </message>
    <message>
        <source>There is nothing of this structure at that place.</source>
        <translation>Il n’y a rien de cette structure à cet endroit.</translation>
    </message>
    <message>
        <source>Fill between slices of {0}</source>
        <translation>Remplir entre les coupes de {0}</translation>
    </message>
    <message>
        <source>Fill holes of {0}</source>
        <translation>Combler les trous de {0}</translation>
    </message>
    <message>
        <source>Keep the largest piece of {0}</source>
        <translation>Garder le plus grand morceau de {0}</translation>
    </message>
    <message>
        <source>Remove small pieces of {0}</source>
        <translation>Supprimer les petits morceaux de {0}</translation>
    </message>
    <message>
        <source>Smooth {0}</source>
        <translation>Lisser {0}</translation>
    </message>
    <message>
        <source>Margin around {0}</source>
        <translation>Marge autour de {0}</translation>
    </message>
    <message>
        <source>Shrink {0}</source>
        <translation>Rétrécir {0}</translation>
    </message>
    <message>
        <source>Keep one piece of {0}</source>
        <translation>Garder un morceau de {0}</translation>
    </message>
    <message>
        <source>Smart brush on {0}</source>
        <translation>Pinceau sélectif sur {0}</translation>
    </message>
    <message>
        <source>Brush on {0}</source>
        <translation>Pinceau sur {0}</translation>
    </message>
    <message>
        <source>Eraser on {0}</source>
        <translation>Gomme sur {0}</translation>
    </message>
    <message>
        <source>Scissors on {0}</source>
        <translation>Ciseaux sur {0}</translation>
    </message>
    <message>
        <source>New structure {0}</source>
        <translation>Nouvelle structure {0}</translation>
    </message>
    <message>
        <source>Rename {0}</source>
        <translation>Renommer {0}</translation>
    </message>
    <message>
        <source>Remove {0}</source>
        <translation>Supprimer {0}</translation>
    </message>
    <message>
        <source>The model cannot be used. Build it anew.</source>
        <translation>Le modèle ne peut pas être utilisé. Refaites-le.</translation>
    </message>
    <message>
        <source>Place the tool</source>
        <translation>Placer l’instrument</translation>
    </message>
    <message>
        <source>Take the tool away</source>
        <translation>Retirer l’instrument</translation>
    </message>
    <message>
        <source>Move the tool</source>
        <translation>Déplacer l’instrument</translation>
    </message>
    <message>
        <source>Change the force</source>
        <translation>Changer la force</translation>
    </message>
    <message>
        <source>No images were found in {0}.</source>
        <translation>Aucune image n’a été trouvée dans {0}.</translation>
    </message>
    <message>
        <source>By the meshfree engine a grasper pulls with a force; {0} has a displacement.</source>
        <translation>Avec le moteur sans maillage, une pince tire avec une force&#xa0;; {0} a un déplacement.</translation>
    </message>
    <message>
        <source>Give it a pull, or take finite elements.</source>
        <translation>Donnez-lui une traction, ou prenez les éléments finis.</translation>
    </message>
    <message>
        <source>camera has no 3 x 3 matrix with positive focal lengths, or a distortion that is no list of numbers</source>
        <translation>camera n’a pas de matrice 3 x 3 à distances focales positives, ou sa distorsion n’est pas une liste de nombres</translation>
    </message>
    <message>
        <source>The first line of {0} is not {1}.</source>
        <translation>La première ligne de {0} n’est pas {1}.</translation>
    </message>
    <message>
        <source>Name the columns so, in this order, with commas between them.</source>
        <translation>Nommez ainsi les colonnes, dans cet ordre, séparées par des virgules.</translation>
    </message>
    <message>
        <source>Check that tracks and clouds are both in mm of the left camera.</source>
        <translation>Vérifiez que les trajectoires et les nuages sont tous deux en mm de la caméra gauche.</translation>
    </message>
    <message>
        <source>In line {0} no number stands in the column &quot;{1}&quot;.</source>
        <translation>À la ligne {0}, la colonne «&#xa0;{1}&#xa0;» ne contient pas de nombre.</translation>
    </message>
    <message>
        <source>A line needs a strain (0.05 for 5 %) and a stress in kPa, numbers with a dot: look for a missing value, a unit, or a decimal comma.</source>
        <translation>Chaque ligne demande une déformation (0.05 pour 5 %) et une contrainte en kPa, nombres avec un point&#xa0;: cherchez une valeur manquante, une unité ou une virgule décimale.</translation>
    </message>
    <message>
        <source>Tools with friction are not there for a body with a grain.</source>
        <translation>Il n’y a pas d’instruments avec frottement pour un corps à fibres orientées.</translation>
    </message>
    <message>
        <source>Leave out the grain or the friction.</source>
        <translation>Retirez la direction des fibres ou le frottement.</translation>
    </message>
    <message>
        <source>The mean of the elastography&apos;s magnitude images serves as the anatomy.</source>
        <translation>La moyenne des images d’amplitude de l’élastographie sert d’anatomie.</translation>
    </message>
    <message>
        <source>{0} was not wholly inside the liver; it was meshed as part of it.</source>
        <translation>{0} n’était pas entièrement dans le foie&#xa0;; cette structure a été maillée comme en faisant partie.</translation>
    </message>
    <message>
        <source>{0} holds no voxels.</source>
        <translation>{0} ne contient aucun voxel.</translation>
    </message>
    <message>
        <source>The body falls in {0} parts; the largest is kept, and the rest is left out: {1}.</source>
        <translation>Le corps se divise en {0} parties&#xa0;; la plus grande est gardée, le reste est écarté&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>Holes without a label inside the body, {0} ml together, are filled.</source>
        <translation>Les trous sans étiquette à l’intérieur du corps, {0} ml au total, sont comblés.</translation>
    </message>
    <message>
        <source>{0} speck of fewer than {1} voxels ({2} voxels together) became part of what it touches.</source>
        <translation>{0} îlot de moins de {1} voxels ({2} voxels au total) a été rattaché à ce qu’il touche.</translation>
    </message>
    <message>
        <source>{0} specks of fewer than {1} voxels ({2} voxels together) became part of what they touch.</source>
        <translation>{0} îlots de moins de {1} voxels ({2} voxels au total) ont été rattachés à ce qu’ils touchent.</translation>
    </message>
    <message>
        <source>The mesh has {0} cells instead of {1}; its shape and inner structures ask for them.</source>
        <translation>Le maillage a {0} cellules au lieu de {1}&#xa0;; sa forme et ses structures internes les demandent.</translation>
    </message>
    <message>
        <source>{0}: {1} piece ({2} ml) too thin for {3} cells got no cells of its own; about {4} cells would show it.</source>
        <translation>{0}&#xa0;: {1} morceau ({2} ml) trop mince pour {3} cellules n’a pas de cellules propres&#xa0;; environ {4} cellules le montreraient.</translation>
    </message>
    <message>
        <source>{0}: {1} pieces ({2} ml) too thin for {3} cells got no cells of their own; about {4} cells would show them.</source>
        <translation>{0}&#xa0;: {1} morceaux ({2} ml) trop minces pour {3} cellules n’ont pas de cellules propres&#xa0;; environ {4} cellules les montreraient.</translation>
    </message>
    <message>
        <source>Another way of touching</source>
        <translation>Autre manière de toucher</translation>
    </message>
    <message>
        <source>Place another tool</source>
        <translation>Placer un autre instrument</translation>
    </message>
    <message>
        <source>The walls of cuts can be kept apart in equilibrium by finite elements, without a grain and not straight from data.</source>
        <translation>Les parois des sections peuvent être tenues séparées à l&apos;équilibre par éléments finis, sans orientation des fibres et pas directement à partir de données.</translation>
    </message>
    <message>
        <source>The displacement has {0} points, the liver {1}; or one of them is not a number.</source>
        <translation>Le déplacement a {0} points, le foie {1} ; ou l&apos;un d&apos;eux n&apos;est pas un nombre.</translation>
    </message>
    <message>
        <source>Simulate it again with the model as it is now.</source>
        <translation>Simulez de nouveau avec le modèle actuel.</translation>
    </message>
    <message>
        <source>Pull or push with less force.</source>
        <translation>Tirez ou poussez avec moins de force.</translation>
    </message>
    <message>
        <source>The result {0} is not of this model: its points at rest are others.</source>
        <translation>Le résultat {0} n&apos;est pas de ce modèle : ses points au repos sont autres.</translation>
    </message>
    <message>
        <source>one of its elements does not end</source>
        <translation>l&apos;un de ses éléments ne se termine pas</translation>
    </message>
    <message>
        <source>a compressed array has no blocks</source>
        <translation>un tableau compressé n&apos;a pas de blocs</translation>
    </message>
    <message>
        <source>the blocks of a compressed array have no size</source>
        <translation>les blocs d&apos;un tableau compressé n&apos;ont pas de taille</translation>
    </message>
    <message>
        <source>a compressed array has more bytes than the file can hold</source>
        <translation>un tableau compressé a plus d&apos;octets que le fichier n&apos;en peut contenir</translation>
    </message>
    <message>
        <source>an array begins behind its end</source>
        <translation>un tableau commence après sa fin</translation>
    </message>
    <message>
        <source>Mesh the surface anew, for example with MeshLab.</source>
        <translation>Remaillez la surface, par exemple avec MeshLab.</translation>
    </message>
    <message>
        <source>No triangle of the surface has an area.</source>
        <translation>Aucun triangle de la surface n&apos;a d&apos;aire.</translation>
    </message>
    <message>
        <source>Make the surface anew; a cloud of points is not one.</source>
        <translation>Refaites la surface ; un nuage de points n&apos;en est pas une.</translation>
    </message>
    <message>
        <source>The surface is in {0} pieces, between which there is no way along it; the largest has {1} % of its area.</source>
        <translation>La surface est en {0} morceaux, entre lesquels aucun chemin ne la suit ; le plus grand a {1} % de son aire.</translation>
    </message>
    <message>
        <source>Keep its largest piece, or join the pieces.</source>
        <translation>Gardez le plus grand morceau, ou réunissez les morceaux.</translation>
    </message>
    <message>
        <source>Points at the place of another, joined with it: {0}.</source>
        <translation>Points à la place d&apos;un autre, réunis avec lui : {0}.</translation>
    </message>
    <message>
        <source>Doubled or empty triangles left out: {0}.</source>
        <translation>Triangles doubles ou vides laissés de côté : {0}.</translation>
    </message>
    <message>
        <source>Triangles turned to fit their neighbours: {0}.</source>
        <translation>Triangles retournés pour s&apos;accorder à leurs voisins : {0}.</translation>
    </message>
    <message>
        <source>Points parted where the surface only touches itself: {0}.</source>
        <translation>Points séparés là où la surface ne fait que se toucher : {0}.</translation>
    </message>
    <message>
        <source>Pieces left out, together below 1 % of the area: {0}.</source>
        <translation>Morceaux laissés de côté, ensemble moins de 1 % de l&apos;aire : {0}.</translation>
    </message>
    <message>
        <source>the patient&apos;s left</source>
        <translation>la gauche du patient</translation>
    </message>
    <message>
        <source>the patient&apos;s right</source>
        <translation>la droite du patient</translation>
    </message>
    <message>
        <source>the back</source>
        <translation>le dos</translation>
    </message>
    <message>
        <source>the front</source>
        <translation>l&apos;avant</translation>
    </message>
    <message>
        <source>the head</source>
        <translation>la tête</translation>
    </message>
    <message>
        <source>the feet</source>
        <translation>les pieds</translation>
    </message>
    <message>
        <source>The image cuts the body off towards {0}; it is closed there by a flat cap.</source>
        <translation>L&apos;image coupe le corps vers {0} ; il y est fermé par une face plane.</translation>
    </message>
    <message>
        <source>Most rows of {0} are far shorter than its first.</source>
        <translation>La plupart des lignes de {0} sont bien plus courtes que la première.</translation>
    </message>
    <message>
        <source>{0} is left out: its pixels cannot be written without what else is stored with them.</source>
        <translation>{0} est laissé de côté : ses pixels ne peuvent pas être écrits sans ce qui est enregistré avec eux.</translation>
    </message>
    <message>
        <source>{0} does not say whether its pixels are signed: PixelRepresentation is {1}.</source>
        <translation>{0} ne dit pas si ses pixels sont signés : PixelRepresentation vaut {1}.</translation>
    </message>
    <message>
        <source>its voxels lie in several files</source>
        <translation>ses voxels se trouvent dans plusieurs fichiers</translation>
    </message>
    <message>
        <source>its voxels are encoded in a way that is not read</source>
        <translation>ses voxels sont codés d’une façon qui n’est pas lue</translation>
    </message>
    <message>
        <source>{0} has {1} million voxels; at most {2} million are read.</source>
        <translation>{0} a {1} millions de voxels ; {2} millions au plus sont lus.</translation>
    </message>
    <message>
        <source>Cut out the part that is needed, or resample it to larger voxels.</source>
        <translation>Découpez la partie nécessaire ou rééchantillonnez en voxels plus grands.</translation>
    </message>
    <message>
        <source>The compressed voxels of {0} are damaged or cut short.</source>
        <translation>Les voxels compressés de {0} sont endommagés ou tronqués.</translation>
    </message>
    <message>
        <source>{0} holds more voxels than its header declares: its sizes are not those that it was written with.</source>
        <translation>{0} contient plus de voxels que son en-tête n’en déclare : ses dimensions ne sont pas celles de son écriture.</translation>
    </message>
    <message>
        <source>There is no room in the liver for {0} of {1} mm: make it smaller, or let it lie elsewhere.</source>
        <translation>Il n&apos;y a pas de place dans le foie pour {0} de {1} mm : réduisez sa taille ou placez-la ailleurs.</translation>
    </message>
    <message>
        <source>A liver of {0} ml cannot be made: ask for 800 to 2800 ml.</source>
        <translation>Un foie de {0} ml ne peut pas être généré : demandez de 800 à 2800 ml.</translation>
    </message>
    <message>
        <source>A fat fraction of {0} with fibrosis of stage {1} cannot be made: the first is 0 to 0.5, the second 0 to 4.</source>
        <translation>Une fraction de graisse de {0} avec une fibrose de stade {1} ne peut pas être générée : la première va de 0 à 0.5, le second de 0 à 4.</translation>
    </message>
    <message>
        <source>shaping the liver</source>
        <translation>mise en forme du foie</translation>
    </message>
    <message>
        <source>growing the vessels</source>
        <translation>croissance des vaisseaux</translation>
    </message>
    <message>
        <source>The lesion {0} is not understood: give its diameter in mm, as 30, and if you like its segment, 30@7, or its place, 30@x,y,z.</source>
        <translation>La lésion {0} n&apos;est pas comprise : donnez son diamètre en mm, comme 30, et si vous le souhaitez son segment, 30@7, ou son emplacement, 30@x,y,z.</translation>
    </message>
    <message>
        <source>others are writing it</source>
        <translation>d’autres sont en train de l’écrire</translation>
    </message>
    <message>
        <source>{0} is a link to another place, where nothing is written.</source>
        <translation>{0} est un lien vers un autre endroit, où rien n’est écrit.</translation>
    </message>
    <message>
        <source>Put the folder itself there.</source>
        <translation>Placez-y le dossier lui-même.</translation>
    </message>
    <message>
        <source>{0} names a file outside its place in the case folder: {1}.</source>
        <translation>{0} nomme un fichier hors de sa place dans le dossier du cas : {1}.</translation>
    </message>
    <message>
        <source>{0} is being made by another program.</source>
        <translation>{0} est en train d’être créé par un autre programme.</translation>
    </message>
    <message>
        <source>Wait until it has finished, or choose another name.</source>
        <translation>Attendez qu’il ait fini, ou choisissez un autre nom.</translation>
    </message>
    <message>
        <source>{0} was replaced by another program and does not fit the liver of this case.</source>
        <translation>{0} a été remplacé par un autre programme et ne correspond pas au foie de ce cas.</translation>
    </message>
    <message>
        <source>Put the file back, or make it anew: glisson-cli segment, mesh, stiffness.</source>
        <translation>Remettez le fichier, ou refaites-le : glisson-cli segment, mesh, stiffness.</translation>
    </message>
    <message>
        <source>Another program has changed {0} since it was saved.</source>
        <translation>Un autre programme a modifié {0} depuis son enregistrement.</translation>
    </message>
    <message>
        <source>What {0} was made from has changed since: make it anew.</source>
        <translation>Ce dont {0} a été fait a changé depuis : refaites-le.</translation>
    </message>
    <message>
        <source>Point {0} of the surface lies farther off than a thousand kilometres.</source>
        <translation>Le point {0} de la surface se trouve à plus de mille kilomètres.</translation>
    </message>
    <message>
        <source>No triangle of the surface has an area: they are lines or points.</source>
        <translation>Aucun triangle de la surface n’a d’aire : ce sont des lignes ou des points.</translation>
    </message>
    <message>
        <source>Point {0} of the mesh lies farther off than a thousand kilometres.</source>
        <translation>Le point {0} du maillage se trouve à plus de mille kilomètres.</translation>
    </message>
    <message>
        <source>The command is done, but its answer cannot be written: {0}.</source>
        <translation>La commande est exécutée, mais sa réponse ne peut pas être écrite : {0}.</translation>
    </message>
    <message>
        <source>Check where standard output goes, and the space there.</source>
        <translation>Vérifiez où va la sortie standard, et la place qui y reste.</translation>
    </message>
    <message>
        <source>They are of another patient.</source>
        <translation>Elles sont d&apos;un autre patient.</translation>
    </message>
    <message>
        <source>They are of another examination.</source>
        <translation>Elles sont d&apos;un autre examen.</translation>
    </message>
    <message>
        <source>They have another frame of reference: the patient may have moved between them.</source>
        <translation>Elles ont un autre référentiel : le patient a pu bouger entre les deux.</translation>
    </message>
    <message>
        <source>They lie elsewhere: only {0} % of their place is that of the case&apos;s anatomy.</source>
        <translation>Elles se trouvent ailleurs : {0} % seulement de leur espace est celui de l&apos;anatomie du cas.</translation>
    </message>
    <message>
        <source>This was measured on &quot;{0}&quot;, and nothing shows that it is tissue of {1}.</source>
        <translation>Cela a été mesuré sur « {0} », et rien ne montre que ce soit du tissu de {1}.</translation>
    </message>
    <message>
        <source>Where it is, name the case in the experiment&apos;s title, or say so with --of-this-patient.</source>
        <translation>Si c&apos;en est, nommez le cas dans le titre de l&apos;expérience, ou dites-le par --of-this-patient.</translation>
    </message>
    <message>
        <source>The effect {0} would change nothing in the rehearsal: {1}</source>
        <translation>L&apos;effet {0} ne changerait rien à la répétition : {1}</translation>
    </message>
    <message>
        <source>Accept the others alone (--effect KIND).</source>
        <translation>Acceptez les autres seuls (--effect SORTE).</translation>
    </message>
    <message>
        <source>Make a case of their own, or take them all the same with --replace.</source>
        <translation>Faites-en un cas à part, ou prenez-les malgré tout avec --replace.</translation>
    </message>
    <message>
        <source>These images may not belong to {0}.{1}</source>
        <translation>Ces images n&apos;appartiennent peut-être pas à {0}.{1}</translation>
    </message>
    <message>
        <source>{0} has an anatomy already, which these images would replace.</source>
        <translation>{0} a déjà une anatomie, que ces images remplaceraient.</translation>
    </message>
    <message>
        <source>Drawn on another grid ({0} x {1} x {2}) and carried to the anatomy&apos;s, each voxel from the nearest one.</source>
        <translation>Dessiné sur une autre grille ({0} x {1} x {2}) et porté sur celle de l&apos;anatomie, chaque voxel du plus proche.</translation>
    </message>
    <message>
        <source>Left out of the label map: {0}.</source>
        <translation>Laissé de côté dans la carte d&apos;étiquettes : {0}.</translation>
    </message>
    <message>
        <source>Nothing says what the values of {0} are: {1}.</source>
        <translation>Rien ne dit ce que sont les valeurs de {0} : {1}.</translation>
    </message>
    <message>
        <source>Name them, as in --label-value 1=liver --label-value 2=tumour-1.</source>
        <translation>Nommez-les, par exemple --label-value 1=liver --label-value 2=tumour-1.</translation>
    </message>
    <message>
        <source>Two files bring the structure {0}: {1} is the second.</source>
        <translation>Deux fichiers apportent la structure {0} : {1} est le second.</translation>
    </message>
    <message>
        <source>Leave one of them out (--labels UID takes that label map alone).</source>
        <translation>Laissez-en un de côté (--labels UID ne prend que cette carte d&apos;étiquettes).</translation>
    </message>
    <message>
        <source>No voxel of {0} lies inside the anatomy.</source>
        <translation>Aucun voxel de {0} ne se trouve dans l&apos;anatomie.</translation>
    </message>
    <message>
        <source>Named after the file.</source>
        <translation>Nommé d&apos;après le fichier.</translation>
    </message>
    <message>
        <source>Named by you.</source>
        <translation>Nommé par vous.</translation>
    </message>
    <message>
        <source>Named by 3D Slicer&apos;s segments.</source>
        <translation>Nommé par les segments de 3D Slicer.</translation>
    </message>
    <message>
        <source>Named by the table in the file.</source>
        <translation>Nommé par la table du fichier.</translation>
    </message>
    <message>
        <source>Named by the label description beside the file.</source>
        <translation>Nommé par la description d&apos;étiquettes à côté du fichier.</translation>
    </message>
    <message>
        <source>Named by TotalSegmentator&apos;s class numbers: see whether they are right.</source>
        <translation>Nommé par les numéros de classe de TotalSegmentator : vérifiez qu&apos;ils sont justes.</translation>
    </message>
    <message>
        <source>The stiffness is assumed, {0} kPa for all cells, and not measured: it is not compared with the atlas.</source>
        <translation>La rigidité est supposée, {0} kPa pour toutes les cellules, et non mesurée : elle n’est pas comparée à l’atlas.</translation>
    </message>
    <message>
        <source>The stiffness is assumed, the atlas&apos;s {0} kPa for all cells, and not measured: it is not compared with the atlas.</source>
        <translation>La rigidité est supposée, les {0} kPa de l’atlas pour toutes les cellules, et non mesurée : elle n’est pas comparée à l’atlas.</translation>
    </message>
    <message>
        <source>The result in {0} is not to be used: {1}.</source>
        <translation>Le résultat dans {0} est inutilisable : {1}.</translation>
    </message>
    <message>
        <source>Simulate it again with less force, or on other supports.</source>
        <translation>Simulez-le de nouveau avec moins de force, ou sur d’autres appuis.</translation>
    </message>
    <message>
        <source>Within the model: strains reach {0} %.</source>
        <translation>Dans le modèle : les déformations atteignent {0} %.</translation>
    </message>
    <message>
        <source>Outside of the model: strains reach {0} %, and beyond {1} % it is an extrapolation.</source>
        <translation>Hors du modèle : les déformations atteignent {0} %, et au-delà de {1} % c’est une extrapolation.</translation>
    </message>
    <message>
        <source>Not to be used: cells turned inside out: {0}.</source>
        <translation>Inutilisable : cellules retournées : {0}.</translation>
    </message>
    <message>
        <source>Not to be used: the computation did not converge.</source>
        <translation>Inutilisable : le calcul n’a pas convergé.</translation>
    </message>
    <message>
        <source>cells turned inside out: {0}</source>
        <translation>cellules retournées : {0}</translation>
    </message>
    <message>
        <source>Plan a resection first, and save it.</source>
        <translation>Planifiez d’abord une résection, et enregistrez-la.</translation>
    </message>
    <message>
        <source>The result {0} is not to be used: {1}.</source>
        <translation>Le résultat {0} est inutilisable : {1}.</translation>
    </message>
    <message>
        <source>Simulate it again with less force.</source>
        <translation>Simulez-le de nouveau avec moins de force.</translation>
    </message>
    <message>
        <source>A result that did not converge cannot be compared: {0}</source>
        <translation>Un résultat qui n’a pas convergé ne peut pas être comparé&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The retraction&apos;s answer is not to be used: {0}.</source>
        <translation>La réponse de la rétraction est inutilisable : {0}.</translation>
    </message>
    <message>
        <source>Use less force.</source>
        <translation>Utilisez moins de force.</translation>
    </message>
    <message>
        <source>Less than 5 % of the organ is seen: too little to say where the rest is.</source>
        <translation>Moins de 5 % de l&apos;organe est visible : trop peu pour dire où se trouve le reste.</translation>
    </message>
    <message>
        <source>What is seen does not fit this organ: more than half of the points lie far from it.</source>
        <translation>Ce qui est vu ne correspond pas à cet organe : plus de la moitié des points en sont éloignés.</translation>
    </message>
    <message>
        <source>Preparing the organ</source>
        <translation>Préparation de l&apos;organe</translation>
    </message>
    <message>
        <source>Fewer than 20 points of the surface were seen.</source>
        <translation>Moins de 20 points de la surface ont été vus.</translation>
    </message>
    <message>
        <source>What was seen is twenty times smaller than the organ: lengths are in mm, are these in metres?</source>
        <translation>Ce qui est vu est vingt fois plus petit que l&apos;organe : les longueurs sont en mm, celles-ci sont-elles en mètres ?</translation>
    </message>
    <message>
        <source>What was seen is five times larger than the organ: lengths are in mm.</source>
        <translation>Ce qui est vu est cinq fois plus grand que l&apos;organe : les longueurs sont en mm.</translation>
    </message>
    <message>
        <source>Placing the organ</source>
        <translation>Placement de l&apos;organe</translation>
    </message>
    <message>
        <source>In {0}: {1}.</source>
        <translation>Dans {0} : {1}.</translation>
    </message>
    <message>
        <source>The format &quot;glisson-guidance/1&quot; is described in the documentation.</source>
        <translation>Le format &quot;glisson-guidance/1&quot; est décrit dans la documentation.</translation>
    </message>
    <message>
        <source>The first line must be id,x_mm,y_mm,z_mm.</source>
        <translation>La première ligne doit être id,x_mm,y_mm,z_mm.</translation>
    </message>
    <message>
        <source>Line {0} must hold an id and three numbers.</source>
        <translation>La ligne {0} doit contenir un identifiant et trois nombres.</translation>
    </message>
    <message>
        <source>Give a pose_guess, or mark ridges or the falciform ligament.</source>
        <translation>Donnez une pose_guess, ou marquez des crêtes ou le ligament falciforme.</translation>
    </message>
    <message>
        <source>Under no pose does what frame {0} saw lie near the organ.</source>
        <translation>Dans aucune position, ce que l&apos;image {0} a vu n&apos;est proche de l&apos;organe.</translation>
    </message>
    <message>
        <source>Check that the features have the same names on both sides, that lengths are in mm, and that the frame is of this patient.</source>
        <translation>Vérifiez que les repères portent les mêmes noms des deux côtés, que les longueurs sont en mm et que l&apos;image est de ce patient.</translation>
    </message>
    <message>
        <source>Reading the guidance case</source>
        <translation>Lecture du cas de guidage</translation>
    </message>
    <message>
        <source>Another window has {0} open: here it can be looked at, and nothing is changed.</source>
        <translation>{0} est ouvert dans une autre fenêtre : ici on peut le regarder, et rien n’est modifié.</translation>
    </message>
    <message>
        <source>Close it there and open it here again.</source>
        <translation>Fermez-le là-bas et rouvrez-le ici.</translation>
    </message>
    <message>
        <source>The folder of {0} takes no files: the case can be looked at, and nothing is kept.</source>
        <translation>Le dossier de {0} n’accepte pas de fichiers : on peut regarder le cas, et rien n’est conservé.</translation>
    </message>
    <message>
        <source>Copy it to where you may write, and open the copy.</source>
        <translation>Copiez-le là où vous pouvez écrire, et ouvrez la copie.</translation>
    </message>
    <message>
        <source>The folder {0} is gone: nothing more of this case can be kept.</source>
        <translation>Le dossier {0} a disparu : plus rien de ce cas ne peut être conservé.</translation>
    </message>
    <message>
        <source>Bring it back to its place, or open the case where it is now.</source>
        <translation>Remettez-le à sa place, ou ouvrez le cas là où il est maintenant.</translation>
    </message>
    <message>
        <source>The landmarks in {0} cannot be read: {1}.</source>
        <translation>Les repères dans {0} ne peuvent pas être lus : {1}.</translation>
    </message>
    <message>
        <source>Undo the change in the window, or delete the file&apos;s entry and set them again.</source>
        <translation>Annulez la modification dans la fenêtre, ou supprimez l&apos;entrée du fichier et placez-les de nouveau.</translation>
    </message>
    <message>
        <source>No voxel there has a grey value from {0} to {1}.</source>
        <translation>Aucun voxel n&apos;y a une valeur de gris de {0} à {1}.</translation>
    </message>
    <message>
        <source>This case has no structure &quot;{0}&quot;.</source>
        <translation>Ce cas n&apos;a pas de structure &quot;{0}&quot;.</translation>
    </message>
    <message>
        <source>Names are those of the folder labels in the case: liver, portal-vein, ...</source>
        <translation>Les noms sont ceux du dossier labels du cas : liver, portal-vein, ...</translation>
    </message>
    <message>
        <source>On {0} % of its border the outline lies on tissue that hardly differs from it, most of all at {1} (LPS, mm): look there before you trust it, and add a point where a part is missing.</source>
        <translation>Sur {0} % de son bord, le contour touche un tissu qui n&apos;en diffère guère, surtout en {1} (LPS, mm) : regardez-y avant de vous y fier, et ajoutez un point là où une partie manque.</translation>
    </message>
    <message>
        <source>A seed lies where there is no image value, or outside of the structure to stay in.</source>
        <translation>Une graine se trouve là où l&apos;image n&apos;a pas de valeur, ou hors de la structure où rester.</translation>
    </message>
    <message>
        <source>Forget the points, and click inside of it.</source>
        <translation>Oubliez les points, et cliquez à l&apos;intérieur.</translation>
    </message>
    <message>
        <source>Nothing around the seeds differs from them in brightness.</source>
        <translation>Rien autour des graines n&apos;en diffère par la luminosité.</translation>
    </message>
    <message>
        <source>Move the seeds, or draw with the brush.</source>
        <translation>Déplacez les graines, ou dessinez au pinceau.</translation>
    </message>
    <message>
        <source>What is as bright as the seeds and hangs together with them is more than {0} mm thick: no vessel.</source>
        <translation>Ce qui est aussi clair que les graines et y est relié a plus de {0} mm d&apos;épaisseur : ce n&apos;est pas un vaisseau.</translation>
    </message>
    <message>
        <source>Move the seed into a vessel that stands out, or keep the growth inside of the liver.</source>
        <translation>Placez la graine dans un vaisseau qui se détache, ou gardez la croissance à l&apos;intérieur du foie.</translation>
    </message>
    <message>
        <source>The seeds ({0}) hardly stand out from the tissue around ({1}, scatter {2}): look at the outline.</source>
        <translation>Les graines ({0}) se détachent à peine du tissu autour ({1}, dispersion {2}) : regardez le contour.</translation>
    </message>
    <message>
        <source>The growth reaches the side of the image: it has probably leaked. Keep it inside of the liver, or cut it there.</source>
        <translation>La croissance atteint le bord de l&apos;image : elle a sans doute fui. Gardez-la dans le foie, ou coupez-la là.</translation>
    </message>
    <message>
        <source>Grey values for {0}</source>
        <translation>Valeurs de gris pour {0}</translation>
    </message>
    <message>
        <source>{0} and another structure</source>
        <translation>{0} et une autre structure</translation>
    </message>
    <message>
        <source>This place is not in the liver: a landmark is followed as the liver moves.</source>
        <translation>Cet endroit n&apos;est pas dans le foie : un repère est suivi quand le foie bouge.</translation>
    </message>
    <message>
        <source>Click in the liver, in a slice or in 3D, and set it again.</source>
        <translation>Cliquez dans le foie, dans une coupe ou en 3D, et placez-le de nouveau.</translation>
    </message>
    <message>
        <source>Widen the range.</source>
        <translation>Élargissez l&apos;intervalle.</translation>
    </message>
    <message>
        <source>{0} does not hold the images that {1} was made from.</source>
        <translation>{0} ne contient pas les images dont {1} a été fait.</translation>
    </message>
    <message>
        <source>Name the folder that was imported.</source>
        <translation>Indiquez le dossier qui a été importé.</translation>
    </message>
    <message>
        <source>SIMULATED, not measured</source>
        <translation>SIMULÉ, non mesuré</translation>
    </message>
    <message>
        <source>The moduli in {0} were made of shear moduli by a Poisson&apos;s ratio of {1}, not {2}.</source>
        <translation>Les modules de {0} ont été calculés à partir de modules de cisaillement avec un coefficient de Poisson de {1}, et non de {2}.</translation>
    </message>
    <message>
        <source>Say &quot;poisson_ratio&quot;: {1} in the specimen.</source>
        <translation>Indiquez &quot;poisson_ratio&quot; : {1} dans l’échantillon (specimen).</translation>
    </message>
    <message>
        <source>Tetrahedra {0} and {1} lie on the same side of the face that they share: they overlap.</source>
        <translation>Les tétraèdres {0} et {1} sont du même côté de la face qu’ils partagent : ils se chevauchent.</translation>
    </message>
    <message>
        <source>Mesh it anew.</source>
        <translation>Refaites le maillage.</translation>
    </message>
    <message>
        <source>{0} holds {1} MB of voxels in {2} MB: nearly all of them have one value.</source>
        <translation>{0} contient {1} Mo de voxels dans {2} Mo : presque tous ont la même valeur.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of cell {0} is {1} kPa; matter has {2} to {3} kPa.</source>
        <translation>Le module d’Young de la cellule {0} est de {1} kPa ; la matière a de {2} à {3} kPa.</translation>
    </message>
    <message>
        <source>Check its unit: liver has 2 to 60 kPa.</source>
        <translation>Vérifiez son unité : le foie a de 2 à 60 kPa.</translation>
    </message>
    <message>
        <source>The mesh&apos;s Poisson&apos;s ratio must lie above -1 and not above 0.5; it is {0}.</source>
        <translation>Le coefficient de Poisson du maillage doit être supérieur à -1 et ne pas dépasser 0.5 ; il vaut {0}.</translation>
    </message>
    <message>
        <source>SIMULATED: a generated liver, breathing and pressed by a tool as a formula says. The registration called &quot;given&quot; is the true one with a fault put into it on the left of the picture.</source>
        <translation>SIMULÉ&#xa0;: un foie engendré, qui respire et qu’un instrument enfonce selon une formule. Le recalage dit «&#xa0;fourni&#xa0;» est le vrai, dans lequel une erreur a été mise à gauche de l’image.</translation>
    </message>
    <message>
        <source>there is no picture</source>
        <translation>il n’y a pas d’image</translation>
    </message>
    <message>
        <source>Patient: name withheld</source>
        <translation>Patient : nom non communiqué</translation>
    </message>
    <message>
        <source>What was planned and rehearsed</source>
        <translation>Ce qui a été planifié et répété</translation>
    </message>
    <message>
        <source>Not a medical device.</source>
        <translation>N’est pas un dispositif médical.</translation>
    </message>
    <message>
        <source>Glisson {0}. Not a medical device: not for diagnosis or treatment.</source>
        <translation>Glisson {0}. N’est pas un dispositif médical : ni pour le diagnostic ni pour le traitement.</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Provenance</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Obtenu par</translation>
    </message>
    <message>
        <source>the case</source>
        <translation>le dossier</translation>
    </message>
    <message>
        <source>files: {0}</source>
        <translation>fichiers : {0}</translation>
    </message>
    <message>
        <source>The case holds no images.</source>
        <translation>Le dossier ne contient pas d’images.</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Structures</translation>
    </message>
    <message>
        <source>Nothing is outlined yet.</source>
        <translation>Rien n’est encore délimité.</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Outlined by</source>
        <translation>Délimité par</translation>
    </message>
    <message>
        <source>{0} with {1} N over {2} mm radius</source>
        <translation>{0} avec {1} N sur {2} mm de rayon</translation>
    </message>
    <message>
        <source>Rehearsed retraction</source>
        <translation>Rétraction répétée</translation>
    </message>
    <message>
        <source>No tool is on the liver: nothing is being rehearsed.</source>
        <translation>Aucun instrument n’est sur le foie : rien n’est répété.</translation>
    </message>
    <message>
        <source>Tools: {0}.</source>
        <translation>Instruments : {0}.</translation>
    </message>
    <message>
        <source>The liver moves by up to {0} mm.</source>
        <translation>Le foie se déplace de {0} mm au plus.</translation>
    </message>
    <message>
        <source>5 mm or more matters to a surgeon and is marked !.</source>
        <translation>À partir de 5 mm, cela compte pour le chirurgien et porte un !.</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Moves (mm)</source>
        <translation>Déplacement (mm)</translation>
    </message>
    <message>
        <source>Atlas off (mm)</source>
        <translation>Écart de l’atlas (mm)</translation>
    </message>
    <message>
        <source>What can be worn</source>
        <translation>Ce qui peut être porté</translation>
    </message>
    <message>
        <source>For a liver of {0} cm3, {1} mm accuracy, {2} frames a second, {3} h at {4} deg C: {5}.</source>
        <translation>Pour un foie de {0} cm³, {1} mm de précision, {2} images par seconde, {3} h à {4} °C : {5}.</translation>
    </message>
    <message>
        <source>the least obtrusive that holds is {0}</source>
        <translation>le moins encombrant qui suffit est {0}</translation>
    </message>
    <message>
        <source>none of the known platforms holds</source>
        <translation>aucune des plateformes connues ne suffit</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Plateforme</translation>
    </message>
    <message>
        <source>Frames/s</source>
        <translation>Images/s</translation>
    </message>
    <message>
        <source>Battery (h)</source>
        <translation>Batterie (h)</translation>
    </message>
    <message>
        <source>Surface (deg C)</source>
        <translation>Surface (°C)</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Suffit</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>current</source>
        <translation>à jour</translation>
    </message>
    <message>
        <source>stale: made from something that has changed</source>
        <translation>périmé : ce dont il provient a changé</translation>
    </message>
    <message>
        <source>changed by another program</source>
        <translation>modifié par un autre programme</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>manquant</translation>
    </message>
    <message>
        <source>Where it comes from</source>
        <translation>D’où cela vient</translation>
    </message>
    <message>
        <source>Each file of the case, the beginning of its SHA-256, and what made it.</source>
        <translation>Chaque fichier du dossier, le début de son SHA-256 et ce qui l’a produit.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>When (UTC)</source>
        <translation>Quand (UTC)</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>assumed: one value for all cells, {0} kPa</source>
        <translation>supposée : une valeur pour toutes les cellules, {0} kPa</translation>
    </message>
    <message>
        <source>assumed: the atlas&apos;s one value, {0} kPa</source>
        <translation>supposée : la valeur unique de l’atlas, {0} kPa</translation>
    </message>
    <message>
        <source>the patient&apos;s own, from MR elastography</source>
        <translation>celle du patient, par élastographie IRM</translation>
    </message>
    <message>
        <source>cut through: R1 !</source>
        <translation>coupée : R1 !</translation>
    </message>
    <message>
        <source>left in place !</source>
        <translation>laissée en place !</translation>
    </message>
    <message>
        <source>under 5 mm !</source>
        <translation>moins de 5 mm !</translation>
    </message>
    <message>
        <source>Smallest distance to the cut. Under 1 mm counts as R1, under 5 mm is narrow; both are marked !.</source>
        <translation>Plus petite distance à la coupe. Moins de 1 mm compte comme R1, moins de 5 mm est étroit ; les deux portent un !.</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumeur</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Margin (mm)</source>
        <translation>Marge (mm)</translation>
    </message>
    <message>
        <source>Caution</source>
        <translation>Attention</translation>
    </message>
    <message>
        <source>Moved by the tools (mm)</source>
        <translation>Déplacée par les instruments (mm)</translation>
    </message>
    <message>
        <source>cut through</source>
        <translation>coupée</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>retirée</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>reste</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>There is no model yet.</source>
        <translation>Il n’y a pas encore de modèle.</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Cellules</translation>
    </message>
    <message>
        <source>Smallest dihedral angle</source>
        <translation>Plus petit angle dièdre</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidité</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Module d’Young</translation>
    </message>
    <message>
        <source>{0} kPa on average, sd {1}</source>
        <translation>{0} kPa en moyenne, écart type {1}</translation>
    </message>
    <message>
        <source>Cells without data of their own</source>
        <translation>Cellules sans données propres</translation>
    </message>
    <message>
        <source>{0} % (filled from inside)</source>
        <translation>{0} % (complétées de l’intérieur)</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Tenu par</translation>
    </message>
    <message>
        <source>the bare area near the vena cava, and springs under the diaphragm (assumed)</source>
        <translation>l’area nuda près de la veine cave, et des ressorts sous le diaphragme (supposé)</translation>
    </message>
    <message>
        <source>Planned resection</source>
        <translation>Résection planifiée</translation>
    </message>
    <message>
        <source>No resection was saved.</source>
        <translation>Aucune résection n’a été enregistrée.</translation>
    </message>
    <message>
        <source>The cut removes {0} ml and leaves {1} ml, {2} % of the liver.</source>
        <translation>La coupe retire {0} ml et laisse {1} ml, {2} % du foie.</translation>
    </message>
    <message>
        <source>Planned on the liver as tools hold it, an answer within the model: strains reach {0} %.</source>
        <translation>Planifié sur le foie tel que les instruments le tiennent, une réponse dans le modèle : les déformations atteignent {0} %.</translation>
    </message>
    <message>
        <source>Planned on the liver as tools hold it, an answer outside of the model: strains reach {0} %.</source>
        <translation>Planifié sur le foie tel que les instruments le tiennent, une réponse hors du modèle : les déformations atteignent {0} %.</translation>
    </message>
    <message>
        <source>Vessels that the cut crosses.</source>
        <translation>Vaisseaux que la coupe traverse.</translation>
    </message>
    <message>
        <source>Vessel</source>
        <translation>Vaisseau</translation>
    </message>
    <message>
        <source>Diameter (mm)</source>
        <translation>Diamètre (mm)</translation>
    </message>
    <message>
        <source>Vena cava, by its width</source>
        <translation>Veine cave, par sa largeur</translation>
    </message>
    <message>
        <source>The saved resection cannot be read: its file is damaged.</source>
        <translation>La résection enregistrée est illisible : son fichier est endommagé.</translation>
    </message>
    <message>
        <source>Evidence accepted</source>
        <translation>Preuves acceptées</translation>
    </message>
    <message>
        <source>None: the model is as declared.</source>
        <translation>Aucune : le modèle est tel que déclaré.</translation>
    </message>
    <message>
        <source>Changes the model: {0}</source>
        <translation>Change le modèle : {0}</translation>
    </message>
    <message>
        <source>Accepted, but left out: {0}</source>
        <translation>Acceptée, mais laissée de côté : {0}</translation>
    </message>
    <message>
        <source>Cells of the liver</source>
        <translation>Cellules du foie</translation>
    </message>
    <message>
        <source>Model: stiffness of each cell</source>
        <translation>Modèle : rigidité de chaque cellule</translation>
    </message>
    <message>
        <source>Images: {0}</source>
        <translation>Images : {0}</translation>
    </message>
    <message>
        <source>Outline: {0}</source>
        <translation>Contour : {0}</translation>
    </message>
    <message>
        <source>Smooth surface: {0}</source>
        <translation>Surface lisse : {0}</translation>
    </message>
    <message>
        <source>imported</source>
        <translation>importé</translation>
    </message>
    <message>
        <source>outlined</source>
        <translation>délimité</translation>
    </message>
    <message>
        <source>made into cells</source>
        <translation>découpé en cellules</translation>
    </message>
    <message>
        <source>stiffness given</source>
        <translation>rigidité attribuée</translation>
    </message>
    <message>
        <source>waves inverted</source>
        <translation>ondes inversées</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>accepté</translation>
    </message>
    <message>
        <source>Left out of the label map: {0} and {1} more.</source>
        <translation>Laissés de côté dans la carte d’étiquettes : {0} et {1} autres.</translation>
    </message>
    <message>
        <source>{0} lies outside of the liver and has no cells of its own.</source>
        <translation>{0} se trouve hors du foie et n’a pas de cellules propres.</translation>
    </message>
    <message>
        <source>No landmark was set.</source>
        <translation>Aucun repère n’a été placé.</translation>
    </message>
    <message>
        <source>{0} and the liver lie on different grids.</source>
        <translation>{0} et le foie sont sur des grilles différentes.</translation>
    </message>
    <message>
        <source>Import one of them again: a case carries what it imports to one grid.</source>
        <translation>Importez de nouveau l’un des deux : un cas met ce qu’il importe sur une seule grille.</translation>
    </message>
    <message>
        <source>The case has no vessels to make trees of.</source>
        <translation>Le cas n’a pas de vaisseaux dont faire des arbres.</translation>
    </message>
    <message>
        <source>Mark the structures portal-vein and hepatic-vein, or both as one structure, vessels.</source>
        <translation>Marquez les structures portal-vein et hepatic-vein, ou les deux en une seule structure, vessels.</translation>
    </message>
    <message>
        <source>The case has no vessel trees.</source>
        <translation>Le cas n’a pas d’arbres vasculaires.</translation>
    </message>
    <message>
        <source>Find them first (vessels), or take the liver&apos;s shape alone (--from prior).</source>
        <translation>Cherchez-les d’abord (vessels), ou prenez la seule forme du foie (--from prior).</translation>
    </message>
    <message>
        <source>What frame {0} saw fits the organ in more than one place: its shape alone does not say where.</source>
        <translation>Ce que montre l’image {0} s’ajuste à l’organe à plus d’un endroit : la forme seule ne dit pas où.</translation>
    </message>
    <message>
        <source>measuring the depth of the vessels</source>
        <translation>mesure de la profondeur des vaisseaux</translation>
    </message>
    <message>
        <source>following the vessels</source>
        <translation>suivi des vaisseaux</translation>
    </message>
    <message>
        <source>measuring the vessels</source>
        <translation>mesure des vaisseaux</translation>
    </message>
    <message>
        <source>The axes of the vessel mask are not at right angles: resample it.</source>
        <translation>Les axes du masque des vaisseaux ne sont pas à angle droit : rééchantillonnez-le.</translation>
    </message>
    <message>
        <source>The vessel mask holds no voxels: mark vessels first, or import another mask.</source>
        <translation>Le masque des vaisseaux ne contient aucun voxel : marquez d’abord des vaisseaux, ou importez un autre masque.</translation>
    </message>
    <message>
        <source>The vessel mask holds a piece of {0} mm width that is no vessel: mark vessels alone.</source>
        <translation>Le masque des vaisseaux contient un morceau large de {0} mm qui n’est pas un vaisseau : ne marquez que des vaisseaux.</translation>
    </message>
    <message>
        <source>looking at the liver</source>
        <translation>examen du foie</translation>
    </message>
    <message>
        <source>finding the segments</source>
        <translation>recherche des segments</translation>
    </message>
    <message>
        <source>Only {0} % of the vessels lie in the liver: check that both masks are of one scan.</source>
        <translation>Seuls {0} % des vaisseaux sont dans le foie : vérifiez que les deux masques viennent du même examen.</translation>
    </message>
    <message>
        <source>The liver mask holds no voxels: mark the liver first.</source>
        <translation>Le masque du foie ne contient aucun voxel : marquez d’abord le foie.</translation>
    </message>
    <message>
        <source>The image ends within the liver, so that its segments cannot be told: take a scan that holds all of it.</source>
        <translation>L’image s’arrête dans le foie, dont les segments ne peuvent donc être déterminés : prenez un examen qui le contient en entier.</translation>
    </message>
    <message>
        <source>No branch of the {0} lies in the liver, so that no tissue can be told to be its: check that vessels and liver are of one scan.</source>
        <translation>Aucune branche ({0}) n’est dans le foie, de sorte qu’aucun tissu ne peut lui être attribué : vérifiez que vaisseaux et foie viennent du même examen.</translation>
    </message>
    <message>
        <source>The vessel trees cannot be read: {0} is missing or makes no sense.</source>
        <translation>Les arbres vasculaires ne peuvent être lus : {0} manque ou n’a pas de sens.</translation>
    </message>
    <message>
        <source>Find the vessels again.</source>
        <translation>Cherchez de nouveau les vaisseaux.</translation>
    </message>
    <message>
        <source>--pose {0} is no rigid motion: 16 numbers with commas, row by row.</source>
        <translation>--pose {0} n’est pas un mouvement rigide : 16 nombres séparés par des virgules, ligne par ligne.</translation>
    </message>
    <message>
        <source>The pose takes a point of the scan (mm) to the camera&apos;s frame.</source>
        <translation>La pose amène un point de l’examen (mm) dans le repère de la caméra.</translation>
    </message>
    <message>
        <source>nothing was written into it</source>
        <translation>rien n’y a été écrit</translation>
    </message>
    <message>
        <source>At large strain a session knows quadratic cells of a neo-Hookean or Veronda-Westmann material without a grain.</source>
        <translation>En grande déformation, une séance ne connaît que des cellules quadratiques d’un matériau néo-hookéen ou de Veronda-Westmann sans direction de fibres.</translation>
    </message>
    <message>
        <source>The body has no rest under its standing loads.</source>
        <translation>Le corps ne trouve pas de repos sous ses charges permanentes.</translation>
    </message>
    <message>
        <source>A session does not know &quot;{0}&quot; of a scenario.</source>
        <translation>Une séance ne connaît pas « {0} » d’un scénario.</translation>
    </message>
    <message>
        <source>Leave it out; tools are taken by the session&apos;s commands.</source>
        <translation>Omettez-le ; les outils se prennent par les commandes de la séance.</translation>
    </message>
    <message>
        <source>The case has no plan {0}.</source>
        <translation>Le cas n’a pas de plan {0}.</translation>
    </message>
    <message>
        <source>A cut cannot advance through a body that was meshed with a cut.</source>
        <translation>Une coupe ne peut pas avancer dans un corps déjà maillé avec une coupe.</translation>
    </message>
    <message>
        <source>A cut cannot advance through a body with a capsule.</source>
        <translation>Une coupe ne peut pas avancer dans un corps muni d’une capsule.</translation>
    </message>
    <message>
        <source>Leave the capsule out, or cut before the rehearsal.</source>
        <translation>Omettez la capsule, ou coupez avant la répétition.</translation>
    </message>
    <message>
        <source>The cut&apos;s advance needs two different places to go between.</source>
        <translation>L’avance de la coupe exige deux endroits différents.</translation>
    </message>
    <message>
        <source>The cut crosses an earlier one, whose walls would have to be divided too.</source>
        <translation>La coupe croise une coupe précédente, dont les parois devraient aussi être divisées.</translation>
    </message>
    <message>
        <source>The cut opens nothing: all that lies along it is open already, held, or outside of the body.</source>
        <translation>La coupe n’ouvre rien : tout ce qui s’y trouve est déjà ouvert, fixé ou hors du corps.</translation>
    </message>
    <message>
        <source>The body&apos;s answer to the cut was not found: the relative residual stayed at {0}.</source>
        <translation>La réponse du corps à la coupe n’a pas été trouvée : le résidu relatif est resté à {0}.</translation>
    </message>
    <message>
        <source>Nothing would hold the part that this cut separates.</source>
        <translation>Rien ne tiendrait la partie que cette coupe sépare.</translation>
    </message>
    <message>
        <source>Stop before the last bridge of tissue.</source>
        <translation>Arrêtez-vous avant le dernier pont de tissu.</translation>
    </message>
    <message>
        <source>{0} must be whole numbers from 1 to 8, Couinaud&apos;s segments.</source>
        <translation>{0} doivent être des nombres entiers de 1 à 8, les segments de Couinaud.</translation>
    </message>
    <message>
        <source>{0} is not of the format glisson-plan/1.</source>
        <translation>{0} n’est pas au format glisson-plan/1.</translation>
    </message>
    <message>
        <source>{0} needs at least one cut in its list of cuts.</source>
        <translation>{0} a besoin d’au moins une section dans sa liste cuts.</translation>
    </message>
    <message>
        <source>A plan takes at most 255 tumours; there are {0}.</source>
        <translation>Un plan prend au plus 255 tumeurs ; il y en a {0}.</translation>
    </message>
    <message>
        <source>The liver&apos;s outline is empty.</source>
        <translation>Le contour du foie est vide.</translation>
    </message>
    <message>
        <source>looking what hangs on which vessel</source>
        <translation>recherche de ce qui dépend de chaque vaisseau</translation>
    </message>
    <message>
        <source>looking at segments and stiffness</source>
        <translation>examen des segments et de la rigidité</translation>
    </message>
    <message>
        <source>looking around the tumours</source>
        <translation>examen autour des tumeurs</translation>
    </message>
    <message>
        <source>The plan holds no cut.</source>
        <translation>Le plan ne contient aucune section.</translation>
    </message>
    <message>
        <source>The plan takes the whole liver: nothing would be left.</source>
        <translation>Le plan prend tout le foie : il ne resterait rien.</translation>
    </message>
    <message>
        <source>The liver&apos;s segments are not known yet.</source>
        <translation>Les segments du foie ne sont pas encore connus.</translation>
    </message>
    <message>
        <source>Find them first (glisson-cli territories).</source>
        <translation>Trouvez-les d’abord (glisson-cli territories).</translation>
    </message>
    <message>
        <source>The plan names no segment to take: give numbers from 1 to 8.</source>
        <translation>Le plan ne nomme aucun segment : donnez des numéros de 1 à 8.</translation>
    </message>
    <message>
        <source>There is no segment {0}: Couinaud&apos;s are 1 to 8.</source>
        <translation>Il n’y a pas de segment {0} : ceux de Couinaud sont 1 à 8.</translation>
    </message>
    <message>
        <source>Segment {0} holds no tissue of this liver.</source>
        <translation>Le segment {0} ne contient aucun tissu de ce foie.</translation>
    </message>
    <message>
        <source>There is no branch {0} in the vessel trees.</source>
        <translation>Il n’y a pas de branche {0} dans les arbres vasculaires.</translation>
    </message>
    <message>
        <source>glisson-cli vessels lists their names; portal/right/posterior stands for all that begin so.</source>
        <translation>glisson-cli vessels en donne les noms ; portal/right/posterior vaut pour tous ceux qui commencent ainsi.</translation>
    </message>
    <message>
        <source>No tissue of the liver belongs to the branch {0}.</source>
        <translation>Aucun tissu du foie n’appartient à la branche {0}.</translation>
    </message>
    <message>
        <source>Take a branch nearer to the stem.</source>
        <translation>Prenez une branche plus proche du tronc.</translation>
    </message>
    <message>
        <source>There is no tumour {0} in the liver.</source>
        <translation>Il n’y a pas de tumeur {0} dans le foie.</translation>
    </message>
    <message>
        <source>Give the name of a structure of the case that lies in the liver.</source>
        <translation>Donnez le nom d’une structure du cas située dans le foie.</translation>
    </message>
    <message>
        <source>The margin around {0} must be 0 to {1} mm.</source>
        <translation>La marge autour de {0} doit être de 0 à {1} mm.</translation>
    </message>
    <message>
        <source>The planned cut passes the liver by.</source>
        <translation>La coupe prévue passe à côté du foie.</translation>
    </message>
    <message>
        <source>Plans compared</source>
        <translation>Plans comparés</translation>
    </message>
    <message>
        <source>{0} no longer holds: {1}</source>
        <translation>{0} ne tient plus : {1}</translation>
    </message>
    <message>
        <source>What {0} was made from has changed since it was kept.</source>
        <translation>Ce dont {0} a été fait a changé depuis.</translation>
    </message>
    <message>
        <source>Per cent are of the liver without its tumours. Thresholds are the surgeon&apos;s to set.</source>
        <translation>Les pourcentages portent sur le foie sans ses tumeurs. Les seuils reviennent au chirurgien.</translation>
    </message>
    <message>
        <source>Removed (ml)</source>
        <translation>Retiré (ml)</translation>
    </message>
    <message>
        <source>Left (ml)</source>
        <translation>Reste (ml)</translation>
    </message>
    <message>
        <source>Left (%)</source>
        <translation>Reste (%)</translation>
    </message>
    <message>
        <source>Left and alive: perfused and drained (ml)</source>
        <translation>Reste vivant : perfusé et drainé (ml)</translation>
    </message>
    <message>
        <source>Left and alive (%)</source>
        <translation>Reste vivant (%)</translation>
    </message>
    <message>
        <source>Left without inflow: ischaemic (ml)</source>
        <translation>Reste sans apport : ischémique (ml)</translation>
    </message>
    <message>
        <source>Left without outflow: congested (ml)</source>
        <translation>Reste sans drainage : congestif (ml)</translation>
    </message>
    <message>
        <source>Smallest margin (mm)</source>
        <translation>Plus petite marge (mm)</translation>
    </message>
    <message>
        <source>Tumours cut through or left</source>
        <translation>Tumeurs sectionnées ou laissées</translation>
    </message>
    <message>
        <source>Stiffness of what is left (kPa)</source>
        <translation>Rigidité de ce qui reste (kPa)</translation>
    </message>
    <message>
        <source>Measured share of it (%)</source>
        <translation>Part mesurée (%)</translation>
    </message>
    <message>
        <source>What stays of each segment, in ml.</source>
        <translation>Ce qui reste de chaque segment, en ml.</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Branche</translation>
    </message>
    <message>
        <source>Make the demo anew.</source>
        <translation>Refaites la démonstration.</translation>
    </message>
    <message>
        <source>{0} has no tumour to be found.</source>
        <translation>{0} n&apos;a pas de tumeur à trouver.</translation>
    </message>
    <message>
        <source>The liver of {0} was found in no frame of its own video.</source>
        <translation>Le foie de {0} n&apos;a été trouvé dans aucune image de sa propre vidéo.</translation>
    </message>
    <message>
        <source>The case has no plan to compare.</source>
        <translation>Le cas n’a aucun plan à comparer.</translation>
    </message>
    <message>
        <source>Add some first: glisson-cli plan CASE --add PLAN.json.</source>
        <translation>Ajoutez-en d’abord : glisson-cli plan CASE --add PLAN.json.</translation>
    </message>
    <message>
        <source>Writing the video</source>
        <translation>Écriture de la vidéo</translation>
    </message>
    <message>
        <source>Place the liver by hand</source>
        <translation>Placer le foie à la main</translation>
    </message>
    <message>
        <source>Reading the sequence</source>
        <translation>Lecture de la séquence</translation>
    </message>
    <message>
        <source>Reading the clouds</source>
        <translation>Lecture des nuages de points</translation>
    </message>
    <message>
        <source>The plan was set on the liver as it was held aside: set it at rest to cut along it here.</source>
        <translation>Le plan a été posé sur le foie écarté : posez-le au repos pour couper ici en le suivant.</translation>
    </message>
    <message>
        <source>Keep the plan {0}</source>
        <translation>Garder le plan {0}</translation>
    </message>
    <message>
        <source>Drop the plan {0}</source>
        <translation>Écarter le plan {0}</translation>
    </message>
    <message>
        <source>The outline fills {0} % of the body in its slices, a person&apos;s liver less than half: it is not the liver alone, or these are images of an animal or a phantom.</source>
        <translation>Le contour remplit {0} % du corps dans ses coupes, le foie d’une personne moins de la moitié : ce n’est pas le foie seul, ou ce sont des images d’un animal ou d’un fantôme.</translation>
    </message>
    <message>
        <source>{0} ml is less than any person&apos;s liver holds: the outline is a part of it, or these are images of an animal or a phantom.</source>
        <translation>{0} ml, c’est moins que n’en contient le foie de quiconque : le contour en est une partie, ou ce sont des images d’un animal ou d’un fantôme.</translation>
    </message>
    <message>
        <source>{0} needs one of plane, sheet, segments, territory, around, ablation.</source>
        <translation>{0} demande l&apos;un de plane, sheet, segments, territory, around, ablation.</translation>
    </message>
    <message>
        <source>An ablation needs a direction, and radii of more than 0 and at most {0} mm.</source>
        <translation>Une ablation demande une direction, et des rayons de plus de 0 et d&apos;au plus {0} mm.</translation>
    </message>
    <message>
        <source>The ablation lies beside the liver.</source>
        <translation>L&apos;ablation se trouve à côté du foie.</translation>
    </message>
    <message>
        <source>Move it into the liver; positions are patient coordinates (LPS, mm).</source>
        <translation>Déplacez-la dans le foie ; les positions sont des coordonnées du patient (LPS, mm).</translation>
    </message>
    <message>
        <source>{0}: the cut unrolled flat. Purple: tumour; red: less than 5 mm from one; amber: less than 10 mm. Rings: vessels that are cut.</source>
        <translation>{0} : la coupe déroulée à plat. Violet : tumeur ; rouge : à moins de 5 mm d&apos;une ; ambre : à moins de 10 mm. Anneaux : vaisseaux coupés.</translation>
    </message>
    <message>
        <source>Left, of the body&apos;s weight (%)</source>
        <translation>Reste, du poids du corps (%)</translation>
    </message>
    <message>
        <source>Left and alive, of the body&apos;s weight (%)</source>
        <translation>Reste et vit, du poids du corps (%)</translation>
    </message>
    <message>
        <source>No worse in margin, tissue and tumours, and better in one</source>
        <translation>Ni moins bon en marge, tissu et tumeurs, et meilleur en un point</translation>
    </message>
    <message>
        <source>What a wider margin costs.</source>
        <translation>Ce que coûte une marge plus large.</translation>
    </message>
    <message>
        <source>smallest margin (mm)</source>
        <translation>plus petite marge (mm)</translation>
    </message>
    <message>
        <source>left and alive (ml)</source>
        <translation>reste et vit (ml)</translation>
    </message>
    <message>
        <source>--study and --plan serve a DICOM SEG alone (--format dicom-seg).</source>
        <translation>--study et --plan ne servent qu&apos;à un DICOM SEG (--format dicom-seg).</translation>
    </message>
    <message>
        <source>Line {1} of {0} is not landmark,frame,x_mm,y_mm,z_mm of a landmark in the tracks, with &quot;model&quot; or a frame below {2}.</source>
        <translation>La ligne {1} de {0} n’est pas landmark,frame,x_mm,y_mm,z_mm d’un repère suivi, avec &quot;model&quot; ou une image inférieure à {2}.</translation>
    </message>
    <message>
        <source>Make the sequence anew, or leave &quot;benchmark&quot; out of it.</source>
        <translation>Refaites la séquence, ou retirez-en &quot;benchmark&quot;.</translation>
    </message>
    <message>
        <source>each point was aligned without a fifth of the landmarks, the one nearest to it among them</source>
        <translation>chaque point a été aligné sans un cinquième des repères, dont le plus proche de lui</translation>
    </message>
    <message>
        <source>benchmark is no file name</source>
        <translation>benchmark n’est pas un nom de fichier</translation>
    </message>
    <message>
        <source>judged by its own landmarks, without a benchmark kept with the sequence: a fault that never changes is hardly seen</source>
        <translation>jugé par ses propres repères, sans référence gardée avec la séquence&#xa0;: une erreur qui ne change jamais ne se voit guère</translation>
    </message>
    <message>
        <source>&quot;frames&quot; must be a list with at least one frame.</source>
        <translation>&quot;frames&quot; doit être une liste d’au moins une image.</translation>
    </message>
    <message>
        <source>{0} must be a rigid motion: 16 numbers, row by row, scan to camera.</source>
        <translation>{0} doit être un mouvement rigide&#xa0;: 16 nombres, ligne par ligne, du scanner à la caméra.</translation>
    </message>
    <message>
        <source>Is it stretched or mirrored, or given column by column?</source>
        <translation>Est-il étiré ou en miroir, ou donné colonne par colonne&#xa0;?</translation>
    </message>
    <message>
        <source>{0} holds no points.</source>
        <translation>{0} ne contient aucun point.</translation>
    </message>
    <message>
        <source>In {0} most points of {1} lie farther than {2} mm from the organ, as the pose has it.</source>
        <translation>Dans {0}, la plupart des points de {1} sont à plus de {2} mm de l’organe, d’après la pose.</translation>
    </message>
    <message>
        <source>Are they in metres, in another camera&apos;s frame, or is &quot;pose_guess&quot; that of another frame?</source>
        <translation>Sont-ils en mètres, dans le repère d’une autre caméra, ou &quot;pose_guess&quot; est-elle celle d’une autre image&#xa0;?</translation>
    </message>
    <message>
        <source>In {0} more than one tool touches the organ.</source>
        <translation>Dans {0}, plus d’un instrument touche l’organe.</translation>
    </message>
    <message>
        <source>An experiment takes frames with one tool, or none.</source>
        <translation>Une expérience prend des images avec un instrument, ou aucun.</translation>
    </message>
    <message>
        <source>Two frames have the id &quot;{0}&quot;.</source>
        <translation>Deux images ont l’identifiant &quot;{0}&quot;.</translation>
    </message>
    <message>
        <source>{0} names no frames.</source>
        <translation>{0} ne nomme aucune image.</translation>
    </message>
    <message>
        <source>{0} names the frame &quot;{1}&quot;, which is not there.</source>
        <translation>{0} nomme l’image &quot;{1}&quot;, qui n’existe pas.</translation>
    </message>
    <message>
        <source>The frame &quot;{0}&quot; belongs to two trials.</source>
        <translation>L’image &quot;{0}&quot; appartient à deux essais.</translation>
    </message>
    <message>
        <source>Name each frame in one trial, or leave &quot;trials&quot; out: each frame is one then.</source>
        <translation>Nommez chaque image dans un essai, ou retirez &quot;trials&quot;&#xa0;: chaque image en est alors un.</translation>
    </message>
    <message>
        <source>Repeat the longest trial at half of its current or load.</source>
        <translation>Répéter l’essai le plus long avec la moitié de son courant ou de sa charge.</translation>
    </message>
    <message>
        <source>Repeat the longest trial at twice its current or load.</source>
        <translation>Répéter l’essai le plus long avec le double de son courant ou de sa charge.</translation>
    </message>
    <message>
        <source>Repeat the longest trial in a room that is 15 °C warmer.</source>
        <translation>Répéter l’essai le plus long dans une pièce plus chaude de 15 °C.</translation>
    </message>
    <message>
        <source>A finer mesh would change the prediction; {0} % of what it would change shows in the measurements and is taken off what the better model predicts.</source>
        <translation>Un maillage plus fin changerait la prédiction ; {0} % de ce changement se voit dans les mesures et est retiré de ce que prédit le meilleur modèle.</translation>
    </message>
    <message>
        <source>There is only one trial, so nothing could be predicted that was not fitted.</source>
        <translation>Il n’y a qu’un essai ; rien n’a donc pu être prédit qui n’ait servi à l’ajustement.</translation>
    </message>
    <message>
        <source>The residual is not quite random, but no larger than the noise can be trusted to be.</source>
        <translation>Le résidu n’est pas tout à fait aléatoire, mais pas plus grand que ce que vaut le bruit indiqué.</translation>
    </message>
    <message>
        <source>The residual is not quite random, but no larger than what a finer mesh would change of the prediction.</source>
        <translation>Le résidu n’est pas tout à fait aléatoire, mais pas plus grand que ce qu’un maillage plus fin changerait à la prédiction.</translation>
    </message>
    <message>
        <source>{0} was left out: {1}</source>
        <translation>{0} a été écarté : {1}</translation>
    </message>
    <message>
        <source>These data do not determine {0} of {1}.</source>
        <translation>Ces données ne déterminent pas {0} (effet : {1}).</translation>
    </message>
    <message>
        <source>{0} of {1} ended at the limit of its range ({2}).</source>
        <translation>{0} a fini à la limite de son intervalle ({2} ; effet : {1}).</translation>
    </message>
    <message>
        <source>{0} and {1} can hardly be told apart in size (correlation {2}).</source>
        <translation>« {0} » et « {1} » se distinguent à peine par leur ampleur (corrélation {2}).</translation>
    </message>
    <message>
        <source>there is nowhere to begin</source>
        <translation>il n’y a aucune valeur de départ</translation>
    </message>
    <message>
        <source>it promised to take much less of the error than others</source>
        <translation>il promettait d’enlever bien moins d’erreur que d’autres</translation>
    </message>
    <message>
        <source>Deform ten times as slowly.</source>
        <translation>Déformer dix fois plus lentement.</translation>
    </message>
    <message>
        <source>Deform ten times as fast.</source>
        <translation>Déformer dix fois plus vite.</translation>
    </message>
    <message>
        <source>Deform quickly and hold for the length of the longest trial.</source>
        <translation>Déformer rapidement et maintenir pendant la durée de l’essai le plus long.</translation>
    </message>
    <message>
        <source>Load and unload twice.</source>
        <translation>Charger et décharger deux fois.</translation>
    </message>
    <message>
        <source>Deform a fifth further.</source>
        <translation>Déformer d’un cinquième de plus.</translation>
    </message>
    <message>
        <source>Deform to the other side (tension in place of compression, or the reverse).</source>
        <translation>Déformer dans l’autre sens (traction au lieu de compression, ou l’inverse).</translation>
    </message>
    <message>
        <source>Press at ({0}, {1}, {2}) mm with {3} N.</source>
        <translation>Appuyer en ({0}, {1}, {2}) mm avec {3} N.</translation>
    </message>
    <message>
        <source>Press as in trial {0}, but with {1} N.</source>
        <translation>Appuyer comme dans l’essai {0}, mais avec {1} N.</translation>
    </message>
    <message>
        <source>Press as in trial {0} and hold the force for {1} s.</source>
        <translation>Appuyer comme dans l’essai {0} et maintenir la force pendant {1} s.</translation>
    </message>
    <message>
        <source>Pull where trial {0} presses, with {1} N.</source>
        <translation>Tirer là où l’essai {0} appuie, avec {1} N.</translation>
    </message>
    <message>
        <source>Error by load, a line a trial: broken before, whole after</source>
        <translation>Erreur selon la charge, une ligne par essai : tirets avant, continue après</translation>
    </message>
    <message>
        <source>Measured (dots), before (broken), after (line)</source>
        <translation>Mesuré (points), avant (tirets), après (ligne)</translation>
    </message>
    <message>
        <source>What was left before (broken) and after (line)</source>
        <translation>Ce qui restait avant (tirets) et après (ligne)</translation>
    </message>
    <message>
        <source>{0} was made on the data &quot;{1}&quot;, {2} on &quot;{3}&quot;.</source>
        <translation>{0} a été fait sur les données « {1} », {2} sur « {3} ».</translation>
    </message>
    <message>
        <source>{0} and {1} have no case in common.</source>
        <translation>{0} et {1} n&apos;ont aucun cas en commun.</translation>
    </message>
    <message>
        <source>Name the same cases in the first column of both metrics.csv.</source>
        <translation>Nommez les mêmes cas dans la première colonne des deux metrics.csv.</translation>
    </message>
    <message>
        <source>The tolerances name {0}, which neither {1} nor {2} has.</source>
        <translation>Les tolérances nomment {0}, que ni {1} ni {2} n&apos;ont.</translation>
    </message>
    <message>
        <source>{0} must begin with a line case,METRIC,METRIC, ...</source>
        <translation>{0} doit commencer par une ligne case,METRIC,METRIC, ...</translation>
    </message>
    <message>
        <source>Column {0} of {1} has no name of its own.</source>
        <translation>La colonne {0} de {1} n&apos;a pas de nom à elle.</translation>
    </message>
    <message>
        <source>Line {0} of {1} has more cells than the first.</source>
        <translation>La ligne {0} de {1} a plus de cellules que la première.</translation>
    </message>
    <message>
        <source>Line {0} of {1} names no case, or one that was there before.</source>
        <translation>La ligne {0} de {1} ne nomme aucun cas, ou un cas déjà vu.</translation>
    </message>
    <message>
        <source>{0} holds no case.</source>
        <translation>{0} ne contient aucun cas.</translation>
    </message>
    <message>
        <source>{0} holds no metrics.csv.</source>
        <translation>{0} ne contient pas de metrics.csv.</translation>
    </message>
    <message>
        <source>Write one: a line case,METRIC,..., then a row for each case.</source>
        <translation>Écrivez-en un : une ligne case,METRIC,..., puis une ligne par cas.</translation>
    </message>
    <message>
        <source>{0} must lie between 0 and 1.</source>
        <translation>{0} doit être compris entre 0 et 1.</translation>
    </message>
    <message>
        <source>The pictures have different sizes: {0} x {1} and {2} x {3}.</source>
        <translation>Les images ont des tailles différentes : {0} x {1} et {2} x {3}.</translation>
    </message>
    <message>
        <source>The mask of the pictures is black everywhere.</source>
        <translation>Le masque des images est noir partout.</translation>
    </message>
    <message>
        <source>{0}: samples {1}, rows without a reading {2}.</source>
        <translation>{0} : échantillons {1}, lignes sans mesure {2}.</translation>
    </message>
    <message>
        <source>Runs in the trace: {0}, in the log: {1}.</source>
        <translation>Exécutions dans la trace : {0}, dans le journal : {1}.</translation>
    </message>
    <message>
        <source>Gaps in the recording: {0}; runs end there and nothing is made up for them.</source>
        <translation>Trous dans l’enregistrement : {0} ; les exécutions s’y arrêtent et rien n’est inventé à leur place.</translation>
    </message>
    <message>
        <source>Rows without a reading: {0}.</source>
        <translation>Lignes sans mesure : {0}.</translation>
    </message>
    <message>
        <source>Runs that reach the end of a channel&apos;s range, so that their power is a lower bound: {0}. Record again with a larger range.</source>
        <translation>Exécutions qui atteignent la fin de la plage d’un canal, de sorte que leur puissance est une borne inférieure : {0}. Enregistrez de nouveau avec une plage plus grande.</translation>
    </message>
    <message>
        <source>{0} declares an impossible size: {1} x {2} pixels, frames: {3}.</source>
        <translation>{0} déclare une taille impossible : {1} x {2} pixels, images : {3}.</translation>
    </message>
    <message>
        <source>The step would turn cells inside out ({0}): a tool goes too far into the body.</source>
        <translation>Le pas retournerait des cellules ({0}) : un instrument entre trop loin dans le corps.</translation>
    </message>
    <message>
        <source>Cells taken away where the body touched itself in a point or an edge: {0}.</source>
        <translation>Cellules retirées là où le corps se touchait lui-même en un point ou une arête : {0}.</translation>
    </message>
    <message>
        <source>A landmark was followed through {0} of {1} frames.</source>
        <translation>Un repère a été suivi sur {0} des {1} images.</translation>
    </message>
    <message>
        <source>Landmarks that lie far from the points of their frames: {0} of {1}.</source>
        <translation>Repères éloignés des points de leurs images : {0} sur {1}.</translation>
    </message>
    <message>
        <source>Landmarks seen in three frames or more: {0}; four that do not lie on one line are needed.</source>
        <translation>Repères vus dans trois images ou plus : {0} ; il en faut quatre qui ne soient pas alignés.</translation>
    </message>
    <message>
        <source>Too few frames to correlate: {0}; {1} are needed.</source>
        <translation>Trop peu d’images à corréler : {0} ; il en faut {1}.</translation>
    </message>
    <message>
        <source>Landmark {0} was followed through {1} of {2} frames.</source>
        <translation>Le repère {0} a été suivi sur {1} des {2} images.</translation>
    </message>
    <message>
        <source>Landmarks left out, which were seen in fewer than three frames: {0}</source>
        <translation>Repères écartés, vus dans moins de trois images : {0}</translation>
    </message>
    <message>
        <source>Landmarks left out, which lie far from the points of their frames: {0}</source>
        <translation>Repères écartés, éloignés des points de leurs images : {0}</translation>
    </message>
    <message>
        <source>Triangles with all corners in fewer than three frames, whose correlation is 0: {0}</source>
        <translation>Triangles dont tous les sommets sont dans moins de trois images et dont la corrélation est 0 : {0}</translation>
    </message>
    <message>
        <source>The {0} video ends before the other, at frame {1}.</source>
        <translation>La vidéo ({0}) se termine avant l’autre, à l’image {1}.</translation>
    </message>
    <message>
        <source>Frames that show something: {0}; {1} are needed.</source>
        <translation>Images qui montrent quelque chose : {0} ; il en faut {1}.</translation>
    </message>
    <message>
        <source>Held like this, cells of the liver are turned inside out ({0}): nothing can be measured there.</source>
        <translation>Tenu ainsi, des cellules du foie sont retournées ({0}) : rien ne peut y être mesuré.</translation>
    </message>
    <message>
        <source>The structures have changed since the model was built. Landmarks that now lie outside of it are left out ({0}). Build the model anew.</source>
        <translation>Les structures ont changé depuis la construction du modèle. Les repères qui se trouvent maintenant en dehors sont écartés ({0}). Reconstruisez le modèle.</translation>
    </message>
    <message>
        <source>Frames that belong to no trial: {0}.</source>
        <translation>Images qui n’appartiennent à aucun essai : {0}.</translation>
    </message>
    <message>
        <source>The benchmark is not of this sequence, with its landmarks ({0}) and frames ({1}).</source>
        <translation>La référence n’est pas celle de cette séquence, avec ses repères ({0}) et ses images ({1}).</translation>
    </message>
    <message>
        <source>landmarks that the benchmark has no place for were left out: {0}</source>
        <translation>repères laissés de côté, pour lesquels la référence n’a pas de place : {0}</translation>
    </message>
    <message>
        <source>The history of {0} has no step {1}.</source>
        <translation>L’historique de {0} n’a pas d’étape {1}.</translation>
    </message>
    <message>
        <source>See which there are: glisson-cli macro CASE.</source>
        <translation>Voyez lesquelles existent : glisson-cli macro CASE.</translation>
    </message>
    <message>
        <source>Step {1} of {0} changed a view and nothing in the case.</source>
        <translation>L’étape {1} de {0} a changé une vue et rien dans le cas.</translation>
    </message>
    <message>
        <source>Step {0} of {1} began with another {2} than {3} holds.</source>
        <translation>L’étape {0} de {1} est partie d’un autre {2} que celui de {3}.</translation>
    </message>
    <message>
        <source>Begin with the case as it was, and do all steps in their order.</source>
        <translation>Partez du cas tel qu’il était et refaites toutes les étapes dans leur ordre.</translation>
    </message>
    <message>
        <source>{0} no longer holds what a step of its history led to: {1}.</source>
        <translation>{0} ne contient plus ce à quoi une étape de son historique a conduit : {1}.</translation>
    </message>
    <message>
        <source>Another program has changed it; do this step in the window.</source>
        <translation>Un autre programme l’a changé ; faites cette étape dans la fenêtre.</translation>
    </message>
    <message>
        <source>No case fits in {0} minutes.</source>
        <translation>Aucun cas ne tient en {0} minutes.</translation>
    </message>
    <message>
        <source>Give more minutes, or a history with shorter cases.</source>
        <translation>Donnez plus de minutes, ou un historique aux cas plus courts.</translation>
    </message>
    <message>
        <source>{0} must begin with a line case,seconds,METRIC, ... and hold a row a case a run.</source>
        <translation>{0} doit commencer par une ligne case,seconds,MESURE, ... et avoir une ligne par cas et par exécution.</translation>
    </message>
    <message>
        <source>A column of {0} is there twice.</source>
        <translation>Une colonne de {0} y est deux fois.</translation>
    </message>
    <message>
        <source>Line {0} of {1} names no case, or has more cells than the first.</source>
        <translation>La ligne {0} de {1} ne nomme aucun cas, ou a plus de cellules que la première.</translation>
    </message>
    <message>
        <source>{0} names no case.</source>
        <translation>{0} ne nomme aucun cas.</translation>
    </message>
    <message>
        <source>Make it with glisson-cli gate-cases.</source>
        <translation>Faites-le avec glisson-cli gate-cases.</translation>
    </message>
    <message>
        <source>Stiffness from the waves</source>
        <translation>Rigidité à partir des ondes</translation>
    </message>
    <message>
        <source>A frame is this program&apos;s own: {0}. Carried over from another machine in proportion to memory and arithmetic; nobody has run it on these platforms.</source>
        <translation>Une image est celle de ce programme : {0}. Reportée d’une autre machine en proportion de la mémoire et du calcul ; personne ne l’a exécutée sur ces plateformes.</translation>
    </message>
    <message>
        <source>The task {0} moves no bytes and takes no operations.</source>
        <translation>La tâche {0} ne déplace aucun octet et ne demande aucune opération.</translation>
    </message>
    <message>
        <source>{0} has no list &quot;tasks&quot; of 1 to {1} tasks.</source>
        <translation>{0} n’a pas de liste &quot;tasks&quot; de 1 à {1} tâches.</translation>
    </message>
    <message>
        <source>Two tasks have the id &quot;{0}&quot;.</source>
        <translation>Deux tâches ont l’identifiant &quot;{0}&quot;.</translation>
    </message>
    <message>
        <source>A support that moves by a displacement is there for equilibrium by finite elements, without tools, motion, walls kept apart and data in place of a law.</source>
        <translation>Un appui qui se déplace d&apos;une valeur imposée existe pour l&apos;équilibre par éléments finis, sans instruments, mouvement, parois tenues séparées ni données à la place d&apos;une loi.</translation>
    </message>
    <message>
        <source>The displacement of support {0} is not a finite vector.</source>
        <translation>Le déplacement de l&apos;appui {0} n&apos;est pas un vecteur fini.</translation>
    </message>
    <message>
        <source>Support {0} moves points that another support holds or moves elsewhere.</source>
        <translation>L&apos;appui {0} déplace des points qu&apos;un autre appui maintient ou déplace ailleurs.</translation>
    </message>
    <message>
        <source>Let each point be held by one support, or in other directions.</source>
        <translation>Que chaque point soit maintenu par un seul appui, ou dans d&apos;autres directions.</translation>
    </message>
    <message>
        <source>{0} moves by a displacement: it is neither a foundation nor a ligament.</source>
        <translation>{0} se déplace d&apos;une valeur imposée : ce n&apos;est ni une fondation ni un ligament.</translation>
    </message>
    <message>
        <source>{0} is moved in a direction that its &quot;directions&quot; leave free.</source>
        <translation>{0} est déplacé dans une direction que ses &quot;directions&quot; laissent libre.</translation>
    </message>
    <message>
        <source>Resolutions must grow from 0.5 mm3 or more to 1700 mm3 or less, in 2 to 100 steps.</source>
        <translation>Les résolutions doivent croître de 0.5 mm3 ou plus à 1700 mm3 ou moins, en 2 à 100 pas.</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Échantillonnage</translation>
    </message>
    <message>
        <source>The matching study takes ascending numbers of points from 8 to 1024, starts of 0 or more, 1 to 1000 passes and livers, and two or more poses of each shape.</source>
        <translation>L’étude d’appariement prend des nombres de points croissants de 8 à 1024, des départs à partir de 0, de 1 à 1000 passes et foies, et deux poses ou plus de chaque forme.</translation>
    </message>
    <message>
        <source>There is no task &quot;{0}&quot;.</source>
        <translation>Il n’y a pas de tâche &quot;{0}&quot;.</translation>
    </message>
    <message>
        <source>Use product or one of: {1}.</source>
        <translation>Utilisez product ou l’une de : {1}.</translation>
    </message>
    <message>
        <source>The hidden targets, which nothing was fitted to, are farther off with what was found ({0} mm on average) than without it ({1} mm): do not take it for the cause.</source>
        <translation>Les cibles cachées, auxquelles rien n&apos;a été ajusté, sont plus loin avec ce qui a été trouvé (en moyenne {0} mm) que sans cela ({1} mm) : ne le prenez pas pour la cause.</translation>
    </message>
    <message>
        <source>Copy the plan {0}</source>
        <translation>Copier le plan {0}</translation>
    </message>
    <message>
        <source>Set an ablation zone</source>
        <translation>Placer une zone d’ablation</translation>
    </message>
    <message>
        <source>Cut around a tumour</source>
        <translation>Section autour d’une tumeur</translation>
    </message>
    <message>
        <source>Cut along a territory</source>
        <translation>Section le long d’un territoire</translation>
    </message>
    <message>
        <source>Cut by segments</source>
        <translation>Section par segments</translation>
    </message>
    <message>
        <source>Change an ablation zone</source>
        <translation>Modifier une zone d’ablation</translation>
    </message>
    <message>
        <source>Give back what was to go</source>
        <translation>Rendre ce qui devait partir</translation>
    </message>
    <message>
        <source>No branch is named that is to be embolised.</source>
        <translation>Aucune branche à emboliser n’est nommée.</translation>
    </message>
    <message>
        <source>A growth of {0} % is not between 0 and {1} %.</source>
        <translation>Une croissance de {0} % n’est pas entre 0 et {1} %.</translation>
    </message>
    <message>
        <source>{0} is no branch of the portal vein.</source>
        <translation>{0} n’est pas une branche de la veine porte.</translation>
    </message>
    <message>
        <source>The tool {0} spreads its force over a patch, which a session knows at large strain alone.</source>
        <translation>L’instrument {0} répartit sa force sur une surface, ce qu’une séance ne connaît qu’aux grandes déformations.</translation>
    </message>
    <message>
        <source>Take the material neo-hookean, or jaws that pull.</source>
        <translation>Prenez le matériau neo-hookean, ou des mors qui tirent.</translation>
    </message>
    <message>
        <source>Computed with large deformations (neo-Hookean).</source>
        <translation>Calculé aux grandes déformations (néo-hookéen).</translation>
    </message>
    <message>
        <source>Computed with small deformations (linear).</source>
        <translation>Calculé aux petites déformations (linéaire).</translation>
    </message>
    <message>
        <source>The liver had not come to rest: landmarks are within {0} mm of it.</source>
        <translation>Le foie n’était pas venu au repos : les repères en sont à {0} mm au plus.</translation>
    </message>
    <message>
        <source>This is no liver as the model&apos;s {0}: {1} mm are left between both, and its modes are {2} standard deviations out on average.</source>
        <translation>Ce n&apos;est pas un foie comme les {0} du modèle : il reste {1} mm entre les deux, et ses modes sont en moyenne à {2} écarts types.</translation>
    </message>
    <message>
        <source>Look at spacing and affine; a resected or transplanted liver cannot be completed by a model of whole ones.</source>
        <translation>Vérifiez l&apos;espacement et la matrice affine ; un foie réséqué ou transplanté ne peut être complété par un modèle de foies entiers.</translation>
    </message>
    <message>
        <source>The model&apos;s livers come nearer to this one&apos;s mirror image: left and right are exchanged, or the patient is a rare one.</source>
        <translation>Les foies du modèle sont plus proches de l&apos;image miroir de celui-ci : la gauche et la droite sont échangées, ou le patient est un cas rare.</translation>
    </message>
    <message>
        <source>Look at the file&apos;s affine: which way its first axis runs.</source>
        <translation>Vérifiez la matrice affine du fichier : dans quel sens va son premier axe.</translation>
    </message>
    <message>
        <source>The liver&apos;s mirror image is more like a liver ({0} mm from a typical one, against {1} mm): left and right are exchanged, or the patient is a rare one.</source>
        <translation>L&apos;image miroir du foie ressemble davantage à un foie ({0} mm d&apos;un foie typique, contre {1} mm) : la gauche et la droite sont échangées, ou le patient est un cas rare.</translation>
    </message>
    <message>
        <source>A typical liver cannot be bent onto this one: {0} mm are left on average.</source>
        <translation>Un foie typique ne peut être déformé jusqu&apos;à celui-ci : il reste {0} mm en moyenne.</translation>
    </message>
    <message>
        <source>Look whether the labels are one whole liver, neither resected nor transplanted.</source>
        <translation>Vérifiez que les étiquettes sont un foie entier, ni réséqué ni transplanté.</translation>
    </message>
    <message>
        <source>No liver of {0} drawn from the model is a body of 400 to 5000 ml.</source>
        <translation>Aucun des {0} foies tirés du modèle n&apos;est un corps de 400 à 5000 ml.</translation>
    </message>
    <message>
        <source>The liver has {0} ml, which no adult&apos;s liver has.</source>
        <translation>Le foie fait {0} ml, ce que ne fait celui d&apos;aucun adulte.</translation>
    </message>
    <message>
        <source>Look whether the labels&apos; spacing is the scan&apos;s and all of them are liver.</source>
        <translation>Vérifiez que l&apos;espacement des étiquettes est celui de l&apos;examen et qu&apos;elles sont toutes du foie.</translation>
    </message>
    <message>
        <source>All voxels are said to be 1 x 1 x 1 mm, as in files that have lost their spacing; the liver&apos;s size would be a guess.</source>
        <translation>Tous les voxels seraient de 1 x 1 x 1 mm, comme dans les fichiers qui ont perdu leur espacement ; la taille du foie serait devinée.</translation>
    </message>
    <message>
        <source>Write the scan&apos;s spacing into the labels, or say that it is true.</source>
        <translation>Écrivez l&apos;espacement de l&apos;examen dans les étiquettes, ou dites qu&apos;il est vrai.</translation>
    </message>
    <message>
        <source>No voxel of the labels is a liver&apos;s.</source>
        <translation>Aucun voxel des étiquettes n&apos;est d&apos;un foie.</translation>
    </message>
    <message>
        <source>The liver lies in pieces that do not touch; the second of them holds {0} %.</source>
        <translation>Le foie est en morceaux qui ne se touchent pas ; le deuxième en contient {0} %.</translation>
    </message>
    <message>
        <source>Mend the labels, or take the piece that is the liver.</source>
        <translation>Corrigez les étiquettes, ou prenez le morceau qui est le foie.</translation>
    </message>
    <message>
        <source>The file is no shape model: its point array {0} is missing or damaged.</source>
        <translation>Le fichier n&apos;est pas un modèle de forme : son champ de points {0} manque ou est endommagé.</translation>
    </message>
    <message>
        <source>Give a model.vtp that &quot;study shapes&quot; has made.</source>
        <translation>Donnez un model.vtp fait par &quot;study shapes&quot;.</translation>
    </message>
    <message>
        <source>fitting the shape</source>
        <translation>ajustement de la forme</translation>
    </message>
    <message>
        <source>What is seen of the liver does not come to lie on the model anywhere.</source>
        <translation>Ce qui est vu du foie ne vient se poser nulle part sur le modèle.</translation>
    </message>
    <message>
        <source>Look whether it is in the patient&apos;s frame (LPS, mm) and is a liver.</source>
        <translation>Vérifiez qu&apos;il est dans le repère du patient (LPS, mm) et que c&apos;est un foie.</translation>
    </message>
    <message>
        <source>A shape model needs {0} shapes or more; there are {1}.</source>
        <translation>Un modèle de forme demande {0} formes ou plus ; il y en a {1}.</translation>
    </message>
    <message>
        <source>The shapes have different points or triangles.</source>
        <translation>Les formes ont des points ou des triangles différents.</translation>
    </message>
    <message>
        <source>The image cuts the liver off towards {0}: a model learns from whole ones.</source>
        <translation>L&apos;image coupe le foie (côté : {0}) : un modèle apprend de foies entiers.</translation>
    </message>
    <message>
        <source>The folder holds no label maps of livers.</source>
        <translation>Le dossier ne contient pas de cartes d&apos;étiquettes de foies.</translation>
    </message>
    <message>
        <source>Give one with a file a liver, as ID_liver.nii.gz.</source>
        <translation>Donnez-en un avec un fichier par foie, comme ID_liver.nii.gz.</translation>
    </message>
    <message>
        <source>Small or large deformations</source>
        <translation>Petites ou grandes déformations</translation>
    </message>
    <message>
        <source>The whole organ is stiffer or softer than declared, everywhere by the same factor.</source>
        <translation>L&apos;organe entier est plus raide ou plus souple que déclaré, partout du même facteur.</translation>
    </message>
    <message>
        <source>What holds the organ gives way like a spring: all of it moves when a tool moves it.</source>
        <translation>Ce qui tient l&apos;organe cède comme un ressort : il bouge tout entier quand un instrument le déplace.</translation>
    </message>
    <message>
        <source>The camera stands elsewhere than declared: everything is seen turned and shifted alike.</source>
        <translation>La caméra se trouve ailleurs que déclaré : tout est vu tourné et décalé de la même façon.</translation>
    </message>
    <message>
        <source>The tools push with another force than declared, by the same factor in all frames.</source>
        <translation>Les instruments poussent avec une autre force que déclaré, du même facteur sur toutes les images.</translation>
    </message>
    <message>
        <source>Probability that nothing is missing: {1}; next comes: {2}, {3}.</source>
        <translation>Probabilité que rien ne manque : {1} ; vient ensuite : {2}, {3}.</translation>
    </message>
    <message>
        <source>Probability that nothing is missing: {1}.</source>
        <translation>Probabilité que rien ne manque : {1}.</translation>
    </message>
    <message>
        <source>Probability of {0}: {1}; next comes: {2}, {3}.</source>
        <translation>Probabilité de {0} : {1} ; vient ensuite : {2}, {3}.</translation>
    </message>
    <message>
        <source>Probability of {0}: {1}.</source>
        <translation>Probabilité de {0} : {1}.</translation>
    </message>
    <message>
        <source>Probability that something acts which is not in the catalogue: {1}; next comes: {2}, {3}.</source>
        <translation>Probabilité qu&apos;agisse quelque chose qui n&apos;est pas au catalogue : {1} ; vient ensuite : {2}, {3}.</translation>
    </message>
    <message>
        <source>Probability that something acts which is not in the catalogue: {1}.</source>
        <translation>Probabilité qu&apos;agisse quelque chose qui n&apos;est pas au catalogue : {1}.</translation>
    </message>
    <message>
        <source>The whole specimen is stiffer or softer than declared, everywhere by the same factor.</source>
        <translation>L&apos;échantillon entier est plus raide ou plus souple que déclaré, partout du même facteur.</translation>
    </message>
    <message>
        <source>The tissue stiffens the further it is strained: pressing twice as hard dents it less than twice as deep.</source>
        <translation>Le tissu se raidit à mesure qu&apos;il est déformé : appuyer deux fois plus fort l&apos;enfonce de moins du double.</translation>
    </message>
    <message>
        <source>What holds the specimen gives way like a spring: all of it moves a little when it is pressed.</source>
        <translation>Ce qui tient l&apos;échantillon cède comme un ressort : il bouge un peu tout entier quand on appuie.</translation>
    </message>
    <message>
        <source>Somewhere inside lies a stiff lump, as a tumour would: around it the specimen moves less.</source>
        <translation>Quelque part à l&apos;intérieur se trouve une masse raide, comme une tumeur : autour d&apos;elle l&apos;échantillon bouge moins.</translation>
    </message>
    <message>
        <source>The tissue creeps: held under a steady force it goes on giving way for a while.</source>
        <translation>Le tissu flue : sous une force constante, il continue de céder un moment.</translation>
    </message>
    <message>
        <source>The load cell is off: it does not read zero when untouched, or it reads too much or too little.</source>
        <translation>Le capteur de force est faux : il n&apos;indique pas zéro sans contact, ou il indique trop ou trop peu.</translation>
    </message>
    <message>
        <source>The camera&apos;s coordinates do not match the specimen&apos;s: all markers seem shifted or turned alike.</source>
        <translation>Les coordonnées de la caméra ne correspondent pas à celles de l&apos;échantillon : tous les marqueurs semblent décalés ou tournés de la même façon.</translation>
    </message>
    <message>
        <source>The tissue has fibres: it is stiffer (or softer) along one direction than across it.</source>
        <translation>Le tissu a des fibres : il est plus raide (ou plus souple) dans une direction qu&apos;en travers.</translation>
    </message>
    <message>
        <source>A skin around the specimen (as Glisson&apos;s capsule around the liver) carries part of the load.</source>
        <translation>Une peau autour de l&apos;échantillon (comme la capsule de Glisson autour du foie) porte une partie de la charge.</translation>
    </message>
    <message>
        <source>Something else loaded the specimen while it was measured, and not when its shape was taken: its weight, or a pressure around it.</source>
        <translation>Autre chose chargeait l&apos;échantillon pendant la mesure, et non quand sa forme a été relevée : son poids ou une pression autour de lui.</translation>
    </message>
    <message>
        <source>× noise</source>
        <translation>× bruit</translation>
    </message>
    <message>
        <source>What the declared model lacks, by the measurements</source>
        <translation>Ce qui manque au modèle déclaré, d&apos;après les mesures</translation>
    </message>
    <message>
        <source>What these trials could have shown</source>
        <translation>Ce que ces essais auraient pu montrer</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Ce qui a été trouvé</translation>
    </message>
    <message>
        <source>A smooth correction over load and place predicts trials better that it was not fitted to. It claims no cause.</source>
        <translation>Une correction lisse selon la charge et le lieu prédit mieux des essais auxquels elle n&apos;a pas été ajustée. Elle n&apos;affirme aucune cause.</translation>
    </message>
    <message>
        <source>Candidates, each by itself</source>
        <translation>Candidats, chacun à lui seul</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>What to measure next</source>
        <translation>Que mesurer ensuite</translation>
    </message>
    <message>
        <source>No further trial is needed to tell the leading explanations apart, or none is known that would.</source>
        <translation>Aucun autre essai n&apos;est nécessaire pour distinguer les principales explications, ou aucun n&apos;est connu qui le ferait.</translation>
    </message>
    <message>
        <source>Glisson plans and reviews liver surgery. Not a medical device.</source>
        <translation>Glisson prépare et relit la chirurgie du foie. Ce n&apos;est pas un dispositif médical.</translation>
    </message>
    <message>
        <source>What is left is noise: no test finds anything that noise would not do.</source>
        <translation>Ce qui reste est du bruit : aucun test ne trouve quoi que ce soit que le bruit ne ferait pas.</translation>
    </message>
    <message>
        <source>What is left is not noise: {0}.</source>
        <translation>Ce qui reste n&apos;est pas du bruit : {0}.</translation>
    </message>
    <message>
        <source>From this value on, nine of ten such experiments would have shown the effect</source>
        <translation>À partir de cette valeur, neuf expériences de ce genre sur dix auraient montré l&apos;effet</translation>
    </message>
    <message>
        <source>effect</source>
        <translation>effet</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>paramètre</translation>
    </message>
    <message>
        <source>without effect</source>
        <translation>sans effet</translation>
    </message>
    <message>
        <source>seen from</source>
        <translation>visible dès</translation>
    </message>
    <message>
        <source>at no size in its range</source>
        <translation>à aucune valeur de son domaine</translation>
    </message>
    <message>
        <source>Errors ({0})</source>
        <translation>Erreurs ({0})</translation>
    </message>
    <message>
        <source>before</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>after</source>
        <translation>après</translation>
    </message>
    <message>
        <source>root mean square, trials that were fitted</source>
        <translation>moyenne quadratique, essais ajustés</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>95 of 100 are below</source>
        <translation>95 sur 100 sont en dessous</translation>
    </message>
    <message>
        <source>chi-squared over number</source>
        <translation>khi-deux sur nombre</translation>
    </message>
    <message>
        <source>{0} ({1} to {2})</source>
        <translation>{0} ({1} à {2})</translation>
    </message>
    <message>
        <source>root mean square, trials left out whole</source>
        <translation>moyenne quadratique, essais entièrement écartés</translation>
    </message>
    <message>
        <source>hidden targets, which nothing was fitted to: mean (mm)</source>
        <translation>cibles cachées, auxquelles rien n&apos;a été ajusté : moyenne (mm)</translation>
    </message>
    <message>
        <source>hidden targets: the farthest (mm)</source>
        <translation>cibles cachées : la plus éloignée (mm)</translation>
    </message>
    <message>
        <source>noise of the measurement</source>
        <translation>bruit de la mesure</translation>
    </message>
    <message>
        <source>Parameters, with standard deviation and 95 % interval</source>
        <translation>Paramètres, avec écart type et intervalle à 95 %</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>could also be</source>
        <translation>pourrait aussi être</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>non déterminé</translation>
    </message>
    <message>
        <source>Errors in {0}; the lower the BIC, the better</source>
        <translation>Erreurs en {0} ; plus le BIC est bas, mieux c&apos;est</translation>
    </message>
    <message>
        <source>error fitted</source>
        <translation>erreur ajustée</translation>
    </message>
    <message>
        <source>error on trials left out</source>
        <translation>erreur sur les essais écartés</translation>
    </message>
    <message>
        <source>change of BIC</source>
        <translation>variation du BIC</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>remarque</translation>
    </message>
    <message>
        <source>left out: {0}</source>
        <translation>écarté : {0}</translation>
    </message>
    <message>
        <source>like {0}</source>
        <translation>comme {0}</translation>
    </message>
    <message>
        <source>Probability of each explanation, all that were weighed taken together</source>
        <translation>Probabilité de chaque explication, toutes celles pesées prises ensemble</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>autre chose</translation>
    </message>
    <message>
        <source>nothing is missing</source>
        <translation>rien ne manque</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} et {1}</translation>
    </message>
    <message>
        <source>force (N)</source>
        <translation>force (N)</translation>
    </message>
    <message>
        <source>error ({0})</source>
        <translation>erreur ({0})</translation>
    </message>
    <message>
        <source>Residual before, trial {0} at its worst: arrows {1} times as long, red at {2} mm</source>
        <translation>Résidu avant, essai {0} au pire moment : flèches {1} fois plus longues, rouge à {2} mm</translation>
    </message>
    <message>
        <source>Residual after, trial {0} at its worst: arrows {1} times as long, red at {2} mm</source>
        <translation>Résidu après, essai {0} au pire moment : flèches {1} fois plus longues, rouge à {2} mm</translation>
    </message>
    <message>
        <source>voltage (V)</source>
        <translation>tension (V)</translation>
    </message>
    <message>
        <source>temperature (°C)</source>
        <translation>température (°C)</translation>
    </message>
    <message>
        <source>power (W)</source>
        <translation>puissance (W)</translation>
    </message>
    <message>
        <source>stress (kPa)</source>
        <translation>contrainte (kPa)</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>temps (s)</translation>
    </message>
    <message>
        <source>strain</source>
        <translation>déformation</translation>
    </message>
    <message>
        <source>residual: {0}</source>
        <translation>résidu : {0}</translation>
    </message>
    <message>
        <source>The image cuts the liver off towards {0}: only whole ones can be retracted.</source>
        <translation>L&apos;image coupe le foie (côté : {0}) : seuls des foies entiers peuvent être rétractés.</translation>
    </message>
    <message>
        <source>The tissue&apos;s own law found no equilibrium: {0}</source>
        <translation>La loi même du tissu n’a trouvé aucun équilibre : {0}</translation>
    </message>
    <message>
        <source>Measurements must be 3 to 100000, noise 0 to 50 % of the largest stress, and at most 20 of each are tried.</source>
        <translation>Il faut 3 à 100000 mesures, un bruit de 0 à 50 % de la plus grande contrainte, et l’on essaie au plus 20 de chaque.</translation>
    </message>
    <message>
        <source>Tests must go to 5 % strain or farther, to 100 % at most, forces be up to 100 N, and a liver have 200 cells or more.</source>
        <translation>Les essais doivent dépasser 5 % de déformation, 100 % au plus, les forces ne pas dépasser 100 N, et un foie avoir 200 cellules ou plus.</translation>
    </message>
    <message>
        <source>The specimen&apos;s state must be &quot;plane-strain&quot;.</source>
        <translation>L&apos;état de l&apos;éprouvette doit être &quot;plane-strain&quot;.</translation>
    </message>
    <message>
        <source>Plane stress is not known here: a thin sheet needs a law for its thickness.</source>
        <translation>La contrainte plane n&apos;est pas connue ici : une feuille mince demande une loi pour son épaisseur.</translation>
    </message>
    <message>
        <source>{0} has {1} points; at most {2} are used.</source>
        <translation>{0} a {1} points ; au plus {2} sont utilisés.</translation>
    </message>
    <message>
        <source>Give the field on a coarser mesh.</source>
        <translation>Donnez le champ sur un maillage plus grossier.</translation>
    </message>
    <message>
        <source>{0} does not lie in a plane of equal z.</source>
        <translation>{0} n&apos;est pas dans un plan de même z.</translation>
    </message>
    <message>
        <source>{0} has a triangle without area (at {1}, {2}).</source>
        <translation>{0} a un triangle sans aire (en {1}, {2}).</translation>
    </message>
    <message>
        <source>The laws are {1}.</source>
        <translation>Les lois sont {1}.</translation>
    </message>
    <message>
        <source>{0} must lie between -1 and 0.5.</source>
        <translation>{0} doit être entre -1 et 0.5.</translation>
    </message>
    <message>
        <source>The law {0} has no number called &quot;{1}&quot;.</source>
        <translation>La loi {0} n&apos;a pas de nombre appelé &quot;{1}&quot;.</translation>
    </message>
    <message>
        <source>Its numbers are {2}.</source>
        <translation>Ses nombres sont {2}.</translation>
    </message>
    <message>
        <source>The declared law lacks some of its numbers: {0}.</source>
        <translation>Il manque à la loi déclarée certains de ses nombres : {0}.</translation>
    </message>
    <message>
        <source>Give all of them, or none: then they are found first, and the law&apos;s name alone is declared.</source>
        <translation>Donnez-les tous, ou aucun : ils sont alors trouvés d&apos;abord, et seul le nom de la loi est déclaré.</translation>
    </message>
    <message>
        <source>{0} has no column &quot;{1}&quot; in its first line.</source>
        <translation>{0} n&apos;a pas de colonne &quot;{1}&quot; dans sa première ligne.</translation>
    </message>
    <message>
        <source>Displacements stand in point,ux,uy, reactions in boundary,fx,fy.</source>
        <translation>Les déplacements sont dans point,ux,uy, les réactions dans boundary,fx,fy.</translation>
    </message>
    <message>
        <source>{0} holds no row beneath its first line.</source>
        <translation>{0} ne contient rien sous sa première ligne.</translation>
    </message>
    <message>
        <source>Line {0} of {1} names no point of the mesh, which has {2} from 0 on.</source>
        <translation>La ligne {0} de {1} ne nomme aucun point du maillage, qui en a {2} à partir de 0.</translation>
    </message>
    <message>
        <source>Points are numbered as in the mesh, from 0.</source>
        <translation>Les points sont numérotés comme dans le maillage, à partir de 0.</translation>
    </message>
    <message>
        <source>{0} names the point array &quot;{1}&quot;, which the mesh does not have.</source>
        <translation>{0} nomme le tableau de points &quot;{1}&quot;, que le maillage n&apos;a pas.</translation>
    </message>
    <message>
        <source>{0} names the boundary &quot;{1}&quot;, of which the mesh has no points.</source>
        <translation>{0} nomme le bord &quot;{1}&quot;, dont le maillage n&apos;a aucun point.</translation>
    </message>
    <message>
        <source>Boundaries are sides (left, right, bottom, top), point arrays of the mesh, groups in its arrays &quot;group_x&quot; and &quot;group_y&quot;, or stand under &quot;boundaries&quot; in the experiment.</source>
        <translation>Les bords sont des côtés (left, right, bottom, top), des tableaux de points du maillage, des groupes de ses tableaux &quot;group_x&quot; et &quot;group_y&quot;, ou figurent sous &quot;boundaries&quot; dans l&apos;expérience.</translation>
    </message>
    <message>
        <source>Nothing says where the plate is held or moved in {0}.</source>
        <translation>Rien ne dit où la plaque est tenue ou déplacée selon {0}.</translation>
    </message>
    <message>
        <source>Name the boundaries in the tables of reactions, or under &quot;boundaries&quot; in the experiment.</source>
        <translation>Nommez les bords dans les tableaux des réactions, ou sous &quot;boundaries&quot; dans l&apos;expérience.</translation>
    </message>
    <message>
        <source>No reaction is given where a displacement is prescribed.</source>
        <translation>Aucune réaction n&apos;est donnée là où un déplacement est imposé.</translation>
    </message>
    <message>
        <source>Displacements alone do not say how stiff the material is.</source>
        <translation>Les déplacements seuls ne disent pas la rigidité du matériau.</translation>
    </message>
    <message>
        <source>The noise of displacements is stated as {0}, but neighbouring points differ by {1}, which was taken in its place.</source>
        <translation>Le bruit des déplacements est donné comme {0}, mais des points voisins diffèrent de {1}, qui a été pris à sa place.</translation>
    </message>
    <message>
        <source>The noise of displacements is stated as {0}, but neighbouring points differ by {1} alone: was the field smoothed? Smoothing leaves errors that neighbours share.</source>
        <translation>Le bruit des déplacements est donné comme {0}, mais des points voisins ne diffèrent que de {1} : le champ a-t-il été lissé ? Le lissage laisse des erreurs que les voisins partagent.</translation>
    </message>
    <message>
        <source>The noise of reactions is not stated; as opposite ones balance, {0} was taken.</source>
        <translation>Le bruit des réactions n&apos;est pas donné ; d&apos;après l&apos;équilibre des réactions opposées, {0} a été pris.</translation>
    </message>
    <message>
        <source>The noise of reactions is not stated; {0} was taken, two thousandths of the largest.</source>
        <translation>Le bruit des réactions n&apos;est pas donné ; {0} a été pris, deux millièmes de la plus grande.</translation>
    </message>
    <message>
        <source>No law has an equilibrium near these displacements.</source>
        <translation>Aucune loi n&apos;a d&apos;équilibre près de ces déplacements.</translation>
    </message>
    <message>
        <source>Are points numbered as in the mesh, and are boundaries where the forces were measured?</source>
        <translation>Les points sont-ils numérotés comme dans le maillage, et les bords là où les forces ont été mesurées ?</translation>
    </message>
    <message>
        <source>The material resists shear and change of volume by another law than the one that is declared.</source>
        <translation>Le matériau résiste au cisaillement et au changement de volume par une autre loi que celle déclarée.</translation>
    </message>
    <message>
        <source>The material is stiffer along fibres than across them.</source>
        <translation>Le matériau est plus rigide le long de fibres qu&apos;en travers.</translation>
    </message>
    <message>
        <source>The law {0} has no equilibrium in trial {1}.</source>
        <translation>La loi {0} n&apos;a pas d&apos;équilibre dans l&apos;essai {1}.</translation>
    </message>
    <message>
        <source>Are its numbers in the unit of the reactions over lengths, and large enough?</source>
        <translation>Ses nombres sont-ils dans l&apos;unité des réactions par longueur, et assez grands ?</translation>
    </message>
    <message>
        <source>The reactions are those of a solution on the mesh&apos;s own linear triangles, not of a plate: that error is in what is predicted for them.</source>
        <translation>Les réactions sont celles d&apos;une solution sur les triangles linéaires du maillage, non celles d&apos;une plaque : cette erreur est dans ce qui est prédit pour elles.</translation>
    </message>
    <message>
        <source>Displacements and reactions are those of a solution on the mesh&apos;s own linear triangles, not of a plate: that error is in what is predicted.</source>
        <translation>Déplacements et réactions sont ceux d&apos;une solution sur les triangles linéaires du maillage, non ceux d&apos;une plaque : cette erreur est dans ce qui est prédit.</translation>
    </message>
    <message>
        <source>The declared law stands without numbers: the best ones were taken as declared.</source>
        <translation>La loi déclarée est sans nombres : les meilleurs ont été pris comme déclarés.</translation>
    </message>
    <message>
        <source>The declared law {0} stands without numbers.</source>
        <translation>La loi déclarée {0} est sans nombres.</translation>
    </message>
    <message>
        <source>Give them under &quot;declared&quot;, or a model.json with --with.</source>
        <translation>Donnez-les sous &quot;declared&quot;, ou un model.json avec --with.</translation>
    </message>
    <message>
        <source>Cell {1} of {0} is a {2} of {3} points; only triangles and quadrangles are used.</source>
        <translation>La cellule {1} de {0} est un {2} de {3} points ; seuls triangles et quadrangles sont utilisés.</translation>
    </message>
    <message>
        <source>Cut it into triangles first, for example with ParaView&apos;s Triangulate.</source>
        <translation>Découpez-le d&apos;abord en triangles, par exemple avec Triangulate de ParaView.</translation>
    </message>
    <message>
        <source>largest strain</source>
        <translation>plus grande déformation</translation>
    </message>
    <message>
        <source>Residual before, trial {0} at its worst: arrows {1} times as long, red at {2}</source>
        <translation>Résidu avant, essai {0} au pire : flèches {1} fois plus longues, rouge à {2}</translation>
    </message>
    <message>
        <source>Residual after, trial {0} at its worst: arrows {1} times as long, red at {2}</source>
        <translation>Résidu après, essai {0} au pire : flèches {1} fois plus longues, rouge à {2}</translation>
    </message>
    <message>
        <source>Set the cut</source>
        <translation>Placer la section</translation>
    </message>
    <message>
        <source>Take the cut away</source>
        <translation>Retirer la section</translation>
    </message>
    <message>
        <source>Change the cut</source>
        <translation>Modifier la section</translation>
    </message>
    <message>
        <source>{0} failed ({1}): {2}</source>
        <translation>{0} a échoué ({1}) : {2}</translation>
    </message>
    <message>
        <source>Run it by hand to see all that it says.</source>
        <translation>Lancez-le à la main pour voir tout ce qu’il dit.</translation>
    </message>
    <message>
        <source>In the command {0} a quotation mark is not closed.</source>
        <translation>Dans la commande {0}, un guillemet n’est pas fermé.</translation>
    </message>
    <message>
        <source>Close it, or write \ before it.</source>
        <translation>Fermez-le, ou écrivez \ devant.</translation>
    </message>
    <message>
        <source>The command is empty.</source>
        <translation>La commande est vide.</translation>
    </message>
    <message>
        <source>There is no program {0} on this computer.</source>
        <translation>Il n’y a pas de programme {0} sur cet ordinateur.</translation>
    </message>
    <message>
        <source>Install it, or write where it lies.</source>
        <translation>Installez-le, ou écrivez où il se trouve.</translation>
    </message>
    <message>
        <source>{0} could not be started: {1}</source>
        <translation>{0} n’a pas pu être lancé : {1}</translation>
    </message>
    <message>
        <source>Check that it may be run.</source>
        <translation>Vérifiez qu’il peut être exécuté.</translation>
    </message>
    <message>
        <source>Handing over the images</source>
        <translation>Remise des images</translation>
    </message>
    <message>
        <source>As in: TotalSegmentator -i {image} -o {folder}</source>
        <translation>Comme dans : TotalSegmentator -i {image} -o {folder}</translation>
    </message>
    <message>
        <source>The command {0} is given no image.</source>
        <translation>La commande {0} ne reçoit aucune image.</translation>
    </message>
    <message>
        <source>The command {0} is not told where to put what it outlines.</source>
        <translation>Rien ne dit à la commande {0} où mettre ses contours.</translation>
    </message>
    <message>
        <source>The command {0} ended, and left no label map.</source>
        <translation>La commande {0} s’est terminée sans laisser de carte d’étiquettes.</translation>
    </message>
    <message>
        <source>Run it by hand, and see which files it writes, and where.</source>
        <translation>Lancez-la à la main, et voyez quels fichiers elle écrit, et où.</translation>
    </message>
    <message>
        <source>In Settings, {0} does not say what a value of the outlining program is.</source>
        <translation>Dans les réglages, {0} ne dit pas ce qu’est une valeur du programme de contours.</translation>
    </message>
    <message>
        <source>Write value and name, as in 1=liver, 2=tumour-1.</source>
        <translation>Écrivez valeur et nom, comme dans 1=liver, 2=tumour-1.</translation>
    </message>
    <message>
        <source>Noted when {0}&apos;s liver was outlined:</source>
        <translation>Noté en délimitant le foie de {0} :</translation>
    </message>
    <message>
        <source>{0} is compared with itself.</source>
        <translation>{0} est comparé à lui-même.</translation>
    </message>
    <message>
        <source>Name the case of the earlier study first, then that of the later one.</source>
        <translation>Nommez d’abord le cas de l’examen antérieur, puis celui de l’examen postérieur.</translation>
    </message>
    <message>
        <source>One study was parted into segments by its vessels, the other by the liver&apos;s shape alone: a part of what differs comes of that.</source>
        <translation>Un examen a été partagé en segments d’après ses vaisseaux, l’autre d’après la seule forme du foie : une part de la différence vient de là.</translation>
    </message>
    <message>
        <source>{0} has no segments yet.</source>
        <translation>{0} n’a pas encore de segments.</translation>
    </message>
    <message>
        <source>Find them first: in Resect, or by glisson-cli territories CASE.</source>
        <translation>Trouvez-les d’abord : dans Résection ou par glisson-cli territories CASE.</translation>
    </message>
    <message>
        <source>The segments of {0} are older than the outlines or vessels that they were made from, or of another version of Glisson.</source>
        <translation>Les segments de {0} sont plus anciens que les contours ou les vaisseaux dont ils ont été tirés, ou d’une autre version de Glisson.</translation>
    </message>
    <message>
        <source>Find them anew: in Resect, or by glisson-cli territories CASE.</source>
        <translation>Trouvez-les à nouveau : dans Résection ou par glisson-cli territories CASE.</translation>
    </message>
    <message>
        <source>Nothing shows whether {0} and {1} are of one patient: the images of one or both name nobody, or came into their case before cases kept what tells.</source>
        <translation>Rien ne montre si {0} et {1} sont d’un même patient : les images de l’un ou des deux ne nomment personne, ou sont entrées dans leur cas avant que les cas ne le gardent.</translation>
    </message>
    <message>
        <source>The images of {0} and {1} name two patients; you said that they are of one.</source>
        <translation>Les images de {0} et {1} nomment deux patients ; vous avez dit qu’elles sont d’un seul.</translation>
    </message>
    <message>
        <source>The images of {0} and {1} name two patients.</source>
        <translation>Les images de {0} et {1} nomment deux patients.</translation>
    </message>
    <message>
        <source>Where they are of one all the same, say so with --same-patient.</source>
        <translation>Si elles sont malgré tout d’un seul, dites-le par --same-patient.</translation>
    </message>
    <message>
        <source>By the dates of its images {0} is {1} days older than {2}.</source>
        <translation>D’après les dates de ses images, {0} est plus ancien de {1} jours que {2}.</translation>
    </message>
    <message>
        <source>By the dates of their images the studies are {0} days apart, and not {1}.</source>
        <translation>D’après les dates de leurs images, {0} jours séparent les examens, et non {1}.</translation>
    </message>
    <message>
        <source>Leave --days out: it is for studies without dates.</source>
        <translation>Omettez --days : c’est pour les examens sans dates.</translation>
    </message>
    <message>
        <source>Both studies are of the same day: there is no growth rate.</source>
        <translation>Les deux examens sont du même jour : il n’y a pas de taux de croissance.</translation>
    </message>
    <message>
        <source>How many days lie between the studies is not known, so that there is no growth rate: their images have no dates, or name nobody. Say it (--days).</source>
        <translation>On ne sait pas combien de jours séparent les examens, si bien qu’il n’y a pas de taux de croissance : leurs images n’ont pas de dates ou ne nomment personne. Dites-le (--days).</translation>
    </message>
    <message>
        <source>Neither {0} nor {1} has a plan {2}.</source>
        <translation>Ni {0} ni {1} n’ont de plan {2}.</translation>
    </message>
    <message>
        <source>{0} alone has the plan {1}, and not all of it goes by segments or territories: a plane, a sheet, a margin or a zone has its place in its own study.</source>
        <translation>Seul {0} a le plan {1}, et tout n’y va pas par segments ou territoires : un plan de coupe, une surface, une marge ou une zone a sa place dans son propre examen.</translation>
    </message>
    <message>
        <source>Keep a plan of that name in the other case too.</source>
        <translation>Gardez un plan de ce nom dans l’autre cas aussi.</translation>
    </message>
    <message>
        <source>Less than {0} mm of the line lie over the liver.</source>
        <translation>Moins de {0} mm de la ligne passent sur le foie.</translation>
    </message>
    <message>
        <source>Draw it across the liver, from one side to the other.</source>
        <translation>Tracez-la en travers du foie, d’un côté à l’autre.</translation>
    </message>
    <message>
        <source>The line turns back on itself.</source>
        <translation>La ligne revient sur elle-même.</translation>
    </message>
    <message>
        <source>Draw it from one side of the liver to the other without turning.</source>
        <translation>Tracez-la d’un côté du foie à l’autre sans revenir en arrière.</translation>
    </message>
    <message>
        <source>{0} days between the studies: the second must be later than the first.</source>
        <translation>{0} jours entre les examens : le second doit être postérieur au premier.</translation>
    </message>
    <message>
        <source>A standard liver volume of {0} ml is not more than 0.</source>
        <translation>Un volume standard du foie de {0} ml n’est pas supérieur à 0.</translation>
    </message>
    <message>
        <source>The liver without tumours has {1} ml, {0} ml before ({2} %).</source>
        <translation>Le foie sans tumeurs a {1} ml, {0} ml avant ({2} %).</translation>
    </message>
    <message>
        <source>What the plan {0} leaves has {2} ml, {1} ml before ({3} %).</source>
        <translation>Ce que laisse le plan {0} a {2} ml, {1} ml avant ({3} %).</translation>
    </message>
    <message>
        <source>That is {1} % of the standard liver volume of {3} ml, {0} % before: a degree of hypertrophy of {2} percentage points.</source>
        <translation>C’est {1} % du volume standard du foie de {3} ml, {0} % avant : un degré d’hypertrophie de {2} points de pourcentage.</translation>
    </message>
    <message>
        <source>That is {1} % of the liver without tumours of its own study, {0} % before: a degree of hypertrophy of {2} percentage points.</source>
        <translation>C’est {1} % du foie sans tumeurs de son propre examen, {0} % avant : un degré d’hypertrophie de {2} points de pourcentage.</translation>
    </message>
    <message>
        <source>Kinetic growth rate: {0} percentage points a week, over {1} days by the images&apos; dates.</source>
        <translation>Taux de croissance cinétique : {0} points de pourcentage par semaine, sur {1} jours d’après les dates des images.</translation>
    </message>
    <message>
        <source>Kinetic growth rate: {0} percentage points a week, over the {1} days that were given.</source>
        <translation>Taux de croissance cinétique : {0} points de pourcentage par semaine, sur les {1} jours indiqués.</translation>
    </message>
    <message>
        <source>A remnant&apos;s change of up to {0} % may be none: volumes of what is parted anew are off by as much in one of ten.</source>
        <translation>Un changement du foie restant jusqu’à {0} % peut n’en être pas un : les volumes de ce qui est partagé à nouveau s’écartent d’autant dans un cas sur dix.</translation>
    </message>
    <message>
        <source>A segment&apos;s change of up to {0} % (~) may be none: volumes of segments that are parted anew are off by as much in one of ten.</source>
        <translation>Un changement d’un segment jusqu’à {0} % (~) peut n’en être pas un : les volumes de segments trouvés à nouveau s’écartent d’autant dans un cas sur dix.</translation>
    </message>
    <message>
        <source>Choose the plan {0}</source>
        <translation>Choisir le plan {0}</translation>
    </message>
    <message>
        <source>An OpenCL device solves motions by finite elements with the material &quot;linear&quot; or &quot;corotational&quot;, without tools, ligaments, capsule or gas.</source>
        <translation>Un appareil OpenCL résout des mouvements par éléments finis avec le matériau &quot;linear&quot; ou &quot;corotational&quot;, sans outils, ligaments, capsule ni gaz.</translation>
    </message>
    <message>
        <source>{0} cannot compile the kernels: {1}</source>
        <translation>{0} ne peut pas compiler les noyaux : {1}</translation>
    </message>
    <message>
        <source>The matching takes {0} MB on {1}, which has {2} MB.</source>
        <translation>L&apos;appariement prend {0} Mo sur {1}, qui a {2} Mo.</translation>
    </message>
    <message>
        <source>An OpenCL device matches by trwls in 16 bits.</source>
        <translation>Un appareil OpenCL apparie par trwls en 16 bits.</translation>
    </message>
    <message>
        <source>A probability weighs how well an explanation predicts what was measured, whatever the size of its effects, against how common it is taken to be before anything is measured. &quot;Something else&quot; stands for every cause that is not in the catalogue. Where the answer was known, in generated experiments, 98 of 100 explanations given 90 % and more were right, and 7 of 10 given 60 to 80 %.</source>
        <translation>Une probabilité met en balance la qualité avec laquelle une explication prédit ce qui a été mesuré, quelle que soit la taille de ses effets, et la fréquence qu&apos;on lui suppose avant toute mesure. « Autre chose » représente toute cause absente du catalogue. Là où la réponse était connue, dans des expériences générées, 98 explications sur 100 à 90 % et plus étaient justes, et 7 sur 10 entre 60 et 80 %.</translation>
    </message>
    <message>
        <source>It would tell what is likeliest from {0}.</source>
        <translation>Il distinguerait le plus probable de {0}.</translation>
    </message>
    <message>
        <source>Of the doubt among the known explanations {0} % is expected to be gone then.</source>
        <translation>Du doute entre les explications connues, {0} % devraient alors avoir disparu.</translation>
    </message>
    <message>
        <source>How the probabilities went while trials were added</source>
        <translation>Évolution des probabilités à mesure que des essais s&apos;ajoutaient</translation>
    </message>
    <message>
        <source>number of trials</source>
        <translation>nombre d&apos;essais</translation>
    </message>
    <message>
        <source>probability (%)</source>
        <translation>probabilité (%)</translation>
    </message>
    <message>
        <source>{0} has no frame {1}: it has {2}, counted from 0.</source>
        <translation>{0} n’a pas d’image {1} : elle en a {2}, comptées à partir de 0.</translation>
    </message>
    <message>
        <source>Cut along the plan</source>
        <translation>Couper selon le plan</translation>
    </message>
    <message>
        <source>{0} is not the sequence that was asked for: its SHA-256 is another than {1}.</source>
        <translation>{0} n’est pas la séquence demandée : son SHA-256 est autre que {1}.</translation>
    </message>
    <message>
        <source>From one measurement to the next the values scatter {0} times as much as the stated noise, which cannot be right: state it anew and ask again.</source>
        <translation>D&apos;une mesure à la suivante, les valeurs se dispersent {0} fois autant que le bruit déclaré, qui ne peut donc être juste : déclarez-le à nouveau et redemandez.</translation>
    </message>
    <message>
        <source>Nothing narrower joins this place to the rest of the structure: cut it off with the scissors, or click farther out.</source>
        <translation>Rien de plus étroit ne relie cet endroit au reste de la structure : coupez-le aux ciseaux, ou cliquez plus à l&apos;extérieur.</translation>
    </message>
    <message>
        <source>Take a part off {0}</source>
        <translation>Partie retirée de {0}</translation>
    </message>
    <message>
        <source>The battery stopped discharging while it was measured.</source>
        <translation>La batterie a cessé de se décharger pendant la mesure.</translation>
    </message>
    <message>
        <source>Keep the machine unplugged until the measurement ends.</source>
        <translation>Laissez la machine débranchée jusqu&apos;à la fin de la mesure.</translation>
    </message>
    <message>
        <source>The counter of {0} did not move in {1} s.</source>
        <translation>Le compteur de {0} n&apos;a pas bougé en {1} s.</translation>
    </message>
    <message>
        <source>Measure for longer.</source>
        <translation>Mesurez plus longtemps.</translation>
    </message>
    <message>
        <source>{0} gave one reading in {1} s: how sure it is cannot be told. Each metered problem runs {2} s.</source>
        <translation>{0} a donné une seule valeur en {1} s : on ne peut dire à quel point elle est sûre. Chaque problème mesuré tourne {2} s.</translation>
    </message>
    <message>
        <source>{0} is renewed every {1} s: each metered problem runs {2} s. What follows &quot;give or take&quot; is what that resolves; how true the readings are was not checked.</source>
        <translation>{0} se renouvelle toutes les {1} s : chaque problème mesuré tourne {2} s. Ce qui suit « give or take » est la résolution qui en résulte ; la justesse des valeurs n&apos;a pas été vérifiée.</translation>
    </message>
    <message>
        <source>The processor&apos;s energy counters (RAPL) at {0} may be read by root only, as they betray secrets (CVE-2020-8694): run this once as root, or let yourself read energy_uj.</source>
        <translation>Les compteurs d&apos;énergie du processeur (RAPL) sous {0} ne peuvent être lus que par root, car ils trahissent des secrets (CVE-2020-8694) : lancez ceci une fois en tant que root, ou donnez-vous le droit de lire energy_uj.</translation>
    </message>
    <message>
        <source>The processor&apos;s energy counters (RAPL) at {0} hold no number or no range.</source>
        <translation>Les compteurs d&apos;énergie du processeur (RAPL) sous {0} ne contiennent pas de nombre ou pas d&apos;étendue.</translation>
    </message>
    <message>
        <source>The battery gauge at {0} tells neither power nor what is left.</source>
        <translation>La jauge de la batterie sous {0} n&apos;indique ni la puissance ni ce qui reste.</translation>
    </message>
    <message>
        <source>A trace needs a channel, factors other than 0, and a range that is positive.</source>
        <translation>Un enregistrement demande un canal, des facteurs différents de 0 et une étendue positive.</translation>
    </message>
    <message>
        <source>{0} begins as a power analyser&apos;s log, but its first line holds no time and no reading.</source>
        <translation>{0} commence comme le journal d&apos;un analyseur de puissance, mais sa première ligne ne contient ni heure ni valeur.</translation>
    </message>
    <message>
        <source>There is no meter {0} here.{1}</source>
        <translation>Il n&apos;y a pas d&apos;appareil de mesure {0} ici.{1}</translation>
    </message>
    <message>
        <source>{0} lies in no case, so that there is no scan to draw over.</source>
        <translation>{0} ne se trouve dans aucun cas, il n&apos;y a donc pas d&apos;image sur laquelle dessiner.</translation>
    </message>
    <message>
        <source>Give a result in the folder results of a case.</source>
        <translation>Indiquez un résultat du dossier results d&apos;un cas.</translation>
    </message>
    <message>
        <source>The result has no landmarks &quot;{0}&quot;; it has: {1}.</source>
        <translation>Le résultat n&apos;a pas de repères « {0} » ; il a : {1}.</translation>
    </message>
    <message>
        <source>A result has no scene named {0}; it has displacement, landmarks.</source>
        <translation>Un résultat n&apos;a pas de scène nommée {0} ; il a displacement, landmarks.</translation>
    </message>
    <message>
        <source>{0} must be &quot;glisson-orders/1&quot;.</source>
        <translation>{0} doit être « glisson-orders/1 ».</translation>
    </message>
    <message>
        <source>There are no steps to keep as {0}.</source>
        <translation>Il n’y a pas d’étapes à garder sous le nom {0}.</translation>
    </message>
    <message>
        <source>Move a rigid tool or advance a cut first.</source>
        <translation>Déplacez d’abord un instrument rigide ou avancez une coupe.</translation>
    </message>
    <message>
        <source>The case has no order of steps {0}.</source>
        <translation>Le cas n’a pas d’ordre d’étapes {0}.</translation>
    </message>
    <message>
        <source>There is no order of steps to compare.</source>
        <translation>Il n’y a aucun ordre d’étapes à comparer.</translation>
    </message>
    <message>
        <source>Keep the steps of a rehearsal first.</source>
        <translation>Gardez d’abord les étapes d’une répétition.</translation>
    </message>
    <message>
        <source>{0} (step {1})</source>
        <translation>{0} (étape {1})</translation>
    </message>
    <message>
        <source>What each order asks of the liver at its worst</source>
        <translation>Ce que chaque ordre demande au foie à son pire moment</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>étapes</translation>
    </message>
    <message>
        <source>{0}, largest displacement (mm)</source>
        <translation>{0}, plus grand déplacement (mm)</translation>
    </message>
    <message>
        <source>{0}, at the end (mm)</source>
        <translation>{0}, à la fin (mm)</translation>
    </message>
    <message>
        <source>largest force of one tool (N)</source>
        <translation>plus grande force d’un instrument (N)</translation>
    </message>
    <message>
        <source>largest strain (%)</source>
        <translation>plus grande déformation (%)</translation>
    </message>
    <message>
        <source>strain of vessel walls, 95 of 100 below (%)</source>
        <translation>déformation des parois des vaisseaux, 95 sur 100 en dessous (%)</translation>
    </message>
    <message>
        <source>cut open at the end (cm2)</source>
        <translation>coupe ouverte à la fin (cm2)</translation>
    </message>
    <message>
        <source>steps that could not be carried out</source>
        <translation>étapes qui n’ont pu être exécutées</translation>
    </message>
    <message>
        <source>steps not to be used</source>
        <translation>étapes à ne pas utiliser</translation>
    </message>
    <message>
        <source>Orders of steps</source>
        <translation>Ordres des étapes</translation>
    </message>
    <message>
        <source>Computed with large deformations, at rest after each step.</source>
        <translation>Calculé aux grandes déformations, au repos après chaque étape.</translation>
    </message>
    <message>
        <source>Orders of steps compared</source>
        <translation>Ordres des étapes comparés</translation>
    </message>
    <message>
        <source>Order of steps: {0}</source>
        <translation>Ordre des étapes : {0}</translation>
    </message>
    <message>
        <source>rehearsed</source>
        <translation>répété</translation>
    </message>
    <message>
        <source>Keep the steps {0}</source>
        <translation>Garder les étapes {0}</translation>
    </message>
    <message>
        <source>Drop the steps {0}</source>
        <translation>Écarter les étapes {0}</translation>
    </message>
    <message>
        <source>Compare orders of steps</source>
        <translation>Comparer les ordres des étapes</translation>
    </message>
    <message>
        <source>The calibration is of pictures of {0} x {1} pixels; these have {2} x {3}.</source>
        <translation>Le calibrage vaut pour des images de {0} x {1} pixels ; celles-ci en ont {2} x {3}.</translation>
    </message>
    <message>
        <source>A picture of {0} x {1} pixels cannot be halved into two of one size.</source>
        <translation>Une image de {0} x {1} pixels ne se partage pas en deux de même taille.</translation>
    </message>
    <message>
        <source>Give a video whose pictures show both eyes, or one video for each eye.</source>
        <translation>Donnez une vidéo dont les images montrent les deux yeux, ou une vidéo par œil.</translation>
    </message>
    <message>
        <source>The two videos differ in length: frames of the left one {0}, of the right one {1}.</source>
        <translation>Les deux vidéos n&apos;ont pas la même longueur : images de la gauche {0}, de la droite {1}.</translation>
    </message>
    <message>
        <source>Give two videos of the same moments, or take fewer frames than both have.</source>
        <translation>Donnez deux vidéos des mêmes instants, ou prenez moins d&apos;images que n&apos;en ont les deux.</translation>
    </message>
    <message>
        <source>SIMULATED: a generated liver, breathing and pressed by a tool as a formula says.</source>
        <translation>SIMULÉ&#xa0;: un foie engendré, qui respire et qu’un instrument enfonce selon une formule.</translation>
    </message>
    <message>
        <source>The kinds are palpation, material, platform, guidance, full-field and elastography.</source>
        <translation>Les genres sont palpation, material, platform, guidance, full-field et elastography.</translation>
    </message>
    <message>
        <source>The trials hold more than {0} values together.</source>
        <translation>Les essais contiennent ensemble plus de {0} valeurs.</translation>
    </message>
    <message>
        <source>Cut the images to the region, or leave trials out.</source>
        <translation>Rognez les images à la région, ou omettez des essais.</translation>
    </message>
    <message>
        <source>The declared density is {0} kg/m3, which no tissue has.</source>
        <translation>La densité déclarée est de {0} kg/m3, ce qu’aucun tissu n’a.</translation>
    </message>
    <message>
        <source>Was it given in g/cm3?</source>
        <translation>A-t-elle été donnée en g/cm3 ?</translation>
    </message>
    <message>
        <source>{0} names none of x, y and z.</source>
        <translation>{0} ne nomme aucun de x, y et z.</translation>
    </message>
    <message>
        <source>{0} must have x, y and z: without one of them a free pressure cannot be taken off.</source>
        <translation>{0} doit avoir x, y et z : sans l’un d’eux, une pression libre ne peut être ôtée.</translation>
    </message>
    <message>
        <source>{0} must be those of the first trial.</source>
        <translation>{0} doivent être ceux du premier essai.</translation>
    </message>
    <message>
        <source>{0} has more than {1} voxels.</source>
        <translation>{0} a plus de {1} voxels.</translation>
    </message>
    <message>
        <source>Cut it to the region.</source>
        <translation>Rognez-la à la région.</translation>
    </message>
    <message>
        <source>The axes of {0} are not at right angles.</source>
        <translation>Les axes de {0} ne sont pas à angle droit.</translation>
    </message>
    <message>
        <source>{0} lies on another grid than the first image.</source>
        <translation>{0} se trouve sur une autre grille que la première image.</translation>
    </message>
    <message>
        <source>All images of an experiment have the same voxels.</source>
        <translation>Toutes les images d’une expérience ont les mêmes voxels.</translation>
    </message>
    <message>
        <source>The region holds no voxel in which all images have numbers.</source>
        <translation>La région ne contient aucun voxel où toutes les images ont des nombres.</translation>
    </message>
    <message>
        <source>Was the mask drawn on these images?</source>
        <translation>Le masque a-t-il été dessiné sur ces images ?</translation>
    </message>
    <message>
        <source>Shear waves run slower or faster than declared, everywhere and at every frequency.</source>
        <translation>Les ondes de cisaillement vont moins vite ou plus vite que déclaré, partout et à toute fréquence.</translation>
    </message>
    <message>
        <source>Waves lose energy on their way, as in a viscous tissue.</source>
        <translation>Les ondes perdent de l’énergie en chemin, comme dans un tissu visqueux.</translation>
    </message>
    <message>
        <source>Shear waves along one direction, as of fibres, run at another speed than across it.</source>
        <translation>Les ondes de cisaillement vont le long d’une direction, comme celle de fibres, à une autre vitesse qu’en travers.</translation>
    </message>
    <message>
        <source>Besides shear waves there are long ones that compress; the declared equation knows none.</source>
        <translation>Outre les ondes de cisaillement, il y en a de longues qui compriment ; l’équation déclarée n’en connaît pas.</translation>
    </message>
    <message>
        <source>Slices were not measured at one moment of the vibration, but one after the other.</source>
        <translation>Les coupes n’ont pas été mesurées à un même moment de la vibration, mais l’une après l’autre.</translation>
    </message>
    <message>
        <source>A region inside is stiffer or softer than declared.</source>
        <translation>Une région à l’intérieur est plus raide ou plus molle que déclaré.</translation>
    </message>
    <message>
        <source>Along the border another stiffness holds than inside.</source>
        <translation>Le long du bord vaut une autre rigidité qu’à l’intérieur.</translation>
    </message>
    <message>
        <source>The images hold {0} x {1} x {2} voxels, too few for a patch.</source>
        <translation>Les images contiennent {0} x {1} x {2} voxels, trop peu pour une parcelle.</translation>
    </message>
    <message>
        <source>Seven along each axis are needed, or a single slice.</source>
        <translation>Il en faut sept le long de chaque axe, ou une seule coupe.</translation>
    </message>
    <message>
        <source>No patch of trial {0} lies within the region: it would take {1} mm to each side.</source>
        <translation>Aucune parcelle de l’essai {0} ne tient dans la région : il lui faudrait {1} mm de chaque côté.</translation>
    </message>
    <message>
        <source>Is the region thin, or the declared modulus in Pa? &quot;patch_radius_mm&quot; sets it.</source>
        <translation>La région est-elle mince, ou le module déclaré en Pa ? « patch_radius_mm » le fixe.</translation>
    </message>
    <message>
        <source>Of trial {0} {1} patches were taken, evenly from all.</source>
        <translation>De l’essai {0}, {1} parcelles ont été prises, réparties également.</translation>
    </message>
    <message>
        <source>frequency (Hz)</source>
        <translation>fréquence (Hz)</translation>
    </message>
    <message>
        <source>The same with the better model</source>
        <translation>La même chose avec le meilleur modèle</translation>
    </message>
    <message>
        <source>What was seen does not lie where the frame before left the organ, and no other place was found: the organ is lost here.</source>
        <translation>Ce qui a été vu ne se trouve pas là où l&apos;image précédente a laissé l&apos;organe, et aucun autre endroit n&apos;a été trouvé : l&apos;organe est perdu ici.</translation>
    </message>
    <message>
        <source>{0} holds no marked lines.</source>
        <translation>{0} ne contient pas de lignes marquées.</translation>
    </message>
    <message>
        <source>It begins with &quot;format&quot;: &quot;glisson-marked-lines/1&quot;; a line has an id, places at rest and places seen, three numbers each.</source>
        <translation>Il commence par &quot;format&quot;: &quot;glisson-marked-lines/1&quot; ; une ligne a un id, des points au repos et des points vus, de trois nombres chacun.</translation>
    </message>
    <message>
        <source>Mark a line</source>
        <translation>Marquer une ligne</translation>
    </message>
    <message>
        <source>The format &quot;glisson-contours/1&quot; is described in the documentation.</source>
        <translation>Le format « glisson-contours/1 » est décrit dans la documentation.</translation>
    </message>
    <message>
        <source>One picture tells a pose by two lines of the organ and more; {0} are given.</source>
        <translation>Une image indique la position à partir de deux lignes de l&apos;organe ; {0} sont données.</translation>
    </message>
    <message>
        <source>Mark ridges and the falciform ligament, or give a pose_guess.</source>
        <translation>Marquez les bords et le ligament falciforme, ou donnez pose_guess.</translation>
    </message>
    <message>
        <source>Under no pose do the lines of the organ lie on those of the picture.</source>
        <translation>Dans aucune position les lignes de l&apos;organe ne sont sur celles de l&apos;image.</translation>
    </message>
    <message>
        <source>Check that lines have the same names on both sides, that lengths are in mm, and that the picture is of this camera and patient.</source>
        <translation>Vérifiez que les lignes portent les mêmes noms des deux côtés, que les longueurs sont en mm et que l&apos;image est de cette caméra et de ce patient.</translation>
    </message>
    <message>
        <source>The lines of the picture fit the organ in more than one place.</source>
        <translation>Les lignes de l&apos;image conviennent à l&apos;organe à plus d&apos;un endroit.</translation>
    </message>
    <message>
        <source>Mark another line, or give a pose_guess.</source>
        <translation>Marquez une autre ligne, ou donnez pose_guess.</translation>
    </message>
    <message>
        <source>predicts nothing</source>
        <translation>ne prédit rien</translation>
    </message>
    <message>
        <source>Fitted without one of the trials, {0} has no solution there, or is farther off than a prediction of zero: it predicts nothing beyond what it was fitted to.</source>
        <translation>Ajusté sans l&apos;un des essais, {0} n&apos;y a pas de solution, ou s&apos;en écarte plus qu&apos;une prédiction nulle : il ne prédit rien au-delà de ce à quoi il a été ajusté.</translation>
    </message>
    <message>
        <source>one of the quantities that were measured is off by more than its noise</source>
        <translation>une des grandeurs mesurées s&apos;écarte de plus que son bruit</translation>
    </message>
    <message>
        <source>Somewhere inside lies a stiff lump, as a tumour would: around it the organ gives way less.</source>
        <translation>Quelque part à l’intérieur se trouve un nodule dur, comme une tumeur : autour de lui l’organe cède moins.</translation>
    </message>
    <message>
        <source>What held the specimen has no place on the organ&apos;s surface: the specimen is not this organ in this place.</source>
        <translation>Ce qui tenait l’échantillon n’a pas de place sur la surface de l’organe : l’échantillon n’est pas cet organe à cet endroit.</translation>
    </message>
    <message>
        <source>Around ({0}, {1}, {2}) the surface is held within {3} mm by springs of {4} kPa/mm.</source>
        <translation>Autour de ({0}, {1}, {2}) la surface est tenue sur {3} mm par des ressorts de {4} kPa/mm.</translation>
    </message>
    <message>
        <source>What is declared to hold the organ at {0} holds it with {1} kPa/mm alone.</source>
        <translation>Ce qui est déclaré tenir l’organe à {0} ne le tient qu’avec {1} kPa/mm.</translation>
    </message>
    <message>
        <source>The organ has no support {0} that could hold less.</source>
        <translation>L’organe n’a pas de support {0} qui pourrait tenir moins.</translation>
    </message>
    <message>
        <source>Something that nobody declared holds a part of the surface, as an adhesion or a ligament does: there it moves less.</source>
        <translation>Quelque chose que personne n’a déclaré tient une partie de la surface, comme une adhérence ou un ligament : elle y bouge moins.</translation>
    </message>
    <message>
        <source>One of the declared attachments holds less than declared, or is not there at all.</source>
        <translation>L’une des attaches déclarées tient moins que déclaré, ou n’est pas là du tout.</translation>
    </message>
    <message>
        <source>Error by frequency: broken before, whole after</source>
        <translation>Erreur selon la fréquence : en tirets avant, en trait plein après</translation>
    </message>
    <message>
        <source>Where the declared law does not hold: what it leaves in each patch, in noises (1 is noise alone; red at {0}); the worst layer</source>
        <translation>Où la loi déclarée ne vaut pas : ce qu&apos;elle laisse dans chaque zone, en bruits (1 : le bruit seul ; rouge à {0}) ; la pire couche</translation>
    </message>
    <message>
        <source>A lens&apos;s distortion has 4, 5, 8, 12 or 14 coefficients; here there are {0}.</source>
        <translation>La distorsion d’un objectif a 4, 5, 8, 12 ou 14 coefficients ; ici il y en a {0}.</translation>
    </message>
    <message>
        <source>A tool would lie {0} mm deep in the body.</source>
        <translation>Un outil se trouverait à {0} mm de profondeur dans le corps.</translation>
    </message>
    <message>
        <source>Move it there in smaller steps, or away from the body.</source>
        <translation>Amenez-le là par de plus petits pas, ou éloignez-le du corps.</translation>
    </message>
    <message>
        <source>Press where trial {0} presses, with {1} N along ({2}, {3}, {4}).</source>
        <translation>Appuyer là où appuie l’essai {0}, avec {1} N selon ({2}, {3}, {4}).</translation>
    </message>
    <message>
        <source>Press at ({0}, {1}, {2}) mm with {3} N and hold the force for {4} s.</source>
        <translation>Appuyer en ({0}, {1}, {2}) mm avec {3} N et maintenir la force pendant {4} s.</translation>
    </message>
    <message>
        <source>No vessel lies within {0} mm of {1}, where one was told: put the place on the vessel.</source>
        <translation>Aucun vaisseau ne se trouve à moins de {0} mm de {1}, là où un vaisseau a été indiqué : placez l’endroit sur le vaisseau.</translation>
    </message>
    <message>
        <source>--click wants VESSEL=X,Y,Z with one of {0}, not &quot;{1}&quot;.</source>
        <translation>--click veut VAISSEAU=X,Y,Z avec l’un de {0}, pas « {1} ».</translation>
    </message>
    <message>
        <source>The residual is larger than the stated noise, but has no shape that speaks of an effect: the noise may be stated too small, or some rows are outliers.</source>
        <translation>Le résidu dépasse le bruit déclaré, mais n&apos;a pas de forme qui indique un effet : le bruit est peut-être déclaré trop petit, ou quelques valeurs sont aberrantes.</translation>
    </message>
    <message>
        <source>Nothing is probable enough to be named. Probability of {0}: {1}; next comes: {2}, {3}.</source>
        <translation>Rien n&apos;est assez probable pour être nommé. Probabilité de {0} : {1} ; ensuite vient : {2}, {3}.</translation>
    </message>
    <message>
        <source>Nothing is missing: what the declared model leaves shows no effect, and nothing was added to it.</source>
        <translation>Rien ne manque : ce que laisse le modèle déclaré ne montre aucun effet, et rien n&apos;y a été ajouté.</translation>
    </message>
    <message>
        <source>Explained: the effects below are probable enough to be named.</source>
        <translation>Expliqué : les effets ci-dessous sont assez probables pour être nommés.</translation>
    </message>
    <message>
        <source>Unexplained: something acts that the declared model lacks, and no combination of known effects is probable enough to be named. What is named below removes a part of the error and is not a cause that these data establish.</source>
        <translation>Inexpliqué : quelque chose agit qui manque au modèle déclaré, et aucune combinaison d&apos;effets connus n&apos;est assez probable pour être nommée. Ce qui figure ci-dessous enlève une partie de l&apos;erreur et n&apos;est pas une cause que ces données établissent.</translation>
    </message>
    <message>
        <source>Probability of {0}, or of what these data cannot tell from it: {1}.</source>
        <translation>Probabilité de {0}, ou de ce que ces données n&apos;en distinguent pas : {1}.</translation>
    </message>
    <message>
        <source>Unite them in one structure, vessels: its systems are told apart.</source>
        <translation>Réunissez-les en une structure, vessels : ses systèmes sont distingués.</translation>
    </message>
    <message>
        <source>{0} places on borders are told: tell {1} at most.</source>
        <translation>{0} endroits sur des limites sont indiqués : indiquez-en {1} au plus.</translation>
    </message>
    <message>
        <source>{0} does not lie in the liver, where the border of {1} was told: put the place inside.</source>
        <translation>{0} n’est pas dans le foie, où la limite de {1} est indiquée : placez l’endroit dedans.</translation>
    </message>
    <message>
        <source>{0} lies {1} mm from the usual course of the border of {2}: tell the border that is meant, or put the place on it.</source>
        <translation>{0} est à {1} mm du trajet habituel de la limite de {2} : indiquez la limite voulue, ou placez l’endroit sur elle.</translation>
    </message>
    <message>
        <source>The border of {0} cannot pass {1} as well as the other borders where they were told: take one of the places back.</source>
        <translation>La limite de {0} ne peut passer par {1} et les autres limites par leurs endroits : retirez un des endroits.</translation>
    </message>
    <message>
        <source>--border wants BORDER=X,Y,Z with one of {0}, not &quot;{1}&quot;.</source>
        <translation>--border demande BORDER=X,Y,Z avec l’un de {0}, non « {1} ».</translation>
    </message>
    <message>
        <source>The tool {0} slides past the body, which gives way under {1} N.</source>
        <translation>L’outil {0} glisse et passe à côté du corps, qui cède sous {1}&#xa0;N.</translation>
    </message>
    <message>
        <source>Push with less, or where the body holds against it.</source>
        <translation>Poussez moins fort, ou là où le corps résiste.</translation>
    </message>
    <message>
        <source>The vessel trees were made before there was {0}: find the vessels again.</source>
        <translation>Les arbres des vaisseaux ont été faits avant qu’il y ait {0} : retrouvez les vaisseaux.</translation>
    </message>
    <message>
        <source>What {1} was made from has changed since, and {0} was made from that: make {1} anew, then {0}.</source>
        <translation>Ce dont {1} a été fait a changé depuis, et {0} en a été fait : refaites {1}, puis {0}.</translation>
    </message>
    <message>
        <source>{1} and {2} hold the same vessels: {0} % of the smaller one.</source>
        <translation>{1} et {2} contiennent les mêmes vaisseaux : {0} % du plus petit.</translation>
    </message>
    <message>
        <source>Take the one out of the other: glisson-cli segment --subtract.</source>
        <translation>Retirez l’un de l’autre : glisson-cli segment --subtract.</translation>
    </message>
    <message>
        <source>{0} holds a piece as wide as it is long, which is no vessel.</source>
        <translation>{0} contient un morceau aussi large que long, qui n’est pas un vaisseau.</translation>
    </message>
    <message>
        <source>Outline vessels and ducts alone, the gall bladder by itself.</source>
        <translation>Délimitez les vaisseaux et les conduits seuls, la vésicule biliaire à part.</translation>
    </message>
    <message>
        <source>{0} has no tissue of its own: arteries and bile ducts run with portal branches.</source>
        <translation>{0} n’a pas de tissu à soi : les artères et les voies biliaires suivent les branches portes.</translation>
    </message>
    <message>
        <source>Take the portal branch beside it.</source>
        <translation>Prenez la branche porte d’à côté.</translation>
    </message>
    <message>
        <source>{0}: branches that are cut, with the tissue beyond the cut; of arteries and bile ducts their own length.</source>
        <translation>{0} : branches coupées, avec le tissu au-delà de la section ; pour les artères et les voies biliaires, leur propre longueur.</translation>
    </message>
    <message>
        <source>Beyond it</source>
        <translation>Au-delà</translation>
    </message>
    <message>
        <source>Of that left</source>
        <translation>Dont reste</translation>
    </message>
    <message>
        <source>Finding vessels</source>
        <translation>Recherche des vaisseaux</translation>
    </message>
    <message>
        <source>The outline to find vessels in holds nothing.</source>
        <translation>Le contour où chercher des vaisseaux ne contient rien.</translation>
    </message>
    <message>
        <source>Nothing in the outline stands out as a tube.</source>
        <translation>Rien dans le contour ne se détache comme un tube.</translation>
    </message>
    <message>
        <source>Vessels need contrast: take another phase or sequence, grow them from seeds, or import their outline.</source>
        <translation>Les vaisseaux ont besoin de contraste : prenez une autre phase ou séquence, faites-les croître à partir de points ou importez leur contour.</translation>
    </message>
    <message>
        <source>Vessels are brighter than the tissue around by {0}: {1} ml, {2} % of the outline.</source>
        <translation>Les vaisseaux sont plus clairs de {0} que le tissu autour : {1} ml, {2} % du contour.</translation>
    </message>
    <message>
        <source>Vessels are darker than the tissue around by {0}: {1} ml, {2} % of the outline.</source>
        <translation>Les vaisseaux sont plus sombres de {0} que le tissu autour : {1} ml, {2} % du contour.</translation>
    </message>
    <message>
        <source>The seed at ({0}) mm lies more than {1} mm from every vessel found.</source>
        <translation>Le point à ({0}) mm est à plus de {1} mm de tout vaisseau trouvé.</translation>
    </message>
    <message>
        <source>Move the seed onto a vessel, or leave seeds out: then all vessels are kept.</source>
        <translation>Placez le point sur un vaisseau, ou n’en donnez pas : alors tous les vaisseaux restent.</translation>
    </message>
    <message>
        <source>With tools in the hand the meshfree engine knows a linear, isotropic liver without ligaments.</source>
        <translation>Avec des instruments en main, la méthode sans maillage connaît un foie linéaire et isotrope sans ligaments.</translation>
    </message>
    <message>
        <source>Take finite elements for others.</source>
        <translation>Prenez les éléments finis pour les autres.</translation>
    </message>
    <message>
        <source>{0} meshfree nodes are too many to be taken in hand: their matrix is not factorised within seconds.</source>
        <translation>{0} nœuds sans maillage sont trop nombreux pour être pris en main : leur matrice ne se factorise pas en quelques secondes.</translation>
    </message>
    <message>
        <source>Take fewer nodes, or let `simulate` solve for them.</source>
        <translation>Prenez moins de nœuds, ou laissez `simulate` les résoudre.</translation>
    </message>
    <message>
        <source>The liver was found without a point: look at it before you trust it, and give a point inside it where it is wrong.</source>
        <translation>Le foie a été trouvé sans point : regardez-le avant de vous y fier et, là où il est faux, indiquez un point à l&apos;intérieur.</translation>
    </message>
    <message>
        <source>The image shows {0} % of the liver&apos;s border; elsewhere the shape leads.</source>
        <translation>L&apos;image montre {0} % du bord du foie ; ailleurs, c&apos;est la forme qui guide.</translation>
    </message>
    <message>
        <source>There is no image value where the liver is looked for.</source>
        <translation>Là où le foie est cherché, l&apos;image n&apos;a aucune valeur.</translation>
    </message>
    <message>
        <source>Fitting the shape to the image</source>
        <translation>Ajustement de la forme à l&apos;image</translation>
    </message>
    <message>
        <source>The image hardly shows a border where the model expects the liver&apos;s.</source>
        <translation>Là où le modèle attend le bord du foie, l&apos;image n&apos;en montre presque pas.</translation>
    </message>
    <message>
        <source>Give a seed inside the liver; look whether the image shows one, and lies in the patient&apos;s frame (LPS).</source>
        <translation>Indiquez un point dans le foie ; vérifiez que l&apos;image en montre un et qu&apos;elle est dans le repère du patient (LPS).</translation>
    </message>
    <message>
        <source>Looking for the liver</source>
        <translation>Recherche du foie</translation>
    </message>
    <message>
        <source>No place in the image looks like a liver of the model&apos;s shape.</source>
        <translation>Aucun endroit de l&apos;image ne ressemble à un foie de la forme du modèle.</translation>
    </message>
    <message>
        <source>The liver is what grew by brightness alone: no shape made its border surer.</source>
        <translation>Le foie est ce qui a grandi par la seule luminosité : aucune forme n’a rendu son bord plus sûr.</translation>
    </message>
    <message>
        <source>Point {0} on what is not liver, at ({1}) mm, lies {2} mm outside the image.</source>
        <translation>Le point {0} sur ce qui n’est pas le foie, en ({1}) mm, est à {2} mm hors de l’image.</translation>
    </message>
    <message>
        <source>Points are DICOM patient coordinates (LPS) in mm, not voxel indices.</source>
        <translation>Les points sont des coordonnées du patient DICOM (LPS) en mm, non des indices de voxels.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Il n’y a rien à annuler.</translation>
    </message>
    <message>
        <source>The scenario says itself how soon the organ stiffens: the effect {0} is left out.</source>
        <translation>Le scénario dit lui-même à quel point l’organe se raidit : l’effet {0} est laissé de côté.</translation>
    </message>
    <message>
        <source>Only the material veronda-westmann stiffens with strain: the effect {0} is left out.</source>
        <translation>Seul le matériau veronda-westmann se raidit avec la déformation : l’effet {0} est laissé de côté.</translation>
    </message>
    <message>
        <source>That the specimen stiffens with strain is not carried to the organ.</source>
        <translation>Que l’éprouvette se raidisse avec la déformation n’est pas reporté sur l’organe.</translation>
    </message>
    <message>
        <source>With large deformations the organ stiffens as it is strained (Veronda and Westmann&apos;s law, strain_stiffening {0}); with small ones it does not.</source>
        <translation>Avec de grandes déformations, l’organe se raidit (loi de Veronda et Westmann, strain_stiffening {0}) ; avec de petites, non.</translation>
    </message>
    <message>
        <source>Only bent by {0} mm (rms) does the organ lie where it was seen: it is another organ, the cloud is mirrored, or the guess is far off.</source>
        <translation>Ce n’est que déformé de {0} mm (moyenne quadratique) que l’organe se trouve là où il a été vu : c’est un autre organe, le nuage est en miroir, ou l’estimation est loin de la vérité.</translation>
    </message>
    <message>
        <source>The feature {0} lies {1} mm from the organ at rest: it is of another organ, or in another frame than the mesh.</source>
        <translation>Le repère {0} se trouve à {1} mm de l’organe au repos : il est d’un autre organe, ou dans un autre système de coordonnées que le maillage.</translation>
    </message>
    <message>
        <source>The feature {0} lies {1} mm from where all else that is seen has it: the features contradict each other or the cloud. Is each named rightly?</source>
        <translation>Le repère {0} se trouve à {1} mm de là où le place tout le reste de ce qui est vu : les repères se contredisent ou contredisent le nuage. Chacun est-il bien nommé ?</translation>
    </message>
    <message>
        <source>Go on along the earlier cut, or keep farther away from it.</source>
        <translation>Poursuivez la coupe précédente, ou restez plus loin d’elle.</translation>
    </message>
    <message>
        <source>No equilibrium of the pressed gel was found at {0} mm.</source>
        <translation>Aucun équilibre du gel pressé n’a été trouvé à {0} mm.</translation>
    </message>
    <message>
        <source>The gel does not bear {0} N at {1} mm of depth.</source>
        <translation>Le gel ne supporte pas {0} N à {1} mm de profondeur.</translation>
    </message>
    <message>
        <source>There is no trial {0}; the first one is {1}.</source>
        <translation>Il n’y a pas d’essai {0} ; le premier est {1}.</translation>
    </message>
    <message>
        <source>A scene for SOFA cannot hold what the scenario says with {0}.</source>
        <translation>Une scène pour SOFA ne peut pas contenir ce que le scénario dit par {0}.</translation>
    </message>
    <message>
        <source>It holds linear and corotational bodies by finite elements, fixed points, foundations and loads.</source>
        <translation>Elle contient des corps linéaires et corotationnels par éléments finis, des points fixes, des fondations et des charges.</translation>
    </message>
    <message>
        <source>Without a scenario, the scene hoists segment VI with {0} N.</source>
        <translation>Sans scénario, la scène soulève le segment VI avec {0} N.</translation>
    </message>
    <message>
        <source>A scene for SOFA cannot hold the effect {0}: it is left out.</source>
        <translation>Une scène pour SOFA ne peut pas contenir l&apos;effet {0} : il est omis.</translation>
    </message>
    <message>
        <source>SOFA&apos;s linear tetrahedra are stiffer than the quadratic ones here: the largest displacement should be {0} mm in the scene, and is {1} mm in Glisson.</source>
        <translation>Les tétraèdres linéaires de SOFA sont plus raides que les quadratiques ici : le plus grand déplacement devrait être de {0} mm dans la scène et est de {1} mm dans Glisson.</translation>
    </message>
    <message>
        <source>The liver&apos;s points are not those of the liver whose vessels are carried along.</source>
        <translation>Les points du foie ne sont pas ceux du foie dont les vaisseaux sont emportés.</translation>
    </message>
    <message>
        <source>Give the spacing of the reference that the model was made with, or draw without vessels.</source>
        <translation>Indiquez l&apos;espacement de la référence avec lequel le modèle a été fait, ou tirez sans vaisseaux.</translation>
    </message>
    <message>
        <source>The liver is bent so far that vessels carried along would be turned inside out.</source>
        <translation>Le foie est si déformé que les vaisseaux emportés seraient retournés.</translation>
    </message>
    <message>
        <source>--scenario serves a scene for SOFA alone (--format sofa).</source>
        <translation>--scenario ne sert qu&apos;à une scène pour SOFA (--format sofa).</translation>
    </message>
    <message>
        <source>The scenario says itself how the organ relaxes: the effect {0} is left out.</source>
        <translation>Le scénario dit lui-même comment l’organe se relâche&#xa0;: l’effet {0} est laissé de côté.</translation>
    </message>
    <message>
        <source>Held for long, the organ creeps: it is {0} times as stiff as at once. In motion it relaxes on the way there, with times of {1} s.</source>
        <translation>Tenu longtemps, l’organe flue&#xa0;: il est alors {0} fois aussi rigide qu’au premier instant. En mouvement, il se relâche jusque-là avec des temps de {1} s.</translation>
    </message>
    <message>
        <source>A relaxation has at most {0} terms, and {1} are given.</source>
        <translation>Une relaxation a au plus {0} termes, et {1} sont donnés.</translation>
    </message>
    <message>
        <source>Term {0} of a relaxation needs a weight between 0 and 1 and a time above zero.</source>
        <translation>Le terme {0} d’une relaxation demande un poids entre 0 et 1 et un temps supérieur à zéro.</translation>
    </message>
    <message>
        <source>The weights of a relaxation sum to {0}: they must leave something of the stiffness, and sum to less than 1.</source>
        <translation>Les poids d’une relaxation font {0} au total&#xa0;: ils doivent laisser quelque chose de la rigidité, et faire moins de 1.</translation>
    </message>
    <message>
        <source>Straight from data nothing relaxes: the measured stresses are what is left.</source>
        <translation>À partir des seules données, rien ne se relâche&#xa0;: les contraintes mesurées sont ce qui reste.</translation>
    </message>
    <message>
        <source>Leave out &quot;relaxation&quot;.</source>
        <translation>Omettre &quot;relaxation&quot;.</translation>
    </message>
    <message>
        <source>A line that cuts needs 2 to {0} places; there are {1}.</source>
        <translation>Une ligne de coupe demande de 2 à {0} points ; il y en a {1}.</translation>
    </message>
    <message>
        <source>A line that cuts needs a way into the body with a length.</source>
        <translation>Une ligne de coupe demande une direction vers l’intérieur du corps, de longueur non nulle.</translation>
    </message>
    <message>
        <source>A place of the line that cuts is not finite.</source>
        <translation>Un point de la ligne de coupe n’est pas fini.</translation>
    </message>
    <message>
        <source>Places {0} and {1} of the line that cuts lie above each other, along its way into the body.</source>
        <translation>Les points {0} et {1} de la ligne de coupe sont l’un au-dessus de l’autre, dans sa direction vers l’intérieur du corps.</translation>
    </message>
    <message>
        <source>The line turns more sharply than the model&apos;s cells can follow, or meets itself.</source>
        <translation>La ligne tourne plus court que les cellules du modèle ne peuvent suivre, ou se rencontre elle-même.</translation>
    </message>
    <message>
        <source>Draw a wider curve, or begin a new cut farther away.</source>
        <translation>Dessinez une courbe plus large, ou commencez une nouvelle coupe plus loin.</translation>
    </message>
    <message>
        <source>Meshfree nodes reach ahead of a cut: its line cannot be drawn further once it is cut along.</source>
        <translation>Les nœuds sans maillage s’étendent au-delà d’une coupe : sa ligne ne peut plus être prolongée une fois qu’elle est entamée.</translation>
    </message>
    <message>
        <source>Give the whole line before its first advance, or begin a new cut.</source>
        <translation>Donnez toute la ligne avant sa première avancée, ou commencez une nouvelle coupe.</translation>
    </message>
    <message>
        <source>The line leaves the surface that it was drawn on.</source>
        <translation>La ligne quitte la surface sur laquelle elle a été dessinée.</translation>
    </message>
    <message>
        <source>Turn the liver until you look onto it, and go on from there.</source>
        <translation>Tournez le foie jusqu’à le voir de face, et continuez de là.</translation>
    </message>
    <message>
        <source>Lift, and begin a new cut farther away.</source>
        <translation>Relâchez, et commencez une nouvelle coupe plus loin.</translation>
    </message>
    <message>
        <source>Cut freehand</source>
        <translation>Couper à main levée</translation>
    </message>
    <message>
        <source>A body in motion keeps its moduli.</source>
        <translation>Un corps en mouvement garde ses modules.</translation>
    </message>
    <message>
        <source>A session in motion is by quadratic finite elements.</source>
        <translation>Une session en mouvement se calcule par éléments finis quadratiques.</translation>
    </message>
    <message>
        <source>A command is {&quot;hold&quot;: {...}}, {&quot;release&quot;: id}, {&quot;cut&quot;: {...}}, {&quot;undo&quot;: true}, {&quot;settle&quot;: true}, {&quot;compare&quot;: true} or {&quot;wait_steps&quot;: n}.</source>
        <translation>Une commande est {&quot;hold&quot;: {...}}, {&quot;release&quot;: id}, {&quot;cut&quot;: {...}}, {&quot;undo&quot;: true}, {&quot;settle&quot;: true}, {&quot;compare&quot;: true} ou {&quot;wait_steps&quot;: n}.</translation>
    </message>
    <message>
        <source>A cut does not advance in a session in motion.</source>
        <translation>Une coupe n’avance pas dans une session en mouvement.</translation>
    </message>
    <message>
        <source>Cut in a session at rest.</source>
        <translation>Coupez dans une session au repos.</translation>
    </message>
    <message>
        <source>At large strain a session in motion is damped by its mass alone.</source>
        <translation>En grandes déformations, une session en mouvement n’est amortie que par sa masse.</translation>
    </message>
    <message>
        <source>A session in motion is by finite elements.</source>
        <translation>Une session en mouvement se calcule par éléments finis.</translation>
    </message>
    <message>
        <source>Take the engine &quot;fem&quot;, or no motion.</source>
        <translation>Prenez la méthode &quot;fem&quot;, ou pas de mouvement.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::AblationControls</name>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
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
        <translation>Diamètre de la zone le long de la sonde</translation>
    </message>
    <message>
        <source>Diameter of the zone across the probe</source>
        <translation>Diamètre de la zone en travers de la sonde</translation>
    </message>
    <message>
        <source>from the side</source>
        <translation>par le côté</translation>
    </message>
    <message>
        <source>from the front</source>
        <translation>par l’avant</translation>
    </message>
    <message>
        <source>from below</source>
        <translation>par le bas</translation>
    </message>
    <message>
        <source>At the crosshair</source>
        <translation>Au réticule</translation>
    </message>
    <message>
        <source>Sets a zone of this size about the crosshair</source>
        <translation>Place une zone de cette taille autour du réticule</translation>
    </message>
    <message>
        <source>Over this tumour</source>
        <translation>Sur cette tumeur</translation>
    </message>
    <message>
        <source>Sets the smallest ball that holds the tumour chosen above with its margin</source>
        <translation>Place la plus petite boule qui contient la tumeur choisie ci-dessus avec sa marge</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::AdvanceControls</name>
    <message>
        <source>Cut 5 mm further</source>
        <translation>Couper 5 mm de plus</translation>
    </message>
    <message>
        <source>Leads the planned cut on, from the lower front edge to the upper back, while rigid tools hold the liver. Energy devices and bleeding are not simulated.</source>
        <translation>Poursuit la coupe prévue, du bord antérieur inférieur vers l’arrière et le haut, pendant que des instruments rigides tiennent le foie. Ni instruments à énergie ni saignement ne sont simulés.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Revenir</translation>
    </message>
    <message>
        <source>Tick the rigid tool above, to cut while tools hold the liver.</source>
        <translation>Cochez l’instrument rigide ci-dessus, pour couper pendant que des instruments tiennent le foie.</translation>
    </message>
    <message>
        <source>%1 % of the section is open, by up to %2 mm.</source>
        <translation>%1 % de la section est ouverte, jusqu’à %2 mm.</translation>
    </message>
    <message>
        <source>Crossed: %1.</source>
        <translation>Traversé : %1.</translation>
    </message>
    <message>
        <source>The plan&apos;s cut is %1 mm long. Nothing is cut yet.</source>
        <translation>La coupe prévue mesure %1 mm. Rien n’est encore coupé.</translation>
    </message>
    <message>
        <source>Plan a plane or a sheet in Resect and keep the plan, to cut along it here.</source>
        <translation>Planifiez un plan ou une surface dans Résection et gardez ce plan, pour couper ici le long de lui.</translation>
    </message>
    <message>
        <source>By finite elements: %1 mm.</source>
        <translation>Par éléments finis : %1 mm.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Closes the last advance, as long as no tool was moved since</source>
        <translation>Referme la dernière avancée, tant qu’aucun instrument n’a bougé depuis</translation>
    </message>
    <message>
        <source>Cut freehand</source>
        <translation>Couper à main levée</translation>
    </message>
    <message>
        <source>Then draw over the liver in the 3D view with the left button held: it parts behind the pointer, straight away from you, as deep as is said here. From the end of the last line the cut goes on.</source>
        <translation>Puis dessinez sur le foie dans la vue 3D, bouton gauche tenu : il se sépare derrière le pointeur, droit devant vous, aussi profond qu’il est dit ici. Depuis le bout de la dernière ligne, la coupe continue.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How deep the knife goes from the surface, away from you</source>
        <translation>À quelle profondeur va le couteau depuis la surface, droit devant vous</translation>
    </message>
    <message>
        <source>%1 cm² are cut, open by up to %2 mm.</source>
        <translation>%1 cm² sont coupés, ouverts de %2 mm au plus.</translation>
    </message>
    <message>
        <source>Cut freehand, or plan a plane or a sheet in Resect and keep the plan, to cut along it here.</source>
        <translation>Coupez à main levée, ou planifiez un plan ou une surface dans Résection et gardez-le, pour couper ici le long de lui.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::AlgorithmChoice</name>
    <message>
        <source>ICP: nearest points</source>
        <translation>ICP&#xa0;: points les plus proches</translation>
    </message>
    <message>
        <source>GEO: distances along the surface</source>
        <translation>GEO&#xa0;: distances le long de la surface</translation>
    </message>
    <message>
        <source>GNRA: all frames by their landmarks</source>
        <translation>GNRA&#xa0;: toutes les images par leurs repères</translation>
    </message>
    <message>
        <source>Given by the sequence</source>
        <translation>Fourni par la séquence</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>Fourni</translation>
    </message>
    <message>
        <source>Algorithms</source>
        <translation>Algorithmes</translation>
    </message>
    <message>
        <source>First algorithm</source>
        <translation>Premier algorithme</translation>
    </message>
    <message>
        <source>Second algorithm</source>
        <translation>Second algorithme</translation>
    </message>
    <message>
        <source>What the left picture shows</source>
        <translation>Ce que montre l’image de gauche</translation>
    </message>
    <message>
        <source>What the right picture shows, or nothing</source>
        <translation>Ce que montre l’image de droite, ou rien</translation>
    </message>
    <message>
        <source>Register and judge</source>
        <translation>Recaler et juger</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Stops registering; what was computed before stays</source>
        <translation>Arrête le recalage&#xa0;; ce qui était déjà calculé reste</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>No second algorithm</source>
        <translation>Pas de second algorithme</translation>
    </message>
    <message>
        <source>The sequence names no registered clouds</source>
        <translation>La séquence ne nomme aucun nuage recalé</translation>
    </message>
    <message>
        <source>The sequence names no model</source>
        <translation>La séquence ne nomme aucun modèle</translation>
    </message>
    <message>
        <source>Open a sequence first</source>
        <translation>Ouvrez d’abord une séquence</translation>
    </message>
    <message>
        <source>It is being computed</source>
        <translation>Le calcul est en cours</translation>
    </message>
    <message>
        <source>Both algorithms are computed already</source>
        <translation>Les deux algorithmes sont déjà calculés</translation>
    </message>
    <message>
        <source>Registers every frame by the algorithms above and judges them by SIRGn: up to a second or so a frame</source>
        <translation>Recale chaque image par les algorithmes ci-dessus et les juge par SIRGn&#xa0;: jusqu’à une seconde environ par image</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::BorderByHand</name>
    <message>
        <source>Runs through the crosshair</source>
        <translation>Passe par le réticule</translation>
    </message>
    <message>
        <source>First stands the border that runs nearest to the crosshair</source>
        <translation>En premier figure la limite qui passe le plus près du réticule</translation>
    </message>
    <message>
        <source>Border %1 (%2 mm away)</source>
        <translation>Limite %1 (à %2 mm)</translation>
    </message>
    <message>
        <source>Forget the last place (%1)</source>
        <translation>Oublier le dernier endroit (%1)</translation>
    </message>
    <message>
        <source>Places on borders that were set by hand: %1. Segments are found again without the last</source>
        <translation>Endroits sur des limites placés à la main : %1. Les segments sont retrouvés sans le dernier</translation>
    </message>
    <message>
        <source>The border of these two segments is to pass the crosshair. Segments are found again by it, and are less in doubt. Its mark is dragged in a slice or in 3D; Delete takes away the one that was clicked on</source>
        <translation>La limite de ces deux segments doit passer par le réticule. Les segments sont retrouvés d’après elle, et sont moins incertains. Son repère se déplace dans une coupe ou en 3D ; Suppr ôte celui sur lequel on a cliqué</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::CandidatesTable</name>
    <message>
        <source>very strong</source>
        <translation>très forte</translation>
    </message>
    <message>
        <source>strong</source>
        <translation>forte</translation>
    </message>
    <message>
        <source>weak</source>
        <translation>faible</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Suspect, each by itself</source>
        <translation>Suspect, chacun seul</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>On trials left out</source>
        <translation>Sur les essais écartés</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>Preuve</translation>
    </message>
    <message>
        <source>These data cannot tell it from</source>
        <translation>Ces données ne le distinguent pas de</translation>
    </message>
    <message>
        <source>Root mean square on the trials that it was fitted to</source>
        <translation>Moyenne quadratique sur les essais auxquels il a été ajusté</translation>
    </message>
    <message>
        <source>Root mean square on trials that it was not fitted to, left out whole</source>
        <translation>Moyenne quadratique sur des essais entiers écartés, auxquels il n’a pas été ajusté</translation>
    </message>
    <message>
        <source>Against the declared model, by the difference of BIC</source>
        <translation>Contre le modèle déclaré, par la différence de BIC</translation>
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
        <translation>hors course&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::CaseDiary</name>
    <message>
        <source>Diary of %1 - Glisson</source>
        <translation>Journal de %1 - Glisson</translation>
    </message>
    <message>
        <source>What was done to this case, as far as it can be undone. Copied, it is a program that does the same without a window, on the case as it was before.</source>
        <translation>Ce qui a été fait à ce cas, pour autant qu’on puisse l’annuler. Copié, c’est un programme qui fait la même chose sans fenêtre, sur le cas tel qu’il était avant.</translation>
    </message>
    <message>
        <source>The steps</source>
        <translation>Les étapes</translation>
    </message>
    <message>
        <source>Copy as Python</source>
        <translation>Copier en Python</translation>
    </message>
    <message>
        <source>Copy as command line</source>
        <translation>Copier en ligne de commande</translation>
    </message>
    <message>
        <source>Steps copied: %1</source>
        <translation>Étapes copiées : %1</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::CaseOverview</name>
    <message>
        <source>The open case</source>
        <translation>Le cas ouvert</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Élément</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Créé par</translation>
    </message>
    <message>
        <source>What comes next</source>
        <translation>La suite</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>à jour</translation>
    </message>
    <message>
        <source>⚠ stale</source>
        <translation>⚠ périmé</translation>
    </message>
    <message>
        <source>⚠ changed by another program</source>
        <translation>⚠ modifié par un autre programme</translation>
    </message>
    <message>
        <source>⚠ file is gone</source>
        <translation>⚠ fichier disparu</translation>
    </message>
    <message>
        <source>Something that it was made from has changed since.</source>
        <translation>Quelque chose dont il a été tiré a changé depuis.</translation>
    </message>
    <message>
        <source>No case is open. Open images, choose what each series is for, and make a case of them.</source>
        <translation>Aucun cas n’est ouvert. Ouvrez des images, choisissez à quoi sert chaque série et créez-en un cas.</translation>
    </message>
    <message>
        <source>Everything is up to date.</source>
        <translation>Tout est à jour.</translation>
    </message>
    <message>
        <source>Stale: %1. They were made from something that has changed since.</source>
        <translation>Périmés&#xa0;: %1. Ils ont été tirés de quelque chose qui a changé depuis.</translation>
    </message>
    <message>
        <source>Make the model anew</source>
        <translation>Refaire le modèle</translation>
    </message>
    <message>
        <source>There are no anatomical images: without them nothing can be outlined. Open them on the left.</source>
        <translation>Il n’y a pas d’images anatomiques&#xa0;: sans elles, rien ne peut être délimité. Ouvrez-les à gauche.</translation>
    </message>
    <message>
        <source>The elastography has not been inverted: File, Elastography waves (Ctrl+W) makes the stiffness of it.</source>
        <translation>L’élastographie n’a pas été inversée&#xa0;: Fichier, Ondes d’élastographie (Ctrl+W) en tire la rigidité.</translation>
    </message>
    <message>
        <source>The liver is not outlined yet.</source>
        <translation>Le foie n’est pas encore délimité.</translation>
    </message>
    <message>
        <source>Outline it in Segment</source>
        <translation>La délimiter dans Segmenter</translation>
    </message>
    <message>
        <source>There is no model yet.</source>
        <translation>Il n’y a pas encore de modèle.</translation>
    </message>
    <message>
        <source>Build the model</source>
        <translation>Construire le modèle</translation>
    </message>
    <message>
        <source>The model is there.</source>
        <translation>Le modèle est là.</translation>
    </message>
    <message>
        <source>Rehearse</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>Building the model</source>
        <translation>Construction du modèle</translation>
    </message>
    <message>
        <source>import</source>
        <translation>import</translation>
    </message>
    <message>
        <source>outlining</source>
        <translation>délimitation</translation>
    </message>
    <message>
        <source>meshing</source>
        <translation>maillage</translation>
    </message>
    <message>
        <source>giving stiffness</source>
        <translation>attribution de la rigidité</translation>
    </message>
    <message>
        <source>inversion of waves</source>
        <translation>inversion des ondes</translation>
    </message>
    <message>
        <source>Outline: %1</source>
        <translation>Contour&#xa0;: %1</translation>
    </message>
    <message>
        <source>Surface: %1</source>
        <translation>Surface&#xa0;: %1</translation>
    </message>
    <message>
        <source>Tetrahedra of the liver</source>
        <translation>Tétraèdres du foie</translation>
    </message>
    <message>
        <source>Model: stiffness of each cell</source>
        <translation>Modèle&#xa0;: rigidité de chaque cellule</translation>
    </message>
    <message>
        <source>Images: anatomy</source>
        <translation>Images&#xa0;: anatomie</translation>
    </message>
    <message>
        <source>Map: stiffness (kPa)</source>
        <translation>Carte&#xa0;: rigidité (kPa)</translation>
    </message>
    <message>
        <source>Map: confidence</source>
        <translation>Carte&#xa0;: confiance</translation>
    </message>
    <message>
        <source>MRE magnitude</source>
        <translation>Magnitude ERM</translation>
    </message>
    <message>
        <source>MRE phase</source>
        <translation>Phase ERM</translation>
    </message>
    <message>
        <source>MRE waves</source>
        <translation>Ondes ERM</translation>
    </message>
    <message>
        <source>There is no model yet. Without elastography its stiffness is assumed: the atlas&apos;s.</source>
        <translation>Il n’y a pas encore de modèle. Sans élastographie, sa rigidité est supposée : celle de l’atlas.</translation>
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
        <translation>Avec une seule rigidité pour tout le foie, comme la donne un atlas</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>Atlas in red, patient in blue: purple where they agree</source>
        <translation>Atlas en rouge, patient en bleu&#xa0;: violet là où ils concordent</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Côte à côte</translation>
    </message>
    <message>
        <source>Two 3D views that turn together: the patient on the left, the atlas on the right</source>
        <translation>Deux vues 3D qui tournent ensemble&#xa0;: le patient à gauche, l’atlas à droite</translation>
    </message>
    <message>
        <source>No stiffness was measured: there is nothing to compare with the atlas</source>
        <translation>Aucune rigidité n’a été mesurée : il n’y a rien à comparer à l’atlas</translation>
    </message>
    <message>
        <source>With this patient&apos;s own stiffness, as it was measured</source>
        <translation>Avec la rigidité propre à ce patient, telle qu’elle a été mesurée</translation>
    </message>
    <message>
        <source>With the assumed stiffness</source>
        <translation>Avec la rigidité supposée</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ContourPlot</name>
    <message>
        <source>Liver (cm³)</source>
        <translation>Foie (cm³)</translation>
    </message>
    <message>
        <source>Volume of a node (mm³)</source>
        <translation>Volume d’un nœud (mm³)</translation>
    </message>
    <message>
        <source>Accuracy (mm)</source>
        <translation>Précision (mm)</translation>
    </message>
    <message>
        <source>hot spot</source>
        <translation>point chaud</translation>
    </message>
    <message>
        <source>this case</source>
        <translation>ce cas</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::CutControls</name>
    <message>
        <source>Cut by a plane</source>
        <translation>Section par un plan</translation>
    </message>
    <message>
        <source>Cut by a smooth surface through points</source>
        <translation>Section par une surface lisse passant par des points</translation>
    </message>
    <message>
        <source>Divides</source>
        <translation>Sépare</translation>
    </message>
    <message>
        <source>left from right</source>
        <translation>la gauche de la droite</translation>
    </message>
    <message>
        <source>front from back</source>
        <translation>l’avant de l’arrière</translation>
    </message>
    <message>
        <source>head from foot</source>
        <translation>la tête des pieds</translation>
    </message>
    <message>
        <source>Through crosshair</source>
        <translation>Par le réticule</translation>
    </message>
    <message>
        <source>Puts the plane through the crosshair, across the direction above</source>
        <translation>Place le plan par le réticule, en travers de la direction ci-dessus</translation>
    </message>
    <message>
        <source>By three clicks</source>
        <translation>Par trois clics</translation>
    </message>
    <message>
        <source>Then click three places on the liver or in the slices</source>
        <translation>Cliquez ensuite trois endroits sur le foie ou dans les coupes</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Décaler</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Incliner</translation>
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
        <translation>Distance du plan au milieu du foie, le long de sa normale</translation>
    </message>
    <message>
        <source>The normal about the axis from feet to head: 0° to the patient&apos;s left, 90° to the back</source>
        <translation>La normale autour de l’axe pieds-tête&#xa0;: 0° vers la gauche du patient, 90° vers l’arrière</translation>
    </message>
    <message>
        <source>The normal upwards: 90° to the head</source>
        <translation>La normale vers le haut&#xa0;: 90° vers la tête</translation>
    </message>
    <message>
        <source>Set points</source>
        <translation>Poser des points</translation>
    </message>
    <message>
        <source>Each click on the liver or in a slice sets a point; points can be dragged</source>
        <translation>Chaque clic sur le foie ou dans une coupe pose un point&#xa0;; les points peuvent être déplacés</translation>
    </message>
    <message>
        <source>Drop the last</source>
        <translation>Ôter le dernier</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Points set: %1. Three are needed.</source>
        <translation>Points posés&#xa0;: %1. Il en faut trois.</translation>
    </message>
    <message>
        <source>Points set: %1. Drag them in any view.</source>
        <translation>Points posés&#xa0;: %1. Déplacez-les dans n’importe quelle vue.</translation>
    </message>
    <message>
        <source>Draw a line</source>
        <translation>Tracer une ligne</translation>
    </message>
    <message>
        <source>Then draw over the liver in the 3D view with the left button held: the cut goes straight down under the line, as it is seen from there</source>
        <translation>Tracez ensuite sur le foie dans la vue 3D, le bouton gauche enfoncé : la section descend tout droit sous la ligne, telle qu’on la voit de là</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::DeformationChoice</name>
    <message>
        <source>Deformations</source>
        <translation>Déformations</translation>
    </message>
    <message>
        <source>Small (at once)</source>
        <translation>Petites (immédiat)</translation>
    </message>
    <message>
        <source>A linear liver: made for strains up to 20 %</source>
        <translation>Un foie linéaire : fait pour des déformations relatives jusqu’à 20 %</translation>
    </message>
    <message>
        <source>Large (settles)</source>
        <translation>Grandes (se stabilise)</translation>
    </message>
    <message>
        <source>A hyperelastic (neo-Hookean) liver of the same stiffness: made for larger strains too. A first picture says how far its landmarks may be from rest, and is brought to rest in the background.</source>
        <translation>Un foie hyperélastique (néo-hookéen) de même rigidité : fait aussi pour des déformations relatives plus grandes. Une première image dit à quelle distance du repos ses repères peuvent être, et elle est amenée au repos en arrière-plan.</translation>
    </message>
    <message>
        <source>Use large deformations</source>
        <translation>Prendre les grandes déformations</translation>
    </message>
    <message>
        <source>The tools stay where they are; what was recorded begins anew</source>
        <translation>Les instruments restent où ils sont ; l’enregistrement recommence</translation>
    </message>
    <message>
        <source>The liver is being prepared for large deformations.</source>
        <translation>Le foie est en préparation pour les grandes déformations.</translation>
    </message>
    <message>
        <source>Large deformations, as you chose.</source>
        <translation>Grandes déformations, comme vous l’avez choisi.</translation>
    </message>
    <message>
        <source>Large deformations, as you chose: strains reach %1 %, small ones would only extrapolate.</source>
        <translation>Grandes déformations, comme vous l’avez choisi : les déformations relatives atteignent %1 %, les petites ne feraient qu’extrapoler.</translation>
    </message>
    <message>
        <source>Large deformations, as you chose. Strains reach %1 %: small ones would do.</source>
        <translation>Grandes déformations, comme vous l’avez choisi. Les déformations relatives atteignent %1 % : les petites suffiraient.</translation>
    </message>
    <message>
        <source>Small deformations: evidence gave this liver a grain, which large ones do not know.</source>
        <translation>Petites déformations : des preuves ont donné à ce foie une direction de fibres, que les grandes ne connaissent pas.</translation>
    </message>
    <message>
        <source>Small deformations: made for strains up to 20 %.</source>
        <translation>Petites déformations : faites pour des déformations relatives jusqu’à 20 %.</translation>
    </message>
    <message>
        <source>Small deformations, but strains reach %1 %: beyond 20 % take large ones.</source>
        <translation>Petites déformations, mais les déformations relatives atteignent %1 % : au-delà de 20 %, prendre les grandes.</translation>
    </message>
    <message>
        <source>Small deformations: enough, since strains reach %1 % only.</source>
        <translation>Petites déformations : elles suffisent, car les déformations relatives n’atteignent que %1 %.</translation>
    </message>
    <message>
        <source>Small, meshfree</source>
        <translation>Petites, sans maillage</translation>
    </message>
    <message>
        <source>A linear liver by a few hundred meshfree nodes in place of finite elements, under rigid tools. Finite elements answer beside it, so that you see what it costs and what it misses.</source>
        <translation>Un foie linéaire par quelques centaines de nœuds sans maillage à la place des éléments finis, sous des instruments rigides. Les éléments finis répondent à côté, pour que vous voyiez ce qu&apos;il en coûte et ce qui lui échappe.</translation>
    </message>
    <message>
        <source>The liver is being prepared for the meshfree engine.</source>
        <translation>Le foie est préparé pour la méthode sans maillage.</translation>
    </message>
    <message>
        <source>Meshfree, as you chose. Finite elements will answer beside it.</source>
        <translation>Sans maillage, comme vous l&apos;avez choisi. Les éléments finis répondront à côté.</translation>
    </message>
    <message>
        <source>Meshfree, as you chose. Finite elements found no shape under these tools.</source>
        <translation>Sans maillage, comme vous l&apos;avez choisi. Les éléments finis n&apos;ont trouvé aucune forme sous ces instruments.</translation>
    </message>
    <message>
        <source>Meshfree, as you chose: %1 ms, finite elements %2 ms. Landmarks are %3 mm apart at most, the surface %4 mm.</source>
        <translation>Sans maillage, comme vous l&apos;avez choisi : %1 ms, éléments finis %2 ms. Les repères s&apos;écartent de %3 mm au plus, la surface de %4 mm.</translation>
    </message>
    <message>
        <source>Small, in motion</source>
        <translation>Petites, en mouvement</translation>
    </message>
    <message>
        <source>A linear liver that takes its time, under rigid tools: what is let go swings and comes to rest, and tissue that creeps gives way under a held tool and comes back slowly. It is not cut.</source>
        <translation>Un foie linéaire qui prend son temps, sous des instruments rigides : ce qui est lâché oscille et vient au repos, et un tissu qui flue cède sous un instrument tenu et revient lentement. Il n’est pas coupé.</translation>
    </message>
    <message>
        <source>The liver is being prepared to move.</source>
        <translation>Le foie est préparé pour bouger.</translation>
    </message>
    <message>
        <source>Its tissue creeps, as evidence showed.</source>
        <translation>Son tissu flue, comme les preuves l’ont montré.</translation>
    </message>
    <message>
        <source>Its tissue is elastic: no accepted evidence shows that it creeps.</source>
        <translation>Son tissu est élastique : aucune preuve acceptée ne montre qu’il flue.</translation>
    </message>
    <message>
        <source>In motion, as you chose.</source>
        <translation>En mouvement, comme vous l’avez choisi.</translation>
    </message>
    <message>
        <source>In motion, as you chose: %1 mm/s at most.</source>
        <translation>En mouvement, comme vous l’avez choisi : %1 mm/s au plus.</translation>
    </message>
    <message>
        <source>In motion, as you chose: it has come to rest.</source>
        <translation>En mouvement, comme vous l’avez choisi : il est venu au repos.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::DiaryWindow</name>
    <message>
        <source>Log - Glisson</source>
        <translation>Journal - Glisson</translation>
    </message>
    <message>
        <source>What Glisson did, in English, for those who mend it. It holds nothing about a patient: no names, no paths, no values. Nothing is sent anywhere; you decide who gets it.</source>
        <translation>Ce que Glisson a fait, en anglais, pour ceux qui le réparent. Rien n’y concerne un patient&#xa0;: ni nom, ni chemin, ni valeur. Rien n’est envoyé nulle part&#xa0;; vous décidez qui le reçoit.</translation>
    </message>
    <message>
        <source>The log</source>
        <translation>Le journal</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Save a report of the problem...</source>
        <translation>Enregistrer un rapport du problème…</translation>
    </message>
    <message>
        <source>Save a report of the problem</source>
        <translation>Enregistrer un rapport du problème</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Texte (*.txt)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ErrorsTable</name>
    <message>
        <source>%1 × noise</source>
        <translation>%1 × bruit</translation>
    </message>
    <message>
        <source>Error, × noise</source>
        <translation>Erreur, × bruit</translation>
    </message>
    <message>
        <source>Error, %1</source>
        <translation>Erreur, %1</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>On trials left out</source>
        <translation>Sur les essais écartés</translation>
    </message>
    <message>
        <source>95 % interval of it</source>
        <translation>Intervalle à 95 %</translation>
    </message>
    <message>
        <source>Root mean square</source>
        <translation>Moyenne quadratique</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>95 of 100 are below</source>
        <translation>95 sur 100 sont en dessous</translation>
    </message>
    <message>
        <source>Noise of the measurement</source>
        <translation>Bruit de la mesure</translation>
    </message>
    <message>
        <source>Hidden targets, mean</source>
        <translation>Cibles cachées, moyenne</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::EvidenceAnswer</name>
    <message>
        <source>What was found</source>
        <translation>Ce qui a été trouvé</translation>
    </message>
    <message>
        <source>Residual (mm)</source>
        <translation>Résidu (mm)</translation>
    </message>
    <message>
        <source>Measured less predicted, where this trial was farthest off. Arrows %1 times as long as they are; colours reach to %2 mm, between markers interpolated.</source>
        <translation>Mesuré moins prédit, là où cet essai s’écarte le plus. Flèches allongées %1 fois&#xa0;; couleurs jusqu’à %2 mm, interpolées entre les marqueurs.</translation>
    </message>
    <message>
        <source>No test finds anything in it that noise would not do.</source>
        <translation>Aucun test n’y trouve rien que le bruit ne ferait pas.</translation>
    </message>
    <message>
        <source>What the declared model leaves is not noise: %1.</source>
        <translation>Ce que laisse le modèle déclaré n’est pas du bruit&#xa0;: %1.</translation>
    </message>
    <message>
        <source>What is left at the end: %1.</source>
        <translation>Ce qui reste à la fin&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>Suspects</source>
        <translation>Suspects</translation>
    </message>
    <message>
        <source>What to measure next</source>
        <translation>Que mesurer ensuite</translation>
    </message>
    <message>
        <source>No further trial is known that would tell the leading explanations apart.</source>
        <translation>On ne connaît pas d’autre essai qui départagerait les meilleures explications.</translation>
    </message>
    <message>
        <source>Trial that is shown</source>
        <translation>Essai montré</translation>
    </message>
    <message>
        <source>What is left, in space</source>
        <translation>Ce qui reste, dans l’espace</translation>
    </message>
    <message>
        <source>The error before and after</source>
        <translation>L’erreur avant et après</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
    <message>
        <source>The error falls from %1 to %2.</source>
        <translation>L&apos;erreur tombe de %1 à %2.</translation>
    </message>
    <message>
        <source>%1 It would tell what is likeliest from: %2.</source>
        <translation>%1 Il distinguerait le plus probable de : %2.</translation>
    </message>
    <message>
        <source>%1 Of the doubt %2 % is expected to be gone then.</source>
        <translation>%1 Du doute, %2 % devraient alors avoir disparu.</translation>
    </message>
    <message>
        <source>What these trials could have shown</source>
        <translation>Ce que ces essais auraient pu montrer</translation>
    </message>
    <message>
        <source>Of experiments of this sort no further trial is proposed.</source>
        <translation>Pour les expériences de ce genre, aucun autre essai n&apos;est proposé.</translation>
    </message>
    <message>
        <source>Nothing is missing: what the declared model leaves, %1, shows no effect.</source>
        <translation>Rien ne manque : ce que laisse le modèle déclaré, %1, ne montre aucun effet.</translation>
    </message>
    <message>
        <source>%1: something acts, but no effect that Glisson knows is probable enough to be named.</source>
        <translation>%1 : quelque chose agit, mais aucun effet que Glisson connaît n&apos;est assez probable pour être nommé.</translation>
    </message>
    <message>
        <source>%1: %2. This takes away %3 % of the error.</source>
        <translation>%1 : %2. Cela enlève %3 % de l&apos;erreur.</translation>
    </message>
    <message>
        <source>%1: %2 takes away %3 % of the error, but is not probable enough to be called the cause.</source>
        <translation>%1 : %2 enlève %3 % de l&apos;erreur, mais n&apos;est pas assez probable pour être appelé la cause.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::EvidenceView</name>
    <message>
        <source>Evidence</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Hold measurements against the model, and find what it lacks.</source>
        <translation>Confronter des mesures au modèle et trouver ce qui lui manque.</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Open an experiment...</source>
        <translation>Ouvrir une expérience…</translation>
    </message>
    <message>
        <source>A file that says what was measured and which model was assumed (Help, Closing the loop)</source>
        <translation>Un fichier qui dit ce qui a été mesuré et quel modèle a été supposé (Aide, Boucler la boucle par des mesures)</translation>
    </message>
    <message>
        <source>Try the example</source>
        <translation>Essayer l’exemple</translation>
    </message>
    <message>
        <source>Open a report...</source>
        <translation>Ouvrir un rapport…</translation>
    </message>
    <message>
        <source>A folder with report.json and model.json, written here or by glisson-cli explain</source>
        <translation>Un dossier avec report.json et model.json, écrit ici ou par glisson-cli explain</translation>
    </message>
    <message>
        <source>For the patient</source>
        <translation>Pour le patient</translation>
    </message>
    <message>
        <source>Accept for this patient</source>
        <translation>Accepter pour ce patient</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Other trials</source>
        <translation>Autres essais</translation>
    </message>
    <message>
        <source>Predict other trials...</source>
        <translation>Prédire d’autres essais…</translation>
    </message>
    <message>
        <source>An experiment of the same kind; where it was measured, both models are compared with it</source>
        <translation>Une expérience du même genre&#xa0;; là où elle a été mesurée, les deux modèles lui sont comparés</translation>
    </message>
    <message>
        <source>Save the report...</source>
        <translation>Enregistrer le rapport…</translation>
    </message>
    <message>
        <source>Explaining %1</source>
        <translation>Explication de %1</translation>
    </message>
    <message>
        <source>Open measurements first.</source>
        <translation>Ouvrez d’abord des mesures.</translation>
    </message>
    <message>
        <source>Nothing was found missing that could be accepted.</source>
        <translation>Rien de manquant n’a été trouvé qui pourrait être accepté.</translation>
    </message>
    <message>
        <source>What was found is of a computer, not of a patient.</source>
        <translation>Ce qui a été trouvé concerne un ordinateur, pas un patient.</translation>
    </message>
    <message>
        <source>Open the patient&apos;s case first.</source>
        <translation>Ouvrez d’abord le cas du patient.</translation>
    </message>
    <message>
        <source>Tick an effect among what was found.</source>
        <translation>Cochez un effet parmi ce qui a été trouvé.</translation>
    </message>
    <message>
        <source>%1, learnt from %2</source>
        <translation>%1, d’après %2</translation>
    </message>
    <message>
        <source>A palpation</source>
        <translation>Une palpation</translation>
    </message>
    <message>
        <source>A material test</source>
        <translation>Un essai de matériau</translation>
    </message>
    <message>
        <source>A wearable computer</source>
        <translation>Un ordinateur porté</translation>
    </message>
    <message>
        <source>Nothing is open.</source>
        <translation>Rien n’est ouvert.</translation>
    </message>
    <message>
        <source>The ticked effects change the organ that is rehearsed</source>
        <translation>Les effets cochés changent l’organe qui est répété</translation>
    </message>
    <message>
        <source>Nothing was accepted for this patient.</source>
        <translation>Rien n’a été accepté pour ce patient.</translation>
    </message>
    <message>
        <source>The organ is again what it was before</source>
        <translation>L’organe redevient ce qu’il était</translation>
    </message>
    <message>
        <source>Accepted: %1</source>
        <translation>Accepté&#xa0;: %1</translation>
    </message>
    <message>
        <source>Accepted, but left out: %1</source>
        <translation>Accepté, mais laissé de côté&#xa0;: %1</translation>
    </message>
    <message>
        <source>About %1 s left</source>
        <translation>Encore environ %1 s</translation>
    </message>
    <message>
        <source>About %1 min left</source>
        <translation>Encore environ %1 min</translation>
    </message>
    <message>
        <source>Accepting the evidence</source>
        <translation>Acceptation des constats</translation>
    </message>
    <message>
        <source>Taking the evidence back</source>
        <translation>Retrait des constats</translation>
    </message>
    <message>
        <source>Predicting the trials of %1</source>
        <translation>Prédiction des essais de %1</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>non mesuré</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Declared</source>
        <translation>Déclaré</translation>
    </message>
    <message>
        <source>Better</source>
        <translation>Meilleur</translation>
    </message>
    <message>
        <source>Root mean square error, %1</source>
        <translation>Erreur quadratique moyenne, %1</translation>
    </message>
    <message>
        <source>Open an experiment</source>
        <translation>Ouvrir une expérience</translation>
    </message>
    <message>
        <source>Experiments (*.json)</source>
        <translation>Expériences (*.json)</translation>
    </message>
    <message>
        <source>Open a report (a folder with report.json)</source>
        <translation>Ouvrir un rapport (un dossier avec report.json)</translation>
    </message>
    <message>
        <source>Predict other trials</source>
        <translation>Prédire d’autres essais</translation>
    </message>
    <message>
        <source>Save the report in this folder</source>
        <translation>Enregistrer le rapport dans ce dossier</translation>
    </message>
    <message>
        <source>The report is in %1</source>
        <translation>Le rapport est dans %1</translation>
    </message>
    <message>
        <source>What was found would change nothing in the rehearsal: %1</source>
        <translation>Ce qui a été trouvé ne changerait rien à la répétition : %1</translation>
    </message>
    <message>
        <source>This was measured on &quot;%1&quot;, and nothing shows that it is tissue of %2.</source>
        <translation>Cela a été mesuré sur « %1 », et rien ne montre que ce soit du tissu de %2.</translation>
    </message>
    <message>
        <source>Accept for this patient?</source>
        <translation>Accepter pour ce patient ?</translation>
    </message>
    <message>
        <source>Specimen: %1
Patient: %2

The organ that is rehearsed changes:
%3</source>
        <translation>Échantillon : %1
Patient : %2

L&apos;organe répété change :
%3</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Accepter</translation>
    </message>
    <message>
        <source>A sample of tissue, compressed: simulated, and it does something that its file does not declare</source>
        <translation>Un échantillon de tissu, comprimé&#xa0;: simulé, et il fait quelque chose que son fichier ne déclare pas</translation>
    </message>
    <message>
        <source>A guided sequence</source>
        <translation>Une séquence guidée</translation>
    </message>
    <message>
        <source>What was found is of a plate, not of a patient.</source>
        <translation>Ce qui a été trouvé est d&apos;une plaque, non d&apos;un patient.</translation>
    </message>
    <message>
        <source>A plate in full field</source>
        <translation>Une plaque en plein champ</translation>
    </message>
    <message>
        <source>What was found is of waves, not of how an organ is held.</source>
        <translation>Ce qui a été trouvé concerne des ondes, non la façon dont un organe est tenu.</translation>
    </message>
    <message>
        <source>Waves of an elastography</source>
        <translation>Ondes d’une élastographie</translation>
    </message>
    <message>
        <source>Open measurements of a palpation, a material test, a plate in full field, waves of an elastography, a guided sequence or a wearable computer.
Glisson says how far the declared model is off, what it lacks, and how sure that is.

No measurements at hand? Try the example: a simulated sample of tissue that does something undeclared.</source>
        <translation>Ouvrez des mesures d’une palpation, d’un essai de matériau, d’une plaque en champ complet, des ondes d’une élastographie, d’une séquence guidée ou d’un ordinateur porté.
Glisson dit de combien le modèle déclaré se trompe, ce qui lui manque et avec quelle certitude.

Pas de mesures sous la main&#xa0;? Essayez l’exemple&#xa0;: un échantillon de tissu simulé qui fait quelque chose de non déclaré.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ExportMenu</name>
    <message>
        <source>Images and outlines as NIfTI...</source>
        <translation>Images et contours en NIfTI...</translation>
    </message>
    <message>
        <source>Images and outlines as NRRD (3D Slicer)...</source>
        <translation>Images et contours en NRRD (3D Slicer)...</translation>
    </message>
    <message>
        <source>Outlines as DICOM SEG...</source>
        <translation>Contours en DICOM SEG...</translation>
    </message>
    <message>
        <source>Surfaces as STL...</source>
        <translation>Surfaces en STL...</translation>
    </message>
    <message>
        <source>Surfaces as OBJ...</source>
        <translation>Surfaces en OBJ...</translation>
    </message>
    <message>
        <source>Surfaces as VTP (ParaView)...</source>
        <translation>Surfaces en VTP (ParaView)...</translation>
    </message>
    <message>
        <source>The model&apos;s tetrahedra as VTU...</source>
        <translation>Les tétraèdres du modèle en VTU...</translation>
    </message>
    <message>
        <source>Save the outlines</source>
        <translation>Enregistrer les contours</translation>
    </message>
    <message>
        <source>DICOM (*.dcm)</source>
        <translation>DICOM (*.dcm)</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Enregistrer le modèle</translation>
    </message>
    <message>
        <source>VTK meshes (*.vtu)</source>
        <translation>Maillages VTK (*.vtu)</translation>
    </message>
    <message>
        <source>Write the files into this folder</source>
        <translation>Écrire les fichiers dans ce dossier</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Exportation</translation>
    </message>
    <message>
        <source>Files written: %1, in %2</source>
        <translation>Fichiers écrits : %1, dans %2</translation>
    </message>
    <message>
        <source>Outlines, remnant and specimen as DICOM SEG</source>
        <translation>Contours, foie restant et pièce en DICOM SEG</translation>
    </message>
    <message>
        <source>No plan is kept: keep one in Resect</source>
        <translation>Aucun plan n’est gardé : gardez-en un dans Résection</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FiguresTable</name>
    <message>
        <source>Figures of the registrations</source>
        <translation>Chiffres des recalages</translation>
    </message>
    <message>
        <source>Mean correlation</source>
        <translation>Corrélation moyenne</translation>
    </message>
    <message>
        <source>Rejected (%)</source>
        <translation>Rejetés (%)</translation>
    </message>
    <message>
        <source>TRE (mm)</source>
        <translation>TRE (mm)</translation>
    </message>
    <message>
        <source>TRE, this frame (mm)</source>
        <translation>TRE, cette image (mm)</translation>
    </message>
    <message>
        <source>RMSE (mm)</source>
        <translation>RMSE (mm)</translation>
    </message>
    <message>
        <source>RMSE, this frame (mm)</source>
        <translation>RMSE, cette image (mm)</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Durée (s)</translation>
    </message>
    <message>
        <source>SIRGn, over the triangles: 1 is best</source>
        <translation>SIRGn, sur les triangles&#xa0;: 1 est le meilleur</translation>
    </message>
    <message>
        <source>Share of the triangles whose corners are off by %1 mm or more on average</source>
        <translation>Part des triangles dont les sommets sont décalés de %1 mm ou plus en moyenne</translation>
    </message>
    <message>
        <source>Target registration error: how far registered landmarks are from where they are on the model, mm</source>
        <translation>Erreur de recalage de la cible (TRE)&#xa0;: distance entre les repères recalés et leur place sur le modèle, mm</translation>
    </message>
    <message>
        <source>How far the registered cloud is from the model (root mean square), mm</source>
        <translation>Distance du nuage recalé au modèle (moyenne quadratique), mm</translation>
    </message>
    <message>
        <source>To register all frames and to judge them, s</source>
        <translation>Pour recaler toutes les images et les juger, s</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FoundTree</name>
    <message>
        <source>Effect</source>
        <translation>Effet</translation>
    </message>
    <message>
        <source>Value ± sd</source>
        <translation>Valeur ± éc. type</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>● left open by the data</source>
        <translation>● laissé ouvert par les données</translation>
    </message>
    <message>
        <source>changes nothing in the rehearsal</source>
        <translation>ne change rien à la répétition</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FreehandKnife</name>
    <message>
        <source>The last line is still being cut.</source>
        <translation>La dernière ligne est encore en train d’être coupée.</translation>
    </message>
    <message>
        <source>The cut would skim the liver here: turn it until you look onto its surface.</source>
        <translation>La coupe ne ferait qu’effleurer le foie ici : tournez-le jusqu’à voir sa surface de face.</translation>
    </message>
    <message>
        <source>The line left the liver: the cut ends at its edge.</source>
        <translation>La ligne a quitté le foie : la coupe se termine à son bord.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FromMeasurements</name>
    <message>
        <source>Straight from measurements</source>
        <translation>Directement d’après des mesures</translation>
    </message>
    <message>
        <source>The liver lifted at segment VI by what was measured of the tissue, without a law.</source>
        <translation>Le foie soulevé au segment VI d’après ce qui a été mesuré du tissu, sans loi.</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Force of the retractor at segment VI</source>
        <translation>Force de l’écarteur au segment VI</translation>
    </message>
    <message>
        <source>Strain and stress...</source>
        <translation>Déformation et contrainte...</translation>
    </message>
    <message>
        <source>A table with the columns strain and stress_kPa, or a material experiment; compression is negative</source>
        <translation>Un tableau avec les colonnes strain et stress_kPa, ou une expérience de matériau ; la compression est négative</translation>
    </message>
    <message>
        <source>Show it in 3D</source>
        <translation>Le montrer en 3D</translation>
    </message>
    <message>
        <source>Measured strain and stress</source>
        <translation>Déformation et contrainte mesurées</translation>
    </message>
    <message>
        <source>Tables and experiments (*.csv *.json)</source>
        <translation>Tableaux et expériences (*.csv *.json)</translation>
    </message>
    <message>
        <source>Retracting by %1</source>
        <translation>Rétraction d’après %1</translation>
    </message>
    <message>
        <source>%1: %2 measurements, %3 N</source>
        <translation>%1 : %2 mesures, %3 N</translation>
    </message>
    <message>
        <source>Lifted by up to %1 mm; by the model&apos;s stiffness %2 mm.</source>
        <translation>Soulevé jusqu’à %1 mm ; d’après la rigidité du modèle, %2 mm.</translation>
    </message>
    <message>
        <source>Apart by %1 mm on average, %2 mm at most.</source>
        <translation>Écart de %1 mm en moyenne, %2 mm au plus.</translation>
    </message>
    <message>
        <source>Landmark %1: %2 mm apart, the most of all.</source>
        <translation>Repère %1 : %2 mm d’écart, le plus grand de tous.</translation>
    </message>
    <message>
        <source>▲ %1 % of the liver is strained farther than was measured.</source>
        <translation>▲ %1 % du foie est déformé plus loin que les mesures.</translation>
    </message>
    <message>
        <source>From the model&apos;s answer (mm)</source>
        <translation>De la réponse du modèle (mm)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::FromVideo</name>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>What is chosen here stays</source>
        <translation>Ce qui est choisi ici reste</translation>
    </message>
    <message>
        <source>Make the sequence</source>
        <translation>Créer la séquence</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Stops, and leaves nothing behind</source>
        <translation>S&apos;arrête et ne laisse rien</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Making a sequence from the video</source>
        <translation>Création d&apos;une séquence à partir de la vidéo</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was left behind.</source>
        <translation>Annulé. Rien n&apos;est resté.</translation>
    </message>
    <message>
        <source>It is being computed</source>
        <translation>Le calcul est en cours</translation>
    </message>
    <message>
        <source>Makes clouds and tracks of the frames, and opens them</source>
        <translation>Tire des images des nuages et des trajets, et les ouvre</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::GrowthControls</name>
    <message>
        <source>Earlier study...</source>
        <translation>Examen antérieur...</translation>
    </message>
    <message>
        <source>The case of this patient&apos;s earlier study, with its segments: a folder NAME.glisson</source>
        <translation>Le cas de l’examen antérieur de ce patient, avec ses segments : un dossier NAME.glisson</translation>
    </message>
    <message>
        <source>They are of one patient</source>
        <translation>Ils sont d’un même patient</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segmenter</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Maintenant</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Changement</translation>
    </message>
    <message>
        <source>kPa</source>
        <translation>kPa</translation>
    </message>
    <message>
        <source>ml without tumours, in the earlier study</source>
        <translation>ml sans tumeurs, dans l’examen antérieur</translation>
    </message>
    <message>
        <source>ml without tumours, in the open case</source>
        <translation>ml sans tumeurs, dans le cas ouvert</translation>
    </message>
    <message>
        <source>Of what it was; ~: no more than such a volume may be off by</source>
        <translation>De ce qu’il était ; ~ : pas plus que ce dont un tel volume peut s’écarter</translation>
    </message>
    <message>
        <source>Mean stiffness before and now</source>
        <translation>Rigidité moyenne avant et maintenant</translation>
    </message>
    <message>
        <source>Remnant of</source>
        <translation>Foie restant de</translation>
    </message>
    <message>
        <source>no plan</source>
        <translation>aucun plan</translation>
    </message>
    <message>
        <source>Days between</source>
        <translation>Jours entre les deux</translation>
    </message>
    <message>
        <source>0: by the dates of the images. To be typed where these have none</source>
        <translation>0 : d’après les dates des images. À saisir quand elles n’en ont pas</translation>
    </message>
    <message>
        <source>Standard volume</source>
        <translation>Volume standard</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>The liver&apos;s volume estimated from body size, of which the per cent are in both studies: -794.41 + 1267.28 × body surface in m² (Vauthey et al. 2002). 0: of each study&apos;s own liver</source>
        <translation>Le volume du foie estimé d’après la taille du corps, dont sont les pour cent dans les deux examens : -794.41 + 1267.28 × surface corporelle en m² (Vauthey et al. 2002). 0 : du foie de chaque examen</translation>
    </message>
    <message>
        <source>The case of the earlier study</source>
        <translation>Le cas de l’examen antérieur</translation>
    </message>
    <message>
        <source>Comparing...</source>
        <translation>Comparaison...</translation>
    </message>
    <message>
        <source>Remnant</source>
        <translation>Foie restant</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Foie</translation>
    </message>
    <message>
        <source>%1 % of the liver</source>
        <translation>%1 % du foie</translation>
    </message>
    <message>
        <source>%1 % and %2 % of it were measured.</source>
        <translation>%1 % et %2 % en ont été mesurés.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::GuidePage</name>
    <message>
        <source>Guide</source>
        <translation>Guider</translation>
    </message>
    <message>
        <source>See on a laparoscope&apos;s frames where tumours and vessels lie, and how far to trust it.</source>
        <translation>Voir sur les images d&apos;un laparoscope où sont tumeurs et vaisseaux, et jusqu&apos;où s&apos;y fier.</translation>
    </message>
    <message>
        <source>The liver in space, with what was seen of it</source>
        <translation>Le foie dans l&apos;espace, avec ce qui en a été vu</translation>
    </message>
    <message>
        <source>Open another...</source>
        <translation>En ouvrir une autre…</translation>
    </message>
    <message>
        <source>Another sequence.json in place of this one</source>
        <translation>Un autre sequence.json à la place de celui-ci</translation>
    </message>
    <message>
        <source>Opening the sequence</source>
        <translation>Ouverture de la séquence</translation>
    </message>
    <message>
        <source>Making an example sequence</source>
        <translation>Création d’une séquence d’exemple</translation>
    </message>
    <message>
        <source>Placing the liver</source>
        <translation>Placement du foie</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Image %1</translation>
    </message>
    <message>
        <source>dashed: may be off by more than %1 mm</source>
        <translation>tireté : peut être à plus de %1 mm</translation>
    </message>
    <message>
        <source>not placed</source>
        <translation>non placé</translation>
    </message>
    <message>
        <source>Writing the video</source>
        <translation>Écriture de la vidéo</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit : %1</translation>
    </message>
    <message>
        <source>Open a sequence</source>
        <translation>Ouvrir une séquence</translation>
    </message>
    <message>
        <source>Sequences (*.json)</source>
        <translation>Séquences (*.json)</translation>
    </message>
    <message>
        <source>Save a video of the frames</source>
        <translation>Enregistrer une vidéo des images</translation>
    </message>
    <message>
        <source>Movies (*.mp4);;Folder of pictures (*)</source>
        <translation>Films (*.mp4);;Dossier d’images (*)</translation>
    </message>
    <message>
        <source>do not trust here</source>
        <translation>ne pas s&apos;y fier ici</translation>
    </message>
    <message>
        <source>%1: do not trust, ±%2 mm</source>
        <translation>%1 : ne pas s&apos;y fier, ±%2 mm</translation>
    </message>
    <message>
        <source>%1 ±%2 mm, %3 mm deep</source>
        <translation>%1 ±%2 mm, à %3 mm de profondeur</translation>
    </message>
    <message>
        <source>%1 ±%2 mm</source>
        <translation>%1 ±%2 mm</translation>
    </message>
    <message>
        <source>The sequence names no camera, so that nothing can be drawn over the video.</source>
        <translation>La séquence ne nomme pas de caméra : rien ne peut être dessiné sur la vidéo.</translation>
    </message>
    <message>
        <source>By hand: nothing is known of the error yet. When it lies about right, press &quot;Refine&quot;.</source>
        <translation>À la main : on ne sait encore rien de l&apos;erreur. Quand il est à peu près en place, appuyez sur « Affiner ».</translation>
    </message>
    <message>
        <source>Not placed yet: it is being computed.</source>
        <translation>Pas encore placé : calcul en cours.</translation>
    </message>
    <message>
        <source>Not placed yet: press &quot;Place the liver&quot;.</source>
        <translation>Pas encore placé : appuyez sur « Placer le foie ».</translation>
    </message>
    <message>
        <source>Place it by hand, then press &quot;Refine&quot;.</source>
        <translation>Placez-le à la main, puis appuyez sur « Affiner ».</translation>
    </message>
    <message>
        <source>All outlines lie within %1 mm of the truth, 90 times of 100.</source>
        <translation>Tous les contours sont à %1 mm au plus de la vérité, 90 fois sur 100.</translation>
    </message>
    <message>
        <source>Trust no outline of this frame to %1 mm.</source>
        <translation>Ne vous fiez à aucun contour de cette image à %1 mm près.</translation>
    </message>
    <message>
        <source>Not to be trusted everywhere to %1 mm: %2.</source>
        <translation>Pas fiables partout à %1 mm près : %2.</translation>
    </message>
    <message>
        <source>%1 % of the liver&apos;s surface is seen; it is deformed by %2 mm.</source>
        <translation>%1 % de la surface du foie sont vus ; il est déformé de %2 mm.</translation>
    </message>
    <message>
        <source>One moment...</source>
        <translation>Un instant…</translation>
    </message>
    <message>
        <source>%1: %2 frames</source>
        <translation>%1 : %2 images</translation>
    </message>
    <message>
        <source>%1: placed in %2 of %3 frames</source>
        <translation>%1 : placé dans %2 images sur %3</translation>
    </message>
    <message>
        <source>Frame %1 with outlines</source>
        <translation>Image %1 avec contours</translation>
    </message>
    <message>
        <source>From a video...</source>
        <translation>D&apos;une vidéo…</translation>
    </message>
    <message>
        <source>Two videos, or one that shows both eyes, become a sequence</source>
        <translation>Deux vidéos, ou une qui montre les deux yeux, deviennent une séquence</translation>
    </message>
    <message>
        <source>Nothing was seen of the surface there: an instrument, or a gap. Click beside it.</source>
        <translation>Rien de la surface n&apos;a été vu là : un instrument ou un trou. Cliquez à côté.</translation>
    </message>
    <message>
        <source>Click along a line here, and along the same line on the model beside it.</source>
        <translation>Cliquez ici le long d&apos;une ligne, et le long de la même ligne sur le modèle à côté.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::GuidePanel</name>
    <message>
        <source>The liver on the frames</source>
        <translation>Le foie sur les images</translation>
    </message>
    <message>
        <source>Place the liver</source>
        <translation>Placer le foie</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Stops here; frames that are placed already stay</source>
        <translation>S&apos;arrête ici ; les images déjà placées restent</translation>
    </message>
    <message>
        <source>Place by hand</source>
        <translation>Placer à la main</translation>
    </message>
    <message>
        <source>Lay the liver over the frame yourself, where it is not found or found wrong</source>
        <translation>Poser vous-même le foie sur l&apos;image, s&apos;il n&apos;est pas trouvé ou mal trouvé</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Affiner</translation>
    </message>
    <message>
        <source>Drag: move. Right drag or Shift: turn. Wheel: nearer, farther. Ctrl and wheel: turn in the picture. Arrow keys, + and - do the same in steps.</source>
        <translation>Glisser : déplacer. Bouton droit ou Maj : tourner. Molette : plus près, plus loin. Ctrl et molette : tourner dans l&apos;image. Les flèches, + et - font de même par pas.</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Contours</translation>
    </message>
    <message>
        <source>Shows or hides what is drawn over the frame (O)</source>
        <translation>Montre ou cache ce qui est dessiné sur l&apos;image (O)</translation>
    </message>
    <message>
        <source>Opacity of the outlines</source>
        <translation>Opacité des contours</translation>
    </message>
    <message>
        <source>How strong the outlines stand on the frame</source>
        <translation>La force des contours sur l&apos;image</translation>
    </message>
    <message>
        <source>Trusted up to an error of</source>
        <translation>Fiable jusqu&apos;à une erreur de</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Outlines are dashed where 90 % of such places would be off by more than %1 mm</source>
        <translation>En tireté là où il faut plus de %1 mm pour contenir 90 % de tels points</translation>
    </message>
    <message>
        <source>It is being computed</source>
        <translation>Le calcul est en cours</translation>
    </message>
    <message>
        <source>The sequence names no camera, so that nothing can be drawn over the video.</source>
        <translation>La séquence ne nomme pas de caméra : rien ne peut être dessiné sur la vidéo.</translation>
    </message>
    <message>
        <source>Finds where the liver lies in the first frame, without a guess or by the lines that are marked, and follows it from frame to frame</source>
        <translation>Trouve, sans indication ou d&apos;après les lignes marquées, où est le foie dans la première image et le suit d&apos;image en image</translation>
    </message>
    <message>
        <source>Place the liver by hand first</source>
        <translation>Placez d&apos;abord le foie à la main</translation>
    </message>
    <message>
        <source>Fits the liver from where you laid it, and follows it from there</source>
        <translation>Ajuste le foie depuis l&apos;endroit où vous l&apos;avez posé et le suit à partir de là</translation>
    </message>
    <message>
        <source>Save a video...</source>
        <translation>Enregistrer une vidéo...</translation>
    </message>
    <message>
        <source>Place the liver first</source>
        <translation>Placez d&apos;abord le foie</translation>
    </message>
    <message>
        <source>All frames with their outlines as they are shown now, MP4 or pictures</source>
        <translation>Toutes les images avec leurs contours tels qu&apos;affichés, MP4 ou images</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::GuideWelcome</name>
    <message>
        <source>Where is the tumour in this picture?</source>
        <translation>Où est la tumeur dans cette image ?</translation>
    </message>
    <message>
        <source>Open a sequence...</source>
        <translation>Ouvrir une séquence…</translation>
    </message>
    <message>
        <source>Open the example</source>
        <translation>Ouvrir l&apos;exemple</translation>
    </message>
    <message>
        <source>A sequence.json with its clouds, tracks and pictures beside it</source>
        <translation>Un sequence.json avec ses nuages, trajectoires et images à côté</translation>
    </message>
    <message>
        <source>40 simulated frames, made in a few seconds the first time; 7 MB</source>
        <translation>40 images simulées, créées en quelques secondes la première fois ; 7 Mo</translation>
    </message>
    <message>
        <source>The liver of the open case is placed on a laparoscope&apos;s frames and follows them; its tumours and vessels are drawn where they are, with how far they may be off. Begin with the video of a stereo laparoscope and its calibration, or pictures of a board; or open a sequence that was made of one. The example is simulated and shows the demo patient&apos;s liver.</source>
        <translation>Le foie du cas ouvert est placé sur les images d&apos;un laparoscope et les suit ; ses tumeurs et ses vaisseaux sont dessinés là où ils sont, avec l&apos;écart possible. Commencez par la vidéo d&apos;un laparoscope stéréo et son calibrage, ou des images d&apos;une mire ; ou ouvrez une séquence qui en a été tirée. L&apos;exemple est simulé et montre le foie du patient de démonstration.</translation>
    </message>
    <message>
        <source>From a video...</source>
        <translation>D&apos;une vidéo…</translation>
    </message>
    <message>
        <source>Two videos, or one that shows both eyes, become a sequence</source>
        <translation>Deux vidéos, ou une qui montre les deux yeux, deviennent une séquence</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::KeptOrders</name>
    <message>
        <source>Comparing orders of steps</source>
        <translation>Comparaison des ordres des étapes</translation>
    </message>
    <message>
        <source>Order %1</source>
        <translation>Ordre %1</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>Name of the order</source>
        <translation>Nom de l’ordre</translation>
    </message>
    <message>
        <source>Keep these steps</source>
        <translation>Garder ces étapes</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Runs each order again from the liver at rest; the report shows what comes of it</source>
        <translation>Refait chaque ordre à partir du foie au repos ; le rapport en montre le résultat</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Écarter</translation>
    </message>
    <message>
        <source>Takes the order that is marked out of the case</source>
        <translation>Ôte du cas l’ordre marqué</translation>
    </message>
    <message>
        <source>Keeps all that the tools did, and the cut, in this order</source>
        <translation>Garde tout ce que les instruments ont fait, et la coupe, dans cet ordre</translation>
    </message>
    <message>
        <source>Kept since: compare again.</source>
        <translation>Un autre a été gardé depuis : comparez à nouveau.</translation>
    </message>
    <message>
        <source>Steps that could not be carried out, or are not to be used: %1</source>
        <translation>Étapes qui n’ont pu être exécutées ou à ne pas utiliser : %1</translation>
    </message>
    <message>
        <source>How far the landmark goes that moves most; 5 mm or more is marked !</source>
        <translation>Jusqu’où va le repère qui bouge le plus ; à partir de 5 mm il est marqué !</translation>
    </message>
    <message>
        <source>The largest force of any one tool</source>
        <translation>La plus grande force d’un seul instrument</translation>
    </message>
    <message>
        <source>The largest strain</source>
        <translation>La plus grande déformation</translation>
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
        <translation>On garde les étapes d&apos;instruments rigides et de grandes déformations, avec les éléments finis</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LabelNamesDialog</name>
    <message>
        <source>What the labels are</source>
        <translation>Ce que sont les étiquettes</translation>
    </message>
    <message>
        <source>%1 does not say what its values are. Choose a structure for each that you want.</source>
        <translation>%1 ne dit pas ce que sont ses valeurs. Choisissez une structure pour chacune de celles que vous voulez.</translation>
    </message>
    <message>
        <source>%1: %2 ml</source>
        <translation>%1 : %2 ml</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Laisser de côté</translation>
    </message>
    <message>
        <source>Take them</source>
        <translation>Les prendre</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LandmarkTable</name>
    <message>
        <source>Landmark</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Moves
mm</source>
        <translation>Déplac.
mm</translation>
    </message>
    <message>
        <source>Atlas off
mm</source>
        <translation>Écart
atlas
mm</translation>
    </message>
    <message>
        <source>From 5 mm</source>
        <translation>Dès
5 mm</translation>
    </message>
    <message>
        <source>How far from there the atlas&apos;s stiffness puts it</source>
        <translation>À quelle distance de là le place la rigidité de l’atlas</translation>
    </message>
    <message>
        <source>5 mm and more matters to a surgeon</source>
        <translation>5 mm et plus comptent pour un chirurgien</translation>
    </message>
    <message>
        <source>▲ Atlas off</source>
        <translation>▲ Atlas faux</translation>
    </message>
    <message>
        <source>● Moves</source>
        <translation>● Bouge</translation>
    </message>
    <message>
        <source>How far the landmark moves from where the scan shows it</source>
        <translation>De combien le repère s’éloigne de l’endroit où l’examen le montre</translation>
    </message>
    <message>
        <source>%1: set by hand. A double click renames it.</source>
        <translation>%1 : placé à la main. Un double-clic le renomme.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LanguageMenu</name>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>System language</source>
        <translation>Langue du système</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LinePanel</name>
    <message>
        <source>Mark a ridge or a ligament on the frame and on the model: where the shape alone does not tell how the liver lies, the line does</source>
        <translation>Marquer un bord ou un ligament sur l&apos;image et sur le modèle : là où la forme seule ne dit pas comment le foie est placé, la ligne le dit</translation>
    </message>
    <message>
        <source>Mark lines</source>
        <translation>Marquer des lignes</translation>
    </message>
    <message>
        <source>Falciform ligament</source>
        <translation>Ligament falciforme</translation>
    </message>
    <message>
        <source>Lower edge</source>
        <translation>Bord inférieur</translation>
    </message>
    <message>
        <source>Gall bladder&apos;s border</source>
        <translation>Bord de la vésicule</translation>
    </message>
    <message>
        <source>Another line</source>
        <translation>Autre ligne</translation>
    </message>
    <message>
        <source>The line that is marked</source>
        <translation>La ligne que l&apos;on marque</translation>
    </message>
    <message>
        <source>Which line the next clicks are of</source>
        <translation>À quelle ligne appartiennent les prochains clics</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Takes this line away, from the model and from all frames</source>
        <translation>Retire cette ligne du modèle et de toutes les images</translation>
    </message>
    <message>
        <source>Places on this frame: %1, on the model: %2.</source>
        <translation>Points sur cette image : %1, sur le modèle : %2.</translation>
    </message>
    <message>
        <source>It counts when the liver is placed.</source>
        <translation>Elle compte quand le foie est placé.</translation>
    </message>
    <message>
        <source>It counts from two on each.</source>
        <translation>Elle compte à partir de deux de chaque côté.</translation>
    </message>
    <message>
        <source>Click along the line on the frame, and along the same line on the model. The two need not begin or end at the same place. Undo takes a click back.</source>
        <translation>Cliquez le long de la ligne sur l&apos;image, et le long de la même ligne sur le modèle. Elles n&apos;ont pas à commencer ni à finir au même endroit. Annuler retire un clic.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::LinkedViews</name>
    <message>
        <source>Transverse</source>
        <translation>Transversale</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronale</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittale</translation>
    </message>
    <message>
        <source>Drag: turn. Shift+drag: shift. Wheel: zoom. Click: crosshair there.</source>
        <translation>Glisser&#xa0;: tourner. Maj+glisser&#xa0;: décaler. Molette&#xa0;: zoom. Clic&#xa0;: réticule à cet endroit.</translation>
    </message>
    <message>
        <source>Surgeon</source>
        <translation>Chirurgien</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Dessous</translation>
    </message>
    <message>
        <source>Look from here, everything in view</source>
        <translation>Regarder d’ici, tout dans la vue</translation>
    </message>
    <message>
        <source>Atlas</source>
        <translation>Atlas</translation>
    </message>
    <message>
        <source>Click: crosshair. Right drag: brightness and contrast. Wheel: next slice.
Ctrl+wheel: zoom. Shift+drag: shift. Ctrl+drag: turn. Knobs of the crosshair: tilt the other slices.</source>
        <translation>Clic&#xa0;: réticule. Glisser avec le bouton droit&#xa0;: luminosité et contraste. Molette&#xa0;: coupe suivante.
Ctrl+molette&#xa0;: zoom. Maj+glisser&#xa0;: déplacer. Ctrl+glisser&#xa0;: tourner. Poignées du réticule&#xa0;: incliner les autres coupes.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer l’image</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>The scan itself as a soft backdrop: bones and bright vessels behind the organ</source>
        <translation>L’image elle-même comme fond doux : os et vaisseaux brillants derrière l’organe</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::MainWindow</name>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de&#xa0;%1</translation>
    </message>
    <message>
        <source>Opening the demo patient</source>
        <translation>Ouverture du patient de démonstration</translation>
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
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Open a case...</source>
        <translation>&amp;Ouvrir un cas…</translation>
    </message>
    <message>
        <source>Open the &amp;demo patient</source>
        <translation>Ouvrir le patient de &amp;démonstration</translation>
    </message>
    <message>
        <source>&amp;Save the picture...</source>
        <translation>&amp;Enregistrer l’image…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aide</translation>
    </message>
    <message>
        <source>&amp;About Glisson</source>
        <translation>À &amp;propos de Glisson</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2&#xa0;%)</translation>
    </message>
    <message>
        <source>A defect in Glisson stopped this: %1</source>
        <translation>Un défaut de Glisson a interrompu cette opération&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Open a case (a folder NAME.glisson)</source>
        <translation>Ouvrir un cas (un dossier NOM.glisson)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer l’image</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>The picture could not be written to %1.</source>
        <translation>L’image n’a pas pu être écrite dans&#xa0;%1.</translation>
    </message>
    <message>
        <source>About Glisson</source>
        <translation>À propos de Glisson</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Glisson %1&lt;/h3&gt;&lt;p&gt;Planning and reviewing liver surgery.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Not a medical device.&lt;/b&gt; Not for diagnosis or treatment.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Glisson&#xa0;%1&lt;/h3&gt;&lt;p&gt;Planification et revue de la chirurgie du foie.&lt;/p&gt;&lt;p&gt;&lt;b&gt;N’est pas un dispositif médical.&lt;/b&gt; Ni pour le diagnostic, ni pour le traitement.&lt;/p&gt;&lt;p&gt;Logiciel libre sous la licence publique générale GNU, version 3 ou ultérieure.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Something else is still under way. Wait for it, or cancel it first.</source>
        <translation>Une autre opération est en cours. Attendez-la, ou annulez-la d’abord.</translation>
    </message>
    <message>
        <source>Outlining the liver</source>
        <translation>Délimitation du foie</translation>
    </message>
    <message>
        <source>Building the model</source>
        <translation>Construction du modèle</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>Elastography &amp;waves...</source>
        <translation>&amp;Ondes d’élastographie…</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>&amp;Aller</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Ouverts &amp;récemment</translation>
    </message>
    <message>
        <source>Se&amp;ttings...</source>
        <translation>Ré&amp;glages…</translation>
    </message>
    <message>
        <source>&amp;Keys...</source>
        <translation>&amp;Touches…</translation>
    </message>
    <message>
        <source>&amp;Log and problems...</source>
        <translation>&amp;Journal et problèmes…</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Aucun pour l’instant</translation>
    </message>
    <message>
        <source>Forget them</source>
        <translation>Vider la liste</translation>
    </message>
    <message>
        <source>&amp;Tour on the demo patient</source>
        <translation>&amp;Visite guidée avec le patient de démonstration</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Édition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>Open &amp;images...</source>
        <translation>Ouvrir des &amp;images...</translation>
    </message>
    <message>
        <source>&amp;Add labels...</source>
        <translation>&amp;Ajouter des étiquettes...</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exporter</translation>
    </message>
    <message>
        <source>&amp;Close the case</source>
        <translation>&amp;Fermer le cas</translation>
    </message>
    <message>
        <source>Open images: a folder, or a file of them</source>
        <translation>Ouvrir des images : un dossier, ou un de leurs fichiers</translation>
    </message>
    <message>
        <source>Add labels</source>
        <translation>Ajouter des étiquettes</translation>
    </message>
    <message>
        <source>Label maps and DICOM SEG (*.nii *.nii.gz *.nrrd *.mha *.mhd *.nhdr *.dcm);;All files (*)</source>
        <translation>Cartes d&apos;étiquettes et DICOM SEG (*.nii *.nii.gz *.nrrd *.mha *.mhd *.nhdr *.dcm);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1 is still under way. If you close now, it is given up, and the case stays as it was.</source>
        <translation>%1 est encore en cours. Si vous fermez maintenant, c’est abandonné, et le cas reste tel qu’il était.</translation>
    </message>
    <message>
        <source>Keep working</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Give it up and close</source>
        <translation>Abandonner et fermer</translation>
    </message>
    <message>
        <source>&amp;Diary of the case...</source>
        <translation>&amp;Journal du cas...</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ManualWindow</name>
    <message>
        <source>Manual - Glisson</source>
        <translation>Manuel - Glisson</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Chercher dans le manuel</translation>
    </message>
    <message>
        <source>Words to search for</source>
        <translation>Mots à chercher</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Pages du manuel</translation>
    </message>
    <message>
        <source>The page</source>
        <translation>La page</translation>
    </message>
    <message>
        <source>The manual was not found among the files that ship with Glisson.</source>
        <translation>Le manuel n’a pas été trouvé parmi les fichiers livrés avec Glisson.</translation>
    </message>
    <message>
        <source>No page holds these words.</source>
        <translation>Aucune page ne contient ces mots.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::MeasureList</name>
    <message>
        <source>Measurements</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Boule</translation>
    </message>
    <message>
        <source>Volume: %1</source>
        <translation>Volume&#xa0;: %1</translation>
    </message>
    <message>
        <source>Takes this measurement away</source>
        <translation>Retire cette mesure</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ModelPanel</name>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Bring it up to date</source>
        <translation>Le mettre à jour</translation>
    </message>
    <message>
        <source>Cells, stiffness and supports of the liver, and building them anew.</source>
        <translation>Cellules, rigidité et appuis du foie, et leur reconstruction.</translation>
    </message>
    <message>
        <source>Needs an outline of the liver: make it in Segment.</source>
        <translation>Il faut un contour du foie&#xa0;: tracez-le dans Segmenter.</translation>
    </message>
    <message>
        <source>The 3D view shows</source>
        <translation>La vue 3D montre</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidité</translation>
    </message>
    <message>
        <source>The patient</source>
        <translation>Le patient</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Cellules</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Module de Young</translation>
    </message>
    <message>
        <source>From MR elastography</source>
        <translation>De l’élastographie par RM</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation> kPa</translation>
    </message>
    <message>
        <source>Young&apos;s modulus, about three times the shear modulus</source>
        <translation>Module de Young, environ trois fois le module de cisaillement</translation>
    </message>
    <message>
        <source>Give it this stiffness</source>
        <translation>Lui donner cette rigidité</translation>
    </message>
    <message>
        <source>Elastography waves...</source>
        <translation>Ondes d’élastographie…</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Construire</translation>
    </message>
    <message>
        <source> cells</source>
        <translation> cellules</translation>
    </message>
    <message>
        <source>Wanted number of cells: more are finer and slower. 20 000 answer at once.</source>
        <translation>Nombre de cellules voulu&#xa0;: plus il y en a, plus c’est fin et lent. 20 000 répondent aussitôt.</translation>
    </message>
    <message>
        <source>Building the model</source>
        <translation>Construction du modèle</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de&#xa0;%1</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Fixé</translation>
    </message>
    <message>
        <source>On springs</source>
        <translation>Sur ressorts</translation>
    </message>
    <message>
        <source>Young&apos;s modulus (kPa)</source>
        <translation>Module de Young (kPa)</translation>
    </message>
    <message>
        <source>Needs a case: open one, or the demo patient.</source>
        <translation>Il faut un cas&#xa0;: ouvrez-en un, ou le patient de démonstration.</translation>
    </message>
    <message>
        <source>There is no model yet. Build it from the outline.</source>
        <translation>Il n’y a pas encore de modèle. Construisez-le à partir du contour.</translation>
    </message>
    <message>
        <source>✓ The model is up to date.</source>
        <translation>✓ Le modèle est à jour.</translation>
    </message>
    <message>
        <source>▲ A file of the model is gone.</source>
        <translation>▲ Un fichier du modèle a disparu.</translation>
    </message>
    <message>
        <source>▲ Another program has changed a file of the model.</source>
        <translation>▲ Un autre programme a modifié un fichier du modèle.</translation>
    </message>
    <message>
        <source>▲ The model is out of date.</source>
        <translation>▲ Le modèle est périmé.</translation>
    </message>
    <message>
        <source>▲ Out of date: %1 changed since it was built.</source>
        <translation>▲ Périmé&#xa0;: %1 a changé depuis sa construction.</translation>
    </message>
    <message>
        <source>Build it anew</source>
        <translation>Le reconstruire</translation>
    </message>
    <message>
        <source>Build the model</source>
        <translation>Construire le modèle</translation>
    </message>
    <message>
        <source>This case has no stiffness map: import one, or invert its waves</source>
        <translation>Ce cas n’a pas de carte de rigidité&#xa0;: importez-en une, ou inversez ses ondes</translation>
    </message>
    <message>
        <source>Keeps the cells and gives each this stiffness</source>
        <translation>Garde les cellules et donne à chacune cette rigidité</translation>
    </message>
    <message>
        <source>Needs cells: build the model first</source>
        <translation>Il faut des cellules&#xa0;: construisez d’abord le modèle</translation>
    </message>
    <message>
        <source>Makes the cells anew and gives them the stiffness chosen above</source>
        <translation>Refait les cellules et leur donne la rigidité choisie ci-dessus</translation>
    </message>
    <message>
        <source>See the waves and invert them</source>
        <translation>Voir les ondes et les inverser</translation>
    </message>
    <message>
        <source>This case has no raw waves</source>
        <translation>Ce cas n’a pas d’ondes brutes</translation>
    </message>
    <message>
        <source>Assumed from the liver&apos;s shape: the bare area at the vena cava is held, the dome below the diaphragm rests on springs of 1.1 kPa/mm.</source>
        <translation>Supposé d’après la forme du foie&#xa0;: l’area nuda contre la veine cave est fixée, le dôme sous le diaphragme repose sur des ressorts de 1.1 kPa/mm.</translation>
    </message>
    <message>
        <source>%1 cells, %2 points</source>
        <translation>%1 cellules, %2 points</translation>
    </message>
    <message>
        <source>Smallest dihedral angle %1°</source>
        <translation>Plus petit angle dièdre %1°</translation>
    </message>
    <message>
        <source>smallest dihedral angle of a cell, °</source>
        <translation>plus petit angle dièdre d’une cellule, °</translation>
    </message>
    <message>
        <source>%1 kPa on average, sd %2</source>
        <translation>%1 kPa en moyenne, écart-type %2</translation>
    </message>
    <message>
        <source>%1 % of the cells without data of their own, filled from inside</source>
        <translation>%1 % des cellules sans données propres, complétées depuis l’intérieur</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of a cell, kPa</source>
        <translation>module de Young d’une cellule, kPa</translation>
    </message>
    <message>
        <source>Assumed: the atlas&apos;s 2.1 kPa in shear</source>
        <translation>Supposé : les 2.1 kPa (cisaillement) de l’atlas</translation>
    </message>
    <message>
        <source>Assumed: the atlas&apos;s 2.6 kPa in shear</source>
        <translation>Supposé : les 2.6 kPa (cisaillement) de l’atlas</translation>
    </message>
    <message>
        <source>Assumed: one value for all cells</source>
        <translation>Supposé : une valeur pour toutes les cellules</translation>
    </message>
    <message>
        <source>%1 ml outlined; the cells hold %2 % of it</source>
        <translation>%1 ml de contour ; les cellules en remplissent %2 %</translation>
    </message>
    <message>
        <source>Assumed: %1 kPa for all cells</source>
        <translation>Supposé : %1 kPa pour toutes les cellules</translation>
    </message>
    <message>
        <source>Attachments</source>
        <translation>Attaches</translation>
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
        <translation>pas au repos : repères à %1 mm près</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::NextStepBox</name>
    <message>
        <source>Next: put the crosshair inside the liver, away from large vessels.</source>
        <translation>Ensuite&#xa0;: placez le réticule dans le foie, loin des gros vaisseaux.</translation>
    </message>
    <message>
        <source>Next: build the model of the liver from its outline and stiffness.</source>
        <translation>Ensuite&#xa0;: construisez le modèle du foie à partir de son contour et de sa rigidité.</translation>
    </message>
    <message>
        <source>Outline the liver from here</source>
        <translation>Délimiter le foie à partir d’ici</translation>
    </message>
    <message>
        <source>Build the model</source>
        <translation>Construire le modèle</translation>
    </message>
    <message>
        <source>Its elastography has not been inverted: until then the stiffness is assumed.</source>
        <translation>Son élastographie n’a pas été inversée : d’ici là, la rigidité est supposée.</translation>
    </message>
    <message>
        <source>Elastography waves...</source>
        <translation>Ondes d’élastographie…</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::Notices</name>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::NumberBox</name>
    <message>
        <source>At most %1.</source>
        <translation>Au plus %1.</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <translation>Au moins %1.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PathRow</name>
    <message>
        <source>Choose...</source>
        <translation>Choisir...</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>Dossiers (*)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PatientViews</name>
    <message>
        <source>Displacement (mm)</source>
        <translation>Déplacement (mm)</translation>
    </message>
    <message>
        <source>Red: one stiffness from the atlas</source>
        <translation>Rouge&#xa0;: une seule rigidité, de l’atlas</translation>
    </message>
    <message>
        <source>Blue: the patient&apos;s own stiffness</source>
        <translation>Bleu&#xa0;: la rigidité propre au patient</translation>
    </message>
    <message>
        <source>Purple: both agree</source>
        <translation>Violet&#xa0;: les deux concordent</translation>
    </message>
    <message>
        <source>Shear stiffness (kPa)</source>
        <translation>Rigidité en cisaillement (kPa)</translation>
    </message>
    <message>
        <source>%1  %2 mm</source>
        <translation>%1 &#xa0;%2 mm</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>The patient&apos;s own stiffness</source>
        <translation>La rigidité propre du patient</translation>
    </message>
    <message>
        <source>One stiffness from the atlas</source>
        <translation>Une seule rigidité, celle de l’atlas</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PlanByAnatomy</name>
    <message>
        <source>Segments and tumours</source>
        <translation>Segments et tumeurs</translation>
    </message>
    <message>
        <source>Find segments</source>
        <translation>Trouver les segments</translation>
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
        <translation>Reste, ml</translation>
    </message>
    <message>
        <source>kPa</source>
        <translation>kPa</translation>
    </message>
    <message>
        <source>Mean stiffness (Young&apos;s modulus) of the tissue that was measured; faint under half of it</source>
        <translation>Rigidité moyenne (module de Young) du tissu mesuré ; pâle en dessous de la moitié</translation>
    </message>
    <message>
        <source>Show segments</source>
        <translation>Montrer les segments</translation>
    </message>
    <message>
        <source>Take these segments</source>
        <translation>Prendre ces segments</translation>
    </message>
    <message>
        <source>Removes the segments that are ticked</source>
        <translation>Retire les segments cochés</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Around this tumour</source>
        <translation>Autour de cette tumeur</translation>
    </message>
    <message>
        <source>Removes the tumour with all tissue up to this margin</source>
        <translation>Retire la tumeur avec tout le tissu jusqu’à cette marge</translation>
    </message>
    <message>
        <source>Branches cut</source>
        <translation>Branches coupées</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Branche</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Diameter where it is cut</source>
        <translation>Diamètre là où elle est coupée</translation>
    </message>
    <message>
        <source>What of that stays in the patient without it</source>
        <translation>Ce qui en reste dans le patient sans elle</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Reste</translation>
    </message>
    <message>
        <source>Keeps it in the case under this name, beside the others</source>
        <translation>Le garde dans le cas sous ce nom, à côté des autres</translation>
    </message>
    <message>
        <source>Finding vessels and segments</source>
        <translation>Recherche des vaisseaux et des segments</translation>
    </message>
    <message>
        <source>Looking at the liver&apos;s anatomy...</source>
        <translation>Examen de l’anatomie du foie…</translation>
    </message>
    <message>
        <source>By the liver&apos;s shape alone: it has no vessel trees.</source>
        <translation>D’après la seule forme du foie : il n’y a pas d’arbres vasculaires.</translation>
    </message>
    <message>
        <source>%1 % of the segment was measured.</source>
        <translation>%1 % du segment a été mesuré.</translation>
    </message>
    <message>
        <source>%1 % of the liver without tumours stay.</source>
        <translation>%1 % du foie sans tumeurs restent.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 ml&lt;/b&gt; removed, &lt;b&gt;%2 ml&lt;/b&gt; stay: %3 % of the liver without tumours.</source>
        <translation>&lt;b&gt;%1 ml&lt;/b&gt; retirés, &lt;b&gt;%2 ml&lt;/b&gt; restent : %3 % du foie sans tumeurs.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 ml&lt;/b&gt; of it stay alive, perfused and drained (%2 %); without inflow %3 ml, without outflow %4 ml.</source>
        <translation>&lt;b&gt;%1 ml&lt;/b&gt; en restent vivants, perfusés et drainés (%2 %) ; sans apport %3 ml, sans drainage %4 ml.</translation>
    </message>
    <message>
        <source>Smallest margin: at least %1 mm.</source>
        <translation>Plus petite marge : au moins %1 mm.</translation>
    </message>
    <message>
        <source>Smallest margin: %1 mm.</source>
        <translation>Plus petite marge : %1 mm.</translation>
    </message>
    <message>
        <source>▲ %1 stays in the patient.</source>
        <translation>▲ %1 reste dans le patient.</translation>
    </message>
    <message>
        <source>▲ %1 is cut through.</source>
        <translation>▲ %1 est sectionné.</translation>
    </message>
    <message>
        <source>What stays has %1 kPa; %2 % of it was measured.</source>
        <translation>Ce qui reste a %1 kPa ; %2 % en ont été mesurés.</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Retiré</translation>
    </message>
    <message>
        <source>%1 is kept. Rehearse, Guide and the report follow it.</source>
        <translation>%1 est gardé. Répéter, Guider et le rapport le suivent.</translation>
    </message>
    <message>
        <source>%1 is kept.</source>
        <translation>%1 est gardé.</translation>
    </message>
    <message>
        <source>This patient is not kept in a case folder</source>
        <translation>Ce patient n’est pas conservé dans un dossier de cas</translation>
    </message>
    <message>
        <source>Needs a cut through the liver</source>
        <translation>Il faut une section à travers le foie</translation>
    </message>
    <message>
        <source>Keeps the cut on the liver held aside, for the report; the table is of plans at rest</source>
        <translation>Garde la section sur le foie écarté, pour le rapport ; le tableau est celui des plans au repos</translation>
    </message>
    <message>
        <source>Keeps it in the case under this name, beside the others; Rehearse, Guide and the report then follow it</source>
        <translation>Le garde dans le cas sous ce nom, à côté des autres ; Répéter, Guider et le rapport le suivent alors</translation>
    </message>
    <message>
        <source>The cut unrolled flat</source>
        <translation>La section déroulée à plat</translation>
    </message>
    <message>
        <source>%1 (%2 ml)</source>
        <translation>%1 (%2 ml)</translation>
    </message>
    <message>
        <source>%1 ml of what goes are ablated.</source>
        <translation>%1 ml de ce qui part sont détruits par ablation.</translation>
    </message>
    <message>
        <source>No tumour is outlined: the map shows the vessels alone.</source>
        <translation>Aucune tumeur n’est délimitée : la carte ne montre que les vaisseaux.</translation>
    </message>
    <message>
        <source>No tumour within %1 mm of the cut.</source>
        <translation>Aucune tumeur à moins de %1 mm de la section.</translation>
    </message>
    <message>
        <source>▲ The cut goes through a tumour.</source>
        <translation>▲ La section traverse une tumeur.</translation>
    </message>
    <message>
        <source>At the nearest the cut is %1 mm from a tumour.</source>
        <translation>Au plus près, la section est à %1 mm d’une tumeur.</translation>
    </message>
    <message>
        <source>Along this territory</source>
        <translation>Le long de ce territoire</translation>
    </message>
    <message>
        <source>Removes all that this branch feeds or drains, with what grows from it. Proposed: the smallest portal territory that holds the tumour above</source>
        <translation>Retire tout ce que cette branche irrigue ou draine, avec ce qui en part. Proposé : le plus petit territoire portal qui contient la tumeur ci-dessus</translation>
    </message>
    <message>
        <source>Ablation</source>
        <translation>Ablation</translation>
    </message>
    <message>
        <source>%1 with %2 mm around it needs a zone %3 mm wide; %4 mm is the widest. Set several.</source>
        <translation>%1 avec %2 mm autour demande une zone large de %3 mm ; %4 mm est la plus large. Placez-en plusieurs.</translation>
    </message>
    <message>
        <source>✕ gives it back</source>
        <translation>✕ le rend</translation>
    </message>
    <message>
        <source>Segments: %1</source>
        <translation>Segments : %1</translation>
    </message>
    <message>
        <source>Territory: %1</source>
        <translation>Territoire : %1</translation>
    </message>
    <message>
        <source>%1 with %2 mm around it</source>
        <translation>%1 avec %2 mm autour</translation>
    </message>
    <message>
        <source>Ablation, %1 × %2 mm</source>
        <translation>Ablation, %1 × %2 mm</translation>
    </message>
    <message>
        <source>Two stages</source>
        <translation>Deux temps</translation>
    </message>
    <message>
        <source>Growth since an earlier study</source>
        <translation>Croissance depuis un examen antérieur</translation>
    </message>
    <message>
        <source>By the liver&apos;s shape and borders set by hand: it has no vessel trees.</source>
        <translation>D’après la forme du foie et des limites placées à la main : il n’a pas d’arbres vasculaires.</translation>
    </message>
    <message>
        <source>By the portal and hepatic veins where both are outlined, else by the liver&apos;s shape alone. Arteries and bile ducts that are outlined get trees too</source>
        <translation>D’après la veine porte et les veines hépatiques là où les deux sont délimitées, sinon d’après la seule forme du foie. Les artères et les voies biliaires délimitées reçoivent aussi des arbres</translation>
    </message>
    <message>
        <source>Beyond</source>
        <translation>Au-delà</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Reste</translation>
    </message>
    <message>
        <source>All tissue that it feeds or drains beyond the cut; of an artery or a bile duct its own length</source>
        <translation>Tout le tissu qu’elle irrigue ou draine au-delà de la section ; pour une artère ou une voie biliaire, sa propre longueur</translation>
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
        <translation>Plans</translation>
    </message>
    <message>
        <source>as they were kept</source>
        <translation>dans l’ordre où ils furent gardés</translation>
    </message>
    <message>
        <source>widest margin first</source>
        <translation>plus grande marge d’abord</translation>
    </message>
    <message>
        <source>most tissue alive first</source>
        <translation>plus de tissu vivant d’abord</translation>
    </message>
    <message>
        <source>least tissue cut off first</source>
        <translation>moins de tissu coupé d’abord</translation>
    </message>
    <message>
        <source>Plans that leave a tumour, or cut through one, come after those that do not</source>
        <translation>Les plans qui laissent une tumeur, ou la traversent, viennent après les autres</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Reste</translation>
    </message>
    <message>
        <source>Alive</source>
        <translation>Vivant</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Coupées</translation>
    </message>
    <message>
        <source>Of the liver without its tumours</source>
        <translation>Du foie sans ses tumeurs</translation>
    </message>
    <message>
        <source>What stays perfused and drained, of the same</source>
        <translation>Ce qui reste perfusé et drainé, de même</translation>
    </message>
    <message>
        <source>Branches that are cut</source>
        <translation>Branches qui sont coupées</translation>
    </message>
    <message>
        <source>A ring: another plan is no worse in margin, living tissue and tumours, and better in one.</source>
        <translation>Un anneau : un autre plan n’est pas moins bon en marge, tissu vivant et tumeurs, et meilleur en l’un.</translation>
    </message>
    <message>
        <source>Name of the plan</source>
        <translation>Nom du plan</translation>
    </message>
    <message>
        <source>Keep this plan</source>
        <translation>Garder ce plan</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Keeps the plan that is marked a second time, to be changed</source>
        <translation>Garde une seconde fois le plan marqué, pour le modifier</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Écarter</translation>
    </message>
    <message>
        <source>Takes the plan that is marked out of the case</source>
        <translation>Ôte du cas le plan marqué</translation>
    </message>
    <message>
        <source>Rehearse, Guide and the report follow this plan</source>
        <translation>Répéter, Guider et le rapport suivent ce plan</translation>
    </message>
    <message>
        <source>What it was made from has changed since; the figures are those of now.</source>
        <translation>Ce dont il a été fait a changé depuis ; les chiffres sont ceux de maintenant.</translation>
    </message>
    <message>
        <source>No worse in anything, and better in something: %1</source>
        <translation>Moins bon en rien, et meilleur en quelque chose : %1</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PlanPlot</name>
    <message>
        <source>smallest margin, mm</source>
        <translation>plus petite marge, mm</translation>
    </message>
    <message>
        <source>stays alive, ml</source>
        <translation>reste vivant, ml</translation>
    </message>
    <message>
        <source>Plans by margin and by what stays alive</source>
        <translation>Plans selon la marge et ce qui reste vivant</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PlatformTable</name>
    <message>
        <source>Assumed: %1 %2 (%3)</source>
        <translation>Supposé&#xa0;:&#xa0;%1&#xa0;%2 (%3)</translation>
    </message>
    <message>
        <source>head</source>
        <translation>tête</translation>
    </message>
    <message>
        <source>belt</source>
        <translation>ceinture</translation>
    </message>
    <message>
        <source>back</source>
        <translation>dos</translation>
    </message>
    <message>
        <source>idle draw</source>
        <translation>repos</translation>
    </message>
    <message>
        <source>too hot idle</source>
        <translation>trop chaud au repos</translation>
    </message>
    <message>
        <source>too slow</source>
        <translation>trop lent</translation>
    </message>
    <message>
        <source>slows itself down</source>
        <translation>se ralentit</translation>
    </message>
    <message>
        <source>battery</source>
        <translation>batterie</translation>
    </message>
    <message>
        <source>too hot</source>
        <translation>trop chaud</translation>
    </message>
    <message>
        <source>✕ fails: %1</source>
        <translation>✕ échoue&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>heat</source>
        <translation>chaleur</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>✓ holds; next limit: %1</source>
        <translation>✓ tient&#xa0;; limite&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Plateforme</translation>
    </message>
    <message>
        <source>Worn on
the</source>
        <translation>Porté
sur</translation>
    </message>
    <message>
        <source>Draws idle
W</source>
        <translation>Au repos
W</translation>
    </message>
    <message>
        <source>Battery
allows W</source>
        <translation>Batterie
permet W</translation>
    </message>
    <message>
        <source>Left to
compute W</source>
        <translation>Reste pour
calculer W</translation>
    </message>
    <message>
        <source>Frames/s
at most</source>
        <translation>Images/s
au plus</translation>
    </message>
    <message>
        <source>Lasts
h</source>
        <translation>Dure
h</translation>
    </message>
    <message>
        <source>Surface
°C</source>
        <translation>Surface
°C</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Assumed
figures</source>
        <translation>Chiffres
supposés</translation>
    </message>
    <message>
        <source>What it takes from its battery when nothing is computed</source>
        <translation>Ce qu’elle prend à sa batterie quand rien n’est calculé</translation>
    </message>
    <message>
        <source>The largest constant power that its battery carries for the operation</source>
        <translation>La plus grande puissance constante que sa batterie soutient pendant l’opération</translation>
    </message>
    <message>
        <source>What the battery allows, less what idling takes</source>
        <translation>Ce que la batterie permet, moins ce que prend le repos</translation>
    </message>
    <message>
        <source>The frame rate that meets every constraint</source>
        <translation>La fréquence d’images qui satisfait toutes les contraintes</translation>
    </message>
    <message>
        <source>On one charge, at the wanted frame rate or the fastest it computes</source>
        <translation>Sur une charge, à la fréquence d’images voulue ou à la plus rapide qu’elle calcule</translation>
    </message>
    <message>
        <source>At the end of the operation</source>
        <translation>À la fin de l’opération</translation>
    </message>
    <message>
        <source>Figures that nobody measured; ≈ marks what rests on them</source>
        <translation>Chiffres que personne n’a mesurés&#xa0;; ≈ marque ce qui en dépend</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur&#xa0;%2</translation>
    </message>
    <message>
        <source>Sure to
hold %</source>
        <translation>Suffit
sûr %</translation>
    </message>
    <message>
        <source>In how many of 100 draws of its figures, off by as much as their sources may be, it holds</source>
        <translation>Dans combien de 100 tirages de ses chiffres, écartés autant que leurs sources le permettent, elle suffit</translation>
    </message>
    <message>
        <source>In 80 of 100 draws it can do %1 to %2 frames/s</source>
        <translation>Dans 80 tirages sur 100, elle atteint %1 à %2 images/s</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::PlatformView</name>
    <message>
        <source>Volume and stiffness of %1</source>
        <translation>Volume et rigidité de&#xa0;%1</translation>
    </message>
    <message>
        <source>Volume of %1; its stiffness is not known</source>
        <translation>Volume de&#xa0;%1&#xa0;; sa rigidité n’est pas connue</translation>
    </message>
    <message>
        <source>Stiffness of %1; its volume is not known</source>
        <translation>Rigidité de&#xa0;%1&#xa0;; son volume n’est pas connu</translation>
    </message>
    <message>
        <source>%1 has no outlined liver yet: type its volume</source>
        <translation>%1 n’a pas encore de foie délimité&#xa0;: saisissez son volume</translation>
    </message>
    <message>
        <source>The case</source>
        <translation>Le cas</translation>
    </message>
    <message>
        <source>No case is open: type its figures</source>
        <translation>Aucun cas n’est ouvert&#xa0;: saisissez ses chiffres</translation>
    </message>
    <message>
        <source> cm³</source>
        <translation> cm³</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Foie</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation> kPa</translation>
    </message>
    <message>
        <source>Mean Young&apos;s modulus. Softer tissue moves farther under the same load, and what a coarse model misses of it grows alike.</source>
        <translation>Module de Young moyen. Un tissu plus souple se déplace davantage sous la même charge, et ce qu’un modèle grossier en manque croît de même.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Module de Young</translation>
    </message>
    <message>
        <source>What is wanted</source>
        <translation>Ce qui est voulu</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Précision</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Duration of the operation</source>
        <translation>Durée de l’opération</translation>
    </message>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Fréquence d’images</translation>
    </message>
    <message>
        <source> /s</source>
        <translation> /s</translation>
    </message>
    <message>
        <source>The room and the skin</source>
        <translation>La pièce et la peau</translation>
    </message>
    <message>
        <source>Operating room</source>
        <translation>Salle d’opération</translation>
    </message>
    <message>
        <source> °C</source>
        <translation> °C</translation>
    </message>
    <message>
        <source>Hottest surface to be worn</source>
        <translation>Surface portée la plus chaude</translation>
    </message>
    <message>
        <source>Add devices...</source>
        <translation>Ajouter des appareils…</translation>
    </message>
    <message>
        <source>A table of your own, or what glisson-cli platform measure wrote</source>
        <translation>Une table à vous, ou ce que glisson-cli platform measure a écrit</translation>
    </message>
    <message>
        <source>Surface temperature</source>
        <translation>Température de surface</translation>
    </message>
    <message>
        <source>Frame rate that holds</source>
        <translation>Fréquence d’images qui tient</translation>
    </message>
    <message>
        <source>Battery life</source>
        <translation>Autonomie de la batterie</translation>
    </message>
    <message>
        <source>Mean power</source>
        <translation>Puissance moyenne</translation>
    </message>
    <message>
        <source>Add devices</source>
        <translation>Ajouter des appareils</translation>
    </message>
    <message>
        <source>Device tables (*.json)</source>
        <translation>Tables d’appareils (*.json)</translation>
    </message>
    <message>
        <source>%1 nodes of %2 mm³. A frame is %3 block products: %4 MB to move, %5 million operations.</source>
        <translation>%1 nœuds de&#xa0;%2 mm³. Une image fait&#xa0;%3 produits par blocs&#xa0;:&#xa0;%4 Mo à déplacer,&#xa0;%5 millions d’opérations.</translation>
    </message>
    <message>
        <source>None of these platforms holds.</source>
        <translation>Aucune de ces plates-formes ne tient.</translation>
    </message>
    <message>
        <source>Least obtrusive that holds, on the head: %1</source>
        <translation>La moins gênante qui tient, sur la tête&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Least obtrusive that holds, on the belt: %1</source>
        <translation>La moins gênante qui tient, à la ceinture&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Least obtrusive that holds, on the back: %1</source>
        <translation>La moins gênante qui tient, sur le dos&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Surface after %1 h at %2 frames/s (°C)</source>
        <translation>Surface après&#xa0;%1 h à&#xa0;%2 images/s (°C)</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Frames/s that hold for %1 h</source>
        <translation>Images/s qui tiennent&#xa0;%1 h</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Battery lasts at %1 frames/s (h)</source>
        <translation>La batterie dure à&#xa0;%1 images/s (h)</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>Mean power at %1 frames/s (W)</source>
        <translation>Puissance moyenne à&#xa0;%1 images/s (W)</translation>
    </message>
    <message>
        <source>%1 W: the battery</source>
        <translation>%1 W&#xa0;: la batterie</translation>
    </message>
    <message>
        <source>an operation of at most %1 h</source>
        <translation>une opération d’au plus&#xa0;%1 h</translation>
    </message>
    <message>
        <source>at most %1 frames/s</source>
        <translation>au plus&#xa0;%1 images/s</translation>
    </message>
    <message>
        <source>an accuracy of %1 mm</source>
        <translation>une précision de&#xa0;%1 mm</translation>
    </message>
    <message>
        <source>a battery of %1 Wh</source>
        <translation>une batterie de&#xa0;%1 Wh</translation>
    </message>
    <message>
        <source>a heat sink of %1 °C/W</source>
        <translation>un dissipateur de&#xa0;%1 °C/W</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesuré</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>calculé</translation>
    </message>
    <message>
        <source>dissertation</source>
        <translation>thèse</translation>
    </message>
    <message>
        <source>ASSUMED</source>
        <translation>SUPPOSÉ</translation>
    </message>
    <message>
        <source>Idle first: it draws %1 W of the %2 W that its battery allows over %3 h; it would last %4 h and reach %5 °C without computing anything.</source>
        <translation>Le repos d’abord&#xa0;: elle consomme&#xa0;%1 W sur les&#xa0;%2 W que sa batterie permet pendant&#xa0;%3 h&#xa0;; elle durerait&#xa0;%4 h et atteindrait&#xa0;%5 °C sans rien calculer.</translation>
    </message>
    <message>
        <source>Frames/s: %1 by its speed, %2 by its battery, %3 by its heat. A frame takes %4 J above idle; mean power %5 W.</source>
        <translation>Images/s&#xa0;:&#xa0;%1 par sa vitesse,&#xa0;%2 par sa batterie,&#xa0;%3 par sa chaleur. Une image prend&#xa0;%4 J au-dessus du repos&#xa0;; puissance moyenne&#xa0;%5 W.</translation>
    </message>
    <message>
        <source>Why it fails:</source>
        <translation>Pourquoi elle échoue&#xa0;:</translation>
    </message>
    <message>
        <source>No single figure would make it hold.</source>
        <translation>Aucun chiffre seul ne la ferait tenir.</translation>
    </message>
    <message>
        <source>It would hold with one of:</source>
        <translation>Elle tiendrait avec l’un de ceux-ci&#xa0;:</translation>
    </message>
    <message>
        <source>Where its figures come from:</source>
        <translation>D’où viennent ses chiffres&#xa0;:</translation>
    </message>
    <message>
        <source>Volume of %1; its stiffness is assumed</source>
        <translation>Volume de %1 ; sa rigidité est supposée</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Plateforme</translation>
    </message>
    <message>
        <source>Find what can be worn for this case.</source>
        <translation>Trouver ce qui peut être porté pour ce cas.</translation>
    </message>
    <message>
        <source>What is computed</source>
        <translation>Ce qui est calculé</translation>
    </message>
    <message>
        <source>The dissertation&apos;s product</source>
        <translation>Le produit de la thèse</translation>
    </message>
    <message>
        <source>A frame of it: %1 MB to move, %2 million operations.</source>
        <translation>Une image : %1 Mo à déplacer, %2 millions d’opérations.</translation>
    </message>
    <message>
        <source>How sure that is: with its figures off by as much as their sources may be, 5 to 30 %, it holds in %1 of 100 draws, and in 80 of 100 it can do %2 to %3 frames/s.</source>
        <translation>Degré de certitude : si ses chiffres s’écartent autant que leurs sources le permettent, de 5 à 30 %, elle suffit dans %1 tirages sur 100, et dans 80 sur 100 elle atteint %2 à %3 images/s.</translation>
    </message>
    <message>
        <source>Rehearse: a live frame, small deformations</source>
        <translation>Répéter : une image, petites déformations</translation>
    </message>
    <message>
        <source>Rehearse: a live frame, large deformations</source>
        <translation>Répéter : une image, grandes déformations</translation>
    </message>
    <message>
        <source>Rehearse: a step of the meshfree engine</source>
        <translation>Répéter : un pas de la méthode sans maillage</translation>
    </message>
    <message>
        <source>Guide: a frame</source>
        <translation>Guider : une image</translation>
    </message>
    <message>
        <source>Match: a registration of 128 points</source>
        <translation>Apparier : un recalage de 128 points</translation>
    </message>
    <message>
        <source>Read a power recording...</source>
        <translation>Lire un enregistrement de puissance...</translation>
    </message>
    <message>
        <source>What an oscilloscope, a power analyser or a battery tester wrote of a platform: idle power and power under load</source>
        <translation>Ce qu&apos;un oscilloscope, un analyseur de puissance ou un testeur de batterie a enregistré d&apos;une plateforme : puissance au repos et en charge</translation>
    </message>
    <message>
        <source>Read a power recording</source>
        <translation>Lire un enregistrement de puissance</translation>
    </message>
    <message>
        <source>Recordings (*.csv *.txt *.log *.tsv)</source>
        <translation>Enregistrements (*.csv *.txt *.log *.tsv)</translation>
    </message>
    <message>
        <source>%1, as recorded</source>
        <translation>%1, tel qu&apos;enregistré</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ProbabilityBars</name>
    <message>
        <source>Something that is not in the catalogue</source>
        <translation>Quelque chose qui n&apos;est pas dans le catalogue</translation>
    </message>
    <message>
        <source>Nothing is missing</source>
        <translation>Rien ne manque</translation>
    </message>
    <message>
        <source>Probability of each explanation. Where the answer was known, in generated experiments, 98 of 100 that were given 90 % and more were right, and 7 of 10 given 60 to 80 %.</source>
        <translation>Probabilité de chaque explication. Là où la réponse était connue, dans des expériences générées, 98 sur 100 à 90 % et plus étaient justes, et 7 sur 10 entre 60 et 80 %.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ReadingPanel</name>
    <message>
        <source>Reading</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>What the colours show</source>
        <translation>Ce que montrent les couleurs</translation>
    </message>
    <message>
        <source>Colours: SIRGn&apos;s correlation</source>
        <translation>Couleurs&#xa0;: corrélation de SIRGn</translation>
    </message>
    <message>
        <source>Colours: error of the landmarks (mm)</source>
        <translation>Couleurs&#xa0;: erreur des repères (mm)</translation>
    </message>
    <message>
        <source>Colours: doubt (mm)</source>
        <translation>Couleurs&#xa0;: doute (mm)</translation>
    </message>
    <message>
        <source>Correlation: whether landmarks and warp move alike over time, 1 is best. Error: mean distance of a triangle&apos;s landmarks, as registered, from where they are on the model, mm. Doubt: motion that the registration leaves unexplained, mm, to be compared within one sequence.</source>
        <translation>Corrélation&#xa0;: si les repères et la déformation bougent de même au cours du temps, 1 est le meilleur. Erreur&#xa0;: distance moyenne des repères recalés d’un triangle à leur place sur le modèle, mm. Doute&#xa0;: mouvement que le recalage laisse inexpliqué, mm, à comparer au sein d’une même séquence.</translation>
    </message>
    <message>
        <source>Tolerance: rejected from</source>
        <translation>Tolérance&#xa0;: rejet à partir de</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Triangles whose landmarks are off by this much or more, mm, are grey and hatched</source>
        <translation>Les triangles dont les repères sont décalés d’autant ou plus (mm) sont gris et hachurés</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Sets the tolerance to %1 mm</source>
        <translation>Règle la tolérance à %1 mm</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::RegisterPage</name>
    <message>
        <source>Register</source>
        <translation>Recaler</translation>
    </message>
    <message>
        <source>See how good a registration of a video is, place by place.</source>
        <translation>Voir ce que vaut le recalage d’une vidéo, endroit par endroit.</translation>
    </message>
    <message>
        <source>Opening the sequence</source>
        <translation>Ouverture de la séquence</translation>
    </message>
    <message>
        <source>Making an example sequence</source>
        <translation>Création d’une séquence d’exemple</translation>
    </message>
    <message>
        <source>Registering the video</source>
        <translation>Recalage de la vidéo</translation>
    </message>
    <message>
        <source>Open another...</source>
        <translation>En ouvrir une autre…</translation>
    </message>
    <message>
        <source>Another sequence.json in place of this one</source>
        <translation>Un autre sequence.json à la place de celui-ci</translation>
    </message>
    <message>
        <source>Open a sequence</source>
        <translation>Ouvrir une séquence</translation>
    </message>
    <message>
        <source>Sequences (*.json)</source>
        <translation>Séquences (*.json)</translation>
    </message>
    <message>
        <source>Click a triangle to see its history.</source>
        <translation>Cliquez sur un triangle pour voir son évolution.</translation>
    </message>
    <message>
        <source>%1 mm in this frame</source>
        <translation>%1 mm dans cette image</translation>
    </message>
    <message>
        <source>not all its corners are seen in this frame</source>
        <translation>tous ses sommets ne sont pas visibles dans cette image</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>rejeté</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>accepté</translation>
    </message>
    <message>
        <source>%1, triangle %2: correlation %3; off by %4 mm on average, %5; %6</source>
        <translation>%1, triangle %2&#xa0;: corrélation %3&#xa0;; décalé de %4 mm en moyenne, %5&#xa0;; %6</translation>
    </message>
    <message>
        <source>%1: %2 frames, %3 landmarks</source>
        <translation>%1&#xa0;: %2 images, %3 repères</translation>
    </message>
    <message>
        <source>One moment...</source>
        <translation>Un instant…</translation>
    </message>
    <message>
        <source>Click a triangle to see its history; hover over it for its figures</source>
        <translation>Cliquez sur un triangle pour voir son évolution&#xa0;; survolez-le pour ses chiffres</translation>
    </message>
    <message>
        <source>Not registered yet: press &quot;Register and judge&quot;.</source>
        <translation>Pas encore recalé&#xa0;: cliquez sur «&#xa0;Recaler et juger&#xa0;».</translation>
    </message>
    <message>
        <source>%1: %2 % of %3 triangles rejected at %4 mm</source>
        <translation>%1&#xa0;: %2 % de %3 triangles rejetés à %4 mm</translation>
    </message>
    <message>
        <source>The sequence names no camera, so that no mesh can be drawn over the video.</source>
        <translation>La séquence ne nomme aucune caméra&#xa0;: aucun maillage ne peut être dessiné sur la vidéo.</translation>
    </message>
    <message>
        <source>The sequence names no pictures; the mesh is drawn on black.</source>
        <translation>La séquence ne nomme aucune image&#xa0;; le maillage est dessiné sur fond noir.</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Corrélation</translation>
    </message>
    <message>
        <source>Error
(mm)</source>
        <translation>Erreur
(mm)</translation>
    </message>
    <message>
        <source>Doubt
(mm)</source>
        <translation>Doute
(mm)</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bon</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>mauvais</translation>
    </message>
    <message>
        <source>rejected: off by %1 mm or more</source>
        <translation>rejeté&#xa0;: décalé de %1 mm ou plus</translation>
    </message>
    <message>
        <source>the left edge</source>
        <translation>le bord gauche</translation>
    </message>
    <message>
        <source>the right edge</source>
        <translation>le bord droit</translation>
    </message>
    <message>
        <source>the upper edge</source>
        <translation>le bord supérieur</translation>
    </message>
    <message>
        <source>the lower edge</source>
        <translation>le bord inférieur</translation>
    </message>
    <message>
        <source>%1 is nowhere off by %2 mm or more.</source>
        <translation>%1 n&apos;est nulle part à %2 mm ou plus.</translation>
    </message>
    <message>
        <source>Do not trust %1: on most of it landmarks are off by %2 mm or more.</source>
        <translation>Ne vous fiez pas à %1 : sur la plus grande partie, les repères sont à %2 mm ou plus.</translation>
    </message>
    <message>
        <source>Of %1 do not trust single places: %2 % of it is off by %3 mm or more.</source>
        <translation>Pour %1, ne vous fiez pas à certains endroits : %2 % sont à %3 mm ou plus.</translation>
    </message>
    <message>
        <source>Of %1 do not trust %2: landmarks are off by %3 mm or more there.</source>
        <translation>Pour %1, ne vous fiez pas à ceci : %2. Les repères y sont à %3 mm ou plus.</translation>
    </message>
    <message>
        <source>Neither %1 nor %2 is clearly better here.</source>
        <translation>Ni %1 ni %2 n&apos;est nettement meilleur ici.</translation>
    </message>
    <message>
        <source>%1 is better here than %2.</source>
        <translation>%1 est meilleur ici que %2.</translation>
    </message>
    <message>
        <source>From a video...</source>
        <translation>D&apos;une vidéo…</translation>
    </message>
    <message>
        <source>Two videos, or one that shows both eyes, become a sequence</source>
        <translation>Deux vidéos, ou une qui montre les deux yeux, deviennent une séquence</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::RegisterWelcome</name>
    <message>
        <source>How good is a registration of a video?</source>
        <translation>Que vaut le recalage d’une vidéo&#xa0;?</translation>
    </message>
    <message>
        <source>Open a sequence...</source>
        <translation>Ouvrir une séquence…</translation>
    </message>
    <message>
        <source>A sequence.json with its clouds, tracks and pictures beside it</source>
        <translation>Un sequence.json avec ses nuages, trajectoires et images à côté</translation>
    </message>
    <message>
        <source>Make an example sequence</source>
        <translation>Créer une séquence d’exemple</translation>
    </message>
    <message>
        <source>Simulates 40 frames in a few seconds and opens them; 7 MB</source>
        <translation>Simule 40 images en quelques secondes et les ouvre&#xa0;; 7 Mo</translation>
    </message>
    <message>
        <source>Begin with the video of a stereo laparoscope and its calibration, or pictures of a board: a sequence is made of it, a cloud of points a frame and the tracks of landmarks. Or open a sequence that is there. Without a video, an example shows what it is about: the demo patient&apos;s liver, breathing and pressed by a tool, simulated.</source>
        <translation>Commencez par la vidéo d&apos;un laparoscope stéréo et son calibrage, ou des images d&apos;une mire : il en est tiré une séquence, un nuage de points par image et les trajets de repères. Ou ouvrez une séquence existante. Sans vidéo, un exemple montre de quoi il s&apos;agit : le foie du patient de démonstration, qui respire et que presse un instrument, simulé.</translation>
    </message>
    <message>
        <source>From a video...</source>
        <translation>D&apos;une vidéo…</translation>
    </message>
    <message>
        <source>Two videos, or one that shows both eyes, become a sequence</source>
        <translation>Deux vidéos, ou une qui montre les deux yeux, deviennent une séquence</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::RehearsePanel</name>
    <message>
        <source>Rehearse</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>Open a case with a model of the liver, or the demo patient, to rehearse a retraction.</source>
        <translation>Ouvrez un cas avec un modèle du foie, ou le patient de démonstration, pour répéter une rétraction.</translation>
    </message>
    <message>
        <source>Show the liver with the stiffness of</source>
        <translation>Montrer le foie avec la rigidité de</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>Colour the liver by how far it moves</source>
        <translation>Colorer le foie selon son déplacement</translation>
    </message>
    <message>
        <source>Place the tool to see what moves.</source>
        <translation>Placez l’instrument pour voir ce qui bouge.</translation>
    </message>
    <message>
        <source>The liver moves by up to %1 mm.</source>
        <translation>Le foie se déplace jusqu’à&#xa0;%1 mm.</translation>
    </message>
    <message>
        <source>The atlas is off by up to %1 mm.</source>
        <translation>L’atlas se trompe jusqu’à&#xa0;%1 mm.</translation>
    </message>
    <message>
        <source>Changed by evidence: %1</source>
        <translation>Modifié par les constats&#xa0;: %1</translation>
    </message>
    <message>
        <source>Evidence to bear in mind: %1</source>
        <translation>Constats à garder à l’esprit&#xa0;: %1</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Saves the landmarks as CSV, in mm</source>
        <translation>Enregistre les repères en CSV, en mm</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Au cours du temps</translation>
    </message>
    <message>
        <source>Save the landmarks as a table</source>
        <translation>Enregistrer les repères dans un tableau</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Placer</translation>
    </message>
    <message>
        <source>Sets a landmark where the crosshair is: click in a slice or in 3D first</source>
        <translation>Place un repère à l&apos;endroit du réticule : cliquez d&apos;abord dans une coupe ou en 3D</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Takes the chosen landmark away, if it was set by hand; Ctrl+Z brings it back</source>
        <translation>Retire le repère choisi, s&apos;il a été placé à la main ; Ctrl+Z le ramène</translation>
    </message>
    <message>
        <source>A name has letters or digits.</source>
        <translation>Un nom a des lettres ou des chiffres.</translation>
    </message>
    <message>
        <source>This name is taken.</source>
        <translation>Ce nom est déjà pris.</translation>
    </message>
    <message>
        <source>Rename landmark</source>
        <translation>Renommer le repère</translation>
    </message>
    <message>
        <source>Remove landmark</source>
        <translation>Retirer le repère</translation>
    </message>
    <message>
        <source>▲ The image cuts the liver off here, towards %1. The tool touches a cap where the liver goes on: place it elsewhere.</source>
        <translation>▲ L’image coupe le foie ici, vers %1. L’instrument touche une face plane là où le foie continue : placez-le ailleurs.</translation>
    </message>
    <message>
        <source>There are no landmarks: put the crosshair where one is to be, then press Set.</source>
        <translation>Il n’y a pas de repères : placez le réticule à l’endroit voulu, puis appuyez sur Placer.</translation>
    </message>
    <message>
        <source>Set landmark</source>
        <translation>Placer un repère</translation>
    </message>
    <message>
        <source>Pull with a tool, and see what moves and how far.</source>
        <translation>Tirer avec un instrument et voir ce qui bouge, et de combien.</translation>
    </message>
    <message>
        <source>Click on the liver where the tool is to touch it.</source>
        <translation>Cliquez sur le foie à l’endroit que l’instrument doit toucher.</translation>
    </message>
    <message>
        <source>Tool placed in %1 ms.</source>
        <translation>Instrument placé en&#xa0;%1 ms.</translation>
    </message>
    <message>
        <source>Orders of steps</source>
        <translation>Ordres des étapes</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ReportView</name>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Show the patient&apos;s name</source>
        <translation>Montrer le nom du patient</translation>
    </message>
    <message>
        <source>Without it the page names neither the patient nor the case; see the settings too</source>
        <translation>Sans cela, la page ne nomme ni le patient ni le cas&#xa0;; voir aussi les réglages</translation>
    </message>
    <message>
        <source>Collect again</source>
        <translation>Rassembler à nouveau</translation>
    </message>
    <message>
        <source>Reads the case and the present rehearsal anew</source>
        <translation>Relit le cas et la répétition en cours</translation>
    </message>
    <message>
        <source>Save as a web page...</source>
        <translation>Enregistrer comme page web…</translation>
    </message>
    <message>
        <source>Print to PDF...</source>
        <translation>Imprimer en PDF…</translation>
    </message>
    <message>
        <source>All that was done for this patient on one page.</source>
        <translation>Tout ce qui a été fait pour ce patient, sur une page.</translation>
    </message>
    <message>
        <source>Needs a case: open one, or the demo patient.</source>
        <translation>Il faut un cas&#xa0;: ouvrez-en un, ou le patient de démonstration.</translation>
    </message>
    <message>
        <source>Collecting the report</source>
        <translation>Rassemblement du rapport</translation>
    </message>
    <message>
        <source>Open a case, or the demo patient, to see its page.</source>
        <translation>Ouvrez un cas, ou le patient de démonstration, pour voir sa page.</translation>
    </message>
    <message>
        <source>The page is being collected.</source>
        <translation>La page est en cours de rassemblement.</translation>
    </message>
    <message>
        <source>Something has changed since this page was collected.</source>
        <translation>Quelque chose a changé depuis que cette page a été rassemblée.</translation>
    </message>
    <message>
        <source>Collected from the case and from what is being rehearsed now.</source>
        <translation>Rassemblé à partir du cas et de ce qui est répété en ce moment.</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Pages web (*.html)</translation>
    </message>
    <message>
        <source>The report is in %1</source>
        <translation>Le rapport est dans %1</translation>
    </message>
    <message>
        <source>Print the report</source>
        <translation>Imprimer le rapport</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>With what can be worn</source>
        <translation>Avec ce qui peut être porté</translation>
    </message>
    <message>
        <source>Adds which wearable computers can do this case, as planned in Platform</source>
        <translation>Ajoute quels ordinateurs portés peuvent traiter ce cas, comme prévu dans Plateforme</translation>
    </message>
    <message>
        <source>The planned cut.</source>
        <translation>La coupe planifiée.</translation>
    </message>
    <message>
        <source>The patient as shown in the window.</source>
        <translation>Le patient tel que la fenêtre le montre.</translation>
    </message>
    <message>
        <source>Transverse</source>
        <translation>Transversale</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronale</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittale</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ResectPanel</name>
    <message>
        <source>Plan a resection</source>
        <translation>Planifier une résection</translation>
    </message>
    <message>
        <source>Needs a model of the liver. Build it first, or open the demo patient.</source>
        <translation>Il faut un modèle du foie. Construisez-le d’abord, ou ouvrez le patient de démonstration.</translation>
    </message>
    <message>
        <source>Resect</source>
        <translation>Résection</translation>
    </message>
    <message>
        <source>Set a cut: what goes, what stays, how near the tumours it passes.</source>
        <translation>Poser une section&#xa0;: ce qui part, ce qui reste, à quelle distance des tumeurs elle passe.</translation>
    </message>
    <message>
        <source>Draws the part that is removed away from the rest</source>
        <translation>Écarte du reste la partie qui est retirée</translation>
    </message>
    <message>
        <source>Remove the other part</source>
        <translation>Retirer l’autre partie</translation>
    </message>
    <message>
        <source>No cut</source>
        <translation>Aucune section</translation>
    </message>
    <message>
        <source>The three places lie almost on one line. Click three others.</source>
        <translation>Les trois endroits sont presque alignés. Cliquez-en trois autres.</translation>
    </message>
    <message>
        <source>Click three places on the liver or in the slices.</source>
        <translation>Cliquez trois endroits sur le foie ou dans les coupes.</translation>
    </message>
    <message>
        <source>Click on the liver or in the slices where the cut is to pass.</source>
        <translation>Cliquez sur le foie ou dans les coupes, là où doit passer la section.</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Retiré</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Reste</translation>
    </message>
    <message>
        <source>Set three or more points where the cut is to pass: on the liver, or in the slices.</source>
        <translation>Posez trois points ou plus là où doit passer la section&#xa0;: sur le foie ou dans les coupes.</translation>
    </message>
    <message>
        <source>Click three places through which the plane is to pass.</source>
        <translation>Cliquez trois endroits par lesquels le plan doit passer.</translation>
    </message>
    <message>
        <source>Planning...</source>
        <translation>Planification…</translation>
    </message>
    <message>
        <source>Put the crosshair where the cut is to pass, then the plane through it. Drag its line in a slice to shift it, a line&apos;s end to tilt it.</source>
        <translation>Placez le réticule là où doit passer la section, puis le plan par ce point. Tirez sa ligne dans une coupe pour le décaler, une extrémité de la ligne pour l’incliner.</translation>
    </message>
    <message>
        <source>Separation</source>
        <translation>Écartement</translation>
    </message>
    <message>
        <source>On the liver as the tool holds it</source>
        <translation>Sur le foie tel que l&apos;outil le tient</translation>
    </message>
    <message>
        <source>The cut lies on the liver held aside; the slices show the scan, at rest.</source>
        <translation>La coupe porte sur le foie écarté ; les plans montrent l&apos;examen, au repos.</translation>
    </message>
    <message>
        <source>Margins, widths and places are those on the liver under the tool of Rehearse; volumes are at rest</source>
        <translation>Marges, largeurs et lieux sont ceux du foie sous l&apos;outil de Répéter ; les volumes sont au repos</translation>
    </message>
    <message>
        <source>Place a tool in Rehearse first: a patch at small deformations that the model bears, not a rigid tool.</source>
        <translation>Placez d’abord un instrument dans Répéter : une surface aux petites déformations que le modèle supporte, pas un instrument rigide.</translation>
    </message>
    <message>
        <source>Draw a line over the liver in the 3D view.</source>
        <translation>Tracez une ligne sur le foie dans la vue 3D.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ResectionResults</name>
    <message>
        <source>removed</source>
        <translation>retiré</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>reste</translation>
    </message>
    <message>
        <source>cut through</source>
        <translation>sectionné</translation>
    </message>
    <message>
        <source>▲ R1: cut through</source>
        <translation>▲ R1&#xa0;: sectionné</translation>
    </message>
    <message>
        <source>▲ Stays in the patient</source>
        <translation>▲ Reste dans le patient</translation>
    </message>
    <message>
        <source>▲ R1: under 1 mm</source>
        <translation>▲ R1&#xa0;: moins de 1 mm</translation>
    </message>
    <message>
        <source>● Under 5 mm</source>
        <translation>● Moins de 5 mm</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Marges</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Smallest distance to the cut inside the liver</source>
        <translation>Plus petite distance à la section à l’intérieur du foie</translation>
    </message>
    <message>
        <source>R1: a margin under 1 mm counts as tumour at the edge. Under 5 mm is narrow.</source>
        <translation>R1&#xa0;: une marge inférieure à 1 mm compte comme tumeur au bord. Moins de 5 mm, c’est étroit.</translation>
    </message>
    <message>
        <source>Vessels crossed</source>
        <translation>Vaisseaux croisés</translation>
    </message>
    <message>
        <source>Vessel</source>
        <translation>Vaisseau</translation>
    </message>
    <message>
        <source>Diameter, mm</source>
        <translation>Diamètre, mm</translation>
    </message>
    <message>
        <source>The cut crosses no vessel that was outlined.</source>
        <translation>La section ne croise aucun vaisseau délimité.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 ml&lt;/b&gt; removed (%2 %)</source>
        <translation>&lt;b&gt;%1 ml&lt;/b&gt; retirés (%2 %)</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 ml&lt;/b&gt; stay (%2 %)</source>
        <translation>&lt;b&gt;%1 ml&lt;/b&gt; restent (%2 %)</translation>
    </message>
    <message>
        <source>Caution</source>
        <translation>Attention</translation>
    </message>
    <message>
        <source>With the tool %1 goes by %2 mm; its margin there is %3 mm.</source>
        <translation>Avec l&apos;outil, %1 se déplace de %2 mm ; sa marge y est de %3 mm.</translation>
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
        <translation>%1, large de %2 mm</translation>
    </message>
    <message>
        <source>In a tumour</source>
        <translation>Dans une tumeur</translation>
    </message>
    <message>
        <source>No tumour within %1 mm</source>
        <translation>Aucune tumeur à moins de %1 mm</translation>
    </message>
    <message>
        <source>%1 mm from a tumour</source>
        <translation>à %1 mm d’une tumeur</translation>
    </message>
    <message>
        <source>tumour</source>
        <translation>tumeur</translation>
    </message>
    <message>
        <source>under %1 mm</source>
        <translation>moins de %1 mm</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>○ portal, □ hepatic vein cut; ◇ artery, △ bile duct</source>
        <translation>○ veine porte, □ veine hépatique coupée ; ◇ artère, △ voie biliaire</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SegmentPanel</name>
    <message>
        <source>Segment</source>
        <translation>Segmenter</translation>
    </message>
    <message>
        <source>Outline the liver, its vessels and its tumours.</source>
        <translation>Délimiter le foie, ses vaisseaux et ses tumeurs.</translation>
    </message>
    <message>
        <source>Needs a case: open one, or import images.</source>
        <translation>Il faut un cas&#xa0;: ouvrez-en un ou importez des images.</translation>
    </message>
    <message>
        <source>Needs anatomical images: import them in Study.</source>
        <translation>Il faut des images anatomiques&#xa0;: importez-les dans Étude.</translation>
    </message>
    <message>
        <source>Nothing changed.</source>
        <translation>Rien n’a changé.</translation>
    </message>
    <message>
        <source>Reading the structures</source>
        <translation>Lecture des structures</translation>
    </message>
    <message>
        <source>Another name...</source>
        <translation>Autre nom…</translation>
    </message>
    <message>
        <source>Name of the structure</source>
        <translation>Nom de la structure</translation>
    </message>
    <message>
        <source>Letters, digits and hyphens:</source>
        <translation>Lettres, chiffres et traits d’union&#xa0;:</translation>
    </message>
    <message>
        <source>Choose a structure first, or add one.</source>
        <translation>Choisissez d’abord une structure, ou ajoutez-en une.</translation>
    </message>
    <message>
        <source>Click into the structure first, in any slice.</source>
        <translation>Cliquez d’abord dans la structure, sur n’importe quelle coupe.</translation>
    </message>
    <message>
        <source>Replaces the outline by the tissue around the points</source>
        <translation>Remplace le contour par le tissu autour des points</translation>
    </message>
    <message>
        <source>Click into the tissue, away from large vessels. Points so far: %1</source>
        <translation>Cliquez dans le tissu, loin des gros vaisseaux. Points jusqu’ici&#xa0;: %1</translation>
    </message>
    <message>
        <source>Choose a tool to draw in the slices. Without one, clicks move the crosshair.</source>
        <translation>Choisissez un outil pour dessiner dans les coupes. Sans outil, les clics déplacent le réticule.</translation>
    </message>
    <message>
        <source>Growing: %1</source>
        <translation>Croissance&#xa0;: %1</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Structures</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>The chosen one is drawn on. The box shows or hides it.</source>
        <translation>On dessine sur celle qui est choisie. La case l’affiche ou la masque.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>A new, empty structure</source>
        <translation>Une nouvelle structure, vide</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Another name, and with it another colour, for the chosen structure</source>
        <translation>Un autre nom, et avec lui une autre couleur, pour la structure choisie</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Takes the chosen structure out of the case; Ctrl+Z brings it back</source>
        <translation>Retire la structure choisie du cas&#xa0;; Ctrl+Z la ramène</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>Réticule</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Gomme</translation>
    </message>
    <message>
        <source>Smart brush</source>
        <translation>Pinceau sélectif</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Ciseaux</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Croissance</translation>
    </message>
    <message>
        <source>Pick piece</source>
        <translation>Choisir un morceau</translation>
    </message>
    <message>
        <source>Clicks move the crosshair</source>
        <translation>Les clics déplacent le réticule</translation>
    </message>
    <message>
        <source>Drag to add. Ctrl: erase instead. Shift+wheel: radius in mm</source>
        <translation>Glisser pour ajouter. Ctrl&#xa0;: effacer. Maj+molette&#xa0;: rayon en mm</translation>
    </message>
    <message>
        <source>Drag to take away. Ctrl: add instead. Shift+wheel: radius in mm</source>
        <translation>Glisser pour enlever. Ctrl&#xa0;: ajouter. Maj+molette&#xa0;: rayon en mm</translation>
    </message>
    <message>
        <source>Adds only where the grey values are like those under the click</source>
        <translation>N’ajoute que là où les niveaux de gris ressemblent à ceux sous le clic</translation>
    </message>
    <message>
        <source>Draw around something, and cut away what is inside or outside</source>
        <translation>Entourer quelque chose et enlever ce qui est à l’intérieur ou à l’extérieur</translation>
    </message>
    <message>
        <source>%1 (key %2)</source>
        <translation>%1 (touche %2)</translation>
    </message>
    <message>
        <source>Radius (Shift+wheel)</source>
        <translation>Rayon (Maj+molette)</translation>
    </message>
    <message>
        <source>Radius of the brush in mm</source>
        <translation>Rayon du pinceau en mm</translation>
    </message>
    <message>
        <source>Disc in this slice</source>
        <translation>Disque dans cette coupe</translation>
    </message>
    <message>
        <source>Ball through the slices</source>
        <translation>Boule à travers les coupes</translation>
    </message>
    <message>
        <source>Whether the brush reaches into the neighbouring slices</source>
        <translation>Si le pinceau atteint les coupes voisines</translation>
    </message>
    <message>
        <source>Tolerance (standard deviations)</source>
        <translation>Tolérance (écarts-types)</translation>
    </message>
    <message>
        <source>How far a grey value may be from that under the click, in standard deviations around it</source>
        <translation>Écart permis d’un niveau de gris à celui sous le clic, en écarts-types autour de lui</translation>
    </message>
    <message>
        <source>Cut away what is inside</source>
        <translation>Enlever ce qui est à l’intérieur</translation>
    </message>
    <message>
        <source>Cut away what is outside</source>
        <translation>Enlever ce qui est à l’extérieur</translation>
    </message>
    <message>
        <source>In this slice only</source>
        <translation>Dans cette coupe seulement</translation>
    </message>
    <message>
        <source>Through all slices</source>
        <translation>À travers toutes les coupes</translation>
    </message>
    <message>
        <source>Forget the points</source>
        <translation>Oublier les points</translation>
    </message>
    <message>
        <source>The whole structure</source>
        <translation>La structure entière</translation>
    </message>
    <message>
        <source>Fill between slices</source>
        <translation>Remplir entre les coupes</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Combler les trous</translation>
    </message>
    <message>
        <source>Keep the largest</source>
        <translation>Garder le plus grand</translation>
    </message>
    <message>
        <source>Remove pieces below</source>
        <translation>Supprimer les morceaux sous</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <source>Grow by</source>
        <translation>Élargir de</translation>
    </message>
    <message>
        <source>Shrink by</source>
        <translation>Rétrécir de</translation>
    </message>
    <message>
        <source>Fills the slices between drawn ones by their shapes</source>
        <translation>Remplit les coupes entre celles dessinées d’après leurs formes</translation>
    </message>
    <message>
        <source>Fills what is enclosed on all sides</source>
        <translation>Comble ce qui est entièrement entouré</translation>
    </message>
    <message>
        <source>Keeps the largest piece and drops the others</source>
        <translation>Garde le plus grand morceau et supprime les autres</translation>
    </message>
    <message>
        <source>Drops pieces of less than this volume in ml</source>
        <translation>Supprime les morceaux de volume inférieur à celui-ci, en ml</translation>
    </message>
    <message>
        <source>Rounds what is smaller than about this many mm</source>
        <translation>Arrondit ce qui est plus petit qu’environ ce nombre de mm</translation>
    </message>
    <message>
        <source>Adds a margin of this many mm all around</source>
        <translation>Ajoute tout autour une marge de ce nombre de mm</translation>
    </message>
    <message>
        <source>Takes a margin of this many mm away all around</source>
        <translation>Enlève tout autour une marge de ce nombre de mm</translation>
    </message>
    <message>
        <source>Transverse</source>
        <translation>Transversale</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronale</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittale</translation>
    </message>
    <message>
        <source>The slices that were drawn in</source>
        <translation>Les coupes dans lesquelles on a dessiné</translation>
    </message>
    <message>
        <source>Least volume in ml</source>
        <translation>Volume minimal en ml</translation>
    </message>
    <message>
        <source>Radius of smoothing in mm</source>
        <translation>Rayon du lissage en mm</translation>
    </message>
    <message>
        <source>Margin in mm</source>
        <translation>Marge en mm</translation>
    </message>
    <message>
        <source>So far to both sides</source>
        <translation>De chaque côté, de</translation>
    </message>
    <message>
        <source>This slice and all towards you</source>
        <translation>Cette coupe et toutes celles devant</translation>
    </message>
    <message>
        <source>This slice and all behind it</source>
        <translation>Cette coupe et toutes celles derrière</translation>
    </message>
    <message>
        <source>How deep the scissors cut along your line of sight, in tilted slices too</source>
        <translation>Profondeur de la coupe des ciseaux le long de votre regard, dans les coupes inclinées aussi</translation>
    </message>
    <message>
        <source>How far the scissors cut before and behind this slice, in mm</source>
        <translation>Distance de coupe des ciseaux devant et derrière cette coupe, en mm</translation>
    </message>
    <message>
        <source>Click into the middle of it. Points so far: %1</source>
        <translation>Cliquez au milieu. Points jusqu&apos;ici : %1</translation>
    </message>
    <message>
        <source>Outline with another program...</source>
        <translation>Tracer par un autre programme...</translation>
    </message>
    <message>
        <source>Outline with another program</source>
        <translation>Tracer par un autre programme</translation>
    </message>
    <message>
        <source>Its command, as in TotalSegmentator -i {image} -o {folder}
(kept in Settings):</source>
        <translation>Sa commande, comme dans TotalSegmentator -i {image} -o {folder}
(gardée dans les réglages) :</translation>
    </message>
    <message>
        <source>Outlining with another program</source>
        <translation>Un autre programme trace les contours</translation>
    </message>
    <message>
        <source>Click on the piece that is to stay; all others go. Ctrl and click: the part under the pointer goes, from where it is narrowest.</source>
        <translation>Cliquez sur le morceau à garder ; les autres disparaissent. Ctrl et clic : la partie sous le pointeur disparaît, à partir de l&apos;endroit le plus étroit.</translation>
    </message>
    <message>
        <source>Click on the piece that is to stay; all others go. Ctrl: takes off the part under the pointer</source>
        <translation>Cliquez sur le morceau à garder ; les autres disparaissent. Ctrl : retire la partie sous le pointeur</translation>
    </message>
    <message>
        <source>Outline the liver first.</source>
        <translation>Délimitez d’abord le foie.</translation>
    </message>
    <message>
        <source>Replaces the outline by all that is shaped like a vessel in the liver</source>
        <translation>Remplace le contour par tout ce qui, dans le foie, a la forme d’un vaisseau</translation>
    </message>
    <message>
        <source>Replaces the outline by the vessels in the liver that hang on the points</source>
        <translation>Remplace le contour par les vaisseaux du foie reliés aux points</translation>
    </message>
    <message>
        <source>Click into the vessel where it stands out best, or let all vessels be found. Points so far: %1</source>
        <translation>Cliquez dans le vaisseau là où il se détache le mieux, ou faites trouver tous les vaisseaux. Points : %1</translation>
    </message>
    <message>
        <source>Finding vessels: %1</source>
        <translation>Recherche des vaisseaux : %1</translation>
    </message>
    <message>
        <source>Click points into the tissue, then let the structure grow over what looks alike; vessels are found without</source>
        <translation>Cliquez des points dans le tissu, puis laissez la structure croître sur ce qui lui ressemble ; les vaisseaux se trouvent aussi sans</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Trouver</translation>
    </message>
    <message>
        <source>Replaces the outline by the liver that brightness and shape show; it needs no point</source>
        <translation>Remplace le contour par le foie que montrent la luminosité et la forme ; aucun point n&apos;est nécessaire</translation>
    </message>
    <message>
        <source>Finding: %1</source>
        <translation>Recherche : %1</translation>
    </message>
    <message>
        <source>Points outside count for Find alone.</source>
        <translation>Les points extérieurs ne comptent que pour « Trouver ».</translation>
    </message>
    <message>
        <source>Click into the liver, away from large vessels; Ctrl and click into what is wrongly taken for it. A click on a point takes it away. Points so far: %1 inside, %2 outside</source>
        <translation>Cliquez dans le foie, loin des gros vaisseaux ; avec Ctrl, dans ce qui est pris à tort pour lui. Un clic sur un point l’enlève. Points jusqu’ici : %1 à l’intérieur, %2 à l’extérieur</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SequenceReportView</name>
    <message>
        <source>Calibration: read; the eyes are %1 mm apart.</source>
        <translation>Calibrage : lu ; les yeux sont à %1 mm l&apos;un de l&apos;autre.</translation>
    </message>
    <message>
        <source>Calibration: reprojection error %1 px; the board is seen in %2 of %3 pairs; the eyes are %4 mm apart.</source>
        <translation>Calibrage : erreur de reprojection %1 px ; la mire se voit dans %2 paires sur %3 ; les yeux sont à %4 mm l&apos;un de l&apos;autre.</translation>
    </message>
    <message>
        <source>Landmarks tracked: %1.</source>
        <translation>Repères suivis : %1.</translation>
    </message>
    <message>
        <source>Landmarks tracked: %1; they agree within %2 mm once all frames are aligned.</source>
        <translation>Repères suivis : %1 ; ils concordent à %2 mm près une fois toutes les images alignées.</translation>
    </message>
    <message>
        <source>Most pairs do not show the board: check its kind, its columns and its rows.</source>
        <translation>La plupart des paires ne montrent pas la mire : vérifiez son genre, ses colonnes et ses lignes.</translation>
    </message>
    <message>
        <source>More than 1 px: the board may not be flat, or it moved between the two eyes.</source>
        <translation>Plus de 1 px : la mire n&apos;est peut-être pas plane, ou elle a bougé entre les deux yeux.</translation>
    </message>
    <message>
        <source>The eyes of a laparoscope are about 5 mm apart: is the board&apos;s size right?</source>
        <translation>Les yeux d&apos;un laparoscope sont à environ 5 mm l&apos;un de l&apos;autre : la taille de la mire est-elle juste ?</translation>
    </message>
    <message>
        <source>The eyes of a laparoscope are about 5 mm apart: is the calibration in mm?</source>
        <translation>Les yeux d&apos;un laparoscope sont à environ 5 mm l&apos;un de l&apos;autre : le calibrage est-il en mm ?</translation>
    </message>
    <message>
        <source>The calibration&apos;s middle lies far from the pictures&apos; middle: is it of this size?</source>
        <translation>Le milieu du calibrage est loin de celui des images : vaut-il pour cette taille ?</translation>
    </message>
    <message>
        <source>Frames left out because they show hardly anything in depth: %1.</source>
        <translation>Images laissées de côté parce qu&apos;elles ne montrent presque rien en profondeur : %1.</translation>
    </message>
    <message>
        <source>What comes on the way</source>
        <translation>Ce qui vient en chemin</translation>
    </message>
    <message>
        <source>Here you will see how well the camera is calibrated, how much of each pair of pictures is seen in depth, and how many landmarks are followed. Then the sequence is opened.</source>
        <translation>Vous verrez ici si la caméra est bien calibrée, quelle part de chaque paire d&apos;images est vue en profondeur et combien de repères sont suivis. Ensuite la séquence s&apos;ouvre.</translation>
    </message>
    <message>
        <source>A frame beside its depths</source>
        <translation>Une image à côté de ses profondeurs</translation>
    </message>
    <message>
        <source>First pair, frame %1: points %2; %3 % of what can be seen.</source>
        <translation>Première paire, image %1 : points %2 ; %3 % de ce qui peut se voir.</translation>
    </message>
    <message>
        <source>Frames: %1, with %2 points each on average; %3 % of what can be seen.</source>
        <translation>Images : %1, avec %2 points chacune en moyenne ; %3 % de ce qui peut se voir.</translation>
    </message>
    <message>
        <source>Frame %1: points %2; %3 % of what can be seen; landmarks known from before: %4.</source>
        <translation>Image %1 : points %2 ; %3 % de ce qui peut se voir ; repères déjà connus : %4.</translation>
    </message>
    <message>
        <source>Kept in %1.</source>
        <translation>Conservée dans %1.</translation>
    </message>
    <message>
        <source>Rectified left picture; beside it what is seen in depth, near places bright.</source>
        <translation>Image gauche rectifiée ; à côté ce qui est vu en profondeur, le proche en clair.</translation>
    </message>
    <message>
        <source>Made from the video.</source>
        <translation>Créée à partir de la vidéo.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SeriesTable</name>
    <message>
        <source>Series</source>
        <translation>Série</translation>
    </message>
    <message>
        <source>Size and spacing</source>
        <translation>Taille et espacement</translation>
    </message>
    <message>
        <source>Use as</source>
        <translation>Utiliser comme</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>Anatomy</source>
        <translation>Anatomie</translation>
    </message>
    <message>
        <source>Stiffness (kPa)</source>
        <translation>Rigidité (kPa)</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Confiance</translation>
    </message>
    <message>
        <source>MRE magnitude</source>
        <translation>Magnitude ERM</translation>
    </message>
    <message>
        <source>MRE phase</source>
        <translation>Phase ERM</translation>
    </message>
    <message>
        <source>MRE waves</source>
        <translation>Ondes ERM</translation>
    </message>
    <message>
        <source>Segmentation</source>
        <translation>Segmentation</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Écarter</translation>
    </message>
    <message>
        <source>Without a description</source>
        <translation>Sans description</translation>
    </message>
    <message>
        <source>%1 volumes</source>
        <translation>%1 volumes</translation>
    </message>
    <message>
        <source>Use %1 as</source>
        <translation>Utiliser %1 comme</translation>
    </message>
    <message>
        <source>What this series is for. The proposal is read from its header.</source>
        <translation>À quoi sert cette série. La proposition est lue dans son en-tête.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SettingsWindow</name>
    <message>
        <source>Settings - Glisson</source>
        <translation>Réglages - Glisson</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Apparence</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>System language</source>
        <translation>Langue du système</translation>
    </message>
    <message>
        <source>&amp;Processors</source>
        <translation>&amp;Processeurs</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Les %1</translation>
    </message>
    <message>
        <source>How many processors long computations may take</source>
        <translation>Combien de processeurs les longs calculs peuvent utiliser</translation>
    </message>
    <message>
        <source>&amp;Patients&apos; names in what leaves this window</source>
        <translation>Noms des &amp;patients dans ce qui quitte cette fenêtre</translation>
    </message>
    <message>
        <source>Pictures, movies and reports name a patient only then. The log never does.</source>
        <translation>Images, films et rapports ne nomment un patient que dans ce cas. Le journal ne le fait jamais.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>&amp;Outlining program</source>
        <translation>Programme de c&amp;ontours</translation>
    </message>
    <message>
        <source>Its &amp;values</source>
        <translation>Ses &amp;valeurs</translation>
    </message>
    <message>
        <source>A program of yours that outlines organs, for Segment (Add). {image} stands for the images of the case and {folder} for where its label maps go. Values are named only where its files do not say what they are.</source>
        <translation>Un programme à vous qui trace les contours d’organes, pour Segmenter (Ajouter). {image} désigne les images du cas et {folder} l’endroit où vont ses cartes d’étiquettes. Les valeurs ne sont nommées que là où ses fichiers ne disent pas ce qu’elles sont.</translation>
    </message>
    <message>
        <source>As in: %1</source>
        <translation>Comme dans : %1</translation>
    </message>
    <message>
        <source>Livers&apos; &amp;shapes</source>
        <translation>&amp;Formes de foie</translation>
    </message>
    <message>
        <source>A shape model&apos;s file, by which Segment finds the liver; without one, a simulated liver&apos;s shape</source>
        <translation>Le fichier d&apos;un modèle de forme avec lequel Segmenter trouve le foie ; sans lui, la forme d&apos;un foie simulé</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ShortcutsWindow</name>
    <message>
        <source>Keys - Glisson</source>
        <translation>Touches - Glisson</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Words to search for</source>
        <translation>Mots à chercher</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Ce qu’elle fait</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Touche</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SliceTools</name>
    <message>
        <source>Choose a structure first, or add one.</source>
        <translation>Choisissez d’abord une structure, ou ajoutez-en une.</translation>
    </message>
    <message>
        <source>One moment: the last change is being worked off.</source>
        <translation>Un instant&#xa0;: la dernière modification est en cours.</translation>
    </message>
    <message>
        <source>Points outside count for the liver alone.</source>
        <translation>Les points extérieurs ne comptent que pour le foie.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::SolvingLight</name>
    <message>
        <source>○ No tool</source>
        <translation>○ Aucun instrument</translation>
    </message>
    <message>
        <source>◐ Solving</source>
        <translation>◐ Résolution</translation>
    </message>
    <message>
        <source>▲ Not to be used</source>
        <translation>▲ Inutilisable</translation>
    </message>
    <message>
        <source>✔ Solved</source>
        <translation>✔ Résolu</translation>
    </message>
    <message>
        <source>✖ Not solved</source>
        <translation>✖ Non résolu</translation>
    </message>
    <message>
        <source>❚❚ Frozen</source>
        <translation>❚❚ Figé</translation>
    </message>
    <message>
        <source>What is shown is from before.</source>
        <translation>Ce qui est montré est l’état précédent.</translation>
    </message>
    <message>
        <source>▲ Outside of the model</source>
        <translation>▲ Hors du modèle</translation>
    </message>
    <message>
        <source>Use less force.</source>
        <translation>Utilisez moins de force.</translation>
    </message>
    <message>
        <source>solved in %1 ms · drawn in %2 ms</source>
        <translation>résolu en %1 ms · dessiné en %2 ms</translation>
    </message>
    <message>
        <source>Residual %1: how far the equations are from balance</source>
        <translation>Résidu %1&#xa0;: l’écart des équations à l’équilibre</translation>
    </message>
    <message>
        <source>An estimate, which holds for slow tools; past 0.5 mm the picture is said to be settling</source>
        <translation>Une estimation, valable pour des instruments lents ; au-delà de 0.5 mm, il est dit que l’image se stabilise</translation>
    </message>
    <message>
        <source>◐ Preparing</source>
        <translation>◐ En préparation</translation>
    </message>
    <message>
        <source>◐ Settling</source>
        <translation>◐ Se stabilise</translation>
    </message>
    <message>
        <source>▲ Not at rest</source>
        <translation>▲ Pas au repos</translation>
    </message>
    <message>
        <source>Landmarks are within %1 mm of rest</source>
        <translation>Les repères sont à %1 mm du repos au plus</translation>
    </message>
    <message>
        <source>This picture is not at rest, and the liver may slip farther than is shown. Press less, or move the tool a little.</source>
        <translation>Cette image n’est pas au repos, et le foie peut glisser plus loin qu’il n’est montré. Appuyez moins, ou déplacez un peu l’instrument.</translation>
    </message>
    <message>
        <source>◐ Moving</source>
        <translation>◐ En mouvement</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StatusLine</name>
    <message>
        <source>about %1 s left</source>
        <translation>encore %1 s environ</translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation>encore %1 min environ</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Not a medical device</source>
        <translation>N’est pas un dispositif médical</translation>
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
        <translation>Déformation et contrainte mesurées</translation>
    </message>
    <message>
        <source>strain, %</source>
        <translation>déformation, %</translation>
    </message>
    <message>
        <source>stress, kPa</source>
        <translation>contrainte, kPa</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StructureOperations</name>
    <message>
        <source>Choose a structure first, or add one.</source>
        <translation>Choisissez d&apos;abord une structure, ou ajoutez-en une.</translation>
    </message>
    <message>
        <source>Replaces the structure by the voxels of these grey values</source>
        <translation>Remplace la structure par les voxels de ces valeurs de gris</translation>
    </message>
    <message>
        <source>There is no other structure.</source>
        <translation>Il n&apos;y a pas d&apos;autre structure.</translation>
    </message>
    <message>
        <source>Changes the chosen structure; the other one stays as it is</source>
        <translation>Modifie la structure choisie ; l&apos;autre reste telle quelle</translation>
    </message>
    <message>
        <source>Grey values and other structures</source>
        <translation>Valeurs de gris et autres structures</translation>
    </message>
    <message>
        <source>Grey values from, to</source>
        <translation>Valeurs de gris de, à</translation>
    </message>
    <message>
        <source>Lowest grey value</source>
        <translation>Valeur de gris la plus basse</translation>
    </message>
    <message>
        <source>Highest grey value</source>
        <translation>Valeur de gris la plus haute</translation>
    </message>
    <message>
        <source>As here</source>
        <translation>Comme ici</translation>
    </message>
    <message>
        <source>Takes the grey values that are like those under the crosshair</source>
        <translation>Prend les valeurs de gris semblables à celles sous le réticule</translation>
    </message>
    <message>
        <source>Take these</source>
        <translation>Les prendre</translation>
    </message>
    <message>
        <source>The brush draws on these only</source>
        <translation>Le pinceau ne dessine que sur celles-ci</translation>
    </message>
    <message>
        <source>Inside of</source>
        <translation>À l&apos;intérieur de</translation>
    </message>
    <message>
        <source>the whole image</source>
        <translation>toute l&apos;image</translation>
    </message>
    <message>
        <source>Structure to stay inside of</source>
        <translation>Structure où rester</translation>
    </message>
    <message>
        <source>Grow and Take these stay inside of this structure</source>
        <translation>Croissance et Les prendre restent dans cette structure</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Keep what is also in</source>
        <translation>Garder ce qui est aussi dans</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>What to do with the other structure</source>
        <translation>Que faire avec l&apos;autre structure</translation>
    </message>
    <message>
        <source>The other structure</source>
        <translation>L&apos;autre structure</translation>
    </message>
    <message>
        <source>Do it</source>
        <translation>Appliquer</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StudiesPage</name>
    <message>
        <source>Studies</source>
        <translation>Études</translation>
    </message>
    <message>
        <source>Run the dissertation&apos;s studies over many patients, and follow them.</source>
        <translation>Exécuter les études de la thèse sur de nombreux patients, et les suivre.</translation>
    </message>
    <message>
        <source>Of the patients in</source>
        <translation>Des patients dans</translation>
    </message>
    <message>
        <source>Of the case</source>
        <translation>Du cas</translation>
    </message>
    <message>
        <source>Of the livers in</source>
        <translation>Des foies dans</translation>
    </message>
    <message>
        <source>Of the scans in</source>
        <translation>Des numérisations dans</translation>
    </message>
    <message>
        <source>No folder: simulated patients</source>
        <translation>Sans dossier : patients simulés</translation>
    </message>
    <message>
        <source>Open a case, or choose one</source>
        <translation>Ouvrez un cas ou choisissez-en un</translation>
    </message>
    <message>
        <source>Choose a folder of label maps</source>
        <translation>Choisissez un dossier de cartes d’étiquettes</translation>
    </message>
    <message>
        <source>No folder: simulated scans</source>
        <translation>Sans dossier : numérisations simulées</translation>
    </message>
    <message>
        <source>The folder with the patients or scans, or a case</source>
        <translation>Le dossier des patients ou des numérisations, ou un cas</translation>
    </message>
    <message>
        <source>The folder for the results</source>
        <translation>Le dossier des résultats</translation>
    </message>
    <message>
        <source>The folder that a study is written to</source>
        <translation>Le dossier dans lequel une étude est écrite</translation>
    </message>
    <message>
        <source>Patients done: %1</source>
        <translation>Patients faits : %1</translation>
    </message>
    <message>
        <source>Could not be used: %1</source>
        <translation>Inutilisables : %1</translation>
    </message>
    <message>
        <source>Start a study, or follow a folder that another program fills.</source>
        <translation>Commencez une étude, ou suivez un dossier qu’un autre programme remplit.</translation>
    </message>
    <message>
        <source>Stopping...</source>
        <translation>Arrêt...</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Fait.</translation>
    </message>
    <message>
        <source>Stopped. Started again, it goes on from there.</source>
        <translation>Arrêtée. Recommencée, elle reprend de là.</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Choisir...</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Without a folder</source>
        <translation>Sans dossier</translation>
    </message>
    <message>
        <source>Simulated patients</source>
        <translation>Patients simulés</translation>
    </message>
    <message>
        <source>Results go to</source>
        <translation>Les résultats vont dans</translation>
    </message>
    <message>
        <source>A folder. What lies there from an earlier run of the same study is not computed again.</source>
        <translation>Un dossier. Ce qui s’y trouve d’une exécution antérieure de la même étude n’est pas recalculé.</translation>
    </message>
    <message>
        <source>...</source>
        <translation>...</translation>
    </message>
    <message>
        <source>Choose the folder for the results</source>
        <translation>Choisir le dossier des résultats</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Commencer</translation>
    </message>
    <message>
        <source>Runs beside the window; closing the window stops it. Started again, it goes on.</source>
        <translation>Tourne à côté de la fenêtre ; la fermer l’arrête. Recommencée, elle continue.</translation>
    </message>
    <message>
        <source>Follow a folder...</source>
        <translation>Suivre un dossier...</translation>
    </message>
    <message>
        <source>Shows what another program, or a cluster, writes to a study&apos;s folder</source>
        <translation>Montre ce qu’un autre programme, ou une grappe, écrit dans le dossier d’une étude</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>What is done stays</source>
        <translation>Ce qui est fait reste</translation>
    </message>
    <message>
        <source>Open the page</source>
        <translation>Ouvrir la page</translation>
    </message>
    <message>
        <source>The study&apos;s report, in the browser</source>
        <translation>Le rapport de l’étude, dans le navigateur</translation>
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
        <translation>Étude</translation>
    </message>
    <message>
        <source>Find images, say what each series is for, and see what the case holds.</source>
        <translation>Trouver des images, dire à quoi sert chaque série et voir ce que contient le cas.</translation>
    </message>
    <message>
        <source>Looking for images</source>
        <translation>Recherche d’images</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Look in a folder...</source>
        <translation>Chercher dans un dossier…</translation>
    </message>
    <message>
        <source>A folder, a DICOMDIR or one file; dropping it on the window does the same</source>
        <translation>Un dossier, un DICOMDIR ou un fichier&#xa0;; le déposer sur la fenêtre fait de même</translation>
    </message>
    <message>
        <source>Keep the case as</source>
        <translation>Conserver le cas sous</translation>
    </message>
    <message>
        <source>Make a case</source>
        <translation>Créer un cas</translation>
    </message>
    <message>
        <source>Add to the open case</source>
        <translation>Ajouter au cas ouvert</translation>
    </message>
    <message>
        <source>Drop a folder of DICOM images, a DICOMDIR, or a NIfTI, NRRD or MHA file here.</source>
        <translation>Déposez ici un dossier d’images DICOM, un DICOMDIR ou un fichier NIfTI, NRRD ou MHA.</translation>
    </message>
    <message>
        <source>%1: series found: %2</source>
        <translation>%1&#xa0;: séries trouvées&#xa0;: %2</translation>
    </message>
    <message>
        <source>; files left out: %1</source>
        <translation>; fichiers écartés&#xa0;: %1</translation>
    </message>
    <message>
        <source>Give at least one series a role first.</source>
        <translation>Donnez d’abord un rôle à au moins une série.</translation>
    </message>
    <message>
        <source>There is something of that name already: choose another.</source>
        <translation>Il existe déjà quelque chose de ce nom&#xa0;: choisissez-en un autre.</translation>
    </message>
    <message>
        <source>Copies the chosen series into a new case</source>
        <translation>Copie les séries choisies dans un nouveau cas</translation>
    </message>
    <message>
        <source>No case is open.</source>
        <translation>Aucun cas n’est ouvert.</translation>
    </message>
    <message>
        <source>Patients&apos; names are neither shown nor kept: a case keeps a hash of them. The images are never written to.</source>
        <translation>Les noms des patients ne sont ni montrés ni gardés : un cas n&apos;en garde qu&apos;une empreinte. Rien n&apos;est jamais écrit dans les images.</translation>
    </message>
    <message>
        <source>Labels need the images that they were drawn on: give one series another role.</source>
        <translation>Les étiquettes ont besoin des images sur lesquelles elles ont été dessinées : donnez un autre rôle à une série.</translation>
    </message>
    <message>
        <source>Glisson asks before anything is replaced; Ctrl+Z brings it back</source>
        <translation>Glisson demande avant de remplacer quoi que ce soit ; Ctrl+Z le ramène</translation>
    </message>
    <message>
        <source>Open images: a folder, or a file of them</source>
        <translation>Ouvrir des images : un dossier, ou un de leurs fichiers</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StudyPanel</name>
    <message>
        <source>Slices show</source>
        <translation>Les coupes montrent</translation>
    </message>
    <message>
        <source>Anatomy</source>
        <translation>Anatomie</translation>
    </message>
    <message>
        <source>Stiffness (MR elastography)</source>
        <translation>Rigidité (élastographie par RM)</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Structures</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>No patient open</source>
        <translation>Aucun patient ouvert</translation>
    </message>
    <message>
        <source>%1 cells
Young&apos;s modulus %2 kPa (mean)</source>
        <translation>%1 cellules
Module de Young&#xa0;%2 kPa (moyenne)</translation>
    </message>
    <message>
        <source>%1 voxels,
%2 each</source>
        <translation>%1 voxels,
de %2 chacun</translation>
    </message>
    <message>
        <source>%1 cells
Young&apos;s modulus %2 kPa (assumed)</source>
        <translation>%1 cellules
Module de Young %2 kPa (supposé)</translation>
    </message>
    <message>
        <source>%1 (fixed)</source>
        <translation>%1 (fixe)</translation>
    </message>
    <message>
        <source>No part of the model: drawn where it was outlined, it does not move.</source>
        <translation>Ne fait pas partie du modèle : dessiné là où il a été délimité, il ne bouge pas.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::StudyRun</name>
    <message>
        <source>%1 could not be started: it belongs beside this program. Install Glisson again.</source>
        <translation>%1 n’a pas pu être lancé : il doit se trouver à côté de ce programme. Réinstallez Glisson.</translation>
    </message>
    <message>
        <source>The study ended without saying why. Start it again.</source>
        <translation>L’étude s’est terminée sans dire pourquoi. Recommencez-la.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TakingIn</name>
    <message>
        <source>Looking at the labels</source>
        <translation>Examen des étiquettes</translation>
    </message>
    <message>
        <source>The case %1 has an anatomy already. These images would replace it; what was outlined and modelled on it then no longer fits.</source>
        <translation>Le cas %1 a déjà une anatomie. Ces images la remplaceraient ; ce qui y a été contouré et modélisé ne conviendrait plus.</translation>
    </message>
    <message>
        <source>Replace the anatomy?</source>
        <translation>Remplacer l&apos;anatomie ?</translation>
    </message>
    <message>
        <source>Is it this patient?</source>
        <translation>Est-ce bien ce patient ?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Add all the same</source>
        <translation>Ajouter malgré tout</translation>
    </message>
    <message>
        <source>Importing</source>
        <translation>Importation</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TargetTable</name>
    <message>
        <source>What is drawn, and how far it may be off</source>
        <translation>Ce qui est dessiné, et de combien il peut être écarté</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
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
        <translation>Écart type de chaque coordonnée de l&apos;erreur, mm : le plus grand de la structure</translation>
    </message>
    <message>
        <source>90 of 100 such places are off by this at most, mm: 2.5 sd</source>
        <translation>90 de ces points sur 100 sont à cette distance au plus, mm : 2.5 σ</translation>
    </message>
    <message>
        <source>How far its nearest place lies behind the liver&apos;s front, along the line of sight, mm</source>
        <translation>À quelle distance son point le plus proche est derrière l&apos;avant du foie, dans l&apos;axe de vue, mm</translation>
    </message>
    <message>
        <source>Do not trust it at %1 mm</source>
        <translation>Ne pas s&apos;y fier à %1 mm</translation>
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
        <translation>Lire</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Une image en arrière</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>Une image en avant</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>No frames</source>
        <translation>Aucune image</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Image %1 sur %2</translation>
    </message>
    <message>
        <source>Open a sequence first</source>
        <translation>Ouvrez d’abord une séquence</translation>
    </message>
    <message>
        <source>Plays the video at 15 frames a second, round and round (Space)</source>
        <translation>Lit la vidéo à 15 images par seconde, en boucle (Espace)</translation>
    </message>
    <message>
        <source>One frame back (Left)</source>
        <translation>Une image en arrière (Gauche)</translation>
    </message>
    <message>
        <source>One frame on (Right)</source>
        <translation>Une image en avant (Droite)</translation>
    </message>
    <message>
        <source>The frame that is shown (Left, Right, Page Up, Page Down, Home, End)</source>
        <translation>L’image affichée (Gauche, Droite, Page préc., Page suiv., Début, Fin)</translation>
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
        <translation>Direction</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>Place by click</source>
        <translation>Placer d’un clic</translation>
    </message>
    <message>
        <source>Then click on the liver where the tool is to touch it. By key: Ctrl+T, at the crosshair</source>
        <translation>Cliquez ensuite sur le foie à l’endroit que l’instrument doit toucher. Au clavier&#xa0;: Ctrl+T, au réticule</translation>
    </message>
    <message>
        <source>Hoist segment VI</source>
        <translation>Soulever le segment VI</translation>
    </message>
    <message>
        <source>Puts the tool under the right, lower, rear part of the liver, lifting it to the front and the head</source>
        <translation>Place l’instrument sous la partie droite, inférieure et postérieure du foie, en la soulevant vers l’avant et la tête</translation>
    </message>
    <message>
        <source>Hoist to front and head</source>
        <translation>Soulever vers l’avant et la tête</translation>
    </message>
    <message>
        <source>Pull away from the surface</source>
        <translation>Tirer loin de la surface</translation>
    </message>
    <message>
        <source>Push into the surface</source>
        <translation>Appuyer sur la surface</translation>
    </message>
    <message>
        <source>As the arrow was dragged</source>
        <translation>Comme la flèche a été tirée</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Touch with the rigid tool itself</source>
        <translation>Toucher avec l’instrument rigide lui-même</translation>
    </message>
    <message>
        <source>The tool&apos;s solid in contact with the liver, and several tools at once. Otherwise the force is spread over a patch.</source>
        <translation>Le solide de l’instrument au contact du foie, et plusieurs instruments à la fois. Sinon, la force est répartie sur une surface.</translation>
    </message>
    <message>
        <source>Several tools at once need rigid tools</source>
        <translation>Plusieurs instruments à la fois ne sont possibles qu’avec des instruments rigides</translation>
    </message>
    <message>
        <source>Take the tool away</source>
        <translation>Retirer l’instrument</translation>
    </message>
    <message>
        <source>From %1 N on, strains are outside of the model</source>
        <translation>Dès %1 N, les déformations sont hors du modèle</translation>
    </message>
    <message>
        <source>Add another tool</source>
        <translation>Ajouter un autre instrument</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TourCard</name>
    <message>
        <source>End the tour</source>
        <translation>Terminer la visite</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TracePlot</name>
    <message>
        <source>Time (s)</source>
        <translation>Temps (s)</translation>
    </message>
    <message>
        <source>Power (W)</source>
        <translation>Puissance (W)</translation>
    </message>
    <message>
        <source>Power; shaded: a run</source>
        <translation>Puissance ; grisé : un passage</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>Repos</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TraceView</name>
    <message>
        <source>Close the recording</source>
        <translation>Fermer l&apos;enregistrement</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Puissance</translation>
    </message>
    <message>
        <source>Watts per unit</source>
        <translation>Watts par unité</translation>
    </message>
    <message>
        <source>1 where the column holds watts, 0.001 for milliwatts; for a current clamp its amperes per volt times the supply&apos;s voltage. Negative turns the sign.</source>
        <translation>1 si la colonne contient des watts, 0.001 pour des milliwatts ; pour une pince ampèremétrique, ses ampères par volt fois la tension d&apos;alimentation. Négatif inverse le signe.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>rows, one a second</source>
        <translation>lignes, une par seconde</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>colonne %1</translation>
    </message>
    <message>
        <source>Plan with it</source>
        <translation>Planifier avec</translation>
    </message>
    <message>
        <source>Plan with it as %1</source>
        <translation>Planifier avec comme %1</translation>
    </message>
    <message>
        <source>Adds that platform once more, with the idle and active power of this recording</source>
        <translation>Ajoute cette plateforme une fois de plus, avec la puissance au repos et en charge de cet enregistrement</translation>
    </message>
    <message>
        <source>Idle %1 W, the median of the pauses. Under load %2 W more, the median of the runs (there are %3).</source>
        <translation>Au repos %1 W, la médiane des pauses. En charge %2 W de plus, la médiane des passages (il y en a %3).</translation>
    </message>
    <message>
        <source>%1 W on average, from %2 to %3 W.</source>
        <translation>%1 W en moyenne, de %2 à %3 W.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TrackControls</name>
    <message>
        <source>❚❚ Freeze</source>
        <translation>❚❚ Figer</translation>
    </message>
    <message>
        <source>Nothing moves the tool while you look around</source>
        <translation>Rien ne déplace l’instrument pendant que vous regardez</translation>
    </message>
    <message>
        <source>▶ Play</source>
        <translation>▶ Lire</translation>
    </message>
    <message>
        <source>Shows again what was done, from where the time stands; rests are cut to 1 s</source>
        <translation>Montre à nouveau ce qui a été fait, à partir du temps choisi&#xa0;; les pauses sont réduites à 1 s</translation>
    </message>
    <message>
        <source>Any moment of this rehearsal, in seconds</source>
        <translation>N’importe quel moment de cette répétition, en secondes</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Table...</source>
        <translation>Tableau…</translation>
    </message>
    <message>
        <source>Saves every moment as CSV: tools, forces (N), landmarks (mm)</source>
        <translation>Enregistre chaque moment en CSV&#xa0;: instruments, forces (N), repères (mm)</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Oublier</translation>
    </message>
    <message>
        <source>Forgets what was done so far; the tool stays</source>
        <translation>Oublie ce qui a été fait jusqu’ici&#xa0;; l’instrument reste</translation>
    </message>
    <message>
        <source>Stop (%1 %)</source>
        <translation>Arrêter (%1 %)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>Save a movie of the rehearsal</source>
        <translation>Enregistrer un film de la répétition</translation>
    </message>
    <message>
        <source>Movies (*.mp4);;Folder of pictures (*)</source>
        <translation>Films (*.mp4);;Dossier d’images (*)</translation>
    </message>
    <message>
        <source>Save the rehearsal as a table</source>
        <translation>Enregistrer la répétition dans un tableau</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 sur %2 s</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>A movie of what the 3D view shows, MP4 or pictures</source>
        <translation>Un film de ce que montre la vue 3D&#xa0;: MP4 ou images</translation>
    </message>
    <message>
        <source>Move a tool first: there is nothing to show yet</source>
        <translation>Déplacez d’abord un instrument&#xa0;: il n’y a encore rien à montrer</translation>
    </message>
    <message>
        <source>Movie...</source>
        <translation>Film…</translation>
    </message>
    <message>
        <source>Stopped. No movie was written.</source>
        <translation>Arrêté. Aucun film n’a été écrit.</translation>
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
        <translation>Écart de l’atlas</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>5 mm</source>
        <translation>5 mm</translation>
    </message>
    <message>
        <source>Moves at most</source>
        <translation>Déplacement maximal</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TriangleHistory</name>
    <message>
        <source>A triangle over the frames</source>
        <translation>Un triangle au fil des images</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Triangle</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>The triangle of the left picture whose history is drawn; or click one in a picture</source>
        <translation>Le triangle de l’image de gauche dont l’évolution est tracée&#xa0;; ou cliquez-en un dans une image</translation>
    </message>
    <message>
        <source>Error (mm)</source>
        <translation>Erreur (mm)</translation>
    </message>
    <message>
        <source>Motion (mm)</source>
        <translation>Mouvement (mm)</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>The chosen triangle over the frames</source>
        <translation>Le triangle choisi au fil des images</translation>
    </message>
    <message>
        <source>Left: how far the registered corners are from where they are on the model, mm, with the tolerance as a dash-dotted line. Right: what SIRGn&apos;s correlation compares, the motion of the landmarks and of the registration&apos;s warp, mm</source>
        <translation>À gauche&#xa0;: distance des sommets recalés à leur place sur le modèle, mm, avec la tolérance en trait mixte. À droite&#xa0;: ce que compare la corrélation de SIRGn, le mouvement des repères et celui de la déformation du recalage, mm</translation>
    </message>
    <message>
        <source>Landmarks, %1</source>
        <translation>Repères, %1</translation>
    </message>
    <message>
        <source>Warp, %1</source>
        <translation>Déformation, %1</translation>
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
        <translation>Chaque image de tout le recalage. À gauche&#xa0;: la distance des repères recalés à leur place sur le modèle, mm, avec la tolérance en trait mixte. À droite&#xa0;: la distance du nuage recalé au modèle (moyenne quadratique), mm</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::TwoStageControls</name>
    <message>
        <source>Embolised</source>
        <translation>Embolisée</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>The rest grows</source>
        <translation>Le reste croît</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>By how much what keeps its portal inflow grows until the cut. On average it was 37.9 % in 44 studies (van Lienden et al. 2013), less in a cirrhotic liver</source>
        <translation>De combien croît, jusqu’à la section, ce qui garde son apport porte. En moyenne 37.9 % dans 44 études (van Lienden et al. 2013), moins dans un foie cirrhotique</translation>
    </message>
    <message>
        <source>%1 ml lose their portal inflow and shrink.</source>
        <translation>%1 ml perdent leur apport porte et rétrécissent.</translation>
    </message>
    <message>
        <source>%1 ml of what stays grow to &lt;b&gt;%2 ml&lt;/b&gt;: %3 % of the liver without tumours, %4 % now.</source>
        <translation>%1 ml de ce qui reste croissent à &lt;b&gt;%2 ml&lt;/b&gt; : %3 % du foie sans tumeurs, %4 % maintenant.</translation>
    </message>
    <message>
        <source>▲ %1 ml of the embolised tissue stay in the patient and are not counted.</source>
        <translation>▲ %1 ml du tissu embolisé restent dans le patient et ne sont pas comptés.</translation>
    </message>
    <message>
        <source>An estimate by the growth above, not a forecast.</source>
        <translation>Une estimation selon la croissance ci-dessus, pas une prévision.</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::Undo</name>
    <message>
        <source>Undone: %1</source>
        <translation>Annulé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>Rétabli&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rétablir&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::UnsurePlaces</name>
    <message>
        <source>Next unsure place</source>
        <translation>Endroit incertain suivant</translation>
    </message>
    <message>
        <source>Where is it unsure?</source>
        <translation>Où est-ce incertain ?</translation>
    </message>
    <message>
        <source>Goes to where the chosen outline lies on tissue that looks alike on both sides, as towards the heart</source>
        <translation>Va là où le contour choisi passe dans un tissu d&apos;aspect semblable des deux côtés, comme vers le cœur</translation>
    </message>
    <message>
        <source>Looking along the border...</source>
        <translation>Parcours du bord...</translation>
    </message>
    <message>
        <source>%1 % of the border looks alike on both sides. Place %2 of %3 lies under the crosshair: draw it as you see it.</source>
        <translation>%1 % du bord ont le même aspect des deux côtés. L&apos;endroit %2 sur %3 est sous le réticule : dessinez-y ce que vous voyez.</translation>
    </message>
    <message>
        <source>No larger part of the border is unsure (%1 % in all).</source>
        <translation>Aucune grande partie du bord n&apos;est incertaine (%1 % en tout).</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::VesselClick</name>
    <message>
        <source>Lies at the crosshair</source>
        <translation>Est au réticule</translation>
    </message>
    <message>
        <source>Put the crosshair on this vessel, in the middle of its course. Vessels and segments are found again by it</source>
        <translation>Placez le réticule sur ce vaisseau, au milieu de son trajet. Les vaisseaux et les segments sont retrouvés d’après lui</translation>
    </message>
    <message>
        <source>First stands the vessel whose place would tell most of the borders of segments</source>
        <translation>En premier vient le vaisseau dont la place en dirait le plus sur les limites des segments</translation>
    </message>
    <message>
        <source>%1 (%2 ml in doubt)</source>
        <translation>%1 (%2 ml incertains)</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::VideoForm</name>
    <message>
        <source>Video</source>
        <translation>Vidéo</translation>
    </message>
    <message>
        <source>Calibration of the camera</source>
        <translation>Calibrage de la caméra</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>From frame</source>
        <translation>Depuis l&apos;image</translation>
    </message>
    <message>
        <source>One frame in</source>
        <translation>Une sur</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>The first frame that is taken, counted from 1</source>
        <translation>La première image prise, comptée depuis 1</translation>
    </message>
    <message>
        <source>1 takes every frame, 5 every fifth</source>
        <translation>1 prend toutes les images, 5 une sur cinq</translation>
    </message>
    <message>
        <source>So many frames are taken at most; each takes up to a second</source>
        <translation>Autant d&apos;images sont prises au plus ; chacune prend jusqu&apos;à une seconde</translation>
    </message>
    <message>
        <source>Choose the video.</source>
        <translation>Choisissez la vidéo.</translation>
    </message>
    <message>
        <source>Choose the left eye&apos;s video.</source>
        <translation>Choisissez la vidéo de l&apos;œil gauche.</translation>
    </message>
    <message>
        <source>Choose the right eye&apos;s video.</source>
        <translation>Choisissez la vidéo de l&apos;œil droit.</translation>
    </message>
    <message>
        <source>Choose the camera&apos;s calibration.</source>
        <translation>Choisissez le calibrage de la caméra.</translation>
    </message>
    <message>
        <source>Choose the pictures of the board.</source>
        <translation>Choisissez les images de la mire.</translation>
    </message>
    <message>
        <source>Say where to keep the sequence.</source>
        <translation>Dites où conserver la séquence.</translation>
    </message>
    <message>
        <source>A video file, or a folder of its pictures</source>
        <translation>Un fichier vidéo, ou un dossier de ses images</translation>
    </message>
    <message>
        <source>Two videos, one for each eye</source>
        <translation>Deux vidéos, une par œil</translation>
    </message>
    <message>
        <source>One video, left eye on the left</source>
        <translation>Une vidéo, œil gauche à gauche</translation>
    </message>
    <message>
        <source>One video, left eye on the right</source>
        <translation>Une vidéo, œil gauche à droite</translation>
    </message>
    <message>
        <source>One video, left eye above</source>
        <translation>Une vidéo, œil gauche en haut</translation>
    </message>
    <message>
        <source>How the video shows both eyes</source>
        <translation>Comment la vidéo montre les deux yeux</translation>
    </message>
    <message>
        <source>How the video, and the pictures of a board, show both eyes</source>
        <translation>Comment la vidéo et les images d&apos;une mire montrent les deux yeux</translation>
    </message>
    <message>
        <source>Left eye</source>
        <translation>Œil gauche</translation>
    </message>
    <message>
        <source>Right eye</source>
        <translation>Œil droit</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>D&apos;un fichier</translation>
    </message>
    <message>
        <source>From pictures of a board</source>
        <translation>D&apos;images d&apos;une mire</translation>
    </message>
    <message>
        <source>Where the calibration comes from</source>
        <translation>D&apos;où vient le calibrage</translation>
    </message>
    <message>
        <source>Without a calibration, take pictures of a flat board with both eyes, from several sides</source>
        <translation>Sans calibrage, prenez une mire plane avec les deux yeux, de plusieurs côtés</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibrage</translation>
    </message>
    <message>
        <source>JSON, OpenCV&apos;s YAML or XML, or a folder of text files</source>
        <translation>JSON, YAML ou XML d&apos;OpenCV, ou un dossier de fichiers texte</translation>
    </message>
    <message>
        <source>A folder of pictures or a video: the same board, from at least three sides; ten are better</source>
        <translation>Un dossier d&apos;images ou une vidéo : la même mire d&apos;au moins trois côtés ; dix valent mieux</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>Damier</translation>
    </message>
    <message>
        <source>Grid of circles</source>
        <translation>Grille de cercles</translation>
    </message>
    <message>
        <source>Grid of circles, four of them larger</source>
        <translation>Grille de cercles, dont quatre plus grands</translation>
    </message>
    <message>
        <source>Kind of board</source>
        <translation>Genre de mire</translation>
    </message>
    <message>
        <source>What is printed on the board</source>
        <translation>Ce qui est imprimé sur la mire</translation>
    </message>
    <message>
        <source>Inner corners, columns by rows</source>
        <translation>Coins intérieurs, colonnes par lignes</translation>
    </message>
    <message>
        <source>Circles, columns by rows</source>
        <translation>Cercles, colonnes par lignes</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Côté d&apos;une case</translation>
    </message>
    <message>
        <source>From circle to circle</source>
        <translation>D&apos;un cercle à l&apos;autre</translation>
    </message>
    <message>
        <source>Along a row: a board of 10 x 7 squares has 9 x 6 inner corners</source>
        <translation>Une mire de 10 x 7 cases a 9 x 6 coins intérieurs</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Measure it: all lengths of the sequence follow from it</source>
        <translation>Mesurez-le : toutes les longueurs de la séquence en découlent</translation>
    </message>
    <message>
        <source>Keep it in</source>
        <translation>Conserver dans</translation>
    </message>
    <message>
        <source>A new folder for the clouds, tracks and pictures</source>
        <translation>Un nouveau dossier pour les nuages, les trajets et les images</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ViewBar</name>
    <message>
        <source>Measure a &amp;distance</source>
        <translation>Mesurer une &amp;distance</translation>
    </message>
    <message>
        <source>A distance in mm: click its two ends, or press Enter at the crosshair; Escape gives up</source>
        <translation>Une distance en mm&#xa0;: cliquez sur ses deux extrémités, ou appuyez sur Entrée au réticule&#xa0;; Échap annule</translation>
    </message>
    <message>
        <source>Measure an &amp;angle</source>
        <translation>Mesurer un &amp;angle</translation>
    </message>
    <message>
        <source>An angle in degrees: click one side, the vertex, the other side</source>
        <translation>Un angle en degrés&#xa0;: cliquez sur un côté, le sommet, l’autre côté</translation>
    </message>
    <message>
        <source>Measure a &amp;ball</source>
        <translation>Mesurer une &amp;boule</translation>
    </message>
    <message>
        <source>A ball&apos;s volume in ml: click its centre, then a point of its surface</source>
        <translation>Le volume d’une boule en ml&#xa0;: cliquez sur son centre, puis sur un point de sa surface</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Lists the volume of a structure, in ml</source>
        <translation>Ajoute à la liste le volume d’une structure, en ml</translation>
    </message>
    <message>
        <source>&amp;Volume of</source>
        <translation>&amp;Volume de</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Foie</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Poumon</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Os</translation>
    </message>
    <message>
        <source>Brightness and contrast of the slices. The presets are for CT; MR has no fixed scale.
By hand: drag with the right button</source>
        <translation>Luminosité et contraste des coupes. Les préréglages sont pour le scanner&#xa0;; l’IRM n’a pas d’échelle fixe.
À la main&#xa0;: glissez avec le bouton droit</translation>
    </message>
    <message>
        <source>Brightness and contrast</source>
        <translation>Luminosité et contraste</translation>
    </message>
    <message>
        <source>&amp;Next brightness and contrast</source>
        <translation>Luminosité et contraste &amp;suivants</translation>
    </message>
    <message>
        <source>Surgeon&apos;s &amp;side</source>
        <translation>Côté du &amp;chirurgien</translation>
    </message>
    <message>
        <source>Turns the three slices to where the surgeon stands. By hand: drag the knobs of the crosshair, or Ctrl and drag</source>
        <translation>Tourne les trois coupes vers là où se tient le chirurgien. À la main&#xa0;: tirez les poignées du réticule, ou Ctrl et glisser</translation>
    </message>
    <message>
        <source>&amp;Four views</source>
        <translation>&amp;Quatre vues</translation>
    </message>
    <message>
        <source>3D &amp;large</source>
        <translation>3D en &amp;grand</translation>
    </message>
    <message>
        <source>T&amp;hree slices side by side</source>
        <translation>&amp;Trois coupes côte à côte</translation>
    </message>
    <message>
        <source>&amp;One view: the one in use</source>
        <translation>&amp;Une vue&#xa0;: celle utilisée</translation>
    </message>
    <message>
        <source>Save the &amp;picture of the view in use...</source>
        <translation>Enregistrer l’&amp;image de la vue utilisée…</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>What there is no room for here</source>
        <translation>Ce qui ne tient pas ici</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Personnalisé</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>S&amp;tandard planes</source>
        <translation>Plans s&amp;tandard</translation>
    </message>
    <message>
        <source>Transverse, coronal and sagittal slices again</source>
        <translation>De nouveau des coupes transversales, coronales et sagittales</translation>
    </message>
    <message>
        <source>W %1  L %2</source>
        <translation>L %1  N %2</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::ViewFrame</name>
    <message>
        <source>Show all four views</source>
        <translation>Montrer les quatre vues</translation>
    </message>
    <message>
        <source>Fill the window with this view</source>
        <translation>Remplir la fenêtre avec cette vue</translation>
    </message>
    <message>
        <source>Save the picture of this view</source>
        <translation>Enregistrer l’image de cette vue</translation>
    </message>
    <message>
        <source>What there is no room for here</source>
        <translation>Ce qui ne tient pas ici</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::VisibleTable</name>
    <message>
        <source>Effect</source>
        <translation>Effet</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Paramètre</translation>
    </message>
    <message>
        <source>Without effect</source>
        <translation>Sans effet</translation>
    </message>
    <message>
        <source>Seen from</source>
        <translation>Visible à partir de</translation>
    </message>
    <message>
        <source>In nine of ten such experiments an effect of this size is seen</source>
        <translation>Dans neuf expériences de ce genre sur dix, un effet de cette taille se voit</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>at no size</source>
        <translation>à aucune valeur</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::WaveView</name>
    <message>
        <source>Elastography waves</source>
        <translation>Ondes d’élastographie</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>A defect in Glisson stopped this: %1</source>
        <translation>Un défaut de Glisson a interrompu cette opération&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Inverting the waves</source>
        <translation>Inversion des ondes</translation>
    </message>
    <message>
        <source>Saving the maps</source>
        <translation>Enregistrement des cartes</translation>
    </message>
    <message>
        <source>The case now holds this stiffness. Build its model anew to use it.</source>
        <translation>Le cas contient maintenant cette rigidité. Reconstruisez son modèle pour l’utiliser.</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>as the images say</source>
        <translation>selon les images</translation>
    </message>
    <message>
        <source>&amp;Vibration</source>
        <translation>&amp;Vibration</translation>
    </message>
    <message>
        <source>Complex modulus</source>
        <translation>Module complexe</translation>
    </message>
    <message>
        <source>Local wavelength</source>
        <translation>Longueur d’onde locale</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Méthode</translation>
    </message>
    <message>
        <source>High-pass</source>
        <translation>Passe-haut</translation>
    </message>
    <message>
        <source>Curl</source>
        <translation>Rotationnel</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conserver</translation>
    </message>
    <message>
        <source>&amp;Long waves</source>
        <translation>Ondes &amp;longues</translation>
    </message>
    <message>
        <source>Compute the stiffness</source>
        <translation>Calculer la rigidité</translation>
    </message>
    <message>
        <source>Shear waves</source>
        <translation>Ondes de cisaillement</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>Shear stiffness</source>
        <translation>Rigidité en cisaillement</translation>
    </message>
    <message>
        <source>kPa</source>
        <translation>kPa</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Confiance</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Accept into the case</source>
        <translation>Accepter dans le cas</translation>
    </message>
    <message>
        <source>Compute the stiffness from the waves that the case holds.</source>
        <translation>Calculez la rigidité à partir des ondes que contient le cas.</translation>
    </message>
    <message>
        <source>Shear stiffness %1 kPa on average over %2 confident voxels, %3 % of the region; middle half %4 to %5 kPa; vibration %6 Hz, wavelength %7 mm</source>
        <translation>Rigidité en cisaillement de&#xa0;%1 kPa en moyenne sur&#xa0;%2 voxels de confiance,&#xa0;%3&#xa0;% de la région&#xa0;; moitié centrale de&#xa0;%4 à&#xa0;%5 kPa&#xa0;; vibration&#xa0;%6 Hz, longueur d’onde&#xa0;%7 mm</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>Coupe&#xa0;%1 sur&#xa0;%2</translation>
    </message>
</context>
<context>
    <name>glisson::widgets::WelcomePage</name>
    <message>
        <source>Plan a liver operation</source>
        <translation>Planifier une opération du foie</translation>
    </message>
    <message>
        <source>Drop a case or a folder of DICOM images here, or begin with the demo patient.</source>
        <translation>Déposez ici un cas ou un dossier d’images DICOM, ou commencez par le patient de démonstration.</translation>
    </message>
    <message>
        <source>Open the demo patient</source>
        <translation>Ouvrir le patient de démonstration</translation>
    </message>
    <message>
        <source>Open a case...</source>
        <translation>Ouvrir un cas…</translation>
    </message>
    <message>
        <source>Open images...</source>
        <translation>Ouvrir des images…</translation>
    </message>
    <message>
        <source>Opened before</source>
        <translation>Ouverts récemment</translation>
    </message>
    <message>
        <source>Glisson ended unexpectedly. Open %1 as it was</source>
        <translation>Glisson s’est arrêté de façon inattendue. Ouvrir %1 tel qu’il était</translation>
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
        <translation>Recherche</translation>
    </message>
</context>
<context>
    <name>parameters</name>
    <message>
        <source>amplitude</source>
        <translation>amplitude</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>angle</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>axe</translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation>azimut</translation>
    </message>
    <message>
        <source>center</source>
        <translation>centre</translation>
    </message>
    <message>
        <source>coefficient</source>
        <translation>coefficient</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>courbe</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>retard</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>profondeur</translation>
    </message>
    <message>
        <source>efficiency</source>
        <translation>rendement</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>élévation</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>énergie</translation>
    </message>
    <message>
        <source>exponent</source>
        <translation>exposant</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>facteur</translation>
    </message>
    <message>
        <source>faster</source>
        <translation>plus rapide</translation>
    </message>
    <message>
        <source>foundation</source>
        <translation>appui élastique</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>frottement</translation>
    </message>
    <message>
        <source>full load</source>
        <translation>pleine charge</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>gain</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>pesanteur</translation>
    </message>
    <message>
        <source>length scale</source>
        <translation>échelle de longueur</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>limite</translation>
    </message>
    <message>
        <source>loss</source>
        <translation>perte</translation>
    </message>
    <message>
        <source>loss ratio</source>
        <translation>facteur de perte</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>pression</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>rayon</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>rapport</translation>
    </message>
    <message>
        <source>resistance</source>
        <translation>résistance</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>rotation</translation>
    </message>
    <message>
        <source>share</source>
        <translation>part</translation>
    </message>
    <message>
        <source>slip strain</source>
        <translation>déformation de glissement</translation>
    </message>
    <message>
        <source>slower</source>
        <translation>plus lent</translation>
    </message>
    <message>
        <source>static</source>
        <translation>puissance au repos</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>raideur</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>time constant</source>
        <translation>constante de temps</translation>
    </message>
    <message>
        <source>translation</source>
        <translation>translation</translation>
    </message>
    <message>
        <source>viscosity</source>
        <translation>viscosité</translation>
    </message>
    <message>
        <source>zero</source>
        <translation>zéro</translation>
    </message>
</context>
<context>
    <name>patients</name>
    <message>
        <source>Demo patient</source>
        <translation>Patient de démonstration</translation>
    </message>
</context>
<context>
    <name>structures</name>
    <message>
        <source>Liver</source>
        <translation>Foie</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumeur</translation>
    </message>
    <message>
        <source>Cyst</source>
        <translation>Kyste</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Veine porte</translation>
    </message>
    <message>
        <source>Hepatic vein</source>
        <translation>Veine hépatique</translation>
    </message>
    <message>
        <source>Artery</source>
        <translation>Artère</translation>
    </message>
    <message>
        <source>Biliary tract</source>
        <translation>Voies biliaires</translation>
    </message>
    <message>
        <source>Necrosis</source>
        <translation>Nécrose</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Vésicule biliaire</translation>
    </message>
    <message>
        <source>Gastric vein</source>
        <translation>Veine gastrique</translation>
    </message>
    <message>
        <source>Aorta</source>
        <translation>Aorte</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Cœur</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Estomac</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Rein</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Pancreas</source>
        <translation>Pancréas</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Os</translation>
    </message>
    <message>
        <source>Hilum</source>
        <translation>Hile hépatique</translation>
    </message>
    <message>
        <source>Vena cava</source>
        <translation>Veine cave</translation>
    </message>
    <message>
        <source>Duodenum</source>
        <translation>Duodénum</translation>
    </message>
    <message>
        <source>Small bowel</source>
        <translation>Intestin grêle</translation>
    </message>
    <message>
        <source>Colon</source>
        <translation>Côlon</translation>
    </message>
    <message>
        <source>Esophagus</source>
        <translation>Œsophage</translation>
    </message>
    <message>
        <source>Adrenal gland</source>
        <translation>Glande surrénale</translation>
    </message>
    <message>
        <source>Kidney left</source>
        <translation>Rein gauche</translation>
    </message>
    <message>
        <source>Kidney right</source>
        <translation>Rein droit</translation>
    </message>
    <message>
        <source>Adrenal gland left</source>
        <translation>Glande surrénale gauche</translation>
    </message>
    <message>
        <source>Adrenal gland right</source>
        <translation>Glande surrénale droite</translation>
    </message>
    <message>
        <source>Planned cut</source>
        <translation>Coupe prévue</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segments</translation>
    </message>
</context>
<context>
    <name>studies</name>
    <message>
        <source>Landmarks under an atlas</source>
        <translation>Repères sous un atlas</translation>
    </message>
    <message>
        <source>How far a liver of one published stiffness misplaces a retracted liver&apos;s places, patient by patient (section 4.4).</source>
        <translation>De combien un foie d’une rigidité publiée déplace les lieux d’un foie rétracté, patient par patient (section 4.4).</translation>
    </message>
    <message>
        <source>Stiffness of a cohort</source>
        <translation>Rigidité d’une cohorte</translation>
    </message>
    <message>
        <source>How stiffness varies between patients and within one, against the atlas (section 4.3).</source>
        <translation>Comment la rigidité varie entre patients et chez un seul, face à l’atlas (section 4.3).</translation>
    </message>
    <message>
        <source>Beams of one liver</source>
        <translation>Poutres d’un foie</translation>
    </message>
    <message>
        <source>Beams of a case&apos;s softest, stiffest and most uneven tissue against one of its mean (table 4.1).</source>
        <translation>Poutres du tissu le plus mou, le plus rigide et le plus inégal d’un cas face à une de sa moyenne (tableau 4.1).</translation>
    </message>
    <message>
        <source>Shapes of livers</source>
        <translation>Formes de foies</translation>
    </message>
    <message>
        <source>A mean liver and its modes, from a folder of segmented livers, judged on livers left out.</source>
        <translation>Un foie moyen et ses modes, d’un dossier de foies segmentés, jugé sur des foies laissés de côté.</translation>
    </message>
    <message>
        <source>Pressed phantoms</source>
        <translation>Fantômes pressés</translation>
    </message>
    <message>
        <source>Silicone pressed by a tool: the simulated surface against the scanned one (section 4.5). Without scans, SIMULATED ones.</source>
        <translation>Silicone pressé par un outil : la surface simulée face à la numérisée (section 4.5). Sans numérisations, des SIMULÉES.</translation>
    </message>
    <message>
        <source>Stiffness against a testing machine</source>
        <translation>Rigidité face à une machine d’essai</translation>
    </message>
    <message>
        <source>Young&apos;s modulus by elastography beside a testing machine&apos;s, by the dissertation&apos;s own figures (section 4.6).</source>
        <translation>Module de Young par élastographie à côté de celui d’une machine d’essai, d’après les chiffres de la thèse (section 4.6).</translation>
    </message>
    <message>
        <source>Error against resolution</source>
        <translation>Erreur selon la résolution</translation>
    </message>
    <message>
        <source>How much of a beam&apos;s deflection a coarse model misses (section 6.3.2): what Platform plans by.</source>
        <translation>Combien de la flèche d’une poutre échappe à un modèle grossier (section 6.3.2) : ce d’après quoi Plateforme planifie.</translation>
    </message>
    <message>
        <source>Matching of shapes</source>
        <translation>Appariement de formes</translation>
    </message>
    <message>
        <source>Energy, bits, memory and time of matching two surfaces (chapter 3), on SIMULATED livers.</source>
        <translation>Énergie, bits, mémoire et temps de l’appariement de deux surfaces (chapitre 3), sur des foies SIMULÉS.</translation>
    </message>
    <message>
        <source>Data in place of a law</source>
        <translation>Des données à la place d’une loi</translation>
    </message>
    <message>
        <source>A SIMULATED liver retracted straight from measured strain and stress, beside lines fitted to them (chapter 5).</source>
        <translation>Un foie SIMULÉ, rétracté directement d’après des déformations et contraintes mesurées, à côté de droites ajustées (chapitre 5).</translation>
    </message>
</context>
<context>
    <name>tour</name>
    <message>
        <source>Study: the images</source>
        <translation>Étude&#xa0;: les images</translation>
    </message>
    <message>
        <source>Every case begins with its images. Drop a DICOM folder on the window: Glisson proposes what each series is for, and you correct it. Here you also see what a case still lacks.</source>
        <translation>Tout cas commence par ses images. Déposez un dossier DICOM sur la fenêtre&#xa0;: Glisson propose à quoi sert chaque série, et vous corrigez. Vous voyez aussi ici ce qui manque encore à un cas.</translation>
    </message>
    <message>
        <source>Segment: what is where</source>
        <translation>Segmenter&#xa0;: où se trouve quoi</translation>
    </message>
    <message>
        <source>The liver, its vessels and tumours as coloured outlines in the slices. Paint, erase, grow and smooth; every step can be undone, even after the case was closed.</source>
        <translation>Le foie, ses vaisseaux et ses tumeurs en contours colorés sur les coupes. Peindre, effacer, faire croître et lisser&#xa0;; chaque pas peut être annulé, même après la fermeture du cas.</translation>
    </message>
    <message>
        <source>Model: how stiff each part is</source>
        <translation>Modèle&#xa0;: la rigidité de chaque partie</translation>
    </message>
    <message>
        <source>The liver becomes tetrahedra, and each gets the patient&apos;s own stiffness from MR elastography. What holds the liver in place is shown too.</source>
        <translation>Le foie devient un ensemble de tétraèdres, et chacun reçoit la rigidité propre du patient, tirée de l’élastographie par RM. Ce qui tient le foie en place est montré aussi.</translation>
    </message>
    <message>
        <source>Rehearse: pull, and see</source>
        <translation>Répéter&#xa0;: tirer et voir</translation>
    </message>
    <message>
        <source>Resect: what is left</source>
        <translation>Résection&#xa0;: ce qui reste</translation>
    </message>
    <message>
        <source>A cutting surface divides the liver: volumes of specimen and remnant, the smallest margin to each tumour, and the vessels that are crossed.</source>
        <translation>Une surface de coupe divise le foie&#xa0;: volumes de la pièce et du foie restant, plus petite marge à chaque tumeur, et vaisseaux traversés.</translation>
    </message>
    <message>
        <source>Register: can the overlay be trusted</source>
        <translation>Recaler&#xa0;: peut-on se fier à la superposition&#xa0;?</translation>
    </message>
    <message>
        <source>Laparoscopic video is registered to the model, and SIRGn shows on each triangle how well, for one algorithm or two side by side.</source>
        <translation>La vidéo laparoscopique est recalée sur le modèle, et SIRGn montre sur chaque triangle avec quelle qualité, pour un algorithme ou deux côte à côte.</translation>
    </message>
    <message>
        <source>Platform: what to wear</source>
        <translation>Plateforme&#xa0;: que porter</translation>
    </message>
    <message>
        <source>Which wearable computer carries this case for as long as the operation takes: frames a second, battery and heat, and why the others do not.</source>
        <translation>Quel ordinateur porté sur soi suffit à ce cas pendant toute l’opération&#xa0;: images par seconde, batterie et chaleur, et pourquoi les autres ne suffisent pas.</translation>
    </message>
    <message>
        <source>Evidence: where the model is wrong</source>
        <translation>Constats&#xa0;: là où le modèle se trompe</translation>
    </message>
    <message>
        <source>Measurements are held against the model. What it cannot explain is traced to a cause; you accept that cause for this patient, and can take it back.</source>
        <translation>Les mesures sont confrontées au modèle. Ce qu’il ne peut expliquer est ramené à une cause&#xa0;; vous l’acceptez pour ce patient, et pouvez revenir en arrière.</translation>
    </message>
    <message>
        <source>Report: one page</source>
        <translation>Rapport&#xa0;: une page</translation>
    </message>
    <message>
        <source>All that was done for this patient, to read, save or print. The name is masked unless you ask for it in the settings.</source>
        <translation>Tout ce qui a été fait pour ce patient, à lire, enregistrer ou imprimer. Le nom est masqué, sauf demande dans les réglages.</translation>
    </message>
    <message>
        <source>A retractor hoists segment VI. Change the force, or place the tool elsewhere by a click: the table follows each tumour and vessel, and marks what is 5 mm or more off.</source>
        <translation>Un écarteur soulève le segment VI. Changez la force, ou placez l’instrument ailleurs d’un clic : le tableau suit chaque tumeur et chaque vaisseau, et marque ce qui s’écarte de 5 mm ou plus.</translation>
    </message>
    <message>
        <source>Guide: where the tumour is now</source>
        <translation>Guider : où est la tumeur maintenant</translation>
    </message>
    <message>
        <source>The liver is found on the frames of a laparoscope&apos;s video and follows them. Tumours and vessels are drawn where they lie, dashed where they are not to be trusted.</source>
        <translation>Le foie est trouvé sur les images d&apos;un laparoscope et les suit. Tumeurs et vaisseaux sont dessinés là où ils sont, en tireté là où il ne faut pas s&apos;y fier.</translation>
    </message>
</context>
<context>
    <name>vessels</name>
    <message>
        <source>Portal vein</source>
        <translation>Veine porte</translation>
    </message>
    <message>
        <source>Hepatic vein</source>
        <translation>Veine hépatique</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>médiane</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>antérieure</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>postérieure</translation>
    </message>
    <message>
        <source>lateral</source>
        <translation>latérale</translation>
    </message>
    <message>
        <source>medial</source>
        <translation>médiale</translation>
    </message>
    <message>
        <source>caudate</source>
        <translation>caudée</translation>
    </message>
    <message>
        <source>stem</source>
        <translation>tronc</translation>
    </message>
    <message>
        <source>Middle hepatic vein</source>
        <translation>Veine hépatique moyenne</translation>
    </message>
    <message>
        <source>Right hepatic vein</source>
        <translation>Veine hépatique droite</translation>
    </message>
    <message>
        <source>Umbilical portion of the left portal vein</source>
        <translation>Portion ombilicale de la veine porte gauche</translation>
    </message>
    <message>
        <source>Left hepatic vein</source>
        <translation>Veine hépatique gauche</translation>
    </message>
    <message>
        <source>Hepatic artery</source>
        <translation>Artère hépatique</translation>
    </message>
    <message>
        <source>Bile duct</source>
        <translation>Voie biliaire</translation>
    </message>
    <message>
        <source>outside the liver</source>
        <translation>hors du foie</translation>
    </message>
</context>
</TS>
