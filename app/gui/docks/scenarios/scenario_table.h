#pragma once

#include <QAbstractTableModel>
#include <map>
#include <memory>
#include <optional>

#include "app/report/scenarios/scenario_study.h"

namespace noonmark {

class ProjectSession;

/// The scenarios side by side: changes, height and floor area, the figures of each one's latest study, its
/// impact, score and verdicts. Figures are comparable only for the same study, so those with other settings
/// are left out. Areas and heights are in the units in use.
class ScenarioTable final : public QAbstractTableModel {
    Q_OBJECT
public:
    /// `session` must outlive it
    explicit ScenarioTable(ProjectSession& session, QObject* parent = nullptr);

    enum Column {
        scenario,
        changes,
        height,
        floorArea,
        shadowArea,
        gross,
        continuous,
        impact,
        weightedShade,
        score,
        verdicts,
        uses,
    };
    static constexpr int columns = uses + 1;
    /// Role of the number, or name, by which a column is sorted.
    static constexpr int sortRole = Qt::UserRole;
    /// Role of a heading: a name of the column for settings, the same in all languages.
    static constexpr int keyRole = Qt::UserRole;

    using Studies = std::map<std::string, std::shared_ptr<const Study>>;
    /// Studies by scenario; those with settings other than `settings` are not shown.
    void setStudies(Studies studies, const StudySettings& settings);

    /// What impact, score and verdicts belong to: names of the baseline, the weight table and the rule.
    struct Basis {
        std::string baseline, weights, rule;
    };
    /// By scenario. Only what is up to date; figures of earlier studies count where setStudies() gave none.
    void setAnswers(std::map<std::string, ScenarioAnswers> answers, const Basis& basis);

    [[nodiscard]] std::string scenarioAt(int row) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void follow();
    struct Row {
        std::string scenario;
        std::shared_ptr<const City> city;
        std::optional<std::vector<Edit>> edits;  ///< with those of its bases; none: a base is missing
        ScenarioUses uses;
        std::optional<double> heightM;
    };
    [[nodiscard]] Row makeRow(const std::string& scenario) const;
    [[nodiscard]] QVariant valueAt(const Row& row, int column) const;
    [[nodiscard]] QVariant answerAt(const Row& row, int column) const;
    [[nodiscard]] QString textAt(const Row& row, int column) const;
    [[nodiscard]] QString tipAt(const Row& row, int column) const;
    [[nodiscard]] QString tipOfAnswer(const Row& row, int column) const;
    [[nodiscard]] ScenarioAnswers answersOf(const Row& row) const;
    [[nodiscard]] std::optional<ShadowStatistics> measuredOf(const Row& row) const;
    void showAgain();

    ProjectSession& session_;
    std::vector<Row> rows_;
    Studies studies_;
    std::map<std::string, ScenarioAnswers> answers_;
    Basis basis_;
};

}  // namespace noonmark
