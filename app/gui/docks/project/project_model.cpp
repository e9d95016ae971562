#include "app/gui/docks/project/project_model.h"

#include <QFont>
#include <QObject>
#include <algorithm>

#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/project/project_session.h"
#include "app/gui/session/study/region_text.h"
#include "app/report/sheets/study_text.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

using Kind = ProjectNode::Kind;

QString qtText(const std::string& text) { return QString::fromStdString(text); }

ProjectNode& added(ProjectNode& parent, ProjectNode node) {
    node.parent = &parent;
    return *parent.children.emplace_back(std::make_unique<ProjectNode>(std::move(node)));
}

void addFact(ProjectNode& parent, const QString& text, const QString& tip = {}) {
    added(parent, {.kind = Kind::fact, .text = text, .tip = tip});
}

ProjectNode& addGroup(ProjectNode& root, ProjectPart part, const QString& text, std::size_t count,
                      const QString& tip) {
    const QString title = count > 0 ? QStringLiteral("%1 (%2)").arg(text).arg(count) : text;
    return added(root, {.kind = Kind::group, .part = part, .text = title, .tip = tip});
}

ProjectNode& addPart(ProjectNode& group, const std::string& name, const QString& shown,
                     const QString& about = {}, const QString& tip = {}) {
    const QString text = about.isEmpty() ? shown : QStringLiteral("%1   %2").arg(shown, about);
    return added(group, {.kind = Kind::part, .part = group.part, .name = name, .text = text, .tip = tip});
}

void addCity(ProjectNode& root, const Project& project) {
    const City& city = *project.city;
    ProjectNode& group =
        added(root, {.kind = Kind::group,
                     .text = QObject::tr("City"),
                     .tip = QObject::tr("The existing city, from which every scenario starts")});
    const std::size_t buildings = city.buildings.size();
    addFact(group, QObject::tr("%1 building(s)", "", pluralNumber(buildings)).arg(formatCount(buildings)));
    addFact(group, city.terrain ? QObject::tr("Terrain of %1 × %2 points")
                                      .arg(city.terrain->grid.columns)
                                      .arg(city.terrain->grid.rows)
                                : QObject::tr("Flat ground"));
    if (!project.attribution.empty()) addFact(group, describeData(project.attribution));
    for (const InputFile& input : project.inputs)
        addFact(group, qtText(input.path.filename().string()),
                QStringLiteral("%1\n%2").arg(qtText(input.path.string()), qtText(input.sha256)));
}

void addScenario(ProjectNode& group, const Scenario& scenario, bool shown, bool baseline) {
    QStringList notes;
    if (!scenario.base.empty()) notes << QObject::tr("from %1").arg(scenarioName(scenario.base));
    if (baseline) notes << QObject::tr("baseline");
    ProjectNode& node =
        addPart(group, scenario.name, scenarioName(scenario.name),
                notes.isEmpty() ? QString() : QStringLiteral("(%1)").arg(notes.join(QStringLiteral(", "))),
                QObject::tr("Press Enter or double-click to show it"));
    node.emphasized = shown;
    for (std::size_t i = 0; i < scenario.edits.size(); ++i)
        added(node, {.kind = Kind::edit,
                     .part = ProjectPart::scenario,
                     .name = scenario.name,
                     .position = i,
                     .text = qtText(noonmark::formatText(scenario.edits[i])),
                     .tip = QObject::tr("Step %1 of %2; press Delete to remove it")
                                .arg(i + 1)
                                .arg(qtText(scenario.name))});
}

void addScenarios(ProjectNode& root, const Project& project, const std::string& shown,
                  const std::string& baseline) {
    ProjectNode& group =
        addGroup(root, ProjectPart::scenario, QObject::tr("Scenarios"), project.scenarios.size(),
                 QObject::tr("Lists of changes to the city; the displayed one is bold"));
    addScenario(group, {existingCity, {}, {}}, shown == existingCity, baseline == existingCity);
    group.children.back()->tip = QObject::tr("The existing city. Press Enter or double-click to show it");
    for (const Scenario& scenario : project.scenarios)
        addScenario(group, scenario, shown == scenario.name, baseline == scenario.name);
}

