#include "app/gui/tools/editing/mesh_placing.h"

#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/field_rows.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "core/city/terrain/building_ground.h"
#include "core/io/files/plain_file.h"
#include "core/io/formats/format.h"
#include "core/io/meshes/ifc_site.h"
#include "core/io/meshes/stated_axes.h"
#include "core/io/settings/read_settings.h"
#include "scenarios/edits/read_shape.h"
#include "scenarios/scenario.h"

namespace noonmark {

namespace {

constexpr int wordLines = 4;  // room for a long file name and the instruction

}  // namespace

PlacingPanel::PlacingPanel(QWidget* parent)
    : QWidget(parent),
      what_(new QLabel),
      warnings_(new QLabel),
      axes_(new FieldRows(meshAxesFields().rows(), this)),
      scale_(numberField(0.001, 1000, 3, 0.1, {})),
      turn_(numberField(-360, 360, 1, 5, QStringLiteral("°"))),
      storeyHeight_(lengthField(0, 10, 2, 0.1)),
      longitude_(numberField(-180, 180, 7, 0.0001, tr("° east"))),
      latitude_(numberField(-90, 90, 7, 0.0001, tr("° north"))),
      apply_(new QPushButton(tr("Build"))),
      reload_(
          pushButton(tr("Reload"), "reloadMesh",
                     tr("Puts the file in the place of its earlier edition; the edits that follow stay"))) {
    for (QLabel* words : {what_, warnings_}) {
        words->setWordWrap(true);
        words->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    }
    // A fixed height: the fields must not move under the cursor while the mesh is placed.
    what_->setFixedHeight(wordLines * what_->fontMetrics().lineSpacing());
    scale_->setToolTip(tr("Scale of all three axes"));
    turn_->setToolTip(tr("Clockwise, seen from above. Of an IFC that states its true north, preset from it"));
    for (const auto& [field, name] :
         {std::pair(scale_, "meshScale"), std::pair(turn_, "meshTurn"),
          std::pair(longitude_, "meshLongitude"), std::pair(latitude_, "meshLatitude")})
        field->setObjectName(QString::fromLatin1(name));
    for (QDoubleSpinBox* field : {longitude_, latitude_})
        field->setToolTip(tr("Where its middle stands; a click on the ground sets it, too"));
    reload_->hide();
    storeyHeight_->setObjectName(QStringLiteral("meshStoreyHeight"));
    storeyHeight_->setToolTip(tr("Floor to floor, %1 to %2, for lines at its floors; 0: not known")
                                  .arg(describeLength(2, 0), describeLength(10, 0)));
    storeyHeight_->setSpecialValueText(tr("not known"));
    apply_->setObjectName(QStringLiteral("applyMesh"));
    apply_->setToolTip(tr("Adds it to the scenario (Enter over the view)"));
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setObjectName(QStringLiteral("cancelPlacing"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(apply_);
    buttons->addWidget(reload_);
    buttons->addWidget(cancel);
    auto* form = new QFormLayout(this);
    form->addRow(what_);
    axes_->addRows(*form, {"--up", "--mesh-unit"});
    form->addRow(tr("Scale"), scale_);
    form->addRow(tr("Rotation"), turn_);
    form->addRow(tr("Middle"), longitude_);
    form->addRow(QString(), latitude_);
    form->addRow(tr("Storey height"), storeyHeight_);
    form->addRow(buttons);
    form->addRow(warnings_);  // below the fields, since their number varies
    connect(axes_, &FieldRows::edited, this, &PlacingPanel::readingEdited);
    for (QDoubleSpinBox* field : {scale_, turn_, storeyHeight_})
        connect(field, &QDoubleSpinBox::valueChanged, this, &PlacingPanel::edited);
    for (QDoubleSpinBox* field : {longitude_, latitude_})
        connect(field, &QDoubleSpinBox::valueChanged, this, [this] {
            Q_EMIT placeTyped({longitude_->value(), latitude_->value()});
        });
    connect(apply_, &QPushButton::clicked, this, &PlacingPanel::applyRequested);
    connect(reload_, &QPushButton::clicked, this, &PlacingPanel::reloadRequested);
    connect(cancel, &QPushButton::clicked, this, &PlacingPanel::cancelled);
}

void PlacingPanel::begin(const QString& file) {
    file_ = file;
    preset(1, 0, 0);
    apply_->setEnabled(false);
    reload_->setEnabled(false);
    what_->setText(tr("%1: click the place on the ground for its middle.").arg(file));
}

void PlacingPanel::setStated(bool axes, bool unit) {
    axes_->widget("--up")->setEnabled(!axes);
    axes_->widget("--mesh-unit")->setEnabled(!unit);
}

void PlacingPanel::showPlaced(double heightM, double groundElevationM) {
    apply_->setEnabled(true);
    reload_->setEnabled(true);
    if (!reload_->isHidden()) return;  // what it says of the earlier edition stays
    what_->setText(
        tr("%1, top %2. Another click moves it.").arg(file_, describeHeight(heightM, groundElevationM)));
}

void PlacingPanel::preset(double scale, double clockwiseDeg, double storeyHeightM) {
    const QSignalBlocker quietScale(scale_), quietTurn(turn_), quietStoreys(storeyHeight_);
    scale_->setValue(scale);
    turn_->setValue(clockwiseDeg);
    storeyHeight_->setValue(storeyHeightM);
}

void PlacingPanel::showMiddle(LonLat middle) {
    const QSignalBlocker quietLongitude(longitude_), quietLatitude(latitude_);
    longitude_->setValue(middle.lonDeg);
    latitude_->setValue(middle.latDeg);
}

void PlacingPanel::setEarlier(const QString& building) {
    reload_->setVisible(!building.isEmpty());
    if (!building.isEmpty())
        what_->setText(tr("%1: an earlier version of this file is in the scenario as %2. Reload replaces it; "
                          "Build adds another.")
                           .arg(file_, building));
}

void PlacingPanel::showWarnings(const Warnings& warnings) {
    QStringList lines;
    for (const WarningGroup& group : groupWarnings(warnings)) lines << describeWarningWithPlaces(group);
    warnings_->setText(lines.mid(0, 1).join(QString()) +
                       (lines.size() > 1 ? tr(" (and %1 more)").arg(lines.size() - 1) : QString()));
    warnings_->setToolTip(lines.join(QLatin1Char('\n')));
    warnings_->setVisible(!lines.isEmpty());
}

void PlacingPanel::showReading(const ReadSettings& settings) { axes_->show(meshAxesFields().of(settings)); }

ReadSettings PlacingPanel::reading(ReadSettings settings) const {
    axes_->take(meshAxesFields().of(settings));
    return settings;
}

double PlacingPanel::scale() const { return scale_->value(); }

double PlacingPanel::clockwiseDeg() const { return turn_->value(); }

// Less than 2 m is no storey.
double PlacingPanel::storeyHeightM() const {
    constexpr double minM = 2;
    return storeyHeight_->value() < minM ? 0 : storeyHeight_->value();
}

namespace {

std::string freeId(const City& city, const std::string& wanted) {
    return findFreeName(wanted, [&](const std::string& id) {
        return std::ranges::any_of(city.buildings, [&](const auto& b) { return b->sourceId == id; });
    });
}

}  // namespace

MeshPlacing::MeshPlacing(EditContext& context, PlacingPanel& panel, QObject* parent)
    : QObject(parent), context_(context), panel_(panel) {
    connect(&panel_, &PlacingPanel::edited, this, &MeshPlacing::show);
    connect(&panel_, &PlacingPanel::readingEdited, this, &MeshPlacing::read);
    connect(&panel_, &PlacingPanel::placeTyped, this, [this](LonLat middle) {
        if (context_.city) placeAt(context_.city->city().frame.localFromLonLat(middle));
    });
    connect(&panel_, &PlacingPanel::reloadRequested, this, &MeshPlacing::reload);
    connect(&panel_, &PlacingPanel::applyRequested, this, &MeshPlacing::build);
    connect(&panel_, &PlacingPanel::cancelled, this, &MeshPlacing::cancel);
}

void MeshPlacing::begin(const QString& file, std::optional<glm::dvec2> place) {
    if (!context_.city) return;
    mesh_.reset();
    place_ = place;
    file_ = file;
    const auto stated = findStatedAxes(file.toStdString());
    panel_.setStated(stated.has_value(), stated && stated->metresPerUnit);
    reading_ = {};
    if (const ImportMesh* earlier = findEarlier())
        applyReading(*earlier, reading_), panel_.showReading(reading_);
    read();
}

void MeshPlacing::read() {
    const std::string id = freeId(context_.city->city(), QFileInfo(file_).completeBaseName().toStdString());
    job_.start<Read>(
        tr("Reading %1").arg(QFileInfo(file_).fileName()),
        [file = file_.toStdString(), id, settings = panel_.reading(reading_),
         frame = context_.city->city().frame](Progress& progress, std::stop_token stop) {
            Warnings warnings;
            const OwnPlace own = findOwnPlace(file, frame, stop);
            return readShape(file, id, settings, frame, warnings, progress, std::move(stop))
                .map([&](ImportMesh mesh) {
                    return Read{std::move(mesh), warnings, own};
                });
        },
        [this](Result<Read> read) { take(std::move(read)); });
}

void MeshPlacing::take(Result<Read> read) {
    if (!read) return Q_EMIT failed(read.error());
    const bool first = !mesh_.has_value();
    mesh_ = std::move(read->mesh);
    if (first) Q_EMIT began();
    if (first) {
        panel_.begin(QString::fromStdString(mesh_->file));
        preset(read->own);
    }
    panel_.showWarnings(read->warnings);
    show();
}

const ImportMesh* MeshPlacing::findEarlier() const {
    const std::string name = QFileInfo(file_).fileName().toStdString();
    const auto found = std::ranges::find(context_.proposals, name, &ImportMesh::file);
    return found == context_.proposals.end() ? nullptr : &*found;
}

// As the earlier edition stands, else as an IFC states: its true north, and its place where it is near.
void MeshPlacing::preset(const OwnPlace& own) {
    const ImportMesh* earlier = findEarlier();
    panel_.setEarlier(earlier ? QString::fromStdString(earlier->shape->sourceId) : QString());
    const glm::dvec2 middle = findMiddle(*mesh_->shape);
    if (earlier) {
        panel_.preset(earlier->placement.scale, earlier->placement.clockwiseDeg, earlier->storeyHeightM);
        if (!place_) place_ = applyTo(middle, earlier->placement);
        return;
    }
    if (!own.clockwiseDeg) return;
    panel_.preset(1, *own.clockwiseDeg, 0);
    if (!place_ && own.originM) place_ = *own.originM + applyTo(middle, {.clockwiseDeg = *own.clockwiseDeg});
}

void MeshPlacing::placeAt(glm::dvec2 ground) {
    place_ = ground;
    show();
}

void MeshPlacing::show() {
    if (!mesh_ || !place_) return;
    const glm::dvec2 middle = findMiddle(*mesh_->shape);
    mesh_->placement = {.about = middle,
                        .scale = panel_.scale(),
                        .clockwiseDeg = panel_.clockwiseDeg(),
                        .byM = *place_ - middle};
    mesh_->storeyHeightM = panel_.storeyHeightM();
    panel_.showMiddle(context_.city->city().frame.lonLatFromLocal(*place_));
    if (const auto shown = context_.preview.show({*mesh_}); !shown) return Q_EMIT failed(shown.error());
    const City& city = context_.city->city();
    const double groundM = double(findGroundUnder(*context_.preview.changes().added.back(), city));
    panel_.showPlaced(double(topM(*mesh_->shape)) * panel_.scale(),
                      computeElevation(city, {*place_, groundM}));
}

std::optional<double> MeshPlacing::storeyHeightM() const {
    return panel_.storeyHeightM() > 0 ? std::optional(panel_.storeyHeightM()) : std::nullopt;
}

void MeshPlacing::build() {
    if (!mesh_ || !place_) return;
    const ImportMesh done = *std::exchange(mesh_, std::nullopt);
    Q_EMIT ended();
    Q_EMIT editsMade({done}, tr("Import %1").arg(QString::fromStdString(done.file)), done.shape->sourceId);
}

void MeshPlacing::reload() {
    const ImportMesh* earlier = mesh_ && place_ ? findEarlier() : nullptr;
    if (earlier == nullptr) return;
    ImportMesh edition = asEditionOf(*std::exchange(mesh_, std::nullopt), *earlier);
    context_.preview.clear();
    Q_EMIT ended();
    Q_EMIT editionRead(std::move(edition));
}

void MeshPlacing::cancel() {
    job_.drop();
    if (!mesh_) return;
    mesh_.reset();
    context_.preview.clear();
    Q_EMIT ended();
}

}  // namespace noonmark
