"""Stands in for the build back end while pip downloads a source distribution.

pip asks the back end for metadata even when it only downloads, and would fetch and run the real one, unpinned. The
metadata lies in the distribution, ready made.
"""

import email
import os
import shutil


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    with open("PKG-INFO", encoding="utf-8") as file:
        about = email.message_from_file(file)
    folder = f"{about['Name'].replace('-', '_')}-{about['Version']}.dist-info"
    os.makedirs(os.path.join(metadata_directory, folder))
    shutil.copy("PKG-INFO", os.path.join(metadata_directory, folder, "METADATA"))
    return folder