void addLots(ProjectNode& root, const Project& project) {
    ProjectNode& group = addGroup(root, ProjectPart::lot, QObject::tr("Lots"), project.lots.size(),
                                  QObject::tr("Ground to build on"));
    for (const NamedLot& lot : project.lots)
        addPart(group, lot.name, qtText(lot.name),
                lot.roads.empty() ? describeArea(area(lot.outline))
                                  : QObject::tr("%1, roads: %2")
                                        .arg(describeArea(area(lot.outline)),
                                             QString::fromStdString(noonmark::formatText(lot.roads))),
                QObject::tr("Press Enter or double-click to zoom to it"));
}

void addRegions(ProjectNode& root, const Project& project) {
    ProjectNode& group = addGroup(root, ProjectPart::region, QObject::tr("Regions"), project.regions.size(),
                                  QObject::tr("Where shadow is measured"));
    for (const Region& region : project.regions)
        addPart(group, region.name, placeName(region.name), describeArea(area(region)),
                QObject::tr("Press Enter or double-click to use it as the study region"));
}

void addPlaces(ProjectNode& root, const Project& project) {
    ProjectNode& group =
        addGroup(root, ProjectPart::place, QObject::tr("Places"), project.places.size(),
                 QObject::tr("Areas whose sunlight matters: parks, playgrounds, school grounds..."));
    for (const Place& place : project.places)
        addPart(
            group, place.name, placeName(place.name),
            QObject::tr("%1, %2").arg(describeKind(place.kind), describeArea(noonmark::area(place))),
            QObject::tr("%1\nPress Enter or double-click to zoom to it").arg(qtText(place.source)).trimmed());
}

void addPeriods(ProjectNode& root, const Project& project) {
    ProjectNode& group = addGroup(root, ProjectPart::period, QObject::tr("Periods"), project.periods.size(),
                                  QObject::tr("Days and hours to study"));
    for (const NamedPeriod& period : project.periods)
        addPart(group, period.name, qtText(period.name), {},
                QObject::tr("%1\nPress Enter or double-click to use it as the study period")
                    .arg(describeWhen(period.period)));
}

QString describeView(const SavedView& view) {
    QString projection = view.parallel ? QObject::tr("parallel") : QObject::tr("perspective");
    if (view.section) projection = QObject::tr("%1, section box").arg(projection);
    if (!view.moment) return projection;
    return QObject::tr("%1, %2 %3")
        .arg(projection, qtText(noonmark::formatText(view.moment->date)),
             qtText(noonmark::formatText(view.moment->at)));
}

void addViews(ProjectNode& root, const Project& project) {
    ProjectNode& group =
        addGroup(root, ProjectPart::view, QObject::tr("Views"), project.views.size(),
                 QObject::tr("Camera, projection, section box and moment, saved with Ctrl+Shift+V"));
    for (const SavedView& view : project.views)
        addPart(group, view.name, qtText(view.name), {},
                QObject::tr("%1\nPress Enter or double-click to go to it").arg(describeView(view)));
}

void addWeights(ProjectNode& root, const Project& project) {
    ProjectNode& group = addGroup(
        root, ProjectPart::weights, QObject::tr("Weight tables"), project.weights.size(),
        QObject::tr("How much shade is wanted (up to 1) or shadow unwanted (down to -1), by time of year"));
    for (const TimeWeights& table : project.weights) {
        ProjectNode& node =
            addPart(group, table.name, weightName(table.name), {},
                    QObject::tr("Press Enter or double-click to edit it and compute scores with it"));
        for (const WeightedInterval& interval : table.intervals)
            addFact(node, QStringLiteral("%1   %2").arg(weightName(interval.name),
                                                        formatShort(interval.weight, 3)));
    }
}

