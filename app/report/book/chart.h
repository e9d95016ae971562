#pragma once

#include <QImage>
#include <QRectF>
#include <array>
#include <vector>

#include "app/report/book/page_text.h"

namespace noonmark {

/// Areas in shadow at one time of day, m2.
struct TimelinePoint {
    double minute = 0;  ///< since midnight of the chart's clock
    double baselineM2 = 0, scenarioM2 = 0, incrementalM2 = 0, gainedM2 = 0;
};

/// Area in shadow on a place over one day.
struct PageTimeline {
    Caption caption;
    std::vector<TimelinePoint> points;  ///< in time order; a gap of more than 1.5 steps breaks the areas
    double stepMinutes = 1;
    double fromMin = 0, toMin = 1440;  ///< of the axis
    double areaM2 = 0;                 ///< of the place: the top of the axis
    double textScale = 1;
};

/// A share from 0 to 1 for each day and time of day, as a picture: days from left to right, the latest time
/// of day at the top.
struct PageCarpet {
    Caption caption;
    QImage image;                      ///< a column for each day
    double fromMin = 0, toMin = 1440;  ///< of the rows
    struct Month {
        double at = 0;  ///< its first day, in columns
        QString name;
    };
    std::vector<Month> months;
    bool isIncremental = false;  ///< which legend
    double textScale = 1;
};

/// Colours of carpets. NaN: the sun is not measured.
QColor carpetColour(double share, bool isIncremental);

/// Bars in groups, one bar a series: values by month. Values may be negative.
struct PageBars {
    Caption caption;
    QString unit;                 ///< of the values
    std::vector<QColor> colours;  ///< by series
    struct Group {
        QString name;
        std::vector<double> values;  ///< as many as series
    };
    std::vector<Group> groups;  ///< at least one
    double textScale = 1;
};

void paintTimeline(const Canvas& canvas, const QRectF& area, const PageTimeline& chart);
void paintCarpet(const Canvas& canvas, const QRectF& area, const PageCarpet& chart);
void paintBars(const Canvas& canvas, const QRectF& area, const PageBars& chart);

}  // namespace noonmark
