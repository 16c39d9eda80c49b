# Sets QUARTER_CHARTS to a folder for PYTHONPATH that holds the chart library of docs/paper.md, pinned in
# requirements-charts.txt: wheels of pure Python, installed there and nowhere else.
include(${CMAKE_CURRENT_LIST_DIR}/pip.cmake)

set(QUARTER_CHARTS ${QUARTER_CACHE}/charts)
quarter_pip_install(${QUARTER_CHARTS} ${PROJECT_SOURCE_DIR}/cmake/requirements-charts.txt)