void addResults(ProjectNode& root, const Project& project) {
    ProjectNode& group =
        addGroup(root, ProjectPart::result, QObject::tr("Saved results"), project.results.size(),
                 QObject::tr("Maps and figures saved in the project"));
    for (const auto& result : project.results) {
        const QString of = result->baseline.empty()
                               ? scenarioName(result->scenario)
                               : QObject::tr("%1 compared with %2")
                                     .arg(scenarioName(result->scenario), scenarioName(result->baseline));
        addPart(group, result->name, shownName(result), {},
                QObject::tr("%1 of %2\nPress Enter or double-click to show it again")
                    .arg(qtText(result->kind), of));
    }
}

/// The tree of a project. The displayed scenario is emphasized; the baseline is marked.
std::unique_ptr<ProjectNode> makeNodes(const Project& project, const std::string& shown,
                                       const std::string& baseline) {
    auto root = std::make_unique<ProjectNode>();
    addCity(*root, project);
    addScenarios(*root, project, shown, baseline);
    addLots(*root, project);
    addRegions(*root, project);
    addPlaces(*root, project);
    addPeriods(*root, project);
    addViews(*root, project);
    addWeights(*root, project);
    addResults(*root, project);
    return root;
}

// Whether two nodes represent the same thing, even if the text differs.
bool same(const ProjectNode& a, const ProjectNode& b) {
    if (a.kind != b.kind || a.part != b.part || a.name != b.name) return false;
    if (a.kind == ProjectNode::Kind::part) return true;
    return a.kind == ProjectNode::Kind::group ? a.part.has_value() || a.text == b.text : a.text == b.text;
}

int rowOf(const ProjectNode& node) {
    const auto& rows = node.parent->children;
    return int(std::ranges::find(rows, &node, [](const auto& one) { return one.get(); }) - rows.begin());
}

bool canRename(const ProjectNode& node) {
    return node.kind == ProjectNode::Kind::part && node.name != existingCity;
}

}  // namespace

ProjectModel::ProjectModel(ProjectSession& session, QObject* parent)
    : QAbstractItemModel(parent),
      session_(session),
      root_(makeNodes(session.project(), session.scenario(), session.baseline())) {
    connect(&session_, &ProjectSession::changed, this, &ProjectModel::follow);
}

ProjectModel::~ProjectModel() = default;

void ProjectModel::follow() {
    const auto wanted = makeNodes(session_.project(), session_.scenario(), session_.baseline());
    mergeInto(*root_, *wanted);
}

// Keeps nodes that are equal at the beginning and at the end, and replaces those in between.
void ProjectModel::mergeInto(ProjectNode& old, ProjectNode& wanted) {
    auto& was = old.children;
    auto& is = wanted.children;
    std::size_t first = 0;
    while (first < was.size() && first < is.size() && same(*was[first], *is[first])) ++first;
    std::size_t oldEnd = was.size(), wantedEnd = is.size();
    while (oldEnd > first && wantedEnd > first && same(*was[oldEnd - 1], *is[wantedEnd - 1]))
        --oldEnd, --wantedEnd;
    for (std::size_t i = 0; i < first; ++i) mergeInto(*was[i], *is[i]);
    for (std::size_t i = 0; oldEnd + i < was.size(); ++i) mergeInto(*was[oldEnd + i], *is[wantedEnd + i]);
    replaceRows(old, wanted, first, oldEnd, wantedEnd);
    if (&old == root_.get()) return;
    const bool differs = old.text != wanted.text || old.tip != wanted.tip ||
                         old.emphasized != wanted.emphasized || old.position != wanted.position;
    old.text = wanted.text;
    old.tip = wanted.tip;
    old.emphasized = wanted.emphasized;
    old.position = wanted.position;
    if (differs) Q_EMIT dataChanged(indexOf(old), indexOf(old));
}

