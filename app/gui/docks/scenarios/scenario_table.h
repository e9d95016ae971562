#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <QVariant>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "app/report/scenarios/scenario_months.h"
#include "app/report/scenarios/scenario_study.h"
#include "core/describe/figure.h"
#include "scenarios/edits/edit.h"
#include "scenarios/massing/tower_design.h"

namespace noonmark {

/// "Homes 12,300 m², Offices 4,000 m²": the gross floor area of each use that has any. Empty without towers.
QString describeUses(const ScenarioUses& uses);

/// A line for each use, "Homes: 20 storeys, 12,300 m²", and one about towers that are not counted.
QString describeUseLines(const ScenarioUses& uses);

/// A scenario of the table, without what is measured.
struct ScenarioRow {
    std::string scenario;
    std::shared_ptr<const City> city;
    std::optional<std::vector<Edit>> edits;  ///< with those of its bases; none: a base is missing
    ScenarioUses uses;
    std::optional<double> heightM;
};

/// What fills a column.
enum class ScenarioWork { none, measuring, measuringPlaces, comparing, scoring, reviewing };

/// A column of the table of scenarios. One that shows a figure has its label, definition and unit from there.
struct ScenarioColumn {
    std::string_view key;  ///< of settings and CSV, the same in all languages
    const Figure* figure = nullptr;
    const char* title = nullptr;  ///< %1: the unit; null: the figure's label
    const char* tip = nullptr;    ///< null: the figure's definition
    ScenarioWork work = ScenarioWork::none;
    Better better = Better::none;  ///< where it shows no figure
    bool isCompared = false;       ///< also as a difference to the baseline
    bool isNumber = true;
    /// What it is sorted by; invalid: the scenario has no such value.
    std::function<QVariant(const ScenarioRow&, const ScenarioAnswers&)> value{};
};

/// In their order from the left; the first is the name.
const std::vector<ScenarioColumn>& scenarioColumns();

/// The position of the column with this key, which must exist.
int scenarioColumn(std::string_view key);

/// Which of its values is the best one.
Better betterOf(const ScenarioColumn& column);

/// The title with the unit in use.
QString titleOf(const ScenarioColumn& column);
QString tipOf(const ScenarioColumn& column);

/// A number as its column shows it, in the units in use. `isDifference`: always with its sign.
QString numberText(double value, const ScenarioColumn& column, bool isDifference = false);

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
    /// Whether what is missing of these columns is being computed.
    void setWorking(ScenarioWork work, bool isWorking);
    /// Forgets which values were there before, and failures: of another project.
    void forgetPast();

    [[nodiscard]] std::string scenarioAt(int row) const;
    /// Its columns in the order in which they are read: the name, what was measured of any scenario, what the
    /// scenarios are, what was not measured.
    [[nodiscard]] std::vector<int> readingOrder() const;
    /// Their months, the baseline first.
    [[nodiscard]] std::vector<ScenarioMonths> months() const;
    /// Which of the scenarios adds least shadow and which most, and by what; likewise of scores. Of one
    /// scenario what it adds. Empty: none has been compared.
    [[nodiscard]] QString verdict() const;
    /// All scenarios as CSV, whatever is hidden or shown as a difference: numbers in metres and square
    /// metres, empty where there is none, then their differences to the baseline ("height_difference"), what
    /// they belong to, and last what each scenario lacks, in words.
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
    [[nodiscard]] QVariant differenceAt(const Row& row, int column) const;  ///< to the baseline
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
    std::string region_, period_;  ///< of the study's settings
    bool differences_ = false, shadeWanted_ = false;
    using Filled = std::pair<std::string, ScenarioWork>;
    std::set<ScenarioWork> working_;
    std::set<Filled> past_;  ///< had a value before
    std::map<Filled, QString> failures_;
};

}  // namespace noonmark
