#include "app/gui/docks/export/table_text.h"

#include <QAbstractItemModel>
#include <QStringList>
#include <algorithm>

#include "core/base/csv_text.h"

namespace noonmark {

namespace {

// A tab or a line end inside a cell would begin another one.
QString plainCell(const QString& text) {
    return QString::fromStdString(escapeFormula(text.simplified().toStdString()));
}

QString lineOf(const QAbstractItemModel& model, int row, const QModelIndex& parent) {
    QStringList cells;
    for (int column = 0; column < model.columnCount(parent); ++column)
        cells << plainCell(model.index(row, column, parent).data().toString());
    return cells.join(QLatin1Char('\t'));
}

QString headingOf(const QAbstractItemModel& model) {
    QStringList cells;
    for (int column = 0; column < model.columnCount(); ++column)
        cells << plainCell(model.headerData(column, Qt::Horizontal).toString());
    return cells.join(QLatin1Char('\t'));
}

void addRows(const QAbstractItemModel& model, const QModelIndex& parent, const QModelIndexList& only,
             QStringList& lines) {
    for (int row = 0; row < model.rowCount(parent); ++row) {
        const QModelIndex first = model.index(row, 0, parent);
        const auto isThis = [&](const QModelIndex& index) { return index.siblingAtColumn(0) == first; };
        if (only.isEmpty() || std::ranges::any_of(only, isThis)) lines << lineOf(model, row, parent);
        addRows(model, first, only, lines);
    }
}

}  // namespace

QString makeTableText(const QAbstractItemModel& model, const QModelIndexList& only) {
    QStringList lines{headingOf(model)};
    addRows(model, {}, only, lines);
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

QString makeTableText(const std::vector<ResultRow>& rows) {
    QString text;
    for (const ResultRow& row : rows)
        text += plainCell(row.name) + QLatin1Char('\t') + plainCell(row.value) + QLatin1Char('\n');
    return text;
}

}  // namespace noonmark
