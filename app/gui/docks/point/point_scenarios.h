#pragma once

#include <QWidget>

class QComboBox;
class QTableWidget;

namespace noonmark {

class PointInspector;

/// Which two scenarios the point is compared in, and its figures in all of them. Without scenarios there is
/// nothing to choose: it is hidden.
class PointScenarios final : public QWidget {
    Q_OBJECT
public:
    explicit PointScenarios(PointInspector& inspector, QWidget* parent = nullptr);  ///< it outlives this

private:
    void makeFields();
    void fillLists();
    void choose();
    void showTable();

    PointInspector& inspector_;
    QComboBox* from_;
    QComboBox* to_;
    QTableWidget* table_;
};

}  // namespace noonmark
