#pragma once

#include <QTreeWidget>

#include "core/base/warnings.h"

namespace noonmark {

/// The warnings of reading: data that was repaired, left out or assumed, grouped by kind, with the ids of the
/// features.
class WarningsDock final : public QTreeWidget {
    Q_OBJECT
public:
    explicit WarningsDock(QWidget* parent = nullptr);
    void show(const Warnings& warnings);

Q_SIGNALS:
    void placeChosen(QString where);  ///< double click or Enter on a warning's place
};

}  // namespace noonmark
