#pragma once

#include <QAbstractTableModel>
#include <map>
#include <memory>

#include "core/study/study.h"

namespace noonmark {

class ProjectSession;

/// The scenarios side by side: the number of changes, and the figures of each one's latest study. Figures are
/// comparable only for the same study, so those with other settings are left out.
class ScenarioTable final : public QAbstractTableModel {
    Q_OBJECT
public:
    /// `session` must outlive it
    explicit ScenarioTable(ProjectSession& session, QObject* parent = nullptr);

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
    [[nodiscard]] QString textAt(const std::string& scenario, int column) const;

    ProjectSession& session_;
    std::vector<std::string> scenarios_;
    Studies studies_;
};

}  // namespace noonmark
