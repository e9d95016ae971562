#pragma once

#include <QAbstractItemModel>
#include <memory>
#include <optional>

#include "app/gui/session/project/project_changes.h"

namespace noonmark {

class ProjectSession;

/// A node of the project's tree.
struct ProjectNode {
    enum class Kind { group, fact, part, edit };
    Kind kind = Kind::fact;
    std::optional<ProjectPart>
        /// The kind of a group's parts, of a part, or of the part that an edit belongs to.
        part;
    std::string name;          ///< of a part; of an edit: the scenario's name; else empty
    std::size_t position = 0;  ///< of an edit: its index in the scenario
    QString text;
    QString tip;
    bool emphasized = false;        ///< the displayed scenario
    ProjectNode* parent = nullptr;  ///< null: the root
    std::vector<std::unique_ptr<ProjectNode>> children;
};

/// The project as a tree: city, scenarios with their edits, lots, regions, periods, views, weight tables,
/// results. Follows the session; unchanged nodes are not rebuilt, so views keep what is expanded and
/// selected. Parts can be renamed in place.
class ProjectModel final : public QAbstractItemModel {
    Q_OBJECT
public:
    explicit ProjectModel(ProjectSession& session, QObject* parent = nullptr);  ///< `session` must outlive it
    ~ProjectModel() override;

    [[nodiscard]] const ProjectNode* nodeAt(const QModelIndex& index) const;  ///< null: the root
    [[nodiscard]] QModelIndex indexOf(ProjectPart part, const std::string& name) const;
    [[nodiscard]] QModelIndex groupOf(ProjectPart part) const;

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& child) const override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

Q_SIGNALS:
    void renamed(noonmark::ProjectPart part, std::string name);  ///< in the tree, to this name

private:
    void follow();
    void mergeInto(ProjectNode& old, ProjectNode& wanted);
    void replaceRows(ProjectNode& old, ProjectNode& wanted, std::size_t first, std::size_t oldEnd,
                     std::size_t wantedEnd);
    [[nodiscard]] QModelIndex indexOf(const ProjectNode& node) const;

    ProjectSession& session_;
    std::unique_ptr<ProjectNode> root_;
};

}  // namespace noonmark
