#include "app/gui/docks/study_form/face_form.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <array>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/number_fields.h"

namespace noonmark {

std::vector<std::string> splitNames(const QString& text) {
    std::vector<std::string> names;
    for (const QString& name : text.split(QLatin1Char(','), Qt::SkipEmptyParts))
        if (!name.trimmed().isEmpty()) names.push_back(name.trimmed().toStdString());
    return names;
}

QString joinNames(const std::vector<std::string>& names) {
    QStringList list;
    for (const std::string& name : names) list << QString::fromStdString(name);
    return list.join(QStringLiteral(", "));
}

namespace {

// After "any direction": north, east, south and west, each 45 degrees to both sides.
constexpr std::array<AzimuthRange, 4> sides{{{315, 45}, {45, 135}, {135, 225}, {225, 315}}};
constexpr int otherRange = int(sides.size()) + 1;
// Two fields beside each other may be narrower than their longest texts, so that the form need not scroll.
constexpr int besidePx = 68;

QDoubleSpinBox* degreesField(const char* name, const QString& tip) {
    QDoubleSpinBox* field = numberField(0, 360, 1, 5, QObject::tr(" °"));
    field->setObjectName(QString::fromLatin1(name));
    field->setToolTip(tip);
    return field;
}

}  // namespace

FaceForm::FaceForm(QWidget* parent) : QWidget(parent) {
    makeFields();
    placeFields();
    connectFields();
    setPlaces({});
}

void FaceForm::makeFields() {
    ids_ = new QLineEdit;
    ids_->setObjectName(QStringLiteral("faces"));
    ids_->setPlaceholderText(tr("all faces"));
    ids_->setToolTip(
        tr("Single faces of buildings, with commas between them, by the beginning of their points' ids: "
           "way 12 wall 3. Empty: all faces"));
    pick_ =
        pushButton(tr("Pick"), "pickFace",
                   tr("Click walls in the view: each click adds a face or removes it. Press again to end"));
    pick_->setCheckable(true);
    direction_ = new QComboBox;
    direction_->setObjectName(QStringLiteral("facingDirection"));
    direction_->addItems({tr("any direction"), tr("north ± 45°"), tr("east ± 45°"), tr("south ± 45°"),
                          tr("west ± 45°"), tr("other azimuths")});
    direction_->setToolTip(tr("Only faces, or windows, that face this direction from true north"));
    from_ = degreesField("facingFrom", tr("The first azimuth, clockwise from true north"));
    to_ = degreesField("facingTo", tr("The last azimuth, clockwise from true north"));
    place_ = new QComboBox;
    place_->setObjectName(QStringLiteral("facingPlace"));
    place_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    place_->setMinimumContentsLength(6);
    place_->setToolTip(
        tr("Only points from which a level line straight out from the wall meets this place, as the windows "
           "along a park"));
    within_ = lengthField(1, FaceChoice::maxWithinM, 0, 10);
    within_->setObjectName(QStringLiteral("facingWithin"));
    within_->setToolTip(tr("How far away the place may be"));
    for (QWidget* field : std::initializer_list<QWidget*>{from_, to_, place_, within_})
        field->setMinimumWidth(besidePx);
}

void FaceForm::placeFields() {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Faces"), widgetRow({ids_, pick_}));
    form->addRow(tr("Facing"), direction_);
    form->addRow(QString(), widgetRow({from_, to_}));
    form->addRow(tr("Looking at"), widgetRow({place_, within_}));
}

void FaceForm::connectFields() {
    connect(ids_, &QLineEdit::editingFinished, this, [this] {
        auto ids = splitNames(ids_->text());
        if (ids == faces_.faces) return;
        faces_.faces = std::move(ids);
        Q_EMIT edited(faces_, tr("faces"));
    });
    connect(pick_, &QPushButton::toggled, this, [this](bool on) {
        if (on) Q_EMIT pickingBegan();
    });
    connect(direction_, &QComboBox::activated, this, &FaceForm::takeDirection);
    for (QDoubleSpinBox* field : {from_, to_})
        connect(field, &QDoubleSpinBox::valueChanged, this, &FaceForm::takeRange);
    connect(place_, &QComboBox::activated, this, [this](int chosen) {
        faces_.place = chosen == 0 ? std::string() : place_->currentText().toStdString();
        within_->setEnabled(chosen != 0);
        Q_EMIT edited(faces_, tr("faced place"));
    });
    connect(within_, &QDoubleSpinBox::valueChanged, this, [this](double metres) {
        faces_.withinM = metres;
        Q_EMIT edited(faces_, tr("faced place"));
    });
}

void FaceForm::takeDirection(int chosen) {
    if (chosen == 0)
        faces_.facing.reset();
    else if (chosen < otherRange)
        faces_.facing = sides[std::size_t(chosen - 1)];
    else
        faces_.facing = AzimuthRange{from_->value(), to_->value()};
    showRange();
    Q_EMIT edited(faces_, tr("direction"));
}

void FaceForm::takeRange() {
    faces_.facing = AzimuthRange{from_->value(), to_->value()};
    Q_EMIT edited(faces_, tr("azimuths"));
}

void FaceForm::showRange() {
    const QSignalBlocker quiet[]{QSignalBlocker(from_), QSignalBlocker(to_)};
    for (QDoubleSpinBox* field : {from_, to_}) field->parentWidget()->setVisible(faces_.facing.has_value());
    if (!faces_.facing) return direction_->setCurrentIndex(0);
    const auto* side = std::ranges::find(sides, *faces_.facing);
    direction_->setCurrentIndex(side == sides.end() ? otherRange : int(side - sides.begin()) + 1);
    from_->setValue(faces_.facing->fromDeg);
    to_->setValue(faces_.facing->toDeg);
}

void FaceForm::show(const FaceChoice& faces) {
    faces_ = faces;
    ids_->setText(joinNames(faces.faces));
    showRange();
    const QString place = QString::fromStdString(faces.place);
    if (!place.isEmpty() && place_->findText(place) < 0) place_->addItem(place);
    place_->setCurrentIndex(place.isEmpty() ? 0 : place_->findText(place));
    const QSignalBlocker quiet(within_);
    within_->setValue(faces.withinM);
    within_->setEnabled(!place.isEmpty());
}

void FaceForm::setPlaces(const QStringList& names) {
    place_->clear();
    place_->addItem(tr("anything"));
    place_->addItems(names);
    show(faces_);
}

void FaceForm::setPickable(bool pickable) {
    if (!pickable) endPicking();
    ids_->parentWidget()->setEnabled(pickable);
}

void FaceForm::addFace(const QString& id) {
    const std::string face = id.toStdString();
    const auto found = std::ranges::find(faces_.faces, face);
    found == faces_.faces.end() ? faces_.faces.push_back(face) : void(faces_.faces.erase(found));
    ids_->setText(joinNames(faces_.faces));
    Q_EMIT edited(faces_, tr("faces"));
}

void FaceForm::endPicking() { pick_->setChecked(false); }

bool FaceForm::picking() const { return pick_->isChecked() && isVisible(); }

}  // namespace noonmark
