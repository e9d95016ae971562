#pragma once

#include <QTreeWidget>

#include "core/base/warnings.h"

namespace noonmark {

/// What was mended, left out or assumed, by kind, each with the ids of its features, which can be gone to.
class WarningsDock final : public QTreeWidget {
    Q_OBJECT
public:
    explicit WarningsDock(QWidget* parent = nullptr);
    void show(const Warnings& warnings);

Q_SIGNALS:
    void placeChosen(QString where);  ///< a warning's place: double click or Enter
};

}  // namespace noonmark
