#pragma once

#include <QAbstractTableModel>
#include <map>
#include <memory>

#include "core/study/study.h"

namespace noonmark {

class ProjectSession;

/// The scenarios side by side: how many changes, and the figures of the latest study of each. Numbers can be
/// compared only where the same question was asked, so those of other settings than the present are left out.
class ScenarioTable final : public QAbstractTableModel {
    Q_OBJECT
public:
    explicit ScenarioTable(ProjectSession& session, QObject* parent = nullptr);  ///< `session` outlives it

    using Studies = std::map<std::string, std::shared_ptr<const Study>>;
    /// By scenario; those of another question than `settings` are not shown.
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
