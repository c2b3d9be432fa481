<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>AverageWords</name>
    <message numerus="yes">
        <source>Mean of %n buttons</source>
        <translation>
            <numerusform>Mittel von %n Taster</numerusform>
            <numerusform>Mittel von %n Tastern</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Mean of %n buttons.</source>
        <translation>
            <numerusform>Mittel von %n Taster.</numerusform>
            <numerusform>Mittel von %n Tastern.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 (one button only).</source>
        <translation>%1: %2 (nur ein Taster).</translation>
    </message>
    <message>
        <source>%1: %2 ± %3.</source>
        <translation>%1: %2 ± %3.</translation>
    </message>
    <message>
        <source>Outlier: %1.</source>
        <translation>Ausreißer: %1.</translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message>
        <source>release</source>
        <translation>Rückweg</translation>
    </message>
    <message>
        <source>press</source>
        <translation>Hinweg</translation>
    </message>
    <message>
        <source>The release lies %1 above the press at %2. Are press and release swapped?</source>
        <translation>Der Rückweg liegt bei %2 um %1 über dem Hinweg. Sind Hin- und Rückweg vertauscht?</translation>
    </message>
    <message>
        <source>The release begins at %1, but the press ends at %3 (%2 apart).</source>
        <translation>Der Rückweg beginnt bei %1, der Hinweg endet aber bei %3 (Abstand %2).</translation>
    </message>
    <message>
        <source>There is no release curve; the press curve is used instead.</source>
        <translation>Es gibt keine Rückwegkurve; stattdessen gilt die Hinwegkurve.</translation>
    </message>
    <message>
        <source>The %1 force falls to %2 at %3; a negative force would pull the finger down.</source>
        <translation>Die Kraft auf dem %1 fällt bei %3 auf %2; eine negative Kraft zöge den Finger nach unten.</translation>
    </message>
    <message>
        <source>The press begins with a falling force; the button has no stable rest position.</source>
        <translation>Der Hinweg beginnt mit fallender Kraft; der Taster hat keine stabile Ruhelage.</translation>
    </message>
    <message>
        <source>The tactile point of the %1 at %2 lies inside an earlier jump, so the finger never feels it.</source>
        <translation>Der Druckpunkt auf dem %1 bei %2 liegt in einem früheren Sprung, der Finger fühlt ihn daher nie.</translation>
    </message>
    <message>
        <source>The reset point at %1 lies deeper than the operating point at %2.</source>
        <translation>Der Rückschaltpunkt bei %1 liegt tiefer als der Schaltpunkt bei %2.</translation>
    </message>
    <message>
        <source>The release ends at %1, but the next state starts at %3 (%2 apart).</source>
        <translation>Der Rückweg endet bei %1, der nächste Zustand beginnt aber bei %3 (Abstand %2).</translation>
    </message>
    <message>
        <source>A damping point lies at %1, but the travel ends at %2.</source>
        <translation>Bei %1 liegt ein Dämpfungspunkt, der Weg endet aber bei %2.</translation>
    </message>
    <message>
        <source>The %1 curve has %2 points, too many to edit by hand. Refit the curve with fewer pieces.</source>
        <translation>Die Kurve „%1“ hat %2 Kurvenpunkte, zu viele zum Bearbeiten von Hand. Passen Sie die Kurve mit weniger Stücken neu an.</translation>
    </message>
    <message>
        <source>The confidence of the import is only %1 %. Compare the curves with the page.</source>
        <translation>Die Sicherheit des Imports beträgt nur %1 %. Vergleichen Sie die Kurven mit der Seite.</translation>
    </message>
    <message>
        <source>Total travel</source>
        <translation>Gesamtweg</translation>
    </message>
    <message>
        <source>Pre-travel</source>
        <translation>Vorlaufweg</translation>
    </message>
    <message>
        <source>Operating force</source>
        <translation>Betätigungskraft</translation>
    </message>
    <message>
        <source>Force at the end</source>
        <translation>Kraft am Ende</translation>
    </message>
    <message>
        <source>State %1: %2</source>
        <translation>Zustand %1: %2</translation>
    </message>
    <message>
        <source> (%1 to %2)</source>
        <translation> (%1 bis %2)</translation>
    </message>
    <message>
        <source>%1: the datasheet states %2, the graph has %3.</source>
        <translation>%1: Im Datenblatt steht %2, im Graphen %3.</translation>
    </message>
    <message>
        <source>At %4, the release at %1 mm/s lies %2 above the press at %3 mm/s: the button would return more energy than it took up.</source>
        <translation>Bei %4 liegt der Rückweg mit %1 mm/s um %2 über dem Hinweg mit %3 mm/s: Der Taster gäbe mehr Energie ab, als er aufnahm.</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Spitzenkraft</translation>
    </message>
</context>
<context>
    <name>Differences</name>
    <message>
        <source>snap ratio</source>
        <translation>Schnappverhältnis</translation>
    </message>
    <message>
        <source>force at rest</source>
        <translation>Kraft in Ruhe</translation>
    </message>
    <message>
        <source>largest force</source>
        <translation>größte Kraft</translation>
    </message>
    <message>
        <source>initial slope</source>
        <translation>Anfangssteigung</translation>
    </message>
    <message>
        <source>tactile points</source>
        <translation>Druckpunkte</translation>
    </message>
    <message>
        <source>work</source>
        <translation>Arbeit</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Hinweg</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Rückweg</translation>
    </message>
    <message>
        <source>%1: the curves differ by %2 % of the first button&apos;s force range on average and by %3 % at most (up to %4 %5, %6 %7)</source>
        <translation>%1: Die Kurven unterscheiden sich im Mittel um %2 % des Kraftbereichs des ersten Tasters, höchstens um %3 % (bis zu %4 %5, %6 %7)</translation>
    </message>
    <message>
        <source>peak travel</source>
        <translation>Weg der Spitze</translation>
    </message>
    <message>
        <source>valley travel</source>
        <translation>Weg des Tals</translation>
    </message>
    <message>
        <source>peak force</source>
        <translation>Spitzenkraft</translation>
    </message>
    <message>
        <source>valley force</source>
        <translation>Kraft des Tals</translation>
    </message>
    <message>
        <source>jump length</source>
        <translation>Länge des Sprungs</translation>
    </message>
    <message>
        <source>jump energy</source>
        <translation>Sprungenergie</translation>
    </message>
    <message>
        <source>%1; before the bottom-out by %2 % at most</source>
        <translation>%1; vor dem Anschlag um höchstens %2 %</translation>
    </message>
</context>
<context>
    <name>ExperimenterDialog</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1, complete</source>
        <translation>%1, vollständig</translation>
    </message>
    <message>
        <source>%1, ended early</source>
        <translation>%1, vorzeitig beendet</translation>
    </message>
    <message>
        <source>person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>REHEARSAL, without a device</source>
        <translation>PROBELAUF, ohne Gerät</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULIERT</translation>
    </message>
</context>
<context>
    <name>FormatWords</name>
    <message>
        <source>Detent package (JSON)</source>
        <translation>Detent-Paket (JSON)</translation>
    </message>
    <message>
        <source>Everything for your own playback program: force thresholds, waveforms, curve and filters.</source>
        <translation>Alles für ein eigenes Abspielprogramm: Kraftschwellen, Wellenformen, Kurve und Filter.</translation>
    </message>
    <message>
        <source>Firmware (C header)</source>
        <translation>Firmware (C-Header)</translation>
    </message>
    <message>
        <source>Force thresholds, waveforms and curve for a microcontroller. Filters, equalizer and limiter are left out.</source>
        <translation>Kraftschwellen, Wellenformen und Kurve für einen Mikrocontroller. Ohne Filter, Entzerrer und Begrenzer.</translation>
    </message>
    <message>
        <source>iPhone (AHAP)</source>
        <translation>iPhone (AHAP)</translation>
    </message>
    <message>
        <source>Two files, press and release, 80 to 230 Hz. Plays like a recording; the finger&apos;s force has no effect.</source>
        <translation>Zwei Dateien, Hinweg und Rückweg, 80 bis 230 Hz. Spielt wie eine Aufnahme ab; die Kraft des Fingers hat keinen Einfluss.</translation>
    </message>
    <message>
        <source>Meta and Lofelt (.haptic)</source>
        <translation>Meta und Lofelt (.haptic)</translation>
    </message>
    <message>
        <source>One tone, 80 to 230 Hz. Plays like a recording; the finger&apos;s force has no effect.</source>
        <translation>Ein Ton, 80 bis 230 Hz. Spielt wie eine Aufnahme ab; die Kraft des Fingers hat keinen Einfluss.</translation>
    </message>
    <message>
        <source>Android (Kotlin)</source>
        <translation>Android (Kotlin)</translation>
    </message>
    <message>
        <source>Strength of press and release over time, in steps of at least 20 ms. Plays like a recording; the finger&apos;s force has no effect.</source>
        <translation>Stärke von Hinweg und Rückweg über der Zeit, in Schritten von mindestens 20 ms. Spielt wie eine Aufnahme ab; die Kraft des Fingers hat keinen Einfluss.</translation>
    </message>
    <message>
        <source>OpenXR (parametric)</source>
        <translation>OpenXR (parametrisch)</translation>
    </message>
    <message>
        <source>Two files with the same data, JSON and a C header. Plays like a recording; the finger&apos;s force has no effect.</source>
        <translation>Zwei Dateien mit denselben Daten, JSON und C-Header. Spielt wie eine Aufnahme ab; die Kraft des Fingers hat keinen Einfluss.</translation>
    </message>
    <message>
        <source>MPEG haptics (HJIF)</source>
        <translation>MPEG-Haptik (HJIF)</translation>
    </message>
    <message>
        <source>ISO/IEC 23090-31, with the unchanged waveform. Plays like a recording; the finger&apos;s force has no effect.</source>
        <translation>ISO/IEC 23090-31, mit unveränderter Wellenform. Spielt wie eine Aufnahme ab; die Kraft des Fingers hat keinen Einfluss.</translation>
    </message>
    <message>
        <source>Piezo driver BOS1921</source>
        <translation>Piezotreiber BOS1921</translation>
    </message>
    <message>
        <source>Whole sine cycles for the driver&apos;s memory. Plays like a recording; the finger&apos;s force has no effect.</source>
        <translation>Ganze Sinusperioden für den Speicher des Treibers. Spielt wie eine Aufnahme ab; die Kraft des Fingers hat keinen Einfluss.</translation>
    </message>
    <message>
        <source>Motor driver DA7280, DA7282</source>
        <translation>Motortreiber DA7280, DA7282</translation>
    </message>
    <message>
        <source>100 bytes of waveform memory; the motor vibrates at its own frequency.</source>
        <translation>100 Byte Wellenformspeicher; der Motor vibriert mit seiner eigenen Frequenz.</translation>
    </message>
    <message>
        <source>Motor driver DRV2605</source>
        <translation>Motortreiber DRV2605</translation>
    </message>
    <message>
        <source>One amplitude every 5 ms; the motor vibrates at its own frequency.</source>
        <translation>Alle 5 ms eine Amplitude; der Motor vibriert mit seiner eigenen Frequenz.</translation>
    </message>
    <message>
        <source>Samples (C array)</source>
        <translation>Abtastwerte (C-Array)</translation>
    </message>
    <message>
        <source>The waveform as numbers. Plays like a recording; the finger&apos;s force has no effect.</source>
        <translation>Die Wellenform als Zahlen. Spielt wie eine Aufnahme ab; die Kraft des Fingers hat keinen Einfluss.</translation>
    </message>
    <message>
        <source>Haptic touchpad</source>
        <translation>Haptisches Touchpad</translation>
    </message>
    <message>
        <source>Sets force threshold (110 to 190 g) and intensity; the touchpad plays its own waveforms.</source>
        <translation>Setzt Kraftschwelle (110 bis 190 g) und Stärke; das Touchpad spielt eigene Wellenformen.</translation>
    </message>
</context>
<context>
    <name>GraphDrag</name>
    <message>
        <source>The move stops at %1. %2</source>
        <translation>Die Bewegung endet bei %1. %2</translation>
    </message>
    <message>
        <source>Shift: one axis, Ctrl: no snapping, Esc: cancel</source>
        <translation>Umschalt: eine Achse, Strg: kein Einrasten, Esc: abbrechen</translation>
    </message>
    <message>
        <source>Shift: one axis, Esc: cancel</source>
        <translation>Umschalt: eine Achse, Esc: abbrechen</translation>
    </message>
</context>
<context>
    <name>InputKinds</name>
    <message>
        <source>Check the name; the file may have been moved or renamed</source>
        <translation>Prüfen Sie den Namen; die Datei wurde vielleicht verschoben oder umbenannt</translation>
    </message>
    <message>
        <source>Choose a file in this folder</source>
        <translation>Wählen Sie eine Datei in diesem Ordner</translation>
    </message>
    <message>
        <source>Check the permissions of the file</source>
        <translation>Prüfen Sie die Zugriffsrechte der Datei</translation>
    </message>
    <message>
        <source>All supported files</source>
        <translation>Alle unterstützten Dateien</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Taster</translation>
    </message>
    <message>
        <source>Datasheets and pictures</source>
        <translation>Datenblätter und Bilder</translation>
    </message>
    <message>
        <source>Force-displacement CSV</source>
        <translation>Kraft-Weg-CSV</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Alle Dateien</translation>
    </message>
    <message>
        <source>Datasheets, pictures and force meters&apos; logs</source>
        <translation>Datenblätter, Bilder und Protokolle von Kraftmessgeräten</translation>
    </message>
    <message>
        <source>the file was not found</source>
        <translation>die Datei wurde nicht gefunden</translation>
    </message>
    <message>
        <source>this is a folder, not a file</source>
        <translation>dies ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>the file cannot be opened: %1</source>
        <translation>die Datei lässt sich nicht öffnen: %1</translation>
    </message>
    <message>
        <source>this is not an ordinary file</source>
        <translation>dies ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>Save the content to an ordinary file and open that file</source>
        <translation>Speichern Sie den Inhalt in einer gewöhnlichen Datei, und öffnen Sie diese</translation>
    </message>
</context>
<context>
    <name>Measured</name>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>%1 ± %2 %3</source>
        <translation>%1 ± %2 %3</translation>
    </message>
    <message>
        <source>Rated by %1 (licence: %2).</source>
        <translation>Bewertet von %1 (Lizenz: %2).</translation>
    </message>
    <message>
        <source>Forces in this kind of file may differ greatly from those of other laboratories.</source>
        <translation>Kräfte in dieser Art von Datei können stark von denen anderer Labore abweichen.</translation>
    </message>
    <message>
        <source>%1
Credit: %2
Licence: %3</source>
        <translation>%1
Urheber: %2
Lizenz: %3</translation>
    </message>
    <message>
        <source>%1, run %2</source>
        <translation>%1, Lauf %2</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>intermediate</source>
        <translation>dazwischen</translation>
    </message>
    <message>
        <source>tactile</source>
        <translation>taktil</translation>
    </message>
    <message>
        <source>none stated</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1, specimen %2</source>
        <translation>%1, Exemplar %2</translation>
    </message>
    <message>
        <source>%1 measurements of %2 specimens of this switch. Spread: %3.</source>
        <translation>%1 Messungen von %2 Exemplaren dieses Schalters. Streuung: %3.</translation>
    </message>
    <message>
        <source>%1 measurements of one specimen of this switch. Spread: %2.</source>
        <translation>%1 Messungen eines Exemplars dieses Schalters. Streuung: %2.</translation>
    </message>
</context>
<context>
    <name>Moves</name>
    <message>
        <source>the press between %1 and %2</source>
        <translation>den Hinweg zwischen %1 und %2</translation>
    </message>
    <message>
        <source>the release between %1 and %2</source>
        <translation>den Rückweg zwischen %1 und %2</translation>
    </message>
    <message>
        <source>Moves %1.</source>
        <translation>Bewegt %1.</translation>
    </message>
    <message>
        <source>Also changes: %1.</source>
        <translation>Ändert auch: %1.</translation>
    </message>
</context>
<context>
    <name>PageWords</name>
    <message>
        <source>Source: %1, page %2, graph %3</source>
        <translation>Quelle: %1, Seite %2, Graph %3</translation>
    </message>
    <message>
        <source>Press at %1: </source>
        <translation>Hinweg bei %1: </translation>
    </message>
    <message>
        <source>Release at %1: </source>
        <translation>Rückweg bei %1: </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>PlacementDelay</name>
    <message>
        <source>%1 ms, spread %2 ms (%3 sample frames at 48 kHz)</source>
        <translation>%1 ms, Streuung %2 ms (%3 Abtastwerte bei 48 kHz)</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>The page names no units: %1 and %2 are a guess.</source>
        <translation>Die Seite nennt keine Einheiten: %1 und %2 sind geraten.</translation>
    </message>
    <message>
        <source>If everything matches the page, tick “I have checked it against the page”.</source>
        <translation>Wenn alles zur Seite passt, setzen Sie das Häkchen bei „Ich habe es mit der Seite verglichen“.</translation>
    </message>
    <message>
        <source>not readable yet</source>
        <translation>noch nicht lesbar</translation>
    </message>
    <message>
        <source>, check it</source>
        <translation>, bitte prüfen</translation>
    </message>
    <message>
        <source>plot frame drawn by hand</source>
        <translation>Rahmen von Hand gezeichnet</translation>
    </message>
    <message>
        <source>%1–%2 %3</source>
        <translation>%1–%2 %3</translation>
    </message>
    <message>
        <source>This plot shows %1 switches.</source>
        <translation>Dieses Diagramm zeigt %1 Taster.</translation>
    </message>
    <message>
        <source>Choose one in the list of switches, or tick several there: each becomes a button of its own.</source>
        <translation>Wählen Sie einen in der Liste der Taster oder kreuzen Sie dort mehrere an: Aus jedem wird ein eigener Taster.</translation>
    </message>
    <message>
        <source>Confidence %1 %</source>
        <translation>Sicherheit %1 %</translation>
    </message>
</context>
<context>
    <name>Questions</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Änderungen an „%1“ speichern?</translation>
    </message>
    <message numerus="yes">
        <source>Save the changes to %n buttons?</source>
        <translation>
            <numerusform>Änderungen an %n Taster speichern?</numerusform>
            <numerusform>Änderungen an %n Tastern speichern?</numerusform>
        </translation>
    </message>
    <message>
        <source>If you do not save them, the changes are lost.</source>
        <translation>Wenn Sie nicht speichern, gehen die Änderungen verloren.</translation>
    </message>
    <message>
        <source>Detent</source>
        <translation>Detent</translation>
    </message>
</context>
<context>
    <name>SampledAt</name>
    <message>
        <source>Type a step such as 0.1, or travels such as 0; 0.5; 2</source>
        <translation>Geben Sie einen Schritt wie 0,1 oder Wege wie 0; 0,5; 2 ein</translation>
    </message>
</context>
<context>
    <name>StateName</name>
    <message>
        <source>State %1</source>
        <translation>Zustand %1</translation>
    </message>
    <message>
        <source>unlocked</source>
        <translation>gelöst</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>eingerastet</translation>
    </message>
</context>
<context>
    <name>Templates</name>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Force rises evenly; no tactile point</source>
        <translation>Die Kraft steigt gleichmäßig; kein Druckpunkt</translation>
    </message>
    <message>
        <source>Tactile</source>
        <translation>Taktil</translation>
    </message>
    <message>
        <source>One soft bump on the way down and up</source>
        <translation>Ein weicher Buckel auf dem Hin- und Rückweg</translation>
    </message>
    <message>
        <source>Clicky</source>
        <translation>Klickend</translation>
    </message>
    <message>
        <source>The force collapses at the tactile point</source>
        <translation>Die Kraft bricht am Druckpunkt ein</translation>
    </message>
    <message>
        <source>Two-level</source>
        <translation>Zweistufig</translation>
    </message>
    <message>
        <source>Two tactile points, the second stronger, as on a camera&apos;s shutter button</source>
        <translation>Zwei Druckpunkte, der zweite stärker, wie beim Auslöser einer Kamera</translation>
    </message>
    <message>
        <source>Self-locking</source>
        <translation>Rastend</translation>
    </message>
    <message>
        <source>One press locks it down, the next press releases it; two states</source>
        <translation>Ein Druck rastet ihn ein, der nächste löst ihn; zwei Zustände</translation>
    </message>
</context>
<context>
    <name>detent</name>
    <message>
        <source>state %1</source>
        <translation>Zustand %1</translation>
    </message>
    <message>
        <source>state &quot;%1&quot;</source>
        <translation>Zustand „%1“</translation>
    </message>
    <message>
        <source>%1 at %2 lies outside its stroke (%3 to %4)</source>
        <translation>%1 bei %2 liegt außerhalb der Kurve (%3 bis %4)</translation>
    </message>
    <message>
        <source>Move the point inside the travel, or remove it</source>
        <translation>Legen Sie den Punkt in den Weg, oder entfernen Sie ihn</translation>
    </message>
    <message>
        <source>displacement %1 is not a usable number</source>
        <translation>der Weg %1 ist keine brauchbare Zahl</translation>
    </message>
    <message>
        <source>Give a displacement inside the travel</source>
        <translation>Geben Sie einen Ort innerhalb des Wegs an</translation>
    </message>
    <message>
        <source>damping %1 N·s/mm is not a number of 0 or more</source>
        <translation>die Dämpfung %1 N·s/mm ist keine Zahl ab 0</translation>
    </message>
    <message>
        <source>Give 0 where there is no damping</source>
        <translation>Geben Sie 0 an, wo es keine Dämpfung gibt</translation>
    </message>
    <message>
        <source>Give each state its own name</source>
        <translation>Geben Sie jedem Zustand seinen eigenen Namen</translation>
    </message>
    <message>
        <source>operating point</source>
        <translation>Schaltpunkt</translation>
    </message>
    <message>
        <source>reset point</source>
        <translation>Rückschaltpunkt</translation>
    </message>
    <message>
        <source>provenance</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>%1 is %2, not a usable number</source>
        <translation>%1 ist %2, keine brauchbare Zahl</translation>
    </message>
    <message>
        <source>Leave out values that you do not know</source>
        <translation>Lassen Sie Werte weg, die Sie nicht kennen</translation>
    </message>
    <message>
        <source>frame edge</source>
        <translation>Rahmenkante</translation>
    </message>
    <message>
        <source>axis value</source>
        <translation>Achsenwert</translation>
    </message>
    <message>
        <source>deviation or confidence</source>
        <translation>Abweichung oder Sicherheit</translation>
    </message>
    <message>
        <source>factor %1 is not a number above 0</source>
        <translation>der Faktor %1 ist keine Zahl über 0</translation>
    </message>
    <message>
        <source>Give a factor such as 1.1</source>
        <translation>Geben Sie einen Faktor wie 1,1 an</translation>
    </message>
    <message>
        <source>Choose one of the states of the button</source>
        <translation>Wählen Sie einen der Zustände des Tasters</translation>
    </message>
    <message>
        <source>release curve</source>
        <translation>Rückwegkurve</translation>
    </message>
    <message>
        <source>hysteresis</source>
        <translation>Hysterese</translation>
    </message>
    <message>
        <source>Give a force in N, 0 for none</source>
        <translation>Geben Sie eine Kraft in N an, 0 für keine</translation>
    </message>
    <message>
        <source>Remove one of the states first</source>
        <translation>Entfernen Sie zuerst einen der Zustände</translation>
    </message>
    <message>
        <source>Add a second state first</source>
        <translation>Fügen Sie zuerst einen zweiten Zustand hinzu</translation>
    </message>
    <message>
        <source>Choose one of the points of the curve</source>
        <translation>Wählen Sie einen der Punkte der Kurve</translation>
    </message>
    <message>
        <source>curve point %1</source>
        <translation>Kurvenpunkt %1</translation>
    </message>
    <message>
        <source>Keep the point between its neighbours, or remove the neighbour first</source>
        <translation>Lassen Sie den Punkt zwischen seinen Nachbarn, oder entfernen Sie zuerst den Nachbarn</translation>
    </message>
    <message>
        <source>Choose a displacement between the ends of the curve</source>
        <translation>Wählen Sie einen Weg zwischen den Enden der Kurve</translation>
    </message>
    <message>
        <source>Move that curve point instead</source>
        <translation>Verschieben Sie stattdessen diesen Kurvenpunkt</translation>
    </message>
    <message>
        <source>Move the point instead</source>
        <translation>Verschieben Sie den Punkt stattdessen</translation>
    </message>
    <message>
        <source>Keep the points in their order, or select fewer points</source>
        <translation>Lassen Sie die Punkte in ihrer Reihenfolge, oder wählen Sie weniger Punkte aus</translation>
    </message>
    <message>
        <source>Keep at least two points</source>
        <translation>Lassen Sie mindestens zwei Punkte stehen</translation>
    </message>
    <message>
        <source>Choose two places on the curve, the first one before the second</source>
        <translation>Wählen Sie zwei Orte auf der Kurve, den ersten vor dem zweiten</translation>
    </message>
    <message>
        <source>Give one point or more</source>
        <translation>Geben Sie mindestens einen Punkt an</translation>
    </message>
    <message>
        <source>Keep the point between the neighbouring peaks and valleys</source>
        <translation>Lassen Sie den Punkt zwischen den benachbarten Spitzen und Tälern</translation>
    </message>
    <message>
        <source>Keep the force of the point above this value</source>
        <translation>Halten Sie die Kraft des Punkts über diesem Wert</translation>
    </message>
    <message>
        <source>Keep the force of the point below this value</source>
        <translation>Halten Sie die Kraft des Punkts unter diesem Wert</translation>
    </message>
    <message>
        <source>Choose one of the tactile points of the curve</source>
        <translation>Wählen Sie einen der Druckpunkte der Kurve</translation>
    </message>
    <message>
        <source>Move the section by less</source>
        <translation>Verschieben Sie den Abschnitt weniger weit</translation>
    </message>
    <message>
        <source>new jump</source>
        <translation>neuer Sprung</translation>
    </message>
    <message>
        <source>Give width and drop as numbers above 0</source>
        <translation>Geben Sie Breite und Abfall als Zahlen über 0 an</translation>
    </message>
    <message>
        <source>Make the jump narrower, or move it inward</source>
        <translation>Machen Sie den Sprung schmaler, oder rücken Sie ihn nach innen</translation>
    </message>
    <message>
        <source>Start the jump where the force rises, so that its start becomes a tactile point</source>
        <translation>Lassen Sie den Sprung beginnen, wo die Kraft steigt; sein Anfang wird dann ein Druckpunkt</translation>
    </message>
    <message>
        <source>tactile point %1</source>
        <translation>Druckpunkt %1</translation>
    </message>
    <message>
        <source>Choose a peak or a valley</source>
        <translation>Wählen Sie eine Spitze oder ein Tal</translation>
    </message>
    <message>
        <source>Give a ratio above 0</source>
        <translation>Geben Sie ein Verhältnis über 0 an</translation>
    </message>
    <message>
        <source>Add a valley, or raise the end of the stroke above the tactile point</source>
        <translation>Fügen Sie ein Tal hinzu, oder heben Sie das Ende der Kurve über den Druckpunkt</translation>
    </message>
    <message>
        <source>valley after %1</source>
        <translation>Tal nach %1</translation>
    </message>
    <message>
        <source>Choose one of the sections of the curve</source>
        <translation>Wählen Sie einen der Abschnitte der Kurve</translation>
    </message>
    <message>
        <source>section %1</source>
        <translation>Abschnitt %1</translation>
    </message>
    <message>
        <source>Make the drop larger or the jump narrower</source>
        <translation>Machen Sie den Abfall größer oder den Sprung schmaler</translation>
    </message>
    <message>
        <source>release rows, point %1</source>
        <translation>Zeilen des Rückwegs, Punkt %1</translation>
    </message>
    <message>
        <source>press rows, point %1</source>
        <translation>Zeilen des Hinwegs, Punkt %1</translation>
    </message>
    <message>
        <source>release rows</source>
        <translation>Zeilen des Rückwegs</translation>
    </message>
    <message>
        <source>press rows</source>
        <translation>Zeilen des Hinwegs</translation>
    </message>
    <message>
        <source>force reaches %1, beyond the limit of ±%2</source>
        <translation>die Kraft erreicht %1, jenseits der Grenze von ±%2</translation>
    </message>
    <message>
        <source>Check the unit of the force axis</source>
        <translation>Prüfen Sie die Einheit der Kraftachse</translation>
    </message>
    <message>
        <source>displacement reaches %1, beyond the limit of %2</source>
        <translation>der Weg erreicht %1, jenseits der Grenze von %2</translation>
    </message>
    <message>
        <source>Check the unit of the displacement axis</source>
        <translation>Prüfen Sie die Einheit der Wegachse</translation>
    </message>
    <message>
        <source>Measure the displacement of both strokes from the same zero</source>
        <translation>Messen Sie den Weg beider Hübe vom selben Nullpunkt aus</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>Give every curve point usable numbers</source>
        <translation>Geben Sie jedem Kurvenpunkt brauchbare Zahlen</translation>
    </message>
    <message>
        <source>Sort the points by increasing displacement</source>
        <translation>Ordnen Sie die Punkte nach zunehmendem Weg</translation>
    </message>
    <message>
        <source>At one displacement, keep at most two points: the ends of a vertical piece</source>
        <translation>Behalten Sie bei einem Weg höchstens zwei Punkte: die Enden eines senkrechten Stücks</translation>
    </message>
    <message>
        <source>piece %1</source>
        <translation>Stück %1</translation>
    </message>
    <message>
        <source>Make the piece vertical (equal displacements) or less steep</source>
        <translation>Machen Sie das Stück senkrecht (gleiche Wege) oder weniger steil</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>Correct the file at this place, or export the button again</source>
        <translation>Berichtigen Sie die Datei an dieser Stelle, oder exportieren Sie den Taster noch einmal</translation>
    </message>
    <message>
        <source>Give a *.button.json written by Detent</source>
        <translation>Geben Sie eine *.button.json an, die Detent geschrieben hat</translation>
    </message>
    <message>
        <source>version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Add &quot;version&quot;: %1</source>
        <translation>Ergänzen Sie &quot;version&quot;: %1</translation>
    </message>
    <message>
        <source>Update Detent to open this file</source>
        <translation>Aktualisieren Sie Detent, um diese Datei zu öffnen</translation>
    </message>
    <message>
        <source>Initial force</source>
        <translation>Anfangskraft</translation>
    </message>
    <message>
        <source>Pre-travel</source>
        <translation>Vorlaufweg</translation>
    </message>
    <message>
        <source>Operating force</source>
        <translation>Betätigungskraft</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Spitzenkraft</translation>
    </message>
    <message>
        <source>Peak travel</source>
        <translation>Weg zur Spitze</translation>
    </message>
    <message>
        <source>Valley force</source>
        <translation>Talkraft</translation>
    </message>
    <message>
        <source>Valley travel</source>
        <translation>Weg zum Tal</translation>
    </message>
    <message>
        <source>Tactile drop</source>
        <translation>Kraftabfall</translation>
    </message>
    <message>
        <source>Snap ratio</source>
        <translation>Schnappverhältnis</translation>
    </message>
    <message>
        <source>Spring rate to the peak</source>
        <translation>Federrate bis zur Spitze</translation>
    </message>
    <message>
        <source>Spring rate of the drop</source>
        <translation>Federrate des Abfalls</translation>
    </message>
    <message>
        <source>Spring rate to the bottom-out</source>
        <translation>Federrate bis zum Anschlag</translation>
    </message>
    <message>
        <source>Reset point</source>
        <translation>Rückschaltpunkt</translation>
    </message>
    <message>
        <source>Reset force</source>
        <translation>Rückschaltkraft</translation>
    </message>
    <message>
        <source>Differential travel</source>
        <translation>Differenzweg</translation>
    </message>
    <message>
        <source>Over-travel</source>
        <translation>Nachlaufweg</translation>
    </message>
    <message>
        <source>Bottom-out force</source>
        <translation>Kraft am Anschlag</translation>
    </message>
    <message>
        <source>Bottom-out travel</source>
        <translation>Weg zum Anschlag</translation>
    </message>
    <message>
        <source>Total travel</source>
        <translation>Gesamtweg</translation>
    </message>
    <message>
        <source>Force at the end</source>
        <translation>Kraft am Ende</translation>
    </message>
    <message>
        <source>Work of a press</source>
        <translation>Betätigungsarbeit</translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation>Hysterese</translation>
    </message>
    <message>
        <source>%1 cannot be infinite</source>
        <translation>%1 kann nicht unendlich sein</translation>
    </message>
    <message>
        <source>Give a number</source>
        <translation>Eine Zahl angeben</translation>
    </message>
    <message>
        <source>%1 N/mm</source>
        <translation>%1 N/mm</translation>
    </message>
    <message>
        <source>%1 mJ</source>
        <translation>%1 mJ</translation>
    </message>
    <message>
        <source>a part of the curve would have no width left</source>
        <translation>hätte ein Teil der Kurve keine Breite mehr</translation>
    </message>
    <message>
        <source>a rising part of the curve would fall, or a falling part would rise</source>
        <translation>würde ein Anstieg der Kraft zum Abfall oder ein Abfall zum Anstieg</translation>
    </message>
    <message>
        <source>the force would fall below 0, and the button would pull</source>
        <translation>würde die Kraft negativ, und der Taster würde ziehen</translation>
    </message>
    <message>
        <source>the operating or the reset point would leave its stroke</source>
        <translation>läge der Schaltpunkt oder der Rückschaltpunkt nicht mehr auf seiner Kurve</translation>
    </message>
    <message>
        <source>the reset point would lie deeper than the operating point</source>
        <translation>läge der Rückschaltpunkt tiefer als der Schaltpunkt</translation>
    </message>
    <message>
        <source>the release force would exceed the press force</source>
        <translation>läge die Kraft des Rückwegs über der des Hinwegs</translation>
    </message>
    <message>
        <source>a tactile point would become too weak to count</source>
        <translation>wäre ein Druckpunkt zu schwach, um zu zählen</translation>
    </message>
    <message>
        <source>the bottom-out would begin elsewhere</source>
        <translation>begänne der Anschlag an anderer Stelle</translation>
    </message>
    <message>
        <source>the release would not begin where the press ends</source>
        <translation>begänne der Rückweg nicht, wo der Hinweg endet</translation>
    </message>
    <message>
        <source>the release would not end where the next state starts</source>
        <translation>endete der Rückweg nicht, wo der nächste Zustand beginnt</translation>
    </message>
    <message>
        <source>a tactile point would lie inside a jump, where no finger feels it</source>
        <translation>läge ein Druckpunkt in einem Sprung, wo ihn kein Finger fühlt</translation>
    </message>
    <message>
        <source>the press would begin with a falling force</source>
        <translation>begänne der Hinweg mit fallender Kraft</translation>
    </message>
    <message>
        <source>a damping point would lie outside the travel</source>
        <translation>läge ein Dämpfungspunkt außerhalb des Wegs</translation>
    </message>
    <message>
        <source>no curve was found that meets all these targets (%1); it is not known which of them conflict</source>
        <translation>keine Kurve gefunden, die alle diese Ziele erfüllt (%1); welche davon sich widersprechen, ist nicht bekannt</translation>
    </message>
    <message>
        <source>Remove or unlock some of these, or give values nearer to the current ones</source>
        <translation>Entfernen oder entsperren Sie einige davon, oder geben Sie Werte näher an den jetzigen an</translation>
    </message>
    <message>
        <source>%1 and %2 contradict each other</source>
        <translation>%1 und %2 widersprechen einander</translation>
    </message>
    <message>
        <source>Remove or unlock one of the two, or give it another value</source>
        <translation>Entfernen oder entsperren Sie eines der beiden, oder geben Sie ihm einen anderen Wert</translation>
    </message>
    <message>
        <source>Remove or unlock one of them, or give it another value</source>
        <translation>Entfernen oder entsperren Sie eines davon, oder geben Sie ihm einen anderen Wert</translation>
    </message>
    <message>
        <source>the button has no key figure of this kind: %1</source>
        <translation>Der Taster hat keine solche Kennzahl: %1</translation>
    </message>
    <message>
        <source>the share is %1</source>
        <translation>der Anteil ist %1</translation>
    </message>
    <message>
        <source>press</source>
        <translation>Hinweg</translation>
    </message>
    <message>
        <source>release</source>
        <translation>Rückweg</translation>
    </message>
    <message>
        <source>Move only one end, or remove the link between the ends</source>
        <translation>Bewegen Sie nur ein Ende, oder heben Sie die Kopplung der Enden auf</translation>
    </message>
    <message>
        <source>Unlock the point, or move something else</source>
        <translation>Entsperren Sie den Punkt, oder bewegen Sie etwas anderes</translation>
    </message>
    <message>
        <source>stroke curve</source>
        <translation>Kraftkurve</translation>
    </message>
    <message>
        <source>force graph</source>
        <translation>Kraftgraph</translation>
    </message>
    <message>
        <source>stroke sketch</source>
        <translation>Skizze eines Hubs</translation>
    </message>
    <message>
        <source>self-locking button</source>
        <translation>rastender Taster</translation>
    </message>
    <message>
        <source>links</source>
        <translation>Verknüpfungen</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>button</source>
        <translation>Taster</translation>
    </message>
    <message>
        <source>buttons</source>
        <translation>Taster</translation>
    </message>
    <message>
        <source>weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>key figures</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <source>plot frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>plot</source>
        <translation>Graph</translation>
    </message>
    <message>
        <source>plot frame entered by hand</source>
        <translation>von Hand eingegebener Rahmen</translation>
    </message>
    <message>
        <source>selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>force device</source>
        <translation>Kraftgerät</translation>
    </message>
    <message>
        <source>press trace</source>
        <translation>Betätigungsverlauf</translation>
    </message>
    <message>
        <source>standard press</source>
        <translation>Standardbetätigung</translation>
    </message>
    <message>
        <source>device profile</source>
        <translation>Geräteprofil</translation>
    </message>
    <message>
        <source>default device</source>
        <translation>Standardgerät</translation>
    </message>
    <message>
        <source>sample rate</source>
        <translation>Abtastrate</translation>
    </message>
    <message>
        <source>page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>text of the clipboard</source>
        <translation>Text der Zwischenablage</translation>
    </message>
    <message>
        <source>fit options</source>
        <translation>Einstellungen der Anpassung</translation>
    </message>
    <message>
        <source>point spacing</source>
        <translation>Punktabstand</translation>
    </message>
    <message>
        <source>Give each button one weight of 0 or more, but not 0 to all</source>
        <translation>Geben Sie jedem Taster ein Gewicht ab 0, aber nicht allen 0</translation>
    </message>
    <message>
        <source>Give a share from 0 to 1</source>
        <translation>Geben Sie einen Anteil von 0 bis 1 an</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message>
        <source>Keep two to four graphs</source>
        <translation>Behalten Sie zwei bis vier Graphen</translation>
    </message>
    <message>
        <source>speed %1 is not a usable speed</source>
        <translation>%1 ist keine brauchbare Geschwindigkeit</translation>
    </message>
    <message>
        <source>Give speeds above 0, up to %1</source>
        <translation>Geschwindigkeiten über 0 bis %1 angeben</translation>
    </message>
    <message>
        <source>speed %1 is not above the previous speed %2</source>
        <translation>Geschwindigkeit %1 ist nicht höher als die vorige, %2</translation>
    </message>
    <message>
        <source>Give graphs of one button, with the same travel</source>
        <translation>Graphen eines Tasters mit demselben Weg angeben</translation>
    </message>
    <message>
        <source>Choose the same speed for the main graph of every state</source>
        <translation>Wählen Sie für den Hauptgraphen jedes Zustands dieselbe Geschwindigkeit</translation>
    </message>
    <message>
        <source>Give every state graphs at the same speeds</source>
        <translation>Jedem Zustand Graphen bei denselben Geschwindigkeiten geben</translation>
    </message>
    <message>
        <source>the two graphs have no stroke in common</source>
        <translation>die beiden Graphen haben keinen gemeinsamen Hub</translation>
    </message>
    <message>
        <source>Remove the point</source>
        <translation>Entfernen Sie den Punkt</translation>
    </message>
    <message>
        <source>%1 mm/s is not a speed above 0</source>
        <translation>%1 mm/s ist keine Geschwindigkeit über 0</translation>
    </message>
    <message>
        <source>Give a speed such as 50</source>
        <translation>Eine Geschwindigkeit wie 50 angeben</translation>
    </message>
    <message>
        <source>there are %1 speeds for %2 buttons</source>
        <translation>es gibt %1 Geschwindigkeiten für %2 Taster</translation>
    </message>
    <message>
        <source>Give two to four buttons, and a speed for each</source>
        <translation>Zwei bis vier Taster angeben, und zu jedem eine Geschwindigkeit</translation>
    </message>
    <message>
        <source>the release force at one speed would exceed the press force at another</source>
        <translation>läge die Kraft des Rückwegs bei einer Geschwindigkeit über der des Hinwegs bei einer anderen</translation>
    </message>
    <message>
        <source>lock position</source>
        <translation>Raststellung</translation>
    </message>
    <message>
        <source>Move the lock position between the two</source>
        <translation>Legen Sie die Raststelle zwischen beide</translation>
    </message>
    <message>
        <source>Choose specimens of the same button</source>
        <translation>Wählen Sie Exemplare desselben Tasters</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>live playback</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>playback setting</source>
        <translation>Einstellung der Wiedergabe</translation>
    </message>
    <message>
        <source>travel of the button</source>
        <translation>Weg des Tasters</translation>
    </message>
    <message>
        <source>rate in Hz</source>
        <translation>Rate in Hz</translation>
    </message>
    <message>
        <source>mass of the device in kg</source>
        <translation>Masse des Geräts in kg</translation>
    </message>
    <message>
        <source>friction of the device in N</source>
        <translation>Reibung des Geräts in N</translation>
    </message>
    <message>
        <source>damping of the device in N·s/mm</source>
        <translation>Dämpfung des Geräts in N·s/mm</translation>
    </message>
    <message>
        <source>encoder step in mm</source>
        <translation>Encoderschritt in mm</translation>
    </message>
    <message>
        <source>delay of the device in s</source>
        <translation>Verzögerung des Geräts in s</translation>
    </message>
    <message>
        <source>motor lag of the device in s</source>
        <translation>Verzögerung des Motors in s</translation>
    </message>
    <message>
        <source>steepest slope in N/mm</source>
        <translation>größte Steigung in N/mm</translation>
    </message>
    <message>
        <source>force limit in N</source>
        <translation>Kraftgrenze in N</translation>
    </message>
    <message>
        <source>limit of force change in N/s</source>
        <translation>Grenze des Kraftanstiegs in N/s</translation>
    </message>
    <message>
        <source>speed limit in mm/s</source>
        <translation>Grenze der Geschwindigkeit in mm/s</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>snap</source>
        <translation>Schnappverhältnis</translation>
    </message>
    <message>
        <source>quiet</source>
        <translation>still</translation>
    </message>
    <message>
        <source>%1 lies outside the travel</source>
        <translation>%1 liegt außerhalb des Weges</translation>
    </message>
    <message>
        <source>Give travels from %1 to %2</source>
        <translation>Geben Sie Wege von %1 bis %2 an</translation>
    </message>
    <message>
        <source>the step is not above 0</source>
        <translation>die Schrittweite ist nicht größer als 0</translation>
    </message>
    <message>
        <source>Give a step such as 0.1 mm</source>
        <translation>Geben Sie eine Schrittweite wie 0,1 mm an</translation>
    </message>
    <message>
        <source>the step is too small: the table would have more than 100000 rows</source>
        <translation>die Schrittweite ist zu klein: Die Tabelle hätte mehr als 100000 Zeilen</translation>
    </message>
    <message>
        <source>Give a larger step</source>
        <translation>Geben Sie eine größere Schrittweite an</translation>
    </message>
    <message>
        <source>no travel is given</source>
        <translation>kein Weg ist angegeben</translation>
    </message>
    <message>
        <source>Give at least one travel</source>
        <translation>Geben Sie mindestens einen Weg an</translation>
    </message>
    <message>
        <source>actuation point</source>
        <translation>Auslösepunkt</translation>
    </message>
    <message>
        <source>release point</source>
        <translation>Rückstellpunkt</translation>
    </message>
    <message>
        <source>press distance</source>
        <translation>Druckstrecke</translation>
    </message>
    <message>
        <source>release distance</source>
        <translation>Loslassstrecke</translation>
    </message>
    <message>
        <source>top dead zone</source>
        <translation>obere Totzone</translation>
    </message>
    <message>
        <source>bottom dead zone</source>
        <translation>untere Totzone</translation>
    </message>
    <message>
        <source>specimens</source>
        <translation>Exemplare</translation>
    </message>
    <message>
        <source>rendered press</source>
        <translation>berechneter Tastendruck</translation>
    </message>
    <message>
        <source>there are no buttons</source>
        <translation>es gibt keine Taster</translation>
    </message>
    <message>
        <source>Give one button or more</source>
        <translation>Geben Sie einen oder mehrere Taster an</translation>
    </message>
    <message>
        <source>the number of weights, or one of the weights, does not suit the buttons</source>
        <translation>die Anzahl der Gewichte oder eines der Gewichte passt nicht zu den Tastern</translation>
    </message>
    <message>
        <source>some of the buttons are momentary, others are self-locking</source>
        <translation>einige der Taster sind tastend, andere rastend</translation>
    </message>
    <message>
        <source>Choose buttons of one kind</source>
        <translation>Wählen Sie Taster einer Art</translation>
    </message>
    <message>
        <source>the displacement %1 is not above that of the previous point</source>
        <translation>der Weg %1 liegt nicht über dem des vorigen Punkts</translation>
    </message>
    <message>
        <source>Sort the damping points by increasing displacement</source>
        <translation>Sortieren Sie die Dämpfungspunkte nach zunehmendem Weg</translation>
    </message>
    <message>
        <source>the state has graphs at other speeds, but gives no speed for its main graph</source>
        <translation>der Zustand hat Graphen bei anderen Geschwindigkeiten, gibt aber keine Geschwindigkeit für den Hauptgraphen an</translation>
    </message>
    <message>
        <source>Give the speed of the main graph in mm/s</source>
        <translation>Geben Sie die Geschwindigkeit des Hauptgraphen in mm/s an</translation>
    </message>
    <message>
        <source>the state gives the speed %1, but has no graph at another speed</source>
        <translation>der Zustand gibt die Geschwindigkeit %1 an, hat aber keinen Graphen bei einer anderen</translation>
    </message>
    <message>
        <source>Add a graph at another speed, or remove the speed</source>
        <translation>Fügen Sie einen Graphen bei einer anderen Geschwindigkeit hinzu, oder entfernen Sie die Geschwindigkeit</translation>
    </message>
    <message>
        <source>the state has graphs at %1 speeds, which are too many</source>
        <translation>der Zustand hat Graphen bei %1 Geschwindigkeiten, das sind zu viele</translation>
    </message>
    <message>
        <source>the state has two graphs at the speed %1</source>
        <translation>der Zustand hat zwei Graphen bei der Geschwindigkeit %1</translation>
    </message>
    <message>
        <source>Give each graph a different speed</source>
        <translation>Geben Sie jedem Graphen eine andere Geschwindigkeit</translation>
    </message>
    <message>
        <source>Sort the other graphs by increasing speed, and use each speed only once</source>
        <translation>Sortieren Sie die übrigen Graphen nach steigender Geschwindigkeit, und verwenden Sie jede nur einmal</translation>
    </message>
    <message>
        <source>this graph has a release, but the graph at %1 has none</source>
        <translation>dieser Graph hat einen Rückweg, der Graph bei %1 aber keinen</translation>
    </message>
    <message>
        <source>this graph has no release, but the graph at %1 has one</source>
        <translation>dieser Graph hat keinen Rückweg, der Graph bei %1 aber einen</translation>
    </message>
    <message>
        <source>Give the graphs of all speeds a release, or none of them</source>
        <translation>Geben Sie den Graphen aller Geschwindigkeiten einen Rückweg, oder keinem</translation>
    </message>
    <message>
        <source>the main graph of this state has the speed %1, but that of %2 has %3</source>
        <translation>der Hauptgraph dieses Zustands hat die Geschwindigkeit %1, der von %2 aber %3</translation>
    </message>
    <message>
        <source>the graphs of this state have other speeds than those of %1</source>
        <translation>die Graphen dieses Zustands haben andere Geschwindigkeiten als die von %1</translation>
    </message>
    <message>
        <source>this state has the same name as state %1</source>
        <translation>dieser Zustand hat denselben Namen wie Zustand %1</translation>
    </message>
    <message>
        <source>the button has no state %1</source>
        <translation>der Taster hat keinen Zustand %1</translation>
    </message>
    <message>
        <source>there is no release curve</source>
        <translation>es gibt keinen Rückweg</translation>
    </message>
    <message>
        <source>Create a release curve first (in the window: Edit &gt; Curve &gt; Mirror press to release)</source>
        <translation>Erzeugen Sie zuerst einen Rückweg (im Fenster: Bearbeiten &gt; Kurve &gt; Hinweg zum Rückweg spiegeln)</translation>
    </message>
    <message>
        <source>the hysteresis is not a number of 0 or more</source>
        <translation>die Hysterese ist keine Zahl ab 0</translation>
    </message>
    <message>
        <source>the button already has two states</source>
        <translation>der Taster hat schon zwei Zustände</translation>
    </message>
    <message>
        <source>the button has only this state</source>
        <translation>der Taster hat nur diesen Zustand</translation>
    </message>
    <message>
        <source>the curve has no point %1, because it has only %2 points</source>
        <translation>die Kurve hat keinen Punkt %1, weil sie nur %2 Punkte hat</translation>
    </message>
    <message>
        <source>the point cannot move to %1, because its neighbour at %2 lies in between</source>
        <translation>der Punkt lässt sich nicht nach %1 verschieben, weil sein Nachbar bei %2 dazwischen liegt</translation>
    </message>
    <message>
        <source>no point can be added at %1, because the curve runs from %2 to %3</source>
        <translation>bei %1 lässt sich kein Punkt hinzufügen, weil die Kurve von %2 bis %3 reicht</translation>
    </message>
    <message>
        <source>there already is a curve point at %1</source>
        <translation>bei %1 liegt schon ein Kurvenpunkt</translation>
    </message>
    <message>
        <source>the point cannot be removed, because a curve needs 2 points</source>
        <translation>der Punkt lässt sich nicht entfernen, weil eine Kurve 2 Punkte braucht</translation>
    </message>
    <message>
        <source>the point would move to %1, before curve point %2 at %3</source>
        <translation>der Punkt käme nach %1, vor Kurvenpunkt %2 bei %3</translation>
    </message>
    <message>
        <source>%1 points cannot be removed, because a curve needs 2 points</source>
        <translation>%1 Punkte lassen sich nicht entfernen, weil eine Kurve 2 Punkte braucht</translation>
    </message>
    <message>
        <source>the curve has no part from %1 to %2</source>
        <translation>die Kurve hat keinen Teil von %1 bis %2</translation>
    </message>
    <message>
        <source>there are no points to insert into the curve</source>
        <translation>es gibt keine Punkte, die sich in die Kurve einfügen ließen</translation>
    </message>
    <message>
        <source>the point cannot move to %1, because it must stay between %2 and %3</source>
        <translation>der Punkt lässt sich nicht nach %1 verschieben, weil er zwischen %2 und %3 bleiben muss</translation>
    </message>
    <message>
        <source>with the force %1, the point would no longer be a peak or valley, because the curve beside it ends at %2</source>
        <translation>mit der Kraft %1 wäre der Punkt keine Spitze und kein Tal mehr, weil die Kurve daneben bei %2 endet</translation>
    </message>
    <message>
        <source>the curve has no tactile point %1, because it has only %2</source>
        <translation>die Kurve hat keinen Druckpunkt %1, weil sie nur %2 hat</translation>
    </message>
    <message>
        <source>the section cannot move by %1, because the neighbouring section ends at %2</source>
        <translation>der Abschnitt lässt sich nicht um %1 verschieben, weil der Abschnitt daneben bei %2 endet</translation>
    </message>
    <message>
        <source>the jump has the width %1 and the drop %2, but both must be above 0</source>
        <translation>der Sprung hat die Breite %1 und den Abfall %2, beide müssen aber über 0 liegen</translation>
    </message>
    <message>
        <source>the jump from %1 to %2 leaves the curve, which runs from %3 to %4</source>
        <translation>der Sprung von %1 bis %2 verlässt die Kurve, die von %3 bis %4 reicht</translation>
    </message>
    <message>
        <source>the jump starts at %1, where the force does not rise</source>
        <translation>der Sprung beginnt bei %1, wo die Kraft nicht steigt</translation>
    </message>
    <message>
        <source>the point is neither a peak nor a valley of the curve</source>
        <translation>der Punkt ist weder Spitze noch Tal der Kurve</translation>
    </message>
    <message>
        <source>a tactile point cannot have a snap ratio of %1</source>
        <translation>ein Druckpunkt kann kein Schnappverhältnis von %1 haben</translation>
    </message>
    <message>
        <source>there is no valley after the tactile point</source>
        <translation>nach dem Druckpunkt kommt kein Tal</translation>
    </message>
    <message>
        <source>the curve has no section %1, because it has only %2</source>
        <translation>die Kurve hat keinen Abschnitt %1, weil sie nur %2 hat</translation>
    </message>
    <message>
        <source>the section cannot move, because the distance is not a usable number</source>
        <translation>der Abschnitt lässt sich nicht verschieben, weil der Betrag keine brauchbare Zahl ist</translation>
    </message>
    <message>
        <source>Give the distances as ordinary numbers</source>
        <translation>Geben Sie die Beträge als gewöhnliche Zahlen an</translation>
    </message>
    <message>
        <source>the list has %1 codes for %2 warnings</source>
        <translation>die Liste hat %1 Codes zu %2 Warnungen</translation>
    </message>
    <message>
        <source>the picture has %1 bytes; the limit is %2</source>
        <translation>das Bild hat %1 Bytes; die Grenze ist %2</translation>
    </message>
    <message>
        <source>the list has %1 numbers, but it needs nine</source>
        <translation>die Liste hat %1 Zahlen, sie braucht aber neun</translation>
    </message>
    <message>
        <source>the format is not &quot;detent-button&quot;</source>
        <translation>das Format ist nicht „detent-button“</translation>
    </message>
    <message>
        <source>the field is missing</source>
        <translation>das Feld fehlt</translation>
    </message>
    <message>
        <source>the file has version %1; this program reads versions up to %2</source>
        <translation>die Datei hat Version %1; dieses Programm liest Versionen bis %2</translation>
    </message>
    <message>
        <source>the release curve runs from %1 to %2, but the press curve from %3 to %4</source>
        <translation>der Rückweg reicht von %1 bis %2, der Hinweg aber von %3 bis %4</translation>
    </message>
    <message>
        <source>this stroke would no longer end where the other strokes end</source>
        <translation>dieser Hub würde nicht mehr dort enden, wo die übrigen Hübe enden</translation>
    </message>
    <message>
        <source>the curve would leave its locked point at %1</source>
        <translation>die Kurve würde ihren gesperrten Punkt bei %1 verlassen</translation>
    </message>
    <message>
        <source>one of the two values is not a usable number</source>
        <translation>einer der beiden Werte ist keine brauchbare Zahl</translation>
    </message>
    <message>
        <source>the displacement %1 lies before that of the previous point, %2</source>
        <translation>der Weg %1 liegt vor dem des vorigen Punkts, %2</translation>
    </message>
    <message>
        <source>Put the points of the stroke into the order of the movement, or let detent-import fit a curve to them (in the window: File &gt; Import a datasheet)</source>
        <translation>Bringen Sie die Punkte des Hubs in die Reihenfolge der Bewegung, oder lassen Sie detent-import eine Kurve anpassen (im Fenster: Datei &gt; Ein Datenblatt importieren)</translation>
    </message>
    <message>
        <source>the force reverses its direction inside a vertical rise at %1</source>
        <translation>die Kraft kehrt in einem senkrechten Anstieg bei %1 die Richtung um</translation>
    </message>
    <message>
        <source>Keep one force at each displacement, or let detent-import fit a curve to the points (in the window: File &gt; Import a datasheet)</source>
        <translation>Behalten Sie bei jedem Weg eine Kraft, oder lassen Sie detent-import eine Kurve anpassen (im Fenster: Datei &gt; Ein Datenblatt importieren)</translation>
    </message>
    <message>
        <source>the file cannot be written: %1</source>
        <translation>die Datei lässt sich nicht schreiben: %1</translation>
    </message>
    <message>
        <source>this is the third point at the displacement %1</source>
        <translation>dies ist der dritte Punkt beim Weg %1</translation>
    </message>
    <message>
        <source>this piece is too steep to compute its slope</source>
        <translation>dieses Stück ist zu steil, um seine Steigung zu berechnen</translation>
    </message>
    <message>
        <source>another tactile point would get the largest drop</source>
        <translation>ein anderer Druckpunkt bekäme den größten Abfall</translation>
    </message>
    <message>
        <source>these targets contradict each other: %1; %2; %3</source>
        <translation>diese Ziele widersprechen einander: %1; %2; %3</translation>
    </message>
    <message>
        <source>First add to the curve the part that this key figure measures, such as a release or a tactile point</source>
        <translation>Ergänzen Sie zuerst den Teil der Kurve, den diese Kennzahl misst, zum Beispiel einen Rückweg oder einen Druckpunkt</translation>
    </message>
    <message>
        <source>there is no such piece, because the curve has only %1 pieces</source>
        <translation>dieses Stück gibt es nicht, weil die Kurve nur %1 Stücke hat</translation>
    </message>
    <message>
        <source>the lock position does not lie between the valley and the end of the travel</source>
        <translation>die Rastposition liegt nicht zwischen dem Tal und dem Ende des Wegs</translation>
    </message>
    <message>
        <source>an average needs at least two specimens</source>
        <translation>ein Mittel braucht mindestens zwei Exemplare</translation>
    </message>
    <message>
        <source>Give every specimen that was measured</source>
        <translation>Geben Sie jedes gemessene Exemplar an</translation>
    </message>
    <message>
        <source>no displacement lies within the travel of all specimens</source>
        <translation>kein Weg liegt im Weg aller Exemplare</translation>
    </message>
    <message>
        <source>Choose two graphs that both have a press, or both have a release</source>
        <translation>Wählen Sie zwei Graphen, die beide einen Hinweg oder beide einen Rückweg haben</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>clicks only</source>
        <translation>nur Klicks</translation>
    </message>
    <message>
        <source>slopes only</source>
        <translation>nur Steigungen</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>strength of the click</source>
        <translation>Stärke des Klicks</translation>
    </message>
    <message>
        <source>roughness along the travel</source>
        <translation>Rauheit entlang des Wegs</translation>
    </message>
    <message>
        <source>masked by rain noise</source>
        <translation>durch Regengeräusch maskiert</translation>
    </message>
    <message>
        <source>the %1 has an end at %2, but at %4 in the graph of %3; they may differ by %5 at most</source>
        <translation>ein Ende (%1) liegt bei %2, im Graphen für %3 aber bei %4; beide dürfen höchstens um %5 auseinanderliegen</translation>
    </message>
    <message>
        <source>the jump cannot rejoin the curve: its end would lie at %1, but its valley or peak at %2</source>
        <translation>der Sprung findet nicht zur Kurve zurück: Sein Ende läge bei %1, sein Tal oder Gipfel aber bei %2</translation>
    </message>
    <message>
        <source>Choose one of its pieces</source>
        <translation>Wählen Sie eines ihrer Stücke</translation>
    </message>
    <message>
        <source>%1, damping point %2</source>
        <translation>%1, Dämpfungspunkt %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>turn at %1</source>
        <translation>Umkehr bei %1</translation>
    </message>
    <message>
        <source>holds a number that is too large: %1</source>
        <translation>enthält eine zu große Zahl: %1</translation>
    </message>
    <message>
        <source>the file is not valid JSON: it ends too early</source>
        <translation>die Datei ist kein gültiges JSON: sie endet zu früh</translation>
    </message>
    <message>
        <source>the file is not valid JSON</source>
        <translation>die Datei ist kein gültiges JSON</translation>
    </message>
    <message>
        <source>the file is not valid JSON: &quot;%1&quot; cannot be read</source>
        <translation>die Datei ist kein gültiges JSON: „%1“ ist nicht lesbar</translation>
    </message>
</context>
<context>
    <name>detent::Bending</name>
    <message>
        <source>%1 cannot be %2; beyond %3, %4</source>
        <translation>%1 kann nicht %2 sein: Jenseits von %3 %4</translation>
    </message>
    <message>
        <source>Give a value nearer to the current one</source>
        <translation>Geben Sie einen Wert näher am jetzigen an</translation>
    </message>
    <message>
        <source>the curve would break several rules at once</source>
        <translation>verstieße die Kurve gegen mehrere Regeln zugleich</translation>
    </message>
</context>
<context>
    <name>detent::Button</name>
    <message>
        <source>Give one state (momentary) or two (self-locking)</source>
        <translation>Geben Sie einen Zustand an (tastend) oder zwei (rastend)</translation>
    </message>
    <message>
        <source>the button has %1 states, but it needs one or two</source>
        <translation>der Taster hat %1 Zustände, er braucht aber einen oder zwei</translation>
    </message>
</context>
<context>
    <name>detent::ForceGraph</name>
    <message>
        <source>press curve</source>
        <translation>Hinwegkurve</translation>
    </message>
    <message>
        <source>Move the curve so that it starts at 0 mm or later</source>
        <translation>Verschieben Sie die Kurve so, dass sie bei 0 mm oder später beginnt</translation>
    </message>
    <message>
        <source>the press curve starts at %1, before 0</source>
        <translation>der Hinweg beginnt bei %1, vor 0</translation>
    </message>
</context>
<context>
    <name>detent::Reader</name>
    <message>
        <source>Add the field; see docs/reference/file-format.md</source>
        <translation>Ergänzen Sie das Feld, siehe docs/reference/file-format.md</translation>
    </message>
    <message>
        <source>this field does not belong to the format</source>
        <translation>dieses Feld gehört nicht zum Format</translation>
    </message>
    <message>
        <source>the field is missing</source>
        <translation>das Feld fehlt</translation>
    </message>
</context>
<context>
    <name>detent::Reader::T</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>detent::StagedFile</name>
    <message>
        <source>Name a file inside this folder</source>
        <translation>Nennen Sie eine Datei in diesem Ordner</translation>
    </message>
    <message>
        <source>Name an ordinary file</source>
        <translation>Nennen Sie eine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>Create the folder first</source>
        <translation>Legen Sie zuerst den Ordner an</translation>
    </message>
    <message>
        <source>Check the folder&apos;s permissions and free space</source>
        <translation>Prüfen Sie Zugriffsrechte und freien Platz des Ordners</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>die Datei lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>the file cannot be written: %1</source>
        <translation>die Datei lässt sich nicht schreiben: %1</translation>
    </message>
    <message>
        <source>this is a folder, not a file</source>
        <translation>dies ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>this is not an ordinary file</source>
        <translation>dies ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>the folder of the file does not exist</source>
        <translation>den Ordner der Datei gibt es nicht</translation>
    </message>
</context>
<context>
    <name>detent::StrokeCurve</name>
    <message>
        <source>Give at least the start and the end of the curve</source>
        <translation>Geben Sie mindestens Anfang und Ende der Kurve an</translation>
    </message>
    <message>
        <source>Remove some of the points first</source>
        <translation>Entfernen Sie zuerst einige der Punkte</translation>
    </message>
    <message>
        <source>Give the curve two different displacements</source>
        <translation>Geben Sie der Kurve zwei verschiedene Wege</translation>
    </message>
    <message>
        <source>the curve has %1 points, but it needs at least 2</source>
        <translation>die Kurve hat %1 Punkte, sie braucht aber mindestens 2</translation>
    </message>
    <message>
        <source>the curve has %1 points, but at most %2 are allowed</source>
        <translation>die Kurve hat %1 Punkte, erlaubt sind aber höchstens %2</translation>
    </message>
    <message>
        <source>the curve has no travel, because all its points lie at %1</source>
        <translation>die Kurve hat keinen Weg, weil alle ihre Punkte bei %1 liegen</translation>
    </message>
</context>
<context>
    <name>detent::editor</name>
    <message>
        <source>Tactile point %1 of the press</source>
        <translation>Druckpunkt %1 des Hinwegs</translation>
    </message>
    <message>
        <source>Tactile point %1 of the release</source>
        <translation>Druckpunkt %1 des Rückwegs</translation>
    </message>
    <message>
        <source>Valley or peak %1 of the press</source>
        <translation>Tal oder Spitze %1 des Hinwegs</translation>
    </message>
    <message>
        <source>Valley or peak %1 of the release</source>
        <translation>Tal oder Spitze %1 des Rückwegs</translation>
    </message>
    <message>
        <source>Curve point %1 of the press</source>
        <translation>Kurvenpunkt %1 des Hinwegs</translation>
    </message>
    <message>
        <source>Curve point %1 of the release</source>
        <translation>Kurvenpunkt %1 des Rückwegs</translation>
    </message>
    <message>
        <source>Slope before curve point %1 of the press</source>
        <translation>Steigung vor Kurvenpunkt %1 des Hinwegs</translation>
    </message>
    <message>
        <source>Slope before curve point %1 of the release</source>
        <translation>Steigung vor Kurvenpunkt %1 des Rückwegs</translation>
    </message>
    <message>
        <source>Slope after curve point %1 of the press</source>
        <translation>Steigung nach Kurvenpunkt %1 des Hinwegs</translation>
    </message>
    <message>
        <source>Slope after curve point %1 of the release</source>
        <translation>Steigung nach Kurvenpunkt %1 des Rückwegs</translation>
    </message>
    <message>
        <source>Section %1 of the press</source>
        <translation>Abschnitt %1 des Hinwegs</translation>
    </message>
    <message>
        <source>Section %1 of the release</source>
        <translation>Abschnitt %1 des Rückwegs</translation>
    </message>
    <message>
        <source>Operating point</source>
        <translation>Schaltpunkt</translation>
    </message>
    <message>
        <source>Reset point</source>
        <translation>Rückschaltpunkt</translation>
    </message>
    <message>
        <source>%1 %2, %3 %4</source>
        <translation>%1 %2, %3 %4</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>traced point</source>
        <translation>abgelesener Punkt</translation>
    </message>
    <message>
        <source>other stroke</source>
        <translation>andere Kurve</translation>
    </message>
    <message>
        <source>press</source>
        <translation>Hinweg</translation>
    </message>
    <message>
        <source>release</source>
        <translation>Rückweg</translation>
    </message>
    <message>
        <source>%1: </source>
        <translation>%1: </translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>(limit of the device)</source>
        <translation>(Grenze des Geräts)</translation>
    </message>
    <message>
        <source>the falling jump %1 has a slope of %2</source>
        <translation>der fallende Sprung %1 hat die Steigung %2</translation>
    </message>
    <message>
        <source>the rise %1 has a slope of %2</source>
        <translation>der Anstieg %1 hat die Steigung %2</translation>
    </message>
    <message>
        <source>; the device can reproduce at most %1 without vibrating %2</source>
        <translation>; das Gerät kann höchstens %1 wiedergeben, ohne zu schwingen %2</translation>
    </message>
    <message>
        <source>Stable: the device can reproduce every slope. Smallest margin: %1.</source>
        <translation>Stabil: Das Gerät kann jede Steigung wiedergeben. Kleinste Reserve: %1.</translation>
    </message>
    <message>
        <source>At one place the button is too steep for the device, which would vibrate there.</source>
        <translation>An einer Stelle ist der Taster zu steil für das Gerät, das dort schwingen würde.</translation>
    </message>
    <message>
        <source>At %1 places the button is too steep for the device, which would vibrate there. The worst:</source>
        <translation>An %1 Stellen ist der Taster zu steil für das Gerät, das dort schwingen würde. Die ungünstigste:</translation>
    </message>
    <message>
        <source>the rise of %1 at %2 is reproduced as %3</source>
        <translation>der Anstieg von %1 bei %2 wird als %3 wiedergegeben</translation>
    </message>
    <message>
        <source>the fall of %1 at %2 is reproduced as %3</source>
        <translation>der Abfall von %1 bei %2 wird als %3 wiedergegeben</translation>
    </message>
    <message>
        <source>%1 exceeds the force of the device; %2 is reproduced</source>
        <translation>%1 übersteigt die Kraft des Geräts; wiedergegeben wird %2</translation>
    </message>
    <message>
        <source>the damping of %1 at %2 is reproduced as %3</source>
        <translation>die Dämpfung von %1 bei %2 wird als %3 wiedergegeben</translation>
    </message>
    <message>
        <source>forces %2 changed by up to %1</source>
        <translation>Kräfte %2 um bis zu %1 geändert</translation>
    </message>
    <message>
        <source>damping raised by up to %1</source>
        <translation>Dämpfung um bis zu %1 erhöht</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>Snap ratio × %1</source>
        <translation>Schnappverhältnis × %1</translation>
    </message>
    <message>
        <source>Travel × %1</source>
        <translation>Weg × %1</translation>
    </message>
    <message>
        <source>Force × %1</source>
        <translation>Kraft × %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>draw the plot frame, or drag its corners onto the ends of the axes</source>
        <translation>den Rahmen des Graphen zeichnen oder seine Ecken auf die Enden der Achsen ziehen</translation>
    </message>
    <message>
        <source>Draw plot frame</source>
        <translation>Rahmen zeichnen</translation>
    </message>
    <message>
        <source>enter the values at both ends of the displacement axis</source>
        <translation>die Werte an beiden Enden der Wegachse eingeben</translation>
    </message>
    <message>
        <source>Set axis values</source>
        <translation>Achsenwerte setzen</translation>
    </message>
    <message>
        <source>enter the values at both ends of the force axis</source>
        <translation>die Werte an beiden Enden der Kraftachse eingeben</translation>
    </message>
    <message>
        <source>choose the unit of the displacement axis</source>
        <translation>die Einheit der Wegachse wählen</translation>
    </message>
    <message>
        <source>Displacement unit</source>
        <translation>Wegeinheit</translation>
    </message>
    <message>
        <source>choose the unit of the force axis</source>
        <translation>die Einheit der Kraftachse wählen</translation>
    </message>
    <message>
        <source>Force unit</source>
        <translation>Krafteinheit</translation>
    </message>
    <message>
        <source>click the press curve on the page</source>
        <translation>auf der Seite die Hinwegkurve anklicken</translation>
    </message>
    <message>
        <source>Pick press curve</source>
        <translation>Hinwegkurve wählen</translation>
    </message>
    <message>
        <source>click the release curve on the page</source>
        <translation>auf der Seite die Rückwegkurve anklicken</translation>
    </message>
    <message>
        <source>Pick release curve</source>
        <translation>Rückwegkurve wählen</translation>
    </message>
    <message>
        <source>paint a mask over what is not part of a curve</source>
        <translation>mit einer Maske übermalen, was nicht zu einer Kurve gehört</translation>
    </message>
    <message>
        <source>Paint mask</source>
        <translation>Maske malen</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>swap press and release</source>
        <translation>Hinweg und Rückweg vertauschen</translation>
    </message>
    <message>
        <source>Swap press and release</source>
        <translation>Hinweg und Rückweg vertauschen</translation>
    </message>
    <message>
        <source>, or </source>
        <translation>, oder </translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>If that is wrong, </source>
        <translation>Wenn das falsch ist: </translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Press and release</source>
        <translation>Hinweg und Rückweg</translation>
    </message>
    <message>
        <source>Plot frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>Einlesen</translation>
    </message>
    <message>
        <source>finding the plot frame</source>
        <translation>Rahmen suchen</translation>
    </message>
    <message>
        <source>drawing the page</source>
        <translation>Seite zeichnen</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>reading texts</source>
        <translation>Texte lesen</translation>
    </message>
    <message>
        <source>comparing copies of the page</source>
        <translation>Kopien der Seite vergleichen</translation>
    </message>
    <message>
        <source>tracing</source>
        <translation>Ablesen</translation>
    </message>
    <message>
        <source>strokes</source>
        <translation>Kurven zuordnen</translation>
    </message>
    <message>
        <source>refined axes</source>
        <translation>Achsen verfeinern</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>reading callouts</source>
        <translation>Bezugslinien lesen</translation>
    </message>
    <message>
        <source>Reading the log …</source>
        <translation>Das Protokoll wird gelesen …</translation>
    </message>
    <message>
        <source>Finding the graph and reading its axes …</source>
        <translation>Graph und Achsen werden gelesen …</translation>
    </message>
    <message>
        <source>Tracing the curves …</source>
        <translation>Die Kurven werden abgelesen …</translation>
    </message>
    <message>
        <source>Identifying press and release …</source>
        <translation>Hinweg und Rückweg werden unterschieden …</translation>
    </message>
    <message>
        <source>Refining the axes …</source>
        <translation>Die Achsen werden verfeinert …</translation>
    </message>
    <message>
        <source>Fitting …</source>
        <translation>Die Kurven werden angepasst …</translation>
    </message>
    <message>
        <source>operating point</source>
        <translation>Schaltpunkt</translation>
    </message>
    <message>
        <source>reset point</source>
        <translation>Rückschaltpunkt</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Precise</source>
        <translation>Genau</translation>
    </message>
    <message>
        <source>%1 – fastest, error %2 % of the axis</source>
        <translation>%1 – am schnellsten, Fehler %2 % der Achse</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Curve that this command changes</source>
        <translation>Kurve, die dieser Befehl ändert</translation>
    </message>
    <message>
        <source>Add jump</source>
        <translation>Sprung hinzufügen</translation>
    </message>
    <message>
        <source>Adds a tactile point: from it, the force falls into a valley and then returns to the curve. On the release stroke, the force rises to a peak instead.</source>
        <translation>Fügt einen Druckpunkt hinzu: Von ihm fällt die Kraft in ein Tal und kehrt dann zur Kurve zurück. Auf dem Rückweg steigt sie stattdessen zu einer Spitze.</translation>
    </message>
    <message>
        <source>Tactile point at</source>
        <translation>Druckpunkt bei</translation>
    </message>
    <message>
        <source>Displacement of the tactile point</source>
        <translation>Weg des Druckpunkts</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Travel from the tactile point to where the jump rejoins the curve</source>
        <translation>Weg vom Druckpunkt bis dorthin, wo der Sprung die Kurve wieder erreicht</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Abfall</translation>
    </message>
    <message>
        <source>Force difference between tactile point and valley</source>
        <translation>Kraftunterschied zwischen Druckpunkt und Tal</translation>
    </message>
    <message>
        <source>Remove jump</source>
        <translation>Sprung entfernen</translation>
    </message>
    <message>
        <source>The tactile point and its jump become a straight line.</source>
        <translation>Druckpunkt und Sprung werden zu einer Geraden.</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>Make linear</source>
        <translation>Linear machen</translation>
    </message>
    <message>
        <source>Replaces the curve by a straight line from the start to the bottom-out. The bottom-out stays.</source>
        <translation>Ersetzt die Kurve durch eine Gerade vom Anfang bis zum Anschlag. Der Anschlag bleibt.</translation>
    </message>
    <message>
        <source>Mirror press to release</source>
        <translation>Hinweg zum Rückweg spiegeln</translation>
    </message>
    <message>
        <source>How far the release lies below the press</source>
        <translation>Wie weit der Rückweg unter dem Hinweg liegt</translation>
    </message>
    <message>
        <source>Remove release curve</source>
        <translation>Rückweg entfernen</translation>
    </message>
    <message>
        <source>The release will follow the press curve.</source>
        <translation>Der Rückweg folgt dann der Hinwegkurve.</translation>
    </message>
    <message>
        <source>Scale force</source>
        <translation>Kraft skalieren</translation>
    </message>
    <message>
        <source>Scales all forces of all states, and the damping with them.</source>
        <translation>Skaliert alle Kräfte aller Zustände und die Dämpfung mit ihnen.</translation>
    </message>
    <message>
        <source>Highest force</source>
        <translation>Höchste Kraft</translation>
    </message>
    <message>
        <source>Highest force of this state after scaling</source>
        <translation>Größte Kraft dieses Zustands nach dem Skalieren</translation>
    </message>
    <message>
        <source>Scale travel</source>
        <translation>Weg skalieren</translation>
    </message>
    <message>
        <source>Scales all displacements of all states, including operating and reset points.</source>
        <translation>Skaliert alle Wege aller Zustände, auch Schalt- und Rückschaltpunkt.</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Snap ratio</source>
        <translation>Schnappverhältnis</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>Refit curve</source>
        <translation>Kurve neu anpassen</translation>
    </message>
    <message>
        <source>Fits the curves to the traced points again, with as many pieces as you choose. Replaces changes made by hand.</source>
        <translation>Passt die Kurven mit der gewählten Zahl von Stücken neu an die abgelesenen Punkte an. Ersetzt Änderungen von Hand.</translation>
    </message>
    <message>
        <source>Pieces of the press curve</source>
        <translation>Stücke der Hinwegkurve</translation>
    </message>
    <message>
        <source>More pieces follow the points more closely; fewer are easier to edit</source>
        <translation>Mehr Stücke folgen den Punkten genauer, weniger lassen sich leichter bearbeiten</translation>
    </message>
    <message>
        <source>Pieces of the release curve</source>
        <translation>Stücke der Rückwegkurve</translation>
    </message>
    <message>
        <source>Operating and reset point</source>
        <translation>Schalt- und Rückschaltpunkt</translation>
    </message>
    <message>
        <source>Where the contact closes on the press stroke, and where it opens on the release stroke.</source>
        <translation>Wo der Kontakt auf dem Hinweg schließt und wo er auf dem Rückweg öffnet.</translation>
    </message>
    <message>
        <source>Closes at</source>
        <translation>Schließt bei</translation>
    </message>
    <message>
        <source>Displacement on the press stroke</source>
        <translation>Weg auf dem Hinweg</translation>
    </message>
    <message>
        <source>Opens at</source>
        <translation>Öffnet bei</translation>
    </message>
    <message>
        <source>Displacement on the release stroke</source>
        <translation>Weg auf dem Rückweg</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Adds a force proportional to velocity, for force feedback devices. Edit it in the damping view.</source>
        <translation>Fügt eine Kraft im Verhältnis zur Geschwindigkeit hinzu, für Geräte mit Kraftrückmeldung. Bearbeiten Sie sie in der Dämpfungsansicht.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Am Anfang</translation>
    </message>
    <message>
        <source>Damping in N·s/mm at 0 mm</source>
        <translation>Dämpfung in N·s/mm bei 0 mm</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>Am Ende</translation>
    </message>
    <message>
        <source>Damping in N·s/mm at the end of the travel</source>
        <translation>Dämpfung in N·s/mm am Ende des Wegs</translation>
    </message>
    <message>
        <source>Two-level button</source>
        <translation>Zweistufiger Taster</translation>
    </message>
    <message>
        <source>Replaces the curves of this state by a button with two tactile points. The second one is stronger, as on a camera&apos;s shutter button.</source>
        <translation>Ersetzt die Kurven dieses Zustands durch einen Taster mit zwei Druckpunkten. Der zweite ist stärker, wie beim Auslöser einer Kamera.</translation>
    </message>
    <message>
        <source>Self-locking button</source>
        <translation>Rastender Taster</translation>
    </message>
    <message>
        <source>Replaces the button by one with two states: one press locks it down, the next press releases it.</source>
        <translation>Ersetzt den Taster durch einen mit zwei Zuständen: Einmal gedrückt, rastet er unten ein; noch einmal gedrückt, löst er sich.</translation>
    </message>
    <message>
        <source>Lock at</source>
        <translation>Rastet bei</translation>
    </message>
    <message>
        <source>Where the locked button rests; between its valley and the end of the travel</source>
        <translation>Wo der eingerastete Taster ruht; zwischen seinem Tal und dem Ende des Wegs</translation>
    </message>
    <message>
        <source>Add state</source>
        <translation>Zustand hinzufügen</translation>
    </message>
    <message>
        <source>The button becomes self-locking: its two states alternate at each actuation. The new state starts as a copy of this one.</source>
        <translation>Der Taster wird rastend: Seine beiden Zustände wechseln bei jeder Betätigung. Der neue Zustand beginnt als Kopie von diesem.</translation>
    </message>
    <message>
        <source>Remove state</source>
        <translation>Zustand entfernen</translation>
    </message>
    <message>
        <source>Removes this state. The button keeps its other state and becomes momentary.</source>
        <translation>Entfernt diesen Zustand. Der Taster behält den anderen Zustand und wird zum Taster ohne Verriegelung.</translation>
    </message>
    <message>
        <source>The field is empty. Type for example %1.</source>
        <translation>Das Feld ist leer. Geben Sie zum Beispiel %1 ein.</translation>
    </message>
    <message>
        <source>“%1” is not a number. Type for example %2, or +5, or -10 %.</source>
        <translation>„%1“ ist keine Zahl. Geben Sie zum Beispiel %2 ein, oder +5, oder -10 %.</translation>
    </message>
    <message>
        <source>“%1” can be read in two ways. Type the number without spaces or separators between thousands.</source>
        <translation>„%1“ lässt sich auf zwei Weisen lesen. Geben Sie die Zahl ohne Leerzeichen und ohne Tausendertrennzeichen ein.</translation>
    </message>
    <message>
        <source>“%1” is not a unit for this value. Type the number alone.</source>
        <translation>„%1“ ist keine Einheit für diesen Wert. Geben Sie die Zahl allein ein.</translation>
    </message>
    <message>
        <source>“%1” is not a known unit. Type for example %2.</source>
        <translation>„%1“ ist keine bekannte Einheit. Geben Sie zum Beispiel %2 ein.</translation>
    </message>
    <message>
        <source>“%1” has a unit. Type a number without a unit.</source>
        <translation>„%1“ hat eine Einheit. Geben Sie eine Zahl ohne Einheit ein.</translation>
    </message>
    <message>
        <source>The unit in “%1” does not suit this field. Type a number in %2.</source>
        <translation>Die Einheit in „%1“ passt nicht zu diesem Feld. Geben Sie eine Zahl in %2 ein.</translation>
    </message>
    <message>
        <source>“%1” is relative to the present value, but the field is empty. Type a value, for example %2.</source>
        <translation>„%1“ ist relativ zum jetzigen Wert, aber das Feld ist leer. Geben Sie einen Wert ein, zum Beispiel %2.</translation>
    </message>
    <message>
        <source>“%1” is not a whole number. Type a number without decimals.</source>
        <translation>„%1“ ist keine ganze Zahl. Geben Sie eine Zahl ohne Nachkommastellen ein.</translation>
    </message>
    <message>
        <source>Change: %1</source>
        <translation>Ändern: %1</translation>
    </message>
    <message>
        <source>Move: %1</source>
        <translation>Verschieben: %1</translation>
    </message>
    <message>
        <source>Remove: %1</source>
        <translation>Entfernen: %1</translation>
    </message>
    <message>
        <source>at %2, the force changes with speed like a damping of %1; the device reproduces %3</source>
        <translation>bei %2 ändert sich die Kraft mit der Geschwindigkeit wie eine Dämpfung von %1; das Gerät gibt %3 wieder</translation>
    </message>
    <message>
        <source>at %2, the change of force with speed adds energy (%1); the device reproduces %3</source>
        <translation>bei %2 führt die Änderung der Kraft mit der Geschwindigkeit Energie zu (%1); das Gerät gibt %3 wieder</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message>
        <source>Import the file with File &gt; Import a datasheet</source>
        <translation>Importieren Sie die Datei mit Datei &gt; Ein Datenblatt importieren</translation>
    </message>
    <message>
        <source>Choose a smaller size for the picture</source>
        <translation>Wählen Sie eine kleinere Bildgröße</translation>
    </message>
    <message>
        <source>Export a PNG instead</source>
        <translation>Exportieren Sie stattdessen eine PNG</translation>
    </message>
    <message>
        <source>Export an SVG instead</source>
        <translation>Exportieren Sie stattdessen eine SVG</translation>
    </message>
    <message>
        <source>Copy the picture again, or save it to a file and open the file</source>
        <translation>Kopieren Sie das Bild noch einmal, oder speichern Sie es in eine Datei und öffnen Sie diese</translation>
    </message>
    <message>
        <source>Create a release first: Edit &gt; Curve &gt; Mirror press to release</source>
        <translation>Erzeugen Sie zuerst einen Rückweg: Bearbeiten &gt; Kurve &gt; Hinweg zum Rückweg spiegeln</translation>
    </message>
    <message>
        <source>slope handle</source>
        <translation>Steigungsgriff</translation>
    </message>
    <message>
        <source>Keep the handle left of the curve point</source>
        <translation>Lassen Sie den Griff links vom Kurvenpunkt</translation>
    </message>
    <message>
        <source>Keep the handle right of the curve point</source>
        <translation>Lassen Sie den Griff rechts vom Kurvenpunkt</translation>
    </message>
    <message>
        <source>Select a curve point, a tactile point, or the operating or reset point</source>
        <translation>Wählen Sie einen Kurvenpunkt, einen Druckpunkt, den Schaltpunkt oder den Rückschaltpunkt</translation>
    </message>
    <message>
        <source>Select the points again</source>
        <translation>Die Punkte noch einmal wählen</translation>
    </message>
    <message>
        <source>Select three or more points; the outer two stay in place</source>
        <translation>Wählen Sie drei oder mehr Punkte; die beiden äußeren bleiben</translation>
    </message>
    <message>
        <source>%1 is more than 100 %. Press Enter again to keep it.</source>
        <translation>%1 ist mehr als 100 %. Drücken Sie noch einmal die Eingabetaste, um den Wert zu behalten.</translation>
    </message>
    <message>
        <source>%1 is less than 1 %. Did you mean %2? Press Enter again to keep it.</source>
        <translation>%1 ist weniger als 1 %. Meinten Sie %2? Drücken Sie noch einmal die Eingabetaste, um den Wert zu behalten.</translation>
    </message>
    <message>
        <source>draw along the whole press curve</source>
        <translation>die ganze Hinwegkurve nachziehen</translation>
    </message>
    <message>
        <source>choose a switch in the list</source>
        <translation>einen Taster in der Liste wählen</translation>
    </message>
    <message>
        <source>Choose switch</source>
        <translation>Taster wählen</translation>
    </message>
    <message>
        <source>To set the point, right-click its place on the curve.</source>
        <translation>Um den Punkt zu setzen, klicken Sie mit der rechten Maustaste auf seine Stelle der Kurve.</translation>
    </message>
    <message>
        <source>piece between curve points %1 and %2</source>
        <translation>Stück zwischen den Kurvenpunkten %1 und %2</translation>
    </message>
    <message>
        <source>Add a curve point there (K) and move the new point</source>
        <translation>Fügen Sie dort einen Kurvenpunkt hinzu (K) und verschieben Sie den neuen Punkt</translation>
    </message>
    <message>
        <source>Draw press curve</source>
        <translation>Hinwegkurve zeichnen</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>operating %1</source>
        <translation>schaltet %1</translation>
    </message>
    <message>
        <source>reset %1</source>
        <translation>schaltet zurück %1</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <source>set</source>
        <translation>gesetzt</translation>
    </message>
    <message>
        <source>Give every number in “%1” a unit.</source>
        <translation>Geben Sie jeder Zahl in „%1“ eine Einheit.</translation>
    </message>
    <message>
        <source>%1 is unusually high. Press Enter again to keep it.</source>
        <translation>%1 ist ungewöhnlich hoch. Drücken Sie noch einmal die Eingabetaste, um den Wert zu behalten.</translation>
    </message>
    <message>
        <source>%1 is unusually high. Did you mean %2? Press Enter again to keep %1.</source>
        <translation>%1 ist ungewöhnlich hoch. Meinten Sie %2? Drücken Sie noch einmal die Eingabetaste, um %1 zu behalten.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>pre-travel</source>
        <translation>Vorlaufweg</translation>
    </message>
    <message>
        <source>differential</source>
        <translation>Differenzweg</translation>
    </message>
    <message>
        <source>slope %1</source>
        <translation>Steigung %1</translation>
    </message>
    <message>
        <source>their mean</source>
        <translation>ihr Mittel</translation>
    </message>
    <message>
        <source>it is the release</source>
        <translation>es ist das Loslassen</translation>
    </message>
    <message>
        <source>%1? %2</source>
        <translation>%1? %2</translation>
    </message>
    <message>
        <source>%1 – takes %2 times as long as a draft, error %3 % of the axis</source>
        <translation>%1 – %2 Mal die Zeit eines Entwurfs, Fehler %3 % der Achse</translation>
    </message>
    <message>
        <source>“%1” is too large, or divides by zero. Type another number.</source>
        <translation>„%1“ ist zu groß oder teilt durch null. Geben Sie eine andere Zahl ein.</translation>
    </message>
    <message>
        <source>specimens ± standard deviation</source>
        <translation>Exemplare ± Standardabweichung</translation>
    </message>
    <message>
        <source>to change from press to release, this device would need %1 of travel; it has only %2, so it may vibrate</source>
        <translation>um vom Hinweg zum Rückweg zu wechseln, brauchte dieses Gerät %1 Weg; es hat nur %2 und kann daher vibrieren</translation>
    </message>
    <message>
        <source>this file is a page to import, not a button</source>
        <translation>diese Datei ist eine Seite zum Importieren, kein Taster</translation>
    </message>
    <message>
        <source>the picture cannot be saved as a PNG</source>
        <translation>das Bild lässt sich nicht als PNG speichern</translation>
    </message>
    <message>
        <source>the picture cannot be drawn</source>
        <translation>das Bild lässt sich nicht zeichnen</translation>
    </message>
    <message>
        <source>the folder cannot be created: %1</source>
        <translation>der Ordner lässt sich nicht anlegen: %1</translation>
    </message>
    <message>
        <source>Choose another folder or another name</source>
        <translation>Wählen Sie einen anderen Ordner oder einen anderen Namen</translation>
    </message>
    <message>
        <source>the graph could not be drawn</source>
        <translation>der Graph ließ sich nicht zeichnen</translation>
    </message>
    <message>
        <source>Detent wrote this file before it ended unexpectedly; you can delete it</source>
        <translation>Detent hat diese Datei geschrieben, bevor es unerwartet endete; Sie können sie löschen</translation>
    </message>
    <message>
        <source>the file is not a recovery file: %1</source>
        <translation>die Datei ist keine Wiederherstellungsdatei: %1</translation>
    </message>
    <message>
        <source>the file is not a recovery file: its format is not detent-recovery</source>
        <translation>die Datei ist keine Wiederherstellungsdatei: Ihr Format ist nicht detent-recovery</translation>
    </message>
    <message>
        <source>the recovery file has version %1, but only version 1 can be read</source>
        <translation>die Wiederherstellungsdatei hat Version %1, lesbar ist aber nur Version 1</translation>
    </message>
    <message>
        <source>which switch should be read</source>
        <translation>welcher Schalter soll gelesen werden</translation>
    </message>
    <message>
        <source>which recording should be read</source>
        <translation>welche Aufzeichnung soll gelesen werden</translation>
    </message>
    <message>
        <source>what is the unit of force</source>
        <translation>welche Einheit hat die Kraft</translation>
    </message>
    <message>
        <source>what is the unit of displacement</source>
        <translation>welche Einheit hat der Weg</translation>
    </message>
    <message>
        <source>what do the columns measure</source>
        <translation>was messen die Spalten</translation>
    </message>
    <message>
        <source>which columns hold displacement and force</source>
        <translation>welche Spalten enthalten Weg und Kraft</translation>
    </message>
    <message>
        <source>which column holds the force</source>
        <translation>welche Spalte enthält die Kraft</translation>
    </message>
    <message>
        <source>which column holds the displacement</source>
        <translation>welche Spalte enthält den Weg</translation>
    </message>
    <message>
        <source>does the second column of forces hold the release</source>
        <translation>enthält die zweite Spalte mit Kräften den Rückweg</translation>
    </message>
    <message>
        <source>it is another recording</source>
        <translation>sie ist eine andere Aufzeichnung</translation>
    </message>
    <message>
        <source>the clipboard holds no picture</source>
        <translation>die Zwischenablage enthält kein Bild</translation>
    </message>
    <message>
        <source>the graph has no release curve to paste into</source>
        <translation>der Graph hat keinen Rückweg, in den sich einfügen ließe</translation>
    </message>
    <message>
        <source>the handle would move to the other side of its curve point</source>
        <translation>der Griff käme auf die andere Seite seines Kurvenpunkts</translation>
    </message>
    <message>
        <source>this piece is vertical</source>
        <translation>dieses Stück ist senkrecht</translation>
    </message>
    <message>
        <source>this piece would get an extra peak or valley</source>
        <translation>dieses Stück bekäme eine zusätzliche Spitze oder ein zusätzliches Tal</translation>
    </message>
    <message>
        <source>this element cannot be removed on its own</source>
        <translation>dieses Element lässt sich nicht allein entfernen</translation>
    </message>
    <message>
        <source>one of the selected curve points no longer exists</source>
        <translation>einen der ausgewählten Kurvenpunkte gibt es nicht mehr</translation>
    </message>
    <message>
        <source>fewer than two curve points are selected</source>
        <translation>es sind weniger als zwei Kurvenpunkte ausgewählt</translation>
    </message>
    <message>
        <source>Select two or more curve points; the others are aligned with the last one</source>
        <translation>Wählen Sie zwei oder mehr Kurvenpunkte aus; die anderen werden am letzten ausgerichtet</translation>
    </message>
    <message>
        <source>fewer than three curve points of one stroke are selected</source>
        <translation>es sind weniger als drei Kurvenpunkte eines Hubs ausgewählt</translation>
    </message>
    <message>
        <source>(limited by the damping of the device)</source>
        <translation>(begrenzt durch die Dämpfung des Geräts)</translation>
    </message>
    <message>
        <source>(limited by the friction and the encoder steps of the device)</source>
        <translation>(begrenzt durch Reibung und Encoderschritte des Geräts)</translation>
    </message>
    <message>
        <source>at %2, the release lies up to %1 above the press and would add energy; there, the device uses the release curve for both strokes</source>
        <translation>bei %2 liegt der Rückweg um bis zu %1 über dem Hinweg und würde Energie zuführen; dort nimmt das Gerät für beide Hübe den Rückweg</translation>
    </message>
    <message>
        <source>at %2, the release at one speed lies up to %1 above the press at another and would add energy; there, the device uses this release curve for the press as well</source>
        <translation>bei %2 liegt der Rückweg einer Geschwindigkeit um bis zu %1 über dem Hinweg einer anderen und würde Energie zuführen; dort nimmt das Gerät diesen Rückweg auch für den Hinweg</translation>
    </message>
    <message>
        <source>choose a resolution; Detent then traces the page as a picture</source>
        <translation>eine Auflösung wählen; Detent liest die Seite dann als Bild ab</translation>
    </message>
    <message>
        <source>The release becomes a copy of the press curve, lowered by this force. Where the press force is below twice of it, the copy is lowered by less.</source>
        <translation>Der Rückweg wird eine Kopie der Hinwegkurve, um diese Kraft gesenkt. Wo die Kraft des Hinwegs unter ihrem Doppelten liegt, wird die Kopie weniger gesenkt.</translation>
    </message>
    <message>
        <source>Release lower by</source>
        <translation>Rückweg tiefer um</translation>
    </message>
    <message>
        <source>Usual: 20 % for a soft key, 60 % for a snappy dome</source>
        <translation>Üblich: 20 % für eine weiche Taste, 60 % für eine knackige Schnappscheibe</translation>
    </message>
    <message>
        <source>(Peak force − valley force) / peak force. The tactile point stays, the valley moves.</source>
        <translation>(Spitzenkraft − Talkraft) / Spitzenkraft. Der Druckpunkt bleibt, das Tal wandert.</translation>
    </message>
    <message>
        <source>say that the page shows no release of this button</source>
        <translation>angeben, dass die Seite keinen Rückweg dieses Tasters zeigt</translation>
    </message>
    <message>
        <source>No release curve</source>
        <translation>Keine Rückwegkurve</translation>
    </message>
    <message>
        <source>which curves are press and release</source>
        <translation>welche Kurven sind Hinweg und Rückweg</translation>
    </message>
    <message>
        <source>which curve is the release</source>
        <translation>welche Kurve ist der Rückweg</translation>
    </message>
    <message>
        <source>this button has no release</source>
        <translation>dieser Taster hat keinen Rückweg</translation>
    </message>
    <message>
        <source>draw along the whole release curve</source>
        <translation>die ganze Rückwegkurve nachziehen</translation>
    </message>
    <message>
        <source>Draw release curve</source>
        <translation>Rückwegkurve zeichnen</translation>
    </message>
</context>
<context>
    <name>detent::editor::AddJumpTool</name>
    <message>
        <source>Hold the mouse button where the jump begins, on a rising part of a curve. Then drag the valley into place.</source>
        <translation>Halten Sie die Maustaste, wo der Sprung beginnt, auf einem steigenden Teil einer Kurve. Ziehen Sie dann das Tal an seine Stelle.</translation>
    </message>
    <message>
        <source>There is no curve here. Start nearer to one.</source>
        <translation>Hier ist keine Kurve. Beginnen Sie näher an einer Kurve.</translation>
    </message>
    <message>
        <source>Add jump</source>
        <translation>Sprung hinzufügen</translation>
    </message>
</context>
<context>
    <name>detent::editor::AddKnotTool</name>
    <message>
        <source>Click a curve to add a curve point. Keep the button down to move the new point.</source>
        <translation>Klicken Sie auf eine Kurve, um einen Kurvenpunkt zu setzen. Halten Sie die Taste, um den neuen Punkt zu verschieben.</translation>
    </message>
    <message>
        <source>There is no curve here. Click nearer to one.</source>
        <translation>Hier ist keine Kurve. Klicken Sie näher an einer Kurve.</translation>
    </message>
    <message>
        <source>Add curve point</source>
        <translation>Kurvenpunkt hinzufügen</translation>
    </message>
</context>
<context>
    <name>detent::editor::AdjustTool</name>
    <message>
        <source>Move plot frame</source>
        <translation>Rahmen verschieben</translation>
    </message>
    <message>
        <source>Move displacement tick</source>
        <translation>Teilstrich der Wegachse verschieben</translation>
    </message>
    <message>
        <source>Move force tick</source>
        <translation>Teilstrich der Kraftachse verschieben</translation>
    </message>
    <message>
        <source>Move mask</source>
        <translation>Maske verschieben</translation>
    </message>
    <message>
        <source>Remove mask</source>
        <translation>Maske entfernen</translation>
    </message>
    <message>
        <source>Remove tick</source>
        <translation>Teilstrich entfernen</translation>
    </message>
    <message>
        <source>Drag the %1 of the plot frame, or use the arrow keys (Shift: 10 times the step, Alt: a tenth). Ctrl keeps the frame rectangular.</source>
        <translation>Ziehen Sie am Rahmen (%1), oder verwenden Sie die Pfeiltasten (Umschalt: zehnfacher Schritt, Alt: ein Zehntel). Strg hält den Rahmen rechteckig.</translation>
    </message>
    <message>
        <source>Move point</source>
        <translation>Punkt bewegen</translation>
    </message>
    <message>
        <source>Remove this point</source>
        <translation>Diesen Punkt entfernen</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>Punkt entfernen</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Set operating point here</source>
        <translation>Schaltpunkt hier setzen</translation>
    </message>
    <message>
        <source>Set reset point here</source>
        <translation>Rückschaltpunkt hier setzen</translation>
    </message>
    <message>
        <source>Set tactile point of the press here</source>
        <translation>Druckpunkt des Hinwegs hier setzen</translation>
    </message>
    <message>
        <source>Set tactile point of the release here</source>
        <translation>Druckpunkt des Rückwegs hier setzen</translation>
    </message>
    <message>
        <source>Drag corners and edges of the plot frame, ticks, or points of the curve. Right-click to add a point. Double-click a tick to type its value. Tab selects the next element, arrow keys move it, Delete removes it.</source>
        <translation>Ziehen Sie Ecken und Kanten des Rahmens, Teilstriche oder Punkte der Kurve. Ein Rechtsklick fügt einen Punkt hinzu. Ein Doppelklick auf einen Teilstrich öffnet die Eingabe seines Werts. Tab wählt das nächste Element, Pfeiltasten verschieben es, Entf entfernt es.</translation>
    </message>
</context>
<context>
    <name>detent::editor::AdviceBar</name>
    <message>
        <source>Message about the import</source>
        <translation>Meldung zum Import</translation>
    </message>
    <message>
        <source>Which unit is the displacement axis in?</source>
        <translation>Welche Einheit hat die Wegachse?</translation>
    </message>
    <message>
        <source>Which unit is the force axis in?</source>
        <translation>Welche Einheit hat die Kraftachse?</translation>
    </message>
    <message>
        <source>None of these: another quantity</source>
        <translation>Keine davon: eine andere Größe</translation>
    </message>
</context>
<context>
    <name>detent::editor::AnnotationsPanel</name>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versionen</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Created</source>
        <translation>Erstellt am</translation>
    </message>
    <message>
        <source>Note for the selected point. Press Enter to add the note.</source>
        <translation>Notiz zum gewählten Punkt. Die Eingabetaste fügt die Notiz hinzu.</translation>
    </message>
    <message>
        <source>New note</source>
        <translation>Neue Notiz</translation>
    </message>
    <message>
        <source>Name under which the present state of the button is kept. Press Enter to add the version.</source>
        <translation>Name, unter dem der jetzige Stand des Tasters behalten wird. Die Eingabetaste fügt die Version hinzu.</translation>
    </message>
    <message>
        <source>Name of the version</source>
        <translation>Name der Version</translation>
    </message>
    <message>
        <source>New note at the selected point</source>
        <translation>Neue Notiz am gewählten Punkt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected note</source>
        <translation>Die gewählte Notiz entfernen</translation>
    </message>
    <message>
        <source>Remove a note</source>
        <translation>Notiz entfernen</translation>
    </message>
    <message>
        <source>Version name…</source>
        <translation>Name der Version …</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Restore the button to the selected version</source>
        <translation>Den Taster auf die gewählte Version zurücksetzen</translation>
    </message>
    <message>
        <source>Open in new tab</source>
        <translation>In neuem Reiter öffnen</translation>
    </message>
    <message>
        <source>Open the selected version as a new button, to compare it</source>
        <translation>Die gewählte Version als neuen Taster öffnen, um sie zu vergleichen</translation>
    </message>
    <message>
        <source>Remove the selected version</source>
        <translation>Die gewählte Version entfernen</translation>
    </message>
    <message>
        <source>Remove a version</source>
        <translation>Version entfernen</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verknüpfungen</translation>
    </message>
    <message>
        <source>Unlock all</source>
        <translation>Alle entsperren</translation>
    </message>
    <message>
        <source>Unlock all points, so that they can be moved again</source>
        <translation>Alle Punkte entsperren, damit sie sich wieder bewegen lassen</translation>
    </message>
    <message>
        <source>Select a point first; the note will be attached to it.</source>
        <translation>Wählen Sie zuerst einen Punkt; die Notiz wird an ihm befestigt.</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Notiz: %1</translation>
    </message>
    <message>
        <source>There is a version called “%1” already. Give this one another name.</source>
        <translation>Es gibt schon eine Version namens „%1“. Geben Sie dieser einen anderen Namen.</translation>
    </message>
    <message>
        <source>Add version: %1</source>
        <translation>Version hinzufügen: %1</translation>
    </message>
    <message>
        <source>Restore version: %1</source>
        <translation>Version wiederherstellen: %1</translation>
    </message>
    <message>
        <source>Change a note</source>
        <translation>Notiz ändern</translation>
    </message>
    <message>
        <source>Rename a version</source>
        <translation>Version umbenennen</translation>
    </message>
    <message>
        <source>press</source>
        <translation>Hinweg</translation>
    </message>
    <message>
        <source>release</source>
        <translation>Rückweg</translation>
    </message>
    <message>
        <source>No locked points. Press P to lock the selected one.</source>
        <translation>Keine gesperrten Punkte. P sperrt den gewählten.</translation>
    </message>
    <message>
        <source>Locked points: %1</source>
        <translation>Gesperrte Punkte: %1</translation>
    </message>
    <message>
        <source>Moving the end of one stroke also moves the ends of all strokes in all states</source>
        <translation>Wird das Ende eines Hubs verschoben, verschieben sich die Enden aller Hübe aller Zustände mit</translation>
    </message>
    <message>
        <source>&amp;Release follows press, lower by</source>
        <translation>&amp;Rückweg folgt Hinweg, tiefer um</translation>
    </message>
    <message>
        <source>Edits of the press also move the release. The release keeps its shape.</source>
        <translation>Änderungen des Hinwegs verschieben auch den Rückweg. Der Rückweg behält seine Form.</translation>
    </message>
    <message>
        <source>How far the release lies below the press on average. Another value moves the whole release up or down.</source>
        <translation>Wie weit der Rückweg im Mittel unter dem Hinweg liegt. Ein anderer Wert hebt oder senkt den ganzen Rückweg.</translation>
    </message>
    <message>
        <source>Lower the release</source>
        <translation>Rückweg senken</translation>
    </message>
    <message>
        <source>Change links</source>
        <translation>Verknüpfungen ändern</translation>
    </message>
    <message>
        <source>All strokes e&amp;nd at the same travel</source>
        <translation>Alle Hübe enden beim selben W&amp;eg</translation>
    </message>
</context>
<context>
    <name>detent::editor::AverageDialog</name>
    <message>
        <source>Buttons to average</source>
        <translation>Taster für das Mittel</translation>
    </message>
    <message>
        <source>Average buttons</source>
        <translation>Taster mitteln</translation>
    </message>
    <message>
        <source>&amp;Create</source>
        <translation>&amp;Erstellen</translation>
    </message>
    <message>
        <source>Opens the average in a new tab</source>
        <translation>Öffnet das Mittel in einem neuen Reiter</translation>
    </message>
    <message>
        <source>Average which buttons?</source>
        <translation>Welche Taster mitteln?</translation>
    </message>
    <message>
        <source>“%1” and “%2” differ in states or tactile points. Average buttons of one kind.</source>
        <translation>„%1“ und „%2“ haben verschieden viele Zustände oder Druckpunkte. Mitteln Sie Taster einer Art.</translation>
    </message>
    <message>
        <source>Tick two or more buttons.</source>
        <translation>Haken Sie zwei oder mehr Taster an.</translation>
    </message>
</context>
<context>
    <name>detent::editor::AxisBox</name>
    <message>
        <source>Reset displacement axis</source>
        <translation>Wegachse zurücksetzen</translation>
    </message>
    <message>
        <source>Reset force axis</source>
        <translation>Kraftachse zurücksetzen</translation>
    </message>
    <message>
        <source>Reset displacement unit</source>
        <translation>Wegeinheit zurücksetzen</translation>
    </message>
    <message>
        <source>Reset force unit</source>
        <translation>Krafteinheit zurücksetzen</translation>
    </message>
    <message>
        <source>Displacement at the left edge of the plot frame</source>
        <translation>Weg an der linken Kante des Rahmens</translation>
    </message>
    <message>
        <source>Force at the lower edge of the plot frame</source>
        <translation>Kraft an der unteren Kante des Rahmens</translation>
    </message>
    <message>
        <source>Displacement at the right edge of the plot frame</source>
        <translation>Weg an der rechten Kante des Rahmens</translation>
    </message>
    <message>
        <source>Force at the upper edge of the plot frame</source>
        <translation>Kraft an der oberen Kante des Rahmens</translation>
    </message>
    <message>
        <source>Unit of the displacement axis as printed</source>
        <translation>Einheit der Wegachse, wie gedruckt</translation>
    </message>
    <message>
        <source>Unit of the force axis as printed</source>
        <translation>Einheit der Kraftachse, wie gedruckt</translation>
    </message>
    <message>
        <source>, in the printed unit</source>
        <translation>, in der gedruckten Einheit</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>Set on page…</source>
        <translation>Auf Seite setzen …</translation>
    </message>
    <message>
        <source>Click ticks of the axis on the page and type their values</source>
        <translation>Teilstriche der Achse auf der Seite anklicken und ihre Werte eingeben</translation>
    </message>
    <message>
        <source>Range:</source>
        <translation>Bereich:</translation>
    </message>
    <message>
        <source>Unit:</source>
        <translation>Einheit:</translation>
    </message>
    <message>
        <source>Displacement unit</source>
        <translation>Wegeinheit</translation>
    </message>
    <message>
        <source>Force unit</source>
        <translation>Krafteinheit</translation>
    </message>
    <message>
        <source>Displacement range</source>
        <translation>Wegbereich</translation>
    </message>
    <message>
        <source>Force range</source>
        <translation>Kraftbereich</translation>
    </message>
    <message>
        <source>Displacement in the file</source>
        <translation>Weg in der Datei</translation>
    </message>
    <message>
        <source>Displacement axis (horizontal)</source>
        <translation>Wegachse (waagerecht)</translation>
    </message>
    <message>
        <source>Force in the file</source>
        <translation>Kraft in der Datei</translation>
    </message>
    <message>
        <source>Force axis (vertical)</source>
        <translation>Kraftachse (senkrecht)</translation>
    </message>
    <message>
        <source>as printed</source>
        <translation>wie gedruckt</translation>
    </message>
    <message>
        <source>not printed, a guess</source>
        <translation>nicht gedruckt, geraten</translation>
    </message>
    <message>
        <source>1 tick set; set one more to define the axis</source>
        <translation>1 Teilstrich gesetzt; setzen Sie noch einen, um die Achse festzulegen</translation>
    </message>
    <message>
        <source>%1 ticks set</source>
        <translation>%1 Teilstriche gesetzt</translation>
    </message>
    <message>
        <source>titled “%1”</source>
        <translation>beschriftet „%1“</translation>
    </message>
    <message>
        <source>Some tick labels of this axis lie outside the plot frame. Move the edge of the frame to include them</source>
        <translation>Einige Zahlen dieser Achse liegen außerhalb des Rahmens. Verschieben Sie die Kante des Rahmens, um sie einzuschließen</translation>
    </message>
    <message>
        <source>Extend the plot frame from %1 to %2</source>
        <translation>Rahmen von %1 bis %2 erweitern</translation>
    </message>
    <message>
        <source>Extend plot frame</source>
        <translation>Rahmen erweitern</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Left and right have the same value. Type the value printed at each end.</source>
        <translation>Links und rechts steht derselbe Wert. Geben Sie den Wert ein, der an jedem Ende gedruckt ist.</translation>
    </message>
    <message>
        <source>Bottom and top have the same value. Type the value printed at each end.</source>
        <translation>Unten und oben steht derselbe Wert. Geben Sie den Wert ein, der an jedem Ende gedruckt ist.</translation>
    </message>
    <message>
        <source>Displacement grows:</source>
        <translation>Der Weg nimmt zu:</translation>
    </message>
    <message>
        <source>Force grows:</source>
        <translation>Die Kraft nimmt zu:</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>upwards</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>downwards</source>
        <translation>nach unten</translation>
    </message>
    <message>
        <source>Direction of the axis</source>
        <translation>Richtung der Achse</translation>
    </message>
    <message>
        <source>1 tick set</source>
        <translation>1 Teilstrich gesetzt</translation>
    </message>
    <message>
        <source>%1 of %2 printed numbers agree with your values</source>
        <translation>%1 von %2 gedruckten Zahlen stimmen mit Ihren Werten überein</translation>
    </message>
    <message>
        <source>%1 of %2 printed numbers used (deviation %3 px)</source>
        <translation>%1 von %2 gedruckten Zahlen verwendet (Abweichung %3 px)</translation>
    </message>
</context>
<context>
    <name>detent::editor::BatchDialog</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Abgelehnt</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Results of the batch</source>
        <translation>Ergebnisse des Stapels</translation>
    </message>
    <message>
        <source>Files finished</source>
        <translation>Fertige Dateien</translation>
    </message>
    <message>
        <source>Import many files</source>
        <translation>Viele Dateien importieren</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Liest …</translation>
    </message>
    <message>
        <source>Choose &amp;files…</source>
        <translation>&amp;Dateien wählen …</translation>
    </message>
    <message>
        <source>Choose files to import; they replace those in the list</source>
        <translation>Dateien zum Importieren wählen; sie ersetzen die in der Liste</translation>
    </message>
    <message>
        <source>Choose a f&amp;older…</source>
        <translation>&amp;Ordner wählen …</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Stop; finished files keep their results</source>
        <translation>Anhalten; fertige Dateien behalten ihre Ergebnisse</translation>
    </message>
    <message>
        <source>Open in the &amp;import dialogue</source>
        <translation>Im &amp;Importdialog öffnen</translation>
    </message>
    <message>
        <source>Open &amp;buttons</source>
        <translation>&amp;Taster öffnen</translation>
    </message>
    <message>
        <source>Open the selected buttons in tabs</source>
        <translation>Die gewählten Taster in Reitern öffnen</translation>
    </message>
    <message>
        <source>&amp;Save buttons…</source>
        <translation>Taster &amp;speichern …</translation>
    </message>
    <message>
        <source>Save the selected buttons in a folder, or all if none is selected</source>
        <translation>Die gewählten Taster in einem Ordner speichern; ist keiner gewählt, alle</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Page %1, graph %2</source>
        <translation>Seite %1, Graph %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Saved %1 of %2 buttons. %3</source>
        <translation>%1 von %2 Tastern gespeichert. %3</translation>
    </message>
    <message>
        <source>Buttons saved in %2: %1.</source>
        <translation>In %2 gespeicherte Taster: %1.</translation>
    </message>
    <message>
        <source>Choose files or a folder. Every graph in them is imported in the background.</source>
        <translation>Wählen Sie Dateien oder einen Ordner. Jeder Graph darin wird im Hintergrund importiert.</translation>
    </message>
    <message>
        <source>Import all datasheets, pictures and tables in a folder and its subfolders</source>
        <translation>Alle Datenblätter, Bilder und Tabellen eines Ordners und seiner Unterordner importieren</translation>
    </message>
    <message>
        <source>No datasheet, picture or table was found in %1.</source>
        <translation>In %1 wurde kein Datenblatt, kein Bild und keine Tabelle gefunden.</translation>
    </message>
    <message>
        <source>Check what was found on the page, answer the question, or correct the result</source>
        <translation>Auf der Seite prüfen, was gefunden wurde, die Frage beantworten oder das Ergebnis korrigieren</translation>
    </message>
    <message>
        <source>, checked</source>
        <translation>, geprüft</translation>
    </message>
    <message>
        <source>%1 of %2 files. Buttons: %3 (to check: %4), questions: %5, refused: %6.</source>
        <translation>%1 von %2 Dateien. Taster: %3 (zu prüfen: %4), Fragen: %5, abgelehnt: %6.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>switch %1</source>
        <translation>Taster %1</translation>
    </message>
</context>
<context>
    <name>detent::editor::BatchImport</name>
    <message>
        <source>The file needs more memory than is available.</source>
        <translation>Die Datei braucht mehr Speicher, als verfügbar ist.</translation>
    </message>
    <message>
        <source>The program that reads files crashed on this one, or did not finish.</source>
        <translation>Das Programm, das Dateien liest, ist an dieser abgestürzt oder nicht fertig geworden.</translation>
    </message>
</context>
<context>
    <name>detent::editor::ButtonDocument</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Reload from disk</source>
        <translation>Vom Datenträger neu laden</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>detent::editor::ChecksPanel</name>
    <message>
        <source>Problems and warnings of the button</source>
        <translation>Probleme und Warnungen zum Taster</translation>
    </message>
    <message>
        <source>No problems found.</source>
        <translation>Keine Probleme gefunden.</translation>
    </message>
    <message>
        <source>Click a problem, or press Enter, to go to its place</source>
        <translation>Ein Klick auf ein Problem oder die Eingabetaste führt zu seiner Stelle</translation>
    </message>
</context>
<context>
    <name>detent::editor::ComparePanel</name>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Overlaid force graphs</source>
        <translation>Die Kraftgraphen übereinander</translation>
    </message>
    <message>
        <source>Point at the graph to read values. Click to set a cursor and read differences from there.</source>
        <translation>Zeigen Sie auf den Graphen, um Werte abzulesen. Ein Klick setzt einen Zeiger, von dem aus Sie Unterschiede ablesen.</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>&amp;Differenz</translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation>&amp;Bild …</translation>
    </message>
    <message>
        <source>Save the graphs with their names as PNG, SVG or PDF</source>
        <translation>Die Graphen mit ihren Namen als PNG, SVG oder PDF speichern</translation>
    </message>
    <message>
        <source>C&amp;opy the picture</source>
        <translation>Bild k&amp;opieren</translation>
    </message>
    <message>
        <source>Copy the graphs with their names as a picture</source>
        <translation>Die Graphen mit ihren Namen als Bild kopieren</translation>
    </message>
    <message>
        <source>S&amp;wap</source>
        <translation>&amp;Tauschen</translation>
    </message>
    <message>
        <source>Copy the &amp;table</source>
        <translation>Tabelle &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the differences as CSV, in the units shown</source>
        <translation>Die Unterschiede als CSV kopieren, in den gezeigten Einheiten</translation>
    </message>
    <message>
        <source>Button %1 of the comparison</source>
        <translation>Taster %1 des Vergleichs</translation>
    </message>
    <message>
        <source>Button %1</source>
        <translation>Taster %1</translation>
    </message>
    <message>
        <source>State of a self-locking button to compare</source>
        <translation>Zustand eines rastenden Tasters, der verglichen wird</translation>
    </message>
    <message>
        <source>State of button %1</source>
        <translation>Zustand von Taster %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>%1 − %2</source>
        <translation>%1 − %2</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Show differences from the first button below the graph</source>
        <translation>Unterschiede zum ersten Taster unter dem Graphen zeigen</translation>
    </message>
    <message>
        <source>&amp;Add button</source>
        <translation>Taster &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Overlay another open button</source>
        <translation>Einen weiteren offenen Taster darüberlegen</translation>
    </message>
    <message>
        <source>&amp;Remove button</source>
        <translation>Taster &amp;entfernen</translation>
    </message>
    <message>
        <source>Remove the last button</source>
        <translation>Den letzten Taster entfernen</translation>
    </message>
    <message>
        <source>Swap the first two buttons; differences change their sign</source>
        <translation>Die ersten beiden Taster tauschen; Unterschiede wechseln das Vorzeichen</translation>
    </message>
    <message>
        <source>Comparison table</source>
        <translation>Vergleichstabelle</translation>
    </message>
    <message>
        <source>A comparison needs a second button. Choose where it comes from:</source>
        <translation>Ein Vergleich braucht einen zweiten Taster. Woher soll er kommen?</translation>
    </message>
</context>
<context>
    <name>detent::editor::ComparePlot</name>
    <message>
        <source>Displacement (%1)</source>
        <translation>Weg (%1)</translation>
    </message>
    <message>
        <source>Force (%1)</source>
        <translation>Kraft (%1)</translation>
    </message>
    <message>
        <source>%1 press %2, release %3</source>
        <translation>%1 Hinweg %2, Rückweg %3</translation>
    </message>
    <message>
        <source>At %1: %2 (%3)</source>
        <translation>Bei %1: %2 (%3)</translation>
    </message>
    <message>
        <source>%1 press %2</source>
        <translation>%1 Hinweg %2</translation>
    </message>
    <message>
        <source>Difference from the pinned cursor: %1; %2</source>
        <translation>Unterschied zum angehefteten Zeiger: %1; %2</translation>
    </message>
    <message>
        <source>Difference (%1)</source>
        <translation>Differenz (%1)</translation>
    </message>
</context>
<context>
    <name>detent::editor::CurvesBox</name>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Swap press and release</source>
        <translation>Hinweg und Rückweg vertauschen</translation>
    </message>
    <message>
        <source>Press curve…</source>
        <translation>Hinweg …</translation>
    </message>
    <message>
        <source>Release curve…</source>
        <translation>Rückweg …</translation>
    </message>
    <message>
        <source>Click the press curve on the page</source>
        <translation>Klicken Sie auf der Seite die Hinwegkurve an</translation>
    </message>
    <message>
        <source>Click the release curve on the page</source>
        <translation>Klicken Sie auf der Seite die Rückwegkurve an</translation>
    </message>
    <message>
        <source>Reset press curve</source>
        <translation>Hinwegkurve zurücksetzen</translation>
    </message>
    <message>
        <source>Reset release curve</source>
        <translation>Rückwegkurve zurücksetzen</translation>
    </message>
    <message>
        <source>Mask…</source>
        <translation>Maske …</translation>
    </message>
    <message>
        <source>Drag rectangles over parts that are not a curve</source>
        <translation>Rechtecke über Teile ziehen, die keine Kurve sind</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Alle entfernen</translation>
    </message>
    <message>
        <source>Remove masks</source>
        <translation>Masken entfernen</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Resolution of the page picture that is traced, in dots per inch</source>
        <translation>Auflösung des Seitenbilds, das abgelesen wird, in Punkten je Zoll</translation>
    </message>
    <message>
        <source>Reset resolution</source>
        <translation>Auflösung zurücksetzen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>1 area masked</source>
        <translation>1 Bereich maskiert</translation>
    </message>
    <message>
        <source>%1 areas masked</source>
        <translation>%1 Bereiche maskiert</translation>
    </message>
</context>
<context>
    <name>detent::editor::DampingView</name>
    <message>
        <source>Damping over displacement</source>
        <translation>Dämpfung über dem Weg</translation>
    </message>
    <message>
        <source>Drag points to move them. Double-click the line to add a point; Delete removes the selected one.</source>
        <translation>Ziehen Sie Punkte, um sie zu verschieben. Ein Doppelklick auf die Linie setzt einen Punkt, Entf entfernt den gewählten.</translation>
    </message>
    <message>
        <source>Damping point %1: %2, %3</source>
        <translation>Dämpfungspunkt %1: %2, %3</translation>
    </message>
    <message>
        <source>Move damping point %1</source>
        <translation>Dämpfungspunkt %1 verschieben</translation>
    </message>
    <message>
        <source>Add damping point</source>
        <translation>Dämpfungspunkt hinzufügen</translation>
    </message>
    <message>
        <source>Remove damping point %1</source>
        <translation>Dämpfungspunkt %1 entfernen</translation>
    </message>
</context>
<context>
    <name>detent::editor::DeviceExportDialog</name>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>Largest timing error: %1 ms; pulses merged: %2; frequencies shifted by up to %3 Hz</source>
        <translation>Größter Zeitfehler: %1 ms; zusammengefasste Impulse: %2; Frequenzen um bis zu %3 Hz verschoben</translation>
    </message>
    <message>
        <source>The format cannot hold the whole press: the end of the press is cut off. The file states where.</source>
        <translation>Das Format fasst nicht die ganze Betätigung: Das Ende der Betätigung ist abgeschnitten. Die Datei gibt an, wo.</translation>
    </message>
    <message>
        <source>Samples per second</source>
        <translation>Abtastwerte je Sekunde</translation>
    </message>
    <message>
        <source>Number of bits per sample</source>
        <translation>Anzahl der Bits je Abtastwert</translation>
    </message>
    <message>
        <source>bits</source>
        <translation>Bit</translation>
    </message>
    <message>
        <source>Duration of the press stroke</source>
        <translation>Dauer des Hinwegs</translation>
    </message>
    <message>
        <source>Export for a device</source>
        <translation>Für ein Gerät exportieren</translation>
    </message>
    <message>
        <source>&amp;Device:</source>
        <translation>&amp;Gerät:</translation>
    </message>
    <message>
        <source>Press &amp;stroke duration:</source>
        <translation>&amp;Dauer des Hinwegs:</translation>
    </message>
    <message>
        <source>&amp;Rate:</source>
        <translation>&amp;Rate:</translation>
    </message>
    <message>
        <source>&amp;Bits:</source>
        <translation>&amp;Bits:</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Choose a location and write the file</source>
        <translation>Speicherort wählen und die Datei schreiben</translation>
    </message>
    <message>
        <source>Share of the vibration&apos;s energy that the export keeps: %1</source>
        <translation>Anteil der Energie der Vibration, den der Export behält: %1</translation>
    </message>
    <message>
        <source>Format or device for which the press is exported</source>
        <translation>Format oder Gerät, für das die Betätigung exportiert wird</translation>
    </message>
</context>
<context>
    <name>detent::editor::DisplacementForceView</name>
    <message>
        <source>Displacement over force</source>
        <translation>Weg über der Kraft</translation>
    </message>
    <message>
        <source>The travel at each force, as a finger that sets the force feels it. Jumps appear as vertical lines.</source>
        <translation>Der Weg bei jeder Kraft, wie ihn ein Finger fühlt, der die Kraft vorgibt. Sprünge erscheinen als senkrechte Linien.</translation>
    </message>
</context>
<context>
    <name>detent::editor::DocumentTab</name>
    <message>
        <source>Select a point to type its values.</source>
        <translation>Wählen Sie einen Punkt, um seine Werte einzugeben.</translation>
    </message>
</context>
<context>
    <name>detent::editor::DrawCurveTool</name>
    <message>
        <source>Click points along the press curve, or draw along it. Press Enter or double-click to finish. To correct part of a traced curve, draw over that part.</source>
        <translation>Klicken Sie Punkte entlang der Hinwegkurve, oder zeichnen Sie an ihr entlang. Beenden Sie mit der Eingabetaste oder einem Doppelklick. Um einen Teil einer abgelesenen Kurve zu berichtigen, zeichnen Sie über diesen Teil.</translation>
    </message>
    <message>
        <source>Click points along the release curve, or draw along it. Press Enter or double-click to finish. To correct part of a traced curve, draw over that part.</source>
        <translation>Klicken Sie Punkte entlang der Rückwegkurve, oder zeichnen Sie an ihr entlang. Beenden Sie mit der Eingabetaste oder einem Doppelklick. Um einen Teil einer abgelesenen Kurve zu berichtigen, zeichnen Sie über diesen Teil.</translation>
    </message>
    <message>
        <source>Draw press curve</source>
        <translation>Hinwegkurve zeichnen</translation>
    </message>
    <message>
        <source>Draw release curve</source>
        <translation>Rückwegkurve zeichnen</translation>
    </message>
</context>
<context>
    <name>detent::editor::DrawFrameTool</name>
    <message>
        <source>Draw plot frame</source>
        <translation>Rahmen zeichnen</translation>
    </message>
    <message>
        <source>Drag across the area in which the curves are drawn, from corner to corner. Over the current plot frame, the new one replaces it; elsewhere, it adds a graph. Edges snap to lines close to them; Ctrl draws freely.</source>
        <translation>Ziehen Sie über den Bereich, in dem die Kurven gezeichnet sind, von Ecke zu Ecke. Über dem aktuellen Rahmen ersetzt der neue diesen; an anderer Stelle kommt ein Graph hinzu. Die Kanten rasten an nahen Linien ein; mit Strg zeichnen Sie frei.</translation>
    </message>
</context>
<context>
    <name>detent::editor::ExperimenterDialog</name>
    <message>
        <source>Study: experimenter</source>
        <translation>Studie: Versuchsleitung</translation>
    </message>
    <message>
        <source>&amp;New study…</source>
        <translation>&amp;Neue Studie …</translation>
    </message>
    <message>
        <source>Create a study with the open buttons</source>
        <translation>Eine Studie mit den offenen Tastern anlegen</translation>
    </message>
    <message>
        <source>&amp;Open a study…</source>
        <translation>Studie &amp;öffnen …</translation>
    </message>
    <message>
        <source>Choose the folder of a study</source>
        <translation>Den Ordner einer Studie wählen</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Versuchspersonen</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Versuchsperson</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>Beantwortet</translation>
    </message>
    <message>
        <source>Answers by</source>
        <translation>Antworten von</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Use letters, digits, - and _, not a person&apos;s name. Participants in the list continue with the question that they had reached</source>
        <translation>Verwenden Sie Buchstaben, Ziffern, - und _, keinen Personennamen. Wer in der Liste steht, macht bei der zuletzt erreichten Frage weiter</translation>
    </message>
    <message>
        <source>Rehearsals and simulated answers are marked in every row and on every page of the report</source>
        <translation>Probeläufe und simulierte Antworten sind in jeder Zeile und auf jeder Seite des Berichts gekennzeichnet</translation>
    </message>
    <message>
        <source>a person, with the sound device</source>
        <translation>eine Person, mit dem Audiogerät</translation>
    </message>
    <message>
        <source>nobody: a rehearsal without a sound device</source>
        <translation>niemand: ein Probelauf ohne Audiogerät</translation>
    </message>
    <message>
        <source>the program, guessing</source>
        <translation>das Programm, durch Raten</translation>
    </message>
    <message>
        <source>the program, always correct</source>
        <translation>das Programm, immer richtig</translation>
    </message>
    <message>
        <source>What the participant hears; recorded with every answer</source>
        <translation>Was die Versuchsperson hört; wird mit jeder Antwort gespeichert</translation>
    </message>
    <message>
        <source>quiet</source>
        <translation>still</translation>
    </message>
    <message>
        <source>masked by rain noise</source>
        <translation>durch Regengeräusch maskiert</translation>
    </message>
    <message>
        <source>Sound device of the headphones that play rain noise; turn up the volume until the vibration is inaudible</source>
        <translation>Audiogerät der Kopfhörer für das Regengeräusch; erhöhen Sie die Lautstärke, bis die Vibration nicht mehr zu hören ist</translation>
    </message>
    <message>
        <source>Serial port of a force sensor under the finger, calibrated by the study&apos;s device profile. If empty, participants press with keys or large on-screen buttons</source>
        <translation>Serieller Anschluss eines Kraftsensors unter dem Finger, kalibriert durch das Geräteprofil der Studie. Wenn leer, wird mit Tasten oder großen Schaltflächen gedrückt</translation>
    </message>
    <message>
        <source>Next &amp;participant:</source>
        <translation>Nächste &amp;Versuchsperson:</translation>
    </message>
    <message>
        <source>&amp;Answers by:</source>
        <translation>&amp;Antworten von:</translation>
    </message>
    <message>
        <source>&amp;Listening condition:</source>
        <translation>&amp;Hörbedingung:</translation>
    </message>
    <message>
        <source>&amp;Headphones:</source>
        <translation>&amp;Kopfhörer:</translation>
    </message>
    <message>
        <source>Force &amp;sensor:</source>
        <translation>Kraft&amp;sensor:</translation>
    </message>
    <message>
        <source>&amp;Begin or continue</source>
        <translation>&amp;Beginnen oder fortsetzen</translation>
    </message>
    <message>
        <source>Open the participant&apos;s window, or let the program answer</source>
        <translation>Das Fenster für die Versuchsperson öffnen, oder das Programm antworten lassen</translation>
    </message>
    <message>
        <source>Write the &amp;report…</source>
        <translation>Be&amp;richt schreiben …</translation>
    </message>
    <message>
        <source>Write tables and pictures of the answers so far as one HTML page</source>
        <translation>Tabellen und Bilder der bisherigen Antworten als eine HTML-Seite schreiben</translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation>Studie öffnen</translation>
    </message>
    <message>
        <source>Create a new study with the open buttons, or open the folder of an existing one.</source>
        <translation>Legen Sie eine neue Studie mit den offenen Tastern an, oder öffnen Sie den Ordner einer vorhandenen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: %2. Questions for each participant: %3</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: %2. Fragen an jede Versuchsperson: %3</translation>
    </message>
    <message>
        <source>A participant is answering. Finish or pause the session in the participant&apos;s window first.</source>
        <translation>Eine Versuchsperson antwortet gerade. Beenden oder unterbrechen Sie die Sitzung zuerst in deren Fenster.</translation>
    </message>
    <message>
        <source>%1 Or choose a rehearsal.</source>
        <translation>%1 Oder wählen Sie einen Probelauf.</translation>
    </message>
    <message>
        <source>%1 has answered everything.</source>
        <translation>%1 hat alles beantwortet.</translation>
    </message>
    <message>
        <source>The program answers…</source>
        <translation>Das Programm antwortet …</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Webseite (*.html)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Language of all texts that the participant reads</source>
        <translation>Sprache aller Texte für die Versuchsperson</translation>
    </message>
    <message>
        <source>The participant&apos;s window fills this screen; choose another one to keep this window visible</source>
        <translation>Das Fenster der Versuchsperson füllt diesen Bildschirm; auf einem anderen bleibt dieses Fenster sichtbar</translation>
    </message>
    <message>
        <source>Participant&apos;s lan&amp;guage:</source>
        <translation>S&amp;prache der Versuchsperson:</translation>
    </message>
    <message>
        <source>Participant&apos;s s&amp;creen:</source>
        <translation>Bil&amp;dschirm der Versuchsperson:</translation>
    </message>
    <message>
        <source>%1 is answering.</source>
        <translation>%1 antwortet gerade.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 answered; %4</source>
        <translation>%1: %2 von %3 beantwortet; %4</translation>
    </message>
    <message>
        <source>force device of the Feel panel</source>
        <translation>Kraftgerät des Bereichs „Fühlen“</translation>
    </message>
    <message>
        <source>Participants press and feel the buttons on this device. Choose it in the Feel panel under Setup</source>
        <translation>Die Versuchspersonen drücken und fühlen die Taster auf diesem Gerät. Wählen Sie es im Bereich „Fühlen“ unter „Einrichtung“</translation>
    </message>
    <message>
        <source>none is chosen</source>
        <translation>keines ist gewählt</translation>
    </message>
    <message>
        <source>Choose a force device in the Feel panel under Setup</source>
        <translation>Wählen Sie ein Kraftgerät im Bereich „Fühlen“ unter „Einrichtung“</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>reading the consent text</source>
        <translation>liest den Einwilligungstext</translation>
    </message>
    <message>
        <source>reading the instructions</source>
        <translation>liest die Anleitung</translation>
    </message>
    <message>
        <source>answering a question</source>
        <translation>beantwortet eine Frage</translation>
    </message>
    <message>
        <source>resting</source>
        <translation>ruht sich aus</translation>
    </message>
    <message>
        <source>pausing</source>
        <translation>macht Pause</translation>
    </message>
    <message>
        <source>waiting for you: a device was disconnected</source>
        <translation>wartet auf Sie: ein Gerät wurde getrennt</translation>
    </message>
    <message>
        <source>finished, waiting for you</source>
        <translation>fertig, wartet auf Sie</translation>
    </message>
    <message>
        <source>if empty: the sound device of the vibration, on the channels after those of the vibration</source>
        <translation>wenn leer: das Audiogerät der Vibration, auf den Kanälen nach denen der Vibration</translation>
    </message>
</context>
<context>
    <name>detent::editor::ExportController</name>
    <message>
        <source>Not exported: %1</source>
        <translation>Nicht exportiert: %1</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>%1 exportiert</translation>
    </message>
    <message>
        <source>Export samples</source>
        <translation>Kurvenwerte exportieren</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG-Zeichnung</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>PNG-Bild</translation>
    </message>
    <message>
        <source>Export the vibration of a press</source>
        <translation>Die Vibration einer Betätigung exportieren</translation>
    </message>
    <message>
        <source>WAV sound</source>
        <translation>WAV-Klang</translation>
    </message>
    <message>
        <source>Share as web page</source>
        <translation>Als Webseite teilen</translation>
    </message>
    <message>
        <source>Web page</source>
        <translation>Webseite</translation>
    </message>
    <message>
        <source>Export for a device</source>
        <translation>Für ein Gerät exportieren</translation>
    </message>
    <message>
        <source>PDF document</source>
        <translation>PDF-Dokument</translation>
    </message>
    <message>
        <source>Export the graph</source>
        <translation>Graphen exportieren</translation>
    </message>
    <message>
        <source>Export as a data package</source>
        <translation>Als Datenpaket exportieren</translation>
    </message>
    <message>
        <source>Folder of a data package</source>
        <translation>Ordner eines Datenpakets</translation>
    </message>
    <message>
        <source>Export for WebPlotDigitizer</source>
        <translation>Für WebPlotDigitizer exportieren</translation>
    </message>
    <message>
        <source>Project with its picture</source>
        <translation>Projekt mit seinem Bild</translation>
    </message>
    <message>
        <source>Project without a picture</source>
        <translation>Projekt ohne Bild</translation>
    </message>
    <message>
        <source>Export the comparison</source>
        <translation>Vergleich exportieren</translation>
    </message>
    <message>
        <source>Samples at given travels</source>
        <translation>Kurvenwerte an bestimmten Stellen</translation>
    </message>
    <message>
        <source>Step, or travels separated by spaces or semicolons, in %1:</source>
        <translation>Schrittweite oder Wege, durch Leerzeichen oder Semikolons getrennt, in %1:</translation>
    </message>
    <message>
        <source>Export for a magnetic keyboard</source>
        <translation>Für eine Magnettastatur exportieren</translation>
    </message>
    <message>
        <source>C header</source>
        <translation>C-Header</translation>
    </message>
    <message>
        <source>%1, %2 and %3</source>
        <translation>%1, %2 und %3</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>CSV with semicolons</source>
        <translation>CSV mit Strichpunkten</translation>
    </message>
</context>
<context>
    <name>detent::editor::FeelPanel</name>
    <message>
        <source>Feel</source>
        <translation>Fühlen</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Einrichtung</translation>
    </message>
    <message>
        <source>Set up pad, feedback, devices and force sensor</source>
        <translation>Feld, Rückmeldung, Geräte und Kraftsensor einrichten</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Press the other button (A or B)</source>
        <translation>Den anderen Taster drücken (A oder B)</translation>
    </message>
    <message>
        <source>Standard press</source>
        <translation>Standardbetätigung</translation>
    </message>
    <message>
        <source>Show and play a standard press: 120 ms down, 80 ms held, 100 ms up</source>
        <translation>Eine Standardbetätigung zeigen und abspielen: 120 ms hinunter, 80 ms gehalten, 100 ms hinauf</translation>
    </message>
    <message>
        <source>My last press</source>
        <translation>Meine letzte Betätigung</translation>
    </message>
    <message>
        <source>Show and play your own last press. It is repeated on A, on B and after every edit, so that all are pressed in the same way</source>
        <translation>Ihre letzte Betätigung zeigen und abspielen. Sie wird auf A, auf B und nach jeder Änderung wiederholt, damit alle gleich gedrückt werden</translation>
    </message>
    <message>
        <source>Play the press shown</source>
        <translation>Gezeigte Betätigung abspielen</translation>
    </message>
    <message>
        <source>Send the press shown to the sound device; no finger is needed</source>
        <translation>Die gezeigte Betätigung an das Audiogerät senden; kein Finger ist nötig</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Spielen</translation>
    </message>
    <message>
        <source>Press %1</source>
        <translation>%1 drücken</translation>
    </message>
    <message>
        <source>No button is open</source>
        <translation>Kein Taster ist offen</translation>
    </message>
    <message>
        <source>Choose a second button to compare with</source>
        <translation>Wählen Sie einen zweiten Taster zum Vergleich</translation>
    </message>
    <message>
        <source>This button cannot be pressed: %1</source>
        <translation>Dieser Taster lässt sich nicht drücken: %1</translation>
    </message>
    <message>
        <source>This build of Detent has no live playback, so the pad cannot be pressed. The vibration is shown below.</source>
        <translation>Dieses Detent ist ohne Live-Wiedergabe gebaut, daher lässt sich das Feld nicht drücken. Die Vibration ist unten gezeigt.</translation>
    </message>
    <message>
        <source>Sound, force and setup</source>
        <translation>Ton, Kraft und Einrichtung</translation>
    </message>
    <message>
        <source>Compare with a signal of another program: AHAP, .haptic, HJIF, WAV</source>
        <translation>Mit dem Signal eines anderen Programms vergleichen: AHAP, .haptic, HJIF, WAV</translation>
    </message>
    <message>
        <source>Play the reference</source>
        <translation>Vergleichssignal abspielen</translation>
    </message>
    <message>
        <source>Play the reference on the sound device, at the same gain as the press; click again to stop</source>
        <translation>Das Vergleichssignal auf dem Audiogerät abspielen, mit derselben Verstärkung wie die Betätigung; ein weiterer Klick beendet es</translation>
    </message>
    <message>
        <source>Remove the reference</source>
        <translation>Vergleichssignal entfernen</translation>
    </message>
    <message>
        <source>Reference signal</source>
        <translation>Vergleichssignal</translation>
    </message>
    <message>
        <source>Signals (*.ahap *.haptic *.hjif *.wav *.flac *.aiff *.ogg);;All files (*)</source>
        <translation>Signale (*.ahap *.haptic *.hjif *.wav *.flac *.aiff *.ogg);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Compare with a reference…</source>
        <translation>Mit Vergleichssignal vergleichen …</translation>
    </message>
    <message>
        <source>Reference: %1</source>
        <translation>Vergleich: %1</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Switch between A and B while pressing. Both are played at their true strength, without loudness matching.</source>
        <translation>Beim Drücken zwischen A und B wechseln. Beide werden in wahrer Stärke gespielt, ohne Angleich der Lautheit.</translation>
    </message>
</context>
<context>
    <name>detent::editor::FeelSession</name>
    <message>
        <source>Only one press can be played at a time</source>
        <translation>Es kann immer nur eine Betätigung abgespielt werden</translation>
    </message>
    <message>
        <source>Switch the sound on to play a press</source>
        <translation>Schalten Sie den Ton ein, um eine Betätigung abzuspielen</translation>
    </message>
    <message>
        <source>Switch the sound on to play the reference</source>
        <translation>Schalten Sie den Ton ein, um die Referenz abzuspielen</translation>
    </message>
    <message>
        <source>You are pressing %1 at its true strength</source>
        <translation>Sie drücken %1 in wahrer Stärke</translation>
    </message>
</context>
<context>
    <name>detent::editor::FeelSetup</name>
    <message>
        <source>How mouse and touch press the pad. Keys always play a timed press; a pen presses by its pressure.</source>
        <translation>Wie Maus und Berührung das Feld drücken. Tasten spielen immer eine zeitgesteuerte Betätigung ab; ein Stift drückt mit seinem Druck.</translation>
    </message>
    <message>
        <source>Hold: a human-like press</source>
        <translation>Halten: eine Betätigung wie von Hand</translation>
    </message>
    <message>
        <source>Drag down: depth</source>
        <translation>Nach unten ziehen: Tiefe</translation>
    </message>
    <message>
        <source>Drag down: force</source>
        <translation>Nach unten ziehen: Kraft</translation>
    </message>
    <message>
        <source>&amp;Press with mouse:</source>
        <translation>&amp;Drücken mit der Maus:</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Force at the end of a timed press, at full pen pressure, or at the end of a drag. Automatic: a quarter more than the button&apos;s strongest force.</source>
        <translation>Kraft am Ende einer zeitgesteuerten Betätigung, bei vollem Stiftdruck oder am Ende des Ziehens. Automatisch: ein Viertel mehr als die größte Kraft des Tasters.</translation>
    </message>
    <message>
        <source>&amp;Full press:</source>
        <translation>&amp;Volle Betätigung:</translation>
    </message>
    <message>
        <source>Which parts of the button are felt; reduced feedback serves as a baseline for comparison.</source>
        <translation>Welche Teile des Tasters zu fühlen sind; reduzierte Rückmeldung dient als Vergleich.</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Clicks only (jumps, bottom-out)</source>
        <translation>Nur Klicks (Sprünge, Anschlag)</translation>
    </message>
    <message>
        <source>Slopes only (vibration pulses)</source>
        <translation>Nur Steigungen (Vibrationsimpulse)</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>F&amp;eedback:</source>
        <translation>&amp;Rückmeldung:</translation>
    </message>
    <message>
        <source>Even: constant delay for every event</source>
        <translation>Gleichmäßig: feste Verzögerung für jedes Ereignis</translation>
    </message>
    <message>
        <source>Events are played with a constant delay after the finger passed them.</source>
        <translation>Ereignisse werden mit fester Verzögerung gespielt, nachdem der Finger sie überschritt.</translation>
    </message>
    <message>
        <source>Fast: every event as early as possible</source>
        <translation>Schnell: jedes Ereignis so früh wie möglich</translation>
    </message>
    <message>
        <source>Events are played as soon as the sensor shows them: earlier on average, but less evenly.</source>
        <translation>Ereignisse werden gespielt, sobald der Sensor sie zeigt: im Mittel früher, aber weniger gleichmäßig.</translation>
    </message>
    <message>
        <source>Timing:</source>
        <translation>Zeitverhalten:</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>Play as for an ideal device</source>
        <translation>Wiedergabe wie für ein ideales Gerät</translation>
    </message>
    <message>
        <source>&amp;Device profile:</source>
        <translation>&amp;Geräteprofil:</translation>
    </message>
    <message>
        <source>Sound device that drives the transducer</source>
        <translation>Audiogerät, das den Wandler treibt</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Neu suchen</translation>
    </message>
    <message>
        <source>Search for sound devices again</source>
        <translation>Noch einmal nach Audiogeräten suchen</translation>
    </message>
    <message>
        <source>&amp;Sound device:</source>
        <translation>&amp;Audiogerät:</translation>
    </message>
    <message>
        <source>Sample rate in Hz</source>
        <translation>Abtastrate in Hz</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Samples per buffer: smaller is faster, larger is safer against drop-outs</source>
        <translation>Abtastwerte je Puffer: Kleiner ist schneller, größer ist sicherer gegen Aussetzer</translation>
    </message>
    <message>
        <source>chosen by the system</source>
        <translation>vom System gewählt</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 Abtastwerte</translation>
    </message>
    <message>
        <source>Sample &amp;rate:</source>
        <translation>A&amp;btastrate:</translation>
    </message>
    <message>
        <source>&amp;Buffer:</source>
        <translation>Pu&amp;ffer:</translation>
    </message>
    <message>
        <source>Serial port of the force sensor, for example /dev/ttyACM0</source>
        <translation>Serieller Anschluss des Kraftsensors, zum Beispiel /dev/ttyACM0</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Press with the force sensor, as calibrated in the device profile</source>
        <translation>Mit dem Kraftsensor drücken, wie im Geräteprofil kalibriert</translation>
    </message>
    <message>
        <source>Force se&amp;nsor:</source>
        <translation>Kraft&amp;sensor:</translation>
    </message>
    <message>
        <source>Ba&amp;ud rate:</source>
        <translation>Ba&amp;udrate:</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Default output</source>
        <translation>Standardausgabe</translation>
    </message>
    <message>
        <source>Default output (%1)</source>
        <translation>Standardausgabe (%1)</translation>
    </message>
    <message>
        <source>output channels: %1, %2 Hz</source>
        <translation>Ausgabekanäle: %1, %2 Hz</translation>
    </message>
    <message>
        <source>%1 (not connected)</source>
        <translation>%1 (nicht angeschlossen)</translation>
    </message>
    <message>
        <source>Looking for sound devices…</source>
        <translation>Audiogeräte werden gesucht …</translation>
    </message>
    <message>
        <source>No sound device was found. Connect one or start the sound server, then search again.</source>
        <translation>Kein Audiogerät gefunden. Schließen Sie eines an oder starten Sie den Audioserver, dann suchen Sie neu.</translation>
    </message>
    <message>
        <source>measured %1</source>
        <translation>gemessen %1</translation>
    </message>
    <message>
        <source>Delay from the moment the force passes a threshold to the first sound sample. Measured with a 425 Hz sensor and a JACK server, without converter, amplifier and transducer (docs/measurements/bench-playback.md)</source>
        <translation>Verzögerung vom Überschreiten einer Kraftschwelle bis zum ersten Tonwert. Gemessen mit einem Sensor von 425 Hz und einem JACK-Server, ohne Wandler, Verstärker und Umsetzer (docs/measurements/bench-playback.md)</translation>
    </message>
    <message>
        <source>%1: </source>
        <translation>%1: </translation>
    </message>
    <message>
        <source>resonances: %1, equalizer bands: %2</source>
        <translation>Resonanzen: %1, Bänder des Entzerrers: %2</translation>
    </message>
    <message>
        <source>; sensor calibrated from %1 to %2 N, ±%3 N</source>
        <translation>; Sensor kalibriert von %1 bis %2 N, ±%3 N</translation>
    </message>
    <message>
        <source>Waiting for the first reading. If none arrives, check the baud rate.</source>
        <translation>Es wird auf den ersten Messwert gewartet. Wenn keiner kommt, prüfen Sie die Baudrate.</translation>
    </message>
    <message>
        <source>Running, %1 readings a second</source>
        <translation>Läuft, %1 Messwerte je Sekunde</translation>
    </message>
    <message>
        <source>No data: the sensor has stopped sending. Check its power supply and firmware.</source>
        <translation>Keine Daten: Der Sensor sendet nicht mehr. Prüfen Sie seine Stromversorgung und Firmware.</translation>
    </message>
    <message>
        <source>; %1 readings rejected, %2 lines not understood</source>
        <translation>; %1 Messwerte verworfen, %2 Zeilen nicht verstanden</translation>
    </message>
    <message>
        <source>Device profile</source>
        <translation>Geräteprofil</translation>
    </message>
    <message>
        <source>Device profiles (*.device);;All files (*)</source>
        <translation>Geräteprofile (*.device);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>; measured delay %1 ms, standard deviation %2 ms, %3 measurements</source>
        <translation>; gemessene Verzögerung %1 ms, Standardabweichung %2 ms, %3 Messungen</translation>
    </message>
    <message>
        <source>Show the state that is felt</source>
        <translation>Gefühlten Zustand zeigen</translation>
    </message>
    <message>
        <source>For a self-locking button, the graph changes to the state that is felt: unlocked or locked.</source>
        <translation>Bei einem Taster mit Verriegelung wechselt der Graph zu dem Zustand, der gerade gefühlt wird: gelöst oder eingerastet.</translation>
    </message>
    <message>
        <source>File (.device) that states how strong the transducer is at each frequency, and how the force sensor is calibrated. The command `detent-play sweep` measures the transducer, `detent-play calibrate` the sensor; the user&apos;s guide shows how.</source>
        <translation>Datei (.device), die angibt, wie stark der Wandler bei jeder Frequenz ist und wie der Kraftsensor kalibriert ist. Der Befehl „detent-play sweep“ misst den Wandler, „detent-play calibrate“ den Sensor; das Benutzerhandbuch zeigt, wie.</translation>
    </message>
    <message>
        <source>Speed of the serial port in bits per second. Sensors with a USB connection ignore it</source>
        <translation>Geschwindigkeit der seriellen Schnittstelle in Bit je Sekunde. Sensoren mit USB-Anschluss beachten sie nicht</translation>
    </message>
    <message>
        <source>The sensor has reported the same force for 10 s. Remove anything that presses on it. If the force stays the same, the sensor is defective.</source>
        <translation>Der Sensor meldet seit 10 s dieselbe Kraft. Entfernen Sie alles, was auf ihn drückt. Bleibt die Kraft gleich, ist der Sensor defekt.</translation>
    </message>
    <message>
        <source>rate of the device</source>
        <translation>Rate des Geräts</translation>
    </message>
    <message>
        <source>The force sensor is unplugged. Detent continues when it is connected again.</source>
        <translation>Der Kraftsensor ist ausgesteckt. Detent macht weiter, sobald er wieder angeschlossen ist.</translation>
    </message>
</context>
<context>
    <name>detent::editor::FileController</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Not opened: %1</source>
        <translation>Nicht geöffnet: %1</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>Another Detent window (process %1) has this file open. You&apos;ll be warned before overwriting the other window&apos;s changes.</source>
        <translation>Ein anderes Detent-Fenster (Prozess %1) hat diese Datei geöffnet. Sie werden gewarnt, bevor Sie dessen Änderungen überschreiben.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Reloaded %1</source>
        <translation>%1 neu geladen</translation>
    </message>
    <message>
        <source>Not reloaded: %1</source>
        <translation>Nicht neu geladen: %1</translation>
    </message>
    <message>
        <source>Not saved: another program has changed %1 since it was read here.</source>
        <translation>Nicht gespeichert: Ein anderes Programm hat %1 geändert, seit die Datei hier gelesen wurde.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Taster</translation>
    </message>
    <message>
        <source>%1 exists already.</source>
        <translation>%1 gibt es schon.</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>%1 is open in another tab. Close it there first, or choose another name</source>
        <translation>%1 ist in einem anderen Reiter offen. Schließen Sie den Taster zuerst dort, oder wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>Another program changed this file, and there are unsaved changes here. Reloading can be undone.</source>
        <translation>Ein anderes Programm hat diese Datei geändert, und hier gibt es nicht gespeicherte Änderungen. Das Neuladen lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Another program changed this file.</source>
        <translation>Ein anderes Programm hat diese Datei geändert.</translation>
    </message>
    <message>
        <source>Keep my version</source>
        <translation>Meine Fassung behalten</translation>
    </message>
    <message>
        <source>The file of this button was deleted or moved away. Saving writes it again.</source>
        <translation>Die Datei dieses Tasters wurde gelöscht oder verschoben. Speichern schreibt sie neu.</translation>
    </message>
    <message>
        <source>sample-datasheet</source>
        <translation>Beispiel-Datenblatt</translation>
    </message>
    <message>
        <source>Import many files</source>
        <translation>Viele Dateien importieren</translation>
    </message>
    <message>
        <source>Import a folder</source>
        <translation>Einen Ordner importieren</translation>
    </message>
    <message>
        <source>Save the buttons in</source>
        <translation>Taster speichern in</translation>
    </message>
</context>
<context>
    <name>detent::editor::FilterBar</name>
    <message>
        <source>Show only switches with these words in name, credit, licence or file</source>
        <translation>Nur Schalter mit diesen Wörtern in Name, Urheber, Lizenz oder Datei zeigen</translation>
    </message>
    <message>
        <source>Words to search for</source>
        <translation>Gesuchte Wörter</translation>
    </message>
    <message>
        <source>Search: maker, name, credit …</source>
        <translation>Suche: Hersteller, Name, Urheber …</translation>
    </message>
    <message>
        <source>Show only switches of this kind</source>
        <translation>Nur Schalter dieser Art zeigen</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>all kinds</source>
        <translation>alle Arten</translation>
    </message>
    <message>
        <source>Filter by key &amp;figure…</source>
        <translation>Nach Kenn&amp;zahl filtern …</translation>
    </message>
    <message>
        <source>Show only switches with a key figure within limits that you choose</source>
        <translation>Nur Schalter zeigen, deren Kennzahl innerhalb der Grenzen liegt, die Sie wählen</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>mindestens</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>höchstens</translation>
    </message>
    <message>
        <source>Remove this condition</source>
        <translation>Diese Bedingung entfernen</translation>
    </message>
</context>
<context>
    <name>detent::editor::FindingsPanel</name>
    <message>
        <source>I have checked it against the page</source>
        <translation>Ich habe es mit der Seite verglichen</translation>
    </message>
    <message>
        <source>Findings and corrections</source>
        <translation>Befunde und Berichtigungen</translation>
    </message>
    <message>
        <source>How sure the import is, in percent</source>
        <translation>Wie sicher der Import ist, in Prozent</translation>
    </message>
    <message>
        <source>Allows an uncertain result to be imported</source>
        <translation>Erlaubt den Import eines unsicheren Ergebnisses</translation>
    </message>
    <message>
        <source>Plot frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>Draw…</source>
        <translation>Zeichnen …</translation>
    </message>
    <message>
        <source>Drag a new plot frame on the page</source>
        <translation>Einen neuen Rahmen auf die Seite ziehen</translation>
    </message>
    <message>
        <source>Reset plot frame</source>
        <translation>Rahmen zurücksetzen</translation>
    </message>
    <message>
        <source>Reading the graph …</source>
        <translation>Der Graph wird gelesen …</translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <translation>%1 %2 %</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>reason: %1</source>
        <translation>Grund: %1</translation>
    </message>
    <message>
        <source>Last valid result (%1 % confidence)</source>
        <translation>Letztes gültiges Ergebnis (%1 % Sicherheit)</translation>
    </message>
    <message>
        <source>Confidence %1 %: check before importing</source>
        <translation>Sicherheit %1 %: vor dem Import prüfen</translation>
    </message>
    <message>
        <source>Confidence %1 %</source>
        <translation>Sicherheit %1 %</translation>
    </message>
    <message>
        <source>Not readable yet</source>
        <translation>Noch nicht lesbar</translation>
    </message>
    <message>
        <source>1 switch will be imported</source>
        <translation>1 Schalter wird importiert</translation>
    </message>
    <message>
        <source>%1 switches will be imported</source>
        <translation>%1 Schalter werden importiert</translation>
    </message>
</context>
<context>
    <name>detent::editor::ForceBox</name>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>&amp;Make button stable</source>
        <translation>&amp;Taster stabil machen</translation>
    </message>
    <message>
        <source>Change the button only as much as the device requires: damping first, then slopes; peaks keep their force. Can be undone in one step.</source>
        <translation>Den Taster nur so weit ändern, wie das Gerät es erfordert: zuerst Dämpfung, dann Steigungen; Spitzen behalten ihre Kraft. Lässt sich in einem Schritt rückgängig machen.</translation>
    </message>
    <message>
        <source>No force device. Choose one under Setup; simulated devices need no hardware.</source>
        <translation>Kein Kraftgerät. Wählen Sie eines unter Einrichtung; simulierte brauchen keine Hardware.</translation>
    </message>
    <message>
        <source>Simulated device: nothing moves in reality. Switch it on to watch it.</source>
        <translation>Simuliertes Gerät: In Wirklichkeit bewegt sich nichts. Schalten Sie es ein, um es zu beobachten.</translation>
    </message>
    <message>
        <source>Off: the device applies no force.</source>
        <translation>Aus: Das Gerät übt keine Kraft aus.</translation>
    </message>
    <message>
        <source>Opening the force device…</source>
        <translation>Das Kraftgerät wird geöffnet …</translation>
    </message>
    <message>
        <source>No force: %1</source>
        <translation>Keine Kraft: %1</translation>
    </message>
    <message>
        <source>No force yet: pull the handle all the way out and push it all the way in, until the light is green.</source>
        <translation>Noch keine Kraft: Ziehen Sie den Griff ganz heraus und schieben Sie ihn ganz hinein, bis das Licht grün ist.</translation>
    </message>
    <message>
        <source>Simulated device on: %1</source>
        <translation>Simuliertes Gerät an: %1</translation>
    </message>
    <message>
        <source>On: %1</source>
        <translation>An: %1</translation>
    </message>
    <message>
        <source>Feel the button as force on the device chosen under Setup</source>
        <translation>Den Taster als Kraft auf dem unter Einrichtung gewählten Gerät fühlen</translation>
    </message>
    <message>
        <source>Choose a force device under Setup first</source>
        <translation>Wählen Sie zuerst unter Einrichtung ein Kraftgerät</translation>
    </message>
    <message>
        <source>Changed: %1</source>
        <translation>Geändert: %1</translation>
    </message>
    <message>
        <source>Show in the graph which slopes the device can reproduce without vibrating</source>
        <translation>Im Graphen zeigen, welche Steigungen das Gerät wiedergeben kann, ohne zu schwingen</translation>
    </message>
    <message>
        <source>The force device is disconnected and applies no force. Detent continues when it is connected again.</source>
        <translation>Das Kraftgerät ist getrennt und übt keine Kraft aus. Detent macht weiter, sobald es wieder angeschlossen ist.</translation>
    </message>
</context>
<context>
    <name>detent::editor::ForceMeter</name>
    <message>
        <source>Force, energy and timing</source>
        <translation>Kraft, Energie und Zeitverhalten</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Force&lt;/b&gt;: the commanded force, and the largest one allowed.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Energy&lt;/b&gt;: energy that the finger has put into the button since rest, and how much of it was returned. A balance below 0 means that the button returned more than it stored.&lt;/p&gt;&lt;p&gt;&lt;b&gt;On time&lt;/b&gt;: share of control steps that began within 0.1 ms of their planned time, and the longest delay.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Kraft&lt;/b&gt;: die Sollkraft und die größte zulässige Kraft.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Energie&lt;/b&gt;: Energie, die der Finger seit der Ruhelage in den Taster eingebracht hat, und wie viel davon zurückkam. Eine Bilanz unter 0 heißt, dass der Taster mehr abgab, als er gespeichert hatte.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Pünktlich&lt;/b&gt;: Anteil der Regelschritte, die innerhalb von 0,1 ms ihres geplanten Zeitpunkts begannen, und die größte Verspätung.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>On time</source>
        <translation>Pünktlich</translation>
    </message>
    <message>
        <source>no force</source>
        <translation>keine Kraft</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 mJ, balance %2 mJ</source>
        <translation>%1 mJ, Bilanz %2 mJ</translation>
    </message>
    <message>
        <source>%1 mJ, %2 of %3 returned</source>
        <translation>%1 mJ, %2 von %3 zurück</translation>
    </message>
    <message>
        <source>%1 %, max. %2 ms late</source>
        <translation>%1 %, max. %2 ms zu spät</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>detent::editor::ForceSession</name>
    <message>
        <source>No change is needed: the device can reproduce every slope of this button.</source>
        <translation>Keine Änderung nötig: Das Gerät kann jede Steigung dieses Tasters wiedergeben.</translation>
    </message>
    <message>
        <source>Make button stable</source>
        <translation>Taster stabil machen</translation>
    </message>
    <message>
        <source>Changed to the nearest stable button. Use Undo to go back.</source>
        <translation>Zum nächsten stabilen Taster geändert. „Rückgängig“ nimmt die Änderung zurück.</translation>
    </message>
</context>
<context>
    <name>detent::editor::ForceSetup</name>
    <message>
        <source>Device that produces the force: a simulated one with a simulated finger, or a real one</source>
        <translation>Gerät, das die Kraft erzeugt: ein simuliertes mit einem simulierten Finger oder ein echtes</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>simulated: bench device, 1 µm</source>
        <translation>simuliert: Laborgerät, 1 µm</translation>
    </message>
    <message>
        <source>simulated: Novint Falcon</source>
        <translation>simuliert: Novint Falcon</translation>
    </message>
    <message>
        <source>simulated: voice coil, 10 µm</source>
        <translation>simuliert: Tauchspule, 10 µm</translation>
    </message>
    <message>
        <source>microcontroller on a serial port</source>
        <translation>Mikrocontroller an einem seriellen Anschluss</translation>
    </message>
    <message>
        <source>ODrive</source>
        <translation>ODrive</translation>
    </message>
    <message>
        <source>Novint Falcon</source>
        <translation>Novint Falcon</translation>
    </message>
    <message>
        <source>F&amp;orce device:</source>
        <translation>&amp;Kraftgerät:</translation>
    </message>
    <message>
        <source>Serial port of the force device, for example /dev/ttyACM0</source>
        <translation>Serieller Anschluss des Kraftgeräts, zum Beispiel /dev/ttyACM0</translation>
    </message>
    <message>
        <source>&amp;Port:</source>
        <translation>A&amp;nschluss:</translation>
    </message>
    <message>
        <source>Fir&amp;mware:</source>
        <translation>Fir&amp;mware:</translation>
    </message>
    <message>
        <source>Behaviour of the simulated finger</source>
        <translation>Verhalten des simulierten Fingers</translation>
    </message>
    <message>
        <source>presses again and again</source>
        <translation>drückt immer wieder</translation>
    </message>
    <message>
        <source>rests in the middle of the travel</source>
        <translation>ruht in der Mitte des Wegs</translation>
    </message>
    <message>
        <source>F&amp;inger:</source>
        <translation>F&amp;inger:</translation>
    </message>
    <message>
        <source>The force never exceeds this value</source>
        <translation>Die Kraft überschreitet diesen Wert nie</translation>
    </message>
    <message>
        <source>&amp;Largest force:</source>
        <translation>&amp;Größte Kraft:</translation>
    </message>
    <message>
        <source>Encoder step, at the finger</source>
        <translation>Encoderschritt, am Finger</translation>
    </message>
    <message>
        <source>10 µm</source>
        <translation>10 µm</translation>
    </message>
    <message>
        <source>Encoder s&amp;tep:</source>
        <translation>Encoderschri&amp;tt:</translation>
    </message>
    <message>
        <source>Travel of the handle in one turn of the motor; negative if pressing turns the motor backwards</source>
        <translation>Weg des Griffs bei einer Umdrehung des Motors; negativ, wenn Drücken den Motor rückwärts dreht</translation>
    </message>
    <message>
        <source>Travel per t&amp;urn:</source>
        <translation>Weg je &amp;Umdrehung:</translation>
    </message>
    <message>
        <source>Compute the force on the microcontroller, at its own rate</source>
        <translation>Die Kraft auf dem Mikrocontroller berechnen, in seinem eigenen Takt</translation>
    </message>
    <message>
        <source>Add damping where the button returns more energy than it took up</source>
        <translation>Dämpfen, wo der Taster mehr Energie abgibt, als er aufnahm</translation>
    </message>
    <message>
        <source>Steadier on a device that vibrates, but less crisp where a button snaps (passivity controller)</source>
        <translation>Ruhiger auf einem Gerät, das schwingt, aber weniger ausgeprägt, wo ein Taster schnappt (Passivitätsregler)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>The first time, keep a hand on the power switch and set the largest force to 1 N. The guide to force feedback describes the wiring.</source>
        <translation>Beim ersten Mal eine Hand am Netzschalter lassen und die größte Kraft auf 1 N stellen. Der Leitfaden zur Kraftrückmeldung beschreibt die Verdrahtung.</translation>
    </message>
    <message>
        <source>Firmware of the Falcon</source>
        <translation>Firmware des Falcon</translation>
    </message>
    <message>
        <source>Firmware (*.bin);;All files (*)</source>
        <translation>Firmware (*.bin);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Uploads a table of forces to the microcontroller, so that no USB delay lies between position and force</source>
        <translation>Überträgt eine Tabelle der Kräfte auf den Mikrocontroller, damit keine USB-Verzögerung zwischen Position und Kraft liegt</translation>
    </message>
    <message>
        <source>limit of the device</source>
        <translation>Grenze des Geräts</translation>
    </message>
    <message>
        <source>Firmware file that came with the Falcon&apos;s driver (7 to 9 kB). The Falcon needs it each time it is switched on. Its licence does not allow Detent to include it</source>
        <translation>Firmware-Datei, die mit dem Treiber des Falcon kam (7 bis 9 kB). Der Falcon braucht sie nach jedem Einschalten. Ihre Lizenz erlaubt nicht, dass Detent sie enthält</translation>
    </message>
</context>
<context>
    <name>detent::editor::ForecastBar</name>
    <message>
        <source>Predicted confusion</source>
        <translation>Vorhergesagte Verwechslung</translation>
    </message>
    <message>
        <source>This prediction comes from the vibration of both buttons and a model of touch; no participants were asked. Its limits: docs/reference/predicted-confusion.md.</source>
        <translation>Diese Vorhersage kommt aus der Vibration beider Taster und einem Modell des Tastsinns; niemand wurde befragt. Ihre Grenzen: docs/reference/predicted-confusion.md.</translation>
    </message>
    <message>
        <source>Make &amp;distinguishable…</source>
        <translation>&amp;Unterscheidbar machen …</translation>
    </message>
    <message>
        <source>Find the smallest change of button A that people will notice</source>
        <translation>Die kleinste Änderung von Taster A suchen, die Menschen bemerken</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Es wird gesucht …</translation>
    </message>
    <message>
        <source>Detent found no such change. Even if the snap ratio, the travel or the force of button A changes by a factor of 4, people may still confuse the buttons</source>
        <translation>Detent hat keine solche Änderung gefunden. Selbst wenn sich Schnappverhältnis, Weg oder Kraft von Taster A um den Faktor 4 ändern, kann man die Taster noch verwechseln</translation>
    </message>
</context>
<context>
    <name>detent::editor::ForecastMatrix</name>
    <message>
        <source>Predicted confusion of the open buttons</source>
        <translation>Vorhergesagte Verwechslungen der offenen Taster</translation>
    </message>
    <message>
        <source>Predicted errors in 90 trials for every pair</source>
        <translation>Vorhergesagte Fehler in 90 Durchgängen für jedes Paar</translation>
    </message>
    <message>
        <source>%v of %m</source>
        <translation>%v von %m</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Cancel the computation; the next edit starts a new one</source>
        <translation>Die Berechnung abbrechen; die nächste Änderung beginnt eine neue</translation>
    </message>
    <message>
        <source>Open two buttons or more to compare them.</source>
        <translation>Öffnen Sie zwei Taster oder mehr, um sie zu vergleichen.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Number of wrong answers predicted if people compare two buttons by feel 90 times. 45 means that they guess. 9 or fewer means that they can tell the buttons apart. Bold numbers are not certain. Double-click a number to compare the two buttons.</source>
        <translation>Vorhergesagte Anzahl falscher Antworten, wenn Menschen zwei Taster 90-mal durch Fühlen vergleichen. 45 bedeutet, dass sie raten. 9 oder weniger bedeutet, dass sie die Taster unterscheiden können. Fette Zahlen sind nicht sicher. Ein Doppelklick auf eine Zahl vergleicht die zwei Taster.</translation>
    </message>
</context>
<context>
    <name>detent::editor::GlossaryWindow</name>
    <message>
        <source>travel</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Glossary</source>
        <translation>Glossar</translation>
    </message>
    <message>
        <source>Operating point</source>
        <translation>Schaltpunkt</translation>
    </message>
    <message>
        <source>Where the contact closes while the button is pressed. Keyboards call it the actuation point. Its force is the operating force.</source>
        <translation>Hier schließt der Kontakt beim Drücken. Bei Tastaturen heißt er Auslösepunkt. Die Kraft dort ist die Schaltkraft.</translation>
    </message>
    <message>
        <source>Tactile peak</source>
        <translation>Druckpunkt</translation>
    </message>
    <message>
        <source>The force to overcome before the button gives way. The finger feels the drop behind it as a click.</source>
        <translation>Diese Kraft ist zu überwinden, bevor der Taster nachgibt. Den Abfall dahinter spürt der Finger als Klick.</translation>
    </message>
    <message>
        <source>Bottom-out</source>
        <translation>Anschlag</translation>
    </message>
    <message>
        <source>Pre-travel and over-travel</source>
        <translation>Vorlaufweg und Nachlaufweg</translation>
    </message>
    <message>
        <source>The way to the operating point, and the way from there to the end. Both together are the total travel.</source>
        <translation>Der Weg bis zum Schaltpunkt und der Weg von dort bis zum Ende. Beide zusammen sind der Gesamtweg.</translation>
    </message>
    <message>
        <source>Reset point and hysteresis</source>
        <translation>Rückschaltpunkt und Hysterese</translation>
    </message>
    <message>
        <source>Snap ratio</source>
        <translation>Schnappverhältnis</translation>
    </message>
    <message>
        <source>The drop behind the peak, as a share of the peak force: 0 % for a linear button, about 40 % and more for a crisp one.</source>
        <translation>Der Abfall hinter dem Druckpunkt als Anteil seiner Kraft: 0 % bei einem linearen Taster, etwa 40 % und mehr bei einem knackigen.</translation>
    </message>
    <message>
        <source>On its way back the button pushes less (dashed), and the contact opens later, at the reset point. The area between the curves is the energy that a press loses.</source>
        <translation>Auf dem Rückweg drückt der Taster schwächer (gestrichelt), und der Kontakt öffnet später, am Rückschaltpunkt. Die Fläche zwischen den Kurven ist die Energie, die bei einem Druck verloren geht.</translation>
    </message>
    <message>
        <source>Solid: the press. Dashed: the release. Red: the part that the term names.</source>
        <translation>Durchgezogen: Drücken. Gestrichelt: Loslassen. Rot: der Teil, den der Begriff benennt.</translation>
    </message>
    <message>
        <source>Where the button meets its end stop: from here on the force rises steeply, up to the end of the travel.</source>
        <translation>Hier trifft der Taster auf seinen Anschlag: Von da an steigt die Kraft steil bis zum Ende des Wegs.</translation>
    </message>
</context>
<context>
    <name>detent::editor::GraphCanvas</name>
    <message>
        <source>Force graph</source>
        <translation>Kraftgraph</translation>
    </message>
    <message>
        <source>Tab goes through the points of the graph, arrow keys move the selected one, Delete removes it.</source>
        <translation>Tab geht durch die Punkte des Graphen, Pfeiltasten verschieben den gewählten, Entf entfernt ihn.</translation>
    </message>
    <message numerus="yes">
        <source>Force graph: %n points selected</source>
        <translation>
            <numerusform>Kraftgraph: %n Punkt ausgewählt</numerusform>
            <numerusform>Kraftgraph: %n Punkte ausgewählt</numerusform>
        </translation>
    </message>
    <message>
        <source>Force graph: %1</source>
        <translation>Kraftgraph: %1</translation>
    </message>
</context>
<context>
    <name>detent::editor::GraphExportDialog</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Export the graph</source>
        <translation>Graphen exportieren</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Choose a location and write the file</source>
        <translation>Speicherort wählen und die Datei schreiben</translation>
    </message>
    <message>
        <source>Purpose of the graph</source>
        <translation>Zweck des Graphen</translation>
    </message>
    <message>
        <source>Datasheet</source>
        <translation>Datenblatt</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Fachartikel</translation>
    </message>
    <message>
        <source>Slide</source>
        <translation>Folie</translation>
    </message>
    <message>
        <source>Format of the file</source>
        <translation>Format der Datei</translation>
    </message>
    <message>
        <source>Drawing (SVG)</source>
        <translation>Zeichnung (SVG)</translation>
    </message>
    <message>
        <source>PDF</source>
        <translation>PDF</translation>
    </message>
    <message>
        <source>Picture (PNG)</source>
        <translation>Bild (PNG)</translation>
    </message>
    <message>
        <source>Width of the graph</source>
        <translation>Breite des Graphen</translation>
    </message>
    <message>
        <source>Height of the graph of one state</source>
        <translation>Höhe des Graphen eines Zustands</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>Sans-serif</source>
        <translation>Ohne Serifen</translation>
    </message>
    <message>
        <source>Serif</source>
        <translation>Mit Serifen</translation>
    </message>
    <message>
        <source>Size of the font</source>
        <translation>Größe der Schrift</translation>
    </message>
    <message>
        <source>&amp;Preset:</source>
        <translation>&amp;Vorlage:</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format:</translation>
    </message>
    <message>
        <source>&amp;Width:</source>
        <translation>&amp;Breite:</translation>
    </message>
    <message>
        <source>&amp;Height:</source>
        <translation>&amp;Höhe:</translation>
    </message>
    <message>
        <source>F&amp;ont:</source>
        <translation>S&amp;chrift:</translation>
    </message>
    <message>
        <source>Font &amp;size:</source>
        <translation>Schrift&amp;größe:</translation>
    </message>
    <message>
        <source>Language of the labels</source>
        <translation>Sprache der Beschriftungen</translation>
    </message>
    <message>
        <source>Decimal separator</source>
        <translation>Dezimaltrennzeichen</translation>
    </message>
    <message>
        <source>Point (1.5)</source>
        <translation>Punkt (1.5)</translation>
    </message>
    <message>
        <source>Comma (1,5)</source>
        <translation>Komma (1,5)</translation>
    </message>
    <message>
        <source>Unit of the displacement</source>
        <translation>Einheit des Wegs</translation>
    </message>
    <message>
        <source>Unit of the force</source>
        <translation>Einheit der Kraft</translation>
    </message>
    <message>
        <source>Unit of a second scale at the right side</source>
        <translation>Einheit einer zweiten Skala am rechten Rand</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Lan&amp;guage:</source>
        <translation>S&amp;prache:</translation>
    </message>
    <message>
        <source>&amp;Decimal separator:</source>
        <translation>&amp;Dezimaltrennzeichen:</translation>
    </message>
    <message>
        <source>D&amp;isplacement in:</source>
        <translation>&amp;Weg in:</translation>
    </message>
    <message>
        <source>Fo&amp;rce in:</source>
        <translation>&amp;Kraft in:</translation>
    </message>
    <message>
        <source>Second s&amp;cale:</source>
        <translation>&amp;Zweite Skala:</translation>
    </message>
    <message>
        <source>Where the displacement axis begins</source>
        <translation>Wo die Wegachse beginnt</translation>
    </message>
    <message>
        <source>Where the displacement axis ends</source>
        <translation>Wo die Wegachse endet</translation>
    </message>
    <message>
        <source>Where the force axis begins</source>
        <translation>Wo die Kraftachse beginnt</translation>
    </message>
    <message>
        <source>Where the force axis ends</source>
        <translation>Wo die Kraftachse endet</translation>
    </message>
    <message>
        <source>Displ&amp;acement from:</source>
        <translation>Weg vo&amp;n:</translation>
    </message>
    <message>
        <source>to:</source>
        <translation>bis:</translation>
    </message>
    <message>
        <source>Force fro&amp;m:</source>
        <translation>Kraft v&amp;on:</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>&amp;Black and white</source>
        <translation>&amp;Schwarzweiß</translation>
    </message>
    <message>
        <source>Draw the press in black, the release in black and dashed</source>
        <translation>Den Hinweg schwarz zeichnen, den Rückweg schwarz und gestrichelt</translation>
    </message>
    <message>
        <source>&amp;Label points</source>
        <translation>P&amp;unkte beschriften</translation>
    </message>
    <message>
        <source>Label tactile points, operating and reset point and bottom-out with their values</source>
        <translation>Druckpunkte, Schalt- und Rückschaltpunkt und Anschlag mit ihren Werten beschriften</translation>
    </message>
    <message>
        <source>Dimensio&amp;ns</source>
        <translation>&amp;Maße</translation>
    </message>
    <message>
        <source>Show pre-travel and differential travel as dimension lines</source>
        <translation>Vorlaufweg und Differenzweg als Maßlinien zeigen</translation>
    </message>
    <message>
        <source>Tolerance band, as a share of the press force</source>
        <translation>Toleranzband als Anteil der Kraft des Hinwegs</translation>
    </message>
    <message>
        <source>Tolerance band, as a force above and below the press</source>
        <translation>Toleranzband als Kraft über und unter dem Hinweg</translation>
    </message>
    <message>
        <source>&amp;Tolerance ±:</source>
        <translation>&amp;Toleranz ±:</translation>
    </message>
    <message>
        <source>or ± force:</source>
        <translation>oder ± Kraft:</translation>
    </message>
    <message>
        <source>The font is too large for this size: there is no room for the curves. Choose a smaller font or a larger graph.</source>
        <translation>Die Schrift ist zu groß für dieses Maß: Für die Kurven bleibt kein Platz. Wählen Sie eine kleinere Schrift oder einen größeren Graphen.</translation>
    </message>
    <message>
        <source>An axis must begin below its end. Type a smaller start or a larger end.</source>
        <translation>Eine Achse muss unter ihrem Ende beginnen. Geben Sie einen kleineren Anfang oder ein größeres Ende ein.</translation>
    </message>
    <message>
        <source>Labels without room are left out: %1. Choose a larger graph or a smaller font.</source>
        <translation>Beschriftungen ohne Platz fehlen: %1. Wählen Sie einen größeren Graphen oder eine kleinere Schrift.</translation>
    </message>
</context>
<context>
    <name>detent::editor::GraphWorkspace</name>
    <message>
        <source>&amp;State</source>
        <translation>&amp;Zustand</translation>
    </message>
    <message>
        <source>State of the button</source>
        <translation>Zustand des Tasters</translation>
    </message>
    <message>
        <source>State that you edit; the other state is drawn pale behind it.</source>
        <translation>Zustand, den Sie bearbeiten; der andere Zustand ist blass dahinter gezeichnet.</translation>
    </message>
    <message>
        <source>&amp;Page</source>
        <translation>&amp;Seite</translation>
    </message>
    <message>
        <source>Opacity of the datasheet page</source>
        <translation>Deckkraft der Datenblattseite</translation>
    </message>
    <message>
        <source>How strongly the datasheet page shows under the curves, in %</source>
        <translation>Wie stark die Seite des Datenblatts unter den Kurven zu sehen ist, in %</translation>
    </message>
    <message>
        <source>&amp;Select and move</source>
        <translation>&amp;Auswählen und verschieben</translation>
    </message>
    <message>
        <source>Drag tactile points, curve points, slope handles and sections</source>
        <translation>Druckpunkte, Kurvenpunkte, Steigungsgriffe und Abschnitte ziehen</translation>
    </message>
    <message>
        <source>Add &amp;curve point</source>
        <translation>&amp;Kurvenpunkt hinzufügen</translation>
    </message>
    <message>
        <source>Click a curve to add a curve point</source>
        <translation>Auf eine Kurve klicken, um einen Kurvenpunkt zu setzen</translation>
    </message>
    <message>
        <source>Add &amp;jump</source>
        <translation>&amp;Sprung hinzufügen</translation>
    </message>
    <message>
        <source>Hold the mouse button where the jump begins, then drag the valley into place</source>
        <translation>Maustaste halten, wo der Sprung beginnt, dann das Tal an seine Stelle ziehen</translation>
    </message>
    <message>
        <source>&amp;Pan</source>
        <translation>Ansicht verschie&amp;ben</translation>
    </message>
    <message>
        <source>Drag the view; the middle mouse button does the same in every tool</source>
        <translation>Die Ansicht ziehen; die mittlere Maustaste tut dasselbe mit jedem Werkzeug</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Removes the selected curve point, jump, operating or reset point</source>
        <translation>Entfernt den gewählten Kurvenpunkt, Sprung, Schalt- oder Rückschaltpunkt</translation>
    </message>
    <message>
        <source>&amp;Corner or smooth</source>
        <translation>&amp;Ecke oder glatt</translation>
    </message>
    <message>
        <source>Turns the selected curve point into a corner, or makes it smooth</source>
        <translation>Macht den gewählten Kurvenpunkt zur Ecke oder glättet ihn</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>Copies the selected points as text and removes them</source>
        <translation>Kopiert die gewählten Punkte als Text und entfernt sie</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copies the selected part of the curve as text, or the whole button</source>
        <translation>Kopiert den gewählten Teil der Kurve als Text, oder den ganzen Taster</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>A&amp;lles auswählen</translation>
    </message>
    <message>
        <source>Selects all curve points, operating and reset point</source>
        <translation>Wählt alle Kurvenpunkte, Schalt- und Rückschaltpunkt</translation>
    </message>
    <message>
        <source>Align to the same &amp;force</source>
        <translation>Auf gleiche &amp;Kraft ausrichten</translation>
    </message>
    <message>
        <source>Moves the selected points to the force of the last one</source>
        <translation>Verschiebt die gewählten Punkte auf die Kraft des letzten</translation>
    </message>
    <message>
        <source>Align to the same &amp;displacement</source>
        <translation>Auf gleichen &amp;Weg ausrichten</translation>
    </message>
    <message>
        <source>Moves the selected points to the displacement of the last one</source>
        <translation>Verschiebt die gewählten Punkte auf den Weg des letzten</translation>
    </message>
    <message>
        <source>Distribute over d&amp;isplacement</source>
        <translation>Über den W&amp;eg verteilen</translation>
    </message>
    <message>
        <source>Spaces the selected points of a stroke evenly over the travel</source>
        <translation>Verteilt die gewählten Punkte einer Kurve gleichmäßig über den Weg</translation>
    </message>
    <message>
        <source>Distribute over f&amp;orce</source>
        <translation>Über die K&amp;raft verteilen</translation>
    </message>
    <message>
        <source>Spaces the selected points of a stroke evenly over the force</source>
        <translation>Verteilt die gewählten Punkte einer Kurve gleichmäßig über die Kraft</translation>
    </message>
    <message>
        <source>Copied the selected part of the curve</source>
        <translation>Der gewählte Teil der Kurve wurde kopiert</translation>
    </message>
    <message>
        <source>Paste part of a curve</source>
        <translation>Teil einer Kurve einfügen</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>Ein&amp;passen</translation>
    </message>
    <message>
        <source>Shows the whole graph</source>
        <translation>Zeigt den ganzen Graphen</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>The mouse wheel zooms at the pointer; with Alt only displacement, with Ctrl only force</source>
        <translation>Das Mausrad vergrößert am Zeiger; mit Alt nur den Weg, mit Strg nur die Kraft</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Shows a larger part of the graph</source>
        <translation>Zeigt einen größeren Teil des Graphen</translation>
    </message>
    <message>
        <source>Displacement over &amp;force</source>
        <translation>Weg über &amp;Kraft</translation>
    </message>
    <message>
        <source>Displacement plotted over force; jumps appear as vertical lines</source>
        <translation>Weg über der Kraft aufgetragen; Sprünge erscheinen als senkrechte Linien</translation>
    </message>
    <message>
        <source>&amp;Damping</source>
        <translation>&amp;Dämpfung</translation>
    </message>
    <message>
        <source>Damping over displacement, if the button has damping</source>
        <translation>Dämpfung über dem Weg, falls der Taster Dämpfung hat</translation>
    </message>
    <message>
        <source>&amp;Traced points and deviations</source>
        <translation>Abgelesene &amp;Punkte und Abweichungen</translation>
    </message>
    <message>
        <source>The traced points and how far the curve deviates from them, enlarged ten times</source>
        <translation>Die abgelesenen Punkte und wie weit die Kurve von ihnen abweicht, zehnfach vergrößert</translation>
    </message>
    <message>
        <source>&amp;Magnifier</source>
        <translation>&amp;Lupe</translation>
    </message>
    <message>
        <source>Magnifies the graph five times while you drag</source>
        <translation>Vergrößert den Graphen fünffach, während Sie ziehen</translation>
    </message>
    <message>
        <source>C&amp;urve points</source>
        <translation>Kurvenpu&amp;nkte</translation>
    </message>
    <message>
        <source>Show curve points, valleys and peaks on the curves</source>
        <translation>Kurvenpunkte, Täler und Spitzen auf den Kurven zeigen</translation>
    </message>
    <message>
        <source>Snap to &amp;grid</source>
        <translation>Am &amp;Raster fangen</translation>
    </message>
    <message>
        <source>Snap dragged points to the grid</source>
        <translation>Gezogene Punkte rasten am Raster ein</translation>
    </message>
    <message>
        <source>Snap to tr&amp;aced points</source>
        <translation>An &amp;abgelesenen Punkten fangen</translation>
    </message>
    <message>
        <source>Dragged points snap to the points traced on the page</source>
        <translation>Gezogene Punkte rasten an den auf der Seite abgelesenen Punkten ein</translation>
    </message>
    <message>
        <source>Snap to the other &amp;stroke</source>
        <translation>An der anderen K&amp;urve fangen</translation>
    </message>
    <message>
        <source>Snap press points to the release curve, and vice versa</source>
        <translation>Punkte des Hinwegs rasten an der Rückwegkurve ein und umgekehrt</translation>
    </message>
    <message>
        <source>&amp;Zoom to a rectangle</source>
        <translation>Rechteck ver&amp;größern</translation>
    </message>
    <message>
        <source>Drag a rectangle to zoom in; a click zooms in</source>
        <translation>Rechteck aufziehen zum Vergrößern; ein Klick vergrößert</translation>
    </message>
    <message>
        <source>Grid ste&amp;ps…</source>
        <translation>S&amp;chrittweiten des Rasters …</translation>
    </message>
    <message>
        <source>Spacing of the snap grid</source>
        <translation>Abstand der Linien des Fangrasters</translation>
    </message>
    <message>
        <source>Sp&amp;eed</source>
        <translation>G&amp;eschwindigkeit</translation>
    </message>
    <message>
        <source>Speed of the graph</source>
        <translation>Geschwindigkeit des Graphen</translation>
    </message>
    <message>
        <source>Graph of %1</source>
        <translation>Graph von %1</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Drag from one place to another to measure travel, force and slope between them</source>
        <translation>Von einer Stelle zur anderen ziehen, um Weg, Kraft und Steigung dazwischen zu messen</translation>
    </message>
    <message>
        <source>Speed of the graph that you edit. This graph is also used where the speed of a press is not known. Graphs of other speeds are drawn thin.</source>
        <translation>Geschwindigkeit des Graphen, den Sie bearbeiten. Dieser Graph gilt auch, wo die Geschwindigkeit eines Tastendrucks nicht bekannt ist. Graphen anderer Geschwindigkeiten sind dünn gezeichnet.</translation>
    </message>
</context>
<context>
    <name>detent::editor::GridDialog</name>
    <message>
        <source>Steps of the snap grid</source>
        <translation>Schrittweiten des Fangrasters</translation>
    </message>
    <message>
        <source>&amp;Displacement:</source>
        <translation>&amp;Weg:</translation>
    </message>
    <message>
        <source>&amp;Force:</source>
        <translation>&amp;Kraft:</translation>
    </message>
    <message>
        <source>Step of the grid along the displacement</source>
        <translation>Schrittweite des Rasters entlang des Wegs</translation>
    </message>
    <message>
        <source>Step of the grid along the force</source>
        <translation>Schrittweite des Rasters entlang der Kraft</translation>
    </message>
</context>
<context>
    <name>detent::editor::GuideWindow</name>
    <message>
        <source>%1 is part of Detent&apos;s sources; it is not installed with the program.</source>
        <translation>%1 gehört zu den Quelltexten von Detent und wird nicht mit dem Programm installiert.</translation>
    </message>
    <message>
        <source>User&apos;s guide</source>
        <translation>Benutzerhandbuch</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;Contents</source>
        <translation>&amp;Inhalt</translation>
    </message>
    <message>
        <source>The first page of the guide</source>
        <translation>Die erste Seite des Handbuchs</translation>
    </message>
    <message>
        <source>Find on this page</source>
        <translation>Auf dieser Seite suchen</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>Vorige Seite</translation>
    </message>
    <message>
        <source>Press Enter to find the next match</source>
        <translation>Die Eingabetaste sucht die nächste Stelle</translation>
    </message>
    <message>
        <source>The guide is not installed. It belongs in the folder share/detent/docs beside the program&apos;s folder. Install the package again.</source>
        <translation>Das Handbuch ist nicht installiert. Es gehört in den Ordner share/detent/docs neben dem Ordner des Programms. Installieren Sie das Paket noch einmal.</translation>
    </message>
</context>
<context>
    <name>detent::editor::HistoryPanel</name>
    <message>
        <source>Editing steps of this button</source>
        <translation>Bearbeitungsschritte dieses Tasters</translation>
    </message>
    <message>
        <source>Every editing step since the button was opened. Click one to return to it.</source>
        <translation>Jeder Bearbeitungsschritt, seit der Taster geöffnet wurde. Ein Klick führt dorthin zurück.</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>Geöffnet</translation>
    </message>
    <message>
        <source>Imported</source>
        <translation>Importiert</translation>
    </message>
</context>
<context>
    <name>detent::editor::ImportDialog</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Adjust</source>
        <translation>Justieren</translation>
    </message>
    <message>
        <source>Drag corners, edges and ticks</source>
        <translation>Ecken, Kanten und Teilstriche ziehen</translation>
    </message>
    <message>
        <source>Axis values</source>
        <translation>Achsenwerte</translation>
    </message>
    <message>
        <source>Click ticks and type their values</source>
        <translation>Teilstriche anklicken und ihre Werte eingeben</translation>
    </message>
    <message>
        <source>Plot frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>Draw a plot frame</source>
        <translation>Einen Rahmen zeichnen</translation>
    </message>
    <message>
        <source>Press curve</source>
        <translation>Hinweg</translation>
    </message>
    <message>
        <source>Click the press curve</source>
        <translation>Hinwegkurve anklicken</translation>
    </message>
    <message>
        <source>Release curve</source>
        <translation>Rückweg</translation>
    </message>
    <message>
        <source>Click the release curve</source>
        <translation>Rückwegkurve anklicken</translation>
    </message>
    <message>
        <source>Draw press</source>
        <translation>Hinweg zeichnen</translation>
    </message>
    <message>
        <source>Click points along the press curve, or draw along it</source>
        <translation>Punkte entlang der Hinwegkurve klicken, oder an ihr entlang zeichnen</translation>
    </message>
    <message>
        <source>Draw release</source>
        <translation>Rückweg zeichnen</translation>
    </message>
    <message>
        <source>Click points along the release curve, or draw along it</source>
        <translation>Punkte entlang der Rückwegkurve klicken, oder an ihr entlang zeichnen</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Mask a rectangle</source>
        <translation>Ein Rechteck maskieren</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Paint a mask</source>
        <translation>Eine Maske malen</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Schieben</translation>
    </message>
    <message>
        <source>Drag the page</source>
        <translation>Die Seite ziehen</translation>
    </message>
    <message>
        <source>Next graph</source>
        <translation>Nächster Graph</translation>
    </message>
    <message>
        <source>Previous graph</source>
        <translation>Voriger Graph</translation>
    </message>
    <message>
        <source>Tick all graphs</source>
        <translation>Alle Graphen ankreuzen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last correction</source>
        <translation>Die letzte Berichtigung rückgängig machen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Redo the correction</source>
        <translation>Die Berichtigung wiederherstellen</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>Graph</translation>
    </message>
    <message>
        <source>Show the graph</source>
        <translation>Den Graphen zeigen</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Show the whole page</source>
        <translation>Die ganze Seite zeigen</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open a picture, PDF, SVG or a force meter&apos;s CSV (%1)</source>
        <translation>Ein Bild, PDF, SVG oder die CSV eines Kraftmessgeräts öffnen (%1)</translation>
    </message>
    <message>
        <source>&amp;Paste picture</source>
        <translation>Bild &amp;einfügen</translation>
    </message>
    <message>
        <source>Import the picture on the clipboard (%1)</source>
        <translation>Das Bild in der Zwischenablage importieren (%1)</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualität</translation>
    </message>
    <message>
        <source>Quality of the import</source>
        <translation>Qualität des Imports</translation>
    </message>
    <message>
        <source>How carefully Detent reads the graph. Times and errors were measured on drawn graphs (docs/measurements/trade.md). Your corrections are kept when you change the quality.</source>
        <translation>Wie sorgfältig Detent den Graphen liest. Zeiten und Fehler sind an gezeichneten Graphen gemessen (docs/measurements/trade.md). Ihre Berichtigungen bleiben erhalten, wenn Sie die Qualität ändern.</translation>
    </message>
    <message>
        <source>Graphs onl&amp;y</source>
        <translation>Nur &amp;Graphen</translation>
    </message>
    <message>
        <source>List only the graphs, without the pages between them</source>
        <translation>Nur die Graphen aufführen, ohne die Seiten dazwischen</translation>
    </message>
    <message>
        <source>Progress of the import</source>
        <translation>Fortschritt des Imports</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Stop reading and keep the last result</source>
        <translation>Mit dem Lesen aufhören und das letzte Ergebnis behalten</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Displacement unit</source>
        <translation>Wegeinheit</translation>
    </message>
    <message>
        <source>Force unit</source>
        <translation>Krafteinheit</translation>
    </message>
    <message>
        <source> – %1 pages</source>
        <translation> – %1 Seiten</translation>
    </message>
    <message>
        <source>Import a force graph</source>
        <translation>Einen Kraftgraphen importieren</translation>
    </message>
    <message>
        <source>Import – %1</source>
        <translation>Importieren – %1</translation>
    </message>
    <message>
        <source>Undo: %1 (%2)</source>
        <translation>Rückgängig: %1 (%2)</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>Redo: %1 (%2)</source>
        <translation>Wiederherstellen: %1 (%2)</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Nichts wiederherzustellen</translation>
    </message>
    <message>
        <source>Searching for graphs: page %1 of %2</source>
        <translation>Graphen werden gesucht: Seite %1 von %2</translation>
    </message>
    <message>
        <source>No force graph was found on this page.</source>
        <translation>Auf dieser Seite wurde kein Kraftgraph gefunden.</translation>
    </message>
    <message>
        <source>No force graph was found.</source>
        <translation>Es wurde kein Kraftgraph gefunden.</translation>
    </message>
    <message>
        <source>If the page shows a graph, draw its plot frame or click a dashed rectangle.</source>
        <translation>Wenn die Seite einen Graphen zeigt, zeichnen Sie seinen Rahmen oder klicken Sie auf ein gestricheltes Rechteck.</translation>
    </message>
    <message>
        <source>Import the ticked graphs, each as a button of its own</source>
        <translation>Die angekreuzten Graphen importieren, jeden als eigenen Taster</translation>
    </message>
    <message>
        <source>Import this graph as a button (Ctrl+Enter)</source>
        <translation>Diesen Graphen als Taster importieren (Strg+Eingabe)</translation>
    </message>
    <message>
        <source>Swap press and release</source>
        <translation>Hinweg und Rückweg vertauschen</translation>
    </message>
    <message>
        <source>Open a datasheet or a force meter&apos;s log</source>
        <translation>Ein Datenblatt oder das Protokoll eines Kraftmessgeräts öffnen</translation>
    </message>
    <message>
        <source>There is no picture on the clipboard. Copy one, for instance with the snipping tool of your system.</source>
        <translation>In der Zwischenablage ist kein Bild. Kopieren Sie eines, zum Beispiel mit dem Bildschirmfoto-Werkzeug Ihres Systems.</translation>
    </message>
    <message>
        <source>Another quantity</source>
        <translation>Andere Größe</translation>
    </message>
    <message>
        <source>Searching the page for graphs …</source>
        <translation>Die Seite wird nach Graphen durchsucht …</translation>
    </message>
    <message>
        <source>As it was read, this graph gives no button. If it was misread, click its dashed rectangle. If the page shows another graph, draw its plot frame.</source>
        <translation>So, wie er gelesen wurde, ergibt dieser Graph keinen Taster. Wurde er falsch gelesen, klicken Sie auf sein gestricheltes Rechteck. Zeigt die Seite einen anderen Graphen, zeichnen Sie dessen Rahmen.</translation>
    </message>
    <message>
        <source>The horizontal axis measures no displacement.</source>
        <translation>Die waagerechte Achse misst keinen Weg.</translation>
    </message>
    <message>
        <source>The vertical axis measures no force.</source>
        <translation>Die senkrechte Achse misst keine Kraft.</translation>
    </message>
    <message>
        <source>No button can be imported from this graph. Use Undo to take your answer back.</source>
        <translation>Aus diesem Graphen kann kein Taster importiert werden. Mit „Rückgängig“ nehmen Sie Ihre Antwort zurück.</translation>
    </message>
    <message>
        <source>&amp;Import %1 buttons</source>
        <translation>%1 Taster &amp;importieren</translation>
    </message>
    <message>
        <source>No release curve</source>
        <translation>Keine Rückwegkurve</translation>
    </message>
</context>
<context>
    <name>detent::editor::ImportState</name>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Eingefügtes Bild</translation>
    </message>
    <message>
        <source>Draw plot frame</source>
        <translation>Rahmen zeichnen</translation>
    </message>
    <message>
        <source>Choose switch</source>
        <translation>Taster wählen</translation>
    </message>
</context>
<context>
    <name>detent::editor::KeyFiguresModel</name>
    <message>
        <source>Force at the start of the press; this is the preload, if there is one.</source>
        <translation>Kraft am Anfang des Hinwegs; das ist die Vorspannkraft, falls es eine gibt.</translation>
    </message>
    <message>
        <source>Force of the press at the operating point; keyboards call it actuation force.</source>
        <translation>Kraft des Hinwegs am Schaltpunkt; bei Tastaturen auch Auslösekraft genannt.</translation>
    </message>
    <message>
        <source>Force of the tactile point with the largest drop after it.</source>
        <translation>Kraft des Druckpunkts mit dem größten Abfall danach.</translation>
    </message>
    <message>
        <source>Displacement of the tactile point with the largest drop after it.</source>
        <translation>Weg des Druckpunkts mit dem größten Abfall danach.</translation>
    </message>
    <message>
        <source>Lowest force between the peak and the next tactile point, or the end of the press.</source>
        <translation>Kleinste Kraft zwischen der Spitze und dem nächsten Druckpunkt oder dem Ende des Hinwegs.</translation>
    </message>
    <message>
        <source>Displacement of the lowest force after the peak.</source>
        <translation>Weg der kleinsten Kraft nach der Spitze.</translation>
    </message>
    <message>
        <source>Tactile drop divided by peak force; also called tactile ratio or click ratio.</source>
        <translation>Kraftabfall geteilt durch Spitzenkraft; auch Click Ratio genannt.</translation>
    </message>
    <message>
        <source>Mean slope from the start to the peak; without a peak, to the bottom-out.</source>
        <translation>Mittlere Steigung vom Anfang bis zur Spitze; ohne Spitze bis zum Anschlag.</translation>
    </message>
    <message>
        <source>Mean slope from the peak to the valley (a negative value).</source>
        <translation>Mittlere Steigung von der Spitze bis zum Tal (ein negativer Wert).</translation>
    </message>
    <message>
        <source>Mean slope from the valley to the bottom-out.</source>
        <translation>Mittlere Steigung vom Tal bis zum Anschlag.</translation>
    </message>
    <message>
        <source>Displacement at which the contact opens on the release.</source>
        <translation>Weg, bei dem der Kontakt auf dem Rückweg öffnet.</translation>
    </message>
    <message>
        <source>Force of the release at the reset point (RF).</source>
        <translation>Kraft des Rückwegs am Rückschaltpunkt (RF).</translation>
    </message>
    <message>
        <source>Operating point minus reset point (MD).</source>
        <translation>Schaltpunkt minus Rückschaltpunkt (MD).</translation>
    </message>
    <message>
        <source>From the operating point to the end of the press (OT).</source>
        <translation>Vom Schaltpunkt bis zum Ende des Hinwegs (OT).</translation>
    </message>
    <message>
        <source>Force where the bottom-out starts; without a bottom-out, at the end of the travel.</source>
        <translation>Kraft am Beginn des Anschlags; ohne Anschlag am Ende des Wegs.</translation>
    </message>
    <message>
        <source>Displacement where the bottom-out starts; without a bottom-out, the end of the travel.</source>
        <translation>Weg am Beginn des Anschlags; ohne Anschlag das Ende des Wegs.</translation>
    </message>
    <message>
        <source>Force at the end of the press.</source>
        <translation>Kraft am Ende des Hinwegs.</translation>
    </message>
    <message>
        <source>Area under the press curve.</source>
        <translation>Fläche unter der Hinwegkurve.</translation>
    </message>
    <message>
        <source>Area between press and release: the energy lost in one actuation.</source>
        <translation>Fläche zwischen Hinweg und Rückweg: die Energie, die eine Betätigung kostet.</translation>
    </message>
    <message>
        <source>Key figure</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Set: %1</source>
        <translation>Setzen: %1</translation>
    </message>
    <message>
        <source>This part of the curve is too short for a slope or ratio.</source>
        <translation>Dieser Teil der Kurve ist zu kurz für eine Steigung oder ein Verhältnis.</translation>
    </message>
    <message>
        <source>Displacement of the operating point (PT).</source>
        <translation>Weg am Schaltpunkt (PT).</translation>
    </message>
    <message>
        <source>Displacement of the end of the press (TT).</source>
        <translation>Weg am Ende des Hinwegs (TT).</translation>
    </message>
    <message>
        <source>Peak force minus valley force; the drop the finger feels.</source>
        <translation>Spitzenkraft minus Talkraft; der Abfall, den der Finger spürt.</translation>
    </message>
    <message>
        <source>Set…</source>
        <translation>Setzen …</translation>
    </message>
    <message>
        <source>Lock: %1</source>
        <translation>Sperren: %1</translation>
    </message>
    <message>
        <source>Changes apply immediately; locked figures don&apos;t move.</source>
        <translation>Änderungen gelten sofort; gesperrte Kennzahlen bleiben.</translation>
    </message>
    <message>
        <source>All targets are met together; the dashed curve previews the result.</source>
        <translation>Alle Zielwerte werden gemeinsam erfüllt; die gestrichelte Kurve zeigt das Ergebnis vorab.</translation>
    </message>
    <message>
        <source>Locked figures stay as they are while others change.</source>
        <translation>Gesperrte Kennzahlen bleiben, während sich andere ändern.</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Aktuell</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>No operating point is set. Set it in Edit &gt; Curve &gt; Operating and reset point (Ctrl+Shift+O).</source>
        <translation>Es ist kein Schaltpunkt gesetzt. Setzen Sie ihn unter Bearbeiten &gt; Kurve &gt; Schalt- und Rückschaltpunkt (Strg+Umschalt+O).</translation>
    </message>
    <message>
        <source>No reset point is set. Set it in Edit &gt; Curve &gt; Operating and reset point (Ctrl+Shift+O).</source>
        <translation>Es ist kein Rückschaltpunkt gesetzt. Setzen Sie ihn unter Bearbeiten &gt; Kurve &gt; Schalt- und Rückschaltpunkt (Strg+Umschalt+O).</translation>
    </message>
    <message>
        <source>The button has no release curve. Add one with Edit &gt; Curve &gt; Mirror press to release.</source>
        <translation>Der Taster hat keinen Rückweg. Fügen Sie ihn mit Bearbeiten &gt; Kurve &gt; Hinweg zum Rückweg spiegeln hinzu.</translation>
    </message>
    <message>
        <source>The press has no tactile point. Add one with Edit &gt; Curve &gt; Add jump (Ctrl+Shift+J).</source>
        <translation>Der Hinweg hat keinen Druckpunkt. Fügen Sie ihn mit Bearbeiten &gt; Kurve &gt; Sprung hinzufügen (Strg+Umschalt+J) hinzu.</translation>
    </message>
    <message>
        <source>This figure needs an operating point and a reset point: Edit &gt; Curve &gt; Operating and reset point (Ctrl+Shift+O).</source>
        <translation>Diese Kennzahl braucht Schalt- und Rückschaltpunkt: Bearbeiten &gt; Kurve &gt; Schalt- und Rückschaltpunkt (Strg+Umschalt+O).</translation>
    </message>
</context>
<context>
    <name>detent::editor::KeyFiguresPanel</name>
    <message>
        <source>Key figures of the button</source>
        <translation>Kennzahlen des Tasters</translation>
    </message>
    <message>
        <source>A&amp;ll figures</source>
        <translation>A&amp;lle Kennzahlen</translation>
    </message>
    <message>
        <source>Show all key figures, not only the most used ones</source>
        <translation>Alle Kennzahlen zeigen, nicht nur die gebräuchlichsten</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Anwenden</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>Clear all targets</source>
        <translation>Alle Zielwerte löschen</translation>
    </message>
    <message>
        <source>Solving…</source>
        <translation>Wird gelöst …</translation>
    </message>
    <message>
        <source>Change the curve so that it has the target figures</source>
        <translation>Die Kurve so ändern, dass sie die Zielwerte hat</translation>
    </message>
</context>
<context>
    <name>detent::editor::Keyboard</name>
    <message numerus="yes">
        <source>Move %n points</source>
        <translation>
            <numerusform>%n Punkt verschieben</numerusform>
            <numerusform>%n Punkte verschieben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points selected</source>
        <translation>
            <numerusform>%n Punkt ausgewählt</numerusform>
            <numerusform>%n Punkte ausgewählt</numerusform>
        </translation>
    </message>
    <message>
        <source>Align to the same force</source>
        <translation>Auf gleiche Kraft ausrichten</translation>
    </message>
    <message>
        <source>Align to the same displacement</source>
        <translation>Auf gleichen Weg ausrichten</translation>
    </message>
    <message>
        <source>Distribute over force</source>
        <translation>Über die Kraft verteilen</translation>
    </message>
    <message>
        <source>Distribute over displacement</source>
        <translation>Über den Weg verteilen</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n points</source>
        <translation>
            <numerusform>%n Punkt entfernen</numerusform>
            <numerusform>%n Punkte entfernen</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no curve point at this valley or peak. Select a curve point or a tactile point.</source>
        <translation>An diesem Tal oder dieser Spitze ist kein Kurvenpunkt. Wählen Sie einen Kurvenpunkt oder einen Druckpunkt.</translation>
    </message>
    <message>
        <source>Select a curve point to make it a corner or smooth.</source>
        <translation>Wählen Sie einen Kurvenpunkt, um ihn zur Ecke zu machen oder zu glätten.</translation>
    </message>
    <message>
        <source>Corner or smooth: %1</source>
        <translation>Ecke oder glatt: %1</translation>
    </message>
    <message>
        <source>Add curve point</source>
        <translation>Kurvenpunkt hinzufügen</translation>
    </message>
    <message>
        <source>Unlocked: the point can be moved again.</source>
        <translation>Entsperrt: Der Punkt lässt sich wieder bewegen.</translation>
    </message>
    <message>
        <source>Locked: no edit moves this point until you press P on it again.</source>
        <translation>Gesperrt: Keine Änderung bewegt diesen Punkt, bis Sie auf ihm wieder P drücken.</translation>
    </message>
    <message>
        <source>Unlock a point</source>
        <translation>Punkt entsperren</translation>
    </message>
    <message>
        <source>Lock a point</source>
        <translation>Punkt sperren</translation>
    </message>
</context>
<context>
    <name>detent::editor::LevelMeter</name>
    <message>
        <source>Output level</source>
        <translation>Ausgangspegel</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>still</translation>
    </message>
    <message>
        <source>peak %1 dB</source>
        <translation>Spitze %1 dB</translation>
    </message>
    <message>
        <source>, limited</source>
        <translation>, begrenzt</translation>
    </message>
    <message>
        <source>%1 dB</source>
        <translation>%1 dB</translation>
    </message>
    <message>
        <source>&lt;p&gt;Output level, in dB relative to full scale: the bar is the peak of the last 20 ms; the line and the number are the highest peak (held for 1.5 s).&lt;/p&gt;&lt;p&gt;“limited” appears while the limiter caps the level. Lower the gain to feel the button&apos;s true strength.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Ausgangspegel in dB, bezogen auf Vollaussteuerung: Der Balken ist die Spitze der letzten 20 ms; die Linie und die Zahl sind die höchste Spitze (1,5 s gehalten).&lt;/p&gt;&lt;p&gt;„begrenzt“ erscheint, solange der Begrenzer den Pegel kappt. Senken Sie die Verstärkung, um die wahre Stärke des Tasters zu fühlen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>limited</source>
        <translation>begrenzt</translation>
    </message>
</context>
<context>
    <name>detent::editor::LibraryPanel</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open buttons</source>
        <translation>Offene Taster</translation>
    </message>
    <message>
        <source>Folder of the library</source>
        <translation>Ordner der Sammlung</translation>
    </message>
    <message>
        <source>Choose the folder whose buttons are listed here</source>
        <translation>Den Ordner wählen, dessen Taster hier aufgeführt werden</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Nach Namen filtern</translation>
    </message>
    <message>
        <source>Buttons of the folder</source>
        <translation>Taster des Ordners</translation>
    </message>
    <message>
        <source>Choose a folder…</source>
        <translation>Ordner wählen …</translation>
    </message>
    <message>
        <source>Choose a folder to list its buttons.</source>
        <translation>Wählen Sie einen Ordner, um seine Taster aufzulisten.</translation>
    </message>
    <message>
        <source>This folder has no button file (*.button.json) with this name.</source>
        <translation>Dieser Ordner hat keine Tasterdatei (*.button.json) mit diesem Namen.</translation>
    </message>
    <message>
        <source>Show this button</source>
        <translation>Diesen Taster zeigen</translation>
    </message>
    <message>
        <source>Compare with the button shown</source>
        <translation>Mit dem gezeigten Taster vergleichen</translation>
    </message>
    <message numerus="yes">
        <source>Compare the %n selected</source>
        <translation>
            <numerusform>Den %n gewählten vergleichen</numerusform>
            <numerusform>Die %n gewählten vergleichen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>detent::editor::LogPlot</name>
    <message>
        <source>Measured points and fit</source>
        <translation>Gemessene Punkte und Anpassung</translation>
    </message>
    <message>
        <source>Reading the log …</source>
        <translation>Das Protokoll wird gelesen …</translation>
    </message>
    <message>
        <source>No curve could be read from this log</source>
        <translation>Aus diesem Protokoll ließ sich keine Kurve lesen</translation>
    </message>
    <message>
        <source>Displacement [%1]</source>
        <translation>Weg [%1]</translation>
    </message>
    <message>
        <source>Force [%1]</source>
        <translation>Kraft [%1]</translation>
    </message>
</context>
<context>
    <name>detent::editor::MagneticDialog</name>
    <message>
        <source>Force graph and movement of the key</source>
        <translation>Kraftkurve und Bewegung der Taste</translation>
    </message>
    <message>
        <source>Export for a magnetic keyboard</source>
        <translation>Für eine Magnettastatur exportieren</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Choose a location and write the C header</source>
        <translation>Ort wählen und den C-Header schreiben</translation>
    </message>
    <message>
        <source>&amp;Actuation point:</source>
        <translation>&amp;Auslösepunkt:</translation>
    </message>
    <message>
        <source>Displacement at which the key closes (switches on)</source>
        <translation>Weg, bei dem die Taste schließt (einschaltet)</translation>
    </message>
    <message>
        <source>&amp;Release point:</source>
        <translation>&amp;Rückstellpunkt:</translation>
    </message>
    <message>
        <source>Displacement at which the key opens on its way up</source>
        <translation>Weg, bei dem die Taste auf dem Rückweg öffnet</translation>
    </message>
    <message>
        <source>Rapid &amp;trigger</source>
        <translation>Rapid &amp;Trigger</translation>
    </message>
    <message>
        <source>The key opens and closes as the movement changes direction</source>
        <translation>Die Taste öffnet und schließt, wenn die Bewegung die Richtung wechselt</translation>
    </message>
    <message>
        <source>&amp;Press distance:</source>
        <translation>&amp;Druckstrecke:</translation>
    </message>
    <message>
        <source>How far the key moves down from its highest position before it closes</source>
        <translation>Wie weit sich die Taste von ihrer höchsten Stelle abwärts bewegt, bevor sie schließt</translation>
    </message>
    <message>
        <source>Release &amp;distance:</source>
        <translation>&amp;Loslassstrecke:</translation>
    </message>
    <message>
        <source>How far the key moves up from its deepest position before it opens</source>
        <translation>Wie weit sich die Taste von ihrer tiefsten Stelle aufwärts bewegt, bevor sie öffnet</translation>
    </message>
    <message>
        <source>&amp;Continuous</source>
        <translation>D&amp;urchgehend</translation>
    </message>
    <message>
        <source>Rapid trigger stays active until the key is fully released, even above the release point</source>
        <translation>Rapid Trigger bleibt aktiv, bis die Taste ganz losgelassen ist, auch über dem Rückstellpunkt</translation>
    </message>
    <message>
        <source>T&amp;op dead zone:</source>
        <translation>&amp;Obere Totzone:</translation>
    </message>
    <message>
        <source>First part of the travel, in which the key is always open</source>
        <translation>Erster Teil des Wegs, in dem die Taste immer offen ist</translation>
    </message>
    <message>
        <source>&amp;Bottom dead zone:</source>
        <translation>U&amp;ntere Totzone:</translation>
    </message>
    <message>
        <source>Last part of the travel, in which the key is always closed</source>
        <translation>Letzter Teil des Wegs, in dem die Taste immer geschlossen ist</translation>
    </message>
    <message>
        <source>Presses go do&amp;wn to:</source>
        <translation>Drücken &amp;bis:</translation>
    </message>
    <message>
        <source>How deep both presses of the example movement go</source>
        <translation>Wie tief beide Drücke der Beispielbewegung gehen</translation>
    </message>
    <message>
        <source>and &amp;up to:</source>
        <translation>und &amp;zurück bis:</translation>
    </message>
    <message>
        <source>Displacement at which the second press of the example movement begins</source>
        <translation>Weg, bei dem der zweite Druck der Beispielbewegung beginnt</translation>
    </message>
    <message>
        <source>Readin&amp;gs…</source>
        <translation>&amp;Messwerte …</translation>
    </message>
    <message>
        <source>Load the readings of your sensor over the travel from a CSV file</source>
        <translation>Die Messwerte Ihres Sensors über den Weg aus einer CSV-Datei laden</translation>
    </message>
    <message>
        <source>No readings loaded: a magnet of the usual size is assumed.</source>
        <translation>Keine Messwerte geladen: Ein Magnet üblicher Größe wird angenommen.</translation>
    </message>
    <message>
        <source>Readings of the sensor</source>
        <translation>Messwerte des Sensors</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>Readings from %1.</source>
        <translation>Messwerte aus %1.</translation>
    </message>
    <message>
        <source>Force (%1)</source>
        <translation>Kraft (%1)</translation>
    </message>
    <message>
        <source>Displacement (%1)</source>
        <translation>Weg (%1)</translation>
    </message>
    <message>
        <source>Distance moved (%1)</source>
        <translation>Zurückgelegter Weg (%1)</translation>
    </message>
    <message>
        <source>closes at %1</source>
        <translation>schließt bei %1</translation>
    </message>
    <message>
        <source>opens at %1</source>
        <translation>öffnet bei %1</translation>
    </message>
    <message>
        <source>The key stays open.</source>
        <translation>Die Taste bleibt offen.</translation>
    </message>
    <message>
        <source>The key %1.</source>
        <translation>Die Taste %1.</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Hinweg</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Rückweg</translation>
    </message>
    <message>
        <source>Key closes</source>
        <translation>Taste schließt</translation>
    </message>
    <message>
        <source>Key opens</source>
        <translation>Taste öffnet</translation>
    </message>
    <message>
        <source>Key closed</source>
        <translation>Taste geschlossen</translation>
    </message>
    <message>
        <source>For your own sensor: a CSV file of two columns, the displacement from rest in mm, increasing, and the reading in counts of your converter, which only rises or only falls. Two rows or more. Example:</source>
        <translation>Für den eigenen Sensor: eine CSV-Datei mit zwei Spalten, dem Weg ab der Ruhelage in mm, steigend, und dem Messwert in Schritten des Wandlers, der nur steigt oder nur fällt. Mindestens zwei Zeilen. Beispiel:</translation>
    </message>
</context>
<context>
    <name>detent::editor::MainWindow</name>
    <message>
        <source>Show or hide: %1</source>
        <translation>Zeigen oder verbergen: %1</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Sammlung</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Button B, for comparison</source>
        <translation>Taster B zum Vergleichen</translation>
    </message>
    <message>
        <source>Displacement and force under the mouse</source>
        <translation>Weg und Kraft unter der Maus</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Units that everything is shown and typed in</source>
        <translation>Einheiten, in denen alles gezeigt und eingegeben wird</translation>
    </message>
    <message>
        <source>no other button</source>
        <translation>kein anderer Taster</translation>
    </message>
    <message>
        <source>Detent</source>
        <translation>Detent</translation>
    </message>
    <message>
        <source>%1[*] – Detent</source>
        <translation>%1[*] – Detent</translation>
    </message>
    <message>
        <source>The clipboard holds no picture, no file and nothing copied from a button. Copy a picture of a graph, or points of a curve, first.</source>
        <translation>In der Zwischenablage sind kein Bild, keine Datei und nichts aus einem Taster Kopiertes. Kopieren Sie zuerst ein Bild eines Graphen oder Punkte einer Kurve.</translation>
    </message>
    <message>
        <source>Copied the whole button as text.</source>
        <translation>Der ganze Taster wurde als Text kopiert.</translation>
    </message>
    <message>
        <source>Copied a picture of the graph.</source>
        <translation>Ein Bild des Graphen wurde kopiert.</translation>
    </message>
    <message>
        <source>Copied the samples as CSV, in mm and N.</source>
        <translation>Die Kurvenwerte wurden als CSV kopiert, in mm und N.</translation>
    </message>
    <message>
        <source>Printed %1.</source>
        <translation>%1 gedruckt.</translation>
    </message>
    <message>
        <source>The printer did not accept the print job. Choose another printer, or print to a file.</source>
        <translation>Der Drucker hat den Auftrag nicht angenommen. Wählen Sie einen anderen Drucker, oder drucken Sie in eine Datei.</translation>
    </message>
    <message>
        <source>Rename the button</source>
        <translation>Den Taster umbenennen</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New from template…</source>
        <translation>&amp;Neu aus Vorlage …</translation>
    </message>
    <message>
        <source>Start a new button from a template</source>
        <translation>Einen neuen Taster aus einer Vorlage beginnen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open buttons, datasheets, pictures or CSV files</source>
        <translation>Taster, Datenblätter, Bilder oder CSV-Dateien öffnen</translation>
    </message>
    <message>
        <source>&amp;Import a datasheet…</source>
        <translation>Ein Datenblatt &amp;importieren …</translation>
    </message>
    <message>
        <source>Read the force graph from a picture, PDF, SVG or CSV</source>
        <translation>Den Kraftgraphen aus einem Bild, PDF, SVG oder CSV lesen</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save this button</source>
        <translation>Diesen Taster speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save this button under another name</source>
        <translation>Diesen Taster unter einem anderen Namen speichern</translation>
    </message>
    <message>
        <source>Save a&amp;ll</source>
        <translation>A&amp;lle speichern</translation>
    </message>
    <message>
        <source>Save every button with unsaved changes</source>
        <translation>Alle Taster mit nicht gespeicherten Änderungen speichern</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>&amp;Picture (PNG)…</source>
        <translation>&amp;Bild (PNG) …</translation>
    </message>
    <message>
        <source>&amp;Samples (CSV)…</source>
        <translation>Kurven&amp;werte (CSV) …</translation>
    </message>
    <message>
        <source>Write samples of the state shown, in the units shown or in mm and N</source>
        <translation>Kurvenwerte des gezeigten Zustands schreiben, in den gezeigten Einheiten oder in mm und N</translation>
    </message>
    <message>
        <source>&amp;Vibration of a press (WAV)…</source>
        <translation>&amp;Vibration einer Betätigung (WAV) …</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken …</translation>
    </message>
    <message>
        <source>Print the graph with its values</source>
        <translation>Den Graphen mit seinen Werten drucken</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Close this button</source>
        <translation>Diesen Taster schließen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close all buttons and quit</source>
        <translation>Alle Taster schließen und beenden</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>Den letzten Schritt zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Redo the last undone step</source>
        <translation>Den zuletzt zurückgenommenen Schritt wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Import the picture or file on the clipboard, or paste copied points or a copied button</source>
        <translation>Das Bild oder die Datei in der Zwischenablage importieren, oder kopierte Punkte oder einen kopierten Taster einfügen</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Open a copy of this button in a new tab</source>
        <translation>Eine Kopie dieses Tasters in einem neuen Reiter öffnen</translation>
    </message>
    <message>
        <source>&amp;Copy as picture</source>
        <translation>Als &amp;Bild kopieren</translation>
    </message>
    <message>
        <source>Copy a picture of the graph</source>
        <translation>Ein Bild des Graphen kopieren</translation>
    </message>
    <message>
        <source>Copy as C&amp;SV</source>
        <translation>Als C&amp;SV kopieren</translation>
    </message>
    <message>
        <source>Copy samples of the state shown, in mm and N</source>
        <translation>Kurvenwerte des gezeigten Zustands kopieren, in mm und N</translation>
    </message>
    <message>
        <source>Re&amp;name the button…</source>
        <translation>Den Taster &amp;umbenennen …</translation>
    </message>
    <message>
        <source>Give the button another name</source>
        <translation>Dem Taster einen anderen Namen geben</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Next panel</source>
        <translation>&amp;Nächster Bereich</translation>
    </message>
    <message>
        <source>Move the focus to the next panel</source>
        <translation>Zum nächsten Bereich wechseln</translation>
    </message>
    <message>
        <source>Pre&amp;vious panel</source>
        <translation>&amp;Voriger Bereich</translation>
    </message>
    <message>
        <source>Move the focus to the previous panel</source>
        <translation>Zum vorigen Bereich wechseln</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Den ganzen Bildschirm benutzen</translation>
    </message>
    <message>
        <source>Show displacements in %1</source>
        <translation>Wege in %1 zeigen</translation>
    </message>
    <message>
        <source>Show forces in %1</source>
        <translation>Kräfte in %1 zeigen</translation>
    </message>
    <message>
        <source>&amp;Button</source>
        <translation>&amp;Taster</translation>
    </message>
    <message>
        <source>Predict for all open buttons which of them people will confuse</source>
        <translation>Für alle offenen Taster vorhersagen, welche Menschen verwechseln</translation>
    </message>
    <message>
        <source>&amp;Study with people…</source>
        <translation>&amp;Studie mit Menschen …</translation>
    </message>
    <message>
        <source>Ask people whether they can tell buttons apart</source>
        <translation>Menschen fragen, ob sie Taster unterscheiden können</translation>
    </message>
    <message>
        <source>&amp;Next button</source>
        <translation>&amp;Nächster Taster</translation>
    </message>
    <message>
        <source>Show the next open button</source>
        <translation>Den nächsten offenen Taster zeigen</translation>
    </message>
    <message>
        <source>&amp;Previous button</source>
        <translation>V&amp;origer Taster</translation>
    </message>
    <message>
        <source>Show the previous open button</source>
        <translation>Den vorigen offenen Taster zeigen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>List every action with its keys</source>
        <translation>Jede Aktion mit ihren Tasten aufführen</translation>
    </message>
    <message>
        <source>&amp;About Detent</source>
        <translation>Ü&amp;ber Detent</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version und Lizenz</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederherstellen: %1</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Editing</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>About Detent</source>
        <translation>Über Detent</translation>
    </message>
    <message>
        <source>&lt;b&gt;Detent %1&lt;/b&gt;&lt;p&gt;From a printed force graph to a button you can feel.&lt;/p&gt;&lt;p&gt;GPL-3.0-or-later. Based on work by S. Kim and G. Lee, UIST 2013, and P. Shrestha.&lt;/p&gt;</source>
        <translation>&lt;b&gt;Detent %1&lt;/b&gt;&lt;p&gt;Vom gedruckten Kraftgraphen zum Taster, den man fühlen kann.&lt;/p&gt;&lt;p&gt;GPL-3.0-or-later. Beruht auf Arbeiten von S. Kim und G. Lee, UIST 2013, und P. Shrestha.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Try a sample datasheet</source>
        <translation>Beispiel-Datenblatt aus&amp;probieren</translation>
    </message>
    <message>
        <source>Import a datasheet that comes with Detent, to see how it works</source>
        <translation>Ein mitgeliefertes Datenblatt importieren, um zu sehen, wie es geht</translation>
    </message>
    <message>
        <source>&amp;Keep the page in the file</source>
        <translation>Seite in der Da&amp;tei behalten</translation>
    </message>
    <message>
        <source>Save the part of the page around the graph in the file of the button, so that you see it without the datasheet</source>
        <translation>Den Teil der Seite um den Graphen in der Datei des Tasters speichern, damit Sie ihn ohne Datenblatt sehen</translation>
    </message>
    <message>
        <source>Export the vibration of a standard press (WAV, mono, 48 kHz)</source>
        <translation>Die Vibration einer Standardbetätigung exportieren (WAV, mono, 48 kHz)</translation>
    </message>
    <message>
        <source>For a &amp;device…</source>
        <translation>&amp;Für ein Gerät …</translation>
    </message>
    <message>
        <source>Export a press for phones, headsets, driver chips, firmware and touchpads</source>
        <translation>Eine Betätigung für Telefone, Headsets, Treiberbausteine, Firmware und Touchpads exportieren</translation>
    </message>
    <message>
        <source>S&amp;hare as web page…</source>
        <translation>Als Webseite &amp;teilen …</translation>
    </message>
    <message>
        <source>Write a web page on which anyone can press the button, without installing anything</source>
        <translation>Eine Webseite schreiben, auf der jeder den Taster drücken kann, ohne etwas zu installieren</translation>
    </message>
    <message>
        <source>&amp;Graph for datasheet, paper or slide…</source>
        <translation>&amp;Graph für Datenblatt, Fachartikel oder Folie …</translation>
    </message>
    <message>
        <source>Write the graph ready for print: SVG, PDF or PNG in any size, language and unit</source>
        <translation>Den Graphen druckfertig schreiben: SVG, PDF oder PNG in jeder Größe, Sprache und Einheit</translation>
    </message>
    <message>
        <source>Create a button that lies between two open buttons</source>
        <translation>Einen Taster erzeugen, der zwischen zwei offenen Tastern liegt</translation>
    </message>
    <message>
        <source>Samples with d&amp;ecimal commas (CSV)…</source>
        <translation>Kurvenwerte mit D&amp;ezimalkommas (CSV) …</translation>
    </message>
    <message>
        <source>WebPlotDigitizer p&amp;roject…</source>
        <translation>P&amp;rojekt für WebPlotDigitizer …</translation>
    </message>
    <message>
        <source>Write the state shown as a WebPlotDigitizer project, with axes in the units shown</source>
        <translation>Den gezeigten Zustand als Projekt für WebPlotDigitizer schreiben, mit den gezeigten Einheiten an den Achsen</translation>
    </message>
    <message>
        <source>Write the samples with decimal commas and semicolons, as many spreadsheets expect them</source>
        <translation>Die Kurvenwerte mit Dezimalkomma und Semikolons schreiben, wie viele Tabellenprogramme sie erwarten</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Open a library</source>
        <translation>Sammlung öffnen</translation>
    </message>
    <message>
        <source>Libraries (*.db *.sqlite *.sqlite3)</source>
        <translation>Sammlungen (*.db *.sqlite *.sqlite3)</translation>
    </message>
    <message>
        <source>Add a folder of measurements</source>
        <translation>Ordner mit Messungen hinzufügen</translation>
    </message>
    <message>
        <source>Write a web page</source>
        <translation>Webseite schreiben</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webseiten (*.html)</translation>
    </message>
    <message>
        <source>&amp;Measured switches…</source>
        <translation>&amp;Gemessene Schalter …</translation>
    </message>
    <message>
        <source>&amp;Find similar switches…</source>
        <translation>&amp;Ähnliche Schalter suchen …</translation>
    </message>
    <message>
        <source>List the measured switches nearest to this button</source>
        <translation>Die gemessenen Schalter nennen, die diesem Taster am nächsten sind</translation>
    </message>
    <message>
        <source>&amp;Average open buttons…</source>
        <translation>Mi&amp;ttel der offenen Taster …</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>Fühlen</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>Alle Werte</translation>
    </message>
    <message>
        <source>Compare &amp;with:</source>
        <translation>Vergleichen &amp;mit:</translation>
    </message>
    <message>
        <source>Open a second button first: a blend needs two.</source>
        <translation>Öffnen Sie zuerst einen zweiten Taster: Eine Mischung braucht zwei.</translation>
    </message>
    <message>
        <source>Open a second button first: an average needs two.</source>
        <translation>Öffnen Sie zuerst einen zweiten Taster: Ein Mittelwert braucht zwei.</translation>
    </message>
    <message>
        <source>Copied the key figures as a table.</source>
        <translation>Kennzahlen als Tabelle kopiert.</translation>
    </message>
    <message>
        <source>Write a picture of the graph, 2400 by 1600 pixels. It contains the button, so that Detent can open it again</source>
        <translation>Schreibt ein Bild des Graphen, 2400 mal 1600 Pixel. Es enthält den Taster, sodass Detent es wieder öffnen kann</translation>
    </message>
    <message>
        <source>Samples &amp;at given travels (CSV)…</source>
        <translation>Kurvenwerte &amp;an bestimmten Stellen (CSV) …</translation>
    </message>
    <message>
        <source>Write press and release at even steps of travel, or at the travels you type</source>
        <translation>Schreibt Hinweg und Rückweg in gleichen Wegschritten oder bei den eingegebenen Wegen</translation>
    </message>
    <message>
        <source>Copy key fi&amp;gures</source>
        <translation>Kennzahlen ko&amp;pieren</translation>
    </message>
    <message>
        <source>Copy the key figures as a table for spreadsheets, in the units shown</source>
        <translation>Kopiert die Kennzahlen als Tabelle für Tabellenkalkulationen, in den gezeigten Einheiten</translation>
    </message>
    <message>
        <source>Show the graph and its inspector</source>
        <translation>Zeigt den Graphen und seinen Inspektor</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleichen</translation>
    </message>
    <message>
        <source>Overlay buttons and show their differences</source>
        <translation>Zeigt Taster übereinander, mit ihren Unterschieden</translation>
    </message>
    <message>
        <source>Fee&amp;l</source>
        <translation>Füh&amp;len</translation>
    </message>
    <message>
        <source>Press the button, hear it and see its vibration</source>
        <translation>Den Taster drücken, hören und seine Vibration sehen</translation>
    </message>
    <message>
        <source>&amp;Blend two buttons…</source>
        <translation>Zwei Taster &amp;mischen …</translation>
    </message>
    <message>
        <source>Predicted &amp;confusion…</source>
        <translation>Vorhergesagte &amp;Verwechslung …</translation>
    </message>
    <message>
        <source>&amp;Clear list</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>&amp;Reference curve</source>
        <translation>&amp;Referenzkurve</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Keine</translation>
    </message>
    <message>
        <source>This button as it is &amp;now</source>
        <translation>Dieser Taster, wie er &amp;jetzt ist</translation>
    </message>
    <message>
        <source>%1 (version)</source>
        <translation>%1 (Version)</translation>
    </message>
    <message>
        <source>Import &amp;many files…</source>
        <translation>&amp;Viele Dateien importieren …</translation>
    </message>
    <message>
        <source>Import files or a folder in the background, with a list of results</source>
        <translation>Dateien oder einen Ordner im Hintergrund importieren, mit einer Liste der Ergebnisse</translation>
    </message>
    <message>
        <source>Pre&amp;ferences…</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>Units, theme, language and layout</source>
        <translation>Einheiten, Farben, Sprache und Anordnung</translation>
    </message>
    <message>
        <source>&amp;User&apos;s guide</source>
        <translation>&amp;Benutzerhandbuch</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>&amp;Glossar</translation>
    </message>
    <message>
        <source>Read how to use Detent</source>
        <translation>Lesen, wie man Detent benutzt</translation>
    </message>
    <message>
        <source>Show in pictures what each figure measures</source>
        <translation>In Bildern zeigen, was jeder Kennwert misst</translation>
    </message>
    <message>
        <source>For a &amp;magnetic keyboard…</source>
        <translation>Für eine &amp;Magnettastatur …</translation>
    </message>
    <message>
        <source>Choose rapid trigger and dead zones, see what the key does, export a C header</source>
        <translation>Rapid Trigger und Totzonen wählen, sehen, was die Taste tut, einen C-Header exportieren</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>A&amp;nordnen</translation>
    </message>
    <message>
        <source>Cur&amp;ve</source>
        <translation>Kur&amp;ve</translation>
    </message>
    <message>
        <source>Copy a&amp;s</source>
        <translation>Kopieren a&amp;ls</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>The reference curve, %1</source>
        <translation>Die Referenzkurve, %1</translation>
    </message>
    <message>
        <source>Open the reference curve as a button and compare it</source>
        <translation>Die Referenzkurve als Taster öffnen und vergleichen</translation>
    </message>
    <message>
        <source>As on the &amp;page</source>
        <translation>Wie auf der &amp;Seite</translation>
    </message>
    <message>
        <source>Show each button in the units of the page that it was read from</source>
        <translation>Jeden Taster in den Einheiten der Seite zeigen, von der er gelesen wurde</translation>
    </message>
    <message>
        <source>Second button (B), which you can press in turn with the button shown</source>
        <translation>Zweiter Taster (B), den Sie abwechselnd mit dem gezeigten drücken können</translation>
    </message>
    <message>
        <source>Data pac&amp;kage (described tables)…</source>
        <translation>Datenpa&amp;ket (beschriebene Tabellen) …</translation>
    </message>
    <message>
        <source>Write a folder of tables (curve and key figures), with a description of every column and its unit, as the standard Frictionless Data Package requires</source>
        <translation>Einen Ordner mit Tabellen (Kurve und Kennzahlen) schreiben, mit einer Beschreibung jeder Spalte und ihrer Einheit, wie es der Standard Frictionless Data Package verlangt</translation>
    </message>
    <message>
        <source>Create the mean of several specimens of one button, and show their spread</source>
        <translation>Aus mehreren Exemplaren einen mittleren Taster erzeugen und ihre Streuung zeigen</translation>
    </message>
    <message>
        <source>Look through measured switches: table, map, curves</source>
        <translation>Gemessene Schalter durchsehen: Tabelle, Karte, Kurven</translation>
    </message>
</context>
<context>
    <name>detent::editor::MarginOverlay</name>
    <message>
        <source>Slopes that the force device can reproduce without vibrating</source>
        <translation>Steigungen, die das Kraftgerät wiedergeben kann, ohne zu schwingen</translation>
    </message>
    <message>
        <source>%1, device limit %2</source>
        <translation>%1, Grenze des Geräts %2</translation>
    </message>
</context>
<context>
    <name>detent::editor::MaskBoxTool</name>
    <message>
        <source>Drag a rectangle over parts that are not a curve: texts, arrows, stamps.</source>
        <translation>Ziehen Sie ein Rechteck über Teile, die keine Kurve sind: Texte, Pfeile, Stempel.</translation>
    </message>
    <message>
        <source>Mask rectangle</source>
        <translation>Rechteck maskieren</translation>
    </message>
</context>
<context>
    <name>detent::editor::MaskBrushTool</name>
    <message>
        <source>Paint mask</source>
        <translation>Maske malen</translation>
    </message>
    <message>
        <source>Paint over parts that are not a curve. [ and ] change the size of the brush.</source>
        <translation>Übermalen Sie Teile, die keine Kurve sind. [ und ] ändern die Größe des Pinsels.</translation>
    </message>
</context>
<context>
    <name>detent::editor::MeasureTool</name>
    <message>
        <source>Drag from one place to another, or click both, to measure between them. Ctrl: no snapping.</source>
        <translation>Von einer Stelle zur anderen ziehen oder beide anklicken, um dazwischen zu messen. Strg: kein Einrasten.</translation>
    </message>
</context>
<context>
    <name>detent::editor::MeasuredTable</name>
    <message>
        <source>%1
The value after ± is the standard error from the meter&apos;s noise and resolution; calibration errors are not included</source>
        <translation>%1
Der Wert nach ± ist der Standardfehler aus Rauschen und Auflösung des Messgeräts; Kalibrierfehler sind nicht enthalten</translation>
    </message>
    <message>
        <source>By the tactile drop: linear below 5 gf, tactile above 8 gf, otherwise intermediate</source>
        <translation>Nach dem Kraftabfall: linear unter 5 gf, taktil über 8 gf, sonst dazwischen</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Distance from the reference switch. 1 is the usual difference between two laboratories that measure the same switch; below 1, both may be the same switch</source>
        <translation>Abstand zum Referenzschalter. 1 ist der übliche Unterschied zweier Labore, die denselben Schalter messen; unter 1 kann es derselbe Schalter sein</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Predicted difference in feel from the reference switch; only for the nearest switches</source>
        <translation>Vorhergesagter fühlbarer Unterschied zum Referenzschalter; nur für die nächsten Schalter</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>Vorhersage</translation>
    </message>
    <message>
        <source>Licence of the measurements, from their folder</source>
        <translation>Lizenz der Messungen, aus ihrem Ordner</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Lizenz</translation>
    </message>
    <message>
        <source>Author of the measurements</source>
        <translation>Urheber der Messungen</translation>
    </message>
    <message>
        <source>Credit</source>
        <translation>Urheber</translation>
    </message>
    <message>
        <source>The file the switch was read from</source>
        <translation>Die Datei, aus der der Schalter gelesen wurde</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
</context>
<context>
    <name>detent::editor::MeasuredWindow</name>
    <message numerus="yes">
        <source>Forces of %n of these switches may differ greatly from those of other laboratories.</source>
        <translation>
            <numerusform>Die Kräfte von %n dieser Schalter können stark von denen anderer Labore abweichen.</numerusform>
            <numerusform>Die Kräfte von %n dieser Schalter können stark von denen anderer Labore abweichen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Measured switches</source>
        <translation>Gemessene Schalter</translation>
    </message>
    <message>
        <source>Progress of reading the folders</source>
        <translation>Fortschritt beim Lesen der Ordner</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop reading and keep what was read</source>
        <translation>Mit dem Lesen aufhören und Gelesenes behalten</translation>
    </message>
    <message>
        <source>Rejected files…</source>
        <translation>Abgelehnte Dateien …</translation>
    </message>
    <message>
        <source>Which files were rejected, and why</source>
        <translation>Welche Dateien abgelehnt wurden, und warum</translation>
    </message>
    <message>
        <source>&amp;Add a folder…</source>
        <translation>Ordner &amp;hinzufügen …</translation>
    </message>
    <message>
        <source>Read the measurements in a folder and its subfolders</source>
        <translation>Die Messungen eines Ordners und seiner Unterordner lesen</translation>
    </message>
    <message>
        <source>&amp;Open a library…</source>
        <translation>Sammlung ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Folders and files of the library</source>
        <translation>Ordner und Dateien der Sammlung</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Sammlung</translation>
    </message>
    <message>
        <source>&amp;Library</source>
        <translation>&amp;Sammlung</translation>
    </message>
    <message>
        <source>&amp;Read the folders again</source>
        <translation>Ordner &amp;neu lesen</translation>
    </message>
    <message>
        <source>Read the folders again, but only files that have changed</source>
        <translation>Die Ordner neu lesen, aber nur geänderte Dateien</translation>
    </message>
    <message>
        <source>Include &amp;datasheets</source>
        <translation>&amp;Datenblätter einbeziehen</translation>
    </message>
    <message>
        <source>&amp;Open another library…</source>
        <translation>Andere Sammlung ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>The switches that feel like this one come first, with their distance</source>
        <translation>Schalter, die sich so anfühlen, stehen zuerst, mit ihrem Abstand</translation>
    </message>
    <message>
        <source>Feels like</source>
        <translation>Fühlt sich an wie</translation>
    </message>
    <message>
        <source>Feels li&amp;ke:</source>
        <translation>Fühlt sich an &amp;wie:</translation>
    </message>
    <message>
        <source>Click a dot or draw a rectangle to select; hold Ctrl to add to the selection; double-click to show all</source>
        <translation>Einen Punkt anklicken oder ein Rechteck ziehen, um auszuwählen; mit Strg zur Auswahl hinzufügen; ein Doppelklick zeigt alles</translation>
    </message>
    <message>
        <source>Map of the switches shown</source>
        <translation>Karte der gezeigten Schalter</translation>
    </message>
    <message>
        <source>Main difference %1</source>
        <translation>Hauptunterschied %1</translation>
    </message>
    <message>
        <source>Horizontal axis of the map</source>
        <translation>Waagerechte Achse der Karte</translation>
    </message>
    <message>
        <source>Vertical axis of the map</source>
        <translation>Senkrechte Achse der Karte</translation>
    </message>
    <message>
        <source>Map: ho&amp;rizontal</source>
        <translation>Karte: waage&amp;recht</translation>
    </message>
    <message>
        <source>&amp;vertical</source>
        <translation>senkre&amp;cht</translation>
    </message>
    <message>
        <source>Find &amp;similar</source>
        <translation>&amp;Ähnliche suchen</translation>
    </message>
    <message>
        <source>List the switches most similar to the selected one first</source>
        <translation>Die Schalter zuerst nennen, die dem gewählten am ähnlichsten sind</translation>
    </message>
    <message>
        <source>Open as a &amp;button</source>
        <translation>Als &amp;Taster öffnen</translation>
    </message>
    <message>
        <source>Open the selected switches as buttons, each in a new tab</source>
        <translation>Die gewählten Schalter als Taster öffnen, jeden in einem neuen Reiter</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleichen</translation>
    </message>
    <message>
        <source>Open two to six selected switches and overlay their curves</source>
        <translation>Zwei bis sechs gewählte Schalter öffnen und übereinanderlegen</translation>
    </message>
    <message>
        <source>Write the most similar switches as a web page with plots, to send to others</source>
        <translation>Die ähnlichsten Schalter als Webseite mit Diagrammen schreiben, die man verschicken kann</translation>
    </message>
    <message>
        <source>Curves of the selected switches</source>
        <translation>Kurven der gewählten Schalter</translation>
    </message>
    <message>
        <source>None of the folders of the library was found. Add one.</source>
        <translation>Keiner der Ordner der Sammlung wurde gefunden. Fügen Sie einen hinzu.</translation>
    </message>
    <message>
        <source>%1 files read (%2 switches), %3 unchanged, %4 rejected, %5 removed.</source>
        <translation>%1 Dateien gelesen (%2 Schalter), %3 unverändert, %4 abgelehnt, %5 entfernt.</translation>
    </message>
    <message>
        <source>Rejected files</source>
        <translation>Abgelehnte Dateien</translation>
    </message>
    <message>
        <source>Measured switches – %1</source>
        <translation>Gemessene Schalter – %1</translation>
    </message>
    <message>
        <source>no reference</source>
        <translation>keine Referenz</translation>
    </message>
    <message>
        <source>%L1 of %L2 switches</source>
        <translation>%L1 von %L2 Schaltern</translation>
    </message>
    <message>
        <source>All shown</source>
        <translation>Alle gezeigten</translation>
    </message>
    <message>
        <source>%1. Credit: %2. Licence: %3.</source>
        <translation>%1. Urheber: %2. Lizenz: %3.</translation>
    </message>
    <message>
        <source>Written: %1.</source>
        <translation>Geschrieben: %1.</translation>
    </message>
    <message>
        <source>Show a library file that the command `detent-import library` made</source>
        <translation>Eine Bibliotheksdatei zeigen, die der Befehl „detent-import library“ angelegt hat</translation>
    </message>
    <message>
        <source>Also read force graphs from PDF, SVG and picture files in the folders. This takes some seconds per page, but only the first time</source>
        <translation>Auch Kraftgraphen aus PDF-, SVG- und Bilddateien in den Ordnern lesen. Das dauert einige Sekunden je Seite, aber nur beim ersten Mal</translation>
    </message>
    <message>
        <source>Measurements of more than 1,500 key switches are published. Download one of these collections (force-curves-tidy, Open-Switch-Curve-Meter, topre-force-curves …) or take your own measurements (CSV, ODS, JSON, button files). Then add their folder. Detent contains no measurements; each one shows its author and licence.</source>
        <translation>Messungen von mehr als 1.500 Tastenschaltern sind veröffentlicht. Laden Sie eine dieser Sammlungen herunter (force-curves-tidy, Open-Switch-Curve-Meter, topre-force-curves …), oder verwenden Sie eigene Messungen (CSV, ODS, JSON, Taster-Dateien). Fügen Sie dann deren Ordner hinzu. Detent enthält keine Messungen; zu jeder werden Urheber und Lizenz angezeigt.</translation>
    </message>
    <message>
        <source>Write a &amp;web page…</source>
        <translation>Webse&amp;ite schreiben …</translation>
    </message>
</context>
<context>
    <name>detent::editor::MorphDialog</name>
    <message>
        <source>The button at the left end of the slider</source>
        <translation>Der Taster am linken Ende des Schiebers</translation>
    </message>
    <message>
        <source>The button at the right end of the slider</source>
        <translation>Der Taster am rechten Ende des Schiebers</translation>
    </message>
    <message>
        <source>0 % = first button, 100 % = second</source>
        <translation>0 % = erster Taster, 100 % = zweiter</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Mischung</translation>
    </message>
    <message>
        <source>The three force graphs, overlaid</source>
        <translation>Die drei Kraftgraphen übereinander</translation>
    </message>
    <message>
        <source>&amp;From (A):</source>
        <translation>&amp;Von (A):</translation>
    </message>
    <message>
        <source>&amp;To (B):</source>
        <translation>&amp;Nach (B):</translation>
    </message>
    <message>
        <source>&amp;Share of B:</source>
        <translation>&amp;Anteil von B:</translation>
    </message>
    <message>
        <source>&amp;Create</source>
        <translation>&amp;Erstellen</translation>
    </message>
    <message>
        <source>Opens the blended button in a new tab</source>
        <translation>Öffnet den gemischten Taster in einem neuen Reiter</translation>
    </message>
    <message>
        <source>Compared with A: %1</source>
        <translation>Gegenüber A: %1</translation>
    </message>
    <message>
        <source>Compared with B: %1</source>
        <translation>Gegenüber B: %1</translation>
    </message>
    <message>
        <source>Blend two buttons</source>
        <translation>Zwei Taster mischen</translation>
    </message>
</context>
<context>
    <name>detent::editor::NoticeBar</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>detent::editor::OpenButtonsModel</name>
    <message>
        <source>Not saved yet</source>
        <translation>Noch nicht gespeichert</translation>
    </message>
    <message>
        <source>%1
Compared with the button shown: %2</source>
        <translation>%1
Gegenüber dem gezeigten Taster: %2</translation>
    </message>
    <message>
        <source>%1, with unsaved changes</source>
        <translation>%1, mit nicht gespeicherten Änderungen</translation>
    </message>
</context>
<context>
    <name>detent::editor::OperationDialog</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>detent::editor::OperationMenu</name>
    <message>
        <source>Add &amp;jump…</source>
        <translation>&amp;Sprung hinzufügen …</translation>
    </message>
    <message>
        <source>Add a tactile point with its valley by entering numbers</source>
        <translation>Einen Druckpunkt mit seinem Tal durch Eingabe von Zahlen hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Remove jump…</source>
        <translation>Sprung &amp;entfernen …</translation>
    </message>
    <message>
        <source>Replace a tactile point and its valley by a straight line</source>
        <translation>Einen Druckpunkt und sein Tal durch eine Gerade ersetzen</translation>
    </message>
    <message>
        <source>Snap r&amp;atio…</source>
        <translation>Schn&amp;appverhältnis …</translation>
    </message>
    <message>
        <source>Make &amp;linear…</source>
        <translation>&amp;Linear machen …</translation>
    </message>
    <message>
        <source>Replace the curve by a straight line up to the bottom-out</source>
        <translation>Die Kurve durch eine Gerade bis zum Anschlag ersetzen</translation>
    </message>
    <message>
        <source>&amp;Mirror press to release…</source>
        <translation>&amp;Hinweg zum Rückweg spiegeln …</translation>
    </message>
    <message>
        <source>Remove release &amp;curve…</source>
        <translation>&amp;Rückweg entfernen …</translation>
    </message>
    <message>
        <source>Remove the release curve; the release follows the press curve</source>
        <translation>Die Rückwegkurve entfernen; der Rückweg folgt dann der Hinwegkurve</translation>
    </message>
    <message>
        <source>Scale &amp;force…</source>
        <translation>&amp;Kraft skalieren …</translation>
    </message>
    <message>
        <source>Multiply all forces by one factor</source>
        <translation>Alle Kräfte mit einem Faktor multiplizieren</translation>
    </message>
    <message>
        <source>Scale &amp;travel…</source>
        <translation>&amp;Weg skalieren …</translation>
    </message>
    <message>
        <source>Multiply all displacements by one factor</source>
        <translation>Alle Wege mit einem Faktor multiplizieren</translation>
    </message>
    <message>
        <source>Ref&amp;it curve…</source>
        <translation>Kurve neu an&amp;passen …</translation>
    </message>
    <message>
        <source>Fit the curves to the traced points again, with another number of pieces</source>
        <translation>Die Kurven mit einer anderen Zahl von Stücken neu an die abgelesenen Punkte anpassen</translation>
    </message>
    <message>
        <source>&amp;Operating and reset point…</source>
        <translation>S&amp;chalt- und Rückschaltpunkt …</translation>
    </message>
    <message>
        <source>Set where the contact closes and opens</source>
        <translation>Festlegen, wo der Kontakt schließt und öffnet</translation>
    </message>
    <message>
        <source>&amp;Damping…</source>
        <translation>&amp;Dämpfung …</translation>
    </message>
    <message>
        <source>Switch damping for force feedback on or off</source>
        <translation>Dämpfung für Kraftrückmeldung ein- oder ausschalten</translation>
    </message>
    <message>
        <source>T&amp;wo-level button…</source>
        <translation>&amp;Zweistufiger Taster …</translation>
    </message>
    <message>
        <source>Replace the curves by ones with two tactile points, as on a camera&apos;s shutter button</source>
        <translation>Die Kurven durch solche mit zwei Druckpunkten ersetzen, wie beim Auslöser einer Kamera</translation>
    </message>
    <message>
        <source>&amp;Self-locking button…</source>
        <translation>Ras&amp;tender Taster …</translation>
    </message>
    <message>
        <source>Replace the button by one with two states that alternate at each actuation</source>
        <translation>Den Taster durch einen mit zwei Zuständen ersetzen, die bei jeder Betätigung wechseln</translation>
    </message>
    <message>
        <source>Add stat&amp;e…</source>
        <translation>Z&amp;ustand hinzufügen …</translation>
    </message>
    <message>
        <source>Add a second state, as a copy of this one</source>
        <translation>Einen zweiten Zustand hinzufügen, als Kopie von diesem</translation>
    </message>
    <message>
        <source>Remo&amp;ve state…</source>
        <translation>Zustand ent&amp;fernen …</translation>
    </message>
    <message>
        <source>Remove this state; only the other state remains</source>
        <translation>Diesen Zustand entfernen; nur der andere Zustand bleibt</translation>
    </message>
    <message>
        <source>Reading the traced points from the page…</source>
        <translation>Die Punkte werden von der Seite abgelesen …</translation>
    </message>
    <message>
        <source>Create a release curve from the press, lower by a force</source>
        <translation>Eine Rückwegkurve aus dem Hinweg erzeugen, um eine Kraft tiefer</translation>
    </message>
    <message>
        <source>Set how deep the valley lies below the peak force</source>
        <translation>Festlegen, wie tief das Tal unter der Spitzenkraft liegt</translation>
    </message>
</context>
<context>
    <name>detent::editor::OriginMark</name>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Restore the value that Detent found</source>
        <translation>Den Wert wiederherstellen, den Detent gefunden hat</translation>
    </message>
    <message>
        <source>set by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>found, %1 % sure</source>
        <translation>gefunden, %1 % sicher</translation>
    </message>
</context>
<context>
    <name>detent::editor::OverlayPlot</name>
    <message numerus="yes">
        <source>press of %n switches, ± 1 standard deviation</source>
        <translation>
            <numerusform>Hinweg von %n Schalter, ± 1 Standardabweichung</numerusform>
            <numerusform>Hinweg von %n Schaltern, ± 1 Standardabweichung</numerusform>
        </translation>
    </message>
    <message>
        <source>Displacement from first contact (%1)</source>
        <translation>Weg ab erster Berührung (%1)</translation>
    </message>
    <message>
        <source>Force (%1)</source>
        <translation>Kraft (%1)</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
</context>
<context>
    <name>detent::editor::PageList</name>
    <message>
        <source>Pages and graphs</source>
        <translation>Seiten und Graphen</translation>
    </message>
</context>
<context>
    <name>detent::editor::PageListModel</name>
    <message>
        <source>Page %1: cannot be read</source>
        <translation>Seite %1: nicht lesbar</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>Page %1 …</source>
        <translation>Seite %1 …</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Page %1 is still being searched for graphs</source>
        <translation>Seite %1 wird noch nach Graphen durchsucht</translation>
    </message>
    <message>
        <source>Graph %1, %2
%3</source>
        <translation>Graph %1, %2
%3</translation>
    </message>
    <message>
        <source>Page %1, graph %2, %3, %4</source>
        <translation>Seite %1, Graph %2, %3, %4</translation>
    </message>
    <message>
        <source>Graph %1 of page %2: %3. Tick several to import them together.</source>
        <translation>Graph %1 auf Seite %2: %3. Kreuzen Sie mehrere an, um sie zusammen zu importieren.</translation>
    </message>
</context>
<context>
    <name>detent::editor::PageReturn</name>
    <message>
        <source>%1 was found, but the graph could not be read again. %2</source>
        <translation>%1 wurde gefunden, aber der Graph ließ sich nicht noch einmal lesen. %2</translation>
    </message>
    <message>
        <source>The button was read from another datasheet, %1. Choose that file.</source>
        <translation>Der Taster wurde aus einem anderen Datenblatt gelesen, %1. Wählen Sie diese Datei.</translation>
    </message>
</context>
<context>
    <name>detent::editor::PageTool</name>
    <message>
        <source>top left corner</source>
        <translation>Die Ecke oben links</translation>
    </message>
    <message>
        <source>top right corner</source>
        <translation>Die Ecke oben rechts</translation>
    </message>
    <message>
        <source>bottom right corner</source>
        <translation>Die Ecke unten rechts</translation>
    </message>
    <message>
        <source>bottom left corner</source>
        <translation>Die Ecke unten links</translation>
    </message>
</context>
<context>
    <name>detent::editor::PageView</name>
    <message>
        <source>Page with findings</source>
        <translation>Seite mit Befunden</translation>
    </message>
    <message>
        <source>The page with plot frame, axis ticks and curves as found. Tab moves through corners and ticks, arrow keys move the selected one, Enter opens its value.</source>
        <translation>Die Seite mit Rahmen, Teilstrichen und Kurven, wie gefunden. Tab geht durch Ecken und Teilstriche, Pfeiltasten verschieben sie, die Eingabetaste öffnet einen Wert.</translation>
    </message>
    <message>
        <source>Value of the displacement tick</source>
        <translation>Wert des Teilstrichs der Wegachse</translation>
    </message>
    <message>
        <source>Value of the force tick</source>
        <translation>Wert des Teilstrichs der Kraftachse</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>value in %1</source>
        <translation>Wert in %1</translation>
    </message>
    <message>
        <source>Set displacement tick</source>
        <translation>Teilstrich der Wegachse setzen</translation>
    </message>
    <message>
        <source>Set force tick</source>
        <translation>Teilstrich der Kraftachse setzen</translation>
    </message>
    <message>
        <source>Value of both axes at their common corner</source>
        <translation>Wert beider Achsen in ihrer gemeinsamen Ecke</translation>
    </message>
    <message>
        <source>value of both axes</source>
        <translation>Wert beider Achsen</translation>
    </message>
    <message>
        <source>Set the origin</source>
        <translation>Ursprung setzen</translation>
    </message>
    <message>
        <source>Opening %1 …</source>
        <translation>%1 wird geöffnet …</translation>
    </message>
    <message>
        <source>Drop a datasheet or a force meter&apos;s log here,
paste a picture of a graph (%1),
or open a file (%2).</source>
        <translation>Legen Sie hier ein Datenblatt oder das Protokoll eines Kraftmessgeräts ab,
fügen Sie ein Bild eines Graphen ein (%1),
oder öffnen Sie eine Datei (%2).</translation>
    </message>
    <message>
        <source>Graph %1: click to import it</source>
        <translation>Graph %1: Klicken Sie, um ihn zu importieren</translation>
    </message>
    <message>
        <source>Not recognised as a force graph: %1 Click to import it by hand.</source>
        <translation>Nicht als Kraftgraph erkannt: %1 Klicken Sie, um ihn von Hand zu importieren.</translation>
    </message>
    <message>
        <source>This page is still being searched. Your click takes effect as soon as that is done.</source>
        <translation>Diese Seite wird noch durchsucht. Ihr Klick wirkt, sobald das fertig ist.</translation>
    </message>
</context>
<context>
    <name>detent::editor::PanTool</name>
    <message>
        <source>Drag the page. With any other tool, drag with the middle button, or hold Space and drag.</source>
        <translation>Ziehen Sie die Seite. Mit jedem anderen Werkzeug: mit der mittleren Maustaste ziehen, oder mit gedrückter Leertaste.</translation>
    </message>
    <message>
        <source>Drag to move the view; the wheel zooms at the pointer.</source>
        <translation>Ziehen verschiebt die Ansicht; das Mausrad vergrößert am Zeiger.</translation>
    </message>
</context>
<context>
    <name>detent::editor::PipetteTool</name>
    <message>
        <source>Pick press curve</source>
        <translation>Hinwegkurve wählen</translation>
    </message>
    <message>
        <source>Pick release curve</source>
        <translation>Rückwegkurve wählen</translation>
    </message>
    <message>
        <source>Click the press curve.</source>
        <translation>Klicken Sie die Hinwegkurve an.</translation>
    </message>
    <message>
        <source>Click the release curve.</source>
        <translation>Klicken Sie die Rückwegkurve an.</translation>
    </message>
</context>
<context>
    <name>detent::editor::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Z&amp;urücksetzen</translation>
    </message>
    <message>
        <source>Layout of the window:</source>
        <translation>Anordnung des Fensters:</translation>
    </message>
    <message>
        <source>Unit of all displacements that are shown or typed</source>
        <translation>Einheit aller Wege, die gezeigt oder eingegeben werden</translation>
    </message>
    <message>
        <source>Unit of all forces that are shown or typed</source>
        <translation>Einheit aller Kräfte, die gezeigt oder eingegeben werden</translation>
    </message>
    <message>
        <source>&amp;Displacement:</source>
        <translation>&amp;Weg:</translation>
    </message>
    <message>
        <source>&amp;Force:</source>
        <translation>&amp;Kraft:</translation>
    </message>
    <message>
        <source>Light or dark window</source>
        <translation>Helles oder dunkles Fenster</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>&amp;Farben:</translation>
    </message>
    <message>
        <source>Lan&amp;guage:</source>
        <translation>&amp;Sprache:</translation>
    </message>
    <message>
        <source>Move all panels back to their initial places</source>
        <translation>Alle Felder an ihre anfänglichen Plätze zurückstellen</translation>
    </message>
    <message>
        <source>same as system</source>
        <translation>wie das System</translation>
    </message>
    <message>
        <source>Language of all texts and format of numbers</source>
        <translation>Sprache aller Texte und Schreibweise der Zahlen</translation>
    </message>
    <message>
        <source>The language changes when Detent is restarted.</source>
        <translation>Die Sprache wechselt, wenn Detent neu gestartet wird.</translation>
    </message>
</context>
<context>
    <name>detent::editor::PressPad</name>
    <message>
        <source>Press pad</source>
        <translation>Druckfeld</translation>
    </message>
    <message>
        <source>Press and hold Space or Enter to press the button. Mouse, pen and touch press it too.</source>
        <translation>Halten Sie die Leertaste oder die Eingabetaste gedrückt, um den Taster zu drücken. Maus, Stift und Berührung drücken ihn auch.</translation>
    </message>
    <message>
        <source>&lt;p&gt;Press the button: hold &lt;b&gt;Space&lt;/b&gt; or &lt;b&gt;Enter&lt;/b&gt;, the mouse button, a finger, or a pen (its pressure is the force).&lt;/p&gt;&lt;p&gt;The scales show depth and force; indicators light up for what is felt.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Drücken Sie den Taster: Halten Sie die &lt;b&gt;Leertaste&lt;/b&gt;, die &lt;b&gt;Eingabetaste&lt;/b&gt;, die Maustaste, einen Finger oder einen Stift gedrückt (der Stiftdruck ist die Kraft).&lt;/p&gt;&lt;p&gt;Die Skalen zeigen Tiefe und Kraft; Anzeigen leuchten bei dem auf, was zu fühlen ist.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Open a button to press it.</source>
        <translation>Öffnen Sie einen Taster, um ihn zu drücken.</translation>
    </message>
    <message>
        <source>hold to press</source>
        <translation>zum Drücken halten</translation>
    </message>
    <message>
        <source>drag down to press</source>
        <translation>zum Drücken nach unten ziehen</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>jump</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>bottom-out</source>
        <translation>Anschlag</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Space · mouse · pen · touch</source>
        <translation>Leertaste · Maus · Stift · Berührung</translation>
    </message>
    <message>
        <source>release stroke</source>
        <translation>Rückweg</translation>
    </message>
    <message>
        <source>press stroke</source>
        <translation>Hinweg</translation>
    </message>
</context>
<context>
    <name>detent::editor::PressStrip</name>
    <message>
        <source>Last presses</source>
        <translation>Letzte Betätigungen</translation>
    </message>
    <message>
        <source>&lt;p&gt;The last 3 seconds: depth of the finger (down is deeper), and what was felt.&lt;/p&gt;&lt;p&gt;Short ticks: vibration pulses of the slopes. Bars: jumps of the press and release stroke, bottom-out. The line above shows when the contact is closed.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Die letzten 3 Sekunden: Tiefe des Fingers (unten ist tiefer) und was zu fühlen war.&lt;/p&gt;&lt;p&gt;Kurze Striche: Vibrationsimpulse der Steigungen. Balken: Sprünge des Hinwegs und des Rückwegs, Anschlag. Die Linie darüber zeigt, wann der Kontakt geschlossen ist.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Live trace</source>
        <translation>Laufende Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>detent::editor::QuantityField</name>
    <message>
        <source>Between %1 and %2</source>
        <translation>Zwischen %1 und %2</translation>
    </message>
</context>
<context>
    <name>detent::editor::RecoveryController</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Detent ended unexpectedly and kept unsaved changes: %1</source>
        <translation>Detent wurde unerwartet beendet und hat nicht gespeicherte Änderungen bewahrt: %1</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>Verwerfen …</translation>
    </message>
    <message>
        <source>Discard the unsaved changes permanently?</source>
        <translation>Die nicht gespeicherten Änderungen endgültig verwerfen?</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Recover unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen wiederherstellen</translation>
    </message>
</context>
<context>
    <name>detent::editor::RecoveryStore</name>
    <message>
        <source>Autosave is off: the folder %1 cannot be written. Save manually.</source>
        <translation>Das automatische Sichern ist aus: In den Ordner %1 lässt sich nicht schreiben. Speichern Sie Ihre Arbeit selbst.</translation>
    </message>
</context>
<context>
    <name>detent::editor::ResultBox</name>
    <message>
        <source>%1 %2 ms</source>
        <translation>%1 %2 ms</translation>
    </message>
    <message>
        <source>Computed in %1 ms: %2</source>
        <translation>In %1 ms berechnet: %2</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Printed on the page:
%1</source>
        <translation>Auf der Seite gedruckt:
%1</translation>
    </message>
    <message>
        <source>%1: 1 piece</source>
        <translation>%1: 1 Stück</translation>
    </message>
    <message>
        <source>%1: %2 pieces</source>
        <translation>%1: %2 Stücke</translation>
    </message>
    <message>
        <source>, deviation %1 px</source>
        <translation>, Abweichung %1 px</translation>
    </message>
    <message>
        <source>
   tactile point %1, %2</source>
        <translation>
   Druckpunkt %1, %2</translation>
    </message>
    <message>
        <source>, no tactile point</source>
        <translation>, kein Druckpunkt</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Hinweg</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Rückweg</translation>
    </message>
    <message>
        <source>No release curve</source>
        <translation>Keine Rückwegkurve</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Operating point</source>
        <translation>Schaltpunkt</translation>
    </message>
    <message>
        <source>Reset point</source>
        <translation>Rückschaltpunkt</translation>
    </message>
    <message>
        <source>On the page you can drag or delete these points. Right-click the curve to add one.</source>
        <translation>Auf der Seite können Sie diese Punkte ziehen oder löschen. Ein Rechtsklick auf die Kurve fügt einen hinzu.</translation>
    </message>
    <message>
        <source>Total travel %1</source>
        <translation>Gesamtweg %1</translation>
    </message>
    <message>
        <source>One of the points that you set was left out: %1</source>
        <translation>Einer der von Ihnen gesetzten Punkte wurde ausgelassen: %1</translation>
    </message>
</context>
<context>
    <name>detent::editor::ScaleTool</name>
    <message>
        <source>Click a tick of an axis and type the value printed there. Two ticks define an axis. The corner where the axes meet sets both at once.</source>
        <translation>Klicken Sie einen Teilstrich einer Achse an, und geben Sie den Wert ein, der dort steht. Zwei Teilstriche legen eine Achse fest. Die Ecke, in der die Achsen sich treffen, setzt beide zugleich.</translation>
    </message>
</context>
<context>
    <name>detent::editor::SelectTool</name>
    <message>
        <source>There is no curve point here. Add one (K) to select it with others.</source>
        <translation>Hier ist kein Kurvenpunkt. Fügen Sie einen hinzu (K), um ihn mit anderen auszuwählen.</translation>
    </message>
    <message numerus="yes">
        <source>%n points selected</source>
        <translation>
            <numerusform>%n Punkt ausgewählt</numerusform>
            <numerusform>%n Punkte ausgewählt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n points</source>
        <translation>
            <numerusform>%n Punkt verschieben</numerusform>
            <numerusform>%n Punkte verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Corner or smooth: %1</source>
        <translation>Ecke oder glatt: %1</translation>
    </message>
    <message>
        <source>Add curve point</source>
        <translation>Kurvenpunkt hinzufügen</translation>
    </message>
    <message>
        <source>Drag points and slope handles. Drag the line to bend it between two points. Drag on empty space to select several. Shift: one axis, Ctrl: no snapping, Escape: cancel.</source>
        <translation>Punkte und Steigungsgriffe ziehen. An der Linie ziehen biegt sie zwischen zwei Punkten. Auf freier Fläche ziehen wählt mehrere. Umschalt: eine Achse, Strg: kein Einrasten, Esc: abbrechen.</translation>
    </message>
</context>
<context>
    <name>detent::editor::SelectionPanel</name>
    <message>
        <source>Values of the selected point</source>
        <translation>Werte des gewählten Punkts</translation>
    </message>
    <message>
        <source>release</source>
        <translation>Rückweg</translation>
    </message>
    <message>
        <source>press</source>
        <translation>Hinweg</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Select a point in the graph.</source>
        <translation>Wählen Sie einen Punkt im Graphen.</translation>
    </message>
</context>
<context>
    <name>detent::editor::SheetController</name>
    <message>
        <source>Discard the corrections of this datasheet?</source>
        <translation>Die Berichtigungen dieses Datenblatts verwerfen?</translation>
    </message>
    <message>
        <source>a pasted picture</source>
        <translation>ein eingefügtes Bild</translation>
    </message>
    <message>
        <source>An import was interrupted; the corrections made to %1 are kept.</source>
        <translation>Ein Import wurde unterbrochen; die Berichtigungen an %1 sind noch da.</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Find datasheet…</source>
        <translation>Datenblatt suchen …</translation>
    </message>
    <message>
        <source>Find datasheet</source>
        <translation>Datenblatt suchen</translation>
    </message>
    <message>
        <source>Datasheet page of %1 restored.</source>
        <translation>Datenblattseite von %1 wiederhergestellt.</translation>
    </message>
    <message>
        <source>The datasheet %1, from which this button was read, is neither next to the file of the button nor at its last location.</source>
        <translation>Das Datenblatt %1, aus dem dieser Taster gelesen wurde, liegt weder neben der Datei des Tasters noch am letzten Ort.</translation>
    </message>
    <message>
        <source>This page is too large to be kept in a button&apos;s file.</source>
        <translation>Diese Seite ist zu groß, um in der Datei eines Tasters behalten zu werden.</translation>
    </message>
    <message>
        <source>The page will be saved with the button; the file grows by %1.</source>
        <translation>Die Seite wird mit dem Taster gespeichert; die Datei wächst um %1.</translation>
    </message>
    <message>
        <source>The page shown is the one kept in the button&apos;s file.</source>
        <translation>Gezeigt wird die Seite, die in der Datei des Tasters behalten wurde.</translation>
    </message>
</context>
<context>
    <name>detent::editor::ShortcutDialog</name>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Search the shortcuts</source>
        <translation>Die Tastenkürzel durchsuchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
</context>
<context>
    <name>detent::editor::SignalView</name>
    <message>
        <source>pulse</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>press jump</source>
        <translation>Sprung auf dem Hinweg</translation>
    </message>
    <message>
        <source>release jump</source>
        <translation>Sprung auf dem Rückweg</translation>
    </message>
    <message>
        <source>bottom-out</source>
        <translation>Anschlag</translation>
    </message>
    <message>
        <source>contact closes</source>
        <translation>Kontakt schließt</translation>
    </message>
    <message>
        <source>contact opens</source>
        <translation>Kontakt öffnet</translation>
    </message>
    <message>
        <source>triggered from outside</source>
        <translation>von außen ausgelöst</translation>
    </message>
    <message>
        <source>Vibration of a press</source>
        <translation>Vibration einer Betätigung</translation>
    </message>
    <message>
        <source>&lt;p&gt;Above: the vibration of a press, as a share of full scale. The grey line is the force (or depth) it was pressed with: a standard press (120 ms down, 80 ms held, 100 ms up; a quarter more force than the bottom-out needs) or your own last one.&lt;/p&gt;&lt;p&gt;Below: its frequencies over time up to 1000 Hz (spectrogram; Hann window of 32 ms), from −60 to 0 dB of a full-scale sine.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Oben: die Vibration einer Betätigung, als Anteil der Vollaussteuerung. Die graue Linie ist die Kraft (oder Tiefe), mit der gedrückt wurde: eine Standardbetätigung (120 ms hinunter, 80 ms gehalten, 100 ms hinauf; ein Viertel mehr Kraft, als der Anschlag braucht) oder Ihre eigene letzte.&lt;/p&gt;&lt;p&gt;Unten: ihre Frequenzen über der Zeit bis 1000 Hz (Spektrogramm; Hann-Fenster von 32 ms), von −60 bis 0 dB eines voll ausgesteuerten Sinus.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Peak %1 percent of full scale, %2 milliseconds. %3</source>
        <translation>Spitze %1 Prozent der Vollaussteuerung, %2 Millisekunden. %3</translation>
    </message>
    <message>
        <source>The vibration of a press is drawn here.</source>
        <translation>Hier wird die Vibration einer Betätigung gezeichnet.</translation>
    </message>
    <message>
        <source>; pressed at %1 mm/s</source>
        <translation>; mit %1 mm/s gedrückt</translation>
    </message>
    <message>
        <source>Vibration of a standard press</source>
        <translation>Vibration einer Standardbetätigung</translation>
    </message>
    <message>
        <source>Vibration of my last press</source>
        <translation>Vibration meiner letzten Betätigung</translation>
    </message>
    <message>
        <source>peak %1 %</source>
        <translation>Spitze %1 %</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>gefühlt</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>−60 dB</source>
        <translation>−60 dB</translation>
    </message>
    <message>
        <source>0 dB</source>
        <translation>0 dB</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1   %2 Hz   %3 dB</source>
        <translation>%1   %2 Hz   %3 dB</translation>
    </message>
    <message>
        <source>%1 ms   %2 at %3 mm</source>
        <translation>%1 ms   %2 bei %3 mm</translation>
    </message>
    <message>
        <source>%1   %2 % of full scale</source>
        <translation>%1   %2 % der Vollaussteuerung</translation>
    </message>
    <message>
        <source>Reference: %1</source>
        <translation>Vergleich: %1</translation>
    </message>
    <message>
        <source>&lt;p&gt;A signal of another program, for comparison: above as a share of full scale, below as a spectrogram. The level has the same scale as that of the press. So has the time, unless one signal is four times longer than the other.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Das Signal eines anderen Programms zum Vergleich: oben als Anteil der Vollaussteuerung, unten als Spektrogramm. Der Pegel hat denselben Maßstab wie der der Betätigung. Ebenso die Zeit, außer wenn ein Signal viermal so lang ist wie das andere.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>detent::editor::SoundBox</name>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>felt %1 dB</source>
        <translation>fühlbar %1 dB</translation>
    </message>
    <message>
        <source>&amp;Gain</source>
        <translation>&amp;Verstärkung</translation>
    </message>
    <message>
        <source>Gain before the limiter, −40 to +20 dB. 0 dB is the strength that button and device profile require</source>
        <translation>Verstärkung vor dem Begrenzer, −40 bis +20 dB. 0 dB ist die Stärke, die Taster und Geräteprofil verlangen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Open the sound device once more</source>
        <translation>Das Audiogerät noch einmal öffnen</translation>
    </message>
    <message>
        <source>%1 dB</source>
        <translation>%1 dB</translation>
    </message>
    <message>
        <source>No sound: presses are tracked without sound</source>
        <translation>Kein Ton: Betätigungen werden ohne Ton verfolgt</translation>
    </message>
    <message>
        <source>Sound starts with the first press.</source>
        <translation>Der Ton beginnt mit der ersten Betätigung.</translation>
    </message>
    <message>
        <source>Sound is off; presses are tracked without sound.</source>
        <translation>Der Ton ist aus; Betätigungen werden ohne Ton verfolgt.</translation>
    </message>
    <message>
        <source>Opening the sound device; until then, presses are tracked without sound.</source>
        <translation>Das Audiogerät wird geöffnet; bis dahin werden Betätigungen ohne Ton verfolgt.</translation>
    </message>
    <message>
        <source>The sound device %1 is disconnected. Plug it in or start its server again: sound resumes by itself. Until then, presses are tracked without sound.</source>
        <translation>Das Audiogerät %1 ist getrennt. Stecken Sie es an oder starten Sie seinen Server neu: Der Ton setzt von selbst wieder ein. Bis dahin werden Betätigungen ohne Ton verfolgt.</translation>
    </message>
    <message>
        <source>%1 · %2 kHz</source>
        <translation>%1 · %2 kHz</translation>
    </message>
    <message>
        <source> · buffer %1 (%2 ms)</source>
        <translation> · Puffer %1 (%2 ms)</translation>
    </message>
    <message>
        <source> · load %1 %</source>
        <translation> · Last %1 %</translation>
    </message>
    <message>
        <source> · drop-outs: %1</source>
        <translation> · Aussetzer: %1</translation>
    </message>
    <message>
        <source> · lost: %1</source>
        <translation> · verloren: %1</translation>
    </message>
    <message>
        <source>No audio output. Presses are tracked without sound. %1</source>
        <translation>Keine Tonausgabe. Betätigungen werden ohne Ton verfolgt. %1</translation>
    </message>
    <message>
        <source>Strength of the strongest 10 ms within the last 1.5 s, in dB above the weakest vibration that a fingertip feels. It is computed from the strength of the transducer in the device profile. ≈ means that the strength of the transducer was assumed, not measured.</source>
        <translation>Stärke der stärksten 10 ms in den letzten 1,5 s, in dB über der schwächsten Vibration, die eine Fingerspitze fühlt. Sie wird aus der Stärke des Wandlers im Geräteprofil berechnet. ≈ bedeutet, dass die Stärke des Wandlers angenommen und nicht gemessen ist.</translation>
    </message>
    <message>
        <source>Play the vibration of each press through the sound device. The first press opens the device; switching this off closes it.</source>
        <translation>Die Vibration jeder Betätigung über das Audiogerät abspielen. Die erste Betätigung öffnet das Gerät; das Ausschalten schließt es.</translation>
    </message>
</context>
<context>
    <name>detent::editor::StudyMaker</name>
    <message>
        <source>Kind of feedback. Every pair is presented with each kind that is ticked, in random order and without names</source>
        <translation>Art der Rückmeldung. Jedes Paar wird mit jeder angekreuzten Art dargeboten, in zufälliger Reihenfolge und ohne Namen</translation>
    </message>
    <message>
        <source>New study</source>
        <translation>Neue Studie</translation>
    </message>
    <message>
        <source>Buttons of the study</source>
        <translation>Taster der Studie</translation>
    </message>
    <message>
        <source>Buttons, as they are shown now:</source>
        <translation>Taster, wie sie jetzt gezeigt sind:</translation>
    </message>
    <message>
        <source>The participants&apos; task</source>
        <translation>Aufgabe der Versuchspersonen</translation>
    </message>
    <message>
        <source>Practice questions, which do not count</source>
        <translation>Übungsfragen, die nicht zählen</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>clicks only</source>
        <translation>nur Klicks</translation>
    </message>
    <message>
        <source>slopes only</source>
        <translation>nur Steigungen</translation>
    </message>
    <message>
        <source>&amp;Task:</source>
        <translation>&amp;Aufgabe:</translation>
    </message>
    <message>
        <source>&amp;Questions per condition:</source>
        <translation>&amp;Fragen je Bedingung:</translation>
    </message>
    <message>
        <source>&amp;Practice:</source>
        <translation>&amp;Übung:</translation>
    </message>
    <message>
        <source>Feedback:</source>
        <translation>Rückmeldung:</translation>
    </message>
    <message>
        <source>Device profile:</source>
        <translation>Geräteprofil:</translation>
    </message>
    <message>
        <source>none (choose it in the Feel panel under Setup)</source>
        <translation>keines (wählbar im Bereich „Fühlen“ unter „Einrichtung“)</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Wählen …</translation>
    </message>
    <message>
        <source>Choose where to create the folder</source>
        <translation>Wählen, wo der Ordner angelegt wird</translation>
    </message>
    <message>
        <source>Folder of the study</source>
        <translation>Ordner der Studie</translation>
    </message>
    <message>
        <source>&amp;Folder:</source>
        <translation>&amp;Ordner:</translation>
    </message>
    <message>
        <source>Create stud&amp;y</source>
        <translation>Studie an&amp;legen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Questions for each participant: %1, about %2 minutes.</source>
        <translation>Fragen an jede Versuchsperson: %1, etwa %2 Minuten.</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>strength of the click</source>
        <translation>Stärke des Klicks</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>snap</source>
        <translation>Schnappen</translation>
    </message>
    <message>
        <source>roughness along the travel</source>
        <translation>Rauheit auf dem Weg</translation>
    </message>
    <message>
        <source>How buttons are rated</source>
        <translation>Wie Taster bewertet werden</translation>
    </message>
    <message>
        <source>how much people like it, 1 to 7</source>
        <translation>wie sehr er gefällt, 1 bis 7</translation>
    </message>
    <message>
        <source>how strong it is, rated with any number</source>
        <translation>wie stark er ist, mit einer beliebigen Zahl</translation>
    </message>
    <message>
        <source>which of two is better</source>
        <translation>welcher von zweien besser ist</translation>
    </message>
    <message>
        <source>Number of questions for each pair or button and each kind of feedback</source>
        <translation>Zahl der Fragen je Paar oder Taster und je Art der Rückmeldung</translation>
    </message>
    <message>
        <source>&amp;Scale:</source>
        <translation>S&amp;kala:</translation>
    </message>
    <message>
        <source>C&amp;onsent texts:</source>
        <translation>&amp;Einwilligungen:</translation>
    </message>
    <message>
        <source>Text files that participants read first, one for each language: NAME.en.txt, NAME.de.txt; separate several with semicolons</source>
        <translation>Textdateien, die Versuchspersonen zuerst lesen, eine je Sprache: NAME.en.txt, NAME.de.txt; mehrere durch Semikolon getrennt</translation>
    </message>
    <message>
        <source>a short text in English and German</source>
        <translation>ein kurzer Text auf Englisch und Deutsch</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>Au&amp;swählen …</translation>
    </message>
    <message>
        <source>Choose consent texts</source>
        <translation>Einwilligungen auswählen</translation>
    </message>
    <message>
        <source>Consent texts</source>
        <translation>Einwilligungen</translation>
    </message>
    <message>
        <source>Texts (*.txt)</source>
        <translation>Texte (*.txt)</translation>
    </message>
    <message>
        <source>Press:</source>
        <translation>Drücken:</translation>
    </message>
    <message>
        <source>Seconds per r&amp;un:</source>
        <translation>Sek&amp;unden je Lauf:</translation>
    </message>
    <message>
        <source>When or how fast participants press the button</source>
        <translation>Wann oder wie schnell die Versuchspersonen den Taster drücken</translation>
    </message>
    <message>
        <source>with the last of four beats</source>
        <translation>mit dem letzten von vier Schlägen</translation>
    </message>
    <message>
        <source>as fast as can be kept up</source>
        <translation>so schnell es durchzuhalten ist</translation>
    </message>
    <message>
        <source>Seconds from the first press, %1 to %2</source>
        <translation>Sekunden ab dem ersten Tastendruck, %1 bis %2</translation>
    </message>
    <message>
        <source>Soun&amp;d:</source>
        <translation>&amp;Ton:</translation>
    </message>
    <message>
        <source>Recordin&amp;g:</source>
        <translation>Aufna&amp;hme:</translation>
    </message>
    <message>
        <source>What participants hear of each press, beside the vibration</source>
        <translation>Was die Teilnehmer bei jedem Druck hören, neben der Vibration</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>the vibration itself</source>
        <translation>die Vibration selbst</translation>
    </message>
    <message>
        <source>a recording</source>
        <translation>eine Aufnahme</translation>
    </message>
    <message>
        <source>dB added to the sound, %1 to %2</source>
        <translation>dB, um die der Ton angehoben wird, %1 bis %2</translation>
    </message>
    <message>
        <source>Milliseconds from the click to its sound, 0 to %1</source>
        <translation>Millisekunden vom Klick bis zu seinem Ton, 0 bis %1</translation>
    </message>
    <message>
        <source>Choos&amp;e…</source>
        <translation>Wäh&amp;len …</translation>
    </message>
    <message>
        <source>Choose a recording of the press</source>
        <translation>Eine Aufnahme des Drucks wählen</translation>
    </message>
    <message>
        <source>Recording of a press</source>
        <translation>Aufnahme eines Drucks</translation>
    </message>
    <message>
        <source>Sounds (*.wav *.flac *.ogg)</source>
        <translation>Töne (*.wav *.flac *.ogg)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>A sound file of at most 5 s that begins with the click; it plays once per press</source>
        <translation>Eine Tondatei von höchstens 5 s, die mit dem Klick beginnt; sie erklingt einmal je Druck</translation>
    </message>
    <message>
        <source>Are two buttons the same? (same or different)</source>
        <translation>Sind zwei Taster gleich? (gleich oder verschieden)</translation>
    </message>
    <message>
        <source>Which of all buttons is X? (matching)</source>
        <translation>Welcher von allen Tastern ist X? (Zuordnung)</translation>
    </message>
    <message>
        <source>Which of two buttons has more of a quantity? (threshold)</source>
        <translation>Welcher von zwei Tastern hat mehr von einer Größe? (Schwelle)</translation>
    </message>
    <message>
        <source>How does a button feel? (rating)</source>
        <translation>Wie fühlt sich ein Taster an? (Bewertung)</translation>
    </message>
    <message>
        <source>When do participants press? (timing)</source>
        <translation>Wann drücken Versuchspersonen? (Timing)</translation>
    </message>
    <message>
        <source>One of the two buttons has more of this quantity. The study adapts the difference to the answers</source>
        <translation>Einer der zwei Taster hat mehr von dieser Größe. Die Studie passt den Unterschied den Antworten an</translation>
    </message>
    <message>
        <source>Quantity that is va&amp;ried:</source>
        <translation>Veränderte &amp;Größe:</translation>
    </message>
    <message>
        <source>Inter&amp;vals in s:</source>
        <translation>Inter&amp;valle in s:</translation>
    </message>
    <message>
        <source>Time &amp;windows in s:</source>
        <translation>&amp;Zeitfenster in s:</translation>
    </message>
    <message>
        <source>Sound &amp;level in dB:</source>
        <translation>P&amp;egel in dB:</translation>
    </message>
    <message>
        <source>Sound dela&amp;y in ms:</source>
        <translation>Verz&amp;ögerung in ms:</translation>
    </message>
    <message>
        <source>while a ball is between two bars</source>
        <translation>während eine Kugel zwischen zwei Balken ist</translation>
    </message>
    <message>
        <source>Time between beats, or from the ball&apos;s start until it reaches the bars, %1 to %2 s. Separate several with semicolons</source>
        <translation>Zeit zwischen den Schlägen, oder vom Start der Kugel bis zu den Balken, %1 bis %2 s. Mehrere mit Semikolon trennen</translation>
    </message>
    <message>
        <source>Time for which the ball is between the bars, %1 to %2 s. Separate several with semicolons</source>
        <translation>Zeit, für die die Kugel zwischen den Balken ist, %1 bis %2 s. Mehrere mit Semikolon trennen</translation>
    </message>
    <message>
        <source>Which of two buttons is X? (ABX)</source>
        <translation>Welcher von zwei Tastern ist X? (ABX)</translation>
    </message>
    <message>
        <source>New folder that will hold the whole study. It can be copied to another computer</source>
        <translation>Neuer Ordner, der die ganze Studie enthalten wird. Er lässt sich auf einen anderen Rechner kopieren</translation>
    </message>
</context>
<context>
    <name>detent::editor::StudyWindow</name>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>REHEARSAL: there is no sound device, nothing is felt</source>
        <translation>PROBELAUF: Es gibt kein Audiogerät, nichts ist zu fühlen</translation>
    </message>
    <message>
        <source>I agree: begin</source>
        <translation>Ich bin einverstanden: beginnen</translation>
    </message>
    <message>
        <source>No, thank you</source>
        <translation>Nein, danke</translation>
    </message>
    <message>
        <source>Feel X</source>
        <translation>X fühlen</translation>
    </message>
    <message>
        <source>Feel %1</source>
        <translation>%1 fühlen</translation>
    </message>
    <message>
        <source>X is %1</source>
        <translation>X ist %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop for good</source>
        <translation>Endgültig aufhören</translation>
    </message>
    <message>
        <source>Stop for good? What you have answered is kept.</source>
        <translation>Endgültig aufhören? Was Sie beantwortet haben, bleibt erhalten.</translation>
    </message>
    <message>
        <source>No, go on</source>
        <translation>Nein, weitermachen</translation>
    </message>
    <message>
        <source>Yes, stop</source>
        <translation>Ja, aufhören</translation>
    </message>
    <message>
        <source>Practice: question %1 of %2</source>
        <translation>Übung: Frage %1 von %2</translation>
    </message>
    <message>
        <source>Question %1 of %2</source>
        <translation>Frage %1 von %2</translation>
    </message>
    <message>
        <source>X is the real switch number %1</source>
        <translation>X ist der echte Schalter Nummer %1</translation>
    </message>
    <message>
        <source>X is one of those below. Feel X and the others, then say which one it is.</source>
        <translation>X ist einer von denen unten. Fühlen Sie X und die anderen, dann sagen Sie, welcher es ist.</translation>
    </message>
    <message>
        <source>Choose one, then press the pad with your finger.</source>
        <translation>Wählen Sie einen, dann drücken Sie das Feld mit dem Finger.</translation>
    </message>
    <message>
        <source>Your answer is not saved yet. %1 Then answer again.</source>
        <translation>Ihre Antwort ist noch nicht gespeichert. %1 Dann antworten Sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 (not pressed to the end yet)</source>
        <translation>%1 (noch nicht bis zum Ende gedrückt)</translation>
    </message>
    <message>
        <source>First press to the end and let go: %1.</source>
        <translation>Erst bis zum Ende drücken und loslassen: %1.</translation>
    </message>
    <message>
        <source>The device is connected again. This question starts over.</source>
        <translation>Das Gerät ist wieder verbunden. Diese Frage beginnt von vorn.</translation>
    </message>
    <message>
        <source>The force sensor was disconnected. Please call the experimenter.</source>
        <translation>Der Kraftsensor ist getrennt. Bitte rufen Sie die Versuchsleitung.</translation>
    </message>
    <message>
        <source>The sound device was disconnected. Please call the experimenter.</source>
        <translation>Das Audiogerät ist getrennt. Bitte rufen Sie die Versuchsleitung.</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>J</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Type a number above 0, then Enter.</source>
        <translation>Tippen Sie eine Zahl über 0, dann die Eingabetaste.</translation>
    </message>
    <message>
        <source>Pause for as long as you like. The question you were at will start over.</source>
        <translation>Eine Pause, so lange Sie mögen. Die Frage, an der Sie waren, beginnt von vorn.</translation>
    </message>
    <message>
        <source>Stop now and continue another day</source>
        <translation>Jetzt aufhören und an einem anderen Tag weitermachen</translation>
    </message>
    <message>
        <source>Thank you. Next time you will continue with the question you were at.</source>
        <translation>Vielen Dank. Beim nächsten Mal geht es genau bei der Frage weiter, an der Sie waren.</translation>
    </message>
    <message>
        <source>Please call the experimenter.</source>
        <translation>Bitte rufen Sie die Versuchsleitung.</translation>
    </message>
    <message>
        <source>For the experimenter: close</source>
        <translation>Für die Versuchsleitung: schließen</translation>
    </message>
    <message>
        <source>%1 is better</source>
        <translation>%1 ist besser</translation>
    </message>
    <message>
        <source>%1 needs more force</source>
        <translation>%1 braucht mehr Kraft</translation>
    </message>
    <message>
        <source>%1 has the stronger click</source>
        <translation>%1 hat den stärkeren Klick</translation>
    </message>
    <message>
        <source>%1 goes deeper</source>
        <translation>%1 geht tiefer</translation>
    </message>
    <message>
        <source>%1 snaps more</source>
        <translation>%1 schnappt mehr</translation>
    </message>
    <message>
        <source>%1 feels rougher while it moves</source>
        <translation>%1 fühlt sich beim Bewegen rauer an</translation>
    </message>
    <message>
        <source>Feel it</source>
        <translation>Fühlen</translation>
    </message>
    <message>
        <source>space bar</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>This is my number</source>
        <translation>Das ist meine Zahl</translation>
    </message>
    <message>
        <source>1: I do not like it at all</source>
        <translation>1: gefällt mir gar nicht</translation>
    </message>
    <message>
        <source>7: I like it very much</source>
        <translation>7: gefällt mir sehr</translation>
    </message>
    <message>
        <source>Feel both, then say which one has more. If you are not sure, guess.</source>
        <translation>Fühlen Sie beide, dann sagen Sie, welcher mehr hat. Sind Sie nicht sicher, raten Sie.</translation>
    </message>
    <message>
        <source>Feel both, then say which one is better. There is no right or wrong.</source>
        <translation>Fühlen Sie beide, dann sagen Sie, welcher besser ist. Es gibt kein Richtig oder Falsch.</translation>
    </message>
    <message>
        <source>Feel the button, then say how much you like it. There is no right or wrong.</source>
        <translation>Fühlen Sie den Taster und sagen Sie dann, wie sehr er Ihnen gefällt. Es gibt kein Richtig oder Falsch.</translation>
    </message>
    <message>
        <source>Feel the button, then give a number for how strong it feels: what feels twice as strong gets twice the number. Any number above 0 will do.</source>
        <translation>Fühlen Sie den Taster und geben Sie dann eine Zahl dafür an, wie stark er sich anfühlt: Was sich doppelt so stark anfühlt, bekommt die doppelte Zahl. Jede Zahl über 0 ist möglich.</translation>
    </message>
    <message>
        <source>To feel a button under your finger, press its key or click it.</source>
        <translation>Um einen Taster unter dem Finger zu fühlen, drücken Sie seine Taste oder klicken Sie ihn an.</translation>
    </message>
    <message>
        <source>First press the button to the end and let go.</source>
        <translation>Drücken Sie den Taster zuerst bis zum Ende und lassen Sie los.</translation>
    </message>
    <message>
        <source>Thank you for coming. Nothing about you was saved.</source>
        <translation>Vielen Dank, dass Sie da waren. Es wurde nichts über Sie gespeichert.</translation>
    </message>
    <message>
        <source>Questions for practice, which do not count: %1</source>
        <translation>Fragen zur Übung, die nicht zählen: %1</translation>
    </message>
    <message>
        <source>That was the practice. From now on your answers count.</source>
        <translation>Das war die Übung. Von jetzt an zählen Ihre Antworten.</translation>
    </message>
    <message>
        <source>Time for a rest, as long as you like. You have answered %1 of %2.</source>
        <translation>Zeit für eine Pause, so lange Sie mögen. Sie haben %1 von %2 beantwortet.</translation>
    </message>
    <message>
        <source>Now answer, or feel again as often as you like.</source>
        <translation>Antworten Sie jetzt, oder fühlen Sie noch einmal, so oft Sie mögen.</translation>
    </message>
    <message>
        <source>Thank you. What you have answered is kept.</source>
        <translation>Vielen Dank. Was Sie beantwortet haben, bleibt erhalten.</translation>
    </message>
    <message>
        <source>Press here</source>
        <translation>Hier drücken</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>noch %1 s</translation>
    </message>
    <message>
        <source>Hit</source>
        <translation>Getroffen</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Daneben</translation>
    </message>
    <message>
        <source>Stop.</source>
        <translation>Halt.</translation>
    </message>
    <message>
        <source>No press fell within the time that counts. Please try again.</source>
        <translation>Kein Tastendruck lag in der Zeit, die zählt. Bitte noch einmal.</translation>
    </message>
    <message>
        <source>The presses were too close together: let go of the key each time. Please try again.</source>
        <translation>Die Tastendrücke kamen zu dicht hintereinander: Lassen Sie die Taste jedes Mal los. Bitte noch einmal.</translation>
    </message>
    <message>
        <source>The button was not pressed far enough. Please try again.</source>
        <translation>Der Taster wurde nicht weit genug gedrückt. Bitte noch einmal.</translation>
    </message>
    <message>
        <source>The result is not saved yet. %1 Please try again.</source>
        <translation>Das Ergebnis ist noch nicht gespeichert. %1 Bitte noch einmal.</translation>
    </message>
    <message>
        <source>You will hear four even beats. Press with the fourth.</source>
        <translation>Sie hören vier gleichmäßige Schläge. Drücken Sie mit dem vierten.</translation>
    </message>
    <message>
        <source>A ball runs to the right. Press while its middle is between the two bars.</source>
        <translation>Ein Ball läuft nach rechts. Drücken Sie, während seine Mitte zwischen den beiden Strichen ist.</translation>
    </message>
    <message>
        <source>Press again and again, as fast as you can, until you are told to stop: %1 seconds from your first press.</source>
        <translation>Drücken Sie immer wieder, so schnell Sie können, bis „Halt“ erscheint: %1 Sekunden ab Ihrem ersten Tastendruck.</translation>
    </message>
    <message>
        <source>Press the button under your finger.</source>
        <translation>Drücken Sie den Taster unter Ihrem Finger.</translation>
    </message>
    <message>
        <source>Press the space bar, or the large field on the screen.</source>
        <translation>Drücken Sie die Leertaste oder das große Feld auf dem Bildschirm.</translation>
    </message>
    <message>
        <source>Choose one, then press the button under your finger.</source>
        <translation>Wählen Sie einen, dann drücken Sie den Taster unter Ihrem Finger.</translation>
    </message>
    <message>
        <source>Press Escape to switch the force off at once.</source>
        <translation>Drücken Sie Escape, um die Kraft sofort abzuschalten.</translation>
    </message>
    <message>
        <source>The force device was disconnected. Please call the experimenter.</source>
        <translation>Das Kraftgerät ist getrennt. Bitte rufen Sie die Versuchsleitung.</translation>
    </message>
    <message>
        <source>The force is off. Please call the experimenter, who can switch it on with F9.</source>
        <translation>Die Kraft ist aus. Bitte rufen Sie die Versuchsleitung, die sie mit F9 einschalten kann.</translation>
    </message>
    <message>
        <source>They are the same</source>
        <translation>Sie sind gleich</translation>
    </message>
    <message>
        <source>They differ</source>
        <translation>Sie sind verschieden</translation>
    </message>
    <message>
        <source>Feel both, then say whether they are the same. If you are not sure, guess.</source>
        <translation>Fühlen Sie beide und sagen Sie dann, ob sie gleich sind. Wenn Sie unsicher sind, raten Sie.</translation>
    </message>
    <message>
        <source>That was the last question. Thank you.</source>
        <translation>Das war die letzte Frage. Vielen Dank.</translation>
    </message>
</context>
<context>
    <name>detent::editor::SwitchMap</name>
    <message>
        <source>Main difference %1</source>
        <translation>Hauptunterschied %1</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>%1: %2 %, %3</source>
        <translation>%1: %2 %, %3</translation>
    </message>
</context>
<context>
    <name>detent::editor::SwitchesBox</name>
    <message>
        <source>Switch %1</source>
        <translation>Taster %1</translation>
    </message>
    <message>
        <source>%1: press and release</source>
        <translation>%1: Hinweg und Rückweg</translation>
    </message>
    <message>
        <source>%1: press only</source>
        <translation>%1: nur Hinweg</translation>
    </message>
    <message>
        <source>Switches in this plot</source>
        <translation>Taster in diesem Diagramm</translation>
    </message>
    <message>
        <source>Choose the switch to read. Ticked switches are imported together, each as a button of its own.</source>
        <translation>Wählen Sie den Schalter, der gelesen werden soll. Angekreuzte Schalter werden zusammen importiert, jeder als eigener Taster.</translation>
    </message>
    <message>
        <source>Choose switch</source>
        <translation>Taster wählen</translation>
    </message>
</context>
<context>
    <name>detent::editor::TabArea</name>
    <message>
        <source>Open buttons</source>
        <translation>Offene Taster</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>Noch nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>detent::editor::TactileChoice</name>
    <message>
        <source>Tactile point</source>
        <translation>Druckpunkt</translation>
    </message>
</context>
<context>
    <name>detent::editor::TemplateDialog</name>
    <message>
        <source>New button</source>
        <translation>Neuer Taster</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Start from a template and shape it, or drop a datasheet on the window instead.</source>
        <translation>Beginnen Sie mit einer Vorlage und formen Sie sie, oder legen Sie stattdessen ein Datenblatt im Fenster ab.</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Erstellen</translation>
    </message>
</context>
<context>
    <name>detent::editor::UnitPlot</name>
    <message>
        <source>Displacement (%1)</source>
        <translation>Weg (%1)</translation>
    </message>
    <message>
        <source>Force (%1)</source>
        <translation>Kraft (%1)</translation>
    </message>
    <message>
        <source>Damping (%1·s/%2)</source>
        <translation>Dämpfung (%1·s/%2)</translation>
    </message>
</context>
<context>
    <name>detent::editor::ValuesModel</name>
    <message>
        <source>Tactile point %1</source>
        <translation>Druckpunkt %1</translation>
    </message>
    <message>
        <source>Curve point %1</source>
        <translation>Kurvenpunkt %1</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>jump</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>bottom-out</source>
        <translation>Anschlag</translation>
    </message>
    <message>
        <source>Press: tactile points</source>
        <translation>Hinweg: Druckpunkte</translation>
    </message>
    <message>
        <source>Release: tactile points</source>
        <translation>Rückweg: Druckpunkte</translation>
    </message>
    <message>
        <source>Press: curve points</source>
        <translation>Hinweg: Kurvenpunkte</translation>
    </message>
    <message>
        <source>Release: curve points</source>
        <translation>Rückweg: Kurvenpunkte</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Slope left of the curve point</source>
        <translation>Steigung links vom Kurvenpunkt</translation>
    </message>
    <message>
        <source>Set: %1</source>
        <translation>Setzen: %1</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Valley or peak %1</source>
        <translation>Tal oder Spitze %1</translation>
    </message>
    <message>
        <source>Section %1</source>
        <translation>Abschnitt %1</translation>
    </message>
    <message>
        <source>Press: valleys and peaks</source>
        <translation>Hinweg: Täler und Spitzen</translation>
    </message>
    <message>
        <source>Release: valleys and peaks</source>
        <translation>Rückweg: Täler und Spitzen</translation>
    </message>
    <message>
        <source>Press: sections (end point)</source>
        <translation>Hinweg: Abschnitte (Endpunkt)</translation>
    </message>
    <message>
        <source>Release: sections (end point)</source>
        <translation>Rückweg: Abschnitte (Endpunkt)</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Slope before</source>
        <translation>Steigung davor</translation>
    </message>
    <message>
        <source>Slope after</source>
        <translation>Steigung danach</translation>
    </message>
    <message>
        <source>Slope right of the curve point. For a section: mean slope from its start to its end</source>
        <translation>Steigung rechts vom Kurvenpunkt. Bei einem Abschnitt: mittlere Steigung von seinem Anfang bis zu seinem Ende</translation>
    </message>
</context>
<context>
    <name>detent::editor::ValuesPanel</name>
    <message>
        <source>Exact values of the force graph</source>
        <translation>Genaue Werte des Kraftgraphen</translation>
    </message>
</context>
<context>
    <name>detent::editor::WelcomePage</name>
    <message>
        <source>Drop a datasheet here</source>
        <translation>Legen Sie hier ein Datenblatt ab</translation>
    </message>
    <message>
        <source>A picture, a PDF, an SVG, a force meter&apos;s CSV, or a button file. Detent reads the force graph and turns it into a button you can edit and feel.</source>
        <translation>Ein Bild, ein PDF, ein SVG, die CSV eines Kraftmessgeräts oder eine Tasterdatei. Detent liest den Kraftgraphen und macht daraus einen Taster, den Sie formen und fühlen können.</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
</context>
<context>
    <name>detent::editor::ZoomTool</name>
    <message>
        <source>Drag a rectangle to zoom in; click zooms in, Shift+click zooms out, F fits.</source>
        <translation>Rechteck aufziehen zum Vergrößern; Klick vergrößert, Umschalt+Klick verkleinert, F zeigt alles.</translation>
    </message>
</context>
<context>
    <name>detent::importer</name>
    <message>
        <source>%1 axis</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>a plot frame needs 2 or 4 corners, not %1</source>
        <translation>ein Rahmen braucht 2 oder 4 Ecken, nicht %1</translation>
    </message>
    <message>
        <source>corner (%1, %2) is outside the page</source>
        <translation>die Ecke (%1, %2) liegt außerhalb der Seite</translation>
    </message>
    <message>
        <source>page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>page %1, graph %2</source>
        <translation>Seite %1, Graph %2</translation>
    </message>
    <message>
        <source>plot frame entered by hand</source>
        <translation>Rahmen von Hand eingegeben</translation>
    </message>
    <message>
        <source>%1: entered by hand</source>
        <translation>%1: von Hand eingegeben</translation>
    </message>
    <message>
        <source>one of the curves reaches a higher force</source>
        <translation>eine der Kurven erreicht eine höhere Kraft</translation>
    </message>
    <message>
        <source>the two curves end at different points, like curves of two switches</source>
        <translation>beide Kurven enden an verschiedenen Punkten, wie Kurven zweier Schalter</translation>
    </message>
    <message>
        <source>the frame was widened to its outermost tick labels</source>
        <translation>der Rahmen wurde bis zu seinen äußersten Skalenzahlen erweitert</translation>
    </message>
    <message>
        <source>the start of a stroke is hidden under another curve and was taken from that curve</source>
        <translation>der Anfang eines Hubs ist von einer anderen Kurve verdeckt und wurde von dieser übernommen</translation>
    </message>
    <message>
        <source>the axes are not certain (%1)</source>
        <translation>die Achsen sind nicht sicher (%1)</translation>
    </message>
    <message>
        <source>the curves are not certain (%1)</source>
        <translation>die Kurven sind nicht sicher (%1)</translation>
    </message>
    <message>
        <source>the traced points do not form a curve (the fit deviates from them by %1 px)</source>
        <translation>die abgelesenen Punkte ergeben keine Kurve (die Anpassung weicht um %1 px von ihnen ab)</translation>
    </message>
    <message>
        <source>this is more likely a drawing than a force graph (%1)</source>
        <translation>dies ist eher eine Zeichnung als ein Kraftgraph (%1)</translation>
    </message>
    <message>
        <source>the lines that were traced do not look like a force curve (confidence %1)</source>
        <translation>die abgelesenen Linien sehen nicht nach einer Kraftkurve aus (Sicherheit %1)</translation>
    </message>
    <message>
        <source>there are %1 curves, and it is not clear which two belong together: %2</source>
        <translation>es sind %1 Kurven, und es ist nicht klar, welche zwei zusammengehören: %2</translation>
    </message>
    <message>
        <source>the plot shows %1 switches: %2</source>
        <translation>das Diagramm zeigt %1 Schalter: %2</translation>
    </message>
    <message>
        <source>press and release cannot be told apart: neither legend nor hysteresis says which is which (%1, %2)</source>
        <translation>Hinweg und Rückweg lassen sich nicht unterscheiden: Weder Legende noch Hysterese zeigt, welche Kurve welche ist (%1, %2)</translation>
    </message>
    <message>
        <source>a travel of %1 is not plausible for a button</source>
        <translation>ein Weg von %1 ist für einen Taster unplausibel</translation>
    </message>
    <message>
        <source>a force of %1 is not plausible for a button</source>
        <translation>eine Kraft von %1 ist für einen Taster unplausibel</translation>
    </message>
    <message>
        <source>the press starts at %1, left of zero</source>
        <translation>der Hinweg beginnt bei %1, links von null</translation>
    </message>
    <message>
        <source>the press goes down to %1, below zero</source>
        <translation>der Hinweg geht bis %1 hinab, unter null</translation>
    </message>
    <message>
        <source>more than half of a curve is parallel to an axis, as gridlines are</source>
        <translation>mehr als die Hälfte einer Kurve liegt parallel zu einer Achse, wie Gitterlinien</translation>
    </message>
    <message>
        <source>a stroke with %1 tactile points is not plausible for a button</source>
        <translation>ein Hub mit %1 Druckpunkten ist für einen Taster unplausibel</translation>
    </message>
    <message>
        <source>the press force falls at its start or end; perhaps an edge of the frame was traced, or a magnet pulls</source>
        <translation>die Kraft des Hinwegs fällt an seinem Anfang oder Ende; vielleicht wurde eine Kante des Rahmens abgelesen, oder ein Magnet zieht</translation>
    </message>
    <message>
        <source>a curve is cut off at the edge of the picture</source>
        <translation>eine Kurve ist am Rand des Bildes abgeschnitten</translation>
    </message>
    <message>
        <source>a curve goes on beyond the plot frame at %1</source>
        <translation>eine Kurve läuft bei %1 über den Rahmen hinaus</translation>
    </message>
    <message>
        <source>the force axis begins at %1, but a curve goes below this value</source>
        <translation>die Kraftachse beginnt bei %1, aber eine Kurve geht unter diesen Wert</translation>
    </message>
    <message>
        <source>you gave the colour %1 here, but the legend calls the curve of that colour &quot;%2&quot;</source>
        <translation>Sie haben hier die Farbe %1 angegeben, die Legende nennt die Kurve dieser Farbe aber „%2“</translation>
    </message>
    <message>
        <source>the first reading of the page was not certain (%1); two readings at other sizes agree and were used</source>
        <translation>die erste Lesung der Seite war nicht sicher (%1); zwei Lesungen in anderen Größen stimmen überein und wurden verwendet</translation>
    </message>
    <message>
        <source>the time limit of %1 s was reached; the best reading so far was used</source>
        <translation>die Zeitgrenze von %1 s ist erreicht; verwendet wurde die bis dahin beste Lesung</translation>
    </message>
    <message>
        <source>the traced curve runs over blank paper around %1, %2</source>
        <translation>die abgelesene Kurve läuft bei %1, %2 über leeres Papier</translation>
    </message>
    <message>
        <source>the numbers of the %1 axis may be thousands, or may have three decimals</source>
        <translation>die Zahlen der Achse %1 können Tausender sein oder drei Nachkommastellen haben</translation>
    </message>
    <message>
        <source>press and release share only %1 of their travel</source>
        <translation>Hinweg und Rückweg haben nur %1 ihres Weges gemeinsam</translation>
    </message>
    <message>
        <source>the page looks scanned, and scans are read wrong more often than drawings</source>
        <translation>die Seite sieht gescannt aus, und Scans werden öfter falsch gelesen als Zeichnungen</translation>
    </message>
    <message>
        <source>the page looks photographed, and photographs are read wrong more often than other pages</source>
        <translation>die Seite sieht fotografiert aus, und Fotos werden öfter falsch gelesen als andere Seiten</translation>
    </message>
    <message>
        <source>not certain: %1</source>
        <translation>nicht sicher: %1</translation>
    </message>
    <message>
        <source>page %1: images that could not be decoded: %2; the rest of the page was read</source>
        <translation>Seite %1: Bilder, die sich nicht dekodieren ließen: %2; der Rest der Seite wurde gelesen</translation>
    </message>
    <message>
        <source>page %1: %2</source>
        <translation>Seite %1: %2</translation>
    </message>
    <message>
        <source>the %1 axis has no ticks: its scale was taken from the positions of its numbers</source>
        <translation>die Achse %1 hat keine Teilstriche: Ihre Skala wurde aus den Stellen ihrer Zahlen bestimmt</translation>
    </message>
    <message>
        <source>a force of %1 before contact was subtracted as offset of the force meter</source>
        <translation>eine Kraft von %1 vor der Berührung wurde als Nullpunktfehler des Messgeräts abgezogen</translation>
    </message>
    <message>
        <source>%1 of %2 rows do not hold two usable numbers and were left out, the first in line %3 (&quot;%4&quot;)</source>
        <translation>%1 von %2 Zeilen enthalten keine zwei brauchbaren Zahlen und wurden weggelassen, die erste in Zeile %3 („%4“)</translation>
    </message>
    <message>
        <source>the log holds no release stroke</source>
        <translation>das Protokoll enthält keinen Rückweg</translation>
    </message>
    <message>
        <source>forces from testers that write this format can differ by up to 30 gf from those of other laboratories</source>
        <translation>Kräfte von Messgeräten mit diesem Format können um bis zu 30 gf von denen anderer Labore abweichen</translation>
    </message>
    <message>
        <source>the same graph is drawn %1 times (%2); the one on page %3 was used, as it is the most certain</source>
        <translation>derselbe Graph ist %1 Mal gezeichnet (%2); verwendet wurde der auf Seite %3, der am sichersten ist</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>the curve ends where the curve of another switch covers it</source>
        <translation>die Kurve endet, wo die Kurve eines anderen Schalters sie verdeckt</translation>
    </message>
    <message>
        <source>no single curve is named &quot;%1&quot;; the plot shows %2</source>
        <translation>keine einzelne Kurve heißt „%1“; das Diagramm zeigt %2</translation>
    </message>
    <message>
        <source>the file has %1; the limit is %2</source>
        <translation>die Datei hat %1; die Grenze ist %2</translation>
    </message>
    <message>
        <source>Give a smaller file</source>
        <translation>Geben Sie eine kleinere Datei an</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>Check the path %1</source>
        <translation>Prüfen Sie den Pfad %1</translation>
    </message>
    <message>
        <source>this is a folder, not a file</source>
        <translation>dies ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>Choose one of the files in the folder</source>
        <translation>Wählen Sie eine der Dateien im Ordner</translation>
    </message>
    <message>
        <source>this is not an ordinary file</source>
        <translation>dies ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>Save the content to an ordinary file and import that file</source>
        <translation>Speichern Sie den Inhalt in einer gewöhnlichen Datei, und importieren Sie diese</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>die Datei lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>Check that you may read %1</source>
        <translation>Prüfen Sie, ob Sie %1 lesen dürfen</translation>
    </message>
    <message>
        <source>the file&apos;s size cannot be read</source>
        <translation>die Größe der Datei lässt sich nicht feststellen</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>Byte %1</translation>
    </message>
    <message>
        <source>the file could not be read to its end</source>
        <translation>die Datei ließ sich nicht bis zu ihrem Ende lesen</translation>
    </message>
    <message>
        <source>Copy the file to a local disk and import the copy</source>
        <translation>Kopieren Sie die Datei auf einen lokalen Datenträger, und importieren Sie die Kopie</translation>
    </message>
    <message>
        <source>the content is plain text</source>
        <translation>der Inhalt ist reiner Text</translation>
    </message>
    <message>
        <source>the type of the content is not known</source>
        <translation>die Art des Inhalts ist nicht bekannt</translation>
    </message>
    <message>
        <source>first bytes</source>
        <translation>erste Bytes</translation>
    </message>
    <message>
        <source>%1, although the file name says that it is a %2</source>
        <translation>%1, obwohl der Dateiname etwas anderes sagt (%2)</translation>
    </message>
    <message>
        <source>Give a PNG, JPEG, BMP, TIFF, WebP, GIF, PDF, SVG or CSV file</source>
        <translation>Geben Sie eine PNG-, JPEG-, BMP-, TIFF-, WebP-, GIF-, PDF-, SVG- oder CSV-Datei an</translation>
    </message>
    <message>
        <source>the content is a %1, although the file name says that it is a %2</source>
        <translation>der Inhalt (%1) ist ein anderer, als der Dateiname sagt (%2)</translation>
    </message>
    <message>
        <source>Check that this is the right file, and give it a name that suits its content</source>
        <translation>Prüfen Sie, ob das die richtige Datei ist, und geben Sie ihr einen Namen, der zu ihrem Inhalt passt</translation>
    </message>
    <message>
        <source>the file is empty (0 bytes)</source>
        <translation>die Datei ist leer (0 Bytes)</translation>
    </message>
    <message>
        <source>Copy or download the file again</source>
        <translation>Kopieren oder laden Sie die Datei noch einmal</translation>
    </message>
    <message>
        <source>there is not enough memory to read the file</source>
        <translation>der Speicher reicht nicht aus, um die Datei zu lesen</translation>
    </message>
    <message>
        <source>Scale the picture down or crop it to the graph</source>
        <translation>Verkleinern Sie das Bild, oder schneiden Sie es auf den Graphen zu</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>PNG-Bild</translation>
    </message>
    <message>
        <source>JPEG picture</source>
        <translation>JPEG-Bild</translation>
    </message>
    <message>
        <source>BMP picture</source>
        <translation>BMP-Bild</translation>
    </message>
    <message>
        <source>TIFF picture</source>
        <translation>TIFF-Bild</translation>
    </message>
    <message>
        <source>GIF picture</source>
        <translation>GIF-Bild</translation>
    </message>
    <message>
        <source>HEIC picture</source>
        <translation>HEIC-Bild</translation>
    </message>
    <message>
        <source>AVIF picture</source>
        <translation>AVIF-Bild</translation>
    </message>
    <message>
        <source>JPEG 2000 picture</source>
        <translation>JPEG-2000-Bild</translation>
    </message>
    <message>
        <source>the content is a %1, which Detent cannot read</source>
        <translation>der Inhalt (%1) ist von einer Art, die Detent nicht lesen kann</translation>
    </message>
    <message>
        <source>Open it in a picture viewer and save it as PNG</source>
        <translation>Öffnen Sie es in einem Bildbetrachter, und speichern Sie es als PNG</translation>
    </message>
    <message>
        <source>the packed content is damaged, or larger than the limit of %1</source>
        <translation>der gepackte Inhalt ist beschädigt oder größer als die Grenze von %1</translation>
    </message>
    <message>
        <source>Unpack the file and import its content</source>
        <translation>Entpacken Sie die Datei, und importieren Sie den Inhalt</translation>
    </message>
    <message>
        <source>WebP picture</source>
        <translation>WebP-Bild</translation>
    </message>
    <message>
        <source>PDF document</source>
        <translation>PDF-Dokument</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG-Zeichnung</translation>
    </message>
    <message>
        <source>file of unknown type</source>
        <translation>Datei unbekannter Art</translation>
    </message>
    <message>
        <source>header</source>
        <translation>Dateikopf</translation>
    </message>
    <message>
        <source>Save or export the picture again and import the new file</source>
        <translation>Speichern oder exportieren Sie das Bild noch einmal, und importieren Sie die neue Datei</translation>
    </message>
    <message>
        <source>the picture claims %1 x %2 pixels, which is more than the limit of %3 megapixels</source>
        <translation>das Bild gibt %1 × %2 Pixel an, mehr als die Grenze von %3 Megapixeln</translation>
    </message>
    <message>
        <source>end of file</source>
        <translation>Dateiende</translation>
    </message>
    <message>
        <source>the %1 is truncated</source>
        <translation>%1: die Datei ist abgeschnitten</translation>
    </message>
    <message>
        <source>this build of Detent cannot read %1 files (it was built without MuPDF)</source>
        <translation>diese Fassung von Detent kann keine %1-Dateien lesen (sie wurde ohne MuPDF gebaut)</translation>
    </message>
    <message>
        <source>Remove from the file all values that the sensor did not measure</source>
        <translation>Entfernen Sie aus der Datei alle Werte, die der Sensor nicht gemessen hat</translation>
    </message>
    <message>
        <source>the disk is full or failed: %1</source>
        <translation>der Datenträger ist voll oder fehlerhaft: %1</translation>
    </message>
    <message>
        <source>the library is not complete: %1</source>
        <translation>die Sammlung ist nicht vollständig: %1</translation>
    </message>
    <message>
        <source>the library had version %1, this program uses %2: it was built anew from the given folders</source>
        <translation>die Sammlung hatte Version %1, dieses Programm verwendet %2: Sie wurde aus den angegebenen Ordnern neu aufgebaut</translation>
    </message>
    <message>
        <source>the library is damaged and could not be renamed: %1</source>
        <translation>die Sammlung ist beschädigt und ließ sich nicht umbenennen: %1</translation>
    </message>
    <message>
        <source>the library was damaged (%1) and was built anew from the given folders; the damaged file is kept as %2</source>
        <translation>die Sammlung war beschädigt (%1) und wurde aus den angegebenen Ordnern neu aufgebaut; die beschädigte Datei ist als %2 aufgehoben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither a button nor a force log</source>
        <translation>„%1“ ist weder ein Taster noch ein Kraftprotokoll</translation>
    </message>
    <message>
        <source>there are only %1 switches or states</source>
        <translation>es gibt nur %1 Schalter oder Zustände</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the name of a page</source>
        <translation>„%1“ ist nicht der Name einer Seite</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the name of a button</source>
        <translation>„%1“ ist nicht der Name eines Tasters</translation>
    </message>
    <message>
        <source>no row of numbers was found along the axis</source>
        <translation>an der Achse wurde keine Reihe von Zahlen gefunden</translation>
    </message>
    <message>
        <source>both ends of the axis have the same value</source>
        <translation>beide Enden der Achse haben denselben Wert</translation>
    </message>
    <message>
        <source>Give two different values</source>
        <translation>Zwei verschiedene Werte angeben</translation>
    </message>
    <message>
        <source>displacement or force is not a usable number</source>
        <translation>Weg oder Kraft ist keine brauchbare Zahl</translation>
    </message>
    <message>
        <source>Leave out such points before fitting</source>
        <translation>Solche Punkte vor dem Anpassen weglassen</translation>
    </message>
    <message>
        <source>there are no points</source>
        <translation>es gibt keine Punkte</translation>
    </message>
    <message>
        <source>there is only one point</source>
        <translation>es gibt nur einen Punkt</translation>
    </message>
    <message>
        <source>Give at least two points with different displacements</source>
        <translation>Mindestens zwei Punkte mit verschiedenen Wegen angeben</translation>
    </message>
    <message>
        <source>all points have the same displacement, so there is no travel</source>
        <translation>alle Punkte haben denselben Weg, also gibt es keinen Hub</translation>
    </message>
    <message>
        <source>Check the displacement axis or column</source>
        <translation>Die Achse oder Spalte des Wegs prüfen</translation>
    </message>
    <message>
        <source>the points are too far apart to compute with</source>
        <translation>die Punkte liegen zu weit auseinander, um damit zu rechnen</translation>
    </message>
    <message>
        <source>Check the units of the axes</source>
        <translation>Die Einheiten der Achsen prüfen</translation>
    </message>
    <message>
        <source>Give two opposite corners or four (top left, top right, bottom right, bottom left) inside the page</source>
        <translation>Zwei gegenüberliegende Ecken oder vier (oben links, oben rechts, unten rechts, unten links) auf der Seite angeben</translation>
    </message>
    <message>
        <source>the corners enclose no area in this order</source>
        <translation>die Ecken umschließen in dieser Reihenfolge keine Fläche</translation>
    </message>
    <message>
        <source>the plot frame is smaller than 16 pixels</source>
        <translation>der Rahmen ist kleiner als 16 Pixel</translation>
    </message>
    <message>
        <source>Export the data sets as CSV</source>
        <translation>Die Datensätze als CSV exportieren</translation>
    </message>
    <message>
        <source>no data set on xy axes has two points or more</source>
        <translation>kein Datensatz auf xy-Achsen hat mindestens zwei Punkte</translation>
    </message>
    <message>
        <source>Trace each stroke as a data set, then save the project</source>
        <translation>Jeden Hub als Datensatz nachzeichnen, dann das Projekt speichern</translation>
    </message>
    <message>
        <source>data set &quot;%1&quot;</source>
        <translation>Datensatz &quot;%1&quot;</translation>
    </message>
    <message>
        <source>the points jump between two curves</source>
        <translation>die Punkte springen zwischen zwei Kurven</translation>
    </message>
    <message>
        <source>all data sets are named as releases</source>
        <translation>alle Datensätze heißen Rückweg (release)</translation>
    </message>
    <message>
        <source>Name the data set of the press &quot;press&quot;</source>
        <translation>Den Datensatz des Hinwegs „press“ nennen</translation>
    </message>
    <message>
        <source>Save the project once more in WebPlotDigitizer</source>
        <translation>Das Projekt im WebPlotDigitizer noch einmal speichern</translation>
    </message>
    <message>
        <source>the file is not a TAR archive</source>
        <translation>die Datei ist kein TAR-Archiv</translation>
    </message>
    <message>
        <source>the archive is damaged</source>
        <translation>das Archiv ist beschädigt</translation>
    </message>
    <message>
        <source>the archive holds no project (wpd.json)</source>
        <translation>das Archiv enthält kein Projekt (wpd.json)</translation>
    </message>
    <message>
        <source>the file is not JSON</source>
        <translation>die Datei ist kein JSON</translation>
    </message>
    <message>
        <source>Export the file again: it may have been cut off</source>
        <translation>Exportieren Sie die Datei neu: Sie kann abgeschnitten sein</translation>
    </message>
    <message>
        <source>the file is the description of a data package</source>
        <translation>die Datei ist die Beschreibung eines Datenpakets</translation>
    </message>
    <message>
        <source>Import the CSV file of its curve, which is in the same folder</source>
        <translation>Importieren Sie die CSV-Datei der Kurve, die im selben Ordner liegt</translation>
    </message>
    <message>
        <source>the file holds no strokes</source>
        <translation>die Datei enthält keine Hübe</translation>
    </message>
    <message>
        <source>A recording has the lists down_x, down_y and up_y</source>
        <translation>Eine Aufzeichnung hat die Listen down_x, down_y und up_y</translation>
    </message>
    <message>
        <source>the lists of the recording hold no press</source>
        <translation>die Listen der Aufzeichnung enthalten keinen Hinweg</translation>
    </message>
    <message>
        <source>the file is not a spreadsheet, or is damaged</source>
        <translation>die Datei ist keine Tabelle oder ist beschädigt</translation>
    </message>
    <message>
        <source>the import %1</source>
        <translation>der Import %1</translation>
    </message>
    <message>
        <source>the curve has fewer than two points</source>
        <translation>die Kurve hat weniger als zwei Punkte</translation>
    </message>
    <message>
        <source>Leave the value at 1</source>
        <translation>Lassen Sie den Wert bei 1</translation>
    </message>
    <message>
        <source>total travel</source>
        <translation>Gesamtweg</translation>
    </message>
    <message>
        <source>pre-travel</source>
        <translation>Vorlaufweg</translation>
    </message>
    <message>
        <source>operating force</source>
        <translation>Betätigungskraft</translation>
    </message>
    <message>
        <source>force at the end</source>
        <translation>Kraft am Ende</translation>
    </message>
    <message>
        <source>Save the spreadsheet again, as xlsx, ODS or CSV</source>
        <translation>Die Tabelle neu speichern, als xlsx, ODS oder CSV</translation>
    </message>
    <message>
        <source>the content is damaged, or larger than 64 MB when unpacked</source>
        <translation>der Inhalt ist beschädigt oder entpackt größer als 64 MB</translation>
    </message>
    <message>
        <source>the spreadsheet file has no sheet</source>
        <translation>die Tabellendatei hat kein Tabellenblatt</translation>
    </message>
    <message>
        <source>the line is too long</source>
        <translation>die Zeile ist zu lang</translation>
    </message>
    <message>
        <source>Give a table with one sample per line</source>
        <translation>Eine Tabelle mit einem Messpunkt je Zeile angeben</translation>
    </message>
    <message>
        <source>the units are named only in the heading: &quot;%1&quot;</source>
        <translation>die Einheiten stehen nur in der Überschrift: „%1“</translation>
    </message>
    <message>
        <source>spreadsheets need the library libzip, which is not installed</source>
        <translation>Tabellen brauchen die Bibliothek libzip, die nicht installiert ist</translation>
    </message>
    <message>
        <source>Install it (on Debian: libzip4), or save the sheet as CSV</source>
        <translation>Sie installieren (unter Debian: libzip4) oder die Tabelle als CSV speichern</translation>
    </message>
    <message>
        <source>the page states an operating point, but it could not be placed on the curve</source>
        <translation>die Seite nennt einen Schaltpunkt, er ließ sich aber nicht auf die Kurve setzen</translation>
    </message>
    <message>
        <source>the page states a reset point, but it could not be placed on the curve</source>
        <translation>die Seite nennt einen Rückschaltpunkt, er ließ sich aber nicht auf die Kurve setzen</translation>
    </message>
    <message>
        <source>the axes are exchanged: force runs to the right and travel upwards</source>
        <translation>die Achsen sind vertauscht: Die Kraft verläuft nach rechts und der Weg nach oben</translation>
    </message>
    <message>
        <source>%1 axis: entered by hand; %2 of %3 printed numbers agree</source>
        <translation>%1-Achse: von Hand eingegeben; %2 von %3 gedruckten Zahlen stimmen überein</translation>
    </message>
    <message>
        <source>%1 axis: %2 of %3 printed numbers fit one scale, with %4 ticks</source>
        <translation>%1-Achse: %2 von %3 gedruckten Zahlen passen zu einer Skala, mit %4 Teilstrichen</translation>
    </message>
    <message>
        <source>the values entered for the %1 axis contradict the numbers printed there (%2)</source>
        <translation>die Werte, die für die %1-Achse eingegeben sind, widersprechen den dort gedruckten Zahlen (%2)</translation>
    </message>
    <message>
        <source>Import a graph on which press and release have the same force scale</source>
        <translation>Importieren Sie einen Graphen, auf dem Hinweg und Rückweg dieselbe Kraftskala haben</translation>
    </message>
    <message>
        <source>graph %1</source>
        <translation>Graph %1</translation>
    </message>
    <message>
        <source>there is no such graph</source>
        <translation>diesen Graphen gibt es nicht</translation>
    </message>
    <message>
        <source>no force graph found</source>
        <translation>kein Kraftgraph gefunden</translation>
    </message>
    <message>
        <source>no force graph found (%1)</source>
        <translation>kein Kraftgraph gefunden (%1)</translation>
    </message>
    <message>
        <source>the table can be read in several ways: %1</source>
        <translation>die Tabelle lässt sich auf mehrere Weisen lesen: %1</translation>
    </message>
    <message>
        <source>Choose one of these</source>
        <translation>Wählen Sie eine davon</translation>
    </message>
    <message>
        <source>the table does not look like a measurement of a button</source>
        <translation>die Tabelle sieht nicht nach der Messung eines Tasters aus</translation>
    </message>
    <message>
        <source>the fitted curve deviates from the measured values</source>
        <translation>die angepasste Kurve weicht von den Messwerten ab</translation>
    </message>
    <message>
        <source>Check the values, or accept a lower confidence</source>
        <translation>Prüfen Sie die Werte, oder lassen Sie eine geringere Sicherheit zu</translation>
    </message>
    <message>
        <source>nothing was read within the limit of %1 s</source>
        <translation>innerhalb der Grenze von %1 s wurde nichts gelesen</translation>
    </message>
    <message>
        <source>Choose a lower quality</source>
        <translation>Eine niedrigere Qualität wählen</translation>
    </message>
    <message>
        <source>it is logarithmic</source>
        <translation>sie ist logarithmisch</translation>
    </message>
    <message>
        <source>it has categories instead of a scale</source>
        <translation>sie zeigt Kategorien statt einer Skala</translation>
    </message>
    <message>
        <source>it measures &quot;%1&quot;</source>
        <translation>sie misst „%1“</translation>
    </message>
    <message>
        <source>Separate press and release, and put the points of each into the order of the movement</source>
        <translation>Trennen Sie Hin- und Rückweg, und bringen Sie die Punkte beider in die Reihenfolge der Bewegung</translation>
    </message>
    <message>
        <source>this button has no %1</source>
        <translation>dieser Taster hat kein %1</translation>
    </message>
    <message>
        <source>Use one data set for the press and one for the release, and name them &quot;press&quot; and &quot;release&quot;</source>
        <translation>Verwenden Sie einen Datensatz für den Hinweg und einen für den Rückweg, und nennen Sie sie „press“ und „release“</translation>
    </message>
    <message>
        <source>the file wpd.json in the archive is not JSON</source>
        <translation>die Datei wpd.json im Archiv ist kein JSON</translation>
    </message>
    <message>
        <source>the file wpd.json in the archive is not a WebPlotDigitizer project</source>
        <translation>die Datei wpd.json im Archiv ist kein WebPlotDigitizer-Projekt</translation>
    </message>
    <message>
        <source>Export the page as a PNG of at least 300 dpi and import that, or install a build of Detent with MuPDF</source>
        <translation>Exportieren Sie die Seite als PNG mit mindestens 300 dpi und importieren Sie dieses, oder installieren Sie ein Detent mit MuPDF</translation>
    </message>
    <message>
        <source>%1 of the 4 edges of the frame are drawn, with %2 vertical and %3 horizontal lines or ticks</source>
        <translation>%1 der 4 Kanten des Rahmens sind gezeichnet, mit %2 senkrechten und %3 waagrechten Linien oder Skalenstrichen</translation>
    </message>
    <message>
        <source>the legend names press and release</source>
        <translation>die Legende benennt Hin- und Rückweg</translation>
    </message>
    <message>
        <source>the press lies above the release along %1 of the travel on which they differ</source>
        <translation>der Hinweg liegt auf %1 des Wegs, auf dem sich beide unterscheiden, über dem Rückweg</translation>
    </message>
    <message>
        <source>there is only one curve, which is the press</source>
        <translation>es gibt nur eine Kurve, den Hinweg</translation>
    </message>
    <message>
        <source>the only curve was taken as the press, although the legend calls it release</source>
        <translation>die einzige Kurve gilt als Hinweg, obwohl die Legende sie Rückweg nennt</translation>
    </message>
    <message>
        <source>the only curve was taken as the press, although the legend also names a release (&quot;%1&quot;)</source>
        <translation>die einzige Kurve gilt als Hinweg, obwohl die Legende auch einen Rückweg nennt („%1“)</translation>
    </message>
    <message>
        <source>press and release were swapped by hand</source>
        <translation>Hin- und Rückweg wurden von Hand vertauscht</translation>
    </message>
    <message>
        <source>there are %1 numbers in a row and %2 in a column, but no rectangle of lines</source>
        <translation>es gibt %1 Zahlen in einer Reihe und %2 in einer Spalte, aber kein Rechteck aus Linien</translation>
    </message>
    <message>
        <source>no curve is named &quot;%1&quot;; the most similar name that was read is &quot;%2&quot;</source>
        <translation>keine Kurve heißt „%1“; der ähnlichste gelesene Name ist „%2“</translation>
    </message>
    <message>
        <source>the %1 numbers along this axis do not form an even scale</source>
        <translation>die %1 Zahlen an dieser Achse bilden keine gleichmäßige Skala</translation>
    </message>
    <message>
        <source>the %1 axis cannot be used: %2</source>
        <translation>die Achse %1 ist nicht verwendbar: %2</translation>
    </message>
    <message>
        <source>there is a second scale on the right, and %1</source>
        <translation>rechts gibt es eine zweite Skala, und %1</translation>
    </message>
    <message>
        <source>a line that looks like a curve was not traced; it lies around %1, %2</source>
        <translation>eine Linie, die wie eine Kurve aussieht, wurde nicht nachgezogen; sie liegt um %1, %2</translation>
    </message>
    <message>
        <source>two readings of the page differ: the first found %1; the second, with the page drawn at another size, found %2</source>
        <translation>zwei Lesungen der Seite weichen voneinander ab: Die erste fand %1; die zweite, bei anderer Größe der Seite, fand %2</translation>
    </message>
    <message>
        <source>the tick label &quot;%1&quot; on the %2 axis was ignored, because by the other labels its place means %3</source>
        <translation>die Skalenzahl „%1“ der Achse %2 wurde nicht beachtet, weil ihre Stelle nach den übrigen Zahlen %3 bedeutet</translation>
    </message>
    <message>
        <source>the file names no unit of displacement, so %1 was assumed</source>
        <translation>die Datei nennt keine Einheit des Wegs, deshalb wurde %1 angenommen</translation>
    </message>
    <message>
        <source>the file names no unit of force; %1 was assumed from the size of the numbers</source>
        <translation>die Datei nennt keine Einheit der Kraft; nach der Größe der Zahlen wurde %1 angenommen</translation>
    </message>
    <message>
        <source>this file gives compression as negative forces; they were made positive</source>
        <translation>diese Datei gibt Druck als negative Kräfte an; sie wurden positiv gemacht</translation>
    </message>
    <message>
        <source>in this file, the displacement falls while the force rises; the direction of the displacement was reversed</source>
        <translation>in dieser Datei nimmt der Weg ab, während die Kraft steigt; die Richtung des Wegs wurde umgekehrt</translation>
    </message>
    <message>
        <source>the log holds %1 presses; the first complete cycle was used</source>
        <translation>das Protokoll enthält %1 Tastendrücke; verwendet wurde der erste vollständige Zyklus</translation>
    </message>
    <message>
        <source>the displacement started at %1; it was shifted so that the press starts at zero</source>
        <translation>der Weg begann bei %1; er wurde verschoben, damit der Hinweg bei null beginnt</translation>
    </message>
    <message>
        <source>the log is long, so every %1 rows were averaged into one</source>
        <translation>das Protokoll ist lang, deshalb wurden je %1 Zeilen zu einer gemittelt</translation>
    </message>
    <message>
        <source>%1 graphs were found; this is the most certain one (page %2, graph %3)</source>
        <translation>%1 Graphen wurden gefunden; dies ist der sicherste (Seite %2, Graph %3)</translation>
    </message>
    <message>
        <source>a travel of %1, forces up to %2 and no release</source>
        <translation>ein Weg von %1, Kräfte bis %2 und kein Rückweg</translation>
    </message>
    <message>
        <source>a travel of %1 and forces up to %2</source>
        <translation>ein Weg von %1 und Kräfte bis %2</translation>
    </message>
    <message>
        <source>it also measures forces</source>
        <translation>sie misst ebenfalls Kräfte</translation>
    </message>
    <message>
        <source>%1 agrees with the page: %2 read, %3 printed (page %4: &quot;%5&quot;)</source>
        <translation>%1 stimmt mit der Seite überein: %2 gelesen, %3 gedruckt (Seite %4: „%5“)</translation>
    </message>
    <message>
        <source>%1 differs from the page: %2 read, %3 printed (page %4: &quot;%5&quot;)</source>
        <translation>%1 weicht von der Seite ab: %2 gelesen, %3 gedruckt (Seite %4: „%5“)</translation>
    </message>
    <message>
        <source>there is no curve in the plot frame</source>
        <translation>im Diagrammrahmen gibt es keine Kurve</translation>
    </message>
    <message>
        <source>the plot frame is empty: it shows only paper and gridlines</source>
        <translation>der Diagrammrahmen ist leer: Er zeigt nur Papier und Gitterlinien</translation>
    </message>
    <message>
        <source>no line in the plot frame has one of the given colours</source>
        <translation>keine Linie im Diagrammrahmen hat eine der angegebenen Farben</translation>
    </message>
    <message>
        <source>the point spacing must be above 0 and at most 16 px</source>
        <translation>der Punktabstand muss größer als 0 und höchstens 16 px sein</translation>
    </message>
    <message>
        <source>the plot frame lies outside the picture or has no area</source>
        <translation>der Diagrammrahmen liegt außerhalb des Bilds oder hat keine Fläche</translation>
    </message>
    <message>
        <source>the folder cannot be read: %1</source>
        <translation>der Ordner lässt sich nicht lesen: %1</translation>
    </message>
    <message>
        <source>the library cannot be opened: %1</source>
        <translation>die Bibliothek lässt sich nicht öffnen: %1</translation>
    </message>
    <message>
        <source>the file is a WebPlotDigitizer project of an unknown version; only the versions 3 and 4 can be read</source>
        <translation>die Datei ist ein WebPlotDigitizer-Projekt einer unbekannten Version; lesbar sind nur die Versionen 3 und 4</translation>
    </message>
    <message>
        <source>a rectangle of lines has %1 tick labels below it and %2 beside it</source>
        <translation>unter einem Rechteck aus Linien stehen %1 Skalenzahlen, daneben %2</translation>
    </message>
    <message>
        <source>the legend calls one of two curves &quot;%1&quot;, which means neither press nor release; the name of the other curve could not be read</source>
        <translation>die Legende nennt eine von zwei Kurven „%1“, was weder Drücken noch Loslassen bedeutet; der Name der anderen Kurve war nicht lesbar</translation>
    </message>
    <message>
        <source>it has a break, after which the numbers stand at another spacing</source>
        <translation>sie ist unterbrochen; danach stehen die Zahlen in anderem Abstand</translation>
    </message>
    <message>
        <source>the displacement of the points goes back and forth</source>
        <translation>der Weg der Punkte läuft hin und her</translation>
    </message>
    <message>
        <source>the legend also names curves of &quot;%1&quot;, which were not traced</source>
        <translation>die Legende nennt auch Kurven von „%1“, die nicht abgelesen wurden</translation>
    </message>
    <message>
        <source>the %1 numbers along this axis decrease, and the plot could not be mirrored</source>
        <translation>die %1 Zahlen an dieser Achse nehmen ab, und das Diagramm ließ sich nicht spiegeln</translation>
    </message>
    <message>
        <source>the %1 is damaged or cut off: it states no width and height</source>
        <translation>%1 ist beschädigt oder abgeschnitten: Breite und Höhe fehlen</translation>
    </message>
    <message>
        <source>Import a graph of the same button with evenly divided axes</source>
        <translation>Importieren Sie einen Graphen desselben Tasters mit gleichmäßig geteilten Achsen</translation>
    </message>
    <message>
        <source>peak force</source>
        <translation>Spitzenkraft</translation>
    </message>
    <message>
        <source>the numbers of the %1 axis are negative; they were read without their minus signs</source>
        <translation>die Zahlen der %1-Achse sind negativ; sie wurden ohne ihr Minuszeichen gelesen</translation>
    </message>
    <message>
        <source>the title of the %1 axis prints the factor %2; %3</source>
        <translation>im Titel der %1-Achse steht der Faktor %2; %3</translation>
    </message>
    <message>
        <source>both curves have one colour, and their course tells which is the press</source>
        <translation>beide Kurven haben eine Farbe, und ihr Verlauf zeigt, welche der Hinweg ist</translation>
    </message>
    <message>
        <source>the press or the release was given by hand</source>
        <translation>der Hinweg oder der Rückweg wurde von Hand angegeben</translation>
    </message>
    <message>
        <source>the curve that would be the release lies above the press over %1 of their travel</source>
        <translation>die Kurve, die der Rückweg wäre, liegt auf %1 des gemeinsamen Wegs über dem Hinweg</translation>
    </message>
    <message>
        <source>the curves that would be press and release run along each other, or one jumps to the other and back</source>
        <translation>die Kurven, die Hinweg und Rückweg wären, verlaufen aufeinander, oder eine springt auf die andere und zurück</translation>
    </message>
    <message>
        <source>imported without a release: none was given by hand beside the press</source>
        <translation>ohne Rückweg importiert: Neben dem Hinweg wurde keiner von Hand angegeben</translation>
    </message>
    <message>
        <source>no curve beside the press has the colour %1 that was given for the release</source>
        <translation>keine Kurve neben dem Hinweg hat die Farbe %1, die für den Rückweg angegeben wurde</translation>
    </message>
    <message>
        <source>no curve has the colour %1 that was given for the press</source>
        <translation>keine Kurve hat die Farbe %1, die für den Hinweg angegeben wurde</translation>
    </message>
    <message>
        <source>no curve has the colour %1 that was given for the release</source>
        <translation>keine Kurve hat die Farbe %1, die für den Rückweg angegeben wurde</translation>
    </message>
    <message>
        <source>no unit for %3 was found at the %1 axis; %2 would be a guess</source>
        <translation>an der Achse %1 wurde keine Einheit für %3 gefunden; %2 wäre geraten</translation>
    </message>
    <message>
        <source>the title of the %1 axis prints a factor that cannot be read</source>
        <translation>der Titel der Achse %1 nennt einen Faktor, der nicht lesbar ist</translation>
    </message>
    <message>
        <source>no unit for lengths was found at the %1 axis, so %2 was assumed</source>
        <translation>an der Achse %1 wurde keine Einheit für Längen gefunden, deshalb wurde %2 angenommen</translation>
    </message>
    <message>
        <source>no unit for forces was found at the %1 axis; N was assumed, because the axis ends at 5 or below</source>
        <translation>an der Achse %1 wurde keine Einheit für Kräfte gefunden; N wurde angenommen, weil die Achse bei 5 oder darunter endet</translation>
    </message>
    <message>
        <source>no unit for forces was found at the %1 axis; gf was assumed, because the axis ends above 5</source>
        <translation>an der Achse %1 wurde keine Einheit für Kräfte gefunden; gf wurde angenommen, weil die Achse über 5 endet</translation>
    </message>
    <message>
        <source>upright marks on the curves, such as error bars, were left out: %1</source>
        <translation>senkrechte Marken auf den Kurven, etwa Fehlerbalken, wurden weggelassen: %1</translation>
    </message>
    <message>
        <source>the release was traced from %1 only, but the press goes on to %2; its beginning may be missing</source>
        <translation>der Rückweg wurde erst ab %1 nachgezeichnet, der Hinweg geht aber weiter bis %2; sein Anfang fehlt vielleicht</translation>
    </message>
</context>
<context>
    <name>detent::importer::Document</name>
    <message>
        <source>there is no page %1</source>
        <translation>Seite %1 gibt es nicht</translation>
    </message>
    <message>
        <source>Pages count from 1 to %1</source>
        <translation>Seiten zählen von 1 bis %1</translation>
    </message>
    <message>
        <source>the region is not a rectangle</source>
        <translation>der Bereich ist kein Rechteck</translation>
    </message>
    <message>
        <source>Give left, top, right, bottom</source>
        <translation>Links, oben, rechts, unten angeben</translation>
    </message>
</context>
<context>
    <name>detent::importer::Doubts</name>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; are taken as press and release, because they end at the same point</source>
        <translation>„%1“ und „%2“ sind als Hinweg und Rückweg genommen, weil sie im selben Punkt enden</translation>
    </message>
    <message>
        <source>Import the whole picture</source>
        <translation>Importieren Sie das ganze Bild</translation>
    </message>
    <message>
        <source>Correct the given values, or remove them so that the printed numbers are used</source>
        <translation>Berichtigen Sie die vorgegebenen Werte, oder entfernen Sie sie, damit die gedruckten Zahlen gelten</translation>
    </message>
    <message>
        <source>it also measures forces</source>
        <translation>sie misst ebenfalls Kräfte</translation>
    </message>
    <message>
        <source>it measures &quot;%1&quot;</source>
        <translation>sie misst „%1“</translation>
    </message>
    <message>
        <source>it names no unit of force</source>
        <translation>sie nennt keine Einheit der Kraft</translation>
    </message>
    <message>
        <source>the given values were not multiplied by it</source>
        <translation>die eingegebenen Werte wurden nicht mit ihm multipliziert</translation>
    </message>
    <message>
        <source>the numbers along the axis were multiplied by it</source>
        <translation>die Zahlen an der Achse wurden mit ihm multipliziert</translation>
    </message>
    <message>
        <source>lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>Multiply the given values by it</source>
        <translation>Die angegebenen Werte damit multiplizieren</translation>
    </message>
</context>
<context>
    <name>detent::importer::ImportSession</name>
    <message>
        <source>a force log has no pages</source>
        <translation>ein Kraftprotokoll hat keine Seiten</translation>
    </message>
    <message>
        <source>Import the log without a page number</source>
        <translation>Importieren Sie das Protokoll ohne Seitenzahl</translation>
    </message>
    <message>
        <source>a force log has no pages to list</source>
        <translation>ein Kraftprotokoll hat keine Seiten, die sich auflisten ließen</translation>
    </message>
    <message>
        <source>Import the log without listing</source>
        <translation>Importieren Sie das Protokoll, ohne aufzulisten</translation>
    </message>
    <message>
        <source>List the graphs of the page</source>
        <translation>Listen Sie die Graphen der Seite auf</translation>
    </message>
    <message>
        <source>a page has no recordings to choose from</source>
        <translation>eine Seite hat keine Aufzeichnungen zur Auswahl</translation>
    </message>
    <message>
        <source>a force log has no switches to choose from</source>
        <translation>ein Kraftprotokoll hat keine Schalter zur Auswahl</translation>
    </message>
</context>
<context>
    <name>detent::importer::KeptPages</name>
    <message>
        <source>graph %1</source>
        <translation>Graph %1</translation>
    </message>
    <message>
        <source>there is no such page</source>
        <translation>diese Seite gibt es nicht</translation>
    </message>
    <message>
        <source>1 to %1</source>
        <translation>1 bis %1</translation>
    </message>
</context>
<context>
    <name>detent::importer::LibraryStore</name>
    <message>
        <source>the library has version %1, this program uses %2</source>
        <translation>die Sammlung hat Version %1, dieses Programm verwendet %2</translation>
    </message>
</context>
<context>
    <name>detent::importer::LogReader</name>
    <message>
        <source>there are no samples</source>
        <translation>es gibt keine Messwerte</translation>
    </message>
    <message>
        <source>there is only one sample</source>
        <translation>es gibt nur einen Messwert</translation>
    </message>
    <message>
        <source>A stroke needs at least two samples at different displacements. Check the rows, and which rows are press and release</source>
        <translation>Ein Hub braucht mindestens zwei Messwerte an verschiedenen Wegen. Prüfen Sie die Zeilen und welche davon Hinweg und Rückweg sind</translation>
    </message>
    <message>
        <source>the displacement never changes</source>
        <translation>der Weg ändert sich nie</translation>
    </message>
    <message>
        <source>Check which column holds the displacement</source>
        <translation>Prüfen, in welcher Spalte der Weg steht</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>die Datei gibt es nicht</translation>
    </message>
    <message>
        <source>the file is larger than 256 MB</source>
        <translation>die Datei ist größer als 256 MB</translation>
    </message>
    <message>
        <source>Export one press with its release, or fewer rows</source>
        <translation>Eine Betätigung mit ihrem Rückweg exportieren, oder weniger Zeilen</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the file is a spreadsheet of Excel 97 to 2003</source>
        <translation>die Datei ist eine Tabelle von Excel 97 bis 2003</translation>
    </message>
    <message>
        <source>Save the spreadsheet as xlsx, ODS or CSV</source>
        <translation>Speichern Sie die Tabelle als xlsx, ODS oder CSV</translation>
    </message>
    <message>
        <source>the file is larger than 32 MB</source>
        <translation>die Datei ist größer als 32 MB</translation>
    </message>
    <message>
        <source>Export fewer switches into one file</source>
        <translation>Weniger Schalter in eine Datei exportieren</translation>
    </message>
    <message>
        <source>the file is not a spreadsheet, or is damaged</source>
        <translation>die Datei ist keine Tabelle oder ist beschädigt</translation>
    </message>
    <message>
        <source>Save the spreadsheet again</source>
        <translation>Die Tabelle neu speichern</translation>
    </message>
    <message>
        <source>the file is not a TAR archive</source>
        <translation>die Datei ist kein TAR-Archiv</translation>
    </message>
    <message>
        <source>Save the project once more in WebPlotDigitizer</source>
        <translation>Das Projekt in WebPlotDigitizer neu speichern</translation>
    </message>
    <message>
        <source>the content is not text</source>
        <translation>der Inhalt ist kein Text</translation>
    </message>
    <message>
        <source>Export the measurement as CSV, xlsx or ODS</source>
        <translation>Die Messung als CSV, xlsx oder ODS exportieren</translation>
    </message>
    <message>
        <source>the spreadsheet holds no table of numbers</source>
        <translation>die Datei enthält keine Tabelle mit Zahlen</translation>
    </message>
    <message>
        <source>Give a sheet with a column of displacement and one of force</source>
        <translation>Ein Blatt mit einer Wegspalte und einer Kraftspalte angeben</translation>
    </message>
    <message>
        <source>there are no two columns of numbers</source>
        <translation>es gibt keine zwei Spalten mit Zahlen</translation>
    </message>
    <message>
        <source>Give a table with a column of displacement and one of force, for example &quot;displacement_mm,force_N&quot;</source>
        <translation>Eine Tabelle mit einer Wegspalte und einer Kraftspalte angeben, zum Beispiel „displacement_mm,force_N“</translation>
    </message>
    <message>
        <source>no column is named &quot;%1&quot;</source>
        <translation>keine Spalte heißt „%1“</translation>
    </message>
    <message>
        <source>The columns are %1</source>
        <translation>Die Spalten sind %1</translation>
    </message>
    <message>
        <source>the unit of %1, &quot;%2&quot;, is not known</source>
        <translation>die Einheit für %1, „%2“, ist nicht bekannt</translation>
    </message>
    <message>
        <source>the mean of %1 recordings was taken</source>
        <translation>das Mittel von %1 Aufzeichnungen wurde genommen</translation>
    </message>
    <message>
        <source>there are %1 recordings: %2</source>
        <translation>es gibt %1 Aufzeichnungen: %2</translation>
    </message>
    <message>
        <source>a pair consists of two files, one with a press and one with a release</source>
        <translation>ein Paar besteht aus zwei Dateien, einer mit dem Hinweg und einer mit dem Rückweg</translation>
    </message>
    <message>
        <source>Give the file of the press first, then that of the release</source>
        <translation>Zuerst die Datei des Hinwegs angeben, dann die des Rückwegs</translation>
    </message>
    <message>
        <source>the press went back a little and continued; both parts were joined</source>
        <translation>der Hinweg ging ein wenig zurück und dann weiter; beide Teile wurden verbunden</translation>
    </message>
    <message>
        <source>Check the path and its permissions</source>
        <translation>Den Pfad und seine Zugriffsrechte prüfen</translation>
    </message>
    <message>
        <source>Give a file</source>
        <translation>Eine Datei angeben</translation>
    </message>
    <message>
        <source>Export the measurement again</source>
        <translation>Die Messung neu exportieren</translation>
    </message>
    <message>
        <source>%1 formulas have no results: no program has calculated them</source>
        <translation>%1 Formeln haben keine Ergebnisse: Kein Programm hat sie berechnet</translation>
    </message>
    <message>
        <source>Open the file in a spreadsheet program and save it there</source>
        <translation>Öffnen Sie die Datei in einem Tabellenprogramm, und speichern Sie sie dort</translation>
    </message>
    <message>
        <source>the displacement changes no more than its noise; the columns are %1</source>
        <translation>der Weg ändert sich nicht stärker als sein Rauschen; die Spalten sind %1</translation>
    </message>
    <message>
        <source>Give the log of a press</source>
        <translation>Die Aufzeichnung eines Drucks angeben</translation>
    </message>
    <message>
        <source>press and release are mixed, sorted by displacement, and cannot be separated</source>
        <translation>Hinweg und Rückweg sind nach dem Weg durcheinander sortiert und lassen sich nicht trennen</translation>
    </message>
    <message>
        <source>If it is a release, record the press too</source>
        <translation>Wenn es ein Rückweg ist, zeichnen Sie auch den Hinweg auf</translation>
    </message>
    <message>
        <source>If it is, confirm it with %1</source>
        <translation>Wenn ja, bestätigen Sie es mit %1</translation>
    </message>
    <message>
        <source>it is not known whether column %1 holds displacements and column %2 forces</source>
        <translation>es ist nicht bekannt, ob Spalte %1 Wege und Spalte %2 Kräfte enthält</translation>
    </message>
    <message>
        <source>it is not known whether column %1 holds displacements</source>
        <translation>es ist nicht bekannt, ob Spalte %1 Wege enthält</translation>
    </message>
    <message>
        <source>it is not known whether column %1 holds forces</source>
        <translation>es ist nicht bekannt, ob Spalte %1 Kräfte enthält</translation>
    </message>
    <message>
        <source>column %1 was read in %2, the unit that you gave</source>
        <translation>Spalte %1 wurde in %2 gelesen, der von Ihnen angegebenen Einheit</translation>
    </message>
    <message>
        <source>no column holds displacements; the columns are %1</source>
        <translation>keine Spalte enthält Wege; die Spalten sind %1</translation>
    </message>
    <message>
        <source>no column holds forces; the columns are %1</source>
        <translation>keine Spalte enthält Kräfte; die Spalten sind %1</translation>
    </message>
    <message>
        <source>no column holds displacements, and none holds forces; the columns are %1</source>
        <translation>keine Spalte enthält Wege, und keine enthält Kräfte; die Spalten sind %1</translation>
    </message>
    <message>
        <source>Export the points in the order of the movement, or each stroke in its own column</source>
        <translation>Exportieren Sie die Punkte in der Reihenfolge der Bewegung, oder jeden Hub in einer eigenen Spalte</translation>
    </message>
    <message>
        <source>Choose one of them with --record NAME|N, or their mean with --record mean</source>
        <translation>Wählen Sie mit --record NAME|N eine davon, oder mit --record mean ihr Mittel</translation>
    </message>
    <message>
        <source>the first %1 of the movement, before the contact, was cut off; the contact point is known to within %2</source>
        <translation>die ersten %1 der Bewegung, vor der Berührung, wurden abgeschnitten; der Berührungspunkt ist auf %2 genau</translation>
    </message>
    <message>
        <source>this is a folder, not a file</source>
        <translation>dies ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>the file holds a release, but no press</source>
        <translation>die Datei enthält einen Rückweg, aber keinen Hinweg</translation>
    </message>
    <message>
        <source>If one of them is it: --displacement-column NAME|N, --force-column NAME|N</source>
        <translation>Falls es eine von ihnen ist: --displacement-column NAME|N, --force-column NAME|N</translation>
    </message>
    <message>
        <source>this is not an ordinary file</source>
        <translation>dies ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>Save the content to an ordinary file and import that file</source>
        <translation>Speichern Sie den Inhalt in einer gewöhnlichen Datei, und importieren Sie diese</translation>
    </message>
    <message>
        <source>Give the columns titles such as &quot;Travel (mm)&quot; and &quot;Force (N)&quot;</source>
        <translation>Geben Sie den Spalten Titel wie „Weg (mm)“ und „Kraft (N)“</translation>
    </message>
    <message>
        <source>To read one of them alone, save it as a file of its own</source>
        <translation>Um nur eine davon zu lesen, speichern Sie sie als eigene Datei</translation>
    </message>
</context>
<context>
    <name>detent::importer::MupdfSource</name>
    <message>
        <source>the %1 is damaged (%2)</source>
        <translation>%1: die Datei ist beschädigt (%2)</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>ohne Angabe eines Grundes</translation>
    </message>
    <message>
        <source>Open the file in a viewer and print or export it again, or import a picture of the page</source>
        <translation>Öffnen Sie die Datei in einem Betrachter, und drucken oder exportieren Sie sie noch einmal, oder importieren Sie ein Bild der Seite</translation>
    </message>
    <message>
        <source>there is not enough memory to open the file</source>
        <translation>der Speicher reicht nicht aus, um die Datei zu öffnen</translation>
    </message>
    <message>
        <source>Close other programs and try again</source>
        <translation>Schließen Sie andere Programme, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>end of file</source>
        <translation>Dateiende</translation>
    </message>
    <message>
        <source>the PDF is truncated (its end mark is missing)</source>
        <translation>die PDF-Datei ist abgeschnitten (ihr Ende fehlt)</translation>
    </message>
    <message>
        <source>Copy or download the file again</source>
        <translation>Kopieren oder laden Sie die Datei noch einmal</translation>
    </message>
    <message>
        <source>the PDF is encrypted with a password</source>
        <translation>die PDF-Datei ist mit einem Passwort verschlüsselt</translation>
    </message>
    <message>
        <source>Save a copy without the password and import that</source>
        <translation>Speichern Sie eine Kopie ohne Passwort, und importieren Sie diese</translation>
    </message>
    <message>
        <source>Export the page as a picture of at least 300 dpi and import that</source>
        <translation>Exportieren Sie die Seite als Bild mit mindestens 300 dpi, und importieren Sie das</translation>
    </message>
    <message>
        <source>the drawing has too many points (the limit is %1)</source>
        <translation>die Zeichnung hat zu viele Punkte (die Grenze ist %1)</translation>
    </message>
    <message>
        <source>the page has too many objects</source>
        <translation>die Seite hat zu viele Objekte</translation>
    </message>
    <message>
        <source>the page takes too long to draw</source>
        <translation>es dauert zu lange, die Seite zu zeichnen</translation>
    </message>
    <message>
        <source>the page takes too long to interpret</source>
        <translation>es dauert zu lange, die Seite zu lesen</translation>
    </message>
    <message>
        <source>an image on the page claims %1 x %2 pixels, which is more than the limit</source>
        <translation>ein Bild auf der Seite gibt %1 × %2 Pixel an, mehr als die Grenze</translation>
    </message>
    <message>
        <source>the page needs more memory than allowed</source>
        <translation>die Seite braucht mehr Speicher als erlaubt</translation>
    </message>
    <message>
        <source>the region lies outside the page</source>
        <translation>der Bereich liegt außerhalb der Seite</translation>
    </message>
    <message>
        <source>Give a region inside %1 x %2 points</source>
        <translation>Einen Bereich innerhalb von %1 x %2 Punkten angeben</translation>
    </message>
    <message>
        <source>the document has %1 pages, more than the limit of %2</source>
        <translation>das Dokument hat %1 Seiten, mehr als die Grenze von %2</translation>
    </message>
    <message>
        <source>Save the pages with the graphs as a document of their own and import that</source>
        <translation>Speichern Sie die Seiten mit den Graphen als eigenes Dokument und importieren Sie dieses</translation>
    </message>
</context>
<context>
    <name>detent::importer::PictureSource</name>
    <message>
        <source>the GIF picture is damaged or animated</source>
        <translation>das GIF-Bild ist beschädigt oder animiert</translation>
    </message>
    <message>
        <source>Save the picture that shows the whole graph as PNG and import that</source>
        <translation>Speichern Sie das Bild, das den ganzen Graphen zeigt, als PNG und importieren Sie dieses</translation>
    </message>
    <message>
        <source>the %1 is damaged and cannot be decoded</source>
        <translation>%1: die Datei ist beschädigt und lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>Save or export the picture again and import the new file</source>
        <translation>Speichern oder exportieren Sie das Bild noch einmal, und importieren Sie die neue Datei</translation>
    </message>
    <message>
        <source>the region lies outside the picture</source>
        <translation>der Bereich liegt außerhalb des Bilds</translation>
    </message>
    <message>
        <source>Give a region inside %1 x %2 pixels</source>
        <translation>Einen Bereich innerhalb von %1 x %2 Pixeln angeben</translation>
    </message>
</context>
<context>
    <name>detent::importer::SvgSource</name>
    <message>
        <source>%1 parts are not drawn, because they are HTML or lie in other files</source>
        <translation>%1 Teile werden nicht gezeichnet, weil sie HTML sind oder in anderen Dateien liegen</translation>
    </message>
    <message>
        <source>no installed font has the letters %1; boxes are drawn instead</source>
        <translation>keine installierte Schrift hat die Zeichen %1; stattdessen sind Kästchen gezeichnet</translation>
    </message>
    <message>
        <source>the SVG cannot be drawn: %1</source>
        <translation>die SVG-Datei kann nicht gezeichnet werden: %1</translation>
    </message>
    <message>
        <source>end of file</source>
        <translation>Ende der Datei</translation>
    </message>
    <message>
        <source>the %1 is truncated</source>
        <translation>%1 ist abgeschnitten</translation>
    </message>
    <message>
        <source>Copy or download the file again</source>
        <translation>Die Datei neu kopieren oder herunterladen</translation>
    </message>
    <message>
        <source>the program detent-svg-worker, which draws SVG files, is not in %1</source>
        <translation>das Programm detent-svg-worker, das SVG-Dateien zeichnet, ist nicht in %1</translation>
    </message>
    <message>
        <source>Install Detent&apos;s package again, or export the drawing as a PDF and import that</source>
        <translation>Das Paket von Detent neu installieren, oder die Zeichnung als PDF exportieren und dieses importieren</translation>
    </message>
    <message>
        <source>the program detent-svg-worker cannot be started (%1)</source>
        <translation>das Programm detent-svg-worker kann nicht gestartet werden (%1)</translation>
    </message>
    <message>
        <source>Close other programs and try again</source>
        <translation>Andere Programme schließen und noch einmal versuchen</translation>
    </message>
    <message>
        <source>the drawing takes too long to draw</source>
        <translation>es dauert zu lange, die Zeichnung zu zeichnen</translation>
    </message>
    <message>
        <source>the drawing has too many objects</source>
        <translation>die Zeichnung hat zu viele Objekte</translation>
    </message>
    <message>
        <source>the drawing needs more memory than allowed, or crashes the program that draws it</source>
        <translation>die Zeichnung braucht mehr Speicher als erlaubt oder bringt das Programm zum Absturz, das sie zeichnet</translation>
    </message>
    <message>
        <source>Export the drawing as a PDF or as a picture of at least 300 dpi and import that</source>
        <translation>Die Zeichnung als PDF oder als Bild mit mindestens 300 dpi exportieren und dieses importieren</translation>
    </message>
</context>
<context>
    <name>detent::importer::trace</name>
    <message>
        <source>no curve of this colour runs through the plot frame</source>
        <translation>keine Kurve dieser Farbe läuft durch den Rahmen</translation>
    </message>
</context>
<context>
    <name>detent::playback</name>
    <message>
        <source>almost no errors in 90 trials</source>
        <translation>fast keine Fehler in 90 Durchgängen</translation>
    </message>
    <message>
        <source>about %1 errors in 90 trials</source>
        <translation>etwa %1 Fehler in 90 Durchgängen</translation>
    </message>
    <message>
        <source>%1 to %2 errors in 90 trials</source>
        <translation>%1 bis %2 Fehler in 90 Durchgängen</translation>
    </message>
    <message>
        <source>people can tell these apart: %1</source>
        <translation>Menschen können diese unterscheiden: %1</translation>
    </message>
    <message>
        <source>people cannot tell these apart: %1</source>
        <translation>Menschen können diese nicht unterscheiden: %1</translation>
    </message>
    <message>
        <source>people can probably tell these apart (%1): %2</source>
        <translation>Menschen können diese wahrscheinlich unterscheiden (%1): %2</translation>
    </message>
    <message>
        <source>people probably cannot tell these apart (%1): %2</source>
        <translation>Menschen können diese wahrscheinlich nicht unterscheiden (%1): %2</translation>
    </message>
    <message>
        <source>nothing differs</source>
        <translation>nichts unterscheidet sich</translation>
    </message>
    <message>
        <source>the largest difference is on the press: %1</source>
        <translation>der größte Unterschied liegt auf dem Hinweg: %1</translation>
    </message>
    <message>
        <source>the largest difference is on the release: %1</source>
        <translation>der größte Unterschied liegt auf dem Rückweg: %1</translation>
    </message>
    <message>
        <source>Write the text that participants are asked to agree to</source>
        <translation>Schreiben Sie den Text, in den die Versuchspersonen einwilligen sollen</translation>
    </message>
    <message>
        <source>Give one text for each language: NAME.en.txt, NAME.de.txt</source>
        <translation>Einen Text für jede Sprache nennen: NAME.en.txt, NAME.de.txt</translation>
    </message>
    <message>
        <source>Give another participant id</source>
        <translation>Eine andere Kennung der Versuchsperson eingeben</translation>
    </message>
    <message>
        <source>Go on in the same condition, or give another participant id</source>
        <translation>In derselben Bedingung weitermachen oder eine andere Kennung der Versuchsperson eingeben</translation>
    </message>
    <message>
        <source>Give an id that sounds different when read aloud</source>
        <translation>Eine Kennung eingeben, die vorgelesen anders klingt</translation>
    </message>
    <message>
        <source>%1 lies outside %2 to %3</source>
        <translation>%1 liegt nicht zwischen %2 und %3</translation>
    </message>
    <message>
        <source>Give a number inside this range</source>
        <translation>Geben Sie eine Zahl in diesem Bereich ein</translation>
    </message>
    <message>
        <source>Choose another quantity, mode, button or kind of feel</source>
        <translation>Eine andere Größe, Art, einen anderen Taster oder ein anderes Gefühl wählen</translation>
    </message>
    <message>
        <source>Rename the file</source>
        <translation>Die Datei umbenennen</translation>
    </message>
    <message>
        <source>Rename one of the files</source>
        <translation>Eine der Dateien umbenennen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a participant&apos;s id</source>
        <translation>„%1“ ist keine Kennung</translation>
    </message>
    <message>
        <source>Give 1 to %1 letters, digits, - or _, such as P01, but no name of a person</source>
        <translation>1 bis %1 Buchstaben, Ziffern, - oder _ eingeben, etwa P01, aber keinen Personennamen</translation>
    </message>
    <message>
        <source>Give at least one button</source>
        <translation>Geben Sie mindestens einen Taster an</translation>
    </message>
    <message>
        <source>Give at least two buttons</source>
        <translation>Geben Sie mindestens zwei Taster an</translation>
    </message>
    <message>
        <source>Give at most %1</source>
        <translation>Höchstens %1 wählen</translation>
    </message>
    <message>
        <source>Leave this option out</source>
        <translation>Lassen Sie diese Option weg</translation>
    </message>
    <message>
        <source>Give fewer pairs, or 0 for all pairs</source>
        <translation>Geben Sie weniger Paare an, oder 0 für alle Paare</translation>
    </message>
    <message>
        <source>Choose at least one mode, each only once</source>
        <translation>Wählen Sie mindestens eine Art, jede nur einmal</translation>
    </message>
    <message>
        <source>Give full, click-only or slope-only</source>
        <translation>full, click-only oder slope-only angeben</translation>
    </message>
    <message>
        <source>Add --kind matching</source>
        <translation>--kind matching hinzufügen</translation>
    </message>
    <message>
        <source>Name a new folder; a study is never overwritten</source>
        <translation>Einen neuen Ordner nennen; eine Studie wird nie überschrieben</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>no sound output was found</source>
        <translation>es wurde kein Tonausgang gefunden</translation>
    </message>
    <message>
        <source>no sound input was found</source>
        <translation>es wurde kein Toneingang gefunden</translation>
    </message>
    <message>
        <source>Connect a sound device, or start a JACK server</source>
        <translation>Schließen Sie ein Audiogerät an, oder starten Sie einen JACK-Server</translation>
    </message>
    <message>
        <source>Give a longer part of the name</source>
        <translation>Geben Sie einen längeren Teil des Namens an</translation>
    </message>
    <message>
        <source>Check the device and try again</source>
        <translation>Prüfen Sie das Gerät und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>Switch the device off and on, connect it without a hub, and try again</source>
        <translation>Schalten Sie das Gerät aus und wieder ein, schließen Sie es ohne Hub an, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>Name the firmware file that came with the Falcon&apos;s driver (docs/guide/force-feedback.md)</source>
        <translation>Nennen Sie die Firmware-Datei, die mit dem Treiber des Falcon kam (docs/guide/force-feedback.md)</translation>
    </message>
    <message>
        <source>Give yourself the permission with a udev rule (docs/guide/force-feedback.md), then plug the device in again</source>
        <translation>Erlauben Sie sich den Zugriff mit einer udev-Regel (docs/guide/force-feedback.md), und stecken Sie das Gerät neu ein</translation>
    </message>
    <message>
        <source>End the other program</source>
        <translation>Beenden Sie das andere Programm</translation>
    </message>
    <message>
        <source>Unplug the device, switch its power off and on, plug it in again</source>
        <translation>Ziehen Sie das Gerät ab, schalten Sie es aus und wieder ein, und stecken Sie es neu ein</translation>
    </message>
    <message>
        <source>Choose another port</source>
        <translation>Wählen Sie einen anderen Anschluss</translation>
    </message>
    <message>
        <source>Name the force device as one of these: sim, sim:falcon, sim:rig, serial:PORT, odrive:PORT, falcon or falcon:N</source>
        <translation>Nennen Sie eines dieser Kraftgeräte: sim, sim:falcon, sim:rig, serial:PORT, odrive:PORT, falcon oder falcon:N</translation>
    </message>
    <message>
        <source>there is no such simulated device</source>
        <translation>ein solches simuliertes Gerät gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such device</source>
        <translation>ein solches Gerät gibt es nicht</translation>
    </message>
    <message>
        <source>the position is not a number</source>
        <translation>die Position ist keine Zahl</translation>
    </message>
    <message>
        <source>Give the position in mm with a point, for example hold=1.25</source>
        <translation>Geben Sie die Position in mm mit einem Punkt an, zum Beispiel hold=1.25</translation>
    </message>
    <message>
        <source>the position lies more than 1 mm outside the travel of %1</source>
        <translation>die Position liegt mehr als 1 mm außerhalb des Wegs von %1</translation>
    </message>
    <message>
        <source>Give a position inside the travel</source>
        <translation>Geben Sie eine Position innerhalb des Wegs an</translation>
    </message>
    <message>
        <source>no reading of the press trace is a number</source>
        <translation>kein Messwert des Druckverlaufs ist eine Zahl</translation>
    </message>
    <message>
        <source>Check that the firmware follows docs/reference/force-protocol.md</source>
        <translation>Prüfen Sie, ob die Firmware docs/reference/force-protocol.md befolgt</translation>
    </message>
    <message>
        <source>sample %1</source>
        <translation>Wert %1</translation>
    </message>
    <message>
        <source>the force is %1</source>
        <translation>die Kraft ist %1</translation>
    </message>
    <message>
        <source>the displacement is %1</source>
        <translation>der Weg ist %1</translation>
    </message>
    <message>
        <source>samples of %1 bits are not supported</source>
        <translation>%1 Bit je Wert werden nicht unterstützt</translation>
    </message>
    <message>
        <source>Give 8 or 16</source>
        <translation>Geben Sie 8 oder 16 an</translation>
    </message>
    <message>
        <source>a rate of %1 samples a second is not supported</source>
        <translation>%1 Werte je Sekunde werden nicht unterstützt</translation>
    </message>
    <message>
        <source>Give a rate from 8000 to 192000</source>
        <translation>Geben Sie eine Rate von 8000 bis 192000 an</translation>
    </message>
    <message>
        <source>Correct these readings</source>
        <translation>Berichtigen Sie diese Messwerte</translation>
    </message>
    <message>
        <source>this press produces no vibration</source>
        <translation>diese Betätigung erzeugt keine Vibration</translation>
    </message>
    <message>
        <source>the press lasts %1 s; an export holds at most %2 s</source>
        <translation>die Betätigung dauert %1 s; ein Export fasst höchstens %2 s</translation>
    </message>
    <message>
        <source>Give a shorter press</source>
        <translation>Geben Sie eine kürzere Betätigung an</translation>
    </message>
    <message>
        <source>the parameter curve %1 is left out</source>
        <translation>die Parameterkurve %1 wird weggelassen</translation>
    </message>
    <message>
        <source>Sort the curve&apos;s points by time</source>
        <translation>Ordnen Sie die Punkte der Kurve nach der Zeit</translation>
    </message>
    <message>
        <source>the parameter %1 is left out</source>
        <translation>der Parameter %1 wird weggelassen</translation>
    </message>
    <message>
        <source>events of the type %1 are left out</source>
        <translation>Ereignisse der Art %1 werden weggelassen</translation>
    </message>
    <message>
        <source>the event parameter %1 is left out</source>
        <translation>der Ereignisparameter %1 wird weggelassen</translation>
    </message>
    <message>
        <source>Export the file as version 1</source>
        <translation>Exportieren Sie die Datei als Version 1</translation>
    </message>
    <message>
        <source>Sort the points by time</source>
        <translation>Ordnen Sie die Punkte nach der Zeit</translation>
    </message>
    <message>
        <source>Export the file again as version 1</source>
        <translation>Exportieren Sie die Datei neu als Version 1</translation>
    </message>
    <message>
        <source>Give Sine, Square, Triangle, SawToothUp or SawToothDown</source>
        <translation>Geben Sie Sine, Square, Triangle, SawToothUp oder SawToothDown an</translation>
    </message>
    <message>
        <source>Sort the keyframes by relative_position</source>
        <translation>Ordnen Sie die Schlüsselbilder nach relative_position</translation>
    </message>
    <message>
        <source>wavelet bands are left out</source>
        <translation>Wavelet-Bänder werden weggelassen</translation>
    </message>
    <message>
        <source>Give Transient, Curve or VectorialWave</source>
        <translation>Geben Sie Transient, Curve oder VectorialWave an</translation>
    </message>
    <message>
        <source>curves of the type %1 are played as straight lines</source>
        <translation>Kurven der Art %1 werden als gerade Linien wiedergegeben</translation>
    </message>
    <message>
        <source>effects of the type %1 are left out</source>
        <translation>Effekte der Art %1 werden weggelassen</translation>
    </message>
    <message>
        <source>Add the effect to the effect_library</source>
        <translation>Fügen Sie den Effekt in die effect_library ein</translation>
    </message>
    <message>
        <source>the file has the draft version 1; it is played as the edition of 2023</source>
        <translation>die Datei hat die Entwurfsversion 1; sie wird wie die Ausgabe von 2023 gespielt</translation>
    </message>
    <message>
        <source>commas before a closing bracket are not valid JSON; they are ignored</source>
        <translation>Kommas vor einer schließenden Klammer sind kein gültiges JSON; sie werden ignoriert</translation>
    </message>
    <message>
        <source>Export the file for one of these editions</source>
        <translation>Exportieren Sie die Datei für eine dieser Ausgaben</translation>
    </message>
    <message>
        <source>%1 channels are played together</source>
        <translation>%1 Kanäle werden zusammen wiedergegeben</translation>
    </message>
    <message>
        <source>the signal exceeds full scale by a factor of %1 and is turned down</source>
        <translation>das Signal überschreitet die Vollaussteuerung um den Faktor %1 und wird abgeschwächt</translation>
    </message>
    <message>
        <source>Give a file with events</source>
        <translation>Geben Sie eine Datei mit Ereignissen an</translation>
    </message>
    <message>
        <source>Give a file of at most %1 s</source>
        <translation>Geben Sie eine Datei von höchstens %1 s an</translation>
    </message>
    <message>
        <source>Give a file whose events last at most %1 s in total</source>
        <translation>Geben Sie eine Datei an, deren Ereignisse zusammen höchstens %1 s dauern</translation>
    </message>
    <message>
        <source>Export or copy the file again</source>
        <translation>Exportieren oder kopieren Sie die Datei neu</translation>
    </message>
    <message>
        <source>the mean of its %1 channels is played</source>
        <translation>das Mittel ihrer %1 Kanäle wird wiedergegeben</translation>
    </message>
    <message>
        <source>Give a shorter file</source>
        <translation>Geben Sie eine kürzere Datei an</translation>
    </message>
    <message>
        <source>Export the file again: it may have been cut off</source>
        <translation>Exportieren Sie die Datei neu: Sie kann abgeschnitten sein</translation>
    </message>
    <message>
        <source>Correct the number</source>
        <translation>Berichtigen Sie die Zahl</translation>
    </message>
    <message>
        <source>the profile of a force device</source>
        <translation>das Profil eines Kraftgeräts</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 fehlt</translation>
    </message>
    <message>
        <source>Measure the device with `detent-play identify-device`</source>
        <translation>Messen Sie das Gerät mit `detent-play identify-device`</translation>
    </message>
    <message>
        <source>a device profile</source>
        <translation>ein Geräteprofil</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>See docs/reference/device-profile.md</source>
        <translation>Siehe docs/reference/device-profile.md</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the first line is %1, not the names of the columns</source>
        <translation>die erste Zeile ist %1, nicht die Namen der Spalten</translation>
    </message>
    <message>
        <source>%1 has %2 fields, not 2</source>
        <translation>%1 hat %2 Felder, nicht 2</translation>
    </message>
    <message>
        <source>%1 is not a time</source>
        <translation>%1 ist keine Zeit</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 ist keine Zahl</translation>
    </message>
    <message>
        <source>no reading follows the header</source>
        <translation>auf den Kopf folgt kein Messwert</translation>
    </message>
    <message>
        <source>the first time is %1 s</source>
        <translation>die erste Zeit ist %1 s</translation>
    </message>
    <message>
        <source>Subtract this from all times, so that they begin at 0</source>
        <translation>Ziehen Sie das von allen Zeiten ab, damit sie bei 0 beginnen</translation>
    </message>
    <message>
        <source>the recording is longer than a week</source>
        <translation>die Aufzeichnung ist länger als eine Woche</translation>
    </message>
    <message>
        <source>Cut the recording into parts</source>
        <translation>Zerlegen Sie die Aufzeichnung in Teile</translation>
    </message>
    <message>
        <source>Give the forces of a pressing finger in N</source>
        <translation>Geben Sie die Kräfte eines drückenden Fingers in N an</translation>
    </message>
    <message>
        <source>Give displacements in mm</source>
        <translation>Geben Sie Wege in mm an</translation>
    </message>
    <message>
        <source>Give a value inside this range</source>
        <translation>Geben Sie einen Wert in diesem Bereich an</translation>
    </message>
    <message>
        <source>sample rate in Hz</source>
        <translation>Abtastrate in Hz</translation>
    </message>
    <message>
        <source>block length in samples</source>
        <translation>Blocklänge in Abtastwerten</translation>
    </message>
    <message>
        <source>time after the press in s</source>
        <translation>Zeit nach der Betätigung in s</translation>
    </message>
    <message>
        <source>Give a WAV file</source>
        <translation>Geben Sie eine WAV-Datei an</translation>
    </message>
    <message>
        <source>Give a longer file</source>
        <translation>Geben Sie eine längere Datei an</translation>
    </message>
    <message>
        <source>Export the file again</source>
        <translation>Exportieren Sie die Datei neu</translation>
    </message>
    <message>
        <source>Give positive times that add up to at most 600 s</source>
        <translation>Geben Sie positive Zeiten an, die zusammen höchstens 600 s ergeben</translation>
    </message>
    <message>
        <source>the device has steps of %1, but the playback was prepared for finer steps</source>
        <translation>das Gerät hat Schritte von %1, die Wiedergabe wurde aber für feinere vorbereitet</translation>
    </message>
    <message>
        <source>Name fewer buttons, or make several pages</source>
        <translation>Nennen Sie weniger Taster oder machen Sie mehrere Seiten</translation>
    </message>
    <message>
        <source>Give a value from %1 to %2</source>
        <translation>Geben Sie einen Wert von %1 bis %2 an</translation>
    </message>
    <message>
        <source>A force device can produce %1 to %2; scale the button (edit it, or convert its graph)</source>
        <translation>Ein Kraftgerät kann %1 bis %2 erzeugen; skalieren Sie den Taster (bearbeiten Sie ihn oder wandeln Sie seinen Graphen um)</translation>
    </message>
    <message>
        <source>Choose a device that reaches farther, or scale the button (edit it, or convert its graph)</source>
        <translation>Wählen Sie ein Gerät, das weiter reicht, oder skalieren Sie den Taster (bearbeiten Sie ihn oder wandeln Sie seinen Graphen um)</translation>
    </message>
    <message>
        <source>%1 must be above %2 and at most %3</source>
        <translation>%1 muss über %2 und höchstens %3 sein</translation>
    </message>
    <message>
        <source>the force falls while the reading rises</source>
        <translation>die Kraft fällt, während der Messwert steigt</translation>
    </message>
    <message>
        <source>Swap the sensor&apos;s two wires, or calibrate again</source>
        <translation>Vertauschen Sie die beiden Drähte des Sensors oder kalibrieren Sie neu</translation>
    </message>
    <message>
        <source>Calibrate the sensor again</source>
        <translation>Kalibrieren Sie den Sensor neu</translation>
    </message>
    <message>
        <source>line 1</source>
        <translation>Zeile 1</translation>
    </message>
    <message>
        <source>Move this file out of the study</source>
        <translation>Nehmen Sie diese Datei aus der Studie</translation>
    </message>
    <message>
        <source>Start the step again</source>
        <translation>Beginnen Sie den Schritt neu</translation>
    </message>
    <message>
        <source>Put the file %1 into this folder, or choose another language</source>
        <translation>Legen Sie die Datei %1 in diesen Ordner, oder wählen Sie eine andere Sprache</translation>
    </message>
    <message>
        <source>Restore the journal from a copy</source>
        <translation>Stellen Sie das Journal aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>Restore both files from a copy</source>
        <translation>Stellen Sie beide Dateien aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>Give the columns trial,press_s: one row for each press, in seconds after the cue</source>
        <translation>Geben Sie die Spalten trial,press_s an: eine Zeile für jeden Tastendruck, in Sekunden nach dem Zeichen</translation>
    </message>
    <message>
        <source>recorded presses can answer only timing studies</source>
        <translation>aufgezeichnete Tastendrücke können nur Studien des Timings beantworten</translation>
    </message>
    <message>
        <source>Give guess, perfect or errors=P</source>
        <translation>Geben Sie guess, perfect oder errors=P an</translation>
    </message>
    <message>
        <source>Give timing=PLACE,SPREAD or presses=FILE</source>
        <translation>Geben Sie timing=STELLE,STREUUNG oder presses=DATEI an</translation>
    </message>
    <message>
        <source>Give a time of 0.01 s or more</source>
        <translation>Geben Sie eine Zeit ab 0.01 s an</translation>
    </message>
    <message>
        <source>Restore the file from a copy, or plan again before the first participant begins</source>
        <translation>Stellen Sie die Datei aus einer Kopie wieder her, oder planen Sie neu, bevor die erste Versuchsperson beginnt</translation>
    </message>
    <message>
        <source>Restore the file</source>
        <translation>Stellen Sie die Datei wieder her</translation>
    </message>
    <message>
        <source>Restore the original file</source>
        <translation>Stellen Sie die ursprüngliche Datei wieder her</translation>
    </message>
    <message>
        <source>Restore the file, or make a new study with the changed button</source>
        <translation>Stellen Sie die Datei wieder her oder machen Sie eine neue Studie mit dem geänderten Taster</translation>
    </message>
    <message>
        <source>Restore the file, or make a new study</source>
        <translation>Stellen Sie die Datei wieder her oder machen Sie eine neue Studie</translation>
    </message>
    <message>
        <source>Check the folder, its permissions and the free space</source>
        <translation>Prüfen Sie den Ordner, seine Zugriffsrechte und den freien Platz</translation>
    </message>
    <message>
        <source>Restore the file from a copy</source>
        <translation>Stellen Sie die Datei aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>button &quot;%1&quot; (%2) would feel different in this program (%3) than in the one that made the study (%4)</source>
        <translation>Taster „%1“ (%2) würde sich in diesem Programm (%3) anders anfühlen als in dem, das die Studie gemacht hat (%4)</translation>
    </message>
    <message>
        <source>Go on with that program, or begin a new study</source>
        <translation>Machen Sie mit jenem Programm weiter oder beginnen Sie eine neue Studie</translation>
    </message>
    <message>
        <source>Plan before the first participant begins, or make a new study</source>
        <translation>Planen Sie, bevor die erste Versuchsperson beginnt, oder machen Sie eine neue Studie</translation>
    </message>
    <message>
        <source>invalid state</source>
        <translation>ungültiger Zustand</translation>
    </message>
    <message>
        <source>motor failed</source>
        <translation>Motor gestört</translation>
    </message>
    <message>
        <source>sensorless estimator failed</source>
        <translation>sensorlose Schätzung gestört</translation>
    </message>
    <message>
        <source>encoder failed</source>
        <translation>Encoder gestört</translation>
    </message>
    <message>
        <source>controller failed</source>
        <translation>Regler gestört</translation>
    </message>
    <message>
        <source>watchdog timer expired</source>
        <translation>Überwachungszeit abgelaufen</translation>
    </message>
    <message>
        <source>end stop pressed (low)</source>
        <translation>Endschalter gedrückt (unten)</translation>
    </message>
    <message>
        <source>end stop pressed (high)</source>
        <translation>Endschalter gedrückt (oben)</translation>
    </message>
    <message>
        <source>emergency stop requested</source>
        <translation>Nothalt verlangt</translation>
    </message>
    <message>
        <source>homing without end stop</source>
        <translation>Referenzfahrt ohne Endschalter</translation>
    </message>
    <message>
        <source>over temperature</source>
        <translation>zu heiß</translation>
    </message>
    <message>
        <source>unknown position</source>
        <translation>Position unbekannt</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>Fehler %1</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>%1; error %2</source>
        <translation>%1; Fehler %2</translation>
    </message>
    <message>
        <source>%1 of %2 answers were late or lost while the handle was pushed a little</source>
        <translation>%1 von %2 Antworten kamen zu spät oder gar nicht, während der Griff leicht geschoben wurde</translation>
    </message>
    <message>
        <source>Check the cable, close other programs on this computer, and try again</source>
        <translation>Prüfen Sie das Kabel, schließen Sie andere Programme auf diesem Rechner, und versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>Check the folder, its permissions and the free space, then try again</source>
        <translation>Prüfen Sie den Ordner, seine Zugriffsrechte und den freien Platz und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>state %1</source>
        <translation>Zustand %1</translation>
    </message>
    <message>
        <source>initializing</source>
        <translation>Initialisierung</translation>
    </message>
    <message>
        <source>system level</source>
        <translation>Systemfehler</translation>
    </message>
    <message>
        <source>timing error</source>
        <translation>Zeitfehler</translation>
    </message>
    <message>
        <source>missing estimate</source>
        <translation>fehlende Schätzung</translation>
    </message>
    <message>
        <source>bad configuration</source>
        <translation>falsche Konfiguration</translation>
    </message>
    <message>
        <source>gate driver fault</source>
        <translation>Fehler des Gate-Treibers</translation>
    </message>
    <message>
        <source>missing input</source>
        <translation>fehlende Eingabe</translation>
    </message>
    <message>
        <source>DC bus over-voltage</source>
        <translation>Überspannung im Zwischenkreis</translation>
    </message>
    <message>
        <source>DC bus under-voltage</source>
        <translation>Unterspannung im Zwischenkreis</translation>
    </message>
    <message>
        <source>DC bus over-current</source>
        <translation>Überstrom im Zwischenkreis</translation>
    </message>
    <message>
        <source>DC bus over-regeneration current</source>
        <translation>zu hoher Rückspeisestrom im Zwischenkreis</translation>
    </message>
    <message>
        <source>current limit violation</source>
        <translation>Stromgrenze überschritten</translation>
    </message>
    <message>
        <source>motor over temperature</source>
        <translation>Motor zu heiß</translation>
    </message>
    <message>
        <source>inverter over temperature</source>
        <translation>Wechselrichter zu heiß</translation>
    </message>
    <message>
        <source>velocity limit violation</source>
        <translation>Geschwindigkeitsgrenze überschritten</translation>
    </message>
    <message>
        <source>position limit violation</source>
        <translation>Positionsgrenze überschritten</translation>
    </message>
    <message>
        <source>spinout detected</source>
        <translation>Durchdrehen erkannt</translation>
    </message>
    <message>
        <source>brake resistor disarmed</source>
        <translation>Bremswiderstand abgeschaltet</translation>
    </message>
    <message>
        <source>thermistor disconnected</source>
        <translation>Thermistor nicht verbunden</translation>
    </message>
    <message>
        <source>calibration error</source>
        <translation>Kalibrierfehler</translation>
    </message>
    <message>
        <source>an error whose code begins with %1; the rest was cut off, but dump_errors in odrivetool shows it</source>
        <translation>ein Fehler, dessen Code mit %1 beginnt; der Rest wurde abgeschnitten, dump_errors in odrivetool zeigt ihn</translation>
    </message>
    <message>
        <source>With friction of %1 N or an encoder step of %2 mm, the button would be stable</source>
        <translation>Mit einer Reibung von %1 N oder einem Encoderschritt von %2 mm wäre der Taster stabil</translation>
    </message>
    <message>
        <source>Give an AHAP, .haptic or HJIF file, or a sound file such as a WAV</source>
        <translation>Eine AHAP-, .haptic- oder HJIF-Datei angeben, oder eine Tondatei wie WAV</translation>
    </message>
    <message>
        <source>only channel %1 of %2 is played, because the channels would cancel each other out</source>
        <translation>nur Kanal %1 von %2 wird gespielt, weil die Kanäle einander auslöschen würden</translation>
    </message>
    <message>
        <source>the polarity is reversed: the handle moves against the commanded force</source>
        <translation>die Polung ist verkehrt: Der Griff bewegt sich gegen die verlangte Kraft</translation>
    </message>
    <message>
        <source>Swap the motor&apos;s two wires or the encoder&apos;s A and B</source>
        <translation>Die beiden Drähte des Motors tauschen, oder A und B des Encoders</translation>
    </message>
    <message>
        <source>the handle does not follow a small push</source>
        <translation>der Griff folgt einem kleinen Stoß nicht</translation>
    </message>
    <message>
        <source>Turn the motor by hand: if the position does not change, the encoder is dead. Otherwise free the handle, take the finger off, and try again</source>
        <translation>Drehen Sie den Motor von Hand: Ändert sich die Position nicht, ist der Encoder defekt. Sonst machen Sie den Griff frei, nehmen Sie den Finger weg, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a site name</source>
        <translation>„%1“ ist kein gültiger Name eines Standorts</translation>
    </message>
    <message>
        <source>Give --sites names made of letters, digits, - and _</source>
        <translation>Geben Sie bei --sites Namen aus Buchstaben, Ziffern, - und _ an</translation>
    </message>
    <message>
        <source>two sites are called &quot;%1&quot;</source>
        <translation>zwei Standorte heißen „%1“</translation>
    </message>
    <message>
        <source>Give --sites a different name for each study</source>
        <translation>Geben Sie bei --sites einen eigenen Namen für jede Studie an</translation>
    </message>
    <message>
        <source>Merge the studies of its sites</source>
        <translation>Die Studien ihrer Standorte zusammenführen</translation>
    </message>
    <message>
        <source>Merge copies of one study</source>
        <translation>Kopien einer Studie zusammenführen</translation>
    </message>
    <message>
        <source>Merge studies of one plan</source>
        <translation>Studien eines Plans zusammenführen</translation>
    </message>
    <message>
        <source>Give --sites one name for each study</source>
        <translation>Geben Sie bei --sites einen Namen für jede Studie an</translation>
    </message>
    <message>
        <source>Check the folders and the free space</source>
        <translation>Die Ordner und den freien Platz prüfen</translation>
    </message>
    <message>
        <source>Run the study of one site, then merge again</source>
        <translation>Führen Sie die Studie eines Standorts durch, und führen Sie dann neu zusammen</translation>
    </message>
    <message>
        <source>this is the merged study of several sites: nobody answers in it</source>
        <translation>dies ist die zusammengeführte Studie mehrerer Standorte: Darin antwortet niemand</translation>
    </message>
    <message>
        <source>Give the study file of one site only</source>
        <translation>Geben Sie die Studiendatei nur eines Standorts an</translation>
    </message>
    <message>
        <source>Run the study with detent-play study run or in detent-edit</source>
        <translation>Führen Sie die Studie mit detent-play study run oder in detent-edit durch</translation>
    </message>
    <message>
        <source>the study was made for a device profile, and a browser&apos;s device is unknown</source>
        <translation>die Studie wurde für ein Geräteprofil angelegt, und das Gerät eines Browsers ist unbekannt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the address of a web server</source>
        <translation>„%1“ ist nicht die Adresse eines Webservers</translation>
    </message>
    <message>
        <source>Give an address such as https://lab.example/answers</source>
        <translation>Geben Sie eine Adresse wie https://lab.example/answers an</translation>
    </message>
    <message>
        <source>Name the participants with --participants, separated by commas</source>
        <translation>Nennen Sie die Versuchspersonen mit --participants, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>Give ids that sound different when read aloud</source>
        <translation>Geben Sie Kennungen an, die vorgelesen verschieden klingen</translation>
    </message>
    <message>
        <source>With friction of %1 N, the button would be stable</source>
        <translation>Mit einer Reibung von %1 N wäre der Taster stabil</translation>
    </message>
    <message>
        <source>Give guess, perfect, errors=P with P from 0 to 1, threshold=T with T from 0.001 to 10, d-prime=D with D from 0 to 10, timing=PLACE,SPREAD or presses=FILE</source>
        <translation>Geben Sie guess, perfect, errors=P mit P von 0 bis 1, threshold=T mit T von 0.001 bis 10, d-prime=D mit D von 0 bis 10, timing=ORT,STREUUNG oder presses=DATEI an</translation>
    </message>
    <message>
        <source>Give the file another ending than %1</source>
        <translation>Geben Sie der Datei eine andere Endung als %1</translation>
    </message>
    <message>
        <source>%1 is not greater than 0</source>
        <translation>%1 ist nicht größer als 0</translation>
    </message>
    <message>
        <source>Set a distance, or turn rapid trigger off</source>
        <translation>Eine Strecke einstellen oder Rapid Trigger ausschalten</translation>
    </message>
    <message>
        <source>%1 is longer than the travel, %2</source>
        <translation>%1 ist länger als der Gesamtweg, %2</translation>
    </message>
    <message>
        <source>Set at most %1</source>
        <translation>Höchstens %1 einstellen</translation>
    </message>
    <message>
        <source>%1 lies beyond the travel, %2</source>
        <translation>%1 liegt jenseits des Gesamtwegs, %2</translation>
    </message>
    <message>
        <source>%1 does not lie between rest and the actuation point, %2</source>
        <translation>%1 liegt nicht zwischen Ruhelage und Auslösepunkt, %2</translation>
    </message>
    <message>
        <source>Set less than %1</source>
        <translation>Weniger als %1 einstellen</translation>
    </message>
    <message>
        <source>Set at most %1, or move the release point down</source>
        <translation>Höchstens %1 einstellen oder den Rückstellpunkt tiefer legen</translation>
    </message>
    <message>
        <source>Set at most %1, or move the actuation point up</source>
        <translation>Höchstens %1 einstellen oder den Auslösepunkt höher legen</translation>
    </message>
    <message>
        <source>Give at least one point</source>
        <translation>Geben Sie mindestens einen Punkt an</translation>
    </message>
    <message>
        <source>Give at least one reading</source>
        <translation>Geben Sie mindestens einen Messwert an</translation>
    </message>
    <message>
        <source>Check the connection of the sound device, or choose another one; `detent-play devices` and the Feel panel (Setup) list them</source>
        <translation>Prüfen Sie die Verbindung des Audiogeräts, oder wählen Sie ein anderes; „detent-play devices“ und der Bereich „Fühlen“ (Einrichtung) zeigen die Liste</translation>
    </message>
    <message>
        <source>this computer has no sound output of this name</source>
        <translation>dieser Rechner hat keinen Tonausgang dieses Namens</translation>
    </message>
    <message>
        <source>this computer has no sound input of this name</source>
        <translation>dieser Rechner hat keinen Toneingang dieses Namens</translation>
    </message>
    <message>
        <source>Choose a sound device from the list of `detent-play devices` or of the Feel panel (Setup)</source>
        <translation>Wählen Sie ein Audiogerät aus der Liste von „detent-play devices“ oder des Bereichs „Fühlen“ (Einrichtung)</translation>
    </message>
    <message>
        <source>several devices match this name: %1</source>
        <translation>mehrere Geräte passen zu diesem Namen: %1</translation>
    </message>
    <message>
        <source>the sound system or the sound device cannot be started</source>
        <translation>das Tonsystem oder das Audiogerät kann nicht gestartet werden</translation>
    </message>
    <message>
        <source>the sound device cannot play and record at the same time</source>
        <translation>das Audiogerät kann nicht zugleich wiedergeben und aufnehmen</translation>
    </message>
    <message>
        <source>the sound device stopped during the measurement</source>
        <translation>das Audiogerät blieb während der Messung stehen</translation>
    </message>
    <message>
        <source>the Falcon was switched on and has no firmware yet</source>
        <translation>der Falcon wurde eingeschaltet und hat noch keine Firmware</translation>
    </message>
    <message>
        <source>the Falcon did not accept the firmware in %1 attempts</source>
        <translation>der Falcon nahm die Firmware in %1 Versuchen nicht an</translation>
    </message>
    <message>
        <source>the file cannot be read (%1)</source>
        <translation>die Datei kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>the file is not Falcon firmware: it is too large</source>
        <translation>die Datei ist keine Firmware eines Falcon: Sie ist zu groß</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the file is not Falcon firmware: it is not a boot image of the Falcon&apos;s processor</source>
        <translation>die Datei ist keine Firmware eines Falcon: Sie ist kein Startabbild des Prozessors im Falcon</translation>
    </message>
    <message>
        <source>you have no permission to use the device</source>
        <translation>Sie haben keine Berechtigung, das Gerät zu benutzen</translation>
    </message>
    <message>
        <source>the device is in use by another program</source>
        <translation>ein anderes Programm benutzt das Gerät</translation>
    </message>
    <message>
        <source>the device cannot be opened (%1)</source>
        <translation>das Gerät kann nicht geöffnet werden (%1)</translation>
    </message>
    <message>
        <source>this build of Detent does not support the Novint Falcon</source>
        <translation>dieses Detent ist ohne Unterstützung des Novint Falcon gebaut</translation>
    </message>
    <message>
        <source>Choose another force device, or install a build of Detent with the Falcon (docs/guide/force-feedback.md)</source>
        <translation>Wählen Sie ein anderes Kraftgerät, oder installieren Sie ein Detent mit dem Falcon (docs/guide/force-feedback.md)</translation>
    </message>
    <message>
        <source>the device can hold the force of only one speed; this button has graphs at %1 speeds</source>
        <translation>das Gerät fasst die Kraft nur einer Geschwindigkeit; dieser Taster hat Graphen bei %1 Geschwindigkeiten</translation>
    </message>
    <message>
        <source>the device can run only one state; this button has %1</source>
        <translation>das Gerät führt nur einen Zustand aus; dieser Taster hat %1</translation>
    </message>
    <message>
        <source>Switch the upload of the force table off, so that this computer computes the force of self-locking buttons</source>
        <translation>Schalten Sie die Übertragung der Krafttabelle aus, damit dieser Rechner die Kraft rastender Taster berechnet</translation>
    </message>
    <message>
        <source>the port cannot be opened to receive messages (%1)</source>
        <translation>der Port lässt sich nicht zum Empfangen öffnen (%1)</translation>
    </message>
    <message>
        <source>the device answers after %1 ms, so the force acts %2 ms late. With this delay, slopes up to %3 N/mm are stable; this button needs %4 N/mm</source>
        <translation>das Gerät antwortet nach %1 ms, die Kraft wirkt daher %2 ms zu spät. Mit dieser Verzögerung sind Steigungen bis %3 N/mm stabil; dieser Taster braucht %4 N/mm</translation>
    </message>
    <message>
        <source>the name of the serial port is missing; an example is %1:/dev/ttyACM0</source>
        <translation>der Name der seriellen Schnittstelle fehlt; ein Beispiel ist %1:/dev/ttyACM0</translation>
    </message>
    <message>
        <source>Correct the times and values in the CSV file of the press</source>
        <translation>Berichtigen Sie die Zeiten und Werte in der CSV-Datei des Tastendrucks</translation>
    </message>
    <message>
        <source>the device does not accept the limits for a slow connection</source>
        <translation>das Gerät nimmt die Grenzen für eine langsame Verbindung nicht an</translation>
    </message>
    <message>
        <source>the recording covers only %1 in steps of %2, which are too few steps</source>
        <translation>die Aufzeichnung umfasst nur %1 in Schritten von %2, das sind zu wenige Schritte</translation>
    </message>
    <message>
        <source>two exported files would get this name</source>
        <translation>zwei exportierte Dateien bekämen diesen Namen</translation>
    </message>
    <message>
        <source>the times of control points count from the Time of their curve. In the curve at %1 s they seem to count from the beginning of the pattern instead, so it is played too late</source>
        <translation>die Zeiten von Stützpunkten zählen ab der Time ihrer Kurve. In der Kurve bei %1 s scheinen sie dagegen ab dem Anfang des Musters zu zählen, deshalb wird sie zu spät gespielt</translation>
    </message>
    <message>
        <source>this control point lies before the previous one</source>
        <translation>dieser Stützpunkt liegt vor dem vorigen</translation>
    </message>
    <message>
        <source>the version is %1, but only version 1 of AHAP can be read</source>
        <translation>die Version ist %1, lesbar ist aber nur Version 1 von AHAP</translation>
    </message>
    <message>
        <source>this point lies before the previous one</source>
        <translation>dieser Punkt liegt vor dem vorigen</translation>
    </message>
    <message>
        <source>the version is %1, but only version 1 of .haptic can be read</source>
        <translation>die Version ist %1, lesbar ist aber nur Version 1 von .haptic</translation>
    </message>
    <message>
        <source>the emphasis is weaker than the point that it emphasizes</source>
        <translation>die Betonung ist schwächer als der Punkt, den sie betont</translation>
    </message>
    <message>
        <source>Give the emphasis at least the amplitude of this point</source>
        <translation>Geben Sie der Betonung mindestens die Amplitude dieses Punkts</translation>
    </message>
    <message>
        <source>the list holds no point</source>
        <translation>die Liste enthält keinen Punkt</translation>
    </message>
    <message>
        <source>there is no base signal %1</source>
        <translation>es gibt kein Grundsignal %1</translation>
    </message>
    <message>
        <source>this keyframe lies before the previous one</source>
        <translation>dieses Schlüsselbild liegt vor dem vorigen</translation>
    </message>
    <message>
        <source>there is no band type %1</source>
        <translation>es gibt keine Art von Band mit dem Namen %1</translation>
    </message>
    <message>
        <source>this effect is not in the effect_library</source>
        <translation>dieser Effekt steht nicht in der effect_library</translation>
    </message>
    <message>
        <source>the version is %1, but only the editions of 2023 and 2025 can be read</source>
        <translation>die Version ist %1, lesbar sind aber nur die Ausgaben von 2023 und 2025</translation>
    </message>
    <message>
        <source>the file contains nothing to play</source>
        <translation>die Datei enthält nichts zum Abspielen</translation>
    </message>
    <message>
        <source>the file lasts %1 s</source>
        <translation>die Datei dauert %1 s</translation>
    </message>
    <message>
        <source>the events of the file overlap and last %1 s in total</source>
        <translation>die Ereignisse der Datei überlappen einander und dauern zusammen %1 s</translation>
    </message>
    <message>
        <source>the file is cut off</source>
        <translation>die Datei ist abgeschnitten</translation>
    </message>
    <message>
        <source>the file is JSON, but not a haptic file</source>
        <translation>die Datei ist JSON, aber keine haptische Datei</translation>
    </message>
    <message>
        <source>the file is larger than %1 MB</source>
        <translation>die Datei ist größer als %1 MB</translation>
    </message>
    <message>
        <source>the file holds a number that is too large: %1</source>
        <translation>die Datei enthält eine zu große Zahl: %1</translation>
    </message>
    <message>
        <source>the file is neither JSON nor a sound file that can be read</source>
        <translation>die Datei ist weder JSON noch eine lesbare Tondatei</translation>
    </message>
    <message>
        <source>the top dead zone of %1 is not between 0 and the release point, which is at %2</source>
        <translation>die obere Totzone von %1 liegt nicht zwischen 0 und dem Rückstellpunkt, der bei %2 liegt</translation>
    </message>
    <message>
        <source>the bottom dead zone of %1 is not between 0 and %2, the distance from the actuation point to the end of the travel</source>
        <translation>die untere Totzone von %1 liegt nicht zwischen 0 und %2, dem Abstand vom Auslösepunkt zum Ende des Wegs</translation>
    </message>
    <message>
        <source>this entry is given twice</source>
        <translation>dieser Eintrag kommt zweimal vor</translation>
    </message>
    <message>
        <source>this entry is not known</source>
        <translation>dieser Eintrag ist nicht bekannt</translation>
    </message>
    <message>
        <source>the value is not a single number</source>
        <translation>der Wert ist nicht eine einzelne Zahl</translation>
    </message>
    <message>
        <source>the value lies outside %1 to %2</source>
        <translation>der Wert liegt außerhalb %1 bis %2</translation>
    </message>
    <message>
        <source>a newer Detent wrote this file (version %1)</source>
        <translation>ein neueres Detent hat diese Datei geschrieben (Version %1)</translation>
    </message>
    <message>
        <source>the line has no &quot;=&quot;</source>
        <translation>die Zeile hat kein „=“</translation>
    </message>
    <message>
        <source>this build of Detent has no live playback</source>
        <translation>dieses Detent ist ohne Live-Wiedergabe gebaut</translation>
    </message>
    <message>
        <source>Install a build of Detent with live playback, or write the vibration to a sound file (in the window: File &gt; Export; on the command line: `detent-play render`)</source>
        <translation>Installieren Sie ein Detent mit Live-Wiedergabe, oder schreiben Sie die Vibration in eine Tondatei (im Fenster: Datei &gt; Exportieren; auf der Befehlszeile: „detent-play render“)</translation>
    </message>
    <message>
        <source>none of the %1 readings can be used, because each is out of range or not a number</source>
        <translation>keiner der %1 Messwerte ist verwendbar, weil jeder außerhalb des Bereichs liegt oder keine Zahl ist</translation>
    </message>
    <message>
        <source>the press trace contains no readings</source>
        <translation>der Druckverlauf enthält keine Messwerte</translation>
    </message>
    <message>
        <source>this is not a readable sound file: its header is damaged</source>
        <translation>dies ist keine lesbare Tondatei: Ihr Kopf ist beschädigt</translation>
    </message>
    <message>
        <source>this is not a readable sound file: %1</source>
        <translation>dies ist keine lesbare Tondatei: %1</translation>
    </message>
    <message>
        <source>the sound file has %1 samples a second</source>
        <translation>die Tondatei hat %1 Werte je Sekunde</translation>
    </message>
    <message>
        <source>the sound file has %1 channels</source>
        <translation>die Tondatei hat %1 Kanäle</translation>
    </message>
    <message>
        <source>the sound file holds no sample</source>
        <translation>die Tondatei enthält keinen Wert</translation>
    </message>
    <message>
        <source>sample %1 of the sound file is not a number</source>
        <translation>Wert %1 der Tondatei ist keine Zahl</translation>
    </message>
    <message>
        <source>Install a build of Detent that can make web pages. If you build Detent yourself, first install clang-14, lld-14, wasi-libc, libc++-14-dev-wasm32 and libclang-rt-14-dev-wasm32</source>
        <translation>Installieren Sie ein Detent, das Webseiten erzeugen kann. Wenn Sie Detent selbst bauen, installieren Sie zuerst clang-14, lld-14, wasi-libc, libc++-14-dev-wasm32 und libclang-rt-14-dev-wasm32</translation>
    </message>
    <message>
        <source>the value is %1</source>
        <translation>der Wert ist %1</translation>
    </message>
    <message>
        <source>the travel ends at %1, but %2 reaches only %3</source>
        <translation>der Weg endet bei %1, %2 reicht aber nur bis %3</translation>
    </message>
    <message>
        <source>the equalizer has %1 bands, but at most %2 are allowed</source>
        <translation>der Equalizer hat %1 Bänder, erlaubt sind aber höchstens %2</translation>
    </message>
    <message>
        <source>the device has so little friction or damping that no button is stable on it</source>
        <translation>das Gerät hat so wenig Reibung oder Dämpfung, dass kein Taster darauf stabil ist</translation>
    </message>
    <message>
        <source>the file is not a journal of a study</source>
        <translation>die Datei ist kein Journal einer Studie</translation>
    </message>
    <message>
        <source>the step was cancelled</source>
        <translation>der Schritt wurde abgebrochen</translation>
    </message>
    <message>
        <source>a timing study needs exact times, which a browser does not give</source>
        <translation>eine Studie des Timings braucht genaue Zeiten, die ein Browser nicht liefert</translation>
    </message>
    <message>
        <source>the participant %1 has begun already</source>
        <translation>die Versuchsperson %1 hat schon begonnen</translation>
    </message>
    <message>
        <source>on a force device, the participant presses the device itself, so a force sensor cannot be used as well</source>
        <translation>auf einem Kraftgerät drückt die Versuchsperson das Gerät selbst, deshalb lässt sich nicht zugleich ein Kraftsensor verwenden</translation>
    </message>
    <message>
        <source>Use either the force device or the force sensor</source>
        <translation>Verwenden Sie entweder das Kraftgerät oder den Kraftsensor</translation>
    </message>
    <message>
        <source>the device would play only the button that was uploaded, but a study switches between buttons</source>
        <translation>das Gerät würde nur den übertragenen Taster ausführen, eine Studie wechselt aber zwischen Tastern</translation>
    </message>
    <message>
        <source>Switch the upload of the force table off</source>
        <translation>Schalten Sie die Übertragung der Krafttabelle aus</translation>
    </message>
    <message>
        <source>a force device produces forces, but this study compares properties that only a vibration has</source>
        <translation>ein Kraftgerät erzeugt Kräfte, diese Studie vergleicht aber Eigenschaften, die nur eine Vibration hat</translation>
    </message>
    <message>
        <source>Either run this study without the force device, or make a study whose only mode is &quot;full&quot;</source>
        <translation>Führen Sie diese Studie entweder ohne das Kraftgerät durch, oder erstellen Sie eine Studie, deren einziger Modus „full“ ist</translation>
    </message>
    <message>
        <source>the file is not encoded as UTF-8</source>
        <translation>die Datei ist nicht als UTF-8 kodiert</translation>
    </message>
    <message>
        <source>Save the file as UTF-8 text</source>
        <translation>Speichern Sie die Datei als Text in UTF-8</translation>
    </message>
    <message>
        <source>there are two consent texts for %1</source>
        <translation>es gibt zwei Einwilligungstexte für %1</translation>
    </message>
    <message>
        <source>the folder has no consent text in the language &quot;%1&quot;</source>
        <translation>der Ordner hat keinen Einwilligungstext in der Sprache „%1“</translation>
    </message>
    <message>
        <source>this study is already a merged study</source>
        <translation>diese Studie ist schon eine zusammengeführte Studie</translation>
    </message>
    <message>
        <source>this study has other questions or other buttons than &quot;%1&quot;</source>
        <translation>diese Studie hat andere Fragen oder andere Taster als „%1“</translation>
    </message>
    <message>
        <source>this study and &quot;%1&quot; have different rules for participants who did not finish</source>
        <translation>diese Studie und „%1“ haben verschiedene Regeln für Versuchspersonen, die nicht fertig wurden</translation>
    </message>
    <message>
        <source>the folder exists already</source>
        <translation>den Ordner gibt es schon</translation>
    </message>
    <message>
        <source>the folder cannot be created (%1)</source>
        <translation>der Ordner kann nicht angelegt werden (%1)</translation>
    </message>
    <message>
        <source>Check the folder in which it should be created</source>
        <translation>Prüfen Sie den Ordner, in dem er angelegt werden soll</translation>
    </message>
    <message>
        <source>the folder cannot be read (%1)</source>
        <translation>der Ordner kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>the file &quot;%1&quot;, which belongs to the journal, is missing; the end of the journal may have been cut off</source>
        <translation>die Datei „%1“, die zum Journal gehört, fehlt; das Ende des Journals kann abgeschnitten sein</translation>
    </message>
    <message>
        <source>the file does not record the length of the journal</source>
        <translation>die Datei hält die Länge des Journals nicht fest</translation>
    </message>
    <message>
        <source>the journal should have %1 lines, but some of them are missing</source>
        <translation>das Journal sollte %1 Zeilen haben, einige davon fehlen aber</translation>
    </message>
    <message>
        <source>this participant already has simulated answers</source>
        <translation>diese Versuchsperson hat schon simulierte Antworten</translation>
    </message>
    <message>
        <source>this participant already has answers that a person gave</source>
        <translation>diese Versuchsperson hat schon Antworten, die ein Mensch gegeben hat</translation>
    </message>
    <message>
        <source>this participant has used the listening condition &quot;%1&quot; so far, not &quot;%2&quot;</source>
        <translation>diese Versuchsperson hatte bisher die Hörbedingung „%1“, nicht „%2“</translation>
    </message>
    <message>
        <source>this id is too similar to &quot;%1&quot;, which is already in the study</source>
        <translation>diese Kennung ist „%1“ zu ähnlich, die schon in der Studie ist</translation>
    </message>
    <message>
        <source>the file does not have the columns trial and press_s</source>
        <translation>die Datei hat die Spalten trial und press_s nicht</translation>
    </message>
    <message>
        <source>this line has too few fields</source>
        <translation>diese Zeile hat zu wenige Felder</translation>
    </message>
    <message>
        <source>this line does not hold a trial and a time</source>
        <translation>diese Zeile enthält keinen Durchgang mit Zeit</translation>
    </message>
    <message>
        <source>the file holds no press</source>
        <translation>die Datei enthält keinen Tastendruck</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a way to simulate answers</source>
        <translation>„%1“ ist keine Art, Antworten zu simulieren</translation>
    </message>
    <message>
        <source>this kind of simulation cannot answer a timing study</source>
        <translation>diese Art der Simulation kann keine Studie des Timings beantworten</translation>
    </message>
    <message>
        <source>a simulated sensitivity (d&apos;) can answer only same/different studies</source>
        <translation>eine simulierte Empfindlichkeit (d&apos;) kann nur Studien „gleich oder verschieden“ beantworten</translation>
    </message>
    <message>
        <source>a simulated threshold can answer only threshold studies</source>
        <translation>eine simulierte Schwelle kann nur Schwellenstudien beantworten</translation>
    </message>
    <message>
        <source>the file is not a study plan that this program knows</source>
        <translation>die Datei ist kein Studienplan, den dieses Programm kennt</translation>
    </message>
    <message>
        <source>increasing &quot;%3&quot; makes no difference to the feel of the button &quot;%1&quot; (%2)</source>
        <translation>mehr „%3“ ändert nichts daran, wie sich der Taster „%1“ anfühlt (%2)</translation>
    </message>
    <message>
        <source>the file names a mode &quot;%1&quot; that does not exist</source>
        <translation>die Datei nennt eine Art „%1“, die es nicht gibt</translation>
    </message>
    <message>
        <source>the file does not describe a study</source>
        <translation>die Datei beschreibt keine Studie</translation>
    </message>
    <message>
        <source>the study has version %1; this program knows the versions 1 to %2</source>
        <translation>die Studie hat Version %1; dieses Programm kennt die Versionen 1 bis %2</translation>
    </message>
    <message>
        <source>Use the version of Detent that made the study</source>
        <translation>Verwenden Sie die Version von Detent, mit der die Studie angelegt wurde</translation>
    </message>
    <message>
        <source>the order of the questions was made by another generator, %1</source>
        <translation>die Reihenfolge der Fragen stammt von einem anderen Generator, %1</translation>
    </message>
    <message>
        <source>the file names a kind of study &quot;%1&quot; that does not exist</source>
        <translation>die Datei nennt eine Studienart „%1“, die es nicht gibt</translation>
    </message>
    <message>
        <source>the file names a quantity %1 that does not exist</source>
        <translation>die Datei nennt eine Größe %1, die es nicht gibt</translation>
    </message>
    <message>
        <source>the file names a rating scale %1 that does not exist</source>
        <translation>die Datei nennt eine Bewertungsskala %1, die es nicht gibt</translation>
    </message>
    <message>
        <source>the file names a task %1 that does not exist</source>
        <translation>die Datei nennt eine Aufgabe %1, die es nicht gibt</translation>
    </message>
    <message>
        <source>the file names a kind of feel %1 that does not exist</source>
        <translation>die Datei nennt eine Art des Gefühls %1, die es nicht gibt</translation>
    </message>
    <message>
        <source>the file was changed after the study was made</source>
        <translation>die Datei wurde geändert, nachdem die Studie angelegt wurde</translation>
    </message>
    <message>
        <source>the file names a button &quot;%1&quot; that is not in the study</source>
        <translation>die Datei nennt einen Taster „%1“, der nicht in der Studie ist</translation>
    </message>
    <message>
        <source>the file does not record how the button &quot;%1&quot; feels in the mode %2</source>
        <translation>die Datei hält nicht fest, wie sich der Taster „%1“ in der Art %2 anfühlt</translation>
    </message>
    <message>
        <source>the name of the file is not encoded as UTF-8</source>
        <translation>der Name der Datei ist nicht als UTF-8 kodiert</translation>
    </message>
    <message>
        <source>two of the button files have the name &quot;%1&quot;</source>
        <translation>zwei der Tasterdateien haben den Namen „%1“</translation>
    </message>
    <message>
        <source>the list of times is empty or too long, repeats a time, or has a time outside %1 to %2 s</source>
        <translation>die Liste der Zeiten ist leer oder zu lang, wiederholt eine Zeit oder hat eine Zeit außerhalb %1 bis %2 s</translation>
    </message>
    <message>
        <source>the list of times is empty or too long, repeats a time, or has a time that is outside %1 to %2 s or as long as an interval</source>
        <translation>die Liste der Zeiten ist leer oder zu lang, wiederholt eine Zeit oder hat eine Zeit, die außerhalb %1 bis %2 s liegt oder so lang wie ein Intervall ist</translation>
    </message>
    <message>
        <source>the study has no button</source>
        <translation>die Studie hat keinen Taster</translation>
    </message>
    <message>
        <source>the study has only 1 button</source>
        <translation>die Studie hat nur 1 Taster</translation>
    </message>
    <message>
        <source>the study has %1 buttons</source>
        <translation>die Studie hat %1 Taster</translation>
    </message>
    <message>
        <source>this option cannot be used in a study without pairs</source>
        <translation>diese Option lässt sich in einer Studie ohne Paare nicht verwenden</translation>
    </message>
    <message>
        <source>%1 pairs are requested, but there are only %2</source>
        <translation>verlangt sind %1 Paare, es gibt aber nur %2</translation>
    </message>
    <message>
        <source>no mode is given, or one mode is given twice</source>
        <translation>es ist keine Art angegeben, oder eine Art zweimal</translation>
    </message>
    <message>
        <source>the mode &quot;off&quot; plays nothing that participants could feel</source>
        <translation>die Art „off“ spielt nichts, das Versuchspersonen fühlen könnten</translation>
    </message>
    <message>
        <source>this option needs a matching study</source>
        <translation>diese Option braucht eine Zuordnungsstudie</translation>
    </message>
    <message>
        <source>the folder is not a study: its study.json cannot be read (%1)</source>
        <translation>der Ordner ist keine Studie: Seine study.json lässt sich nicht lesen (%1)</translation>
    </message>
    <message>
        <source>Choose the folder of a study, or make a new study (in the window: Button &gt; Study with people; on the command line: `detent-play study new`)</source>
        <translation>Wählen Sie den Ordner einer Studie, oder legen Sie eine neue Studie an (im Fenster: Taster &gt; Studie mit Menschen; auf der Befehlszeile: „detent-play study new“)</translation>
    </message>
    <message>
        <source>the file names no sites that this program knows</source>
        <translation>die Datei nennt keine Standorte, die dieses Programm kennt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>the button has no room to increase &quot;%1&quot; by 10 %</source>
        <translation>der Taster lässt keinen Platz, um „%1“ um 10 % zu erhöhen</translation>
    </message>
    <message>
        <source>the study already has a participant, so it is too late for a plan</source>
        <translation>die Studie hat schon eine Versuchsperson, für einen Plan ist es daher zu spät</translation>
    </message>
    <message>
        <source>Check the folder in which it should be created, and its permissions</source>
        <translation>Prüfen Sie den Ordner, in dem er angelegt werden soll, und dessen Rechte</translation>
    </message>
    <message>
        <source>the ODrive reports no error, but does not reach closed-loop control</source>
        <translation>der ODrive meldet keinen Fehler, erreicht aber die Regelung (closed-loop control) nicht</translation>
    </message>
    <message>
        <source>%1 must start with the line &quot;%2 %3&quot;</source>
        <translation>%1 muss mit der Zeile „%2 %3“ beginnen</translation>
    </message>
    <message>
        <source>this build of Detent cannot make a web page on which buttons can be pressed</source>
        <translation>dieses Detent kann keine Webseite erzeugen, auf der sich Taster drücken lassen</translation>
    </message>
    <message>
        <source>a web page can hold 1 to %1 buttons, but %2 were given</source>
        <translation>eine Webseite kann 1 bis %1 Taster enthalten, angegeben sind aber %2</translation>
    </message>
    <message>
        <source>a web page is for 1 to %1 participants, but %2 were given</source>
        <translation>eine Webseite ist für 1 bis %1 Versuchspersonen, angegeben sind aber %2</translation>
    </message>
    <message>
        <source>the participant %1 is named twice, or the id is too similar to another one</source>
        <translation>die Versuchsperson %1 ist zweimal genannt, oder die Kennung ist einer anderen zu ähnlich</translation>
    </message>
    <message>
        <source>there are %1 names for %2 studies</source>
        <translation>es gibt %1 Namen für %2 Studien</translation>
    </message>
    <message>
        <source>Restore the folder from a copy</source>
        <translation>Stellen Sie den Ordner aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>in falcon:N, N is the number of the Falcon, starting with 0</source>
        <translation>in falcon:N ist N die Nummer des Falcon, beginnend mit 0</translation>
    </message>
    <message>
        <source>Keep only the strongest bands</source>
        <translation>Behalten Sie nur die stärksten Bänder</translation>
    </message>
    <message>
        <source>Give the friction and the damping of the device, or choose another device</source>
        <translation>Geben Sie Reibung und Dämpfung des Geräts an, oder wählen Sie ein anderes</translation>
    </message>
    <message>
        <source>Give a list of 1 to %1 times that all differ</source>
        <translation>Geben Sie eine Liste von 1 bis %1 verschiedenen Zeiten an</translation>
    </message>
    <message>
        <source>Give a list of 1 to %1 times that are all shorter than the shortest interval</source>
        <translation>Geben Sie eine Liste von 1 bis %1 Zeiten an, die alle kürzer als das kürzeste Intervall sind</translation>
    </message>
    <message>
        <source>how strong it is</source>
        <translation>wie stark er ist</translation>
    </message>
    <message>
        <source>when the click comes</source>
        <translation>wann der Klick kommt</translation>
    </message>
    <message>
        <source>how hard one has to press</source>
        <translation>wie fest man drücken muss</translation>
    </message>
    <message>
        <source>how far it seems to give way</source>
        <translation>wie weit er nachzugeben scheint</translation>
    </message>
    <message>
        <source>told apart: %1</source>
        <translation>unterschieden: %1</translation>
    </message>
    <message>
        <source>not told apart: %1</source>
        <translation>nicht unterschieden: %1</translation>
    </message>
    <message>
        <source>probably told apart: %1</source>
        <translation>wahrscheinlich unterschieden: %1</translation>
    </message>
    <message>
        <source>probably not told apart: %1</source>
        <translation>wahrscheinlich nicht unterschieden: %1</translation>
    </message>
    <message>
        <source>the file has versions of the button &quot;%1&quot; with more of the varied quantity, but this button is not in the study</source>
        <translation>die Datei hat Fassungen des Tasters „%1“ mit mehr von der veränderten Größe, aber dieser Taster ist nicht in der Studie</translation>
    </message>
    <message>
        <source>the file has fewer than two versions of the button &quot;%1&quot; with more of the varied quantity</source>
        <translation>die Datei hat weniger als zwei Fassungen des Tasters „%1“ mit mehr von der veränderten Größe</translation>
    </message>
    <message>
        <source>Choose another quantity, or a button that has less of the present quantity</source>
        <translation>Wählen Sie eine andere Größe oder einen Taster, der weniger von der jetzigen hat</translation>
    </message>
    <message>
        <source>This computer is too slow: a message to itself takes %1 ms. Close other programs and allow real-time scheduling (docs/guide/force-feedback.md)</source>
        <translation>Dieser Rechner reagiert zu langsam: Eine Nachricht an sich selbst dauert %1 ms. Andere Programme schließen und Echtzeit-Scheduling erlauben (docs/guide/force-feedback.md)</translation>
    </message>
    <message>
        <source>%1 cannot hold this press: its strongest sample is only %2 of full scale, so nothing would be felt</source>
        <translation>%1 kann diese Betätigung nicht fassen: Der stärkste Wert ist nur %2 der Vollaussteuerung, es wäre also nichts zu fühlen</translation>
    </message>
    <message>
        <source>Press deeper, raise the gain of the device profile, or choose the Detent package, which holds any press</source>
        <translation>Drücken Sie tiefer, erhöhen Sie die Verstärkung des Geräteprofils, oder wählen Sie das Detent-Paket, das jede Betätigung fasst</translation>
    </message>
    <message>
        <source>this press produces no vibration: %1 of its %2 readings are out of range, out of order or not numbers</source>
        <translation>diese Betätigung erzeugt keine Vibration: %1 ihrer %2 Messwerte sind außerhalb des Bereichs, nicht in der Reihenfolge oder keine Zahlen</translation>
    </message>
    <message>
        <source>Press harder or deeper, or give the button a tactile point</source>
        <translation>Drücken Sie stärker oder tiefer, oder geben Sie dem Taster einen Druckpunkt</translation>
    </message>
    <message>
        <source>a time, the force or the sensor rate is out of range</source>
        <translation>eine Zeit, die Kraft oder die Sensorrate liegt außerhalb ihres Bereichs</translation>
    </message>
    <message>
        <source>in a tapping study, PLACE of timing=PLACE,SPREAD is the time between presses in seconds, and this one is too short</source>
        <translation>in einer Studie des Tippens ist PLACE in timing=PLACE,SPREAD die Zeit zwischen den Tastendrücken in Sekunden, und diese ist zu kurz</translation>
    </message>
    <message>
        <source>this program does not know the plan&apos;s rule for participants who did not finish</source>
        <translation>dieses Programm kennt die Regel des Plans für Versuchspersonen nicht, die nicht fertig wurden</translation>
    </message>
    <message>
        <source>the file does not hold counted answers, version %1</source>
        <translation>die Datei enthält keine ausgezählten Antworten, Version %1</translation>
    </message>
    <message>
        <source>Choose the folder of a study that “New study” or `detent-play study new` made</source>
        <translation>Wählen Sie den Ordner einer Studie, die „Neue Studie“ oder „detent-play study new“ angelegt hat</translation>
    </message>
    <message>
        <source>can hold %1 N/mm by its measured profile; this button needs %2 N/mm</source>
        <translation>kann nach seinem gemessenen Profil %1 N/mm halten; dieser Taster braucht %2 N/mm</translation>
    </message>
    <message>
        <source>Choose its firmware file (docs/guide/force-feedback.md)</source>
        <translation>Wählen Sie seine Firmware-Datei (docs/guide/force-feedback.md)</translation>
    </message>
    <message>
        <source>On the command line: --firmware FILE</source>
        <translation>Auf der Befehlszeile: --firmware DATEI</translation>
    </message>
    <message>
        <source>Leave the upload out; this computer then computes the force. Or upload a button that has a single speed (detent-graph convert makes one)</source>
        <translation>Lassen Sie die Übertragung weg; dann berechnet dieser Rechner die Kraft. Oder übertragen Sie einen Taster mit einer einzigen Geschwindigkeit (detent-graph convert erzeugt ihn)</translation>
    </message>
    <message>
        <source>The device is too slow. Make the connection faster: native USB, a higher baud rate, an FTDI latency timer of 1 ms. Or let the device compute the force</source>
        <translation>Das Gerät reagiert zu langsam. Beschleunigen Sie die Verbindung: natives USB, höhere Baudrate, FTDI-Latenz von 1 ms. Oder lassen Sie das Gerät die Kraft berechnen</translation>
    </message>
    <message>
        <source>On the command line: --baud, --upload</source>
        <translation>Auf der Befehlszeile: --baud, --upload</translation>
    </message>
    <message>
        <source>With more damping of the handle, a faster loop or a shorter delay, the button would be stable</source>
        <translation>Mit mehr Dämpfung des Griffs, einer schnelleren Schleife oder einer kürzeren Verzögerung wäre der Taster stabil</translation>
    </message>
    <message>
        <source>Set this encoder step and start again</source>
        <translation>Stellen Sie diesen Encoderschritt ein, und starten Sie neu</translation>
    </message>
    <message>
        <source>On the command line: --step-mm %1</source>
        <translation>Auf der Befehlszeile: --step-mm %1</translation>
    </message>
    <message>
        <source>Make a study without a device profile, or run this one with detent-play study run or in detent-edit</source>
        <translation>Machen Sie eine Studie ohne Geräteprofil, oder führen Sie diese mit detent-play study run oder in detent-edit durch</translation>
    </message>
    <message>
        <source>the content is broken</source>
        <translation>der Inhalt ist beschädigt</translation>
    </message>
</context>
<context>
    <name>detent::playback::AudioCapture::Recorder</name>
    <message>
        <source>the sound system or the sound device cannot be started</source>
        <translation>das Tonsystem oder das Audiogerät kann nicht gestartet werden</translation>
    </message>
    <message>
        <source>the sound device cannot be used for recording</source>
        <translation>das Audiogerät kann nicht zum Aufnehmen verwendet werden</translation>
    </message>
</context>
<context>
    <name>detent::playback::AudioOutput::Stream</name>
    <message>
        <source>the sound system or the sound device cannot be started</source>
        <translation>das Tonsystem oder das Audiogerät kann nicht gestartet werden</translation>
    </message>
    <message>
        <source>the sound device has only one output, so participants would feel the masking noise</source>
        <translation>das Audiogerät hat nur einen Ausgang, deshalb würden Versuchspersonen das Maskierrauschen fühlen</translation>
    </message>
    <message>
        <source>the sound device cannot be opened at %1 Hz</source>
        <translation>das Audiogerät kann bei %1 Hz nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Choose the sound device of the headphones for the masking noise</source>
        <translation>Wählen Sie das Audiogerät der Kopfhörer für das Maskierrauschen</translation>
    </message>
    <message>
        <source>On the command line: --noise-device</source>
        <translation>Auf der Befehlszeile: --noise-device</translation>
    </message>
</context>
<context>
    <name>detent::playback::FalconUsb</name>
    <message>
        <source>the Falcon is not connected</source>
        <translation>der Falcon ist nicht angeschlossen</translation>
    </message>
    <message>
        <source>Check its cable and its power supply, or try the simulated Falcon</source>
        <translation>Prüfen Sie Kabel und Netzteil, oder versuchen Sie den simulierten Falcon</translation>
    </message>
    <message>
        <source>On the command line: --device sim:falcon</source>
        <translation>Auf der Befehlszeile: --device sim:falcon</translation>
    </message>
</context>
<context>
    <name>detent::playback::HapticPreparation</name>
    <message>
        <source>with the levels of the published method, the click at %2 cannot be felt, because the slope or the bottom-out is more than %1 dB stronger. Use --feel clear to keep the click</source>
        <translation>mit den Pegeln der Veröffentlichung ist der Klick bei %2 nicht zu fühlen, weil Steigung oder Anschlag um mehr als %1 dB stärker ist. Mit --feel clear bleibt der Klick fühlbar</translation>
    </message>
</context>
<context>
    <name>detent::playback::JackStream</name>
    <message>
        <source>the JACK server does not answer</source>
        <translation>der JACK-Server antwortet nicht</translation>
    </message>
    <message>
        <source>Close another JACK program</source>
        <translation>Schließen Sie ein anderes JACK-Programm</translation>
    </message>
    <message>
        <source>Start the JACK server (jackd)</source>
        <translation>Starten Sie den JACK-Server (jackd)</translation>
    </message>
    <message>
        <source>the JACK server runs at another sample rate</source>
        <translation>der JACK-Server läuft mit einer anderen Abtastrate</translation>
    </message>
    <message>
        <source>the JACK server runs at a sample rate outside 8000 to 192000 Hz</source>
        <translation>der JACK-Server läuft mit einer Abtastrate außerhalb 8000 bis 192000 Hz</translation>
    </message>
    <message>
        <source>Restart the JACK server at another sample rate</source>
        <translation>Starten Sie den JACK-Server mit einer anderen Abtastrate neu</translation>
    </message>
    <message>
        <source>the JACK server has no free ports</source>
        <translation>der JACK-Server hat keine freien Anschlüsse</translation>
    </message>
    <message>
        <source>the connection to the JACK server does not start</source>
        <translation>die Verbindung zum JACK-Server startet nicht</translation>
    </message>
    <message>
        <source>Restart the JACK server (jackd)</source>
        <translation>Starten Sie den JACK-Server (jackd) neu</translation>
    </message>
    <message>
        <source>this JACK device has no inputs to connect to</source>
        <translation>dieses JACK-Gerät hat keine Eingänge zum Verbinden</translation>
    </message>
    <message>
        <source>Choose another sound device; `detent-play devices` and the Feel panel (Setup) list them</source>
        <translation>Wählen Sie ein anderes Audiogerät; „detent-play devices“ und der Bereich „Fühlen“ (Einrichtung) zeigen die Liste</translation>
    </message>
    <message>
        <source>this build of Detent has no JACK output</source>
        <translation>dieses Detent ist ohne Ausgabe über JACK gebaut</translation>
    </message>
    <message>
        <source>Choose a sound device without &quot;JACK:&quot;, or install a build of Detent with JACK</source>
        <translation>Wählen Sie ein Audiogerät ohne „JACK:“, oder installieren Sie ein Detent mit JACK</translation>
    </message>
    <message>
        <source>Choose the rate of the device</source>
        <translation>Wählen Sie die Rate des Geräts</translation>
    </message>
    <message>
        <source>On the command line, leave --device-rate out</source>
        <translation>Lassen Sie auf der Befehlszeile --device-rate weg</translation>
    </message>
</context>
<context>
    <name>detent::playback::JsonPlace</name>
    <message>
        <source>Correct the value</source>
        <translation>Berichtigen Sie den Wert</translation>
    </message>
    <message>
        <source>Give a number from %1 to %2</source>
        <translation>Geben Sie eine Zahl von %1 bis %2 an</translation>
    </message>
    <message>
        <source>the field %1 is missing</source>
        <translation>das Feld %1 fehlt</translation>
    </message>
    <message>
        <source>the value is not a list</source>
        <translation>der Wert ist keine Liste</translation>
    </message>
    <message>
        <source>the value is not a number</source>
        <translation>der Wert ist keine Zahl</translation>
    </message>
    <message>
        <source>the value is %1</source>
        <translation>der Wert ist %1</translation>
    </message>
    <message>
        <source>the value is not text</source>
        <translation>der Wert ist kein Text</translation>
    </message>
</context>
<context>
    <name>detent::playback::LineJournal</name>
    <message>
        <source>End that session first, or give another participant&apos;s id</source>
        <translation>Beenden Sie zuerst jene Sitzung oder geben Sie eine andere Kennung an</translation>
    </message>
    <message>
        <source>the journal cannot be opened</source>
        <translation>das Journal kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>the journal cannot be locked</source>
        <translation>das Journal kann nicht gesperrt werden</translation>
    </message>
    <message>
        <source>another program is writing this journal</source>
        <translation>ein anderes Programm schreibt gerade dieses Journal</translation>
    </message>
    <message>
        <source>the journal cannot be read</source>
        <translation>das Journal kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the journal cannot be shortened to its last complete line</source>
        <translation>das Journal lässt sich nicht auf seine letzte ganze Zeile kürzen</translation>
    </message>
    <message>
        <source>a line could not be added to the journal</source>
        <translation>dem Journal ließ sich keine Zeile hinzufügen</translation>
    </message>
</context>
<context>
    <name>detent::playback::LivePlayer</name>
    <message>
        <source>Choose another rate</source>
        <translation>Wählen Sie eine andere Rate</translation>
    </message>
    <message>
        <source>the sample rate %1 Hz lies outside 8000 to 192000 Hz</source>
        <translation>die Abtastrate %1 Hz liegt außerhalb 8000 bis 192000 Hz</translation>
    </message>
</context>
<context>
    <name>detent::playback::MagneticSensor</name>
    <message>
        <source>Measure readings at several places of the travel</source>
        <translation>An mehreren Stellen des Wegs messen</translation>
    </message>
    <message>
        <source>Remove or correct the value</source>
        <translation>Entfernen oder berichtigen Sie den Wert</translation>
    </message>
    <message>
        <source>Sort the pairs by displacement</source>
        <translation>Die Paare nach dem Weg ordnen</translation>
    </message>
    <message>
        <source>Leave out the part of the travel where the reading of the sensor stays the same or turns back</source>
        <translation>Lassen Sie den Teil des Wegs weg, in dem der Messwert des Sensors gleich bleibt oder umkehrt</translation>
    </message>
    <message>
        <source>Give a CSV with the header displacement_mm,reading</source>
        <translation>Eine CSV mit der Kopfzeile displacement_mm,reading angeben</translation>
    </message>
    <message>
        <source>Give the standard deviation of the readings at rest</source>
        <translation>Die Standardabweichung der Messwerte in Ruhe angeben</translation>
    </message>
    <message>
        <source>the noise must lie between 0 and 1000000 counts</source>
        <translation>das Rauschen muss zwischen 0 und 1000000 Schritten des Wandlers liegen</translation>
    </message>
    <message>
        <source>the file has fewer than two pairs of displacement and reading</source>
        <translation>die Datei hat weniger als zwei Paare aus Weg und Messwert</translation>
    </message>
    <message>
        <source>one of the two values is not a usable number</source>
        <translation>einer der beiden Werte ist keine brauchbare Zahl</translation>
    </message>
    <message>
        <source>this pair is not deeper than the previous one</source>
        <translation>dieses Paar liegt nicht tiefer als das vorige</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the file has no columns displacement_mm and reading</source>
        <translation>die Datei hat keine Spalten displacement_mm und reading</translation>
    </message>
    <message>
        <source>this line does not hold two usable numbers</source>
        <translation>diese Zeile enthält keine zwei brauchbaren Zahlen</translation>
    </message>
    <message>
        <source>readings must all rise or all fall, but this one stays the same or turns back</source>
        <translation>die Messwerte müssen alle steigen oder alle fallen, aber dieser bleibt gleich oder kehrt um</translation>
    </message>
    <message>
        <source>pair %1</source>
        <translation>Paar %1</translation>
    </message>
</context>
<context>
    <name>detent::playback::OdriveForceDevice</name>
    <message>
        <source>the axis or the travel per turn is not valid</source>
        <translation>die Achse oder der Weg je Umdrehung ist ungültig</translation>
    </message>
    <message>
        <source>Give axis 0 or 1 and a travel that is not 0</source>
        <translation>Geben Sie Achse 0 oder 1 an und einen Weg, der nicht 0 ist</translation>
    </message>
    <message>
        <source>no ODrive answers on axis %1</source>
        <translation>auf Achse %1 antwortet kein ODrive</translation>
    </message>
    <message>
        <source>the answer on axis %1 is not that of an ODrive: &quot;%2&quot;</source>
        <translation>die Antwort auf Achse %1 kommt nicht von einem ODrive: „%2“</translation>
    </message>
    <message>
        <source>Check power, cable and axis, and that the ASCII protocol is on (docs/guide/force-feedback.md)</source>
        <translation>Prüfen Sie Strom, Kabel und Achse und ob das ASCII-Protokoll eingeschaltet ist (docs/guide/force-feedback.md)</translation>
    </message>
    <message>
        <source>axis %1 cannot be switched on: %2</source>
        <translation>Achse %1 lässt sich nicht einschalten: %2</translation>
    </message>
    <message>
        <source>Correct this with odrivetool (dump_errors), until closed-loop control runs</source>
        <translation>Beheben Sie das mit odrivetool (dump_errors), bis die Regelung läuft</translation>
    </message>
    <message>
        <source>axis %1 does not keep the setting %2</source>
        <translation>Achse %1 behält die Einstellung %2 nicht</translation>
    </message>
    <message>
        <source>Make this setting with odrivetool, then try again</source>
        <translation>Nehmen Sie diese Einstellung mit odrivetool vor, und versuchen Sie es noch einmal</translation>
    </message>
</context>
<context>
    <name>detent::playback::ParticipantSession</name>
    <message>
        <source>trial %1</source>
        <translation>Durchgang %1</translation>
    </message>
    <message>
        <source>Answer the trial that is shown</source>
        <translation>Beantworten Sie den Durchgang, der gezeigt wird</translation>
    </message>
    <message>
        <source>Give a number above 0, at most a million</source>
        <translation>Geben Sie eine Zahl über 0 an, höchstens eine Million</translation>
    </message>
    <message>
        <source>Give 1, 2, 3, 4, 5, 6 or 7</source>
        <translation>Geben Sie 1, 2, 3, 4, 5, 6 oder 7 an</translation>
    </message>
    <message>
        <source>Press at the cue; in tapping, press at least twice</source>
        <translation>Drücken Sie beim Zeichen; beim Tippen drücken Sie mindestens zweimal</translation>
    </message>
    <message>
        <source>Press X and the button that it is compared with to the end, then answer</source>
        <translation>Drücken Sie X und den Taster, mit dem X verglichen wird, bis zum Ende, und antworten Sie dann</translation>
    </message>
    <message>
        <source>this is not the current trial</source>
        <translation>dies ist nicht der laufende Durchgang</translation>
    </message>
    <message>
        <source>the answer does not lie on the scale</source>
        <translation>die Antwort liegt nicht auf der Skala</translation>
    </message>
    <message>
        <source>the answer contains no number</source>
        <translation>die Antwort enthält keine Zahl</translation>
    </message>
    <message>
        <source>no press fell within the time that counts</source>
        <translation>kein Tastendruck fiel in die Zeit, die zählt</translation>
    </message>
    <message>
        <source>the answer is about a button that was not felt</source>
        <translation>die Antwort betrifft einen Taster, der nicht gefühlt wurde</translation>
    </message>
</context>
<context>
    <name>detent::playback::Player</name>
    <message>
        <source>Start the player with a sound device</source>
        <translation>Starten Sie die Wiedergabe mit einem Audiogerät</translation>
    </message>
    <message>
        <source>Give at least one reading</source>
        <translation>Geben Sie mindestens einen Messwert an</translation>
    </message>
    <message>
        <source>Wait until one of the requests has begun</source>
        <translation>Warten Sie, bis eine der Anforderungen begonnen hat</translation>
    </message>
    <message>
        <source>Choose another rate</source>
        <translation>Wählen Sie eine andere Rate</translation>
    </message>
    <message>
        <source>Give samples within -1 and 1</source>
        <translation>Geben Sie Werte zwischen -1 und 1 an</translation>
    </message>
    <message>
        <source>nothing can be played without a sound device</source>
        <translation>ohne Audiogerät lässt sich nichts wiedergeben</translation>
    </message>
    <message>
        <source>the press trace contains no readings</source>
        <translation>der Druckverlauf enthält keine Messwerte</translation>
    </message>
    <message>
        <source>there are no samples</source>
        <translation>es gibt keine Messwerte</translation>
    </message>
    <message>
        <source>the samples have a rate outside 8000 to 192000 Hz</source>
        <translation>die Abtastwerte haben eine Rate außerhalb 8000 bis 192000 Hz</translation>
    </message>
    <message>
        <source>the samples exceed full scale</source>
        <translation>die Abtastwerte überschreiten die Vollaussteuerung</translation>
    </message>
    <message>
        <source>this sound device also plays the vibration, so participants would feel the masking noise</source>
        <translation>dieses Audiogerät spielt auch die Vibration, deshalb würden Versuchspersonen das Maskierrauschen fühlen</translation>
    </message>
    <message>
        <source>too many requests to play samples came at the same time</source>
        <translation>zu viele Aufträge zum Abspielen von Samples, kamen gleichzeitig</translation>
    </message>
    <message>
        <source>Choose the sound device of the headphones for the masking noise</source>
        <translation>Wählen Sie das Audiogerät der Kopfhörer für das Maskierrauschen</translation>
    </message>
    <message>
        <source>On the command line: --noise-device</source>
        <translation>Auf der Befehlszeile: --noise-device</translation>
    </message>
</context>
<context>
    <name>detent::playback::Reader</name>
    <message>
        <source>this entry is given twice</source>
        <translation>dieser Eintrag kommt zweimal vor</translation>
    </message>
    <message>
        <source>the value holds something that is not a number</source>
        <translation>der Wert enthält etwas, das keine Zahl ist</translation>
    </message>
    <message>
        <source>the value must be above 0</source>
        <translation>der Wert muss über 0 liegen</translation>
    </message>
    <message>
        <source>this entry needs 1 to 4 numbers</source>
        <translation>dieser Eintrag braucht 1 bis 4 Zahlen</translation>
    </message>
    <message>
        <source>this entry can have at most 4 numbers</source>
        <translation>dieser Eintrag kann höchstens 4 Zahlen haben</translation>
    </message>
    <message>
        <source>this entry is not known</source>
        <translation>dieser Eintrag ist nicht bekannt</translation>
    </message>
    <message>
        <source>the value must be &quot;newtons&quot;, &quot;linear&quot; or &quot;divider&quot;</source>
        <translation>der Wert muss „newtons“, „linear“ oder „divider“ sein</translation>
    </message>
</context>
<context>
    <name>detent::playback::Reader::Action</name>
    <message>
        <source>this entry needs %1 numbers, but has %2</source>
        <translation>dieser Eintrag braucht %1 Zahlen, hat aber %2</translation>
    </message>
</context>
<context>
    <name>detent::playback::Replay</name>
    <message>
        <source>Restore the journal from a copy; while it is damaged, its answers are not used</source>
        <translation>Stellen Sie das Journal aus einer Kopie wieder her; solange es beschädigt ist, werden seine Antworten nicht verwendet</translation>
    </message>
    <message>
        <source>Use the program that wrote the journal</source>
        <translation>Benutzen Sie das Programm, das das Journal geschrieben hat</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>Move this file out of the study</source>
        <translation>Nehmen Sie diese Datei aus der Studie</translation>
    </message>
    <message>
        <source>Give the file its original name again</source>
        <translation>Geben Sie der Datei wieder ihren ursprünglichen Namen</translation>
    </message>
    <message>
        <source>Restore study.json, or move the journal to its own study</source>
        <translation>Stellen Sie study.json wieder her oder legen Sie das Journal zu seiner Studie</translation>
    </message>
    <message>
        <source>Restore the journal</source>
        <translation>Stellen Sie das Journal wieder her</translation>
    </message>
    <message>
        <source>this line or an earlier one was changed by hand</source>
        <translation>diese Zeile oder eine frühere wurde von Hand geändert</translation>
    </message>
    <message>
        <source>this line holds an event &quot;%1&quot; that this program does not know</source>
        <translation>diese Zeile enthält ein Ereignis „%1“, das dieses Programm nicht kennt</translation>
    </message>
    <message>
        <source>the file is not a journal of a study</source>
        <translation>die Datei ist kein Journal einer Studie</translation>
    </message>
    <message>
        <source>the journal has version %1, which this program cannot read</source>
        <translation>das Journal hat Version %1, die dieses Programm nicht lesen kann</translation>
    </message>
    <message>
        <source>this is the journal of %1</source>
        <translation>dies ist das Journal von %1</translation>
    </message>
    <message>
        <source>this line is an answer outside a session</source>
        <translation>diese Zeile ist eine Antwort außerhalb einer Sitzung</translation>
    </message>
    <message>
        <source>this line answers trial %1 out of order</source>
        <translation>diese Zeile beantwortet Durchgang %1 außer der Reihe</translation>
    </message>
    <message>
        <source>this answer does not fit the list of trials</source>
        <translation>diese Antwort passt nicht zur Liste der Durchgänge</translation>
    </message>
    <message>
        <source>this line is an answer about a button that was not felt</source>
        <translation>diese Zeile ist eine Antwort über einen Taster, der nicht gefühlt wurde</translation>
    </message>
    <message>
        <source>the journal belongs to another study, or study.json was changed later</source>
        <translation>das Journal gehört zu einer anderen Studie, oder study.json wurde später geändert</translation>
    </message>
    <message>
        <source>this line has a kind of session that this program does not know: %1, %2</source>
        <translation>diese Zeile hat eine Art von Sitzung, die dieses Programm nicht kennt: %1, %2</translation>
    </message>
</context>
<context>
    <name>detent::playback::SerialForceDevice</name>
    <message>
        <source>Check that the firmware follows docs/reference/force-protocol.md and that the baud rate is the same</source>
        <translation>Prüfen Sie, ob die Firmware docs/reference/force-protocol.md befolgt und die Baudrate dieselbe ist</translation>
    </message>
    <message>
        <source>Prepare the button for the limit of the device</source>
        <translation>Bereiten Sie den Taster für die Grenze des Geräts vor</translation>
    </message>
    <message>
        <source>the device can produce only %1, less than the playback was prepared for</source>
        <translation>das Gerät bringt nur %1 auf, weniger als die Wiedergabe voraussetzt</translation>
    </message>
    <message>
        <source>the device does not confirm the limits that it was given, so nothing would limit its force if this program failed</source>
        <translation>das Gerät bestätigt die übertragenen Grenzen nicht, deshalb würde nichts seine Kraft begrenzen, wenn dieses Programm ausfiele</translation>
    </message>
    <message>
        <source>the device gives an answer that is not part of the protocol</source>
        <translation>das Gerät gibt eine Antwort, die nicht zum Protokoll gehört</translation>
    </message>
    <message>
        <source>the device answers &quot;%1&quot;, which is not part of the protocol</source>
        <translation>das Gerät antwortet „%1“, das gehört nicht zum Protokoll</translation>
    </message>
    <message>
        <source>the device uses an older protocol without its own force limit: install samples/firmware/force1d again</source>
        <translation>das Gerät verwendet ein älteres Protokoll ohne eigene Kraftgrenze: Installieren Sie samples/firmware/force1d neu</translation>
    </message>
    <message>
        <source>the device does not accept the force table</source>
        <translation>das Gerät nimmt die Krafttabelle nicht an</translation>
    </message>
    <message>
        <source>the device cannot hold a force table</source>
        <translation>das Gerät fasst keine Krafttabelle</translation>
    </message>
    <message>
        <source>Switch the upload of the force table off, so that this computer computes the force</source>
        <translation>Schalten Sie die Übertragung der Krafttabelle aus, damit dieser Rechner die Kraft berechnet</translation>
    </message>
    <message>
        <source>the device was opened with a limit of %1, but the table has %2 or no limit</source>
        <translation>das Gerät wurde mit einer Grenze von %1 geöffnet, die Tabelle hat aber %2 oder keine Grenze</translation>
    </message>
    <message>
        <source>Check the firmware and the cable, or switch the upload off: this computer computes the force then</source>
        <translation>Prüfen Sie Firmware und Kabel, oder schalten Sie das Übertragen aus: Dann berechnet dieser Rechner die Kraft</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>antwortet nicht</translation>
    </message>
    <message>
        <source>Set this as the largest force and start again</source>
        <translation>Stellen Sie diese Kraft als größte ein, und starten Sie neu</translation>
    </message>
    <message>
        <source>On the command line: --max-N %1</source>
        <translation>Auf der Befehlszeile: --max-N %1</translation>
    </message>
</context>
<context>
    <name>detent::playback::SerialLink</name>
    <message>
        <source>Check the name, the cable and your permission to use the port (group dialout)</source>
        <translation>Prüfen Sie den Namen, das Kabel und Ihre Berechtigung für den Anschluss (Gruppe dialout)</translation>
    </message>
    <message>
        <source>End that program, then try again</source>
        <translation>Dieses Programm beenden, dann noch einmal versuchen</translation>
    </message>
    <message>
        <source>Give a rate from %1 to %2</source>
        <translation>Geben Sie eine Rate von %1 bis %2 an</translation>
    </message>
    <message>
        <source>Unplug one of them, or give a name under /dev/serial/by-path</source>
        <translation>Eines davon abstecken oder einen Namen unter /dev/serial/by-path angeben</translation>
    </message>
    <message>
        <source>a speed of %1 baud is not supported</source>
        <translation>eine Geschwindigkeit von %1 Baud wird nicht unterstützt</translation>
    </message>
    <message>
        <source>two devices have this name, because their serial numbers are the same; the other one is %1</source>
        <translation>zwei Geräte haben diesen Namen, weil ihre Seriennummern gleich sind; das andere ist %1</translation>
    </message>
    <message>
        <source>the device is in use by another program</source>
        <translation>ein anderes Programm benutzt das Gerät</translation>
    </message>
    <message>
        <source>the device is in use by %1</source>
        <translation>%1 benutzt das Gerät</translation>
    </message>
    <message>
        <source>the port cannot run at %1 baud</source>
        <translation>die Schnittstelle läuft nicht mit %1 Baud</translation>
    </message>
    <message>
        <source>the device cannot be opened (%1)</source>
        <translation>das Gerät kann nicht geöffnet werden (%1)</translation>
    </message>
    <message>
        <source>Choose another baud rate, and set it in the firmware too</source>
        <translation>Wählen Sie eine andere Baudrate, und stellen Sie sie auch in der Firmware ein</translation>
    </message>
    <message>
        <source>On the command line: --baud</source>
        <translation>Auf der Befehlszeile: --baud</translation>
    </message>
</context>
<context>
    <name>detent::playback::SignalSender</name>
    <message>
        <source>Check host and port</source>
        <translation>Prüfen Sie Rechner und Anschluss</translation>
    </message>
    <message>
        <source>the receiver cannot be reached (%1)</source>
        <translation>der Empfänger ist nicht erreichbar (%1)</translation>
    </message>
</context>
<context>
    <name>detent::playback::StudyPlayer</name>
    <message>
        <source>Check the sensor, its cable and the speed of the port</source>
        <translation>Prüfen Sie den Sensor, sein Kabel und die Geschwindigkeit des Anschlusses</translation>
    </message>
    <message>
        <source>the force sensor sends no readings</source>
        <translation>der Kraftsensor sendet keine Messwerte</translation>
    </message>
</context>
<context>
    <name>detent::playback::Summary</name>
    <message>
        <source>FLAC cannot store floating-point samples</source>
        <translation>FLAC kann keine Gleitkommawerte speichern</translation>
    </message>
    <message>
        <source>Give --bits 16 or 24, or a .wav file</source>
        <translation>Geben Sie --bits 16 oder 24 an, oder eine .wav-Datei</translation>
    </message>
    <message>
        <source>Give a file that ends in .wav or .flac</source>
        <translation>Geben Sie eine Datei an, die auf .wav oder .flac endet</translation>
    </message>
    <message>
        <source>the file name ends in neither .wav nor .flac</source>
        <translation>der Dateiname endet weder auf .wav noch auf .flac</translation>
    </message>
</context>
<context>
    <name>std</name>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>no press is named</source>
        <translation>keine Betätigung ist angegeben</translation>
    </message>
    <message>
        <source>%1 is not a press</source>
        <translation>%1 ist keine Betätigung</translation>
    </message>
    <message>
        <source>Give standard, human:120ms with 10 ms to 10 s, or a CSV of time_s,force_N or time_s,displacement_mm</source>
        <translation>Geben Sie standard, human:120ms mit 10 ms bis 10 s oder eine CSV mit time_s,force_N oder time_s,displacement_mm an</translation>
    </message>
    <message>
        <source>A press trace has the header time_s,force_N or time_s,displacement_mm and two numbers per line</source>
        <translation>Ein Betätigungsverlauf hat den Kopf time_s,force_N oder time_s,displacement_mm und zwei Zahlen je Zeile</translation>
    </message>
    <message>
        <source>the text is empty</source>
        <translation>der Text ist leer</translation>
    </message>
</context>
</TS>
