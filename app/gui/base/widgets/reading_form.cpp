#include "app/gui/base/widgets/reading_form.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QPushButton>

#include "app/gui/base/widgets/field_rows.h"
#include "app/gui/base/widgets/number_fields.h"
#include "core/io/formats/format.h"
#include "core/io/settings/read_fields.h"

namespace noonmark {

ReadingForm::ReadingForm(QWidget* parent)
    : QWidget(parent), rows_(new FieldRows(readSettingsFields().rows(), this)) {
    makeFields();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    for (QGroupBox* group : {makeHeights(), makeData(), makeMeshes()}) column->addWidget(group);
    setMiddle({});
    connect(rows_, &FieldRows::edited, this, &ReadingForm::edited);
}

void ReadingForm::makeFields() {
    anchored_ = new QCheckBox(tr("Origin located at"));
    longitude_ = numberField(-180, 180, 7, 0.001, tr("° east"));
    latitude_ = numberField(-90, 90, 7, 0.001, tr("° north"));
    toMiddle_ = new QPushButton(tr("Middle of the open city"));
    toMiddle_->setAutoDefault(false);  // Enter must trigger Open
    const auto add = [](QWidget* field, const char* name, const QString& tip) {
        field->setObjectName(QString::fromLatin1(name));
        field->setToolTip(tip);
    };
    add(anchored_, "anchored",
        tr("Geographic location of the mesh's origin. Required for a mesh opened alone.\nOff: at the origin "
           "of the city from the other files."));
    add(longitude_, "longitude", tr("Longitude of the mesh's origin, degrees, east positive, -180 to 180"));
    add(latitude_, "latitude", tr("Latitude of the mesh's origin, degrees, north positive, -90 to 90"));
    add(toMiddle_, "toMiddle", tr("Places the mesh's origin at the middle of the open city"));
}

QGroupBox* ReadingForm::makeHeights() {
    auto* group = new QGroupBox(tr("Heights and names"));
    rows_->addRows(*new QFormLayout(group), {"--height-field", "--levels-field", "--building-name-field",
                                             "--height-unit", "--metres-per-level", "--default-height"});
    return group;
}

QGroupBox* ReadingForm::makeData() {
    auto* group = new QGroupBox(tr("Place and choice of data"));
    rows_->addRows(*new QFormLayout(group),
                   {"--crs", "--layer", "--lod", "--far-away", "--terrain-from-bases", "--stand",
                    "--terrain-shows", "--heights-from-surface"});
    return group;
}

QGroupBox* ReadingForm::makeMeshes() {
    auto* group = new QGroupBox(tr("Meshes (%1)").arg(QString::fromStdString(listNames({FileKind::mesh}))));
    auto* form = new QFormLayout(group);
    rows_->addRows(*form, {"--up", "--mesh-unit", "--mesh-north"});
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
    rows_->take(readSettingsFields().of(settings));
    if (anchored_->isChecked()) settings.meshAnchor = LonLat{longitude_->value(), latitude_->value()};
    return settings;
}

void ReadingForm::show(const ReadSettings& settings) {
    rows_->show(readSettingsFields().of(settings));
    showAnchor(settings.meshAnchor.value_or(LonLat{}));
    anchored_->setChecked(settings.meshAnchor.has_value());
}

}  // namespace noonmark