void ProjectModel::replaceRows(ProjectNode& old, ProjectNode& wanted, std::size_t first, std::size_t oldEnd,
                               std::size_t wantedEnd) {
    const QModelIndex parent = &old == root_.get() ? QModelIndex() : indexOf(old);
    const auto at = [](auto& list, std::size_t i) { return list.begin() + std::ptrdiff_t(i); };
    if (oldEnd > first) {
        beginRemoveRows(parent, int(first), int(oldEnd) - 1);
        old.children.erase(at(old.children, first), at(old.children, oldEnd));
        endRemoveRows();
    }
    if (wantedEnd == first) return;
    beginInsertRows(parent, int(first), int(wantedEnd) - 1);
    for (std::size_t i = first; i < wantedEnd; ++i) {
        wanted.children[i]->parent = &old;
        old.children.insert(at(old.children, i), std::move(wanted.children[i]));
    }
    endInsertRows();
}

const ProjectNode* ProjectModel::nodeAt(const QModelIndex& index) const {
    return index.isValid() ? static_cast<const ProjectNode*>(index.constInternalPointer()) : nullptr;
}

QModelIndex ProjectModel::indexOf(const ProjectNode& node) const {
    return createIndex(rowOf(node), 0, &node);
}

QModelIndex ProjectModel::groupOf(ProjectPart part) const {
    for (const auto& group : root_->children)
        if (group->part == part) return indexOf(*group);
    return {};
}

QModelIndex ProjectModel::indexOf(ProjectPart part, const std::string& name) const {
    const ProjectNode* group = nodeAt(groupOf(part));
    for (const auto& node : group->children)
        if (node->name == name) return indexOf(*node);
    return {};
}

QModelIndex ProjectModel::index(int row, int column, const QModelIndex& parent) const {
    const ProjectNode* node = parent.isValid() ? nodeAt(parent) : root_.get();
    if (column != 0 || row < 0 || std::size_t(row) >= node->children.size()) return {};
    return createIndex(row, 0, node->children[std::size_t(row)].get());
}

QModelIndex ProjectModel::parent(const QModelIndex& child) const {
    const ProjectNode* node = nodeAt(child);
    return node == nullptr || node->parent == root_.get() ? QModelIndex() : indexOf(*node->parent);
}

int ProjectModel::rowCount(const QModelIndex& parent) const {
    if (parent.column() > 0) return 0;
    return int((parent.isValid() ? nodeAt(parent) : root_.get())->children.size());
}

int ProjectModel::columnCount(const QModelIndex&) const { return 1; }

QVariant ProjectModel::data(const QModelIndex& index, int role) const {
    const ProjectNode* node = nodeAt(index);
    if (node == nullptr) return {};
    if (role == Qt::DisplayRole) return node->text;
    if (role == Qt::EditRole) return QString::fromStdString(node->name);
    if (role == Qt::ToolTipRole && !node->tip.isEmpty()) return node->tip;
    if (role == Qt::FontRole && node->emphasized) {
        QFont bold;
        bold.setBold(true);
        return bold;
    }
    return {};
}

bool ProjectModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const ProjectNode* node = nodeAt(index);
    const std::string name = value.toString().trimmed().toStdString();
    if (node == nullptr || role != Qt::EditRole || !canRename(*node) || name.empty()) return false;
    if (name == node->name) return true;
    const ProjectPart part = *node->part;
    if (!session_.rename(part, std::string(node->name), name)) return false;
    Q_EMIT renamed(part, name);
    return true;
}

Qt::ItemFlags ProjectModel::flags(const QModelIndex& index) const {
    const ProjectNode* node = nodeAt(index);
    if (node == nullptr) return Qt::NoItemFlags;
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return canRename(*node) ? flags | Qt::ItemIsEditable : flags;
}

}  // namespace noonmark
