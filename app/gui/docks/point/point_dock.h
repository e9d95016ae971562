#pragma once

#include <QWidget>

#include "core/io/files/check_output.h"

class QComboBox;
class QTableWidget;
class QLabel;
class QPushButton;
class QScrollArea;

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

class SkyPicture;

/// The sun and sky of the clicked point: a sentence, figures, the skyline with the sun's paths, and buttons
/// that save them.
class PointDock final : public QWidget {
    Q_OBJECT
public:
    /// `inspector` must outlive this object.
    explicit PointDock(PointInspector& inspector, QWidget* parent = nullptr);

    /// Writes the drawing (.svg, .png) or the minutes by month and hour (.csv).
    Result<void> save(const QString& file, const OutputRules& rules);

Q_SIGNALS:
    void saveRequested();
    void treeRequested(const QString& id);  ///< one of those that take sun from the point

private:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    QWidget* makeSide();
    void showAnswer();
    void showError(const Error& error);

    PointInspector& inspector_;
    QLabel* sentence_;
    QLabel* figures_;
    QLabel* taken_;  ///< the trees that take sun
    QPushButton* save_;
    SkyPicture* picture_;
    QScrollArea* scroll_;
};

}  // namespace noonmark
