#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <string>

#include "app/gui/session/project/project_changes.h"

namespace noonmark {

class ProjectSession;
struct MonthsAndHours;

/// One weight table of the project: one row per interval, with columns for name, days, hours and weight, all
/// edited in place as text ("06-01" or "June", "15:00", "-0.5"). Each edit is one undo step. An invalid date,
/// hour or weight, and intervals that would give a time two weights, are refused and change nothing. Follows
/// the session, including renaming of the table.
class WeightsModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { intervalName, firstDay, lastDay, fromHour, toHour, intervalWeight };

    explicit WeightsModel(ProjectSession& session, QObject* parent = nullptr);  ///< `session` must outlive it

    /// The table to show; if it does not exist (any more) there are no rows.
    void setTable(const std::string& name);
    [[nodiscard]] const TimeWeights& table() const { return table_; }

    /// Adds an interval, as addInterval() places it. Returns its row, or -1 if refused.
    int add(int afterRow);
    /// Gives this time a weight, or none, as paintWeights() does. False if refused.
    bool paint(const MonthsAndHours& time, std::optional<double> weight);
    bool removeRows(int row, int count, const QModelIndex& parent = {}) override;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    /// For Qt::UserRole, returns the weight itself in every column.
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

Q_SIGNALS:
    void chosen();  ///< another table
    void edited();  ///< by this model: clears an earlier refusal
    void refused(noonmark::Error error);

private:
    void follow();
    void replaceTable(TimeWeights table);
    bool change(const Result<TimeWeights>& next);

    ProjectSession& session_;
    TimeWeights table_;
};

}  // namespace noonmark
