#pragma once

#include <QModelIndexList>
#include <QString>
#include <vector>

#include "app/gui/session/answers/result_rows.h"

class QAbstractItemModel;

namespace noonmark {

/// A table as text for spreadsheets: columns with tabs, rows with line ends, a heading first. Rows inside
/// rows follow their parents. `only`: rows by their index in any column; none: all.
QString makeTableText(const QAbstractItemModel& model, const QModelIndexList& only = {});

/// Name and value of each figure.
QString makeTableText(const std::vector<ResultRow>& rows);

}  // namespace noonmark
