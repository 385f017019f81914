"""Files of weights: safetensors with Macula's metadata (engine/network/README.md)."""

import json
import os
import struct

import numpy as np


def _number(value):
    """A decimal number that reads back as the same float32."""
    return repr(float(np.float32(value)))


def check_writable(path):
    """Makes the folder of a file; OSError where the file could not be written."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(f"{path}.part", "wb"):
        pass
    os.remove(f"{path}.part")


def write_network(path, model, features, outputs, mean, scale, layers, output_activation, command,
                  data_hash, half=True):
    """Writes a network whole or not at all.

    layers: (weight [outputs, inputs], bias [outputs]) of each dense layer, in order.
    half: weights as 16-bit floats.
    """
    kind = np.float16 if half else np.float32
    tensors = {}
    for i, (weight, bias) in enumerate(layers):
        tensors[f"layer{i}.weight"] = np.asarray(weight, dtype=kind)
        tensors[f"layer{i}.bias"] = np.asarray(bias, dtype=kind)
    write_tensors(path, tensors, {
        "format": "macula-network",
        "version": "1",
        "model": model,
        "features": ",".join(features),
        "outputs": ",".join(outputs),
        "mean": " ".join(map(_number, mean)),
        "scale": " ".join(map(_number, scale)),
        "activation": "relu",
        "output_activation": output_activation,
        "command": command,
        "data": data_hash,
    })


def write_tensors(path, tensors, metadata):
    """Writes arrays of 16- or 32-bit floats as safetensors, whole or not at all."""
    header = {"__metadata__": metadata}
    blocks = []
    at = 0
    for name, values in tensors.items():
        block = np.ascontiguousarray(values)
        header[name] = {
            "dtype": {"float16": "F16", "float32": "F32"}[block.dtype.name],
            "shape": list(block.shape),
            "data_offsets": [at, at + block.nbytes],
        }
        at += block.nbytes
        blocks.append(block.astype(block.dtype.newbyteorder("<")).tobytes())
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 8)
    temporary = f"{path}.part"
    with open(temporary, "wb") as file:
        file.write(struct.pack("<Q", len(text)))
        file.write(text)
        for block in blocks:
            file.write(block)
    os.replace(temporary, path)


def rounded(values, half=True):
    """What a file of weights holds of some values."""
    return np.asarray(values, dtype=np.float16 if half else np.float32).astype(np.float32)
