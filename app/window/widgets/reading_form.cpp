#include "app/window/widgets/reading_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

#include "app/window/widgets/length_field.h"
#include "app/window/widgets/mesh_fields.h"
#include "app/window/widgets/number_fields.h"

namespace noonmark {

namespace {

constexpr int asInFile = -1;  // item data for "as in the file"

QLineEdit* textField(const QString& whenEmpty) {
    auto* field = new QLineEdit;
    field->setPlaceholderText(whenEmpty);
    return field;
}

std::string textIn(const QLineEdit& field) { return field.text().trimmed().toStdString(); }

void showText(QLineEdit& field, const std::string& text) { field.setText(QString::fromStdString(text)); }

}  // namespace

ReadingForm::ReadingForm(QWidget* parent) : QWidget(parent) {
    makeFields();
    tell();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    for (QGroupBox* group : {makeHeights(), makeData(), makeMeshes()}) column->addWidget(group);
    setMiddle({});
    show(ReadSettings{});
}

void ReadingForm::makeFields() {
    heightField_ = textField(tr("found by name"));
    levelsField_ = textField(tr("found by name"));
    heightUnit_ = new QComboBox;
    heightUnit_->addItem(tr("as in the file"), asInFile);
    addUnits(*heightUnit_);
    metresPerLevel_ = lengthField(2, 6, 2, 0.1);
    defaultHeight_ = lengthField(1, 1000, 2, 1);
    layer_ = textField(tr("all layers with polygons"));
    crs_ = textField(tr("as in the file (example: EPSG:2263)"));
    lod_ = textField(tr("the highest"));
    farAway_ = lengthField(100, 200000, 0, 1000);
    terrainFromBases_ = new QComboBox;
    terrainFromBases_->addItem(tr("if neighbours' ground heights differ"), int(TerrainFromBases::automatic));
    terrainFromBases_->addItem(tr("always"), int(TerrainFromBases::always));
    terrainFromBases_->addItem(tr("never (flat ground)"), int(TerrainFromBases::never));
    stand_ = new QComboBox;
    stand_->addItem(tr("as their bases fit the terrain"), int(Stand::automatic));
    stand_->addItem(tr("each set down on the terrain"), int(Stand::terrain));
    stand_->addItem(tr("at the elevations in the file"), int(Stand::absolute));
    terrainShows_ = new QComboBox;
    terrainShows_->addItem(tr("found by its steps at outlines"), int(TerrainShows::automatic));
    terrainShows_->addItem(tr("the bare ground"), int(TerrainShows::ground));
    terrainShows_->addItem(tr("a surface with buildings"), int(TerrainShows::surface));
    heightsFromSurface_ = new QCheckBox(tr("Missing heights from the surface model"));
    upAxis_ = upAxisField();
    meshUnit_ = meshUnitField();
    meshNorth_ = numberField(-360, 360, 4, 1, tr("°"));
    anchored_ = new QCheckBox(tr("Origin located at"));
    longitude_ = numberField(-180, 180, 7, 0.001, tr("° east"));
    latitude_ = numberField(-90, 90, 7, 0.001, tr("° north"));
    toMiddle_ = new QPushButton(tr("Middle of the open city"));
    toMiddle_->setAutoDefault(false);  // Enter must trigger Open
}

QGroupBox* ReadingForm::makeHeights() {
    auto* group = new QGroupBox(tr("Heights"));
    auto* form = new QFormLayout(group);
    form->addRow(tr("Height field"), heightField_);
    form->addRow(tr("Storeys field"), levelsField_);
    form->addRow(tr("Unit of heights"), heightUnit_);
    form->addRow(tr("Height of a storey"), metresPerLevel_);
    form->addRow(tr("Default height"), defaultHeight_);
    return group;
}

QGroupBox* ReadingForm::makeData() {
    auto* group = new QGroupBox(tr("Place and choice of data"));
    auto* form = new QFormLayout(group);
    form->addRow(tr("Coordinate system"), crs_);
    form->addRow(tr("Layer"), layer_);
    form->addRow(tr("Level of detail"), lod_);
    form->addRow(tr("Maximum distance"), farAway_);
    form->addRow(tr("Terrain from building bases"), terrainFromBases_);
    form->addRow(tr("Buildings stand"), stand_);
    form->addRow(tr("Terrain shows"), terrainShows_);
    form->addRow(QString(), heightsFromSurface_);
    return group;
}

QGroupBox* ReadingForm::makeMeshes() {
    auto* group = new QGroupBox(tr("Meshes (OBJ, PLY, glTF, IFC, DXF)"));
    auto* form = new QFormLayout(group);
    form->addRow(tr("Up axis"), upAxis_);
    form->addRow(tr("Unit of coordinates"), meshUnit_);
    form->addRow(tr("Mesh north"), meshNorth_);
    form->addRow(anchored_, makeAnchor());
    form->addRow(QString(), toMiddle_);
    return group;
}

QWidget* ReadingForm::makeAnchor() {
    auto* place = new QWidget;
    auto* row = new QHBoxLayout(place);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(longitude_, 1);
    row->addWidget(latitude_, 1);
    connect(anchored_, &QCheckBox::toggled, place, &QWidget::setEnabled);
    connect(toMiddle_, &QPushButton::clicked, this, [this] {
        if (middle_) showAnchor(*middle_);
    });
    place->setEnabled(false);
    return place;
}

void ReadingForm::tell() {
    const auto add = [](QWidget* field, const char* name, const QString& tip) {
        field->setObjectName(QString::fromLatin1(name));
        field->setToolTip(tip);
    };
    add(heightField_, "heightField",
        tr("Name of the field with the heights.\nEmpty: the usual names are tried."));
    add(levelsField_, "levelsField",
        tr("Name of the field with the storeys above ground.\nEmpty: the usual names are tried."));
    add(heightUnit_, "heightUnit",
        tr("Unit of heights given as plain numbers.\nAs in the file: metres, unless the value or the field "
           "states otherwise."));
    add(terrainFromBases_, "terrainFromBases",
        tr("If no terrain is read: derive it from the buildings' ground elevations.\nDefault: if more than "
           "one in twenty pairs of neighbours differ by more than 1 m in height."));
    add(stand_, "stand",
        tr("Where buildings stand whose file states their elevations.\nDefault: they are shifted by a gap "
           "that "
           "is the same for all, or set down where their bases do not follow the terrain."));
    add(terrainShows_, "terrainShows",
        tr("A surface model shows the roofs of buildings, which would count twice: the ground around them is "
           "used instead."));
    add(heightsFromSurface_, "heightsFromSurface",
        tr("Buildings without a height get that of the surface model above the ground."));
    add(metresPerLevel_, "metresPerLevel",
        tr("For buildings with known storeys but no height, metres, 2 to 6"));
    add(defaultHeight_, "defaultHeight",
        tr("For buildings with neither height nor storeys, metres, 1 to 1000"));
    add(layer_, "layer", tr("Read this layer only.\nEmpty: all layers with polygons."));
    add(crs_, "crs",
        tr("Coordinate reference system of files that do not state it: EPSG:number.\nEmpty: as in the "
           "file."));
    add(lod_, "lod",
        tr("CityJSON: read this level of detail, 2.2 for example.\nEmpty: the highest available."));
    add(farAway_, "farAway",
        tr("Objects farther from the middle of the data are left out, with a warning; metres, 100 to "
           "200000"));
    add(meshNorth_, "meshNorth",
        tr("Direction of the mesh's north axis, degrees clockwise from true north, -360 to 360"));
    add(anchored_, "anchored",
        tr("Geographic location of the mesh's origin. Required for a mesh opened alone.\nOff: at the origin "
           "of the city from the other files."));
    add(longitude_, "longitude", tr("Longitude of the mesh's origin, degrees, east positive, -180 to 180"));
    add(latitude_, "latitude", tr("Latitude of the mesh's origin, degrees, north positive, -90 to 90"));
    add(toMiddle_, "toMiddle", tr("Places the mesh's origin at the middle of the open city"));
}

void ReadingForm::setMiddle(std::optional<LonLat> middle) {
    middle_ = middle;
    toMiddle_->setEnabled(middle_.has_value());
}

void ReadingForm::showAnchor(LonLat place) {
    anchored_->setChecked(true);
    longitude_->setValue(place.lonDeg);
    latitude_->setValue(place.latDeg);
}

ReadSettings ReadingForm::settings() const {
    ReadSettings settings;
    settings.heightField = textIn(*heightField_);
    settings.levelsField = textIn(*levelsField_);
    const int unit = heightUnit_->currentData().toInt();
    if (unit != asInFile) settings.heightUnit = LengthUnit(unit);
    settings.metresPerLevel = metresPerLevel_->value();
    settings.defaultHeightM = defaultHeight_->value();
    settings.layer = textIn(*layer_);
    if (const std::string crs = textIn(*crs_); !crs.empty()) settings.crs = crs;
    settings.lod = textIn(*lod_);
    settings.farAwayM = farAway_->value();
    settings.terrainFromBases = TerrainFromBases(terrainFromBases_->currentData().toInt());
    settings.stand = Stand(stand_->currentData().toInt());
    settings.terrainShows = TerrainShows(terrainShows_->currentData().toInt());
    settings.heightsFromSurface = heightsFromSurface_->isChecked();
    settings.upAxis = UpAxis(upAxis_->currentData().toInt());
    settings.meshUnit = LengthUnit(meshUnit_->currentData().toInt());
    settings.meshNorthDeg = meshNorth_->value();
    if (anchored_->isChecked()) settings.meshAnchor = LonLat{longitude_->value(), latitude_->value()};
    return settings;
}

void ReadingForm::show(const ReadSettings& settings) {
    showText(*heightField_, settings.heightField);
    showText(*levelsField_, settings.levelsField);
    choose(*heightUnit_, settings.heightUnit ? int(*settings.heightUnit) : asInFile);
    metresPerLevel_->setValue(settings.metresPerLevel);
    defaultHeight_->setValue(settings.defaultHeightM);
    showText(*layer_, settings.layer);
    showText(*crs_, settings.crs.value_or(""));
    showText(*lod_, settings.lod);
    farAway_->setValue(settings.farAwayM);
    choose(*terrainFromBases_, int(settings.terrainFromBases));
    choose(*stand_, int(settings.stand));
    choose(*terrainShows_, int(settings.terrainShows));
    heightsFromSurface_->setChecked(settings.heightsFromSurface);
    choose(*upAxis_, int(settings.upAxis));
    choose(*meshUnit_, int(settings.meshUnit));
    meshNorth_->setValue(settings.meshNorthDeg);
    showAnchor(settings.meshAnchor.value_or(LonLat{}));
    anchored_->setChecked(settings.meshAnchor.has_value());
}

}  // namespace noonmark
