#pragma once

#include <QAbstractTableModel>
#include <map>
#include <memory>
#include <optional>

#include "core/study/study.h"
#include "scenarios/massing/tower_design.h"

namespace noonmark {

class ProjectSession;

/// The scenarios side by side: the number of changes, the figures of each one's latest study, and the floor
/// area of its towers by use. Figures are comparable only for the same study, so those with other settings
/// are left out.
class ScenarioTable final : public QAbstractTableModel {
    Q_OBJECT
public:
    /// `session` must outlive it
    explicit ScenarioTable(ProjectSession& session, QObject* parent = nullptr);

    /// Role of the number, or name, by which a column is sorted.
    static constexpr int sortRole = Qt::UserRole;

    using Studies = std::map<std::string, std::shared_ptr<const Study>>;
    /// Studies by scenario; those with settings other than `settings` are not shown.
    void setStudies(Studies studies, const StudySettings& settings);

    [[nodiscard]] std::string scenarioAt(int row) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void follow();
    struct Row {
        std::string scenario;
        std::optional<std::vector<Edit>> edits;  ///< with those of its bases; none: a base is missing
        ScenarioUses uses;
    };
    [[nodiscard]] Row makeRow(const std::string& scenario) const;
    [[nodiscard]] QVariant valueAt(const Row& row, int column) const;
    [[nodiscard]] QString textAt(const Row& row, int column) const;
    [[nodiscard]] QString tipAt(const Row& row, int column) const;

    ProjectSession& session_;
    std::vector<Row> rows_;
    Studies studies_;
};

}  // namespace noonmark
