#include "app/gui/tools/editing/tree_editing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <utility>

#include "app/gui/base/widgets/cursor_label.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "core/engines/api/tree_shade.h"
#include "render/scene/crown_bodies.h"
#include "scenarios/edits/tree_edits.h"

namespace noonmark {

TreeEditing::TreeEditing(EditContext& context, TreePanel& panel, QObject* parent)
    : QObject(parent),
      context_(context),
      panel_(panel),
      claim_(context.panel.view(), [this](int key) { return key == Qt::Key_Delete && !ids_.empty(); }) {
    context_.panel.navigator().addTarget(*this);
    connect(&context_.panel.navigator(), &ViewNavigator::doubleClicked, this, [this] { finishRow(); });
    connect(&live_, &LiveTrees::changed, this, &TreeEditing::showLive);
    connect(&live_, &LiveTrees::failed, this, [this](const Error& error) {
        if (!isCancelled(error)) Q_EMIT hinted(describeError(error));
    });
    connect(&panel_, &TreePanel::plantingChosen, this, &TreeEditing::plant);
    connect(&panel_, &TreePanel::replaceRequested, this, &TreeEditing::replace);
    connect(&panel_, &TreePanel::fellRequested, this, &TreeEditing::fell);
    connect(&panel_, &TreePanel::growRequested, this, &TreeEditing::grow);
}

TreeEditing::~TreeEditing() { context_.panel.navigator().removeTarget(*this); }

const Trees* TreeEditing::trees() const {
    return context_.city ? context_.city->city().trees.get() : nullptr;
}

void TreeEditing::cityChanged() {
    std::set<std::string> there;
    for (const Tree& tree : chosenTrees()) there.insert(tree.sourceId);
    ids_ = std::move(there);
    if (std::exchange(grabbed_, std::nullopt)) endDrag();
    endPlanting();
    movedM_ = {0, 0};
    show();
}

void TreeEditing::plant(TreePanel::Planting planting) {
    planting_ = context_.city ? planting : TreePanel::Planting::none;
    corners_.clear();
    cursor_.reset();
    endPlanting();
    if (isPlanting()) {
        ids_.clear();
        context_.panel.view().requestActivate();  // the view receives the keys that end it
        Q_EMIT chosen();
    }
    show();
}

std::optional<std::size_t> TreeEditing::treeAt(QPointF pixel) const {
    const CityView& view = context_.panel.view();
    if (!trees() || !view.showsTrees()) return std::nullopt;
    const ViewRay ray = makeRayThrough(view.pose(), view.lens(), {pixel.x(), pixel.y()});
    const auto hit = pickTree(trees()->trees, ray);
    const auto behind = context_.panel.navigator().pickAt(pixel);
    if (!hit || (behind && glm::distance(behind->position, ray.origin) < hit->distanceM)) return std::nullopt;
    return hit->tree;
}

std::optional<glm::dvec2> TreeEditing::groundAt(QPointF pixel) const {
    const auto ground = context_.panel.navigator().groundAt(pixel);
    return ground ? std::optional(glm::dvec2(*ground)) : std::nullopt;
}

bool TreeEditing::click(QPointF pixel) {
    if (isPlanting()) {
        if (const auto ground = groundAt(pixel)) addCorner(*ground);
        return true;
    }
    const bool adds = context_.panel.navigator().clickModifiers().testFlag(Qt::ControlModifier);
    const auto tree = treeAt(pixel);
    if (!adds) ids_.clear();
    if (tree)
        if (const std::string& id = trees()->trees[*tree].sourceId; !ids_.insert(id).second) ids_.erase(id);
    show();
    if (tree) Q_EMIT chosen();
    return tree.has_value();
}

void TreeEditing::addCorner(glm::dvec2 ground) {
    if (planting_ == TreePanel::Planting::single) return plantAt({ground});
    corners_.push_back(ground);
    show();
}

// The second click of a double click is no corner of its own.
void TreeEditing::finishRow() {
    if (planting_ != TreePanel::Planting::row || corners_.empty()) return;
    const auto places = placeTreesAlong(std::exchange(corners_, {}), panel_.spacingM());
    if (!places) return Q_EMIT failed(places.error());
    plantAt(*places);
}

void TreeEditing::plantAt(const std::vector<glm::dvec2>& places) {
    const auto tree = panel_.facts().and_then(designTree);
    if (!tree) return Q_EMIT failed(tree.error());
    Q_EMIT editsMade(makePlantings(context_.city->city(), *tree, places),
                     tr("plant %1 tree(s)", "", int(places.size())).arg(formatCount(places.size())));
}

void TreeEditing::hover(QPointF pixel) {
    if (!isPlanting()) return;
    cursor_ = groundAt(pixel);
    show();
    followPlanting();
}

// Where the map of a study is shown. Another species or height in the panel is another tree.
void TreeEditing::followPlanting() {
    const std::vector<Tree> planned = plannedTrees();
    if (planned.empty() || planned.size() > LiveTreeShade::maxMoved) return endPlanting();
    Tree tree = planned.front();
    tree.place = {};
    if (tree != plantedAs_) {
        endPlanting();
        if (!isStudyShown()) return;
        plantedAs_ = tree;
        live_.begin(context_.study, {.moved = {}, .planted = tree}, context_.preview.places());
    }
    HandledPlaces places;
    for (const Tree& one : planned) places.planted.push_back(one.place);
    live_.follow(std::move(places));
}

void TreeEditing::endPlanting() {
    if (std::exchange(plantedAs_, std::nullopt)) stopLive();
}

bool TreeEditing::key(int key) {
    const bool enter = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (enter && !corners_.empty()) return finishRow(), true;
    if (key != Qt::Key_Delete || ids_.empty()) return false;
    fell();
    return true;
}

std::optional<Tree> TreeEditing::findTree(const std::string& id) const {
    if (!trees()) return std::nullopt;
    const auto found = std::ranges::find(trees()->trees, id, &Tree::sourceId);
    return found == trees()->trees.end() ? std::nullopt : std::optional(*found);
}

void TreeEditing::choose(const std::string& id) {
    if (!findTree(id)) return;
    ids_ = {id};
    plant(TreePanel::Planting::none);
}

void TreeEditing::chooseNone() {
    ids_.clear();
    show();
}

bool TreeEditing::cancel() {
    if (!isPlanting() && ids_.empty()) return false;
    if (!isPlanting()) ids_.clear();
    plant(TreePanel::Planting::none);
    return true;
}

bool TreeEditing::grab(QPointF pixel) {
    if (isPlanting() || ids_.empty()) return false;
    const auto tree = treeAt(pixel);
    if (!tree || !ids_.contains(trees()->trees[*tree].sourceId)) return false;
    grabbed_ = groundAt(pixel);
    if (grabbed_) beginDrag();
    return grabbed_.has_value();
}

bool TreeEditing::isStudyShown() const {
    return context_.study && context_.panel.results().showsAnswer() &&
           context_.study->settings.trees != TreeColumns::without;
}

// A map of minutes follows where that of a study is shown, the shade of a moment where rays draw the view.
void TreeEditing::beginDrag() {
    if (isStudyShown())
        live_.begin(context_.study, {.moved = ids_, .planted = {}}, context_.preview.places());
    if (!context_.city->crowns) return;
    Trees others = *trees();
    std::erase_if(others.trees, [this](const Tree& tree) { return ids_.contains(tree.sourceId); });
    finding_.start<std::shared_ptr<const CrownRays>>(
        tr("Crowns of the other trees"),
        [others = std::make_shared<const Trees>(std::move(others))](Progress&, const std::stop_token& stop) {
            return makeCrownRays(others, stop);
        },
        [this](Result<std::shared_ptr<const CrownRays>> rays) {
            others_ = rays.value_or(nullptr);
            showDraggedShade();
        });
}

void TreeEditing::showDraggedShade() {
    if (!others_ || !grabbed_) return;
    Trees dragged{.trees = chosenTrees(), .leafDays = trees()->leafDays};
    for (Tree& tree : dragged.trees) {
        tree.place += movedM_;
        tree.groundM = float(noonmark::groundAt(context_.city->city(), tree.place));
    }
    const auto rays = makeCrownRays(std::make_shared<const Trees>(std::move(dragged)), {});
    if (!rays) return;
    CrownRays all = *others_;
    all.scenes.insert(all.scenes.end(), (*rays)->scenes.begin(), (*rays)->scenes.end());
    context_.panel.view().showTrees(others_->trees, std::make_shared<const CrownRays>(std::move(all)));
}

void TreeEditing::showLive() {
    if (!(grabbed_ || plantedAs_) || !live_.field()) return;
    const std::shared_ptr<const Study> study = live_.study();
    const QString columns = live_.isSeasonal() ? tr("With trees and their seasons, while they move")
                                               : tr("With trees as evergreens, while they move");
    context_.panel.results().setLive(
        GroundAnswer{.map = live_.field(),
                     .receivers = std::shared_ptr<const Receivers>(study, &study->receivers),
                     .note = columns,
                     .grossOnly = true});
    panel_.showFigures(live_.figures(), context_.panel.legend().choice().show,
                       study->field.sunlitMinutesPerDay);
}

void TreeEditing::stopLive() {
    live_.end();
    context_.panel.results().setLive(std::nullopt);
    panel_.showFigures({}, ShownAs::shadow, 0);
}

// The city with the trees where they were dropped follows; where it does not, they are where they were.
void TreeEditing::endDrag() {
    stopLive();
    finding_.drop();
    if (std::exchange(others_, nullptr))
        context_.panel.view().showTrees(context_.city->city().trees, context_.city->crowns);
}

void TreeEditing::dragTo(QPointF pixel) {
    const auto ground = groundAt(pixel);
    if (!grabbed_ || !ground) return;
    movedM_ = *ground - *grabbed_;
    show();
    live_.follow({.byM = movedM_, .planted = {}});
    showDraggedShade();
}

void TreeEditing::drop() {
    endDrag();
    grabbed_.reset();
    const glm::dvec2 by = std::exchange(movedM_, {0, 0});
    if (by == glm::dvec2(0)) return;
    std::vector<Edit> edits;
    for (const std::string& id : ids_) edits.emplace_back(MoveTree{id, by});
    Q_EMIT editsMade(std::move(edits),
                     tr("move %1 tree(s)", "", int(ids_.size())).arg(formatCount(ids_.size())));
}

void TreeEditing::fell() {
    std::vector<Edit> edits;
    for (const std::string& id : ids_) edits.emplace_back(FellTree{id});
    Q_EMIT editsMade(std::move(edits),
                     tr("fell %1 tree(s)", "", int(ids_.size())).arg(formatCount(ids_.size())));
}

void TreeEditing::replace() {
    const auto tree = panel_.facts().and_then(designTree);
    if (!tree) return Q_EMIT failed(tree.error());
    std::vector<Edit> edits;
    for (const std::string& id : ids_) edits.emplace_back(ReplaceTree{id, *tree});
    Q_EMIT editsMade(std::move(edits),
                     tr("replace %1 tree(s)", "", int(ids_.size())).arg(formatCount(ids_.size())));
}

void TreeEditing::grow() {
    std::vector<Edit> edits;
    const std::vector<Tree> some = ids_.empty() ? trees()->trees : chosenTrees();
    for (const Tree& tree : some)
        if (auto growth = makeGrowth(tree, panel_.years())) edits.push_back(*std::move(growth));
    if (edits.empty())
        return Q_EMIT failed({"None of these trees grows",
                              {},
                              "Trees of 35 m or more and cells of a canopy raster stay as they are"});
    Q_EMIT editsMade(std::move(edits), tr("let trees grow by %1 years").arg(panel_.years()));
}

std::vector<Tree> TreeEditing::chosenTrees() const {
    std::vector<Tree> chosen;
    if (trees() && !ids_.empty())
        std::ranges::copy_if(trees()->trees, std::back_inserter(chosen),
                             [this](const Tree& tree) { return ids_.contains(tree.sourceId); });
    return chosen;
}

// Those of a row so far, or the one under the cursor.
std::vector<Tree> TreeEditing::plannedTrees() const {
    std::vector<glm::dvec2> line = corners_;
    if (cursor_) line.push_back(*cursor_);
    const auto tree = panel_.facts().and_then(designTree);
    if (!tree || line.empty()) return {};
    const auto row = placeTreesAlong(line, panel_.spacingM());
    std::vector<Tree> planned;
    for (const glm::dvec2 place :
         row&& planting_ == TreePanel::Planting::row ? *row : std::vector{line.back()}) {
        planned.push_back(*tree);
        planned.back().place = place;
    }
    return planned;
}

void TreeEditing::show() {
    const std::vector<Tree> chosen = chosenTrees();
    panel_.showChosen(chosen, trees() ? trees()->trees.size() : 0);
    panel_.showPlanting(planting_);
    mark(isPlanting() ? plannedTrees() : chosen);
}

// A little larger than the trees themselves, so that they cover them.
void TreeEditing::mark(std::vector<Tree> trees) {
    constexpr float largerTimes = 1.04F;
    CrownBodies& marked = context_.panel.view().markedTrees();
    if (trees.empty()) return marked.show(nullptr);
    for (Tree& tree : trees) {
        tree.evergreen = true;
        tree.place += movedM_;
        tree.groundM = float(noonmark::groundAt(context_.city->city(), tree.place));
        tree.crownDiameterM *= largerTimes;
        tree.heightM *= largerTimes;
    }
    marked.show(std::make_shared<const Trees>(Trees{.trees = std::move(trees)}));
}

}  // namespace noonmark
