#pragma once

#include <QAbstractTableModel>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "app/gui/docks/scenarios/scenario_columns.h"
#include "app/report/scenarios/scenario_months.h"

namespace noonmark {

class ProjectSession;

/// The scenarios side by side: changes, height and floor area, the figures of each one's latest study, its
/// impact, score and verdicts (scenarioColumns()). A cell without a figure says why. Figures are comparable
/// only for the same study, so those with other settings are left out. Areas and heights are in the units in
/// use.
class ScenarioTable final : public QAbstractTableModel {
    Q_OBJECT
public:
    /// `session` must outlive it
    explicit ScenarioTable(ProjectSession& session, QObject* parent = nullptr);

    /// Role of the number, or name, by which a column is sorted.
    static constexpr int sortRole = Qt::UserRole;
    /// Role of whether the value is the best one of its column: of at least two that differ.
    static constexpr int bestRole = Qt::UserRole + 1;
    /// Role of a heading: a name of the column for settings, the same in all languages.
    static constexpr int keyRole = Qt::UserRole;

    using Studies = std::map<std::string, std::shared_ptr<const Study>>;
    /// Studies by scenario; those with settings other than `settings` are not shown.
    void setStudies(Studies studies, const StudySettings& settings);

    /// What impact, score and verdicts belong to: names of the baseline, the weight table and the rule.
    struct Basis {
        std::string baseline, weights, rule;
        std::string ruleBaseline{};  ///< the rule compares the others with it
        bool hasWeights = true;      ///< the weight table has intervals
    };
    /// By scenario. Only what is up to date; figures of earlier studies count where setStudies() gave none.
    void setAnswers(std::map<std::string, ScenarioAnswers> answers, const Basis& basis);

    /// Numbers as differences to the baseline of the impact, whose own stay.
    void setDifferences(bool differences);
    /// Whether more shadow is better in all columns of shadow.
    void setShadeWanted(bool wanted);
    /// Why the last attempt to fill these columns of a scenario failed, until it has a value.
    void noteFailure(const std::string& scenario, ScenarioWork work, const QString& error);
    /// Forgets which values were there before, and failures: of another project.
    void forgetPast();

    [[nodiscard]] std::string scenarioAt(int row) const;
    /// Their months, the baseline first.
    [[nodiscard]] std::vector<ScenarioMonths> months() const;
    /// Which of the scenarios adds least shadow and which most, and by what; likewise of scores. Of one
    /// scenario what it adds. Empty: none has been compared.
    [[nodiscard]] QString verdict() const;
    /// All scenarios as CSV, whatever is hidden: numbers in metres and square metres, empty where there is
    /// none, and last what each scenario lacks, in words.
    [[nodiscard]] std::string csv() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void follow();
    using Row = ScenarioRow;
    [[nodiscard]] Row makeRow(const std::string& scenario) const;
    [[nodiscard]] QVariant valueAt(const Row& row, int column) const;
    [[nodiscard]] QVariant shownValueAt(const Row& row, int column) const;
    [[nodiscard]] bool showsDifferenceAt(const Row& row, int column) const;
    [[nodiscard]] bool isBest(const Row& row, int column) const;
    [[nodiscard]] QString textAt(const Row& row, int column) const;
    [[nodiscard]] QString tipAt(const Row& row, int column) const;
    [[nodiscard]] QString tipOfValue(const Row& row, const ScenarioColumn& column) const;
    [[nodiscard]] QString tipOfLack(const Row& row, const ScenarioColumn& column) const;
    /// Why there is no value; empty: it has none by its nature.
    [[nodiscard]] QString lackAt(const Row& row, const ScenarioColumn& column) const;
    [[nodiscard]] QString listLacks(const Row& row) const;
    [[nodiscard]] bool isBaselineOf(const Row& row, ScenarioWork work) const;
    [[nodiscard]] QString impactVerdict() const;
    [[nodiscard]] QString scoreVerdict() const;
    [[nodiscard]] ScenarioAnswers answersOf(const Row& row) const;
    void notePast();
    void showAgain();

    ProjectSession& session_;
    std::vector<Row> rows_;
    Studies studies_;
    std::map<std::string, ScenarioAnswers> answers_;
    Basis basis_;
    bool differences_ = false, shadeWanted_ = false;
    using Filled = std::pair<std::string, ScenarioWork>;
    std::set<Filled> past_;  ///< had a value before
    std::map<Filled, QString> failures_;
};

}  // namespace noonmark
