#include "app/gui/docks/project/project_model.h"

#include <QFont>
#include <algorithm>

#include "app/gui/docks/project/project_nodes.h"
#include "app/gui/session/project/project_session.h"

namespace noonmark {

namespace {

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
    return session_.rename(*node->part, std::string(node->name), name);
}

Qt::ItemFlags ProjectModel::flags(const QModelIndex& index) const {
    const ProjectNode* node = nodeAt(index);
    if (node == nullptr) return Qt::NoItemFlags;
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return canRename(*node) ? flags | Qt::ItemIsEditable : flags;
}

}  // namespace noonmark
