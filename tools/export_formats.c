#include "export_parts.h"

const export_format export_formats[] = {
    {"csv", ".csv", EXPORT_CELLS, false, export_csv},
    {"geojson", ".geojson", EXPORT_DEGREES, false, export_geojson},
    {"gpx", ".gpx", EXPORT_DEGREES, false, export_gpx},
    {"qgc-plan", ".plan", EXPORT_DEGREES, true, export_qgc_plan},
    {"qgc-wpl", ".waypoints", EXPORT_DEGREES, true, export_qgc_wpl},
    {"nav2", ".yaml", EXPORT_METRES, true, export_nav2},
    {"moos", NULL, EXPORT_METRES, true, export_moos},
    {.name = NULL},
};
