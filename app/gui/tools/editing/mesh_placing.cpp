#include "app/gui/tools/editing/mesh_placing.h"

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "app/gui/base/widgets/height_words.h"
#include "app/gui/tools/editing/placing_panel.h"
#include "core/city/terrain/building_ground.h"
#include "core/io/meshes/stated_axes.h"
#include "scenarios/edits/read_shape.h"
#include "scenarios/free_name.h"

namespace noonmark {

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
    connect(&panel_, &PlacingPanel::applied, this, &MeshPlacing::build);
    connect(&panel_, &PlacingPanel::cancelled, this, &MeshPlacing::cancel);
}

void MeshPlacing::begin(const QString& file, std::optional<glm::dvec2> place) {
    if (!context_.city) return;
    mesh_.reset();
    place_ = place;
    file_ = file;
    const auto stated = findStatedAxes(file.toStdString());
    panel_.setStated(stated.has_value(), stated && stated->metresPerUnit);
    read();
}

void MeshPlacing::read() {
    const std::string id = freeId(context_.city->city(), QFileInfo(file_).completeBaseName().toStdString());
    reading_.start<Read>(
        tr("Reading %1").arg(QFileInfo(file_).fileName()),
        [file = file_.toStdString(), id, settings = panel_.reading(), frame = context_.city->city().frame](
            Progress& progress, std::stop_token stop) {
            Warnings warnings;
            return readShape(file, id, settings, frame, warnings, progress, std::move(stop))
                .map([&](ImportMesh mesh) {
                    return Read{std::move(mesh), warnings};
                });
        },
        [this](Result<Read> read) { take(std::move(read)); });
}

void MeshPlacing::take(Result<Read> read) {
    if (!read) return Q_EMIT failed(read.error());
    const bool first = !mesh_.has_value();
    mesh_ = std::move(read->mesh);
    if (first) Q_EMIT began();
    if (first) panel_.begin(QString::fromStdString(mesh_->file));
    panel_.showWarnings(read->warnings);
    show();
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

void MeshPlacing::cancel() {
    reading_.drop();
    if (!mesh_) return;
    mesh_.reset();
    context_.preview.clear();
    Q_EMIT ended();
}

}  // namespace noonmark
