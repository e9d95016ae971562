#include "app/gui/tools/massing/massing_panel.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/study/region_text.h"
#include "app/gui/tools/massing/massing_form.h"
#include "app/gui/tools/massing/massing_text.h"

namespace noonmark {

namespace {

enum TargetKind { floorAreaKind, ratioKind };

constexpr double largestAreaM2 = 1e7, largestRatio = 1000;

bool isInFeet() { return unitsInUse() == UnitSystem::imperial; }
double squareMetresShown() { return isInFeet() ? squareMetresPerSquareFoot : 1; }

}  // namespace

TargetRow::TargetRow(QWidget* parent)
    : QWidget(parent), kind_(new QComboBox), number_(numberField(0, 1, 0, 1, {})) {
    kind_->setObjectName(QStringLiteral("targetKind"));
    kind_->addItems({tr("Floor area"), tr("FAR")});
    kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    kind_->setMinimumContentsLength(7);
    number_->setObjectName(QStringLiteral("targetNumber"));
    kind_->setToolTip(
        tr("Gross floor area, or floor area ratio: gross floor area divided by the lot's area"));
    number_->setToolTip(
        tr("What the tower shall have: type it, and storeys or plate are fitted; else what it has"));
    number_->setKeyboardTracking(false);  // a number is fitted when it is complete
    auto* storeys = pushButton(tr("Fit storeys"), "fitStoreys", tr("The most storeys that stay within it"));
    auto* plate =
        pushButton(tr("Fit plate"), "fitPlate", tr("The floor plate with which these storeys reach it"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(kind_, 0, 0);
    grid->addWidget(number_, 0, 1);
    grid->addWidget(storeys, 1, 0);
    grid->addWidget(plate, 1, 1);
    choose(floorAreaKind);
    connect(kind_, &QComboBox::activated, this, &TargetRow::choose);
    for (QPushButton* button : {storeys, plate}) {
        button->setCheckable(true);
        button->setAutoExclusive(true);
    }
    storeys->setChecked(true);
    connect(number_, &QDoubleSpinBox::valueChanged, this, &TargetRow::fitTyped);
    connect(storeys, &QPushButton::clicked, this, [this] { fit(FloorAreaBy::storeys); });
    connect(plate, &QPushButton::clicked, this, [this] { fit(FloorAreaBy::plate); });
}

void TargetRow::fit(FloorAreaBy by) {
    by_ = by;
    fitTyped();
}

// What is stated stays although whole storeys give less; a change of the tower by other fields ends it.
void TargetRow::fitTyped() {
    isFitting_ = true;
    Q_EMIT fitRequested(target());
    isFitting_ = false;
}

void TargetRow::showReached(double grossFloorM2, double ratio) {
    reachedM2_ = grossFloorM2;
    reachedRatio_ = ratio;
    if (!isFitting_) showNumber();
}

void TargetRow::showNumber() {
    const QSignalBlocker quiet(number_);
    number_->setValue(kind_->currentIndex() == ratioKind ? reachedRatio_ : reachedM2_ / squareMetresShown());
}

// Sets the number's range and unit. Of the other kind nothing is stated yet.
void TargetRow::choose(int kind) {
    const QSignalBlocker quiet(number_);
    const bool ratio = kind == ratioKind;
    number_->setDecimals(ratio ? 2 : 0);
    number_->setSuffix(ratio ? QString() : isInFeet() ? tr(" sq ft") : QStringLiteral(" m²"));
    number_->setRange(ratio ? 0.01 : 1, ratio ? largestRatio : largestAreaM2 / squareMetresShown());
    number_->setSingleStep(ratio ? 0.5 : 500);
    showNumber();
}

FloorAreaTarget TargetRow::target() const {
    FloorAreaTarget target{.by = by_};
    if (kind_->currentIndex() == ratioKind)
        target.floorAreaRatio = number_->value();
    else
        target.grossFloorM2 = number_->value() * squareMetresShown();
    return target;
}

namespace {

constexpr int minNumberPx = 58;
constexpr int minScreenPx = 300;  // of the fields, so that the window fits on small screens

QString makeUseRows(const std::vector<UseArea>& uses) {
    QString rows;
    for (const UseArea& area : uses) {
        const QString use =
            area.use.empty() ? QObject::tr("Use not stated") : QString::fromStdString(area.use);
        rows += QStringLiteral("<tr><td>%1, %2&nbsp;&nbsp;</td><td align='right'>%3</td></tr>")
                    .arg(use.toHtmlEscaped(), describeStoreys(area.storeys),
                         describeSmallArea(area.grossFloorM2));
    }
    return rows;
}

// Of a height that is no number of whole storeys.
QString describeTopStorey(const Massing& massing) {
    const double topM = massing.figures.heightM - (massing.figures.storeys - 1) * massing.storeyHeightM;
    if (std::abs(topM - massing.storeyHeightM) < 0.005) return {};
    return QObject::tr(" (top: %1)").arg(describeLength(topM));
}

QString makeRows(const Massing& massing, std::size_t demolished, double groundElevationM) {
    const MassingFigures& figures = massing.figures;
    const auto row = [](const QString& name, const QString& value) {
        return QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td align='right'><b>%2</b></td></tr>")
            .arg(name, value);
    };
    return QStringLiteral("<table>") +
           row(QObject::tr("Gross floor area"), describeSmallArea(figures.grossFloorM2)) +
           makeUseRows(figures.uses) +
           row(QObject::tr("Floor area ratio (FAR)"), groupDigits(figures.floorAreaRatio, 2)) +
           row(QObject::tr("Lot coverage"), groupDigits(figures.coverage * 100) + QStringLiteral(" %")) +
           row(QObject::tr("Height"), describeHeight(figures.heightM, groundElevationM)) +
           row(QObject::tr("Storeys"), QString::number(figures.storeys) + describeTopStorey(massing)) +
           row(QObject::tr("Buildings demolished"), QString::number(demolished)) + QStringLiteral("</table>");
}

}  // namespace

MassingPanel::MassingPanel(QWidget* parent)
    : QWidget(parent),
      scroll_(new QScrollArea),
      body_(new QWidget),
      on_(new QLabel),
      name_(new QLineEdit),
      target_(new TargetRow),
      form_(new MassingForm) {
    on_->setWordWrap(true);
    name_->setMaxLength(80);
    name_->setToolTip(tr("Name and id of the new building"));
    auto* names = new QFormLayout;
    names->addRow(tr("On"), on_);
    names->addRow(tr("Name"), name_);
    names->addRow(tr("Target"), target_);
    auto* inside = new QVBoxLayout(body_);
    inside->setContentsMargins(0, 0, 0, 0);
    inside->addLayout(names);
    inside->addWidget(form_);
    inside->addWidget(makeLiveChoices());
    auto* scrolled = new QWidget;
    auto* above = new QVBoxLayout(scrolled);
    above->setContentsMargins(6, 6, 6, 6);
    above->addWidget(makeLotRow());
    above->addWidget(body_);
    above->addStretch(1);
    scroll_->setWidget(scrolled);
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(scroll_, 1);
    footer_ = makeFooter();
    column->addWidget(footer_);
    connect(target_, &TargetRow::fitRequested, this, &MassingPanel::fitRequested);
    connect(form_, &MassingForm::edited, this, &MassingPanel::edited);
    connect(name_, &QLineEdit::textEdited, this, &MassingPanel::edited);
    // Their largest numbers are far wider than the usual ones.
    for (QAbstractSpinBox* number : scrolled->findChildren<QAbstractSpinBox*>())
        number->setMinimumWidth(minNumberPx);
    // No field is cut, and none needs to be scrolled to sideways; on small screens they scroll.
    const int barPx = scroll_->verticalScrollBar()->sizeHint().width();
    scroll_->setMinimumWidth(std::min(minScreenPx, scrolled->minimumSizeHint().width() + barPx));
    setLots({});
    showNone();
}

QWidget* MassingPanel::makeLotRow() {
    lot_ = new QComboBox;
    lot_->setObjectName(QStringLiteral("lot"));
    lot_->setToolTip(tr("The project's lots, and those of buildings that towers have replaced"));
    // A long name shall not widen the panel.
    lot_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    lot_->setMinimumContentsLength(12);
    design_ = pushButton(tr("Design tower"), "designTower",
                         tr("Designs a tower on this lot; building it demolishes the buildings on the lot"));
    editTower_ = pushButton(tr("Edit tower"), "editTower",
                            tr("Designs the tower on this lot further, with the values it was built with"));
    copy_ =
        pushButton(tr("Copy tower here"), "copyTower",
                   tr("Sets the tower that is selected or being designed on this lot too, with its storeys, "
                      "plate areas and setbacks, turned as the lot is"));
    edit_ = pushButton(tr("Edit lot"), "editLot",
                       tr("Shows the lot's corners and sides as handles that are dragged.\nA click on the "
                          "middle of a side adds a corner, Delete removes the selected one."));
    auto* draw =
        pushButton(tr("Draw lot"), "drawLot",
                   tr("Click corners on the ground (Shift: at right angles to the last side; Ctrl: without "
                      "snapping),\nor type the length of a side and press Enter.\nDouble click, Enter or "
                      "right click finishes, Backspace removes the last corner."));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(draw);
    buttons->addWidget(edit_);
    auto* row = new QWidget;
    auto* column = new QVBoxLayout(row);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(lot_);
    column->addLayout(buttons);
    auto* towers = new QHBoxLayout;
    towers->addWidget(design_);
    towers->addWidget(editTower_);
    column->addLayout(towers);
    column->addWidget(copy_);
    hint_ = new QLabel(
        tr("Draw a lot on the ground, or click a building and make a lot from its footprint. Ctrl+T replaces "
           "the building that is selected by a tower."));
    hint_->setObjectName(QStringLiteral("towerHint"));
    hint_->setWordWrap(true);
    column->addWidget(hint_);
    connect(lot_, &QComboBox::currentIndexChanged, this, &MassingPanel::enableLotButtons);
    connect(editTower_, &QPushButton::clicked, this, [this] {
        if (const auto lot = chosenLot()) Q_EMIT editTowerRequested(*lot);
    });
    connect(draw, &QPushButton::clicked, this, &MassingPanel::drawRequested);
    connect(edit_, &QPushButton::clicked, this, [this] {
        if (const auto lot = chosenLot()) Q_EMIT editRequested(*lot);
    });
    connect(design_, &QPushButton::clicked, this, [this] {
        if (const auto lot = chosenLot()) Q_EMIT designRequested(*lot);
    });
    connect(copy_, &QPushButton::clicked, this, [this] {
        if (const auto lot = chosenLot()) Q_EMIT copyRequested(*lot);
    });
    return row;
}

std::optional<NamedLot> MassingPanel::chosenLot() const {
    const int chosen = lot_->currentIndex();
    if (chosen < 0 || std::size_t(chosen) >= lots_.size()) return std::nullopt;
    return lots_[std::size_t(chosen)];
}

// One or the other, or the shadow with the tower on the ground alone.
QWidget* MassingPanel::makeLiveChoices() {
    change_ = new QCheckBox(tr("Change of shadow"));
    change_->setObjectName(QStringLiteral("liveChange"));
    change_->setToolTip(
        tr("Shows where the tower adds shadow to the baseline, or takes it away, instead of all shadow with "
           "it. A pin marks the worst spot."));
    facades_ = new QCheckBox(tr("Sunlight of its facades"));
    facades_->setObjectName(QStringLiteral("liveFacades"));
    facades_->setChecked(true);
    facades_->setToolTip(tr(
        "Shows the hours of shadow on the tower's facades, coarsely while it changes. Click other buildings "
        "in the view to see their facades too. Bays and storeys are those of the study's form."));
    connect(change_, &QCheckBox::clicked, this, &MassingPanel::changeShownChosen);
    connect(facades_, &QCheckBox::clicked, this, &MassingPanel::facadesShownChosen);
    auto* choices = new QWidget;
    auto* column = new QVBoxLayout(choices);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(change_);
    column->addWidget(facades_);
    return choices;
}

void MassingPanel::setFacadesShown(bool shown) { facades_->setChecked(shown); }

void MassingPanel::setChangeShown(bool shown) { change_->setChecked(shown); }

void MassingPanel::showEffect(const QString& words) {
    effect_->setText(words);
    effect_->setEnabled(true);
    effect_->setVisible(!words.isEmpty());
}

void MassingPanel::greyEffect() { effect_->setEnabled(false); }

void MassingPanel::showInRegion(InRegion place) {
    beyond_->setText(
        place == InRegion::part
            ? tr("A part of the tower stands outside the study's region, which alone is measured.")
            : tr("The tower stands outside the study's region, which alone is measured."));
    for (QWidget* one : std::initializer_list<QWidget*>{beyond_, moveRegion_})
        one->setVisible(place != InRegion::whole);
}

// Figures, error and buttons, which stay in sight while the fields are scrolled.
QWidget* MassingPanel::makeFooter() {
    figures_ = new QLabel;
    figures_->setTextFormat(Qt::RichText);
    figures_->setObjectName(QStringLiteral("figures"));
    effect_ = new QLabel;
    effect_->setTextFormat(Qt::PlainText);
    effect_->setWordWrap(true);
    effect_->setObjectName(QStringLiteral("towerEffect"));
    effect_->hide();
    beyond_ = new QLabel;
    beyond_->setWordWrap(true);
    beyond_->setObjectName(QStringLiteral("towerBeyond"));
    moveRegion_ = pushButton(tr("Move the region here"), "moveRegion",
                             tr("Studies, comparisons and exports then measure the ground around the tower"));
    connect(moveRegion_, &QPushButton::clicked, this, &MassingPanel::regionRequested);
    showInRegion(InRegion::whole);
    error_ = new QLabel;
    error_->setWordWrap(true);
    error_->setObjectName(QStringLiteral("massingError"));
    showAsError(*error_);
    nearest_ = pushButton({}, "takeNearest", tr("Takes the nearest value with which the tower can be built"));
    connect(nearest_, &QPushButton::clicked, this, &MassingPanel::nearestTaken);
    auto* group = new QFrame;
    group->setFrameShape(QFrame::StyledPanel);
    auto* column = new QVBoxLayout(group);
    column->setContentsMargins(8, 4, 8, 4);
    column->setSpacing(4);
    for (QWidget* one : std::initializer_list<QWidget*>{figures_, effect_, beyond_, moveRegion_, error_,
                                                        nearest_, makeAnswerButtons()})
        column->addWidget(one);
    return group;
}

QWidget* MassingPanel::makeAnswerButtons() {
    apply_ = pushButton(tr("Build"), "applyMassing",
                        tr("Adds the tower to the scenario, as one undo step (Enter over the view)"));
    auto* cancel =
        pushButton(tr("Cancel"), "cancelMassing", tr("Leaves the scenario unchanged (Esc over the view)"));
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(apply_);
    row->addWidget(cancel);
    connect(apply_, &QPushButton::clicked, this, &MassingPanel::applyRequested);
    connect(cancel, &QPushButton::clicked, this, &MassingPanel::cancelled);
    return buttons;
}

namespace {

bool hasName(const std::vector<NamedLot>& lots, const std::string& name) {
    return std::ranges::find(lots, name, &NamedLot::name) != lots.end();
}

}  // namespace

void MassingPanel::setLots(const std::vector<NamedLot>& lots) {
    projectLots_ = lots;
    listLots();
}

void MassingPanel::setDesignedLots(std::vector<NamedLot> lots) {
    designed_ = std::move(lots);
    listLots();
}

void MassingPanel::listLots() {
    const QString chosen = lot_->currentText();
    lots_ = projectLots_;
    for (const NamedLot& lot : designed_)
        if (!hasName(lots_, lot.name)) lots_.push_back(lot);
    const QSignalBlocker quiet(lot_);
    lot_->clear();
    for (const NamedLot& lot : lots_) lot_->addItem(QString::fromStdString(lot.name));
    if (lots_.empty()) lot_->addItem(tr("No lots yet: draw one"));
    lot_->setCurrentIndex(std::max(0, lot_->findText(chosen)));
    lot_->setEnabled(!lots_.empty());
    hint_->setVisible(lots_.empty() && body_->isHidden());
    enableLotButtons();
}

void MassingPanel::chooseLot(const std::string& name) {
    lot_->setCurrentIndex(std::max(0, lot_->findText(QString::fromStdString(name))));
}

void MassingPanel::enableLotButtons() {
    const auto lot = chosenLot();
    for (QPushButton* button : {design_, copy_}) button->setEnabled(lot.has_value());
    edit_->setEnabled(lot && hasName(projectLots_, lot->name));
    editTower_->setEnabled(lot && hasName(designed_, lot->name));
}

// What is done once for a lot moves out of sight where the screen is low, so that the fields are in sight.
void MassingPanel::setDesigning(bool designing) {
    const bool begins = designing && body_->isHidden();
    for (QWidget* one : {body_, footer_}) one->setVisible(designing);
    hint_->setVisible(!designing && lots_.empty());
    if (begins)  // when all has its place
        QTimer::singleShot(0, this, [this] { scroll_->verticalScrollBar()->setValue(body_->y()); });
}

void MassingPanel::showDraft(const TowerDraft& draft) {
    draft_ = draft;
    const QString lot = QString::fromStdString(draft.lot.name), size = describeArea(area(draft.lot.outline));
    on_->setText(lot.isEmpty() ? size : QStringLiteral("%1, %2").arg(lot, size));
    const QString name = QString::fromStdString(draft.tower);
    if (name_->text() != name) name_->setText(name);
    chooseLot(draft.lot.name);
    form_->show(draft.settings);
    setDesigning(true);
}

void MassingPanel::showNone() {
    draft_ = {};
    setDesigning(false);
}

TowerDraft MassingPanel::draft() const {
    TowerDraft draft = draft_;
    draft.tower = name_->text().trimmed().toStdString();
    draft.settings = form_->settings();
    return draft;
}

void MassingPanel::showFigures(const Massing& massing, std::size_t demolished, double groundElevationM) {
    form_->setGround(groundElevationM);
    form_->markWrong(nullptr);
    target_->showReached(massing.figures.grossFloorM2, massing.figures.floorAreaRatio);
    figures_->setText(makeRows(massing, demolished, groundElevationM));
    error_->clear();
    for (QWidget* one : std::initializer_list<QWidget*>{error_, nearest_}) one->hide();
    for (QWidget* one : std::initializer_list<QWidget*>{figures_, effect_, apply_}) one->setEnabled(true);
}

// The last figures stay, paler: they describe the tower still in the view.
void MassingPanel::showError(const Error& error, const NearestFit* nearest) {
    error_->setText(describeError(Error{error.what, {}, error.advice}));  // the field is marked
    error_->show();
    for (QWidget* one : {figures_, effect_}) one->setEnabled(false);
    form_->markWrong(nearest);
    nearest_->setVisible(nearest != nullptr);
    if (nearest != nullptr) nearest_->setText(tr("Use %1").arg(describeNearest(*nearest)));
    apply_->setEnabled(false);
}

void MassingPanel::showNotReached(const Error& error) {
    error_->setText(describeError(error));
    error_->show();
}

QString MassingPanel::message() const { return error_->text(); }

}  // namespace noonmark
