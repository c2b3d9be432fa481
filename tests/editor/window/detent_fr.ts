<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR">
<context>
    <name>detent::editor::MainWindow</name>
    <message>
        <source>Save this button</source>
        <translation>Enregistrer ce bouton</translation>
    </message>
</context>
<context>
    <name>detent::editor</name>
    <message>
        <source>Scale force</source>
        <translation>Changer la force</translation>
    </message>
</context>
</TS>
