"""Files of weights: safetensors with Macula's metadata (engine/network/README.md)."""

import json
import os
import struct

import numpy as np


def _number(value):
    """A decimal number that reads back as the same float32."""
    return repr(float(np.float32(value)))


def write_network(path, model, features, outputs, mean, scale, layers, output_activation, command,
                  data_hash, half=True):
    """Writes a network whole or not at all.

    layers: (weight [outputs, inputs], bias [outputs]) of each dense layer, in order.
    half: weights as 16-bit floats; what they round to is what is returned.
    """
    kind, name = (np.float16, "F16") if half else (np.float32, "F32")
    header = {
        "__metadata__": {
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
        }
    }
    blocks = []
    at = 0
    for i, (weight, bias) in enumerate(layers):
        for part, values in (("weight", weight), ("bias", bias)):
            block = np.ascontiguousarray(values, dtype=kind)
            header[f"layer{i}.{part}"] = {
                "dtype": name,
                "shape": list(block.shape),
                "data_offsets": [at, at + block.nbytes],
            }
            at += block.nbytes
            blocks.append(block.astype("<" + block.dtype.str[1:]).tobytes())
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
