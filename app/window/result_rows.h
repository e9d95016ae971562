#pragma once

#include <QString>
#include <vector>

#include "core/study/study.h"

namespace noonmark {

/// A line of the results: name, value with unit, and what it means.
struct ResultRow {
    QString name;
    QString value;
    QString meaning;
};

std::vector<ResultRow> resultRowsOf(const Study& study);

}  // namespace noonmark
