#pragma once

#include <QAbstractTableModel>
#include <string>

#include "app/window/project/project_changes.h"

namespace noonmark {

class ProjectSession;

/// One weight table of the project: a row an interval, with columns for its name, its days, its hours and its
/// weight, all edited in place as text ("06-01" or "June", "15:00", "-0.5"). Each edit is one step of undo.
/// What is no date, hour or weight, and what would give a time two weights, is refused where it stands and
/// changes nothing. Follows the session, a new name of the table too.
class WeightsModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { intervalName, firstDay, lastDay, fromHour, toHour, intervalWeight };

    explicit WeightsModel(ProjectSession& session, QObject* parent = nullptr);  ///< `session` outlives it

    /// The table that is shown; one that is not there (any more) has no rows.
    void setTable(const std::string& name);
    [[nodiscard]] const TimeWeights& table() const { return table_; }

    /// An interval more, as addInterval() has it. Returns its row; -1 where it was refused.
    int add(int afterRow);
    bool removeRows(int row, int count, const QModelIndex& parent = {}) override;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    /// The weight itself as Qt::UserRole, of every column.
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

Q_SIGNALS:
    void edited();  ///< by this model: what was refused before is settled
    void refused(noonmark::Error error);

private:
    void follow();
    void become(TimeWeights table);
    bool change(const Result<TimeWeights>& next);

    ProjectSession& session_;
    TimeWeights table_;
};

}  // namespace noonmark
